<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
    <context>
        <name>workbench</name>
        <message>
            <location filename="../../ui/commands/menus.py" />
            <source>&amp;File</source>
            <translation>&amp;Fichier</translation>
        </message>
        <message>
            <location filename="../../ui/commands/menus.py" />
            <source>&amp;New from example</source>
            <translation>Nouveau &amp;d'après un exemple</translation>
        </message>
        <message>
            <location filename="../../ui/commands/menus.py" />
            <source>First lenses, twice as fine</source>
            <translation>Premières lentilles, deux fois plus fines</translation>
        </message>
        <message>
            <location filename="../../ui/commands/menus.py" />
            <source>Top hat: networks and starts</source>
            <translation>Disque uniforme : réseaux et points de départ</translation>
        </message>
        <message>
            <location filename="../../ui/commands/menus.py" />
            <source>Real lights</source>
            <translation>Sources réelles</translation>
        </message>
        <message>
            <location filename="../../ui/commands/menus.py" />
            <source>Flame and ball: magnifications</source>
            <translation>Flamme et ballon : grandissements</translation>
        </message>
        <message>
            <location filename="../../ui/commands/menus.py" />
            <source>Flame: point and extended source</source>
            <translation>Flamme : source ponctuelle et étendue</translation>
        </message>
        <message>
            <location filename="../../ui/commands/menus.py" />
            <source>Walls and streets</source>
            <translation>Murs et rues</translation>
        </message>
        <message>
            <location filename="../../ui/commands/menus.py" />
            <source>Two freeform faces</source>
            <translation>Deux faces de forme libre</translation>
        </message>
        <message>
            <location filename="../../ui/commands/menus.py" />
            <source>Derivative maps of a flat lens</source>
            <translation>Cartes de dérivées d'une lentille plane</translation>
        </message>
        <message>
            <location filename="../../ui/commands/menus.py" />
            <source>Open &amp;recent</source>
            <translation>Fichiers &amp;récents</translation>
        </message>
        <message>
            <location filename="../../ui/commands/menus.py" />
            <source>&amp;Edit</source>
            <translation>É&amp;dition</translation>
        </message>
        <message>
            <location filename="../../ui/commands/menus.py" />
            <source>&amp;Design</source>
            <translation>&amp;Conception</translation>
        </message>
        <message>
            <location filename="../../ui/commands/menus.py" />
            <source>&amp;Run</source>
            <translation>&amp;Exécution</translation>
        </message>
        <message>
            <location filename="../../ui/commands/menus.py" />
            <source>&amp;View</source>
            <translation>&amp;Affichage</translation>
        </message>
        <message>
            <location filename="../../ui/commands/menus.py" />
            <source>&amp;Rays</source>
            <translation>Ra&amp;yons</translation>
        </message>
        <message>
            <location filename="../../ui/commands/menus.py" />
            <source>F&amp;aces</source>
            <translation>F&amp;aces</translation>
        </message>
        <message>
            <location filename="../../ui/commands/menus.py" />
            <source>Save pict&amp;ure of 3D</source>
            <translation>&amp;Enregistrer l'image 3D</translation>
        </message>
        <message>
            <location filename="../../ui/commands/menus.py" />
            <source>&amp;Colours of light</source>
            <translation>Couleurs de la l&amp;umière</translation>
        </message>
        <message>
            <location filename="../../ui/commands/menus.py" />
            <source>Th&amp;eme</source>
            <translation>&amp;Thème</translation>
        </message>
        <message>
            <location filename="../../ui/commands/menus.py" />
            <source>La&amp;nguage</source>
            <translation>Lan&amp;gue</translation>
        </message>
        <message>
            <location filename="../../ui/commands/menus.py" />
            <source>&amp;Go to</source>
            <translation>Aller &amp;à</translation>
        </message>
        <message>
            <location filename="../../ui/commands/menus.py" />
            <source>&amp;Help</source>
            <translation>A&amp;ide</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Top hat</source>
            <translation>Disque uniforme</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>A uniform disc of light; see how soon its edge is sharp.</source>
            <translation>Un disque de lumière uniforme ; on voit son bord devenir vite net.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Flame</source>
            <translation>Flamme</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>A flame-like logo on black; see light leave what shall be dark.</source>
            <translation>Un logo en forme de flamme sur fond noir ; on voit la lumière quitter ce qui doit rester sombre.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Ball</source>
            <translation>Ballon</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>A faceted ball; see whether each grey comes out evenly bright.</source>
            <translation>Un ballon à facettes ; on voit si chaque gris devient uniforme.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Photograph</source>
            <translation>Photographie</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Every grey from black to white; see texture and shadow come.</source>
            <translation>Tous les gris du noir au blanc ; on voit venir la texture et les ombres.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Letter</source>
            <translation>Lettre</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>A bold letter on black; see its straight edges and corners.</source>
            <translation>Une lettre grasse sur fond noir ; à observer : ses bords droits et ses coins.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Flame, 512 × 512</source>
            <translation>Flamme, 512 × 512</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>The flame with four times the detail; see its thin parts.</source>
            <translation>La flamme avec quatre fois plus de détails ; à observer : ses parties fines.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Ball, 512 × 512</source>
            <translation>Ballon, 512 × 512</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>The ball with four times the detail; see the facets' edges.</source>
            <translation>Le ballon avec quatre fois plus de détails ; à observer : les arêtes des facettes.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>No network, flat start</source>
            <translation>Sans réseau, départ plan</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>The yardstick for the three networks: a smooth lens that keeps the target's symmetry.</source>
            <translation>La référence des trois réseaux : une lentille lisse qui garde la symétrie de la cible.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Sparse network, faint start</source>
            <translation>Réseau creux, départ faible</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Weights a ten-thousandth off zero; compare speed and symmetry with no network.</source>
            <translation>Poids à un dix-millième de zéro ; comparer vitesse et symétrie au cas sans réseau.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Sparse network, random start</source>
            <translation>Réseau creux, départ aléatoire</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>A rough first lens; see how much of its roughness is left in the end.</source>
            <translation>Une première lentille rugueuse ; on voit ce qu'il en reste à la fin.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Dense network, faint start</source>
            <translation>Réseau dense, départ faible</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Two million weights for a thousand heights; compare loss and time with the sparse one.</source>
            <translation>Deux millions de poids pour mille hauteurs ; comparer coût et durée au réseau creux.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Sun plate</source>
            <translation>Plaque solaire</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Acrylic to hold into the sun, whose disc blurs by 4.7 mm: compare error and bound.</source>
            <translation>De l'acrylique à tenir au soleil, dont le disque rend flou de 4.7 mm : comparer erreur et borne.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Phone torch</source>
            <translation>Lampe de téléphone</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>The LED of a telephone, close to the lens, blurs the letter's edges: see the bound.</source>
            <translation>La LED d'un téléphone, près de la lentille, rend les bords flous : voir la borne.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>LED to a rectangle</source>
            <translation>LED vers un rectangle</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Light as wide as can be bent; see what is totally reflected, and how even the rest is.</source>
            <translation>La lumière aussi large que possible ; à observer : la réflexion totale et l'uniformité du reste.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Beam shaper</source>
            <translation>Mise en forme de faisceau</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>A Gaussian laser beam becomes an even disc; see that hardly any light is lost.</source>
            <translation>Un faisceau laser gaussien devient un disque uniforme ; presque rien n'est perdu.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Measured LED</source>
            <translation>LED mesurée</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>A file of 9,000 rays lights the lens; see how their grain shows in the check.</source>
            <translation>Un fichier de 9 000 rayons éclaire la lentille ; leur grain se voit à la vérification.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Flame, magnification 1</source>
            <translation>Flamme, grandissement 1</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>A screen as large as the lens, far away: a few hundredths of height do it all.</source>
            <translation>Un écran de la taille de la lentille, au loin : quelques centièmes de hauteur suffisent.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Flame, magnification 3</source>
            <translation>Flamme, grandissement 3</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>The concave base just fills the screen; see the corners, where rays are steep.</source>
            <translation>La base concave remplit juste l'écran ; à observer : les coins, où les rayons sont inclinés.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Flame, magnification 5</source>
            <translation>Flamme, grandissement 5</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Steeper still: compare the loss, and the light beside the screen, with 1 and 3.</source>
            <translation>Plus incliné encore : comparer le coût et la lumière hors de l'écran à 1 et 3.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Ball, magnification 1</source>
            <translation>Ballon, grandissement 1</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Ball, magnification 3</source>
            <translation>Ballon, grandissement 3</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Ball, magnification 5</source>
            <translation>Ballon, grandissement 5</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Point source</source>
            <translation>Source ponctuelle</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Light from one point; see in the light account how much of the cone passes the square lens by.</source>
            <translation>La lumière d'un point ; le bilan montre la part du cône qui manque la lentille carrée.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Extended source of 25 × 25 points</source>
            <translation>Source étendue de 25 × 25 points</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>The flame is put together from images of the square source: details smaller than these stay blurred.</source>
            <translation>La flamme se compose d'images de la source carrée : les détails plus petits restent flous.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Point source, then the extended one</source>
            <translation>Source ponctuelle, puis étendue</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>The loss jumps when the extended source takes over at iteration 200; see what is won back.</source>
            <translation>Le coût saute quand la source étendue prend le relais à l'itération 200 ; on voit ce qui est regagné.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Wall washer</source>
            <translation>Lèche-mur</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>A picture on a wall that leans away from the lamp; see that it comes out straight.</source>
            <translation>Une image sur un mur incliné par rapport à la lampe ; elle apparaît droite.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Street light</source>
            <translation>Éclairage de rue</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>An LED's IES file; see intensity rise to both ends, so that the road below is even.</source>
            <translation>Le fichier IES d'une LED ; l'intensité croît vers les deux bouts pour une route uniforme.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Mirror: letter on a wall</source>
            <translation>Miroir : lettre sur un mur</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Sunlight from below, thrown back to a wall beside it; see the mirror lean towards it.</source>
            <translation>Le soleil d'en bas, renvoyé vers un mur voisin ; le miroir s'incline vers lui.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Mirror: photograph beside the lamp</source>
            <translation>Miroir : photographie à côté de la lampe</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Light from one point, drawn on a screen beside that point; see what misses the mirror.</source>
            <translation>La lumière d'un point, dessinée sur un écran voisin ; à observer : ce qui manque le miroir.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Photograph from a thin plate</source>
            <translation>Photographie par une plaque mince</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Both faces bend the light; compare their slopes with those of one face alone.</source>
            <translation>Les deux faces dévient la lumière ; comparer leurs pentes à celles d'une seule face.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Wide angle: disc from a near point</source>
            <translation>Grand angle : disque d'un point proche</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Light comes in at up to 60°; see how little of what is in the glass leaves by the side.</source>
            <translation>La lumière arrive jusqu'à 60° ; très peu quitte le verre par le côté.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>LED close by: square through a dome</source>
            <translation>LED proche : carré par un dôme</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>The entrance face comes towards the LED in its middle; compare with a flat one.</source>
            <translation>La face d'entrée s'avance vers la LED ; comparer à une face plane.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Photograph at two distances</source>
            <translation>Photographie à deux distances</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Thick glass moves the light, its exit face makes it parallel; compare both images.</source>
            <translation>Le verre épais déplace la lumière, la face de sortie la rend parallèle ; comparer les deux images.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Degrees (3, 3), filter 3 × 3</source>
            <translation>Degrés (3, 3), filtre 3 × 3</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>As a control point rises it gathers light: a mountain in a valley, sum zero.</source>
            <translation>Un point de contrôle qui monte rassemble la lumière : un mont dans une vallée, somme nulle.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Degrees (3, 3), filter 11 × 11</source>
            <translation>Degrés (3, 3), filtre 11 × 11</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>The same mountain, smoother: each ray's light is spread over 11 × 11 pixels.</source>
            <translation>Le même mont, plus lisse : la lumière de chaque rayon s'étale sur 11 × 11 pixels.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Degrees (5, 3), filter 3 × 3</source>
            <translation>Degrés (5, 3), filtre 3 × 3</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Wider along x: the valley meets the screen's border, and the sum leaves zero.</source>
            <translation>Plus large selon x : la vallée atteint le bord de l'écran, et la somme n'est plus nulle.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;New…</source>
            <translation>&amp;Nouveau…</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Begin a design: choose a job and answer its questions</source>
            <translation>Commencer une conception : choisir une tâche et répondre à ses questions</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>New from &amp;gallery…</source>
            <translation>Nouveau depuis la &amp;galerie…</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Choose an example by the picture of its light</source>
            <translation>Choisir un exemple d'après l'image de sa lumière</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>New &amp;window</source>
            <translation>Nouvelle &amp;fenêtre</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Open another window, with a design and a run of its own</source>
            <translation>Ouvrir une autre fenêtre, avec sa propre conception et sa propre exécution</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Open…</source>
            <translation>&amp;Ouvrir…</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Open a design, or a scene file</source>
            <translation>Ouvrir une conception ou un fichier de scène</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Save</source>
            <translation>&amp;Enregistrer</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Save scene, target and lens</source>
            <translation>Enregistrer scène, cible et lentille</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Save scene, target and mirror</source>
            <translation>Enregistrer scène, cible et miroir</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Save &amp;as…</source>
            <translation>Enregistrer &amp;sous…</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Save under another name</source>
            <translation>Enregistrer sous un autre nom</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Export…</source>
            <translation>E&amp;xporter…</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Write the lens or its light for other programs</source>
            <translation>Écrire la lentille ou sa lumière pour d'autres programmes</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Write the mirror or its light for other programs</source>
            <translation>Écrire le miroir ou sa lumière pour d'autres programmes</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Cu&amp;t with a ball cutter…</source>
            <translation>Usiner à la fraise &amp;hémisphérique…</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Write a finishing pass as G-code; what the cut leaves of the image is found before</source>
            <translation>Écrire une passe de finition en G-code ; ce que l'usinage laisse de l'image est calculé avant</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Report…</source>
            <translation>Ra&amp;pport…</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Write scene, pictures, check and figures on some pages (HTML, PDF)</source>
            <translation>Écrire scène, images, vérification et chiffres sur quelques pages (HTML, PDF)</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Save &amp;predicted photo…</source>
            <translation>Enregistrer la photo préd&amp;ite…</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Save the predicted photo of the screen: what a camera would see, in colour (PNG)</source>
            <translation>Enregistrer la photo prédite de l'écran : ce que verrait un appareil, en couleur (PNG)</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Close window</source>
            <translation>Fer&amp;mer la fenêtre</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Close this window; others stay open</source>
            <translation>Fermer cette fenêtre ; les autres restent ouvertes</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Quit</source>
            <translation>&amp;Quitter</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Close all windows of the workbench</source>
            <translation>Fermer toutes les fenêtres du programme</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Re&amp;vert</source>
            <translation>Ré&amp;tablir le fichier</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Go back to the file as it was saved; this can be undone</source>
            <translation>Revenir au fichier enregistré ; peut être annulé</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Undo</source>
            <translation>A&amp;nnuler</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Take the last change back</source>
            <translation>Annuler la dernière modification</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Redo</source>
            <translation>&amp;Rétablir</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Make the change again</source>
            <translation>Refaire la modification</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Paste picture</source>
            <translation>&amp;Coller une image</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Make the picture on the clipboard the target</source>
            <translation>Prendre l'image du presse-papiers pour cible</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Copy &amp;plot</source>
            <translation>Co&amp;pier le graphique</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Copy a picture of the plot that was clicked last, to paste it elsewhere</source>
            <translation>Copier une image du dernier graphique cliqué, pour la coller ailleurs</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Save p&amp;lot…</source>
            <translation>&amp;Enregistrer le graphique…</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Save the plot that was clicked last: as a picture (PNG, SVG) or its numbers (CSV)</source>
            <translation>Enregistrer le dernier graphique cliqué : en image (PNG, SVG) ou ses valeurs (CSV)</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Start</source>
            <translation>&amp;Démarrer</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Design the lens from nothing; one that is there gives way, and Undo brings it back</source>
            <translation>Concevoir la lentille à partir de rien ; celle qui existe cède la place, Annuler la ramène</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Design the mirror from nothing; one that is there gives way, and Undo brings it back</source>
            <translation>Concevoir le miroir à partir de rien ; celui qui existe cède la place, Annuler le ramène</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Continue</source>
            <translation>&amp;Continuer</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Go on designing from the lens as it is, with as many more iterations</source>
            <translation>Poursuivre à partir de la lentille actuelle, avec autant d'itérations de plus</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Go on designing from the mirror as it is, with as many more iterations</source>
            <translation>Poursuivre à partir du miroir actuel, avec autant d'itérations de plus</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Pause</source>
            <translation>&amp;Pause</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Hold the design; again to go on</source>
            <translation>Suspendre la conception ; de nouveau pour reprendre</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>S&amp;top</source>
            <translation>Arrê&amp;ter</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>End the design and keep its best lens</source>
            <translation>Terminer la conception et garder sa meilleure lentille</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>End the design and keep its best mirror</source>
            <translation>Terminer la conception et garder son meilleur miroir</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Follow edits</source>
            <translation>&amp;Suivre les modifications</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Design the lens anew after every edit, while no run goes on</source>
            <translation>Concevoir la lentille à nouveau après chaque modification, hors exécution</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Design the mirror anew after every edit, while no run goes on</source>
            <translation>Concevoir le miroir à nouveau après chaque modification, hors exécution</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>S&amp;weep…</source>
            <translation>Séri&amp;e…</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Design a lens for each of several values of a field, and see all in a table</source>
            <translation>Concevoir une lentille pour chacune de plusieurs valeurs d'un champ, et les voir toutes dans un tableau</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Design a mirror for each of several values of a field, and see all in a table</source>
            <translation>Concevoir un miroir pour chacune de plusieurs valeurs d'un champ, et les voir tous dans un tableau</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Restore run</source>
            <translation>&amp;Restaurer l'exécution</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Give the design task and lens of the run chosen in the dock Runs</source>
            <translation>Donner à la conception la tâche et la lentille de l'exécution choisie dans le volet Exécutions</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Give the design task and mirror of the run chosen in the dock Runs</source>
            <translation>Donner à la conception la tâche et le miroir de l'exécution choisie dans le volet Exécutions</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Compare runs</source>
            <translation>Co&amp;mparer des exécutions</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>See the two runs chosen in the dock Runs beside each other: light, figures, fields</source>
            <translation>Voir côte à côte les deux exécutions choisies dans le volet Exécutions : lumière, chiffres, champs</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Delete runs</source>
            <translation>S&amp;upprimer des exécutions</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Forget the runs chosen in the dock Runs</source>
            <translation>Oublier les exécutions choisies dans le volet Exécutions</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Check lens</source>
            <translation>Vérifier la &amp;lentille</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Check mirror</source>
            <translation>Vérifier le &amp;miroir</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Trace the lens on show anew, with rays that its design never saw; again to cancel</source>
            <translation>Tracer à nouveau la lentille affichée, avec des rayons que la conception n'a jamais vus ; de nouveau pour annuler</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Trace the mirror on show anew, with rays that its design never saw; again to cancel</source>
            <translation>Tracer à nouveau le miroir affiché, avec des rayons que la conception n'a jamais vus ; de nouveau pour annuler</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Fit 3D view</source>
            <translation>A&amp;juster la vue 3D</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Show lens and screen whole</source>
            <translation>Montrer toute la lentille et tout l'écran</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Show mirror and screen whole</source>
            <translation>Montrer tout le miroir et tout l'écran</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Look at &amp;lens</source>
            <translation>Regarder la &amp;lentille</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Look at &amp;mirror</source>
            <translation>Regarder le &amp;miroir</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>See the lens as large as it can be</source>
            <translation>Voir la lentille aussi grande que possible</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>See the mirror as large as it can be</source>
            <translation>Voir le miroir aussi grand que possible</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Look at s&amp;creen</source>
            <translation>Regarder l'é&amp;cran</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>See the screen as large as it can be</source>
            <translation>Voir l'écran aussi grand que possible</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>From the &amp;side</source>
            <translation>De côt&amp;é</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Look at the 3D scene along x: light goes right</source>
            <translation>Regarder la scène 3D selon x : la lumière va à droite</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>From a&amp;bove</source>
            <translation>D'en &amp;haut</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Look at the 3D scene along y: light goes right</source>
            <translation>Regarder la scène 3D selon y : la lumière va à droite</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Along the a&amp;xis</source>
            <translation>Selon l'a&amp;xe</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Look back along z from behind the screen</source>
            <translation>Regarder en arrière selon z, depuis l'arrière de l'écran</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Shorten gaps</source>
            <translation>&amp;Raccourcir les distances</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Draw a far source and screen nearer, and a large screen smaller, to see the lens</source>
            <translation>Dessiner plus près source et écran lointains, et plus petit un grand écran, pour voir la lentille</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Draw a far source and screen nearer, and a large screen smaller, to see the mirror</source>
            <translation>Dessiner plus près source et écran lointains, et plus petit un grand écran, pour voir le miroir</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>No rays</source>
            <translation>Aucun rayon</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Rays in the 3D scene</source>
            <translation>Rayons de la scène 3D</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>25 rays</source>
            <translation>25 rayons</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>81 rays</source>
            <translation>81 rayons</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>225 rays</source>
            <translation>225 rayons</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>2025 rays</source>
            <translation>2025 rayons</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Inferno</source>
            <translation>Inferno</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Colours of light in the images and on the screen of the 3D scene</source>
            <translation>Couleurs de la lumière dans les images et sur l'écran de la scène 3D</translation>
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
            <translation>Gris</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>As the &amp;system</source>
            <translation>Comme le &amp;système</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Show all windows light, dark, or as the system is</source>
            <translation>Afficher toutes les fenêtres claires, sombres ou comme le système</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Light</source>
            <translation>&amp;Clair</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Dark</source>
            <translation>S&amp;ombre</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Language of the window; the command line speaks English</source>
            <translation>Langue de la fenêtre ; la ligne de commande parle anglais</translation>
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
            <translation>Colorer selon l'&amp;issue</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Rays that miss the screen are red</source>
            <translation>Les rayons qui manquent l'écran sont rouges</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Colour by &amp;weight</source>
            <translation>Colorer selon le &amp;poids</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>By the part of a ray's light that arrives</source>
            <translation>Selon la part de lumière du rayon qui arrive</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>As their &amp;material</source>
            <translation>Selon leur &amp;matériau</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Faces of the lens as glass or metal</source>
            <translation>Faces de la lentille en verre ou en métal</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Faces of the mirror as glass or metal</source>
            <translation>Faces du miroir en verre ou en métal</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>By &amp;height</source>
            <translation>Selon la &amp;hauteur</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Faces of the lens from dark, low along z, to bright</source>
            <translation>Faces de la lentille du sombre (bas selon z) au clair</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Faces of the mirror from dark, low along z, to bright</source>
            <translation>Faces du miroir du sombre (bas selon z) au clair</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>By &amp;curvature</source>
            <translation>Selon la &amp;courbure</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Faces of the lens red where they are bowl-shaped towards +z, blue where humped</source>
            <translation>Faces de la lentille rouges où elles sont creuses vers +z, bleues où elles sont bombées</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Faces of the mirror red where they are bowl-shaped towards +z, blue where humped</source>
            <translation>Faces du miroir rouges où elles sont creuses vers +z, bleues où elles sont bombées</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Relief exaggerated</source>
            <translation>&amp;Relief exagéré</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Light the fine shape of faces as if it were higher; the lens stays as it is</source>
            <translation>Éclairer la forme fine des faces comme si elle était plus haute ; la lentille reste telle quelle</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Light the fine shape of faces as if it were higher; the mirror stays as it is</source>
            <translation>Éclairer la forme fine des faces comme si elle était plus haute ; le miroir reste tel quel</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Perspective</source>
            <translation>&amp;Perspective</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Draw what is farther away smaller, instead of in parallel</source>
            <translation>Dessiner plus petit ce qui est plus loin, au lieu d'une vue parallèle</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Copy picture of 3&amp;D</source>
            <translation>Copier l'image 3&amp;D</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Put the 3D scene on the clipboard</source>
            <translation>Mettre la scène 3D dans le presse-papiers</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>1 × as large…</source>
            <translation>1 × la taille…</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Save the 3D scene as PNG, 1 × as large as it is seen</source>
            <translation>Enregistrer la scène 3D en PNG, à 1 × la taille affichée</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>2 × as large…</source>
            <translation>2 × la taille…</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Save the 3D scene as PNG, 2 × as large as it is seen</source>
            <translation>Enregistrer la scène 3D en PNG, à 2 × la taille affichée</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>4 × as large…</source>
            <translation>4 × la taille…</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Save the 3D scene as PNG, 4 × as large as it is seen</source>
            <translation>Enregistrer la scène 3D en PNG, à 4 × la taille affichée</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Turn</source>
            <translation>&amp;Tourner</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Mouse and arrow keys turn the 3D scene; click to pick</source>
            <translation>Souris et flèches tournent la scène 3D ; un clic sélectionne</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Sculpt</source>
            <translation>&amp;Sculpter</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Drag control points of the lens along z</source>
            <translation>Tirer des points de contrôle de la lentille selon z</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Drag control points of the mirror along z</source>
            <translation>Tirer des points de contrôle du miroir selon z</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Lock points</source>
            <translation>&amp;Verrouiller des points</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Paint control points that a run must leave</source>
            <translation>Peindre les points de contrôle qu'une exécution doit laisser</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Move source</source>
            <translation>&amp;Déplacer la source</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Drag the source; Ctrl: along z</source>
            <translation>Tirer la source ; Ctrl : selon z</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Mark &amp;regions</source>
            <translation>Marquer les &amp;régions</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Draw regions on the images of light, or move their edges: drag a rectangle, or click the corners of a polygon and double-click. Esc leaves</source>
            <translation>Dessiner des régions sur les images de lumière ou déplacer leurs bords : tirer un rectangle, ou cliquer les sommets d'un polygone et double-cliquer. Échap quitte</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Image as wide and high as the &amp;picture</source>
            <translation>Image au format de la &amp;photo</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Give screen or far field, and their pixels, the aspect of the target's picture</source>
            <translation>Donner à l'écran ou au champ lointain, et à leurs pixels, le format de la photo cible</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Freeform entrance face</source>
            <translation>Face d'entrée de &amp;forme libre</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Let light meet a second freeform face first, or a flat one again; the exit face stays</source>
            <translation>Faire rencontrer à la lumière d'abord une seconde face de forme libre, ou de nouveau une plane ; la face de sortie reste</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Other face</source>
            <translation>&amp;Autre face</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Turn the lens over, to sculpt or lock its other freeform face</source>
            <translation>Retourner la lentille, pour sculpter ou verrouiller son autre face de forme libre</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Turn the mirror over, to sculpt or lock its other freeform face</source>
            <translation>Retourner le miroir, pour sculpter ou verrouiller son autre face de forme libre</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Lar&amp;ger brush</source>
            <translation>Pinceau plus &amp;grand</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>More control points at once; also Ctrl+wheel</source>
            <translation>Plus de points de contrôle à la fois ; aussi Ctrl+molette</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Smaller brus&amp;h</source>
            <translation>Pinceau plus p&amp;etit</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Fewer control points at once; also Ctrl+wheel</source>
            <translation>Moins de points de contrôle à la fois ; aussi Ctrl+molette</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Lock &amp;all points</source>
            <translation>Verr&amp;ouiller tous les points</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Leave the whole lens as it is in runs</source>
            <translation>Laisser toute la lentille telle quelle dans les exécutions</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Leave the whole mirror as it is in runs</source>
            <translation>Laisser tout le miroir tel quel dans les exécutions</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Unlock all points</source>
            <translation>Déverro&amp;uiller tous les points</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Let runs change the whole lens</source>
            <translation>Laisser les exécutions changer toute la lentille</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Let runs change the whole mirror</source>
            <translation>Laisser les exécutions changer tout le miroir</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Invert locks</source>
            <translation>&amp;Inverser les verrous</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Lock what is unlocked, and the reverse</source>
            <translation>Verrouiller ce qui ne l'est pas, et inversement</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;3D scene</source>
            <translation>Scène &amp;3D</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Show or hide the 3D scene</source>
            <translation>Montrer ou cacher la scène 3D</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>R&amp;eset layout</source>
            <translation>Réi&amp;nitialiser la disposition</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Put all docks where they stood at first</source>
            <translation>Remettre tous les volets à leur place initiale</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Next pane</source>
            <translation>Volet &amp;suivant</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Take the keyboard to the next pane</source>
            <translation>Mener le clavier au volet suivant</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Previous pane</source>
            <translation>Volet &amp;précédent</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Take the keyboard to the pane before</source>
            <translation>Mener le clavier au volet précédent</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Design</source>
            <translation>Conception</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Show this pane and take the keyboard there</source>
            <translation>Montrer ce volet et y mener le clavier</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>3D scene</source>
            <translation>Scène 3D</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Irradiance</source>
            <translation>Éclairement énergétique</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Target</source>
            <translation>Cible</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Irradiance − target</source>
            <translation>Éclairement énergétique − cible</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Derivative</source>
            <translation>Dérivée</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Surface</source>
            <translation>Surface</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Manufacture</source>
            <translation>Fabrication</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Tolerances</source>
            <translation>Tolérances</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Through focus</source>
            <translation>Série focale</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Predicted photo</source>
            <translation>Photo prédite</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Check</source>
            <translation>Vérification</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Loss</source>
            <translation>Coût</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Cross-section</source>
            <translation>Coupe</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Light account</source>
            <translation>Bilan de lumière</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Runs</source>
            <translation>Exécutions</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>History</source>
            <translation>Historique</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Log</source>
            <translation>Journal</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Command &amp;palette</source>
            <translation>&amp;Palette de commandes</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Find any command by its name</source>
            <translation>Trouver une commande par son nom</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Keyboard shortcuts</source>
            <translation>&amp;Raccourcis clavier</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>All keys, to be found by name or by key</source>
            <translation>Toutes les touches, à trouver par nom ou par touche</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Tour</source>
            <translation>&amp;Visite guidée</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>A short tour of the window</source>
            <translation>Une courte visite de la fenêtre</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Manual</source>
            <translation>&amp;Manuel</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>All that can be done, here and in a shell, and what has been measured</source>
            <translation>Tout ce qui est possible, ici et dans un terminal, et ce qui a été mesuré</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;About</source>
            <translation>À pr&amp;opos</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>What this program is</source>
            <translation>Ce qu'est ce programme</translation>
        </message>
        <message>
            <location filename="../../ui/check/check.py" />
            <source>The light of this design is still being traced. Try again in a moment.</source>
            <translation>La lumière de cette conception est encore en cours de tracé. Réessayer dans un instant.</translation>
        </message>
        <message>
            <location filename="../../ui/check/check.py" />
            <source>checking…</source>
            <translation>vérification en cours…</translation>
        </message>
        <message>
            <location filename="../../ui/check/check.py" />
            <source>checking… {part:.0f} %</source>
            <translation>vérification… {part:.0f} %</translation>
        </message>
        <message>
            <location filename="../../ui/check/check.py" />
            <source>Check failed</source>
            <translation>Échec de la vérification</translation>
        </message>
        <message>
            <location filename="../../ui/check/check.py" />
            <source>Checked error {verified}</source>
            <translation>Erreur vérifiée {verified}</translation>
        </message>
        <message>
            <location filename="../../ui/check/check.py" />
            <source>Check with {rays:,} fresh rays: relative L2 error {verified} ({low:.2f} to {high:.2f} %); with the scatter of the rays {relative_l2:.2f} ± {noise:.2f} %, loss {loss}; {efficiency:.1f} % {place}</source>
            <translation>Vérification avec {rays:,} rayons nouveaux : erreur L2 relative {verified} ({low:.2f} à {high:.2f} %) ; avec la dispersion des rayons {relative_l2:.2f} ± {noise:.2f} %, coût {loss} ; {efficiency:.1f} % {place}</translation>
        </message>
        <message>
            <location filename="../../ui/check/check.py" />
            <source>check</source>
            <translation>vérification</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>F8 traces what is on show anew, with rays that its design never saw.</source>
            <translation>F8 trace à nouveau ce qui est affiché, avec des rayons que la conception n'a jamais vus.</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>check failed</source>
            <translation>échec de la vérification</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>Cells and random rays trace the same light by different means. Where they differ by more than noise and error bounds explain, one of them is wrong.</source>
            <translation>Cellules et rayons aléatoires tracent la même lumière par des moyens différents. S'ils diffèrent de plus que le bruit et les bornes d'erreur n'expliquent, l'un des deux est faux.</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>no deterministic figure</source>
            <translation>pas de valeur déterministe</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>The error is by random rays alone, whose noise is in the intervals below.</source>
            <translation>L'erreur vient des seuls rayons aléatoires, dont le bruit figure dans les intervalles ci-dessous.</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>optimiser and check</source>
            <translation>optimiseur et vérification</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>The image and the efficiency of the design differ from the check by more than errors explain: the optimiser traces fewer rays.</source>
            <translation>L'image et le rendement de la conception diffèrent de la vérification de plus que les erreurs n'expliquent : l'optimiseur trace moins de rayons.</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>verified error</source>
            <translation>erreur vérifiée</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>Relative L2 error of image and target, by cells and without random rays: what the optic itself is off.</source>
            <translation>Erreur L2 relative entre image et cible, par cellules et sans rayons aléatoires : l'écart de l'optique elle-même.</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>it is surely</source>
            <translation>elle est sûrement</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>Where that error lies, by a bound from two sizes of cells.</source>
            <translation>Où se situe cette erreur, par une borne tirée de deux tailles de cellules.</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>Cells of the entrance face whose light is spread over what they cover there.</source>
            <translation>Cellules de la face d'entrée dont la lumière est répartie sur ce qu'elles y couvrent.</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>error by independent images</source>
            <translation>erreur par images indépendantes</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>Cells would have to be finer than time allows: the error, and where it lies with 95 % confidence, are from pairs of images by random rays: their scatter has no mean.</source>
            <translation>Les cellules devraient être plus fines que le temps ne le permet : l'erreur, et où elle se situe avec 95 % de confiance, viennent de paires d'images par rayons aléatoires : leur dispersion est de moyenne nulle.</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>random rays are off by</source>
            <translation>les rayons aléatoires s'écartent de</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>Relative L2 difference of the two images: the second opinion. About once the noise of the rays is what chance alone makes.</source>
            <translation>Différence L2 relative des deux images : le second avis. Environ une fois le bruit des rayons : le seul hasard.</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>relative L2 error</source>
            <translation>erreur L2 relative</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>‖I − T‖ / ‖T‖ of image and target, each divided by its sum. The scatter of the rays from pixel to pixel is in it; more rays make it smaller.</source>
            <translation>‖I − T‖ / ‖T‖ de l'image et de la cible, chacune divisée par sa somme. La dispersion des rayons d'un pixel à l'autre y est ; plus de rayons la réduisent.</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>95 % of other rays</source>
            <translation>95 % d'autres rayons</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>Where the error with scatter lies for as many other rays.</source>
            <translation>Où se situe l'erreur avec dispersion pour autant d'autres rayons.</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>without ray noise</source>
            <translation>sans bruit des rayons</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>The same error without the scatter of the rays: what the optic itself is off. With &lt; if so few rays cannot tell it from none.</source>
            <translation>La même erreur sans la dispersion des rayons : l'écart de l'optique elle-même. Avec &lt; si si peu de rayons ne la distinguent pas d'une erreur nulle.</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>95 % confidence</source>
            <translation>confiance à 95 %</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>Where the error of the optic itself lies.</source>
            <translation>Où se situe l'erreur de l'optique elle-même.</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>loss of the paper</source>
            <translation>coût de l'article</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>The norm of the difference between image and target, each divided by its sum, over the root of the number of pixels.</source>
            <translation>La norme de la différence entre image et cible, chacune divisée par sa somme, sur la racine du nombre de pixels.</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>PSNR</source>
            <translation>PSNR</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>Peak signal-to-noise ratio, against the target's peak: more is better.</source>
            <translation>Rapport signal sur bruit de crête, par rapport à la crête de la cible : plus grand est mieux.</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>SSIM</source>
            <translation>SSIM</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>Mean structural similarity in windows of 11 × 11 pixels: 1 for equal images.</source>
            <translation>Similarité structurelle moyenne dans des fenêtres de 11 × 11 pixels : 1 pour des images égales.</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>Pearson's coefficient of image and target over the pixels: 1 for images of one shape.</source>
            <translation>Coefficient de Pearson de l'image et de la cible sur les pixels : 1 pour des images de même forme.</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>Least over mean of irradiance / target where the target is lit, at half its peak or more: 1 is even, 0 has a dark pixel.</source>
            <translation>Minimum sur moyenne de éclairement / cible là où la cible est éclairée, à la moitié de sa crête ou plus : 1 est uniforme, 0 a un pixel sombre.</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>(lit − black) / (lit + black) of the mean irradiances there; black is up to a hundredth of the target's peak. 1 is a perfect black.</source>
            <translation>(éclairé − noir) / (éclairé + noir) des éclairements moyens ; noir va jusqu'à un centième de la crête de la cible. 1 est un noir parfait.</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>Part of the emitted light that makes the image.</source>
            <translation>Part de la lumière émise qui forme l'image.</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>meets the face again</source>
            <translation>rencontre à nouveau la face</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>Light that comes back to the face which it leaves, as in a deep bowl. Image and efficiency count it as if nothing were in its way.</source>
            <translation>Lumière qui revient à la face qu'elle quitte, comme dans un bol profond. Image et rendement la comptent comme si rien ne la gênait.</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>comes through the screen</source>
            <translation>traverse l'écran</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>Light that the screen keeps from the mirror. Image and efficiency count it as if the screen were not in its way; a screen beside the axis is not.</source>
            <translation>Lumière que l'écran cache au miroir. Image et rendement la comptent comme si l'écran ne gênait pas ; un écran à côté de l'axe ne gêne pas.</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>off the optimiser's image</source>
            <translation>écart à l'image de l'optimiseur</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>Relative L2 difference to the image that the optimiser sees. Its filter and the scatter of these rays are in it.</source>
            <translation>Différence L2 relative à l'image que voit l'optimiseur. Son filtre et la dispersion de ces rayons y sont.</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>Rays of the image; a quarter as many more are traced for the error without scatter.</source>
            <translation>Rayons de l'image ; un quart de plus est tracé pour l'erreur sans dispersion.</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>cells</source>
            <translation>cellules</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>correlation</source>
            <translation>corrélation</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>uniformity</source>
            <translation>uniformité</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>contrast</source>
            <translation>contraste</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>efficiency</source>
            <translation>rendement</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>rays</source>
            <translation>rayons</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>Part of the emitted light that falls on the region, and its darkest and brightest pixel over the mean: 1 is even.</source>
            <translation>Part de la lumière émise qui tombe sur la région, et ses pixels le plus sombre et le plus clair sur la moyenne : 1 est uniforme.</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>Figures of the check</source>
            <translation>Chiffres de la vérification</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>Copy</source>
            <translation>Copier</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>Rays of a check</source>
            <translation>Rayons d'une vérification</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>Rays of a check; four times as many halve their scatter</source>
            <translation>Rayons d'une vérification ; quatre fois plus divisent leur dispersion par deux</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>{rays} million rays</source>
            <translation>{rays} millions de rayons</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>Put all figures on the clipboard, a tab between name and value</source>
            <translation>Mettre tous les chiffres dans le presse-papiers, une tabulation entre nom et valeur</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source>image {number}: {name}</source>
            <translation>image {number} : {name}</translation>
        </message>
        <message>
            <location filename="../../ui/check/figures.py" />
            <source> Out of date: these figures are of the design before.</source>
            <translation> Périmé : ces chiffres sont ceux de la conception précédente.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/actions.py" />
            <source>Toolbar</source>
            <translation>Barre d'outils</translation>
        </message>
        <message>
            <location filename="../../ui/commands/availability.py" />
            <source>There is one freeform face: Freeform entrance face gives a lens a second one</source>
            <translation>Il y a une face de forme libre : « Face d'entrée de forme libre » en donne une seconde à une lentille</translation>
        </message>
        <message>
            <location filename="../../ui/commands/availability.py" />
            <source>Not while a run goes on: it works on the design as it was when it began. Stop it first</source>
            <translation>Pas pendant une exécution : elle travaille sur la conception telle qu'au début. L'arrêter d'abord</translation>
        </message>
        <message>
            <location filename="../../ui/commands/availability.py" />
            <source>Flat &amp;entrance face</source>
            <translation>Face d'entrée &amp;plane</translation>
        </message>
        <message>
            <location filename="../../ui/commands/availability.py" />
            <source>Freeform &amp;entrance face</source>
            <translation>Face d'entrée d&amp;e forme libre</translation>
        </message>
        <message>
            <location filename="../../ui/commands/availability.py" />
            <source>&amp;Start over</source>
            <translation>Reco&amp;mmencer</translation>
        </message>
        <message>
            <location filename="../../ui/commands/availability.py" />
            <source>&amp;Resume</source>
            <translation>R&amp;eprendre</translation>
        </message>
        <message>
            <location filename="../../ui/commands/availability.py" />
            <source>There is no lens yet: Start designs one</source>
            <translation>Il n'y a pas encore de lentille : Démarrer en conçoit une</translation>
        </message>
        <message>
            <location filename="../../ui/commands/availability.py" />
            <source>There is no mirror yet: Start designs one</source>
            <translation>Il n'y a pas encore de miroir : Démarrer en conçoit un</translation>
        </message>
        <message>
            <location filename="../../ui/commands/availability.py" />
            <source>the best lens so far</source>
            <translation>la meilleure lentille jusqu'ici</translation>
        </message>
        <message>
            <location filename="../../ui/commands/availability.py" />
            <source>the best mirror so far</source>
            <translation>le meilleur miroir jusqu'ici</translation>
        </message>
        <message>
            <location filename="../../ui/commands/availability.py" />
            <source>Takes {lens}</source>
            <translation>Utilise : {lens}</translation>
        </message>
        <message>
            <location filename="../../ui/commands/availability.py" />
            <source>A lens has one freeform face</source>
            <translation>Une lentille a une face de forme libre</translation>
        </message>
        <message>
            <location filename="../../ui/commands/availability.py" />
            <source>A mirror has one freeform face</source>
            <translation>Un miroir a une face de forme libre</translation>
        </message>
        <message>
            <location filename="../../ui/commands/language_choice.py" />
            <source>The language changes at the next start.</source>
            <translation>La langue change au prochain démarrage.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/palette.py" />
            <source>Command palette</source>
            <translation>Palette de commandes</translation>
        </message>
        <message>
            <location filename="../../ui/commands/palette.py" />
            <source>Type parts of a command's name</source>
            <translation>Saisir des parties du nom d'une commande</translation>
        </message>
        <message>
            <location filename="../../ui/commands/palette.py" />
            <source>No command has all of this in its name: {words}</source>
            <translation>Aucune commande n'a tout cela dans son nom : {words}</translation>
        </message>
        <message>
            <location filename="../../ui/commands/shortcuts.py" />
            <source>Keyboard shortcuts</source>
            <translation>Raccourcis clavier</translation>
        </message>
        <message>
            <location filename="../../ui/commands/shortcuts.py" />
            <source>Find by a part of the name, or by the key</source>
            <translation>Chercher par une partie du nom, ou par la touche</translation>
        </message>
        <message>
            <location filename="../../ui/commands/shortcuts.py" />
            <source>Find a shortcut</source>
            <translation>Chercher un raccourci</translation>
        </message>
        <message>
            <location filename="../../ui/commands/shortcuts.py" />
            <source>Command</source>
            <translation>Commande</translation>
        </message>
        <message>
            <location filename="../../ui/commands/shortcuts.py" />
            <source>Key</source>
            <translation>Touche</translation>
        </message>
        <message>
            <location filename="../../ui/document/document.py" />
            <source>new reading of the image</source>
            <translation>nouvelle lecture de l'image</translation>
        </message>
        <message>
            <location filename="../../ui/document/document.py" />
            <source>new task: {name}</source>
            <translation>nouvelle tâche : {name}</translation>
        </message>
        <message>
            <location filename="../../ui/document/document.py" />
            <source>revert to the file</source>
            <translation>retour au fichier</translation>
        </message>
        <message>
            <location filename="../../ui/files/actions.py" />
            <source>Designs and scenes ({endings});;All files (*)</source>
            <translation>Conceptions et scènes ({endings});;Tous les fichiers (*)</translation>
        </message>
        <message>
            <location filename="../../ui/files/actions.py" />
            <source>Designs ({endings})</source>
            <translation>Conceptions ({endings})</translation>
        </message>
        <message>
            <location filename="../../ui/files/actions.py" />
            <source>Open</source>
            <translation>Ouvrir</translation>
        </message>
        <message>
            <location filename="../../ui/files/actions.py" />
            <source>{path} is no longer there; it was taken off the list.</source>
            <translation>{path} n'existe plus ; il a été retiré de la liste.</translation>
        </message>
        <message>
            <location filename="../../ui/files/actions.py" />
            <source>{name}: the name of a design ends in {ending}</source>
            <translation>{name} : le nom d'une conception se termine par {ending}</translation>
        </message>
        <message>
            <location filename="../../ui/files/actions.py" />
            <source>Save as</source>
            <translation>Enregistrer sous</translation>
        </message>
        <message>
            <location filename="../../ui/files/actions.py" />
            <source>Save the changes to {name}?</source>
            <translation>Enregistrer les modifications de {name} ?</translation>
        </message>
        <message>
            <location filename="../../ui/files/actions.py" />
            <source>Unsaved changes</source>
            <translation>Modifications non enregistrées</translation>
        </message>
        <message>
            <location filename="../../ui/files/actions.py" />
            <source>{name} is open in another window: choose another name.</source>
            <translation>{name} est ouvert dans une autre fenêtre : choisir un autre nom.</translation>
        </message>
        <message>
            <location filename="../../ui/files/actions.py" />
            <source>, with {lens}</source>
            <translation>, avec : {lens}</translation>
        </message>
        <message>
            <location filename="../../ui/files/actions.py" />
            <source>Save as…</source>
            <translation>Enregistrer sous…</translation>
        </message>
        <message>
            <location filename="../../ui/files/actions.py" />
            <source>Saved {name}, {size}{words}</source>
            <translation>{name} enregistré, {size}{words}</translation>
        </message>
        <message>
            <location filename="../../ui/files/changed.py" />
            <source>The file has changed</source>
            <translation>Le fichier a changé</translation>
        </message>
        <message>
            <location filename="../../ui/files/changed.py" />
            <source>Another program has changed {name} since it was last read or saved here.</source>
            <translation>Un autre programme a modifié {name} depuis sa dernière lecture ou son dernier enregistrement ici.</translation>
        </message>
        <message>
            <location filename="../../ui/files/changed.py" />
            <source>Overwrite loses what the file holds now. Reload shows it in place of your design; Undo brings your design back.</source>
            <translation>Écraser perd ce que le fichier contient à présent. Recharger le montre à la place de votre conception ; Annuler la ramène.</translation>
        </message>
        <message>
            <location filename="../../ui/files/changed.py" />
            <source>&amp;Overwrite</source>
            <translation>&amp;Écraser</translation>
        </message>
        <message>
            <location filename="../../ui/files/changed.py" />
            <source>&amp;Reload</source>
            <translation>&amp;Recharger</translation>
        </message>
        <message>
            <location filename="../../ui/files/changed.py" />
            <source>The file is gone</source>
            <translation>Le fichier a disparu</translation>
        </message>
        <message>
            <location filename="../../ui/files/changed.py" />
            <source>{name} has been deleted, moved or renamed since it was last saved here.</source>
            <translation>{name} a été supprimé, déplacé ou renommé depuis son dernier enregistrement ici.</translation>
        </message>
        <message>
            <location filename="../../ui/files/changed.py" />
            <source>&amp;Save there again</source>
            <translation>&amp;Enregistrer à nouveau là</translation>
        </message>
        <message>
            <location filename="../../ui/files/changed.py" />
            <source>Its folder, {parent}, is gone, too.</source>
            <translation>Son dossier, {parent}, a disparu aussi.</translation>
        </message>
        <message>
            <location filename="../../ui/files/chosen_files.py" />
            <source>{name} is a file of light, not a design.</source>
            <translation>{name} est un fichier de lumière, pas une conception.</translation>
        </message>
        <message>
            <location filename="../../ui/files/chosen_files.py" />
            <source>Use as light source</source>
            <translation>Utiliser comme source de lumière</translation>
        </message>
        <message>
            <location filename="../../ui/files/chosen_files.py" />
            <source>{name} is a picture, not a design.</source>
            <translation>{name} est une image, pas une conception.</translation>
        </message>
        <message>
            <location filename="../../ui/files/chosen_files.py" />
            <source>Use as target</source>
            <translation>Utiliser comme cible</translation>
        </message>
        <message>
            <location filename="../../ui/files/chosen_files.py" />
            <source>There is no picture on the clipboard.</source>
            <translation>Il n'y a pas d'image dans le presse-papiers.</translation>
        </message>
        <message>
            <location filename="../../ui/files/chosen_files.py" />
            <source>Target image</source>
            <translation>Image cible</translation>
        </message>
        <message>
            <location filename="../../ui/files/chosen_files.py" />
            <source>File of light</source>
            <translation>Fichier de lumière</translation>
        </message>
        <message>
            <location filename="../../ui/files/exporter.py" />
            <source>export</source>
            <translation>export</translation>
        </message>
        <message>
            <location filename="../../ui/files/exporter.py" />
            <source>Cut {lens}</source>
            <translation>Usiner : {lens}</translation>
        </message>
        <message>
            <location filename="../../ui/files/exporter.py" />
            <source>One file is still being written; export the next after it.</source>
            <translation>Un fichier est encore en cours d'écriture ; exporter le suivant après.</translation>
        </message>
        <message>
            <location filename="../../ui/files/exporter.py" />
            <source>{name} is being written…</source>
            <translation>Écriture de {name}…</translation>
        </message>
        <message>
            <location filename="../../ui/files/exporter.py" />
            <source>Cancel</source>
            <translation>Annuler</translation>
        </message>
        <message>
            <location filename="../../ui/files/exporter.py" />
            <source>Export {lens}</source>
            <translation>Exporter : {lens}</translation>
        </message>
        <message>
            <location filename="../../ui/files/exporter.py" />
            <source>No file is written.</source>
            <translation>Aucun fichier n'est écrit.</translation>
        </message>
        <message>
            <location filename="../../ui/files/exporter.py" />
            <source>{format} in {unit}</source>
            <translation>{format} en {unit}</translation>
        </message>
        <message>
            <location filename="../../ui/files/gallery.py" />
            <source>New from example</source>
            <translation>Nouveau d'après un exemple</translation>
        </message>
        <message>
            <location filename="../../ui/files/gallery.py" />
            <source>Examples</source>
            <translation>Exemples</translation>
        </message>
        <message>
            <location filename="../../ui/files/left_behind.py" />
            <source>Unsaved work</source>
            <translation>Travail non enregistré</translation>
        </message>
        <message>
            <location filename="../../ui/files/left_behind.py" />
            <source>{name} had unsaved changes when the workbench was asked to end.</source>
            <translation>{name} avait des modifications non enregistrées quand le programme a été terminé.</translation>
        </message>
        <message>
            <location filename="../../ui/files/left_behind.py" />
            <source>The workbench was not closed. Unsaved changes to {name} were kept.</source>
            <translation>Le programme n'a pas été fermé. Les modifications non enregistrées de {name} ont été gardées.</translation>
        </message>
        <message>
            <location filename="../../ui/files/left_behind.py" />
            <source>Kept on {kept_at:%Y-%m-%d, %H:%M:%S}.</source>
            <translation>Gardées le {kept_at:%Y-%m-%d, %H:%M:%S}.</translation>
        </message>
        <message>
            <location filename="../../ui/files/left_behind.py" />
            <source>&amp;Recover</source>
            <translation>&amp;Récupérer</translation>
        </message>
        <message>
            <location filename="../../ui/files/left_behind.py" />
            <source>&amp;Discard</source>
            <translation>&amp;Abandonner</translation>
        </message>
        <message>
            <location filename="../../ui/files/left_behind.py" />
            <source>Ask &amp;later</source>
            <translation>Demander p&amp;lus tard</translation>
        </message>
        <message>
            <location filename="../../ui/files/photo_picture.py" />
            <source>There is no photo of this lens yet; save it once it is seen.</source>
            <translation>Il n'y a pas encore de photo de cette lentille ; l'enregistrer dès qu'on la voit.</translation>
        </message>
        <message>
            <location filename="../../ui/files/photo_picture.py" />
            <source>{design} photo</source>
            <translation>{design} photo</translation>
        </message>
        <message>
            <location filename="../../ui/files/photo_picture.py" />
            <source>Picture ({endings})</source>
            <translation>Image ({endings})</translation>
        </message>
        <message>
            <location filename="../../ui/files/photo_picture.py" />
            <source>Save predicted photo</source>
            <translation>Enregistrer la photo prédite</translation>
        </message>
        <message>
            <location filename="../../ui/files/photo_picture.py" />
            <source>The lens has changed since; save the photo of the new one.</source>
            <translation>La lentille a changé depuis ; enregistrer la photo de la nouvelle.</translation>
        </message>
        <message>
            <location filename="../../ui/files/photo_picture.py" />
            <source>{path} is written.</source>
            <translation>{path} est écrit.</translation>
        </message>
        <message>
            <location filename="../../ui/files/plots.py" />
            <source>Picture in pixels (*.png)</source>
            <translation>Image en pixels (*.png)</translation>
        </message>
        <message>
            <location filename="../../ui/files/plots.py" />
            <source>Picture in lines (*.svg)</source>
            <translation>Image vectorielle (*.svg)</translation>
        </message>
        <message>
            <location filename="../../ui/files/plots.py" />
            <source>Numbers shown (*.csv)</source>
            <translation>Valeurs affichées (*.csv)</translation>
        </message>
        <message>
            <location filename="../../ui/files/plots.py" />
            <source>Figures (*.json)</source>
            <translation>Chiffres (*.json)</translation>
        </message>
        <message>
            <location filename="../../ui/files/plots.py" />
            <source>plot</source>
            <translation>graphique</translation>
        </message>
        <message>
            <location filename="../../ui/files/plots.py" />
            <source>A picture of the {pane} plot is on the clipboard.</source>
            <translation>Une image du graphique « {pane} » est dans le presse-papiers.</translation>
        </message>
        <message>
            <location filename="../../ui/files/plots.py" />
            <source>{name}: a plot is saved as one of {known}</source>
            <translation>{name} : un graphique s'enregistre comme l'un de {known}</translation>
        </message>
        <message>
            <location filename="../../ui/files/plots.py" />
            <source>Save {pane} plot</source>
            <translation>Enregistrer le graphique « {pane} »</translation>
        </message>
        <message>
            <location filename="../../ui/files/plots.py" />
            <source>There is no plot to be seen; View shows the docks of all plots.</source>
            <translation>Aucun graphique n'est visible ; Affichage montre les volets de tous les graphiques.</translation>
        </message>
        <message>
            <location filename="../../ui/files/plots.py" />
            <source>One plot is still being written; save the next after it.</source>
            <translation>Un graphique est encore en cours d'écriture ; enregistrer le suivant après.</translation>
        </message>
        <message>
            <location filename="../../ui/files/recovery.py" />
            <source>recovery</source>
            <translation>récupération</translation>
        </message>
        <message>
            <location filename="../../ui/files/recovery.py" />
            <source>Unsaved work cannot be kept for a recovery. {reason}</source>
            <translation>Le travail non enregistré ne peut être gardé pour une récupération. {reason}</translation>
        </message>
        <message>
            <location filename="../../ui/files/reporter.py" />
            <source>Web page (*.html)</source>
            <translation>Page web (*.html)</translation>
        </message>
        <message>
            <location filename="../../ui/files/reporter.py" />
            <source>Document (*.pdf)</source>
            <translation>Document (*.pdf)</translation>
        </message>
        <message>
            <location filename="../../ui/files/reporter.py" />
            <source>report</source>
            <translation>rapport</translation>
        </message>
        <message>
            <location filename="../../ui/files/reporter.py" />
            <source>One report is still being written; ask for the next after it.</source>
            <translation>Un rapport est encore en cours d'écriture ; demander le suivant après.</translation>
        </message>
        <message>
            <location filename="../../ui/files/reporter.py" />
            <source>{file} is being written, with a check of {lens}…</source>
            <translation>Écriture de {file}, avec une vérification ({lens})…</translation>
        </message>
        <message>
            <location filename="../../ui/files/reporter.py" />
            <source>Report {lens}</source>
            <translation>Rapport : {lens}</translation>
        </message>
        <message>
            <location filename="../../ui/files/reporter.py" />
            <source>No report is written.</source>
            <translation>Aucun rapport n'est écrit.</translation>
        </message>
        <message>
            <location filename="../../ui/files/scene_pictures.py" />
            <source>A picture of the 3D scene is on the clipboard.</source>
            <translation>Une image de la scène 3D est dans le presse-papiers.</translation>
        </message>
        <message>
            <location filename="../../ui/files/scene_pictures.py" />
            <source>{path} is written, {width} × {height} pixels.</source>
            <translation>{path} est écrit, {width} × {height} pixels.</translation>
        </message>
        <message>
            <location filename="../../ui/files/scene_pictures.py" />
            <source>Save picture of 3D</source>
            <translation>Enregistrer l'image 3D</translation>
        </message>
        <message>
            <location filename="../../ui/files/scene_pictures.py" />
            <source>The 3D scene is hidden; View &gt; 3D scene shows it.</source>
            <translation>La scène 3D est cachée ; Affichage &gt; Scène 3D la montre.</translation>
        </message>
        <message>
            <location filename="../../ui/help/help.py" />
            <source>New here? A tour of {count} steps shows what is where. Help &gt; Tour begins it at any time.</source>
            <translation>Première visite ? Un tour en {count} étapes montre où tout se trouve. Aide &gt; Visite guidée le lance à tout moment.</translation>
        </message>
        <message>
            <location filename="../../ui/help/help.py" />
            <source>Show me around</source>
            <translation>Faire la visite</translation>
        </message>
        <message>
            <location filename="../../ui/help/help.py" />
            <source>About {title}</source>
            <translation>À propos de {title}</translation>
        </message>
        <message>
            <location filename="../../ui/help/help.py" />
            <source>&lt;h3&gt;{title} {version}&lt;/h3&gt;&lt;p&gt;Shapes a freeform lens until it throws the wanted image of light.&lt;/p&gt;&lt;p&gt;MIT licence&lt;/p&gt;</source>
            <translation>&lt;h3&gt;{title} {version}&lt;/h3&gt;&lt;p&gt;Façonne une lentille de forme libre jusqu'à ce qu'elle projette l'image de lumière voulue.&lt;/p&gt;&lt;p&gt;Licence MIT&lt;/p&gt;</translation>
        </message>
        <message>
            <location filename="../../ui/help/manual.py" />
            <source>Manual</source>
            <translation>Manuel</translation>
        </message>
        <message>
            <location filename="../../ui/help/manual.py" />
            <source>Search</source>
            <translation>Rechercher</translation>
        </message>
        <message>
            <location filename="../../ui/help/manual.py" />
            <source>Search the manual</source>
            <translation>Rechercher dans le manuel</translation>
        </message>
        <message>
            <location filename="../../ui/help/manual.py" />
            <source>Words that a page must hold; Return goes to the next place</source>
            <translation>Mots qu'une page doit contenir ; Entrée va à l'endroit suivant</translation>
        </message>
        <message>
            <location filename="../../ui/help/manual.py" />
            <source>Pages of the manual</source>
            <translation>Pages du manuel</translation>
        </message>
        <message>
            <location filename="../../ui/help/manual.py" />
            <source>No page has all of this: {words}</source>
            <translation>Aucune page ne contient tout cela : {words}</translation>
        </message>
        <message>
            <location filename="../../ui/help/tour.py" />
            <source>Describe the task</source>
            <translation>Décrire la tâche</translation>
        </message>
        <message>
            <location filename="../../ui/help/tour.py" />
            <source>Here you say what you have and what you want: the image of light, the lens, the source, the screen. What is not possible is refused beside the field, with what would be allowed. Any picture dropped onto the window becomes the target.</source>
            <translation>Ici se dit ce qu'on a et ce qu'on veut : l'image de lumière, la lentille, la source, l'écran. L'impossible est refusé à côté du champ, avec ce qui serait permis. Toute image déposée sur la fenêtre devient la cible.</translation>
        </message>
        <message>
            <location filename="../../ui/help/tour.py" />
            <source>Start</source>
            <translation>Démarrer</translation>
        </message>
        <message>
            <location filename="../../ui/help/tour.py" />
            <source>Start (F5) shapes the lens until its light fits the target. Pause (F6) holds it, Stop (F7) keeps the best lens so far, Continue goes on from there.</source>
            <translation>Démarrer (F5) façonne la lentille jusqu'à ce que sa lumière suive la cible. Pause (F6) suspend, Arrêter (F7) garde la meilleure lentille, Continuer repart de là.</translation>
        </message>
        <message>
            <location filename="../../ui/help/tour.py" />
            <source>Watch the light</source>
            <translation>Regarder la lumière</translation>
        </message>
        <message>
            <location filename="../../ui/help/tour.py" />
            <source>Lens, rays and screen. Drag to turn, Shift-drag to move, scroll to zoom, or use arrow keys, + and −. Ctrl+1 looks at the lens, Ctrl+2 at the screen, Ctrl+0 shows all again; Ctrl+D draws a far screen nearer.</source>
            <translation>Lentille, rayons et écran. Tirer tourne, Maj et tirer déplace, la molette zoome ; ou les flèches, + et −. Ctrl+1 montre la lentille, Ctrl+2 l'écran, Ctrl+0 à nouveau tout ; Ctrl+D dessine plus près un écran lointain.</translation>
        </message>
        <message>
            <location filename="../../ui/help/tour.py" />
            <source>See what reaches the screen</source>
            <translation>Voir ce qui atteint l'écran</translation>
        </message>
        <message>
            <location filename="../../ui/help/tour.py" />
            <source>Flux per area, live. Below it what is still wrong: too much light is red, too little is blue. Both zoom and move together.</source>
            <translation>Le flux par surface, en direct. À côté, ce qui ne va pas encore : trop de lumière en rouge, trop peu en bleu. Les deux zooment et se déplacent ensemble.</translation>
        </message>
        <message>
            <location filename="../../ui/help/tour.py" />
            <source>Look back</source>
            <translation>Regarder en arrière</translation>
        </message>
        <message>
            <location filename="../../ui/help/tour.py" />
            <source>The curve falls while the lens gets better. The slider below it shows the lens at any kept moment of the run; you can go on from there.</source>
            <translation>La courbe descend quand la lentille s'améliore. Le curseur dessous montre la lentille à tout moment gardé de l'exécution ; on peut repartir de là.</translation>
        </message>
        <message>
            <location filename="../../ui/help/tour.py" />
            <source>Nothing is lost</source>
            <translation>Rien n'est perdu</translation>
        </message>
        <message>
            <location filename="../../ui/help/tour.py" />
            <source>Every edit and every run is a step. Undo with Ctrl+Z, or click a step to go there. Unsaved work is kept every minute, even if the program breaks off.</source>
            <translation>Chaque modification et chaque exécution est une étape. Annuler par Ctrl+Z, ou cliquer sur une étape. Le travail non enregistré est gardé chaque minute, même si le programme s'interrompt.</translation>
        </message>
        <message>
            <location filename="../../ui/help/tour.py" />
            <source>Find anything</source>
            <translation>Tout trouver</translation>
        </message>
        <message>
            <location filename="../../ui/help/tour.py" />
            <source>Ctrl+Shift+P finds any command by parts of its name. File &gt; New from gallery has examples by their pictures, File &gt; Export takes the lens to other programs. Enjoy!</source>
            <translation>Ctrl+Maj+P trouve toute commande par des parties de son nom. Fichier &gt; Nouveau depuis la galerie montre des exemples en images, Fichier &gt; Exporter mène la lentille vers d'autres programmes. Bonne visite !</translation>
        </message>
        <message>
            <location filename="../../ui/help/tour.py" />
            <source>&amp;End</source>
            <translation>&amp;Terminer</translation>
        </message>
        <message>
            <location filename="../../ui/help/tour.py" />
            <source>&amp;Back</source>
            <translation>&amp;Retour</translation>
        </message>
        <message>
            <location filename="../../ui/help/tour.py" />
            <source>End the tour (Esc); Help &gt; Tour begins it again</source>
            <translation>Terminer la visite (Échap) ; Aide &gt; Visite guidée la relance</translation>
        </message>
        <message>
            <location filename="../../ui/help/tour.py" />
            <source>{number} of {count}</source>
            <translation>{number} sur {count}</translation>
        </message>
        <message>
            <location filename="../../ui/help/tour.py" />
            <source>&amp;Done</source>
            <translation>&amp;Fini</translation>
        </message>
        <message>
            <location filename="../../ui/help/tour.py" />
            <source>&amp;Next</source>
            <translation>&amp;Suivant</translation>
        </message>
        <message>
            <location filename="../../ui/jobs/drawing.py" />
            <source>The job from the side</source>
            <translation>La tâche vue de côté</translation>
        </message>
        <message>
            <location filename="../../ui/jobs/drawing.py" />
            <source>From the side</source>
            <translation>De côté</translation>
        </message>
        <message>
            <location filename="../../ui/jobs/drawing.py" />
            <source>From above</source>
            <translation>D'en haut</translation>
        </message>
        <message>
            <location filename="../../ui/jobs/drawing.py" />
            <source>, {across:.1f} × as high</source>
            <translation>, {across:.1f} × plus haut</translation>
        </message>
        <message>
            <location filename="../../ui/jobs/drawing.py" />
            <source>, to scale</source>
            <translation>, à l'échelle</translation>
        </message>
        <message>
            <location filename="../../ui/jobs/form.py" />
            <source>picture</source>
            <translation>image</translation>
        </message>
        <message>
            <location filename="../../ui/jobs/form.py" />
            <source>file of light</source>
            <translation>fichier de lumière</translation>
        </message>
        <message>
            <location filename="../../ui/jobs/outlook.py" />
            <source>outlook</source>
            <translation>aperçu</translation>
        </message>
        <message>
            <location filename="../../ui/jobs/outlook.py" />
            <source>Picture at best</source>
            <translation>Image au mieux</translation>
        </message>
        <message>
            <location filename="../../ui/jobs/outlook.py" />
            <source>Blurred by the size of the light, as any lens has to</source>
            <translation>Rendue floue par la taille de la source, comme avec toute lentille</translation>
        </message>
        <message>
            <location filename="../../ui/jobs/outlook.py" />
            <source>Wanted</source>
            <translation>Voulu</translation>
        </message>
        <message>
            <location filename="../../ui/jobs/outlook.py" />
            <source>At best</source>
            <translation>Au mieux</translation>
        </message>
        <message>
            <location filename="../../ui/jobs/outlook.py" />
            <source>Computing what can be expected…</source>
            <translation>Calcul de ce qu'on peut attendre…</translation>
        </message>
        <message>
            <location filename="../../ui/jobs/outlook.py" />
            <source>The figures are of the answers before.</source>
            <translation>Les valeurs sont celles des réponses précédentes.</translation>
        </message>
        <message>
            <location filename="../../ui/jobs/outlook.py" />
            <source>Estimating… {part:.0f} %</source>
            <translation>Estimation… {part:.0f} %</translation>
        </message>
        <message>
            <location filename="../../ui/jobs/page.py" />
            <source>New design</source>
            <translation>Nouvelle conception</translation>
        </message>
        <message>
            <location filename="../../ui/jobs/page.py" />
            <source>Jobs</source>
            <translation>Tâches</translation>
        </message>
        <message>
            <location filename="../../ui/jobs/page.py" />
            <source>&amp;Begin</source>
            <translation>&amp;Commencer</translation>
        </message>
        <message>
            <location filename="../../ui/jobs/page.py" />
            <source>&amp;Open a file…</source>
            <translation>&amp;Ouvrir un fichier…</translation>
        </message>
        <message>
            <location filename="../../ui/jobs/page.py" />
            <source>E&amp;xamples…</source>
            <translation>E&amp;xemples…</translation>
        </message>
        <message>
            <location filename="../../ui/jobs/page.py" />
            <source>Cannot begin: {reason}</source>
            <translation>Impossible de commencer : {reason}</translation>
        </message>
        <message>
            <location filename="../../ui/jobs/page.py" />
            <source>Picture</source>
            <translation>Motif</translation>
        </message>
        <message>
            <location filename="../../ui/lens/brush.py" />
            <source>a single point</source>
            <translation>un seul point</translation>
        </message>
        <message>
            <location filename="../../ui/lens/brush.py" />
            <source>radius {radius}</source>
            <translation>rayon {radius}</translation>
        </message>
        <message>
            <location filename="../../ui/lens/live.py" />
            <source>trace of the lens</source>
            <translation>tracé de la lentille</translation>
        </message>
        <message>
            <location filename="../../ui/lens/live.py" />
            <source>trace of the mirror</source>
            <translation>tracé du miroir</translation>
        </message>
        <message>
            <location filename="../../ui/lens/lock.py" />
            <source>{place}Paint over control points to lock them, or unlock them where you begin on a lock; or use arrows and Space. Brush, [ and ]: {words}. {count} locked</source>
            <translation>{place}Peindre les points de contrôle pour les verrouiller, ou les libérer en partant d'un verrou ; ou par flèches et Espace. Pinceau, [ et ] : {words}. {count} verrouillés</translation>
        </message>
        <message>
            <location filename="../../ui/lens/move_source.py" />
            <source>Collimated light comes from everywhere: choose another source to move it</source>
            <translation>La lumière collimatée vient de partout : choisir une autre source pour la déplacer</translation>
        </message>
        <message>
            <location filename="../../ui/lens/move_source.py" />
            <source>Drag the source across, Ctrl: along z; or use arrows, Page Up and Page Down; Shift: finely; Esc: back. </source>
            <translation>Tirer la source en travers, Ctrl : selon z ; ou par flèches, Page haut et bas ; Maj : finement ; Échap : retour. </translation>
        </message>
        <message>
            <location filename="../../ui/lens/move_source.py" />
            <source>Corners: its size. </source>
            <translation>Coins : sa taille. </translation>
        </message>
        <message>
            <location filename="../../ui/lens/sculpt.py" />
            <source>{place}Drag control points along z, or use arrows, Page Up and Page Down; Shift: finely; Esc: back. Brush, [ and ]: {words}</source>
            <translation>{place}Tirer des points de contrôle selon z, ou par flèches, Page haut et bas ; Maj : finement ; Échap : retour. Pinceau, [ et ] : {words}</translation>
        </message>
        <message>
            <location filename="../../ui/lens/sculpt.py" />
            <source>. Moved by {rise:+.4g} {unit}</source>
            <translation>. Déplacé de {rise:+.4g} {unit}</translation>
        </message>
        <message>
            <location filename="../../ui/lens/sculpt.py" />
            <source>All control points in the brush are locked; unlock some first.</source>
            <translation>Tous les points de contrôle du pinceau sont verrouillés ; en libérer d'abord.</translation>
        </message>
        <message>
            <location filename="../../ui/lens/tools.py" />
            <source>Stop the run first; then change the lens by hand.</source>
            <translation>Arrêter d'abord l'exécution ; puis modifier la lentille à la main.</translation>
        </message>
        <message>
            <location filename="../../ui/lens/tools.py" />
            <source>Stop the run first; then change the mirror by hand.</source>
            <translation>Arrêter d'abord l'exécution ; puis modifier le miroir à la main.</translation>
        </message>
        <message>
            <location filename="../../ui/lens/tools.py" />
            <source>There is no lens to shape yet.</source>
            <translation>Il n'y a pas encore de lentille à façonner.</translation>
        </message>
        <message>
            <location filename="../../ui/lens/tools.py" />
            <source>There is no mirror to shape yet.</source>
            <translation>Il n'y a pas encore de miroir à façonner.</translation>
        </message>
        <message>
            <location filename="../../ui/lens/tools.py" />
            <source>There is one freeform face. Design &gt; Freeform entrance face gives a lens a second one.</source>
            <translation>Il y a une face de forme libre. Conception &gt; Face d'entrée de forme libre en donne une seconde à une lentille.</translation>
        </message>
        <message>
            <location filename="../../ui/lens/tools.py" />
            <source>Show distances to scale first (View &gt; Shorten gaps); then move the source.</source>
            <translation>Afficher d'abord les distances à l'échelle (Affichage &gt; Raccourcir les distances) ; puis déplacer la source.</translation>
        </message>
        <message>
            <location filename="../../ui/lens/tools.py" />
            <source>lock all points</source>
            <translation>verrouiller tous les points</translation>
        </message>
        <message>
            <location filename="../../ui/lens/tools.py" />
            <source>unlock all points</source>
            <translation>déverrouiller tous les points</translation>
        </message>
        <message>
            <location filename="../../ui/lens/tools.py" />
            <source>invert locks</source>
            <translation>inverser les verrous</translation>
        </message>
        <message>
            <location filename="../../ui/lens/tools.py" />
            <source>move the source</source>
            <translation>déplacer la source</translation>
        </message>
        <message>
            <location filename="../../ui/lens/tools.py" />
            <source>move control points</source>
            <translation>déplacer des points de contrôle</translation>
        </message>
        <message>
            <location filename="../../ui/lens/tools.py" />
            <source>lock points</source>
            <translation>verrouiller des points</translation>
        </message>
        <message>
            <location filename="../../ui/lens/tools.py" />
            <source>unlock points</source>
            <translation>déverrouiller des points</translation>
        </message>
        <message>
            <location filename="../../ui/main_window.py" />
            <source>Oldest steps ({count}) forgotten: too much memory to undo</source>
            <translation>Étapes les plus anciennes ({count}) oubliées : trop de mémoire pour annuler</translation>
        </message>
        <message>
            <location filename="../../ui/main_window.py" />
            <source>{design} is still being designed. Stop, and save its best lens?</source>
            <translation>{design} est encore en cours de conception. Arrêter et enregistrer sa meilleure lentille ?</translation>
        </message>
        <message>
            <location filename="../../ui/main_window.py" />
            <source>{design} is still being designed. Stop, and save its best mirror?</source>
            <translation>{design} est encore en cours de conception. Arrêter et enregistrer son meilleur miroir ?</translation>
        </message>
        <message>
            <location filename="../../ui/main_window.py" />
            <source> Changes of the task that wait for the end of the run are given up.</source>
            <translation> Les modifications de la tâche qui attendent la fin de l'exécution sont abandonnées.</translation>
        </message>
        <message>
            <location filename="../../ui/main_window.py" />
            <source>{file} takes the place of {design}, which is being designed.</source>
            <translation>{file} prend la place de {design}, en cours de conception.</translation>
        </message>
        <message>
            <location filename="../../ui/main_window.py" />
            <source>Stop and open</source>
            <translation>Arrêter et ouvrir</translation>
        </message>
        <message>
            <location filename="../../ui/main_window.py" />
            <source>Saved with the last valid value of each marked field.</source>
            <translation>Enregistré avec la dernière valeur valable de chaque champ marqué.</translation>
        </message>
        <message>
            <location filename="../../ui/main_window.py" />
            <source>Saved with the task that the run works on.</source>
            <translation>Enregistré avec la tâche sur laquelle travaille l'exécution.</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cut_fields.py" />
            <source>Tool radius</source>
            <translation>Rayon de l'outil</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cut_fields.py" />
            <source>a radius that fits</source>
            <translation>un rayon qui convient</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cut_fields.py" />
            <source>Radius of the ball. Left empty: that of the design task, or one that fits everywhere.</source>
            <translation>Rayon de la bille. Vide : celui de la tâche, ou un qui convient partout.</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cut_fields.py" />
            <source>Ridges</source>
            <translation>Crêtes</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cut_fields.py" />
            <source>How high ridges between neighbouring cuts may be. Left empty: 1e-4 of the larger half-width, or higher where that takes more moves than a program can have.</source>
            <translation>Hauteur permise des crêtes entre passes voisines. Vide : 1e-4 de la plus grande demi-largeur, ou plus si cela demande plus de mouvements qu'un programme n'en peut avoir.</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cut_fields.py" />
            <source>Clamping rim</source>
            <translation>Bord de serrage</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cut_fields.py" />
            <source>Width of stock around the lens, to hold it by.</source>
            <translation>Largeur de brut autour de la lentille, pour la tenir.</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cut_fields.py" />
            <source>Travel height</source>
            <translation>Hauteur de dégagement</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cut_fields.py" />
            <source>the ball's diameter</source>
            <translation>le diamètre de la bille</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cut_fields.py" />
            <source>How far over its highest cut the cutter travels.</source>
            <translation>À quelle hauteur au-dessus de sa plus haute coupe la fraise se déplace.</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cut_fields.py" />
            <source>fine</source>
            <translation>fin</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cut_fields.py" />
            <source>Feed</source>
            <translation>Avance</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cut_fields.py" />
            <source>How fast the cutter moves while it cuts.</source>
            <translation>Vitesse de la fraise pendant la coupe.</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cut_fields.py" />
            <source>Plunge feed</source>
            <translation>Avance de plongée</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cut_fields.py" />
            <source>How fast the cutter goes down into the stock.</source>
            <translation>La vitesse à laquelle la fraise descend dans le brut.</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cut_fields.py" />
            <source>Spindle speed</source>
            <translation>Vitesse de broche</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cut_fields.py" />
            <source>Revolutions a minute, clockwise.</source>
            <translation>Tours par minute, en sens horaire.</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cut_fields.py" />
            <source>Dwell</source>
            <translation>Temporisation</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cut_fields.py" />
            <source>How long the cutter waits above the stock until the spindle is at its speed.</source>
            <translation>Combien de temps la fraise attend au-dessus du brut que la broche atteigne sa vitesse.</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cut_fields.py" />
            <source>From {least} to {most} {unit}.</source>
            <translation>De {least} à {most} {unit}.</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cut_fields.py" />
            <source>Cut a mould of the face</source>
            <translation>Usiner un moule de la face</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cut_fields.py" />
            <source>The negative: hollows become humps, turned over about the y axis.</source>
            <translation>Le négatif : les creux deviennent des bosses, retourné autour de l'axe y.</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cutter.py" />
            <source>A finishing pass of a ball cutter as G-code in millimetres (GRBL, LinuxCNC). The cut is simulated before it is written: a cutter that leaves too much material standing, or cuts too deep, is refused.</source>
            <translation>Une passe de finition à la fraise hémisphérique en G-code en millimètres (GRBL, LinuxCNC). L'usinage est simulé avant l'écriture : une fraise qui laisse trop de matière ou coupe trop profond est refusée.</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cutter.py" />
            <source>Ball cutter</source>
            <translation>Fraise hémisphérique</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cutter.py" />
            <source>What the cut leaves</source>
            <translation>Ce que laisse l'usinage</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cutter.py" />
            <source>Stop</source>
            <translation>Arrêter</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cutter.py" />
            <source>Stop the simulation; a change of a field begins it anew</source>
            <translation>Arrêter la simulation ; la modification d'un champ la recommence</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cutter.py" />
            <source>&amp;Write G-code…</source>
            <translation>É&amp;crire le G-code…</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cutter.py" />
            <source>&amp;Trace light</source>
            <translation>&amp;Tracer la lumière</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cutter.py" />
            <source>Trace light through what the cut leaves, beside the lens as designed</source>
            <translation>Tracer la lumière à travers ce que l'usinage laisse, à côté de la lentille telle que conçue</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cutter.py" />
            <source>simulation of the cut</source>
            <translation>simulation de l'usinage</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cutter.py" />
            <source>Simulating the cut: {percent} %</source>
            <translation>Simulation de l'usinage : {percent} %</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cutter.py" />
            <source>Tracing: {percent} %</source>
            <translation>Tracé : {percent} %</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cutter.py" />
            <source>Stopped: the cut is not simulated.</source>
            <translation>Arrêté : l'usinage n'est pas simulé.</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cutter.py" />
            <source>Use {radius}</source>
            <translation>Utiliser {radius}</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cutter.py" />
            <source>Up to {cut_off} is cut too deep</source>
            <translation>Jusqu'à {cut_off} sont coupés trop profond</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cutter.py" />
            <source>Radius {radius}, {size:,} moves. {deep}; up to {left} of material is left standing, as ridges or where the ball does not fit.</source>
            <translation>Rayon {radius}, {size:,} mouvements. {deep} ; il reste jusqu'à {left} de matière, en crêtes ou là où la bille n'entre pas.</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cutter.py" />
            <source>Nothing is cut too deep</source>
            <translation>Rien n'est coupé trop profond</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cutter.py" />
            <source>The cutter fits.</source>
            <translation>La fraise convient.</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cutter.py" />
            <source>Polishing takes ridges away.</source>
            <translation>Le polissage enlève les crêtes.</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/face_map.py" />
            <source>Thickness along z</source>
            <translation>Épaisseur selon z</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/face_map.py" />
            <source>Angle between the face and a plane across the axis</source>
            <translation>Angle entre la face et un plan perpendiculaire à l'axe</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/face_map.py" />
            <source>One over the radius of concave places; zero elsewhere</source>
            <translation>Inverse du rayon des endroits concaves ; zéro ailleurs</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/face_map.py" />
            <source>One over the radius of convex places; zero elsewhere</source>
            <translation>Inverse du rayon des endroits convexes ; zéro ailleurs</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/face_map.py" />
            <source>Computed when no run changes it…</source>
            <translation>Calculé quand aucune exécution ne le change…</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/face_map.py" />
            <source>What the map shows</source>
            <translation>Ce que montre la carte</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/face_map.py" />
            <source>; what is beyond a limit is hatched</source>
            <translation> ; ce qui dépasse une limite est hachuré</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>✓ met</source>
            <translation>✓ tenue</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>No place is beyond the limit.</source>
            <translation>Aucun endroit ne dépasse la limite.</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>? open</source>
            <translation>? ouverte</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>No place that was looked at is beyond the limit, but that no other place is, is not proved: {bound} is all that the face surely keeps to.</source>
            <translation>Aucun endroit examiné ne dépasse la limite, mais qu'aucun autre ne le fait n'est pas prouvé : {bound} est tout ce que la face tient sûrement.</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>✗ broken</source>
            <translation>✗ dépassée</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>Some places are beyond the limit; the map shows where.</source>
            <translation>Certains endroits dépassent la limite ; la carte montre où.</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>Slope</source>
            <translation>Pente</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>Largest angle between the face and a plane across the axis</source>
            <translation>Plus grand angle entre la face et un plan perpendiculaire à l'axe</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>Concave radius</source>
            <translation>Rayon concave</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>Smallest radius of curvature of concave places</source>
            <translation>Plus petit rayon de courbure des endroits concaves</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>Convex radius</source>
            <translation>Rayon convexe</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>Smallest radius of curvature of convex places</source>
            <translation>Plus petit rayon de courbure des endroits convexes</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>Largest ball that fits</source>
            <translation>Plus grande bille qui passe</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>Largest radius of a ball cutter that reaches every place of the face. A larger one leaves material standing in hollows</source>
            <translation>Plus grand rayon d'une fraise hémisphérique qui atteint chaque point de la face. Une plus grande laisse de la matière dans les creux</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>Sag range</source>
            <translation>Flèche</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>Height of the highest point of the face over the lowest</source>
            <translation>Hauteur du point le plus haut de la face au-dessus du plus bas</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>Draft</source>
            <translation>Dépouille</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>Least angle between the face and the axis, along which a mould opens</source>
            <translation>Plus petit angle entre la face et l'axe selon lequel s'ouvre un moule</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>Lens</source>
            <translation>Lentille</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>Limit</source>
            <translation>Limite</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>Ball cutter…</source>
            <translation>Fraise hémisphérique…</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>Say how the face is cut, see what the cut leaves, and write G-code</source>
            <translation>Dire comment la face est usinée, voir ce que laisse l'usinage, et écrire le G-code</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>Verdict: {figure}</source>
            <translation>Verdict : {figure}</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>Entrance face</source>
            <translation>Face d'entrée</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>Entrance face: {figure}</source>
            <translation>Face d'entrée : {figure}</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>none</source>
            <translation>sans</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>The face has none.</source>
            <translation>La face n'en a pas.</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>At x = {x}, y = {y}. Nowhere beyond {bound}.</source>
            <translation>À x = {x}, y = {y}. Nulle part au-delà de {bound}.</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/limits.py" />
            <source>Thinnest</source>
            <translation>Plus mince</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/limits.py" />
            <source>The part has to be as thick as this everywhere</source>
            <translation>La pièce doit avoir partout cette épaisseur</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/limits.py" />
            <source>Thickest</source>
            <translation>Plus épais</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/limits.py" />
            <source>The part must not be thicker than this anywhere</source>
            <translation>La pièce ne doit nulle part être plus épaisse</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/limits.py" />
            <source>Largest angle between a freeform face and a plane across the axis, in degrees</source>
            <translation>Plus grand angle entre une face de forme libre et un plan perpendiculaire à l'axe, en degrés</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/limits.py" />
            <source>Smallest radius that a tool can cut, of concave and convex places</source>
            <translation>Plus petit rayon qu'un outil peut usiner, des endroits concaves et convexes</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/limits.py" />
            <source>Radius of the ball cutter that has to reach every place of the face. One that is too large for a hollow leaves material standing there</source>
            <translation>Rayon de la fraise hémisphérique qui doit atteindre chaque point de la face. Une fraise trop grande pour un creux y laisse de la matière</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/limits.py" />
            <source>Empty: what the design task keeps to, if anything. Kept for the next start.</source>
            <translation>Vide : ce que la tâche respecte, s'il y a lieu. Gardé pour le prochain démarrage.</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/limits.py" />
            <source>Limit: {label}</source>
            <translation>Limite : {label}</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/limits.py" />
            <source>{value:g}; a number above 0, or nothing</source>
            <translation>{value:g} ; un nombre au-dessus de 0, ou rien</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/pane.py" />
            <source>look at the face</source>
            <translation>examen de la face</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/pane.py" />
            <source>Out of date: of the lens before; computed anew when it rests.</source>
            <translation>Périmé : de la lentille précédente ; recalculé quand elle est au repos.</translation>
        </message>
        <message>
            <location filename="../../ui/notices/carried_lens.py" />
            <source>The lens does not fit the new outline: Start designs another one, Undo brings it back.</source>
            <translation>La lentille ne convient pas au nouveau contour : Démarrer en conçoit une autre, Annuler la ramène.</translation>
        </message>
        <message>
            <location filename="../../ui/notices/carried_lens.py" />
            <source>The mirror does not fit the new outline: Start designs another one, Undo brings it back.</source>
            <translation>Le miroir ne convient pas au nouveau contour : Démarrer en conçoit un autre, Annuler le ramène.</translation>
        </message>
        <message>
            <location filename="../../ui/notices/carried_lens.py" />
            <source>The entrance face is freeform now, and flat so far. Continue shapes both faces, and Undo takes the change back.</source>
            <translation>La face d'entrée est désormais de forme libre, et encore plane. Continuer façonne les deux faces, Annuler retire la modification.</translation>
        </message>
        <message>
            <location filename="../../ui/notices/carried_lens.py" />
            <source>The entrance face is flat now; the exit face stays as it was, but it was made for the light of both. Continue shapes it alone, and Undo takes the change back.</source>
            <translation>La face d'entrée est désormais plane ; la face de sortie reste telle quelle, mais elle était faite pour la lumière des deux. Continuer la façonne seule, Annuler retire la modification.</translation>
        </message>
        <message>
            <location filename="../../ui/notices/carried_lens.py" />
            <source>The lens is changed by up to {moved} to be within its new limits. Continue goes on from there, and Undo takes the change back.</source>
            <translation>La lentille change de {moved} au plus pour rester dans ses nouvelles limites. Continuer repart de là, Annuler retire la modification.</translation>
        </message>
        <message>
            <location filename="../../ui/notices/carried_lens.py" />
            <source>The mirror is changed by up to {moved} to be within its new limits. Continue goes on from there, and Undo takes the change back.</source>
            <translation>Le miroir change de {moved} au plus pour rester dans ses nouvelles limites. Continuer repart de là, Annuler retire la modification.</translation>
        </message>
        <message>
            <location filename="../../ui/notices/carried_lens.py" />
            <source>The program takes {size} control points now. Continue goes on from the lens that was there, carried over, and Undo takes the change back.</source>
            <translation>Le programme prend maintenant {size} points de contrôle. Continuer repart de la lentille précédente, transposée, Annuler retire la modification.</translation>
        </message>
        <message>
            <location filename="../../ui/notices/carried_lens.py" />
            <source>The program takes {size} control points now. Continue goes on from the mirror that was there, carried over, and Undo takes the change back.</source>
            <translation>Le programme prend maintenant {size} points de contrôle. Continuer repart du miroir précédent, transposé, Annuler retire la modification.</translation>
        </message>
        <message>
            <location filename="../../ui/notices/carried_lens.py" />
            <source>The lens was designed for another task and is a start for this one: Continue goes on from it, Start over does not</source>
            <translation>La lentille a été conçue pour une autre tâche et sert de départ à celle-ci : Continuer repart d'elle, Recommencer non</translation>
        </message>
        <message>
            <location filename="../../ui/notices/carried_lens.py" />
            <source>The mirror was designed for another task and is a start for this one: Continue goes on from it, Start over does not</source>
            <translation>Le miroir a été conçu pour une autre tâche et sert de départ à celle-ci : Continuer repart de lui, Recommencer non</translation>
        </message>
        <message>
            <location filename="../../ui/notices/carried_lens.py" />
            <source>On {size} control points {name} is the same.</source>
            <translation>Sur {size} points de contrôle, inchangé : {name}.</translation>
        </message>
        <message>
            <location filename="../../ui/notices/carried_lens.py" />
            <source>Take {size}, exact</source>
            <translation>Prendre {size}, exact</translation>
        </message>
        <message>
            <location filename="../../ui/notices/carried_lens.py" />
            <source>On {size} control points {name} is off by up to {off}. Continue goes on from there, Start over from nothing, and Undo takes the change back.</source>
            <translation>Sur {size} points de contrôle, {name} s'écarte de {off} au plus. Continuer repart de là, Recommencer de rien, Annuler retire la modification.</translation>
        </message>
        <message>
            <location filename="../../ui/notices/carried_lens.py" />
            <source>change of {name}</source>
            <translation>modification : {name}</translation>
        </message>
        <message>
            <location filename="../../ui/notices/carried_lens.py" />
            <source>control points</source>
            <translation>points de contrôle</translation>
        </message>
        <message>
            <location filename="../../ui/notices/carried_lens.py" />
            <source>the lens</source>
            <translation>la lentille</translation>
        </message>
        <message>
            <location filename="../../ui/notices/carried_lens.py" />
            <source>the mirror</source>
            <translation>le miroir</translation>
        </message>
        <message>
            <location filename="../../ui/notices/carried_lens.py" />
            <source>the entrance face</source>
            <translation>la face d'entrée</translation>
        </message>
        <message>
            <location filename="../../ui/notices/coarse_net.py" />
            <source>Refine and start over</source>
            <translation>Affiner et recommencer</translation>
        </message>
        <message>
            <location filename="../../ui/notices/coarse_net.py" />
            <source>automatic control points</source>
            <translation>points de contrôle automatiques</translation>
        </message>
        <message>
            <location filename="../../ui/notices/postponed_edits.py" />
            <source>Stop and apply</source>
            <translation>Arrêter et appliquer</translation>
        </message>
        <message>
            <location filename="../../ui/notices/postponed_edits.py" />
            <source>Take back</source>
            <translation>Reprendre</translation>
        </message>
        <message>
            <location filename="../../ui/notices/refused_fields.py" />
            <source> ({count} more refused)</source>
            <translation> ({count} autres refusés)</translation>
        </message>
        <message>
            <location filename="../../ui/notices/refused_fields.py" />
            <source>{first}{others}. Correct it, or press Esc, first.</source>
            <translation>{first}{others}. Corriger d'abord, ou appuyer sur Échap.</translation>
        </message>
        <message>
            <location filename="../../ui/notices/shortfall.py" />
            <source>The run goes on within these limits.</source>
            <translation>L'exécution se poursuit dans ces limites.</translation>
        </message>
        <message>
            <location filename="../../ui/notices/shortfall.py" />
            <source>Stop and widen</source>
            <translation>Arrêter et élargir</translation>
        </message>
        <message>
            <location filename="../../ui/notices/shortfall.py" />
            <source>Widen</source>
            <translation>Élargir</translation>
        </message>
        <message>
            <location filename="../../ui/notices/shortfall.py" />
            <source>Continue</source>
            <translation>Continuer</translation>
        </message>
        <message>
            <location filename="../../ui/notices/shortfall.py" />
            <source>automatic height range</source>
            <translation>plage de hauteur automatique</translation>
        </message>
        <message>
            <location filename="../../ui/notices/shortfall.py" />
            <source>wider height range</source>
            <translation>plage de hauteur plus large</translation>
        </message>
        <message>
            <location filename="../../ui/notices/shortfall.py" />
            <source>wider entrance range</source>
            <translation>plage d'entrée plus large</translation>
        </message>
        <message>
            <location filename="../../ui/notices/shortfall.py" />
            <source>The height range follows from the task now</source>
            <translation>La plage de hauteur suit désormais de la tâche</translation>
        </message>
        <message>
            <location filename="../../ui/notices/shortfall.py" />
            <source>The height range is {low:.3g} to {high:.3g} {unit} now</source>
            <translation>La plage de hauteur est désormais de {low:.3g} à {high:.3g} {unit}</translation>
        </message>
        <message>
            <location filename="../../ui/notices/shortfall.py" />
            <source>The entrance range is {low:.3g} to {high:.3g} {unit} now</source>
            <translation>La plage d'entrée est désormais de {low:.3g} à {high:.3g} {unit}</translation>
        </message>
        <message>
            <location filename="../../ui/notices/shortfall.py" />
            <source>{said}, and the lens is as it was. Start over mostly finds a better one than Continue does.</source>
            <translation>{said} ; la lentille est inchangée. Recommencer en trouve le plus souvent une meilleure que Continuer.</translation>
        </message>
        <message>
            <location filename="../../ui/notices/shortfall.py" />
            <source>{said}, and the mirror is as it was. Start over mostly finds a better one than Continue does.</source>
            <translation>{said} ; le miroir est inchangé. Recommencer en trouve le plus souvent un meilleur que Continuer.</translation>
        </message>
        <message>
            <location filename="../../ui/notices/shortfall.py" />
            <source>Start over</source>
            <translation>Recommencer</translation>
        </message>
        <message>
            <location filename="../../ui/notices/target_image.py" />
            <source>{image} has changed. The design keeps the picture that it has.</source>
            <translation>{image} a changé. La conception garde l'image qu'elle a.</translation>
        </message>
        <message>
            <location filename="../../ui/notices/target_image.py" />
            <source>Read it again</source>
            <translation>Lire à nouveau</translation>
        </message>
        <message>
            <location filename="../../ui/notices/total_reflection.py" />
            <source>{where}, as marked in the 3D scene: {cure}.</source>
            <translation>{where}, comme marqué dans la scène 3D : {cure}.</translation>
        </message>
        <message>
            <location filename="../../ui/notices/total_reflection.py" />
            <source>search for total reflection</source>
            <translation>recherche de réflexion totale</translation>
        </message>
        <message>
            <location filename="../../ui/notices/unit_change.py" />
            <source>All lengths are converted: 1 {old} is {ratio:.6g} {new} now.</source>
            <translation>Toutes les longueurs sont converties : 1 {old} vaut maintenant {ratio:.6g} {new}.</translation>
        </message>
        <message>
            <location filename="../../ui/notices/unit_change.py" />
            <source>Keep the numbers</source>
            <translation>Garder les nombres</translation>
        </message>
        <message>
            <location filename="../../ui/notices/unit_change.py" />
            <source>change of unit alone</source>
            <translation>changement d'unité seul</translation>
        </message>
        <message>
            <location filename="../../ui/panels/auto_row.py" />
            <source>Auto</source>
            <translation>Auto</translation>
        </message>
        <message>
            <location filename="../../ui/panels/auto_row.py" />
            <source>{label}, automatic</source>
            <translation>{label}, automatique</translation>
        </message>
        <message>
            <location filename="../../ui/panels/auto_row.py" />
            <source>auto</source>
            <translation>auto</translation>
        </message>
        <message>
            <location filename="../../ui/panels/edits.py" />
            <source>this task has no such field any more</source>
            <translation>cette tâche n'a plus de tel champ</translation>
        </message>
        <message>
            <location filename="../../ui/panels/element_list.py" />
            <source>element</source>
            <translation>élément</translation>
        </message>
        <message>
            <location filename="../../ui/panels/element_list.py" />
            <source>Elements</source>
            <translation>Éléments</translation>
        </message>
        <message>
            <location filename="../../ui/panels/element_list.py" />
            <source>Add a plano-convex lens of fixed shape behind the last element</source>
            <translation>Ajouter une lentille plan-convexe de forme fixe derrière le dernier élément</translation>
        </message>
        <message>
            <location filename="../../ui/panels/element_list.py" />
            <source>Add a plane mirror behind the last element</source>
            <translation>Ajouter un miroir plan derrière le dernier élément</translation>
        </message>
        <message>
            <location filename="../../ui/panels/element_list.py" />
            <source>Add a copy of the chosen element behind the last element</source>
            <translation>Ajouter une copie de l'élément choisi derrière le dernier élément</translation>
        </message>
        <message>
            <location filename="../../ui/panels/element_list.py" />
            <source>Remove the chosen element</source>
            <translation>Retirer l'élément choisi</translation>
        </message>
        <message>
            <location filename="../../ui/panels/element_list.py" />
            <source>Exchange the chosen element with the one before it, along z too</source>
            <translation>Échanger l'élément choisi avec celui qui le précède, selon z aussi</translation>
        </message>
        <message>
            <location filename="../../ui/panels/element_list.py" />
            <source>Exchange the chosen element with the one behind it, along z too</source>
            <translation>Échanger l'élément choisi avec celui qui le suit, selon z aussi</translation>
        </message>
        <message>
            <location filename="../../ui/panels/element_list.py" />
            <source>Add lens</source>
            <translation>Ajouter une lentille</translation>
        </message>
        <message>
            <location filename="../../ui/panels/element_list.py" />
            <source>Add mirror</source>
            <translation>Ajouter un miroir</translation>
        </message>
        <message>
            <location filename="../../ui/panels/element_list.py" />
            <source>designed</source>
            <translation>à concevoir</translation>
        </message>
        <message>
            <location filename="../../ui/panels/elements.py" />
            <source>Optical train</source>
            <translation>Train optique</translation>
        </message>
        <message>
            <location filename="../../ui/panels/elements.py" />
            <source>Kind</source>
            <translation>Genre</translation>
        </message>
        <message>
            <location filename="../../ui/panels/elements.py" />
            <source>Custom index</source>
            <translation>Indice propre</translation>
        </message>
        <message>
            <location filename="../../ui/panels/elements.py" />
            <source>Automatic</source>
            <translation>Automatique</translation>
        </message>
        <message>
            <location filename="../../ui/panels/elements.py" />
            <source>Own limits</source>
            <translation>Limites propres</translation>
        </message>
        <message>
            <location filename="../../ui/panels/elements.py" />
            <source>From the base</source>
            <translation>Depuis la base</translation>
        </message>
        <message>
            <location filename="../../ui/panels/elements.py" />
            <source>How far a control point may move from the base, down and up. A wider range bends light further.</source>
            <translation>De combien un point de contrôle peut s'écarter de la base, vers le bas et le haut. Une plage plus large dévie davantage la lumière.</translation>
        </message>
        <message>
            <location filename="../../ui/panels/fields.py" />
            <source>{label}, {number} of {count}</source>
            <translation>{label}, {number} sur {count}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/forms.py" />
            <source>refused {edit}</source>
            <translation>refusé : {edit}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/forms.py" />
            <source>flat entrance face</source>
            <translation>face d'entrée plane</translation>
        </message>
        <message>
            <location filename="../../ui/panels/forms.py" />
            <source>freeform entrance face</source>
            <translation>face d'entrée de forme libre</translation>
        </message>
        <message>
            <location filename="../../ui/panels/forms.py" />
            <source>The target is no picture: only a picture has an aspect.</source>
            <translation>La cible n'est pas une image : seule une image a un format.</translation>
        </message>
        <message>
            <location filename="../../ui/panels/forms.py" />
            <source>The picture has no aspect: {refused}</source>
            <translation>L'image n'a pas de format : {refused}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/forms.py" />
            <source>screen of the picture's aspect</source>
            <translation>écran au format de l'image</translation>
        </message>
        <message>
            <location filename="../../ui/panels/forms.py" />
            <source>far field of the picture's aspect</source>
            <translation>champ lointain au format de l'image</translation>
        </message>
        <message>
            <location filename="../../ui/panels/forms.py" />
            <source>The design is paused. Changes wait until it ends.</source>
            <translation>La conception est en pause. Les modifications attendent sa fin.</translation>
        </message>
        <message>
            <location filename="../../ui/panels/forms.py" />
            <source>The design is running. Changes wait until it ends.</source>
            <translation>La conception est en cours. Les modifications attendent sa fin.</translation>
        </message>
        <message>
            <location filename="../../ui/panels/forms.py" />
            <source>Refused: {refused}</source>
            <translation>Refusé : {refused}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/forms.py" />
            <source>The {edit} is refused: {refused}</source>
            <translation>Refusé ({edit}) : {refused}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/forms.py" />
            <source>Stop the run first; then read the image again.</source>
            <translation>Arrêter d'abord l'exécution ; puis relire l'image.</translation>
        </message>
        <message>
            <location filename="../../ui/panels/forms.py" />
            <source>Waits for the end of the run: {edits}.</source>
            <translation>Attend la fin de l'exécution : {edits}.</translation>
        </message>
        <message>
            <location filename="../../ui/panels/image_list.py" />
            <source>image</source>
            <translation>image</translation>
        </message>
        <message>
            <location filename="../../ui/panels/image_list.py" />
            <source>Images</source>
            <translation>Images</translation>
        </message>
        <message>
            <location filename="../../ui/panels/image_list.py" />
            <source>Add an image farther away, with the target of the last one</source>
            <translation>Ajouter une image plus loin, avec la cible de la dernière</translation>
        </message>
        <message>
            <location filename="../../ui/panels/image_list.py" />
            <source>Add a copy of the chosen image behind it</source>
            <translation>Ajouter une copie de l'image choisie après elle</translation>
        </message>
        <message>
            <location filename="../../ui/panels/image_list.py" />
            <source>Remove the chosen image</source>
            <translation>Retirer l'image choisie</translation>
        </message>
        <message>
            <location filename="../../ui/panels/image_list.py" />
            <source>Move the chosen image up</source>
            <translation>Monter l'image choisie</translation>
        </message>
        <message>
            <location filename="../../ui/panels/image_list.py" />
            <source>Move the chosen image down</source>
            <translation>Descendre l'image choisie</translation>
        </message>
        <message>
            <location filename="../../ui/panels/image_list.py" />
            <source>The panels Target and Receiver have the settings of image 1.</source>
            <translation>Les panneaux Cible et Récepteur contiennent les réglages de l'image 1.</translation>
        </message>
        <message>
            <location filename="../../ui/panels/image_list.py" />
            <source>{place}, {target}, weight {weight:g}</source>
            <translation>{place}, {target}, poids {weight:g}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/images.py" />
            <source>Image {number}</source>
            <translation>Image {number}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/images.py" />
            <source>change of target image</source>
            <translation>changement d'image cible</translation>
        </message>
        <message>
            <location filename="../../ui/panels/panel.py" />
            <source>{panel} {field}</source>
            <translation>{panel}, {field}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/part_list.py" />
            <source>Add</source>
            <translation>Ajouter</translation>
        </message>
        <message>
            <location filename="../../ui/panels/part_list.py" />
            <source>Duplicate</source>
            <translation>Dupliquer</translation>
        </message>
        <message>
            <location filename="../../ui/panels/part_list.py" />
            <source>Remove</source>
            <translation>Retirer</translation>
        </message>
        <message>
            <location filename="../../ui/panels/part_list.py" />
            <source>Up</source>
            <translation>Monter</translation>
        </message>
        <message>
            <location filename="../../ui/panels/part_list.py" />
            <source>Down</source>
            <translation>Descendre</translation>
        </message>
        <message>
            <location filename="../../ui/panels/part_list.py" />
            <source>new {part}</source>
            <translation>nouveau : {part}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/part_list.py" />
            <source>copy of {part} {number}</source>
            <translation>copie : {part} {number}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/part_list.py" />
            <source>removal of {part} {number}</source>
            <translation>retrait : {part} {number}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/part_list.py" />
            <source>move of {part} {number}</source>
            <translation>déplacement : {part} {number}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/region_list.py" />
            <source>region</source>
            <translation>région</translation>
        </message>
        <message>
            <location filename="../../ui/panels/region_list.py" />
            <source>Regions</source>
            <translation>Régions</translation>
        </message>
        <message>
            <location filename="../../ui/panels/region_list.py" />
            <source>Add a region in the middle</source>
            <translation>Ajouter une région au milieu</translation>
        </message>
        <message>
            <location filename="../../ui/panels/region_list.py" />
            <source>Add a copy of the chosen region behind it</source>
            <translation>Ajouter une copie de la région choisie après elle</translation>
        </message>
        <message>
            <location filename="../../ui/panels/region_list.py" />
            <source>Remove the chosen region</source>
            <translation>Retirer la région choisie</translation>
        </message>
        <message>
            <location filename="../../ui/panels/region_list.py" />
            <source>Move the chosen region up</source>
            <translation>Monter la région choisie</translation>
        </message>
        <message>
            <location filename="../../ui/panels/region_list.py" />
            <source>Move the chosen region down</source>
            <translation>Descendre la région choisie</translation>
        </message>
        <message>
            <location filename="../../ui/panels/region_list.py" />
            <source>None.</source>
            <translation>Aucune.</translation>
        </message>
        <message>
            <location filename="../../ui/panels/region_list.py" />
            <source>Region {count}</source>
            <translation>Région {count}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/regions.py" />
            <source>Watched</source>
            <translation>Observées</translation>
        </message>
        <message>
            <location filename="../../ui/panels/regions.py" />
            <source>Region {number}</source>
            <translation>Région {number}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/regions.py" />
            <source>Shape</source>
            <translation>Forme</translation>
        </message>
        <message>
            <location filename="../../ui/panels/regions.py" />
            <source>As x, y; x, y; …</source>
            <translation>Sous la forme x, y; x, y; …</translation>
        </message>
        <message>
            <location filename="../../ui/panels/run.py" />
            <source>Parameters</source>
            <translation>Paramètres</translation>
        </message>
        <message>
            <location filename="../../ui/panels/run.py" />
            <source>How many numbers are optimised, and the memory that they take with their gradient and the optimiser's two moments. A network that does not fit is refused at the start.</source>
            <translation>Combien de nombres sont optimisés, et la mémoire qu'ils prennent avec leur gradient et les deux moments de l'optimiseur. Un réseau trop grand est refusé au départ.</translation>
        </message>
        <message>
            <location filename="../../ui/panels/scene.py" />
            <source>Scene</source>
            <translation>Scène</translation>
        </message>
        <message>
            <location filename="../../ui/panels/scene.py" />
            <source>change of unit</source>
            <translation>changement d'unité</translation>
        </message>
        <message>
            <location filename="../../ui/panels/source.py" />
            <source>Files of light ({endings});;All files (*)</source>
            <translation>Fichiers de lumière ({endings});;Tous les fichiers (*)</translation>
        </message>
        <message>
            <location filename="../../ui/panels/source.py" />
            <source>change of file of light</source>
            <translation>changement de fichier de lumière</translation>
        </message>
        <message>
            <location filename="../../ui/panels/source.py" />
            <source>The design keeps files of up to {largest} MB.</source>
            <translation>La conception garde les fichiers jusqu'à {largest} Mo.</translation>
        </message>
        <message>
            <location filename="../../ui/panels/source.py" />
            <source>Choose a file of light</source>
            <translation>Choisir un fichier de lumière</translation>
        </message>
        <message>
            <location filename="../../ui/panels/stage_list.py" />
            <source>In turn</source>
            <translation>Tour à tour</translation>
        </message>
        <message>
            <location filename="../../ui/panels/stage_list.py" />
            <source>A run goes through these stages before the scene itself, each going on from the lens of the one before: from a point source to an extended one, say, or from a coarse net to a fine one.</source>
            <translation>Une exécution passe par ces étapes avant la scène elle-même, chacune à partir de la lentille de la précédente : d'une source ponctuelle à une étendue, par exemple, ou d'un réseau grossier à un fin.</translation>
        </message>
        <message>
            <location filename="../../ui/panels/stage_list.py" />
            <source>stage</source>
            <translation>étape</translation>
        </message>
        <message>
            <location filename="../../ui/panels/stage_list.py" />
            <source>Stages of the run</source>
            <translation>Étapes de l'exécution</translation>
        </message>
        <message>
            <location filename="../../ui/panels/stage_list.py" />
            <source>Add a stage behind the others</source>
            <translation>Ajouter une étape après les autres</translation>
        </message>
        <message>
            <location filename="../../ui/panels/stage_list.py" />
            <source>Add a copy of the chosen stage behind it</source>
            <translation>Ajouter une copie de l'étape choisie après elle</translation>
        </message>
        <message>
            <location filename="../../ui/panels/stage_list.py" />
            <source>Remove the chosen stage</source>
            <translation>Retirer l'étape choisie</translation>
        </message>
        <message>
            <location filename="../../ui/panels/stage_list.py" />
            <source>Run the chosen stage sooner</source>
            <translation>Exécuter plus tôt l'étape choisie</translation>
        </message>
        <message>
            <location filename="../../ui/panels/stage_list.py" />
            <source>Run the chosen stage later</source>
            <translation>Exécuter plus tard l'étape choisie</translation>
        </message>
        <message>
            <location filename="../../ui/panels/stage_list.py" />
            <source>Then the scene as it stands, {iterations}.</source>
            <translation>Puis la scène telle quelle, {iterations}.</translation>
        </message>
        <message>
            <location filename="../../ui/panels/stage_list.py" />
            <source>None: the scene is run as it stands.</source>
            <translation>Aucune : la scène est exécutée telle quelle.</translation>
        </message>
        <message>
            <location filename="../../ui/panels/stage_list.py" />
            <source>net of {n_u} × {n_v}</source>
            <translation>réseau de {n_u} × {n_v}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/stage_list.py" />
            <source>{kind} filter</source>
            <translation>filtre : {kind}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/stage_list.py" />
            <source>1 iteration</source>
            <translation>1 itération</translation>
        </message>
        <message>
            <location filename="../../ui/panels/stage_list.py" />
            <source>{count} iterations</source>
            <translation>{count} itérations</translation>
        </message>
        <message>
            <location filename="../../ui/panels/stages.py" />
            <source>As the scene</source>
            <translation>Comme la scène</translation>
        </message>
        <message>
            <location filename="../../ui/panels/stages.py" />
            <source>Stages</source>
            <translation>Étapes</translation>
        </message>
        <message>
            <location filename="../../ui/panels/stages.py" />
            <source>Stage {number}</source>
            <translation>Étape {number}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/target.py" />
            <source>Images ({endings});;All files (*)</source>
            <translation>Images ({endings});;Tous les fichiers (*)</translation>
        </message>
        <message>
            <location filename="../../ui/panels/target.py" />
            <source>An image file can also be dropped onto the window.</source>
            <translation>Un fichier d'image peut aussi être déposé sur la fenêtre.</translation>
        </message>
        <message>
            <location filename="../../ui/panels/target.py" />
            <source>The design keeps images of up to {largest} MB.</source>
            <translation>La conception garde les images jusqu'à {largest} Mo.</translation>
        </message>
        <message>
            <location filename="../../ui/panels/target.py" />
            <source>Choose an image file</source>
            <translation>Choisir un fichier d'image</translation>
        </message>
        <message>
            <location filename="../../ui/panels/target.py" />
            <source>The light that is wanted on the screen, as its viewer sees it</source>
            <translation>La lumière voulue sur l'écran, telle que la voit son observateur</translation>
        </message>
        <message>
            <location filename="../../ui/run/bound.py" />
            <source>bound</source>
            <translation>borne</translation>
        </message>
        <message>
            <location filename="../../ui/run/bound.py" />
            <source>at best {error}</source>
            <translation>au mieux {error}</translation>
        </message>
        <message>
            <location filename="../../ui/run/bound.py" />
            <source>There can be {bound}; {error} with a source half as wide. This is the least relative L2 error, certified; freeform bound tells more.</source>
            <translation>Possible : {bound} ; {error} avec une source deux fois moins large. C'est la plus petite erreur L2 relative, certifiée ; « freeform bound » en dit plus.</translation>
        </message>
        <message>
            <location filename="../../ui/run/comparison.py" />
            <source>The scenes are the same</source>
            <translation>Les scènes sont identiques</translation>
        </message>
        <message>
            <location filename="../../ui/run/comparison.py" />
            <source>Fields of the scenes that differ</source>
            <translation>Champs des scènes qui diffèrent</translation>
        </message>
        <message>
            <location filename="../../ui/run/comparison.py" />
            <source>Point at an image to read its light</source>
            <translation>Pointer une image pour lire sa lumière</translation>
        </message>
        <message>
            <location filename="../../ui/run/comparison.py" />
            <source>Comparison of two runs</source>
            <translation>Comparaison de deux exécutions</translation>
        </message>
        <message>
            <location filename="../../ui/run/comparison.py" />
            <source>Image that is shown</source>
            <translation>Image affichée</translation>
        </message>
        <message>
            <location filename="../../ui/run/comparison.py" />
            <source>Which of the scenes' images is shown, in pictures and figures</source>
            <translation>Laquelle des images des scènes est affichée, dans les images et les chiffres</translation>
        </message>
        <message>
            <location filename="../../ui/run/comparison.py" />
            <source>Light under the pointer</source>
            <translation>Lumière sous le pointeur</translation>
        </message>
        <message>
            <location filename="../../ui/run/comparison.py" />
            <source>Figures of both runs</source>
            <translation>Chiffres des deux exécutions</translation>
        </message>
        <message>
            <location filename="../../ui/run/control.py" />
            <source>return to iteration {number}</source>
            <translation>retour à l'itération {number}</translation>
        </message>
        <message>
            <location filename="../../ui/run/control.py" />
            <source>design run</source>
            <translation>exécution de la conception</translation>
        </message>
        <message>
            <location filename="../../ui/run/follow.py" />
            <source>Following: the first design is under way</source>
            <translation>Suivi : la première conception est en cours</translation>
        </message>
        <message>
            <location filename="../../ui/run/follow.py" />
            <source>Following: the first design takes long here; edits wait for a pause</source>
            <translation>Suivi : la première conception est longue ici ; les modifications attendent une pause</translation>
        </message>
        <message>
            <location filename="../../ui/run/follow.py" />
            <source>design of the lens that was missing</source>
            <translation>conception de la lentille manquante</translation>
        </message>
        <message>
            <location filename="../../ui/run/follow.py" />
            <source>design of the mirror that was missing</source>
            <translation>conception du miroir manquant</translation>
        </message>
        <message>
            <location filename="../../ui/run/follow.py" />
            <source>Following: error {error:.1f} %, still getting better</source>
            <translation>Suivi : erreur {error:.1f} %, encore en baisse</translation>
        </message>
        <message>
            <location filename="../../ui/run/follow.py" />
            <source>design of the lens</source>
            <translation>conception de la lentille</translation>
        </message>
        <message>
            <location filename="../../ui/run/follow.py" />
            <source>design of the mirror</source>
            <translation>conception du miroir</translation>
        </message>
        <message>
            <location filename="../../ui/run/kept.py" />
            <source>Run {number}: {description}</source>
            <translation>Exécution {number} : {description}</translation>
        </message>
        <message>
            <location filename="../../ui/run/kept.py" />
            <source>Followed {number}: {description}</source>
            <translation>Suivi {number} : {description}</translation>
        </message>
        <message>
            <location filename="../../ui/run/lens_on_show.py" />
            <source>There is no result yet, or its light is still being traced; try again in a moment.</source>
            <translation>Il n'y a pas encore de résultat, ou sa lumière est encore en cours de tracé ; réessayer dans un instant.</translation>
        </message>
        <message>
            <location filename="../../ui/run/lens_on_show.py" />
            <source>the best lens so far, after {count} iterations</source>
            <translation>la meilleure lentille jusqu'ici, après {count} itérations</translation>
        </message>
        <message>
            <location filename="../../ui/run/lens_on_show.py" />
            <source>the best mirror so far, after {count} iterations</source>
            <translation>le meilleur miroir jusqu'ici, après {count} itérations</translation>
        </message>
        <message>
            <location filename="../../ui/run/lens_on_show.py" />
            <source>the lens on show, {origin}</source>
            <translation>la lentille affichée, {origin}</translation>
        </message>
        <message>
            <location filename="../../ui/run/lens_on_show.py" />
            <source>the mirror on show, {origin}</source>
            <translation>le miroir affiché, {origin}</translation>
        </message>
        <message>
            <location filename="../../ui/run/log.py" />
            <source>Run paused</source>
            <translation>Exécution en pause</translation>
        </message>
        <message>
            <location filename="../../ui/run/log.py" />
            <source>Run resumed</source>
            <translation>Exécution reprise</translation>
        </message>
        <message>
            <location filename="../../ui/run/log.py" />
            <source>Stop asked for</source>
            <translation>Arrêt demandé</translation>
        </message>
        <message>
            <location filename="../../ui/run/log.py" />
            <source>{name} is kept no longer: kept runs would take too much memory</source>
            <translation>{name} n'est plus gardé : les exécutions gardées prendraient trop de mémoire</translation>
        </message>
        <message>
            <location filename="../../ui/run/log.py" />
            <source>Run begins: {name}, method {method}</source>
            <translation>Début d'exécution : {name}, méthode {method}</translation>
        </message>
        <message>
            <location filename="../../ui/run/log.py" />
            <source> at iteration {iteration}</source>
            <translation> à l'itération {iteration}</translation>
        </message>
        <message>
            <location filename="../../ui/run/log.py" />
            <source>Stage {stage} of {stages}, iteration {iteration}</source>
            <translation>Étape {stage} sur {stages}, itération {iteration}</translation>
        </message>
        <message>
            <location filename="../../ui/run/log.py" />
            <source>Trace: {notes}</source>
            <translation>Tracé : {notes}</translation>
        </message>
        <message>
            <location filename="../../ui/run/log.py" />
            <source>Run ended before its first lens</source>
            <translation>Exécution terminée avant sa première lentille</translation>
        </message>
        <message>
            <location filename="../../ui/run/log.py" />
            <source>Run ended before its first mirror</source>
            <translation>Exécution terminée avant son premier miroir</translation>
        </message>
        <message>
            <location filename="../../ui/run/log.py" />
            <source>Run ended{why} after iteration {iteration} of {iterations}, {clock}: last loss {loss}, {efficiency:.1f} % {place}</source>
            <translation>Exécution terminée{why} après l'itération {iteration} sur {iterations}, {clock} : dernier coût {loss}, {efficiency:.1f} % {place}</translation>
        </message>
        <message>
            <location filename="../../ui/run/run_check.py" />
            <source>check of the run</source>
            <translation>vérification de l'exécution</translation>
        </message>
        <message>
            <location filename="../../ui/run/run_check.py" />
            <source>Checked error {error} at {iteration}</source>
            <translation>Erreur vérifiée {error} à {iteration}</translation>
        </message>
        <message>
            <location filename="../../ui/run/runner.py" />
            <source>run</source>
            <translation>exécution</translation>
        </message>
        <message>
            <location filename="../../ui/run/runs.py" />
            <source>Choose one run in View &gt; Runs first.</source>
            <translation>Choisir d'abord une exécution dans Affichage &gt; Exécutions.</translation>
        </message>
        <message>
            <location filename="../../ui/run/runs.py" />
            <source>Choose runs in View &gt; Runs first.</source>
            <translation>Choisir d'abord des exécutions dans Affichage &gt; Exécutions.</translation>
        </message>
        <message>
            <location filename="../../ui/run/runs.py" />
            <source>Choose two runs in View &gt; Runs first: Ctrl and a click.</source>
            <translation>Choisir d'abord deux exécutions dans Affichage &gt; Exécutions : Ctrl et clic.</translation>
        </message>
        <message>
            <location filename="../../ui/run/runs.py" />
            <source>rename run</source>
            <translation>renommer l'exécution</translation>
        </message>
        <message>
            <location filename="../../ui/run/runs.py" />
            <source>The run is still called {name}: {reason}</source>
            <translation>L'exécution s'appelle toujours {name} : {reason}</translation>
        </message>
        <message>
            <location filename="../../ui/run/runs.py" />
            <source>return to {name}</source>
            <translation>retour à {name}</translation>
        </message>
        <message>
            <location filename="../../ui/run/runs.py" />
            <source>delete {name}</source>
            <translation>suppression de {name}</translation>
        </message>
        <message>
            <location filename="../../ui/run/runs.py" />
            <source>delete {count} runs</source>
            <translation>suppression de {count} exécutions</translation>
        </message>
        <message>
            <location filename="../../ui/run/status.py" />
            <source>iteration {done} of {count}{rate}</source>
            <translation>itération {done} sur {count}{rate}</translation>
        </message>
        <message>
            <location filename="../../ui/run/status.py" />
            <source>Error {error} · light {place} {shares}</source>
            <translation>Erreur {error} · lumière {place} {shares}</translation>
        </message>
        <message>
            <location filename="../../ui/run/status.py" />
            <source>loss {loss}</source>
            <translation>coût {loss}</translation>
        </message>
        <message>
            <location filename="../../ui/run/status.py" />
            <source>{time} elapsed</source>
            <translation>durée {time}</translation>
        </message>
        <message>
            <location filename="../../ui/run/status.py" />
            <source>at most {time} left</source>
            <translation>au plus {time} restant</translation>
        </message>
        <message>
            <location filename="../../ui/run/status.py" />
            <source>Outdated:</source>
            <translation>Obsolète :</translation>
        </message>
        <message>
            <location filename="../../ui/run/status.py" />
            <source>Iterations done, and how many a second lately</source>
            <translation>Itérations faites, et combien par seconde dernièrement</translation>
        </message>
        <message>
            <location filename="../../ui/run/status.py" />
            <source>Relative L2 error of the image after so many iterations of the run, by an independent trace with rays that the design never saw; the scatter of these rays is left out</source>
            <translation>Erreur L2 relative de l'image après tant d'itérations, par un tracé indépendant avec des rayons que la conception n'a jamais vus ; sans la dispersion de ces rayons</translation>
        </message>
        <message>
            <location filename="../../ui/run/status.py" />
            <source>Relative L2 error of the design on show, by an independent trace with rays that the design never saw; the scatter of these rays is left out. The log tells more</source>
            <translation>Erreur L2 relative de la conception affichée, par un tracé indépendant avec des rayons qu'elle n'a jamais vus ; sans la dispersion de ces rayons. Le journal en dit plus</translation>
        </message>
        <message>
            <location filename="../../ui/run/status.py" />
            <source>How far the image is from the target, as the design sees it (relative L2), and how much of the light lands where it is wanted: on the screen, or in the far field. Of several images, both are given for each</source>
            <translation>L'écart de l'image à la cible, tel que la conception le voit (L2 relatif), et la part de lumière qui arrive où elle est voulue : sur l'écran, ou dans le champ lointain. De plusieurs images, les deux pour chacune</translation>
        </message>
        <message>
            <location filename="../../ui/run/status.py" />
            <source>in the far field</source>
            <translation>dans le champ lointain</translation>
        </message>
        <message>
            <location filename="../../ui/run/status.py" />
            <source>What the design makes as small as it can</source>
            <translation>Ce que la conception rend aussi petit que possible</translation>
        </message>
        <message>
            <location filename="../../ui/run/status.py" />
            <source>Run time</source>
            <translation>Durée d'exécution</translation>
        </message>
        <message>
            <location filename="../../ui/run/status.py" />
            <source>Time left at the pace of the last seconds. Automatic ends sooner when nothing improves any more</source>
            <translation>Temps restant au rythme des dernières secondes. Automatique s'arrête plus tôt quand rien ne s'améliore plus</translation>
        </message>
        <message>
            <location filename="../../ui/run/status.py" />
            <source>{time} left</source>
            <translation>{time} restant</translation>
        </message>
        <message>
            <location filename="../../ui/run/status.py" />
            <source>Progress of the design</source>
            <translation>Avancement de la conception</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Each run that ends is kept here, to be compared with others and gone back to.</source>
            <translation>Chaque exécution terminée est gardée ici, pour la comparer à d'autres et y revenir.</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Name</source>
            <translation>Nom</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>What the run is called, with its light; a check mark draws its loss beside that of this run</source>
            <translation>Le nom de l'exécution, avec sa lumière ; une coche dessine son coût à côté de celui de cette exécution</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>The image that the light should draw: its file, or what it is</source>
            <translation>L'image que la lumière doit dessiner : son fichier, ou ce qu'elle est</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Error</source>
            <translation>Erreur</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Relative L2 error of its best result, as the run saw it</source>
            <translation>Erreur L2 relative de son meilleur résultat, telle que l'exécution l'a vue</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Verified</source>
            <translation>Vérifié</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Relative L2 error of its result, by an independent trace with other rays</source>
            <translation>Erreur L2 relative de son résultat, par un tracé indépendant avec d'autres rayons</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>On screen</source>
            <translation>Sur l'écran</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Part of the light that lands on the screen, or in the far field</source>
            <translation>Part de la lumière qui arrive sur l'écran, ou dans le champ lointain</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Time</source>
            <translation>Durée</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Iterations</source>
            <translation>Itérations</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Iterations taken, those of runs that it continued included</source>
            <translation>Itérations faites, y compris celles des exécutions poursuivies</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Net</source>
            <translation>Réseau</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Numbers of control points along x and y</source>
            <translation>Nombres de points de contrôle selon x et y</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Method</source>
            <translation>Méthode</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>How the result was searched for</source>
            <translation>Comment le résultat a été cherché</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Loss of its best result, as the run saw it</source>
            <translation>Coût de son meilleur résultat, tel que l'exécution l'a vu</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Ended</source>
            <translation>Fin</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Why the run ended</source>
            <translation>Pourquoi l'exécution s'est terminée</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Kept runs</source>
            <translation>Exécutions gardées</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Delete</source>
            <translation>Supprimer</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Restore</source>
            <translation>Restaurer</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Give the design this run's task and result</source>
            <translation>Donner à la conception la tâche et le résultat de cette exécution</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Forget the chosen runs</source>
            <translation>Oublier les exécutions choisies</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Compare</source>
            <translation>Comparer</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>See two chosen runs beside each other: light, figures, fields</source>
            <translation>Voir côte à côte deux exécutions choisies : lumière, chiffres, champs</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>The one of the design</source>
            <translation>Celle de la conception</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>A name has at most {count} characters</source>
            <translation>Un nom a au plus {count} caractères</translation>
        </message>
        <message>
            <location filename="../../ui/shown/image_titles.py" />
            <source>Image {number}, {place}</source>
            <translation>Image {number}, {place}</translation>
        </message>
        <message>
            <location filename="../../ui/startup/unexpected_errors.py" />
            <source>Something went wrong that should not: {error}. Your work is still here: save it.</source>
            <translation>Quelque chose s'est mal passé qui n'aurait pas dû : {error}. Votre travail est encore là : enregistrez-le.</translation>
        </message>
        <message>
            <location filename="../../ui/startup/warm_up.py" />
            <source>start</source>
            <translation>démarrage</translation>
        </message>
        <message>
            <location filename="../../ui/sweep/curve.py" />
            <source>Verified error over the values</source>
            <translation>Erreur vérifiée selon les valeurs</translation>
        </message>
        <message>
            <location filename="../../ui/sweep/dialog.py" />
            <source>Each value, or each pair of values of two fields, gets a design of its own, which is checked. Sessions and a table (CSV, JSON) go into the folder; what is finished there is not done again.</source>
            <translation>Chaque valeur, ou chaque paire de valeurs de deux champs, reçoit sa propre conception, qui est vérifiée. Les sessions et un tableau (CSV, JSON) vont dans le dossier ; ce qui y est terminé n'est pas refait.</translation>
        </message>
        <message>
            <location filename="../../ui/sweep/dialog.py" />
            <source>Verified error</source>
            <translation>Erreur vérifiée</translation>
        </message>
        <message>
            <location filename="../../ui/sweep/dialog.py" />
            <source>Light</source>
            <translation>Lumière</translation>
        </message>
        <message>
            <location filename="../../ui/sweep/dialog.py" />
            <source>Seconds</source>
            <translation>Secondes</translation>
        </message>
        <message>
            <location filename="../../ui/sweep/dialog.py" />
            <source>Sweep</source>
            <translation>Série</translation>
        </message>
        <message>
            <location filename="../../ui/sweep/dialog.py" />
            <source>Folder</source>
            <translation>Dossier</translation>
        </message>
        <message>
            <location filename="../../ui/sweep/dialog.py" />
            <source>How far the sweep is</source>
            <translation>Avancement de la série</translation>
        </message>
        <message>
            <location filename="../../ui/sweep/dialog.py" />
            <source>&amp;Open design</source>
            <translation>&amp;Ouvrir la conception</translation>
        </message>
        <message>
            <location filename="../../ui/sweep/dialog.py" />
            <source>Open the session of the chosen row in the window</source>
            <translation>Ouvrir la session de la ligne choisie dans la fenêtre</translation>
        </message>
        <message>
            <location filename="../../ui/sweep/dialog.py" />
            <source>Choose a folder for the designs.</source>
            <translation>Choisir un dossier pour les conceptions.</translation>
        </message>
        <message>
            <location filename="../../ui/sweep/dialog.py" />
            <source>Asked for at the start</source>
            <translation>Demandé au démarrage</translation>
        </message>
        <message>
            <location filename="../../ui/sweep/dialog.py" />
            <source>Choose the folder</source>
            <translation>Choisir le dossier</translation>
        </message>
        <message>
            <location filename="../../ui/sweep/dialog.py" />
            <source>sweep</source>
            <translation>série</translation>
        </message>
        <message>
            <location filename="../../ui/sweep/dialog.py" />
            <source>{count} of {wanted} designs</source>
            <translation>{count} conceptions sur {wanted}</translation>
        </message>
        <message>
            <location filename="../../ui/sweep/dialog.py" />
            <source>Designs of the sweep</source>
            <translation>Conceptions de la série</translation>
        </message>
        <message>
            <location filename="../../ui/sweep/form.py" />
            <source>Between commas: numbers as 1, 2.5, 3; whole numbers as 0..4; pairs as 64x48; words as auto. Lengths in the unit of the scene.</source>
            <translation>Entre virgules : nombres comme 1, 2.5, 3 ; entiers comme 0..4 ; paires comme 64x48 ; mots comme auto. Longueurs dans l'unité de la scène.</translation>
        </message>
        <message>
            <location filename="../../ui/sweep/form.py" />
            <source>Field</source>
            <translation>Champ</translation>
        </message>
        <message>
            <location filename="../../ui/sweep/form.py" />
            <source>Second field</source>
            <translation>Second champ</translation>
        </message>
        <message>
            <location filename="../../ui/sweep/form.py" />
            <source>Values of {field}</source>
            <translation>Valeurs de {field}</translation>
        </message>
        <message>
            <location filename="../../ui/sweep/form.py" />
            <source>now {value}</source>
            <translation>actuellement {value}</translation>
        </message>
        <message>
            <location filename="../../ui/threads/failure.py" />
            <source>The {work} ended with an {error}</source>
            <translation>{work} : arrêt sur « {error} »</translation>
        </message>
        <message>
            <location filename="../../ui/tolerances/form.py" />
            <source>Save…</source>
            <translation>Enregistrer…</translation>
        </message>
        <message>
            <location filename="../../ui/tolerances/form.py" />
            <source>Save the plot (PNG, SVG), or the figures of each lens (CSV, JSON)</source>
            <translation>Enregistrer le graphique (PNG, SVG), ou les chiffres de chaque lentille (CSV, JSON)</translation>
        </message>
        <message>
            <location filename="../../ui/tolerances/form.py" />
            <source>a whole number from 1 to {most} is needed</source>
            <translation>un nombre entier de 1 à {most} est requis</translation>
        </message>
        <message>
            <location filename="../../ui/tolerances/form.py" />
            <source>a whole number from 0 is needed</source>
            <translation>un nombre entier à partir de 0 est requis</translation>
        </message>
        <message>
            <location filename="../../ui/tolerances/form.py" />
            <source>a finite number from 0 is needed</source>
            <translation>un nombre fini à partir de 0 est requis</translation>
        </message>
        <message>
            <location filename="../../ui/tolerances/form.py" />
            <source>over</source>
            <translation>sur</translation>
        </message>
        <message>
            <location filename="../../ui/tolerances/form.py" />
            <source>Lenses</source>
            <translation>Lentilles</translation>
        </message>
        <message>
            <location filename="../../ui/tolerances/form.py" />
            <source>How many are traced; more make the tail surer</source>
            <translation>Combien sont tracées ; plus rendent la queue plus sûre</translation>
        </message>
        <message>
            <location filename="../../ui/tolerances/form.py" />
            <source>Seed</source>
            <translation>Graine</translation>
        </message>
        <message>
            <location filename="../../ui/tolerances/form.py" />
            <source>The same seed gives the same lenses</source>
            <translation>La même graine donne les mêmes lentilles</translation>
        </message>
        <message>
            <location filename="../../ui/tolerances/pane.py" />
            <source>Nothing is off: give a tilt, a decentre or another tolerance.</source>
            <translation>Rien ne s'écarte : donner une inclinaison, un décentrement ou une autre tolérance.</translation>
        </message>
        <message>
            <location filename="../../ui/tolerances/pane.py" />
            <source>sample of tolerances</source>
            <translation>échantillon de tolérances</translation>
        </message>
        <message>
            <location filename="../../ui/tolerances/pane.py" />
            <source>Trace no more; those that are traced count</source>
            <translation>Ne plus tracer ; celles qui sont tracées comptent</translation>
        </message>
        <message>
            <location filename="../../ui/tolerances/pane.py" />
            <source>Perturb what is on show at random, and trace each with fresh rays</source>
            <translation>Perturber au hasard ce qui est affiché, et tracer chacune avec des rayons nouveaux</translation>
        </message>
        <message>
            <location filename="../../ui/tolerances/pane.py" />
            <source>{count} of {wanted} lenses</source>
            <translation>{count} lentilles sur {wanted}</translation>
        </message>
        <message>
            <location filename="../../ui/tolerances/pane.py" />
            <source>{done}: error as designed {nominal:.2f} %, median {median:.2f} %, 95 % of lenses below {most:.2f} %, worst {worst:.2f} %</source>
            <translation>{done} : erreur de la conception {nominal:.2f} %, médiane {median:.2f} %, 95 % des lentilles sous {most:.2f} %, pire {worst:.2f} %</translation>
        </message>
        <message>
            <location filename="../../ui/tolerances/pane.py" />
            <source>Out of date: the lens has changed since.</source>
            <translation>Périmé : la lentille a changé depuis.</translation>
        </message>
        <message>
            <location filename="../../ui/tolerances/spread_view.py" />
            <source>How does the image change when lenses are a little off? Start traces some of them.</source>
            <translation>Comment l'image change-t-elle quand les lentilles s'écartent un peu ? Démarrer en trace quelques-unes.</translation>
        </message>
        <message>
            <location filename="../../ui/views/derivative_view.py" />
            <source>Control point</source>
            <translation>Point de contrôle</translation>
        </message>
        <message>
            <location filename="../../ui/views/derivative_view.py" />
            <source>Choose it here, or click it in the 3D scene.</source>
            <translation>Le choisir ici, ou le cliquer dans la scène 3D.</translation>
        </message>
        <message>
            <location filename="../../ui/views/derivative_view.py" />
            <source>Computed when the design rests…</source>
            <translation>Calculé quand la conception est au repos…</translation>
        </message>
        <message>
            <location filename="../../ui/views/derivative_view.py" />
            <source>Computing…</source>
            <translation>Calcul…</translation>
        </message>
        <message>
            <location filename="../../ui/views/derivative_view.py" />
            <source>derivative map</source>
            <translation>carte de dérivées</translation>
        </message>
        <message>
            <location filename="../../ui/views/derivative_view.py" />
            <source>There is no map of this point yet.</source>
            <translation>Il n'y a pas encore de carte de ce point.</translation>
        </message>
        <message>
            <location filename="../../ui/views/derivative_view.py" />
            <source>Number of the control point along {axis}, counted from 0</source>
            <translation>Numéro du point de contrôle selon {axis}, compté à partir de 0</translation>
        </message>
        <message>
            <location filename="../../ui/views/derivative_view.py" />
            <source>Control point along {axis}</source>
            <translation>Point de contrôle selon {axis}</translation>
        </message>
        <message>
            <location filename="../../ui/views/derivative_view.py" />
            <source>, {part} of the total flux there</source>
            <translation>, {part} du flux total qui y arrive</translation>
        </message>
        <message>
            <location filename="../../ui/views/derivative_view.py" />
            <source>Sum: flux on the screen changes by {sum} per {unit}{part}</source>
            <translation>Somme : le flux sur l'écran change de {sum} par {unit}{part}</translation>
        </message>
        <message>
            <location filename="../../ui/views/face_choice.py" />
            <source>Face</source>
            <translation>Face</translation>
        </message>
        <message>
            <location filename="../../ui/views/face_choice.py" />
            <source>Which of the freeform faces of the lens is meant</source>
            <translation>Laquelle des faces de forme libre de la lentille</translation>
        </message>
        <message>
            <location filename="../../ui/views/focus_curve.py" />
            <source>Relative L2 error against the distance; the dotted line is the screen</source>
            <translation>Erreur L2 relative selon la distance ; la ligne pointillée est l'écran</translation>
        </message>
        <message>
            <location filename="../../ui/views/focus_view.py" />
            <source>trace through focus</source>
            <translation>série focale</translation>
        </message>
        <message>
            <location filename="../../ui/views/focus_view.py" />
            <source>A far field is at no distance: there is nothing to focus.</source>
            <translation>Un champ lointain n'est à aucune distance : il n'y a rien à mettre au point.</translation>
        </message>
        <message>
            <location filename="../../ui/views/focus_view.py" />
            <source>Distance of the screen</source>
            <translation>Distance de l'écran</translation>
        </message>
        <message>
            <location filename="../../ui/views/focus_view.py" />
            <source>Look at the light before or behind the screen: half to one and a half times its distance. The scene stays as it is</source>
            <translation>Regarder la lumière devant ou derrière l'écran : de la moitié à une fois et demie sa distance. La scène reste telle quelle</translation>
        </message>
        <message>
            <location filename="../../ui/views/focus_view.py" />
            <source>At screen</source>
            <translation>À l'écran</translation>
        </message>
        <message>
            <location filename="../../ui/views/focus_view.py" />
            <source>Go back to the distance of the scene's screen</source>
            <translation>Revenir à la distance de l'écran de la scène</translation>
        </message>
        <message>
            <location filename="../../ui/views/focus_view.py" />
            <source>Curve</source>
            <translation>Courbe</translation>
        </message>
        <message>
            <location filename="../../ui/views/focus_view.py" />
            <source>Trace the light to many distances and draw the error against them</source>
            <translation>Tracer la lumière à de nombreuses distances et dessiner l'erreur en fonction d'elles</translation>
        </message>
        <message>
            <location filename="../../ui/views/focus_view.py" />
            <source>traced when the design rests…</source>
            <translation>tracé quand la conception est au repos…</translation>
        </message>
        <message>
            <location filename="../../ui/views/focus_view.py" />
            <source>tracing…</source>
            <translation>tracé…</translation>
        </message>
        <message>
            <location filename="../../ui/views/focus_view.py" />
            <source>no light arrives there</source>
            <translation>aucune lumière n'y arrive</translation>
        </message>
        <message>
            <location filename="../../ui/views/focus_view.py" />
            <source>{part:.1f} % of the light</source>
            <translation>{part:.1f} % de la lumière</translation>
        </message>
        <message>
            <location filename="../../ui/views/focus_view.py" />
            <source>error {error}, {light}</source>
            <translation>erreur {error}, {light}</translation>
        </message>
        <message>
            <location filename="../../ui/views/focus_view.py" />
            <source>screen</source>
            <translation>écran</translation>
        </message>
        <message>
            <location filename="../../ui/views/focus_view.py" />
            <source>The light there is traced when the design rests.</source>
            <translation>La lumière y est tracée quand la conception est au repos.</translation>
        </message>
        <message>
            <location filename="../../ui/views/history_slider.py" />
            <source>Moment of the run</source>
            <translation>Moment de l'exécution</translation>
        </message>
        <message>
            <location filename="../../ui/views/history_slider.py" />
            <source>Look back at the design and its light at any moment of the run</source>
            <translation>Revoir la conception et sa lumière à tout moment de l'exécution</translation>
        </message>
        <message>
            <location filename="../../ui/views/history_slider.py" />
            <source>iteration {number}</source>
            <translation>itération {number}</translation>
        </message>
        <message>
            <location filename="../../ui/views/history_slider.py" />
            <source>Go on from here</source>
            <translation>Repartir d'ici</translation>
        </message>
        <message>
            <location filename="../../ui/views/history_slider.py" />
            <source>Take the design as it was at this moment, and continue from it; Undo brings the later one back</source>
            <translation>Prendre la conception telle qu'à ce moment, et repartir de là ; Annuler ramène la suivante</translation>
        </message>
        <message>
            <location filename="../../ui/views/image_choice.py" />
            <source>Which of the scene's images is shown</source>
            <translation>Laquelle des images de la scène est affichée</translation>
        </message>
        <message>
            <location filename="../../ui/views/image_view.py" />
            <source>Value under the pointer</source>
            <translation>Valeur sous le pointeur</translation>
        </message>
        <message>
            <location filename="../../ui/views/image_view.py" />
            <source>beside the lens</source>
            <translation>à côté de la lentille</translation>
        </message>
        <message>
            <location filename="../../ui/views/image_view.py" />
            <source>beside the mirror</source>
            <translation>à côté du miroir</translation>
        </message>
        <message>
            <location filename="../../ui/views/image_view.py" />
            <source>{value} at {x}, {y}</source>
            <translation>{value} à {x}, {y}</translation>
        </message>
        <message>
            <location filename="../../ui/views/light_image_view.py" />
            <source>Logarithmic colours</source>
            <translation>Couleurs logarithmiques</translation>
        </message>
        <message>
            <location filename="../../ui/views/light_image_view.py" />
            <source>Logarithmic colours, over three decades: stray light is seen</source>
            <translation>Couleurs logarithmiques, sur trois décades : la lumière parasite se voit</translation>
        </message>
        <message>
            <location filename="../../ui/views/light_view.py" />
            <source>All parts</source>
            <translation>Toutes les parts</translation>
        </message>
        <message>
            <location filename="../../ui/views/light_view.py" />
            <source>The parts together; the account is complete when this is 100 %.</source>
            <translation>Les parts ensemble ; le bilan est complet si cela fait 100 %.</translation>
        </message>
        <message>
            <location filename="../../ui/views/loss_view.py" />
            <source>Axes</source>
            <translation>Axes</translation>
        </message>
        <message>
            <location filename="../../ui/views/loss_view.py" />
            <source>What the loss is drawn against, and how</source>
            <translation>En fonction de quoi le coût est dessiné, et comment</translation>
        </message>
        <message>
            <location filename="../../ui/views/loss_view.py" />
            <source>Against iterations</source>
            <translation>Selon les itérations</translation>
        </message>
        <message>
            <location filename="../../ui/views/loss_view.py" />
            <source>Against seconds</source>
            <translation>Selon les secondes</translation>
        </message>
        <message>
            <location filename="../../ui/views/loss_view.py" />
            <source>Logarithmic x</source>
            <translation>x logarithmique</translation>
        </message>
        <message>
            <location filename="../../ui/views/loss_view.py" />
            <source>Logarithmic y</source>
            <translation>y logarithmique</translation>
        </message>
        <message>
            <location filename="../../ui/views/loss_view.py" />
            <source>The loss is drawn here while a design runs. Run &gt; Start begins one.</source>
            <translation>Le coût est dessiné ici pendant une conception. Exécution &gt; Démarrer en lance une.</translation>
        </message>
        <message>
            <location filename="../../ui/views/photo_view.py" />
            <source>predict the photo</source>
            <translation>prédiction de la photo</translation>
        </message>
        <message>
            <location filename="../../ui/views/photo_view.py" />
            <source>There is no lens yet: Start designs one.</source>
            <translation>Il n'y a pas encore de lentille : Démarrer en conçoit une.</translation>
        </message>
        <message>
            <location filename="../../ui/views/photo_view.py" />
            <source>The photo is predicted when the design rests.</source>
            <translation>La photo est prédite quand la conception est au repos.</translation>
        </message>
        <message>
            <location filename="../../ui/views/photo_view.py" />
            <source>Predicting… {part:.0f} %</source>
            <translation>Prédiction… {part:.0f} %</translation>
        </message>
        <message>
            <location filename="../../ui/views/photo_view.py" />
            <source>Light of the photo</source>
            <translation>Lumière de la photo</translation>
        </message>
        <message>
            <location filename="../../ui/views/photo_view.py" />
            <source>What the lens is lit by: as its source suggests (daylight from infinitely far, a laser as a Gaussian beam, else an LED), or another light</source>
            <translation>Ce qui éclaire la lentille : selon sa source (lumière du jour de l'infini, laser pour un faisceau gaussien, sinon une LED), ou une autre lumière</translation>
        </message>
        <message>
            <location filename="../../ui/views/photo_view.py" />
            <source>Light of the source</source>
            <translation>Lumière de la source</translation>
        </message>
        <message>
            <location filename="../../ui/views/photo_view.py" />
            <source>Exposure</source>
            <translation>Exposition</translation>
        </message>
        <message>
            <location filename="../../ui/views/photo_view.py" />
            <source>Exposure in stops: one more makes all twice as bright</source>
            <translation>Exposition en diaphragmes : un de plus rend tout deux fois plus clair</translation>
        </message>
        <message>
            <location filename="../../ui/views/photo_view.py" />
            <source>{number} stops</source>
            <translation>{number} IL</translation>
        </message>
        <message>
            <location filename="../../ui/views/photo_view.py" />
            <source>The usual exposure: the target's brightest pixel is white</source>
            <translation>L'exposition usuelle : le pixel le plus clair de la cible est blanc</translation>
        </message>
        <message>
            <location filename="../../ui/views/photo_view.py" />
            <source>Usual exposure</source>
            <translation>Exposition usuelle</translation>
        </message>
        <message>
            <location filename="../../ui/views/photo_view.py" />
            <source>Out of date: of the lens before. </source>
            <translation>Périmé : de la lentille précédente. </translation>
        </message>
        <message>
            <location filename="../../ui/views/plot_view.py" />
            <source>The first picture of this design comes in a moment.</source>
            <translation>La première image de cette conception arrive dans un instant.</translation>
        </message>
        <message>
            <location filename="../../ui/views/plot_view.py" />
            <source>There is too little room here for a picture.</source>
            <translation>Il y a trop peu de place ici pour une image.</translation>
        </message>
        <message>
            <location filename="../../ui/views/plot_view.py" />
            <source>There is no picture of this design: its light cannot be traced.</source>
            <translation>Il n'y a pas d'image de cette conception : sa lumière ne peut être tracée.</translation>
        </message>
        <message>
            <location filename="../../ui/views/region_marks.py" />
            <source>least / mean {number:.2f}</source>
            <translation>minimum / moyenne {number:.2f}</translation>
        </message>
        <message>
            <location filename="../../ui/views/region_tool.py" />
            <source>new region</source>
            <translation>nouvelle région</translation>
        </message>
        <message>
            <location filename="../../ui/views/region_tool.py" />
            <source>move of {region}</source>
            <translation>déplacement de {region}</translation>
        </message>
        <message>
            <location filename="../../ui/views/scene_contents.py" />
            <source>Height</source>
            <translation>Hauteur</translation>
        </message>
        <message>
            <location filename="../../ui/views/scene_contents.py" />
            <source>Mean curvature</source>
            <translation>Courbure moyenne</translation>
        </message>
        <message>
            <location filename="../../ui/views/screen_image_view.py" />
            <source>Draw a line</source>
            <translation>Tracer une ligne</translation>
        </message>
        <message>
            <location filename="../../ui/views/screen_image_view.py" />
            <source>Drag across an image to draw the line of a cross-section; Shift and drag does so too</source>
            <translation>Tirer à travers une image pour dessiner la ligne d'une coupe ; Maj et tirer aussi</translation>
        </message>
        <message>
            <location filename="../../ui/views/screen_image_view.py" />
            <source>{side}: mirror-inverted</source>
            <translation>{side} : inversé comme dans un miroir</translation>
        </message>
        <message>
            <location filename="../../ui/views/section_view.py" />
            <source>Where the screen is cut: along x or y through the place that is clicked in an image,
or along a line that is drawn across one with Shift and drag.
Arrow keys move place or line by a pixel, with Shift by ten; with Ctrl, the end of the line</source>
            <translation>Où l'écran est coupé : selon x ou y par l'endroit cliqué dans une image,
ou selon une ligne dessinée à travers une image avec Maj et tirer.
Les flèches déplacent l'endroit ou la ligne d'un pixel, avec Maj de dix ; avec Ctrl, le bout de la ligne</translation>
        </message>
        <message>
            <location filename="../../ui/views/section_view.py" />
            <source>Along</source>
            <translation>Selon</translation>
        </message>
        <message>
            <location filename="../../ui/views/section_view.py" />
            <source>Along x</source>
            <translation>Selon x</translation>
        </message>
        <message>
            <location filename="../../ui/views/section_view.py" />
            <source>Along y</source>
            <translation>Selon y</translation>
        </message>
        <message>
            <location filename="../../ui/views/section_view.py" />
            <source>Along a line</source>
            <translation>Selon une ligne</translation>
        </message>
        <message>
            <location filename="../../ui/views/section_view.py" />
            <source>From {start} to {end} {unit}.
{tip}</source>
            <translation>De {start} à {end} {unit}.
{tip}</translation>
        </message>
        <message>
            <location filename="../../ui/views/target_view.py" />
            <source>The target with as much light as arrives: where the irradiance is right, both have the same colour, however much light is lost on the way. The light account tells where that goes.</source>
            <translation>La cible avec autant de lumière qu'il en arrive : où l'éclairement est juste, les deux ont la même couleur, quelle que soit la lumière perdue en route. Le bilan de lumière dit où elle va.</translation>
        </message>
        <message>
            <location filename="../../ui/widgets/log_view.py" />
            <source>What runs, checks and exports tell is written here.</source>
            <translation>Ce que disent exécutions, vérifications et exports s'écrit ici.</translation>
        </message>
        <message>
            <location filename="../../ui/widgets/message_bar.py" />
            <source>Close this message</source>
            <translation>Fermer ce message</translation>
        </message>
        <message>
            <location filename="../../ui/widgets/plot_words.py" />
            <source>as designed</source>
            <translation>comme conçu</translation>
        </message>
        <message>
            <location filename="../../ui/widgets/plot_words.py" />
            <source>lenses up to there</source>
            <translation>lentilles jusque-là</translation>
        </message>
        <message>
            <location filename="../../ui/widgets/plot_words.py" />
            <source>z of the screen</source>
            <translation>z de l'écran</translation>
        </message>
        <message>
            <location filename="../../ui/widgets/plot_words.py" />
            <source>Second minus first</source>
            <translation>Second moins premier</translation>
        </message>
        <message>
            <location filename="../../ui/widgets/plot_words.py" />
            <source>The receivers cover different places: nothing to subtract.</source>
            <translation>Les récepteurs couvrent des endroits différents : rien à soustraire.</translation>
        </message>
        <message>
            <location filename="../../ui/widgets/plot_words.py" />
            <source>iteration</source>
            <translation>itération</translation>
        </message>
        <message>
            <location filename="../../ui/widgets/plot_words.py" />
            <source>time</source>
            <translation>temps</translation>
        </message>
        <message>
            <location filename="../../ui/widgets/plot_words.py" />
            <source>distance</source>
            <translation>distance</translation>
        </message>
        <message>
            <location filename="../../ui/widgets/plot_words.py" />
            <source>loss</source>
            <translation>coût</translation>
        </message>
        <message>
            <location filename="../../ui/widgets/plot_words.py" />
            <source>this run</source>
            <translation>cette exécution</translation>
        </message>
        <message>
            <location filename="../../ui/widgets/plot_words.py" />
            <source>verified</source>
            <translation>vérifié</translation>
        </message>
        <message>
            <location filename="../../ui/widgets/plot_words.py" />
            <source>target</source>
            <translation>cible</translation>
        </message>
        <message>
            <location filename="../../ui/widgets/plot_words.py" />
            <source>irradiance</source>
            <translation>éclairement</translation>
        </message>
        <message>
            <location filename="../../ui/widgets/plot_words.py" />
            <source>intensity</source>
            <translation>intensité</translation>
        </message>
        <message>
            <location filename="../../ui/widgets/plot_words.py" />
            <source>error</source>
            <translation>erreur</translation>
        </message>
        <message>
            <location filename="../../ui/widgets/plot_words.py" />
            <source>flux / {unit}</source>
            <translation>flux / {unit}</translation>
        </message>
        <message>
            <location filename="../../ui/widgets/plot_words.py" />
            <source>{axis} at {place}</source>
            <translation>{axis} à {place}</translation>
        </message>
        <message>
            <location filename="../../ui/widgets/veil.py" />
            <source>Outdated: this is the design before the change</source>
            <translation>Obsolète : c'est la conception avant la modification</translation>
        </message>
        <message>
            <location filename="../../ui/window/early_parts.py" />
            <source>The run waits for its tracing kernels: they are compiled once after installing, for about half a minute</source>
            <translation>L'exécution attend ses noyaux de tracé : ils sont compilés une fois après l'installation, pendant une demi-minute environ</translation>
        </message>
        <message>
            <location filename="../../ui/window/loaded_parts.py" />
            <source>Stop the run first; then mark regions.</source>
            <translation>Arrêtez d'abord le calcul, puis marquez les régions.</translation>
        </message>
        <message>
            <location filename="../../ui/window/loaded_parts.py" />
            <source>Cancel &amp;check</source>
            <translation>Annu&amp;ler la vérification</translation>
        </message>
        <message>
            <location filename="../../ui/window/view_state.py" />
            <source>The {what} kept with this design cannot be shown again: {error}</source>
            <translation>Ce qui était gardé avec cette conception ne peut être remontré ({what}) : {error}</translation>
        </message>
        <message>
            <location filename="../../ui/window/window_state.py" />
            <source>Loading…</source>
            <translation>Chargement…</translation>
        </message>
        <message>
            <location filename="../../ui/window/window_state.py" />
            <source>Ready</source>
            <translation>Prêt</translation>
        </message>
        <message>
            <location filename="../../ui/window/window_state.py" />
            <source>Designing…</source>
            <translation>Conception en cours…</translation>
        </message>
        <message>
            <location filename="../../ui/window/window_state.py" />
            <source>Paused</source>
            <translation>En pause</translation>
        </message>
        <message>
            <location filename="../../ui/window/window_state.py" />
            <source>Stopping…</source>
            <translation>Arrêt…</translation>
        </message>
        <message>
            <location filename="../../ui/window/window_state.py" />
            <source>&amp;Undo {undo}</source>
            <translation>A&amp;nnuler : {undo}</translation>
        </message>
        <message>
            <location filename="../../ui/window/window_state.py" />
            <source>&amp;Redo {redo}</source>
            <translation>&amp;Rétablir : {redo}</translation>
        </message>
        <message>
            <location filename="../../ui/window/window_state.py" />
            <source>Stopped: {command} ({keys}) can make the lens better</source>
            <translation>Arrêté : {command} ({keys}) peut améliorer la lentille</translation>
        </message>
        <message>
            <location filename="../../ui/window/window_state.py" />
            <source>Stopped: {command} ({keys}) can make the mirror better</source>
            <translation>Arrêté : {command} ({keys}) peut améliorer le miroir</translation>
        </message>
        <message>
            <location filename="../../ui/window/workspace.py" />
            <source>Loading the 3D scene…</source>
            <translation>Chargement de la scène 3D…</translation>
        </message>
        <message>
            <location filename="../../ui/window/workspace.py" />
            <source>As opened</source>
            <translation>Comme ouvert</translation>
        </message>
        <message>
            <location filename="../../ui/window/workspace.py" />
            <source>A click goes back or forth to that step</source>
            <translation>Un clic revient ou avance à cette étape</translation>
        </message>
        <message>
            <location filename="../../ui/window/workspace.py" />
            <source>The 3D scene is hidden. View &gt; 3D scene shows it again.</source>
            <translation>La scène 3D est cachée. Affichage &gt; Scène 3D la remontre.</translation>
        </message>
        <message>
            <location filename="../../ui/windows.py" />
            <source>{name} is open with the unsaved changes that were recovered.</source>
            <translation>{name} est ouvert avec les modifications non enregistrées récupérées.</translation>
        </message>
        <message>
            <location filename="../../ui/windows.py" />
            <source>Copy details</source>
            <translation>Copier les détails</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>First lenses</source>
            <translation>Premières lentilles</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>lens</source>
            <translation>lentille</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>exit face</source>
            <translation>face de sortie</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>entrance face</source>
            <translation>face d'entrée</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>mirror</source>
            <translation>miroir</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>on the screen</source>
            <translation>sur l'écran</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>On the screen</source>
            <translation>Sur l'écran</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Light that makes the image.</source>
            <translation>Lumière qui forme l'image.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Missed the screen</source>
            <translation>Manque l'écran</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Light that passes the optic and the screen by. One that sends much light here wastes it, or has more than its surface can bend.</source>
            <translation>Lumière qui passe à côté de l'optique et de l'écran. Une optique qui en envoie beaucoup ici la gaspille, ou en a plus que sa surface n'en peut dévier.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Missed the lens</source>
            <translation>Manque la lentille</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Light that passes the entrance face by. The cone of a point source is round and just covers the rectangle around the face; of that, an elliptic lens leaves the corners open.</source>
            <translation>Lumière qui passe à côté de la face d'entrée. Le cône d'une source ponctuelle est rond et couvre juste le rectangle autour de la face ; une lentille elliptique en laisse les coins.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Out of the side</source>
            <translation>Sort par le côté</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Light that entered the lens so slanted that it meets a side wall before the exit face.</source>
            <translation>Lumière entrée si inclinée dans la lentille qu'elle rencontre une paroi avant la face de sortie.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Totally reflected</source>
            <translation>Réflexion totale</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Light that meets the exit face too steeply to leave the lens there.</source>
            <translation>Lumière qui rencontre la face de sortie trop inclinée pour y quitter la lentille.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Reflected on entry</source>
            <translation>Réfléchie à l'entrée</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>The part that the entrance face reflects of the light that it refracts.</source>
            <translation>La part que la face d'entrée réfléchit de la lumière qu'elle réfracte.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Reflected on exit</source>
            <translation>Réfléchie à la sortie</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>The part that the exit face reflects of the light that it refracts.</source>
            <translation>La part que la face de sortie réfléchit de la lumière qu'elle réfracte.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Absorbed</source>
            <translation>Absorbée</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>The part that the glass absorbs of the light that comes to the exit face.</source>
            <translation>La part que le verre absorbe de la lumière qui va à la face de sortie.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Missed the mirror</source>
            <translation>Manque le miroir</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Light that passes the mirror by: between it and the rim of the light's cone, and through the corners of the rectangle around an elliptic mirror.</source>
            <translation>Lumière qui passe à côté du miroir : entre lui et le bord du cône, et par les coins du rectangle autour d'un miroir elliptique.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Absorbed by the mirror</source>
            <translation>Absorbée par le miroir</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>The part of the light on the mirror that it does not reflect.</source>
            <translation>La part de la lumière sur le miroir qu'il ne réfléchit pas.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>far field</source>
            <translation>champ lointain</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Intensity</source>
            <translation>Intensité énergétique</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>In the far field</source>
            <translation>Dans le champ lointain</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Missed the far field</source>
            <translation>Manque le champ lointain</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Light that passes the optic and the far field by. One that sends much light here wastes it, or has more than its surface can bend.</source>
            <translation>Lumière qui passe à côté de l'optique et du champ lointain. Une optique qui en envoie beaucoup ici la gaspille, ou en a plus que sa surface n'en peut dévier.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Unit</source>
            <translation>Unité</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Unit of every length in the scene. Another one converts them all: a lens of 1 cm becomes one of 10 mm.</source>
            <translation>Unité de toutes les longueurs de la scène. Une autre les convertit toutes : une lentille de 1 cm en devient une de 10 mm.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Source</source>
            <translation>Source</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Where the light comes from.</source>
            <translation>D'où vient la lumière.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Collimated light</source>
            <translation>Lumière collimatée</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Light from infinitely far that fills the entrance face: the sun, a laser beam.</source>
            <translation>Lumière venue de l'infini qui remplit la face d'entrée : le soleil, un faisceau laser.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Rays</source>
            <translation>Rayons</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Rays along x and y in each iteration of the paper's method, and for derivative maps. More give a smoother image and take longer; at least two per pixel and axis are good. Automatic chooses its own.</source>
            <translation>Rayons selon x et y à chaque itération de la méthode de l'article, et pour les cartes de dérivées. Plus donnent une image plus lisse et prennent plus de temps ; au moins deux par pixel et axe conviennent. Automatique choisit les siens.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Direction</source>
            <translation>Direction</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>How far the light is tilted against the optical axis: about x, which makes it go downwards, and about y, which makes it go to +x.</source>
            <translation>L'inclinaison de la lumière sur l'axe optique : autour de x, ce qui la fait descendre, et autour de y, ce qui la fait aller vers +x.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Angular diameter</source>
            <translation>Diamètre angulaire</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Full angle of the disc that the light comes from: 0.533 for the sun, 0 for a laser or a star. It blurs the image by as much as the disc's light spreads on the way.</source>
            <translation>Angle total du disque d'où vient la lumière : 0.533 pour le soleil, 0 pour un laser ou une étoile. Il rend l'image floue d'autant que la lumière du disque s'étale en chemin.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Profile</source>
            <translation>Profil</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>How bright the light is across the beam.</source>
            <translation>La luminosité à travers le faisceau.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Uniform</source>
            <translation>Uniforme</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>As bright everywhere.</source>
            <translation>Partout aussi clair.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Gaussian beam</source>
            <translation>Faisceau gaussien</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>A laser beam about the optical axis of the lens; what passes its rim misses the lens.</source>
            <translation>Un faisceau laser autour de l'axe optique de la lentille ; ce qui passe hors de son bord manque la lentille.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Beam radius</source>
            <translation>Rayon du faisceau</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Where the irradiance has fallen to 1/e² (13.5 %) of that in the middle, measured across the beam.</source>
            <translation>Où l'éclairement est tombé à 1/e² (13.5 %) de celui du milieu, mesuré en travers du faisceau.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Wavelength</source>
            <translation>Longueur d'onde</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Vacuum wavelength at which the indices of materials are taken. Left empty, it is 0.5876 µm (helium d).</source>
            <translation>Longueur d'onde dans le vide à laquelle sont pris les indices des matériaux. Vide : 0.5876 µm (raie d de l'hélium).</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Light from one point into the cone that just covers the entrance face.</source>
            <translation>Lumière d'un point dans le cône qui couvre juste la face d'entrée.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Position</source>
            <translation>Position</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Where the point is: x, y and z. It has to stand before the entrance face; off the axis it lights the lens askew.</source>
            <translation>Où est le point : x, y et z. Il doit être devant la face d'entrée ; hors de l'axe il éclaire la lentille de biais.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Rays in each iteration of the paper's method, and for derivative maps, those that miss the lens included. More give a smoother image and take longer; at least four per pixel are good. Automatic chooses its own.</source>
            <translation>Rayons à chaque itération de la méthode de l'article, et pour les cartes de dérivées, y compris ceux qui manquent la lentille. Plus donnent une image plus lisse et prennent plus de temps ; au moins quatre par pixel conviennent. Automatique choisit les siens.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Emission</source>
            <translation>Émission</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Uniform: equally bright in all directions, as a small bulb. Lambertian: dimmer away from the optical axis, as the surface of an LED.</source>
            <translation>Uniforme : aussi claire dans toutes les directions, comme une petite ampoule. Lambertienne : moins claire loin de l'axe optique, comme la surface d'une LED.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Lambertian</source>
            <translation>Lambertienne</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Sampling</source>
            <translation>Échantillonnage</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>How directions of the paper's method are drawn. Low discrepancy (Sobol) spreads them evenly and needs far fewer rays; random is noisier, as in the paper.</source>
            <translation>Comment les directions de la méthode de l'article sont tirées. La faible discrépance (Sobol) les répartit uniformément et demande bien moins de rayons ; aléatoire est plus bruité, comme dans l'article.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Low discrepancy</source>
            <translation>Faible discrépance</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Random</source>
            <translation>Aléatoire</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Fresh rays</source>
            <translation>Rayons nouveaux</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Draw new rays for each iteration of the paper's method, so that the lens cannot fit itself to one set of them. Automatic does not have this.</source>
            <translation>Tirer de nouveaux rayons à chaque itération de la méthode de l'article, pour que la lentille ne s'ajuste pas à un seul jeu. Automatique n'a pas cela.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Intersection</source>
            <translation>Intersection</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>How it is found where a ray of the paper's method meets the exit face.</source>
            <translation>Comment se trouve l'endroit où un rayon de la méthode de l'article rencontre la face de sortie.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Exact</source>
            <translation>Exacte</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>On the B-spline itself, fast and without an error of its own.</source>
            <translation>Sur la B-spline elle-même, vite et sans erreur propre.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Triangle mesh</source>
            <translation>Maillage de triangles</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>As in the paper, for comparison.</source>
            <translation>Comme dans l'article, pour comparer.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Subdivisions</source>
            <translation>Subdivisions</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Parts along x and y that each knot span is cut into, two triangles each. Twice as many make a quarter of the error, and four times the triangles.</source>
            <translation>Parts selon x et y de chaque intervalle de nœuds, de deux triangles chacune. Deux fois plus donnent un quart de l'erreur, et quatre fois plus de triangles.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Grid of points</source>
            <translation>Grille de points</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Many points of equal intensity, standing for a source of some size.</source>
            <translation>De nombreux points d'égale intensité, pour une source d'une certaine taille.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>The middle of the grid: x, y and z. All points have the same z, before the entrance face.</source>
            <translation>Le milieu de la grille : x, y et z. Tous les points ont le même z, devant la face d'entrée.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Half width</source>
            <translation>Demi-largeur</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Half of the grid's extent along x and y. No detail of the image can be sharper than the image that the lens makes of this.</source>
            <translation>La moitié de l'étendue de la grille selon x et y. Aucun détail de l'image ne peut être plus net que l'image que la lentille en fait.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Points</source>
            <translation>Points</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Points along x and y, the outer ones on the rim. More of them come closer to an evenly bright source.</source>
            <translation>Points selon x et y, les extérieurs sur le bord. Plus s'approchent d'une source uniforme.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Rays per point</source>
            <translation>Rayons par point</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Rays from each point of the grid, for the paper's method and derivative maps. What they add up to makes the image smooth; few from each of many points are enough. Automatic chooses its own.</source>
            <translation>Rayons de chaque point de la grille, pour la méthode de l'article et les cartes de dérivées. Leur total rend l'image lisse ; peu de chacun de nombreux points suffisent. Automatique choisit les siens.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Photometric file</source>
            <translation>Fichier photométrique</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>A small lamp whose intensity by direction stands in a photometric file.</source>
            <translation>Une petite lampe dont l'intensité par direction est dans un fichier photométrique.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>File</source>
            <translation>Fichier</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Intensity by direction, in a file of IES LM-63 (.ies) or EULUMDAT (.ldt). Its nadir looks along +z, C0 along +x and C90 along −y; the beam axis of types A and B along +z, V upwards along +y and H to the right along −x. A relative path starts at the scene file's folder.</source>
            <translation>Intensité par direction, dans un fichier IES LM-63 (.ies) ou EULUMDAT (.ldt). Son nadir regarde selon +z, C0 selon +x et C90 selon −y ; l'axe du faisceau des types A et B selon +z, V vers le haut selon +y et H vers la droite selon −x. Un chemin relatif part du dossier du fichier de scène.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Where the lamp is: x, y and z. It has to stand before the lens.</source>
            <translation>Où est la lampe : x, y et z. Elle doit être devant la lentille.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Rotation</source>
            <translation>Rotation</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>How the lamp is turned about its own origin: about its x, then about its new y, then about its new z.</source>
            <translation>La rotation de la lampe autour de sa propre origine : autour de son x, puis de son nouvel y, puis de son nouveau z.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Rays in each iteration of the paper's method, and for derivative maps. Automatic chooses its own.</source>
            <translation>Rayons à chaque itération de la méthode de l'article, et pour les cartes de dérivées. Automatique choisit les siens.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Ray file</source>
            <translation>Fichier de rayons</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>A lamp whose rays stand in a ray file, as they were measured or simulated.</source>
            <translation>Une lampe dont les rayons sont dans un fichier, tels que mesurés ou simulés.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Rays in a file of IES TM-25 (.tm25ray), of OpticStudio (.dat), or of text (.csv, .txt) with the columns x, y, z, l, m, n and flux. A relative path starts at the scene file's folder.</source>
            <translation>Rayons dans un fichier IES TM-25 (.tm25ray), d'OpticStudio (.dat) ou de texte (.csv, .txt) avec les colonnes x, y, z, l, m, n et flux. Un chemin relatif part du dossier du fichier de scène.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Where the origin of the file is: x, y and z.</source>
            <translation>Où est l'origine du fichier : x, y et z.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Unit of the file</source>
            <translation>Unité du fichier</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Unit of the lengths in the file. Left empty, it is the one that the file names.</source>
            <translation>Unité des longueurs du fichier. Vide : celle que nomme le fichier.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Area emitter</source>
            <translation>Émetteur plan</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>A flat emitter that faces the lens; it shines into the whole half-space before it.</source>
            <translation>Un émetteur plan qui fait face à la lentille ; il rayonne dans tout le demi-espace devant lui.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>The middle of the emitter: x, y and z, before the entrance face.</source>
            <translation>Le milieu de l'émetteur : x, y et z, devant la face d'entrée.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Half of the emitter's extent along x and y.</source>
            <translation>La moitié de l'étendue de l'émetteur selon x et y.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Outline</source>
            <translation>Contour</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>The shape of its face; of an ellipse the half-widths are semi-axes.</source>
            <translation>La forme de sa face ; pour une ellipse les demi-largeurs sont des demi-axes.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Rectangle</source>
            <translation>Rectangle</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Ellipse</source>
            <translation>Ellipse</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Luminous flux</source>
            <translation>Flux lumineux</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>All light that the emitter gives. With it, light on a screen is given in lux and lumen; left empty, in parts of all light. The lens does not depend on it.</source>
            <translation>Toute la lumière que donne l'émetteur. Avec elle, la lumière sur un écran est dite en lux et lumens ; vide : en parts de toute la lumière. La lentille n'en dépend pas.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Lenses and mirrors in the order in which light meets them. Light that passes one by is lost there.</source>
            <translation>Lentilles et miroirs dans l'ordre où la lumière les rencontre. La lumière qui passe à côté de l'un d'eux y est perdue.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Two faces with a material between; light goes through along its +z.</source>
            <translation>Deux faces avec un matériau entre elles ; la lumière la traverse selon son +z.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>What the element is called; letters, digits, - and _.</source>
            <translation>Le nom de l'élément ; lettres, chiffres, - et _.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Where the vertex of its front face stands: x, y and z.</source>
            <translation>La position du sommet de sa face avant : x, y et z.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Tilt</source>
            <translation>Inclinaison</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>How the element is turned about its front vertex: about its x, then about its new y, then about its new z.</source>
            <translation>La rotation de l'élément autour de son sommet avant : autour de son x, puis de son nouvel y, puis de son nouveau z.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Half of its extent along x and y. All of it is lit.</source>
            <translation>La moitié de son étendue selon x et y. Il est éclairé en entier.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Its shape as seen along the axis; the half widths of an ellipse are its semi-axes. Light beside it misses the element.</source>
            <translation>Sa forme vue selon l'axe ; les demi-largeurs d'une ellipse sont ses demi-axes. La lumière à côté manque l'élément.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Material</source>
            <translation>Matériau</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>What the lens is made of: a catalogue material, or a custom index.</source>
            <translation>De quoi la lentille est faite : un matériau du catalogue, ou un indice propre.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>A refractive index that is the same at all wavelengths.</source>
            <translation>Un indice de réfraction identique à toutes les longueurs d'onde.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Index</source>
            <translation>Indice</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Refractive index at the wavelength of the light.</source>
            <translation>Indice de réfraction à la longueur d'onde de la lumière.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Thickness</source>
            <translation>Épaisseur</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>From the vertex of the front face to the vertex of the back face.</source>
            <translation>Du sommet de la face avant au sommet de la face arrière.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Faces</source>
            <translation>Faces</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Front face and back face, in the order in which light meets them.</source>
            <translation>Face avant et face arrière, dans l'ordre où la lumière les rencontre.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Plane</source>
            <translation>Plan</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>A plane across the axis.</source>
            <translation>Un plan perpendiculaire à l'axe.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Conic</source>
            <translation>Conique</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>A surface of revolution: a conic with aspheric coefficients (ISO 10110-12).</source>
            <translation>Une surface de révolution : une conique à coefficients asphériques (ISO 10110-12).</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Radius</source>
            <translation>Rayon</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Radius of curvature at the vertex: positive where the centre of curvature lies on the +z side of the vertex.</source>
            <translation>Rayon de courbure au sommet : positif si le centre de courbure est du côté +z du sommet.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Conic constant</source>
            <translation>Constante de conicité</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>0 makes a sphere, −1 a paraboloid, less a hyperboloid, between −1 and 0 an ellipsoid.</source>
            <translation>0 donne une sphère, −1 un paraboloïde, moins un hyperboloïde, entre −1 et 0 un ellipsoïde.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Coefficients</source>
            <translation>Coefficients</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Aspheric coefficients a4, a6, …: a4 r⁴ + a6 r⁶ + … is added to the sag.</source>
            <translation>Coefficients asphériques a4, a6, … : a4 r⁴ + a6 r⁶ + … s'ajoute à la flèche.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>B-spline</source>
            <translation>B-spline</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>A B-spline over a base; designed unless it is fixed.</source>
            <translation>Une B-spline sur une base ; à concevoir, sauf si elle est fixe.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Degree</source>
            <translation>Degré</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Polynomial degree of the B-spline along x and y. 3 gives smooth curvature.</source>
            <translation>Degré polynomial de la B-spline selon x et y. 3 donne une courbure lisse.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Control points</source>
            <translation>Points de contrôle</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Number of control points along x and y. More of them draw finer detail and take longer. Automatic takes what the target's detail, the screen's pixels and the size of the source are worth, and as many for the front face as for the back face; the paper's method then has nets like those of the paper.</source>
            <translation>Nombre de points de contrôle selon x et y. Plus dessinent un détail plus fin et prennent plus de temps. Automatique prend ce que valent le détail de la cible, les pixels de l'écran et la taille de la source, et autant pour la face avant que pour la face arrière ; la méthode de l'article a alors des réseaux comme ceux de l'article.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Base</source>
            <translation>Base</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>The shape of the face before the design; heights are counted from it.</source>
            <translation>La forme de la face avant la conception ; les hauteurs sont comptées à partir d'elle.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Flat</source>
            <translation>Plane</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Sphere</source>
            <translation>Sphère</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>A spherical cap that rises or falls towards the rim.</source>
            <translation>Une calotte sphérique qui monte ou descend vers le bord.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Base radius</source>
            <translation>Rayon de la base</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Radius of curvature of the base; more than the half-diagonal of the lens or mirror.</source>
            <translation>Rayon de courbure de la base ; plus que la demi-diagonale de la lentille ou du miroir.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Base form</source>
            <translation>Forme de la base</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Concave rises towards the rim, convex falls.</source>
            <translation>Concave monte vers le bord, convexe descend.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Concave</source>
            <translation>Concave</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Convex</source>
            <translation>Convexe</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Height range</source>
            <translation>Plage de hauteur</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>How far the face may be from the base. Automatic takes what the task needs.</source>
            <translation>De combien la face peut s'écarter de la base. Automatique prend ce que la tâche demande.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>to</source>
            <translation>à</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Fixed</source>
            <translation>Fixe</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>The design leaves the face as it is, with the control heights given.</source>
            <translation>La conception laisse la face telle quelle, avec les hauteurs de contrôle données.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Control heights</source>
            <translation>Hauteurs de contrôle</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>File (.npy) of the control heights of a fixed face, in the element's coordinates.</source>
            <translation>Fichier (.npy) des hauteurs de contrôle d'une face fixe, dans les coordonnées de l'élément.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Absorption</source>
            <translation>Absorption</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>How much the glass absorbs per length: light falls as exp(−absorption · path). Clear glass and acrylic absorb some 0.0002 per mm.</source>
            <translation>Ce que le verre absorbe par longueur : la lumière décroît comme exp(−absorption · trajet). Verre clair et acrylique absorbent environ 0.0002 par mm.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Reflection</source>
            <translation>Réflexion</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>What bare faces reflect: by Fresnel's equations for unpolarised light, by Schlick's approximation to them, as in the paper, or nothing. Under total reflection all of it.</source>
            <translation>Ce que des faces nues réfléchissent : selon les équations de Fresnel pour une lumière non polarisée, selon l'approximation de Schlick, comme dans l'article, ou rien. En réflexion totale, tout.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Fresnel, exact</source>
            <translation>Fresnel, exact</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Schlick, approximate</source>
            <translation>Schlick, approché</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>None</source>
            <translation>Aucune</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Coating</source>
            <translation>Traitement</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Part of the light that an antireflection coating reflects, at the entrance face and at the exit face, at all angles: 0.005 is a good one. Left empty, faces are bare.</source>
            <translation>Part de la lumière qu'un traitement antireflet réfléchit, à la face d'entrée et à celle de sortie, à tous les angles : 0.005 est bon. Vide : faces nues.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Max. thickness</source>
            <translation>Épaisseur max.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>The back face is at most this far from the front face: the thickness of the stock that the part is made of. Left empty, any will do.</source>
            <translation>La face arrière est au plus à cette distance de la face avant : l'épaisseur du brut dont la pièce est faite. Vide : sans limite.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Min. thickness</source>
            <translation>Épaisseur min.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>The back face stays at least this far from the front face, so that the part can be made.</source>
            <translation>La face arrière reste au moins à cette distance de la face avant, pour que la pièce soit réalisable.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Mirror</source>
            <translation>Miroir</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>One face that reflects, lit from below.</source>
            <translation>Une face qui réfléchit, éclairée d'en bas.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>The face that reflects.</source>
            <translation>La face qui réfléchit.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Reflectance</source>
            <translation>Facteur de réflexion</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Part of the light that the mirror reflects, at all angles: about 0.9 for aluminium, 0.97 for silver. It absorbs the rest.</source>
            <translation>Part de la lumière que le miroir réfléchit, à tous les angles : environ 0.9 pour l'aluminium, 0.97 pour l'argent. Il absorbe le reste.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>How far the flat back of the plate is behind the highest point of the mirror, in exports of the plate.</source>
            <translation>À quelle distance le dos plan de la plaque est derrière le point le plus haut du miroir, dans les exports de la plaque.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Where light is wanted, and which. Two freeform faces can form several images; one face forms a compromise.</source>
            <translation>Où la lumière est voulue, et laquelle. Deux faces de forme libre peuvent former plusieurs images ; une seule forme un compromis.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Image</source>
            <translation>Image</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>A receiver with the light that is wanted on it. It takes no light from other images.</source>
            <translation>Un récepteur avec la lumière qui y est voulue. Il ne prend aucune lumière aux autres images.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Receiver</source>
            <translation>Récepteur</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Where the light is wanted: on a plane or in directions.</source>
            <translation>Où la lumière est voulue : sur un plan ou dans des directions.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Rectangle of a plane. Its coordinates go along its sides, from its middle.</source>
            <translation>Rectangle d'un plan. Ses coordonnées suivent ses côtés, à partir de son milieu.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Where the middle of the plane stands: x, y and z.</source>
            <translation>La position du milieu du plan : x, y et z.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>How the plane is turned about its middle: about its x, which takes its upper edge away from or towards the lens, then about its new y, then about its new z. Rows and columns turn with it.</source>
            <translation>La rotation du plan autour de son milieu : autour de son x, ce qui éloigne ou rapproche son bord supérieur de la lentille, puis de son nouvel y, puis de son nouveau z. Lignes et colonnes tournent avec lui.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Half of the screen's extent along x and y. The target fills it.</source>
            <translation>La moitié de l'étendue de l'écran selon x et y. La cible le remplit.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Pixels</source>
            <translation>Pixels</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Pixels along x and y in which the light is counted and compared with the target.</source>
            <translation>Pixels selon x et y dans lesquels la lumière est comptée et comparée à la cible.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Far field</source>
            <translation>Champ lointain</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Directions of the light that leaves the lens, as if a screen were infinitely far.</source>
            <translation>Directions de la lumière qui quitte la lentille, comme si un écran était infiniment loin.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Half angle</source>
            <translation>Demi-angle</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Half of the angles that it covers to the right and upwards. The target fills it.</source>
            <translation>La moitié des angles qu'il couvre à droite et vers le haut. La cible le remplit.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Centre</source>
            <translation>Centre</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Its middle: angle to the right and angle upwards from the optical axis.</source>
            <translation>Son milieu : angle à droite et angle vers le haut depuis l'axe optique.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>The image that the light shall draw there.</source>
            <translation>L'image que la lumière doit y dessiner.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Image file</source>
            <translation>Fichier d'image</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Bright pixels get much light, black ones and transparent ones none.</source>
            <translation>Les pixels clairs reçoivent beaucoup de lumière, les noirs et les transparents aucune.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Image file; bright pixels get much light, black ones and transparent ones none. Where all that is drawn is black, as in many a logo on a transparent ground, the drawing itself gets the light. It is fitted into the screen, or into the far field's angles, with its aspect kept. A relative path starts at the scene file's folder.</source>
            <translation>Fichier d'image ; les pixels clairs reçoivent beaucoup de lumière, les noirs et les transparents aucune. Où tout le dessin est noir, comme pour bien des logos sur fond transparent, le dessin lui-même reçoit la lumière. Il est ajusté à l'écran, ou aux angles du champ lointain, en gardant son format. Un chemin relatif part du dossier du fichier de scène.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Brightness</source>
            <translation>Luminosité</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>What a pixel value means. A monitor shows half of the largest value as a fifth of the light: a photograph looks as it does there only where that is undone (sRGB). As stored, the value itself is the light: half of it is half the light. A colour profile in the file counts in place of this.</source>
            <translation>Ce que signifie une valeur de pixel. Un moniteur montre la moitié de la plus grande valeur comme un cinquième de la lumière : une photographie n'a le même aspect que si cela est annulé (sRGB). Telle qu'enregistrée, la valeur est la lumière : la moitié de la valeur est la moitié de la lumière. Un profil de couleur dans le fichier compte à la place.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>As stored</source>
            <translation>Telle que stockée</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>As shown by a monitor</source>
            <translation>Comme sur un moniteur</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Fit</source>
            <translation>Ajustement</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Whether all of the picture is seen, with a black border where the screen or the far field has another aspect, or that is filled, and what is beyond it is cut away.</source>
            <translation>Si toute l'image est vue, avec un bord noir où l'écran ou le champ lointain a un autre format, ou si celui-ci est rempli, et ce qui dépasse coupé.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>All of the picture</source>
            <translation>Toute l'image</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Without a border</source>
            <translation>Sans bord</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Turn</source>
            <translation>Tourner</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Turns the picture.</source>
            <translation>Tourne l'image.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>As it is</source>
            <translation>Telle quelle</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>A quarter to the left</source>
            <translation>Un quart de tour à gauche</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>A quarter to the right</source>
            <translation>Un quart de tour à droite</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Upside down</source>
            <translation>À l'envers</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Cut away</source>
            <translation>Rogner</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>What is cut away at the left, top, right and bottom of the picture, as fractions of its width and height, before it is turned.</source>
            <translation>Ce qui est coupé à gauche, en haut, à droite et en bas de l'image, en fractions de sa largeur et de sa hauteur, avant rotation.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>of the picture</source>
            <translation>de l'image</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Padding</source>
            <translation>Marge</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Black border on each side as a fraction of the whole image; it keeps light away from the edge.</source>
            <translation>Bord noir de chaque côté, en fraction de l'image entière ; il tient la lumière loin du bord.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>of width</source>
            <translation>de la largeur</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Blur</source>
            <translation>Flou</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Standard deviation of a Gaussian over the target. Soft edges are easier for a smooth lens.</source>
            <translation>Écart type d'une gaussienne sur la cible. Des bords doux sont plus faciles pour une lentille lisse.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Invert</source>
            <translation>Inverser</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Swap bright and dark.</source>
            <translation>Échanger clair et sombre.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Viewed from</source>
            <translation>Vu depuis</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>The side of the receiver from which the picture reads the right way round. An opaque wall, a table, or a far field on a distant wall is viewed from the side of the light, a rear projection from behind the receiver. If it is left out, column 0 of the picture lies at −x: it then reads right from behind with a lens, from the side of the light with a mirror.</source>
            <translation>Le côté du récepteur d'où l'image se lit à l'endroit. Un mur opaque, une table ou un champ lointain sur un mur éloigné se regarde du côté de la lumière, une rétroprojection de derrière le récepteur. Sans indication, la colonne 0 de l'image est à −x : elle se lit alors à l'endroit de derrière avec une lentille, du côté de la lumière avec un miroir.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Column 0 at −x</source>
            <translation>Colonne 0 à −x</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>The side of the light</source>
            <translation>Le côté de la lumière</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Behind the receiver</source>
            <translation>Derrière le récepteur</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>A uniform disc.</source>
            <translation>Un disque uniforme.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Radius of the shape as a fraction of the smaller half-width of the whole image.</source>
            <translation>Rayon de la forme en fraction de la plus petite demi-largeur de l'image entière.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>of half width</source>
            <translation>de la demi-largeur</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>A flame-like logo on black.</source>
            <translation>Un logo en forme de flamme sur fond noir.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Height of the shape as a fraction of the smaller width of the whole image.</source>
            <translation>Hauteur de la forme en fraction de la plus petite largeur de l'image entière.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>A faceted ball in several greys.</source>
            <translation>Un ballon à facettes en plusieurs gris.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>A uniform rectangle; as large as the whole image, all of it evenly lit.</source>
            <translation>Un rectangle uniforme ; aussi grand que l'image entière, il l'éclaire tout entière uniformément.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Width</source>
            <translation>Largeur</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Width of the rectangle as a fraction of that of the whole image.</source>
            <translation>Largeur du rectangle en fraction de celle de l'image entière.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>of the whole image</source>
            <translation>de l'image entière</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Height of the rectangle as a fraction of that of the whole image; a small one makes a line.</source>
            <translation>Hauteur du rectangle en fraction de celle de l'image entière ; une petite fait une ligne.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Ring</source>
            <translation>Anneau</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>A uniform ring.</source>
            <translation>Un anneau uniforme.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Inner radius</source>
            <translation>Rayon intérieur</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>As a fraction of the radius.</source>
            <translation>En fraction du rayon.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>of radius</source>
            <translation>du rayon</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Text</source>
            <translation>Texte</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Words, as large as the whole image lets them be.</source>
            <translation>Des mots, aussi grands que l'image entière le permet.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>The words; \n begins a new line.</source>
            <translation>Les mots ; \n commence une nouvelle ligne.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Weight</source>
            <translation>Poids</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Factor of the square of this image's relative error in a design of several images.</source>
            <translation>Facteur du carré de l'erreur relative de cette image dans une conception à plusieurs images.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Image filter</source>
            <translation>Filtre d'image</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>How a ray's light is shared among pixels, by the paper's method and in derivative maps. Automatic has no filter.</source>
            <translation>Comment la lumière d'un rayon est répartie entre pixels, par la méthode de l'article et dans les cartes de dérivées. Automatique n'a pas de filtre.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Gaussian</source>
            <translation>Gaussien</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Light falls off over some pixels, so that a design feels where in a pixel a ray lands.</source>
            <translation>La lumière décroît sur quelques pixels, de sorte qu'une conception sent où un rayon tombe dans un pixel.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Size</source>
            <translation>Taille</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Pixels along x and y that one ray reaches; odd numbers.</source>
            <translation>Pixels selon x et y qu'atteint un rayon ; nombres impairs.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Alpha</source>
            <translation>Alpha</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>How fast the Gaussian falls: exp(−alpha · distance²). Small is wide.</source>
            <translation>La vitesse de décroissance de la gaussienne : exp(−alpha · distance²). Petit est large.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Box</source>
            <translation>Boîte</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Every ray counts fully in the pixel that it hits.</source>
            <translation>Chaque rayon compte entièrement dans le pixel qu'il touche.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Parts of the screen, or of the angles of the far field, whose light is stated by itself, as on a desk or a lane: how much there is, and how even it is; of several images, the same parts of each. They do not change the lens.</source>
            <translation>Parties de l'écran ou des angles du champ lointain dont la lumière est indiquée à part, comme sur un bureau ou une voie : sa quantité et son uniformité ; de plusieurs images, les mêmes parties de chacune. Elles ne changent pas la lentille.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>A rectangle.</source>
            <translation>Un rectangle.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Middle</source>
            <translation>Milieu</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Where its middle is, from that of the receiver.</source>
            <translation>Où est son milieu, depuis celui du récepteur.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Its whole width and height.</source>
            <translation>Ses largeur et hauteur totales.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>What figures of the region are called.</source>
            <translation>Le nom des chiffres de la région.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>An ellipse; a circle where the receiver's aspect and its own make one.</source>
            <translation>Une ellipse ; un cercle où le format du récepteur et le sien en font un.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Polygon</source>
            <translation>Polygone</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>A polygon, whose corners are drawn on an image.</source>
            <translation>Un polygone, dont les coins sont dessinés sur une image.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Corners</source>
            <translation>Coins</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>In their order around it, from the receiver's middle.</source>
            <translation>Dans leur ordre tout autour, depuis le milieu du récepteur.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Run</source>
            <translation>Exécution</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>How the design is found.</source>
            <translation>Comment la conception est trouvée.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>The best that this program knows; it may stop before all iterations are done.</source>
            <translation>Le meilleur que connaît ce programme ; il peut s'arrêter avant la dernière itération.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Upper limit of iterations. Automatic may stop sooner, when nothing improves.</source>
            <translation>Limite supérieure d'itérations. Automatique peut s'arrêter plus tôt, quand rien ne s'améliore.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>What the run goes through before the scene as it stands.</source>
            <translation>Ce par quoi passe l'exécution avant la scène telle quelle.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Stage</source>
            <translation>Étape</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>A part of the run, before the scene itself is run, with some things different.</source>
            <translation>Une partie de l'exécution, avant la scène elle-même, où certaines choses diffèrent.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Upper limit of iterations of this stage. They count within those of the run; what all stages leave is for the scene itself.</source>
            <translation>Limite supérieure d'itérations de cette étape. Elles comptent dans celles de l'exécution ; ce que les étapes laissent est pour la scène elle-même.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>How the lens is searched for in this stage.</source>
            <translation>Comment la lentille est cherchée dans cette étape.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>As in the paper</source>
            <translation>Comme dans l'article</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Learning rate</source>
            <translation>Taux d'apprentissage</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Step of the optimiser. Too large and the loss jumps, too small and it creeps. Left empty, it is that of the scene.</source>
            <translation>Pas de l'optimiseur. Trop grand, le coût saute ; trop petit, il rampe. Vide : celui de la scène.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Numbers of control points along x and y in this stage. A coarse net moves light over long distances soon; the next stage goes on with the same surface on a finer one. Left empty, they are the lens's.</source>
            <translation>Nombres de points de contrôle selon x et y dans cette étape. Un réseau grossier déplace vite la lumière au loin ; l'étape suivante poursuit avec la même surface sur un plus fin. Vide : ceux de la lentille.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Smoothness</source>
            <translation>Lissage</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Weight of the exit face's bending energy beside the square of the image's error; it has no unit. 0.001 calms ripples, 0.01 costs sharpness. Left empty, the face may bend as it likes.</source>
            <translation>Poids de l'énergie de flexion de la face de sortie à côté du carré de l'erreur de l'image ; sans unité. 0.001 calme les ondulations, 0.01 coûte de la netteté. Vide : la face peut fléchir à son gré.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Smallest radius</source>
            <translation>Plus petit rayon</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Smallest radius of curvature that the exit face may have, concave and convex: that of the tool. A run that has settled keeps to it; dark edges get softer. Left empty, any will do.</source>
            <translation>Plus petit rayon de courbure permis à la face de sortie, concave et convexe : celui de l'outil. Une exécution stabilisée s'y tient ; les bords sombres s'adoucissent. Vide : quelconque.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Ball cutter radius</source>
            <translation>Rayon de la fraise</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Radius of the ball cutter that has to fit everywhere on the freeform faces. Hollows keep to it; humps may be sharper. Manufacture tells whether it fits. Left empty, any will do.</source>
            <translation>Rayon de la fraise hémisphérique qui doit convenir partout aux faces de forme libre. Les creux s'y tiennent ; les bosses peuvent être plus vives. Fabrication dit si elle convient. Vide : quelconque.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Start of the random numbers; the same seed repeats the same run.</source>
            <translation>Départ des nombres aléatoires ; la même graine répète la même exécution.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Computes on</source>
            <translation>Calcule sur</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>The graphics card needs a CUDA device and a PyTorch built for it.</source>
            <translation>La carte graphique demande un appareil CUDA et un PyTorch compilé pour lui.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Processor</source>
            <translation>Processeur</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Graphics card (CUDA)</source>
            <translation>Carte graphique (CUDA)</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>The published method, for comparison: Adam on control heights, or through a network.</source>
            <translation>La méthode publiée, pour comparer : Adam sur les hauteurs de contrôle, ou à travers un réseau.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Optimises</source>
            <translation>Optimise</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>What the optimiser moves: one number per control height, or the weights of a network that puts the heights out. In a sparse network the neurons of control points that share a piece of the face are linked, in a dense one all are.</source>
            <translation>Ce que l'optimiseur déplace : un nombre par hauteur de contrôle, ou les poids d'un réseau qui produit les hauteurs. Dans un réseau creux, les neurones de points de contrôle qui partagent un morceau de la face sont liés, dans un dense tous le sont.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Sparse network</source>
            <translation>Réseau creux</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Dense network</source>
            <translation>Réseau dense</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Parameters before the first iteration: all zero, in ±0.0001, or drawn from the seed so that the lens is crooked. A network that starts with zeros behaves as if there were none.</source>
            <translation>Paramètres avant la première itération : tous nuls, dans ±0.0001, ou tirés de la graine de sorte que la lentille est tordue. Un réseau qui part de zéros se comporte comme s'il n'y en avait pas.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Faint noise</source>
            <translation>Bruit faible</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Step of the optimiser. Too large and the loss jumps, too small and it creeps. Left empty, it is the one that suits what is optimised.</source>
            <translation>Pas de l'optimiseur. Trop grand, le coût saute ; trop petit, il rampe. Vide : celui qui convient à ce qui est optimisé.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Sunlit plate</source>
            <translation>Plaque au soleil</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>A clear plate in the sun throws a picture onto a wall or table nearby.</source>
            <translation>Une plaque claire au soleil projette une image sur un mur ou une table proche.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>What the light shall draw: a picture file, a shape or a word.</source>
            <translation>Ce que la lumière doit dessiner : un fichier d'image, une forme ou un mot.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Lens size</source>
            <translation>Taille de la lentille</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Full width and height of the lens; all of it is lit.</source>
            <translation>Largeur et hauteur totales de la lentille ; elle est éclairée tout entière.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>What the lens is made of. Any index can be given later.</source>
            <translation>De quoi la lentille est faite. Tout indice peut être donné plus tard.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Acrylic (PMMA)</source>
            <translation>Acrylique (PMMA)</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Polycarbonate</source>
            <translation>Polycarbonate</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Polystyrene</source>
            <translation>Polystyrène</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Glass (N-BK7)</source>
            <translation>Verre (N-BK7)</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Fused silica</source>
            <translation>Silice fondue</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Stock thickness</source>
            <translation>Épaisseur du brut</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Thickness of the plate that the lens is cut from. Left empty, any will do, and one is proposed.</source>
            <translation>Épaisseur de la plaque dont la lentille est tirée. Vide : quelconque, et une est proposée.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Distance to the image</source>
            <translation>Distance à l'image</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>From the entrance face of the lens to the image.</source>
            <translation>De la face d'entrée de la lentille à l'image.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Image size</source>
            <translation>Taille de l'image</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Full width and height of the image; the picture is fitted into it.</source>
            <translation>Largeur et hauteur totales de l'image ; le motif y est ajusté.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Torch or phone</source>
            <translation>Lampe torche ou téléphone</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>The light of a telephone or a torch throws a picture onto a wall.</source>
            <translation>La lumière d'un téléphone ou d'une lampe torche projette une image sur un mur.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Lamp size</source>
            <translation>Taille de la lampe</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Full width and height of what shines: 1 to 2 mm in a telephone.</source>
            <translation>Largeur et hauteur totales de ce qui brille : 1 à 2 mm dans un téléphone.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>All light of the lamp, as its data sheet says. With it, light is given in lux and lumen; left empty, in parts of all light.</source>
            <translation>Toute la lumière de la lampe, selon sa fiche technique. Avec elle, la lumière est indiquée en lux et en lumens ; sans elle, en parties de toute la lumière.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Lamp to lens</source>
            <translation>De la lampe à la lentille</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>From the lamp to the entrance face of the lens.</source>
            <translation>De la lampe à la face d'entrée de la lentille.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>LED close by</source>
            <translation>LED proche</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>An LED close to its lens lights a rectangle or another shape evenly.</source>
            <translation>Une LED proche de sa lentille éclaire uniformément un rectangle ou une autre forme.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>LED size</source>
            <translation>Taille de la LED</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Full width and height of the LED's bright face.</source>
            <translation>Largeur et hauteur totales de la face lumineuse de la LED.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Laser beam shaper</source>
            <translation>Mise en forme laser</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>A Gaussian laser beam becomes an even disc, a rectangle or any other shape.</source>
            <translation>Un faisceau laser gaussien devient un disque uniforme, un rectangle ou toute autre forme.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Beam diameter</source>
            <translation>Diamètre du faisceau</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Where the irradiance has fallen to 1/e² (13.5 %) of that in the middle, across the beam.</source>
            <translation>Où l'éclairement est tombé à 1/e² (13.5 %) de celui du milieu, en travers du faisceau.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Of the laser. It decides the index, and how far light spreads.</source>
            <translation>Du laser. Elle décide de l'indice, et de l'étalement de la lumière.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>A lamp at the ceiling, or on the floor, lights a wall evenly from the side.</source>
            <translation>Une lampe au plafond, ou au sol, éclaire un mur uniformément de côté.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Lit wall</source>
            <translation>Mur éclairé</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Full width and height of what shall be lit of the wall.</source>
            <translation>Largeur et hauteur totales de ce qui doit être éclairé du mur.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Lamp to wall</source>
            <translation>De la lampe au mur</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>From the lamp straight to the wall.</source>
            <translation>De la lampe au mur, par le plus court chemin.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Lamp above the middle</source>
            <translation>Lampe au-dessus du milieu</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>How much higher than the middle of the lit wall the lamp is; below it, less than 0.</source>
            <translation>De combien la lampe est plus haute que le milieu du mur éclairé ; au-dessous, moins de 0.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Far field of a lamp</source>
            <translation>Champ lointain d'une lampe</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>A lamp of a photometric file sends its light into wanted directions, far away.</source>
            <translation>Une lampe d'un fichier photométrique envoie sa lumière dans des directions voulues, au loin.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Lamp file</source>
            <translation>Fichier de la lampe</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Intensity by direction, in a file of IES LM-63 (.ies) or EULUMDAT (.ldt).</source>
            <translation>Intensité par direction, dans un fichier IES LM-63 (.ies) ou EULUMDAT (.ldt).</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Image angles</source>
            <translation>Angles de l'image</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Full angles of the image across and upwards.</source>
            <translation>Angles totaux de l'image en travers et vers le haut.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>A mirror in collimated light, or in the sun, throws a picture to the side.</source>
            <translation>Un miroir en lumière collimatée, ou au soleil, projette une image sur le côté.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Mirror size</source>
            <translation>Taille du miroir</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Full width and height of the mirror; all of it is lit.</source>
            <translation>Largeur et hauteur totales du miroir ; il est éclairé tout entier.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Full angle of the light: 0.533 for the sun, 0 for a laser.</source>
            <translation>Angle total de la lumière : 0.533 pour le soleil, 0 pour un laser.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>From the mirror to the middle of the image.</source>
            <translation>Du miroir au milieu de l'image.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>To the side</source>
            <translation>De côté</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Angle between the light that comes and the light that goes, which has to pass the image on its way.</source>
            <translation>Angle entre la lumière qui vient et celle qui part, qui doit passer à côté de l'image en chemin.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Experiments of the paper</source>
            <translation>Expériences de l'article</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Designs of de Koning, Heemels, Adam and Möller (2023), to repeat or to improve on.</source>
            <translation>Conceptions de de Koning, Heemels, Adam et Möller (2023), à répéter ou à améliorer.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Experiment</source>
            <translation>Expérience</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>A design of the paper.</source>
            <translation>Une conception de l'article.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>How the lens is found: by the best that this program knows, on as many control points as the target needs, or as then. The 64 × 64 control points of the paper are too few for fine detail: a flame stays 19 % off.</source>
            <translation>Comment la lentille est trouvée : par le meilleur que connaît ce programme, sur autant de points de contrôle qu'il en faut pour la cible, ou comme alors. Les 64 × 64 points de contrôle de l'article sont trop peu pour de fins détails : une flamme reste à 19 % d'écart.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Empty</source>
            <translation>Vide</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>A square lens in collimated light and a screen behind it; all fields are yours to change.</source>
            <translation>Une lentille carrée en lumière collimatée et un écran derrière ; tous les champs peuvent être changés.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>From {} to {}.</source>
            <translation>De {} à {}.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Above {} to {}.</source>
            <translation>Au-dessus de {} jusqu'à {}.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>From {} to below {}.</source>
            <translation>De {} à moins de {}.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Above {} to below {}.</source>
            <translation>Au-dessus de {}, à moins de {}.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>passes beside it</source>
            <translation>passe à côté</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>a larger screen catches it</source>
            <translation>un écran plus grand la capte</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>a larger far field catches it</source>
            <translation>un champ lointain plus grand la capte</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>misses the lens</source>
            <translation>manque la lentille</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>a larger lens catches it</source>
            <translation>une lentille plus grande la capte</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>leaves by the side</source>
            <translation>sort par le côté</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>a thinner lens, or a source farther away or nearer to the axis, keeps it</source>
            <translation>une lentille plus mince, ou une source plus éloignée ou plus proche de l'axe, la garde</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>is totally reflected</source>
            <translation>subit une réflexion totale</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>{flatter}thicker stock, a lower index or a target that needs less bending lets it out</source>
            <translation>{flatter}un brut plus épais, un indice plus faible ou une cible qui demande moins de déviation la laisse sortir</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>is reflected at the entrance</source>
            <translation>est réfléchi à l'entrée</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>an antireflection coating, a lower index or a source nearer to the axis lets it in</source>
            <translation>un traitement antireflet, un indice plus faible ou une source plus près de l'axe la laisse entrer</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>is reflected at the exit</source>
            <translation>est réfléchi à la sortie</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>an antireflection coating, {flatter}a lower index or a target that needs less bending lets it out</source>
            <translation>un traitement antireflet, {flatter}un indice plus faible ou une cible qui demande moins de déviation la laisse sortir</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>is absorbed by the glass</source>
            <translation>est absorbé par le verre</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>a thinner lens or a clearer glass lets more of it through</source>
            <translation>une lentille plus mince ou un verre plus clair en laisse passer davantage</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>misses the mirror</source>
            <translation>manque le miroir</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>a larger mirror catches it</source>
            <translation>un miroir plus grand la capte</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>is absorbed by the mirror</source>
            <translation>est absorbé par le miroir</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>a coating with a higher reflectance reflects it</source>
            <translation>un revêtement plus réfléchissant la réfléchit</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>body of glass</source>
            <translation>corps de verre</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>missing; it is required</source>
            <translation>manque ; il est nécessaire</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>{input} is too small; must be greater than {gt:.10g}</source>
            <translation>{input} est trop petit ; il faut plus de {gt:.10g}</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>{input} is too small; at least {ge:.10g}</source>
            <translation>{input} est trop petit ; au moins {ge:.10g}</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>{input} is too large; must be less than {lt:.10g}</source>
            <translation>{input} est trop grand ; il faut moins de {lt:.10g}</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>{input} is too large; at most {le:.10g}</source>
            <translation>{input} est trop grand ; au plus {le:.10g}</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>{input} is not available; allowed: {expected}</source>
            <translation>{input} n'existe pas ; permis : {expected}</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>{input} is even; an odd number is needed</source>
            <translation>{input} est pair ; il faut un nombre impair</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>{input} is not finite; a finite number is needed</source>
            <translation>{input} n'est pas fini ; il faut un nombre fini</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>{input} is not a number; a number is needed</source>
            <translation>{input} n'est pas un nombre ; il faut un nombre</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>{input} is not a whole number; a whole number is needed</source>
            <translation>{input} n'est pas un nombre entier ; il faut un nombre entier</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>{input} is neither true nor false; true or false is needed</source>
            <translation>{input} n'est ni true ni false ; il faut true ou false</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>{input} is not text; text is needed</source>
            <translation>{input} n'est pas un texte ; il faut un texte</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>{input} is empty; some text is needed</source>
            <translation>{input} est vide ; il faut un texte</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>{input} has other signs; letters, digits, - and _ are possible</source>
            <translation>{input} a d'autres signes ; lettres, chiffres, - et _ sont possibles</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>{input} is not a list; a list of numbers is needed</source>
            <translation>{input} n'est pas une liste ; il faut une liste de nombres</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>{input} is not an object; an object with named fields is needed</source>
            <translation>{input} n'est pas un objet ; il faut un objet aux champs nommés</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>not valid JSON: {error}</source>
            <translation>JSON non valide : {error}</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>unknown field; known here: {fields}</source>
            <translation>champ inconnu ; connus ici : {fields}</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>{actual_length} values given; at least {min_length} are needed</source>
            <translation>{actual_length} valeurs données ; il en faut au moins {min_length}</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>{actual_length} values given; exactly {max_length} are needed</source>
            <translation>{actual_length} valeurs données ; il en faut exactement {max_length}</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>{input}: two whole numbers or 'auto' are needed</source>
            <translation>{input} : il faut deux nombres entiers ou 'auto'</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>{input} is neither a name nor an index above 1</source>
            <translation>{input} n'est ni un nom ni un indice supérieur à 1</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Largest angle between lens and optical axis</source>
            <translation>Plus grand angle entre lentille et axe optique</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Largest angle between mirror and optical axis</source>
            <translation>Plus grand angle entre miroir et axe optique</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Decentre</source>
            <translation>Décentrement</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Largest distance of the lens from the axis</source>
            <translation>Plus grande distance de la lentille à l'axe</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Largest distance of the mirror from the axis</source>
            <translation>Plus grande distance du miroir à l'axe</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Exit tilt</source>
            <translation>Inclin. sortie</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Largest tilt of the exit face against the entrance</source>
            <translation>Plus grande inclinaison de la face de sortie sur l'entrée</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Exit decentre</source>
            <translation>Décentr. sortie</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Largest shift of the exit face over the entrance</source>
            <translation>Plus grand décalage de la face de sortie sur l'entrée</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Index ±</source>
            <translation>Indice ±</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Largest error of the refractive index</source>
            <translation>Plus grande erreur de l'indice de réfraction</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Screen ±</source>
            <translation>Écran ±</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Largest error of the screen's distance</source>
            <translation>Plus grande erreur de la distance de l'écran</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Source tilt</source>
            <translation>Inclin. source</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Largest tilt of the source about its middle</source>
            <translation>Plus grande inclinaison de la source autour de son milieu</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Source shift</source>
            <translation>Décal. source</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Largest shift of the source, in any direction</source>
            <translation>Plus grand décalage de la source, dans toute direction</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Root mean square of the error of the exit face, or of the mirror, and the length over which it is alike: some micrometres over some millimetres when milled</source>
            <translation>Moyenne quadratique de l'erreur de la face de sortie, ou du miroir, et la longueur sur laquelle elle est semblable : quelques micromètres sur quelques millimètres après fraisage</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Entrance surface</source>
            <translation>Surface d'entrée</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>The same two of the entrance face</source>
            <translation>Les deux mêmes pour la face d'entrée</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>height</source>
            <translation>hauteur</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Deviation along z from the base, or of the entrance face from its place</source>
            <translation>Écart selon z à la base, ou de la face d'entrée à sa place</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>slope</source>
            <translation>pente</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>mean curvature</source>
            <translation>courbure moyenne</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Mean of the principal curvatures, positive where the face is concave, negative where it is convex</source>
            <translation>Moyenne des courbures principales, positive où la face est concave, négative où elle est convexe</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Gaussian curvature</source>
            <translation>courbure de Gauss</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Product of the principal curvatures: positive in a bowl and on a hump, negative on a saddle, zero where the face is bent in one direction only</source>
            <translation>Produit des courbures principales : positif dans un creux et sur une bosse, négatif sur une selle, nul où la face n'est courbée que dans une direction</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>largest curvature</source>
            <translation>plus grande courbure</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Larger principal curvature, positive where the face is concave, negative where it is convex; one over the smallest concave radius</source>
            <translation>Plus grande courbure principale, positive où la face est concave, négative où elle est convexe ; inverse du plus petit rayon concave</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>smallest curvature</source>
            <translation>plus petite courbure</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Smaller principal curvature, positive where the face is concave, negative where it is convex; one over the smallest convex radius</source>
            <translation>Plus petite courbure principale, positive où la face est concave, négative où elle est convexe ; inverse du plus petit rayon convexe</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Concave curvature</source>
            <translation>Courbure concave</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Convex curvature</source>
            <translation>Courbure convexe</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>fused silica</source>
            <translation>silice fondue</translation>
        </message>
        <message>
            <location filename="../../workbench/design/endings.py" />
            <source>all iterations are done</source>
            <translation>toutes les itérations sont faites</translation>
        </message>
        <message>
            <location filename="../../workbench/design/endings.py" />
            <source>all control points are locked</source>
            <translation>tous les points de contrôle sont verrouillés</translation>
        </message>
        <message>
            <location filename="../../workbench/design/endings.py" />
            <source>stopped</source>
            <translation>arrêté</translation>
        </message>
        <message>
            <location filename="../../workbench/design/endings.py" />
            <source>converged: error below {error:g} %</source>
            <translation>convergé : erreur sous {error:g} %</translation>
        </message>
        <message>
            <location filename="../../workbench/design/endings.py" />
            <source>converged: no step makes the image better</source>
            <translation>convergé : aucun pas n'améliore l'image</translation>
        </message>
        <message>
            <location filename="../../workbench/design/endings.py" />
            <source>converged: less than {gain:g} % better in {patience} iterations</source>
            <translation>convergé : moins de {gain:g} % de mieux en {patience} itérations</translation>
        </message>
        <message>
            <location filename="../../workbench/design/endings.py" />
            <source>converged: error less than {points:g} percentage points lower in {patience} iterations</source>
            <translation>convergé : erreur réduite de moins de {points:g} point de pourcentage en {patience} itérations</translation>
        </message>
        <message>
            <location filename="../../workbench/design/endings.py" />
            <source>{ended}; no iteration made the lens better</source>
            <translation>{ended} ; aucune itération n'a amélioré la lentille</translation>
        </message>
        <message>
            <location filename="../../workbench/design/endings.py" />
            <source>{ended}; the exit face alone makes no image</source>
            <translation>{ended} ; la face de sortie seule ne fait pas d'image</translation>
        </message>
        <message>
            <location filename="../../workbench/design/endings.py" />
            <source>{ended}; after {iterations} iterations the error of both faces was {times:.2g} times that of the exit face behind a flat entrance</source>
            <translation>{ended} ; après {iterations} itérations, l'erreur des deux faces était {times:.2g} fois celle de la face de sortie derrière une entrée plane</translation>
        </message>
        <message>
            <location filename="../../workbench/design/endings.py" />
            <source>failed: {why}</source>
            <translation>échec : {why}</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/agreement.py" />
            <source>the check contradicts itself: {cells:.4g} % of the light on the receiver by cells, {rays:.4g} % by random rays; no figure of this check is reliable</source>
            <translation>la vérification se contredit : {cells:.4g} % de la lumière sur le récepteur par cellules, {rays:.4g} % par rayons aléatoires ; aucune valeur de cette vérification n'est fiable</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/agreement.py" />
            <source>the check contradicts itself: the images by cells and by random rays are {apart:.3g} % apart, which noise and error bound do not explain; no figure of this check is reliable</source>
            <translation>la vérification se contredit : les images par cellules et par rayons aléatoires sont à {apart:.3g} % l'une de l'autre, ce que bruit et borne d'erreur n'expliquent pas ; aucune valeur de cette vérification n'est fiable</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/agreement.py" />
            <source>the run finds {run:.4g} % of the light on the receiver, the check {check:.4g} %: use the figures of the check</source>
            <translation>le calcul trouve {run:.4g} % de la lumière sur le récepteur, la vérification {check:.4g} % : utiliser les valeurs de la vérification</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/agreement.py" />
            <source>the image of the run is {apart:.3g} % off the image of the check: use the figures of the check</source>
            <translation>l'image du calcul s'écarte de {apart:.3g} % de celle de la vérification : utiliser les valeurs de la vérification</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/by_cells.py" />
            <source>finer cells would take too long</source>
            <translation>des cellules plus fines prendraient trop de temps</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/by_cells.py" />
            <source>that needs more rays</source>
            <translation>cela demande plus de rayons</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/by_cells.py" />
            <source>off by up to {off:g} %, not {wanted:.2g} %: {why}</source>
            <translation>jusqu'à {off:g} % d'écart, et non {wanted:.2g} % : {why}</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/cells/image.py" />
            <source>no light of this lens reaches the screen, so there is no image to judge</source>
            <translation>aucune lumière de cette lentille n'atteint l'écran : il n'y a pas d'image à juger</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/cross_check.py" />
            <source>no light of this lens reaches the screen, so there is nothing to compare</source>
            <translation>aucune lumière de cette lentille n'atteint l'écran : il n'y a rien à comparer</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/cut_lens.py" />
            <source>Error as cut {cut:.3g} % (± {cut_off:.1g}), as designed {designed:.3g} % (± {designed_off:.1g}).</source>
            <translation>Erreur telle qu'usinée {cut:.3g} % (± {cut_off:.1g}), telle que conçue {designed:.3g} % (± {designed_off:.1g}).</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/cut_lens.py" />
            <source>its cut is not traced; only that of an exit face is</source>
            <translation>sa coupe n'est pas tracée ; seule celle d'une face de sortie l'est</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/derivatives.py" />
            <source>{i} is no control point; 0 to {last}</source>
            <translation>{i} n'est pas un point de contrôle ; 0 à {last}</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/derivatives.py" />
            <source>'{kind}' counts rays by pixel, which has no derivative; 'gaussian'</source>
            <translation>'{kind}' compte les rayons par pixel, ce qui n'a pas de dérivée ; 'gaussian'</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/derivatives.py" />
            <source>1 counts rays by pixel, which has no derivative; 3 or more</source>
            <translation>1 compte les rayons par pixel, ce qui n'a pas de dérivée ; 3 ou plus</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/photo/light.py" />
            <source>laser of {wavelength:g} µm</source>
            <translation>laser de {wavelength:g} µm</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/photo/light.py" />
            <source>daylight (D65)</source>
            <translation>lumière du jour (D65)</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/photo/light.py" />
            <source>white LED</source>
            <translation>LED blanche</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/photo/light.py" />
            <source>equal energy</source>
            <translation>énergie égale</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/photo/photo.py" />
            <source>with cells</source>
            <translation>par cellules</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/photo/photo.py" />
            <source>with random rays</source>
            <translation>par rayons aléatoires</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/photo/photo.py" />
            <source>{side}; {light}, no dispersion known, {way}</source>
            <translation>{side} ; {light}, dispersion inconnue, {way}</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/photo/photo.py" />
            <source>{side}; {light}, {count} wavelengths from {first:g} to {last:g} µm, {step} pixels apart, {way}</source>
            <translation>{side} ; {light}, {count} longueurs d'onde de {first:g} à {last:g} µm, espacées de {step} pixels, {way}</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/photo/photo.py" />
            <source>no light of this lens reaches the screen, so there is nothing to see</source>
            <translation>aucune lumière de cette lentille n'atteint l'écran : il n'y a rien à voir</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/regions.py" />
            <source>{part:.3f} % of the light, least / mean {even}</source>
            <translation>{part:.3f} % de la lumière, minimum / moyenne {even}</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/regions.py" />
            <source>{part:.3f} % of the light, least / mean {even}, most / mean {most:.3f}</source>
            <translation>{part:.3f} % de la lumière, minimum / moyenne {even}, maximum / moyenne {most:.3f}</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/regions.py" />
            <source>{part:.3f} % of the light, {lumens}, mean {mean}, least {least}, most {most}, least / mean {even}</source>
            <translation>{part:.3f} % de la lumière, {lumens}, moyenne {mean}, minimum {least}, maximum {most}, minimum / moyenne {even}</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/shading.py" />
            <source>{part:.3g} % of the light</source>
            <translation>{part:.3g} % de la lumière</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/shading.py" />
            <source>{share}, most around ({x:.4g}, {y:.4g})</source>
            <translation>{share}, surtout autour de ({x:.4g}, {y:.4g})</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/tolerance_fields.py" />
            <source>{angle:g} degrees change nothing: {absent}; 0</source>
            <translation>{angle:g} degrés ne changent rien : {absent} ; 0</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/tolerance_fields.py" />
            <source>{size:g} changes nothing: {absent}; 0</source>
            <translation>{size:g} ne change rien : {absent} ; 0</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/tolerance_fields.py" />
            <source>{angle:g} degrees; at least 0, less than 45</source>
            <translation>{angle:g} degrés ; au moins 0, moins de 45</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/tolerance_fields.py" />
            <source>{size:g}; a finite number from 0 is needed</source>
            <translation>{size:g} ; il faut un nombre fini à partir de 0</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/tolerance_fields.py" />
            <source>a mirror has no other face</source>
            <translation>un miroir n'a pas d'autre face</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/tolerance_fields.py" />
            <source>there is no glass</source>
            <translation>il n'y a pas de verre</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/tolerance_fields.py" />
            <source>a far field is at no distance</source>
            <translation>un champ lointain n'a pas de distance</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/tolerance_fields.py" />
            <source>this source lights the lens alike however it is turned</source>
            <translation>cette source éclaire la lentille de même, comment qu'on la tourne</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/tolerance_fields.py" />
            <source>even light from infinitely far is the same everywhere</source>
            <translation>une lumière uniforme venue de l'infini est partout la même</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/tolerance_fields.py" />
            <source>else there may be no glass</source>
            <translation>sinon il peut ne pas y avoir de verre</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/tolerance_fields.py" />
            <source>else the screen may touch the lens</source>
            <translation>sinon l'écran peut toucher la lentille</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/tolerance_fields.py" />
            <source>else the screen may touch the mirror</source>
            <translation>sinon l'écran peut toucher le miroir</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/tolerance_fields.py" />
            <source>else the source may touch the lens</source>
            <translation>sinon la source peut toucher la lentille</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/tolerance_fields.py" />
            <source>else the source may touch the mirror</source>
            <translation>sinon la source peut toucher le miroir</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/tolerance_fields.py" />
            <source>{scale:g}; from {least:g} to {width:g}</source>
            <translation>{scale:g} ; de {least:g} à {width:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/tolerance_fields.py" />
            <source>{size:g}; at least 0, less than {room:g}, {otherwise}</source>
            <translation>{size:g} ; au moins 0, moins de {room:g}, {otherwise}</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/tolerances.py" />
            <source>the exit face may come {lower:.3g} nearer to the entrance face, more than half of the least thickness {half:.3g}: less is needed</source>
            <translation>la face de sortie peut s'approcher de {lower:.3g} de la face d'entrée, plus de la moitié de l'épaisseur minimale {half:.3g} : il en faut moins</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/tracing/trace.py" />
            <source>{rays} are too many; at most {most}</source>
            <translation>{rays} sont de trop ; au plus {most}</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/tracing/train.py" />
            <source>a receiver at z = {z:g} may touch the element {name}; more than {least:g}</source>
            <translation>un récepteur à z = {z:g} peut toucher l'élément {name} ; plus de {least:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/validation.py" />
            <source>cells follow light through one element only; random rays are used</source>
            <translation>les cellules ne suivent la lumière qu'à travers un seul élément ; des rayons aléatoires sont utilisés</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/validation.py" />
            <source>finer cells would take too long: ask for more rays</source>
            <translation>des cellules plus fines prendraient trop de temps : demander plus de rayons</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/validation.py" />
            <source>cells are off by up to {bound:.2g} %, more than random rays: ask for more rays</source>
            <translation>les cellules s'écartent de jusqu'à {bound:.2g} %, plus que les rayons aléatoires : demander plus de rayons</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/validation.py" />
            <source>so few rays of the file come to the screen that some of {parts} parts of them make no image: the check needs a file of more rays</source>
            <translation>si peu de rayons du fichier arrivent sur l'écran que certaines de {parts} parties d'entre eux ne font pas d'image : la vérification a besoin d'un fichier de plus de rayons</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/validation.py" />
            <source>so few rays of the file come to the far field that some of {parts} parts of them make no image: the check needs a file of more rays</source>
            <translation>si peu de rayons du fichier arrivent dans le champ lointain que certaines de {parts} parties d'entre eux ne font pas d'image : la vérification a besoin d'un fichier de plus de rayons</translation>
        </message>
        <message>
            <location filename="../../workbench/design/blurred_plan.py" />
            <source>its light is blurred over {x:.3g} × {y:.3g} pixels</source>
            <translation>la lumière est étalée sur {x:.3g} × {y:.3g} pixels</translation>
        </message>
        <message>
            <location filename="../../workbench/design/coarse_net.py" />
            <source>The image stays {error:.0f} % off: {n_u} × {n_v} control points are too few for the detail of this target. {finer_u} × {finer_v}, the automatic choice, can show it.</source>
            <translation>L'image reste à {error:.0f} % d'écart : {n_u} × {n_v} points de contrôle sont trop peu pour le détail de cette cible. {finer_u} × {finer_v}, le choix automatique, peuvent le montrer.</translation>
        </message>
        <message>
            <location filename="../../workbench/design/loss.py" />
            <source>{part:.1%} {where}</source>
            <translation>{part:.1%} {where}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/loss.py" />
            <source>no light reaches the screen: of the emitted light {went}; {cure}</source>
            <translation>aucune lumière n'atteint l'écran : de la lumière émise, {went} ; {cure}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/loss.py" />
            <source>no light reaches the far field: of the emitted light {went}; {cure}</source>
            <translation>aucune lumière n'atteint le champ lointain : de la lumière émise, {went} ; {cure}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/loss.py" />
            <source>the loss is {loss} although {part:.0%} of the light is on the screen</source>
            <translation>la perte vaut {loss} bien que {part:.0%} de la lumière soit sur l'écran</translation>
        </message>
        <message>
            <location filename="../../workbench/design/loss.py" />
            <source>the gradient of the loss is not finite for {bad} of {count} parameters</source>
            <translation>le gradient de la perte n'est pas fini pour {bad} des {count} paramètres</translation>
        </message>
        <message>
            <location filename="../../workbench/design/memory.py" />
            <source>memory: about {needed}</source>
            <translation>mémoire : environ {needed}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/memory.py" />
            <source>{n_x} × {n_y} pixels with {n_u} × {n_v} control points need about {needed} of memory, and {available} are free; take fewer of both, or close other programs</source>
            <translation>{n_x} × {n_y} pixels avec {n_u} × {n_v} points de contrôle demandent environ {needed} de mémoire, et {available} sont libres ; prenez-en moins, ou fermez d'autres programmes</translation>
        </message>
        <message>
            <location filename="../../workbench/design/needs.py" />
            <source>light grazes the far side of the screen, at {slant:.0f} degrees from across it, where the image is less exact; turn the screen towards the lens, or move its middle nearer to the axis</source>
            <translation>la lumière rase le côté lointain de l'écran, à {slant:.0f} degrés de la perpendiculaire, où l'image est moins exacte ; tournez l'écran vers la lentille, ou rapprochez son milieu de l'axe</translation>
        </message>
        <message>
            <location filename="../../workbench/design/needs.py" />
            <source>light grazes the far side of the far field, at {slant:.0f} degrees from across it, where the image is less exact; turn the far field towards the lens, or move its middle nearer to the axis</source>
            <translation>la lumière rase le côté lointain du champ lointain, à {slant:.0f} degrés de la perpendiculaire, où l'image est moins exacte ; tournez le champ lointain vers la lentille, ou rapprochez son milieu de l'axe</translation>
        </message>
        <message>
            <location filename="../../workbench/design/needs.py" />
            <source>light grazes the far side of the screen, at {slant:.0f} degrees from across it, where the image is less exact; turn the screen towards the mirror, or move its middle nearer to the axis</source>
            <translation>la lumière rase le côté lointain de l'écran, à {slant:.0f} degrés de la perpendiculaire, où l'image est moins exacte ; tournez l'écran vers le miroir, ou rapprochez son milieu de l'axe</translation>
        </message>
        <message>
            <location filename="../../workbench/design/needs.py" />
            <source>light grazes the far side of the far field, at {slant:.0f} degrees from across it, where the image is less exact; turn the far field towards the mirror, or move its middle nearer to the axis</source>
            <translation>la lumière rase le côté lointain du champ lointain, à {slant:.0f} degrés de la perpendiculaire, où l'image est moins exacte ; tournez le champ lointain vers le miroir, ou rapprochez son milieu de l'axe</translation>
        </message>
        <message>
            <location filename="../../workbench/design/needs.py" />
            <source>the picture is mirror-inverted for viewers on the side of the light, and reads right from behind the screen; target.viewed_from "front" turns it around</source>
            <translation>l'image est inversée pour qui regarde du côté de la lumière, et se lit à l'endroit de derrière l'écran ; target.viewed_from "front" la retourne</translation>
        </message>
        <message>
            <location filename="../../workbench/design/needs.py" />
            <source>the picture is mirror-inverted for viewers on the side of the light, and reads right from behind the far field; target.viewed_from "front" turns it around</source>
            <translation>l'image est inversée pour qui regarde du côté de la lumière, et se lit à l'endroit de derrière le champ lointain ; target.viewed_from "front" la retourne</translation>
        </message>
        <message>
            <location filename="../../workbench/design/needs.py" />
            <source>none of its light goes to the lens; turn or move it</source>
            <translation>aucune de sa lumière ne va vers la lentille ; tournez-la ou déplacez-la</translation>
        </message>
        <message>
            <location filename="../../workbench/design/needs.py" />
            <source>none of its light goes to the mirror; turn or move it</source>
            <translation>aucune de sa lumière ne va vers le miroir ; tournez-la ou déplacez-la</translation>
        </message>
        <message>
            <location filename="../../workbench/design/needs.py" />
            <source>{net} are not the control points of the finished lens that are locked; leave the stage's net out or unlock them</source>
            <translation>{net} ne sont pas les points de contrôle de la lentille finie, qui sont verrouillés ; omettez le réseau de l'étape ou déverrouillez-les</translation>
        </message>
        <message>
            <location filename="../../workbench/design/needs.py" />
            <source>{net} are not the control points of the finished mirror that are locked; leave the stage's net out or unlock them</source>
            <translation>{net} ne sont pas les points de contrôle du miroir fini, qui sont verrouillés ; omettez le réseau de l'étape ou déverrouillez-les</translation>
        </message>
        <message>
            <location filename="../../workbench/design/origin.py" />
            <source>absent</source>
            <translation>absent</translation>
        </message>
        <message>
            <location filename="../../workbench/design/origin.py" />
            <source>not designed yet</source>
            <translation>pas encore conçu</translation>
        </message>
        <message>
            <location filename="../../workbench/design/origin.py" />
            <source>designed for this task</source>
            <translation>conçu pour cette tâche</translation>
        </message>
        <message>
            <location filename="../../workbench/design/origin.py" />
            <source>designed for another task ({run}): {differences}</source>
            <translation>conçu pour une autre tâche ({run}) : {differences}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/origin.py" />
            <source>not designed for this task</source>
            <translation>non conçu pour cette tâche</translation>
        </message>
        <message>
            <location filename="../../workbench/design/origin.py" />
            <source>{path} {then}, now {now}</source>
            <translation>{path} {then}, maintenant {now}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/origin.py" />
            <source>another target image</source>
            <translation>une autre image cible</translation>
        </message>
        <message>
            <location filename="../../workbench/design/paper.py" />
            <source>'box' is constant within a pixel and gives the paper's method no gradient; 'gaussian'</source>
            <translation>'box' est constant dans un pixel et ne donne pas de gradient à la méthode de l'article ; 'gaussian'</translation>
        </message>
        <message>
            <location filename="../../workbench/design/paper.py" />
            <source>the paper's method</source>
            <translation>la méthode de l'article</translation>
        </message>
        <message>
            <location filename="../../workbench/design/parametrisation.py" />
            <source>'{name}' has {count:,} parameters here and needs {needed} for them, their gradient and Adam's moments; {available} are free</source>
            <translation>'{name}' a ici {count:,} paramètres et demande {needed} pour eux, leur gradient et les moments d'Adam ; {available} sont libres</translation>
        </message>
        <message>
            <location filename="../../workbench/design/room.py" />
            <source>heights within {most:.3g} {unit} of the base</source>
            <translation>hauteurs à {most:.3g} {unit} au plus de la base</translation>
        </message>
        <message>
            <location filename="../../workbench/design/run.py" />
            <source>the graphics card has too little free memory; compute on the processor, or take fewer pixels</source>
            <translation>la carte graphique a trop peu de mémoire libre ; calculez sur le processeur, ou prenez moins de pixels</translation>
        </message>
        <message>
            <location filename="../../workbench/design/run.py" />
            <source>{why}. {limit}</source>
            <translation>{why}. {limit}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/run.py" />
            <source>stopped at iteration {iteration}: {why}</source>
            <translation>arrêté à l'itération {iteration} : {why}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/run.py" />
            <source>control points: {n_u} × {n_v}, chosen for this task</source>
            <translation>points de contrôle : {n_u} × {n_v}, choisis pour cette tâche</translation>
        </message>
        <message>
            <location filename="../../workbench/design/session.py" />
            <source>it has {count} characters; 1 to {most} are needed</source>
            <translation>a {count} caractères ; il en faut 1 à {most}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/session.py" />
            <source>holds no lens yet; freeform design finds one</source>
            <translation>ne contient pas encore de lentille ; freeform design en trouve une</translation>
        </message>
        <message>
            <location filename="../../workbench/design/session.py" />
            <source>its lens was designed for another task, which was edited afterwards; freeform design goes on from it</source>
            <translation>sa lentille a été conçue pour une autre tâche, modifiée depuis ; freeform design repart d'elle</translation>
        </message>
        <message>
            <location filename="../../workbench/design/shortfall.py" />
            <source>widen the height range, or leave it out</source>
            <translation>élargir la plage de hauteur, ou l'omettre</translation>
        </message>
        <message>
            <location filename="../../workbench/design/shortfall.py" />
            <source>thicker stock, or a smaller minimal thickness, lets the lens bend more</source>
            <translation>un brut plus épais, ou une épaisseur minimale plus petite, permet à la lentille de dévier davantage</translation>
        </message>
        <message>
            <location filename="../../workbench/design/shortfall.py" />
            <source>a higher base or a smaller minimal thickness gives it room</source>
            <translation>une base plus haute ou une épaisseur minimale plus petite donne de la place</translation>
        </message>
        <message>
            <location filename="../../workbench/design/shortfall.py" />
            <source>move the screen away from the lens</source>
            <translation>éloigner l'écran de la lentille</translation>
        </message>
        <message>
            <location filename="../../workbench/design/shortfall.py" />
            <source>widen the entrance range</source>
            <translation>élargir la plage d'entrée</translation>
        </message>
        <message>
            <location filename="../../workbench/design/shortfall.py" />
            <source>The entrance face fills {part:.0f} % of its automatic range of {range} {unit}</source>
            <translation>La face d'entrée occupe {part:.0f} % de sa plage automatique de {range} {unit}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/shortfall.py" />
            <source>The entrance face fills {part:.0f} % of its range of {range} {unit}, and would bend more of the light in a wider one</source>
            <translation>La face d'entrée remplit {part:.0f} % de sa plage de {range} {unit}, et dévierait davantage de lumière dans une plage plus large</translation>
        </message>
        <message>
            <location filename="../../workbench/design/shortfall.py" />
            <source>{part:.0f} % of the control heights are at the minimal thickness of {thinnest:.3g} {unit}</source>
            <translation>{part:.0f} % des hauteurs de contrôle sont à l'épaisseur minimale de {thinnest:.3g} {unit}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/shortfall.py" />
            <source>{range} {unit} is the automatic limit</source>
            <translation>{range} {unit} est la limite automatique</translation>
        </message>
        <message>
            <location filename="../../workbench/design/shortfall.py" />
            <source>{range} {unit} is allowed</source>
            <translation>la limite est de {range} {unit}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/shortfall.py" />
            <source>{part:.0f} % of the control heights are at an end of their range; {allowed}</source>
            <translation>{part:.0f} % des hauteurs de contrôle sont à une extrémité de leur plage ; {allowed}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/shortfall.py" />
            <source>The lens needs {range} {unit}; {allowed}</source>
            <translation>La lentille a besoin de {range} {unit} ; {allowed}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/shortfall.py" />
            <source>The mirror needs {range} {unit}; {allowed}</source>
            <translation>Le miroir a besoin de {range} {unit} ; {allowed}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/shortfall.py" />
            <source>{thickest:.3g} {unit} is the automatic limit</source>
            <translation>{thickest:.3g} {unit} est la limite automatique</translation>
        </message>
        <message>
            <location filename="../../workbench/design/shortfall.py" />
            <source>the screen leaves room for {thickest:.3g} {unit}</source>
            <translation>l'écran laisse de la place pour {thickest:.3g} {unit}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/shortfall.py" />
            <source>the stock allows {thickest:.3g} {unit}</source>
            <translation>le brut permet {thickest:.3g} {unit}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/shortfall.py" />
            <source>{part:.0f} % of the control heights are at the largest thickness; {allowed}</source>
            <translation>{part:.0f} % des hauteurs de contrôle sont à la plus grande épaisseur ; {allowed}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/shortfall.py" />
            <source>The lens needs to be {needed:.3g} {unit} thick; {allowed}</source>
            <translation>La lentille devrait avoir une épaisseur de {needed:.3g} {unit} ; {allowed}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/shortfall.py" />
            <source>The mirror needs to be {needed:.3g} {unit} thick; {allowed}</source>
            <translation>Le miroir devrait avoir une épaisseur de {needed:.3g} {unit} ; {allowed}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/shortfall.py" />
            <source>{sentence}: {cure}</source>
            <translation>{sentence} : {cure}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/shortfall.py" />
            <source>{field}: {said}</source>
            <translation>{field} : {said}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/shortfall.py" />
            <source>set {field} to a larger thickness</source>
            <translation>donner à {field} une épaisseur plus grande</translation>
        </message>
        <message>
            <location filename="../../workbench/design/shortfall.py" />
            <source>set {field} to a wider range</source>
            <translation>donner à {field} une plage plus large</translation>
        </message>
        <message>
            <location filename="../../workbench/design/shortfall.py" />
            <source>±{high:.3g}</source>
            <translation>±{high:.3g}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/shortfall.py" />
            <source>{low:.3g} to {high:.3g}</source>
            <translation>{low:.3g} à {high:.3g}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/transport/first.py" />
            <source>both faces</source>
            <translation>les deux faces</translation>
        </message>
        <message>
            <location filename="../../workbench/design/transport/first.py" />
            <source>the exit face alone</source>
            <translation>la face de sortie seule</translation>
        </message>
        <message>
            <location filename="../../workbench/design/transport/first.py" />
            <source>both faces along lines through all images</source>
            <translation>les deux faces le long de lignes à travers toutes les images</translation>
        </message>
        <message>
            <location filename="../../workbench/design/transport/first.py" />
            <source>the entrance face for image {number} alone</source>
            <translation>la face d'entrée pour l'image {number} seule</translation>
        </message>
        <message>
            <location filename="../../workbench/design/transport/first.py" />
            <source>the exit face for image {number} alone</source>
            <translation>la face de sortie pour l'image {number} seule</translation>
        </message>
        <message>
            <location filename="../../workbench/design/transport/first.py" />
            <source>{error} % by {face}</source>
            <translation>{error} % pour {face}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/transport/first.py" />
            <source>first lens: {tried}; it begins with {best}</source>
            <translation>première lentille : {tried} ; retenu : {best}</translation>
        </message>
        <message>
            <location filename="../../workbench/files/atomic.py" />
            <source>cannot be written: its folder does not exist</source>
            <translation>ne peut pas être écrit : son dossier n'existe pas</translation>
        </message>
        <message>
            <location filename="../../workbench/files/atomic.py" />
            <source>cannot be written: {problem}</source>
            <translation>ne peut pas être écrit : {problem}</translation>
        </message>
        <message>
            <location filename="../../workbench/files/designs.py" />
            <source>is dark or has negative values; some light is needed</source>
            <translation>est sombre ou a des valeurs négatives ; il faut un peu de lumière</translation>
        </message>
        <message>
            <location filename="../../workbench/files/designs.py" />
            <source>{height:.5g} is no height of this lens; at most {farthest:g} {unit} from {front} are possible</source>
            <translation>{height:.5g} n'est pas une hauteur de cette lentille ; au plus {farthest:g} {unit} de distance sont possibles ({front})</translation>
        </message>
        <message>
            <location filename="../../workbench/files/designs.py" />
            <source>{height:.5g} is no height of this mirror; at most {farthest:g} {unit} from {front} are possible</source>
            <translation>{height:.5g} n'est pas une hauteur de ce miroir ; au plus {farthest:g} {unit} de distance sont possibles ({front})</translation>
        </message>
        <message>
            <location filename="../../workbench/files/designs.py" />
            <source>{value:.5g} is more than all light of the source in this pixel; {most:.5g} would be all of it</source>
            <translation>{value:.5g} dépasse toute la lumière de la source dans ce pixel ; {most:.5g} en serait la totalité</translation>
        </message>
        <message>
            <location filename="../../workbench/files/designs.py" />
            <source>has figures of {given} further images; the scene has {others}</source>
            <translation>a les chiffres de {given} autres images ; la scène en a {others}</translation>
        </message>
        <message>
            <location filename="../../workbench/files/designs.py" />
            <source>has {count} losses; stages cannot have begun after {starts}</source>
            <translation>a {count} valeurs de perte ; des étapes ne peuvent pas avoir commencé après {starts}</translation>
        </message>
        <message>
            <location filename="../../workbench/files/entries.py" />
            <source>does not belong into this session</source>
            <translation>n'a pas sa place dans cette session</translation>
        </message>
        <message>
            <location filename="../../workbench/files/entries.py" />
            <source>holds an entry twice; each must be there once</source>
            <translation>contient une entrée en double ; chacune doit y être une fois</translation>
        </message>
        <message>
            <location filename="../../workbench/files/entries.py" />
            <source>is cut off</source>
            <translation>est tronquée</translation>
        </message>
        <message>
            <location filename="../../workbench/files/entries.py" />
            <source>holds entries that overlap; each has bytes of its own</source>
            <translation>contient des entrées qui se chevauchent ; chacune a ses propres octets</translation>
        </message>
        <message>
            <location filename="../../workbench/files/entries.py" />
            <source>is missing; a session holds it</source>
            <translation>manque ; une session le contient</translation>
        </message>
        <message>
            <location filename="../../workbench/files/entries.py" />
            <source>is compressed or encrypted; sessions store entries as they are</source>
            <translation>est compressée ou chiffrée ; les sessions stockent les entrées telles quelles</translation>
        </message>
        <message>
            <location filename="../../workbench/files/entries.py" />
            <source>has {size} bytes; at most {largest} are possible</source>
            <translation>a {size} octets ; au plus {largest} sont possibles</translation>
        </message>
        <message>
            <location filename="../../workbench/files/entries.py" />
            <source>is a damaged or incomplete zip: {detail}</source>
            <translation>est un zip endommagé ou incomplet : {detail}</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/far_light.py" />
            <source>no light leaves its {body}, so that it has no intensity</source>
            <translation>aucune lumière ne quitte le {body}, il n'a donc pas d'intensité</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/formats.py" />
            <source>has no ending that tells a format; one of {endings}</source>
            <translation>n'a pas d'extension qui indique un format ; l'une de {endings}</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/gcode.py" />
            <source>a ball cutter of {radius} does not fit: it leaves {left} at x = {x}, y = {y} and cuts off {cut}; {cure}</source>
            <translation>une fraise hémisphérique de {radius} ne convient pas : elle laisse {left} en x = {x}, y = {y} et enlève {cut} de trop ; {cure}</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/gcode.py" />
            <source>one of {fitting} fits</source>
            <translation>une de {fitting} convient</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/gcode.py" />
            <source>a smaller one or higher ridges are needed</source>
            <translation>il en faut une plus petite, ou des crêtes plus hautes</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/iges.py" />
            <source>needs OpenCASCADE, which pip install 'freeform-lens-workbench[iges]' brings</source>
            <translation>demande OpenCASCADE, que pip install 'freeform-lens-workbench[iges]' apporte</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/iges.py" />
            <source>OpenCASCADE could not turn the shape into IGES</source>
            <translation>OpenCASCADE n'a pas pu convertir la forme en IGES</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/iges.py" />
            <source>OpenCASCADE could not write the IGES file</source>
            <translation>OpenCASCADE n'a pas pu écrire le fichier IGES</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/iges.py" />
            <source>OpenCASCADE could not read the {ending} file again</source>
            <translation>OpenCASCADE n'a pas pu relire le fichier {ending}</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/iges.py" />
            <source>OpenCASCADE finds no B-spline face in the IGES file that it wrote</source>
            <translation>OpenCASCADE ne trouve aucune face B-spline dans le fichier IGES qu'il a écrit</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/options.py" />
            <source>{value:g}; a length above 0</source>
            <translation>{value:g} ; une longueur supérieure à 0</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/options.py" />
            <source>{value:g}; a length of 0 or more</source>
            <translation>{value:g} ; une longueur de 0 ou plus</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/options.py" />
            <source>{value:g} {unit}; from {least:g} to {most:,} {unit}</source>
            <translation>{value:g} {unit} ; de {least:g} à {most:,} {unit}</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/options.py" />
            <source>{ridge:g}; less than the cutter's radius {radius:g} is needed</source>
            <translation>{ridge:g} ; il faut moins que le rayon de la fraise {radius:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/options.py" />
            <source>{unit}; one of {known}</source>
            <translation>{unit} ; une parmi {known}</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/tessellation.py" />
            <source>{largest:.3g} {unit} is finer than the numbers of this format; at least {least:.3g}</source>
            <translation>{largest:.3g} {unit} est plus fin que les nombres de ce format ; au moins {least:.3g}</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/tessellation.py" />
            <source>{largest:.3g} {unit} takes {triangles:.0f} triangles, more than {most}; about {possible:.2g} is possible</source>
            <translation>{largest:.3g} {unit} demande {triangles:.0f} triangles, plus de {most} ; environ {possible:.2g} est possible</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/write.py" />
            <source>the {face} face is flat, so it has no file</source>
            <translation>la face « {face} » est plane, elle n'a donc pas de fichier</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/write.py" />
            <source>{reason}; {path}: {other}</source>
            <translation>{reason} ; {path} : {other}</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/write.py" />
            <source>{path}: {reason}</source>
            <translation>{path} : {reason}</translation>
        </message>
        <message>
            <location filename="../../workbench/files/header.py" />
            <source>{version} is of a newer Freeform Lens Workbench, at most {most} can be read here; update the program</source>
            <translation>{version} vient d'un Freeform Lens Workbench plus récent, au plus {most} peut être lu ici ; mettez le programme à jour</translation>
        </message>
        <message>
            <location filename="../../workbench/files/header.py" />
            <source>{count} are given; at most {most} are kept</source>
            <translation>{count} sont donnés ; au plus {most} sont conservés</translation>
        </message>
        <message>
            <location filename="../../workbench/files/header.py" />
            <source>cannot be kept as JSON: {error}</source>
            <translation>ne peut pas être conservé en JSON : {error}</translation>
        </message>
        <message>
            <location filename="../../workbench/files/header.py" />
            <source>takes {size} bytes; at most {most} are kept</source>
            <translation>prend {size} octets ; au plus {most} sont conservés</translation>
        </message>
        <message>
            <location filename="../../workbench/files/header.py" />
            <source>is nested too deeply; at most {most} levels are kept</source>
            <translation>est trop imbriqué ; au plus {most} niveaux sont conservés</translation>
        </message>
        <message>
            <location filename="../../workbench/files/json_text.py" />
            <source>is given twice; each field can be there once</source>
            <translation>est donné deux fois ; chaque champ peut y être une fois</translation>
        </message>
        <message>
            <location filename="../../workbench/files/npy.py" />
            <source>holds a value that is NaN or infinite; finite values are needed</source>
            <translation>contient une valeur NaN ou infinie ; il faut des valeurs finies</translation>
        </message>
        <message>
            <location filename="../../workbench/files/npy.py" />
            <source>holds a value that is neither 0 nor 1; false or true is needed</source>
            <translation>contient une valeur qui n'est ni 0 ni 1 ; il faut faux ou vrai</translation>
        </message>
        <message>
            <location filename="../../workbench/files/npy.py" />
            <source>holds {dtype}; {kind} is needed</source>
            <translation>contient {dtype} ; il faut {kind}</translation>
        </message>
        <message>
            <location filename="../../workbench/files/npy.py" />
            <source>has shape {found}; the scene needs {shape}</source>
            <translation>est de forme {found} ; la scène demande {shape}</translation>
        </message>
        <message>
            <location filename="../../workbench/files/npy.py" />
            <source>is in Fortran order; C order is needed</source>
            <translation>est dans l'ordre Fortran ; il faut l'ordre C</translation>
        </message>
        <message>
            <location filename="../../workbench/files/npy.py" />
            <source>has {given} bytes of values; shape {shape} needs {size}</source>
            <translation>a {given} octets de valeurs ; la forme {shape} en demande {size}</translation>
        </message>
        <message>
            <location filename="../../workbench/files/npy.py" />
            <source>is no .npy array: its header cannot be read</source>
            <translation>n'est pas un tableau .npy : son en-tête est illisible</translation>
        </message>
        <message>
            <location filename="../../workbench/files/scene.py" />
            <source>is no scene: it has more than {most} bytes</source>
            <translation>n'est pas une scène : plus de {most} octets</translation>
        </message>
        <message>
            <location filename="../../workbench/files/scene.py" />
            <source>is neither a session nor a scene in UTF-8 text</source>
            <translation>n'est ni une session ni une scène en texte UTF-8</translation>
        </message>
        <message>
            <location filename="../../workbench/files/scene.py" />
            <source>{name!r} is no text and cannot be kept in one</source>
            <translation>{name!r} n'est pas un texte et ne peut y être conservé</translation>
        </message>
        <message>
            <location filename="../../workbench/files/session.py" />
            <source>its text would have {size} bytes; at most {most} can be read</source>
            <translation>son texte aurait {size} octets ; au plus {most} peuvent être lus</translation>
        </message>
        <message>
            <location filename="../../workbench/files/session.py" />
            <source>is no session: it does not begin like a zip</source>
            <translation>n'est pas une session : le début n'est pas celui d'un zip</translation>
        </message>
        <message>
            <location filename="../../workbench/files/session.py" />
            <source>would hold {count} kept runs; at most {most}</source>
            <translation>contiendrait {count} calculs conservés ; au plus {most}</translation>
        </message>
        <message>
            <location filename="../../workbench/geometry/ball_cutter.py" />
            <source>{scallop:.2g} takes {moves:,} moves of this cutter, more than {most:,}; a larger one</source>
            <translation>{scallop:.2g} demande {moves:,} déplacements de cette fraise, plus de {most:,} ; une plus grande</translation>
        </message>
        <message>
            <location filename="../../workbench/geometry/body.py" />
            <source>its {face} is at z = {z:.5g} {unit} at x = {x:.4g}, y = {y:.4g}, not {limit} at z = {end:g}: that is no {body}</source>
            <translation>{face} : z = {z:.5g} {unit} en x = {x:.4g}, y = {y:.4g}, non {limit} à z = {end:g} : il n'y a pas de {body}</translation>
        </message>
        <message>
            <location filename="../../workbench/geometry/body.py" />
            <source>above {front}</source>
            <translation>au-dessus de : {front}</translation>
        </message>
        <message>
            <location filename="../../workbench/geometry/body.py" />
            <source>before the screen</source>
            <translation>devant l'écran</translation>
        </message>
        <message>
            <location filename="../../workbench/geometry/body.py" />
            <source>above the screen and the source</source>
            <translation>au-dessus de l'écran et de la source</translation>
        </message>
        <message>
            <location filename="../../workbench/geometry/body.py" />
            <source>below all</source>
            <translation>sous tout le reste</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>Estimate</source>
            <translation>Estimation</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>estimating…</source>
            <translation>estimation en cours…</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>By a coarse design of this task.</source>
            <translation>D'après une conception grossière de cette tâche.</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>No light arrives in a coarse design of this task.</source>
            <translation>Dans une conception grossière de cette tâche, aucune lumière n'arrive.</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>Only designs by the automatic method are estimated.</source>
            <translation>Seules les conceptions par la méthode automatique sont estimées.</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>not known</source>
            <translation>inconnu</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>error {error}, {light:.0f} % of the light {place}</source>
            <translation>erreur {error}, {light:.0f} % de la lumière {place}</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>By a coarse design of this task, with all losses of light and the size of the source.</source>
            <translation>D'après une conception grossière de cette tâche, avec toutes les pertes de lumière et la taille de la source.</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>Blur of the light</source>
            <translation>Flou de la lumière</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>The light comes from one point or direction.</source>
            <translation>La lumière vient d'un point ou d'une direction.</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>{count:.0f} details fit side by side into the image.</source>
            <translation>{count:.0f} détails tiennent côte à côte dans l'image.</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>√(λ · distance)</source>
            <translation>√(λ · distance)</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>λ / width of the lens</source>
            <translation>λ / largeur de la lentille</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>Diffraction</source>
            <translation>Diffraction</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>{law}: finer details cannot be sharp, and no ray tracer shows that.</source>
            <translation>{law} : des détails plus fins ne peuvent être nets, et aucun tracé de rayons ne le montre.</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>Largest slope</source>
            <translation>Plus grande pente</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>{slope:.0f}°, light turns by up to {turn:.0f}°</source>
            <translation>{slope:.0f}°, déviation jusqu'à {turn:.0f}°</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>light would have to turn by {turn:.0f}°</source>
            <translation>la lumière devrait être déviée de {turn:.0f}°</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>The lens turns it by {most:.0f}° at most: a smaller image, more distance or another place of the light helps.</source>
            <translation>La lentille la dévie de {most:.0f}° au plus : une image plus petite, plus de distance ou une autre place de la lumière aide.</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>The mirror turns it by {most:.0f}° at most: a smaller image, more distance or another place of the light helps.</source>
            <translation>Le miroir la dévie de {most:.0f}° au plus : une image plus petite, plus de distance ou une autre place de la lumière aide.</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>{most:.0f}° is the most; so near to it much light is reflected.</source>
            <translation>{most:.0f}° est le maximum ; si près, beaucoup de lumière est réfléchie.</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>Up to {most:.0f}° would be possible.</source>
            <translation>Jusqu'à {most:.0f}° serait possible.</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>up to {slant:.0f}°</source>
            <translation>jusqu'à {slant:.0f}°</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>Light on the screen</source>
            <translation>Lumière sur l'écran</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>{sentence}.</source>
            <translation>{sentence}.</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>Light on the lens</source>
            <translation>Lumière sur la lentille</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>Light on the mirror</source>
            <translation>Lumière sur le miroir</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>{part:.0f} % of it</source>
            <translation>{part:.0f} % du total</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>The rest passes it by: a lamp that is nearer, or a larger lens, catches more.</source>
            <translation>Le reste passe à côté : une lampe plus proche, ou une lentille plus grande, en capte plus.</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>The rest passes it by: a lamp that is nearer, or a larger mirror, catches more.</source>
            <translation>Le reste passe à côté : une lampe plus proche, ou un miroir plus grand, en capte plus.</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>The rest misses the lens or is lost at its faces.</source>
            <translation>Le reste manque la lentille ou se perd à ses faces.</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>The rest misses the mirror or is lost at its faces.</source>
            <translation>Le reste manque le miroir ou se perd à sa face.</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>No more can land where the picture is bright: the light's own image is larger.</source>
            <translation>Pas plus ne peut aller où l'image est claire : l'image de la source elle-même est plus grande.</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>Light at best</source>
            <translation>Lumière au mieux</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>at most {part:.0f} %</source>
            <translation>au plus {part:.0f} %</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>Error at best</source>
            <translation>Erreur au mieux</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>The lens cannot turn all the light that far.</source>
            <translation>La lentille ne peut pas dévier toute la lumière aussi loin.</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>The mirror cannot turn all the light that far.</source>
            <translation>Le miroir ne peut pas dévier toute la lumière aussi loin.</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>The size of the light sets no bound.</source>
            <translation>La taille de la source ne fixe aucune borne.</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>Rays of a file need not come evenly from one place.</source>
            <translation>Les rayons d'un fichier ne viennent pas forcément uniformément d'un même endroit.</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>A lamp so near is blurred less by the rim of the lens than by its middle.</source>
            <translation>Une lampe si proche est moins floutée par le bord de la lentille que par son milieu.</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>The light is small enough for this picture.</source>
            <translation>La source est assez petite pour cette image.</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>No lens of this size can be below it; a smaller or farther lamp would help.</source>
            <translation>Aucune lentille de cette taille ne peut faire moins ; une lampe plus petite ou plus loin aiderait.</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>{n_u} × {n_v} control points, {n_x} × {n_y} pixels</source>
            <translation>{n_u} × {n_v} points de contrôle, {n_x} × {n_y} pixels</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>{height:.3g} {unit} thick, {net}</source>
            <translation>{height:.3g} {unit} d'épaisseur, {net}</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>Proposed</source>
            <translation>Proposition</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>All of it can be changed in the window.</source>
            <translation>Tout peut être changé dans la fenêtre.</translation>
        </message>
        <message>
            <location filename="../../workbench/materials.py" />
            <source>{name} is not in the catalogue; known: {known}</source>
            <translation>{name} n'est pas au catalogue ; connus : {known}</translation>
        </message>
        <message>
            <location filename="../../workbench/materials.py" />
            <source>{wavelength:g} is outside the data for {name}; {low:g} to {high:g}</source>
            <translation>{wavelength:g} est hors des données de {name} ; de {low:g} à {high:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/lamps.py" />
            <source>missing; '{file}' does not name its unit</source>
            <translation>manque ; « {file} » ne nomme pas son unité</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/lamps.py" />
            <source>'{file}' gives the lens no light: {error}</source>
            <translation>« {file} » ne donne pas de lumière à la lentille : {error}</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/lamps.py" />
            <source>'{file}' {reason}</source>
            <translation>« {file} » {reason}</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/photometry/__init__.py" />
            <source>is no photometric file; {endings} is needed</source>
            <translation>n'est pas un fichier photométrique ; il faut {endings}</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/photometry/__init__.py" />
            <source>has more than {most} MB, too many for such a file</source>
            <translation>a plus de {most} Mo, trop pour un tel fichier</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/photometry/__init__.py" />
            <source>cannot be used: {problem}</source>
            <translation>ne peut pas être utilisé : {problem}</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/photometry/ies.py" />
            <source>it has no line that begins with TILT=, as each IES file has</source>
            <translation>il n'a pas de ligne qui commence par TILT=, comme tout fichier IES</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/photometry/ies.py" />
            <source>its TILT is in another file, {file!r}; NONE or INCLUDE is needed</source>
            <translation>son TILT est dans un autre fichier, {file!r} ; il faut NONE ou INCLUDE</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/photometry/ies.py" />
            <source>it ends behind its TILT</source>
            <translation>il se termine après son TILT</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/photometry/ies.py" />
            <source>it says to be of version {found!r}; known are {known}</source>
            <translation>il indique la version {found!r} ; sont connues : {known}</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/photometry/ies.py" />
            <source>it is cut off: {n} of 13 numbers stand before its angles</source>
            <translation>il est tronqué : {n} nombres sur 13 précèdent ses angles</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/photometry/ies.py" />
            <source>{problem}: its header makes {needed} numbers, and there are {found}</source>
            <translation>{problem} : son en-tête demande {needed} nombres, et il y en a {found}</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/photometry/ies.py" />
            <source>it is cut off within {part}</source>
            <translation>il est tronqué dans cette partie : {part}</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/photometry/ies.py" />
            <source>its TILT</source>
            <translation>TILT</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/photometry/ldt.py" />
            <source>it is cut off: {found} of at least {least} lines are there</source>
            <translation>il est tronqué : il a {found} lignes sur au moins {least}</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/photometry/ldt.py" />
            <source>its lamps</source>
            <translation>ses lampes</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/photometry/ldt.py" />
            <source>{problem}: its header makes {needed} numbers behind the lamps, and there are {found}</source>
            <translation>{problem} : son en-tête demande {needed} nombres après les lampes, et il y en a {found}</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/photometry/ldt.py" />
            <source>its symmetry is {symmetry} and it has {n} planes of C; a multiple of {parts} is needed</source>
            <translation>sa symétrie est {symmetry} et il a {n} plans C ; il faut un multiple de {parts}</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/photometry/table.py" />
            <source>it has a single angle γ; at least two are needed</source>
            <translation>il a un seul angle γ ; il en faut au moins deux</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/photometry/table.py" />
            <source>its angles {name} do not ascend</source>
            <translation>ses angles {name} ne sont pas croissants</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/photometry/table.py" />
            <source>its angles γ go from {first:g}° to {last:g}°; within 0° to 180°</source>
            <translation>ses angles γ vont de {first:g}° à {last:g}° ; 0° à 180° sont permis</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/photometry/table.py" />
            <source>it has an intensity of {least:g} cd; none can be negative</source>
            <translation>il a une intensité de {least:g} cd ; aucune ne peut être négative</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/photometry/table.py" />
            <source>it gives no light: all its intensities are 0</source>
            <translation>il ne donne pas de lumière : toutes ses intensités sont 0</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/photometry/table.py" />
            <source>its largest intensity is {largest:.3g} cd; from {least:g} to {most:g} cd can be used</source>
            <translation>sa plus grande intensité est de {largest:.3g} cd ; de {least:g} à {most:g} cd sont utilisables</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/photometry/table.py" />
            <source>intensities below 0 count as 0: {count}, the least is {least:g} cd</source>
            <translation>les intensités inférieures à 0 comptent pour 0 : {count}, la plus petite est {least:g} cd</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/photometry/table.py" />
            <source>its planes of C go from {first:g}° to {last:g}°, which is no known symmetry</source>
            <translation>ses plans C vont de {first:g}° à {last:g}° ; ce n'est aucune symétrie connue</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/photometry/table.py" />
            <source>it has a single angle {name}; two are needed</source>
            <translation>il n'a qu'un angle {name} ; il en faut deux</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/photometry/table.py" />
            <source>its angles {name} go from {first:g}° to {last:g}°; they have to ascend within −{most}° to {most}°</source>
            <translation>ses angles {name} vont de {first:g}° à {last:g}° ; ils doivent croître entre −{most}° et {most}°</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/rays/__init__.py" />
            <source>is no ray file; {endings} are known</source>
            <translation>n'est pas un fichier de rayons ; sont connus {endings}</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/rays/model.py" />
            <source>{points} points stand for the rays of the file: {off:.1f} % of their light on the lens is elsewhere, and rays start {spread:.0f} % as far from their point as from the middle of all</source>
            <translation>{points} points remplacent les rayons du fichier : {off:.1f} % de leur lumière sur la lentille est ailleurs, et les rayons partent à {spread:.0f} % de leur distance au milieu de tous</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/rays/model.py" />
            <source>no ray of it comes to the lens</source>
            <translation>aucun de ses rayons n'arrive à la lentille</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/rays/opticstudio.py" />
            <source>it begins neither like a binary source file nor like one of text</source>
            <translation>il ne commence ni comme un fichier source binaire ni comme un fichier texte</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/rays/opticstudio.py" />
            <source>its first line says {rays} rays, and there are {found}</source>
            <translation>sa première ligne indique {rays} rayons, et il y en a {found}</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/rays/opticstudio.py" />
            <source>its header</source>
            <translation>en-tête</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/rays/opticstudio.py" />
            <source>its rays are of format {found}; 0 or 2 is known</source>
            <translation>ses rayons sont au format {found} ; 0 et 2 sont connus</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/rays/opticstudio.py" />
            <source>its unit is {found}; 0 to {most} are known</source>
            <translation>son unité est {found} ; 0 à {most} sont connues</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/rays/opticstudio.py" />
            <source>its header says {rays} rays, and the {left} bytes behind it are {found:.10g} of them</source>
            <translation>son en-tête indique {rays} rayons, et les {left} octets qui suivent en font {found:.10g}</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/rays/rayset.py" />
            <source>it has no rays</source>
            <translation>il n'a pas de rayons</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/rays/rayset.py" />
            <source>none of its rays has any flux</source>
            <translation>aucun de ses rayons n'a de flux</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/rays/rayset.py" />
            <source>a ray has a spectrum that is none of the {n} there are</source>
            <translation>un rayon a un spectre qui n'est aucun des {n} présents</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/rays/rayset.py" />
            <source>its ray {ray} has a value that is no finite number</source>
            <translation>son rayon {ray} a une valeur qui n'est pas un nombre fini</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/rays/rayset.py" />
            <source>its ray {ray} has a direction that is no unit vector</source>
            <translation>son rayon {ray} a une direction qui n'est pas un vecteur unitaire</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/rays/rayset.py" />
            <source>its ray {ray} has a negative flux</source>
            <translation>son rayon {ray} a un flux négatif</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/rays/rayset.py" />
            <source>it is cut off behind ray {ray}</source>
            <translation>il est tronqué après le rayon {ray}</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/rays/table.py" />
            <source>its first ray has {n} numbers; 7, or 8 with a wavelength</source>
            <translation>son premier rayon a {n} nombres ; il en faut 7, ou 8 avec une longueur d'onde</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/rays/table.py" />
            <source>it has a line without an end</source>
            <translation>il a une ligne sans fin</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/rays/table.py" />
            <source>it is no text</source>
            <translation>ce n'est pas du texte</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/rays/table.py" />
            <source>behind ray {ray} it has no rays: {reason}</source>
            <translation>après le rayon {ray} il n'y a plus de rayons : {reason}</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/rays/table.py" />
            <source>behind ray {ray} it has {found} columns; {width} as above</source>
            <translation>après le rayon {ray} il a {found} colonnes ; il en faut {width} comme plus haut</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/rays/tm25.py" />
            <source>it does not begin with TM25</source>
            <translation>il ne commence pas par TM25</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/rays/tm25.py" />
            <source>it is of version {found}; {known} is known</source>
            <translation>il est de version {found} ; {known} est connue</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/rays/tm25.py" />
            <source>its header says {rays} rays of {width} numbers, and the {left} bytes behind it are {found:.10g} of them</source>
            <translation>son en-tête indique {rays} rayons de {width} nombres, et les {left} octets qui suivent en font {found:.10g}</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/rays/tm25.py" />
            <source>the flags of its columns are {found}; 1, 1 and then 0 or 1</source>
            <translation>les indicateurs de ses colonnes sont {found} ; il faut 1, 1 puis 0 ou 1</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/rays/tm25.py" />
            <source>its header says {n} spectra; from 0 to {most}</source>
            <translation>son en-tête indique {n} spectres ; de 0 à {most}</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/rays/tm25.py" />
            <source>its spectra</source>
            <translation>spectres</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/rays/tm25.py" />
            <source>one of its spectra has {n} points; from 1 to {most}</source>
            <translation>un de ses spectres a {n} points ; de 1 à {most}</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/rays/tm25.py" />
            <source>its header says {value} for "{name}"; from 0 to {most}</source>
            <translation>son en-tête indique {value} pour "{name}" ; de 0 à {most}</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/text.py" />
            <source>{word!r} stands where a number is needed</source>
            <translation>{word!r} se trouve là où il faut un nombre</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/text.py" />
            <source>{word!r} stands where a finite number is needed</source>
            <translation>{word!r} se trouve là où il faut un nombre fini</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/text.py" />
            <source>{word!r} stands where a whole number from {least} to {most} has to</source>
            <translation>{word!r} se trouve là où il faut un nombre entier de {least} à {most}</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/text.py" />
            <source>text behind the last number is ignored: {text!r}</source>
            <translation>le texte après le dernier nombre est ignoré : {text!r}</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/text.py" />
            <source>it is cut off</source>
            <translation>il est tronqué</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/text.py" />
            <source>it goes on behind its end</source>
            <translation>il continue après sa fin</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/account.py" />
            <source>Only {part:.1f} % of the light lands {place}; {lost:.0f} % {where}: {cure}.</source>
            <translation>Seulement {part:.1f} % de la lumière arrive {place} ; {lost:.0f} % {where} : {cure}.</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/beam_plan.py" />
            <source>beams of light between {rays} rays: no noise, and no filter</source>
            <translation>faisceaux de lumière entre {rays} rayons : ni bruit, ni filtre</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/beam_plan.py" />
            <source>beams run between points of the source, through each sample of the lens</source>
            <translation>les faisceaux passent entre les points de la source, par chaque échantillon de la lentille</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/beam_plan.py" />
            <source>shading by the screen and by the mirror itself is ignored</source>
            <translation>l'ombre de l'écran et du miroir lui-même est ignorée</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/beam_plan.py" />
            <source>shading by the far field and by the mirror itself is ignored</source>
            <translation>l'ombre du champ lointain et du miroir lui-même est ignorée</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/choice.py" />
            <source>fused kernels, {threads} threads, {precision}</source>
            <translation>noyaux compilés, {threads} fils d'exécution, {precision}</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/choice.py" />
            <source>fused kernels, 1 thread, {precision}</source>
            <translation>noyaux compilés, 1 fil d'exécution, {precision}</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/choice.py" />
            <source>reference in torch on {device}, {precision}</source>
            <translation>référence en torch sur {device}, {precision}</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/choice.py" />
            <source>no kernel for this path ({faces}): by the reference alone</source>
            <translation>aucun noyau pour ce chemin ({faces}) : par la référence seule</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/choice.py" />
            <source>float64: float32 has too few digits for this scene</source>
            <translation>float64 : float32 a trop peu de chiffres pour cette scène</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/choice.py" />
            <source>the kernel could not be compiled ({error}), so this run is many times slower</source>
            <translation>le noyau n'a pas pu être compilé ({error}), cette exécution est donc bien plus lente</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/choice.py" />
            <source>compiled kernels could not be kept ({reason}), so each start compiles them again</source>
            <translation>les noyaux compilés n'ont pas pu être conservés ({reason}), chaque démarrage les compile donc à nouveau</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/halves.py" />
            <source>mirror symmetry: a quarter of the rays</source>
            <translation>symétrie miroir : un quart des rayons</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/halves.py" />
            <source>mirror symmetry: half of the rays</source>
            <translation>symétrie miroir : la moitié des rayons</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/plan.py" />
            <source>box filter: one pixel a ray, no ghost pixels</source>
            <translation>filtre boîte : un pixel par rayon, pas de pixels fantômes</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/plan.py" />
            <source>'cuda' needs an NVIDIA GPU that torch can use, and there is none; 'cpu'</source>
            <translation>'cuda' demande une carte NVIDIA que torch puisse utiliser, et il n'y en a pas ; 'cpu'</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/sampled.py" />
            <source>samples of the aperture, followed through fixed faces once</source>
            <translation>échantillons de l'ouverture, suivis une seule fois à travers les faces fixes</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/sampled.py" />
            <source>samples on the exit face, shared by all origins of the light</source>
            <translation>échantillons sur la face de sortie, communs à toutes les origines de la lumière</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/sampled.py" />
            <source>samples on the entrance face, shared by all origins of the light</source>
            <translation>échantillons sur la face d'entrée, communs à toutes les origines de la lumière</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/sampled.py" />
            <source>samples on the mirror, shared by all origins of the light</source>
            <translation>échantillons sur le miroir, communs à toutes les origines de la lumière</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/total_reflection.py" />
            <source>{part} % of the light is totally reflected at the {face}, most of it around x = {x}, y = {y}</source>
            <translation>{part} % de la lumière est totalement réfléchie sur la {face}, surtout autour de x = {x}, y = {y}</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/train/entries.py" />
            <source>1 direction of light</source>
            <translation>1 direction de lumière</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/train/entries.py" />
            <source>{count} directions of light</source>
            <translation>{count} directions de lumière</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/train/entries.py" />
            <source>1 point of light</source>
            <translation>1 point de lumière</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/train/entries.py" />
            <source>{count} points of light</source>
            <translation>{count} points de lumière</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/train/entries.py" />
            <source>mirror symmetry: {some} of them are traced</source>
            <translation>symétrie miroir : {some} d'entre eux sont tracés</translation>
        </message>
        <message>
            <location filename="../../workbench/reading.py" />
            <source>does not exist; no file can have such a name</source>
            <translation>n'existe pas ; aucun fichier ne peut avoir un tel nom</translation>
        </message>
        <message>
            <location filename="../../workbench/reading.py" />
            <source>is a folder; a file is needed</source>
            <translation>est un dossier ; il faut un fichier</translation>
        </message>
        <message>
            <location filename="../../workbench/reading.py" />
            <source>is a device or pipe; an ordinary file is needed</source>
            <translation>est un périphérique ou un tube ; il faut un fichier ordinaire</translation>
        </message>
        <message>
            <location filename="../../workbench/reading.py" />
            <source>does not exist; the name of a file is needed</source>
            <translation>n'existe pas ; il faut le nom d'un fichier</translation>
        </message>
        <message>
            <location filename="../../workbench/reading.py" />
            <source>cannot be read: {problem}</source>
            <translation>ne peut pas être lu : {problem}</translation>
        </message>
        <message>
            <location filename="../../workbench/report/figures.py" />
            <source>{off}, {times:.2f} times their noise</source>
            <translation>{off}, {times:.2f} fois leur bruit</translation>
        </message>
        <message>
            <location filename="../../workbench/report/figures.py" />
            <source>{rays:,} rays, 95 % confidence</source>
            <translation>{rays:,} rayons, confiance de 95 %</translation>
        </message>
        <message>
            <location filename="../../workbench/report/figures.py" />
            <source>{low} to {high}</source>
            <translation>{low} à {high}</translation>
        </message>
        <message>
            <location filename="../../workbench/report/figures.py" />
            <source>{figure}; {remark}</source>
            <translation>{figure} ; {remark}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/collimated_source.py" />
            <source>{angle:g} brings light {steepest:g} degrees from the axis, which does not come to {front}; less than 90 in all</source>
            <translation>{angle:g} amène de la lumière à {steepest:g} degrés de l'axe, qui n'arrive pas là ({front}) ; moins de 90 en tout</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/collimated_source.py" />
            <source>{radius:g} is too narrow for a lens with a half-width of {half:g}; at least {least:g}</source>
            <translation>{radius:g} est trop étroit pour une lentille de demi-largeur {half:g} ; au moins {least:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/collimated_source.py" />
            <source>{radius:g} is too narrow for a mirror with a half-width of {half:g}; at least {least:g}</source>
            <translation>{radius:g} est trop étroit pour un miroir de demi-largeur {half:g} ; au moins {least:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/element.py" />
            <source>'auto' needs a target to choose for; numbers</source>
            <translation>'auto' demande une cible pour choisir ; des nombres</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/emission.py" />
            <source>{parts} make {across} × {up} rectangles; at most {most} in all</source>
            <translation>{parts} font {across} × {up} rectangles ; au plus {most} en tout</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/faces.py" />
            <source>{count} is too few for degree {degree}; at least {least}</source>
            <translation>{count} est trop peu pour le degré {degree} ; au moins {least}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/faces.py" />
            <source>{radius:g} does not span the lens; more than its half-diagonal {least:g}</source>
            <translation>{radius:g} ne couvre pas la lentille ; plus que sa demi-diagonale {least:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/faces.py" />
            <source>{radius:g} does not span the mirror; more than its half-diagonal {least:g}</source>
            <translation>{radius:g} ne couvre pas le miroir ; plus que sa demi-diagonale {least:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/faces.py" />
            <source>0 is no curvature; a radius, or a plane face</source>
            <translation>0 n'est pas une courbure ; un rayon, ou une face plane</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/faces.py" />
            <source>{radius:g} ends within the lens; more than {least:g} in size</source>
            <translation>{radius:g} s'arrête à l'intérieur de la lentille ; plus de {least:g} en valeur absolue</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/faces.py" />
            <source>{radius:g} ends within the mirror; more than {least:g} in size</source>
            <translation>{radius:g} s'arrête à l'intérieur du miroir ; plus de {least:g} en valeur absolue</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/faces.py" />
            <source>[{low:g}, {high:g}] is empty; low before high</source>
            <translation>[{low:g}, {high:g}] est vide ; la plus petite valeur d'abord</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/far_field.py" />
            <source>{half:g} about {middle:g} goes beyond {most:g} degrees; at most {left:g}</source>
            <translation>{half:g} autour de {middle:g} dépasse {most:g} degrés ; au plus {left:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/far_field.py" />
            <source>is at no distance; a screen is needed</source>
            <translation>n'a pas de distance ; il faut un écran</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/grid_source.py" />
            <source>{rays} from each of {points} points are too many; at most {most} rays in all</source>
            <translation>{rays} de chacun des {points} points sont trop ; au plus {most} rayons en tout</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/lens.py" />
            <source>a front face is designed together with the back face; 'bspline', not fixed</source>
            <translation>une face avant se conçoit avec la face arrière ; 'bspline', non fixe</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/lens.py" />
            <source>{index:g}; greater than 1 is needed</source>
            <translation>{index:g} ; il faut plus de 1</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/lens.py" />
            <source>{height:g} leaves no room above the minimal thickness; more than {least:g}</source>
            <translation>{height:g} ne laisse pas de place au-dessus de l'épaisseur minimale ; plus de {least:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/lens.py" />
            <source>{height:g} leaves no room below the maximal thickness; less than {most:g}</source>
            <translation>{height:g} ne laisse pas de place au-dessous de l'épaisseur maximale ; moins de {most:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/limits.py" />
            <source>{large:g} cannot be computed with; from {least:g} to {most:g}, in another unit if need be</source>
            <translation>{large:g} ne permet pas de calculer ; de {least:g} à {most:g}, au besoin dans une autre unité</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/limits.py" />
            <source>{half:g} makes the element slimmer than {most:g} to 1; at least {least:g}</source>
            <translation>{half:g} rend l'élément plus étroit que {most:g} pour 1 ; au moins {least:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/limits.py" />
            <source>{index:g} is more than any material has; at most {most:g}</source>
            <translation>{index:g} est plus que n'a aucun matériau ; au plus {most:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/limits.py" />
            <source>{absorption:g} leaves less than {least:g} of the light behind {thickness:g} of glass; at most {most:g}</source>
            <translation>{absorption:g} laisse moins de {least:g} de la lumière derrière {thickness:g} de verre ; au plus {most:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/limits.py" />
            <source>{length:g} is too long beside a half-width of {half:g}; at most {most:g}</source>
            <translation>{length:g} est trop long pour une demi-largeur de {half:g} ; au plus {most:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/losses.py" />
            <source>a flatter base, </source>
            <translation>une base plus plate, </translation>
        </message>
        <message>
            <location filename="../../workbench/scene/measured_source.py" />
            <source>'{file}' is none of these: {endings}</source>
            <translation>'{file}' n'est aucun de ceux-ci : {endings}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/part.py" />
            <source>{value:g} is too small for this one; a number that it can hold</source>
            <translation>{value:g} est trop petit pour celle-ci ; un nombre qu'elle peut tenir</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/paths.py" />
            <source>no path of a field; a path as in lens.thickness is needed</source>
            <translation>n'est pas un chemin de champ ; il faut un chemin comme lens.thickness</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/paths.py" />
            <source>given twice; one value for each field</source>
            <translation>donné deux fois ; une valeur pour chaque champ</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/paths.py" />
            <source>no field and no element of this scene; fields: {fields}; elements: {names}</source>
            <translation>ni champ ni élément de cette scène ; champs : {fields} ; éléments : {names}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/paths.py" />
            <source>unknown field; there is no such part of the scene</source>
            <translation>champ inconnu ; la scène n'a pas une telle partie</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/paths.py" />
            <source>there are only {count} of them; 0 to {last}</source>
            <translation>il n'y en a que {count} ; 0 à {last}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/paths.py" />
            <source>there is none of them</source>
            <translation>il n'y en a aucun</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/points.py" />
            <source>{z:g} is not before {front}; less than {most:g}</source>
            <translation>{z:g} n'est pas devant ({front}) ; moins de {most:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/points.py" />
            <source>{way:g} before {front} is too near for a lens with a half-width of {size:g}; at least {least:g}</source>
            <translation>{way:g} devant ({front}) est trop près pour une lentille de demi-largeur {size:g} ; au moins {least:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/points.py" />
            <source>{way:g} before {front} is too near for a mirror with a half-width of {size:g}; at least {least:g}</source>
            <translation>{way:g} devant ({front}) est trop près pour un miroir de demi-largeur {size:g} ; au moins {least:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/points.py" />
            <source>{way:g} before {front} is too far for a lens with a half-width of {size:g}; at most {most:g}, or collimated light</source>
            <translation>{way:g} devant ({front}) est trop loin pour une lentille de demi-largeur {size:g} ; au plus {most:g}, ou une lumière collimatée</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/points.py" />
            <source>{way:g} before {front} is too far for a mirror with a half-width of {size:g}; at most {most:g}, or collimated light</source>
            <translation>{way:g} devant ({front}) est trop loin pour un miroir de demi-largeur {size:g} ; au plus {most:g}, ou une lumière collimatée</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/region.py" />
            <source>{size:g} about {middle:g} ends beyond the receiver; at most {most:g} there</source>
            <translation>{size:g} autour de {middle:g} dépasse le récepteur ; au plus {most:g} à cet endroit</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/region.py" />
            <source>have no area between them; a polygon with some</source>
            <translation>n'entourent aucune surface ; un polygone qui en a une</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/region.py" />
            <source>make sides that cross; in their order around the polygon</source>
            <translation>font des côtés qui se croisent ; dans leur ordre autour du polygone</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/region.py" />
            <source>{count} are given; at most {most}</source>
            <translation>{count} sont donnés ; au plus {most}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/screen.py" />
            <source>{tilt} turns the back of the screen to light of the lens; its front has to face all of the lens</source>
            <translation>{tilt} tourne le dos de l'écran vers la lumière de la lentille ; son avant doit faire face à toute la lentille</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/screen.py" />
            <source>{tilt} turns the back of the screen to light of the mirror; its front has to face all of the mirror</source>
            <translation>{tilt} tourne le dos de l'écran vers la lumière du miroir ; son avant doit faire face à tout le miroir</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/screen.py" />
            <source>{z:g} may touch the lens; more than {least:g}, the highest that the exit face can become</source>
            <translation>{z:g} peut toucher la lentille ; plus de {least:g}, le plus haut que la face de sortie puisse atteindre</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/screen.py" />
            <source>{z:g} puts its lowest edge at z = {nearest:g}, which may touch the lens; more than {least:g}, the highest that the exit face can become and the tilt adds</source>
            <translation>{z:g} met son bord le plus bas à z = {nearest:g}, qui peut toucher la lentille ; plus de {least:g}, le plus haut que la face de sortie puisse atteindre, et ce qu'ajoute l'inclinaison</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/screen.py" />
            <source>{z:g} may touch the lens, or be behind it; less than {most:g}, the lowest that it can become</source>
            <translation>{z:g} peut toucher la lentille ou être derrière elle ; moins de {most:g}, le plus bas qu'elle puisse atteindre</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/screen.py" />
            <source>{z:g} may touch the mirror, or be behind it; less than {most:g}, the lowest that it can become</source>
            <translation>{z:g} peut toucher le miroir ou être derrière lui ; moins de {most:g}, le plus bas qu'il puisse atteindre</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/stages.py" />
            <source>they leave none of the {count} iterations for the scene itself; more than {least} in all are needed</source>
            <translation>elles ne laissent aucune des {count} itérations à la scène elle-même ; il en faut plus de {least} en tout</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/stages.py" />
            <source>unknown field; the automatic method has none</source>
            <translation>champ inconnu ; la méthode automatique n'en a pas</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/target.py" />
            <source>takes {across:g} of the width away; at most {most:g}</source>
            <translation>enlève {across:g} de la largeur ; au plus {most:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/target.py" />
            <source>takes {up:g} of the height away; at most {most:g}</source>
            <translation>enlève {up:g} de la hauteur ; au plus {most:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/task.py" />
            <source>{value:g} is about curvature, and faces of degree 1 are flat between edges; {field} of at least 2</source>
            <translation>{value:g} concerne la courbure, et les faces de degré 1 sont planes entre les arêtes ; {field} d'au moins 2</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/task.py" />
            <source>'{name}' is the name of another element; another name</source>
            <translation>'{name}' est le nom d'un autre élément ; un autre nom</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/task.py" />
            <source>no face is designed; one face of shape 'bspline'</source>
            <translation>aucune face n'est à concevoir ; une face de forme 'bspline'</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/task.py" />
            <source>a second designed element; one element is designed</source>
            <translation>un second élément à concevoir ; un seul élément est conçu</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/task.py" />
            <source>fixed B-spline faces are not traced yet; a conic face</source>
            <translation>les faces B-spline fixes ne sont pas encore tracées ; une face conique</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/task.py" />
            <source>a mirror that is not designed is not traced yet</source>
            <translation>un miroir qui n'est pas à concevoir n'est pas encore tracé</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/task.py" />
            <source>elements behind a mirror are not traced yet; none</source>
            <translation>les éléments derrière un miroir ne sont pas encore tracés ; aucun</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/task.py" />
            <source>the first and the designed element stand upright on the axis; 0</source>
            <translation>le premier élément et celui à concevoir sont droits sur l'axe ; 0</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/task.py" />
            <source>{z:g} reaches into {name}; at least {least:g}</source>
            <translation>{z:g} empiète sur {name} ; au moins {least:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/task.py" />
            <source>{count} given, which {who} cannot take into account; one</source>
            <translation>il y en a {count}, ce dont {who} ne peut tenir compte ; il en faut 1</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/versions.py" />
            <source>missing; it goes with {material}</source>
            <translation>manque ; elle va avec {material}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/versions.py" />
            <source>{value} is neither a number nor a name; a number above 1 or a material name</source>
            <translation>{value} n'est ni un nombre ni un nom ; un nombre supérieur à 1 ou le nom d'un matériau</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/versions.py" />
            <source>{value}; a number greater than 1 is needed</source>
            <translation>{value} ; il faut un nombre supérieur à 1</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/versions.py" />
            <source>missing; it or {other} is required</source>
            <translation>manque ; lui ou {other} est nécessaire</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/versions.py" />
            <source>is given together with a {one}; one of them is needed</source>
            <translation>est donné avec {one} ; il faut l'un des deux</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/viewing.py" />
            <source>viewed from the side of the light</source>
            <translation>vu du côté de la lumière</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/viewing.py" />
            <source>viewed from behind the screen</source>
            <translation>vu de derrière l'écran</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/viewing.py" />
            <source>viewed from behind the far field</source>
            <translation>vu de derrière le champ lointain</translation>
        </message>
        <message>
            <location filename="../../workbench/sweep/points.py" />
            <source>is varied twice; all its values belong together</source>
            <translation>est varié deux fois ; toutes ses valeurs vont ensemble</translation>
        </message>
        <message>
            <location filename="../../workbench/sweep/points.py" />
            <source>{count} points; at most {most} are possible</source>
            <translation>{count} points ; {most} au plus sont possibles</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/colour.py" />
            <source>has a colour profile that cannot be used ({why}); “Brightness” (target.tone) counts</source>
            <translation>a un profil de couleur inutilisable ({why}) ; « Luminosité » (target.tone) compte</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/colour.py" />
            <source>has {statement}, which counts in place of “Brightness” (target.tone)</source>
            <translation>a {statement}, qui compte à la place de « Luminosité » (target.tone)</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/colour.py" />
            <source>a chunk sRGB</source>
            <translation>un bloc sRGB</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/colour.py" />
            <source>a chunk gAMA of {gamma:.4g}</source>
            <translation>un bloc gAMA de {gamma:.4g}</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/colour.py" />
            <source>the colour profile “{name}”</source>
            <translation>le profil de couleur « {name} »</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/exr_image.py" />
            <source>has pixels {aspect:.3g} times as wide as high; they count as squares</source>
            <translation>a des pixels {aspect:.3g} fois plus larges que hauts ; ils comptent comme carrés</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/exr_image.py" />
            <source>is damaged or incomplete</source>
            <translation>est endommagé ou incomplet</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/exr_image.py" />
            <source>is a deep EXR; a flat one is needed</source>
            <translation>est un EXR profond ; il en faut un plat</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/exr_image.py" />
            <source>has the channels {names}; R, G and B, or Y, are needed</source>
            <translation>a les canaux {names} ; il faut R, G et B, ou Y</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/exr_image.py" />
            <source>has chromaticities that are no colours</source>
            <translation>a des chromaticités qui ne sont pas des couleurs</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/image.py" />
            <source>is a folder; an image file is needed</source>
            <translation>est un dossier ; il faut un fichier d'image</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/image.py" />
            <source>is not an existing file; an image file is needed</source>
            <translation>n'existe pas ; il faut un fichier d'image</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/image.py" />
            <source>cannot be read: {why}</source>
            <translation>ne peut être lu : {why}</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/image.py" />
            <source>'{tone}' is for shades, and '{path}' holds numbers; 'linear'</source>
            <translation>'{tone}' est pour des tons, et '{path}' contient des nombres ; 'linear'</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/image.py" />
            <source>'{path}' {remark}</source>
            <translation>'{path}' {remark}</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/image.py" />
            <source>is an SVG of more than {most} MB</source>
            <translation>est un SVG de plus de {most} Mo</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/image.py" />
            <source>holds light itself; “Brightness” (target.tone) does not count</source>
            <translation>contient la lumière elle-même ; « Luminosité » (target.tone) ne compte pas</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/image.py" />
            <source>is damaged or incomplete: {why}</source>
            <translation>est endommagé ou incomplet : {why}</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/image.py" />
            <source>'{path}' {reason}</source>
            <translation>'{path}' {reason}</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/image.py" />
            <source>is not a whole .npy array of numbers: {why}</source>
            <translation>n'est pas un tableau .npy complet de nombres : {why}</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/image.py" />
            <source>has {count} dimensions; 2 (rows, columns) are needed</source>
            <translation>a {count} dimensions ; il en faut 2 (lignes, colonnes)</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/image.py" />
            <source>holds values of type {kind}; real numbers are needed</source>
            <translation>contient des valeurs de type {kind} ; il faut des nombres réels</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/image.py" />
            <source>is not a whole .npy array of numbers: it lacks some of {size} bytes</source>
            <translation>n'est pas un tableau .npy complet de nombres : il manque une partie des {size} octets</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/picture.py" />
            <source>has {columns} × {rows} pixels; at least one is needed</source>
            <translation>a {columns} × {rows} pixels ; il en faut au moins un</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/picture.py" />
            <source>has {columns} × {rows} pixels; at most {most} million are allowed</source>
            <translation>a {columns} × {rows} pixels ; au plus {most} millions sont permis</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/picture.py" />
            <source>has {columns} × {rows} pixels and is reduced to {less_columns} × {less_rows}</source>
            <translation>a {columns} × {rows} pixels et est réduit à {less_columns} × {less_rows}</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/picture.py" />
            <source>holds {least:g}; values of at least 0 are needed</source>
            <translation>contient {least:g} ; il faut des valeurs d'au moins 0</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/prepare.py" />
            <source>is too small to light any pixel of the screen; enlarge the shape</source>
            <translation>est trop petit pour éclairer un pixel de l'écran ; agrandissez la forme</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/prepare.py" />
            <source>'{path}' is black all over; some light is needed</source>
            <translation>'{path}' est tout noir ; il faut un peu de lumière</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/prepare.py" />
            <source>true leaves '{path}', which is uniform, black all over</source>
            <translation>true rend '{path}', qui est uniforme, tout noir</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/radiance_image.py" />
            <source>is damaged: it has no line with its resolution</source>
            <translation>est endommagé : il n'a pas de ligne de résolution</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/radiance_image.py" />
            <source>has primaries that are no colours of light</source>
            <translation>a des primaires qui ne sont pas des couleurs de lumière</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/radiance_image.py" />
            <source>is damaged: a line has another length than the picture</source>
            <translation>est endommagé : une ligne n'a pas la longueur de l'image</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/radiance_image.py" />
            <source>is damaged: a line is longer than the picture</source>
            <translation>est endommagé : une ligne est plus longue que l'image</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/radiance_image.py" />
            <source>is incomplete: lines are missing at its end</source>
            <translation>est incomplet : des lignes manquent à la fin</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/raster_image.py" />
            <source>is not an image that can be read; known: {known}</source>
            <translation>n'est pas une image lisible ; connus : {known}</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/raster_image.py" />
            <source>has too many pixels; at most {most} million</source>
            <translation>a trop de pixels ; au plus {most} millions</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/raster_image.py" />
            <source>has {frames} frames or pages; the first one counts</source>
            <translation>a {frames} images ou pages ; la première compte</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/raster_image.py" />
            <source>has 32 bits a pixel with zero as white; save it with zero as black</source>
            <translation>a 32 bits par pixel avec zéro pour blanc ; l'enregistrer avec zéro pour noir</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/raster_image.py" />
            <source>has zero as white; save it with zero as black</source>
            <translation>a zéro pour blanc ; l'enregistrer avec zéro pour noir</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/svg.py" />
            <source>it cannot be drawn within {most:g} s</source>
            <translation>il ne peut être dessiné en {most:g} s</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/svg.py" />
            <source>links to the picture '{link}'; embed that picture in the SVG</source>
            <translation>renvoie à l'image '{link}' ; intégrer cette image au SVG</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/svg.py" />
            <source>it is nested too deeply to be drawn</source>
            <translation>il est imbriqué trop profondément pour être dessiné</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/svg.py" />
            <source>has the letter {letter} (U+{number:04X}), which no font here has; install one</source>
            <translation>a la lettre {letter} (U+{number:04X}), qu'aucune police d'ici ne possède ; en installer une</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/svg.py" />
            <source>is an SVG that cannot be drawn: {why}</source>
            <translation>est un SVG qui ne peut être dessiné : {why}</translation>
        </message>
        <message>
            <location filename="../../workbench/targets/text.py" />
            <source>{text!r} draws nothing; letters, digits or signs are needed</source>
            <translation>{text!r} ne dessine rien ; il faut des lettres, des chiffres ou des signes</translation>
        </message>
    </context>
</TS>
