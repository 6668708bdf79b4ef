<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr_FR" sourcelanguage="en">
<context>
    <name>AboutDialog</name>
    <message>
        <source>Furrow %1</source>
        <translation>Furrow %1</translation>
    </message>
    <message>
        <source>Furrow plans how a machine covers a farm field.</source>
        <translation>Furrow planifie comment une machine travaille une parcelle.</translation>
    </message>
    <message>
        <source>Free software under the BSD 3-Clause licence: use it, change it and pass it on, without any warranty.</source>
        <translation>Logiciel libre sous licence BSD à 3 clauses : utilisez-le, modifiez-le et transmettez-le, sans aucune garantie.</translation>
    </message>
    <message>
        <source>The methods follow the Fields2Cover paper (Mier, Valente and de Bruin, 2023) and the sources that the design names.</source>
        <translation>Les méthodes suivent l&apos;article Fields2Cover (Mier, Valente et de Bruin, 2023) et les sources citées dans le document de conception.</translation>
    </message>
    <message>
        <source>Built with %1.</source>
        <translation>Construit avec %1.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
</context>
<context>
    <name>BestPlanDialog</name>
    <message>
        <source>The best plan found</source>
        <translation>Le meilleur plan trouvé</translation>
    </message>
    <message>
        <source>Your plan is the best one found</source>
        <translation>Votre plan est le meilleur trouvé</translation>
    </message>
    <message>
        <source>Find the best plan</source>
        <translation>Chercher le meilleur plan</translation>
    </message>
    <message>
        <source>Other choices are planned, and the quickest plan that can be driven is taken. Margins, overlap and what the operation needs stay as they are.</source>
        <translation>D&apos;autres choix sont planifiés, et le plan réalisable le plus rapide est retenu. Les marges, le recouvrement et ce que demande le travail restent tels quels.</translation>
    </message>
    <message>
        <source>May change</source>
        <translation>Peut changer</translation>
    </message>
    <message>
        <source>%1 (set by you)</source>
        <translation>%1 (votre choix)</translation>
    </message>
    <message>
        <source>Best plan</source>
        <translation>Meilleur plan</translation>
    </message>
    <message>
        <source>Best so far</source>
        <translation>Meilleur jusqu&apos;ici</translation>
    </message>
    <message>
        <source>As it was</source>
        <translation>Avant</translation>
    </message>
    <message>
        <source>Saved</source>
        <translation>Gagné</translation>
    </message>
    <message>
        <source>Time of the best plan during the search</source>
        <translation>Durée du meilleur plan pendant la recherche</translation>
    </message>
    <message numerus="yes">
        <source>%n alternative(s) were planned.</source>
        <translation>
            <numerusform>%n autre choix a été planifié.</numerusform>
            <numerusform>%n autres choix ont été planifiés.</numerusform>
        </translation>
    </message>
    <message>
        <source>Times include working separately what a plan leaves.</source>
        <translation>Les temps comprennent le travail séparé de ce qu’un plan laisse.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Chercher</translation>
    </message>
    <message>
        <source>Stop and keep</source>
        <translation>Arrêter et garder</translation>
    </message>
    <message>
        <source>Use this plan</source>
        <translation>Utiliser ce plan</translation>
    </message>
</context>
<context>
    <name>CellStepper</name>
    <message>
        <source>Done</source>
        <translation>Terminé</translation>
    </message>
    <message>
        <source>Go through the steps</source>
        <translation>Parcourir les étapes</translation>
    </message>
    <message>
        <source>Next step</source>
        <translation>Étape suivante</translation>
    </message>
    <message>
        <source>Previous step</source>
        <translation>Étape précédente</translation>
    </message>
    <message>
        <source>Show the blocks</source>
        <translation>Montrer les sous-parcelles</translation>
    </message>
    <message>
        <source>Step of the blocks</source>
        <translation>Étape des sous-parcelles</translation>
    </message>
    <message>
        <source>Turns and ways from block to block, estimated.</source>
        <translation>Demi-tours et déplacements d&apos;une sous-parcelle à l&apos;autre, estimés.</translation>
    </message>
</context>
<context>
    <name>ChoiceTable</name>
    <message>
        <source>%1, %2: %3</source>
        <translation>%1, %2 : %3</translation>
    </message>
    <message numerus="yes">
        <source>%n other(s) are slower still, or cannot be driven.</source>
        <translation>
            <numerusform>%n autre est encore plus lent, ou irréalisable.</numerusform>
            <numerusform>%n autres sont encore plus lents, ou irréalisables.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Command</name>
    <message>
        <source>Ctrl</source>
        <translation>Ctrl</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Maj</translation>
    </message>
</context>
<context>
    <name>CommandPalette</name>
    <message>
        <source>%1: %2</source>
        <translation>%1 : %2</translation>
    </message>
    <message>
        <source>There is no command and no setting of that name</source>
        <translation>Aucune commande ni réglage de ce nom</translation>
    </message>
    <message>
        <source>Search commands, settings, coordinates</source>
        <translation>Chercher commandes, réglages, coordonnées</translation>
    </message>
    <message>
        <source>As maps, phones and receivers write them</source>
        <translation>Comme les écrivent cartes, téléphones et récepteurs</translation>
    </message>
</context>
<context>
    <name>CommentPins</name>
    <message>
        <source>Comment %1: %2</source>
        <translation>Commentaire %1 : %2</translation>
    </message>
    <message>
        <source>Click the place that you want to comment on. Esc ends it.</source>
        <translation>Cliquez sur l&apos;endroit à commenter. Échap pour arrêter.</translation>
    </message>
</context>
<context>
    <name>CommentRow</name>
    <message>
        <source>Comment %1 by %2: %3</source>
        <translation>Commentaire %1 de %2 : %3</translation>
    </message>
    <message>
        <source>Of a plan before the last change</source>
        <translation>Plan d&apos;avant la dernière modification</translation>
    </message>
    <message>
        <source>Open again</source>
        <translation>Rouvrir</translation>
    </message>
    <message>
        <source>Settled</source>
        <translation>Réglé</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Retirer</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Modifier</translation>
    </message>
</context>
<context>
    <name>ComparePanel</name>
    <message>
        <source>Compare</source>
        <translation>Comparer</translation>
    </message>
    <message>
        <source>%1 beside</source>
        <translation>%1 à côté de</translation>
    </message>
    <message>
        <source>The other plan</source>
        <translation>L&apos;autre plan</translation>
    </message>
    <message>
        <source>Keep this plan as a variant…</source>
        <translation>Garder ce plan comme variante…</translation>
    </message>
    <message>
        <source>The other plan is being made …</source>
        <translation>L&apos;autre plan est en cours de calcul…</translation>
    </message>
    <message>
        <source>This plan</source>
        <translation>Ce plan</translation>
    </message>
    <message>
        <source>The other</source>
        <translation>L&apos;autre</translation>
    </message>
    <message>
        <source>%1: %2, the other %3</source>
        <translation>%1 : %2, l&apos;autre %3</translation>
    </message>
    <message>
        <source>Hold to see the other plan (key X)</source>
        <translation>Maintenir pour voir l&apos;autre plan (touche X)</translation>
    </message>
    <message>
        <source>What was chosen otherwise</source>
        <translation>Choix différents</translation>
    </message>
    <message>
        <source>Machine and settings are the same.</source>
        <translation>La machine et les réglages sont les mêmes.</translation>
    </message>
    <message>
        <source>%1 → %2</source>
        <translation>%1 → %2</translation>
    </message>
    <message>
        <source>Go on with the other plan</source>
        <translation>Continuer avec l&apos;autre plan</translation>
    </message>
    <message>
        <source>Two maps side by side (Ctrl+Shift+D)</source>
        <translation>Deux cartes côte à côte (Ctrl+Maj+D)</translation>
    </message>
    <message>
        <source>On the maps, swaths, headland passes and turns are coloured that the other plan has not: full lines in this plan, dashes in the other.</source>
        <translation>Sur les cartes, les passages, tours de fourrière et demi-tours que l’autre plan n’a pas sont colorés : traits pleins dans ce plan, tirets dans l’autre.</translation>
    </message>
    <message>
        <source>On the map, swaths, headland passes and turns: full lines only in this plan, dashes only in the other.</source>
        <translation>Sur la carte, passages, tours de fourrière et demi-tours : traits pleins dans ce plan seul, tirets dans l’autre seul.</translation>
    </message>
</context>
<context>
    <name>CrashNotice</name>
    <message>
        <source>Furrow ended unexpectedly the last time.</source>
        <translation>Furrow s&apos;est arrêté de façon inattendue la dernière fois.</translation>
    </message>
    <message>
        <source>Your work was kept up to the last half second. What happened is recorded on this computer; a report helps to mend it.</source>
        <translation>Votre travail est conservé jusqu&apos;à la dernière demi-seconde. Ce qui s&apos;est passé est enregistré sur cet ordinateur ; un rapport aide à le corriger.</translation>
    </message>
    <message>
        <source>Report a problem…</source>
        <translation>Signaler un problème…</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
</context>
<context>
    <name>DrawingNotice</name>
    <message>
        <source>The map cannot show fields and plans: this window is drawn without OpenGL.</source>
        <translation>La carte ne peut afficher ni parcelles ni plans : cette fenêtre est dessinée sans OpenGL.</translation>
    </message>
    <message>
        <source>Install a graphics driver with OpenGL; Mesa draws on any processor. The command line plans and exports all the same.</source>
        <translation>Installez un pilote graphique avec OpenGL ; Mesa dessine avec tout processeur. La ligne de commande planifie et exporte quand même.</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
</context>
<context>
    <name>DriveBar</name>
    <message>
        <source>Drive-through</source>
        <translation>Parcours</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Drive through the plan</source>
        <translation>Parcourir le plan</translation>
    </message>
    <message>
        <source>Moment of the drive</source>
        <translation>Moment du parcours</translation>
    </message>
    <message>
        <source>Pace: %1 times as fast</source>
        <translation>Rythme : %1 fois plus vite</translation>
    </message>
    <message>
        <source>%1×</source>
        <translation>%1×</translation>
    </message>
    <message>
        <source>Let the map rest</source>
        <translation>Laisser la carte immobile</translation>
    </message>
    <message>
        <source>Follow the machine</source>
        <translation>Suivre la machine</translation>
    </message>
    <message>
        <source>Hide the drive-through</source>
        <translation>Masquer le parcours</translation>
    </message>
</context>
<context>
    <name>DrivenDialog</name>
    <message>
        <source>Open a recorded track</source>
        <translation>Ouvrir un trajet enregistré</translation>
    </message>
    <message>
        <source>Recorded tracks (%1)</source>
        <translation>Trajets enregistrés (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Tous les fichiers (*)</translation>
    </message>
</context>
<context>
    <name>DrivenPanel</name>
    <message>
        <source>Planned and driven</source>
        <translation>Prévu et parcouru</translation>
    </message>
    <message>
        <source>Go to the farthest place</source>
        <translation>Aller à l&apos;endroit le plus éloigné</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1 : %2</translation>
    </message>
    <message>
        <source>Distance from the plan</source>
        <translation>Écart au plan</translation>
    </message>
    <message>
        <source>Another track…</source>
        <translation>Autre trajet…</translation>
    </message>
    <message>
        <source>Make a field from it</source>
        <translation>En faire une parcelle</translation>
    </message>
</context>
<context>
    <name>EditCommands</name>
    <message>
        <source>Edit</source>
        <translation>Édition</translation>
    </message>
    <message>
        <source>Undo: %1</source>
        <translation>Annuler : %1</translation>
    </message>
    <message>
        <source>Draw a point</source>
        <translation>Dessiner un point</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Redo: %1</source>
        <translation>Rétablir : %1</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Rétablir</translation>
    </message>
    <message>
        <source>Delete what is selected</source>
        <translation>Supprimer la sélection</translation>
    </message>
    <message>
        <source>Del</source>
        <translation>Suppr</translation>
    </message>
    <message>
        <source>Select the next point</source>
        <translation>Sélectionner le point suivant</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Espace</translation>
    </message>
    <message>
        <source>Select the next edge</source>
        <translation>Sélectionner le côté suivant</translation>
    </message>
    <message>
        <source>Select the next outline, line or gate</source>
        <translation>Contour, ligne ou entrée suivante</translation>
    </message>
    <message>
        <source>PgDown</source>
        <translation>Pg suiv</translation>
    </message>
    <message>
        <source>Find a command…</source>
        <translation>Chercher une commande…</translation>
    </message>
</context>
<context>
    <name>EmptyState</name>
    <message>
        <source>Which field?</source>
        <translation>Quelle parcelle ?</translation>
    </message>
    <message>
        <source>Open its boundary, or drop the file anywhere on this window. Shapefile, GeoJSON, KML, GeoPackage, GML and others are understood, zipped or not.</source>
        <translation>Ouvrez sa limite, ou déposez le fichier n&apos;importe où dans cette fenêtre. Shapefile, GeoJSON, KML, GeoPackage, GML et d&apos;autres sont lus, zippés ou non.</translation>
    </message>
    <message>
        <source>Open a file…</source>
        <translation>Ouvrir un fichier…</translation>
    </message>
    <message>
        <source>Draw it</source>
        <translation>La dessiner</translation>
    </message>
    <message>
        <source>Or try one of these</source>
        <translation>Ou essayez l&apos;une de celles-ci</translation>
    </message>
    <message>
        <source>Sample field %1</source>
        <translation>Parcelle d&apos;exemple %1</translation>
    </message>
</context>
<context>
    <name>ErrorCourse</name>
    <message>
        <source>Distance from the plan along the recording, up to %1</source>
        <translation>Écart au plan le long de l&apos;enregistrement, jusqu&apos;à %1</translation>
    </message>
    <message>
        <source>%1 to the left</source>
        <translation>%1 à gauche</translation>
    </message>
    <message>
        <source>%1 to the right</source>
        <translation>%1 à droite</translation>
    </message>
</context>
<context>
    <name>ExportChecks</name>
    <message>
        <source>Choose another format or terminal, and report this.</source>
        <translation>Choisissez un autre format ou une autre console, et signalez-le.</translation>
    </message>
    <message numerus="yes">
        <source>%n check(s) passed: nothing in the files that receivers stumble over.</source>
        <translation>
            <numerusform>%n contrôle réussi : rien dans les fichiers qui puisse gêner les consoles.</numerusform>
            <numerusform>%n contrôles réussis : rien dans les fichiers qui puisse gêner les consoles.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ExportDialog</name>
    <message>
        <source>Export the plan</source>
        <translation>Exporter le plan</translation>
    </message>
    <message>
        <source>USB stick</source>
        <translation>Clé USB</translation>
    </message>
    <message>
        <source>Files in a folder</source>
        <translation>Fichiers dans un dossier</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Writing …</source>
        <translation>Écriture…</translation>
    </message>
    <message>
        <source>Write to the stick</source>
        <translation>Écrire sur la clé</translation>
    </message>
    <message>
        <source>Write files</source>
        <translation>Écrire les fichiers</translation>
    </message>
    <message>
        <source>Plan again</source>
        <translation>Planifier à nouveau</translation>
    </message>
    <message numerus="yes">
        <source>%n problem(s) in this plan: it cannot be driven as drawn. The files say so too.</source>
        <translation>
            <numerusform>%n problème dans ce plan : il ne peut pas être suivi tel quel. Les fichiers le disent aussi.</numerusform>
            <numerusform>%n problèmes dans ce plan : il ne peut pas être suivi tel quel. Les fichiers le disent aussi.</numerusform>
        </translation>
    </message>
    <message>
        <source>Export fields</source>
        <translation>Exporter des parcelles</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Arrêter</translation>
    </message>
</context>
<context>
    <name>ExportFolderPage</name>
    <message>
        <source>Folder</source>
        <translation>Dossier</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Choisir…</translation>
    </message>
    <message>
        <source>Folder for the plan</source>
        <translation>Dossier du plan</translation>
    </message>
    <message>
        <source>Fields without a plan are planned on the way. Each field gets a folder of its own; ISOXML and AgGPS hold all fields in one.</source>
        <translation>Les parcelles sans plan sont planifiées au passage. Chaque parcelle a son propre dossier ; ISOXML et AgGPS contiennent toutes les parcelles ensemble.</translation>
    </message>
</context>
<context>
    <name>ExportStickPage</name>
    <message>
        <source>Terminal</source>
        <translation>Console</translation>
    </message>
    <message>
        <source>Stick</source>
        <translation>Clé</translation>
    </message>
    <message>
        <source>No USB stick is plugged in. It appears here when it is; or choose a folder to carry the files yourself.</source>
        <translation>Aucune clé USB n&apos;est branchée. Elle apparaîtra ici dès qu&apos;elle le sera ; ou choisissez un dossier pour transporter les fichiers vous-même.</translation>
    </message>
    <message>
        <source>Another folder…</source>
        <translation>Autre dossier…</translation>
    </message>
    <message>
        <source>%1 is on it already.</source>
        <translation>%1 s&apos;y trouve déjà.</translation>
    </message>
    <message>
        <source>It will not be deleted: it is kept under another name.</source>
        <translation>Rien n&apos;est effacé : le contenu est gardé sous un autre nom.</translation>
    </message>
    <message>
        <source>Keep it as a backup and write the plan</source>
        <translation>Garder une copie et écrire le plan</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>et %n autre</numerusform>
            <numerusform>et %n autres</numerusform>
        </translation>
    </message>
    <message>
        <source>Folder in the place of a stick</source>
        <translation>Dossier à la place d&apos;une clé</translation>
    </message>
    <message>
        <source>Also in a task, for terminals that show lines in tasks only</source>
        <translation>Aussi dans une tâche, si la console l&apos;exige</translation>
    </message>
</context>
<context>
    <name>FarImageryNotice</name>
    <message>
        <source>This picture does not show the field: it lies %1 away.</source>
        <translation>Cette image ne montre pas la parcelle : elle est à %1.</translation>
    </message>
    <message>
        <source>Go there</source>
        <translation>Y aller</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
</context>
<context>
    <name>FarmHeader</name>
    <message>
        <source>%1, sorted downwards</source>
        <translation>%1, tri décroissant</translation>
    </message>
    <message>
        <source>%1, sorted</source>
        <translation>%1, trié</translation>
    </message>
</context>
<context>
    <name>FarmPanel</name>
    <message>
        <source>The farm</source>
        <translation>L&apos;exploitation</translation>
    </message>
    <message>
        <source>Find a field</source>
        <translation>Chercher une parcelle</translation>
    </message>
    <message>
        <source>Find a field, season or machine</source>
        <translation>Chercher une parcelle, une campagne, une machine</translation>
    </message>
    <message>
        <source>Back to the field (Esc)</source>
        <translation>Retour à la parcelle (Échap)</translation>
    </message>
    <message>
        <source>Field</source>
        <translation>Parcelle</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Machine</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Surface</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Trajet</translation>
    </message>
    <message>
        <source>State</source>
        <translation>État</translation>
    </message>
    <message>
        <source>Fields of the farm</source>
        <translation>Parcelles de l&apos;exploitation</translation>
    </message>
    <message>
        <source>No field has these words.</source>
        <translation>Aucune parcelle ne contient ces mots.</translation>
    </message>
    <message>
        <source>There is no field yet.</source>
        <translation>Il n&apos;y a pas encore de parcelle.</translation>
    </message>
    <message>
        <source>Select none</source>
        <translation>Ne rien sélectionner</translation>
    </message>
    <message>
        <source>Select all</source>
        <translation>Tout sélectionner</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Arrêter</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
    <message numerus="yes">
        <source>Plan %n field(s)</source>
        <translation>
            <numerusform>Planifier %n parcelle</numerusform>
            <numerusform>Planifier %n parcelles</numerusform>
        </translation>
    </message>
    <message>
        <source>Planning …</source>
        <translation>Planification…</translation>
    </message>
    <message>
        <source>All are planned</source>
        <translation>Toutes sont planifiées</translation>
    </message>
    <message>
        <source>Machine and settings of this plan</source>
        <translation>Machine et réglages de ce plan</translation>
    </message>
    <message>
        <source>Add a plan to each…</source>
        <translation>Ajouter un plan à chacune…</translation>
    </message>
    <message>
        <source>Print…</source>
        <translation>Imprimer…</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exporter…</translation>
    </message>
</context>
<context>
    <name>FarmRow</name>
    <message>
        <source>%1, %2, %3</source>
        <translation>%1, %2, %3</translation>
    </message>
</context>
<context>
    <name>FieldActions</name>
    <message>
        <source>Open file…</source>
        <translation>Ouvrir un fichier…</translation>
    </message>
    <message>
        <source>Draw</source>
        <translation>Dessiner</translation>
    </message>
    <message>
        <source>Sample field</source>
        <translation>Parcelle d&apos;exemple</translation>
    </message>
    <message>
        <source>Add one to look at</source>
        <translation>En ajouter une pour voir</translation>
    </message>
</context>
<context>
    <name>FieldChooser</name>
    <message numerus="yes">
        <source>Which of the %n field(s)?</source>
        <translation>
            <numerusform>Quelle parcelle (%n) ?</numerusform>
            <numerusform>Laquelle des %n parcelles ?</numerusform>
        </translation>
    </message>
    <message>
        <source>Open none of them</source>
        <translation>N&apos;en ouvrir aucune</translation>
    </message>
    <message>
        <source>Open all of them</source>
        <translation>Les ouvrir toutes</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
</context>
<context>
    <name>FieldCommands</name>
    <message>
        <source>Field</source>
        <translation>Parcelle</translation>
    </message>
    <message>
        <source>Draw a field</source>
        <translation>Dessiner une parcelle</translation>
    </message>
    <message>
        <source>boundary polygon</source>
        <translation>limite polygone</translation>
    </message>
    <message>
        <source>Make a field from a recorded track…</source>
        <translation>Faire une parcelle d&apos;un trajet enregistré…</translation>
    </message>
    <message>
        <source>boundary driven recorded GPX NMEA log drive around</source>
        <translation>limite roulé enregistré GPX NMEA contour</translation>
    </message>
    <message>
        <source>Draw a hole</source>
        <translation>Dessiner une enclave</translation>
    </message>
    <message>
        <source>Draw an obstacle</source>
        <translation>Dessiner un obstacle</translation>
    </message>
    <message>
        <source>pond tree pole wet</source>
        <translation>mare arbre poteau humide</translation>
    </message>
    <message>
        <source>Draw an AB line</source>
        <translation>Dessiner une ligne AB</translation>
    </message>
    <message>
        <source>guidance curve direction</source>
        <translation>guidage courbe orientation</translation>
    </message>
    <message>
        <source>Draw a split line</source>
        <translation>Dessiner une ligne de partage</translation>
    </message>
    <message>
        <source>cut divide mainland parts</source>
        <translation>couper diviser plein champ parties</translation>
    </message>
    <message>
        <source>Add a gate</source>
        <translation>Ajouter une entrée de parcelle</translation>
    </message>
    <message>
        <source>entry road</source>
        <translation>accès chemin</translation>
    </message>
    <message>
        <source>Select and change</source>
        <translation>Sélectionner et modifier</translation>
    </message>
    <message>
        <source>Make the outline&apos;s steps straight</source>
        <translation>Redresser les marches du contour</translation>
    </message>
    <message>
        <source>pixels image stairs smooth simplify</source>
        <translation>pixels image escalier lisser simplifier</translation>
    </message>
    <message>
        <source>Rename the field…</source>
        <translation>Renommer la parcelle…</translation>
    </message>
    <message>
        <source>Remove the field</source>
        <translation>Retirer la parcelle</translation>
    </message>
    <message>
        <source>delete</source>
        <translation>supprimer</translation>
    </message>
    <message>
        <source>Next field</source>
        <translation>Parcelle suivante</translation>
    </message>
    <message>
        <source>All fields of the farm</source>
        <translation>Toutes les parcelles de l&apos;exploitation</translation>
    </message>
    <message>
        <source>list overview plan all batch totals</source>
        <translation>liste aperçu planifier tous totaux</translation>
    </message>
</context>
<context>
    <name>FieldFromTrackPanel</name>
    <message>
        <source>Field from a track</source>
        <translation>Parcelle d&apos;après un trajet</translation>
    </message>
    <message>
        <source>How it was driven</source>
        <translation>Comment on a roulé</translation>
    </message>
    <message>
        <source>Operating width</source>
        <translation>Largeur de travail</translation>
    </message>
    <message>
        <source>The edge lies outside of the line by</source>
        <translation>Le bord est à l&apos;extérieur de la ligne de</translation>
    </message>
    <message>
        <source>Half a width: the implement ran along the edge</source>
        <translation>Demi-largeur : l&apos;outil longeait le bord</translation>
    </message>
    <message>
        <source>None: the line is the edge</source>
        <translation>Rien : la ligne est le bord</translation>
    </message>
    <message>
        <source>Gaps between strips are closed up to</source>
        <translation>Les vides entre bandes sont fermés jusqu&apos;à</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1 : %2</translation>
    </message>
    <message>
        <source>Make the field</source>
        <translation>Créer la parcelle</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
</context>
<context>
    <name>FieldsToExport</name>
    <message numerus="yes">
        <source>%1 and %n more</source>
        <translation>
            <numerusform>%1 et %n autre</numerusform>
            <numerusform>%1 et %n autres</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1 : %2</translation>
    </message>
    <message>
        <source>%1: the plan has problems and cannot be driven as drawn. The files say so too.</source>
        <translation>%1 : le plan a des problèmes et ne peut être parcouru tel qu’il est tracé. Les fichiers le disent aussi.</translation>
    </message>
</context>
<context>
    <name>FileCommands</name>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>New project</source>
        <translation>Nouveau projet</translation>
    </message>
    <message>
        <source>farm</source>
        <translation>exploitation</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Ouvrir…</translation>
    </message>
    <message>
        <source>boundary import project</source>
        <translation>limite importer projet</translation>
    </message>
    <message>
        <source>Add imagery…</source>
        <translation>Ajouter des images…</translation>
    </message>
    <message>
        <source>GeoTIFF MBTiles aerial photo satellite background heights elevation</source>
        <translation>GeoTIFF MBTiles photo aérienne satellite fond altitude relief</translation>
    </message>
    <message>
        <source>Add a folder of tiles…</source>
        <translation>Ajouter un dossier de tuiles…</translation>
    </message>
    <message>
        <source>imagery XYZ TMS</source>
        <translation>imagerie XYZ TMS</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Enregistrer</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Enregistrer sous…</translation>
    </message>
    <message>
        <source>Export the plan…</source>
        <translation>Exporter le plan…</translation>
    </message>
    <message>
        <source>ISOXML USB terminal</source>
        <translation>ISOXML USB console</translation>
    </message>
    <message>
        <source>Print the work order…</source>
        <translation>Imprimer l&apos;ordre de travail…</translation>
    </message>
    <message>
        <source>print pdf report work order picture printer</source>
        <translation>imprimer PDF rapport ordre de travail image imprimante</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Quitter</translation>
    </message>
</context>
<context>
    <name>FileList</name>
    <message>
        <source>%1, falling</source>
        <translation>%1, décroissant</translation>
    </message>
    <message>
        <source>%1, rising</source>
        <translation>%1, croissant</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Changed</source>
        <translation>Modifié</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>Files of %1</source>
        <translation>Fichiers de %1</translation>
    </message>
    <message>
        <source>Folder %1</source>
        <translation>Dossier %1</translation>
    </message>
    <message>
        <source>%1, %2, %3</source>
        <translation>%1, %2, %3</translation>
    </message>
    <message>
        <source>Reading the folder …</source>
        <translation>Lecture du dossier …</translation>
    </message>
    <message>
        <source>Nothing to choose here.</source>
        <translation>Rien à choisir ici.</translation>
    </message>
</context>
<context>
    <name>FileWindow</name>
    <message>
        <source>The folder around it (Backspace)</source>
        <translation>Le dossier parent (Retour arrière)</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Dossier</translation>
    </message>
    <message>
        <source>New folder…</source>
        <translation>Nouveau dossier…</translation>
    </message>
    <message>
        <source>“%1” is already there. Write over it?</source>
        <translation>« %1 » existe déjà. L&apos;écraser ?</translation>
    </message>
    <message>
        <source>There is no folder “%1”. Make it?</source>
        <translation>Il n&apos;y a pas de dossier « %1 ». Le créer ?</translation>
    </message>
    <message>
        <source>Name of the new folder</source>
        <translation>Nom du nouveau dossier</translation>
    </message>
    <message>
        <source>No</source>
        <translation>Non</translation>
    </message>
    <message>
        <source>Write over it</source>
        <translation>Écraser</translation>
    </message>
    <message>
        <source>Make the folder</source>
        <translation>Créer le dossier</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Which files are shown</source>
        <translation>Quels fichiers sont affichés</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Enregistrer</translation>
    </message>
    <message>
        <source>Choose this folder</source>
        <translation>Choisir ce dossier</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
    <message>
        <source>The folder “%1” cannot be made.</source>
        <translation>Le dossier « %1 » ne peut pas être créé.</translation>
    </message>
    <message>
        <source>There is nothing called “%1”.</source>
        <translation>Il n&apos;y a rien qui s&apos;appelle « %1 ».</translation>
    </message>
    <message>
        <source>Choose files only, or one folder to look into.</source>
        <translation>Choisissez seulement des fichiers, ou un dossier à ouvrir.</translation>
    </message>
    <message>
        <source>Choose a file first.</source>
        <translation>Choisissez d&apos;abord un fichier.</translation>
    </message>
    <message>
        <source>Nothing can be written in “%1”. Choose another folder.</source>
        <translation>Rien ne peut être écrit dans « %1 ». Choisissez un autre dossier.</translation>
    </message>
    <message>
        <source>Give the file a name.</source>
        <translation>Donnez un nom au fichier.</translation>
    </message>
</context>
<context>
    <name>FilesNotice</name>
    <message>
        <source>Keep</source>
        <translation>Garder</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
    <message>
        <source>Throw away</source>
        <translation>Abandonner</translation>
    </message>
    <message>
        <source>Save over it</source>
        <translation>Écraser</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Enregistrer sous…</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Plus tard</translation>
    </message>
</context>
<context>
    <name>Finder</name>
    <message>
        <source>Coordinates, such as 48.1371, 11.5754</source>
        <translation>Coordonnées, comme 48,1371 ; 11,5754</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>Guide</translation>
    </message>
    <message>
        <source>Sample field</source>
        <translation>Parcelle d&apos;exemple</translation>
    </message>
    <message>
        <source>example try</source>
        <translation>exemple essayer</translation>
    </message>
    <message>
        <source>Fields</source>
        <translation>Parcelles</translation>
    </message>
    <message>
        <source>field</source>
        <translation>parcelle</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Remarques</translation>
    </message>
    <message>
        <source>finding</source>
        <translation>remarque</translation>
    </message>
    <message>
        <source>Go to %1</source>
        <translation>Aller à %1</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Carte</translation>
    </message>
</context>
<context>
    <name>FindingRow</name>
    <message>
        <source>Finding %1: %2 %3</source>
        <translation>Remarque %1 : %2 %3</translation>
    </message>
    <message>
        <source>Apply: %1</source>
        <translation>Appliquer : %1</translation>
    </message>
    <message>
        <source>For information</source>
        <translation>Pour information</translation>
    </message>
    <message>
        <source>%1 of %2 of this kind</source>
        <translation>%1 sur %2 de ce genre</translation>
    </message>
    <message>
        <source>The one before, of this kind (Ctrl+Shift+F8)</source>
        <translation>La précédente de ce genre (Ctrl+Maj+F8)</translation>
    </message>
    <message>
        <source>The next of this kind (Ctrl+F8)</source>
        <translation>La suivante de ce genre (Ctrl+F8)</translation>
    </message>
</context>
<context>
    <name>GuidePanel</name>
    <message>
        <source>All chapters</source>
        <translation>Tous les chapitres</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>Guide</translation>
    </message>
    <message>
        <source>Close the guide (Esc)</source>
        <translation>Fermer le guide (Échap)</translation>
    </message>
    <message>
        <source>Search the guide</source>
        <translation>Chercher dans le guide</translation>
    </message>
    <message>
        <source>Nothing is found. Try another word.</source>
        <translation>Rien trouvé. Essayez un autre mot.</translation>
    </message>
</context>
<context>
    <name>HeadingChart</name>
    <message>
        <source>Time by</source>
        <translation>Durée selon</translation>
    </message>
    <message>
        <source>direction</source>
        <translation>orientation</translation>
    </message>
    <message>
        <source>overlap</source>
        <translation>recouvrement</translation>
    </message>
    <message>
        <source>missed</source>
        <translation>non travaillé</translation>
    </message>
    <message>
        <source>turning</source>
        <translation>demi-tours</translation>
    </message>
    <message>
        <source>Time by %1</source>
        <translation>Durée selon %1</translation>
    </message>
    <message>
        <source>Directions of swaths and their times</source>
        <translation>Orientations des passages et leurs durées</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>%1 at least</source>
        <translation>au moins %1</translation>
    </message>
    <message>
        <source>Estimates for the land inside the headland, to and fro. The plan adds headland, short passes and ways.</source>
        <translation>Estimations pour la surface à l’intérieur de la fourrière, en aller et retour. Le plan ajoute la fourrière, les passages courts et les trajets.</translation>
    </message>
    <message>
        <source>Let Furrow search the direction</source>
        <translation>Laisser Furrow chercher l&apos;orientation</translation>
    </message>
</context>
<context>
    <name>HelpCommands</name>
    <message>
        <source>Help</source>
        <translation>Aide</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>Guide</translation>
    </message>
    <message>
        <source>help manual how to documentation</source>
        <translation>aide manuel documentation comment</translation>
    </message>
    <message>
        <source>Take the tour</source>
        <translation>Suivre la visite guidée</translation>
    </message>
    <message>
        <source>help introduction first start</source>
        <translation>aide introduction premier démarrage</translation>
    </message>
    <message>
        <source>Keys and mouse</source>
        <translation>Clavier et souris</translation>
    </message>
    <message>
        <source>shortcuts help</source>
        <translation>raccourcis aide</translation>
    </message>
    <message>
        <source>Report a problem…</source>
        <translation>Signaler un problème…</translation>
    </message>
    <message>
        <source>bug crash support error</source>
        <translation>bogue plantage assistance erreur</translation>
    </message>
    <message>
        <source>About Furrow</source>
        <translation>À propos de Furrow</translation>
    </message>
    <message>
        <source>version licence credits</source>
        <translation>version licence crédits</translation>
    </message>
</context>
<context>
    <name>ImageryDialogs</name>
    <message>
        <source>All files (*)</source>
        <translation>Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Add imagery</source>
        <translation>Ajouter des images</translation>
    </message>
    <message>
        <source>Pictures and heights (%1)</source>
        <translation>Images et altitudes (%1)</translation>
    </message>
    <message>
        <source>Add a folder of tiles</source>
        <translation>Ajouter un dossier de tuiles</translation>
    </message>
</context>
<context>
    <name>ImageryList</name>
    <message>
        <source>Your own pictures and heights: GeoTIFF, MBTiles or a folder of tiles. They stay on this computer.</source>
        <translation>Vos propres images et altitudes : GeoTIFF, MBTiles ou un dossier de tuiles. Elles restent sur cet ordinateur.</translation>
    </message>
    <message>
        <source>Add files…</source>
        <translation>Ajouter des fichiers…</translation>
    </message>
    <message>
        <source>Add a folder of tiles…</source>
        <translation>Ajouter un dossier de tuiles…</translation>
    </message>
</context>
<context>
    <name>ImageryNotice</name>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
</context>
<context>
    <name>ImageryRow</name>
    <message>
        <source>Show all of %1</source>
        <translation>Afficher tout %1</translation>
    </message>
    <message>
        <source>Move %1 up</source>
        <translation>Monter %1</translation>
    </message>
    <message>
        <source>Move %1 down</source>
        <translation>Descendre %1</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>Retirer %1</translation>
    </message>
    <message>
        <source>How strong %1 is</source>
        <translation>Opacité de %1</translation>
    </message>
    <message>
        <source>Opening …</source>
        <translation>Ouverture…</translation>
    </message>
    <message>
        <source>Contour lines every %1</source>
        <translation>Courbes de niveau tous les %1</translation>
    </message>
    <message>
        <source>Rows count from the south (TMS)</source>
        <translation>Lignes comptées depuis le sud (TMS)</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Réessayer</translation>
    </message>
</context>
<context>
    <name>Inspector</name>
    <message>
        <source>Headland</source>
        <translation>Fourrière</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>boundary</source>
        <translation>limite de parcelle</translation>
    </message>
    <message>
        <source>hole</source>
        <translation>enclave</translation>
    </message>
    <message>
        <source>obstacle</source>
        <translation>obstacle</translation>
    </message>
    <message>
        <source>guidance line</source>
        <translation>ligne de guidage</translation>
    </message>
    <message>
        <source>Point %1 of the %2</source>
        <translation>Point %1 (%2)</translation>
    </message>
    <message>
        <source>Drag it on the map, move it by arrow keys, or type where it is.</source>
        <translation>Faites-le glisser sur la carte, déplacez-le avec les flèches ou saisissez sa position.</translation>
    </message>
    <message>
        <source>Latitude</source>
        <translation>Latitude</translation>
    </message>
    <message>
        <source>Longitude</source>
        <translation>Longitude</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Angle</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>AB line</source>
        <translation>Ligne AB</translation>
    </message>
    <message>
        <source>Edge %1 of the %2</source>
        <translation>Côté %1 (%2)</translation>
    </message>
    <message>
        <source>One swath lies on it, the others beside it. Drag it or its ends, or type its direction.</source>
        <translation>Un passage est dessus, les autres à côté. Faites glisser la ligne ou ses extrémités, ou saisissez sa direction.</translation>
    </message>
    <message>
        <source>Drag it to move it sideways; the dot in its middle makes another point.</source>
        <translation>Faites-le glisser pour le déplacer latéralement ; le point en son milieu en crée un autre.</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longueur</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Direction</translation>
    </message>
    <message>
        <source>Obstacle</source>
        <translation>Obstacle</translation>
    </message>
    <message>
        <source>It is not worked, but may be driven on.</source>
        <translation>Il n&apos;est pas travaillé, mais on peut rouler dessus.</translation>
    </message>
    <message>
        <source>It is not worked, and nothing drives nearer than its buffer.</source>
        <translation>Il n&apos;est pas travaillé, et rien ne s&apos;en approche à moins de cette distance.</translation>
    </message>
    <message>
        <source>Buffer</source>
        <translation>Distance</translation>
    </message>
    <message>
        <source>Overhang</source>
        <translation>Débord</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Surface</translation>
    </message>
    <message>
        <source>the end</source>
        <translation>arrivée</translation>
    </message>
    <message>
        <source>swath %1</source>
        <translation>passage %1</translation>
    </message>
    <message>
        <source>pass %1</source>
        <translation>tour de fourrière %1</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>Swath %1</source>
        <translation>Passage %1</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Largeur</translation>
    </message>
    <message>
        <source>Headland pass %1</source>
        <translation>Tour de fourrière %1</translation>
    </message>
    <message>
        <source>Counted from the outside; %1 are worked here in %2.</source>
        <translation>Compté depuis l&apos;extérieur ; %1 sont travaillés ici en %2.</translation>
    </message>
    <message>
        <source>Turn from %1 to %2</source>
        <translation>Demi-tour : %1 → %2</translation>
    </message>
    <message>
        <source>%1 in reverse, in %2.</source>
        <translation>%1 en marche arrière, en %2.</translation>
    </message>
    <message>
        <source>%1 with the implement up, in %2.</source>
        <translation>%1 outil relevé, en %2.</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>Way from %1 to %2</source>
        <translation>Déplacement : %1 → %2</translation>
    </message>
    <message>
        <source>%1 without working, in %2.</source>
        <translation>%1 sans travailler, en %2.</translation>
    </message>
    <message>
        <source>It cannot be driven like this: %1.</source>
        <translation>Ce n&apos;est pas praticable ainsi : %1.</translation>
    </message>
    <message>
        <source>Block %1</source>
        <translation>Sous-parcelle %1</translation>
    </message>
    <message numerus="yes">
        <source>A piece of the field whose %n swath(s) are driven together.</source>
        <translation>
            <numerusform>Un morceau du plein champ avec %n passage.</numerusform>
            <numerusform>Un morceau du plein champ dont les %n passages sont faits ensemble.</numerusform>
        </translation>
    </message>
    <message>
        <source>Swaths</source>
        <translation>Passages</translation>
    </message>
    <message>
        <source>Gate</source>
        <translation>Entrée de parcelle</translation>
    </message>
    <message>
        <source>Here the machine may enter and leave the field. Drag it along the boundary.</source>
        <translation>Ici, la machine peut entrer et sortir. Faites glisser l&apos;entrée le long de la limite.</translation>
    </message>
    <message>
        <source>Guidance curve</source>
        <translation>Courbe de guidage</translation>
    </message>
    <message>
        <source>The swaths lie beside it. Drag its points, or delete it.</source>
        <translation>Les passages sont à côté. Faites glisser ses points, ou supprimez-la.</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Points</translation>
    </message>
    <message>
        <source>Hole</source>
        <translation>Enclave</translation>
    </message>
    <message>
        <source>It is no part of the field. Drag it, or its points and edges.</source>
        <translation>Elle ne fait pas partie de la parcelle. Faites-la glisser, ou ses points et ses côtés.</translation>
    </message>
    <message>
        <source>split line</source>
        <translation>ligne de partage</translation>
    </message>
    <message>
        <source>The field inside the headland is cut along it, where it runs right through. Drag it or its points, or delete it.</source>
        <translation>Le plein champ est coupé le long de cette ligne, là où elle le traverse entièrement. Faites glisser la ligne ou ses points, ou supprimez-la.</translation>
    </message>
    <message>
        <source>Split line %1</source>
        <translation>Ligne de partage %1</translation>
    </message>
    <message>
        <source>%1 with the implement folded, in %2.</source>
        <translation>%1 outil replié, en %2.</translation>
    </message>
    <message>
        <source>Whole turn</source>
        <translation>Demi-tour entier</translation>
    </message>
    <message>
        <source>Driven as number %1 of %2: %3 in %4.</source>
        <translation>Fait en n° %1 sur %2 : %3 en %4.</translation>
    </message>
    <message>
        <source>From the edge</source>
        <translation>Distance du bord</translation>
    </message>
    <message>
        <source>Instead: %1</source>
        <translation>À la place : %1</translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>environ %1</translation>
    </message>
    <message>
        <source>no room</source>
        <translation>pas la place</translation>
    </message>
    <message>
        <source>In the bunker</source>
        <translation>Dans la trémie</translation>
    </message>
    <message>
        <source>In the tank</source>
        <translation>Dans la cuve</translation>
    </message>
    <message>
        <source>Then stands</source>
        <translation>S&apos;arrête ensuite</translation>
    </message>
</context>
<context>
    <name>InspectorPanel</name>
    <message>
        <source>Headland as elsewhere</source>
        <translation>Fourrière comme ailleurs</translation>
    </message>
    <message>
        <source>selected</source>
        <translation>sélection</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1 : %2</translation>
    </message>
    <message>
        <source>May be driven on</source>
        <translation>On peut rouler dessus</translation>
    </message>
    <message>
        <source>Swaths along it</source>
        <translation>Passages parallèles</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Drive from here</source>
        <translation>Parcourir d&apos;ici</translation>
    </message>
</context>
<context>
    <name>KeysDialog</name>
    <message>
        <source>Drag the map, wheel</source>
        <translation>Glisser la carte, molette</translation>
    </message>
    <message>
        <source>move, zoom</source>
        <translation>déplacer, zoomer</translation>
    </message>
    <message>
        <source>Arrows, + and −</source>
        <translation>Flèches, + et −</translation>
    </message>
    <message>
        <source>move the selection or the map, zoom</source>
        <translation>déplacer la sélection ou la carte, zoomer</translation>
    </message>
    <message>
        <source>, and .</source>
        <translation>, et .</translation>
    </message>
    <message>
        <source>the point before, the next point</source>
        <translation>point précédent, suivant</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Entrée</translation>
    </message>
    <message>
        <source>finish drawing; type into the inspector</source>
        <translation>terminer le dessin ; saisir à droite</translation>
    </message>
    <message>
        <source>Alt</source>
        <translation>Alt</translation>
    </message>
    <message>
        <source>no snapping while it is held</source>
        <translation>pas d&apos;accrochage tant qu&apos;elle est enfoncée</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Échap</translation>
    </message>
    <message>
        <source>stop what was begun</source>
        <translation>arrêter ce qui est commencé</translation>
    </message>
    <message>
        <source>Keys and mouse</source>
        <translation>Clavier et souris</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1 : %2</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
</context>
<context>
    <name>LayerSwitches</name>
    <message>
        <source>Boundary</source>
        <translation>Limite de parcelle</translation>
    </message>
    <message>
        <source>Headland</source>
        <translation>Fourrière</translation>
    </message>
    <message>
        <source>Swaths</source>
        <translation>Passages</translation>
    </message>
    <message>
        <source>Order numbers</source>
        <translation>Numéros d&apos;ordre</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Remarques</translation>
    </message>
    <message>
        <source>Imagery</source>
        <translation>Imagerie</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Trajet</translation>
    </message>
    <message>
        <source>Directions</source>
        <translation>Sens de marche</translation>
    </message>
    <message>
        <source>Coverage</source>
        <translation>Travaillé</translation>
    </message>
    <message>
        <source>Worked twice</source>
        <translation>Travaillé deux fois</translation>
    </message>
    <message>
        <source>Missed</source>
        <translation>Non travaillé</translation>
    </message>
    <message>
        <source>Wheel passes</source>
        <translation>Passages de roues</translation>
    </message>
    <message>
        <source>Swath numbers</source>
        <translation>Numéros des passages</translation>
    </message>
</context>
<context>
    <name>LayersPanel</name>
    <message>
        <source>Layers</source>
        <translation>Couches</translation>
    </message>
    <message>
        <source>Close the layers</source>
        <translation>Fermer les couches</translation>
    </message>
    <message>
        <source>Imagery</source>
        <translation>Imagerie</translation>
    </message>
    <message>
        <source>From the network</source>
        <translation>Depuis le réseau</translation>
    </message>
    <message>
        <source>OpenStreetMap</source>
        <translation>OpenStreetMap</translation>
    </message>
    <message>
        <source>Asks openstreetmap.org for what is in view. Off, nothing leaves this computer.</source>
        <translation>Demande à openstreetmap.org ce qui est affiché. Désactivé, rien ne quitte cet ordinateur.</translation>
    </message>
</context>
<context>
    <name>MachineFields</name>
    <message>
        <source>Machine</source>
        <translation>Machine</translation>
    </message>
    <message>
        <source>Back to the original</source>
        <translation>Valeurs d&apos;origine</translation>
    </message>
    <message>
        <source>Keep as your own…</source>
        <translation>Garder dans vos machines…</translation>
    </message>
    <message>
        <source>Remove from your own</source>
        <translation>Retirer de vos machines</translation>
    </message>
</context>
<context>
    <name>Main</name>
    <message>
        <source>%1%2 – Furrow</source>
        <translation>%1%2 – Furrow</translation>
    </message>
    <message>
        <source>Furrow</source>
        <translation>Furrow</translation>
    </message>
    <message>
        <source>Rename the field</source>
        <translation>Renommer la parcelle</translation>
    </message>
    <message>
        <source>Add a plan</source>
        <translation>Ajouter un plan</translation>
    </message>
    <message>
        <source>Rename the plan</source>
        <translation>Renommer le plan</translation>
    </message>
    <message>
        <source>Add a plan to each field</source>
        <translation>Ajouter un plan à chaque parcelle</translation>
    </message>
    <message>
        <source>Keep as a variant</source>
        <translation>Garder comme variante</translation>
    </message>
    <message>
        <source>Keep the machine as</source>
        <translation>Garder la machine sous</translation>
    </message>
    <message>
        <source>This plan: %1</source>
        <translation>Ce plan : %1</translation>
    </message>
</context>
<context>
    <name>MapPage</name>
    <message>
        <source>Map</source>
        <translation>Carte</translation>
    </message>
</context>
<context>
    <name>MapToolBar</name>
    <message>
        <source>Select and change (V)</source>
        <translation>Sélectionner et modifier (V)</translation>
    </message>
    <message>
        <source>Draw a field (B)</source>
        <translation>Dessiner une parcelle (B)</translation>
    </message>
    <message>
        <source>Draw a hole (H)</source>
        <translation>Dessiner une enclave (H)</translation>
    </message>
    <message>
        <source>Draw an obstacle (O)</source>
        <translation>Dessiner un obstacle (O)</translation>
    </message>
    <message>
        <source>Draw an AB line (L)</source>
        <translation>Dessiner une ligne AB (L)</translation>
    </message>
    <message>
        <source>Add a gate (G)</source>
        <translation>Ajouter une entrée de parcelle (G)</translation>
    </message>
    <message>
        <source>Show the whole field (F)</source>
        <translation>Montrer toute la parcelle (F)</translation>
    </message>
    <message>
        <source>Closer (+)</source>
        <translation>Zoom avant (+)</translation>
    </message>
    <message>
        <source>Further away (−)</source>
        <translation>Zoom arrière (−)</translation>
    </message>
    <message>
        <source>Layers (Ctrl+L)</source>
        <translation>Couches (Ctrl+L)</translation>
    </message>
    <message>
        <source>Draw a split line (S)</source>
        <translation>Dessiner une ligne de partage (S)</translation>
    </message>
</context>
<context>
    <name>NameDialog</name>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Season</source>
        <translation>Campagne</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
</context>
<context>
    <name>OnlineMap</name>
    <message>
        <source>© OpenStreetMap contributors</source>
        <translation>© les contributeurs d&apos;OpenStreetMap</translation>
    </message>
</context>
<context>
    <name>OrderEditor</name>
    <message>
        <source>Change the order by hand…</source>
        <translation>Changer l&apos;ordre à la main…</translation>
    </message>
    <message>
        <source>Drag a swath to its new place. Or click swaths on the map: each is driven after the one clicked before.</source>
        <translation>Faites glisser un passage à sa nouvelle place. Ou cliquez sur des passages de la carte : chacun est fait après le précédent.</translation>
    </message>
    <message>
        <source>Order of swaths</source>
        <translation>Ordre des passages</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Terminé</translation>
    </message>
    <message>
        <source>Search the order of the others</source>
        <translation>Chercher l&apos;ordre des autres</translation>
    </message>
    <message>
        <source>Search the order again</source>
        <translation>Chercher l&apos;ordre à nouveau</translation>
    </message>
</context>
<context>
    <name>OrderForm</name>
    <message>
        <source>Status</source>
        <translation>Statut</translation>
    </message>
</context>
<context>
    <name>OrderRow</name>
    <message>
        <source>%1. Swath %2, %3</source>
        <translation>%1. Passage %2, %3</translation>
    </message>
    <message>
        <source>Swath %1</source>
        <translation>Passage %1</translation>
    </message>
    <message>
        <source>Drive swath %1 the other way</source>
        <translation>Parcourir le passage %1 dans l&apos;autre sens</translation>
    </message>
</context>
<context>
    <name>OtherMap</name>
    <message>
        <source>Map of the other plan: %1</source>
        <translation>Carte de l’autre plan : %1</translation>
    </message>
    <message>
        <source>The other plan is being made …</source>
        <translation>L&apos;autre plan est en cours de calcul…</translation>
    </message>
    <message>
        <source>The other: %1</source>
        <translation>L’autre : %1</translation>
    </message>
</context>
<context>
    <name>PageList</name>
    <message>
        <source>Pages</source>
        <translation>Pages</translation>
    </message>
    <message>
        <source>Page %1 of %2</source>
        <translation>Page %1 sur %2</translation>
    </message>
    <message>
        <source>Planning for the pages …</source>
        <translation>Planification pour les pages …</translation>
    </message>
    <message>
        <source>Stopped before there were pages.</source>
        <translation>Arrêté avant que les pages soient prêtes.</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Réessayer</translation>
    </message>
</context>
<context>
    <name>ParameterField</name>
    <message>
        <source>Auto</source>
        <translation>Auto</translation>
    </message>
    <message>
        <source>%1: let Furrow choose</source>
        <translation>%1 : laisser Furrow choisir</translation>
    </message>
    <message>
        <source>as text</source>
        <translation>en texte</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Choisir…</translation>
    </message>
    <message>
        <source>On the map</source>
        <translation>Sur la carte</translation>
    </message>
    <message>
        <source>As text</source>
        <translation>En texte</translation>
    </message>
    <message>
        <source>%1 as text</source>
        <translation>%1 en texte</translation>
    </message>
    <message>
        <source>not chosen</source>
        <translation>non choisi</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Retirer</translation>
    </message>
    <message>
        <source>%1: remove</source>
        <translation>%1 : retirer</translation>
    </message>
</context>
<context>
    <name>Pickers</name>
    <message>
        <source>Click the place on the map. Esc ends it.</source>
        <translation>Cliquez sur l&apos;endroit sur la carte. Échap pour arrêter.</translation>
    </message>
    <message>
        <source>Click the places on the map</source>
        <translation>Cliquez les endroits sur la carte</translation>
    </message>
    <message>
        <source>Click another place, or one of them to remove it</source>
        <translation>Cliquez un autre endroit, ou l&apos;un d&apos;eux pour l&apos;enlever</translation>
    </message>
</context>
<context>
    <name>PlacesPicker</name>
    <message>
        <source>Place %1: remove it</source>
        <translation>Endroit %1 : l&apos;enlever</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Terminé</translation>
    </message>
</context>
<context>
    <name>PlanCommands</name>
    <message>
        <source>Plan</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>Drive-through</source>
        <translation>Parcours</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>Relecture</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Remarques</translation>
    </message>
    <message>
        <source>Add a plan…</source>
        <translation>Ajouter un plan…</translation>
    </message>
    <message>
        <source>season operation copy</source>
        <translation>campagne opération copie</translation>
    </message>
    <message>
        <source>Compare with another plan</source>
        <translation>Comparer avec un autre plan</translation>
    </message>
    <message>
        <source>compare variants differences side by side better</source>
        <translation>comparer variantes différences côte à côte meilleur</translation>
    </message>
    <message>
        <source>Compare on two maps</source>
        <translation>Comparer sur deux cartes</translation>
    </message>
    <message>
        <source>compare side by side split map</source>
        <translation>comparer côte à côte carte partagée deux</translation>
    </message>
    <message>
        <source>Compare with a recorded track…</source>
        <translation>Comparer à un trajet enregistré…</translation>
    </message>
    <message>
        <source>driven recorded GPX NMEA log cross-track error compare</source>
        <translation>parcouru enregistré GPX NMEA écart comparer</translation>
    </message>
    <message>
        <source>Rename the plan…</source>
        <translation>Renommer le plan…</translation>
    </message>
    <message>
        <source>Remove the plan</source>
        <translation>Retirer le plan</translation>
    </message>
    <message>
        <source>delete</source>
        <translation>supprimer</translation>
    </message>
    <message>
        <source>Plan again</source>
        <translation>Planifier à nouveau</translation>
    </message>
    <message>
        <source>Find the best plan…</source>
        <translation>Chercher le meilleur plan…</translation>
    </message>
    <message>
        <source>quickest optimise compare alternatives</source>
        <translation>plus rapide optimiser comparer alternatives</translation>
    </message>
    <message>
        <source>Change the order by hand…</source>
        <translation>Changer l&apos;ordre à la main…</translation>
    </message>
    <message>
        <source>order swaths list drag sequence</source>
        <translation>ordre passages liste glisser suite</translation>
    </message>
    <message>
        <source>Drive through the plan</source>
        <translation>Parcourir le plan</translation>
    </message>
    <message>
        <source>Pause the drive</source>
        <translation>Mettre le parcours en pause</translation>
    </message>
    <message>
        <source>drive play pause simulate machine</source>
        <translation>parcourir lecture pause simuler machine</translation>
    </message>
    <message>
        <source>Drive from what is selected</source>
        <translation>Parcourir depuis la sélection</translation>
    </message>
    <message>
        <source>drive play here swath turn</source>
        <translation>parcourir ici passage demi-tour</translation>
    </message>
    <message>
        <source>Drive faster</source>
        <translation>Parcourir plus vite</translation>
    </message>
    <message>
        <source>pace speed</source>
        <translation>rythme vitesse</translation>
    </message>
    <message>
        <source>Drive slower</source>
        <translation>Parcourir plus lentement</translation>
    </message>
    <message>
        <source>Comment on a place…</source>
        <translation>Commenter un endroit…</translation>
    </message>
    <message>
        <source>review note remark pin</source>
        <translation>relecture note remarque endroit</translation>
    </message>
    <message>
        <source>Comment on the whole plan…</source>
        <translation>Commenter tout le plan…</translation>
    </message>
    <message>
        <source>review note remark</source>
        <translation>relecture note remarque</translation>
    </message>
    <message>
        <source>contractor share file approve</source>
        <translation>entrepreneur partager fichier approuver</translation>
    </message>
    <message>
        <source>Take in a review that came back…</source>
        <translation>Reprendre une relecture revenue…</translation>
    </message>
    <message>
        <source>merge comments contractor</source>
        <translation>fusionner commentaires entrepreneur</translation>
    </message>
    <message>
        <source>Next finding</source>
        <translation>Remarque suivante</translation>
    </message>
    <message>
        <source>problem check step through</source>
        <translation>problème contrôle parcourir</translation>
    </message>
    <message>
        <source>Previous finding</source>
        <translation>Remarque précédente</translation>
    </message>
    <message>
        <source>problem check step back</source>
        <translation>problème contrôle retour</translation>
    </message>
    <message>
        <source>Next finding of the same kind</source>
        <translation>Remarque suivante du même genre</translation>
    </message>
    <message>
        <source>Previous finding of the same kind</source>
        <translation>Remarque précédente du même genre</translation>
    </message>
</context>
<context>
    <name>PlanTitle</name>
    <message>
        <source>%1 wide</source>
        <translation>%1 de large</translation>
    </message>
    <message>
        <source>takes %1</source>
        <translation>durée %1</translation>
    </message>
    <message>
        <source>planned %1</source>
        <translation>planifié le %1</translation>
    </message>
</context>
<context>
    <name>Planner</name>
    <message>
        <source> and twice %1 of margin</source>
        <translation> et deux fois %1 de marge</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 et %2</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 et %2 autres</translation>
    </message>
    <message>
        <source>%1 are driven in reverse; the trailed implement cannot.</source>
        <translation>%1 sont faits en marche arrière ; l&apos;outil traîné ne le peut pas.</translation>
    </message>
    <message>
        <source>%1 are driven in reverse; this machine cannot.</source>
        <translation>%1 sont faits en marche arrière ; cette machine ne le peut pas.</translation>
    </message>
    <message>
        <source>%1 are not worked, %2 of the field, in %3; this is the largest.</source>
        <translation>%1 ne sont pas travaillés, %2 de la parcelle, en %3 ; voici la plus grande zone non travaillée.</translation>
    </message>
    <message>
        <source>%1 bends with a radius of %2; this machine needs %3.</source>
        <translation>%1 a des courbes de %2 de rayon ; cette machine a besoin de %3.</translation>
    </message>
    <message>
        <source>%1 cannot be driven: %2.</source>
        <translation>%1 n&apos;est pas praticable : %2.</translation>
    </message>
    <message>
        <source>%1 cannot be made: %2</source>
        <translation>%1 ne peut pas être créé : %2</translation>
    </message>
    <message>
        <source>%1 crosses an obstacle, by %2.</source>
        <translation>%1 empiète de %2 sur un obstacle.</translation>
    </message>
    <message>
        <source>%1 crosses an obstacle.</source>
        <translation>%1 traverse un obstacle.</translation>
    </message>
    <message>
        <source>%1 does not fit here</source>
        <translation>%1 ne convient pas ici</translation>
    </message>
    <message>
        <source>%1 for transport is wider than the machine at work, %2</source>
        <translation>%1 pour le transport, c&apos;est plus large que la machine au travail, %2</translation>
    </message>
    <message>
        <source>%1 holds no positions</source>
        <translation>%1 ne contient aucune position</translation>
    </message>
    <message>
        <source>%1 in one piece are not worked.</source>
        <translation>%1 d&apos;un seul tenant ne sont pas travaillés.</translation>
    </message>
    <message>
        <source>%1 is %2 wide; this machine is %3 wide for transport.</source>
        <translation>%1 fait %2 de large ; cette machine fait %3 de large pour le transport.</translation>
    </message>
    <message>
        <source>%1 is not a whole number</source>
        <translation>%1 n&apos;est pas un nombre entier</translation>
    </message>
    <message>
        <source>%1 is on the stick already</source>
        <translation>%1 est déjà sur la clé</translation>
    </message>
    <message>
        <source>%1 is out of range</source>
        <translation>%1 est hors des valeurs admises</translation>
    </message>
    <message>
        <source>%1 is planned, but nothing of it is driven with the implement down.</source>
        <translation>%1 est prévu, mais rien n&apos;en est fait outil baissé.</translation>
    </message>
    <message>
        <source>%1 is planned, but only %2 of it is driven with the implement down.</source>
        <translation>%1 est prévu, mais seulement %2 en est fait outil baissé.</translation>
    </message>
    <message>
        <source>%1 jumps by %2.</source>
        <translation>%1 saute de %2.</translation>
    </message>
    <message>
        <source>%1 leads from one part of the field to another that this machine cannot drive to.</source>
        <translation>%1 mène d&apos;une partie de la parcelle à une autre que cette machine ne peut pas atteindre.</translation>
    </message>
    <message>
        <source>%1 leaves the field by %2.</source>
        <translation>%1 sort de la parcelle de %2.</translation>
    </message>
    <message>
        <source>%1 leaves the field or crosses an obstacle, by up to %2, as this plan allows.</source>
        <translation>%1 sort de la parcelle ou empiète sur un obstacle, de %2 au plus, comme ce plan le permet.</translation>
    </message>
    <message>
        <source>%1 moves %2 off where the machine points.</source>
        <translation>%1 s&apos;écarte de %2 du cap de la machine.</translation>
    </message>
    <message>
        <source>%1 needs %2</source>
        <translation>%1 demande : %2</translation>
    </message>
    <message>
        <source>%1 of %2 guidance lines of &apos;%3&apos; are there</source>
        <translation>%1 lignes de guidage sur %2 de « %3 » y sont</translation>
    </message>
    <message>
        <source>%1 of %2 swaths are not in the order: %3</source>
        <translation>%1 passages sur %2 ne sont pas dans l&apos;ordre : %3</translation>
    </message>
    <message>
        <source>%1 of %2 tracks are of another place and were left out</source>
        <translation>%1 trajets sur %2 sont d&apos;un autre endroit et ont été laissés de côté</translation>
    </message>
    <message>
        <source>%1 of its sentences have a wrong checksum</source>
        <translation>%1 de ses phrases ont une somme de contrôle fausse</translation>
    </message>
    <message>
        <source>%1 of margin leaves nothing of the field to work</source>
        <translation>%1 de marge ne laissent rien de la parcelle à travailler</translation>
    </message>
    <message>
        <source>%1 of the positions jump away and back</source>
        <translation>%1 des positions sautent ailleurs et reviennent</translation>
    </message>
    <message>
        <source>%1 reads back other bytes than were written</source>
        <translation>%1, relu, ne correspond pas à ce qui a été écrit</translation>
    </message>
    <message>
        <source>%1 small patches of worked pixels are left out</source>
        <translation>%1 petites taches de pixels travaillés sont laissées de côté</translation>
    </message>
    <message>
        <source>%1 swaths and turns leave the field or cross an obstacle, by up to %2, as this plan allows.</source>
        <translation>%1 passages et demi-tours sortent de la parcelle ou empiètent sur un obstacle, de %2 au plus, comme ce plan le permet.</translation>
    </message>
    <message>
        <source>%1, %2 is more than 1,000 km from the plan</source>
        <translation>%1, %2 est à plus de 1 000 km du plan</translation>
    </message>
    <message>
        <source>%1, %2 is no longitude and latitude</source>
        <translation>%1, %2 n&apos;est pas une longitude et une latitude</translation>
    </message>
    <message>
        <source>%1, %2 is no longitude and latitude, and the file does not say which coordinate system it uses</source>
        <translation>%1, %2 n&apos;est pas une longitude et une latitude, et le fichier ne dit pas quel système de coordonnées il utilise</translation>
    </message>
    <message>
        <source>%1, %2 is outside longitude -180 to 180 and latitude -90 to 90</source>
        <translation>%1, %2 est hors de la longitude -180 à 180 et de la latitude -90 à 90</translation>
    </message>
    <message>
        <source>%1, %2, line %3</source>
        <translation>%1, %2, ligne %3</translation>
    </message>
    <message>
        <source>%1, %2, point %3</source>
        <translation>%1, %2, point %3</translation>
    </message>
    <message>
        <source>%1, byte %2</source>
        <translation>%1, octet %2</translation>
    </message>
    <message>
        <source>%1, feature %2</source>
        <translation>%1, objet %2</translation>
    </message>
    <message>
        <source>%1, gate %2</source>
        <translation>%1, entrée de parcelle %2</translation>
    </message>
    <message>
        <source>%1, hole %2</source>
        <translation>%1, enclave %2</translation>
    </message>
    <message>
        <source>%1, line %2</source>
        <translation>%1, ligne %2</translation>
    </message>
    <message>
        <source>%1, obstacle %2</source>
        <translation>%1, obstacle %2</translation>
    </message>
    <message>
        <source>%1, point %2</source>
        <translation>%1, point %2</translation>
    </message>
    <message>
        <source>%1, row %2</source>
        <translation>%1, ligne %2</translation>
    </message>
    <message>
        <source>%1.bin is not there</source>
        <translation>%1.bin manque</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1 : %2</translation>
    </message>
    <message>
        <source>%1: the setting %2 is not used: %3</source>
        <translation>%1 : le réglage %2 n&apos;est pas utilisé : %3</translation>
    </message>
    <message>
        <source>%1; %2 × other turns</source>
        <translation>%1 ; %2 × autres demi-tours</translation>
    </message>
    <message>
        <source>%1; what it belongs to was left out</source>
        <translation>%1 ; ce dont cela fait partie a été laissé de côté</translation>
    </message>
    <message numerus="yes">
        <source>%n areas are neither field, hole nor obstacle by their layer or kind and were not used</source>
        <translation>
            <numerusform>%n surface n&apos;est, d&apos;après son calque ou son type, ni parcelle, ni enclave, ni obstacle et n&apos;a pas été utilisée</numerusform>
            <numerusform>%n surfaces ne sont, d&apos;après leur calque ou leur type, ni parcelle, ni enclave, ni obstacle et n&apos;ont pas été utilisées</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n areas in the file are neither field nor obstacle and were not used</source>
        <translation>
            <numerusform>%n surface du fichier n&apos;est ni parcelle ni obstacle et n&apos;a pas été utilisée</numerusform>
            <numerusform>%n surfaces du fichier ne sont ni parcelle ni obstacle et n&apos;ont pas été utilisées</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n damaged lines were passed over</source>
        <translation>
            <numerusform>%n ligne endommagée a été passée</numerusform>
            <numerusform>%n lignes endommagées ont été passées</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n entries without a shape</source>
        <translation>
            <numerusform>%n entrée sans forme</numerusform>
            <numerusform>%n entrées sans forme</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n fields</source>
        <translation>
            <numerusform>%n parcelle</numerusform>
            <numerusform>%n parcelles</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n messages without a position were passed over</source>
        <translation>
            <numerusform>%n message sans position a été passé</numerusform>
            <numerusform>%n messages sans position ont été passés</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n open lines</source>
        <translation>
            <numerusform>%n ligne ouverte</numerusform>
            <numerusform>%n lignes ouvertes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n passes</source>
        <translation>
            <numerusform>%n tour</numerusform>
            <numerusform>%n tours</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pieces</source>
        <translation>
            <numerusform>%n morceau</numerusform>
            <numerusform>%n morceaux</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n places</source>
        <translation>
            <numerusform>%n endroit</numerusform>
            <numerusform>%n endroits</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n points</source>
        <translation>
            <numerusform>%n point</numerusform>
            <numerusform>%n points</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n points were given twice and taken once</source>
        <translation>
            <numerusform>%n point était donné deux fois et compte une fois</numerusform>
            <numerusform>%n points étaient donnés deux fois et comptent une fois</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n positions that jumped away were left out</source>
        <translation>
            <numerusform>%n position qui avait sauté ailleurs a été laissée de côté</numerusform>
            <numerusform>%n positions qui avaient sauté ailleurs ont été laissées de côté</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n records without a position were passed over</source>
        <translation>
            <numerusform>%n enregistrement sans position a été passé</numerusform>
            <numerusform>%n enregistrements sans position ont été passés</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n reports without a position were passed over</source>
        <translation>
            <numerusform>%n rapport sans position a été passé</numerusform>
            <numerusform>%n rapports sans position ont été passés</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n rings did not end where they began and were closed</source>
        <translation>
            <numerusform>%n contour ne finissait pas là où il commence et a été fermé</numerusform>
            <numerusform>%n contours ne finissaient pas là où ils commencent et ont été fermés</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n rings ran the wrong way round and were turned</source>
        <translation>
            <numerusform>%n contour tournait à l&apos;envers et a été retourné</numerusform>
            <numerusform>%n contours tournaient à l&apos;envers et ont été retournés</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n rows without a position were passed over</source>
        <translation>
            <numerusform>%n ligne sans position a été passée</numerusform>
            <numerusform>%n lignes sans position ont été passées</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sentences with a wrong checksum were passed over</source>
        <translation>
            <numerusform>%n phrase à la somme de contrôle fausse a été passée</numerusform>
            <numerusform>%n phrases à la somme de contrôle fausse ont été passées</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sentences without a position were passed over</source>
        <translation>
            <numerusform>%n phrase sans position a été passée</numerusform>
            <numerusform>%n phrases sans position ont été passées</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n spikes without area were removed</source>
        <translation>
            <numerusform>%n pointe sans surface a été retirée</numerusform>
            <numerusform>%n pointes sans surface ont été retirées</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n stretches of one strip were left out, as ways to the field: %1 together</source>
        <translation>
            <numerusform>%n tronçon d&apos;une seule bande a été laissé de côté, comme chemin vers la parcelle : %1</numerusform>
            <numerusform>%n tronçons d&apos;une seule bande ont été laissés de côté, comme chemins vers la parcelle : %1 en tout</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n turns</source>
        <translation>
            <numerusform>%n demi-tour</numerusform>
            <numerusform>%n demi-tours</numerusform>
        </translation>
    </message>
    <message>
        <source>&apos;%1&apos; files hold no recorded track</source>
        <translation>les fichiers « %1 » ne contiennent aucun trajet enregistré</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is left out: its kind %2 is not known</source>
        <translation>« %1 » est laissé de côté : son type %2 est inconnu</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no length</source>
        <translation>« %1 » n&apos;est pas une longueur</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no local frame</source>
        <translation>« %1 » n&apos;est pas un repère local</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not %2</source>
        <translation>« %1 » n&apos;est pas : %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a line</source>
        <translation>« %1 » n&apos;est pas une ligne</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not well-known text</source>
        <translation>« %1 » n&apos;est pas du well-known text</translation>
    </message>
    <message>
        <source>&apos;%1&apos;, &apos;%2&apos; is no latitude and longitude</source>
        <translation>« %1 », « %2 » n&apos;est pas une latitude et une longitude</translation>
    </message>
    <message>
        <source>&apos;%1&apos;, &apos;%2&apos; is no longitude and latitude</source>
        <translation>« %1 », « %2 » n&apos;est pas une longitude et une latitude</translation>
    </message>
    <message>
        <source>&apos;%1&apos;, &apos;%2&apos; is no position</source>
        <translation>« %1 », « %2 » n&apos;est pas une position</translation>
    </message>
    <message>
        <source>A and B are %1 apart</source>
        <translation>A et B sont à %1 l&apos;un de l&apos;autre</translation>
    </message>
    <message>
        <source>A bulb to both sides; for swaths nearer than two turning radii.</source>
        <translation>S&apos;élargit des deux côtés ; pour des passages à moins de deux rayons de braquage.</translation>
    </message>
    <message>
        <source>A bulb to one side and straight back; for swaths nearer than two turning radii.</source>
        <translation>S&apos;élargit d&apos;un côté, puis retour droit ; pour des passages à moins de deux rayons de braquage.</translation>
    </message>
    <message>
        <source>A block gets a heading of its own where that saves time.</source>
        <translation>Une sous-parcelle a sa propre orientation là où cela fait gagner du temps.</translation>
    </message>
    <message>
        <source>A file of lines: planted rows, or the tramlines of a plan.</source>
        <translation>Un fichier de lignes : rangs plantés, ou passages de pulvérisateur d&apos;un plan.</translation>
    </message>
    <message>
        <source>A gate&apos;s name or a point; the first gate where nothing is given.</source>
        <translation>Nom d&apos;une entrée ou un point ; la première entrée si rien n&apos;est donné.</translation>
    </message>
    <message>
        <source>A goal of opennav_coverage has one outline: %1 of %2 parts are left out.</source>
        <translation>Un objectif opennav_coverage a un contour : %1 parties sur %2 sont laissées de côté.</translation>
    </message>
    <message>
        <source>A raster of heights in metres that covers the field, such as a GeoTIFF.</source>
        <translation>Une grille d&apos;altitudes en mètres qui couvre la parcelle, par exemple un GeoTIFF.</translation>
    </message>
    <message>
        <source>A robot with ROS 2</source>
        <translation>Un robot avec ROS 2</translation>
    </message>
    <message>
        <source>A snake within each cluster of swaths, cluster after cluster.</source>
        <translation>Un serpentin dans chaque groupe de passages, groupe après groupe.</translation>
    </message>
    <message>
        <source>A strip of the same width along the boundary and around obstacles, for turning.</source>
        <translation>Une bande de même largeur le long de la limite et autour des obstacles, pour tourner.</translation>
    </message>
    <message>
        <source>A+</source>
        <translation>A+</translation>
    </message>
    <message>
        <source>AB curve</source>
        <translation>Courbe AB</translation>
    </message>
    <message>
        <source>AB line</source>
        <translation>Ligne AB</translation>
    </message>
    <message>
        <source>Across the slope: beside a line of equal height, and a new one where that no longer fits.</source>
        <translation>En travers de la pente : à côté d&apos;une courbe de niveau, et d&apos;une autre là où cela ne va plus.</translation>
    </message>
    <message>
        <source>After the swaths</source>
        <translation>Après les passages</translation>
    </message>
    <message>
        <source>AgBot</source>
        <translation>AgBot</translation>
    </message>
    <message>
        <source>AgGPS folder</source>
        <translation>Dossier AgGPS</translation>
    </message>
    <message>
        <source>AgOpenGPS 6, import of ISOXML</source>
        <translation>AgOpenGPS 6, import ISOXML</translation>
    </message>
    <message>
        <source>AgOpenGPS drives recorded paths forwards only, and this one reverses %1 times: its %2 forward stretches are &apos;Part 01.rec&apos; and so on, RecPath.txt is the first; %3 under 5 m are left out.</source>
        <translation>AgOpenGPS ne suit les trajets enregistrés qu&apos;en avant, et celui-ci recule %1 fois : ses %2 tronçons avant sont &apos;Part 01.rec&apos; et suivants, RecPath.txt est le premier ; %3 de moins de 5 m sont laissés de côté.</translation>
    </message>
    <message>
        <source>AgOpenGPS field</source>
        <translation>Parcelle AgOpenGPS</translation>
    </message>
    <message>
        <source>AgOpenGPS keeps one outline to a field: the %1 parts of &apos;%2&apos; are fields of their own, and the whole path is in the first.</source>
        <translation>AgOpenGPS garde un contour par parcelle : les %1 parties de « %2 » sont des parcelles à part, et tout le trajet est dans la première.</translation>
    </message>
    <message>
        <source>AgOpenGPS keeps one outline to a field: the %1 parts of &apos;%2&apos; are fields of their own.</source>
        <translation>AgOpenGPS garde un contour par parcelle : les %1 parties de « %2 » sont des parcelles à part.</translation>
    </message>
    <message>
        <source>All swaths along the edge of the boundary that you pick.</source>
        <translation>Tous les passages le long du côté de la limite choisi.</translation>
    </message>
    <message>
        <source>All swaths along the longest straight edge inside the headland.</source>
        <translation>Tous les passages le long du plus long côté droit du plein champ.</translation>
    </message>
    <message>
        <source>All swaths in the direction that you type.</source>
        <translation>Tous les passages dans la direction saisie.</translation>
    </message>
    <message>
        <source>Along an edge</source>
        <translation>Le long d&apos;un côté</translation>
    </message>
    <message>
        <source>Along each edge as wide as the turns there need it; a single pass where no swath ends, or nothing if it is not worked.</source>
        <translation>Le long de chaque côté, aussi large que les demi-tours l&apos;exigent ; un seul passage là où aucun ne finit, ou rien si elle n&apos;est pas travaillée.</translation>
    </message>
    <message>
        <source>Along rows that are there already, or between them.</source>
        <translation>Le long de rangs déjà là, ou entre eux.</translation>
    </message>
    <message>
        <source>Along the boundary</source>
        <translation>Le long de la limite</translation>
    </message>
    <message>
        <source>Along the contours</source>
        <translation>Selon les courbes de niveau</translation>
    </message>
    <message>
        <source>Along the direction of travel.</source>
        <translation>Dans le sens de la marche.</translation>
    </message>
    <message>
        <source>Along the headland</source>
        <translation>Par la fourrière</translation>
    </message>
    <message>
        <source>Along the line from A to B; one swath lies on it.</source>
        <translation>Le long de la ligne de A à B ; un passage est dessus.</translation>
    </message>
    <message>
        <source>Along the longest edge</source>
        <translation>Le long du plus long côté</translation>
    </message>
    <message>
        <source>An older ISOBUS terminal</source>
        <translation>Une console ISOBUS plus ancienne</translation>
    </message>
    <message>
        <source>Another ISOBUS terminal</source>
        <translation>Une autre console ISOBUS</translation>
    </message>
    <message>
        <source>Anywhere</source>
        <translation>Partout</translation>
    </message>
    <message>
        <source>Arc, straight, arc; for swaths at least two turning radii apart.</source>
        <translation>Arc, droite, arc ; pour des passages distants d&apos;au moins deux rayons de braquage.</translation>
    </message>
    <message>
        <source>Choose the best that fits, which takes the quickest everywhere.</source>
        <translation>Choisissez « Le meilleur qui passe », qui prend partout le plus rapide.</translation>
    </message>
    <message>
        <source>Joined where that is quicker</source>
        <translation>Réunies là où c&apos;est plus rapide</translation>
    </message>
    <message>
        <source>As few swaths, and so turns, as possible.</source>
        <translation>Aussi peu de passages, donc de demi-tours, que possible.</translation>
    </message>
    <message>
        <source>At obstacles</source>
        <translation>Aux obstacles</translation>
    </message>
    <message>
        <source>At the left edge</source>
        <translation>Au bord gauche</translation>
    </message>
    <message>
        <source>At the right edge</source>
        <translation>Au bord droit</translation>
    </message>
    <message>
        <source>At the start of the first swath.</source>
        <translation>Au début du premier passage.</translation>
    </message>
    <message>
        <source>Before the swaths</source>
        <translation>Avant les passages</translation>
    </message>
    <message>
        <source>Beside a curve of your own, or beside the edges around the one that you pick.</source>
        <translation>À côté d&apos;une courbe à vous, ou des côtés autour de celui choisi.</translation>
    </message>
    <message>
        <source>Best heading</source>
        <translation>Meilleure orientation</translation>
    </message>
    <message>
        <source>Best of all headings</source>
        <translation>Meilleure de toutes</translation>
    </message>
    <message>
        <source>Best that fits</source>
        <translation>Le meilleur qui passe</translation>
    </message>
    <message>
        <source>Between the fixed and the steered axle.</source>
        <translation>Entre l&apos;essieu fixe et l&apos;essieu directeur.</translation>
    </message>
    <message>
        <source>Between the headings that are tried.</source>
        <translation>Entre les orientations essayées.</translation>
    </message>
    <message>
        <source>Between the rows</source>
        <translation>Entre les rangs</translation>
    </message>
    <message>
        <source>Boundaries in longitude and latitude.</source>
        <translation>Limites en longitude et latitude.</translation>
    </message>
    <message>
        <source>Boundaries, also field files of Fields2Cover and GAOS.</source>
        <translation>Limites, aussi les fichiers de Fields2Cover et GAOS.</translation>
    </message>
    <message>
        <source>Boundaries.</source>
        <translation>Limites de parcelle.</translation>
    </message>
    <message>
        <source>Boundary and guidance lines for Trimble and FM displays; no driving order.</source>
        <translation>Limite et lignes de guidage pour consoles Trimble et FM ; pas d&apos;ordre des passages.</translation>
    </message>
    <message>
        <source>Boundary, headland, heading and order; the robot lays swaths and turns itself.</source>
        <translation>Limite, fourrière, orientation et ordre ; le robot trace passages et demi-tours lui-même.</translation>
    </message>
    <message>
        <source>Boundary, holes, headland, guidance lines, and the whole driven path as a recorded path.</source>
        <translation>Limite, enclaves, fourrière, lignes de guidage et tout le trajet comme trajet enregistré.</translation>
    </message>
    <message>
        <source>Boundary, holes, obstacles and guidance lines for older terminals; no headland, no driving order.</source>
        <translation>Limite, enclaves, obstacles et lignes de guidage pour consoles anciennes ; ni fourrière ni ordre des passages.</translation>
    </message>
    <message>
        <source>Boundary, holes, obstacles, gates, headland and guidance lines for terminals; no driving order.</source>
        <translation>Limite, enclaves, obstacles, entrées, fourrière et lignes de guidage pour consoles ; pas d&apos;ordre des passages.</translation>
    </message>
    <message>
        <source>Boundary, holes, obstacles, headland, swaths and path in metres of the UTM zone.</source>
        <translation>Limite, enclaves, obstacles, fourrière, passages et trajet en mètres de la zone UTM.</translation>
    </message>
    <message>
        <source>Boundary, obstacles, gates, headland, swaths and path, to look at.</source>
        <translation>Limite, obstacles, entrées, fourrière, passages et trajet, pour regarder.</translation>
    </message>
    <message>
        <source>Boundary, obstacles, gates, headland, swaths, path and findings; for maps and programs.</source>
        <translation>Limite, obstacles, entrées, fourrière, passages, trajet et remarques ; pour cartes et programmes.</translation>
    </message>
    <message>
        <source>Boundary, obstacles, gates, inside of the headland, swaths and path as layers for a GIS.</source>
        <translation>Limite, obstacles, entrées, plein champ, passages et trajet en couches pour un SIG.</translation>
    </message>
    <message>
        <source>Boundary, obstacles, gates, inside of the headland, swaths and path, a shapefile of each.</source>
        <translation>Limite, obstacles, entrées, plein champ, passages et trajet, un shapefile pour chacun.</translation>
    </message>
    <message>
        <source>Bringing the crop in: headland first, swaths overlap a little.</source>
        <translation>Rentrer la récolte : fourrière d&apos;abord, léger recouvrement des passages.</translation>
    </message>
    <message>
        <source>CSV table</source>
        <translation>Tableau CSV</translation>
    </message>
    <message>
        <source>Can reverse</source>
        <translation>Peut reculer</translation>
    </message>
    <message>
        <source>Can turn in place</source>
        <translation>Peut tourner sur place</translation>
    </message>
    <message>
        <source>Carried by the tractor, or pulled on a hitch and following its own track.</source>
        <translation>Porté par le tracteur, ou traîné à l&apos;attelage et suivant sa propre trace.</translation>
    </message>
    <message>
        <source>Blocks</source>
        <translation>Sous-parcelles</translation>
    </message>
    <message>
        <source>Centre line</source>
        <translation>Ligne médiane</translation>
    </message>
    <message>
        <source>Check that the machine stays inside the field while it turns.</source>
        <translation>Vérifiez que la machine reste dans la parcelle en tournant.</translation>
    </message>
    <message>
        <source>Choose another place.</source>
        <translation>Choisissez un autre endroit.</translation>
    </message>
    <message>
        <source>Circles</source>
        <translation>Cercles</translation>
    </message>
    <message>
        <source>Clockwise</source>
        <translation>Sens horaire</translation>
    </message>
    <message>
        <source>Cluster</source>
        <translation>Groupe</translation>
    </message>
    <message>
        <source>Combine harvester, 7.5 m header</source>
        <translation>Moissonneuse-batteuse, coupe 7,5 m</translation>
    </message>
    <message>
        <source>Corners</source>
        <translation>Coins</translation>
    </message>
    <message>
        <source>Counter-clockwise</source>
        <translation>Sens antihoraire</translation>
    </message>
    <message>
        <source>Crop protection: headland first, ways along the headland.</source>
        <translation>Protection des cultures : fourrière d&apos;abord, déplacements par la fourrière.</translation>
    </message>
    <message>
        <source>Curves are driven with up to %1 sideways; the machine&apos;s limit is less.</source>
        <translation>Les courbes sont prises avec %1 de côté au plus ; la limite de la machine est inférieure.</translation>
    </message>
    <message>
        <source>Curves with reversing</source>
        <translation>Courbes avec marche arrière</translation>
    </message>
    <message>
        <source>Curves with reversing, smooth steering</source>
        <translation>Courbes avec recul, braquage progressif</translation>
    </message>
    <message>
        <source>Cut along the swaths at every corner, sharp or rounded.</source>
        <translation>Découpé le long des passages à chaque coin, vif ou arrondi.</translation>
    </message>
    <message>
        <source>Cut along the swaths where an obstacle or a bay begins or ends.</source>
        <translation>Coupé le long des passages là où un obstacle ou un renfoncement commence ou finit.</translation>
    </message>
    <message>
        <source>Cut where an obstacle or a bay begins or ends, and joined again where that saves turns and ways.</source>
        <translation>Coupé là où un obstacle ou un renfoncement commence ou finit, et réuni là où cela évite des demi-tours et des déplacements.</translation>
    </message>
    <message>
        <source>Cutting grass: headland first, swaths overlap a little.</source>
        <translation>Fauche de l&apos;herbe : fourrière d&apos;abord, léger recouvrement des passages.</translation>
    </message>
    <message>
        <source>DXF drawing</source>
        <translation>Dessin DXF</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Direction</translation>
    </message>
    <message>
        <source>Drawn out until the whole width is covered, as far as there is room.</source>
        <translation>Prolongé jusqu&apos;à couvrir toute la largeur, tant qu&apos;il y a de la place.</translation>
    </message>
    <message>
        <source>Drilling or planting: headland last, ways along the headland.</source>
        <translation>Semis ou plantation : fourrière en dernier, déplacements par la fourrière.</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>Rouler</translation>
    </message>
    <message>
        <source>Drive the curves more slowly.</source>
        <translation>Prenez les courbes plus lentement.</translation>
    </message>
    <message>
        <source>Drives the path from waypoint to waypoint, rounding corners its own way; relay 1 is on where the implement works. Not tested on the machine by us.</source>
        <translation>Va de point en point en arrondissant les angles à sa façon ; le relais 1 est activé là où l&apos;outil travaille. Non testé par nous sur la machine.</translation>
    </message>
    <message>
        <source>Drives the whole path, turns included, as a recorded path; stretches in reverse gear are left to the driver. Shows boundary, headland and guidance lines. Copy the field&apos;s folder to Documents/AgOpenGPS/Fields.</source>
        <translation>Suit tout le trajet, demi-tours compris, comme trajet enregistré ; les tronçons en marche arrière sont laissés au chauffeur. Montre limite, fourrière et lignes de guidage. Copiez le dossier de la parcelle dans Documents/AgOpenGPS/Fields.</translation>
    </message>
    <message>
        <source>Each its own</source>
        <translation>Chacune la sienne</translation>
    </message>
    <message>
        <source>Edge</source>
        <translation>Côté</translation>
    </message>
    <message>
        <source>Edge directions and every tenth of a degree, refined; says when nothing better exists.</source>
        <translation>Directions des côtés et chaque dixième de degré, affiné ; dit s&apos;il n&apos;y a pas mieux.</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Arrivée</translation>
    </message>
    <message>
        <source>Ends</source>
        <translation>Bouts</translation>
    </message>
    <message>
        <source>Every how many swaths a wider machine will drive again; 0 for none.</source>
        <translation>Tous les combien de passages une machine plus large repassera ; 0 pour aucun.</translation>
    </message>
    <message>
        <source>Every sample of the path; without a plan boundaries as WKT, or as points.</source>
        <translation>Chaque point du trajet ; sans plan, les limites en WKT ou en points.</translation>
    </message>
    <message>
        <source>Every second swath on the way out, the others on the way back.</source>
        <translation>Un passage sur deux à l&apos;aller, les autres au retour.</translation>
    </message>
    <message>
        <source>Every swath after its neighbour, back and forth.</source>
        <translation>Chaque passage après son voisin, en aller-retour.</translation>
    </message>
    <message>
        <source>Fendt One, Vario terminal</source>
        <translation>Fendt One, Varioterminal</translation>
    </message>
    <message>
        <source>Fertiliser or manure: headland first, ways along the headland.</source>
        <translation>Engrais ou fumier : fourrière d&apos;abord, déplacements par la fourrière.</translation>
    </message>
    <message>
        <source>Fertiliser spreader, 36 m</source>
        <translation>Épandeur d&apos;engrais, 36 m</translation>
    </message>
    <message>
        <source>Fewest swaths</source>
        <translation>Moins de passages</translation>
    </message>
    <message>
        <source>Field robot, 1.5 m weeder</source>
        <translation>Robot agricole, bineuse 1,5 m</translation>
    </message>
    <message>
        <source>Finish corners</source>
        <translation>Finir les coins</translation>
    </message>
    <message>
        <source>First tramline</source>
        <translation>Premier passage de pulvérisateur</translation>
    </message>
    <message>
        <source>Fishtail</source>
        <translation>Demi-tour en queue de poisson</translation>
    </message>
    <message>
        <source>Five-furrow mounted plough, 2.5 m</source>
        <translation>Charrue portée cinq corps, 2,5 m</translation>
    </message>
    <message>
        <source>Forward arc, straight back, forward arc; little room for near swaths.</source>
        <translation>Arc en avant, recul droit, arc en avant ; peu de place pour des passages proches.</translation>
    </message>
    <message>
        <source>Forward curves</source>
        <translation>Courbes en marche avant</translation>
    </message>
    <message>
        <source>Forward curves, smooth steering</source>
        <translation>Courbes avant, braquage progressif</translation>
    </message>
    <message>
        <source>Forward, back with the wheels the other way, forward again.</source>
        <translation>En avant, en arrière roues braquées à l&apos;inverse, en avant.</translation>
    </message>
    <message>
        <source>Forwards and backwards, the wheels turned no faster than the machine can (clothoids).</source>
        <translation>En avant et en arrière, les roues braquées pas plus vite que la machine ne le peut (clothoïdes).</translation>
    </message>
    <message>
        <source>From clear of the ground to working depth.</source>
        <translation>D&apos;au-dessus du sol à la profondeur de travail.</translation>
    </message>
    <message>
        <source>From inside out</source>
        <translation>De l&apos;intérieur vers l&apos;extérieur</translation>
    </message>
    <message>
        <source>From outside in</source>
        <translation>De l&apos;extérieur vers l&apos;intérieur</translation>
    </message>
    <message>
        <source>From the boundary inwards; holds as many passes as fit.</source>
        <translation>De la limite au plein champ ; contient autant de tours qu&apos;il en tient.</translation>
    </message>
    <message>
        <source>From the fixed axle to the hitch, negative behind the axle.</source>
        <translation>De l&apos;essieu fixe à l&apos;attelage, négatif derrière l&apos;essieu.</translation>
    </message>
    <message>
        <source>From the fixed axle to the middle of the working parts, negative behind the axle.</source>
        <translation>De l&apos;essieu fixe au milieu des pièces travaillantes, négatif derrière l&apos;essieu.</translation>
    </message>
    <message>
        <source>From the fixed axle to the tractor&apos;s rear end.</source>
        <translation>De l&apos;essieu fixe à l&apos;arrière du tracteur.</translation>
    </message>
    <message>
        <source>From the tractor&apos;s nose to its rear end.</source>
        <translation>Du nez du tracteur à son arrière.</translation>
    </message>
    <message>
        <source>From working depth to clear of the ground.</source>
        <translation>De la profondeur de travail jusqu&apos;au-dessus du sol.</translation>
    </message>
    <message>
        <source>Front and rear mower, 9 m</source>
        <translation>Faucheuse avant et arrière, 9 m</translation>
    </message>
    <message>
        <source>Fuel at work</source>
        <translation>Carburant au travail</translation>
    </message>
    <message>
        <source>Fuel in turns</source>
        <translation>Carburant en demi-tour</translation>
    </message>
    <message>
        <source>Full spacing; the last swath is moved back to the edge.</source>
        <translation>Espacement complet ; le dernier passage est ramené au bord.</translation>
    </message>
    <message>
        <source>Full spacing; a rest of less than half a width stays uncovered, where it costs least.</source>
        <translation>Espacement complet ; un reste de moins d&apos;une demi-largeur n&apos;est pas travaillé, là où cela coûte le moins.</translation>
    </message>
    <message>
        <source>Full width</source>
        <translation>Pleine largeur</translation>
    </message>
    <message>
        <source>Gets the whole path as nav_msgs/Path, and stretches in one gear each where it reverses.</source>
        <translation>Reçoit tout le trajet en nav_msgs/Path, et des tronçons d&apos;un seul sens là où il recule.</translation>
    </message>
    <message>
        <source>Given direction</source>
        <translation>Orientation donnée</translation>
    </message>
    <message>
        <source>Go round obstacles up to</source>
        <translation>Contourner les obstacles jusqu&apos;à</translation>
    </message>
    <message>
        <source>Great Field</source>
        <translation>Grand Champ</translation>
    </message>
    <message>
        <source>Half way in</source>
        <translation>À mi-largeur</translation>
    </message>
    <message>
        <source>Make them straight: &quot;Field&quot; menu, or furrow-cli convert --straighten-steps.</source>
        <translation>Redressez-les : menu « Parcelle », ou furrow-cli convert --straighten-steps.</translation>
    </message>
    <message>
        <source>Quick search</source>
        <translation>Recherche rapide</translation>
    </message>
    <message>
        <source>Harvest</source>
        <translation>Récolte</translation>
    </message>
    <message>
        <source>Heading</source>
        <translation>Orientation des passages</translation>
    </message>
    <message>
        <source>Headland</source>
        <translation>Fourrière</translation>
    </message>
    <message>
        <source>Headland first or last.</source>
        <translation>Fourrière en premier ou en dernier.</translation>
    </message>
    <message>
        <source>Heights</source>
        <translation>Altitudes</translation>
    </message>
    <message>
        <source>Hitch offset</source>
        <translation>Position de l&apos;attelage</translation>
    </message>
    <message>
        <source>Home Field</source>
        <translation>Champ de la Ferme</translation>
    </message>
    <message>
        <source>How far a trailed implement may swing to one side.</source>
        <translation>De combien un outil traîné peut pivoter d&apos;un côté.</translation>
    </message>
    <message>
        <source>How far the steered wheels turn to one side.</source>
        <translation>De combien les roues directrices tournent d&apos;un côté.</translation>
    </message>
    <message>
        <source>How fast the curvature may change along the path; from the steering rate where it is not given.</source>
        <translation>À quelle vitesse la courbure peut changer le long du trajet ; d&apos;après la vitesse de braquage si elle n&apos;est pas donnée.</translation>
    </message>
    <message>
        <source>How fast the steered wheels turn.</source>
        <translation>À quelle vitesse tournent les roues directrices.</translation>
    </message>
    <message>
        <source>How headland passes get round corners.</source>
        <translation>Comment les tours de fourrière passent les coins.</translation>
    </message>
    <message>
        <source>How much neighbouring swaths overlap.</source>
        <translation>De combien les passages voisins se recouvrent.</translation>
    </message>
    <message>
        <source>How the direction of the swaths is found.</source>
        <translation>Comment l&apos;orientation des passages est trouvée.</translation>
    </message>
    <message>
        <source>How the machine gets from one swath to the next.</source>
        <translation>Comment la machine va d&apos;un passage au suivant.</translation>
    </message>
    <message>
        <source>How the field is divided; the swaths of a block are driven together.</source>
        <translation>Comment le plein champ est divisé ; les passages d&apos;une sous-parcelle sont faits ensemble.</translation>
    </message>
    <message>
        <source>Implement can reverse</source>
        <translation>L&apos;outil peut reculer</translation>
    </message>
    <message>
        <source>Implement length</source>
        <translation>Longueur de l&apos;outil</translation>
    </message>
    <message>
        <source>Implement offset</source>
        <translation>Position de l&apos;outil</translation>
    </message>
    <message>
        <source>In WGS84: A and B of a line, a curve, A alone with a direction, or a pivot&apos;s centre.</source>
        <translation>En WGS84 : A et B d&apos;une ligne, une courbe, A seul avec une direction, ou le centre d&apos;un pivot.</translation>
    </message>
    <message>
        <source>In which order the headland passes are driven.</source>
        <translation>Dans quel ordre sont faits les tours de fourrière.</translation>
    </message>
    <message>
        <source>In which order the swaths are driven.</source>
        <translation>Dans quel ordre sont faits les passages.</translation>
    </message>
    <message>
        <source>Largest acceleration</source>
        <translation>Accélération maxi</translation>
    </message>
    <message>
        <source>Largest curvature rate</source>
        <translation>Variation de courbure maxi</translation>
    </message>
    <message>
        <source>Largest hitch angle</source>
        <translation>Angle d&apos;attelage maxi</translation>
    </message>
    <message>
        <source>Largest lateral acceleration</source>
        <translation>Accélération latérale maxi</translation>
    </message>
    <message>
        <source>Largest speed in turns.</source>
        <translation>Vitesse maximale dans les demi-tours.</translation>
    </message>
    <message>
        <source>Largest steering angle</source>
        <translation>Angle de braquage maxi</translation>
    </message>
    <message>
        <source>Last pass</source>
        <translation>Dernier passage</translation>
    </message>
    <message>
        <source>Lateral offset</source>
        <translation>Déport latéral</translation>
    </message>
    <message>
        <source>Least overlap</source>
        <translation>Moins de recouvrement</translation>
    </message>
    <message>
        <source>Least time</source>
        <translation>Moins de temps</translation>
    </message>
    <message>
        <source>Leaves some swaths out at each turn and comes back for them.</source>
        <translation>Saute des passages à chaque demi-tour et y revient.</translation>
    </message>
    <message>
        <source>Left out</source>
        <translation>Sautés</translation>
    </message>
    <message>
        <source>Limits the speed in tight bends.</source>
        <translation>Limite la vitesse dans les courbes serrées.</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Ligne</translation>
    </message>
    <message>
        <source>Lines along which the field inside the headland is cut; they run right through it, or end no farther than an operating width from its edge.</source>
        <translation>Lignes le long desquelles le plein champ est découpé ; elles le traversent ou s&apos;arrêtent à une largeur de travail au plus de son bord.</translation>
    </message>
    <message>
        <source>Litres of fuel per hour of turns and transfers.</source>
        <translation>Litres de carburant par heure de demi-tours et de déplacements.</translation>
    </message>
    <message>
        <source>Litres of fuel per hour of work.</source>
        <translation>Litres de carburant par heure de travail.</translation>
    </message>
    <message>
        <source>Long Strip</source>
        <translation>Longue Bande</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>Boucle</translation>
    </message>
    <message>
        <source>Lower the speeds, or correct the machine&apos;s.</source>
        <translation>Baissez les vitesses, ou corrigez celles de la machine.</translation>
    </message>
    <message>
        <source>MAVLink waypoints</source>
        <translation>Points de passage MAVLink</translation>
    </message>
    <message>
        <source>Make the gate wider, or take another.</source>
        <translation>Élargissez l&apos;entrée de parcelle ou prenez-en une autre.</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Marge</translation>
    </message>
    <message>
        <source>Overhang</source>
        <translation>Débord</translation>
    </message>
    <message>
        <source>Most covered</source>
        <translation>Plus de surface</translation>
    </message>
    <message>
        <source>Most terminals read FAT32 only; this stick has %1. Format it as FAT32.</source>
        <translation>La plupart des consoles ne lisent que FAT32 ; cette clé est en %1. Formatez-la en FAT32.</translation>
    </message>
    <message>
        <source>Mounted cultivator, 6 m</source>
        <translation>Cultivateur porté, 6 m</translation>
    </message>
    <message>
        <source>Mounted drill, 12 m</source>
        <translation>Semoir porté, 12 m</translation>
    </message>
    <message>
        <source>Mounting</source>
        <translation>Attelage</translation>
    </message>
    <message>
        <source>Mowing</source>
        <translation>Fauche</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>No headland</source>
        <translation>Sans fourrière</translation>
    </message>
    <message>
        <source>Nothing leads to the start of %1, %2 away.</source>
        <translation>Rien ne mène au début, à %2 de là : %1.</translation>
    </message>
    <message>
        <source>Number of the boundary&apos;s edge, from 0 in the order of its points; for curves with all around it up to a corner of 35 degrees within a width, or a bend of 90 in all.</source>
        <translation>Numéro du côté de la limite, à partir de 0 dans l&apos;ordre des points ; pour les courbes avec tous ceux autour jusqu&apos;à un angle de 35 degrés sur une largeur, ou un virage de 90 en tout.</translation>
    </message>
    <message>
        <source>Of the four corners and both ways the one with the quickest turns.</source>
        <translation>Des quatre coins et des deux sens, celui aux demi-tours les plus rapides.</translation>
    </message>
    <message>
        <source>Of the middle of the operating width, positive to the left.</source>
        <translation>Du milieu de la largeur de travail, positif vers la gauche.</translation>
    </message>
    <message>
        <source>Of the swaths.</source>
        <translation>Des passages.</translation>
    </message>
    <message>
        <source>Off: the strip is kept for turning only.</source>
        <translation>Non : la bande ne sert qu&apos;à tourner.</translation>
    </message>
    <message>
        <source>Omega turn</source>
        <translation>Demi-tour en oméga</translation>
    </message>
    <message>
        <source>On the rows</source>
        <translation>Sur les rangs</translation>
    </message>
    <message>
        <source>On the rows, or between them.</source>
        <translation>Sur les rangs, ou entre eux.</translation>
    </message>
    <message>
        <source>On the spot</source>
        <translation>Sur place</translation>
    </message>
    <message>
        <source>One for all</source>
        <translation>Une pour toutes</translation>
    </message>
    <message>
        <source>One piece</source>
        <translation>D&apos;un seul tenant</translation>
    </message>
    <message>
        <source>Only where it turns</source>
        <translation>Seulement là où l&apos;on tourne</translation>
    </message>
    <message>
        <source>Operating width</source>
        <translation>Largeur de travail</translation>
    </message>
    <message>
        <source>Operation</source>
        <translation>Opération</translation>
    </message>
    <message>
        <source>Orchard tractor with 1.5 m sprayer</source>
        <translation>Tracteur fruitier avec pulvérisateur 1,5 m</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Ordre</translation>
    </message>
    <message>
        <source>Overlap</source>
        <translation>Recouvrement</translation>
    </message>
    <message>
        <source>Overlaps its neighbour</source>
        <translation>Recouvre le voisin</translation>
    </message>
    <message>
        <source>P turn</source>
        <translation>Demi-tour en P</translation>
    </message>
    <message>
        <source>Passes</source>
        <translation>Tours</translation>
    </message>
    <message>
        <source>Plan again with this machine&apos;s turning radius.</source>
        <translation>Planifiez à nouveau avec le rayon de braquage de cette machine.</translation>
    </message>
    <message>
        <source>Plan again, or trust the positions.</source>
        <translation>Planifiez à nouveau, ou fiez-vous aux positions.</translation>
    </message>
    <message>
        <source>Plan again; the heading or the gear is wrong here.</source>
        <translation>Planifiez à nouveau ; le cap ou le sens de marche est faux ici.</translation>
    </message>
    <message>
        <source>Plan again; the path lacks this pass.</source>
        <translation>Planifiez à nouveau ; ce passage manque au trajet.</translation>
    </message>
    <message>
        <source>Plan again; the path was changed or cut here.</source>
        <translation>Planifiez à nouveau ; le trajet a été modifié ou coupé ici.</translation>
    </message>
    <message>
        <source>Plan again; the times were changed.</source>
        <translation>Planifiez à nouveau ; les temps ont été modifiés.</translation>
    </message>
    <message>
        <source>Plan the parts of the field apart, or widen the passage between them.</source>
        <translation>Planifiez les parties de la parcelle séparément, ou élargissez le passage entre elles.</translation>
    </message>
    <message>
        <source>Plan the turn that is missing here.</source>
        <translation>Planifiez le demi-tour qui manque ici.</translation>
    </message>
    <message>
        <source>Power harrow and drill, 3 m</source>
        <translation>Herse rotative et semoir, 3 m</translation>
    </message>
    <message>
        <source>Prefer</source>
        <translation>Préférer</translation>
    </message>
    <message>
        <source>Protobuf message</source>
        <translation>Message Protobuf</translation>
    </message>
    <message>
        <source>QGroundControl plan</source>
        <translation>Plan QGroundControl</translation>
    </message>
    <message>
        <source>Racetrack</source>
        <translation>Circuit</translation>
    </message>
    <message>
        <source>Raised width</source>
        <translation>Largeur outil relevé</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Dose</translation>
    </message>
    <message>
        <source>Rear overhang</source>
        <translation>Porte-à-faux arrière</translation>
    </message>
    <message>
        <source>Recorded path</source>
        <translation>Trajet enregistré</translation>
    </message>
    <message>
        <source>Relay 1 is on where the implement works.</source>
        <translation>Le relais 1 est activé là où l&apos;outil travaille.</translation>
    </message>
    <message>
        <source>Repaired in %1: %2.</source>
        <translation>Réparé (%1) : %2.</translation>
    </message>
    <message>
        <source>Reverse</source>
        <translation>Marche arrière</translation>
    </message>
    <message>
        <source>Reverse speed</source>
        <translation>Vitesse en marche arrière</translation>
    </message>
    <message>
        <source>Round and round the centre of a pivot, from the rim inwards.</source>
        <translation>En rond autour du centre d&apos;un pivot, du bord vers l&apos;intérieur.</translation>
    </message>
    <message>
        <source>Round and round, with half of the swaths between the way out and the way back.</source>
        <translation>En rond, avec la moitié des passages entre l&apos;aller et le retour.</translation>
    </message>
    <message>
        <source>Round the field</source>
        <translation>Autour de la parcelle</translation>
    </message>
    <message>
        <source>Rounded</source>
        <translation>Arrondi</translation>
    </message>
    <message>
        <source>Route</source>
        <translation>Ordre des passages</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>Rangs</translation>
    </message>
    <message>
        <source>Rows that are left out, numbered from 1 as in the file; between rows, that on the right.</source>
        <translation>Rangs laissés de côté, numérotés à partir de 1 comme dans le fichier ; entre les rangs, celui de droite.</translation>
    </message>
    <message>
        <source>Run-in</source>
        <translation>Distance d&apos;approche</translation>
    </message>
    <message>
        <source>Same width all round</source>
        <translation>Même largeur tout autour</translation>
    </message>
    <message>
        <source>Seen from above, turning left at corners.</source>
        <translation>Vu d&apos;en haut, en tournant à gauche aux coins.</translation>
    </message>
    <message>
        <source>Seen from above, turning right at corners.</source>
        <translation>Vu d&apos;en haut, en tournant à droite aux coins.</translation>
    </message>
    <message>
        <source>Short name for the command line.</source>
        <translation>Nom court pour la ligne de commande.</translation>
    </message>
    <message>
        <source>Short passes where corners would leave more than 1 % of the field.</source>
        <translation>De courts passages là où les coins laisseraient plus de 1 % de la parcelle.</translation>
    </message>
    <message>
        <source>Shortest swaths</source>
        <translation>Passages les plus courts</translation>
    </message>
    <message>
        <source>Shows the boundary and the guidance lines; it plans turns and order itself. Not tested on the machine by us.</source>
        <translation>Montre la limite et les lignes de guidage ; elle planifie demi-tours et ordre elle-même. Non testé par nous sur la machine.</translation>
    </message>
    <message>
        <source>Shows the boundary with holes and obstacles and the guidance lines; it plans turns and order itself. The import may have to be unlocked. Not tested on the machine by us.</source>
        <translation>Montre la limite avec enclaves et obstacles et les lignes de guidage ; elle planifie demi-tours et ordre elle-même. L&apos;import doit parfois être débloqué. Non testé par nous sur la machine.</translation>
    </message>
    <message>
        <source>Shows the boundary with holes and obstacles, the headland where the terminal knows it, and the guidance lines; it plans turns and order itself. The import may have to be unlocked. Not tested on the machine by us.</source>
        <translation>Montre la limite avec enclaves et obstacles, la fourrière si la console la connaît, et les lignes de guidage ; elle planifie demi-tours et ordre elle-même. L&apos;import doit parfois être débloqué. Non testé par nous sur la machine.</translation>
    </message>
    <message>
        <source>Shows the boundary, its holes, the headland and the guidance lines, not the path. Holes are written as obstacles, since it overlooks others.</source>
        <translation>Montre la limite, ses enclaves, la fourrière et les lignes de guidage, pas le trajet. Les enclaves sont écrites comme obstacles, car il ignore les autres.</translation>
    </message>
    <message>
        <source>Shows the path as a mission, and the boundary and obstacles as fences. Not tested on the machine by us.</source>
        <translation>Montre le trajet en mission, et la limite et les obstacles en barrières. Non testé par nous sur la machine.</translation>
    </message>
    <message>
        <source>Six directions, then ever finer around the best three (Oksanen &amp; Visala).</source>
        <translation>Six directions, puis de plus en plus fin autour des trois meilleures (Oksanen &amp; Visala).</translation>
    </message>
    <message>
        <source>Six-row planter, 4.5 m</source>
        <translation>Semoir monograine six rangs, 4,5 m</translation>
    </message>
    <message>
        <source>Skip</source>
        <translation>Sauter</translation>
    </message>
    <message>
        <source>Skip and fill</source>
        <translation>Sauter et combler</translation>
    </message>
    <message>
        <source>Slanted Field</source>
        <translation>Champ Oblique</translation>
    </message>
    <message>
        <source>Slurry tanker, 15 m trailing shoe</source>
        <translation>Tonne à lisier, patins 15 m</translation>
    </message>
    <message>
        <source>Smallest circle the middle of the fixed axle can follow; from the steering angle where it is not given.</source>
        <translation>Plus petit cercle que suit le milieu de l&apos;essieu fixe ; d&apos;après l&apos;angle de braquage s&apos;il n&apos;est pas donné.</translation>
    </message>
    <message>
        <source>Smallest turning radius</source>
        <translation>Rayon de braquage mini</translation>
    </message>
    <message>
        <source>Snake</source>
        <translation>Serpentin</translation>
    </message>
    <message>
        <source>So that the wide machine begins flush with the left edge, or beside the line that was given.</source>
        <translation>Pour que la machine large commence au ras du bord gauche, ou à côté de la ligne donnée.</translation>
    </message>
    <message>
        <source>Sowing</source>
        <translation>Semis</translation>
    </message>
    <message>
        <source>Speed backwards.</source>
        <translation>Vitesse en reculant.</translation>
    </message>
    <message>
        <source>Speed on longer ways with the implement lifted.</source>
        <translation>Vitesse sur les longs déplacements, outil relevé.</translation>
    </message>
    <message>
        <source>Speed with the implement at work.</source>
        <translation>Vitesse avec l&apos;outil au travail.</translation>
    </message>
    <message>
        <source>Spiral in clusters</source>
        <translation>Spirale par groupes</translation>
    </message>
    <message>
        <source>Split lines</source>
        <translation>Lignes de partage</translation>
    </message>
    <message>
        <source>Spraying</source>
        <translation>Pulvérisation</translation>
    </message>
    <message>
        <source>Spread over all</source>
        <translation>Réparti sur tous</translation>
    </message>
    <message>
        <source>Spreading</source>
        <translation>Épandage</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Départ</translation>
    </message>
    <message>
        <source>Start at</source>
        <translation>Commencer à</translation>
    </message>
    <message>
        <source>Stay inside</source>
        <translation>Rester dans la parcelle</translation>
    </message>
    <message>
        <source>Steering rate</source>
        <translation>Vitesse de braquage</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Pas angulaire</translation>
    </message>
    <message>
        <source>Straight into the corner and back into it on the next side.</source>
        <translation>Tout droit dans le coin, puis en marche arrière sur le côté suivant.</translation>
    </message>
    <message>
        <source>Straight into the corner and on after a loop, where there is room for it.</source>
        <translation>Tout droit dans le coin puis une boucle, là où il y a la place.</translation>
    </message>
    <message>
        <source>Straight way needed before the implement is lowered.</source>
        <translation>Ligne droite nécessaire avant de baisser l&apos;outil.</translation>
    </message>
    <message>
        <source>Swath after swath over all of the field, whatever cuts them.</source>
        <translation>Passage après passage sur tout le plein champ, sans tenir compte de ce qui les coupe.</translation>
    </message>
    <message>
        <source>Swath numbers in driving order; a minus drives one the other way.</source>
        <translation>Numéros de passages dans l&apos;ordre ; un signe moins inverse le sens.</translation>
    </message>
    <message>
        <source>Swaths</source>
        <translation>Passages</translation>
    </message>
    <message>
        <source>Swaths go on from block to block.</source>
        <translation>Les passages continuent d&apos;une sous-parcelle à l&apos;autre.</translation>
    </message>
    <message>
        <source>Swaths go round obstacles of up to this size; larger ones get a headland. Auto is the operating width.</source>
        <translation>Les passages contournent les obstacles jusqu&apos;à cette taille ; les plus grands reçoivent une fourrière. Auto est la largeur de travail.</translation>
    </message>
    <message>
        <source>Swaths left out at each turn and driven on the way back.</source>
        <translation>Passages sautés à chaque demi-tour et faits au retour.</translation>
    </message>
    <message>
        <source>Swaths that are finished together.</source>
        <translation>Passages terminés ensemble.</translation>
    </message>
    <message>
        <source>Takes the boundary only, as an upload from a computer; no guidance lines, no path.</source>
        <translation>Prend la limite seule, envoyée depuis un ordinateur ; ni lignes de guidage ni trajet.</translation>
    </message>
    <message>
        <source>Tank or bunker</source>
        <translation>Cuve ou trémie</translation>
    </message>
    <message>
        <source>The Bend</source>
        <translation>Le Coude</translation>
    </message>
    <message>
        <source>The best corner</source>
        <translation>Le meilleur coin</translation>
    </message>
    <message>
        <source>The boundary alone as a flat zipped shapefile, as operations centres take it.</source>
        <translation>La limite seule en shapefile zippé à plat, comme les centres d&apos;opérations l&apos;acceptent.</translation>
    </message>
    <message>
        <source>The chosen one cannot be driven between these swaths.</source>
        <translation>Celui qui est choisi est impossible entre ces passages.</translation>
    </message>
    <message>
        <source>The corner where the route starts.</source>
        <translation>Le coin où commence l&apos;ordre des passages.</translation>
    </message>
    <message>
        <source>The field is narrower here than the %1 in which this machine turns without reversing: leave this strip out, or work it with a machine that turns more tightly.</source>
        <translation>La parcelle est ici plus étroite que les %1 qu&apos;il faut à cette machine pour faire demi-tour sans reculer : laissez cette bande de côté, ou travaillez-la avec une machine qui braque mieux.</translation>
    </message>
    <message>
        <source>The field is narrower here than this machine, which takes %1: leave this strip out, or work it with a narrower machine.</source>
        <translation>La parcelle est ici plus étroite que cette machine, à qui il faut %1 : laissez cette bande de côté, ou travaillez-la avec une machine plus étroite.</translation>
    </message>
    <message>
        <source>The field is too narrow for %1 of headland; it is %2 with %3</source>
        <translation>La parcelle est trop étroite pour %1 de fourrière ; il en reste %2, avec %3</translation>
    </message>
    <message>
        <source>The field is too narrow for %1 of headland; there is none</source>
        <translation>La parcelle est trop étroite pour %1 de fourrière ; il n&apos;y en a donc pas</translation>
    </message>
    <message>
        <source>The first swath</source>
        <translation>Le premier passage</translation>
    </message>
    <message>
        <source>The first swath on the left is one, or the line that was given.</source>
        <translation>Le premier passage à gauche en est un, ou la ligne donnée.</translation>
    </message>
    <message>
        <source>The first swath on the right is one, or the line that was given.</source>
        <translation>Le premier passage à droite en est un, ou la ligne donnée.</translation>
    </message>
    <message>
        <source>The headland is worked first.</source>
        <translation>La fourrière est travaillée d&apos;abord.</translation>
    </message>
    <message>
        <source>The headland is worked last.</source>
        <translation>La fourrière est travaillée en dernier.</translation>
    </message>
    <message>
        <source>The headland strip, %1, is not worked by this plan, nor are %2 at the ends of the swaths beside it.</source>
        <translation>La bande de fourrière, %1, n&apos;est pas travaillée par ce plan, ni %2 au bout des passages voisins.</translation>
    </message>
    <message>
        <source>The headland strip, %1, is not worked by this plan.</source>
        <translation>La bande de fourrière, %1, n&apos;est pas travaillée par ce plan.</translation>
    </message>
    <message>
        <source>The hitch bends by %1 in %2; %3 are allowed.</source>
        <translation>L&apos;attelage plie de %1 dans %2 ; %3 sont permis.</translation>
    </message>
    <message>
        <source>The largest covered share inside the headland.</source>
        <translation>La plus grande part travaillée du plein champ.</translation>
    </message>
    <message>
        <source>The least metres driven in swaths, with what is missed added as metres.</source>
        <translation>Le moins de mètres parcourus en passages ; les zones non travaillées comptent comme des mètres.</translation>
    </message>
    <message>
        <source>The machine does not get in at %1.</source>
        <translation>La machine ne peut pas entrer ici : %1.</translation>
    </message>
    <message>
        <source>The machine does not get out at %1.</source>
        <translation>La machine ne peut pas sortir ici : %1.</translation>
    </message>
    <message>
        <source>The machine drives half way between two neighbours.</source>
        <translation>La machine roule à mi-distance de deux voisins.</translation>
    </message>
    <message>
        <source>The machine drives over them.</source>
        <translation>La machine roule dessus.</translation>
    </message>
    <message>
        <source>The machine turns on the spot in %1, by up to %2.</source>
        <translation>La machine tourne sur place à %1, jusqu&apos;à %2.</translation>
    </message>
    <message>
        <source>The machine turns on the spot in %1, by up to %2; it cannot.</source>
        <translation>La machine tourne sur place à %1, jusqu&apos;à %2 ; elle ne le peut pas.</translation>
    </message>
    <message>
        <source>The mission has %1 items; controllers without a memory card hold about %2.</source>
        <translation>La mission a %1 éléments ; les contrôleurs sans carte mémoire en tiennent environ %2.</translation>
    </message>
    <message>
        <source>The outermost pass goes round with the machine&apos;s radius where little is left; others reach into corners.</source>
        <translation>Le tour extérieur passe au rayon de la machine là où il reste peu ; les autres vont dans les coins.</translation>
    </message>
    <message>
        <source>The outline has %1 steps of about %2, like the pixels of an image.</source>
        <translation>Le contour a %1 marches d’environ %2, comme les pixels d’une image.</translation>
    </message>
    <message>
        <source>The pass along the boundary first.</source>
        <translation>Le tour le long de la limite d&apos;abord.</translation>
    </message>
    <message>
        <source>The innermost pass first.</source>
        <translation>Le tour le long du plein champ d&apos;abord.</translation>
    </message>
    <message>
        <source>The path as a mission for ArduPilot Rover: waypoints, speeds, gear, implement.</source>
        <translation>Le trajet en mission pour ArduPilot Rover : points, vitesses, sens de marche, outil.</translation>
    </message>
    <message>
        <source>The path as a track, swath ends as a route, gates as waypoints; for phones.</source>
        <translation>Le trajet en trace, les bouts de passages en route, les entrées en points ; pour téléphones.</translation>
    </message>
    <message>
        <source>The path as nav_msgs/Path in a recording of ROS 2.</source>
        <translation>Le trajet en nav_msgs/Path dans un enregistrement ROS 2.</translation>
    </message>
    <message>
        <source>The path as one message for ros2 topic pub.</source>
        <translation>Le trajet en un message pour ros2 topic pub.</translation>
    </message>
    <message>
        <source>The path with times, velocities and orientations, and the boundary as a fence; for own robots.</source>
        <translation>Le trajet avec temps, vitesses et orientations, et la limite comme barrière ; pour robots maison.</translation>
    </message>
    <message>
        <source>The quickest turn of any kind that stays inside the field, in several moves where it must.</source>
        <translation>Le demi-tour le plus rapide, quel qu&apos;il soit, qui reste dans la parcelle, en plusieurs temps s&apos;il le faut.</translation>
    </message>
    <message>
        <source>The same as KML, zipped.</source>
        <translation>La même chose que KML, zippée.</translation>
    </message>
    <message>
        <source>The same mission with the boundary and obstacles as fences.</source>
        <translation>La même mission avec la limite et les obstacles comme barrières.</translation>
    </message>
    <message>
        <source>The shortest curve forwards and backwards, at the smallest turning radius (Reeds and Shepp).</source>
        <translation>La courbe la plus courte en avant et en arrière, au plus petit rayon de braquage (Reeds et Shepp).</translation>
    </message>
    <message>
        <source>The shortest curve without reversing, at the smallest turning radius (Dubins).</source>
        <translation>La courbe la plus courte sans reculer, au plus petit rayon de braquage (Dubins).</translation>
    </message>
    <message>
        <source>The shortest time in swaths and turns.</source>
        <translation>Le temps le plus court en passages et demi-tours.</translation>
    </message>
    <message>
        <source>The smallest area worked twice.</source>
        <translation>La plus petite surface travaillée deux fois.</translation>
    </message>
    <message>
        <source>The spacing is reduced evenly so that all fit.</source>
        <translation>L&apos;espacement est réduit également pour que tous tiennent.</translation>
    </message>
    <message>
        <source>The stated curvature differs from the path in %1, by up to %2 1/m.</source>
        <translation>La courbure indiquée diffère du trajet à %1, jusqu&apos;à %2 1/m.</translation>
    </message>
    <message>
        <source>The stated speed is up to %1 above the machine&apos;s.</source>
        <translation>La vitesse indiquée dépasse celle de la machine de %1 au plus.</translation>
    </message>
    <message>
        <source>The strip kept for turning.</source>
        <translation>La bande gardée pour tourner.</translation>
    </message>
    <message>
        <source>The swaths in the order and direction that you type.</source>
        <translation>Les passages dans l&apos;ordre et le sens saisis.</translation>
    </message>
    <message>
        <source>The table holds boundaries only: obstacles, gates and lines are left out.</source>
        <translation>Le tableau ne contient que des limites : obstacles, entrées et lignes sont laissés de côté.</translation>
    </message>
    <message>
        <source>The task data has %1 MB; old terminals take at most 2 MB.</source>
        <translation>Les données de tâche font %1 Mo ; les vieilles consoles en acceptent 2 au plus.</translation>
    </message>
    <message>
        <source>The tractor may drive backwards with it.</source>
        <translation>Le tracteur peut reculer avec.</translation>
    </message>
    <message>
        <source>The tractor may drive backwards.</source>
        <translation>Le tracteur peut rouler en marche arrière.</translation>
    </message>
    <message>
        <source>The tractor may turn about its own middle.</source>
        <translation>Le tracteur peut tourner autour de son milieu.</translation>
    </message>
    <message>
        <source>The way from %1 to %2</source>
        <translation>Le déplacement %1 → %2</translation>
    </message>
    <message>
        <source>There the chosen one does not fit into the field or cannot be driven between these swaths.</source>
        <translation>Celui qui est choisi n&apos;y tient pas dans la parcelle ou est impossible entre ces passages.</translation>
    </message>
    <message>
        <source>There the chosen one does not fit into the field.</source>
        <translation>Celui qui est choisi n&apos;y tient pas dans la parcelle.</translation>
    </message>
    <message>
        <source>This machine cannot reverse.</source>
        <translation>Cette machine ne peut pas reculer.</translation>
    </message>
    <message>
        <source>This stick has %1 partitions; terminals see the first one only, if any.</source>
        <translation>Cette clé a %1 partitions ; les consoles ne voient que la première, au mieux.</translation>
    </message>
    <message>
        <source>Three Ponds</source>
        <translation>Trois Mares</translation>
    </message>
    <message>
        <source>Three-point turn</source>
        <translation>Demi-tour en trois temps</translation>
    </message>
    <message>
        <source>Through point A in the direction that you type.</source>
        <translation>Par le point A dans la direction saisie.</translation>
    </message>
    <message>
        <source>Tillage</source>
        <translation>Travail du sol</translation>
    </message>
    <message>
        <source>Time and way do not fit the speed in %1.</source>
        <translation>Le temps et la distance ne correspondent pas à la vitesse à %1.</translation>
    </message>
    <message>
        <source>Time to lift</source>
        <translation>Temps de relevage</translation>
    </message>
    <message>
        <source>Time to lower</source>
        <translation>Temps de descente</translation>
    </message>
    <message>
        <source>To and fro</source>
        <translation>Aller-retour</translation>
    </message>
    <message>
        <source>Trailed sprayer, 24 m boom</source>
        <translation>Pulvérisateur traîné, rampe 24 m</translation>
    </message>
    <message>
        <source>Tramline every</source>
        <translation>Passages de pulvérisateur tous les</translation>
    </message>
    <message>
        <source>Transfer speed</source>
        <translation>Vitesse de déplacement</translation>
    </message>
    <message>
        <source>Transport width</source>
        <translation>Largeur de transport</translation>
    </message>
    <message>
        <source>Trapezoids</source>
        <translation>Trapèzes</translation>
    </message>
    <message>
        <source>Tries every heading in steps and keeps the best.</source>
        <translation>Essaie toutes les orientations par pas et garde la meilleure.</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Demi-tour</translation>
    </message>
    <message>
        <source>Turning speed</source>
        <translation>Vitesse en demi-tour</translation>
    </message>
    <message>
        <source>Turns</source>
        <translation>Demi-tours</translation>
    </message>
    <message>
        <source>Turns between swaths that are of another kind than chosen (path.method): %1 of %2. %3</source>
        <translation>Demi-tours entre passages d&apos;un autre type que celui choisi (path.method) : %1 sur %2. %3</translation>
    </message>
    <message>
        <source>Turns in place and drives straight to the next swath; only for machines that can.</source>
        <translation>Tourne sur place et va droit au passage suivant ; seulement pour les machines qui le peuvent.</translation>
    </message>
    <message>
        <source>Turns on the spot are chosen (path.method), and this machine cannot turn on the spot.</source>
        <translation>Des demi-tours sur place sont choisis (path.method), et cette machine ne peut pas tourner sur place.</translation>
    </message>
    <message>
        <source>U turn</source>
        <translation>Demi-tour en U</translation>
    </message>
    <message>
        <source>Vehicle length</source>
        <translation>Longueur du véhicule</translation>
    </message>
    <message>
        <source>Vehicle width</source>
        <translation>Largeur du véhicule</translation>
    </message>
    <message>
        <source>Ways</source>
        <translation>Déplacements</translation>
    </message>
    <message>
        <source>Ways keep to the field&apos;s edge.</source>
        <translation>Les déplacements restent au bord de la parcelle.</translation>
    </message>
    <message>
        <source>Ways keep to the headland; crop and seedbed are not driven over.</source>
        <translation>Les déplacements restent sur la fourrière ; on ne roule pas sur la culture ni le lit de semences.</translation>
    </message>
    <message>
        <source>Ways may cross worked land.</source>
        <translation>Les déplacements peuvent traverser le plein champ.</translation>
    </message>
    <message>
        <source>Well-known text</source>
        <translation>Well-known text</translation>
    </message>
    <message>
        <source>What becomes of the width that is left over at the far side.</source>
        <translation>Ce que devient la largeur qui reste de l&apos;autre côté.</translation>
    </message>
    <message>
        <source>Distance from the boundary that nothing enters; auto is the boundary&apos;s accuracy.</source>
        <translation>Distance à la limite que rien ne franchit ; auto : la précision de la limite.</translation>
    </message>
    <message>
        <source>How far the implement may stand over the boundary and obstacles, its sections there switched off; the tractor and all wheels stay inside.</source>
        <translation>Jusqu&apos;où l&apos;outil peut déborder de la limite de parcelle et au-dessus des obstacles, tronçons coupés à cet endroit ; le tracteur et toutes les roues restent à l&apos;intérieur.</translation>
    </message>
    <message>
        <source>What is spread or gathered on a square metre, in the same unit.</source>
        <translation>Ce qui est épandu ou récolté sur un mètre carré, dans la même unité.</translation>
    </message>
    <message>
        <source>What it holds, in your own unit: litres, kilograms, seeds.</source>
        <translation>Ce qu&apos;elle contient, dans votre unité : litres, kilos, graines.</translation>
    </message>
    <message>
        <source>What the field is driven over for: sets when the headland is worked, ways and overlap.</source>
        <translation>Le travail à faire : détermine quand la fourrière est travaillée, les déplacements et le recouvrement.</translation>
    </message>
    <message>
        <source>What the machine is called.</source>
        <translation>Comment s&apos;appelle la machine.</translation>
    </message>
    <message>
        <source>What the search for the best heading looks for.</source>
        <translation>Ce que vise la recherche de la meilleure orientation.</translation>
    </message>
    <message>
        <source>Wheelbase</source>
        <translation>Empattement</translation>
    </message>
    <message>
        <source>When</source>
        <translation>Quand</translation>
    </message>
    <message>
        <source>When speeding up and when braking.</source>
        <translation>En accélérant et en freinant.</translation>
    </message>
    <message>
        <source>Where a swath ends at a slanting edge.</source>
        <translation>Où finit un passage contre un bord oblique.</translation>
    </message>
    <message>
        <source>Where the machine may drive from swath to swath; follows from the operation.</source>
        <translation>Où la machine peut rouler d&apos;un passage à l&apos;autre ; découle de l&apos;opération.</translation>
    </message>
    <message>
        <source>Where the middle of the swath meets the headland.</source>
        <translation>Là où le milieu du passage rencontre la fourrière.</translation>
    </message>
    <message>
        <source>Where tramlines are counted from.</source>
        <translation>D&apos;où sont comptés les passages de pulvérisateur.</translation>
    </message>
    <message>
        <source>Whether blocks have a heading of their own.</source>
        <translation>Si les sous-parcelles ont leur propre orientation.</translation>
    </message>
    <message>
        <source>Which way round the headland passes are driven.</source>
        <translation>Dans quel sens sont faits les tours de fourrière.</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Largeur</translation>
    </message>
    <message>
        <source>Width in operating widths; auto leaves room for the turns.</source>
        <translation>Largeur en largeurs de travail ; auto laisse la place des demi-tours.</translation>
    </message>
    <message>
        <source>Width the tractor occupies, wheels included.</source>
        <translation>Largeur qu&apos;occupe le tracteur, roues comprises.</translation>
    </message>
    <message>
        <source>Width while folded for the road, through gates and on ways in and out; the raised width where it is not given.</source>
        <translation>Largeur une fois replié pour la route, aux entrées de parcelle et pour entrer et sortir ; sans indication, la largeur outil relevé.</translation>
    </message>
    <message>
        <source>Width while lifted or folded for a turn; the operating width where it is not given.</source>
        <translation>Largeur relevé ou replié pour un demi-tour ; la largeur de travail si elle n&apos;est pas donnée.</translation>
    </message>
    <message>
        <source>Width worked in one pass.</source>
        <translation>Largeur travaillée en un passage.</translation>
    </message>
    <message>
        <source>Without reversing, the wheels turned no faster than the machine can (clothoids).</source>
        <translation>Sans reculer, les roues braquées pas plus vite que la machine ne le peut (clothoïdes).</translation>
    </message>
    <message>
        <source>Work it along the boundary, before or after the swaths.</source>
        <translation>Travaillez-la le long de la limite, avant ou après les passages.</translation>
    </message>
    <message>
        <source>Work the headland</source>
        <translation>Travailler la fourrière</translation>
    </message>
    <message>
        <source>Working speed</source>
        <translation>Vitesse de travail</translation>
    </message>
    <message>
        <source>Working the soil: worked land may be driven over.</source>
        <translation>Travail du sol : on peut traverser le plein champ.</translation>
    </message>
    <message>
        <source>Your own order</source>
        <translation>Ordre personnel</translation>
    </message>
    <message>
        <source>Zipped boundary</source>
        <translation>Limite zippée</translation>
    </message>
    <message>
        <source>a chunk of the recording has a wrong checksum</source>
        <translation>un bloc de l&apos;enregistrement a une somme de contrôle fausse</translation>
    </message>
    <message>
        <source>a chunk of the recording is cut off</source>
        <translation>un bloc de l&apos;enregistrement est coupé</translation>
    </message>
    <message>
        <source>a chunk of the recording is damaged</source>
        <translation>un bloc de l&apos;enregistrement est endommagé</translation>
    </message>
    <message>
        <source>a compressed chunk of the recording is damaged</source>
        <translation>un bloc compressé de l&apos;enregistrement est endommagé</translation>
    </message>
    <message>
        <source>a coordinate is not a number</source>
        <translation>une coordonnée n&apos;est pas un nombre</translation>
    </message>
    <message>
        <source>a curve needs at least two points that differ</source>
        <translation>une courbe demande au moins deux points différents</translation>
    </message>
    <message>
        <source>a drawing does not say which coordinate system it uses</source>
        <translation>un dessin ne dit pas quel système de coordonnées il utilise</translation>
    </message>
    <message>
        <source>a hole lies outside the boundary</source>
        <translation>une enclave est hors de la limite</translation>
    </message>
    <message>
        <source>a hole of &apos;%1&apos; is missing or another</source>
        <translation>une enclave de « %1 » manque ou diffère</translation>
    </message>
    <message>
        <source>a machine is one JSON object</source>
        <translation>une machine est un objet JSON</translation>
    </message>
    <message>
        <source>a message is cut off</source>
        <translation>un message est coupé</translation>
    </message>
    <message>
        <source>a message is not plain CDR</source>
        <translation>un message n&apos;est pas en CDR simple</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>un nombre</translation>
    </message>
    <message>
        <source>a number is too large to be read</source>
        <translation>un nombre est trop grand pour être lu</translation>
    </message>
    <message>
        <source>a part of it states %1 bytes, more than 256 MiB</source>
        <translation>une partie en annonce %1 octets, plus de 256 Mio</translation>
    </message>
    <message>
        <source>a part of the boundary of &apos;%1&apos; is missing or another</source>
        <translation>une partie de la limite de « %1 » manque ou diffère</translation>
    </message>
    <message>
        <source>a point</source>
        <translation>un point</translation>
    </message>
    <message>
        <source>a point has no place in EPSG:%1</source>
        <translation>un point n&apos;a pas de place dans EPSG:%1</translation>
    </message>
    <message>
        <source>a point or a line in WGS84 such as LINESTRING (4.1 52.0, 4.2 52.0)</source>
        <translation>un point ou une ligne en WGS84 comme LINESTRING (4.1 52.0, 4.2 52.0)</translation>
    </message>
    <message>
        <source>a record of the recording is damaged</source>
        <translation>un élément de l&apos;enregistrement est endommagé</translation>
    </message>
    <message>
        <source>a sliver of %1 was left out</source>
        <translation>un petit reste de %1 a été laissé de côté</translation>
    </message>
    <message>
        <source>a track that ended %1 from where it began was closed</source>
        <translation>une trace qui finissait à %1 de son début a été fermée</translation>
    </message>
    <message>
        <source>a value of its own</source>
        <translation>une valeur propre</translation>
    </message>
    <message>
        <source>add the .prj file that belongs to it, or export the field again in WGS84</source>
        <translation>ajoutez le fichier .prj qui l&apos;accompagne, ou exportez à nouveau la parcelle en WGS84</translation>
    </message>
    <message>
        <source>allow it to be kept as a backup</source>
        <translation>permettez de le garder comme copie</translation>
    </message>
    <message>
        <source>an obstacle</source>
        <translation>un obstacle</translation>
    </message>
    <message>
        <source>an obstacle has no shape</source>
        <translation>un obstacle n&apos;a pas de forme</translation>
    </message>
    <message>
        <source>an overlap of %1 leaves nothing of %2</source>
        <translation>un recouvrement de %1 ne laisse rien de %2</translation>
    </message>
    <message>
        <source>boundary accuracy</source>
        <translation>précision de la limite</translation>
    </message>
    <message>
        <source>changes cannot be kept for the case of a crash: %1</source>
        <translation>les modifications ne peuvent pas être gardées en cas de plantage : %1</translation>
    </message>
    <message>
        <source>check its coordinates</source>
        <translation>vérifiez ses coordonnées</translation>
    </message>
    <message>
        <source>check that the folder can be written to</source>
        <translation>vérifiez que l&apos;on peut écrire dans le dossier</translation>
    </message>
    <message>
        <source>check that you may read it</source>
        <translation>vérifiez que vous avez le droit de le lire</translation>
    </message>
    <message>
        <source>check the boundary for crossings</source>
        <translation>vérifiez si la limite se croise</translation>
    </message>
    <message>
        <source>check the coordinate system, correct this point, or split the field</source>
        <translation>vérifiez le système de coordonnées, corrigez ce point ou divisez la parcelle</translation>
    </message>
    <message>
        <source>check the file&apos;s coordinate system</source>
        <translation>vérifiez le système de coordonnées du fichier</translation>
    </message>
    <message>
        <source>check the operating width and the overlap</source>
        <translation>vérifiez la largeur de travail et le recouvrement</translation>
    </message>
    <message>
        <source>check the path</source>
        <translation>vérifiez le chemin</translation>
    </message>
    <message>
        <source>check the width and how far the edge lies from the line</source>
        <translation>vérifiez la largeur et la distance entre le bord et la ligne</translation>
    </message>
    <message>
        <source>check the width of the implement, or take the track as driven around the field</source>
        <translation>vérifiez la largeur de l&apos;outil, ou prenez le trajet comme un tour de la parcelle</translation>
    </message>
    <message>
        <source>choose a narrower headland or a narrower machine</source>
        <translation>choisissez une fourrière ou une machine plus étroite</translation>
    </message>
    <message>
        <source>choose a smaller machine or check the boundary&apos;s coordinate system</source>
        <translation>choisissez une machine plus petite ou vérifiez le système de coordonnées de la limite</translation>
    </message>
    <message>
        <source>choose another format</source>
        <translation>choisissez un autre format</translation>
    </message>
    <message>
        <source>choose one by its id: %1</source>
        <translation>choisissez-en un par son identifiant : %1</translation>
    </message>
    <message>
        <source>choose one by its number in the file: %1</source>
        <translation>choisissez-en une par son numéro dans le fichier : %1</translation>
    </message>
    <message>
        <source>choose the format rosbag2-mcap</source>
        <translation>choisissez le format rosbag2-mcap</translation>
    </message>
    <message>
        <source>close it there first</source>
        <translation>fermez-le d&apos;abord là-bas</translation>
    </message>
    <message>
        <source>contour needs heights</source>
        <translation>les courbes de niveau demandent des altitudes</translation>
    </message>
    <message>
        <source>copy it again, or mend it with &apos;mcap recover&apos; or sqlite3&apos;s &apos;.recover&apos;</source>
        <translation>copiez-le à nouveau, ou réparez-le avec « mcap recover » ou « .recover » de sqlite3</translation>
    </message>
    <message>
        <source>copy or export it again</source>
        <translation>copiez-le ou exportez-le à nouveau</translation>
    </message>
    <message>
        <source>copy or export the recording again</source>
        <translation>copiez ou exportez à nouveau l&apos;enregistrement</translation>
    </message>
    <message>
        <source>copy the whole folder</source>
        <translation>copiez tout le dossier</translation>
    </message>
    <message>
        <source>correct it, or remove the hole or obstacle from the file</source>
        <translation>corrigez-le, ou retirez l&apos;enclave ou l&apos;obstacle du fichier</translation>
    </message>
    <message>
        <source>correct or delete this point in the file</source>
        <translation>corrigez ou supprimez ce point dans le fichier</translation>
    </message>
    <message>
        <source>correct or remove the line</source>
        <translation>corrigez ou supprimez la ligne</translation>
    </message>
    <message>
        <source>correct or remove the point</source>
        <translation>corrigez ou supprimez le point</translation>
    </message>
    <message>
        <source>correct the line, or export the track in WGS84</source>
        <translation>corrigez la ligne, ou exportez le trajet en WGS84</translation>
    </message>
    <message>
        <source>could not be read: %1</source>
        <translation>la lecture a échoué : %1</translation>
    </message>
    <message>
        <source>could not be written: %1</source>
        <translation>l&apos;écriture a échoué : %1</translation>
    </message>
    <message>
        <source>crosses an obstacle</source>
        <translation>traverse un obstacle</translation>
    </message>
    <message>
        <source>cut it into the days or fields that it holds</source>
        <translation>découpez-le par jours ou par parcelles</translation>
    </message>
    <message>
        <source>decimal commas in the place of the field were taken for points</source>
        <translation>des virgules décimales dans la position de la parcelle ont été lues comme des points</translation>
    </message>
    <message>
        <source>delete some of them</source>
        <translation>supprimez-en quelques-uns</translation>
    </message>
    <message>
        <source>delete the hole that covers it</source>
        <translation>supprimez l&apos;enclave qui la couvre</translation>
    </message>
    <message>
        <source>did you mean &apos;%1&apos;?</source>
        <translation>serait-ce « %1 » ?</translation>
    </message>
    <message>
        <source>did you mean &apos;%1&apos;? use one of: %2; or give a machine file (.json)</source>
        <translation>serait-ce « %1 » ? utilisez l&apos;une de : %2 ; ou indiquez un fichier de machine (.json)</translation>
    </message>
    <message>
        <source>download the file and give its path</source>
        <translation>téléchargez le fichier et indiquez son chemin</translation>
    </message>
    <message>
        <source>draw it again</source>
        <translation>redessinez</translation>
    </message>
    <message>
        <source>draw it again with at least 3 corners</source>
        <translation>redessinez avec au moins 3 coins</translation>
    </message>
    <message>
        <source>draw it as an area, or remove it from the file</source>
        <translation>dessinez-le comme une surface, ou retirez-le du fichier</translation>
    </message>
    <message>
        <source>draw it, or remove it from the file</source>
        <translation>dessinez-le, ou retirez-le du fichier</translation>
    </message>
    <message>
        <source>draw one or open a file that has one</source>
        <translation>dessinez-en une ou ouvrez un fichier qui en a une</translation>
    </message>
    <message>
        <source>draw or open one in the window first</source>
        <translation>dessinez ou ouvrez-en d&apos;abord une dans la fenêtre</translation>
    </message>
    <message>
        <source>drive on to where the recording began, or take the track as worked land</source>
        <translation>roulez jusqu&apos;à l&apos;endroit où l&apos;enregistrement a commencé, ou prenez le trajet comme terre travaillée</translation>
    </message>
    <message>
        <source>export fewer fields at once</source>
        <translation>exportez moins de parcelles à la fois</translation>
    </message>
    <message>
        <source>export it again</source>
        <translation>exportez-la à nouveau</translation>
    </message>
    <message>
        <source>export it again with its coordinate system</source>
        <translation>exportez-le à nouveau avec son système de coordonnées</translation>
    </message>
    <message>
        <source>export or copy it again</source>
        <translation>exportez-le ou copiez-le à nouveau</translation>
    </message>
    <message>
        <source>export the boundary as a polygon</source>
        <translation>exportez la limite comme polygone</translation>
    </message>
    <message>
        <source>export the field again in WGS84 (longitude and latitude)</source>
        <translation>exportez à nouveau la parcelle en WGS84 (longitude et latitude)</translation>
    </message>
    <message>
        <source>export the field with its boundary</source>
        <translation>exportez la parcelle avec sa limite</translation>
    </message>
    <message>
        <source>export the field with its boundary; furrow-cli compare reads what a machine recorded</source>
        <translation>exportez la parcelle avec sa limite ; furrow-cli compare lit ce qu&apos;une machine a enregistré</translation>
    </message>
    <message>
        <source>export the fields again in one coordinate system</source>
        <translation>exportez à nouveau les parcelles dans un seul système de coordonnées</translation>
    </message>
    <message>
        <source>export the recorded track, not only its waypoints</source>
        <translation>exportez le trajet enregistré, pas seulement ses points de passage</translation>
    </message>
    <message>
        <source>feature %1</source>
        <translation>objet %1</translation>
    </message>
    <message>
        <source>fewer than 3 different points enclose nothing</source>
        <translation>moins de 3 points différents ne délimitent rien</translation>
    </message>
    <message>
        <source>free some space on it, or use another one</source>
        <translation>libérez-y de la place, ou utilisez-en une autre</translation>
    </message>
    <message>
        <source>free some space on the stick</source>
        <translation>libérez de la place sur la clé</translation>
    </message>
    <message>
        <source>free some space or choose another folder</source>
        <translation>libérez de la place ou choisissez un autre dossier</translation>
    </message>
    <message>
        <source>gate %1</source>
        <translation>entrée de parcelle %1</translation>
    </message>
    <message>
        <source>give %1</source>
        <translation>indiquez %1</translation>
    </message>
    <message>
        <source>give 0 m or more</source>
        <translation>indiquez 0 m ou plus</translation>
    </message>
    <message>
        <source>give GPX, CSV, an NMEA or gpsd log, ISOXML task data (folder, TASKDATA.XML or zip) or a rosbag2</source>
        <translation>indiquez un GPX, un CSV, un journal NMEA ou gpsd, des données de tâche ISOXML (dossier, TASKDATA.XML ou zip) ou un rosbag2</translation>
    </message>
    <message>
        <source>give GeoJSON, a shapefile (.shp or .zip), TASKDATA.XML, KML, KMZ, GeoPackage, GML, FlatGeobuf, DXF, WKT or CSV</source>
        <translation>indiquez un GeoJSON, un shapefile (.shp ou .zip), TASKDATA.XML, KML, KMZ, GeoPackage, GML, FlatGeobuf, DXF, WKT ou CSV</translation>
    </message>
    <message>
        <source>give a GeoTIFF, or a world file (.pgw) beside the PNG</source>
        <translation>indiquez un GeoTIFF, ou un fichier de calage (.pgw) à côté du PNG</translation>
    </message>
    <message>
        <source>give a buffer of 0 m or more</source>
        <translation>indiquez une distance de 0 m ou plus</translation>
    </message>
    <message>
        <source>give a distance up to 50 m</source>
        <translation>indiquez une distance jusqu&apos;à 50 m</translation>
    </message>
    <message>
        <source>give a gap up to 100 m</source>
        <translation>indiquez un écart jusqu&apos;à 100 m</translation>
    </message>
    <message>
        <source>give a plan and a track of the same field</source>
        <translation>indiquez un plan et un trajet de la même parcelle</translation>
    </message>
    <message>
        <source>give a width up to 100 m</source>
        <translation>indiquez une largeur jusqu&apos;à 100 m</translation>
    </message>
    <message>
        <source>give an overhang of 0 to 100 m</source>
        <translation>indiquez un débord de 0 à 100 m</translation>
    </message>
    <message>
        <source>give a curve that does not, or plan its parts apart</source>
        <translation>indiquez une courbe qui ne se croise pas, ou planifiez ses parties séparément</translation>
    </message>
    <message>
        <source>give a file on a disk</source>
        <translation>indiquez un fichier sur un disque</translation>
    </message>
    <message>
        <source>give a file with a line for each row</source>
        <translation>indiquez un fichier avec une ligne par rang</translation>
    </message>
    <message>
        <source>give a gate, or a point in the field</source>
        <translation>indiquez une entrée, ou un point dans la parcelle</translation>
    </message>
    <message>
        <source>give a gentler curve, or one without a turn back</source>
        <translation>indiquez une courbe plus douce, ou sans retour en arrière</translation>
    </message>
    <message>
        <source>give a machine file (JSON)</source>
        <translation>indiquez un fichier de machine (JSON)</translation>
    </message>
    <message>
        <source>give a number</source>
        <translation>indiquez un nombre</translation>
    </message>
    <message>
        <source>give a number from %1 to %2</source>
        <translation>indiquez un nombre de %1 à %2</translation>
    </message>
    <message>
        <source>give a number from 0 to %1</source>
        <translation>indiquez un nombre de 0 à %1</translation>
    </message>
    <message>
        <source>give a number in %1</source>
        <translation>indiquez un nombre en %1</translation>
    </message>
    <message>
        <source>give a picture of at most 100 million pixels</source>
        <translation>indiquez une image de 100 millions de pixels au plus</translation>
    </message>
    <message>
        <source>give a point such as POINT (4.1 52.0)</source>
        <translation>indiquez un point comme POINT (4.1 52.0)</translation>
    </message>
    <message>
        <source>give a smaller margin or check the obstacles</source>
        <translation>indiquez une marge plus petite ou vérifiez les obstacles</translation>
    </message>
    <message>
        <source>give a smaller number</source>
        <translation>indiquez un nombre plus petit</translation>
    </message>
    <message>
        <source>give a text in quotes</source>
        <translation>indiquez un texte entre guillemets</translation>
    </message>
    <message>
        <source>give a transverse Mercator with +lat_0 and +lon_0</source>
        <translation>indiquez une projection de Mercator transverse avec +lat_0 et +lon_0</translation>
    </message>
    <message>
        <source>give a width of 0 m or more</source>
        <translation>indiquez une largeur de 0 m ou plus</translation>
    </message>
    <message>
        <source>give an EPSG code, as in SRID=4326;POLYGON(...)</source>
        <translation>indiquez un code EPSG, comme SRID=4326;POLYGON(...)</translation>
    </message>
    <message>
        <source>give both in degrees, or remove the row</source>
        <translation>indiquez les deux en degrés, ou retirez la ligne</translation>
    </message>
    <message>
        <source>give each point as [longitude, latitude]</source>
        <translation>indiquez chaque point sous la forme [longitude, latitude]</translation>
    </message>
    <message>
        <source>give heights as a GeoTIFF or an ASCII grid</source>
        <translation>indiquez les altitudes en GeoTIFF ou en grille ASCII</translation>
    </message>
    <message>
        <source>give heights that cover the field</source>
        <translation>indiquez des altitudes qui couvrent la parcelle</translation>
    </message>
    <message>
        <source>give it a kind, or remove it from the file</source>
        <translation>indiquez son type, ou retirez-le du fichier</translation>
    </message>
    <message>
        <source>give it as WKT in WGS84, %1</source>
        <translation>indiquez-la en WKT en WGS84, %1</translation>
    </message>
    <message>
        <source>give it as WKT in WGS84, such as LINESTRING (4.1 52.0, 4.2 52.0, 4.3 52.1)</source>
        <translation>indiquez-la en WKT en WGS84, comme LINESTRING (4.1 52.0, 4.2 52.0, 4.3 52.1)</translation>
    </message>
    <message>
        <source>give it as WKT in WGS84, such as POINT (4.1 52.0)</source>
        <translation>indiquez-le en WKT en WGS84, comme POINT (4.1 52.0)</translation>
    </message>
    <message>
        <source>give it the field that it lies in, or remove it from the file</source>
        <translation>indiquez la parcelle où il se trouve, ou retirez-le du fichier</translation>
    </message>
    <message>
        <source>give its width while it is folded</source>
        <translation>indiquez sa largeur une fois replié</translation>
    </message>
    <message>
        <source>give less than the operating width</source>
        <translation>indiquez moins que la largeur de travail</translation>
    </message>
    <message>
        <source>give metres, 0 or more</source>
        <translation>indiquez des mètres, 0 ou plus</translation>
    </message>
    <message>
        <source>give min_turning_radius_m or max_steering_angle_deg</source>
        <translation>indiquez min_turning_radius_m ou max_steering_angle_deg</translation>
    </message>
    <message>
        <source>give one of %1 or a point such as POINT (4.1 52.0)</source>
        <translation>indiquez l&apos;une de %1 ou un point comme POINT (4.1 52.0)</translation>
    </message>
    <message>
        <source>give one of the files in it</source>
        <translation>indiquez un des fichiers qu&apos;il contient</translation>
    </message>
    <message>
        <source>give operating_width_m in metres</source>
        <translation>indiquez operating_width_m en mètres</translation>
    </message>
    <message>
        <source>give the file TASKDATA.XML</source>
        <translation>indiquez le fichier TASKDATA.XML</translation>
    </message>
    <message>
        <source>give the folder of a field</source>
        <translation>indiquez le dossier d&apos;une parcelle</translation>
    </message>
    <message>
        <source>give the folder of one of these, or a file in it</source>
        <translation>indiquez le dossier de l&apos;un d&apos;eux, ou un fichier qu&apos;il contient</translation>
    </message>
    <message>
        <source>give the folder of one recording</source>
        <translation>indiquez le dossier d&apos;un enregistrement</translation>
    </message>
    <message>
        <source>give the folder or zip with TASKDATA.XML and its TLG files, a rosbag2 folder, or one file</source>
        <translation>indiquez le dossier ou le zip avec TASKDATA.XML et ses fichiers TLG, un dossier rosbag2, ou un seul fichier</translation>
    </message>
    <message>
        <source>give the points in degrees (WGS84), longitude in lon and latitude in lat</source>
        <translation>indiquez les points en degrés (WGS84), longitude dans lon et latitude dans lat</translation>
    </message>
    <message>
        <source>give true or false</source>
        <translation>indiquez true ou false</translation>
    </message>
    <message>
        <source>give two points at least 1 m apart</source>
        <translation>indiquez deux points distants d&apos;au moins 1 m</translation>
    </message>
    <message>
        <source>give x_m and y_m in the plan&apos;s frame, or longitude and latitude</source>
        <translation>indiquez x_m et y_m dans le repère du plan, ou longitude et latitude</translation>
    </message>
    <message>
        <source>guidance lines without two points</source>
        <translation>lignes de guidage sans deux points</translation>
    </message>
    <message>
        <source>guidance patterns whose points do not fit their kind</source>
        <translation>motifs de guidage dont les points ne vont pas avec leur type</translation>
    </message>
    <message>
        <source>guidance patterns without a line</source>
        <translation>motifs de guidage sans ligne</translation>
    </message>
    <message>
        <source>headland pass %1</source>
        <translation>tour de fourrière %1</translation>
    </message>
    <message>
        <source>hole %1 encloses no area and was left out</source>
        <translation>l&apos;enclave %1 ne délimite aucune surface et a été laissée de côté</translation>
    </message>
    <message>
        <source>it does not say in which coordinate system it is</source>
        <translation>il ne dit pas dans quel système de coordonnées il est</translation>
    </message>
    <message>
        <source>it does not say what it is</source>
        <translation>il n&apos;est pas dit ce que c&apos;est</translation>
    </message>
    <message>
        <source>it does not say which field it belongs to</source>
        <translation>il n&apos;est pas dit à quelle parcelle il appartient</translation>
    </message>
    <message>
        <source>it has %1 by %2 pixels</source>
        <translation>elle a %1 pixels sur %2</translation>
    </message>
    <message>
        <source>it has %1: %2</source>
        <translation>il a %1 : %2</translation>
    </message>
    <message>
        <source>it has another coordinate system than the file</source>
        <translation>il a un autre système de coordonnées que le fichier</translation>
    </message>
    <message>
        <source>it has more than %1 parts</source>
        <translation>il a plus de %1 parties</translation>
    </message>
    <message>
        <source>it has no heights where the field is</source>
        <translation>il n&apos;a pas d&apos;altitudes là où est la parcelle</translation>
    </message>
    <message>
        <source>it has no shape</source>
        <translation>il n&apos;a pas de forme</translation>
    </message>
    <message>
        <source>it has: %1</source>
        <translation>elle a : %1</translation>
    </message>
    <message>
        <source>it holds more than %1 files</source>
        <translation>il contient plus de %1 fichiers</translation>
    </message>
    <message>
        <source>it holds more than %1 positions</source>
        <translation>il contient plus de %1 positions</translation>
    </message>
    <message>
        <source>it is a line at %1 without a width</source>
        <translation>c&apos;est une ligne à %1 sans largeur</translation>
    </message>
    <message>
        <source>it is a point at %1 without a size</source>
        <translation>c&apos;est un point à %1 sans étendue</translation>
    </message>
    <message>
        <source>it is no closed line</source>
        <translation>ce n&apos;est pas une ligne fermée</translation>
    </message>
    <message>
        <source>it is no raster of heights</source>
        <translation>ce n&apos;est pas une grille d&apos;altitudes</translation>
    </message>
    <message>
        <source>it is no rosbag2 that can be read (%1)</source>
        <translation>ce n&apos;est pas un rosbag2 lisible (%1)</translation>
    </message>
    <message>
        <source>it is not a length</source>
        <translation>ce n&apos;est pas une longueur</translation>
    </message>
    <message>
        <source>it is not what a plan&apos;s is</source>
        <translation>ce n&apos;est pas celui d&apos;un plan</translation>
    </message>
    <message>
        <source>it lies in none of the %1 fields</source>
        <translation>il n&apos;est dans aucune des %1 parcelles</translation>
    </message>
    <message>
        <source>it lies outside the field</source>
        <translation>il est hors de la parcelle</translation>
    </message>
    <message>
        <source>it may be damaged; copy or export it again</source>
        <translation>il est peut-être endommagé ; copiez-le ou exportez-le à nouveau</translation>
    </message>
    <message>
        <source>it names no local frame</source>
        <translation>il ne nomme pas de repère local</translation>
    </message>
    <message>
        <source>it names no machine</source>
        <translation>il ne nomme pas de machine</translation>
    </message>
    <message>
        <source>it needs latitude and longitude, as in 52.09,5.66</source>
        <translation>il lui faut latitude et longitude, comme 52.09,5.66</translation>
    </message>
    <message>
        <source>its buffer is not a length</source>
        <translation>sa distance n&apos;est pas une longueur</translation>
    </message>
    <message>
        <source>its compression &apos;%1&apos; is not known</source>
        <translation>sa compression « %1 » n&apos;est pas connue</translation>
    </message>
    <message>
        <source>its overhang is not a length from 0 to 100 m</source>
        <translation>son débord n&apos;est pas une longueur de 0 à 100 m</translation>
    </message>
    <message>
        <source>its coordinate system &apos;%1&apos; cannot be turned into WGS84</source>
        <translation>son système de coordonnées « %1 » ne peut pas être converti en WGS84</translation>
    </message>
    <message>
        <source>its coordinate system &apos;%1&apos; is not known</source>
        <translation>son système de coordonnées « %1 » n&apos;est pas connu</translation>
    </message>
    <message>
        <source>its coordinate system cannot be turned into WGS84</source>
        <translation>son système de coordonnées ne peut pas être converti en WGS84</translation>
    </message>
    <message>
        <source>its coordinate system would have to be fetched from &apos;%1&apos;</source>
        <translation>son système de coordonnées devrait être téléchargé depuis « %1 »</translation>
    </message>
    <message>
        <source>its file is missing</source>
        <translation>son fichier manque</translation>
    </message>
    <message>
        <source>its heights cannot be read</source>
        <translation>ses altitudes ne peuvent pas être lues</translation>
    </message>
    <message>
        <source>its holes leave nothing of it</source>
        <translation>les enclaves n&apos;en laissent rien</translation>
    </message>
    <message>
        <source>its kind &apos;%1&apos; is not known</source>
        <translation>son type « %1 » n&apos;est pas connu</translation>
    </message>
    <message>
        <source>its points enclose no area</source>
        <translation>ses points ne délimitent aucune surface</translation>
    </message>
    <message>
        <source>its width is not a length</source>
        <translation>sa largeur n&apos;est pas une longueur</translation>
    </message>
    <message>
        <source>keep one of them</source>
        <translation>gardez-en une</translation>
    </message>
    <message>
        <source>keep the .shp, .shx, .dbf and .prj files together</source>
        <translation>gardez .shp, .shx, .dbf et .prj ensemble</translation>
    </message>
    <message>
        <source>leave it out, or give a project of the window</source>
        <translation>omettez-le, ou indiquez un projet de la fenêtre</translation>
    </message>
    <message>
        <source>leaves the field by %1</source>
        <translation>sort de la parcelle de %1</translation>
    </message>
    <message>
        <source>left out: %1</source>
        <translation>laissé de côté : %1</translation>
    </message>
    <message>
        <source>left out: %1 %2</source>
        <translation>laissé de côté : %1 %2</translation>
    </message>
    <message>
        <source>line %1 is left out: it is damaged</source>
        <translation>la ligne %1 est laissée de côté : elle est endommagée</translation>
    </message>
    <message>
        <source>line %1, column %2</source>
        <translation>ligne %1, colonne %2</translation>
    </message>
    <message>
        <source>lines in WGS84 such as MULTILINESTRING ((4.1 52.0, 4.2 52.0), (4.1 52.1, 4.2 52.1))</source>
        <translation>des lignes en WGS84 comme MULTILINESTRING ((4.1 52.0, 4.2 52.0), (4.1 52.1, 4.2 52.1))</translation>
    </message>
    <message>
        <source>lines that guide nothing</source>
        <translation>lignes qui ne guident rien</translation>
    </message>
    <message>
        <source>lon=&quot;%1&quot; lat=&quot;%2&quot; is no place on Earth</source>
        <translation>lon=&quot;%1&quot; lat=&quot;%2&quot; n&apos;est pas un lieu sur Terre</translation>
    </message>
    <message>
        <source>look for a missing comma, quote or brace just before it</source>
        <translation>cherchez une virgule, un guillemet ou une accolade qui manque juste avant</translation>
    </message>
    <message>
        <source>most of its lines are not JSON</source>
        <translation>la plupart de ses lignes ne sont pas du JSON</translation>
    </message>
    <message>
        <source>most of its sentences have a wrong checksum</source>
        <translation>la plupart de ses phrases ont une somme de contrôle fausse</translation>
    </message>
    <message>
        <source>move one of the points there, so that it is clear which side is field</source>
        <translation>déplacez-y un point, pour qu&apos;il soit clair de quel côté est la parcelle</translation>
    </message>
    <message>
        <source>move or delete it</source>
        <translation>déplacez-le ou supprimez-le</translation>
    </message>
    <message>
        <source>name a raster of heights, such as a GeoTIFF</source>
        <translation>indiquez une grille d&apos;altitudes, par exemple un GeoTIFF</translation>
    </message>
    <message>
        <source>name each swath once</source>
        <translation>indiquez chaque passage une fois</translation>
    </message>
    <message>
        <source>name each swath once, with a minus where it is driven backwards</source>
        <translation>indiquez chaque passage une fois, avec un signe moins là où il est fait dans l&apos;autre sens</translation>
    </message>
    <message>
        <source>name one, such as GeoJSON with a LineString for each row</source>
        <translation>indiquez-en un, par exemple un GeoJSON avec une LineString par rang</translation>
    </message>
    <message>
        <source>name the columns in the first row</source>
        <translation>nommez les colonnes dans la première ligne</translation>
    </message>
    <message>
        <source>name the columns, for example time,lon,lat,speed_kmh in the first line</source>
        <translation>nommez les colonnes, par exemple time,lon,lat,speed_kmh sur la première ligne</translation>
    </message>
    <message>
        <source>name the folder of a plan, as furrow-cli plan writes it</source>
        <translation>indiquez le dossier d&apos;un plan, tel que l&apos;écrit furrow-cli plan</translation>
    </message>
    <message>
        <source>neither turning radius nor steering angle is given</source>
        <translation>ni rayon de braquage ni angle de braquage n&apos;est donné</translation>
    </message>
    <message>
        <source>no boundary can be read from this file (%1)</source>
        <translation>aucune limite ne peut être lue dans ce fichier (%1)</translation>
    </message>
    <message>
        <source>no header names a longitude and a latitude (or x_m and y_m)</source>
        <translation>aucun en-tête ne nomme une longitude et une latitude (ou x_m et y_m)</translation>
    </message>
    <message>
        <source>no pixel of the picture is worked</source>
        <translation>aucun pixel de l&apos;image n&apos;est travaillé</translation>
    </message>
    <message>
        <source>no row of this table has a position</source>
        <translation>aucune ligne de ce tableau n&apos;a de position</translation>
    </message>
    <message>
        <source>no swath fits inside the headland</source>
        <translation>aucun passage ne tient dans le plein champ</translation>
    </message>
    <message>
        <source>no topic of this bag has a position</source>
        <translation>aucun topic de ce bag n&apos;a de position</translation>
    </message>
    <message>
        <source>none of its %1 RMC and GGA sentences has a position</source>
        <translation>aucune de ses %1 phrases RMC et GGA n&apos;a de position</translation>
    </message>
    <message>
        <source>none of its %1 position reports has a position</source>
        <translation>aucun de ses %1 rapports de position n&apos;a de position</translation>
    </message>
    <message>
        <source>none of its %1 time logs holds a position</source>
        <translation>aucun de ses %1 journaux ne contient de position</translation>
    </message>
    <message>
        <source>none of the tracks has more than one position</source>
        <translation>aucun des trajets n&apos;a plus d&apos;une position</translation>
    </message>
    <message>
        <source>nothing is left of the land inside of this track</source>
        <translation>il ne reste rien de la terre à l&apos;intérieur de ce trajet</translation>
    </message>
    <message>
        <source>obstacle %1</source>
        <translation>obstacle %1</translation>
    </message>
    <message>
        <source>obstacles outside the boundary</source>
        <translation>obstacles hors de la limite</translation>
    </message>
    <message>
        <source>obstacles that are holes already</source>
        <translation>obstacles qui sont déjà des enclaves</translation>
    </message>
    <message>
        <source>one of its choices</source>
        <translation>l&apos;un de ses choix</translation>
    </message>
    <message>
        <source>only files on this computer are read</source>
        <translation>seuls les fichiers de cet ordinateur sont lus</translation>
    </message>
    <message>
        <source>only the fields of a project have plans</source>
        <translation>seules les parcelles d&apos;un projet ont des plans</translation>
    </message>
    <message>
        <source>open a file of your own</source>
        <translation>ouvrez un fichier à vous</translation>
    </message>
    <message>
        <source>open it as a field boundary, or choose another file</source>
        <translation>ouvrez-le comme limite de parcelle, ou choisissez un autre fichier</translation>
    </message>
    <message>
        <source>open it with a newer Furrow; the file was left as it is</source>
        <translation>ouvrez-le avec un Furrow plus récent ; le fichier est resté tel quel</translation>
    </message>
    <message>
        <source>open the field of that plan first, or record longitude and latitude</source>
        <translation>ouvrez d&apos;abord la parcelle de ce plan, ou enregistrez longitude et latitude</translation>
    </message>
    <message>
        <source>opennav_coverage goal</source>
        <translation>Objectif opennav_coverage</translation>
    </message>
    <message>
        <source>opennav_coverage lays swaths and turns of its own from the goal; they need not be those of this plan.</source>
        <translation>opennav_coverage trace ses propres passages et demi-tours ; ce ne sont pas forcément ceux de ce plan.</translation>
    </message>
    <message>
        <source>part %1</source>
        <translation>partie %1</translation>
    </message>
    <message>
        <source>part %1, point %2</source>
        <translation>partie %1, point %2</translation>
    </message>
    <message>
        <source>path.csv has %1 segments and plan.geojson %2</source>
        <translation>path.csv a %1 tronçons et plan.geojson %2</translation>
    </message>
    <message>
        <source>per m²</source>
        <translation>par m²</translation>
    </message>
    <message>
        <source>pivot needs its centre</source>
        <translation>les cercles demandent leur centre</translation>
    </message>
    <message>
        <source>plan the field first: furrow-cli plan FIELD --out plan</source>
        <translation>planifiez d&apos;abord la parcelle : furrow-cli plan FIELD --out plan</translation>
    </message>
    <message>
        <source>points that are no gates</source>
        <translation>points qui ne sont pas des entrées de parcelle</translation>
    </message>
    <message>
        <source>polygons of a kind that is not used</source>
        <translation>polygones d&apos;un type non utilisé</translation>
    </message>
    <message>
        <source>put the EPSG code into its name, as in field_EPSG32632.dxf</source>
        <translation>mettez le code EPSG dans son nom, comme field_EPSG32632.dxf</translation>
    </message>
    <message>
        <source>record %1 has a value that its header does not name</source>
        <translation>l&apos;élément %1 a une valeur que son en-tête ne nomme pas</translation>
    </message>
    <message>
        <source>record a position every second, or every few metres</source>
        <translation>enregistrez une position chaque seconde, ou tous les quelques mètres</translation>
    </message>
    <message>
        <source>record or draw its boundary first</source>
        <translation>enregistrez ou dessinez d&apos;abord sa limite</translation>
    </message>
    <message>
        <source>record or export it again</source>
        <translation>enregistrez-le ou exportez-le à nouveau</translation>
    </message>
    <message>
        <source>record sensor_msgs/NavSatFix, nav_msgs/Odometry, geometry_msgs/PoseStamped or nav_msgs/Path</source>
        <translation>enregistrez sensor_msgs/NavSatFix, nav_msgs/Odometry, geometry_msgs/PoseStamped ou nav_msgs/Path</translation>
    </message>
    <message>
        <source>record the log again with a receiver that has a fix</source>
        <translation>enregistrez à nouveau avec un récepteur qui connaît sa position</translation>
    </message>
    <message>
        <source>record the positions without pictures and point clouds</source>
        <translation>enregistrez les positions sans images ni nuages de points</translation>
    </message>
    <message>
        <source>record with a correction signal (EGNOS, RTK), or under an open sky</source>
        <translation>enregistrez avec un signal de correction (EGNOS, RTK), ou à ciel ouvert</translation>
    </message>
    <message>
        <source>record with zstd, lz4 or no compression</source>
        <translation>enregistrez avec zstd, lz4 ou sans compression</translation>
    </message>
    <message>
        <source>remove it from the file, or add its field</source>
        <translation>retirez-le du fichier, ou ajoutez sa parcelle</translation>
    </message>
    <message>
        <source>remove it; keys look like operating_width_m, vehicle_width_m, can_reverse</source>
        <translation>retirez-le ; les clés ressemblent à operating_width_m, vehicle_width_m, can_reverse</translation>
    </message>
    <message>
        <source>restore a copy of the file</source>
        <translation>restaurez une copie du fichier</translation>
    </message>
    <message>
        <source>rings that overlap each other were joined</source>
        <translation>des contours qui se chevauchent ont été réunis</translation>
    </message>
    <message>
        <source>rings with fewer than three corners</source>
        <translation>contours de moins de trois coins</translation>
    </message>
    <message>
        <source>rows needs a file of lines</source>
        <translation>les rangs demandent un fichier de lignes</translation>
    </message>
    <message>
        <source>save it again in WGS84</source>
        <translation>enregistrez-la à nouveau en WGS84</translation>
    </message>
    <message>
        <source>save it as GeoTIFF, or with a world file in degrees</source>
        <translation>enregistrez-la en GeoTIFF, ou avec un fichier de calage en degrés</translation>
    </message>
    <message>
        <source>save the field again, or remove this file</source>
        <translation>enregistrez à nouveau la parcelle ou retirez ce fichier</translation>
    </message>
    <message>
        <source>save the project, and free some space</source>
        <translation>enregistrez le projet et libérez de la place</translation>
    </message>
    <message>
        <source>say how far to keep from it (buffer_m), or draw its outline</source>
        <translation>indiquez la distance à garder (buffer_m), ou dessinez son contour</translation>
    </message>
    <message>
        <source>several fields are called &apos;%1&apos;</source>
        <translation>plusieurs parcelles s&apos;appellent « %1 »</translation>
    </message>
    <message>
        <source>several plans of &apos;%1&apos; are called &apos;%2&apos;</source>
        <translation>plusieurs plans de « %1 » s&apos;appellent « %2 »</translation>
    </message>
    <message>
        <source>simplify it to at most a million</source>
        <translation>simplifiez-la à un million au plus</translation>
    </message>
    <message>
        <source>such as LINESTRING (4.1 52.0, 4.2 52.0)</source>
        <translation>comme LINESTRING (4.1 52.0, 4.2 52.0)</translation>
    </message>
    <message>
        <source>such as POINT (4.1 52.0)</source>
        <translation>comme POINT (4.1 52.0)</translation>
    </message>
    <message>
        <source>swath %1</source>
        <translation>passage %1</translation>
    </message>
    <message>
        <source>swath %1 is named twice</source>
        <translation>le passage %1 est nommé deux fois</translation>
    </message>
    <message>
        <source>take it away</source>
        <translation>retirez-la</translation>
    </message>
    <message>
        <source>take off its write protection, or use another one</source>
        <translation>ôtez la protection, ou utilisez une autre clé</translation>
    </message>
    <message>
        <source>take off the write protection of the stick</source>
        <translation>ôtez la protection en écriture de la clé</translation>
    </message>
    <message>
        <source>take the track as driven around the field, or record the work</source>
        <translation>prenez le trajet comme un tour de la parcelle, ou enregistrez le travail</translation>
    </message>
    <message>
        <source>the .shx file that belongs to it is missing</source>
        <translation>le fichier .shx qui l&apos;accompagne manque</translation>
    </message>
    <message>
        <source>the GPX file is damaged (%1)</source>
        <translation>le fichier GPX est endommagé (%1)</translation>
    </message>
    <message>
        <source>the GPX file is larger than 256 MiB</source>
        <translation>le fichier GPX dépasse 256 Mio</translation>
    </message>
    <message>
        <source>the boundary</source>
        <translation>la limite de parcelle</translation>
    </message>
    <message>
        <source>the boundary has %1 points</source>
        <translation>la limite a %1 points</translation>
    </message>
    <message>
        <source>the boundary has no such edge</source>
        <translation>la limite n&apos;a pas ce côté</translation>
    </message>
    <message>
        <source>the boundary is that of the guidance group; the field itself has none</source>
        <translation>la limite est celle du groupe de guidage ; la parcelle elle-même n&apos;en a pas</translation>
    </message>
    <message>
        <source>the coordinate system that it names is not known</source>
        <translation>le système de coordonnées qu&apos;il nomme n&apos;est pas connu</translation>
    </message>
    <message>
        <source>the coordinates lie outside longitude -180 to 180 and latitude -90 to 90</source>
        <translation>les coordonnées sont hors de la longitude -180 à 180 et de la latitude -90 à 90</translation>
    </message>
    <message>
        <source>the curve bends more sharply than this machine can follow (%1 of radius)</source>
        <translation>la courbe est plus serrée que ce que cette machine peut suivre (%1 de rayon)</translation>
    </message>
    <message>
        <source>the curve crosses itself, %1 from its start</source>
        <translation>la courbe se croise, à %1 de son début</translation>
    </message>
    <message>
        <source>the curves from line %1 on are left out: it is damaged</source>
        <translation>les courbes à partir de la ligne %1 sont laissées de côté : elle est endommagée</translation>
    </message>
    <message>
        <source>the edge cannot lie that far from the line</source>
        <translation>le bord ne peut pas être aussi loin de la ligne</translation>
    </message>
    <message>
        <source>the end</source>
        <translation>arrivée</translation>
    </message>
    <message>
        <source>the field &apos;%1&apos; has no boundary</source>
        <translation>la parcelle « %1 » n&apos;a pas de limite</translation>
    </message>
    <message>
        <source>the field &apos;%1&apos; has no plan &apos;%2&apos;</source>
        <translation>la parcelle « %1 » n&apos;a pas de plan « %2 »</translation>
    </message>
    <message>
        <source>the field &apos;%1&apos; is left out: %2</source>
        <translation>la parcelle « %1 » est laissée de côté : %2</translation>
    </message>
    <message>
        <source>the field has neither boundary nor guidance line</source>
        <translation>la parcelle n&apos;a ni limite ni ligne de guidage</translation>
    </message>
    <message>
        <source>the field has no boundary</source>
        <translation>la parcelle n&apos;a pas de limite</translation>
    </message>
    <message>
        <source>the field is more than 100 km across; %1 is farthest from the others</source>
        <translation>la parcelle s&apos;étend sur plus de 100 km ; %1 est le plus loin des autres</translation>
    </message>
    <message>
        <source>the field is nowhere as wide as the machine (%1%2)</source>
        <translation>la parcelle n&apos;est nulle part aussi large que la machine (%1%2)</translation>
    </message>
    <message>
        <source>the fields in this task data have neither boundary nor guidance line</source>
        <translation>les parcelles de ces données de tâche n&apos;ont ni limite ni ligne de guidage</translation>
    </message>
    <message>
        <source>the file cannot be read</source>
        <translation>le fichier ne peut pas être lu</translation>
    </message>
    <message>
        <source>the file has %1 fields: %2</source>
        <translation>le fichier a %1 parcelles : %2</translation>
    </message>
    <message>
        <source>the file is damaged</source>
        <translation>le fichier est endommagé</translation>
    </message>
    <message>
        <source>the file is damaged (%1)</source>
        <translation>le fichier est endommagé (%1)</translation>
    </message>
    <message>
        <source>the file is damaged here</source>
        <translation>le fichier est endommagé ici</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>le fichier est vide</translation>
    </message>
    <message>
        <source>the file is empty or cannot be read</source>
        <translation>le fichier est vide ou illisible</translation>
    </message>
    <message>
        <source>the file is larger than 1 GiB</source>
        <translation>le fichier dépasse 1 Gio</translation>
    </message>
    <message>
        <source>the file may be cut off or damaged; copy or export it again</source>
        <translation>le fichier est peut-être coupé ou endommagé ; copiez-le ou exportez-le à nouveau</translation>
    </message>
    <message>
        <source>the file may be cut off or damaged; export it again</source>
        <translation>le fichier est peut-être coupé ou endommagé ; exportez-le à nouveau</translation>
    </message>
    <message>
        <source>the folder or zip cannot be read</source>
        <translation>le dossier ou le zip ne peut pas être lu</translation>
    </message>
    <message>
        <source>the gap is out of range</source>
        <translation>l&apos;écart est hors limites</translation>
    </message>
    <message>
        <source>the headland is left out: line %1 is damaged</source>
        <translation>la fourrière est laissée de côté : la ligne %1 est endommagée</translation>
    </message>
    <message>
        <source>the headland of edge %1</source>
        <translation>la fourrière du côté %1</translation>
    </message>
    <message>
        <source>the implement was nowhere down on this track</source>
        <translation>l&apos;outil n&apos;a été baissé nulle part sur ce trajet</translation>
    </message>
    <message>
        <source>the log is cut off in record %1</source>
        <translation>le journal est coupé à l&apos;élément %1</translation>
    </message>
    <message>
        <source>the operating width is out of range</source>
        <translation>la largeur de travail est hors limites</translation>
    </message>
    <message>
        <source>the overhang of edge %1</source>
        <translation>le débord du côté %1</translation>
    </message>
    <message>
        <source>edge %1</source>
        <translation>côté %1</translation>
    </message>
    <message>
        <source>the key is there twice</source>
        <translation>la clé y est deux fois</translation>
    </message>
    <message>
        <source>the line after StartFix is no place</source>
        <translation>la ligne après StartFix n&apos;est pas une position</translation>
    </message>
    <message>
        <source>the line crosses itself at %1</source>
        <translation>la ligne se croise en %1</translation>
    </message>
    <message>
        <source>the line touches or crosses itself by a sliver; taken apart there</source>
        <translation>la ligne se touche ou se croise de très peu ; séparée à cet endroit</translation>
    </message>
    <message>
        <source>the lines from line %1 on are left out: it is damaged</source>
        <translation>les lignes à partir de la ligne %1 sont laissées de côté : elle est endommagée</translation>
    </message>
    <message>
        <source>the machine (%1 wide, %2 long%3) fits nowhere into the field</source>
        <translation>la machine (%1 de large, %2 de long%3) ne tient nulle part dans la parcelle</translation>
    </message>
    <message>
        <source>the name of a gate or a point in WGS84 such as POINT (4.1 52.0)</source>
        <translation>le nom d&apos;une entrée ou un point en WGS84 comme POINT (4.1 52.0)</translation>
    </message>
    <message>
        <source>the number after SRID= is no coordinate system that is known</source>
        <translation>le nombre après SRID= n&apos;est pas un système de coordonnées connu</translation>
    </message>
    <message>
        <source>the obstacles leave nothing of the field</source>
        <translation>les obstacles ne laissent rien de la parcelle</translation>
    </message>
    <message>
        <source>the operating width is missing</source>
        <translation>la largeur de travail manque</translation>
    </message>
    <message>
        <source>the part %1 is left out: %2</source>
        <translation>la partie %1 est laissée de côté : %2</translation>
    </message>
    <message>
        <source>the path of a file</source>
        <translation>le chemin d&apos;un fichier</translation>
    </message>
    <message>
        <source>the picture cannot be read (%1)</source>
        <translation>l&apos;image ne peut pas être lue (%1)</translation>
    </message>
    <message>
        <source>the picture does not say where it lies</source>
        <translation>l&apos;image ne dit pas où elle se trouve</translation>
    </message>
    <message>
        <source>the picture does not say which coordinate system it uses</source>
        <translation>l&apos;image ne dit pas quel système de coordonnées elle utilise</translation>
    </message>
    <message>
        <source>the picture is damaged</source>
        <translation>l&apos;image est endommagée</translation>
    </message>
    <message>
        <source>the place lies outside of the field</source>
        <translation>l&apos;endroit est hors de la parcelle</translation>
    </message>
    <message>
        <source>the plan gives no reason</source>
        <translation>le plan n&apos;en donne pas la raison</translation>
    </message>
    <message>
        <source>the positions of this track are metres in the plan that was driven, not places on Earth</source>
        <translation>les positions de ce trajet sont des mètres dans le plan suivi, pas des lieux sur Terre</translation>
    </message>
    <message>
        <source>the recorded path is left out: it is damaged</source>
        <translation>le trajet enregistré est laissé de côté : il est endommagé</translation>
    </message>
    <message>
        <source>the recording cannot be made: %1</source>
        <translation>l&apos;enregistrement ne peut pas être créé : %1</translation>
    </message>
    <message>
        <source>the recording is cut off in the middle of a record</source>
        <translation>l&apos;enregistrement est coupé au milieu d&apos;un élément</translation>
    </message>
    <message>
        <source>the recording is cut off: its end is missing</source>
        <translation>l&apos;enregistrement est coupé : sa fin manque</translation>
    </message>
    <message>
        <source>the sample field cannot be read</source>
        <translation>la parcelle d&apos;exemple ne peut pas être lue</translation>
    </message>
    <message>
        <source>the shape could not be computed with (%1)</source>
        <translation>le calcul avec cette forme a échoué (%1)</translation>
    </message>
    <message>
        <source>the start</source>
        <translation>départ</translation>
    </message>
    <message>
        <source>the stick does not answer any more (%1)</source>
        <translation>la clé ne répond plus (%1)</translation>
    </message>
    <message>
        <source>the stick has %1 MB free, and %2 MB are needed</source>
        <translation>la clé a %1 Mo de libres, et il en faut %2</translation>
    </message>
    <message>
        <source>the stick is damaged: use another one</source>
        <translation>la clé est endommagée : utilisez-en une autre</translation>
    </message>
    <message>
        <source>the stick is write-protected</source>
        <translation>la clé est protégée en écriture</translation>
    </message>
    <message>
        <source>the strips of this track lie nowhere beside each other</source>
        <translation>les bandes de ce trajet ne sont nulle part côte à côte</translation>
    </message>
    <message>
        <source>the swaths are left out: %1</source>
        <translation>les passages sont laissés de côté : %1</translation>
    </message>
    <message>
        <source>the table has neither a column WKT nor columns lon and lat</source>
        <translation>le tableau n&apos;a ni colonne WKT ni colonnes lon et lat</translation>
    </message>
    <message>
        <source>the track does not come to the plan anywhere</source>
        <translation>le trajet ne passe nulle part près du plan</translation>
    </message>
    <message>
        <source>the track goes around nothing: from its end to its beginning %1 are missing</source>
        <translation>le trajet ne fait pas le tour : il manque %1 de sa fin à son début</translation>
    </message>
    <message numerus="yes">
        <source>the track has %n positions only</source>
        <translation>
            <numerusform>le trajet n&apos;a que %n position</numerusform>
            <numerusform>le trajet n&apos;a que %n positions</numerusform>
        </translation>
    </message>
    <message>
        <source>the transfer after %1</source>
        <translation>le déplacement après le %1</translation>
    </message>
    <message>
        <source>the transfer at %1</source>
        <translation>le déplacement à %1</translation>
    </message>
    <message>
        <source>the turn after %1</source>
        <translation>le demi-tour après le %1</translation>
    </message>
    <message>
        <source>the turn at %1</source>
        <translation>le demi-tour à %1</translation>
    </message>
    <message>
        <source>the way to refill</source>
        <translation>le déplacement pour remplir</translation>
    </message>
    <message>
        <source>the zip cannot be made: %1</source>
        <translation>le zip ne peut pas être créé : %1</translation>
    </message>
    <message>
        <source>there is no &apos;%1&apos;</source>
        <translation>il n&apos;y a pas de « %1 »</translation>
    </message>
    <message>
        <source>there is no &apos;%1&apos; in a machine</source>
        <translation>il n&apos;y a pas de « %1 » dans une machine</translation>
    </message>
    <message>
        <source>there is no Field.txt</source>
        <translation>il n&apos;y a pas de Field.txt</translation>
    </message>
    <message>
        <source>there is no boundary</source>
        <translation>il n&apos;y a pas de limite de parcelle</translation>
    </message>
    <message>
        <source>there is no boundary file in this zip</source>
        <translation>ce zip ne contient pas de fichier de limites</translation>
    </message>
    <message>
        <source>there is no edge %1</source>
        <translation>il n&apos;y a pas de côté %1</translation>
    </message>
    <message>
        <source>there is no field &apos;%1&apos; in the file</source>
        <translation>il n&apos;y a pas de parcelle « %1 » dans le fichier</translation>
    </message>
    <message>
        <source>there is no field &apos;%1&apos; in the project</source>
        <translation>il n&apos;y a pas de parcelle « %1 » dans le projet</translation>
    </message>
    <message>
        <source>there is no field boundary in it</source>
        <translation>il ne contient pas de limite de parcelle</translation>
    </message>
    <message>
        <source>there is no field boundary in it, only %1</source>
        <translation>il ne contient pas de limite de parcelle, seulement %1</translation>
    </message>
    <message>
        <source>there is no field in this project</source>
        <translation>il n&apos;y a pas de parcelle dans ce projet</translation>
    </message>
    <message>
        <source>there is no field in this task data</source>
        <translation>il n&apos;y a pas de parcelle dans ces données de tâche</translation>
    </message>
    <message>
        <source>there is no gate &apos;%1&apos;</source>
        <translation>il n&apos;y a pas d&apos;entrée de parcelle « %1 »</translation>
    </message>
    <message>
        <source>there is no line in it</source>
        <translation>il ne contient pas de ligne</translation>
    </message>
    <message>
        <source>there is no machine &apos;%1&apos;</source>
        <translation>il n&apos;y a pas de machine « %1 »</translation>
    </message>
    <message>
        <source>there is no path in it</source>
        <translation>il n&apos;y a pas de trajet dedans</translation>
    </message>
    <message>
        <source>there is no project format %1</source>
        <translation>il n&apos;y a pas de format de projet %1</translation>
    </message>
    <message>
        <source>there is no recorded track in it</source>
        <translation>il n&apos;y a pas de trajet enregistré dedans</translation>
    </message>
    <message>
        <source>there is no setting &apos;%1&apos;</source>
        <translation>il n&apos;y a pas de réglage « %1 »</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>ce fichier n&apos;existe pas</translation>
    </message>
    <message>
        <source>there is no swath %1</source>
        <translation>il n&apos;y a pas de passage %1</translation>
    </message>
    <message>
        <source>there is no terminal &apos;%1&apos;</source>
        <translation>il n&apos;y a pas de console « %1 »</translation>
    </message>
    <message>
        <source>there is no track in this GPX file</source>
        <translation>il n&apos;y a pas de trajet dans ce fichier GPX</translation>
    </message>
    <message>
        <source>this XML file is cut off</source>
        <translation>ce fichier XML est coupé</translation>
    </message>
    <message>
        <source>this XML is no task data</source>
        <translation>ce XML ne contient pas de données de tâche</translation>
    </message>
    <message>
        <source>this folder holds no TASKDATA.XML, no field of AgOpenGPS and no AgGPS boundary</source>
        <translation>ce dossier ne contient ni TASKDATA.XML, ni parcelle AgOpenGPS, ni limite AgGPS</translation>
    </message>
    <message>
        <source>this format holds the path of a plan, and there is only a field</source>
        <translation>ce format contient le trajet d&apos;un plan, et il n&apos;y a qu&apos;une parcelle</translation>
    </message>
    <message>
        <source>this is a bag of ROS 1</source>
        <translation>c&apos;est un bag de ROS 1</translation>
    </message>
    <message>
        <source>this is a folder</source>
        <translation>c&apos;est un dossier</translation>
    </message>
    <message>
        <source>this is no MCAP file of version 0</source>
        <translation>ce n&apos;est pas un fichier MCAP de version 0</translation>
    </message>
    <message>
        <source>this is no boundary file that can be read</source>
        <translation>ce n&apos;est pas un fichier de limites lisible</translation>
    </message>
    <message>
        <source>this is no header of a time log</source>
        <translation>ce n&apos;est pas l&apos;en-tête d&apos;un journal</translation>
    </message>
    <message>
        <source>this is no ordinary file</source>
        <translation>ce n&apos;est pas un fichier ordinaire</translation>
    </message>
    <message>
        <source>this is no track that can be read</source>
        <translation>ce n&apos;est pas un trajet lisible</translation>
    </message>
    <message>
        <source>this is no zip of fields or recordings</source>
        <translation>ce n&apos;est pas un zip de parcelles ou d&apos;enregistrements</translation>
    </message>
    <message>
        <source>this is not JSON from here on</source>
        <translation>à partir d&apos;ici ce n&apos;est pas du JSON</translation>
    </message>
    <message>
        <source>this is not XML from here on</source>
        <translation>à partir d&apos;ici ce n&apos;est pas du XML</translation>
    </message>
    <message>
        <source>this is not a project of Furrow</source>
        <translation>ce n&apos;est pas un projet de Furrow</translation>
    </message>
    <message>
        <source>this is not well-known text from here on</source>
        <translation>à partir d&apos;ici ce n&apos;est pas du well-known text</translation>
    </message>
    <message>
        <source>this place</source>
        <translation>cet endroit</translation>
    </message>
    <message>
        <source>this polygon cannot be read</source>
        <translation>ce polygone ne peut pas être lu</translation>
    </message>
    <message>
        <source>this project file is damaged: %1</source>
        <translation>ce fichier de projet est endommagé : %1</translation>
    </message>
    <message>
        <source>this project is open in another window of Furrow</source>
        <translation>ce projet est ouvert dans une autre fenêtre de Furrow</translation>
    </message>
    <message>
        <source>this project was saved by a newer Furrow (format %1, this one knows %2)</source>
        <translation>ce projet a été enregistré par un Furrow plus récent (format %1, celui-ci connaît %2)</translation>
    </message>
    <message>
        <source>topic %1 was left out for %2</source>
        <translation>le topic %1 a été laissé de côté au profit de %2</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true ou false</translation>
    </message>
    <message>
        <source>try another stick</source>
        <translation>essayez une autre clé</translation>
    </message>
    <message>
        <source>turn it into a rosbag2 with rosbags-convert</source>
        <translation>convertissez-le en rosbag2 avec rosbags-convert</translation>
    </message>
    <message>
        <source>two points</source>
        <translation>deux points</translation>
    </message>
    <message>
        <source>use another terminal&apos;s format, and report this</source>
        <translation>utilisez le format d&apos;une autre console, et signalez-le</translation>
    </message>
    <message>
        <source>use one of: %1</source>
        <translation>utilisez l&apos;un de : %1</translation>
    </message>
    <message>
        <source>use one of: %1; or give a machine file (.json)</source>
        <translation>utilisez l&apos;une de : %1 ; ou indiquez un fichier de machine (.json)</translation>
    </message>
    <message>
        <source>use one or more of: %1</source>
        <translation>utilisez un ou plusieurs de : %1</translation>
    </message>
    <message>
        <source>use the numbers from 1 to %1</source>
        <translation>utilisez les numéros de 1 à %1</translation>
    </message>
    <message>
        <source>was it pulled out? Plug it in again and write once more</source>
        <translation>a-t-elle été retirée ? Rebranchez-la et écrivez encore une fois</translation>
    </message>
    <message>
        <source>what is on the stick is not the plan: %1</source>
        <translation>ce qui est sur la clé n&apos;est pas le plan : %1</translation>
    </message>
    <message>
        <source>whole numbers divided by commas</source>
        <translation>des nombres entiers séparés par des virgules</translation>
    </message>
    <message>
        <source>worked pixels need a value other than 0</source>
        <translation>les pixels travaillés doivent avoir une valeur autre que 0</translation>
    </message>
    <message>
        <source>write POLYGON((lon lat, lon lat, ...))</source>
        <translation>écrivez POLYGON((lon lat, lon lat, ...))</translation>
    </message>
    <message>
        <source>write POLYGON((lon lat, lon lat, ...)), one polygon a line</source>
        <translation>écrivez POLYGON((lon lat, lon lat, ...)), un polygone par ligne</translation>
    </message>
    <message>
        <source>write it like LINESTRING (4.1 52.0, 4.2 52.0)</source>
        <translation>écrivez-le comme LINESTRING (4.1 52.0, 4.2 52.0)</translation>
    </message>
    <message>
        <source>write the plan again with furrow-cli plan</source>
        <translation>écrivez à nouveau le plan avec furrow-cli plan</translation>
    </message>
    <message>
        <source>write {&quot;name&quot;: ..., &quot;operating_width_m&quot;: ...}</source>
        <translation>écrivez {&quot;name&quot;: ..., &quot;operating_width_m&quot;: ...}</translation>
    </message>
    <message>
        <source>a part of it cannot be read</source>
        <translation>une partie est illisible</translation>
    </message>
    <message>
        <source>a part of it is damaged: %1</source>
        <translation>une partie est endommagée : %1</translation>
    </message>
    <message>
        <source>a tile is damaged</source>
        <translation>une tuile est endommagée</translation>
    </message>
    <message>
        <source>choose a file or a folder of tiles</source>
        <translation>choisissez un fichier ou un dossier de tuiles</translation>
    </message>
    <message>
        <source>choose the folder that holds the folders of the zooms, 0 to 24</source>
        <translation>choisissez le dossier qui contient les dossiers des niveaux de zoom, 0 à 24</translation>
    </message>
    <message>
        <source>copy or export the file again</source>
        <translation>copiez ou exportez à nouveau le fichier</translation>
    </message>
    <message>
        <source>give a GeoTIFF, MBTiles, or a folder of tiles</source>
        <translation>indiquez un GeoTIFF, un MBTiles ou un dossier de tuiles</translation>
    </message>
    <message>
        <source>give a GeoTIFF, or export it again with its coordinate system</source>
        <translation>indiquez un GeoTIFF ou exportez-la à nouveau avec son système de coordonnées</translation>
    </message>
    <message>
        <source>it is damaged, or not a picture that Furrow can show</source>
        <translation>il est endommagé, ou ce n&apos;est pas une image que Furrow peut afficher</translation>
    </message>
    <message>
        <source>it is no file</source>
        <translation>ce n&apos;est pas un fichier</translation>
    </message>
    <message>
        <source>it is too large to be shown without overviews</source>
        <translation>elle est trop grande pour être affichée sans aperçus</translation>
    </message>
    <message>
        <source>its tiles are in degrees, not in web Mercator</source>
        <translation>ses tuiles sont en degrés, pas en Web Mercator</translation>
    </message>
    <message>
        <source>make the tiles again</source>
        <translation>refaites les tuiles</translation>
    </message>
    <message>
        <source>make them again with the profile mercator, or give the raster itself</source>
        <translation>refaites-les avec le profil mercator ou indiquez le raster lui-même</translation>
    </message>
    <message>
        <source>open it again</source>
        <translation>ouvrez-le à nouveau</translation>
    </message>
    <message>
        <source>put it back, or choose another one</source>
        <translation>remettez-le en place ou choisissez-en un autre</translation>
    </message>
    <message>
        <source>put it back, or remove the layer</source>
        <translation>remettez-le en place ou retirez la couche</translation>
    </message>
    <message>
        <source>save it in tiles and with overviews (gdal_translate -of COG)</source>
        <translation>enregistrez-la en tuiles et avec des aperçus (gdal_translate -of COG)</translation>
    </message>
    <message>
        <source>the file cannot be read any more</source>
        <translation>le fichier n&apos;est plus lisible</translation>
    </message>
    <message>
        <source>the file is not there any more</source>
        <translation>le fichier n&apos;est plus là</translation>
    </message>
    <message>
        <source>the file was changed while it was open</source>
        <translation>le fichier a été modifié pendant qu&apos;il était ouvert</translation>
    </message>
    <message>
        <source>the folder is not there any more</source>
        <translation>le dossier n&apos;est plus là</translation>
    </message>
    <message>
        <source>there are no tiles in this folder</source>
        <translation>il n&apos;y a pas de tuiles dans ce dossier</translation>
    </message>
    <message>
        <source>there is no picture in it</source>
        <translation>il ne contient aucune image</translation>
    </message>
    <message>
        <source>there is no such file or folder</source>
        <translation>ce fichier ou ce dossier n&apos;existe pas</translation>
    </message>
    <message>
        <source>Receivers may refuse %1: %2.</source>
        <translation>Certaines consoles pourraient refuser %1 : %2.</translation>
    </message>
    <message>
        <source>some systems do not allow a file of this name</source>
        <translation>certains systèmes n&apos;admettent pas un fichier de ce nom</translation>
    </message>
    <message>
        <source>another file differs from it in capitals only</source>
        <translation>un autre fichier n&apos;en diffère que par les majuscules</translation>
    </message>
    <message>
        <source>%1 is far from the field</source>
        <translation>%1 est loin de la parcelle</translation>
    </message>
    <message>
        <source>a ring of &apos;%1&apos; has fewer than three corners</source>
        <translation>un contour de « %1 » a moins de trois coins</translation>
    </message>
    <message>
        <source>a ring of &apos;%1&apos; does not end where it begins</source>
        <translation>un contour de « %1 » ne finit pas là où il commence</translation>
    </message>
    <message>
        <source>a ring of &apos;%1&apos; ends with its first point again</source>
        <translation>un contour de « %1 » répète à la fin son premier point</translation>
    </message>
    <message>
        <source>&apos;%1&apos; crosses itself, or a hole lies outside of it</source>
        <translation>« %1 » se croise lui-même, ou une enclave se trouve en dehors</translation>
    </message>
    <message>
        <source>a ring of &apos;%1&apos; runs the wrong way round</source>
        <translation>un contour de « %1 » tourne dans le mauvais sens</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is said to have %2, and has %3</source>
        <translation>« %1 » aurait %2 et a %3</translation>
    </message>
    <message>
        <source>the name &apos;%1&apos; is longer than %2 characters</source>
        <translation>le nom « %1 » a plus de %2 caractères</translation>
    </message>
    <message>
        <source>the name &apos;%1&apos; is there twice</source>
        <translation>le nom « %1 » y est deux fois</translation>
    </message>
    <message>
        <source>the name &apos;%1&apos; has letters beyond A to Z</source>
        <translation>le nom « %1 » a des lettres autres que A à Z</translation>
    </message>
    <message>
        <source>the name &apos;%1&apos; has characters that are no letters</source>
        <translation>le nom « %1 » a des caractères qui ne sont pas des lettres</translation>
    </message>
    <message>
        <source>the line &apos;%1&apos; has fewer than two points</source>
        <translation>la ligne « %1 » a moins de deux points</translation>
    </message>
    <message>
        <source>A and B of &apos;%1&apos; are the same place</source>
        <translation>A et B de « %1 » sont au même endroit</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is said to be %2 wide</source>
        <translation>« %1 » aurait %2 de large</translation>
    </message>
    <message>
        <source>%1 comes where %2 should</source>
        <translation>%1 se trouve où devrait être %2</translation>
    </message>
    <message>
        <source>%1 boundaries are in it, not %2</source>
        <translation>il contient %1 limites de parcelle, et non %2</translation>
    </message>
    <message>
        <source>%1 holes are in it, not %2</source>
        <translation>il contient %1 enclaves, et non %2</translation>
    </message>
    <message>
        <source>%1 guidance lines are in it, not %2</source>
        <translation>il contient %1 lignes de guidage, et non %2</translation>
    </message>
    <message>
        <source>%1 swaths are in it, not %2</source>
        <translation>il contient %1 passages, et non %2</translation>
    </message>
    <message>
        <source>%1 fields are in it, not %2</source>
        <translation>il contient %1 parcelles, et non %2</translation>
    </message>
    <message>
        <source>the path is not in it</source>
        <translation>il ne contient pas le trajet</translation>
    </message>
    <message>
        <source>place %1 of the path is not where the plan goes next</source>
        <translation>le point %1 du trajet n&apos;est pas là où le plan continue</translation>
    </message>
    <message>
        <source>the path does not begin and end as the plan does</source>
        <translation>le trajet ne commence et ne finit pas comme le plan</translation>
    </message>
    <message>
        <source>the path is %1 long, not %2</source>
        <translation>le trajet mesure %1, et non %2</translation>
    </message>
    <message>
        <source>the time of place %1 of the path is before that of the place before</source>
        <translation>l&apos;heure du point %1 du trajet précède celle du point d&apos;avant</translation>
    </message>
    <message>
        <source>the times of the path stand still</source>
        <translation>les heures du trajet n&apos;avancent pas</translation>
    </message>
    <message>
        <source>the heading at place %1 of the path does not point along it</source>
        <translation>le cap au point %1 du trajet ne le suit pas</translation>
    </message>
    <message>
        <source>the speed at place %1 of the path is negative</source>
        <translation>la vitesse au point %1 du trajet est négative</translation>
    </message>
    <message>
        <source>its largest speed is %1, not %2</source>
        <translation>sa plus grande vitesse est %1, et non %2</translation>
    </message>
    <message>
        <source>line %1 is not as this format has it</source>
        <translation>la ligne %1 n&apos;est pas conforme à ce format</translation>
    </message>
    <message>
        <source>this is no %1</source>
        <translation>ce n&apos;est pas un fichier %1</translation>
    </message>
    <message>
        <source>its content cannot be read</source>
        <translation>son contenu ne peut pas être lu</translation>
    </message>
    <message>
        <source>%1 is missing</source>
        <translation>%1 manque</translation>
    </message>
    <message>
        <source>%1 entries are announced, and %2 are there</source>
        <translation>%1 entrées sont annoncées, et il y en a %2</translation>
    </message>
    <message>
        <source>the id %1 is there twice</source>
        <translation>l&apos;identifiant %1 y est deux fois</translation>
    </message>
    <message>
        <source>%1 is referred to and not there</source>
        <translation>il est fait référence à %1, qui n&apos;y est pas</translation>
    </message>
    <message>
        <source>%1 is not known before version 4</source>
        <translation>%1 n&apos;est pas connu avant la version 4</translation>
    </message>
    <message>
        <source>&apos;%1&apos; holds a line of kind %2</source>
        <translation>« %1 » contient une ligne de type %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is of kind %2 and its points are of kinds %3</source>
        <translation>« %1 » est de type %2 et ses points sont des types %3</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has %2 lines</source>
        <translation>« %1 » a %2 lignes</translation>
    </message>
    <message>
        <source>the headings of a ring do not point along it</source>
        <translation>les caps d&apos;un contour ne le suivent pas</translation>
    </message>
    <message>
        <source>its shapes have heights or measures, which displays do not read</source>
        <translation>ses formes ont des altitudes ou des mesures, que les consoles ne lisent pas</translation>
    </message>
    <message>
        <source>this is the recording of a drive (%1), and no boundary</source>
        <translation>c&apos;est l&apos;enregistrement d&apos;un trajet (%1), et non une limite de parcelle</translation>
    </message>
    <message>
        <source>give the field&apos;s boundary; furrow-cli compare lays a recording over a plan</source>
        <translation>indiquez la limite de la parcelle ; furrow-cli compare superpose un enregistrement à un plan</translation>
    </message>
    <message>
        <source>Raster mask</source>
        <translation>Masque matriciel</translation>
    </message>
    <message>
        <source>What is worked and what is not, as a field.</source>
        <translation>Ce qui est travaillé et ce qui ne l&apos;est pas, comme parcelle.</translation>
    </message>
    <message>
        <source>NMEA or gpsd log</source>
        <translation>Journal NMEA ou gpsd</translation>
    </message>
    <message>
        <source>What a machine drove.</source>
        <translation>Ce qu&apos;une machine a parcouru.</translation>
    </message>
    <message>
        <source>split line %1 ends %2 short of the headland and cuts nothing off there (decomposition.split); draw it right through</source>
        <translation>la ligne de partage %1 s&apos;arrête %2 avant la fourrière et n&apos;y découpe rien (decomposition.split) ; tracez-la de part en part</translation>
    </message>
    <message>
        <source>split line %1 does not lie inside the headland and cuts nothing (decomposition.split)</source>
        <translation>la ligne de partage %1 est hors du plein champ et ne découpe rien (decomposition.split)</translation>
    </message>
    <message numerus="yes">
        <source>%n swaths shorter than %1 are left out</source>
        <translation>
            <numerusform>%n passage de moins de %1 est laissé de côté</numerusform>
            <numerusform>%n passages de moins de %1 sont laissés de côté</numerusform>
        </translation>
    </message>
    <message>
        <source>along the longest edge</source>
        <translation>le long du plus long côté</translation>
    </message>
    <message>
        <source>along an edge</source>
        <translation>le long d&apos;un côté</translation>
    </message>
    <message>
        <source>swaths run %1</source>
        <translation>les passages vont %1</translation>
    </message>
    <message>
        <source>swaths run %1; about %2 slower than with the best heading</source>
        <translation>les passages vont %1 ; environ %2 de plus qu&apos;avec la meilleure orientation</translation>
    </message>
    <message>
        <source>swaths run %1; as quick as with the best heading</source>
        <translation>les passages vont %1 ; aussi rapide qu&apos;avec la meilleure orientation</translation>
    </message>
    <message>
        <source>swaths run %1; %2 more than with the best heading</source>
        <translation>les passages vont %1 ; %2 de plus qu&apos;avec la meilleure orientation</translation>
    </message>
    <message>
        <source>swaths run %1; as short as with the best heading</source>
        <translation>les passages vont %1 ; aussi court qu&apos;avec la meilleure orientation</translation>
    </message>
    <message>
        <source>Shortest swath</source>
        <translation>Passage le plus court</translation>
    </message>
    <message>
        <source>Swaths that are shorter are left out; auto is the implement&apos;s length.</source>
        <translation>Les passages plus courts sont laissés de côté ; auto : la longueur de l&apos;outil.</translation>
    </message>
    <message>
        <source>Prefer edges within (%)</source>
        <translation>Préférer les côtés jusqu&apos;à (%)</translation>
    </message>
    <message>
        <source>Swaths run along the field&apos;s longest edge, or another long one, where that takes no more than this above the best heading; 0 takes the best whatever its direction.</source>
        <translation>Les passages suivent le plus long côté de la parcelle, ou un autre long côté, tant que cela ne dépasse pas la meilleure orientation de plus que cette valeur ; 0 prend la meilleure, quelle qu&apos;elle soit.</translation>
    </message>
    <message>
        <source>%1 are out of this machine&apos;s reach; the largest piece, %2, lies here.</source>
        <translation>%1 sont hors de portée de cette machine ; le plus grand morceau, %2, se trouve ici.</translation>
    </message>
    <message>
        <source>The implement stands over the edge of the field or an obstacle, by up to %1, as the overhang allows.</source>
        <translation>L&apos;outil déborde de la parcelle ou au-dessus d&apos;un obstacle, jusqu&apos;à %1, comme le débord le permet.</translation>
    </message>
    <message>
        <source>%1 within %2 of the centre: tighter than this machine can follow, left out</source>
        <translation>%1 à moins de %2 du centre : plus serrés que ce que cette machine peut suivre, omis</translation>
    </message>
    <message numerus="yes">
        <source>%n circles</source>
        <translation>
            <numerusform>%n cercle</numerusform>
            <numerusform>%n cercles</numerusform>
        </translation>
    </message>
    <message>
        <source>A headland of %1 holds %2; it is %3 wide, and the rest belongs to the swaths</source>
        <translation>Une fourrière de %1 contient %2 ; elle a %3 de large, le reste revient aux passages</translation>
    </message>
    <message>
        <source>Plan the sides of the obstacle apart.</source>
        <translation>Planifiez séparément les côtés de l&apos;obstacle.</translation>
    </message>
    <message>
        <source>Set &quot;%1&quot; to &quot;%2&quot;: with that this is gone.</source>
        <translation>Réglez « %1 » sur « %2 » : cela règle ce point.</translation>
    </message>
    <message>
        <source>Swaths along the longest edge</source>
        <translation>Les passages le long du plus long côté</translation>
    </message>
    <message>
        <source>Swaths at a bearing of %1</source>
        <translation>Les passages au cap %1</translation>
    </message>
    <message>
        <source>Take a machine that can.</source>
        <translation>Prenez une machine qui le peut.</translation>
    </message>
    <message>
        <source>The field is too narrow for this machine to turn in: take a smaller machine.</source>
        <translation>La parcelle est trop étroite pour tourner avec cette machine : prenez une machine plus petite.</translation>
    </message>
    <message>
        <source>The quickest</source>
        <translation>Le plus rapide</translation>
    </message>
    <message>
        <source>give one of the two, or a width that holds just these passes</source>
        <translation>indiquez l&apos;un des deux, ou une largeur qui contient juste ces tours</translation>
    </message>
    <message>
        <source>headland.width_m and headland.passes do not agree</source>
        <translation>headland.width_m et headland.passes ne concordent pas</translation>
    </message>
    <message>
        <source>off</source>
        <translation>désactivé</translation>
    </message>
    <message>
        <source>on</source>
        <translation>activé</translation>
    </message>
    <message>
        <source>&quot;%1&quot;: &quot;%2&quot; is planned instead of &quot;%3&quot;: %4</source>
        <translation>« %1 » : « %2 » est planifié au lieu de « %3 » : %4</translation>
    </message>
    <message>
        <source>%1 are planned instead of the heading with the best estimate: %2</source>
        <translation>%1 sont planifiés au lieu de l&apos;orientation la mieux estimée : %2</translation>
    </message>
    <message>
        <source>it has fewer problems</source>
        <translation>il y a moins de problèmes</translation>
    </message>
    <message>
        <source>it is %1 quicker</source>
        <translation>c&apos;est plus rapide de %1</translation>
    </message>
    <message>
        <source>the margin and the obstacles that may be driven on leave nothing to work</source>
        <translation>la marge et les obstacles franchissables ne laissent rien à travailler</translation>
    </message>
    <message>
        <source>make them smaller, or delete some of them</source>
        <translation>réduisez-les ou supprimez-en quelques-uns</translation>
    </message>
    <message>
        <source>Without a headland (%1) there is no room to turn.</source>
        <translation>Sans fourrière (%1), il n&apos;y a pas la place de tourner.</translation>
    </message>
    <message>
        <source>A turn of this machine needs %1 of headland; it is %2 (%3).</source>
        <translation>Un demi-tour de cette machine demande %1 de fourrière ; il y en a %2 (%3).</translation>
    </message>
    <message>
        <source>The field is too narrow for this machine to turn in: take a smaller machine, or let the swaths run along the field (%1).</source>
        <translation>La parcelle est trop étroite pour tourner avec cette machine : prenez une machine plus petite, ou orientez les passages dans la longueur de la parcelle (%1).</translation>
    </message>
    <message>
        <source>The field is too narrow for this machine to turn in: take a smaller machine or a smaller margin (%1).</source>
        <translation>La parcelle est trop étroite pour tourner avec cette machine : prenez une machine plus petite ou une marge plus petite (%1).</translation>
    </message>
    <message>
        <source>No passes are driven in the headland (%1).</source>
        <translation>Aucun tour n&apos;est fait dans la fourrière (%1).</translation>
    </message>
    <message>
        <source>The chosen swaths (%1) do not reach it.</source>
        <translation>Les passages choisis (%1) n&apos;y arrivent pas.</translation>
    </message>
    <message>
        <source>Land that is left is not finished if the machine may leave the field (%1).</source>
        <translation>Là où la machine peut sortir de la parcelle (%1), les restes ne sont pas repris.</translation>
    </message>
    <message>
        <source>Land that is left is not finished, because that is switched off (%1).</source>
        <translation>Les restes ne sont pas repris, car c&apos;est désactivé (%1).</translation>
    </message>
    <message>
        <source>choose a smaller machine or a smaller margin (%1)</source>
        <translation>choisissez une machine plus petite ou une marge plus petite (%1)</translation>
    </message>
    <message>
        <source>no row is left inside the headland</source>
        <translation>il ne reste aucun rang dans le plein champ</translation>
    </message>
    <message>
        <source>skip fewer rows</source>
        <translation>sautez moins de rangs</translation>
    </message>
    <message>
        <source>no row lies inside the headland</source>
        <translation>aucun rang ne se trouve dans le plein champ</translation>
    </message>
    <message>
        <source>check that the rows belong to this field, or choose a narrower headland</source>
        <translation>vérifiez que les rangs appartiennent à cette parcelle, ou choisissez une fourrière plus étroite</translation>
    </message>
    <message>
        <source>Quickest</source>
        <translation>Le plus rapide</translation>
    </message>
    <message>
        <source>The kind below with which the whole plan takes the least time.</source>
        <translation>Le type avec lequel le plan entier prend le moins de temps.</translation>
    </message>
    <message>
        <source>A headland of %1 is planned instead of one that is wide enough for turns: %2</source>
        <translation>Une fourrière de %1 est planifiée au lieu d&apos;une fourrière assez large pour tourner : %2</translation>
    </message>
    <message>
        <source>Drive more slowly there, or plan again.</source>
        <translation>Conduisez-y plus lentement ou planifiez à nouveau.</translation>
    </message>
    <message>
        <source>The steering is too slow for the planned speed in %1; %2 is the worst and would need %3.</source>
        <translation>Le braquage est trop lent pour la vitesse prévue à %1 ; le pire est %2, qui demanderait %3.</translation>
    </message>
    <message>
        <source>The implement is folded on the way from %1 to %2.</source>
        <translation>L&apos;outil est replié sur ce déplacement : %1 → %2.</translation>
    </message>
    <message>
        <source>The machine has to stand for %1 s to fold its implement or to unfold it, and does not in %2.</source>
        <translation>La machine doit rester à l&apos;arrêt %1 s pour replier ou déplier son outil ; elle ne le fait pas à %2.</translation>
    </message>
    <message>
        <source>Time to fold</source>
        <translation>Temps de repliage</translation>
    </message>
    <message>
        <source>To fold to the transport width, standing; the same again to unfold.</source>
        <translation>Pour replier à la largeur de transport, à l&apos;arrêt ; autant pour déplier.</translation>
    </message>
    <message>
        <source>Fuel</source>
        <translation>Carburant</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longueur</translation>
    </message>
    <message>
        <source>Saves</source>
        <translation>Économise</translation>
    </message>
    <message>
        <source>The least fuel for turns and ways; the least time if the machine has no fuel figures.</source>
        <translation>Le moins de carburant pour les demi-tours et les déplacements ; le moins de temps si la machine n&apos;a pas de valeurs de consommation.</translation>
    </message>
    <message>
        <source>The least time for turns and ways.</source>
        <translation>Le moins de temps pour les demi-tours et les déplacements.</translation>
    </message>
    <message>
        <source>The shortest turns and ways.</source>
        <translation>Les demi-tours et déplacements les plus courts.</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>What the order of the swaths is to save.</source>
        <translation>Ce que l&apos;ordre des passages doit économiser.</translation>
    </message>
    <message>
        <source>Every pattern is tried and improved; the plan tells how near the order is to the best one.</source>
        <translation>Tous les schémas sont essayés et améliorés ; le plan dit à quel point l&apos;ordre est proche du meilleur.</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>Verrouillés</translation>
    </message>
    <message>
        <source>Swath numbers that follow each other in this order; a minus drives one the other way. The order of the others is searched.</source>
        <translation>Numéros de passages qui se suivent dans cet ordre ; un signe moins inverse le sens. L&apos;ordre des autres est cherché.</translation>
    </message>
    <message>
        <source>Ends of swaths</source>
        <translation>Bouts des passages</translation>
    </message>
    <message>
        <source>Heading of blocks</source>
        <translation>Orientation des sous-parcelles</translation>
    </message>
    <message>
        <source>Heading: bearing %1</source>
        <translation>Orientation : %1</translation>
    </message>
    <message>
        <source>Headland passes</source>
        <translation>Tours de fourrière</translation>
    </message>
    <message>
        <source>Order of swaths</source>
        <translation>Ordre des passages</translation>
    </message>
    <message>
        <source>Small obstacles</source>
        <translation>Petits obstacles</translation>
    </message>
    <message>
        <source>First swath</source>
        <translation>Premier passage</translation>
    </message>
    <message>
        <source>Last swath</source>
        <translation>Dernier passage</translation>
    </message>
    <message>
        <source>Most strips that are left between driven swaths for later. With 0 the machine never comes back to a gap, so that a second one can follow; auto sets no limit.</source>
        <translation>Nombre maximal de bandes laissées pour plus tard entre des passages faits. Avec 0, la machine ne revient jamais dans un vide, et une autre peut la suivre ; « auto » ne met pas de limite.</translation>
    </message>
    <message>
        <source>Open strips</source>
        <translation>Bandes ouvertes</translation>
    </message>
    <message>
        <source>The number of the swath that is driven first; auto takes any.</source>
        <translation>Le numéro du passage fait en premier ; « auto » laisse le choix libre.</translation>
    </message>
    <message>
        <source>The number of the swath that is driven last; auto takes any.</source>
        <translation>Le numéro du passage fait en dernier ; « auto » laisse le choix libre.</translation>
    </message>
    <message>
        <source>allow more open strips, or lock fewer swaths</source>
        <translation>autorisez plus de bandes ouvertes, ou verrouillez moins de passages</translation>
    </message>
    <message>
        <source>name another swath for the end</source>
        <translation>indiquez un autre passage pour la fin</translation>
    </message>
    <message>
        <source>no order was found that keeps to all that is said of the order of swaths</source>
        <translation>aucun ordre trouvé ne respecte tout ce qui est dit de l&apos;ordre des passages</translation>
    </message>
    <message>
        <source>swath %1 is driven first</source>
        <translation>le passage %1 est fait en premier</translation>
    </message>
    <message>
        <source>%1 are driven outside of the field</source>
        <translation>%1 sont parcourus hors de la parcelle</translation>
    </message>
    <message>
        <source>%1 costs %2 more than the longest edge (%3)</source>
        <translation>%1 coûte %2 de plus que le plus long côté (%3)</translation>
    </message>
    <message>
        <source>%1 h %2 min</source>
        <translation>%1 h %2 min</translation>
    </message>
    <message>
        <source>%1 is as quick as the longest edge (%2)</source>
        <translation>%1 est aussi rapide que le plus long côté (%2)</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>%1 of a work order is no amount</source>
        <translation>%1 d&apos;un ordre de travail n&apos;est pas une quantité</translation>
    </message>
    <message>
        <source>%1 of a work order is no text</source>
        <translation>%1 d&apos;un ordre de travail n&apos;est pas un texte</translation>
    </message>
    <message>
        <source>%1 runs along the longest edge</source>
        <translation>%1 longe le plus long côté</translation>
    </message>
    <message>
        <source>%1 saves %2 against the longest edge (%3)</source>
        <translation>%1 fait gagner %2 par rapport au plus long côté (%3)</translation>
    </message>
    <message>
        <source>%1 × %2, %3 each</source>
        <translation>%1 × %2, %3 chacun</translation>
    </message>
    <message>
        <source>%1: a turn of this machine, with a radius of %2, needs %3.</source>
        <translation>%1 : un demi-tour de cette machine, avec un rayon de %2, demande %3.</translation>
    </message>
    <message>
        <source>%1: a turn to the next swath would need %2, so turns are made in other ways.</source>
        <translation>%1 : un demi-tour vers le passage suivant demanderait %2, on tourne donc autrement.</translation>
    </message>
    <message>
        <source>%1: its work order is not used: %2</source>
        <translation>%1 : son ordre de travail n&apos;est pas utilisé : %2</translation>
    </message>
    <message>
        <source>%1: the field is too narrow for the %2 that a turn of this machine needs.</source>
        <translation>%1 : la parcelle est trop étroite pour les %2 que demande un demi-tour de cette machine.</translation>
    </message>
    <message>
        <source>%1; the machine keeps %2 from its edge at least.</source>
        <translation>%1 ; la machine reste au moins à %2 du bord.</translation>
    </message>
    <message numerus="yes">
        <source>%n blocks</source>
        <translation>
            <numerusform>%n sous-parcelle</numerusform>
            <numerusform>%n sous-parcelles</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n passes of %1</source>
        <translation>
            <numerusform>%n tour de %1</numerusform>
            <numerusform>%n tours de %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n swaths</source>
        <translation>
            <numerusform>%n passage</numerusform>
            <numerusform>%n passages</numerusform>
        </translation>
    </message>
    <message>
        <source>Cut into %1 pieces where swaths are interrupted, joined to %2.</source>
        <translation>Coupé en %1 morceaux là où les passages s&apos;interrompent, réunis en %2.</translation>
    </message>
    <message>
        <source>Cut into %1 pieces where swaths are interrupted; joining them to %2 saves %3 of turns and ways.</source>
        <translation>Coupé en %1 morceaux là où les passages s&apos;interrompent ; les réunir en %2 fait gagner %3 de demi-tours et de déplacements.</translation>
    </message>
    <message>
        <source>Edges that swaths run along get %1, edges that they end at up to %2: a turn of this machine needs %3.</source>
        <translation>Les côtés longés par les passages reçoivent %1, ceux où ils finissent jusqu&apos;à %2 : un demi-tour de cette machine demande %3.</translation>
    </message>
    <message>
        <source>Everything keeps %1 from the boundary, as chosen.</source>
        <translation>Tout reste à %1 de la limite, comme choisi.</translation>
    </message>
    <message>
        <source>Everything keeps %1 from the boundary: no more is known of where it runs.</source>
        <translation>Tout reste à %1 de la limite : on n&apos;en connaît pas mieux le tracé.</translation>
    </message>
    <message numerus="yes">
        <source>No heading has fewer than %n swaths.</source>
        <translation>
            <numerusform>Aucune orientation n&apos;a moins de %n passage.</numerusform>
            <numerusform>Aucune orientation n&apos;a moins de %n passages.</numerusform>
        </translation>
    </message>
    <message>
        <source>No heading that was tried covers more: %1 inside the headland.</source>
        <translation>Aucune orientation essayée ne travaille plus de surface : %1 du plein champ.</translation>
    </message>
    <message numerus="yes">
        <source>No heading that was tried has fewer than %n swaths.</source>
        <translation>
            <numerusform>Aucune orientation essayée n&apos;a moins de %n passage.</numerusform>
            <numerusform>Aucune orientation essayée n&apos;a moins de %n passages.</numerusform>
        </translation>
    </message>
    <message>
        <source>No heading that was tried has shorter swaths: %1.</source>
        <translation>Aucune orientation essayée n&apos;a des passages plus courts : %1.</translation>
    </message>
    <message>
        <source>No heading that was tried works less land twice: %1.</source>
        <translation>Aucune orientation essayée ne travaille moins de surface deux fois : %1.</translation>
    </message>
    <message>
        <source>No order of these swaths can save more than %1 of the turns, or %2 of all.</source>
        <translation>Aucun ordre de ces passages ne peut faire gagner plus de %1 des demi-tours, ou %2 du total.</translation>
    </message>
    <message>
        <source>No order of these swaths is better; that is proved.</source>
        <translation>Aucun ordre de ces passages n&apos;est meilleur ; c&apos;est prouvé.</translation>
    </message>
    <message>
        <source>Nothing divides the swaths: one block.</source>
        <translation>Rien ne coupe les passages : une seule sous-parcelle.</translation>
    </message>
    <message>
        <source>Nothing stands outside of the field</source>
        <translation>Rien ne sort de la parcelle</translation>
    </message>
    <message>
        <source>One pass all round works the whole field.</source>
        <translation>Un seul tour travaille toute la parcelle.</translation>
    </message>
    <message numerus="yes">
        <source>Swaths are interrupted by corners or obstacles: %n blocks.</source>
        <translation>
            <numerusform>Des coins ou des obstacles interrompent les passages : %n sous-parcelle.</numerusform>
            <numerusform>Des coins ou des obstacles interrompent les passages : %n sous-parcelles.</numerusform>
        </translation>
    </message>
    <message>
        <source>The longest way without work, %1, follows %2.</source>
        <translation>Le plus long déplacement sans travail, %1, suit %2.</translation>
    </message>
    <message>
        <source>There is no headland, as chosen. Turns reach %1 beyond the ends of swaths.</source>
        <translation>Pas de fourrière, comme choisi. Les demi-tours dépassent de %1 le bout des passages.</translation>
    </message>
    <message>
        <source>Turns take %1 less than with the pattern “%2” (%3).</source>
        <translation>Les demi-tours coûtent %1 de moins qu&apos;avec le schéma « %2 » (%3).</translation>
    </message>
    <message>
        <source>Turns take %1 more than with the pattern “%2” (%3).</source>
        <translation>Les demi-tours coûtent %1 de plus qu&apos;avec le schéma « %2 » (%3).</translation>
    </message>
    <message>
        <source>Turns take about as much as with the pattern “%1”.</source>
        <translation>Les demi-tours coûtent à peu près autant qu&apos;avec le schéma « %1 ».</translation>
    </message>
    <message>
        <source>a member that every plan has is missing or of another kind</source>
        <translation>il manque un élément que tout plan possède, ou il est d&apos;un autre type</translation>
    </message>
    <message>
        <source>a work order is a JSON object, and this is none</source>
        <translation>un ordre de travail est un objet JSON, et ceci n&apos;en est pas un</translation>
    </message>
    <message>
        <source>bulb turn</source>
        <translation>demi-tour en oméga</translation>
    </message>
    <message>
        <source>by this estimate %1 would save %2</source>
        <translation>selon cette estimation, %1 ferait gagner %2</translation>
    </message>
    <message>
        <source>fishtail turn</source>
        <translation>demi-tour en queue de poisson</translation>
    </message>
    <message>
        <source>give a number that is not negative, or leave it out</source>
        <translation>donnez un nombre non négatif, ou ne le mettez pas</translation>
    </message>
    <message>
        <source>it is draft, issued, in_progress or done</source>
        <translation>c&apos;est draft, issued, in_progress ou done</translation>
    </message>
    <message>
        <source>no heading is much quicker</source>
        <translation>aucune orientation n&apos;est nettement plus rapide</translation>
    </message>
    <message>
        <source>no heading is quicker</source>
        <translation>aucune orientation n&apos;est plus rapide</translation>
    </message>
    <message>
        <source>no plan of this project was sent for this review</source>
        <translation>aucun plan de ce projet n&apos;a été envoyé pour cette relecture</translation>
    </message>
    <message>
        <source>open the project that the plan was sent from, or open the file by itself</source>
        <translation>ouvrez le projet d&apos;où vient le plan, ou le fichier seul</translation>
    </message>
    <message>
        <source>put it in quotation marks</source>
        <translation>mettez-le entre guillemets</translation>
    </message>
    <message>
        <source>see the README for the members of a work order</source>
        <translation>voir dans le README les données d&apos;un ordre de travail</translation>
    </message>
    <message>
        <source>there is no such status of a work order</source>
        <translation>cet état d&apos;ordre de travail n&apos;existe pas</translation>
    </message>
    <message>
        <source>there is no way to drive</source>
        <translation>il n&apos;y a aucun chemin possible</translation>
    </message>
    <message>
        <source>turn on the spot</source>
        <translation>demi-tour sur place</translation>
    </message>
    <message>
        <source>turn with reversing</source>
        <translation>demi-tour avec marche arrière</translation>
    </message>
    <message>
        <source>way straight on</source>
        <translation>déplacement tout droit</translation>
    </message>
    <message>
        <source>%1 are driven over the field with the implement up; longest: %2.</source>
        <translation>%1 sont parcourus sur la parcelle outil relevé ; le plus long : %2.</translation>
    </message>
    <message>
        <source>%1 for each swath gives %2 swaths, and no plan may have more than %3</source>
        <translation>%1 par passage donnent %2 passages, et aucun plan ne peut en avoir plus de %3</translation>
    </message>
    <message>
        <source>%1 is beyond what machines have</source>
        <translation>%1 dépasse ce qu&apos;ont les machines</translation>
    </message>
    <message>
        <source>&apos;%1&apos; in it is a view</source>
        <translation>« %1 » y est une vue</translation>
    </message>
    <message>
        <source>a text with fields may take %1 MiB, and this one takes more</source>
        <translation>un texte avec des parcelles peut occuper %1 Mio, et celui-ci en occupe plus</translation>
    </message>
    <message>
        <source>a value in it is not of the kind that belongs there</source>
        <translation>une valeur n&apos;est pas du type attendu à cet endroit</translation>
    </message>
    <message>
        <source>correct one of them, or give min_turning_radius_m</source>
        <translation>corrigez l&apos;un des deux ou indiquez min_turning_radius_m</translation>
    </message>
    <message>
        <source>cut it into parts, or export it as a GeoPackage</source>
        <translation>découpez-le, ou exportez-le en GeoPackage</translation>
    </message>
    <message>
        <source>did you mean %1?</source>
        <translation>vouliez-vous dire %1 ?</translation>
    </message>
    <message>
        <source>export it as a table, or remove it</source>
        <translation>exportez-la comme table, ou retirez-la</translation>
    </message>
    <message>
        <source>it would grow more than three hundredfold when it is unpacked</source>
        <translation>il grossirait plus de trois cents fois à la décompression</translation>
    </message>
    <message>
        <source>it would take more than 2 GiB when it is unpacked</source>
        <translation>décompressé, il prendrait plus de 2 Gio</translation>
    </message>
    <message>
        <source>lists and objects lie too deep in one another here</source>
        <translation>des listes et des objets sont imbriqués trop profondément ici</translation>
    </message>
    <message>
        <source>remove what does not belong there</source>
        <translation>retirez ce qui n&apos;a pas sa place ici</translation>
    </message>
    <message>
        <source>the file is far too large for what it should hold</source>
        <translation>le fichier est bien trop grand pour ce qu&apos;il devrait contenir</translation>
    </message>
    <message>
        <source>unpack it and give one of its files</source>
        <translation>décompressez-le et indiquez l&apos;un de ses fichiers</translation>
    </message>
    <message>
        <source>with this wheelbase, %1 give a turning radius of %2</source>
        <translation>avec cet empattement, %1 donnent un rayon de braquage de %2</translation>
    </message>
    <message>
        <source>%1 is no number (%2), and nothing is written</source>
        <translation>%1 n&apos;est pas un nombre (%2), et rien n&apos;est écrit</translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <translation>%1 : %2</translation>
    </message>
    <message>
        <source>%1: %2 (%3); the plan is made with %4 until then</source>
        <translation>%1 : %2 (%3) ; d&apos;ici là, le plan est fait avec %4</translation>
    </message>
    <message>
        <source>a place</source>
        <translation>un point</translation>
    </message>
    <message>
        <source>a place of a guidance line</source>
        <translation>un point d&apos;une ligne de guidage</translation>
    </message>
    <message>
        <source>a place of an obstacle</source>
        <translation>un point d&apos;un obstacle</translation>
    </message>
    <message>
        <source>a place of swath %1</source>
        <translation>un point du passage %1</translation>
    </message>
    <message>
        <source>a place of the boundary</source>
        <translation>un point du contour</translation>
    </message>
    <message>
        <source>a place of the mainland</source>
        <translation>un point de l&apos;intérieur</translation>
    </message>
    <message>
        <source>give one beside it, in WGS84, longitude first</source>
        <translation>indiquez-en une à côté, en WGS84, longitude d&apos;abord</translation>
    </message>
    <message>
        <source>plan parts of the field by themselves, choose another heading, or take small obstacles out of the boundary</source>
        <translation>planifiez des parties de la parcelle séparément, choisissez une autre direction ou retirez les petits obstacles du contour</translation>
    </message>
    <message>
        <source>the area of the field</source>
        <translation>la surface de la parcelle</translation>
    </message>
    <message>
        <source>the bearing of a guidance line</source>
        <translation>le cap d&apos;une ligne de guidage</translation>
    </message>
    <message>
        <source>the buffer of an obstacle</source>
        <translation>la marge autour d&apos;un obstacle</translation>
    </message>
    <message>
        <source>the coverage of the swaths</source>
        <translation>la part que travaillent les passages</translation>
    </message>
    <message>
        <source>the curvature</source>
        <translation>la courbure</translation>
    </message>
    <message>
        <source>the curve is %1 km away from the field</source>
        <translation>la courbe est à %1 km de la parcelle</translation>
    </message>
    <message>
        <source>the heading</source>
        <translation>la direction</translation>
    </message>
    <message>
        <source>the outline cuts the tracks into %1 swaths, and no plan may have more than %2</source>
        <translation>le contour coupe les voies en %1 passages, et aucun plan ne peut en avoir plus de %2</translation>
    </message>
    <message>
        <source>the overhang of an obstacle</source>
        <translation>le porte-à-faux au-dessus d&apos;un obstacle</translation>
    </message>
    <message>
        <source>the overlap of the swaths</source>
        <translation>le recouvrement des passages</translation>
    </message>
    <message>
        <source>the place of a finding</source>
        <translation>le point d&apos;une remarque</translation>
    </message>
    <message>
        <source>the place of a gate</source>
        <translation>le point d&apos;une entrée</translation>
    </message>
    <message>
        <source>the radius of a guidance line</source>
        <translation>le rayon d&apos;une ligne de guidage</translation>
    </message>
    <message>
        <source>the share of the mainland</source>
        <translation>la part de l&apos;intérieur</translation>
    </message>
    <message>
        <source>the speed</source>
        <translation>la vitesse</translation>
    </message>
    <message>
        <source>the time</source>
        <translation>le temps</translation>
    </message>
    <message>
        <source>the way driven</source>
        <translation>le chemin parcouru</translation>
    </message>
    <message>
        <source>the width of a gate</source>
        <translation>la largeur d&apos;une entrée</translation>
    </message>
    <message>
        <source>the width of a guidance line</source>
        <translation>la largeur d&apos;une ligne de guidage</translation>
    </message>
    <message>
        <source>the width of the headland</source>
        <translation>la largeur de la fourrière</translation>
    </message>
    <message>
        <source>this is a mistake of Furrow, please report it with the field, the machine and the settings</source>
        <translation>c&apos;est une erreur de Furrow ; signalez-la avec la parcelle, la machine et les réglages</translation>
    </message>
    <message>
        <source>%1 %2 is no place in WGS84</source>
        <translation>%1 %2 n&apos;est pas un endroit en WGS84</translation>
    </message>
    <message>
        <source>%1 gathers %2; the bunker holds %3.</source>
        <translation>%1 récolte %2 ; la trémie contient %3.</translation>
    </message>
    <message>
        <source>%1 of standing</source>
        <translation>%1 d&apos;arrêt</translation>
    </message>
    <message>
        <source>%1 takes %2; the tank holds %3.</source>
        <translation>%1 demande %2 ; la cuve contient %3.</translation>
    </message>
    <message numerus="yes">
        <source>%n passes are too long for it.</source>
        <translation>
            <numerusform>%n passage est trop long.</numerusform>
            <numerusform>%n passages sont trop longs.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n refills, with %1 of way to them and back and %2.</source>
        <translation>
            <numerusform>Un remplissage, avec %1 de chemin aller et retour et %2.</numerusform>
            <numerusform>%n remplissages, avec %1 de chemin aller et retour et %2.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n unloadings, with %1 of way to them and back and %2.</source>
        <translation>
            <numerusform>Une vidange, avec %1 de chemin aller et retour et %2.</numerusform>
            <numerusform>%n vidanges, avec %1 de chemin aller et retour et %2.</numerusform>
        </translation>
    </message>
    <message>
        <source>Choose another refill point.</source>
        <translation>Choisissez un autre point de remplissage.</translation>
    </message>
    <message>
        <source>Give more refill points, or ones that are nearer.</source>
        <translation>Indiquez plus de points de remplissage, ou de plus proches.</translation>
    </message>
    <message>
        <source>Let ways cross the mainland (route.traversal), so that swaths may be interrupted, or lay the swaths the short way.</source>
        <translation>Laissez les chemins traverser le plein champ (route.traversal), pour que les passages puissent être interrompus, ou tracez-les dans le sens court.</translation>
    </message>
    <message>
        <source>No trip to a refill point is needed: %1 of the %2 that the bunker holds are gathered.</source>
        <translation>Aucun trajet vers un point de vidange n&apos;est nécessaire : %1 des %2 de la trémie sont récoltés.</translation>
    </message>
    <message>
        <source>No trip to a refill point is needed: %1 of the %2 that the tank holds are used.</source>
        <translation>Aucun trajet vers un point de remplissage n&apos;est nécessaire : %1 des %2 de la cuve sont utilisés.</translation>
    </message>
    <message>
        <source>No way to a refill point leads from the work before %1.</source>
        <translation>Aucun chemin ne mène à un point de remplissage depuis le travail avant %1.</translation>
    </message>
    <message>
        <source>POINT (%1 %2) lies outside of the field</source>
        <translation>POINT (%1 %2) est hors de la parcelle</translation>
    </message>
    <message>
        <source>Plan again; the levels were changed.</source>
        <translation>Planifiez à nouveau ; les niveaux ont été modifiés.</translation>
    </message>
    <message>
        <source>Refill points</source>
        <translation>Points de remplissage</translation>
    </message>
    <message>
        <source>That the machine stands each time its tank is filled or its bunker emptied; 300 s where it is not given.</source>
        <translation>Durée d&apos;arrêt de la machine chaque fois que la cuve est remplie ou la trémie vidée ; 300 s si rien n&apos;est indiqué.</translation>
    </message>
    <message>
        <source>The bunker is full in %1: %2 are worked beyond that.</source>
        <translation>La trémie est pleine (%1) : %2 sont travaillés au-delà.</translation>
    </message>
    <message>
        <source>The level changes %1 away from the refill points.</source>
        <translation>Le niveau change à %1 des points de remplissage.</translation>
    </message>
    <message>
        <source>The machine has no room at this refill point.</source>
        <translation>La machine n&apos;a pas de place à ce point de remplissage.</translation>
    </message>
    <message>
        <source>The machine has to stand for %1 s at a refill point, and does not in %2.</source>
        <translation>La machine doit rester %1 s à un point de remplissage et ne le fait pas : %2.</translation>
    </message>
    <message>
        <source>The refill points are not used: this machine has no tank.</source>
        <translation>Les points de remplissage ne servent pas : cette machine n&apos;a pas de cuve.</translation>
    </message>
    <message>
        <source>The refill points are not used: this machine&apos;s tank has no rate.</source>
        <translation>Les points de remplissage ne servent pas : la cuve de cette machine n&apos;a pas de dose.</translation>
    </message>
    <message>
        <source>The refill points are not used: this operation uses no tank.</source>
        <translation>Les points de remplissage ne servent pas : ce travail n&apos;utilise pas de cuve.</translation>
    </message>
    <message>
        <source>The stated level differs from the work that is done, by up to %1 of the tank.</source>
        <translation>Le niveau indiqué diffère du travail fait, jusqu&apos;à %1 de la cuve.</translation>
    </message>
    <message>
        <source>The tank is empty in %1: %2 are worked beyond that.</source>
        <translation>La cuve est vide (%1) : %2 sont travaillés au-delà.</translation>
    </message>
    <message>
        <source>Time to fill</source>
        <translation>Temps de remplissage</translation>
    </message>
    <message>
        <source>Where the tank is filled or the bunker emptied: points or names of gates, divided by semicolons.</source>
        <translation>Où la cuve est remplie ou la trémie vidée : des points ou des noms d&apos;entrées, séparés par des points-virgules.</translation>
    </message>
    <message>
        <source>give longitude, then latitude, in degrees</source>
        <translation>indiquez la longitude, puis la latitude, en degrés</translation>
    </message>
    <message>
        <source>names of gates or points in WGS84 such as MULTIPOINT ((4.1 52.0), (4.2 52.0))</source>
        <translation>des noms d&apos;entrées ou des points en WGS84 comme MULTIPOINT ((4.1 52.0), (4.2 52.0))</translation>
    </message>
    <message>
        <source>Always</source>
        <translation>Toujours</translation>
    </message>
    <message>
        <source>The quickest of them is taken.</source>
        <translation>Le plus rapide est retenu.</translation>
    </message>
    <message>
        <source>Only where the first one cannot be driven</source>
        <translation>Seulement si le premier n&apos;est pas réalisable</translation>
    </message>
    <message>
        <source>Planning is several times quicker, and the work takes some percent longer.</source>
        <translation>La planification est plusieurs fois plus rapide, et le travail dure quelques pour cent de plus.</translation>
    </message>
    <message>
        <source>Compare plans</source>
        <translation>Comparer des plans</translation>
    </message>
    <message>
        <source>Plans with other headings, orders, corners and fewer headland passes are driven beside the first one.</source>
        <translation>En plus du premier, des plans avec d&apos;autres orientations, ordres et coins et moins de tours de fourrière sont calculés en entier.</translation>
    </message>
    <message>
        <source>headings, orders and corners are not compared as driven: the path has %1 parts and the field %2 corners, and with more than %3 in all that takes too long</source>
        <translation>les orientations, les ordres et les coins ne sont pas comparés tels que parcourus : le trajet a %1 parties et la parcelle %2 coins ; au-delà de %3 en tout, cela dure trop longtemps</translation>
    </message>
    <message>
        <source>Way back to work</source>
        <translation>Chemin de retour au travail</translation>
    </message>
    <message>
        <source>Way to refill</source>
        <translation>Chemin vers le remplissage</translation>
    </message>
    <message>
        <source>Way to unload</source>
        <translation>Chemin vers la vidange</translation>
    </message>
    <message>
        <source>Swaths reach to the boundary; for fields with room to turn outside, and for machines that turn on the spot.</source>
        <translation>Les passages vont jusqu&apos;à la limite ; pour les parcelles où l&apos;on peut tourner dehors et pour les machines qui tournent sur place.</translation>
    </message>
    <message>
        <source>There is no headland, as chosen. The machine turns on the spot inside the field.</source>
        <translation>Pas de fourrière, comme choisi. La machine tourne sur place, à l’intérieur de la parcelle.</translation>
    </message>
</context>
<context>
    <name>PreferencesDialog</name>
    <message>
        <source>Language and units</source>
        <translation>Langue et unités</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Langue</translation>
    </message>
    <message>
        <source>Same as this computer</source>
        <translation>Comme cet ordinateur</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>Unités</translation>
    </message>
    <message>
        <source>Metres, hectares, km/h</source>
        <translation>Mètres, hectares, km/h</translation>
    </message>
    <message>
        <source>Feet, acres, mph</source>
        <translation>Pieds, acres, mph</translation>
    </message>
    <message>
        <source>Fields take both: 7.3 m, 24 ft, 10&apos;6&quot;, 8 km/h, 5 mph. Files always hold metres.</source>
        <translation>Les cases acceptent les deux : 7,3 m, 24 ft, 10&apos;6&quot;, 8 km/h, 5 mph. Les fichiers sont toujours en mètres.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
</context>
<context>
    <name>PrintDialog</name>
    <message>
        <source>Print the work order</source>
        <translation>Imprimer l&apos;ordre de travail</translation>
    </message>
    <message>
        <source>Plan again</source>
        <translation>Planifier à nouveau</translation>
    </message>
    <message numerus="yes">
        <source>%n problem(s) in this plan: it cannot be driven as drawn. The pages say so too.</source>
        <translation>
            <numerusform>%n problème dans ce plan : il ne peut pas être suivi tel quel. Les pages le disent aussi.</numerusform>
            <numerusform>%n problèmes dans ce plan : il ne peut pas être suivi tel quel. Les pages le disent aussi.</numerusform>
        </translation>
    </message>
    <message>
        <source>Pages of</source>
        <translation>Pages de</translation>
    </message>
    <message>
        <source>This field</source>
        <translation>Cette parcelle</translation>
    </message>
    <message>
        <source>The whole farm (%1)</source>
        <translation>Toute l&apos;exploitation (%1)</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>Papier</translation>
    </message>
    <message>
        <source>A4</source>
        <translation>A4</translation>
    </message>
    <message>
        <source>Letter</source>
        <translation>Letter</translation>
    </message>
    <message>
        <source>Printer</source>
        <translation>Imprimante</translation>
    </message>
    <message>
        <source>No printer was found</source>
        <translation>Aucune imprimante trouvée</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Arrêter</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Save picture…</source>
        <translation>Enregistrer l&apos;image…</translation>
    </message>
    <message>
        <source>Print</source>
        <translation>Imprimer</translation>
    </message>
    <message>
        <source>Save as PDF…</source>
        <translation>Enregistrer en PDF…</translation>
    </message>
    <message>
        <source>Save the work order</source>
        <translation>Enregistrer l&apos;ordre de travail</translation>
    </message>
    <message>
        <source>PDF (%1)</source>
        <translation>PDF (%1)</translation>
    </message>
    <message>
        <source>Save the page with the map as a picture</source>
        <translation>Enregistrer la page de la carte en image</translation>
    </message>
    <message>
        <source>Pictures (%1)</source>
        <translation>Images (%1)</translation>
    </message>
    <message numerus="yes">
        <source>%n field(s) of the list</source>
        <translation>
            <numerusform>%n parcelle de la liste</numerusform>
            <numerusform>%n parcelles de la liste</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ProblemCard</name>
    <message>
        <source>Show the place</source>
        <translation>Montrer l&apos;endroit</translation>
    </message>
    <message>
        <source>Open another file…</source>
        <translation>Ouvrir un autre fichier…</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
</context>
<context>
    <name>ProjectDialogs</name>
    <message>
        <source>Open projects or field boundaries</source>
        <translation>Ouvrir des projets ou des limites de parcelle</translation>
    </message>
    <message>
        <source>Projects and field boundaries (%1)</source>
        <translation>Projets et limites de parcelle (%1)</translation>
    </message>
    <message>
        <source>Projects (%1)</source>
        <translation>Projets (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Save the project</source>
        <translation>Enregistrer le projet</translation>
    </message>
</context>
<context>
    <name>RecentList</name>
    <message>
        <source>Open recent</source>
        <translation>Fichiers récents</translation>
    </message>
    <message>
        <source>%1 — %2</source>
        <translation>%1 — %2</translation>
    </message>
</context>
<context>
    <name>RecentProjects</name>
    <message>
        <source>Go on with</source>
        <translation>Continuer avec</translation>
    </message>
    <message>
        <source>Project %1 in %2, %3</source>
        <translation>Projet %1 dans %2, %3</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
</context>
<context>
    <name>ResultsPanel</name>
    <message>
        <source>Plan</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1 : %2</translation>
    </message>
    <message numerus="yes">
        <source>%n finding(s)</source>
        <translation>
            <numerusform>%n remarque</numerusform>
            <numerusform>%n remarques</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n problem(s)</source>
        <translation>
            <numerusform>%n problème</numerusform>
            <numerusform>%n problèmes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n to look at</source>
        <translation>
            <numerusform>%n à regarder</numerusform>
            <numerusform>%n à regarder</numerusform>
        </translation>
    </message>
    <message>
        <source>Show the first %1 only</source>
        <translation>Ne montrer que les %1 premières</translation>
    </message>
    <message>
        <source>Show all %1</source>
        <translation>Les montrer toutes (%1)</translation>
    </message>
    <message>
        <source>Out of date: figures and findings are those of the plan before the change.</source>
        <translation>Périmé : les chiffres et les remarques sont ceux du plan d&apos;avant la modification.</translation>
    </message>
    <message>
        <source>Nothing was found in this plan: all of it can be driven.</source>
        <translation>Rien n&apos;a été trouvé dans ce plan : il peut être suivi en entier.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>first plan: preliminary figures</source>
        <translation>premier plan : chiffres provisoires</translation>
    </message>
    <message>
        <source>of the plan before</source>
        <translation>du plan précédent</translation>
    </message>
</context>
<context>
    <name>ReviewDialogs</name>
    <message>
        <source>Send for review</source>
        <translation>Envoyer en relecture</translation>
    </message>
    <message>
        <source>Review files (%1)</source>
        <translation>Fichiers de relecture (%1)</translation>
    </message>
    <message>
        <source>Take in what came back</source>
        <translation>Reprendre ce qui est revenu</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Take in this review?</source>
        <translation>Reprendre cette relecture ?</translation>
    </message>
    <message>
        <source>The file is a review of a plan of the project that is open. Its comments can be taken in here.</source>
        <translation>Le fichier est la relecture d’un plan du projet ouvert. Ses commentaires peuvent être repris ici.</translation>
    </message>
    <message>
        <source>Take in</source>
        <translation>Reprendre</translation>
    </message>
    <message>
        <source>Open by itself</source>
        <translation>Ouvrir à part</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
</context>
<context>
    <name>ReviewSection</name>
    <message numerus="yes">
        <source>Review · %n open comment(s)</source>
        <translation>
            <numerusform>Relecture · %n commentaire ouvert</numerusform>
            <numerusform>Relecture · %n commentaires ouverts</numerusform>
        </translation>
    </message>
    <message>
        <source>Review</source>
        <translation>Relecture</translation>
    </message>
    <message>
        <source>The plan has changed since.</source>
        <translation>Le plan a changé depuis.</translation>
    </message>
    <message>
        <source>Take back</source>
        <translation>Retirer</translation>
    </message>
    <message>
        <source>At the place that you clicked:</source>
        <translation>À l&apos;endroit cliqué :</translation>
    </message>
    <message>
        <source>On the whole plan:</source>
        <translation>Sur tout le plan :</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>Commentaire</translation>
    </message>
    <message>
        <source>What should be changed here?</source>
        <translation>Que faut-il changer ici ?</translation>
    </message>
    <message>
        <source>Your name</source>
        <translation>Votre nom</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Ajouter</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>On a place…</source>
        <translation>À un endroit…</translation>
    </message>
    <message>
        <source>On the whole plan…</source>
        <translation>Sur tout le plan…</translation>
    </message>
    <message>
        <source>Approve</source>
        <translation>Approuver</translation>
    </message>
    <message>
        <source>Ask for changes</source>
        <translation>Demander des changements</translation>
    </message>
    <message>
        <source>Take in what came back…</source>
        <translation>Reprendre ce qui est revenu…</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Comment %1:</source>
        <translation>Commentaire %1 :</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Modifier</translation>
    </message>
</context>
<context>
    <name>ScaleBar</name>
    <message>
        <source>Scale: the bar is %1 long</source>
        <translation>Échelle : la barre mesure %1</translation>
    </message>
</context>
<context>
    <name>SearchButton</name>
    <message>
        <source>Search commands</source>
        <translation>Chercher une commande</translation>
    </message>
    <message>
        <source>Ctrl K</source>
        <translation>Ctrl K</translation>
    </message>
</context>
<context>
    <name>SettingText</name>
    <message>
        <source>%1: %2</source>
        <translation>%1 : %2</translation>
    </message>
</context>
<context>
    <name>SidePanel</name>
    <message>
        <source>Back to the plan (Esc)</source>
        <translation>Retour au plan (Échap)</translation>
    </message>
</context>
<context>
    <name>SketchHint</name>
    <message>
        <source>Click the first corner of the field</source>
        <translation>Cliquez sur le premier coin de la parcelle</translation>
    </message>
    <message>
        <source>Click the first corner of the hole</source>
        <translation>Cliquez sur le premier coin de l&apos;enclave</translation>
    </message>
    <message>
        <source>Click the first corner of the obstacle</source>
        <translation>Cliquez sur le premier coin de l&apos;obstacle</translation>
    </message>
    <message>
        <source>Click on the boundary where the gate is</source>
        <translation>Cliquez sur la limite, là où est l&apos;entrée de parcelle</translation>
    </message>
    <message>
        <source>Click where the AB line begins</source>
        <translation>Cliquez là où commence la ligne AB</translation>
    </message>
    <message>
        <source>Length of the next edge</source>
        <translation>Longueur du côté suivant</translation>
    </message>
    <message>
        <source>Direction of the next edge</source>
        <translation>Direction du côté suivant</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Ajouter</translation>
    </message>
    <message>
        <source>By hand</source>
        <translation>À main levée</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>Terminer</translation>
    </message>
    <message>
        <source>Close boundary</source>
        <translation>Fermer la limite</translation>
    </message>
    <message>
        <source>Click where the split line begins</source>
        <translation>Cliquez là où commence la ligne de partage</translation>
    </message>
    <message>
        <source>Press and trace it with the pointer, to %1</source>
        <translation>Appuyez et tracez avec le pointeur, à %1 près</translation>
    </message>
    <message>
        <source>Backspace or Ctrl+Z takes the last point back</source>
        <translation>Retour arrière ou Ctrl+Z retire le dernier point</translation>
    </message>
</context>
<context>
    <name>StatusChip</name>
    <message>
        <source>Stop</source>
        <translation>Arrêter</translation>
    </message>
    <message>
        <source>Plan again</source>
        <translation>Planifier à nouveau</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Montrer</translation>
    </message>
    <message>
        <source>Show the problems</source>
        <translation>Montrer les problèmes</translation>
    </message>
</context>
<context>
    <name>StepItem</name>
    <message>
        <source>%1. %2: %3. %4</source>
        <translation>%1. %2 : %3. %4</translation>
    </message>
</context>
<context>
    <name>StepsNotice</name>
    <message>
        <source>The outline has %1 steps of about %2 %3, like the pixels of an image.</source>
        <translation>Le contour a %1 marches d’environ %2 %3, comme les pixels d’une image.</translation>
    </message>
    <message>
        <source>Made straight, their outlines would be refused. Open one of them to see why.</source>
        <translation>Redressés, leurs contours seraient refusés. Ouvrez-en une pour voir pourquoi.</translation>
    </message>
    <message>
        <source>No machine follows them. Straight edges lead through the middles of the steps.</source>
        <translation>Aucune machine ne les suit. Des bords droits passent au milieu des marches.</translation>
    </message>
    <message>
        <source>Make them straight</source>
        <translation>Redresser</translation>
    </message>
    <message>
        <source>In all fields</source>
        <translation>Dans toutes les parcelles</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
</context>
<context>
    <name>StepsPanel</name>
    <message>
        <source>Find the best plan…</source>
        <translation>Chercher le meilleur plan…</translation>
    </message>
</context>
<context>
    <name>ThemeSwitch</name>
    <message>
        <source>Sunlight colours; press for light</source>
        <translation>Couleurs plein soleil ; cliquer pour les claires</translation>
    </message>
    <message>
        <source>Dark colours; press for sunlight</source>
        <translation>Couleurs sombres ; cliquer pour plein soleil</translation>
    </message>
    <message>
        <source>Light colours; press for dark</source>
        <translation>Couleurs claires ; cliquer pour les sombres</translation>
    </message>
</context>
<context>
    <name>TopBar</name>
    <message>
        <source>Not saved yet</source>
        <translation>Pas encore enregistré</translation>
    </message>
    <message>
        <source>There are changes that are not saved</source>
        <translation>Il y a des modifications non enregistrées</translation>
    </message>
    <message>
        <source>Hide the results</source>
        <translation>Masquer les résultats</translation>
    </message>
    <message>
        <source>Show the results</source>
        <translation>Montrer les résultats</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exporter</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Comparer</translation>
    </message>
    <message>
        <source>Hide the steps</source>
        <translation>Masquer les étapes</translation>
    </message>
    <message>
        <source>Show the steps</source>
        <translation>Afficher les étapes</translation>
    </message>
</context>
<context>
    <name>Tour</name>
    <message>
        <source>Get a field</source>
        <translation>Charger une parcelle</translation>
    </message>
    <message>
        <source>Open its boundary, draw it, or press here for a sample.</source>
        <translation>Ouvrez sa limite, dessinez-la, ou appuyez ici pour un exemple.</translation>
    </message>
    <message>
        <source>Choose your machine</source>
        <translation>Choisir votre machine</translation>
    </message>
    <message>
        <source>The second step: the one most like yours, then its width.</source>
        <translation>La deuxième étape : la plus proche de la vôtre, puis sa largeur.</translation>
    </message>
    <message>
        <source>Change the field</source>
        <translation>Modifier la parcelle</translation>
    </message>
    <message>
        <source>Drag a corner on the map. The plan follows; Ctrl+Z takes it back.</source>
        <translation>Faites glisser un coin sur la carte. Le plan suit ; Ctrl+Z annule.</translation>
    </message>
    <message>
        <source>Take it to the tractor</source>
        <translation>Emporter le plan au tracteur</translation>
    </message>
    <message>
        <source>Export writes the plan to a stick or a folder and checks it.</source>
        <translation>L&apos;export écrit le plan sur une clé ou dans un dossier et le vérifie.</translation>
    </message>
    <message>
        <source>That is all</source>
        <translation>C&apos;est tout</translation>
    </message>
    <message>
        <source>First things</source>
        <translation>Premiers pas</translation>
    </message>
    <message>
        <source>Leave; it is in the Help menu</source>
        <translation>Quitter ; dans le menu Aide</translation>
    </message>
    <message>
        <source>%1: done</source>
        <translation>%1 : fait</translation>
    </message>
    <message>
        <source>Ctrl+S saves the project, F1 opens the guide.</source>
        <translation>Ctrl+S enregistre le projet, F1 ouvre le guide.</translation>
    </message>
</context>
<context>
    <name>TrackQuestion</name>
    <message>
        <source>“%1” is a recorded track</source>
        <translation>« %1 » est un trajet enregistré</translation>
    </message>
    <message>
        <source>It can become a field, or be laid over the plan to see how far beside it was driven.</source>
        <translation>Il peut devenir une parcelle, ou être posé sur le plan pour voir de combien on s&apos;en est écarté.</translation>
    </message>
    <message>
        <source>Make a field from it</source>
        <translation>En faire une parcelle</translation>
    </message>
    <message>
        <source>Lay it over the plan</source>
        <translation>Le poser sur le plan</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
</context>
<context>
    <name>TroubleDialog</name>
    <message>
        <source>Report a problem</source>
        <translation>Signaler un problème</translation>
    </message>
    <message>
        <source>One file with all that is needed to find the cause: the version, the machine, the settings, the shape of the field, the findings, and the record of the last crash. No names and no other fields are in it.</source>
        <translation>Un fichier avec tout ce qu&apos;il faut pour trouver la cause : la version, la machine, les réglages, la forme de la parcelle, les remarques et l&apos;enregistrement du dernier plantage. Aucun nom ni aucune autre parcelle n&apos;y figure.</translation>
    </message>
    <message>
        <source>Nothing is sent. You decide who gets the file; write to them what you did and what you expected.</source>
        <translation>Rien n&apos;est envoyé. Vous décidez qui reçoit le fichier ; écrivez ce que vous avez fait et ce que vous attendiez.</translation>
    </message>
    <message>
        <source>Save the report…</source>
        <translation>Enregistrer le rapport…</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>Enregistrer le rapport</translation>
    </message>
    <message>
        <source>Reports (%1)</source>
        <translation>Rapports (%1)</translation>
    </message>
</context>
<context>
    <name>UnitText</name>
    <message>
        <source>%1 ft</source>
        <translation>%1 ft</translation>
    </message>
    <message>
        <source>%1 ft²</source>
        <translation>%1 ft²</translation>
    </message>
    <message>
        <source>%1 m²</source>
        <translation>%1 m²</translation>
    </message>
    <message>
        <source>%1 ac</source>
        <translation>%1 ac</translation>
    </message>
    <message>
        <source>%1 ha</source>
        <translation>%1 ha</translation>
    </message>
    <message>
        <source>%1 mi</source>
        <translation>%1 mi</translation>
    </message>
    <message>
        <source>%1 km</source>
        <translation>%1 km</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>%1 mph</source>
        <translation>%1 mph</translation>
    </message>
    <message>
        <source>%1 km/h</source>
        <translation>%1 km/h</translation>
    </message>
    <message>
        <source>%1 ft/s²</source>
        <translation>%1 ft/s²</translation>
    </message>
    <message>
        <source>%1 m/s²</source>
        <translation>%1 m/s²</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>%1 h %2 min</source>
        <translation>%1 h %2 min</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>%1 min %2 s</source>
        <translation>%1 min %2 s</translation>
    </message>
    <message>
        <source>%1 h %2 min %3 s</source>
        <translation>%1 h %2 min %3 s</translation>
    </message>
</context>
<context>
    <name>UnsavedDialog</name>
    <message>
        <source>Save the changes of “%1”?</source>
        <translation>Enregistrer les modifications de « %1 » ?</translation>
    </message>
    <message>
        <source>Save your work?</source>
        <translation>Enregistrer le travail ?</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Do not save</source>
        <translation>Ne pas enregistrer</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Enregistrer</translation>
    </message>
</context>
<context>
    <name>ViewCommands</name>
    <message>
        <source>View</source>
        <translation>Affichage</translation>
    </message>
    <message>
        <source>What the map shows</source>
        <translation>Ce que montre la carte</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Couleurs</translation>
    </message>
    <message>
        <source>Size of everything</source>
        <translation>Taille de l&apos;affichage</translation>
    </message>
    <message>
        <source>Everything at %1 %</source>
        <translation>Tout à %1 %</translation>
    </message>
    <message>
        <source>size scaling zoom large text</source>
        <translation>taille échelle zoom grand texte</translation>
    </message>
    <message>
        <source>Follow the machine</source>
        <translation>Suivre la machine</translation>
    </message>
    <message>
        <source>drive camera centre</source>
        <translation>parcourir carte centre</translation>
    </message>
    <message>
        <source>Drive-through bar</source>
        <translation>Barre de parcours</translation>
    </message>
    <message>
        <source>drive play slider</source>
        <translation>parcourir lecture curseur</translation>
    </message>
    <message>
        <source>Show the whole field</source>
        <translation>Montrer toute la parcelle</translation>
    </message>
    <message>
        <source>Go to a place…</source>
        <translation>Aller à un endroit…</translation>
    </message>
    <message>
        <source>coordinates latitude longitude map</source>
        <translation>coordonnées latitude longitude carte</translation>
    </message>
    <message>
        <source>Closer</source>
        <translation>Zoom avant</translation>
    </message>
    <message>
        <source>zoom in</source>
        <translation>agrandir zoom</translation>
    </message>
    <message>
        <source>Further away</source>
        <translation>Zoom arrière</translation>
    </message>
    <message>
        <source>zoom out</source>
        <translation>réduire zoom</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Étapes</translation>
    </message>
    <message>
        <source>Results panel</source>
        <translation>Résultats</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Couches</translation>
    </message>
    <message>
        <source>imagery map background</source>
        <translation>imagerie carte fond</translation>
    </message>
    <message>
        <source>Layer: imagery</source>
        <translation>Couche : imagerie</translation>
    </message>
    <message>
        <source>Layer: OpenStreetMap from the network</source>
        <translation>Couche : OpenStreetMap depuis le réseau</translation>
    </message>
    <message>
        <source>online tiles</source>
        <translation>en ligne tuiles</translation>
    </message>
    <message>
        <source>Layer: boundary</source>
        <translation>Couche : limite de parcelle</translation>
    </message>
    <message>
        <source>Layer: headland</source>
        <translation>Couche : fourrière</translation>
    </message>
    <message>
        <source>Layer: swaths</source>
        <translation>Couche : passages</translation>
    </message>
    <message>
        <source>Layer: turns</source>
        <translation>Couche : demi-tours</translation>
    </message>
    <message>
        <source>Layer: driving direction</source>
        <translation>Couche : sens de marche</translation>
    </message>
    <message>
        <source>Layer: swath numbers</source>
        <translation>Couche : numéros des passages</translation>
    </message>
    <message>
        <source>Layer: order numbers</source>
        <translation>Couche : numéros d&apos;ordre</translation>
    </message>
    <message>
        <source>Layer: coverage</source>
        <translation>Couche : surface travaillée</translation>
    </message>
    <message>
        <source>Layer: worked twice</source>
        <translation>Couche : travaillé deux fois</translation>
    </message>
    <message>
        <source>overlap</source>
        <translation>recouvrement</translation>
    </message>
    <message>
        <source>Layer: missed</source>
        <translation>Couche : zones non travaillées</translation>
    </message>
    <message>
        <source>gap uncovered</source>
        <translation>manque non couvert</translation>
    </message>
    <message>
        <source>Layer: driven over often</source>
        <translation>Couche : passages de roues</translation>
    </message>
    <message>
        <source>wheel passes traffic compaction</source>
        <translation>passages de roues trafic tassement</translation>
    </message>
    <message>
        <source>Layer: findings</source>
        <translation>Couche : remarques</translation>
    </message>
    <message>
        <source>Language and units…</source>
        <translation>Langue et unités…</translation>
    </message>
    <message>
        <source>preferences settings metric imperial feet acres</source>
        <translation>préférences réglages métrique impérial pieds acres</translation>
    </message>
    <message>
        <source>Light colours</source>
        <translation>Couleurs claires</translation>
    </message>
    <message>
        <source>theme</source>
        <translation>thème</translation>
    </message>
    <message>
        <source>Dark colours</source>
        <translation>Couleurs sombres</translation>
    </message>
    <message>
        <source>theme night</source>
        <translation>thème nuit</translation>
    </message>
    <message>
        <source>Sunlight colours</source>
        <translation>Couleurs plein soleil</translation>
    </message>
    <message>
        <source>theme contrast</source>
        <translation>thème contraste</translation>
    </message>
</context>
<context>
    <name>WindowDialogs</name>
    <message>
        <source>Everything at %1 %</source>
        <translation>Tout à %1 %</translation>
    </message>
    <message>
        <source>This holds from the next start of Furrow.</source>
        <translation>Cela prend effet au prochain démarrage de Furrow.</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
</context>
<context>
    <name>Words</name>
    <message>
        <source>Several moves</source>
        <translation>Plusieurs manœuvres</translation>
    </message>
</context>
<context>
    <name>WorkOrderPages</name>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>as drawn</source>
        <translation>comme dessiné</translation>
    </message>
    <message>
        <source>Draft</source>
        <comment>work order</comment>
        <translation>Brouillon</translation>
    </message>
    <message>
        <source>Issued</source>
        <comment>work order</comment>
        <translation>Émis</translation>
    </message>
    <message>
        <source>In progress</source>
        <comment>work order</comment>
        <translation>En cours</translation>
    </message>
    <message>
        <source>Done</source>
        <comment>work order</comment>
        <translation>Terminé</translation>
    </message>
    <message numerus="yes">
        <source>Not drivable: %n problem(s)</source>
        <translation>
            <numerusform>Non réalisable : %n problème</numerusform>
            <numerusform>Non réalisable : %n problèmes</numerusform>
        </translation>
    </message>
    <message>
        <source>Work order</source>
        <translation>Ordre de travail</translation>
    </message>
    <message>
        <source>Work order %1</source>
        <translation>Ordre de travail %1</translation>
    </message>
    <message>
        <source>%1/ac</source>
        <translation>%1/ac</translation>
    </message>
    <message>
        <source>%1/ha</source>
        <translation>%1/ha</translation>
    </message>
    <message>
        <source>Customer</source>
        <translation>Client</translation>
    </message>
    <message>
        <source>Field address</source>
        <translation>Adresse de la parcelle</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>Chauffeur</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>Product</source>
        <translation>Produit</translation>
    </message>
    <message>
        <source>Rate and total</source>
        <translation>Dose et total</translation>
    </message>
    <message>
        <source>%1 = %2</source>
        <comment>rate and total</comment>
        <translation>%1 = %2</translation>
    </message>
    <message>
        <source>Where the work starts</source>
        <translation>Où commence le travail</translation>
    </message>
    <message>
        <source>Gate</source>
        <translation>Entrée</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Surface</translation>
    </message>
    <message>
        <source>Driven</source>
        <translation>Parcouru</translation>
    </message>
    <message>
        <source>Working</source>
        <translation>Travail</translation>
    </message>
    <message>
        <source>Turning</source>
        <translation>Demi-tours</translation>
    </message>
    <message>
        <source>Covered</source>
        <translation>Travaillé</translation>
    </message>
    <message>
        <source>Worked twice</source>
        <translation>Travaillé deux fois</translation>
    </message>
    <message>
        <source>Outside the field</source>
        <translation>Hors de la parcelle</translation>
    </message>
    <message>
        <source>Fuel</source>
        <translation>Carburant</translation>
    </message>
    <message>
        <source>%1 l</source>
        <translation>%1 l</translation>
    </message>
    <message>
        <source>Above the best order</source>
        <translation>Écart au meilleur ordre</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Machine</translation>
    </message>
    <message>
        <source>Working width</source>
        <translation>Largeur de travail</translation>
    </message>
    <message>
        <source>Width in turns</source>
        <translation>Largeur en demi-tour</translation>
    </message>
    <message>
        <source>Turning radius</source>
        <translation>Rayon de braquage</translation>
    </message>
    <message>
        <source>Speed at work</source>
        <translation>Vitesse de travail</translation>
    </message>
    <message>
        <source>Speed in turns</source>
        <translation>Vitesse en demi-tour</translation>
    </message>
    <message>
        <source>Implement</source>
        <translation>Outil</translation>
    </message>
    <message>
        <source>trailed</source>
        <translation>traîné</translation>
    </message>
    <message>
        <source>mounted</source>
        <translation>porté</translation>
    </message>
    <message>
        <source>Tank</source>
        <translation>Cuve</translation>
    </message>
    <message>
        <source>full after %1</source>
        <translation>plein après %1</translation>
    </message>
    <message>
        <source>enough for %1</source>
        <translation>suffit pour %1</translation>
    </message>
    <message numerus="yes">
        <source>%n pass(es)</source>
        <translation>
            <numerusform>%n tour</numerusform>
            <numerusform>%n tours</numerusform>
        </translation>
    </message>
    <message>
        <source>none</source>
        <comment>headland</comment>
        <translation>aucune</translation>
    </message>
    <message>
        <source>Operation</source>
        <translation>Opération</translation>
    </message>
    <message>
        <source>Headland</source>
        <translation>Fourrière</translation>
    </message>
    <message>
        <source>Swaths</source>
        <translation>Passages</translation>
    </message>
    <message>
        <source>Kept free at the edge</source>
        <translation>Marge libre au bord</translation>
    </message>
    <message>
        <source>Plan and settings</source>
        <translation>Plan et réglages</translation>
    </message>
    <message>
        <source>What was done</source>
        <translation>Réalisation</translation>
    </message>
    <message>
        <source>Acres worked</source>
        <translation>Acres travaillés</translation>
    </message>
    <message>
        <source>Hectares worked</source>
        <translation>Hectares travaillés</translation>
    </message>
    <message>
        <source>Hours</source>
        <translation>Heures</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>Début</translation>
    </message>
    <message>
        <source>End</source>
        <comment>of the work</comment>
        <translation>Fin</translation>
    </message>
    <message>
        <source>Wind</source>
        <translation>Vent</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>Température</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Remarques</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Date</translation>
    </message>
    <message>
        <source>Signature</source>
        <translation>Signature</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Remarques</translation>
    </message>
    <message>
        <source>None: the plan can be driven as drawn.</source>
        <translation>Aucune : le plan peut être suivi tel quel.</translation>
    </message>
    <message numerus="yes">
        <source>and %n more, in the window and in summary.json</source>
        <translation>
            <numerusform>et %n autre, dans la fenêtre et dans summary.json</numerusform>
            <numerusform>et %n autres, dans la fenêtre et dans summary.json</numerusform>
        </translation>
    </message>
    <message>
        <source>Comments</source>
        <translation>Commentaires</translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <comment>count and kind of turns</comment>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>%1 in reverse</source>
        <translation>%1 en marche arrière</translation>
    </message>
    <message>
        <source>Turns</source>
        <translation>Demi-tours</translation>
    </message>
    <message>
        <source>H%1</source>
        <comment>headland pass</comment>
        <translation>F%1</translation>
    </message>
    <message>
        <source>Swath %1</source>
        <translation>Passage %1</translation>
    </message>
    <message>
        <source>Order of the passes</source>
        <translation>Ordre des passages</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>N°</translation>
    </message>
    <message>
        <source>Pass</source>
        <translation>Passage</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longueur</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Vers</translation>
    </message>
    <message>
        <source>This plan&apos;s path.csv has the SHA-256 sum below. A file with another sum is another plan.</source>
        <translation>Le fichier path.csv de ce plan a la somme SHA-256 ci-dessous. Un fichier avec une autre somme est un autre plan.</translation>
    </message>
    <message>
        <source>N</source>
        <comment>north</comment>
        <translation>N</translation>
    </message>
    <message>
        <source>1 : %1</source>
        <comment>scale of a map</comment>
        <translation>1 : %1</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Départ</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Fin</translation>
    </message>
    <message>
        <source>Swath</source>
        <translation>Passage</translation>
    </message>
    <message>
        <source>Headland pass</source>
        <translation>Tour de fourrière</translation>
    </message>
    <message>
        <source>Implement up</source>
        <translation>Outil relevé</translation>
    </message>
    <message>
        <source>Finding</source>
        <translation>Remarque</translation>
    </message>
    <message>
        <source>Obstacle</source>
        <translation>Obstacle</translation>
    </message>
    <message>
        <source>Farm</source>
        <translation>Exploitation</translation>
    </message>
    <message>
        <source>Work orders</source>
        <translation>Ordres de travail</translation>
    </message>
    <message numerus="yes">
        <source>%n field(s)</source>
        <translation>
            <numerusform>%n parcelle</numerusform>
            <numerusform>%n parcelles</numerusform>
        </translation>
    </message>
    <message>
        <source>Field</source>
        <translation>Parcelle</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>State</source>
        <translation>État</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>Page</translation>
    </message>
    <message>
        <source>Not drivable</source>
        <translation>Non réalisable</translation>
    </message>
    <message>
        <source>Total</source>
        <translation>Total</translation>
    </message>
    <message>
        <source>Furrow %1</source>
        <translation>Furrow %1</translation>
    </message>
    <message>
        <source>plan %1</source>
        <translation>plan %1</translation>
    </message>
    <message>
        <source>Page %1 of %2</source>
        <translation>Page %1 sur %2</translation>
    </message>
    <message>
        <source>Unloadings</source>
        <translation>Vidanges</translation>
    </message>
    <message>
        <source>Refills</source>
        <translation>Remplissages</translation>
    </message>
</context>
<context>
    <name>furrow::BestSearch</name>
    <message>
        <source>Take the best plan</source>
        <translation>Prendre le meilleur plan</translation>
    </message>
</context>
<context>
    <name>furrow::CellSteps</name>
    <message numerus="yes">
        <source>%n block(s), %1</source>
        <translation>
            <numerusform>%n sous-parcelle, %1</numerusform>
            <numerusform>%n sous-parcelles, %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Cut: %1</source>
        <translation>Coupé : %1</translation>
    </message>
    <message>
        <source>Cut: %1 → joined: %2</source>
        <translation>Coupé : %1 → réuni : %2</translation>
    </message>
    <message>
        <source>Joining any two of them would save nothing.</source>
        <translation>En réunir deux ne ferait rien gagner.</translation>
    </message>
    <message>
        <source>Step %1 of %2: %3</source>
        <translation>Étape %1 sur %2 : %3</translation>
    </message>
    <message>
        <source>As cut.</source>
        <translation>Tel que coupé.</translation>
    </message>
    <message>
        <source>The two marked blocks become one: that saves %1.</source>
        <translation>Les deux sous-parcelles marquées n&apos;en font plus qu&apos;une : %1 de gagné.</translation>
    </message>
    <message>
        <source>Blocks in which no swath lies go to their neighbours.</source>
        <translation>Les sous-parcelles sans passage vont à leurs voisines.</translation>
    </message>
</context>
<context>
    <name>furrow::ChoiceTableModel</name>
    <message>
        <source>saves %1</source>
        <translation>gagne %1</translation>
    </message>
    <message>
        <source>mends the plan</source>
        <translation>rend le plan réalisable</translation>
    </message>
    <message>
        <source>the same time</source>
        <translation>même durée</translation>
    </message>
    <message>
        <source>%1 slower</source>
        <translation>%1 plus lent</translation>
    </message>
    <message>
        <source>%1 quicker</source>
        <translation>%1 plus rapide</translation>
    </message>
</context>
<context>
    <name>furrow::DriveThrough</name>
    <message>
        <source>Swath %1, %2 of %3</source>
        <translation>Passage %1, %2 sur %3</translation>
    </message>
    <message>
        <source>backwards</source>
        <translation>en marche arrière</translation>
    </message>
    <message>
        <source>implement down</source>
        <translation>outil baissé</translation>
    </message>
    <message>
        <source>implement folded</source>
        <translation>outil replié</translation>
    </message>
    <message>
        <source>implement up</source>
        <translation>outil relevé</translation>
    </message>
    <message>
        <source>%1 done</source>
        <translation>%1 faits</translation>
    </message>
    <message>
        <source>wheels straight</source>
        <translation>roues droites</translation>
    </message>
    <message>
        <source>%1° left</source>
        <translation>%1° à gauche</translation>
    </message>
    <message>
        <source>%1° right</source>
        <translation>%1° à droite</translation>
    </message>
    <message>
        <source>tank %1</source>
        <translation>cuve %1</translation>
    </message>
    <message>
        <source>tank empty</source>
        <translation>cuve vide</translation>
    </message>
    <message>
        <source>Way without work</source>
        <translation>Chemin sans travail</translation>
    </message>
    <message>
        <source>bunker %1</source>
        <translation>trémie %1</translation>
    </message>
</context>
<context>
    <name>furrow::DrivenTrack</name>
    <message>
        <source>On the plan</source>
        <translation>Sur le plan</translation>
    </message>
    <message>
        <source>Positions within one and a half widths of it; the figures are of these</source>
        <translation>Positions à moins d&apos;une largeur et demie ; les chiffres portent sur celles-ci</translation>
    </message>
    <message>
        <source>Half are within</source>
        <translation>La moitié est à moins de</translation>
    </message>
    <message>
        <source>95 % are within</source>
        <translation>95 % sont à moins de</translation>
    </message>
    <message>
        <source>Farthest</source>
        <translation>Le plus loin</translation>
    </message>
    <message>
        <source>On average to the right</source>
        <translation>En moyenne à droite</translation>
    </message>
    <message>
        <source>On average to the left</source>
        <translation>En moyenne à gauche</translation>
    </message>
    <message>
        <source>The same everywhere: antenna or offset</source>
        <translation>Partout pareil : antenne ou décalage</translation>
    </message>
    <message>
        <source>On swaths, 95 % within</source>
        <translation>Sur les passages, 95 % à moins de</translation>
    </message>
    <message>
        <source>Covered</source>
        <translation>Travaillé</translation>
    </message>
    <message>
        <source>As if the implement ran in the middle of the recorded line</source>
        <translation>Comme si l&apos;outil était centré sur la ligne enregistrée</translation>
    </message>
    <message>
        <source>Missed</source>
        <translation>Non travaillé</translation>
    </message>
    <message>
        <source>Driven</source>
        <translation>Parcouru</translation>
    </message>
    <message>
        <source>The plan: %1</source>
        <translation>Le plan : %1</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>up to %1</source>
        <translation>jusqu&apos;à %1</translation>
    </message>
    <message>
        <source>farther</source>
        <translation>plus loin</translation>
    </message>
    <message>
        <source>off the plan</source>
        <translation>hors du plan</translation>
    </message>
</context>
<context>
    <name>furrow::ExportModel</name>
    <message>
        <source>Furrow plan</source>
        <translation>Plan Furrow</translation>
    </message>
    <message>
        <source>Furrow %1</source>
        <translation>Furrow %1</translation>
    </message>
    <message>
        <source>Writing …</source>
        <translation>Écriture…</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) written to %1</source>
        <translation>
            <numerusform>%n fichier écrit dans %1</numerusform>
            <numerusform>%n fichiers écrits dans %1</numerusform>
        </translation>
    </message>
    <message>
        <source>There is no field yet, and no plan to export.</source>
        <translation>Il n&apos;y a pas encore de parcelle, ni de plan à exporter.</translation>
    </message>
    <message>
        <source>A field is being opened. Its plan can be exported when it is finished.</source>
        <translation>Une parcelle est en cours d&apos;ouverture. Son plan pourra être exporté quand il sera prêt.</translation>
    </message>
    <message>
        <source>The plan is still being made. It can be exported when it is finished.</source>
        <translation>Le plan est encore en cours de calcul. Il pourra être exporté quand il sera prêt.</translation>
    </message>
    <message>
        <source>The plan is out of date: the field, the machine or a setting was changed after it was made.</source>
        <translation>Le plan est périmé : la parcelle, la machine ou un réglage a été modifié depuis.</translation>
    </message>
    <message>
        <source>There is no plan to export. The message on the map says why.</source>
        <translation>Il n&apos;y a pas de plan à exporter. Le message sur la carte dit pourquoi.</translation>
    </message>
    <message numerus="yes">
        <source>%n field(s)</source>
        <translation>
            <numerusform>%n parcelle</numerusform>
            <numerusform>%n parcelles</numerusform>
        </translation>
    </message>
    <message>
        <source>Furrow plans</source>
        <translation>Furrow plans</translation>
    </message>
    <message>
        <source>None of the fields could be exported.</source>
        <translation>Aucune des parcelles n’a pu être exportée.</translation>
    </message>
    <message numerus="yes">
        <source>%n field(s) written to %1</source>
        <translation>
            <numerusform>%n parcelle écrite dans %1</numerusform>
            <numerusform>%n parcelles écrites dans %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n file(s)</source>
        <translation>
            <numerusform>%n fichier</numerusform>
            <numerusform>%n fichiers</numerusform>
        </translation>
    </message>
    <message>
        <source>Writing was stopped.</source>
        <translation>L’écriture a été arrêtée.</translation>
    </message>
    <message>
        <source>Fields that were written before stay in the folder.</source>
        <translation>Les parcelles déjà écrites restent dans le dossier.</translation>
    </message>
</context>
<context>
    <name>furrow::FarmList</name>
    <message numerus="yes">
        <source>Plan %n field(s) alike</source>
        <translation>
            <numerusform>Planifier %n parcelle de même</numerusform>
            <numerusform>Planifier %n parcelles de même</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Add a plan to %n field(s)</source>
        <translation>
            <numerusform>Ajouter un plan à %n parcelle</numerusform>
            <numerusform>Ajouter un plan à %n parcelles</numerusform>
        </translation>
    </message>
    <message>
        <source>Not planned yet</source>
        <translation>Pas planifié</translation>
    </message>
    <message>
        <source>Out of date</source>
        <translation>Périmé</translation>
    </message>
    <message>
        <source>Waits</source>
        <translation>En attente</translation>
    </message>
    <message>
        <source>Planning …</source>
        <translation>Planification…</translation>
    </message>
    <message>
        <source>Drivable</source>
        <translation>Réalisable</translation>
    </message>
    <message numerus="yes">
        <source>%n problem(s)</source>
        <translation>
            <numerusform>%n problème</numerusform>
            <numerusform>%n problèmes</numerusform>
        </translation>
    </message>
    <message>
        <source>No plan</source>
        <translation>Pas de plan</translation>
    </message>
    <message numerus="yes">
        <source>%n field(s)</source>
        <translation>
            <numerusform>%n parcelle</numerusform>
            <numerusform>%n parcelles</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n field(s)</source>
        <translation>
            <numerusform>%1 sur %n parcelle</numerusform>
            <numerusform>%1 sur %n parcelles</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 drivable</source>
        <translation>%1 réalisables</translation>
    </message>
</context>
<context>
    <name>furrow::FarmModel</name>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>Rename the field</source>
        <translation>Renommer la parcelle</translation>
    </message>
    <message>
        <source>Remove field %1</source>
        <translation>Retirer la parcelle %1</translation>
    </message>
    <message>
        <source>Add a plan</source>
        <translation>Ajouter un plan</translation>
    </message>
    <message>
        <source>Rename the plan</source>
        <translation>Renommer le plan</translation>
    </message>
    <message>
        <source>Remove the plan</source>
        <translation>Retirer le plan</translation>
    </message>
</context>
<context>
    <name>furrow::FarmPlans</name>
    <message>
        <source>%1 of %2: %3</source>
        <translation>%1 sur %2 : %3</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Arrêté</translation>
    </message>
    <message numerus="yes">
        <source>%n field(s) planned</source>
        <translation>
            <numerusform>%n parcelle planifiée</numerusform>
            <numerusform>%n parcelles planifiées</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n with problems</source>
        <translation>
            <numerusform>%n avec problèmes</numerusform>
            <numerusform>%n avec problèmes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n without a plan</source>
        <translation>
            <numerusform>%n sans plan</numerusform>
            <numerusform>%n sans plan</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>furrow::FieldEditor</name>
    <message>
        <source>Add a point</source>
        <translation>Ajouter un point</translation>
    </message>
    <message>
        <source>Change the headland of an edge</source>
        <translation>Modifier la fourrière d&apos;un côté</translation>
    </message>
    <message>
        <source>Headland of an edge as elsewhere</source>
        <translation>Fourrière d&apos;un côté comme ailleurs</translation>
    </message>
    <message>
        <source>Move a point</source>
        <translation>Déplacer un point</translation>
    </message>
    <message>
        <source>Move an edge</source>
        <translation>Déplacer un côté</translation>
    </message>
    <message>
        <source>Move a hole</source>
        <translation>Déplacer une enclave</translation>
    </message>
    <message>
        <source>Move an obstacle</source>
        <translation>Déplacer un obstacle</translation>
    </message>
    <message>
        <source>Move a gate</source>
        <translation>Déplacer une entrée de parcelle</translation>
    </message>
    <message>
        <source>Change the buffer</source>
        <translation>Modifier la distance</translation>
    </message>
    <message>
        <source>Change the overhang of an obstacle</source>
        <translation>Modifier le débord d&apos;un obstacle</translation>
    </message>
    <message>
        <source>Change the overhang of an edge</source>
        <translation>Modifier le débord d&apos;un côté</translation>
    </message>
    <message>
        <source>Draw a hole</source>
        <translation>Dessiner une enclave</translation>
    </message>
    <message>
        <source>Draw an obstacle</source>
        <translation>Dessiner un obstacle</translation>
    </message>
    <message>
        <source>Obstacle %1</source>
        <translation>Obstacle %1</translation>
    </message>
    <message>
        <source>Add a gate</source>
        <translation>Ajouter une entrée de parcelle</translation>
    </message>
    <message>
        <source>Gate %1</source>
        <translation>Entrée de parcelle %1</translation>
    </message>
    <message>
        <source>Draw a guidance curve</source>
        <translation>Dessiner une courbe de guidage</translation>
    </message>
    <message>
        <source>Draw an AB line</source>
        <translation>Dessiner une ligne AB</translation>
    </message>
    <message>
        <source>Delete a point</source>
        <translation>Supprimer un point</translation>
    </message>
    <message>
        <source>Delete a hole</source>
        <translation>Supprimer une enclave</translation>
    </message>
    <message>
        <source>Delete an obstacle</source>
        <translation>Supprimer un obstacle</translation>
    </message>
    <message>
        <source>Delete a gate</source>
        <translation>Supprimer une entrée de parcelle</translation>
    </message>
    <message>
        <source>Delete the guidance line</source>
        <translation>Supprimer la ligne de guidage</translation>
    </message>
    <message>
        <source>Make steps straight</source>
        <translation>Redresser les marches</translation>
    </message>
    <message>
        <source>Made straight, it would be refused: %1; %2.</source>
        <translation>Redressé, il serait refusé : %1; %2.</translation>
    </message>
    <message numerus="yes">
        <source>%n field(s) stay as they are: %1.</source>
        <translation>
            <numerusform>%n parcelle reste comme elle est : %1.</numerusform>
            <numerusform>%n parcelles restent comme elles sont : %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Déplacer</translation>
    </message>
    <message>
        <source>Change a length</source>
        <translation>Modifier une longueur</translation>
    </message>
    <message>
        <source>Change a direction</source>
        <translation>Modifier une direction</translation>
    </message>
    <message>
        <source>Let the obstacle be driven on</source>
        <translation>Rendre l&apos;obstacle franchissable</translation>
    </message>
    <message>
        <source>Keep off the obstacle</source>
        <translation>Ne pas rouler sur l&apos;obstacle</translation>
    </message>
    <message>
        <source>Change the gate</source>
        <translation>Modifier l&apos;entrée de parcelle</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Renommer</translation>
    </message>
    <message>
        <source>AB line along an edge</source>
        <translation>Ligne AB le long d&apos;un côté</translation>
    </message>
    <message>
        <source>Draw a split line</source>
        <translation>Dessiner une ligne de partage</translation>
    </message>
    <message>
        <source>Delete a split line</source>
        <translation>Supprimer une ligne de partage</translation>
    </message>
</context>
<context>
    <name>furrow::FieldFromTrack</name>
    <message numerus="yes">
        <source>%n position(s)</source>
        <translation>
            <numerusform>%n position</numerusform>
            <numerusform>%n positions</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n track(s)</source>
        <translation>
            <numerusform>%n trajet</numerusform>
            <numerusform>%n trajets</numerusform>
        </translation>
    </message>
    <message>
        <source>The pieces do not touch: each becomes a field of its own.</source>
        <translation>Les morceaux ne se touchent pas : chacun devient une parcelle.</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Surface</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>Morceaux</translation>
    </message>
    <message>
        <source>Holes</source>
        <translation>Trous</translation>
    </message>
    <message>
        <source>Points of the boundary</source>
        <translation>Points de la limite</translation>
    </message>
    <message>
        <source>Around the field</source>
        <translation>Autour de la parcelle</translation>
    </message>
    <message>
        <source>Over the whole field, at work</source>
        <translation>Sur toute la parcelle, au travail</translation>
    </message>
    <message>
        <source>As it looks: around the field</source>
        <translation>D&apos;après le trajet : autour de la parcelle</translation>
    </message>
    <message>
        <source>As it looks: over the field</source>
        <translation>D&apos;après le trajet : sur la parcelle</translation>
    </message>
    <message>
        <source>As it looks</source>
        <translation>D&apos;après le trajet</translation>
    </message>
</context>
<context>
    <name>furrow::FieldOpener</name>
    <message numerus="yes">
        <source>%n file(s)</source>
        <translation>
            <numerusform>%n fichier</numerusform>
            <numerusform>%n fichiers</numerusform>
        </translation>
    </message>
    <message>
        <source>Add field %1</source>
        <translation>Ajouter la parcelle %1</translation>
    </message>
    <message numerus="yes">
        <source>Add %n field(s)</source>
        <translation>
            <numerusform>Ajouter %n parcelle</numerusform>
            <numerusform>Ajouter %n parcelles</numerusform>
        </translation>
    </message>
    <message>
        <source>Field %1</source>
        <translation>Parcelle %1</translation>
    </message>
    <message>
        <source>drawn on the map</source>
        <translation>dessinée sur la carte</translation>
    </message>
</context>
<context>
    <name>furrow::FiguresModel</name>
    <message>
        <source>Area</source>
        <translation>Surface</translation>
    </message>
    <message>
        <source>Of the field, holes and obstacles taken out</source>
        <translation>De la parcelle, sans enclaves ni obstacles</translation>
    </message>
    <message>
        <source>Inside the headland</source>
        <translation>Plein champ</translation>
    </message>
    <message>
        <source>What is left inside the headland</source>
        <translation>Ce qui reste à l&apos;intérieur de la fourrière</translation>
    </message>
    <message>
        <source>Swaths</source>
        <translation>Passages</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Trajet</translation>
    </message>
    <message>
        <source>Everything that is driven</source>
        <translation>Tout ce qui est parcouru</translation>
    </message>
    <message>
        <source>Working</source>
        <translation>Travail</translation>
    </message>
    <message>
        <source>Turning</source>
        <translation>Demi-tours</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>Covered</source>
        <translation>Travaillé</translation>
    </message>
    <message>
        <source>Share of the field that is worked, measured on the finished path</source>
        <translation>Part de la parcelle travaillée, mesurée sur le trajet terminé</translation>
    </message>
    <message>
        <source>Overlap</source>
        <translation>Recouvrement</translation>
    </message>
    <message>
        <source>Share of the field that is worked twice</source>
        <translation>Part de la parcelle travaillée deux fois</translation>
    </message>
    <message>
        <source>Land that is not worked</source>
        <translation>Sol qui n&apos;est pas travaillé</translation>
    </message>
    <message>
        <source>%1 cannot be reached by the implement, mostly in corners; %2 could be.</source>
        <translation>%1 est hors d&apos;atteinte de l&apos;outil, surtout dans les coins ; %2 pourrait être travaillé.</translation>
    </message>
    <message>
        <source>Missed</source>
        <translation>Non travaillé</translation>
    </message>
    <message>
        <source>Outside the field</source>
        <translation>Hors de la parcelle</translation>
    </message>
    <message>
        <source>Ground outside that the machine or its implement drives over</source>
        <translation>Sol au dehors sur lequel passe la machine ou son outil</translation>
    </message>
</context>
<context>
    <name>furrow::FileBrowser</name>
    <message>
        <source>This folder cannot be read.</source>
        <translation>Ce dossier ne peut pas être lu.</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Dossier personnel</translation>
    </message>
    <message>
        <source>Documents</source>
        <translation>Documents</translation>
    </message>
    <message>
        <source>Downloads</source>
        <translation>Téléchargements</translation>
    </message>
    <message>
        <source>Desktop</source>
        <translation>Bureau</translation>
    </message>
    <message>
        <source>Computer</source>
        <translation>Ordinateur</translation>
    </message>
</context>
<context>
    <name>furrow::FindingsModel</name>
    <message>
        <source>%1: %2</source>
        <translation>%1 : %2</translation>
    </message>
    <message>
        <source>no problems</source>
        <translation>aucun problème</translation>
    </message>
    <message numerus="yes">
        <source>%n problem(s)</source>
        <translation>
            <numerusform>%n problème</numerusform>
            <numerusform>%n problèmes</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 → %2. Before: %3. Now: %4.</source>
        <translation>%1 → %2. Avant : %3. Maintenant : %4.</translation>
    </message>
</context>
<context>
    <name>furrow::HeadingChoice</name>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>no swath fits</source>
        <translation>aucun passage ne tient</translation>
    </message>
    <message numerus="yes">
        <source>%n swath(s)</source>
        <translation>
            <numerusform>%n passage</numerusform>
            <numerusform>%n passages</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 turning</source>
        <translation>%1 de demi-tours</translation>
    </message>
    <message>
        <source>%1 twice</source>
        <translation>%1 deux fois</translation>
    </message>
    <message>
        <source>%1 missed</source>
        <translation>%1 non travaillés</translation>
    </message>
    <message>
        <source>Swaths along %1</source>
        <translation>Passages à %1</translation>
    </message>
    <message>
        <source>Search the heading</source>
        <translation>Chercher l&apos;orientation</translation>
    </message>
</context>
<context>
    <name>furrow::ImageryModel</name>
    <message>
        <source>%1: %2</source>
        <translation>%1 : %2</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>Ajouter %1</translation>
    </message>
    <message>
        <source>Add imagery</source>
        <translation>Ajouter des images</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>Retirer %1</translation>
    </message>
    <message>
        <source>Move a layer</source>
        <translation>Déplacer une couche</translation>
    </message>
    <message>
        <source>Rename a layer</source>
        <translation>Renommer une couche</translation>
    </message>
    <message>
        <source>Show a layer</source>
        <translation>Afficher une couche</translation>
    </message>
    <message>
        <source>Hide a layer</source>
        <translation>Masquer une couche</translation>
    </message>
    <message>
        <source>Change how strong a layer is</source>
        <translation>Modifier l&apos;opacité d&apos;une couche</translation>
    </message>
    <message>
        <source>Turn the rows of tiles round</source>
        <translation>Inverser l&apos;ordre des lignes de tuiles</translation>
    </message>
</context>
<context>
    <name>furrow::MachineModel</name>
    <message>
        <source>auto · %1</source>
        <translation>auto · %1</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Machine</translation>
    </message>
    <message>
        <source>machine</source>
        <translation>machine</translation>
    </message>
</context>
<context>
    <name>furrow::OrderModel</name>
    <message>
        <source>Order number</source>
        <translation>N° de l&apos;ordre</translation>
    </message>
    <message>
        <source>Customer</source>
        <translation>Client</translation>
    </message>
    <message>
        <source>Field address</source>
        <translation>Adresse de la parcelle</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>Chauffeur</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Horaire</translation>
    </message>
    <message>
        <source>Product</source>
        <translation>Produit</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Dose</translation>
    </message>
    <message>
        <source>Unit of the rate</source>
        <translation>Unité de la dose</translation>
    </message>
    <message>
        <source>Area worked</source>
        <translation>Surface travaillée</translation>
    </message>
    <message>
        <source>Hours worked</source>
        <translation>Heures de travail</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Remarques</translation>
    </message>
    <message>
        <source>%1 per acre</source>
        <translation>%1 par acre</translation>
    </message>
    <message>
        <source>%1 per hectare</source>
        <translation>%1 par hectare</translation>
    </message>
    <message>
        <source>Change the work order</source>
        <translation>Modifier l&apos;ordre de travail</translation>
    </message>
</context>
<context>
    <name>furrow::ParameterModel</name>
    <message>
        <source>auto</source>
        <translation>auto</translation>
    </message>
    <message>
        <source>auto · %1</source>
        <translation>auto · %1</translation>
    </message>
    <message numerus="yes">
        <source>%n place(s) on the map</source>
        <translation>
            <numerusform>%n endroit sur la carte</numerusform>
            <numerusform>%n endroits sur la carte</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>a line of %n point(s)</source>
        <translation>
            <numerusform>une ligne de %n point</numerusform>
            <numerusform>une ligne de %n points</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n line(s)</source>
        <translation>
            <numerusform>%n ligne</numerusform>
            <numerusform>%n lignes</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>furrow::PlanChange</name>
    <message>
        <source>time %1</source>
        <translation>durée %1</translation>
    </message>
    <message>
        <source>path %1</source>
        <translation>trajet %1</translation>
    </message>
    <message>
        <source>covered %1</source>
        <translation>travaillé %1</translation>
    </message>
    <message>
        <source>worked twice %1</source>
        <translation>travaillé deux fois %1</translation>
    </message>
    <message>
        <source>With the last change: the same time, length and area.</source>
        <translation>Avec le dernier changement : même durée, longueur et surface.</translation>
    </message>
    <message>
        <source>With the last change: %1</source>
        <translation>Avec le dernier changement : %1</translation>
    </message>
</context>
<context>
    <name>furrow::PlanComparison</name>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Trajet</translation>
    </message>
    <message>
        <source>Working</source>
        <translation>Travail</translation>
    </message>
    <message>
        <source>Turning</source>
        <translation>Demi-tours</translation>
    </message>
    <message>
        <source>Swaths</source>
        <translation>Passages</translation>
    </message>
    <message>
        <source>Covered</source>
        <translation>Travaillé</translation>
    </message>
    <message>
        <source>Missed</source>
        <translation>Non travaillé</translation>
    </message>
    <message>
        <source>Overlap</source>
        <translation>Recouvrement</translation>
    </message>
    <message>
        <source>Outside the field</source>
        <translation>Hors de la parcelle</translation>
    </message>
    <message>
        <source>In reverse</source>
        <translation>En marche arrière</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Problèmes</translation>
    </message>
    <message>
        <source>The standard settings</source>
        <translation>Les réglages standard</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Machine</translation>
    </message>
    <message>
        <source>All swaths lie in the same places.</source>
        <translation>Tous les passages sont aux mêmes endroits.</translation>
    </message>
    <message numerus="yes">
        <source>%n swath(s) of the other plan lie elsewhere.</source>
        <translation>
            <numerusform>%n passage de l&apos;autre plan est ailleurs.</numerusform>
            <numerusform>%n passages de l&apos;autre plan sont ailleurs.</numerusform>
        </translation>
    </message>
    <message>
        <source>Take the standard settings</source>
        <translation>Prendre les réglages standard</translation>
    </message>
    <message>
        <source>Inside the headland</source>
        <translation>Plein champ</translation>
    </message>
    <message>
        <source>Headland passes: %1 only in this plan, %2 only in the other.</source>
        <translation>Tours de fourrière : %1 dans ce plan seul, %2 dans l’autre seul.</translation>
    </message>
    <message>
        <source>Turns and ways: %1 only in this plan, %2 only in the other.</source>
        <translation>Demi-tours et trajets : %1 dans ce plan seul, %2 dans l’autre seul.</translation>
    </message>
    <message>
        <source>All headland passes lie in the same places.</source>
        <translation>Tous les tours de fourrière sont aux mêmes endroits.</translation>
    </message>
    <message>
        <source>All turns and ways lie in the same places.</source>
        <translation>Tous les demi-tours et trajets sont aux mêmes endroits.</translation>
    </message>
</context>
<context>
    <name>furrow::Planning</name>
    <message>
        <source>Change the machine</source>
        <translation>Modifier la machine</translation>
    </message>
    <message>
        <source>Reading %1 …</source>
        <translation>Lecture de %1…</translation>
    </message>
    <message numerus="yes">
        <source>%n field(s) in this file</source>
        <translation>
            <numerusform>%n parcelle dans ce fichier</numerusform>
            <numerusform>%n parcelles dans ce fichier</numerusform>
        </translation>
    </message>
    <message>
        <source>Planning …</source>
        <translation>Planification…</translation>
    </message>
    <message>
        <source>No plan</source>
        <translation>Pas de plan</translation>
    </message>
    <message>
        <source>Plan ready · %1 ms</source>
        <translation>Plan prêt · %1 ms</translation>
    </message>
    <message>
        <source>Plan ready · %1 s</source>
        <translation>Plan prêt · %1 s</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>Change: %1</source>
        <translation>Modifier : %1</translation>
    </message>
    <message>
        <source>Draft · planning …</source>
        <translation>Ébauche · planification…</translation>
    </message>
    <message>
        <source>Draft · the whole plan follows when you let go</source>
        <translation>Ébauche · le plan complet suit au relâchement</translation>
    </message>
    <message>
        <source>Out of date · this is a draft</source>
        <translation>Périmé · ceci est une ébauche</translation>
    </message>
    <message>
        <source>Out of date · this is the plan before the change</source>
        <translation>Périmé · plan d&apos;avant la modification</translation>
    </message>
    <message>
        <source>Stopped · there is no plan</source>
        <translation>Arrêté · il n&apos;y a pas de plan</translation>
    </message>
    <message numerus="yes">
        <source>%n problem(s)</source>
        <translation>
            <numerusform>%n problème</numerusform>
            <numerusform>%n problèmes</numerusform>
        </translation>
    </message>
    <message>
        <source>Out of date · this is a first plan</source>
        <translation>Périmé · ceci est un premier plan</translation>
    </message>
    <message>
        <source>First plan · being improved …</source>
        <translation>Premier plan · en cours d&apos;amélioration…</translation>
    </message>
    <message>
        <source>First plan · comparing plan %1 …</source>
        <translation>Premier plan · comparaison du plan %1…</translation>
    </message>
    <message>
        <source>Planning … · comparing plan %1</source>
        <translation>Planification… · comparaison du plan %1</translation>
    </message>
</context>
<context>
    <name>furrow::Printing</name>
    <message>
        <source>There is no field yet, and no plan to print.</source>
        <translation>Il n&apos;y a pas encore de parcelle, ni de plan à imprimer.</translation>
    </message>
    <message>
        <source>The plan is still being made. It can be printed when it is finished.</source>
        <translation>Le plan est en cours de calcul. Il pourra être imprimé une fois terminé.</translation>
    </message>
    <message>
        <source>The plan is out of date. Plan again to print it.</source>
        <translation>Le plan est périmé. Planifiez à nouveau pour l&apos;imprimer.</translation>
    </message>
    <message>
        <source>There is no plan to print. The message on the map says why.</source>
        <translation>Il n&apos;y a pas de plan à imprimer. Le message sur la carte dit pourquoi.</translation>
    </message>
    <message>
        <source>Work order</source>
        <translation>Ordre de travail</translation>
    </message>
    <message>
        <source>Work orders</source>
        <translation>Ordres de travail</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Écrit : %1</translation>
    </message>
    <message>
        <source>The printer %1 did not take the pages.</source>
        <translation>L&apos;imprimante %1 n&apos;a pas accepté les pages.</translation>
    </message>
    <message>
        <source>Look whether it is on, or save a PDF and print that.</source>
        <translation>Vérifiez qu&apos;elle est allumée, ou enregistrez un PDF et imprimez-le.</translation>
    </message>
    <message>
        <source>Sent to %1</source>
        <translation>Envoyé à %1</translation>
    </message>
</context>
<context>
    <name>furrow::ProjectFiles</name>
    <message>
        <source>Your last work was not saved. Here it is again.</source>
        <translation>Le dernier travail n&apos;était pas enregistré. Le voici.</translation>
    </message>
    <message>
        <source>Changes of “%1” were not saved. Here they are again.</source>
        <translation>Des modifications de « %1 » n&apos;étaient pas enregistrées. Les voici.</translation>
    </message>
    <message>
        <source>It is kept in the file all the same.</source>
        <translation>Cela reste tout de même dans le fichier.</translation>
    </message>
    <message>
        <source>Restore changes that were not saved</source>
        <translation>Rétablir des modifications non enregistrées</translation>
    </message>
    <message>
        <source>Another program changed “%1” while changes of yours were not saved. Yours are shown; undo shows the file.</source>
        <translation>Un autre programme a modifié « %1 » alors que vos modifications n&apos;étaient pas enregistrées. Les vôtres sont affichées ; « Annuler » montre le fichier.</translation>
    </message>
    <message>
        <source>Another program has changed “%1” since it was opened here.</source>
        <translation>Un autre programme a modifié « %1 » depuis son ouverture ici.</translation>
    </message>
    <message>
        <source>Save over it, or save yours under another name.</source>
        <translation>Écrasez-le, ou enregistrez le vôtre sous un autre nom.</translation>
    </message>
    <message>
        <source>Farm</source>
        <translation>Exploitation</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1 : %2</translation>
    </message>
</context>
<context>
    <name>furrow::QuantityText</name>
    <message>
        <source>ft</source>
        <translation>ft</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>ac</source>
        <translation>ac</translation>
    </message>
    <message>
        <source>ha</source>
        <translation>ha</translation>
    </message>
    <message>
        <source>mph</source>
        <translation>mph</translation>
    </message>
    <message>
        <source>km/h</source>
        <translation>km/h</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>This is not a length. Type it like 7.3 m, 24 ft or 10&apos;6&quot;.</source>
        <translation>Ce n&apos;est pas une longueur. Saisissez par exemple 7,3 m, 24 ft ou 10&apos;6&quot;.</translation>
    </message>
    <message>
        <source>This is not an area. Type it like 12.5 ha or 30 ac.</source>
        <translation>Ce n&apos;est pas une surface. Saisissez par exemple 12,5 ha ou 30 ac.</translation>
    </message>
    <message>
        <source>This is not a speed. Type it like 8 km/h or 5 mph.</source>
        <translation>Ce n&apos;est pas une vitesse. Saisissez par exemple 8 km/h ou 5 mph.</translation>
    </message>
    <message>
        <source>This is not an angle. Type it in degrees, like 87.5.</source>
        <translation>Ce n&apos;est pas un angle. Saisissez-le en degrés, par exemple 87,5.</translation>
    </message>
    <message>
        <source>This is not a number.</source>
        <translation>Ce n&apos;est pas un nombre.</translation>
    </message>
    <message>
        <source>This is not a whole number.</source>
        <translation>Ce n&apos;est pas un nombre entier.</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>Type something from %1 to %2.</source>
        <translation>Saisissez une valeur de %1 à %2.</translation>
    </message>
    <message>
        <source>%1 mi</source>
        <translation>%1 mi</translation>
    </message>
    <message>
        <source>%1 km</source>
        <translation>%1 km</translation>
    </message>
    <message>
        <source>%1 ft</source>
        <translation>%1 ft</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>This is not a time. Type it like 45 s or 2 min.</source>
        <translation>Ce n&apos;est pas un temps. Saisissez par exemple 45 s ou 2 min.</translation>
    </message>
</context>
<context>
    <name>furrow::RecentFiles</name>
    <message numerus="yes">
        <source>%n field(s)</source>
        <translation>
            <numerusform>%n parcelle</numerusform>
            <numerusform>%n parcelles</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>furrow::ReviewModel</name>
    <message>
        <source>Only a finished plan of what the panels show can be sent.</source>
        <translation>Seul un plan terminé de ce que montrent les panneaux peut être envoyé.</translation>
    </message>
    <message>
        <source>Approved: %1</source>
        <translation>Approuvé : %1</translation>
    </message>
    <message>
        <source>Changes wanted: %1</source>
        <translation>Changements souhaités : %1</translation>
    </message>
    <message>
        <source>Send back…</source>
        <translation>Retourner…</translation>
    </message>
    <message>
        <source>Send on…</source>
        <translation>Renvoyer…</translation>
    </message>
    <message>
        <source>Send for review…</source>
        <translation>Envoyer en relecture…</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>Commentaire</translation>
    </message>
    <message>
        <source>Remove a comment</source>
        <translation>Retirer un commentaire</translation>
    </message>
    <message>
        <source>Settle a comment</source>
        <translation>Régler un commentaire</translation>
    </message>
    <message>
        <source>Open a comment again</source>
        <translation>Rouvrir un commentaire</translation>
    </message>
    <message>
        <source>Approve the plan</source>
        <translation>Approuver le plan</translation>
    </message>
    <message>
        <source>Ask for changes</source>
        <translation>Demander des changements</translation>
    </message>
    <message>
        <source>Take the verdict back</source>
        <translation>Retirer l&apos;avis</translation>
    </message>
    <message>
        <source>review</source>
        <translation>relecture</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1 : %2</translation>
    </message>
    <message>
        <source>Send for review</source>
        <translation>Envoyer en relecture</translation>
    </message>
    <message>
        <source>Written: %1. Whoever has Furrow can open it, comment on it and send it back.</source>
        <translation>Écrit : %1. Quiconque a Furrow peut l&apos;ouvrir, le commenter et le renvoyer.</translation>
    </message>
    <message>
        <source>Take in a review</source>
        <translation>Reprendre une relecture</translation>
    </message>
    <message numerus="yes">
        <source>%n new comment(s)</source>
        <translation>
            <numerusform>%n nouveau commentaire</numerusform>
            <numerusform>%n nouveaux commentaires</numerusform>
        </translation>
    </message>
    <message>
        <source>The review was brought up to date</source>
        <translation>La relecture est mise à jour</translation>
    </message>
    <message>
        <source>Nothing new in this review</source>
        <translation>Rien de nouveau dans cette relecture</translation>
    </message>
    <message>
        <source>%1. The plan has changed since it was sent.</source>
        <translation>%1. Le plan a changé depuis son envoi.</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1.</translation>
    </message>
    <message>
        <source>Edit a comment</source>
        <translation>Modifier un commentaire</translation>
    </message>
</context>
<context>
    <name>furrow::StepsModel</name>
    <message numerus="yes">
        <source>%1 but for %n edge(s)</source>
        <translation>
            <numerusform>%1 sauf sur %n côté</numerusform>
            <numerusform>%1 sauf sur %n côtés</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 inside</source>
        <translation>plein champ %1</translation>
    </message>
    <message numerus="yes">
        <source>%n pass(es)</source>
        <translation>
            <numerusform>%n tour</numerusform>
            <numerusform>%n tours</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n block(s)</source>
        <translation>
            <numerusform>%n sous-parcelle</numerusform>
            <numerusform>%n sous-parcelles</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n swath(s)</source>
        <translation>
            <numerusform>%n passage</numerusform>
            <numerusform>%n passages</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 with turns on the spot</source>
        <translation>%1 avec demi-tours sur place</translation>
    </message>
    <message numerus="yes">
        <source>%n turn(s)</source>
        <translation>
            <numerusform>%n demi-tour</numerusform>
            <numerusform>%n demi-tours</numerusform>
        </translation>
    </message>
    <message>
        <source>No usable boundary</source>
        <translation>Pas de limite utilisable</translation>
    </message>
    <message>
        <source>No field yet</source>
        <translation>Pas encore de parcelle</translation>
    </message>
    <message numerus="yes">
        <source>%n obstacle(s)</source>
        <translation>
            <numerusform>%n obstacle</numerusform>
            <numerusform>%n obstacles</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n hole(s)</source>
        <translation>
            <numerusform>%n enclave</numerusform>
            <numerusform>%n enclaves</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n boundary point(s)</source>
        <translation>
            <numerusform>%n point de limite</numerusform>
            <numerusform>%n points de limite</numerusform>
        </translation>
    </message>
    <message>
        <source>The message on the map says why</source>
        <translation>Le message sur la carte dit pourquoi</translation>
    </message>
    <message>
        <source>Open a file or draw a boundary</source>
        <translation>Ouvrez un fichier ou dessinez une limite</translation>
    </message>
    <message>
        <source>%1 wide</source>
        <translation>%1 de large</translation>
    </message>
    <message>
        <source>%1 radius</source>
        <translation>%1 de rayon</translation>
    </message>
    <message>
        <source>Field</source>
        <translation>Parcelle</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Machine</translation>
    </message>
    <message numerus="yes">
        <source>%n problem(s)</source>
        <translation>
            <numerusform>%n problème</numerusform>
            <numerusform>%n problèmes</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing to check yet</source>
        <translation>Rien à vérifier pour l&apos;instant</translation>
    </message>
    <message>
        <source>Planning …</source>
        <translation>Planification…</translation>
    </message>
    <message>
        <source>No plan</source>
        <translation>Pas de plan</translation>
    </message>
    <message>
        <source>Out of date</source>
        <translation>Périmé</translation>
    </message>
    <message>
        <source>Plan again to check what the panels show</source>
        <translation>Planifiez à nouveau pour vérifier l&apos;état actuel</translation>
    </message>
    <message>
        <source>No problems</source>
        <translation>Aucun problème</translation>
    </message>
    <message numerus="yes">
        <source>%n note(s)</source>
        <translation>
            <numerusform>%n remarque</numerusform>
            <numerusform>%n remarques</numerusform>
        </translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Contrôle</translation>
    </message>
    <message>
        <source>proved: no order is better</source>
        <translation>le meilleur, prouvé</translation>
    </message>
    <message>
        <source>turns within %1 of the best</source>
        <translation>demi-tours : +%1 au plus</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1 : %2</translation>
    </message>
    <message>
        <source>To a stick, to files or on paper</source>
        <translation>Sur une clé, en fichiers ou sur papier</translation>
    </message>
    <message>
        <source>No plan to export yet</source>
        <translation>Pas encore de plan à exporter</translation>
    </message>
    <message>
        <source>Waits for the finished plan</source>
        <translation>Attend le plan terminé</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exporter</translation>
    </message>
    <message>
        <source>First plan, being improved</source>
        <translation>Premier plan, en cours d&apos;amélioration</translation>
    </message>
    <message>
        <source>Only the finished plan is checked</source>
        <translation>Seul le plan terminé est vérifié</translation>
    </message>
    <message>
        <source>Until then the map shows the plan before</source>
        <translation>D&apos;ici là, la carte montre le plan précédent</translation>
    </message>
</context>
<context>
    <name>furrow::StickExport</name>
    <message>
        <source>%1 free of %2</source>
        <translation>%1 libres sur %2</translation>
    </message>
    <message>
        <source>Writing …</source>
        <translation>Écriture…</translation>
    </message>
    <message>
        <source>every byte was read back, and the plan read from there is this plan.</source>
        <translation>chaque octet a été relu, et le plan lu là est bien ce plan.</translation>
    </message>
    <message>
        <source>every byte was read back and is as written.</source>
        <translation>chaque octet a été relu et est tel qu&apos;écrit.</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Écrit : %1</translation>
    </message>
    <message>
        <source>Safe to unplug: %1</source>
        <translation>La clé peut être retirée : %1</translation>
    </message>
    <message>
        <source>What was there before is kept as %1.</source>
        <translation>Ce qui s&apos;y trouvait est gardé sous le nom %1.</translation>
    </message>
    <message>
        <source>Writing was stopped, because the plan was changed meanwhile.</source>
        <translation>L&apos;écriture a été arrêtée, car le plan a été modifié entre-temps.</translation>
    </message>
    <message>
        <source>Write it again when the plan is finished.</source>
        <translation>Écrivez-le à nouveau quand le plan sera prêt.</translation>
    </message>
    <message>
        <source>every byte was read back, and the fields read from there are these.</source>
        <translation>chaque octet a été relu, et les parcelles lues là sont bien celles-ci.</translation>
    </message>
</context>
<context>
    <name>furrow::SwathOrder</name>
    <message>
        <source>Search the order of the other swaths</source>
        <translation>Chercher l&apos;ordre des autres passages</translation>
    </message>
    <message>
        <source>Search the order</source>
        <translation>Chercher l&apos;ordre</translation>
    </message>
    <message>
        <source>Change the order of swaths</source>
        <translation>Changer l&apos;ordre des passages</translation>
    </message>
</context>
<context>
    <name>furrow::TroubleReport</name>
    <message>
        <source>The report could not be written: %1</source>
        <translation>Le rapport n&apos;a pas pu être écrit : %1</translation>
    </message>
    <message>
        <source>The report is in %1.</source>
        <translation>Le rapport est dans %1.</translation>
    </message>
</context>
</TS>
