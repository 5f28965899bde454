<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
    <context>
        <name>workbench</name>
        <message>
            <location filename="../../ui/commands/actions.py" />
            <source>&amp;File</source>
            <translation>&amp;Fichier</translation>
        </message>
        <message>
            <location filename="../../ui/commands/actions.py" />
            <source>Open &amp;recent</source>
            <translation>Fichiers &amp;récents</translation>
        </message>
        <message>
            <location filename="../../ui/commands/actions.py" />
            <source>&amp;Edit</source>
            <translation>É&amp;dition</translation>
        </message>
        <message>
            <location filename="../../ui/commands/actions.py" />
            <source>&amp;Design</source>
            <translation>&amp;Conception</translation>
        </message>
        <message>
            <location filename="../../ui/commands/actions.py" />
            <source>&amp;Run</source>
            <translation>&amp;Exécution</translation>
        </message>
        <message>
            <location filename="../../ui/commands/actions.py" />
            <source>&amp;View</source>
            <translation>&amp;Affichage</translation>
        </message>
        <message>
            <location filename="../../ui/commands/actions.py" />
            <source>&amp;Rays</source>
            <translation>Ra&amp;yons</translation>
        </message>
        <message>
            <location filename="../../ui/commands/actions.py" />
            <source>F&amp;aces</source>
            <translation>F&amp;aces</translation>
        </message>
        <message>
            <location filename="../../ui/commands/actions.py" />
            <source>&amp;Colours of light</source>
            <translation>Couleurs de la l&amp;umière</translation>
        </message>
        <message>
            <location filename="../../ui/commands/actions.py" />
            <source>&amp;Workspace</source>
            <translation>E&amp;space de travail</translation>
        </message>
        <message>
            <location filename="../../ui/commands/actions.py" />
            <source>&amp;Go to</source>
            <translation>Aller &amp;à</translation>
        </message>
        <message>
            <location filename="../../ui/commands/actions.py" />
            <source>Lay&amp;outs</source>
            <translation>D&amp;ispositions</translation>
        </message>
        <message>
            <location filename="../../ui/commands/actions.py" />
            <source>&amp;Help</source>
            <translation>A&amp;ide</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;New…</source>
            <translation>&amp;Nouveau…</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Begin a design on the start page</source>
            <translation>Commencer une conception sur la page d'accueil</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>New &amp;window</source>
            <translation>Nouvelle &amp;fenêtre</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Open another window with its own design and run</source>
            <translation>Ouvrir une autre fenêtre avec sa propre conception et sa propre exécution</translation>
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
            <source>Write the lens or its rays for other programs</source>
            <translation>Écrire la lentille ou ses rayons pour d'autres programmes</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Write the mirror or its rays for other programs</source>
            <translation>Écrire le miroir ou ses rayons pour d'autres programmes</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Cu&amp;t with a ball cutter…</source>
            <translation>Usiner à la fraise &amp;hémisphérique…</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Simulate a finishing pass and write it as G-code</source>
            <translation>Simuler une passe de finition et l'écrire en G-code</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>P&amp;lan milling and polishing…</source>
            <translation>P&amp;lanifier le fraisage et le polissage…</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Find step-over and polishing for a wanted error as made, with the least time</source>
            <translation>Trouver le pas et le polissage pour une erreur voulue après fabrication, en un minimum de temps</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Compare a p&amp;hotograph…</source>
            <translation>&amp;Comparer une photographie…</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Compare a photograph of the projected light with the prediction, and find likely causes</source>
            <translation>Comparer une photographie de la lumière projetée à la prédiction, et trouver les causes probables</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Read measured s&amp;urfaces…</source>
            <translation>L&amp;ire des surfaces mesurées…</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Compare measured parts with the design, and correct the design for the next part</source>
            <translation>Comparer des pièces mesurées à la conception, et corriger celle-ci pour la pièce suivante</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Report…</source>
            <translation>Ra&amp;pport…</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Write scene, pictures, check and figures as a report (HTML, PDF)</source>
            <translation>Écrire scène, images, vérification et chiffres dans un rapport (HTML, PDF)</translation>
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
            <source>Restore the saved file; Undo reverts</source>
            <translation>Rétablir le fichier enregistré ; peut être annulé</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Undo</source>
            <translation>A&amp;nnuler</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Undo the last change</source>
            <translation>Annuler la dernière modification</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Redo</source>
            <translation>&amp;Rétablir</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Redo the change</source>
            <translation>Rétablir la modification</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Paste picture</source>
            <translation>&amp;Coller une image</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Use the picture on the clipboard as the target</source>
            <translation>Utiliser l'image du presse-papiers comme cible</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Copy &amp;plot</source>
            <translation>Co&amp;pier le graphique</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Copy a picture of the plot that was clicked last</source>
            <translation>Copier une image du dernier graphique cliqué</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Save p&amp;lot…</source>
            <translation>&amp;Enregistrer le graphique…</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Save the plot that was clicked last, as picture (PNG, SVG) or numbers (CSV)</source>
            <translation>Enregistrer le dernier graphique cliqué, en image (PNG, SVG) ou en nombres (CSV)</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Pre&amp;ferences…</source>
            <translation>Pré&amp;férences…</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Theme, text size, language, start, checks and cores</source>
            <translation>Thème, taille du texte, langue, démarrage, vérifications et cœurs</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Start</source>
            <translation>&amp;Démarrer</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Design from scratch. Replaces this lens; Undo restores it.</source>
            <translation>Concevoir de zéro. Remplace cette lentille ; Annuler la rétablit.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Design from scratch. Replaces this mirror; Undo restores it.</source>
            <translation>Concevoir de zéro. Remplace ce miroir ; Annuler le rétablit.</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Continue</source>
            <translation>&amp;Continuer</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Continue the design of this lens with more iterations</source>
            <translation>Poursuivre la conception de cette lentille avec d'autres itérations</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Continue the design of this mirror with more iterations</source>
            <translation>Poursuivre la conception de ce miroir avec d'autres itérations</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Pause</source>
            <translation>&amp;Pause</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Pause the design, or resume it</source>
            <translation>Suspendre la conception ou la reprendre</translation>
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
            <source>&amp;Live update</source>
            <translation>Mise à &amp;jour en direct</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Update the lens after every edit, except during a run</source>
            <translation>Mettre à jour la lentille après chaque modification, sauf pendant une exécution</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Update the mirror after every edit, except during a run</source>
            <translation>Mettre à jour le miroir après chaque modification, sauf pendant une exécution</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>S&amp;weep…</source>
            <translation>Séri&amp;e…</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Design a lens for each of several values of a field</source>
            <translation>Concevoir une lentille pour chacune de plusieurs valeurs d'un champ</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Design a mirror for each of several values of a field</source>
            <translation>Concevoir un miroir pour chacune de plusieurs valeurs d'un champ</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Save &amp;video of the run…</source>
            <translation>Enregistrer la &amp;vidéo de l'exécution…</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Save the image after each iteration of this run as an animated picture (GIF, WebP)</source>
            <translation>Enregistrer l'image après chaque itération de cette exécution comme image animée (GIF, WebP)</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Restore run</source>
            <translation>&amp;Restaurer l'exécution</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Restore task and lens of the run selected in the dock Runs</source>
            <translation>Rétablir la tâche et la lentille de l'exécution choisie dans le panneau Exécutions</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Restore task and mirror of the run selected in the dock Runs</source>
            <translation>Rétablir la tâche et le miroir de l'exécution choisie dans le panneau Exécutions</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Compare runs</source>
            <translation>Co&amp;mparer des exécutions</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Compare irradiance, figures and fields of the two runs selected in the dock Runs</source>
            <translation>Comparer éclairement, chiffres et champs des deux exécutions choisies dans le panneau Exécutions</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Delete runs</source>
            <translation>S&amp;upprimer des exécutions</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Delete the runs selected in the dock Runs</source>
            <translation>Supprimer les exécutions choisies dans le panneau Exécutions</translation>
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
            <source>Check this lens with an independent ray trace; again to cancel</source>
            <translation>Vérifier cette lentille par un tracé de rayons indépendant ; de nouveau pour annuler</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Check this mirror with an independent ray trace; again to cancel</source>
            <translation>Vérifier ce miroir par un tracé de rayons indépendant ; de nouveau pour annuler</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Fit 3D view</source>
            <translation>A&amp;juster la vue 3D</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Fit lens and screen into the view</source>
            <translation>Ajuster la lentille et l'écran à la vue</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Fit mirror and screen into the view</source>
            <translation>Ajuster le miroir et l'écran à la vue</translation>
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
            <source>Fit the lens into the view</source>
            <translation>Ajuster la lentille à la vue</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Fit the mirror into the view</source>
            <translation>Ajuster le miroir à la vue</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Look at s&amp;creen</source>
            <translation>Regarder l'é&amp;cran</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Fit the screen into the view</source>
            <translation>Ajuster l'écran à la vue</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>From the &amp;side</source>
            <translation>De côt&amp;é</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>View along x; light travels to the right</source>
            <translation>Vue selon x ; la lumière va vers la droite</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>From a&amp;bove</source>
            <translation>D'en &amp;haut</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>View along y; light travels to the right</source>
            <translation>Vue selon y ; la lumière va vers la droite</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Along the a&amp;xis</source>
            <translation>Selon l'a&amp;xe</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>View along −z from behind the screen</source>
            <translation>Vue selon −z depuis l'arrière de l'écran</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Compress distances</source>
            <translation>C&amp;omprimer les distances</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Draw far elements nearer and a large screen smaller, to enlarge the lens</source>
            <translation>Dessiner plus près ce qui est loin et plus petit un grand écran, pour agrandir la lentille</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Draw far elements nearer and a large screen smaller, to enlarge the mirror</source>
            <translation>Dessiner plus près ce qui est loin et plus petit un grand écran, pour agrandir le miroir</translation>
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
            <source>By &amp;target</source>
            <translation>Selon la &amp;cible</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Colour map of images and 3D screen. By target: pictures as they are seen, unless the light is in lux; other light in Inferno</source>
            <translation>Palette des images et de l'écran 3D. Selon la cible : les images telles qu'on les voit, sauf lumière en lux ; autre lumière en Inferno</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>As &amp;seen</source>
            <translation>Comme &amp;vu</translation>
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
            <source>By the fraction of a ray's flux that arrives</source>
            <translation>Selon la part du flux du rayon qui arrive</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>As their &amp;material</source>
            <translation>Selon leur &amp;matériau</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Draw faces of the lens as glass or metal</source>
            <translation>Dessiner les faces de la lentille en verre ou en métal</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Draw faces of the mirror as glass or metal</source>
            <translation>Dessiner les faces du miroir en verre ou en métal</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>By &amp;height</source>
            <translation>Selon la &amp;hauteur</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Colour faces of the lens by height along z: dark is low</source>
            <translation>Colorer les faces de la lentille selon la hauteur en z : sombre est bas</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Colour faces of the mirror by height along z: dark is low</source>
            <translation>Colorer les faces du miroir selon la hauteur en z : sombre est bas</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>By &amp;curvature</source>
            <translation>Selon la &amp;courbure</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Colour faces of the lens by curvature: red is concave towards +z, blue convex</source>
            <translation>Colorer les faces de la lentille selon la courbure : rouge concave vers +z, bleu convexe</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Colour faces of the mirror by curvature: red is concave towards +z, blue convex</source>
            <translation>Colorer les faces du miroir selon la courbure : rouge concave vers +z, bleu convexe</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>By &amp;limits</source>
            <translation>Selon les &amp;limites</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Colour faces of the lens by the limits of manufacture: red is exceeded, green within</source>
            <translation>Colorer les faces de la lentille selon les limites de fabrication : rouge dépassée, vert respectée</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Colour faces of the mirror by the limits of manufacture: red is exceeded, green within</source>
            <translation>Colorer les faces du miroir selon les limites de fabrication : rouge dépassée, vert respectée</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Relief exaggerated</source>
            <translation>&amp;Relief exagéré</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Exaggerate the relief of faces in the 3D view; the lens is unchanged</source>
            <translation>Exagérer le relief des faces dans la vue 3D ; la lentille est inchangée</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Exaggerate the relief of faces in the 3D view; the mirror is unchanged</source>
            <translation>Exagérer le relief des faces dans la vue 3D ; le miroir est inchangé</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Perspective</source>
            <translation>&amp;Perspective</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Perspective instead of parallel projection</source>
            <translation>Perspective au lieu d'une projection parallèle</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Copy picture of 3&amp;D</source>
            <translation>Copier l'image 3&amp;D</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Copy a picture of the 3D scene to the clipboard</source>
            <translation>Copier une image de la scène 3D dans le presse-papiers</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Save pict&amp;ure of 3D…</source>
            <translation>&amp;Enregistrer l'image 3D…</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Save the 3D scene as PNG, about 1800 pixels wide</source>
            <translation>Enregistrer la scène 3D en PNG, large d'environ 1800 pixels</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Turn</source>
            <translation>&amp;Tourner</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Rotate the 3D scene by mouse or arrow keys; click to select</source>
            <translation>Tourner la scène 3D à la souris ou aux flèches ; cliquer pour sélectionner</translation>
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
            <source>Paint control points that runs must not change</source>
            <translation>Peindre les points de contrôle que les exécutions ne doivent pas modifier</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Move parts</source>
            <translation>&amp;Déplacer des pièces</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Drag source, elements, the thickness of a lens, or the screen</source>
            <translation>Glisser la source, des éléments, l'épaisseur d'une lentille ou l'écran</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>M&amp;easure</source>
            <translation>&amp;Mesurer</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Click two points on lens or screen for their distance</source>
            <translation>Cliquer deux points sur la lentille ou l'écran : leur distance</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Click two points on mirror or screen for their distance</source>
            <translation>Cliquer deux points sur le miroir ou l'écran : leur distance</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Mark &amp;regions</source>
            <translation>Marquer les &amp;régions</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Drag a rectangle on an image, or click the corners of a polygon and double-click; drag edges to move them. Esc ends</source>
            <translation>Tracer un rectangle sur une image, ou cliquer les coins d'un polygone puis double-cliquer ; les bords se déplacent. Échap termine</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Use aspect of the &amp;picture</source>
            <translation>Utiliser le ra&amp;pport de l'image</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Set size and pixels of the receiver to the aspect of the target's picture</source>
            <translation>Régler taille et pixels du récepteur selon le rapport de l'image cible</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Freeform entrance face</source>
            <translation>Face d'entrée de &amp;forme libre</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Make the entrance face freeform, or flat again; the exit face is unchanged</source>
            <translation>Rendre la face d'entrée de forme libre, ou plane à nouveau ; la face de sortie est inchangée</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Other face</source>
            <translation>&amp;Autre face</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Select the other freeform face of the lens for sculpting and locking</source>
            <translation>Choisir l'autre face de forme libre de la lentille pour sculpter et verrouiller</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Select the other freeform face of the mirror for sculpting and locking</source>
            <translation>Choisir l'autre face de forme libre du miroir pour sculpter et verrouiller</translation>
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
            <source>Lock all control points of the lens in runs</source>
            <translation>Verrouiller tous les points de contrôle de la lentille</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Lock all control points of the mirror in runs</source>
            <translation>Verrouiller tous les points de contrôle du miroir</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Unlock all points</source>
            <translation>Déverro&amp;uiller tous les points</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Unlock all control points of the lens</source>
            <translation>Déverrouiller tous les points de contrôle de la lentille</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Unlock all control points of the mirror</source>
            <translation>Déverrouiller tous les points de contrôle du miroir</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Invert locks</source>
            <translation>&amp;Inverser les verrous</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Lock unlocked control points, and unlock locked ones</source>
            <translation>Verrouiller les points déverrouillés et inversement</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Task</source>
            <translation>Tâche</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Describe the light, the element and the image</source>
            <translation>Décrire la lumière, l'élément et l'image</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Design</source>
            <translation>Conception</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Run the design and watch the image</source>
            <translation>Lancer la conception et suivre l'image</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Check</source>
            <translation>Vérification</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Verify the image: errors, cross-sections, through focus</source>
            <translation>Vérifier l'image : erreurs, coupes, autour du foyer</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Make</source>
            <translation>Fabrication</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Make the part: cutters, tolerances, exports</source>
            <translation>Fabriquer la pièce : fraises, tolérances, exports</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Start page</source>
            <translation>Page d'accueil</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Begin a design: a picture, a job, a recent file or an example</source>
            <translation>Commencer une conception : image, tâche, fichier récent ou exemple</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Custom</source>
            <translation>Personnel</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Arrange docks by hand: drag their title bars</source>
            <translation>Disposer les volets à la main : faire glisser leurs titres</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Save layout…</source>
            <translation>&amp;Enregistrer la disposition…</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Save the arrangement of the docks under a name</source>
            <translation>Enregistrer la disposition des volets sous un nom</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Delete layout…</source>
            <translation>&amp;Supprimer une disposition…</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Delete a saved arrangement of the docks</source>
            <translation>Supprimer une disposition enregistrée des volets</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>R&amp;eset layout</source>
            <translation>Réi&amp;nitialiser la disposition</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Arrange this workspace as it was at first</source>
            <translation>Disposer cet espace de travail comme au début</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Next pane</source>
            <translation>Volet &amp;suivant</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Move the keyboard focus to the next pane</source>
            <translation>Donner le focus au panneau suivant</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Previous pane</source>
            <translation>Volet &amp;précédent</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Move the keyboard focus to the previous pane</source>
            <translation>Donner le focus au panneau précédent</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Show this pane and focus it</source>
            <translation>Afficher ce panneau et lui donner le focus</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>3D scene</source>
            <translation>Scène 3D</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Irradiance</source>
            <translation>Éclairement</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Target</source>
            <translation>Cible</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Difference</source>
            <translation>Différence</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Photo</source>
            <translation>Photo</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Surface</source>
            <translation>Surface</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Derivative</source>
            <translation>Dérivée</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Through focus</source>
            <translation>Série focale</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Pinned</source>
            <translation>Épinglée</translation>
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
            <source>Result</source>
            <translation>Résultat</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Light account</source>
            <translation>Bilan de lumière</translation>
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
            <source>All keyboard shortcuts, with search</source>
            <translation>Tous les raccourcis clavier, avec recherche</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Tour</source>
            <translation>&amp;Visite guidée</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Four marks that explain the window</source>
            <translation>Quatre repères qui expliquent la fenêtre</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;Manual</source>
            <translation>&amp;Manuel</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>Manual of window, command line and methods</source>
            <translation>Manuel de la fenêtre, de la ligne de commande et des méthodes</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>&amp;About</source>
            <translation>À pr&amp;opos</translation>
        </message>
        <message>
            <location filename="../../ui/commands/table.py" />
            <source>About this program</source>
            <translation>À propos de ce programme</translation>
        </message>
        <message>
            <location filename="../../ui/background.py" />
            <source>The {work} failed: {error}</source>
            <translation>Échec ({work}) : {error}</translation>
        </message>
        <message>
            <location filename="../../ui/commands/actions.py" />
            <source>Limits in 3D</source>
            <translation>Limites en 3D</translation>
        </message>
        <message>
            <location filename="../../ui/commands/command_search.py" />
            <source>Command palette</source>
            <translation>Palette de commandes</translation>
        </message>
        <message>
            <location filename="../../ui/commands/command_search.py" />
            <source>Search commands</source>
            <translation>Rechercher des commandes</translation>
        </message>
        <message>
            <location filename="../../ui/commands/command_search.py" />
            <source>No command found: {words}</source>
            <translation>Aucune commande trouvée : {words}</translation>
        </message>
        <message>
            <location filename="../../ui/commands/toolbar.py" />
            <source>Toolbar</source>
            <translation>Barre d'outils</translation>
        </message>
        <message>
            <location filename="../../ui/commands/toolbar.py" />
            <source>More commands</source>
            <translation>Autres commandes</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/coach.py" />
            <source>Describe the task</source>
            <translation>Décrire la tâche</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/coach.py" />
            <source>Picture, light, lens and screen. Drag a label to change its value; Ctrl+Z undoes.</source>
            <translation>Image, lumière, lentille et écran. Faire glisser un libellé change sa valeur ; Ctrl+Z annule.</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/coach.py" />
            <source>Start the design</source>
            <translation>Lancer la conception</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/coach.py" />
            <source>Start (F5) designs the lens. Stop (F7) ends the run with the best lens so far.</source>
            <translation>Démarrer (F5) conçoit la lentille. Arrêter (F7) termine l'exécution avec la meilleure lentille obtenue.</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/coach.py" />
            <source>Image of light</source>
            <translation>Image de lumière</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/coach.py" />
            <source>The light on the screen, updated during the run. The buttons above show target, difference and photo.</source>
            <translation>La lumière sur l'écran, mise à jour pendant l'exécution. Les boutons au-dessus montrent cible, différence et photo.</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/coach.py" />
            <source>From task to part</source>
            <translation>De la tâche à la pièce</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/coach.py" />
            <source>Task, Design, Check, Make: verify the image, then export the lens for making.</source>
            <translation>Tâche, Conception, Vérification, Fabrication : vérifier l'image, puis exporter la lentille à fabriquer.</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/coach.py" />
            <source>&amp;End</source>
            <translation>&amp;Terminer</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/coach.py" />
            <source>{number} of {count}</source>
            <translation>{number} sur {count}</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/coach.py" />
            <source>&amp;Next</source>
            <translation>&amp;Suivant</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/coach.py" />
            <source>&amp;Done</source>
            <translation>&amp;Fini</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/comparison.py" />
            <source>Made and designed</source>
            <translation>Fabriqué et conçu</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/comparison.py" />
            <source>Figures</source>
            <translation>Valeurs</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/comparison.py" />
            <source>Made beside designed</source>
            <translation>Fabriqué à côté de conçu</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/corners.py" />
            <source>Drag the numbered corners onto those of the receiver: 1 is the top left corner of the target, and 2, 3 and 4 follow around it. With the keyboard: Space chooses a corner, arrows move it.</source>
            <translation>Faites glisser les coins numérotés sur ceux du récepteur : 1 est le coin supérieur gauche de la cible, 2, 3 et 4 suivent le tour. Au clavier : Espace choisit un coin, les flèches le déplacent.</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/corners.py" />
            <source>Photograph with the corners of the receiver</source>
            <translation>Photographie avec les coins du récepteur</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/corners.py" />
            <source>Compare a photograph</source>
            <translation>Comparer une photographie</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/corners.py" />
            <source>&amp;Compare</source>
            <translation>&amp;Comparer</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/drawing.py" />
            <source>Side view of the job</source>
            <translation>Vue de côté de la tâche</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/drawing.py" />
            <source>From the side</source>
            <translation>De côté</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/drawing.py" />
            <source>From above</source>
            <translation>D'en haut</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/drawing.py" />
            <source>, heights × {across:.1f}</source>
            <translation>, hauteurs × {across:.1f}</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/drawing.py" />
            <source>, to scale</source>
            <translation>, à l'échelle</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/estimate.py" />
            <source>estimate</source>
            <translation>estimation</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/estimate.py" />
            <source>Best possible image</source>
            <translation>Meilleure image possible</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/estimate.py" />
            <source>The source size blurs the image of any lens</source>
            <translation>La taille de la source rend floue l'image de toute lentille</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/estimate.py" />
            <source>Best possible</source>
            <translation>Au mieux</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/estimate.py" />
            <source>Computing the estimate…</source>
            <translation>Calcul de l'estimation…</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/estimate.py" />
            <source>Outdated figures.</source>
            <translation>Chiffres obsolètes.</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/estimate.py" />
            <source>Estimating… {part:.0f} %</source>
            <translation>Estimation… {part:.0f} %</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/help.py" />
            <source>Manual</source>
            <translation>Manuel</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/help.py" />
            <source>Search</source>
            <translation>Rechercher</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/help.py" />
            <source>Find pages with all words; Return shows the next match</source>
            <translation>Trouver les pages contenant tous les mots ; Entrée montre l'occurrence suivante</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/help.py" />
            <source>Search the manual</source>
            <translation>Rechercher dans le manuel</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/help.py" />
            <source>Pages of the manual</source>
            <translation>Pages du manuel</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/help.py" />
            <source>No page found: {words}</source>
            <translation>Aucune page trouvée : {words}</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/help.py" />
            <source>About {title}</source>
            <translation>À propos de {title}</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/help.py" />
            <source>&lt;h3&gt;{title} {version}&lt;/h3&gt;&lt;p&gt;Designs freeform lenses and mirrors that form a given irradiance.&lt;/p&gt;&lt;p&gt;MIT licence&lt;/p&gt;</source>
            <translation>&lt;h3&gt;{title} {version}&lt;/h3&gt;&lt;p&gt;Conçoit des lentilles et des miroirs de forme libre qui produisent un éclairement donné.&lt;/p&gt;&lt;p&gt;Licence MIT&lt;/p&gt;</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/job_form.py" />
            <source>picture</source>
            <translation>image</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/job_form.py" />
            <source>file of light</source>
            <translation>fichier de lumière</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/job_page.py" />
            <source>B&amp;ack</source>
            <translation>&amp;Retour</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/job_page.py" />
            <source>&amp;Begin</source>
            <translation>&amp;Commencer</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/job_page.py" />
            <source>Cannot begin: {reason}</source>
            <translation>Impossible de commencer : {reason}</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/job_page.py" />
            <source>Picture</source>
            <translation>Motif</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/measured.py" />
            <source>comparison</source>
            <translation>comparaison</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/measured.py" />
            <source>Read measured surfaces</source>
            <translation>Lire des surfaces mesurées</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/measured.py" />
            <source>Measured surfaces ({endings});;All files (*)</source>
            <translation>Surfaces mesurées ({endings});;Tous les fichiers (*)</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/measured.py" />
            <source>Measured surfaces</source>
            <translation>Surfaces mesurées</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/measured.py" />
            <source>Comparison with {file}</source>
            <translation>Comparaison avec {file}</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/measured.py" />
            <source>Write a design whose face makes good what repeats in the parts</source>
            <translation>Écrire une conception dont la surface compense ce qui se répète sur les pièces</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/measured.py" />
            <source>Save &amp;corrected part…</source>
            <translation>Enregistrer la pièce &amp;corrigée…</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/measured.py" />
            <source>Save the corrected part</source>
            <translation>Enregistrer la pièce corrigée</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/measured.py" />
            <source>Design (*.freeform)</source>
            <translation>Conception (*.freeform)</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/measured.py" />
            <source>Corrected part</source>
            <translation>Pièce corrigée</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/measured.py" />
            <source>{file} is written.</source>
            <translation>{file} est écrit.</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/preferences.py" />
            <source>As the system</source>
            <translation>Comme le système</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/preferences.py" />
            <source>Theme</source>
            <translation>Thème</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/preferences.py" />
            <source>Colours of all windows</source>
            <translation>Couleurs de toutes les fenêtres</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/preferences.py" />
            <source>Light</source>
            <translation>Lumière</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/preferences.py" />
            <source>Dark</source>
            <translation>Sombre</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/preferences.py" />
            <source>Text size</source>
            <translation>Taille du texte</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/preferences.py" />
            <source>Size of the text in all windows</source>
            <translation>Taille du texte dans toutes les fenêtres</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/preferences.py" />
            <source>Language</source>
            <translation>Langue</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/preferences.py" />
            <source>Language of the window; the command line is in English</source>
            <translation>Langue de la fenêtre ; la ligne de commande est en anglais</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/preferences.py" />
            <source>At the start</source>
            <translation>Au démarrage</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/preferences.py" />
            <source>What the window shows when the program starts without a file</source>
            <translation>Ce que montre la fenêtre quand le programme démarre sans fichier</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/preferences.py" />
            <source>Last design</source>
            <translation>Dernier projet</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/preferences.py" />
            <source>Finished lenses</source>
            <translation>Lentilles terminées</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/preferences.py" />
            <source>Whether an independent ray trace checks what a run or live update has finished</source>
            <translation>Indique si un tracé de rayons indépendant vérifie ce qu'une exécution ou la mise à jour en direct a terminé</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/preferences.py" />
            <source>Check the result</source>
            <translation>Vérifier le résultat</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/preferences.py" />
            <source>No check</source>
            <translation>Aucune vérification</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/preferences.py" />
            <source>Free cores</source>
            <translation>Cœurs libres</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/preferences.py" />
            <source>Cores that runs leave to the window and to other programs</source>
            <translation>Cœurs que les exécutions laissent à la fenêtre et aux autres programmes</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/preferences.py" />
            <source>Preferences</source>
            <translation>Préférences</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/preferences.py" />
            <source>Text size, language and cores change at the next start.</source>
            <translation>La taille du texte, la langue et les cœurs changent au prochain démarrage.</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/start_page.py" />
            <source>Jobs</source>
            <translation>Tâches</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/start_page.py" />
            <source>Examples</source>
            <translation>Exemples</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/start_page.py" />
            <source>Recent files</source>
            <translation>Fichiers récents</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/start_page.py" />
            <source>Begin with a job</source>
            <translation>Commencer par une tâche</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/start_page.py" />
            <source>Drop a picture here</source>
            <translation>Déposer une image ici</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/start_page.py" />
            <source>The lens will draw it with light. Ctrl+V pastes one.</source>
            <translation>La lentille la dessine avec la lumière. Ctrl+V colle une image.</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/start_page.py" />
            <source>Choose &amp;picture…</source>
            <translation>Choisir une i&amp;mage…</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/start_page.py" />
            <source>&amp;Open design…</source>
            <translation>&amp;Ouvrir une conception…</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/sweep.py" />
            <source>{count} of {wanted} designs</source>
            <translation>{count} conceptions sur {wanted}</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/sweep.py" />
            <source>Designs and checks a lens for each value, or each pair of values of two fields. The folder gets the sessions and a table (CSV, JSON). Finished designs are skipped.</source>
            <translation>Conçoit et vérifie une lentille pour chaque valeur, ou chaque paire de valeurs de deux champs. Le dossier reçoit les sessions et un tableau (CSV, JSON). Les conceptions terminées sont ignorées.</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/sweep.py" />
            <source>Verified error</source>
            <translation>Erreur vérifiée</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/sweep.py" />
            <source>Iterations</source>
            <translation>Itérations</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/sweep.py" />
            <source>Seconds</source>
            <translation>Secondes</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/sweep.py" />
            <source>Sweep</source>
            <translation>Série</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/sweep.py" />
            <source>Folder</source>
            <translation>Dossier</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/sweep.py" />
            <source>Progress of the sweep</source>
            <translation>Progression de la série</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/sweep.py" />
            <source>Designs of the sweep</source>
            <translation>Conceptions de la série</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/sweep.py" />
            <source>Start</source>
            <translation>Démarrer</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/sweep.py" />
            <source>Open the session of the selected row</source>
            <translation>Ouvrir la session de la ligne choisie</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/sweep.py" />
            <source>&amp;Open design</source>
            <translation>&amp;Ouvrir la conception</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/sweep.py" />
            <source>sweep</source>
            <translation>série</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/sweep.py" />
            <source>Choose a folder for the designs.</source>
            <translation>Choisir un dossier pour les conceptions.</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/sweep.py" />
            <source>Chosen at the start</source>
            <translation>Choisi au démarrage</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/sweep.py" />
            <source>Choose the folder</source>
            <translation>Choisir le dossier</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/sweep.py" />
            <source>Stop</source>
            <translation>Arrêter</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/sweep.py" />
            <source>Separate values by commas: 1, 2.5, 3; ranges as 0..4; pairs as 64x48; words as auto. Lengths in the unit of the scene.</source>
            <translation>Séparer les valeurs par des virgules : 1, 2.5, 3 ; plages comme 0..4 ; paires comme 64x48 ; mots comme auto. Longueurs dans l'unité de la scène.</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/sweep.py" />
            <source>Field</source>
            <translation>Champ</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/sweep.py" />
            <source>Second field</source>
            <translation>Second champ</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/sweep.py" />
            <source>Values of {field}</source>
            <translation>Valeurs de {field}</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/sweep.py" />
            <source>none</source>
            <translation>sans</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/sweep.py" />
            <source>now {value}</source>
            <translation>actuellement {value}</translation>
        </message>
        <message>
            <location filename="../../ui/dialogs/sweep.py" />
            <source>Verified error over the values</source>
            <translation>Erreur vérifiée selon les valeurs</translation>
        </message>
        <message>
            <location filename="../../ui/document/document.py" />
            <source>reload of the image</source>
            <translation>rechargement de l'image</translation>
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
            <location filename="../../ui/document/frame.py" />
            <source>Image {number}, {place}</source>
            <translation>Image {number}, {place}</translation>
        </message>
        <message>
            <location filename="../../ui/files/actions.py" />
            <source>Cancel</source>
            <translation>Annuler</translation>
        </message>
        <message>
            <location filename="../../ui/files/actions.py" />
            <source>The file has changed</source>
            <translation>Le fichier a changé</translation>
        </message>
        <message>
            <location filename="../../ui/files/actions.py" />
            <source>Another program has changed {name}.</source>
            <translation>Un autre programme a modifié {name}.</translation>
        </message>
        <message>
            <location filename="../../ui/files/actions.py" />
            <source>Overwrite discards its changes. Reload discards yours; Undo restores them.</source>
            <translation>Écraser abandonne ses modifications. Recharger abandonne les vôtres ; Annuler les rétablit.</translation>
        </message>
        <message>
            <location filename="../../ui/files/actions.py" />
            <source>&amp;Overwrite</source>
            <translation>&amp;Écraser</translation>
        </message>
        <message>
            <location filename="../../ui/files/actions.py" />
            <source>&amp;Reload</source>
            <translation>&amp;Recharger</translation>
        </message>
        <message>
            <location filename="../../ui/files/actions.py" />
            <source>The file is missing</source>
            <translation>Le fichier manque</translation>
        </message>
        <message>
            <location filename="../../ui/files/actions.py" />
            <source>{name} was deleted, moved or renamed.</source>
            <translation>{name} a été supprimé, déplacé ou renommé.</translation>
        </message>
        <message>
            <location filename="../../ui/files/actions.py" />
            <source>Its folder is missing too: {parent}</source>
            <translation>Son dossier manque aussi : {parent}</translation>
        </message>
        <message>
            <location filename="../../ui/files/actions.py" />
            <source>&amp;Save there again</source>
            <translation>&amp;Enregistrer à nouveau là</translation>
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
            <source>{path} no longer exists; it was removed from the list.</source>
            <translation>{path} n'existe plus ; il a été retiré de la liste.</translation>
        </message>
        <message>
            <location filename="../../ui/files/actions.py" />
            <source>Save as</source>
            <translation>Enregistrer sous</translation>
        </message>
        <message>
            <location filename="../../ui/files/actions.py" />
            <source>{name}: a design file ends in {ending}</source>
            <translation>{name} : un fichier de conception se termine par {ending}</translation>
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
            <source>{name} is open in another window. Choose another name.</source>
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
            <location filename="../../ui/files/dialogs.py" />
            <source>File of light</source>
            <translation>Fichier de lumière</translation>
        </message>
        <message>
            <location filename="../../ui/files/dialogs.py" />
            <source>{name} is a file of light, not a design.</source>
            <translation>{name} est un fichier de lumière, pas une conception.</translation>
        </message>
        <message>
            <location filename="../../ui/files/dialogs.py" />
            <source>Use as light source</source>
            <translation>Utiliser comme source de lumière</translation>
        </message>
        <message>
            <location filename="../../ui/files/dialogs.py" />
            <source>{name} is a picture, not a design.</source>
            <translation>{name} est une image, pas une conception.</translation>
        </message>
        <message>
            <location filename="../../ui/files/dialogs.py" />
            <source>Use as target</source>
            <translation>Utiliser comme cible</translation>
        </message>
        <message>
            <location filename="../../ui/files/dialogs.py" />
            <source>There is no picture on the clipboard.</source>
            <translation>Il n'y a pas d'image dans le presse-papiers.</translation>
        </message>
        <message>
            <location filename="../../ui/files/dialogs.py" />
            <source>Target image</source>
            <translation>Image cible</translation>
        </message>
        <message>
            <location filename="../../ui/files/exporter.py" />
            <source>A file is still being written. Start the next one after it.</source>
            <translation>Un fichier est encore en cours d'écriture. Commencez le suivant après.</translation>
        </message>
        <message>
            <location filename="../../ui/files/exporter.py" />
            <source>export</source>
            <translation>export</translation>
        </message>
        <message>
            <location filename="../../ui/files/exporter.py" />
            <source>Export {lens}</source>
            <translation>Exporter : {lens}</translation>
        </message>
        <message>
            <location filename="../../ui/files/exporter.py" />
            <source>Cut {lens}</source>
            <translation>Usiner : {lens}</translation>
        </message>
        <message>
            <location filename="../../ui/files/exporter.py" />
            <source>all, one file each</source>
            <translation>tous, un fichier chacun</translation>
        </message>
        <message>
            <location filename="../../ui/files/exporter.py" />
            <source>Export</source>
            <translation>Exporter</translation>
        </message>
        <message>
            <location filename="../../ui/files/exporter.py" />
            <source>Designed element</source>
            <translation>Élément conçu</translation>
        </message>
        <message>
            <location filename="../../ui/files/exporter.py" />
            <source>Replace {files}?</source>
            <translation>Remplacer {files} ?</translation>
        </message>
        <message>
            <location filename="../../ui/files/exporter.py" />
            <source>Export {name}</source>
            <translation>Exporter : {name}</translation>
        </message>
        <message>
            <location filename="../../ui/files/exporter.py" />
            <source>No file was written.</source>
            <translation>Aucun fichier n'a été écrit.</translation>
        </message>
        <message>
            <location filename="../../ui/files/exporter.py" />
            <source>{format} in {unit}</source>
            <translation>{format} en {unit}</translation>
        </message>
        <message>
            <location filename="../../ui/files/exporter.py" />
            <source>Web page (*.html)</source>
            <translation>Page web (*.html)</translation>
        </message>
        <message>
            <location filename="../../ui/files/exporter.py" />
            <source>Document (*.pdf)</source>
            <translation>Document (*.pdf)</translation>
        </message>
        <message>
            <location filename="../../ui/files/exporter.py" />
            <source>report</source>
            <translation>rapport</translation>
        </message>
        <message>
            <location filename="../../ui/files/exporter.py" />
            <source>Report {lens}</source>
            <translation>Rapport : {lens}</translation>
        </message>
        <message>
            <location filename="../../ui/files/exporter.py" />
            <source>Report {name}</source>
            <translation>Rapport : {name}</translation>
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
            <source>Animated picture (*.gif)</source>
            <translation>Image animée (*.gif)</translation>
        </message>
        <message>
            <location filename="../../ui/files/plots.py" />
            <source>Animated picture in all colours (*.webp)</source>
            <translation>Image animée en toutes couleurs (*.webp)</translation>
        </message>
        <message>
            <location filename="../../ui/files/plots.py" />
            <source>Animated PNG (*.apng)</source>
            <translation>PNG animé (*.apng)</translation>
        </message>
        <message>
            <location filename="../../ui/files/plots.py" />
            <source>Open folder</source>
            <translation>Ouvrir le dossier</translation>
        </message>
        <message>
            <location filename="../../ui/files/plots.py" />
            <source>{path} is written.</source>
            <translation>{path} est écrit.</translation>
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
            <source>Save {pane} plot</source>
            <translation>Enregistrer le graphique « {pane} »</translation>
        </message>
        <message>
            <location filename="../../ui/files/plots.py" />
            <source>{name}: a plot is saved as one of {known}</source>
            <translation>{name} : un graphique s'enregistre comme l'un de {known}</translation>
        </message>
        <message>
            <location filename="../../ui/files/plots.py" />
            <source>No plot is visible. The View menu shows the docks of plots.</source>
            <translation>Aucun graphique n'est visible. Le menu Affichage montre leurs panneaux.</translation>
        </message>
        <message>
            <location filename="../../ui/files/plots.py" />
            <source>A plot is still being written. Save the next one after it.</source>
            <translation>Un graphique est en cours d'écriture. Enregistrez le suivant ensuite.</translation>
        </message>
        <message>
            <location filename="../../ui/files/plots.py" />
            <source>video</source>
            <translation>vidéo</translation>
        </message>
        <message>
            <location filename="../../ui/files/plots.py" />
            <source>A video needs a run of some iterations. Press Start.</source>
            <translation>Une vidéo demande une exécution de quelques itérations. Appuyer sur Démarrer.</translation>
        </message>
        <message>
            <location filename="../../ui/files/plots.py" />
            <source>Save video</source>
            <translation>Enregistrer la vidéo</translation>
        </message>
        <message>
            <location filename="../../ui/files/plots.py" />
            <source>iteration {number}, error {error} %</source>
            <translation>itération {number}, erreur {error} %</translation>
        </message>
        <message>
            <location filename="../../ui/files/plots.py" />
            <source>A picture of the 3D scene is on the clipboard.</source>
            <translation>Une image de la scène 3D est dans le presse-papiers.</translation>
        </message>
        <message>
            <location filename="../../ui/files/plots.py" />
            <source>Save picture of 3D</source>
            <translation>Enregistrer l'image 3D</translation>
        </message>
        <message>
            <location filename="../../ui/files/plots.py" />
            <source>The 3D scene is hidden. View &gt; 3D scene shows it.</source>
            <translation>La scène 3D est masquée. Affichage &gt; Scène 3D la montre.</translation>
        </message>
        <message>
            <location filename="../../ui/files/recovery.py" />
            <source>{name} had unsaved changes when the program was terminated.</source>
            <translation>{name} avait des modifications non enregistrées à l'arrêt du programme.</translation>
        </message>
        <message>
            <location filename="../../ui/files/recovery.py" />
            <source>The program ended unexpectedly. Unsaved changes to {name} were kept.</source>
            <translation>Le programme s'est terminé de façon inattendue. Les modifications de {name} ont été conservées.</translation>
        </message>
        <message>
            <location filename="../../ui/files/recovery.py" />
            <source>Kept on {kept_at:%Y-%m-%d, %H:%M:%S}.</source>
            <translation>Gardées le {kept_at:%Y-%m-%d, %H:%M:%S}.</translation>
        </message>
        <message>
            <location filename="../../ui/files/recovery.py" />
            <source>Unsaved work</source>
            <translation>Travail non enregistré</translation>
        </message>
        <message>
            <location filename="../../ui/files/recovery.py" />
            <source>&amp;Recover</source>
            <translation>&amp;Récupérer</translation>
        </message>
        <message>
            <location filename="../../ui/files/recovery.py" />
            <source>&amp;Discard</source>
            <translation>&amp;Abandonner</translation>
        </message>
        <message>
            <location filename="../../ui/files/recovery.py" />
            <source>Ask &amp;later</source>
            <translation>Demander p&amp;lus tard</translation>
        </message>
        <message>
            <location filename="../../ui/files/recovery.py" />
            <source>recovery</source>
            <translation>récupération</translation>
        </message>
        <message>
            <location filename="../../ui/files/recovery.py" />
            <source>Unsaved work cannot be backed up. {reason}</source>
            <translation>Le travail non enregistré ne peut pas être sauvegardé. {reason}</translation>
        </message>
        <message>
            <location filename="../../ui/lens/brush_tools.py" />
            <source>a single point</source>
            <translation>un seul point</translation>
        </message>
        <message>
            <location filename="../../ui/lens/brush_tools.py" />
            <source>radius {radius}</source>
            <translation>rayon {radius}</translation>
        </message>
        <message>
            <location filename="../../ui/lens/brush_tools.py" />
            <source>{place}Paint control points to lock or unlock them; or use arrows and Space. Brush ([ and ]): {words}. {count} locked</source>
            <translation>{place}Peindre les points de contrôle pour les verrouiller ou déverrouiller ; ou flèches et Espace. Pinceau ([ et ]) : {words}. {count} verrouillés</translation>
        </message>
        <message>
            <location filename="../../ui/lens/brush_tools.py" />
            <source>{place}Drag control points along z, or use arrows, Page Up and Page Down. Shift: fine, Esc: cancel. Brush ([ and ]): {words}</source>
            <translation>{place}Faire glisser les points de contrôle selon z, ou flèches, Page haut et Page bas. Maj : fin, Échap : annuler. Pinceau ([ et ]) : {words}</translation>
        </message>
        <message>
            <location filename="../../ui/lens/brush_tools.py" />
            <source>. Moved by {rise:+.4g} {unit}</source>
            <translation>. Déplacé de {rise:+.4g} {unit}</translation>
        </message>
        <message>
            <location filename="../../ui/lens/brush_tools.py" />
            <source>All control points under the brush are locked. Unlock some first.</source>
            <translation>Tous les points de contrôle du pinceau sont verrouillés ; en libérer d'abord.</translation>
        </message>
        <message>
            <location filename="../../ui/lens/measure.py" />
            <source>Switch off View &gt; Compress distances first, then measure.</source>
            <translation>Désactivez d'abord Affichage &gt; Comprimer les distances, puis mesurez.</translation>
        </message>
        <message>
            <location filename="../../ui/lens/measure.py" />
            <source>Click two points on lens or screen, or drag from one to the other.</source>
            <translation>Cliquez deux points sur la lentille ou l'écran, ou tirez de l'un à l'autre.</translation>
        </message>
        <message>
            <location filename="../../ui/lens/measure.py" />
            <source>Distance {length} {unit}: x {x}, y {y}, z {z}</source>
            <translation>Distance {length} {unit} : x {x}, y {y}, z {z}</translation>
        </message>
        <message>
            <location filename="../../ui/lens/move_source.py" />
            <source>Drag a handle, with Ctrl along z: source, elements, thickness at the lower rim, distance of a screen. Shift: fine, Esc: cancel.</source>
            <translation>Glisser une poignée, avec Ctrl le long de z : source, éléments, épaisseur au bord inférieur, distance d'un écran. Maj : fin, Échap : annuler.</translation>
        </message>
        <message>
            <location filename="../../ui/lens/move_source.py" />
            <source>Arrows, Page Up and Page Down move the source.</source>
            <translation>Les flèches, Page préc. et Page suiv. déplacent la source.</translation>
        </message>
        <message>
            <location filename="../../ui/lens/tools.py" />
            <source>ray trace</source>
            <translation>tracé de rayons</translation>
        </message>
        <message>
            <location filename="../../ui/lens/tools.py" />
            <source>Stop the run first, then sculpt the lens.</source>
            <translation>Arrêtez d'abord l'exécution, puis sculptez la lentille.</translation>
        </message>
        <message>
            <location filename="../../ui/lens/tools.py" />
            <source>Stop the run first, then sculpt the mirror.</source>
            <translation>Arrêtez d'abord l'exécution, puis sculptez le miroir.</translation>
        </message>
        <message>
            <location filename="../../ui/lens/tools.py" />
            <source>There is no lens to sculpt yet.</source>
            <translation>Il n'y a pas encore de lentille à façonner.</translation>
        </message>
        <message>
            <location filename="../../ui/lens/tools.py" />
            <source>There is no mirror to sculpt yet.</source>
            <translation>Il n'y a pas encore de miroir à façonner.</translation>
        </message>
        <message>
            <location filename="../../ui/lens/tools.py" />
            <source>There is only one freeform face. Design &gt; Freeform entrance face adds a second one.</source>
            <translation>Il y a une face de forme libre. Conception &gt; Face d'entrée de forme libre en donne une seconde à une lentille.</translation>
        </message>
        <message>
            <location filename="../../ui/lens/tools.py" />
            <source>Switch off View &gt; Compress distances first, then move the source.</source>
            <translation>Désactivez d'abord Affichage &gt; Comprimer les distances, puis déplacez la source.</translation>
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
            <source>The {count} oldest steps can no longer be undone (memory limit)</source>
            <translation>Les {count} plus anciennes étapes ne peuvent plus être annulées (limite de mémoire)</translation>
        </message>
        <message>
            <location filename="../../ui/main_window.py" />
            <source>A run of {design} is in progress. Stop it and save the best lens?</source>
            <translation>Une exécution de {design} est en cours. L'arrêter et enregistrer la meilleure lentille ?</translation>
        </message>
        <message>
            <location filename="../../ui/main_window.py" />
            <source>A run of {design} is in progress. Stop it and save the best mirror?</source>
            <translation>Une exécution de {design} est en cours. L'arrêter et enregistrer le meilleur miroir ?</translation>
        </message>
        <message>
            <location filename="../../ui/main_window.py" />
            <source> Changes that wait for the end of the run are discarded.</source>
            <translation> Les modifications en attente de la fin de l'exécution sont abandonnées.</translation>
        </message>
        <message>
            <location filename="../../ui/main_window.py" />
            <source>A run of {design} is in progress. Stop it to open {file}.</source>
            <translation>Une exécution de {design} est en cours. Arrêtez-la pour ouvrir {file}.</translation>
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
            <source>Saved with the task of the run.</source>
            <translation>Enregistré avec la tâche de l'exécution.</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cutter.py" />
            <source>Writes the passes of a ball cutter as G-code in millimetres. The cut is simulated first; a cutter that leaves too much material or cuts too deep is refused.</source>
            <translation>Écrit les passes d’une fraise boule en code G, en millimètres. L’usinage est d’abord simulé ; une fraise qui laisse trop de matière ou coupe trop profond est refusée.</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cutter.py" />
            <source>simulation of the cut</source>
            <translation>simulation de l'usinage</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cutter.py" />
            <source>Ball cutter</source>
            <translation>Fraise hémisphérique</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cutter.py" />
            <source>Result of the simulation</source>
            <translation>Résultat de la simulation</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cutter.py" />
            <source>&amp;Write G-code…</source>
            <translation>É&amp;crire le G-code…</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cutter.py" />
            <source>Compare the image of the lens as made with the lens as designed</source>
            <translation>Comparer l'image de la lentille usinée à celle de la lentille conçue</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/cutter.py" />
            <source>&amp;Trace light</source>
            <translation>&amp;Tracer la lumière</translation>
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
            <source>Radius {radius}, {size:,} moves. {deep}; up to {left} of material remains.</source>
            <translation>Rayon {radius}, {size:,} mouvements. {deep} ; il reste jusqu'à {left} de matière.</translation>
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
            <location filename="../../ui/manufacture/figures.py" />
            <source>Empty: the limit of the design task. Stored for the next start.</source>
            <translation>Vide : la limite de la tâche. Conservé pour le prochain démarrage.</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>✓ met</source>
            <translation>✓ tenue</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>The limit is kept everywhere.</source>
            <translation>La limite est respectée partout.</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>? not checked yet</source>
            <translation>? pas encore vérifié</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>The limit is kept at all sampled points. Proved for the whole face: {bound}.</source>
            <translation>La limite est respectée à tous les points échantillonnés. Prouvé pour toute la face : {bound}.</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>✗ exceeded</source>
            <translation>✗ dépassée</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>The limit is exceeded; the map shows where.</source>
            <translation>La limite est dépassée ; la carte montre où.</translation>
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
            <source>Least concave radius of curvature</source>
            <translation>Plus petit rayon de courbure concave</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>Convex radius</source>
            <translation>Rayon convexe</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>Least convex radius of curvature</source>
            <translation>Plus petit rayon de courbure convexe</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>Largest ball cutter</source>
            <translation>Plus grande fraise boule</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>Radius of the largest ball cutter that fits everywhere on the face. A larger ball leaves material in hollows</source>
            <translation>Rayon de la plus grande fraise boule qui passe partout sur la face. Une boule plus grande laisse de la matière dans les creux</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>Sag range</source>
            <translation>Flèche</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>Height of the highest point of the face above the lowest</source>
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
            <source>Limit: {label}</source>
            <translation>Limite : {label}</translation>
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
            <source>Verdict: {figure}</source>
            <translation>Verdict : {figure}</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>The face has none.</source>
            <translation>La face n'en a pas.</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/figures.py" />
            <source>At x = {x}, y = {y}. Proved bound: {bound}.</source>
            <translation>En x = {x}, y = {y}. Borne prouvée : {bound}.</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/pane.py" />
            <source>Computed when the design rests…</source>
            <translation>Calculé quand la conception est au repos…</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/pane.py" />
            <source>Thickness along z</source>
            <translation>Épaisseur selon z</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/pane.py" />
            <source>Angle between the face and a plane across the axis</source>
            <translation>Angle entre la face et un plan perpendiculaire à l'axe</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/pane.py" />
            <source>Largest concave curvature; zero where there is none</source>
            <translation>Plus grande courbure concave ; zéro s'il n'y en a pas</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/pane.py" />
            <source>Largest convex curvature; zero where there is none</source>
            <translation>Plus grande courbure convexe ; zéro s'il n'y en a pas</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/pane.py" />
            <source>Red and hatched where a limit is exceeded, green elsewhere</source>
            <translation>Rouge et hachuré là où une limite est dépassée, vert ailleurs</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/pane.py" />
            <source>; hatched where a limit is exceeded</source>
            <translation>; hachuré où une limite est dépassée</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/pane.py" />
            <source>exceeded</source>
            <translation>dépassées</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/pane.py" />
            <source>analysis of the face</source>
            <translation>analyse de la face</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/pane.py" />
            <source>Analysis of the face</source>
            <translation>Analyse de la face</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/pane.py" />
            <source>Computing…</source>
            <translation>Calcul…</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/pane.py" />
            <source>Computing the figures…</source>
            <translation>Calcul des valeurs…</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/pane.py" />
            <source>Outdated; recomputed when the design rests.</source>
            <translation>Obsolète ; recalculé quand la conception est au repos.</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/plan.py" />
            <source>Step-over</source>
            <translation>Pas entre passes</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/plan.py" />
            <source>Scallop</source>
            <translation>Crête</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/plan.py" />
            <source>Polish over</source>
            <translation>Polissage sur</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/plan.py" />
            <source>Error as made</source>
            <translation>Erreur après fabrication</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/plan.py" />
            <source>Minutes</source>
            <translation>Minutes</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/plan.py" />
            <source>Milling leaves scallops, and polishing removes them and fine details of the lens. These plans reach the wanted error; the first takes the least time and is verified by random rays.</source>
            <translation>Le fraisage laisse des crêtes ; le polissage les enlève, avec les détails fins de la lentille. Ces plans atteignent l'erreur voulue ; le premier prend le moins de temps et est vérifié par des rayons aléatoires.</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/plan.py" />
            <source>Plan milling and polishing</source>
            <translation>Planifier le fraisage et le polissage</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/plan.py" />
            <source>search for plans</source>
            <translation>recherche de plans</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/plan.py" />
            <source>Result of the search</source>
            <translation>Résultat de la recherche</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/plan.py" />
            <source>Plans</source>
            <translation>Plans</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/plan.py" />
            <source>Enter these processes; Continue then designs for them</source>
            <translation>Entrer ces procédés ; Continuer conçoit ensuite pour eux</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/plan.py" />
            <source>&amp;Use this plan</source>
            <translation>&amp;Utiliser ce plan</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/plan.py" />
            <source>&amp;Find plans</source>
            <translation>&amp;Chercher des plans</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/plan.py" />
            <source>Comparing plans: {percent} %</source>
            <translation>Comparaison des plans : {percent} %</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/plan.py" />
            <source>plan of manufacture</source>
            <translation>plan de fabrication</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/plan.py" />
            <source>Error as designed {designed:.2f} %, wanted as made {wanted:.2f} %; ball radius {radius}.</source>
            <translation>Erreur telle que conçue {designed:.2f} %, voulue après fabrication {wanted:.2f} % ; rayon de la fraise {radius}.</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/tolerance_form.py" />
            <source>Lenses</source>
            <translation>Lentilles</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/tolerance_form.py" />
            <source>Number of traced lenses; more lenses give better percentiles</source>
            <translation>Nombre de lentilles tracées ; davantage donne de meilleurs percentiles</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/tolerance_form.py" />
            <source>Seed</source>
            <translation>Graine</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/tolerance_form.py" />
            <source>The same seed gives the same lenses</source>
            <translation>La même graine donne les mêmes lentilles</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/tolerance_form.py" />
            <source>over</source>
            <translation>sur</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/tolerance_pane.py" />
            <source>Start traces randomly perturbed lenses and shows the distribution of the error.</source>
            <translation>Démarrer trace des lentilles perturbées au hasard et montre la distribution de l'erreur.</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/tolerance_pane.py" />
            <source>All tolerances are zero. Enter a tilt, a decentre or another tolerance.</source>
            <translation>Toutes les tolérances sont nulles. Entrez une inclinaison, un décentrement ou une autre tolérance.</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/tolerance_pane.py" />
            <source>Save…</source>
            <translation>Enregistrer…</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/tolerance_pane.py" />
            <source>Save the plot (PNG, SVG), or the figures of each lens (CSV, JSON)</source>
            <translation>Enregistrer le graphique (PNG, SVG), ou les chiffres de chaque lentille (CSV, JSON)</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/tolerance_pane.py" />
            <source>tolerance analysis</source>
            <translation>analyse de tolérances</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/tolerance_pane.py" />
            <source>Stop; the traced lenses are kept</source>
            <translation>Arrêter ; les lentilles tracées sont conservées</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/tolerance_pane.py" />
            <source>Perturb the lens at random and trace each sample independently</source>
            <translation>Perturber la lentille au hasard et tracer chaque échantillon indépendamment</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/tolerance_pane.py" />
            <source>{count} of {wanted} lenses</source>
            <translation>{count} lentilles sur {wanted}</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/tolerance_pane.py" />
            <source>{done}: error as designed {nominal:.2f} %, median {median:.2f} %, 95 % of lenses below {most:.2f} %, worst {worst:.2f} %</source>
            <translation>{done} : erreur de la conception {nominal:.2f} %, médiane {median:.2f} %, 95 % des lentilles sous {most:.2f} %, pire {worst:.2f} %</translation>
        </message>
        <message>
            <location filename="../../ui/manufacture/tolerance_pane.py" />
            <source>Outdated: the lens has changed.</source>
            <translation>Obsolète : la lentille a changé.</translation>
        </message>
        <message>
            <location filename="../../ui/panels/area.py" />
            <source>Limits</source>
            <translation>Limites</translation>
        </message>
        <message>
            <location filename="../../ui/panels/area.py" />
            <source>Expert</source>
            <translation>Expert</translation>
        </message>
        <message>
            <location filename="../../ui/panels/area.py" />
            <source>No field matches.</source>
            <translation>Aucun champ ne correspond.</translation>
        </message>
        <message>
            <location filename="../../ui/panels/area.py" />
            <source>Search all fields by name, explanation or path in files (Ctrl+F)</source>
            <translation>Chercher parmi tous les champs par nom, explication ou chemin dans les fichiers (Ctrl+F)</translation>
        </message>
        <message>
            <location filename="../../ui/panels/area.py" />
            <source>Search fields</source>
            <translation>Chercher un champ</translation>
        </message>
        <message>
            <location filename="../../ui/panels/area.py" />
            <source>{count} changed</source>
            <translation>{count} modif.</translation>
        </message>
        <message>
            <location filename="../../ui/panels/crop.py" />
            <source>Picture with the part that is kept</source>
            <translation>Image avec la partie conservée</translation>
        </message>
        <message>
            <location filename="../../ui/panels/edits.py" />
            <source>the task no longer has this field</source>
            <translation>la tâche n'a plus ce champ</translation>
        </message>
        <message>
            <location filename="../../ui/panels/elements.py" />
            <source>element</source>
            <translation>élément</translation>
        </message>
        <message>
            <location filename="../../ui/panels/elements.py" />
            <source>Add lens</source>
            <translation>+ lentille</translation>
        </message>
        <message>
            <location filename="../../ui/panels/elements.py" />
            <source>Add a plano-convex lens of fixed shape behind the others</source>
            <translation>Ajouter une lentille plan-convexe de forme fixe derrière les autres</translation>
        </message>
        <message>
            <location filename="../../ui/panels/elements.py" />
            <source>Add mirror</source>
            <translation>+ miroir</translation>
        </message>
        <message>
            <location filename="../../ui/panels/elements.py" />
            <source>Add a plane mirror behind the others</source>
            <translation>Ajouter un miroir plan derrière les autres</translation>
        </message>
        <message>
            <location filename="../../ui/panels/elements.py" />
            <source>Add diffuser</source>
            <translation>+ diffuseur</translation>
        </message>
        <message>
            <location filename="../../ui/panels/elements.py" />
            <source>Add a diffuser behind the others</source>
            <translation>Ajouter un diffuseur derrière les autres</translation>
        </message>
        <message>
            <location filename="../../ui/panels/elements.py" />
            <source>Optical train</source>
            <translation>Train optique</translation>
        </message>
        <message>
            <location filename="../../ui/panels/elements.py" />
            <source>designed</source>
            <translation>à concevoir</translation>
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
            <source>Bounds of the control heights relative to the base, down and up. Wider bounds allow larger deflection.</source>
            <translation>Bornes des hauteurs de contrôle par rapport à la base, vers le bas et le haut. Des bornes plus larges permettent une plus grande déviation.</translation>
        </message>
        <message>
            <location filename="../../ui/panels/elements.py" />
            <source>From the base</source>
            <translation>Depuis la base</translation>
        </message>
        <message>
            <location filename="../../ui/panels/fields.py" />
            <source>change of {name}</source>
            <translation>modification : {name}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/fields.py" />
            <source>{label}, {number} of {count}</source>
            <translation>{label}, {number} sur {count}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/fields.py" />
            <source>Auto</source>
            <translation>Auto</translation>
        </message>
        <message>
            <location filename="../../ui/panels/fields.py" />
            <source>{label}, automatic</source>
            <translation>{label}, automatique</translation>
        </message>
        <message>
            <location filename="../../ui/panels/fields.py" />
            <source>auto</source>
            <translation>auto</translation>
        </message>
        <message>
            <location filename="../../ui/panels/forms.py" />
            <source>refused {edit}</source>
            <translation>refusé : {edit}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/forms.py" />
            <source>change of target image</source>
            <translation>changement d'image cible</translation>
        </message>
        <message>
            <location filename="../../ui/panels/forms.py" />
            <source>change of file of light</source>
            <translation>changement de fichier de lumière</translation>
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
            <source>The target is not a picture and has no aspect.</source>
            <translation>La cible n'est pas une image et n'a pas de rapport.</translation>
        </message>
        <message>
            <location filename="../../ui/panels/forms.py" />
            <source>The picture cannot be read: {refused}</source>
            <translation>L'image ne peut pas être lue : {refused}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/forms.py" />
            <source>aspect of the picture for the screen</source>
            <translation>rapport de l'image pour l'écran</translation>
        </message>
        <message>
            <location filename="../../ui/panels/forms.py" />
            <source>aspect of the picture for the far field</source>
            <translation>rapport de l'image pour le champ lointain</translation>
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
            <source>The {edit} is refused: {refused}</source>
            <translation>Refusé ({edit}) : {refused}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/forms.py" />
            <source>Refused: {refused}</source>
            <translation>Refusé : {refused}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/forms.py" />
            <source>Stop the run first, then reload the image.</source>
            <translation>Arrêtez d'abord l'exécution, puis rechargez l'image.</translation>
        </message>
        <message>
            <location filename="../../ui/panels/forms.py" />
            <source>Waiting for the end of the run: {edits}.</source>
            <translation>Attend la fin de l'exécution : {edits}.</translation>
        </message>
        <message>
            <location filename="../../ui/panels/images.py" />
            <source>Images ({endings});;All files (*)</source>
            <translation>Images ({endings});;Tous les fichiers (*)</translation>
        </message>
        <message>
            <location filename="../../ui/panels/images.py" />
            <source>An image file can also be dropped onto the window.</source>
            <translation>Un fichier d'image peut aussi être déposé sur la fenêtre.</translation>
        </message>
        <message>
            <location filename="../../ui/panels/images.py" />
            <source>Choose the part of the picture that is used, and its levels</source>
            <translation>Choisir la partie de l'image qui est utilisée, et ses niveaux</translation>
        </message>
        <message>
            <location filename="../../ui/panels/images.py" />
            <source>Crop and tone…</source>
            <translation>Recadrage et tons…</translation>
        </message>
        <message>
            <location filename="../../ui/panels/images.py" />
            <source>Turn</source>
            <translation>Tourner</translation>
        </message>
        <message>
            <location filename="../../ui/panels/images.py" />
            <source>Turn the picture by a quarter to the right</source>
            <translation>Tourner l'image d'un quart à droite</translation>
        </message>
        <message>
            <location filename="../../ui/panels/images.py" />
            <source>crop and tone of the picture</source>
            <translation>recadrage et tons de l'image</translation>
        </message>
        <message>
            <location filename="../../ui/panels/images.py" />
            <source>turn of the picture</source>
            <translation>rotation de l'image</translation>
        </message>
        <message>
            <location filename="../../ui/panels/images.py" />
            <source>Target irradiance as its viewer sees it</source>
            <translation>Éclairement cible tel que l'observateur le voit</translation>
        </message>
        <message>
            <location filename="../../ui/panels/images.py" />
            <source>image</source>
            <translation>image</translation>
        </message>
        <message>
            <location filename="../../ui/panels/images.py" />
            <source>Image {number}</source>
            <translation>Image {number}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/images.py" />
            <source>Add an image farther away, with the target of the last one</source>
            <translation>Ajouter une image plus loin, avec la cible de la dernière</translation>
        </message>
        <message>
            <location filename="../../ui/panels/images.py" />
            <source>Add</source>
            <translation>Ajouter</translation>
        </message>
        <message>
            <location filename="../../ui/panels/images.py" />
            <source>The panels Target and Receiver belong to image 1.</source>
            <translation>Les panneaux Cible et Récepteur appartiennent à l'image 1.</translation>
        </message>
        <message>
            <location filename="../../ui/panels/images.py" />
            <source>{place}, {target}, weight {weight:g}</source>
            <translation>{place}, {target}, poids {weight:g}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/images.py" />
            <source>As x, y; x, y; …</source>
            <translation>Sous la forme x, y; x, y; …</translation>
        </message>
        <message>
            <location filename="../../ui/panels/images.py" />
            <source>region</source>
            <translation>région</translation>
        </message>
        <message>
            <location filename="../../ui/panels/images.py" />
            <source>Region {number}</source>
            <translation>Région {number}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/images.py" />
            <source>None.</source>
            <translation>Aucune.</translation>
        </message>
        <message>
            <location filename="../../ui/panels/images.py" />
            <source>Shape</source>
            <translation>Forme</translation>
        </message>
        <message>
            <location filename="../../ui/panels/images.py" />
            <source>Add a region in the middle</source>
            <translation>Ajouter une région au milieu</translation>
        </message>
        <message>
            <location filename="../../ui/panels/images.py" />
            <source>Regions</source>
            <translation>Régions</translation>
        </message>
        <message>
            <location filename="../../ui/panels/images.py" />
            <source>Region {count}</source>
            <translation>Région {count}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/panel.py" />
            <source>{panel} {field}</source>
            <translation>{panel}, {field}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/panel.py" />
            <source>Duplicate</source>
            <translation>Dupliquer</translation>
        </message>
        <message>
            <location filename="../../ui/panels/panel.py" />
            <source>Add a copy of the selected one</source>
            <translation>Ajouter une copie de l'entrée choisie</translation>
        </message>
        <message>
            <location filename="../../ui/panels/panel.py" />
            <source>Remove</source>
            <translation>Retirer</translation>
        </message>
        <message>
            <location filename="../../ui/panels/panel.py" />
            <source>Remove the selected one</source>
            <translation>Supprimer l'entrée choisie</translation>
        </message>
        <message>
            <location filename="../../ui/panels/panel.py" />
            <source>Up</source>
            <translation>Monter</translation>
        </message>
        <message>
            <location filename="../../ui/panels/panel.py" />
            <source>Move the selected one up</source>
            <translation>Monter l'entrée choisie</translation>
        </message>
        <message>
            <location filename="../../ui/panels/panel.py" />
            <source>Down</source>
            <translation>Descendre</translation>
        </message>
        <message>
            <location filename="../../ui/panels/panel.py" />
            <source>Move the selected one down</source>
            <translation>Descendre l'entrée choisie</translation>
        </message>
        <message>
            <location filename="../../ui/panels/panel.py" />
            <source>new {part}</source>
            <translation>nouveau : {part}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/panel.py" />
            <source>copy of {part} {number}</source>
            <translation>copie : {part} {number}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/panel.py" />
            <source>removal of {part} {number}</source>
            <translation>retrait : {part} {number}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/panel.py" />
            <source>move of {part} {number}</source>
            <translation>déplacement : {part} {number}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/picture_dialog.py" />
            <source>Histogram of the picture</source>
            <translation>Histogramme de l'image</translation>
        </message>
        <message>
            <location filename="../../ui/panels/picture_dialog.py" />
            <source>Drag black level, mid-tones or white level; double-click to reset all three</source>
            <translation>Glisser le niveau du noir, les tons moyens ou le niveau du blanc ; un double-clic remet les trois</translation>
        </message>
        <message>
            <location filename="../../ui/panels/picture_dialog.py" />
            <source>Crop and tone of the picture</source>
            <translation>Recadrage et tons de l'image</translation>
        </message>
        <message>
            <location filename="../../ui/panels/picture_dialog.py" />
            <source>&amp;Whole picture</source>
            <translation>Image &amp;entière</translation>
        </message>
        <message>
            <location filename="../../ui/panels/picture_dialog.py" />
            <source>Kept: {width:.0f} × {height:.0f} % of the picture, aspect {aspect:.2f}</source>
            <translation>Conservé : {width:.0f} × {height:.0f} % de l'image, rapport {aspect:.2f}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/picture_dialog.py" />
            <source>Peak: {peak:.1f} × the mean; black: {black:.0f} % of the area</source>
            <translation>Maximum : {peak:.1f} × la moyenne ; noir : {black:.0f} % de la surface</translation>
        </message>
        <message>
            <location filename="../../ui/panels/rows.py" />
            <source>The design keeps files of up to {largest} MB.</source>
            <translation>La conception garde les fichiers jusqu'à {largest} Mo.</translation>
        </message>
        <message>
            <location filename="../../ui/panels/rows.py" />
            <source>Choose a file</source>
            <translation>Choisir un fichier</translation>
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
            <location filename="../../ui/panels/scene.py" />
            <source>Files of light ({endings});;All files (*)</source>
            <translation>Fichiers de lumière ({endings});;Tous les fichiers (*)</translation>
        </message>
        <message>
            <location filename="../../ui/panels/scene.py" />
            <source>Number of optimised parameters, and their memory with gradient and optimiser state. A network that does not fit into memory is refused at the start.</source>
            <translation>Nombre de paramètres optimisés, et leur mémoire avec gradient et état de l'optimiseur. Un réseau qui ne tient pas en mémoire est refusé au démarrage.</translation>
        </message>
        <message>
            <location filename="../../ui/panels/scene.py" />
            <source>Parameters</source>
            <translation>Paramètres</translation>
        </message>
        <message>
            <location filename="../../ui/panels/scene.py" />
            <source>1 iteration</source>
            <translation>1 itération</translation>
        </message>
        <message>
            <location filename="../../ui/panels/scene.py" />
            <source>{count} iterations</source>
            <translation>{count} itérations</translation>
        </message>
        <message>
            <location filename="../../ui/panels/scene.py" />
            <source>stage</source>
            <translation>étape</translation>
        </message>
        <message>
            <location filename="../../ui/panels/scene.py" />
            <source>Stage {number}</source>
            <translation>Étape {number}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/scene.py" />
            <source>None: the run has only the scene itself.</source>
            <translation>Aucune : l'exécution n'a que la scène elle-même.</translation>
        </message>
        <message>
            <location filename="../../ui/panels/scene.py" />
            <source>Stages that a run completes before the scene itself; each continues from the lens of the previous one. Example: a point source before an extended one, or a coarse net before a fine one.</source>
            <translation>Étapes qu'une exécution parcourt avant la scène elle-même ; chacune continue depuis la lentille de la précédente. Exemple : une source ponctuelle avant une source étendue, ou un réseau grossier avant un fin.</translation>
        </message>
        <message>
            <location filename="../../ui/panels/scene.py" />
            <source>Stages</source>
            <translation>Étapes</translation>
        </message>
        <message>
            <location filename="../../ui/panels/scene.py" />
            <source>Add a stage behind the others</source>
            <translation>Ajouter une étape après les autres</translation>
        </message>
        <message>
            <location filename="../../ui/panels/scene.py" />
            <source>Then the scene itself: {iterations}.</source>
            <translation>Puis la scène elle-même : {iterations}.</translation>
        </message>
        <message>
            <location filename="../../ui/panels/scene.py" />
            <source>net of {n_u} × {n_v}</source>
            <translation>réseau de {n_u} × {n_v}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/scene.py" />
            <source>{kind} filter</source>
            <translation>filtre : {kind}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/scene.py" />
            <source>process</source>
            <translation>procédé</translation>
        </message>
        <message>
            <location filename="../../ui/panels/scene.py" />
            <source>Process {number}</source>
            <translation>Procédé {number}</translation>
        </message>
        <message>
            <location filename="../../ui/panels/scene.py" />
            <source>None: elements are as designed.</source>
            <translation>Aucun : les éléments sont tels que conçus.</translation>
        </message>
        <message>
            <location filename="../../ui/panels/scene.py" />
            <source>Process</source>
            <translation>Procédé</translation>
        </message>
        <message>
            <location filename="../../ui/panels/scene.py" />
            <source>Add {process} behind the others</source>
            <translation>Ajouter {process} après les autres</translation>
        </message>
        <message>
            <location filename="../../ui/panels/scene.py" />
            <source>Preset…</source>
            <translation>Préréglage…</translation>
        </message>
        <message>
            <location filename="../../ui/panels/scene.py" />
            <source>Choose a process with usual values, whose source is stated</source>
            <translation>Choisir un procédé aux valeurs usuelles, dont la source est indiquée</translation>
        </message>
        <message>
            <location filename="../../ui/panels/scene.py" />
            <source>Preset</source>
            <translation>Préréglage</translation>
        </message>
        <message>
            <location filename="../../ui/panels/scene.py" />
            <source>Process and source</source>
            <translation>Procédé et source</translation>
        </message>
        <message>
            <location filename="../../ui/run/cards.py" />
            <source>findings</source>
            <translation>constats</translation>
        </message>
        <message>
            <location filename="../../ui/run/cards.py" />
            <source>goal</source>
            <translation>objectif</translation>
        </message>
        <message>
            <location filename="../../ui/run/cards.py" />
            <source>Good</source>
            <translation>Bon</translation>
        </message>
        <message>
            <location filename="../../ui/run/cards.py" />
            <source>Needs attention</source>
            <translation>À surveiller</translation>
        </message>
        <message>
            <location filename="../../ui/run/cards.py" />
            <source>Goal missed</source>
            <translation>Objectif manqué</translation>
        </message>
        <message>
            <location filename="../../ui/run/cards.py" />
            <source>Goal</source>
            <translation>Objectif</translation>
        </message>
        <message>
            <location filename="../../ui/run/cards.py" />
            <source>Type a limit, at most {most}; empty the field to remove the goal</source>
            <translation>Saisir une limite, {most} au plus ; un champ vide retire l'objectif</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>F8 checks the design with an independent ray trace.</source>
            <translation>F8 vérifie la conception par un tracé de rayons indépendant.</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>check failed</source>
            <translation>échec de la vérification</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>Two independent methods, beam meshes and random rays, differ by more than their error bounds: one of them is wrong.</source>
            <translation>Deux méthodes indépendantes, maillages de faisceaux et rayons aléatoires, diffèrent de plus que leurs bornes d'erreur : l'une est fausse.</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>no deterministic figure</source>
            <translation>pas de valeur déterministe</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>The error is from random rays alone; the intervals below include their noise.</source>
            <translation>L'erreur provient des seuls rayons aléatoires ; les intervalles ci-dessous incluent leur bruit.</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>optimiser and check</source>
            <translation>optimiseur et vérification</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>Image or efficiency of the optimiser differ from the check by more than the error bounds; the optimiser traces fewer rays.</source>
            <translation>L'image ou le rendement de l'optimiseur diffèrent de la vérification de plus que les bornes d'erreur ; l'optimiseur trace moins de rayons.</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>verified error</source>
            <translation>erreur vérifiée</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>Relative L2 error between image and target, free of ray noise, and the interval that it is in: by a deterministic beam mesh, or by random rays with 95 % confidence. With &lt; where it cannot be told from zero.</source>
            <translation>Erreur L2 relative entre image et cible, sans bruit de rayons, et l'intervalle où elle se trouve : par un maillage de faisceaux déterministe, ou par des rayons aléatoires avec une confiance de 95 %. Avec &lt; si elle ne se distingue pas de zéro.</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>beam mesh</source>
            <translation>maillage de faisceaux</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>Number of beams through the entrance face.</source>
            <translation>Nombre de faisceaux à travers la face d'entrée.</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>error by image pairs</source>
            <translation>erreur par paires d'images</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>The deterministic check would be too slow here; pairs of random images are used. The interval has 95 % confidence.</source>
            <translation>La vérification déterministe serait trop lente ici ; des paires d'images aléatoires sont utilisées. L'intervalle a 95 % de confiance.</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>difference of random rays</source>
            <translation>écart des rayons aléatoires</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>Relative L2 difference between the images of both methods. About one noise level is expected.</source>
            <translation>Différence L2 relative entre les images des deux méthodes. Environ un niveau de bruit est attendu.</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>error by random rays</source>
            <translation>erreur par rayons aléatoires</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>The same error by random rays without their noise, with 95 % confidence: a second opinion.</source>
            <translation>La même erreur par des rayons aléatoires sans leur bruit, avec une confiance de 95 % : un second avis.</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>error with ray noise</source>
            <translation>erreur avec bruit de rayons</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>‖I − T‖ / ‖T‖ of image and target, each divided by its sum, by random rays with their noise, which more rays reduce. The interval is that of 95 % for other rays.</source>
            <translation>‖I − T‖ / ‖T‖ de l'image et de la cible, chacune divisée par sa somme, par des rayons aléatoires avec leur bruit, que plus de rayons réduisent. L'intervalle est celui à 95 % pour d'autres rayons.</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>loss of the paper</source>
            <translation>coût de l'article</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>Norm of the difference between image and target, each divided by its sum, over the root of the number of pixels.</source>
            <translation>La norme de la différence entre image et cible, chacune divisée par sa somme, sur la racine du nombre de pixels.</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>PSNR</source>
            <translation>PSNR</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>Peak signal-to-noise ratio, against the target's peak: more is better.</source>
            <translation>Rapport signal sur bruit de crête, par rapport à la crête de la cible : plus grand est mieux.</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>SSIM</source>
            <translation>SSIM</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>Mean structural similarity in windows of 11 × 11 pixels: 1 for equal images.</source>
            <translation>Similarité structurelle moyenne dans des fenêtres de 11 × 11 pixels : 1 pour des images égales.</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>Pearson's coefficient of image and target over the pixels; 1 for proportional images.</source>
            <translation>Coefficient de Pearson de l'image et de la cible sur les pixels ; 1 pour des images proportionnelles.</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>Least over mean of irradiance / target where the target is at least half its peak; 1 is uniform, 0 has a dark pixel.</source>
            <translation>Minimum sur moyenne de éclairement / cible où la cible atteint au moins la moitié de son maximum ; 1 est uniforme, 0 a un pixel sombre.</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>(lit − black) / (lit + black) of the mean irradiances there; black is up to a hundredth of the target's peak. 1 is a perfect black.</source>
            <translation>(éclairé − noir) / (éclairé + noir) des éclairements moyens ; noir va jusqu'à un centième de la crête de la cible. 1 est un noir parfait.</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>Fraction of the emitted flux in the image.</source>
            <translation>Part du flux émis dans l'image.</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>meets the face again</source>
            <translation>rencontre à nouveau la face</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>Flux that hits its exit face a second time, as in a deep concave face. Image and efficiency ignore this.</source>
            <translation>Flux qui rencontre une seconde fois sa face de sortie, comme dans une face très concave. L'image et le rendement l'ignorent.</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>comes through the screen</source>
            <translation>traverse l'écran</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>Flux that the screen blocks before the mirror. Image and efficiency ignore this; a screen beside the axis does not block it.</source>
            <translation>Flux que l'écran bloque avant le miroir. L'image et le rendement l'ignorent ; un écran à côté de l'axe ne bloque rien.</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>difference to the optimiser</source>
            <translation>écart avec l'optimiseur</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>Relative L2 difference to the image of the optimiser; includes its filter and ray noise.</source>
            <translation>Différence L2 relative à l'image de l'optimiseur ; inclut son filtre et le bruit des rayons.</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>Rays of the image; a quarter more are traced for the error without noise.</source>
            <translation>Rayons de l'image ; un quart de plus est tracé pour l'erreur sans bruit.</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>correlation</source>
            <translation>corrélation</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>uniformity</source>
            <translation>uniformité</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>contrast</source>
            <translation>contraste</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>efficiency</source>
            <translation>rendement</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>rays</source>
            <translation>rayons</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>Relative L2 error as designed, and after each process of manufacture and those before it; the last one is that of the finished part.</source>
            <translation>Erreur L2 relative telle que conçue, puis après chaque procédé de fabrication et ceux qui le précèdent ; la dernière est celle de la pièce finie.</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>Fraction of the emitted flux on the area, and its light pixel by pixel. U₀ is minimum / average, U₁ minimum / maximum; 1 is uniform.</source>
            <translation>Part du flux émis sur la zone, et sa lumière pixel par pixel. U₀ est minimum / moyenne, U₁ minimum / maximum ; 1 est uniforme.</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>Figures of the check</source>
            <translation>Chiffres de la vérification</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>Copy</source>
            <translation>Copier</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>Rays of a check; four times as many halve the noise</source>
            <translation>Rayons d'une vérification ; quatre fois plus divisent le bruit par deux</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>Rays of a check</source>
            <translation>Rayons d'une vérification</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>Copy all figures to the clipboard, tab-separated</source>
            <translation>Copier tous les chiffres dans le presse-papiers, séparés par des tabulations</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>{rays} million rays</source>
            <translation>{rays} millions de rayons</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>image {number}: {name}</source>
            <translation>image {number} : {name}</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>Outdated figures: the design has changed.</source>
            <translation>Valeurs obsolètes : la conception a changé.</translation>
        </message>
        <message>
            <location filename="../../ui/run/check_figures.py" />
            <source>Checking…</source>
            <translation>Vérification en cours…</translation>
        </message>
        <message>
            <location filename="../../ui/run/checks.py" />
            <source>check</source>
            <translation>vérification</translation>
        </message>
        <message>
            <location filename="../../ui/run/checks.py" />
            <source>The image is still being computed. Try again in a moment.</source>
            <translation>L'image est en cours de calcul. Réessayez dans un instant.</translation>
        </message>
        <message>
            <location filename="../../ui/run/checks.py" />
            <source>Check with {rays:,} rays: relative L2 error {verified} ({low:.2f} to {high:.2f} %); with ray noise {relative_l2:.2f} ± {noise:.2f} %, loss {loss}; {efficiency:.1f} % {place}</source>
            <translation>Vérification avec {rays:,} rayons : erreur L2 relative {verified} ({low:.2f} à {high:.2f} %) ; avec le bruit des rayons {relative_l2:.2f} ± {noise:.2f} %, perte {loss} ; {efficiency:.1f} % {place}</translation>
        </message>
        <message>
            <location filename="../../ui/run/checks.py" />
            <source>check of the result</source>
            <translation>vérification du résultat</translation>
        </message>
        <message>
            <location filename="../../ui/run/checks.py" />
            <source>Check of the result</source>
            <translation>Vérification du résultat</translation>
        </message>
        <message>
            <location filename="../../ui/run/checks.py" />
            <source>bound</source>
            <translation>borne</translation>
        </message>
        <message>
            <location filename="../../ui/run/checks.py" />
            <source>Certified lower bound of the relative L2 error: {bound}; {error} with a source of half the width. Details: freeform bound.</source>
            <translation>Borne inférieure certifiée de l'erreur L2 relative : {bound} ; {error} avec une source de demi-largeur. Détails : freeform bound.</translation>
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
            <source>Point at an image to read its irradiance</source>
            <translation>Pointez une image pour lire son éclairement</translation>
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
            <source>Choose the image to compare</source>
            <translation>Choisir l'image à comparer</translation>
        </message>
        <message>
            <location filename="../../ui/run/comparison.py" />
            <source>Value under the pointer</source>
            <translation>Valeur sous le pointeur</translation>
        </message>
        <message>
            <location filename="../../ui/run/comparison.py" />
            <source>Irradiance of both runs</source>
            <translation>Éclairement des deux exécutions</translation>
        </message>
        <message>
            <location filename="../../ui/run/comparison.py" />
            <source>Figures of both runs</source>
            <translation>Chiffres des deux exécutions</translation>
        </message>
        <message>
            <location filename="../../ui/run/control.py" />
            <source>run</source>
            <translation>exécution</translation>
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
            <location filename="../../ui/run/control.py" />
            <source>There is no result yet, or it is still being computed. Try again in a moment.</source>
            <translation>Il n'y a pas encore de résultat, ou il est en cours de calcul. Réessayez dans un instant.</translation>
        </message>
        <message>
            <location filename="../../ui/run/control.py" />
            <source>the best lens so far, after {count} iterations</source>
            <translation>la meilleure lentille jusqu'ici, après {count} itérations</translation>
        </message>
        <message>
            <location filename="../../ui/run/control.py" />
            <source>the best mirror so far, after {count} iterations</source>
            <translation>le meilleur miroir jusqu'ici, après {count} itérations</translation>
        </message>
        <message>
            <location filename="../../ui/run/control.py" />
            <source>this lens, {origin}</source>
            <translation>cette lentille, {origin}</translation>
        </message>
        <message>
            <location filename="../../ui/run/control.py" />
            <source>this mirror, {origin}</source>
            <translation>ce miroir, {origin}</translation>
        </message>
        <message>
            <location filename="../../ui/run/follow.py" />
            <source>Updating the lens</source>
            <translation>Mise à jour de la lentille</translation>
        </message>
        <message>
            <location filename="../../ui/run/follow.py" />
            <source>Updating the mirror</source>
            <translation>Mise à jour du miroir</translation>
        </message>
        <message>
            <location filename="../../ui/run/follow.py" />
            <source>Updating the lens: slow task, edits are applied after a pause</source>
            <translation>Mise à jour de la lentille : tâche lente, les modifications s'appliquent après une pause</translation>
        </message>
        <message>
            <location filename="../../ui/run/follow.py" />
            <source>Updating the mirror: slow task, edits are applied after a pause</source>
            <translation>Mise à jour du miroir : tâche lente, les modifications s'appliquent après une pause</translation>
        </message>
        <message>
            <location filename="../../ui/run/follow.py" />
            <source>live update</source>
            <translation>mise à jour en direct</translation>
        </message>
        <message>
            <location filename="../../ui/run/follow.py" />
            <source>design of the missing lens</source>
            <translation>conception de la lentille manquante</translation>
        </message>
        <message>
            <location filename="../../ui/run/follow.py" />
            <source>design of the missing mirror</source>
            <translation>conception du miroir manquant</translation>
        </message>
        <message>
            <location filename="../../ui/run/kept_runs.py" />
            <source>Run {number}: {description}</source>
            <translation>Exécution {number} : {description}</translation>
        </message>
        <message>
            <location filename="../../ui/run/kept_runs.py" />
            <source>Live update {number}: {description}</source>
            <translation>Mise à jour {number} : {description}</translation>
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
            <source>Stop requested</source>
            <translation>Arrêt demandé</translation>
        </message>
        <message>
            <location filename="../../ui/run/log.py" />
            <source>{name} was removed: memory limit of kept runs</source>
            <translation>{name} a été supprimé : limite de mémoire des exécutions</translation>
        </message>
        <message>
            <location filename="../../ui/run/log.py" />
            <source>Run started: {name}, method {method}</source>
            <translation>Exécution démarrée : {name}, méthode {method}</translation>
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
            <source>Run ended without a lens</source>
            <translation>Exécution terminée sans lentille</translation>
        </message>
        <message>
            <location filename="../../ui/run/log.py" />
            <source>Run ended without a mirror</source>
            <translation>Exécution terminée sans miroir</translation>
        </message>
        <message>
            <location filename="../../ui/run/log.py" />
            <source>Run ended{why} after iteration {iteration} of {iterations}, {clock}: last loss {loss}, {efficiency:.1f} % {place}</source>
            <translation>Exécution terminée{why} après l'itération {iteration} sur {iterations}, {clock} : dernier coût {loss}, {efficiency:.1f} % {place}</translation>
        </message>
        <message>
            <location filename="../../ui/run/runs.py" />
            <source>Select two runs in View &gt; Runs first (Ctrl+click).</source>
            <translation>Choisissez d'abord deux exécutions dans Affichage &gt; Exécutions (Ctrl+clic).</translation>
        </message>
        <message>
            <location filename="../../ui/run/runs.py" />
            <source>Select a run in View &gt; Runs first.</source>
            <translation>Choisir d'abord une exécution dans Affichage &gt; Exécutions.</translation>
        </message>
        <message>
            <location filename="../../ui/run/runs.py" />
            <source>return to {name}</source>
            <translation>retour à {name}</translation>
        </message>
        <message>
            <location filename="../../ui/run/runs.py" />
            <source>Select runs in View &gt; Runs first.</source>
            <translation>Choisir d'abord des exécutions dans Affichage &gt; Exécutions.</translation>
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
            <location filename="../../ui/run/runs.py" />
            <source>rename run</source>
            <translation>renommer l'exécution</translation>
        </message>
        <message>
            <location filename="../../ui/run/runs.py" />
            <source>The run was not renamed; it is still {name}: {reason}</source>
            <translation>L'exécution s'appelle toujours {name} : {reason}</translation>
        </message>
        <message>
            <location filename="../../ui/run/status.py" />
            <source>iteration {done} of {count}{rate}</source>
            <translation>itération {done} sur {count}{rate}</translation>
        </message>
        <message>
            <location filename="../../ui/run/status.py" />
            <source>at most {time} left</source>
            <translation>au plus {time} restant</translation>
        </message>
        <message>
            <location filename="../../ui/run/status.py" />
            <source>Progress of the design</source>
            <translation>Avancement de la conception</translation>
        </message>
        <message>
            <location filename="../../ui/run/status.py" />
            <source>Finished iterations, and the current rate</source>
            <translation>Itérations terminées et rythme actuel</translation>
        </message>
        <message>
            <location filename="../../ui/run/status.py" />
            <source>Remaining time at the current rate; the automatic method ends sooner without further gain</source>
            <translation>Temps restant au rythme actuel ; la méthode automatique s'arrête plus tôt sans gain</translation>
        </message>
        <message>
            <location filename="../../ui/run/status.py" />
            <source>{time} left</source>
            <translation>{time} restant</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Finished runs are listed here, to compare and restore them.</source>
            <translation>Les exécutions terminées sont listées ici, pour les comparer et les rétablir.</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Name</source>
            <translation>Nom</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Name and image of the run; tick it to plot its loss beside that of this run</source>
            <translation>Nom et image de l'exécution ; cochez pour tracer sa perte à côté de celle de cette exécution</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Target image: file or built-in shape</source>
            <translation>Image cible : fichier ou forme intégrée</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Error</source>
            <translation>Erreur</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Relative L2 error of the best result, as the optimiser computes it</source>
            <translation>Erreur L2 relative du meilleur résultat, calculée par l'optimiseur</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Verified</source>
            <translation>Vérifié</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Relative L2 error of the result, by the independent check</source>
            <translation>Erreur L2 relative du résultat, par la vérification indépendante</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>On screen</source>
            <translation>Sur l'écran</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Fraction of the flux on the receiver</source>
            <translation>Part du flux sur le récepteur</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Time</source>
            <translation>Durée</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Run time</source>
            <translation>Durée d'exécution</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Iterations, including those of continued runs</source>
            <translation>Itérations, y compris celles des exécutions poursuivies</translation>
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
            <source>Design method</source>
            <translation>Méthode de conception</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Loss of the best result</source>
            <translation>Perte du meilleur résultat</translation>
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
            <source>Compare irradiance, figures and fields of two selected runs</source>
            <translation>Comparer éclairement, chiffres et champs de deux exécutions choisies</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Restore</source>
            <translation>Restaurer</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Restore task and result of this run</source>
            <translation>Rétablir la tâche et le résultat de cette exécution</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Delete the selected runs</source>
            <translation>Supprimer les exécutions choisies</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Compare</source>
            <translation>Comparer</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>Run of the current lens</source>
            <translation>Exécution de la lentille actuelle</translation>
        </message>
        <message>
            <location filename="../../ui/run/table.py" />
            <source>A name has at most {count} characters</source>
            <translation>Un nom a au plus {count} caractères</translation>
        </message>
        <message>
            <location filename="../../ui/unexpected_errors.py" />
            <source>Unexpected error: {error}. Save your work.</source>
            <translation>Erreur inattendue : {error}. Enregistrez votre travail.</translation>
        </message>
        <message>
            <location filename="../../ui/views/choices.py" />
            <source>Choose the image to show</source>
            <translation>Choisir l'image à afficher</translation>
        </message>
        <message>
            <location filename="../../ui/views/choices.py" />
            <source>Face</source>
            <translation>Face</translation>
        </message>
        <message>
            <location filename="../../ui/views/choices.py" />
            <source>Choose the freeform face</source>
            <translation>Choisir la face de forme libre</translation>
        </message>
        <message>
            <location filename="../../ui/views/derivative_view.py" />
            <source>derivative map</source>
            <translation>carte de dérivées</translation>
        </message>
        <message>
            <location filename="../../ui/views/derivative_view.py" />
            <source>Control point along {axis}</source>
            <translation>Point de contrôle selon {axis}</translation>
        </message>
        <message>
            <location filename="../../ui/views/derivative_view.py" />
            <source>Number of the control point along {axis}, counted from 0</source>
            <translation>Numéro du point de contrôle selon {axis}, compté à partir de 0</translation>
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
            <location filename="../../ui/views/focus_view.py" />
            <source>trace through focus</source>
            <translation>série focale</translation>
        </message>
        <message>
            <location filename="../../ui/views/focus_view.py" />
            <source>Relative L2 error against the distance; the dotted line is the screen</source>
            <translation>Erreur L2 relative selon la distance ; la ligne pointillée est l'écran</translation>
        </message>
        <message>
            <location filename="../../ui/views/focus_view.py" />
            <source>A far field has no distance to vary.</source>
            <translation>Un champ lointain n'a pas de distance à varier.</translation>
        </message>
        <message>
            <location filename="../../ui/views/focus_view.py" />
            <source>Show the irradiance at 0.5 to 1.5 times the distance of the screen; the scene is unchanged</source>
            <translation>Montrer l'éclairement à 0,5 à 1,5 fois la distance de l'écran ; la scène est inchangée</translation>
        </message>
        <message>
            <location filename="../../ui/views/focus_view.py" />
            <source>Distance of the screen</source>
            <translation>Distance de l'écran</translation>
        </message>
        <message>
            <location filename="../../ui/views/focus_view.py" />
            <source>Return to the distance of the screen</source>
            <translation>Revenir à la distance de l'écran</translation>
        </message>
        <message>
            <location filename="../../ui/views/focus_view.py" />
            <source>At screen</source>
            <translation>À l'écran</translation>
        </message>
        <message>
            <location filename="../../ui/views/focus_view.py" />
            <source>Curve</source>
            <translation>Courbe</translation>
        </message>
        <message>
            <location filename="../../ui/views/focus_view.py" />
            <source>Plot the error against the distance</source>
            <translation>Tracer l'erreur en fonction de la distance</translation>
        </message>
        <message>
            <location filename="../../ui/views/focus_view.py" />
            <source>tracing…</source>
            <translation>tracé…</translation>
        </message>
        <message>
            <location filename="../../ui/views/focus_view.py" />
            <source>computed when the design rests…</source>
            <translation>calculé quand la conception est au repos…</translation>
        </message>
        <message>
            <location filename="../../ui/views/focus_view.py" />
            <source>no flux arrives there</source>
            <translation>aucun flux n'y arrive</translation>
        </message>
        <message>
            <location filename="../../ui/views/focus_view.py" />
            <source>screen</source>
            <translation>écran</translation>
        </message>
        <message>
            <location filename="../../ui/views/focus_view.py" />
            <source>Computed when the design rests.</source>
            <translation>Calculé quand la conception est au repos.</translation>
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
            <location filename="../../ui/views/image_view.py" />
            <source>outside the lens</source>
            <translation>à côté de la lentille</translation>
        </message>
        <message>
            <location filename="../../ui/views/image_view.py" />
            <source>outside the mirror</source>
            <translation>à côté du miroir</translation>
        </message>
        <message>
            <location filename="../../ui/views/image_view.py" />
            <source>{value} at {x}, {y}</source>
            <translation>{value} à {x}, {y}</translation>
        </message>
        <message>
            <location filename="../../ui/views/light_images.py" />
            <source>Draw a line</source>
            <translation>Tracer une ligne</translation>
        </message>
        <message>
            <location filename="../../ui/views/light_images.py" />
            <source>Drag across an image to draw the line of a cross-section; or use Shift and drag</source>
            <translation>Glissez sur une image pour tracer la ligne d'une coupe ; ou Maj et glisser</translation>
        </message>
        <message>
            <location filename="../../ui/views/light_images.py" />
            <source>Logarithmic colours</source>
            <translation>Couleurs logarithmiques</translation>
        </message>
        <message>
            <location filename="../../ui/views/light_images.py" />
            <source>Logarithmic colours over three decades, to see stray light</source>
            <translation>Couleurs logarithmiques sur trois décades, pour voir la lumière parasite</translation>
        </message>
        <message>
            <location filename="../../ui/views/light_images.py" />
            <source>Contours</source>
            <translation>Lignes de niveau</translation>
        </message>
        <message>
            <location filename="../../ui/views/light_images.py" />
            <source>Lines of equal light, with their values</source>
            <translation>Lignes d'égale lumière, avec leurs valeurs</translation>
        </message>
        <message>
            <location filename="../../ui/views/light_images.py" />
            <source>Pin this image</source>
            <translation>Épingler cette image</translation>
        </message>
        <message>
            <location filename="../../ui/views/light_images.py" />
            <source>Pin this image to compare others with it; again to remove it</source>
            <translation>Épingler cette image pour lui comparer d'autres ; de nouveau pour la retirer</translation>
        </message>
        <message>
            <location filename="../../ui/views/light_images.py" />
            <source>Nothing is pinned. The pin below the image of light pins it.</source>
            <translation>Rien n'est épinglé. L'épingle sous l'image de lumière l'épingle.</translation>
        </message>
        <message>
            <location filename="../../ui/views/light_images.py" />
            <source>Pinned at iteration {count}, error {error}</source>
            <translation>Épinglée à l'itération {count}, erreur {error}</translation>
        </message>
        <message>
            <location filename="../../ui/views/light_images.py" />
            <source>The target, scaled to the flux that arrives: where the irradiance is right, both have the same colour. The light account shows where lost light goes.</source>
            <translation>La cible, mise à l'échelle du flux qui arrive : où l'éclairement est juste, les deux ont la même couleur. Le bilan de lumière montre où va la lumière perdue.</translation>
        </message>
        <message>
            <location filename="../../ui/views/light_view.py" />
            <source>All parts</source>
            <translation>Toutes les parts</translation>
        </message>
        <message>
            <location filename="../../ui/views/light_view.py" />
            <source>Sum of all parts; 100 % when the account is complete.</source>
            <translation>Somme de toutes les parts ; 100 % si le bilan est complet.</translation>
        </message>
        <message>
            <location filename="../../ui/views/loss_strip.py" />
            <source>Iteration of the run</source>
            <translation>Itération de l'exécution</translation>
        </message>
        <message>
            <location filename="../../ui/views/loss_strip.py" />
            <source>Iteration {number}: loss {loss}</source>
            <translation>Itération {number} : coût {loss}</translation>
        </message>
        <message>
            <location filename="../../ui/views/loss_strip.py" />
            <source>The loss of a run is plotted here. Run &gt; Start starts a run.</source>
            <translation>La perte d'une exécution est tracée ici. Exécution &gt; Démarrer en lance une.</translation>
        </message>
        <message>
            <location filename="../../ui/views/loss_strip.py" />
            <source>Loss that the optimiser minimises</source>
            <translation>Perte que l'optimiseur minimise</translation>
        </message>
        <message>
            <location filename="../../ui/views/loss_strip.py" />
            <source>Loss {loss}</source>
            <translation>Coût {loss}</translation>
        </message>
        <message>
            <location filename="../../ui/views/loss_strip.py" />
            <source>Restore the design of this iteration and continue from it; Undo restores the later one</source>
            <translation>Rétablir la conception de cette itération et continuer ; Annuler rétablit la suivante</translation>
        </message>
        <message>
            <location filename="../../ui/views/loss_strip.py" />
            <source>Continue from here</source>
            <translation>Continuer d'ici</translation>
        </message>
        <message>
            <location filename="../../ui/views/loss_strip.py" />
            <source>Drag along the curve, or press arrows on it, to show an earlier iteration</source>
            <translation>Glisser le long de la courbe, ou y presser les flèches, pour montrer une itération antérieure</translation>
        </message>
        <message>
            <location filename="../../ui/views/loss_strip.py" />
            <source>iteration {number}</source>
            <translation>itération {number}</translation>
        </message>
        <message>
            <location filename="../../ui/views/photo_view.py" />
            <source>There is no lens yet. Start designs one.</source>
            <translation>Il n'y a pas encore de lentille : Démarrer en conçoit une.</translation>
        </message>
        <message>
            <location filename="../../ui/views/photo_view.py" />
            <source>The photo is predicted when the design rests.</source>
            <translation>La photo est prédite quand la conception est au repos.</translation>
        </message>
        <message>
            <location filename="../../ui/views/photo_view.py" />
            <source>photo prediction</source>
            <translation>prédiction de la photo</translation>
        </message>
        <message>
            <location filename="../../ui/views/photo_view.py" />
            <source>Predicting… {part:.0f} %</source>
            <translation>Prédiction… {part:.0f} %</translation>
        </message>
        <message>
            <location filename="../../ui/views/photo_view.py" />
            <source>State of the photo</source>
            <translation>État de la photo</translation>
        </message>
        <message>
            <location filename="../../ui/views/photo_view.py" />
            <source>Light of the photo: that of the source (daylight for collimated light, a laser for a Gaussian beam, otherwise an LED), or another one</source>
            <translation>Lumière de la photo : celle de la source (lumière du jour si collimatée, laser si faisceau gaussien, sinon LED), ou une autre</translation>
        </message>
        <message>
            <location filename="../../ui/views/photo_view.py" />
            <source>Light of the source</source>
            <translation>Lumière de la source</translation>
        </message>
        <message>
            <location filename="../../ui/views/photo_view.py" />
            <source>Light of the photo</source>
            <translation>Lumière de la photo</translation>
        </message>
        <message>
            <location filename="../../ui/views/photo_view.py" />
            <source>Exposure in stops; each stop doubles the brightness</source>
            <translation>Exposition en diaphragmes ; chacun double la luminosité</translation>
        </message>
        <message>
            <location filename="../../ui/views/photo_view.py" />
            <source>Exposure</source>
            <translation>Exposition</translation>
        </message>
        <message>
            <location filename="../../ui/views/photo_view.py" />
            <source>{number} stops</source>
            <translation>{number} IL</translation>
        </message>
        <message>
            <location filename="../../ui/views/photo_view.py" />
            <source>Default exposure: the target's brightest pixel is white</source>
            <translation>Exposition par défaut : le pixel le plus clair de la cible est blanc</translation>
        </message>
        <message>
            <location filename="../../ui/views/photo_view.py" />
            <source>Default exposure</source>
            <translation>Exposition par défaut</translation>
        </message>
        <message>
            <location filename="../../ui/views/photo_view.py" />
            <source>Outdated. </source>
            <translation>Obsolète. </translation>
        </message>
        <message>
            <location filename="../../ui/views/plot_view.py" />
            <source>The image is being computed.</source>
            <translation>L'image est en cours de calcul.</translation>
        </message>
        <message>
            <location filename="../../ui/views/plot_view.py" />
            <source>Too little space for a plot.</source>
            <translation>Trop peu de place pour un graphique.</translation>
        </message>
        <message>
            <location filename="../../ui/views/plot_view.py" />
            <source>There is no image: this design cannot be traced.</source>
            <translation>Il n'y a pas d'image : cette conception ne peut pas être tracée.</translation>
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
            <location filename="../../ui/views/scene_contents.py" />
            <source>within limits | exceeded</source>
            <translation>respectées | dépassées</translation>
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
            <source>Cross-section along x or y through the point clicked in an image,
