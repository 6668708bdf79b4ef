<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="nl_NL" sourcelanguage="en">
<context>
    <name>AboutDialog</name>
    <message>
        <source>Furrow %1</source>
        <translation>Furrow %1</translation>
    </message>
    <message>
        <source>Furrow plans how a machine covers a farm field.</source>
        <translation>Furrow plant hoe een machine een perceel bewerkt.</translation>
    </message>
    <message>
        <source>Free software under the BSD 3-Clause licence: use it, change it and pass it on, without any warranty.</source>
        <translation>Vrije software onder de BSD-3-Clause-licentie: gebruiken, wijzigen en doorgeven, zonder enige garantie.</translation>
    </message>
    <message>
        <source>The methods follow the Fields2Cover paper (Mier, Valente and de Bruin, 2023) and the sources that the design names.</source>
        <translation>De methoden volgen het Fields2Cover-artikel (Mier, Valente en de Bruin, 2023) en de bronnen die het ontwerp noemt.</translation>
    </message>
    <message>
        <source>Built with %1.</source>
        <translation>Gebouwd met %1.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Sluiten</translation>
    </message>
</context>
<context>
    <name>BestPlanDialog</name>
    <message>
        <source>The best plan found</source>
        <translation>Het beste gevonden plan</translation>
    </message>
    <message>
        <source>Your plan is the best one found</source>
        <translation>Uw plan is het beste gevonden plan</translation>
    </message>
    <message>
        <source>Find the best plan</source>
        <translation>Beste plan zoeken</translation>
    </message>
    <message>
        <source>Other choices are planned, and the quickest plan that can be driven is taken. Margins, overlap and what the operation needs stay as they are.</source>
        <translation>Andere keuzes worden gepland, en het snelste plan dat te rijden is wordt genomen. Marges, overlap en wat de bewerking vraagt blijven zoals ze zijn.</translation>
    </message>
    <message>
        <source>May change</source>
        <translation>Mag veranderen</translation>
    </message>
    <message>
        <source>%1 (set by you)</source>
        <translation>%1 (door u)</translation>
    </message>
    <message>
        <source>Best plan</source>
        <translation>Beste plan</translation>
    </message>
    <message>
        <source>Best so far</source>
        <translation>Beste tot nu toe</translation>
    </message>
    <message>
        <source>As it was</source>
        <translation>Eerst</translation>
    </message>
    <message>
        <source>Saved</source>
        <translation>Bespaard</translation>
    </message>
    <message>
        <source>Time of the best plan during the search</source>
        <translation>Tijd van het beste plan tijdens het zoeken</translation>
    </message>
    <message numerus="yes">
        <source>%n alternative(s) were planned.</source>
        <translation>
            <numerusform>%n alternatief is gepland.</numerusform>
            <numerusform>%n alternatieven zijn gepland.</numerusform>
        </translation>
    </message>
    <message>
        <source>Times include working separately what a plan leaves.</source>
        <translation>De tijden bevatten het apart bewerken van wat een plan laat liggen.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Sluiten</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuleren</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Zoeken</translation>
    </message>
    <message>
        <source>Stop and keep</source>
        <translation>Stoppen en behouden</translation>
    </message>
    <message>
        <source>Use this plan</source>
        <translation>Dit plan gebruiken</translation>
    </message>
</context>
<context>
    <name>CellStepper</name>
    <message>
        <source>Done</source>
        <translation>Klaar</translation>
    </message>
    <message>
        <source>Go through the steps</source>
        <translation>Stappen doorlopen</translation>
    </message>
    <message>
        <source>Next step</source>
        <translation>Volgende stap</translation>
    </message>
    <message>
        <source>Previous step</source>
        <translation>Vorige stap</translation>
    </message>
    <message>
        <source>Show the blocks</source>
        <translation>Deelpercelen tonen</translation>
    </message>
    <message>
        <source>Step of the blocks</source>
        <translation>Stap van de deelpercelen</translation>
    </message>
    <message>
        <source>Turns and ways from block to block, estimated.</source>
        <translation>Draaien en verplaatsingen van deelperceel naar deelperceel, geschat.</translation>
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
            <numerusform>%n andere is nog langzamer of niet te rijden.</numerusform>
            <numerusform>%n andere zijn nog langzamer of niet te rijden.</numerusform>
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
        <translation>Shift</translation>
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
        <translation>Er is geen opdracht en geen instelling met die naam</translation>
    </message>
    <message>
        <source>Search commands, settings, coordinates</source>
        <translation>Opdrachten, instellingen, coördinaten zoeken</translation>
    </message>
    <message>
        <source>As maps, phones and receivers write them</source>
        <translation>Zoals kaarten, telefoons en ontvangers ze schrijven</translation>
    </message>
</context>
<context>
    <name>CommentPins</name>
    <message>
        <source>Comment %1: %2</source>
        <translation>Opmerking %1: %2</translation>
    </message>
    <message>
        <source>Click the place that you want to comment on. Esc ends it.</source>
        <translation>Klik op de plek waar de opmerking bij hoort. Esc stopt.</translation>
    </message>
</context>
<context>
    <name>CommentRow</name>
    <message>
        <source>Comment %1 by %2: %3</source>
        <translation>Opmerking %1 van %2: %3</translation>
    </message>
    <message>
        <source>Of a plan before the last change</source>
        <translation>Van een plan vóór de laatste wijziging</translation>
    </message>
    <message>
        <source>Open again</source>
        <translation>Heropenen</translation>
    </message>
    <message>
        <source>Settled</source>
        <translation>Afgehandeld</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Verwijderen</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Bewerken</translation>
    </message>
</context>
<context>
    <name>ComparePanel</name>
    <message>
        <source>Compare</source>
        <translation>Vergelijken</translation>
    </message>
    <message>
        <source>%1 beside</source>
        <translation>%1 naast</translation>
    </message>
    <message>
        <source>The other plan</source>
        <translation>Het andere plan</translation>
    </message>
    <message>
        <source>Keep this plan as a variant…</source>
        <translation>Dit plan als variant bewaren…</translation>
    </message>
    <message>
        <source>The other plan is being made …</source>
        <translation>Het andere plan wordt gemaakt…</translation>
    </message>
    <message>
        <source>This plan</source>
        <translation>Dit plan</translation>
    </message>
    <message>
        <source>The other</source>
        <translation>Het andere</translation>
    </message>
    <message>
        <source>%1: %2, the other %3</source>
        <translation>%1: %2, het andere %3</translation>
    </message>
    <message>
        <source>Hold to see the other plan (key X)</source>
        <translation>Vasthouden: het andere plan (toets X)</translation>
    </message>
    <message>
        <source>What was chosen otherwise</source>
        <translation>Wat anders gekozen is</translation>
    </message>
    <message>
        <source>Machine and settings are the same.</source>
        <translation>Machine en instellingen zijn gelijk.</translation>
    </message>
    <message>
        <source>%1 → %2</source>
        <translation>%1 → %2</translation>
    </message>
    <message>
        <source>Go on with the other plan</source>
        <translation>Verder met het andere plan</translation>
    </message>
    <message>
        <source>Two maps side by side (Ctrl+Shift+D)</source>
        <translation>Twee kaarten naast elkaar (Ctrl+Shift+D)</translation>
    </message>
    <message>
        <source>On the maps, swaths, headland passes and turns are coloured that the other plan has not: full lines in this plan, dashes in the other.</source>
        <translation>Op de kaarten zijn werkgangen, kopakkergangen en draaien gekleurd die het andere plan niet heeft: volle lijnen in dit plan, streepjes in het andere.</translation>
    </message>
    <message>
        <source>On the map, swaths, headland passes and turns: full lines only in this plan, dashes only in the other.</source>
        <translation>Op de kaart, werkgangen, kopakkergangen en draaien: volle lijnen alleen in dit plan, streepjes alleen in het andere.</translation>
    </message>
</context>
<context>
    <name>CrashNotice</name>
    <message>
        <source>Furrow ended unexpectedly the last time.</source>
        <translation>Furrow is de vorige keer onverwacht gestopt.</translation>
    </message>
    <message>
        <source>Your work was kept up to the last half second. What happened is recorded on this computer; a report helps to mend it.</source>
        <translation>Uw werk is bewaard tot de laatste halve seconde. Wat er gebeurde, is op deze computer vastgelegd; een verslag helpt om het te verhelpen.</translation>
    </message>
    <message>
        <source>Report a problem…</source>
        <translation>Een probleem melden…</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Sluiten</translation>
    </message>
</context>
<context>
    <name>DrawingNotice</name>
    <message>
        <source>The map cannot show fields and plans: this window is drawn without OpenGL.</source>
        <translation>De kaart kan geen percelen en plannen tonen: dit venster wordt zonder OpenGL getekend.</translation>
    </message>
    <message>
        <source>Install a graphics driver with OpenGL; Mesa draws on any processor. The command line plans and exports all the same.</source>
        <translation>Installeer een grafisch stuurprogramma met OpenGL; Mesa tekent op elke processor. Op de opdrachtregel kan wel worden gepland en geëxporteerd.</translation>
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
        <translation>Afrijden</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pauze</translation>
    </message>
    <message>
        <source>Drive through the plan</source>
        <translation>Plan afrijden</translation>
    </message>
    <message>
        <source>Moment of the drive</source>
        <translation>Moment van de rit</translation>
    </message>
    <message>
        <source>Pace: %1 times as fast</source>
        <translation>Tempo: %1 keer zo snel</translation>
    </message>
    <message>
        <source>%1×</source>
        <translation>%1×</translation>
    </message>
    <message>
        <source>Let the map rest</source>
        <translation>Kaart laten rusten</translation>
    </message>
    <message>
        <source>Follow the machine</source>
        <translation>De machine volgen</translation>
    </message>
    <message>
        <source>Hide the drive-through</source>
        <translation>Afrijden verbergen</translation>
    </message>
