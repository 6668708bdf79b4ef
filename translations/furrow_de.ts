<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en">
<context>
    <name>AboutDialog</name>
    <message>
        <source>Furrow %1</source>
        <translation>Furrow %1</translation>
    </message>
    <message>
        <source>Furrow plans how a machine covers a farm field.</source>
        <translation>Furrow plant, wie eine Maschine einen Schlag bearbeitet.</translation>
    </message>
    <message>
        <source>Free software under the BSD 3-Clause licence: use it, change it and pass it on, without any warranty.</source>
        <translation>Freie Software unter der BSD-3-Clause-Lizenz: nutzen, ändern und weitergeben, ohne jede Gewähr.</translation>
    </message>
    <message>
        <source>The methods follow the Fields2Cover paper (Mier, Valente and de Bruin, 2023) and the sources that the design names.</source>
        <translation>Die Verfahren folgen dem Fields2Cover-Aufsatz (Mier, Valente und de Bruin, 2023) und den Quellen, die der Entwurf nennt.</translation>
    </message>
    <message>
        <source>Built with %1.</source>
        <translation>Gebaut mit %1.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
</context>
<context>
    <name>BestPlanDialog</name>
    <message>
        <source>The best plan found</source>
        <translation>Der beste gefundene Plan</translation>
    </message>
    <message>
        <source>Your plan is the best one found</source>
        <translation>Ihr Plan ist der beste gefundene</translation>
    </message>
    <message>
        <source>Find the best plan</source>
        <translation>Besten Plan suchen</translation>
    </message>
    <message>
        <source>Other choices are planned, and the quickest plan that can be driven is taken. Margins, overlap and what the operation needs stay as they are.</source>
        <translation>Andere Möglichkeiten werden geplant, und der schnellste fahrbare Plan wird genommen. Abstände, Überlappung und was der Arbeitsgang verlangt, bleiben, wie sie sind.</translation>
    </message>
    <message>
        <source>May change</source>
        <translation>Darf sich ändern</translation>
    </message>
    <message>
        <source>%1 (set by you)</source>
        <translation>%1 (von Ihnen)</translation>
    </message>
    <message>
        <source>Best plan</source>
        <translation>Bester Plan</translation>
    </message>
    <message>
        <source>Best so far</source>
        <translation>Bisher bester</translation>
    </message>
    <message>
        <source>As it was</source>
        <translation>Vorher</translation>
    </message>
    <message>
        <source>Saved</source>
        <translation>Gespart</translation>
    </message>
    <message>
        <source>Time of the best plan during the search</source>
        <translation>Zeit des besten Plans während der Suche</translation>
    </message>
    <message numerus="yes">
        <source>%n alternative(s) were planned.</source>
        <translation>
            <numerusform>%n Möglichkeit wurde geplant.</numerusform>
            <numerusform>%n Möglichkeiten wurden geplant.</numerusform>
        </translation>
    </message>
    <message>
        <source>Times include working separately what a plan leaves.</source>
        <translation>Die Zeiten enthalten, was ein Plan liegen lässt und getrennt zu bearbeiten wäre.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Stop and keep</source>
        <translation>Anhalten und behalten</translation>
    </message>
    <message>
        <source>Use this plan</source>
        <translation>Diesen Plan nehmen</translation>
    </message>
</context>
<context>
    <name>CellStepper</name>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Go through the steps</source>
        <translation>Schritte durchgehen</translation>
    </message>
    <message>
        <source>Next step</source>
        <translation>Nächster Schritt</translation>
    </message>
    <message>
        <source>Previous step</source>
        <translation>Vorheriger Schritt</translation>
    </message>
    <message>
        <source>Show the blocks</source>
        <translation>Teilflächen zeigen</translation>
    </message>
    <message>
        <source>Step of the blocks</source>
        <translation>Schritt der Teilflächen</translation>
    </message>
    <message>
        <source>Turns and ways from block to block, estimated.</source>
        <translation>Wendungen und Wege von Teilfläche zu Teilfläche, geschätzt.</translation>
    </message>
</context>
<context>
    <name>ChoiceTable</name>
    <message>
        <source>%1, %2: %3</source>
        <translation>%1, %2: %3</translation>
    </message>
    <message numerus="yes">
        <source>%n other(s) are slower still, or cannot be driven.</source>
        <translation>
            <numerusform>%n weitere ist noch langsamer oder nicht fahrbar.</numerusform>
            <numerusform>%n weitere sind noch langsamer oder nicht fahrbar.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Command</name>
    <message>
        <source>Ctrl</source>
        <translation>Strg</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Umschalt</translation>
    </message>
</context>
<context>
    <name>CommandPalette</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>There is no command and no setting of that name</source>
        <translation>Es gibt keinen Befehl und keine Einstellung dieses Namens</translation>
    </message>
    <message>
        <source>Search commands, settings, coordinates</source>
        <translation>Befehle, Einstellungen, Koordinaten suchen</translation>
    </message>
    <message>
        <source>As maps, phones and receivers write them</source>
        <translation>So wie Karten, Telefone und Empfänger sie schreiben</translation>
    </message>
</context>
<context>
    <name>CommentPins</name>
    <message>
        <source>Comment %1: %2</source>
        <translation>Kommentar %1: %2</translation>
    </message>
    <message>
        <source>Click the place that you want to comment on. Esc ends it.</source>
        <translation>Die Stelle anklicken, zu der der Kommentar gehört. Esc beendet es.</translation>
    </message>
</context>
<context>
    <name>CommentRow</name>
    <message>
        <source>Comment %1 by %2: %3</source>
        <translation>Kommentar %1 von %2: %3</translation>
    </message>
    <message>
        <source>Of a plan before the last change</source>
        <translation>Zu einem Plan vor der letzten Änderung</translation>
    </message>
    <message>
        <source>Open again</source>
        <translation>Wieder öffnen</translation>
    </message>
    <message>
        <source>Settled</source>
        <translation>Erledigt</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Bearbeiten</translation>
    </message>
</context>
<context>
    <name>ComparePanel</name>
    <message>
        <source>Compare</source>
        <translation>Vergleichen</translation>
    </message>
    <message>
        <source>%1 beside</source>
        <translation>%1 neben</translation>
    </message>
    <message>
        <source>The other plan</source>
        <translation>Der andere Plan</translation>
    </message>
    <message>
        <source>Keep this plan as a variant…</source>
        <translation>Diesen Plan als Variante behalten …</translation>
    </message>
    <message>
        <source>The other plan is being made …</source>
        <translation>Der andere Plan wird gemacht …</translation>
    </message>
    <message>
        <source>This plan</source>
        <translation>Dieser Plan</translation>
    </message>
    <message>
        <source>The other</source>
        <translation>Der andere</translation>
    </message>
    <message>
        <source>%1: %2, the other %3</source>
        <translation>%1: %2, der andere %3</translation>
    </message>
    <message>
        <source>Hold to see the other plan (key X)</source>
        <translation>Halten: der andere Plan (Taste X)</translation>
    </message>
    <message>
        <source>What was chosen otherwise</source>
        <translation>Was anders gewählt ist</translation>
    </message>
    <message>
        <source>Machine and settings are the same.</source>
        <translation>Maschine und Einstellungen sind gleich.</translation>
    </message>
    <message>
        <source>%1 → %2</source>
        <translation>%1 → %2</translation>
    </message>
    <message>
        <source>Go on with the other plan</source>
        <translation>Mit dem anderen Plan weiter</translation>
    </message>
    <message>
        <source>Two maps side by side (Ctrl+Shift+D)</source>
        <translation>Zwei Karten nebeneinander (Strg+Umschalt+D)</translation>
    </message>
    <message>
        <source>On the maps, swaths, headland passes and turns are coloured that the other plan has not: full lines in this plan, dashes in the other.</source>
        <translation>Auf den Karten sind Spuren, Vorgewendespuren und Wendungen farbig, die der andere Plan nicht hat: volle Linien in diesem Plan, gestrichelte im anderen.</translation>
    </message>
    <message>
        <source>On the map, swaths, headland passes and turns: full lines only in this plan, dashes only in the other.</source>
        <translation>Auf der Karte, Spuren, Vorgewendespuren und Wendungen: volle Linien nur in diesem Plan, gestrichelte nur im anderen.</translation>
    </message>
</context>
<context>
    <name>CrashNotice</name>
    <message>
        <source>Furrow ended unexpectedly the last time.</source>
        <translation>Furrow wurde beim letzten Mal unerwartet beendet.</translation>
    </message>
    <message>
        <source>Your work was kept up to the last half second. What happened is recorded on this computer; a report helps to mend it.</source>
        <translation>Ihre Arbeit ist bis auf die letzte halbe Sekunde erhalten. Was geschah, ist auf diesem Computer aufgezeichnet; ein Bericht hilft, es zu beheben.</translation>
    </message>
    <message>
        <source>Report a problem…</source>
        <translation>Ein Problem melden …</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
</context>
<context>
    <name>DrawingNotice</name>
    <message>
        <source>The map cannot show fields and plans: this window is drawn without OpenGL.</source>
        <translation>Die Karte kann weder Schläge noch Pläne zeigen: Dieses Fenster wird ohne OpenGL gezeichnet.</translation>
    </message>
    <message>
        <source>Install a graphics driver with OpenGL; Mesa draws on any processor. The command line plans and exports all the same.</source>
        <translation>Einen Grafiktreiber mit OpenGL installieren; Mesa zeichnet auf jedem Prozessor. Auf der Kommandozeile lässt sich trotzdem planen und exportieren.</translation>
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
        <translation>Abfahren</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Drive through the plan</source>
        <translation>Plan abfahren</translation>
    </message>
    <message>
        <source>Moment of the drive</source>
        <translation>Zeitpunkt der Fahrt</translation>
    </message>
    <message>
        <source>Pace: %1 times as fast</source>
        <translation>Tempo: %1-mal so schnell</translation>
    </message>
    <message>
        <source>%1×</source>
        <translation>%1×</translation>
    </message>
    <message>
        <source>Let the map rest</source>
        <translation>Karte ruhen lassen</translation>
    </message>
    <message>
        <source>Follow the machine</source>
        <translation>Der Maschine folgen</translation>
    </message>
    <message>
        <source>Hide the drive-through</source>
        <translation>Abfahren ausblenden</translation>
    </message>
</context>
<context>
    <name>DrivenDialog</name>
    <message>
        <source>Open a recorded track</source>
        <translation>Aufzeichnung öffnen</translation>
    </message>
    <message>
        <source>Recorded tracks (%1)</source>
        <translation>Aufzeichnungen (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
</context>
<context>
    <name>DrivenPanel</name>
    <message>
        <source>Planned and driven</source>
        <translation>Geplant und gefahren</translation>
    </message>
    <message>
        <source>Go to the farthest place</source>
        <translation>Zum größten Abstand</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Distance from the plan</source>
        <translation>Abstand vom Plan</translation>
    </message>
    <message>
        <source>Another track…</source>
        <translation>Andere Aufzeichnung …</translation>
    </message>
    <message>
        <source>Make a field from it</source>
        <translation>Schlag daraus machen</translation>
    </message>
</context>
<context>
    <name>EditCommands</name>
    <message>
        <source>Edit</source>
        <translation>Bearbeiten</translation>
    </message>
    <message>
        <source>Undo: %1</source>
        <translation>Rückgängig: %1</translation>
    </message>
    <message>
        <source>Draw a point</source>
        <translation>Punkt zeichnen</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Redo: %1</source>
        <translation>Wiederholen: %1</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Delete what is selected</source>
        <translation>Auswahl löschen</translation>
    </message>
    <message>
        <source>Del</source>
        <translation>Entf</translation>
    </message>
    <message>
        <source>Select the next point</source>
        <translation>Nächsten Punkt auswählen</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Leertaste</translation>
    </message>
    <message>
        <source>Select the next edge</source>
        <translation>Nächste Kante auswählen</translation>
    </message>
    <message>
        <source>Select the next outline, line or gate</source>
        <translation>Nächsten Umriss, nächste Linie oder Zufahrt auswählen</translation>
    </message>
    <message>
        <source>PgDown</source>
        <translation>Bild ab</translation>
    </message>
    <message>
        <source>Find a command…</source>
        <translation>Befehl suchen …</translation>
    </message>
</context>
<context>
    <name>EmptyState</name>
    <message>
        <source>Which field?</source>
        <translation>Welcher Schlag?</translation>
    </message>
    <message>
        <source>Open its boundary, or drop the file anywhere on this window. Shapefile, GeoJSON, KML, GeoPackage, GML and others are understood, zipped or not.</source>
        <translation>Feldgrenze öffnen oder die Datei irgendwo in dieses Fenster ziehen. Shapefile, GeoJSON, KML, GeoPackage, GML und andere werden gelesen, auch gezippt.</translation>
    </message>
    <message>
        <source>Open a file…</source>
        <translation>Datei öffnen …</translation>
    </message>
    <message>
        <source>Draw it</source>
        <translation>Zeichnen</translation>
    </message>
    <message>
        <source>Or try one of these</source>
        <translation>Oder einen von diesen ausprobieren</translation>
    </message>
    <message>
        <source>Sample field %1</source>
        <translation>Beispielschlag %1</translation>
    </message>
</context>
<context>
    <name>ErrorCourse</name>
    <message>
        <source>Distance from the plan along the recording, up to %1</source>
        <translation>Abstand vom Plan entlang der Aufzeichnung, bis %1</translation>
    </message>
    <message>
        <source>%1 to the left</source>
        <translation>%1 nach links</translation>
    </message>
    <message>
        <source>%1 to the right</source>
        <translation>%1 nach rechts</translation>
    </message>
</context>
<context>
    <name>ExportChecks</name>
    <message>
        <source>Choose another format or terminal, and report this.</source>
        <translation>Ein anderes Format oder Terminal wählen und dies melden.</translation>
    </message>
    <message numerus="yes">
        <source>%n check(s) passed: nothing in the files that receivers stumble over.</source>
        <translation>
            <numerusform>%n Prüfung bestanden: nichts in den Dateien, worüber Terminals stolpern.</numerusform>
            <numerusform>%n Prüfungen bestanden: nichts in den Dateien, worüber Terminals stolpern.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ExportDialog</name>
    <message>
        <source>Export the plan</source>
        <translation>Plan exportieren</translation>
    </message>
    <message>
        <source>USB stick</source>
        <translation>USB-Stick</translation>
    </message>
    <message>
        <source>Files in a folder</source>
        <translation>Dateien in einem Ordner</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Writing …</source>
        <translation>Wird geschrieben …</translation>
    </message>
    <message>
        <source>Write to the stick</source>
        <translation>Auf den Stick schreiben</translation>
    </message>
    <message>
        <source>Write files</source>
        <translation>Dateien schreiben</translation>
    </message>
    <message>
        <source>Plan again</source>
        <translation>Neu planen</translation>
    </message>
    <message numerus="yes">
        <source>%n problem(s) in this plan: it cannot be driven as drawn. The files say so too.</source>
        <translation>
            <numerusform>%n Problem in diesem Plan: So ist er nicht fahrbar. Das steht auch in den Dateien.</numerusform>
            <numerusform>%n Probleme in diesem Plan: So ist er nicht fahrbar. Das steht auch in den Dateien.</numerusform>
        </translation>
    </message>
    <message>
        <source>Export fields</source>
        <translation>Schläge exportieren</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
</context>
<context>
    <name>ExportFolderPage</name>
    <message>
        <source>Folder</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen …</translation>
    </message>
    <message>
        <source>Folder for the plan</source>
        <translation>Ordner für den Plan</translation>
    </message>
    <message>
        <source>Fields without a plan are planned on the way. Each field gets a folder of its own; ISOXML and AgGPS hold all fields in one.</source>
        <translation>Schläge ohne Plan werden dabei geplant. Jeder Schlag bekommt einen eigenen Ordner; ISOXML und AgGPS enthalten alle Schläge gemeinsam.</translation>
    </message>
</context>
<context>
    <name>ExportStickPage</name>
    <message>
        <source>Terminal</source>
        <translation>Terminal</translation>
    </message>
    <message>
        <source>Stick</source>
        <translation>Stick</translation>
    </message>
    <message>
        <source>No USB stick is plugged in. It appears here when it is; or choose a folder to carry the files yourself.</source>
        <translation>Kein USB-Stick eingesteckt. Sobald einer steckt, erscheint er hier; oder einen Ordner wählen und die Dateien selbst übertragen.</translation>
    </message>
    <message>
        <source>Another folder…</source>
        <translation>Anderer Ordner …</translation>
    </message>
    <message>
        <source>%1 is on it already.</source>
        <translation>%1 ist schon darauf.</translation>
    </message>
    <message>
        <source>It will not be deleted: it is kept under another name.</source>
        <translation>Es wird nicht gelöscht, sondern unter anderem Namen behalten.</translation>
    </message>
    <message>
        <source>Keep it as a backup and write the plan</source>
        <translation>Als Sicherung behalten und den Plan schreiben</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>und %n weitere</numerusform>
            <numerusform>und %n weitere</numerusform>
        </translation>
    </message>
    <message>
        <source>Folder in the place of a stick</source>
        <translation>Ordner anstelle eines Sticks</translation>
    </message>
    <message>
        <source>Also in a task, for terminals that show lines in tasks only</source>
        <translation>Auch als Auftrag, für Terminals, die Linien nur in Aufträgen zeigen</translation>
    </message>
</context>
<context>
    <name>FarImageryNotice</name>
    <message>
        <source>This picture does not show the field: it lies %1 away.</source>
        <translation>Dieses Bild zeigt den Schlag nicht: es liegt %1 entfernt.</translation>
    </message>
    <message>
        <source>Go there</source>
        <translation>Dorthin gehen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
</context>
<context>
    <name>FarmHeader</name>
    <message>
        <source>%1, sorted downwards</source>
        <translation>%1, absteigend sortiert</translation>
    </message>
    <message>
        <source>%1, sorted</source>
        <translation>%1, sortiert</translation>
    </message>
</context>
<context>
    <name>FarmPanel</name>
    <message>
        <source>The farm</source>
        <translation>Der Betrieb</translation>
    </message>
    <message>
        <source>Find a field</source>
        <translation>Schlag suchen</translation>
    </message>
    <message>
        <source>Find a field, season or machine</source>
        <translation>Schlag, Saison oder Maschine suchen</translation>
    </message>
    <message>
        <source>Back to the field (Esc)</source>
        <translation>Zurück zum Schlag (Esc)</translation>
    </message>
    <message>
        <source>Field</source>
        <translation>Schlag</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Maschine</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Fahrweg</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Stand</translation>
    </message>
    <message>
        <source>Fields of the farm</source>
        <translation>Schläge des Betriebs</translation>
    </message>
    <message>
        <source>No field has these words.</source>
        <translation>Kein Schlag enthält diese Wörter.</translation>
    </message>
    <message>
        <source>There is no field yet.</source>
        <translation>Es gibt noch keinen Schlag.</translation>
    </message>
    <message>
        <source>Select none</source>
        <translation>Keine auswählen</translation>
    </message>
    <message>
        <source>Select all</source>
        <translation>Alle auswählen</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
    <message numerus="yes">
        <source>Plan %n field(s)</source>
        <translation>
            <numerusform>%n Schlag planen</numerusform>
            <numerusform>%n Schläge planen</numerusform>
        </translation>
    </message>
    <message>
        <source>Planning …</source>
        <translation>Wird geplant …</translation>
    </message>
    <message>
        <source>All are planned</source>
        <translation>Alle sind geplant</translation>
    </message>
    <message>
        <source>Machine and settings of this plan</source>
        <translation>Maschine und Einstellungen dieses Plans</translation>
    </message>
    <message>
        <source>Add a plan to each…</source>
        <translation>Jedem einen Plan hinzufügen …</translation>
    </message>
    <message>
        <source>Print…</source>
        <translation>Drucken …</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportieren …</translation>
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
        <translation>Datei öffnen …</translation>
    </message>
    <message>
        <source>Draw</source>
        <translation>Zeichnen</translation>
    </message>
    <message>
        <source>Sample field</source>
        <translation>Beispielschlag</translation>
    </message>
    <message>
        <source>Add one to look at</source>
        <translation>Einen zum Ansehen hinzufügen</translation>
    </message>
</context>
<context>
    <name>FieldChooser</name>
    <message numerus="yes">
        <source>Which of the %n field(s)?</source>
        <translation>
            <numerusform>Welcher Schlag (%n)?</numerusform>
            <numerusform>Welcher der %n Schläge?</numerusform>
        </translation>
    </message>
    <message>
        <source>Open none of them</source>
        <translation>Keinen davon öffnen</translation>
    </message>
    <message>
        <source>Open all of them</source>
        <translation>Alle öffnen</translation>
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
        <translation>Schlag</translation>
    </message>
    <message>
        <source>Draw a field</source>
        <translation>Schlag zeichnen</translation>
    </message>
    <message>
        <source>boundary polygon</source>
        <translation>feldgrenze polygon</translation>
    </message>
    <message>
        <source>Make a field from a recorded track…</source>
        <translation>Schlag aus einer Aufzeichnung machen …</translation>
    </message>
    <message>
        <source>boundary driven recorded GPX NMEA log drive around</source>
        <translation>Feldgrenze gefahren aufgezeichnet GPX NMEA umfahren</translation>
    </message>
    <message>
        <source>Draw a hole</source>
        <translation>Aussparung zeichnen</translation>
    </message>
    <message>
        <source>Draw an obstacle</source>
        <translation>Hindernis zeichnen</translation>
    </message>
    <message>
        <source>pond tree pole wet</source>
        <translation>teich baum mast nass</translation>
    </message>
    <message>
        <source>Draw an AB line</source>
        <translation>AB-Linie zeichnen</translation>
    </message>
    <message>
        <source>guidance curve direction</source>
        <translation>leitlinie kurve richtung</translation>
    </message>
    <message>
        <source>Draw a split line</source>
        <translation>Teilungslinie zeichnen</translation>
    </message>
    <message>
        <source>cut divide mainland parts</source>
        <translation>schneiden teilen innenfläche teile</translation>
    </message>
    <message>
        <source>Add a gate</source>
        <translation>Zufahrt hinzufügen</translation>
    </message>
    <message>
        <source>entry road</source>
        <translation>einfahrt weg</translation>
    </message>
    <message>
        <source>Select and change</source>
        <translation>Auswählen und ändern</translation>
    </message>
    <message>
        <source>Make the outline&apos;s steps straight</source>
        <translation>Stufen des Umrisses begradigen</translation>
    </message>
    <message>
        <source>pixels image stairs smooth simplify</source>
        <translation>Pixel Bild Treppe glätten vereinfachen</translation>
    </message>
    <message>
        <source>Rename the field…</source>
        <translation>Schlag umbenennen …</translation>
    </message>
    <message>
        <source>Remove the field</source>
        <translation>Schlag entfernen</translation>
    </message>
    <message>
        <source>delete</source>
        <translation>löschen</translation>
    </message>
    <message>
        <source>Next field</source>
        <translation>Nächster Schlag</translation>
    </message>
    <message>
        <source>All fields of the farm</source>
        <translation>Alle Schläge des Betriebs</translation>
    </message>
    <message>
        <source>list overview plan all batch totals</source>
        <translation>Liste Übersicht alle planen Summen</translation>
    </message>
</context>
<context>
    <name>FieldFromTrackPanel</name>
    <message>
        <source>Field from a track</source>
        <translation>Schlag aus einer Aufzeichnung</translation>
    </message>
    <message>
        <source>How it was driven</source>
        <translation>Wie gefahren wurde</translation>
    </message>
    <message>
        <source>Operating width</source>
        <translation>Arbeitsbreite</translation>
    </message>
    <message>
        <source>The edge lies outside of the line by</source>
        <translation>Die Grenze liegt außerhalb der Linie um</translation>
    </message>
    <message>
        <source>Half a width: the implement ran along the edge</source>
        <translation>Halbe Breite: Das Gerät lief an der Grenze</translation>
    </message>
    <message>
        <source>None: the line is the edge</source>
        <translation>Nichts: Die Linie ist die Grenze</translation>
    </message>
    <message>
        <source>Gaps between strips are closed up to</source>
        <translation>Lücken zwischen Streifen werden geschlossen bis</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Make the field</source>
        <translation>Schlag anlegen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>FieldsToExport</name>
    <message numerus="yes">
        <source>%1 and %n more</source>
        <translation>
            <numerusform>%1 und %n weiterer</numerusform>
            <numerusform>%1 und %n weitere</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: the plan has problems and cannot be driven as drawn. The files say so too.</source>
        <translation>%1: Der Plan hat Probleme und ist so, wie er gezeichnet ist, nicht fahrbar. Die Dateien sagen es auch.</translation>
    </message>
</context>
<context>
    <name>FileCommands</name>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>New project</source>
        <translation>Neues Projekt</translation>
    </message>
    <message>
        <source>farm</source>
        <translation>betrieb</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Öffnen …</translation>
    </message>
    <message>
        <source>boundary import project</source>
        <translation>feldgrenze import projekt</translation>
    </message>
    <message>
        <source>Add imagery…</source>
        <translation>Luftbild hinzufügen …</translation>
    </message>
    <message>
        <source>GeoTIFF MBTiles aerial photo satellite background heights elevation</source>
        <translation>GeoTIFF MBTiles Luftbild Satellit Hintergrund Höhen Gelände</translation>
    </message>
    <message>
        <source>Add a folder of tiles…</source>
        <translation>Ordner mit Kacheln hinzufügen …</translation>
    </message>
    <message>
        <source>imagery XYZ TMS</source>
        <translation>Luftbild XYZ TMS</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Speichern unter …</translation>
    </message>
    <message>
        <source>Export the plan…</source>
        <translation>Plan exportieren …</translation>
    </message>
    <message>
        <source>ISOXML USB terminal</source>
        <translation>ISOXML USB terminal</translation>
    </message>
    <message>
        <source>Print the work order…</source>
        <translation>Arbeitsauftrag drucken …</translation>
    </message>
    <message>
        <source>print pdf report work order picture printer</source>
        <translation>drucken PDF Bericht Arbeitsauftrag Bild Drucker</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Beenden</translation>
    </message>
</context>
<context>
    <name>FileList</name>
    <message>
        <source>%1, falling</source>
        <translation>%1, absteigend</translation>
    </message>
    <message>
        <source>%1, rising</source>
        <translation>%1, aufsteigend</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Changed</source>
        <translation>Geändert</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Files of %1</source>
        <translation>Dateien in %1</translation>
    </message>
    <message>
        <source>Folder %1</source>
        <translation>Ordner %1</translation>
    </message>
    <message>
        <source>%1, %2, %3</source>
        <translation>%1, %2, %3</translation>
    </message>
    <message>
        <source>Reading the folder …</source>
        <translation>Ordner wird gelesen …</translation>
    </message>
    <message>
        <source>Nothing to choose here.</source>
        <translation>Hier gibt es nichts zu wählen.</translation>
    </message>
</context>
<context>
    <name>FileWindow</name>
    <message>
        <source>The folder around it (Backspace)</source>
        <translation>Der Ordner darüber (Rücktaste)</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>New folder…</source>
        <translation>Neuer Ordner …</translation>
    </message>
    <message>
        <source>“%1” is already there. Write over it?</source>
        <translation>„%1“ gibt es schon. Überschreiben?</translation>
    </message>
    <message>
        <source>There is no folder “%1”. Make it?</source>
        <translation>Einen Ordner „%1“ gibt es nicht. Anlegen?</translation>
    </message>
    <message>
        <source>Name of the new folder</source>
        <translation>Name des neuen Ordners</translation>
    </message>
    <message>
        <source>No</source>
        <translation>Nein</translation>
    </message>
    <message>
        <source>Write over it</source>
        <translation>Überschreiben</translation>
    </message>
    <message>
        <source>Make the folder</source>
        <translation>Ordner anlegen</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Which files are shown</source>
        <translation>Welche Dateien gezeigt werden</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Choose this folder</source>
        <translation>Diesen Ordner wählen</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>The folder “%1” cannot be made.</source>
        <translation>Der Ordner „%1“ kann nicht angelegt werden.</translation>
    </message>
    <message>
        <source>There is nothing called “%1”.</source>
        <translation>Es gibt nichts, das „%1“ heißt.</translation>
    </message>
    <message>
        <source>Choose files only, or one folder to look into.</source>
        <translation>Wählen Sie nur Dateien, oder einen Ordner, um hineinzusehen.</translation>
    </message>
    <message>
        <source>Choose a file first.</source>
        <translation>Wählen Sie erst eine Datei.</translation>
    </message>
    <message>
        <source>Nothing can be written in “%1”. Choose another folder.</source>
        <translation>In „%1“ kann nichts geschrieben werden. Wählen Sie einen anderen Ordner.</translation>
    </message>
    <message>
        <source>Give the file a name.</source>
        <translation>Geben Sie der Datei einen Namen.</translation>
    </message>
</context>
<context>
    <name>FilesNotice</name>
    <message>
        <source>Keep</source>
        <translation>Behalten</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
    <message>
        <source>Throw away</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Save over it</source>
        <translation>Überschreiben</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Speichern unter …</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Später</translation>
    </message>
</context>
<context>
    <name>Finder</name>
    <message>
        <source>Coordinates, such as 48.1371, 11.5754</source>
        <translation>Koordinaten, etwa 48,1371; 11,5754</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>Handbuch</translation>
    </message>
    <message>
        <source>Sample field</source>
        <translation>Beispielschlag</translation>
    </message>
    <message>
        <source>example try</source>
        <translation>Beispiel ausprobieren</translation>
    </message>
    <message>
        <source>Fields</source>
        <translation>Schläge</translation>
    </message>
    <message>
        <source>field</source>
        <translation>Schlag</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Hinweise</translation>
    </message>
    <message>
        <source>finding</source>
        <translation>Hinweis</translation>
    </message>
    <message>
        <source>Go to %1</source>
        <translation>Gehe zu %1</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Karte</translation>
    </message>
</context>
<context>
    <name>FindingRow</name>
    <message>
        <source>Finding %1: %2 %3</source>
        <translation>Hinweis %1: %2 %3</translation>
    </message>
    <message>
        <source>Apply: %1</source>
        <translation>Anwenden: %1</translation>
    </message>
    <message>
        <source>For information</source>
        <translation>Zur Kenntnis</translation>
    </message>
    <message>
        <source>%1 of %2 of this kind</source>
        <translation>%1 von %2 dieser Art</translation>
    </message>
    <message>
        <source>The one before, of this kind (Ctrl+Shift+F8)</source>
        <translation>Der vorige dieser Art (Strg+Umschalt+F8)</translation>
    </message>
    <message>
        <source>The next of this kind (Ctrl+F8)</source>
        <translation>Der nächste dieser Art (Strg+F8)</translation>
    </message>
</context>
<context>
    <name>GuidePanel</name>
    <message>
        <source>All chapters</source>
        <translation>Alle Kapitel</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>Handbuch</translation>
    </message>
    <message>
        <source>Close the guide (Esc)</source>
        <translation>Handbuch schließen (Esc)</translation>
    </message>
    <message>
        <source>Search the guide</source>
        <translation>Im Handbuch suchen</translation>
    </message>
    <message>
        <source>Nothing is found. Try another word.</source>
        <translation>Nichts gefunden. Ein anderes Wort versuchen.</translation>
    </message>
</context>
<context>
    <name>HeadingChart</name>
    <message>
        <source>Time by</source>
        <translation>Zeit nach</translation>
    </message>
    <message>
        <source>direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>overlap</source>
        <translation>Überlappung</translation>
    </message>
    <message>
        <source>missed</source>
        <translation>Fehlstellen</translation>
    </message>
    <message>
        <source>turning</source>
        <translation>Wenden</translation>
    </message>
    <message>
        <source>Time by %1</source>
        <translation>Zeit nach %1</translation>
    </message>
    <message>
        <source>Directions of swaths and their times</source>
        <translation>Richtungen der Spuren und ihre Zeiten</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>%1 at least</source>
        <translation>mindestens %1</translation>
    </message>
    <message>
        <source>Estimates for the land inside the headland, to and fro. The plan adds headland, short passes and ways.</source>
        <translation>Schätzungen für das Land innerhalb des Vorgewendes, hin und her. Der Plan enthält auch Vorgewende, kurze Spuren und Wege.</translation>
    </message>
    <message>
        <source>Let Furrow search the direction</source>
        <translation>Richtung von Furrow suchen lassen</translation>
    </message>
</context>
<context>
    <name>HelpCommands</name>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>Handbuch</translation>
    </message>
    <message>
        <source>help manual how to documentation</source>
        <translation>Hilfe Anleitung Dokumentation wie</translation>
    </message>
    <message>
        <source>Take the tour</source>
        <translation>Rundgang starten</translation>
    </message>
    <message>
        <source>help introduction first start</source>
        <translation>Hilfe Einführung erster Start</translation>
    </message>
    <message>
        <source>Keys and mouse</source>
        <translation>Tasten und Maus</translation>
    </message>
    <message>
        <source>shortcuts help</source>
        <translation>tastenkürzel hilfe</translation>
    </message>
    <message>
        <source>Report a problem…</source>
        <translation>Ein Problem melden …</translation>
    </message>
    <message>
        <source>bug crash support error</source>
        <translation>Fehler Absturz Hilfe</translation>
    </message>
    <message>
        <source>About Furrow</source>
        <translation>Über Furrow</translation>
    </message>
    <message>
        <source>version licence credits</source>
        <translation>Version Lizenz Danksagung</translation>
    </message>
</context>
<context>
    <name>ImageryDialogs</name>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Add imagery</source>
        <translation>Luftbild hinzufügen</translation>
    </message>
    <message>
        <source>Pictures and heights (%1)</source>
        <translation>Bilder und Höhen (%1)</translation>
    </message>
    <message>
        <source>Add a folder of tiles</source>
        <translation>Ordner mit Kacheln hinzufügen</translation>
    </message>
</context>
<context>
    <name>ImageryList</name>
    <message>
        <source>Your own pictures and heights: GeoTIFF, MBTiles or a folder of tiles. They stay on this computer.</source>
        <translation>Ihre eigenen Bilder und Höhen: GeoTIFF, MBTiles oder ein Ordner mit Kacheln. Sie bleiben auf diesem Computer.</translation>
    </message>
    <message>
        <source>Add files…</source>
        <translation>Dateien hinzufügen …</translation>
    </message>
    <message>
        <source>Add a folder of tiles…</source>
        <translation>Ordner mit Kacheln hinzufügen …</translation>
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
        <translation>%1 ganz zeigen</translation>
    </message>
    <message>
        <source>Move %1 up</source>
        <translation>%1 nach oben</translation>
    </message>
    <message>
        <source>Move %1 down</source>
        <translation>%1 nach unten</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>%1 entfernen</translation>
    </message>
    <message>
        <source>How strong %1 is</source>
        <translation>Deckkraft von %1</translation>
    </message>
    <message>
        <source>Opening …</source>
        <translation>Wird geöffnet …</translation>
    </message>
    <message>
        <source>Contour lines every %1</source>
        <translation>Höhenlinien alle %1</translation>
    </message>
    <message>
        <source>Rows count from the south (TMS)</source>
        <translation>Zeilen zählen von Süden (TMS)</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Erneut versuchen</translation>
    </message>
</context>
<context>
    <name>Inspector</name>
    <message>
        <source>Headland</source>
        <translation>Vorgewende</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>boundary</source>
        <translation>Feldgrenze</translation>
    </message>
    <message>
        <source>hole</source>
        <translation>Aussparung</translation>
    </message>
    <message>
        <source>obstacle</source>
        <translation>Hindernis</translation>
    </message>
    <message>
        <source>guidance line</source>
        <translation>Leitlinie</translation>
    </message>
    <message>
        <source>Point %1 of the %2</source>
        <translation>Punkt %1 (%2)</translation>
    </message>
    <message>
        <source>Drag it on the map, move it by arrow keys, or type where it is.</source>
        <translation>Auf der Karte ziehen, mit den Pfeiltasten verschieben oder die Lage eintippen.</translation>
    </message>
    <message>
        <source>Latitude</source>
        <translation>Breitengrad</translation>
    </message>
    <message>
        <source>Longitude</source>
        <translation>Längengrad</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>AB line</source>
        <translation>AB-Linie</translation>
    </message>
    <message>
        <source>Edge %1 of the %2</source>
        <translation>Kante %1 (%2)</translation>
    </message>
    <message>
        <source>One swath lies on it, the others beside it. Drag it or its ends, or type its direction.</source>
        <translation>Eine Spur liegt darauf, die anderen daneben. Die Linie oder ihre Enden ziehen oder die Richtung eintippen.</translation>
    </message>
    <message>
        <source>Drag it to move it sideways; the dot in its middle makes another point.</source>
        <translation>Ziehen verschiebt sie seitlich; der Punkt in ihrer Mitte ergibt einen weiteren Eckpunkt.</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Obstacle</source>
        <translation>Hindernis</translation>
    </message>
    <message>
        <source>It is not worked, but may be driven on.</source>
        <translation>Es wird nicht bearbeitet, darf aber überfahren werden.</translation>
    </message>
    <message>
        <source>It is not worked, and nothing drives nearer than its buffer.</source>
        <translation>Es wird nicht bearbeitet, und nichts fährt näher heran als sein Abstand.</translation>
    </message>
    <message>
        <source>Buffer</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Overhang</source>
        <translation>Überstand</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>the end</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>swath %1</source>
        <translation>Spur %1</translation>
    </message>
    <message>
        <source>pass %1</source>
        <translation>Vorgewendespur %1</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Swath %1</source>
        <translation>Spur %1</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Headland pass %1</source>
        <translation>Vorgewendespur %1</translation>
    </message>
    <message>
        <source>Counted from the outside; %1 are worked here in %2.</source>
        <translation>Von außen gezählt; %1 werden hier in %2 bearbeitet.</translation>
    </message>
    <message>
        <source>Turn from %1 to %2</source>
        <translation>Wendung: %1 → %2</translation>
    </message>
    <message>
        <source>%1 in reverse, in %2.</source>
        <translation>%1 rückwärts, in %2.</translation>
    </message>
    <message>
        <source>%1 with the implement up, in %2.</source>
        <translation>%1 mit ausgehobenem Gerät, in %2.</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Way from %1 to %2</source>
        <translation>Weg: %1 → %2</translation>
    </message>
    <message>
        <source>%1 without working, in %2.</source>
        <translation>%1 ohne Arbeit, in %2.</translation>
    </message>
    <message>
        <source>It cannot be driven like this: %1.</source>
        <translation>So ist es nicht fahrbar: %1.</translation>
    </message>
    <message>
        <source>Block %1</source>
        <translation>Teilfläche %1</translation>
    </message>
    <message numerus="yes">
        <source>A piece of the field whose %n swath(s) are driven together.</source>
        <translation>
            <numerusform>Ein Stück der Innenfläche mit %n Spur.</numerusform>
            <numerusform>Ein Stück der Innenfläche, dessen %n Spuren zusammen gefahren werden.</numerusform>
        </translation>
    </message>
    <message>
        <source>Swaths</source>
        <translation>Spuren</translation>
    </message>
    <message>
        <source>Gate</source>
        <translation>Zufahrt</translation>
    </message>
    <message>
        <source>Here the machine may enter and leave the field. Drag it along the boundary.</source>
        <translation>Hier darf die Maschine in den Schlag und hinaus. Entlang der Feldgrenze ziehen.</translation>
    </message>
    <message>
        <source>Guidance curve</source>
        <translation>Leitkurve</translation>
    </message>
    <message>
        <source>The swaths lie beside it. Drag its points, or delete it.</source>
        <translation>Die Spuren liegen daneben. Die Punkte ziehen oder die Kurve löschen.</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Hole</source>
        <translation>Aussparung</translation>
    </message>
    <message>
        <source>It is no part of the field. Drag it, or its points and edges.</source>
        <translation>Sie gehört nicht zum Schlag. Sie selbst, ihre Punkte oder Kanten ziehen.</translation>
    </message>
    <message>
        <source>split line</source>
        <translation>Teilungslinie</translation>
    </message>
    <message>
        <source>The field inside the headland is cut along it, where it runs right through. Drag it or its points, or delete it.</source>
        <translation>Die Innenfläche wird an ihr geteilt, wo sie ganz hindurchgeht. Die Linie oder ihre Punkte ziehen oder sie löschen.</translation>
    </message>
    <message>
        <source>Split line %1</source>
        <translation>Teilungslinie %1</translation>
    </message>
    <message>
        <source>%1 with the implement folded, in %2.</source>
        <translation>%1 mit eingeklapptem Gerät, in %2.</translation>
    </message>
    <message>
        <source>Whole turn</source>
        <translation>Ganze Wendung</translation>
    </message>
    <message>
        <source>Driven as number %1 of %2: %3 in %4.</source>
        <translation>Gefahren als Nummer %1 von %2: %3 in %4.</translation>
    </message>
    <message>
        <source>From the edge</source>
        <translation>Vom Rand entfernt</translation>
    </message>
    <message>
        <source>Instead: %1</source>
        <translation>Stattdessen: %1</translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>etwa %1</translation>
    </message>
    <message>
        <source>no room</source>
        <translation>kein Platz</translation>
    </message>
    <message>
        <source>In the bunker</source>
        <translation>Im Bunker</translation>
    </message>
    <message>
        <source>In the tank</source>
        <translation>Im Tank</translation>
    </message>
    <message>
        <source>Then stands</source>
        <translation>Steht danach</translation>
    </message>
</context>
<context>
    <name>InspectorPanel</name>
    <message>
        <source>Headland as elsewhere</source>
        <translation>Vorgewende wie sonst</translation>
    </message>
    <message>
        <source>selected</source>
        <translation>ausgewählt</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>May be driven on</source>
        <translation>Darf überfahren werden</translation>
    </message>
    <message>
        <source>Swaths along it</source>
        <translation>Spuren daran entlang</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Drive from here</source>
        <translation>Ab hier fahren</translation>
    </message>
</context>
<context>
    <name>KeysDialog</name>
    <message>
        <source>Drag the map, wheel</source>
        <translation>Karte ziehen, Mausrad</translation>
    </message>
    <message>
        <source>move, zoom</source>
        <translation>verschieben, zoomen</translation>
    </message>
    <message>
        <source>Arrows, + and −</source>
        <translation>Pfeile, + und −</translation>
    </message>
    <message>
        <source>move the selection or the map, zoom</source>
        <translation>Auswahl oder Karte verschieben, zoomen</translation>
    </message>
    <message>
        <source>, and .</source>
        <translation>, und .</translation>
    </message>
    <message>
        <source>the point before, the next point</source>
        <translation>voriger, nächster Punkt</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Eingabe</translation>
    </message>
    <message>
        <source>finish drawing; type into the inspector</source>
        <translation>Zeichnung beenden; im Inspektor eintippen</translation>
    </message>
    <message>
        <source>Alt</source>
        <translation>Alt</translation>
    </message>
    <message>
        <source>no snapping while it is held</source>
        <translation>kein Einrasten, solange gedrückt</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>stop what was begun</source>
        <translation>abbrechen, was begonnen wurde</translation>
    </message>
    <message>
        <source>Keys and mouse</source>
        <translation>Tasten und Maus</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
</context>
<context>
    <name>LayerSwitches</name>
    <message>
        <source>Boundary</source>
        <translation>Feldgrenze</translation>
    </message>
    <message>
        <source>Headland</source>
        <translation>Vorgewende</translation>
    </message>
    <message>
        <source>Swaths</source>
        <translation>Spuren</translation>
    </message>
    <message>
        <source>Order numbers</source>
        <translation>Reihenfolge</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Hinweise</translation>
    </message>
    <message>
        <source>Imagery</source>
        <translation>Luftbild</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Fahrweg</translation>
    </message>
    <message>
        <source>Directions</source>
        <translation>Richtungen</translation>
    </message>
    <message>
        <source>Coverage</source>
        <translation>Bearbeitet</translation>
    </message>
    <message>
        <source>Worked twice</source>
        <translation>Doppelt bearbeitet</translation>
    </message>
    <message>
        <source>Missed</source>
        <translation>Fehlstellen</translation>
    </message>
    <message>
        <source>Wheel passes</source>
        <translation>Überfahrten</translation>
    </message>
    <message>
        <source>Swath numbers</source>
        <translation>Spurnummern</translation>
    </message>
</context>
<context>
    <name>LayersPanel</name>
    <message>
        <source>Layers</source>
        <translation>Ebenen</translation>
    </message>
    <message>
        <source>Close the layers</source>
        <translation>Ebenen schließen</translation>
    </message>
    <message>
        <source>Imagery</source>
        <translation>Luftbild</translation>
    </message>
    <message>
        <source>From the network</source>
        <translation>Aus dem Internet</translation>
    </message>
    <message>
        <source>OpenStreetMap</source>
        <translation>OpenStreetMap</translation>
    </message>
    <message>
        <source>Asks openstreetmap.org for what is in view. Off, nothing leaves this computer.</source>
        <translation>Fragt openstreetmap.org nach dem, was zu sehen ist. Ausgeschaltet verlässt nichts diesen Computer.</translation>
    </message>
</context>
<context>
    <name>MachineFields</name>
    <message>
        <source>Machine</source>
        <translation>Maschine</translation>
    </message>
    <message>
        <source>Back to the original</source>
        <translation>Zurück zum Original</translation>
    </message>
    <message>
        <source>Keep as your own…</source>
        <translation>Als eigene behalten …</translation>
    </message>
    <message>
        <source>Remove from your own</source>
        <translation>Aus den eigenen entfernen</translation>
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
        <translation>Schlag umbenennen</translation>
    </message>
    <message>
        <source>Add a plan</source>
        <translation>Plan hinzufügen</translation>
    </message>
    <message>
        <source>Rename the plan</source>
        <translation>Plan umbenennen</translation>
    </message>
    <message>
        <source>Add a plan to each field</source>
        <translation>Jedem Schlag einen Plan hinzufügen</translation>
    </message>
    <message>
        <source>Keep as a variant</source>
        <translation>Als Variante behalten</translation>
    </message>
    <message>
        <source>Keep the machine as</source>
        <translation>Maschine behalten als</translation>
    </message>
    <message>
        <source>This plan: %1</source>
        <translation>Dieser Plan: %1</translation>
    </message>
</context>
<context>
    <name>MapPage</name>
    <message>
        <source>Map</source>
        <translation>Karte</translation>
    </message>
</context>
<context>
    <name>MapToolBar</name>
    <message>
        <source>Select and change (V)</source>
        <translation>Auswählen und ändern (V)</translation>
    </message>
    <message>
        <source>Draw a field (B)</source>
        <translation>Schlag zeichnen (B)</translation>
    </message>
    <message>
        <source>Draw a hole (H)</source>
        <translation>Aussparung zeichnen (H)</translation>
    </message>
    <message>
        <source>Draw an obstacle (O)</source>
        <translation>Hindernis zeichnen (O)</translation>
    </message>
    <message>
        <source>Draw an AB line (L)</source>
        <translation>AB-Linie zeichnen (L)</translation>
    </message>
    <message>
        <source>Add a gate (G)</source>
        <translation>Zufahrt hinzufügen (G)</translation>
    </message>
    <message>
        <source>Show the whole field (F)</source>
        <translation>Ganzen Schlag zeigen (F)</translation>
    </message>
    <message>
        <source>Closer (+)</source>
        <translation>Näher heran (+)</translation>
    </message>
    <message>
        <source>Further away (−)</source>
        <translation>Weiter weg (−)</translation>
    </message>
    <message>
        <source>Layers (Ctrl+L)</source>
        <translation>Ebenen (Strg+L)</translation>
    </message>
    <message>
        <source>Draw a split line (S)</source>
        <translation>Teilungslinie zeichnen (S)</translation>
    </message>
</context>
<context>
    <name>NameDialog</name>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Season</source>
        <translation>Saison</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
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
        <translation>© OpenStreetMap-Mitwirkende</translation>
    </message>
</context>
<context>
    <name>OrderEditor</name>
    <message>
        <source>Change the order by hand…</source>
        <translation>Reihenfolge von Hand ändern …</translation>
    </message>
    <message>
        <source>Drag a swath to its new place. Or click swaths on the map: each is driven after the one clicked before.</source>
        <translation>Eine Spur an ihren neuen Platz ziehen. Oder Spuren auf der Karte anklicken: Jede folgt auf die zuvor angeklickte.</translation>
    </message>
    <message>
        <source>Order of swaths</source>
        <translation>Reihenfolge der Spuren</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Search the order of the others</source>
        <translation>Reihenfolge der anderen suchen</translation>
    </message>
    <message>
        <source>Search the order again</source>
        <translation>Reihenfolge neu suchen</translation>
    </message>
</context>
<context>
    <name>OrderForm</name>
    <message>
        <source>Status</source>
        <translation>Status</translation>
    </message>
</context>
<context>
    <name>OrderRow</name>
    <message>
        <source>%1. Swath %2, %3</source>
        <translation>%1. Spur %2, %3</translation>
    </message>
    <message>
        <source>Swath %1</source>
        <translation>Spur %1</translation>
    </message>
    <message>
        <source>Drive swath %1 the other way</source>
        <translation>Spur %1 andersherum fahren</translation>
    </message>
</context>
<context>
    <name>OtherMap</name>
    <message>
        <source>Map of the other plan: %1</source>
        <translation>Karte des anderen Plans: %1</translation>
    </message>
    <message>
        <source>The other plan is being made …</source>
        <translation>Der andere Plan wird gemacht …</translation>
    </message>
    <message>
        <source>The other: %1</source>
        <translation>Der andere: %1</translation>
    </message>
</context>
<context>
    <name>PageList</name>
    <message>
        <source>Pages</source>
        <translation>Seiten</translation>
    </message>
    <message>
        <source>Page %1 of %2</source>
        <translation>Seite %1 von %2</translation>
    </message>
    <message>
        <source>Planning for the pages …</source>
        <translation>Für die Seiten wird geplant …</translation>
    </message>
    <message>
        <source>Stopped before there were pages.</source>
        <translation>Angehalten, bevor es Seiten gab.</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Erneut versuchen</translation>
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
        <translation>%1: Furrow wählen lassen</translation>
    </message>
    <message>
        <source>as text</source>
        <translation>als Text</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen …</translation>
    </message>
    <message>
        <source>On the map</source>
        <translation>Auf der Karte</translation>
    </message>
    <message>
        <source>As text</source>
        <translation>Als Text</translation>
    </message>
    <message>
        <source>%1 as text</source>
        <translation>%1 als Text</translation>
    </message>
    <message>
        <source>not chosen</source>
        <translation>nicht gewählt</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>%1: remove</source>
        <translation>%1: entfernen</translation>
    </message>
</context>
<context>
    <name>Pickers</name>
    <message>
        <source>Click the place on the map. Esc ends it.</source>
        <translation>Die Stelle auf der Karte anklicken. Esc beendet es.</translation>
    </message>
    <message>
        <source>Click the places on the map</source>
        <translation>Klicken Sie die Stellen auf der Karte an</translation>
    </message>
    <message>
        <source>Click another place, or one of them to remove it</source>
        <translation>Klicken Sie eine weitere Stelle an, oder eine davon, um sie zu entfernen</translation>
    </message>
</context>
<context>
    <name>PlacesPicker</name>
    <message>
        <source>Place %1: remove it</source>
        <translation>Stelle %1: entfernen</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
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
        <translation>Abfahren</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>Durchsicht</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Hinweise</translation>
    </message>
    <message>
        <source>Add a plan…</source>
        <translation>Plan hinzufügen …</translation>
    </message>
    <message>
        <source>season operation copy</source>
        <translation>saison arbeitsgang kopie</translation>
    </message>
    <message>
        <source>Compare with another plan</source>
        <translation>Mit einem anderen Plan vergleichen</translation>
    </message>
    <message>
        <source>compare variants differences side by side better</source>
        <translation>vergleichen Varianten Unterschiede nebeneinander besser</translation>
    </message>
    <message>
        <source>Compare on two maps</source>
        <translation>Auf zwei Karten vergleichen</translation>
    </message>
    <message>
        <source>compare side by side split map</source>
        <translation>vergleichen nebeneinander geteilte Karte zwei</translation>
    </message>
    <message>
        <source>Compare with a recorded track…</source>
        <translation>Mit einer Aufzeichnung vergleichen …</translation>
    </message>
    <message>
        <source>driven recorded GPX NMEA log cross-track error compare</source>
        <translation>gefahren aufgezeichnet GPX NMEA Spurabweichung vergleichen</translation>
    </message>
    <message>
        <source>Rename the plan…</source>
        <translation>Plan umbenennen …</translation>
    </message>
    <message>
        <source>Remove the plan</source>
        <translation>Plan entfernen</translation>
    </message>
    <message>
        <source>delete</source>
        <translation>löschen</translation>
    </message>
    <message>
        <source>Plan again</source>
        <translation>Neu planen</translation>
    </message>
    <message>
        <source>Find the best plan…</source>
        <translation>Besten Plan suchen …</translation>
    </message>
    <message>
        <source>quickest optimise compare alternatives</source>
        <translation>schnellster optimieren vergleichen Alternativen</translation>
    </message>
    <message>
        <source>Change the order by hand…</source>
        <translation>Reihenfolge von Hand ändern …</translation>
    </message>
    <message>
        <source>order swaths list drag sequence</source>
        <translation>reihenfolge spuren liste ziehen folge</translation>
    </message>
    <message>
        <source>Drive through the plan</source>
        <translation>Plan abfahren</translation>
    </message>
    <message>
        <source>Pause the drive</source>
        <translation>Fahrt anhalten</translation>
    </message>
    <message>
        <source>drive play pause simulate machine</source>
        <translation>fahren abspielen anhalten simulieren Maschine</translation>
    </message>
    <message>
        <source>Drive from what is selected</source>
        <translation>Ab der Auswahl fahren</translation>
    </message>
    <message>
        <source>drive play here swath turn</source>
        <translation>fahren abspielen hier Spur Wendung</translation>
    </message>
    <message>
        <source>Drive faster</source>
        <translation>Schneller fahren</translation>
    </message>
    <message>
        <source>pace speed</source>
        <translation>Tempo Geschwindigkeit</translation>
    </message>
    <message>
        <source>Drive slower</source>
        <translation>Langsamer fahren</translation>
    </message>
    <message>
        <source>Comment on a place…</source>
        <translation>Stelle kommentieren …</translation>
    </message>
    <message>
        <source>review note remark pin</source>
        <translation>Durchsicht Notiz Bemerkung Stelle</translation>
    </message>
    <message>
        <source>Comment on the whole plan…</source>
        <translation>Ganzen Plan kommentieren …</translation>
    </message>
    <message>
        <source>review note remark</source>
        <translation>Durchsicht Notiz Bemerkung</translation>
    </message>
    <message>
        <source>contractor share file approve</source>
        <translation>Lohnunternehmer teilen Datei zustimmen</translation>
    </message>
    <message>
        <source>Take in a review that came back…</source>
        <translation>Zurückgekommene Durchsicht übernehmen …</translation>
    </message>
    <message>
        <source>merge comments contractor</source>
        <translation>zusammenführen Kommentare Lohnunternehmer</translation>
    </message>
    <message>
        <source>Next finding</source>
        <translation>Nächster Hinweis</translation>
    </message>
    <message>
        <source>problem check step through</source>
        <translation>Problem prüfen durchgehen</translation>
    </message>
    <message>
        <source>Previous finding</source>
        <translation>Voriger Hinweis</translation>
    </message>
    <message>
        <source>problem check step back</source>
        <translation>Problem prüfen zurück</translation>
    </message>
    <message>
        <source>Next finding of the same kind</source>
        <translation>Nächster Hinweis derselben Art</translation>
    </message>
    <message>
        <source>Previous finding of the same kind</source>
        <translation>Voriger Hinweis derselben Art</translation>
    </message>
</context>
<context>
    <name>PlanTitle</name>
    <message>
        <source>%1 wide</source>
        <translation>%1 breit</translation>
    </message>
    <message>
        <source>takes %1</source>
        <translation>dauert %1</translation>
    </message>
    <message>
        <source>planned %1</source>
        <translation>geplant %1</translation>
    </message>
</context>
<context>
    <name>Planner</name>
    <message>
        <source> and twice %1 of margin</source>
        <translation> und zweimal %1 Sicherheitsabstand</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 und %2</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 und %2 weitere</translation>
    </message>
    <message>
        <source>%1 are driven in reverse; the trailed implement cannot.</source>
        <translation>%1 werden rückwärts gefahren; das gezogene Gerät kann das nicht.</translation>
    </message>
    <message>
        <source>%1 are driven in reverse; this machine cannot.</source>
        <translation>%1 werden rückwärts gefahren; diese Maschine kann das nicht.</translation>
    </message>
    <message>
        <source>%1 are not worked, %2 of the field, in %3; this is the largest.</source>
        <translation>%1 werden nicht bearbeitet, %2 des Schlags, in %3; dies ist die größte Fehlstelle.</translation>
    </message>
    <message>
        <source>%1 bends with a radius of %2; this machine needs %3.</source>
        <translation>%1 hat Kurven mit %2 Radius; diese Maschine braucht %3.</translation>
    </message>
    <message>
        <source>%1 cannot be driven: %2.</source>
        <translation>%1 ist nicht fahrbar: %2.</translation>
    </message>
    <message>
        <source>%1 cannot be made: %2</source>
        <translation>%1 kann nicht erstellt werden: %2</translation>
    </message>
    <message>
        <source>%1 crosses an obstacle, by %2.</source>
        <translation>%1 ragt %2 in ein Hindernis hinein.</translation>
    </message>
    <message>
        <source>%1 crosses an obstacle.</source>
        <translation>%1 quert ein Hindernis.</translation>
    </message>
    <message>
        <source>%1 does not fit here</source>
        <translation>%1 passt hier nicht</translation>
    </message>
    <message>
        <source>%1 for transport is wider than the machine at work, %2</source>
        <translation>%1 für den Transport ist breiter als die Maschine bei der Arbeit, %2</translation>
    </message>
    <message>
        <source>%1 holds no positions</source>
        <translation>%1 enthält keine Positionen</translation>
    </message>
    <message>
        <source>%1 in one piece are not worked.</source>
        <translation>%1 an einem Stück werden nicht bearbeitet.</translation>
    </message>
    <message>
        <source>%1 is %2 wide; this machine is %3 wide for transport.</source>
        <translation>%1 ist %2 breit; diese Maschine ist für den Transport %3 breit.</translation>
    </message>
    <message>
        <source>%1 is not a whole number</source>
        <translation>%1 ist keine ganze Zahl</translation>
    </message>
    <message>
        <source>%1 is on the stick already</source>
        <translation>%1 ist schon auf dem Stick</translation>
    </message>
    <message>
        <source>%1 is out of range</source>
        <translation>%1 liegt außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>%1 is planned, but nothing of it is driven with the implement down.</source>
        <translation>%1 ist geplant, aber nichts davon wird mit abgesenktem Gerät gefahren.</translation>
    </message>
    <message>
        <source>%1 is planned, but only %2 of it is driven with the implement down.</source>
        <translation>%1 ist geplant, aber nur %2 davon werden mit abgesenktem Gerät gefahren.</translation>
    </message>
    <message>
        <source>%1 jumps by %2.</source>
        <translation>%1 springt um %2.</translation>
    </message>
    <message>
        <source>%1 leads from one part of the field to another that this machine cannot drive to.</source>
        <translation>%1 führt von einem Teil des Schlags in einen anderen, den diese Maschine nicht erreicht.</translation>
    </message>
    <message>
        <source>%1 leaves the field by %2.</source>
        <translation>%1 verlässt den Schlag um %2.</translation>
    </message>
    <message>
        <source>%1 leaves the field or crosses an obstacle, by up to %2, as this plan allows.</source>
        <translation>%1 verlässt den Schlag oder quert ein Hindernis, um bis zu %2, wie in diesem Plan erlaubt.</translation>
    </message>
    <message>
        <source>%1 moves %2 off where the machine points.</source>
        <translation>%1 weicht um %2 von der Richtung ab, in die die Maschine zeigt.</translation>
    </message>
    <message>
        <source>%1 needs %2</source>
        <translation>%1 braucht: %2</translation>
    </message>
    <message>
        <source>%1 of %2 guidance lines of &apos;%3&apos; are there</source>
        <translation>%1 von %2 Leitlinien von „%3“ sind da</translation>
    </message>
    <message>
        <source>%1 of %2 swaths are not in the order: %3</source>
        <translation>%1 von %2 Spuren fehlen in der Reihenfolge: %3</translation>
    </message>
    <message>
        <source>%1 of %2 tracks are of another place and were left out</source>
        <translation>%1 von %2 Aufzeichnungen sind von anderswo und wurden weggelassen</translation>
    </message>
    <message>
        <source>%1 of its sentences have a wrong checksum</source>
        <translation>%1 ihrer Sätze haben eine falsche Prüfsumme</translation>
    </message>
    <message>
        <source>%1 of margin leaves nothing of the field to work</source>
        <translation>bei %1 Sicherheitsabstand bleibt vom Schlag nichts zu bearbeiten</translation>
    </message>
    <message>
        <source>%1 of the positions jump away and back</source>
        <translation>%1 der Positionen springen weg und zurück</translation>
    </message>
    <message>
        <source>%1 reads back other bytes than were written</source>
        <translation>%1 liefert andere Bytes zurück, als geschrieben wurden</translation>
    </message>
    <message>
        <source>%1 small patches of worked pixels are left out</source>
        <translation>%1 kleine Flecken bearbeiteter Pixel werden weggelassen</translation>
    </message>
    <message>
        <source>%1 swaths and turns leave the field or cross an obstacle, by up to %2, as this plan allows.</source>
        <translation>%1 Spuren und Wendungen verlassen den Schlag oder queren ein Hindernis, um bis zu %2, wie in diesem Plan erlaubt.</translation>
    </message>
    <message>
        <source>%1, %2 is more than 1,000 km from the plan</source>
        <translation>%1, %2 ist mehr als 1.000 km vom Plan entfernt</translation>
    </message>
    <message>
        <source>%1, %2 is no longitude and latitude</source>
        <translation>%1, %2 ist kein Längen- und Breitengrad</translation>
    </message>
    <message>
        <source>%1, %2 is no longitude and latitude, and the file does not say which coordinate system it uses</source>
        <translation>%1, %2 ist kein Längen- und Breitengrad, und die Datei sagt nicht, welches Koordinatensystem sie hat</translation>
    </message>
    <message>
        <source>%1, %2 is outside longitude -180 to 180 and latitude -90 to 90</source>
        <translation>%1, %2 liegt außerhalb der Längengrade -180 bis 180 und Breitengrade -90 bis 90</translation>
    </message>
    <message>
        <source>%1, %2, line %3</source>
        <translation>%1, %2, Zeile %3</translation>
    </message>
    <message>
        <source>%1, %2, point %3</source>
        <translation>%1, %2, Punkt %3</translation>
    </message>
    <message>
        <source>%1, byte %2</source>
        <translation>%1, Byte %2</translation>
    </message>
    <message>
        <source>%1, feature %2</source>
        <translation>%1, Objekt %2</translation>
    </message>
    <message>
        <source>%1, gate %2</source>
        <translation>%1, Zufahrt %2</translation>
    </message>
    <message>
        <source>%1, hole %2</source>
        <translation>%1, Aussparung %2</translation>
    </message>
    <message>
        <source>%1, line %2</source>
        <translation>%1, Zeile %2</translation>
    </message>
    <message>
        <source>%1, obstacle %2</source>
        <translation>%1, Hindernis %2</translation>
    </message>
    <message>
        <source>%1, point %2</source>
        <translation>%1, Punkt %2</translation>
    </message>
    <message>
        <source>%1, row %2</source>
        <translation>%1, Zeile %2</translation>
    </message>
    <message>
        <source>%1.bin is not there</source>
        <translation>%1.bin fehlt</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: the setting %2 is not used: %3</source>
        <translation>%1: die Einstellung %2 wird nicht verwendet: %3</translation>
    </message>
    <message>
        <source>%1; %2 × other turns</source>
        <translation>%1; %2 × andere Wendungen</translation>
    </message>
    <message>
        <source>%1; what it belongs to was left out</source>
        <translation>%1; wozu es gehört, wurde ausgelassen</translation>
    </message>
    <message numerus="yes">
        <source>%n areas are neither field, hole nor obstacle by their layer or kind and were not used</source>
        <translation>
            <numerusform>%n Fläche ist nach Ebene oder Art weder Schlag, Aussparung noch Hindernis und wurde nicht verwendet</numerusform>
            <numerusform>%n Flächen sind nach Ebene oder Art weder Schlag, Aussparung noch Hindernis und wurden nicht verwendet</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n areas in the file are neither field nor obstacle and were not used</source>
        <translation>
            <numerusform>%n Fläche in der Datei ist weder Schlag noch Hindernis und wurde nicht verwendet</numerusform>
            <numerusform>%n Flächen in der Datei sind weder Schlag noch Hindernis und wurden nicht verwendet</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n damaged lines were passed over</source>
        <translation>
            <numerusform>%n beschädigte Zeile wurde übergangen</numerusform>
            <numerusform>%n beschädigte Zeilen wurden übergangen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n entries without a shape</source>
        <translation>
            <numerusform>%n Eintrag ohne Form</numerusform>
            <numerusform>%n Einträge ohne Form</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n fields</source>
        <translation>
            <numerusform>%n Schlag</numerusform>
            <numerusform>%n Schläge</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n messages without a position were passed over</source>
        <translation>
            <numerusform>%n Nachricht ohne Position wurde übergangen</numerusform>
            <numerusform>%n Nachrichten ohne Position wurden übergangen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n open lines</source>
        <translation>
            <numerusform>%n offene Linie</numerusform>
            <numerusform>%n offene Linien</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n passes</source>
        <translation>
            <numerusform>%n Spur</numerusform>
            <numerusform>%n Spuren</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pieces</source>
        <translation>
            <numerusform>%n Stück</numerusform>
            <numerusform>%n Stücken</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n places</source>
        <translation>
            <numerusform>%n Stelle</numerusform>
            <numerusform>%n Stellen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n points</source>
        <translation>
            <numerusform>%n Punkt</numerusform>
            <numerusform>%n Punkte</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n points were given twice and taken once</source>
        <translation>
            <numerusform>%n Punkt war doppelt und zählt einmal</numerusform>
            <numerusform>%n Punkte waren doppelt und zählen einmal</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n positions that jumped away were left out</source>
        <translation>
            <numerusform>%n Position, die wegsprang, wurde weggelassen</numerusform>
            <numerusform>%n Positionen, die wegsprangen, wurden weggelassen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n records without a position were passed over</source>
        <translation>
            <numerusform>%n Eintrag ohne Position wurde übergangen</numerusform>
            <numerusform>%n Einträge ohne Position wurden übergangen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n reports without a position were passed over</source>
        <translation>
            <numerusform>%n Meldung ohne Position wurde übergangen</numerusform>
            <numerusform>%n Meldungen ohne Position wurden übergangen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n rings did not end where they began and were closed</source>
        <translation>
            <numerusform>%n Ring endete nicht, wo er begann, und wurde geschlossen</numerusform>
            <numerusform>%n Ringe endeten nicht, wo sie begannen, und wurden geschlossen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n rings ran the wrong way round and were turned</source>
        <translation>
            <numerusform>%n Ring lief falsch herum und wurde umgedreht</numerusform>
            <numerusform>%n Ringe liefen falsch herum und wurden umgedreht</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n rows without a position were passed over</source>
        <translation>
            <numerusform>%n Zeile ohne Position wurde übergangen</numerusform>
            <numerusform>%n Zeilen ohne Position wurden übergangen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sentences with a wrong checksum were passed over</source>
        <translation>
            <numerusform>%n Satz mit falscher Prüfsumme wurde übergangen</numerusform>
            <numerusform>%n Sätze mit falscher Prüfsumme wurden übergangen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sentences without a position were passed over</source>
        <translation>
            <numerusform>%n Satz ohne Position wurde übergangen</numerusform>
            <numerusform>%n Sätze ohne Position wurden übergangen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n spikes without area were removed</source>
        <translation>
            <numerusform>%n Spitze ohne Fläche wurde entfernt</numerusform>
            <numerusform>%n Spitzen ohne Fläche wurden entfernt</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n stretches of one strip were left out, as ways to the field: %1 together</source>
        <translation>
            <numerusform>%n Stück aus einem einzigen Streifen wurde als Weg zum Feld weggelassen: %1</numerusform>
            <numerusform>%n Stücke aus einem einzigen Streifen wurden als Wege zum Feld weggelassen: zusammen %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n turns</source>
        <translation>
            <numerusform>%n Wendung</numerusform>
            <numerusform>%n Wendungen</numerusform>
        </translation>
    </message>
    <message>
        <source>&apos;%1&apos; files hold no recorded track</source>
        <translation>„%1“-Dateien enthalten keine aufgezeichnete Fahrt</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is left out: its kind %2 is not known</source>
        <translation>„%1“ wird weggelassen: die Art %2 ist nicht bekannt</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no length</source>
        <translation>„%1“ ist keine Länge</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no local frame</source>
        <translation>„%1“ ist kein lokales Koordinatensystem</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not %2</source>
        <translation>„%1“ ist nicht: %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a line</source>
        <translation>„%1“ ist keine Linie</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not well-known text</source>
        <translation>„%1“ ist kein Well-known text</translation>
    </message>
    <message>
        <source>&apos;%1&apos;, &apos;%2&apos; is no latitude and longitude</source>
        <translation>„%1“, „%2“ ist kein Breiten- und Längengrad</translation>
    </message>
    <message>
        <source>&apos;%1&apos;, &apos;%2&apos; is no longitude and latitude</source>
        <translation>„%1“, „%2“ ist kein Längen- und Breitengrad</translation>
    </message>
    <message>
        <source>&apos;%1&apos;, &apos;%2&apos; is no position</source>
        <translation>„%1“, „%2“ ist keine Position</translation>
    </message>
    <message>
        <source>A and B are %1 apart</source>
        <translation>A und B liegen %1 auseinander</translation>
    </message>
    <message>
        <source>A bulb to both sides; for swaths nearer than two turning radii.</source>
        <translation>Nach beiden Seiten ausgebaucht; für Spuren, die näher als zwei Wenderadien liegen.</translation>
    </message>
    <message>
        <source>A bulb to one side and straight back; for swaths nearer than two turning radii.</source>
        <translation>Nach einer Seite ausgebaucht und gerade zurück; für Spuren, die näher als zwei Wenderadien liegen.</translation>
    </message>
    <message>
        <source>A block gets a heading of its own where that saves time.</source>
        <translation>Eine Teilfläche erhält eine eigene Fahrtrichtung, wo das Zeit spart.</translation>
    </message>
    <message>
        <source>A file of lines: planted rows, or the tramlines of a plan.</source>
        <translation>Eine Datei mit Linien: gepflanzte Reihen oder die Fahrgassen eines Plans.</translation>
    </message>
    <message>
        <source>A gate&apos;s name or a point; the first gate where nothing is given.</source>
        <translation>Name einer Zufahrt oder ein Punkt; die erste Zufahrt, wo nichts angegeben ist.</translation>
    </message>
    <message>
        <source>A goal of opennav_coverage has one outline: %1 of %2 parts are left out.</source>
        <translation>Ein Ziel von opennav_coverage hat einen Umriss: %1 von %2 Teilen fehlen.</translation>
    </message>
    <message>
        <source>A raster of heights in metres that covers the field, such as a GeoTIFF.</source>
        <translation>Ein Höhenraster in Metern, das den Schlag abdeckt, zum Beispiel ein GeoTIFF.</translation>
    </message>
    <message>
        <source>A robot with ROS 2</source>
        <translation>Ein Roboter mit ROS 2</translation>
    </message>
    <message>
        <source>A snake within each cluster of swaths, cluster after cluster.</source>
        <translation>Eine Schlange in jeder Gruppe von Spuren, Gruppe nach Gruppe.</translation>
    </message>
    <message>
        <source>A strip of the same width along the boundary and around obstacles, for turning.</source>
        <translation>Ein gleich breiter Streifen entlang der Feldgrenze und um Hindernisse, zum Wenden.</translation>
    </message>
    <message>
        <source>A+</source>
        <translation>A+</translation>
    </message>
    <message>
        <source>AB curve</source>
        <translation>AB-Kurve</translation>
    </message>
    <message>
        <source>AB line</source>
        <translation>AB-Linie</translation>
    </message>
    <message>
        <source>Across the slope: beside a line of equal height, and a new one where that no longer fits.</source>
        <translation>Quer zum Hang: neben einer Höhenlinie, und einer neuen, wo das nicht mehr passt.</translation>
    </message>
    <message>
        <source>After the swaths</source>
        <translation>Nach den Spuren</translation>
    </message>
    <message>
        <source>AgBot</source>
        <translation>AgBot</translation>
    </message>
    <message>
        <source>AgGPS folder</source>
        <translation>AgGPS-Ordner</translation>
    </message>
    <message>
        <source>AgOpenGPS 6, import of ISOXML</source>
        <translation>AgOpenGPS 6, ISOXML-Import</translation>
    </message>
    <message>
        <source>AgOpenGPS drives recorded paths forwards only, and this one reverses %1 times: its %2 forward stretches are &apos;Part 01.rec&apos; and so on, RecPath.txt is the first; %3 under 5 m are left out.</source>
        <translation>AgOpenGPS fährt aufgezeichnete Wege nur vorwärts, und dieser fährt %1-mal rückwärts: seine %2 Vorwärtsstücke sind „Part 01.rec“ und so weiter, RecPath.txt ist das erste; %3 unter 5 m fehlen.</translation>
    </message>
    <message>
        <source>AgOpenGPS field</source>
        <translation>AgOpenGPS-Schlag</translation>
    </message>
    <message>
        <source>AgOpenGPS keeps one outline to a field: the %1 parts of &apos;%2&apos; are fields of their own, and the whole path is in the first.</source>
        <translation>AgOpenGPS kennt einen Umriss je Schlag: die %1 Teile von „%2“ sind eigene Schläge, und der ganze Fahrweg liegt im ersten.</translation>
    </message>
    <message>
        <source>AgOpenGPS keeps one outline to a field: the %1 parts of &apos;%2&apos; are fields of their own.</source>
        <translation>AgOpenGPS kennt einen Umriss je Schlag: die %1 Teile von „%2“ sind eigene Schläge.</translation>
    </message>
    <message>
        <source>All swaths along the edge of the boundary that you pick.</source>
        <translation>Alle Spuren entlang der ausgewählten Kante der Feldgrenze.</translation>
    </message>
    <message>
        <source>All swaths along the longest straight edge inside the headland.</source>
        <translation>Alle Spuren entlang der längsten geraden Kante der Innenfläche.</translation>
    </message>
    <message>
        <source>All swaths in the direction that you type.</source>
        <translation>Alle Spuren in der eingetippten Richtung.</translation>
    </message>
    <message>
        <source>Along an edge</source>
        <translation>Entlang einer Kante</translation>
    </message>
    <message>
        <source>Along each edge as wide as the turns there need it; a single pass where no swath ends, or nothing if it is not worked.</source>
        <translation>An jeder Kante so breit, wie die Wendungen dort es brauchen; eine einzige Vorgewendespur, wo keine Spur endet, oder nichts, wenn das Vorgewende nicht bearbeitet wird.</translation>
    </message>
    <message>
        <source>Along rows that are there already, or between them.</source>
        <translation>Entlang von Reihen, die schon da sind, oder zwischen ihnen.</translation>
    </message>
    <message>
        <source>Along the boundary</source>
        <translation>An der Feldgrenze entlang</translation>
    </message>
    <message>
        <source>Along the contours</source>
        <translation>Entlang der Höhenlinien</translation>
    </message>
    <message>
        <source>Along the direction of travel.</source>
        <translation>In Fahrtrichtung.</translation>
    </message>
    <message>
        <source>Along the headland</source>
        <translation>Auf dem Vorgewende</translation>
    </message>
    <message>
        <source>Along the line from A to B; one swath lies on it.</source>
        <translation>Entlang der Linie von A nach B; eine Spur liegt darauf.</translation>
    </message>
    <message>
        <source>Along the longest edge</source>
        <translation>Entlang der längsten Kante</translation>
    </message>
    <message>
        <source>An older ISOBUS terminal</source>
        <translation>Ein älteres ISOBUS-Terminal</translation>
    </message>
    <message>
        <source>Another ISOBUS terminal</source>
        <translation>Ein anderes ISOBUS-Terminal</translation>
    </message>
    <message>
        <source>Anywhere</source>
        <translation>Überall</translation>
    </message>
    <message>
        <source>Arc, straight, arc; for swaths at least two turning radii apart.</source>
        <translation>Bogen, Gerade, Bogen; für Spuren, die mindestens zwei Wenderadien auseinander liegen.</translation>
    </message>
    <message>
        <source>Choose the best that fits, which takes the quickest everywhere.</source>
        <translation>Die beste passende Wendung wählen: sie nimmt überall die schnellste.</translation>
    </message>
    <message>
        <source>Joined where that is quicker</source>
        <translation>Verbunden, wo es schneller ist</translation>
    </message>
    <message>
        <source>As few swaths, and so turns, as possible.</source>
        <translation>So wenige Spuren, und damit Wendungen, wie möglich.</translation>
    </message>
    <message>
        <source>At obstacles</source>
        <translation>An Hindernissen</translation>
    </message>
    <message>
        <source>At the left edge</source>
        <translation>Am linken Rand</translation>
    </message>
    <message>
        <source>At the right edge</source>
        <translation>Am rechten Rand</translation>
    </message>
    <message>
        <source>At the start of the first swath.</source>
        <translation>Am Anfang der ersten Spur.</translation>
    </message>
    <message>
        <source>Before the swaths</source>
        <translation>Vor den Spuren</translation>
    </message>
    <message>
        <source>Beside a curve of your own, or beside the edges around the one that you pick.</source>
        <translation>Neben einer eigenen Kurve oder neben den Kanten um die ausgewählte.</translation>
    </message>
    <message>
        <source>Best heading</source>
        <translation>Beste Fahrtrichtung</translation>
    </message>
    <message>
        <source>Best of all headings</source>
        <translation>Beste aller Richtungen</translation>
    </message>
    <message>
        <source>Best that fits</source>
        <translation>Beste, die passt</translation>
    </message>
    <message>
        <source>Between the fixed and the steered axle.</source>
        <translation>Zwischen der starren und der gelenkten Achse.</translation>
    </message>
    <message>
        <source>Between the headings that are tried.</source>
        <translation>Zwischen den Richtungen, die versucht werden.</translation>
    </message>
    <message>
        <source>Between the rows</source>
        <translation>Zwischen den Reihen</translation>
    </message>
    <message>
        <source>Boundaries in longitude and latitude.</source>
        <translation>Feldgrenzen in Längen- und Breitengraden.</translation>
    </message>
    <message>
        <source>Boundaries, also field files of Fields2Cover and GAOS.</source>
        <translation>Feldgrenzen, auch Schlagdateien von Fields2Cover und GAOS.</translation>
    </message>
    <message>
        <source>Boundaries.</source>
        <translation>Feldgrenzen.</translation>
    </message>
    <message>
        <source>Boundary and guidance lines for Trimble and FM displays; no driving order.</source>
        <translation>Feldgrenze und Leitlinien für Trimble- und FM-Displays; keine Reihenfolge.</translation>
    </message>
    <message>
        <source>Boundary, headland, heading and order; the robot lays swaths and turns itself.</source>
        <translation>Feldgrenze, Vorgewende, Fahrtrichtung und Reihenfolge; Spuren und Wendungen legt der Roboter selbst.</translation>
    </message>
    <message>
        <source>Boundary, holes, headland, guidance lines, and the whole driven path as a recorded path.</source>
        <translation>Feldgrenze, Aussparungen, Vorgewende, Leitlinien und der ganze Fahrweg als aufgezeichneter Weg.</translation>
    </message>
    <message>
        <source>Boundary, holes, obstacles and guidance lines for older terminals; no headland, no driving order.</source>
        <translation>Feldgrenze, Aussparungen, Hindernisse und Leitlinien für ältere Terminals; kein Vorgewende, keine Reihenfolge.</translation>
    </message>
    <message>
        <source>Boundary, holes, obstacles, gates, headland and guidance lines for terminals; no driving order.</source>
        <translation>Feldgrenze, Aussparungen, Hindernisse, Zufahrten, Vorgewende und Leitlinien für Terminals; keine Reihenfolge.</translation>
    </message>
    <message>
        <source>Boundary, holes, obstacles, headland, swaths and path in metres of the UTM zone.</source>
        <translation>Feldgrenze, Aussparungen, Hindernisse, Vorgewende, Spuren und Fahrweg in Metern der UTM-Zone.</translation>
    </message>
    <message>
        <source>Boundary, obstacles, gates, headland, swaths and path, to look at.</source>
        <translation>Feldgrenze, Hindernisse, Zufahrten, Vorgewende, Spuren und Fahrweg zum Ansehen.</translation>
    </message>
    <message>
        <source>Boundary, obstacles, gates, headland, swaths, path and findings; for maps and programs.</source>
        <translation>Feldgrenze, Hindernisse, Zufahrten, Vorgewende, Spuren, Fahrweg und Hinweise; für Karten und Programme.</translation>
    </message>
    <message>
        <source>Boundary, obstacles, gates, inside of the headland, swaths and path as layers for a GIS.</source>
        <translation>Feldgrenze, Hindernisse, Zufahrten, Innenfläche, Spuren und Fahrweg als Ebenen für ein GIS.</translation>
    </message>
    <message>
        <source>Boundary, obstacles, gates, inside of the headland, swaths and path, a shapefile of each.</source>
        <translation>Feldgrenze, Hindernisse, Zufahrten, Innenfläche, Spuren und Fahrweg, je ein Shapefile.</translation>
    </message>
    <message>
        <source>Bringing the crop in: headland first, swaths overlap a little.</source>
        <translation>Ernte einbringen: Vorgewende zuerst, Spuren überlappen etwas.</translation>
    </message>
    <message>
        <source>CSV table</source>
        <translation>CSV-Tabelle</translation>
    </message>
    <message>
        <source>Can reverse</source>
        <translation>Kann rückwärts fahren</translation>
    </message>
    <message>
        <source>Can turn in place</source>
        <translation>Kann auf der Stelle drehen</translation>
    </message>
    <message>
        <source>Carried by the tractor, or pulled on a hitch and following its own track.</source>
        <translation>Vom Schlepper getragen oder an einer Anhängung gezogen mit eigener Spur.</translation>
    </message>
    <message>
        <source>Blocks</source>
        <translation>Teilflächen</translation>
    </message>
    <message>
        <source>Centre line</source>
        <translation>Mittellinie</translation>
    </message>
    <message>
        <source>Check that the machine stays inside the field while it turns.</source>
        <translation>Prüfen, ob die Maschine beim Wenden im Schlag bleibt.</translation>
    </message>
    <message>
        <source>Choose another place.</source>
        <translation>Eine andere Stelle wählen.</translation>
    </message>
    <message>
        <source>Circles</source>
        <translation>Kreise</translation>
    </message>
    <message>
        <source>Clockwise</source>
        <translation>Im Uhrzeigersinn</translation>
    </message>
    <message>
        <source>Cluster</source>
        <translation>Gruppe</translation>
    </message>
    <message>
        <source>Combine harvester, 7.5 m header</source>
        <translation>Mähdrescher, Schneidwerk 7,5 m</translation>
    </message>
    <message>
        <source>Corners</source>
        <translation>Ecken</translation>
    </message>
    <message>
        <source>Counter-clockwise</source>
        <translation>Gegen den Uhrzeigersinn</translation>
    </message>
    <message>
        <source>Crop protection: headland first, ways along the headland.</source>
        <translation>Pflanzenschutz: Vorgewende zuerst, Wege auf dem Vorgewende.</translation>
    </message>
    <message>
        <source>Curves are driven with up to %1 sideways; the machine&apos;s limit is less.</source>
        <translation>Kurven werden mit bis zu %1 quer gefahren; die Grenze der Maschine ist niedriger.</translation>
    </message>
    <message>
        <source>Curves with reversing</source>
        <translation>Kurven mit Rückwärtsfahrt</translation>
    </message>
    <message>
        <source>Curves with reversing, smooth steering</source>
        <translation>Kurven mit Rückwärtsfahrt, sanft gelenkt</translation>
    </message>
    <message>
        <source>Cut along the swaths at every corner, sharp or rounded.</source>
        <translation>An jeder Ecke entlang der Spuren geteilt, ob spitz oder gerundet.</translation>
    </message>
    <message>
        <source>Cut along the swaths where an obstacle or a bay begins or ends.</source>
        <translation>Entlang der Spuren geteilt, wo ein Hindernis oder eine Bucht beginnt oder endet.</translation>
    </message>
    <message>
        <source>Cut where an obstacle or a bay begins or ends, and joined again where that saves turns and ways.</source>
        <translation>Geteilt, wo ein Hindernis oder eine Bucht beginnt oder endet, und wieder verbunden, wo das Wendungen und Wege spart.</translation>
    </message>
    <message>
        <source>Cutting grass: headland first, swaths overlap a little.</source>
        <translation>Gras mähen: Vorgewende zuerst, Spuren überlappen etwas.</translation>
    </message>
    <message>
        <source>DXF drawing</source>
        <translation>DXF-Zeichnung</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Drawn out until the whole width is covered, as far as there is room.</source>
        <translation>Verlängert, bis die ganze Breite bearbeitet ist, soweit Platz ist.</translation>
    </message>
    <message>
        <source>Drilling or planting: headland last, ways along the headland.</source>
        <translation>Drillen oder Legen: Vorgewende zuletzt, Wege auf dem Vorgewende.</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>Fahren</translation>
    </message>
    <message>
        <source>Drive the curves more slowly.</source>
        <translation>Die Kurven langsamer fahren.</translation>
    </message>
    <message>
        <source>Drives the path from waypoint to waypoint, rounding corners its own way; relay 1 is on where the implement works. Not tested on the machine by us.</source>
        <translation>Fährt von Wegpunkt zu Wegpunkt und rundet Ecken auf seine Weise; Relais 1 ist eingeschaltet, wo das Gerät arbeitet. Von uns nicht an der Maschine geprüft.</translation>
    </message>
    <message>
        <source>Drives the whole path, turns included, as a recorded path; stretches in reverse gear are left to the driver. Shows boundary, headland and guidance lines. Copy the field&apos;s folder to Documents/AgOpenGPS/Fields.</source>
        <translation>Fährt den ganzen Weg mit Wendungen als aufgezeichneten Weg; Stücke im Rückwärtsgang bleiben dem Fahrer. Zeigt Feldgrenze, Vorgewende und Leitlinien. Den Ordner des Schlags nach Documents/AgOpenGPS/Fields kopieren.</translation>
    </message>
    <message>
        <source>Each its own</source>
        <translation>Jede ihre eigene</translation>
    </message>
    <message>
        <source>Edge</source>
        <translation>Kante</translation>
    </message>
    <message>
        <source>Edge directions and every tenth of a degree, refined; says when nothing better exists.</source>
        <translation>Richtungen der Kanten und jedes Zehntelgrad, verfeinert; sagt, wenn es nichts Besseres gibt.</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>Ends</source>
        <translation>Enden</translation>
    </message>
    <message>
        <source>Every how many swaths a wider machine will drive again; 0 for none.</source>
        <translation>Nach wie vielen Spuren eine breitere Maschine wieder fährt; 0 für keine.</translation>
    </message>
    <message>
        <source>Every sample of the path; without a plan boundaries as WKT, or as points.</source>
        <translation>Jeder Punkt des Fahrwegs; ohne Plan Feldgrenzen als WKT oder als Punkte.</translation>
    </message>
    <message>
        <source>Every second swath on the way out, the others on the way back.</source>
        <translation>Jede zweite Spur auf dem Hinweg, die anderen auf dem Rückweg.</translation>
    </message>
    <message>
        <source>Every swath after its neighbour, back and forth.</source>
        <translation>Jede Spur nach ihrer Nachbarin, hin und zurück.</translation>
    </message>
    <message>
        <source>Fendt One, Vario terminal</source>
        <translation>Fendt One, Varioterminal</translation>
    </message>
    <message>
        <source>Fertiliser or manure: headland first, ways along the headland.</source>
        <translation>Dünger oder Gülle: Vorgewende zuerst, Wege auf dem Vorgewende.</translation>
    </message>
    <message>
        <source>Fertiliser spreader, 36 m</source>
        <translation>Düngerstreuer, 36 m</translation>
    </message>
    <message>
        <source>Fewest swaths</source>
        <translation>Wenigste Spuren</translation>
    </message>
    <message>
        <source>Field robot, 1.5 m weeder</source>
        <translation>Feldroboter, Hacke 1,5 m</translation>
    </message>
    <message>
        <source>Finish corners</source>
        <translation>Ecken nacharbeiten</translation>
    </message>
    <message>
        <source>First tramline</source>
        <translation>Erste Fahrgasse</translation>
    </message>
    <message>
        <source>Fishtail</source>
        <translation>Schwalbenschwanz-Wendung</translation>
    </message>
    <message>
        <source>Five-furrow mounted plough, 2.5 m</source>
        <translation>Fünfschar-Anbaupflug, 2,5 m</translation>
    </message>
    <message>
        <source>Forward arc, straight back, forward arc; little room for near swaths.</source>
        <translation>Bogen vorwärts, gerade zurück, Bogen vorwärts; wenig Platz für nahe Spuren.</translation>
    </message>
    <message>
        <source>Forward curves</source>
        <translation>Vorwärtskurven</translation>
    </message>
    <message>
        <source>Forward curves, smooth steering</source>
        <translation>Vorwärtskurven, sanft gelenkt</translation>
    </message>
    <message>
        <source>Forward, back with the wheels the other way, forward again.</source>
        <translation>Vorwärts, rückwärts mit Gegeneinschlag, wieder vorwärts.</translation>
    </message>
    <message>
        <source>Forwards and backwards, the wheels turned no faster than the machine can (clothoids).</source>
        <translation>Vorwärts und rückwärts, die Räder nicht schneller eingeschlagen, als die Maschine kann (Klothoiden).</translation>
    </message>
    <message>
        <source>From clear of the ground to working depth.</source>
        <translation>Von ausgehoben bis auf Arbeitstiefe.</translation>
    </message>
    <message>
        <source>From inside out</source>
        <translation>Von innen nach außen</translation>
    </message>
    <message>
        <source>From outside in</source>
        <translation>Von außen nach innen</translation>
    </message>
    <message>
        <source>From the boundary inwards; holds as many passes as fit.</source>
        <translation>Von der Feldgrenze bis zur Innenfläche; fasst so viele Spuren, wie hineinpassen.</translation>
    </message>
    <message>
        <source>From the fixed axle to the hitch, negative behind the axle.</source>
        <translation>Von der starren Achse zur Anhängung, negativ hinter der Achse.</translation>
    </message>
    <message>
        <source>From the fixed axle to the middle of the working parts, negative behind the axle.</source>
        <translation>Von der starren Achse zur Mitte der Werkzeuge, negativ hinter der Achse.</translation>
    </message>
    <message>
        <source>From the fixed axle to the tractor&apos;s rear end.</source>
        <translation>Von der starren Achse bis zum Heck des Schleppers.</translation>
    </message>
    <message>
        <source>From the tractor&apos;s nose to its rear end.</source>
        <translation>Von der Front des Schleppers bis zum Heck.</translation>
    </message>
    <message>
        <source>From working depth to clear of the ground.</source>
        <translation>Von Arbeitstiefe bis ausgehoben.</translation>
    </message>
    <message>
        <source>Front and rear mower, 9 m</source>
        <translation>Front- und Heckmähwerk, 9 m</translation>
    </message>
    <message>
        <source>Fuel at work</source>
        <translation>Kraftstoff bei der Arbeit</translation>
    </message>
    <message>
        <source>Fuel in turns</source>
        <translation>Kraftstoff beim Wenden</translation>
    </message>
    <message>
        <source>Full spacing; the last swath is moved back to the edge.</source>
        <translation>Voller Abstand; die letzte Spur wird an den Rand gerückt.</translation>
    </message>
    <message>
        <source>Full spacing; a rest of less than half a width stays uncovered, where it costs least.</source>
        <translation>Voller Abstand; ein Rest von weniger als einer halben Breite bleibt liegen, wo es am wenigsten kostet.</translation>
    </message>
    <message>
        <source>Full width</source>
        <translation>Volle Breite</translation>
    </message>
    <message>
        <source>Gets the whole path as nav_msgs/Path, and stretches in one gear each where it reverses.</source>
        <translation>Erhält den ganzen Fahrweg als nav_msgs/Path, und je ein Stück pro Gang, wo er rückwärts fährt.</translation>
    </message>
    <message>
        <source>Given direction</source>
        <translation>Vorgegebene Richtung</translation>
    </message>
    <message>
        <source>Go round obstacles up to</source>
        <translation>Hindernisse umfahren bis</translation>
    </message>
    <message>
        <source>Great Field</source>
        <translation>Großer Schlag</translation>
    </message>
    <message>
        <source>Half way in</source>
        <translation>Auf halber Breite</translation>
    </message>
    <message>
        <source>Make them straight: &quot;Field&quot; menu, or furrow-cli convert --straighten-steps.</source>
        <translation>Begradigen: Menü „Schlag“, oder furrow-cli convert --straighten-steps.</translation>
    </message>
    <message>
        <source>Quick search</source>
        <translation>Schnelle Suche</translation>
    </message>
    <message>
        <source>Harvest</source>
        <translation>Ernte</translation>
    </message>
    <message>
        <source>Heading</source>
        <translation>Fahrtrichtung</translation>
    </message>
    <message>
        <source>Headland</source>
        <translation>Vorgewende</translation>
    </message>
    <message>
        <source>Headland first or last.</source>
        <translation>Vorgewende zuerst oder zuletzt.</translation>
    </message>
    <message>
        <source>Heights</source>
        <translation>Höhen</translation>
    </message>
    <message>
        <source>Hitch offset</source>
        <translation>Lage der Anhängung</translation>
    </message>
    <message>
        <source>Home Field</source>
        <translation>Hofschlag</translation>
    </message>
    <message>
        <source>How far a trailed implement may swing to one side.</source>
        <translation>Wie weit ein gezogenes Gerät nach einer Seite schwenken darf.</translation>
    </message>
    <message>
        <source>How far the steered wheels turn to one side.</source>
        <translation>Wie weit die gelenkten Räder nach einer Seite einschlagen.</translation>
    </message>
    <message>
        <source>How fast the curvature may change along the path; from the steering rate where it is not given.</source>
        <translation>Wie schnell sich die Krümmung entlang des Fahrwegs ändern darf; aus der Lenkgeschwindigkeit, wo sie nicht angegeben ist.</translation>
    </message>
    <message>
        <source>How fast the steered wheels turn.</source>
        <translation>Wie schnell die gelenkten Räder einschlagen.</translation>
    </message>
    <message>
        <source>How headland passes get round corners.</source>
        <translation>Wie Vorgewendespuren um Ecken kommen.</translation>
    </message>
    <message>
        <source>How much neighbouring swaths overlap.</source>
        <translation>Wie weit benachbarte Spuren überlappen.</translation>
    </message>
    <message>
        <source>How the direction of the swaths is found.</source>
        <translation>Wie die Fahrtrichtung gefunden wird.</translation>
    </message>
    <message>
        <source>How the machine gets from one swath to the next.</source>
        <translation>Wie die Maschine von einer Spur zur nächsten kommt.</translation>
    </message>
    <message>
        <source>How the field is divided; the swaths of a block are driven together.</source>
        <translation>Wie die Innenfläche geteilt wird; die Spuren einer Teilfläche werden zusammen gefahren.</translation>
    </message>
    <message>
        <source>Implement can reverse</source>
        <translation>Gerät kann rückwärts</translation>
    </message>
    <message>
        <source>Implement length</source>
        <translation>Gerätelänge</translation>
    </message>
    <message>
        <source>Implement offset</source>
        <translation>Lage des Geräts</translation>
    </message>
    <message>
        <source>In WGS84: A and B of a line, a curve, A alone with a direction, or a pivot&apos;s centre.</source>
        <translation>In WGS84: A und B einer Linie, eine Kurve, A allein mit einer Richtung oder die Mitte einer Kreisberegnung.</translation>
    </message>
    <message>
        <source>In which order the headland passes are driven.</source>
        <translation>In welcher Reihenfolge die Vorgewendespuren gefahren werden.</translation>
    </message>
    <message>
        <source>In which order the swaths are driven.</source>
        <translation>In welcher Reihenfolge die Spuren gefahren werden.</translation>
    </message>
    <message>
        <source>Largest acceleration</source>
        <translation>Größte Beschleunigung</translation>
    </message>
    <message>
        <source>Largest curvature rate</source>
        <translation>Größte Krümmungsänderung</translation>
    </message>
    <message>
        <source>Largest hitch angle</source>
        <translation>Größter Knickwinkel</translation>
    </message>
    <message>
        <source>Largest lateral acceleration</source>
        <translation>Größte Querbeschleunigung</translation>
    </message>
    <message>
        <source>Largest speed in turns.</source>
        <translation>Größte Geschwindigkeit in Wendungen.</translation>
    </message>
    <message>
        <source>Largest steering angle</source>
        <translation>Größter Lenkwinkel</translation>
    </message>
    <message>
        <source>Last pass</source>
        <translation>Letzte Spur</translation>
    </message>
    <message>
        <source>Lateral offset</source>
        <translation>Seitlicher Versatz</translation>
    </message>
    <message>
        <source>Least overlap</source>
        <translation>Geringste Überlappung</translation>
    </message>
    <message>
        <source>Least time</source>
        <translation>Kürzeste Zeit</translation>
    </message>
    <message>
        <source>Leaves some swaths out at each turn and comes back for them.</source>
        <translation>Lässt bei jeder Wendung Spuren aus und holt sie nach.</translation>
    </message>
    <message>
        <source>Left out</source>
        <translation>Ausgelassen</translation>
    </message>
    <message>
        <source>Limits the speed in tight bends.</source>
        <translation>Begrenzt die Geschwindigkeit in engen Kurven.</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Linie</translation>
    </message>
    <message>
        <source>Lines along which the field inside the headland is cut; they run right through it, or end no farther than an operating width from its edge.</source>
        <translation>Linien, an denen die Innenfläche geteilt wird; sie gehen ganz hindurch oder enden höchstens eine Arbeitsbreite vor ihrem Rand.</translation>
    </message>
    <message>
        <source>Litres of fuel per hour of turns and transfers.</source>
        <translation>Liter Kraftstoff je Stunde in Wendungen und Leerfahrten.</translation>
    </message>
    <message>
        <source>Litres of fuel per hour of work.</source>
        <translation>Liter Kraftstoff je Arbeitsstunde.</translation>
    </message>
    <message>
        <source>Long Strip</source>
        <translation>Langer Streifen</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>Schleife</translation>
    </message>
    <message>
        <source>Lower the speeds, or correct the machine&apos;s.</source>
        <translation>Die Geschwindigkeiten senken oder die der Maschine berichtigen.</translation>
    </message>
    <message>
        <source>MAVLink waypoints</source>
        <translation>MAVLink-Wegpunkte</translation>
    </message>
    <message>
        <source>Make the gate wider, or take another.</source>
        <translation>Die Zufahrt breiter machen oder eine andere nehmen.</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Sicherheitsabstand</translation>
    </message>
    <message>
        <source>Overhang</source>
        <translation>Überstand</translation>
    </message>
    <message>
        <source>Most covered</source>
        <translation>Meiste Fläche</translation>
    </message>
    <message>
        <source>Most terminals read FAT32 only; this stick has %1. Format it as FAT32.</source>
        <translation>Die meisten Terminals lesen nur FAT32; dieser Stick hat %1. Als FAT32 formatieren.</translation>
    </message>
    <message>
        <source>Mounted cultivator, 6 m</source>
        <translation>Anbaugrubber, 6 m</translation>
    </message>
    <message>
        <source>Mounted drill, 12 m</source>
        <translation>Anbaudrillmaschine, 12 m</translation>
    </message>
    <message>
        <source>Mounting</source>
        <translation>Anbau</translation>
    </message>
    <message>
        <source>Mowing</source>
        <translation>Mähen</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>No headland</source>
        <translation>Kein Vorgewende</translation>
    </message>
    <message>
        <source>Nothing leads to the start of %1, %2 away.</source>
        <translation>Zum %2 entfernten Anfang führt kein Weg: %1.</translation>
    </message>
    <message>
        <source>Number of the boundary&apos;s edge, from 0 in the order of its points; for curves with all around it up to a corner of 35 degrees within a width, or a bend of 90 in all.</source>
        <translation>Nummer der Kante der Feldgrenze, ab 0 in der Folge ihrer Punkte; bei Kurven mit allen ringsum bis zu einer Ecke von 35 Grad innerhalb einer Breite oder einer Biegung von insgesamt 90.</translation>
    </message>
    <message>
        <source>Of the four corners and both ways the one with the quickest turns.</source>
        <translation>Von den vier Ecken und beiden Richtungen die mit den schnellsten Wendungen.</translation>
    </message>
    <message>
        <source>Of the middle of the operating width, positive to the left.</source>
        <translation>Der Mitte der Arbeitsbreite, positiv nach links.</translation>
    </message>
    <message>
        <source>Of the swaths.</source>
        <translation>Der Spuren.</translation>
    </message>
    <message>
        <source>Off: the strip is kept for turning only.</source>
        <translation>Aus: der Streifen dient nur zum Wenden.</translation>
    </message>
    <message>
        <source>Omega turn</source>
        <translation>Omega-Wendung</translation>
    </message>
    <message>
        <source>On the rows</source>
        <translation>Auf den Reihen</translation>
    </message>
    <message>
        <source>On the rows, or between them.</source>
        <translation>Auf den Reihen oder dazwischen.</translation>
    </message>
    <message>
        <source>On the spot</source>
        <translation>Auf der Stelle</translation>
    </message>
    <message>
        <source>One for all</source>
        <translation>Eine für alle</translation>
    </message>
    <message>
        <source>One piece</source>
        <translation>Ein Stück</translation>
    </message>
    <message>
        <source>Only where it turns</source>
        <translation>Nur wo gewendet wird</translation>
    </message>
    <message>
        <source>Operating width</source>
        <translation>Arbeitsbreite</translation>
    </message>
    <message>
        <source>Operation</source>
        <translation>Arbeitsgang</translation>
    </message>
    <message>
        <source>Orchard tractor with 1.5 m sprayer</source>
        <translation>Obstbauschlepper mit Sprühgerät 1,5 m</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Reihenfolge</translation>
    </message>
    <message>
        <source>Overlap</source>
        <translation>Überlappung</translation>
    </message>
    <message>
        <source>Overlaps its neighbour</source>
        <translation>Überlappt ihre Nachbarin</translation>
    </message>
    <message>
        <source>P turn</source>
        <translation>P-Wendung</translation>
    </message>
    <message>
        <source>Passes</source>
        <translation>Spuren</translation>
    </message>
    <message>
        <source>Plan again with this machine&apos;s turning radius.</source>
        <translation>Mit dem Wenderadius dieser Maschine neu planen.</translation>
    </message>
    <message>
        <source>Plan again, or trust the positions.</source>
        <translation>Neu planen oder den Positionen vertrauen.</translation>
    </message>
    <message>
        <source>Plan again; the heading or the gear is wrong here.</source>
        <translation>Neu planen; Richtung oder Gang stimmen hier nicht.</translation>
    </message>
    <message>
        <source>Plan again; the path lacks this pass.</source>
        <translation>Neu planen; im Fahrweg fehlt diese Spur.</translation>
    </message>
    <message>
        <source>Plan again; the path was changed or cut here.</source>
        <translation>Neu planen; der Fahrweg wurde hier geändert oder abgeschnitten.</translation>
    </message>
    <message>
        <source>Plan again; the times were changed.</source>
        <translation>Neu planen; die Zeiten wurden geändert.</translation>
    </message>
    <message>
        <source>Plan the parts of the field apart, or widen the passage between them.</source>
        <translation>Die Teile des Schlags einzeln planen oder den Durchlass zwischen ihnen verbreitern.</translation>
    </message>
    <message>
        <source>Plan the turn that is missing here.</source>
        <translation>Die hier fehlende Wendung planen.</translation>
    </message>
    <message>
        <source>Power harrow and drill, 3 m</source>
        <translation>Kreiselegge mit Drillmaschine, 3 m</translation>
    </message>
    <message>
        <source>Prefer</source>
        <translation>Bevorzugen</translation>
    </message>
    <message>
        <source>Protobuf message</source>
        <translation>Protobuf-Nachricht</translation>
    </message>
    <message>
        <source>QGroundControl plan</source>
        <translation>QGroundControl-Plan</translation>
    </message>
    <message>
        <source>Racetrack</source>
        <translation>Rundherum</translation>
    </message>
    <message>
        <source>Raised width</source>
        <translation>Breite beim Wenden</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Menge</translation>
    </message>
    <message>
        <source>Rear overhang</source>
        <translation>Hinterer Überhang</translation>
    </message>
    <message>
        <source>Recorded path</source>
        <translation>Aufgezeichneter Weg</translation>
    </message>
    <message>
        <source>Relay 1 is on where the implement works.</source>
        <translation>Relais 1 ist eingeschaltet, wo das Gerät arbeitet.</translation>
    </message>
    <message>
        <source>Repaired in %1: %2.</source>
        <translation>Repariert (%1): %2.</translation>
    </message>
    <message>
        <source>Reverse</source>
        <translation>Rückwärts</translation>
    </message>
    <message>
        <source>Reverse speed</source>
        <translation>Rückwärtsgeschwindigkeit</translation>
    </message>
    <message>
        <source>Round and round the centre of a pivot, from the rim inwards.</source>
        <translation>Rundherum um die Mitte einer Kreisberegnung, vom Rand nach innen.</translation>
    </message>
    <message>
        <source>Round and round, with half of the swaths between the way out and the way back.</source>
        <translation>Rundherum, mit der Hälfte der Spuren zwischen Hin- und Rückweg.</translation>
    </message>
    <message>
        <source>Round the field</source>
        <translation>Um den Schlag</translation>
    </message>
    <message>
        <source>Rounded</source>
        <translation>Abgerundet</translation>
    </message>
    <message>
        <source>Route</source>
        <translation>Fahrroute</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>Reihen</translation>
    </message>
    <message>
        <source>Rows that are left out, numbered from 1 as in the file; between rows, that on the right.</source>
        <translation>Reihen, die wegbleiben, ab 1 gezählt wie in der Datei; zwischen Reihen die rechte.</translation>
    </message>
    <message>
        <source>Run-in</source>
        <translation>Anlaufstrecke</translation>
    </message>
    <message>
        <source>Same width all round</source>
        <translation>Ringsum gleich breit</translation>
    </message>
    <message>
        <source>Seen from above, turning left at corners.</source>
        <translation>Von oben gesehen, an Ecken nach links.</translation>
    </message>
    <message>
        <source>Seen from above, turning right at corners.</source>
        <translation>Von oben gesehen, an Ecken nach rechts.</translation>
    </message>
    <message>
        <source>Short name for the command line.</source>
        <translation>Kurzer Name für die Befehlszeile.</translation>
    </message>
    <message>
        <source>Short passes where corners would leave more than 1 % of the field.</source>
        <translation>Kurze Spuren, wo in Ecken mehr als 1 % des Schlags übrig bliebe.</translation>
    </message>
    <message>
        <source>Shortest swaths</source>
        <translation>Kürzeste Spuren</translation>
    </message>
    <message>
        <source>Shows the boundary and the guidance lines; it plans turns and order itself. Not tested on the machine by us.</source>
        <translation>Zeigt die Feldgrenze und die Leitlinien; Wendungen und Reihenfolge plant es selbst. Von uns nicht an der Maschine geprüft.</translation>
    </message>
    <message>
        <source>Shows the boundary with holes and obstacles and the guidance lines; it plans turns and order itself. The import may have to be unlocked. Not tested on the machine by us.</source>
        <translation>Zeigt die Feldgrenze mit Aussparungen und Hindernissen und die Leitlinien; Wendungen und Reihenfolge plant es selbst. Der Import muss eventuell freigeschaltet werden. Von uns nicht an der Maschine geprüft.</translation>
    </message>
    <message>
        <source>Shows the boundary with holes and obstacles, the headland where the terminal knows it, and the guidance lines; it plans turns and order itself. The import may have to be unlocked. Not tested on the machine by us.</source>
        <translation>Zeigt die Feldgrenze mit Aussparungen und Hindernissen, das Vorgewende, wo das Terminal es kennt, und die Leitlinien; Wendungen und Reihenfolge plant es selbst. Der Import muss eventuell freigeschaltet werden. Von uns nicht an der Maschine geprüft.</translation>
    </message>
    <message>
        <source>Shows the boundary, its holes, the headland and the guidance lines, not the path. Holes are written as obstacles, since it overlooks others.</source>
        <translation>Zeigt Feldgrenze, Aussparungen, Vorgewende und Leitlinien, nicht den Fahrweg. Aussparungen werden als Hindernisse geschrieben, da es andere übersieht.</translation>
    </message>
    <message>
        <source>Shows the path as a mission, and the boundary and obstacles as fences. Not tested on the machine by us.</source>
        <translation>Zeigt den Fahrweg als Mission und Feldgrenze und Hindernisse als Zäune. Von uns nicht an der Maschine geprüft.</translation>
    </message>
    <message>
        <source>Six directions, then ever finer around the best three (Oksanen &amp; Visala).</source>
        <translation>Sechs Richtungen, dann immer feiner um die besten drei (Oksanen &amp; Visala).</translation>
    </message>
    <message>
        <source>Six-row planter, 4.5 m</source>
        <translation>Einzelkornsämaschine, 6 Reihen, 4,5 m</translation>
    </message>
    <message>
        <source>Skip</source>
        <translation>Auslassen</translation>
    </message>
    <message>
        <source>Skip and fill</source>
        <translation>Auslassen und füllen</translation>
    </message>
    <message>
        <source>Slanted Field</source>
        <translation>Schräger Schlag</translation>
    </message>
    <message>
        <source>Slurry tanker, 15 m trailing shoe</source>
        <translation>Güllewagen, Schleppschuh 15 m</translation>
    </message>
    <message>
        <source>Smallest circle the middle of the fixed axle can follow; from the steering angle where it is not given.</source>
        <translation>Kleinster Kreis, dem die Mitte der starren Achse folgen kann; aus dem Lenkwinkel, wo er nicht angegeben ist.</translation>
    </message>
    <message>
        <source>Smallest turning radius</source>
        <translation>Kleinster Wenderadius</translation>
    </message>
    <message>
        <source>Snake</source>
        <translation>Schlange</translation>
    </message>
    <message>
        <source>So that the wide machine begins flush with the left edge, or beside the line that was given.</source>
        <translation>Sodass die breite Maschine bündig am linken Rand beginnt oder neben der angegebenen Linie.</translation>
    </message>
    <message>
        <source>Sowing</source>
        <translation>Aussaat</translation>
    </message>
    <message>
        <source>Speed backwards.</source>
        <translation>Geschwindigkeit rückwärts.</translation>
    </message>
    <message>
        <source>Speed on longer ways with the implement lifted.</source>
        <translation>Geschwindigkeit auf längeren Wegen mit ausgehobenem Gerät.</translation>
    </message>
    <message>
        <source>Speed with the implement at work.</source>
        <translation>Geschwindigkeit mit arbeitendem Gerät.</translation>
    </message>
    <message>
        <source>Spiral in clusters</source>
        <translation>Spirale in Gruppen</translation>
    </message>
    <message>
        <source>Split lines</source>
        <translation>Teilungslinien</translation>
    </message>
    <message>
        <source>Spraying</source>
        <translation>Pflanzenschutz</translation>
    </message>
    <message>
        <source>Spread over all</source>
        <translation>Auf alle verteilt</translation>
    </message>
    <message>
        <source>Spreading</source>
        <translation>Düngerstreuen</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Anfang</translation>
    </message>
    <message>
        <source>Start at</source>
        <translation>Beginnen bei</translation>
    </message>
    <message>
        <source>Stay inside</source>
        <translation>Im Schlag bleiben</translation>
    </message>
    <message>
        <source>Steering rate</source>
        <translation>Lenkgeschwindigkeit</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Straight into the corner and back into it on the next side.</source>
        <translation>Gerade in die Ecke und auf der nächsten Seite rückwärts hinein.</translation>
    </message>
    <message>
        <source>Straight into the corner and on after a loop, where there is room for it.</source>
        <translation>Gerade in die Ecke und nach einer Schleife weiter, wo Platz dafür ist.</translation>
    </message>
    <message>
        <source>Straight way needed before the implement is lowered.</source>
        <translation>Gerader Weg, der vor dem Absenken nötig ist.</translation>
    </message>
    <message>
        <source>Swath after swath over all of the field, whatever cuts them.</source>
        <translation>Spur nach Spur über die ganze Innenfläche, was auch immer sie schneidet.</translation>
    </message>
    <message>
        <source>Swath numbers in driving order; a minus drives one the other way.</source>
        <translation>Spurnummern in Fahrfolge; ein Minus fährt eine andersherum.</translation>
    </message>
    <message>
        <source>Swaths</source>
        <translation>Spuren</translation>
    </message>
    <message>
        <source>Swaths go on from block to block.</source>
        <translation>Spuren laufen von Teilfläche zu Teilfläche weiter.</translation>
    </message>
    <message>
        <source>Swaths go round obstacles of up to this size; larger ones get a headland. Auto is the operating width.</source>
        <translation>Spuren umfahren Hindernisse bis zu dieser Größe; größere bekommen ein Vorgewende. Auto ist die Arbeitsbreite.</translation>
    </message>
    <message>
        <source>Swaths left out at each turn and driven on the way back.</source>
        <translation>Spuren, die bei jeder Wendung ausgelassen und auf dem Rückweg gefahren werden.</translation>
    </message>
    <message>
        <source>Swaths that are finished together.</source>
        <translation>Spuren, die zusammen fertig werden.</translation>
    </message>
    <message>
        <source>Takes the boundary only, as an upload from a computer; no guidance lines, no path.</source>
        <translation>Nimmt nur die Feldgrenze, hochgeladen von einem Computer; keine Leitlinien, kein Fahrweg.</translation>
    </message>
    <message>
        <source>Tank or bunker</source>
        <translation>Tank oder Behälter</translation>
    </message>
    <message>
        <source>The Bend</source>
        <translation>Die Biegung</translation>
    </message>
    <message>
        <source>The best corner</source>
        <translation>Die beste Ecke</translation>
    </message>
    <message>
        <source>The boundary alone as a flat zipped shapefile, as operations centres take it.</source>
        <translation>Nur die Feldgrenze als flach gezipptes Shapefile, wie es Operations Center annehmen.</translation>
    </message>
    <message>
        <source>The chosen one cannot be driven between these swaths.</source>
        <translation>Die gewählte lässt sich zwischen diesen Spuren nicht fahren.</translation>
    </message>
    <message>
        <source>The corner where the route starts.</source>
        <translation>Die Ecke, an der die Fahrroute beginnt.</translation>
    </message>
    <message>
        <source>The field is narrower here than the %1 in which this machine turns without reversing: leave this strip out, or work it with a machine that turns more tightly.</source>
        <translation>Der Schlag ist hier schmaler als die %1, auf denen diese Maschine ohne Rückwärtsfahren wendet: Lassen Sie diesen Streifen weg, oder bearbeiten Sie ihn mit einer wendigeren Maschine.</translation>
    </message>
    <message>
        <source>The field is narrower here than this machine, which takes %1: leave this strip out, or work it with a narrower machine.</source>
        <translation>Der Schlag ist hier schmaler als diese Maschine, die %1 braucht: Lassen Sie diesen Streifen weg, oder bearbeiten Sie ihn mit einer schmaleren Maschine.</translation>
    </message>
    <message>
        <source>The field is too narrow for %1 of headland; it is %2 with %3</source>
        <translation>Der Schlag ist zu schmal für %1 Vorgewende; es werden %2 mit %3</translation>
    </message>
    <message>
        <source>The field is too narrow for %1 of headland; there is none</source>
        <translation>Der Schlag ist zu schmal für %1 Vorgewende; es gibt keins</translation>
    </message>
    <message>
        <source>The first swath</source>
        <translation>Die erste Spur</translation>
    </message>
    <message>
        <source>The first swath on the left is one, or the line that was given.</source>
        <translation>Die erste Spur links ist eine, oder die angegebene Linie.</translation>
    </message>
    <message>
        <source>The first swath on the right is one, or the line that was given.</source>
        <translation>Die erste Spur rechts ist eine, oder die angegebene Linie.</translation>
    </message>
    <message>
        <source>The headland is worked first.</source>
        <translation>Das Vorgewende wird zuerst bearbeitet.</translation>
    </message>
    <message>
        <source>The headland is worked last.</source>
        <translation>Das Vorgewende wird zuletzt bearbeitet.</translation>
    </message>
    <message>
        <source>The headland strip, %1, is not worked by this plan, nor are %2 at the ends of the swaths beside it.</source>
        <translation>Der Vorgewendestreifen, %1, wird in diesem Plan nicht bearbeitet, ebenso %2 an den Enden der Spuren daneben.</translation>
    </message>
    <message>
        <source>The headland strip, %1, is not worked by this plan.</source>
        <translation>Der Vorgewendestreifen, %1, wird in diesem Plan nicht bearbeitet.</translation>
    </message>
    <message>
        <source>The hitch bends by %1 in %2; %3 are allowed.</source>
        <translation>Die Anhängung knickt bei %2 um %1; erlaubt sind %3.</translation>
    </message>
    <message>
        <source>The largest covered share inside the headland.</source>
        <translation>Der größte bearbeitete Anteil der Innenfläche.</translation>
    </message>
    <message>
        <source>The least metres driven in swaths, with what is missed added as metres.</source>
        <translation>Die wenigsten gefahrenen Meter in Spuren; Fehlstellen zählen als Meter mit.</translation>
    </message>
    <message>
        <source>The machine does not get in at %1.</source>
        <translation>Die Maschine kommt hier nicht hinein: %1.</translation>
    </message>
    <message>
        <source>The machine does not get out at %1.</source>
        <translation>Die Maschine kommt hier nicht hinaus: %1.</translation>
    </message>
    <message>
        <source>The machine drives half way between two neighbours.</source>
        <translation>Die Maschine fährt mitten zwischen zwei Nachbarn.</translation>
    </message>
    <message>
        <source>The machine drives over them.</source>
        <translation>Die Maschine fährt darüber.</translation>
    </message>
    <message>
        <source>The machine turns on the spot in %1, by up to %2.</source>
        <translation>Die Maschine dreht an %1 auf der Stelle, um bis zu %2.</translation>
    </message>
    <message>
        <source>The machine turns on the spot in %1, by up to %2; it cannot.</source>
        <translation>Die Maschine dreht an %1 auf der Stelle, um bis zu %2; das kann sie nicht.</translation>
    </message>
    <message>
        <source>The mission has %1 items; controllers without a memory card hold about %2.</source>
        <translation>Die Mission hat %1 Einträge; Steuerungen ohne Speicherkarte fassen etwa %2.</translation>
    </message>
    <message>
        <source>The outermost pass goes round with the machine&apos;s radius where little is left; others reach into corners.</source>
        <translation>Die äußerste Spur fährt mit dem Radius der Maschine herum, wo wenig liegen bleibt; andere reichen in die Ecken.</translation>
    </message>
    <message>
        <source>The outline has %1 steps of about %2, like the pixels of an image.</source>
        <translation>Der Umriss hat %1 Stufen von etwa %2, wie die Pixel eines Bildes.</translation>
    </message>
    <message>
        <source>The pass along the boundary first.</source>
        <translation>Zuerst die Spur an der Feldgrenze.</translation>
    </message>
    <message>
        <source>The innermost pass first.</source>
        <translation>Zuerst die Spur an der Innenfläche.</translation>
    </message>
    <message>
        <source>The path as a mission for ArduPilot Rover: waypoints, speeds, gear, implement.</source>
        <translation>Der Fahrweg als Mission für ArduPilot Rover: Wegpunkte, Geschwindigkeiten, Gang, Gerät.</translation>
    </message>
    <message>
        <source>The path as a track, swath ends as a route, gates as waypoints; for phones.</source>
        <translation>Der Fahrweg als Track, Spurenden als Route, Zufahrten als Wegpunkte; für Telefone.</translation>
    </message>
    <message>
        <source>The path as nav_msgs/Path in a recording of ROS 2.</source>
        <translation>Der Fahrweg als nav_msgs/Path in einer Aufzeichnung von ROS 2.</translation>
    </message>
    <message>
        <source>The path as one message for ros2 topic pub.</source>
        <translation>Der Fahrweg als eine Nachricht für ros2 topic pub.</translation>
    </message>
    <message>
        <source>The path with times, velocities and orientations, and the boundary as a fence; for own robots.</source>
        <translation>Der Fahrweg mit Zeiten, Geschwindigkeiten und Ausrichtungen und die Feldgrenze als Zaun; für eigene Roboter.</translation>
    </message>
    <message>
        <source>The quickest turn of any kind that stays inside the field, in several moves where it must.</source>
        <translation>Die schnellste Wendung jeder Art, die im Schlag bleibt, in mehreren Zügen, wo nötig.</translation>
    </message>
    <message>
        <source>The same as KML, zipped.</source>
        <translation>Dasselbe wie KML, gezippt.</translation>
    </message>
    <message>
        <source>The same mission with the boundary and obstacles as fences.</source>
        <translation>Dieselbe Mission mit Feldgrenze und Hindernissen als Zäunen.</translation>
    </message>
    <message>
        <source>The shortest curve forwards and backwards, at the smallest turning radius (Reeds and Shepp).</source>
        <translation>Die kürzeste Kurve vorwärts und rückwärts, mit dem kleinsten Wenderadius (Reeds und Shepp).</translation>
    </message>
    <message>
        <source>The shortest curve without reversing, at the smallest turning radius (Dubins).</source>
        <translation>Die kürzeste Kurve ohne Rückwärtsfahren, mit dem kleinsten Wenderadius (Dubins).</translation>
    </message>
    <message>
        <source>The shortest time in swaths and turns.</source>
        <translation>Die kürzeste Zeit in Spuren und Wendungen.</translation>
    </message>
    <message>
        <source>The smallest area worked twice.</source>
        <translation>Die kleinste doppelt bearbeitete Fläche.</translation>
    </message>
    <message>
        <source>The spacing is reduced evenly so that all fit.</source>
        <translation>Der Abstand wird gleichmäßig verringert, sodass alle passen.</translation>
    </message>
    <message>
        <source>The stated curvature differs from the path in %1, by up to %2 1/m.</source>
        <translation>Die angegebene Krümmung weicht an %1 vom Fahrweg ab, um bis zu %2 1/m.</translation>
    </message>
    <message>
        <source>The stated speed is up to %1 above the machine&apos;s.</source>
        <translation>Die angegebene Geschwindigkeit liegt bis zu %1 über der der Maschine.</translation>
    </message>
    <message>
        <source>The strip kept for turning.</source>
        <translation>Der Streifen zum Wenden.</translation>
    </message>
    <message>
        <source>The swaths in the order and direction that you type.</source>
        <translation>Die Spuren in eingetippter Reihenfolge und Richtung.</translation>
    </message>
    <message>
        <source>The table holds boundaries only: obstacles, gates and lines are left out.</source>
        <translation>Die Tabelle enthält nur Feldgrenzen: Hindernisse, Zufahrten und Linien fehlen.</translation>
    </message>
    <message>
        <source>The task data has %1 MB; old terminals take at most 2 MB.</source>
        <translation>Die Auftragsdaten haben %1 MB; alte Terminals nehmen höchstens 2 MB.</translation>
    </message>
    <message>
        <source>The tractor may drive backwards with it.</source>
        <translation>Der Schlepper darf damit rückwärts fahren.</translation>
    </message>
    <message>
        <source>The tractor may drive backwards.</source>
        <translation>Der Schlepper darf rückwärts fahren.</translation>
    </message>
    <message>
        <source>The tractor may turn about its own middle.</source>
        <translation>Der Schlepper darf sich um seine eigene Mitte drehen.</translation>
    </message>
    <message>
        <source>The way from %1 to %2</source>
        <translation>Der Weg %1 → %2</translation>
    </message>
    <message>
        <source>There the chosen one does not fit into the field or cannot be driven between these swaths.</source>
        <translation>Die gewählte passt dort nicht in den Schlag oder lässt sich zwischen diesen Spuren nicht fahren.</translation>
    </message>
    <message>
        <source>There the chosen one does not fit into the field.</source>
        <translation>Die gewählte passt dort nicht in den Schlag.</translation>
    </message>
    <message>
        <source>This machine cannot reverse.</source>
        <translation>Diese Maschine kann nicht rückwärts fahren.</translation>
    </message>
    <message>
        <source>This stick has %1 partitions; terminals see the first one only, if any.</source>
        <translation>Dieser Stick hat %1 Partitionen; Terminals sehen höchstens die erste.</translation>
    </message>
    <message>
        <source>Three Ponds</source>
        <translation>Drei Teiche</translation>
    </message>
    <message>
        <source>Three-point turn</source>
        <translation>Dreipunktwendung</translation>
    </message>
    <message>
        <source>Through point A in the direction that you type.</source>
        <translation>Durch Punkt A in der eingetippten Richtung.</translation>
    </message>
    <message>
        <source>Tillage</source>
        <translation>Bodenbearbeitung</translation>
    </message>
    <message>
        <source>Time and way do not fit the speed in %1.</source>
        <translation>Zeit und Weg passen an %1 nicht zur Geschwindigkeit.</translation>
    </message>
    <message>
        <source>Time to lift</source>
        <translation>Zeit zum Ausheben</translation>
    </message>
    <message>
        <source>Time to lower</source>
        <translation>Zeit zum Absenken</translation>
    </message>
    <message>
        <source>To and fro</source>
        <translation>Hin und her</translation>
    </message>
    <message>
        <source>Trailed sprayer, 24 m boom</source>
        <translation>Anhängespritze, Gestänge 24 m</translation>
    </message>
    <message>
        <source>Tramline every</source>
        <translation>Fahrgasse alle</translation>
    </message>
    <message>
        <source>Transfer speed</source>
        <translation>Geschwindigkeit bei Leerfahrt</translation>
    </message>
    <message>
        <source>Transport width</source>
        <translation>Transportbreite</translation>
    </message>
    <message>
        <source>Trapezoids</source>
        <translation>Trapeze</translation>
    </message>
    <message>
        <source>Tries every heading in steps and keeps the best.</source>
        <translation>Versucht alle Richtungen in Schritten und behält die beste.</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Wendung</translation>
    </message>
    <message>
        <source>Turning speed</source>
        <translation>Wendegeschwindigkeit</translation>
    </message>
    <message>
        <source>Turns</source>
        <translation>Wendungen</translation>
    </message>
    <message>
        <source>Turns between swaths that are of another kind than chosen (path.method): %1 of %2. %3</source>
        <translation>Wendungen zwischen Spuren, die anders sind als gewählt (path.method): %1 von %2. %3</translation>
    </message>
    <message>
        <source>Turns in place and drives straight to the next swath; only for machines that can.</source>
        <translation>Dreht auf der Stelle und fährt gerade zur nächsten Spur; nur für Maschinen, die das können.</translation>
    </message>
    <message>
        <source>Turns on the spot are chosen (path.method), and this machine cannot turn on the spot.</source>
        <translation>Gewählt sind Wendungen auf der Stelle (path.method), und diese Maschine kann nicht auf der Stelle wenden.</translation>
    </message>
    <message>
        <source>U turn</source>
        <translation>U-Wendung</translation>
    </message>
    <message>
        <source>Vehicle length</source>
        <translation>Fahrzeuglänge</translation>
    </message>
    <message>
        <source>Vehicle width</source>
        <translation>Fahrzeugbreite</translation>
    </message>
    <message>
        <source>Ways</source>
        <translation>Wege</translation>
    </message>
    <message>
        <source>Ways keep to the field&apos;s edge.</source>
        <translation>Wege bleiben am Rand des Schlags.</translation>
    </message>
    <message>
        <source>Ways keep to the headland; crop and seedbed are not driven over.</source>
        <translation>Wege bleiben auf dem Vorgewende; Bestand und Saatbett werden nicht überfahren.</translation>
    </message>
    <message>
        <source>Ways may cross worked land.</source>
        <translation>Wege dürfen die Innenfläche queren.</translation>
    </message>
    <message>
        <source>Well-known text</source>
        <translation>Well-known text</translation>
    </message>
    <message>
        <source>What becomes of the width that is left over at the far side.</source>
        <translation>Was aus der Breite wird, die auf der anderen Seite übrig bleibt.</translation>
    </message>
    <message>
        <source>Distance from the boundary that nothing enters; auto is the boundary&apos;s accuracy.</source>
        <translation>Abstand zur Feldgrenze, den alles einhält; Auto ist die Genauigkeit der Feldgrenze.</translation>
    </message>
    <message>
        <source>How far the implement may stand over the boundary and obstacles, its sections there switched off; the tractor and all wheels stay inside.</source>
        <translation>Wie weit das Gerät über Feldgrenze und Hindernisse ragen darf; die Teilbreiten sind dort abgeschaltet, Schlepper und alle Räder bleiben im Schlag.</translation>
    </message>
    <message>
        <source>What is spread or gathered on a square metre, in the same unit.</source>
        <translation>Was auf einem Quadratmeter ausgebracht oder geerntet wird, in derselben Einheit.</translation>
    </message>
    <message>
        <source>What it holds, in your own unit: litres, kilograms, seeds.</source>
        <translation>Was hineinpasst, in der eigenen Einheit: Liter, Kilogramm, Körner.</translation>
    </message>
    <message>
        <source>What the field is driven over for: sets when the headland is worked, ways and overlap.</source>
        <translation>Wofür gefahren wird: bestimmt, wann das Vorgewende bearbeitet wird, Wege und Überlappung.</translation>
    </message>
    <message>
        <source>What the machine is called.</source>
        <translation>Wie die Maschine heißt.</translation>
    </message>
    <message>
        <source>What the search for the best heading looks for.</source>
        <translation>Wonach die Suche nach der besten Fahrtrichtung geht.</translation>
    </message>
    <message>
        <source>Wheelbase</source>
        <translation>Radstand</translation>
    </message>
    <message>
        <source>When</source>
        <translation>Wann</translation>
    </message>
    <message>
        <source>When speeding up and when braking.</source>
        <translation>Beim Anfahren und beim Bremsen.</translation>
    </message>
    <message>
        <source>Where a swath ends at a slanting edge.</source>
        <translation>Wo eine Spur an einer schrägen Kante endet.</translation>
    </message>
    <message>
        <source>Where the machine may drive from swath to swath; follows from the operation.</source>
        <translation>Wo die Maschine von Spur zu Spur fahren darf; folgt aus dem Arbeitsgang.</translation>
    </message>
    <message>
        <source>Where the middle of the swath meets the headland.</source>
        <translation>Wo die Mitte der Spur auf das Vorgewende trifft.</translation>
    </message>
    <message>
        <source>Where tramlines are counted from.</source>
        <translation>Von wo die Fahrgassen gezählt werden.</translation>
    </message>
    <message>
        <source>Whether blocks have a heading of their own.</source>
        <translation>Ob Teilflächen eine eigene Fahrtrichtung haben.</translation>
    </message>
    <message>
        <source>Which way round the headland passes are driven.</source>
        <translation>In welcher Richtung die Vorgewendespuren gefahren werden.</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Width in operating widths; auto leaves room for the turns.</source>
        <translation>Breite in Arbeitsbreiten; Auto lässt Platz für die Wendungen.</translation>
    </message>
    <message>
        <source>Width the tractor occupies, wheels included.</source>
        <translation>Breite, die der Schlepper mit Rädern einnimmt.</translation>
    </message>
    <message>
        <source>Width while folded for the road, through gates and on ways in and out; the raised width where it is not given.</source>
        <translation>Breite, wenn für die Straße geklappt, durch Zufahrten und auf Wegen hinein und hinaus; ohne Angabe die Breite beim Wenden.</translation>
    </message>
    <message>
        <source>Width while lifted or folded for a turn; the operating width where it is not given.</source>
        <translation>Breite beim Wenden, ausgehoben oder geklappt; ohne Angabe die Arbeitsbreite.</translation>
    </message>
    <message>
        <source>Width worked in one pass.</source>
        <translation>Breite, die in einer Spur bearbeitet wird.</translation>
    </message>
    <message>
        <source>Without reversing, the wheels turned no faster than the machine can (clothoids).</source>
        <translation>Ohne Rückwärtsfahren, die Räder nicht schneller eingeschlagen, als die Maschine kann (Klothoiden).</translation>
    </message>
    <message>
        <source>Work it along the boundary, before or after the swaths.</source>
        <translation>Vor oder nach den Spuren entlang der Feldgrenze bearbeiten.</translation>
    </message>
    <message>
        <source>Work the headland</source>
        <translation>Vorgewende bearbeiten</translation>
    </message>
    <message>
        <source>Working speed</source>
        <translation>Arbeitsgeschwindigkeit</translation>
    </message>
    <message>
        <source>Working the soil: worked land may be driven over.</source>
        <translation>Bodenbearbeitung: die Innenfläche darf gequert werden.</translation>
    </message>
    <message>
        <source>Your own order</source>
        <translation>Eigene Reihenfolge</translation>
    </message>
    <message>
        <source>Zipped boundary</source>
        <translation>Gezippte Feldgrenze</translation>
    </message>
    <message>
        <source>a chunk of the recording has a wrong checksum</source>
        <translation>ein Stück der Aufzeichnung hat eine falsche Prüfsumme</translation>
    </message>
    <message>
        <source>a chunk of the recording is cut off</source>
        <translation>ein Stück der Aufzeichnung ist abgeschnitten</translation>
    </message>
    <message>
        <source>a chunk of the recording is damaged</source>
        <translation>ein Stück der Aufzeichnung ist beschädigt</translation>
    </message>
    <message>
        <source>a compressed chunk of the recording is damaged</source>
        <translation>ein gepacktes Stück der Aufzeichnung ist beschädigt</translation>
    </message>
    <message>
        <source>a coordinate is not a number</source>
        <translation>eine Koordinate ist keine Zahl</translation>
    </message>
    <message>
        <source>a curve needs at least two points that differ</source>
        <translation>eine Kurve braucht mindestens zwei verschiedene Punkte</translation>
    </message>
    <message>
        <source>a drawing does not say which coordinate system it uses</source>
        <translation>eine Zeichnung sagt nicht, welches Koordinatensystem sie hat</translation>
    </message>
    <message>
        <source>a hole lies outside the boundary</source>
        <translation>eine Aussparung liegt außerhalb der Feldgrenze</translation>
    </message>
    <message>
        <source>a hole of &apos;%1&apos; is missing or another</source>
        <translation>eine Aussparung von „%1“ fehlt oder ist anders</translation>
    </message>
    <message>
        <source>a machine is one JSON object</source>
        <translation>eine Maschine ist ein JSON-Objekt</translation>
    </message>
    <message>
        <source>a message is cut off</source>
        <translation>eine Nachricht ist abgeschnitten</translation>
    </message>
    <message>
        <source>a message is not plain CDR</source>
        <translation>eine Nachricht ist kein einfaches CDR</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>eine Zahl</translation>
    </message>
    <message>
        <source>a number is too large to be read</source>
        <translation>eine Zahl ist zu groß zum Lesen</translation>
    </message>
    <message>
        <source>a part of it states %1 bytes, more than 256 MiB</source>
        <translation>ein Teil davon soll %1 Byte groß sein, mehr als 256 MiB</translation>
    </message>
    <message>
        <source>a part of the boundary of &apos;%1&apos; is missing or another</source>
        <translation>ein Teil der Feldgrenze von „%1“ fehlt oder ist anders</translation>
    </message>
    <message>
        <source>a point</source>
        <translation>einen Punkt</translation>
    </message>
    <message>
        <source>a point has no place in EPSG:%1</source>
        <translation>ein Punkt hat keine Lage in EPSG:%1</translation>
    </message>
    <message>
        <source>a point or a line in WGS84 such as LINESTRING (4.1 52.0, 4.2 52.0)</source>
        <translation>ein Punkt oder eine Linie in WGS84 wie LINESTRING (4.1 52.0, 4.2 52.0)</translation>
    </message>
    <message>
        <source>a record of the recording is damaged</source>
        <translation>ein Eintrag der Aufzeichnung ist beschädigt</translation>
    </message>
    <message>
        <source>a sliver of %1 was left out</source>
        <translation>ein schmaler Rest von %1 wurde weggelassen</translation>
    </message>
    <message>
        <source>a track that ended %1 from where it began was closed</source>
        <translation>eine Aufzeichnung, die %1 vor ihrem Anfang endete, wurde geschlossen</translation>
    </message>
    <message>
        <source>a value of its own</source>
        <translation>ein eigener Wert</translation>
    </message>
    <message>
        <source>add the .prj file that belongs to it, or export the field again in WGS84</source>
        <translation>die zugehörige .prj-Datei dazulegen oder den Schlag in WGS84 neu exportieren</translation>
    </message>
    <message>
        <source>allow it to be kept as a backup</source>
        <translation>erlauben, dass es als Sicherung behalten wird</translation>
    </message>
    <message>
        <source>an obstacle</source>
        <translation>ein Hindernis</translation>
    </message>
    <message>
        <source>an obstacle has no shape</source>
        <translation>ein Hindernis hat keine Form</translation>
    </message>
    <message>
        <source>an overlap of %1 leaves nothing of %2</source>
        <translation>eine Überlappung von %1 lässt von %2 nichts übrig</translation>
    </message>
    <message>
        <source>boundary accuracy</source>
        <translation>Genauigkeit der Feldgrenze</translation>
    </message>
    <message>
        <source>changes cannot be kept for the case of a crash: %1</source>
        <translation>Änderungen können nicht für den Fall eines Absturzes bewahrt werden: %1</translation>
    </message>
    <message>
        <source>check its coordinates</source>
        <translation>seine Koordinaten prüfen</translation>
    </message>
    <message>
        <source>check that the folder can be written to</source>
        <translation>prüfen, ob in den Ordner geschrieben werden darf</translation>
    </message>
    <message>
        <source>check that you may read it</source>
        <translation>prüfen, ob sie gelesen werden darf</translation>
    </message>
    <message>
        <source>check the boundary for crossings</source>
        <translation>die Feldgrenze auf Kreuzungen prüfen</translation>
    </message>
    <message>
        <source>check the coordinate system, correct this point, or split the field</source>
        <translation>das Koordinatensystem prüfen, diesen Punkt berichtigen oder den Schlag teilen</translation>
    </message>
    <message>
        <source>check the file&apos;s coordinate system</source>
        <translation>das Koordinatensystem der Datei prüfen</translation>
    </message>
    <message>
        <source>check the operating width and the overlap</source>
        <translation>Arbeitsbreite und Überlappung prüfen</translation>
    </message>
    <message>
        <source>check the path</source>
        <translation>den Dateipfad prüfen</translation>
    </message>
    <message>
        <source>check the width and how far the edge lies from the line</source>
        <translation>die Breite prüfen und wie weit der Rand von der Linie liegt</translation>
    </message>
    <message>
        <source>check the width of the implement, or take the track as driven around the field</source>
        <translation>die Breite des Geräts prüfen oder die Aufzeichnung als Fahrt um das Feld nehmen</translation>
    </message>
    <message>
        <source>choose a narrower headland or a narrower machine</source>
        <translation>ein schmaleres Vorgewende oder eine schmalere Maschine wählen</translation>
    </message>
    <message>
        <source>choose a smaller machine or check the boundary&apos;s coordinate system</source>
        <translation>eine kleinere Maschine wählen oder das Koordinatensystem der Feldgrenze prüfen</translation>
    </message>
    <message>
        <source>choose another format</source>
        <translation>ein anderes Format wählen</translation>
    </message>
    <message>
        <source>choose one by its id: %1</source>
        <translation>einen nach seiner Kennung wählen: %1</translation>
    </message>
    <message>
        <source>choose one by its number in the file: %1</source>
        <translation>einen nach seiner Nummer in der Datei wählen: %1</translation>
    </message>
    <message>
        <source>choose the format rosbag2-mcap</source>
        <translation>das Format rosbag2-mcap wählen</translation>
    </message>
    <message>
        <source>close it there first</source>
        <translation>es dort zuerst schließen</translation>
    </message>
    <message>
        <source>contour needs heights</source>
        <translation>Höhenlinien brauchen Höhen</translation>
    </message>
    <message>
        <source>copy it again, or mend it with &apos;mcap recover&apos; or sqlite3&apos;s &apos;.recover&apos;</source>
        <translation>neu kopieren oder mit „mcap recover“ oder „.recover“ von sqlite3 reparieren</translation>
    </message>
    <message>
        <source>copy or export it again</source>
        <translation>neu kopieren oder exportieren</translation>
    </message>
    <message>
        <source>copy or export the recording again</source>
        <translation>die Aufzeichnung neu kopieren oder exportieren</translation>
    </message>
    <message>
        <source>copy the whole folder</source>
        <translation>den ganzen Ordner kopieren</translation>
    </message>
    <message>
        <source>correct it, or remove the hole or obstacle from the file</source>
        <translation>berichtigen, oder die Aussparung oder das Hindernis aus der Datei entfernen</translation>
    </message>
    <message>
        <source>correct or delete this point in the file</source>
        <translation>diesen Punkt in der Datei berichtigen oder löschen</translation>
    </message>
    <message>
        <source>correct or remove the line</source>
        <translation>die Zeile berichtigen oder entfernen</translation>
    </message>
    <message>
        <source>correct or remove the point</source>
        <translation>den Punkt berichtigen oder entfernen</translation>
    </message>
    <message>
        <source>correct the line, or export the track in WGS84</source>
        <translation>die Zeile berichtigen oder die Aufzeichnung in WGS84 exportieren</translation>
    </message>
    <message>
        <source>could not be read: %1</source>
        <translation>konnte nicht gelesen werden: %1</translation>
    </message>
    <message>
        <source>could not be written: %1</source>
        <translation>konnte nicht geschrieben werden: %1</translation>
    </message>
    <message>
        <source>crosses an obstacle</source>
        <translation>quert ein Hindernis</translation>
    </message>
    <message>
        <source>cut it into the days or fields that it holds</source>
        <translation>in die Tage oder Schläge aufteilen, die sie enthält</translation>
    </message>
    <message>
        <source>decimal commas in the place of the field were taken for points</source>
        <translation>Dezimalkommas in der Lage des Schlags wurden als Punkte gelesen</translation>
    </message>
    <message>
        <source>delete some of them</source>
        <translation>einige davon löschen</translation>
    </message>
    <message>
        <source>delete the hole that covers it</source>
        <translation>die Aussparung löschen, die alles bedeckt</translation>
    </message>
    <message>
        <source>did you mean &apos;%1&apos;?</source>
        <translation>meinten Sie „%1“?</translation>
    </message>
    <message>
        <source>did you mean &apos;%1&apos;? use one of: %2; or give a machine file (.json)</source>
        <translation>meinten Sie „%1“? eine davon verwenden: %2; oder eine Maschinendatei (.json) angeben</translation>
    </message>
    <message>
        <source>download the file and give its path</source>
        <translation>die Datei herunterladen und ihren Pfad angeben</translation>
    </message>
    <message>
        <source>draw it again</source>
        <translation>neu zeichnen</translation>
    </message>
    <message>
        <source>draw it again with at least 3 corners</source>
        <translation>mit mindestens 3 Ecken neu zeichnen</translation>
    </message>
    <message>
        <source>draw it as an area, or remove it from the file</source>
        <translation>als Fläche zeichnen oder aus der Datei entfernen</translation>
    </message>
    <message>
        <source>draw it, or remove it from the file</source>
        <translation>zeichnen oder aus der Datei entfernen</translation>
    </message>
    <message>
        <source>draw one or open a file that has one</source>
        <translation>eine zeichnen oder eine Datei öffnen, die eine hat</translation>
    </message>
    <message>
        <source>draw or open one in the window first</source>
        <translation>zuerst einen im Fenster zeichnen oder öffnen</translation>
    </message>
    <message>
        <source>drive on to where the recording began, or take the track as worked land</source>
        <translation>bis dahin weiterfahren, wo die Aufzeichnung begann, oder sie als bearbeitetes Land nehmen</translation>
    </message>
    <message>
        <source>export fewer fields at once</source>
        <translation>weniger Schläge auf einmal exportieren</translation>
    </message>
    <message>
        <source>export it again</source>
        <translation>neu exportieren</translation>
    </message>
    <message>
        <source>export it again with its coordinate system</source>
        <translation>mit seinem Koordinatensystem neu exportieren</translation>
    </message>
    <message>
        <source>export or copy it again</source>
        <translation>neu exportieren oder kopieren</translation>
    </message>
    <message>
        <source>export the boundary as a polygon</source>
        <translation>die Feldgrenze als Polygon exportieren</translation>
    </message>
    <message>
        <source>export the field again in WGS84 (longitude and latitude)</source>
        <translation>den Schlag in WGS84 (Längen- und Breitengrade) neu exportieren</translation>
    </message>
    <message>
        <source>export the field with its boundary</source>
        <translation>den Schlag mit seiner Feldgrenze exportieren</translation>
    </message>
    <message>
        <source>export the field with its boundary; furrow-cli compare reads what a machine recorded</source>
        <translation>den Schlag mit seiner Feldgrenze exportieren; furrow-cli compare liest, was eine Maschine aufgezeichnet hat</translation>
    </message>
    <message>
        <source>export the fields again in one coordinate system</source>
        <translation>die Schläge noch einmal in einem einzigen Koordinatensystem exportieren</translation>
    </message>
    <message>
        <source>export the recorded track, not only its waypoints</source>
        <translation>die aufgezeichnete Fahrt exportieren, nicht nur ihre Wegpunkte</translation>
    </message>
    <message>
        <source>feature %1</source>
        <translation>Objekt %1</translation>
    </message>
    <message>
        <source>fewer than 3 different points enclose nothing</source>
        <translation>weniger als 3 verschiedene Punkte umschließen nichts</translation>
    </message>
    <message>
        <source>free some space on it, or use another one</source>
        <translation>Platz darauf schaffen oder einen anderen verwenden</translation>
    </message>
    <message>
        <source>free some space on the stick</source>
        <translation>Platz auf dem Stick schaffen</translation>
    </message>
    <message>
        <source>free some space or choose another folder</source>
        <translation>Platz schaffen oder einen anderen Ordner wählen</translation>
    </message>
    <message>
        <source>gate %1</source>
        <translation>Zufahrt %1</translation>
    </message>
    <message>
        <source>give %1</source>
        <translation>%1 angeben</translation>
    </message>
    <message>
        <source>give 0 m or more</source>
        <translation>0 m oder mehr angeben</translation>
    </message>
    <message>
        <source>give GPX, CSV, an NMEA or gpsd log, ISOXML task data (folder, TASKDATA.XML or zip) or a rosbag2</source>
        <translation>GPX, CSV, ein Protokoll von NMEA oder gpsd, ISOXML-Auftragsdaten (Ordner, TASKDATA.XML oder ZIP) oder ein rosbag2 angeben</translation>
    </message>
    <message>
        <source>give GeoJSON, a shapefile (.shp or .zip), TASKDATA.XML, KML, KMZ, GeoPackage, GML, FlatGeobuf, DXF, WKT or CSV</source>
        <translation>GeoJSON, Shapefile (.shp oder .zip), TASKDATA.XML, KML, KMZ, GeoPackage, GML, FlatGeobuf, DXF, WKT oder CSV angeben</translation>
    </message>
    <message>
        <source>give a GeoTIFF, or a world file (.pgw) beside the PNG</source>
        <translation>ein GeoTIFF angeben oder eine World-Datei (.pgw) neben dem PNG</translation>
    </message>
    <message>
        <source>give a buffer of 0 m or more</source>
        <translation>einen Abstand von 0 m oder mehr angeben</translation>
    </message>
    <message>
        <source>give a distance up to 50 m</source>
        <translation>einen Abstand bis 50 m angeben</translation>
    </message>
    <message>
        <source>give a gap up to 100 m</source>
        <translation>eine Lücke bis 100 m angeben</translation>
    </message>
    <message>
        <source>give a plan and a track of the same field</source>
        <translation>Plan und Aufzeichnung vom selben Feld angeben</translation>
    </message>
    <message>
        <source>give a width up to 100 m</source>
        <translation>eine Breite bis 100 m angeben</translation>
    </message>
    <message>
        <source>give an overhang of 0 to 100 m</source>
        <translation>einen Überstand von 0 bis 100 m angeben</translation>
    </message>
    <message>
        <source>give a curve that does not, or plan its parts apart</source>
        <translation>eine Kurve ohne Kreuzung angeben oder ihre Teile getrennt planen</translation>
    </message>
    <message>
        <source>give a file on a disk</source>
        <translation>eine Datei auf einem Datenträger angeben</translation>
    </message>
    <message>
        <source>give a file with a line for each row</source>
        <translation>eine Datei mit einer Linie je Reihe angeben</translation>
    </message>
    <message>
        <source>give a gate, or a point in the field</source>
        <translation>eine Zufahrt oder einen Punkt im Schlag angeben</translation>
    </message>
    <message>
        <source>give a gentler curve, or one without a turn back</source>
        <translation>eine sanftere Kurve angeben oder eine ohne Umkehr</translation>
    </message>
    <message>
        <source>give a machine file (JSON)</source>
        <translation>eine Maschinendatei (JSON) angeben</translation>
    </message>
    <message>
        <source>give a number</source>
        <translation>eine Zahl angeben</translation>
    </message>
    <message>
        <source>give a number from %1 to %2</source>
        <translation>eine Zahl von %1 bis %2 angeben</translation>
    </message>
    <message>
        <source>give a number from 0 to %1</source>
        <translation>eine Zahl von 0 bis %1 angeben</translation>
    </message>
    <message>
        <source>give a number in %1</source>
        <translation>eine Zahl in %1 angeben</translation>
    </message>
    <message>
        <source>give a picture of at most 100 million pixels</source>
        <translation>ein Bild mit höchstens 100 Millionen Pixeln angeben</translation>
    </message>
    <message>
        <source>give a point such as POINT (4.1 52.0)</source>
        <translation>einen Punkt wie POINT (4.1 52.0) angeben</translation>
    </message>
    <message>
        <source>give a smaller margin or check the obstacles</source>
        <translation>einen kleineren Sicherheitsabstand angeben oder die Hindernisse prüfen</translation>
    </message>
    <message>
        <source>give a smaller number</source>
        <translation>eine kleinere Zahl angeben</translation>
    </message>
    <message>
        <source>give a text in quotes</source>
        <translation>einen Text in Anführungszeichen angeben</translation>
    </message>
    <message>
        <source>give a transverse Mercator with +lat_0 and +lon_0</source>
        <translation>eine transversale Mercatorprojektion mit +lat_0 und +lon_0 angeben</translation>
    </message>
    <message>
        <source>give a width of 0 m or more</source>
        <translation>eine Breite von 0 m oder mehr angeben</translation>
    </message>
    <message>
        <source>give an EPSG code, as in SRID=4326;POLYGON(...)</source>
        <translation>einen EPSG-Code angeben, wie SRID=4326;POLYGON(...)</translation>
    </message>
    <message>
        <source>give both in degrees, or remove the row</source>
        <translation>beide in Grad angeben oder die Zeile entfernen</translation>
    </message>
    <message>
        <source>give each point as [longitude, latitude]</source>
        <translation>jeden Punkt als [Längengrad, Breitengrad] angeben</translation>
    </message>
    <message>
        <source>give heights as a GeoTIFF or an ASCII grid</source>
        <translation>Höhen als GeoTIFF oder ASCII-Raster angeben</translation>
    </message>
    <message>
        <source>give heights that cover the field</source>
        <translation>Höhen angeben, die den Schlag abdecken</translation>
    </message>
    <message>
        <source>give it a kind, or remove it from the file</source>
        <translation>eine Art angeben oder es aus der Datei entfernen</translation>
    </message>
    <message>
        <source>give it as WKT in WGS84, %1</source>
        <translation>als WKT in WGS84 angeben, %1</translation>
    </message>
    <message>
        <source>give it as WKT in WGS84, such as LINESTRING (4.1 52.0, 4.2 52.0, 4.3 52.1)</source>
        <translation>als WKT in WGS84 angeben, wie LINESTRING (4.1 52.0, 4.2 52.0, 4.3 52.1)</translation>
    </message>
    <message>
        <source>give it as WKT in WGS84, such as POINT (4.1 52.0)</source>
        <translation>als WKT in WGS84 angeben, wie POINT (4.1 52.0)</translation>
    </message>
    <message>
        <source>give it the field that it lies in, or remove it from the file</source>
        <translation>den Schlag angeben, in dem es liegt, oder es aus der Datei entfernen</translation>
    </message>
    <message>
        <source>give its width while it is folded</source>
        <translation>die Breite im geklappten Zustand angeben</translation>
    </message>
    <message>
        <source>give less than the operating width</source>
        <translation>weniger als die Arbeitsbreite angeben</translation>
    </message>
    <message>
        <source>give metres, 0 or more</source>
        <translation>Meter angeben, 0 oder mehr</translation>
    </message>
    <message>
        <source>give min_turning_radius_m or max_steering_angle_deg</source>
        <translation>min_turning_radius_m oder max_steering_angle_deg angeben</translation>
    </message>
    <message>
        <source>give one of %1 or a point such as POINT (4.1 52.0)</source>
        <translation>eine von %1 oder einen Punkt wie POINT (4.1 52.0) angeben</translation>
    </message>
    <message>
        <source>give one of the files in it</source>
        <translation>eine der Dateien darin angeben</translation>
    </message>
    <message>
        <source>give operating_width_m in metres</source>
        <translation>operating_width_m in Metern angeben</translation>
    </message>
    <message>
        <source>give the file TASKDATA.XML</source>
        <translation>die Datei TASKDATA.XML angeben</translation>
    </message>
    <message>
        <source>give the folder of a field</source>
        <translation>den Ordner eines Schlags angeben</translation>
    </message>
    <message>
        <source>give the folder of one of these, or a file in it</source>
        <translation>den Ordner von einem davon oder eine Datei darin angeben</translation>
    </message>
    <message>
        <source>give the folder of one recording</source>
        <translation>den Ordner einer Aufzeichnung angeben</translation>
    </message>
    <message>
        <source>give the folder or zip with TASKDATA.XML and its TLG files, a rosbag2 folder, or one file</source>
        <translation>den Ordner oder das ZIP mit TASKDATA.XML und den TLG-Dateien, einen Ordner von rosbag2 oder eine Datei angeben</translation>
    </message>
    <message>
        <source>give the points in degrees (WGS84), longitude in lon and latitude in lat</source>
        <translation>die Punkte in Grad (WGS84) angeben, den Längengrad in lon und den Breitengrad in lat</translation>
    </message>
    <message>
        <source>give true or false</source>
        <translation>true oder false angeben</translation>
    </message>
    <message>
        <source>give two points at least 1 m apart</source>
        <translation>zwei Punkte angeben, die mindestens 1 m auseinander liegen</translation>
    </message>
    <message>
        <source>give x_m and y_m in the plan&apos;s frame, or longitude and latitude</source>
        <translation>x_m und y_m im Bezugssystem des Plans angeben oder Länge und Breite</translation>
    </message>
    <message>
        <source>guidance lines without two points</source>
        <translation>Leitlinien ohne zwei Punkte</translation>
    </message>
    <message>
        <source>guidance patterns whose points do not fit their kind</source>
        <translation>Leitlinien, deren Punkte nicht zu ihrer Art passen</translation>
    </message>
    <message>
        <source>guidance patterns without a line</source>
        <translation>Leitlinien ohne Verlauf</translation>
    </message>
    <message>
        <source>headland pass %1</source>
        <translation>Vorgewendespur %1</translation>
    </message>
    <message>
        <source>hole %1 encloses no area and was left out</source>
        <translation>Aussparung %1 umschließt keine Fläche und wurde weggelassen</translation>
    </message>
    <message>
        <source>it does not say in which coordinate system it is</source>
        <translation>es sagt nicht, in welchem Koordinatensystem es ist</translation>
    </message>
    <message>
        <source>it does not say what it is</source>
        <translation>es sagt nicht, was es ist</translation>
    </message>
    <message>
        <source>it does not say which field it belongs to</source>
        <translation>es sagt nicht, zu welchem Schlag es gehört</translation>
    </message>
    <message>
        <source>it has %1 by %2 pixels</source>
        <translation>es hat %1 mal %2 Pixel</translation>
    </message>
    <message>
        <source>it has %1: %2</source>
        <translation>sie hat %1: %2</translation>
    </message>
    <message>
        <source>it has another coordinate system than the file</source>
        <translation>es hat ein anderes Koordinatensystem als die Datei</translation>
    </message>
    <message>
        <source>it has more than %1 parts</source>
        <translation>es hat mehr als %1 Teile</translation>
    </message>
    <message>
        <source>it has no heights where the field is</source>
        <translation>es hat keine Höhen, wo der Schlag liegt</translation>
    </message>
    <message>
        <source>it has no shape</source>
        <translation>es hat keine Form</translation>
    </message>
    <message>
        <source>it has: %1</source>
        <translation>er hat: %1</translation>
    </message>
    <message>
        <source>it holds more than %1 files</source>
        <translation>es enthält mehr als %1 Dateien</translation>
    </message>
    <message>
        <source>it holds more than %1 positions</source>
        <translation>sie enthält mehr als %1 Positionen</translation>
    </message>
    <message>
        <source>it is a line at %1 without a width</source>
        <translation>es ist eine Linie bei %1 ohne Breite</translation>
    </message>
    <message>
        <source>it is a point at %1 without a size</source>
        <translation>es ist ein Punkt bei %1 ohne Größe</translation>
    </message>
    <message>
        <source>it is no closed line</source>
        <translation>es ist keine geschlossene Linie</translation>
    </message>
    <message>
        <source>it is no raster of heights</source>
        <translation>das ist kein Höhenraster</translation>
    </message>
    <message>
        <source>it is no rosbag2 that can be read (%1)</source>
        <translation>das ist kein lesbares rosbag2 (%1)</translation>
    </message>
    <message>
        <source>it is not a length</source>
        <translation>das ist keine Länge</translation>
    </message>
    <message>
        <source>it is not what a plan&apos;s is</source>
        <translation>das ist nicht wie in einem Plan</translation>
    </message>
    <message>
        <source>it lies in none of the %1 fields</source>
        <translation>es liegt in keinem der %1 Schläge</translation>
    </message>
    <message>
        <source>it lies outside the field</source>
        <translation>es liegt außerhalb des Schlags</translation>
    </message>
    <message>
        <source>it may be damaged; copy or export it again</source>
        <translation>es ist vielleicht beschädigt; neu kopieren oder exportieren</translation>
    </message>
    <message>
        <source>it names no local frame</source>
        <translation>es nennt kein lokales Koordinatensystem</translation>
    </message>
    <message>
        <source>it names no machine</source>
        <translation>es nennt keine Maschine</translation>
    </message>
    <message>
        <source>it needs latitude and longitude, as in 52.09,5.66</source>
        <translation>sie braucht Breiten- und Längengrad, wie 52.09,5.66</translation>
    </message>
    <message>
        <source>its buffer is not a length</source>
        <translation>sein Abstand ist keine Länge</translation>
    </message>
    <message>
        <source>its compression &apos;%1&apos; is not known</source>
        <translation>die Kompression „%1“ ist nicht bekannt</translation>
    </message>
    <message>
        <source>its overhang is not a length from 0 to 100 m</source>
        <translation>sein Überstand ist keine Länge von 0 bis 100 m</translation>
    </message>
    <message>
        <source>its coordinate system &apos;%1&apos; cannot be turned into WGS84</source>
        <translation>das Koordinatensystem „%1“ lässt sich nicht in WGS84 umrechnen</translation>
    </message>
    <message>
        <source>its coordinate system &apos;%1&apos; is not known</source>
        <translation>das Koordinatensystem „%1“ ist nicht bekannt</translation>
    </message>
    <message>
        <source>its coordinate system cannot be turned into WGS84</source>
        <translation>das Koordinatensystem lässt sich nicht in WGS84 umrechnen</translation>
    </message>
    <message>
        <source>its coordinate system would have to be fetched from &apos;%1&apos;</source>
        <translation>ihr Koordinatensystem müsste von „%1“ geholt werden</translation>
    </message>
    <message>
        <source>its file is missing</source>
        <translation>seine Datei fehlt</translation>
    </message>
    <message>
        <source>its heights cannot be read</source>
        <translation>seine Höhen können nicht gelesen werden</translation>
    </message>
    <message>
        <source>its holes leave nothing of it</source>
        <translation>die Aussparungen lassen nichts davon übrig</translation>
    </message>
    <message>
        <source>its kind &apos;%1&apos; is not known</source>
        <translation>seine Art „%1“ ist nicht bekannt</translation>
    </message>
    <message>
        <source>its points enclose no area</source>
        <translation>seine Punkte umschließen keine Fläche</translation>
    </message>
    <message>
        <source>its width is not a length</source>
        <translation>ihre Breite ist keine Länge</translation>
    </message>
    <message>
        <source>keep one of them</source>
        <translation>einen davon behalten</translation>
    </message>
    <message>
        <source>keep the .shp, .shx, .dbf and .prj files together</source>
        <translation>.shp, .shx, .dbf und .prj beieinander lassen</translation>
    </message>
    <message>
        <source>leave it out, or give a project of the window</source>
        <translation>weglassen oder ein Projekt des Fensters angeben</translation>
    </message>
    <message>
        <source>leaves the field by %1</source>
        <translation>verlässt den Schlag um %1</translation>
    </message>
    <message>
        <source>left out: %1</source>
        <translation>weggelassen: %1</translation>
    </message>
    <message>
        <source>left out: %1 %2</source>
        <translation>weggelassen: %1 %2</translation>
    </message>
    <message>
        <source>line %1 is left out: it is damaged</source>
        <translation>Zeile %1 wird weggelassen: sie ist beschädigt</translation>
    </message>
    <message>
        <source>line %1, column %2</source>
        <translation>Zeile %1, Spalte %2</translation>
    </message>
    <message>
        <source>lines in WGS84 such as MULTILINESTRING ((4.1 52.0, 4.2 52.0), (4.1 52.1, 4.2 52.1))</source>
        <translation>Linien in WGS84 wie MULTILINESTRING ((4.1 52.0, 4.2 52.0), (4.1 52.1, 4.2 52.1))</translation>
    </message>
    <message>
        <source>lines that guide nothing</source>
        <translation>Linien, die nichts leiten</translation>
    </message>
    <message>
        <source>lon=&quot;%1&quot; lat=&quot;%2&quot; is no place on Earth</source>
        <translation>lon=&quot;%1&quot; lat=&quot;%2&quot; ist kein Ort auf der Erde</translation>
    </message>
    <message>
        <source>look for a missing comma, quote or brace just before it</source>
        <translation>kurz davor nach einem fehlenden Komma, Anführungszeichen oder einer Klammer suchen</translation>
    </message>
    <message>
        <source>most of its lines are not JSON</source>
        <translation>die meisten Zeilen sind kein JSON</translation>
    </message>
    <message>
        <source>most of its sentences have a wrong checksum</source>
        <translation>die meisten Sätze haben eine falsche Prüfsumme</translation>
    </message>
    <message>
        <source>move one of the points there, so that it is clear which side is field</source>
        <translation>dort einen Punkt verschieben, damit klar ist, welche Seite zum Schlag gehört</translation>
    </message>
    <message>
        <source>move or delete it</source>
        <translation>verschieben oder löschen</translation>
    </message>
    <message>
        <source>name a raster of heights, such as a GeoTIFF</source>
        <translation>ein Höhenraster nennen, zum Beispiel ein GeoTIFF</translation>
    </message>
    <message>
        <source>name each swath once</source>
        <translation>jede Spur einmal nennen</translation>
    </message>
    <message>
        <source>name each swath once, with a minus where it is driven backwards</source>
        <translation>jede Spur einmal nennen, mit einem Minus, wo sie andersherum gefahren wird</translation>
    </message>
    <message>
        <source>name one, such as GeoJSON with a LineString for each row</source>
        <translation>eine nennen, zum Beispiel GeoJSON mit einem LineString je Reihe</translation>
    </message>
    <message>
        <source>name the columns in the first row</source>
        <translation>die Spalten in der ersten Zeile benennen</translation>
    </message>
    <message>
        <source>name the columns, for example time,lon,lat,speed_kmh in the first line</source>
        <translation>die Spalten benennen, zum Beispiel time,lon,lat,speed_kmh in der ersten Zeile</translation>
    </message>
    <message>
        <source>name the folder of a plan, as furrow-cli plan writes it</source>
        <translation>den Ordner eines Plans nennen, wie furrow-cli plan ihn schreibt</translation>
    </message>
    <message>
        <source>neither turning radius nor steering angle is given</source>
        <translation>weder Wenderadius noch Lenkwinkel ist angegeben</translation>
    </message>
    <message>
        <source>no boundary can be read from this file (%1)</source>
        <translation>aus dieser Datei lässt sich keine Feldgrenze lesen (%1)</translation>
    </message>
    <message>
        <source>no header names a longitude and a latitude (or x_m and y_m)</source>
        <translation>keine Kopfzeile nennt Länge und Breite (oder x_m und y_m)</translation>
    </message>
    <message>
        <source>no pixel of the picture is worked</source>
        <translation>kein Pixel des Bildes ist bearbeitet</translation>
    </message>
    <message>
        <source>no row of this table has a position</source>
        <translation>keine Zeile dieser Tabelle hat eine Position</translation>
    </message>
    <message>
        <source>no swath fits inside the headland</source>
        <translation>in die Innenfläche passt keine Spur</translation>
    </message>
    <message>
        <source>no topic of this bag has a position</source>
        <translation>kein Topic dieses Bags hat eine Position</translation>
    </message>
    <message>
        <source>none of its %1 RMC and GGA sentences has a position</source>
        <translation>keiner der %1 RMC- und GGA-Sätze hat eine Position</translation>
    </message>
    <message>
        <source>none of its %1 position reports has a position</source>
        <translation>keine der %1 Positionsmeldungen hat eine Position</translation>
    </message>
    <message>
        <source>none of its %1 time logs holds a position</source>
        <translation>keines der %1 Fahrtprotokolle enthält eine Position</translation>
    </message>
    <message>
        <source>none of the tracks has more than one position</source>
        <translation>keine der Aufzeichnungen hat mehr als eine Position</translation>
    </message>
    <message>
        <source>nothing is left of the land inside of this track</source>
        <translation>vom Land innerhalb dieser Aufzeichnung bleibt nichts übrig</translation>
    </message>
    <message>
        <source>obstacle %1</source>
        <translation>Hindernis %1</translation>
    </message>
    <message>
        <source>obstacles outside the boundary</source>
        <translation>Hindernisse außerhalb der Feldgrenze</translation>
    </message>
    <message>
        <source>obstacles that are holes already</source>
        <translation>Hindernisse, die schon Aussparungen sind</translation>
    </message>
    <message>
        <source>one of its choices</source>
        <translation>eine der Auswahlmöglichkeiten</translation>
    </message>
    <message>
        <source>only files on this computer are read</source>
        <translation>nur Dateien auf diesem Computer werden gelesen</translation>
    </message>
    <message>
        <source>only the fields of a project have plans</source>
        <translation>nur die Schläge eines Projekts haben Pläne</translation>
    </message>
    <message>
        <source>open a file of your own</source>
        <translation>eine eigene Datei öffnen</translation>
    </message>
    <message>
        <source>open it as a field boundary, or choose another file</source>
        <translation>als Feldgrenze öffnen oder eine andere Datei wählen</translation>
    </message>
    <message>
        <source>open it with a newer Furrow; the file was left as it is</source>
        <translation>mit einem neueren Furrow öffnen; die Datei blieb, wie sie ist</translation>
    </message>
    <message>
        <source>open the field of that plan first, or record longitude and latitude</source>
        <translation>zuerst den Schlag dieses Plans öffnen oder Länge und Breite aufzeichnen</translation>
    </message>
    <message>
        <source>opennav_coverage goal</source>
        <translation>opennav_coverage-Ziel</translation>
    </message>
    <message>
        <source>opennav_coverage lays swaths and turns of its own from the goal; they need not be those of this plan.</source>
        <translation>opennav_coverage legt aus dem Ziel eigene Spuren und Wendungen; sie müssen nicht die dieses Plans sein.</translation>
    </message>
    <message>
        <source>part %1</source>
        <translation>Teil %1</translation>
    </message>
    <message>
        <source>part %1, point %2</source>
        <translation>Teil %1, Punkt %2</translation>
    </message>
    <message>
        <source>path.csv has %1 segments and plan.geojson %2</source>
        <translation>path.csv hat %1 Abschnitte und plan.geojson %2</translation>
    </message>
    <message>
        <source>per m²</source>
        <translation>je m²</translation>
    </message>
    <message>
        <source>pivot needs its centre</source>
        <translation>Kreise brauchen ihre Mitte</translation>
    </message>
    <message>
        <source>plan the field first: furrow-cli plan FIELD --out plan</source>
        <translation>zuerst den Schlag planen: furrow-cli plan FIELD --out plan</translation>
    </message>
    <message>
        <source>points that are no gates</source>
        <translation>Punkte, die keine Zufahrten sind</translation>
    </message>
    <message>
        <source>polygons of a kind that is not used</source>
        <translation>Polygone einer nicht verwendeten Art</translation>
    </message>
    <message>
        <source>put the EPSG code into its name, as in field_EPSG32632.dxf</source>
        <translation>den EPSG-Code in den Namen schreiben, wie field_EPSG32632.dxf</translation>
    </message>
    <message>
        <source>record %1 has a value that its header does not name</source>
        <translation>Eintrag %1 hat einen Wert, den die Kopfdatei nicht nennt</translation>
    </message>
    <message>
        <source>record a position every second, or every few metres</source>
        <translation>jede Sekunde oder alle paar Meter eine Position aufzeichnen</translation>
    </message>
    <message>
        <source>record or draw its boundary first</source>
        <translation>zuerst die Feldgrenze aufnehmen oder zeichnen</translation>
    </message>
    <message>
        <source>record or export it again</source>
        <translation>neu aufzeichnen oder exportieren</translation>
    </message>
    <message>
        <source>record sensor_msgs/NavSatFix, nav_msgs/Odometry, geometry_msgs/PoseStamped or nav_msgs/Path</source>
        <translation>sensor_msgs/NavSatFix, nav_msgs/Odometry, geometry_msgs/PoseStamped oder nav_msgs/Path aufzeichnen</translation>
    </message>
    <message>
        <source>record the log again with a receiver that has a fix</source>
        <translation>das Protokoll mit einem Empfänger neu aufzeichnen, der seine Position kennt</translation>
    </message>
    <message>
        <source>record the positions without pictures and point clouds</source>
        <translation>die Positionen ohne Bilder und Punktwolken aufzeichnen</translation>
    </message>
    <message>
        <source>record with a correction signal (EGNOS, RTK), or under an open sky</source>
        <translation>mit Korrektursignal (EGNOS, RTK) oder unter freiem Himmel aufzeichnen</translation>
    </message>
    <message>
        <source>record with zstd, lz4 or no compression</source>
        <translation>mit zstd, lz4 oder ohne Kompression aufzeichnen</translation>
    </message>
    <message>
        <source>remove it from the file, or add its field</source>
        <translation>aus der Datei entfernen oder seinen Schlag ergänzen</translation>
    </message>
    <message>
        <source>remove it; keys look like operating_width_m, vehicle_width_m, can_reverse</source>
        <translation>entfernen; Schlüssel sehen aus wie operating_width_m, vehicle_width_m, can_reverse</translation>
    </message>
    <message>
        <source>restore a copy of the file</source>
        <translation>eine Kopie der Datei wiederherstellen</translation>
    </message>
    <message>
        <source>rings that overlap each other were joined</source>
        <translation>Ringe, die sich überlappen, wurden verbunden</translation>
    </message>
    <message>
        <source>rings with fewer than three corners</source>
        <translation>Ringe mit weniger als drei Ecken</translation>
    </message>
    <message>
        <source>rows needs a file of lines</source>
        <translation>Reihen brauchen eine Datei mit Linien</translation>
    </message>
    <message>
        <source>save it again in WGS84</source>
        <translation>in WGS84 neu speichern</translation>
    </message>
    <message>
        <source>save it as GeoTIFF, or with a world file in degrees</source>
        <translation>als GeoTIFF speichern oder mit einer World-Datei in Grad</translation>
    </message>
    <message>
        <source>save the field again, or remove this file</source>
        <translation>den Schlag neu speichern oder diese Datei entfernen</translation>
    </message>
    <message>
        <source>save the project, and free some space</source>
        <translation>das Projekt speichern und Platz schaffen</translation>
    </message>
    <message>
        <source>say how far to keep from it (buffer_m), or draw its outline</source>
        <translation>angeben, wie viel Abstand zu halten ist (buffer_m), oder den Umriss zeichnen</translation>
    </message>
    <message>
        <source>several fields are called &apos;%1&apos;</source>
        <translation>mehrere Schläge heißen „%1“</translation>
    </message>
    <message>
        <source>several plans of &apos;%1&apos; are called &apos;%2&apos;</source>
        <translation>mehrere Pläne von „%1“ heißen „%2“</translation>
    </message>
    <message>
        <source>simplify it to at most a million</source>
        <translation>auf höchstens eine Million vereinfachen</translation>
    </message>
    <message>
        <source>such as LINESTRING (4.1 52.0, 4.2 52.0)</source>
        <translation>wie LINESTRING (4.1 52.0, 4.2 52.0)</translation>
    </message>
    <message>
        <source>such as POINT (4.1 52.0)</source>
        <translation>wie POINT (4.1 52.0)</translation>
    </message>
    <message>
        <source>swath %1</source>
        <translation>Spur %1</translation>
    </message>
    <message>
        <source>swath %1 is named twice</source>
        <translation>Spur %1 ist zweimal genannt</translation>
    </message>
    <message>
        <source>take it away</source>
        <translation>die Angabe entfernen</translation>
    </message>
    <message>
        <source>take off its write protection, or use another one</source>
        <translation>den Schreibschutz aufheben oder einen anderen verwenden</translation>
    </message>
    <message>
        <source>take off the write protection of the stick</source>
        <translation>den Schreibschutz des Sticks aufheben</translation>
    </message>
    <message>
        <source>take the track as driven around the field, or record the work</source>
        <translation>die Aufzeichnung als Fahrt um das Feld nehmen oder die Arbeit aufzeichnen</translation>
    </message>
    <message>
        <source>the .shx file that belongs to it is missing</source>
        <translation>die zugehörige .shx-Datei fehlt</translation>
    </message>
    <message>
        <source>the GPX file is damaged (%1)</source>
        <translation>die GPX-Datei ist beschädigt (%1)</translation>
    </message>
    <message>
        <source>the GPX file is larger than 256 MiB</source>
        <translation>die GPX-Datei ist größer als 256 MiB</translation>
    </message>
    <message>
        <source>the boundary</source>
        <translation>die Feldgrenze</translation>
    </message>
    <message>
        <source>the boundary has %1 points</source>
        <translation>die Feldgrenze hat %1 Punkte</translation>
    </message>
    <message>
        <source>the boundary has no such edge</source>
        <translation>die Feldgrenze hat keine solche Kante</translation>
    </message>
    <message>
        <source>the boundary is that of the guidance group; the field itself has none</source>
        <translation>die Feldgrenze ist die der Leitliniengruppe; der Schlag selbst hat keine</translation>
    </message>
    <message>
        <source>the coordinate system that it names is not known</source>
        <translation>das Koordinatensystem, das sie nennt, ist nicht bekannt</translation>
    </message>
    <message>
        <source>the coordinates lie outside longitude -180 to 180 and latitude -90 to 90</source>
        <translation>die Koordinaten liegen außerhalb der Längengrade -180 bis 180 und Breitengrade -90 bis 90</translation>
    </message>
    <message>
        <source>the curve bends more sharply than this machine can follow (%1 of radius)</source>
        <translation>die Kurve ist enger, als diese Maschine folgen kann (%1 Radius)</translation>
    </message>
    <message>
        <source>the curve crosses itself, %1 from its start</source>
        <translation>die Kurve kreuzt sich selbst, %1 nach ihrem Anfang</translation>
    </message>
    <message>
        <source>the curves from line %1 on are left out: it is damaged</source>
        <translation>die Kurven ab Zeile %1 werden weggelassen: sie ist beschädigt</translation>
    </message>
    <message>
        <source>the edge cannot lie that far from the line</source>
        <translation>der Rand kann nicht so weit von der Linie liegen</translation>
    </message>
    <message>
        <source>the end</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>the field &apos;%1&apos; has no boundary</source>
        <translation>der Schlag „%1“ hat keine Feldgrenze</translation>
    </message>
    <message>
        <source>the field &apos;%1&apos; has no plan &apos;%2&apos;</source>
        <translation>der Schlag „%1“ hat keinen Plan „%2“</translation>
    </message>
    <message>
        <source>the field &apos;%1&apos; is left out: %2</source>
        <translation>der Schlag „%1“ wird weggelassen: %2</translation>
    </message>
    <message>
        <source>the field has neither boundary nor guidance line</source>
        <translation>der Schlag hat weder Feldgrenze noch Leitlinie</translation>
    </message>
    <message>
        <source>the field has no boundary</source>
        <translation>der Schlag hat keine Feldgrenze</translation>
    </message>
    <message>
        <source>the field is more than 100 km across; %1 is farthest from the others</source>
        <translation>der Schlag reicht über mehr als 100 km; %1 liegt am weitesten ab</translation>
    </message>
    <message>
        <source>the field is nowhere as wide as the machine (%1%2)</source>
        <translation>der Schlag ist nirgends so breit wie die Maschine (%1%2)</translation>
    </message>
    <message>
        <source>the fields in this task data have neither boundary nor guidance line</source>
        <translation>die Schläge in diesen Auftragsdaten haben weder Feldgrenze noch Leitlinie</translation>
    </message>
    <message>
        <source>the file cannot be read</source>
        <translation>die Datei kann nicht gelesen werden</translation>
    </message>
    <message>
        <source>the file has %1 fields: %2</source>
        <translation>die Datei hat %1 Schläge: %2</translation>
    </message>
    <message>
        <source>the file is damaged</source>
        <translation>die Datei ist beschädigt</translation>
    </message>
    <message>
        <source>the file is damaged (%1)</source>
        <translation>die Datei ist beschädigt (%1)</translation>
    </message>
    <message>
        <source>the file is damaged here</source>
        <translation>die Datei ist hier beschädigt</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>die Datei ist leer</translation>
    </message>
    <message>
        <source>the file is empty or cannot be read</source>
        <translation>die Datei ist leer oder nicht lesbar</translation>
    </message>
    <message>
        <source>the file is larger than 1 GiB</source>
        <translation>die Datei ist größer als 1 GiB</translation>
    </message>
    <message>
        <source>the file may be cut off or damaged; copy or export it again</source>
        <translation>die Datei ist vielleicht abgeschnitten oder beschädigt; neu kopieren oder exportieren</translation>
    </message>
    <message>
        <source>the file may be cut off or damaged; export it again</source>
        <translation>die Datei ist vielleicht abgeschnitten oder beschädigt; neu exportieren</translation>
    </message>
    <message>
        <source>the folder or zip cannot be read</source>
        <translation>der Ordner oder das Zip kann nicht gelesen werden</translation>
    </message>
    <message>
        <source>the gap is out of range</source>
        <translation>die Lücke liegt außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>the headland is left out: line %1 is damaged</source>
        <translation>das Vorgewende wird weggelassen: Zeile %1 ist beschädigt</translation>
    </message>
    <message>
        <source>the headland of edge %1</source>
        <translation>das Vorgewende an Kante %1</translation>
    </message>
    <message>
        <source>the implement was nowhere down on this track</source>
        <translation>das Gerät war auf dieser Fahrt nirgends abgesenkt</translation>
    </message>
    <message>
        <source>the log is cut off in record %1</source>
        <translation>das Protokoll ist in Eintrag %1 abgeschnitten</translation>
    </message>
    <message>
        <source>the operating width is out of range</source>
        <translation>die Arbeitsbreite liegt außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>the overhang of edge %1</source>
        <translation>der Überstand an Kante %1</translation>
    </message>
    <message>
        <source>edge %1</source>
        <translation>Kante %1</translation>
    </message>
    <message>
        <source>the key is there twice</source>
        <translation>der Schlüssel ist zweimal da</translation>
    </message>
    <message>
        <source>the line after StartFix is no place</source>
        <translation>die Zeile nach StartFix nennt keine Lage</translation>
    </message>
    <message>
        <source>the line crosses itself at %1</source>
        <translation>die Linie kreuzt sich selbst bei %1</translation>
    </message>
    <message>
        <source>the line touches or crosses itself by a sliver; taken apart there</source>
        <translation>die Linie berührt oder kreuzt sich knapp selbst; dort getrennt</translation>
    </message>
    <message>
        <source>the lines from line %1 on are left out: it is damaged</source>
        <translation>die Linien ab Zeile %1 werden weggelassen: sie ist beschädigt</translation>
    </message>
    <message>
        <source>the machine (%1 wide, %2 long%3) fits nowhere into the field</source>
        <translation>die Maschine (%1 breit, %2 lang%3) passt nirgends in den Schlag</translation>
    </message>
    <message>
        <source>the name of a gate or a point in WGS84 such as POINT (4.1 52.0)</source>
        <translation>der Name einer Zufahrt oder ein Punkt in WGS84 wie POINT (4.1 52.0)</translation>
    </message>
    <message>
        <source>the number after SRID= is no coordinate system that is known</source>
        <translation>die Zahl nach SRID= ist kein bekanntes Koordinatensystem</translation>
    </message>
    <message>
        <source>the obstacles leave nothing of the field</source>
        <translation>die Hindernisse lassen nichts vom Schlag übrig</translation>
    </message>
    <message>
        <source>the operating width is missing</source>
        <translation>die Arbeitsbreite fehlt</translation>
    </message>
    <message>
        <source>the part %1 is left out: %2</source>
        <translation>der Teil %1 wird weggelassen: %2</translation>
    </message>
    <message>
        <source>the path of a file</source>
        <translation>der Pfad einer Datei</translation>
    </message>
    <message>
        <source>the picture cannot be read (%1)</source>
        <translation>das Bild kann nicht gelesen werden (%1)</translation>
    </message>
    <message>
        <source>the picture does not say where it lies</source>
        <translation>das Bild sagt nicht, wo es liegt</translation>
    </message>
    <message>
        <source>the picture does not say which coordinate system it uses</source>
        <translation>das Bild sagt nicht, welches Koordinatensystem es hat</translation>
    </message>
    <message>
        <source>the picture is damaged</source>
        <translation>das Bild ist beschädigt</translation>
    </message>
    <message>
        <source>the place lies outside of the field</source>
        <translation>die Stelle liegt außerhalb des Schlags</translation>
    </message>
    <message>
        <source>the plan gives no reason</source>
        <translation>der Plan nennt keinen Grund</translation>
    </message>
    <message>
        <source>the positions of this track are metres in the plan that was driven, not places on Earth</source>
        <translation>die Positionen dieser Aufzeichnung sind Meter im gefahrenen Plan, keine Orte auf der Erde</translation>
    </message>
    <message>
        <source>the recorded path is left out: it is damaged</source>
        <translation>der aufgezeichnete Weg wird weggelassen: er ist beschädigt</translation>
    </message>
    <message>
        <source>the recording cannot be made: %1</source>
        <translation>die Aufzeichnung kann nicht erstellt werden: %1</translation>
    </message>
    <message>
        <source>the recording is cut off in the middle of a record</source>
        <translation>die Aufzeichnung ist mitten in einem Eintrag abgeschnitten</translation>
    </message>
    <message>
        <source>the recording is cut off: its end is missing</source>
        <translation>die Aufzeichnung ist abgeschnitten: das Ende fehlt</translation>
    </message>
    <message>
        <source>the sample field cannot be read</source>
        <translation>der Beispielschlag lässt sich nicht lesen</translation>
    </message>
    <message>
        <source>the shape could not be computed with (%1)</source>
        <translation>mit der Form ließ sich nicht rechnen (%1)</translation>
    </message>
    <message>
        <source>the start</source>
        <translation>Anfang</translation>
    </message>
    <message>
        <source>the stick does not answer any more (%1)</source>
        <translation>der Stick antwortet nicht mehr (%1)</translation>
    </message>
    <message>
        <source>the stick has %1 MB free, and %2 MB are needed</source>
        <translation>auf dem Stick sind %1 MB frei, gebraucht werden %2 MB</translation>
    </message>
    <message>
        <source>the stick is damaged: use another one</source>
        <translation>der Stick ist beschädigt: einen anderen verwenden</translation>
    </message>
    <message>
        <source>the stick is write-protected</source>
        <translation>der Stick ist schreibgeschützt</translation>
    </message>
    <message>
        <source>the strips of this track lie nowhere beside each other</source>
        <translation>die Streifen dieser Aufzeichnung liegen nirgends nebeneinander</translation>
    </message>
    <message>
        <source>the swaths are left out: %1</source>
        <translation>die Spuren werden weggelassen: %1</translation>
    </message>
    <message>
        <source>the table has neither a column WKT nor columns lon and lat</source>
        <translation>die Tabelle hat weder eine Spalte WKT noch Spalten lon und lat</translation>
    </message>
    <message>
        <source>the track does not come to the plan anywhere</source>
        <translation>die Aufzeichnung kommt dem Plan nirgends nahe</translation>
    </message>
    <message>
        <source>the track goes around nothing: from its end to its beginning %1 are missing</source>
        <translation>die Fahrt führt nicht rundherum: vom Ende bis zum Anfang fehlen %1</translation>
    </message>
    <message numerus="yes">
        <source>the track has %n positions only</source>
        <translation>
            <numerusform>die Aufzeichnung hat nur %n Position</numerusform>
            <numerusform>die Aufzeichnung hat nur %n Positionen</numerusform>
        </translation>
    </message>
    <message>
        <source>the transfer after %1</source>
        <translation>die Leerfahrt nach %1</translation>
    </message>
    <message>
        <source>the transfer at %1</source>
        <translation>die Leerfahrt bei %1</translation>
    </message>
    <message>
        <source>the turn after %1</source>
        <translation>die Wendung nach %1</translation>
    </message>
    <message>
        <source>the turn at %1</source>
        <translation>die Wendung bei %1</translation>
    </message>
    <message>
        <source>the way to refill</source>
        <translation>die Fahrt zum Befüllen</translation>
    </message>
    <message>
        <source>the zip cannot be made: %1</source>
        <translation>das Zip kann nicht erstellt werden: %1</translation>
    </message>
    <message>
        <source>there is no &apos;%1&apos;</source>
        <translation>es gibt kein „%1“</translation>
    </message>
    <message>
        <source>there is no &apos;%1&apos; in a machine</source>
        <translation>in einer Maschine gibt es kein „%1“</translation>
    </message>
    <message>
        <source>there is no Field.txt</source>
        <translation>Field.txt fehlt</translation>
    </message>
    <message>
        <source>there is no boundary</source>
        <translation>es gibt keine Feldgrenze</translation>
    </message>
    <message>
        <source>there is no boundary file in this zip</source>
        <translation>in diesem Zip ist keine Datei mit Feldgrenzen</translation>
    </message>
    <message>
        <source>there is no edge %1</source>
        <translation>es gibt keine Kante %1</translation>
    </message>
    <message>
        <source>there is no field &apos;%1&apos; in the file</source>
        <translation>in der Datei gibt es keinen Schlag „%1“</translation>
    </message>
    <message>
        <source>there is no field &apos;%1&apos; in the project</source>
        <translation>es gibt keinen Schlag „%1“ im Projekt</translation>
    </message>
    <message>
        <source>there is no field boundary in it</source>
        <translation>darin ist keine Feldgrenze</translation>
    </message>
    <message>
        <source>there is no field boundary in it, only %1</source>
        <translation>darin ist keine Feldgrenze, nur %1</translation>
    </message>
    <message>
        <source>there is no field in this project</source>
        <translation>in diesem Projekt ist kein Schlag</translation>
    </message>
    <message>
        <source>there is no field in this task data</source>
        <translation>in diesen Auftragsdaten ist kein Schlag</translation>
    </message>
    <message>
        <source>there is no gate &apos;%1&apos;</source>
        <translation>es gibt keine Zufahrt „%1“</translation>
    </message>
    <message>
        <source>there is no line in it</source>
        <translation>darin ist keine Linie</translation>
    </message>
    <message>
        <source>there is no machine &apos;%1&apos;</source>
        <translation>es gibt keine Maschine „%1“</translation>
    </message>
    <message>
        <source>there is no path in it</source>
        <translation>darin ist kein Fahrweg</translation>
    </message>
    <message>
        <source>there is no project format %1</source>
        <translation>es gibt kein Projektformat %1</translation>
    </message>
    <message>
        <source>there is no recorded track in it</source>
        <translation>es ist keine aufgezeichnete Fahrt darin</translation>
    </message>
    <message>
        <source>there is no setting &apos;%1&apos;</source>
        <translation>es gibt keine Einstellung „%1“</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>diese Datei gibt es nicht</translation>
    </message>
    <message>
        <source>there is no swath %1</source>
        <translation>es gibt keine Spur %1</translation>
    </message>
    <message>
        <source>there is no terminal &apos;%1&apos;</source>
        <translation>es gibt kein Terminal „%1“</translation>
    </message>
    <message>
        <source>there is no track in this GPX file</source>
        <translation>in dieser GPX-Datei ist keine Fahrt</translation>
    </message>
    <message>
        <source>this XML file is cut off</source>
        <translation>diese XML-Datei ist abgeschnitten</translation>
    </message>
    <message>
        <source>this XML is no task data</source>
        <translation>dieses XML enthält keine Auftragsdaten</translation>
    </message>
    <message>
        <source>this folder holds no TASKDATA.XML, no field of AgOpenGPS and no AgGPS boundary</source>
        <translation>dieser Ordner enthält kein TASKDATA.XML, keinen Schlag von AgOpenGPS und keine AgGPS-Feldgrenze</translation>
    </message>
    <message>
        <source>this format holds the path of a plan, and there is only a field</source>
        <translation>dieses Format enthält den Fahrweg eines Plans, und es gibt nur einen Schlag</translation>
    </message>
    <message>
        <source>this is a bag of ROS 1</source>
        <translation>das ist ein Bag von ROS 1</translation>
    </message>
    <message>
        <source>this is a folder</source>
        <translation>das ist ein Ordner</translation>
    </message>
    <message>
        <source>this is no MCAP file of version 0</source>
        <translation>das ist keine MCAP-Datei der Version 0</translation>
    </message>
    <message>
        <source>this is no boundary file that can be read</source>
        <translation>das ist keine lesbare Datei mit Feldgrenzen</translation>
    </message>
    <message>
        <source>this is no header of a time log</source>
        <translation>das ist keine Kopfdatei eines Fahrtprotokolls</translation>
    </message>
    <message>
        <source>this is no ordinary file</source>
        <translation>das ist keine gewöhnliche Datei</translation>
    </message>
    <message>
        <source>this is no track that can be read</source>
        <translation>das ist keine lesbare Aufzeichnung</translation>
    </message>
    <message>
        <source>this is no zip of fields or recordings</source>
        <translation>das ist kein Zip mit Schlägen oder Aufzeichnungen</translation>
    </message>
    <message>
        <source>this is not JSON from here on</source>
        <translation>ab hier ist das kein JSON</translation>
    </message>
    <message>
        <source>this is not XML from here on</source>
        <translation>ab hier ist das kein XML</translation>
    </message>
    <message>
        <source>this is not a project of Furrow</source>
        <translation>das ist kein Projekt von Furrow</translation>
    </message>
    <message>
        <source>this is not well-known text from here on</source>
        <translation>ab hier ist das kein Well-known text</translation>
    </message>
    <message>
        <source>this place</source>
        <translation>diese Stelle</translation>
    </message>
    <message>
        <source>this polygon cannot be read</source>
        <translation>dieses Polygon kann nicht gelesen werden</translation>
    </message>
    <message>
        <source>this project file is damaged: %1</source>
        <translation>diese Projektdatei ist beschädigt: %1</translation>
    </message>
    <message>
        <source>this project is open in another window of Furrow</source>
        <translation>dieses Projekt ist in einem anderen Fenster von Furrow offen</translation>
    </message>
    <message>
        <source>this project was saved by a newer Furrow (format %1, this one knows %2)</source>
        <translation>dieses Projekt wurde von einem neueren Furrow gespeichert (Format %1, dieses kennt %2)</translation>
    </message>
    <message>
        <source>topic %1 was left out for %2</source>
        <translation>Topic %1 wurde zugunsten von %2 weggelassen</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true oder false</translation>
    </message>
    <message>
        <source>try another stick</source>
        <translation>einen anderen Stick versuchen</translation>
    </message>
    <message>
        <source>turn it into a rosbag2 with rosbags-convert</source>
        <translation>es mit rosbags-convert in ein rosbag2 umwandeln</translation>
    </message>
    <message>
        <source>two points</source>
        <translation>zwei Punkte</translation>
    </message>
    <message>
        <source>use another terminal&apos;s format, and report this</source>
        <translation>das Format eines anderen Terminals verwenden und dies melden</translation>
    </message>
    <message>
        <source>use one of: %1</source>
        <translation>eines davon verwenden: %1</translation>
    </message>
    <message>
        <source>use one of: %1; or give a machine file (.json)</source>
        <translation>eine davon verwenden: %1; oder eine Maschinendatei (.json) angeben</translation>
    </message>
    <message>
        <source>use one or more of: %1</source>
        <translation>eines oder mehrere davon verwenden: %1</translation>
    </message>
    <message>
        <source>use the numbers from 1 to %1</source>
        <translation>die Nummern von 1 bis %1 verwenden</translation>
    </message>
    <message>
        <source>was it pulled out? Plug it in again and write once more</source>
        <translation>wurde er abgezogen? Wieder einstecken und noch einmal schreiben</translation>
    </message>
    <message>
        <source>what is on the stick is not the plan: %1</source>
        <translation>was auf dem Stick ist, ist nicht der Plan: %1</translation>
    </message>
    <message>
        <source>whole numbers divided by commas</source>
        <translation>ganze Zahlen, durch Kommas getrennt</translation>
    </message>
    <message>
        <source>worked pixels need a value other than 0</source>
        <translation>bearbeitete Pixel brauchen einen anderen Wert als 0</translation>
    </message>
    <message>
        <source>write POLYGON((lon lat, lon lat, ...))</source>
        <translation>POLYGON((lon lat, lon lat, ...)) schreiben</translation>
    </message>
    <message>
        <source>write POLYGON((lon lat, lon lat, ...)), one polygon a line</source>
        <translation>POLYGON((lon lat, lon lat, ...)) schreiben, ein Polygon je Zeile</translation>
    </message>
    <message>
        <source>write it like LINESTRING (4.1 52.0, 4.2 52.0)</source>
        <translation>schreiben wie LINESTRING (4.1 52.0, 4.2 52.0)</translation>
    </message>
    <message>
        <source>write the plan again with furrow-cli plan</source>
        <translation>den Plan mit furrow-cli plan neu schreiben</translation>
    </message>
    <message>
        <source>write {&quot;name&quot;: ..., &quot;operating_width_m&quot;: ...}</source>
        <translation>schreiben: {&quot;name&quot;: ..., &quot;operating_width_m&quot;: ...}</translation>
    </message>
    <message>
        <source>a part of it cannot be read</source>
        <translation>ein Teil davon lässt sich nicht lesen</translation>
    </message>
    <message>
        <source>a part of it is damaged: %1</source>
        <translation>ein Teil davon ist beschädigt: %1</translation>
    </message>
    <message>
        <source>a tile is damaged</source>
        <translation>eine Kachel ist beschädigt</translation>
    </message>
    <message>
        <source>choose a file or a folder of tiles</source>
        <translation>eine Datei oder einen Ordner mit Kacheln wählen</translation>
    </message>
    <message>
        <source>choose the folder that holds the folders of the zooms, 0 to 24</source>
        <translation>den Ordner wählen, in dem die Ordner der Zoomstufen liegen, 0 bis 24</translation>
    </message>
    <message>
        <source>copy or export the file again</source>
        <translation>die Datei neu kopieren oder exportieren</translation>
    </message>
    <message>
        <source>give a GeoTIFF, MBTiles, or a folder of tiles</source>
        <translation>ein GeoTIFF, MBTiles oder einen Ordner mit Kacheln angeben</translation>
    </message>
    <message>
        <source>give a GeoTIFF, or export it again with its coordinate system</source>
        <translation>ein GeoTIFF angeben oder mit seinem Koordinatensystem neu exportieren</translation>
    </message>
    <message>
        <source>it is damaged, or not a picture that Furrow can show</source>
        <translation>es ist beschädigt oder kein Bild, das Furrow zeigen kann</translation>
    </message>
    <message>
        <source>it is no file</source>
        <translation>es ist keine Datei</translation>
    </message>
    <message>
        <source>it is too large to be shown without overviews</source>
        <translation>es ist zu groß, um ohne Übersichtsbilder gezeigt zu werden</translation>
    </message>
    <message>
        <source>its tiles are in degrees, not in web Mercator</source>
        <translation>seine Kacheln sind in Grad, nicht in Web-Mercator</translation>
    </message>
    <message>
        <source>make the tiles again</source>
        <translation>die Kacheln neu erzeugen</translation>
    </message>
    <message>
        <source>make them again with the profile mercator, or give the raster itself</source>
        <translation>mit dem Profil mercator neu erzeugen oder das Raster selbst angeben</translation>
    </message>
    <message>
        <source>open it again</source>
        <translation>neu öffnen</translation>
    </message>
    <message>
        <source>put it back, or choose another one</source>
        <translation>wieder dorthin legen oder etwas anderes wählen</translation>
    </message>
    <message>
        <source>put it back, or remove the layer</source>
        <translation>wieder dorthin legen oder die Ebene entfernen</translation>
    </message>
    <message>
        <source>save it in tiles and with overviews (gdal_translate -of COG)</source>
        <translation>in Kacheln und mit Übersichtsbildern speichern (gdal_translate -of COG)</translation>
    </message>
    <message>
        <source>the file cannot be read any more</source>
        <translation>die Datei lässt sich nicht mehr lesen</translation>
    </message>
    <message>
        <source>the file is not there any more</source>
        <translation>die Datei ist nicht mehr da</translation>
    </message>
    <message>
        <source>the file was changed while it was open</source>
        <translation>die Datei wurde geändert, während sie geöffnet war</translation>
    </message>
    <message>
        <source>the folder is not there any more</source>
        <translation>der Ordner ist nicht mehr da</translation>
    </message>
    <message>
        <source>there are no tiles in this folder</source>
        <translation>in diesem Ordner sind keine Kacheln</translation>
    </message>
    <message>
        <source>there is no picture in it</source>
        <translation>es ist kein Bild darin</translation>
    </message>
    <message>
        <source>there is no such file or folder</source>
        <translation>diese Datei oder diesen Ordner gibt es nicht</translation>
    </message>
    <message>
        <source>Receivers may refuse %1: %2.</source>
        <translation>Manche Terminals könnten %1 ablehnen: %2.</translation>
    </message>
    <message>
        <source>some systems do not allow a file of this name</source>
        <translation>manche Systeme erlauben keine Datei dieses Namens</translation>
    </message>
    <message>
        <source>another file differs from it in capitals only</source>
        <translation>eine andere Datei unterscheidet sich davon nur durch Groß- und Kleinschreibung</translation>
    </message>
    <message>
        <source>%1 is far from the field</source>
        <translation>%1 liegt weit vom Schlag entfernt</translation>
    </message>
    <message>
        <source>a ring of &apos;%1&apos; has fewer than three corners</source>
        <translation>ein Ring von „%1“ hat weniger als drei Ecken</translation>
    </message>
    <message>
        <source>a ring of &apos;%1&apos; does not end where it begins</source>
        <translation>ein Ring von „%1“ endet nicht, wo er beginnt</translation>
    </message>
    <message>
        <source>a ring of &apos;%1&apos; ends with its first point again</source>
        <translation>ein Ring von „%1“ endet noch einmal mit seinem ersten Punkt</translation>
    </message>
    <message>
        <source>&apos;%1&apos; crosses itself, or a hole lies outside of it</source>
        <translation>„%1“ überkreuzt sich, oder eine Aussparung liegt außerhalb</translation>
    </message>
    <message>
        <source>a ring of &apos;%1&apos; runs the wrong way round</source>
        <translation>ein Ring von „%1“ läuft falsch herum</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is said to have %2, and has %3</source>
        <translation>„%1“ soll %2 haben und hat %3</translation>
    </message>
    <message>
        <source>the name &apos;%1&apos; is longer than %2 characters</source>
        <translation>der Name „%1“ ist länger als %2 Zeichen</translation>
    </message>
    <message>
        <source>the name &apos;%1&apos; is there twice</source>
        <translation>der Name „%1“ kommt zweimal vor</translation>
    </message>
    <message>
        <source>the name &apos;%1&apos; has letters beyond A to Z</source>
        <translation>der Name „%1“ hat andere Buchstaben als A bis Z</translation>
    </message>
    <message>
        <source>the name &apos;%1&apos; has characters that are no letters</source>
        <translation>der Name „%1“ hat Zeichen, die keine Buchstaben sind</translation>
    </message>
    <message>
        <source>the line &apos;%1&apos; has fewer than two points</source>
        <translation>die Linie „%1“ hat weniger als zwei Punkte</translation>
    </message>
    <message>
        <source>A and B of &apos;%1&apos; are the same place</source>
        <translation>A und B von „%1“ sind dieselbe Stelle</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is said to be %2 wide</source>
        <translation>„%1“ soll %2 breit sein</translation>
    </message>
    <message>
        <source>%1 comes where %2 should</source>
        <translation>%1 steht, wo %2 stehen sollte</translation>
    </message>
    <message>
        <source>%1 boundaries are in it, not %2</source>
        <translation>%1 Feldgrenzen sind darin, nicht %2</translation>
    </message>
    <message>
        <source>%1 holes are in it, not %2</source>
        <translation>%1 Aussparungen sind darin, nicht %2</translation>
    </message>
    <message>
        <source>%1 guidance lines are in it, not %2</source>
        <translation>%1 Leitlinien sind darin, nicht %2</translation>
    </message>
    <message>
        <source>%1 swaths are in it, not %2</source>
        <translation>%1 Spuren sind darin, nicht %2</translation>
    </message>
    <message>
        <source>%1 fields are in it, not %2</source>
        <translation>%1 Schläge sind darin, nicht %2</translation>
    </message>
    <message>
        <source>the path is not in it</source>
        <translation>der Fahrweg ist nicht darin</translation>
    </message>
    <message>
        <source>place %1 of the path is not where the plan goes next</source>
        <translation>Stelle %1 des Fahrwegs liegt nicht dort, wo der Plan weitergeht</translation>
    </message>
    <message>
        <source>the path does not begin and end as the plan does</source>
        <translation>der Fahrweg beginnt und endet nicht wie der Plan</translation>
    </message>
    <message>
        <source>the path is %1 long, not %2</source>
        <translation>der Fahrweg ist %1 lang, nicht %2</translation>
    </message>
    <message>
        <source>the time of place %1 of the path is before that of the place before</source>
        <translation>die Zeit der Stelle %1 des Fahrwegs liegt vor der Zeit der Stelle davor</translation>
    </message>
    <message>
        <source>the times of the path stand still</source>
        <translation>die Zeiten des Fahrwegs stehen still</translation>
    </message>
    <message>
        <source>the heading at place %1 of the path does not point along it</source>
        <translation>die Richtung an Stelle %1 des Fahrwegs zeigt nicht an ihm entlang</translation>
    </message>
    <message>
        <source>the speed at place %1 of the path is negative</source>
        <translation>die Geschwindigkeit an Stelle %1 des Fahrwegs ist negativ</translation>
    </message>
    <message>
        <source>its largest speed is %1, not %2</source>
        <translation>ihre größte Geschwindigkeit ist %1, nicht %2</translation>
    </message>
    <message>
        <source>line %1 is not as this format has it</source>
        <translation>Zeile %1 entspricht nicht diesem Format</translation>
    </message>
    <message>
        <source>this is no %1</source>
        <translation>das ist kein %1</translation>
    </message>
    <message>
        <source>its content cannot be read</source>
        <translation>ihr Inhalt ist nicht lesbar</translation>
    </message>
    <message>
        <source>%1 is missing</source>
        <translation>%1 fehlt</translation>
    </message>
    <message>
        <source>%1 entries are announced, and %2 are there</source>
        <translation>%1 Einträge sind angekündigt und %2 sind da</translation>
    </message>
    <message>
        <source>the id %1 is there twice</source>
        <translation>die Kennung %1 kommt zweimal vor</translation>
    </message>
    <message>
        <source>%1 is referred to and not there</source>
        <translation>auf %1 wird verwiesen, aber es fehlt</translation>
    </message>
    <message>
        <source>%1 is not known before version 4</source>
        <translation>%1 ist vor Version 4 nicht bekannt</translation>
    </message>
    <message>
        <source>&apos;%1&apos; holds a line of kind %2</source>
        <translation>„%1“ enthält eine Linie der Art %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is of kind %2 and its points are of kinds %3</source>
        <translation>„%1“ ist von der Art %2, und die Punkte sind von den Arten %3</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has %2 lines</source>
        <translation>„%1“ hat %2 Linien</translation>
    </message>
    <message>
        <source>the headings of a ring do not point along it</source>
        <translation>die Richtungen eines Rings zeigen nicht an ihm entlang</translation>
    </message>
    <message>
        <source>its shapes have heights or measures, which displays do not read</source>
        <translation>ihre Formen haben Höhen oder Messwerte, die Displays nicht lesen</translation>
    </message>
    <message>
        <source>this is the recording of a drive (%1), and no boundary</source>
        <translation>das ist die Aufzeichnung einer Fahrt (%1) und keine Feldgrenze</translation>
    </message>
    <message>
        <source>give the field&apos;s boundary; furrow-cli compare lays a recording over a plan</source>
        <translation>die Feldgrenze angeben; furrow-cli compare legt eine Aufzeichnung über einen Plan</translation>
    </message>
    <message>
        <source>Raster mask</source>
        <translation>Rastermaske</translation>
    </message>
    <message>
        <source>What is worked and what is not, as a field.</source>
        <translation>Was bearbeitet wird und was nicht, als Schlag.</translation>
    </message>
    <message>
        <source>NMEA or gpsd log</source>
        <translation>NMEA- oder gpsd-Protokoll</translation>
    </message>
    <message>
        <source>What a machine drove.</source>
        <translation>Was eine Maschine gefahren ist.</translation>
    </message>
    <message>
        <source>split line %1 ends %2 short of the headland and cuts nothing off there (decomposition.split); draw it right through</source>
        <translation>Teilungslinie %1 endet %2 vor dem Vorgewende und trennt dort nichts ab (decomposition.split); ganz durchziehen</translation>
    </message>
    <message>
        <source>split line %1 does not lie inside the headland and cuts nothing (decomposition.split)</source>
        <translation>Teilungslinie %1 liegt außerhalb der Innenfläche und teilt nichts (decomposition.split)</translation>
    </message>
    <message numerus="yes">
        <source>%n swaths shorter than %1 are left out</source>
        <translation>
            <numerusform>%n Spur, die kürzer als %1 ist, entfällt</numerusform>
            <numerusform>%n Spuren, die kürzer als %1 sind, entfallen</numerusform>
        </translation>
    </message>
    <message>
        <source>along the longest edge</source>
        <translation>entlang der längsten Kante</translation>
    </message>
    <message>
        <source>along an edge</source>
        <translation>entlang einer Kante</translation>
    </message>
    <message>
        <source>swaths run %1</source>
        <translation>die Spuren verlaufen %1</translation>
    </message>
    <message>
        <source>swaths run %1; about %2 slower than with the best heading</source>
        <translation>die Spuren verlaufen %1; etwa %2 langsamer als mit der besten Richtung</translation>
    </message>
    <message>
        <source>swaths run %1; as quick as with the best heading</source>
        <translation>die Spuren verlaufen %1; so schnell wie mit der besten Richtung</translation>
    </message>
    <message>
        <source>swaths run %1; %2 more than with the best heading</source>
        <translation>die Spuren verlaufen %1; %2 mehr als mit der besten Richtung</translation>
    </message>
    <message>
        <source>swaths run %1; as short as with the best heading</source>
        <translation>die Spuren verlaufen %1; so kurz wie mit der besten Richtung</translation>
    </message>
    <message>
        <source>Shortest swath</source>
        <translation>Kürzeste Spur</translation>
    </message>
    <message>
        <source>Swaths that are shorter are left out; auto is the implement&apos;s length.</source>
        <translation>Kürzere Spuren entfallen; Auto ist die Länge des Geräts.</translation>
    </message>
    <message>
        <source>Prefer edges within (%)</source>
        <translation>Kanten bevorzugen bis (%)</translation>
    </message>
    <message>
        <source>Swaths run along the field&apos;s longest edge, or another long one, where that takes no more than this above the best heading; 0 takes the best whatever its direction.</source>
        <translation>Die Spuren verlaufen entlang der längsten oder einer anderen langen Kante des Schlags, wo das höchstens so viel mehr kostet als die beste Richtung; 0 nimmt die beste, wie sie auch liegt.</translation>
    </message>
    <message>
        <source>%1 are out of this machine&apos;s reach; the largest piece, %2, lies here.</source>
        <translation>%1 kann diese Maschine nicht erreichen; das größte Stück, %2, liegt hier.</translation>
    </message>
    <message>
        <source>The implement stands over the edge of the field or an obstacle, by up to %1, as the overhang allows.</source>
        <translation>Das Gerät ragt bis zu %1 über den Rand des Schlags oder über ein Hindernis, wie der Überstand es erlaubt.</translation>
    </message>
    <message>
        <source>%1 within %2 of the centre: tighter than this machine can follow, left out</source>
        <translation>%1 näher als %2 an der Mitte: enger, als diese Maschine fahren kann, weggelassen</translation>
    </message>
    <message numerus="yes">
        <source>%n circles</source>
        <translation>
            <numerusform>%n Kreis</numerusform>
            <numerusform>%n Kreise</numerusform>
        </translation>
    </message>
    <message>
        <source>A headland of %1 holds %2; it is %3 wide, and the rest belongs to the swaths</source>
        <translation>Ein Vorgewende von %1 fasst %2; es ist %3 breit, der Rest gehört zu den Spuren</translation>
    </message>
    <message>
        <source>Plan the sides of the obstacle apart.</source>
        <translation>Die Seiten des Hindernisses getrennt planen.</translation>
    </message>
    <message>
        <source>Set &quot;%1&quot; to &quot;%2&quot;: with that this is gone.</source>
        <translation>„%1“ auf „%2“ setzen: Damit ist das behoben.</translation>
    </message>
    <message>
        <source>Swaths along the longest edge</source>
        <translation>Spuren entlang der längsten Kante</translation>
    </message>
    <message>
        <source>Swaths at a bearing of %1</source>
        <translation>Spuren in Richtung %1</translation>
    </message>
    <message>
        <source>Take a machine that can.</source>
        <translation>Eine Maschine nehmen, die das kann.</translation>
    </message>
    <message>
        <source>The field is too narrow for this machine to turn in: take a smaller machine.</source>
        <translation>Der Schlag ist zum Wenden mit dieser Maschine zu schmal: eine kleinere Maschine nehmen.</translation>
    </message>
    <message>
        <source>The quickest</source>
        <translation>Die schnellste</translation>
    </message>
    <message>
        <source>give one of the two, or a width that holds just these passes</source>
        <translation>eines von beiden angeben oder eine Breite, in die genau diese Spuren passen</translation>
    </message>
    <message>
        <source>headland.width_m and headland.passes do not agree</source>
        <translation>headland.width_m und headland.passes passen nicht zusammen</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>on</source>
        <translation>ein</translation>
    </message>
    <message>
        <source>&quot;%1&quot;: &quot;%2&quot; is planned instead of &quot;%3&quot;: %4</source>
        <translation>„%1“: Geplant ist „%2“ statt „%3“: %4</translation>
    </message>
    <message>
        <source>%1 are planned instead of the heading with the best estimate: %2</source>
        <translation>%1 sind statt der Richtung mit der besten Schätzung geplant: %2</translation>
    </message>
    <message>
        <source>it has fewer problems</source>
        <translation>so gibt es weniger Probleme</translation>
    </message>
    <message>
        <source>it is %1 quicker</source>
        <translation>das ist %1 schneller</translation>
    </message>
    <message>
        <source>the margin and the obstacles that may be driven on leave nothing to work</source>
        <translation>der Sicherheitsabstand und die überfahrbaren Hindernisse lassen nichts zum Bearbeiten übrig</translation>
    </message>
    <message>
        <source>make them smaller, or delete some of them</source>
        <translation>sie verkleinern oder einige löschen</translation>
    </message>
    <message>
        <source>Without a headland (%1) there is no room to turn.</source>
        <translation>Ohne Vorgewende (%1) ist kein Platz zum Wenden.</translation>
    </message>
    <message>
        <source>A turn of this machine needs %1 of headland; it is %2 (%3).</source>
        <translation>Eine Wendung dieser Maschine braucht %1 Vorgewende; es sind %2 (%3).</translation>
    </message>
    <message>
        <source>The field is too narrow for this machine to turn in: take a smaller machine, or let the swaths run along the field (%1).</source>
        <translation>Der Schlag ist zum Wenden mit dieser Maschine zu schmal: eine kleinere Maschine nehmen, oder die Spuren längs des Schlags legen (%1).</translation>
    </message>
    <message>
        <source>The field is too narrow for this machine to turn in: take a smaller machine or a smaller margin (%1).</source>
        <translation>Der Schlag ist zum Wenden mit dieser Maschine zu schmal: eine kleinere Maschine oder einen kleineren Sicherheitsabstand nehmen (%1).</translation>
    </message>
    <message>
        <source>No passes are driven in the headland (%1).</source>
        <translation>Auf dem Vorgewende werden keine Spuren gefahren (%1).</translation>
    </message>
    <message>
        <source>The chosen swaths (%1) do not reach it.</source>
        <translation>Die gewählten Spuren (%1) reichen nicht bis dorthin.</translation>
    </message>
    <message>
        <source>Land that is left is not finished if the machine may leave the field (%1).</source>
        <translation>Wo die Maschine den Schlag verlassen darf (%1), werden Reste nicht nachgearbeitet.</translation>
    </message>
    <message>
        <source>Land that is left is not finished, because that is switched off (%1).</source>
        <translation>Reste werden nicht nachgearbeitet, weil das ausgeschaltet ist (%1).</translation>
    </message>
    <message>
        <source>choose a smaller machine or a smaller margin (%1)</source>
        <translation>eine kleinere Maschine oder einen kleineren Sicherheitsabstand wählen (%1)</translation>
    </message>
    <message>
        <source>no row is left inside the headland</source>
        <translation>in der Innenfläche bleibt keine Reihe übrig</translation>
    </message>
    <message>
        <source>skip fewer rows</source>
        <translation>weniger Reihen auslassen</translation>
    </message>
    <message>
        <source>no row lies inside the headland</source>
        <translation>in der Innenfläche liegt keine Reihe</translation>
    </message>
    <message>
        <source>check that the rows belong to this field, or choose a narrower headland</source>
        <translation>prüfen, ob die Reihen zu diesem Schlag gehören, oder ein schmaleres Vorgewende wählen</translation>
    </message>
    <message>
        <source>Quickest</source>
        <translation>Schnellste</translation>
    </message>
    <message>
        <source>The kind below with which the whole plan takes the least time.</source>
        <translation>Die Art, mit der der ganze Plan am wenigsten Zeit braucht.</translation>
    </message>
    <message>
        <source>A headland of %1 is planned instead of one that is wide enough for turns: %2</source>
        <translation>Vorgewende: %1. Es wird statt eines geplant, das breit genug zum Wenden ist: %2</translation>
    </message>
    <message>
        <source>Drive more slowly there, or plan again.</source>
        <translation>Dort langsamer fahren oder neu planen.</translation>
    </message>
    <message>
        <source>The steering is too slow for the planned speed in %1; %2 is the worst and would need %3.</source>
        <translation>Die Lenkung ist für die geplante Geschwindigkeit zu langsam (%1); am schlimmsten ist es hier: %2. Dort wären %3 nötig.</translation>
    </message>
    <message>
        <source>The implement is folded on the way from %1 to %2.</source>
        <translation>Das Gerät ist auf diesem Weg eingeklappt: %1 → %2.</translation>
    </message>
    <message>
        <source>The machine has to stand for %1 s to fold its implement or to unfold it, and does not in %2.</source>
        <translation>Zum Ein- oder Ausklappen des Geräts muss die Maschine %1 s stehen; sie tut es an %2 nicht.</translation>
    </message>
    <message>
        <source>Time to fold</source>
        <translation>Zeit zum Einklappen</translation>
    </message>
    <message>
        <source>To fold to the transport width, standing; the same again to unfold.</source>
        <translation>Auf Transportbreite einklappen, im Stand; zum Ausklappen noch einmal so lang.</translation>
    </message>
    <message>
        <source>Fuel</source>
        <translation>Kraftstoff</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Saves</source>
        <translation>Spart</translation>
    </message>
    <message>
        <source>The least fuel for turns and ways; the least time if the machine has no fuel figures.</source>
        <translation>Der geringste Kraftstoffverbrauch für Wendungen und Wege; die kürzeste Zeit, wenn die Maschine keine Verbrauchswerte hat.</translation>
    </message>
    <message>
        <source>The least time for turns and ways.</source>
        <translation>Die kürzeste Zeit für Wendungen und Wege.</translation>
    </message>
    <message>
        <source>The shortest turns and ways.</source>
        <translation>Die kürzesten Wendungen und Wege.</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>What the order of the swaths is to save.</source>
        <translation>Was die Reihenfolge der Spuren sparen soll.</translation>
    </message>
    <message>
        <source>Every pattern is tried and improved; the plan tells how near the order is to the best one.</source>
        <translation>Alle Muster werden probiert und verbessert; der Plan sagt, wie nah die Reihenfolge an der besten ist.</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>Festgelegt</translation>
    </message>
    <message>
        <source>Swath numbers that follow each other in this order; a minus drives one the other way. The order of the others is searched.</source>
        <translation>Spurnummern, die in dieser Reihenfolge aufeinander folgen; ein Minus fährt eine in der anderen Richtung. Die Reihenfolge der übrigen wird gesucht.</translation>
    </message>
    <message>
        <source>Ends of swaths</source>
        <translation>Enden der Spuren</translation>
    </message>
    <message>
        <source>Heading of blocks</source>
        <translation>Fahrtrichtung der Teilflächen</translation>
    </message>
    <message>
        <source>Heading: bearing %1</source>
        <translation>Fahrtrichtung: %1</translation>
    </message>
    <message>
        <source>Headland passes</source>
        <translation>Vorgewendespuren</translation>
    </message>
    <message>
        <source>Order of swaths</source>
        <translation>Reihenfolge der Spuren</translation>
    </message>
    <message>
        <source>Small obstacles</source>
        <translation>Kleine Hindernisse</translation>
    </message>
    <message>
        <source>First swath</source>
        <translation>Erste Spur</translation>
    </message>
    <message>
        <source>Last swath</source>
        <translation>Letzte Spur</translation>
    </message>
    <message>
        <source>Most strips that are left between driven swaths for later. With 0 the machine never comes back to a gap, so that a second one can follow; auto sets no limit.</source>
        <translation>So viele Streifen bleiben höchstens zwischen gefahrenen Spuren für später offen. Mit 0 kehrt die Maschine nie zu einer Lücke zurück, sodass eine zweite folgen kann; Auto setzt keine Grenze.</translation>
    </message>
    <message>
        <source>Open strips</source>
        <translation>Offene Streifen</translation>
    </message>
    <message>
        <source>The number of the swath that is driven first; auto takes any.</source>
        <translation>Die Nummer der Spur, die zuerst gefahren wird; Auto nimmt irgendeine.</translation>
    </message>
    <message>
        <source>The number of the swath that is driven last; auto takes any.</source>
        <translation>Die Nummer der Spur, die zuletzt gefahren wird; Auto nimmt irgendeine.</translation>
    </message>
    <message>
        <source>allow more open strips, or lock fewer swaths</source>
        <translation>mehr offene Streifen erlauben oder weniger Spuren festlegen</translation>
    </message>
    <message>
        <source>name another swath for the end</source>
        <translation>eine andere Spur für das Ende nennen</translation>
    </message>
    <message>
        <source>no order was found that keeps to all that is said of the order of swaths</source>
        <translation>es wurde keine Reihenfolge gefunden, die alle Vorgaben für die Reihenfolge der Spuren einhält</translation>
    </message>
    <message>
        <source>swath %1 is driven first</source>
        <translation>Spur %1 wird zuerst gefahren</translation>
    </message>
    <message>
        <source>%1 are driven outside of the field</source>
        <translation>%1 werden außerhalb des Schlags überfahren</translation>
    </message>
    <message>
        <source>%1 costs %2 more than the longest edge (%3)</source>
        <translation>%1 kostet %2 mehr als die längste Kante (%3)</translation>
    </message>
    <message>
        <source>%1 h %2 min</source>
        <translation>%1 h %2 min</translation>
    </message>
    <message>
        <source>%1 is as quick as the longest edge (%2)</source>
        <translation>%1 ist so schnell wie die längste Kante (%2)</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>%1 of a work order is no amount</source>
        <translation>%1 eines Arbeitsauftrags ist keine Menge</translation>
    </message>
    <message>
        <source>%1 of a work order is no text</source>
        <translation>%1 eines Arbeitsauftrags ist kein Text</translation>
    </message>
    <message>
        <source>%1 runs along the longest edge</source>
        <translation>%1 verläuft an der längsten Kante entlang</translation>
    </message>
    <message>
        <source>%1 saves %2 against the longest edge (%3)</source>
        <translation>%1 spart %2 gegenüber der längsten Kante (%3)</translation>
    </message>
    <message>
        <source>%1 × %2, %3 each</source>
        <translation>%1 × %2, je %3</translation>
    </message>
    <message>
        <source>%1: a turn of this machine, with a radius of %2, needs %3.</source>
        <translation>%1: eine Wendung dieser Maschine mit %2 Radius braucht %3.</translation>
    </message>
    <message>
        <source>%1: a turn to the next swath would need %2, so turns are made in other ways.</source>
        <translation>%1: eine Wendung in die nächste Spur bräuchte %2, darum wird anders gewendet.</translation>
    </message>
    <message>
        <source>%1: its work order is not used: %2</source>
        <translation>%1: Der Arbeitsauftrag wird nicht verwendet: %2</translation>
    </message>
    <message>
        <source>%1: the field is too narrow for the %2 that a turn of this machine needs.</source>
        <translation>%1: der Schlag ist zu schmal für die %2, die eine Wendung dieser Maschine braucht.</translation>
    </message>
    <message>
        <source>%1; the machine keeps %2 from its edge at least.</source>
        <translation>%1; die Maschine bleibt mindestens %2 von seinem Rand.</translation>
    </message>
    <message numerus="yes">
        <source>%n blocks</source>
        <translation>
            <numerusform>%n Teilfläche</numerusform>
            <numerusform>%n Teilflächen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n passes of %1</source>
        <translation>
            <numerusform>%n Spur von %1</numerusform>
            <numerusform>%n Spuren von %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n swaths</source>
        <translation>
            <numerusform>%n Spur</numerusform>
            <numerusform>%n Spuren</numerusform>
        </translation>
    </message>
    <message>
        <source>Cut into %1 pieces where swaths are interrupted, joined to %2.</source>
        <translation>In %1 Stücke geteilt, wo Spuren unterbrochen sind, verbunden zu %2.</translation>
    </message>
    <message>
        <source>Cut into %1 pieces where swaths are interrupted; joining them to %2 saves %3 of turns and ways.</source>
        <translation>In %1 Stücke geteilt, wo Spuren unterbrochen sind; verbunden zu %2 spart das %3 an Wendungen und Wegen.</translation>
    </message>
    <message>
        <source>Edges that swaths run along get %1, edges that they end at up to %2: a turn of this machine needs %3.</source>
        <translation>Kanten, an denen Spuren entlanglaufen, bekommen %1, Kanten, an denen sie enden, bis %2: eine Wendung dieser Maschine braucht %3.</translation>
    </message>
    <message>
        <source>Everything keeps %1 from the boundary, as chosen.</source>
        <translation>Alles hält %1 Abstand zur Feldgrenze, wie gewählt.</translation>
    </message>
    <message>
        <source>Everything keeps %1 from the boundary: no more is known of where it runs.</source>
        <translation>Alles hält %1 Abstand zur Feldgrenze: genauer ist nicht bekannt, wo sie verläuft.</translation>
    </message>
    <message numerus="yes">
        <source>No heading has fewer than %n swaths.</source>
        <translation>
            <numerusform>Keine Richtung hat weniger als %n Spur.</numerusform>
            <numerusform>Keine Richtung hat weniger als %n Spuren.</numerusform>
        </translation>
    </message>
    <message>
        <source>No heading that was tried covers more: %1 inside the headland.</source>
        <translation>Keine geprüfte Richtung bearbeitet mehr: %1 der Innenfläche.</translation>
    </message>
    <message numerus="yes">
        <source>No heading that was tried has fewer than %n swaths.</source>
        <translation>
            <numerusform>Keine geprüfte Richtung hat weniger als %n Spur.</numerusform>
            <numerusform>Keine geprüfte Richtung hat weniger als %n Spuren.</numerusform>
        </translation>
    </message>
    <message>
        <source>No heading that was tried has shorter swaths: %1.</source>
        <translation>Keine geprüfte Richtung hat kürzere Spuren: %1.</translation>
    </message>
    <message>
        <source>No heading that was tried works less land twice: %1.</source>
        <translation>Keine geprüfte Richtung bearbeitet weniger Fläche doppelt: %1.</translation>
    </message>
    <message>
        <source>No order of these swaths can save more than %1 of the turns, or %2 of all.</source>
        <translation>Keine Reihenfolge dieser Spuren kann mehr als %1 der Wendungen sparen, oder %2 von allem.</translation>
    </message>
    <message>
        <source>No order of these swaths is better; that is proved.</source>
        <translation>Keine Reihenfolge dieser Spuren ist besser; das ist bewiesen.</translation>
    </message>
    <message>
        <source>Nothing divides the swaths: one block.</source>
        <translation>Nichts teilt die Spuren: eine Teilfläche.</translation>
    </message>
    <message>
        <source>Nothing stands outside of the field</source>
        <translation>Nichts steht außerhalb des Schlags</translation>
    </message>
    <message>
        <source>One pass all round works the whole field.</source>
        <translation>Eine Runde bearbeitet den ganzen Schlag.</translation>
    </message>
    <message numerus="yes">
        <source>Swaths are interrupted by corners or obstacles: %n blocks.</source>
        <translation>
            <numerusform>Ecken oder Hindernisse unterbrechen die Spuren: %n Teilfläche.</numerusform>
            <numerusform>Ecken oder Hindernisse unterbrechen die Spuren: %n Teilflächen.</numerusform>
        </translation>
    </message>
    <message>
        <source>The longest way without work, %1, follows %2.</source>
        <translation>Der längste Weg ohne Arbeit, %1, folgt auf %2.</translation>
    </message>
    <message>
        <source>There is no headland, as chosen. Turns reach %1 beyond the ends of swaths.</source>
        <translation>Ohne Vorgewende, wie gewählt. Wendungen reichen %1 über die Enden der Spuren hinaus.</translation>
    </message>
    <message>
        <source>Turns take %1 less than with the pattern “%2” (%3).</source>
        <translation>Wendungen kosten %1 weniger als mit dem Muster „%2“ (%3).</translation>
    </message>
    <message>
        <source>Turns take %1 more than with the pattern “%2” (%3).</source>
        <translation>Wendungen kosten %1 mehr als mit dem Muster „%2“ (%3).</translation>
    </message>
    <message>
        <source>Turns take about as much as with the pattern “%1”.</source>
        <translation>Wendungen kosten etwa so viel wie mit dem Muster „%1“.</translation>
    </message>
    <message>
        <source>a member that every plan has is missing or of another kind</source>
        <translation>ein Eintrag, den jeder Plan hat, fehlt oder ist von anderer Art</translation>
    </message>
    <message>
        <source>a work order is a JSON object, and this is none</source>
        <translation>ein Arbeitsauftrag ist ein JSON-Objekt, und dies ist keines</translation>
    </message>
    <message>
        <source>bulb turn</source>
        <translation>Omega-Wendung</translation>
    </message>
    <message>
        <source>by this estimate %1 would save %2</source>
        <translation>nach dieser Schätzung würde %1 %2 sparen</translation>
    </message>
    <message>
        <source>fishtail turn</source>
        <translation>Schwalbenschwanz-Wendung</translation>
    </message>
    <message>
        <source>give a number that is not negative, or leave it out</source>
        <translation>eine Zahl angeben, die nicht negativ ist, oder es weglassen</translation>
    </message>
    <message>
        <source>it is draft, issued, in_progress or done</source>
        <translation>er ist draft, issued, in_progress oder done</translation>
    </message>
    <message>
        <source>no heading is much quicker</source>
        <translation>keine Richtung ist viel schneller</translation>
    </message>
    <message>
        <source>no heading is quicker</source>
        <translation>keine Richtung ist schneller</translation>
    </message>
    <message>
        <source>no plan of this project was sent for this review</source>
        <translation>kein Plan dieses Projekts wurde für diese Durchsicht verschickt</translation>
    </message>
    <message>
        <source>open the project that the plan was sent from, or open the file by itself</source>
        <translation>das Projekt öffnen, aus dem der Plan kam, oder die Datei für sich öffnen</translation>
    </message>
    <message>
        <source>put it in quotation marks</source>
        <translation>in Anführungszeichen setzen</translation>
    </message>
    <message>
        <source>see the README for the members of a work order</source>
        <translation>die README nennt die Angaben eines Arbeitsauftrags</translation>
    </message>
    <message>
        <source>there is no such status of a work order</source>
        <translation>diesen Status eines Arbeitsauftrags gibt es nicht</translation>
    </message>
    <message>
        <source>there is no way to drive</source>
        <translation>es gibt keinen Fahrweg</translation>
    </message>
    <message>
        <source>turn on the spot</source>
        <translation>Wendung auf der Stelle</translation>
    </message>
    <message>
        <source>turn with reversing</source>
        <translation>Wendung mit Rückwärtsfahrt</translation>
    </message>
    <message>
        <source>way straight on</source>
        <translation>Weg geradeaus</translation>
    </message>
    <message>
        <source>%1 are driven over the field with the implement up; longest: %2.</source>
        <translation>%1 werden mit ausgehobenem Gerät über den Schlag gefahren; am längsten: %2.</translation>
    </message>
    <message>
        <source>%1 for each swath gives %2 swaths, and no plan may have more than %3</source>
        <translation>%1 je Spur ergeben %2 Spuren, und kein Plan darf mehr als %3 haben</translation>
    </message>
    <message>
        <source>%1 is beyond what machines have</source>
        <translation>%1 geht über alles hinaus, was Maschinen haben</translation>
    </message>
    <message>
        <source>&apos;%1&apos; in it is a view</source>
        <translation>„%1“ darin ist eine Sicht (View)</translation>
    </message>
    <message>
        <source>a text with fields may take %1 MiB, and this one takes more</source>
        <translation>ein Text mit Schlägen darf %1 MiB haben, und dieser hat mehr</translation>
    </message>
    <message>
        <source>a value in it is not of the kind that belongs there</source>
        <translation>ein Wert darin ist nicht von der Art, die dorthin gehört</translation>
    </message>
    <message>
        <source>correct one of them, or give min_turning_radius_m</source>
        <translation>eins davon berichtigen oder min_turning_radius_m angeben</translation>
    </message>
    <message>
        <source>cut it into parts, or export it as a GeoPackage</source>
        <translation>in Teile zerlegen oder als GeoPackage exportieren</translation>
    </message>
    <message>
        <source>did you mean %1?</source>
        <translation>meinten Sie %1?</translation>
    </message>
    <message>
        <source>export it as a table, or remove it</source>
        <translation>als Tabelle exportieren oder entfernen</translation>
    </message>
    <message>
        <source>it would grow more than three hundredfold when it is unpacked</source>
        <translation>beim Entpacken würde es mehr als das Dreihundertfache</translation>
    </message>
    <message>
        <source>it would take more than 2 GiB when it is unpacked</source>
        <translation>entpackt hätte es mehr als 2 GiB</translation>
    </message>
    <message>
        <source>lists and objects lie too deep in one another here</source>
        <translation>Listen und Objekte sind hier zu tief ineinander geschachtelt</translation>
    </message>
    <message>
        <source>remove what does not belong there</source>
        <translation>entfernen, was nicht dorthin gehört</translation>
    </message>
    <message>
        <source>the file is far too large for what it should hold</source>
        <translation>die Datei ist viel zu groß für das, was darin stehen soll</translation>
    </message>
    <message>
        <source>unpack it and give one of its files</source>
        <translation>entpacken und eine der Dateien angeben</translation>
    </message>
    <message>
        <source>with this wheelbase, %1 give a turning radius of %2</source>
        <translation>bei diesem Radstand ergeben %1 einen Wenderadius von %2</translation>
    </message>
    <message>
        <source>%1 is no number (%2), and nothing is written</source>
        <translation>%1 ist keine Zahl (%2), und nichts wird geschrieben</translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: %2 (%3); the plan is made with %4 until then</source>
        <translation>%1: %2 (%3); bis dahin wird mit %4 geplant</translation>
    </message>
    <message>
        <source>a place</source>
        <translation>eine Stelle</translation>
    </message>
    <message>
        <source>a place of a guidance line</source>
        <translation>eine Stelle einer Leitlinie</translation>
    </message>
    <message>
        <source>a place of an obstacle</source>
        <translation>eine Stelle eines Hindernisses</translation>
    </message>
    <message>
        <source>a place of swath %1</source>
        <translation>eine Stelle von Spur %1</translation>
    </message>
    <message>
        <source>a place of the boundary</source>
        <translation>eine Stelle der Feldgrenze</translation>
    </message>
    <message>
        <source>a place of the mainland</source>
        <translation>eine Stelle der Innenfläche</translation>
    </message>
    <message>
        <source>give one beside it, in WGS84, longitude first</source>
        <translation>eine daneben angeben, in WGS84, Längengrad zuerst</translation>
    </message>
    <message>
        <source>plan parts of the field by themselves, choose another heading, or take small obstacles out of the boundary</source>
        <translation>Teile des Schlags für sich planen, eine andere Richtung wählen oder kleine Hindernisse aus der Grenze nehmen</translation>
    </message>
    <message>
        <source>the area of the field</source>
        <translation>die Fläche des Schlags</translation>
    </message>
    <message>
        <source>the bearing of a guidance line</source>
        <translation>die Richtung einer Leitlinie</translation>
    </message>
    <message>
        <source>the buffer of an obstacle</source>
        <translation>der Abstand um ein Hindernis</translation>
    </message>
    <message>
        <source>the coverage of the swaths</source>
        <translation>der Anteil, den die Spuren bearbeiten</translation>
    </message>
    <message>
        <source>the curvature</source>
        <translation>die Krümmung</translation>
    </message>
    <message>
        <source>the curve is %1 km away from the field</source>
        <translation>die Kurve ist %1 km vom Schlag entfernt</translation>
    </message>
    <message>
        <source>the heading</source>
        <translation>die Richtung</translation>
    </message>
    <message>
        <source>the outline cuts the tracks into %1 swaths, and no plan may have more than %2</source>
        <translation>die Grenze zerschneidet die Spuren in %1 Teile, und kein Plan darf mehr als %2 Spuren haben</translation>
    </message>
    <message>
        <source>the overhang of an obstacle</source>
        <translation>der Überhang eines Hindernisses</translation>
    </message>
    <message>
        <source>the overlap of the swaths</source>
        <translation>die Überlappung der Spuren</translation>
    </message>
    <message>
        <source>the place of a finding</source>
        <translation>die Stelle eines Hinweises</translation>
    </message>
    <message>
        <source>the place of a gate</source>
        <translation>die Stelle einer Zufahrt</translation>
    </message>
    <message>
        <source>the radius of a guidance line</source>
        <translation>der Radius einer Leitlinie</translation>
    </message>
    <message>
        <source>the share of the mainland</source>
        <translation>der Anteil der Innenfläche</translation>
    </message>
    <message>
        <source>the speed</source>
        <translation>die Geschwindigkeit</translation>
    </message>
    <message>
        <source>the time</source>
        <translation>die Zeit</translation>
    </message>
    <message>
        <source>the way driven</source>
        <translation>der gefahrene Weg</translation>
    </message>
    <message>
        <source>the width of a gate</source>
        <translation>die Breite einer Zufahrt</translation>
    </message>
    <message>
        <source>the width of a guidance line</source>
        <translation>die Breite einer Leitlinie</translation>
    </message>
    <message>
        <source>the width of the headland</source>
        <translation>die Breite des Vorgewendes</translation>
    </message>
    <message>
        <source>this is a mistake of Furrow, please report it with the field, the machine and the settings</source>
        <translation>das ist ein Fehler von Furrow; bitte mit Schlag, Maschine und Einstellungen melden</translation>
    </message>
    <message>
        <source>%1 %2 is no place in WGS84</source>
        <translation>%1 %2 ist keine Stelle in WGS84</translation>
    </message>
    <message>
        <source>%1 gathers %2; the bunker holds %3.</source>
        <translation>%1 bringt %2; der Bunker fasst %3.</translation>
    </message>
    <message>
        <source>%1 of standing</source>
        <translation>%1 Standzeit</translation>
    </message>
    <message>
        <source>%1 takes %2; the tank holds %3.</source>
        <translation>%1 braucht %2; der Tank fasst %3.</translation>
    </message>
    <message numerus="yes">
        <source>%n passes are too long for it.</source>
        <translation>
            <numerusform>%n Durchgang ist zu lang dafür.</numerusform>
            <numerusform>%n Durchgänge sind zu lang dafür.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n refills, with %1 of way to them and back and %2.</source>
        <translation>
            <numerusform>Eine Befüllung, mit %1 Weg hin und zurück und %2.</numerusform>
            <numerusform>%n Befüllungen, mit %1 Weg hin und zurück und %2.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n unloadings, with %1 of way to them and back and %2.</source>
        <translation>
            <numerusform>Eine Entladung, mit %1 Weg hin und zurück und %2.</numerusform>
            <numerusform>%n Entladungen, mit %1 Weg hin und zurück und %2.</numerusform>
        </translation>
    </message>
    <message>
        <source>Choose another refill point.</source>
        <translation>Wählen Sie eine andere Füllstelle.</translation>
    </message>
    <message>
        <source>Give more refill points, or ones that are nearer.</source>
        <translation>Geben Sie mehr Füllstellen an, oder nähere.</translation>
    </message>
    <message>
        <source>Let ways cross the mainland (route.traversal), so that swaths may be interrupted, or lay the swaths the short way.</source>
        <translation>Lassen Sie Wege über die Innenfläche zu (route.traversal), damit Spuren unterbrochen werden dürfen, oder legen Sie die Spuren in der kurzen Richtung.</translation>
    </message>
    <message>
        <source>No trip to a refill point is needed: %1 of the %2 that the bunker holds are gathered.</source>
        <translation>Keine Fahrt zu einer Entladestelle ist nötig: %1 von den %2, die der Bunker fasst, kommen zusammen.</translation>
    </message>
    <message>
        <source>No trip to a refill point is needed: %1 of the %2 that the tank holds are used.</source>
        <translation>Keine Fahrt zu einer Füllstelle ist nötig: %1 von den %2, die der Tank fasst, werden gebraucht.</translation>
    </message>
    <message>
        <source>No way to a refill point leads from the work before %1.</source>
        <translation>Von der Arbeit vor %1 führt kein Weg zu einer Füllstelle.</translation>
    </message>
    <message>
        <source>POINT (%1 %2) lies outside of the field</source>
        <translation>POINT (%1 %2) liegt außerhalb des Schlags</translation>
    </message>
    <message>
        <source>Plan again; the levels were changed.</source>
        <translation>Planen Sie neu; die Füllstände wurden geändert.</translation>
    </message>
    <message>
        <source>Refill points</source>
        <translation>Füllstellen</translation>
    </message>
    <message>
        <source>That the machine stands each time its tank is filled or its bunker emptied; 300 s where it is not given.</source>
        <translation>So lange steht die Maschine jedes Mal, wenn der Tank gefüllt oder der Bunker entleert wird; 300 s, wenn nichts angegeben ist.</translation>
    </message>
    <message>
        <source>The bunker is full in %1: %2 are worked beyond that.</source>
        <translation>Der Bunker ist voll in %1: %2 werden darüber hinaus bearbeitet.</translation>
    </message>
    <message>
        <source>The level changes %1 away from the refill points.</source>
        <translation>Der Füllstand ändert sich %1 entfernt von den Füllstellen.</translation>
    </message>
    <message>
        <source>The machine has no room at this refill point.</source>
        <translation>An dieser Füllstelle hat die Maschine keinen Platz.</translation>
    </message>
    <message>
        <source>The machine has to stand for %1 s at a refill point, and does not in %2.</source>
        <translation>Die Maschine muss an einer Füllstelle %1 s stehen und tut es nicht: %2.</translation>
    </message>
    <message>
        <source>The refill points are not used: this machine has no tank.</source>
        <translation>Die Füllstellen werden nicht gebraucht: Diese Maschine hat keinen Tank.</translation>
    </message>
    <message>
        <source>The refill points are not used: this machine&apos;s tank has no rate.</source>
        <translation>Die Füllstellen werden nicht gebraucht: Für den Tank dieser Maschine ist keine Menge je m² angegeben.</translation>
    </message>
    <message>
        <source>The refill points are not used: this operation uses no tank.</source>
        <translation>Die Füllstellen werden nicht gebraucht: Diese Arbeit verwendet keinen Tank.</translation>
    </message>
    <message>
        <source>The stated level differs from the work that is done, by up to %1 of the tank.</source>
        <translation>Der angegebene Füllstand weicht von der Arbeit ab, um bis zu %1 des Tanks.</translation>
    </message>
    <message>
        <source>The tank is empty in %1: %2 are worked beyond that.</source>
        <translation>Der Tank ist leer in %1: %2 werden darüber hinaus bearbeitet.</translation>
    </message>
    <message>
        <source>Time to fill</source>
        <translation>Füllzeit</translation>
    </message>
    <message>
        <source>Where the tank is filled or the bunker emptied: points or names of gates, divided by semicolons.</source>
        <translation>Wo der Tank gefüllt oder der Bunker entleert wird: Punkte oder Namen von Zufahrten, durch Semikolon getrennt.</translation>
    </message>
    <message>
        <source>give longitude, then latitude, in degrees</source>
        <translation>geben Sie Länge, dann Breite, in Grad an</translation>
    </message>
    <message>
        <source>names of gates or points in WGS84 such as MULTIPOINT ((4.1 52.0), (4.2 52.0))</source>
        <translation>Namen von Zufahrten oder Punkte in WGS84 wie MULTIPOINT ((4.1 52.0), (4.2 52.0))</translation>
    </message>
    <message>
        <source>Always</source>
        <translation>Immer</translation>
    </message>
    <message>
        <source>The quickest of them is taken.</source>
        <translation>Der schnellste wird genommen.</translation>
    </message>
    <message>
        <source>Only where the first one cannot be driven</source>
        <translation>Nur wenn der erste nicht fahrbar ist</translation>
    </message>
    <message>
        <source>Planning is several times quicker, and the work takes some percent longer.</source>
        <translation>Die Planung ist um ein Mehrfaches schneller, und die Arbeit dauert einige Prozent länger.</translation>
    </message>
    <message>
        <source>Compare plans</source>
        <translation>Pläne vergleichen</translation>
    </message>
    <message>
        <source>Plans with other headings, orders, corners and fewer headland passes are driven beside the first one.</source>
        <translation>Neben dem ersten werden Pläne mit anderen Fahrtrichtungen, Reihenfolgen und Ecken und mit weniger Vorgewendespuren zu Ende gerechnet.</translation>
    </message>
    <message>
        <source>headings, orders and corners are not compared as driven: the path has %1 parts and the field %2 corners, and with more than %3 in all that takes too long</source>
        <translation>Fahrtrichtungen, Reihenfolgen und Ecken werden nicht gefahren verglichen: Der Fahrweg hat %1 Teile und der Schlag %2 Ecken; mit mehr als %3 zusammen dauert das zu lange</translation>
    </message>
    <message>
        <source>Way back to work</source>
        <translation>Weg zurück zur Arbeit</translation>
    </message>
    <message>
        <source>Way to refill</source>
        <translation>Weg zum Befüllen</translation>
    </message>
    <message>
        <source>Way to unload</source>
        <translation>Weg zum Entladen</translation>
    </message>
    <message>
        <source>Swaths reach to the boundary; for fields with room to turn outside, and for machines that turn on the spot.</source>
        <translation>Spuren reichen bis zur Feldgrenze; für Schläge mit Platz zum Wenden außerhalb und für Maschinen, die auf der Stelle drehen.</translation>
    </message>
    <message>
        <source>There is no headland, as chosen. The machine turns on the spot inside the field.</source>
        <translation>Ohne Vorgewende, wie gewählt. Die Maschine dreht auf der Stelle, innerhalb des Feldes.</translation>
    </message>
</context>
<context>
    <name>PreferencesDialog</name>
    <message>
        <source>Language and units</source>
        <translation>Sprache und Einheiten</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>Same as this computer</source>
        <translation>Wie auf diesem Computer</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>Einheiten</translation>
    </message>
    <message>
        <source>Metres, hectares, km/h</source>
        <translation>Meter, Hektar, km/h</translation>
    </message>
    <message>
        <source>Feet, acres, mph</source>
        <translation>Fuß, Acre, mph</translation>
    </message>
    <message>
        <source>Fields take both: 7.3 m, 24 ft, 10&apos;6&quot;, 8 km/h, 5 mph. Files always hold metres.</source>
        <translation>Eingabefelder verstehen beides: 7,3 m, 24 ft, 10&apos;6&quot;, 8 km/h, 5 mph. Dateien enthalten immer Meter.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
</context>
<context>
    <name>PrintDialog</name>
    <message>
        <source>Print the work order</source>
        <translation>Arbeitsauftrag drucken</translation>
    </message>
    <message>
        <source>Plan again</source>
        <translation>Neu planen</translation>
    </message>
    <message numerus="yes">
        <source>%n problem(s) in this plan: it cannot be driven as drawn. The pages say so too.</source>
        <translation>
            <numerusform>%n Problem in diesem Plan: Er kann so nicht gefahren werden. Das steht auch auf den Seiten.</numerusform>
            <numerusform>%n Probleme in diesem Plan: Er kann so nicht gefahren werden. Das steht auch auf den Seiten.</numerusform>
        </translation>
    </message>
    <message>
        <source>Pages of</source>
        <translation>Seiten für</translation>
    </message>
    <message>
        <source>This field</source>
        <translation>Dieser Schlag</translation>
    </message>
    <message>
        <source>The whole farm (%1)</source>
        <translation>Der ganze Betrieb (%1)</translation>
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
        <translation>Drucker</translation>
    </message>
    <message>
        <source>No printer was found</source>
        <translation>Kein Drucker gefunden</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Save picture…</source>
        <translation>Bild speichern …</translation>
    </message>
    <message>
        <source>Print</source>
        <translation>Drucken</translation>
    </message>
    <message>
        <source>Save as PDF…</source>
        <translation>Als PDF speichern …</translation>
    </message>
    <message>
        <source>Save the work order</source>
        <translation>Arbeitsauftrag speichern</translation>
    </message>
    <message>
        <source>PDF (%1)</source>
        <translation>PDF (%1)</translation>
    </message>
    <message>
        <source>Save the page with the map as a picture</source>
        <translation>Seite mit der Karte als Bild speichern</translation>
    </message>
    <message>
        <source>Pictures (%1)</source>
        <translation>Bilder (%1)</translation>
    </message>
    <message numerus="yes">
        <source>%n field(s) of the list</source>
        <translation>
            <numerusform>%n Schlag der Liste</numerusform>
            <numerusform>%n Schläge der Liste</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ProblemCard</name>
    <message>
        <source>Show the place</source>
        <translation>Stelle zeigen</translation>
    </message>
    <message>
        <source>Open another file…</source>
        <translation>Andere Datei öffnen …</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
</context>
<context>
    <name>ProjectDialogs</name>
    <message>
        <source>Open projects or field boundaries</source>
        <translation>Projekte oder Feldgrenzen öffnen</translation>
    </message>
    <message>
        <source>Projects and field boundaries (%1)</source>
        <translation>Projekte und Feldgrenzen (%1)</translation>
    </message>
    <message>
        <source>Projects (%1)</source>
        <translation>Projekte (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Save the project</source>
        <translation>Projekt speichern</translation>
    </message>
</context>
<context>
    <name>RecentList</name>
    <message>
        <source>Open recent</source>
        <translation>Zuletzt geöffnet</translation>
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
        <translation>Weiter mit</translation>
    </message>
    <message>
        <source>Project %1 in %2, %3</source>
        <translation>Projekt %1 in %2, %3</translation>
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
        <translation>%1: %2</translation>
    </message>
    <message numerus="yes">
        <source>%n finding(s)</source>
        <translation>
            <numerusform>%n Hinweis</numerusform>
            <numerusform>%n Hinweise</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n problem(s)</source>
        <translation>
            <numerusform>%n Problem</numerusform>
            <numerusform>%n Probleme</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n to look at</source>
        <translation>
            <numerusform>%n zum Ansehen</numerusform>
            <numerusform>%n zum Ansehen</numerusform>
        </translation>
    </message>
    <message>
        <source>Show the first %1 only</source>
        <translation>Nur die ersten %1 zeigen</translation>
    </message>
    <message>
        <source>Show all %1</source>
        <translation>Alle %1 zeigen</translation>
    </message>
    <message>
        <source>Out of date: figures and findings are those of the plan before the change.</source>
        <translation>Veraltet: Zahlen und Hinweise gehören zum Plan vor der Änderung.</translation>
    </message>
    <message>
        <source>Nothing was found in this plan: all of it can be driven.</source>
        <translation>In diesem Plan wurde nichts gefunden: Alles ist fahrbar.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>first plan: preliminary figures</source>
        <translation>erster Plan: vorläufige Zahlen</translation>
    </message>
    <message>
        <source>of the plan before</source>
        <translation>vom Plan davor</translation>
    </message>
</context>
<context>
    <name>ReviewDialogs</name>
    <message>
        <source>Send for review</source>
        <translation>Zur Durchsicht geben</translation>
    </message>
    <message>
        <source>Review files (%1)</source>
        <translation>Durchsichtsdateien (%1)</translation>
    </message>
    <message>
        <source>Take in what came back</source>
        <translation>Zurückgekommenes übernehmen</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Take in this review?</source>
        <translation>Diese Durchsicht übernehmen?</translation>
    </message>
    <message>
        <source>The file is a review of a plan of the project that is open. Its comments can be taken in here.</source>
        <translation>Die Datei ist die Durchsicht eines Plans aus dem geöffneten Projekt. Ihre Kommentare können hier übernommen werden.</translation>
    </message>
    <message>
        <source>Take in</source>
        <translation>Übernehmen</translation>
    </message>
    <message>
        <source>Open by itself</source>
        <translation>Für sich öffnen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>ReviewSection</name>
    <message numerus="yes">
        <source>Review · %n open comment(s)</source>
        <translation>
            <numerusform>Durchsicht · %n offener Kommentar</numerusform>
            <numerusform>Durchsicht · %n offene Kommentare</numerusform>
        </translation>
    </message>
    <message>
        <source>Review</source>
        <translation>Durchsicht</translation>
    </message>
    <message>
        <source>The plan has changed since.</source>
        <translation>Der Plan hat sich seitdem geändert.</translation>
    </message>
    <message>
        <source>Take back</source>
        <translation>Zurücknehmen</translation>
    </message>
    <message>
        <source>At the place that you clicked:</source>
        <translation>An der angeklickten Stelle:</translation>
    </message>
    <message>
        <source>On the whole plan:</source>
        <translation>Zum ganzen Plan:</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>Kommentar</translation>
    </message>
    <message>
        <source>What should be changed here?</source>
        <translation>Was soll hier anders werden?</translation>
    </message>
    <message>
        <source>Your name</source>
        <translation>Ihr Name</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>On a place…</source>
        <translation>Zu einer Stelle …</translation>
    </message>
    <message>
        <source>On the whole plan…</source>
        <translation>Zum ganzen Plan …</translation>
    </message>
    <message>
        <source>Approve</source>
        <translation>Zustimmen</translation>
    </message>
    <message>
        <source>Ask for changes</source>
        <translation>Änderungen wünschen</translation>
    </message>
    <message>
        <source>Take in what came back…</source>
        <translation>Zurückgekommenes übernehmen …</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Comment %1:</source>
        <translation>Kommentar %1:</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Ändern</translation>
    </message>
</context>
<context>
    <name>ScaleBar</name>
    <message>
        <source>Scale: the bar is %1 long</source>
        <translation>Maßstab: der Balken ist %1 lang</translation>
    </message>
</context>
<context>
    <name>SearchButton</name>
    <message>
        <source>Search commands</source>
        <translation>Befehle suchen</translation>
    </message>
    <message>
        <source>Ctrl K</source>
        <translation>Strg K</translation>
    </message>
</context>
<context>
    <name>SettingText</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>SidePanel</name>
    <message>
        <source>Back to the plan (Esc)</source>
        <translation>Zurück zum Plan (Esc)</translation>
    </message>
</context>
<context>
    <name>SketchHint</name>
    <message>
        <source>Click the first corner of the field</source>
        <translation>Auf die erste Ecke des Schlags klicken</translation>
    </message>
    <message>
        <source>Click the first corner of the hole</source>
        <translation>Auf die erste Ecke der Aussparung klicken</translation>
    </message>
    <message>
        <source>Click the first corner of the obstacle</source>
        <translation>Auf die erste Ecke des Hindernisses klicken</translation>
    </message>
    <message>
        <source>Click on the boundary where the gate is</source>
        <translation>Auf der Feldgrenze klicken, wo die Zufahrt ist</translation>
    </message>
    <message>
        <source>Click where the AB line begins</source>
        <translation>Klicken, wo die AB-Linie beginnt</translation>
    </message>
    <message>
        <source>Length of the next edge</source>
        <translation>Länge der nächsten Kante</translation>
    </message>
    <message>
        <source>Direction of the next edge</source>
        <translation>Richtung der nächsten Kante</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>By hand</source>
        <translation>Freihand</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Close boundary</source>
        <translation>Feldgrenze schließen</translation>
    </message>
    <message>
        <source>Click where the split line begins</source>
        <translation>Klicken, wo die Teilungslinie beginnt</translation>
    </message>
    <message>
        <source>Press and trace it with the pointer, to %1</source>
        <translation>Drücken und mit dem Zeiger nachfahren, auf %1 genau</translation>
    </message>
    <message>
        <source>Backspace or Ctrl+Z takes the last point back</source>
        <translation>Rücktaste oder Strg+Z nimmt den letzten Punkt zurück</translation>
    </message>
</context>
<context>
    <name>StatusChip</name>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Plan again</source>
        <translation>Neu planen</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Show the problems</source>
        <translation>Die Probleme zeigen</translation>
    </message>
</context>
<context>
    <name>StepItem</name>
    <message>
        <source>%1. %2: %3. %4</source>
        <translation>%1. %2: %3. %4</translation>
    </message>
</context>
<context>
    <name>StepsNotice</name>
    <message>
        <source>The outline has %1 steps of about %2 %3, like the pixels of an image.</source>
        <translation>Der Umriss hat %1 Stufen von etwa %2 %3, wie die Pixel eines Bildes.</translation>
    </message>
    <message>
        <source>Made straight, their outlines would be refused. Open one of them to see why.</source>
        <translation>Begradigt würden ihre Umrisse abgelehnt. Öffnen Sie einen davon, um zu sehen, warum.</translation>
    </message>
    <message>
        <source>No machine follows them. Straight edges lead through the middles of the steps.</source>
        <translation>Keine Maschine fährt sie nach. Gerade Kanten führen durch die Mitte der Stufen.</translation>
    </message>
    <message>
        <source>Make them straight</source>
        <translation>Begradigen</translation>
    </message>
    <message>
        <source>In all fields</source>
        <translation>In allen Schlägen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
</context>
<context>
    <name>StepsPanel</name>
    <message>
        <source>Find the best plan…</source>
        <translation>Besten Plan suchen …</translation>
    </message>
</context>
<context>
    <name>ThemeSwitch</name>
    <message>
        <source>Sunlight colours; press for light</source>
        <translation>Farben für Sonnenlicht; drücken für helle</translation>
    </message>
    <message>
        <source>Dark colours; press for sunlight</source>
        <translation>Dunkle Farben; drücken für Sonnenlicht</translation>
    </message>
    <message>
        <source>Light colours; press for dark</source>
        <translation>Helle Farben; drücken für dunkle</translation>
    </message>
</context>
<context>
    <name>TopBar</name>
    <message>
        <source>Not saved yet</source>
        <translation>Noch nicht gespeichert</translation>
    </message>
    <message>
        <source>There are changes that are not saved</source>
        <translation>Es gibt nicht gespeicherte Änderungen</translation>
    </message>
    <message>
        <source>Hide the results</source>
        <translation>Ergebnisse ausblenden</translation>
    </message>
    <message>
        <source>Show the results</source>
        <translation>Ergebnisse zeigen</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleichen</translation>
    </message>
    <message>
        <source>Hide the steps</source>
        <translation>Schritte ausblenden</translation>
    </message>
    <message>
        <source>Show the steps</source>
        <translation>Schritte einblenden</translation>
    </message>
</context>
<context>
    <name>Tour</name>
    <message>
        <source>Get a field</source>
        <translation>Einen Schlag anlegen</translation>
    </message>
    <message>
        <source>Open its boundary, draw it, or press here for a sample.</source>
        <translation>Feldgrenze öffnen, zeichnen oder hier für ein Beispiel drücken.</translation>
    </message>
    <message>
        <source>Choose your machine</source>
        <translation>Ihre Maschine wählen</translation>
    </message>
    <message>
        <source>The second step: the one most like yours, then its width.</source>
        <translation>Der zweite Schritt: die ähnlichste, dann ihre Breite.</translation>
    </message>
    <message>
        <source>Change the field</source>
        <translation>Den Schlag ändern</translation>
    </message>
    <message>
        <source>Drag a corner on the map. The plan follows; Ctrl+Z takes it back.</source>
        <translation>Eine Ecke auf der Karte ziehen. Der Plan folgt; Strg+Z nimmt es zurück.</translation>
    </message>
    <message>
        <source>Take it to the tractor</source>
        <translation>Auf den Schlepper bringen</translation>
    </message>
    <message>
        <source>Export writes the plan to a stick or a folder and checks it.</source>
        <translation>Der Export schreibt den Plan auf einen Stick oder in einen Ordner und prüft ihn.</translation>
    </message>
    <message>
        <source>That is all</source>
        <translation>Das ist alles</translation>
    </message>
    <message>
        <source>First things</source>
        <translation>Die ersten Schritte</translation>
    </message>
    <message>
        <source>Leave; it is in the Help menu</source>
        <translation>Verlassen; steht im Menü Hilfe</translation>
    </message>
    <message>
        <source>%1: done</source>
        <translation>%1: erledigt</translation>
    </message>
    <message>
        <source>Ctrl+S saves the project, F1 opens the guide.</source>
        <translation>Strg+S speichert das Projekt, F1 öffnet das Handbuch.</translation>
    </message>
</context>
<context>
    <name>TrackQuestion</name>
    <message>
        <source>“%1” is a recorded track</source>
        <translation>„%1“ ist eine Aufzeichnung</translation>
    </message>
    <message>
        <source>It can become a field, or be laid over the plan to see how far beside it was driven.</source>
        <translation>Daraus kann ein Schlag werden, oder sie wird über den Plan gelegt und zeigt, wie weit daneben gefahren wurde.</translation>
    </message>
    <message>
        <source>Make a field from it</source>
        <translation>Schlag daraus machen</translation>
    </message>
    <message>
        <source>Lay it over the plan</source>
        <translation>Über den Plan legen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>TroubleDialog</name>
    <message>
        <source>Report a problem</source>
        <translation>Ein Problem melden</translation>
    </message>
    <message>
        <source>One file with all that is needed to find the cause: the version, the machine, the settings, the shape of the field, the findings, and the record of the last crash. No names and no other fields are in it.</source>
        <translation>Eine Datei mit allem, was zum Finden der Ursache nötig ist: Version, Maschine, Einstellungen, Form des Schlags, Hinweise und die Aufzeichnung des letzten Absturzes. Namen und andere Schläge sind nicht darin.</translation>
    </message>
    <message>
        <source>Nothing is sent. You decide who gets the file; write to them what you did and what you expected.</source>
        <translation>Nichts wird gesendet. Sie entscheiden, wer die Datei bekommt; schreiben Sie dazu, was Sie getan und was Sie erwartet haben.</translation>
    </message>
    <message>
        <source>Save the report…</source>
        <translation>Bericht speichern …</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>Bericht speichern</translation>
    </message>
    <message>
        <source>Reports (%1)</source>
        <translation>Berichte (%1)</translation>
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
        <translation>Änderungen an „%1“ speichern?</translation>
    </message>
    <message>
        <source>Save your work?</source>
        <translation>Arbeit speichern?</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Do not save</source>
        <translation>Nicht speichern</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
</context>
<context>
    <name>ViewCommands</name>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>What the map shows</source>
        <translation>Was die Karte zeigt</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>Size of everything</source>
        <translation>Größe der Anzeige</translation>
    </message>
    <message>
        <source>Everything at %1 %</source>
        <translation>Anzeige auf %1 %</translation>
    </message>
    <message>
        <source>size scaling zoom large text</source>
        <translation>Größe Skalierung Zoom große Schrift</translation>
    </message>
    <message>
        <source>Follow the machine</source>
        <translation>Der Maschine folgen</translation>
    </message>
    <message>
        <source>drive camera centre</source>
        <translation>fahren Karte Mitte</translation>
    </message>
    <message>
        <source>Drive-through bar</source>
        <translation>Leiste zum Abfahren</translation>
    </message>
    <message>
        <source>drive play slider</source>
        <translation>fahren abspielen Regler</translation>
    </message>
    <message>
        <source>Show the whole field</source>
        <translation>Ganzen Schlag zeigen</translation>
    </message>
    <message>
        <source>Go to a place…</source>
        <translation>Zu einem Ort gehen …</translation>
    </message>
    <message>
        <source>coordinates latitude longitude map</source>
        <translation>Koordinaten Breite Länge Karte</translation>
    </message>
    <message>
        <source>Closer</source>
        <translation>Näher heran</translation>
    </message>
    <message>
        <source>zoom in</source>
        <translation>vergrößern zoom</translation>
    </message>
    <message>
        <source>Further away</source>
        <translation>Weiter weg</translation>
    </message>
    <message>
        <source>zoom out</source>
        <translation>verkleinern zoom</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>Results panel</source>
        <translation>Ergebnisse</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Ebenen</translation>
    </message>
    <message>
        <source>imagery map background</source>
        <translation>Luftbild Karte Hintergrund</translation>
    </message>
    <message>
        <source>Layer: imagery</source>
        <translation>Ebene: Luftbild</translation>
    </message>
    <message>
        <source>Layer: OpenStreetMap from the network</source>
        <translation>Ebene: OpenStreetMap aus dem Internet</translation>
    </message>
    <message>
        <source>online tiles</source>
        <translation>online Kacheln</translation>
    </message>
    <message>
        <source>Layer: boundary</source>
        <translation>Ebene: Feldgrenze</translation>
    </message>
    <message>
        <source>Layer: headland</source>
        <translation>Ebene: Vorgewende</translation>
    </message>
    <message>
        <source>Layer: swaths</source>
        <translation>Ebene: Spuren</translation>
    </message>
    <message>
        <source>Layer: turns</source>
        <translation>Ebene: Wendungen</translation>
    </message>
    <message>
        <source>Layer: driving direction</source>
        <translation>Ebene: Fahrtrichtung</translation>
    </message>
    <message>
        <source>Layer: swath numbers</source>
        <translation>Ebene: Spurnummern</translation>
    </message>
    <message>
        <source>Layer: order numbers</source>
        <translation>Ebene: Reihenfolge</translation>
    </message>
    <message>
        <source>Layer: coverage</source>
        <translation>Ebene: bearbeitete Fläche</translation>
    </message>
    <message>
        <source>Layer: worked twice</source>
        <translation>Ebene: doppelt bearbeitet</translation>
    </message>
    <message>
        <source>overlap</source>
        <translation>Überlappung</translation>
    </message>
    <message>
        <source>Layer: missed</source>
        <translation>Ebene: Fehlstellen</translation>
    </message>
    <message>
        <source>gap uncovered</source>
        <translation>Lücke unbearbeitet</translation>
    </message>
    <message>
        <source>Layer: driven over often</source>
        <translation>Ebene: oft überfahren</translation>
    </message>
    <message>
        <source>wheel passes traffic compaction</source>
        <translation>Radspuren Überfahrten Verdichtung</translation>
    </message>
    <message>
        <source>Layer: findings</source>
        <translation>Ebene: Hinweise</translation>
    </message>
    <message>
        <source>Language and units…</source>
        <translation>Sprache und Einheiten …</translation>
    </message>
    <message>
        <source>preferences settings metric imperial feet acres</source>
        <translation>einstellungen metrisch imperial fuß acre</translation>
    </message>
    <message>
        <source>Light colours</source>
        <translation>Helle Farben</translation>
    </message>
    <message>
        <source>theme</source>
        <translation>farbschema</translation>
    </message>
    <message>
        <source>Dark colours</source>
        <translation>Dunkle Farben</translation>
    </message>
    <message>
        <source>theme night</source>
        <translation>farbschema nacht</translation>
    </message>
    <message>
        <source>Sunlight colours</source>
        <translation>Farben für Sonnenlicht</translation>
    </message>
    <message>
        <source>theme contrast</source>
        <translation>farbschema kontrast</translation>
    </message>
</context>
<context>
    <name>WindowDialogs</name>
    <message>
        <source>Everything at %1 %</source>
        <translation>Anzeige auf %1 %</translation>
    </message>
    <message>
        <source>This holds from the next start of Furrow.</source>
        <translation>Das gilt ab dem nächsten Start von Furrow.</translation>
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
        <translation>Mehrere Züge</translation>
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
        <translation>wie gezeichnet</translation>
    </message>
    <message>
        <source>Draft</source>
        <comment>work order</comment>
        <translation>Entwurf</translation>
    </message>
    <message>
        <source>Issued</source>
        <comment>work order</comment>
        <translation>Erteilt</translation>
    </message>
    <message>
        <source>In progress</source>
        <comment>work order</comment>
        <translation>In Arbeit</translation>
    </message>
    <message>
        <source>Done</source>
        <comment>work order</comment>
        <translation>Fertig</translation>
    </message>
    <message numerus="yes">
        <source>Not drivable: %n problem(s)</source>
        <translation>
            <numerusform>Nicht fahrbar: %n Problem</numerusform>
            <numerusform>Nicht fahrbar: %n Probleme</numerusform>
        </translation>
    </message>
    <message>
        <source>Work order</source>
        <translation>Arbeitsauftrag</translation>
    </message>
    <message>
        <source>Work order %1</source>
        <translation>Arbeitsauftrag %1</translation>
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
        <translation>Kunde</translation>
    </message>
    <message>
        <source>Field address</source>
        <translation>Adresse des Schlags</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>Fahrer</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Product</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>Rate and total</source>
        <translation>Aufwandmenge und Summe</translation>
    </message>
    <message>
        <source>%1 = %2</source>
        <comment>rate and total</comment>
        <translation>%1 = %2</translation>
    </message>
    <message>
        <source>Where the work starts</source>
        <translation>Wo die Arbeit beginnt</translation>
    </message>
    <message>
        <source>Gate</source>
        <translation>Zufahrt</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>Driven</source>
        <translation>Gefahren</translation>
    </message>
    <message>
        <source>Working</source>
        <translation>Arbeiten</translation>
    </message>
    <message>
        <source>Turning</source>
        <translation>Wenden</translation>
    </message>
    <message>
        <source>Covered</source>
        <translation>Bearbeitet</translation>
    </message>
    <message>
        <source>Worked twice</source>
        <translation>Doppelt bearbeitet</translation>
    </message>
    <message>
        <source>Outside the field</source>
        <translation>Außerhalb des Schlags</translation>
    </message>
    <message>
        <source>Fuel</source>
        <translation>Kraftstoff</translation>
    </message>
    <message>
        <source>%1 l</source>
        <translation>%1 l</translation>
    </message>
    <message>
        <source>Above the best order</source>
        <translation>Über der besten Reihenfolge</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Maschine</translation>
    </message>
    <message>
        <source>Working width</source>
        <translation>Arbeitsbreite</translation>
    </message>
    <message>
        <source>Width in turns</source>
        <translation>Breite beim Wenden</translation>
    </message>
    <message>
        <source>Turning radius</source>
        <translation>Wenderadius</translation>
    </message>
    <message>
        <source>Speed at work</source>
        <translation>Arbeitsgeschwindigkeit</translation>
    </message>
    <message>
        <source>Speed in turns</source>
        <translation>Wendegeschwindigkeit</translation>
    </message>
    <message>
        <source>Implement</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>trailed</source>
        <translation>gezogen</translation>
    </message>
    <message>
        <source>mounted</source>
        <translation>angebaut</translation>
    </message>
    <message>
        <source>Tank</source>
        <translation>Tank</translation>
    </message>
    <message>
        <source>full after %1</source>
        <translation>voll nach %1</translation>
    </message>
    <message>
        <source>enough for %1</source>
        <translation>reicht für %1</translation>
    </message>
    <message numerus="yes">
        <source>%n pass(es)</source>
        <translation>
            <numerusform>%n Spur</numerusform>
            <numerusform>%n Spuren</numerusform>
        </translation>
    </message>
    <message>
        <source>none</source>
        <comment>headland</comment>
        <translation>keines</translation>
    </message>
    <message>
        <source>Operation</source>
        <translation>Arbeitsgang</translation>
    </message>
    <message>
        <source>Headland</source>
        <translation>Vorgewende</translation>
    </message>
    <message>
        <source>Swaths</source>
        <translation>Spuren</translation>
    </message>
    <message>
        <source>Kept free at the edge</source>
        <translation>Abstand zur Feldgrenze</translation>
    </message>
    <message>
        <source>Plan and settings</source>
        <translation>Plan und Einstellungen</translation>
    </message>
    <message>
        <source>What was done</source>
        <translation>Ausführung</translation>
    </message>
    <message>
        <source>Acres worked</source>
        <translation>Bearbeitete Acres</translation>
    </message>
    <message>
        <source>Hectares worked</source>
        <translation>Bearbeitete Hektar</translation>
    </message>
    <message>
        <source>Hours</source>
        <translation>Stunden</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>Beginn</translation>
    </message>
    <message>
        <source>End</source>
        <comment>of the work</comment>
        <translation>Ende</translation>
    </message>
    <message>
        <source>Wind</source>
        <translation>Wind</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>Temperatur</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Bemerkungen</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>Signature</source>
        <translation>Unterschrift</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Hinweise</translation>
    </message>
    <message>
        <source>None: the plan can be driven as drawn.</source>
        <translation>Keine: Der Plan kann so gefahren werden.</translation>
    </message>
    <message numerus="yes">
        <source>and %n more, in the window and in summary.json</source>
        <translation>
            <numerusform>und %n weiterer, im Fenster und in summary.json</numerusform>
            <numerusform>und %n weitere, im Fenster und in summary.json</numerusform>
        </translation>
    </message>
    <message>
        <source>Comments</source>
        <translation>Kommentare</translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <comment>count and kind of turns</comment>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>%1 in reverse</source>
        <translation>%1 rückwärts</translation>
    </message>
    <message>
        <source>Turns</source>
        <translation>Wendungen</translation>
    </message>
    <message>
        <source>H%1</source>
        <comment>headland pass</comment>
        <translation>V%1</translation>
    </message>
    <message>
        <source>Swath %1</source>
        <translation>Spur %1</translation>
    </message>
    <message>
        <source>Order of the passes</source>
        <translation>Reihenfolge der Spuren</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>Pass</source>
        <translation>Spur</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Nach</translation>
    </message>
    <message>
        <source>This plan&apos;s path.csv has the SHA-256 sum below. A file with another sum is another plan.</source>
        <translation>Die path.csv dieses Plans hat die SHA-256-Summe unten. Eine Datei mit anderer Summe ist ein anderer Plan.</translation>
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
        <translation>Start</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>Swath</source>
        <translation>Spur</translation>
    </message>
    <message>
        <source>Headland pass</source>
        <translation>Vorgewendespur</translation>
    </message>
    <message>
        <source>Implement up</source>
        <translation>Gerät ausgehoben</translation>
    </message>
    <message>
        <source>Finding</source>
        <translation>Hinweis</translation>
    </message>
    <message>
        <source>Obstacle</source>
        <translation>Hindernis</translation>
    </message>
    <message>
        <source>Farm</source>
        <translation>Betrieb</translation>
    </message>
    <message>
        <source>Work orders</source>
        <translation>Arbeitsaufträge</translation>
    </message>
    <message numerus="yes">
        <source>%n field(s)</source>
        <translation>
            <numerusform>%n Schlag</numerusform>
            <numerusform>%n Schläge</numerusform>
        </translation>
    </message>
    <message>
        <source>Field</source>
        <translation>Schlag</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Stand</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>Not drivable</source>
        <translation>Nicht fahrbar</translation>
    </message>
    <message>
        <source>Total</source>
        <translation>Gesamt</translation>
    </message>
    <message>
        <source>Furrow %1</source>
        <translation>Furrow %1</translation>
    </message>
    <message>
        <source>plan %1</source>
        <translation>Plan %1</translation>
    </message>
    <message>
        <source>Page %1 of %2</source>
        <translation>Seite %1 von %2</translation>
    </message>
    <message>
        <source>Unloadings</source>
        <translation>Entladungen</translation>
    </message>
    <message>
        <source>Refills</source>
        <translation>Befüllungen</translation>
    </message>
</context>
<context>
    <name>furrow::BestSearch</name>
    <message>
        <source>Take the best plan</source>
        <translation>Besten Plan übernehmen</translation>
    </message>
</context>
<context>
    <name>furrow::CellSteps</name>
    <message numerus="yes">
        <source>%n block(s), %1</source>
        <translation>
            <numerusform>%n Teilfläche, %1</numerusform>
            <numerusform>%n Teilflächen, %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Cut: %1</source>
        <translation>Geteilt: %1</translation>
    </message>
    <message>
        <source>Cut: %1 → joined: %2</source>
        <translation>Geteilt: %1 → verbunden: %2</translation>
    </message>
    <message>
        <source>Joining any two of them would save nothing.</source>
        <translation>Zwei davon zu verbinden würde nichts sparen.</translation>
    </message>
    <message>
        <source>Step %1 of %2: %3</source>
        <translation>Schritt %1 von %2: %3</translation>
    </message>
    <message>
        <source>As cut.</source>
        <translation>Wie geteilt.</translation>
    </message>
    <message>
        <source>The two marked blocks become one: that saves %1.</source>
        <translation>Die zwei markierten Teilflächen werden eine: das spart %1.</translation>
    </message>
    <message>
        <source>Blocks in which no swath lies go to their neighbours.</source>
        <translation>Teilflächen, in denen keine Spur liegt, kommen zu ihren Nachbarn.</translation>
    </message>
</context>
<context>
    <name>furrow::ChoiceTableModel</name>
    <message>
        <source>saves %1</source>
        <translation>spart %1</translation>
    </message>
    <message>
        <source>mends the plan</source>
        <translation>macht den Plan fahrbar</translation>
    </message>
    <message>
        <source>the same time</source>
        <translation>gleich schnell</translation>
    </message>
    <message>
        <source>%1 slower</source>
        <translation>%1 langsamer</translation>
    </message>
    <message>
        <source>%1 quicker</source>
        <translation>%1 schneller</translation>
    </message>
</context>
<context>
    <name>furrow::DriveThrough</name>
    <message>
        <source>Swath %1, %2 of %3</source>
        <translation>Spur %1, %2 von %3</translation>
    </message>
    <message>
        <source>backwards</source>
        <translation>rückwärts</translation>
    </message>
    <message>
        <source>implement down</source>
        <translation>Gerät unten</translation>
    </message>
    <message>
        <source>implement folded</source>
        <translation>Gerät eingeklappt</translation>
    </message>
    <message>
        <source>implement up</source>
        <translation>Gerät oben</translation>
    </message>
    <message>
        <source>%1 done</source>
        <translation>%1 bearbeitet</translation>
    </message>
    <message>
        <source>wheels straight</source>
        <translation>Räder gerade</translation>
    </message>
    <message>
        <source>%1° left</source>
        <translation>%1° links</translation>
    </message>
    <message>
        <source>%1° right</source>
        <translation>%1° rechts</translation>
    </message>
    <message>
        <source>tank %1</source>
        <translation>Tank %1</translation>
    </message>
    <message>
        <source>tank empty</source>
        <translation>Tank leer</translation>
    </message>
    <message>
        <source>Way without work</source>
        <translation>Weg ohne Arbeit</translation>
    </message>
    <message>
        <source>bunker %1</source>
        <translation>Bunker %1</translation>
    </message>
</context>
<context>
    <name>furrow::DrivenTrack</name>
    <message>
        <source>On the plan</source>
        <translation>Auf dem Plan</translation>
    </message>
    <message>
        <source>Positions within one and a half widths of it; the figures are of these</source>
        <translation>Positionen bis eineinhalb Breiten daneben; die Zahlen gelten für diese</translation>
    </message>
    <message>
        <source>Half are within</source>
        <translation>Die Hälfte liegt innerhalb</translation>
    </message>
    <message>
        <source>95 % are within</source>
        <translation>95 % liegen innerhalb</translation>
    </message>
    <message>
        <source>Farthest</source>
        <translation>Größter Abstand</translation>
    </message>
    <message>
        <source>On average to the right</source>
        <translation>Im Mittel nach rechts</translation>
    </message>
    <message>
        <source>On average to the left</source>
        <translation>Im Mittel nach links</translation>
    </message>
    <message>
        <source>The same everywhere: antenna or offset</source>
        <translation>Überall gleich: Antenne oder Versatz</translation>
    </message>
    <message>
        <source>On swaths, 95 % within</source>
        <translation>Auf Spuren 95 % innerhalb</translation>
    </message>
    <message>
        <source>Covered</source>
        <translation>Bearbeitet</translation>
    </message>
    <message>
        <source>As if the implement ran in the middle of the recorded line</source>
        <translation>Als liefe das Gerät mittig auf der aufgezeichneten Linie</translation>
    </message>
    <message>
        <source>Missed</source>
        <translation>Fehlstellen</translation>
    </message>
    <message>
        <source>Driven</source>
        <translation>Gefahren</translation>
    </message>
    <message>
        <source>The plan: %1</source>
        <translation>Der Plan: %1</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>up to %1</source>
        <translation>bis %1</translation>
    </message>
    <message>
        <source>farther</source>
        <translation>weiter</translation>
    </message>
    <message>
        <source>off the plan</source>
        <translation>neben dem Plan</translation>
    </message>
</context>
<context>
    <name>furrow::ExportModel</name>
    <message>
        <source>Furrow plan</source>
        <translation>Furrow-Plan</translation>
    </message>
    <message>
        <source>Furrow %1</source>
        <translation>Furrow %1</translation>
    </message>
    <message>
        <source>Writing …</source>
        <translation>Wird geschrieben …</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) written to %1</source>
        <translation>
            <numerusform>%n Datei nach %1 geschrieben</numerusform>
            <numerusform>%n Dateien nach %1 geschrieben</numerusform>
        </translation>
    </message>
    <message>
        <source>There is no field yet, and no plan to export.</source>
        <translation>Es gibt noch keinen Schlag und keinen Plan zum Exportieren.</translation>
    </message>
    <message>
        <source>A field is being opened. Its plan can be exported when it is finished.</source>
        <translation>Ein Schlag wird geöffnet. Sein Plan lässt sich exportieren, wenn er fertig ist.</translation>
    </message>
    <message>
        <source>The plan is still being made. It can be exported when it is finished.</source>
        <translation>Der Plan entsteht noch. Er lässt sich exportieren, wenn er fertig ist.</translation>
    </message>
    <message>
        <source>The plan is out of date: the field, the machine or a setting was changed after it was made.</source>
        <translation>Der Plan ist veraltet: Schlag, Maschine oder eine Einstellung wurde danach geändert.</translation>
    </message>
    <message>
        <source>There is no plan to export. The message on the map says why.</source>
        <translation>Es gibt keinen Plan zum Exportieren. Die Meldung auf der Karte sagt, warum.</translation>
    </message>
    <message numerus="yes">
        <source>%n field(s)</source>
        <translation>
            <numerusform>%n Schlag</numerusform>
            <numerusform>%n Schläge</numerusform>
        </translation>
    </message>
    <message>
        <source>Furrow plans</source>
        <translation>Furrow Pläne</translation>
    </message>
    <message>
        <source>None of the fields could be exported.</source>
        <translation>Keiner der Schläge konnte exportiert werden.</translation>
    </message>
    <message numerus="yes">
        <source>%n field(s) written to %1</source>
        <translation>
            <numerusform>%n Schlag nach %1 geschrieben</numerusform>
            <numerusform>%n Schläge nach %1 geschrieben</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n file(s)</source>
        <translation>
            <numerusform>%n Datei</numerusform>
            <numerusform>%n Dateien</numerusform>
        </translation>
    </message>
    <message>
        <source>Writing was stopped.</source>
        <translation>Das Schreiben wurde angehalten.</translation>
    </message>
    <message>
        <source>Fields that were written before stay in the folder.</source>
        <translation>Schläge, die schon geschrieben waren, bleiben im Ordner.</translation>
    </message>
</context>
<context>
    <name>furrow::FarmList</name>
    <message numerus="yes">
        <source>Plan %n field(s) alike</source>
        <translation>
            <numerusform>%n Schlag gleich planen</numerusform>
            <numerusform>%n Schläge gleich planen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Add a plan to %n field(s)</source>
        <translation>
            <numerusform>%n Schlag einen Plan hinzufügen</numerusform>
            <numerusform>%n Schlägen einen Plan hinzufügen</numerusform>
        </translation>
    </message>
    <message>
        <source>Not planned yet</source>
        <translation>Nicht geplant</translation>
    </message>
    <message>
        <source>Out of date</source>
        <translation>Veraltet</translation>
    </message>
    <message>
        <source>Waits</source>
        <translation>Wartet</translation>
    </message>
    <message>
        <source>Planning …</source>
        <translation>Wird geplant …</translation>
    </message>
    <message>
        <source>Drivable</source>
        <translation>Fahrbar</translation>
    </message>
    <message numerus="yes">
        <source>%n problem(s)</source>
        <translation>
            <numerusform>%n Problem</numerusform>
            <numerusform>%n Probleme</numerusform>
        </translation>
    </message>
    <message>
        <source>No plan</source>
        <translation>Kein Plan</translation>
    </message>
    <message numerus="yes">
        <source>%n field(s)</source>
        <translation>
            <numerusform>%n Schlag</numerusform>
            <numerusform>%n Schläge</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n field(s)</source>
        <translation>
            <numerusform>%1 von %n Schlag</numerusform>
            <numerusform>%1 von %n Schlägen</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 drivable</source>
        <translation>%1 fahrbar</translation>
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
        <translation>Schlag umbenennen</translation>
    </message>
    <message>
        <source>Remove field %1</source>
        <translation>Schlag %1 entfernen</translation>
    </message>
    <message>
        <source>Add a plan</source>
        <translation>Plan hinzufügen</translation>
    </message>
    <message>
        <source>Rename the plan</source>
        <translation>Plan umbenennen</translation>
    </message>
    <message>
        <source>Remove the plan</source>
        <translation>Plan entfernen</translation>
    </message>
</context>
<context>
    <name>furrow::FarmPlans</name>
    <message>
        <source>%1 of %2: %3</source>
        <translation>%1 von %2: %3</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Angehalten</translation>
    </message>
    <message numerus="yes">
        <source>%n field(s) planned</source>
        <translation>
            <numerusform>%n Schlag geplant</numerusform>
            <numerusform>%n Schläge geplant</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n with problems</source>
        <translation>
            <numerusform>%n mit Problemen</numerusform>
            <numerusform>%n mit Problemen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n without a plan</source>
        <translation>
            <numerusform>%n ohne Plan</numerusform>
            <numerusform>%n ohne Plan</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>furrow::FieldEditor</name>
    <message>
        <source>Add a point</source>
        <translation>Punkt hinzufügen</translation>
    </message>
    <message>
        <source>Change the headland of an edge</source>
        <translation>Vorgewende einer Kante ändern</translation>
    </message>
    <message>
        <source>Headland of an edge as elsewhere</source>
        <translation>Vorgewende einer Kante wie sonst</translation>
    </message>
    <message>
        <source>Move a point</source>
        <translation>Punkt verschieben</translation>
    </message>
    <message>
        <source>Move an edge</source>
        <translation>Kante verschieben</translation>
    </message>
    <message>
        <source>Move a hole</source>
        <translation>Aussparung verschieben</translation>
    </message>
    <message>
        <source>Move an obstacle</source>
        <translation>Hindernis verschieben</translation>
    </message>
    <message>
        <source>Move a gate</source>
        <translation>Zufahrt verschieben</translation>
    </message>
    <message>
        <source>Change the buffer</source>
        <translation>Abstand ändern</translation>
    </message>
    <message>
        <source>Change the overhang of an obstacle</source>
        <translation>Überstand eines Hindernisses ändern</translation>
    </message>
    <message>
        <source>Change the overhang of an edge</source>
        <translation>Überstand einer Kante ändern</translation>
    </message>
    <message>
        <source>Draw a hole</source>
        <translation>Aussparung zeichnen</translation>
    </message>
    <message>
        <source>Draw an obstacle</source>
        <translation>Hindernis zeichnen</translation>
    </message>
    <message>
        <source>Obstacle %1</source>
        <translation>Hindernis %1</translation>
    </message>
    <message>
        <source>Add a gate</source>
        <translation>Zufahrt hinzufügen</translation>
    </message>
    <message>
        <source>Gate %1</source>
        <translation>Zufahrt %1</translation>
    </message>
    <message>
        <source>Draw a guidance curve</source>
        <translation>Leitkurve zeichnen</translation>
    </message>
    <message>
        <source>Draw an AB line</source>
        <translation>AB-Linie zeichnen</translation>
    </message>
    <message>
        <source>Delete a point</source>
        <translation>Punkt löschen</translation>
    </message>
    <message>
        <source>Delete a hole</source>
        <translation>Aussparung löschen</translation>
    </message>
    <message>
        <source>Delete an obstacle</source>
        <translation>Hindernis löschen</translation>
    </message>
    <message>
        <source>Delete a gate</source>
        <translation>Zufahrt löschen</translation>
    </message>
    <message>
        <source>Delete the guidance line</source>
        <translation>Leitlinie löschen</translation>
    </message>
    <message>
        <source>Make steps straight</source>
        <translation>Stufen begradigen</translation>
    </message>
    <message>
        <source>Made straight, it would be refused: %1; %2.</source>
        <translation>Begradigt würde er abgelehnt: %1; %2.</translation>
    </message>
    <message numerus="yes">
        <source>%n field(s) stay as they are: %1.</source>
        <translation>
            <numerusform>%n Schlag bleibt, wie er ist: %1.</numerusform>
            <numerusform>%n Schläge bleiben, wie sie sind: %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Verschieben</translation>
    </message>
    <message>
        <source>Change a length</source>
        <translation>Länge ändern</translation>
    </message>
    <message>
        <source>Change a direction</source>
        <translation>Richtung ändern</translation>
    </message>
    <message>
        <source>Let the obstacle be driven on</source>
        <translation>Hindernis überfahrbar machen</translation>
    </message>
    <message>
        <source>Keep off the obstacle</source>
        <translation>Hindernis nicht überfahren</translation>
    </message>
    <message>
        <source>Change the gate</source>
        <translation>Zufahrt ändern</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>AB line along an edge</source>
        <translation>AB-Linie entlang einer Kante</translation>
    </message>
    <message>
        <source>Draw a split line</source>
        <translation>Teilungslinie zeichnen</translation>
    </message>
    <message>
        <source>Delete a split line</source>
        <translation>Teilungslinie löschen</translation>
    </message>
</context>
<context>
    <name>furrow::FieldFromTrack</name>
    <message numerus="yes">
        <source>%n position(s)</source>
        <translation>
            <numerusform>%n Position</numerusform>
            <numerusform>%n Positionen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n track(s)</source>
        <translation>
            <numerusform>%n Fahrt</numerusform>
            <numerusform>%n Fahrten</numerusform>
        </translation>
    </message>
    <message>
        <source>The pieces do not touch: each becomes a field of its own.</source>
        <translation>Die Stücke berühren sich nicht: Jedes wird ein eigener Schlag.</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>Stücke</translation>
    </message>
    <message>
        <source>Holes</source>
        <translation>Löcher</translation>
    </message>
    <message>
        <source>Points of the boundary</source>
        <translation>Punkte der Feldgrenze</translation>
    </message>
    <message>
        <source>Around the field</source>
        <translation>Um den Schlag herum</translation>
    </message>
    <message>
        <source>Over the whole field, at work</source>
        <translation>Über den ganzen Schlag, bei der Arbeit</translation>
    </message>
    <message>
        <source>As it looks: around the field</source>
        <translation>Wie es aussieht: um den Schlag</translation>
    </message>
    <message>
        <source>As it looks: over the field</source>
        <translation>Wie es aussieht: über den Schlag</translation>
    </message>
    <message>
        <source>As it looks</source>
        <translation>Wie es aussieht</translation>
    </message>
</context>
<context>
    <name>furrow::FieldOpener</name>
    <message numerus="yes">
        <source>%n file(s)</source>
        <translation>
            <numerusform>%n Datei</numerusform>
            <numerusform>%n Dateien</numerusform>
        </translation>
    </message>
    <message>
        <source>Add field %1</source>
        <translation>Schlag %1 hinzufügen</translation>
    </message>
    <message numerus="yes">
        <source>Add %n field(s)</source>
        <translation>
            <numerusform>%n Schlag hinzufügen</numerusform>
            <numerusform>%n Schläge hinzufügen</numerusform>
        </translation>
    </message>
    <message>
        <source>Field %1</source>
        <translation>Schlag %1</translation>
    </message>
    <message>
        <source>drawn on the map</source>
        <translation>auf der Karte gezeichnet</translation>
    </message>
</context>
<context>
    <name>furrow::FiguresModel</name>
    <message>
        <source>Area</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>Of the field, holes and obstacles taken out</source>
        <translation>Des Schlags, ohne Aussparungen und Hindernisse</translation>
    </message>
    <message>
        <source>Inside the headland</source>
        <translation>Innenfläche</translation>
    </message>
    <message>
        <source>What is left inside the headland</source>
        <translation>Die Innenfläche: was ohne das Vorgewende bleibt</translation>
    </message>
    <message>
        <source>Swaths</source>
        <translation>Spuren</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Fahrweg</translation>
    </message>
    <message>
        <source>Everything that is driven</source>
        <translation>Alles, was gefahren wird</translation>
    </message>
    <message>
        <source>Working</source>
        <translation>Arbeiten</translation>
    </message>
    <message>
        <source>Turning</source>
        <translation>Wenden</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Covered</source>
        <translation>Bearbeitet</translation>
    </message>
    <message>
        <source>Share of the field that is worked, measured on the finished path</source>
        <translation>Bearbeiteter Anteil des Schlags, am fertigen Fahrweg gemessen</translation>
    </message>
    <message>
        <source>Overlap</source>
        <translation>Überlappung</translation>
    </message>
    <message>
        <source>Share of the field that is worked twice</source>
        <translation>Anteil des Schlags, der doppelt bearbeitet wird</translation>
    </message>
    <message>
        <source>Land that is not worked</source>
        <translation>Land, das nicht bearbeitet wird</translation>
    </message>
    <message>
        <source>%1 cannot be reached by the implement, mostly in corners; %2 could be.</source>
        <translation>%1 erreicht das Gerät nicht, meist in Ecken; %2 könnte es erreichen.</translation>
    </message>
    <message>
        <source>Missed</source>
        <translation>Fehlstellen</translation>
    </message>
    <message>
        <source>Outside the field</source>
        <translation>Außerhalb des Schlags</translation>
    </message>
    <message>
        <source>Ground outside that the machine or its implement drives over</source>
        <translation>Boden außerhalb, über den Maschine oder Gerät fahren</translation>
    </message>
</context>
<context>
    <name>furrow::FileBrowser</name>
    <message>
        <source>This folder cannot be read.</source>
        <translation>Dieser Ordner kann nicht gelesen werden.</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Persönlicher Ordner</translation>
    </message>
    <message>
        <source>Documents</source>
        <translation>Dokumente</translation>
    </message>
    <message>
        <source>Downloads</source>
        <translation>Downloads</translation>
    </message>
    <message>
        <source>Desktop</source>
        <translation>Schreibtisch</translation>
    </message>
    <message>
        <source>Computer</source>
        <translation>Computer</translation>
    </message>
</context>
<context>
    <name>furrow::FindingsModel</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>no problems</source>
        <translation>keine Probleme</translation>
    </message>
    <message numerus="yes">
        <source>%n problem(s)</source>
        <translation>
            <numerusform>%n Problem</numerusform>
            <numerusform>%n Probleme</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 → %2. Before: %3. Now: %4.</source>
        <translation>%1 → %2. Vorher: %3. Jetzt: %4.</translation>
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
        <translation>keine Spur passt</translation>
    </message>
    <message numerus="yes">
        <source>%n swath(s)</source>
        <translation>
            <numerusform>%n Spur</numerusform>
            <numerusform>%n Spuren</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 turning</source>
        <translation>%1 Wenden</translation>
    </message>
    <message>
        <source>%1 twice</source>
        <translation>%1 doppelt</translation>
    </message>
    <message>
        <source>%1 missed</source>
        <translation>%1 Fehlstellen</translation>
    </message>
    <message>
        <source>Swaths along %1</source>
        <translation>Spuren in Richtung %1</translation>
    </message>
    <message>
        <source>Search the heading</source>
        <translation>Richtung suchen</translation>
    </message>
</context>
<context>
    <name>furrow::ImageryModel</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>%1 hinzufügen</translation>
    </message>
    <message>
        <source>Add imagery</source>
        <translation>Luftbild hinzufügen</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>%1 entfernen</translation>
    </message>
    <message>
        <source>Move a layer</source>
        <translation>Ebene verschieben</translation>
    </message>
    <message>
        <source>Rename a layer</source>
        <translation>Ebene umbenennen</translation>
    </message>
    <message>
        <source>Show a layer</source>
        <translation>Ebene zeigen</translation>
    </message>
    <message>
        <source>Hide a layer</source>
        <translation>Ebene ausblenden</translation>
    </message>
    <message>
        <source>Change how strong a layer is</source>
        <translation>Deckkraft einer Ebene ändern</translation>
    </message>
    <message>
        <source>Turn the rows of tiles round</source>
        <translation>Reihenfolge der Kachelzeilen umkehren</translation>
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
        <translation>Maschine</translation>
    </message>
    <message>
        <source>machine</source>
        <translation>Maschine</translation>
    </message>
</context>
<context>
    <name>furrow::OrderModel</name>
    <message>
        <source>Order number</source>
        <translation>Auftragsnummer</translation>
    </message>
    <message>
        <source>Customer</source>
        <translation>Kunde</translation>
    </message>
    <message>
        <source>Field address</source>
        <translation>Adresse des Schlags</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>Fahrer</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Product</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Aufwandmenge</translation>
    </message>
    <message>
        <source>Unit of the rate</source>
        <translation>Einheit der Aufwandmenge</translation>
    </message>
    <message>
        <source>Area worked</source>
        <translation>Bearbeitete Fläche</translation>
    </message>
    <message>
        <source>Hours worked</source>
        <translation>Arbeitsstunden</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Bemerkungen</translation>
    </message>
    <message>
        <source>%1 per acre</source>
        <translation>%1 je Acre</translation>
    </message>
    <message>
        <source>%1 per hectare</source>
        <translation>%1 je Hektar</translation>
    </message>
    <message>
        <source>Change the work order</source>
        <translation>Arbeitsauftrag ändern</translation>
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
            <numerusform>%n Stelle auf der Karte</numerusform>
            <numerusform>%n Stellen auf der Karte</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>a line of %n point(s)</source>
        <translation>
            <numerusform>eine Linie aus %n Punkt</numerusform>
            <numerusform>eine Linie aus %n Punkten</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n line(s)</source>
        <translation>
            <numerusform>%n Linie</numerusform>
            <numerusform>%n Linien</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>furrow::PlanChange</name>
    <message>
        <source>time %1</source>
        <translation>Zeit %1</translation>
    </message>
    <message>
        <source>path %1</source>
        <translation>Fahrweg %1</translation>
    </message>
    <message>
        <source>covered %1</source>
        <translation>bearbeitet %1</translation>
    </message>
    <message>
        <source>worked twice %1</source>
        <translation>doppelt bearbeitet %1</translation>
    </message>
    <message>
        <source>With the last change: the same time, length and area.</source>
        <translation>Mit der letzten Änderung: gleiche Zeit, Länge und Fläche.</translation>
    </message>
    <message>
        <source>With the last change: %1</source>
        <translation>Mit der letzten Änderung: %1</translation>
    </message>
</context>
<context>
    <name>furrow::PlanComparison</name>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Fahrweg</translation>
    </message>
    <message>
        <source>Working</source>
        <translation>Arbeiten</translation>
    </message>
    <message>
        <source>Turning</source>
        <translation>Wenden</translation>
    </message>
    <message>
        <source>Swaths</source>
        <translation>Spuren</translation>
    </message>
    <message>
        <source>Covered</source>
        <translation>Bearbeitet</translation>
    </message>
    <message>
        <source>Missed</source>
        <translation>Fehlstellen</translation>
    </message>
    <message>
        <source>Overlap</source>
        <translation>Überlappung</translation>
    </message>
    <message>
        <source>Outside the field</source>
        <translation>Außerhalb des Schlags</translation>
    </message>
    <message>
        <source>In reverse</source>
        <translation>Rückwärts</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Probleme</translation>
    </message>
    <message>
        <source>The standard settings</source>
        <translation>Die Standardeinstellungen</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Maschine</translation>
    </message>
    <message>
        <source>All swaths lie in the same places.</source>
        <translation>Alle Spuren liegen an denselben Stellen.</translation>
    </message>
    <message numerus="yes">
        <source>%n swath(s) of the other plan lie elsewhere.</source>
        <translation>
            <numerusform>%n Spur des anderen Plans liegt woanders.</numerusform>
            <numerusform>%n Spuren des anderen Plans liegen woanders.</numerusform>
        </translation>
    </message>
    <message>
        <source>Take the standard settings</source>
        <translation>Standardeinstellungen nehmen</translation>
    </message>
    <message>
        <source>Inside the headland</source>
        <translation>Innenfläche</translation>
    </message>
    <message>
        <source>Headland passes: %1 only in this plan, %2 only in the other.</source>
        <translation>Vorgewendespuren: %1 nur in diesem Plan, %2 nur im anderen.</translation>
    </message>
    <message>
        <source>Turns and ways: %1 only in this plan, %2 only in the other.</source>
        <translation>Wendungen und Wege: %1 nur in diesem Plan, %2 nur im anderen.</translation>
    </message>
    <message>
        <source>All headland passes lie in the same places.</source>
        <translation>Alle Vorgewendespuren liegen an denselben Stellen.</translation>
    </message>
    <message>
        <source>All turns and ways lie in the same places.</source>
        <translation>Alle Wendungen und Wege liegen an denselben Stellen.</translation>
    </message>
</context>
<context>
    <name>furrow::Planning</name>
    <message>
        <source>Change the machine</source>
        <translation>Maschine ändern</translation>
    </message>
    <message>
        <source>Reading %1 …</source>
        <translation>%1 wird gelesen …</translation>
    </message>
    <message numerus="yes">
        <source>%n field(s) in this file</source>
        <translation>
            <numerusform>%n Schlag in dieser Datei</numerusform>
            <numerusform>%n Schläge in dieser Datei</numerusform>
        </translation>
    </message>
    <message>
        <source>Planning …</source>
        <translation>Wird geplant …</translation>
    </message>
    <message>
        <source>No plan</source>
        <translation>Kein Plan</translation>
    </message>
    <message>
        <source>Plan ready · %1 ms</source>
        <translation>Plan fertig · %1 ms</translation>
    </message>
    <message>
        <source>Plan ready · %1 s</source>
        <translation>Plan fertig · %1 s</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>Change: %1</source>
        <translation>Ändern: %1</translation>
    </message>
    <message>
        <source>Draft · planning …</source>
        <translation>Entwurf · wird geplant …</translation>
    </message>
    <message>
        <source>Draft · the whole plan follows when you let go</source>
        <translation>Entwurf · der ganze Plan folgt beim Loslassen</translation>
    </message>
    <message>
        <source>Out of date · this is a draft</source>
        <translation>Veraltet · dies ist ein Entwurf</translation>
    </message>
    <message>
        <source>Out of date · this is the plan before the change</source>
        <translation>Veraltet · Plan vor der Änderung</translation>
    </message>
    <message>
        <source>Stopped · there is no plan</source>
        <translation>Angehalten · es gibt keinen Plan</translation>
    </message>
    <message numerus="yes">
        <source>%n problem(s)</source>
        <translation>
            <numerusform>%n Problem</numerusform>
            <numerusform>%n Probleme</numerusform>
        </translation>
    </message>
    <message>
        <source>Out of date · this is a first plan</source>
        <translation>Veraltet · dies ist ein erster Plan</translation>
    </message>
    <message>
        <source>First plan · being improved …</source>
        <translation>Erster Plan · wird verbessert …</translation>
    </message>
    <message>
        <source>First plan · comparing plan %1 …</source>
        <translation>Erster Plan · vergleicht Plan %1 …</translation>
    </message>
    <message>
        <source>Planning … · comparing plan %1</source>
        <translation>Wird geplant … · vergleicht Plan %1</translation>
    </message>
</context>
<context>
    <name>furrow::Printing</name>
    <message>
        <source>There is no field yet, and no plan to print.</source>
        <translation>Es gibt noch keinen Schlag und keinen Plan zum Drucken.</translation>
    </message>
    <message>
        <source>The plan is still being made. It can be printed when it is finished.</source>
        <translation>Der Plan wird noch erstellt. Er kann gedruckt werden, wenn er fertig ist.</translation>
    </message>
    <message>
        <source>The plan is out of date. Plan again to print it.</source>
        <translation>Der Plan ist veraltet. Neu planen, um ihn zu drucken.</translation>
    </message>
    <message>
        <source>There is no plan to print. The message on the map says why.</source>
        <translation>Es gibt keinen Plan zum Drucken. Die Meldung auf der Karte sagt, warum.</translation>
    </message>
    <message>
        <source>Work order</source>
        <translation>Arbeitsauftrag</translation>
    </message>
    <message>
        <source>Work orders</source>
        <translation>Arbeitsaufträge</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Geschrieben: %1</translation>
    </message>
    <message>
        <source>The printer %1 did not take the pages.</source>
        <translation>Der Drucker %1 hat die Seiten nicht angenommen.</translation>
    </message>
    <message>
        <source>Look whether it is on, or save a PDF and print that.</source>
        <translation>Prüfen, ob er eingeschaltet ist, oder ein PDF speichern und dieses drucken.</translation>
    </message>
    <message>
        <source>Sent to %1</source>
        <translation>An %1 gesendet</translation>
    </message>
</context>
<context>
    <name>furrow::ProjectFiles</name>
    <message>
        <source>Your last work was not saved. Here it is again.</source>
        <translation>Die letzte Arbeit wurde nicht gespeichert. Hier ist sie wieder.</translation>
    </message>
    <message>
        <source>Changes of “%1” were not saved. Here they are again.</source>
        <translation>Änderungen an „%1“ wurden nicht gespeichert. Hier sind sie wieder.</translation>
    </message>
    <message>
        <source>It is kept in the file all the same.</source>
        <translation>In der Datei bleibt es trotzdem erhalten.</translation>
    </message>
    <message>
        <source>Restore changes that were not saved</source>
        <translation>Nicht gespeicherte Änderungen wiederherstellen</translation>
    </message>
    <message>
        <source>Another program changed “%1” while changes of yours were not saved. Yours are shown; undo shows the file.</source>
        <translation>Ein anderes Programm hat „%1“ geändert, während eigene Änderungen nicht gespeichert waren. Gezeigt werden die eigenen; Rückgängig zeigt die Datei.</translation>
    </message>
    <message>
        <source>Another program has changed “%1” since it was opened here.</source>
        <translation>Ein anderes Programm hat „%1“ geändert, seit es hier geöffnet wurde.</translation>
    </message>
    <message>
        <source>Save over it, or save yours under another name.</source>
        <translation>Überschreiben oder unter anderem Namen speichern.</translation>
    </message>
    <message>
        <source>Farm</source>
        <translation>Betrieb</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
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
        <translation>Das ist keine Länge. Eingabe zum Beispiel 7,3 m, 24 ft oder 10&apos;6&quot;.</translation>
    </message>
    <message>
        <source>This is not an area. Type it like 12.5 ha or 30 ac.</source>
        <translation>Das ist keine Fläche. Eingabe zum Beispiel 12,5 ha oder 30 ac.</translation>
    </message>
    <message>
        <source>This is not a speed. Type it like 8 km/h or 5 mph.</source>
        <translation>Das ist keine Geschwindigkeit. Eingabe zum Beispiel 8 km/h oder 5 mph.</translation>
    </message>
    <message>
        <source>This is not an angle. Type it in degrees, like 87.5.</source>
        <translation>Das ist kein Winkel. Eingabe in Grad, zum Beispiel 87,5.</translation>
    </message>
    <message>
        <source>This is not a number.</source>
        <translation>Das ist keine Zahl.</translation>
    </message>
    <message>
        <source>This is not a whole number.</source>
        <translation>Das ist keine ganze Zahl.</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>Type something from %1 to %2.</source>
        <translation>Einen Wert von %1 bis %2 eintippen.</translation>
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
        <translation>Das ist keine Zeit. Eingabe zum Beispiel 45 s oder 2 min.</translation>
    </message>
</context>
<context>
    <name>furrow::RecentFiles</name>
    <message numerus="yes">
        <source>%n field(s)</source>
        <translation>
            <numerusform>%n Schlag</numerusform>
            <numerusform>%n Schläge</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>furrow::ReviewModel</name>
    <message>
        <source>Only a finished plan of what the panels show can be sent.</source>
        <translation>Verschickt werden kann nur ein fertiger Plan zu den gezeigten Einstellungen.</translation>
    </message>
    <message>
        <source>Approved: %1</source>
        <translation>Zugestimmt: %1</translation>
    </message>
    <message>
        <source>Changes wanted: %1</source>
        <translation>Änderungen gewünscht: %1</translation>
    </message>
    <message>
        <source>Send back…</source>
        <translation>Zurückschicken …</translation>
    </message>
    <message>
        <source>Send on…</source>
        <translation>Weitergeben …</translation>
    </message>
    <message>
        <source>Send for review…</source>
        <translation>Zur Durchsicht geben …</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>Kommentar</translation>
    </message>
    <message>
        <source>Remove a comment</source>
        <translation>Kommentar entfernen</translation>
    </message>
    <message>
        <source>Settle a comment</source>
        <translation>Kommentar erledigen</translation>
    </message>
    <message>
        <source>Open a comment again</source>
        <translation>Kommentar wieder öffnen</translation>
    </message>
    <message>
        <source>Approve the plan</source>
        <translation>Dem Plan zustimmen</translation>
    </message>
    <message>
        <source>Ask for changes</source>
        <translation>Änderungen wünschen</translation>
    </message>
    <message>
        <source>Take the verdict back</source>
        <translation>Urteil zurücknehmen</translation>
    </message>
    <message>
        <source>review</source>
        <translation>Durchsicht</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Send for review</source>
        <translation>Zur Durchsicht geben</translation>
    </message>
    <message>
        <source>Written: %1. Whoever has Furrow can open it, comment on it and send it back.</source>
        <translation>Geschrieben: %1. Wer Furrow hat, kann die Datei öffnen, kommentieren und zurückgeben.</translation>
    </message>
    <message>
        <source>Take in a review</source>
        <translation>Durchsicht übernehmen</translation>
    </message>
    <message numerus="yes">
        <source>%n new comment(s)</source>
        <translation>
            <numerusform>%n neuer Kommentar</numerusform>
            <numerusform>%n neue Kommentare</numerusform>
        </translation>
    </message>
    <message>
        <source>The review was brought up to date</source>
        <translation>Die Durchsicht ist auf dem neuesten Stand</translation>
    </message>
    <message>
        <source>Nothing new in this review</source>
        <translation>Nichts Neues in dieser Durchsicht</translation>
    </message>
    <message>
        <source>%1. The plan has changed since it was sent.</source>
        <translation>%1. Der Plan hat sich seit dem Versand geändert.</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1.</translation>
    </message>
    <message>
        <source>Edit a comment</source>
        <translation>Kommentar bearbeiten</translation>
    </message>
</context>
<context>
    <name>furrow::StepsModel</name>
    <message numerus="yes">
        <source>%1 but for %n edge(s)</source>
        <translation>
            <numerusform>%1 außer an %n Kante</numerusform>
            <numerusform>%1 außer an %n Kanten</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 inside</source>
        <translation>Innenfläche %1</translation>
    </message>
    <message numerus="yes">
        <source>%n pass(es)</source>
        <translation>
            <numerusform>%n Spur</numerusform>
            <numerusform>%n Spuren</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n block(s)</source>
        <translation>
            <numerusform>%n Teilfläche</numerusform>
            <numerusform>%n Teilflächen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n swath(s)</source>
        <translation>
            <numerusform>%n Spur</numerusform>
            <numerusform>%n Spuren</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 with turns on the spot</source>
        <translation>%1 mit Wenden auf der Stelle</translation>
    </message>
    <message numerus="yes">
        <source>%n turn(s)</source>
        <translation>
            <numerusform>%n Wendung</numerusform>
            <numerusform>%n Wendungen</numerusform>
        </translation>
    </message>
    <message>
        <source>No usable boundary</source>
        <translation>Keine brauchbare Feldgrenze</translation>
    </message>
    <message>
        <source>No field yet</source>
        <translation>Noch kein Schlag</translation>
    </message>
    <message numerus="yes">
        <source>%n obstacle(s)</source>
        <translation>
            <numerusform>%n Hindernis</numerusform>
            <numerusform>%n Hindernisse</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n hole(s)</source>
        <translation>
            <numerusform>%n Aussparung</numerusform>
            <numerusform>%n Aussparungen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n boundary point(s)</source>
        <translation>
            <numerusform>%n Grenzpunkt</numerusform>
            <numerusform>%n Grenzpunkte</numerusform>
        </translation>
    </message>
    <message>
        <source>The message on the map says why</source>
        <translation>Die Meldung auf der Karte sagt, warum</translation>
    </message>
    <message>
        <source>Open a file or draw a boundary</source>
        <translation>Datei öffnen oder Feldgrenze zeichnen</translation>
    </message>
    <message>
        <source>%1 wide</source>
        <translation>%1 breit</translation>
    </message>
    <message>
        <source>%1 radius</source>
        <translation>%1 Radius</translation>
    </message>
    <message>
        <source>Field</source>
        <translation>Schlag</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Maschine</translation>
    </message>
    <message numerus="yes">
        <source>%n problem(s)</source>
        <translation>
            <numerusform>%n Problem</numerusform>
            <numerusform>%n Probleme</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing to check yet</source>
        <translation>Noch nichts zu prüfen</translation>
    </message>
    <message>
        <source>Planning …</source>
        <translation>Wird geplant …</translation>
    </message>
    <message>
        <source>No plan</source>
        <translation>Kein Plan</translation>
    </message>
    <message>
        <source>Out of date</source>
        <translation>Veraltet</translation>
    </message>
    <message>
        <source>Plan again to check what the panels show</source>
        <translation>Neu planen, um den jetzigen Stand zu prüfen</translation>
    </message>
    <message>
        <source>No problems</source>
        <translation>Keine Probleme</translation>
    </message>
    <message numerus="yes">
        <source>%n note(s)</source>
        <translation>
            <numerusform>%n Hinweis</numerusform>
            <numerusform>%n Hinweise</numerusform>
        </translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Prüfung</translation>
    </message>
    <message>
        <source>proved: no order is better</source>
        <translation>nachweislich die beste</translation>
    </message>
    <message>
        <source>turns within %1 of the best</source>
        <translation>Wendungen: höchstens +%1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>To a stick, to files or on paper</source>
        <translation>Auf Stick, als Dateien oder auf Papier</translation>
    </message>
    <message>
        <source>No plan to export yet</source>
        <translation>Noch kein Plan zum Exportieren</translation>
    </message>
    <message>
        <source>Waits for the finished plan</source>
        <translation>Wartet auf den fertigen Plan</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Export</translation>
    </message>
    <message>
        <source>First plan, being improved</source>
        <translation>Erster Plan, wird verbessert</translation>
    </message>
    <message>
        <source>Only the finished plan is checked</source>
        <translation>Erst der fertige Plan wird geprüft</translation>
    </message>
    <message>
        <source>Until then the map shows the plan before</source>
        <translation>Bis dahin zeigt die Karte den Plan davor</translation>
    </message>
</context>
<context>
    <name>furrow::StickExport</name>
    <message>
        <source>%1 free of %2</source>
        <translation>%1 frei von %2</translation>
    </message>
    <message>
        <source>Writing …</source>
        <translation>Wird geschrieben …</translation>
    </message>
    <message>
        <source>every byte was read back, and the plan read from there is this plan.</source>
        <translation>jedes Byte wurde zurückgelesen, und der gelesene Plan stimmt mit diesem überein.</translation>
    </message>
    <message>
        <source>every byte was read back and is as written.</source>
        <translation>jedes Byte wurde zurückgelesen und stimmt.</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Geschrieben: %1</translation>
    </message>
    <message>
        <source>Safe to unplug: %1</source>
        <translation>Stick kann abgezogen werden: %1</translation>
    </message>
    <message>
        <source>What was there before is kept as %1.</source>
        <translation>Was vorher da war, bleibt als %1 erhalten.</translation>
    </message>
    <message>
        <source>Writing was stopped, because the plan was changed meanwhile.</source>
        <translation>Das Schreiben wurde angehalten, weil der Plan inzwischen geändert wurde.</translation>
    </message>
    <message>
        <source>Write it again when the plan is finished.</source>
        <translation>Noch einmal schreiben, wenn der Plan fertig ist.</translation>
    </message>
    <message>
        <source>every byte was read back, and the fields read from there are these.</source>
        <translation>jedes Byte wurde zurückgelesen, und die Schläge von dort sind diese.</translation>
    </message>
</context>
<context>
    <name>furrow::SwathOrder</name>
    <message>
        <source>Search the order of the other swaths</source>
        <translation>Reihenfolge der anderen Spuren suchen</translation>
    </message>
    <message>
        <source>Search the order</source>
        <translation>Reihenfolge suchen</translation>
    </message>
    <message>
        <source>Change the order of swaths</source>
        <translation>Reihenfolge der Spuren ändern</translation>
    </message>
</context>
<context>
    <name>furrow::TroubleReport</name>
    <message>
        <source>The report could not be written: %1</source>
        <translation>Der Bericht konnte nicht geschrieben werden: %1</translation>
    </message>
    <message>
        <source>The report is in %1.</source>
        <translation>Der Bericht liegt in %1.</translation>
    </message>
</context>
</TS>
