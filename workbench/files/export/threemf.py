"""3MF: the closed body as a zip with XML, which states its unit (3MF Core Specification 1.3).

Times of the zip's entries are fixed, so the same lens gives the same file.
"""

from typing import BinaryIO
from zipfile import ZIP_DEFLATED, ZipFile, ZipInfo

from workbench.files.export.design import Design, Deviation
from workbench.files.export.tessellation import Tessellation

_UNITS = {"mm": "millimeter", "cm": "centimeter", "m": "meter", "inch": "inch"}
_XML = '<?xml version="1.0" encoding="UTF-8"?>\n'
_TYPES = f"""{_XML}<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">
<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>
<Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/>
</Types>
"""
_RELATIONS = f"""{_XML}<Relationships \
xmlns="http://schemas.openxmlformats.org/package/2006/relationships">
<Relationship Target="/3D/3dmodel.model" Id="rel0" \
Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>
</Relationships>
"""
_BEGIN = f"""{_XML}<model unit="{{unit}}" xml:lang="en-US" \
xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02">
<metadata name="Title">freeform lens</metadata>
<metadata name="Application">freeform-lens-workbench</metadata>
<resources>
<object id="1" type="model" name="freeform lens">
<mesh>
<vertices>
"""
_MIDDLE = "</vertices>\n<triangles>\n"
_END = """</triangles>
</mesh>
</object>
</resources>
<build>
<item objectid="1"/>
</build>
</model>
"""


def write_3mf(design: Design, file: BinaryIO) -> Deviation:
    """Write the closed body.

    Raises
    ------
    Refused
        If the chord error takes too many triangles.
    """
    face = Tessellation.of(design)
    body = face.body(design.in_mesh_unit)
    with ZipFile(file, "w") as package:
        package.writestr(_entry("[Content_Types].xml"), _TYPES)
        package.writestr(_entry("_rels/.rels"), _RELATIONS)
        with package.open(_entry("3D/3dmodel.model"), "w") as model:
            model.write(_BEGIN.format(unit=_UNITS[design.mesh_unit]).encode())
            model.writelines(
                f'<vertex x="{x!r}" y="{y!r}" z="{z!r}"/>\n'.encode()
                for x, y, z in body.vertices.tolist()
            )
            model.write(_MIDDLE.encode())
            model.writelines(
                f'<triangle v1="{a}" v2="{b}" v3="{c}"/>\n'.encode()
                for a, b, c in body.triangles.tolist()
            )
            model.write(_END.encode())
    return face.deviation(design)


def _entry(name: str) -> ZipInfo:
    entry = ZipInfo(name)
    entry.compress_type = ZIP_DEFLATED
    return entry