or along a line drawn with Shift and drag.
Arrow keys move the point or line by a pixel, with Shift by ten; with Ctrl the end of the line</source>
            <translation>Coupe selon x ou y par le point cliqué dans une image,
ou selon une ligne tracée avec Maj et glisser.
Les flèches déplacent le point ou la ligne d'un pixel, avec Maj de dix ; avec Ctrl le bout de la ligne</translation>
        </message>
        <message>
            <location filename="../../ui/views/section_view.py" />
            <source>Along</source>
            <translation>Selon</translation>
        </message>
        <message>
            <location filename="../../ui/views/section_view.py" />
            <source>From {start} to {end} {unit}.
{tip}</source>
            <translation>De {start} à {end} {unit}.
{tip}</translation>
        </message>
        <message>
            <location filename="../../ui/views/surface_view.py" />
            <source>What the map shows</source>
            <translation>Ce que montre la carte</translation>
        </message>
        <message>
            <location filename="../../ui/widgets/figures.py" />
            <source>× mean</source>
            <translation>× moyenne</translation>
        </message>
        <message>
            <location filename="../../ui/widgets/figures.py" />
            <source>{axis} at {place}</source>
            <translation>{axis} à {place}</translation>
        </message>
        <message>
            <location filename="../../ui/widgets/labels.py" />
            <source>Outdated: the design has changed</source>
            <translation>Obsolète : la conception a changé</translation>
        </message>
        <message>
            <location filename="../../ui/widgets/messages.py" />
            <source>Close this message</source>
            <translation>Fermer ce message</translation>
        </message>
        <message>
            <location filename="../../ui/widgets/messages.py" />
            <source>Messages of runs, checks and exports appear here.</source>
            <translation>Les messages des exécutions, vérifications et exports apparaissent ici.</translation>
        </message>
        <message>
            <location filename="../../ui/widgets/shelf.py" />
            <source>Progress of {task}</source>
            <translation>Avancement : {task}</translation>
        </message>
        <message>
            <location filename="../../ui/widgets/shelf.py" />
            <source>Ends soon…</source>
            <translation>Se termine…</translation>
        </message>
        <message>
            <location filename="../../ui/widgets/shelf.py" />
            <source>Checks, exports, reports and sweeps in the background</source>
            <translation>Vérifications, exportations, rapports et séries en arrière-plan</translation>
        </message>
        <message>
            <location filename="../../ui/widgets/shelf.py" />
            <source>Progress of the tasks</source>
            <translation>Avancement des tâches</translation>
        </message>
        <message>
            <location filename="../../ui/widgets/shelf.py" />
            <source>Tasks</source>
            <translation>Tâches</translation>
        </message>
        <message>
            <location filename="../../ui/widgets/shelf.py" />
            <source>No tasks. Checks, exports, reports and sweeps appear here.</source>
            <translation>Aucune tâche. Vérifications, exportations, rapports et séries apparaissent ici.</translation>
        </message>
        <message>
            <location filename="../../ui/widgets/shelf.py" />
            <source>Tasks ({count})</source>
            <translation>Tâches ({count})</translation>
        </message>
        <message>
            <location filename="../../ui/window/docks.py" />
            <source>As opened</source>
            <translation>Comme ouvert</translation>
        </message>
        <message>
            <location filename="../../ui/window/docks.py" />
            <source>Click a step to restore it</source>
            <translation>Cliquez une étape pour la rétablir</translation>
        </message>
        <message>
            <location filename="../../ui/window/docks.py" />
            <source>Loading…</source>
            <translation>Chargement…</translation>
        </message>
        <message>
            <location filename="../../ui/window/docks.py" />
            <source>The run waits for the compilation of its kernels (once after installation, half a minute)</source>
            <translation>L'exécution attend la compilation de ses noyaux (une fois après l'installation, une demi-minute)</translation>
        </message>
        <message>
            <location filename="../../ui/window/edit_notices.py" />
            <source>The lens does not fit the new outline. Start designs another one; Undo restores it.</source>
            <translation>La lentille ne convient pas au nouveau contour. Démarrer en conçoit une autre ; Annuler la rétablit.</translation>
        </message>
        <message>
            <location filename="../../ui/window/edit_notices.py" />
            <source>The mirror does not fit the new outline. Start designs another one; Undo restores it.</source>
            <translation>Le miroir ne convient pas au nouveau contour. Démarrer en conçoit un autre ; Annuler le rétablit.</translation>
        </message>
        <message>
            <location filename="../../ui/window/edit_notices.py" />
            <source>The entrance face is freeform now, and still flat. Continue shapes both faces; Undo reverts.</source>
            <translation>La face d'entrée est maintenant de forme libre, encore plane. Continuer façonne les deux faces ; Annuler y revient.</translation>
        </message>
        <message>
            <location filename="../../ui/window/edit_notices.py" />
            <source>The entrance face is flat now; the exit face is unchanged. Continue reshapes the exit face; Undo reverts.</source>
            <translation>La face d'entrée est maintenant plane ; la face de sortie est inchangée. Continuer refaçonne la face de sortie ; Annuler y revient.</translation>
        </message>
        <message>
            <location filename="../../ui/window/edit_notices.py" />
            <source>The lens was moved by up to {moved} to keep the new limits. Continue improves it; Undo reverts.</source>
            <translation>La lentille a été modifiée de {moved} au plus pour respecter les nouvelles limites. Continuer l'améliore ; Annuler y revient.</translation>
        </message>
        <message>
            <location filename="../../ui/window/edit_notices.py" />
            <source>The mirror was moved by up to {moved} to keep the new limits. Continue improves it; Undo reverts.</source>
            <translation>Le miroir a été modifié de {moved} au plus pour respecter les nouvelles limites. Continuer l'améliore ; Annuler y revient.</translation>
        </message>
        <message>
            <location filename="../../ui/window/edit_notices.py" />
            <source>The net now has {size} control points; the lens was transferred to it. Continue improves it; Undo reverts.</source>
            <translation>Le réseau a maintenant {size} points de contrôle ; la lentille y a été transférée. Continuer l'améliore ; Annuler y revient.</translation>
        </message>
        <message>
            <location filename="../../ui/window/edit_notices.py" />
            <source>The net now has {size} control points; the mirror was transferred to it. Continue improves it; Undo reverts.</source>
            <translation>Le réseau a maintenant {size} points de contrôle ; le miroir y a été transféré. Continuer l'améliore ; Annuler y revient.</translation>
        </message>
        <message>
            <location filename="../../ui/window/edit_notices.py" />
            <source>The lens was designed for another task. Continue starts from it; Start over does not</source>
            <translation>La lentille a été conçue pour une autre tâche. Continuer part d'elle ; Recommencer non</translation>
        </message>
        <message>
            <location filename="../../ui/window/edit_notices.py" />
            <source>The mirror was designed for another task. Continue starts from it; Start over does not</source>
            <translation>Le miroir a été conçu pour une autre tâche. Continuer part de lui ; Recommencer non</translation>
        </message>
        <message>
            <location filename="../../ui/window/edit_notices.py" />
            <source>Not possible during a run. Stop it first</source>
            <translation>Impossible pendant une exécution. Arrêtez-la d'abord</translation>
        </message>
        <message>
            <location filename="../../ui/window/edit_notices.py" />
            <source> ({count} more refused)</source>
            <translation> ({count} autres refusés)</translation>
        </message>
        <message>
            <location filename="../../ui/window/edit_notices.py" />
            <source>{first}{others}. Correct it, or press Esc.</source>
            <translation>{first}{others}. Corrigez, ou appuyez sur Échap.</translation>
        </message>
        <message>
            <location filename="../../ui/window/edit_notices.py" />
            <source>Stop and apply</source>
            <translation>Arrêter et appliquer</translation>
        </message>
        <message>
            <location filename="../../ui/window/edit_notices.py" />
            <source>Discard</source>
            <translation>Abandonner</translation>
        </message>
        <message>
            <location filename="../../ui/window/edit_notices.py" />
            <source>{name} is unchanged on {size} control points.</source>
            <translation>{name} est inchangé(e) sur {size} points de contrôle.</translation>
        </message>
        <message>
            <location filename="../../ui/window/edit_notices.py" />
            <source>Use {size}, exact</source>
            <translation>Utiliser {size}, exact</translation>
        </message>
        <message>
            <location filename="../../ui/window/edit_notices.py" />
            <source>{name} is approximated on {size} control points: deviation up to {off}. Continue improves it; Undo reverts.</source>
            <translation>{name} est approché(e) sur {size} points de contrôle : écart jusqu'à {off}. Continuer améliore ; Annuler y revient.</translation>
        </message>
        <message>
            <location filename="../../ui/window/edit_notices.py" />
            <source>control points</source>
            <translation>points de contrôle</translation>
        </message>
        <message>
            <location filename="../../ui/window/edit_notices.py" />
            <source>The lens</source>
            <translation>La lentille</translation>
        </message>
        <message>
            <location filename="../../ui/window/edit_notices.py" />
            <source>The mirror</source>
            <translation>Le miroir</translation>
        </message>
        <message>
            <location filename="../../ui/window/edit_notices.py" />
            <source>The entrance face</source>
            <translation>La face d'entrée</translation>
        </message>
        <message>
            <location filename="../../ui/window/edit_notices.py" />
            <source>{image} has changed on disk. The design keeps the earlier picture.</source>
            <translation>{image} a changé sur le disque. La conception garde l'image précédente.</translation>
        </message>
        <message>
            <location filename="../../ui/window/edit_notices.py" />
            <source>Reload</source>
            <translation>Recharger</translation>
        </message>
        <message>
            <location filename="../../ui/window/edit_notices.py" />
            <source>All lengths were converted: 1 {old} = {ratio:.6g} {new}.</source>
            <translation>Toutes les longueurs ont été converties : 1 {old} = {ratio:.6g} {new}.</translation>
        </message>
        <message>
            <location filename="../../ui/window/edit_notices.py" />
            <source>Keep the numbers</source>
            <translation>Garder les nombres</translation>
        </message>
        <message>
            <location filename="../../ui/window/edit_notices.py" />
            <source>change of unit alone</source>
            <translation>changement d'unité seul</translation>
        </message>
        <message>
            <location filename="../../ui/window/image_panel.py" />
            <source>Show a second image; drag the handle between them, or press arrows on it</source>
            <translation>Montrer une seconde image ; faire glisser la poignée entre les deux, ou la déplacer par les flèches</translation>
        </message>
        <message>
            <location filename="../../ui/window/image_panel.py" />
            <source>More images</source>
            <translation>Autres images</translation>
        </message>
        <message>
            <location filename="../../ui/window/image_panel.py" />
            <source>Compare: {image}</source>
            <translation>Comparer : {image}</translation>
        </message>
        <message>
            <location filename="../../ui/window/image_panel.py" />
            <source>Image</source>
            <translation>Image</translation>
        </message>
        <message>
            <location filename="../../ui/window/image_panel.py" />
            <source>Handle between two images</source>
            <translation>Poignée entre deux images</translation>
        </message>
        <message>
            <location filename="../../ui/window/layouts.py" />
            <source>Save layout</source>
            <translation>Enregistrer la disposition</translation>
        </message>
        <message>
            <location filename="../../ui/window/layouts.py" />
            <source>Name; an existing one is replaced</source>
            <translation>Nom ; un nom existant est remplacé</translation>
        </message>
        <message>
            <location filename="../../ui/window/layouts.py" />
            <source>Delete layout</source>
            <translation>Supprimer une disposition</translation>
        </message>
        <message>
            <location filename="../../ui/window/layouts.py" />
            <source>Layout</source>
            <translation>Disposition</translation>
        </message>
        <message>
            <location filename="../../ui/window/loaded_parts.py" />
            <source>Stop the run first, then mark regions.</source>
            <translation>Arrêtez d'abord le calcul, puis marquez les régions.</translation>
        </message>
        <message>
            <location filename="../../ui/window/loaded_parts.py" />
            <source>Edit {part} in the form</source>
            <translation>Modifier {part} dans le formulaire</translation>
        </message>
        <message>
            <location filename="../../ui/window/loaded_parts.py" />
            <source>Cancel &amp;check</source>
            <translation>Annu&amp;ler la vérification</translation>
        </message>
        <message>
            <location filename="../../ui/window/window_state.py" />
            <source>There is only one freeform face; Freeform entrance face adds a second one</source>
            <translation>Il y a une face de forme libre : « Face d'entrée de forme libre » en donne une seconde à une lentille</translation>
        </message>
        <message>
            <location filename="../../ui/window/window_state.py" />
            <source>Flat &amp;entrance face</source>
            <translation>Face d'entrée &amp;plane</translation>
        </message>
        <message>
            <location filename="../../ui/window/window_state.py" />
            <source>Freeform &amp;entrance face</source>
            <translation>Face d'entrée d&amp;e forme libre</translation>
        </message>
        <message>
            <location filename="../../ui/window/window_state.py" />
            <source>&amp;Start over</source>
            <translation>Reco&amp;mmencer</translation>
        </message>
        <message>
            <location filename="../../ui/window/window_state.py" />
            <source>&amp;Resume</source>
            <translation>R&amp;eprendre</translation>
        </message>
        <message>
            <location filename="../../ui/window/window_state.py" />
            <source>There is no lens yet; Start designs one</source>
            <translation>Il n'y a pas encore de lentille : Démarrer en conçoit une</translation>
        </message>
        <message>
            <location filename="../../ui/window/window_state.py" />
            <source>There is no mirror yet; Start designs one</source>
            <translation>Il n'y a pas encore de miroir : Démarrer en conçoit un</translation>
        </message>
        <message>
            <location filename="../../ui/window/window_state.py" />
            <source>the best lens so far</source>
            <translation>la meilleure lentille jusqu'ici</translation>
        </message>
        <message>
            <location filename="../../ui/window/window_state.py" />
            <source>the best mirror so far</source>
            <translation>le meilleur miroir jusqu'ici</translation>
        </message>
        <message>
            <location filename="../../ui/window/window_state.py" />
            <source>Uses {lens}</source>
            <translation>Utilise : {lens}</translation>
        </message>
        <message>
            <location filename="../../ui/window/window_state.py" />
            <source>A lens has one freeform face</source>
            <translation>Une lentille a une face de forme libre</translation>
        </message>
        <message>
            <location filename="../../ui/window/window_state.py" />
            <source>A mirror has one freeform face</source>
            <translation>Un miroir a une face de forme libre</translation>
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
            <source>Done: no further gain</source>
            <translation>Terminé : plus de gain</translation>
        </message>
        <message>
            <location filename="../../ui/window/window_state.py" />
            <source>Stopped; {command} ({keys}) improves the lens</source>
            <translation>Arrêté ; {command} ({keys}) améliore la lentille</translation>
        </message>
        <message>
            <location filename="../../ui/window/window_state.py" />
            <source>Stopped; {command} ({keys}) improves the mirror</source>
            <translation>Arrêté ; {command} ({keys}) améliore le miroir</translation>
        </message>
        <message>
            <location filename="../../ui/window/workspaces.py" />
            <source>The view settings ({what}) of this design cannot be restored: {error}</source>
            <translation>Les réglages d'affichage ({what}) de cette conception ne peuvent être rétablis : {error}</translation>
        </message>
        <message>
            <location filename="../../ui/windows.py" />
            <source>start</source>
            <translation>démarrage</translation>
        </message>
        <message>
            <location filename="../../ui/windows.py" />
            <source>{name} is open with the recovered changes.</source>
            <translation>{name} est ouvert avec les modifications récupérées.</translation>
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
            <location filename="../../resources/__init__.py" />
            <source>Top hat</source>
            <translation>Disque uniforme</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>A uniform disc of light; see how soon its edge is sharp.</source>
            <translation>Un disque de lumière uniforme ; on voit son bord devenir vite net.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Flame</source>
            <translation>Flamme</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>A flame-like logo on black; see light leave what shall be dark.</source>
            <translation>Un logo en forme de flamme sur fond noir ; on voit la lumière quitter ce qui doit rester sombre.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Ball</source>
            <translation>Ballon</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>A faceted ball; see whether each grey comes out evenly bright.</source>
            <translation>Un ballon à facettes ; on voit si chaque gris devient uniforme.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Photograph</source>
            <translation>Photographie</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Every grey from black to white; see texture and shadow come.</source>
            <translation>Tous les gris du noir au blanc ; on voit venir la texture et les ombres.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Letter</source>
            <translation>Lettre</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>A bold letter on black; see its straight edges and corners.</source>
            <translation>Une lettre grasse sur fond noir ; à observer : ses bords droits et ses coins.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>First lenses, twice as fine</source>
            <translation>Premières lentilles, deux fois plus fines</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Flame, 512 × 512</source>
            <translation>Flamme, 512 × 512</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>The flame with four times the detail; see its thin parts.</source>
            <translation>La flamme avec quatre fois plus de détails ; à observer : ses parties fines.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Ball, 512 × 512</source>
            <translation>Ballon, 512 × 512</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>The ball with four times the detail; see the facets' edges.</source>
            <translation>Le ballon avec quatre fois plus de détails ; à observer : les arêtes des facettes.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Top hat: networks and starts</source>
            <translation>Disque uniforme : réseaux et points de départ</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>No network, flat start</source>
            <translation>Sans réseau, départ plan</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>The yardstick for the three networks: a smooth lens that keeps the target's symmetry.</source>
            <translation>La référence des trois réseaux : une lentille lisse qui garde la symétrie de la cible.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Sparse network, faint start</source>
            <translation>Réseau creux, départ faible</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Weights a ten-thousandth off zero; compare speed and symmetry with no network.</source>
            <translation>Poids à un dix-millième de zéro ; comparer vitesse et symétrie au cas sans réseau.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Sparse network, random start</source>
            <translation>Réseau creux, départ aléatoire</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>A rough initial lens; see how much of its roughness remains at the end.</source>
            <translation>Une lentille initiale rugueuse ; on voit la rugosité qui reste à la fin.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Dense network, faint start</source>
            <translation>Réseau dense, départ faible</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Two million weights for a thousand heights; compare loss and time with the sparse one.</source>
            <translation>Deux millions de poids pour mille hauteurs ; comparer coût et durée au réseau creux.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Real lights</source>
            <translation>Sources réelles</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Sun plate</source>
            <translation>Plaque solaire</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Acrylic to hold into the sun, whose disc blurs by 4.7 mm: compare error and bound.</source>
            <translation>De l'acrylique à tenir au soleil, dont le disque rend flou de 4.7 mm : comparer erreur et borne.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Phone torch</source>
            <translation>Lampe de téléphone</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>The LED of a telephone, close to the lens, blurs the letter's edges.</source>
            <translation>La LED d'un téléphone, près de la lentille, rend les bords flous.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>LED to a rectangle</source>
            <translation>LED vers un rectangle</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Light as wide as can be bent; see what is totally reflected, and how even the rest is.</source>
            <translation>La lumière aussi large que possible ; à observer : la réflexion totale et l'uniformité du reste.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Beam shaper</source>
            <translation>Mise en forme de faisceau</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>A Gaussian laser beam becomes an even disc; see that hardly any light is lost.</source>
            <translation>Un faisceau laser gaussien devient un disque uniforme ; presque rien n'est perdu.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Measured LED</source>
            <translation>LED mesurée</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>A file of 9,000 rays lights the lens; see how their grain shows in the check.</source>
            <translation>Un fichier de 9 000 rayons éclaire la lentille ; leur grain se voit à la vérification.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>White light</source>
            <translation>Lumière blanche</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Polycarbonate turns blue light more than red; see coloured edges in the predicted photo.</source>
            <translation>Le polycarbonate dévie plus le bleu que le rouge ; voir les bords colorés de la photo prédite.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Flame and ball: magnifications</source>
            <translation>Flamme et ballon : grandissements</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Flame, magnification 1</source>
            <translation>Flamme, grandissement 1</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>A screen as large as the lens, far away: a few hundredths of height do it all.</source>
            <translation>Un écran de la taille de la lentille, au loin : quelques centièmes de hauteur suffisent.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Flame, magnification 3</source>
            <translation>Flamme, grandissement 3</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>The concave base just fills the screen; see the corners, where rays are steep.</source>
            <translation>La base concave remplit juste l'écran ; à observer : les coins, où les rayons sont inclinés.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Flame, magnification 5</source>
            <translation>Flamme, grandissement 5</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Steeper still: compare the loss, and the light beside the screen, with 1 and 3.</source>
            <translation>Plus incliné encore : comparer le coût et la lumière hors de l'écran à 1 et 3.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Ball, magnification 1</source>
            <translation>Ballon, grandissement 1</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Ball, magnification 3</source>
            <translation>Ballon, grandissement 3</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Ball, magnification 5</source>
            <translation>Ballon, grandissement 5</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Flame: point and extended source</source>
            <translation>Flamme : source ponctuelle et étendue</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Point source</source>
            <translation>Source ponctuelle</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Light from one point; see in the light account how much of the cone passes the square lens by.</source>
            <translation>La lumière d'un point ; le bilan montre la part du cône qui manque la lentille carrée.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Extended source of 25 × 25 points</source>
            <translation>Source étendue de 25 × 25 points</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>The flame is put together from images of the square source: details smaller than these stay blurred.</source>
            <translation>La flamme se compose d'images de la source carrée : les détails plus petits restent flous.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Point source, then the extended one</source>
            <translation>Source ponctuelle, puis étendue</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>The loss jumps when the extended source takes over at iteration 200; see what is won back.</source>
            <translation>Le coût saute quand la source étendue prend le relais à l'itération 200 ; on voit ce qui est regagné.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Walls and streets</source>
            <translation>Murs et rues</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Wall washer</source>
            <translation>Lèche-mur</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>A picture on a wall that leans away from the lamp; see that it comes out straight.</source>
            <translation>Une image sur un mur incliné par rapport à la lampe ; elle apparaît droite.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Street light</source>
            <translation>Éclairage de rue</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>An LED's IES file; see intensity rise to both ends, so that the road below is even.</source>
            <translation>Le fichier IES d'une LED ; l'intensité croît vers les deux bouts pour une route uniforme.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Mirror: letter on a wall</source>
            <translation>Miroir : lettre sur un mur</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Sunlight from below, thrown back to a wall beside it; see the mirror lean towards it.</source>
            <translation>Le soleil d'en bas, renvoyé vers un mur voisin ; le miroir s'incline vers lui.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Mirror: photograph beside the lamp</source>
            <translation>Miroir : photographie à côté de la lampe</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Light from one point, drawn on a screen beside that point; see what misses the mirror.</source>
            <translation>La lumière d'un point, dessinée sur un écran voisin ; à observer : ce qui manque le miroir.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Two freeform faces</source>
            <translation>Deux faces de forme libre</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Photograph from a thin plate</source>
            <translation>Photographie par une plaque mince</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Both faces bend the light; compare their slopes with those of one face alone.</source>
            <translation>Les deux faces dévient la lumière ; comparer leurs pentes à celles d'une seule face.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Wide angle: disc from a near point</source>
            <translation>Grand angle : disque d'un point proche</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Light comes in at up to 60°; see how little of what is in the glass leaves by the side.</source>
            <translation>La lumière arrive jusqu'à 60° ; très peu quitte le verre par le côté.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>LED close by: square through a dome</source>
            <translation>LED proche : carré par un dôme</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>The entrance face comes towards the LED in its middle; compare with a flat one.</source>
            <translation>La face d'entrée s'avance vers la LED ; comparer à une face plane.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Photograph at two distances</source>
            <translation>Photographie à deux distances</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Thick glass moves the light, its exit face makes it parallel; compare both images.</source>
            <translation>Le verre épais déplace la lumière, la face de sortie la rend parallèle ; comparer les deux images.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Several elements</source>
            <translation>Plusieurs éléments</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>LED with dome, freeform lens and cover plate</source>
            <translation>LED avec dôme, lentille de forme libre et vitre</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>The lens is designed with the dome before it and the plate behind it; see the rays.</source>
            <translation>La lentille est conçue avec le dôme devant et la vitre derrière ; voir les rayons.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Collimated LED and freeform plate</source>
            <translation>LED collimatée et plaque de forme libre</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>A stock lens makes the light parallel, a thin plate forms the letter; see its soft edges.</source>
            <translation>Une lentille du commerce collimate la lumière, une plaque mince forme la lettre ; voir ses bords flous.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Wide photograph by one lens</source>
            <translation>Photo large avec une lentille</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>One face bends light by up to 47°; see in the light account what is reflected.</source>
            <translation>Une face dévie la lumière jusqu’à 47° ; le bilan de lumière montre ce qui est réfléchi.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Wide photograph by two lenses</source>
            <translation>Photo large avec deux lentilles</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Each lens bends light by about half; compare error and light account with one lens.</source>
            <translation>Chaque lentille dévie la lumière d’environ la moitié ; comparez l’erreur et le bilan de lumière avec une lentille.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Diffuser before the screen</source>
            <translation>Diffuseur devant l'écran</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>A film 4 mm before the screen blurs the letter; see the lens sharpen what the film blurs.</source>
            <translation>Un film à 4 mm de l'écran rend la lettre floue ; voir la lentille compenser ce flou.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Diffuser behind the lens</source>
            <translation>Diffuseur derrière la lentille</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>A film that scatters by 0.3° blurs over 1 mm at the screen; compare with the photograph.</source>
            <translation>Un film qui diffuse de 0.3° rend flou sur 1 mm à l'écran ; comparer avec la photo.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Fold mirror</source>
            <translation>Miroir de renvoi</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>A plane mirror turns the light by 90° before the freeform lens; see the folded axis.</source>
            <translation>Un miroir plan dévie la lumière de 90° avant la lentille freeform ; voir l'axe replié.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Mirror and lens</source>
            <translation>Miroir et lentille</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>The mirror is designed for the light behind a stock lens; see where the rays cross it.</source>
            <translation>Le miroir est conçu pour la lumière derrière une lentille du commerce ; voir où les rayons la traversent.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Tilted lens</source>
            <translation>Lentille inclinée</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>The lens is tilted and shifted, and is designed as it stands; see the image come out straight.</source>
            <translation>La lentille est inclinée et décalée, et conçue dans cette position ; l'image reste droite.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Derivative maps of a flat lens</source>
            <translation>Cartes de dérivées d'une lentille plane</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Degrees (3, 3), filter 3 × 3</source>
            <translation>Degrés (3, 3), filtre 3 × 3</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>As a control point rises it gathers light: a mountain in a valley, sum zero.</source>
            <translation>Un point de contrôle qui monte rassemble la lumière : un mont dans une vallée, somme nulle.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Degrees (3, 3), filter 11 × 11</source>
            <translation>Degrés (3, 3), filtre 11 × 11</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>The same mountain, smoother: each ray's light is spread over 11 × 11 pixels.</source>
            <translation>Le même mont, plus lisse : la lumière de chaque rayon s'étale sur 11 × 11 pixels.</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Degrees (5, 3), filter 3 × 3</source>
            <translation>Degrés (5, 3), filtre 3 × 3</translation>
        </message>
        <message>
            <location filename="../../resources/__init__.py" />
            <source>Wider along x: the valley meets the screen's border, and the sum leaves zero.</source>
            <translation>Plus large selon x : la vallée atteint le bord de l'écran, et la somme n'est plus nulle.</translation>
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
            <source>irradiance</source>
            <translation>éclairement</translation>
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
            <source>Light that leaves the last element and misses the screen. Much of it means that the designed faces cannot deflect all light to the image.</source>
            <translation>Lumière qui quitte le dernier élément et manque l'écran. S'il y en a beaucoup, les faces conçues ne peuvent pas dévier toute la lumière vers l'image.</translation>
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
            <source>Missed the diffuser</source>
            <translation>Passée à côté du diffuseur</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Light that passes the diffuser by.</source>
            <translation>La lumière qui manque le diffuseur.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Absorbed by the diffuser</source>
            <translation>Absorbée par le diffuseur</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>The part of the light on the diffuser that does not go on behind it.</source>
            <translation>La part de la lumière sur le diffuseur qui ne continue pas derrière lui.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>far field</source>
            <translation>champ lointain</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>in the far field</source>
            <translation>dans le champ lointain</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>intensity</source>
            <translation>intensité</translation>
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
            <source>Light that leaves the last element and misses the far field. Much of it means that the designed faces cannot deflect all light to the image.</source>
            <translation>Lumière qui quitte le dernier élément et manque le champ lointain. S'il y en a beaucoup, les faces conçues ne peuvent pas dévier toute la lumière vers l'image.</translation>
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
            <source>Vacuum wavelength at which the indices of materials are taken. Left empty, it is 0.5876 µm (helium d), or the mean of the spectrum.</source>
            <translation>Longueur d'onde dans le vide des indices des matériaux. Vide : 0.5876 µm (hélium d), ou la moyenne du spectre.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Spectrum</source>
            <translation>Spectre</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Up to 16 lines of light in place of one wavelength: wavelength in µm and part of the flux, as in 0.45, 0.3; 0.55, 0.5; 0.63, 0.2. Each line is traced with its own refractive indices, and an image is the sum of all lines. The parts may have any sum.</source>
            <translation>Jusqu'à 16 raies au lieu d'une longueur d'onde : longueur d'onde en µm et part du flux, comme 0.45, 0.3; 0.55, 0.5; 0.63, 0.2. Chaque raie est tracée avec ses propres indices, et une image est la somme de toutes. Les parts peuvent avoir une somme quelconque.</translation>
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
            <source>Size</source>
            <translation>Taille</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Full width and height of the grid. No detail of the image can be sharper than the image that the lens makes of this.</source>
            <translation>Largeur et hauteur totales de la grille. Aucun détail de l'image ne peut être plus net que l'image que la lentille en fait.</translation>
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
            <source>Full width and height of the emitter.</source>
            <translation>Largeur et hauteur totales de l'émetteur.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Outline</source>
            <translation>Contour</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>The shape of its face: the rectangle of its size, or the ellipse within.</source>
            <translation>La forme de sa face : le rectangle de sa taille, ou l'ellipse inscrite.</translation>
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
            <source>Elements</source>
            <translation>Éléments</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Lenses, mirrors and diffusers in the order in which light meets them. Light that passes one by is lost there.</source>
            <translation>Lentilles, miroirs et diffuseurs dans l'ordre où la lumière les rencontre. La lumière qui en manque un y est perdue.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Two faces with a material between; light goes through along its +z.</source>
            <translation>Deux faces avec un matériau entre elles ; la lumière la traverse selon son +z.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Name of the element; letters, digits, - and _.</source>
            <translation>Nom de l'élément ; lettres, chiffres, - et _.</translation>
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
            <source>Full width and height of the element. All of it is lit.</source>
            <translation>Largeur et hauteur totales de l'élément. Il est éclairé en entier.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>The rectangle of its size, or the ellipse within. Light beside it misses it.</source>
            <translation>Le rectangle de sa taille, ou l'ellipse inscrite. La lumière à côté manque l'élément.</translation>
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
            <source>Front face</source>
            <translation>Face avant</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Back face</source>
            <translation>Face arrière</translation>
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
            <source>Diffuser</source>
            <translation>Diffuseur</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>One plane that scatters light onwards: the last element of a train.</source>
            <translation>Un plan qui diffuse la lumière vers l'avant : le dernier élément d'une suite.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Scatter</source>
            <translation>Diffusion</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>In which directions the light goes on behind the plane.</source>
            <translation>Dans quelles directions la lumière continue derrière le plan.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Gaussian</source>
            <translation>Gaussien</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Light is scattered about the direction in which it would go on.</source>
            <translation>La lumière est diffusée autour de la direction dans laquelle elle continuerait.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Sigma</source>
            <translation>Sigma</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>How far light is scattered: the radiant intensity of a narrow beam behind the diffuser falls as exp(−θ²/2σ²) with the angle θ to the beam. For small σ it is the standard deviation of the angle along each axis. The full width at half maximum, which data sheets state, is 2.355 σ.</source>
            <translation>L'étendue de la diffusion : l'intensité énergétique d'un faisceau étroit derrière le diffuseur décroît comme exp(−θ²/2σ²) avec l'angle θ au faisceau. Pour σ petit, c'est l'écart type de l'angle selon chaque axe. La largeur à mi-hauteur des fiches techniques est 2.355 σ.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Light leaves with the same radiance in all directions, wherever it comes from.</source>
            <translation>La lumière sort avec la même luminance dans toutes les directions, d'où qu'elle vienne.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Transmittance</source>
            <translation>Facteur de transmission</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Part of the light that goes on behind the diffuser, at all angles of incidence. It absorbs the rest, or reflects it.</source>
            <translation>Part de la lumière qui continue derrière le diffuseur, à tous les angles d'incidence. Il absorbe ou réfléchit le reste.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Images</source>
            <translation>Images</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Where light is wanted, and which. Two freeform faces can form several images; one face forms a compromise.</source>
            <translation>Où la lumière est voulue, et laquelle. Deux faces de forme libre peuvent former plusieurs images ; une seule forme un compromis.</translation>
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
            <source>Full width and height of the screen. The target fills it.</source>
            <translation>Largeur et hauteur totales de l'écran. La cible le remplit.</translation>
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
            <source>Full angles that it covers across and upwards. The target fills it.</source>
            <translation>Angles totaux qu'il couvre en largeur et en hauteur. La cible le remplit.</translation>
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
            <source>Black level</source>
            <translation>Niveau du noir</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Pixel values up to this level get no light, as in the levels of a photo program. Raise it where a dark background takes light from the subject. Levels are fractions of the brightest pixel value, after the crop and the inversion.</source>
            <translation>Les valeurs de pixel jusqu'à ce niveau ne reçoivent pas de lumière, comme les niveaux d'un logiciel photo. À relever si un fond sombre prend de la lumière au sujet. Les niveaux sont des fractions de la valeur la plus claire, après le recadrage et l'inversion.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>of the brightest</source>
            <translation>du plus clair</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>White level</source>
            <translation>Niveau du blanc</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Pixel values from this level on are white. Lower it to cut highlights off, so that the rest of the picture gets more of the light.</source>
            <translation>Les valeurs de pixel à partir de ce niveau sont blanches. À baisser pour couper les hautes lumières : le reste de l'image reçoit plus de lumière.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Gamma</source>
            <translation>Gamma</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Above 1 the mid-tones between the black level and the white level are brighter, below 1 darker: the pixel value to the power of 1/gamma.</source>
            <translation>Au-dessus de 1, les tons moyens entre le noir et le blanc sont plus clairs, en dessous plus sombres : la valeur de pixel à la puissance 1/gamma.</translation>
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
            <source>Beam</source>
            <translation>Faisceau</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>A rotationally symmetric beam with a hot spot, and spill around it.</source>
            <translation>Un faisceau de révolution avec un centre clair et une lumière diffuse autour.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Points of radius and level, from the middle outwards; a smooth curve joins them. A radius is a fraction of the smaller half-width of the whole image, a level one of the peak: the radius at level 0.5 is half of the full width at half maximum, that at 0.1 half of the field width. The first level holds within its radius; beyond the last radius there is no light.</source>
            <translation>Points de rayon et de niveau, du centre vers l'extérieur ; une courbe lisse les joint. Un rayon est une fraction de la plus petite demi-largeur de toute l'image, un niveau une fraction du maximum : le rayon au niveau 0,5 est la moitié de la largeur à mi-hauteur, celui à 0,1 la moitié de la largeur de champ. Le premier niveau vaut jusqu'à son rayon ; au-delà du dernier rayon, il n'y a pas de lumière.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>radius, level</source>
            <translation>rayon, niveau</translation>
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
            <source>Light falls off over some pixels, so that a design feels where in a pixel a ray lands.</source>
            <translation>La lumière décroît sur quelques pixels, de sorte qu'une conception sent où un rayon tombe dans un pixel.</translation>
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
            <source>Name of the region in its figures.</source>
            <translation>Nom de la région dans ses valeurs.</translation>
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
            <source>Steps by which the designed elements are made, in their order. Runs design for the image as made, and checks trace it. Left empty, elements are ideal.</source>
            <translation>Étapes de fabrication des éléments conçus, dans leur ordre. Les calculs conçoivent pour l'image après fabrication, et les contrôles la tracent. Laissé vide, les éléments sont idéaux.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Milling</source>
            <translation>Fraisage</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Milling with a ball cutter in straight parallel passes.</source>
            <translation>Fraisage à la fraise boule en passes droites parallèles.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Ball radius</source>
            <translation>Rayon de la fraise</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Radius of the ball cutter.</source>
            <translation>Rayon de la fraise boule.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Distance of neighbouring passes, seen along z. The scallops between them are about step² / 8 R high.</source>
            <translation>Distance entre passes voisines, vue le long de z. Les crêtes entre elles ont environ pas² / 8 R de haut.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Direction of the passes against x.</source>
            <translation>Direction des passes par rapport à x.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Feed per tooth</source>
            <translation>Avance par dent</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Distance of the marks along each pass; 0 for none.</source>
            <translation>Distance des marques le long de chaque passe ; 0 pour aucune.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Diamond turning</source>
            <translation>Tournage au diamant</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Diamond turning with a slow tool servo: a spiral about the axis of the element.</source>
            <translation>Tournage au diamant avec servo-outil lent : une spirale autour de l'axe de l'élément.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Nose radius</source>
            <translation>Rayon de bec</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Radius of the tip of the diamond.</source>
            <translation>Rayon de la pointe du diamant.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Feed</source>
            <translation>Avance</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Distance of neighbouring turns. The ridges between are feed² / 8 R high.</source>
            <translation>Distance entre tours voisins. Les crêtes entre eux ont avance² / 8 R de haut.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Polishing</source>
            <translation>Polissage</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Polishing: high spots go first, so that the face becomes an average of itself.</source>
            <translation>Polissage : les points hauts partent d'abord, et la face devient une moyenne d'elle-même.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Rms width of the Gaussian by which polishing averages the face. Half of the step-over removes scallops; details of the lens that are not much wider go, too.</source>
            <translation>Largeur efficace de la gaussienne par laquelle le polissage moyenne la face. La moitié du pas enlève les crêtes ; les détails de la lentille guère plus larges partent aussi.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Depth</source>
            <translation>Profondeur</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Thickness of the layer that polishing removes.</source>
            <translation>Épaisseur de la couche enlevée par le polissage.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Casting or moulding</source>
            <translation>Coulée ou moulage</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Casting or moulding: the element shrinks as it cures or cools.</source>
            <translation>Coulée ou moulage : l'élément rétrécit en durcissant ou en refroidissant.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Shrinkage</source>
            <translation>Retrait</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Part by which all lengths of the element become smaller and the mould or the print file does not make up for: 0.005 for 0.5 %.</source>
            <translation>Part dont toutes les longueurs de l'élément diminuent et que le moule ou le fichier d'impression ne compense pas : 0,005 pour 0,5 %.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Resin printing</source>
            <translation>Impression résine</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Resin printing in layers along z, which pixels of light cure; then dipping or coating.</source>
            <translation>Impression résine en couches le long de z, durcies par des pixels de lumière ; puis trempage ou vernis.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Layer height</source>
            <translation>Hauteur de couche</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Thickness of each layer, along z.</source>
            <translation>Épaisseur de chaque couche, le long de z.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Pixel size</source>
            <translation>Taille de pixel</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Width of the pixels of light that cure a layer.</source>
            <translation>Largeur des pixels de lumière qui durcissent une couche.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Dip width</source>
            <translation>Largeur de trempage</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Rms width of the Gaussian by which a dip in resin, or a coat of varnish, averages the face; 0 for none.</source>
            <translation>Largeur efficace de la gaussienne par laquelle un bain de résine ou un vernis moyenne la face ; 0 pour aucun.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Figure error</source>
            <translation>Erreur de forme</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Figure error: random waves of a known slope and length, whatever makes them.</source>
            <translation>Erreur de forme : des ondes aléatoires de pente et de longueur connues, quelle qu'en soit la cause.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Rms of the gradient of the error.</source>
            <translation>Valeur efficace du gradient de l'erreur.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Correlation length</source>
            <translation>Longueur de corrélation</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Distance at which the autocorrelation falls to 1/e.</source>
            <translation>Distance à laquelle l'autocorrélation tombe à 1/e.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Another number makes other waves.</source>
            <translation>Un autre nombre donne d'autres ondes.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Uncertainty</source>
            <translation>Incertitude</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Standard deviations of the set-up that is built. Runs then lower the mean error over them, and not that of the exact set-up alone.</source>
            <translation>Écarts types du montage construit. Les calculs réduisent alors l'erreur moyenne sur eux, et pas seulement celle du montage exact.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Standard deviations of what a built set-up has else than the scene says; 0 where known.</source>
            <translation>Écarts types de ce qu'un montage construit a de différent de la scène ; 0 si connu.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Distance</source>
            <translation>Distance</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Of the receiver, along the light that comes to its middle.</source>
            <translation>Du récepteur, le long de la lumière qui arrive en son milieu.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Source shift</source>
            <translation>Décal. source</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Of a source at a place, along x and along y.</source>
            <translation>D'une source placée, le long de x et de y.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Source tilt</source>
            <translation>Inclin. source</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Of collimated light, about x and about y.</source>
            <translation>De la lumière collimatée, autour de x et de y.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Source size</source>
            <translation>Taille de la source</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Of an extended source, in percent of its size.</source>
            <translation>D’une source étendue, en pour cent de sa taille.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Of the refractive index of designed lenses.</source>
            <translation>De l’indice de réfraction des lentilles conçues.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Of the material of designed lenses at each freeform face.</source>
            <translation>De la matière des lentilles conçues à chaque surface freeform.</translation>
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
            <source>As the scene</source>
            <translation>Comme la scène</translation>
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
            <source>Radius of the ball cutter that has to fit everywhere on the freeform faces. Hollows keep to it; humps may be sharper. Manufacture shows whether it fits. Left empty, any will do.</source>
            <translation>Rayon de la fraise hémisphérique qui doit convenir partout aux faces de forme libre. Les creux s'y tiennent ; les bosses peuvent être plus vives. Fabrication montre si elle convient. Vide : quelconque.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Error at most</source>
            <translation>Erreur au plus</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Goal for the relative L2 error: 0.02 is 2 %. The run ends as soon as its lens meets it. Left empty, the run goes on as long as it gains.</source>
            <translation>Objectif pour l'erreur L2 relative : 0.02 vaut 2 %. L'exécution se termine dès que sa lentille l'atteint. Vide : elle continue tant qu'elle gagne.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Light at least</source>
            <translation>Lumière au moins</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Goal for the part of the emitted light on the receiver: 0.9 is 90 %. It is judged and does not change the run.</source>
            <translation>Objectif pour la part de la lumière émise sur le récepteur : 0.9 vaut 90 %. Il est jugé et ne change pas l'exécution.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Uniformity at least</source>
            <translation>Uniformité au moins</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Goal for U₀, the minimum over the average irradiance where the target is lit; 1 is uniform. It is judged and does not change the run.</source>
            <translation>Objectif pour U₀, le minimum sur la moyenne de l'éclairement où la cible est éclairée ; 1 est uniforme. Il est jugé et ne change pas l'exécution.</translation>
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
            <source>Beam of a torch or downlight</source>
            <translation>Faisceau d'une lampe de poche</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>An LED and its lens make a round beam of given angles, as of a torch or a downlight.</source>
            <translation>Une LED et sa lentille font un faisceau rond d'angles donnés, comme une lampe de poche ou un downlight.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Beam angle</source>
            <translation>Angle du faisceau</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Full angle within which the intensity is at least half of the peak.</source>
            <translation>Angle total dans lequel l'intensité est au moins la moitié du maximum.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Field angle</source>
            <translation>Angle de champ</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Full angle within which the intensity is at least 10 % of the peak.</source>
            <translation>Angle total dans lequel l'intensité est au moins 10 % du maximum.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Spill angle</source>
            <translation>Angle de la lumière diffuse</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Full angle of all light of the beam.</source>
            <translation>Angle total de toute la lumière du faisceau.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Spill</source>
            <translation>Lumière diffuse</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Intensity at the edge of the spill, in percent of the peak.</source>
            <translation>Intensité au bord de la lumière diffuse, en pour cent du maximum.</translation>
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
            <source>A lamp above or below a wall lights it evenly from the side.</source>
            <translation>Une lampe en haut ou en bas d'un mur l'éclaire uniformément de côté.</translation>
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
            <source>misses the diffuser</source>
            <translation>manque le diffuseur</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>a larger diffuser catches it</source>
            <translation>un diffuseur plus grand la capte</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>is absorbed by the diffuser</source>
            <translation>est absorbé par le diffuseur</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>a diffuser with a higher transmittance lets it through</source>
            <translation>un diffuseur de plus grande transmission la laisse passer</translation>
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
            <source>the parts emitted, greater than 0, and on_screen are needed</source>
            <translation>les parts emitted, supérieure à 0, et on_screen sont nécessaires</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>{input} is no part of a light account</source>
            <translation>{input} n'est pas une part d'un bilan de lumière</translation>
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
            <source>Control</source>
            <translation>Commande</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Control that reads the program: its preamble, path modes, dwell, decimals and end.</source>
            <translation>Commande qui lit le programme : préambule, modes de trajectoire, temporisation, décimales et fin.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Standard ball cutter by its diameter. Empty: the cutter of the processes or limits of the design, else the largest standard cutter that fits everywhere.</source>
            <translation>Fraise boule du commerce, par son diamètre. Vide : la fraise des procédés ou des limites de la conception, sinon la plus grande fraise du commerce qui passe partout.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>automatic</source>
            <translation>automatique</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Tool radius</source>
            <translation>Rayon de l'outil</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Radius of another ball cutter than a standard one.</source>
            <translation>Rayon d’une autre fraise boule que les courantes.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>standard</source>
            <translation>courant</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Scallop height</source>
            <translation>Hauteur de crête</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Largest height of material between neighbouring passes. Empty: that of the step-over among the processes of the design, else 1e-4 of the larger half-width, or more where that needs too many moves.</source>
            <translation>Hauteur maximale de matière entre deux passes voisines. Vide : celle du pas entre passes des procédés de la conception, sinon 1e-4 de la plus grande demi-largeur, ou davantage où cela demande trop de mouvements.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Fixture rim</source>
            <translation>Bord de bridage</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Width of stock around the part for clamping.</source>
            <translation>Largeur du brut autour de la pièce pour le bridage.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Stock above</source>
            <translation>Brut au-dessus</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Height of stock above the highest point of the face.</source>
            <translation>Hauteur du brut au-dessus du point le plus haut de la face.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Whole height of the stock. Empty: as much as part and cuts need.</source>
            <translation>Hauteur totale du brut. Vide : ce qu’il faut pour la pièce et les passes.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Program zero</source>
            <translation>Origine du programme</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Place of the stock where the program's coordinates are zero.</source>
            <translation>Point du brut où les coordonnées du programme sont nulles.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>middle, top of the stock</source>
            <translation>milieu, dessus du brut</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>corner of least x and y, top of the stock</source>
            <translation>coin aux plus petits x et y, dessus du brut</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>middle, bottom of the stock</source>
            <translation>milieu, dessous du brut</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Roughing</source>
            <translation>Ébauche</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Passes at levels of z that clear the stock above the face.</source>
            <translation>Passes par niveaux de z qui enlèvent le brut au-dessus de la face.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>flat cutter</source>
            <translation>fraise cylindrique</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>ball cutter</source>
            <translation>fraise boule</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Roughing cutter</source>
            <translation>Fraise d’ébauche</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Standard cutter of the roughing passes by its diameter. Empty: the largest one that is at most a quarter as wide as the part.</source>
            <translation>Fraise courante de l’ébauche, par son diamètre. Vide : la plus grande qui est au plus large d’un quart de la pièce.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Step down</source>
            <translation>Profondeur de passe</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Distance of two levels of roughing. Empty: half of the cutter's radius.</source>
            <translation>Distance de deux niveaux d’ébauche. Vide : la moitié du rayon de la fraise.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Allowance</source>
            <translation>Surépaisseur</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Material that roughing leaves everywhere for finishing. Empty: a tenth of the cutter's radius.</source>
            <translation>Matière que l’ébauche laisse partout pour la finition. Vide : un dixième du rayon de la fraise.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Travel height</source>
            <translation>Hauteur de dégagement</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Height of rapid moves above the stock and above the highest cut. Empty: 2 mm, or the ball's diameter if that is more.</source>
            <translation>Hauteur des déplacements rapides au-dessus du brut et de la passe la plus haute. Vide : 2 mm, ou le diamètre de la boule s’il est plus grand.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Feed rate while cutting.</source>
            <translation>Avance en coupe.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Plunge feed</source>
            <translation>Avance de plongée</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Feed rate while plunging into the stock.</source>
            <translation>Avance en plongée dans le brut.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Spindle speed</source>
            <translation>Vitesse de broche</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Revolutions per minute, clockwise.</source>
            <translation>Tours par minute, en sens horaire.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Dwell</source>
            <translation>Temporisation</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Wait above the stock until the spindle has reached its speed.</source>
            <translation>Attente au-dessus du brut jusqu'à ce que la broche ait atteint sa vitesse.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Coolant</source>
            <translation>Arrosage</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Switch flood coolant on and off.</source>
            <translation>Met l’arrosage en marche et l’arrête.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Program number</source>
            <translation>Numéro du programme</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Number of the program, where the control has numbers.</source>
            <translation>Numéro du programme, si la commande a des numéros.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Cut a mould of the face</source>
            <translation>Usiner un moule de la face</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Cut the negative of the face, turned over about the y axis.</source>
            <translation>Usiner le négatif de la face, retourné autour de l'axe y.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Radius of the diamond's round nose. Empty: 0.5 mm, or less where that does not fit.</source>
            <translation>Rayon du bec rond du diamant. Vide : 0,5 mm, ou moins s’il ne passe pas.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Feed per turn</source>
            <translation>Avance par tour</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>How far the tool moves to the axis during a turn. Empty: for cusps of 1e-5 of the larger half-width.</source>
            <translation>Course de l’outil vers l’axe pendant un tour. Vide : pour des crêtes de 1e-5 de la plus grande demi-largeur.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Points per turn</source>
            <translation>Points par tour</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Points of the table for each turn. Empty: as many as keep the error between them below the chord error.</source>
            <translation>Points de la table par tour. Vide : autant qu’il faut pour que l’erreur entre eux reste sous l’erreur de corde.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Form tolerance</source>
            <translation>Tolérance de forme</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Width of the zone that holds the freeform face. Empty: the drawing states none.</source>
            <translation>Largeur de la zone qui contient la face de forme libre. Vide : le dessin n’en indique pas.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Inspection points</source>
            <translation>Points de contrôle</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Points of the face along each axis whose coordinates are listed.</source>
            <translation>Points de la face le long de chaque axe dont les coordonnées sont listées.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Tile side</source>
            <translation>Côté de la plaquette</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Write only a square of the face on a flat back, this wide, as a test piece. Empty: the whole part.</source>
            <translation>Écrire seulement un carré de la face avec un dos plan, de cette largeur, comme pièce d'essai. Vide : la pièce entière.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>whole part</source>
            <translation>pièce entière</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Tile x</source>
            <translation>Plaquette x</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Middle of the tile along x.</source>
            <translation>Milieu de la plaquette selon x.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Tile y</source>
            <translation>Plaquette y</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Middle of the tile along y.</source>
            <translation>Milieu de la plaquette selon y.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Thinnest</source>
            <translation>Plus mince</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Least thickness of the element</source>
            <translation>Épaisseur minimale de l'élément</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Thickest</source>
            <translation>Plus épais</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Largest thickness of the element</source>
            <translation>Épaisseur maximale de l'élément</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Largest angle between a freeform face and a plane across the axis, in degrees</source>
            <translation>Plus grand angle entre une face de forme libre et un plan perpendiculaire à l'axe, en degrés</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Least radius of curvature that a tool can cut, concave or convex</source>
            <translation>Plus petit rayon de courbure usinable, concave ou convexe</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Radius of the ball cutter that must fit everywhere on the face. A larger ball leaves material in hollows</source>
            <translation>Rayon de la fraise boule qui doit passer partout sur la face. Une boule plus grande laisse de la matière dans les creux</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Wanted error as made</source>
            <translation>Erreur voulue après fabrication</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Relative L2 error of the image as made. Empty: 1.1 times the error as designed.</source>
            <translation>Erreur L2 relative de l'image après fabrication. Vide : 1,1 fois l'erreur telle que conçue.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>1.1 times as designed</source>
            <translation>1,1 fois telle que conçue</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Radius of the ball cutter. Empty: the largest standard cutter that fits everywhere.</source>
            <translation>Rayon de la fraise hémisphérique. Vide : la plus grande fraise standard qui passe partout.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Polish time</source>
            <translation>Temps de polissage</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Time to polish 1 cm² over a width of 0.1 mm, which grows with the square of the width. The default is an assumption.</source>
            <translation>Temps pour polir 1 cm² sur une largeur de 0,1 mm ; il croît avec le carré de la largeur. La valeur par défaut est une hypothèse.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Meaning of pixel values, unless the file has a colour profile.</source>
            <translation>Signification des valeurs de pixel, sauf si le fichier a un profil de couleurs.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>as shown by a monitor</source>
            <translation>comme les montre un écran</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>as stored</source>
            <translation>comme enregistrées</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Unit of the measurements. Empty: that of the file, or else of the scene.</source>
            <translation>Unité des mesures. Vide : celle du fichier, sinon celle de la scène.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>of file or scene</source>
            <translation>du fichier ou de la scène</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Unit of heights</source>
            <translation>Unité des hauteurs</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Unit of their heights. Empty: that of their lengths.</source>
            <translation>Unité de leurs hauteurs. Vide : celle de leurs longueurs.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>as lengths</source>
            <translation>comme les longueurs</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Determine a scale</source>
            <translation>Déterminer une échelle</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Determine a scale (shrinkage), too.</source>
            <translation>Déterminer aussi une échelle (retrait).</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Pixel</source>
            <translation>Pixel</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Of pictures: side of a pixel. Empty: of the file.</source>
            <translation>Pour les images : côté d’un pixel. Vide : celui du fichier.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>of the file</source>
            <translation>du fichier</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Black</source>
            <translation>Noir</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Of pictures: height of black.</source>
            <translation>Pour les images : hauteur du noir.</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>White</source>
            <translation>Blanc</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>Of pictures: height of white.</source>
            <translation>Pour les images : hauteur du blanc.</translation>
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
            <source>Largest tilt of the source about its middle</source>
            <translation>Plus grande inclinaison de la source autour de son milieu</translation>
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
            <source>Within limits</source>
            <translation>Limites respectées</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>No limit is set</source>
            <translation>Aucune limite fixée</translation>
        </message>
        <message>
            <location filename="../../workbench" />
            <source>fused silica</source>
            <translation>silice fondue</translation>
        </message>
        <message>
            <location filename="../../workbench/design/snapshot.py" />
            <source>all iterations are done</source>
            <translation>toutes les itérations sont faites</translation>
        </message>
        <message>
            <location filename="../../workbench/design/snapshot.py" />
            <source>all control points are locked</source>
            <translation>tous les points de contrôle sont verrouillés</translation>
        </message>
        <message>
            <location filename="../../workbench/design/snapshot.py" />
            <source>stopped</source>
            <translation>arrêté</translation>
        </message>
        <message>
            <location filename="../../workbench/design/snapshot.py" />
            <source>goal met: error {error} of at most {goal}</source>
            <translation>objectif atteint : erreur {error} pour {goal} au plus</translation>
        </message>
        <message>
            <location filename="../../workbench/design/snapshot.py" />
            <source>converged: error below {error:g} %</source>
            <translation>convergé : erreur sous {error:g} %</translation>
        </message>
        <message>
            <location filename="../../workbench/design/snapshot.py" />
            <source>converged: no step makes the image better</source>
            <translation>convergé : aucun pas n'améliore l'image</translation>
        </message>
        <message>
            <location filename="../../workbench/design/snapshot.py" />
            <source>converged: less than {gain:g} % better in {patience} iterations</source>
            <translation>convergé : moins de {gain:g} % de mieux en {patience} itérations</translation>
        </message>
        <message>
            <location filename="../../workbench/design/snapshot.py" />
            <source>converged: error less than {points:g} percentage points lower in {patience} iterations</source>
            <translation>convergé : erreur réduite de moins de {points:g} point de pourcentage en {patience} itérations</translation>
        </message>
        <message>
            <location filename="../../workbench/design/snapshot.py" />
            <source>converged: in the light of other points of the source the image gets worse</source>
            <translation>convergé : à la lumière d'autres points de la source, l'image se dégrade</translation>
        </message>
        <message>
            <location filename="../../workbench/design/snapshot.py" />
            <source>{ended}; no iteration made the lens better</source>
            <translation>{ended} ; aucune itération n'a amélioré la lentille</translation>
        </message>
        <message>
            <location filename="../../workbench/design/snapshot.py" />
            <source>{ended}; the exit face alone makes no image</source>
            <translation>{ended} ; la face de sortie seule ne fait pas d'image</translation>
        </message>
        <message>
            <location filename="../../workbench/design/snapshot.py" />
            <source>{ended}; after {iterations} iterations the error of both faces was {times:.2g} times that of the exit face behind a flat entrance</source>
            <translation>{ended} ; après {iterations} itérations, l'erreur des deux faces était {times:.2g} fois celle de la face de sortie derrière une entrée plane</translation>
        </message>
        <message>
            <location filename="../../workbench/design/snapshot.py" />
            <source>failed: {why}</source>
            <translation>échec : {why}</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/by_cells.py" />
            <source>the check contradicts itself: {cells:.4g} % of the light on the receiver by cells, {rays:.4g} % by random rays; no figure of this check is reliable</source>
            <translation>la vérification se contredit : {cells:.4g} % de la lumière sur le récepteur par cellules, {rays:.4g} % par rayons aléatoires ; aucune valeur de cette vérification n'est fiable</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/by_cells.py" />
            <source>the check contradicts itself: the images by cells and by random rays are {apart:.3g} % apart, which noise and error bound do not explain; no figure of this check is reliable</source>
            <translation>la vérification se contredit : les images par cellules et par rayons aléatoires sont à {apart:.3g} % l'une de l'autre, ce que bruit et borne d'erreur n'expliquent pas ; aucune valeur de cette vérification n'est fiable</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/by_cells.py" />
            <source>the run finds {run:.4g} % of the light on the receiver, the check {check:.4g} %: use the figures of the check</source>
            <translation>le calcul trouve {run:.4g} % de la lumière sur le récepteur, la vérification {check:.4g} % : utiliser les valeurs de la vérification</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/by_cells.py" />
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
            <location filename="../../workbench/analysis/cross_check.py" />
            <source>no light of this lens reaches the screen, so there is nothing to compare</source>
            <translation>aucune lumière de cette lentille n'atteint l'écran : il n'y a rien à comparer</translation>
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
            <location filename="../../workbench/analysis/derivatives.py" />
            <source>no number; a number as in lens.thickness is needed</source>
            <translation>pas un nombre ; un nombre comme dans lens.thickness est nécessaire</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/focus.py" />
            <source>{z:g}: light comes to the screen across the z axis, along which its distance changes; {now:g}</source>
            <translation>{z:g} : la lumière vient à l'écran en travers de l'axe z, le long duquel sa distance change ; {now:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/inspection/alignment.py" />
            <source>its points do not fit {face}: they are off by {off:.3g} and the relief of the face is {relief:.3g}; check the part, the face and the unit</source>
            <translation>ses points ne correspondent pas à {face} : ils s'écartent de {off:.3g}, et le relief de la face est de {relief:.3g} ; vérifiez la pièce, la face et l'unité</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/inspection/alignment.py" />
            <source>it is a mirror image of the face: reverse the sign of its heights</source>
            <translation>c'est une image en miroir de la face : inversez le signe de ses hauteurs</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/inspection/alignment.py" />
            <source>it is a mirror image of the face: reverse the sign of its x</source>
            <translation>c'est une image en miroir de la face : inversez le signe de son x</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/inspection/inspection.py" />
            <source>as designed</source>
            <translation>comme conçu</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/inspection/inspection.py" />
            <source>{face!r} is no freeform face; {known}</source>
            <translation>{face!r} n'est pas une face freeform ; {known}</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/inspection/inspection.py" />
            <source>it has another size than {face} in {old}; the unit {unit} fits</source>
            <translation>en {old}, elle n'a pas la taille de {face} ; l'unité {unit} convient</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/inspection/inspection.py" />
            <source>its heights do not fit {face} in {old}; lengths in {unit} and heights in {up} fit</source>
            <translation>en {old}, ses hauteurs ne correspondent pas à {face} ; longueurs en {unit} et hauteurs en {up} conviennent</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/inspection/inspection.py" />
            <source>it has another size or relief than {face}, and no unit fits; check part and face</source>
            <translation>elle a une autre taille ou un autre relief que {face}, et aucune unité ne convient ; vérifiez la pièce et la face</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/inspection/residual.py" />
            <source>it covers {covered:.0f} % of {face}; at least {least:.0f} % are needed</source>
            <translation>elle couvre {covered:.0f} % de {face} ; il en faut au moins {least:.0f} %</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/light_limit.py" />
            <source>{part} % meets the lens</source>
            <translation>{part} % atteint la lentille</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/light_limit.py" />
            <source>{part} % meets the mirror</source>
            <translation>{part} % atteint le miroir</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/light_limit.py" />
            <source>{part} % passes the faces at best</source>
            <translation>{part} % traverse les faces au mieux</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/light_limit.py" />
            <source>{part} % can be sent there</source>
            <translation>{part} % peut y être envoyé</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/light_limit.py" />
            <source>{part} % fits into the étendue</source>
            <translation>{part} % tient dans l’étendue optique</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/light_limit.py" />
            <source>{reasons}, {reason}</source>
            <translation>{reasons}, {reason}</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/light_limit.py" />
            <source>All of the light may land {place}.</source>
            <translation>Toute la lumière peut arriver {place}.</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/light_limit.py" />
            <source>At most {most} % of the light can land {place}: {reasons}.</source>
            <translation>Au plus {most} % de la lumière peut arriver {place} : {reasons}.</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/making/photograph.py" />
            <source>the picture of this lens is not within these corners; mark those of the receiver</source>
            <translation>l’image de cette lentille n’est pas entre ces coins ; marquez ceux du récepteur</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/making/photograph.py" />
            <source>four places x,y in pixels of the photograph are needed</source>
            <translation>il faut quatre points x,y en pixels de la photographie</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/making/photograph.py" />
            <source>are beside the photograph of {n_x} × {n_y} pixels</source>
            <translation>sont hors de la photographie de {n_x} × {n_y} pixels</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/making/photograph.py" />
            <source>make no convex quadrilateral in this order</source>
            <translation>ne forment pas un quadrilatère convexe dans cet ordre</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/making/photograph.py" />
            <source>turned by 180°</source>
            <translation>tournée de 180°</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/making/photograph.py" />
            <source>mirrored left to right</source>
            <translation>inversée de gauche à droite</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/making/photograph.py" />
            <source>mirrored top to bottom</source>
            <translation>inversée de haut en bas</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/making/photograph.py" />
            <source>a photograph shows a plane; 'plane'</source>
            <translation>une photographie montre un plan ; 'plane'</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/making/photograph.py" />
            <source>distance</source>
            <translation>distance</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/making/photograph.py" />
            <source>tilt about x</source>
            <translation>inclinaison autour de x</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/making/photograph.py" />
            <source>tilt about y</source>
            <translation>inclinaison autour de y</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/making/photograph.py" />
            <source>source size</source>
            <translation>taille de la source</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/making/plan.py" />
            <source>{wanted:.3g} % as made is not reached by milling and polishing this lens; more than {least:.3g} % may be</source>
            <translation>{wanted:.3g} % après fabrication n'est pas atteint par fraisage et polissage de cette lentille ; plus de {least:.3g} % peut l'être</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/making/robust.py" />
            <source>nothing is uncertain; state standard deviations, such as of distance</source>
            <translation>rien n’est incertain ; indiquez des écarts types, par exemple celui de la distance</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/mitsuba_elements.py" />
            <source>Mitsuba is given no {kind}; leave it out to compare</source>
            <translation>Mitsuba ne connaît pas {kind} ; l'omettre pour comparer</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/mitsuba_receivers.py" />
            <source>Mitsuba has no camera for {kind}; use a plane or a far field</source>
            <translation>Mitsuba n'a pas de caméra pour {kind} ; utiliser un plan ou un champ lointain</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/mitsuba_scatter.py" />
            <source>Mitsuba is given no scatter of kind {law}; compare without it</source>
            <translation>Mitsuba ne connaît pas la diffusion {law} ; comparer sans elle</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/photo/light.py" />
            <source>laser of {wavelength:g} µm</source>
            <translation>laser de {wavelength:g} µm</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/photo/light.py" />
            <source>the spectrum of the source</source>
            <translation>le spectre de la source</translation>
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
            <source>part of the light</source>
            <translation>part de la lumière</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/regions.py" />
            <source>average</source>
            <translation>moyenne</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/regions.py" />
            <source>minimum</source>
            <translation>minimum</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/regions.py" />
            <source>maximum</source>
            <translation>maximum</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/regions.py" />
            <source>U₀ (minimum / average)</source>
            <translation>U₀ (minimum / moyenne)</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/regions.py" />
            <source>U₁ (minimum / maximum)</source>
            <translation>U₁ (minimum / maximum)</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/regions.py" />
            <source>{times:.3f} × average</source>
            <translation>{times:.3f} × moyenne</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/regions.py" />
            <source>{part} of the light, average {average}, minimum {least}, maximum {most}, U₀ {even}, U₁ {ends}</source>
            <translation>{part} de la lumière, moyenne {average}, minimum {least}, maximum {most}, U₀ {even}, U₁ {ends}</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/regions.py" />
            <source>whole receiver</source>
            <translation>récepteur entier</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/regions.py" />
            <source>lit area of the target</source>
            <translation>zone éclairée de la cible</translation>
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
            <source>optical trains have no such error</source>
            <translation>les trains optiques n’ont pas cette erreur</translation>
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
            <source>{size:g}; at least 0, less than {limit:g}, {otherwise}</source>
            <translation>{size:g} ; au moins 0, moins de {limit:g}, {otherwise}</translation>
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
            <location filename="../../workbench/analysis/validation.py" />
            <source>no light of this lens reaches the screen, so there is no image to judge</source>
            <translation>aucune lumière de cette lentille n'atteint l'écran : il n'y a pas d'image à juger</translation>
        </message>
        <message>
            <location filename="../../workbench/analysis/validation.py" />
            <source>{what} scatters the light: random rays are used</source>
            <translation>{what} diffuse la lumière : des rayons aléatoires sont utilisés</translation>
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
            <location filename="../../workbench/design/bounds.py" />
            <source>heights within {most:.3g} {unit} of the base</source>
            <translation>hauteurs à {most:.3g} {unit} au plus de la base</translation>
        </message>
        <message>
            <location filename="../../workbench/design/checks.py" />
            <source>light grazes the far side of the screen, at {slant:.0f} degrees from across it, where the image is less exact; turn the screen towards the lens, or move its middle nearer to the axis</source>
            <translation>la lumière rase le côté lointain de l'écran, à {slant:.0f} degrés de la perpendiculaire, où l'image est moins exacte ; tournez l'écran vers la lentille, ou rapprochez son milieu de l'axe</translation>
        </message>
        <message>
            <location filename="../../workbench/design/checks.py" />
            <source>light grazes the far side of the far field, at {slant:.0f} degrees from across it, where the image is less exact; turn the far field towards the lens, or move its middle nearer to the axis</source>
            <translation>la lumière rase le côté lointain du champ lointain, à {slant:.0f} degrés de la perpendiculaire, où l'image est moins exacte ; tournez le champ lointain vers la lentille, ou rapprochez son milieu de l'axe</translation>
        </message>
        <message>
            <location filename="../../workbench/design/checks.py" />
            <source>light grazes the far side of the screen, at {slant:.0f} degrees from across it, where the image is less exact; turn the screen towards the mirror, or move its middle nearer to the axis</source>
            <translation>la lumière rase le côté lointain de l'écran, à {slant:.0f} degrés de la perpendiculaire, où l'image est moins exacte ; tournez l'écran vers le miroir, ou rapprochez son milieu de l'axe</translation>
        </message>
        <message>
            <location filename="../../workbench/design/checks.py" />
            <source>light grazes the far side of the far field, at {slant:.0f} degrees from across it, where the image is less exact; turn the far field towards the mirror, or move its middle nearer to the axis</source>
            <translation>la lumière rase le côté lointain du champ lointain, à {slant:.0f} degrés de la perpendiculaire, où l'image est moins exacte ; tournez le champ lointain vers le miroir, ou rapprochez son milieu de l'axe</translation>
        </message>
        <message>
            <location filename="../../workbench/design/checks.py" />
            <source>the picture is mirror-inverted for viewers on the side of the light, and reads right from behind the screen; target.viewed_from "front" turns it around</source>
            <translation>l'image est inversée pour qui regarde du côté de la lumière, et se lit à l'endroit de derrière l'écran ; target.viewed_from "front" la retourne</translation>
        </message>
        <message>
            <location filename="../../workbench/design/checks.py" />
            <source>the picture is mirror-inverted for viewers on the side of the light, and reads right from behind the far field; target.viewed_from "front" turns it around</source>
            <translation>l'image est inversée pour qui regarde du côté de la lumière, et se lit à l'endroit de derrière le champ lointain ; target.viewed_from "front" la retourne</translation>
        </message>
        <message>
            <location filename="../../workbench/design/checks.py" />
            <source>The image stays {error:.0f} % off: {n_u} × {n_v} control points are too few for the detail of this target. {finer_u} × {finer_v}, the automatic choice, can show it.</source>
            <translation>L'image reste à {error:.0f} % d'écart : {n_u} × {n_v} points de contrôle sont trop peu pour le détail de cette cible. {finer_u} × {finer_v}, le choix automatique, peuvent le montrer.</translation>
        </message>
        <message>
            <location filename="../../workbench/design/images.py" />
            <source>mean error over {count} set-ups {error:.2f} %</source>
            <translation>erreur moyenne sur {count} montages {error:.2f} %</translation>
        </message>
        <message>
            <location filename="../../workbench/design/lens_blur.py" />
            <source>its light is blurred over {x:.3g} × {y:.3g} pixels</source>
            <translation>la lumière est étalée sur {x:.3g} × {y:.3g} pixels</translation>
        </message>
        <message>
            <location filename="../../workbench/design/limits.py" />
            <source>widen the height range, or leave it out</source>
            <translation>élargir la plage de hauteur, ou l'omettre</translation>
        </message>
        <message>
            <location filename="../../workbench/design/limits.py" />
            <source>thicker stock, or a smaller minimal thickness, lets the lens bend more</source>
            <translation>un brut plus épais, ou une épaisseur minimale plus petite, permet à la lentille de dévier davantage</translation>
        </message>
        <message>
            <location filename="../../workbench/design/limits.py" />
            <source>raise the base, or lower the minimal thickness</source>
            <translation>relevez la base ou réduisez l'épaisseur minimale</translation>
        </message>
        <message>
            <location filename="../../workbench/design/limits.py" />
            <source>move the screen away from the lens</source>
            <translation>éloigner l'écran de la lentille</translation>
        </message>
        <message>
            <location filename="../../workbench/design/limits.py" />
            <source>widen the entrance range</source>
            <translation>élargir la plage d'entrée</translation>
        </message>
        <message>
            <location filename="../../workbench/design/limits.py" />
            <source>The entrance face fills {part:.0f} % of its automatic range of {range} {unit}</source>
            <translation>La face d'entrée occupe {part:.0f} % de sa plage automatique de {range} {unit}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/limits.py" />
            <source>The entrance face fills {part:.0f} % of its range of {range} {unit}, and would bend more of the light in a wider one</source>
            <translation>La face d'entrée remplit {part:.0f} % de sa plage de {range} {unit}, et dévierait davantage de lumière dans une plage plus large</translation>
        </message>
        <message>
            <location filename="../../workbench/design/limits.py" />
            <source>{part:.0f} % of the control heights are at the minimal thickness of {thinnest:.3g} {unit}</source>
            <translation>{part:.0f} % des hauteurs de contrôle sont à l'épaisseur minimale de {thinnest:.3g} {unit}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/limits.py" />
            <source>{range} {unit} is the automatic limit</source>
            <translation>{range} {unit} est la limite automatique</translation>
        </message>
        <message>
            <location filename="../../workbench/design/limits.py" />
            <source>{range} {unit} is allowed</source>
            <translation>la limite est de {range} {unit}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/limits.py" />
            <source>{part:.0f} % of the control heights are at an end of their range; {allowed}</source>
            <translation>{part:.0f} % des hauteurs de contrôle sont à une extrémité de leur plage ; {allowed}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/limits.py" />
            <source>The lens needs {range} {unit}; {allowed}</source>
            <translation>La lentille a besoin de {range} {unit} ; {allowed}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/limits.py" />
            <source>The mirror needs {range} {unit}; {allowed}</source>
            <translation>Le miroir a besoin de {range} {unit} ; {allowed}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/limits.py" />
            <source>{thickest:.3g} {unit} is the automatic limit</source>
            <translation>{thickest:.3g} {unit} est la limite automatique</translation>
        </message>
        <message>
            <location filename="../../workbench/design/limits.py" />
            <source>the screen allows {thickest:.3g} {unit}</source>
            <translation>l'écran permet {thickest:.3g} {unit}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/limits.py" />
            <source>the stock allows {thickest:.3g} {unit}</source>
            <translation>le brut permet {thickest:.3g} {unit}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/limits.py" />
            <source>{part:.0f} % of the control heights are at the largest thickness; {allowed}</source>
            <translation>{part:.0f} % des hauteurs de contrôle sont à la plus grande épaisseur ; {allowed}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/limits.py" />
            <source>The lens needs to be {needed:.3g} {unit} thick; {allowed}</source>
            <translation>La lentille devrait avoir une épaisseur de {needed:.3g} {unit} ; {allowed}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/limits.py" />
            <source>The mirror needs to be {needed:.3g} {unit} thick; {allowed}</source>
            <translation>Le miroir devrait avoir une épaisseur de {needed:.3g} {unit} ; {allowed}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/limits.py" />
            <source>{sentence}: {cure}</source>
            <translation>{sentence} : {cure}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/limits.py" />
            <source>{field}: {reason}</source>
            <translation>{field} : {reason}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/limits.py" />
            <source>set {field} to a larger thickness</source>
            <translation>donner à {field} une épaisseur plus grande</translation>
        </message>
        <message>
            <location filename="../../workbench/design/limits.py" />
            <source>set {field} to a wider range</source>
            <translation>donner à {field} une plage plus large</translation>
        </message>
        <message>
            <location filename="../../workbench/design/limits.py" />
            <source>±{high:.3g}</source>
            <translation>±{high:.3g}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/limits.py" />
            <source>{low:.3g} to {high:.3g}</source>
            <translation>{low:.3g} à {high:.3g}</translation>
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
            <location filename="../../workbench/design/net.py" />
            <source>'{name}' has {count:,} parameters here and needs {needed} for them, their gradient and Adam's moments; {available} are free</source>
            <translation>'{name}' a ici {count:,} paramètres et demande {needed} pour eux, leur gradient et les moments d'Adam ; {available} sont libres</translation>
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
            <location filename="../../workbench/design/paper.py" />
            <source>the paper's method designs for the exact set-up; method 'auto'</source>
            <translation>la méthode de l'article conçoit pour le montage exact ; méthode 'auto'</translation>
        </message>
        <message>
            <location filename="../../workbench/design/run.py" />
            <source>the graphics card has too little free memory; compute on the processor, or take fewer pixels</source>
            <translation>la carte graphique a trop peu de mémoire libre ; calculez sur le processeur, ou prenez moins de pixels</translation>
        </message>
        <message>
            <location filename="../../workbench/design/run.py" />
            <source>none of its light goes to the lens; turn or move it</source>
            <translation>aucune de sa lumière ne va vers la lentille ; tournez-la ou déplacez-la</translation>
        </message>
        <message>
            <location filename="../../workbench/design/run.py" />
            <source>none of its light goes to the mirror; turn or move it</source>
            <translation>aucune de sa lumière ne va vers le miroir ; tournez-la ou déplacez-la</translation>
        </message>
        <message>
            <location filename="../../workbench/design/run.py" />
            <source>the control heights of the fixed face are missing; a file (.npy)</source>
            <translation>les hauteurs de contrôle de la face fixe manquent ; un fichier (.npy)</translation>
        </message>
        <message>
            <location filename="../../workbench/design/run.py" />
            <source>{net} are not the control points of the finished lens that are locked; leave the stage's net out or unlock them</source>
            <translation>{net} ne sont pas les points de contrôle de la lentille finie, qui sont verrouillés ; omettez le réseau de l'étape ou déverrouillez-les</translation>
        </message>
        <message>
            <location filename="../../workbench/design/run.py" />
            <source>{net} are not the control points of the finished mirror that are locked; leave the stage's net out or unlock them</source>
            <translation>{net} ne sont pas les points de contrôle du miroir fini, qui sont verrouillés ; omettez le réseau de l'étape ou déverrouillez-les</translation>
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
            <location filename="../../workbench/design/task.py" />
            <source>absent</source>
            <translation>absent</translation>
        </message>
        <message>
            <location filename="../../workbench/design/task.py" />
            <source>not designed yet</source>
            <translation>pas encore conçu</translation>
        </message>
        <message>
            <location filename="../../workbench/design/task.py" />
            <source>designed for this task</source>
            <translation>conçu pour cette tâche</translation>
        </message>
        <message>
            <location filename="../../workbench/design/task.py" />
            <source>designed for another task ({run}): {differences}</source>
            <translation>conçu pour une autre tâche ({run}) : {differences}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/task.py" />
            <source>not designed for this task</source>
            <translation>non conçu pour cette tâche</translation>
        </message>
        <message>
            <location filename="../../workbench/design/task.py" />
            <source>{path} {then}, now {now}</source>
            <translation>{path} {then}, maintenant {now}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/task.py" />
            <source>another target image</source>
            <translation>une autre image cible</translation>
        </message>
        <message>
            <location filename="../../workbench/design/transport/entrance.py" />
            <source>rim</source>
            <translation>bord</translation>
        </message>
        <message>
            <location filename="../../workbench/design/transport/entrance.py" />
            <source>left and right sides</source>
            <translation>côtés gauche et droit</translation>
        </message>
        <message>
            <location filename="../../workbench/design/transport/entrance.py" />
            <source>top and bottom</source>
            <translation>bords supérieur et inférieur</translation>
        </message>
        <message>
            <location filename="../../workbench/design/transport/entrance.py" />
            <source>{part:.0f} % with a hollow one (conic of radius {radius:.3g})</source>
            <translation>{part:.0f} % avec une face creuse (conique de rayon {radius:.3g})</translation>
        </message>
        <message>
            <location filename="../../workbench/design/transport/entrance.py" />
            <source>{part:.0f} % with a freeform one</source>
            <translation>{part:.0f} % avec une face de forme libre</translation>
        </message>
        <message>
            <location filename="../../workbench/design/transport/entrance.py" />
            <source>{part:.0f} % with a plane entrance face</source>
            <translation>{part:.0f} % avec une face d'entrée plane</translation>
        </message>
        <message>
            <location filename="../../workbench/design/transport/entrance.py" />
            <source>towards the {side} of the screen deflections up to {turn:.0f} degrees are needed, of which the exit face makes less than {most:.0f}: it would reflect {part:.0f} % of the light</source>
            <translation>du côté « {side} » de l'écran, des déviations jusqu'à {turn:.0f} degrés sont nécessaires, dont la face de sortie fait moins de {most:.0f} : elle réfléchirait {part:.0f} % de la lumière</translation>
        </message>
        <message>
            <location filename="../../workbench/design/transport/entrance.py" />
            <source>towards the {side} of the far field deflections up to {turn:.0f} degrees are needed, of which the exit face makes less than {most:.0f}: it would reflect {part:.0f} % of the light</source>
            <translation>du côté « {side} » du champ lointain, des déviations jusqu'à {turn:.0f} degrés sont nécessaires, dont la face de sortie fait moins de {most:.0f} : elle réfléchirait {part:.0f} % de la lumière</translation>
        </message>
        <message>
            <location filename="../../workbench/design/transport/entrance.py" />
            <source>{why}; a smaller or farther target needs less, and no other entrance face helps</source>
            <translation>{why} ; une cible plus petite ou plus lointaine en demande moins, et aucune autre face d'entrée n'aide</translation>
        </message>
        <message>
            <location filename="../../workbench/design/transport/entrance.py" />
            <source>{why}. The lens can send to its place at best: {faces}. Set {field}, or use a smaller or farther target</source>
            <translation>{why}. La lentille peut envoyer à sa place au mieux : {faces}. Réglez {field}, ou choisissez une cible plus petite ou plus lointaine</translation>
        </message>
        <message>
            <location filename="../../workbench/design/transport/first_design.py" />
            <source>both faces</source>
            <translation>les deux faces</translation>
        </message>
        <message>
            <location filename="../../workbench/design/transport/first_design.py" />
            <source>the exit face alone</source>
            <translation>la face de sortie seule</translation>
        </message>
        <message>
            <location filename="../../workbench/design/transport/first_design.py" />
            <source>both faces along lines through all images</source>
            <translation>les deux faces le long de lignes à travers toutes les images</translation>
        </message>
        <message>
            <location filename="../../workbench/design/transport/first_design.py" />
            <source>the exit face behind a hollow entrance face</source>
            <translation>la face de sortie derrière une face d'entrée creuse</translation>
        </message>
        <message>
            <location filename="../../workbench/design/transport/first_design.py" />
            <source>the entrance face for image {number} alone</source>
            <translation>la face d'entrée pour l'image {number} seule</translation>
        </message>
        <message>
            <location filename="../../workbench/design/transport/first_design.py" />
            <source>the exit face for image {number} alone</source>
            <translation>la face de sortie pour l'image {number} seule</translation>
        </message>
        <message>
            <location filename="../../workbench/design/transport/first_design.py" />
            <source>{error} % by {face}</source>
            <translation>{error} % pour {face}</translation>
        </message>
        <message>
            <location filename="../../workbench/design/transport/first_design.py" />
            <source>first design: {tried}; it begins with {best}</source>
            <translation>première conception : {tried} ; retenu : {best}</translation>
        </message>
        <message>
            <location filename="../../workbench/extended/bound.py" />
            <source>Other elements, or a tilt, change the blur</source>
            <translation>D’autres éléments, ou une inclinaison, changent le flou</translation>
        </message>
        <message>
            <location filename="../../workbench/extended/bound.py" />
            <source>Each of several images may be worse than alone</source>
            <translation>Chacune de plusieurs images peut être moins bonne que seule</translation>
        </message>
        <message>
            <location filename="../../workbench/extended/bound.py" />
            <source>Rays of a file need not come evenly from one place</source>
            <translation>Les rayons d’un fichier ne viennent pas forcément d’un seul endroit, uniformément</translation>
        </message>
        <message>
            <location filename="../../workbench/extended/bound.py" />
            <source>A lamp so near is blurred less by the rim of the lens than by its middle</source>
            <translation>Une lampe si proche est moins floutée par le bord de la lentille que par son milieu</translation>
        </message>
        <message>
            <location filename="../../workbench/extended/bound.py" />
            <source>A curved entrance face can make the image of the source smaller</source>
            <translation>Une face d’entrée courbe peut réduire l’image de la source</translation>
        </message>
        <message>
            <location filename="../../workbench/extended/relief_blur.py" />
            <source>relief of manufacture blurs it over {x:.3g} × {y:.3g} pixels</source>
            <translation>le relief de fabrication le floute sur {x:.3g} × {y:.3g} pixels</translation>
        </message>
        <message>
            <location filename="../../workbench/extended/scattering.py" />
            <source>light of a diffuser on {kind} cannot be computed; use a plane or a far field</source>
            <translation>la lumière d'un diffuseur sur {kind} ne peut pas être calculée ; utiliser un plan ou un champ lointain</translation>
        </message>
        <message>
            <location filename="../../workbench/extended/scattering.py" />
            <source>the diffuser blurs it over {x:.3g} × {y:.3g} pixels</source>
            <translation>le diffuseur l'étale sur {x:.3g} × {y:.3g} pixels</translation>
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
            <source>holds a value that is NaN or infinite; finite values are needed</source>
            <translation>contient une valeur NaN ou infinie ; il faut des valeurs finies</translation>
        </message>
        <message>
            <location filename="../../workbench/files/entries.py" />
            <source>holds a value that is neither 0 nor 1; false or true is needed</source>
            <translation>contient une valeur qui n'est ni 0 ni 1 ; il faut faux ou vrai</translation>
        </message>
        <message>
            <location filename="../../workbench/files/entries.py" />
            <source>holds {dtype}; {kind} is needed</source>
            <translation>contient {dtype} ; il faut {kind}</translation>
        </message>
        <message>
            <location filename="../../workbench/files/entries.py" />
            <source>has shape {found}; the scene needs {shape}</source>
            <translation>est de forme {found} ; la scène demande {shape}</translation>
        </message>
        <message>
            <location filename="../../workbench/files/entries.py" />
            <source>is in Fortran order; C order is needed</source>
            <translation>est dans l'ordre Fortran ; il faut l'ordre C</translation>
        </message>
        <message>
            <location filename="../../workbench/files/entries.py" />
            <source>has {given} bytes of values; shape {shape} needs {size}</source>
            <translation>a {given} octets de valeurs ; la forme {shape} en demande {size}</translation>
        </message>
        <message>
            <location filename="../../workbench/files/entries.py" />
            <source>is no .npy array: its header cannot be read</source>
            <translation>n'est pas un tableau .npy : son en-tête est illisible</translation>
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
            <location filename="../../workbench/files/export/cut_plan.py" />
            <source>a ball cutter of {radius} does not fit: it leaves {left} at x = {x}, y = {y} and cuts off {cut}; {cure}</source>
            <translation>une fraise hémisphérique de {radius} ne convient pas : elle laisse {left} en x = {x}, y = {y} et enlève {cut} de trop ; {cure}</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/cut_plan.py" />
            <source>one of {fitting} fits</source>
            <translation>une de {fitting} convient</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/cut_plan.py" />
            <source>a smaller one or higher ridges are needed</source>
            <translation>il en faut une plus petite, ou des crêtes plus hautes</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/cut_plan.py" />
            <source>a cutter of {radius} is wider than the part; at most {half}</source>
            <translation>une fraise de {radius} est plus large que la pièce ; au plus {half}</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/cut_plan.py" />
            <source>{stock} is too thin for the part; at least {needed}</source>
            <translation>{stock} est trop mince pour la pièce ; au moins {needed}</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/cut_plan.py" />
            <source>{stock} is too thin: cuts at the rim go {deep} deep; at least that</source>
            <translation>{stock} est trop mince : les passes au bord vont à {deep} de profondeur ; au moins autant</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/cut_plan.py" />
            <source>{step} makes {levels:,.0f} levels, more than a program holds; a larger one</source>
            <translation>{step} donne {levels:,.0f} niveaux, plus qu’un programme n’en contient ; une valeur plus grande</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/design.py" />
            <source>{side:g} {unit} about ({x:g}, {y:g}) is not within the lens</source>
            <translation>{side:g} {unit} autour de ({x:g}, {y:g}) n'est pas dans la lentille</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/design.py" />
            <source>{side:g} {unit} about ({x:g}, {y:g}) is not within the mirror</source>
            <translation>{side:g} {unit} autour de ({x:g}, {y:g}) n'est pas dans le miroir</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/design.py" />
            <source>a conic front face of the designed element is not exported; a plane one</source>
            <translation>une face avant conique de l'élément conçu n'est pas exportée ; une plane</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/far_light.py" />
            <source>no light leaves its {body}, so that it has no intensity</source>
            <translation>aucune lumière ne quitte le {body}, il n'a donc pas d'intensité</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/formats.py" />
            <source>has no known ending; use one of {endings}</source>
            <translation>n'a pas d'extension connue ; l'une de {endings}</translation>
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
            <source>a standard cutter is chosen as well; give one of them</source>
            <translation>une fraise courante est aussi choisie ; indiquer l’une des deux</translation>
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
            <location filename="../../workbench/files/export/turning.py" />
            <source>{feed} takes {points:,} points, more than {most:,}; a larger one, or fewer points per turn</source>
            <translation>{feed} demande {points:,} points, plus que {most:,} ; une valeur plus grande, ou moins de points par tour</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/turning.py" />
            <source>a nose of {radius} does not fit: it cuts off {cut}; a smaller one</source>
            <translation>un bec de {radius} ne passe pas : il coupe {cut} ; un plus petit</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/write.py" />
            <source>the entrance face is not freeform, so it has no file</source>
            <translation>la face d'entrée n'est pas de forme libre et n'a pas de fichier</translation>
        </message>
        <message>
            <location filename="../../workbench/files/export/write.py" />
            <source>{name} is no designed element; {names}</source>
            <translation>{name} n’est pas un élément conçu ; {names}</translation>
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
            <location filename="../../workbench/files/scene.py" />
            <source>is given twice; each field can be there once</source>
            <translation>est donné deux fois ; chaque champ peut y être une fois</translation>
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
            <location filename="../../workbench/geometry/as_made.py" />
            <source>a diffuser</source>
            <translation>un diffuseur</translation>
        </message>
        <message>
            <location filename="../../workbench/geometry/as_made.py" />
            <source>the relief that manufacture leaves</source>
            <translation>le relief que laisse la fabrication</translation>
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
            <location filename="../../workbench/jobs/lenses.py" />
            <source>more than {least:g}, as light fades</source>
            <translation>plus de {least:g}, car la lumière diminue</translation>
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
            <source>From a coarse design of this task.</source>
            <translation>D'après une conception grossière de cette tâche.</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>No flux arrives in a coarse design of this task.</source>
            <translation>Aucun flux n'arrive dans une conception grossière de cette tâche.</translation>
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
            <source>From a coarse design of this task, with losses and source size.</source>
            <translation>D'après une conception grossière de cette tâche, avec pertes et taille de source.</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>Finest detail</source>
            <translation>Détail le plus fin</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>The source has no size.</source>
            <translation>La source est sans étendue.</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>{across:.0f} × {up:.0f} dots in the image.</source>
            <translation>{across:.0f} × {up:.0f} points dans l'image.</translation>
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
            <source>{law}: limit of sharpness, which ray tracing does not include.</source>
            <translation>{law} : limite de netteté, que le tracé de rayons n'inclut pas.</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>Largest slope</source>
            <translation>Plus grande pente</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>{slope:.0f}°, deflection up to {turn:.0f}°</source>
            <translation>{slope:.0f}°, déviation jusqu'à {turn:.0f}°</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>a deflection of {turn:.0f}° would be needed</source>
            <translation>une déviation de {turn:.0f}° serait nécessaire</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>The lens deflects by {most:.0f}° at most. Use a smaller image, more distance or another source position.</source>
            <translation>La lentille dévie de {most:.0f}° au plus. Utilisez une image plus petite, plus de distance ou une autre position de source.</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>The mirror deflects by {most:.0f}° at most. Use a smaller image, more distance or another source position.</source>
            <translation>Le miroir dévie de {most:.0f}° au plus. Utilisez une image plus petite, plus de distance ou une autre position de source.</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>Near the limit of {most:.0f}° much light is reflected.</source>
            <translation>Près de la limite de {most:.0f}°, beaucoup de lumière est réfléchie.</translation>
        </message>
        <message>
            <location filename="../../workbench/jobs/prospect.py" />
            <source>Limit of the deflection: {most:.0f}°.</source>
            <translation>Limite de la déviation : {most:.0f}°.</translation>
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
            <source>not known; {error} for the light found</source>
            <translation>inconnu ; {error} avec la lumière trouvée</translation>
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
            <source>Can be changed later in the window.</source>
            <translation>Modifiable plus tard dans la fenêtre.</translation>
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
            <location filename="../../workbench/measured/lamps.py" />
            <source>{value} {unit}</source>
            <translation>{value} {unit}</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/photometry/__init__.py" />
            <source>is no photometric file; {endings} is needed</source>
            <translation>n'est pas un fichier photométrique ; il faut {endings}</translation>
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
            <source>its version is {found!r}; known are {known}</source>
            <translation>sa version est {found!r} ; connues : {known}</translation>
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
            <location filename="../../workbench/measured/rays/__init__.py" />
            <source>cannot be used: {problem}</source>
            <translation>ne peut pas être utilisé : {problem}</translation>
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
            <location filename="../../workbench/measured/surfaces/__init__.py" />
            <source>is no measured surface; {endings} are known</source>
            <translation>n'est pas une surface mesurée ; formats connus : {endings}</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/surfaces/esri.py" />
            <source>its header has no ncols, nrows and cellsize</source>
            <translation>son en-tête n'a pas ncols, nrows et cellsize</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/surfaces/esri.py" />
            <source>it has {found} heights; {columns} × {rows} are needed</source>
            <translation>il a {found} hauteurs ; il en faut {columns} × {rows}</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/surfaces/picture.py" />
            <source>it is damaged or incomplete: {why}</source>
            <translation>il est endommagé ou incomplet : {why}</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/surfaces/picture.py" />
            <source>it has {mode} pixels; grey of 16 bits or floats are needed</source>
            <translation>il a des pixels {mode} ; il faut du gris à 16 bits ou des nombres à virgule flottante</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/surfaces/picture.py" />
            <source>it has no scale; give the size of a pixel and the heights</source>
            <translation>il n'a pas d'échelle ; indiquez la taille d'un pixel et les hauteurs</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/surfaces/points.py" />
            <source>it has {count} points with a height; at least {least} are needed</source>
            <translation>il a {count} points avec une hauteur ; il en faut au moins {least}</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/surfaces/points.py" />
            <source>it has {columns} × {rows} points; 1 to {most} million are possible</source>
            <translation>il a {columns} × {rows} points ; 1 à {most} millions sont possibles</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/surfaces/sdf.py" />
            <source>it begins neither with aISO-1.0 nor with bISO-1.0</source>
            <translation>il ne commence ni par aISO-1.0 ni par bISO-1.0</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/surfaces/sdf.py" />
            <source>it is compressed; save it without compression</source>
            <translation>il est compressé ; enregistrez-le sans compression</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/surfaces/sdf.py" />
            <source>its DataType is {found}; 0 to 7 are known</source>
            <translation>son DataType est {found} ; 0 à 7 sont connus</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/surfaces/sdf.py" />
            <source>it is cut off</source>
            <translation>il est tronqué</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/surfaces/sdf.py" />
            <source>it has no line * behind its header</source>
            <translation>il n'a pas de ligne * après son en-tête</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/surfaces/sdf.py" />
            <source>its header has no {name}</source>
            <translation>son en-tête n'a pas {name}</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/surfaces/sdf.py" />
            <source>its Xscale, Yscale and Zscale are not all greater than 0</source>
            <translation>ses Xscale, Yscale et Zscale ne sont pas tous supérieurs à 0</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/surfaces/stl.py" />
            <source>a vertex of it has a value that is no finite number</source>
            <translation>un de ses sommets a une valeur qui n'est pas un nombre fini</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/surfaces/stl.py" />
            <source>no smooth part of its mesh has {least} vertices</source>
            <translation>aucune partie lisse de son maillage n'a {least} sommets</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/surfaces/stl.py" />
            <source>it has {count} triangles; 1 to {most} million are possible</source>
            <translation>il a {count} triangles ; 1 à {most} millions sont possibles</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/surfaces/table.py" />
            <source>no line of it begins with three numbers x, y and z</source>
            <translation>aucune de ses lignes ne commence par trois nombres x, y et z</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/surfaces/table.py" />
            <source>it has more than {most} million points</source>
            <translation>il a plus de {most} millions de points</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/surfaces/table.py" />
            <source>its line {number} has no x, y and z: {line!r}</source>
            <translation>sa ligne {number} n'a pas x, y et z : {line!r}</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/surfaces/x3p.py" />
            <source>its entry {name} is too long</source>
            <translation>son entrée {name} est trop longue</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/surfaces/x3p.py" />
            <source>its main.xml has no {path}</source>
            <translation>son main.xml n'a pas {path}</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/surfaces/x3p.py" />
            <source>its axis {axis} has no values</source>
            <translation>son axe {axis} n'a pas de valeurs</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/surfaces/x3p.py" />
            <source>its DataType is {found!r}; I, L, F, D are known</source>
            <translation>son DataType est {found!r} ; I, L, F, D sont connus</translation>
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
            <source>it goes on behind its end</source>
            <translation>il continue après sa fin</translation>
        </message>
        <message>
            <location filename="../../workbench/measured/text.py" />
            <source>has more than {most} MB, too many for such a file</source>
            <translation>a plus de {most} Mo, trop pour un tel fichier</translation>
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
            <location filename="../../workbench/optics/paths.py" />
            <source>{face} of {element}</source>
            <translation>{face} de {element}</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/paths.py" />
            <source>{part} % of the light is totally reflected at the {face}, most of it around x = {x}, y = {y}</source>
            <translation>{part} % de la lumière est totalement réfléchie sur la {face}, surtout autour de x = {x}, y = {y}</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/plan.py" />
            <source>fused kernels, {threads} threads, {precision}</source>
            <translation>noyaux compilés, {threads} fils d'exécution, {precision}</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/plan.py" />
            <source>fused kernels, 1 thread, {precision}</source>
            <translation>noyaux compilés, 1 fil d'exécution, {precision}</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/plan.py" />
            <source>reference in torch on {device}, {precision}</source>
            <translation>référence en torch sur {device}, {precision}</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/plan.py" />
            <source>no kernel for this path ({faces}): by the reference alone</source>
            <translation>aucun noyau pour ce chemin ({faces}) : par la référence seule</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/plan.py" />
            <source>float64: float32 has too few digits for this scene</source>
            <translation>float64 : float32 a trop peu de chiffres pour cette scène</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/plan.py" />
            <source>the kernel could not be compiled ({error}), so this run is many times slower</source>
            <translation>le noyau n'a pas pu être compilé ({error}), cette exécution est donc bien plus lente</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/plan.py" />
            <source>compiled kernels could not be kept ({reason}), so each start compiles them again</source>
            <translation>les noyaux compilés n'ont pas pu être conservés ({reason}), chaque démarrage les compile donc à nouveau</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/plan.py" />
            <source>box filter: one pixel a ray, no ghost pixels</source>
            <translation>filtre boîte : un pixel par rayon, pas de pixels fantômes</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/plan.py" />
            <source>{count} lines of light, each with its own refractive indices</source>
            <translation>{count} raies, chacune avec ses propres indices</translation>
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
            <location filename="../../workbench/optics/train/entries.py" />
            <source>collimated light: entrance refraction and intersection left out</source>
            <translation>lumière collimatée : réfraction à l’entrée et recherche d’intersection omises</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/train/incident.py" />
            <source>mirror symmetry: a quarter of the rays</source>
            <translation>symétrie miroir : un quart des rayons</translation>
        </message>
        <message>
            <location filename="../../workbench/optics/train/incident.py" />
            <source>mirror symmetry: half of the rays</source>
            <translation>symétrie miroir : la moitié des rayons</translation>
        </message>
        <message>
            <location filename="../../workbench/option_groups.py" />
            <source>{value}; one of {known}</source>
            <translation>{value} ; l’un de {known}</translation>
        </message>
        <message>
            <location filename="../../workbench/option_groups.py" />
            <source>{value:g}; from {least:g} to {most:,}</source>
            <translation>{value:g} ; de {least:g} à {most:,}</translation>
        </message>
        <message>
            <location filename="../../workbench/option_groups.py" />
            <source>{value:g} {unit}; from {least:g} to {most:,} {unit}</source>
            <translation>{value:g} {unit} ; de {least:g} à {most:,} {unit}</translation>
        </message>
        <message>
            <location filename="../../workbench/option_groups.py" />
            <source>{value:g}; a finite number is needed</source>
            <translation>{value:g} ; il faut un nombre fini</translation>
        </message>
        <message>
            <location filename="../../workbench/option_groups.py" />
            <source>{value:g}; a length above 0</source>
            <translation>{value:g} ; une longueur supérieure à 0</translation>
        </message>
        <message>
            <location filename="../../workbench/option_groups.py" />
            <source>{value:g}; a length of 0 or more</source>
            <translation>{value:g} ; une longueur de 0 ou plus</translation>
        </message>
        <message>
            <location filename="../../workbench/pictures/comparison.py" />
            <source>Second minus first</source>
            <translation>Second moins premier</translation>
        </message>
        <message>
            <location filename="../../workbench/pictures/comparison.py" />
            <source>The receivers differ: no difference image.</source>
            <translation>Les récepteurs diffèrent : pas d'image de différence.</translation>
        </message>
        <message>
            <location filename="../../workbench/pictures/error_curves.py" />
            <source>z of the screen</source>
            <translation>z de l'écran</translation>
        </message>
        <message>
            <location filename="../../workbench/pictures/error_curves.py" />
            <source>error</source>
            <translation>erreur</translation>
        </message>
        <message>
            <location filename="../../workbench/pictures/error_curves.py" />
            <source>relative L2 error</source>
            <translation>erreur L2 relative</translation>
        </message>
        <message>
            <location filename="../../workbench/pictures/error_curves.py" />
            <source>lenses up to there</source>
            <translation>lentilles jusque-là</translation>
        </message>
        <message>
            <location filename="../../workbench/pictures/error_curves.py" />
            <source>error in the exact set-up</source>
            <translation>erreur dans le montage exact</translation>
        </message>
        <message>
            <location filename="../../workbench/pictures/error_curves.py" />
            <source>mean error over what is uncertain</source>
            <translation>erreur moyenne sur ce qui est incertain</translation>
        </message>
        <message>
            <location filename="../../workbench/pictures/handles.py" />
            <source>move the source</source>
            <translation>déplacer la source</translation>
        </message>
        <message>
            <location filename="../../workbench/pictures/handles.py" />
            <source>move the element</source>
            <translation>déplacer l'élément</translation>
        </message>
        <message>
            <location filename="../../workbench/pictures/handles.py" />
            <source>change the thickness</source>
            <translation>changer l'épaisseur</translation>
        </message>
        <message>
            <location filename="../../workbench/pictures/handles.py" />
            <source>move the screen</source>
            <translation>déplacer l'écran</translation>
        </message>
        <message>
            <location filename="../../workbench/pictures/handles.py" />
            <source>source</source>
            <translation>source</translation>
        </message>
        <message>
            <location filename="../../workbench/pictures/loss.py" />
            <source>this run</source>
            <translation>cette exécution</translation>
        </message>
        <message>
            <location filename="../../workbench/pictures/loss.py" />
            <source>verified</source>
            <translation>vérifié</translation>
        </message>
        <message>
            <location filename="../../workbench/pictures/loss.py" />
            <source>iteration</source>
            <translation>itération</translation>
        </message>
        <message>
            <location filename="../../workbench/pictures/loss.py" />
            <source>loss</source>
            <translation>coût</translation>
        </message>
        <message>
            <location filename="../../workbench/pictures/part/inspection.py" />
            <source>residual as measured</source>
            <translation>écart tel que mesuré</translation>
        </message>
        <message>
            <location filename="../../workbench/pictures/part/inspection.py" />
            <source>resolved residual</source>
            <translation>écart résolu</translation>
        </message>
        <message>
            <location filename="../../workbench/pictures/part/inspection.py" />
            <source>repeats</source>
            <translation>se répète</translation>
        </message>
        <message>
            <location filename="../../workbench/pictures/part/photograph.py" />
            <source>1 = mean</source>
            <translation>1 = moyenne</translation>
        </message>
        <message>
            <location filename="../../workbench/pictures/part/photograph.py" />
            <source>photograph, rectified</source>
            <translation>photographie redressée</translation>
        </message>
        <message>
            <location filename="../../workbench/pictures/part/photograph.py" />
            <source>prediction with causes</source>
            <translation>prédiction avec les causes</translation>
        </message>
        <message>
            <location filename="../../workbench/pictures/part/photograph.py" />
            <source>photograph less prediction</source>
            <translation>photographie moins prédiction</translation>
        </message>
        <message>
            <location filename="../../workbench/pictures/section.py" />
            <source>target</source>
            <translation>cible</translation>
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
            <source>error as designed</source>
            <translation>erreur telle que conçue</translation>
        </message>
        <message>
            <location filename="../../workbench/report/figures.py" />
            <source>{error}, {change:+.3f} percentage points by this process ({interval})</source>
            <translation>{error}, {change:+.3f} points de pourcentage par ce procédé ({interval})</translation>
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
            <source>{error} ({interval})</source>
            <translation>{error} ({interval})</translation>
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
            <location filename="../../workbench/report/findings.py" />
            <source>There is no lens yet.</source>
            <translation>Il n'y a pas encore de lentille.</translation>
        </message>
        <message>
            <location filename="../../workbench/report/findings.py" />
            <source>There is no mirror yet.</source>
            <translation>Il n'y a pas encore de miroir.</translation>
        </message>
        <message>
            <location filename="../../workbench/report/findings.py" />
            <source>{error} computed error, not verified yet</source>
            <translation>{error} d'erreur calculée, pas encore vérifiée</translation>
        </message>
        <message>
            <location filename="../../workbench/report/findings.py" />
            <source>{error} computed error as made, not verified yet</source>
            <translation>{error} d'erreur calculée après fabrication, pas encore vérifiée</translation>
        </message>
        <message>
            <location filename="../../workbench/report/findings.py" />
            <source>{error} verified error</source>
            <translation>{error} d'erreur vérifiée</translation>
        </message>
        <message>
            <location filename="../../workbench/report/findings.py" />
            <source>{error} verified error as made</source>
            <translation>{error} d'erreur vérifiée après fabrication</translation>
        </message>
        <message>
            <location filename="../../workbench/report/findings.py" />
            <source>{error}; no lens gets below {lowest}.</source>
            <translation>{error} ; aucune lentille ne descend sous {lowest}.</translation>
        </message>
        <message>
            <location filename="../../workbench/report/findings.py" />
            <source>{error}; no mirror gets below {lowest}.</source>
            <translation>{error} ; aucun miroir ne descend sous {lowest}.</translation>
        </message>
        <message>
            <location filename="../../workbench/report/findings.py" />
            <source>Continue</source>
            <translation>Continuer</translation>
        </message>
        <message>
            <location filename="../../workbench/report/findings.py" />
            <source>{part:.1f} % of the light lands {place}; {lost:.1f} % {where}.</source>
            <translation>{part:.1f} % de la lumière arrive {place} ; {lost:.1f} % {where}.</translation>
        </message>
        <message>
            <location filename="../../workbench/report/findings.py" />
            <source>{part:.1f} % of the light lands {place}, of at most {most:.1f} %; {lost:.1f} % {where}.</source>
            <translation>{part:.1f} % de la lumière arrive {place}, sur {most:.1f} % au plus ; {lost:.1f} % {where}.</translation>
        </message>
        <message>
            <location filename="../../workbench/report/findings.py" />
            <source>{even:.2f} uniformity U₀ (minimum / average) on the {area}; U₁ (minimum / maximum) is {ends:.2f}.</source>
            <translation>{even:.2f} d'uniformité U₀ (minimum / moyenne), {area} ; U₁ (minimum / maximum) est {ends:.2f}.</translation>
        </message>
        <message>
            <location filename="../../workbench/report/findings.py" />
            <source>{sentence} Average: {average}.</source>
            <translation>{sentence} Moyenne : {average}.</translation>
        </message>
        <message>
            <location filename="../../workbench/report/findings.py" />
            <source>Widen and start over</source>
            <translation>Élargir et recommencer</translation>
        </message>
        <message>
            <location filename="../../workbench/report/findings.py" />
            <source>{n_u} × {n_v} control points are too few for the detail of this target; {finer_u} × {finer_v} can show it.</source>
            <translation>{n_u} × {n_v} points de contrôle sont trop peu pour le détail de cette cible ; {finer_u} × {finer_v} peuvent le montrer.</translation>
        </message>
        <message>
            <location filename="../../workbench/report/findings.py" />
            <source>Refine and start over</source>
            <translation>Affiner et recommencer</translation>
        </message>
        <message>
            <location filename="../../workbench/report/findings.py" />
            <source>{part:.2g} % of the light {goes}: {cure}.</source>
            <translation>{part:.2g} % de la lumière {goes} : {cure}.</translation>
        </message>
        <message>
            <location filename="../../workbench/report/findings.py" />
            <source>{where}, as marked in the 3D scene: {cure}.</source>
            <translation>{where}, comme marqué dans la scène 3D : {cure}.</translation>
        </message>
        <message>
            <location filename="../../workbench/report/measured.py" />
            <source>difference</source>
            <translation>différence</translation>
        </message>
        <message>
            <location filename="../../workbench/report/measured.py" />
            <source>{part} (relative L2, beside scale and camera)</source>
            <translation>{part} (L2 relative, hors échelle et appareil photo)</translation>
        </message>
        <message>
            <location filename="../../workbench/report/measured.py" />
            <source>with causes</source>
            <translation>avec les causes</translation>
        </message>
        <message>
            <location filename="../../workbench/report/measured.py" />
            <source>response</source>
            <translation>réponse</translation>
        </message>
        <message>
            <location filename="../../workbench/report/measured.py" />
            <source>{power:.2f} (1 if the tone is right)</source>
            <translation>{power:.2f} (1 si le ton est juste)</translation>
        </message>
        <message>
            <location filename="../../workbench/report/measured.py" />
            <source>corners</source>
            <translation>coins</translation>
        </message>
        <message>
            <location filename="../../workbench/report/measured.py" />
            <source>{factor:.2f} times as light as the middle</source>
            <translation>{factor:.2f} fois la clarté du milieu</translation>
        </message>
        <message>
            <location filename="../../workbench/report/measured.py" />
            <source>photograph</source>
            <translation>photographie</translation>
        </message>
        <message>
            <location filename="../../workbench/report/measured.py" />
            <source>{value} ± {off}, explains {part:.0f} %</source>
            <translation>{value} ± {off}, explique {part:.0f} %</translation>
        </message>
        <message>
            <location filename="../../workbench/report/measured.py" />
            <source>part</source>
            <translation>pièce</translation>
        </message>
        <message>
            <location filename="../../workbench/report/measured.py" />
            <source>points</source>
            <translation>points</translation>
        </message>
        <message>
            <location filename="../../workbench/report/measured.py" />
            <source>{count} on {covered} of {face}, {missing} without a height, {spikes} spikes</source>
            <translation>{count} sur {covered} de {face}, {missing} sans hauteur, {spikes} aberrants</translation>
        </message>
        <message>
            <location filename="../../workbench/report/measured.py" />
            <source>residual</source>
            <translation>écart</translation>
        </message>
        <message>
            <location filename="../../workbench/report/measured.py" />
            <source>{rms:.4g} µm rms, {whole:.4g} µm peak to valley</source>
            <translation>{rms:.4g} µm rms, {whole:.4g} µm crête à creux</translation>
        </message>
        <message>
            <location filename="../../workbench/report/measured.py" />
            <source>resolved</source>
            <translation>résolu</translation>
        </message>
        <message>
            <location filename="../../workbench/report/measured.py" />
            <source>{rms:.4g} µm rms, slope {slope:.4g} mrad rms, by {columns} × {rows} control points</source>
            <translation>{rms:.4g} µm rms, pente {slope:.4g} mrad rms, par {columns} × {rows} points de contrôle</translation>
        </message>
        <message>
            <location filename="../../workbench/report/measured.py" />
            <source>rest</source>
            <translation>reste</translation>
        </message>
        <message>
            <location filename="../../workbench/report/measured.py" />
            <source>turned by</source>
            <translation>tourné de</translation>
        </message>
        <message>
            <location filename="../../workbench/report/measured.py" />
            <source>shifted by</source>
            <translation>décalé de</translation>
        </message>
        <message>
            <location filename="../../workbench/report/measured.py" />
            <source>scale</source>
            <translation>échelle</translation>
        </message>
        <message>
            <location filename="../../workbench/report/measured.py" />
            <source>{rms:.4g} µm rms</source>
            <translation>{rms:.4g} µm rms</translation>
        </message>
        <message>
            <location filename="../../workbench/report/measured.py" />
            <source>parts differ by</source>
            <translation>les pièces diffèrent de</translation>
        </message>
        <message>
            <location filename="../../workbench/report/measured.py" />
            <source>light of {part}</source>
            <translation>lumière de {part}</translation>
        </message>
        <message>
            <location filename="../../workbench/report/measured.py" />
            <source>{error} verified error, {light} on the receiver</source>
            <translation>{error} erreur vérifiée, {light} sur le récepteur</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/element.py" />
            <source>'auto' needs a target to choose for; numbers</source>
            <translation>'auto' demande une cible pour choisir ; des nombres</translation>
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
            <location filename="../../workbench/scene/image.py" />
            <source>viewed from the side of the light</source>
            <translation>vu du côté de la lumière</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/image.py" />
            <source>viewed from behind the screen</source>
            <translation>vu de derrière l'écran</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/image.py" />
            <source>viewed from behind the far field</source>
            <translation>vu de derrière le champ lointain</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/image.py" />
            <source>{size:g} about {middle:g} ends beyond the receiver; at most {most:g} there</source>
            <translation>{size:g} autour de {middle:g} dépasse le récepteur ; au plus {most:g} à cet endroit</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/image.py" />
            <source>have no area between them; a polygon with some</source>
            <translation>n'entourent aucune surface ; un polygone qui en a une</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/image.py" />
            <source>make sides that cross; in their order around the polygon</source>
            <translation>font des côtés qui se croisent ; dans leur ordre autour du polygone</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/image.py" />
            <source>{count} are given; at most {most}</source>
            <translation>{count} sont donnés ; au plus {most}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/lens.py" />
            <source>the entrance face</source>
            <translation>la face d'entrée</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/lens.py" />
            <source>a B-spline front face needs a B-spline back face; 'bspline'</source>
            <translation>une face avant B-spline demande une face arrière B-spline ; 'bspline'</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/lens.py" />
            <source>{index:g}; greater than 1 is needed</source>
            <translation>{index:g} ; il faut plus de 1</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/lens.py" />
            <source>{height:g} is below the minimal thickness; use more than {least:g}</source>
            <translation>{height:g} est sous l'épaisseur minimale ; prenez plus de {least:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/lens.py" />
            <source>{height:g} is above the maximal thickness; use less than {most:g}</source>
            <translation>{height:g} est au-dessus de l'épaisseur maximale ; prenez moins de {most:g}</translation>
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
            <source>{length:g} is too long beside a width of {width:g}; at most {most:g}</source>
            <translation>{length:g} est trop long pour une largeur de {width:g} ; au plus {most:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/losses.py" />
            <source>a flatter base, </source>
            <translation>une base plus plate, </translation>
        </message>
        <message>
            <location filename="../../workbench/scene/losses.py" />
            <source>{loss} ({element})</source>
            <translation>{loss} ({element})</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/making/presets.py" />
            <source>typical value, no source</source>
            <translation>valeur typique, sans source</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/making/presets.py" />
            <source>largest value of MISUMI, Plastic Molding Tutorial #004, table 1, 2009</source>
            <translation>plus grande valeur de MISUMI, Plastic Molding Tutorial #004, tableau 1, 2009</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/making/presets.py" />
            <source>layers: toglefritz.com, Form 1+ 0.1mm vs. 0.025mm Layer Thickness; pixels: typical value</source>
            <translation>couches : toglefritz.com, Form 1+ 0.1mm vs. 0.025mm Layer Thickness ; pixels : valeur typique</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/making/presets.py" />
            <source>Milling: ball of 3 mm, scallops of 5 µm</source>
            <translation>Fraisage : bille de 3 mm, crêtes de 5 µm</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/making/presets.py" />
            <source>Milling: ball of 1 mm, scallops of 1 µm</source>
            <translation>Fraisage : bille de 1 mm, crêtes de 1 µm</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/making/presets.py" />
            <source>Diamond turning: nose of 0.5 mm, feed of 5 µm</source>
            <translation>Tournage au diamant : bec de 0,5 mm, avance de 5 µm</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/making/presets.py" />
            <source>Polishing over a width of 0.1 mm</source>
            <translation>Polissage sur une largeur de 0,1 mm</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/making/presets.py" />
            <source>Injection moulding of PMMA: shrinkage of 0.4 %</source>
            <translation>Moulage par injection de PMMA : retrait de 0,4 %</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/making/presets.py" />
            <source>Injection moulding of PS: shrinkage of 0.7 %</source>
            <translation>Moulage par injection de PS : retrait de 0,7 %</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/making/presets.py" />
            <source>Resin printing: layers and pixels of 50 µm</source>
            <translation>Impression de résine : couches et pixels de 50 µm</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/making/presets.py" />
            <source>Resin printing: layers of 25 µm, pixels of 50 µm</source>
            <translation>Impression de résine : couches de 25 µm, pixels de 50 µm</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/making/process.py" />
            <source>{width:g} is too large for {name}; at most {most:.3g}</source>
            <translation>{width:g} est trop grand pour {name} ; au plus {most:.3g}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/making/process.py" />
            <source>{step:g} leaves ridges of the tool's own size; at most {most:g}</source>
            <translation>{step:g} laisse des crêtes de la taille de l'outil ; au plus {most:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/mirror_diffuser.py" />
            <source>the mirror</source>
            <translation>le miroir</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/mirror_diffuser.py" />
            <source>the diffuser</source>
            <translation>le diffuseur</translation>
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
            <source>{parts} make {across} × {up} rectangles; at most {most} in all</source>
            <translation>{parts} font {across} × {up} rectangles ; au plus {most} en tout</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/receiver.py" />
            <source>is at no distance; a screen is needed</source>
            <translation>n'a pas de distance ; il faut un écran</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/receivers.py" />
            <source>{tilt} turns the back of the screen to light of the lens; its front has to face all of the lens</source>
            <translation>{tilt} tourne le dos de l'écran vers la lumière de la lentille ; son avant doit faire face à toute la lentille</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/receivers.py" />
            <source>{tilt} turns the back of the screen to light of the mirror; its front has to face all of the mirror</source>
            <translation>{tilt} tourne le dos de l'écran vers la lumière du miroir ; son avant doit faire face à tout le miroir</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/receivers.py" />
            <source>{z:g} may touch the lens; more than {least:g}, the highest that the exit face can become</source>
            <translation>{z:g} peut toucher la lentille ; plus de {least:g}, le plus haut que la face de sortie puisse atteindre</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/receivers.py" />
            <source>{z:g} puts its lowest edge at z = {nearest:g}, which may touch the lens; more than {least:g}, the highest that the exit face can become and the tilt adds</source>
            <translation>{z:g} met son bord le plus bas à z = {nearest:g}, qui peut toucher la lentille ; plus de {least:g}, le plus haut que la face de sortie puisse atteindre, et ce qu'ajoute l'inclinaison</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/receivers.py" />
            <source>{z:g} may touch the lens, or be behind it; less than {most:g}, the lowest that it can become</source>
            <translation>{z:g} peut toucher la lentille ou être derrière elle ; moins de {most:g}, le plus bas qu'elle puisse atteindre</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/receivers.py" />
            <source>{z:g} may touch the mirror, or be behind it; less than {most:g}, the lowest that it can become</source>
            <translation>{z:g} peut toucher le miroir ou être derrière lui ; moins de {most:g}, le plus bas qu'il puisse atteindre</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/receivers.py" />
            <source>{half:g} about {middle:g} goes beyond {most:g} degrees; at most {left:g}</source>
            <translation>{half:g} autour de {middle:g} dépasse {most:g} degrés ; au plus {left:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/run.py" />
            <source>they leave none of the {count} iterations for the scene itself; more than {least} in all are needed</source>
            <translation>elles ne laissent aucune des {count} itérations à la scène elle-même ; il en faut plus de {least} en tout</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/run.py" />
            <source>unknown field; the automatic method has none</source>
            <translation>champ inconnu ; la méthode automatique n'en a pas</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/source.py" />
            <source>{z:g} is not before {front}; less than {most:g}</source>
            <translation>{z:g} n'est pas devant ({front}) ; moins de {most:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/source.py" />
            <source>{way:g} before {front} is too near for a lens that is {width:g} wide; at least {least:g}</source>
            <translation>{way:g} devant ({front}) est trop près pour une lentille large de {width:g} ; au moins {least:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/source.py" />
            <source>{way:g} before {front} is too near for a mirror that is {width:g} wide; at least {least:g}</source>
            <translation>{way:g} devant ({front}) est trop près pour un miroir large de {width:g} ; au moins {least:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/source.py" />
            <source>{way:g} before {front} is too far for a lens that is {width:g} wide; at most {most:g}, or collimated light</source>
            <translation>{way:g} devant ({front}) est trop loin pour une lentille large de {width:g} ; au plus {most:g}, ou une lumière collimatée</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/source.py" />
            <source>{way:g} before {front} is too far for a mirror that is {width:g} wide; at most {most:g}, or collimated light</source>
            <translation>{way:g} devant ({front}) est trop loin pour un miroir large de {width:g} ; au plus {most:g}, ou une lumière collimatée</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/source.py" />
            <source>given together with a wavelength of {wavelength:g} µm; one of both</source>
            <translation>donné avec une longueur d'onde de {wavelength:g} µm ; l'un des deux</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/source.py" />
            <source>{count} lines are given; 1 to {most}</source>
            <translation>{count} raies sont données ; 1 à {most}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/source.py" />
            <source>all parts of the flux are 0; one above 0</source>
            <translation>toutes les parts du flux sont 0 ; une au-dessus de 0</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/sources.py" />
            <source>{angle:g} brings light {steepest:g} degrees from the axis, which does not come to {front}; less than 90 in all</source>
            <translation>{angle:g} amène de la lumière à {steepest:g} degrés de l'axe, qui n'arrive pas là ({front}) ; moins de 90 en tout</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/sources.py" />
            <source>{radius:g} is too narrow for a lens that is {width:g} wide; at least {least:g}</source>
            <translation>{radius:g} est trop étroit pour une lentille large de {width:g} ; au moins {least:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/sources.py" />
            <source>{radius:g} is too narrow for a mirror that is {width:g} wide; at least {least:g}</source>
            <translation>{radius:g} est trop étroit pour un miroir large de {width:g} ; au moins {least:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/sources.py" />
            <source>'{file}' is none of these: {endings}</source>
            <translation>'{file}' n'est aucun de ceux-ci : {endings}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/spline_face.py" />
            <source>{count} is too few for degree {degree}; at least {least}</source>
            <translation>{count} est trop peu pour le degré {degree} ; au moins {least}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/spline_face.py" />
            <source>{radius:g} does not span the lens; more than its half-diagonal {least:g}</source>
            <translation>{radius:g} ne couvre pas la lentille ; plus que sa demi-diagonale {least:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/spline_face.py" />
            <source>{radius:g} does not span the mirror; more than its half-diagonal {least:g}</source>
            <translation>{radius:g} ne couvre pas le miroir ; plus que sa demi-diagonale {least:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/spline_face.py" />
            <source>the file has {count} control points; {given}</source>
            <translation>le fichier a {count} points de contrôle ; {given}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/spline_face.py" />
            <source>the control heights in {file} are in the unit of the scene; the same unit</source>
            <translation>les hauteurs de contrôle de {file} sont dans l’unité de la scène ; la même unité</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/spline_face.py" />
            <source>[{low:g}, {high:g}] is empty; low before high</source>
            <translation>[{low:g}, {high:g}] est vide ; la plus petite valeur d'abord</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/spline_face.py" />
            <source>no array of control heights; a .npy file of at most {most} × {most} finite numbers</source>
            <translation>pas de tableau de hauteurs de contrôle ; un fichier .npy d’au plus {most} × {most} nombres finis</translation>
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
            <location filename="../../workbench/scene/target.py" />
            <source>at least {least:g}, above black</source>
            <translation>au moins {least:g}, au-dessus du noir</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/target.py" />
            <source>{radius:g} is not above {before:g}</source>
            <translation>{radius:g} n'est pas au-dessus de {before:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/target.py" />
            <source>has no light; some level above 0 is needed</source>
            <translation>n'a pas de lumière ; il faut un niveau au-dessus de 0</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/task.py" />
            <source>the element is not upright, which {who} cannot take into account; 0</source>
            <translation>l'élément est incliné, ce que {who} ne peut pas prendre en compte ; 0</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/task.py" />
            <source>'diffuser', which {who} cannot take into account; none</source>
            <translation>'diffuser', ce que {who} ne peut pas prendre en compte ; aucun</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/task.py" />
            <source>{count} given, which {who} cannot take into account; one</source>
            <translation>il y en a {count}, ce dont {who} ne peut tenir compte ; il en faut 1</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/train.py" />
            <source>'{name}' is the name of another element; another name</source>
            <translation>'{name}' est le nom d'un autre élément ; un autre nom</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/train.py" />
            <source>no face is designed; one face of shape 'bspline'</source>
            <translation>aucune face n'est à concevoir ; une face de forme 'bspline'</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/train.py" />
            <source>{value:g} is about curvature, and faces of degree 1 are flat between edges; {field} of at least 2</source>
            <translation>{value:g} concerne la courbure, et les faces de degré 1 sont planes entre les arêtes ; {field} d'au moins 2</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/train.py" />
            <source>light leaves {name} at {angle:.0f} degrees from the z axis, too far for a far field; at most {most:g}, or a plane</source>
            <translation>la lumière quitte {name} à {angle:.0f} degrés de l'axe z, trop pour un champ lointain ; au plus {most:g}, ou un plan</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/train.py" />
            <source>a receiver at z = {z:g} may touch the element {name}; more than {least:g}</source>
            <translation>un récepteur à z = {z:g} peut toucher l'élément {name} ; plus de {least:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/train.py" />
            <source>a receiver at {place} may touch the element {name}, or gets none of its light; farther along the light, and across it</source>
            <translation>un récepteur en {place} peut toucher l'élément {name}, ou n'en reçoit pas de lumière ; plus loin le long de la lumière, et en travers</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/train.py" />
            <source>light comes to the back of {name}, at {angle:.0f} degrees from its z; less than 90, as where it is turned by 180 degrees about its x</source>
            <translation>la lumière arrive au dos de {name}, à {angle:.0f} degrés de son z ; moins de 90, par exemple après une rotation de 180 degrés autour de son x</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/train.py" />
            <source>'{name}' is behind the diffuser {diffuser}; move the diffuser to the end</source>
            <translation>'{name}' est derrière le diffuseur {diffuser} ; placez le diffuseur à la fin</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/train.py" />
            <source>behind a Lambertian diffuser all lenses make the same far field; 'plane', or {field}: 'gaussian'</source>
            <translation>derrière un diffuseur lambertien, toutes les lentilles donnent le même champ lointain ; 'plane', ou {field}: 'gaussian'</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/train.py" />
            <source>not parallel to the Lambertian diffuser {name}; its tilt</source>
            <translation>pas parallèle au diffuseur lambertien {name} ; son inclinaison</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/train.py" />
            <source>{z:g} reaches into {name}; at least {least:g}</source>
            <translation>{z:g} empiète sur {name} ; au moins {least:g}</translation>
        </message>
        <message>
            <location filename="../../workbench/scene/train.py" />
            <source>{place} is not where light of {name} goes; {by:g} farther along its axis</source>
            <translation>{place} n'est pas où va la lumière de {name} ; {by:g} plus loin le long de son axe</translation>
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
            <location filename="../../workbench/scene/wide_sources.py" />
            <source>{rays} from each of {points} points are too many; at most {most} rays in all</source>
            <translation>{rays} de chacun des {points} points sont trop ; au plus {most} rayons en tout</translation>
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
            <location filename="../../workbench/targets/prepare.py" />
            <source>leaves '{path}' black all over; less leaves some light</source>
            <translation>ne laisse que du noir de « {path} » ; une valeur plus petite laisse de la lumière</translation>
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
