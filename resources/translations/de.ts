<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
    <context>
        <name>workbench</name>
        <message>
            <location filename="../../ui/commands/menus.py" />
            <source>&amp;File</source>
            <translation>&amp;Datei</translation>
        </message>
        <message>
            <location filename="../../ui/commands/menus.py" />
            <source>&amp;New from example</source>
            <translation>Neu aus Beis&amp;piel</translation>
        </message>
        <message>
            <location filename="../../ui/commands/menus.py" />
            <source>First lenses, twice as fine</source>
            <translation>Erste Linsen, doppelt so fein</translation>
        </message>
        <message>
            <location filename="../../ui/commands/menus.py" />
            <source>Top hat: networks and starts</source>
            <translation>Zylinder: Netzwerke und Startwerte</translation>
        </message>
        <message>
            <location filename="../../ui/commands/menus.py" />
            <source>Real lights</source>
            <translation>Wirkliche Lichtquellen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/menus.py" />
            <source>Flame and ball: magnifications</source>
            <translation>Flamme und Ball: Vergrößerungen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/menus.py" />
            <source>Flame: point and extended source</source>
            <translation>Flamme: punktförmige und ausgedehnte Quelle</translation>
        </message>
        <message>
            <location filename="../../ui/commands/menus.py" />
            <source>Walls and streets</source>
            <translation>Wände und Straßen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/menus.py" />
            <source>Two freeform faces</source>
            <translation>Zwei Freiformflächen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/menus.py" />
            <source>Derivative maps of a flat lens</source>
            <translation>Ableitungskarten einer ebenen Linse</translation>
        </message>
        <message>
            <location filename="../../ui/commands/menus.py" />
            <source>Open &amp;recent</source>
            <translation>Zuletzt &amp;geöffnet</translation>
        </message>
        <message>
            <location filename="../../ui/commands/menus.py" />
            <source>&amp;Edit</source>
            <translation>&amp;Bearbeiten</translation>
        </message>
        <message>
            <location filename="../../ui/commands/menus.py" />
            <source>&amp;Design</source>
            <translation>&amp;Entwurf</translation>
        </message>
        <message>
            <location filename="../../ui/commands/menus.py" />
            <source>&amp;Run</source>
            <translation>&amp;Lauf</translation>
        </message>
        <message>
            <location filename="../../ui/commands/menus.py" />
            <source>&amp;View</source>
            <translation>&amp;Ansicht</translation>
        </message>
        <message>
            <location filename="../../ui/commands/menus.py" />
            <source>&amp;Rays</source>
            <translation>S&amp;trahlen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/menus.py" />
            <source>F&amp;aces</source>
            <translation>&amp;Flächen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/menus.py" />
            <source>Save pict&amp;ure of 3D</source>
            <translation>3D-Bild speic&amp;hern</translation>
        </message>
        <message>
            <location filename="../../ui/commands/menus.py" />
            <source>&amp;Colours of light</source>
            <translation>Farben &amp;des Lichts</translation>
        </message>
        <message>
            <location filename="../../ui/commands/menus.py" />
            <source>Th&amp;eme</source>
            <translation>E&amp;rscheinungsbild</translation>
        </message>
        <message>
            <location filename="../../ui/commands/menus.py" />
            <source>La&amp;nguage</source>
            <translation>&amp;Sprache</translation>
        </message>
        <message>
            <location filename="../../ui/commands/menus.py" />
            <source>&amp;Go to</source>
            <translation>&amp;Gehe zu</translation>
        </message>
        <message>
            <location filename="../../ui/commands/menus.py" />
            <source>&amp;Help</source>
            <translation>&amp;Hilfe</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Top hat</source>
            <translation>Zylinder (Top Hat)</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>A uniform disc of light; see how soon its edge is sharp.</source>
            <translation>Eine gleichmäßige Lichtscheibe; zu sehen ist, wie bald ihr Rand scharf wird.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Flame</source>
            <translation>Flamme</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>A flame-like logo on black; see light leave what shall be dark.</source>
            <translation>Ein flammenähnliches Logo auf Schwarz; zu sehen ist, wie das Licht verlässt, was dunkel sein soll.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Ball</source>
            <translation>Ball</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>A faceted ball; see whether each grey comes out evenly bright.</source>
            <translation>Ein Ball aus Facetten; zu sehen ist, ob jedes Grau gleichmäßig hell wird.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Photograph</source>
            <translation>Fotografie</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Every grey from black to white; see texture and shadow come.</source>
            <translation>Alle Grautöne von Schwarz bis Weiß; zu sehen ist, wie Struktur und Schatten entstehen.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Letter</source>
            <translation>Buchstabe</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>A bold letter on black; see its straight edges and corners.</source>
            <translation>Ein fetter Buchstabe auf Schwarz; zu beachten sind seine geraden Kanten und Ecken.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Flame, 512 × 512</source>
            <translation>Flamme, 512 × 512</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>The flame with four times the detail; see its thin parts.</source>
            <translation>Die Flamme mit viermal so vielen Einzelheiten; zu beachten sind ihre dünnen Teile.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Ball, 512 × 512</source>
            <translation>Ball, 512 × 512</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>The ball with four times the detail; see the facets' edges.</source>
            <translation>Der Ball mit viermal so vielen Einzelheiten; zu beachten sind die Kanten der Facetten.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>No network, flat start</source>
            <translation>Kein Netzwerk, ebener Start</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>The yardstick for the three networks: a smooth lens that keeps the target's symmetry.</source>
            <translation>Der Maßstab für die drei Netzwerke: eine glatte Linse mit der Symmetrie des Ziels.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Sparse network, faint start</source>
            <translation>Dünn besetztes Netzwerk, schwacher Start</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Weights a ten-thousandth off zero; compare speed and symmetry with no network.</source>
            <translation>Gewichte um ein Zehntausendstel neben null; Tempo und Symmetrie mit „kein Netzwerk“ vergleichen.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Sparse network, random start</source>
            <translation>Dünn besetztes Netzwerk, zufälliger Start</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>A rough first lens; see how much of its roughness is left in the end.</source>
            <translation>Eine raue erste Linse; zu sehen ist, wie viel davon am Ende bleibt.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Dense network, faint start</source>
            <translation>Vollbesetztes Netzwerk, schwacher Start</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Two million weights for a thousand heights; compare loss and time with the sparse one.</source>
            <translation>Zwei Millionen Gewichte für tausend Höhen; Zielfunktion und Zeit mit dem dünn besetzten vergleichen.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Sun plate</source>
            <translation>Sonnenplatte</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Acrylic to hold into the sun, whose disc blurs by 4.7 mm: compare error and bound.</source>
            <translation>Acrylglas für die Sonne, deren Scheibe um 4.7 mm unscharf macht: Fehler und Schranke vergleichen.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Phone torch</source>
            <translation>Handy-Taschenlampe</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>The LED of a telephone, close to the lens, blurs the letter's edges: see the bound.</source>
            <translation>Die LED eines Telefons, nahe der Linse, macht die Kanten unscharf: die Schranke beachten.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>LED to a rectangle</source>
            <translation>LED auf ein Rechteck</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Light as wide as can be bent; see what is totally reflected, and how even the rest is.</source>
            <translation>Licht so weit, wie es sich ablenken lässt; zu beachten: die Totalreflexion und wie gleichmäßig der Rest ist.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Beam shaper</source>
            <translation>Strahlformer</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>A Gaussian laser beam becomes an even disc; see that hardly any light is lost.</source>
            <translation>Ein Gaußscher Laserstrahl wird zur gleichmäßigen Scheibe; kaum Licht geht verloren.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Measured LED</source>
            <translation>Gemessene LED</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>A file of 9,000 rays lights the lens; see how their grain shows in the check.</source>
            <translation>Eine Datei mit 9 000 Strahlen beleuchtet die Linse; ihr Korn zeigt sich in der Prüfung.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Flame, magnification 1</source>
            <translation>Flamme, Vergrößerung 1</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>A screen as large as the lens, far away: a few hundredths of height do it all.</source>
            <translation>Ein Schirm so groß wie die Linse, weit entfernt: wenige Hundertstel Höhe genügen.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Flame, magnification 3</source>
            <translation>Flamme, Vergrößerung 3</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>The concave base just fills the screen; see the corners, where rays are steep.</source>
            <translation>Die konkave Grundform füllt den Schirm gerade; die Ecken beachten, wo Strahlen steil sind.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Flame, magnification 5</source>
            <translation>Flamme, Vergrößerung 5</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Steeper still: compare the loss, and the light beside the screen, with 1 and 3.</source>
            <translation>Noch steiler: Zielfunktion und Licht neben dem Schirm mit 1 und 3 vergleichen.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Ball, magnification 1</source>
            <translation>Ball, Vergrößerung 1</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Ball, magnification 3</source>
            <translation>Ball, Vergrößerung 3</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Ball, magnification 5</source>
            <translation>Ball, Vergrößerung 5</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Point source</source>
            <translation>Punktquelle</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Light from one point; see in the light account how much of the cone passes the square lens by.</source>
            <translation>Licht von einem Punkt; die Lichtbilanz zeigt, wie viel vom Kegel die quadratische Linse verfehlt.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Extended source of 25 × 25 points</source>
            <translation>Ausgedehnte Quelle aus 25 × 25 Punkten</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>The flame is put together from images of the square source: details smaller than these stay blurred.</source>
            <translation>Die Flamme setzt sich aus Bildern der quadratischen Quelle zusammen: kleinere Einzelheiten bleiben unscharf.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Point source, then the extended one</source>
            <translation>Punktquelle, dann die ausgedehnte</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>The loss jumps when the extended source takes over at iteration 200; see what is won back.</source>
            <translation>Die Zielfunktion springt, wenn bei Iteration 200 die ausgedehnte Quelle übernimmt; zu sehen ist, was zurückgewonnen wird.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Wall washer</source>
            <translation>Wandfluter</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>A picture on a wall that leans away from the lamp; see that it comes out straight.</source>
            <translation>Ein Bild auf einer Wand, die sich von der Lampe wegneigt; es erscheint gerade.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Street light</source>
            <translation>Straßenleuchte</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>An LED's IES file; see intensity rise to both ends, so that the road below is even.</source>
            <translation>Die IES-Datei einer LED; die Strahlstärke steigt zu beiden Enden, damit die Straße gleichmäßig hell wird.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Mirror: letter on a wall</source>
            <translation>Spiegel: Buchstabe auf einer Wand</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Sunlight from below, thrown back to a wall beside it; see the mirror lean towards it.</source>
            <translation>Sonnenlicht von unten, auf eine Wand daneben geworfen; der Spiegel neigt sich zu ihr.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Mirror: photograph beside the lamp</source>
            <translation>Spiegel: Fotografie neben der Lampe</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Light from one point, drawn on a screen beside that point; see what misses the mirror.</source>
            <translation>Licht von einem Punkt, auf einen Schirm daneben gezeichnet; zu beachten, was den Spiegel verfehlt.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Photograph from a thin plate</source>
            <translation>Fotografie mit einer dünnen Platte</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Both faces bend the light; compare their slopes with those of one face alone.</source>
            <translation>Beide Flächen lenken das Licht ab; ihre Neigungen mit denen einer Fläche vergleichen.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Wide angle: disc from a near point</source>
            <translation>Weitwinkel: Scheibe aus einem nahen Punkt</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Light comes in at up to 60°; see how little of what is in the glass leaves by the side.</source>
            <translation>Licht kommt mit bis zu 60° an; kaum etwas davon verlässt das Glas durch die Seite.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>LED close by: square through a dome</source>
            <translation>Nahe LED: Quadrat durch eine Kuppel</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>The entrance face comes towards the LED in its middle; compare with a flat one.</source>
            <translation>Die Eintrittsfläche wölbt sich zur LED; mit einer ebenen vergleichen.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Photograph at two distances</source>
            <translation>Fotografie in zwei Abständen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Thick glass moves the light, its exit face makes it parallel; compare both images.</source>
            <translation>Dickes Glas verschiebt das Licht, die Austrittsfläche richtet es parallel; beide Bilder vergleichen.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Degrees (3, 3), filter 3 × 3</source>
            <translation>Grade (3, 3), Filter 3 × 3</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>As a control point rises it gathers light: a mountain in a valley, sum zero.</source>
            <translation>Steigt ein Kontrollpunkt, sammelt er Licht: ein Berg in einem Tal, Summe null.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Degrees (3, 3), filter 11 × 11</source>
            <translation>Grade (3, 3), Filter 11 × 11</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>The same mountain, smoother: each ray's light is spread over 11 × 11 pixels.</source>
            <translation>Derselbe Berg, glatter: das Licht jedes Strahls verteilt sich auf 11 × 11 Pixel.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Degrees (5, 3), filter 3 × 3</source>
            <translation>Grade (5, 3), Filter 3 × 3</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Wider along x: the valley meets the screen's border, and the sum leaves zero.</source>
            <translation>Breiter entlang x: das Tal erreicht den Rand des Schirms, und die Summe ist nicht mehr null.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;New…</source>
            <translation>&amp;Neu …</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Begin a design: choose a job and answer its questions</source>
            <translation>Einen Entwurf beginnen: Aufgabe wählen und ihre Fragen beantworten</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>New from &amp;gallery…</source>
            <translation>Neu aus G&amp;alerie …</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Choose an example by the picture of its light</source>
            <translation>Ein Beispiel nach dem Bild seines Lichts wählen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>New &amp;window</source>
            <translation>Neues &amp;Fenster</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Open another window, with a design and a run of its own</source>
            <translation>Ein weiteres Fenster mit eigenem Entwurf und eigenem Lauf öffnen</translation>
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
            <source>Write the lens or its light for other programs</source>
            <translation>Die Linse oder ihr Licht für andere Programme schreiben</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Write the mirror or its light for other programs</source>
            <translation>Den Spiegel oder sein Licht für andere Programme schreiben</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Cu&amp;t with a ball cutter…</source>
            <translation>Mit &amp;Kugelfräser fräsen …</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Write a finishing pass as G-code; what the cut leaves of the image is found before</source>
            <translation>Schlichtbahnen als G-Code schreiben; was der Schnitt vom Bild lässt, wird vorher ermittelt</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Report…</source>
            <translation>Be&amp;richt …</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Write scene, pictures, check and figures on some pages (HTML, PDF)</source>
            <translation>Szene, Bilder, Prüfung und Zahlen auf einige Seiten schreiben (HTML, PDF)</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Save &amp;predicted photo…</source>
            <translation>Fo&amp;to speichern …</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Save the predicted photo of the screen: what a camera would see, in colour (PNG)</source>
            <translation>Das vorhergesagte Foto des Schirms speichern: was eine Kamera sähe, in Farbe (PNG)</translation>
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
            <source>Go back to the file as it was saved; this can be undone</source>
            <translation>Zur gespeicherten Datei zurückkehren; lässt sich rückgängig machen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Undo</source>
            <translation>&amp;Rückgängig</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Take the last change back</source>
            <translation>Die letzte Änderung zurücknehmen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Redo</source>
            <translation>&amp;Wiederherstellen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Make the change again</source>
            <translation>Die Änderung erneut ausführen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Paste picture</source>
            <translation>Bild &amp;einfügen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Make the picture on the clipboard the target</source>
            <translation>Das Bild der Zwischenablage zum Ziel machen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Copy &amp;plot</source>
            <translation>&amp;Diagramm kopieren</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Copy a picture of the plot that was clicked last, to paste it elsewhere</source>
            <translation>Ein Bild des zuletzt angeklickten Diagramms kopieren, um es anderswo einzufügen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Save p&amp;lot…</source>
            <translation>Diagramm &amp;speichern …</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Save the plot that was clicked last: as a picture (PNG, SVG) or its numbers (CSV)</source>
            <translation>Das zuletzt angeklickte Diagramm speichern: als Bild (PNG, SVG) oder seine Zahlen (CSV)</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Start</source>
            <translation>&amp;Start</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Design the lens from nothing; one that is there gives way, and Undo brings it back</source>
            <translation>Die Linse von Grund auf entwerfen; eine vorhandene wird ersetzt, Rückgängig bringt sie zurück</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Design the mirror from nothing; one that is there gives way, and Undo brings it back</source>
            <translation>Den Spiegel von Grund auf entwerfen; ein vorhandener wird ersetzt, Rückgängig bringt ihn zurück</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Continue</source>
            <translation>&amp;Fortsetzen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Go on designing from the lens as it is, with as many more iterations</source>
            <translation>Von der jetzigen Linse aus weiter entwerfen, mit ebenso vielen weiteren Iterationen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Go on designing from the mirror as it is, with as many more iterations</source>
            <translation>Vom jetzigen Spiegel aus weiter entwerfen, mit ebenso vielen weiteren Iterationen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Pause</source>
            <translation>&amp;Pause</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Hold the design; again to go on</source>
            <translation>Den Entwurf anhalten; erneut, um fortzufahren</translation>
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
            <source>&amp;Follow edits</source>
            <translation>&amp;Änderungen folgen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Design the lens anew after every edit, while no run goes on</source>
            <translation>Die Linse nach jeder Änderung neu entwerfen, solange kein Lauf im Gange ist</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Design the mirror anew after every edit, while no run goes on</source>
            <translation>Den Spiegel nach jeder Änderung neu entwerfen, solange kein Lauf im Gange ist</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>S&amp;weep…</source>
            <translation>R&amp;eihe…</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Design a lens for each of several values of a field, and see all in a table</source>
            <translation>Für jeden von mehreren Werten eines Feldes eine Linse entwerfen und alle in einer Tabelle sehen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Design a mirror for each of several values of a field, and see all in a table</source>
            <translation>Für jeden von mehreren Werten eines Feldes einen Spiegel entwerfen und alle in einer Tabelle sehen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Restore run</source>
            <translation>La&amp;uf wiederherstellen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Give the design task and lens of the run chosen in the dock Runs</source>
            <translation>Dem Entwurf Aufgabe und Linse des im Bereich „Läufe“ gewählten Laufs geben</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Give the design task and mirror of the run chosen in the dock Runs</source>
            <translation>Dem Entwurf Aufgabe und Spiegel des im Bereich „Läufe“ gewählten Laufs geben</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Compare runs</source>
            <translation>Läufe &amp;vergleichen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>See the two runs chosen in the dock Runs beside each other: light, figures, fields</source>
            <translation>Die beiden im Bereich „Läufe“ gewählten Läufe nebeneinander sehen: Licht, Zahlen, Felder</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Delete runs</source>
            <translation>Läufe &amp;löschen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Forget the runs chosen in the dock Runs</source>
            <translation>Die im Bereich „Läufe“ gewählten Läufe verwerfen</translation>
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
            <source>Trace the lens on show anew, with rays that its design never saw; again to cancel</source>
            <translation>Die gezeigte Linse neu durchrechnen, mit Strahlen, die ihr Entwurf nie gesehen hat; erneut zum Abbrechen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Trace the mirror on show anew, with rays that its design never saw; again to cancel</source>
            <translation>Den gezeigten Spiegel neu durchrechnen, mit Strahlen, die sein Entwurf nie gesehen hat; erneut zum Abbrechen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Fit 3D view</source>
            <translation>3D-Ansicht &amp;einpassen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Show lens and screen whole</source>
            <translation>Linse und Schirm ganz zeigen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Show mirror and screen whole</source>
            <translation>Spiegel und Schirm ganz zeigen</translation>
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
            <source>See the lens as large as it can be</source>
            <translation>Die Linse so groß wie möglich sehen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>See the mirror as large as it can be</source>
            <translation>Den Spiegel so groß wie möglich sehen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Look at s&amp;creen</source>
            <translation>S&amp;chirm ansehen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>See the screen as large as it can be</source>
            <translation>Den Schirm so groß wie möglich sehen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>From the &amp;side</source>
            <translation>Von der Se&amp;ite</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Look at the 3D scene along x: light goes right</source>
            <translation>Die 3D-Szene entlang x ansehen: Licht läuft nach rechts</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>From a&amp;bove</source>
            <translation>Von &amp;oben</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Look at the 3D scene along y: light goes right</source>
            <translation>Die 3D-Szene entlang y ansehen: Licht läuft nach rechts</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Along the a&amp;xis</source>
            <translation>Entlang der &amp;Achse</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Look back along z from behind the screen</source>
            <translation>Entlang z von hinter dem Schirm zurückblicken</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Shorten gaps</source>
            <translation>Abstände &amp;verkürzen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Draw a far source and screen nearer, and a large screen smaller, to see the lens</source>
            <translation>Ferne Quelle und fernen Schirm näher, großen Schirm kleiner zeichnen, damit die Linse zu sehen ist</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Draw a far source and screen nearer, and a large screen smaller, to see the mirror</source>
            <translation>Ferne Quelle und fernen Schirm näher, großen Schirm kleiner zeichnen, damit der Spiegel zu sehen ist</translation>
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
            <source>Inferno</source>
            <translation>Inferno</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Colours of light in the images and on the screen of the 3D scene</source>
            <translation>Farben des Lichts in den Bildern und auf dem Schirm der 3D-Szene</translation>
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
            <source>Gray</source>
            <translation>Grau</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>As the &amp;system</source>
            <translation>Wie das &amp;System</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Show all windows light, dark, or as the system is</source>
            <translation>Alle Fenster hell, dunkel oder wie das System zeigen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Light</source>
            <translation>&amp;Hell</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Dark</source>
            <translation>&amp;Dunkel</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Language of the window; the command line speaks English</source>
            <translation>Sprache des Fensters; die Befehlszeile spricht Englisch</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>English</source>
            <translation>English</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Deutsch</source>
            <translation>Deutsch</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Français</source>
            <translation>Français</translation>
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
            <source>By the part of a ray's light that arrives</source>
            <translation>Nach dem Teil des Lichts eines Strahls, der ankommt</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>As their &amp;material</source>
            <translation>Wie ihr &amp;Material</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Faces of the lens as glass or metal</source>
            <translation>Flächen der Linse als Glas oder Metall</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Faces of the mirror as glass or metal</source>
            <translation>Flächen des Spiegels als Glas oder Metall</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>By &amp;height</source>
            <translation>Nach &amp;Höhe</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Faces of the lens from dark, low along z, to bright</source>
            <translation>Flächen der Linse von dunkel (tief entlang z) bis hell</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Faces of the mirror from dark, low along z, to bright</source>
            <translation>Flächen des Spiegels von dunkel (tief entlang z) bis hell</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>By &amp;curvature</source>
            <translation>Nach &amp;Krümmung</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Faces of the lens red where they are bowl-shaped towards +z, blue where humped</source>
            <translation>Flächen der Linse rot, wo sie zu +z hin schalenförmig sind, blau, wo gewölbt</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Faces of the mirror red where they are bowl-shaped towards +z, blue where humped</source>
            <translation>Flächen des Spiegels rot, wo sie zu +z hin schalenförmig sind, blau, wo gewölbt</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Relief exaggerated</source>
            <translation>&amp;Relief überhöht</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Light the fine shape of faces as if it were higher; the lens stays as it is</source>
            <translation>Die feine Form der Flächen so beleuchten, als wäre sie höher; die Linse bleibt, wie sie ist</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Light the fine shape of faces as if it were higher; the mirror stays as it is</source>
            <translation>Die feine Form der Flächen so beleuchten, als wäre sie höher; der Spiegel bleibt, wie er ist</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Perspective</source>
            <translation>&amp;Perspektive</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Draw what is farther away smaller, instead of in parallel</source>
            <translation>Entferntes kleiner zeichnen statt parallel</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Copy picture of 3&amp;D</source>
            <translation>3D-&amp;Bild kopieren</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Put the 3D scene on the clipboard</source>
            <translation>Die 3D-Szene in die Zwischenablage legen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>1 × as large…</source>
            <translation>1 × so groß …</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Save the 3D scene as PNG, 1 × as large as it is seen</source>
            <translation>Die 3D-Szene als PNG speichern, 1 × so groß wie gezeigt</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>2 × as large…</source>
            <translation>2 × so groß …</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Save the 3D scene as PNG, 2 × as large as it is seen</source>
            <translation>Die 3D-Szene als PNG speichern, 2 × so groß wie gezeigt</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>4 × as large…</source>
            <translation>4 × so groß …</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Save the 3D scene as PNG, 4 × as large as it is seen</source>
            <translation>Die 3D-Szene als PNG speichern, 4 × so groß wie gezeigt</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Turn</source>
            <translation>&amp;Drehen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Mouse and arrow keys turn the 3D scene; click to pick</source>
            <translation>Maus und Pfeiltasten drehen die 3D-Szene; Klick wählt aus</translation>
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
            <source>Paint control points that a run must leave</source>
            <translation>Kontrollpunkte markieren, die ein Lauf unverändert lässt</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Move source</source>
            <translation>&amp;Quelle verschieben</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Drag the source; Ctrl: along z</source>
            <translation>Die Quelle ziehen; Strg: entlang z</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Mark &amp;regions</source>
            <translation>Ausschnitte mark&amp;ieren</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Draw regions on the images of light, or move their edges: drag a rectangle, or click the corners of a polygon and double-click. Esc leaves</source>
            <translation>Ausschnitte auf den Bildern des Lichts zeichnen oder ihre Ränder verschieben: ein Rechteck ziehen, oder die Ecken eines Polygons anklicken und doppelklicken. Esc beendet das</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Image as wide and high as the &amp;picture</source>
            <translation>Bild so breit und hoch wie die Bild&amp;vorlage</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Give screen or far field, and their pixels, the aspect of the target's picture</source>
            <translation>Schirm oder Fernfeld und ihren Pixeln das Seitenverhältnis der Bildvorlage geben</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Freeform entrance face</source>
            <translation>&amp;Freiform-Eintrittsfläche</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Let light meet a second freeform face first, or a flat one again; the exit face stays</source>
            <translation>Das Licht zuerst auf eine zweite Freiformfläche treffen lassen oder wieder auf eine ebene; die Austrittsfläche bleibt</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Other face</source>
            <translation>A&amp;ndere Fläche</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Turn the lens over, to sculpt or lock its other freeform face</source>
            <translation>Die Linse umdrehen, um ihre andere Freiformfläche zu modellieren oder zu sperren</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Turn the mirror over, to sculpt or lock its other freeform face</source>
            <translation>Den Spiegel umdrehen, um seine andere Freiformfläche zu modellieren oder zu sperren</translation>
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
            <source>Leave the whole lens as it is in runs</source>
            <translation>Die ganze Linse in Läufen so lassen, wie sie ist</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Leave the whole mirror as it is in runs</source>
            <translation>Den ganzen Spiegel in Läufen so lassen, wie er ist</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Unlock all points</source>
            <translation>Alle Punkte freige&amp;ben</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Let runs change the whole lens</source>
            <translation>Läufe die ganze Linse ändern lassen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Let runs change the whole mirror</source>
            <translation>Läufe den ganzen Spiegel ändern lassen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Invert locks</source>
            <translation>Sperren &amp;umkehren</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Lock what is unlocked, and the reverse</source>
            <translation>Freies sperren und umgekehrt</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;3D scene</source>
            <translation>&amp;3D-Szene</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Show or hide the 3D scene</source>
            <translation>Die 3D-Szene zeigen oder verbergen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>R&amp;eset layout</source>
            <translation>Anord&amp;nung zurücksetzen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Put all docks where they stood at first</source>
            <translation>Alle Bereiche dorthin stellen, wo sie anfangs standen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Next pane</source>
            <translation>&amp;Nächster Bereich</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Take the keyboard to the next pane</source>
            <translation>Die Tastatur in den nächsten Bereich setzen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Previous pane</source>
            <translation>&amp;Voriger Bereich</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Take the keyboard to the pane before</source>
            <translation>Die Tastatur in den vorigen Bereich setzen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Design</source>
            <translation>Entwurf</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Show this pane and take the keyboard there</source>
            <translation>Diesen Bereich zeigen und die Tastatur dorthin setzen</translation>
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
            <source>Irradiance − target</source>
            <translation>Bestrahlungsstärke − Ziel</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Derivative</source>
            <translation>Ableitung</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Surface</source>
            <translation>Fläche</translation>
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
            <source>Through focus</source>
            <translation>Fokusreihe</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Predicted photo</source>
            <translation>Vorhergesagtes Foto</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Check</source>
            <translation>Prüfung</translation>
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
            <source>Light account</source>
            <translation>Lichtbilanz</translation>
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
            <source>All keys, to be found by name or by key</source>
            <translation>Alle Tasten, nach Namen oder Taste zu finden</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Tour</source>
            <translation>&amp;Rundgang</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>A short tour of the window</source>
            <translation>Ein kurzer Rundgang durch das Fenster</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Manual</source>
            <translation>&amp;Handbuch</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>All that can be done, here and in a shell, and what has been measured</source>
            <translation>Alles, was möglich ist, hier und in einer Shell, und was gemessen wurde</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;About</source>
            <translation>&amp;Über</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>What this program is</source>
            <translation>Was dieses Programm ist</translation>
        </message>
        <message>
            <location filename="../../ui/check/check.py" />
            <source>The light of this design is still being traced. Try again in a moment.</source>
            <translation>Das Licht dieses Entwurfs wird noch durchgerechnet. Gleich noch einmal versuchen.</translation>
        </message>
        <message>
            <location filename="../../ui/check/check.py" />
            <source>checking…</source>
            <translation>Prüfung läuft …</translation>
        </message>
        <message>
            <location filename="../../ui/check/check.py" />
            <source>checking… {part:.0f} %</source>
            <translation>Prüfung läuft … {part:.0f} %</translation>
        </message>
        <message>
            <location filename="../../ui/check/check.py" />
            <source>Check failed</source>
            <translation>Prüfung fehlgeschlagen</translation>
        </message>
        <message>
            <location filename="../../ui/check/check.py" />
            <source>Checked error {verified}</source>
            <translation>Geprüfter Fehler {verified}</translation>
        </message>
        <message>
            <location filename="../../ui/check/check.py" />
            <source>Check with {rays:,} fresh rays: relative L2 error {verified} ({low:.2f} to {high:.2f} %); with the scatter of the rays {relative_l2:.2f} ± {noise:.2f} %, loss {loss}; {efficiency:.1f} % {place}</source>
            <translation>Prüfung mit {rays:,} neuen Strahlen: relativer L2-Fehler {verified} ({low:.2f} bis {high:.2f} %); mit der Streuung der Strahlen {relative_l2:.2f} ± {noise:.2f} %, Zielfunktion {loss}; {efficiency:.1f} % {place}</translation>
        </message>
        <message>
            <location filename="../../ui/check/check.py" />
            <source>check</source>
            <translation>Prüfung</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>F8 traces what is on show anew, with rays that its design never saw.</source>
            <translation>F8 rechnet das Gezeigte neu durch, mit Strahlen, die sein Entwurf nie gesehen hat.</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>check failed</source>
            <translation>Prüfung fehlgeschlagen</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>Cells and random rays trace the same light by different means. Where they differ by more than noise and error bounds explain, one of them is wrong.</source>
            <translation>Zellen und Zufallsstrahlen berechnen dasselbe Licht auf verschiedenen Wegen. Weichen sie stärker ab, als Rauschen und Fehlerschranken erklären, ist eines von beiden falsch.</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>no deterministic figure</source>
            <translation>kein deterministischer Wert</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>The error is by random rays alone, whose noise is in the intervals below.</source>
            <translation>Der Fehler stammt allein von Zufallsstrahlen, deren Rauschen in den Intervallen unten steht.</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>optimiser and check</source>
            <translation>Optimierer und Prüfung</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>The image and the efficiency of the design differ from the check by more than errors explain: the optimiser traces fewer rays.</source>
            <translation>Bild und Wirkungsgrad des Entwurfs weichen von der Prüfung stärker ab, als Fehler erklären: der Optimierer rechnet weniger Strahlen.</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>verified error</source>
            <translation>geprüfter Fehler</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>Relative L2 error of image and target, by cells and without random rays: what the optic itself is off.</source>
            <translation>Relativer L2-Fehler von Bild und Ziel, über Zellen und ohne Zufallsstrahlen: die Abweichung der Optik selbst.</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>it is surely</source>
            <translation>er liegt sicher</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>Where that error lies, by a bound from two sizes of cells.</source>
            <translation>Wo dieser Fehler liegt, nach einer Schranke aus zwei Zellgrößen.</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>Cells of the entrance face whose light is spread over what they cover there.</source>
            <translation>Zellen der Eintrittsfläche, deren Licht auf das verteilt wird, was sie dort bedecken.</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>error by independent images</source>
            <translation>Fehler aus unabhängigen Bildern</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>Cells would have to be finer than time allows: the error, and where it lies with 95 % confidence, are from pairs of images by random rays: their scatter has no mean.</source>
            <translation>Die Zellen müssten feiner sein, als die Zeit erlaubt: der Fehler und wo er mit 95 % Konfidenz liegt, stammen aus Paaren von Bildern mit Zufallsstrahlen: ihre Streuung hat keinen Mittelwert.</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>random rays are off by</source>
            <translation>Zufallsstrahlen weichen ab um</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>Relative L2 difference of the two images: the second opinion. About once the noise of the rays is what chance alone makes.</source>
            <translation>Relative L2-Differenz der beiden Bilder: die Zweitmeinung. Etwa das Einfache des Strahlrauschens ist, was der Zufall allein ausmacht.</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>relative L2 error</source>
            <translation>relativer L2-Fehler</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>‖I − T‖ / ‖T‖ of image and target, each divided by its sum. The scatter of the rays from pixel to pixel is in it; more rays make it smaller.</source>
            <translation>‖I − T‖ / ‖T‖ von Bild und Ziel, jeweils durch ihre Summe geteilt. Die Streuung der Strahlen von Pixel zu Pixel ist darin; mehr Strahlen verkleinern sie.</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>95 % of other rays</source>
            <translation>95 % anderer Strahlen</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>Where the error with scatter lies for as many other rays.</source>
            <translation>Wo der Fehler mit Streuung für ebenso viele andere Strahlen liegt.</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>without ray noise</source>
            <translation>ohne Strahlrauschen</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>The same error without the scatter of the rays: what the optic itself is off. With &lt; if so few rays cannot tell it from none.</source>
            <translation>Derselbe Fehler ohne die Streuung der Strahlen: die Abweichung der Optik selbst. Mit &lt;, wenn so wenige Strahlen ihn nicht von keinem unterscheiden können.</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>95 % confidence</source>
            <translation>95 % Konfidenz</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>Where the error of the optic itself lies.</source>
            <translation>Wo der Fehler der Optik selbst liegt.</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>loss of the paper</source>
            <translation>Zielfunktion der Veröffentlichung</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>The norm of the difference between image and target, each divided by its sum, over the root of the number of pixels.</source>
            <translation>Die Norm der Differenz von Bild und Ziel, jeweils durch ihre Summe geteilt, durch die Wurzel der Pixelzahl.</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>PSNR</source>
            <translation>PSNR</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>Peak signal-to-noise ratio, against the target's peak: more is better.</source>
            <translation>Spitzen-Signal-Rausch-Verhältnis, bezogen auf die Spitze des Ziels: mehr ist besser.</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>SSIM</source>
            <translation>SSIM</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>Mean structural similarity in windows of 11 × 11 pixels: 1 for equal images.</source>
            <translation>Mittlere strukturelle Ähnlichkeit in Fenstern von 11 × 11 Pixeln: 1 bei gleichen Bildern.</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>Pearson's coefficient of image and target over the pixels: 1 for images of one shape.</source>
            <translation>Korrelationskoeffizient nach Pearson von Bild und Ziel über die Pixel: 1 bei Bildern gleicher Form.</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>Least over mean of irradiance / target where the target is lit, at half its peak or more: 1 is even, 0 has a dark pixel.</source>
            <translation>Kleinstes durch Mittel von Bestrahlungsstärke / Ziel, wo das Ziel hell ist, ab der Hälfte seiner Spitze: 1 ist gleichmäßig, 0 hat ein dunkles Pixel.</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>(lit − black) / (lit + black) of the mean irradiances there; black is up to a hundredth of the target's peak. 1 is a perfect black.</source>
            <translation>(hell − schwarz) / (hell + schwarz) der mittleren Bestrahlungsstärken dort; schwarz ist bis zu einem Hundertstel der Spitze des Ziels. 1 ist vollkommenes Schwarz.</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>Part of the emitted light that makes the image.</source>
            <translation>Teil des ausgesandten Lichts, der das Bild macht.</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>meets the face again</source>
            <translation>trifft die Fläche erneut</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>Light that comes back to the face which it leaves, as in a deep bowl. Image and efficiency count it as if nothing were in its way.</source>
            <translation>Licht, das zu der Fläche zurückkommt, die es verlässt, wie in einer tiefen Schale. Bild und Wirkungsgrad zählen es, als wäre nichts im Weg.</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>comes through the screen</source>
            <translation>kommt durch den Schirm</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>Light that the screen keeps from the mirror. Image and efficiency count it as if the screen were not in its way; a screen beside the axis is not.</source>
            <translation>Licht, das der Schirm vom Spiegel fernhält. Bild und Wirkungsgrad zählen es, als wäre der Schirm nicht im Weg; ein Schirm neben der Achse ist es nicht.</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>off the optimiser's image</source>
            <translation>Abweichung vom Bild des Optimierers</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>Relative L2 difference to the image that the optimiser sees. Its filter and the scatter of these rays are in it.</source>
            <translation>Relative L2-Differenz zum Bild, das der Optimierer sieht. Sein Filter und die Streuung dieser Strahlen sind darin.</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>Rays of the image; a quarter as many more are traced for the error without scatter.</source>
            <translation>Strahlen des Bildes; für den Fehler ohne Streuung wird ein Viertel mehr gerechnet.</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>cells</source>
            <translation>Zellen</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>correlation</source>
            <translation>Korrelation</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>uniformity</source>
            <translation>Gleichmäßigkeit</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>contrast</source>
            <translation>Kontrast</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>efficiency</source>
            <translation>Wirkungsgrad</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>rays</source>
            <translation>Strahlen</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>Part of the emitted light that falls on the region, and its darkest and brightest pixel over the mean: 1 is even.</source>
            <translation>Teil des ausgesandten Lichts, der auf den Ausschnitt fällt, und sein dunkelstes und hellstes Pixel bezogen auf das Mittel: 1 ist gleichmäßig.</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>Figures of the check</source>
            <translation>Zahlen der Prüfung</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>Copy</source>
            <translation>Kopieren</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>Rays of a check</source>
            <translation>Strahlen einer Prüfung</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>Rays of a check; four times as many halve their scatter</source>
            <translation>Strahlen einer Prüfung; viermal so viele halbieren die Streuung</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>{rays} million rays</source>
            <translation>{rays} Mio. Strahlen</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>Put all figures on the clipboard, a tab between name and value</source>
            <translation>Alle Zahlen in die Zwischenablage legen, ein Tabulator zwischen Name und Wert</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>image {number}: {name}</source>
            <translation>Bild {number}: {name}</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source> Out of date: these figures are of the design before.</source>
            <translation> Veraltet: diese Zahlen gehören zum vorigen Entwurf.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/actions.py" />
            <source>Toolbar</source>
            <translation>Werkzeugleiste</translation>
        </message>
        <message>
            <location filename="../../ui/commands/availability.py" />
            <source>There is one freeform face: Freeform entrance face gives a lens a second one</source>
            <translation>Es gibt eine Freiformfläche: „Freiform-Eintrittsfläche“ gibt einer Linse eine zweite</translation>
        </message>
        <message>
            <location filename="../../ui/commands/availability.py" />
            <source>Not while a run goes on: it works on the design as it was when it began. Stop it first</source>
            <translation>Nicht während eines Laufs: er arbeitet am Entwurf, wie er zu Beginn war. Zuerst stoppen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/availability.py" />
            <source>Flat &amp;entrance face</source>
            <translation>&amp;Ebene Eintrittsfläche</translation>
        </message>
        <message>
            <location filename="../../ui/commands/availability.py" />
            <source>Freeform &amp;entrance face</source>
            <translation>Fr&amp;eiform-Eintrittsfläche</translation>
        </message>
        <message>
            <location filename="../../ui/commands/availability.py" />
            <source>&amp;Start over</source>
            <translation>&amp;Neu starten</translation>
        </message>
        <message>
            <location filename="../../ui/commands/availability.py" />
            <source>&amp;Resume</source>
            <translation>&amp;Weiter</translation>
        </message>
        <message>
            <location filename="../../ui/commands/availability.py" />
            <source>There is no lens yet: Start designs one</source>
            <translation>Es gibt noch keine Linse: Start entwirft eine</translation>
        </message>
        <message>
            <location filename="../../ui/commands/availability.py" />
            <source>There is no mirror yet: Start designs one</source>
            <translation>Es gibt noch keinen Spiegel: Start entwirft einen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/availability.py" />
            <source>the best lens so far</source>
            <translation>die bisher beste Linse</translation>
        </message>
        <message>
            <location filename="../../ui/commands/availability.py" />
            <source>the best mirror so far</source>
            <translation>der bisher beste Spiegel</translation>
        </message>
        <message>
            <location filename="../../ui/commands/availability.py" />
            <source>Takes {lens}</source>
            <translation>Verwendet wird: {lens}</translation>
        </message>
        <message>
            <location filename="../../ui/commands/availability.py" />
            <source>A lens has one freeform face</source>
            <translation>Eine Linse hat eine Freiformfläche</translation>
        </message>
        <message>
            <location filename="../../ui/commands/availability.py" />
            <source>A mirror has one freeform face</source>
            <translation>Ein Spiegel hat eine Freiformfläche</translation>
        </message>
        <message>
            <location filename="../../ui/commands/language_choice.py" />
            <source>The language changes at the next start.</source>
            <translation>Die Sprache ändert sich beim nächsten Start.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/palette.py" />
            <source>Command palette</source>
            <translation>Befehlspalette</translation>
        </message>
        <message>
            <location filename="../../ui/commands/palette.py" />
            <source>Type parts of a command's name</source>
            <translation>Teile eines Befehlsnamens eingeben</translation>
        </message>
        <message>
            <location filename="../../ui/commands/palette.py" />
            <source>No command has all of this in its name: {words}</source>
            <translation>Kein Befehl hat all das im Namen: {words}</translation>
        </message>
        <message>
            <location filename="../../ui/commands/shortcuts.py" />
            <source>Keyboard shortcuts</source>
            <translation>Tastenkürzel</translation>
        </message>
        <message>
            <location filename="../../ui/commands/shortcuts.py" />
            <source>Find by a part of the name, or by the key</source>
            <translation>Nach einem Teil des Namens oder nach der Taste suchen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/shortcuts.py" />
            <source>Find a shortcut</source>
            <translation>Tastenkürzel suchen</translation>
        </message>
        <message>
            <location filename="../../ui/commands/shortcuts.py" />
            <source>Command</source>
            <translation>Befehl</translation>
        </message>
        <message>
            <location filename="../../ui/commands/shortcuts.py" />
            <source>Key</source>
            <translation>Taste</translation>
        </message>
        <message>
            <location filename="../../ui/document/document.py" />
            <source>new reading of the image</source>
            <translation>Bild neu lesen</translation>
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
            <source>{path} is no longer there; it was taken off the list.</source>
            <translation>{path} gibt es nicht mehr; der Eintrag wurde aus der Liste genommen.</translation>
        </message>
        <message>
            <location filename="../../ui/files/actions.py" />
            <source>{name}: the name of a design ends in {ending}</source>
            <translation>{name}: der Name eines Entwurfs endet auf {ending}</translation>
        </message>
        <message>
            <location filename="../../ui/files/actions.py" />
            <source>Save as</source>
            <translation>Speichern unter</translation>
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
            <source>{name} is open in another window: choose another name.</source>
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
            <location filename="../../ui/files/changed.py" />
            <source>The file has changed</source>
            <translation>Die Datei hat sich geändert</translation>
        </message>
        <message>
            <location filename="../../ui/files/changed.py" />
            <source>Another program has changed {name} since it was last read or saved here.</source>
            <translation>Ein anderes Programm hat {name} geändert, seit die Datei hier zuletzt gelesen oder gespeichert wurde.</translation>
        </message>
        <message>
            <location filename="../../ui/files/changed.py" />
            <source>Overwrite loses what the file holds now. Reload shows it in place of your design; Undo brings your design back.</source>
            <translation>Überschreiben verwirft, was die Datei jetzt enthält. Neu laden zeigt sie an Stelle Ihres Entwurfs; Rückgängig bringt Ihren Entwurf zurück.</translation>
        </message>
        <message>
            <location filename="../../ui/files/changed.py" />
            <source>&amp;Overwrite</source>
            <translation>Ü&amp;berschreiben</translation>
        </message>
        <message>
            <location filename="../../ui/files/changed.py" />
            <source>&amp;Reload</source>
            <translation>&amp;Neu laden</translation>
        </message>
        <message>
            <location filename="../../ui/files/changed.py" />
            <source>The file is gone</source>
            <translation>Die Datei ist verschwunden</translation>
        </message>
        <message>
            <location filename="../../ui/files/changed.py" />
            <source>{name} has been deleted, moved or renamed since it was last saved here.</source>
            <translation>{name} wurde gelöscht, verschoben oder umbenannt, seit die Datei hier zuletzt gespeichert wurde.</translation>
        </message>
        <message>
            <location filename="../../ui/files/changed.py" />
            <source>&amp;Save there again</source>
            <translation>&amp;Dort wieder speichern</translation>
        </message>
        <message>
            <location filename="../../ui/files/changed.py" />
            <source>Its folder, {parent}, is gone, too.</source>
            <translation>Auch der Ordner {parent} ist verschwunden.</translation>
        </message>
        <message>
            <location filename="../../ui/files/chosen_files.py" />
            <source>{name} is a file of light, not a design.</source>
            <translation>{name} ist eine Lichtdatei, kein Entwurf.</translation>
        </message>
        <message>
            <location filename="../../ui/files/chosen_files.py" />
            <source>Use as light source</source>
            <translation>Als Lichtquelle verwenden</translation>
        </message>
        <message>
            <location filename="../../ui/files/chosen_files.py" />
            <source>{name} is a picture, not a design.</source>
            <translation>{name} ist ein Bild, kein Entwurf.</translation>
        </message>
        <message>
            <location filename="../../ui/files/chosen_files.py" />
            <source>Use as target</source>
            <translation>Als Ziel verwenden</translation>
        </message>
        <message>
            <location filename="../../ui/files/chosen_files.py" />
            <source>There is no picture on the clipboard.</source>
            <translation>In der Zwischenablage ist kein Bild.</translation>
        </message>
        <message>
            <location filename="../../ui/files/chosen_files.py" />
            <source>Target image</source>
            <translation>Zielbild</translation>
        </message>
        <message>
            <location filename="../../ui/files/chosen_files.py" />
            <source>File of light</source>
            <translation>Lichtdatei</translation>
        </message>
        <message>
            <location filename="../../ui/files/exporter.py" />
            <source>export</source>
            <translation>Export</translation>
        </message>
        <message>
            <location filename="../../ui/files/exporter.py" />
            <source>Cut {lens}</source>
            <translation>Fräsen: {lens}</translation>
        </message>
        <message>
            <location filename="../../ui/files/exporter.py" />
            <source>One file is still being written; export the next after it.</source>
            <translation>Eine Datei wird noch geschrieben; die nächste danach exportieren.</translation>
        </message>
        <message>
            <location filename="../../ui/files/exporter.py" />
            <source>{name} is being written…</source>
            <translation>{name} wird geschrieben …</translation>
        </message>
        <message>
            <location filename="../../ui/files/exporter.py" />
            <source>Cancel</source>
            <translation>Abbrechen</translation>
        </message>
        <message>
            <location filename="../../ui/files/exporter.py" />
            <source>Export {lens}</source>
            <translation>Exportieren: {lens}</translation>
        </message>
        <message>
            <location filename="../../ui/files/exporter.py" />
            <source>No file is written.</source>
            <translation>Es wird keine Datei geschrieben.</translation>
        </message>
        <message>
            <location filename="../../ui/files/exporter.py" />
            <source>{format} in {unit}</source>
            <translation>{format} in {unit}</translation>
        </message>
        <message>
            <location filename="../../ui/files/gallery.py" />
            <source>New from example</source>
            <translation>Neu aus Beispiel</translation>
        </message>
        <message>
            <location filename="../../ui/files/gallery.py" />
            <source>Examples</source>
            <translation>Beispiele</translation>
        </message>
        <message>
            <location filename="../../ui/files/left_behind.py" />
            <source>Unsaved work</source>
            <translation>Ungespeicherte Arbeit</translation>
        </message>
        <message>
            <location filename="../../ui/files/left_behind.py" />
            <source>{name} had unsaved changes when the workbench was asked to end.</source>
            <translation>{name} hatte ungespeicherte Änderungen, als die Workbench beendet wurde.</translation>
        </message>
        <message>
            <location filename="../../ui/files/left_behind.py" />
            <source>The workbench was not closed. Unsaved changes to {name} were kept.</source>
            <translation>Die Workbench wurde nicht geschlossen. Ungespeicherte Änderungen an {name} wurden aufbewahrt.</translation>
        </message>
        <message>
            <location filename="../../ui/files/left_behind.py" />
            <source>Kept on {kept_at:%Y-%m-%d, %H:%M:%S}.</source>
            <translation>Aufbewahrt am {kept_at:%Y-%m-%d, %H:%M:%S}.</translation>
        </message>
        <message>
            <location filename="../../ui/files/left_behind.py" />
            <source>&amp;Recover</source>
            <translation>&amp;Wiederherstellen</translation>
        </message>
        <message>
            <location filename="../../ui/files/left_behind.py" />
            <source>&amp;Discard</source>
            <translation>&amp;Verwerfen</translation>
        </message>
        <message>
            <location filename="../../ui/files/left_behind.py" />
            <source>Ask &amp;later</source>
            <translation>&amp;Später fragen</translation>
        </message>
        <message>
            <location filename="../../ui/files/photo_picture.py" />
            <source>There is no photo of this lens yet; save it once it is seen.</source>
            <translation>Von dieser Linse gibt es noch kein Foto; speichern, sobald es zu sehen ist.</translation>
        </message>
        <message>
            <location filename="../../ui/files/photo_picture.py" />
            <source>{design} photo</source>
            <translation>{design} Foto</translation>
        </message>
        <message>
            <location filename="../../ui/files/photo_picture.py" />
            <source>Picture ({endings})</source>
            <translation>Bild ({endings})</translation>
        </message>
        <message>
            <location filename="../../ui/files/photo_picture.py" />
            <source>Save predicted photo</source>
            <translation>Vorhergesagtes Foto speichern</translation>
        </message>
        <message>
            <location filename="../../ui/files/photo_picture.py" />
            <source>The lens has changed since; save the photo of the new one.</source>
            <translation>Die Linse hat sich seitdem geändert; das Foto der neuen speichern.</translation>
        </message>
        <message>
            <location filename="../../ui/files/photo_picture.py" />
            <source>{path} is written.</source>
            <translation>{path} ist geschrieben.</translation>
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
            <source>{name}: a plot is saved as one of {known}</source>
            <translation>{name}: ein Diagramm wird als eines von {known} gespeichert</translation>
        </message>
        <message>
            <location filename="../../ui/files/plots.py" />
            <source>Save {pane} plot</source>
            <translation>Diagramm „{pane}“ speichern</translation>
        </message>
        <message>
            <location filename="../../ui/files/plots.py" />
            <source>There is no plot to be seen; View shows the docks of all plots.</source>
            <translation>Es ist kein Diagramm zu sehen; „Ansicht“ zeigt die Bereiche aller Diagramme.</translation>
        </message>
        <message>
            <location filename="../../ui/files/plots.py" />
            <source>One plot is still being written; save the next after it.</source>
            <translation>Ein Diagramm wird noch geschrieben; das nächste danach speichern.</translation>
        </message>
        <message>
            <location filename="../../ui/files/recovery.py" />
            <source>recovery</source>
            <translation>Sicherung</translation>
        </message>
        <message>
            <location filename="../../ui/files/recovery.py" />
            <source>Unsaved work cannot be kept for a recovery. {reason}</source>
            <translation>Ungespeicherte Arbeit kann nicht für eine Wiederherstellung aufbewahrt werden. {reason}</translation>
        </message>
        <message>
            <location filename="../../ui/files/reporter.py" />
            <source>Web page (*.html)</source>
            <translation>Webseite (*.html)</translation>
        </message>
        <message>
            <location filename="../../ui/files/reporter.py" />
            <source>Document (*.pdf)</source>
            <translation>Dokument (*.pdf)</translation>
        </message>
        <message>
            <location filename="../../ui/files/reporter.py" />
            <source>report</source>
            <translation>Bericht</translation>
        </message>
        <message>
            <location filename="../../ui/files/reporter.py" />
            <source>One report is still being written; ask for the next after it.</source>
            <translation>Ein Bericht wird noch geschrieben; den nächsten danach anfordern.</translation>
        </message>
        <message>
            <location filename="../../ui/files/reporter.py" />
            <source>{file} is being written, with a check of {lens}…</source>
            <translation>{file} wird geschrieben, mit einer Prüfung ({lens}) …</translation>
        </message>
        <message>
            <location filename="../../ui/files/reporter.py" />
            <source>Report {lens}</source>
            <translation>Bericht: {lens}</translation>
        </message>
        <message>
            <location filename="../../ui/files/reporter.py" />
            <source>No report is written.</source>
            <translation>Es wird kein Bericht geschrieben.</translation>
        </message>
        <message>
            <location filename="../../ui/files/scene_pictures.py" />
            <source>A picture of the 3D scene is on the clipboard.</source>
            <translation>Ein Bild der 3D-Szene ist in der Zwischenablage.</translation>
        </message>
        <message>
            <location filename="../../ui/files/scene_pictures.py" />
            <source>{path} is written, {width} × {height} pixels.</source>
            <translation>{path} ist geschrieben, {width} × {height} Pixel.</translation>
        </message>
        <message>
            <location filename="../../ui/files/scene_pictures.py" />
            <source>Save picture of 3D</source>
            <translation>3D-Bild speichern</translation>
        </message>
        <message>
            <location filename="../../ui/files/scene_pictures.py" />
            <source>The 3D scene is hidden; View &gt; 3D scene shows it.</source>
            <translation>Die 3D-Szene ist verborgen; Ansicht &gt; 3D-Szene zeigt sie.</translation>
        </message>
        <message>
            <location filename="../../ui/help/help.py" />
            <source>New here? A tour of {count} steps shows what is where. Help &gt; Tour begins it at any time.</source>
            <translation>Neu hier? Ein Rundgang mit {count} Schritten zeigt, was wo ist. Hilfe &gt; Rundgang beginnt ihn jederzeit.</translation>
        </message>
        <message>
            <location filename="../../ui/help/help.py" />
            <source>Show me around</source>
            <translation>Rundgang beginnen</translation>
        </message>
        <message>
            <location filename="../../ui/help/help.py" />
            <source>About {title}</source>
            <translation>Über {title}</translation>
        </message>
        <message>
            <location filename="../../ui/help/help.py" />
            <source>&lt;h3&gt;{title} {version}&lt;/h3&gt;&lt;p&gt;Shapes a freeform lens until it throws the wanted image of light.&lt;/p&gt;&lt;p&gt;MIT licence&lt;/p&gt;</source>
            <translation>&lt;h3&gt;{title} {version}&lt;/h3&gt;&lt;p&gt;Formt eine Freiformlinse, bis sie das gewünschte Bild aus Licht wirft.&lt;/p&gt;&lt;p&gt;MIT-Lizenz&lt;/p&gt;</translation>
        </message>
        <message>
            <location filename="../../ui/help/manual.py" />
            <source>Manual</source>
            <translation>Handbuch</translation>
        </message>
        <message>
            <location filename="../../ui/help/manual.py" />
            <source>Search</source>
            <translation>Suchen</translation>
        </message>
        <message>
            <location filename="../../ui/help/manual.py" />
            <source>Search the manual</source>
            <translation>Im Handbuch suchen</translation>
        </message>
        <message>
            <location filename="../../ui/help/manual.py" />
            <source>Words that a page must hold; Return goes to the next place</source>
            <translation>Wörter, die eine Seite enthalten muss; die Eingabetaste geht zur nächsten Stelle</translation>
        </message>
        <message>
            <location filename="../../ui/help/manual.py" />
            <source>Pages of the manual</source>
            <translation>Seiten des Handbuchs</translation>
        </message>
        <message>
            <location filename="../../ui/help/manual.py" />
            <source>No page has all of this: {words}</source>
            <translation>Keine Seite enthält all das: {words}</translation>
        </message>
        <message>
            <location filename="../../ui/help/tour.py" />
            <source>Describe the task</source>
            <translation>Die Aufgabe beschreiben</translation>
        </message>
        <message>
            <location filename="../../ui/help/tour.py" />
            <source>Here you say what you have and what you want: the image of light, the lens, the source, the screen. What is not possible is refused beside the field, with what would be allowed. Any picture dropped onto the window becomes the target.</source>
            <translation>Hier steht, was vorhanden ist und was gewünscht wird: das Bild aus Licht, die Linse, die Quelle, der Schirm. Was nicht möglich ist, wird neben dem Feld abgelehnt, mit dem, was erlaubt wäre. Jedes auf das Fenster gezogene Bild wird zum Ziel.</translation>
        </message>
        <message>
            <location filename="../../ui/help/tour.py" />
            <source>Start</source>
            <translation>Start</translation>
        </message>
        <message>
            <location filename="../../ui/help/tour.py" />
            <source>Start (F5) shapes the lens until its light fits the target. Pause (F6) holds it, Stop (F7) keeps the best lens so far, Continue goes on from there.</source>
            <translation>Start (F5) formt die Linse, bis ihr Licht zum Ziel passt. Pause (F6) hält an, Stopp (F7) behält die bisher beste Linse, Fortsetzen macht von dort weiter.</translation>
        </message>
        <message>
            <location filename="../../ui/help/tour.py" />
            <source>Watch the light</source>
            <translation>Dem Licht zusehen</translation>
        </message>
        <message>
            <location filename="../../ui/help/tour.py" />
            <source>Lens, rays and screen. Drag to turn, Shift-drag to move, scroll to zoom, or use arrow keys, + and −. Ctrl+1 looks at the lens, Ctrl+2 at the screen, Ctrl+0 shows all again; Ctrl+D draws a far screen nearer.</source>
            <translation>Linse, Strahlen und Schirm. Ziehen dreht, Ziehen mit Umschalttaste verschiebt, das Mausrad zoomt; auch Pfeiltasten, + und −. Strg+1 zeigt die Linse, Strg+2 den Schirm, Strg+0 wieder alles; Strg+D zeichnet einen fernen Schirm näher.</translation>
        </message>
        <message>
            <location filename="../../ui/help/tour.py" />
            <source>See what reaches the screen</source>
            <translation>Sehen, was den Schirm erreicht</translation>
        </message>
        <message>
            <location filename="../../ui/help/tour.py" />
            <source>Flux per area, live. Below it what is still wrong: too much light is red, too little is blue. Both zoom and move together.</source>
            <translation>Lichtstrom je Fläche, laufend. Daneben, was noch nicht stimmt: zu viel Licht ist rot, zu wenig blau. Beide zoomen und verschieben sich gemeinsam.</translation>
        </message>
        <message>
            <location filename="../../ui/help/tour.py" />
            <source>Look back</source>
            <translation>Zurückblicken</translation>
        </message>
        <message>
            <location filename="../../ui/help/tour.py" />
            <source>The curve falls while the lens gets better. The slider below it shows the lens at any kept moment of the run; you can go on from there.</source>
            <translation>Die Kurve fällt, während die Linse besser wird. Der Schieber darunter zeigt die Linse zu jedem aufbewahrten Zeitpunkt des Laufs; von dort lässt sich fortfahren.</translation>
        </message>
        <message>
            <location filename="../../ui/help/tour.py" />
            <source>Nothing is lost</source>
            <translation>Nichts geht verloren</translation>
        </message>
        <message>
            <location filename="../../ui/help/tour.py" />
            <source>Every edit and every run is a step. Undo with Ctrl+Z, or click a step to go there. Unsaved work is kept every minute, even if the program breaks off.</source>
            <translation>Jede Änderung und jeder Lauf ist ein Schritt. Mit Strg+Z rückgängig machen oder einen Schritt anklicken. Ungespeicherte Arbeit wird jede Minute gesichert, auch wenn das Programm abbricht.</translation>
        </message>
        <message>
            <location filename="../../ui/help/tour.py" />
            <source>Find anything</source>
            <translation>Alles finden</translation>
        </message>
        <message>
            <location filename="../../ui/help/tour.py" />
            <source>Ctrl+Shift+P finds any command by parts of its name. File &gt; New from gallery has examples by their pictures, File &gt; Export takes the lens to other programs. Enjoy!</source>
            <translation>Strg+Umschalt+P findet jeden Befehl nach Teilen seines Namens. Datei &gt; Neu aus Galerie zeigt Beispiele als Bilder, Datei &gt; Exportieren gibt die Linse an andere Programme. Viel Freude!</translation>
        </message>
        <message>
            <location filename="../../ui/help/tour.py" />
            <source>&amp;End</source>
            <translation>&amp;Beenden</translation>
        </message>
        <message>
            <location filename="../../ui/help/tour.py" />
            <source>&amp;Back</source>
            <translation>&amp;Zurück</translation>
        </message>
        <message>
            <location filename="../../ui/help/tour.py" />
            <source>End the tour (Esc); Help &gt; Tour begins it again</source>
            <translation>Den Rundgang beenden (Esc); Hilfe &gt; Rundgang beginnt ihn wieder</translation>
        </message>
        <message>
            <location filename="../../ui/help/tour.py" />
            <source>{number} of {count}</source>
            <translation>{number} von {count}</translation>
        </message>
        <message>
            <location filename="../../ui/help/tour.py" />
            <source>&amp;Done</source>
            <translation>&amp;Fertig</translation>
        </message>
        <message>
            <location filename="../../ui/help/tour.py" />
            <source>&amp;Next</source>
            <translation>&amp;Weiter</translation>
        </message>
        <message>
            <location filename="../../ui/jobs/drawing.py" />
            <source>The job from the side</source>
            <translation>Die Aufgabe von der Seite</translation>
        </message>
        <message>
            <location filename="../../ui/jobs/drawing.py" />
            <source>From the side</source>
            <translation>Von der Seite</translation>
        </message>
        <message>
            <location filename="../../ui/jobs/drawing.py" />
            <source>From above</source>
            <translation>Von oben</translation>
        </message>
        <message>
            <location filename="../../ui/jobs/drawing.py" />
            <source>, {across:.1f} × as high</source>
            <translation>, {across:.1f}-fach überhöht</translation>
        </message>
        <message>
            <location filename="../../ui/jobs/drawing.py" />
            <source>, to scale</source>
            <translation>, maßstäblich</translation>
        </message>
        <message>
            <location filename="../../ui/jobs/form.py" />
            <source>picture</source>
            <translation>Bild</translation>
        </message>
        <message>
            <location filename="../../ui/jobs/form.py" />
            <source>file of light</source>
            <translation>Lichtdatei</translation>
        </message>
        <message>
            <location filename="../../ui/jobs/outlook.py" />
            <source>outlook</source>
            <translation>Vorschau</translation>
        </message>
        <message>
            <location filename="../../ui/jobs/outlook.py" />
            <source>Picture at best</source>
            <translation>Bild im besten Fall</translation>
        </message>
        <message>
            <location filename="../../ui/jobs/outlook.py" />
            <source>Blurred by the size of the light, as any lens has to</source>
            <translation>Unscharf durch die Größe der Lichtquelle, wie bei jeder Linse</translation>
        </message>
        <message>
            <location filename="../../ui/jobs/outlook.py" />
            <source>Wanted</source>
            <translation>Gewünscht</translation>
        </message>
        <message>
            <location filename="../../ui/jobs/outlook.py" />
            <source>At best</source>
            <translation>Bestmöglich</translation>
        </message>
        <message>
            <location filename="../../ui/jobs/outlook.py" />
            <source>Computing what can be expected…</source>
            <translation>Ermittle, was zu erwarten ist …</translation>
        </message>
        <message>
            <location filename="../../ui/jobs/outlook.py" />
            <source>The figures are of the answers before.</source>
            <translation>Die Werte gehören zu den vorherigen Angaben.</translation>
        </message>
        <message>
            <location filename="../../ui/jobs/outlook.py" />
            <source>Estimating… {part:.0f} %</source>
            <translation>Schätzung läuft … {part:.0f} %</translation>
        </message>
        <message>
            <location filename="../../ui/jobs/page.py" />
            <source>New design</source>
            <translation>Neuer Entwurf</translation>
        </message>
        <message>
            <location filename="../../ui/jobs/page.py" />
            <source>Jobs</source>
            <translation>Aufgaben</translation>
        </message>
        <message>
            <location filename="../../ui/jobs/page.py" />
            <source>&amp;Begin</source>
            <translation>&amp;Beginnen</translation>
        </message>
        <message>
            <location filename="../../ui/jobs/page.py" />
            <source>&amp;Open a file…</source>
            <translation>Datei &amp;öffnen …</translation>
        </message>
        <message>
            <location filename="../../ui/jobs/page.py" />
            <source>E&amp;xamples…</source>
            <translation>B&amp;eispiele …</translation>
        </message>
        <message>
            <location filename="../../ui/jobs/page.py" />
            <source>Cannot begin: {reason}</source>
            <translation>Beginn nicht möglich: {reason}</translation>
        </message>
        <message>
            <location filename="../../ui/jobs/page.py" />
            <source>Picture</source>
            <translation>Motiv</translation>
        </message>
        <message>
            <location filename="../../ui/lens/brush.py" />
            <source>a single point</source>
            <translation>ein einzelner Punkt</translation>
        </message>
        <message>
            <location filename="../../ui/lens/brush.py" />
            <source>radius {radius}</source>
            <translation>Radius {radius}</translation>
        </message>
        <message>
            <location filename="../../ui/lens/live.py" />
            <source>trace of the lens</source>
            <translation>Durchrechnung der Linse</translation>
        </message>
        <message>
            <location filename="../../ui/lens/live.py" />
            <source>trace of the mirror</source>
            <translation>Durchrechnung des Spiegels</translation>
        </message>
        <message>
            <location filename="../../ui/lens/lock.py" />
            <source>{place}Paint over control points to lock them, or unlock them where you begin on a lock; or use arrows and Space. Brush, [ and ]: {words}. {count} locked</source>
            <translation>{place}Über Kontrollpunkte malen, um sie zu sperren, oder freizugeben, wenn auf einem gesperrten begonnen wird; oder mit Pfeilen und Leertaste. Pinsel, [ und ]: {words}. {count} gesperrt</translation>
        </message>
        <message>
            <location filename="../../ui/lens/move_source.py" />
            <source>Collimated light comes from everywhere: choose another source to move it</source>
            <translation>Kollimiertes Licht kommt von überall: zum Verschieben eine andere Quelle wählen</translation>
        </message>
        <message>
            <location filename="../../ui/lens/move_source.py" />
            <source>Drag the source across, Ctrl: along z; or use arrows, Page Up and Page Down; Shift: finely; Esc: back. </source>
            <translation>Die Quelle quer ziehen, Strg: entlang z; oder mit Pfeilen, Bild auf und Bild ab; Umschalt: fein; Esc: zurück. </translation>
        </message>
        <message>
            <location filename="../../ui/lens/move_source.py" />
            <source>Corners: its size. </source>
            <translation>Ecken: ihre Größe. </translation>
        </message>
        <message>
            <location filename="../../ui/lens/sculpt.py" />
            <source>{place}Drag control points along z, or use arrows, Page Up and Page Down; Shift: finely; Esc: back. Brush, [ and ]: {words}</source>
            <translation>{place}Kontrollpunkte entlang z ziehen, oder mit Pfeilen, Bild auf und Bild ab; Umschalt: fein; Esc: zurück. Pinsel, [ und ]: {words}</translation>
        </message>
        <message>
            <location filename="../../ui/lens/sculpt.py" />
            <source>. Moved by {rise:+.4g} {unit}</source>
            <translation>. Verschoben um {rise:+.4g} {unit}</translation>
        </message>
        <message>
            <location filename="../../ui/lens/sculpt.py" />
            <source>All control points in the brush are locked; unlock some first.</source>
            <translation>Alle Kontrollpunkte im Pinsel sind gesperrt; zuerst einige freigeben.</translation>
        </message>
        <message>
            <location filename="../../ui/lens/tools.py" />
            <source>Stop the run first; then change the lens by hand.</source>
            <translation>Zuerst den Lauf stoppen, dann die Linse von Hand ändern.</translation>
        </message>
        <message>
            <location filename="../../ui/lens/tools.py" />
            <source>Stop the run first; then change the mirror by hand.</source>
            <translation>Zuerst den Lauf stoppen, dann den Spiegel von Hand ändern.</translation>
        </message>
        <message>
            <location filename="../../ui/lens/tools.py" />
            <source>There is no lens to shape yet.</source>
            <translation>Es gibt noch keine Linse zum Modellieren.</translation>
        </message>
        <message>
            <location filename="../../ui/lens/tools.py" />
            <source>There is no mirror to shape yet.</source>
            <translation>Es gibt noch keinen Spiegel zum Modellieren.</translation>
        </message>
        <message>
            <location filename="../../ui/lens/tools.py" />
            <source>There is one freeform face. Design &gt; Freeform entrance face gives a lens a second one.</source>
            <translation>Es gibt eine Freiformfläche. Entwurf &gt; Freiform-Eintrittsfläche gibt einer Linse eine zweite.</translation>
        </message>
        <message>
            <location filename="../../ui/lens/tools.py" />
            <source>Show distances to scale first (View &gt; Shorten gaps); then move the source.</source>
            <translation>Zuerst Abstände maßstäblich zeigen (Ansicht &gt; Abstände verkürzen), dann die Quelle verschieben.</translation>
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
            <source>move the source</source>
            <translation>Quelle verschieben</translation>
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
            <source>Oldest steps ({count}) forgotten: too much memory to undo</source>
            <translation>Älteste Schritte ({count}) verworfen: zu viel Speicher zum Rückgängigmachen</translation>
        </message>
        <message>
            <location filename="../../ui/main_window.py" />
            <source>{design} is still being designed. Stop, and save its best lens?</source>
            <translation>{design} wird noch entworfen. Stoppen und die beste Linse speichern?</translation>
        </message>
        <message>
            <location filename="../../ui/main_window.py" />
            <source>{design} is still being designed. Stop, and save its best mirror?</source>
            <translation>{design} wird noch entworfen. Stoppen und den besten Spiegel speichern?</translation>
        </message>
        <message>
            <location filename="../../ui/main_window.py" />
            <source> Changes of the task that wait for the end of the run are given up.</source>
            <translation> Änderungen der Aufgabe, die auf das Ende des Laufs warten, werden aufgegeben.</translation>
        </message>
        <message>
            <location filename="../../ui/main_window.py" />
            <source>{file} takes the place of {design}, which is being designed.</source>
            <translation>{file} tritt an die Stelle von {design}, das gerade entworfen wird.</translation>
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
            <source>Saved with the task that the run works on.</source>
            <translation>Gespeichert mit der Aufgabe, an der der Lauf arbeitet.</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cut_fields.py" />
            <source>Tool radius</source>
            <translation>Werkzeugradius</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cut_fields.py" />
            <source>a radius that fits</source>
            <translation>ein passender Radius</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cut_fields.py" />
            <source>Radius of the ball. Left empty: that of the design task, or one that fits everywhere.</source>
            <translation>Radius der Kugel. Leer: der der Aufgabe oder einer, der überall passt.</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cut_fields.py" />
            <source>Ridges</source>
            <translation>Rillen</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cut_fields.py" />
            <source>How high ridges between neighbouring cuts may be. Left empty: 1e-4 of the larger half-width, or higher where that takes more moves than a program can have.</source>
            <translation>Wie hoch Grate zwischen benachbarten Bahnen sein dürfen. Leer: 1e-4 der größeren Halbbreite, oder mehr, wo das mehr Bewegungen bräuchte, als ein Programm haben kann.</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cut_fields.py" />
            <source>Clamping rim</source>
            <translation>Spannrand</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cut_fields.py" />
            <source>Width of stock around the lens, to hold it by.</source>
            <translation>Breite des Rohteils um die Linse herum, um es zu spannen.</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cut_fields.py" />
            <source>Travel height</source>
            <translation>Verfahrhöhe</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cut_fields.py" />
            <source>the ball's diameter</source>
            <translation>der Kugeldurchmesser</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cut_fields.py" />
            <source>How far over its highest cut the cutter travels.</source>
            <translation>Wie weit über seinem höchsten Schnitt der Fräser verfährt.</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cut_fields.py" />
            <source>fine</source>
            <translation>fein</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cut_fields.py" />
            <source>Feed</source>
            <translation>Vorschub</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cut_fields.py" />
            <source>How fast the cutter moves while it cuts.</source>
            <translation>Wie schnell sich der Fräser beim Schneiden bewegt.</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cut_fields.py" />
            <source>Plunge feed</source>
            <translation>Eintauchvorschub</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cut_fields.py" />
            <source>How fast the cutter goes down into the stock.</source>
            <translation>Wie schnell der Fräser in das Rohteil eintaucht.</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cut_fields.py" />
            <source>Spindle speed</source>
            <translation>Spindeldrehzahl</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cut_fields.py" />
            <source>Revolutions a minute, clockwise.</source>
            <translation>Umdrehungen je Minute, im Uhrzeigersinn.</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cut_fields.py" />
            <source>Dwell</source>
            <translation>Verweilzeit</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cut_fields.py" />
            <source>How long the cutter waits above the stock until the spindle is at its speed.</source>
            <translation>Wie lange der Fräser über dem Rohteil wartet, bis die Spindel ihre Drehzahl hat.</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cut_fields.py" />
            <source>From {least} to {most} {unit}.</source>
            <translation>Von {least} bis {most} {unit}.</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cut_fields.py" />
            <source>Cut a mould of the face</source>
            <translation>Eine Form der Fläche fräsen</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cut_fields.py" />
            <source>The negative: hollows become humps, turned over about the y axis.</source>
            <translation>Das Negativ: Mulden werden Erhebungen, um die y-Achse gewendet.</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cutter.py" />
            <source>A finishing pass of a ball cutter as G-code in millimetres (GRBL, LinuxCNC). The cut is simulated before it is written: a cutter that leaves too much material standing, or cuts too deep, is refused.</source>
            <translation>Schlichtbahnen eines Kugelfräsers als G-Code in Millimetern (GRBL, LinuxCNC). Der Schnitt wird vor dem Schreiben simuliert: ein Fräser, der zu viel Material stehen lässt oder zu tief schneidet, wird abgelehnt.</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cutter.py" />
            <source>Ball cutter</source>
            <translation>Kugelfräser</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cutter.py" />
            <source>What the cut leaves</source>
            <translation>Was der Schnitt übrig lässt</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cutter.py" />
            <source>Stop</source>
            <translation>Stopp</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cutter.py" />
            <source>Stop the simulation; a change of a field begins it anew</source>
            <translation>Die Simulation anhalten; eine Änderung eines Feldes beginnt sie neu</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cutter.py" />
            <source>&amp;Write G-code…</source>
            <translation>G-Code &amp;schreiben …</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cutter.py" />
            <source>&amp;Trace light</source>
            <translation>Licht &amp;durchrechnen</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cutter.py" />
            <source>Trace light through what the cut leaves, beside the lens as designed</source>
            <translation>Licht durch das rechnen, was der Schnitt übrig lässt, neben der Linse wie entworfen</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cutter.py" />
            <source>simulation of the cut</source>
            <translation>Simulation des Schnitts</translation>
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
            <source>Stopped: the cut is not simulated.</source>
            <translation>Angehalten: der Schnitt ist nicht simuliert.</translation>
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
            <source>Radius {radius}, {size:,} moves. {deep}; up to {left} of material is left standing, as ridges or where the ball does not fit.</source>
            <translation>Radius {radius}, {size:,} Bewegungen. {deep}; bis zu {left} Material bleibt stehen, als Rillen oder wo die Kugel nicht hineinpasst.</translation>
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
            <location filename="../../ui/manufacture/cutter.py" />
            <source>Polishing takes ridges away.</source>
            <translation>Polieren entfernt Rillen.</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/face_map.py" />
            <source>Thickness along z</source>
            <translation>Dicke entlang z</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/face_map.py" />
            <source>Angle between the face and a plane across the axis</source>
            <translation>Winkel zwischen der Fläche und einer Ebene quer zur Achse</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/face_map.py" />
            <source>One over the radius of concave places; zero elsewhere</source>
            <translation>Kehrwert des Radius konkaver Stellen; sonst null</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/face_map.py" />
            <source>One over the radius of convex places; zero elsewhere</source>
            <translation>Kehrwert des Radius konvexer Stellen; sonst null</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/face_map.py" />
            <source>Computed when no run changes it…</source>
            <translation>Wird berechnet, wenn kein Lauf sie ändert …</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/face_map.py" />
            <source>What the map shows</source>
            <translation>Was die Karte zeigt</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/face_map.py" />
            <source>; what is beyond a limit is hatched</source>
            <translation>; was über einer Grenze liegt, ist schraffiert</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>✓ met</source>
            <translation>✓ erfüllt</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>No place is beyond the limit.</source>
            <translation>Keine Stelle liegt über der Grenze.</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>? open</source>
            <translation>? offen</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>No place that was looked at is beyond the limit, but that no other place is, is not proved: {bound} is all that the face surely keeps to.</source>
            <translation>Keine betrachtete Stelle liegt über der Grenze; dass es keine andere tut, ist nicht bewiesen: {bound} ist alles, was die Fläche sicher einhält.</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>✗ broken</source>
            <translation>✗ verletzt</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>Some places are beyond the limit; the map shows where.</source>
            <translation>Einige Stellen liegen über der Grenze; die Karte zeigt, wo.</translation>
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
            <source>Smallest radius of curvature of concave places</source>
            <translation>Kleinster Krümmungsradius konkaver Stellen</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>Convex radius</source>
            <translation>Konvexer Radius</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>Smallest radius of curvature of convex places</source>
            <translation>Kleinster Krümmungsradius konvexer Stellen</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>Largest ball that fits</source>
            <translation>Größte passende Kugel</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>Largest radius of a ball cutter that reaches every place of the face. A larger one leaves material standing in hollows</source>
            <translation>Größter Radius eines Kugelfräsers, der jede Stelle der Fläche erreicht. Ein größerer lässt in Mulden Material stehen</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>Sag range</source>
            <translation>Pfeilhöhe</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>Height of the highest point of the face over the lowest</source>
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
            <source>Ball cutter…</source>
            <translation>Kugelfräser …</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>Say how the face is cut, see what the cut leaves, and write G-code</source>
            <translation>Festlegen, wie die Fläche gefräst wird, sehen, was der Schnitt übrig lässt, und G-Code schreiben</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>Verdict: {figure}</source>
            <translation>Urteil: {figure}</translation>
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
            <source>none</source>
            <translation>ohne</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>The face has none.</source>
            <translation>Die Fläche hat keine.</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>At x = {x}, y = {y}. Nowhere beyond {bound}.</source>
            <translation>Bei x = {x}, y = {y}. Nirgends jenseits von {bound}.</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/limits.py" />
            <source>Thinnest</source>
            <translation>Dünnste Stelle</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/limits.py" />
            <source>The part has to be as thick as this everywhere</source>
            <translation>So dick muss das Teil überall sein</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/limits.py" />
            <source>Thickest</source>
            <translation>Dickste Stelle</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/limits.py" />
            <source>The part must not be thicker than this anywhere</source>
            <translation>Dicker darf das Teil nirgends sein</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/limits.py" />
            <source>Largest angle between a freeform face and a plane across the axis, in degrees</source>
            <translation>Größter Winkel zwischen einer Freiformfläche und einer Ebene quer zur Achse, in Grad</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/limits.py" />
            <source>Smallest radius that a tool can cut, of concave and convex places</source>
            <translation>Kleinster Radius, den ein Werkzeug fräsen kann, an konkaven und konvexen Stellen</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/limits.py" />
            <source>Radius of the ball cutter that has to reach every place of the face. One that is too large for a hollow leaves material standing there</source>
            <translation>Radius des Kugelfräsers, der jede Stelle der Fläche erreichen muss. Einer, der für eine Mulde zu groß ist, lässt dort Material stehen</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/limits.py" />
            <source>Empty: what the design task keeps to, if anything. Kept for the next start.</source>
            <translation>Leer: was die Aufgabe einhält, falls etwas. Für den nächsten Start aufbewahrt.</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/limits.py" />
            <source>Limit: {label}</source>
            <translation>Grenze: {label}</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/limits.py" />
            <source>{value:g}; a number above 0, or nothing</source>
            <translation>{value:g}; eine Zahl über 0 oder nichts</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/pane.py" />
            <source>look at the face</source>
            <translation>Untersuchung der Fläche</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/pane.py" />
            <source>Out of date: of the lens before; computed anew when it rests.</source>
            <translation>Veraltet: von der vorigen Linse; wird neu berechnet, sobald sie ruht.</translation>
        </message>
        <message>
            <location filename="../../ui/notices/carried_lens.py" />
            <source>The lens does not fit the new outline: Start designs another one, Undo brings it back.</source>
            <translation>Die Linse passt nicht zum neuen Umriss: Start entwirft eine andere, Rückgängig bringt sie zurück.</translation>
        </message>
        <message>
            <location filename="../../ui/notices/carried_lens.py" />
            <source>The mirror does not fit the new outline: Start designs another one, Undo brings it back.</source>
            <translation>Der Spiegel passt nicht zum neuen Umriss: Start entwirft einen anderen, Rückgängig bringt ihn zurück.</translation>
        </message>
        <message>
            <location filename="../../ui/notices/carried_lens.py" />
            <source>The entrance face is freeform now, and flat so far. Continue shapes both faces, and Undo takes the change back.</source>
            <translation>Die Eintrittsfläche ist jetzt eine Freiformfläche und vorerst eben. Fortsetzen formt beide Flächen, Rückgängig nimmt die Änderung zurück.</translation>
        </message>
        <message>
            <location filename="../../ui/notices/carried_lens.py" />
            <source>The entrance face is flat now; the exit face stays as it was, but it was made for the light of both. Continue shapes it alone, and Undo takes the change back.</source>
            <translation>Die Eintrittsfläche ist jetzt eben; die Austrittsfläche blieb, wie sie war, wurde aber für das Licht beider gemacht. Fortsetzen formt sie allein, Rückgängig nimmt die Änderung zurück.</translation>
        </message>
        <message>
            <location filename="../../ui/notices/carried_lens.py" />
            <source>The lens is changed by up to {moved} to be within its new limits. Continue goes on from there, and Undo takes the change back.</source>
            <translation>Die Linse wird um bis zu {moved} geändert, um in ihren neuen Grenzen zu bleiben. Fortsetzen macht von dort weiter, Rückgängig nimmt die Änderung zurück.</translation>
        </message>
        <message>
            <location filename="../../ui/notices/carried_lens.py" />
            <source>The mirror is changed by up to {moved} to be within its new limits. Continue goes on from there, and Undo takes the change back.</source>
            <translation>Der Spiegel wird um bis zu {moved} geändert, um in seinen neuen Grenzen zu bleiben. Fortsetzen macht von dort weiter, Rückgängig nimmt die Änderung zurück.</translation>
        </message>
        <message>
            <location filename="../../ui/notices/carried_lens.py" />
            <source>The program takes {size} control points now. Continue goes on from the lens that was there, carried over, and Undo takes the change back.</source>
            <translation>Das Programm nimmt jetzt {size} Kontrollpunkte. Fortsetzen macht von der bisherigen Linse weiter, die übertragen ist, Rückgängig nimmt die Änderung zurück.</translation>
        </message>
        <message>
            <location filename="../../ui/notices/carried_lens.py" />
            <source>The program takes {size} control points now. Continue goes on from the mirror that was there, carried over, and Undo takes the change back.</source>
            <translation>Das Programm nimmt jetzt {size} Kontrollpunkte. Fortsetzen macht von dem bisherigen Spiegel weiter, der übertragen ist, Rückgängig nimmt die Änderung zurück.</translation>
        </message>
        <message>
            <location filename="../../ui/notices/carried_lens.py" />
            <source>The lens was designed for another task and is a start for this one: Continue goes on from it, Start over does not</source>
            <translation>Die Linse wurde für eine andere Aufgabe entworfen und ist ein Anfang für diese: Fortsetzen macht von ihr weiter, Neu starten nicht</translation>
        </message>
        <message>
            <location filename="../../ui/notices/carried_lens.py" />
            <source>The mirror was designed for another task and is a start for this one: Continue goes on from it, Start over does not</source>
            <translation>Der Spiegel wurde für eine andere Aufgabe entworfen und ist ein Anfang für diese: Fortsetzen macht von ihm weiter, Neu starten nicht</translation>
        </message>
        <message>
            <location filename="../../ui/notices/carried_lens.py" />
            <source>On {size} control points {name} is the same.</source>
            <translation>Auf {size} Kontrollpunkten unverändert: {name}.</translation>
        </message>
        <message>
            <location filename="../../ui/notices/carried_lens.py" />
            <source>Take {size}, exact</source>
            <translation>{size} nehmen, exakt</translation>
        </message>
        <message>
            <location filename="../../ui/notices/carried_lens.py" />
            <source>On {size} control points {name} is off by up to {off}. Continue goes on from there, Start over from nothing, and Undo takes the change back.</source>
            <translation>Auf {size} Kontrollpunkten weicht {name} um bis zu {off} ab. Fortsetzen macht von dort weiter, Neu starten beginnt von Grund auf, Rückgängig nimmt die Änderung zurück.</translation>
        </message>
        <message>
            <location filename="../../ui/notices/carried_lens.py" />
            <source>change of {name}</source>
            <translation>{name} ändern</translation>
        </message>
        <message>
            <location filename="../../ui/notices/carried_lens.py" />
            <source>control points</source>
            <translation>Kontrollpunkte</translation>
        </message>
        <message>
            <location filename="../../ui/notices/carried_lens.py" />
            <source>the lens</source>
            <translation>die Linse</translation>
        </message>
        <message>
            <location filename="../../ui/notices/carried_lens.py" />
            <source>the mirror</source>
            <translation>der Spiegel</translation>
        </message>
        <message>
            <location filename="../../ui/notices/carried_lens.py" />
            <source>the entrance face</source>
            <translation>die Eintrittsfläche</translation>
        </message>
        <message>
            <location filename="../../ui/notices/coarse_net.py" />
            <source>Refine and start over</source>
            <translation>Verfeinern und neu starten</translation>
        </message>
        <message>
            <location filename="../../ui/notices/coarse_net.py" />
            <source>automatic control points</source>
            <translation>automatische Kontrollpunkte</translation>
        </message>
        <message>
            <location filename="../../ui/notices/postponed_edits.py" />
            <source>Stop and apply</source>
            <translation>Stoppen und anwenden</translation>
        </message>
        <message>
            <location filename="../../ui/notices/postponed_edits.py" />
            <source>Take back</source>
            <translation>Zurücknehmen</translation>
        </message>
        <message>
            <location filename="../../ui/notices/refused_fields.py" />
            <source> ({count} more refused)</source>
            <translation> ({count} weitere abgelehnt)</translation>
        </message>
        <message>
            <location filename="../../ui/notices/refused_fields.py" />
            <source>{first}{others}. Correct it, or press Esc, first.</source>
            <translation>{first}{others}. Zuerst berichtigen oder Esc drücken.</translation>
        </message>
        <message>
            <location filename="../../ui/notices/shortfall.py" />
            <source>The run goes on within these limits.</source>
            <translation>Der Lauf geht innerhalb dieser Grenzen weiter.</translation>
        </message>
        <message>
            <location filename="../../ui/notices/shortfall.py" />
            <source>Stop and widen</source>
            <translation>Stoppen und erweitern</translation>
        </message>
        <message>
            <location filename="../../ui/notices/shortfall.py" />
            <source>Widen</source>
            <translation>Erweitern</translation>
        </message>
        <message>
            <location filename="../../ui/notices/shortfall.py" />
            <source>Continue</source>
            <translation>Fortsetzen</translation>
        </message>
        <message>
            <location filename="../../ui/notices/shortfall.py" />
            <source>automatic height range</source>
            <translation>automatischer Höhenbereich</translation>
        </message>
        <message>
            <location filename="../../ui/notices/shortfall.py" />
            <source>wider height range</source>
            <translation>breiterer Höhenbereich</translation>
        </message>
        <message>
            <location filename="../../ui/notices/shortfall.py" />
            <source>wider entrance range</source>
            <translation>weiterer Eintrittsbereich</translation>
        </message>
        <message>
            <location filename="../../ui/notices/shortfall.py" />
            <source>The height range follows from the task now</source>
            <translation>Der Höhenbereich folgt jetzt aus der Aufgabe</translation>
        </message>
        <message>
            <location filename="../../ui/notices/shortfall.py" />
            <source>The height range is {low:.3g} to {high:.3g} {unit} now</source>
            <translation>Der Höhenbereich ist jetzt {low:.3g} bis {high:.3g} {unit}</translation>
        </message>
        <message>
            <location filename="../../ui/notices/shortfall.py" />
            <source>The entrance range is {low:.3g} to {high:.3g} {unit} now</source>
            <translation>Der Eintrittsbereich ist jetzt {low:.3g} bis {high:.3g} {unit}</translation>
        </message>
        <message>
            <location filename="../../ui/notices/shortfall.py" />
            <source>{said}, and the lens is as it was. Start over mostly finds a better one than Continue does.</source>
            <translation>{said}; die Linse ist, wie sie war. Neu starten findet meist eine bessere als Fortsetzen.</translation>
        </message>
        <message>
            <location filename="../../ui/notices/shortfall.py" />
            <source>{said}, and the mirror is as it was. Start over mostly finds a better one than Continue does.</source>
            <translation>{said}; der Spiegel ist, wie er war. Neu starten findet meist einen besseren als Fortsetzen.</translation>
        </message>
        <message>
            <location filename="../../ui/notices/shortfall.py" />
            <source>Start over</source>
            <translation>Neu starten</translation>
        </message>
        <message>
            <location filename="../../ui/notices/target_image.py" />
            <source>{image} has changed. The design keeps the picture that it has.</source>
            <translation>{image} hat sich geändert. Der Entwurf behält das Bild, das er hat.</translation>
        </message>
        <message>
            <location filename="../../ui/notices/target_image.py" />
            <source>Read it again</source>
            <translation>Neu lesen</translation>
        </message>
        <message>
            <location filename="../../ui/notices/total_reflection.py" />
            <source>{where}, as marked in the 3D scene: {cure}.</source>
            <translation>{where}, wie in der 3D-Szene markiert: {cure}.</translation>
        </message>
        <message>
            <location filename="../../ui/notices/total_reflection.py" />
            <source>search for total reflection</source>
            <translation>Suche nach Totalreflexion</translation>
        </message>
        <message>
            <location filename="../../ui/notices/unit_change.py" />
            <source>All lengths are converted: 1 {old} is {ratio:.6g} {new} now.</source>
            <translation>Alle Längen wurden umgerechnet: 1 {old} ist jetzt {ratio:.6g} {new}.</translation>
        </message>
        <message>
            <location filename="../../ui/notices/unit_change.py" />
            <source>Keep the numbers</source>
            <translation>Zahlen beibehalten</translation>
        </message>
        <message>
            <location filename="../../ui/notices/unit_change.py" />
            <source>change of unit alone</source>
            <translation>nur die Einheit ändern</translation>
        </message>
        <message>
            <location filename="../../ui/panels/auto_row.py" />
            <source>Auto</source>
            <translation>Auto</translation>
        </message>
        <message>
            <location filename="../../ui/panels/auto_row.py" />
            <source>{label}, automatic</source>
            <translation>{label}, automatisch</translation>
        </message>
        <message>
            <location filename="../../ui/panels/auto_row.py" />
            <source>auto</source>
            <translation>auto</translation>
        </message>
        <message>
            <location filename="../../ui/panels/edits.py" />
            <source>this task has no such field any more</source>
            <translation>diese Aufgabe hat kein solches Feld mehr</translation>
        </message>
        <message>
            <location filename="../../ui/panels/element_list.py" />
            <source>element</source>
            <translation>Element</translation>
        </message>
        <message>
            <location filename="../../ui/panels/element_list.py" />
            <source>Elements</source>
            <translation>Elemente</translation>
        </message>
        <message>
            <location filename="../../ui/panels/element_list.py" />
            <source>Add a plano-convex lens of fixed shape behind the last element</source>
            <translation>Eine plankonvexe Linse fester Form hinter dem letzten Element hinzufügen</translation>
        </message>
        <message>
            <location filename="../../ui/panels/element_list.py" />
            <source>Add a plane mirror behind the last element</source>
            <translation>Einen ebenen Spiegel hinter dem letzten Element hinzufügen</translation>
        </message>
        <message>
            <location filename="../../ui/panels/element_list.py" />
            <source>Add a copy of the chosen element behind the last element</source>
            <translation>Eine Kopie des gewählten Elements hinter dem letzten Element hinzufügen</translation>
        </message>
        <message>
            <location filename="../../ui/panels/element_list.py" />
            <source>Remove the chosen element</source>
            <translation>Das gewählte Element entfernen</translation>
        </message>
        <message>
            <location filename="../../ui/panels/element_list.py" />
            <source>Exchange the chosen element with the one before it, along z too</source>
            <translation>Das gewählte Element mit dem davor tauschen, auch entlang z</translation>
        </message>
        <message>
            <location filename="../../ui/panels/element_list.py" />
            <source>Exchange the chosen element with the one behind it, along z too</source>
            <translation>Das gewählte Element mit dem dahinter tauschen, auch entlang z</translation>
        </message>
        <message>
            <location filename="../../ui/panels/element_list.py" />
            <source>Add lens</source>
            <translation>Linse hinzufügen</translation>
        </message>
        <message>
            <location filename="../../ui/panels/element_list.py" />
            <source>Add mirror</source>
            <translation>Spiegel hinzufügen</translation>
        </message>
        <message>
            <location filename="../../ui/panels/element_list.py" />
            <source>designed</source>
            <translation>entworfen</translation>
        </message>
        <message>
            <location filename="../../ui/panels/elements.py" />
            <source>Optical train</source>
            <translation>Optisches System</translation>
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
            <source>From the base</source>
            <translation>Ab Grundform</translation>
        </message>
        <message>
            <location filename="../../ui/panels/elements.py" />
            <source>How far a control point may move from the base, down and up. A wider range bends light further.</source>
            <translation>Wie weit ein Kontrollpunkt nach unten und oben von der Grundform abweichen darf. Ein weiterer Bereich lenkt Licht weiter ab.</translation>
        </message>
        <message>
            <location filename="../../ui/panels/fields.py" />
            <source>{label}, {number} of {count}</source>
            <translation>{label}, {number} von {count}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/forms.py" />
            <source>refused {edit}</source>
            <translation>abgelehnt: {edit}</translation>
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
            <source>The target is no picture: only a picture has an aspect.</source>
            <translation>Das Ziel ist kein Bild: nur ein Bild hat ein Seitenverhältnis.</translation>
        </message>
        <message>
            <location filename="../../ui/panels/forms.py" />
            <source>The picture has no aspect: {refused}</source>
            <translation>Das Bild hat kein Seitenverhältnis: {refused}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/forms.py" />
            <source>screen of the picture's aspect</source>
            <translation>Schirm im Seitenverhältnis des Bildes</translation>
        </message>
        <message>
            <location filename="../../ui/panels/forms.py" />
            <source>far field of the picture's aspect</source>
            <translation>Fernfeld im Seitenverhältnis des Bildes</translation>
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
            <source>Refused: {refused}</source>
            <translation>Abgelehnt: {refused}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/forms.py" />
            <source>The {edit} is refused: {refused}</source>
            <translation>Abgelehnt ({edit}): {refused}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/forms.py" />
            <source>Stop the run first; then read the image again.</source>
            <translation>Zuerst den Lauf stoppen, dann das Bild neu lesen.</translation>
        </message>
        <message>
            <location filename="../../ui/panels/forms.py" />
            <source>Waits for the end of the run: {edits}.</source>
            <translation>Wartet auf das Ende des Laufs: {edits}.</translation>
        </message>
        <message>
            <location filename="../../ui/panels/image_list.py" />
            <source>image</source>
            <translation>Bild</translation>
        </message>
        <message>
            <location filename="../../ui/panels/image_list.py" />
            <source>Images</source>
            <translation>Bilder</translation>
        </message>
        <message>
            <location filename="../../ui/panels/image_list.py" />
            <source>Add an image farther away, with the target of the last one</source>
            <translation>Ein weiter entferntes Bild mit dem Ziel des letzten hinzufügen</translation>
        </message>
        <message>
            <location filename="../../ui/panels/image_list.py" />
            <source>Add a copy of the chosen image behind it</source>
            <translation>Eine Kopie des gewählten Bildes dahinter hinzufügen</translation>
        </message>
        <message>
            <location filename="../../ui/panels/image_list.py" />
            <source>Remove the chosen image</source>
            <translation>Das gewählte Bild entfernen</translation>
        </message>
        <message>
            <location filename="../../ui/panels/image_list.py" />
            <source>Move the chosen image up</source>
            <translation>Das gewählte Bild nach oben</translation>
        </message>
        <message>
            <location filename="../../ui/panels/image_list.py" />
            <source>Move the chosen image down</source>
            <translation>Das gewählte Bild nach unten</translation>
        </message>
        <message>
            <location filename="../../ui/panels/image_list.py" />
            <source>The panels Target and Receiver have the settings of image 1.</source>
            <translation>Die Bereiche Ziel und Empfänger haben die Einstellungen von Bild 1.</translation>
        </message>
        <message>
            <location filename="../../ui/panels/image_list.py" />
            <source>{place}, {target}, weight {weight:g}</source>
            <translation>{place}, {target}, Gewicht {weight:g}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/images.py" />
            <source>Image {number}</source>
            <translation>Bild {number}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/images.py" />
            <source>change of target image</source>
            <translation>Zielbild ändern</translation>
        </message>
        <message>
            <location filename="../../ui/panels/panel.py" />
            <source>{panel} {field}</source>
            <translation>{panel}, {field}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/part_list.py" />
            <source>Add</source>
            <translation>Hinzufügen</translation>
        </message>
        <message>
            <location filename="../../ui/panels/part_list.py" />
            <source>Duplicate</source>
            <translation>Duplizieren</translation>
        </message>
        <message>
            <location filename="../../ui/panels/part_list.py" />
            <source>Remove</source>
            <translation>Entfernen</translation>
        </message>
        <message>
            <location filename="../../ui/panels/part_list.py" />
            <source>Up</source>
            <translation>Auf</translation>
        </message>
        <message>
            <location filename="../../ui/panels/part_list.py" />
            <source>Down</source>
            <translation>Ab</translation>
        </message>
        <message>
            <location filename="../../ui/panels/part_list.py" />
            <source>new {part}</source>
            <translation>Neu: {part}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/part_list.py" />
            <source>copy of {part} {number}</source>
            <translation>Kopie von {part} {number}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/part_list.py" />
            <source>removal of {part} {number}</source>
            <translation>{part} {number} entfernen</translation>
        </message>
        <message>
            <location filename="../../ui/panels/part_list.py" />
            <source>move of {part} {number}</source>
            <translation>{part} {number} verschieben</translation>
        </message>
        <message>
            <location filename="../../ui/panels/region_list.py" />
            <source>region</source>
            <translation>Ausschnitt</translation>
        </message>
        <message>
            <location filename="../../ui/panels/region_list.py" />
            <source>Regions</source>
            <translation>Ausschnitte</translation>
        </message>
        <message>
            <location filename="../../ui/panels/region_list.py" />
            <source>Add a region in the middle</source>
            <translation>Einen Ausschnitt in der Mitte hinzufügen</translation>
        </message>
        <message>
            <location filename="../../ui/panels/region_list.py" />
            <source>Add a copy of the chosen region behind it</source>
            <translation>Eine Kopie des gewählten Ausschnitts dahinter hinzufügen</translation>
        </message>
        <message>
            <location filename="../../ui/panels/region_list.py" />
            <source>Remove the chosen region</source>
            <translation>Den gewählten Ausschnitt entfernen</translation>
        </message>
        <message>
            <location filename="../../ui/panels/region_list.py" />
            <source>Move the chosen region up</source>
            <translation>Den gewählten Ausschnitt nach oben</translation>
        </message>
        <message>
            <location filename="../../ui/panels/region_list.py" />
            <source>Move the chosen region down</source>
            <translation>Den gewählten Ausschnitt nach unten</translation>
        </message>
        <message>
            <location filename="../../ui/panels/region_list.py" />
            <source>None.</source>
            <translation>Keine.</translation>
        </message>
        <message>
            <location filename="../../ui/panels/region_list.py" />
            <source>Region {count}</source>
            <translation>Ausschnitt {count}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/regions.py" />
            <source>Watched</source>
            <translation>Beobachtet</translation>
        </message>
        <message>
            <location filename="../../ui/panels/regions.py" />
            <source>Region {number}</source>
            <translation>Ausschnitt {number}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/regions.py" />
            <source>Shape</source>
            <translation>Form</translation>
        </message>
        <message>
            <location filename="../../ui/panels/regions.py" />
            <source>As x, y; x, y; …</source>
            <translation>In der Form x, y; x, y; …</translation>
        </message>
        <message>
            <location filename="../../ui/panels/run.py" />
            <source>Parameters</source>
            <translation>Parameter</translation>
        </message>
        <message>
            <location filename="../../ui/panels/run.py" />
            <source>How many numbers are optimised, and the memory that they take with their gradient and the optimiser's two moments. A network that does not fit is refused at the start.</source>
            <translation>Wie viele Zahlen optimiert werden, und der Speicher, den sie mit ihrem Gradienten und den beiden Momenten des Optimierers brauchen. Ein Netzwerk, das nicht passt, wird beim Start abgelehnt.</translation>
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
            <location filename="../../ui/panels/source.py" />
            <source>Files of light ({endings});;All files (*)</source>
            <translation>Lichtdateien ({endings});;Alle Dateien (*)</translation>
        </message>
        <message>
            <location filename="../../ui/panels/source.py" />
            <source>change of file of light</source>
            <translation>Lichtdatei ändern</translation>
        </message>
        <message>
            <location filename="../../ui/panels/source.py" />
            <source>The design keeps files of up to {largest} MB.</source>
            <translation>Der Entwurf bewahrt Dateien bis {largest} MB auf.</translation>
        </message>
        <message>
            <location filename="../../ui/panels/source.py" />
            <source>Choose a file of light</source>
            <translation>Eine Lichtdatei wählen</translation>
        </message>
        <message>
            <location filename="../../ui/panels/stage_list.py" />
            <source>In turn</source>
            <translation>Nacheinander</translation>
        </message>
        <message>
            <location filename="../../ui/panels/stage_list.py" />
            <source>A run goes through these stages before the scene itself, each going on from the lens of the one before: from a point source to an extended one, say, or from a coarse net to a fine one.</source>
            <translation>Ein Lauf durchläuft diese Stufen vor der Szene selbst, jede ausgehend von der Linse der vorigen: etwa von einer Punktquelle zu einer ausgedehnten oder von einem groben Netz zu einem feinen.</translation>
        </message>
        <message>
            <location filename="../../ui/panels/stage_list.py" />
            <source>stage</source>
            <translation>Stufe</translation>
        </message>
        <message>
            <location filename="../../ui/panels/stage_list.py" />
            <source>Stages of the run</source>
            <translation>Stufen des Laufs</translation>
        </message>
        <message>
            <location filename="../../ui/panels/stage_list.py" />
            <source>Add a stage behind the others</source>
            <translation>Eine Stufe hinter den anderen hinzufügen</translation>
        </message>
        <message>
            <location filename="../../ui/panels/stage_list.py" />
            <source>Add a copy of the chosen stage behind it</source>
            <translation>Eine Kopie der gewählten Stufe dahinter hinzufügen</translation>
        </message>
        <message>
            <location filename="../../ui/panels/stage_list.py" />
            <source>Remove the chosen stage</source>
            <translation>Die gewählte Stufe entfernen</translation>
        </message>
        <message>
            <location filename="../../ui/panels/stage_list.py" />
            <source>Run the chosen stage sooner</source>
            <translation>Die gewählte Stufe früher ausführen</translation>
        </message>
        <message>
            <location filename="../../ui/panels/stage_list.py" />
            <source>Run the chosen stage later</source>
            <translation>Die gewählte Stufe später ausführen</translation>
        </message>
        <message>
            <location filename="../../ui/panels/stage_list.py" />
            <source>Then the scene as it stands, {iterations}.</source>
            <translation>Danach die Szene, wie sie ist, {iterations}.</translation>
        </message>
        <message>
            <location filename="../../ui/panels/stage_list.py" />
            <source>None: the scene is run as it stands.</source>
            <translation>Keine: die Szene läuft, wie sie ist.</translation>
        </message>
        <message>
            <location filename="../../ui/panels/stage_list.py" />
            <source>net of {n_u} × {n_v}</source>
            <translation>Netz aus {n_u} × {n_v}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/stage_list.py" />
            <source>{kind} filter</source>
            <translation>Filter: {kind}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/stage_list.py" />
            <source>1 iteration</source>
            <translation>1 Iteration</translation>
        </message>
        <message>
            <location filename="../../ui/panels/stage_list.py" />
            <source>{count} iterations</source>
            <translation>{count} Iterationen</translation>
        </message>
        <message>
            <location filename="../../ui/panels/stages.py" />
            <source>As the scene</source>
            <translation>Wie die Szene</translation>
        </message>
        <message>
            <location filename="../../ui/panels/stages.py" />
            <source>Stages</source>
            <translation>Stufen</translation>
        </message>
        <message>
            <location filename="../../ui/panels/stages.py" />
            <source>Stage {number}</source>
            <translation>Stufe {number}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/target.py" />
            <source>Images ({endings});;All files (*)</source>
            <translation>Bilder ({endings});;Alle Dateien (*)</translation>
        </message>
        <message>
            <location filename="../../ui/panels/target.py" />
            <source>An image file can also be dropped onto the window.</source>
            <translation>Eine Bilddatei lässt sich auch auf das Fenster ziehen.</translation>
        </message>
        <message>
            <location filename="../../ui/panels/target.py" />
            <source>The design keeps images of up to {largest} MB.</source>
            <translation>Der Entwurf bewahrt Bilder bis {largest} MB auf.</translation>
        </message>
        <message>
            <location filename="../../ui/panels/target.py" />
            <source>Choose an image file</source>
            <translation>Eine Bilddatei wählen</translation>
        </message>
        <message>
            <location filename="../../ui/panels/target.py" />
            <source>The light that is wanted on the screen, as its viewer sees it</source>
            <translation>Das gewünschte Licht auf dem Schirm, wie es sein Betrachter sieht</translation>
        </message>
        <message>
            <location filename="../../ui/run/bound.py" />
            <source>bound</source>
            <translation>Schranke</translation>
        </message>
        <message>
            <location filename="../../ui/run/bound.py" />
            <source>at best {error}</source>
            <translation>bestenfalls {error}</translation>
        </message>
        <message>
            <location filename="../../ui/run/bound.py" />
            <source>There can be {bound}; {error} with a source half as wide. This is the least relative L2 error, certified; freeform bound tells more.</source>
            <translation>Möglich: {bound}; {error} mit einer halb so breiten Quelle. Das ist der kleinste relative L2-Fehler, nachgewiesen; „freeform bound“ sagt mehr.</translation>
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
            <source>Point at an image to read its light</source>
            <translation>Auf ein Bild zeigen, um sein Licht abzulesen</translation>
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
            <source>Which of the scenes' images is shown, in pictures and figures</source>
            <translation>Welches der Bilder der Szenen gezeigt wird, in Bildern und Zahlen</translation>
        </message>
        <message>
            <location filename="../../ui/run/comparison.py" />
            <source>Light under the pointer</source>
            <translation>Licht unter dem Zeiger</translation>
        </message>
        <message>
            <location filename="../../ui/run/comparison.py" />
            <source>Figures of both runs</source>
            <translation>Zahlen beider Läufe</translation>
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
            <location filename="../../ui/run/follow.py" />
            <source>Following: the first design is under way</source>
            <translation>Folgen: der erste Entwurf entsteht</translation>
        </message>
        <message>
            <location filename="../../ui/run/follow.py" />
            <source>Following: the first design takes long here; edits wait for a pause</source>
            <translation>Folgen: der erste Entwurf dauert hier lange; Änderungen warten auf eine Pause</translation>
        </message>
        <message>
            <location filename="../../ui/run/follow.py" />
            <source>design of the lens that was missing</source>
            <translation>Entwurf der fehlenden Linse</translation>
        </message>
        <message>
            <location filename="../../ui/run/follow.py" />
            <source>design of the mirror that was missing</source>
            <translation>Entwurf des fehlenden Spiegels</translation>
        </message>
        <message>
            <location filename="../../ui/run/follow.py" />
            <source>Following: error {error:.1f} %, still getting better</source>
            <translation>Folgen: Fehler {error:.1f} %, wird noch besser</translation>
        </message>
        <message>
            <location filename="../../ui/run/follow.py" />
            <source>design of the lens</source>
            <translation>Entwurf der Linse</translation>
        </message>
        <message>
            <location filename="../../ui/run/follow.py" />
            <source>design of the mirror</source>
            <translation>Entwurf des Spiegels</translation>
        </message>
        <message>
            <location filename="../../ui/run/kept.py" />
            <source>Run {number}: {description}</source>
            <translation>Lauf {number}: {description}</translation>
        </message>
        <message>
            <location filename="../../ui/run/kept.py" />
            <source>Followed {number}: {description}</source>
            <translation>Gefolgt {number}: {description}</translation>
        </message>
        <message>
            <location filename="../../ui/run/lens_on_show.py" />
            <source>There is no result yet, or its light is still being traced; try again in a moment.</source>
            <translation>Es gibt noch kein Ergebnis, oder sein Licht wird noch durchgerechnet; gleich noch einmal versuchen.</translation>
        </message>
        <message>
            <location filename="../../ui/run/lens_on_show.py" />
            <source>the best lens so far, after {count} iterations</source>
            <translation>die bisher beste Linse, nach {count} Iterationen</translation>
        </message>
        <message>
            <location filename="../../ui/run/lens_on_show.py" />
            <source>the best mirror so far, after {count} iterations</source>
            <translation>der bisher beste Spiegel, nach {count} Iterationen</translation>
        </message>
        <message>
            <location filename="../../ui/run/lens_on_show.py" />
            <source>the lens on show, {origin}</source>
            <translation>die gezeigte Linse, {origin}</translation>
        </message>
        <message>
            <location filename="../../ui/run/lens_on_show.py" />
            <source>the mirror on show, {origin}</source>
            <translation>der gezeigte Spiegel, {origin}</translation>
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
            <source>Stop asked for</source>
            <translation>Stopp verlangt</translation>
        </message>
        <message>
            <location filename="../../ui/run/log.py" />
            <source>{name} is kept no longer: kept runs would take too much memory</source>
            <translation>{name} wird nicht mehr aufbewahrt: aufbewahrte Läufe bräuchten zu viel Speicher</translation>
        </message>
        <message>
            <location filename="../../ui/run/log.py" />
            <source>Run begins: {name}, method {method}</source>
            <translation>Lauf beginnt: {name}, Methode {method}</translation>
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
            <source>Run ended before its first lens</source>
            <translation>Lauf endete vor seiner ersten Linse</translation>
        </message>
        <message>
            <location filename="../../ui/run/log.py" />
            <source>Run ended before its first mirror</source>
            <translation>Lauf endete vor seinem ersten Spiegel</translation>
        </message>
        <message>
            <location filename="../../ui/run/log.py" />
            <source>Run ended{why} after iteration {iteration} of {iterations}, {clock}: last loss {loss}, {efficiency:.1f} % {place}</source>
            <translation>Lauf beendet{why} nach Iteration {iteration} von {iterations}, {clock}: letzte Zielfunktion {loss}, {efficiency:.1f} % {place}</translation>
        </message>
        <message>
            <location filename="../../ui/run/run_check.py" />
            <source>check of the run</source>
            <translation>Prüfung des Laufs</translation>
        </message>
        <message>
            <location filename="../../ui/run/run_check.py" />
            <source>Checked error {error} at {iteration}</source>
            <translation>Geprüfter Fehler {error} bei {iteration}</translation>
        </message>
        <message>
            <location filename="../../ui/run/runner.py" />
            <source>run</source>
            <translation>Lauf</translation>
        </message>
        <message>
            <location filename="../../ui/run/runs.py" />
            <source>Choose one run in View &gt; Runs first.</source>
            <translation>Zuerst in Ansicht &gt; Läufe einen Lauf wählen.</translation>
        </message>
        <message>
            <location filename="../../ui/run/runs.py" />
            <source>Choose runs in View &gt; Runs first.</source>
            <translation>Zuerst in Ansicht &gt; Läufe Läufe wählen.</translation>
        </message>
        <message>
            <location filename="../../ui/run/runs.py" />
            <source>Choose two runs in View &gt; Runs first: Ctrl and a click.</source>
            <translation>Zuerst in Ansicht &gt; Läufe zwei Läufe wählen: Strg und Klick.</translation>
        </message>
        <message>
            <location filename="../../ui/run/runs.py" />
            <source>rename run</source>
            <translation>Lauf umbenennen</translation>
        </message>
        <message>
            <location filename="../../ui/run/runs.py" />
            <source>The run is still called {name}: {reason}</source>
            <translation>Der Lauf heißt weiterhin {name}: {reason}</translation>
        </message>
        <message>
            <location filename="../../ui/run/runs.py" />
            <source>return to {name}</source>
            <translation>zurück zu {name}</translation>
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
            <location filename="../../ui/run/status.py" />
            <source>iteration {done} of {count}{rate}</source>
            <translation>Iteration {done} von {count}{rate}</translation>
        </message>
        <message>
            <location filename="../../ui/run/status.py" />
            <source>Error {error} · light {place} {shares}</source>
            <translation>Fehler {error} · Licht {place} {shares}</translation>
        </message>
        <message>
            <location filename="../../ui/run/status.py" />
            <source>loss {loss}</source>
            <translation>Zielfunktion {loss}</translation>
        </message>
        <message>
            <location filename="../../ui/run/status.py" />
            <source>{time} elapsed</source>
            <translation>Zeit {time}</translation>
        </message>
        <message>
            <location filename="../../ui/run/status.py" />
            <source>at most {time} left</source>
            <translation>höchstens noch {time}</translation>
        </message>
        <message>
            <location filename="../../ui/run/status.py" />
            <source>Outdated:</source>
            <translation>Veraltet:</translation>
        </message>
        <message>
            <location filename="../../ui/run/status.py" />
            <source>Iterations done, and how many a second lately</source>
            <translation>Ausgeführte Iterationen, und wie viele je Sekunde zuletzt</translation>
        </message>
        <message>
            <location filename="../../ui/run/status.py" />
            <source>Relative L2 error of the image after so many iterations of the run, by an independent trace with rays that the design never saw; the scatter of these rays is left out</source>
            <translation>Relativer L2-Fehler des Bildes nach so vielen Iterationen des Laufs, nach einer unabhängigen Durchrechnung mit Strahlen, die der Entwurf nie gesehen hat; ohne die Streuung dieser Strahlen</translation>
        </message>
        <message>
            <location filename="../../ui/run/status.py" />
            <source>Relative L2 error of the design on show, by an independent trace with rays that the design never saw; the scatter of these rays is left out. The log tells more</source>
            <translation>Relativer L2-Fehler des gezeigten Entwurfs, nach einer unabhängigen Durchrechnung mit Strahlen, die der Entwurf nie gesehen hat; ohne die Streuung dieser Strahlen. Das Protokoll sagt mehr</translation>
        </message>
        <message>
            <location filename="../../ui/run/status.py" />
            <source>How far the image is from the target, as the design sees it (relative L2), and how much of the light lands where it is wanted: on the screen, or in the far field. Of several images, both are given for each</source>
            <translation>Wie weit das Bild vom Ziel entfernt ist, wie der Entwurf es sieht (relatives L2), und wie viel Licht ankommt, wo es gewünscht ist: auf dem Schirm oder im Fernfeld. Bei mehreren Bildern beides für jedes</translation>
        </message>
        <message>
            <location filename="../../ui/run/status.py" />
            <source>in the far field</source>
            <translation>im Fernfeld</translation>
        </message>
        <message>
            <location filename="../../ui/run/status.py" />
            <source>What the design makes as small as it can</source>
            <translation>Was der Entwurf so klein wie möglich macht</translation>
        </message>
        <message>
            <location filename="../../ui/run/status.py" />
            <source>Run time</source>
            <translation>Laufzeit</translation>
        </message>
        <message>
            <location filename="../../ui/run/status.py" />
            <source>Time left at the pace of the last seconds. Automatic ends sooner when nothing improves any more</source>
            <translation>Verbleibende Zeit beim Tempo der letzten Sekunden. Automatisch endet früher, wenn nichts mehr besser wird</translation>
        </message>
        <message>
            <location filename="../../ui/run/status.py" />
            <source>{time} left</source>
            <translation>noch {time}</translation>
        </message>
        <message>
            <location filename="../../ui/run/status.py" />
            <source>Progress of the design</source>
            <translation>Fortschritt des Entwurfs</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Each run that ends is kept here, to be compared with others and gone back to.</source>
            <translation>Jeder beendete Lauf wird hier aufbewahrt, um ihn zu vergleichen und zu ihm zurückzukehren.</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Name</source>
            <translation>Name</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>What the run is called, with its light; a check mark draws its loss beside that of this run</source>
            <translation>Wie der Lauf heißt, mit seinem Licht; ein Häkchen zeichnet seine Zielfunktion neben der dieses Laufs</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>The image that the light should draw: its file, or what it is</source>
            <translation>Das Bild, das das Licht zeichnen soll: seine Datei, oder was es ist</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Error</source>
            <translation>Fehler</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Relative L2 error of its best result, as the run saw it</source>
            <translation>Relativer L2-Fehler seines besten Ergebnisses, wie der Lauf ihn sah</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Verified</source>
            <translation>Geprüft</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Relative L2 error of its result, by an independent trace with other rays</source>
            <translation>Relativer L2-Fehler des Ergebnisses, nach einer unabhängigen Durchrechnung mit anderen Strahlen</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>On screen</source>
            <translation>Auf dem Schirm</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Part of the light that lands on the screen, or in the far field</source>
            <translation>Teil des Lichts, der auf dem Schirm oder im Fernfeld ankommt</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Time</source>
            <translation>Zeit</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Iterations</source>
            <translation>Iterationen</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Iterations taken, those of runs that it continued included</source>
            <translation>Ausgeführte Iterationen, auch die der Läufe, die er fortsetzte</translation>
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
            <source>How the result was searched for</source>
            <translation>Wie das Ergebnis gesucht wurde</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Loss of its best result, as the run saw it</source>
            <translation>Zielfunktion des besten Ergebnisses, wie der Lauf sie sah</translation>
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
            <source>Restore</source>
            <translation>Wiederherstellen</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Give the design this run's task and result</source>
            <translation>Dem Entwurf Aufgabe und Ergebnis dieses Laufs geben</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Forget the chosen runs</source>
            <translation>Die gewählten Läufe verwerfen</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Compare</source>
            <translation>Vergleichen</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>See two chosen runs beside each other: light, figures, fields</source>
            <translation>Zwei gewählte Läufe nebeneinander sehen: Licht, Zahlen, Felder</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>The one of the design</source>
            <translation>Der des Entwurfs</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>A name has at most {count} characters</source>
            <translation>Ein Name hat höchstens {count} Zeichen</translation>
        </message>
        <message>
            <location filename="../../ui/shown/image_titles.py" />
            <source>Image {number}, {place}</source>
            <translation>Bild {number}, {place}</translation>
        </message>
        <message>
            <location filename="../../ui/startup/unexpected_errors.py" />
            <source>Something went wrong that should not: {error}. Your work is still here: save it.</source>
            <translation>Etwas ist schiefgegangen, das nicht schiefgehen sollte: {error}. Ihre Arbeit ist noch da: speichern Sie sie.</translation>
        </message>
        <message>
            <location filename="../../ui/startup/warm_up.py" />
            <source>start</source>
            <translation>Start</translation>
        </message>
        <message>
            <location filename="../../ui/sweep/curve.py" />
            <source>Verified error over the values</source>
            <translation>Geprüfter Fehler über den Werten</translation>
        </message>
        <message>
            <location filename="../../ui/sweep/dialog.py" />
            <source>Each value, or each pair of values of two fields, gets a design of its own, which is checked. Sessions and a table (CSV, JSON) go into the folder; what is finished there is not done again.</source>
            <translation>Jeder Wert, oder jedes Paar von Werten zweier Felder, bekommt einen eigenen Entwurf, der geprüft wird. Sitzungen und eine Tabelle (CSV, JSON) kommen in den Ordner; was dort fertig ist, wird nicht noch einmal gemacht.</translation>
        </message>
        <message>
            <location filename="../../ui/sweep/dialog.py" />
            <source>Verified error</source>
            <translation>Geprüfter Fehler</translation>
        </message>
        <message>
            <location filename="../../ui/sweep/dialog.py" />
            <source>Light</source>
            <translation>Licht</translation>
        </message>
        <message>
            <location filename="../../ui/sweep/dialog.py" />
            <source>Seconds</source>
            <translation>Sekunden</translation>
        </message>
        <message>
            <location filename="../../ui/sweep/dialog.py" />
            <source>Sweep</source>
            <translation>Reihe</translation>
        </message>
        <message>
            <location filename="../../ui/sweep/dialog.py" />
            <source>Folder</source>
            <translation>Ordner</translation>
        </message>
        <message>
            <location filename="../../ui/sweep/dialog.py" />
            <source>How far the sweep is</source>
            <translation>Wie weit die Reihe ist</translation>
        </message>
        <message>
            <location filename="../../ui/sweep/dialog.py" />
            <source>&amp;Open design</source>
            <translation>&amp;Entwurf öffnen</translation>
        </message>
        <message>
            <location filename="../../ui/sweep/dialog.py" />
            <source>Open the session of the chosen row in the window</source>
            <translation>Die Sitzung der gewählten Zeile im Fenster öffnen</translation>
        </message>
        <message>
            <location filename="../../ui/sweep/dialog.py" />
            <source>Choose a folder for the designs.</source>
            <translation>Einen Ordner für die Entwürfe wählen.</translation>
        </message>
        <message>
            <location filename="../../ui/sweep/dialog.py" />
            <source>Asked for at the start</source>
            <translation>Wird beim Start erfragt</translation>
        </message>
        <message>
            <location filename="../../ui/sweep/dialog.py" />
            <source>Choose the folder</source>
            <translation>Den Ordner wählen</translation>
        </message>
        <message>
            <location filename="../../ui/sweep/dialog.py" />
            <source>sweep</source>
            <translation>Reihe</translation>
        </message>
        <message>
            <location filename="../../ui/sweep/dialog.py" />
            <source>{count} of {wanted} designs</source>
            <translation>{count} von {wanted} Entwürfen</translation>
        </message>
        <message>
            <location filename="../../ui/sweep/dialog.py" />
            <source>Designs of the sweep</source>
            <translation>Entwürfe der Reihe</translation>
        </message>
        <message>
            <location filename="../../ui/sweep/form.py" />
            <source>Between commas: numbers as 1, 2.5, 3; whole numbers as 0..4; pairs as 64x48; words as auto. Lengths in the unit of the scene.</source>
            <translation>Zwischen Kommas: Zahlen wie 1, 2.5, 3; ganze Zahlen wie 0..4; Paare wie 64x48; Wörter wie auto. Längen in der Einheit der Szene.</translation>
        </message>
        <message>
            <location filename="../../ui/sweep/form.py" />
            <source>Field</source>
            <translation>Feld</translation>
        </message>
        <message>
            <location filename="../../ui/sweep/form.py" />
            <source>Second field</source>
            <translation>Zweites Feld</translation>
        </message>
        <message>
            <location filename="../../ui/sweep/form.py" />
            <source>Values of {field}</source>
            <translation>Werte von {field}</translation>
        </message>
        <message>
            <location filename="../../ui/sweep/form.py" />
            <source>now {value}</source>
            <translation>jetzt {value}</translation>
        </message>
        <message>
            <location filename="../../ui/threads/failure.py" />
            <source>The {work} ended with an {error}</source>
            <translation>{work}: beendet mit „{error}“</translation>
        </message>
        <message>
            <location filename="../../ui/tolerances/form.py" />
            <source>Save…</source>
            <translation>Speichern …</translation>
        </message>
        <message>
            <location filename="../../ui/tolerances/form.py" />
            <source>Save the plot (PNG, SVG), or the figures of each lens (CSV, JSON)</source>
            <translation>Das Diagramm (PNG, SVG) oder die Zahlen jeder Linse (CSV, JSON) speichern</translation>
        </message>
        <message>
            <location filename="../../ui/tolerances/form.py" />
            <source>a whole number from 1 to {most} is needed</source>
            <translation>eine ganze Zahl von 1 bis {most} ist nötig</translation>
        </message>
        <message>
            <location filename="../../ui/tolerances/form.py" />
            <source>a whole number from 0 is needed</source>
            <translation>eine ganze Zahl ab 0 ist nötig</translation>
        </message>
        <message>
            <location filename="../../ui/tolerances/form.py" />
            <source>a finite number from 0 is needed</source>
            <translation>eine endliche Zahl ab 0 ist nötig</translation>
        </message>
        <message>
            <location filename="../../ui/tolerances/form.py" />
            <source>over</source>
            <translation>über</translation>
        </message>
        <message>
            <location filename="../../ui/tolerances/form.py" />
            <source>Lenses</source>
            <translation>Linsen</translation>
        </message>
        <message>
            <location filename="../../ui/tolerances/form.py" />
            <source>How many are traced; more make the tail surer</source>
            <translation>Wie viele durchgerechnet werden; mehr machen die Ränder der Verteilung sicherer</translation>
        </message>
        <message>
            <location filename="../../ui/tolerances/form.py" />
            <source>Seed</source>
            <translation>Startwert</translation>
        </message>
        <message>
            <location filename="../../ui/tolerances/form.py" />
            <source>The same seed gives the same lenses</source>
            <translation>Derselbe Startwert ergibt dieselben Linsen</translation>
        </message>
        <message>
            <location filename="../../ui/tolerances/pane.py" />
            <source>Nothing is off: give a tilt, a decentre or another tolerance.</source>
            <translation>Nichts weicht ab: eine Verkippung, Dezentrierung oder andere Toleranz angeben.</translation>
        </message>
        <message>
            <location filename="../../ui/tolerances/pane.py" />
            <source>sample of tolerances</source>
            <translation>Toleranzstichprobe</translation>
        </message>
        <message>
            <location filename="../../ui/tolerances/pane.py" />
            <source>Trace no more; those that are traced count</source>
            <translation>Nicht weiter durchrechnen; was durchgerechnet ist, zählt</translation>
        </message>
        <message>
            <location filename="../../ui/tolerances/pane.py" />
            <source>Perturb what is on show at random, and trace each with fresh rays</source>
            <translation>Das Gezeigte zufällig stören und jedes mit neuen Strahlen durchrechnen</translation>
        </message>
        <message>
            <location filename="../../ui/tolerances/pane.py" />
            <source>{count} of {wanted} lenses</source>
            <translation>{count} von {wanted} Linsen</translation>
        </message>
        <message>
            <location filename="../../ui/tolerances/pane.py" />
            <source>{done}: error as designed {nominal:.2f} %, median {median:.2f} %, 95 % of lenses below {most:.2f} %, worst {worst:.2f} %</source>
            <translation>{done}: Fehler wie entworfen {nominal:.2f} %, Median {median:.2f} %, 95 % der Linsen unter {most:.2f} %, schlechteste {worst:.2f} %</translation>
        </message>
        <message>
            <location filename="../../ui/tolerances/pane.py" />
            <source>Out of date: the lens has changed since.</source>
            <translation>Veraltet: die Linse hat sich seitdem geändert.</translation>
        </message>
        <message>
            <location filename="../../ui/tolerances/spread_view.py" />
            <source>How does the image change when lenses are a little off? Start traces some of them.</source>
            <translation>Wie ändert sich das Bild, wenn Linsen etwas abweichen? Start rechnet einige davon durch.</translation>
        </message>
        <message>
            <location filename="../../ui/views/derivative_view.py" />
            <source>Control point</source>
            <translation>Kontrollpunkt</translation>
        </message>
        <message>
            <location filename="../../ui/views/derivative_view.py" />
            <source>Choose it here, or click it in the 3D scene.</source>
            <translation>Hier wählen oder in der 3D-Szene anklicken.</translation>
        </message>
        <message>
            <location filename="../../ui/views/derivative_view.py" />
            <source>Computed when the design rests…</source>
            <translation>Wird berechnet, sobald der Entwurf ruht …</translation>
        </message>
        <message>
            <location filename="../../ui/views/derivative_view.py" />
            <source>Computing…</source>
            <translation>Berechnung …</translation>
        </message>
        <message>
            <location filename="../../ui/views/derivative_view.py" />
            <source>derivative map</source>
            <translation>Ableitungskarte</translation>
        </message>
        <message>
            <location filename="../../ui/views/derivative_view.py" />
            <source>There is no map of this point yet.</source>
            <translation>Von diesem Punkt gibt es noch keine Karte.</translation>
        </message>
        <message>
            <location filename="../../ui/views/derivative_view.py" />
            <source>Number of the control point along {axis}, counted from 0</source>
            <translation>Nummer des Kontrollpunkts entlang {axis}, ab 0 gezählt</translation>
        </message>
        <message>
            <location filename="../../ui/views/derivative_view.py" />
            <source>Control point along {axis}</source>
            <translation>Kontrollpunkt entlang {axis}</translation>
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
            <location filename="../../ui/views/face_choice.py" />
            <source>Face</source>
            <translation>Fläche</translation>
        </message>
        <message>
            <location filename="../../ui/views/face_choice.py" />
            <source>Which of the freeform faces of the lens is meant</source>
            <translation>Welche der Freiformflächen der Linse gemeint ist</translation>
        </message>
        <message>
            <location filename="../../ui/views/focus_curve.py" />
            <source>Relative L2 error against the distance; the dotted line is the screen</source>
            <translation>Relativer L2-Fehler über dem Abstand; die gepunktete Linie ist der Schirm</translation>
        </message>
        <message>
            <location filename="../../ui/views/focus_view.py" />
            <source>trace through focus</source>
            <translation>Fokusreihe</translation>
        </message>
        <message>
            <location filename="../../ui/views/focus_view.py" />
            <source>A far field is at no distance: there is nothing to focus.</source>
            <translation>Ein Fernfeld liegt in keinem Abstand: es gibt nichts zu fokussieren.</translation>
        </message>
        <message>
            <location filename="../../ui/views/focus_view.py" />
            <source>Distance of the screen</source>
            <translation>Abstand des Schirms</translation>
        </message>
        <message>
            <location filename="../../ui/views/focus_view.py" />
            <source>Look at the light before or behind the screen: half to one and a half times its distance. The scene stays as it is</source>
            <translation>Das Licht vor oder hinter dem Schirm ansehen: beim halben bis anderthalbfachen Abstand. Die Szene bleibt, wie sie ist</translation>
        </message>
        <message>
            <location filename="../../ui/views/focus_view.py" />
            <source>At screen</source>
            <translation>Am Schirm</translation>
        </message>
        <message>
            <location filename="../../ui/views/focus_view.py" />
            <source>Go back to the distance of the scene's screen</source>
            <translation>Zum Abstand des Schirms der Szene zurückkehren</translation>
        </message>
        <message>
            <location filename="../../ui/views/focus_view.py" />
            <source>Curve</source>
            <translation>Kurve</translation>
        </message>
        <message>
            <location filename="../../ui/views/focus_view.py" />
            <source>Trace the light to many distances and draw the error against them</source>
            <translation>Das Licht in vielen Abständen durchrechnen und den Fehler darüber zeichnen</translation>
        </message>
        <message>
            <location filename="../../ui/views/focus_view.py" />
            <source>traced when the design rests…</source>
            <translation>wird durchgerechnet, sobald der Entwurf ruht …</translation>
        </message>
        <message>
            <location filename="../../ui/views/focus_view.py" />
            <source>tracing…</source>
            <translation>Durchrechnung …</translation>
        </message>
        <message>
            <location filename="../../ui/views/focus_view.py" />
            <source>no light arrives there</source>
            <translation>dort kommt kein Licht an</translation>
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
            <location filename="../../ui/views/focus_view.py" />
            <source>screen</source>
            <translation>Schirm</translation>
        </message>
        <message>
            <location filename="../../ui/views/focus_view.py" />
            <source>The light there is traced when the design rests.</source>
            <translation>Das Licht dort wird durchgerechnet, sobald der Entwurf ruht.</translation>
        </message>
        <message>
            <location filename="../../ui/views/history_slider.py" />
            <source>Moment of the run</source>
            <translation>Zeitpunkt des Laufs</translation>
        </message>
        <message>
            <location filename="../../ui/views/history_slider.py" />
            <source>Look back at the design and its light at any moment of the run</source>
            <translation>Auf den Entwurf und sein Licht zu jedem Zeitpunkt des Laufs zurückblicken</translation>
        </message>
        <message>
            <location filename="../../ui/views/history_slider.py" />
            <source>iteration {number}</source>
            <translation>Iteration {number}</translation>
        </message>
        <message>
            <location filename="../../ui/views/history_slider.py" />
            <source>Go on from here</source>
            <translation>Von hier fortfahren</translation>
        </message>
        <message>
            <location filename="../../ui/views/history_slider.py" />
            <source>Take the design as it was at this moment, and continue from it; Undo brings the later one back</source>
            <translation>Den Entwurf nehmen, wie er zu diesem Zeitpunkt war, und von dort fortfahren; Rückgängig bringt den späteren zurück</translation>
        </message>
        <message>
            <location filename="../../ui/views/image_choice.py" />
            <source>Which of the scene's images is shown</source>
            <translation>Welches der Bilder der Szene gezeigt wird</translation>
        </message>
        <message>
            <location filename="../../ui/views/image_view.py" />
            <source>Value under the pointer</source>
            <translation>Wert unter dem Zeiger</translation>
        </message>
        <message>
            <location filename="../../ui/views/image_view.py" />
            <source>beside the lens</source>
            <translation>neben der Linse</translation>
        </message>
        <message>
            <location filename="../../ui/views/image_view.py" />
            <source>beside the mirror</source>
            <translation>neben dem Spiegel</translation>
        </message>
        <message>
            <location filename="../../ui/views/image_view.py" />
            <source>{value} at {x}, {y}</source>
            <translation>{value} bei {x}, {y}</translation>
        </message>
        <message>
            <location filename="../../ui/views/light_image_view.py" />
            <source>Logarithmic colours</source>
            <translation>Logarithmische Farben</translation>
        </message>
        <message>
            <location filename="../../ui/views/light_image_view.py" />
            <source>Logarithmic colours, over three decades: stray light is seen</source>
            <translation>Logarithmische Farben über drei Dekaden: Streulicht wird sichtbar</translation>
        </message>
        <message>
            <location filename="../../ui/views/light_view.py" />
            <source>All parts</source>
            <translation>Alle Teile</translation>
        </message>
        <message>
            <location filename="../../ui/views/light_view.py" />
            <source>The parts together; the account is complete when this is 100 %.</source>
            <translation>Die Teile zusammen; die Bilanz ist vollständig, wenn das 100 % ist.</translation>
        </message>
        <message>
            <location filename="../../ui/views/loss_view.py" />
            <source>Axes</source>
            <translation>Achsen</translation>
        </message>
        <message>
            <location filename="../../ui/views/loss_view.py" />
            <source>What the loss is drawn against, and how</source>
            <translation>Worüber die Zielfunktion gezeichnet wird, und wie</translation>
        </message>
        <message>
            <location filename="../../ui/views/loss_view.py" />
            <source>Against iterations</source>
            <translation>Über Iterationen</translation>
        </message>
        <message>
            <location filename="../../ui/views/loss_view.py" />
            <source>Against seconds</source>
            <translation>Über Sekunden</translation>
        </message>
        <message>
            <location filename="../../ui/views/loss_view.py" />
            <source>Logarithmic x</source>
            <translation>x logarithmisch</translation>
        </message>
        <message>
            <location filename="../../ui/views/loss_view.py" />
            <source>Logarithmic y</source>
            <translation>y logarithmisch</translation>
        </message>
        <message>
            <location filename="../../ui/views/loss_view.py" />
            <source>The loss is drawn here while a design runs. Run &gt; Start begins one.</source>
            <translation>Hier wird die Zielfunktion gezeichnet, während ein Entwurf läuft. Lauf &gt; Start beginnt einen.</translation>
        </message>
        <message>
            <location filename="../../ui/views/photo_view.py" />
            <source>predict the photo</source>
            <translation>Fotovorhersage</translation>
        </message>
        <message>
            <location filename="../../ui/views/photo_view.py" />
            <source>There is no lens yet: Start designs one.</source>
            <translation>Es gibt noch keine Linse: Start entwirft eine.</translation>
        </message>
        <message>
            <location filename="../../ui/views/photo_view.py" />
            <source>The photo is predicted when the design rests.</source>
            <translation>Das Foto wird vorhergesagt, sobald der Entwurf ruht.</translation>
        </message>
        <message>
            <location filename="../../ui/views/photo_view.py" />
            <source>Predicting… {part:.0f} %</source>
            <translation>Vorhersage … {part:.0f} %</translation>
        </message>
        <message>
            <location filename="../../ui/views/photo_view.py" />
            <source>Light of the photo</source>
            <translation>Licht des Fotos</translation>
        </message>
        <message>
            <location filename="../../ui/views/photo_view.py" />
            <source>What the lens is lit by: as its source suggests (daylight from infinitely far, a laser as a Gaussian beam, else an LED), or another light</source>
            <translation>Womit die Linse beleuchtet wird: wie ihre Quelle es nahelegt (Tageslicht aus dem Unendlichen, ein Laser als Gaußstrahl, sonst eine LED), oder ein anderes Licht</translation>
        </message>
        <message>
            <location filename="../../ui/views/photo_view.py" />
            <source>Light of the source</source>
            <translation>Licht der Quelle</translation>
        </message>
        <message>
            <location filename="../../ui/views/photo_view.py" />
            <source>Exposure</source>
            <translation>Belichtung</translation>
        </message>
        <message>
            <location filename="../../ui/views/photo_view.py" />
            <source>Exposure in stops: one more makes all twice as bright</source>
            <translation>Belichtung in Blendenstufen: eine mehr macht alles doppelt so hell</translation>
        </message>
        <message>
            <location filename="../../ui/views/photo_view.py" />
            <source>{number} stops</source>
            <translation>{number} Blenden</translation>
        </message>
        <message>
            <location filename="../../ui/views/photo_view.py" />
            <source>The usual exposure: the target's brightest pixel is white</source>
            <translation>Die übliche Belichtung: das hellste Pixel des Ziels ist weiß</translation>
        </message>
        <message>
            <location filename="../../ui/views/photo_view.py" />
            <source>Usual exposure</source>
            <translation>Übliche Belichtung</translation>
        </message>
        <message>
            <location filename="../../ui/views/photo_view.py" />
            <source>Out of date: of the lens before. </source>
            <translation>Veraltet: von der vorigen Linse. </translation>
        </message>
        <message>
            <location filename="../../ui/views/plot_view.py" />
            <source>The first picture of this design comes in a moment.</source>
            <translation>Das erste Bild dieses Entwurfs kommt gleich.</translation>
        </message>
        <message>
            <location filename="../../ui/views/plot_view.py" />
            <source>There is too little room here for a picture.</source>
            <translation>Hier ist zu wenig Platz für ein Bild.</translation>
        </message>
        <message>
            <location filename="../../ui/views/plot_view.py" />
            <source>There is no picture of this design: its light cannot be traced.</source>
            <translation>Von diesem Entwurf gibt es kein Bild: sein Licht lässt sich nicht durchrechnen.</translation>
        </message>
        <message>
            <location filename="../../ui/views/region_marks.py" />
            <source>least / mean {number:.2f}</source>
            <translation>kleinste / mittlere {number:.2f}</translation>
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
            <location filename="../../ui/views/screen_image_view.py" />
            <source>Draw a line</source>
            <translation>Eine Linie ziehen</translation>
        </message>
        <message>
            <location filename="../../ui/views/screen_image_view.py" />
            <source>Drag across an image to draw the line of a cross-section; Shift and drag does so too</source>
            <translation>Über ein Bild ziehen, um die Linie eines Schnitts zu zeichnen; Umschalt und Ziehen tut es auch</translation>
        </message>
        <message>
            <location filename="../../ui/views/screen_image_view.py" />
            <source>{side}: mirror-inverted</source>
            <translation>{side}: spiegelverkehrt</translation>
        </message>
        <message>
            <location filename="../../ui/views/section_view.py" />
            <source>Where the screen is cut: along x or y through the place that is clicked in an image,
