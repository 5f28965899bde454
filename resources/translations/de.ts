<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
    <context>
        <name>workbench</name>
        <message>
            <location filename="../../ui/commands/actions.py" />
            <source>&amp;File</source>
            <translation>&amp;Datei</translation>
        </message>
        <message>
            <location filename="../../ui/commands/actions.py" />
            <source>Open &amp;recent</source>
            <translation>Zuletzt &amp;geöffnet</translation>
        </message>
        <message>
            <location filename="../../ui/commands/actions.py" />
            <source>&amp;Edit</source>
            <translation>&amp;Bearbeiten</translation>
        </message>
        <message>
            <location filename="../../ui/commands/actions.py" />
            <source>&amp;Design</source>
            <translation>&amp;Entwurf</translation>
        </message>
        <message>
            <location filename="../../ui/commands/actions.py" />
            <source>&amp;Run</source>
            <translation>&amp;Lauf</translation>
        </message>
        <message>
            <location filename="../../ui/commands/actions.py" />
            <source>&amp;View</source>
            <translation>&amp;Ansicht</translation>
        </message>
        <message>
            <location filename="../../ui/commands/actions.py" />
            <source>&amp;Rays</source>
            <translation>S&amp;trahlen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/actions.py" />
            <source>F&amp;aces</source>
            <translation>&amp;Flächen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/actions.py" />
            <source>&amp;Colours of light</source>
            <translation>Farben &amp;des Lichts</translation>
        </message>
        <message>
            <location filename="../../ui/commands/actions.py" />
            <source>&amp;Workspace</source>
            <translation>Arbeitsu&amp;mgebung</translation>
        </message>
        <message>
            <location filename="../../ui/commands/actions.py" />
            <source>&amp;Go to</source>
            <translation>&amp;Gehe zu</translation>
        </message>
        <message>
            <location filename="../../ui/commands/actions.py" />
            <source>Lay&amp;outs</source>
            <translation>Ano&amp;rdnungen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/actions.py" />
            <source>&amp;Help</source>
            <translation>&amp;Hilfe</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;New…</source>
            <translation>&amp;Neu …</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Begin a design on the start page</source>
            <translation>Einen Entwurf auf der Startseite beginnen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>New &amp;window</source>
            <translation>Neues &amp;Fenster</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Open another window with its own design and run</source>
            <translation>Weiteres Fenster mit eigenem Entwurf und eigenem Lauf öffnen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Open…</source>
            <translation>&amp;Öffnen …</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Open a design, or a scene file</source>
            <translation>Einen Entwurf oder eine Szenendatei öffnen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Save</source>
            <translation>&amp;Speichern</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Save scene, target and lens</source>
            <translation>Szene, Ziel und Linse speichern</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Save scene, target and mirror</source>
            <translation>Szene, Ziel und Spiegel speichern</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Save &amp;as…</source>
            <translation>Speichern &amp;unter …</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Save under another name</source>
            <translation>Unter anderem Namen speichern</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Export…</source>
            <translation>&amp;Exportieren …</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Write the lens or its rays for other programs</source>
            <translation>Linse oder ihre Strahlen für andere Programme schreiben</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Write the mirror or its rays for other programs</source>
            <translation>Spiegel oder seine Strahlen für andere Programme schreiben</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Cu&amp;t with a ball cutter…</source>
            <translation>Mit &amp;Kugelfräser fräsen …</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Simulate a finishing pass and write it as G-code</source>
            <translation>Schlichten simulieren und als G-Code schreiben</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>P&amp;lan milling and polishing…</source>
            <translation>Fräsen und Polieren p&amp;lanen…</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Find step-over and polishing for a wanted error as made, with the least time</source>
            <translation>Zeilenabstand und Politur für einen gewünschten Fehler nach der Fertigung finden, mit der kürzesten Zeit</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Compare a p&amp;hotograph…</source>
            <translation>F&amp;oto vergleichen …</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Compare a photograph of the projected light with the prediction, and find likely causes</source>
            <translation>Ein Foto des projizierten Lichts mit der Vorhersage vergleichen und wahrscheinliche Ursachen finden</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Read measured s&amp;urfaces…</source>
            <translation>Ge&amp;messene Flächen lesen …</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Compare measured parts with the design, and correct the design for the next part</source>
            <translation>Gemessene Teile mit dem Entwurf vergleichen und den Entwurf für das nächste Teil korrigieren</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Report…</source>
            <translation>Be&amp;richt …</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Write scene, pictures, check and figures as a report (HTML, PDF)</source>
            <translation>Szene, Bilder, Prüfung und Kennzahlen als Bericht schreiben (HTML, PDF)</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Close window</source>
            <translation>Fenster s&amp;chließen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Close this window; others stay open</source>
            <translation>Dieses Fenster schließen; andere bleiben offen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Quit</source>
            <translation>&amp;Beenden</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Close all windows of the workbench</source>
            <translation>Alle Fenster der Workbench schließen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Re&amp;vert</source>
            <translation>&amp;Zurücksetzen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Restore the saved file; Undo reverts</source>
            <translation>Gespeicherte Datei wiederherstellen; lässt sich rückgängig machen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Undo</source>
            <translation>&amp;Rückgängig</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Undo the last change</source>
            <translation>Letzte Änderung rückgängig machen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Redo</source>
            <translation>&amp;Wiederherstellen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Redo the change</source>
            <translation>Änderung wiederholen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Paste picture</source>
            <translation>Bild &amp;einfügen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Use the picture on the clipboard as the target</source>
            <translation>Bild der Zwischenablage als Ziel verwenden</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Copy &amp;plot</source>
            <translation>&amp;Diagramm kopieren</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Copy a picture of the plot that was clicked last</source>
            <translation>Bild des zuletzt angeklickten Diagramms kopieren</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Save p&amp;lot…</source>
            <translation>Diagramm &amp;speichern …</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Save the plot that was clicked last, as picture (PNG, SVG) or numbers (CSV)</source>
            <translation>Zuletzt angeklicktes Diagramm speichern, als Bild (PNG, SVG) oder Zahlen (CSV)</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Pre&amp;ferences…</source>
            <translation>E&amp;instellungen…</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Theme, text size, language, start, checks and cores</source>
            <translation>Farbschema, Schriftgröße, Sprache, Start, Prüfungen und Kerne</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Start</source>
            <translation>&amp;Start</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Design from scratch. Replaces this lens; Undo restores it.</source>
            <translation>Neu entwerfen. Ersetzt diese Linse; Rückgängig stellt sie wieder her.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Design from scratch. Replaces this mirror; Undo restores it.</source>
            <translation>Neu entwerfen. Ersetzt diesen Spiegel; Rückgängig stellt ihn wieder her.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Continue</source>
            <translation>&amp;Fortsetzen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Continue the design of this lens with more iterations</source>
            <translation>Entwurf dieser Linse mit weiteren Iterationen fortsetzen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Continue the design of this mirror with more iterations</source>
            <translation>Entwurf dieses Spiegels mit weiteren Iterationen fortsetzen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Pause</source>
            <translation>&amp;Pause</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Pause the design, or resume it</source>
            <translation>Entwurf anhalten oder fortsetzen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>S&amp;top</source>
            <translation>S&amp;topp</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>End the design and keep its best lens</source>
            <translation>Den Entwurf beenden und seine beste Linse behalten</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>End the design and keep its best mirror</source>
            <translation>Den Entwurf beenden und seinen besten Spiegel behalten</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Live update</source>
            <translation>Live-&amp;Aktualisierung</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Update the lens after every edit, except during a run</source>
            <translation>Linse nach jeder Änderung neu entwerfen, außer während eines Laufs</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Update the mirror after every edit, except during a run</source>
            <translation>Spiegel nach jeder Änderung neu entwerfen, außer während eines Laufs</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>S&amp;weep…</source>
            <translation>R&amp;eihe…</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Design a lens for each of several values of a field</source>
            <translation>Für jeden von mehreren Werten eines Feldes eine Linse entwerfen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Design a mirror for each of several values of a field</source>
            <translation>Für jeden von mehreren Werten eines Feldes einen Spiegel entwerfen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Save &amp;video of the run…</source>
            <translation>V&amp;ideo des Laufs speichern …</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Save the image after each iteration of this run as an animated picture (GIF, WebP)</source>
            <translation>Das Bild nach jeder Iteration dieses Laufs als bewegtes Bild speichern (GIF, WebP)</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Restore run</source>
            <translation>La&amp;uf wiederherstellen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Restore task and lens of the run selected in the dock Runs</source>
            <translation>Aufgabe und Linse des im Dock Läufe gewählten Laufs wiederherstellen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Restore task and mirror of the run selected in the dock Runs</source>
            <translation>Aufgabe und Spiegel des im Dock Läufe gewählten Laufs wiederherstellen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Compare runs</source>
            <translation>Läufe &amp;vergleichen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Compare irradiance, figures and fields of the two runs selected in the dock Runs</source>
            <translation>Bestrahlungsstärke, Kennzahlen und Felder der zwei im Dock Läufe gewählten Läufe vergleichen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Delete runs</source>
            <translation>Läufe &amp;löschen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Delete the runs selected in the dock Runs</source>
            <translation>Die im Dock Läufe gewählten Läufe löschen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Check lens</source>
            <translation>Linse p&amp;rüfen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Check mirror</source>
            <translation>Spiegel p&amp;rüfen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Check this lens with an independent ray trace; again to cancel</source>
            <translation>Diese Linse mit unabhängigem Raytracing prüfen; nochmals zum Abbrechen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Check this mirror with an independent ray trace; again to cancel</source>
            <translation>Diesen Spiegel mit unabhängigem Raytracing prüfen; nochmals zum Abbrechen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Fit 3D view</source>
            <translation>3D-Ansicht &amp;einpassen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Fit lens and screen into the view</source>
            <translation>Linse und Schirm einpassen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Fit mirror and screen into the view</source>
            <translation>Spiegel und Schirm einpassen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Look at &amp;lens</source>
            <translation>&amp;Linse ansehen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Look at &amp;mirror</source>
            <translation>Sp&amp;iegel ansehen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Fit the lens into the view</source>
            <translation>Linse einpassen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Fit the mirror into the view</source>
            <translation>Spiegel einpassen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Look at s&amp;creen</source>
            <translation>S&amp;chirm ansehen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Fit the screen into the view</source>
            <translation>Schirm einpassen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>From the &amp;side</source>
            <translation>Von der Se&amp;ite</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>View along x; light travels to the right</source>
            <translation>Ansicht entlang x; Licht läuft nach rechts</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>From a&amp;bove</source>
            <translation>Von &amp;oben</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>View along y; light travels to the right</source>
            <translation>Ansicht entlang y; Licht läuft nach rechts</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Along the a&amp;xis</source>
            <translation>Entlang der &amp;Achse</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>View along −z from behind the screen</source>
            <translation>Ansicht entlang −z von hinter dem Schirm</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Compress distances</source>
            <translation>Abstände sta&amp;uchen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Draw far elements nearer and a large screen smaller, to enlarge the lens</source>
            <translation>Ferne Elemente näher und einen großen Schirm kleiner zeichnen, damit die Linse größer erscheint</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Draw far elements nearer and a large screen smaller, to enlarge the mirror</source>
            <translation>Ferne Elemente näher und einen großen Schirm kleiner zeichnen, damit der Spiegel größer erscheint</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>No rays</source>
            <translation>Keine Strahlen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Rays in the 3D scene</source>
            <translation>Strahlen in der 3D-Szene</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>25 rays</source>
            <translation>25 Strahlen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>81 rays</source>
            <translation>81 Strahlen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>225 rays</source>
            <translation>225 Strahlen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>2025 rays</source>
            <translation>2025 Strahlen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>By &amp;target</source>
            <translation>Nach dem &amp;Ziel</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Colour map of images and 3D screen. By target: pictures as they are seen, unless the light is in lux; other light in Inferno</source>
            <translation>Farbskala der Bilder und des Schirms in 3D. Nach dem Ziel: Fotos und Zeichnungen, wie man sie sieht, außer bei Licht in Lux; anderes Licht in Inferno</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>As &amp;seen</source>
            <translation>&amp;Wie gesehen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Inferno</source>
            <translation>Inferno</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Viridis</source>
            <translation>Viridis</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Cividis</source>
            <translation>Cividis</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Colour by &amp;outcome</source>
            <translation>Nach &amp;Verbleib färben</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Rays that miss the screen are red</source>
            <translation>Strahlen, die den Schirm verfehlen, sind rot</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Colour by &amp;weight</source>
            <translation>Nach &amp;Gewicht färben</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>By the fraction of a ray's flux that arrives</source>
            <translation>Nach dem Anteil des Flusses, der ankommt</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>As their &amp;material</source>
            <translation>Wie ihr &amp;Material</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Draw faces of the lens as glass or metal</source>
            <translation>Flächen der Linse als Glas oder Metall zeichnen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Draw faces of the mirror as glass or metal</source>
            <translation>Flächen des Spiegels als Glas oder Metall zeichnen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>By &amp;height</source>
            <translation>Nach &amp;Höhe</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Colour faces of the lens by height along z: dark is low</source>
            <translation>Flächen der Linse nach Höhe entlang z färben: dunkel ist niedrig</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Colour faces of the mirror by height along z: dark is low</source>
            <translation>Flächen des Spiegels nach Höhe entlang z färben: dunkel ist niedrig</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>By &amp;curvature</source>
            <translation>Nach &amp;Krümmung</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Colour faces of the lens by curvature: red is concave towards +z, blue convex</source>
            <translation>Flächen der Linse nach Krümmung färben: rot ist konkav zu +z, blau konvex</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Colour faces of the mirror by curvature: red is concave towards +z, blue convex</source>
            <translation>Flächen des Spiegels nach Krümmung färben: rot ist konkav zu +z, blau konvex</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>By &amp;limits</source>
            <translation>Nach &amp;Grenzen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Colour faces of the lens by the limits of manufacture: red is exceeded, green within</source>
            <translation>Flächen der Linse nach den Grenzen der Fertigung färben: rot überschritten, grün eingehalten</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Colour faces of the mirror by the limits of manufacture: red is exceeded, green within</source>
            <translation>Flächen des Spiegels nach den Grenzen der Fertigung färben: rot überschritten, grün eingehalten</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Relief exaggerated</source>
            <translation>&amp;Relief überhöht</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Exaggerate the relief of faces in the 3D view; the lens is unchanged</source>
            <translation>Relief der Flächen in der 3D-Ansicht überhöhen; die Linse bleibt unverändert</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Exaggerate the relief of faces in the 3D view; the mirror is unchanged</source>
            <translation>Relief der Flächen in der 3D-Ansicht überhöhen; der Spiegel bleibt unverändert</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Perspective</source>
            <translation>&amp;Perspektive</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Perspective instead of parallel projection</source>
            <translation>Perspektive statt Parallelprojektion</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Copy picture of 3&amp;D</source>
            <translation>3D-&amp;Bild kopieren</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Copy a picture of the 3D scene to the clipboard</source>
            <translation>Bild der 3D-Szene in die Zwischenablage kopieren</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Save pict&amp;ure of 3D…</source>
            <translation>3D-Bild speic&amp;hern…</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Save the 3D scene as PNG, about 1800 pixels wide</source>
            <translation>Die 3D-Szene als PNG speichern, etwa 1800 Pixel breit</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Turn</source>
            <translation>&amp;Drehen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Rotate the 3D scene by mouse or arrow keys; click to select</source>
            <translation>3D-Szene mit Maus oder Pfeiltasten drehen; Klick wählt aus</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Sculpt</source>
            <translation>&amp;Modellieren</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Drag control points of the lens along z</source>
            <translation>Kontrollpunkte der Linse entlang z ziehen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Drag control points of the mirror along z</source>
            <translation>Kontrollpunkte des Spiegels entlang z ziehen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Lock points</source>
            <translation>Punkte &amp;sperren</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Paint control points that runs must not change</source>
            <translation>Kontrollpunkte übermalen, die Läufe nicht ändern dürfen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Move parts</source>
            <translation>&amp;Teile verschieben</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Drag source, elements, the thickness of a lens, or the screen</source>
            <translation>Quelle, Elemente, die Dicke einer Linse oder den Schirm ziehen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>M&amp;easure</source>
            <translation>M&amp;essen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Click two points on lens or screen for their distance</source>
            <translation>Zwei Punkte auf Linse oder Schirm anklicken: ihr Abstand</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Click two points on mirror or screen for their distance</source>
            <translation>Zwei Punkte auf Spiegel oder Schirm anklicken: ihr Abstand</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Mark &amp;regions</source>
            <translation>Ausschnitte mark&amp;ieren</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Drag a rectangle on an image, or click the corners of a polygon and double-click; drag edges to move them. Esc ends</source>
            <translation>Rechteck auf einem Bild ziehen oder Ecken eines Polygons anklicken und doppelklicken; Kanten lassen sich ziehen. Esc beendet</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Use aspect of the &amp;picture</source>
            <translation>Seiten&amp;verhältnis des Bildes verwenden</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Set size and pixels of the receiver to the aspect of the target's picture</source>
            <translation>Größe und Pixel des Empfängers auf das Seitenverhältnis des Zielbilds setzen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Freeform entrance face</source>
            <translation>&amp;Freiform-Eintrittsfläche</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Make the entrance face freeform, or flat again; the exit face is unchanged</source>
            <translation>Eintrittsfläche zur Freiformfläche machen oder wieder eben; die Austrittsfläche bleibt</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Other face</source>
            <translation>A&amp;ndere Fläche</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Select the other freeform face of the lens for sculpting and locking</source>
            <translation>Die andere Freiformfläche der Linse zum Modellieren und Sperren wählen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Select the other freeform face of the mirror for sculpting and locking</source>
            <translation>Die andere Freiformfläche des Spiegels zum Modellieren und Sperren wählen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Lar&amp;ger brush</source>
            <translation>&amp;Größerer Pinsel</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>More control points at once; also Ctrl+wheel</source>
            <translation>Mehr Kontrollpunkte auf einmal; auch Strg+Mausrad</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Smaller brus&amp;h</source>
            <translation>&amp;Kleinerer Pinsel</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Fewer control points at once; also Ctrl+wheel</source>
            <translation>Weniger Kontrollpunkte auf einmal; auch Strg+Mausrad</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Lock &amp;all points</source>
            <translation>&amp;Alle Punkte sperren</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Lock all control points of the lens in runs</source>
            <translation>Alle Kontrollpunkte der Linse in Läufen sperren</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Lock all control points of the mirror in runs</source>
            <translation>Alle Kontrollpunkte des Spiegels in Läufen sperren</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Unlock all points</source>
            <translation>Alle Punkte freige&amp;ben</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Unlock all control points of the lens</source>
            <translation>Alle Kontrollpunkte der Linse entsperren</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Unlock all control points of the mirror</source>
            <translation>Alle Kontrollpunkte des Spiegels entsperren</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Invert locks</source>
            <translation>Sperren &amp;umkehren</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Lock unlocked control points, and unlock locked ones</source>
            <translation>Entsperrte Kontrollpunkte sperren und gesperrte entsperren</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Task</source>
            <translation>Aufgabe</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Describe the light, the element and the image</source>
            <translation>Licht, Element und Bild beschreiben</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Design</source>
            <translation>Entwurf</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Run the design and watch the image</source>
            <translation>Den Entwurf rechnen und das Bild verfolgen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Check</source>
            <translation>Prüfung</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Verify the image: errors, cross-sections, through focus</source>
            <translation>Das Bild prüfen: Fehler, Schnitte, Fokusverlauf</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Make</source>
            <translation>Fertigung</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Make the part: cutters, tolerances, exports</source>
            <translation>Das Teil fertigen: Fräser, Toleranzen, Ausgabe</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Start page</source>
            <translation>Startseite</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Begin a design: a picture, a job, a recent file or an example</source>
            <translation>Einen Entwurf beginnen: Bild, Aufgabe, letzte Datei oder Beispiel</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Custom</source>
            <translation>Eigene</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Arrange docks by hand: drag their title bars</source>
            <translation>Docks von Hand anordnen: ihre Titelleisten ziehen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Save layout…</source>
            <translation>Anordnung &amp;speichern…</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Save the arrangement of the docks under a name</source>
            <translation>Anordnung der Docks unter einem Namen speichern</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Delete layout…</source>
            <translation>Anordnung &amp;löschen…</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Delete a saved arrangement of the docks</source>
            <translation>Eine gespeicherte Anordnung der Docks löschen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>R&amp;eset layout</source>
            <translation>Anord&amp;nung zurücksetzen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Arrange this workspace as it was at first</source>
            <translation>Diesen Arbeitsbereich wie zu Anfang anordnen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Next pane</source>
            <translation>&amp;Nächster Bereich</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Move the keyboard focus to the next pane</source>
            <translation>Tastaturfokus zum nächsten Bereich</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Previous pane</source>
            <translation>&amp;Voriger Bereich</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Move the keyboard focus to the previous pane</source>
            <translation>Tastaturfokus zum vorigen Bereich</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Show this pane and focus it</source>
            <translation>Diesen Bereich zeigen und fokussieren</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>3D scene</source>
            <translation>3D-Szene</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Irradiance</source>
            <translation>Bestrahlungsstärke</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Target</source>
            <translation>Ziel</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Difference</source>
            <translation>Differenz</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Photo</source>
            <translation>Foto</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Surface</source>
            <translation>Fläche</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Derivative</source>
            <translation>Ableitung</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Through focus</source>
            <translation>Fokusreihe</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Pinned</source>
            <translation>Angeheftet</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Manufacture</source>
            <translation>Fertigung</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Tolerances</source>
            <translation>Toleranzen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Result</source>
            <translation>Ergebnis</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Light account</source>
            <translation>Lichtbilanz</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Loss</source>
            <translation>Zielfunktion</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Cross-section</source>
            <translation>Schnitt</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Runs</source>
            <translation>Läufe</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>History</source>
            <translation>Verlauf</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Log</source>
            <translation>Protokoll</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Command &amp;palette</source>
            <translation>&amp;Befehlspalette</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Find any command by its name</source>
            <translation>Jeden Befehl nach seinem Namen finden</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Keyboard shortcuts</source>
            <translation>&amp;Tastenkürzel</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>All keyboard shortcuts, with search</source>
            <translation>Alle Tastenkürzel, mit Suche</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Tour</source>
            <translation>&amp;Rundgang</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Four marks that explain the window</source>
            <translation>Vier Hinweise, die das Fenster erklären</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Manual</source>
            <translation>&amp;Handbuch</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Manual of window, command line and methods</source>
            <translation>Handbuch zu Fenster, Kommandozeile und Verfahren</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;About</source>
            <translation>&amp;Über</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>About this program</source>
            <translation>Über dieses Programm</translation>
        </message>
        <message>
            <location filename="../../ui/background.py" />
            <source>The {work} failed: {error}</source>
            <translation>{work} fehlgeschlagen: {error}</translation>
        </message>
        <message>
            <location filename="../../ui/commands/actions.py" />
            <source>Limits in 3D</source>
            <translation>Grenzen in 3D</translation>
        </message>
        <message>
            <location filename="../../ui/commands/command_search.py" />
            <source>Command palette</source>
            <translation>Befehlspalette</translation>
        </message>
        <message>
            <location filename="../../ui/commands/command_search.py" />
            <source>Search commands</source>
            <translation>Befehle suchen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/command_search.py" />
            <source>No command found: {words}</source>
            <translation>Kein Befehl gefunden: {words}</translation>
        </message>
        <message>
            <location filename="../../ui/commands/toolbar.py" />
            <source>Toolbar</source>
            <translation>Werkzeugleiste</translation>
        </message>
        <message>
            <location filename="../../ui/commands/toolbar.py" />
            <source>More commands</source>
            <translation>Weitere Befehle</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/coach.py" />
            <source>Describe the task</source>
            <translation>Die Aufgabe beschreiben</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/coach.py" />
            <source>Picture, light, lens and screen. Drag a label to change its value; Ctrl+Z undoes.</source>
            <translation>Bild, Licht, Linse und Schirm. Ziehen an einer Beschriftung ändert ihren Wert; Strg+Z macht rückgängig.</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/coach.py" />
            <source>Start the design</source>
            <translation>Den Entwurf starten</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/coach.py" />
            <source>Start (F5) designs the lens. Stop (F7) ends the run with the best lens so far.</source>
            <translation>Start (F5) entwirft die Linse. Stopp (F7) beendet den Lauf mit der bisher besten Linse.</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/coach.py" />
            <source>Image of light</source>
            <translation>Bild des Lichts</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/coach.py" />
            <source>The light on the screen, updated during the run. The buttons above show target, difference and photo.</source>
            <translation>Das Licht auf dem Schirm, aktualisiert während des Laufs. Die Knöpfe darüber zeigen Ziel, Differenz und Foto.</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/coach.py" />
            <source>From task to part</source>
            <translation>Von der Aufgabe zum Teil</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/coach.py" />
            <source>Task, Design, Check, Make: verify the image, then export the lens for making.</source>
            <translation>Aufgabe, Entwurf, Prüfung, Fertigung: das Bild prüfen, dann die Linse zur Fertigung exportieren.</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/coach.py" />
            <source>&amp;End</source>
            <translation>&amp;Beenden</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/coach.py" />
            <source>{number} of {count}</source>
            <translation>{number} von {count}</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/coach.py" />
            <source>&amp;Next</source>
            <translation>&amp;Weiter</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/coach.py" />
            <source>&amp;Done</source>
            <translation>&amp;Fertig</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/comparison.py" />
            <source>Made and designed</source>
            <translation>Gefertigt und entworfen</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/comparison.py" />
            <source>Figures</source>
            <translation>Kennzahlen</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/comparison.py" />
            <source>Made beside designed</source>
            <translation>Gefertigt neben entworfen</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/corners.py" />
            <source>Drag the numbered corners onto those of the receiver: 1 is the top left corner of the target, and 2, 3 and 4 follow around it. With the keyboard: Space chooses a corner, arrows move it.</source>
            <translation>Ziehen Sie die nummerierten Ecken auf die des Empfängers: 1 ist die linke obere Ecke des Ziels, 2, 3 und 4 folgen im Umlauf. Mit der Tastatur: Leertaste wählt eine Ecke, Pfeile bewegen sie.</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/corners.py" />
            <source>Photograph with the corners of the receiver</source>
            <translation>Foto mit den Ecken des Empfängers</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/corners.py" />
            <source>Compare a photograph</source>
            <translation>Foto vergleichen</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/corners.py" />
            <source>&amp;Compare</source>
            <translation>&amp;Vergleichen</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/drawing.py" />
            <source>Side view of the job</source>
            <translation>Seitenansicht der Aufgabe</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/drawing.py" />
            <source>From the side</source>
            <translation>Von der Seite</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/drawing.py" />
            <source>From above</source>
            <translation>Von oben</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/drawing.py" />
            <source>, heights × {across:.1f}</source>
            <translation>, Höhen × {across:.1f}</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/drawing.py" />
            <source>, to scale</source>
            <translation>, maßstäblich</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/estimate.py" />
            <source>estimate</source>
            <translation>Schätzung</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/estimate.py" />
            <source>Best possible image</source>
            <translation>Bestmögliches Bild</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/estimate.py" />
            <source>The source size blurs the image of any lens</source>
            <translation>Die Größe der Quelle verwischt das Bild jeder Linse</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/estimate.py" />
            <source>Best possible</source>
            <translation>Bestmöglich</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/estimate.py" />
            <source>Computing the estimate…</source>
            <translation>Abschätzung wird berechnet …</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/estimate.py" />
            <source>Outdated figures.</source>
            <translation>Veraltete Kennzahlen.</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/estimate.py" />
            <source>Estimating… {part:.0f} %</source>
            <translation>Schätzung läuft … {part:.0f} %</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/help.py" />
            <source>Manual</source>
            <translation>Handbuch</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/help.py" />
            <source>Search</source>
            <translation>Suchen</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/help.py" />
            <source>Find pages with all words; Return shows the next match</source>
            <translation>Seiten mit allen Wörtern finden; Eingabe zeigt den nächsten Treffer</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/help.py" />
            <source>Search the manual</source>
            <translation>Im Handbuch suchen</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/help.py" />
            <source>Pages of the manual</source>
            <translation>Seiten des Handbuchs</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/help.py" />
            <source>No page found: {words}</source>
            <translation>Keine Seite gefunden: {words}</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/help.py" />
            <source>About {title}</source>
            <translation>Über {title}</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/help.py" />
            <source>&lt;h3&gt;{title} {version}&lt;/h3&gt;&lt;p&gt;Designs freeform lenses and mirrors that form a given irradiance.&lt;/p&gt;&lt;p&gt;MIT licence&lt;/p&gt;</source>
            <translation>&lt;h3&gt;{title} {version}&lt;/h3&gt;&lt;p&gt;Entwirft Freiformlinsen und -spiegel, die eine vorgegebene Bestrahlungsstärke erzeugen.&lt;/p&gt;&lt;p&gt;MIT-Lizenz&lt;/p&gt;</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/job_form.py" />
            <source>picture</source>
            <translation>Bild</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/job_form.py" />
            <source>file of light</source>
            <translation>Lichtdatei</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/job_page.py" />
            <source>B&amp;ack</source>
            <translation>&amp;Zurück</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/job_page.py" />
            <source>&amp;Begin</source>
            <translation>&amp;Beginnen</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/job_page.py" />
            <source>Cannot begin: {reason}</source>
            <translation>Beginn nicht möglich: {reason}</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/job_page.py" />
            <source>Picture</source>
            <translation>Motiv</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/measured.py" />
            <source>comparison</source>
            <translation>Vergleich</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/measured.py" />
            <source>Read measured surfaces</source>
            <translation>Gemessene Flächen lesen</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/measured.py" />
            <source>Measured surfaces ({endings});;All files (*)</source>
            <translation>Gemessene Flächen ({endings});;Alle Dateien (*)</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/measured.py" />
            <source>Measured surfaces</source>
            <translation>Gemessene Flächen</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/measured.py" />
            <source>Comparison with {file}</source>
            <translation>Vergleich mit {file}</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/measured.py" />
            <source>Write a design whose face makes good what repeats in the parts</source>
            <translation>Schreibt einen Entwurf, dessen Fläche ausgleicht, was sich an den Teilen wiederholt</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/measured.py" />
            <source>Save &amp;corrected part…</source>
            <translation>&amp;Korrigiertes Teil speichern …</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/measured.py" />
            <source>Save the corrected part</source>
            <translation>Korrigiertes Teil speichern</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/measured.py" />
            <source>Design (*.freeform)</source>
            <translation>Entwurf (*.freeform)</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/measured.py" />
            <source>Corrected part</source>
            <translation>Korrigiertes Teil</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/measured.py" />
            <source>{file} is written.</source>
            <translation>{file} ist geschrieben.</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/preferences.py" />
            <source>As the system</source>
            <translation>Wie das System</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/preferences.py" />
            <source>Theme</source>
            <translation>Farbschema</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/preferences.py" />
            <source>Colours of all windows</source>
            <translation>Farben aller Fenster</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/preferences.py" />
            <source>Light</source>
            <translation>Licht</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/preferences.py" />
            <source>Dark</source>
            <translation>Dunkel</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/preferences.py" />
            <source>Text size</source>
            <translation>Schriftgröße</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/preferences.py" />
            <source>Size of the text in all windows</source>
            <translation>Größe der Schrift in allen Fenstern</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/preferences.py" />
            <source>Language</source>
            <translation>Sprache</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/preferences.py" />
            <source>Language of the window; the command line is in English</source>
            <translation>Sprache des Fensters; die Kommandozeile ist englisch</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/preferences.py" />
            <source>At the start</source>
            <translation>Beim Start</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/preferences.py" />
            <source>What the window shows when the program starts without a file</source>
            <translation>Was das Fenster zeigt, wenn das Programm ohne Datei startet</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/preferences.py" />
            <source>Last design</source>
            <translation>Letzter Entwurf</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/preferences.py" />
            <source>Finished lenses</source>
            <translation>Fertige Linsen</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/preferences.py" />
            <source>Whether an independent ray trace checks what a run or live update has finished</source>
            <translation>Ob unabhängiges Raytracing prüft, was ein Lauf oder die Live-Aktualisierung fertiggestellt hat</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/preferences.py" />
            <source>Check the result</source>
            <translation>Ergebnis prüfen</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/preferences.py" />
            <source>No check</source>
            <translation>Keine Prüfung</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/preferences.py" />
            <source>Free cores</source>
            <translation>Freie Kerne</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/preferences.py" />
            <source>Cores that runs leave to the window and to other programs</source>
            <translation>Kerne, die Läufe dem Fenster und anderen Programmen lassen</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/preferences.py" />
            <source>Preferences</source>
            <translation>Einstellungen</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/preferences.py" />
            <source>Text size, language and cores change at the next start.</source>
            <translation>Schriftgröße, Sprache und Kerne ändern sich beim nächsten Start.</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/start_page.py" />
            <source>Jobs</source>
            <translation>Aufgaben</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/start_page.py" />
            <source>Examples</source>
            <translation>Beispiele</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/start_page.py" />
            <source>Recent files</source>
            <translation>Letzte Dateien</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/start_page.py" />
            <source>Begin with a job</source>
            <translation>Mit einer Aufgabe beginnen</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/start_page.py" />
            <source>Drop a picture here</source>
            <translation>Ein Bild hier ablegen</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/start_page.py" />
            <source>The lens will draw it with light. Ctrl+V pastes one.</source>
            <translation>Die Linse formt es aus Licht. Strg+V fügt ein Bild ein.</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/start_page.py" />
            <source>Choose &amp;picture…</source>
            <translation>Bild &amp;wählen …</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/start_page.py" />
            <source>&amp;Open design…</source>
            <translation>Entwurf &amp;öffnen …</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/sweep.py" />
            <source>{count} of {wanted} designs</source>
            <translation>{count} von {wanted} Entwürfen</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/sweep.py" />
            <source>Designs and checks a lens for each value, or each pair of values of two fields. The folder gets the sessions and a table (CSV, JSON). Finished designs are skipped.</source>
            <translation>Entwirft und prüft eine Linse für jeden Wert oder jedes Wertepaar zweier Felder. Der Ordner erhält die Sitzungen und eine Tabelle (CSV, JSON). Fertige Entwürfe werden übersprungen.</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/sweep.py" />
            <source>Verified error</source>
            <translation>Geprüfter Fehler</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/sweep.py" />
            <source>Iterations</source>
            <translation>Iterationen</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/sweep.py" />
            <source>Seconds</source>
            <translation>Sekunden</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/sweep.py" />
            <source>Sweep</source>
            <translation>Reihe</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/sweep.py" />
            <source>Folder</source>
            <translation>Ordner</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/sweep.py" />
            <source>Progress of the sweep</source>
            <translation>Fortschritt der Reihe</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/sweep.py" />
            <source>Designs of the sweep</source>
            <translation>Entwürfe der Reihe</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/sweep.py" />
            <source>Start</source>
            <translation>Start</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/sweep.py" />
            <source>Open the session of the selected row</source>
            <translation>Sitzung der gewählten Zeile öffnen</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/sweep.py" />
            <source>&amp;Open design</source>
            <translation>&amp;Entwurf öffnen</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/sweep.py" />
            <source>sweep</source>
            <translation>Reihe</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/sweep.py" />
            <source>Choose a folder for the designs.</source>
            <translation>Einen Ordner für die Entwürfe wählen.</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/sweep.py" />
            <source>Chosen at the start</source>
            <translation>Wird beim Start gewählt</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/sweep.py" />
            <source>Choose the folder</source>
            <translation>Den Ordner wählen</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/sweep.py" />
            <source>Stop</source>
            <translation>Stopp</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/sweep.py" />
            <source>Separate values by commas: 1, 2.5, 3; ranges as 0..4; pairs as 64x48; words as auto. Lengths in the unit of the scene.</source>
            <translation>Werte durch Kommas trennen: 1, 2.5, 3; Bereiche wie 0..4; Paare wie 64x48; Wörter wie auto. Längen in der Einheit der Szene.</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/sweep.py" />
            <source>Field</source>
            <translation>Feld</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/sweep.py" />
            <source>Second field</source>
            <translation>Zweites Feld</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/sweep.py" />
            <source>Values of {field}</source>
            <translation>Werte von {field}</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/sweep.py" />
            <source>none</source>
            <translation>ohne</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/sweep.py" />
            <source>now {value}</source>
            <translation>jetzt {value}</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/sweep.py" />
            <source>Verified error over the values</source>
            <translation>Geprüfter Fehler über den Werten</translation>
        </message>
        <message>
            <location filename="../../ui/document/document.py" />
            <source>reload of the image</source>
            <translation>Neuladen des Bildes</translation>
        </message>
        <message>
            <location filename="../../ui/document/document.py" />
            <source>new task: {name}</source>
            <translation>neue Aufgabe: {name}</translation>
        </message>
        <message>
            <location filename="../../ui/document/document.py" />
            <source>revert to the file</source>
            <translation>zur Datei zurückkehren</translation>
        </message>
        <message>
            <location filename="../../ui/document/frame.py" />
            <source>Image {number}, {place}</source>
            <translation>Bild {number}, {place}</translation>
        </message>
        <message>
            <location filename="../../ui/files/actions.py" />
            <source>Cancel</source>
            <translation>Abbrechen</translation>
        </message>
        <message>
            <location filename="../../ui/files/actions.py" />
            <source>The file has changed</source>
            <translation>Die Datei hat sich geändert</translation>
        </message>
        <message>
            <location filename="../../ui/files/actions.py" />
            <source>Another program has changed {name}.</source>
            <translation>Ein anderes Programm hat {name} geändert.</translation>
        </message>
        <message>
            <location filename="../../ui/files/actions.py" />
            <source>Overwrite discards its changes. Reload discards yours; Undo restores them.</source>
            <translation>Überschreiben verwirft dessen Änderungen. Neu laden verwirft Ihre; Rückgängig stellt sie wieder her.</translation>
        </message>
        <message>
            <location filename="../../ui/files/actions.py" />
            <source>&amp;Overwrite</source>
            <translation>Ü&amp;berschreiben</translation>
        </message>
        <message>
            <location filename="../../ui/files/actions.py" />
            <source>&amp;Reload</source>
            <translation>&amp;Neu laden</translation>
        </message>
        <message>
            <location filename="../../ui/files/actions.py" />
            <source>The file is missing</source>
            <translation>Die Datei fehlt</translation>
        </message>
        <message>
            <location filename="../../ui/files/actions.py" />
            <source>{name} was deleted, moved or renamed.</source>
            <translation>{name} wurde gelöscht, verschoben oder umbenannt.</translation>
        </message>
        <message>
            <location filename="../../ui/files/actions.py" />
            <source>Its folder is missing too: {parent}</source>
            <translation>Auch der Ordner fehlt: {parent}</translation>
        </message>
        <message>
            <location filename="../../ui/files/actions.py" />
            <source>&amp;Save there again</source>
            <translation>&amp;Dort wieder speichern</translation>
        </message>
        <message>
            <location filename="../../ui/files/actions.py" />
            <source>Designs and scenes ({endings});;All files (*)</source>
            <translation>Entwürfe und Szenen ({endings});;Alle Dateien (*)</translation>
        </message>
        <message>
            <location filename="../../ui/files/actions.py" />
            <source>Designs ({endings})</source>
            <translation>Entwürfe ({endings})</translation>
        </message>
        <message>
            <location filename="../../ui/files/actions.py" />
            <source>Open</source>
            <translation>Öffnen</translation>
        </message>
        <message>
            <location filename="../../ui/files/actions.py" />
            <source>{path} no longer exists; it was removed from the list.</source>
            <translation>{path} existiert nicht mehr und wurde aus der Liste entfernt.</translation>
        </message>
        <message>
            <location filename="../../ui/files/actions.py" />
            <source>Save as</source>
            <translation>Speichern unter</translation>
        </message>
        <message>
            <location filename="../../ui/files/actions.py" />
            <source>{name}: a design file ends in {ending}</source>
            <translation>{name}: eine Entwurfsdatei endet auf {ending}</translation>
        </message>
        <message>
            <location filename="../../ui/files/actions.py" />
            <source>Save the changes to {name}?</source>
            <translation>Änderungen an {name} speichern?</translation>
        </message>
        <message>
            <location filename="../../ui/files/actions.py" />
            <source>Unsaved changes</source>
            <translation>Ungespeicherte Änderungen</translation>
        </message>
        <message>
            <location filename="../../ui/files/actions.py" />
            <source>{name} is open in another window. Choose another name.</source>
            <translation>{name} ist in einem anderen Fenster geöffnet: einen anderen Namen wählen.</translation>
        </message>
        <message>
            <location filename="../../ui/files/actions.py" />
            <source>, with {lens}</source>
            <translation>, mit: {lens}</translation>
        </message>
        <message>
            <location filename="../../ui/files/actions.py" />
            <source>Save as…</source>
            <translation>Speichern unter …</translation>
        </message>
        <message>
            <location filename="../../ui/files/actions.py" />
            <source>Saved {name}, {size}{words}</source>
            <translation>{name} gespeichert, {size}{words}</translation>
        </message>
        <message>
            <location filename="../../ui/files/dialogs.py" />
            <source>File of light</source>
            <translation>Lichtdatei</translation>
        </message>
        <message>
            <location filename="../../ui/files/dialogs.py" />
            <source>{name} is a file of light, not a design.</source>
            <translation>{name} ist eine Lichtdatei, kein Entwurf.</translation>
        </message>
        <message>
            <location filename="../../ui/files/dialogs.py" />
            <source>Use as light source</source>
            <translation>Als Lichtquelle verwenden</translation>
        </message>
        <message>
            <location filename="../../ui/files/dialogs.py" />
            <source>{name} is a picture, not a design.</source>
            <translation>{name} ist ein Bild, kein Entwurf.</translation>
        </message>
        <message>
            <location filename="../../ui/files/dialogs.py" />
            <source>Use as target</source>
            <translation>Als Ziel verwenden</translation>
        </message>
        <message>
            <location filename="../../ui/files/dialogs.py" />
            <source>There is no picture on the clipboard.</source>
            <translation>In der Zwischenablage ist kein Bild.</translation>
        </message>
        <message>
            <location filename="../../ui/files/dialogs.py" />
            <source>Target image</source>
            <translation>Zielbild</translation>
        </message>
        <message>
            <location filename="../../ui/files/exporter.py" />
            <source>A file is still being written. Start the next one after it.</source>
            <translation>Eine Datei wird noch geschrieben. Danach die nächste beginnen.</translation>
        </message>
        <message>
            <location filename="../../ui/files/exporter.py" />
            <source>export</source>
            <translation>Export</translation>
        </message>
        <message>
            <location filename="../../ui/files/exporter.py" />
            <source>Export {lens}</source>
            <translation>Exportieren: {lens}</translation>
        </message>
        <message>
            <location filename="../../ui/files/exporter.py" />
            <source>Cut {lens}</source>
            <translation>Fräsen: {lens}</translation>
        </message>
        <message>
            <location filename="../../ui/files/exporter.py" />
            <source>all, one file each</source>
            <translation>alle, je eine Datei</translation>
        </message>
        <message>
            <location filename="../../ui/files/exporter.py" />
            <source>Export</source>
            <translation>Exportieren</translation>
        </message>
        <message>
            <location filename="../../ui/files/exporter.py" />
            <source>Designed element</source>
            <translation>Entworfenes Element</translation>
        </message>
        <message>
            <location filename="../../ui/files/exporter.py" />
            <source>Replace {files}?</source>
            <translation>{files} ersetzen?</translation>
        </message>
        <message>
            <location filename="../../ui/files/exporter.py" />
            <source>Export {name}</source>
            <translation>Exportieren: {name}</translation>
        </message>
        <message>
            <location filename="../../ui/files/exporter.py" />
            <source>No file was written.</source>
            <translation>Keine Datei geschrieben.</translation>
        </message>
        <message>
            <location filename="../../ui/files/exporter.py" />
            <source>{format} in {unit}</source>
            <translation>{format} in {unit}</translation>
        </message>
        <message>
            <location filename="../../ui/files/exporter.py" />
            <source>Web page (*.html)</source>
            <translation>Webseite (*.html)</translation>
        </message>
        <message>
            <location filename="../../ui/files/exporter.py" />
            <source>Document (*.pdf)</source>
            <translation>Dokument (*.pdf)</translation>
        </message>
        <message>
            <location filename="../../ui/files/exporter.py" />
            <source>report</source>
            <translation>Bericht</translation>
        </message>
        <message>
            <location filename="../../ui/files/exporter.py" />
            <source>Report {lens}</source>
            <translation>Bericht: {lens}</translation>
        </message>
        <message>
            <location filename="../../ui/files/exporter.py" />
            <source>Report {name}</source>
            <translation>Bericht: {name}</translation>
        </message>
        <message>
            <location filename="../../ui/files/plots.py" />
            <source>Picture in pixels (*.png)</source>
            <translation>Pixelbild (*.png)</translation>
        </message>
        <message>
            <location filename="../../ui/files/plots.py" />
            <source>Picture in lines (*.svg)</source>
            <translation>Vektorbild (*.svg)</translation>
        </message>
        <message>
            <location filename="../../ui/files/plots.py" />
            <source>Numbers shown (*.csv)</source>
            <translation>Gezeigte Zahlen (*.csv)</translation>
        </message>
        <message>
            <location filename="../../ui/files/plots.py" />
            <source>Figures (*.json)</source>
            <translation>Zahlen (*.json)</translation>
        </message>
        <message>
            <location filename="../../ui/files/plots.py" />
            <source>Animated picture (*.gif)</source>
            <translation>Bewegtes Bild (*.gif)</translation>
        </message>
        <message>
            <location filename="../../ui/files/plots.py" />
            <source>Animated picture in all colours (*.webp)</source>
            <translation>Bewegtes Bild in allen Farben (*.webp)</translation>
        </message>
        <message>
            <location filename="../../ui/files/plots.py" />
            <source>Animated PNG (*.apng)</source>
            <translation>Bewegtes PNG (*.apng)</translation>
        </message>
        <message>
            <location filename="../../ui/files/plots.py" />
            <source>Open folder</source>
            <translation>Ordner öffnen</translation>
        </message>
        <message>
            <location filename="../../ui/files/plots.py" />
            <source>{path} is written.</source>
            <translation>{path} ist geschrieben.</translation>
        </message>
        <message>
            <location filename="../../ui/files/plots.py" />
            <source>plot</source>
            <translation>Diagramm</translation>
        </message>
        <message>
            <location filename="../../ui/files/plots.py" />
            <source>A picture of the {pane} plot is on the clipboard.</source>
            <translation>Ein Bild des Diagramms „{pane}“ ist in der Zwischenablage.</translation>
        </message>
        <message>
            <location filename="../../ui/files/plots.py" />
            <source>Save {pane} plot</source>
            <translation>Diagramm „{pane}“ speichern</translation>
        </message>
        <message>
            <location filename="../../ui/files/plots.py" />
            <source>{name}: a plot is saved as one of {known}</source>
            <translation>{name}: ein Diagramm wird als eines von {known} gespeichert</translation>
        </message>
        <message>
            <location filename="../../ui/files/plots.py" />
            <source>No plot is visible. The View menu shows the docks of plots.</source>
            <translation>Kein Diagramm ist sichtbar. Das Menü Ansicht zeigt die Docks der Diagramme.</translation>
        </message>
        <message>
            <location filename="../../ui/files/plots.py" />
            <source>A plot is still being written. Save the next one after it.</source>
            <translation>Ein Diagramm wird noch geschrieben. Danach das nächste speichern.</translation>
        </message>
        <message>
            <location filename="../../ui/files/plots.py" />
            <source>video</source>
            <translation>Video</translation>
        </message>
        <message>
            <location filename="../../ui/files/plots.py" />
            <source>A video needs a run of some iterations. Press Start.</source>
            <translation>Ein Video braucht einen Lauf mit einigen Iterationen. Start drücken.</translation>
        </message>
        <message>
            <location filename="../../ui/files/plots.py" />
            <source>Save video</source>
            <translation>Video speichern</translation>
        </message>
        <message>
            <location filename="../../ui/files/plots.py" />
            <source>iteration {number}, error {error} %</source>
            <translation>Iteration {number}, Fehler {error} %</translation>
        </message>
        <message>
            <location filename="../../ui/files/plots.py" />
            <source>A picture of the 3D scene is on the clipboard.</source>
            <translation>Ein Bild der 3D-Szene ist in der Zwischenablage.</translation>
        </message>
        <message>
            <location filename="../../ui/files/plots.py" />
            <source>Save picture of 3D</source>
            <translation>3D-Bild speichern</translation>
        </message>
        <message>
            <location filename="../../ui/files/plots.py" />
            <source>The 3D scene is hidden. View &gt; 3D scene shows it.</source>
            <translation>Die 3D-Szene ist verborgen. Ansicht &gt; 3D-Szene zeigt sie.</translation>
        </message>
        <message>
            <location filename="../../ui/files/recovery.py" />
            <source>{name} had unsaved changes when the program was terminated.</source>
            <translation>{name} hatte ungesicherte Änderungen, als das Programm beendet wurde.</translation>
        </message>
        <message>
            <location filename="../../ui/files/recovery.py" />
            <source>The program ended unexpectedly. Unsaved changes to {name} were kept.</source>
            <translation>Das Programm wurde unerwartet beendet. Ungesicherte Änderungen an {name} wurden bewahrt.</translation>
        </message>
        <message>
            <location filename="../../ui/files/recovery.py" />
            <source>Kept on {kept_at:%Y-%m-%d, %H:%M:%S}.</source>
            <translation>Aufbewahrt am {kept_at:%Y-%m-%d, %H:%M:%S}.</translation>
        </message>
        <message>
            <location filename="../../ui/files/recovery.py" />
            <source>Unsaved work</source>
            <translation>Ungespeicherte Arbeit</translation>
        </message>
        <message>
            <location filename="../../ui/files/recovery.py" />
            <source>&amp;Recover</source>
            <translation>&amp;Wiederherstellen</translation>
        </message>
        <message>
            <location filename="../../ui/files/recovery.py" />
            <source>&amp;Discard</source>
            <translation>&amp;Verwerfen</translation>
        </message>
        <message>
            <location filename="../../ui/files/recovery.py" />
            <source>Ask &amp;later</source>
            <translation>&amp;Später fragen</translation>
        </message>
        <message>
            <location filename="../../ui/files/recovery.py" />
            <source>recovery</source>
            <translation>Sicherung</translation>
        </message>
        <message>
            <location filename="../../ui/files/recovery.py" />
            <source>Unsaved work cannot be backed up. {reason}</source>
            <translation>Ungesicherte Arbeit kann nicht zwischengespeichert werden. {reason}</translation>
        </message>
        <message>
            <location filename="../../ui/lens/brush_tools.py" />
            <source>a single point</source>
            <translation>ein einzelner Punkt</translation>
        </message>
        <message>
            <location filename="../../ui/lens/brush_tools.py" />
            <source>radius {radius}</source>
            <translation>Radius {radius}</translation>
        </message>
        <message>
            <location filename="../../ui/lens/brush_tools.py" />
            <source>{place}Paint control points to lock or unlock them; or use arrows and Space. Brush ([ and ]): {words}. {count} locked</source>
            <translation>{place}Kontrollpunkte übermalen, um sie zu sperren oder zu entsperren; oder Pfeile und Leertaste. Pinsel ([ und ]): {words}. {count} gesperrt</translation>
        </message>
        <message>
            <location filename="../../ui/lens/brush_tools.py" />
            <source>{place}Drag control points along z, or use arrows, Page Up and Page Down. Shift: fine, Esc: cancel. Brush ([ and ]): {words}</source>
            <translation>{place}Kontrollpunkte entlang z ziehen, oder Pfeile, Bild auf und Bild ab. Umschalt: fein, Esc: abbrechen. Pinsel ([ und ]): {words}</translation>
        </message>
        <message>
            <location filename="../../ui/lens/brush_tools.py" />
            <source>. Moved by {rise:+.4g} {unit}</source>
            <translation>. Verschoben um {rise:+.4g} {unit}</translation>
        </message>
        <message>
            <location filename="../../ui/lens/brush_tools.py" />
            <source>All control points under the brush are locked. Unlock some first.</source>
            <translation>Alle Kontrollpunkte im Pinsel sind gesperrt; zuerst einige freigeben.</translation>
        </message>
        <message>
            <location filename="../../ui/lens/measure.py" />
            <source>Switch off View &gt; Compress distances first, then measure.</source>
            <translation>Zuerst Ansicht &gt; Abstände stauchen ausschalten, dann messen.</translation>
        </message>
        <message>
            <location filename="../../ui/lens/measure.py" />
            <source>Click two points on lens or screen, or drag from one to the other.</source>
            <translation>Zwei Punkte auf Linse oder Schirm anklicken oder vom einen zum anderen ziehen.</translation>
        </message>
        <message>
            <location filename="../../ui/lens/measure.py" />
            <source>Distance {length} {unit}: x {x}, y {y}, z {z}</source>
            <translation>Abstand {length} {unit}: x {x}, y {y}, z {z}</translation>
        </message>
        <message>
            <location filename="../../ui/lens/move_source.py" />
            <source>Drag a handle, with Ctrl along z: source, elements, thickness at the lower rim, distance of a screen. Shift: fine, Esc: cancel.</source>
            <translation>Einen Griff ziehen, mit Strg entlang z: Quelle, Elemente, Dicke am unteren Rand, Abstand eines Schirms. Umschalt: fein, Esc: abbrechen.</translation>
        </message>
        <message>
            <location filename="../../ui/lens/move_source.py" />
            <source>Arrows, Page Up and Page Down move the source.</source>
            <translation>Pfeile, Bild auf und Bild ab bewegen die Quelle.</translation>
        </message>
        <message>
            <location filename="../../ui/lens/tools.py" />
            <source>ray trace</source>
            <translation>Strahlverfolgung</translation>
        </message>
        <message>
            <location filename="../../ui/lens/tools.py" />
            <source>Stop the run first, then sculpt the lens.</source>
            <translation>Zuerst den Lauf anhalten, dann die Linse modellieren.</translation>
        </message>
        <message>
            <location filename="../../ui/lens/tools.py" />
            <source>Stop the run first, then sculpt the mirror.</source>
            <translation>Zuerst den Lauf anhalten, dann den Spiegel modellieren.</translation>
        </message>
        <message>
            <location filename="../../ui/lens/tools.py" />
            <source>There is no lens to sculpt yet.</source>
            <translation>Es gibt noch keine Linse zum Modellieren.</translation>
        </message>
        <message>
            <location filename="../../ui/lens/tools.py" />
            <source>There is no mirror to sculpt yet.</source>
            <translation>Es gibt noch keinen Spiegel zum Modellieren.</translation>
        </message>
        <message>
            <location filename="../../ui/lens/tools.py" />
            <source>There is only one freeform face. Design &gt; Freeform entrance face adds a second one.</source>
            <translation>Es gibt eine Freiformfläche. Entwurf &gt; Freiform-Eintrittsfläche gibt einer Linse eine zweite.</translation>
        </message>
        <message>
            <location filename="../../ui/lens/tools.py" />
            <source>Switch off View &gt; Compress distances first, then move the source.</source>
            <translation>Zuerst Ansicht &gt; Abstände stauchen ausschalten, dann die Quelle bewegen.</translation>
        </message>
        <message>
            <location filename="../../ui/lens/tools.py" />
            <source>lock all points</source>
            <translation>alle Punkte sperren</translation>
        </message>
        <message>
            <location filename="../../ui/lens/tools.py" />
            <source>unlock all points</source>
            <translation>alle Punkte freigeben</translation>
        </message>
        <message>
            <location filename="../../ui/lens/tools.py" />
            <source>invert locks</source>
            <translation>Sperren umkehren</translation>
        </message>
        <message>
            <location filename="../../ui/lens/tools.py" />
            <source>move control points</source>
            <translation>Kontrollpunkte verschieben</translation>
        </message>
        <message>
            <location filename="../../ui/lens/tools.py" />
            <source>lock points</source>
            <translation>Punkte sperren</translation>
        </message>
        <message>
            <location filename="../../ui/lens/tools.py" />
            <source>unlock points</source>
            <translation>Punkte freigeben</translation>
        </message>
        <message>
            <location filename="../../ui/main_window.py" />
            <source>The {count} oldest steps can no longer be undone (memory limit)</source>
            <translation>Die {count} ältesten Schritte lassen sich nicht mehr rückgängig machen (Speichergrenze)</translation>
        </message>
        <message>
            <location filename="../../ui/main_window.py" />
            <source>A run of {design} is in progress. Stop it and save the best lens?</source>
            <translation>Ein Lauf von {design} ist im Gange. Anhalten und die beste Linse speichern?</translation>
        </message>
        <message>
            <location filename="../../ui/main_window.py" />
            <source>A run of {design} is in progress. Stop it and save the best mirror?</source>
            <translation>Ein Lauf von {design} ist im Gange. Anhalten und den besten Spiegel speichern?</translation>
        </message>
        <message>
            <location filename="../../ui/main_window.py" />
            <source> Changes that wait for the end of the run are discarded.</source>
            <translation> Änderungen, die auf das Ende des Laufs warten, werden verworfen.</translation>
        </message>
        <message>
            <location filename="../../ui/main_window.py" />
            <source>A run of {design} is in progress. Stop it to open {file}.</source>
            <translation>Ein Lauf von {design} ist im Gange. Zum Öffnen von {file} anhalten.</translation>
        </message>
        <message>
            <location filename="../../ui/main_window.py" />
            <source>Stop and open</source>
            <translation>Stoppen und öffnen</translation>
        </message>
        <message>
            <location filename="../../ui/main_window.py" />
            <source>Saved with the last valid value of each marked field.</source>
            <translation>Gespeichert mit dem letzten gültigen Wert jedes markierten Feldes.</translation>
        </message>
        <message>
            <location filename="../../ui/main_window.py" />
            <source>Saved with the task of the run.</source>
            <translation>Mit der Aufgabe des Laufs gespeichert.</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cutter.py" />
            <source>Writes the passes of a ball cutter as G-code in millimetres. The cut is simulated first; a cutter that leaves too much material or cuts too deep is refused.</source>
            <translation>Schreibt die Schnitte eines Kugelfräsers als G-Code in Millimetern. Der Schnitt wird zuerst simuliert; ein Fräser, der zu viel Material stehen lässt oder zu tief schneidet, wird abgelehnt.</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cutter.py" />
            <source>simulation of the cut</source>
            <translation>Simulation des Schnitts</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cutter.py" />
            <source>Ball cutter</source>
            <translation>Kugelfräser</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cutter.py" />
            <source>Result of the simulation</source>
            <translation>Ergebnis der Simulation</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cutter.py" />
            <source>&amp;Write G-code…</source>
            <translation>G-Code &amp;schreiben …</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cutter.py" />
            <source>Compare the image of the lens as made with the lens as designed</source>
            <translation>Bild der gefertigten Linse mit dem der entworfenen vergleichen</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cutter.py" />
            <source>&amp;Trace light</source>
            <translation>Licht &amp;durchrechnen</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cutter.py" />
            <source>Simulating the cut: {percent} %</source>
            <translation>Simulation des Schnitts: {percent} %</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cutter.py" />
            <source>Tracing: {percent} %</source>
            <translation>Durchrechnung: {percent} %</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cutter.py" />
            <source>Use {radius}</source>
            <translation>{radius} verwenden</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cutter.py" />
            <source>Up to {cut_off} is cut too deep</source>
            <translation>Bis zu {cut_off} wird zu tief geschnitten</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cutter.py" />
            <source>Radius {radius}, {size:,} moves. {deep}; up to {left} of material remains.</source>
            <translation>Radius {radius}, {size:,} Bewegungen. {deep}; bis zu {left} Material bleibt stehen.</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cutter.py" />
            <source>Nothing is cut too deep</source>
            <translation>Nirgends wird zu tief geschnitten</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cutter.py" />
            <source>The cutter fits.</source>
            <translation>Der Fräser passt.</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>Empty: the limit of the design task. Stored for the next start.</source>
            <translation>Leer: die Grenze der Aufgabe. Wird für den nächsten Start gespeichert.</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>✓ met</source>
            <translation>✓ erfüllt</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>The limit is kept everywhere.</source>
            <translation>Die Grenze ist überall eingehalten.</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>? not checked yet</source>
            <translation>? noch nicht geprüft</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>The limit is kept at all sampled points. Proved for the whole face: {bound}.</source>
            <translation>Die Grenze ist an allen Abtastpunkten eingehalten. Für die ganze Fläche bewiesen: {bound}.</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>✗ exceeded</source>
            <translation>✗ verletzt</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>The limit is exceeded; the map shows where.</source>
            <translation>Die Grenze ist verletzt; die Karte zeigt wo.</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>Slope</source>
            <translation>Neigung</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>Largest angle between the face and a plane across the axis</source>
            <translation>Größter Winkel zwischen der Fläche und einer Ebene quer zur Achse</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>Concave radius</source>
            <translation>Konkaver Radius</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>Least concave radius of curvature</source>
            <translation>Kleinster konkaver Krümmungsradius</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>Convex radius</source>
            <translation>Konvexer Radius</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>Least convex radius of curvature</source>
            <translation>Kleinster konvexer Krümmungsradius</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>Largest ball cutter</source>
            <translation>Größter Kugelfräser</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>Radius of the largest ball cutter that fits everywhere on the face. A larger ball leaves material in hollows</source>
            <translation>Radius des größten Kugelfräsers, der überall auf der Fläche passt. Eine größere Kugel lässt Material in Mulden stehen</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>Sag range</source>
            <translation>Pfeilhöhe</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>Height of the highest point of the face above the lowest</source>
            <translation>Höhe des höchsten Punkts der Fläche über dem tiefsten</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>Draft</source>
            <translation>Formschräge</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>Least angle between the face and the axis, along which a mould opens</source>
            <translation>Kleinster Winkel zwischen Fläche und Achse, entlang der sich eine Form öffnet</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>Limit: {label}</source>
            <translation>Grenze: {label}</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>Lens</source>
            <translation>Linse</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>Limit</source>
            <translation>Grenze</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>Entrance face</source>
            <translation>Eintrittsfläche</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>Entrance face: {figure}</source>
            <translation>Eintrittsfläche: {figure}</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>Verdict: {figure}</source>
            <translation>Urteil: {figure}</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>The face has none.</source>
            <translation>Die Fläche hat keine.</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>At x = {x}, y = {y}. Proved bound: {bound}.</source>
            <translation>Bei x = {x}, y = {y}. Bewiesene Schranke: {bound}.</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/pane.py" />
            <source>Computed when the design rests…</source>
            <translation>Wird berechnet, sobald der Entwurf ruht …</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/pane.py" />
            <source>Thickness along z</source>
            <translation>Dicke entlang z</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/pane.py" />
            <source>Angle between the face and a plane across the axis</source>
            <translation>Winkel zwischen der Fläche und einer Ebene quer zur Achse</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/pane.py" />
            <source>Largest concave curvature; zero where there is none</source>
            <translation>Größte konkave Krümmung; null, wo es keine gibt</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/pane.py" />
            <source>Largest convex curvature; zero where there is none</source>
            <translation>Größte konvexe Krümmung; null, wo es keine gibt</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/pane.py" />
            <source>Red and hatched where a limit is exceeded, green elsewhere</source>
            <translation>Rot und schraffiert, wo eine Grenze überschritten ist, sonst grün</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/pane.py" />
            <source>; hatched where a limit is exceeded</source>
            <translation>; schraffiert, wo eine Grenze verletzt ist</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/pane.py" />
            <source>exceeded</source>
            <translation>überschritten</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/pane.py" />
            <source>analysis of the face</source>
            <translation>Analyse der Fläche</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/pane.py" />
            <source>Analysis of the face</source>
            <translation>Analyse der Fläche</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/pane.py" />
            <source>Computing…</source>
            <translation>Berechnung …</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/pane.py" />
            <source>Computing the figures…</source>
            <translation>Kennwerte werden berechnet …</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/pane.py" />
            <source>Outdated; recomputed when the design rests.</source>
            <translation>Veraltet; wird neu berechnet, wenn der Entwurf ruht.</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/plan.py" />
            <source>Step-over</source>
            <translation>Zeilenabstand</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/plan.py" />
            <source>Scallop</source>
            <translation>Rillenhöhe</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/plan.py" />
            <source>Polish over</source>
            <translation>Politur über</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/plan.py" />
            <source>Error as made</source>
            <translation>Fehler nach Fertigung</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/plan.py" />
            <source>Minutes</source>
            <translation>Minuten</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/plan.py" />
            <source>Milling leaves scallops, and polishing removes them and fine details of the lens. These plans reach the wanted error; the first takes the least time and is verified by random rays.</source>
            <translation>Fräsen hinterlässt Rillen; Polieren entfernt sie und feine Einzelheiten der Linse. Diese Pläne erreichen den gewünschten Fehler; der erste braucht die kürzeste Zeit und ist mit Zufallsstrahlen geprüft.</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/plan.py" />
            <source>Plan milling and polishing</source>
            <translation>Fräsen und Polieren planen</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/plan.py" />
            <source>search for plans</source>
            <translation>Suche nach Plänen</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/plan.py" />
            <source>Result of the search</source>
            <translation>Ergebnis der Suche</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/plan.py" />
            <source>Plans</source>
            <translation>Pläne</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/plan.py" />
            <source>Enter these processes; Continue then designs for them</source>
            <translation>Diese Verfahren eintragen; Fortsetzen entwirft dann für sie</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/plan.py" />
            <source>&amp;Use this plan</source>
            <translation>Diesen Plan &amp;verwenden</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/plan.py" />
            <source>&amp;Find plans</source>
            <translation>Pläne &amp;suchen</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/plan.py" />
            <source>Comparing plans: {percent} %</source>
            <translation>Pläne werden verglichen: {percent} %</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/plan.py" />
            <source>plan of manufacture</source>
            <translation>Fertigungsplan</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/plan.py" />
            <source>Error as designed {designed:.2f} %, wanted as made {wanted:.2f} %; ball radius {radius}.</source>
            <translation>Fehler wie entworfen {designed:.2f} %, nach Fertigung gewünscht {wanted:.2f} %; Kugelradius {radius}.</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/tolerance_form.py" />
            <source>Lenses</source>
            <translation>Linsen</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/tolerance_form.py" />
            <source>Number of traced lenses; more lenses give better percentiles</source>
            <translation>Zahl der gerechneten Linsen; mehr Linsen geben bessere Perzentile</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/tolerance_form.py" />
            <source>Seed</source>
            <translation>Startwert</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/tolerance_form.py" />
            <source>The same seed gives the same lenses</source>
            <translation>Derselbe Startwert ergibt dieselben Linsen</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/tolerance_form.py" />
            <source>over</source>
            <translation>über</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/tolerance_pane.py" />
            <source>Start traces randomly perturbed lenses and shows the distribution of the error.</source>
            <translation>Start rechnet zufällig gestörte Linsen und zeigt die Verteilung des Fehlers.</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/tolerance_pane.py" />
            <source>All tolerances are zero. Enter a tilt, a decentre or another tolerance.</source>
            <translation>Alle Toleranzen sind null. Eine Verkippung, Dezentrierung oder andere Toleranz eingeben.</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/tolerance_pane.py" />
            <source>Save…</source>
            <translation>Speichern …</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/tolerance_pane.py" />
            <source>Save the plot (PNG, SVG), or the figures of each lens (CSV, JSON)</source>
            <translation>Das Diagramm (PNG, SVG) oder die Zahlen jeder Linse (CSV, JSON) speichern</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/tolerance_pane.py" />
            <source>tolerance analysis</source>
            <translation>Toleranzanalyse</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/tolerance_pane.py" />
            <source>Stop; the traced lenses are kept</source>
            <translation>Anhalten; die gerechneten Linsen bleiben</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/tolerance_pane.py" />
            <source>Perturb the lens at random and trace each sample independently</source>
            <translation>Linse zufällig stören und jede Probe unabhängig rechnen</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/tolerance_pane.py" />
            <source>{count} of {wanted} lenses</source>
            <translation>{count} von {wanted} Linsen</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/tolerance_pane.py" />
            <source>{done}: error as designed {nominal:.2f} %, median {median:.2f} %, 95 % of lenses below {most:.2f} %, worst {worst:.2f} %</source>
            <translation>{done}: Fehler wie entworfen {nominal:.2f} %, Median {median:.2f} %, 95 % der Linsen unter {most:.2f} %, schlechteste {worst:.2f} %</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/tolerance_pane.py" />
            <source>Outdated: the lens has changed.</source>
            <translation>Veraltet: die Linse hat sich geändert.</translation>
        </message>
        <message>
            <location filename="../../ui/panels/area.py" />
            <source>Limits</source>
            <translation>Grenzen</translation>
        </message>
        <message>
            <location filename="../../ui/panels/area.py" />
            <source>Expert</source>
            <translation>Experte</translation>
        </message>
        <message>
            <location filename="../../ui/panels/area.py" />
            <source>No field matches.</source>
            <translation>Kein Feld passt.</translation>
        </message>
        <message>
            <location filename="../../ui/panels/area.py" />
            <source>Search all fields by name, explanation or path in files (Ctrl+F)</source>
            <translation>Alle Felder nach Name, Erklärung oder Pfad in Dateien durchsuchen (Strg+F)</translation>
        </message>
        <message>
            <location filename="../../ui/panels/area.py" />
            <source>Search fields</source>
            <translation>Felder suchen</translation>
        </message>
        <message>
            <location filename="../../ui/panels/area.py" />
            <source>{count} changed</source>
            <translation>{count} geändert</translation>
        </message>
        <message>
            <location filename="../../ui/panels/crop.py" />
            <source>Picture with the part that is kept</source>
            <translation>Bild mit dem Teil, der bleibt</translation>
        </message>
        <message>
            <location filename="../../ui/panels/edits.py" />
            <source>the task no longer has this field</source>
            <translation>die Aufgabe hat dieses Feld nicht mehr</translation>
        </message>
        <message>
            <location filename="../../ui/panels/elements.py" />
            <source>element</source>
            <translation>Element</translation>
        </message>
        <message>
            <location filename="../../ui/panels/elements.py" />
            <source>Add lens</source>
            <translation>+ Linse</translation>
        </message>
        <message>
            <location filename="../../ui/panels/elements.py" />
            <source>Add a plano-convex lens of fixed shape behind the others</source>
            <translation>Eine plankonvexe Linse fester Form hinter den anderen hinzufügen</translation>
        </message>
        <message>
            <location filename="../../ui/panels/elements.py" />
            <source>Add mirror</source>
            <translation>+ Spiegel</translation>
        </message>
        <message>
            <location filename="../../ui/panels/elements.py" />
            <source>Add a plane mirror behind the others</source>
            <translation>Einen ebenen Spiegel hinter den anderen hinzufügen</translation>
        </message>
        <message>
            <location filename="../../ui/panels/elements.py" />
            <source>Add diffuser</source>
            <translation>+ Diffusor</translation>
        </message>
        <message>
            <location filename="../../ui/panels/elements.py" />
            <source>Add a diffuser behind the others</source>
            <translation>Einen Diffusor hinter den anderen hinzufügen</translation>
        </message>
        <message>
            <location filename="../../ui/panels/elements.py" />
            <source>Optical train</source>
            <translation>Optisches System</translation>
        </message>
        <message>
            <location filename="../../ui/panels/elements.py" />
            <source>designed</source>
            <translation>entworfen</translation>
        </message>
        <message>
            <location filename="../../ui/panels/elements.py" />
            <source>Kind</source>
            <translation>Art</translation>
        </message>
        <message>
            <location filename="../../ui/panels/elements.py" />
            <source>Custom index</source>
            <translation>Eigene Brechzahl</translation>
        </message>
        <message>
            <location filename="../../ui/panels/elements.py" />
            <source>Automatic</source>
            <translation>Automatisch</translation>
        </message>
        <message>
            <location filename="../../ui/panels/elements.py" />
            <source>Own limits</source>
            <translation>Eigene Grenzen</translation>
        </message>
        <message>
            <location filename="../../ui/panels/elements.py" />
            <source>Bounds of the control heights relative to the base, down and up. Wider bounds allow larger deflection.</source>
            <translation>Schranken der Kontrollhöhen relativ zur Grundform, nach unten und oben. Weitere Schranken erlauben größere Ablenkung.</translation>
        </message>
        <message>
            <location filename="../../ui/panels/elements.py" />
            <source>From the base</source>
            <translation>Ab Grundform</translation>
        </message>
        <message>
            <location filename="../../ui/panels/fields.py" />
            <source>change of {name}</source>
            <translation>{name} ändern</translation>
        </message>
        <message>
            <location filename="../../ui/panels/fields.py" />
            <source>{label}, {number} of {count}</source>
            <translation>{label}, {number} von {count}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/fields.py" />
            <source>Auto</source>
            <translation>Auto</translation>
        </message>
        <message>
            <location filename="../../ui/panels/fields.py" />
            <source>{label}, automatic</source>
            <translation>{label}, automatisch</translation>
        </message>
        <message>
            <location filename="../../ui/panels/fields.py" />
            <source>auto</source>
            <translation>auto</translation>
        </message>
        <message>
            <location filename="../../ui/panels/forms.py" />
            <source>refused {edit}</source>
            <translation>abgelehnt: {edit}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/forms.py" />
            <source>change of target image</source>
            <translation>Zielbild ändern</translation>
        </message>
        <message>
            <location filename="../../ui/panels/forms.py" />
            <source>change of file of light</source>
            <translation>Lichtdatei ändern</translation>
        </message>
        <message>
            <location filename="../../ui/panels/forms.py" />
            <source>flat entrance face</source>
            <translation>ebene Eintrittsfläche</translation>
        </message>
        <message>
            <location filename="../../ui/panels/forms.py" />
            <source>freeform entrance face</source>
            <translation>Freiform-Eintrittsfläche</translation>
        </message>
        <message>
            <location filename="../../ui/panels/forms.py" />
            <source>The target is not a picture and has no aspect.</source>
            <translation>Das Ziel ist kein Bild und hat kein Seitenverhältnis.</translation>
        </message>
        <message>
            <location filename="../../ui/panels/forms.py" />
            <source>The picture cannot be read: {refused}</source>
            <translation>Das Bild kann nicht gelesen werden: {refused}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/forms.py" />
            <source>aspect of the picture for the screen</source>
            <translation>Seitenverhältnis des Bildes für den Schirm</translation>
        </message>
        <message>
            <location filename="../../ui/panels/forms.py" />
            <source>aspect of the picture for the far field</source>
            <translation>Seitenverhältnis des Bildes für das Fernfeld</translation>
        </message>
        <message>
            <location filename="../../ui/panels/forms.py" />
            <source>The design is paused. Changes wait until it ends.</source>
            <translation>Der Entwurf ist angehalten. Änderungen warten, bis er endet.</translation>
        </message>
        <message>
            <location filename="../../ui/panels/forms.py" />
            <source>The design is running. Changes wait until it ends.</source>
            <translation>Der Entwurf läuft. Änderungen warten, bis er endet.</translation>
        </message>
        <message>
            <location filename="../../ui/panels/forms.py" />
            <source>The {edit} is refused: {refused}</source>
            <translation>Abgelehnt ({edit}): {refused}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/forms.py" />
            <source>Refused: {refused}</source>
            <translation>Abgelehnt: {refused}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/forms.py" />
            <source>Stop the run first, then reload the image.</source>
            <translation>Zuerst den Lauf anhalten, dann das Bild neu laden.</translation>
        </message>
        <message>
            <location filename="../../ui/panels/forms.py" />
            <source>Waiting for the end of the run: {edits}.</source>
            <translation>Wartet auf das Ende des Laufs: {edits}.</translation>
        </message>
        <message>
            <location filename="../../ui/panels/images.py" />
            <source>Images ({endings});;All files (*)</source>
            <translation>Bilder ({endings});;Alle Dateien (*)</translation>
        </message>
        <message>
            <location filename="../../ui/panels/images.py" />
            <source>An image file can also be dropped onto the window.</source>
            <translation>Eine Bilddatei lässt sich auch auf das Fenster ziehen.</translation>
        </message>
        <message>
            <location filename="../../ui/panels/images.py" />
            <source>Choose the part of the picture that is used, and its levels</source>
            <translation>Den Teil des Bildes wählen, der verwendet wird, und seine Tonwerte</translation>
        </message>
        <message>
            <location filename="../../ui/panels/images.py" />
            <source>Crop and tone…</source>
            <translation>Zuschnitt und Tonwerte…</translation>
        </message>
        <message>
            <location filename="../../ui/panels/images.py" />
            <source>Turn</source>
            <translation>Drehen</translation>
        </message>
        <message>
            <location filename="../../ui/panels/images.py" />
            <source>Turn the picture by a quarter to the right</source>
            <translation>Das Bild um ein Viertel nach rechts drehen</translation>
        </message>
        <message>
            <location filename="../../ui/panels/images.py" />
            <source>crop and tone of the picture</source>
            <translation>Zuschnitt und Tonwerte des Bildes</translation>
        </message>
        <message>
            <location filename="../../ui/panels/images.py" />
            <source>turn of the picture</source>
            <translation>Drehung des Bildes</translation>
        </message>
        <message>
            <location filename="../../ui/panels/images.py" />
            <source>Target irradiance as its viewer sees it</source>
            <translation>Ziel-Bestrahlungsstärke, wie der Betrachter sie sieht</translation>
        </message>
        <message>
            <location filename="../../ui/panels/images.py" />
            <source>image</source>
            <translation>Bild</translation>
        </message>
        <message>
            <location filename="../../ui/panels/images.py" />
            <source>Image {number}</source>
            <translation>Bild {number}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/images.py" />
            <source>Add an image farther away, with the target of the last one</source>
            <translation>Ein weiter entferntes Bild mit dem Ziel des letzten hinzufügen</translation>
        </message>
        <message>
            <location filename="../../ui/panels/images.py" />
            <source>Add</source>
            <translation>Hinzufügen</translation>
        </message>
        <message>
            <location filename="../../ui/panels/images.py" />
            <source>The panels Target and Receiver belong to image 1.</source>
            <translation>Die Bereiche Ziel und Empfänger gehören zu Bild 1.</translation>
        </message>
        <message>
            <location filename="../../ui/panels/images.py" />
            <source>{place}, {target}, weight {weight:g}</source>
            <translation>{place}, {target}, Gewicht {weight:g}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/images.py" />
            <source>As x, y; x, y; …</source>
            <translation>In der Form x, y; x, y; …</translation>
        </message>
        <message>
            <location filename="../../ui/panels/images.py" />
            <source>region</source>
            <translation>Ausschnitt</translation>
        </message>
        <message>
            <location filename="../../ui/panels/images.py" />
            <source>Region {number}</source>
            <translation>Ausschnitt {number}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/images.py" />
            <source>None.</source>
            <translation>Keine.</translation>
        </message>
        <message>
            <location filename="../../ui/panels/images.py" />
            <source>Shape</source>
            <translation>Form</translation>
        </message>
        <message>
            <location filename="../../ui/panels/images.py" />
            <source>Add a region in the middle</source>
            <translation>Einen Ausschnitt in der Mitte hinzufügen</translation>
        </message>
        <message>
            <location filename="../../ui/panels/images.py" />
            <source>Regions</source>
            <translation>Bereiche</translation>
        </message>
        <message>
            <location filename="../../ui/panels/images.py" />
            <source>Region {count}</source>
            <translation>Ausschnitt {count}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/panel.py" />
            <source>{panel} {field}</source>
            <translation>{panel}, {field}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/panel.py" />
            <source>Duplicate</source>
            <translation>Duplizieren</translation>
        </message>
        <message>
            <location filename="../../ui/panels/panel.py" />
            <source>Add a copy of the selected one</source>
            <translation>Eine Kopie des gewählten Eintrags hinzufügen</translation>
        </message>
        <message>
            <location filename="../../ui/panels/panel.py" />
            <source>Remove</source>
            <translation>Entfernen</translation>
        </message>
        <message>
            <location filename="../../ui/panels/panel.py" />
            <source>Remove the selected one</source>
            <translation>Den gewählten Eintrag entfernen</translation>
        </message>
        <message>
            <location filename="../../ui/panels/panel.py" />
            <source>Up</source>
            <translation>Auf</translation>
        </message>
        <message>
            <location filename="../../ui/panels/panel.py" />
            <source>Move the selected one up</source>
            <translation>Den gewählten Eintrag nach oben verschieben</translation>
        </message>
        <message>
            <location filename="../../ui/panels/panel.py" />
            <source>Down</source>
            <translation>Ab</translation>
        </message>
        <message>
            <location filename="../../ui/panels/panel.py" />
            <source>Move the selected one down</source>
            <translation>Den gewählten Eintrag nach unten verschieben</translation>
        </message>
        <message>
            <location filename="../../ui/panels/panel.py" />
            <source>new {part}</source>
            <translation>Neu: {part}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/panel.py" />
            <source>copy of {part} {number}</source>
            <translation>Kopie von {part} {number}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/panel.py" />
            <source>removal of {part} {number}</source>
            <translation>{part} {number} entfernen</translation>
        </message>
        <message>
            <location filename="../../ui/panels/panel.py" />
            <source>move of {part} {number}</source>
            <translation>{part} {number} verschieben</translation>
        </message>
        <message>
            <location filename="../../ui/panels/picture_dialog.py" />
            <source>Histogram of the picture</source>
            <translation>Histogramm des Bildes</translation>
        </message>
        <message>
            <location filename="../../ui/panels/picture_dialog.py" />
            <source>Drag black level, mid-tones or white level; double-click to reset all three</source>
            <translation>Schwarzwert, Mitteltöne oder Weißwert ziehen; Doppelklick setzt alle drei zurück</translation>
        </message>
        <message>
            <location filename="../../ui/panels/picture_dialog.py" />
            <source>Crop and tone of the picture</source>
            <translation>Zuschnitt und Tonwerte des Bildes</translation>
        </message>
        <message>
            <location filename="../../ui/panels/picture_dialog.py" />
            <source>&amp;Whole picture</source>
            <translation>&amp;Ganzes Bild</translation>
        </message>
        <message>
            <location filename="../../ui/panels/picture_dialog.py" />
            <source>Kept: {width:.0f} × {height:.0f} % of the picture, aspect {aspect:.2f}</source>
            <translation>Es bleiben {width:.0f} × {height:.0f} % des Bildes, Seitenverhältnis {aspect:.2f}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/picture_dialog.py" />
            <source>Peak: {peak:.1f} × the mean; black: {black:.0f} % of the area</source>
            <translation>Spitze: {peak:.1f} × Mittelwert; schwarz: {black:.0f} % der Fläche</translation>
        </message>
        <message>
            <location filename="../../ui/panels/rows.py" />
            <source>The design keeps files of up to {largest} MB.</source>
            <translation>Der Entwurf bewahrt Dateien bis {largest} MB auf.</translation>
        </message>
        <message>
            <location filename="../../ui/panels/rows.py" />
            <source>Choose a file</source>
            <translation>Datei wählen</translation>
        </message>
        <message>
            <location filename="../../ui/panels/scene.py" />
            <source>Scene</source>
            <translation>Szene</translation>
        </message>
        <message>
            <location filename="../../ui/panels/scene.py" />
            <source>change of unit</source>
            <translation>Einheit ändern</translation>
        </message>
        <message>
            <location filename="../../ui/panels/scene.py" />
            <source>Files of light ({endings});;All files (*)</source>
            <translation>Lichtdateien ({endings});;Alle Dateien (*)</translation>
        </message>
        <message>
            <location filename="../../ui/panels/scene.py" />
            <source>Number of optimised parameters, and their memory with gradient and optimiser state. A network that does not fit into memory is refused at the start.</source>
            <translation>Zahl der optimierten Parameter und ihr Speicher mit Gradient und Zustand des Optimierers. Ein Netz, das nicht in den Speicher passt, wird beim Start abgelehnt.</translation>
        </message>
        <message>
            <location filename="../../ui/panels/scene.py" />
            <source>Parameters</source>
            <translation>Parameter</translation>
        </message>
        <message>
            <location filename="../../ui/panels/scene.py" />
            <source>1 iteration</source>
            <translation>1 Iteration</translation>
        </message>
        <message>
            <location filename="../../ui/panels/scene.py" />
            <source>{count} iterations</source>
            <translation>{count} Iterationen</translation>
        </message>
        <message>
            <location filename="../../ui/panels/scene.py" />
            <source>stage</source>
            <translation>Stufe</translation>
        </message>
        <message>
            <location filename="../../ui/panels/scene.py" />
            <source>Stage {number}</source>
            <translation>Stufe {number}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/scene.py" />
            <source>None: the run has only the scene itself.</source>
            <translation>Keine: der Lauf hat nur die Szene selbst.</translation>
        </message>
        <message>
            <location filename="../../ui/panels/scene.py" />
            <source>Stages that a run completes before the scene itself; each continues from the lens of the previous one. Example: a point source before an extended one, or a coarse net before a fine one.</source>
            <translation>Stufen, die ein Lauf vor der Szene selbst durchläuft; jede setzt von der Linse der vorigen fort. Beispiel: eine Punktquelle vor einer ausgedehnten oder ein grobes Netz vor einem feinen.</translation>
        </message>
        <message>
            <location filename="../../ui/panels/scene.py" />
            <source>Stages</source>
            <translation>Stufen</translation>
        </message>
        <message>
            <location filename="../../ui/panels/scene.py" />
            <source>Add a stage behind the others</source>
            <translation>Eine Stufe hinter den anderen hinzufügen</translation>
        </message>
        <message>
            <location filename="../../ui/panels/scene.py" />
            <source>Then the scene itself: {iterations}.</source>
            <translation>Danach die Szene selbst: {iterations}.</translation>
        </message>
        <message>
            <location filename="../../ui/panels/scene.py" />
            <source>net of {n_u} × {n_v}</source>
            <translation>Netz aus {n_u} × {n_v}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/scene.py" />
            <source>{kind} filter</source>
            <translation>Filter: {kind}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/scene.py" />
            <source>process</source>
            <translation>Verfahren</translation>
        </message>
        <message>
            <location filename="../../ui/panels/scene.py" />
            <source>Process {number}</source>
            <translation>Verfahren {number}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/scene.py" />
            <source>None: elements are as designed.</source>
            <translation>Keine: Elemente sind wie entworfen.</translation>
        </message>
        <message>
            <location filename="../../ui/panels/scene.py" />
            <source>Process</source>
            <translation>Verfahren</translation>
        </message>
        <message>
            <location filename="../../ui/panels/scene.py" />
            <source>Add {process} behind the others</source>
            <translation>{process} hinter den anderen hinzufügen</translation>
        </message>
        <message>
            <location filename="../../ui/panels/scene.py" />
            <source>Preset…</source>
            <translation>Vorlage …</translation>
        </message>
        <message>
            <location filename="../../ui/panels/scene.py" />
            <source>Choose a process with usual values, whose source is stated</source>
            <translation>Einen Prozess mit üblichen Werten wählen, deren Quelle genannt ist</translation>
        </message>
        <message>
            <location filename="../../ui/panels/scene.py" />
            <source>Preset</source>
            <translation>Vorlage</translation>
        </message>
        <message>
            <location filename="../../ui/panels/scene.py" />
            <source>Process and source</source>
            <translation>Prozess und Quelle</translation>
        </message>
        <message>
            <location filename="../../ui/run/cards.py" />
            <source>findings</source>
            <translation>Befunde</translation>
        </message>
        <message>
            <location filename="../../ui/run/cards.py" />
            <source>goal</source>
            <translation>Vorgabe</translation>
        </message>
        <message>
            <location filename="../../ui/run/cards.py" />
            <source>Good</source>
            <translation>Gut</translation>
        </message>
        <message>
            <location filename="../../ui/run/cards.py" />
            <source>Needs attention</source>
            <translation>Zu beachten</translation>
        </message>
        <message>
            <location filename="../../ui/run/cards.py" />
            <source>Goal missed</source>
            <translation>Vorgabe verfehlt</translation>
        </message>
        <message>
            <location filename="../../ui/run/cards.py" />
            <source>Goal</source>
            <translation>Vorgabe</translation>
        </message>
        <message>
            <location filename="../../ui/run/cards.py" />
            <source>Type a limit, at most {most}; empty the field to remove the goal</source>
            <translation>Grenze eingeben, höchstens {most}; ein leeres Feld entfernt die Vorgabe</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>F8 checks the design with an independent ray trace.</source>
            <translation>F8 prüft den Entwurf mit unabhängigem Raytracing.</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>check failed</source>
            <translation>Prüfung fehlgeschlagen</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>Two independent methods, beam meshes and random rays, differ by more than their error bounds: one of them is wrong.</source>
            <translation>Zwei unabhängige Verfahren, Bündelnetze und Zufallsstrahlen, unterscheiden sich um mehr als ihre Fehlerschranken: eines ist falsch.</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>no deterministic figure</source>
            <translation>kein deterministischer Wert</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>The error is from random rays alone; the intervals below include their noise.</source>
            <translation>Der Fehler stammt nur aus Zufallsstrahlen; die Intervalle unten enthalten ihr Rauschen.</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>optimiser and check</source>
            <translation>Optimierer und Prüfung</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>Image or efficiency of the optimiser differ from the check by more than the error bounds; the optimiser traces fewer rays.</source>
            <translation>Bild oder Wirkungsgrad des Optimierers weichen um mehr als die Fehlerschranken von der Prüfung ab; der Optimierer rechnet weniger Strahlen.</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>verified error</source>
            <translation>geprüfter Fehler</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>Relative L2 error between image and target, free of ray noise, and the interval that it is in: by a deterministic beam mesh, or by random rays with 95 % confidence. With &lt; where it cannot be told from zero.</source>
            <translation>Relativer L2-Fehler zwischen Bild und Ziel, frei von Strahlrauschen, und das Intervall, in dem er liegt: mit deterministischem Bündelnetz, oder mit Zufallsstrahlen bei 95 % Konfidenz. Mit &lt;, wenn er sich nicht von null unterscheiden lässt.</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>beam mesh</source>
            <translation>Bündelnetz</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>Number of beams through the entrance face.</source>
            <translation>Zahl der Bündel durch die Eintrittsfläche.</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>error by image pairs</source>
            <translation>Fehler aus Bildpaaren</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>The deterministic check would be too slow here; pairs of random images are used. The interval has 95 % confidence.</source>
            <translation>Die deterministische Prüfung wäre hier zu langsam; Paare zufälliger Bilder werden verwendet. Das Intervall hat 95 % Konfidenz.</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>difference of random rays</source>
            <translation>Abweichung der Zufallsstrahlen</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>Relative L2 difference between the images of both methods. About one noise level is expected.</source>
            <translation>Relative L2-Differenz zwischen den Bildern beider Verfahren. Etwa ein Rauschpegel ist zu erwarten.</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>error by random rays</source>
            <translation>Fehler mit Zufallsstrahlen</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>The same error by random rays without their noise, with 95 % confidence: a second opinion.</source>
            <translation>Derselbe Fehler mit Zufallsstrahlen ohne ihr Rauschen, bei 95 % Konfidenz: eine zweite Meinung.</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>error with ray noise</source>
            <translation>Fehler mit Strahlrauschen</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>‖I − T‖ / ‖T‖ of image and target, each divided by its sum, by random rays with their noise, which more rays reduce. The interval is that of 95 % for other rays.</source>
            <translation>‖I − T‖ / ‖T‖ von Bild und Ziel, jeweils durch ihre Summe geteilt, mit Zufallsstrahlen und ihrem Rauschen, das mehr Strahlen verringern. Das Intervall ist das von 95 % für andere Strahlen.</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>loss of the paper</source>
            <translation>Zielfunktion der Veröffentlichung</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>Norm of the difference between image and target, each divided by its sum, over the root of the number of pixels.</source>
            <translation>Die Norm der Differenz von Bild und Ziel, jeweils durch ihre Summe geteilt, durch die Wurzel der Pixelzahl.</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>PSNR</source>
            <translation>PSNR</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>Peak signal-to-noise ratio, against the target's peak: more is better.</source>
            <translation>Spitzen-Signal-Rausch-Verhältnis, bezogen auf die Spitze des Ziels: mehr ist besser.</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>SSIM</source>
            <translation>SSIM</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>Mean structural similarity in windows of 11 × 11 pixels: 1 for equal images.</source>
            <translation>Mittlere strukturelle Ähnlichkeit in Fenstern von 11 × 11 Pixeln: 1 bei gleichen Bildern.</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>Pearson's coefficient of image and target over the pixels; 1 for proportional images.</source>
            <translation>Pearson-Koeffizient von Bild und Ziel über die Pixel; 1 für proportionale Bilder.</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>Least over mean of irradiance / target where the target is at least half its peak; 1 is uniform, 0 has a dark pixel.</source>
            <translation>Minimum über Mittel von Bestrahlungsstärke / Ziel, wo das Ziel mindestens halb so hell wie sein Maximum ist; 1 ist gleichmäßig, 0 hat einen dunklen Pixel.</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>(lit − black) / (lit + black) of the mean irradiances there; black is up to a hundredth of the target's peak. 1 is a perfect black.</source>
            <translation>(hell − schwarz) / (hell + schwarz) der mittleren Bestrahlungsstärken dort; schwarz ist bis zu einem Hundertstel der Spitze des Ziels. 1 ist vollkommenes Schwarz.</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>Fraction of the emitted flux in the image.</source>
            <translation>Anteil des ausgesandten Flusses im Bild.</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>meets the face again</source>
            <translation>trifft die Fläche erneut</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>Flux that hits its exit face a second time, as in a deep concave face. Image and efficiency ignore this.</source>
            <translation>Fluss, der seine Austrittsfläche ein zweites Mal trifft, wie bei einer tief konkaven Fläche. Bild und Wirkungsgrad berücksichtigen das nicht.</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>comes through the screen</source>
            <translation>kommt durch den Schirm</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>Flux that the screen blocks before the mirror. Image and efficiency ignore this; a screen beside the axis does not block it.</source>
            <translation>Fluss, den der Schirm vor dem Spiegel abschattet. Bild und Wirkungsgrad berücksichtigen das nicht; ein Schirm neben der Achse schattet nicht ab.</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>difference to the optimiser</source>
            <translation>Abweichung vom Optimierer</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>Relative L2 difference to the image of the optimiser; includes its filter and ray noise.</source>
            <translation>Relative L2-Differenz zum Bild des Optimierers; enthält dessen Filter und Strahlrauschen.</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>Rays of the image; a quarter more are traced for the error without noise.</source>
            <translation>Strahlen des Bildes; ein Viertel mehr wird für den Fehler ohne Rauschen gerechnet.</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>correlation</source>
            <translation>Korrelation</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>uniformity</source>
            <translation>Gleichmäßigkeit</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>contrast</source>
            <translation>Kontrast</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>efficiency</source>
            <translation>Wirkungsgrad</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>rays</source>
            <translation>Strahlen</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>Relative L2 error as designed, and after each process of manufacture and those before it; the last one is that of the finished part.</source>
            <translation>Relativer L2-Fehler wie entworfen und nach jedem Prozess der Fertigung samt denen davor; der letzte ist der des fertigen Teils.</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>Fraction of the emitted flux on the area, and its light pixel by pixel. U₀ is minimum / average, U₁ minimum / maximum; 1 is uniform.</source>
            <translation>Anteil des ausgesandten Flusses auf dem Bereich, und dessen Licht Pixel für Pixel. U₀ ist Minimum / Mittelwert, U₁ Minimum / Maximum; 1 ist gleichmäßig.</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>Figures of the check</source>
            <translation>Zahlen der Prüfung</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>Copy</source>
            <translation>Kopieren</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>Rays of a check; four times as many halve the noise</source>
            <translation>Strahlen einer Prüfung; viermal so viele halbieren das Rauschen</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>Rays of a check</source>
            <translation>Strahlen einer Prüfung</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>Copy all figures to the clipboard, tab-separated</source>
            <translation>Alle Kennzahlen in die Zwischenablage kopieren, durch Tabulator getrennt</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>{rays} million rays</source>
            <translation>{rays} Mio. Strahlen</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>image {number}: {name}</source>
            <translation>Bild {number}: {name}</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>Outdated figures: the design has changed.</source>
            <translation>Veraltete Kennzahlen: der Entwurf hat sich geändert.</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>Checking…</source>
            <translation>Prüfung läuft …</translation>
        </message>
        <message>
            <location filename="../../ui/run/checks.py" />
            <source>check</source>
            <translation>Prüfung</translation>
        </message>
        <message>
            <location filename="../../ui/run/checks.py" />
            <source>The image is still being computed. Try again in a moment.</source>
            <translation>Das Bild wird noch berechnet. Gleich noch einmal versuchen.</translation>
        </message>
        <message>
            <location filename="../../ui/run/checks.py" />
            <source>Check with {rays:,} rays: relative L2 error {verified} ({low:.2f} to {high:.2f} %); with ray noise {relative_l2:.2f} ± {noise:.2f} %, loss {loss}; {efficiency:.1f} % {place}</source>
            <translation>Prüfung mit {rays:,} Strahlen: relativer L2-Fehler {verified} ({low:.2f} bis {high:.2f} %); mit Strahlrauschen {relative_l2:.2f} ± {noise:.2f} %, Verlust {loss}; {efficiency:.1f} % {place}</translation>
        </message>
        <message>
            <location filename="../../ui/run/checks.py" />
            <source>check of the result</source>
            <translation>Prüfung des Ergebnisses</translation>
        </message>
        <message>
            <location filename="../../ui/run/checks.py" />
            <source>Check of the result</source>
            <translation>Prüfung des Ergebnisses</translation>
        </message>
        <message>
            <location filename="../../ui/run/checks.py" />
            <source>bound</source>
            <translation>Schranke</translation>
        </message>
        <message>
            <location filename="../../ui/run/checks.py" />
            <source>Certified lower bound of the relative L2 error: {bound}; {error} with a source of half the width. Details: freeform bound.</source>
            <translation>Bewiesene untere Schranke des relativen L2-Fehlers: {bound}; {error} mit einer Quelle halber Breite. Einzelheiten: freeform bound.</translation>
        </message>
        <message>
            <location filename="../../ui/run/comparison.py" />
            <source>The scenes are the same</source>
            <translation>Die Szenen sind gleich</translation>
        </message>
        <message>
            <location filename="../../ui/run/comparison.py" />
            <source>Fields of the scenes that differ</source>
            <translation>Felder der Szenen, die sich unterscheiden</translation>
        </message>
        <message>
            <location filename="../../ui/run/comparison.py" />
            <source>Point at an image to read its irradiance</source>
            <translation>Auf ein Bild zeigen, um die Bestrahlungsstärke zu lesen</translation>
        </message>
        <message>
            <location filename="../../ui/run/comparison.py" />
            <source>Comparison of two runs</source>
            <translation>Vergleich zweier Läufe</translation>
        </message>
        <message>
            <location filename="../../ui/run/comparison.py" />
            <source>Image that is shown</source>
            <translation>Gezeigtes Bild</translation>
        </message>
        <message>
            <location filename="../../ui/run/comparison.py" />
            <source>Choose the image to compare</source>
            <translation>Zu vergleichendes Bild wählen</translation>
        </message>
        <message>
            <location filename="../../ui/run/comparison.py" />
            <source>Value under the pointer</source>
            <translation>Wert unter dem Zeiger</translation>
        </message>
        <message>
            <location filename="../../ui/run/comparison.py" />
            <source>Irradiance of both runs</source>
            <translation>Bestrahlungsstärke beider Läufe</translation>
        </message>
        <message>
            <location filename="../../ui/run/comparison.py" />
            <source>Figures of both runs</source>
            <translation>Zahlen beider Läufe</translation>
        </message>
        <message>
            <location filename="../../ui/run/control.py" />
            <source>run</source>
            <translation>Lauf</translation>
        </message>
        <message>
            <location filename="../../ui/run/control.py" />
            <source>return to iteration {number}</source>
            <translation>zurück zu Iteration {number}</translation>
        </message>
        <message>
            <location filename="../../ui/run/control.py" />
            <source>design run</source>
            <translation>Entwurfslauf</translation>
        </message>
        <message>
            <location filename="../../ui/run/control.py" />
            <source>There is no result yet, or it is still being computed. Try again in a moment.</source>
            <translation>Es gibt noch kein Ergebnis, oder es wird noch berechnet. Gleich noch einmal versuchen.</translation>
        </message>
        <message>
            <location filename="../../ui/run/control.py" />
            <source>the best lens so far, after {count} iterations</source>
            <translation>die bisher beste Linse, nach {count} Iterationen</translation>
        </message>
        <message>
            <location filename="../../ui/run/control.py" />
            <source>the best mirror so far, after {count} iterations</source>
            <translation>der bisher beste Spiegel, nach {count} Iterationen</translation>
        </message>
        <message>
            <location filename="../../ui/run/control.py" />
            <source>this lens, {origin}</source>
            <translation>diese Linse, {origin}</translation>
        </message>
        <message>
            <location filename="../../ui/run/control.py" />
            <source>this mirror, {origin}</source>
            <translation>dieser Spiegel, {origin}</translation>
        </message>
        <message>
            <location filename="../../ui/run/follow.py" />
            <source>Updating the lens</source>
            <translation>Linse wird aktualisiert</translation>
        </message>
        <message>
            <location filename="../../ui/run/follow.py" />
            <source>Updating the mirror</source>
            <translation>Spiegel wird aktualisiert</translation>
        </message>
        <message>
            <location filename="../../ui/run/follow.py" />
            <source>Updating the lens: slow task, edits are applied after a pause</source>
            <translation>Linse wird aktualisiert: langsame Aufgabe, Änderungen wirken nach einer Pause</translation>
        </message>
        <message>
            <location filename="../../ui/run/follow.py" />
            <source>Updating the mirror: slow task, edits are applied after a pause</source>
            <translation>Spiegel wird aktualisiert: langsame Aufgabe, Änderungen wirken nach einer Pause</translation>
        </message>
        <message>
            <location filename="../../ui/run/follow.py" />
            <source>live update</source>
            <translation>Live-Aktualisierung</translation>
        </message>
        <message>
            <location filename="../../ui/run/follow.py" />
            <source>design of the missing lens</source>
            <translation>Entwurf der fehlenden Linse</translation>
        </message>
        <message>
            <location filename="../../ui/run/follow.py" />
            <source>design of the missing mirror</source>
            <translation>Entwurf des fehlenden Spiegels</translation>
        </message>
        <message>
            <location filename="../../ui/run/kept_runs.py" />
            <source>Run {number}: {description}</source>
            <translation>Lauf {number}: {description}</translation>
        </message>
        <message>
            <location filename="../../ui/run/kept_runs.py" />
            <source>Live update {number}: {description}</source>
            <translation>Live-Aktualisierung {number}: {description}</translation>
        </message>
        <message>
            <location filename="../../ui/run/log.py" />
            <source>Run paused</source>
            <translation>Lauf angehalten</translation>
        </message>
        <message>
            <location filename="../../ui/run/log.py" />
            <source>Run resumed</source>
            <translation>Lauf fortgesetzt</translation>
        </message>
        <message>
            <location filename="../../ui/run/log.py" />
            <source>Stop requested</source>
            <translation>Stopp angefordert</translation>
        </message>
        <message>
            <location filename="../../ui/run/log.py" />
            <source>{name} was removed: memory limit of kept runs</source>
            <translation>{name} wurde entfernt: Speichergrenze der Läufe</translation>
        </message>
        <message>
            <location filename="../../ui/run/log.py" />
            <source>Run started: {name}, method {method}</source>
            <translation>Lauf gestartet: {name}, Verfahren {method}</translation>
        </message>
        <message>
            <location filename="../../ui/run/log.py" />
            <source> at iteration {iteration}</source>
            <translation> bei Iteration {iteration}</translation>
        </message>
        <message>
            <location filename="../../ui/run/log.py" />
            <source>Stage {stage} of {stages}, iteration {iteration}</source>
            <translation>Stufe {stage} von {stages}, Iteration {iteration}</translation>
        </message>
        <message>
            <location filename="../../ui/run/log.py" />
            <source>Trace: {notes}</source>
            <translation>Durchrechnung: {notes}</translation>
        </message>
        <message>
            <location filename="../../ui/run/log.py" />
            <source>Run ended without a lens</source>
            <translation>Lauf endete ohne Linse</translation>
        </message>
        <message>
            <location filename="../../ui/run/log.py" />
            <source>Run ended without a mirror</source>
            <translation>Lauf endete ohne Spiegel</translation>
        </message>
        <message>
            <location filename="../../ui/run/log.py" />
            <source>Run ended{why} after iteration {iteration} of {iterations}, {clock}: last loss {loss}, {efficiency:.1f} % {place}</source>
            <translation>Lauf beendet{why} nach Iteration {iteration} von {iterations}, {clock}: letzte Zielfunktion {loss}, {efficiency:.1f} % {place}</translation>
        </message>
        <message>
            <location filename="../../ui/run/runs.py" />
            <source>Select two runs in View &gt; Runs first (Ctrl+click).</source>
            <translation>Zuerst zwei Läufe in Ansicht &gt; Läufe wählen (Strg+Klick).</translation>
        </message>
        <message>
            <location filename="../../ui/run/runs.py" />
            <source>Select a run in View &gt; Runs first.</source>
            <translation>Zuerst in Ansicht &gt; Läufe einen Lauf wählen.</translation>
        </message>
        <message>
            <location filename="../../ui/run/runs.py" />
            <source>return to {name}</source>
            <translation>zurück zu {name}</translation>
        </message>
        <message>
            <location filename="../../ui/run/runs.py" />
            <source>Select runs in View &gt; Runs first.</source>
            <translation>Zuerst in Ansicht &gt; Läufe Läufe wählen.</translation>
        </message>
        <message>
            <location filename="../../ui/run/runs.py" />
            <source>delete {name}</source>
            <translation>{name} löschen</translation>
        </message>
        <message>
            <location filename="../../ui/run/runs.py" />
            <source>delete {count} runs</source>
            <translation>{count} Läufe löschen</translation>
        </message>
        <message>
            <location filename="../../ui/run/runs.py" />
            <source>rename run</source>
            <translation>Lauf umbenennen</translation>
        </message>
        <message>
            <location filename="../../ui/run/runs.py" />
            <source>The run was not renamed; it is still {name}: {reason}</source>
            <translation>Der Lauf heißt weiterhin {name}: {reason}</translation>
        </message>
        <message>
            <location filename="../../ui/run/status.py" />
            <source>iteration {done} of {count}{rate}</source>
            <translation>Iteration {done} von {count}{rate}</translation>
        </message>
        <message>
            <location filename="../../ui/run/status.py" />
            <source>at most {time} left</source>
            <translation>höchstens noch {time}</translation>
        </message>
        <message>
            <location filename="../../ui/run/status.py" />
            <source>Progress of the design</source>
            <translation>Fortschritt des Entwurfs</translation>
        </message>
        <message>
            <location filename="../../ui/run/status.py" />
            <source>Finished iterations, and the current rate</source>
            <translation>Erledigte Iterationen und ihre Rate</translation>
        </message>
        <message>
            <location filename="../../ui/run/status.py" />
            <source>Remaining time at the current rate; the automatic method ends sooner without further gain</source>
            <translation>Restzeit bei der jetzigen Rate; das automatische Verfahren endet früher, wenn nichts mehr besser wird</translation>
        </message>
        <message>
            <location filename="../../ui/run/status.py" />
            <source>{time} left</source>
            <translation>noch {time}</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Finished runs are listed here, to compare and restore them.</source>
            <translation>Fertige Läufe stehen hier, zum Vergleichen und Wiederherstellen.</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Name</source>
            <translation>Name</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Name and image of the run; tick it to plot its loss beside that of this run</source>
            <translation>Name und Bild des Laufs; ein Häkchen zeichnet seinen Verlust neben den dieses Laufs</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Target image: file or built-in shape</source>
            <translation>Zielbild: Datei oder eingebaute Form</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Error</source>
            <translation>Fehler</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Relative L2 error of the best result, as the optimiser computes it</source>
            <translation>Relativer L2-Fehler des besten Ergebnisses, wie der Optimierer ihn berechnet</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Verified</source>
            <translation>Geprüft</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Relative L2 error of the result, by the independent check</source>
            <translation>Relativer L2-Fehler des Ergebnisses, nach der unabhängigen Prüfung</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>On screen</source>
            <translation>Auf dem Schirm</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Fraction of the flux on the receiver</source>
            <translation>Anteil des Flusses auf dem Empfänger</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Time</source>
            <translation>Zeit</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Run time</source>
            <translation>Laufzeit</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Iterations, including those of continued runs</source>
            <translation>Iterationen, samt denen fortgesetzter Läufe</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Net</source>
            <translation>Netz</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Numbers of control points along x and y</source>
            <translation>Anzahl der Kontrollpunkte entlang x und y</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Method</source>
            <translation>Methode</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Design method</source>
            <translation>Entwurfsverfahren</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Loss of the best result</source>
            <translation>Verlust des besten Ergebnisses</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Ended</source>
            <translation>Ende</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Why the run ended</source>
            <translation>Warum der Lauf endete</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Kept runs</source>
            <translation>Aufbewahrte Läufe</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Delete</source>
            <translation>Löschen</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Compare irradiance, figures and fields of two selected runs</source>
            <translation>Bestrahlungsstärke, Kennzahlen und Felder zweier gewählter Läufe vergleichen</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Restore</source>
            <translation>Wiederherstellen</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Restore task and result of this run</source>
            <translation>Aufgabe und Ergebnis dieses Laufs wiederherstellen</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Delete the selected runs</source>
            <translation>Gewählte Läufe löschen</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Compare</source>
            <translation>Vergleichen</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Run of the current lens</source>
            <translation>Lauf der aktuellen Linse</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>A name has at most {count} characters</source>
            <translation>Ein Name hat höchstens {count} Zeichen</translation>
        </message>
        <message>
            <location filename="../../ui/unexpected_errors.py" />
            <source>Unexpected error: {error}. Save your work.</source>
            <translation>Unerwarteter Fehler: {error}. Bitte die Arbeit speichern.</translation>
        </message>
        <message>
            <location filename="../../ui/views/choices.py" />
            <source>Choose the image to show</source>
            <translation>Anzuzeigendes Bild wählen</translation>
        </message>
        <message>
            <location filename="../../ui/views/choices.py" />
            <source>Face</source>
            <translation>Fläche</translation>
        </message>
        <message>
            <location filename="../../ui/views/choices.py" />
            <source>Choose the freeform face</source>
            <translation>Freiformfläche wählen</translation>
        </message>
        <message>
            <location filename="../../ui/views/derivative_view.py" />
            <source>derivative map</source>
            <translation>Ableitungskarte</translation>
        </message>
        <message>
            <location filename="../../ui/views/derivative_view.py" />
            <source>Control point along {axis}</source>
            <translation>Kontrollpunkt entlang {axis}</translation>
        </message>
        <message>
            <location filename="../../ui/views/derivative_view.py" />
            <source>Number of the control point along {axis}, counted from 0</source>
            <translation>Nummer des Kontrollpunkts entlang {axis}, ab 0 gezählt</translation>
        </message>
        <message>
            <location filename="../../ui/views/derivative_view.py" />
            <source>, {part} of the total flux there</source>
            <translation>, {part} des gesamten Lichtstroms dort</translation>
        </message>
        <message>
            <location filename="../../ui/views/derivative_view.py" />
            <source>Sum: flux on the screen changes by {sum} per {unit}{part}</source>
            <translation>Summe: der Lichtstrom auf dem Schirm ändert sich um {sum} je {unit}{part}</translation>
        </message>
        <message>
            <location filename="../../ui/views/focus_view.py" />
            <source>trace through focus</source>
            <translation>Fokusreihe</translation>
        </message>
        <message>
            <location filename="../../ui/views/focus_view.py" />
            <source>Relative L2 error against the distance; the dotted line is the screen</source>
            <translation>Relativer L2-Fehler über dem Abstand; die gepunktete Linie ist der Schirm</translation>
        </message>
        <message>
            <location filename="../../ui/views/focus_view.py" />
            <source>A far field has no distance to vary.</source>
            <translation>Ein Fernfeld hat keinen Abstand, der sich ändern ließe.</translation>
        </message>
        <message>
            <location filename="../../ui/views/focus_view.py" />
            <source>Show the irradiance at 0.5 to 1.5 times the distance of the screen; the scene is unchanged</source>
            <translation>Bestrahlungsstärke beim 0,5- bis 1,5-Fachen des Schirmabstands zeigen; die Szene bleibt unverändert</translation>
        </message>
        <message>
            <location filename="../../ui/views/focus_view.py" />
            <source>Distance of the screen</source>
            <translation>Abstand des Schirms</translation>
        </message>
        <message>
            <location filename="../../ui/views/focus_view.py" />
            <source>Return to the distance of the screen</source>
            <translation>Zum Abstand des Schirms zurückkehren</translation>
        </message>
        <message>
            <location filename="../../ui/views/focus_view.py" />
            <source>At screen</source>
            <translation>Am Schirm</translation>
        </message>
        <message>
            <location filename="../../ui/views/focus_view.py" />
            <source>Curve</source>
            <translation>Kurve</translation>
        </message>
        <message>
            <location filename="../../ui/views/focus_view.py" />
            <source>Plot the error against the distance</source>
            <translation>Fehler über dem Abstand zeichnen</translation>
        </message>
        <message>
            <location filename="../../ui/views/focus_view.py" />
            <source>tracing…</source>
            <translation>Durchrechnung …</translation>
        </message>
        <message>
            <location filename="../../ui/views/focus_view.py" />
            <source>computed when the design rests…</source>
            <translation>wird berechnet, wenn der Entwurf ruht …</translation>
        </message>
        <message>
            <location filename="../../ui/views/focus_view.py" />
            <source>no flux arrives there</source>
            <translation>dort kommt kein Fluss an</translation>
        </message>
        <message>
            <location filename="../../ui/views/focus_view.py" />
            <source>screen</source>
            <translation>Schirm</translation>
        </message>
        <message>
            <location filename="../../ui/views/focus_view.py" />
            <source>Computed when the design rests.</source>
            <translation>Wird berechnet, wenn der Entwurf ruht.</translation>
        </message>
        <message>
            <location filename="../../ui/views/focus_view.py" />
            <source>{part:.1f} % of the light</source>
            <translation>{part:.1f} % des Lichts</translation>
        </message>
        <message>
            <location filename="../../ui/views/focus_view.py" />
            <source>error {error}, {light}</source>
            <translation>Fehler {error}, {light}</translation>
        </message>
        <message>
            <location filename="../../ui/views/image_view.py" />
            <source>outside the lens</source>
            <translation>neben der Linse</translation>
        </message>
        <message>
            <location filename="../../ui/views/image_view.py" />
            <source>outside the mirror</source>
            <translation>neben dem Spiegel</translation>
        </message>
        <message>
            <location filename="../../ui/views/image_view.py" />
            <source>{value} at {x}, {y}</source>
            <translation>{value} bei {x}, {y}</translation>
        </message>
        <message>
            <location filename="../../ui/views/light_images.py" />
            <source>Draw a line</source>
            <translation>Eine Linie ziehen</translation>
        </message>
        <message>
            <location filename="../../ui/views/light_images.py" />
            <source>Drag across an image to draw the line of a cross-section; or use Shift and drag</source>
            <translation>Über ein Bild ziehen, um die Linie eines Schnitts zu zeichnen; oder Umschalt und Ziehen</translation>
        </message>
        <message>
            <location filename="../../ui/views/light_images.py" />
            <source>Logarithmic colours</source>
            <translation>Logarithmische Farben</translation>
        </message>
        <message>
            <location filename="../../ui/views/light_images.py" />
            <source>Logarithmic colours over three decades, to see stray light</source>
            <translation>Logarithmische Farben über drei Dekaden, um Streulicht zu sehen</translation>
        </message>
        <message>
            <location filename="../../ui/views/light_images.py" />
            <source>Contours</source>
            <translation>Höhenlinien</translation>
        </message>
        <message>
            <location filename="../../ui/views/light_images.py" />
            <source>Lines of equal light, with their values</source>
            <translation>Linien gleicher Beleuchtung mit ihren Werten</translation>
        </message>
        <message>
            <location filename="../../ui/views/light_images.py" />
            <source>Pin this image</source>
            <translation>Dieses Bild anheften</translation>
        </message>
        <message>
            <location filename="../../ui/views/light_images.py" />
            <source>Pin this image to compare others with it; again to remove it</source>
            <translation>Dieses Bild anheften, um andere damit zu vergleichen; nochmals: entfernen</translation>
        </message>
        <message>
            <location filename="../../ui/views/light_images.py" />
            <source>Nothing is pinned. The pin below the image of light pins it.</source>
            <translation>Nichts ist angeheftet. Die Nadel unter dem Lichtbild heftet es an.</translation>
        </message>
        <message>
            <location filename="../../ui/views/light_images.py" />
            <source>Pinned at iteration {count}, error {error}</source>
            <translation>Angeheftet bei Iteration {count}, Fehler {error}</translation>
        </message>
        <message>
            <location filename="../../ui/views/light_images.py" />
            <source>The target, scaled to the flux that arrives: where the irradiance is right, both have the same colour. The light account shows where lost light goes.</source>
            <translation>Das Ziel, auf den ankommenden Fluss skaliert: wo die Bestrahlungsstärke stimmt, haben beide dieselbe Farbe. Die Lichtbilanz zeigt, wohin verlorenes Licht geht.</translation>
        </message>
        <message>
            <location filename="../../ui/views/light_view.py" />
            <source>All parts</source>
            <translation>Alle Teile</translation>
        </message>
        <message>
            <location filename="../../ui/views/light_view.py" />
            <source>Sum of all parts; 100 % when the account is complete.</source>
            <translation>Summe aller Teile; 100 %, wenn die Bilanz vollständig ist.</translation>
        </message>
        <message>
            <location filename="../../ui/views/loss_strip.py" />
            <source>Iteration of the run</source>
            <translation>Iteration des Laufs</translation>
        </message>
        <message>
            <location filename="../../ui/views/loss_strip.py" />
            <source>Iteration {number}: loss {loss}</source>
            <translation>Iteration {number}: Zielfunktion {loss}</translation>
        </message>
        <message>
            <location filename="../../ui/views/loss_strip.py" />
            <source>The loss of a run is plotted here. Run &gt; Start starts a run.</source>
            <translation>Der Verlust eines Laufs wird hier gezeichnet. Lauf &gt; Start startet einen Lauf.</translation>
        </message>
        <message>
            <location filename="../../ui/views/loss_strip.py" />
            <source>Loss that the optimiser minimises</source>
            <translation>Verlust, den der Optimierer minimiert</translation>
        </message>
        <message>
            <location filename="../../ui/views/loss_strip.py" />
            <source>Loss {loss}</source>
            <translation>Zielfunktion {loss}</translation>
        </message>
        <message>
            <location filename="../../ui/views/loss_strip.py" />
            <source>Restore the design of this iteration and continue from it; Undo restores the later one</source>
            <translation>Entwurf dieser Iteration wiederherstellen und von ihm fortsetzen; Rückgängig stellt den späteren wieder her</translation>
        </message>
        <message>
            <location filename="../../ui/views/loss_strip.py" />
            <source>Continue from here</source>
            <translation>Von hier fortsetzen</translation>
        </message>
        <message>
            <location filename="../../ui/views/loss_strip.py" />
            <source>Drag along the curve, or press arrows on it, to show an earlier iteration</source>
            <translation>Entlang der Kurve ziehen oder Pfeiltasten darauf drücken, um eine frühere Iteration zu zeigen</translation>
        </message>
        <message>
            <location filename="../../ui/views/loss_strip.py" />
            <source>iteration {number}</source>
            <translation>Iteration {number}</translation>
        </message>
        <message>
            <location filename="../../ui/views/photo_view.py" />
            <source>There is no lens yet. Start designs one.</source>
            <translation>Es gibt noch keine Linse: Start entwirft eine.</translation>
        </message>
        <message>
            <location filename="../../ui/views/photo_view.py" />
            <source>The photo is predicted when the design rests.</source>
            <translation>Das Foto wird vorhergesagt, sobald der Entwurf ruht.</translation>
        </message>
        <message>
            <location filename="../../ui/views/photo_view.py" />
            <source>photo prediction</source>
            <translation>Fotovorhersage</translation>
        </message>
        <message>
            <location filename="../../ui/views/photo_view.py" />
            <source>Predicting… {part:.0f} %</source>
            <translation>Vorhersage … {part:.0f} %</translation>
        </message>
        <message>
            <location filename="../../ui/views/photo_view.py" />
            <source>State of the photo</source>
            <translation>Zustand des Fotos</translation>
        </message>
        <message>
            <location filename="../../ui/views/photo_view.py" />
            <source>Light of the photo: that of the source (daylight for collimated light, a laser for a Gaussian beam, otherwise an LED), or another one</source>
            <translation>Licht des Fotos: das der Quelle (Tageslicht bei kollimiertem Licht, Laser bei Gauß-Strahl, sonst LED) oder ein anderes</translation>
        </message>
        <message>
            <location filename="../../ui/views/photo_view.py" />
            <source>Light of the source</source>
            <translation>Licht der Quelle</translation>
        </message>
        <message>
            <location filename="../../ui/views/photo_view.py" />
            <source>Light of the photo</source>
            <translation>Licht des Fotos</translation>
        </message>
        <message>
            <location filename="../../ui/views/photo_view.py" />
            <source>Exposure in stops; each stop doubles the brightness</source>
            <translation>Belichtung in Blendenstufen; jede Stufe verdoppelt die Helligkeit</translation>
        </message>
        <message>
            <location filename="../../ui/views/photo_view.py" />
            <source>Exposure</source>
            <translation>Belichtung</translation>
        </message>
        <message>
            <location filename="../../ui/views/photo_view.py" />
            <source>{number} stops</source>
            <translation>{number} Blenden</translation>
        </message>
        <message>
            <location filename="../../ui/views/photo_view.py" />
            <source>Default exposure: the target's brightest pixel is white</source>
            <translation>Standardbelichtung: der hellste Pixel des Ziels ist weiß</translation>
        </message>
        <message>
            <location filename="../../ui/views/photo_view.py" />
            <source>Default exposure</source>
            <translation>Standardbelichtung</translation>
        </message>
        <message>
            <location filename="../../ui/views/photo_view.py" />
            <source>Outdated. </source>
            <translation>Veraltet. </translation>
        </message>
        <message>
            <location filename="../../ui/views/plot_view.py" />
            <source>The image is being computed.</source>
            <translation>Das Bild wird berechnet.</translation>
        </message>
        <message>
            <location filename="../../ui/views/plot_view.py" />
            <source>Too little space for a plot.</source>
            <translation>Zu wenig Platz für ein Diagramm.</translation>
        </message>
        <message>
            <location filename="../../ui/views/plot_view.py" />
            <source>There is no image: this design cannot be traced.</source>
            <translation>Es gibt kein Bild: dieser Entwurf lässt sich nicht rechnen.</translation>
        </message>
        <message>
            <location filename="../../ui/views/region_tool.py" />
            <source>new region</source>
            <translation>neuer Ausschnitt</translation>
        </message>
        <message>
            <location filename="../../ui/views/region_tool.py" />
            <source>move of {region}</source>
            <translation>Verschieben von {region}</translation>
        </message>
        <message>
            <location filename="../../ui/views/scene_contents.py" />
            <source>Height</source>
            <translation>Höhe</translation>
        </message>
        <message>
            <location filename="../../ui/views/scene_contents.py" />
            <source>Mean curvature</source>
            <translation>Mittlere Krümmung</translation>
        </message>
        <message>
            <location filename="../../ui/views/scene_contents.py" />
            <source>within limits | exceeded</source>
            <translation>eingehalten | überschritten</translation>
        </message>
        <message>
            <location filename="../../ui/views/section_view.py" />
            <source>Along x</source>
            <translation>Entlang x</translation>
        </message>
        <message>
            <location filename="../../ui/views/section_view.py" />
            <source>Along y</source>
            <translation>Entlang y</translation>
        </message>
        <message>
            <location filename="../../ui/views/section_view.py" />
            <source>Along a line</source>
            <translation>Entlang einer Linie</translation>
        </message>
        <message>
            <location filename="../../ui/views/section_view.py" />
            <source>Cross-section along x or y through the point clicked in an image,
or along a line drawn with Shift and drag.
Arrow keys move the point or line by a pixel, with Shift by ten; with Ctrl the end of the line</source>
            <translation>Schnitt entlang x oder y durch den im Bild angeklickten Punkt
oder entlang einer mit Umschalt und Ziehen gezeichneten Linie.
Pfeiltasten bewegen Punkt oder Linie um einen Pixel, mit Umschalt um zehn; mit Strg das Ende der Linie</translation>
        </message>
        <message>
            <location filename="../../ui/views/section_view.py" />
            <source>Along</source>
            <translation>Entlang</translation>
        </message>
        <message>
            <location filename="../../ui/views/section_view.py" />
            <source>From {start} to {end} {unit}.
{tip}</source>
            <translation>Von {start} bis {end} {unit}.
{tip}</translation>
        </message>
        <message>
            <location filename="../../ui/views/surface_view.py" />
            <source>What the map shows</source>
            <translation>Was die Karte zeigt</translation>
        </message>
        <message>
            <location filename="../../ui/widgets/figures.py" />
            <source>× mean</source>
            <translation>× Mittel</translation>
        </message>
        <message>
            <location filename="../../ui/widgets/figures.py" />
            <source>{axis} at {place}</source>
            <translation>{axis} bei {place}</translation>
        </message>
        <message>
            <location filename="../../ui/widgets/labels.py" />
            <source>Outdated: the design has changed</source>
            <translation>Veraltet: der Entwurf hat sich geändert</translation>
        </message>
        <message>
            <location filename="../../ui/widgets/messages.py" />
            <source>Close this message</source>
            <translation>Diese Meldung schließen</translation>
        </message>
        <message>
            <location filename="../../ui/widgets/messages.py" />
            <source>Messages of runs, checks and exports appear here.</source>
            <translation>Hier stehen Meldungen von Läufen, Prüfungen und Exporten.</translation>
        </message>
        <message>
            <location filename="../../ui/widgets/shelf.py" />
            <source>Progress of {task}</source>
            <translation>Fortschritt: {task}</translation>
        </message>
        <message>
            <location filename="../../ui/widgets/shelf.py" />
            <source>Ends soon…</source>
            <translation>Endet gleich …</translation>
        </message>
        <message>
            <location filename="../../ui/widgets/shelf.py" />
            <source>Checks, exports, reports and sweeps in the background</source>
            <translation>Prüfungen, Exporte, Berichte und Reihen im Hintergrund</translation>
        </message>
        <message>
            <location filename="../../ui/widgets/shelf.py" />
            <source>Progress of the tasks</source>
            <translation>Fortschritt der Vorgänge</translation>
        </message>
        <message>
            <location filename="../../ui/widgets/shelf.py" />
            <source>Tasks</source>
            <translation>Vorgänge</translation>
        </message>
        <message>
            <location filename="../../ui/widgets/shelf.py" />
            <source>No tasks. Checks, exports, reports and sweeps appear here.</source>
            <translation>Keine Vorgänge. Prüfungen, Exporte, Berichte und Reihen erscheinen hier.</translation>
        </message>
        <message>
            <location filename="../../ui/widgets/shelf.py" />
            <source>Tasks ({count})</source>
            <translation>Vorgänge ({count})</translation>
        </message>
        <message>
            <location filename="../../ui/window/docks.py" />
            <source>As opened</source>
            <translation>Wie geöffnet</translation>
        </message>
        <message>
            <location filename="../../ui/window/docks.py" />
            <source>Click a step to restore it</source>
            <translation>Schritt anklicken, um ihn wiederherzustellen</translation>
        </message>
        <message>
            <location filename="../../ui/window/docks.py" />
            <source>Loading…</source>
            <translation>Lädt …</translation>
        </message>
        <message>
            <location filename="../../ui/window/docks.py" />
            <source>The run waits for the compilation of its kernels (once after installation, half a minute)</source>
            <translation>Der Lauf wartet auf das Übersetzen seiner Kernel (einmal nach der Installation, eine halbe Minute)</translation>
        </message>
        <message>
            <location filename="../../ui/window/edit_notices.py" />
            <source>The lens does not fit the new outline. Start designs another one; Undo restores it.</source>
            <translation>Die Linse passt nicht zum neuen Umriss. Start entwirft eine andere; Rückgängig stellt sie wieder her.</translation>
        </message>
        <message>
            <location filename="../../ui/window/edit_notices.py" />
            <source>The mirror does not fit the new outline. Start designs another one; Undo restores it.</source>
            <translation>Der Spiegel passt nicht zum neuen Umriss. Start entwirft einen anderen; Rückgängig stellt ihn wieder her.</translation>
        </message>
        <message>
            <location filename="../../ui/window/edit_notices.py" />
            <source>The entrance face is freeform now, and still flat. Continue shapes both faces; Undo reverts.</source>
            <translation>Die Eintrittsfläche ist jetzt eine Freiformfläche und noch eben. Fortsetzen formt beide Flächen; Rückgängig nimmt es zurück.</translation>
        </message>
        <message>
            <location filename="../../ui/window/edit_notices.py" />
            <source>The entrance face is flat now; the exit face is unchanged. Continue reshapes the exit face; Undo reverts.</source>
            <translation>Die Eintrittsfläche ist jetzt eben; die Austrittsfläche ist unverändert. Fortsetzen formt die Austrittsfläche neu; Rückgängig nimmt es zurück.</translation>
        </message>
        <message>
            <location filename="../../ui/window/edit_notices.py" />
            <source>The lens was moved by up to {moved} to keep the new limits. Continue improves it; Undo reverts.</source>
            <translation>Die Linse wurde um bis zu {moved} geändert, um die neuen Grenzen einzuhalten. Fortsetzen verbessert sie; Rückgängig nimmt es zurück.</translation>
        </message>
        <message>
            <location filename="../../ui/window/edit_notices.py" />
            <source>The mirror was moved by up to {moved} to keep the new limits. Continue improves it; Undo reverts.</source>
            <translation>Der Spiegel wurde um bis zu {moved} geändert, um die neuen Grenzen einzuhalten. Fortsetzen verbessert ihn; Rückgängig nimmt es zurück.</translation>
        </message>
        <message>
            <location filename="../../ui/window/edit_notices.py" />
            <source>The net now has {size} control points; the lens was transferred to it. Continue improves it; Undo reverts.</source>
            <translation>Das Netz hat jetzt {size} Kontrollpunkte; die Linse wurde darauf übertragen. Fortsetzen verbessert sie; Rückgängig nimmt es zurück.</translation>
        </message>
        <message>
            <location filename="../../ui/window/edit_notices.py" />
            <source>The net now has {size} control points; the mirror was transferred to it. Continue improves it; Undo reverts.</source>
            <translation>Das Netz hat jetzt {size} Kontrollpunkte; der Spiegel wurde darauf übertragen. Fortsetzen verbessert ihn; Rückgängig nimmt es zurück.</translation>
        </message>
        <message>
            <location filename="../../ui/window/edit_notices.py" />
            <source>The lens was designed for another task. Continue starts from it; Start over does not</source>
            <translation>Die Linse wurde für eine andere Aufgabe entworfen. Fortsetzen geht von ihr aus; Neu starten nicht</translation>
        </message>
        <message>
            <location filename="../../ui/window/edit_notices.py" />
            <source>The mirror was designed for another task. Continue starts from it; Start over does not</source>
            <translation>Der Spiegel wurde für eine andere Aufgabe entworfen. Fortsetzen geht von ihm aus; Neu starten nicht</translation>
        </message>
        <message>
            <location filename="../../ui/window/edit_notices.py" />
            <source>Not possible during a run. Stop it first</source>
            <translation>Während eines Laufs nicht möglich. Zuerst anhalten</translation>
        </message>
        <message>
            <location filename="../../ui/window/edit_notices.py" />
            <source> ({count} more refused)</source>
            <translation> ({count} weitere abgelehnt)</translation>
        </message>
        <message>
            <location filename="../../ui/window/edit_notices.py" />
            <source>{first}{others}. Correct it, or press Esc.</source>
            <translation>{first}{others}. Bitte korrigieren oder Esc drücken.</translation>
        </message>
        <message>
            <location filename="../../ui/window/edit_notices.py" />
            <source>Stop and apply</source>
            <translation>Stoppen und anwenden</translation>
        </message>
        <message>
            <location filename="../../ui/window/edit_notices.py" />
            <source>Discard</source>
            <translation>Verwerfen</translation>
        </message>
        <message>
            <location filename="../../ui/window/edit_notices.py" />
            <source>{name} is unchanged on {size} control points.</source>
            <translation>{name} bleibt auf {size} Kontrollpunkten unverändert.</translation>
        </message>
        <message>
            <location filename="../../ui/window/edit_notices.py" />
            <source>Use {size}, exact</source>
            <translation>{size} verwenden, exakt</translation>
        </message>
        <message>
            <location filename="../../ui/window/edit_notices.py" />
            <source>{name} is approximated on {size} control points: deviation up to {off}. Continue improves it; Undo reverts.</source>
            <translation>{name} wird auf {size} Kontrollpunkten angenähert: Abweichung bis {off}. Fortsetzen verbessert; Rückgängig nimmt es zurück.</translation>
        </message>
        <message>
            <location filename="../../ui/window/edit_notices.py" />
            <source>control points</source>
            <translation>Kontrollpunkte</translation>
        </message>
        <message>
            <location filename="../../ui/window/edit_notices.py" />
            <source>The lens</source>
            <translation>Die Linse</translation>
        </message>
        <message>
            <location filename="../../ui/window/edit_notices.py" />
            <source>The mirror</source>
            <translation>Der Spiegel</translation>
        </message>
        <message>
            <location filename="../../ui/window/edit_notices.py" />
            <source>The entrance face</source>
            <translation>Die Eintrittsfläche</translation>
        </message>
        <message>
            <location filename="../../ui/window/edit_notices.py" />
            <source>{image} has changed on disk. The design keeps the earlier picture.</source>
            <translation>{image} hat sich auf der Platte geändert. Der Entwurf behält das frühere Bild.</translation>
        </message>
        <message>
            <location filename="../../ui/window/edit_notices.py" />
            <source>Reload</source>
            <translation>Neu laden</translation>
        </message>
        <message>
            <location filename="../../ui/window/edit_notices.py" />
            <source>All lengths were converted: 1 {old} = {ratio:.6g} {new}.</source>
            <translation>Alle Längen wurden umgerechnet: 1 {old} = {ratio:.6g} {new}.</translation>
        </message>
        <message>
            <location filename="../../ui/window/edit_notices.py" />
            <source>Keep the numbers</source>
            <translation>Zahlen beibehalten</translation>
        </message>
        <message>
            <location filename="../../ui/window/edit_notices.py" />
            <source>change of unit alone</source>
            <translation>nur die Einheit ändern</translation>
        </message>
        <message>
            <location filename="../../ui/window/image_panel.py" />
            <source>Show a second image; drag the handle between them, or press arrows on it</source>
            <translation>Ein zweites Bild zeigen; den Griff dazwischen ziehen oder mit Pfeiltasten bewegen</translation>
        </message>
        <message>
            <location filename="../../ui/window/image_panel.py" />
            <source>More images</source>
            <translation>Weitere Bilder</translation>
        </message>
        <message>
            <location filename="../../ui/window/image_panel.py" />
            <source>Compare: {image}</source>
            <translation>Vergleich: {image}</translation>
        </message>
        <message>
            <location filename="../../ui/window/image_panel.py" />
            <source>Image</source>
            <translation>Bild</translation>
        </message>
        <message>
            <location filename="../../ui/window/image_panel.py" />
            <source>Handle between two images</source>
            <translation>Griff zwischen zwei Bildern</translation>
        </message>
        <message>
            <location filename="../../ui/window/layouts.py" />
            <source>Save layout</source>
            <translation>Anordnung speichern</translation>
        </message>
        <message>
            <location filename="../../ui/window/layouts.py" />
            <source>Name; an existing one is replaced</source>
            <translation>Name; ein vorhandener wird ersetzt</translation>
        </message>
        <message>
            <location filename="../../ui/window/layouts.py" />
            <source>Delete layout</source>
            <translation>Anordnung löschen</translation>
        </message>
        <message>
            <location filename="../../ui/window/layouts.py" />
            <source>Layout</source>
            <translation>Anordnung</translation>
        </message>
        <message>
            <location filename="../../ui/window/loaded_parts.py" />
            <source>Stop the run first, then mark regions.</source>
            <translation>Erst den Lauf anhalten, dann Ausschnitte markieren.</translation>
        </message>
        <message>
            <location filename="../../ui/window/loaded_parts.py" />
            <source>Edit {part} in the form</source>
            <translation>{part} im Formular bearbeiten</translation>
        </message>
        <message>
            <location filename="../../ui/window/loaded_parts.py" />
            <source>Cancel &amp;check</source>
            <translation>Prüfung abb&amp;rechen</translation>
        </message>
        <message>
            <location filename="../../ui/window/window_state.py" />
            <source>There is only one freeform face; Freeform entrance face adds a second one</source>
            <translation>Es gibt eine Freiformfläche: „Freiform-Eintrittsfläche“ gibt einer Linse eine zweite</translation>
        </message>
        <message>
            <location filename="../../ui/window/window_state.py" />
            <source>Flat &amp;entrance face</source>
            <translation>&amp;Ebene Eintrittsfläche</translation>
        </message>
        <message>
            <location filename="../../ui/window/window_state.py" />
            <source>Freeform &amp;entrance face</source>
            <translation>Fr&amp;eiform-Eintrittsfläche</translation>
        </message>
        <message>
            <location filename="../../ui/window/window_state.py" />
            <source>&amp;Start over</source>
            <translation>&amp;Neu starten</translation>
        </message>
        <message>
            <location filename="../../ui/window/window_state.py" />
            <source>&amp;Resume</source>
            <translation>&amp;Weiter</translation>
        </message>
        <message>
            <location filename="../../ui/window/window_state.py" />
            <source>There is no lens yet; Start designs one</source>
            <translation>Es gibt noch keine Linse: Start entwirft eine</translation>
        </message>
        <message>
            <location filename="../../ui/window/window_state.py" />
            <source>There is no mirror yet; Start designs one</source>
            <translation>Es gibt noch keinen Spiegel: Start entwirft einen</translation>
        </message>
        <message>
            <location filename="../../ui/window/window_state.py" />
            <source>the best lens so far</source>
            <translation>die bisher beste Linse</translation>
        </message>
        <message>
            <location filename="../../ui/window/window_state.py" />
            <source>the best mirror so far</source>
            <translation>der bisher beste Spiegel</translation>
        </message>
        <message>
            <location filename="../../ui/window/window_state.py" />
            <source>Uses {lens}</source>
            <translation>Verwendet: {lens}</translation>
        </message>
        <message>
            <location filename="../../ui/window/window_state.py" />
            <source>A lens has one freeform face</source>
            <translation>Eine Linse hat eine Freiformfläche</translation>
        </message>
        <message>
            <location filename="../../ui/window/window_state.py" />
            <source>A mirror has one freeform face</source>
            <translation>Ein Spiegel hat eine Freiformfläche</translation>
        </message>
        <message>
            <location filename="../../ui/window/window_state.py" />
            <source>Ready</source>
            <translation>Bereit</translation>
        </message>
        <message>
            <location filename="../../ui/window/window_state.py" />
            <source>Designing…</source>
            <translation>Entwurf läuft …</translation>
        </message>
        <message>
            <location filename="../../ui/window/window_state.py" />
            <source>Paused</source>
            <translation>Angehalten</translation>
        </message>
        <message>
            <location filename="../../ui/window/window_state.py" />
            <source>Stopping…</source>
            <translation>Wird gestoppt …</translation>
        </message>
        <message>
            <location filename="../../ui/window/window_state.py" />
            <source>&amp;Undo {undo}</source>
            <translation>&amp;Rückgängig: {undo}</translation>
        </message>
        <message>
            <location filename="../../ui/window/window_state.py" />
            <source>&amp;Redo {redo}</source>
            <translation>&amp;Wiederherstellen: {redo}</translation>
        </message>
        <message>
            <location filename="../../ui/window/window_state.py" />
            <source>Done: no further gain</source>
            <translation>Fertig: kein weiterer Gewinn</translation>
        </message>
        <message>
            <location filename="../../ui/window/window_state.py" />
            <source>Stopped; {command} ({keys}) improves the lens</source>
            <translation>Angehalten; {command} ({keys}) verbessert die Linse</translation>
        </message>
        <message>
            <location filename="../../ui/window/window_state.py" />
            <source>Stopped; {command} ({keys}) improves the mirror</source>
            <translation>Angehalten; {command} ({keys}) verbessert den Spiegel</translation>
        </message>
        <message>
            <location filename="../../ui/window/workspaces.py" />
            <source>The view settings ({what}) of this design cannot be restored: {error}</source>
            <translation>Die Ansicht ({what}) dieses Entwurfs lässt sich nicht wiederherstellen: {error}</translation>
        </message>
        <message>
            <location filename="../../ui/windows.py" />
            <source>start</source>
            <translation>Start</translation>
        </message>
        <message>
            <location filename="../../ui/windows.py" />
            <source>{name} is open with the recovered changes.</source>
            <translation>{name} ist mit den wiederhergestellten Änderungen geöffnet.</translation>
        </message>
        <message>
            <location filename="../../ui/windows.py" />
            <source>Copy details</source>
            <translation>Einzelheiten kopieren</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>First lenses</source>
            <translation>Erste Linsen</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Top hat</source>
            <translation>Zylinder (Top Hat)</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>A uniform disc of light; see how soon its edge is sharp.</source>
            <translation>Eine gleichmäßige Lichtscheibe; zu sehen ist, wie bald ihr Rand scharf wird.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Flame</source>
            <translation>Flamme</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>A flame-like logo on black; see light leave what shall be dark.</source>
            <translation>Ein flammenähnliches Logo auf Schwarz; zu sehen ist, wie das Licht verlässt, was dunkel sein soll.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Ball</source>
            <translation>Ball</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>A faceted ball; see whether each grey comes out evenly bright.</source>
            <translation>Ein Ball aus Facetten; zu sehen ist, ob jedes Grau gleichmäßig hell wird.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Photograph</source>
            <translation>Fotografie</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Every grey from black to white; see texture and shadow come.</source>
            <translation>Alle Grautöne von Schwarz bis Weiß; zu sehen ist, wie Struktur und Schatten entstehen.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Letter</source>
            <translation>Buchstabe</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>A bold letter on black; see its straight edges and corners.</source>
            <translation>Ein fetter Buchstabe auf Schwarz; zu beachten sind seine geraden Kanten und Ecken.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>First lenses, twice as fine</source>
            <translation>Erste Linsen, doppelt so fein</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Flame, 512 × 512</source>
            <translation>Flamme, 512 × 512</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>The flame with four times the detail; see its thin parts.</source>
            <translation>Die Flamme mit viermal so vielen Einzelheiten; zu beachten sind ihre dünnen Teile.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Ball, 512 × 512</source>
            <translation>Ball, 512 × 512</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>The ball with four times the detail; see the facets' edges.</source>
            <translation>Der Ball mit viermal so vielen Einzelheiten; zu beachten sind die Kanten der Facetten.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Top hat: networks and starts</source>
            <translation>Zylinder: Netzwerke und Startwerte</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>No network, flat start</source>
            <translation>Kein Netzwerk, ebener Start</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>The yardstick for the three networks: a smooth lens that keeps the target's symmetry.</source>
            <translation>Der Maßstab für die drei Netzwerke: eine glatte Linse mit der Symmetrie des Ziels.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Sparse network, faint start</source>
            <translation>Dünn besetztes Netzwerk, schwacher Start</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Weights a ten-thousandth off zero; compare speed and symmetry with no network.</source>
            <translation>Gewichte um ein Zehntausendstel neben null; Tempo und Symmetrie mit „kein Netzwerk“ vergleichen.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Sparse network, random start</source>
            <translation>Dünn besetztes Netzwerk, zufälliger Start</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>A rough initial lens; see how much of its roughness remains at the end.</source>
            <translation>Eine raue Ausgangslinse; zu sehen ist, wie viel Rauheit am Ende bleibt.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Dense network, faint start</source>
            <translation>Vollbesetztes Netzwerk, schwacher Start</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Two million weights for a thousand heights; compare loss and time with the sparse one.</source>
            <translation>Zwei Millionen Gewichte für tausend Höhen; Zielfunktion und Zeit mit dem dünn besetzten vergleichen.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Real lights</source>
            <translation>Wirkliche Lichtquellen</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Sun plate</source>
            <translation>Sonnenplatte</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Acrylic to hold into the sun, whose disc blurs by 4.7 mm: compare error and bound.</source>
            <translation>Acrylglas für die Sonne, deren Scheibe um 4.7 mm unscharf macht: Fehler und Schranke vergleichen.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Phone torch</source>
            <translation>Handy-Taschenlampe</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>The LED of a telephone, close to the lens, blurs the letter's edges.</source>
            <translation>Die LED eines Telefons, nahe der Linse, macht die Kanten unscharf.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>LED to a rectangle</source>
            <translation>LED auf ein Rechteck</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Light as wide as can be bent; see what is totally reflected, and how even the rest is.</source>
            <translation>Licht so weit, wie es sich ablenken lässt; zu beachten: die Totalreflexion und wie gleichmäßig der Rest ist.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Beam shaper</source>
            <translation>Strahlformer</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>A Gaussian laser beam becomes an even disc; see that hardly any light is lost.</source>
            <translation>Ein Gaußscher Laserstrahl wird zur gleichmäßigen Scheibe; kaum Licht geht verloren.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Measured LED</source>
            <translation>Gemessene LED</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>A file of 9,000 rays lights the lens; see how their grain shows in the check.</source>
            <translation>Eine Datei mit 9 000 Strahlen beleuchtet die Linse; ihr Korn zeigt sich in der Prüfung.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>White light</source>
            <translation>Weißes Licht</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Polycarbonate turns blue light more than red; see coloured edges in the predicted photo.</source>
            <translation>Polycarbonat lenkt blaues Licht stärker ab als rotes; siehe farbige Ränder im vorhergesagten Foto.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Flame and ball: magnifications</source>
            <translation>Flamme und Ball: Vergrößerungen</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Flame, magnification 1</source>
            <translation>Flamme, Vergrößerung 1</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>A screen as large as the lens, far away: a few hundredths of height do it all.</source>
            <translation>Ein Schirm so groß wie die Linse, weit entfernt: wenige Hundertstel Höhe genügen.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Flame, magnification 3</source>
            <translation>Flamme, Vergrößerung 3</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>The concave base just fills the screen; see the corners, where rays are steep.</source>
            <translation>Die konkave Grundform füllt den Schirm gerade; die Ecken beachten, wo Strahlen steil sind.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Flame, magnification 5</source>
            <translation>Flamme, Vergrößerung 5</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Steeper still: compare the loss, and the light beside the screen, with 1 and 3.</source>
            <translation>Noch steiler: Zielfunktion und Licht neben dem Schirm mit 1 und 3 vergleichen.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Ball, magnification 1</source>
            <translation>Ball, Vergrößerung 1</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Ball, magnification 3</source>
            <translation>Ball, Vergrößerung 3</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Ball, magnification 5</source>
            <translation>Ball, Vergrößerung 5</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Flame: point and extended source</source>
            <translation>Flamme: punktförmige und ausgedehnte Quelle</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Point source</source>
            <translation>Punktquelle</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Light from one point; see in the light account how much of the cone passes the square lens by.</source>
            <translation>Licht von einem Punkt; die Lichtbilanz zeigt, wie viel vom Kegel die quadratische Linse verfehlt.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Extended source of 25 × 25 points</source>
            <translation>Ausgedehnte Quelle aus 25 × 25 Punkten</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>The flame is put together from images of the square source: details smaller than these stay blurred.</source>
            <translation>Die Flamme setzt sich aus Bildern der quadratischen Quelle zusammen: kleinere Einzelheiten bleiben unscharf.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Point source, then the extended one</source>
            <translation>Punktquelle, dann die ausgedehnte</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>The loss jumps when the extended source takes over at iteration 200; see what is won back.</source>
            <translation>Die Zielfunktion springt, wenn bei Iteration 200 die ausgedehnte Quelle übernimmt; zu sehen ist, was zurückgewonnen wird.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Walls and streets</source>
            <translation>Wände und Straßen</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Wall washer</source>
            <translation>Wandfluter</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>A picture on a wall that leans away from the lamp; see that it comes out straight.</source>
            <translation>Ein Bild auf einer Wand, die sich von der Lampe wegneigt; es erscheint gerade.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Street light</source>
            <translation>Straßenleuchte</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>An LED's IES file; see intensity rise to both ends, so that the road below is even.</source>
            <translation>Die IES-Datei einer LED; die Strahlstärke steigt zu beiden Enden, damit die Straße gleichmäßig hell wird.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Mirror: letter on a wall</source>
            <translation>Spiegel: Buchstabe auf einer Wand</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Sunlight from below, thrown back to a wall beside it; see the mirror lean towards it.</source>
            <translation>Sonnenlicht von unten, auf eine Wand daneben geworfen; der Spiegel neigt sich zu ihr.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Mirror: photograph beside the lamp</source>
            <translation>Spiegel: Fotografie neben der Lampe</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Light from one point, drawn on a screen beside that point; see what misses the mirror.</source>
            <translation>Licht von einem Punkt, auf einen Schirm daneben gezeichnet; zu beachten, was den Spiegel verfehlt.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Two freeform faces</source>
            <translation>Zwei Freiformflächen</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Photograph from a thin plate</source>
            <translation>Fotografie mit einer dünnen Platte</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Both faces bend the light; compare their slopes with those of one face alone.</source>
            <translation>Beide Flächen lenken das Licht ab; ihre Neigungen mit denen einer Fläche vergleichen.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Wide angle: disc from a near point</source>
            <translation>Weitwinkel: Scheibe aus einem nahen Punkt</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Light comes in at up to 60°; see how little of what is in the glass leaves by the side.</source>
            <translation>Licht kommt mit bis zu 60° an; kaum etwas davon verlässt das Glas durch die Seite.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>LED close by: square through a dome</source>
            <translation>Nahe LED: Quadrat durch eine Kuppel</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>The entrance face comes towards the LED in its middle; compare with a flat one.</source>
            <translation>Die Eintrittsfläche wölbt sich zur LED; mit einer ebenen vergleichen.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Photograph at two distances</source>
            <translation>Fotografie in zwei Abständen</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Thick glass moves the light, its exit face makes it parallel; compare both images.</source>
            <translation>Dickes Glas verschiebt das Licht, die Austrittsfläche richtet es parallel; beide Bilder vergleichen.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Several elements</source>
            <translation>Mehrere Elemente</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>LED with dome, freeform lens and cover plate</source>
            <translation>LED mit Dom, Freiformlinse und Deckplatte</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>The lens is designed with the dome before it and the plate behind it; see the rays.</source>
            <translation>Die Linse wird mit dem Dom davor und der Platte dahinter entworfen; siehe die Strahlen.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Collimated LED and freeform plate</source>
            <translation>Kollimierte LED und Freiformplatte</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>A stock lens makes the light parallel, a thin plate forms the letter; see its soft edges.</source>
            <translation>Eine Kaufteillinse kollimiert das Licht, eine dünne Platte formt den Buchstaben; siehe seine weichen Kanten.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Wide photograph by one lens</source>
            <translation>Breites Foto mit einer Linse</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>One face bends light by up to 47°; see in the light account what is reflected.</source>
            <translation>Eine Fläche lenkt das Licht um bis zu 47° ab; die Lichtbilanz zeigt, was reflektiert wird.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Wide photograph by two lenses</source>
            <translation>Breites Foto mit zwei Linsen</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Each lens bends light by about half; compare error and light account with one lens.</source>
            <translation>Jede Linse lenkt das Licht etwa zur Hälfte ab; Fehler und Lichtbilanz mit einer Linse vergleichen.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Diffuser before the screen</source>
            <translation>Diffusor vor dem Schirm</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>A film 4 mm before the screen blurs the letter; see the lens sharpen what the film blurs.</source>
            <translation>Eine Folie 4 mm vor dem Schirm macht den Buchstaben unscharf; siehe, wie die Linse vorschärft.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Diffuser behind the lens</source>
            <translation>Diffusor hinter der Linse</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>A film that scatters by 0.3° blurs over 1 mm at the screen; compare with the photograph.</source>
            <translation>Eine um 0.3° streuende Folie verwischt am Schirm über 1 mm; mit dem Foto vergleichen.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Fold mirror</source>
            <translation>Umlenkspiegel</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>A plane mirror turns the light by 90° before the freeform lens; see the folded axis.</source>
            <translation>Ein Planspiegel lenkt das Licht vor der Freiformlinse um 90° um; siehe die gefaltete Achse.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Mirror and lens</source>
            <translation>Spiegel und Linse</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>The mirror is designed for the light behind a stock lens; see where the rays cross it.</source>
            <translation>Der Spiegel ist für das Licht hinter einer Kaufteillinse entworfen; siehe, wo die Strahlen sie durchlaufen.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Tilted lens</source>
            <translation>Verkippte Linse</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>The lens is tilted and shifted, and is designed as it stands; see the image come out straight.</source>
            <translation>Die Linse ist verkippt und verschoben und wird in dieser Lage entworfen; das Bild bleibt gerade.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Derivative maps of a flat lens</source>
            <translation>Ableitungskarten einer ebenen Linse</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Degrees (3, 3), filter 3 × 3</source>
            <translation>Grade (3, 3), Filter 3 × 3</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>As a control point rises it gathers light: a mountain in a valley, sum zero.</source>
            <translation>Steigt ein Kontrollpunkt, sammelt er Licht: ein Berg in einem Tal, Summe null.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Degrees (3, 3), filter 11 × 11</source>
            <translation>Grade (3, 3), Filter 11 × 11</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>The same mountain, smoother: each ray's light is spread over 11 × 11 pixels.</source>
            <translation>Derselbe Berg, glatter: das Licht jedes Strahls verteilt sich auf 11 × 11 Pixel.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Degrees (5, 3), filter 3 × 3</source>
            <translation>Grade (5, 3), Filter 3 × 3</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Wider along x: the valley meets the screen's border, and the sum leaves zero.</source>
            <translation>Breiter entlang x: das Tal erreicht den Rand des Schirms, und die Summe ist nicht mehr null.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>lens</source>
            <translation>Linse</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>exit face</source>
            <translation>Austrittsfläche</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>entrance face</source>
            <translation>Eintrittsfläche</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>mirror</source>
            <translation>Spiegel</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>on the screen</source>
            <translation>auf dem Schirm</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>irradiance</source>
            <translation>Bestrahlungsstärke</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>On the screen</source>
            <translation>Auf dem Schirm</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Light that makes the image.</source>
            <translation>Licht, das das Bild macht.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Missed the screen</source>
            <translation>Am Schirm vorbei</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Light that leaves the last element and misses the screen. Much of it means that the designed faces cannot deflect all light to the image.</source>
            <translation>Licht, das das letzte Element verlässt und den Schirm verfehlt. Ist es viel, so können die entworfenen Flächen nicht alles Licht zum Bild ablenken.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Missed the lens</source>
            <translation>An der Linse vorbei</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Light that passes the entrance face by. The cone of a point source is round and just covers the rectangle around the face; of that, an elliptic lens leaves the corners open.</source>
            <translation>Licht, das an der Eintrittsfläche vorbeigeht. Der Kegel einer Punktquelle ist rund und deckt gerade das Rechteck um die Fläche; eine elliptische Linse lässt davon die Ecken frei.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Out of the side</source>
            <translation>Aus der Seite</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Light that entered the lens so slanted that it meets a side wall before the exit face.</source>
            <translation>Licht, das so schräg in die Linse trat, dass es vor der Austrittsfläche eine Seitenwand trifft.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Totally reflected</source>
            <translation>Totalreflektiert</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Light that meets the exit face too steeply to leave the lens there.</source>
            <translation>Licht, das die Austrittsfläche zu steil trifft, um die Linse dort zu verlassen.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Reflected on entry</source>
            <translation>Beim Eintritt reflektiert</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>The part that the entrance face reflects of the light that it refracts.</source>
            <translation>Der Teil, den die Eintrittsfläche von dem Licht reflektiert, das sie bricht.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Reflected on exit</source>
            <translation>Beim Austritt reflektiert</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>The part that the exit face reflects of the light that it refracts.</source>
            <translation>Der Teil, den die Austrittsfläche von dem Licht reflektiert, das sie bricht.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Absorbed</source>
            <translation>Absorbiert</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>The part that the glass absorbs of the light that comes to the exit face.</source>
            <translation>Der Teil, den das Glas von dem Licht absorbiert, das zur Austrittsfläche kommt.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Missed the mirror</source>
            <translation>Am Spiegel vorbei</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Light that passes the mirror by: between it and the rim of the light's cone, and through the corners of the rectangle around an elliptic mirror.</source>
            <translation>Licht, das am Spiegel vorbeigeht: zwischen ihm und dem Rand des Lichtkegels und durch die Ecken des Rechtecks um einen elliptischen Spiegel.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Absorbed by the mirror</source>
            <translation>Vom Spiegel absorbiert</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>The part of the light on the mirror that it does not reflect.</source>
            <translation>Der Teil des Lichts auf dem Spiegel, den er nicht reflektiert.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Missed the diffuser</source>
            <translation>Am Diffusor vorbei</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Light that passes the diffuser by.</source>
            <translation>Licht, das den Diffusor verfehlt.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Absorbed by the diffuser</source>
            <translation>Vom Diffusor absorbiert</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>The part of the light on the diffuser that does not go on behind it.</source>
            <translation>Der Teil des Lichts auf dem Diffusor, der dahinter nicht weiterläuft.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>far field</source>
            <translation>Fernfeld</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>in the far field</source>
            <translation>im Fernfeld</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>intensity</source>
            <translation>Strahlstärke</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Intensity</source>
            <translation>Strahlstärke</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>In the far field</source>
            <translation>Im Fernfeld</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Missed the far field</source>
            <translation>Am Fernfeld vorbei</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Light that leaves the last element and misses the far field. Much of it means that the designed faces cannot deflect all light to the image.</source>
            <translation>Licht, das das letzte Element verlässt und das Fernfeld verfehlt. Ist es viel, so können die entworfenen Flächen nicht alles Licht zum Bild ablenken.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Unit</source>
            <translation>Einheit</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Unit of every length in the scene. Another one converts them all: a lens of 1 cm becomes one of 10 mm.</source>
            <translation>Einheit aller Längen der Szene. Eine andere rechnet sie alle um: aus einer Linse von 1 cm wird eine von 10 mm.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Source</source>
            <translation>Quelle</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Where the light comes from.</source>
            <translation>Woher das Licht kommt.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Collimated light</source>
            <translation>Kollimiertes Licht</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Light from infinitely far that fills the entrance face: the sun, a laser beam.</source>
            <translation>Licht aus dem Unendlichen, das die Eintrittsfläche füllt: die Sonne, ein Laserstrahl.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Rays</source>
            <translation>Strahlen</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Rays along x and y in each iteration of the paper's method, and for derivative maps. More give a smoother image and take longer; at least two per pixel and axis are good. Automatic chooses its own.</source>
            <translation>Strahlen entlang x und y in jeder Iteration der Methode der Veröffentlichung und für Ableitungskarten. Mehr ergeben ein glatteres Bild und brauchen länger; mindestens zwei je Pixel und Achse sind gut. Automatisch wählt eigene.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Direction</source>
            <translation>Richtung</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>How far the light is tilted against the optical axis: about x, which makes it go downwards, and about y, which makes it go to +x.</source>
            <translation>Wie weit das Licht gegen die optische Achse geneigt ist: um x, was es nach unten lenkt, und um y, was es nach +x lenkt.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Angular diameter</source>
            <translation>Winkeldurchmesser</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Full angle of the disc that the light comes from: 0.533 for the sun, 0 for a laser or a star. It blurs the image by as much as the disc's light spreads on the way.</source>
            <translation>Voller Winkel der Scheibe, von der das Licht kommt: 0.533 bei der Sonne, 0 bei einem Laser oder Stern. Er macht das Bild so unscharf, wie sich das Licht der Scheibe unterwegs ausbreitet.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Profile</source>
            <translation>Profil</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>How bright the light is across the beam.</source>
            <translation>Wie hell das Licht über den Strahlquerschnitt ist.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Uniform</source>
            <translation>Gleichmäßig</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>As bright everywhere.</source>
            <translation>Überall gleich hell.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Gaussian beam</source>
            <translation>Gaußstrahl</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>A laser beam about the optical axis of the lens; what passes its rim misses the lens.</source>
            <translation>Ein Laserstrahl um die optische Achse der Linse; was an ihrem Rand vorbeigeht, verfehlt die Linse.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Beam radius</source>
            <translation>Strahlradius</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Where the irradiance has fallen to 1/e² (13.5 %) of that in the middle, measured across the beam.</source>
            <translation>Wo die Bestrahlungsstärke auf 1/e² (13.5 %) der in der Mitte gefallen ist, quer zum Strahl gemessen.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Wavelength</source>
            <translation>Wellenlänge</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Vacuum wavelength at which the indices of materials are taken. Left empty, it is 0.5876 µm (helium d), or the mean of the spectrum.</source>
            <translation>Vakuumwellenlänge, bei der die Brechzahlen der Materialien gelten. Leer: 0.5876 µm (Helium d) oder das Mittel des Spektrums.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Spectrum</source>
            <translation>Spektrum</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Up to 16 lines of light in place of one wavelength: wavelength in µm and part of the flux, as in 0.45, 0.3; 0.55, 0.5; 0.63, 0.2. Each line is traced with its own refractive indices, and an image is the sum of all lines. The parts may have any sum.</source>
            <translation>Bis zu 16 Spektrallinien statt einer Wellenlänge: Wellenlänge in µm und Anteil am Fluss, etwa 0.45, 0.3; 0.55, 0.5; 0.63, 0.2. Jede Linie wird mit ihren eigenen Brechzahlen gerechnet, und ein Bild ist die Summe aller Linien. Die Anteile dürfen eine beliebige Summe haben.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Light from one point into the cone that just covers the entrance face.</source>
            <translation>Licht von einem Punkt in den Kegel, der die Eintrittsfläche gerade deckt.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Position</source>
            <translation>Ort</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Where the point is: x, y and z. It has to stand before the entrance face; off the axis it lights the lens askew.</source>
            <translation>Wo der Punkt liegt: x, y und z. Er muss vor der Eintrittsfläche stehen; neben der Achse beleuchtet er die Linse schräg.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Rays in each iteration of the paper's method, and for derivative maps, those that miss the lens included. More give a smoother image and take longer; at least four per pixel are good. Automatic chooses its own.</source>
            <translation>Strahlen in jeder Iteration der Methode der Veröffentlichung und für Ableitungskarten, auch die, die die Linse verfehlen. Mehr ergeben ein glatteres Bild und brauchen länger; mindestens vier je Pixel sind gut. Automatisch wählt eigene.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Emission</source>
            <translation>Abstrahlung</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Uniform: equally bright in all directions, as a small bulb. Lambertian: dimmer away from the optical axis, as the surface of an LED.</source>
            <translation>Gleichmäßig: in alle Richtungen gleich hell, wie eine kleine Glühlampe. Lambertsch: abseits der optischen Achse dunkler, wie die Oberfläche einer LED.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Lambertian</source>
            <translation>Lambertsch</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Sampling</source>
            <translation>Abtastung</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>How directions of the paper's method are drawn. Low discrepancy (Sobol) spreads them evenly and needs far fewer rays; random is noisier, as in the paper.</source>
            <translation>Wie Richtungen der Methode der Veröffentlichung gezogen werden. Niedrige Diskrepanz (Sobol) verteilt sie gleichmäßig und braucht weit weniger Strahlen; zufällig rauscht mehr, wie in der Veröffentlichung.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Low discrepancy</source>
            <translation>Niedrige Diskrepanz</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Random</source>
            <translation>Zufällig</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Fresh rays</source>
            <translation>Neue Strahlen</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Draw new rays for each iteration of the paper's method, so that the lens cannot fit itself to one set of them. Automatic does not have this.</source>
            <translation>Für jede Iteration der Methode der Veröffentlichung neue Strahlen ziehen, damit sich die Linse nicht an einen Satz anpasst. Automatisch hat das nicht.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Intersection</source>
            <translation>Schnittpunkt</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>How it is found where a ray of the paper's method meets the exit face.</source>
            <translation>Wie ermittelt wird, wo ein Strahl der Methode der Veröffentlichung die Austrittsfläche trifft.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Exact</source>
            <translation>Exakt</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>On the B-spline itself, fast and without an error of its own.</source>
            <translation>Auf dem B-Spline selbst, schnell und ohne eigenen Fehler.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Triangle mesh</source>
            <translation>Dreiecksnetz</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>As in the paper, for comparison.</source>
            <translation>Wie in der Veröffentlichung, zum Vergleich.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Subdivisions</source>
            <translation>Unterteilungen</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Parts along x and y that each knot span is cut into, two triangles each. Twice as many make a quarter of the error, and four times the triangles.</source>
            <translation>Teile entlang x und y, in die jedes Knotenintervall geteilt wird, je zwei Dreiecke. Doppelt so viele ergeben ein Viertel des Fehlers und viermal so viele Dreiecke.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Grid of points</source>
            <translation>Punktraster</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Many points of equal intensity, standing for a source of some size.</source>
            <translation>Viele Punkte gleicher Stärke, die für eine Quelle gewisser Größe stehen.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>The middle of the grid: x, y and z. All points have the same z, before the entrance face.</source>
            <translation>Die Mitte des Rasters: x, y und z. Alle Punkte haben dasselbe z, vor der Eintrittsfläche.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Half width</source>
            <translation>Halbbreite</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Half of the grid's extent along x and y. No detail of the image can be sharper than the image that the lens makes of this.</source>
            <translation>Die halbe Ausdehnung des Rasters entlang x und y. Keine Einzelheit des Bildes kann schärfer sein als das Bild, das die Linse hiervon macht.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Size</source>
            <translation>Größe</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Full width and height of the grid. No detail of the image can be sharper than the image that the lens makes of this.</source>
            <translation>Volle Breite und Höhe des Rasters. Keine Einzelheit des Bildes kann schärfer sein als das Bild, das die Linse hiervon macht.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Points</source>
            <translation>Punkte</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Points along x and y, the outer ones on the rim. More of them come closer to an evenly bright source.</source>
            <translation>Punkte entlang x und y, die äußeren auf dem Rand. Mehr kommen einer gleichmäßig hellen Quelle näher.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Rays per point</source>
            <translation>Strahlen je Punkt</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Rays from each point of the grid, for the paper's method and derivative maps. What they add up to makes the image smooth; few from each of many points are enough. Automatic chooses its own.</source>
            <translation>Strahlen von jedem Punkt des Rasters, für die Methode der Veröffentlichung und Ableitungskarten. Ihre Gesamtzahl macht das Bild glatt; wenige von jedem von vielen Punkten genügen. Automatisch wählt eigene.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Photometric file</source>
            <translation>Photometrische Datei</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>A small lamp whose intensity by direction stands in a photometric file.</source>
            <translation>Eine kleine Lampe, deren richtungsabhängige Stärke in einer photometrischen Datei steht.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>File</source>
            <translation>Datei</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Intensity by direction, in a file of IES LM-63 (.ies) or EULUMDAT (.ldt). Its nadir looks along +z, C0 along +x and C90 along −y; the beam axis of types A and B along +z, V upwards along +y and H to the right along −x. A relative path starts at the scene file's folder.</source>
            <translation>Richtungsabhängige Strahlstärke in einer Datei nach IES LM-63 (.ies) oder EULUMDAT (.ldt). Ihr Nadir zeigt entlang +z, C0 entlang +x und C90 entlang −y; die Strahlachse der Typen A und B entlang +z, V nach oben entlang +y und H nach rechts entlang −x. Ein relativer Pfad beginnt beim Ordner der Szenendatei.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Where the lamp is: x, y and z. It has to stand before the lens.</source>
            <translation>Wo die Lampe steht: x, y und z. Sie muss vor der Linse stehen.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Rotation</source>
            <translation>Drehung</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>How the lamp is turned about its own origin: about its x, then about its new y, then about its new z.</source>
            <translation>Wie die Lampe um ihren eigenen Ursprung gedreht ist: um ihr x, dann um ihr neues y, dann um ihr neues z.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Rays in each iteration of the paper's method, and for derivative maps. Automatic chooses its own.</source>
            <translation>Strahlen in jeder Iteration der Methode der Veröffentlichung und für Ableitungskarten. Automatisch wählt eigene.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Ray file</source>
            <translation>Strahldatei</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>A lamp whose rays stand in a ray file, as they were measured or simulated.</source>
            <translation>Eine Lampe, deren Strahlen in einer Strahldatei stehen, wie sie gemessen oder simuliert wurden.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Rays in a file of IES TM-25 (.tm25ray), of OpticStudio (.dat), or of text (.csv, .txt) with the columns x, y, z, l, m, n and flux. A relative path starts at the scene file's folder.</source>
            <translation>Strahlen in einer Datei nach IES TM-25 (.tm25ray), von OpticStudio (.dat) oder als Text (.csv, .txt) mit den Spalten x, y, z, l, m, n und Lichtstrom. Ein relativer Pfad beginnt beim Ordner der Szenendatei.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Where the origin of the file is: x, y and z.</source>
            <translation>Wo der Ursprung der Datei liegt: x, y und z.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Unit of the file</source>
            <translation>Einheit der Datei</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Unit of the lengths in the file. Left empty, it is the one that the file names.</source>
            <translation>Einheit der Längen in der Datei. Leer: die, die die Datei nennt.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Area emitter</source>
            <translation>Flächenstrahler</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>A flat emitter that faces the lens; it shines into the whole half-space before it.</source>
            <translation>Ein ebener Strahler, der zur Linse zeigt; er strahlt in den ganzen Halbraum davor.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>The middle of the emitter: x, y and z, before the entrance face.</source>
            <translation>Die Mitte des Strahlers: x, y und z, vor der Eintrittsfläche.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Half of the emitter's extent along x and y.</source>
            <translation>Die halbe Ausdehnung des Strahlers entlang x und y.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Full width and height of the emitter.</source>
            <translation>Volle Breite und Höhe des Strahlers.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Outline</source>
            <translation>Umriss</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>The shape of its face: the rectangle of its size, or the ellipse within.</source>
            <translation>Die Form seiner Fläche: das Rechteck seiner Größe oder die Ellipse darin.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Rectangle</source>
            <translation>Rechteck</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Ellipse</source>
            <translation>Ellipse</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Luminous flux</source>
            <translation>Lichtstrom</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>All light that the emitter gives. With it, light on a screen is given in lux and lumen; left empty, in parts of all light. The lens does not depend on it.</source>
            <translation>Alles Licht, das der Strahler abgibt. Damit wird Licht auf einem Schirm in Lux und Lumen angegeben; leer: in Teilen des ganzen Lichts. Die Linse hängt nicht davon ab.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Elements</source>
            <translation>Elemente</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Lenses, mirrors and diffusers in the order in which light meets them. Light that passes one by is lost there.</source>
            <translation>Linsen, Spiegel und Diffusoren in der Reihenfolge des Lichts. Licht, das eines davon verfehlt, ist dort verloren.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Two faces with a material between; light goes through along its +z.</source>
            <translation>Zwei Flächen mit einem Material dazwischen; Licht geht entlang +z des Elements hindurch.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Name of the element; letters, digits, - and _.</source>
            <translation>Name des Elements; Buchstaben, Ziffern, - und _.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Where the vertex of its front face stands: x, y and z.</source>
            <translation>Wo der Scheitel seiner Vorderfläche steht: x, y und z.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Tilt</source>
            <translation>Verkippung</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>How the element is turned about its front vertex: about its x, then about its new y, then about its new z.</source>
            <translation>Wie das Element um seinen vorderen Scheitel gedreht ist: um sein x, dann um sein neues y, dann um sein neues z.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Half of its extent along x and y. All of it is lit.</source>
            <translation>Die halbe Ausdehnung entlang x und y. Alles davon ist beleuchtet.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Full width and height of the element. All of it is lit.</source>
            <translation>Volle Breite und Höhe des Elements. Alles davon ist beleuchtet.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>The rectangle of its size, or the ellipse within. Light beside it misses it.</source>
            <translation>Das Rechteck seiner Größe oder die Ellipse darin. Licht daneben verfehlt das Element.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Material</source>
            <translation>Material</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>What the lens is made of: a catalogue material, or a custom index.</source>
            <translation>Woraus die Linse besteht: ein Material des Katalogs oder eine eigene Brechzahl.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>A refractive index that is the same at all wavelengths.</source>
            <translation>Eine Brechzahl, die bei allen Wellenlängen gleich ist.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Index</source>
            <translation>Brechzahl</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Refractive index at the wavelength of the light.</source>
            <translation>Brechzahl bei der Wellenlänge des Lichts.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Thickness</source>
            <translation>Dicke</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>From the vertex of the front face to the vertex of the back face.</source>
            <translation>Vom Scheitel der Vorderfläche bis zum Scheitel der Rückfläche.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Faces</source>
            <translation>Flächen</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Front face and back face, in the order in which light meets them.</source>
            <translation>Vorderfläche und Rückfläche, in der Reihenfolge, in der Licht sie trifft.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Front face</source>
            <translation>Vorderfläche</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Back face</source>
            <translation>Rückfläche</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Plane</source>
            <translation>Ebene</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>A plane across the axis.</source>
            <translation>Eine Ebene quer zur Achse.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Conic</source>
            <translation>Kegelschnitt</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>A surface of revolution: a conic with aspheric coefficients (ISO 10110-12).</source>
            <translation>Eine Rotationsfläche: ein Kegelschnitt mit asphärischen Koeffizienten (ISO 10110-12).</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Radius</source>
            <translation>Radius</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Radius of curvature at the vertex: positive where the centre of curvature lies on the +z side of the vertex.</source>
            <translation>Krümmungsradius am Scheitel: positiv, wenn der Krümmungsmittelpunkt auf der +z-Seite des Scheitels liegt.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Conic constant</source>
            <translation>Konische Konstante</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>0 makes a sphere, −1 a paraboloid, less a hyperboloid, between −1 and 0 an ellipsoid.</source>
            <translation>0 ergibt eine Kugel, −1 ein Paraboloid, weniger ein Hyperboloid, zwischen −1 und 0 ein Ellipsoid.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Coefficients</source>
            <translation>Koeffizienten</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Aspheric coefficients a4, a6, …: a4 r⁴ + a6 r⁶ + … is added to the sag.</source>
            <translation>Asphärische Koeffizienten a4, a6, …: a4 r⁴ + a6 r⁶ + … wird zur Pfeilhöhe addiert.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>B-spline</source>
            <translation>B-Spline</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>A B-spline over a base; designed unless it is fixed.</source>
            <translation>Ein B-Spline über einer Grundform; wird entworfen, wenn er nicht fest ist.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Degree</source>
            <translation>Grad</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Polynomial degree of the B-spline along x and y. 3 gives smooth curvature.</source>
            <translation>Polynomgrad des B-Splines entlang x und y. 3 ergibt glatte Krümmung.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Control points</source>
            <translation>Kontrollpunkte</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Number of control points along x and y. More of them draw finer detail and take longer. Automatic takes what the target's detail, the screen's pixels and the size of the source are worth, and as many for the front face as for the back face; the paper's method then has nets like those of the paper.</source>
            <translation>Anzahl der Kontrollpunkte entlang x und y. Mehr davon zeichnen feinere Einzelheiten und brauchen länger. Automatisch nimmt, was die Einzelheiten des Ziels, die Pixel des Schirms und die Größe der Quelle wert sind, und für die Vorderfläche so viele wie für die Rückfläche; die Methode der Veröffentlichung hat dann Netze wie die der Veröffentlichung.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Base</source>
            <translation>Grundform</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>The shape of the face before the design; heights are counted from it.</source>
            <translation>Die Form der Fläche vor dem Entwurf; Höhen zählen von ihr aus.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Flat</source>
            <translation>Eben</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Sphere</source>
            <translation>Kugel</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>A spherical cap that rises or falls towards the rim.</source>
            <translation>Eine Kugelkappe, die zum Rand hin steigt oder fällt.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Base radius</source>
            <translation>Radius der Grundform</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Radius of curvature of the base; more than the half-diagonal of the lens or mirror.</source>
            <translation>Krümmungsradius der Grundform; größer als die halbe Diagonale von Linse oder Spiegel.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Base form</source>
            <translation>Wölbung</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Concave rises towards the rim, convex falls.</source>
            <translation>Konkav steigt zum Rand hin, konvex fällt.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Concave</source>
            <translation>Konkav</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Convex</source>
            <translation>Konvex</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Height range</source>
            <translation>Höhenbereich</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>How far the face may be from the base. Automatic takes what the task needs.</source>
            <translation>Wie weit die Fläche von der Grundform abweichen darf. Automatisch nimmt, was die Aufgabe braucht.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>to</source>
            <translation>bis</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Fixed</source>
            <translation>Fest</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>The design leaves the face as it is, with the control heights given.</source>
            <translation>Der Entwurf lässt die Fläche, wie sie ist, mit den angegebenen Kontrollhöhen.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Control heights</source>
            <translation>Kontrollhöhen</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>File (.npy) of the control heights of a fixed face, in the element's coordinates.</source>
            <translation>Datei (.npy) mit den Kontrollhöhen einer festen Fläche, in den Koordinaten des Elements.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Absorption</source>
            <translation>Absorption</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>How much the glass absorbs per length: light falls as exp(−absorption · path). Clear glass and acrylic absorb some 0.0002 per mm.</source>
            <translation>Wie viel das Glas je Länge absorbiert: Licht fällt wie exp(−Absorption · Weg). Klares Glas und Acryl absorbieren etwa 0.0002 je mm.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Reflection</source>
            <translation>Reflexion</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>What bare faces reflect: by Fresnel's equations for unpolarised light, by Schlick's approximation to them, as in the paper, or nothing. Under total reflection all of it.</source>
            <translation>Was unbeschichtete Flächen reflektieren: nach den Fresnelschen Formeln für unpolarisiertes Licht, nach Schlicks Näherung wie in der Veröffentlichung oder nichts. Bei Totalreflexion alles.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Fresnel, exact</source>
            <translation>Fresnel, exakt</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Schlick, approximate</source>
            <translation>Schlick, genähert</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>None</source>
            <translation>Keine</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Coating</source>
            <translation>Beschichtung</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Part of the light that an antireflection coating reflects, at the entrance face and at the exit face, at all angles: 0.005 is a good one. Left empty, faces are bare.</source>
            <translation>Teil des Lichts, den eine Entspiegelung an Eintritts- und Austrittsfläche unter allen Winkeln reflektiert: 0.005 ist eine gute. Leer: unbeschichtete Flächen.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Max. thickness</source>
            <translation>Max. Dicke</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>The back face is at most this far from the front face: the thickness of the stock that the part is made of. Left empty, any will do.</source>
            <translation>Die Rückfläche ist höchstens so weit von der Vorderfläche entfernt: die Dicke des Rohteils, aus dem das Teil gefertigt wird. Leer: beliebig.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Min. thickness</source>
            <translation>Min. Dicke</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>The back face stays at least this far from the front face, so that the part can be made.</source>
            <translation>Die Rückfläche bleibt mindestens so weit von der Vorderfläche entfernt, damit sich das Teil fertigen lässt.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Mirror</source>
            <translation>Spiegel</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>One face that reflects, lit from below.</source>
            <translation>Eine reflektierende Fläche, von unten beleuchtet.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>The face that reflects.</source>
            <translation>Die Fläche, die reflektiert.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Reflectance</source>
            <translation>Reflexionsgrad</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Part of the light that the mirror reflects, at all angles: about 0.9 for aluminium, 0.97 for silver. It absorbs the rest.</source>
            <translation>Teil des Lichts, den der Spiegel unter allen Winkeln reflektiert: etwa 0.9 bei Aluminium, 0.97 bei Silber. Den Rest absorbiert er.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>How far the flat back of the plate is behind the highest point of the mirror, in exports of the plate.</source>
            <translation>Wie weit die ebene Rückseite der Platte hinter dem höchsten Punkt des Spiegels liegt, beim Export der Platte.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Diffuser</source>
            <translation>Diffusor</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>One plane that scatters light onwards: the last element of a train.</source>
            <translation>Eine Ebene, die Licht nach vorn streut: das letzte Element einer Folge.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Scatter</source>
            <translation>Streuung</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>In which directions the light goes on behind the plane.</source>
            <translation>In welche Richtungen das Licht hinter der Ebene weiterläuft.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Gaussian</source>
            <translation>Gauß</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Light is scattered about the direction in which it would go on.</source>
            <translation>Das Licht wird um die Richtung gestreut, in der es weiterliefe.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Sigma</source>
            <translation>Sigma</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>How far light is scattered: the radiant intensity of a narrow beam behind the diffuser falls as exp(−θ²/2σ²) with the angle θ to the beam. For small σ it is the standard deviation of the angle along each axis. The full width at half maximum, which data sheets state, is 2.355 σ.</source>
            <translation>Wie weit Licht gestreut wird: Die Strahlstärke eines schmalen Bündels fällt hinter dem Diffusor mit dem Winkel θ zum Bündel wie exp(−θ²/2σ²). Für kleine σ ist es die Standardabweichung des Winkels entlang jeder Achse. Die Halbwertsbreite (FWHM) in Datenblättern ist 2.355 σ.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Light leaves with the same radiance in all directions, wherever it comes from.</source>
            <translation>Licht verlässt ihn mit gleicher Strahldichte in alle Richtungen, gleich woher es kommt.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Transmittance</source>
            <translation>Transmissionsgrad</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Part of the light that goes on behind the diffuser, at all angles of incidence. It absorbs the rest, or reflects it.</source>
            <translation>Anteil des Lichts, der hinter dem Diffusor weiterläuft, bei allen Einfallswinkeln. Den Rest absorbiert oder reflektiert er.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Images</source>
            <translation>Bilder</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Where light is wanted, and which. Two freeform faces can form several images; one face forms a compromise.</source>
            <translation>Wo Licht gewünscht ist, und welches. Zwei Freiformflächen können mehrere Bilder formen; eine Fläche formt einen Kompromiss.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>A receiver with the light that is wanted on it. It takes no light from other images.</source>
            <translation>Ein Empfänger mit dem Licht, das auf ihm gewünscht ist. Anderen Bildern nimmt er kein Licht.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Receiver</source>
            <translation>Empfänger</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Where the light is wanted: on a plane or in directions.</source>
            <translation>Wo das Licht gewünscht ist: auf einer Ebene oder in Richtungen.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Rectangle of a plane. Its coordinates go along its sides, from its middle.</source>
            <translation>Rechteck einer Ebene. Seine Koordinaten laufen von seiner Mitte aus entlang seiner Seiten.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Where the middle of the plane stands: x, y and z.</source>
            <translation>Wo die Mitte der Ebene steht: x, y und z.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>How the plane is turned about its middle: about its x, which takes its upper edge away from or towards the lens, then about its new y, then about its new z. Rows and columns turn with it.</source>
            <translation>Wie die Ebene um ihre Mitte gedreht ist: um ihr x, was ihre obere Kante von der Linse weg oder zu ihr hin bewegt, dann um ihr neues y, dann um ihr neues z. Zeilen und Spalten drehen sich mit.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Half of the screen's extent along x and y. The target fills it.</source>
            <translation>Die halbe Ausdehnung des Schirms entlang x und y. Das Ziel füllt ihn.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Full width and height of the screen. The target fills it.</source>
            <translation>Volle Breite und Höhe des Schirms. Das Ziel füllt ihn.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Pixels</source>
            <translation>Pixel</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Pixels along x and y in which the light is counted and compared with the target.</source>
            <translation>Pixel entlang x und y, in denen das Licht gezählt und mit dem Ziel verglichen wird.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Far field</source>
            <translation>Fernfeld</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Directions of the light that leaves the lens, as if a screen were infinitely far.</source>
            <translation>Richtungen des Lichts, das die Linse verlässt, als wäre ein Schirm unendlich fern.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Half angle</source>
            <translation>Halbwinkel</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Half of the angles that it covers to the right and upwards. The target fills it.</source>
            <translation>Die Hälfte der Winkel, die es nach rechts und nach oben umfasst. Das Ziel füllt es.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Full angles that it covers across and upwards. The target fills it.</source>
            <translation>Volle Winkel, die es quer und nach oben umfasst. Das Ziel füllt es.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Centre</source>
            <translation>Mitte</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Its middle: angle to the right and angle upwards from the optical axis.</source>
            <translation>Seine Mitte: Winkel nach rechts und nach oben von der optischen Achse.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>The image that the light shall draw there.</source>
            <translation>Das Bild, das das Licht dort zeichnen soll.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Image file</source>
            <translation>Bilddatei</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Bright pixels get much light, black ones and transparent ones none.</source>
            <translation>Helle Pixel bekommen viel Licht, schwarze und durchsichtige keines.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Image file; bright pixels get much light, black ones and transparent ones none. Where all that is drawn is black, as in many a logo on a transparent ground, the drawing itself gets the light. It is fitted into the screen, or into the far field's angles, with its aspect kept. A relative path starts at the scene file's folder.</source>
            <translation>Bilddatei; helle Pixel bekommen viel Licht, schwarze und durchsichtige keines. Wo alles Gezeichnete schwarz ist, wie bei vielen Logos auf durchsichtigem Grund, bekommt die Zeichnung selbst das Licht. Das Bild wird mit seinem Seitenverhältnis in den Schirm oder in die Winkel des Fernfelds eingepasst. Ein relativer Pfad beginnt im Ordner der Szenendatei.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Brightness</source>
            <translation>Helligkeit</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>What a pixel value means. A monitor shows half of the largest value as a fifth of the light: a photograph looks as it does there only where that is undone (sRGB). As stored, the value itself is the light: half of it is half the light. A colour profile in the file counts in place of this.</source>
            <translation>Was ein Pixelwert bedeutet. Ein Monitor zeigt den halben Höchstwert als ein Fünftel des Lichts: eine Fotografie sieht nur dann aus wie dort, wenn das rückgängig gemacht wird (sRGB). Wie gespeichert heißt: der Wert selbst ist das Licht, halber Wert ist halbes Licht. Ein Farbprofil in der Datei gilt an dessen Stelle.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>As stored</source>
            <translation>Wie gespeichert</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>As shown by a monitor</source>
            <translation>Wie auf einem Monitor</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Fit</source>
            <translation>Einpassen</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Whether all of the picture is seen, with a black border where the screen or the far field has another aspect, or that is filled, and what is beyond it is cut away.</source>
            <translation>Ob das ganze Bild zu sehen ist, mit schwarzem Rand, wo Schirm oder Fernfeld ein anderes Seitenverhältnis haben, oder diese ganz gefüllt werden und abgeschnitten wird, was darüber hinausgeht.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>All of the picture</source>
            <translation>Das ganze Bild</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Without a border</source>
            <translation>Ohne Rand</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Turns the picture.</source>
            <translation>Dreht das Bild.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>As it is</source>
            <translation>Wie es ist</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>A quarter to the left</source>
            <translation>Eine Vierteldrehung nach links</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>A quarter to the right</source>
            <translation>Eine Vierteldrehung nach rechts</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Upside down</source>
            <translation>Auf den Kopf</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Cut away</source>
            <translation>Beschneiden</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>What is cut away at the left, top, right and bottom of the picture, as fractions of its width and height, before it is turned.</source>
            <translation>Was links, oben, rechts und unten vom Bild abgeschnitten wird, als Bruchteile seiner Breite und Höhe, bevor es gedreht wird.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>of the picture</source>
            <translation>des Bildes</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Black level</source>
            <translation>Schwarzwert</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Pixel values up to this level get no light, as in the levels of a photo program. Raise it where a dark background takes light from the subject. Levels are fractions of the brightest pixel value, after the crop and the inversion.</source>
            <translation>Pixelwerte bis hierher erhalten kein Licht, wie bei der Tonwertkorrektur eines Bildprogramms. Höher, wo ein dunkler Hintergrund dem Motiv Licht nimmt. Alle Werte sind Teile des hellsten Pixelwerts, nach Zuschnitt und Umkehrung.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>of the brightest</source>
            <translation>des hellsten</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>White level</source>
            <translation>Weißwert</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Pixel values from this level on are white. Lower it to cut highlights off, so that the rest of the picture gets more of the light.</source>
            <translation>Pixelwerte ab hier sind weiß. Niedriger schneidet Spitzlichter ab, und der Rest des Bildes erhält mehr Licht.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Gamma</source>
            <translation>Gamma</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Above 1 the mid-tones between the black level and the white level are brighter, below 1 darker: the pixel value to the power of 1/gamma.</source>
            <translation>Über 1 sind die Mitteltöne zwischen Schwarzwert und Weißwert heller, unter 1 dunkler: der Pixelwert hoch 1/Gamma.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Padding</source>
            <translation>Rand</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Black border on each side as a fraction of the whole image; it keeps light away from the edge.</source>
            <translation>Schwarzer Rand auf jeder Seite als Bruchteil des ganzen Bildes; er hält Licht von der Kante fern.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>of width</source>
            <translation>der Breite</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Blur</source>
            <translation>Weichzeichnen</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Standard deviation of a Gaussian over the target. Soft edges are easier for a smooth lens.</source>
            <translation>Standardabweichung einer Gaußkurve über dem Ziel. Weiche Kanten sind für eine glatte Linse einfacher.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Invert</source>
            <translation>Umkehren</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Swap bright and dark.</source>
            <translation>Hell und dunkel vertauschen.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Viewed from</source>
            <translation>Betrachtet von</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>The side of the receiver from which the picture reads the right way round. An opaque wall, a table, or a far field on a distant wall is viewed from the side of the light, a rear projection from behind the receiver. If it is left out, column 0 of the picture lies at −x: it then reads right from behind with a lens, from the side of the light with a mirror.</source>
            <translation>Die Seite des Empfängers, von der aus das Bild richtig herum zu lesen ist. Eine undurchsichtige Wand, ein Tisch oder ein Fernfeld auf einer entfernten Wand wird von der Lichtseite betrachtet, eine Rückprojektion von hinter dem Empfänger. Ohne Angabe liegt Spalte 0 des Bildes bei −x: mit einer Linse ist es dann von hinten richtig zu lesen, mit einem Spiegel von der Lichtseite.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>The side of the light</source>
            <translation>Lichtseite</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Behind the receiver</source>
            <translation>Hinter dem Empfänger</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>A uniform disc.</source>
            <translation>Eine gleichmäßige Scheibe.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Radius of the shape as a fraction of the smaller half-width of the whole image.</source>
            <translation>Radius der Form als Bruchteil der kleineren Halbbreite des ganzen Bildes.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>of half width</source>
            <translation>der Halbbreite</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>A flame-like logo on black.</source>
            <translation>Ein flammenähnliches Logo auf Schwarz.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Height of the shape as a fraction of the smaller width of the whole image.</source>
            <translation>Höhe der Form als Bruchteil der kleineren Breite des ganzen Bildes.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>A faceted ball in several greys.</source>
            <translation>Ein Ball aus Facetten in mehreren Grautönen.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>A uniform rectangle; as large as the whole image, all of it evenly lit.</source>
            <translation>Ein gleichmäßiges Rechteck; so groß wie das ganze Bild beleuchtet es dieses ganz und gleichmäßig.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Width</source>
            <translation>Breite</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Width of the rectangle as a fraction of that of the whole image.</source>
            <translation>Breite des Rechtecks als Bruchteil der des ganzen Bildes.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>of the whole image</source>
            <translation>des ganzen Bildes</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Height of the rectangle as a fraction of that of the whole image; a small one makes a line.</source>
            <translation>Höhe des Rechtecks als Bruchteil der des ganzen Bildes; eine kleine macht eine Linie.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Ring</source>
            <translation>Ring</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>A uniform ring.</source>
            <translation>Ein gleichmäßiger Ring.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Inner radius</source>
            <translation>Innenradius</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>As a fraction of the radius.</source>
            <translation>Als Bruchteil des Radius.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>of radius</source>
            <translation>des Radius</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Beam</source>
            <translation>Lichtkegel</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>A rotationally symmetric beam with a hot spot, and spill around it.</source>
            <translation>Ein rotationssymmetrischer Lichtkegel mit hellem Kern und Streulicht darum.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Points of radius and level, from the middle outwards; a smooth curve joins them. A radius is a fraction of the smaller half-width of the whole image, a level one of the peak: the radius at level 0.5 is half of the full width at half maximum, that at 0.1 half of the field width. The first level holds within its radius; beyond the last radius there is no light.</source>
            <translation>Punkte aus Radius und Wert, von der Mitte nach außen; eine glatte Kurve verbindet sie. Ein Radius ist ein Teil der kleineren halben Breite des ganzen Bildes, ein Wert ein Teil des größten: der Radius beim Wert 0,5 ist die halbe Halbwertsbreite, der bei 0,1 die halbe Feldbreite. Der erste Wert gilt innerhalb seines Radius; jenseits des letzten Radius ist kein Licht.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>radius, level</source>
            <translation>Radius, Wert</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Text</source>
            <translation>Text</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Words, as large as the whole image lets them be.</source>
            <translation>Wörter, so groß, wie das ganze Bild es zulässt.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>The words; \n begins a new line.</source>
            <translation>Die Wörter; \n beginnt eine neue Zeile.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Weight</source>
            <translation>Gewicht</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Factor of the square of this image's relative error in a design of several images.</source>
            <translation>Faktor des Quadrats des relativen Fehlers dieses Bildes bei einem Entwurf mit mehreren Bildern.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Image filter</source>
            <translation>Bildfilter</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>How a ray's light is shared among pixels, by the paper's method and in derivative maps. Automatic has no filter.</source>
            <translation>Wie das Licht eines Strahls auf Pixel verteilt wird, bei der Methode der Veröffentlichung und in Ableitungskarten. Automatisch hat keinen Filter.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Light falls off over some pixels, so that a design feels where in a pixel a ray lands.</source>
            <translation>Das Licht fällt über einige Pixel ab, sodass ein Entwurf spürt, wo im Pixel ein Strahl landet.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Pixels along x and y that one ray reaches; odd numbers.</source>
            <translation>Pixel entlang x und y, die ein Strahl erreicht; ungerade Zahlen.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Alpha</source>
            <translation>Alpha</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>How fast the Gaussian falls: exp(−alpha · distance²). Small is wide.</source>
            <translation>Wie schnell die Gaußkurve fällt: exp(−alpha · Abstand²). Klein ist breit.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Box</source>
            <translation>Kasten</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Every ray counts fully in the pixel that it hits.</source>
            <translation>Jeder Strahl zählt ganz in dem Pixel, das er trifft.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Parts of the screen, or of the angles of the far field, whose light is stated by itself, as on a desk or a lane: how much there is, and how even it is; of several images, the same parts of each. They do not change the lens.</source>
            <translation>Teile des Schirms oder der Winkel des Fernfelds, deren Licht für sich angegeben wird, etwa auf einem Tisch oder einer Fahrspur: wie viel es ist und wie gleichmäßig; bei mehreren Bildern dieselben Teile von jedem. Sie ändern die Linse nicht.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>A rectangle.</source>
            <translation>Ein Rechteck.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Middle</source>
            <translation>Mitte</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Where its middle is, from that of the receiver.</source>
            <translation>Wo seine Mitte liegt, von der des Empfängers aus.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Its whole width and height.</source>
            <translation>Seine ganze Breite und Höhe.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Name of the region in its figures.</source>
            <translation>Name des Ausschnitts bei seinen Zahlen.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>An ellipse; a circle where the receiver's aspect and its own make one.</source>
            <translation>Eine Ellipse; ein Kreis, wo das Seitenverhältnis des Empfängers und ihr eigenes einen ergeben.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Polygon</source>
            <translation>Polygon</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>A polygon, whose corners are drawn on an image.</source>
            <translation>Ein Polygon, dessen Ecken auf ein Bild gezeichnet werden.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Corners</source>
            <translation>Ecken</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>In their order around it, from the receiver's middle.</source>
            <translation>In ihrer Reihenfolge ringsum, von der Mitte des Empfängers aus.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Steps by which the designed elements are made, in their order. Runs design for the image as made, and checks trace it. Left empty, elements are ideal.</source>
            <translation>Schritte, in denen die entworfenen Elemente gefertigt werden, in ihrer Reihenfolge. Läufe entwerfen für das Bild nach der Fertigung, und Prüfungen verfolgen es. Leer gelassen sind Elemente ideal.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Milling</source>
            <translation>Fräsen</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Milling with a ball cutter in straight parallel passes.</source>
            <translation>Fräsen mit einem Kugelfräser in geraden parallelen Bahnen.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Ball radius</source>
            <translation>Kugelradius</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Radius of the ball cutter.</source>
            <translation>Radius des Kugelfräsers.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Distance of neighbouring passes, seen along z. The scallops between them are about step² / 8 R high.</source>
            <translation>Abstand benachbarter Bahnen, entlang z gesehen. Die Rillen dazwischen sind etwa Abstand² / 8 R hoch.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Direction of the passes against x.</source>
            <translation>Richtung der Bahnen gegen x.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Feed per tooth</source>
            <translation>Vorschub je Zahn</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Distance of the marks along each pass; 0 for none.</source>
            <translation>Abstand der Marken entlang jeder Bahn; 0 für keine.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Diamond turning</source>
            <translation>Diamantdrehen</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Diamond turning with a slow tool servo: a spiral about the axis of the element.</source>
            <translation>Diamantdrehen mit Slow-Tool-Servo: eine Spirale um die Achse des Elements.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Nose radius</source>
            <translation>Spitzenradius</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Radius of the tip of the diamond.</source>
            <translation>Radius der Diamantspitze.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Feed</source>
            <translation>Vorschub</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Distance of neighbouring turns. The ridges between are feed² / 8 R high.</source>
            <translation>Abstand benachbarter Windungen. Die Grate dazwischen sind Vorschub² / 8 R hoch.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Polishing</source>
            <translation>Polieren</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Polishing: high spots go first, so that the face becomes an average of itself.</source>
            <translation>Polieren: Hohe Stellen gehen zuerst, sodass die Fläche zu einem Mittel ihrer selbst wird.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Rms width of the Gaussian by which polishing averages the face. Half of the step-over removes scallops; details of the lens that are not much wider go, too.</source>
            <translation>Effektive Breite der Gaußkurve, mit der Polieren die Fläche mittelt. Die Hälfte des Zeilenabstands entfernt Rillen; Einzelheiten der Linse, die nicht viel breiter sind, gehen auch.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Depth</source>
            <translation>Tiefe</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Thickness of the layer that polishing removes.</source>
            <translation>Dicke der Schicht, die Polieren abträgt.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Casting or moulding</source>
            <translation>Gießen oder Spritzguss</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Casting or moulding: the element shrinks as it cures or cools.</source>
            <translation>Gießen oder Spritzguss: Das Element schrumpft beim Aushärten oder Abkühlen.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Shrinkage</source>
            <translation>Schwindung</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Part by which all lengths of the element become smaller and the mould or the print file does not make up for: 0.005 for 0.5 %.</source>
            <translation>Teil, um den alle Längen des Elements kleiner werden und den Form oder Druckdatei nicht ausgleicht: 0,005 für 0,5 %.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Resin printing</source>
            <translation>Harzdruck</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Resin printing in layers along z, which pixels of light cure; then dipping or coating.</source>
            <translation>Harzdruck in Schichten entlang z, die Lichtpixel härten; dann Tauchen oder Lackieren.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Layer height</source>
            <translation>Schichthöhe</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Thickness of each layer, along z.</source>
            <translation>Dicke jeder Schicht, entlang z.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Pixel size</source>
            <translation>Pixelgröße</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Width of the pixels of light that cure a layer.</source>
            <translation>Breite der Lichtpixel, die eine Schicht härten.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Dip width</source>
            <translation>Tauchbreite</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Rms width of the Gaussian by which a dip in resin, or a coat of varnish, averages the face; 0 for none.</source>
            <translation>Effektive Breite der Gaußkurve, mit der ein Harzbad oder ein Lack die Fläche mittelt; 0 für keines.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Figure error</source>
            <translation>Formfehler</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Figure error: random waves of a known slope and length, whatever makes them.</source>
            <translation>Formfehler: zufällige Wellen bekannter Neigung und Länge, was sie auch erzeugt.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Rms of the gradient of the error.</source>
            <translation>Effektivwert des Gradienten des Fehlers.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Correlation length</source>
            <translation>Korrelationslänge</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Distance at which the autocorrelation falls to 1/e.</source>
            <translation>Abstand, bei dem die Autokorrelation auf 1/e fällt.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Another number makes other waves.</source>
            <translation>Eine andere Zahl ergibt andere Wellen.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Uncertainty</source>
            <translation>Unsicherheit</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Standard deviations of the set-up that is built. Runs then lower the mean error over them, and not that of the exact set-up alone.</source>
            <translation>Standardabweichungen des gebauten Aufbaus. Läufe senken dann den mittleren Fehler darüber, nicht nur den des genauen Aufbaus.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Standard deviations of what a built set-up has else than the scene says; 0 where known.</source>
            <translation>Standardabweichungen dessen, was ein gebauter Aufbau anders hat als die Szene; 0, wo bekannt.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Distance</source>
            <translation>Abstand</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Of the receiver, along the light that comes to its middle.</source>
            <translation>Des Empfängers, entlang des Lichts zu seiner Mitte.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Source shift</source>
            <translation>Quellenversatz</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Of a source at a place, along x and along y.</source>
            <translation>Einer Quelle an einem Ort, entlang x und entlang y.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Source tilt</source>
            <translation>Quellenkippung</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Of collimated light, about x and about y.</source>
            <translation>Von parallelem Licht, um x und um y.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Source size</source>
            <translation>Größe der Quelle</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Of an extended source, in percent of its size.</source>
            <translation>Einer ausgedehnten Quelle, in Prozent ihrer Größe.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Of the refractive index of designed lenses.</source>
            <translation>Des Brechungsindex entworfener Linsen.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Of the material of designed lenses at each freeform face.</source>
            <translation>Des Materials entworfener Linsen an jeder Freiformfläche.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Run</source>
            <translation>Lauf</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>How the design is found.</source>
            <translation>Wie der Entwurf gefunden wird.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>The best that this program knows; it may stop before all iterations are done.</source>
            <translation>Das Beste, was dieses Programm kennt; es kann vor der letzten Iteration enden.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Upper limit of iterations. Automatic may stop sooner, when nothing improves.</source>
            <translation>Obergrenze der Iterationen. Automatisch kann früher enden, wenn nichts besser wird.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>What the run goes through before the scene as it stands.</source>
            <translation>Was der Lauf vor der Szene, wie sie ist, durchläuft.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Stage</source>
            <translation>Stufe</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>A part of the run, before the scene itself is run, with some things different.</source>
            <translation>Ein Teil des Laufs, bevor die Szene selbst läuft, mit einigen anderen Einstellungen.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Upper limit of iterations of this stage. They count within those of the run; what all stages leave is for the scene itself.</source>
            <translation>Obergrenze der Iterationen dieser Stufe. Sie zählen zu denen des Laufs; was alle Stufen übrig lassen, ist für die Szene selbst.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>How the lens is searched for in this stage.</source>
            <translation>Wie die Linse in dieser Stufe gesucht wird.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>As the scene</source>
            <translation>Wie die Szene</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>As in the paper</source>
            <translation>Wie in der Veröffentlichung</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Learning rate</source>
            <translation>Lernrate</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Step of the optimiser. Too large and the loss jumps, too small and it creeps. Left empty, it is that of the scene.</source>
            <translation>Schrittweite des Optimierers. Zu groß, und die Zielfunktion springt, zu klein, und sie kriecht. Leer: die der Szene.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Numbers of control points along x and y in this stage. A coarse net moves light over long distances soon; the next stage goes on with the same surface on a finer one. Left empty, they are the lens's.</source>
            <translation>Anzahl der Kontrollpunkte entlang x und y in dieser Stufe. Ein grobes Netz bewegt Licht bald über weite Strecken; die nächste Stufe macht mit derselben Fläche auf einem feineren weiter. Leer: die der Linse.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Smoothness</source>
            <translation>Glätte</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Weight of the exit face's bending energy beside the square of the image's error; it has no unit. 0.001 calms ripples, 0.01 costs sharpness. Left empty, the face may bend as it likes.</source>
            <translation>Gewicht der Biegeenergie der Austrittsfläche neben dem Quadrat des Bildfehlers; es hat keine Einheit. 0.001 beruhigt Wellen, 0.01 kostet Schärfe. Leer: die Fläche darf sich beliebig biegen.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Smallest radius</source>
            <translation>Kleinster Radius</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Smallest radius of curvature that the exit face may have, concave and convex: that of the tool. A run that has settled keeps to it; dark edges get softer. Left empty, any will do.</source>
            <translation>Kleinster Krümmungsradius, den die Austrittsfläche haben darf, konkav und konvex: der des Werkzeugs. Ein Lauf, der sich gesetzt hat, hält ihn ein; dunkle Kanten werden weicher. Leer: beliebig.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Ball cutter radius</source>
            <translation>Radius des Kugelfräsers</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Radius of the ball cutter that has to fit everywhere on the freeform faces. Hollows keep to it; humps may be sharper. Manufacture shows whether it fits. Left empty, any will do.</source>
            <translation>Radius des Kugelfräsers, der überall auf die Freiformflächen passen muss. Mulden halten ihn ein; Erhebungen dürfen schärfer sein. „Fertigung“ zeigt, ob er passt. Leer: beliebig.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Error at most</source>
            <translation>Fehler höchstens</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Goal for the relative L2 error: 0.02 is 2 %. The run ends as soon as its lens meets it. Left empty, the run goes on as long as it gains.</source>
            <translation>Vorgabe für den relativen L2-Fehler: 0.02 sind 2 %. Der Lauf endet, sobald seine Linse sie einhält. Leer: Der Lauf geht weiter, solange er gewinnt.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Light at least</source>
            <translation>Licht mindestens</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Goal for the part of the emitted light on the receiver: 0.9 is 90 %. It is judged and does not change the run.</source>
            <translation>Vorgabe für den Anteil des ausgesandten Lichts auf dem Empfänger: 0.9 sind 90 %. Sie wird beurteilt und ändert den Lauf nicht.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Uniformity at least</source>
            <translation>Gleichmäßigkeit mindestens</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Goal for U₀, the minimum over the average irradiance where the target is lit; 1 is uniform. It is judged and does not change the run.</source>
            <translation>Vorgabe für U₀, Minimum über Mittelwert der Bestrahlungsstärke, wo das Ziel hell ist; 1 ist gleichmäßig. Sie wird beurteilt und ändert den Lauf nicht.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Start of the random numbers; the same seed repeats the same run.</source>
            <translation>Anfang der Zufallszahlen; derselbe Startwert wiederholt denselben Lauf.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Computes on</source>
            <translation>Rechnet auf</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>The graphics card needs a CUDA device and a PyTorch built for it.</source>
            <translation>Die Grafikkarte braucht ein CUDA-Gerät und ein dafür gebautes PyTorch.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Processor</source>
            <translation>Prozessor</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Graphics card (CUDA)</source>
            <translation>Grafikkarte (CUDA)</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>The published method, for comparison: Adam on control heights, or through a network.</source>
            <translation>Die veröffentlichte Methode, zum Vergleich: Adam auf Kontrollhöhen oder durch ein Netzwerk.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Optimises</source>
            <translation>Optimiert</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>What the optimiser moves: one number per control height, or the weights of a network that puts the heights out. In a sparse network the neurons of control points that share a piece of the face are linked, in a dense one all are.</source>
            <translation>Was der Optimierer bewegt: eine Zahl je Kontrollhöhe oder die Gewichte eines Netzwerks, das die Höhen ausgibt. In einem dünn besetzten Netzwerk sind die Neuronen von Kontrollpunkten verbunden, die ein Stück der Fläche teilen, in einem vollbesetzten alle.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Sparse network</source>
            <translation>Dünn besetztes Netzwerk</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Dense network</source>
            <translation>Vollbesetztes Netzwerk</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Parameters before the first iteration: all zero, in ±0.0001, or drawn from the seed so that the lens is crooked. A network that starts with zeros behaves as if there were none.</source>
            <translation>Parameter vor der ersten Iteration: alle null, in ±0.0001 oder aus dem Startwert gezogen, sodass die Linse krumm ist. Ein Netzwerk, das mit Nullen beginnt, verhält sich, als gäbe es keines.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Faint noise</source>
            <translation>Schwaches Rauschen</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Step of the optimiser. Too large and the loss jumps, too small and it creeps. Left empty, it is the one that suits what is optimised.</source>
            <translation>Schrittweite des Optimierers. Zu groß, und die Zielfunktion springt, zu klein, und sie kriecht. Leer: die, die zum Optimierten passt.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Sunlit plate</source>
            <translation>Platte in der Sonne</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>A clear plate in the sun throws a picture onto a wall or table nearby.</source>
            <translation>Eine klare Platte in der Sonne wirft ein Bild auf eine nahe Wand oder einen Tisch.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>What the light shall draw: a picture file, a shape or a word.</source>
            <translation>Was das Licht zeichnen soll: eine Bilddatei, eine Form oder ein Wort.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Lens size</source>
            <translation>Linsengröße</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Full width and height of the lens; all of it is lit.</source>
            <translation>Ganze Breite und Höhe der Linse; sie ist ganz beleuchtet.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>What the lens is made of. Any index can be given later.</source>
            <translation>Woraus die Linse besteht. Eine beliebige Brechzahl lässt sich später angeben.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Acrylic (PMMA)</source>
            <translation>Acryl (PMMA)</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Polycarbonate</source>
            <translation>Polycarbonat</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Polystyrene</source>
            <translation>Polystyrol</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Glass (N-BK7)</source>
            <translation>Glas (N-BK7)</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Fused silica</source>
            <translation>Quarzglas</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Stock thickness</source>
            <translation>Rohteildicke</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Thickness of the plate that the lens is cut from. Left empty, any will do, and one is proposed.</source>
            <translation>Dicke der Platte, aus der die Linse geschnitten wird. Leer: beliebig, und eine wird vorgeschlagen.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Distance to the image</source>
            <translation>Abstand zum Bild</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>From the entrance face of the lens to the image.</source>
            <translation>Von der Eintrittsfläche der Linse bis zum Bild.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Image size</source>
            <translation>Bildgröße</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Full width and height of the image; the picture is fitted into it.</source>
            <translation>Ganze Breite und Höhe des Bildes; die Vorlage wird darin eingepasst.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Torch or phone</source>
            <translation>Taschenlampe oder Telefon</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>The light of a telephone or a torch throws a picture onto a wall.</source>
            <translation>Das Licht eines Telefons oder einer Taschenlampe wirft ein Bild auf eine Wand.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Lamp size</source>
            <translation>Lampengröße</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Full width and height of what shines: 1 to 2 mm in a telephone.</source>
            <translation>Ganze Breite und Höhe dessen, was leuchtet: 1 bis 2 mm bei einem Telefon.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>All light of the lamp, as its data sheet says. With it, light is given in lux and lumen; left empty, in parts of all light.</source>
            <translation>Alles Licht der Lampe, wie im Datenblatt. Damit wird Licht in Lux und Lumen angegeben; bleibt es leer, in Teilen des ganzen Lichts.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Lamp to lens</source>
            <translation>Von der Lampe zur Linse</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>From the lamp to the entrance face of the lens.</source>
            <translation>Von der Lampe bis zur Eintrittsfläche der Linse.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Beam of a torch or downlight</source>
            <translation>Lichtkegel einer Taschenlampe</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>An LED and its lens make a round beam of given angles, as of a torch or a downlight.</source>
            <translation>Eine LED und ihre Linse machen einen runden Lichtkegel mit gegebenen Winkeln, wie bei einer Taschenlampe oder einem Downlight.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Beam angle</source>
            <translation>Halbwertswinkel</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Full angle within which the intensity is at least half of the peak.</source>
            <translation>Voller Winkel, in dem die Lichtstärke mindestens die Hälfte der größten ist.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Field angle</source>
            <translation>Feldwinkel</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Full angle within which the intensity is at least 10 % of the peak.</source>
            <translation>Voller Winkel, in dem die Lichtstärke mindestens 10 % der größten ist.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Spill angle</source>
            <translation>Streulichtwinkel</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Full angle of all light of the beam.</source>
            <translation>Voller Winkel allen Lichts des Lichtkegels.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Spill</source>
            <translation>Streulicht</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Intensity at the edge of the spill, in percent of the peak.</source>
            <translation>Lichtstärke am Rand des Streulichts, in Prozent der größten.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>LED size</source>
            <translation>LED-Größe</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Full width and height of the LED's bright face.</source>
            <translation>Ganze Breite und Höhe der leuchtenden Fläche der LED.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>LED close by</source>
            <translation>Nahe LED</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>An LED close to its lens lights a rectangle or another shape evenly.</source>
            <translation>Eine LED nahe ihrer Linse beleuchtet ein Rechteck oder eine andere Form gleichmäßig.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Laser beam shaper</source>
            <translation>Laserstrahlformer</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>A Gaussian laser beam becomes an even disc, a rectangle or any other shape.</source>
            <translation>Ein Gaußscher Laserstrahl wird zur gleichmäßigen Scheibe, zum Rechteck oder zu einer anderen Form.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Beam diameter</source>
            <translation>Strahldurchmesser</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Where the irradiance has fallen to 1/e² (13.5 %) of that in the middle, across the beam.</source>
            <translation>Wo die Bestrahlungsstärke auf 1/e² (13.5 %) der in der Mitte gefallen ist, quer zum Strahl.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Of the laser. It decides the index, and how far light spreads.</source>
            <translation>Des Lasers. Sie bestimmt die Brechzahl und wie weit sich das Licht ausbreitet.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>A lamp above or below a wall lights it evenly from the side.</source>
            <translation>Eine Lampe oben oder unten an einer Wand beleuchtet sie gleichmäßig von der Seite.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Lit wall</source>
            <translation>Beleuchtete Wand</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Full width and height of what shall be lit of the wall.</source>
            <translation>Ganze Breite und Höhe des Teils der Wand, der beleuchtet werden soll.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Lamp to wall</source>
            <translation>Von der Lampe zur Wand</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>From the lamp straight to the wall.</source>
            <translation>Auf kürzestem Weg von der Lampe zur Wand.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Lamp above the middle</source>
            <translation>Lampe über der Mitte</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>How much higher than the middle of the lit wall the lamp is; below it, less than 0.</source>
            <translation>Wie viel höher als die Mitte der beleuchteten Wand die Lampe ist; darunter kleiner als 0.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Far field of a lamp</source>
            <translation>Fernfeld einer Lampe</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>A lamp of a photometric file sends its light into wanted directions, far away.</source>
            <translation>Eine Lampe aus einer photometrischen Datei sendet ihr Licht in gewünschte Richtungen, weit entfernt.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Lamp file</source>
            <translation>Lampendatei</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Intensity by direction, in a file of IES LM-63 (.ies) or EULUMDAT (.ldt).</source>
            <translation>Stärke je Richtung, in einer Datei nach IES LM-63 (.ies) oder EULUMDAT (.ldt).</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Image angles</source>
            <translation>Bildwinkel</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Full angles of the image across and upwards.</source>
            <translation>Volle Winkel des Bildes quer und nach oben.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>A mirror in collimated light, or in the sun, throws a picture to the side.</source>
            <translation>Ein Spiegel in kollimiertem Licht oder in der Sonne wirft ein Bild zur Seite.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Mirror size</source>
            <translation>Spiegelgröße</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Full width and height of the mirror; all of it is lit.</source>
            <translation>Ganze Breite und Höhe des Spiegels; er ist ganz beleuchtet.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Full angle of the light: 0.533 for the sun, 0 for a laser.</source>
            <translation>Voller Winkel des Lichts: 0.533 bei der Sonne, 0 bei einem Laser.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>From the mirror to the middle of the image.</source>
            <translation>Vom Spiegel bis zur Mitte des Bildes.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>To the side</source>
            <translation>Zur Seite</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Angle between the light that comes and the light that goes, which has to pass the image on its way.</source>
            <translation>Winkel zwischen dem ankommenden und dem abgehenden Licht, das am Bild vorbei muss.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Experiments of the paper</source>
            <translation>Experimente der Veröffentlichung</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Designs of de Koning, Heemels, Adam and Möller (2023), to repeat or to improve on.</source>
            <translation>Entwürfe von de Koning, Heemels, Adam und Möller (2023), zum Wiederholen oder Verbessern.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Experiment</source>
            <translation>Experiment</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>A design of the paper.</source>
            <translation>Ein Entwurf der Veröffentlichung.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>How the lens is found: by the best that this program knows, on as many control points as the target needs, or as then. The 64 × 64 control points of the paper are too few for fine detail: a flame stays 19 % off.</source>
            <translation>Wie die Linse gefunden wird: mit dem Besten, was dieses Programm kennt, auf so vielen Kontrollpunkten, wie das Ziel braucht, oder wie damals. Die 64 × 64 Kontrollpunkte der Veröffentlichung sind zu wenige für feine Einzelheiten: Eine Flamme bleibt 19 % daneben.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Empty</source>
            <translation>Leer</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>A square lens in collimated light and a screen behind it; all fields are yours to change.</source>
            <translation>Eine quadratische Linse in kollimiertem Licht und ein Schirm dahinter; alle Felder lassen sich ändern.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>From {} to {}.</source>
            <translation>Von {} bis {}.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Above {} to {}.</source>
            <translation>Über {} bis {}.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>From {} to below {}.</source>
            <translation>Von {} bis unter {}.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Above {} to below {}.</source>
            <translation>Über {} bis unter {}.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>passes beside it</source>
            <translation>geht daran vorbei</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>a larger screen catches it</source>
            <translation>ein größerer Schirm fängt es auf</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>a larger far field catches it</source>
            <translation>ein größeres Fernfeld fängt es auf</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>misses the lens</source>
            <translation>verfehlt die Linse</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>a larger lens catches it</source>
            <translation>eine größere Linse fängt es auf</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>leaves by the side</source>
            <translation>tritt seitlich aus</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>a thinner lens, or a source farther away or nearer to the axis, keeps it</source>
            <translation>eine dünnere Linse, oder eine Quelle weiter weg oder näher an der Achse, hält es</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>is totally reflected</source>
            <translation>wird totalreflektiert</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>{flatter}thicker stock, a lower index or a target that needs less bending lets it out</source>
            <translation>{flatter}dickeres Material, ein kleinerer Brechungsindex oder ein Ziel, das weniger Ablenkung braucht, lässt es hinaus</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>is reflected at the entrance</source>
            <translation>wird am Eintritt reflektiert</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>an antireflection coating, a lower index or a source nearer to the axis lets it in</source>
            <translation>eine Entspiegelung, ein kleinerer Brechungsindex oder eine Quelle näher an der Achse lässt es hinein</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>is reflected at the exit</source>
            <translation>wird am Austritt reflektiert</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>an antireflection coating, {flatter}a lower index or a target that needs less bending lets it out</source>
            <translation>eine Entspiegelung, {flatter}ein kleinerer Brechungsindex oder ein Ziel, das weniger Ablenkung braucht, lässt es hinaus</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>is absorbed by the glass</source>
            <translation>wird vom Glas absorbiert</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>a thinner lens or a clearer glass lets more of it through</source>
            <translation>eine dünnere Linse oder ein klareres Glas lässt mehr davon durch</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>misses the mirror</source>
            <translation>verfehlt den Spiegel</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>a larger mirror catches it</source>
            <translation>ein größerer Spiegel fängt es auf</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>is absorbed by the mirror</source>
            <translation>wird vom Spiegel absorbiert</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>a coating with a higher reflectance reflects it</source>
            <translation>eine Beschichtung mit höherem Reflexionsgrad reflektiert es</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>misses the diffuser</source>
            <translation>verfehlt den Diffusor</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>a larger diffuser catches it</source>
            <translation>ein größerer Diffusor fängt es auf</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>is absorbed by the diffuser</source>
            <translation>wird vom Diffusor absorbiert</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>a diffuser with a higher transmittance lets it through</source>
            <translation>ein Diffusor mit höherem Transmissionsgrad lässt es durch</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>body of glass</source>
            <translation>Glaskörper</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>missing; it is required</source>
            <translation>fehlt; es wird gebraucht</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>{input} is too small; must be greater than {gt:.10g}</source>
            <translation>{input} ist zu klein; nötig ist mehr als {gt:.10g}</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>{input} is too small; at least {ge:.10g}</source>
            <translation>{input} ist zu klein; mindestens {ge:.10g}</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>{input} is too large; must be less than {lt:.10g}</source>
            <translation>{input} ist zu groß; nötig ist weniger als {lt:.10g}</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>{input} is too large; at most {le:.10g}</source>
            <translation>{input} ist zu groß; höchstens {le:.10g}</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>{input} is not available; allowed: {expected}</source>
            <translation>{input} gibt es nicht; erlaubt: {expected}</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>{input} is even; an odd number is needed</source>
            <translation>{input} ist gerade; eine ungerade Zahl ist nötig</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>{input} is not finite; a finite number is needed</source>
            <translation>{input} ist nicht endlich; eine endliche Zahl ist nötig</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>{input} is not a number; a number is needed</source>
            <translation>{input} ist keine Zahl; eine Zahl ist nötig</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>{input} is not a whole number; a whole number is needed</source>
            <translation>{input} ist keine ganze Zahl; eine ganze Zahl ist nötig</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>{input} is neither true nor false; true or false is needed</source>
            <translation>{input} ist weder true noch false; true oder false ist nötig</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>{input} is not text; text is needed</source>
            <translation>{input} ist kein Text; Text ist nötig</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>{input} is empty; some text is needed</source>
            <translation>{input} ist leer; Text ist nötig</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>{input} has other signs; letters, digits, - and _ are possible</source>
            <translation>{input} hat andere Zeichen; möglich sind Buchstaben, Ziffern, - und _</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>{input} is not a list; a list of numbers is needed</source>
            <translation>{input} ist keine Liste; eine Liste von Zahlen ist nötig</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>{input} is not an object; an object with named fields is needed</source>
            <translation>{input} ist kein Objekt; ein Objekt mit benannten Feldern ist nötig</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>not valid JSON: {error}</source>
            <translation>kein gültiges JSON: {error}</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>unknown field; known here: {fields}</source>
            <translation>unbekanntes Feld; hier bekannt: {fields}</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>{actual_length} values given; at least {min_length} are needed</source>
            <translation>{actual_length} Werte angegeben; mindestens {min_length} sind nötig</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>{actual_length} values given; exactly {max_length} are needed</source>
            <translation>{actual_length} Werte angegeben; genau {max_length} sind nötig</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>the parts emitted, greater than 0, and on_screen are needed</source>
            <translation>die Teile emitted, größer als 0, und on_screen werden benötigt</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>{input} is no part of a light account</source>
            <translation>{input} ist kein Teil einer Lichtbilanz</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>{input}: two whole numbers or 'auto' are needed</source>
            <translation>{input}: zwei ganze Zahlen oder 'auto' sind nötig</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>{input} is neither a name nor an index above 1</source>
            <translation>{input} ist weder ein Name noch eine Brechzahl über 1</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Control</source>
            <translation>Steuerung</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Control that reads the program: its preamble, path modes, dwell, decimals and end.</source>
            <translation>Steuerung, die das Programm liest: Vorspann, Bahnmodus, Verweilzeit, Nachkommastellen und Ende.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Standard ball cutter by its diameter. Empty: the cutter of the processes or limits of the design, else the largest standard cutter that fits everywhere.</source>
            <translation>Handelsüblicher Kugelfräser nach seinem Durchmesser. Leer: der Fräser der Prozesse oder Grenzen des Entwurfs, sonst der größte handelsübliche, der überall passt.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>automatic</source>
            <translation>automatisch</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Tool radius</source>
            <translation>Werkzeugradius</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Radius of another ball cutter than a standard one.</source>
            <translation>Radius eines anderen Kugelfräsers als der üblichen.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>standard</source>
            <translation>üblich</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Scallop height</source>
            <translation>Rillenhöhe</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Largest height of material between neighbouring passes. Empty: that of the step-over among the processes of the design, else 1e-4 of the larger half-width, or more where that needs too many moves.</source>
            <translation>Größte Höhe des Materials zwischen benachbarten Bahnen. Leer: die des Bahnabstands unter den Prozessen des Entwurfs, sonst 1e-4 der größeren halben Breite, oder mehr, wo das zu viele Bewegungen braucht.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Fixture rim</source>
            <translation>Spannrand</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Width of stock around the part for clamping.</source>
            <translation>Breite des Rohteils um das Teil zum Spannen.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Stock above</source>
            <translation>Aufmaß oben</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Height of stock above the highest point of the face.</source>
            <translation>Höhe des Rohteils über dem höchsten Punkt der Fläche.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Whole height of the stock. Empty: as much as part and cuts need.</source>
            <translation>Gesamte Höhe des Rohteils. Leer: so viel, wie Teil und Schnitte brauchen.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Program zero</source>
            <translation>Nullpunkt</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Place of the stock where the program's coordinates are zero.</source>
            <translation>Stelle des Rohteils, an der die Koordinaten des Programms null sind.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>middle, top of the stock</source>
            <translation>Mitte, Oberseite des Rohteils</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>corner of least x and y, top of the stock</source>
            <translation>Ecke mit kleinstem x und y, Oberseite des Rohteils</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>middle, bottom of the stock</source>
            <translation>Mitte, Unterseite des Rohteils</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Roughing</source>
            <translation>Schruppen</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Passes at levels of z that clear the stock above the face.</source>
            <translation>Schnitte auf Höhenstufen, die das Rohteil über der Fläche abtragen.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>flat cutter</source>
            <translation>Schaftfräser</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>ball cutter</source>
            <translation>Kugelfräser</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Roughing cutter</source>
            <translation>Schruppfräser</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Standard cutter of the roughing passes by its diameter. Empty: the largest one that is at most a quarter as wide as the part.</source>
            <translation>Üblicher Fräser zum Schruppen nach dem Durchmesser. Leer: der größte, der höchstens ein Viertel so breit ist wie das Teil.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Step down</source>
            <translation>Zustellung</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Distance of two levels of roughing. Empty: half of the cutter's radius.</source>
            <translation>Abstand zweier Stufen beim Schruppen. Leer: der halbe Fräserradius.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Allowance</source>
            <translation>Aufmaß</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Material that roughing leaves everywhere for finishing. Empty: a tenth of the cutter's radius.</source>
            <translation>Material, das das Schruppen überall für das Schlichten stehen lässt. Leer: ein Zehntel des Fräserradius.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Travel height</source>
            <translation>Verfahrhöhe</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Height of rapid moves above the stock and above the highest cut. Empty: 2 mm, or the ball's diameter if that is more.</source>
            <translation>Höhe der Eilgänge über dem Rohteil und über dem höchsten Schnitt. Leer: 2 mm, oder der Kugeldurchmesser, wenn er größer ist.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Feed rate while cutting.</source>
            <translation>Vorschub beim Schneiden.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Plunge feed</source>
            <translation>Eintauchvorschub</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Feed rate while plunging into the stock.</source>
            <translation>Vorschub beim Eintauchen ins Rohteil.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Spindle speed</source>
            <translation>Spindeldrehzahl</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Revolutions per minute, clockwise.</source>
            <translation>Umdrehungen je Minute, im Uhrzeigersinn.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Dwell</source>
            <translation>Verweilzeit</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Wait above the stock until the spindle has reached its speed.</source>
            <translation>Wartezeit über dem Rohteil, bis die Spindel ihre Drehzahl hat.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Coolant</source>
            <translation>Kühlmittel</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Switch flood coolant on and off.</source>
            <translation>Das Kühlmittel ein- und ausschalten.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Program number</source>
            <translation>Programmnummer</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Number of the program, where the control has numbers.</source>
            <translation>Nummer des Programms, wo die Steuerung Nummern hat.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Cut a mould of the face</source>
            <translation>Eine Form der Fläche fräsen</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Cut the negative of the face, turned over about the y axis.</source>
            <translation>Das Negativ der Fläche schneiden, um die y-Achse gewendet.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Radius of the diamond's round nose. Empty: 0.5 mm, or less where that does not fit.</source>
            <translation>Radius der runden Spitze des Diamanten. Leer: 0,5 mm, oder weniger, wo das nicht passt.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Feed per turn</source>
            <translation>Vorschub je Umdrehung</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>How far the tool moves to the axis during a turn. Empty: for cusps of 1e-5 of the larger half-width.</source>
            <translation>Weg des Werkzeugs zur Achse während einer Umdrehung. Leer: für Rillen von 1e-5 der größeren halben Breite.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Points per turn</source>
            <translation>Punkte je Umdrehung</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Points of the table for each turn. Empty: as many as keep the error between them below the chord error.</source>
            <translation>Punkte der Tabelle je Umdrehung. Leer: so viele, dass der Fehler dazwischen unter dem Sehnenfehler bleibt.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Form tolerance</source>
            <translation>Formtoleranz</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Width of the zone that holds the freeform face. Empty: the drawing states none.</source>
            <translation>Breite der Zone, in der die Freiformfläche liegt. Leer: die Zeichnung nennt keine.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Inspection points</source>
            <translation>Prüfpunkte</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Points of the face along each axis whose coordinates are listed.</source>
            <translation>Punkte der Fläche entlang jeder Achse, deren Koordinaten aufgelistet werden.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Tile side</source>
            <translation>Kachelseite</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Write only a square of the face on a flat back, this wide, as a test piece. Empty: the whole part.</source>
            <translation>Nur ein Quadrat der Fläche mit ebener Rückseite, so breit wie angegeben, als Probestück schreiben. Leer: das ganze Teil.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>whole part</source>
            <translation>ganzes Teil</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Tile x</source>
            <translation>Kachel x</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Middle of the tile along x.</source>
            <translation>Mitte der Kachel entlang x.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Tile y</source>
            <translation>Kachel y</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Middle of the tile along y.</source>
            <translation>Mitte der Kachel entlang y.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Thinnest</source>
            <translation>Dünnste Stelle</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Least thickness of the element</source>
            <translation>Kleinste Dicke des Elements</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Thickest</source>
            <translation>Dickste Stelle</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Largest thickness of the element</source>
            <translation>Größte Dicke des Elements</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Largest angle between a freeform face and a plane across the axis, in degrees</source>
            <translation>Größter Winkel zwischen einer Freiformfläche und einer Ebene quer zur Achse, in Grad</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Least radius of curvature that a tool can cut, concave or convex</source>
            <translation>Kleinster Krümmungsradius, den ein Werkzeug schneiden kann, konkav oder konvex</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Radius of the ball cutter that must fit everywhere on the face. A larger ball leaves material in hollows</source>
            <translation>Radius des Kugelfräsers, der überall auf der Fläche passen muss. Eine größere Kugel lässt Material in Mulden stehen</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Wanted error as made</source>
            <translation>Gewünschter Fehler nach Fertigung</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Relative L2 error of the image as made. Empty: 1.1 times the error as designed.</source>
            <translation>Relativer L2-Fehler des Bildes nach der Fertigung. Leer: 1,1-facher Fehler wie entworfen.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>1.1 times as designed</source>
            <translation>1,1-fach wie entworfen</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Radius of the ball cutter. Empty: the largest standard cutter that fits everywhere.</source>
            <translation>Radius des Kugelfräsers. Leer: der größte Standardfräser, der überall passt.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Polish time</source>
            <translation>Polierzeit</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Time to polish 1 cm² over a width of 0.1 mm, which grows with the square of the width. The default is an assumption.</source>
            <translation>Zeit, um 1 cm² über eine Breite von 0,1 mm zu polieren; sie wächst mit dem Quadrat der Breite. Der Standardwert ist eine Annahme.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Meaning of pixel values, unless the file has a colour profile.</source>
            <translation>Bedeutung der Pixelwerte, sofern die Datei kein Farbprofil hat.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>as shown by a monitor</source>
            <translation>wie auf einem Monitor gezeigt</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>as stored</source>
            <translation>wie gespeichert</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Unit of the measurements. Empty: that of the file, or else of the scene.</source>
            <translation>Einheit der Messungen. Leer: die der Datei, sonst die der Szene.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>of file or scene</source>
            <translation>von Datei oder Szene</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Unit of heights</source>
            <translation>Einheit der Höhen</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Unit of their heights. Empty: that of their lengths.</source>
            <translation>Einheit ihrer Höhen. Leer: die ihrer Längen.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>as lengths</source>
            <translation>wie Längen</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Determine a scale</source>
            <translation>Maßstab bestimmen</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Determine a scale (shrinkage), too.</source>
            <translation>Auch einen Maßstab (Schwund) bestimmen.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Pixel</source>
            <translation>Pixel</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Of pictures: side of a pixel. Empty: of the file.</source>
            <translation>Bei Bildern: Seite eines Pixels. Leer: die der Datei.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>of the file</source>
            <translation>der Datei</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Black</source>
            <translation>Schwarz</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Of pictures: height of black.</source>
            <translation>Bei Bildern: Höhe von Schwarz.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>White</source>
            <translation>Weiß</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Of pictures: height of white.</source>
            <translation>Bei Bildern: Höhe von Weiß.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Largest angle between lens and optical axis</source>
            <translation>Größter Winkel zwischen Linse und optischer Achse</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Largest angle between mirror and optical axis</source>
            <translation>Größter Winkel zwischen Spiegel und optischer Achse</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Decentre</source>
            <translation>Dezentrierung</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Largest distance of the lens from the axis</source>
            <translation>Größter Abstand der Linse von der Achse</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Largest distance of the mirror from the axis</source>
            <translation>Größter Abstand des Spiegels von der Achse</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Exit tilt</source>
            <translation>Austrittskippung</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Largest tilt of the exit face against the entrance</source>
            <translation>Größte Verkippung der Austrittsfläche gegen den Eintritt</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Exit decentre</source>
            <translation>Austrittsversatz</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Largest shift of the exit face over the entrance</source>
            <translation>Größter Versatz der Austrittsfläche über dem Eintritt</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Index ±</source>
            <translation>Brechzahl ±</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Largest error of the refractive index</source>
            <translation>Größter Fehler der Brechzahl</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Screen ±</source>
            <translation>Schirm ±</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Largest error of the screen's distance</source>
            <translation>Größter Fehler des Schirmabstands</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Largest tilt of the source about its middle</source>
            <translation>Größte Verkippung der Quelle um ihre Mitte</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Largest shift of the source, in any direction</source>
            <translation>Größter Versatz der Quelle, in jede Richtung</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Root mean square of the error of the exit face, or of the mirror, and the length over which it is alike: some micrometres over some millimetres when milled</source>
            <translation>Quadratisches Mittel des Fehlers der Austrittsfläche oder des Spiegels und die Länge, über die er gleich ist: einige Mikrometer über einige Millimeter, wenn gefräst</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Entrance surface</source>
            <translation>Eintrittsfläche</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>The same two of the entrance face</source>
            <translation>Dieselben beiden für die Eintrittsfläche</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>height</source>
            <translation>Höhe</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Deviation along z from the base, or of the entrance face from its place</source>
            <translation>Abweichung entlang z von der Grundform oder der Eintrittsfläche von ihrem Ort</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>slope</source>
            <translation>Neigung</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>mean curvature</source>
            <translation>mittlere Krümmung</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Mean of the principal curvatures, positive where the face is concave, negative where it is convex</source>
            <translation>Mittel der Hauptkrümmungen, positiv, wo die Fläche konkav ist, negativ, wo konvex</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Gaussian curvature</source>
            <translation>Gaußsche Krümmung</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Product of the principal curvatures: positive in a bowl and on a hump, negative on a saddle, zero where the face is bent in one direction only</source>
            <translation>Produkt der Hauptkrümmungen: positiv in einer Mulde und auf einer Kuppe, negativ auf einem Sattel, null, wo die Fläche nur in einer Richtung gebogen ist</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>largest curvature</source>
            <translation>größte Krümmung</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Larger principal curvature, positive where the face is concave, negative where it is convex; one over the smallest concave radius</source>
            <translation>Größere Hauptkrümmung, positiv, wo die Fläche konkav ist, negativ, wo konvex; Kehrwert des kleinsten konkaven Radius</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>smallest curvature</source>
            <translation>kleinste Krümmung</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Smaller principal curvature, positive where the face is concave, negative where it is convex; one over the smallest convex radius</source>
            <translation>Kleinere Hauptkrümmung, positiv, wo die Fläche konkav ist, negativ, wo konvex; Kehrwert des kleinsten konvexen Radius</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Concave curvature</source>
            <translation>Konkave Krümmung</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Convex curvature</source>
            <translation>Konvexe Krümmung</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Within limits</source>
            <translation>Grenzen eingehalten</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>No limit is set</source>
            <translation>Keine Grenze gesetzt</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>fused silica</source>
            <translation>Quarzglas</translation>
        </message>
        <message>
            <location filename="../../workbench/design/snapshot.py" />
            <source>all iterations are done</source>
            <translation>alle Iterationen sind ausgeführt</translation>
        </message>
        <message>
            <location filename="../../workbench/design/snapshot.py" />
            <source>all control points are locked</source>
            <translation>alle Kontrollpunkte sind gesperrt</translation>
        </message>
        <message>
            <location filename="../../workbench/design/snapshot.py" />
            <source>stopped</source>
            <translation>gestoppt</translation>
        </message>
        <message>
            <location filename="../../workbench/design/snapshot.py" />
            <source>goal met: error {error} of at most {goal}</source>
            <translation>Vorgabe eingehalten: Fehler {error} von höchstens {goal}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/snapshot.py" />
            <source>converged: error below {error:g} %</source>
            <translation>konvergiert: Fehler unter {error:g} %</translation>
        </message>
        <message>
            <location filename="../../workbench/design/snapshot.py" />
            <source>converged: no step makes the image better</source>
            <translation>konvergiert: kein Schritt verbessert das Bild</translation>
        </message>
        <message>
            <location filename="../../workbench/design/snapshot.py" />
            <source>converged: less than {gain:g} % better in {patience} iterations</source>
            <translation>konvergiert: weniger als {gain:g} % besser in {patience} Iterationen</translation>
        </message>
        <message>
            <location filename="../../workbench/design/snapshot.py" />
            <source>converged: error less than {points:g} percentage points lower in {patience} iterations</source>
            <translation>konvergiert: Fehler in {patience} Iterationen um weniger als {points:g} Prozentpunkte kleiner</translation>
        </message>
        <message>
            <location filename="../../workbench/design/snapshot.py" />
            <source>converged: in the light of other points of the source the image gets worse</source>
            <translation>konvergiert: im Licht anderer Punkte der Quelle wird das Bild schlechter</translation>
        </message>
        <message>
            <location filename="../../workbench/design/snapshot.py" />
            <source>{ended}; no iteration made the lens better</source>
            <translation>{ended}; keine Iteration hat die Linse verbessert</translation>
        </message>
        <message>
            <location filename="../../workbench/design/snapshot.py" />
            <source>{ended}; the exit face alone makes no image</source>
            <translation>{ended}; die Austrittsfläche allein macht kein Bild</translation>
        </message>
        <message>
            <location filename="../../workbench/design/snapshot.py" />
            <source>{ended}; after {iterations} iterations the error of both faces was {times:.2g} times that of the exit face behind a flat entrance</source>
            <translation>{ended}; nach {iterations} Iterationen war der Fehler beider Flächen {times:.2g}-mal so groß wie der der Austrittsfläche hinter einem ebenen Eintritt</translation>
        </message>
        <message>
            <location filename="../../workbench/design/snapshot.py" />
            <source>failed: {why}</source>
            <translation>gescheitert: {why}</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/by_cells.py" />
            <source>the check contradicts itself: {cells:.4g} % of the light on the receiver by cells, {rays:.4g} % by random rays; no figure of this check is reliable</source>
            <translation>die Prüfung widerspricht sich: {cells:.4g} % des Lichts auf dem Empfänger über Zellen, {rays:.4g} % mit Zufallsstrahlen; kein Wert dieser Prüfung ist verlässlich</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/by_cells.py" />
            <source>the check contradicts itself: the images by cells and by random rays are {apart:.3g} % apart, which noise and error bound do not explain; no figure of this check is reliable</source>
            <translation>die Prüfung widerspricht sich: die Bilder über Zellen und mit Zufallsstrahlen liegen {apart:.3g} % auseinander, was Rauschen und Fehlerschranke nicht erklären; kein Wert dieser Prüfung ist verlässlich</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/by_cells.py" />
            <source>the run finds {run:.4g} % of the light on the receiver, the check {check:.4g} %: use the figures of the check</source>
            <translation>der Lauf findet {run:.4g} % des Lichts auf dem Empfänger, die Prüfung {check:.4g} %: die Werte der Prüfung verwenden</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/by_cells.py" />
            <source>the image of the run is {apart:.3g} % off the image of the check: use the figures of the check</source>
            <translation>das Bild des Laufs weicht um {apart:.3g} % vom Bild der Prüfung ab: die Werte der Prüfung verwenden</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/by_cells.py" />
            <source>finer cells would take too long</source>
            <translation>feinere Zellen würden zu lange dauern</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/by_cells.py" />
            <source>that needs more rays</source>
            <translation>das braucht mehr Strahlen</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/by_cells.py" />
            <source>off by up to {off:g} %, not {wanted:.2g} %: {why}</source>
            <translation>bis zu {off:g} % daneben, nicht {wanted:.2g} %: {why}</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/cross_check.py" />
            <source>no light of this lens reaches the screen, so there is nothing to compare</source>
            <translation>kein Licht dieser Linse erreicht den Schirm, also gibt es nichts zu vergleichen</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/derivatives.py" />
            <source>{i} is no control point; 0 to {last}</source>
            <translation>{i} ist kein Kontrollpunkt; 0 bis {last}</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/derivatives.py" />
            <source>'{kind}' counts rays by pixel, which has no derivative; 'gaussian'</source>
            <translation>'{kind}' zählt Strahlen je Pixel, was keine Ableitung hat; 'gaussian'</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/derivatives.py" />
            <source>1 counts rays by pixel, which has no derivative; 3 or more</source>
            <translation>1 zählt Strahlen je Pixel, was keine Ableitung hat; 3 oder mehr</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/derivatives.py" />
            <source>no number; a number as in lens.thickness is needed</source>
            <translation>keine Zahl; eine Zahl wie in lens.thickness ist nötig</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/focus.py" />
            <source>{z:g}: light comes to the screen across the z axis, along which its distance changes; {now:g}</source>
            <translation>{z:g}: Das Licht kommt quer zur z-Achse auf den Schirm, entlang der sich sein Abstand ändert; {now:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/inspection/alignment.py" />
            <source>its points do not fit {face}: they are off by {off:.3g} and the relief of the face is {relief:.3g}; check the part, the face and the unit</source>
            <translation>ihre Punkte passen nicht zu {face}: sie weichen um {off:.3g} ab, und das Relief der Fläche ist {relief:.3g}; Teil, Fläche und Einheit prüfen</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/inspection/alignment.py" />
            <source>it is a mirror image of the face: reverse the sign of its heights</source>
            <translation>sie ist ein Spiegelbild der Fläche: das Vorzeichen ihrer Höhen umkehren</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/inspection/alignment.py" />
            <source>it is a mirror image of the face: reverse the sign of its x</source>
            <translation>sie ist ein Spiegelbild der Fläche: das Vorzeichen ihres x umkehren</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/inspection/inspection.py" />
            <source>as designed</source>
            <translation>wie entworfen</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/inspection/inspection.py" />
            <source>{face!r} is no freeform face; {known}</source>
            <translation>{face!r} ist keine Freiformfläche; {known}</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/inspection/inspection.py" />
            <source>it has another size than {face} in {old}; the unit {unit} fits</source>
            <translation>sie ist in {old} anders groß als {face}; die Einheit {unit} passt</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/inspection/inspection.py" />
            <source>its heights do not fit {face} in {old}; lengths in {unit} and heights in {up} fit</source>
            <translation>ihre Höhen passen in {old} nicht zu {face}; Längen in {unit} und Höhen in {up} passen</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/inspection/inspection.py" />
            <source>it has another size or relief than {face}, and no unit fits; check part and face</source>
            <translation>sie hat eine andere Größe oder ein anderes Relief als {face}, und keine Einheit passt; Teil und Fläche prüfen</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/inspection/residual.py" />
            <source>it covers {covered:.0f} % of {face}; at least {least:.0f} % are needed</source>
            <translation>sie bedeckt {covered:.0f} % von {face}; mindestens {least:.0f} % sind nötig</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/light_limit.py" />
            <source>{part} % meets the lens</source>
            <translation>{part} % treffen die Linse</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/light_limit.py" />
            <source>{part} % meets the mirror</source>
            <translation>{part} % treffen den Spiegel</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/light_limit.py" />
            <source>{part} % passes the faces at best</source>
            <translation>{part} % lassen die Flächen bestenfalls durch</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/light_limit.py" />
            <source>{part} % can be sent there</source>
            <translation>{part} % können dorthin gelangen</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/light_limit.py" />
            <source>{part} % fits into the étendue</source>
            <translation>{part} % passen in den Lichtleitwert</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/light_limit.py" />
            <source>{reasons}, {reason}</source>
            <translation>{reasons}, {reason}</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/light_limit.py" />
            <source>All of the light may land {place}.</source>
            <translation>Alles Licht kann {place} ankommen.</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/light_limit.py" />
            <source>At most {most} % of the light can land {place}: {reasons}.</source>
            <translation>Höchstens {most} % des Lichts können {place} ankommen: {reasons}.</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/making/photograph.py" />
            <source>the picture of this lens is not within these corners; mark those of the receiver</source>
            <translation>das Bild dieser Linse liegt nicht in diesen Ecken; markieren Sie die des Empfängers</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/making/photograph.py" />
            <source>four places x,y in pixels of the photograph are needed</source>
            <translation>vier Orte x,y in Pixeln der Fotografie werden gebraucht</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/making/photograph.py" />
            <source>are beside the photograph of {n_x} × {n_y} pixels</source>
            <translation>liegen neben der Fotografie von {n_x} × {n_y} Pixeln</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/making/photograph.py" />
            <source>make no convex quadrilateral in this order</source>
            <translation>bilden in dieser Reihenfolge kein konvexes Viereck</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/making/photograph.py" />
            <source>turned by 180°</source>
            <translation>um 180° gedreht</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/making/photograph.py" />
            <source>mirrored left to right</source>
            <translation>links-rechts gespiegelt</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/making/photograph.py" />
            <source>mirrored top to bottom</source>
            <translation>oben-unten gespiegelt</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/making/photograph.py" />
            <source>a photograph shows a plane; 'plane'</source>
            <translation>eine Fotografie zeigt eine Ebene; 'plane'</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/making/photograph.py" />
            <source>distance</source>
            <translation>Abstand</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/making/photograph.py" />
            <source>tilt about x</source>
            <translation>Neigung um x</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/making/photograph.py" />
            <source>tilt about y</source>
            <translation>Neigung um y</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/making/photograph.py" />
            <source>source size</source>
            <translation>Größe der Quelle</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/making/plan.py" />
            <source>{wanted:.3g} % as made is not reached by milling and polishing this lens; more than {least:.3g} % may be</source>
            <translation>{wanted:.3g} % nach der Fertigung erreichen Fräsen und Polieren dieser Linse nicht; mehr als {least:.3g} % sind möglich</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/making/robust.py" />
            <source>nothing is uncertain; state standard deviations, such as of distance</source>
            <translation>nichts ist unsicher; geben Sie Standardabweichungen an, etwa die des Abstands</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/mitsuba_elements.py" />
            <source>Mitsuba is given no {kind}; leave it out to compare</source>
            <translation>Mitsuba kennt {kind} nicht; zum Vergleichen weglassen</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/mitsuba_receivers.py" />
            <source>Mitsuba has no camera for {kind}; use a plane or a far field</source>
            <translation>Mitsuba hat keine Kamera für {kind}; eine Ebene oder ein Fernfeld verwenden</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/mitsuba_scatter.py" />
            <source>Mitsuba is given no scatter of kind {law}; compare without it</source>
            <translation>Mitsuba kennt die Streuung {law} nicht; ohne sie vergleichen</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/photo/light.py" />
            <source>laser of {wavelength:g} µm</source>
            <translation>Laser von {wavelength:g} µm</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/photo/light.py" />
            <source>the spectrum of the source</source>
            <translation>das Spektrum der Quelle</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/photo/light.py" />
            <source>daylight (D65)</source>
            <translation>Tageslicht (D65)</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/photo/light.py" />
            <source>white LED</source>
            <translation>weiße LED</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/photo/light.py" />
            <source>equal energy</source>
            <translation>gleiche Energie</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/photo/photo.py" />
            <source>with cells</source>
            <translation>mit Zellen</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/photo/photo.py" />
            <source>with random rays</source>
            <translation>mit Zufallsstrahlen</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/photo/photo.py" />
            <source>{side}; {light}, no dispersion known, {way}</source>
            <translation>{side}; {light}, keine Dispersion bekannt, {way}</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/photo/photo.py" />
            <source>{side}; {light}, {count} wavelengths from {first:g} to {last:g} µm, {step} pixels apart, {way}</source>
            <translation>{side}; {light}, {count} Wellenlängen von {first:g} bis {last:g} µm, {step} Pixel auseinander, {way}</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/photo/photo.py" />
            <source>no light of this lens reaches the screen, so there is nothing to see</source>
            <translation>kein Licht dieser Linse erreicht den Schirm, also gibt es nichts zu sehen</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/regions.py" />
            <source>part of the light</source>
            <translation>Anteil des Lichts</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/regions.py" />
            <source>average</source>
            <translation>Mittelwert</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/regions.py" />
            <source>minimum</source>
            <translation>Minimum</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/regions.py" />
            <source>maximum</source>
            <translation>Maximum</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/regions.py" />
            <source>U₀ (minimum / average)</source>
            <translation>U₀ (Minimum / Mittelwert)</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/regions.py" />
            <source>U₁ (minimum / maximum)</source>
            <translation>U₁ (Minimum / Maximum)</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/regions.py" />
            <source>{times:.3f} × average</source>
            <translation>{times:.3f} × Mittelwert</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/regions.py" />
            <source>{part} of the light, average {average}, minimum {least}, maximum {most}, U₀ {even}, U₁ {ends}</source>
            <translation>{part} des Lichts, Mittelwert {average}, Minimum {least}, Maximum {most}, U₀ {even}, U₁ {ends}</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/regions.py" />
            <source>whole receiver</source>
            <translation>ganzer Empfänger</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/regions.py" />
            <source>lit area of the target</source>
            <translation>heller Bereich des Ziels</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/shading.py" />
            <source>{part:.3g} % of the light</source>
            <translation>{part:.3g} % des Lichts</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/shading.py" />
            <source>{share}, most around ({x:.4g}, {y:.4g})</source>
            <translation>{share}, das meiste um ({x:.4g}, {y:.4g})</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/tolerance_fields.py" />
            <source>{angle:g} degrees change nothing: {absent}; 0</source>
            <translation>{angle:g} Grad ändern nichts: {absent}; 0</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/tolerance_fields.py" />
            <source>{size:g} changes nothing: {absent}; 0</source>
            <translation>{size:g} ändert nichts: {absent}; 0</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/tolerance_fields.py" />
            <source>{angle:g} degrees; at least 0, less than 45</source>
            <translation>{angle:g} Grad; mindestens 0, weniger als 45</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/tolerance_fields.py" />
            <source>{size:g}; a finite number from 0 is needed</source>
            <translation>{size:g}; eine endliche Zahl ab 0 ist nötig</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/tolerance_fields.py" />
            <source>a mirror has no other face</source>
            <translation>ein Spiegel hat keine andere Fläche</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/tolerance_fields.py" />
            <source>optical trains have no such error</source>
            <translation>optische Systeme haben diesen Fehler nicht</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/tolerance_fields.py" />
            <source>there is no glass</source>
            <translation>es gibt kein Glas</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/tolerance_fields.py" />
            <source>a far field is at no distance</source>
            <translation>ein Fernfeld hat keinen Abstand</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/tolerance_fields.py" />
            <source>this source lights the lens alike however it is turned</source>
            <translation>diese Quelle beleuchtet die Linse gleich, wie sie auch gedreht ist</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/tolerance_fields.py" />
            <source>even light from infinitely far is the same everywhere</source>
            <translation>gleichmäßiges Licht aus unendlicher Ferne ist überall dasselbe</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/tolerance_fields.py" />
            <source>else there may be no glass</source>
            <translation>sonst gibt es vielleicht kein Glas</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/tolerance_fields.py" />
            <source>else the screen may touch the lens</source>
            <translation>sonst kann der Schirm die Linse berühren</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/tolerance_fields.py" />
            <source>else the screen may touch the mirror</source>
            <translation>sonst kann der Schirm den Spiegel berühren</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/tolerance_fields.py" />
            <source>else the source may touch the lens</source>
            <translation>sonst kann die Quelle die Linse berühren</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/tolerance_fields.py" />
            <source>else the source may touch the mirror</source>
            <translation>sonst kann die Quelle den Spiegel berühren</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/tolerance_fields.py" />
            <source>{scale:g}; from {least:g} to {width:g}</source>
            <translation>{scale:g}; von {least:g} bis {width:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/tolerance_fields.py" />
            <source>{size:g}; at least 0, less than {limit:g}, {otherwise}</source>
            <translation>{size:g}; mindestens 0, weniger als {limit:g}, {otherwise}</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/tolerances.py" />
            <source>the exit face may come {lower:.3g} nearer to the entrance face, more than half of the least thickness {half:.3g}: less is needed</source>
            <translation>die Austrittsfläche kann der Eintrittsfläche um {lower:.3g} näher kommen, mehr als die halbe kleinste Dicke {half:.3g}: weniger ist nötig</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/tracing/trace.py" />
            <source>{rays} are too many; at most {most}</source>
            <translation>{rays} sind zu viele; höchstens {most}</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/validation.py" />
            <source>no light of this lens reaches the screen, so there is no image to judge</source>
            <translation>kein Licht dieser Linse erreicht den Schirm, also gibt es kein Bild zu beurteilen</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/validation.py" />
            <source>{what} scatters the light: random rays are used</source>
            <translation>{what} streut das Licht: Zufallsstrahlen werden verwendet</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/validation.py" />
            <source>finer cells would take too long: ask for more rays</source>
            <translation>feinere Zellen würden zu lange dauern: mehr Strahlen verlangen</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/validation.py" />
            <source>cells are off by up to {bound:.2g} %, more than random rays: ask for more rays</source>
            <translation>Zellen weichen um bis zu {bound:.2g} % ab, mehr als Zufallsstrahlen: mehr Strahlen verlangen</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/validation.py" />
            <source>so few rays of the file come to the screen that some of {parts} parts of them make no image: the check needs a file of more rays</source>
            <translation>es kommen so wenige Strahlen der Datei auf dem Schirm an, dass einige von {parts} Teilen davon kein Bild ergeben: die Prüfung braucht eine Datei mit mehr Strahlen</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/validation.py" />
            <source>so few rays of the file come to the far field that some of {parts} parts of them make no image: the check needs a file of more rays</source>
            <translation>es kommen so wenige Strahlen der Datei im Fernfeld an, dass einige von {parts} Teilen davon kein Bild ergeben: die Prüfung braucht eine Datei mit mehr Strahlen</translation>
        </message>
        <message>
            <location filename="../../workbench/design/bounds.py" />
            <source>heights within {most:.3g} {unit} of the base</source>
            <translation>Höhen bis {most:.3g} {unit} von der Grundform</translation>
        </message>
        <message>
            <location filename="../../workbench/design/checks.py" />
            <source>light grazes the far side of the screen, at {slant:.0f} degrees from across it, where the image is less exact; turn the screen towards the lens, or move its middle nearer to the axis</source>
            <translation>Licht streift die ferne Seite des Schirms, {slant:.0f} Grad von der Senkrechten, wo das Bild weniger genau ist; drehen Sie den Schirm zur Linse, oder rücken Sie seine Mitte näher an die Achse</translation>
        </message>
        <message>
            <location filename="../../workbench/design/checks.py" />
            <source>light grazes the far side of the far field, at {slant:.0f} degrees from across it, where the image is less exact; turn the far field towards the lens, or move its middle nearer to the axis</source>
            <translation>Licht streift die ferne Seite des Fernfelds, {slant:.0f} Grad von der Senkrechten, wo das Bild weniger genau ist; drehen Sie das Fernfeld zur Linse, oder rücken Sie seine Mitte näher an die Achse</translation>
        </message>
        <message>
            <location filename="../../workbench/design/checks.py" />
            <source>light grazes the far side of the screen, at {slant:.0f} degrees from across it, where the image is less exact; turn the screen towards the mirror, or move its middle nearer to the axis</source>
            <translation>Licht streift die ferne Seite des Schirms, {slant:.0f} Grad von der Senkrechten, wo das Bild weniger genau ist; drehen Sie den Schirm zum Spiegel, oder rücken Sie seine Mitte näher an die Achse</translation>
        </message>
        <message>
            <location filename="../../workbench/design/checks.py" />
            <source>light grazes the far side of the far field, at {slant:.0f} degrees from across it, where the image is less exact; turn the far field towards the mirror, or move its middle nearer to the axis</source>
            <translation>Licht streift die ferne Seite des Fernfelds, {slant:.0f} Grad von der Senkrechten, wo das Bild weniger genau ist; drehen Sie das Fernfeld zum Spiegel, oder rücken Sie seine Mitte näher an die Achse</translation>
        </message>
        <message>
            <location filename="../../workbench/design/checks.py" />
            <source>the picture is mirror-inverted for viewers on the side of the light, and reads right from behind the screen; target.viewed_from "front" turns it around</source>
            <translation>das Bild ist für Betrachter auf der Lichtseite spiegelverkehrt und von hinter dem Schirm richtig zu lesen; target.viewed_from "front" dreht es um</translation>
        </message>
        <message>
            <location filename="../../workbench/design/checks.py" />
            <source>the picture is mirror-inverted for viewers on the side of the light, and reads right from behind the far field; target.viewed_from "front" turns it around</source>
            <translation>das Bild ist für Betrachter auf der Lichtseite spiegelverkehrt und von hinter dem Fernfeld richtig zu lesen; target.viewed_from "front" dreht es um</translation>
        </message>
        <message>
            <location filename="../../workbench/design/checks.py" />
            <source>The image stays {error:.0f} % off: {n_u} × {n_v} control points are too few for the detail of this target. {finer_u} × {finer_v}, the automatic choice, can show it.</source>
            <translation>Das Bild bleibt {error:.0f} % daneben: {n_u} × {n_v} Kontrollpunkte sind zu wenige für die Einzelheiten dieses Ziels. {finer_u} × {finer_v}, die automatische Wahl, können sie zeigen.</translation>
        </message>
        <message>
            <location filename="../../workbench/design/images.py" />
            <source>mean error over {count} set-ups {error:.2f} %</source>
            <translation>mittlerer Fehler über {count} Aufbauten {error:.2f} %</translation>
        </message>
        <message>
            <location filename="../../workbench/design/lens_blur.py" />
            <source>its light is blurred over {x:.3g} × {y:.3g} pixels</source>
            <translation>das Licht ist über {x:.3g} × {y:.3g} Pixel verschmiert</translation>
        </message>
        <message>
            <location filename="../../workbench/design/limits.py" />
            <source>widen the height range, or leave it out</source>
            <translation>den Höhenbereich erweitern oder weglassen</translation>
        </message>
        <message>
            <location filename="../../workbench/design/limits.py" />
            <source>thicker stock, or a smaller minimal thickness, lets the lens bend more</source>
            <translation>mit einem dickeren Rohteil oder einer kleineren Mindestdicke kann die Linse stärker ablenken</translation>
        </message>
        <message>
            <location filename="../../workbench/design/limits.py" />
            <source>raise the base, or lower the minimal thickness</source>
            <translation>die Basis anheben oder die Mindestdicke verringern</translation>
        </message>
        <message>
            <location filename="../../workbench/design/limits.py" />
            <source>move the screen away from the lens</source>
            <translation>den Schirm von der Linse wegrücken</translation>
        </message>
        <message>
            <location filename="../../workbench/design/limits.py" />
            <source>widen the entrance range</source>
            <translation>den Eintrittsbereich erweitern</translation>
        </message>
        <message>
            <location filename="../../workbench/design/limits.py" />
            <source>The entrance face fills {part:.0f} % of its automatic range of {range} {unit}</source>
            <translation>Die Eintrittsfläche füllt {part:.0f} % ihres automatischen Bereichs von {range} {unit}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/limits.py" />
            <source>The entrance face fills {part:.0f} % of its range of {range} {unit}, and would bend more of the light in a wider one</source>
            <translation>Die Eintrittsfläche füllt {part:.0f} % ihres Bereichs von {range} {unit} und würde in einem weiteren mehr vom Licht ablenken</translation>
        </message>
        <message>
            <location filename="../../workbench/design/limits.py" />
            <source>{part:.0f} % of the control heights are at the minimal thickness of {thinnest:.3g} {unit}</source>
            <translation>{part:.0f} % der Kontrollhöhen liegen an der Mindestdicke von {thinnest:.3g} {unit}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/limits.py" />
            <source>{range} {unit} is the automatic limit</source>
            <translation>{range} {unit} ist die automatische Grenze</translation>
        </message>
        <message>
            <location filename="../../workbench/design/limits.py" />
            <source>{range} {unit} is allowed</source>
            <translation>erlaubt sind {range} {unit}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/limits.py" />
            <source>{part:.0f} % of the control heights are at an end of their range; {allowed}</source>
            <translation>{part:.0f} % der Kontrollhöhen liegen an einem Ende ihres Bereichs; {allowed}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/limits.py" />
            <source>The lens needs {range} {unit}; {allowed}</source>
            <translation>Die Linse braucht {range} {unit}; {allowed}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/limits.py" />
            <source>The mirror needs {range} {unit}; {allowed}</source>
            <translation>Der Spiegel braucht {range} {unit}; {allowed}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/limits.py" />
            <source>{thickest:.3g} {unit} is the automatic limit</source>
            <translation>{thickest:.3g} {unit} ist die automatische Grenze</translation>
        </message>
        <message>
            <location filename="../../workbench/design/limits.py" />
            <source>the screen allows {thickest:.3g} {unit}</source>
            <translation>der Schirm erlaubt {thickest:.3g} {unit}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/limits.py" />
            <source>the stock allows {thickest:.3g} {unit}</source>
            <translation>das Rohteil erlaubt {thickest:.3g} {unit}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/limits.py" />
            <source>{part:.0f} % of the control heights are at the largest thickness; {allowed}</source>
            <translation>{part:.0f} % der Kontrollhöhen liegen an der größten Dicke; {allowed}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/limits.py" />
            <source>The lens needs to be {needed:.3g} {unit} thick; {allowed}</source>
            <translation>Die Linse müsste {needed:.3g} {unit} dick sein; {allowed}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/limits.py" />
            <source>The mirror needs to be {needed:.3g} {unit} thick; {allowed}</source>
            <translation>Der Spiegel müsste {needed:.3g} {unit} dick sein; {allowed}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/limits.py" />
            <source>{sentence}: {cure}</source>
            <translation>{sentence}: {cure}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/limits.py" />
            <source>{field}: {reason}</source>
            <translation>{field}: {reason}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/limits.py" />
            <source>set {field} to a larger thickness</source>
            <translation>{field} auf eine größere Dicke setzen</translation>
        </message>
        <message>
            <location filename="../../workbench/design/limits.py" />
            <source>set {field} to a wider range</source>
            <translation>{field} auf einen weiteren Bereich setzen</translation>
        </message>
        <message>
            <location filename="../../workbench/design/limits.py" />
            <source>±{high:.3g}</source>
            <translation>±{high:.3g}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/limits.py" />
            <source>{low:.3g} to {high:.3g}</source>
            <translation>{low:.3g} bis {high:.3g}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/loss.py" />
            <source>{part:.1%} {where}</source>
            <translation>{part:.1%} {where}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/loss.py" />
            <source>no light reaches the screen: of the emitted light {went}; {cure}</source>
            <translation>kein Licht erreicht den Schirm: vom ausgesandten Licht {went}; {cure}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/loss.py" />
            <source>no light reaches the far field: of the emitted light {went}; {cure}</source>
            <translation>kein Licht erreicht das Fernfeld: vom ausgesandten Licht {went}; {cure}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/loss.py" />
            <source>the loss is {loss} although {part:.0%} of the light is on the screen</source>
            <translation>der Verlust ist {loss}, obwohl {part:.0%} des Lichts auf dem Schirm sind</translation>
        </message>
        <message>
            <location filename="../../workbench/design/loss.py" />
            <source>the gradient of the loss is not finite for {bad} of {count} parameters</source>
            <translation>der Gradient des Verlusts ist für {bad} von {count} Parametern nicht endlich</translation>
        </message>
        <message>
            <location filename="../../workbench/design/memory.py" />
            <source>memory: about {needed}</source>
            <translation>Speicher: etwa {needed}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/memory.py" />
            <source>{n_x} × {n_y} pixels with {n_u} × {n_v} control points need about {needed} of memory, and {available} are free; take fewer of both, or close other programs</source>
            <translation>{n_x} × {n_y} Pixel mit {n_u} × {n_v} Kontrollpunkten brauchen etwa {needed} Speicher, und {available} sind frei; weniger von beiden helfen, oder andere Programme zu schließen</translation>
        </message>
        <message>
            <location filename="../../workbench/design/net.py" />
            <source>'{name}' has {count:,} parameters here and needs {needed} for them, their gradient and Adam's moments; {available} are free</source>
            <translation>'{name}' hat hier {count:,} Parameter und braucht {needed} für sie, ihren Gradienten und die Momente von Adam; {available} sind frei</translation>
        </message>
        <message>
            <location filename="../../workbench/design/paper.py" />
            <source>'box' is constant within a pixel and gives the paper's method no gradient; 'gaussian'</source>
            <translation>'box' ist innerhalb eines Pixels konstant und gibt der Methode der Veröffentlichung keinen Gradienten; 'gaussian'</translation>
        </message>
        <message>
            <location filename="../../workbench/design/paper.py" />
            <source>the paper's method</source>
            <translation>die Methode der Veröffentlichung</translation>
        </message>
        <message>
            <location filename="../../workbench/design/paper.py" />
            <source>the paper's method designs for the exact set-up; method 'auto'</source>
            <translation>die Methode der Veröffentlichung entwirft für den genauen Aufbau; Methode 'auto'</translation>
        </message>
        <message>
            <location filename="../../workbench/design/run.py" />
            <source>the graphics card has too little free memory; compute on the processor, or take fewer pixels</source>
            <translation>die Grafikkarte hat zu wenig freien Speicher; rechnen Sie auf dem Prozessor, oder nehmen Sie weniger Pixel</translation>
        </message>
        <message>
            <location filename="../../workbench/design/run.py" />
            <source>none of its light goes to the lens; turn or move it</source>
            <translation>kein Licht von ihr trifft die Linse; drehen oder verschieben Sie sie</translation>
        </message>
        <message>
            <location filename="../../workbench/design/run.py" />
            <source>none of its light goes to the mirror; turn or move it</source>
            <translation>kein Licht von ihr trifft den Spiegel; drehen oder verschieben Sie sie</translation>
        </message>
        <message>
            <location filename="../../workbench/design/run.py" />
            <source>the control heights of the fixed face are missing; a file (.npy)</source>
            <translation>die Kontrollhöhen der festen Fläche fehlen; eine Datei (.npy)</translation>
        </message>
        <message>
            <location filename="../../workbench/design/run.py" />
            <source>{net} are not the control points of the finished lens that are locked; leave the stage's net out or unlock them</source>
            <translation>{net} sind nicht die Kontrollpunkte der fertigen Linse, die gesperrt sind; lassen Sie das Netz der Stufe weg, oder entsperren Sie diese</translation>
        </message>
        <message>
            <location filename="../../workbench/design/run.py" />
            <source>{net} are not the control points of the finished mirror that are locked; leave the stage's net out or unlock them</source>
            <translation>{net} sind nicht die Kontrollpunkte des fertigen Spiegels, die gesperrt sind; lassen Sie das Netz der Stufe weg, oder entsperren Sie diese</translation>
        </message>
        <message>
            <location filename="../../workbench/design/run.py" />
            <source>{why}. {limit}</source>
            <translation>{why}. {limit}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/run.py" />
            <source>stopped at iteration {iteration}: {why}</source>
            <translation>angehalten bei Iteration {iteration}: {why}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/run.py" />
            <source>control points: {n_u} × {n_v}, chosen for this task</source>
            <translation>Kontrollpunkte: {n_u} × {n_v}, für diese Aufgabe gewählt</translation>
        </message>
        <message>
            <location filename="../../workbench/design/session.py" />
            <source>it has {count} characters; 1 to {most} are needed</source>
            <translation>hat {count} Zeichen; 1 bis {most} sind nötig</translation>
        </message>
        <message>
            <location filename="../../workbench/design/session.py" />
            <source>holds no lens yet; freeform design finds one</source>
            <translation>enthält noch keine Linse; freeform design findet eine</translation>
        </message>
        <message>
            <location filename="../../workbench/design/session.py" />
            <source>its lens was designed for another task, which was edited afterwards; freeform design goes on from it</source>
            <translation>die Linse wurde für eine andere Aufgabe entworfen, die danach bearbeitet wurde; freeform design macht von ihr aus weiter</translation>
        </message>
        <message>
            <location filename="../../workbench/design/task.py" />
            <source>absent</source>
            <translation>fehlt</translation>
        </message>
        <message>
            <location filename="../../workbench/design/task.py" />
            <source>not designed yet</source>
            <translation>noch nicht entworfen</translation>
        </message>
        <message>
            <location filename="../../workbench/design/task.py" />
            <source>designed for this task</source>
            <translation>für diese Aufgabe entworfen</translation>
        </message>
        <message>
            <location filename="../../workbench/design/task.py" />
            <source>designed for another task ({run}): {differences}</source>
            <translation>für eine andere Aufgabe entworfen ({run}): {differences}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/task.py" />
            <source>not designed for this task</source>
            <translation>nicht für diese Aufgabe entworfen</translation>
        </message>
        <message>
            <location filename="../../workbench/design/task.py" />
            <source>{path} {then}, now {now}</source>
            <translation>{path} {then}, jetzt {now}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/task.py" />
            <source>another target image</source>
            <translation>ein anderes Zielbild</translation>
        </message>
        <message>
            <location filename="../../workbench/design/transport/entrance.py" />
            <source>rim</source>
            <translation>Rand</translation>
        </message>
        <message>
            <location filename="../../workbench/design/transport/entrance.py" />
            <source>left and right sides</source>
            <translation>linken und rechten Rand</translation>
        </message>
        <message>
            <location filename="../../workbench/design/transport/entrance.py" />
            <source>top and bottom</source>
            <translation>oberen und unteren Rand</translation>
        </message>
        <message>
            <location filename="../../workbench/design/transport/entrance.py" />
            <source>{part:.0f} % with a hollow one (conic of radius {radius:.3g})</source>
            <translation>{part:.0f} % mit einer hohlen (Kegelschnitt mit Radius {radius:.3g})</translation>
        </message>
        <message>
            <location filename="../../workbench/design/transport/entrance.py" />
            <source>{part:.0f} % with a freeform one</source>
            <translation>{part:.0f} % mit einer Freiformfläche</translation>
        </message>
        <message>
            <location filename="../../workbench/design/transport/entrance.py" />
            <source>{part:.0f} % with a plane entrance face</source>
            <translation>{part:.0f} % mit einer ebenen Eintrittsfläche</translation>
        </message>
        <message>
            <location filename="../../workbench/design/transport/entrance.py" />
            <source>towards the {side} of the screen deflections up to {turn:.0f} degrees are needed, of which the exit face makes less than {most:.0f}: it would reflect {part:.0f} % of the light</source>
            <translation>zum {side} des Schirms sind Ablenkungen bis {turn:.0f} Grad nötig, von denen die Austrittsfläche weniger als {most:.0f} leistet: sie würde {part:.0f} % des Lichts reflektieren</translation>
        </message>
        <message>
            <location filename="../../workbench/design/transport/entrance.py" />
            <source>towards the {side} of the far field deflections up to {turn:.0f} degrees are needed, of which the exit face makes less than {most:.0f}: it would reflect {part:.0f} % of the light</source>
            <translation>zum {side} des Fernfelds sind Ablenkungen bis {turn:.0f} Grad nötig, von denen die Austrittsfläche weniger als {most:.0f} leistet: sie würde {part:.0f} % des Lichts reflektieren</translation>
        </message>
        <message>
            <location filename="../../workbench/design/transport/entrance.py" />
            <source>{why}; a smaller or farther target needs less, and no other entrance face helps</source>
            <translation>{why}; ein kleineres oder ferneres Ziel braucht weniger, und keine andere Eintrittsfläche hilft</translation>
        </message>
        <message>
            <location filename="../../workbench/design/transport/entrance.py" />
            <source>{why}. The lens can send to its place at best: {faces}. Set {field}, or use a smaller or farther target</source>
            <translation>{why}. An ihren Ort senden kann die Linse bestenfalls: {faces}. Setzen Sie {field}, oder wählen Sie ein kleineres oder ferneres Ziel</translation>
        </message>
        <message>
            <location filename="../../workbench/design/transport/first_design.py" />
            <source>both faces</source>
            <translation>beide Flächen</translation>
        </message>
        <message>
            <location filename="../../workbench/design/transport/first_design.py" />
            <source>the exit face alone</source>
            <translation>die Austrittsfläche allein</translation>
        </message>
        <message>
            <location filename="../../workbench/design/transport/first_design.py" />
            <source>both faces along lines through all images</source>
            <translation>beide Flächen entlang von Linien durch alle Bilder</translation>
        </message>
        <message>
            <location filename="../../workbench/design/transport/first_design.py" />
            <source>the exit face behind a hollow entrance face</source>
            <translation>die Austrittsfläche hinter einer hohlen Eintrittsfläche</translation>
        </message>
        <message>
            <location filename="../../workbench/design/transport/first_design.py" />
            <source>the entrance face for image {number} alone</source>
            <translation>die Eintrittsfläche allein für Bild {number}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/transport/first_design.py" />
            <source>the exit face for image {number} alone</source>
            <translation>die Austrittsfläche allein für Bild {number}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/transport/first_design.py" />
            <source>{error} % by {face}</source>
            <translation>{error} % für {face}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/transport/first_design.py" />
            <source>first design: {tried}; it begins with {best}</source>
            <translation>erster Entwurf: {tried}; genommen: {best}</translation>
        </message>
        <message>
            <location filename="../../workbench/extended/bound.py" />
            <source>Other elements, or a tilt, change the blur</source>
            <translation>Weitere Elemente oder eine Neigung ändern die Unschärfe</translation>
        </message>
        <message>
            <location filename="../../workbench/extended/bound.py" />
            <source>Each of several images may be worse than alone</source>
            <translation>Jedes von mehreren Bildern kann schlechter sein als allein</translation>
        </message>
        <message>
            <location filename="../../workbench/extended/bound.py" />
            <source>Rays of a file need not come evenly from one place</source>
            <translation>Strahlen einer Datei müssen nicht gleichmäßig von einem Ort kommen</translation>
        </message>
        <message>
            <location filename="../../workbench/extended/bound.py" />
            <source>A lamp so near is blurred less by the rim of the lens than by its middle</source>
            <translation>Eine so nahe Lampe wird vom Rand der Linse weniger verwischt als von ihrer Mitte</translation>
        </message>
        <message>
            <location filename="../../workbench/extended/bound.py" />
            <source>A curved entrance face can make the image of the source smaller</source>
            <translation>Eine gekrümmte Eintrittsfläche kann das Bild der Quelle verkleinern</translation>
        </message>
        <message>
            <location filename="../../workbench/extended/relief_blur.py" />
            <source>relief of manufacture blurs it over {x:.3g} × {y:.3g} pixels</source>
            <translation>das Relief der Fertigung verwischt es über {x:.3g} × {y:.3g} Pixel</translation>
        </message>
        <message>
            <location filename="../../workbench/extended/scattering.py" />
            <source>light of a diffuser on {kind} cannot be computed; use a plane or a far field</source>
            <translation>Licht eines Diffusors auf {kind} kann nicht berechnet werden; eine Ebene oder ein Fernfeld verwenden</translation>
        </message>
        <message>
            <location filename="../../workbench/extended/scattering.py" />
            <source>the diffuser blurs it over {x:.3g} × {y:.3g} pixels</source>
            <translation>der Diffusor verwischt es über {x:.3g} × {y:.3g} Pixel</translation>
        </message>
        <message>
            <location filename="../../workbench/files/atomic.py" />
            <source>cannot be written: its folder does not exist</source>
            <translation>lässt sich nicht schreiben: der Ordner existiert nicht</translation>
        </message>
        <message>
            <location filename="../../workbench/files/atomic.py" />
            <source>cannot be written: {problem}</source>
            <translation>lässt sich nicht schreiben: {problem}</translation>
        </message>
        <message>
            <location filename="../../workbench/files/designs.py" />
            <source>is dark or has negative values; some light is needed</source>
            <translation>ist dunkel oder hat negative Werte; etwas Licht ist nötig</translation>
        </message>
        <message>
            <location filename="../../workbench/files/designs.py" />
            <source>{height:.5g} is no height of this lens; at most {farthest:g} {unit} from {front} are possible</source>
            <translation>{height:.5g} ist keine Höhe dieser Linse; möglich sind höchstens {farthest:g} {unit} Abstand ({front})</translation>
        </message>
        <message>
            <location filename="../../workbench/files/designs.py" />
            <source>{height:.5g} is no height of this mirror; at most {farthest:g} {unit} from {front} are possible</source>
            <translation>{height:.5g} ist keine Höhe dieses Spiegels; möglich sind höchstens {farthest:g} {unit} Abstand ({front})</translation>
        </message>
        <message>
            <location filename="../../workbench/files/designs.py" />
            <source>{value:.5g} is more than all light of the source in this pixel; {most:.5g} would be all of it</source>
            <translation>{value:.5g} ist mehr als alles Licht der Quelle in diesem Pixel; {most:.5g} wäre alles</translation>
        </message>
        <message>
            <location filename="../../workbench/files/designs.py" />
            <source>has figures of {given} further images; the scene has {others}</source>
            <translation>hat Zahlen von {given} weiteren Bildern; die Szene hat {others}</translation>
        </message>
        <message>
            <location filename="../../workbench/files/designs.py" />
            <source>has {count} losses; stages cannot have begun after {starts}</source>
            <translation>hat {count} Verlustwerte; Stufen können nicht nach {starts} begonnen haben</translation>
        </message>
        <message>
            <location filename="../../workbench/files/entries.py" />
            <source>holds a value that is NaN or infinite; finite values are needed</source>
            <translation>enthält einen Wert, der NaN oder unendlich ist; endliche Werte sind nötig</translation>
        </message>
        <message>
            <location filename="../../workbench/files/entries.py" />
            <source>holds a value that is neither 0 nor 1; false or true is needed</source>
            <translation>enthält einen Wert, der weder 0 noch 1 ist; falsch oder wahr ist nötig</translation>
        </message>
        <message>
            <location filename="../../workbench/files/entries.py" />
            <source>holds {dtype}; {kind} is needed</source>
            <translation>enthält {dtype}; {kind} ist nötig</translation>
        </message>
        <message>
            <location filename="../../workbench/files/entries.py" />
            <source>has shape {found}; the scene needs {shape}</source>
            <translation>hat die Form {found}; die Szene braucht {shape}</translation>
        </message>
        <message>
            <location filename="../../workbench/files/entries.py" />
            <source>is in Fortran order; C order is needed</source>
            <translation>ist in Fortran-Reihenfolge; C-Reihenfolge ist nötig</translation>
        </message>
        <message>
            <location filename="../../workbench/files/entries.py" />
            <source>has {given} bytes of values; shape {shape} needs {size}</source>
            <translation>hat {given} Bytes an Werten; die Form {shape} braucht {size}</translation>
        </message>
        <message>
            <location filename="../../workbench/files/entries.py" />
            <source>is no .npy array: its header cannot be read</source>
            <translation>ist kein .npy-Array: der Kopf lässt sich nicht lesen</translation>
        </message>
        <message>
            <location filename="../../workbench/files/entries.py" />
            <source>does not belong into this session</source>
            <translation>gehört nicht in diese Sitzung</translation>
        </message>
        <message>
            <location filename="../../workbench/files/entries.py" />
            <source>holds an entry twice; each must be there once</source>
            <translation>enthält einen Eintrag doppelt; jeder muss einmal da sein</translation>
        </message>
        <message>
            <location filename="../../workbench/files/entries.py" />
            <source>is cut off</source>
            <translation>ist abgeschnitten</translation>
        </message>
        <message>
            <location filename="../../workbench/files/entries.py" />
            <source>holds entries that overlap; each has bytes of its own</source>
            <translation>enthält Einträge, die sich überlappen; jeder hat eigene Bytes</translation>
        </message>
        <message>
            <location filename="../../workbench/files/entries.py" />
            <source>is missing; a session holds it</source>
            <translation>fehlt; eine Sitzung enthält es</translation>
        </message>
        <message>
            <location filename="../../workbench/files/entries.py" />
            <source>is compressed or encrypted; sessions store entries as they are</source>
            <translation>ist komprimiert oder verschlüsselt; Sitzungen speichern Einträge, wie sie sind</translation>
        </message>
        <message>
            <location filename="../../workbench/files/entries.py" />
            <source>has {size} bytes; at most {largest} are possible</source>
            <translation>hat {size} Bytes; höchstens {largest} sind möglich</translation>
        </message>
        <message>
            <location filename="../../workbench/files/entries.py" />
            <source>is a damaged or incomplete zip: {detail}</source>
            <translation>ist ein beschädigtes oder unvollständiges ZIP: {detail}</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/cut_plan.py" />
            <source>a ball cutter of {radius} does not fit: it leaves {left} at x = {x}, y = {y} and cuts off {cut}; {cure}</source>
            <translation>ein Kugelfräser von {radius} passt nicht: er lässt bei x = {x}, y = {y} {left} stehen und nimmt {cut} zu viel weg; {cure}</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/cut_plan.py" />
            <source>one of {fitting} fits</source>
            <translation>einer von {fitting} passt</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/cut_plan.py" />
            <source>a smaller one or higher ridges are needed</source>
            <translation>ein kleinerer oder höhere Rillen werden gebraucht</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/cut_plan.py" />
            <source>a cutter of {radius} is wider than the part; at most {half}</source>
            <translation>ein Fräser von {radius} ist breiter als das Teil; höchstens {half}</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/cut_plan.py" />
            <source>{stock} is too thin for the part; at least {needed}</source>
            <translation>{stock} ist zu dünn für das Teil; mindestens {needed}</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/cut_plan.py" />
            <source>{stock} is too thin: cuts at the rim go {deep} deep; at least that</source>
            <translation>{stock} ist zu dünn: Schnitte am Rand gehen {deep} tief; mindestens so viel</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/cut_plan.py" />
            <source>{step} makes {levels:,.0f} levels, more than a program holds; a larger one</source>
            <translation>{step} ergibt {levels:,.0f} Stufen, mehr als ein Programm fasst; ein größerer Wert</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/design.py" />
            <source>{side:g} {unit} about ({x:g}, {y:g}) is not within the lens</source>
            <translation>{side:g} {unit} um ({x:g}, {y:g}) liegt nicht innerhalb der Linse</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/design.py" />
            <source>{side:g} {unit} about ({x:g}, {y:g}) is not within the mirror</source>
            <translation>{side:g} {unit} um ({x:g}, {y:g}) liegt nicht innerhalb des Spiegels</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/design.py" />
            <source>a conic front face of the designed element is not exported; a plane one</source>
            <translation>eine Kegelschnitt-Vorderseite des entworfenen Elements wird nicht exportiert; eine ebene</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/far_light.py" />
            <source>no light leaves its {body}, so that it has no intensity</source>
            <translation>kein Licht verlässt den {body}, also gibt es keine Lichtstärke</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/formats.py" />
            <source>has no known ending; use one of {endings}</source>
            <translation>hat keine bekannte Endung; möglich: {endings}</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/iges.py" />
            <source>needs OpenCASCADE, which pip install 'freeform-lens-workbench[iges]' brings</source>
            <translation>braucht OpenCASCADE, das pip install 'freeform-lens-workbench[iges]' bringt</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/iges.py" />
            <source>OpenCASCADE could not turn the shape into IGES</source>
            <translation>OpenCASCADE konnte die Form nicht in IGES umwandeln</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/iges.py" />
            <source>OpenCASCADE could not write the IGES file</source>
            <translation>OpenCASCADE konnte die IGES-Datei nicht schreiben</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/iges.py" />
            <source>OpenCASCADE could not read the {ending} file again</source>
            <translation>OpenCASCADE konnte die {ending}-Datei nicht wieder lesen</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/iges.py" />
            <source>OpenCASCADE finds no B-spline face in the IGES file that it wrote</source>
            <translation>OpenCASCADE findet in der IGES-Datei, die es geschrieben hat, keine B-Spline-Fläche</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/options.py" />
            <source>a standard cutter is chosen as well; give one of them</source>
            <translation>ein üblicher Fräser ist auch gewählt; einen von beiden angeben</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/options.py" />
            <source>{ridge:g}; less than the cutter's radius {radius:g} is needed</source>
            <translation>{ridge:g}; weniger als der Fräserradius {radius:g} ist nötig</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/options.py" />
            <source>{unit}; one of {known}</source>
            <translation>{unit}; eine von {known}</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/tessellation.py" />
            <source>{largest:.3g} {unit} is finer than the numbers of this format; at least {least:.3g}</source>
            <translation>{largest:.3g} {unit} ist feiner als die Zahlen dieses Formats; mindestens {least:.3g}</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/tessellation.py" />
            <source>{largest:.3g} {unit} takes {triangles:.0f} triangles, more than {most}; about {possible:.2g} is possible</source>
            <translation>{largest:.3g} {unit} braucht {triangles:.0f} Dreiecke, mehr als {most}; etwa {possible:.2g} ist möglich</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/turning.py" />
            <source>{feed} takes {points:,} points, more than {most:,}; a larger one, or fewer points per turn</source>
            <translation>{feed} braucht {points:,} Punkte, mehr als {most:,}; ein größerer Wert, oder weniger Punkte je Umdrehung</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/turning.py" />
            <source>a nose of {radius} does not fit: it cuts off {cut}; a smaller one</source>
            <translation>eine Spitze von {radius} passt nicht: sie schneidet {cut} ab; eine kleinere</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/write.py" />
            <source>the entrance face is not freeform, so it has no file</source>
            <translation>die Eintrittsfläche ist keine Freiformfläche und hat keine Datei</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/write.py" />
            <source>{name} is no designed element; {names}</source>
            <translation>{name} ist kein entworfenes Element; {names}</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/write.py" />
            <source>{reason}; {path}: {other}</source>
            <translation>{reason}; {path}: {other}</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/write.py" />
            <source>{path}: {reason}</source>
            <translation>{path}: {reason}</translation>
        </message>
        <message>
            <location filename="../../workbench/files/header.py" />
            <source>{version} is of a newer Freeform Lens Workbench, at most {most} can be read here; update the program</source>
            <translation>{version} ist von einer neueren Freeform Lens Workbench, höchstens {most} lässt sich hier lesen; das Programm aktualisieren</translation>
        </message>
        <message>
            <location filename="../../workbench/files/header.py" />
            <source>{count} are given; at most {most} are kept</source>
            <translation>{count} sind gegeben; höchstens {most} werden aufbewahrt</translation>
        </message>
        <message>
            <location filename="../../workbench/files/header.py" />
            <source>cannot be kept as JSON: {error}</source>
            <translation>lässt sich nicht als JSON aufbewahren: {error}</translation>
        </message>
        <message>
            <location filename="../../workbench/files/header.py" />
            <source>takes {size} bytes; at most {most} are kept</source>
            <translation>braucht {size} Bytes; höchstens {most} werden aufbewahrt</translation>
        </message>
        <message>
            <location filename="../../workbench/files/header.py" />
            <source>is nested too deeply; at most {most} levels are kept</source>
            <translation>ist zu tief verschachtelt; höchstens {most} Ebenen werden aufbewahrt</translation>
        </message>
        <message>
            <location filename="../../workbench/files/scene.py" />
            <source>is no scene: it has more than {most} bytes</source>
            <translation>ist keine Szene: mehr als {most} Bytes</translation>
        </message>
        <message>
            <location filename="../../workbench/files/scene.py" />
            <source>is neither a session nor a scene in UTF-8 text</source>
            <translation>ist weder eine Sitzung noch eine Szene als UTF-8-Text</translation>
        </message>
        <message>
            <location filename="../../workbench/files/scene.py" />
            <source>{name!r} is no text and cannot be kept in one</source>
            <translation>{name!r} ist kein Text und lässt sich nicht in einem aufbewahren</translation>
        </message>
        <message>
            <location filename="../../workbench/files/scene.py" />
            <source>is given twice; each field can be there once</source>
            <translation>ist doppelt angegeben; jedes Feld kann einmal da sein</translation>
        </message>
        <message>
            <location filename="../../workbench/files/session.py" />
            <source>its text would have {size} bytes; at most {most} can be read</source>
            <translation>der Text hätte {size} Bytes; höchstens {most} lassen sich lesen</translation>
        </message>
        <message>
            <location filename="../../workbench/files/session.py" />
            <source>is no session: it does not begin like a zip</source>
            <translation>ist keine Sitzung: der Anfang ist nicht der eines ZIP</translation>
        </message>
        <message>
            <location filename="../../workbench/files/session.py" />
            <source>would hold {count} kept runs; at most {most}</source>
            <translation>enthielte {count} aufbewahrte Läufe; höchstens {most}</translation>
        </message>
        <message>
            <location filename="../../workbench/geometry/as_made.py" />
            <source>a diffuser</source>
            <translation>ein Diffusor</translation>
        </message>
        <message>
            <location filename="../../workbench/geometry/as_made.py" />
            <source>the relief that manufacture leaves</source>
            <translation>das Relief, das die Fertigung hinterlässt</translation>
        </message>
        <message>
            <location filename="../../workbench/geometry/ball_cutter.py" />
            <source>{scallop:.2g} takes {moves:,} moves of this cutter, more than {most:,}; a larger one</source>
            <translation>{scallop:.2g} braucht {moves:,} Wege dieses Fräsers, mehr als {most:,}; eine größere</translation>
        </message>
        <message>
            <location filename="../../workbench/geometry/body.py" />
            <source>its {face} is at z = {z:.5g} {unit} at x = {x:.4g}, y = {y:.4g}, not {limit} at z = {end:g}: that is no {body}</source>
            <translation>{face}: z = {z:.5g} {unit} bei x = {x:.4g}, y = {y:.4g}, nicht {limit} bei z = {end:g}: so gibt es keinen {body}</translation>
        </message>
        <message>
            <location filename="../../workbench/geometry/body.py" />
            <source>above {front}</source>
            <translation>über: {front}</translation>
        </message>
        <message>
            <location filename="../../workbench/geometry/body.py" />
            <source>before the screen</source>
            <translation>vor dem Schirm</translation>
        </message>
        <message>
            <location filename="../../workbench/geometry/body.py" />
            <source>above the screen and the source</source>
            <translation>über Schirm und Quelle</translation>
        </message>
        <message>
            <location filename="../../workbench/geometry/body.py" />
            <source>below all</source>
            <translation>unter allem</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/lenses.py" />
            <source>more than {least:g}, as light fades</source>
            <translation>mehr als {least:g}, da das Licht abnimmt</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>Estimate</source>
            <translation>Schätzung</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>estimating…</source>
            <translation>Schätzung läuft …</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>From a coarse design of this task.</source>
            <translation>Aus einem groben Entwurf dieser Aufgabe.</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>No flux arrives in a coarse design of this task.</source>
            <translation>In einem groben Entwurf dieser Aufgabe kommt kein Fluss an.</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>Only designs by the automatic method are estimated.</source>
            <translation>Nur Entwürfe nach der automatischen Methode werden geschätzt.</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>not known</source>
            <translation>nicht bekannt</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>error {error}, {light:.0f} % of the light {place}</source>
            <translation>Fehler {error}, {light:.0f} % des Lichts {place}</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>From a coarse design of this task, with losses and source size.</source>
            <translation>Aus einem groben Entwurf dieser Aufgabe, mit Verlusten und Quellgröße.</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>Finest detail</source>
            <translation>Feinstes Detail</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>The source has no size.</source>
            <translation>Die Quelle hat keine Ausdehnung.</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>{across:.0f} × {up:.0f} dots in the image.</source>
            <translation>{across:.0f} × {up:.0f} Punkte im Bild.</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>√(λ · distance)</source>
            <translation>√(λ · Abstand)</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>λ / width of the lens</source>
            <translation>λ / Breite der Linse</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>Diffraction</source>
            <translation>Beugung</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>{law}: limit of sharpness, which ray tracing does not include.</source>
            <translation>{law}: Grenze der Schärfe, die Raytracing nicht enthält.</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>Largest slope</source>
            <translation>Größte Neigung</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>{slope:.0f}°, deflection up to {turn:.0f}°</source>
            <translation>{slope:.0f}°, Ablenkung bis {turn:.0f}°</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>a deflection of {turn:.0f}° would be needed</source>
            <translation>eine Ablenkung von {turn:.0f}° wäre nötig</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>The lens deflects by {most:.0f}° at most. Use a smaller image, more distance or another source position.</source>
            <translation>Die Linse lenkt um höchstens {most:.0f}° ab. Ein kleineres Bild, mehr Abstand oder eine andere Quellposition verwenden.</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>The mirror deflects by {most:.0f}° at most. Use a smaller image, more distance or another source position.</source>
            <translation>Der Spiegel lenkt um höchstens {most:.0f}° ab. Ein kleineres Bild, mehr Abstand oder eine andere Quellposition verwenden.</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>Near the limit of {most:.0f}° much light is reflected.</source>
            <translation>Nahe der Grenze von {most:.0f}° wird viel Licht reflektiert.</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>Limit of the deflection: {most:.0f}°.</source>
            <translation>Grenze der Ablenkung: {most:.0f}°.</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>up to {slant:.0f}°</source>
            <translation>bis {slant:.0f}°</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>Light on the screen</source>
            <translation>Licht auf dem Schirm</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>{sentence}.</source>
            <translation>{sentence}.</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>Light on the lens</source>
            <translation>Licht auf der Linse</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>Light on the mirror</source>
            <translation>Licht auf dem Spiegel</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>{part:.0f} % of it</source>
            <translation>{part:.0f} % davon</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>The rest passes it by: a lamp that is nearer, or a larger lens, catches more.</source>
            <translation>Der Rest geht vorbei: eine nähere Lampe oder eine größere Linse fängt mehr.</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>The rest passes it by: a lamp that is nearer, or a larger mirror, catches more.</source>
            <translation>Der Rest geht vorbei: eine nähere Lampe oder ein größerer Spiegel fängt mehr.</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>The rest misses the lens or is lost at its faces.</source>
            <translation>Der Rest verfehlt die Linse oder geht an ihren Flächen verloren.</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>The rest misses the mirror or is lost at its faces.</source>
            <translation>Der Rest verfehlt den Spiegel oder geht an seiner Fläche verloren.</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>No more can land where the picture is bright: the light's own image is larger.</source>
            <translation>Mehr kann nicht dort landen, wo das Bild hell ist: das Bild der Lichtquelle selbst ist größer.</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>Light at best</source>
            <translation>Licht bestenfalls</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>at most {part:.0f} %</source>
            <translation>höchstens {part:.0f} %</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>Error at best</source>
            <translation>Kleinstmöglicher Fehler</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>The lens cannot turn all the light that far.</source>
            <translation>Die Linse kann nicht alles Licht so weit ablenken.</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>The mirror cannot turn all the light that far.</source>
            <translation>Der Spiegel kann nicht alles Licht so weit ablenken.</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>The size of the light sets no bound.</source>
            <translation>Die Größe der Lichtquelle setzt keine Schranke.</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>not known; {error} for the light found</source>
            <translation>nicht bekannt; {error} mit dem gefundenen Licht</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>The light is small enough for this picture.</source>
            <translation>Die Lichtquelle ist klein genug für dieses Bild.</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>No lens of this size can be below it; a smaller or farther lamp would help.</source>
            <translation>Keine Linse dieser Größe kann darunter liegen; eine kleinere oder fernere Lampe würde helfen.</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>{n_u} × {n_v} control points, {n_x} × {n_y} pixels</source>
            <translation>{n_u} × {n_v} Kontrollpunkte, {n_x} × {n_y} Pixel</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>{height:.3g} {unit} thick, {net}</source>
            <translation>{height:.3g} {unit} dick, {net}</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>Proposed</source>
            <translation>Vorschlag</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>Can be changed later in the window.</source>
            <translation>Lässt sich später im Fenster ändern.</translation>
        </message>
        <message>
            <location filename="../../workbench/materials.py" />
            <source>{name} is not in the catalogue; known: {known}</source>
            <translation>{name} ist nicht im Katalog; bekannt: {known}</translation>
        </message>
        <message>
            <location filename="../../workbench/materials.py" />
            <source>{wavelength:g} is outside the data for {name}; {low:g} to {high:g}</source>
            <translation>{wavelength:g} liegt außerhalb der Daten für {name}; {low:g} bis {high:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/lamps.py" />
            <source>missing; '{file}' does not name its unit</source>
            <translation>fehlt; „{file}“ nennt keine Einheit</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/lamps.py" />
            <source>'{file}' gives the lens no light: {error}</source>
            <translation>„{file}“ gibt der Linse kein Licht: {error}</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/lamps.py" />
            <source>'{file}' {reason}</source>
            <translation>„{file}“ {reason}</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/lamps.py" />
            <source>{value} {unit}</source>
            <translation>{value} {unit}</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/photometry/__init__.py" />
            <source>is no photometric file; {endings} is needed</source>
            <translation>ist keine photometrische Datei; {endings} ist nötig</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/photometry/ies.py" />
            <source>it has no line that begins with TILT=, as each IES file has</source>
            <translation>ihr fehlt die Zeile, die mit TILT= beginnt, wie sie jede IES-Datei hat</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/photometry/ies.py" />
            <source>its TILT is in another file, {file!r}; NONE or INCLUDE is needed</source>
            <translation>ihr TILT steht in einer anderen Datei, {file!r}; nötig ist NONE oder INCLUDE</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/photometry/ies.py" />
            <source>it ends behind its TILT</source>
            <translation>sie endet nach ihrem TILT</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/photometry/ies.py" />
            <source>its version is {found!r}; known are {known}</source>
            <translation>ihre Version ist {found!r}; bekannt sind {known}</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/photometry/ies.py" />
            <source>it is cut off: {n} of 13 numbers stand before its angles</source>
            <translation>sie ist abgeschnitten: vor ihren Winkeln stehen {n} von 13 Zahlen</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/photometry/ies.py" />
            <source>{problem}: its header makes {needed} numbers, and there are {found}</source>
            <translation>{problem}: ihr Kopf verlangt {needed} Zahlen, und da sind {found}</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/photometry/ies.py" />
            <source>it is cut off within {part}</source>
            <translation>sie ist abgeschnitten in diesem Teil: {part}</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/photometry/ies.py" />
            <source>its TILT</source>
            <translation>TILT</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/photometry/ldt.py" />
            <source>it is cut off: {found} of at least {least} lines are there</source>
            <translation>sie ist abgeschnitten: von mindestens {least} Zeilen sind {found} da</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/photometry/ldt.py" />
            <source>its lamps</source>
            <translation>ihre Lampen</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/photometry/ldt.py" />
            <source>{problem}: its header makes {needed} numbers behind the lamps, and there are {found}</source>
            <translation>{problem}: ihr Kopf verlangt {needed} Zahlen nach den Lampen, und da sind {found}</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/photometry/ldt.py" />
            <source>its symmetry is {symmetry} and it has {n} planes of C; a multiple of {parts} is needed</source>
            <translation>ihre Symmetrie ist {symmetry}, und sie hat {n} C-Ebenen; nötig ist ein Vielfaches von {parts}</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/photometry/table.py" />
            <source>it has a single angle γ; at least two are needed</source>
            <translation>sie hat einen einzigen Winkel γ; nötig sind mindestens zwei</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/photometry/table.py" />
            <source>its angles {name} do not ascend</source>
            <translation>ihre Winkel {name} steigen nicht an</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/photometry/table.py" />
            <source>its angles γ go from {first:g}° to {last:g}°; within 0° to 180°</source>
            <translation>ihre Winkel γ gehen von {first:g}° bis {last:g}°; erlaubt ist 0° bis 180°</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/photometry/table.py" />
            <source>it has an intensity of {least:g} cd; none can be negative</source>
            <translation>sie hat eine Lichtstärke von {least:g} cd; keine kann negativ sein</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/photometry/table.py" />
            <source>it gives no light: all its intensities are 0</source>
            <translation>sie gibt kein Licht: alle ihre Lichtstärken sind 0</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/photometry/table.py" />
            <source>its largest intensity is {largest:.3g} cd; from {least:g} to {most:g} cd can be used</source>
            <translation>ihre größte Lichtstärke ist {largest:.3g} cd; verwendbar sind {least:g} bis {most:g} cd</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/photometry/table.py" />
            <source>intensities below 0 count as 0: {count}, the least is {least:g} cd</source>
            <translation>Lichtstärken unter 0 zählen als 0: {count}, die kleinste ist {least:g} cd</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/photometry/table.py" />
            <source>its planes of C go from {first:g}° to {last:g}°, which is no known symmetry</source>
            <translation>ihre C-Ebenen gehen von {first:g}° bis {last:g}°; das ist keine bekannte Symmetrie</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/photometry/table.py" />
            <source>it has a single angle {name}; two are needed</source>
            <translation>sie hat nur einen Winkel {name}; zwei werden gebraucht</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/photometry/table.py" />
            <source>its angles {name} go from {first:g}° to {last:g}°; they have to ascend within −{most}° to {most}°</source>
            <translation>ihre Winkel {name} gehen von {first:g}° bis {last:g}°; sie müssen innerhalb von −{most}° bis {most}° ansteigen</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/rays/__init__.py" />
            <source>is no ray file; {endings} are known</source>
            <translation>ist keine Strahlendatei; bekannt sind {endings}</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/rays/__init__.py" />
            <source>cannot be used: {problem}</source>
            <translation>lässt sich nicht verwenden: {problem}</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/rays/model.py" />
            <source>{points} points stand for the rays of the file: {off:.1f} % of their light on the lens is elsewhere, and rays start {spread:.0f} % as far from their point as from the middle of all</source>
            <translation>{points} Punkte stehen für die Strahlen der Datei: {off:.1f} % ihres Lichts auf der Linse liegen woanders, und Strahlen beginnen {spread:.0f} % so weit von ihrem Punkt wie von der Mitte aller</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/rays/model.py" />
            <source>no ray of it comes to the lens</source>
            <translation>kein Strahl daraus kommt zur Linse</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/rays/opticstudio.py" />
            <source>it begins neither like a binary source file nor like one of text</source>
            <translation>sie beginnt weder wie eine binäre Quelldatei noch wie eine aus Text</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/rays/opticstudio.py" />
            <source>its first line says {rays} rays, and there are {found}</source>
            <translation>ihre erste Zeile nennt {rays} Strahlen, und da sind {found}</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/rays/opticstudio.py" />
            <source>its header</source>
            <translation>Kopf</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/rays/opticstudio.py" />
            <source>its rays are of format {found}; 0 or 2 is known</source>
            <translation>ihre Strahlen haben das Format {found}; bekannt sind 0 und 2</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/rays/opticstudio.py" />
            <source>its unit is {found}; 0 to {most} are known</source>
            <translation>ihre Einheit ist {found}; bekannt sind 0 bis {most}</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/rays/opticstudio.py" />
            <source>its header says {rays} rays, and the {left} bytes behind it are {found:.10g} of them</source>
            <translation>ihr Kopf nennt {rays} Strahlen, und die {left} Bytes danach sind {found:.10g} davon</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/rays/rayset.py" />
            <source>it has no rays</source>
            <translation>sie hat keine Strahlen</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/rays/rayset.py" />
            <source>none of its rays has any flux</source>
            <translation>keiner ihrer Strahlen hat Lichtstrom</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/rays/rayset.py" />
            <source>a ray has a spectrum that is none of the {n} there are</source>
            <translation>ein Strahl hat ein Spektrum, das keines der {n} vorhandenen ist</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/rays/rayset.py" />
            <source>its ray {ray} has a value that is no finite number</source>
            <translation>ihr Strahl {ray} hat einen Wert, der keine endliche Zahl ist</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/rays/rayset.py" />
            <source>its ray {ray} has a direction that is no unit vector</source>
            <translation>ihr Strahl {ray} hat eine Richtung, die kein Einheitsvektor ist</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/rays/rayset.py" />
            <source>its ray {ray} has a negative flux</source>
            <translation>ihr Strahl {ray} hat negativen Lichtstrom</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/rays/rayset.py" />
            <source>it is cut off behind ray {ray}</source>
            <translation>sie ist nach Strahl {ray} abgeschnitten</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/rays/table.py" />
            <source>its first ray has {n} numbers; 7, or 8 with a wavelength</source>
            <translation>ihr erster Strahl hat {n} Zahlen; es sind 7, oder 8 mit Wellenlänge</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/rays/table.py" />
            <source>it has a line without an end</source>
            <translation>sie hat eine Zeile ohne Ende</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/rays/table.py" />
            <source>it is no text</source>
            <translation>sie ist kein Text</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/rays/table.py" />
            <source>behind ray {ray} it has no rays: {reason}</source>
            <translation>nach Strahl {ray} kommen keine Strahlen: {reason}</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/rays/table.py" />
            <source>behind ray {ray} it has {found} columns; {width} as above</source>
            <translation>nach Strahl {ray} hat sie {found} Spalten; nötig sind {width} wie oben</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/rays/tm25.py" />
            <source>it does not begin with TM25</source>
            <translation>sie beginnt nicht mit TM25</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/rays/tm25.py" />
            <source>it is of version {found}; {known} is known</source>
            <translation>sie hat die Version {found}; bekannt ist {known}</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/rays/tm25.py" />
            <source>its header says {rays} rays of {width} numbers, and the {left} bytes behind it are {found:.10g} of them</source>
            <translation>ihr Kopf nennt {rays} Strahlen zu {width} Zahlen, und die {left} Bytes danach sind {found:.10g} davon</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/rays/tm25.py" />
            <source>the flags of its columns are {found}; 1, 1 and then 0 or 1</source>
            <translation>die Kennzeichen ihrer Spalten sind {found}; nötig sind 1, 1 und dann 0 oder 1</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/rays/tm25.py" />
            <source>its header says {n} spectra; from 0 to {most}</source>
            <translation>ihr Kopf nennt {n} Spektren; erlaubt sind 0 bis {most}</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/rays/tm25.py" />
            <source>its spectra</source>
            <translation>Spektren</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/rays/tm25.py" />
            <source>one of its spectra has {n} points; from 1 to {most}</source>
            <translation>eines ihrer Spektren hat {n} Punkte; erlaubt sind 1 bis {most}</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/rays/tm25.py" />
            <source>its header says {value} for "{name}"; from 0 to {most}</source>
            <translation>ihr Kopf nennt {value} für "{name}"; erlaubt sind 0 bis {most}</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/surfaces/__init__.py" />
            <source>is no measured surface; {endings} are known</source>
            <translation>ist keine gemessene Fläche; bekannt sind {endings}</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/surfaces/esri.py" />
            <source>its header has no ncols, nrows and cellsize</source>
            <translation>ihrem Kopf fehlen ncols, nrows und cellsize</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/surfaces/esri.py" />
            <source>it has {found} heights; {columns} × {rows} are needed</source>
            <translation>sie hat {found} Höhen; {columns} × {rows} sind nötig</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/surfaces/picture.py" />
            <source>it is damaged or incomplete: {why}</source>
            <translation>sie ist beschädigt oder unvollständig: {why}</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/surfaces/picture.py" />
            <source>it has {mode} pixels; grey of 16 bits or floats are needed</source>
            <translation>sie hat Pixel der Art {mode}; Grau mit 16 Bit oder Gleitkommazahlen sind nötig</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/surfaces/picture.py" />
            <source>it has no scale; give the size of a pixel and the heights</source>
            <translation>sie hat keinen Maßstab; Pixelgröße und Höhen angeben</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/surfaces/points.py" />
            <source>it has {count} points with a height; at least {least} are needed</source>
            <translation>sie hat {count} Punkte mit einer Höhe; mindestens {least} sind nötig</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/surfaces/points.py" />
            <source>it has {columns} × {rows} points; 1 to {most} million are possible</source>
            <translation>sie hat {columns} × {rows} Punkte; möglich sind 1 bis {most} Millionen</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/surfaces/sdf.py" />
            <source>it begins neither with aISO-1.0 nor with bISO-1.0</source>
            <translation>sie beginnt weder mit aISO-1.0 noch mit bISO-1.0</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/surfaces/sdf.py" />
            <source>it is compressed; save it without compression</source>
            <translation>sie ist komprimiert; ohne Kompression speichern</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/surfaces/sdf.py" />
            <source>its DataType is {found}; 0 to 7 are known</source>
            <translation>ihr DataType ist {found}; bekannt sind 0 bis 7</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/surfaces/sdf.py" />
            <source>it is cut off</source>
            <translation>sie ist abgeschnitten</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/surfaces/sdf.py" />
            <source>it has no line * behind its header</source>
            <translation>ihr fehlt die Zeile * nach dem Kopf</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/surfaces/sdf.py" />
            <source>its header has no {name}</source>
            <translation>ihrem Kopf fehlt {name}</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/surfaces/sdf.py" />
            <source>its Xscale, Yscale and Zscale are not all greater than 0</source>
            <translation>ihre Xscale, Yscale und Zscale sind nicht alle größer als 0</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/surfaces/stl.py" />
            <source>a vertex of it has a value that is no finite number</source>
            <translation>ein Eckpunkt hat einen Wert, der keine endliche Zahl ist</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/surfaces/stl.py" />
            <source>no smooth part of its mesh has {least} vertices</source>
            <translation>kein glatter Teil ihres Netzes hat {least} Eckpunkte</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/surfaces/stl.py" />
            <source>it has {count} triangles; 1 to {most} million are possible</source>
            <translation>sie hat {count} Dreiecke; möglich sind 1 bis {most} Millionen</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/surfaces/table.py" />
            <source>no line of it begins with three numbers x, y and z</source>
            <translation>keine ihrer Zeilen beginnt mit drei Zahlen x, y und z</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/surfaces/table.py" />
            <source>it has more than {most} million points</source>
            <translation>sie hat mehr als {most} Millionen Punkte</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/surfaces/table.py" />
            <source>its line {number} has no x, y and z: {line!r}</source>
            <translation>ihrer Zeile {number} fehlen x, y und z: {line!r}</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/surfaces/x3p.py" />
            <source>its entry {name} is too long</source>
            <translation>ihr Eintrag {name} ist zu lang</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/surfaces/x3p.py" />
            <source>its main.xml has no {path}</source>
            <translation>ihrer main.xml fehlt {path}</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/surfaces/x3p.py" />
            <source>its axis {axis} has no values</source>
            <translation>ihre Achse {axis} hat keine Werte</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/surfaces/x3p.py" />
            <source>its DataType is {found!r}; I, L, F, D are known</source>
            <translation>ihr DataType ist {found!r}; bekannt sind I, L, F, D</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/text.py" />
            <source>{word!r} stands where a number is needed</source>
            <translation>{word!r} steht, wo eine Zahl nötig ist</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/text.py" />
            <source>{word!r} stands where a finite number is needed</source>
            <translation>{word!r} steht, wo eine endliche Zahl nötig ist</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/text.py" />
            <source>{word!r} stands where a whole number from {least} to {most} has to</source>
            <translation>{word!r} steht, wo eine ganze Zahl von {least} bis {most} nötig ist</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/text.py" />
            <source>text behind the last number is ignored: {text!r}</source>
            <translation>Text hinter der letzten Zahl wird ignoriert: {text!r}</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/text.py" />
            <source>it goes on behind its end</source>
            <translation>sie geht nach ihrem Ende weiter</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/text.py" />
            <source>has more than {most} MB, too many for such a file</source>
            <translation>hat mehr als {most} MB, zu viel für eine solche Datei</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/account.py" />
            <source>Only {part:.1f} % of the light lands {place}; {lost:.0f} % {where}: {cure}.</source>
            <translation>Nur {part:.1f} % des Lichts kommen {place} an; {lost:.0f} % {where}: {cure}.</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/beam_plan.py" />
            <source>beams of light between {rays} rays: no noise, and no filter</source>
            <translation>Lichtbündel zwischen {rays} Strahlen: kein Rauschen und kein Filter</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/beam_plan.py" />
            <source>beams run between points of the source, through each sample of the lens</source>
            <translation>Bündel verlaufen zwischen Punkten der Quelle, durch jede Stützstelle der Linse</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/beam_plan.py" />
            <source>shading by the screen and by the mirror itself is ignored</source>
            <translation>Abschattung durch den Schirm und durch den Spiegel selbst bleibt außer Acht</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/beam_plan.py" />
            <source>shading by the far field and by the mirror itself is ignored</source>
            <translation>Abschattung durch das Fernfeld und durch den Spiegel selbst bleibt außer Acht</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/paths.py" />
            <source>{face} of {element}</source>
            <translation>{face} von {element}</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/paths.py" />
            <source>{part} % of the light is totally reflected at the {face}, most of it around x = {x}, y = {y}</source>
            <translation>{part} % des Lichts werden an der {face} totalreflektiert, das meiste um x = {x}, y = {y}</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/plan.py" />
            <source>fused kernels, {threads} threads, {precision}</source>
            <translation>übersetzte Rechenkerne, {threads} Threads, {precision}</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/plan.py" />
            <source>fused kernels, 1 thread, {precision}</source>
            <translation>übersetzte Rechenkerne, 1 Thread, {precision}</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/plan.py" />
            <source>reference in torch on {device}, {precision}</source>
            <translation>Referenz in torch auf {device}, {precision}</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/plan.py" />
            <source>no kernel for this path ({faces}): by the reference alone</source>
            <translation>kein Rechenkern für diesen Weg ({faces}): nur durch die Referenz</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/plan.py" />
            <source>float64: float32 has too few digits for this scene</source>
            <translation>float64: float32 hat zu wenige Stellen für diese Szene</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/plan.py" />
            <source>the kernel could not be compiled ({error}), so this run is many times slower</source>
            <translation>der Rechenkern ließ sich nicht übersetzen ({error}), darum ist dieser Lauf um ein Vielfaches langsamer</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/plan.py" />
            <source>compiled kernels could not be kept ({reason}), so each start compiles them again</source>
            <translation>übersetzte Rechenkerne ließen sich nicht aufbewahren ({reason}), darum übersetzt sie jeder Start neu</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/plan.py" />
            <source>box filter: one pixel a ray, no ghost pixels</source>
            <translation>Kastenfilter: ein Pixel je Strahl, keine Randpixel</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/plan.py" />
            <source>{count} lines of light, each with its own refractive indices</source>
            <translation>{count} Spektrallinien, jede mit eigenen Brechzahlen</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/plan.py" />
            <source>'cuda' needs an NVIDIA GPU that torch can use, and there is none; 'cpu'</source>
            <translation>'cuda' braucht eine NVIDIA-GPU, die torch benutzen kann, und es gibt keine; 'cpu'</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/sampled.py" />
            <source>samples of the aperture, followed through fixed faces once</source>
            <translation>Stützstellen der Apertur, einmal durch feste Flächen verfolgt</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/sampled.py" />
            <source>samples on the exit face, shared by all origins of the light</source>
            <translation>Stützstellen auf der Austrittsfläche, gemeinsam für alle Ursprünge des Lichts</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/sampled.py" />
            <source>samples on the entrance face, shared by all origins of the light</source>
            <translation>Stützstellen auf der Eintrittsfläche, gemeinsam für alle Ursprünge des Lichts</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/sampled.py" />
            <source>samples on the mirror, shared by all origins of the light</source>
            <translation>Stützstellen auf dem Spiegel, gemeinsam für alle Ursprünge des Lichts</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/train/entries.py" />
            <source>1 direction of light</source>
            <translation>1 Lichtrichtung</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/train/entries.py" />
            <source>{count} directions of light</source>
            <translation>{count} Lichtrichtungen</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/train/entries.py" />
            <source>1 point of light</source>
            <translation>1 Lichtpunkt</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/train/entries.py" />
            <source>{count} points of light</source>
            <translation>{count} Lichtpunkte</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/train/entries.py" />
            <source>mirror symmetry: {some} of them are traced</source>
            <translation>Spiegelsymmetrie: {some} davon werden verfolgt</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/train/entries.py" />
            <source>collimated light: entrance refraction and intersection left out</source>
            <translation>kollimiertes Licht: Brechung an der Eintrittsfläche und Schnittsuche entfallen</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/train/incident.py" />
            <source>mirror symmetry: a quarter of the rays</source>
            <translation>Spiegelsymmetrie: ein Viertel der Strahlen</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/train/incident.py" />
            <source>mirror symmetry: half of the rays</source>
            <translation>Spiegelsymmetrie: die Hälfte der Strahlen</translation>
        </message>
        <message>
            <location filename="../../workbench/option_groups.py" />
            <source>{value}; one of {known}</source>
            <translation>{value}; eines von {known}</translation>
        </message>
        <message>
            <location filename="../../workbench/option_groups.py" />
            <source>{value:g}; from {least:g} to {most:,}</source>
            <translation>{value:g}; von {least:g} bis {most:,}</translation>
        </message>
        <message>
            <location filename="../../workbench/option_groups.py" />
            <source>{value:g} {unit}; from {least:g} to {most:,} {unit}</source>
            <translation>{value:g} {unit}; von {least:g} bis {most:,} {unit}</translation>
        </message>
        <message>
            <location filename="../../workbench/option_groups.py" />
            <source>{value:g}; a finite number is needed</source>
            <translation>{value:g}; eine endliche Zahl ist nötig</translation>
        </message>
        <message>
            <location filename="../../workbench/option_groups.py" />
            <source>{value:g}; a length above 0</source>
            <translation>{value:g}; eine Länge über 0</translation>
        </message>
        <message>
            <location filename="../../workbench/option_groups.py" />
            <source>{value:g}; a length of 0 or more</source>
            <translation>{value:g}; eine Länge von 0 oder mehr</translation>
        </message>
        <message>
            <location filename="../../workbench/pictures/comparison.py" />
            <source>Second minus first</source>
            <translation>Zweites minus erstes</translation>
        </message>
        <message>
            <location filename="../../workbench/pictures/comparison.py" />
            <source>The receivers differ: no difference image.</source>
            <translation>Die Empfänger sind verschieden: kein Differenzbild.</translation>
        </message>
        <message>
            <location filename="../../workbench/pictures/error_curves.py" />
            <source>z of the screen</source>
            <translation>z des Schirms</translation>
        </message>
        <message>
            <location filename="../../workbench/pictures/error_curves.py" />
            <source>error</source>
            <translation>Fehler</translation>
        </message>
        <message>
            <location filename="../../workbench/pictures/error_curves.py" />
            <source>relative L2 error</source>
            <translation>relativer L2-Fehler</translation>
        </message>
        <message>
            <location filename="../../workbench/pictures/error_curves.py" />
            <source>lenses up to there</source>
            <translation>Linsen bis dorthin</translation>
        </message>
        <message>
            <location filename="../../workbench/pictures/error_curves.py" />
            <source>error in the exact set-up</source>
            <translation>Fehler im genauen Aufbau</translation>
        </message>
        <message>
            <location filename="../../workbench/pictures/error_curves.py" />
            <source>mean error over what is uncertain</source>
            <translation>mittlerer Fehler über das Unsichere</translation>
        </message>
        <message>
            <location filename="../../workbench/pictures/handles.py" />
            <source>move the source</source>
            <translation>Quelle verschieben</translation>
        </message>
        <message>
            <location filename="../../workbench/pictures/handles.py" />
            <source>move the element</source>
            <translation>Element verschieben</translation>
        </message>
        <message>
            <location filename="../../workbench/pictures/handles.py" />
            <source>change the thickness</source>
            <translation>Dicke ändern</translation>
        </message>
        <message>
            <location filename="../../workbench/pictures/handles.py" />
            <source>move the screen</source>
            <translation>Schirm verschieben</translation>
        </message>
        <message>
            <location filename="../../workbench/pictures/handles.py" />
            <source>source</source>
            <translation>Quelle</translation>
        </message>
        <message>
            <location filename="../../workbench/pictures/loss.py" />
            <source>this run</source>
            <translation>dieser Lauf</translation>
        </message>
        <message>
            <location filename="../../workbench/pictures/loss.py" />
            <source>verified</source>
            <translation>geprüft</translation>
        </message>
        <message>
            <location filename="../../workbench/pictures/loss.py" />
            <source>iteration</source>
            <translation>Iteration</translation>
        </message>
        <message>
            <location filename="../../workbench/pictures/loss.py" />
            <source>loss</source>
            <translation>Zielfunktion</translation>
        </message>
        <message>
            <location filename="../../workbench/pictures/part/inspection.py" />
            <source>residual as measured</source>
            <translation>Abweichung wie gemessen</translation>
        </message>
        <message>
            <location filename="../../workbench/pictures/part/inspection.py" />
            <source>resolved residual</source>
            <translation>aufgelöste Abweichung</translation>
        </message>
        <message>
            <location filename="../../workbench/pictures/part/inspection.py" />
            <source>repeats</source>
            <translation>wiederholt sich</translation>
        </message>
        <message>
            <location filename="../../workbench/pictures/part/photograph.py" />
            <source>1 = mean</source>
            <translation>1 = Mittel</translation>
        </message>
        <message>
            <location filename="../../workbench/pictures/part/photograph.py" />
            <source>photograph, rectified</source>
            <translation>Foto, entzerrt</translation>
        </message>
        <message>
            <location filename="../../workbench/pictures/part/photograph.py" />
            <source>prediction with causes</source>
            <translation>Vorhersage mit Ursachen</translation>
        </message>
        <message>
            <location filename="../../workbench/pictures/part/photograph.py" />
            <source>photograph less prediction</source>
            <translation>Foto minus Vorhersage</translation>
        </message>
        <message>
            <location filename="../../workbench/pictures/section.py" />
            <source>target</source>
            <translation>Ziel</translation>
        </message>
        <message>
            <location filename="../../workbench/reading.py" />
            <source>does not exist; no file can have such a name</source>
            <translation>existiert nicht; keine Datei kann so heißen</translation>
        </message>
        <message>
            <location filename="../../workbench/reading.py" />
            <source>is a folder; a file is needed</source>
            <translation>ist ein Ordner; eine Datei ist nötig</translation>
        </message>
        <message>
            <location filename="../../workbench/reading.py" />
            <source>is a device or pipe; an ordinary file is needed</source>
            <translation>ist ein Gerät oder eine Pipe; eine gewöhnliche Datei ist nötig</translation>
        </message>
        <message>
            <location filename="../../workbench/reading.py" />
            <source>does not exist; the name of a file is needed</source>
            <translation>existiert nicht; der Name einer Datei ist nötig</translation>
        </message>
        <message>
            <location filename="../../workbench/reading.py" />
            <source>cannot be read: {problem}</source>
            <translation>lässt sich nicht lesen: {problem}</translation>
        </message>
        <message>
            <location filename="../../workbench/report/figures.py" />
            <source>error as designed</source>
            <translation>Fehler wie entworfen</translation>
        </message>
        <message>
            <location filename="../../workbench/report/figures.py" />
            <source>{error}, {change:+.3f} percentage points by this process ({interval})</source>
            <translation>{error}, {change:+.3f} Prozentpunkte durch diesen Prozess ({interval})</translation>
        </message>
        <message>
            <location filename="../../workbench/report/figures.py" />
            <source>{off}, {times:.2f} times their noise</source>
            <translation>{off}, das {times:.2f}-Fache ihres Rauschens</translation>
        </message>
        <message>
            <location filename="../../workbench/report/figures.py" />
            <source>{rays:,} rays, 95 % confidence</source>
            <translation>{rays:,} Strahlen, 95 % Konfidenz</translation>
        </message>
        <message>
            <location filename="../../workbench/report/figures.py" />
            <source>{error} ({interval})</source>
            <translation>{error} ({interval})</translation>
        </message>
        <message>
            <location filename="../../workbench/report/figures.py" />
            <source>{low} to {high}</source>
            <translation>{low} bis {high}</translation>
        </message>
        <message>
            <location filename="../../workbench/report/figures.py" />
            <source>{figure}; {remark}</source>
            <translation>{figure}; {remark}</translation>
        </message>
        <message>
            <location filename="../../workbench/report/findings.py" />
            <source>There is no lens yet.</source>
            <translation>Es gibt noch keine Linse.</translation>
        </message>
        <message>
            <location filename="../../workbench/report/findings.py" />
            <source>There is no mirror yet.</source>
            <translation>Es gibt noch keinen Spiegel.</translation>
        </message>
        <message>
            <location filename="../../workbench/report/findings.py" />
            <source>{error} computed error, not verified yet</source>
            <translation>{error} berechneter Fehler, noch nicht geprüft</translation>
        </message>
        <message>
            <location filename="../../workbench/report/findings.py" />
            <source>{error} computed error as made, not verified yet</source>
            <translation>{error} berechneter Fehler nach Fertigung, noch nicht geprüft</translation>
        </message>
        <message>
            <location filename="../../workbench/report/findings.py" />
            <source>{error} verified error</source>
            <translation>{error} geprüfter Fehler</translation>
        </message>
        <message>
            <location filename="../../workbench/report/findings.py" />
            <source>{error} verified error as made</source>
            <translation>{error} geprüfter Fehler nach Fertigung</translation>
        </message>
        <message>
            <location filename="../../workbench/report/findings.py" />
            <source>{error}; no lens gets below {lowest}.</source>
            <translation>{error}; keine Linse kommt unter {lowest}.</translation>
        </message>
        <message>
            <location filename="../../workbench/report/findings.py" />
            <source>{error}; no mirror gets below {lowest}.</source>
            <translation>{error}; kein Spiegel kommt unter {lowest}.</translation>
        </message>
        <message>
            <location filename="../../workbench/report/findings.py" />
            <source>Continue</source>
            <translation>Fortsetzen</translation>
        </message>
        <message>
            <location filename="../../workbench/report/findings.py" />
            <source>{part:.1f} % of the light lands {place}; {lost:.1f} % {where}.</source>
            <translation>{part:.1f} % des Lichts kommen {place} an; {lost:.1f} % {where}.</translation>
        </message>
        <message>
            <location filename="../../workbench/report/findings.py" />
            <source>{part:.1f} % of the light lands {place}, of at most {most:.1f} %; {lost:.1f} % {where}.</source>
            <translation>{part:.1f} % des Lichts kommen {place} an, von höchstens {most:.1f} %; {lost:.1f} % {where}.</translation>
        </message>
        <message>
            <location filename="../../workbench/report/findings.py" />
            <source>{even:.2f} uniformity U₀ (minimum / average) on the {area}; U₁ (minimum / maximum) is {ends:.2f}.</source>
            <translation>{even:.2f} Gleichmäßigkeit U₀ (Minimum / Mittelwert), {area}; U₁ (Minimum / Maximum) ist {ends:.2f}.</translation>
        </message>
        <message>
            <location filename="../../workbench/report/findings.py" />
            <source>{sentence} Average: {average}.</source>
            <translation>{sentence} Mittelwert: {average}.</translation>
        </message>
        <message>
            <location filename="../../workbench/report/findings.py" />
            <source>Widen and start over</source>
            <translation>Erweitern und neu starten</translation>
        </message>
        <message>
            <location filename="../../workbench/report/findings.py" />
            <source>{n_u} × {n_v} control points are too few for the detail of this target; {finer_u} × {finer_v} can show it.</source>
            <translation>{n_u} × {n_v} Kontrollpunkte sind zu wenige für die Einzelheiten dieses Ziels; {finer_u} × {finer_v} können sie zeigen.</translation>
        </message>
        <message>
            <location filename="../../workbench/report/findings.py" />
            <source>Refine and start over</source>
            <translation>Verfeinern und neu starten</translation>
        </message>
        <message>
            <location filename="../../workbench/report/findings.py" />
            <source>{part:.2g} % of the light {goes}: {cure}.</source>
            <translation>{part:.2g} % des Lichts {goes}: {cure}.</translation>
        </message>
        <message>
            <location filename="../../workbench/report/findings.py" />
            <source>{where}, as marked in the 3D scene: {cure}.</source>
            <translation>{where}, wie in der 3D-Szene markiert: {cure}.</translation>
        </message>
        <message>
            <location filename="../../workbench/report/measured.py" />
            <source>difference</source>
            <translation>Unterschied</translation>
        </message>
        <message>
            <location filename="../../workbench/report/measured.py" />
            <source>{part} (relative L2, beside scale and camera)</source>
            <translation>{part} (relativ L2, abgesehen von Maßstab und Kamera)</translation>
        </message>
        <message>
            <location filename="../../workbench/report/measured.py" />
            <source>with causes</source>
            <translation>mit Ursachen</translation>
        </message>
        <message>
            <location filename="../../workbench/report/measured.py" />
            <source>response</source>
            <translation>Kennlinie</translation>
        </message>
        <message>
            <location filename="../../workbench/report/measured.py" />
            <source>{power:.2f} (1 if the tone is right)</source>
            <translation>{power:.2f} (1, wenn der Tonwert stimmt)</translation>
        </message>
        <message>
            <location filename="../../workbench/report/measured.py" />
            <source>corners</source>
            <translation>Ecken</translation>
        </message>
        <message>
            <location filename="../../workbench/report/measured.py" />
            <source>{factor:.2f} times as light as the middle</source>
            <translation>{factor:.2f}-mal so hell wie die Mitte</translation>
        </message>
        <message>
            <location filename="../../workbench/report/measured.py" />
            <source>photograph</source>
            <translation>Foto</translation>
        </message>
        <message>
            <location filename="../../workbench/report/measured.py" />
            <source>{value} ± {off}, explains {part:.0f} %</source>
            <translation>{value} ± {off}, erklärt {part:.0f} %</translation>
        </message>
        <message>
            <location filename="../../workbench/report/measured.py" />
            <source>part</source>
            <translation>Teil</translation>
        </message>
        <message>
            <location filename="../../workbench/report/measured.py" />
            <source>points</source>
            <translation>Punkte</translation>
        </message>
        <message>
            <location filename="../../workbench/report/measured.py" />
            <source>{count} on {covered} of {face}, {missing} without a height, {spikes} spikes</source>
            <translation>{count} auf {covered} von {face}, {missing} ohne Höhe, {spikes} Ausreißer</translation>
        </message>
        <message>
            <location filename="../../workbench/report/measured.py" />
            <source>residual</source>
            <translation>Abweichung</translation>
        </message>
        <message>
            <location filename="../../workbench/report/measured.py" />
            <source>{rms:.4g} µm rms, {whole:.4g} µm peak to valley</source>
            <translation>{rms:.4g} µm rms, {whole:.4g} µm Spitze-Tal</translation>
        </message>
        <message>
            <location filename="../../workbench/report/measured.py" />
            <source>resolved</source>
            <translation>aufgelöst</translation>
        </message>
        <message>
            <location filename="../../workbench/report/measured.py" />
            <source>{rms:.4g} µm rms, slope {slope:.4g} mrad rms, by {columns} × {rows} control points</source>
            <translation>{rms:.4g} µm rms, Steigung {slope:.4g} mrad rms, mit {columns} × {rows} Kontrollpunkten</translation>
        </message>
        <message>
            <location filename="../../workbench/report/measured.py" />
            <source>rest</source>
            <translation>Rest</translation>
        </message>
        <message>
            <location filename="../../workbench/report/measured.py" />
            <source>turned by</source>
            <translation>gedreht um</translation>
        </message>
        <message>
            <location filename="../../workbench/report/measured.py" />
            <source>shifted by</source>
            <translation>verschoben um</translation>
        </message>
        <message>
            <location filename="../../workbench/report/measured.py" />
            <source>scale</source>
            <translation>Maßstab</translation>
        </message>
        <message>
            <location filename="../../workbench/report/measured.py" />
            <source>{rms:.4g} µm rms</source>
            <translation>{rms:.4g} µm rms</translation>
        </message>
        <message>
            <location filename="../../workbench/report/measured.py" />
            <source>parts differ by</source>
            <translation>Teile unterscheiden sich um</translation>
        </message>
        <message>
            <location filename="../../workbench/report/measured.py" />
            <source>light of {part}</source>
            <translation>Licht von {part}</translation>
        </message>
        <message>
            <location filename="../../workbench/report/measured.py" />
            <source>{error} verified error, {light} on the receiver</source>
            <translation>{error} geprüfter Fehler, {light} auf dem Empfänger</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/element.py" />
            <source>'auto' needs a target to choose for; numbers</source>
            <translation>'auto' braucht ein Ziel, um zu wählen; Zahlen</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/faces.py" />
            <source>0 is no curvature; a radius, or a plane face</source>
            <translation>0 ist keine Krümmung; ein Radius oder eine ebene Fläche</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/faces.py" />
            <source>{radius:g} ends within the lens; more than {least:g} in size</source>
            <translation>{radius:g} endet innerhalb der Linse; dem Betrag nach mehr als {least:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/faces.py" />
            <source>{radius:g} ends within the mirror; more than {least:g} in size</source>
            <translation>{radius:g} endet innerhalb des Spiegels; dem Betrag nach mehr als {least:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/image.py" />
            <source>viewed from the side of the light</source>
            <translation>von der Lichtseite betrachtet</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/image.py" />
            <source>viewed from behind the screen</source>
            <translation>von hinter dem Schirm betrachtet</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/image.py" />
            <source>viewed from behind the far field</source>
            <translation>von hinter dem Fernfeld betrachtet</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/image.py" />
            <source>{size:g} about {middle:g} ends beyond the receiver; at most {most:g} there</source>
            <translation>{size:g} um {middle:g} endet jenseits des Empfängers; dort höchstens {most:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/image.py" />
            <source>have no area between them; a polygon with some</source>
            <translation>umschließen keine Fläche; ein Polygon mit Fläche</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/image.py" />
            <source>make sides that cross; in their order around the polygon</source>
            <translation>ergeben Seiten, die sich kreuzen; in ihrer Reihenfolge um das Polygon</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/image.py" />
            <source>{count} are given; at most {most}</source>
            <translation>{count} sind angegeben; höchstens {most}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/lens.py" />
            <source>the entrance face</source>
            <translation>die Eintrittsfläche</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/lens.py" />
            <source>a B-spline front face needs a B-spline back face; 'bspline'</source>
            <translation>eine vordere B-Spline-Fläche braucht eine hintere B-Spline-Fläche; 'bspline'</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/lens.py" />
            <source>{index:g}; greater than 1 is needed</source>
            <translation>{index:g}; mehr als 1 ist nötig</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/lens.py" />
            <source>{height:g} is below the minimal thickness; use more than {least:g}</source>
            <translation>{height:g} liegt unter der kleinsten Dicke; mehr als {least:g} nehmen</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/lens.py" />
            <source>{height:g} is above the maximal thickness; use less than {most:g}</source>
            <translation>{height:g} liegt über der größten Dicke; weniger als {most:g} nehmen</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/limits.py" />
            <source>{large:g} cannot be computed with; from {least:g} to {most:g}, in another unit if need be</source>
            <translation>mit {large:g} lässt sich nicht rechnen; von {least:g} bis {most:g}, nötigenfalls in einer anderen Einheit</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/limits.py" />
            <source>{half:g} makes the element slimmer than {most:g} to 1; at least {least:g}</source>
            <translation>{half:g} macht das Element schlanker als {most:g} zu 1; mindestens {least:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/limits.py" />
            <source>{index:g} is more than any material has; at most {most:g}</source>
            <translation>{index:g} ist mehr, als ein Material hat; höchstens {most:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/limits.py" />
            <source>{absorption:g} leaves less than {least:g} of the light behind {thickness:g} of glass; at most {most:g}</source>
            <translation>{absorption:g} lässt weniger als {least:g} des Lichts hinter {thickness:g} Glas übrig; höchstens {most:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/limits.py" />
            <source>{length:g} is too long beside a width of {width:g}; at most {most:g}</source>
            <translation>{length:g} ist zu lang neben einer Breite von {width:g}; höchstens {most:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/losses.py" />
            <source>a flatter base, </source>
            <translation>eine flachere Basis, </translation>
        </message>
        <message>
            <location filename="../../workbench/scene/losses.py" />
            <source>{loss} ({element})</source>
            <translation>{loss} ({element})</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/making/presets.py" />
            <source>typical value, no source</source>
            <translation>typischer Wert, keine Quelle</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/making/presets.py" />
            <source>largest value of MISUMI, Plastic Molding Tutorial #004, table 1, 2009</source>
            <translation>größter Wert von MISUMI, Plastic Molding Tutorial #004, Tabelle 1, 2009</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/making/presets.py" />
            <source>layers: toglefritz.com, Form 1+ 0.1mm vs. 0.025mm Layer Thickness; pixels: typical value</source>
            <translation>Schichten: toglefritz.com, Form 1+ 0.1mm vs. 0.025mm Layer Thickness; Pixel: typischer Wert</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/making/presets.py" />
            <source>Milling: ball of 3 mm, scallops of 5 µm</source>
            <translation>Fräsen: Kugel von 3 mm, Rillen von 5 µm</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/making/presets.py" />
            <source>Milling: ball of 1 mm, scallops of 1 µm</source>
            <translation>Fräsen: Kugel von 1 mm, Rillen von 1 µm</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/making/presets.py" />
            <source>Diamond turning: nose of 0.5 mm, feed of 5 µm</source>
            <translation>Diamantdrehen: Schneidenradius 0,5 mm, Vorschub 5 µm</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/making/presets.py" />
            <source>Polishing over a width of 0.1 mm</source>
            <translation>Polieren über eine Breite von 0,1 mm</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/making/presets.py" />
            <source>Injection moulding of PMMA: shrinkage of 0.4 %</source>
            <translation>Spritzguss von PMMA: Schwund von 0,4 %</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/making/presets.py" />
            <source>Injection moulding of PS: shrinkage of 0.7 %</source>
            <translation>Spritzguss von PS: Schwund von 0,7 %</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/making/presets.py" />
            <source>Resin printing: layers and pixels of 50 µm</source>
            <translation>Harzdruck: Schichten und Pixel von 50 µm</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/making/presets.py" />
            <source>Resin printing: layers of 25 µm, pixels of 50 µm</source>
            <translation>Harzdruck: Schichten von 25 µm, Pixel von 50 µm</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/making/process.py" />
            <source>{width:g} is too large for {name}; at most {most:.3g}</source>
            <translation>{width:g} ist zu groß für {name}; höchstens {most:.3g}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/making/process.py" />
            <source>{step:g} leaves ridges of the tool's own size; at most {most:g}</source>
            <translation>{step:g} hinterlässt Grate von der Größe des Werkzeugs; höchstens {most:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/mirror_diffuser.py" />
            <source>the mirror</source>
            <translation>der Spiegel</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/mirror_diffuser.py" />
            <source>the diffuser</source>
            <translation>der Diffusor</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/part.py" />
            <source>{value:g} is too small for this one; a number that it can hold</source>
            <translation>{value:g} ist zu klein für diese; eine Zahl, die sie fasst</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/paths.py" />
            <source>no path of a field; a path as in lens.thickness is needed</source>
            <translation>kein Pfad eines Feldes; nötig ist ein Pfad wie lens.thickness</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/paths.py" />
            <source>given twice; one value for each field</source>
            <translation>doppelt angegeben; ein Wert für jedes Feld</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/paths.py" />
            <source>no field and no element of this scene; fields: {fields}; elements: {names}</source>
            <translation>kein Feld und kein Element dieser Szene; Felder: {fields}; Elemente: {names}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/paths.py" />
            <source>unknown field; there is no such part of the scene</source>
            <translation>unbekanntes Feld; einen solchen Teil der Szene gibt es nicht</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/paths.py" />
            <source>there are only {count} of them; 0 to {last}</source>
            <translation>davon gibt es nur {count}; 0 bis {last}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/paths.py" />
            <source>there is none of them</source>
            <translation>davon gibt es keines</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/points.py" />
            <source>{parts} make {across} × {up} rectangles; at most {most} in all</source>
            <translation>{parts} ergeben {across} × {up} Rechtecke; höchstens {most} insgesamt</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/receiver.py" />
            <source>is at no distance; a screen is needed</source>
            <translation>hat keinen Abstand; ein Schirm ist nötig</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/receivers.py" />
            <source>{tilt} turns the back of the screen to light of the lens; its front has to face all of the lens</source>
            <translation>{tilt} wendet dem Licht der Linse die Rückseite des Schirms zu; seine Vorderseite muss der ganzen Linse zugewandt sein</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/receivers.py" />
            <source>{tilt} turns the back of the screen to light of the mirror; its front has to face all of the mirror</source>
            <translation>{tilt} wendet dem Licht des Spiegels die Rückseite des Schirms zu; seine Vorderseite muss dem ganzen Spiegel zugewandt sein</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/receivers.py" />
            <source>{z:g} may touch the lens; more than {least:g}, the highest that the exit face can become</source>
            <translation>{z:g} kann die Linse berühren; mehr als {least:g}, der höchste Wert, den die Austrittsfläche erreichen kann</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/receivers.py" />
            <source>{z:g} puts its lowest edge at z = {nearest:g}, which may touch the lens; more than {least:g}, the highest that the exit face can become and the tilt adds</source>
            <translation>{z:g} legt seine unterste Kante auf z = {nearest:g}, was die Linse berühren kann; mehr als {least:g}, der höchste Wert, den die Austrittsfläche erreichen kann, und was die Neigung hinzufügt</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/receivers.py" />
            <source>{z:g} may touch the lens, or be behind it; less than {most:g}, the lowest that it can become</source>
            <translation>{z:g} kann die Linse berühren oder hinter ihr liegen; weniger als {most:g}, der tiefste Wert, den sie erreichen kann</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/receivers.py" />
            <source>{z:g} may touch the mirror, or be behind it; less than {most:g}, the lowest that it can become</source>
            <translation>{z:g} kann den Spiegel berühren oder hinter ihm liegen; weniger als {most:g}, der tiefste Wert, den er erreichen kann</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/receivers.py" />
            <source>{half:g} about {middle:g} goes beyond {most:g} degrees; at most {left:g}</source>
            <translation>{half:g} um {middle:g} reicht über {most:g} Grad hinaus; höchstens {left:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/run.py" />
            <source>they leave none of the {count} iterations for the scene itself; more than {least} in all are needed</source>
            <translation>sie lassen keine der {count} Iterationen für die Szene selbst; mehr als {least} insgesamt sind nötig</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/run.py" />
            <source>unknown field; the automatic method has none</source>
            <translation>unbekanntes Feld; die automatische Methode hat keines</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/source.py" />
            <source>{z:g} is not before {front}; less than {most:g}</source>
            <translation>{z:g} liegt nicht davor ({front}); weniger als {most:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/source.py" />
            <source>{way:g} before {front} is too near for a lens that is {width:g} wide; at least {least:g}</source>
            <translation>{way:g} davor ({front}) ist zu nah für eine {width:g} breite Linse; mindestens {least:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/source.py" />
            <source>{way:g} before {front} is too near for a mirror that is {width:g} wide; at least {least:g}</source>
            <translation>{way:g} davor ({front}) ist zu nah für einen {width:g} breiten Spiegel; mindestens {least:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/source.py" />
            <source>{way:g} before {front} is too far for a lens that is {width:g} wide; at most {most:g}, or collimated light</source>
            <translation>{way:g} davor ({front}) ist zu fern für eine {width:g} breite Linse; höchstens {most:g}, oder kollimiertes Licht</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/source.py" />
            <source>{way:g} before {front} is too far for a mirror that is {width:g} wide; at most {most:g}, or collimated light</source>
            <translation>{way:g} davor ({front}) ist zu fern für einen {width:g} breiten Spiegel; höchstens {most:g}, oder kollimiertes Licht</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/source.py" />
            <source>given together with a wavelength of {wavelength:g} µm; one of both</source>
            <translation>zusammen mit einer Wellenlänge von {wavelength:g} µm angegeben; nur eines von beiden</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/source.py" />
            <source>{count} lines are given; 1 to {most}</source>
            <translation>{count} Linien sind angegeben; 1 bis {most}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/source.py" />
            <source>all parts of the flux are 0; one above 0</source>
            <translation>alle Anteile des Flusses sind 0; mindestens einer über 0</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/sources.py" />
            <source>{angle:g} brings light {steepest:g} degrees from the axis, which does not come to {front}; less than 90 in all</source>
            <translation>{angle:g} bringt Licht {steepest:g} Grad von der Achse, das nicht dorthin kommt ({front}); weniger als 90 insgesamt</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/sources.py" />
            <source>{radius:g} is too narrow for a lens that is {width:g} wide; at least {least:g}</source>
            <translation>{radius:g} ist zu schmal für eine {width:g} breite Linse; mindestens {least:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/sources.py" />
            <source>{radius:g} is too narrow for a mirror that is {width:g} wide; at least {least:g}</source>
            <translation>{radius:g} ist zu schmal für einen {width:g} breiten Spiegel; mindestens {least:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/sources.py" />
            <source>'{file}' is none of these: {endings}</source>
            <translation>'{file}' ist keines von diesen: {endings}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/spline_face.py" />
            <source>{count} is too few for degree {degree}; at least {least}</source>
            <translation>{count} sind zu wenige für Grad {degree}; mindestens {least}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/spline_face.py" />
            <source>{radius:g} does not span the lens; more than its half-diagonal {least:g}</source>
            <translation>{radius:g} überspannt die Linse nicht; mehr als ihre halbe Diagonale {least:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/spline_face.py" />
            <source>{radius:g} does not span the mirror; more than its half-diagonal {least:g}</source>
            <translation>{radius:g} überspannt den Spiegel nicht; mehr als seine halbe Diagonale {least:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/spline_face.py" />
            <source>the file has {count} control points; {given}</source>
            <translation>die Datei hat {count} Kontrollpunkte; {given}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/spline_face.py" />
            <source>the control heights in {file} are in the unit of the scene; the same unit</source>
            <translation>die Kontrollhöhen in {file} stehen in der Einheit der Szene; dieselbe Einheit</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/spline_face.py" />
            <source>[{low:g}, {high:g}] is empty; low before high</source>
            <translation>[{low:g}, {high:g}] ist leer; der kleinere Wert zuerst</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/spline_face.py" />
            <source>no array of control heights; a .npy file of at most {most} × {most} finite numbers</source>
            <translation>keine Matrix von Kontrollhöhen; eine .npy-Datei mit höchstens {most} × {most} endlichen Zahlen</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/target.py" />
            <source>takes {across:g} of the width away; at most {most:g}</source>
            <translation>schneidet {across:g} der Breite weg; höchstens {most:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/target.py" />
            <source>takes {up:g} of the height away; at most {most:g}</source>
            <translation>schneidet {up:g} der Höhe weg; höchstens {most:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/target.py" />
            <source>at least {least:g}, above black</source>
            <translation>mindestens {least:g}, über dem Schwarzwert</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/target.py" />
            <source>{radius:g} is not above {before:g}</source>
            <translation>{radius:g} liegt nicht über {before:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/target.py" />
            <source>has no light; some level above 0 is needed</source>
            <translation>hat kein Licht; ein Wert über 0 ist nötig</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/task.py" />
            <source>the element is not upright, which {who} cannot take into account; 0</source>
            <translation>das Element ist verkippt, was {who} nicht berücksichtigen kann; 0</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/task.py" />
            <source>'diffuser', which {who} cannot take into account; none</source>
            <translation>'diffuser', was {who} nicht berücksichtigen kann; keiner</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/task.py" />
            <source>{count} given, which {who} cannot take into account; one</source>
            <translation>{count} angegeben, nicht zu berücksichtigen durch: {who}; eines</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/train.py" />
            <source>'{name}' is the name of another element; another name</source>
            <translation>'{name}' ist der Name eines anderen Elements; ein anderer Name</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/train.py" />
            <source>no face is designed; one face of shape 'bspline'</source>
            <translation>keine Fläche wird entworfen; eine Fläche der Form 'bspline'</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/train.py" />
            <source>{value:g} is about curvature, and faces of degree 1 are flat between edges; {field} of at least 2</source>
            <translation>{value:g} betrifft die Krümmung, und Flächen vom Grad 1 sind zwischen Kanten eben; {field} von mindestens 2</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/train.py" />
            <source>light leaves {name} at {angle:.0f} degrees from the z axis, too far for a far field; at most {most:g}, or a plane</source>
            <translation>Licht verlässt {name} unter {angle:.0f} Grad zur z-Achse, zu viel für ein Fernfeld; höchstens {most:g}, oder eine Ebene</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/train.py" />
            <source>a receiver at z = {z:g} may touch the element {name}; more than {least:g}</source>
            <translation>ein Empfänger bei z = {z:g} kann das Element {name} berühren; mehr als {least:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/train.py" />
            <source>a receiver at {place} may touch the element {name}, or gets none of its light; farther along the light, and across it</source>
            <translation>ein Empfänger bei {place} kann das Element {name} berühren oder erhält kein Licht davon; weiter entlang des Lichts und quer dazu</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/train.py" />
            <source>light comes to the back of {name}, at {angle:.0f} degrees from its z; less than 90, as where it is turned by 180 degrees about its x</source>
            <translation>Licht trifft {name} von hinten, unter {angle:.0f} Grad zu dessen z; weniger als 90, etwa nach einer Drehung um 180 Grad um dessen x</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/train.py" />
            <source>'{name}' is behind the diffuser {diffuser}; move the diffuser to the end</source>
            <translation>'{name}' steht hinter dem Diffusor {diffuser}; der Diffusor gehört ans Ende</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/train.py" />
            <source>behind a Lambertian diffuser all lenses make the same far field; 'plane', or {field}: 'gaussian'</source>
            <translation>hinter einem Lambertschen Diffusor ergeben alle Linsen dasselbe Fernfeld; 'plane', oder {field}: 'gaussian'</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/train.py" />
            <source>not parallel to the Lambertian diffuser {name}; its tilt</source>
            <translation>nicht parallel zum Lambertschen Diffusor {name}; dessen Neigung</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/train.py" />
            <source>{z:g} reaches into {name}; at least {least:g}</source>
            <translation>{z:g} ragt in {name} hinein; mindestens {least:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/train.py" />
            <source>{place} is not where light of {name} goes; {by:g} farther along its axis</source>
            <translation>{place} liegt nicht, wohin Licht von {name} geht; {by:g} weiter entlang dessen Achse</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/versions.py" />
            <source>missing; it goes with {material}</source>
            <translation>fehlt; sie gehört zu {material}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/versions.py" />
            <source>{value} is neither a number nor a name; a number above 1 or a material name</source>
            <translation>{value} ist weder Zahl noch Name; eine Zahl über 1 oder der Name eines Materials</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/versions.py" />
            <source>{value}; a number greater than 1 is needed</source>
            <translation>{value}; eine Zahl über 1 ist nötig</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/versions.py" />
            <source>missing; it or {other} is required</source>
            <translation>fehlt; dies oder {other} wird gebraucht</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/versions.py" />
            <source>is given together with a {one}; one of them is needed</source>
            <translation>ist zusammen mit {one} angegeben; nur eines davon ist nötig</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/wide_sources.py" />
            <source>{rays} from each of {points} points are too many; at most {most} rays in all</source>
            <translation>{rays} von jedem der {points} Punkte sind zu viele; höchstens {most} Strahlen insgesamt</translation>
        </message>
        <message>
            <location filename="../../workbench/sweep/points.py" />
            <source>is varied twice; all its values belong together</source>
            <translation>wird zweimal verändert; alle seine Werte gehören zusammen</translation>
        </message>
        <message>
            <location filename="../../workbench/sweep/points.py" />
            <source>{count} points; at most {most} are possible</source>
            <translation>{count} Punkte; höchstens {most} sind möglich</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/colour.py" />
            <source>has a colour profile that cannot be used ({why}); “Brightness” (target.tone) counts</source>
            <translation>hat ein Farbprofil, das nicht verwendbar ist ({why}); es gilt „Helligkeit“ (target.tone)</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/colour.py" />
            <source>has {statement}, which counts in place of “Brightness” (target.tone)</source>
            <translation>hat {statement}; das gilt anstelle von „Helligkeit“ (target.tone)</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/colour.py" />
            <source>a chunk sRGB</source>
            <translation>einen Block sRGB</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/colour.py" />
            <source>a chunk gAMA of {gamma:.4g}</source>
            <translation>einen Block gAMA von {gamma:.4g}</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/colour.py" />
            <source>the colour profile “{name}”</source>
            <translation>das Farbprofil „{name}“</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/exr_image.py" />
            <source>has pixels {aspect:.3g} times as wide as high; they count as squares</source>
            <translation>hat Pixel, die {aspect:.3g}-mal so breit wie hoch sind; sie zählen als Quadrate</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/exr_image.py" />
            <source>is damaged or incomplete</source>
            <translation>ist beschädigt oder unvollständig</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/exr_image.py" />
            <source>is a deep EXR; a flat one is needed</source>
            <translation>ist ein tiefes EXR; ein flaches wird gebraucht</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/exr_image.py" />
            <source>has the channels {names}; R, G and B, or Y, are needed</source>
            <translation>hat die Kanäle {names}; gebraucht werden R, G und B oder Y</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/exr_image.py" />
            <source>has chromaticities that are no colours</source>
            <translation>hat Farbwertanteile, die keine Farben sind</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/image.py" />
            <source>is a folder; an image file is needed</source>
            <translation>ist ein Ordner; eine Bilddatei ist nötig</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/image.py" />
            <source>is not an existing file; an image file is needed</source>
            <translation>gibt es nicht; eine Bilddatei ist nötig</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/image.py" />
            <source>cannot be read: {why}</source>
            <translation>kann nicht gelesen werden: {why}</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/image.py" />
            <source>'{tone}' is for shades, and '{path}' holds numbers; 'linear'</source>
            <translation>'{tone}' ist für Tonwerte, und '{path}' enthält Zahlen; 'linear'</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/image.py" />
            <source>'{path}' {remark}</source>
            <translation>'{path}' {remark}</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/image.py" />
            <source>is an SVG of more than {most} MB</source>
            <translation>ist ein SVG von mehr als {most} MB</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/image.py" />
            <source>holds light itself; “Brightness” (target.tone) does not count</source>
            <translation>enthält das Licht selbst; „Helligkeit“ (target.tone) gilt nicht</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/image.py" />
            <source>is damaged or incomplete: {why}</source>
            <translation>ist beschädigt oder unvollständig: {why}</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/image.py" />
            <source>'{path}' {reason}</source>
            <translation>'{path}' {reason}</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/image.py" />
            <source>is not a whole .npy array of numbers: {why}</source>
            <translation>ist kein vollständiges .npy-Feld von Zahlen: {why}</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/image.py" />
            <source>has {count} dimensions; 2 (rows, columns) are needed</source>
            <translation>hat {count} Dimensionen; 2 (Zeilen, Spalten) sind nötig</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/image.py" />
            <source>holds values of type {kind}; real numbers are needed</source>
            <translation>enthält Werte vom Typ {kind}; reelle Zahlen sind nötig</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/image.py" />
            <source>is not a whole .npy array of numbers: it lacks some of {size} bytes</source>
            <translation>ist kein vollständiges .npy-Feld von Zahlen: es fehlen einige von {size} Byte</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/picture.py" />
            <source>has {columns} × {rows} pixels; at least one is needed</source>
            <translation>hat {columns} × {rows} Pixel; mindestens eines ist nötig</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/picture.py" />
            <source>has {columns} × {rows} pixels; at most {most} million are allowed</source>
            <translation>hat {columns} × {rows} Pixel; höchstens {most} Millionen sind erlaubt</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/picture.py" />
            <source>has {columns} × {rows} pixels and is reduced to {less_columns} × {less_rows}</source>
            <translation>hat {columns} × {rows} Pixel und wird auf {less_columns} × {less_rows} verkleinert</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/picture.py" />
            <source>holds {least:g}; values of at least 0 are needed</source>
            <translation>enthält {least:g}; Werte von mindestens 0 sind nötig</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/prepare.py" />
            <source>is too small to light any pixel of the screen; enlarge the shape</source>
            <translation>ist zu klein, um ein Pixel des Schirms zu beleuchten; vergrößern Sie die Form</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/prepare.py" />
            <source>'{path}' is black all over; some light is needed</source>
            <translation>'{path}' ist ganz schwarz; etwas Licht ist nötig</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/prepare.py" />
            <source>true leaves '{path}', which is uniform, black all over</source>
            <translation>true macht '{path}', das gleichmäßig ist, ganz schwarz</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/prepare.py" />
            <source>leaves '{path}' black all over; less leaves some light</source>
            <translation>lässt von „{path}“ nur Schwarz; ein kleinerer Wert lässt etwas Licht</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/radiance_image.py" />
            <source>is damaged: it has no line with its resolution</source>
            <translation>ist beschädigt: die Zeile mit der Auflösung fehlt</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/radiance_image.py" />
            <source>has primaries that are no colours of light</source>
            <translation>hat Primärfarben, die keine Lichtfarben sind</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/radiance_image.py" />
            <source>is damaged: a line has another length than the picture</source>
            <translation>ist beschädigt: eine Zeile hat eine andere Länge als das Bild</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/radiance_image.py" />
            <source>is damaged: a line is longer than the picture</source>
            <translation>ist beschädigt: eine Zeile ist länger als das Bild</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/radiance_image.py" />
            <source>is incomplete: lines are missing at its end</source>
            <translation>ist unvollständig: am Ende fehlen Zeilen</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/raster_image.py" />
            <source>is not an image that can be read; known: {known}</source>
            <translation>ist kein Bild, das gelesen werden kann; bekannt: {known}</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/raster_image.py" />
            <source>has too many pixels; at most {most} million</source>
            <translation>hat zu viele Pixel; höchstens {most} Millionen</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/raster_image.py" />
            <source>has {frames} frames or pages; the first one counts</source>
            <translation>hat {frames} Einzelbilder oder Seiten; das erste zählt</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/raster_image.py" />
            <source>has 32 bits a pixel with zero as white; save it with zero as black</source>
            <translation>hat 32 Bit je Pixel mit null als Weiß; mit null als Schwarz speichern</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/raster_image.py" />
            <source>has zero as white; save it with zero as black</source>
            <translation>hat null als Weiß; mit null als Schwarz speichern</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/svg.py" />
            <source>it cannot be drawn within {most:g} s</source>
            <translation>es kann nicht innerhalb von {most:g} s gezeichnet werden</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/svg.py" />
            <source>links to the picture '{link}'; embed that picture in the SVG</source>
            <translation>verweist auf das Bild '{link}'; dieses Bild in die SVG-Datei einbetten</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/svg.py" />
            <source>it is nested too deeply to be drawn</source>
            <translation>es ist zu tief verschachtelt, um gezeichnet zu werden</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/svg.py" />
            <source>has the letter {letter} (U+{number:04X}), which no font here has; install one</source>
            <translation>hat den Buchstaben {letter} (U+{number:04X}), den hier keine Schrift hat; eine passende installieren</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/svg.py" />
            <source>is an SVG that cannot be drawn: {why}</source>
            <translation>ist ein SVG, das nicht gezeichnet werden kann: {why}</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/text.py" />
            <source>{text!r} draws nothing; letters, digits or signs are needed</source>
            <translation>{text!r} zeichnet nichts; Buchstaben, Ziffern oder Zeichen sind nötig</translation>
        </message>
    </context>
</TS>