</context>
<context>
    <name>DrivenDialog</name>
    <message>
        <source>Open a recorded track</source>
        <translation>Opgenomen rit openen</translation>
    </message>
    <message>
        <source>Recorded tracks (%1)</source>
        <translation>Opgenomen ritten (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle bestanden (*)</translation>
    </message>
</context>
<context>
    <name>DrivenPanel</name>
    <message>
        <source>Planned and driven</source>
        <translation>Gepland en gereden</translation>
    </message>
    <message>
        <source>Go to the farthest place</source>
        <translation>Naar de grootste afstand</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Distance from the plan</source>
        <translation>Afstand tot het plan</translation>
    </message>
    <message>
        <source>Another track…</source>
        <translation>Andere rit…</translation>
    </message>
    <message>
        <source>Make a field from it</source>
        <translation>Er een perceel van maken</translation>
    </message>
</context>
<context>
    <name>EditCommands</name>
    <message>
        <source>Edit</source>
        <translation>Bewerken</translation>
    </message>
    <message>
        <source>Undo: %1</source>
        <translation>Ongedaan maken: %1</translation>
    </message>
    <message>
        <source>Draw a point</source>
        <translation>Punt tekenen</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Ongedaan maken</translation>
    </message>
    <message>
        <source>Redo: %1</source>
        <translation>Opnieuw: %1</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Opnieuw</translation>
    </message>
    <message>
        <source>Delete what is selected</source>
        <translation>Selectie verwijderen</translation>
    </message>
    <message>
        <source>Del</source>
        <translation>Del</translation>
    </message>
    <message>
        <source>Select the next point</source>
        <translation>Volgend punt selecteren</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Spatie</translation>
    </message>
    <message>
        <source>Select the next edge</source>
        <translation>Volgende zijde selecteren</translation>
    </message>
    <message>
        <source>Select the next outline, line or gate</source>
        <translation>Volgende omtrek, lijn of inrit selecteren</translation>
    </message>
    <message>
        <source>PgDown</source>
        <translation>PgDn</translation>
    </message>
    <message>
        <source>Find a command…</source>
        <translation>Opdracht zoeken…</translation>
    </message>
</context>
<context>
    <name>EmptyState</name>
    <message>
        <source>Which field?</source>
        <translation>Welk perceel?</translation>
    </message>
    <message>
        <source>Open its boundary, or drop the file anywhere on this window. Shapefile, GeoJSON, KML, GeoPackage, GML and others are understood, zipped or not.</source>
        <translation>Open de perceelsgrens, of sleep het bestand ergens op dit venster. Shapefile, GeoJSON, KML, GeoPackage, GML en andere worden gelezen, al dan niet gezipt.</translation>
    </message>
    <message>
        <source>Open a file…</source>
        <translation>Bestand openen…</translation>
    </message>
    <message>
        <source>Draw it</source>
        <translation>Tekenen</translation>
    </message>
    <message>
        <source>Or try one of these</source>
        <translation>Of probeer een van deze</translation>
    </message>
    <message>
        <source>Sample field %1</source>
        <translation>Voorbeeldperceel %1</translation>
    </message>
</context>
<context>
    <name>ErrorCourse</name>
    <message>
        <source>Distance from the plan along the recording, up to %1</source>
        <translation>Afstand tot het plan langs de opname, tot %1</translation>
    </message>
    <message>
        <source>%1 to the left</source>
        <translation>%1 naar links</translation>
    </message>
    <message>
        <source>%1 to the right</source>
        <translation>%1 naar rechts</translation>
    </message>
</context>
<context>
    <name>ExportChecks</name>
    <message>
        <source>Choose another format or terminal, and report this.</source>
        <translation>Kies een ander formaat of een andere terminal en meld dit.</translation>
    </message>
    <message numerus="yes">
        <source>%n check(s) passed: nothing in the files that receivers stumble over.</source>
        <translation>
            <numerusform>%n controle geslaagd: niets in de bestanden waar terminals over struikelen.</numerusform>
            <numerusform>%n controles geslaagd: niets in de bestanden waar terminals over struikelen.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ExportDialog</name>
    <message>
        <source>Export the plan</source>
        <translation>Plan exporteren</translation>
    </message>
    <message>
        <source>USB stick</source>
        <translation>USB-stick</translation>
    </message>
    <message>
        <source>Files in a folder</source>
        <translation>Bestanden in een map</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Sluiten</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuleren</translation>
    </message>
    <message>
        <source>Writing …</source>
        <translation>Bezig met schrijven…</translation>
    </message>
    <message>
        <source>Write to the stick</source>
        <translation>Naar de stick schrijven</translation>
    </message>
    <message>
        <source>Write files</source>
        <translation>Bestanden schrijven</translation>
    </message>
    <message>
        <source>Plan again</source>
        <translation>Opnieuw plannen</translation>
    </message>
    <message numerus="yes">
        <source>%n problem(s) in this plan: it cannot be driven as drawn. The files say so too.</source>
        <translation>
            <numerusform>%n probleem in dit plan: zo kan het niet worden gereden. Dat staat ook in de bestanden.</numerusform>
            <numerusform>%n problemen in dit plan: zo kan het niet worden gereden. Dat staat ook in de bestanden.</numerusform>
        </translation>
    </message>
    <message>
        <source>Export fields</source>
        <translation>Percelen exporteren</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stoppen</translation>
    </message>
</context>
<context>
    <name>ExportFolderPage</name>
    <message>
        <source>Folder</source>
        <translation>Map</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Kiezen…</translation>
    </message>
    <message>
        <source>Folder for the plan</source>
        <translation>Map voor het plan</translation>
    </message>
    <message>
        <source>Fields without a plan are planned on the way. Each field gets a folder of its own; ISOXML and AgGPS hold all fields in one.</source>
        <translation>Percelen zonder plan worden onderweg gepland. Elk perceel krijgt een eigen map; ISOXML en AgGPS bevatten alle percelen samen.</translation>
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
        <translation>Er zit geen USB-stick in. Hij verschijnt hier zodra dat wel zo is; of kies een map om de bestanden zelf over te zetten.</translation>
    </message>
    <message>
        <source>Another folder…</source>
        <translation>Andere map…</translation>
    </message>
    <message>
        <source>%1 is on it already.</source>
        <translation>%1 staat er al op.</translation>
    </message>
    <message>
        <source>It will not be deleted: it is kept under another name.</source>
        <translation>Het wordt niet gewist: het blijft onder een andere naam bewaard.</translation>
    </message>
    <message>
        <source>Keep it as a backup and write the plan</source>
        <translation>Als reservekopie bewaren en het plan schrijven</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>en nog %n</numerusform>
            <numerusform>en nog %n</numerusform>
        </translation>
    </message>
    <message>
        <source>Folder in the place of a stick</source>
        <translation>Map in plaats van een stick</translation>
    </message>
    <message>
        <source>Also in a task, for terminals that show lines in tasks only</source>
        <translation>Ook in een taak, voor terminals die lijnen alleen in taken tonen</translation>
    </message>
</context>
<context>
    <name>FarImageryNotice</name>
    <message>
        <source>This picture does not show the field: it lies %1 away.</source>
        <translation>Deze afbeelding toont het perceel niet: ze ligt %1 verderop.</translation>
    </message>
    <message>
        <source>Go there</source>
        <translation>Daarheen gaan</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Sluiten</translation>
    </message>
</context>
<context>
    <name>FarmHeader</name>
    <message>
        <source>%1, sorted downwards</source>
        <translation>%1, aflopend gesorteerd</translation>
    </message>
    <message>
        <source>%1, sorted</source>
        <translation>%1, gesorteerd</translation>
    </message>
</context>
<context>
    <name>FarmPanel</name>
    <message>
        <source>The farm</source>
        <translation>Het bedrijf</translation>
    </message>
    <message>
        <source>Find a field</source>
        <translation>Perceel zoeken</translation>
    </message>
    <message>
        <source>Find a field, season or machine</source>
        <translation>Perceel, seizoen of machine zoeken</translation>
    </message>
    <message>
        <source>Back to the field (Esc)</source>
        <translation>Terug naar het perceel (Esc)</translation>
    </message>
    <message>
        <source>Field</source>
        <translation>Perceel</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Machine</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Oppervlakte</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tijd</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Traject</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Status</translation>
    </message>
    <message>
        <source>Fields of the farm</source>
        <translation>Percelen van het bedrijf</translation>
    </message>
    <message>
        <source>No field has these words.</source>
        <translation>Geen perceel bevat deze woorden.</translation>
    </message>
    <message>
        <source>There is no field yet.</source>
        <translation>Er is nog geen perceel.</translation>
    </message>
    <message>
        <source>Select none</source>
        <translation>Niets selecteren</translation>
    </message>
    <message>
        <source>Select all</source>
        <translation>Alles selecteren</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stoppen</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
    <message numerus="yes">
        <source>Plan %n field(s)</source>
        <translation>
            <numerusform>%n perceel plannen</numerusform>
            <numerusform>%n percelen plannen</numerusform>
        </translation>
    </message>
    <message>
        <source>Planning …</source>
        <translation>Bezig met plannen…</translation>
    </message>
    <message>
        <source>All are planned</source>
        <translation>Alles is gepland</translation>
    </message>
    <message>
        <source>Machine and settings of this plan</source>
        <translation>Machine en instellingen van dit plan</translation>
    </message>
    <message>
        <source>Add a plan to each…</source>
        <translation>Aan elk een plan toevoegen…</translation>
    </message>
    <message>
        <source>Print…</source>
        <translation>Afdrukken…</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exporteren…</translation>
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
        <translation>Bestand openen…</translation>
    </message>
    <message>
        <source>Draw</source>
        <translation>Tekenen</translation>
    </message>
    <message>
        <source>Sample field</source>
        <translation>Voorbeeldperceel</translation>
    </message>
    <message>
        <source>Add one to look at</source>
        <translation>Eén toevoegen om te bekijken</translation>
    </message>
</context>
<context>
    <name>FieldChooser</name>
    <message numerus="yes">
        <source>Which of the %n field(s)?</source>
        <translation>
            <numerusform>Welk perceel (%n)?</numerusform>
            <numerusform>Welk van de %n percelen?</numerusform>
        </translation>
    </message>
    <message>
        <source>Open none of them</source>
        <translation>Geen ervan openen</translation>
    </message>
    <message>
        <source>Open all of them</source>
        <translation>Alle openen</translation>
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
        <translation>Perceel</translation>
    </message>
    <message>
        <source>Draw a field</source>
        <translation>Perceel tekenen</translation>
    </message>
    <message>
        <source>boundary polygon</source>
        <translation>perceelsgrens polygoon</translation>
    </message>
    <message>
        <source>Make a field from a recorded track…</source>
        <translation>Perceel maken uit een opgenomen rit…</translation>
    </message>
    <message>
        <source>boundary driven recorded GPX NMEA log drive around</source>
        <translation>perceelsgrens gereden opgenomen GPX NMEA omrijden</translation>
    </message>
    <message>
        <source>Draw a hole</source>
        <translation>Gat tekenen</translation>
    </message>
    <message>
        <source>Draw an obstacle</source>
        <translation>Obstakel tekenen</translation>
    </message>
    <message>
        <source>pond tree pole wet</source>
        <translation>vijver boom mast nat</translation>
    </message>
    <message>
        <source>Draw an AB line</source>
        <translation>AB-lijn tekenen</translation>
    </message>
    <message>
        <source>guidance curve direction</source>
        <translation>stuurlijn curve richting</translation>
    </message>
    <message>
        <source>Draw a split line</source>
        <translation>Splitlijn tekenen</translation>
    </message>
    <message>
        <source>cut divide mainland parts</source>
        <translation>snijden delen binnenakker stukken</translation>
    </message>
    <message>
        <source>Add a gate</source>
        <translation>Inrit toevoegen</translation>
    </message>
    <message>
        <source>entry road</source>
        <translation>toegang weg</translation>
    </message>
    <message>
        <source>Select and change</source>
        <translation>Selecteren en wijzigen</translation>
    </message>
    <message>
        <source>Make the outline&apos;s steps straight</source>
        <translation>Trapjes in de omtrek recht maken</translation>
    </message>
    <message>
        <source>pixels image stairs smooth simplify</source>
        <translation>pixels beeld trap gladmaken vereenvoudigen</translation>
    </message>
    <message>
        <source>Rename the field…</source>
        <translation>Perceel hernoemen…</translation>
    </message>
    <message>
        <source>Remove the field</source>
        <translation>Perceel verwijderen</translation>
    </message>
    <message>
        <source>delete</source>
        <translation>wissen</translation>
    </message>
    <message>
        <source>Next field</source>
        <translation>Volgend perceel</translation>
    </message>
    <message>
        <source>All fields of the farm</source>
        <translation>Alle percelen van het bedrijf</translation>
    </message>
    <message>
        <source>list overview plan all batch totals</source>
        <translation>lijst overzicht alles plannen totalen</translation>
    </message>
</context>
<context>
    <name>FieldFromTrackPanel</name>
    <message>
        <source>Field from a track</source>
        <translation>Perceel uit een rit</translation>
    </message>
    <message>
        <source>How it was driven</source>
        <translation>Hoe er is gereden</translation>
    </message>
    <message>
        <source>Operating width</source>
        <translation>Werkbreedte</translation>
    </message>
    <message>
        <source>The edge lies outside of the line by</source>
        <translation>De rand ligt buiten de lijn op</translation>
    </message>
    <message>
        <source>Half a width: the implement ran along the edge</source>
        <translation>Halve breedte: het werktuig liep langs de rand</translation>
    </message>
    <message>
        <source>None: the line is the edge</source>
        <translation>Niets: de lijn is de rand</translation>
    </message>
    <message>
        <source>Gaps between strips are closed up to</source>
        <translation>Gaten tussen stroken worden gesloten tot</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Make the field</source>
        <translation>Perceel maken</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuleren</translation>
    </message>
</context>
<context>
    <name>FieldsToExport</name>
    <message numerus="yes">
        <source>%1 and %n more</source>
        <translation>
            <numerusform>%1 en nog %n</numerusform>
            <numerusform>%1 en nog %n</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: the plan has problems and cannot be driven as drawn. The files say so too.</source>
        <translation>%1: het plan heeft problemen en is niet te rijden zoals getekend. De bestanden zeggen dat ook.</translation>
    </message>
</context>
<context>
    <name>FileCommands</name>
    <message>
        <source>File</source>
        <translation>Bestand</translation>
    </message>
    <message>
        <source>New project</source>
        <translation>Nieuw project</translation>
    </message>
    <message>
        <source>farm</source>
        <translation>bedrijf</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Openen…</translation>
    </message>
    <message>
        <source>boundary import project</source>
        <translation>perceelsgrens importeren project</translation>
    </message>
    <message>
        <source>Add imagery…</source>
        <translation>Luchtfoto toevoegen…</translation>
    </message>
    <message>
        <source>GeoTIFF MBTiles aerial photo satellite background heights elevation</source>
        <translation>GeoTIFF MBTiles luchtfoto satelliet achtergrond hoogte reliëf</translation>
    </message>
    <message>
        <source>Add a folder of tiles…</source>
        <translation>Map met tegels toevoegen…</translation>
    </message>
    <message>
        <source>imagery XYZ TMS</source>
        <translation>luchtfoto XYZ TMS</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Opslaan</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Opslaan als…</translation>
    </message>
    <message>
        <source>Export the plan…</source>
        <translation>Plan exporteren…</translation>
    </message>
    <message>
        <source>ISOXML USB terminal</source>
        <translation>ISOXML USB terminal</translation>
    </message>
    <message>
        <source>Print the work order…</source>
        <translation>Werkopdracht afdrukken…</translation>
    </message>
    <message>
        <source>print pdf report work order picture printer</source>
        <translation>afdrukken PDF rapport werkopdracht afbeelding printer</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Afsluiten</translation>
    </message>
</context>
<context>
    <name>FileList</name>
    <message>
        <source>%1, falling</source>
        <translation>%1, aflopend</translation>
    </message>
    <message>
        <source>%1, rising</source>
        <translation>%1, oplopend</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Naam</translation>
    </message>
    <message>
        <source>Changed</source>
        <translation>Gewijzigd</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Grootte</translation>
    </message>
    <message>
        <source>Files of %1</source>
        <translation>Bestanden van %1</translation>
    </message>
    <message>
        <source>Folder %1</source>
        <translation>Map %1</translation>
    </message>
    <message>
        <source>%1, %2, %3</source>
        <translation>%1, %2, %3</translation>
    </message>
    <message>
        <source>Reading the folder …</source>
        <translation>De map wordt gelezen …</translation>
    </message>
    <message>
        <source>Nothing to choose here.</source>
        <translation>Hier valt niets te kiezen.</translation>
    </message>
</context>
<context>
    <name>FileWindow</name>
    <message>
        <source>The folder around it (Backspace)</source>
        <translation>De map erboven (Backspace)</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Map</translation>
    </message>
    <message>
        <source>New folder…</source>
        <translation>Nieuwe map…</translation>
    </message>
    <message>
        <source>“%1” is already there. Write over it?</source>
        <translation>“%1” bestaat al. Overschrijven?</translation>
    </message>
    <message>
        <source>There is no folder “%1”. Make it?</source>
        <translation>Er is geen map “%1”. Maken?</translation>
    </message>
    <message>
        <source>Name of the new folder</source>
        <translation>Naam van de nieuwe map</translation>
    </message>
    <message>
        <source>No</source>
        <translation>Nee</translation>
    </message>
    <message>
        <source>Write over it</source>
        <translation>Overschrijven</translation>
    </message>
    <message>
        <source>Make the folder</source>
        <translation>Map maken</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Naam</translation>
    </message>
    <message>
        <source>Which files are shown</source>
        <translation>Welke bestanden worden getoond</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuleren</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Opslaan</translation>
    </message>
    <message>
        <source>Choose this folder</source>
        <translation>Deze map kiezen</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Openen</translation>
    </message>
    <message>
        <source>The folder “%1” cannot be made.</source>
        <translation>De map “%1” kan niet worden gemaakt.</translation>
    </message>
    <message>
        <source>There is nothing called “%1”.</source>
        <translation>Er is niets dat “%1” heet.</translation>
    </message>
    <message>
        <source>Choose files only, or one folder to look into.</source>
        <translation>Kies alleen bestanden, of één map om erin te kijken.</translation>
    </message>
    <message>
        <source>Choose a file first.</source>
        <translation>Kies eerst een bestand.</translation>
    </message>
    <message>
        <source>Nothing can be written in “%1”. Choose another folder.</source>
        <translation>In “%1” kan niets worden geschreven. Kies een andere map.</translation>
    </message>
    <message>
        <source>Give the file a name.</source>
        <translation>Geef het bestand een naam.</translation>
    </message>
</context>
<context>
    <name>FilesNotice</name>
    <message>
        <source>Keep</source>
        <translation>Behouden</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
    <message>
        <source>Throw away</source>
        <translation>Weggooien</translation>
    </message>
    <message>
        <source>Save over it</source>
        <translation>Overschrijven</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Opslaan als…</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Later</translation>
    </message>
</context>
<context>
    <name>Finder</name>
    <message>
        <source>Coordinates, such as 48.1371, 11.5754</source>
        <translation>Coördinaten, zoals 48,1371; 11,5754</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>Handleiding</translation>
    </message>
    <message>
        <source>Sample field</source>
        <translation>Voorbeeldperceel</translation>
    </message>
    <message>
        <source>example try</source>
        <translation>voorbeeld proberen</translation>
    </message>
    <message>
        <source>Fields</source>
        <translation>Percelen</translation>
    </message>
    <message>
        <source>field</source>
        <translation>perceel</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Bevindingen</translation>
    </message>
    <message>
        <source>finding</source>
        <translation>bevinding</translation>
    </message>
    <message>
        <source>Go to %1</source>
        <translation>Ga naar %1</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Kaart</translation>
    </message>
</context>
<context>
    <name>FindingRow</name>
    <message>
        <source>Finding %1: %2 %3</source>
        <translation>Bevinding %1: %2 %3</translation>
    </message>
    <message>
        <source>Apply: %1</source>
        <translation>Toepassen: %1</translation>
    </message>
    <message>
        <source>For information</source>
        <translation>Ter informatie</translation>
    </message>
    <message>
        <source>%1 of %2 of this kind</source>
        <translation>%1 van %2 van deze soort</translation>
    </message>
    <message>
        <source>The one before, of this kind (Ctrl+Shift+F8)</source>
        <translation>De vorige van deze soort (Ctrl+Shift+F8)</translation>
    </message>
    <message>
        <source>The next of this kind (Ctrl+F8)</source>
        <translation>De volgende van deze soort (Ctrl+F8)</translation>
    </message>
</context>
<context>
    <name>GuidePanel</name>
    <message>
        <source>All chapters</source>
        <translation>Alle hoofdstukken</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>Handleiding</translation>
    </message>
    <message>
        <source>Close the guide (Esc)</source>
        <translation>Handleiding sluiten (Esc)</translation>
    </message>
    <message>
        <source>Search the guide</source>
        <translation>In de handleiding zoeken</translation>
    </message>
    <message>
        <source>Nothing is found. Try another word.</source>
        <translation>Niets gevonden. Probeer een ander woord.</translation>
    </message>
</context>
<context>
    <name>HeadingChart</name>
    <message>
        <source>Time by</source>
        <translation>Tijd bij</translation>
    </message>
    <message>
        <source>direction</source>
        <translation>richting</translation>
    </message>
    <message>
        <source>overlap</source>
        <translation>overlap</translation>
    </message>
    <message>
        <source>missed</source>
        <translation>gemist</translation>
    </message>
    <message>
        <source>turning</source>
        <translation>keren</translation>
    </message>
    <message>
        <source>Time by %1</source>
        <translation>Tijd bij %1</translation>
    </message>
    <message>
        <source>Directions of swaths and their times</source>
        <translation>Richtingen van werkgangen en hun tijden</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>%1 at least</source>
        <translation>minstens %1</translation>
    </message>
    <message>
        <source>Estimates for the land inside the headland, to and fro. The plan adds headland, short passes and ways.</source>
        <translation>Schattingen voor het land binnen de kopakker, heen en weer. Het plan bevat ook kopakker, korte werkgangen en ritten.</translation>
    </message>
    <message>
        <source>Let Furrow search the direction</source>
        <translation>Furrow de richting laten zoeken</translation>
    </message>
</context>
<context>
    <name>HelpCommands</name>
    <message>
        <source>Help</source>
        <translation>Help</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>Handleiding</translation>
    </message>
    <message>
        <source>help manual how to documentation</source>
        <translation>hulp handleiding documentatie hoe</translation>
    </message>
    <message>
        <source>Take the tour</source>
        <translation>Rondleiding starten</translation>
    </message>
    <message>
        <source>help introduction first start</source>
        <translation>help introductie eerste start</translation>
    </message>
    <message>
        <source>Keys and mouse</source>
        <translation>Toetsen en muis</translation>
    </message>
    <message>
        <source>shortcuts help</source>
        <translation>sneltoetsen hulp</translation>
    </message>
    <message>
        <source>Report a problem…</source>
        <translation>Een probleem melden…</translation>
    </message>
    <message>
        <source>bug crash support error</source>
        <translation>fout crash ondersteuning</translation>
    </message>
    <message>
        <source>About Furrow</source>
        <translation>Over Furrow</translation>
    </message>
    <message>
        <source>version licence credits</source>
        <translation>versie licentie dankwoord</translation>
    </message>
</context>
<context>
    <name>ImageryDialogs</name>
    <message>
        <source>All files (*)</source>
        <translation>Alle bestanden (*)</translation>
    </message>
    <message>
        <source>Add imagery</source>
        <translation>Luchtfoto toevoegen</translation>
    </message>
    <message>
        <source>Pictures and heights (%1)</source>
        <translation>Beelden en hoogten (%1)</translation>
    </message>
    <message>
        <source>Add a folder of tiles</source>
        <translation>Map met tegels toevoegen</translation>
    </message>
</context>
<context>
    <name>ImageryList</name>
    <message>
        <source>Your own pictures and heights: GeoTIFF, MBTiles or a folder of tiles. They stay on this computer.</source>
        <translation>Uw eigen beelden en hoogten: GeoTIFF, MBTiles of een map met tegels. Ze blijven op deze computer.</translation>
    </message>
    <message>
        <source>Add files…</source>
        <translation>Bestanden toevoegen…</translation>
    </message>
    <message>
        <source>Add a folder of tiles…</source>
        <translation>Map met tegels toevoegen…</translation>
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
        <translation>%1 helemaal tonen</translation>
    </message>
    <message>
        <source>Move %1 up</source>
        <translation>%1 omhoog</translation>
    </message>
    <message>
        <source>Move %1 down</source>
        <translation>%1 omlaag</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>%1 verwijderen</translation>
    </message>
    <message>
        <source>How strong %1 is</source>
        <translation>Dekking van %1</translation>
    </message>
    <message>
        <source>Opening …</source>
        <translation>Wordt geopend…</translation>
    </message>
    <message>
        <source>Contour lines every %1</source>
        <translation>Hoogtelijnen om de %1</translation>
    </message>
    <message>
        <source>Rows count from the south (TMS)</source>
        <translation>Rijen tellen vanaf het zuiden (TMS)</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Opnieuw proberen</translation>
    </message>
</context>
<context>
    <name>Inspector</name>
    <message>
        <source>Headland</source>
        <translation>Kopakker</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Naam</translation>
    </message>
    <message>
        <source>boundary</source>
        <translation>perceelsgrens</translation>
    </message>
    <message>
        <source>hole</source>
        <translation>gat</translation>
    </message>
    <message>
        <source>obstacle</source>
        <translation>obstakel</translation>
    </message>
    <message>
        <source>guidance line</source>
        <translation>stuurlijn</translation>
    </message>
    <message>
        <source>Point %1 of the %2</source>
        <translation>Punt %1 (%2)</translation>
    </message>
    <message>
        <source>Drag it on the map, move it by arrow keys, or type where it is.</source>
        <translation>Sleep het op de kaart, verplaats het met de pijltoetsen of typ waar het ligt.</translation>
    </message>
    <message>
        <source>Latitude</source>
        <translation>Breedtegraad</translation>
    </message>
    <message>
        <source>Longitude</source>
        <translation>Lengtegraad</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Hoek</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>AB line</source>
        <translation>AB-lijn</translation>
    </message>
    <message>
        <source>Edge %1 of the %2</source>
        <translation>Zijde %1 (%2)</translation>
    </message>
    <message>
        <source>One swath lies on it, the others beside it. Drag it or its ends, or type its direction.</source>
        <translation>Eén werkgang ligt erop, de andere ernaast. Sleep de lijn of de uiteinden, of typ de richting.</translation>
    </message>
    <message>
        <source>Drag it to move it sideways; the dot in its middle makes another point.</source>
        <translation>Slepen verplaatst hem zijwaarts; de stip in het midden maakt er een punt bij.</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Lengte</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richting</translation>
    </message>
    <message>
        <source>Obstacle</source>
        <translation>Obstakel</translation>
    </message>
    <message>
        <source>It is not worked, but may be driven on.</source>
        <translation>Het wordt niet bewerkt, maar er mag overheen gereden worden.</translation>
    </message>
    <message>
        <source>It is not worked, and nothing drives nearer than its buffer.</source>
        <translation>Het wordt niet bewerkt, en niets rijdt dichterbij dan de afstand.</translation>
    </message>
    <message>
        <source>Buffer</source>
        <translation>Afstand</translation>
    </message>
    <message>
        <source>Overhang</source>
        <translation>Overhang</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Oppervlakte</translation>
    </message>
    <message>
        <source>the end</source>
        <translation>einde</translation>
    </message>
    <message>
        <source>swath %1</source>
        <translation>werkgang %1</translation>
    </message>
    <message>
        <source>pass %1</source>
        <translation>kopakkergang %1</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tijd</translation>
    </message>
    <message>
        <source>Swath %1</source>
        <translation>Werkgang %1</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breedte</translation>
    </message>
    <message>
        <source>Headland pass %1</source>
        <translation>Kopakkergang %1</translation>
    </message>
    <message>
        <source>Counted from the outside; %1 are worked here in %2.</source>
        <translation>Van buitenaf geteld; %1 wordt hier in %2 bewerkt.</translation>
    </message>
    <message>
        <source>Turn from %1 to %2</source>
        <translation>Draai: %1 → %2</translation>
    </message>
    <message>
        <source>%1 in reverse, in %2.</source>
        <translation>%1 achteruit, in %2.</translation>
    </message>
    <message>
        <source>%1 with the implement up, in %2.</source>
        <translation>%1 met geheven werktuig, in %2.</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Soort</translation>
    </message>
    <message>
        <source>Way from %1 to %2</source>
        <translation>Verplaatsing: %1 → %2</translation>
    </message>
    <message>
        <source>%1 without working, in %2.</source>
        <translation>%1 zonder te werken, in %2.</translation>
    </message>
    <message>
        <source>It cannot be driven like this: %1.</source>
        <translation>Zo is het niet te rijden: %1.</translation>
    </message>
    <message>
        <source>Block %1</source>
        <translation>Deelperceel %1</translation>
    </message>
    <message numerus="yes">
        <source>A piece of the field whose %n swath(s) are driven together.</source>
        <translation>
            <numerusform>Een stuk van de binnenakker met %n werkgang.</numerusform>
            <numerusform>Een stuk van de binnenakker waarvan de %n werkgangen samen gereden worden.</numerusform>
        </translation>
    </message>
    <message>
        <source>Swaths</source>
        <translation>Werkgangen</translation>
    </message>
    <message>
        <source>Gate</source>
        <translation>Inrit</translation>
    </message>
    <message>
        <source>Here the machine may enter and leave the field. Drag it along the boundary.</source>
        <translation>Hier mag de machine het perceel in en uit. Sleep de inrit langs de perceelsgrens.</translation>
    </message>
    <message>
        <source>Guidance curve</source>
        <translation>Stuurcurve</translation>
    </message>
    <message>
        <source>The swaths lie beside it. Drag its points, or delete it.</source>
        <translation>De werkgangen liggen ernaast. Sleep de punten of verwijder de curve.</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punten</translation>
    </message>
    <message>
        <source>Hole</source>
        <translation>Gat</translation>
    </message>
    <message>
        <source>It is no part of the field. Drag it, or its points and edges.</source>
        <translation>Het hoort niet bij het perceel. Sleep het, of de punten en zijden.</translation>
    </message>
    <message>
        <source>split line</source>
        <translation>splitlijn</translation>
    </message>
    <message>
        <source>The field inside the headland is cut along it, where it runs right through. Drag it or its points, or delete it.</source>
        <translation>De binnenakker wordt erlangs gesplitst waar ze er helemaal doorheen loopt. Sleep de lijn of de punten, of verwijder ze.</translation>
    </message>
    <message>
        <source>Split line %1</source>
        <translation>Splitlijn %1</translation>
    </message>
    <message>
        <source>%1 with the implement folded, in %2.</source>
        <translation>%1 met opgeklapt werktuig, in %2.</translation>
    </message>
    <message>
        <source>Whole turn</source>
        <translation>Hele draai</translation>
    </message>
    <message>
        <source>Driven as number %1 of %2: %3 in %4.</source>
        <translation>Gereden als nummer %1 van %2: %3 in %4.</translation>
    </message>
    <message>
        <source>From the edge</source>
        <translation>Afstand tot de rand</translation>
    </message>
    <message>
        <source>Instead: %1</source>
        <translation>In plaats daarvan: %1</translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>ongeveer %1</translation>
    </message>
    <message>
        <source>no room</source>
        <translation>geen ruimte</translation>
    </message>
    <message>
        <source>In the bunker</source>
        <translation>In de bunker</translation>
    </message>
    <message>
        <source>In the tank</source>
        <translation>In de tank</translation>
    </message>
    <message>
        <source>Then stands</source>
        <translation>Staat daarna stil</translation>
    </message>
</context>
<context>
    <name>InspectorPanel</name>
    <message>
        <source>Headland as elsewhere</source>
        <translation>Kopakker zoals elders</translation>
    </message>
    <message>
        <source>selected</source>
        <translation>geselecteerd</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>May be driven on</source>
        <translation>Er mag overheen gereden worden</translation>
    </message>
    <message>
        <source>Swaths along it</source>
        <translation>Werkgangen hierlangs</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Verwijderen</translation>
    </message>
    <message>
        <source>Drive from here</source>
        <translation>Rijden vanaf hier</translation>
    </message>
</context>
<context>
    <name>KeysDialog</name>
    <message>
        <source>Drag the map, wheel</source>
        <translation>Kaart slepen, muiswiel</translation>
    </message>
    <message>
        <source>move, zoom</source>
        <translation>verplaatsen, zoomen</translation>
    </message>
    <message>
        <source>Arrows, + and −</source>
        <translation>Pijlen, + en −</translation>
    </message>
    <message>
        <source>move the selection or the map, zoom</source>
        <translation>de selectie of de kaart verplaatsen, zoomen</translation>
    </message>
    <message>
        <source>, and .</source>
        <translation>, en .</translation>
    </message>
    <message>
        <source>the point before, the next point</source>
        <translation>vorig, volgend punt</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Enter</translation>
    </message>
    <message>
        <source>finish drawing; type into the inspector</source>
        <translation>tekenen afsluiten; in de inspecteur typen</translation>
    </message>
    <message>
        <source>Alt</source>
        <translation>Alt</translation>
    </message>
    <message>
        <source>no snapping while it is held</source>
        <translation>niet vastklikken zolang ingedrukt</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>stop what was begun</source>
        <translation>stoppen waaraan begonnen is</translation>
    </message>
    <message>
        <source>Keys and mouse</source>
        <translation>Toetsen en muis</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Sluiten</translation>
    </message>
</context>
<context>
    <name>LayerSwitches</name>
    <message>
        <source>Boundary</source>
        <translation>Perceelsgrens</translation>
    </message>
    <message>
        <source>Headland</source>
        <translation>Kopakker</translation>
    </message>
    <message>
        <source>Swaths</source>
        <translation>Werkgangen</translation>
    </message>
    <message>
        <source>Order numbers</source>
        <translation>Volgnummers</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Bevindingen</translation>
    </message>
    <message>
        <source>Imagery</source>
        <translation>Luchtfoto</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Traject</translation>
    </message>
    <message>
        <source>Directions</source>
        <translation>Richtingen</translation>
    </message>
    <message>
        <source>Coverage</source>
        <translation>Bewerkt</translation>
    </message>
    <message>
        <source>Worked twice</source>
        <translation>Dubbel bewerkt</translation>
    </message>
    <message>
        <source>Missed</source>
        <translation>Gemiste plekken</translation>
    </message>
    <message>
        <source>Wheel passes</source>
        <translation>Wielsporen</translation>
    </message>
    <message>
        <source>Swath numbers</source>
        <translation>Werkgangnummers</translation>
    </message>
</context>
<context>
    <name>LayersPanel</name>
    <message>
        <source>Layers</source>
        <translation>Lagen</translation>
    </message>
    <message>
        <source>Close the layers</source>
        <translation>Lagen sluiten</translation>
    </message>
    <message>
        <source>Imagery</source>
        <translation>Luchtfoto</translation>
    </message>
    <message>
        <source>From the network</source>
        <translation>Van internet</translation>
    </message>
    <message>
        <source>OpenStreetMap</source>
        <translation>OpenStreetMap</translation>
    </message>
    <message>
        <source>Asks openstreetmap.org for what is in view. Off, nothing leaves this computer.</source>
        <translation>Vraagt openstreetmap.org om wat in beeld is. Uitgeschakeld verlaat niets deze computer.</translation>
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
        <translation>Terug naar origineel</translation>
    </message>
    <message>
        <source>Keep as your own…</source>
        <translation>Als eigen bewaren…</translation>
    </message>
    <message>
        <source>Remove from your own</source>
        <translation>Uit eigen machines halen</translation>
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
        <translation>Perceel hernoemen</translation>
    </message>
    <message>
        <source>Add a plan</source>
        <translation>Plan toevoegen</translation>
    </message>
    <message>
        <source>Rename the plan</source>
        <translation>Plan hernoemen</translation>
    </message>
    <message>
        <source>Add a plan to each field</source>
        <translation>Aan elk perceel een plan toevoegen</translation>
    </message>
    <message>
        <source>Keep as a variant</source>
        <translation>Als variant bewaren</translation>
    </message>
    <message>
        <source>Keep the machine as</source>
        <translation>Machine bewaren als</translation>
    </message>
    <message>
        <source>This plan: %1</source>
        <translation>Dit plan: %1</translation>
    </message>
</context>
<context>
    <name>MapPage</name>
    <message>
        <source>Map</source>
        <translation>Kaart</translation>
    </message>
</context>
<context>
    <name>MapToolBar</name>
    <message>
        <source>Select and change (V)</source>
        <translation>Selecteren en wijzigen (V)</translation>
    </message>
    <message>
        <source>Draw a field (B)</source>
        <translation>Perceel tekenen (B)</translation>
    </message>
    <message>
        <source>Draw a hole (H)</source>
        <translation>Gat tekenen (H)</translation>
    </message>
    <message>
        <source>Draw an obstacle (O)</source>
        <translation>Obstakel tekenen (O)</translation>
    </message>
    <message>
        <source>Draw an AB line (L)</source>
        <translation>AB-lijn tekenen (L)</translation>
    </message>
    <message>
        <source>Add a gate (G)</source>
        <translation>Inrit toevoegen (G)</translation>
    </message>
    <message>
        <source>Show the whole field (F)</source>
        <translation>Heel perceel tonen (F)</translation>
    </message>
    <message>
        <source>Closer (+)</source>
        <translation>Inzoomen (+)</translation>
    </message>
    <message>
        <source>Further away (−)</source>
        <translation>Uitzoomen (−)</translation>
    </message>
    <message>
        <source>Layers (Ctrl+L)</source>
        <translation>Lagen (Ctrl+L)</translation>
    </message>
    <message>
        <source>Draw a split line (S)</source>
        <translation>Splitlijn tekenen (S)</translation>
    </message>
</context>
<context>
    <name>NameDialog</name>
    <message>
        <source>Name</source>
        <translation>Naam</translation>
    </message>
    <message>
        <source>Season</source>
        <translation>Seizoen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuleren</translation>
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
        <translation>© OpenStreetMap-bijdragers</translation>
    </message>
</context>
<context>
    <name>OrderEditor</name>
    <message>
        <source>Change the order by hand…</source>
        <translation>Volgorde met de hand wijzigen…</translation>
    </message>
    <message>
        <source>Drag a swath to its new place. Or click swaths on the map: each is driven after the one clicked before.</source>
        <translation>Sleep een werkgang naar zijn nieuwe plaats. Of klik werkgangen op de kaart aan: elke volgt op de vorige.</translation>
    </message>
    <message>
        <source>Order of swaths</source>
        <translation>Volgorde van werkgangen</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Klaar</translation>
    </message>
    <message>
        <source>Search the order of the others</source>
        <translation>Volgorde van de andere zoeken</translation>
    </message>
    <message>
        <source>Search the order again</source>
        <translation>Volgorde opnieuw zoeken</translation>
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
        <translation>%1. Werkgang %2, %3</translation>
    </message>
    <message>
        <source>Swath %1</source>
        <translation>Werkgang %1</translation>
    </message>
    <message>
        <source>Drive swath %1 the other way</source>
        <translation>Werkgang %1 andersom rijden</translation>
    </message>
</context>
<context>
    <name>OtherMap</name>
    <message>
        <source>Map of the other plan: %1</source>
        <translation>Kaart van het andere plan: %1</translation>
    </message>
    <message>
        <source>The other plan is being made …</source>
        <translation>Het andere plan wordt gemaakt…</translation>
    </message>
    <message>
        <source>The other: %1</source>
        <translation>Het andere: %1</translation>
    </message>
</context>
<context>
    <name>PageList</name>
    <message>
        <source>Pages</source>
        <translation>Pagina&apos;s</translation>
    </message>
    <message>
        <source>Page %1 of %2</source>
        <translation>Pagina %1 van %2</translation>
    </message>
    <message>
        <source>Planning for the pages …</source>
        <translation>Er wordt gepland voor de pagina&apos;s…</translation>
    </message>
    <message>
        <source>Stopped before there were pages.</source>
        <translation>Gestopt voordat er pagina&apos;s waren.</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Opnieuw proberen</translation>
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
        <translation>%1: Furrow laten kiezen</translation>
    </message>
    <message>
        <source>as text</source>
        <translation>als tekst</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Kiezen…</translation>
    </message>
    <message>
        <source>On the map</source>
        <translation>Op de kaart</translation>
    </message>
    <message>
        <source>As text</source>
        <translation>Als tekst</translation>
    </message>
    <message>
        <source>%1 as text</source>
        <translation>%1 als tekst</translation>
    </message>
    <message>
        <source>not chosen</source>
        <translation>niet gekozen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Verwijderen</translation>
    </message>
    <message>
        <source>%1: remove</source>
        <translation>%1: verwijderen</translation>
    </message>
</context>
<context>
    <name>Pickers</name>
    <message>
        <source>Click the place on the map. Esc ends it.</source>
        <translation>Klik de plek op de kaart aan. Esc beëindigt het.</translation>
    </message>
    <message>
        <source>Click the places on the map</source>
        <translation>Klik de plaatsen op de kaart aan</translation>
    </message>
    <message>
        <source>Click another place, or one of them to remove it</source>
        <translation>Klik nog een plaats aan, of een ervan om die te verwijderen</translation>
    </message>
</context>
<context>
    <name>PlacesPicker</name>
    <message>
        <source>Place %1: remove it</source>
        <translation>Plaats %1: verwijderen</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Klaar</translation>
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
        <translation>Afrijden</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>Beoordeling</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Bevindingen</translation>
    </message>
    <message>
        <source>Add a plan…</source>
        <translation>Plan toevoegen…</translation>
    </message>
    <message>
        <source>season operation copy</source>
        <translation>seizoen bewerking kopie</translation>
    </message>
    <message>
        <source>Compare with another plan</source>
        <translation>Met een ander plan vergelijken</translation>
    </message>
    <message>
        <source>compare variants differences side by side better</source>
        <translation>vergelijken varianten verschillen naast elkaar beter</translation>
    </message>
    <message>
        <source>Compare on two maps</source>
        <translation>Op twee kaarten vergelijken</translation>
    </message>
    <message>
        <source>compare side by side split map</source>
        <translation>vergelijken naast elkaar gedeelde kaart twee</translation>
    </message>
    <message>
        <source>Compare with a recorded track…</source>
        <translation>Met een opgenomen rit vergelijken…</translation>
    </message>
    <message>
        <source>driven recorded GPX NMEA log cross-track error compare</source>
        <translation>gereden opgenomen GPX NMEA afwijking vergelijken</translation>
    </message>
    <message>
        <source>Rename the plan…</source>
        <translation>Plan hernoemen…</translation>
    </message>
    <message>
        <source>Remove the plan</source>
        <translation>Plan verwijderen</translation>
    </message>
    <message>
        <source>delete</source>
        <translation>wissen</translation>
    </message>
    <message>
        <source>Plan again</source>
        <translation>Opnieuw plannen</translation>
    </message>
    <message>
        <source>Find the best plan…</source>
        <translation>Beste plan zoeken…</translation>
    </message>
    <message>
        <source>quickest optimise compare alternatives</source>
        <translation>snelste optimaliseren vergelijken alternatieven</translation>
    </message>
    <message>
        <source>Change the order by hand…</source>
        <translation>Volgorde met de hand wijzigen…</translation>
    </message>
    <message>
        <source>order swaths list drag sequence</source>
        <translation>volgorde werkgangen lijst slepen</translation>
    </message>
    <message>
        <source>Drive through the plan</source>
        <translation>Plan afrijden</translation>
    </message>
    <message>
        <source>Pause the drive</source>
        <translation>Rit pauzeren</translation>
    </message>
    <message>
        <source>drive play pause simulate machine</source>
        <translation>rijden afspelen pauze simuleren machine</translation>
    </message>
    <message>
        <source>Drive from what is selected</source>
        <translation>Rijden vanaf de selectie</translation>
    </message>
    <message>
        <source>drive play here swath turn</source>
        <translation>rijden afspelen hier werkgang draai keren</translation>
    </message>
    <message>
        <source>Drive faster</source>
        <translation>Sneller rijden</translation>
    </message>
    <message>
        <source>pace speed</source>
        <translation>tempo snelheid</translation>
    </message>
    <message>
        <source>Drive slower</source>
        <translation>Langzamer rijden</translation>
    </message>
    <message>
        <source>Comment on a place…</source>
        <translation>Opmerking bij een plek…</translation>
    </message>
    <message>
        <source>review note remark pin</source>
        <translation>beoordeling notitie opmerking plek</translation>
    </message>
    <message>
        <source>Comment on the whole plan…</source>
        <translation>Opmerking bij het hele plan…</translation>
    </message>
    <message>
        <source>review note remark</source>
        <translation>beoordeling notitie opmerking</translation>
    </message>
    <message>
        <source>contractor share file approve</source>
        <translation>loonwerker delen bestand goedkeuren</translation>
    </message>
    <message>
        <source>Take in a review that came back…</source>
        <translation>Teruggekomen beoordeling overnemen…</translation>
    </message>
    <message>
        <source>merge comments contractor</source>
        <translation>samenvoegen opmerkingen loonwerker</translation>
    </message>
    <message>
        <source>Next finding</source>
        <translation>Volgende bevinding</translation>
    </message>
    <message>
        <source>problem check step through</source>
        <translation>probleem controle doorlopen</translation>
    </message>
    <message>
        <source>Previous finding</source>
        <translation>Vorige bevinding</translation>
    </message>
    <message>
        <source>problem check step back</source>
        <translation>probleem controle terug</translation>
    </message>
    <message>
        <source>Next finding of the same kind</source>
        <translation>Volgende bevinding van dezelfde soort</translation>
    </message>
    <message>
        <source>Previous finding of the same kind</source>
        <translation>Vorige bevinding van dezelfde soort</translation>
    </message>
</context>
<context>
    <name>PlanTitle</name>
    <message>
        <source>%1 wide</source>
        <translation>%1 breed</translation>
    </message>
    <message>
        <source>takes %1</source>
        <translation>duurt %1</translation>
    </message>
    <message>
        <source>planned %1</source>
        <translation>gepland %1</translation>
    </message>
</context>
<context>
    <name>Planner</name>
    <message>
        <source> and twice %1 of margin</source>
        <translation> en tweemaal %1 marge</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 en %2</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 en nog %2</translation>
    </message>
    <message>
        <source>%1 are driven in reverse; the trailed implement cannot.</source>
        <translation>%1 wordt achteruit gereden; het getrokken werktuig kan dat niet.</translation>
    </message>
    <message>
        <source>%1 are driven in reverse; this machine cannot.</source>
        <translation>%1 wordt achteruit gereden; deze machine kan dat niet.</translation>
    </message>
    <message>
        <source>%1 are not worked, %2 of the field, in %3; this is the largest.</source>
        <translation>%1 wordt niet bewerkt, %2 van het perceel, in %3; dit is de grootste gemiste plek.</translation>
    </message>
    <message>
        <source>%1 bends with a radius of %2; this machine needs %3.</source>
        <translation>%1 heeft bochten met een straal van %2; deze machine heeft %3 nodig.</translation>
    </message>
    <message>
        <source>%1 cannot be driven: %2.</source>
        <translation>%1 is niet te rijden: %2.</translation>
    </message>
    <message>
        <source>%1 cannot be made: %2</source>
        <translation>%1 kan niet gemaakt worden: %2</translation>
    </message>
    <message>
        <source>%1 crosses an obstacle, by %2.</source>
        <translation>%1 gaat %2 over een obstakel.</translation>
    </message>
    <message>
        <source>%1 crosses an obstacle.</source>
        <translation>%1 gaat over een obstakel.</translation>
    </message>
    <message>
        <source>%1 does not fit here</source>
        <translation>%1 past hier niet</translation>
    </message>
    <message>
        <source>%1 for transport is wider than the machine at work, %2</source>
        <translation>%1 voor transport is breder dan de machine aan het werk, %2</translation>
    </message>
    <message>
        <source>%1 holds no positions</source>
        <translation>%1 bevat geen posities</translation>
    </message>
    <message>
        <source>%1 in one piece are not worked.</source>
        <translation>%1 aan één stuk wordt niet bewerkt.</translation>
    </message>
    <message>
        <source>%1 is %2 wide; this machine is %3 wide for transport.</source>
        <translation>%1 is %2 breed; deze machine is voor transport %3 breed.</translation>
    </message>
    <message>
        <source>%1 is not a whole number</source>
        <translation>%1 is geen heel getal</translation>
    </message>
    <message>
        <source>%1 is on the stick already</source>
        <translation>%1 staat al op de stick</translation>
    </message>
    <message>
        <source>%1 is out of range</source>
        <translation>%1 valt buiten het bereik</translation>
    </message>
    <message>
        <source>%1 is planned, but nothing of it is driven with the implement down.</source>
        <translation>%1 is gepland, maar niets ervan wordt met neergelaten werktuig gereden.</translation>
    </message>
    <message>
        <source>%1 is planned, but only %2 of it is driven with the implement down.</source>
        <translation>%1 is gepland, maar slechts %2 ervan wordt met neergelaten werktuig gereden.</translation>
    </message>
    <message>
        <source>%1 jumps by %2.</source>
        <translation>%1 verspringt %2.</translation>
    </message>
    <message>
        <source>%1 leads from one part of the field to another that this machine cannot drive to.</source>
        <translation>%1 leidt van het ene deel van het perceel naar een ander deel dat deze machine niet kan bereiken.</translation>
    </message>
    <message>
        <source>%1 leaves the field by %2.</source>
        <translation>%1 komt %2 buiten het perceel.</translation>
    </message>
    <message>
        <source>%1 leaves the field or crosses an obstacle, by up to %2, as this plan allows.</source>
        <translation>%1 komt buiten het perceel of gaat over een obstakel, tot %2, zoals dit plan toestaat.</translation>
    </message>
    <message>
        <source>%1 moves %2 off where the machine points.</source>
        <translation>%1 wijkt %2 af van de richting waarin de machine wijst.</translation>
    </message>
    <message>
        <source>%1 needs %2</source>
        <translation>%1 heeft nodig: %2</translation>
    </message>
    <message>
        <source>%1 of %2 guidance lines of &apos;%3&apos; are there</source>
        <translation>%1 van %2 stuurlijnen van ‘%3’ zijn er</translation>
    </message>
    <message>
        <source>%1 of %2 swaths are not in the order: %3</source>
        <translation>%1 van %2 werkgangen ontbreken in de volgorde: %3</translation>
    </message>
    <message>
        <source>%1 of %2 tracks are of another place and were left out</source>
        <translation>%1 van %2 ritten zijn van een andere plek en zijn weggelaten</translation>
    </message>
    <message>
        <source>%1 of its sentences have a wrong checksum</source>
        <translation>%1 van de zinnen erin hebben een verkeerde controlesom</translation>
    </message>
    <message>
        <source>%1 of margin leaves nothing of the field to work</source>
        <translation>%1 marge laat niets van het perceel over om te bewerken</translation>
    </message>
    <message>
        <source>%1 of the positions jump away and back</source>
        <translation>%1 van de posities springen weg en weer terug</translation>
    </message>
    <message>
        <source>%1 reads back other bytes than were written</source>
        <translation>%1 levert andere bytes terug dan er geschreven zijn</translation>
    </message>
    <message>
        <source>%1 small patches of worked pixels are left out</source>
        <translation>%1 kleine vlekken bewerkte pixels zijn weggelaten</translation>
    </message>
    <message>
        <source>%1 swaths and turns leave the field or cross an obstacle, by up to %2, as this plan allows.</source>
        <translation>%1 werkgangen en draaien komen buiten het perceel of gaan over een obstakel, tot %2, zoals dit plan toestaat.</translation>
    </message>
    <message>
        <source>%1, %2 is more than 1,000 km from the plan</source>
        <translation>%1, %2 ligt meer dan 1.000 km van het plan</translation>
    </message>
    <message>
        <source>%1, %2 is no longitude and latitude</source>
        <translation>%1, %2 is geen lengte- en breedtegraad</translation>
    </message>
    <message>
        <source>%1, %2 is no longitude and latitude, and the file does not say which coordinate system it uses</source>
        <translation>%1, %2 is geen lengte- en breedtegraad, en het bestand zegt niet welk coördinatenstelsel het gebruikt</translation>
    </message>
    <message>
        <source>%1, %2 is outside longitude -180 to 180 and latitude -90 to 90</source>
        <translation>%1, %2 ligt buiten de lengtegraden -180 tot 180 en breedtegraden -90 tot 90</translation>
    </message>
    <message>
        <source>%1, %2, line %3</source>
        <translation>%1, %2, regel %3</translation>
    </message>
    <message>
        <source>%1, %2, point %3</source>
        <translation>%1, %2, punt %3</translation>
    </message>
    <message>
        <source>%1, byte %2</source>
        <translation>%1, byte %2</translation>
    </message>
    <message>
        <source>%1, feature %2</source>
        <translation>%1, object %2</translation>
    </message>
    <message>
        <source>%1, gate %2</source>
        <translation>%1, inrit %2</translation>
    </message>
    <message>
        <source>%1, hole %2</source>
        <translation>%1, gat %2</translation>
    </message>
    <message>
        <source>%1, line %2</source>
        <translation>%1, regel %2</translation>
    </message>
    <message>
        <source>%1, obstacle %2</source>
        <translation>%1, obstakel %2</translation>
    </message>
    <message>
        <source>%1, point %2</source>
        <translation>%1, punt %2</translation>
    </message>
    <message>
        <source>%1, row %2</source>
        <translation>%1, rij %2</translation>
    </message>
    <message>
        <source>%1.bin is not there</source>
        <translation>%1.bin ontbreekt</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: the setting %2 is not used: %3</source>
        <translation>%1: de instelling %2 wordt niet gebruikt: %3</translation>
    </message>
    <message>
        <source>%1; %2 × other turns</source>
        <translation>%1; %2 × andere wendingen</translation>
    </message>
    <message>
        <source>%1; what it belongs to was left out</source>
        <translation>%1; waar het bij hoort is weggelaten</translation>
    </message>
    <message numerus="yes">
        <source>%n areas are neither field, hole nor obstacle by their layer or kind and were not used</source>
        <translation>
            <numerusform>%n vlak is volgens laag of soort geen perceel, gat of obstakel en is niet gebruikt</numerusform>
            <numerusform>%n vlakken zijn volgens laag of soort geen perceel, gat of obstakel en zijn niet gebruikt</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n areas in the file are neither field nor obstacle and were not used</source>
        <translation>
            <numerusform>%n vlak in het bestand is geen perceel en geen obstakel en is niet gebruikt</numerusform>
            <numerusform>%n vlakken in het bestand zijn geen perceel en geen obstakel en zijn niet gebruikt</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n damaged lines were passed over</source>
        <translation>
            <numerusform>%n beschadigde regel is overgeslagen</numerusform>
            <numerusform>%n beschadigde regels zijn overgeslagen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n entries without a shape</source>
        <translation>
            <numerusform>%n item zonder vorm</numerusform>
            <numerusform>%n items zonder vorm</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n fields</source>
        <translation>
            <numerusform>%n perceel</numerusform>
            <numerusform>%n percelen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n messages without a position were passed over</source>
        <translation>
            <numerusform>%n bericht zonder positie is overgeslagen</numerusform>
            <numerusform>%n berichten zonder positie zijn overgeslagen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n open lines</source>
        <translation>
            <numerusform>%n open lijn</numerusform>
            <numerusform>%n open lijnen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n passes</source>
        <translation>
            <numerusform>%n gang</numerusform>
            <numerusform>%n gangen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pieces</source>
        <translation>
            <numerusform>%n stuk</numerusform>
            <numerusform>%n stukken</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n places</source>
        <translation>
            <numerusform>%n plek</numerusform>
            <numerusform>%n plekken</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n points</source>
        <translation>
            <numerusform>%n punt</numerusform>
            <numerusform>%n punten</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n points were given twice and taken once</source>
        <translation>
            <numerusform>%n punt was dubbel en telt één keer</numerusform>
            <numerusform>%n punten waren dubbel en tellen één keer</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n positions that jumped away were left out</source>
        <translation>
            <numerusform>%n positie die wegsprong is weggelaten</numerusform>
            <numerusform>%n posities die wegsprongen zijn weggelaten</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n records without a position were passed over</source>
        <translation>
            <numerusform>%n record zonder positie is overgeslagen</numerusform>
            <numerusform>%n records zonder positie zijn overgeslagen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n reports without a position were passed over</source>
        <translation>
            <numerusform>%n melding zonder positie is overgeslagen</numerusform>
            <numerusform>%n meldingen zonder positie zijn overgeslagen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n rings did not end where they began and were closed</source>
        <translation>
            <numerusform>%n ring eindigde niet waar hij begon en is gesloten</numerusform>
            <numerusform>%n ringen eindigden niet waar ze begonnen en zijn gesloten</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n rings ran the wrong way round and were turned</source>
        <translation>
            <numerusform>%n ring liep verkeerd om en is omgekeerd</numerusform>
            <numerusform>%n ringen liepen verkeerd om en zijn omgekeerd</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n rows without a position were passed over</source>
        <translation>
            <numerusform>%n rij zonder positie is overgeslagen</numerusform>
            <numerusform>%n rijen zonder positie zijn overgeslagen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sentences with a wrong checksum were passed over</source>
        <translation>
            <numerusform>%n zin met een verkeerde controlesom is overgeslagen</numerusform>
            <numerusform>%n zinnen met een verkeerde controlesom zijn overgeslagen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sentences without a position were passed over</source>
        <translation>
            <numerusform>%n zin zonder positie is overgeslagen</numerusform>
            <numerusform>%n zinnen zonder positie zijn overgeslagen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n spikes without area were removed</source>
        <translation>
            <numerusform>%n uitsteeksel zonder oppervlakte is verwijderd</numerusform>
            <numerusform>%n uitsteeksels zonder oppervlakte zijn verwijderd</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n stretches of one strip were left out, as ways to the field: %1 together</source>
        <translation>
            <numerusform>%n stuk van één strook is weggelaten, als weg naar het perceel: %1</numerusform>
            <numerusform>%n stukken van één strook zijn weggelaten, als wegen naar het perceel: samen %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n turns</source>
        <translation>
            <numerusform>%n draai</numerusform>
            <numerusform>%n draaien</numerusform>
        </translation>
    </message>
    <message>
        <source>&apos;%1&apos; files hold no recorded track</source>
        <translation>&apos;%1&apos;-bestanden bevatten geen opgenomen rit</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is left out: its kind %2 is not known</source>
        <translation>‘%1’ is weggelaten: soort %2 is niet bekend</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no length</source>
        <translation>‘%1’ is geen lengte</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no local frame</source>
        <translation>‘%1’ is geen lokaal coördinatenstelsel</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not %2</source>
        <translation>‘%1’ is niet: %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a line</source>
        <translation>‘%1’ is geen lijn</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not well-known text</source>
        <translation>‘%1’ is geen well-known text</translation>
    </message>
    <message>
        <source>&apos;%1&apos;, &apos;%2&apos; is no latitude and longitude</source>
        <translation>‘%1’, ‘%2’ is geen breedte- en lengtegraad</translation>
    </message>
    <message>
        <source>&apos;%1&apos;, &apos;%2&apos; is no longitude and latitude</source>
        <translation>‘%1’, ‘%2’ is geen lengte- en breedtegraad</translation>
    </message>
    <message>
        <source>&apos;%1&apos;, &apos;%2&apos; is no position</source>
        <translation>&apos;%1&apos;, &apos;%2&apos; is geen positie</translation>
    </message>
    <message>
        <source>A and B are %1 apart</source>
        <translation>A en B liggen %1 uit elkaar</translation>
    </message>
    <message>
        <source>A bulb to both sides; for swaths nearer than two turning radii.</source>
        <translation>Naar beide kanten uitgebogen; voor werkgangen dichterbij dan twee draaistralen.</translation>
    </message>
    <message>
        <source>A bulb to one side and straight back; for swaths nearer than two turning radii.</source>
        <translation>Naar één kant uitgebogen en recht terug; voor werkgangen dichterbij dan twee draaistralen.</translation>
    </message>
    <message>
        <source>A block gets a heading of its own where that saves time.</source>
        <translation>Een deelperceel krijgt een eigen rijrichting waar dat tijd spaart.</translation>
    </message>
    <message>
        <source>A file of lines: planted rows, or the tramlines of a plan.</source>
        <translation>Een bestand met lijnen: geplante rijen, of de spuitsporen van een plan.</translation>
    </message>
    <message>
        <source>A gate&apos;s name or a point; the first gate where nothing is given.</source>
        <translation>Naam van een inrit of een punt; de eerste inrit waar niets opgegeven is.</translation>
    </message>
    <message>
        <source>A goal of opennav_coverage has one outline: %1 of %2 parts are left out.</source>
        <translation>Een doel van opennav_coverage heeft één omtrek: %1 van %2 delen zijn weggelaten.</translation>
    </message>
    <message>
        <source>A raster of heights in metres that covers the field, such as a GeoTIFF.</source>
        <translation>Een raster van hoogten in meters dat het perceel dekt, zoals een GeoTIFF.</translation>
    </message>
    <message>
        <source>A robot with ROS 2</source>
        <translation>Een robot met ROS 2</translation>
    </message>
    <message>
        <source>A snake within each cluster of swaths, cluster after cluster.</source>
        <translation>Een slang binnen elke groep werkgangen, groep na groep.</translation>
    </message>
    <message>
        <source>A strip of the same width along the boundary and around obstacles, for turning.</source>
        <translation>Een strook van gelijke breedte langs de perceelsgrens en rond obstakels, om te keren.</translation>
    </message>
    <message>
        <source>A+</source>
        <translation>A+</translation>
    </message>
    <message>
        <source>AB curve</source>
        <translation>AB-curve</translation>
    </message>
    <message>
        <source>AB line</source>
        <translation>AB-lijn</translation>
    </message>
    <message>
        <source>Across the slope: beside a line of equal height, and a new one where that no longer fits.</source>
        <translation>Dwars op de helling: naast een hoogtelijn, en een nieuwe waar dat niet meer past.</translation>
    </message>
    <message>
        <source>After the swaths</source>
        <translation>Na de werkgangen</translation>
    </message>
    <message>
        <source>AgBot</source>
        <translation>AgBot</translation>
    </message>
    <message>
        <source>AgGPS folder</source>
        <translation>AgGPS-map</translation>
    </message>
    <message>
        <source>AgOpenGPS 6, import of ISOXML</source>
        <translation>AgOpenGPS 6, import van ISOXML</translation>
    </message>
    <message>
        <source>AgOpenGPS drives recorded paths forwards only, and this one reverses %1 times: its %2 forward stretches are &apos;Part 01.rec&apos; and so on, RecPath.txt is the first; %3 under 5 m are left out.</source>
        <translation>AgOpenGPS rijdt opgenomen paden alleen vooruit, en dit pad gaat %1 keer achteruit: de %2 stukken vooruit zijn ‘Part 01.rec’ enzovoort, RecPath.txt is het eerste; %3 onder 5 m zijn weggelaten.</translation>
    </message>
    <message>
        <source>AgOpenGPS field</source>
        <translation>AgOpenGPS-perceel</translation>
    </message>
    <message>
        <source>AgOpenGPS keeps one outline to a field: the %1 parts of &apos;%2&apos; are fields of their own, and the whole path is in the first.</source>
        <translation>AgOpenGPS kent één omtrek per perceel: de %1 delen van ‘%2’ zijn aparte percelen, en het hele traject zit in het eerste.</translation>
    </message>
    <message>
        <source>AgOpenGPS keeps one outline to a field: the %1 parts of &apos;%2&apos; are fields of their own.</source>
        <translation>AgOpenGPS kent één omtrek per perceel: de %1 delen van ‘%2’ zijn aparte percelen.</translation>
    </message>
    <message>
        <source>All swaths along the edge of the boundary that you pick.</source>
        <translation>Alle werkgangen langs de gekozen zijde van de perceelsgrens.</translation>
    </message>
    <message>
        <source>All swaths along the longest straight edge inside the headland.</source>
        <translation>Alle werkgangen langs de langste rechte zijde van de binnenakker.</translation>
    </message>
    <message>
        <source>All swaths in the direction that you type.</source>
        <translation>Alle werkgangen in de getypte richting.</translation>
    </message>
    <message>
        <source>Along an edge</source>
        <translation>Langs een zijde</translation>
    </message>
    <message>
        <source>Along each edge as wide as the turns there need it; a single pass where no swath ends, or nothing if it is not worked.</source>
        <translation>Langs elke zijde zo breed als daar nodig is om te keren; één kopakkergang waar geen werkgang eindigt, of niets als de kopakker niet wordt bewerkt.</translation>
    </message>
    <message>
        <source>Along rows that are there already, or between them.</source>
        <translation>Langs rijen die er al zijn, of ertussen.</translation>
    </message>
    <message>
        <source>Along the boundary</source>
        <translation>Langs de perceelsgrens</translation>
    </message>
    <message>
        <source>Along the contours</source>
        <translation>Langs de hoogtelijnen</translation>
    </message>
    <message>
        <source>Along the direction of travel.</source>
        <translation>In de rijrichting.</translation>
    </message>
    <message>
        <source>Along the headland</source>
        <translation>Over de kopakker</translation>
    </message>
    <message>
        <source>Along the line from A to B; one swath lies on it.</source>
        <translation>Langs de lijn van A naar B; één werkgang ligt erop.</translation>
    </message>
    <message>
        <source>Along the longest edge</source>
        <translation>Langs de langste zijde</translation>
    </message>
    <message>
        <source>An older ISOBUS terminal</source>
        <translation>Een oudere ISOBUS-terminal</translation>
    </message>
    <message>
        <source>Another ISOBUS terminal</source>
        <translation>Een andere ISOBUS-terminal</translation>
    </message>
    <message>
        <source>Anywhere</source>
        <translation>Overal</translation>
    </message>
    <message>
        <source>Arc, straight, arc; for swaths at least two turning radii apart.</source>
        <translation>Boog, recht, boog; voor werkgangen minstens twee draaistralen uit elkaar.</translation>
    </message>
    <message>
        <source>Choose the best that fits, which takes the quickest everywhere.</source>
        <translation>Kies de beste die past: die neemt overal de snelste.</translation>
    </message>
    <message>
        <source>Joined where that is quicker</source>
        <translation>Samengevoegd waar dat sneller is</translation>
    </message>
    <message>
        <source>As few swaths, and so turns, as possible.</source>
        <translation>Zo weinig mogelijk werkgangen, en dus draaien.</translation>
    </message>
    <message>
        <source>At obstacles</source>
        <translation>Bij obstakels</translation>
    </message>
    <message>
        <source>At the left edge</source>
        <translation>Aan de linkerrand</translation>
    </message>
    <message>
        <source>At the right edge</source>
        <translation>Aan de rechterrand</translation>
    </message>
    <message>
        <source>At the start of the first swath.</source>
        <translation>Aan het begin van de eerste werkgang.</translation>
    </message>
    <message>
        <source>Before the swaths</source>
        <translation>Vóór de werkgangen</translation>
    </message>
    <message>
        <source>Beside a curve of your own, or beside the edges around the one that you pick.</source>
        <translation>Naast een eigen curve, of naast de zijden rond de gekozen zijde.</translation>
    </message>
    <message>
        <source>Best heading</source>
        <translation>Beste rijrichting</translation>
    </message>
    <message>
        <source>Best of all headings</source>
        <translation>Beste van alle richtingen</translation>
    </message>
    <message>
        <source>Best that fits</source>
        <translation>Beste die past</translation>
    </message>
    <message>
        <source>Between the fixed and the steered axle.</source>
        <translation>Tussen de vaste en de gestuurde as.</translation>
    </message>
    <message>
        <source>Between the headings that are tried.</source>
        <translation>Tussen de richtingen die geprobeerd worden.</translation>
    </message>
    <message>
        <source>Between the rows</source>
        <translation>Tussen de rijen</translation>
    </message>
    <message>
        <source>Boundaries in longitude and latitude.</source>
        <translation>Perceelsgrenzen in lengte- en breedtegraden.</translation>
    </message>
    <message>
        <source>Boundaries, also field files of Fields2Cover and GAOS.</source>
        <translation>Perceelsgrenzen, ook perceelbestanden van Fields2Cover en GAOS.</translation>
    </message>
    <message>
        <source>Boundaries.</source>
        <translation>Perceelsgrenzen.</translation>
    </message>
    <message>
        <source>Boundary and guidance lines for Trimble and FM displays; no driving order.</source>
        <translation>Perceelsgrens en stuurlijnen voor Trimble- en FM-displays; geen rijvolgorde.</translation>
    </message>
    <message>
        <source>Boundary, headland, heading and order; the robot lays swaths and turns itself.</source>
        <translation>Perceelsgrens, kopakker, rijrichting en volgorde; de robot legt werkgangen en draaien zelf.</translation>
    </message>
    <message>
        <source>Boundary, holes, headland, guidance lines, and the whole driven path as a recorded path.</source>
        <translation>Perceelsgrens, gaten, kopakker, stuurlijnen en het hele gereden traject als opgenomen pad.</translation>
    </message>
    <message>
        <source>Boundary, holes, obstacles and guidance lines for older terminals; no headland, no driving order.</source>
        <translation>Perceelsgrens, gaten, obstakels en stuurlijnen voor oudere terminals; geen kopakker, geen rijvolgorde.</translation>
    </message>
    <message>
        <source>Boundary, holes, obstacles, gates, headland and guidance lines for terminals; no driving order.</source>
        <translation>Perceelsgrens, gaten, obstakels, inritten, kopakker en stuurlijnen voor terminals; geen rijvolgorde.</translation>
    </message>
    <message>
        <source>Boundary, holes, obstacles, headland, swaths and path in metres of the UTM zone.</source>
        <translation>Perceelsgrens, gaten, obstakels, kopakker, werkgangen en traject in meters van de UTM-zone.</translation>
    </message>
    <message>
        <source>Boundary, obstacles, gates, headland, swaths and path, to look at.</source>
        <translation>Perceelsgrens, obstakels, inritten, kopakker, werkgangen en traject, om te bekijken.</translation>
    </message>
    <message>
        <source>Boundary, obstacles, gates, headland, swaths, path and findings; for maps and programs.</source>
        <translation>Perceelsgrens, obstakels, inritten, kopakker, werkgangen, traject en bevindingen; voor kaarten en programma&apos;s.</translation>
    </message>
    <message>
        <source>Boundary, obstacles, gates, inside of the headland, swaths and path as layers for a GIS.</source>
        <translation>Perceelsgrens, obstakels, inritten, binnenakker, werkgangen en traject als lagen voor een GIS.</translation>
    </message>
    <message>
        <source>Boundary, obstacles, gates, inside of the headland, swaths and path, a shapefile of each.</source>
        <translation>Perceelsgrens, obstakels, inritten, binnenakker, werkgangen en traject, elk een shapefile.</translation>
    </message>
    <message>
        <source>Bringing the crop in: headland first, swaths overlap a little.</source>
        <translation>De oogst binnenhalen: kopakker eerst, werkgangen overlappen iets.</translation>
    </message>
    <message>
        <source>CSV table</source>
        <translation>CSV-tabel</translation>
    </message>
    <message>
        <source>Can reverse</source>
        <translation>Kan achteruitrijden</translation>
    </message>
    <message>
        <source>Can turn in place</source>
        <translation>Kan op de plaats draaien</translation>
    </message>
    <message>
        <source>Carried by the tractor, or pulled on a hitch and following its own track.</source>
        <translation>Door de trekker gedragen, of getrokken aan een koppelpunt met een eigen spoor.</translation>
    </message>
    <message>
        <source>Blocks</source>
        <translation>Deelpercelen</translation>
    </message>
    <message>
        <source>Centre line</source>
        <translation>Middellijn</translation>
    </message>
    <message>
        <source>Check that the machine stays inside the field while it turns.</source>
        <translation>Controleren of de machine bij het keren binnen het perceel blijft.</translation>
    </message>
    <message>
        <source>Choose another place.</source>
        <translation>Kies een andere plek.</translation>
    </message>
    <message>
        <source>Circles</source>
        <translation>Cirkels</translation>
    </message>
    <message>
        <source>Clockwise</source>
        <translation>Met de klok mee</translation>
    </message>
    <message>
        <source>Cluster</source>
        <translation>Groep</translation>
    </message>
    <message>
        <source>Combine harvester, 7.5 m header</source>
        <translation>Maaidorser, maaibord 7,5 m</translation>
    </message>
    <message>
        <source>Corners</source>
        <translation>Hoeken</translation>
    </message>
    <message>
        <source>Counter-clockwise</source>
        <translation>Tegen de klok in</translation>
    </message>
    <message>
        <source>Crop protection: headland first, ways along the headland.</source>
        <translation>Gewasbescherming: kopakker eerst, verplaatsen over de kopakker.</translation>
    </message>
    <message>
        <source>Curves are driven with up to %1 sideways; the machine&apos;s limit is less.</source>
        <translation>Bochten worden met tot %1 zijwaarts gereden; de grens van de machine is lager.</translation>
    </message>
    <message>
        <source>Curves with reversing</source>
        <translation>Bochten met achteruitrijden</translation>
    </message>
    <message>
        <source>Curves with reversing, smooth steering</source>
        <translation>Bochten met achteruitrijden, vloeiend sturen</translation>
    </message>
    <message>
        <source>Cut along the swaths at every corner, sharp or rounded.</source>
        <translation>Langs de werkgangen gesplitst bij elke hoek, scherp of afgerond.</translation>
    </message>
    <message>
        <source>Cut along the swaths where an obstacle or a bay begins or ends.</source>
        <translation>Langs de werkgangen gesplitst waar een obstakel of een inham begint of eindigt.</translation>
    </message>
    <message>
        <source>Cut where an obstacle or a bay begins or ends, and joined again where that saves turns and ways.</source>
        <translation>Gesplitst waar een obstakel of een inham begint of eindigt, en weer samengevoegd waar dat draaien en verplaatsingen bespaart.</translation>
    </message>
    <message>
        <source>Cutting grass: headland first, swaths overlap a little.</source>
        <translation>Gras maaien: kopakker eerst, werkgangen overlappen iets.</translation>
    </message>
    <message>
        <source>DXF drawing</source>
        <translation>DXF-tekening</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richting</translation>
    </message>
    <message>
        <source>Drawn out until the whole width is covered, as far as there is room.</source>
        <translation>Doorgetrokken tot de hele breedte bewerkt is, zover er ruimte is.</translation>
    </message>
    <message>
        <source>Drilling or planting: headland last, ways along the headland.</source>
        <translation>Zaaien of poten: kopakker als laatste, verplaatsen over de kopakker.</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>Rijden</translation>
    </message>
    <message>
        <source>Drive the curves more slowly.</source>
        <translation>Rijd de bochten langzamer.</translation>
    </message>
    <message>
        <source>Drives the path from waypoint to waypoint, rounding corners its own way; relay 1 is on where the implement works. Not tested on the machine by us.</source>
        <translation>Rijdt van waypoint naar waypoint en rondt hoeken op eigen wijze af; relais 1 is aan waar het werktuig werkt. Door ons niet op de machine getest.</translation>
    </message>
    <message>
        <source>Drives the whole path, turns included, as a recorded path; stretches in reverse gear are left to the driver. Shows boundary, headland and guidance lines. Copy the field&apos;s folder to Documents/AgOpenGPS/Fields.</source>
        <translation>Rijdt het hele traject, draaien inbegrepen, als opgenomen pad; stukken achteruit blijven voor de bestuurder. Toont perceelsgrens, kopakker en stuurlijnen. Kopieer de map van het perceel naar Documents/AgOpenGPS/Fields.</translation>
    </message>
    <message>
        <source>Each its own</source>
        <translation>Elk zijn eigen</translation>
    </message>
    <message>
        <source>Edge</source>
        <translation>Zijde</translation>
    </message>
    <message>
        <source>Edge directions and every tenth of a degree, refined; says when nothing better exists.</source>
        <translation>Richtingen van zijden en elke tiende graad, verfijnd; zegt wanneer er niets beters is.</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Einde</translation>
    </message>
    <message>
        <source>Ends</source>
        <translation>Uiteinden</translation>
    </message>
    <message>
        <source>Every how many swaths a wider machine will drive again; 0 for none.</source>
        <translation>Om de hoeveel werkgangen een bredere machine weer rijdt; 0 voor geen.</translation>
    </message>
    <message>
        <source>Every sample of the path; without a plan boundaries as WKT, or as points.</source>
        <translation>Elk punt van het traject; zonder plan perceelsgrenzen als WKT of als punten.</translation>
    </message>
    <message>
        <source>Every second swath on the way out, the others on the way back.</source>
        <translation>Elke tweede werkgang op de heenweg, de andere op de terugweg.</translation>
    </message>
    <message>
        <source>Every swath after its neighbour, back and forth.</source>
        <translation>Elke werkgang na zijn buur, heen en terug.</translation>
    </message>
    <message>
        <source>Fendt One, Vario terminal</source>
        <translation>Fendt One, Varioterminal</translation>
    </message>
    <message>
        <source>Fertiliser or manure: headland first, ways along the headland.</source>
        <translation>Kunstmest of mest: kopakker eerst, verplaatsen over de kopakker.</translation>
    </message>
    <message>
        <source>Fertiliser spreader, 36 m</source>
        <translation>Kunstmeststrooier, 36 m</translation>
    </message>
    <message>
        <source>Fewest swaths</source>
        <translation>Minste werkgangen</translation>
    </message>
    <message>
        <source>Field robot, 1.5 m weeder</source>
        <translation>Veldrobot, schoffel 1,5 m</translation>
    </message>
    <message>
        <source>Finish corners</source>
        <translation>Hoeken afwerken</translation>
    </message>
    <message>
        <source>First tramline</source>
        <translation>Eerste spuitspoor</translation>
    </message>
    <message>
        <source>Fishtail</source>
        <translation>Vissenstaart</translation>
    </message>
    <message>
        <source>Five-furrow mounted plough, 2.5 m</source>
        <translation>Gedragen vijfschaarploeg, 2,5 m</translation>
    </message>
    <message>
        <source>Forward arc, straight back, forward arc; little room for near swaths.</source>
        <translation>Boog vooruit, recht achteruit, boog vooruit; weinig ruimte voor nabije werkgangen.</translation>
    </message>
    <message>
        <source>Forward curves</source>
        <translation>Bochten vooruit</translation>
    </message>
    <message>
        <source>Forward curves, smooth steering</source>
        <translation>Bochten vooruit, vloeiend sturen</translation>
    </message>
    <message>
        <source>Forward, back with the wheels the other way, forward again.</source>
        <translation>Vooruit, achteruit met de wielen andersom, weer vooruit.</translation>
    </message>
    <message>
        <source>Forwards and backwards, the wheels turned no faster than the machine can (clothoids).</source>
        <translation>Vooruit en achteruit, de wielen niet sneller gedraaid dan de machine kan (clothoïden).</translation>
    </message>
    <message>
        <source>From clear of the ground to working depth.</source>
        <translation>Van vrij van de grond tot werkdiepte.</translation>
    </message>
    <message>
        <source>From inside out</source>
        <translation>Van binnen naar buiten</translation>
    </message>
    <message>
        <source>From outside in</source>
        <translation>Van buiten naar binnen</translation>
    </message>
    <message>
        <source>From the boundary inwards; holds as many passes as fit.</source>
        <translation>Van de perceelsgrens tot de binnenakker; bevat zoveel gangen als er passen.</translation>
    </message>
    <message>
        <source>From the fixed axle to the hitch, negative behind the axle.</source>
        <translation>Van de vaste as tot het koppelpunt, negatief achter de as.</translation>
    </message>
    <message>
        <source>From the fixed axle to the middle of the working parts, negative behind the axle.</source>
        <translation>Van de vaste as tot het midden van de werkende delen, negatief achter de as.</translation>
    </message>
    <message>
        <source>From the fixed axle to the tractor&apos;s rear end.</source>
        <translation>Van de vaste as tot de achterkant van de trekker.</translation>
    </message>
    <message>
        <source>From the tractor&apos;s nose to its rear end.</source>
        <translation>Van de voorkant van de trekker tot de achterkant.</translation>
    </message>
    <message>
        <source>From working depth to clear of the ground.</source>
        <translation>Van werkdiepte tot vrij van de grond.</translation>
    </message>
    <message>
        <source>Front and rear mower, 9 m</source>
        <translation>Front- en achtermaaier, 9 m</translation>
    </message>
    <message>
        <source>Fuel at work</source>
        <translation>Brandstof bij het werk</translation>
    </message>
    <message>
        <source>Fuel in turns</source>
        <translation>Brandstof bij het keren</translation>
    </message>
    <message>
        <source>Full spacing; the last swath is moved back to the edge.</source>
        <translation>Volle afstand; de laatste werkgang schuift naar de rand.</translation>
    </message>
    <message>
        <source>Full spacing; a rest of less than half a width stays uncovered, where it costs least.</source>
        <translation>Volle afstand; een rest van minder dan een halve breedte blijft liggen waar dat het minst kost.</translation>
    </message>
    <message>
        <source>Full width</source>
        <translation>Volle breedte</translation>
    </message>
    <message>
        <source>Gets the whole path as nav_msgs/Path, and stretches in one gear each where it reverses.</source>
        <translation>Krijgt het hele traject als nav_msgs/Path, en stukken in elk één versnelling waar hij achteruitrijdt.</translation>
    </message>
    <message>
        <source>Given direction</source>
        <translation>Opgegeven richting</translation>
    </message>
    <message>
        <source>Go round obstacles up to</source>
        <translation>Om obstakels heen tot</translation>
    </message>
    <message>
        <source>Great Field</source>
        <translation>Groot Perceel</translation>
    </message>
    <message>
        <source>Half way in</source>
        <translation>Op halve breedte</translation>
    </message>
    <message>
        <source>Make them straight: &quot;Field&quot; menu, or furrow-cli convert --straighten-steps.</source>
        <translation>Maak ze recht: menu &quot;Perceel&quot;, of furrow-cli convert --straighten-steps.</translation>
    </message>
    <message>
        <source>Quick search</source>
        <translation>Snel zoeken</translation>
    </message>
    <message>
        <source>Harvest</source>
        <translation>Oogst</translation>
    </message>
    <message>
        <source>Heading</source>
        <translation>Rijrichting</translation>
    </message>
    <message>
        <source>Headland</source>
        <translation>Kopakker</translation>
    </message>
    <message>
        <source>Headland first or last.</source>
        <translation>Kopakker eerst of als laatste.</translation>
    </message>
    <message>
        <source>Heights</source>
        <translation>Hoogten</translation>
    </message>
    <message>
        <source>Hitch offset</source>
        <translation>Plaats van het koppelpunt</translation>
    </message>
    <message>
        <source>Home Field</source>
        <translation>Huiskavel</translation>
    </message>
    <message>
        <source>How far a trailed implement may swing to one side.</source>
        <translation>Hoe ver een getrokken werktuig naar één kant mag zwaaien.</translation>
    </message>
    <message>
        <source>How far the steered wheels turn to one side.</source>
        <translation>Hoe ver de gestuurde wielen naar één kant draaien.</translation>
    </message>
    <message>
        <source>How fast the curvature may change along the path; from the steering rate where it is not given.</source>
        <translation>Hoe snel de kromming langs het traject mag veranderen; uit de stuursnelheid waar ze niet opgegeven is.</translation>
    </message>
    <message>
        <source>How fast the steered wheels turn.</source>
        <translation>Hoe snel de gestuurde wielen draaien.</translation>
    </message>
    <message>
        <source>How headland passes get round corners.</source>
        <translation>Hoe kopakkergangen om hoeken komen.</translation>
    </message>
    <message>
        <source>How much neighbouring swaths overlap.</source>
        <translation>Hoeveel naburige werkgangen overlappen.</translation>
    </message>
    <message>
        <source>How the direction of the swaths is found.</source>
        <translation>Hoe de rijrichting gevonden wordt.</translation>
    </message>
    <message>
        <source>How the machine gets from one swath to the next.</source>
        <translation>Hoe de machine van de ene werkgang naar de volgende komt.</translation>
    </message>
    <message>
        <source>How the field is divided; the swaths of a block are driven together.</source>
        <translation>Hoe de binnenakker verdeeld wordt; de werkgangen van een deelperceel worden samen gereden.</translation>
    </message>
    <message>
        <source>Implement can reverse</source>
        <translation>Werktuig kan achteruit</translation>
    </message>
    <message>
        <source>Implement length</source>
        <translation>Lengte van het werktuig</translation>
    </message>
    <message>
        <source>Implement offset</source>
        <translation>Plaats van het werktuig</translation>
    </message>
    <message>
        <source>In WGS84: A and B of a line, a curve, A alone with a direction, or a pivot&apos;s centre.</source>
        <translation>In WGS84: A en B van een lijn, een curve, A alleen met een richting, of het midden van een pivot.</translation>
    </message>
    <message>
        <source>In which order the headland passes are driven.</source>
        <translation>In welke volgorde de kopakkergangen gereden worden.</translation>
    </message>
    <message>
        <source>In which order the swaths are driven.</source>
        <translation>In welke volgorde de werkgangen gereden worden.</translation>
    </message>
    <message>
        <source>Largest acceleration</source>
        <translation>Grootste versnelling</translation>
    </message>
    <message>
        <source>Largest curvature rate</source>
        <translation>Grootste krommingsverandering</translation>
    </message>
    <message>
        <source>Largest hitch angle</source>
        <translation>Grootste knikhoek</translation>
    </message>
    <message>
        <source>Largest lateral acceleration</source>
        <translation>Grootste dwarsversnelling</translation>
    </message>
    <message>
        <source>Largest speed in turns.</source>
        <translation>Hoogste snelheid bij het keren.</translation>
    </message>
    <message>
        <source>Largest steering angle</source>
        <translation>Grootste stuurhoek</translation>
    </message>
    <message>
        <source>Last pass</source>
        <translation>Laatste werkgang</translation>
    </message>
    <message>
        <source>Lateral offset</source>
        <translation>Zijdelings verzet</translation>
    </message>
    <message>
        <source>Least overlap</source>
        <translation>Minste overlap</translation>
    </message>
    <message>
        <source>Least time</source>
        <translation>Kortste tijd</translation>
    </message>
    <message>
        <source>Leaves some swaths out at each turn and comes back for them.</source>
        <translation>Slaat bij elke draai werkgangen over en komt ervoor terug.</translation>
    </message>
    <message>
        <source>Left out</source>
        <translation>Overgeslagen</translation>
    </message>
    <message>
        <source>Limits the speed in tight bends.</source>
        <translation>Begrenst de snelheid in krappe bochten.</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Lijn</translation>
    </message>
    <message>
        <source>Lines along which the field inside the headland is cut; they run right through it, or end no farther than an operating width from its edge.</source>
        <translation>Lijnen waarlangs de binnenakker wordt gesplitst; ze lopen er helemaal doorheen of eindigen hoogstens een werkbreedte voor de rand.</translation>
    </message>
    <message>
        <source>Litres of fuel per hour of turns and transfers.</source>
        <translation>Liter brandstof per uur keren en verplaatsen.</translation>
    </message>
    <message>
        <source>Litres of fuel per hour of work.</source>
        <translation>Liter brandstof per uur werk.</translation>
    </message>
    <message>
        <source>Long Strip</source>
        <translation>Lange Strook</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>Lus</translation>
    </message>
    <message>
        <source>Lower the speeds, or correct the machine&apos;s.</source>
        <translation>Verlaag de snelheden, of verbeter die van de machine.</translation>
    </message>
    <message>
        <source>MAVLink waypoints</source>
        <translation>MAVLink-waypoints</translation>
    </message>
    <message>
        <source>Make the gate wider, or take another.</source>
        <translation>Maak de inrit breder of neem een andere.</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Marge</translation>
    </message>
    <message>
        <source>Overhang</source>
        <translation>Overhang</translation>
    </message>
    <message>
        <source>Most covered</source>
        <translation>Meest bewerkt</translation>
    </message>
    <message>
        <source>Most terminals read FAT32 only; this stick has %1. Format it as FAT32.</source>
        <translation>De meeste terminals lezen alleen FAT32; deze stick heeft %1. Formatteer hem als FAT32.</translation>
    </message>
    <message>
        <source>Mounted cultivator, 6 m</source>
        <translation>Gedragen cultivator, 6 m</translation>
    </message>
    <message>
        <source>Mounted drill, 12 m</source>
        <translation>Gedragen zaaimachine, 12 m</translation>
    </message>
    <message>
        <source>Mounting</source>
        <translation>Aanbouw</translation>
    </message>
    <message>
        <source>Mowing</source>
        <translation>Maaien</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Naam</translation>
    </message>
    <message>
        <source>No headland</source>
        <translation>Geen kopakker</translation>
    </message>
    <message>
        <source>Nothing leads to the start of %1, %2 away.</source>
        <translation>Er leidt geen weg naar het begin, %2 verderop: %1.</translation>
    </message>
    <message>
        <source>Number of the boundary&apos;s edge, from 0 in the order of its points; for curves with all around it up to a corner of 35 degrees within a width, or a bend of 90 in all.</source>
        <translation>Nummer van de zijde van de perceelsgrens, vanaf 0 in de volgorde van de punten; bij curves met alle eromheen tot een hoek van 35 graden binnen een breedte, of een bocht van 90 in totaal.</translation>
    </message>
    <message>
        <source>Of the four corners and both ways the one with the quickest turns.</source>
        <translation>Van de vier hoeken en beide richtingen die met de snelste draaien.</translation>
    </message>
    <message>
        <source>Of the middle of the operating width, positive to the left.</source>
        <translation>Van het midden van de werkbreedte, positief naar links.</translation>
    </message>
    <message>
        <source>Of the swaths.</source>
        <translation>Van de werkgangen.</translation>
    </message>
    <message>
        <source>Off: the strip is kept for turning only.</source>
        <translation>Uit: de strook is alleen om te keren.</translation>
    </message>
    <message>
        <source>Omega turn</source>
        <translation>Omegadraai</translation>
    </message>
    <message>
        <source>On the rows</source>
        <translation>Op de rijen</translation>
    </message>
    <message>
        <source>On the rows, or between them.</source>
        <translation>Op de rijen of ertussen.</translation>
    </message>
    <message>
        <source>On the spot</source>
        <translation>Op de plaats</translation>
    </message>
    <message>
        <source>One for all</source>
        <translation>Eén voor alle</translation>
    </message>
    <message>
        <source>One piece</source>
        <translation>Eén stuk</translation>
    </message>
    <message>
        <source>Only where it turns</source>
        <translation>Alleen waar gekeerd wordt</translation>
    </message>
    <message>
        <source>Operating width</source>
        <translation>Werkbreedte</translation>
    </message>
    <message>
        <source>Operation</source>
        <translation>Bewerking</translation>
    </message>
    <message>
        <source>Orchard tractor with 1.5 m sprayer</source>
        <translation>Smalspoortrekker, boomgaardspuit 1,5 m</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Volgorde</translation>
    </message>
    <message>
        <source>Overlap</source>
        <translation>Overlap</translation>
    </message>
    <message>
        <source>Overlaps its neighbour</source>
        <translation>Overlapt de buur</translation>
    </message>
    <message>
        <source>P turn</source>
        <translation>P-draai</translation>
    </message>
    <message>
        <source>Passes</source>
        <translation>Gangen</translation>
    </message>
    <message>
        <source>Plan again with this machine&apos;s turning radius.</source>
        <translation>Plan opnieuw met de draaistraal van deze machine.</translation>
    </message>
    <message>
        <source>Plan again, or trust the positions.</source>
        <translation>Plan opnieuw, of vertrouw de posities.</translation>
    </message>
    <message>
        <source>Plan again; the heading or the gear is wrong here.</source>
        <translation>Plan opnieuw; de richting of de versnelling klopt hier niet.</translation>
    </message>
    <message>
        <source>Plan again; the path lacks this pass.</source>
        <translation>Plan opnieuw; in het traject ontbreekt deze gang.</translation>
    </message>
    <message>
        <source>Plan again; the path was changed or cut here.</source>
        <translation>Plan opnieuw; het traject is hier gewijzigd of afgekapt.</translation>
    </message>
    <message>
        <source>Plan again; the times were changed.</source>
        <translation>Plan opnieuw; de tijden zijn gewijzigd.</translation>
    </message>
    <message>
        <source>Plan the parts of the field apart, or widen the passage between them.</source>
        <translation>Plan de delen van het perceel apart, of maak de doorgang ertussen breder.</translation>
    </message>
    <message>
        <source>Plan the turn that is missing here.</source>
        <translation>Plan de draai die hier ontbreekt.</translation>
    </message>
    <message>
        <source>Power harrow and drill, 3 m</source>
        <translation>Rotorkopeg met zaaimachine, 3 m</translation>
    </message>
    <message>
        <source>Prefer</source>
        <translation>Voorkeur</translation>
    </message>
    <message>
        <source>Protobuf message</source>
        <translation>Protobuf-bericht</translation>
    </message>
    <message>
        <source>QGroundControl plan</source>
        <translation>QGroundControl-plan</translation>
    </message>
    <message>
        <source>Racetrack</source>
        <translation>Rondgang</translation>
    </message>
    <message>
        <source>Raised width</source>
        <translation>Breedte bij het keren</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Dosering</translation>
    </message>
    <message>
        <source>Rear overhang</source>
        <translation>Achteroverbouw</translation>
    </message>
    <message>
        <source>Recorded path</source>
        <translation>Opgenomen pad</translation>
    </message>
    <message>
        <source>Relay 1 is on where the implement works.</source>
        <translation>Relais 1 is aan waar het werktuig werkt.</translation>
    </message>
    <message>
        <source>Repaired in %1: %2.</source>
        <translation>Hersteld (%1): %2.</translation>
    </message>
    <message>
        <source>Reverse</source>
        <translation>Achteruit</translation>
    </message>
    <message>
        <source>Reverse speed</source>
        <translation>Achteruitsnelheid</translation>
    </message>
    <message>
        <source>Round and round the centre of a pivot, from the rim inwards.</source>
        <translation>Rond en rond om het midden van een pivot, van de rand naar binnen.</translation>
    </message>
    <message>
        <source>Round and round, with half of the swaths between the way out and the way back.</source>
        <translation>Rond en rond, met de helft van de werkgangen tussen heen- en terugweg.</translation>
    </message>
    <message>
        <source>Round the field</source>
        <translation>Rond het perceel</translation>
    </message>
    <message>
        <source>Rounded</source>
        <translation>Afgerond</translation>
    </message>
    <message>
        <source>Route</source>
        <translation>Rijroute</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>Rijen</translation>
    </message>
    <message>
        <source>Rows that are left out, numbered from 1 as in the file; between rows, that on the right.</source>
        <translation>Rijen die wegblijven, genummerd vanaf 1 zoals in het bestand; tussen rijen de rechter.</translation>
    </message>
    <message>
        <source>Run-in</source>
        <translation>Aanloop</translation>
    </message>
    <message>
        <source>Same width all round</source>
        <translation>Rondom even breed</translation>
    </message>
    <message>
        <source>Seen from above, turning left at corners.</source>
        <translation>Van boven gezien, bij hoeken linksaf.</translation>
    </message>
    <message>
        <source>Seen from above, turning right at corners.</source>
        <translation>Van boven gezien, bij hoeken rechtsaf.</translation>
    </message>
    <message>
        <source>Short name for the command line.</source>
        <translation>Korte naam voor de opdrachtregel.</translation>
    </message>
    <message>
        <source>Short passes where corners would leave more than 1 % of the field.</source>
        <translation>Korte gangen waar in hoeken meer dan 1 % van het perceel zou overblijven.</translation>
    </message>
    <message>
        <source>Shortest swaths</source>
        <translation>Kortste werkgangen</translation>
    </message>
    <message>
        <source>Shows the boundary and the guidance lines; it plans turns and order itself. Not tested on the machine by us.</source>
        <translation>Toont de perceelsgrens en de stuurlijnen; draaien en volgorde plant hij zelf. Door ons niet op de machine getest.</translation>
    </message>
    <message>
        <source>Shows the boundary with holes and obstacles and the guidance lines; it plans turns and order itself. The import may have to be unlocked. Not tested on the machine by us.</source>
        <translation>Toont de perceelsgrens met gaten en obstakels en de stuurlijnen; draaien en volgorde plant hij zelf. De import moet misschien ontgrendeld worden. Door ons niet op de machine getest.</translation>
    </message>
    <message>
        <source>Shows the boundary with holes and obstacles, the headland where the terminal knows it, and the guidance lines; it plans turns and order itself. The import may have to be unlocked. Not tested on the machine by us.</source>
        <translation>Toont de perceelsgrens met gaten en obstakels, de kopakker waar de terminal die kent, en de stuurlijnen; draaien en volgorde plant hij zelf. De import moet misschien ontgrendeld worden. Door ons niet op de machine getest.</translation>
    </message>
    <message>
        <source>Shows the boundary, its holes, the headland and the guidance lines, not the path. Holes are written as obstacles, since it overlooks others.</source>
        <translation>Toont de perceelsgrens, de gaten, de kopakker en de stuurlijnen, niet het traject. Gaten worden als obstakels geschreven, omdat het andere over het hoofd ziet.</translation>
    </message>
    <message>
        <source>Shows the path as a mission, and the boundary and obstacles as fences. Not tested on the machine by us.</source>
        <translation>Toont het traject als missie, en de perceelsgrens en obstakels als hekken. Door ons niet op de machine getest.</translation>
    </message>
    <message>
        <source>Six directions, then ever finer around the best three (Oksanen &amp; Visala).</source>
        <translation>Zes richtingen, dan steeds fijner rond de beste drie (Oksanen &amp; Visala).</translation>
    </message>
    <message>
        <source>Six-row planter, 4.5 m</source>
        <translation>Precisiezaaimachine, 6 rijen, 4,5 m</translation>
    </message>
    <message>
        <source>Skip</source>
        <translation>Overslaan</translation>
    </message>
    <message>
        <source>Skip and fill</source>
        <translation>Overslaan en vullen</translation>
    </message>
    <message>
        <source>Slanted Field</source>
        <translation>Schuin Perceel</translation>
    </message>
    <message>
        <source>Slurry tanker, 15 m trailing shoe</source>
        <translation>Mesttank, sleepvoet 15 m</translation>
    </message>
    <message>
        <source>Smallest circle the middle of the fixed axle can follow; from the steering angle where it is not given.</source>
        <translation>Kleinste cirkel die het midden van de vaste as kan volgen; uit de stuurhoek waar hij niet opgegeven is.</translation>
    </message>
    <message>
        <source>Smallest turning radius</source>
        <translation>Kleinste draaistraal</translation>
    </message>
    <message>
        <source>Snake</source>
        <translation>Slang</translation>
    </message>
    <message>
        <source>So that the wide machine begins flush with the left edge, or beside the line that was given.</source>
        <translation>Zodat de brede machine gelijk met de linkerrand begint, of naast de opgegeven lijn.</translation>
    </message>
    <message>
        <source>Sowing</source>
        <translation>Zaaien</translation>
    </message>
    <message>
        <source>Speed backwards.</source>
        <translation>Snelheid achteruit.</translation>
    </message>
    <message>
        <source>Speed on longer ways with the implement lifted.</source>
        <translation>Snelheid op langere stukken met geheven werktuig.</translation>
    </message>
    <message>
        <source>Speed with the implement at work.</source>
        <translation>Snelheid met het werktuig aan het werk.</translation>
    </message>
    <message>
        <source>Spiral in clusters</source>
        <translation>Spiraal in groepen</translation>
    </message>
    <message>
        <source>Split lines</source>
        <translation>Splitlijnen</translation>
    </message>
    <message>
        <source>Spraying</source>
        <translation>Spuiten</translation>
    </message>
    <message>
        <source>Spread over all</source>
        <translation>Over alle verdeeld</translation>
    </message>
    <message>
        <source>Spreading</source>
        <translation>Strooien</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Begin</translation>
    </message>
    <message>
        <source>Start at</source>
        <translation>Beginnen bij</translation>
    </message>
    <message>
        <source>Stay inside</source>
        <translation>Binnen het perceel blijven</translation>
    </message>
    <message>
        <source>Steering rate</source>
        <translation>Stuursnelheid</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Stap</translation>
    </message>
    <message>
        <source>Straight into the corner and back into it on the next side.</source>
        <translation>Recht de hoek in en aan de volgende zijde achteruit erin.</translation>
    </message>
    <message>
        <source>Straight into the corner and on after a loop, where there is room for it.</source>
        <translation>Recht de hoek in en na een lus verder, waar daar ruimte voor is.</translation>
    </message>
    <message>
        <source>Straight way needed before the implement is lowered.</source>
        <translation>Recht stuk dat nodig is voordat het werktuig neergelaten wordt.</translation>
    </message>
    <message>
        <source>Swath after swath over all of the field, whatever cuts them.</source>
        <translation>Werkgang na werkgang over de hele binnenakker, wat er ook doorheen loopt.</translation>
    </message>
    <message>
        <source>Swath numbers in driving order; a minus drives one the other way.</source>
        <translation>Werkgangnummers in rijvolgorde; een min rijdt er een andersom.</translation>
    </message>
    <message>
        <source>Swaths</source>
        <translation>Werkgangen</translation>
    </message>
    <message>
        <source>Swaths go on from block to block.</source>
        <translation>Werkgangen lopen door van deelperceel naar deelperceel.</translation>
    </message>
    <message>
        <source>Swaths go round obstacles of up to this size; larger ones get a headland. Auto is the operating width.</source>
        <translation>Werkgangen gaan om obstakels tot deze grootte heen; grotere krijgen een kopakker. Auto is de werkbreedte.</translation>
    </message>
    <message>
        <source>Swaths left out at each turn and driven on the way back.</source>
        <translation>Werkgangen die bij elke draai worden overgeslagen en op de terugweg gereden.</translation>
    </message>
    <message>
        <source>Swaths that are finished together.</source>
        <translation>Werkgangen die samen afgemaakt worden.</translation>
    </message>
    <message>
        <source>Takes the boundary only, as an upload from a computer; no guidance lines, no path.</source>
        <translation>Neemt alleen de perceelsgrens, geüpload van een computer; geen stuurlijnen, geen traject.</translation>
    </message>
    <message>
        <source>Tank or bunker</source>
        <translation>Tank of bunker</translation>
    </message>
    <message>
        <source>The Bend</source>
        <translation>De Bocht</translation>
    </message>
    <message>
        <source>The best corner</source>
        <translation>De beste hoek</translation>
    </message>
    <message>
        <source>The boundary alone as a flat zipped shapefile, as operations centres take it.</source>
        <translation>Alleen de perceelsgrens als platte gezipte shapefile, zoals operations centers die aannemen.</translation>
    </message>
    <message>
        <source>The chosen one cannot be driven between these swaths.</source>
        <translation>De gekozen draai kan tussen deze werkgangen niet worden gereden.</translation>
    </message>
    <message>
        <source>The corner where the route starts.</source>
        <translation>De hoek waar de rijroute begint.</translation>
    </message>
    <message>
        <source>The field is narrower here than the %1 in which this machine turns without reversing: leave this strip out, or work it with a machine that turns more tightly.</source>
        <translation>Het perceel is hier smaller dan de %1 waarop deze machine draait zonder achteruit te rijden: laat deze strook weg of bewerk haar met een machine die krapper draait.</translation>
    </message>
    <message>
        <source>The field is narrower here than this machine, which takes %1: leave this strip out, or work it with a narrower machine.</source>
        <translation>Het perceel is hier smaller dan deze machine, die %1 nodig heeft: laat deze strook weg of bewerk haar met een smallere machine.</translation>
    </message>
    <message>
        <source>The field is too narrow for %1 of headland; it is %2 with %3</source>
        <translation>Het perceel is te smal voor %1 kopakker; het wordt %2 met %3</translation>
    </message>
    <message>
        <source>The field is too narrow for %1 of headland; there is none</source>
        <translation>Het perceel is te smal voor %1 kopakker; er is er geen</translation>
    </message>
    <message>
        <source>The first swath</source>
        <translation>De eerste werkgang</translation>
    </message>
    <message>
        <source>The first swath on the left is one, or the line that was given.</source>
        <translation>De eerste werkgang links is er een, of de opgegeven lijn.</translation>
    </message>
    <message>
        <source>The first swath on the right is one, or the line that was given.</source>
        <translation>De eerste werkgang rechts is er een, of de opgegeven lijn.</translation>
    </message>
    <message>
        <source>The headland is worked first.</source>
        <translation>De kopakker wordt eerst bewerkt.</translation>
    </message>
    <message>
        <source>The headland is worked last.</source>
        <translation>De kopakker wordt als laatste bewerkt.</translation>
    </message>
    <message>
        <source>The headland strip, %1, is not worked by this plan, nor are %2 at the ends of the swaths beside it.</source>
        <translation>De strook van de kopakker, %1, wordt in dit plan niet bewerkt, en ook %2 aan de uiteinden van de werkgangen ernaast niet.</translation>
    </message>
    <message>
        <source>The headland strip, %1, is not worked by this plan.</source>
        <translation>De strook van de kopakker, %1, wordt in dit plan niet bewerkt.</translation>
    </message>
    <message>
        <source>The hitch bends by %1 in %2; %3 are allowed.</source>
        <translation>Het koppelpunt knikt %1 bij %2; toegestaan is %3.</translation>
    </message>
    <message>
        <source>The largest covered share inside the headland.</source>
        <translation>Het grootste bewerkte deel van de binnenakker.</translation>
    </message>
    <message>
        <source>The least metres driven in swaths, with what is missed added as metres.</source>
        <translation>De minste gereden meters in werkgangen; gemiste plekken tellen als meters mee.</translation>
    </message>
    <message>
        <source>The machine does not get in at %1.</source>
        <translation>De machine komt er hier niet in: %1.</translation>
    </message>
    <message>
        <source>The machine does not get out at %1.</source>
        <translation>De machine komt er hier niet uit: %1.</translation>
    </message>
    <message>
        <source>The machine drives half way between two neighbours.</source>
        <translation>De machine rijdt midden tussen twee buren.</translation>
    </message>
    <message>
        <source>The machine drives over them.</source>
        <translation>De machine rijdt eroverheen.</translation>
    </message>
    <message>
        <source>The machine turns on the spot in %1, by up to %2.</source>
        <translation>De machine draait op %1 op de plaats, tot %2.</translation>
    </message>
    <message>
        <source>The machine turns on the spot in %1, by up to %2; it cannot.</source>
        <translation>De machine draait op %1 op de plaats, tot %2; dat kan ze niet.</translation>
    </message>
    <message>
        <source>The mission has %1 items; controllers without a memory card hold about %2.</source>
        <translation>De missie heeft %1 items; besturingen zonder geheugenkaart bevatten er ongeveer %2.</translation>
    </message>
    <message>
        <source>The outermost pass goes round with the machine&apos;s radius where little is left; others reach into corners.</source>
        <translation>De buitenste gang gaat met de straal van de machine rond waar weinig blijft liggen; andere reiken in de hoeken.</translation>
    </message>
    <message>
        <source>The outline has %1 steps of about %2, like the pixels of an image.</source>
        <translation>De omtrek heeft %1 trapjes van ongeveer %2, zoals de pixels van een beeld.</translation>
    </message>
    <message>
        <source>The pass along the boundary first.</source>
        <translation>De gang langs de perceelsgrens eerst.</translation>
    </message>
    <message>
        <source>The innermost pass first.</source>
        <translation>De gang langs de binnenakker eerst.</translation>
    </message>
    <message>
        <source>The path as a mission for ArduPilot Rover: waypoints, speeds, gear, implement.</source>
        <translation>Het traject als missie voor ArduPilot Rover: waypoints, snelheden, versnelling, werktuig.</translation>
    </message>
    <message>
        <source>The path as a track, swath ends as a route, gates as waypoints; for phones.</source>
        <translation>Het traject als track, einden van werkgangen als route, inritten als waypoints; voor telefoons.</translation>
    </message>
    <message>
        <source>The path as nav_msgs/Path in a recording of ROS 2.</source>
        <translation>Het traject als nav_msgs/Path in een opname van ROS 2.</translation>
    </message>
    <message>
        <source>The path as one message for ros2 topic pub.</source>
        <translation>Het traject als één bericht voor ros2 topic pub.</translation>
    </message>
    <message>
        <source>The path with times, velocities and orientations, and the boundary as a fence; for own robots.</source>
        <translation>Het traject met tijden, snelheden en oriëntaties, en de perceelsgrens als hek; voor eigen robots.</translation>
    </message>
    <message>
        <source>The quickest turn of any kind that stays inside the field, in several moves where it must.</source>
        <translation>De snelste draai van welke soort ook die binnen het perceel blijft, in meer bewegingen waar nodig.</translation>
    </message>
    <message>
        <source>The same as KML, zipped.</source>
        <translation>Hetzelfde als KML, gezipt.</translation>
    </message>
    <message>
        <source>The same mission with the boundary and obstacles as fences.</source>
        <translation>Dezelfde missie met perceelsgrens en obstakels als hekken.</translation>
    </message>
    <message>
        <source>The shortest curve forwards and backwards, at the smallest turning radius (Reeds and Shepp).</source>
        <translation>De kortste bocht vooruit en achteruit, met de kleinste draaistraal (Reeds en Shepp).</translation>
    </message>
    <message>
        <source>The shortest curve without reversing, at the smallest turning radius (Dubins).</source>
        <translation>De kortste bocht zonder achteruitrijden, met de kleinste draaistraal (Dubins).</translation>
    </message>
    <message>
        <source>The shortest time in swaths and turns.</source>
        <translation>De kortste tijd in werkgangen en draaien.</translation>
    </message>
    <message>
        <source>The smallest area worked twice.</source>
        <translation>De kleinste dubbel bewerkte oppervlakte.</translation>
    </message>
    <message>
        <source>The spacing is reduced evenly so that all fit.</source>
        <translation>De afstand wordt gelijkmatig verkleind zodat alle passen.</translation>
    </message>
    <message>
        <source>The stated curvature differs from the path in %1, by up to %2 1/m.</source>
        <translation>De opgegeven kromming wijkt op %1 af van het traject, tot %2 1/m.</translation>
    </message>
    <message>
        <source>The stated speed is up to %1 above the machine&apos;s.</source>
        <translation>De opgegeven snelheid ligt tot %1 boven die van de machine.</translation>
    </message>
    <message>
        <source>The strip kept for turning.</source>
        <translation>De strook om te keren.</translation>
    </message>
    <message>
        <source>The swaths in the order and direction that you type.</source>
        <translation>De werkgangen in getypte volgorde en richting.</translation>
    </message>
    <message>
        <source>The table holds boundaries only: obstacles, gates and lines are left out.</source>
        <translation>De tabel bevat alleen perceelsgrenzen: obstakels, inritten en lijnen zijn weggelaten.</translation>
    </message>
    <message>
        <source>The task data has %1 MB; old terminals take at most 2 MB.</source>
        <translation>De taakgegevens zijn %1 MB; oude terminals nemen hoogstens 2 MB.</translation>
    </message>
    <message>
        <source>The tractor may drive backwards with it.</source>
        <translation>De trekker mag er achteruit mee rijden.</translation>
    </message>
    <message>
        <source>The tractor may drive backwards.</source>
        <translation>De trekker mag achteruitrijden.</translation>
    </message>
    <message>
        <source>The tractor may turn about its own middle.</source>
        <translation>De trekker mag om zijn eigen midden draaien.</translation>
    </message>
    <message>
        <source>The way from %1 to %2</source>
        <translation>De verplaatsing %1 → %2</translation>
    </message>
    <message>
        <source>There the chosen one does not fit into the field or cannot be driven between these swaths.</source>
        <translation>De gekozen draai past daar niet in het perceel of kan tussen deze werkgangen niet worden gereden.</translation>
    </message>
    <message>
        <source>There the chosen one does not fit into the field.</source>
        <translation>De gekozen draai past daar niet in het perceel.</translation>
    </message>
    <message>
        <source>This machine cannot reverse.</source>
        <translation>Deze machine kan niet achteruitrijden.</translation>
    </message>
    <message>
        <source>This stick has %1 partitions; terminals see the first one only, if any.</source>
        <translation>Deze stick heeft %1 partities; terminals zien hoogstens de eerste.</translation>
    </message>
    <message>
        <source>Three Ponds</source>
        <translation>Drie Vijvers</translation>
    </message>
    <message>
        <source>Three-point turn</source>
        <translation>Steekbocht</translation>
    </message>
    <message>
        <source>Through point A in the direction that you type.</source>
        <translation>Door punt A in de getypte richting.</translation>
    </message>
    <message>
        <source>Tillage</source>
        <translation>Grondbewerking</translation>
    </message>
    <message>
        <source>Time and way do not fit the speed in %1.</source>
        <translation>Tijd en afstand passen op %1 niet bij de snelheid.</translation>
    </message>
    <message>
        <source>Time to lift</source>
        <translation>Tijd om te heffen</translation>
    </message>
    <message>
        <source>Time to lower</source>
        <translation>Tijd om neer te laten</translation>
    </message>
    <message>
        <source>To and fro</source>
        <translation>Heen en weer</translation>
    </message>
    <message>
        <source>Trailed sprayer, 24 m boom</source>
        <translation>Getrokken veldspuit, boom 24 m</translation>
    </message>
    <message>
        <source>Tramline every</source>
        <translation>Spuitspoor elke</translation>
    </message>
    <message>
        <source>Transfer speed</source>
        <translation>Snelheid bij verplaatsen</translation>
    </message>
    <message>
        <source>Transport width</source>
        <translation>Transportbreedte</translation>
    </message>
    <message>
        <source>Trapezoids</source>
        <translation>Trapezia</translation>
    </message>
    <message>
        <source>Tries every heading in steps and keeps the best.</source>
        <translation>Probeert alle richtingen in stappen en houdt de beste.</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Draai</translation>
    </message>
    <message>
        <source>Turning speed</source>
        <translation>Snelheid bij het keren</translation>
    </message>
    <message>
        <source>Turns</source>
        <translation>Draaien</translation>
    </message>
    <message>
        <source>Turns between swaths that are of another kind than chosen (path.method): %1 of %2. %3</source>
        <translation>Draaien tussen werkgangen die anders zijn dan gekozen (path.method): %1 van %2. %3</translation>
    </message>
    <message>
        <source>Turns in place and drives straight to the next swath; only for machines that can.</source>
        <translation>Draait op de plaats en rijdt recht naar de volgende werkgang; alleen voor machines die dat kunnen.</translation>
    </message>
    <message>
        <source>Turns on the spot are chosen (path.method), and this machine cannot turn on the spot.</source>
        <translation>Er is gekozen voor draaien op de plaats (path.method), en deze machine kan niet op de plaats draaien.</translation>
    </message>
    <message>
        <source>U turn</source>
        <translation>U-draai</translation>
    </message>
    <message>
        <source>Vehicle length</source>
        <translation>Voertuiglengte</translation>
    </message>
    <message>
        <source>Vehicle width</source>
        <translation>Voertuigbreedte</translation>
    </message>
    <message>
        <source>Ways</source>
        <translation>Verplaatsingen</translation>
    </message>
    <message>
        <source>Ways keep to the field&apos;s edge.</source>
        <translation>Verplaatsingen blijven aan de rand van het perceel.</translation>
    </message>
    <message>
        <source>Ways keep to the headland; crop and seedbed are not driven over.</source>
        <translation>Verplaatsingen blijven op de kopakker; over gewas en zaaibed wordt niet gereden.</translation>
    </message>
    <message>
        <source>Ways may cross worked land.</source>
        <translation>Verplaatsingen mogen over de binnenakker gaan.</translation>
    </message>
    <message>
        <source>Well-known text</source>
        <translation>Well-known text</translation>
    </message>
    <message>
        <source>What becomes of the width that is left over at the far side.</source>
        <translation>Wat er gebeurt met de breedte die aan de andere kant overblijft.</translation>
    </message>
    <message>
        <source>Distance from the boundary that nothing enters; auto is the boundary&apos;s accuracy.</source>
        <translation>Afstand die alles tot de perceelsgrens houdt; auto is de nauwkeurigheid van de perceelsgrens.</translation>
    </message>
    <message>
        <source>How far the implement may stand over the boundary and obstacles, its sections there switched off; the tractor and all wheels stay inside.</source>
        <translation>Hoe ver het werktuig over de perceelsgrens en obstakels mag steken, met de secties daar uitgeschakeld; de trekker en alle wielen blijven binnen.</translation>
    </message>
    <message>
        <source>What is spread or gathered on a square metre, in the same unit.</source>
        <translation>Wat op een vierkante meter verdeeld of geoogst wordt, in dezelfde eenheid.</translation>
    </message>
    <message>
        <source>What it holds, in your own unit: litres, kilograms, seeds.</source>
        <translation>Wat erin gaat, in de eigen eenheid: liters, kilo&apos;s, zaden.</translation>
    </message>
    <message>
        <source>What the field is driven over for: sets when the headland is worked, ways and overlap.</source>
        <translation>Waarvoor gereden wordt: bepaalt wanneer de kopakker bewerkt wordt, de verplaatsingen en de overlap.</translation>
    </message>
    <message>
        <source>What the machine is called.</source>
        <translation>Hoe de machine heet.</translation>
    </message>
    <message>
        <source>What the search for the best heading looks for.</source>
        <translation>Waar het zoeken naar de beste rijrichting op let.</translation>
    </message>
    <message>
        <source>Wheelbase</source>
        <translation>Wielbasis</translation>
    </message>
    <message>
        <source>When</source>
        <translation>Wanneer</translation>
    </message>
    <message>
        <source>When speeding up and when braking.</source>
        <translation>Bij optrekken en bij remmen.</translation>
    </message>
    <message>
        <source>Where a swath ends at a slanting edge.</source>
        <translation>Waar een werkgang aan een schuine zijde eindigt.</translation>
    </message>
    <message>
        <source>Where the machine may drive from swath to swath; follows from the operation.</source>
        <translation>Waar de machine van werkgang naar werkgang mag rijden; volgt uit de bewerking.</translation>
    </message>
    <message>
        <source>Where the middle of the swath meets the headland.</source>
        <translation>Waar het midden van de werkgang de kopakker raakt.</translation>
    </message>
    <message>
        <source>Where tramlines are counted from.</source>
        <translation>Vanwaar de spuitsporen geteld worden.</translation>
    </message>
    <message>
        <source>Whether blocks have a heading of their own.</source>
        <translation>Of deelpercelen een eigen rijrichting hebben.</translation>
    </message>
    <message>
        <source>Which way round the headland passes are driven.</source>
        <translation>In welke richting de kopakkergangen gereden worden.</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breedte</translation>
    </message>
    <message>
        <source>Width in operating widths; auto leaves room for the turns.</source>
        <translation>Breedte in werkbreedtes; auto laat ruimte om te keren.</translation>
    </message>
    <message>
        <source>Width the tractor occupies, wheels included.</source>
        <translation>Breedte die de trekker inneemt, wielen inbegrepen.</translation>
    </message>
    <message>
        <source>Width while folded for the road, through gates and on ways in and out; the raised width where it is not given.</source>
        <translation>Breedte als het voor de weg is opgeklapt, door inritten en bij het in- en uitrijden; zonder opgave de breedte bij het keren.</translation>
    </message>
    <message>
        <source>Width while lifted or folded for a turn; the operating width where it is not given.</source>
        <translation>Breedte terwijl het werktuig bij het keren geheven of opgeklapt is; zonder opgave de werkbreedte.</translation>
    </message>
    <message>
        <source>Width worked in one pass.</source>
        <translation>Breedte die in één werkgang bewerkt wordt.</translation>
    </message>
    <message>
        <source>Without reversing, the wheels turned no faster than the machine can (clothoids).</source>
        <translation>Zonder achteruitrijden, de wielen niet sneller gedraaid dan de machine kan (clothoïden).</translation>
    </message>
    <message>
        <source>Work it along the boundary, before or after the swaths.</source>
        <translation>Bewerk hem langs de perceelsgrens, vóór of na de werkgangen.</translation>
    </message>
    <message>
        <source>Work the headland</source>
        <translation>Kopakker bewerken</translation>
    </message>
    <message>
        <source>Working speed</source>
        <translation>Werksnelheid</translation>
    </message>
    <message>
        <source>Working the soil: worked land may be driven over.</source>
        <translation>Grondbewerking: er mag over de binnenakker gereden worden.</translation>
    </message>
    <message>
        <source>Your own order</source>
        <translation>Eigen volgorde</translation>
    </message>
    <message>
        <source>Zipped boundary</source>
        <translation>Gezipte perceelsgrens</translation>
    </message>
    <message>
        <source>a chunk of the recording has a wrong checksum</source>
        <translation>een blok van de opname heeft een verkeerde controlesom</translation>
    </message>
    <message>
        <source>a chunk of the recording is cut off</source>
        <translation>een blok van de opname is afgekapt</translation>
    </message>
    <message>
        <source>a chunk of the recording is damaged</source>
        <translation>een blok van de opname is beschadigd</translation>
    </message>
    <message>
        <source>a compressed chunk of the recording is damaged</source>
        <translation>een gecomprimeerd blok van de opname is beschadigd</translation>
    </message>
    <message>
        <source>a coordinate is not a number</source>
        <translation>een coördinaat is geen getal</translation>
    </message>
    <message>
        <source>a curve needs at least two points that differ</source>
        <translation>een curve heeft minstens twee verschillende punten nodig</translation>
    </message>
    <message>
        <source>a drawing does not say which coordinate system it uses</source>
        <translation>een tekening zegt niet welk coördinatenstelsel ze gebruikt</translation>
    </message>
    <message>
        <source>a hole lies outside the boundary</source>
        <translation>een gat ligt buiten de perceelsgrens</translation>
    </message>
    <message>
        <source>a hole of &apos;%1&apos; is missing or another</source>
        <translation>een gat van ‘%1’ ontbreekt of is anders</translation>
    </message>
    <message>
        <source>a machine is one JSON object</source>
        <translation>een machine is één JSON-object</translation>
    </message>
    <message>
        <source>a message is cut off</source>
        <translation>een bericht is afgekapt</translation>
    </message>
    <message>
        <source>a message is not plain CDR</source>
        <translation>een bericht is geen gewone CDR</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>een getal</translation>
    </message>
    <message>
        <source>a number is too large to be read</source>
        <translation>een getal is te groot om te lezen</translation>
    </message>
    <message>
        <source>a part of it states %1 bytes, more than 256 MiB</source>
        <translation>een deel ervan zou %1 bytes groot zijn, meer dan 256 MiB</translation>
    </message>
    <message>
        <source>a part of the boundary of &apos;%1&apos; is missing or another</source>
        <translation>een deel van de perceelsgrens van ‘%1’ ontbreekt of is anders</translation>
    </message>
    <message>
        <source>a point</source>
        <translation>een punt</translation>
    </message>
    <message>
        <source>a point has no place in EPSG:%1</source>
        <translation>een punt heeft geen plaats in EPSG:%1</translation>
    </message>
    <message>
        <source>a point or a line in WGS84 such as LINESTRING (4.1 52.0, 4.2 52.0)</source>
        <translation>een punt of een lijn in WGS84 zoals LINESTRING (4.1 52.0, 4.2 52.0)</translation>
    </message>
    <message>
        <source>a record of the recording is damaged</source>
        <translation>een record van de opname is beschadigd</translation>
    </message>
    <message>
        <source>a sliver of %1 was left out</source>
        <translation>een snipper van %1 is weggelaten</translation>
    </message>
    <message>
        <source>a track that ended %1 from where it began was closed</source>
        <translation>een opgenomen rit die %1 van het begin eindigde, is gesloten</translation>
    </message>
    <message>
        <source>a value of its own</source>
        <translation>een eigen waarde</translation>
    </message>
    <message>
        <source>add the .prj file that belongs to it, or export the field again in WGS84</source>
        <translation>voeg het .prj-bestand toe dat erbij hoort, of exporteer het perceel opnieuw in WGS84</translation>
    </message>
    <message>
        <source>allow it to be kept as a backup</source>
        <translation>sta toe dat het als reservekopie bewaard blijft</translation>
    </message>
    <message>
        <source>an obstacle</source>
        <translation>een obstakel</translation>
    </message>
    <message>
        <source>an obstacle has no shape</source>
        <translation>een obstakel heeft geen vorm</translation>
    </message>
    <message>
        <source>an overlap of %1 leaves nothing of %2</source>
        <translation>een overlap van %1 laat niets over van %2</translation>
    </message>
    <message>
        <source>boundary accuracy</source>
        <translation>nauwkeurigheid van de perceelsgrens</translation>
    </message>
    <message>
        <source>changes cannot be kept for the case of a crash: %1</source>
        <translation>wijzigingen kunnen niet bewaard worden voor het geval van een crash: %1</translation>
    </message>
    <message>
        <source>check its coordinates</source>
        <translation>controleer de coördinaten</translation>
    </message>
    <message>
        <source>check that the folder can be written to</source>
        <translation>controleer of er in de map geschreven mag worden</translation>
    </message>
    <message>
        <source>check that you may read it</source>
        <translation>controleer of het gelezen mag worden</translation>
    </message>
    <message>
        <source>check the boundary for crossings</source>
        <translation>controleer de perceelsgrens op kruisingen</translation>
    </message>
    <message>
        <source>check the coordinate system, correct this point, or split the field</source>
        <translation>controleer het coördinatenstelsel, verbeter dit punt of splits het perceel</translation>
    </message>
    <message>
        <source>check the file&apos;s coordinate system</source>
        <translation>controleer het coördinatenstelsel van het bestand</translation>
    </message>
    <message>
        <source>check the operating width and the overlap</source>
        <translation>controleer de werkbreedte en de overlap</translation>
    </message>
    <message>
        <source>check the path</source>
        <translation>controleer het pad</translation>
    </message>
    <message>
        <source>check the width and how far the edge lies from the line</source>
        <translation>controleer de breedte en hoe ver de rand van de lijn ligt</translation>
    </message>
    <message>
        <source>check the width of the implement, or take the track as driven around the field</source>
        <translation>controleer de breedte van het werktuig, of neem de rit als rondgang om het perceel</translation>
    </message>
    <message>
        <source>choose a narrower headland or a narrower machine</source>
        <translation>kies een smallere kopakker of een smallere machine</translation>
    </message>
    <message>
        <source>choose a smaller machine or check the boundary&apos;s coordinate system</source>
        <translation>kies een kleinere machine of controleer het coördinatenstelsel van de perceelsgrens</translation>
    </message>
    <message>
        <source>choose another format</source>
        <translation>kies een ander formaat</translation>
    </message>
    <message>
        <source>choose one by its id: %1</source>
        <translation>kies er een met zijn id: %1</translation>
    </message>
    <message>
        <source>choose one by its number in the file: %1</source>
        <translation>kies er een op nummer in het bestand: %1</translation>
    </message>
    <message>
        <source>choose the format rosbag2-mcap</source>
        <translation>kies het formaat rosbag2-mcap</translation>
    </message>
    <message>
        <source>close it there first</source>
        <translation>sluit het daar eerst</translation>
    </message>
    <message>
        <source>contour needs heights</source>
        <translation>hoogtelijnen hebben hoogten nodig</translation>
    </message>
    <message>
        <source>copy it again, or mend it with &apos;mcap recover&apos; or sqlite3&apos;s &apos;.recover&apos;</source>
        <translation>kopieer het opnieuw, of herstel het met &apos;mcap recover&apos; of &apos;.recover&apos; van sqlite3</translation>
    </message>
    <message>
        <source>copy or export it again</source>
        <translation>kopieer of exporteer het opnieuw</translation>
    </message>
    <message>
        <source>copy or export the recording again</source>
        <translation>kopieer of exporteer de opname opnieuw</translation>
    </message>
    <message>
        <source>copy the whole folder</source>
        <translation>kopieer de hele map</translation>
    </message>
    <message>
        <source>correct it, or remove the hole or obstacle from the file</source>
        <translation>verbeter het, of verwijder het gat of obstakel uit het bestand</translation>
    </message>
    <message>
        <source>correct or delete this point in the file</source>
        <translation>verbeter of verwijder dit punt in het bestand</translation>
    </message>
    <message>
        <source>correct or remove the line</source>
        <translation>verbeter of verwijder de regel</translation>
    </message>
    <message>
        <source>correct or remove the point</source>
        <translation>verbeter of verwijder het punt</translation>
    </message>
    <message>
        <source>correct the line, or export the track in WGS84</source>
        <translation>verbeter de regel, of exporteer de rit in WGS84</translation>
    </message>
    <message>
        <source>could not be read: %1</source>
        <translation>kon niet gelezen worden: %1</translation>
    </message>
    <message>
        <source>could not be written: %1</source>
        <translation>kon niet geschreven worden: %1</translation>
    </message>
    <message>
        <source>crosses an obstacle</source>
        <translation>gaat over een obstakel</translation>
    </message>
    <message>
        <source>cut it into the days or fields that it holds</source>
        <translation>splits het in de dagen of percelen die erin zitten</translation>
    </message>
    <message>
        <source>decimal commas in the place of the field were taken for points</source>
        <translation>decimale komma&apos;s in de plaats van het perceel zijn als punten gelezen</translation>
    </message>
    <message>
        <source>delete some of them</source>
        <translation>verwijder er enkele</translation>
    </message>
    <message>
        <source>delete the hole that covers it</source>
        <translation>verwijder het gat dat alles bedekt</translation>
    </message>
    <message>
        <source>did you mean &apos;%1&apos;?</source>
        <translation>bedoelde u ‘%1’?</translation>
    </message>
    <message>
        <source>did you mean &apos;%1&apos;? use one of: %2; or give a machine file (.json)</source>
        <translation>bedoelde u ‘%1’? gebruik een van: %2; of geef een machinebestand (.json)</translation>
    </message>
    <message>
        <source>download the file and give its path</source>
        <translation>download het bestand en geef het pad</translation>
    </message>
    <message>
        <source>draw it again</source>
        <translation>teken het opnieuw</translation>
    </message>
    <message>
        <source>draw it again with at least 3 corners</source>
        <translation>teken het opnieuw met minstens 3 hoeken</translation>
    </message>
    <message>
        <source>draw it as an area, or remove it from the file</source>
        <translation>teken het als vlak, of verwijder het uit het bestand</translation>
    </message>
    <message>
        <source>draw it, or remove it from the file</source>
        <translation>teken het, of verwijder het uit het bestand</translation>
    </message>
    <message>
        <source>draw one or open a file that has one</source>
        <translation>teken er een of open een bestand dat er een heeft</translation>
    </message>
    <message>
        <source>draw or open one in the window first</source>
        <translation>teken of open er eerst een in het venster</translation>
    </message>
    <message>
        <source>drive on to where the recording began, or take the track as worked land</source>
        <translation>rijd door tot waar de opname begon, of neem de rit als bewerkt land</translation>
    </message>
    <message>
        <source>export fewer fields at once</source>
        <translation>exporteer minder percelen tegelijk</translation>
    </message>
    <message>
        <source>export it again</source>
        <translation>exporteer het opnieuw</translation>
    </message>
    <message>
        <source>export it again with its coordinate system</source>
        <translation>exporteer het opnieuw met het coördinatenstelsel</translation>
    </message>
    <message>
        <source>export or copy it again</source>
        <translation>exporteer of kopieer het opnieuw</translation>
    </message>
    <message>
        <source>export the boundary as a polygon</source>
        <translation>exporteer de perceelsgrens als polygoon</translation>
    </message>
    <message>
        <source>export the field again in WGS84 (longitude and latitude)</source>
        <translation>exporteer het perceel opnieuw in WGS84 (lengte- en breedtegraden)</translation>
    </message>
    <message>
        <source>export the field with its boundary</source>
        <translation>exporteer het perceel met de perceelsgrens</translation>
    </message>
    <message>
        <source>export the field with its boundary; furrow-cli compare reads what a machine recorded</source>
        <translation>exporteer het perceel met de perceelsgrens; furrow-cli compare leest wat een machine heeft opgenomen</translation>
    </message>
    <message>
        <source>export the fields again in one coordinate system</source>
        <translation>exporteer de percelen opnieuw in één coördinatenstelsel</translation>
    </message>
    <message>
        <source>export the recorded track, not only its waypoints</source>
        <translation>exporteer de opgenomen rit, niet alleen de wegpunten</translation>
    </message>
    <message>
        <source>feature %1</source>
        <translation>object %1</translation>
    </message>
    <message>
        <source>fewer than 3 different points enclose nothing</source>
        <translation>minder dan 3 verschillende punten sluiten niets in</translation>
    </message>
    <message>
        <source>free some space on it, or use another one</source>
        <translation>maak er ruimte op vrij, of gebruik een andere</translation>
    </message>
    <message>
        <source>free some space on the stick</source>
        <translation>maak ruimte vrij op de stick</translation>
    </message>
    <message>
        <source>free some space or choose another folder</source>
        <translation>maak ruimte vrij of kies een andere map</translation>
    </message>
    <message>
        <source>gate %1</source>
        <translation>inrit %1</translation>
    </message>
    <message>
        <source>give %1</source>
        <translation>geef %1</translation>
    </message>
    <message>
        <source>give 0 m or more</source>
        <translation>geef 0 m of meer</translation>
    </message>
    <message>
        <source>give GPX, CSV, an NMEA or gpsd log, ISOXML task data (folder, TASKDATA.XML or zip) or a rosbag2</source>
        <translation>geef GPX, CSV, een log van NMEA of gpsd, ISOXML-taakgegevens (map, TASKDATA.XML of zip) of een rosbag2</translation>
    </message>
    <message>
        <source>give GeoJSON, a shapefile (.shp or .zip), TASKDATA.XML, KML, KMZ, GeoPackage, GML, FlatGeobuf, DXF, WKT or CSV</source>
        <translation>geef GeoJSON, een shapefile (.shp of .zip), TASKDATA.XML, KML, KMZ, GeoPackage, GML, FlatGeobuf, DXF, WKT of CSV</translation>
    </message>
    <message>
        <source>give a GeoTIFF, or a world file (.pgw) beside the PNG</source>
        <translation>geef een GeoTIFF, of een worldbestand (.pgw) naast de PNG</translation>
    </message>
    <message>
        <source>give a buffer of 0 m or more</source>
        <translation>geef een afstand van 0 m of meer</translation>
    </message>
    <message>
        <source>give a distance up to 50 m</source>
        <translation>geef een afstand tot 50 m</translation>
    </message>
    <message>
        <source>give a gap up to 100 m</source>
        <translation>geef een opening tot 100 m</translation>
    </message>
    <message>
        <source>give a plan and a track of the same field</source>
        <translation>geef een plan en een rit van hetzelfde perceel</translation>
    </message>
    <message>
        <source>give a width up to 100 m</source>
        <translation>geef een breedte tot 100 m</translation>
    </message>
    <message>
        <source>give an overhang of 0 to 100 m</source>
        <translation>geef een overhang van 0 tot 100 m</translation>
    </message>
    <message>
        <source>give a curve that does not, or plan its parts apart</source>
        <translation>geef een curve die dat niet doet, of plan de delen apart</translation>
    </message>
    <message>
        <source>give a file on a disk</source>
        <translation>geef een bestand op een schijf</translation>
    </message>
    <message>
        <source>give a file with a line for each row</source>
        <translation>geef een bestand met een lijn per rij</translation>
    </message>
    <message>
        <source>give a gate, or a point in the field</source>
        <translation>geef een inrit, of een punt in het perceel</translation>
    </message>
    <message>
        <source>give a gentler curve, or one without a turn back</source>
        <translation>geef een flauwere curve, of een zonder omkering</translation>
    </message>
    <message>
        <source>give a machine file (JSON)</source>
        <translation>geef een machinebestand (JSON)</translation>
    </message>
    <message>
        <source>give a number</source>
        <translation>geef een getal</translation>
    </message>
    <message>
        <source>give a number from %1 to %2</source>
        <translation>geef een getal van %1 tot %2</translation>
    </message>
    <message>
        <source>give a number from 0 to %1</source>
        <translation>geef een getal van 0 tot %1</translation>
    </message>
    <message>
        <source>give a number in %1</source>
        <translation>geef een getal in %1</translation>
    </message>
    <message>
        <source>give a picture of at most 100 million pixels</source>
        <translation>geef een beeld van hoogstens 100 miljoen pixels</translation>
    </message>
    <message>
        <source>give a point such as POINT (4.1 52.0)</source>
        <translation>geef een punt zoals POINT (4.1 52.0)</translation>
    </message>
    <message>
        <source>give a smaller margin or check the obstacles</source>
        <translation>geef een kleinere marge of controleer de obstakels</translation>
    </message>
    <message>
        <source>give a smaller number</source>
        <translation>geef een kleiner getal</translation>
    </message>
    <message>
        <source>give a text in quotes</source>
        <translation>geef een tekst tussen aanhalingstekens</translation>
    </message>
    <message>
        <source>give a transverse Mercator with +lat_0 and +lon_0</source>
        <translation>geef een transversale mercatorprojectie met +lat_0 en +lon_0</translation>
    </message>
    <message>
        <source>give a width of 0 m or more</source>
        <translation>geef een breedte van 0 m of meer</translation>
    </message>
    <message>
        <source>give an EPSG code, as in SRID=4326;POLYGON(...)</source>
        <translation>geef een EPSG-code, zoals SRID=4326;POLYGON(...)</translation>
    </message>
    <message>
        <source>give both in degrees, or remove the row</source>
        <translation>geef beide in graden, of verwijder de rij</translation>
    </message>
    <message>
        <source>give each point as [longitude, latitude]</source>
        <translation>geef elk punt als [lengtegraad, breedtegraad]</translation>
    </message>
    <message>
        <source>give heights as a GeoTIFF or an ASCII grid</source>
        <translation>geef hoogten als GeoTIFF of ASCII-raster</translation>
    </message>
    <message>
        <source>give heights that cover the field</source>
        <translation>geef hoogten die het perceel dekken</translation>
    </message>
    <message>
        <source>give it a kind, or remove it from the file</source>
        <translation>geef het een soort, of verwijder het uit het bestand</translation>
    </message>
    <message>
        <source>give it as WKT in WGS84, %1</source>
        <translation>geef het als WKT in WGS84, %1</translation>
    </message>
    <message>
        <source>give it as WKT in WGS84, such as LINESTRING (4.1 52.0, 4.2 52.0, 4.3 52.1)</source>
        <translation>geef het als WKT in WGS84, zoals LINESTRING (4.1 52.0, 4.2 52.0, 4.3 52.1)</translation>
    </message>
    <message>
        <source>give it as WKT in WGS84, such as POINT (4.1 52.0)</source>
        <translation>geef het als WKT in WGS84, zoals POINT (4.1 52.0)</translation>
    </message>
    <message>
        <source>give it the field that it lies in, or remove it from the file</source>
        <translation>geef het perceel op waarin het ligt, of verwijder het uit het bestand</translation>
    </message>
    <message>
        <source>give its width while it is folded</source>
        <translation>geef de breedte in opgeklapte toestand</translation>
    </message>
    <message>
        <source>give less than the operating width</source>
        <translation>geef minder dan de werkbreedte</translation>
    </message>
    <message>
        <source>give metres, 0 or more</source>
        <translation>geef meters, 0 of meer</translation>
    </message>
    <message>
        <source>give min_turning_radius_m or max_steering_angle_deg</source>
        <translation>geef min_turning_radius_m of max_steering_angle_deg</translation>
    </message>
    <message>
        <source>give one of %1 or a point such as POINT (4.1 52.0)</source>
        <translation>geef een van %1 of een punt zoals POINT (4.1 52.0)</translation>
    </message>
    <message>
        <source>give one of the files in it</source>
        <translation>geef een van de bestanden erin</translation>
    </message>
    <message>
        <source>give operating_width_m in metres</source>
        <translation>geef operating_width_m in meters</translation>
    </message>
    <message>
        <source>give the file TASKDATA.XML</source>
        <translation>geef het bestand TASKDATA.XML</translation>
    </message>
    <message>
        <source>give the folder of a field</source>
        <translation>geef de map van een perceel</translation>
    </message>
    <message>
        <source>give the folder of one of these, or a file in it</source>
        <translation>geef de map van een daarvan, of een bestand erin</translation>
    </message>
    <message>
        <source>give the folder of one recording</source>
        <translation>geef de map van één opname</translation>
    </message>
    <message>
        <source>give the folder or zip with TASKDATA.XML and its TLG files, a rosbag2 folder, or one file</source>
        <translation>geef de map of zip met TASKDATA.XML en de TLG-bestanden, een rosbag2-map, of één bestand</translation>
    </message>
    <message>
        <source>give the points in degrees (WGS84), longitude in lon and latitude in lat</source>
        <translation>geef de punten in graden (WGS84), de lengtegraad in lon en de breedtegraad in lat</translation>
    </message>
    <message>
        <source>give true or false</source>
        <translation>geef true of false</translation>
    </message>
    <message>
        <source>give two points at least 1 m apart</source>
        <translation>geef twee punten die minstens 1 m uit elkaar liggen</translation>
    </message>
    <message>
        <source>give x_m and y_m in the plan&apos;s frame, or longitude and latitude</source>
        <translation>geef x_m en y_m in het stelsel van het plan, of lengte- en breedtegraad</translation>
    </message>
    <message>
        <source>guidance lines without two points</source>
        <translation>stuurlijnen zonder twee punten</translation>
    </message>
    <message>
        <source>guidance patterns whose points do not fit their kind</source>
        <translation>stuurlijnen waarvan de punten niet bij hun soort passen</translation>
    </message>
    <message>
        <source>guidance patterns without a line</source>
        <translation>stuurlijnen zonder verloop</translation>
    </message>
    <message>
        <source>headland pass %1</source>
        <translation>kopakkergang %1</translation>
    </message>
    <message>
        <source>hole %1 encloses no area and was left out</source>
        <translation>gat %1 sluit geen oppervlakte in en is weggelaten</translation>
    </message>
    <message>
        <source>it does not say in which coordinate system it is</source>
        <translation>het zegt niet in welk coördinatenstelsel het is</translation>
    </message>
    <message>
        <source>it does not say what it is</source>
        <translation>het zegt niet wat het is</translation>
    </message>
    <message>
        <source>it does not say which field it belongs to</source>
        <translation>het zegt niet bij welk perceel het hoort</translation>
    </message>
    <message>
        <source>it has %1 by %2 pixels</source>
        <translation>het heeft %1 bij %2 pixels</translation>
    </message>
    <message>
        <source>it has %1: %2</source>
        <translation>het heeft %1: %2</translation>
    </message>
    <message>
        <source>it has another coordinate system than the file</source>
        <translation>het heeft een ander coördinatenstelsel dan het bestand</translation>
    </message>
    <message>
        <source>it has more than %1 parts</source>
        <translation>het heeft meer dan %1 delen</translation>
    </message>
    <message>
        <source>it has no heights where the field is</source>
        <translation>het heeft geen hoogten waar het perceel ligt</translation>
    </message>
    <message>
        <source>it has no shape</source>
        <translation>het heeft geen vorm</translation>
    </message>
    <message>
        <source>it has: %1</source>
        <translation>het heeft: %1</translation>
    </message>
    <message>
        <source>it holds more than %1 files</source>
        <translation>er zitten meer dan %1 bestanden in</translation>
    </message>
    <message>
        <source>it holds more than %1 positions</source>
        <translation>het bevat meer dan %1 posities</translation>
    </message>
    <message>
        <source>it is a line at %1 without a width</source>
        <translation>het is een lijn bij %1 zonder breedte</translation>
    </message>
    <message>
        <source>it is a point at %1 without a size</source>
        <translation>het is een punt bij %1 zonder omvang</translation>
    </message>
    <message>
        <source>it is no closed line</source>
        <translation>het is geen gesloten lijn</translation>
    </message>
    <message>
        <source>it is no raster of heights</source>
        <translation>het is geen hoogteraster</translation>
    </message>
    <message>
        <source>it is no rosbag2 that can be read (%1)</source>
        <translation>dit is geen leesbare rosbag2 (%1)</translation>
    </message>
    <message>
        <source>it is not a length</source>
        <translation>dat is geen lengte</translation>
    </message>
    <message>
        <source>it is not what a plan&apos;s is</source>
        <translation>dat is niet zoals in een plan</translation>
    </message>
    <message>
        <source>it lies in none of the %1 fields</source>
        <translation>het ligt in geen van de %1 percelen</translation>
    </message>
    <message>
        <source>it lies outside the field</source>
        <translation>het ligt buiten het perceel</translation>
    </message>
    <message>
        <source>it may be damaged; copy or export it again</source>
        <translation>misschien is die beschadigd; kopieer of exporteer opnieuw</translation>
    </message>
    <message>
        <source>it names no local frame</source>
        <translation>het noemt geen lokaal coördinatenstelsel</translation>
    </message>
    <message>
        <source>it names no machine</source>
        <translation>het noemt geen machine</translation>
    </message>
    <message>
        <source>it needs latitude and longitude, as in 52.09,5.66</source>
        <translation>die heeft breedte- en lengtegraad nodig, zoals 52.09,5.66</translation>
    </message>
    <message>
        <source>its buffer is not a length</source>
        <translation>de afstand is geen lengte</translation>
    </message>
    <message>
        <source>its compression &apos;%1&apos; is not known</source>
        <translation>de compressie &apos;%1&apos; is onbekend</translation>
    </message>
    <message>
        <source>its overhang is not a length from 0 to 100 m</source>
        <translation>de overhang is geen lengte van 0 tot 100 m</translation>
    </message>
    <message>
        <source>its coordinate system &apos;%1&apos; cannot be turned into WGS84</source>
        <translation>het coördinatenstelsel ‘%1’ kan niet naar WGS84 omgerekend worden</translation>
    </message>
    <message>
        <source>its coordinate system &apos;%1&apos; is not known</source>
        <translation>het coördinatenstelsel ‘%1’ is niet bekend</translation>
    </message>
    <message>
        <source>its coordinate system cannot be turned into WGS84</source>
        <translation>het coördinatenstelsel kan niet naar WGS84 omgerekend worden</translation>
    </message>
    <message>
        <source>its coordinate system would have to be fetched from &apos;%1&apos;</source>
        <translation>het coördinatenstelsel zou van ‘%1’ gehaald moeten worden</translation>
    </message>
    <message>
        <source>its file is missing</source>
        <translation>het bestand ontbreekt</translation>
    </message>
    <message>
        <source>its heights cannot be read</source>
        <translation>de hoogten kunnen niet gelezen worden</translation>
    </message>
    <message>
        <source>its holes leave nothing of it</source>
        <translation>de gaten laten er niets van over</translation>
    </message>
    <message>
        <source>its kind &apos;%1&apos; is not known</source>
        <translation>de soort ‘%1’ is niet bekend</translation>
    </message>
    <message>
        <source>its points enclose no area</source>
        <translation>de punten sluiten geen oppervlakte in</translation>
    </message>
    <message>
        <source>its width is not a length</source>
        <translation>de breedte is geen lengte</translation>
    </message>
    <message>
        <source>keep one of them</source>
        <translation>houd er een van</translation>
    </message>
    <message>
        <source>keep the .shp, .shx, .dbf and .prj files together</source>
        <translation>houd .shp, .shx, .dbf en .prj bij elkaar</translation>
    </message>
    <message>
        <source>leave it out, or give a project of the window</source>
        <translation>laat het weg, of geef een project van het venster</translation>
    </message>
    <message>
        <source>leaves the field by %1</source>
        <translation>komt %1 buiten het perceel</translation>
    </message>
    <message>
        <source>left out: %1</source>
        <translation>weggelaten: %1</translation>
    </message>
    <message>
        <source>left out: %1 %2</source>
        <translation>weggelaten: %1 %2</translation>
    </message>
    <message>
        <source>line %1 is left out: it is damaged</source>
        <translation>regel %1 is weggelaten: die is beschadigd</translation>
    </message>
    <message>
        <source>line %1, column %2</source>
        <translation>regel %1, kolom %2</translation>
    </message>
    <message>
        <source>lines in WGS84 such as MULTILINESTRING ((4.1 52.0, 4.2 52.0), (4.1 52.1, 4.2 52.1))</source>
        <translation>lijnen in WGS84 zoals MULTILINESTRING ((4.1 52.0, 4.2 52.0), (4.1 52.1, 4.2 52.1))</translation>
    </message>
    <message>
        <source>lines that guide nothing</source>
        <translation>lijnen waarlangs niet gestuurd wordt</translation>
    </message>
    <message>
        <source>lon=&quot;%1&quot; lat=&quot;%2&quot; is no place on Earth</source>
        <translation>lon=&quot;%1&quot; lat=&quot;%2&quot; is geen plek op aarde</translation>
    </message>
    <message>
        <source>look for a missing comma, quote or brace just before it</source>
        <translation>zoek er vlak voor naar een ontbrekende komma, aanhalingsteken of accolade</translation>
    </message>
    <message>
        <source>most of its lines are not JSON</source>
        <translation>de meeste regels zijn geen JSON</translation>
    </message>
    <message>
        <source>most of its sentences have a wrong checksum</source>
        <translation>de meeste zinnen hebben een verkeerde controlesom</translation>
    </message>
    <message>
        <source>move one of the points there, so that it is clear which side is field</source>
        <translation>verplaats daar een punt, zodat duidelijk is welke kant perceel is</translation>
    </message>
    <message>
        <source>move or delete it</source>
        <translation>verplaats of verwijder het</translation>
    </message>
    <message>
        <source>name a raster of heights, such as a GeoTIFF</source>
        <translation>noem een hoogteraster, zoals een GeoTIFF</translation>
    </message>
    <message>
        <source>name each swath once</source>
        <translation>noem elke werkgang één keer</translation>
    </message>
    <message>
        <source>name each swath once, with a minus where it is driven backwards</source>
        <translation>noem elke werkgang één keer, met een min waar hij andersom gereden wordt</translation>
    </message>
    <message>
        <source>name one, such as GeoJSON with a LineString for each row</source>
        <translation>noem er een, zoals GeoJSON met een LineString per rij</translation>
    </message>
    <message>
        <source>name the columns in the first row</source>
        <translation>noem de kolommen in de eerste rij</translation>
    </message>
    <message>
        <source>name the columns, for example time,lon,lat,speed_kmh in the first line</source>
        <translation>noem de kolommen, bijvoorbeeld time,lon,lat,speed_kmh op de eerste regel</translation>
    </message>
    <message>
        <source>name the folder of a plan, as furrow-cli plan writes it</source>
        <translation>noem de map van een plan, zoals furrow-cli plan die schrijft</translation>
    </message>
    <message>
        <source>neither turning radius nor steering angle is given</source>
        <translation>er is geen draaistraal en geen stuurhoek opgegeven</translation>
    </message>
    <message>
        <source>no boundary can be read from this file (%1)</source>
        <translation>uit dit bestand kan geen perceelsgrens gelezen worden (%1)</translation>
    </message>
    <message>
        <source>no header names a longitude and a latitude (or x_m and y_m)</source>
        <translation>geen kopregel noemt een lengte- en breedtegraad (of x_m en y_m)</translation>
    </message>
    <message>
        <source>no pixel of the picture is worked</source>
        <translation>geen pixel van het beeld is bewerkt</translation>
    </message>
    <message>
        <source>no row of this table has a position</source>
        <translation>geen rij van deze tabel heeft een positie</translation>
    </message>
    <message>
        <source>no swath fits inside the headland</source>
        <translation>er past geen werkgang in de binnenakker</translation>
    </message>
    <message>
        <source>no topic of this bag has a position</source>
        <translation>geen topic van deze bag heeft een positie</translation>
    </message>
    <message>
        <source>none of its %1 RMC and GGA sentences has a position</source>
        <translation>geen van de %1 RMC- en GGA-zinnen heeft een positie</translation>
    </message>
    <message>
        <source>none of its %1 position reports has a position</source>
        <translation>geen van de %1 positiemeldingen heeft een positie</translation>
    </message>
    <message>
        <source>none of its %1 time logs holds a position</source>
        <translation>geen van de %1 tijdlogs bevat een positie</translation>
    </message>
    <message>
        <source>none of the tracks has more than one position</source>
        <translation>geen van de ritten heeft meer dan één positie</translation>
    </message>
    <message>
        <source>nothing is left of the land inside of this track</source>
        <translation>van het land binnen deze rit blijft niets over</translation>
    </message>
    <message>
        <source>obstacle %1</source>
        <translation>obstakel %1</translation>
    </message>
    <message>
        <source>obstacles outside the boundary</source>
        <translation>obstakels buiten de perceelsgrens</translation>
    </message>
    <message>
        <source>obstacles that are holes already</source>
        <translation>obstakels die al gaten zijn</translation>
    </message>
    <message>
        <source>one of its choices</source>
        <translation>een van de keuzes</translation>
    </message>
    <message>
        <source>only files on this computer are read</source>
        <translation>alleen bestanden op deze computer worden gelezen</translation>
    </message>
    <message>
        <source>only the fields of a project have plans</source>
        <translation>alleen percelen van een project hebben plannen</translation>
    </message>
    <message>
        <source>open a file of your own</source>
        <translation>open een eigen bestand</translation>
    </message>
    <message>
        <source>open it as a field boundary, or choose another file</source>
        <translation>open het als perceelsgrens, of kies een ander bestand</translation>
    </message>
    <message>
        <source>open it with a newer Furrow; the file was left as it is</source>
        <translation>open het met een nieuwere Furrow; het bestand is gebleven zoals het was</translation>
    </message>
    <message>
        <source>open the field of that plan first, or record longitude and latitude</source>
        <translation>open eerst het perceel van dat plan, of neem lengte- en breedtegraad op</translation>
    </message>
    <message>
        <source>opennav_coverage goal</source>
        <translation>opennav_coverage-doel</translation>
    </message>
    <message>
        <source>opennav_coverage lays swaths and turns of its own from the goal; they need not be those of this plan.</source>
        <translation>opennav_coverage legt uit het doel eigen werkgangen en draaien; dat hoeven niet die van dit plan te zijn.</translation>
    </message>
    <message>
        <source>part %1</source>
        <translation>deel %1</translation>
    </message>
    <message>
        <source>part %1, point %2</source>
        <translation>deel %1, punt %2</translation>
    </message>
    <message>
        <source>path.csv has %1 segments and plan.geojson %2</source>
        <translation>path.csv heeft %1 stukken en plan.geojson %2</translation>
    </message>
    <message>
        <source>per m²</source>
        <translation>per m²</translation>
    </message>
    <message>
        <source>pivot needs its centre</source>
        <translation>cirkels hebben hun midden nodig</translation>
    </message>
    <message>
        <source>plan the field first: furrow-cli plan FIELD --out plan</source>
        <translation>plan eerst het perceel: furrow-cli plan FIELD --out plan</translation>
    </message>
    <message>
        <source>points that are no gates</source>
        <translation>punten die geen inritten zijn</translation>
    </message>
    <message>
        <source>polygons of a kind that is not used</source>
        <translation>polygonen van een niet gebruikte soort</translation>
    </message>
    <message>
        <source>put the EPSG code into its name, as in field_EPSG32632.dxf</source>
        <translation>zet de EPSG-code in de naam, zoals field_EPSG32632.dxf</translation>
    </message>
    <message>
        <source>record %1 has a value that its header does not name</source>
        <translation>record %1 heeft een waarde die de kop niet noemt</translation>
    </message>
    <message>
        <source>record a position every second, or every few metres</source>
        <translation>neem elke seconde of om de paar meter een positie op</translation>
    </message>
    <message>
        <source>record or draw its boundary first</source>
        <translation>neem eerst de perceelsgrens op of teken die</translation>
    </message>
    <message>
        <source>record or export it again</source>
        <translation>neem het opnieuw op of exporteer het opnieuw</translation>
    </message>
    <message>
        <source>record sensor_msgs/NavSatFix, nav_msgs/Odometry, geometry_msgs/PoseStamped or nav_msgs/Path</source>
        <translation>neem sensor_msgs/NavSatFix, nav_msgs/Odometry, geometry_msgs/PoseStamped of nav_msgs/Path op</translation>
    </message>
    <message>
        <source>record the log again with a receiver that has a fix</source>
        <translation>neem de log opnieuw op met een ontvanger die zijn positie kent</translation>
    </message>
    <message>
        <source>record the positions without pictures and point clouds</source>
        <translation>neem de posities op zonder beelden en puntenwolken</translation>
    </message>
    <message>
        <source>record with a correction signal (EGNOS, RTK), or under an open sky</source>
        <translation>neem op met een correctiesignaal (EGNOS, RTK), of onder open hemel</translation>
    </message>
    <message>
        <source>record with zstd, lz4 or no compression</source>
        <translation>neem op met zstd, lz4 of zonder compressie</translation>
    </message>
    <message>
        <source>remove it from the file, or add its field</source>
        <translation>verwijder het uit het bestand, of voeg het perceel toe</translation>
    </message>
    <message>
        <source>remove it; keys look like operating_width_m, vehicle_width_m, can_reverse</source>
        <translation>verwijder het; sleutels zien eruit als operating_width_m, vehicle_width_m, can_reverse</translation>
    </message>
    <message>
        <source>restore a copy of the file</source>
        <translation>zet een kopie van het bestand terug</translation>
    </message>
    <message>
        <source>rings that overlap each other were joined</source>
        <translation>ringen die elkaar overlappen zijn samengevoegd</translation>
    </message>
    <message>
        <source>rings with fewer than three corners</source>
        <translation>ringen met minder dan drie hoeken</translation>
    </message>
    <message>
        <source>rows needs a file of lines</source>
        <translation>rijen hebben een bestand met lijnen nodig</translation>
    </message>
    <message>
        <source>save it again in WGS84</source>
        <translation>sla het opnieuw op in WGS84</translation>
    </message>
    <message>
        <source>save it as GeoTIFF, or with a world file in degrees</source>
        <translation>sla het op als GeoTIFF, of met een worldbestand in graden</translation>
    </message>
    <message>
        <source>save the field again, or remove this file</source>
        <translation>sla het perceel opnieuw op of verwijder dit bestand</translation>
    </message>
    <message>
        <source>save the project, and free some space</source>
        <translation>sla het project op en maak ruimte vrij</translation>
    </message>
    <message>
        <source>say how far to keep from it (buffer_m), or draw its outline</source>
        <translation>geef aan hoeveel afstand ervan te houden is (buffer_m), of teken de omtrek</translation>
    </message>
    <message>
        <source>several fields are called &apos;%1&apos;</source>
        <translation>meerdere percelen heten ‘%1’</translation>
    </message>
    <message>
        <source>several plans of &apos;%1&apos; are called &apos;%2&apos;</source>
        <translation>meerdere plannen van ‘%1’ heten ‘%2’</translation>
    </message>
    <message>
        <source>simplify it to at most a million</source>
        <translation>vereenvoudig die tot hoogstens een miljoen</translation>
    </message>
    <message>
        <source>such as LINESTRING (4.1 52.0, 4.2 52.0)</source>
        <translation>zoals LINESTRING (4.1 52.0, 4.2 52.0)</translation>
    </message>
    <message>
        <source>such as POINT (4.1 52.0)</source>
        <translation>zoals POINT (4.1 52.0)</translation>
    </message>
    <message>
        <source>swath %1</source>
        <translation>werkgang %1</translation>
    </message>
    <message>
        <source>swath %1 is named twice</source>
        <translation>werkgang %1 is twee keer genoemd</translation>
    </message>
    <message>
        <source>take it away</source>
        <translation>verwijder het</translation>
    </message>
    <message>
        <source>take off its write protection, or use another one</source>
        <translation>haal de schrijfbeveiliging eraf, of gebruik een andere</translation>
    </message>
    <message>
        <source>take off the write protection of the stick</source>
        <translation>haal de schrijfbeveiliging van de stick af</translation>
    </message>
    <message>
        <source>take the track as driven around the field, or record the work</source>
        <translation>neem de rit als rondgang om het perceel, of neem het werk op</translation>
    </message>
    <message>
        <source>the .shx file that belongs to it is missing</source>
        <translation>het bijbehorende .shx-bestand ontbreekt</translation>
    </message>
    <message>
        <source>the GPX file is damaged (%1)</source>
        <translation>het GPX-bestand is beschadigd (%1)</translation>
    </message>
    <message>
        <source>the GPX file is larger than 256 MiB</source>
        <translation>het GPX-bestand is groter dan 256 MiB</translation>
    </message>
    <message>
        <source>the boundary</source>
        <translation>de perceelsgrens</translation>
    </message>
    <message>
        <source>the boundary has %1 points</source>
        <translation>de perceelsgrens heeft %1 punten</translation>
    </message>
    <message>
        <source>the boundary has no such edge</source>
        <translation>de perceelsgrens heeft die zijde niet</translation>
    </message>
    <message>
        <source>the boundary is that of the guidance group; the field itself has none</source>
        <translation>de perceelsgrens is die van de stuurlijngroep; het perceel zelf heeft er geen</translation>
    </message>
    <message>
        <source>the coordinate system that it names is not known</source>
        <translation>het coördinatenstelsel dat het noemt is niet bekend</translation>
    </message>
    <message>
        <source>the coordinates lie outside longitude -180 to 180 and latitude -90 to 90</source>
        <translation>de coördinaten liggen buiten de lengtegraden -180 tot 180 en breedtegraden -90 tot 90</translation>
    </message>
    <message>
        <source>the curve bends more sharply than this machine can follow (%1 of radius)</source>
        <translation>de curve is krapper dan deze machine kan volgen (straal %1)</translation>
    </message>
    <message>
        <source>the curve crosses itself, %1 from its start</source>
        <translation>de curve kruist zichzelf, %1 vanaf het begin</translation>
    </message>
    <message>
        <source>the curves from line %1 on are left out: it is damaged</source>
        <translation>de curves vanaf regel %1 zijn weggelaten: die is beschadigd</translation>
    </message>
    <message>
        <source>the edge cannot lie that far from the line</source>
        <translation>de rand kan niet zo ver van de lijn liggen</translation>
    </message>
    <message>
        <source>the end</source>
        <translation>einde</translation>
    </message>
    <message>
        <source>the field &apos;%1&apos; has no boundary</source>
        <translation>perceel ‘%1’ heeft geen perceelsgrens</translation>
    </message>
    <message>
        <source>the field &apos;%1&apos; has no plan &apos;%2&apos;</source>
        <translation>perceel ‘%1’ heeft geen plan ‘%2’</translation>
    </message>
    <message>
        <source>the field &apos;%1&apos; is left out: %2</source>
        <translation>perceel ‘%1’ is weggelaten: %2</translation>
    </message>
    <message>
        <source>the field has neither boundary nor guidance line</source>
        <translation>het perceel heeft geen perceelsgrens en geen stuurlijn</translation>
    </message>
    <message>
        <source>the field has no boundary</source>
        <translation>het perceel heeft geen perceelsgrens</translation>
    </message>
    <message>
        <source>the field is more than 100 km across; %1 is farthest from the others</source>
        <translation>het perceel reikt over meer dan 100 km; %1 ligt het verst van de andere punten</translation>
    </message>
    <message>
        <source>the field is nowhere as wide as the machine (%1%2)</source>
        <translation>het perceel is nergens zo breed als de machine (%1%2)</translation>
    </message>
    <message>
        <source>the fields in this task data have neither boundary nor guidance line</source>
        <translation>de percelen in deze taakgegevens hebben geen perceelsgrens en geen stuurlijn</translation>
    </message>
    <message>
        <source>the file cannot be read</source>
        <translation>het bestand kan niet gelezen worden</translation>
    </message>
    <message>
        <source>the file has %1 fields: %2</source>
        <translation>het bestand heeft %1 percelen: %2</translation>
    </message>
    <message>
        <source>the file is damaged</source>
        <translation>het bestand is beschadigd</translation>
    </message>
    <message>
        <source>the file is damaged (%1)</source>
        <translation>het bestand is beschadigd (%1)</translation>
    </message>
    <message>
        <source>the file is damaged here</source>
        <translation>het bestand is hier beschadigd</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>het bestand is leeg</translation>
    </message>
    <message>
        <source>the file is empty or cannot be read</source>
        <translation>het bestand is leeg of niet te lezen</translation>
    </message>
    <message>
        <source>the file is larger than 1 GiB</source>
        <translation>het bestand is groter dan 1 GiB</translation>
    </message>
    <message>
        <source>the file may be cut off or damaged; copy or export it again</source>
        <translation>het bestand is misschien afgekapt of beschadigd; kopieer of exporteer het opnieuw</translation>
    </message>
    <message>
        <source>the file may be cut off or damaged; export it again</source>
        <translation>het bestand is misschien afgekapt of beschadigd; exporteer het opnieuw</translation>
    </message>
    <message>
        <source>the folder or zip cannot be read</source>
        <translation>de map of zip kan niet gelezen worden</translation>
    </message>
    <message>
        <source>the gap is out of range</source>
        <translation>de opening valt buiten het bereik</translation>
    </message>
    <message>
        <source>the headland is left out: line %1 is damaged</source>
        <translation>de kopakker is weggelaten: regel %1 is beschadigd</translation>
    </message>
    <message>
        <source>the headland of edge %1</source>
        <translation>de kopakker langs zijde %1</translation>
    </message>
    <message>
        <source>the implement was nowhere down on this track</source>
        <translation>het werktuig was op deze rit nergens neergelaten</translation>
    </message>
    <message>
        <source>the log is cut off in record %1</source>
        <translation>de log is afgekapt in record %1</translation>
    </message>
    <message>
        <source>the operating width is out of range</source>
        <translation>de werkbreedte valt buiten het bereik</translation>
    </message>
    <message>
        <source>the overhang of edge %1</source>
        <translation>de overhang van zijde %1</translation>
    </message>
    <message>
        <source>edge %1</source>
        <translation>zijde %1</translation>
    </message>
    <message>
        <source>the key is there twice</source>
        <translation>de sleutel staat er twee keer</translation>
    </message>
    <message>
        <source>the line after StartFix is no place</source>
        <translation>de regel na StartFix is geen plaats</translation>
    </message>
    <message>
        <source>the line crosses itself at %1</source>
        <translation>de lijn kruist zichzelf bij %1</translation>
    </message>
    <message>
        <source>the line touches or crosses itself by a sliver; taken apart there</source>
        <translation>de lijn raakt of kruist zichzelf heel licht; daar uit elkaar gehaald</translation>
    </message>
    <message>
        <source>the lines from line %1 on are left out: it is damaged</source>
        <translation>de lijnen vanaf regel %1 zijn weggelaten: die is beschadigd</translation>
    </message>
    <message>
        <source>the machine (%1 wide, %2 long%3) fits nowhere into the field</source>
        <translation>de machine (%1 breed, %2 lang%3) past nergens in het perceel</translation>
    </message>
    <message>
        <source>the name of a gate or a point in WGS84 such as POINT (4.1 52.0)</source>
        <translation>de naam van een inrit of een punt in WGS84 zoals POINT (4.1 52.0)</translation>
    </message>
    <message>
        <source>the number after SRID= is no coordinate system that is known</source>
        <translation>het getal na SRID= is geen bekend coördinatenstelsel</translation>
    </message>
    <message>
        <source>the obstacles leave nothing of the field</source>
        <translation>de obstakels laten niets van het perceel over</translation>
    </message>
    <message>
        <source>the operating width is missing</source>
        <translation>de werkbreedte ontbreekt</translation>
    </message>
    <message>
        <source>the part %1 is left out: %2</source>
        <translation>deel %1 is weggelaten: %2</translation>
    </message>
    <message>
        <source>the path of a file</source>
        <translation>het pad van een bestand</translation>
    </message>
    <message>
        <source>the picture cannot be read (%1)</source>
        <translation>het beeld kan niet gelezen worden (%1)</translation>
    </message>
    <message>
        <source>the picture does not say where it lies</source>
        <translation>het beeld zegt niet waar het ligt</translation>
    </message>
    <message>
        <source>the picture does not say which coordinate system it uses</source>
        <translation>het beeld zegt niet welk coördinatenstelsel het gebruikt</translation>
    </message>
    <message>
        <source>the picture is damaged</source>
        <translation>het beeld is beschadigd</translation>
    </message>
    <message>
        <source>the place lies outside of the field</source>
        <translation>de plaats ligt buiten het perceel</translation>
    </message>
    <message>
        <source>the plan gives no reason</source>
        <translation>het plan noemt geen reden</translation>
    </message>
    <message>
        <source>the positions of this track are metres in the plan that was driven, not places on Earth</source>
        <translation>de posities van deze rit zijn meters in het gereden plan, geen plekken op aarde</translation>
    </message>
    <message>
        <source>the recorded path is left out: it is damaged</source>
        <translation>het opgenomen pad is weggelaten: het is beschadigd</translation>
    </message>
    <message>
        <source>the recording cannot be made: %1</source>
        <translation>de opname kan niet gemaakt worden: %1</translation>
    </message>
    <message>
        <source>the recording is cut off in the middle of a record</source>
        <translation>de opname is midden in een record afgekapt</translation>
    </message>
    <message>
        <source>the recording is cut off: its end is missing</source>
        <translation>de opname is afgekapt: het einde ontbreekt</translation>
    </message>
    <message>
        <source>the sample field cannot be read</source>
        <translation>het voorbeeldperceel kan niet worden gelezen</translation>
    </message>
    <message>
        <source>the shape could not be computed with (%1)</source>
        <translation>met de vorm kon niet gerekend worden (%1)</translation>
    </message>
    <message>
        <source>the start</source>
        <translation>begin</translation>
    </message>
    <message>
        <source>the stick does not answer any more (%1)</source>
        <translation>de stick antwoordt niet meer (%1)</translation>
    </message>
    <message>
        <source>the stick has %1 MB free, and %2 MB are needed</source>
        <translation>op de stick is %1 MB vrij, en er is %2 MB nodig</translation>
    </message>
    <message>
        <source>the stick is damaged: use another one</source>
        <translation>de stick is beschadigd: gebruik een andere</translation>
    </message>
    <message>
        <source>the stick is write-protected</source>
        <translation>de stick is tegen schrijven beveiligd</translation>
    </message>
    <message>
        <source>the strips of this track lie nowhere beside each other</source>
        <translation>de stroken van deze rit liggen nergens naast elkaar</translation>
    </message>
    <message>
        <source>the swaths are left out: %1</source>
        <translation>de werkgangen zijn weggelaten: %1</translation>
    </message>
    <message>
        <source>the table has neither a column WKT nor columns lon and lat</source>
        <translation>de tabel heeft geen kolom WKT en geen kolommen lon en lat</translation>
    </message>
    <message>
        <source>the track does not come to the plan anywhere</source>
        <translation>de rit komt nergens bij het plan</translation>
    </message>
    <message>
        <source>the track goes around nothing: from its end to its beginning %1 are missing</source>
        <translation>de rit gaat nergens omheen: van het einde naar het begin ontbreekt %1</translation>
    </message>
    <message numerus="yes">
        <source>the track has %n positions only</source>
        <translation>
            <numerusform>de rit heeft maar %n positie</numerusform>
            <numerusform>de rit heeft maar %n posities</numerusform>
        </translation>
    </message>
    <message>
        <source>the transfer after %1</source>
        <translation>de verplaatsing na %1</translation>
    </message>
    <message>
        <source>the transfer at %1</source>
        <translation>de verplaatsing bij %1</translation>
    </message>
    <message>
        <source>the turn after %1</source>
        <translation>de draai na %1</translation>
    </message>
    <message>
        <source>the turn at %1</source>
        <translation>de draai bij %1</translation>
    </message>
    <message>
        <source>the way to refill</source>
        <translation>de rit om bij te vullen</translation>
    </message>
    <message>
        <source>the zip cannot be made: %1</source>
        <translation>de zip kan niet gemaakt worden: %1</translation>
    </message>
    <message>
        <source>there is no &apos;%1&apos;</source>
        <translation>er is geen ‘%1’</translation>
    </message>
    <message>
        <source>there is no &apos;%1&apos; in a machine</source>
        <translation>in een machine bestaat geen ‘%1’</translation>
    </message>
    <message>
        <source>there is no Field.txt</source>
        <translation>Field.txt ontbreekt</translation>
    </message>
    <message>
        <source>there is no boundary</source>
        <translation>er is geen perceelsgrens</translation>
    </message>
    <message>
        <source>there is no boundary file in this zip</source>
        <translation>er zit geen bestand met perceelsgrenzen in deze zip</translation>
    </message>
    <message>
        <source>there is no edge %1</source>
        <translation>er is geen zijde %1</translation>
    </message>
    <message>
        <source>there is no field &apos;%1&apos; in the file</source>
        <translation>er is geen perceel ‘%1’ in het bestand</translation>
    </message>
    <message>
        <source>there is no field &apos;%1&apos; in the project</source>
        <translation>er is geen perceel ‘%1’ in het project</translation>
    </message>
    <message>
        <source>there is no field boundary in it</source>
        <translation>er zit geen perceelsgrens in</translation>
    </message>
    <message>
        <source>there is no field boundary in it, only %1</source>
        <translation>er zit geen perceelsgrens in, alleen %1</translation>
    </message>
    <message>
        <source>there is no field in this project</source>
        <translation>er is geen perceel in dit project</translation>
    </message>
    <message>
        <source>there is no field in this task data</source>
        <translation>er zit geen perceel in deze taakgegevens</translation>
    </message>
    <message>
        <source>there is no gate &apos;%1&apos;</source>
        <translation>er is geen inrit ‘%1’</translation>
    </message>
    <message>
        <source>there is no line in it</source>
        <translation>er zit geen lijn in</translation>
    </message>
    <message>
        <source>there is no machine &apos;%1&apos;</source>
        <translation>er is geen machine ‘%1’</translation>
    </message>
    <message>
        <source>there is no path in it</source>
        <translation>er zit geen traject in</translation>
    </message>
    <message>
        <source>there is no project format %1</source>
        <translation>er is geen projectformaat %1</translation>
    </message>
    <message>
        <source>there is no recorded track in it</source>
        <translation>er zit geen opgenomen rit in</translation>
    </message>
    <message>
        <source>there is no setting &apos;%1&apos;</source>
        <translation>er is geen instelling ‘%1’</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>dat bestand is er niet</translation>
    </message>
    <message>
        <source>there is no swath %1</source>
        <translation>er is geen werkgang %1</translation>
    </message>
    <message>
        <source>there is no terminal &apos;%1&apos;</source>
        <translation>er is geen terminal ‘%1’</translation>
    </message>
    <message>
        <source>there is no track in this GPX file</source>
        <translation>er zit geen rit in dit GPX-bestand</translation>
    </message>
    <message>
        <source>this XML file is cut off</source>
        <translation>dit XML-bestand is afgekapt</translation>
    </message>
    <message>
        <source>this XML is no task data</source>
        <translation>deze XML bevat geen taakgegevens</translation>
    </message>
    <message>
        <source>this folder holds no TASKDATA.XML, no field of AgOpenGPS and no AgGPS boundary</source>
        <translation>deze map bevat geen TASKDATA.XML, geen perceel van AgOpenGPS en geen AgGPS-perceelsgrens</translation>
    </message>
    <message>
        <source>this format holds the path of a plan, and there is only a field</source>
        <translation>dit formaat bevat het traject van een plan, en er is alleen een perceel</translation>
    </message>
    <message>
        <source>this is a bag of ROS 1</source>
        <translation>dit is een bag van ROS 1</translation>
    </message>
    <message>
        <source>this is a folder</source>
        <translation>dit is een map</translation>
    </message>
    <message>
        <source>this is no MCAP file of version 0</source>
        <translation>dit is geen MCAP-bestand van versie 0</translation>
    </message>
    <message>
        <source>this is no boundary file that can be read</source>
        <translation>dit is geen leesbaar bestand met perceelsgrenzen</translation>
    </message>
    <message>
        <source>this is no header of a time log</source>
        <translation>dit is geen kop van een tijdlog</translation>
    </message>
    <message>
        <source>this is no ordinary file</source>
        <translation>dit is geen gewoon bestand</translation>
    </message>
    <message>
        <source>this is no track that can be read</source>
        <translation>dit is geen leesbare rit</translation>
    </message>
    <message>
        <source>this is no zip of fields or recordings</source>
        <translation>dit is geen zip met percelen of opnamen</translation>
    </message>
    <message>
        <source>this is not JSON from here on</source>
        <translation>vanaf hier is dit geen JSON</translation>
    </message>
    <message>
        <source>this is not XML from here on</source>
        <translation>vanaf hier is dit geen XML</translation>
    </message>
    <message>
        <source>this is not a project of Furrow</source>
        <translation>dit is geen project van Furrow</translation>
    </message>
    <message>
        <source>this is not well-known text from here on</source>
        <translation>vanaf hier is dit geen well-known text</translation>
    </message>
    <message>
        <source>this place</source>
        <translation>deze plek</translation>
    </message>
    <message>
        <source>this polygon cannot be read</source>
        <translation>deze polygoon kan niet gelezen worden</translation>
    </message>
    <message>
        <source>this project file is damaged: %1</source>
        <translation>dit projectbestand is beschadigd: %1</translation>
    </message>
    <message>
        <source>this project is open in another window of Furrow</source>
        <translation>dit project is open in een ander venster van Furrow</translation>
    </message>
    <message>
        <source>this project was saved by a newer Furrow (format %1, this one knows %2)</source>
        <translation>dit project is door een nieuwere Furrow opgeslagen (formaat %1, deze kent %2)</translation>
    </message>
    <message>
        <source>topic %1 was left out for %2</source>
        <translation>topic %1 is weggelaten ten gunste van %2</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true of false</translation>
    </message>
    <message>
        <source>try another stick</source>
        <translation>probeer een andere stick</translation>
    </message>
    <message>
        <source>turn it into a rosbag2 with rosbags-convert</source>
        <translation>zet het om naar een rosbag2 met rosbags-convert</translation>
    </message>
    <message>
        <source>two points</source>
        <translation>twee punten</translation>
    </message>
    <message>
        <source>use another terminal&apos;s format, and report this</source>
        <translation>gebruik het formaat van een andere terminal, en meld dit</translation>
    </message>
    <message>
        <source>use one of: %1</source>
        <translation>gebruik een van: %1</translation>
    </message>
    <message>
        <source>use one of: %1; or give a machine file (.json)</source>
        <translation>gebruik een van: %1; of geef een machinebestand (.json)</translation>
    </message>
    <message>
        <source>use one or more of: %1</source>
        <translation>gebruik een of meer van: %1</translation>
    </message>
    <message>
        <source>use the numbers from 1 to %1</source>
        <translation>gebruik de nummers van 1 tot %1</translation>
    </message>
    <message>
        <source>was it pulled out? Plug it in again and write once more</source>
        <translation>is hij eruit getrokken? Steek hem er weer in en schrijf nog eens</translation>
    </message>
    <message>
        <source>what is on the stick is not the plan: %1</source>
        <translation>wat op de stick staat is niet het plan: %1</translation>
    </message>
    <message>
        <source>whole numbers divided by commas</source>
        <translation>hele getallen, gescheiden door komma&apos;s</translation>
    </message>
    <message>
        <source>worked pixels need a value other than 0</source>
        <translation>bewerkte pixels hebben een andere waarde dan 0 nodig</translation>
    </message>
    <message>
        <source>write POLYGON((lon lat, lon lat, ...))</source>
        <translation>schrijf POLYGON((lon lat, lon lat, ...))</translation>
    </message>
    <message>
        <source>write POLYGON((lon lat, lon lat, ...)), one polygon a line</source>
        <translation>schrijf POLYGON((lon lat, lon lat, ...)), één polygoon per regel</translation>
    </message>
    <message>
        <source>write it like LINESTRING (4.1 52.0, 4.2 52.0)</source>
        <translation>schrijf het als LINESTRING (4.1 52.0, 4.2 52.0)</translation>
    </message>
    <message>
        <source>write the plan again with furrow-cli plan</source>
        <translation>schrijf het plan opnieuw met furrow-cli plan</translation>
    </message>
    <message>
        <source>write {&quot;name&quot;: ..., &quot;operating_width_m&quot;: ...}</source>
        <translation>schrijf {&quot;name&quot;: ..., &quot;operating_width_m&quot;: ...}</translation>
    </message>
    <message>
        <source>a part of it cannot be read</source>
        <translation>een deel ervan is niet te lezen</translation>
    </message>
    <message>
        <source>a part of it is damaged: %1</source>
        <translation>een deel ervan is beschadigd: %1</translation>
    </message>
    <message>
        <source>a tile is damaged</source>
        <translation>een tegel is beschadigd</translation>
    </message>
    <message>
        <source>choose a file or a folder of tiles</source>
        <translation>kies een bestand of een map met tegels</translation>
    </message>
    <message>
        <source>choose the folder that holds the folders of the zooms, 0 to 24</source>
        <translation>kies de map waarin de mappen van de zoomniveaus staan, 0 tot 24</translation>
    </message>
    <message>
        <source>copy or export the file again</source>
        <translation>kopieer of exporteer het bestand opnieuw</translation>
    </message>
    <message>
        <source>give a GeoTIFF, MBTiles, or a folder of tiles</source>
        <translation>geef een GeoTIFF, MBTiles of een map met tegels</translation>
    </message>
    <message>
        <source>give a GeoTIFF, or export it again with its coordinate system</source>
        <translation>geef een GeoTIFF of exporteer het opnieuw met zijn coördinatenstelsel</translation>
    </message>
    <message>
        <source>it is damaged, or not a picture that Furrow can show</source>
        <translation>het is beschadigd of geen beeld dat Furrow kan tonen</translation>
    </message>
    <message>
        <source>it is no file</source>
        <translation>het is geen bestand</translation>
    </message>
    <message>
        <source>it is too large to be shown without overviews</source>
        <translation>het is te groot om zonder overzichten te worden getoond</translation>
    </message>
    <message>
        <source>its tiles are in degrees, not in web Mercator</source>
        <translation>de tegels zijn in graden, niet in Web Mercator</translation>
    </message>
    <message>
        <source>make the tiles again</source>
        <translation>maak de tegels opnieuw</translation>
    </message>
    <message>
        <source>make them again with the profile mercator, or give the raster itself</source>
        <translation>maak ze opnieuw met het profiel mercator of geef het raster zelf</translation>
    </message>
    <message>
        <source>open it again</source>
        <translation>open het opnieuw</translation>
    </message>
    <message>
        <source>put it back, or choose another one</source>
        <translation>zet het terug of kies iets anders</translation>
    </message>
    <message>
        <source>put it back, or remove the layer</source>
        <translation>zet het terug of verwijder de laag</translation>
    </message>
    <message>
        <source>save it in tiles and with overviews (gdal_translate -of COG)</source>
        <translation>sla het op in tegels en met overzichten (gdal_translate -of COG)</translation>
    </message>
    <message>
        <source>the file cannot be read any more</source>
        <translation>het bestand is niet meer te lezen</translation>
    </message>
    <message>
        <source>the file is not there any more</source>
        <translation>het bestand is er niet meer</translation>
    </message>
    <message>
        <source>the file was changed while it was open</source>
        <translation>het bestand is gewijzigd terwijl het open was</translation>
    </message>
    <message>
        <source>the folder is not there any more</source>
        <translation>de map is er niet meer</translation>
    </message>
    <message>
        <source>there are no tiles in this folder</source>
        <translation>er zitten geen tegels in deze map</translation>
    </message>
    <message>
        <source>there is no picture in it</source>
        <translation>er zit geen beeld in</translation>
    </message>
    <message>
        <source>there is no such file or folder</source>
        <translation>dit bestand of deze map bestaat niet</translation>
    </message>
    <message>
        <source>Receivers may refuse %1: %2.</source>
        <translation>Sommige terminals kunnen %1 weigeren: %2.</translation>
    </message>
    <message>
        <source>some systems do not allow a file of this name</source>
        <translation>sommige systemen staan geen bestand met deze naam toe</translation>
    </message>
    <message>
        <source>another file differs from it in capitals only</source>
        <translation>een ander bestand verschilt er alleen in hoofdletters van</translation>
    </message>
    <message>
        <source>%1 is far from the field</source>
        <translation>%1 ligt ver van het perceel</translation>
    </message>
    <message>
        <source>a ring of &apos;%1&apos; has fewer than three corners</source>
        <translation>een ring van ‘%1’ heeft minder dan drie hoeken</translation>
    </message>
    <message>
        <source>a ring of &apos;%1&apos; does not end where it begins</source>
        <translation>een ring van ‘%1’ eindigt niet waar hij begint</translation>
    </message>
    <message>
        <source>a ring of &apos;%1&apos; ends with its first point again</source>
        <translation>een ring van ‘%1’ herhaalt aan het eind zijn eerste punt</translation>
    </message>
    <message>
        <source>&apos;%1&apos; crosses itself, or a hole lies outside of it</source>
        <translation>‘%1’ kruist zichzelf, of een gat ligt erbuiten</translation>
    </message>
    <message>
        <source>a ring of &apos;%1&apos; runs the wrong way round</source>
        <translation>een ring van ‘%1’ loopt de verkeerde kant om</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is said to have %2, and has %3</source>
        <translation>‘%1’ zou %2 hebben en heeft %3</translation>
    </message>
    <message>
        <source>the name &apos;%1&apos; is longer than %2 characters</source>
        <translation>de naam ‘%1’ is langer dan %2 tekens</translation>
    </message>
    <message>
        <source>the name &apos;%1&apos; is there twice</source>
        <translation>de naam ‘%1’ komt twee keer voor</translation>
    </message>
    <message>
        <source>the name &apos;%1&apos; has letters beyond A to Z</source>
        <translation>de naam ‘%1’ heeft andere letters dan A tot Z</translation>
    </message>
    <message>
        <source>the name &apos;%1&apos; has characters that are no letters</source>
        <translation>de naam ‘%1’ heeft tekens die geen letters zijn</translation>
    </message>
    <message>
        <source>the line &apos;%1&apos; has fewer than two points</source>
        <translation>de lijn ‘%1’ heeft minder dan twee punten</translation>
    </message>
    <message>
        <source>A and B of &apos;%1&apos; are the same place</source>
        <translation>A en B van ‘%1’ zijn dezelfde plaats</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is said to be %2 wide</source>
        <translation>‘%1’ zou %2 breed zijn</translation>
    </message>
    <message>
        <source>%1 comes where %2 should</source>
        <translation>%1 staat waar %2 hoort te staan</translation>
    </message>
    <message>
        <source>%1 boundaries are in it, not %2</source>
        <translation>er staan %1 perceelsgrenzen in, niet %2</translation>
    </message>
    <message>
        <source>%1 holes are in it, not %2</source>
        <translation>er staan %1 gaten in, niet %2</translation>
    </message>
    <message>
        <source>%1 guidance lines are in it, not %2</source>
        <translation>er staan %1 stuurlijnen in, niet %2</translation>
    </message>
    <message>
        <source>%1 swaths are in it, not %2</source>
        <translation>er staan %1 werkgangen in, niet %2</translation>
    </message>
    <message>
        <source>%1 fields are in it, not %2</source>
        <translation>er staan %1 percelen in, niet %2</translation>
    </message>
    <message>
        <source>the path is not in it</source>
        <translation>het traject staat er niet in</translation>
    </message>
    <message>
        <source>place %1 of the path is not where the plan goes next</source>
        <translation>plaats %1 van het traject is niet waar het plan verdergaat</translation>
    </message>
    <message>
        <source>the path does not begin and end as the plan does</source>
        <translation>het traject begint en eindigt niet zoals het plan</translation>
    </message>
    <message>
        <source>the path is %1 long, not %2</source>
        <translation>het traject is %1 lang, niet %2</translation>
    </message>
    <message>
        <source>the time of place %1 of the path is before that of the place before</source>
        <translation>de tijd van plaats %1 van het traject ligt vóór die van de plaats ervoor</translation>
    </message>
    <message>
        <source>the times of the path stand still</source>
        <translation>de tijden van het traject staan stil</translation>
    </message>
    <message>
        <source>the heading at place %1 of the path does not point along it</source>
        <translation>de richting op plaats %1 van het traject wijst er niet langs</translation>
    </message>
    <message>
        <source>the speed at place %1 of the path is negative</source>
        <translation>de snelheid op plaats %1 van het traject is negatief</translation>
    </message>
    <message>
        <source>its largest speed is %1, not %2</source>
        <translation>de hoogste snelheid erin is %1, niet %2</translation>
    </message>
    <message>
        <source>line %1 is not as this format has it</source>
        <translation>regel %1 is niet volgens dit formaat</translation>
    </message>
    <message>
        <source>this is no %1</source>
        <translation>dit is geen %1</translation>
    </message>
    <message>
        <source>its content cannot be read</source>
        <translation>de inhoud kan niet worden gelezen</translation>
    </message>
    <message>
        <source>%1 is missing</source>
        <translation>%1 ontbreekt</translation>
    </message>
    <message>
        <source>%1 entries are announced, and %2 are there</source>
        <translation>er zijn %1 regels aangekondigd en er staan er %2</translation>
    </message>
    <message>
        <source>the id %1 is there twice</source>
        <translation>de id %1 komt twee keer voor</translation>
    </message>
    <message>
        <source>%1 is referred to and not there</source>
        <translation>er wordt naar %1 verwezen en het staat er niet</translation>
    </message>
    <message>
        <source>%1 is not known before version 4</source>
        <translation>%1 is vóór versie 4 niet bekend</translation>
    </message>
    <message>
        <source>&apos;%1&apos; holds a line of kind %2</source>
        <translation>‘%1’ bevat een lijn van soort %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is of kind %2 and its points are of kinds %3</source>
        <translation>‘%1’ is van soort %2 en de punten zijn van de soorten %3</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has %2 lines</source>
        <translation>‘%1’ heeft %2 lijnen</translation>
    </message>
    <message>
        <source>the headings of a ring do not point along it</source>
        <translation>de richtingen van een ring wijzen er niet langs</translation>
    </message>
    <message>
        <source>its shapes have heights or measures, which displays do not read</source>
        <translation>de vormen hebben hoogten of meetwaarden die displays niet lezen</translation>
    </message>
    <message>
        <source>this is the recording of a drive (%1), and no boundary</source>
        <translation>dit is de opname van een rit (%1) en geen perceelsgrens</translation>
    </message>
    <message>
        <source>give the field&apos;s boundary; furrow-cli compare lays a recording over a plan</source>
        <translation>geef de perceelsgrens; furrow-cli compare legt een opname over een plan</translation>
    </message>
    <message>
        <source>Raster mask</source>
        <translation>Rastermasker</translation>
    </message>
    <message>
        <source>What is worked and what is not, as a field.</source>
        <translation>Wat bewerkt wordt en wat niet, als perceel.</translation>
    </message>
    <message>
        <source>NMEA or gpsd log</source>
        <translation>NMEA- of gpsd-logboek</translation>
    </message>
    <message>
        <source>What a machine drove.</source>
        <translation>Wat een machine heeft gereden.</translation>
    </message>
    <message>
        <source>split line %1 ends %2 short of the headland and cuts nothing off there (decomposition.split); draw it right through</source>
        <translation>splitlijn %1 eindigt %2 voor de kopakker en snijdt daar niets af (decomposition.split); trek die helemaal door</translation>
    </message>
    <message>
        <source>split line %1 does not lie inside the headland and cuts nothing (decomposition.split)</source>
        <translation>splitlijn %1 ligt buiten de binnenakker en splitst niets (decomposition.split)</translation>
    </message>
    <message numerus="yes">
        <source>%n swaths shorter than %1 are left out</source>
        <translation>
            <numerusform>%n werkgang korter dan %1 vervalt</numerusform>
            <numerusform>%n werkgangen korter dan %1 vervallen</numerusform>
        </translation>
    </message>
    <message>
        <source>along the longest edge</source>
        <translation>langs de langste zijde</translation>
    </message>
    <message>
        <source>along an edge</source>
        <translation>langs een zijde</translation>
    </message>
    <message>
        <source>swaths run %1</source>
        <translation>de werkgangen lopen %1</translation>
    </message>
    <message>
        <source>swaths run %1; about %2 slower than with the best heading</source>
        <translation>de werkgangen lopen %1; ongeveer %2 langzamer dan met de beste richting</translation>
    </message>
    <message>
        <source>swaths run %1; as quick as with the best heading</source>
        <translation>de werkgangen lopen %1; even snel als met de beste richting</translation>
    </message>
    <message>
        <source>swaths run %1; %2 more than with the best heading</source>
        <translation>de werkgangen lopen %1; %2 meer dan met de beste richting</translation>
    </message>
    <message>
        <source>swaths run %1; as short as with the best heading</source>
        <translation>de werkgangen lopen %1; even kort als met de beste richting</translation>
    </message>
    <message>
        <source>Shortest swath</source>
        <translation>Kortste werkgang</translation>
    </message>
    <message>
        <source>Swaths that are shorter are left out; auto is the implement&apos;s length.</source>
        <translation>Kortere werkgangen vervallen; auto is de lengte van het werktuig.</translation>
    </message>
    <message>
        <source>Prefer edges within (%)</source>
        <translation>Zijden voorrang geven tot (%)</translation>
    </message>
    <message>
        <source>Swaths run along the field&apos;s longest edge, or another long one, where that takes no more than this above the best heading; 0 takes the best whatever its direction.</source>
        <translation>De werkgangen lopen langs de langste of een andere lange zijde van het perceel waar dat hoogstens zoveel meer kost dan de beste richting; 0 neemt de beste, hoe die ook ligt.</translation>
    </message>
    <message>
        <source>%1 are out of this machine&apos;s reach; the largest piece, %2, lies here.</source>
        <translation>%1 kan deze machine niet bereiken; het grootste stuk, %2, ligt hier.</translation>
    </message>
    <message>
        <source>The implement stands over the edge of the field or an obstacle, by up to %1, as the overhang allows.</source>
        <translation>Het werktuig steekt tot %1 over de rand van het perceel of een obstakel, zoals de overhang toestaat.</translation>
    </message>
    <message>
        <source>%1 within %2 of the centre: tighter than this machine can follow, left out</source>
        <translation>%1 binnen %2 van het midden: krapper dan deze machine kan volgen, weggelaten</translation>
    </message>
    <message numerus="yes">
        <source>%n circles</source>
        <translation>
            <numerusform>%n cirkel</numerusform>
            <numerusform>%n cirkels</numerusform>
        </translation>
    </message>
    <message>
        <source>A headland of %1 holds %2; it is %3 wide, and the rest belongs to the swaths</source>
        <translation>Een kopakker van %1 biedt plaats aan %2; hij is %3 breed, de rest is voor de werkgangen</translation>
    </message>
    <message>
        <source>Plan the sides of the obstacle apart.</source>
        <translation>Plan de kanten van het obstakel apart.</translation>
    </message>
    <message>
        <source>Set &quot;%1&quot; to &quot;%2&quot;: with that this is gone.</source>
        <translation>Zet ‘%1’ op ‘%2’: daarmee is dit verholpen.</translation>
    </message>
    <message>
        <source>Swaths along the longest edge</source>
        <translation>Werkgangen langs de langste zijde</translation>
    </message>
    <message>
        <source>Swaths at a bearing of %1</source>
        <translation>Werkgangen in richting %1</translation>
    </message>
    <message>
        <source>Take a machine that can.</source>
        <translation>Neem een machine die dat kan.</translation>
    </message>
    <message>
        <source>The field is too narrow for this machine to turn in: take a smaller machine.</source>
        <translation>Het perceel is te smal om met deze machine te keren: neem een kleinere machine.</translation>
    </message>
    <message>
        <source>The quickest</source>
        <translation>De snelste</translation>
    </message>
    <message>
        <source>give one of the two, or a width that holds just these passes</source>
        <translation>geef één van beide, of een breedte waar precies deze gangen in passen</translation>
    </message>
    <message>
        <source>headland.width_m and headland.passes do not agree</source>
        <translation>headland.width_m en headland.passes kloppen niet met elkaar</translation>
    </message>
    <message>
        <source>off</source>
        <translation>uit</translation>
    </message>
    <message>
        <source>on</source>
        <translation>aan</translation>
    </message>
    <message>
        <source>&quot;%1&quot;: &quot;%2&quot; is planned instead of &quot;%3&quot;: %4</source>
        <translation>‘%1’: ‘%2’ is gepland in plaats van ‘%3’: %4</translation>
    </message>
    <message>
        <source>%1 are planned instead of the heading with the best estimate: %2</source>
        <translation>%1 zijn gepland in plaats van de richting met de beste schatting: %2</translation>
    </message>
    <message>
        <source>it has fewer problems</source>
        <translation>zo zijn er minder problemen</translation>
    </message>
    <message>
        <source>it is %1 quicker</source>
        <translation>dat is %1 sneller</translation>
    </message>
    <message>
        <source>the margin and the obstacles that may be driven on leave nothing to work</source>
        <translation>de marge en de berijdbare obstakels laten niets over om te bewerken</translation>
    </message>
    <message>
        <source>make them smaller, or delete some of them</source>
        <translation>maak ze kleiner of verwijder er enkele</translation>
    </message>
    <message>
        <source>Without a headland (%1) there is no room to turn.</source>
        <translation>Zonder kopakker (%1) is er geen ruimte om te keren.</translation>
    </message>
    <message>
        <source>A turn of this machine needs %1 of headland; it is %2 (%3).</source>
        <translation>Een draai van deze machine vraagt %1 kopakker; het is %2 (%3).</translation>
    </message>
    <message>
        <source>The field is too narrow for this machine to turn in: take a smaller machine, or let the swaths run along the field (%1).</source>
        <translation>Het perceel is te smal om met deze machine te keren: neem een kleinere machine, of laat de werkgangen in de lengte van het perceel lopen (%1).</translation>
    </message>
    <message>
        <source>The field is too narrow for this machine to turn in: take a smaller machine or a smaller margin (%1).</source>
        <translation>Het perceel is te smal om met deze machine te keren: neem een kleinere machine of een kleinere marge (%1).</translation>
    </message>
    <message>
        <source>No passes are driven in the headland (%1).</source>
        <translation>Op de kopakker worden geen gangen gereden (%1).</translation>
    </message>
    <message>
        <source>The chosen swaths (%1) do not reach it.</source>
        <translation>De gekozen werkgangen (%1) komen er niet.</translation>
    </message>
    <message>
        <source>Land that is left is not finished if the machine may leave the field (%1).</source>
        <translation>Waar de machine het perceel mag verlaten (%1), worden resten niet nabewerkt.</translation>
    </message>
    <message>
        <source>Land that is left is not finished, because that is switched off (%1).</source>
        <translation>Resten worden niet nabewerkt, omdat dat uitgeschakeld is (%1).</translation>
    </message>
    <message>
        <source>choose a smaller machine or a smaller margin (%1)</source>
        <translation>kies een kleinere machine of een kleinere marge (%1)</translation>
    </message>
    <message>
        <source>no row is left inside the headland</source>
        <translation>er blijft geen rij over in de binnenakker</translation>
    </message>
    <message>
        <source>skip fewer rows</source>
        <translation>sla minder rijen over</translation>
    </message>
    <message>
        <source>no row lies inside the headland</source>
        <translation>er ligt geen rij in de binnenakker</translation>
    </message>
    <message>
        <source>check that the rows belong to this field, or choose a narrower headland</source>
        <translation>controleer of de rijen bij dit perceel horen, of kies een smallere kopakker</translation>
    </message>
    <message>
        <source>Quickest</source>
        <translation>Snelste</translation>
    </message>
    <message>
        <source>The kind below with which the whole plan takes the least time.</source>
        <translation>De soort waarmee het hele plan de minste tijd kost.</translation>
    </message>
    <message>
        <source>A headland of %1 is planned instead of one that is wide enough for turns: %2</source>
        <translation>Er wordt een kopakker van %1 gepland in plaats van een die breed genoeg is om te keren: %2</translation>
    </message>
    <message>
        <source>Drive more slowly there, or plan again.</source>
        <translation>Rijd daar langzamer of plan opnieuw.</translation>
    </message>
    <message>
        <source>The steering is too slow for the planned speed in %1; %2 is the worst and would need %3.</source>
        <translation>De besturing is te traag voor de geplande snelheid op %1; het ergst is %2, daar zou %3 nodig zijn.</translation>
    </message>
    <message>
        <source>The implement is folded on the way from %1 to %2.</source>
        <translation>Het werktuig is bij deze verplaatsing opgeklapt: %1 → %2.</translation>
    </message>
    <message>
        <source>The machine has to stand for %1 s to fold its implement or to unfold it, and does not in %2.</source>
        <translation>Om het werktuig op of uit te klappen moet de machine %1 s stilstaan; op %2 doet ze dat niet.</translation>
    </message>
    <message>
        <source>Time to fold</source>
        <translation>Tijd om op te klappen</translation>
    </message>
    <message>
        <source>To fold to the transport width, standing; the same again to unfold.</source>
        <translation>Opklappen tot transportbreedte, stilstaand; voor uitklappen nog eens zo lang.</translation>
    </message>
    <message>
        <source>Fuel</source>
        <translation>Brandstof</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Lengte</translation>
    </message>
    <message>
        <source>Saves</source>
        <translation>Bespaart</translation>
    </message>
    <message>
        <source>The least fuel for turns and ways; the least time if the machine has no fuel figures.</source>
        <translation>De minste brandstof voor draaien en verplaatsingen; de kortste tijd als de machine geen verbruikscijfers heeft.</translation>
    </message>
    <message>
        <source>The least time for turns and ways.</source>
        <translation>De kortste tijd voor draaien en verplaatsingen.</translation>
    </message>
    <message>
        <source>The shortest turns and ways.</source>
        <translation>De kortste draaien en verplaatsingen.</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tijd</translation>
    </message>
    <message>
        <source>What the order of the swaths is to save.</source>
        <translation>Wat de volgorde van de werkgangen moet besparen.</translation>
    </message>
    <message>
        <source>Every pattern is tried and improved; the plan tells how near the order is to the best one.</source>
        <translation>Alle patronen worden geprobeerd en verbeterd; het plan zegt hoe dicht de volgorde bij de beste ligt.</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>Vastgelegd</translation>
    </message>
    <message>
        <source>Swath numbers that follow each other in this order; a minus drives one the other way. The order of the others is searched.</source>
        <translation>Werkgangnummers die in deze volgorde op elkaar volgen; een min rijdt er een andersom. De volgorde van de andere wordt gezocht.</translation>
    </message>
    <message>
        <source>Ends of swaths</source>
        <translation>Uiteinden van werkgangen</translation>
    </message>
    <message>
        <source>Heading of blocks</source>
        <translation>Rijrichting van deelpercelen</translation>
    </message>
    <message>
        <source>Heading: bearing %1</source>
        <translation>Rijrichting: %1</translation>
    </message>
    <message>
        <source>Headland passes</source>
        <translation>Kopakkergangen</translation>
    </message>
    <message>
        <source>Order of swaths</source>
        <translation>Volgorde van werkgangen</translation>
    </message>
    <message>
        <source>Small obstacles</source>
        <translation>Kleine obstakels</translation>
    </message>
    <message>
        <source>First swath</source>
        <translation>Eerste werkgang</translation>
    </message>
    <message>
        <source>Last swath</source>
        <translation>Laatste werkgang</translation>
    </message>
    <message>
        <source>Most strips that are left between driven swaths for later. With 0 the machine never comes back to a gap, so that a second one can follow; auto sets no limit.</source>
        <translation>Hoogste aantal stroken dat tussen gereden werkgangen voor later open blijft. Met 0 keert de machine nooit terug naar een gat, zodat een tweede kan volgen; auto stelt geen grens.</translation>
    </message>
    <message>
        <source>Open strips</source>
        <translation>Open stroken</translation>
    </message>
    <message>
        <source>The number of the swath that is driven first; auto takes any.</source>
        <translation>Het nummer van de werkgang die het eerst wordt gereden; auto neemt een willekeurige.</translation>
    </message>
    <message>
        <source>The number of the swath that is driven last; auto takes any.</source>
        <translation>Het nummer van de werkgang die het laatst wordt gereden; auto neemt een willekeurige.</translation>
    </message>
    <message>
        <source>allow more open strips, or lock fewer swaths</source>
        <translation>sta meer open stroken toe, of leg minder werkgangen vast</translation>
    </message>
    <message>
        <source>name another swath for the end</source>
        <translation>noem een andere werkgang voor het eind</translation>
    </message>
    <message>
        <source>no order was found that keeps to all that is said of the order of swaths</source>
        <translation>er is geen volgorde gevonden die alle eisen aan de volgorde van werkgangen volgt</translation>
    </message>
    <message>
        <source>swath %1 is driven first</source>
        <translation>werkgang %1 wordt het eerst gereden</translation>
    </message>
    <message>
        <source>%1 are driven outside of the field</source>
        <translation>Buiten het perceel wordt %1 bereden</translation>
    </message>
    <message>
        <source>%1 costs %2 more than the longest edge (%3)</source>
        <translation>%1 kost %2 meer dan de langste zijde (%3)</translation>
    </message>
    <message>
        <source>%1 h %2 min</source>
        <translation>%1 u %2 min</translation>
    </message>
    <message>
        <source>%1 is as quick as the longest edge (%2)</source>
        <translation>%1 is even snel als de langste zijde (%2)</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>%1 of a work order is no amount</source>
        <translation>%1 van een werkopdracht is geen hoeveelheid</translation>
    </message>
    <message>
        <source>%1 of a work order is no text</source>
        <translation>%1 van een werkopdracht is geen tekst</translation>
    </message>
    <message>
        <source>%1 runs along the longest edge</source>
        <translation>%1 loopt langs de langste zijde</translation>
    </message>
    <message>
        <source>%1 saves %2 against the longest edge (%3)</source>
        <translation>%1 bespaart %2 tegenover de langste zijde (%3)</translation>
    </message>
    <message>
        <source>%1 × %2, %3 each</source>
        <translation>%1 × %2, elk %3</translation>
    </message>
    <message>
        <source>%1: a turn of this machine, with a radius of %2, needs %3.</source>
        <translation>%1: keren met deze machine, met een straal van %2, vraagt %3.</translation>
    </message>
    <message>
        <source>%1: a turn to the next swath would need %2, so turns are made in other ways.</source>
        <translation>%1: keren naar de volgende werkgang zou %2 vragen, daarom wordt anders gekeerd.</translation>
    </message>
    <message>
        <source>%1: its work order is not used: %2</source>
        <translation>%1: de werkopdracht wordt niet gebruikt: %2</translation>
    </message>
    <message>
        <source>%1: the field is too narrow for the %2 that a turn of this machine needs.</source>
        <translation>%1: het perceel is te smal voor de %2 die keren met deze machine vraagt.</translation>
    </message>
    <message>
        <source>%1; the machine keeps %2 from its edge at least.</source>
        <translation>%1; de machine blijft minstens %2 van de rand.</translation>
    </message>
    <message numerus="yes">
        <source>%n blocks</source>
        <translation>
            <numerusform>%n deelperceel</numerusform>
            <numerusform>%n deelpercelen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n passes of %1</source>
        <translation>
            <numerusform>%n gang van %1</numerusform>
            <numerusform>%n gangen van %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n swaths</source>
        <translation>
            <numerusform>%n werkgang</numerusform>
            <numerusform>%n werkgangen</numerusform>
        </translation>
    </message>
    <message>
        <source>Cut into %1 pieces where swaths are interrupted, joined to %2.</source>
        <translation>In %1 stukken gesplitst waar werkgangen onderbroken zijn, samengevoegd tot %2.</translation>
    </message>
    <message>
        <source>Cut into %1 pieces where swaths are interrupted; joining them to %2 saves %3 of turns and ways.</source>
        <translation>In %1 stukken gesplitst waar werkgangen onderbroken zijn; samengevoegd tot %2 bespaart dat %3 aan draaien en verplaatsingen.</translation>
    </message>
    <message>
        <source>Edges that swaths run along get %1, edges that they end at up to %2: a turn of this machine needs %3.</source>
        <translation>Zijden waar werkgangen langs lopen krijgen %1, zijden waar ze eindigen tot %2: keren met deze machine vraagt %3.</translation>
    </message>
    <message>
        <source>Everything keeps %1 from the boundary, as chosen.</source>
        <translation>Alles blijft %1 van de grens, zoals gekozen.</translation>
    </message>
    <message>
        <source>Everything keeps %1 from the boundary: no more is known of where it runs.</source>
        <translation>Alles blijft %1 van de grens: nauwkeuriger is niet bekend waar die loopt.</translation>
    </message>
    <message numerus="yes">
        <source>No heading has fewer than %n swaths.</source>
        <translation>
            <numerusform>Geen richting heeft minder dan %n werkgang.</numerusform>
            <numerusform>Geen richting heeft minder dan %n werkgangen.</numerusform>
        </translation>
    </message>
    <message>
        <source>No heading that was tried covers more: %1 inside the headland.</source>
        <translation>Geen geprobeerde richting bewerkt meer: %1 van de binnenakker.</translation>
    </message>
    <message numerus="yes">
        <source>No heading that was tried has fewer than %n swaths.</source>
        <translation>
            <numerusform>Geen geprobeerde richting heeft minder dan %n werkgang.</numerusform>
            <numerusform>Geen geprobeerde richting heeft minder dan %n werkgangen.</numerusform>
        </translation>
    </message>
    <message>
        <source>No heading that was tried has shorter swaths: %1.</source>
        <translation>Geen geprobeerde richting heeft kortere werkgangen: %1.</translation>
    </message>
    <message>
        <source>No heading that was tried works less land twice: %1.</source>
        <translation>Geen geprobeerde richting bewerkt minder land dubbel: %1.</translation>
    </message>
    <message>
        <source>No order of these swaths can save more than %1 of the turns, or %2 of all.</source>
        <translation>Geen volgorde van deze werkgangen kan meer dan %1 van het keren besparen, of %2 van alles.</translation>
    </message>
    <message>
        <source>No order of these swaths is better; that is proved.</source>
        <translation>Geen volgorde van deze werkgangen is beter; dat is bewezen.</translation>
    </message>
    <message>
        <source>Nothing divides the swaths: one block.</source>
        <translation>Niets splitst de werkgangen: één deelperceel.</translation>
    </message>
    <message>
        <source>Nothing stands outside of the field</source>
        <translation>Niets komt buiten het perceel</translation>
    </message>
    <message>
        <source>One pass all round works the whole field.</source>
        <translation>Eén gang rondom bewerkt het hele perceel.</translation>
    </message>
    <message numerus="yes">
        <source>Swaths are interrupted by corners or obstacles: %n blocks.</source>
        <translation>
            <numerusform>Hoeken of obstakels onderbreken de werkgangen: %n deelperceel.</numerusform>
            <numerusform>Hoeken of obstakels onderbreken de werkgangen: %n deelpercelen.</numerusform>
        </translation>
    </message>
    <message>
        <source>The longest way without work, %1, follows %2.</source>
        <translation>De langste verplaatsing zonder werk, %1, volgt op %2.</translation>
    </message>
    <message>
        <source>There is no headland, as chosen. Turns reach %1 beyond the ends of swaths.</source>
        <translation>Geen kopakker, zoals gekozen. Draaien reiken tot %1 voorbij het einde van de werkgangen.</translation>
    </message>
    <message>
        <source>Turns take %1 less than with the pattern “%2” (%3).</source>
        <translation>Keren kost %1 minder dan met het patroon ‘%2’ (%3).</translation>
    </message>
    <message>
        <source>Turns take %1 more than with the pattern “%2” (%3).</source>
        <translation>Keren kost %1 meer dan met het patroon ‘%2’ (%3).</translation>
    </message>
    <message>
        <source>Turns take about as much as with the pattern “%1”.</source>
        <translation>Keren kost ongeveer evenveel als met het patroon ‘%1’.</translation>
    </message>
    <message>
        <source>a member that every plan has is missing or of another kind</source>
        <translation>een gegeven dat elk plan heeft ontbreekt of is van een andere soort</translation>
    </message>
    <message>
        <source>a work order is a JSON object, and this is none</source>
        <translation>een werkopdracht is een JSON-object, en dit is er geen</translation>
    </message>
    <message>
        <source>bulb turn</source>
        <translation>omegadraai</translation>
    </message>
    <message>
        <source>by this estimate %1 would save %2</source>
        <translation>volgens deze schatting zou %1 %2 besparen</translation>
    </message>
    <message>
        <source>fishtail turn</source>
        <translation>vissenstaart</translation>
    </message>
    <message>
        <source>give a number that is not negative, or leave it out</source>
        <translation>geef een getal dat niet negatief is, of laat het weg</translation>
    </message>
    <message>
        <source>it is draft, issued, in_progress or done</source>
        <translation>het is draft, issued, in_progress of done</translation>
    </message>
    <message>
        <source>no heading is much quicker</source>
        <translation>geen richting is veel sneller</translation>
    </message>
    <message>
        <source>no heading is quicker</source>
        <translation>geen richting is sneller</translation>
    </message>
    <message>
        <source>no plan of this project was sent for this review</source>
        <translation>geen plan van dit project is voor deze beoordeling verstuurd</translation>
    </message>
    <message>
        <source>open the project that the plan was sent from, or open the file by itself</source>
        <translation>open het project waaruit het plan kwam, of het bestand op zichzelf</translation>
    </message>
    <message>
        <source>put it in quotation marks</source>
        <translation>zet het tussen aanhalingstekens</translation>
    </message>
    <message>
        <source>see the README for the members of a work order</source>
        <translation>zie de README voor de gegevens van een werkopdracht</translation>
    </message>
    <message>
        <source>there is no such status of a work order</source>
        <translation>deze status van een werkopdracht bestaat niet</translation>
    </message>
    <message>
        <source>there is no way to drive</source>
        <translation>er is geen traject om te rijden</translation>
    </message>
    <message>
        <source>turn on the spot</source>
        <translation>draai op de plaats</translation>
    </message>
    <message>
        <source>turn with reversing</source>
        <translation>draai met achteruitrijden</translation>
    </message>
    <message>
        <source>way straight on</source>
        <translation>rechtdoor rijden</translation>
    </message>
    <message>
        <source>%1 are driven over the field with the implement up; longest: %2.</source>
        <translation>%1 wordt met het werktuig omhoog over het perceel gereden; het langst: %2.</translation>
    </message>
    <message>
        <source>%1 for each swath gives %2 swaths, and no plan may have more than %3</source>
        <translation>%1 per werkgang geeft %2 werkgangen, en geen plan mag er meer dan %3 hebben</translation>
    </message>
    <message>
        <source>%1 is beyond what machines have</source>
        <translation>%1 valt buiten wat machines hebben</translation>
    </message>
    <message>
        <source>&apos;%1&apos; in it is a view</source>
        <translation>‘%1’ daarin is een view</translation>
    </message>
    <message>
        <source>a text with fields may take %1 MiB, and this one takes more</source>
        <translation>een tekst met percelen mag %1 MiB groot zijn, en deze is groter</translation>
    </message>
    <message>
        <source>a value in it is not of the kind that belongs there</source>
        <translation>een waarde erin is niet van de soort die daar hoort</translation>
    </message>
    <message>
        <source>correct one of them, or give min_turning_radius_m</source>
        <translation>corrigeer een van beide of geef min_turning_radius_m</translation>
    </message>
    <message>
        <source>cut it into parts, or export it as a GeoPackage</source>
        <translation>deel het op of exporteer het als GeoPackage</translation>
    </message>
    <message>
        <source>did you mean %1?</source>
        <translation>bedoelde u %1?</translation>
    </message>
    <message>
        <source>export it as a table, or remove it</source>
        <translation>exporteer hem als tabel of verwijder hem</translation>
    </message>
    <message>
        <source>it would grow more than three hundredfold when it is unpacked</source>
        <translation>het zou bij het uitpakken meer dan driehonderd keer zo groot worden</translation>
    </message>
    <message>
        <source>it would take more than 2 GiB when it is unpacked</source>
        <translation>uitgepakt zou het meer dan 2 GiB zijn</translation>
    </message>
    <message>
        <source>lists and objects lie too deep in one another here</source>
        <translation>lijsten en objecten zijn hier te diep in elkaar genest</translation>
    </message>
    <message>
        <source>remove what does not belong there</source>
        <translation>verwijder wat daar niet hoort</translation>
    </message>
    <message>
        <source>the file is far too large for what it should hold</source>
        <translation>het bestand is veel te groot voor wat erin hoort te staan</translation>
    </message>
    <message>
        <source>unpack it and give one of its files</source>
        <translation>pak het uit en geef een van de bestanden</translation>
    </message>
    <message>
        <source>with this wheelbase, %1 give a turning radius of %2</source>
        <translation>bij deze wielbasis geeft %1 een draaistraal van %2</translation>
    </message>
    <message>
        <source>%1 is no number (%2), and nothing is written</source>
        <translation>%1 is geen getal (%2), en er wordt niets geschreven</translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: %2 (%3); the plan is made with %4 until then</source>
        <translation>%1: %2 (%3); tot dan wordt met %4 gepland</translation>
    </message>
    <message>
        <source>a place</source>
        <translation>een plaats</translation>
    </message>
    <message>
        <source>a place of a guidance line</source>
        <translation>een plaats van een stuurlijn</translation>
    </message>
    <message>
        <source>a place of an obstacle</source>
        <translation>een plaats van een obstakel</translation>
    </message>
    <message>
        <source>a place of swath %1</source>
        <translation>een plaats van werkgang %1</translation>
    </message>
    <message>
        <source>a place of the boundary</source>
        <translation>een plaats van de perceelsgrens</translation>
    </message>
    <message>
        <source>a place of the mainland</source>
        <translation>een plaats van het binnenland</translation>
    </message>
    <message>
        <source>give one beside it, in WGS84, longitude first</source>
        <translation>geef er een ernaast, in WGS84, lengte eerst</translation>
    </message>
    <message>
        <source>plan parts of the field by themselves, choose another heading, or take small obstacles out of the boundary</source>
        <translation>plan delen van het perceel apart, kies een andere richting of haal kleine obstakels uit de grens</translation>
    </message>
    <message>
        <source>the area of the field</source>
        <translation>de oppervlakte van het perceel</translation>
    </message>
    <message>
        <source>the bearing of a guidance line</source>
        <translation>de richting van een stuurlijn</translation>
    </message>
    <message>
        <source>the buffer of an obstacle</source>
        <translation>de afstand rond een obstakel</translation>
    </message>
    <message>
        <source>the coverage of the swaths</source>
        <translation>het deel dat de werkgangen bewerken</translation>
    </message>
    <message>
        <source>the curvature</source>
        <translation>de kromming</translation>
    </message>
    <message>
        <source>the curve is %1 km away from the field</source>
        <translation>de curve ligt %1 km van het perceel</translation>
    </message>
    <message>
        <source>the heading</source>
        <translation>de richting</translation>
    </message>
    <message>
        <source>the outline cuts the tracks into %1 swaths, and no plan may have more than %2</source>
        <translation>de omtrek snijdt de sporen in %1 werkgangen, en geen plan mag er meer dan %2 hebben</translation>
    </message>
    <message>
        <source>the overhang of an obstacle</source>
        <translation>de overhang van een obstakel</translation>
    </message>
    <message>
        <source>the overlap of the swaths</source>
        <translation>de overlap van de werkgangen</translation>
    </message>
    <message>
        <source>the place of a finding</source>
        <translation>de plaats van een bevinding</translation>
    </message>
    <message>
        <source>the place of a gate</source>
        <translation>de plaats van een inrit</translation>
    </message>
    <message>
        <source>the radius of a guidance line</source>
        <translation>de straal van een stuurlijn</translation>
    </message>
    <message>
        <source>the share of the mainland</source>
        <translation>het aandeel van het binnenland</translation>
    </message>
    <message>
        <source>the speed</source>
        <translation>de snelheid</translation>
    </message>
    <message>
        <source>the time</source>
        <translation>de tijd</translation>
    </message>
    <message>
        <source>the way driven</source>
        <translation>de gereden afstand</translation>
    </message>
    <message>
        <source>the width of a gate</source>
        <translation>de breedte van een inrit</translation>
    </message>
    <message>
        <source>the width of a guidance line</source>
        <translation>de breedte van een stuurlijn</translation>
    </message>
    <message>
        <source>the width of the headland</source>
        <translation>de breedte van de kopakker</translation>
    </message>
    <message>
        <source>this is a mistake of Furrow, please report it with the field, the machine and the settings</source>
        <translation>dit is een fout van Furrow, meld hem met het perceel, de machine en de instellingen</translation>
    </message>
    <message>
        <source>%1 %2 is no place in WGS84</source>
        <translation>%1 %2 is geen plaats in WGS84</translation>
    </message>
    <message>
        <source>%1 gathers %2; the bunker holds %3.</source>
        <translation>%1 levert %2; de bunker bevat %3.</translation>
    </message>
    <message>
        <source>%1 of standing</source>
        <translation>%1 stilstand</translation>
    </message>
    <message>
        <source>%1 takes %2; the tank holds %3.</source>
        <translation>%1 vraagt %2; de tank bevat %3.</translation>
    </message>
    <message numerus="yes">
        <source>%n passes are too long for it.</source>
        <translation>
            <numerusform>%n gang is er te lang voor.</numerusform>
            <numerusform>%n gangen zijn er te lang voor.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n refills, with %1 of way to them and back and %2.</source>
        <translation>
            <numerusform>Eén vulbeurt, met %1 weg heen en terug en %2.</numerusform>
            <numerusform>%n vulbeurten, met %1 weg heen en terug en %2.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n unloadings, with %1 of way to them and back and %2.</source>
        <translation>
            <numerusform>Eén losbeurt, met %1 weg heen en terug en %2.</numerusform>
            <numerusform>%n losbeurten, met %1 weg heen en terug en %2.</numerusform>
        </translation>
    </message>
    <message>
        <source>Choose another refill point.</source>
        <translation>Kies een andere vulplaats.</translation>
    </message>
    <message>
        <source>Give more refill points, or ones that are nearer.</source>
        <translation>Geef meer vulplaatsen op, of dichterbij.</translation>
    </message>
    <message>
        <source>Let ways cross the mainland (route.traversal), so that swaths may be interrupted, or lay the swaths the short way.</source>
        <translation>Laat wegen over de binnenakker toe (route.traversal), zodat werkgangen mogen worden onderbroken, of leg de werkgangen in de korte richting.</translation>
    </message>
    <message>
        <source>No trip to a refill point is needed: %1 of the %2 that the bunker holds are gathered.</source>
        <translation>Geen rit naar een losplaats nodig: %1 van de %2 die de bunker bevat worden geoogst.</translation>
    </message>
    <message>
        <source>No trip to a refill point is needed: %1 of the %2 that the tank holds are used.</source>
        <translation>Geen rit naar een vulplaats nodig: %1 van de %2 die de tank bevat worden gebruikt.</translation>
    </message>
    <message>
        <source>No way to a refill point leads from the work before %1.</source>
        <translation>Geen weg leidt naar een vulplaats vanaf het werk voor %1.</translation>
    </message>
    <message>
        <source>POINT (%1 %2) lies outside of the field</source>
        <translation>POINT (%1 %2) ligt buiten het perceel</translation>
    </message>
    <message>
        <source>Plan again; the levels were changed.</source>
        <translation>Plan opnieuw; de peilen zijn veranderd.</translation>
    </message>
    <message>
        <source>Refill points</source>
        <translation>Vulplaatsen</translation>
    </message>
    <message>
        <source>That the machine stands each time its tank is filled or its bunker emptied; 300 s where it is not given.</source>
        <translation>Zo lang staat de machine stil telkens als de tank wordt gevuld of de bunker geleegd; 300 s als niets is opgegeven.</translation>
    </message>
    <message>
        <source>The bunker is full in %1: %2 are worked beyond that.</source>
        <translation>De bunker is vol in %1: %2 worden daarna nog bewerkt.</translation>
    </message>
    <message>
        <source>The level changes %1 away from the refill points.</source>
        <translation>Het peil verandert op %1 van de vulplaatsen.</translation>
    </message>
    <message>
        <source>The machine has no room at this refill point.</source>
        <translation>De machine heeft geen ruimte bij deze vulplaats.</translation>
    </message>
    <message>
        <source>The machine has to stand for %1 s at a refill point, and does not in %2.</source>
        <translation>De machine moet %1 s stilstaan bij een vulplaats en doet dat niet: %2.</translation>
    </message>
    <message>
        <source>The refill points are not used: this machine has no tank.</source>
        <translation>De vulplaatsen worden niet gebruikt: deze machine heeft geen tank.</translation>
    </message>
    <message>
        <source>The refill points are not used: this machine&apos;s tank has no rate.</source>
        <translation>De vulplaatsen worden niet gebruikt: de tank van deze machine heeft geen dosering.</translation>
    </message>
    <message>
        <source>The refill points are not used: this operation uses no tank.</source>
        <translation>De vulplaatsen worden niet gebruikt: deze bewerking gebruikt geen tank.</translation>
    </message>
    <message>
        <source>The stated level differs from the work that is done, by up to %1 of the tank.</source>
        <translation>Het opgegeven peil wijkt af van het gedane werk, tot %1 van de tank.</translation>
    </message>
    <message>
        <source>The tank is empty in %1: %2 are worked beyond that.</source>
        <translation>De tank is leeg in %1: %2 worden daarna nog bewerkt.</translation>
    </message>
    <message>
        <source>Time to fill</source>
        <translation>Vultijd</translation>
    </message>
    <message>
        <source>Where the tank is filled or the bunker emptied: points or names of gates, divided by semicolons.</source>
        <translation>Waar de tank wordt gevuld of de bunker geleegd: punten of namen van inritten, gescheiden door puntkomma&apos;s.</translation>
    </message>
    <message>
        <source>give longitude, then latitude, in degrees</source>
        <translation>geef lengte, dan breedte, in graden</translation>
    </message>
    <message>
        <source>names of gates or points in WGS84 such as MULTIPOINT ((4.1 52.0), (4.2 52.0))</source>
        <translation>namen van inritten of punten in WGS84 zoals MULTIPOINT ((4.1 52.0), (4.2 52.0))</translation>
    </message>
    <message>
        <source>Always</source>
        <translation>Altijd</translation>
    </message>
    <message>
        <source>The quickest of them is taken.</source>
        <translation>Het snelste wordt genomen.</translation>
    </message>
    <message>
        <source>Only where the first one cannot be driven</source>
        <translation>Alleen als het eerste niet uitvoerbaar is</translation>
    </message>
    <message>
        <source>Planning is several times quicker, and the work takes some percent longer.</source>
        <translation>De planning is een paar keer zo snel, en het werk duurt enkele procenten langer.</translation>
    </message>
    <message>
        <source>Compare plans</source>
        <translation>Plannen vergelijken</translation>
    </message>
    <message>
        <source>Plans with other headings, orders, corners and fewer headland passes are driven beside the first one.</source>
        <translation>Naast het eerste worden plannen met andere rijrichtingen, volgordes en hoeken en met minder kopakkergangen doorgerekend.</translation>
    </message>
    <message>
        <source>headings, orders and corners are not compared as driven: the path has %1 parts and the field %2 corners, and with more than %3 in all that takes too long</source>
        <translation>rijrichtingen, volgordes en hoeken worden niet gereden vergeleken: het traject heeft %1 delen en het perceel %2 hoeken; met meer dan %3 samen duurt dat te lang</translation>
    </message>
    <message>
        <source>Way back to work</source>
        <translation>Weg terug naar het werk</translation>
    </message>
    <message>
        <source>Way to refill</source>
        <translation>Weg naar het vullen</translation>
    </message>
    <message>
        <source>Way to unload</source>
        <translation>Weg naar het lossen</translation>
    </message>
    <message>
        <source>Swaths reach to the boundary; for fields with room to turn outside, and for machines that turn on the spot.</source>
        <translation>Werkgangen reiken tot de perceelsgrens; voor percelen met ruimte om erbuiten te keren en voor machines die op de plaats draaien.</translation>
    </message>
    <message>
        <source>There is no headland, as chosen. The machine turns on the spot inside the field.</source>
        <translation>Geen kopakker, zoals gekozen. De machine draait op de plaats, binnen het perceel.</translation>
    </message>
</context>
<context>
    <name>PreferencesDialog</name>
    <message>
        <source>Language and units</source>
        <translation>Taal en eenheden</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Taal</translation>
    </message>
    <message>
        <source>Same as this computer</source>
        <translation>Zoals op deze computer</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>Eenheden</translation>
    </message>
    <message>
        <source>Metres, hectares, km/h</source>
        <translation>Meter, hectare, km/h</translation>
    </message>
    <message>
        <source>Feet, acres, mph</source>
        <translation>Voet, acre, mph</translation>
    </message>
    <message>
        <source>Fields take both: 7.3 m, 24 ft, 10&apos;6&quot;, 8 km/h, 5 mph. Files always hold metres.</source>
        <translation>Invoervelden begrijpen beide: 7,3 m, 24 ft, 10&apos;6&quot;, 8 km/h, 5 mph. Bestanden bevatten altijd meters.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Sluiten</translation>
    </message>
</context>
<context>
    <name>PrintDialog</name>
    <message>
        <source>Print the work order</source>
        <translation>Werkopdracht afdrukken</translation>
    </message>
    <message>
        <source>Plan again</source>
        <translation>Opnieuw plannen</translation>
    </message>
    <message numerus="yes">
        <source>%n problem(s) in this plan: it cannot be driven as drawn. The pages say so too.</source>
        <translation>
            <numerusform>%n probleem in dit plan: het kan zo niet gereden worden. De pagina&apos;s zeggen dat ook.</numerusform>
            <numerusform>%n problemen in dit plan: het kan zo niet gereden worden. De pagina&apos;s zeggen dat ook.</numerusform>
        </translation>
    </message>
    <message>
        <source>Pages of</source>
        <translation>Pagina&apos;s voor</translation>
    </message>
    <message>
        <source>This field</source>
        <translation>Dit perceel</translation>
    </message>
    <message>
        <source>The whole farm (%1)</source>
        <translation>Het hele bedrijf (%1)</translation>
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
        <translation>Printer</translation>
    </message>
    <message>
        <source>No printer was found</source>
        <translation>Geen printer gevonden</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stoppen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Sluiten</translation>
    </message>
    <message>
        <source>Save picture…</source>
        <translation>Afbeelding opslaan…</translation>
    </message>
    <message>
        <source>Print</source>
        <translation>Afdrukken</translation>
    </message>
    <message>
        <source>Save as PDF…</source>
        <translation>Opslaan als PDF…</translation>
    </message>
    <message>
        <source>Save the work order</source>
        <translation>Werkopdracht opslaan</translation>
    </message>
    <message>
        <source>PDF (%1)</source>
        <translation>PDF (%1)</translation>
    </message>
    <message>
        <source>Save the page with the map as a picture</source>
        <translation>De pagina met de kaart als afbeelding opslaan</translation>
    </message>
    <message>
        <source>Pictures (%1)</source>
        <translation>Afbeeldingen (%1)</translation>
    </message>
    <message numerus="yes">
        <source>%n field(s) of the list</source>
        <translation>
            <numerusform>%n perceel van de lijst</numerusform>
            <numerusform>%n percelen van de lijst</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ProblemCard</name>
    <message>
        <source>Show the place</source>
        <translation>Plek tonen</translation>
    </message>
    <message>
        <source>Open another file…</source>
        <translation>Ander bestand openen…</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Sluiten</translation>
    </message>
</context>
<context>
    <name>ProjectDialogs</name>
    <message>
        <source>Open projects or field boundaries</source>
        <translation>Projecten of perceelsgrenzen openen</translation>
    </message>
    <message>
        <source>Projects and field boundaries (%1)</source>
        <translation>Projecten en perceelsgrenzen (%1)</translation>
    </message>
    <message>
        <source>Projects (%1)</source>
        <translation>Projecten (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle bestanden (*)</translation>
    </message>
    <message>
        <source>Save the project</source>
        <translation>Project opslaan</translation>
    </message>
</context>
<context>
    <name>RecentList</name>
    <message>
        <source>Open recent</source>
        <translation>Recent geopend</translation>
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
        <translation>Doorgaan met</translation>
    </message>
    <message>
        <source>Project %1 in %2, %3</source>
        <translation>Project %1 in %2, %3</translation>
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
            <numerusform>%n bevinding</numerusform>
            <numerusform>%n bevindingen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n problem(s)</source>
        <translation>
            <numerusform>%n probleem</numerusform>
            <numerusform>%n problemen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n to look at</source>
        <translation>
            <numerusform>%n om te bekijken</numerusform>
            <numerusform>%n om te bekijken</numerusform>
        </translation>
    </message>
    <message>
        <source>Show the first %1 only</source>
        <translation>Alleen de eerste %1 tonen</translation>
    </message>
    <message>
        <source>Show all %1</source>
        <translation>Alle %1 tonen</translation>
    </message>
    <message>
        <source>Out of date: figures and findings are those of the plan before the change.</source>
        <translation>Verouderd: cijfers en bevindingen horen bij het plan van vóór de wijziging.</translation>
    </message>
    <message>
        <source>Nothing was found in this plan: all of it can be driven.</source>
        <translation>In dit plan is niets gevonden: alles kan worden gereden.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Sluiten</translation>
    </message>
    <message>
        <source>first plan: preliminary figures</source>
        <translation>eerste plan: voorlopige cijfers</translation>
    </message>
    <message>
        <source>of the plan before</source>
        <translation>van het vorige plan</translation>
    </message>
</context>
<context>
    <name>ReviewDialogs</name>
    <message>
        <source>Send for review</source>
        <translation>Ter beoordeling sturen</translation>
    </message>
    <message>
        <source>Review files (%1)</source>
        <translation>Beoordelingsbestanden (%1)</translation>
    </message>
    <message>
        <source>Take in what came back</source>
        <translation>Overnemen wat terugkwam</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle bestanden (*)</translation>
    </message>
    <message>
        <source>Take in this review?</source>
        <translation>Deze beoordeling overnemen?</translation>
    </message>
    <message>
        <source>The file is a review of a plan of the project that is open. Its comments can be taken in here.</source>
        <translation>Het bestand is een beoordeling van een plan van het geopende project. De opmerkingen kunnen hier worden overgenomen.</translation>
    </message>
    <message>
        <source>Take in</source>
        <translation>Overnemen</translation>
    </message>
    <message>
        <source>Open by itself</source>
        <translation>Apart openen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuleren</translation>
    </message>
</context>
<context>
    <name>ReviewSection</name>
    <message numerus="yes">
        <source>Review · %n open comment(s)</source>
        <translation>
            <numerusform>Beoordeling · %n open opmerking</numerusform>
            <numerusform>Beoordeling · %n open opmerkingen</numerusform>
        </translation>
    </message>
    <message>
        <source>Review</source>
        <translation>Beoordeling</translation>
    </message>
    <message>
        <source>The plan has changed since.</source>
        <translation>Het plan is sindsdien gewijzigd.</translation>
    </message>
    <message>
        <source>Take back</source>
        <translation>Intrekken</translation>
    </message>
    <message>
        <source>At the place that you clicked:</source>
        <translation>Op de aangeklikte plek:</translation>
    </message>
    <message>
        <source>On the whole plan:</source>
        <translation>Bij het hele plan:</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>Opmerking</translation>
    </message>
    <message>
        <source>What should be changed here?</source>
        <translation>Wat moet hier anders?</translation>
    </message>
    <message>
        <source>Your name</source>
        <translation>Uw naam</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Toevoegen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuleren</translation>
    </message>
    <message>
        <source>On a place…</source>
        <translation>Bij een plek…</translation>
    </message>
    <message>
        <source>On the whole plan…</source>
        <translation>Bij het hele plan…</translation>
    </message>
    <message>
        <source>Approve</source>
        <translation>Goedkeuren</translation>
    </message>
    <message>
        <source>Ask for changes</source>
        <translation>Wijzigingen vragen</translation>
    </message>
    <message>
        <source>Take in what came back…</source>
        <translation>Overnemen wat terugkwam…</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Sluiten</translation>
    </message>
    <message>
        <source>Comment %1:</source>
        <translation>Opmerking %1:</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Wijzigen</translation>
    </message>
</context>
<context>
    <name>ScaleBar</name>
    <message>
        <source>Scale: the bar is %1 long</source>
        <translation>Schaal: de balk is %1 lang</translation>
    </message>
</context>
<context>
    <name>SearchButton</name>
    <message>
        <source>Search commands</source>
        <translation>Opdrachten zoeken</translation>
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
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>SidePanel</name>
    <message>
        <source>Back to the plan (Esc)</source>
        <translation>Terug naar het plan (Esc)</translation>
    </message>
</context>
<context>
    <name>SketchHint</name>
    <message>
        <source>Click the first corner of the field</source>
        <translation>Klik op de eerste hoek van het perceel</translation>
    </message>
    <message>
        <source>Click the first corner of the hole</source>
        <translation>Klik op de eerste hoek van het gat</translation>
    </message>
    <message>
        <source>Click the first corner of the obstacle</source>
        <translation>Klik op de eerste hoek van het obstakel</translation>
    </message>
    <message>
        <source>Click on the boundary where the gate is</source>
        <translation>Klik op de perceelsgrens waar de inrit is</translation>
    </message>
    <message>
        <source>Click where the AB line begins</source>
        <translation>Klik waar de AB-lijn begint</translation>
    </message>
    <message>
        <source>Length of the next edge</source>
        <translation>Lengte van de volgende zijde</translation>
    </message>
    <message>
        <source>Direction of the next edge</source>
        <translation>Richting van de volgende zijde</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Toevoegen</translation>
    </message>
    <message>
        <source>By hand</source>
        <translation>Vrije hand</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuleren</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>Klaar</translation>
    </message>
    <message>
        <source>Close boundary</source>
        <translation>Grens sluiten</translation>
    </message>
    <message>
        <source>Click where the split line begins</source>
        <translation>Klik waar de splitlijn begint</translation>
    </message>
    <message>
        <source>Press and trace it with the pointer, to %1</source>
        <translation>Druk en trek het met de aanwijzer na, tot op %1</translation>
    </message>
    <message>
        <source>Backspace or Ctrl+Z takes the last point back</source>
        <translation>Backspace of Ctrl+Z neemt het laatste punt terug</translation>
    </message>
</context>
<context>
    <name>StatusChip</name>
    <message>
        <source>Stop</source>
        <translation>Stoppen</translation>
    </message>
    <message>
        <source>Plan again</source>
        <translation>Opnieuw plannen</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Tonen</translation>
    </message>
    <message>
        <source>Show the problems</source>
        <translation>De problemen tonen</translation>
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
        <translation>De omtrek heeft %1 trapjes van ongeveer %2 %3, zoals de pixels van een beeld.</translation>
    </message>
    <message>
        <source>Made straight, their outlines would be refused. Open one of them to see why.</source>
        <translation>Rechtgemaakt zouden hun omtrekken geweigerd worden. Open er een om te zien waarom.</translation>
    </message>
    <message>
        <source>No machine follows them. Straight edges lead through the middles of the steps.</source>
        <translation>Geen machine volgt ze. Rechte randen lopen door het midden van de trapjes.</translation>
    </message>
    <message>
        <source>Make them straight</source>
        <translation>Recht maken</translation>
    </message>
    <message>
        <source>In all fields</source>
        <translation>In alle percelen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Sluiten</translation>
    </message>
</context>
<context>
    <name>StepsPanel</name>
    <message>
        <source>Find the best plan…</source>
        <translation>Beste plan zoeken…</translation>
    </message>
</context>
<context>
    <name>ThemeSwitch</name>
    <message>
        <source>Sunlight colours; press for light</source>
        <translation>Kleuren voor zonlicht; druk voor licht</translation>
    </message>
    <message>
        <source>Dark colours; press for sunlight</source>
        <translation>Donkere kleuren; druk voor zonlicht</translation>
    </message>
    <message>
        <source>Light colours; press for dark</source>
        <translation>Lichte kleuren; druk voor donker</translation>
    </message>
</context>
<context>
    <name>TopBar</name>
    <message>
        <source>Not saved yet</source>
        <translation>Nog niet opgeslagen</translation>
    </message>
    <message>
        <source>There are changes that are not saved</source>
        <translation>Er zijn niet opgeslagen wijzigingen</translation>
    </message>
    <message>
        <source>Hide the results</source>
        <translation>Resultaten verbergen</translation>
    </message>
    <message>
        <source>Show the results</source>
        <translation>Resultaten tonen</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Openen</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exporteren</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergelijken</translation>
    </message>
    <message>
        <source>Hide the steps</source>
        <translation>Stappen verbergen</translation>
    </message>
    <message>
        <source>Show the steps</source>
        <translation>Stappen tonen</translation>
    </message>
</context>
<context>
    <name>Tour</name>
    <message>
        <source>Get a field</source>
        <translation>Een perceel kiezen</translation>
    </message>
    <message>
        <source>Open its boundary, draw it, or press here for a sample.</source>
        <translation>Open de grens, teken die, of druk hier voor een voorbeeld.</translation>
    </message>
    <message>
        <source>Choose your machine</source>
        <translation>Uw machine kiezen</translation>
    </message>
    <message>
        <source>The second step: the one most like yours, then its width.</source>
        <translation>De tweede stap: die het meest op de uwe lijkt, dan de breedte.</translation>
    </message>
    <message>
        <source>Change the field</source>
        <translation>Het perceel veranderen</translation>
    </message>
    <message>
        <source>Drag a corner on the map. The plan follows; Ctrl+Z takes it back.</source>
        <translation>Sleep een hoek op de kaart. Het plan volgt; Ctrl+Z neemt het terug.</translation>
    </message>
    <message>
        <source>Take it to the tractor</source>
        <translation>Naar de trekker brengen</translation>
    </message>
    <message>
        <source>Export writes the plan to a stick or a folder and checks it.</source>
        <translation>Exporteren schrijft het plan naar een stick of map en controleert het.</translation>
    </message>
    <message>
        <source>That is all</source>
        <translation>Dat is alles</translation>
    </message>
    <message>
        <source>First things</source>
        <translation>Eerste stappen</translation>
    </message>
    <message>
        <source>Leave; it is in the Help menu</source>
        <translation>Verlaten; staat in het menu Help</translation>
    </message>
    <message>
        <source>%1: done</source>
        <translation>%1: klaar</translation>
    </message>
    <message>
        <source>Ctrl+S saves the project, F1 opens the guide.</source>
        <translation>Ctrl+S bewaart het project, F1 opent de handleiding.</translation>
    </message>
</context>
<context>
    <name>TrackQuestion</name>
    <message>
        <source>“%1” is a recorded track</source>
        <translation>“%1” is een opgenomen rit</translation>
    </message>
    <message>
        <source>It can become a field, or be laid over the plan to see how far beside it was driven.</source>
        <translation>Het kan een perceel worden, of over het plan worden gelegd om te zien hoever ernaast is gereden.</translation>
    </message>
    <message>
        <source>Make a field from it</source>
        <translation>Er een perceel van maken</translation>
    </message>
    <message>
        <source>Lay it over the plan</source>
        <translation>Over het plan leggen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuleren</translation>
    </message>
</context>
<context>
    <name>TroubleDialog</name>
    <message>
        <source>Report a problem</source>
        <translation>Een probleem melden</translation>
    </message>
    <message>
        <source>One file with all that is needed to find the cause: the version, the machine, the settings, the shape of the field, the findings, and the record of the last crash. No names and no other fields are in it.</source>
        <translation>Eén bestand met alles wat nodig is om de oorzaak te vinden: de versie, de machine, de instellingen, de vorm van het perceel, de bevindingen en het verslag van de laatste crash. Er staan geen namen en geen andere percelen in.</translation>
    </message>
    <message>
        <source>Nothing is sent. You decide who gets the file; write to them what you did and what you expected.</source>
        <translation>Er wordt niets verstuurd. U bepaalt wie het bestand krijgt; schrijf erbij wat u deed en wat u verwachtte.</translation>
    </message>
    <message>
        <source>Save the report…</source>
        <translation>Verslag opslaan…</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Sluiten</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>Verslag opslaan</translation>
    </message>
    <message>
        <source>Reports (%1)</source>
        <translation>Verslagen (%1)</translation>
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
        <translation>%1 u %2 min</translation>
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
        <translation>%1 u %2 min %3 s</translation>
    </message>
</context>
<context>
    <name>UnsavedDialog</name>
    <message>
        <source>Save the changes of “%1”?</source>
        <translation>De wijzigingen in ‘%1’ opslaan?</translation>
    </message>
    <message>
        <source>Save your work?</source>
        <translation>Het werk opslaan?</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuleren</translation>
    </message>
    <message>
        <source>Do not save</source>
        <translation>Niet opslaan</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Opslaan</translation>
    </message>
</context>
<context>
    <name>ViewCommands</name>
    <message>
        <source>View</source>
        <translation>Beeld</translation>
    </message>
    <message>
        <source>What the map shows</source>
        <translation>Wat de kaart toont</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Kleuren</translation>
    </message>
    <message>
        <source>Size of everything</source>
        <translation>Grootte van de weergave</translation>
    </message>
    <message>
        <source>Everything at %1 %</source>
        <translation>Weergave op %1 %</translation>
    </message>
    <message>
        <source>size scaling zoom large text</source>
        <translation>grootte schaal zoom grote tekst</translation>
    </message>
    <message>
        <source>Follow the machine</source>
        <translation>De machine volgen</translation>
    </message>
    <message>
        <source>drive camera centre</source>
        <translation>rijden kaart midden</translation>
    </message>
    <message>
        <source>Drive-through bar</source>
        <translation>Balk om af te rijden</translation>
    </message>
    <message>
        <source>drive play slider</source>
        <translation>rijden afspelen schuif</translation>
    </message>
    <message>
        <source>Show the whole field</source>
        <translation>Heel perceel tonen</translation>
    </message>
    <message>
        <source>Go to a place…</source>
        <translation>Naar een plaats gaan…</translation>
    </message>
    <message>
        <source>coordinates latitude longitude map</source>
        <translation>coördinaten breedtegraad lengtegraad kaart</translation>
    </message>
    <message>
        <source>Closer</source>
        <translation>Inzoomen</translation>
    </message>
    <message>
        <source>zoom in</source>
        <translation>vergroten zoom</translation>
    </message>
    <message>
        <source>Further away</source>
        <translation>Uitzoomen</translation>
    </message>
    <message>
        <source>zoom out</source>
        <translation>verkleinen zoom</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Stappen</translation>
    </message>
    <message>
        <source>Results panel</source>
        <translation>Resultaten</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Lagen</translation>
    </message>
    <message>
        <source>imagery map background</source>
        <translation>luchtfoto kaart achtergrond</translation>
    </message>
    <message>
        <source>Layer: imagery</source>
        <translation>Laag: luchtfoto</translation>
    </message>
    <message>
        <source>Layer: OpenStreetMap from the network</source>
        <translation>Laag: OpenStreetMap van internet</translation>
    </message>
    <message>
        <source>online tiles</source>
        <translation>online tegels</translation>
    </message>
    <message>
        <source>Layer: boundary</source>
        <translation>Laag: perceelsgrens</translation>
    </message>
    <message>
        <source>Layer: headland</source>
        <translation>Laag: kopakker</translation>
    </message>
    <message>
        <source>Layer: swaths</source>
        <translation>Laag: werkgangen</translation>
    </message>
    <message>
        <source>Layer: turns</source>
        <translation>Laag: draaien</translation>
    </message>
    <message>
        <source>Layer: driving direction</source>
        <translation>Laag: rijrichting</translation>
    </message>
    <message>
        <source>Layer: swath numbers</source>
        <translation>Laag: werkgangnummers</translation>
    </message>
    <message>
        <source>Layer: order numbers</source>
        <translation>Laag: volgnummers</translation>
    </message>
    <message>
        <source>Layer: coverage</source>
        <translation>Laag: bewerkt oppervlak</translation>
    </message>
    <message>
        <source>Layer: worked twice</source>
        <translation>Laag: dubbel bewerkt</translation>
    </message>
    <message>
        <source>overlap</source>
        <translation>overlap</translation>
    </message>
    <message>
        <source>Layer: missed</source>
        <translation>Laag: gemiste plekken</translation>
    </message>
    <message>
        <source>gap uncovered</source>
        <translation>gat onbewerkt</translation>
    </message>
    <message>
        <source>Layer: driven over often</source>
        <translation>Laag: vaak bereden</translation>
    </message>
    <message>
        <source>wheel passes traffic compaction</source>
        <translation>wielsporen berijding verdichting</translation>
    </message>
    <message>
        <source>Layer: findings</source>
        <translation>Laag: bevindingen</translation>
    </message>
    <message>
        <source>Language and units…</source>
        <translation>Taal en eenheden…</translation>
    </message>
    <message>
        <source>preferences settings metric imperial feet acres</source>
        <translation>voorkeuren instellingen metrisch imperiaal voet acre</translation>
    </message>
    <message>
        <source>Light colours</source>
        <translation>Lichte kleuren</translation>
    </message>
    <message>
        <source>theme</source>
        <translation>thema</translation>
    </message>
    <message>
        <source>Dark colours</source>
        <translation>Donkere kleuren</translation>
    </message>
    <message>
        <source>theme night</source>
        <translation>thema nacht</translation>
    </message>
    <message>
        <source>Sunlight colours</source>
        <translation>Kleuren voor zonlicht</translation>
    </message>
    <message>
        <source>theme contrast</source>
        <translation>thema contrast</translation>
    </message>
</context>
<context>
    <name>WindowDialogs</name>
    <message>
        <source>Everything at %1 %</source>
        <translation>Weergave op %1 %</translation>
    </message>
    <message>
        <source>This holds from the next start of Furrow.</source>
        <translation>Dit geldt vanaf de volgende start van Furrow.</translation>
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
        <translation>Meerdere bewegingen</translation>
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
        <translation>zoals getekend</translation>
    </message>
    <message>
        <source>Draft</source>
        <comment>work order</comment>
        <translation>Concept</translation>
    </message>
    <message>
        <source>Issued</source>
        <comment>work order</comment>
        <translation>Uitgegeven</translation>
    </message>
    <message>
        <source>In progress</source>
        <comment>work order</comment>
        <translation>Bezig</translation>
    </message>
    <message>
        <source>Done</source>
        <comment>work order</comment>
        <translation>Klaar</translation>
    </message>
    <message numerus="yes">
        <source>Not drivable: %n problem(s)</source>
        <translation>
            <numerusform>Niet uitvoerbaar: %n probleem</numerusform>
            <numerusform>Niet uitvoerbaar: %n problemen</numerusform>
        </translation>
    </message>
    <message>
        <source>Work order</source>
        <translation>Werkopdracht</translation>
    </message>
    <message>
        <source>Work order %1</source>
        <translation>Werkopdracht %1</translation>
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
        <translation>Klant</translation>
    </message>
    <message>
        <source>Field address</source>
        <translation>Adres van het perceel</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>Bestuurder</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tijd</translation>
    </message>
    <message>
        <source>Product</source>
        <translation>Product</translation>
    </message>
    <message>
        <source>Rate and total</source>
        <translation>Dosering en totaal</translation>
    </message>
    <message>
        <source>%1 = %2</source>
        <comment>rate and total</comment>
        <translation>%1 = %2</translation>
    </message>
    <message>
        <source>Where the work starts</source>
        <translation>Waar het werk begint</translation>
    </message>
    <message>
        <source>Gate</source>
        <translation>Inrit</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Oppervlakte</translation>
    </message>
    <message>
        <source>Driven</source>
        <translation>Gereden</translation>
    </message>
    <message>
        <source>Working</source>
        <translation>Werken</translation>
    </message>
    <message>
        <source>Turning</source>
        <translation>Keren</translation>
    </message>
    <message>
        <source>Covered</source>
        <translation>Bewerkt</translation>
    </message>
    <message>
        <source>Worked twice</source>
        <translation>Dubbel bewerkt</translation>
    </message>
    <message>
        <source>Outside the field</source>
        <translation>Buiten het perceel</translation>
    </message>
    <message>
        <source>Fuel</source>
        <translation>Brandstof</translation>
    </message>
    <message>
        <source>%1 l</source>
        <translation>%1 l</translation>
    </message>
    <message>
        <source>Above the best order</source>
        <translation>Boven de beste volgorde</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Machine</translation>
    </message>
    <message>
        <source>Working width</source>
        <translation>Werkbreedte</translation>
    </message>
    <message>
        <source>Width in turns</source>
        <translation>Breedte bij het keren</translation>
    </message>
    <message>
        <source>Turning radius</source>
        <translation>Draaistraal</translation>
    </message>
    <message>
        <source>Speed at work</source>
        <translation>Werksnelheid</translation>
    </message>
    <message>
        <source>Speed in turns</source>
        <translation>Snelheid bij het keren</translation>
    </message>
    <message>
        <source>Implement</source>
        <translation>Werktuig</translation>
    </message>
    <message>
        <source>trailed</source>
        <translation>getrokken</translation>
    </message>
    <message>
        <source>mounted</source>
        <translation>gedragen</translation>
    </message>
    <message>
        <source>Tank</source>
        <translation>Tank</translation>
    </message>
    <message>
        <source>full after %1</source>
        <translation>vol na %1</translation>
    </message>
    <message>
        <source>enough for %1</source>
        <translation>genoeg voor %1</translation>
    </message>
    <message numerus="yes">
        <source>%n pass(es)</source>
        <translation>
            <numerusform>%n gang</numerusform>
            <numerusform>%n gangen</numerusform>
        </translation>
    </message>
    <message>
        <source>none</source>
        <comment>headland</comment>
        <translation>geen</translation>
    </message>
    <message>
        <source>Operation</source>
        <translation>Bewerking</translation>
    </message>
    <message>
        <source>Headland</source>
        <translation>Kopakker</translation>
    </message>
    <message>
        <source>Swaths</source>
        <translation>Werkgangen</translation>
    </message>
    <message>
        <source>Kept free at the edge</source>
        <translation>Vrij gehouden langs de rand</translation>
    </message>
    <message>
        <source>Plan and settings</source>
        <translation>Plan en instellingen</translation>
    </message>
    <message>
        <source>What was done</source>
        <translation>Uitvoering</translation>
    </message>
    <message>
        <source>Acres worked</source>
        <translation>Bewerkte acres</translation>
    </message>
    <message>
        <source>Hectares worked</source>
        <translation>Bewerkte hectares</translation>
    </message>
    <message>
        <source>Hours</source>
        <translation>Uren</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>Begin</translation>
    </message>
    <message>
        <source>End</source>
        <comment>of the work</comment>
        <translation>Einde</translation>
    </message>
    <message>
        <source>Wind</source>
        <translation>Wind</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>Temperatuur</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Opmerkingen</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>Signature</source>
        <translation>Handtekening</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Bevindingen</translation>
    </message>
    <message>
        <source>None: the plan can be driven as drawn.</source>
        <translation>Geen: het plan kan zo gereden worden.</translation>
    </message>
    <message numerus="yes">
        <source>and %n more, in the window and in summary.json</source>
        <translation>
            <numerusform>en nog %n, in het venster en in summary.json</numerusform>
            <numerusform>en nog %n, in het venster en in summary.json</numerusform>
        </translation>
    </message>
    <message>
        <source>Comments</source>
        <translation>Opmerkingen</translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <comment>count and kind of turns</comment>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>%1 in reverse</source>
        <translation>%1 achteruit</translation>
    </message>
    <message>
        <source>Turns</source>
        <translation>Draaien</translation>
    </message>
    <message>
        <source>H%1</source>
        <comment>headland pass</comment>
        <translation>K%1</translation>
    </message>
    <message>
        <source>Swath %1</source>
        <translation>Werkgang %1</translation>
    </message>
    <message>
        <source>Order of the passes</source>
        <translation>Volgorde van de werkgangen</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>Pass</source>
        <translation>Werkgang</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Lengte</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Naar</translation>
    </message>
    <message>
        <source>This plan&apos;s path.csv has the SHA-256 sum below. A file with another sum is another plan.</source>
        <translation>De path.csv van dit plan heeft de SHA-256-som hieronder. Een bestand met een andere som is een ander plan.</translation>
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
        <translation>Einde</translation>
    </message>
    <message>
        <source>Swath</source>
        <translation>Werkgang</translation>
    </message>
    <message>
        <source>Headland pass</source>
        <translation>Kopakkergang</translation>
    </message>
    <message>
        <source>Implement up</source>
        <translation>Werktuig geheven</translation>
    </message>
    <message>
        <source>Finding</source>
        <translation>Bevinding</translation>
    </message>
    <message>
        <source>Obstacle</source>
        <translation>Obstakel</translation>
    </message>
    <message>
        <source>Farm</source>
        <translation>Bedrijf</translation>
    </message>
    <message>
        <source>Work orders</source>
        <translation>Werkopdrachten</translation>
    </message>
    <message numerus="yes">
        <source>%n field(s)</source>
        <translation>
            <numerusform>%n perceel</numerusform>
            <numerusform>%n percelen</numerusform>
        </translation>
    </message>
    <message>
        <source>Field</source>
        <translation>Perceel</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Status</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>Pagina</translation>
    </message>
    <message>
        <source>Not drivable</source>
        <translation>Niet uitvoerbaar</translation>
    </message>
    <message>
        <source>Total</source>
        <translation>Totaal</translation>
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
        <translation>Pagina %1 van %2</translation>
    </message>
    <message>
        <source>Unloadings</source>
        <translation>Losbeurten</translation>
    </message>
    <message>
        <source>Refills</source>
        <translation>Vulbeurten</translation>
    </message>
</context>
<context>
    <name>furrow::BestSearch</name>
    <message>
        <source>Take the best plan</source>
        <translation>Beste plan overnemen</translation>
    </message>
</context>
<context>
    <name>furrow::CellSteps</name>
    <message numerus="yes">
        <source>%n block(s), %1</source>
        <translation>
            <numerusform>%n deelperceel, %1</numerusform>
            <numerusform>%n deelpercelen, %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Cut: %1</source>
        <translation>Gesplitst: %1</translation>
    </message>
    <message>
        <source>Cut: %1 → joined: %2</source>
        <translation>Gesplitst: %1 → samengevoegd: %2</translation>
    </message>
    <message>
        <source>Joining any two of them would save nothing.</source>
        <translation>Er twee samenvoegen zou niets besparen.</translation>
    </message>
    <message>
        <source>Step %1 of %2: %3</source>
        <translation>Stap %1 van %2: %3</translation>
    </message>
    <message>
        <source>As cut.</source>
        <translation>Zoals gesplitst.</translation>
    </message>
    <message>
        <source>The two marked blocks become one: that saves %1.</source>
        <translation>De twee gemarkeerde deelpercelen worden één: dat bespaart %1.</translation>
    </message>
    <message>
        <source>Blocks in which no swath lies go to their neighbours.</source>
        <translation>Deelpercelen waarin geen werkgang ligt, gaan naar hun buren.</translation>
    </message>
</context>
<context>
    <name>furrow::ChoiceTableModel</name>
    <message>
        <source>saves %1</source>
        <translation>bespaart %1</translation>
    </message>
    <message>
        <source>mends the plan</source>
        <translation>maakt het plan uitvoerbaar</translation>
    </message>
    <message>
        <source>the same time</source>
        <translation>even snel</translation>
    </message>
    <message>
        <source>%1 slower</source>
        <translation>%1 langzamer</translation>
    </message>
    <message>
        <source>%1 quicker</source>
        <translation>%1 sneller</translation>
    </message>
</context>
<context>
    <name>furrow::DriveThrough</name>
    <message>
        <source>Swath %1, %2 of %3</source>
        <translation>Werkgang %1, %2 van %3</translation>
    </message>
    <message>
        <source>backwards</source>
        <translation>achteruit</translation>
    </message>
    <message>
        <source>implement down</source>
        <translation>werktuig neer</translation>
    </message>
    <message>
        <source>implement folded</source>
        <translation>werktuig opgeklapt</translation>
    </message>
    <message>
        <source>implement up</source>
        <translation>werktuig omhoog</translation>
    </message>
    <message>
        <source>%1 done</source>
        <translation>%1 bewerkt</translation>
    </message>
    <message>
        <source>wheels straight</source>
        <translation>wielen recht</translation>
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
        <translation>tank %1</translation>
    </message>
    <message>
        <source>tank empty</source>
        <translation>tank leeg</translation>
    </message>
    <message>
        <source>Way without work</source>
        <translation>Weg zonder werk</translation>
    </message>
    <message>
        <source>bunker %1</source>
        <translation>bunker %1</translation>
    </message>
</context>
<context>
    <name>furrow::DrivenTrack</name>
    <message>
        <source>On the plan</source>
        <translation>Op het plan</translation>
    </message>
    <message>
        <source>Positions within one and a half widths of it; the figures are of these</source>
        <translation>Posities binnen anderhalve breedte; de cijfers gelden hiervoor</translation>
    </message>
    <message>
        <source>Half are within</source>
        <translation>De helft ligt binnen</translation>
    </message>
    <message>
        <source>95 % are within</source>
        <translation>95 % ligt binnen</translation>
    </message>
    <message>
        <source>Farthest</source>
        <translation>Grootste afstand</translation>
    </message>
    <message>
        <source>On average to the right</source>
        <translation>Gemiddeld naar rechts</translation>
    </message>
    <message>
        <source>On average to the left</source>
        <translation>Gemiddeld naar links</translation>
    </message>
    <message>
        <source>The same everywhere: antenna or offset</source>
        <translation>Overal gelijk: antenne of verschuiving</translation>
    </message>
    <message>
        <source>On swaths, 95 % within</source>
        <translation>Op werkgangen 95 % binnen</translation>
    </message>
    <message>
        <source>Covered</source>
        <translation>Bewerkt</translation>
    </message>
    <message>
        <source>As if the implement ran in the middle of the recorded line</source>
        <translation>Alsof het werktuig midden op de opgenomen lijn liep</translation>
    </message>
    <message>
        <source>Missed</source>
        <translation>Gemiste plekken</translation>
    </message>
    <message>
        <source>Driven</source>
        <translation>Gereden</translation>
    </message>
    <message>
        <source>The plan: %1</source>
        <translation>Het plan: %1</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tijd</translation>
    </message>
    <message>
        <source>up to %1</source>
        <translation>tot %1</translation>
    </message>
    <message>
        <source>farther</source>
        <translation>verder</translation>
    </message>
    <message>
        <source>off the plan</source>
        <translation>buiten het plan</translation>
    </message>
</context>
<context>
    <name>furrow::ExportModel</name>
    <message>
        <source>Furrow plan</source>
        <translation>Furrow-plan</translation>
    </message>
    <message>
        <source>Furrow %1</source>
        <translation>Furrow %1</translation>
    </message>
    <message>
        <source>Writing …</source>
        <translation>Bezig met schrijven…</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) written to %1</source>
        <translation>
            <numerusform>%n bestand geschreven naar %1</numerusform>
            <numerusform>%n bestanden geschreven naar %1</numerusform>
        </translation>
    </message>
    <message>
        <source>There is no field yet, and no plan to export.</source>
        <translation>Er is nog geen perceel en geen plan om te exporteren.</translation>
    </message>
    <message>
        <source>A field is being opened. Its plan can be exported when it is finished.</source>
        <translation>Er wordt een perceel geopend. Het plan kan worden geëxporteerd als het klaar is.</translation>
    </message>
    <message>
        <source>The plan is still being made. It can be exported when it is finished.</source>
        <translation>Het plan wordt nog gemaakt. Het kan worden geëxporteerd als het klaar is.</translation>
    </message>
    <message>
        <source>The plan is out of date: the field, the machine or a setting was changed after it was made.</source>
        <translation>Het plan is verouderd: het perceel, de machine of een instelling is daarna gewijzigd.</translation>
    </message>
    <message>
        <source>There is no plan to export. The message on the map says why.</source>
        <translation>Er is geen plan om te exporteren. De melding op de kaart zegt waarom.</translation>
    </message>
    <message numerus="yes">
        <source>%n field(s)</source>
        <translation>
            <numerusform>%n perceel</numerusform>
            <numerusform>%n percelen</numerusform>
        </translation>
    </message>
    <message>
        <source>Furrow plans</source>
        <translation>Furrow plannen</translation>
    </message>
    <message>
        <source>None of the fields could be exported.</source>
        <translation>Geen van de percelen kon worden geëxporteerd.</translation>
    </message>
    <message numerus="yes">
        <source>%n field(s) written to %1</source>
        <translation>
            <numerusform>%n perceel geschreven naar %1</numerusform>
            <numerusform>%n percelen geschreven naar %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n file(s)</source>
        <translation>
            <numerusform>%n bestand</numerusform>
            <numerusform>%n bestanden</numerusform>
        </translation>
    </message>
    <message>
        <source>Writing was stopped.</source>
        <translation>Het schrijven is gestopt.</translation>
    </message>
    <message>
        <source>Fields that were written before stay in the folder.</source>
        <translation>Percelen die al geschreven waren, blijven in de map.</translation>
    </message>
</context>
<context>
    <name>furrow::FarmList</name>
    <message numerus="yes">
        <source>Plan %n field(s) alike</source>
        <translation>
            <numerusform>%n perceel hetzelfde plannen</numerusform>
            <numerusform>%n percelen hetzelfde plannen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Add a plan to %n field(s)</source>
        <translation>
            <numerusform>Aan %n perceel een plan toevoegen</numerusform>
            <numerusform>Aan %n percelen een plan toevoegen</numerusform>
        </translation>
    </message>
    <message>
        <source>Not planned yet</source>
        <translation>Niet gepland</translation>
    </message>
    <message>
        <source>Out of date</source>
        <translation>Verouderd</translation>
    </message>
    <message>
        <source>Waits</source>
        <translation>Wacht</translation>
    </message>
    <message>
        <source>Planning …</source>
        <translation>Plannen…</translation>
    </message>
    <message>
        <source>Drivable</source>
        <translation>Uitvoerbaar</translation>
    </message>
    <message numerus="yes">
        <source>%n problem(s)</source>
        <translation>
            <numerusform>%n probleem</numerusform>
            <numerusform>%n problemen</numerusform>
        </translation>
    </message>
    <message>
        <source>No plan</source>
        <translation>Geen plan</translation>
    </message>
    <message numerus="yes">
        <source>%n field(s)</source>
        <translation>
            <numerusform>%n perceel</numerusform>
            <numerusform>%n percelen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n field(s)</source>
        <translation>
            <numerusform>%1 van %n perceel</numerusform>
            <numerusform>%1 van %n percelen</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 drivable</source>
        <translation>%1 uitvoerbaar</translation>
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
        <translation>Perceel hernoemen</translation>
    </message>
    <message>
        <source>Remove field %1</source>
        <translation>Perceel %1 verwijderen</translation>
    </message>
    <message>
        <source>Add a plan</source>
        <translation>Plan toevoegen</translation>
    </message>
    <message>
        <source>Rename the plan</source>
        <translation>Plan hernoemen</translation>
    </message>
    <message>
        <source>Remove the plan</source>
        <translation>Plan verwijderen</translation>
    </message>
</context>
<context>
    <name>furrow::FarmPlans</name>
    <message>
        <source>%1 of %2: %3</source>
        <translation>%1 van %2: %3</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Gestopt</translation>
    </message>
    <message numerus="yes">
        <source>%n field(s) planned</source>
        <translation>
            <numerusform>%n perceel gepland</numerusform>
            <numerusform>%n percelen gepland</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n with problems</source>
        <translation>
            <numerusform>%n met problemen</numerusform>
            <numerusform>%n met problemen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n without a plan</source>
        <translation>
            <numerusform>%n zonder plan</numerusform>
            <numerusform>%n zonder plan</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>furrow::FieldEditor</name>
    <message>
        <source>Add a point</source>
        <translation>Punt toevoegen</translation>
    </message>
    <message>
        <source>Change the headland of an edge</source>
        <translation>Kopakker van een zijde wijzigen</translation>
    </message>
    <message>
        <source>Headland of an edge as elsewhere</source>
        <translation>Kopakker van een zijde zoals elders</translation>
    </message>
    <message>
        <source>Move a point</source>
        <translation>Punt verplaatsen</translation>
    </message>
    <message>
        <source>Move an edge</source>
        <translation>Zijde verplaatsen</translation>
    </message>
    <message>
        <source>Move a hole</source>
        <translation>Gat verplaatsen</translation>
    </message>
    <message>
        <source>Move an obstacle</source>
        <translation>Obstakel verplaatsen</translation>
    </message>
    <message>
        <source>Move a gate</source>
        <translation>Inrit verplaatsen</translation>
    </message>
    <message>
        <source>Change the buffer</source>
        <translation>Afstand wijzigen</translation>
    </message>
    <message>
        <source>Change the overhang of an obstacle</source>
        <translation>Overhang van een obstakel wijzigen</translation>
    </message>
    <message>
        <source>Change the overhang of an edge</source>
        <translation>Overhang van een zijde wijzigen</translation>
    </message>
    <message>
        <source>Draw a hole</source>
        <translation>Gat tekenen</translation>
    </message>
    <message>
        <source>Draw an obstacle</source>
        <translation>Obstakel tekenen</translation>
    </message>
    <message>
        <source>Obstacle %1</source>
        <translation>Obstakel %1</translation>
    </message>
    <message>
        <source>Add a gate</source>
        <translation>Inrit toevoegen</translation>
    </message>
    <message>
        <source>Gate %1</source>
        <translation>Inrit %1</translation>
    </message>
    <message>
        <source>Draw a guidance curve</source>
        <translation>Stuurcurve tekenen</translation>
    </message>
    <message>
        <source>Draw an AB line</source>
        <translation>AB-lijn tekenen</translation>
    </message>
    <message>
        <source>Delete a point</source>
        <translation>Punt verwijderen</translation>
    </message>
    <message>
        <source>Delete a hole</source>
        <translation>Gat verwijderen</translation>
    </message>
    <message>
        <source>Delete an obstacle</source>
        <translation>Obstakel verwijderen</translation>
    </message>
    <message>
        <source>Delete a gate</source>
        <translation>Inrit verwijderen</translation>
    </message>
    <message>
        <source>Delete the guidance line</source>
        <translation>Stuurlijn verwijderen</translation>
    </message>
    <message>
        <source>Make steps straight</source>
        <translation>Trapjes recht maken</translation>
    </message>
    <message>
        <source>Made straight, it would be refused: %1; %2.</source>
        <translation>Recht gemaakt zou hij worden geweigerd: %1; %2.</translation>
    </message>
    <message numerus="yes">
        <source>%n field(s) stay as they are: %1.</source>
        <translation>
            <numerusform>%n perceel blijft zoals het is: %1.</numerusform>
            <numerusform>%n percelen blijven zoals ze zijn: %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Verplaatsen</translation>
    </message>
    <message>
        <source>Change a length</source>
        <translation>Lengte wijzigen</translation>
    </message>
    <message>
        <source>Change a direction</source>
        <translation>Richting wijzigen</translation>
    </message>
    <message>
        <source>Let the obstacle be driven on</source>
        <translation>Obstakel berijdbaar maken</translation>
    </message>
    <message>
        <source>Keep off the obstacle</source>
        <translation>Niet over het obstakel rijden</translation>
    </message>
    <message>
        <source>Change the gate</source>
        <translation>Inrit wijzigen</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Hernoemen</translation>
    </message>
    <message>
        <source>AB line along an edge</source>
        <translation>AB-lijn langs een zijde</translation>
    </message>
    <message>
        <source>Draw a split line</source>
        <translation>Splitlijn tekenen</translation>
    </message>
    <message>
        <source>Delete a split line</source>
        <translation>Splitlijn verwijderen</translation>
    </message>
</context>
<context>
    <name>furrow::FieldFromTrack</name>
    <message numerus="yes">
        <source>%n position(s)</source>
        <translation>
            <numerusform>%n positie</numerusform>
            <numerusform>%n posities</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n track(s)</source>
        <translation>
            <numerusform>%n rit</numerusform>
            <numerusform>%n ritten</numerusform>
        </translation>
    </message>
    <message>
        <source>The pieces do not touch: each becomes a field of its own.</source>
        <translation>De stukken raken elkaar niet: elk wordt een eigen perceel.</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Oppervlakte</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>Stukken</translation>
    </message>
    <message>
        <source>Holes</source>
        <translation>Gaten</translation>
    </message>
    <message>
        <source>Points of the boundary</source>
        <translation>Punten van de grens</translation>
    </message>
    <message>
        <source>Around the field</source>
        <translation>Rond het perceel</translation>
    </message>
    <message>
        <source>Over the whole field, at work</source>
        <translation>Over het hele perceel, aan het werk</translation>
    </message>
    <message>
        <source>As it looks: around the field</source>
        <translation>Zoals het eruitziet: rond het perceel</translation>
    </message>
    <message>
        <source>As it looks: over the field</source>
        <translation>Zoals het eruitziet: over het perceel</translation>
    </message>
    <message>
        <source>As it looks</source>
        <translation>Zoals het eruitziet</translation>
    </message>
</context>
<context>
    <name>furrow::FieldOpener</name>
    <message numerus="yes">
        <source>%n file(s)</source>
        <translation>
            <numerusform>%n bestand</numerusform>
            <numerusform>%n bestanden</numerusform>
        </translation>
    </message>
    <message>
        <source>Add field %1</source>
        <translation>Perceel %1 toevoegen</translation>
    </message>
    <message numerus="yes">
        <source>Add %n field(s)</source>
        <translation>
            <numerusform>%n perceel toevoegen</numerusform>
            <numerusform>%n percelen toevoegen</numerusform>
        </translation>
    </message>
    <message>
        <source>Field %1</source>
        <translation>Perceel %1</translation>
    </message>
    <message>
        <source>drawn on the map</source>
        <translation>op de kaart getekend</translation>
    </message>
</context>
<context>
    <name>furrow::FiguresModel</name>
    <message>
        <source>Area</source>
        <translation>Oppervlakte</translation>
    </message>
    <message>
        <source>Of the field, holes and obstacles taken out</source>
        <translation>Van het perceel, zonder gaten en obstakels</translation>
    </message>
    <message>
        <source>Inside the headland</source>
        <translation>Binnenakker</translation>
    </message>
    <message>
        <source>What is left inside the headland</source>
        <translation>De binnenakker: wat zonder de kopakker overblijft</translation>
    </message>
    <message>
        <source>Swaths</source>
        <translation>Werkgangen</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Traject</translation>
    </message>
    <message>
        <source>Everything that is driven</source>
        <translation>Alles wat gereden wordt</translation>
    </message>
    <message>
        <source>Working</source>
        <translation>Werken</translation>
    </message>
    <message>
        <source>Turning</source>
        <translation>Keren</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tijd</translation>
    </message>
    <message>
        <source>Covered</source>
        <translation>Bewerkt</translation>
    </message>
    <message>
        <source>Share of the field that is worked, measured on the finished path</source>
        <translation>Bewerkt deel van het perceel, gemeten op het voltooide traject</translation>
    </message>
    <message>
        <source>Overlap</source>
        <translation>Overlap</translation>
    </message>
    <message>
        <source>Share of the field that is worked twice</source>
        <translation>Deel van het perceel dat dubbel bewerkt wordt</translation>
    </message>
    <message>
        <source>Land that is not worked</source>
        <translation>Land dat niet wordt bewerkt</translation>
    </message>
    <message>
        <source>%1 cannot be reached by the implement, mostly in corners; %2 could be.</source>
        <translation>Bij %1 kan het werktuig niet komen, meestal in hoeken; bij %2 wel.</translation>
    </message>
    <message>
        <source>Missed</source>
        <translation>Gemiste plekken</translation>
    </message>
    <message>
        <source>Outside the field</source>
        <translation>Buiten het perceel</translation>
    </message>
    <message>
        <source>Ground outside that the machine or its implement drives over</source>
        <translation>Grond erbuiten waar machine of werktuig over rijdt</translation>
    </message>
</context>
<context>
    <name>furrow::FileBrowser</name>
    <message>
        <source>This folder cannot be read.</source>
        <translation>Deze map kan niet worden gelezen.</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Persoonlijke map</translation>
    </message>
    <message>
        <source>Documents</source>
        <translation>Documenten</translation>
    </message>
    <message>
        <source>Downloads</source>
        <translation>Downloads</translation>
    </message>
    <message>
        <source>Desktop</source>
        <translation>Bureaublad</translation>
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
        <translation>geen problemen</translation>
    </message>
    <message numerus="yes">
        <source>%n problem(s)</source>
        <translation>
            <numerusform>%n probleem</numerusform>
            <numerusform>%n problemen</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 → %2. Before: %3. Now: %4.</source>
        <translation>%1 → %2. Eerst: %3. Nu: %4.</translation>
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
        <translation>geen werkgang past</translation>
    </message>
    <message numerus="yes">
        <source>%n swath(s)</source>
        <translation>
            <numerusform>%n werkgang</numerusform>
            <numerusform>%n werkgangen</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 turning</source>
        <translation>%1 keren</translation>
    </message>
    <message>
        <source>%1 twice</source>
        <translation>%1 dubbel</translation>
    </message>
    <message>
        <source>%1 missed</source>
        <translation>%1 gemist</translation>
    </message>
    <message>
        <source>Swaths along %1</source>
        <translation>Werkgangen in richting %1</translation>
    </message>
    <message>
        <source>Search the heading</source>
        <translation>Richting zoeken</translation>
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
        <translation>%1 toevoegen</translation>
    </message>
    <message>
        <source>Add imagery</source>
        <translation>Luchtfoto toevoegen</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>%1 verwijderen</translation>
    </message>
    <message>
        <source>Move a layer</source>
        <translation>Laag verplaatsen</translation>
    </message>
    <message>
        <source>Rename a layer</source>
        <translation>Laag hernoemen</translation>
    </message>
    <message>
        <source>Show a layer</source>
        <translation>Laag tonen</translation>
    </message>
    <message>
        <source>Hide a layer</source>
        <translation>Laag verbergen</translation>
    </message>
    <message>
        <source>Change how strong a layer is</source>
        <translation>Dekking van een laag wijzigen</translation>
    </message>
    <message>
        <source>Turn the rows of tiles round</source>
        <translation>Volgorde van de tegelrijen omkeren</translation>
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
        <translation>Opdrachtnummer</translation>
    </message>
    <message>
        <source>Customer</source>
        <translation>Klant</translation>
    </message>
    <message>
        <source>Field address</source>
        <translation>Adres van het perceel</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>Bestuurder</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tijd</translation>
    </message>
    <message>
        <source>Product</source>
        <translation>Product</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Dosering</translation>
    </message>
    <message>
        <source>Unit of the rate</source>
        <translation>Eenheid van de dosering</translation>
    </message>
    <message>
        <source>Area worked</source>
        <translation>Bewerkte oppervlakte</translation>
    </message>
    <message>
        <source>Hours worked</source>
        <translation>Gewerkte uren</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Opmerkingen</translation>
    </message>
    <message>
        <source>%1 per acre</source>
        <translation>%1 per acre</translation>
    </message>
    <message>
        <source>%1 per hectare</source>
        <translation>%1 per hectare</translation>
    </message>
    <message>
        <source>Change the work order</source>
        <translation>Werkopdracht wijzigen</translation>
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
            <numerusform>%n plaats op de kaart</numerusform>
            <numerusform>%n plaatsen op de kaart</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>a line of %n point(s)</source>
        <translation>
            <numerusform>een lijn van %n punt</numerusform>
            <numerusform>een lijn van %n punten</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n line(s)</source>
        <translation>
            <numerusform>%n lijn</numerusform>
            <numerusform>%n lijnen</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>furrow::PlanChange</name>
    <message>
        <source>time %1</source>
        <translation>tijd %1</translation>
    </message>
    <message>
        <source>path %1</source>
        <translation>traject %1</translation>
    </message>
    <message>
        <source>covered %1</source>
        <translation>bewerkt %1</translation>
    </message>
    <message>
        <source>worked twice %1</source>
        <translation>dubbel bewerkt %1</translation>
    </message>
    <message>
        <source>With the last change: the same time, length and area.</source>
        <translation>Met de laatste wijziging: dezelfde tijd, lengte en oppervlakte.</translation>
    </message>
    <message>
        <source>With the last change: %1</source>
        <translation>Met de laatste wijziging: %1</translation>
    </message>
</context>
<context>
    <name>furrow::PlanComparison</name>
    <message>
        <source>Time</source>
        <translation>Tijd</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Traject</translation>
    </message>
    <message>
        <source>Working</source>
        <translation>Werken</translation>
    </message>
    <message>
        <source>Turning</source>
        <translation>Keren</translation>
    </message>
    <message>
        <source>Swaths</source>
        <translation>Werkgangen</translation>
    </message>
    <message>
        <source>Covered</source>
        <translation>Bewerkt</translation>
    </message>
    <message>
        <source>Missed</source>
        <translation>Gemiste plekken</translation>
    </message>
    <message>
        <source>Overlap</source>
        <translation>Overlap</translation>
    </message>
    <message>
        <source>Outside the field</source>
        <translation>Buiten het perceel</translation>
    </message>
    <message>
        <source>In reverse</source>
        <translation>Achteruit</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Problemen</translation>
    </message>
    <message>
        <source>The standard settings</source>
        <translation>De standaardinstellingen</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Machine</translation>
    </message>
    <message>
        <source>All swaths lie in the same places.</source>
        <translation>Alle werkgangen liggen op dezelfde plaats.</translation>
    </message>
    <message numerus="yes">
        <source>%n swath(s) of the other plan lie elsewhere.</source>
        <translation>
            <numerusform>%n werkgang van het andere plan ligt elders.</numerusform>
            <numerusform>%n werkgangen van het andere plan liggen elders.</numerusform>
        </translation>
    </message>
    <message>
        <source>Take the standard settings</source>
        <translation>Standaardinstellingen nemen</translation>
    </message>
    <message>
        <source>Inside the headland</source>
        <translation>Binnenakker</translation>
    </message>
    <message>
        <source>Headland passes: %1 only in this plan, %2 only in the other.</source>
        <translation>Kopakkergangen: %1 alleen in dit plan, %2 alleen in het andere.</translation>
    </message>
    <message>
        <source>Turns and ways: %1 only in this plan, %2 only in the other.</source>
        <translation>Draaien en wegen: %1 alleen in dit plan, %2 alleen in het andere.</translation>
    </message>
    <message>
        <source>All headland passes lie in the same places.</source>
        <translation>Alle kopakkergangen liggen op dezelfde plaatsen.</translation>
    </message>
    <message>
        <source>All turns and ways lie in the same places.</source>
        <translation>Alle draaien en wegen liggen op dezelfde plaatsen.</translation>
    </message>
</context>
<context>
    <name>furrow::Planning</name>
    <message>
        <source>Change the machine</source>
        <translation>Machine wijzigen</translation>
    </message>
    <message>
        <source>Reading %1 …</source>
        <translation>%1 lezen…</translation>
    </message>
    <message numerus="yes">
        <source>%n field(s) in this file</source>
        <translation>
            <numerusform>%n perceel in dit bestand</numerusform>
            <numerusform>%n percelen in dit bestand</numerusform>
        </translation>
    </message>
    <message>
        <source>Planning …</source>
        <translation>Bezig met plannen…</translation>
    </message>
    <message>
        <source>No plan</source>
        <translation>Geen plan</translation>
    </message>
    <message>
        <source>Plan ready · %1 ms</source>
        <translation>Plan klaar · %1 ms</translation>
    </message>
    <message>
        <source>Plan ready · %1 s</source>
        <translation>Plan klaar · %1 s</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>Change: %1</source>
        <translation>Wijzigen: %1</translation>
    </message>
    <message>
        <source>Draft · planning …</source>
        <translation>Concept · bezig met plannen…</translation>
    </message>
    <message>
        <source>Draft · the whole plan follows when you let go</source>
        <translation>Concept · het hele plan volgt bij het loslaten</translation>
    </message>
    <message>
        <source>Out of date · this is a draft</source>
        <translation>Verouderd · dit is een concept</translation>
    </message>
    <message>
        <source>Out of date · this is the plan before the change</source>
        <translation>Verouderd · dit is het plan van vóór de wijziging</translation>
    </message>
    <message>
        <source>Stopped · there is no plan</source>
        <translation>Gestopt · er is geen plan</translation>
    </message>
    <message numerus="yes">
        <source>%n problem(s)</source>
        <translation>
            <numerusform>%n probleem</numerusform>
            <numerusform>%n problemen</numerusform>
        </translation>
    </message>
    <message>
        <source>Out of date · this is a first plan</source>
        <translation>Verouderd · dit is een eerste plan</translation>
    </message>
    <message>
        <source>First plan · being improved …</source>
        <translation>Eerste plan · wordt verbeterd…</translation>
    </message>
    <message>
        <source>First plan · comparing plan %1 …</source>
        <translation>Eerste plan · vergelijkt plan %1…</translation>
    </message>
    <message>
        <source>Planning … · comparing plan %1</source>
        <translation>Bezig met plannen… · vergelijkt plan %1</translation>
    </message>
</context>
<context>
    <name>furrow::Printing</name>
    <message>
        <source>There is no field yet, and no plan to print.</source>
        <translation>Er is nog geen perceel en geen plan om af te drukken.</translation>
    </message>
    <message>
        <source>The plan is still being made. It can be printed when it is finished.</source>
        <translation>Het plan wordt nog gemaakt. Het kan worden afgedrukt als het klaar is.</translation>
    </message>
    <message>
        <source>The plan is out of date. Plan again to print it.</source>
        <translation>Het plan is verouderd. Plan opnieuw om het af te drukken.</translation>
    </message>
    <message>
        <source>There is no plan to print. The message on the map says why.</source>
        <translation>Er is geen plan om af te drukken. De melding op de kaart zegt waarom.</translation>
    </message>
    <message>
        <source>Work order</source>
        <translation>Werkopdracht</translation>
    </message>
    <message>
        <source>Work orders</source>
        <translation>Werkopdrachten</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Geschreven: %1</translation>
    </message>
    <message>
        <source>The printer %1 did not take the pages.</source>
        <translation>De printer %1 nam de pagina&apos;s niet aan.</translation>
    </message>
    <message>
        <source>Look whether it is on, or save a PDF and print that.</source>
        <translation>Kijk of hij aan staat, of sla een PDF op en druk die af.</translation>
    </message>
    <message>
        <source>Sent to %1</source>
        <translation>Verzonden naar %1</translation>
    </message>
</context>
<context>
    <name>furrow::ProjectFiles</name>
    <message>
        <source>Your last work was not saved. Here it is again.</source>
        <translation>Het laatste werk was niet opgeslagen. Hier is het weer.</translation>
    </message>
    <message>
        <source>Changes of “%1” were not saved. Here they are again.</source>
        <translation>Wijzigingen in ‘%1’ waren niet opgeslagen. Hier zijn ze weer.</translation>
    </message>
    <message>
        <source>It is kept in the file all the same.</source>
        <translation>Het blijft toch in het bestand staan.</translation>
    </message>
    <message>
        <source>Restore changes that were not saved</source>
        <translation>Niet opgeslagen wijzigingen herstellen</translation>
    </message>
    <message>
        <source>Another program changed “%1” while changes of yours were not saved. Yours are shown; undo shows the file.</source>
        <translation>Een ander programma heeft ‘%1’ gewijzigd terwijl eigen wijzigingen niet opgeslagen waren. De eigen worden getoond; ongedaan maken toont het bestand.</translation>
    </message>
    <message>
        <source>Another program has changed “%1” since it was opened here.</source>
        <translation>Een ander programma heeft ‘%1’ gewijzigd sinds het hier geopend is.</translation>
    </message>
    <message>
        <source>Save over it, or save yours under another name.</source>
        <translation>Overschrijven, of onder een andere naam opslaan.</translation>
    </message>
    <message>
        <source>Farm</source>
        <translation>Bedrijf</translation>
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
        <translation>Dit is geen lengte. Typ bijvoorbeeld 7,3 m, 24 ft of 10&apos;6&quot;.</translation>
    </message>
    <message>
        <source>This is not an area. Type it like 12.5 ha or 30 ac.</source>
        <translation>Dit is geen oppervlakte. Typ bijvoorbeeld 12,5 ha of 30 ac.</translation>
    </message>
    <message>
        <source>This is not a speed. Type it like 8 km/h or 5 mph.</source>
        <translation>Dit is geen snelheid. Typ bijvoorbeeld 8 km/h of 5 mph.</translation>
    </message>
    <message>
        <source>This is not an angle. Type it in degrees, like 87.5.</source>
        <translation>Dit is geen hoek. Typ hem in graden, bijvoorbeeld 87,5.</translation>
    </message>
    <message>
        <source>This is not a number.</source>
        <translation>Dit is geen getal.</translation>
    </message>
    <message>
        <source>This is not a whole number.</source>
        <translation>Dit is geen heel getal.</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>Type something from %1 to %2.</source>
        <translation>Typ een waarde van %1 tot %2.</translation>
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
        <translation>Dit is geen tijd. Typ bijvoorbeeld 45 s of 2 min.</translation>
    </message>
</context>
<context>
    <name>furrow::RecentFiles</name>
    <message numerus="yes">
        <source>%n field(s)</source>
        <translation>
            <numerusform>%n perceel</numerusform>
            <numerusform>%n percelen</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>furrow::ReviewModel</name>
    <message>
        <source>Only a finished plan of what the panels show can be sent.</source>
        <translation>Alleen een afgerond plan bij de getoonde instellingen kan worden verstuurd.</translation>
    </message>
    <message>
        <source>Approved: %1</source>
        <translation>Goedgekeurd: %1</translation>
    </message>
    <message>
        <source>Changes wanted: %1</source>
        <translation>Wijzigingen gewenst: %1</translation>
    </message>
    <message>
        <source>Send back…</source>
        <translation>Terugsturen…</translation>
    </message>
    <message>
        <source>Send on…</source>
        <translation>Doorsturen…</translation>
    </message>
    <message>
        <source>Send for review…</source>
        <translation>Ter beoordeling sturen…</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>Opmerking</translation>
    </message>
    <message>
        <source>Remove a comment</source>
        <translation>Opmerking verwijderen</translation>
    </message>
    <message>
        <source>Settle a comment</source>
        <translation>Opmerking afhandelen</translation>
    </message>
    <message>
        <source>Open a comment again</source>
        <translation>Opmerking heropenen</translation>
    </message>
    <message>
        <source>Approve the plan</source>
        <translation>Plan goedkeuren</translation>
    </message>
    <message>
        <source>Ask for changes</source>
        <translation>Wijzigingen vragen</translation>
    </message>
    <message>
        <source>Take the verdict back</source>
        <translation>Oordeel intrekken</translation>
    </message>
    <message>
        <source>review</source>
        <translation>beoordeling</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Send for review</source>
        <translation>Ter beoordeling sturen</translation>
    </message>
    <message>
        <source>Written: %1. Whoever has Furrow can open it, comment on it and send it back.</source>
        <translation>Geschreven: %1. Wie Furrow heeft, kan het bestand openen, van opmerkingen voorzien en terugsturen.</translation>
    </message>
    <message>
        <source>Take in a review</source>
        <translation>Beoordeling overnemen</translation>
    </message>
    <message numerus="yes">
        <source>%n new comment(s)</source>
        <translation>
            <numerusform>%n nieuwe opmerking</numerusform>
            <numerusform>%n nieuwe opmerkingen</numerusform>
        </translation>
    </message>
    <message>
        <source>The review was brought up to date</source>
        <translation>De beoordeling is bijgewerkt</translation>
    </message>
    <message>
        <source>Nothing new in this review</source>
        <translation>Niets nieuws in deze beoordeling</translation>
    </message>
    <message>
        <source>%1. The plan has changed since it was sent.</source>
        <translation>%1. Het plan is sinds het versturen gewijzigd.</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1.</translation>
    </message>
    <message>
        <source>Edit a comment</source>
        <translation>Opmerking bewerken</translation>
    </message>
</context>
<context>
    <name>furrow::StepsModel</name>
    <message numerus="yes">
        <source>%1 but for %n edge(s)</source>
        <translation>
            <numerusform>%1 behalve aan %n zijde</numerusform>
            <numerusform>%1 behalve aan %n zijden</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 inside</source>
        <translation>binnenakker %1</translation>
    </message>
    <message numerus="yes">
        <source>%n pass(es)</source>
        <translation>
            <numerusform>%n gang</numerusform>
            <numerusform>%n gangen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n block(s)</source>
        <translation>
            <numerusform>%n deelperceel</numerusform>
            <numerusform>%n deelpercelen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n swath(s)</source>
        <translation>
            <numerusform>%n werkgang</numerusform>
            <numerusform>%n werkgangen</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 with turns on the spot</source>
        <translation>%1 met draaien op de plaats</translation>
    </message>
    <message numerus="yes">
        <source>%n turn(s)</source>
        <translation>
            <numerusform>%n draai</numerusform>
            <numerusform>%n draaien</numerusform>
        </translation>
    </message>
    <message>
        <source>No usable boundary</source>
        <translation>Geen bruikbare perceelsgrens</translation>
    </message>
    <message>
        <source>No field yet</source>
        <translation>Nog geen perceel</translation>
    </message>
    <message numerus="yes">
        <source>%n obstacle(s)</source>
        <translation>
            <numerusform>%n obstakel</numerusform>
            <numerusform>%n obstakels</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n hole(s)</source>
        <translation>
            <numerusform>%n gat</numerusform>
            <numerusform>%n gaten</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n boundary point(s)</source>
        <translation>
            <numerusform>%n grenspunt</numerusform>
            <numerusform>%n grenspunten</numerusform>
        </translation>
    </message>
    <message>
        <source>The message on the map says why</source>
        <translation>De melding op de kaart zegt waarom</translation>
    </message>
    <message>
        <source>Open a file or draw a boundary</source>
        <translation>Bestand openen of grens tekenen</translation>
    </message>
    <message>
        <source>%1 wide</source>
        <translation>%1 breed</translation>
    </message>
    <message>
        <source>%1 radius</source>
        <translation>%1 straal</translation>
    </message>
    <message>
        <source>Field</source>
        <translation>Perceel</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Machine</translation>
    </message>
    <message numerus="yes">
        <source>%n problem(s)</source>
        <translation>
            <numerusform>%n probleem</numerusform>
            <numerusform>%n problemen</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing to check yet</source>
        <translation>Nog niets te controleren</translation>
    </message>
    <message>
        <source>Planning …</source>
        <translation>Bezig met plannen…</translation>
    </message>
    <message>
        <source>No plan</source>
        <translation>Geen plan</translation>
    </message>
    <message>
        <source>Out of date</source>
        <translation>Verouderd</translation>
    </message>
    <message>
        <source>Plan again to check what the panels show</source>
        <translation>Opnieuw plannen om dit te controleren</translation>
    </message>
    <message>
        <source>No problems</source>
        <translation>Geen problemen</translation>
    </message>
    <message numerus="yes">
        <source>%n note(s)</source>
        <translation>
            <numerusform>%n bevinding</numerusform>
            <numerusform>%n bevindingen</numerusform>
        </translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Controle</translation>
    </message>
    <message>
        <source>proved: no order is better</source>
        <translation>aantoonbaar de beste</translation>
    </message>
    <message>
        <source>turns within %1 of the best</source>
        <translation>draaien: hooguit +%1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>To a stick, to files or on paper</source>
        <translation>Naar stick, bestand of papier</translation>
    </message>
    <message>
        <source>No plan to export yet</source>
        <translation>Nog geen plan om te exporteren</translation>
    </message>
    <message>
        <source>Waits for the finished plan</source>
        <translation>Wacht op het voltooide plan</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exporteren</translation>
    </message>
    <message>
        <source>First plan, being improved</source>
        <translation>Eerste plan, wordt verbeterd</translation>
    </message>
    <message>
        <source>Only the finished plan is checked</source>
        <translation>Alleen het voltooide plan wordt gecontroleerd</translation>
    </message>
    <message>
        <source>Until then the map shows the plan before</source>
        <translation>Tot dan toont de kaart het vorige plan</translation>
    </message>
</context>
<context>
    <name>furrow::StickExport</name>
    <message>
        <source>%1 free of %2</source>
        <translation>%1 vrij van %2</translation>
    </message>
    <message>
        <source>Writing …</source>
        <translation>Bezig met schrijven…</translation>
    </message>
    <message>
        <source>every byte was read back, and the plan read from there is this plan.</source>
        <translation>elke byte is teruggelezen, en het gelezen plan is gelijk aan dit plan.</translation>
    </message>
    <message>
        <source>every byte was read back and is as written.</source>
        <translation>elke byte is teruggelezen en is zoals geschreven.</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Geschreven: %1</translation>
    </message>
    <message>
        <source>Safe to unplug: %1</source>
        <translation>Stick kan eruit: %1</translation>
    </message>
    <message>
        <source>What was there before is kept as %1.</source>
        <translation>Wat er eerst stond, blijft bewaard als %1.</translation>
    </message>
    <message>
        <source>Writing was stopped, because the plan was changed meanwhile.</source>
        <translation>Het schrijven is gestopt, omdat het plan intussen is gewijzigd.</translation>
    </message>
    <message>
        <source>Write it again when the plan is finished.</source>
        <translation>Schrijf het opnieuw als het plan klaar is.</translation>
    </message>
    <message>
        <source>every byte was read back, and the fields read from there are these.</source>
        <translation>elke byte is teruggelezen, en de percelen van daar zijn deze.</translation>
    </message>
</context>
<context>
    <name>furrow::SwathOrder</name>
    <message>
        <source>Search the order of the other swaths</source>
        <translation>Volgorde van de andere werkgangen zoeken</translation>
    </message>
    <message>
        <source>Search the order</source>
        <translation>Volgorde zoeken</translation>
    </message>
    <message>
        <source>Change the order of swaths</source>
        <translation>Volgorde van werkgangen wijzigen</translation>
    </message>
</context>
<context>
    <name>furrow::TroubleReport</name>
    <message>
        <source>The report could not be written: %1</source>
        <translation>Het verslag kon niet worden geschreven: %1</translation>
    </message>
    <message>
        <source>The report is in %1.</source>
        <translation>Het verslag staat in %1.</translation>
    </message>
</context>
</TS>