or along a line that is drawn across one with Shift and drag.
Arrow keys move place or line by a pixel, with Shift by ten; with Ctrl, the end of the line</source>
            <translation>Wo der Schirm geschnitten wird: entlang x oder y durch die Stelle, die in einem Bild angeklickt wird,
oder entlang einer Linie, die mit Umschalt und Ziehen gezeichnet wird.
Pfeiltasten verschieben Stelle oder Linie um ein Pixel, mit Umschalt um zehn; mit Strg das Ende der Linie</translation>
        </message>
        <message>
            <location filename="../../ui/views/section_view.py" />
            <source>Along</source>
            <translation>Entlang</translation>
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
            <source>From {start} to {end} {unit}.
{tip}</source>
            <translation>Von {start} bis {end} {unit}.
{tip}</translation>
        </message>
        <message>
            <location filename="../../ui/views/target_view.py" />
            <source>The target with as much light as arrives: where the irradiance is right, both have the same colour, however much light is lost on the way. The light account tells where that goes.</source>
            <translation>Das Ziel mit so viel Licht, wie ankommt: wo die Bestrahlungsstärke stimmt, haben beide dieselbe Farbe, wie viel Licht auch unterwegs verloren geht. Die Lichtbilanz sagt, wohin.</translation>
        </message>
        <message>
            <location filename="../../ui/widgets/log_view.py" />
            <source>What runs, checks and exports tell is written here.</source>
            <translation>Hier steht, was Läufe, Prüfungen und Exporte melden.</translation>
        </message>
        <message>
            <location filename="../../ui/widgets/message_bar.py" />
            <source>Close this message</source>
            <translation>Diese Meldung schließen</translation>
        </message>
        <message>
            <location filename="../../ui/widgets/plot_words.py" />
            <source>as designed</source>
            <translation>wie entworfen</translation>
        </message>
        <message>
            <location filename="../../ui/widgets/plot_words.py" />
            <source>lenses up to there</source>
            <translation>Linsen bis dorthin</translation>
        </message>
        <message>
            <location filename="../../ui/widgets/plot_words.py" />
            <source>z of the screen</source>
            <translation>z des Schirms</translation>
        </message>
        <message>
            <location filename="../../ui/widgets/plot_words.py" />
            <source>Second minus first</source>
            <translation>Zweites minus erstes</translation>
        </message>
        <message>
            <location filename="../../ui/widgets/plot_words.py" />
            <source>The receivers cover different places: nothing to subtract.</source>
            <translation>Die Empfänger decken verschiedene Orte ab: nichts abzuziehen.</translation>
        </message>
        <message>
            <location filename="../../ui/widgets/plot_words.py" />
            <source>iteration</source>
            <translation>Iteration</translation>
        </message>
        <message>
            <location filename="../../ui/widgets/plot_words.py" />
            <source>time</source>
            <translation>Zeit</translation>
        </message>
        <message>
            <location filename="../../ui/widgets/plot_words.py" />
            <source>distance</source>
            <translation>Abstand</translation>
        </message>
        <message>
            <location filename="../../ui/widgets/plot_words.py" />
            <source>loss</source>
            <translation>Zielfunktion</translation>
        </message>
        <message>
            <location filename="../../ui/widgets/plot_words.py" />
            <source>this run</source>
            <translation>dieser Lauf</translation>
        </message>
        <message>
            <location filename="../../ui/widgets/plot_words.py" />
            <source>verified</source>
            <translation>geprüft</translation>
        </message>
        <message>
            <location filename="../../ui/widgets/plot_words.py" />
            <source>target</source>
            <translation>Ziel</translation>
        </message>
        <message>
            <location filename="../../ui/widgets/plot_words.py" />
            <source>irradiance</source>
            <translation>Bestrahlungsstärke</translation>
        </message>
        <message>
            <location filename="../../ui/widgets/plot_words.py" />
            <source>intensity</source>
            <translation>Strahlstärke</translation>
        </message>
        <message>
            <location filename="../../ui/widgets/plot_words.py" />
            <source>error</source>
            <translation>Fehler</translation>
        </message>
        <message>
            <location filename="../../ui/widgets/plot_words.py" />
            <source>flux / {unit}</source>
            <translation>Fluss / {unit}</translation>
        </message>
        <message>
            <location filename="../../ui/widgets/plot_words.py" />
            <source>{axis} at {place}</source>
            <translation>{axis} bei {place}</translation>
        </message>
        <message>
            <location filename="../../ui/widgets/veil.py" />
            <source>Outdated: this is the design before the change</source>
            <translation>Veraltet: das ist der Entwurf vor der Änderung</translation>
        </message>
        <message>
            <location filename="../../ui/window/early_parts.py" />
            <source>The run waits for its tracing kernels: they are compiled once after installing, for about half a minute</source>
            <translation>Der Lauf wartet auf seine Rechenkerne: sie werden einmal nach der Installation übersetzt, etwa eine halbe Minute lang</translation>
        </message>
        <message>
            <location filename="../../ui/window/loaded_parts.py" />
            <source>Stop the run first; then mark regions.</source>
            <translation>Erst den Lauf anhalten, dann Ausschnitte markieren.</translation>
        </message>
        <message>
            <location filename="../../ui/window/loaded_parts.py" />
            <source>Cancel &amp;check</source>
            <translation>Prüfung abb&amp;rechen</translation>
        </message>
        <message>
            <location filename="../../ui/window/view_state.py" />
            <source>The {what} kept with this design cannot be shown again: {error}</source>
            <translation>Mit diesem Entwurf Gespeichertes kann nicht wieder gezeigt werden ({what}): {error}</translation>
        </message>
        <message>
            <location filename="../../ui/window/window_state.py" />
            <source>Loading…</source>
            <translation>Lädt …</translation>
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
            <source>Stopped: {command} ({keys}) can make the lens better</source>
            <translation>Gestoppt: {command} ({keys}) kann die Linse besser machen</translation>
        </message>
        <message>
            <location filename="../../ui/window/window_state.py" />
            <source>Stopped: {command} ({keys}) can make the mirror better</source>
            <translation>Gestoppt: {command} ({keys}) kann den Spiegel besser machen</translation>
        </message>
        <message>
            <location filename="../../ui/window/workspace.py" />
            <source>Loading the 3D scene…</source>
            <translation>3D-Szene wird geladen …</translation>
        </message>
        <message>
            <location filename="../../ui/window/workspace.py" />
            <source>As opened</source>
            <translation>Wie geöffnet</translation>
        </message>
        <message>
            <location filename="../../ui/window/workspace.py" />
            <source>A click goes back or forth to that step</source>
            <translation>Ein Klick geht zu diesem Schritt zurück oder vor</translation>
        </message>
        <message>
            <location filename="../../ui/window/workspace.py" />
            <source>The 3D scene is hidden. View &gt; 3D scene shows it again.</source>
            <translation>Die 3D-Szene ist verborgen. Ansicht &gt; 3D-Szene zeigt sie wieder.</translation>
        </message>
        <message>
            <location filename="../../ui/windows.py" />
            <source>{name} is open with the unsaved changes that were recovered.</source>
            <translation>{name} ist mit den wiederhergestellten, ungespeicherten Änderungen geöffnet.</translation>
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
            <source>Light that passes the optic and the screen by. One that sends much light here wastes it, or has more than its surface can bend.</source>
            <translation>Licht, das an der Optik und am Schirm vorbeigeht. Eine, die viel Licht hierher schickt, verschwendet es oder hat mehr, als ihre Fläche ablenken kann.</translation>
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
            <source>far field</source>
            <translation>Fernfeld</translation>
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
            <source>Light that passes the optic and the far field by. One that sends much light here wastes it, or has more than its surface can bend.</source>
            <translation>Licht, das an der Optik und am Fernfeld vorbeigeht. Eine, die viel Licht hierher schickt, verschwendet es oder hat mehr, als ihre Fläche ablenken kann.</translation>
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
            <source>Vacuum wavelength at which the indices of materials are taken. Left empty, it is 0.5876 µm (helium d).</source>
            <translation>Vakuumwellenlänge, bei der die Brechzahlen der Materialien genommen werden. Leer: 0.5876 µm (Helium d).</translation>
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
            <source>Outline</source>
            <translation>Umriss</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>The shape of its face; of an ellipse the half-widths are semi-axes.</source>
            <translation>Die Form seiner Fläche; bei einer Ellipse sind die Halbbreiten Halbachsen.</translation>
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
            <source>Lenses and mirrors in the order in which light meets them. Light that passes one by is lost there.</source>
            <translation>Linsen und Spiegel in der Reihenfolge, in der Licht sie trifft. Licht, das an einem Element vorbeigeht, ist dort verloren.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Two faces with a material between; light goes through along its +z.</source>
            <translation>Zwei Flächen mit einem Material dazwischen; Licht geht entlang +z des Elements hindurch.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>What the element is called; letters, digits, - and _.</source>
            <translation>Wie das Element heißt; Buchstaben, Ziffern, - und _.</translation>
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
            <source>Its shape as seen along the axis; the half widths of an ellipse are its semi-axes. Light beside it misses the element.</source>
            <translation>Die Form entlang der Achse gesehen; bei einer Ellipse sind die Halbbreiten Halbachsen. Licht daneben verfehlt das Element.</translation>
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
            <source>Where light is wanted, and which. Two freeform faces can form several images; one face forms a compromise.</source>
            <translation>Wo Licht gewünscht ist, und welches. Zwei Freiformflächen können mehrere Bilder formen; eine Fläche formt einen Kompromiss.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Image</source>
            <translation>Bild</translation>
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
            <source>Turn</source>
            <translation>Drehen</translation>
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
            <source>Column 0 at −x</source>
            <translation>Spalte 0 bei −x</translation>
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
            <source>Gaussian</source>
            <translation>Gauß</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Light falls off over some pixels, so that a design feels where in a pixel a ray lands.</source>
            <translation>Das Licht fällt über einige Pixel ab, sodass ein Entwurf spürt, wo im Pixel ein Strahl landet.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Size</source>
            <translation>Größe</translation>
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
            <source>What figures of the region are called.</source>
            <translation>Wie Zahlen des Ausschnitts heißen.</translation>
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
            <source>Radius of the ball cutter that has to fit everywhere on the freeform faces. Hollows keep to it; humps may be sharper. Manufacture tells whether it fits. Left empty, any will do.</source>
            <translation>Radius des Kugelfräsers, der überall auf die Freiformflächen passen muss. Mulden halten ihn ein; Erhebungen dürfen schärfer sein. „Fertigung“ sagt, ob er passt. Leer: beliebig.</translation>
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
            <source>A lamp at the ceiling, or on the floor, lights a wall evenly from the side.</source>
            <translation>Eine Lampe an der Decke oder auf dem Boden beleuchtet eine Wand gleichmäßig von der Seite.</translation>
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
            <source>Source tilt</source>
            <translation>Quellenkippung</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Largest tilt of the source about its middle</source>
            <translation>Größte Verkippung der Quelle um ihre Mitte</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Source shift</source>
            <translation>Quellenversatz</translation>
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
            <source>fused silica</source>
            <translation>Quarzglas</translation>
        </message>
        <message>
            <location filename="../../workbench/design/endings.py" />
            <source>all iterations are done</source>
            <translation>alle Iterationen sind ausgeführt</translation>
        </message>
        <message>
            <location filename="../../workbench/design/endings.py" />
            <source>all control points are locked</source>
            <translation>alle Kontrollpunkte sind gesperrt</translation>
        </message>
        <message>
            <location filename="../../workbench/design/endings.py" />
            <source>stopped</source>
            <translation>gestoppt</translation>
        </message>
        <message>
            <location filename="../../workbench/design/endings.py" />
            <source>converged: error below {error:g} %</source>
            <translation>konvergiert: Fehler unter {error:g} %</translation>
        </message>
        <message>
            <location filename="../../workbench/design/endings.py" />
            <source>converged: no step makes the image better</source>
            <translation>konvergiert: kein Schritt verbessert das Bild</translation>
        </message>
        <message>
            <location filename="../../workbench/design/endings.py" />
            <source>converged: less than {gain:g} % better in {patience} iterations</source>
            <translation>konvergiert: weniger als {gain:g} % besser in {patience} Iterationen</translation>
        </message>
        <message>
            <location filename="../../workbench/design/endings.py" />
            <source>converged: error less than {points:g} percentage points lower in {patience} iterations</source>
            <translation>konvergiert: Fehler in {patience} Iterationen um weniger als {points:g} Prozentpunkte kleiner</translation>
        </message>
        <message>
            <location filename="../../workbench/design/endings.py" />
            <source>{ended}; no iteration made the lens better</source>
            <translation>{ended}; keine Iteration hat die Linse verbessert</translation>
        </message>
        <message>
            <location filename="../../workbench/design/endings.py" />
            <source>{ended}; the exit face alone makes no image</source>
            <translation>{ended}; die Austrittsfläche allein macht kein Bild</translation>
        </message>
        <message>
            <location filename="../../workbench/design/endings.py" />
            <source>{ended}; after {iterations} iterations the error of both faces was {times:.2g} times that of the exit face behind a flat entrance</source>
            <translation>{ended}; nach {iterations} Iterationen war der Fehler beider Flächen {times:.2g}-mal so groß wie der der Austrittsfläche hinter einem ebenen Eintritt</translation>
        </message>
        <message>
            <location filename="../../workbench/design/endings.py" />
            <source>failed: {why}</source>
            <translation>gescheitert: {why}</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/agreement.py" />
            <source>the check contradicts itself: {cells:.4g} % of the light on the receiver by cells, {rays:.4g} % by random rays; no figure of this check is reliable</source>
            <translation>die Prüfung widerspricht sich: {cells:.4g} % des Lichts auf dem Empfänger über Zellen, {rays:.4g} % mit Zufallsstrahlen; kein Wert dieser Prüfung ist verlässlich</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/agreement.py" />
            <source>the check contradicts itself: the images by cells and by random rays are {apart:.3g} % apart, which noise and error bound do not explain; no figure of this check is reliable</source>
            <translation>die Prüfung widerspricht sich: die Bilder über Zellen und mit Zufallsstrahlen liegen {apart:.3g} % auseinander, was Rauschen und Fehlerschranke nicht erklären; kein Wert dieser Prüfung ist verlässlich</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/agreement.py" />
            <source>the run finds {run:.4g} % of the light on the receiver, the check {check:.4g} %: use the figures of the check</source>
            <translation>der Lauf findet {run:.4g} % des Lichts auf dem Empfänger, die Prüfung {check:.4g} %: die Werte der Prüfung verwenden</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/agreement.py" />
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
            <location filename="../../workbench/analysis/cells/image.py" />
            <source>no light of this lens reaches the screen, so there is no image to judge</source>
            <translation>kein Licht dieser Linse erreicht den Schirm, also gibt es kein Bild zu beurteilen</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/cross_check.py" />
            <source>no light of this lens reaches the screen, so there is nothing to compare</source>
            <translation>kein Licht dieser Linse erreicht den Schirm, also gibt es nichts zu vergleichen</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/cut_lens.py" />
            <source>Error as cut {cut:.3g} % (± {cut_off:.1g}), as designed {designed:.3g} % (± {designed_off:.1g}).</source>
            <translation>Fehler wie gefräst {cut:.3g} % (± {cut_off:.1g}), wie entworfen {designed:.3g} % (± {designed_off:.1g}).</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/cut_lens.py" />
            <source>its cut is not traced; only that of an exit face is</source>
            <translation>der Schnitt wird nicht verfolgt; nur der einer Austrittsfläche</translation>
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
            <location filename="../../workbench/analysis/photo/light.py" />
            <source>laser of {wavelength:g} µm</source>
            <translation>Laser von {wavelength:g} µm</translation>
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
            <source>{part:.3f} % of the light, least / mean {even}</source>
            <translation>{part:.3f} % des Lichts, kleinste / mittlere {even}</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/regions.py" />
            <source>{part:.3f} % of the light, least / mean {even}, most / mean {most:.3f}</source>
            <translation>{part:.3f} % des Lichts, kleinste / mittlere {even}, größte / mittlere {most:.3f}</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/regions.py" />
            <source>{part:.3f} % of the light, {lumens}, mean {mean}, least {least}, most {most}, least / mean {even}</source>
            <translation>{part:.3f} % des Lichts, {lumens}, im Mittel {mean}, mindestens {least}, höchstens {most}, kleinste / mittlere {even}</translation>
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
            <source>{size:g}; at least 0, less than {room:g}, {otherwise}</source>
            <translation>{size:g}; mindestens 0, weniger als {room:g}, {otherwise}</translation>
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
            <location filename="../../workbench/analysis/tracing/train.py" />
            <source>a receiver at z = {z:g} may touch the element {name}; more than {least:g}</source>
            <translation>ein Empfänger bei z = {z:g} kann das Element {name} berühren; mehr als {least:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/validation.py" />
            <source>cells follow light through one element only; random rays are used</source>
            <translation>Zellen verfolgen Licht nur durch ein einziges Element; Zufallsstrahlen werden verwendet</translation>
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
            <location filename="../../workbench/design/blurred_plan.py" />
            <source>its light is blurred over {x:.3g} × {y:.3g} pixels</source>
            <translation>das Licht ist über {x:.3g} × {y:.3g} Pixel verschmiert</translation>
        </message>
        <message>
            <location filename="../../workbench/design/coarse_net.py" />
            <source>The image stays {error:.0f} % off: {n_u} × {n_v} control points are too few for the detail of this target. {finer_u} × {finer_v}, the automatic choice, can show it.</source>
            <translation>Das Bild bleibt {error:.0f} % daneben: {n_u} × {n_v} Kontrollpunkte sind zu wenige für die Einzelheiten dieses Ziels. {finer_u} × {finer_v}, die automatische Wahl, können sie zeigen.</translation>
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
            <location filename="../../workbench/design/needs.py" />
            <source>light grazes the far side of the screen, at {slant:.0f} degrees from across it, where the image is less exact; turn the screen towards the lens, or move its middle nearer to the axis</source>
            <translation>Licht streift die ferne Seite des Schirms, {slant:.0f} Grad von der Senkrechten, wo das Bild weniger genau ist; drehen Sie den Schirm zur Linse, oder rücken Sie seine Mitte näher an die Achse</translation>
        </message>
        <message>
            <location filename="../../workbench/design/needs.py" />
            <source>light grazes the far side of the far field, at {slant:.0f} degrees from across it, where the image is less exact; turn the far field towards the lens, or move its middle nearer to the axis</source>
            <translation>Licht streift die ferne Seite des Fernfelds, {slant:.0f} Grad von der Senkrechten, wo das Bild weniger genau ist; drehen Sie das Fernfeld zur Linse, oder rücken Sie seine Mitte näher an die Achse</translation>
        </message>
        <message>
            <location filename="../../workbench/design/needs.py" />
            <source>light grazes the far side of the screen, at {slant:.0f} degrees from across it, where the image is less exact; turn the screen towards the mirror, or move its middle nearer to the axis</source>
            <translation>Licht streift die ferne Seite des Schirms, {slant:.0f} Grad von der Senkrechten, wo das Bild weniger genau ist; drehen Sie den Schirm zum Spiegel, oder rücken Sie seine Mitte näher an die Achse</translation>
        </message>
        <message>
            <location filename="../../workbench/design/needs.py" />
            <source>light grazes the far side of the far field, at {slant:.0f} degrees from across it, where the image is less exact; turn the far field towards the mirror, or move its middle nearer to the axis</source>
            <translation>Licht streift die ferne Seite des Fernfelds, {slant:.0f} Grad von der Senkrechten, wo das Bild weniger genau ist; drehen Sie das Fernfeld zum Spiegel, oder rücken Sie seine Mitte näher an die Achse</translation>
        </message>
        <message>
            <location filename="../../workbench/design/needs.py" />
            <source>the picture is mirror-inverted for viewers on the side of the light, and reads right from behind the screen; target.viewed_from "front" turns it around</source>
            <translation>das Bild ist für Betrachter auf der Lichtseite spiegelverkehrt und von hinter dem Schirm richtig zu lesen; target.viewed_from "front" dreht es um</translation>
        </message>
        <message>
            <location filename="../../workbench/design/needs.py" />
            <source>the picture is mirror-inverted for viewers on the side of the light, and reads right from behind the far field; target.viewed_from "front" turns it around</source>
            <translation>das Bild ist für Betrachter auf der Lichtseite spiegelverkehrt und von hinter dem Fernfeld richtig zu lesen; target.viewed_from "front" dreht es um</translation>
        </message>
        <message>
            <location filename="../../workbench/design/needs.py" />
            <source>none of its light goes to the lens; turn or move it</source>
            <translation>kein Licht von ihr trifft die Linse; drehen oder verschieben Sie sie</translation>
        </message>
        <message>
            <location filename="../../workbench/design/needs.py" />
            <source>none of its light goes to the mirror; turn or move it</source>
            <translation>kein Licht von ihr trifft den Spiegel; drehen oder verschieben Sie sie</translation>
        </message>
        <message>
            <location filename="../../workbench/design/needs.py" />
            <source>{net} are not the control points of the finished lens that are locked; leave the stage's net out or unlock them</source>
            <translation>{net} sind nicht die Kontrollpunkte der fertigen Linse, die gesperrt sind; lassen Sie das Netz der Stufe weg, oder entsperren Sie diese</translation>
        </message>
        <message>
            <location filename="../../workbench/design/needs.py" />
            <source>{net} are not the control points of the finished mirror that are locked; leave the stage's net out or unlock them</source>
            <translation>{net} sind nicht die Kontrollpunkte des fertigen Spiegels, die gesperrt sind; lassen Sie das Netz der Stufe weg, oder entsperren Sie diese</translation>
        </message>
        <message>
            <location filename="../../workbench/design/origin.py" />
            <source>absent</source>
            <translation>fehlt</translation>
        </message>
        <message>
            <location filename="../../workbench/design/origin.py" />
            <source>not designed yet</source>
            <translation>noch nicht entworfen</translation>
        </message>
        <message>
            <location filename="../../workbench/design/origin.py" />
            <source>designed for this task</source>
            <translation>für diese Aufgabe entworfen</translation>
        </message>
        <message>
            <location filename="../../workbench/design/origin.py" />
            <source>designed for another task ({run}): {differences}</source>
            <translation>für eine andere Aufgabe entworfen ({run}): {differences}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/origin.py" />
            <source>not designed for this task</source>
            <translation>nicht für diese Aufgabe entworfen</translation>
        </message>
        <message>
            <location filename="../../workbench/design/origin.py" />
            <source>{path} {then}, now {now}</source>
            <translation>{path} {then}, jetzt {now}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/origin.py" />
            <source>another target image</source>
            <translation>ein anderes Zielbild</translation>
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
            <location filename="../../workbench/design/parametrisation.py" />
            <source>'{name}' has {count:,} parameters here and needs {needed} for them, their gradient and Adam's moments; {available} are free</source>
            <translation>'{name}' hat hier {count:,} Parameter und braucht {needed} für sie, ihren Gradienten und die Momente von Adam; {available} sind frei</translation>
        </message>
        <message>
            <location filename="../../workbench/design/room.py" />
            <source>heights within {most:.3g} {unit} of the base</source>
            <translation>Höhen bis {most:.3g} {unit} von der Grundform</translation>
        </message>
        <message>
            <location filename="../../workbench/design/run.py" />
            <source>the graphics card has too little free memory; compute on the processor, or take fewer pixels</source>
            <translation>die Grafikkarte hat zu wenig freien Speicher; rechnen Sie auf dem Prozessor, oder nehmen Sie weniger Pixel</translation>
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
            <location filename="../../workbench/design/shortfall.py" />
            <source>widen the height range, or leave it out</source>
            <translation>den Höhenbereich erweitern oder weglassen</translation>
        </message>
        <message>
            <location filename="../../workbench/design/shortfall.py" />
            <source>thicker stock, or a smaller minimal thickness, lets the lens bend more</source>
            <translation>mit einem dickeren Rohteil oder einer kleineren Mindestdicke kann die Linse stärker ablenken</translation>
        </message>
        <message>
            <location filename="../../workbench/design/shortfall.py" />
            <source>a higher base or a smaller minimal thickness gives it room</source>
            <translation>eine höhere Basis oder eine kleinere Mindestdicke schafft Platz</translation>
        </message>
        <message>
            <location filename="../../workbench/design/shortfall.py" />
            <source>move the screen away from the lens</source>
            <translation>den Schirm von der Linse wegrücken</translation>
        </message>
        <message>
            <location filename="../../workbench/design/shortfall.py" />
            <source>widen the entrance range</source>
            <translation>den Eintrittsbereich erweitern</translation>
        </message>
        <message>
            <location filename="../../workbench/design/shortfall.py" />
            <source>The entrance face fills {part:.0f} % of its automatic range of {range} {unit}</source>
            <translation>Die Eintrittsfläche füllt {part:.0f} % ihres automatischen Bereichs von {range} {unit}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/shortfall.py" />
            <source>The entrance face fills {part:.0f} % of its range of {range} {unit}, and would bend more of the light in a wider one</source>
            <translation>Die Eintrittsfläche füllt {part:.0f} % ihres Bereichs von {range} {unit} und würde in einem weiteren mehr vom Licht ablenken</translation>
        </message>
        <message>
            <location filename="../../workbench/design/shortfall.py" />
            <source>{part:.0f} % of the control heights are at the minimal thickness of {thinnest:.3g} {unit}</source>
            <translation>{part:.0f} % der Kontrollhöhen liegen an der Mindestdicke von {thinnest:.3g} {unit}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/shortfall.py" />
            <source>{range} {unit} is the automatic limit</source>
            <translation>{range} {unit} ist die automatische Grenze</translation>
        </message>
        <message>
            <location filename="../../workbench/design/shortfall.py" />
            <source>{range} {unit} is allowed</source>
            <translation>erlaubt sind {range} {unit}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/shortfall.py" />
            <source>{part:.0f} % of the control heights are at an end of their range; {allowed}</source>
            <translation>{part:.0f} % der Kontrollhöhen liegen an einem Ende ihres Bereichs; {allowed}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/shortfall.py" />
            <source>The lens needs {range} {unit}; {allowed}</source>
            <translation>Die Linse braucht {range} {unit}; {allowed}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/shortfall.py" />
            <source>The mirror needs {range} {unit}; {allowed}</source>
            <translation>Der Spiegel braucht {range} {unit}; {allowed}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/shortfall.py" />
            <source>{thickest:.3g} {unit} is the automatic limit</source>
            <translation>{thickest:.3g} {unit} ist die automatische Grenze</translation>
        </message>
        <message>
            <location filename="../../workbench/design/shortfall.py" />
            <source>the screen leaves room for {thickest:.3g} {unit}</source>
            <translation>der Schirm lässt Platz für {thickest:.3g} {unit}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/shortfall.py" />
            <source>the stock allows {thickest:.3g} {unit}</source>
            <translation>das Rohteil erlaubt {thickest:.3g} {unit}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/shortfall.py" />
            <source>{part:.0f} % of the control heights are at the largest thickness; {allowed}</source>
            <translation>{part:.0f} % der Kontrollhöhen liegen an der größten Dicke; {allowed}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/shortfall.py" />
            <source>The lens needs to be {needed:.3g} {unit} thick; {allowed}</source>
            <translation>Die Linse müsste {needed:.3g} {unit} dick sein; {allowed}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/shortfall.py" />
            <source>The mirror needs to be {needed:.3g} {unit} thick; {allowed}</source>
            <translation>Der Spiegel müsste {needed:.3g} {unit} dick sein; {allowed}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/shortfall.py" />
            <source>{sentence}: {cure}</source>
            <translation>{sentence}: {cure}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/shortfall.py" />
            <source>{field}: {said}</source>
            <translation>{field}: {said}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/shortfall.py" />
            <source>set {field} to a larger thickness</source>
            <translation>{field} auf eine größere Dicke setzen</translation>
        </message>
        <message>
            <location filename="../../workbench/design/shortfall.py" />
            <source>set {field} to a wider range</source>
            <translation>{field} auf einen weiteren Bereich setzen</translation>
        </message>
        <message>
            <location filename="../../workbench/design/shortfall.py" />
            <source>±{high:.3g}</source>
            <translation>±{high:.3g}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/shortfall.py" />
            <source>{low:.3g} to {high:.3g}</source>
            <translation>{low:.3g} bis {high:.3g}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/transport/first.py" />
            <source>both faces</source>
            <translation>beide Flächen</translation>
        </message>
        <message>
            <location filename="../../workbench/design/transport/first.py" />
            <source>the exit face alone</source>
            <translation>die Austrittsfläche allein</translation>
        </message>
        <message>
            <location filename="../../workbench/design/transport/first.py" />
            <source>both faces along lines through all images</source>
            <translation>beide Flächen entlang von Linien durch alle Bilder</translation>
        </message>
        <message>
            <location filename="../../workbench/design/transport/first.py" />
            <source>the entrance face for image {number} alone</source>
            <translation>die Eintrittsfläche allein für Bild {number}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/transport/first.py" />
            <source>the exit face for image {number} alone</source>
            <translation>die Austrittsfläche allein für Bild {number}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/transport/first.py" />
            <source>{error} % by {face}</source>
            <translation>{error} % für {face}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/transport/first.py" />
            <source>first lens: {tried}; it begins with {best}</source>
            <translation>erste Linse: {tried}; genommen: {best}</translation>
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
            <location filename="../../workbench/files/export/far_light.py" />
            <source>no light leaves its {body}, so that it has no intensity</source>
            <translation>kein Licht verlässt den {body}, also gibt es keine Lichtstärke</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/formats.py" />
            <source>has no ending that tells a format; one of {endings}</source>
            <translation>hat keine Endung, die ein Format nennt; eine von {endings}</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/gcode.py" />
            <source>a ball cutter of {radius} does not fit: it leaves {left} at x = {x}, y = {y} and cuts off {cut}; {cure}</source>
            <translation>ein Kugelfräser von {radius} passt nicht: er lässt bei x = {x}, y = {y} {left} stehen und nimmt {cut} zu viel weg; {cure}</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/gcode.py" />
            <source>one of {fitting} fits</source>
            <translation>einer von {fitting} passt</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/gcode.py" />
            <source>a smaller one or higher ridges are needed</source>
            <translation>ein kleinerer oder höhere Rillen werden gebraucht</translation>
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
            <source>{value:g}; a length above 0</source>
            <translation>{value:g}; eine Länge über 0</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/options.py" />
            <source>{value:g}; a length of 0 or more</source>
            <translation>{value:g}; eine Länge von 0 oder mehr</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/options.py" />
            <source>{value:g} {unit}; from {least:g} to {most:,} {unit}</source>
            <translation>{value:g} {unit}; von {least:g} bis {most:,} {unit}</translation>
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
            <location filename="../../workbench/files/export/write.py" />
            <source>the {face} face is flat, so it has no file</source>
            <translation>die Fläche „{face}“ ist eben, also hat sie keine Datei</translation>
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
            <location filename="../../workbench/files/json_text.py" />
            <source>is given twice; each field can be there once</source>
            <translation>ist doppelt angegeben; jedes Feld kann einmal da sein</translation>
        </message>
        <message>
            <location filename="../../workbench/files/npy.py" />
            <source>holds a value that is NaN or infinite; finite values are needed</source>
            <translation>enthält einen Wert, der NaN oder unendlich ist; endliche Werte sind nötig</translation>
        </message>
        <message>
            <location filename="../../workbench/files/npy.py" />
            <source>holds a value that is neither 0 nor 1; false or true is needed</source>
            <translation>enthält einen Wert, der weder 0 noch 1 ist; falsch oder wahr ist nötig</translation>
        </message>
        <message>
            <location filename="../../workbench/files/npy.py" />
            <source>holds {dtype}; {kind} is needed</source>
            <translation>enthält {dtype}; {kind} ist nötig</translation>
        </message>
        <message>
            <location filename="../../workbench/files/npy.py" />
            <source>has shape {found}; the scene needs {shape}</source>
            <translation>hat die Form {found}; die Szene braucht {shape}</translation>
        </message>
        <message>
            <location filename="../../workbench/files/npy.py" />
            <source>is in Fortran order; C order is needed</source>
            <translation>ist in Fortran-Reihenfolge; C-Reihenfolge ist nötig</translation>
        </message>
        <message>
            <location filename="../../workbench/files/npy.py" />
            <source>has {given} bytes of values; shape {shape} needs {size}</source>
            <translation>hat {given} Bytes an Werten; die Form {shape} braucht {size}</translation>
        </message>
        <message>
            <location filename="../../workbench/files/npy.py" />
            <source>is no .npy array: its header cannot be read</source>
            <translation>ist kein .npy-Array: der Kopf lässt sich nicht lesen</translation>
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
            <source>By a coarse design of this task.</source>
            <translation>Nach einem groben Entwurf dieser Aufgabe.</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>No light arrives in a coarse design of this task.</source>
            <translation>In einem groben Entwurf dieser Aufgabe kommt kein Licht an.</translation>
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
            <source>By a coarse design of this task, with all losses of light and the size of the source.</source>
            <translation>Nach einem groben Entwurf dieser Aufgabe, mit allen Lichtverlusten und der Größe der Quelle.</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>Blur of the light</source>
            <translation>Unschärfe des Lichts</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>The light comes from one point or direction.</source>
            <translation>Das Licht kommt von einem Punkt oder aus einer Richtung.</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>{count:.0f} details fit side by side into the image.</source>
            <translation>{count:.0f} Einzelheiten passen nebeneinander in das Bild.</translation>
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
            <source>{law}: finer details cannot be sharp, and no ray tracer shows that.</source>
            <translation>{law}: feinere Einzelheiten können nicht scharf sein, und keine Strahlrechnung zeigt das.</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>Largest slope</source>
            <translation>Größte Neigung</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>{slope:.0f}°, light turns by up to {turn:.0f}°</source>
            <translation>{slope:.0f}°, Ablenkung bis {turn:.0f}°</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>light would have to turn by {turn:.0f}°</source>
            <translation>das Licht müsste um {turn:.0f}° abgelenkt werden</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>The lens turns it by {most:.0f}° at most: a smaller image, more distance or another place of the light helps.</source>
            <translation>Die Linse lenkt es um höchstens {most:.0f}° ab: ein kleineres Bild, mehr Abstand oder ein anderer Ort des Lichts hilft.</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>The mirror turns it by {most:.0f}° at most: a smaller image, more distance or another place of the light helps.</source>
            <translation>Der Spiegel lenkt es um höchstens {most:.0f}° ab: ein kleineres Bild, mehr Abstand oder ein anderer Ort des Lichts hilft.</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>{most:.0f}° is the most; so near to it much light is reflected.</source>
            <translation>{most:.0f}° ist das Höchste; so nahe daran wird viel Licht reflektiert.</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>Up to {most:.0f}° would be possible.</source>
            <translation>Bis {most:.0f}° wäre möglich.</translation>
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
            <source>Rays of a file need not come evenly from one place.</source>
            <translation>Strahlen einer Datei müssen nicht gleichmäßig von einem Ort kommen.</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>A lamp so near is blurred less by the rim of the lens than by its middle.</source>
            <translation>Eine so nahe Lampe wird vom Rand der Linse weniger verwischt als von ihrer Mitte.</translation>
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
            <source>All of it can be changed in the window.</source>
            <translation>Alles davon lässt sich im Fenster ändern.</translation>
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
            <location filename="../../workbench/measured/photometry/__init__.py" />
            <source>is no photometric file; {endings} is needed</source>
            <translation>ist keine photometrische Datei; {endings} ist nötig</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/photometry/__init__.py" />
            <source>has more than {most} MB, too many for such a file</source>
            <translation>hat mehr als {most} MB, zu viel für eine solche Datei</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/photometry/__init__.py" />
            <source>cannot be used: {problem}</source>
            <translation>lässt sich nicht verwenden: {problem}</translation>
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
            <source>it says to be of version {found!r}; known are {known}</source>
            <translation>sie nennt als Version {found!r}; bekannt sind {known}</translation>
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
            <source>it is cut off</source>
            <translation>sie ist abgeschnitten</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/text.py" />
            <source>it goes on behind its end</source>
            <translation>sie geht nach ihrem Ende weiter</translation>
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
            <location filename="../../workbench/optics/choice.py" />
            <source>fused kernels, {threads} threads, {precision}</source>
            <translation>übersetzte Rechenkerne, {threads} Threads, {precision}</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/choice.py" />
            <source>fused kernels, 1 thread, {precision}</source>
            <translation>übersetzte Rechenkerne, 1 Thread, {precision}</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/choice.py" />
            <source>reference in torch on {device}, {precision}</source>
            <translation>Referenz in torch auf {device}, {precision}</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/choice.py" />
            <source>no kernel for this path ({faces}): by the reference alone</source>
            <translation>kein Rechenkern für diesen Weg ({faces}): nur durch die Referenz</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/choice.py" />
            <source>float64: float32 has too few digits for this scene</source>
            <translation>float64: float32 hat zu wenige Stellen für diese Szene</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/choice.py" />
            <source>the kernel could not be compiled ({error}), so this run is many times slower</source>
            <translation>der Rechenkern ließ sich nicht übersetzen ({error}), darum ist dieser Lauf um ein Vielfaches langsamer</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/choice.py" />
            <source>compiled kernels could not be kept ({reason}), so each start compiles them again</source>
            <translation>übersetzte Rechenkerne ließen sich nicht aufbewahren ({reason}), darum übersetzt sie jeder Start neu</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/halves.py" />
            <source>mirror symmetry: a quarter of the rays</source>
            <translation>Spiegelsymmetrie: ein Viertel der Strahlen</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/halves.py" />
            <source>mirror symmetry: half of the rays</source>
            <translation>Spiegelsymmetrie: die Hälfte der Strahlen</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/plan.py" />
            <source>box filter: one pixel a ray, no ghost pixels</source>
            <translation>Kastenfilter: ein Pixel je Strahl, keine Randpixel</translation>
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
            <location filename="../../workbench/optics/total_reflection.py" />
            <source>{part} % of the light is totally reflected at the {face}, most of it around x = {x}, y = {y}</source>
            <translation>{part} % des Lichts werden an der {face} totalreflektiert, das meiste um x = {x}, y = {y}</translation>
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
            <source>{low} to {high}</source>
            <translation>{low} bis {high}</translation>
        </message>
        <message>
            <location filename="../../workbench/report/figures.py" />
            <source>{figure}; {remark}</source>
            <translation>{figure}; {remark}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/collimated_source.py" />
            <source>{angle:g} brings light {steepest:g} degrees from the axis, which does not come to {front}; less than 90 in all</source>
            <translation>{angle:g} bringt Licht {steepest:g} Grad von der Achse, das nicht dorthin kommt ({front}); weniger als 90 insgesamt</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/collimated_source.py" />
            <source>{radius:g} is too narrow for a lens with a half-width of {half:g}; at least {least:g}</source>
            <translation>{radius:g} ist zu schmal für eine Linse mit halber Breite {half:g}; mindestens {least:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/collimated_source.py" />
            <source>{radius:g} is too narrow for a mirror with a half-width of {half:g}; at least {least:g}</source>
            <translation>{radius:g} ist zu schmal für einen Spiegel mit halber Breite {half:g}; mindestens {least:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/element.py" />
            <source>'auto' needs a target to choose for; numbers</source>
            <translation>'auto' braucht ein Ziel, um zu wählen; Zahlen</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/emission.py" />
            <source>{parts} make {across} × {up} rectangles; at most {most} in all</source>
            <translation>{parts} ergeben {across} × {up} Rechtecke; höchstens {most} insgesamt</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/faces.py" />
            <source>{count} is too few for degree {degree}; at least {least}</source>
            <translation>{count} sind zu wenige für Grad {degree}; mindestens {least}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/faces.py" />
            <source>{radius:g} does not span the lens; more than its half-diagonal {least:g}</source>
            <translation>{radius:g} überspannt die Linse nicht; mehr als ihre halbe Diagonale {least:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/faces.py" />
            <source>{radius:g} does not span the mirror; more than its half-diagonal {least:g}</source>
            <translation>{radius:g} überspannt den Spiegel nicht; mehr als seine halbe Diagonale {least:g}</translation>
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
            <location filename="../../workbench/scene/faces.py" />
            <source>[{low:g}, {high:g}] is empty; low before high</source>
            <translation>[{low:g}, {high:g}] ist leer; der kleinere Wert zuerst</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/far_field.py" />
            <source>{half:g} about {middle:g} goes beyond {most:g} degrees; at most {left:g}</source>
            <translation>{half:g} um {middle:g} reicht über {most:g} Grad hinaus; höchstens {left:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/far_field.py" />
            <source>is at no distance; a screen is needed</source>
            <translation>hat keinen Abstand; ein Schirm ist nötig</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/grid_source.py" />
            <source>{rays} from each of {points} points are too many; at most {most} rays in all</source>
            <translation>{rays} von jedem der {points} Punkte sind zu viele; höchstens {most} Strahlen insgesamt</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/lens.py" />
            <source>a front face is designed together with the back face; 'bspline', not fixed</source>
            <translation>eine Vorderfläche wird zusammen mit der Rückfläche entworfen; 'bspline', nicht fest</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/lens.py" />
            <source>{index:g}; greater than 1 is needed</source>
            <translation>{index:g}; mehr als 1 ist nötig</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/lens.py" />
            <source>{height:g} leaves no room above the minimal thickness; more than {least:g}</source>
            <translation>{height:g} lässt keinen Raum über der kleinsten Dicke; mehr als {least:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/lens.py" />
            <source>{height:g} leaves no room below the maximal thickness; less than {most:g}</source>
            <translation>{height:g} lässt keinen Raum unter der größten Dicke; weniger als {most:g}</translation>
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
            <source>{length:g} is too long beside a half-width of {half:g}; at most {most:g}</source>
            <translation>{length:g} ist zu lang neben einer halben Breite von {half:g}; höchstens {most:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/losses.py" />
            <source>a flatter base, </source>
            <translation>eine flachere Basis, </translation>
        </message>
        <message>
            <location filename="../../workbench/scene/measured_source.py" />
            <source>'{file}' is none of these: {endings}</source>
            <translation>'{file}' ist keines von diesen: {endings}</translation>
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
            <source>{z:g} is not before {front}; less than {most:g}</source>
            <translation>{z:g} liegt nicht davor ({front}); weniger als {most:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/points.py" />
            <source>{way:g} before {front} is too near for a lens with a half-width of {size:g}; at least {least:g}</source>
            <translation>{way:g} davor ({front}) ist zu nah für eine Linse mit halber Breite {size:g}; mindestens {least:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/points.py" />
            <source>{way:g} before {front} is too near for a mirror with a half-width of {size:g}; at least {least:g}</source>
            <translation>{way:g} davor ({front}) ist zu nah für einen Spiegel mit halber Breite {size:g}; mindestens {least:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/points.py" />
            <source>{way:g} before {front} is too far for a lens with a half-width of {size:g}; at most {most:g}, or collimated light</source>
            <translation>{way:g} davor ({front}) ist zu fern für eine Linse mit halber Breite {size:g}; höchstens {most:g}, oder kollimiertes Licht</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/points.py" />
            <source>{way:g} before {front} is too far for a mirror with a half-width of {size:g}; at most {most:g}, or collimated light</source>
            <translation>{way:g} davor ({front}) ist zu fern für einen Spiegel mit halber Breite {size:g}; höchstens {most:g}, oder kollimiertes Licht</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/region.py" />
            <source>{size:g} about {middle:g} ends beyond the receiver; at most {most:g} there</source>
            <translation>{size:g} um {middle:g} endet jenseits des Empfängers; dort höchstens {most:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/region.py" />
            <source>have no area between them; a polygon with some</source>
            <translation>umschließen keine Fläche; ein Polygon mit Fläche</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/region.py" />
            <source>make sides that cross; in their order around the polygon</source>
            <translation>ergeben Seiten, die sich kreuzen; in ihrer Reihenfolge um das Polygon</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/region.py" />
            <source>{count} are given; at most {most}</source>
            <translation>{count} sind angegeben; höchstens {most}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/screen.py" />
            <source>{tilt} turns the back of the screen to light of the lens; its front has to face all of the lens</source>
            <translation>{tilt} wendet dem Licht der Linse die Rückseite des Schirms zu; seine Vorderseite muss der ganzen Linse zugewandt sein</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/screen.py" />
            <source>{tilt} turns the back of the screen to light of the mirror; its front has to face all of the mirror</source>
            <translation>{tilt} wendet dem Licht des Spiegels die Rückseite des Schirms zu; seine Vorderseite muss dem ganzen Spiegel zugewandt sein</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/screen.py" />
            <source>{z:g} may touch the lens; more than {least:g}, the highest that the exit face can become</source>
            <translation>{z:g} kann die Linse berühren; mehr als {least:g}, der höchste Wert, den die Austrittsfläche erreichen kann</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/screen.py" />
            <source>{z:g} puts its lowest edge at z = {nearest:g}, which may touch the lens; more than {least:g}, the highest that the exit face can become and the tilt adds</source>
            <translation>{z:g} legt seine unterste Kante auf z = {nearest:g}, was die Linse berühren kann; mehr als {least:g}, der höchste Wert, den die Austrittsfläche erreichen kann, und was die Neigung hinzufügt</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/screen.py" />
            <source>{z:g} may touch the lens, or be behind it; less than {most:g}, the lowest that it can become</source>
            <translation>{z:g} kann die Linse berühren oder hinter ihr liegen; weniger als {most:g}, der tiefste Wert, den sie erreichen kann</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/screen.py" />
            <source>{z:g} may touch the mirror, or be behind it; less than {most:g}, the lowest that it can become</source>
            <translation>{z:g} kann den Spiegel berühren oder hinter ihm liegen; weniger als {most:g}, der tiefste Wert, den er erreichen kann</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/stages.py" />
            <source>they leave none of the {count} iterations for the scene itself; more than {least} in all are needed</source>
            <translation>sie lassen keine der {count} Iterationen für die Szene selbst; mehr als {least} insgesamt sind nötig</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/stages.py" />
            <source>unknown field; the automatic method has none</source>
            <translation>unbekanntes Feld; die automatische Methode hat keines</translation>
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
            <location filename="../../workbench/scene/task.py" />
            <source>{value:g} is about curvature, and faces of degree 1 are flat between edges; {field} of at least 2</source>
            <translation>{value:g} betrifft die Krümmung, und Flächen vom Grad 1 sind zwischen Kanten eben; {field} von mindestens 2</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/task.py" />
            <source>'{name}' is the name of another element; another name</source>
            <translation>'{name}' ist der Name eines anderen Elements; ein anderer Name</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/task.py" />
            <source>no face is designed; one face of shape 'bspline'</source>
            <translation>keine Fläche wird entworfen; eine Fläche der Form 'bspline'</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/task.py" />
            <source>a second designed element; one element is designed</source>
            <translation>ein zweites entworfenes Element; entworfen wird ein einziges Element</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/task.py" />
            <source>fixed B-spline faces are not traced yet; a conic face</source>
            <translation>feste B-Spline-Flächen werden noch nicht durchgerechnet; eine Kegelschnittfläche</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/task.py" />
            <source>a mirror that is not designed is not traced yet</source>
            <translation>ein Spiegel, der nicht entworfen wird, wird noch nicht durchgerechnet</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/task.py" />
            <source>elements behind a mirror are not traced yet; none</source>
            <translation>Elemente hinter einem Spiegel werden noch nicht durchgerechnet; keines</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/task.py" />
            <source>the first and the designed element stand upright on the axis; 0</source>
            <translation>das erste und das entworfene Element stehen aufrecht auf der Achse; 0</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/task.py" />
            <source>{z:g} reaches into {name}; at least {least:g}</source>
            <translation>{z:g} ragt in {name} hinein; mindestens {least:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/task.py" />
            <source>{count} given, which {who} cannot take into account; one</source>
            <translation>{count} angegeben, nicht zu berücksichtigen durch: {who}; eines</translation>
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
            <location filename="../../workbench/scene/viewing.py" />
            <source>viewed from the side of the light</source>
            <translation>von der Lichtseite betrachtet</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/viewing.py" />
            <source>viewed from behind the screen</source>
            <translation>von hinter dem Schirm betrachtet</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/viewing.py" />
            <source>viewed from behind the far field</source>
            <translation>von hinter dem Fernfeld betrachtet</translation>
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
