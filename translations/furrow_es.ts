<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es_ES" sourcelanguage="en">
<context>
    <name>AboutDialog</name>
    <message>
        <source>Furrow %1</source>
        <translation>Furrow %1</translation>
    </message>
    <message>
        <source>Furrow plans how a machine covers a farm field.</source>
        <translation>Furrow planifica cómo trabaja una máquina una parcela.</translation>
    </message>
    <message>
        <source>Free software under the BSD 3-Clause licence: use it, change it and pass it on, without any warranty.</source>
        <translation>Software libre con la licencia BSD de 3 cláusulas: úselo, modifíquelo y compártalo, sin garantía alguna.</translation>
    </message>
    <message>
        <source>The methods follow the Fields2Cover paper (Mier, Valente and de Bruin, 2023) and the sources that the design names.</source>
        <translation>Los métodos siguen el artículo de Fields2Cover (Mier, Valente y de Bruin, 2023) y las fuentes citadas en el documento de diseño.</translation>
    </message>
    <message>
        <source>Built with %1.</source>
        <translation>Construido con %1.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
</context>
<context>
    <name>BestPlanDialog</name>
    <message>
        <source>The best plan found</source>
        <translation>El mejor plan encontrado</translation>
    </message>
    <message>
        <source>Your plan is the best one found</source>
        <translation>Su plan es el mejor encontrado</translation>
    </message>
    <message>
        <source>Find the best plan</source>
        <translation>Buscar el mejor plan</translation>
    </message>
    <message>
        <source>Other choices are planned, and the quickest plan that can be driven is taken. Margins, overlap and what the operation needs stay as they are.</source>
        <translation>Se planifican otras opciones y se toma el plan realizable más rápido. Los márgenes, el solape y lo que exige la labor quedan como están.</translation>
    </message>
    <message>
        <source>May change</source>
        <translation>Puede cambiar</translation>
    </message>
    <message>
        <source>%1 (set by you)</source>
        <translation>%1 (su elección)</translation>
    </message>
    <message>
        <source>Best plan</source>
        <translation>Mejor plan</translation>
    </message>
    <message>
        <source>Best so far</source>
        <translation>Mejor hasta ahora</translation>
    </message>
    <message>
        <source>As it was</source>
        <translation>Antes</translation>
    </message>
    <message>
        <source>Saved</source>
        <translation>Ahorrado</translation>
    </message>
    <message>
        <source>Time of the best plan during the search</source>
        <translation>Tiempo del mejor plan durante la búsqueda</translation>
    </message>
    <message numerus="yes">
        <source>%n alternative(s) were planned.</source>
        <translation>
            <numerusform>Se planificó %n alternativa.</numerusform>
            <numerusform>Se planificaron %n alternativas.</numerusform>
        </translation>
    </message>
    <message>
        <source>Times include working separately what a plan leaves.</source>
        <translation>Los tiempos incluyen trabajar aparte lo que un plan deja.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Buscar</translation>
    </message>
    <message>
        <source>Stop and keep</source>
        <translation>Detener y conservar</translation>
    </message>
    <message>
        <source>Use this plan</source>
        <translation>Usar este plan</translation>
    </message>
</context>
<context>
    <name>CellStepper</name>
    <message>
        <source>Done</source>
        <translation>Listo</translation>
    </message>
    <message>
        <source>Go through the steps</source>
        <translation>Recorrer los pasos</translation>
    </message>
    <message>
        <source>Next step</source>
        <translation>Paso siguiente</translation>
    </message>
    <message>
        <source>Previous step</source>
        <translation>Paso anterior</translation>
    </message>
    <message>
        <source>Show the blocks</source>
        <translation>Mostrar las subparcelas</translation>
    </message>
    <message>
        <source>Step of the blocks</source>
        <translation>Paso de las subparcelas</translation>
    </message>
    <message>
        <source>Turns and ways from block to block, estimated.</source>
        <translation>Giros y trayectos de una subparcela a otra, estimados.</translation>
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
            <numerusform>%n más es aún más lenta o irrealizable.</numerusform>
            <numerusform>%n más son aún más lentas o irrealizables.</numerusform>
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
        <translation>Mayús</translation>
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
        <translation>No hay ningún comando ni ajuste con ese nombre</translation>
    </message>
    <message>
        <source>Search commands, settings, coordinates</source>
        <translation>Buscar comandos, ajustes, coordenadas</translation>
    </message>
    <message>
        <source>As maps, phones and receivers write them</source>
        <translation>Como las escriben mapas, teléfonos y receptores</translation>
    </message>
</context>
<context>
    <name>CommentPins</name>
    <message>
        <source>Comment %1: %2</source>
        <translation>Comentario %1: %2</translation>
    </message>
    <message>
        <source>Click the place that you want to comment on. Esc ends it.</source>
        <translation>Haga clic en el lugar que quiere comentar. Esc para terminar.</translation>
    </message>
</context>
<context>
    <name>CommentRow</name>
    <message>
        <source>Comment %1 by %2: %3</source>
        <translation>Comentario %1 de %2: %3</translation>
    </message>
    <message>
        <source>Of a plan before the last change</source>
        <translation>De un plan anterior al último cambio</translation>
    </message>
    <message>
        <source>Open again</source>
        <translation>Reabrir</translation>
    </message>
    <message>
        <source>Settled</source>
        <translation>Resuelto</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Editar</translation>
    </message>
</context>
<context>
    <name>ComparePanel</name>
    <message>
        <source>Compare</source>
        <translation>Comparar</translation>
    </message>
    <message>
        <source>%1 beside</source>
        <translation>%1 junto a</translation>
    </message>
    <message>
        <source>The other plan</source>
        <translation>El otro plan</translation>
    </message>
    <message>
        <source>Keep this plan as a variant…</source>
        <translation>Guardar este plan como variante…</translation>
    </message>
    <message>
        <source>The other plan is being made …</source>
        <translation>Se está calculando el otro plan…</translation>
    </message>
    <message>
        <source>This plan</source>
        <translation>Este plan</translation>
    </message>
    <message>
        <source>The other</source>
        <translation>El otro</translation>
    </message>
    <message>
        <source>%1: %2, the other %3</source>
        <translation>%1: %2, el otro %3</translation>
    </message>
    <message>
        <source>Hold to see the other plan (key X)</source>
        <translation>Mantenga para ver el otro plan (tecla X)</translation>
    </message>
    <message>
        <source>What was chosen otherwise</source>
        <translation>Opciones distintas</translation>
    </message>
    <message>
        <source>Machine and settings are the same.</source>
        <translation>La máquina y los ajustes son iguales.</translation>
    </message>
    <message>
        <source>%1 → %2</source>
        <translation>%1 → %2</translation>
    </message>
    <message>
        <source>Go on with the other plan</source>
        <translation>Seguir con el otro plan</translation>
    </message>
    <message>
        <source>Two maps side by side (Ctrl+Shift+D)</source>
        <translation>Dos mapas uno junto al otro (Ctrl+Mayús+D)</translation>
    </message>
    <message>
        <source>On the maps, swaths, headland passes and turns are coloured that the other plan has not: full lines in this plan, dashes in the other.</source>
        <translation>En los mapas se colorean las pasadas, pasadas de cabecera y giros que el otro plan no tiene: líneas continuas en este plan, a trazos en el otro.</translation>
    </message>
    <message>
        <source>On the map, swaths, headland passes and turns: full lines only in this plan, dashes only in the other.</source>
        <translation>En el mapa, pasadas, pasadas de cabecera y giros: líneas continuas solo en este plan, a trazos solo en el otro.</translation>
    </message>
</context>
<context>
    <name>CrashNotice</name>
    <message>
        <source>Furrow ended unexpectedly the last time.</source>
        <translation>Furrow se cerró inesperadamente la última vez.</translation>
    </message>
    <message>
        <source>Your work was kept up to the last half second. What happened is recorded on this computer; a report helps to mend it.</source>
        <translation>Su trabajo se conservó hasta el último medio segundo. Lo ocurrido está registrado en este ordenador; un informe ayuda a corregirlo.</translation>
    </message>
    <message>
        <source>Report a problem…</source>
        <translation>Informar de un problema…</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
</context>
<context>
    <name>DrawingNotice</name>
    <message>
        <source>The map cannot show fields and plans: this window is drawn without OpenGL.</source>
        <translation>El mapa no puede mostrar parcelas ni planes: esta ventana se dibuja sin OpenGL.</translation>
    </message>
    <message>
        <source>Install a graphics driver with OpenGL; Mesa draws on any processor. The command line plans and exports all the same.</source>
        <translation>Instale un controlador gráfico con OpenGL; Mesa dibuja con cualquier procesador. La línea de órdenes planifica y exporta de todos modos.</translation>
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
        <translation>Recorrido</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pausar</translation>
    </message>
    <message>
        <source>Drive through the plan</source>
        <translation>Recorrer el plan</translation>
    </message>
    <message>
        <source>Moment of the drive</source>
        <translation>Momento del recorrido</translation>
    </message>
    <message>
        <source>Pace: %1 times as fast</source>
        <translation>Ritmo: %1 veces más rápido</translation>
    </message>
    <message>
        <source>%1×</source>
        <translation>%1×</translation>
    </message>
    <message>
        <source>Let the map rest</source>
        <translation>Dejar quieto el mapa</translation>
    </message>
    <message>
        <source>Follow the machine</source>
        <translation>Seguir la máquina</translation>
    </message>
    <message>
        <source>Hide the drive-through</source>
        <translation>Ocultar el recorrido</translation>
    </message>
</context>
<context>
    <name>DrivenDialog</name>
    <message>
        <source>Open a recorded track</source>
        <translation>Abrir un recorrido grabado</translation>
    </message>
    <message>
        <source>Recorded tracks (%1)</source>
        <translation>Recorridos grabados (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Todos los archivos (*)</translation>
    </message>
</context>
<context>
    <name>DrivenPanel</name>
    <message>
        <source>Planned and driven</source>
        <translation>Planificado y recorrido</translation>
    </message>
    <message>
        <source>Go to the farthest place</source>
        <translation>Ir al lugar más alejado</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Distance from the plan</source>
        <translation>Distancia al plan</translation>
    </message>
    <message>
        <source>Another track…</source>
        <translation>Otro recorrido…</translation>
    </message>
    <message>
        <source>Make a field from it</source>
        <translation>Hacer una parcela de él</translation>
    </message>
</context>
<context>
    <name>EditCommands</name>
    <message>
        <source>Edit</source>
        <translation>Editar</translation>
    </message>
    <message>
        <source>Undo: %1</source>
        <translation>Deshacer: %1</translation>
    </message>
    <message>
        <source>Draw a point</source>
        <translation>Dibujar un punto</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Deshacer</translation>
    </message>
    <message>
        <source>Redo: %1</source>
        <translation>Rehacer: %1</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Rehacer</translation>
    </message>
    <message>
        <source>Delete what is selected</source>
        <translation>Eliminar la selección</translation>
    </message>
    <message>
        <source>Del</source>
        <translation>Supr</translation>
    </message>
    <message>
        <source>Select the next point</source>
        <translation>Seleccionar el punto siguiente</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Espacio</translation>
    </message>
    <message>
        <source>Select the next edge</source>
        <translation>Seleccionar el lado siguiente</translation>
    </message>
    <message>
        <source>Select the next outline, line or gate</source>
        <translation>Contorno, línea o entrada siguiente</translation>
    </message>
    <message>
        <source>PgDown</source>
        <translation>Av Pág</translation>
    </message>
    <message>
        <source>Find a command…</source>
        <translation>Buscar un comando…</translation>
    </message>
</context>
<context>
    <name>EmptyState</name>
    <message>
        <source>Which field?</source>
        <translation>¿Qué parcela?</translation>
    </message>
    <message>
        <source>Open its boundary, or drop the file anywhere on this window. Shapefile, GeoJSON, KML, GeoPackage, GML and others are understood, zipped or not.</source>
        <translation>Abra su límite o suelte el archivo en cualquier parte de esta ventana. Se leen shapefile, GeoJSON, KML, GeoPackage, GML y otros, comprimidos o no.</translation>
    </message>
    <message>
        <source>Open a file…</source>
        <translation>Abrir un archivo…</translation>
    </message>
    <message>
        <source>Draw it</source>
        <translation>Dibujarla</translation>
    </message>
    <message>
        <source>Or try one of these</source>
        <translation>O pruebe una de estas</translation>
    </message>
    <message>
        <source>Sample field %1</source>
        <translation>Parcela de ejemplo %1</translation>
    </message>
</context>
<context>
    <name>ErrorCourse</name>
    <message>
        <source>Distance from the plan along the recording, up to %1</source>
        <translation>Distancia al plan a lo largo de la grabación, hasta %1</translation>
    </message>
    <message>
        <source>%1 to the left</source>
        <translation>%1 a la izquierda</translation>
    </message>
    <message>
        <source>%1 to the right</source>
        <translation>%1 a la derecha</translation>
    </message>
</context>
<context>
    <name>ExportChecks</name>
    <message>
        <source>Choose another format or terminal, and report this.</source>
        <translation>Elija otro formato o terminal e informe de esto.</translation>
    </message>
    <message numerus="yes">
        <source>%n check(s) passed: nothing in the files that receivers stumble over.</source>
        <translation>
            <numerusform>%n comprobación superada: nada en los archivos que dé problemas en los terminales.</numerusform>
            <numerusform>%n comprobaciones superadas: nada en los archivos que dé problemas en los terminales.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ExportDialog</name>
    <message>
        <source>Export the plan</source>
        <translation>Exportar el plan</translation>
    </message>
    <message>
        <source>USB stick</source>
        <translation>Memoria USB</translation>
    </message>
    <message>
        <source>Files in a folder</source>
        <translation>Archivos en una carpeta</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Writing …</source>
        <translation>Escribiendo…</translation>
    </message>
    <message>
        <source>Write to the stick</source>
        <translation>Escribir en la memoria USB</translation>
    </message>
    <message>
        <source>Write files</source>
        <translation>Escribir los archivos</translation>
    </message>
    <message>
        <source>Plan again</source>
        <translation>Planificar de nuevo</translation>
    </message>
    <message numerus="yes">
        <source>%n problem(s) in this plan: it cannot be driven as drawn. The files say so too.</source>
        <translation>
            <numerusform>%n problema en este plan: no se puede recorrer tal como está. Los archivos también lo dicen.</numerusform>
            <numerusform>%n problemas en este plan: no se puede recorrer tal como está. Los archivos también lo dicen.</numerusform>
        </translation>
    </message>
    <message>
        <source>Export fields</source>
        <translation>Exportar parcelas</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Detener</translation>
    </message>
</context>
<context>
    <name>ExportFolderPage</name>
    <message>
        <source>Folder</source>
        <translation>Carpeta</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Elegir…</translation>
    </message>
    <message>
        <source>Folder for the plan</source>
        <translation>Carpeta para el plan</translation>
    </message>
    <message>
        <source>Fields without a plan are planned on the way. Each field gets a folder of its own; ISOXML and AgGPS hold all fields in one.</source>
        <translation>Las parcelas sin plan se planifican de paso. Cada parcela tiene su propia carpeta; ISOXML y AgGPS contienen todas las parcelas juntas.</translation>
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
        <translation>Memoria USB</translation>
    </message>
    <message>
        <source>No USB stick is plugged in. It appears here when it is; or choose a folder to carry the files yourself.</source>
        <translation>No hay ninguna memoria USB conectada. Aparecerá aquí al conectarla; o elija una carpeta para llevar los archivos usted mismo.</translation>
    </message>
    <message>
        <source>Another folder…</source>
        <translation>Otra carpeta…</translation>
    </message>
    <message>
        <source>%1 is on it already.</source>
        <translation>%1 ya está en ella.</translation>
    </message>
    <message>
        <source>It will not be deleted: it is kept under another name.</source>
        <translation>No se borrará: se conserva con otro nombre.</translation>
    </message>
    <message>
        <source>Keep it as a backup and write the plan</source>
        <translation>Guardarlo como copia y escribir el plan</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>y %n más</numerusform>
            <numerusform>y %n más</numerusform>
        </translation>
    </message>
    <message>
        <source>Folder in the place of a stick</source>
        <translation>Carpeta en lugar de una memoria USB</translation>
    </message>
    <message>
        <source>Also in a task, for terminals that show lines in tasks only</source>
        <translation>También en una tarea, si el terminal lo exige</translation>
    </message>
</context>
<context>
    <name>FarImageryNotice</name>
    <message>
        <source>This picture does not show the field: it lies %1 away.</source>
        <translation>Esta imagen no muestra la parcela: está a %1.</translation>
    </message>
    <message>
        <source>Go there</source>
        <translation>Ir allí</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
</context>
<context>
    <name>FarmHeader</name>
    <message>
        <source>%1, sorted downwards</source>
        <translation>%1, orden descendente</translation>
    </message>
    <message>
        <source>%1, sorted</source>
        <translation>%1, ordenado</translation>
    </message>
</context>
<context>
    <name>FarmPanel</name>
    <message>
        <source>The farm</source>
        <translation>La explotación</translation>
    </message>
    <message>
        <source>Find a field</source>
        <translation>Buscar una parcela</translation>
    </message>
    <message>
        <source>Find a field, season or machine</source>
        <translation>Buscar parcela, campaña o máquina</translation>
    </message>
    <message>
        <source>Back to the field (Esc)</source>
        <translation>Volver a la parcela (Esc)</translation>
    </message>
    <message>
        <source>Field</source>
        <translation>Parcela</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Máquina</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Superficie</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tiempo</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Recorrido</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Estado</translation>
    </message>
    <message>
        <source>Fields of the farm</source>
        <translation>Parcelas de la explotación</translation>
    </message>
    <message>
        <source>No field has these words.</source>
        <translation>Ninguna parcela tiene estas palabras.</translation>
    </message>
    <message>
        <source>There is no field yet.</source>
        <translation>Todavía no hay ninguna parcela.</translation>
    </message>
    <message>
        <source>Select none</source>
        <translation>No seleccionar ninguna</translation>
    </message>
    <message>
        <source>Select all</source>
        <translation>Seleccionar todas</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Detener</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>Aceptar</translation>
    </message>
    <message numerus="yes">
        <source>Plan %n field(s)</source>
        <translation>
            <numerusform>Planificar %n parcela</numerusform>
            <numerusform>Planificar %n parcelas</numerusform>
        </translation>
    </message>
    <message>
        <source>Planning …</source>
        <translation>Planificando…</translation>
    </message>
    <message>
        <source>All are planned</source>
        <translation>Todas planificadas</translation>
    </message>
    <message>
        <source>Machine and settings of this plan</source>
        <translation>Máquina y ajustes de este plan</translation>
    </message>
    <message>
        <source>Add a plan to each…</source>
        <translation>Añadir un plan a cada una…</translation>
    </message>
    <message>
        <source>Print…</source>
        <translation>Imprimir…</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportar…</translation>
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
        <translation>Abrir archivo…</translation>
    </message>
    <message>
        <source>Draw</source>
        <translation>Dibujar</translation>
    </message>
    <message>
        <source>Sample field</source>
        <translation>Parcela de ejemplo</translation>
    </message>
    <message>
        <source>Add one to look at</source>
        <translation>Añadir una para verla</translation>
    </message>
</context>
<context>
    <name>FieldChooser</name>
    <message numerus="yes">
        <source>Which of the %n field(s)?</source>
        <translation>
            <numerusform>¿Qué parcela (%n)?</numerusform>
            <numerusform>¿Cuál de las %n parcelas?</numerusform>
        </translation>
    </message>
    <message>
        <source>Open none of them</source>
        <translation>No abrir ninguna</translation>
    </message>
    <message>
        <source>Open all of them</source>
        <translation>Abrirlas todas</translation>
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
        <translation>Parcela</translation>
    </message>
    <message>
        <source>Draw a field</source>
        <translation>Dibujar una parcela</translation>
    </message>
    <message>
        <source>boundary polygon</source>
        <translation>límite polígono</translation>
    </message>
    <message>
        <source>Make a field from a recorded track…</source>
        <translation>Hacer una parcela de un recorrido grabado…</translation>
    </message>
    <message>
        <source>boundary driven recorded GPX NMEA log drive around</source>
        <translation>límite conducido grabado GPX NMEA rodear</translation>
    </message>
    <message>
        <source>Draw a hole</source>
        <translation>Dibujar un hueco</translation>
    </message>
    <message>
        <source>Draw an obstacle</source>
        <translation>Dibujar un obstáculo</translation>
    </message>
    <message>
        <source>pond tree pole wet</source>
        <translation>charca árbol poste húmedo</translation>
    </message>
    <message>
        <source>Draw an AB line</source>
        <translation>Dibujar una línea AB</translation>
    </message>
    <message>
        <source>guidance curve direction</source>
        <translation>guiado curva dirección</translation>
    </message>
    <message>
        <source>Draw a split line</source>
        <translation>Dibujar una línea de división</translation>
    </message>
    <message>
        <source>cut divide mainland parts</source>
        <translation>cortar dividir interior partes</translation>
    </message>
    <message>
        <source>Add a gate</source>
        <translation>Añadir una entrada</translation>
    </message>
    <message>
        <source>entry road</source>
        <translation>acceso camino</translation>
    </message>
    <message>
        <source>Select and change</source>
        <translation>Seleccionar y cambiar</translation>
    </message>
    <message>
        <source>Make the outline&apos;s steps straight</source>
        <translation>Enderezar los escalones del contorno</translation>
    </message>
    <message>
        <source>pixels image stairs smooth simplify</source>
        <translation>píxeles imagen escalera suavizar simplificar</translation>
    </message>
    <message>
        <source>Rename the field…</source>
        <translation>Renombrar la parcela…</translation>
    </message>
    <message>
        <source>Remove the field</source>
        <translation>Quitar la parcela</translation>
    </message>
    <message>
        <source>delete</source>
        <translation>eliminar</translation>
    </message>
    <message>
        <source>Next field</source>
        <translation>Parcela siguiente</translation>
    </message>
    <message>
        <source>All fields of the farm</source>
        <translation>Todas las parcelas de la explotación</translation>
    </message>
    <message>
        <source>list overview plan all batch totals</source>
        <translation>lista resumen planificar todas totales</translation>
    </message>
</context>
<context>
    <name>FieldFromTrackPanel</name>
    <message>
        <source>Field from a track</source>
        <translation>Parcela de un recorrido</translation>
    </message>
    <message>
        <source>How it was driven</source>
        <translation>Cómo se condujo</translation>
    </message>
    <message>
        <source>Operating width</source>
        <translation>Ancho de trabajo</translation>
    </message>
    <message>
        <source>The edge lies outside of the line by</source>
        <translation>El borde está fuera de la línea</translation>
    </message>
    <message>
        <source>Half a width: the implement ran along the edge</source>
        <translation>Medio ancho: el apero iba por el borde</translation>
    </message>
    <message>
        <source>None: the line is the edge</source>
        <translation>Nada: la línea es el borde</translation>
    </message>
    <message>
        <source>Gaps between strips are closed up to</source>
        <translation>Los huecos entre franjas se cierran hasta</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Make the field</source>
        <translation>Crear la parcela</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
</context>
<context>
    <name>FieldsToExport</name>
    <message numerus="yes">
        <source>%1 and %n more</source>
        <translation>
            <numerusform>%1 y %n más</numerusform>
            <numerusform>%1 y %n más</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: the plan has problems and cannot be driven as drawn. The files say so too.</source>
        <translation>%1: el plan tiene problemas y no se puede recorrer como está dibujado. Los archivos también lo dicen.</translation>
    </message>
</context>
<context>
    <name>FileCommands</name>
    <message>
        <source>File</source>
        <translation>Archivo</translation>
    </message>
    <message>
        <source>New project</source>
        <translation>Proyecto nuevo</translation>
    </message>
    <message>
        <source>farm</source>
        <translation>explotación</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Abrir…</translation>
    </message>
    <message>
        <source>boundary import project</source>
        <translation>límite importar proyecto</translation>
    </message>
    <message>
        <source>Add imagery…</source>
        <translation>Añadir imágenes…</translation>
    </message>
    <message>
        <source>GeoTIFF MBTiles aerial photo satellite background heights elevation</source>
        <translation>GeoTIFF MBTiles foto aérea satélite fondo altura relieve</translation>
    </message>
    <message>
        <source>Add a folder of tiles…</source>
        <translation>Añadir una carpeta de teselas…</translation>
    </message>
    <message>
        <source>imagery XYZ TMS</source>
        <translation>imágenes XYZ TMS</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Guardar</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Guardar como…</translation>
    </message>
    <message>
        <source>Export the plan…</source>
        <translation>Exportar el plan…</translation>
    </message>
    <message>
        <source>ISOXML USB terminal</source>
        <translation>ISOXML USB terminal</translation>
    </message>
    <message>
        <source>Print the work order…</source>
        <translation>Imprimir la orden de trabajo…</translation>
    </message>
    <message>
        <source>print pdf report work order picture printer</source>
        <translation>imprimir PDF informe orden de trabajo imagen impresora</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Salir</translation>
    </message>
</context>
<context>
    <name>FileList</name>
    <message>
        <source>%1, falling</source>
        <translation>%1, descendente</translation>
    </message>
    <message>
        <source>%1, rising</source>
        <translation>%1, ascendente</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Changed</source>
        <translation>Modificado</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Tamaño</translation>
    </message>
    <message>
        <source>Files of %1</source>
        <translation>Archivos de %1</translation>
    </message>
    <message>
        <source>Folder %1</source>
        <translation>Carpeta %1</translation>
    </message>
    <message>
        <source>%1, %2, %3</source>
        <translation>%1, %2, %3</translation>
    </message>
    <message>
        <source>Reading the folder …</source>
        <translation>Leyendo la carpeta …</translation>
    </message>
    <message>
        <source>Nothing to choose here.</source>
        <translation>Aquí no hay nada que elegir.</translation>
    </message>
</context>
<context>
    <name>FileWindow</name>
    <message>
        <source>The folder around it (Backspace)</source>
        <translation>La carpeta superior (Retroceso)</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Carpeta</translation>
    </message>
    <message>
        <source>New folder…</source>
        <translation>Nueva carpeta…</translation>
    </message>
    <message>
        <source>“%1” is already there. Write over it?</source>
        <translation>«%1» ya existe. ¿Sobrescribirlo?</translation>
    </message>
    <message>
        <source>There is no folder “%1”. Make it?</source>
        <translation>No hay ninguna carpeta «%1». ¿Crearla?</translation>
    </message>
    <message>
        <source>Name of the new folder</source>
        <translation>Nombre de la nueva carpeta</translation>
    </message>
    <message>
        <source>No</source>
        <translation>No</translation>
    </message>
    <message>
        <source>Write over it</source>
        <translation>Sobrescribir</translation>
    </message>
    <message>
        <source>Make the folder</source>
        <translation>Crear la carpeta</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Which files are shown</source>
        <translation>Qué archivos se muestran</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Guardar</translation>
    </message>
    <message>
        <source>Choose this folder</source>
        <translation>Elegir esta carpeta</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Abrir</translation>
    </message>
    <message>
        <source>The folder “%1” cannot be made.</source>
        <translation>La carpeta «%1» no se puede crear.</translation>
    </message>
    <message>
        <source>There is nothing called “%1”.</source>
        <translation>No hay nada llamado «%1».</translation>
    </message>
    <message>
        <source>Choose files only, or one folder to look into.</source>
        <translation>Elija solo archivos, o una carpeta para entrar en ella.</translation>
    </message>
    <message>
        <source>Choose a file first.</source>
        <translation>Elija primero un archivo.</translation>
    </message>
    <message>
        <source>Nothing can be written in “%1”. Choose another folder.</source>
        <translation>No se puede escribir en «%1». Elija otra carpeta.</translation>
    </message>
    <message>
        <source>Give the file a name.</source>
        <translation>Dé un nombre al archivo.</translation>
    </message>
</context>
<context>
    <name>FilesNotice</name>
    <message>
        <source>Keep</source>
        <translation>Conservar</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>Aceptar</translation>
    </message>
    <message>
        <source>Throw away</source>
        <translation>Descartar</translation>
    </message>
    <message>
        <source>Save over it</source>
        <translation>Sobrescribir</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Guardar como…</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Más tarde</translation>
    </message>
</context>
<context>
    <name>Finder</name>
    <message>
        <source>Coordinates, such as 48.1371, 11.5754</source>
        <translation>Coordenadas, como 48,1371; 11,5754</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>Guía</translation>
    </message>
    <message>
        <source>Sample field</source>
        <translation>Parcela de ejemplo</translation>
    </message>
    <message>
        <source>example try</source>
        <translation>ejemplo probar</translation>
    </message>
    <message>
        <source>Fields</source>
        <translation>Parcelas</translation>
    </message>
    <message>
        <source>field</source>
        <translation>parcela</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Avisos</translation>
    </message>
    <message>
        <source>finding</source>
        <translation>aviso</translation>
    </message>
    <message>
        <source>Go to %1</source>
        <translation>Ir a %1</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Mapa</translation>
    </message>
</context>
<context>
    <name>FindingRow</name>
    <message>
        <source>Finding %1: %2 %3</source>
        <translation>Aviso %1: %2 %3</translation>
    </message>
    <message>
        <source>Apply: %1</source>
        <translation>Aplicar: %1</translation>
    </message>
    <message>
        <source>For information</source>
        <translation>Para su información</translation>
    </message>
    <message>
        <source>%1 of %2 of this kind</source>
        <translation>%1 de %2 de este tipo</translation>
    </message>
    <message>
        <source>The one before, of this kind (Ctrl+Shift+F8)</source>
        <translation>El anterior de este tipo (Ctrl+Mayús+F8)</translation>
    </message>
    <message>
        <source>The next of this kind (Ctrl+F8)</source>
        <translation>El siguiente de este tipo (Ctrl+F8)</translation>
    </message>
</context>
<context>
    <name>GuidePanel</name>
    <message>
        <source>All chapters</source>
        <translation>Todos los capítulos</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>Guía</translation>
    </message>
    <message>
        <source>Close the guide (Esc)</source>
        <translation>Cerrar la guía (Esc)</translation>
    </message>
    <message>
        <source>Search the guide</source>
        <translation>Buscar en la guía</translation>
    </message>
    <message>
        <source>Nothing is found. Try another word.</source>
        <translation>No se encuentra nada. Pruebe con otra palabra.</translation>
    </message>
</context>
<context>
    <name>HeadingChart</name>
    <message>
        <source>Time by</source>
        <translation>Tiempo según</translation>
    </message>
    <message>
        <source>direction</source>
        <translation>dirección</translation>
    </message>
    <message>
        <source>overlap</source>
        <translation>solape</translation>
    </message>
    <message>
        <source>missed</source>
        <translation>sin trabajar</translation>
    </message>
    <message>
        <source>turning</source>
        <translation>giros</translation>
    </message>
    <message>
        <source>Time by %1</source>
        <translation>Tiempo según %1</translation>
    </message>
    <message>
        <source>Directions of swaths and their times</source>
        <translation>Direcciones de las pasadas y sus tiempos</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>%1 at least</source>
        <translation>como mínimo %1</translation>
    </message>
    <message>
        <source>Estimates for the land inside the headland, to and fro. The plan adds headland, short passes and ways.</source>
        <translation>Estimaciones para el terreno dentro de la cabecera, ida y vuelta. El plan añade cabecera, pasadas cortas y trayectos.</translation>
    </message>
    <message>
        <source>Let Furrow search the direction</source>
        <translation>Dejar que Furrow busque la dirección</translation>
    </message>
</context>
<context>
    <name>HelpCommands</name>
    <message>
        <source>Help</source>
        <translation>Ayuda</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>Guía</translation>
    </message>
    <message>
        <source>help manual how to documentation</source>
        <translation>ayuda manual documentación cómo</translation>
    </message>
    <message>
        <source>Take the tour</source>
        <translation>Hacer la visita guiada</translation>
    </message>
    <message>
        <source>help introduction first start</source>
        <translation>ayuda introducción primer inicio</translation>
    </message>
    <message>
        <source>Keys and mouse</source>
        <translation>Teclas y ratón</translation>
    </message>
    <message>
        <source>shortcuts help</source>
        <translation>atajos ayuda</translation>
    </message>
    <message>
        <source>Report a problem…</source>
        <translation>Informar de un problema…</translation>
    </message>
    <message>
        <source>bug crash support error</source>
        <translation>error fallo soporte</translation>
    </message>
    <message>
        <source>About Furrow</source>
        <translation>Acerca de Furrow</translation>
    </message>
    <message>
        <source>version licence credits</source>
        <translation>versión licencia créditos</translation>
    </message>
</context>
<context>
    <name>ImageryDialogs</name>
    <message>
        <source>All files (*)</source>
        <translation>Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Add imagery</source>
        <translation>Añadir imágenes</translation>
    </message>
    <message>
        <source>Pictures and heights (%1)</source>
        <translation>Imágenes y alturas (%1)</translation>
    </message>
    <message>
        <source>Add a folder of tiles</source>
        <translation>Añadir una carpeta de teselas</translation>
    </message>
</context>
<context>
    <name>ImageryList</name>
    <message>
        <source>Your own pictures and heights: GeoTIFF, MBTiles or a folder of tiles. They stay on this computer.</source>
        <translation>Sus propias imágenes y alturas: GeoTIFF, MBTiles o una carpeta de teselas. Se quedan en este ordenador.</translation>
    </message>
    <message>
        <source>Add files…</source>
        <translation>Añadir archivos…</translation>
    </message>
    <message>
        <source>Add a folder of tiles…</source>
        <translation>Añadir una carpeta de teselas…</translation>
    </message>
</context>
<context>
    <name>ImageryNotice</name>
    <message>
        <source>OK</source>
        <translation>Aceptar</translation>
    </message>
</context>
<context>
    <name>ImageryRow</name>
    <message>
        <source>Show all of %1</source>
        <translation>Mostrar %1 por completo</translation>
    </message>
    <message>
        <source>Move %1 up</source>
        <translation>Subir %1</translation>
    </message>
    <message>
        <source>Move %1 down</source>
        <translation>Bajar %1</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>Quitar %1</translation>
    </message>
    <message>
        <source>How strong %1 is</source>
        <translation>Opacidad de %1</translation>
    </message>
    <message>
        <source>Opening …</source>
        <translation>Abriendo…</translation>
    </message>
    <message>
        <source>Contour lines every %1</source>
        <translation>Curvas de nivel cada %1</translation>
    </message>
    <message>
        <source>Rows count from the south (TMS)</source>
        <translation>Filas contadas desde el sur (TMS)</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Intentar de nuevo</translation>
    </message>
</context>
<context>
    <name>Inspector</name>
    <message>
        <source>Headland</source>
        <translation>Cabecera</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>boundary</source>
        <translation>límite de parcela</translation>
    </message>
    <message>
        <source>hole</source>
        <translation>hueco</translation>
    </message>
    <message>
        <source>obstacle</source>
        <translation>obstáculo</translation>
    </message>
    <message>
        <source>guidance line</source>
        <translation>línea de guiado</translation>
    </message>
    <message>
        <source>Point %1 of the %2</source>
        <translation>Punto %1 (%2)</translation>
    </message>
    <message>
        <source>Drag it on the map, move it by arrow keys, or type where it is.</source>
        <translation>Arrástrelo en el mapa, muévalo con las flechas o escriba dónde está.</translation>
    </message>
    <message>
        <source>Latitude</source>
        <translation>Latitud</translation>
    </message>
    <message>
        <source>Longitude</source>
        <translation>Longitud</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Ángulo</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>AB line</source>
        <translation>Línea AB</translation>
    </message>
    <message>
        <source>Edge %1 of the %2</source>
        <translation>Lado %1 (%2)</translation>
    </message>
    <message>
        <source>One swath lies on it, the others beside it. Drag it or its ends, or type its direction.</source>
        <translation>Una pasada va sobre ella, las demás al lado. Arrástrela o arrastre sus extremos, o escriba su dirección.</translation>
    </message>
    <message>
        <source>Drag it to move it sideways; the dot in its middle makes another point.</source>
        <translation>Al arrastrarlo se mueve de lado; el punto del medio crea otro vértice.</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longitud</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Dirección</translation>
    </message>
    <message>
        <source>Obstacle</source>
        <translation>Obstáculo</translation>
    </message>
    <message>
        <source>It is not worked, but may be driven on.</source>
        <translation>No se trabaja, pero se puede pasar sobre él.</translation>
    </message>
    <message>
        <source>It is not worked, and nothing drives nearer than its buffer.</source>
        <translation>No se trabaja, y nada se acerca a menos de esa distancia.</translation>
    </message>
    <message>
        <source>Buffer</source>
        <translation>Distancia</translation>
    </message>
    <message>
        <source>Overhang</source>
        <translation>Voladizo</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Superficie</translation>
    </message>
    <message>
        <source>the end</source>
        <translation>final</translation>
    </message>
    <message>
        <source>swath %1</source>
        <translation>pasada %1</translation>
    </message>
    <message>
        <source>pass %1</source>
        <translation>pasada de cabecera %1</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tiempo</translation>
    </message>
    <message>
        <source>Swath %1</source>
        <translation>Pasada %1</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Ancho</translation>
    </message>
    <message>
        <source>Headland pass %1</source>
        <translation>Pasada de cabecera %1</translation>
    </message>
    <message>
        <source>Counted from the outside; %1 are worked here in %2.</source>
        <translation>Contada desde fuera; aquí se trabajan %1 en %2.</translation>
    </message>
    <message>
        <source>Turn from %1 to %2</source>
        <translation>Giro: %1 → %2</translation>
    </message>
    <message>
        <source>%1 in reverse, in %2.</source>
        <translation>%1 marcha atrás, en %2.</translation>
    </message>
    <message>
        <source>%1 with the implement up, in %2.</source>
        <translation>%1 con el apero levantado, en %2.</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Way from %1 to %2</source>
        <translation>Trayecto: %1 → %2</translation>
    </message>
    <message>
        <source>%1 without working, in %2.</source>
        <translation>%1 sin trabajar, en %2.</translation>
    </message>
    <message>
        <source>It cannot be driven like this: %1.</source>
        <translation>Así no se puede recorrer: %1.</translation>
    </message>
    <message>
        <source>Block %1</source>
        <translation>Subparcela %1</translation>
    </message>
    <message numerus="yes">
        <source>A piece of the field whose %n swath(s) are driven together.</source>
        <translation>
            <numerusform>Un trozo del interior de la parcela con %n pasada.</numerusform>
            <numerusform>Un trozo del interior de la parcela cuyas %n pasadas se hacen juntas.</numerusform>
        </translation>
    </message>
    <message>
        <source>Swaths</source>
        <translation>Pasadas</translation>
    </message>
    <message>
        <source>Gate</source>
        <translation>Entrada</translation>
    </message>
    <message>
        <source>Here the machine may enter and leave the field. Drag it along the boundary.</source>
        <translation>Por aquí la máquina puede entrar y salir. Arrástrela a lo largo del límite.</translation>
    </message>
    <message>
        <source>Guidance curve</source>
        <translation>Curva de guiado</translation>
    </message>
    <message>
        <source>The swaths lie beside it. Drag its points, or delete it.</source>
        <translation>Las pasadas van a su lado. Arrastre sus puntos o elimínela.</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Puntos</translation>
    </message>
    <message>
        <source>Hole</source>
        <translation>Hueco</translation>
    </message>
    <message>
        <source>It is no part of the field. Drag it, or its points and edges.</source>
        <translation>No forma parte de la parcela. Arrástrelo, o sus puntos y lados.</translation>
    </message>
    <message>
        <source>split line</source>
        <translation>línea de división</translation>
    </message>
    <message>
        <source>The field inside the headland is cut along it, where it runs right through. Drag it or its points, or delete it.</source>
        <translation>El interior se divide por ella donde lo atraviesa por completo. Arrastre la línea o sus puntos, o elimínela.</translation>
    </message>
    <message>
        <source>Split line %1</source>
        <translation>Línea de división %1</translation>
    </message>
    <message>
        <source>%1 with the implement folded, in %2.</source>
        <translation>%1 con el apero plegado, en %2.</translation>
    </message>
    <message>
        <source>Whole turn</source>
        <translation>Giro completo</translation>
    </message>
    <message>
        <source>Driven as number %1 of %2: %3 in %4.</source>
        <translation>Se hace en el puesto %1 de %2: %3 en %4.</translation>
    </message>
    <message>
        <source>From the edge</source>
        <translation>Distancia al borde</translation>
    </message>
    <message>
        <source>Instead: %1</source>
        <translation>En su lugar: %1</translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>unos %1</translation>
    </message>
    <message>
        <source>no room</source>
        <translation>no cabe</translation>
    </message>
    <message>
        <source>In the bunker</source>
        <translation>En la tolva</translation>
    </message>
    <message>
        <source>In the tank</source>
        <translation>En el depósito</translation>
    </message>
    <message>
        <source>Then stands</source>
        <translation>Después se para</translation>
    </message>
</context>
<context>
    <name>InspectorPanel</name>
    <message>
        <source>Headland as elsewhere</source>
        <translation>Cabecera como en el resto</translation>
    </message>
    <message>
        <source>selected</source>
        <translation>seleccionado</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>May be driven on</source>
        <translation>Se puede pasar sobre él</translation>
    </message>
    <message>
        <source>Swaths along it</source>
        <translation>Pasadas paralelas</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Eliminar</translation>
    </message>
    <message>
        <source>Drive from here</source>
        <translation>Recorrer desde aquí</translation>
    </message>
</context>
<context>
    <name>KeysDialog</name>
    <message>
        <source>Drag the map, wheel</source>
        <translation>Arrastrar el mapa, rueda</translation>
    </message>
    <message>
        <source>move, zoom</source>
        <translation>mover, ampliar</translation>
    </message>
    <message>
        <source>Arrows, + and −</source>
        <translation>Flechas, + y −</translation>
    </message>
    <message>
        <source>move the selection or the map, zoom</source>
        <translation>mover la selección o el mapa, ampliar</translation>
    </message>
    <message>
        <source>, and .</source>
        <translation>, y .</translation>
    </message>
    <message>
        <source>the point before, the next point</source>
        <translation>punto anterior, siguiente</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Intro</translation>
    </message>
    <message>
        <source>finish drawing; type into the inspector</source>
        <translation>terminar el dibujo; escribir a la derecha</translation>
    </message>
    <message>
        <source>Alt</source>
        <translation>Alt</translation>
    </message>
    <message>
        <source>no snapping while it is held</source>
        <translation>sin ajuste mientras se mantiene</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>stop what was begun</source>
        <translation>dejar lo que se empezó</translation>
    </message>
    <message>
        <source>Keys and mouse</source>
        <translation>Teclas y ratón</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
</context>
<context>
    <name>LayerSwitches</name>
    <message>
        <source>Boundary</source>
        <translation>Límite de parcela</translation>
    </message>
    <message>
        <source>Headland</source>
        <translation>Cabecera</translation>
    </message>
    <message>
        <source>Swaths</source>
        <translation>Pasadas</translation>
    </message>
    <message>
        <source>Order numbers</source>
        <translation>Números de orden</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Avisos</translation>
    </message>
    <message>
        <source>Imagery</source>
        <translation>Imágenes</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Recorrido</translation>
    </message>
    <message>
        <source>Directions</source>
        <translation>Sentido de marcha</translation>
    </message>
    <message>
        <source>Coverage</source>
        <translation>Trabajado</translation>
    </message>
    <message>
        <source>Worked twice</source>
        <translation>Trabajado dos veces</translation>
    </message>
    <message>
        <source>Missed</source>
        <translation>Sin trabajar</translation>
    </message>
    <message>
        <source>Wheel passes</source>
        <translation>Pasos de rueda</translation>
    </message>
    <message>
        <source>Swath numbers</source>
        <translation>Números de las pasadas</translation>
    </message>
</context>
<context>
    <name>LayersPanel</name>
    <message>
        <source>Layers</source>
        <translation>Capas</translation>
    </message>
    <message>
        <source>Close the layers</source>
        <translation>Cerrar las capas</translation>
    </message>
    <message>
        <source>Imagery</source>
        <translation>Imágenes</translation>
    </message>
    <message>
        <source>From the network</source>
        <translation>De la red</translation>
    </message>
    <message>
        <source>OpenStreetMap</source>
        <translation>OpenStreetMap</translation>
    </message>
    <message>
        <source>Asks openstreetmap.org for what is in view. Off, nothing leaves this computer.</source>
        <translation>Pide a openstreetmap.org lo que está a la vista. Si está desactivado, nada sale de este ordenador.</translation>
    </message>
</context>
<context>
    <name>MachineFields</name>
    <message>
        <source>Machine</source>
        <translation>Máquina</translation>
    </message>
    <message>
        <source>Back to the original</source>
        <translation>Valores originales</translation>
    </message>
    <message>
        <source>Keep as your own…</source>
        <translation>Guardar como propia…</translation>
    </message>
    <message>
        <source>Remove from your own</source>
        <translation>Quitar de las propias</translation>
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
        <translation>Renombrar la parcela</translation>
    </message>
    <message>
        <source>Add a plan</source>
        <translation>Añadir un plan</translation>
    </message>
    <message>
        <source>Rename the plan</source>
        <translation>Renombrar el plan</translation>
    </message>
    <message>
        <source>Add a plan to each field</source>
        <translation>Añadir un plan a cada parcela</translation>
    </message>
    <message>
        <source>Keep as a variant</source>
        <translation>Guardar como variante</translation>
    </message>
    <message>
        <source>Keep the machine as</source>
        <translation>Guardar la máquina como</translation>
    </message>
    <message>
        <source>This plan: %1</source>
        <translation>Este plan: %1</translation>
    </message>
</context>
<context>
    <name>MapPage</name>
    <message>
        <source>Map</source>
        <translation>Mapa</translation>
    </message>
</context>
<context>
    <name>MapToolBar</name>
    <message>
        <source>Select and change (V)</source>
        <translation>Seleccionar y cambiar (V)</translation>
    </message>
    <message>
        <source>Draw a field (B)</source>
        <translation>Dibujar una parcela (B)</translation>
    </message>
    <message>
        <source>Draw a hole (H)</source>
        <translation>Dibujar un hueco (H)</translation>
    </message>
    <message>
        <source>Draw an obstacle (O)</source>
        <translation>Dibujar un obstáculo (O)</translation>
    </message>
    <message>
        <source>Draw an AB line (L)</source>
        <translation>Dibujar una línea AB (L)</translation>
    </message>
    <message>
        <source>Add a gate (G)</source>
        <translation>Añadir una entrada (G)</translation>
    </message>
    <message>
        <source>Show the whole field (F)</source>
        <translation>Mostrar toda la parcela (F)</translation>
    </message>
    <message>
        <source>Closer (+)</source>
        <translation>Acercar (+)</translation>
    </message>
    <message>
        <source>Further away (−)</source>
        <translation>Alejar (−)</translation>
    </message>
    <message>
        <source>Layers (Ctrl+L)</source>
        <translation>Capas (Ctrl+L)</translation>
    </message>
    <message>
        <source>Draw a split line (S)</source>
        <translation>Dibujar una línea de división (S)</translation>
    </message>
</context>
<context>
    <name>NameDialog</name>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Season</source>
        <translation>Campaña</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>Aceptar</translation>
    </message>
</context>
<context>
    <name>OnlineMap</name>
    <message>
        <source>© OpenStreetMap contributors</source>
        <translation>© Colaboradores de OpenStreetMap</translation>
    </message>
</context>
<context>
    <name>OrderEditor</name>
    <message>
        <source>Change the order by hand…</source>
        <translation>Cambiar el orden a mano…</translation>
    </message>
    <message>
        <source>Drag a swath to its new place. Or click swaths on the map: each is driven after the one clicked before.</source>
        <translation>Arrastre una pasada a su nuevo lugar. O haga clic en pasadas del mapa: cada una sigue a la anterior.</translation>
    </message>
    <message>
        <source>Order of swaths</source>
        <translation>Orden de las pasadas</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Listo</translation>
    </message>
    <message>
        <source>Search the order of the others</source>
        <translation>Buscar el orden de las demás</translation>
    </message>
    <message>
        <source>Search the order again</source>
        <translation>Buscar de nuevo el orden</translation>
    </message>
</context>
<context>
    <name>OrderForm</name>
    <message>
        <source>Status</source>
        <translation>Estado</translation>
    </message>
</context>
<context>
    <name>OrderRow</name>
    <message>
        <source>%1. Swath %2, %3</source>
        <translation>%1. Pasada %2, %3</translation>
    </message>
    <message>
        <source>Swath %1</source>
        <translation>Pasada %1</translation>
    </message>
    <message>
        <source>Drive swath %1 the other way</source>
        <translation>Recorrer la pasada %1 al revés</translation>
    </message>
</context>
<context>
    <name>OtherMap</name>
    <message>
        <source>Map of the other plan: %1</source>
        <translation>Mapa del otro plan: %1</translation>
    </message>
    <message>
        <source>The other plan is being made …</source>
        <translation>Se está calculando el otro plan…</translation>
    </message>
    <message>
        <source>The other: %1</source>
        <translation>El otro: %1</translation>
    </message>
</context>
<context>
    <name>PageList</name>
    <message>
        <source>Pages</source>
        <translation>Páginas</translation>
    </message>
    <message>
        <source>Page %1 of %2</source>
        <translation>Página %1 de %2</translation>
    </message>
    <message>
        <source>Planning for the pages …</source>
        <translation>Planificando para las páginas …</translation>
    </message>
    <message>
        <source>Stopped before there were pages.</source>
        <translation>Detenido antes de que hubiera páginas.</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Intentar de nuevo</translation>
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
        <translation>%1: que elija Furrow</translation>
    </message>
    <message>
        <source>as text</source>
        <translation>como texto</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Elegir…</translation>
    </message>
    <message>
        <source>On the map</source>
        <translation>En el mapa</translation>
    </message>
    <message>
        <source>As text</source>
        <translation>Como texto</translation>
    </message>
    <message>
        <source>%1 as text</source>
        <translation>%1 como texto</translation>
    </message>
    <message>
        <source>not chosen</source>
        <translation>no elegido</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>%1: remove</source>
        <translation>%1: quitar</translation>
    </message>
</context>
<context>
    <name>Pickers</name>
    <message>
        <source>Click the place on the map. Esc ends it.</source>
        <translation>Haga clic en el lugar del mapa. Esc para terminar.</translation>
    </message>
    <message>
        <source>Click the places on the map</source>
        <translation>Haga clic en los lugares del mapa</translation>
    </message>
    <message>
        <source>Click another place, or one of them to remove it</source>
        <translation>Haga clic en otro lugar, o en uno de ellos para quitarlo</translation>
    </message>
</context>
<context>
    <name>PlacesPicker</name>
    <message>
        <source>Place %1: remove it</source>
        <translation>Lugar %1: quitarlo</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Terminada</translation>
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
        <translation>Recorrido</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>Revisión</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Avisos</translation>
    </message>
    <message>
        <source>Add a plan…</source>
        <translation>Añadir un plan…</translation>
    </message>
    <message>
        <source>season operation copy</source>
        <translation>campaña operación copia</translation>
    </message>
    <message>
        <source>Compare with another plan</source>
        <translation>Comparar con otro plan</translation>
    </message>
    <message>
        <source>compare variants differences side by side better</source>
        <translation>comparar variantes diferencias lado a lado mejor</translation>
    </message>
    <message>
        <source>Compare on two maps</source>
        <translation>Comparar en dos mapas</translation>
    </message>
    <message>
        <source>compare side by side split map</source>
        <translation>comparar lado a lado mapa dividido dos</translation>
    </message>
    <message>
        <source>Compare with a recorded track…</source>
        <translation>Comparar con un recorrido grabado…</translation>
    </message>
    <message>
        <source>driven recorded GPX NMEA log cross-track error compare</source>
        <translation>recorrido grabado GPX NMEA desviación comparar</translation>
    </message>
    <message>
        <source>Rename the plan…</source>
        <translation>Renombrar el plan…</translation>
    </message>
    <message>
        <source>Remove the plan</source>
        <translation>Quitar el plan</translation>
    </message>
    <message>
        <source>delete</source>
        <translation>eliminar</translation>
    </message>
    <message>
        <source>Plan again</source>
        <translation>Planificar de nuevo</translation>
    </message>
    <message>
        <source>Find the best plan…</source>
        <translation>Buscar el mejor plan…</translation>
    </message>
    <message>
        <source>quickest optimise compare alternatives</source>
        <translation>más rápido optimizar comparar alternativas</translation>
    </message>
    <message>
        <source>Change the order by hand…</source>
        <translation>Cambiar el orden a mano…</translation>
    </message>
    <message>
        <source>order swaths list drag sequence</source>
        <translation>orden pasadas lista arrastrar secuencia</translation>
    </message>
    <message>
        <source>Drive through the plan</source>
        <translation>Recorrer el plan</translation>
    </message>
    <message>
        <source>Pause the drive</source>
        <translation>Pausar el recorrido</translation>
    </message>
    <message>
        <source>drive play pause simulate machine</source>
        <translation>recorrer reproducir pausa simular máquina</translation>
    </message>
    <message>
        <source>Drive from what is selected</source>
        <translation>Recorrer desde lo seleccionado</translation>
    </message>
    <message>
        <source>drive play here swath turn</source>
        <translation>recorrer aquí pasada giro</translation>
    </message>
    <message>
        <source>Drive faster</source>
        <translation>Recorrer más rápido</translation>
    </message>
    <message>
        <source>pace speed</source>
        <translation>ritmo velocidad</translation>
    </message>
    <message>
        <source>Drive slower</source>
        <translation>Recorrer más lento</translation>
    </message>
    <message>
        <source>Comment on a place…</source>
        <translation>Comentar un lugar…</translation>
    </message>
    <message>
        <source>review note remark pin</source>
        <translation>revisión nota observación lugar</translation>
    </message>
    <message>
        <source>Comment on the whole plan…</source>
        <translation>Comentar todo el plan…</translation>
    </message>
    <message>
        <source>review note remark</source>
        <translation>revisión nota observación</translation>
    </message>
    <message>
        <source>contractor share file approve</source>
        <translation>contratista compartir archivo aprobar</translation>
    </message>
    <message>
        <source>Take in a review that came back…</source>
        <translation>Incorporar una revisión recibida…</translation>
    </message>
    <message>
        <source>merge comments contractor</source>
        <translation>unir comentarios contratista</translation>
    </message>
    <message>
        <source>Next finding</source>
        <translation>Aviso siguiente</translation>
    </message>
    <message>
        <source>problem check step through</source>
        <translation>problema comprobar recorrer</translation>
    </message>
    <message>
        <source>Previous finding</source>
        <translation>Aviso anterior</translation>
    </message>
    <message>
        <source>problem check step back</source>
        <translation>problema comprobar atrás</translation>
    </message>
    <message>
        <source>Next finding of the same kind</source>
        <translation>Siguiente aviso del mismo tipo</translation>
    </message>
    <message>
        <source>Previous finding of the same kind</source>
        <translation>Aviso anterior del mismo tipo</translation>
    </message>
</context>
<context>
    <name>PlanTitle</name>
    <message>
        <source>%1 wide</source>
        <translation>%1 de ancho</translation>
    </message>
    <message>
        <source>takes %1</source>
        <translation>dura %1</translation>
    </message>
    <message>
        <source>planned %1</source>
        <translation>planificado el %1</translation>
    </message>
</context>
<context>
    <name>Planner</name>
    <message>
        <source> and twice %1 of margin</source>
        <translation> y dos veces %1 de margen</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 y %2</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 y %2 más</translation>
    </message>
    <message>
        <source>%1 are driven in reverse; the trailed implement cannot.</source>
        <translation>Se recorren %1 marcha atrás; el apero arrastrado no puede.</translation>
    </message>
    <message>
        <source>%1 are driven in reverse; this machine cannot.</source>
        <translation>Se recorren %1 marcha atrás; esta máquina no puede.</translation>
    </message>
    <message>
        <source>%1 are not worked, %2 of the field, in %3; this is the largest.</source>
        <translation>%1 quedan sin trabajar, %2 de la parcela, en %3; esta es la zona sin trabajar más grande.</translation>
    </message>
    <message>
        <source>%1 bends with a radius of %2; this machine needs %3.</source>
        <translation>%1 tiene curvas de %2 de radio; esta máquina necesita %3.</translation>
    </message>
    <message>
        <source>%1 cannot be driven: %2.</source>
        <translation>%1 no se puede recorrer: %2.</translation>
    </message>
    <message>
        <source>%1 cannot be made: %2</source>
        <translation>no se puede crear %1: %2</translation>
    </message>
    <message>
        <source>%1 crosses an obstacle, by %2.</source>
        <translation>%1 invade un obstáculo en %2.</translation>
    </message>
    <message>
        <source>%1 crosses an obstacle.</source>
        <translation>%1 cruza un obstáculo.</translation>
    </message>
    <message>
        <source>%1 does not fit here</source>
        <translation>%1 no encaja aquí</translation>
    </message>
    <message>
        <source>%1 for transport is wider than the machine at work, %2</source>
        <translation>%1 para el transporte es más ancho que la máquina trabajando, %2</translation>
    </message>
    <message>
        <source>%1 holds no positions</source>
        <translation>%1 no contiene posiciones</translation>
    </message>
    <message>
        <source>%1 in one piece are not worked.</source>
        <translation>%1 de una pieza quedan sin trabajar.</translation>
    </message>
    <message>
        <source>%1 is %2 wide; this machine is %3 wide for transport.</source>
        <translation>%1 mide %2 de ancho; esta máquina mide %3 de ancho para el transporte.</translation>
    </message>
    <message>
        <source>%1 is not a whole number</source>
        <translation>%1 no es un número entero</translation>
    </message>
    <message>
        <source>%1 is on the stick already</source>
        <translation>%1 ya está en la memoria USB</translation>
    </message>
    <message>
        <source>%1 is out of range</source>
        <translation>%1 está fuera de rango</translation>
    </message>
    <message>
        <source>%1 is planned, but nothing of it is driven with the implement down.</source>
        <translation>%1 está prevista, pero nada se recorre con el apero bajado.</translation>
    </message>
    <message>
        <source>%1 is planned, but only %2 of it is driven with the implement down.</source>
        <translation>%1 está prevista, pero solo el %2 se recorre con el apero bajado.</translation>
    </message>
    <message>
        <source>%1 jumps by %2.</source>
        <translation>%1 salta %2.</translation>
    </message>
    <message>
        <source>%1 leads from one part of the field to another that this machine cannot drive to.</source>
        <translation>%1 lleva de una parte de la parcela a otra a la que esta máquina no puede llegar.</translation>
    </message>
    <message>
        <source>%1 leaves the field by %2.</source>
        <translation>%1 sale %2 de la parcela.</translation>
    </message>
    <message>
        <source>%1 leaves the field or crosses an obstacle, by up to %2, as this plan allows.</source>
        <translation>%1 sale de la parcela o invade un obstáculo, en %2 como mucho, como permite este plan.</translation>
    </message>
    <message>
        <source>%1 moves %2 off where the machine points.</source>
        <translation>%1 se desvía %2 del rumbo de la máquina.</translation>
    </message>
    <message>
        <source>%1 needs %2</source>
        <translation>%1 necesita: %2</translation>
    </message>
    <message>
        <source>%1 of %2 guidance lines of &apos;%3&apos; are there</source>
        <translation>están %1 de %2 líneas de guiado de «%3»</translation>
    </message>
    <message>
        <source>%1 of %2 swaths are not in the order: %3</source>
        <translation>faltan %1 de %2 pasadas en el orden: %3</translation>
    </message>
    <message>
        <source>%1 of %2 tracks are of another place and were left out</source>
        <translation>%1 de %2 recorridos son de otro lugar y se han omitido</translation>
    </message>
    <message>
        <source>%1 of its sentences have a wrong checksum</source>
        <translation>%1 de sus sentencias tienen una suma de comprobación errónea</translation>
    </message>
    <message>
        <source>%1 of margin leaves nothing of the field to work</source>
        <translation>%1 de margen no dejan nada de la parcela que trabajar</translation>
    </message>
    <message>
        <source>%1 of the positions jump away and back</source>
        <translation>%1 de las posiciones saltan a otro lugar y vuelven</translation>
    </message>
    <message>
        <source>%1 reads back other bytes than were written</source>
        <translation>%1 no coincide al releerlo con lo que se escribió</translation>
    </message>
    <message>
        <source>%1 small patches of worked pixels are left out</source>
        <translation>se omiten %1 manchas pequeñas de píxeles trabajados</translation>
    </message>
    <message>
        <source>%1 swaths and turns leave the field or cross an obstacle, by up to %2, as this plan allows.</source>
        <translation>%1 pasadas y giros salen de la parcela o invaden un obstáculo, en %2 como mucho, como permite este plan.</translation>
    </message>
    <message>
        <source>%1, %2 is more than 1,000 km from the plan</source>
        <translation>%1, %2 está a más de 1.000 km del plan</translation>
    </message>
    <message>
        <source>%1, %2 is no longitude and latitude</source>
        <translation>%1, %2 no es longitud y latitud</translation>
    </message>
    <message>
        <source>%1, %2 is no longitude and latitude, and the file does not say which coordinate system it uses</source>
        <translation>%1, %2 no es longitud y latitud, y el archivo no dice qué sistema de coordenadas usa</translation>
    </message>
    <message>
        <source>%1, %2 is outside longitude -180 to 180 and latitude -90 to 90</source>
        <translation>%1, %2 queda fuera de longitud -180 a 180 y latitud -90 a 90</translation>
    </message>
    <message>
        <source>%1, %2, line %3</source>
        <translation>%1, %2, línea %3</translation>
    </message>
    <message>
        <source>%1, %2, point %3</source>
        <translation>%1, %2, punto %3</translation>
    </message>
    <message>
        <source>%1, byte %2</source>
        <translation>%1, byte %2</translation>
    </message>
    <message>
        <source>%1, feature %2</source>
        <translation>%1, objeto %2</translation>
    </message>
    <message>
        <source>%1, gate %2</source>
        <translation>%1, entrada %2</translation>
    </message>
    <message>
        <source>%1, hole %2</source>
        <translation>%1, hueco %2</translation>
    </message>
    <message>
        <source>%1, line %2</source>
        <translation>%1, línea %2</translation>
    </message>
    <message>
        <source>%1, obstacle %2</source>
        <translation>%1, obstáculo %2</translation>
    </message>
    <message>
        <source>%1, point %2</source>
        <translation>%1, punto %2</translation>
    </message>
    <message>
        <source>%1, row %2</source>
        <translation>%1, fila %2</translation>
    </message>
    <message>
        <source>%1.bin is not there</source>
        <translation>falta %1.bin</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: the setting %2 is not used: %3</source>
        <translation>%1: el ajuste %2 no se usa: %3</translation>
    </message>
    <message>
        <source>%1; %2 × other turns</source>
        <translation>%1; %2 × otros giros</translation>
    </message>
    <message>
        <source>%1; what it belongs to was left out</source>
        <translation>%1; aquello a lo que pertenece se omitió</translation>
    </message>
    <message numerus="yes">
        <source>%n areas are neither field, hole nor obstacle by their layer or kind and were not used</source>
        <translation>
            <numerusform>%n superficie no es, por su capa o clase, ni parcela ni hueco ni obstáculo y no se usó</numerusform>
            <numerusform>%n superficies no son, por su capa o clase, ni parcela ni hueco ni obstáculo y no se usaron</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n areas in the file are neither field nor obstacle and were not used</source>
        <translation>
            <numerusform>%n superficie del archivo no es ni parcela ni obstáculo y no se usó</numerusform>
            <numerusform>%n superficies del archivo no son ni parcela ni obstáculo y no se usaron</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n damaged lines were passed over</source>
        <translation>
            <numerusform>se ha pasado por alto %n línea dañada</numerusform>
            <numerusform>se han pasado por alto %n líneas dañadas</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n entries without a shape</source>
        <translation>
            <numerusform>%n elemento sin forma</numerusform>
            <numerusform>%n elementos sin forma</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n fields</source>
        <translation>
            <numerusform>%n parcela</numerusform>
            <numerusform>%n parcelas</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n messages without a position were passed over</source>
        <translation>
            <numerusform>se ha pasado por alto %n mensaje sin posición</numerusform>
            <numerusform>se han pasado por alto %n mensajes sin posición</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n open lines</source>
        <translation>
            <numerusform>%n línea abierta</numerusform>
            <numerusform>%n líneas abiertas</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n passes</source>
        <translation>
            <numerusform>%n pasada</numerusform>
            <numerusform>%n pasadas</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pieces</source>
        <translation>
            <numerusform>%n trozo</numerusform>
            <numerusform>%n trozos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n places</source>
        <translation>
            <numerusform>%n lugar</numerusform>
            <numerusform>%n lugares</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n points</source>
        <translation>
            <numerusform>%n punto</numerusform>
            <numerusform>%n puntos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n points were given twice and taken once</source>
        <translation>
            <numerusform>%n punto estaba repetido y cuenta una vez</numerusform>
            <numerusform>%n puntos estaban repetidos y cuentan una vez</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n positions that jumped away were left out</source>
        <translation>
            <numerusform>se ha omitido %n posición que saltó a otro lugar</numerusform>
            <numerusform>se han omitido %n posiciones que saltaron a otro lugar</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n records without a position were passed over</source>
        <translation>
            <numerusform>se ha pasado por alto %n registro sin posición</numerusform>
            <numerusform>se han pasado por alto %n registros sin posición</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n reports without a position were passed over</source>
        <translation>
            <numerusform>se ha pasado por alto %n aviso sin posición</numerusform>
            <numerusform>se han pasado por alto %n avisos sin posición</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n rings did not end where they began and were closed</source>
        <translation>
            <numerusform>%n anillo no acababa donde empezó y se ha cerrado</numerusform>
            <numerusform>%n anillos no acababan donde empezaron y se han cerrado</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n rings ran the wrong way round and were turned</source>
        <translation>
            <numerusform>%n anillo iba al revés y se ha invertido</numerusform>
            <numerusform>%n anillos iban al revés y se han invertido</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n rows without a position were passed over</source>
        <translation>
            <numerusform>se ha pasado por alto %n fila sin posición</numerusform>
            <numerusform>se han pasado por alto %n filas sin posición</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sentences with a wrong checksum were passed over</source>
        <translation>
            <numerusform>se ha pasado por alto %n sentencia con suma de comprobación errónea</numerusform>
            <numerusform>se han pasado por alto %n sentencias con suma de comprobación errónea</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sentences without a position were passed over</source>
        <translation>
            <numerusform>se ha pasado por alto %n sentencia sin posición</numerusform>
            <numerusform>se han pasado por alto %n sentencias sin posición</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n spikes without area were removed</source>
        <translation>
            <numerusform>%n pico sin superficie se ha quitado</numerusform>
            <numerusform>%n picos sin superficie se han quitado</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n stretches of one strip were left out, as ways to the field: %1 together</source>
        <translation>
            <numerusform>se ha omitido %n tramo de una sola franja, como camino a la parcela: %1</numerusform>
            <numerusform>se han omitido %n tramos de una sola franja, como caminos a la parcela: %1 en total</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n turns</source>
        <translation>
            <numerusform>%n giro</numerusform>
            <numerusform>%n giros</numerusform>
        </translation>
    </message>
    <message>
        <source>&apos;%1&apos; files hold no recorded track</source>
        <translation>los archivos «%1» no contienen ningún recorrido grabado</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is left out: its kind %2 is not known</source>
        <translation>se omite «%1»: su tipo %2 no se conoce</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no length</source>
        <translation>«%1» no es una longitud</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no local frame</source>
        <translation>«%1» no es un sistema local</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not %2</source>
        <translation>«%1» no es: %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a line</source>
        <translation>«%1» no es una línea</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not well-known text</source>
        <translation>«%1» no es well-known text</translation>
    </message>
    <message>
        <source>&apos;%1&apos;, &apos;%2&apos; is no latitude and longitude</source>
        <translation>«%1», «%2» no es una latitud y una longitud</translation>
    </message>
    <message>
        <source>&apos;%1&apos;, &apos;%2&apos; is no longitude and latitude</source>
        <translation>«%1», «%2» no es longitud y latitud</translation>
    </message>
    <message>
        <source>&apos;%1&apos;, &apos;%2&apos; is no position</source>
        <translation>«%1», «%2» no es una posición</translation>
    </message>
    <message>
        <source>A and B are %1 apart</source>
        <translation>A y B están a %1 uno de otro</translation>
    </message>
    <message>
        <source>A bulb to both sides; for swaths nearer than two turning radii.</source>
        <translation>Se abre a ambos lados; para pasadas a menos de dos radios de giro.</translation>
    </message>
    <message>
        <source>A bulb to one side and straight back; for swaths nearer than two turning radii.</source>
        <translation>Se abre a un lado y vuelve recto; para pasadas a menos de dos radios de giro.</translation>
    </message>
    <message>
        <source>A block gets a heading of its own where that saves time.</source>
        <translation>Una subparcela tiene su propia dirección donde eso ahorra tiempo.</translation>
    </message>
    <message>
        <source>A file of lines: planted rows, or the tramlines of a plan.</source>
        <translation>Un archivo de líneas: hileras plantadas o las calles de pulverización de un plan.</translation>
    </message>
    <message>
        <source>A gate&apos;s name or a point; the first gate where nothing is given.</source>
        <translation>Nombre de una entrada o un punto; la primera entrada si no se indica nada.</translation>
    </message>
    <message>
        <source>A goal of opennav_coverage has one outline: %1 of %2 parts are left out.</source>
        <translation>Un objetivo de opennav_coverage tiene un contorno: se omiten %1 de %2 partes.</translation>
    </message>
    <message>
        <source>A raster of heights in metres that covers the field, such as a GeoTIFF.</source>
        <translation>Un ráster de alturas en metros que cubra la parcela, como un GeoTIFF.</translation>
    </message>
    <message>
        <source>A robot with ROS 2</source>
        <translation>Un robot con ROS 2</translation>
    </message>
    <message>
        <source>A snake within each cluster of swaths, cluster after cluster.</source>
        <translation>Una serpentina en cada grupo de pasadas, grupo tras grupo.</translation>
    </message>
    <message>
        <source>A strip of the same width along the boundary and around obstacles, for turning.</source>
        <translation>Una franja del mismo ancho a lo largo del límite y alrededor de obstáculos, para girar.</translation>
    </message>
    <message>
        <source>A+</source>
        <translation>A+</translation>
    </message>
    <message>
        <source>AB curve</source>
        <translation>Curva AB</translation>
    </message>
    <message>
        <source>AB line</source>
        <translation>Línea AB</translation>
    </message>
    <message>
        <source>Across the slope: beside a line of equal height, and a new one where that no longer fits.</source>
        <translation>A través de la pendiente: junto a una curva de nivel, y otra nueva donde ya no encaja.</translation>
    </message>
    <message>
        <source>After the swaths</source>
        <translation>Después de las pasadas</translation>
    </message>
    <message>
        <source>AgBot</source>
        <translation>AgBot</translation>
    </message>
    <message>
        <source>AgGPS folder</source>
        <translation>Carpeta AgGPS</translation>
    </message>
    <message>
        <source>AgOpenGPS 6, import of ISOXML</source>
        <translation>AgOpenGPS 6, importación de ISOXML</translation>
    </message>
    <message>
        <source>AgOpenGPS drives recorded paths forwards only, and this one reverses %1 times: its %2 forward stretches are &apos;Part 01.rec&apos; and so on, RecPath.txt is the first; %3 under 5 m are left out.</source>
        <translation>AgOpenGPS solo recorre hacia delante, y este recorrido retrocede %1 veces: sus %2 tramos hacia delante son &apos;Part 01.rec&apos;, etc., RecPath.txt es el primero; se omiten %3 de menos de 5 m.</translation>
    </message>
    <message>
        <source>AgOpenGPS field</source>
        <translation>Parcela de AgOpenGPS</translation>
    </message>
    <message>
        <source>AgOpenGPS keeps one outline to a field: the %1 parts of &apos;%2&apos; are fields of their own, and the whole path is in the first.</source>
        <translation>AgOpenGPS guarda un contorno por parcela: las %1 partes de «%2» son parcelas propias, y todo el recorrido está en la primera.</translation>
    </message>
    <message>
        <source>AgOpenGPS keeps one outline to a field: the %1 parts of &apos;%2&apos; are fields of their own.</source>
        <translation>AgOpenGPS guarda un contorno por parcela: las %1 partes de «%2» son parcelas propias.</translation>
    </message>
    <message>
        <source>All swaths along the edge of the boundary that you pick.</source>
        <translation>Todas las pasadas a lo largo del lado del límite que se elija.</translation>
    </message>
    <message>
        <source>All swaths along the longest straight edge inside the headland.</source>
        <translation>Todas las pasadas a lo largo del lado recto más largo del interior.</translation>
    </message>
    <message>
        <source>All swaths in the direction that you type.</source>
        <translation>Todas las pasadas en la dirección que se escriba.</translation>
    </message>
    <message>
        <source>Along an edge</source>
        <translation>A lo largo de un lado</translation>
    </message>
    <message>
        <source>Along each edge as wide as the turns there need it; a single pass where no swath ends, or nothing if it is not worked.</source>
        <translation>En cada lado tan ancha como piden los giros; una sola pasada donde no termina ninguna, o nada si no se trabaja.</translation>
    </message>
    <message>
        <source>Along rows that are there already, or between them.</source>
        <translation>Por hileras que ya existen o entre ellas.</translation>
    </message>
    <message>
        <source>Along the boundary</source>
        <translation>A lo largo del límite</translation>
    </message>
    <message>
        <source>Along the contours</source>
        <translation>Por las curvas de nivel</translation>
    </message>
    <message>
        <source>Along the direction of travel.</source>
        <translation>En el sentido de la marcha.</translation>
    </message>
    <message>
        <source>Along the headland</source>
        <translation>Por la cabecera</translation>
    </message>
    <message>
        <source>Along the line from A to B; one swath lies on it.</source>
        <translation>A lo largo de la línea de A a B; una pasada va sobre ella.</translation>
    </message>
    <message>
        <source>Along the longest edge</source>
        <translation>A lo largo del lado más largo</translation>
    </message>
    <message>
        <source>An older ISOBUS terminal</source>
        <translation>Un terminal ISOBUS más antiguo</translation>
    </message>
    <message>
        <source>Another ISOBUS terminal</source>
        <translation>Otro terminal ISOBUS</translation>
    </message>
    <message>
        <source>Anywhere</source>
        <translation>Por todas partes</translation>
    </message>
    <message>
        <source>Arc, straight, arc; for swaths at least two turning radii apart.</source>
        <translation>Arco, recta, arco; para pasadas separadas al menos dos radios de giro.</translation>
    </message>
    <message>
        <source>Choose the best that fits, which takes the quickest everywhere.</source>
        <translation>Elija «El mejor que cabe», que toma en todas partes el más rápido.</translation>
    </message>
    <message>
        <source>Joined where that is quicker</source>
        <translation>Unidas donde es más rápido</translation>
    </message>
    <message>
        <source>As few swaths, and so turns, as possible.</source>
        <translation>Las menos pasadas, y por tanto giros, posibles.</translation>
    </message>
    <message>
        <source>At obstacles</source>
        <translation>En los obstáculos</translation>
    </message>
    <message>
        <source>At the left edge</source>
        <translation>En el borde izquierdo</translation>
    </message>
    <message>
        <source>At the right edge</source>
        <translation>En el borde derecho</translation>
    </message>
    <message>
        <source>At the start of the first swath.</source>
        <translation>Al inicio de la primera pasada.</translation>
    </message>
    <message>
        <source>Before the swaths</source>
        <translation>Antes de las pasadas</translation>
    </message>
    <message>
        <source>Beside a curve of your own, or beside the edges around the one that you pick.</source>
        <translation>Junto a una curva propia o junto a los lados alrededor del elegido.</translation>
    </message>
    <message>
        <source>Best heading</source>
        <translation>Mejor dirección</translation>
    </message>
    <message>
        <source>Best of all headings</source>
        <translation>Mejor de todas</translation>
    </message>
    <message>
        <source>Best that fits</source>
        <translation>El mejor que cabe</translation>
    </message>
    <message>
        <source>Between the fixed and the steered axle.</source>
        <translation>Entre el eje fijo y el eje directriz.</translation>
    </message>
    <message>
        <source>Between the headings that are tried.</source>
        <translation>Entre las direcciones que se prueban.</translation>
    </message>
    <message>
        <source>Between the rows</source>
        <translation>Entre las hileras</translation>
    </message>
    <message>
        <source>Boundaries in longitude and latitude.</source>
        <translation>Límites en longitud y latitud.</translation>
    </message>
    <message>
        <source>Boundaries, also field files of Fields2Cover and GAOS.</source>
        <translation>Límites, también archivos de Fields2Cover y GAOS.</translation>
    </message>
    <message>
        <source>Boundaries.</source>
        <translation>Límites de parcela.</translation>
    </message>
    <message>
        <source>Boundary and guidance lines for Trimble and FM displays; no driving order.</source>
        <translation>Límite y líneas de guiado para pantallas Trimble y FM; sin orden de pasadas.</translation>
    </message>
    <message>
        <source>Boundary, headland, heading and order; the robot lays swaths and turns itself.</source>
        <translation>Límite, cabecera, dirección y orden; el robot traza él mismo pasadas y giros.</translation>
    </message>
    <message>
        <source>Boundary, holes, headland, guidance lines, and the whole driven path as a recorded path.</source>
        <translation>Límite, huecos, cabecera, líneas de guiado y todo el recorrido como recorrido grabado.</translation>
    </message>
    <message>
        <source>Boundary, holes, obstacles and guidance lines for older terminals; no headland, no driving order.</source>
        <translation>Límite, huecos, obstáculos y líneas de guiado para terminales antiguos; sin cabecera ni orden de pasadas.</translation>
    </message>
    <message>
        <source>Boundary, holes, obstacles, gates, headland and guidance lines for terminals; no driving order.</source>
        <translation>Límite, huecos, obstáculos, entradas, cabecera y líneas de guiado para terminales; sin orden de pasadas.</translation>
    </message>
    <message>
        <source>Boundary, holes, obstacles, headland, swaths and path in metres of the UTM zone.</source>
        <translation>Límite, huecos, obstáculos, cabecera, pasadas y recorrido en metros de la zona UTM.</translation>
    </message>
    <message>
        <source>Boundary, obstacles, gates, headland, swaths and path, to look at.</source>
        <translation>Límite, obstáculos, entradas, cabecera, pasadas y recorrido, para verlos.</translation>
    </message>
    <message>
        <source>Boundary, obstacles, gates, headland, swaths, path and findings; for maps and programs.</source>
        <translation>Límite, obstáculos, entradas, cabecera, pasadas, recorrido y avisos; para mapas y programas.</translation>
    </message>
    <message>
        <source>Boundary, obstacles, gates, inside of the headland, swaths and path as layers for a GIS.</source>
        <translation>Límite, obstáculos, entradas, interior, pasadas y recorrido como capas para un SIG.</translation>
    </message>
    <message>
        <source>Boundary, obstacles, gates, inside of the headland, swaths and path, a shapefile of each.</source>
        <translation>Límite, obstáculos, entradas, interior, pasadas y recorrido, un shapefile de cada uno.</translation>
    </message>
    <message>
        <source>Bringing the crop in: headland first, swaths overlap a little.</source>
        <translation>Recoger la cosecha: cabecera primero, las pasadas se solapan un poco.</translation>
    </message>
    <message>
        <source>CSV table</source>
        <translation>Tabla CSV</translation>
    </message>
    <message>
        <source>Can reverse</source>
        <translation>Puede ir marcha atrás</translation>
    </message>
    <message>
        <source>Can turn in place</source>
        <translation>Puede girar en el sitio</translation>
    </message>
    <message>
        <source>Carried by the tractor, or pulled on a hitch and following its own track.</source>
        <translation>Suspendido en el tractor, o arrastrado de un enganche con su propia huella.</translation>
    </message>
    <message>
        <source>Blocks</source>
        <translation>Subparcelas</translation>
    </message>
    <message>
        <source>Centre line</source>
        <translation>Línea central</translation>
    </message>
    <message>
        <source>Check that the machine stays inside the field while it turns.</source>
        <translation>Compruebe que la máquina no sale de la parcela al girar.</translation>
    </message>
    <message>
        <source>Choose another place.</source>
        <translation>Elija otro lugar.</translation>
    </message>
    <message>
        <source>Circles</source>
        <translation>Círculos</translation>
    </message>
    <message>
        <source>Clockwise</source>
        <translation>Sentido horario</translation>
    </message>
    <message>
        <source>Cluster</source>
        <translation>Grupo</translation>
    </message>
    <message>
        <source>Combine harvester, 7.5 m header</source>
        <translation>Cosechadora, cabezal de 7,5 m</translation>
    </message>
    <message>
        <source>Corners</source>
        <translation>Esquinas</translation>
    </message>
    <message>
        <source>Counter-clockwise</source>
        <translation>Sentido antihorario</translation>
    </message>
    <message>
        <source>Crop protection: headland first, ways along the headland.</source>
        <translation>Protección del cultivo: cabecera primero, trayectos por la cabecera.</translation>
    </message>
    <message>
        <source>Curves are driven with up to %1 sideways; the machine&apos;s limit is less.</source>
        <translation>Las curvas se toman con hasta %1 lateral; el límite de la máquina es menor.</translation>
    </message>
    <message>
        <source>Curves with reversing</source>
        <translation>Curvas con marcha atrás</translation>
    </message>
    <message>
        <source>Curves with reversing, smooth steering</source>
        <translation>Curvas con marcha atrás, dirección suave</translation>
    </message>
    <message>
        <source>Cut along the swaths at every corner, sharp or rounded.</source>
        <translation>Dividido a lo largo de las pasadas en cada esquina, viva o redondeada.</translation>
    </message>
    <message>
        <source>Cut along the swaths where an obstacle or a bay begins or ends.</source>
        <translation>Dividido a lo largo de las pasadas donde empieza o acaba un obstáculo o un entrante.</translation>
    </message>
    <message>
        <source>Cut where an obstacle or a bay begins or ends, and joined again where that saves turns and ways.</source>
        <translation>Dividido donde empieza o acaba un obstáculo o un entrante, y unido de nuevo donde eso ahorra giros y trayectos.</translation>
    </message>
    <message>
        <source>Cutting grass: headland first, swaths overlap a little.</source>
        <translation>Siega de hierba: cabecera primero, las pasadas se solapan un poco.</translation>
    </message>
    <message>
        <source>DXF drawing</source>
        <translation>Dibujo DXF</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Dirección</translation>
    </message>
    <message>
        <source>Drawn out until the whole width is covered, as far as there is room.</source>
        <translation>Se prolonga hasta cubrir todo el ancho, mientras haya sitio.</translation>
    </message>
    <message>
        <source>Drilling or planting: headland last, ways along the headland.</source>
        <translation>Siembra o plantación: cabecera al final, trayectos por la cabecera.</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>Circular</translation>
    </message>
    <message>
        <source>Drive the curves more slowly.</source>
        <translation>Tome las curvas más despacio.</translation>
    </message>
    <message>
        <source>Drives the path from waypoint to waypoint, rounding corners its own way; relay 1 is on where the implement works. Not tested on the machine by us.</source>
        <translation>Va de punto en punto y redondea las esquinas a su manera; el relé 1 está activado donde trabaja el apero. No probado por nosotros en la máquina.</translation>
    </message>
    <message>
        <source>Drives the whole path, turns included, as a recorded path; stretches in reverse gear are left to the driver. Shows boundary, headland and guidance lines. Copy the field&apos;s folder to Documents/AgOpenGPS/Fields.</source>
        <translation>Recorre todo, giros incluidos, como recorrido grabado; los tramos marcha atrás quedan para el conductor. Muestra límite, cabecera y líneas de guiado. Copie la carpeta de la parcela en Documents/AgOpenGPS/Fields.</translation>
    </message>
    <message>
        <source>Each its own</source>
        <translation>Cada una la suya</translation>
    </message>
    <message>
        <source>Edge</source>
        <translation>Lado</translation>
    </message>
    <message>
        <source>Edge directions and every tenth of a degree, refined; says when nothing better exists.</source>
        <translation>Direcciones de lados y cada décima de grado, afinado; dice cuándo no hay nada mejor.</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Final</translation>
    </message>
    <message>
        <source>Ends</source>
        <translation>Extremos</translation>
    </message>
    <message>
        <source>Every how many swaths a wider machine will drive again; 0 for none.</source>
        <translation>Cada cuántas pasadas volverá una máquina más ancha; 0 para ninguna.</translation>
    </message>
    <message>
        <source>Every sample of the path; without a plan boundaries as WKT, or as points.</source>
        <translation>Cada punto del recorrido; sin plan, límites como WKT o puntos.</translation>
    </message>
    <message>
        <source>Every second swath on the way out, the others on the way back.</source>
        <translation>Una pasada de cada dos a la ida, las demás a la vuelta.</translation>
    </message>
    <message>
        <source>Every swath after its neighbour, back and forth.</source>
        <translation>Cada pasada tras su vecina, ida y vuelta.</translation>
    </message>
    <message>
        <source>Fendt One, Vario terminal</source>
        <translation>Fendt One, Varioterminal</translation>
    </message>
    <message>
        <source>Fertiliser or manure: headland first, ways along the headland.</source>
        <translation>Abono o estiércol: cabecera primero, trayectos por la cabecera.</translation>
    </message>
    <message>
        <source>Fertiliser spreader, 36 m</source>
        <translation>Abonadora, 36 m</translation>
    </message>
    <message>
        <source>Fewest swaths</source>
        <translation>Menos pasadas</translation>
    </message>
    <message>
        <source>Field robot, 1.5 m weeder</source>
        <translation>Robot agrícola, escardadora de 1,5 m</translation>
    </message>
    <message>
        <source>Finish corners</source>
        <translation>Acabar las esquinas</translation>
    </message>
    <message>
        <source>First tramline</source>
        <translation>Primera calle de pulverización</translation>
    </message>
    <message>
        <source>Fishtail</source>
        <translation>Giro en cola de pez</translation>
    </message>
    <message>
        <source>Five-furrow mounted plough, 2.5 m</source>
        <translation>Arado suspendido de cinco cuerpos, 2,5 m</translation>
    </message>
    <message>
        <source>Forward arc, straight back, forward arc; little room for near swaths.</source>
        <translation>Arco adelante, recto atrás, arco adelante; poco sitio para pasadas cercanas.</translation>
    </message>
    <message>
        <source>Forward curves</source>
        <translation>Curvas hacia delante</translation>
    </message>
    <message>
        <source>Forward curves, smooth steering</source>
        <translation>Curvas hacia delante, dirección suave</translation>
    </message>
    <message>
        <source>Forward, back with the wheels the other way, forward again.</source>
        <translation>Adelante, atrás con las ruedas al otro lado, adelante de nuevo.</translation>
    </message>
    <message>
        <source>Forwards and backwards, the wheels turned no faster than the machine can (clothoids).</source>
        <translation>Adelante y atrás, sin girar las ruedas más rápido de lo que puede la máquina (clotoides).</translation>
    </message>
    <message>
        <source>From clear of the ground to working depth.</source>
        <translation>Desde que libra el suelo hasta la profundidad de trabajo.</translation>
    </message>
    <message>
        <source>From inside out</source>
        <translation>De dentro hacia fuera</translation>
    </message>
    <message>
        <source>From outside in</source>
        <translation>De fuera hacia dentro</translation>
    </message>
    <message>
        <source>From the boundary inwards; holds as many passes as fit.</source>
        <translation>Del límite al interior de la parcela; contiene tantas pasadas como quepan.</translation>
    </message>
    <message>
        <source>From the fixed axle to the hitch, negative behind the axle.</source>
        <translation>Del eje fijo al enganche, negativo detrás del eje.</translation>
    </message>
    <message>
        <source>From the fixed axle to the middle of the working parts, negative behind the axle.</source>
        <translation>Del eje fijo al centro de las partes que trabajan, negativo detrás del eje.</translation>
    </message>
    <message>
        <source>From the fixed axle to the tractor&apos;s rear end.</source>
        <translation>Del eje fijo al extremo trasero del tractor.</translation>
    </message>
    <message>
        <source>From the tractor&apos;s nose to its rear end.</source>
        <translation>Del morro del tractor a su extremo trasero.</translation>
    </message>
    <message>
        <source>From working depth to clear of the ground.</source>
        <translation>De la profundidad de trabajo hasta que libra el suelo.</translation>
    </message>
    <message>
        <source>Front and rear mower, 9 m</source>
        <translation>Segadora frontal y trasera, 9 m</translation>
    </message>
    <message>
        <source>Fuel at work</source>
        <translation>Combustible en trabajo</translation>
    </message>
    <message>
        <source>Fuel in turns</source>
        <translation>Combustible en giros</translation>
    </message>
    <message>
        <source>Full spacing; the last swath is moved back to the edge.</source>
        <translation>Separación completa; la última pasada se lleva al borde.</translation>
    </message>
    <message>
        <source>Full spacing; a rest of less than half a width stays uncovered, where it costs least.</source>
        <translation>Separación completa; un resto de menos de medio ancho queda sin cubrir donde menos cuesta.</translation>
    </message>
    <message>
        <source>Full width</source>
        <translation>Ancho completo</translation>
    </message>
    <message>
        <source>Gets the whole path as nav_msgs/Path, and stretches in one gear each where it reverses.</source>
        <translation>Recibe todo el recorrido como nav_msgs/Path, y tramos de una sola marcha donde retrocede.</translation>
    </message>
    <message>
        <source>Given direction</source>
        <translation>Dirección dada</translation>
    </message>
    <message>
        <source>Go round obstacles up to</source>
        <translation>Rodear obstáculos de hasta</translation>
    </message>
    <message>
        <source>Great Field</source>
        <translation>Campo Grande</translation>
    </message>
    <message>
        <source>Half way in</source>
        <translation>A medio ancho</translation>
    </message>
    <message>
        <source>Make them straight: &quot;Field&quot; menu, or furrow-cli convert --straighten-steps.</source>
        <translation>Enderécelos: menú «Parcela», o furrow-cli convert --straighten-steps.</translation>
    </message>
    <message>
        <source>Quick search</source>
        <translation>Búsqueda rápida</translation>
    </message>
    <message>
        <source>Harvest</source>
        <translation>Cosecha</translation>
    </message>
    <message>
        <source>Heading</source>
        <translation>Dirección de pasadas</translation>
    </message>
    <message>
        <source>Headland</source>
        <translation>Cabecera</translation>
    </message>
    <message>
        <source>Headland first or last.</source>
        <translation>Cabecera primero o al final.</translation>
    </message>
    <message>
        <source>Heights</source>
        <translation>Alturas</translation>
    </message>
    <message>
        <source>Hitch offset</source>
        <translation>Posición del enganche</translation>
    </message>
    <message>
        <source>Home Field</source>
        <translation>Campo de Casa</translation>
    </message>
    <message>
        <source>How far a trailed implement may swing to one side.</source>
        <translation>Cuánto puede girar hacia un lado un apero arrastrado.</translation>
    </message>
    <message>
        <source>How far the steered wheels turn to one side.</source>
        <translation>Cuánto giran las ruedas directrices hacia un lado.</translation>
    </message>
    <message>
        <source>How fast the curvature may change along the path; from the steering rate where it is not given.</source>
        <translation>Con qué rapidez puede cambiar la curvatura a lo largo del recorrido; si no se indica, se calcula con la velocidad de dirección.</translation>
    </message>
    <message>
        <source>How fast the steered wheels turn.</source>
        <translation>Con qué rapidez giran las ruedas directrices.</translation>
    </message>
    <message>
        <source>How headland passes get round corners.</source>
        <translation>Cómo pasan las esquinas las pasadas de cabecera.</translation>
    </message>
    <message>
        <source>How much neighbouring swaths overlap.</source>
        <translation>Cuánto se solapan las pasadas vecinas.</translation>
    </message>
    <message>
        <source>How the direction of the swaths is found.</source>
        <translation>Cómo se halla la dirección de pasadas.</translation>
    </message>
    <message>
        <source>How the machine gets from one swath to the next.</source>
        <translation>Cómo va la máquina de una pasada a la siguiente.</translation>
    </message>
    <message>
        <source>How the field is divided; the swaths of a block are driven together.</source>
        <translation>Cómo se divide el interior; las pasadas de una subparcela se hacen juntas.</translation>
    </message>
    <message>
        <source>Implement can reverse</source>
        <translation>El apero admite marcha atrás</translation>
    </message>
    <message>
        <source>Implement length</source>
        <translation>Longitud del apero</translation>
    </message>
    <message>
        <source>Implement offset</source>
        <translation>Posición del apero</translation>
    </message>
    <message>
        <source>In WGS84: A and B of a line, a curve, A alone with a direction, or a pivot&apos;s centre.</source>
        <translation>En WGS84: A y B de una línea, una curva, A solo con una dirección, o el centro de un pívot.</translation>
    </message>
    <message>
        <source>In which order the headland passes are driven.</source>
        <translation>En qué orden se hacen las pasadas de cabecera.</translation>
    </message>
    <message>
        <source>In which order the swaths are driven.</source>
        <translation>En qué orden se hacen las pasadas.</translation>
    </message>
    <message>
        <source>Largest acceleration</source>
        <translation>Aceleración máxima</translation>
    </message>
    <message>
        <source>Largest curvature rate</source>
        <translation>Variación de curvatura máxima</translation>
    </message>
    <message>
        <source>Largest hitch angle</source>
        <translation>Ángulo de enganche máximo</translation>
    </message>
    <message>
        <source>Largest lateral acceleration</source>
        <translation>Aceleración lateral máxima</translation>
    </message>
    <message>
        <source>Largest speed in turns.</source>
        <translation>Velocidad máxima en los giros.</translation>
    </message>
    <message>
        <source>Largest steering angle</source>
        <translation>Ángulo de dirección máximo</translation>
    </message>
    <message>
        <source>Last pass</source>
        <translation>Última pasada</translation>
    </message>
    <message>
        <source>Lateral offset</source>
        <translation>Desplazamiento lateral</translation>
    </message>
    <message>
        <source>Least overlap</source>
        <translation>Menos solape</translation>
    </message>
    <message>
        <source>Least time</source>
        <translation>Menos tiempo</translation>
    </message>
    <message>
        <source>Leaves some swaths out at each turn and comes back for them.</source>
        <translation>Se salta pasadas en cada giro y vuelve a por ellas.</translation>
    </message>
    <message>
        <source>Left out</source>
        <translation>Saltadas</translation>
    </message>
    <message>
        <source>Limits the speed in tight bends.</source>
        <translation>Limita la velocidad en curvas cerradas.</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Línea</translation>
    </message>
    <message>
        <source>Lines along which the field inside the headland is cut; they run right through it, or end no farther than an operating width from its edge.</source>
        <translation>Líneas por las que se divide el interior; lo atraviesan por completo o terminan como mucho a un ancho de trabajo de su borde.</translation>
    </message>
    <message>
        <source>Litres of fuel per hour of turns and transfers.</source>
        <translation>Litros de combustible por hora de giros y trayectos.</translation>
    </message>
    <message>
        <source>Litres of fuel per hour of work.</source>
        <translation>Litros de combustible por hora de trabajo.</translation>
    </message>
    <message>
        <source>Long Strip</source>
        <translation>Franja Larga</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>Bucle</translation>
    </message>
    <message>
        <source>Lower the speeds, or correct the machine&apos;s.</source>
        <translation>Baje las velocidades o corrija las de la máquina.</translation>
    </message>
    <message>
        <source>MAVLink waypoints</source>
        <translation>Puntos de paso MAVLink</translation>
    </message>
    <message>
        <source>Make the gate wider, or take another.</source>
        <translation>Haga la entrada más ancha o use otra.</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Margen</translation>
    </message>
    <message>
        <source>Overhang</source>
        <translation>Voladizo</translation>
    </message>
    <message>
        <source>Most covered</source>
        <translation>Más superficie</translation>
    </message>
    <message>
        <source>Most terminals read FAT32 only; this stick has %1. Format it as FAT32.</source>
        <translation>La mayoría de terminales solo leen FAT32; esta memoria USB tiene %1. Formatéela como FAT32.</translation>
    </message>
    <message>
        <source>Mounted cultivator, 6 m</source>
        <translation>Cultivador suspendido, 6 m</translation>
    </message>
    <message>
        <source>Mounted drill, 12 m</source>
        <translation>Sembradora suspendida, 12 m</translation>
    </message>
    <message>
        <source>Mounting</source>
        <translation>Enganche</translation>
    </message>
    <message>
        <source>Mowing</source>
        <translation>Siega</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>No headland</source>
        <translation>Sin cabecera</translation>
    </message>
    <message>
        <source>Nothing leads to the start of %1, %2 away.</source>
        <translation>Nada lleva al inicio, a %2: %1.</translation>
    </message>
    <message>
        <source>Number of the boundary&apos;s edge, from 0 in the order of its points; for curves with all around it up to a corner of 35 degrees within a width, or a bend of 90 in all.</source>
        <translation>Número del lado del límite, desde 0 en el orden de sus puntos; en curvas con todos los contiguos hasta una esquina de 35 grados en un ancho, o una curva de 90 en total.</translation>
    </message>
    <message>
        <source>Of the four corners and both ways the one with the quickest turns.</source>
        <translation>De las cuatro esquinas y los dos sentidos, la de giros más rápidos.</translation>
    </message>
    <message>
        <source>Of the middle of the operating width, positive to the left.</source>
        <translation>Del centro del ancho de trabajo, positivo a la izquierda.</translation>
    </message>
    <message>
        <source>Of the swaths.</source>
        <translation>De las pasadas.</translation>
    </message>
    <message>
        <source>Off: the strip is kept for turning only.</source>
        <translation>No: la franja solo sirve para girar.</translation>
    </message>
    <message>
        <source>Omega turn</source>
        <translation>Giro en omega</translation>
    </message>
    <message>
        <source>On the rows</source>
        <translation>Sobre las hileras</translation>
    </message>
    <message>
        <source>On the rows, or between them.</source>
        <translation>Sobre las hileras o entre ellas.</translation>
    </message>
    <message>
        <source>On the spot</source>
        <translation>En el sitio</translation>
    </message>
    <message>
        <source>One for all</source>
        <translation>Una para todas</translation>
    </message>
    <message>
        <source>One piece</source>
        <translation>De una pieza</translation>
    </message>
    <message>
        <source>Only where it turns</source>
        <translation>Solo donde se gira</translation>
    </message>
    <message>
        <source>Operating width</source>
        <translation>Ancho de trabajo</translation>
    </message>
    <message>
        <source>Operation</source>
        <translation>Operación</translation>
    </message>
    <message>
        <source>Orchard tractor with 1.5 m sprayer</source>
        <translation>Tractor frutero con pulverizador de 1,5 m</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Orden</translation>
    </message>
    <message>
        <source>Overlap</source>
        <translation>Solape</translation>
    </message>
    <message>
        <source>Overlaps its neighbour</source>
        <translation>Se solapa con la vecina</translation>
    </message>
    <message>
        <source>P turn</source>
        <translation>Giro en P</translation>
    </message>
    <message>
        <source>Passes</source>
        <translation>Pasadas</translation>
    </message>
    <message>
        <source>Plan again with this machine&apos;s turning radius.</source>
        <translation>Planifique de nuevo con el radio de giro de esta máquina.</translation>
    </message>
    <message>
        <source>Plan again, or trust the positions.</source>
        <translation>Planifique de nuevo o confíe en las posiciones.</translation>
    </message>
    <message>
        <source>Plan again; the heading or the gear is wrong here.</source>
        <translation>Planifique de nuevo; el rumbo o la marcha no es correcta aquí.</translation>
    </message>
    <message>
        <source>Plan again; the path lacks this pass.</source>
        <translation>Planifique de nuevo; falta esta pasada en el recorrido.</translation>
    </message>
    <message>
        <source>Plan again; the path was changed or cut here.</source>
        <translation>Planifique de nuevo; el recorrido se cambió o se cortó aquí.</translation>
    </message>
    <message>
        <source>Plan again; the times were changed.</source>
        <translation>Planifique de nuevo; se cambiaron los tiempos.</translation>
    </message>
    <message>
        <source>Plan the parts of the field apart, or widen the passage between them.</source>
        <translation>Planifique las partes de la parcela por separado o ensanche el paso entre ellas.</translation>
    </message>
    <message>
        <source>Plan the turn that is missing here.</source>
        <translation>Planifique el giro que falta aquí.</translation>
    </message>
    <message>
        <source>Power harrow and drill, 3 m</source>
        <translation>Grada rotativa y sembradora, 3 m</translation>
    </message>
    <message>
        <source>Prefer</source>
        <translation>Preferir</translation>
    </message>
    <message>
        <source>Protobuf message</source>
        <translation>Mensaje Protobuf</translation>
    </message>
    <message>
        <source>QGroundControl plan</source>
        <translation>Plan de QGroundControl</translation>
    </message>
    <message>
        <source>Racetrack</source>
        <translation>Circuito</translation>
    </message>
    <message>
        <source>Raised width</source>
        <translation>Ancho levantado</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Dosis</translation>
    </message>
    <message>
        <source>Rear overhang</source>
        <translation>Voladizo trasero</translation>
    </message>
    <message>
        <source>Recorded path</source>
        <translation>Recorrido grabado</translation>
    </message>
    <message>
        <source>Relay 1 is on where the implement works.</source>
        <translation>El relé 1 está activado donde trabaja el apero.</translation>
    </message>
    <message>
        <source>Repaired in %1: %2.</source>
        <translation>Reparado (%1): %2.</translation>
    </message>
    <message>
        <source>Reverse</source>
        <translation>Marcha atrás</translation>
    </message>
    <message>
        <source>Reverse speed</source>
        <translation>Velocidad marcha atrás</translation>
    </message>
    <message>
        <source>Round and round the centre of a pivot, from the rim inwards.</source>
        <translation>Alrededor del centro de un pívot, del borde hacia dentro.</translation>
    </message>
    <message>
        <source>Round and round, with half of the swaths between the way out and the way back.</source>
        <translation>En redondo, con la mitad de las pasadas entre la ida y la vuelta.</translation>
    </message>
    <message>
        <source>Round the field</source>
        <translation>Alrededor de la parcela</translation>
    </message>
    <message>
        <source>Rounded</source>
        <translation>Redondeado</translation>
    </message>
    <message>
        <source>Route</source>
        <translation>Ruta</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>Hileras</translation>
    </message>
    <message>
        <source>Rows that are left out, numbered from 1 as in the file; between rows, that on the right.</source>
        <translation>Hileras que se omiten, desde 1 como en el archivo; entre hileras, la de la derecha.</translation>
    </message>
    <message>
        <source>Run-in</source>
        <translation>Tramo de entrada</translation>
    </message>
    <message>
        <source>Same width all round</source>
        <translation>Mismo ancho alrededor</translation>
    </message>
    <message>
        <source>Seen from above, turning left at corners.</source>
        <translation>Visto desde arriba, girando a la izquierda en las esquinas.</translation>
    </message>
    <message>
        <source>Seen from above, turning right at corners.</source>
        <translation>Visto desde arriba, girando a la derecha en las esquinas.</translation>
    </message>
    <message>
        <source>Short name for the command line.</source>
        <translation>Nombre corto para la línea de comandos.</translation>
    </message>
    <message>
        <source>Short passes where corners would leave more than 1 % of the field.</source>
        <translation>Pasadas cortas donde las esquinas dejarían más del 1 % de la parcela.</translation>
    </message>
    <message>
        <source>Shortest swaths</source>
        <translation>Pasadas más cortas</translation>
    </message>
    <message>
        <source>Shows the boundary and the guidance lines; it plans turns and order itself. Not tested on the machine by us.</source>
        <translation>Muestra el límite y las líneas de guiado; planifica él mismo giros y orden. No probado por nosotros en la máquina.</translation>
    </message>
    <message>
        <source>Shows the boundary with holes and obstacles and the guidance lines; it plans turns and order itself. The import may have to be unlocked. Not tested on the machine by us.</source>
        <translation>Muestra el límite con huecos y obstáculos y las líneas de guiado; planifica él mismo giros y orden. Puede que haya que desbloquear la importación. No probado por nosotros en la máquina.</translation>
    </message>
    <message>
        <source>Shows the boundary with holes and obstacles, the headland where the terminal knows it, and the guidance lines; it plans turns and order itself. The import may have to be unlocked. Not tested on the machine by us.</source>
        <translation>Muestra el límite con huecos y obstáculos, la cabecera si el terminal la conoce, y las líneas de guiado; planifica él mismo giros y orden. Puede que haya que desbloquear la importación. No probado por nosotros en la máquina.</translation>
    </message>
    <message>
        <source>Shows the boundary, its holes, the headland and the guidance lines, not the path. Holes are written as obstacles, since it overlooks others.</source>
        <translation>Muestra el límite, sus huecos, la cabecera y las líneas de guiado, no el recorrido. Los huecos se escriben como obstáculos, pues pasa por alto los demás.</translation>
    </message>
    <message>
        <source>Shows the path as a mission, and the boundary and obstacles as fences. Not tested on the machine by us.</source>
        <translation>Muestra el recorrido como misión, y el límite y los obstáculos como vallas. No probado por nosotros en la máquina.</translation>
    </message>
    <message>
        <source>Six directions, then ever finer around the best three (Oksanen &amp; Visala).</source>
        <translation>Seis direcciones, luego cada vez más fino alrededor de las tres mejores (Oksanen &amp; Visala).</translation>
    </message>
    <message>
        <source>Six-row planter, 4.5 m</source>
        <translation>Sembradora de seis hileras, 4,5 m</translation>
    </message>
    <message>
        <source>Skip</source>
        <translation>Saltar</translation>
    </message>
    <message>
        <source>Skip and fill</source>
        <translation>Saltar y rellenar</translation>
    </message>
    <message>
        <source>Slanted Field</source>
        <translation>Campo Oblicuo</translation>
    </message>
    <message>
        <source>Slurry tanker, 15 m trailing shoe</source>
        <translation>Cisterna de purín, patines de 15 m</translation>
    </message>
    <message>
        <source>Smallest circle the middle of the fixed axle can follow; from the steering angle where it is not given.</source>
        <translation>El círculo más pequeño que puede seguir el centro del eje fijo; si no se indica, se calcula con el ángulo de dirección.</translation>
    </message>
    <message>
        <source>Smallest turning radius</source>
        <translation>Radio de giro mínimo</translation>
    </message>
    <message>
        <source>Snake</source>
        <translation>Serpentina</translation>
    </message>
    <message>
        <source>So that the wide machine begins flush with the left edge, or beside the line that was given.</source>
        <translation>Para que la máquina ancha empiece a ras del borde izquierdo o junto a la línea dada.</translation>
    </message>
    <message>
        <source>Sowing</source>
        <translation>Siembra</translation>
    </message>
    <message>
        <source>Speed backwards.</source>
        <translation>Velocidad hacia atrás.</translation>
    </message>
    <message>
        <source>Speed on longer ways with the implement lifted.</source>
        <translation>Velocidad en trayectos largos con el apero levantado.</translation>
    </message>
    <message>
        <source>Speed with the implement at work.</source>
        <translation>Velocidad con el apero trabajando.</translation>
    </message>
    <message>
        <source>Spiral in clusters</source>
        <translation>Espiral por grupos</translation>
    </message>
    <message>
        <source>Split lines</source>
        <translation>Líneas de división</translation>
    </message>
    <message>
        <source>Spraying</source>
        <translation>Pulverización</translation>
    </message>
    <message>
        <source>Spread over all</source>
        <translation>Repartido entre todas</translation>
    </message>
    <message>
        <source>Spreading</source>
        <translation>Abonado</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Inicio</translation>
    </message>
    <message>
        <source>Start at</source>
        <translation>Empezar en</translation>
    </message>
    <message>
        <source>Stay inside</source>
        <translation>Quedarse dentro</translation>
    </message>
    <message>
        <source>Steering rate</source>
        <translation>Velocidad de dirección</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Paso</translation>
    </message>
    <message>
        <source>Straight into the corner and back into it on the next side.</source>
        <translation>Recto hasta la esquina y marcha atrás en el lado siguiente.</translation>
    </message>
    <message>
        <source>Straight into the corner and on after a loop, where there is room for it.</source>
        <translation>Recto hasta la esquina y, tras un bucle, adelante, donde haya sitio.</translation>
    </message>
    <message>
        <source>Straight way needed before the implement is lowered.</source>
        <translation>Tramo recto necesario antes de bajar el apero.</translation>
    </message>
    <message>
        <source>Swath after swath over all of the field, whatever cuts them.</source>
        <translation>Pasada tras pasada por todo el interior, sin mirar lo que las corta.</translation>
    </message>
    <message>
        <source>Swath numbers in driving order; a minus drives one the other way.</source>
        <translation>Números de pasada en orden; con un menos se hace al revés.</translation>
    </message>
    <message>
        <source>Swaths</source>
        <translation>Pasadas</translation>
    </message>
    <message>
        <source>Swaths go on from block to block.</source>
        <translation>Las pasadas siguen de una subparcela a otra.</translation>
    </message>
    <message>
        <source>Swaths go round obstacles of up to this size; larger ones get a headland. Auto is the operating width.</source>
        <translation>Las pasadas rodean los obstáculos de hasta este tamaño; los mayores reciben una cabecera. Auto es el ancho de trabajo.</translation>
    </message>
    <message>
        <source>Swaths left out at each turn and driven on the way back.</source>
        <translation>Pasadas que se saltan en cada giro y se hacen a la vuelta.</translation>
    </message>
    <message>
        <source>Swaths that are finished together.</source>
        <translation>Pasadas que se terminan juntas.</translation>
    </message>
    <message>
        <source>Takes the boundary only, as an upload from a computer; no guidance lines, no path.</source>
        <translation>Solo toma el límite, subido desde un ordenador; sin líneas de guiado ni recorrido.</translation>
    </message>
    <message>
        <source>Tank or bunker</source>
        <translation>Depósito o tolva</translation>
    </message>
    <message>
        <source>The Bend</source>
        <translation>La Curva</translation>
    </message>
    <message>
        <source>The best corner</source>
        <translation>La mejor esquina</translation>
    </message>
    <message>
        <source>The boundary alone as a flat zipped shapefile, as operations centres take it.</source>
        <translation>Solo el límite como shapefile comprimido sin carpetas, como lo aceptan los centros de operaciones.</translation>
    </message>
    <message>
        <source>The chosen one cannot be driven between these swaths.</source>
        <translation>El elegido no se puede hacer entre estas pasadas.</translation>
    </message>
    <message>
        <source>The corner where the route starts.</source>
        <translation>La esquina donde empieza la ruta.</translation>
    </message>
    <message>
        <source>The field is narrower here than the %1 in which this machine turns without reversing: leave this strip out, or work it with a machine that turns more tightly.</source>
        <translation>La parcela es aquí más estrecha que los %1 en los que esta máquina gira sin dar marcha atrás: deje fuera esta franja o trabájela con una máquina que gire más cerrado.</translation>
    </message>
    <message>
        <source>The field is narrower here than this machine, which takes %1: leave this strip out, or work it with a narrower machine.</source>
        <translation>La parcela es aquí más estrecha que esta máquina, que necesita %1: deje fuera esta franja o trabájela con una máquina más estrecha.</translation>
    </message>
    <message>
        <source>The field is too narrow for %1 of headland; it is %2 with %3</source>
        <translation>La parcela es demasiado estrecha para %1 de cabecera; quedan %2, con %3</translation>
    </message>
    <message>
        <source>The field is too narrow for %1 of headland; there is none</source>
        <translation>La parcela es demasiado estrecha para %1 de cabecera; no hay ninguna</translation>
    </message>
    <message>
        <source>The first swath</source>
        <translation>La primera pasada</translation>
    </message>
    <message>
        <source>The first swath on the left is one, or the line that was given.</source>
        <translation>Lo es la primera pasada de la izquierda o la línea dada.</translation>
    </message>
    <message>
        <source>The first swath on the right is one, or the line that was given.</source>
        <translation>Lo es la primera pasada de la derecha o la línea dada.</translation>
    </message>
    <message>
        <source>The headland is worked first.</source>
        <translation>La cabecera se trabaja primero.</translation>
    </message>
    <message>
        <source>The headland is worked last.</source>
        <translation>La cabecera se trabaja al final.</translation>
    </message>
    <message>
        <source>The headland strip, %1, is not worked by this plan, nor are %2 at the ends of the swaths beside it.</source>
        <translation>La franja de cabecera, %1, no se trabaja en este plan, ni %2 en los extremos de las pasadas contiguas.</translation>
    </message>
    <message>
        <source>The headland strip, %1, is not worked by this plan.</source>
        <translation>La franja de cabecera, %1, no se trabaja en este plan.</translation>
    </message>
    <message>
        <source>The hitch bends by %1 in %2; %3 are allowed.</source>
        <translation>El enganche se dobla %1 en %2; se permiten %3.</translation>
    </message>
    <message>
        <source>The largest covered share inside the headland.</source>
        <translation>La mayor superficie trabajada del interior.</translation>
    </message>
    <message>
        <source>The least metres driven in swaths, with what is missed added as metres.</source>
        <translation>Los menos metros recorridos en pasadas; lo que queda sin trabajar cuenta como metros.</translation>
    </message>
    <message>
        <source>The machine does not get in at %1.</source>
        <translation>La máquina no puede entrar por aquí: %1.</translation>
    </message>
    <message>
        <source>The machine does not get out at %1.</source>
        <translation>La máquina no puede salir por aquí: %1.</translation>
    </message>
    <message>
        <source>The machine drives half way between two neighbours.</source>
        <translation>La máquina va a medio camino entre dos vecinas.</translation>
    </message>
    <message>
        <source>The machine drives over them.</source>
        <translation>La máquina pasa sobre ellas.</translation>
    </message>
    <message>
        <source>The machine turns on the spot in %1, by up to %2.</source>
        <translation>La máquina gira en el sitio en %1, hasta %2.</translation>
    </message>
    <message>
        <source>The machine turns on the spot in %1, by up to %2; it cannot.</source>
        <translation>La máquina gira en el sitio en %1, hasta %2; no puede hacerlo.</translation>
    </message>
    <message>
        <source>The mission has %1 items; controllers without a memory card hold about %2.</source>
        <translation>La misión tiene %1 elementos; los controladores sin tarjeta admiten unos %2.</translation>
    </message>
    <message>
        <source>The outermost pass goes round with the machine&apos;s radius where little is left; others reach into corners.</source>
        <translation>La pasada exterior va con el radio de la máquina donde queda poco; las demás entran en las esquinas.</translation>
    </message>
    <message>
        <source>The outline has %1 steps of about %2, like the pixels of an image.</source>
        <translation>El contorno tiene %1 escalones de unos %2, como los píxeles de una imagen.</translation>
    </message>
    <message>
        <source>The pass along the boundary first.</source>
        <translation>Primero la pasada junto al límite.</translation>
    </message>
    <message>
        <source>The innermost pass first.</source>
        <translation>Primero la pasada junto al interior.</translation>
    </message>
    <message>
        <source>The path as a mission for ArduPilot Rover: waypoints, speeds, gear, implement.</source>
        <translation>El recorrido como misión para ArduPilot Rover: puntos, velocidades, marcha, apero.</translation>
    </message>
    <message>
        <source>The path as a track, swath ends as a route, gates as waypoints; for phones.</source>
        <translation>El recorrido como track, extremos de pasadas como ruta, entradas como puntos; para teléfonos.</translation>
    </message>
    <message>
        <source>The path as nav_msgs/Path in a recording of ROS 2.</source>
        <translation>El recorrido como nav_msgs/Path en una grabación de ROS 2.</translation>
    </message>
    <message>
        <source>The path as one message for ros2 topic pub.</source>
        <translation>El recorrido como un mensaje para ros2 topic pub.</translation>
    </message>
    <message>
        <source>The path with times, velocities and orientations, and the boundary as a fence; for own robots.</source>
        <translation>El recorrido con tiempos, velocidades y orientaciones, y el límite como valla; para robots propios.</translation>
    </message>
    <message>
        <source>The quickest turn of any kind that stays inside the field, in several moves where it must.</source>
        <translation>El giro más rápido de cualquier tipo que no sale de la parcela, en varias maniobras si hace falta.</translation>
    </message>
    <message>
        <source>The same as KML, zipped.</source>
        <translation>Lo mismo que KML, comprimido.</translation>
    </message>
    <message>
        <source>The same mission with the boundary and obstacles as fences.</source>
        <translation>La misma misión con el límite y los obstáculos como vallas.</translation>
    </message>
    <message>
        <source>The shortest curve forwards and backwards, at the smallest turning radius (Reeds and Shepp).</source>
        <translation>La curva más corta adelante y atrás, con el menor radio de giro (Reeds y Shepp).</translation>
    </message>
    <message>
        <source>The shortest curve without reversing, at the smallest turning radius (Dubins).</source>
        <translation>La curva más corta sin marcha atrás, con el menor radio de giro (Dubins).</translation>
    </message>
    <message>
        <source>The shortest time in swaths and turns.</source>
        <translation>El menor tiempo en pasadas y giros.</translation>
    </message>
    <message>
        <source>The smallest area worked twice.</source>
        <translation>La menor superficie trabajada dos veces.</translation>
    </message>
    <message>
        <source>The spacing is reduced evenly so that all fit.</source>
        <translation>La separación se reduce por igual para que quepan todas.</translation>
    </message>
    <message>
        <source>The stated curvature differs from the path in %1, by up to %2 1/m.</source>
        <translation>La curvatura indicada difiere del recorrido en %1, hasta %2 1/m.</translation>
    </message>
    <message>
        <source>The stated speed is up to %1 above the machine&apos;s.</source>
        <translation>La velocidad indicada supera hasta en %1 la de la máquina.</translation>
    </message>
    <message>
        <source>The strip kept for turning.</source>
        <translation>La franja que se deja para girar.</translation>
    </message>
    <message>
        <source>The swaths in the order and direction that you type.</source>
        <translation>Las pasadas en el orden y sentido que se escriba.</translation>
    </message>
    <message>
        <source>The table holds boundaries only: obstacles, gates and lines are left out.</source>
        <translation>La tabla solo contiene límites: se omiten obstáculos, entradas y líneas.</translation>
    </message>
    <message>
        <source>The task data has %1 MB; old terminals take at most 2 MB.</source>
        <translation>Los datos de tarea ocupan %1 MB; los terminales antiguos admiten 2 MB como mucho.</translation>
    </message>
    <message>
        <source>The tractor may drive backwards with it.</source>
        <translation>El tractor puede ir marcha atrás con él.</translation>
    </message>
    <message>
        <source>The tractor may drive backwards.</source>
        <translation>El tractor puede ir marcha atrás.</translation>
    </message>
    <message>
        <source>The tractor may turn about its own middle.</source>
        <translation>El tractor puede girar sobre su centro.</translation>
    </message>
    <message>
        <source>The way from %1 to %2</source>
        <translation>El trayecto %1 → %2</translation>
    </message>
    <message>
        <source>There the chosen one does not fit into the field or cannot be driven between these swaths.</source>
        <translation>El elegido no cabe allí en la parcela o no se puede hacer entre estas pasadas.</translation>
    </message>
    <message>
        <source>There the chosen one does not fit into the field.</source>
        <translation>El elegido no cabe allí en la parcela.</translation>
    </message>
    <message>
        <source>This machine cannot reverse.</source>
        <translation>Esta máquina no puede dar marcha atrás.</translation>
    </message>
    <message>
        <source>This stick has %1 partitions; terminals see the first one only, if any.</source>
        <translation>Esta memoria USB tiene %1 particiones; los terminales ven la primera, si acaso.</translation>
    </message>
    <message>
        <source>Three Ponds</source>
        <translation>Tres Charcas</translation>
    </message>
    <message>
        <source>Three-point turn</source>
        <translation>Giro en tres puntos</translation>
    </message>
    <message>
        <source>Through point A in the direction that you type.</source>
        <translation>Por el punto A en la dirección que se escriba.</translation>
    </message>
    <message>
        <source>Tillage</source>
        <translation>Laboreo</translation>
    </message>
    <message>
        <source>Time and way do not fit the speed in %1.</source>
        <translation>El tiempo y la distancia no cuadran con la velocidad en %1.</translation>
    </message>
    <message>
        <source>Time to lift</source>
        <translation>Tiempo para levantar</translation>
    </message>
    <message>
        <source>Time to lower</source>
        <translation>Tiempo para bajar</translation>
    </message>
    <message>
        <source>To and fro</source>
        <translation>Ida y vuelta</translation>
    </message>
    <message>
        <source>Trailed sprayer, 24 m boom</source>
        <translation>Pulverizador arrastrado, barra de 24 m</translation>
    </message>
    <message>
        <source>Tramline every</source>
        <translation>Calle de pulverización cada</translation>
    </message>
    <message>
        <source>Transfer speed</source>
        <translation>Velocidad en trayectos</translation>
    </message>
    <message>
        <source>Transport width</source>
        <translation>Ancho de transporte</translation>
    </message>
    <message>
        <source>Trapezoids</source>
        <translation>Trapecios</translation>
    </message>
    <message>
        <source>Tries every heading in steps and keeps the best.</source>
        <translation>Prueba todas las direcciones por pasos y se queda con la mejor.</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Giro</translation>
    </message>
    <message>
        <source>Turning speed</source>
        <translation>Velocidad de giro</translation>
    </message>
    <message>
        <source>Turns</source>
        <translation>Giros</translation>
    </message>
    <message>
        <source>Turns between swaths that are of another kind than chosen (path.method): %1 of %2. %3</source>
        <translation>Giros entre pasadas de otro tipo que el elegido (path.method): %1 de %2. %3</translation>
    </message>
    <message>
        <source>Turns in place and drives straight to the next swath; only for machines that can.</source>
        <translation>Gira en el sitio y va recto a la pasada siguiente; solo para máquinas que pueden.</translation>
    </message>
    <message>
        <source>Turns on the spot are chosen (path.method), and this machine cannot turn on the spot.</source>
        <translation>Se han elegido giros en el sitio (path.method) y esta máquina no puede girar en el sitio.</translation>
    </message>
    <message>
        <source>U turn</source>
        <translation>Giro en U</translation>
    </message>
    <message>
        <source>Vehicle length</source>
        <translation>Longitud del vehículo</translation>
    </message>
    <message>
        <source>Vehicle width</source>
        <translation>Ancho del vehículo</translation>
    </message>
    <message>
        <source>Ways</source>
        <translation>Trayectos</translation>
    </message>
    <message>
        <source>Ways keep to the field&apos;s edge.</source>
        <translation>Los trayectos siguen el borde de la parcela.</translation>
    </message>
    <message>
        <source>Ways keep to the headland; crop and seedbed are not driven over.</source>
        <translation>Los trayectos siguen la cabecera; no se pisan el cultivo ni el lecho de siembra.</translation>
    </message>
    <message>
        <source>Ways may cross worked land.</source>
        <translation>Los trayectos pueden cruzar el interior.</translation>
    </message>
    <message>
        <source>Well-known text</source>
        <translation>Well-known text</translation>
    </message>
    <message>
        <source>What becomes of the width that is left over at the far side.</source>
        <translation>Qué pasa con el ancho que sobra en el otro lado.</translation>
    </message>
    <message>
        <source>Distance from the boundary that nothing enters; auto is the boundary&apos;s accuracy.</source>
        <translation>Distancia al límite en la que nada entra; auto es la precisión del límite.</translation>
    </message>
    <message>
        <source>How far the implement may stand over the boundary and obstacles, its sections there switched off; the tractor and all wheels stay inside.</source>
        <translation>Hasta dónde puede sobresalir el apero del límite de parcela y sobre los obstáculos, con sus secciones allí cerradas; el tractor y todas las ruedas quedan dentro.</translation>
    </message>
    <message>
        <source>What is spread or gathered on a square metre, in the same unit.</source>
        <translation>Lo que se reparte o recoge en un metro cuadrado, en la misma unidad.</translation>
    </message>
    <message>
        <source>What it holds, in your own unit: litres, kilograms, seeds.</source>
        <translation>Lo que cabe, en su propia unidad: litros, kilos, semillas.</translation>
    </message>
    <message>
        <source>What the field is driven over for: sets when the headland is worked, ways and overlap.</source>
        <translation>La labor que se hace: fija cuándo se trabaja la cabecera, los trayectos y el solape.</translation>
    </message>
    <message>
        <source>What the machine is called.</source>
        <translation>Cómo se llama la máquina.</translation>
    </message>
    <message>
        <source>What the search for the best heading looks for.</source>
        <translation>Qué persigue la búsqueda de la mejor dirección.</translation>
    </message>
    <message>
        <source>Wheelbase</source>
        <translation>Distancia entre ejes</translation>
    </message>
    <message>
        <source>When</source>
        <translation>Cuándo</translation>
    </message>
    <message>
        <source>When speeding up and when braking.</source>
        <translation>Al acelerar y al frenar.</translation>
    </message>
    <message>
        <source>Where a swath ends at a slanting edge.</source>
        <translation>Dónde acaba una pasada en un borde oblicuo.</translation>
    </message>
    <message>
        <source>Where the machine may drive from swath to swath; follows from the operation.</source>
        <translation>Por dónde puede ir la máquina de pasada a pasada; depende de la operación.</translation>
    </message>
    <message>
        <source>Where the middle of the swath meets the headland.</source>
        <translation>Donde el centro de la pasada llega a la cabecera.</translation>
    </message>
    <message>
        <source>Where tramlines are counted from.</source>
        <translation>Desde dónde se cuentan las calles de pulverización.</translation>
    </message>
    <message>
        <source>Whether blocks have a heading of their own.</source>
        <translation>Si las subparcelas tienen su propia dirección.</translation>
    </message>
    <message>
        <source>Which way round the headland passes are driven.</source>
        <translation>En qué sentido se hacen las pasadas de cabecera.</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Ancho</translation>
    </message>
    <message>
        <source>Width in operating widths; auto leaves room for the turns.</source>
        <translation>Ancho en anchos de trabajo; auto deja sitio para los giros.</translation>
    </message>
    <message>
        <source>Width the tractor occupies, wheels included.</source>
        <translation>Ancho que ocupa el tractor, ruedas incluidas.</translation>
    </message>
    <message>
        <source>Width while folded for the road, through gates and on ways in and out; the raised width where it is not given.</source>
        <translation>Ancho plegado para la carretera, por las entradas y en los trayectos de entrada y salida; si no se indica, el ancho levantado.</translation>
    </message>
    <message>
        <source>Width while lifted or folded for a turn; the operating width where it is not given.</source>
        <translation>Ancho levantado o plegado para un giro; si no se indica, el ancho de trabajo.</translation>
    </message>
    <message>
        <source>Width worked in one pass.</source>
        <translation>Ancho trabajado en una pasada.</translation>
    </message>
    <message>
        <source>Without reversing, the wheels turned no faster than the machine can (clothoids).</source>
        <translation>Sin marcha atrás, sin girar las ruedas más rápido de lo que puede la máquina (clotoides).</translation>
    </message>
    <message>
        <source>Work it along the boundary, before or after the swaths.</source>
        <translation>Trabájela a lo largo del límite, antes o después de las pasadas.</translation>
    </message>
    <message>
        <source>Work the headland</source>
        <translation>Trabajar la cabecera</translation>
    </message>
    <message>
        <source>Working speed</source>
        <translation>Velocidad de trabajo</translation>
    </message>
    <message>
        <source>Working the soil: worked land may be driven over.</source>
        <translation>Labor del suelo: se puede cruzar el interior.</translation>
    </message>
    <message>
        <source>Your own order</source>
        <translation>Orden propio</translation>
    </message>
    <message>
        <source>Zipped boundary</source>
        <translation>Límite comprimido</translation>
    </message>
    <message>
        <source>a chunk of the recording has a wrong checksum</source>
        <translation>un bloque de la grabación tiene una suma de comprobación errónea</translation>
    </message>
    <message>
        <source>a chunk of the recording is cut off</source>
        <translation>un bloque de la grabación está cortado</translation>
    </message>
    <message>
        <source>a chunk of the recording is damaged</source>
        <translation>un bloque de la grabación está dañado</translation>
    </message>
    <message>
        <source>a compressed chunk of the recording is damaged</source>
        <translation>un bloque comprimido de la grabación está dañado</translation>
    </message>
    <message>
        <source>a coordinate is not a number</source>
        <translation>una coordenada no es un número</translation>
    </message>
    <message>
        <source>a curve needs at least two points that differ</source>
        <translation>una curva necesita al menos dos puntos distintos</translation>
    </message>
    <message>
        <source>a drawing does not say which coordinate system it uses</source>
        <translation>un dibujo no dice qué sistema de coordenadas usa</translation>
    </message>
    <message>
        <source>a hole lies outside the boundary</source>
        <translation>un hueco queda fuera del límite</translation>
    </message>
    <message>
        <source>a hole of &apos;%1&apos; is missing or another</source>
        <translation>falta o difiere un hueco de «%1»</translation>
    </message>
    <message>
        <source>a machine is one JSON object</source>
        <translation>una máquina es un objeto JSON</translation>
    </message>
    <message>
        <source>a message is cut off</source>
        <translation>un mensaje está cortado</translation>
    </message>
    <message>
        <source>a message is not plain CDR</source>
        <translation>un mensaje no es CDR simple</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>un número</translation>
    </message>
    <message>
        <source>a number is too large to be read</source>
        <translation>un número es demasiado grande para leerlo</translation>
    </message>
    <message>
        <source>a part of it states %1 bytes, more than 256 MiB</source>
        <translation>una parte indica %1 bytes, más de 256 MiB</translation>
    </message>
    <message>
        <source>a part of the boundary of &apos;%1&apos; is missing or another</source>
        <translation>falta o difiere una parte del límite de «%1»</translation>
    </message>
    <message>
        <source>a point</source>
        <translation>un punto</translation>
    </message>
    <message>
        <source>a point has no place in EPSG:%1</source>
        <translation>un punto no tiene lugar en EPSG:%1</translation>
    </message>
    <message>
        <source>a point or a line in WGS84 such as LINESTRING (4.1 52.0, 4.2 52.0)</source>
        <translation>un punto o una línea en WGS84 como LINESTRING (4.1 52.0, 4.2 52.0)</translation>
    </message>
    <message>
        <source>a record of the recording is damaged</source>
        <translation>un registro de la grabación está dañado</translation>
    </message>
    <message>
        <source>a sliver of %1 was left out</source>
        <translation>se ha omitido un resto de %1</translation>
    </message>
    <message>
        <source>a track that ended %1 from where it began was closed</source>
        <translation>se ha cerrado un track que acababa a %1 de su comienzo</translation>
    </message>
    <message>
        <source>a value of its own</source>
        <translation>un valor propio</translation>
    </message>
    <message>
        <source>add the .prj file that belongs to it, or export the field again in WGS84</source>
        <translation>añada el archivo .prj correspondiente o exporte la parcela de nuevo en WGS84</translation>
    </message>
    <message>
        <source>allow it to be kept as a backup</source>
        <translation>permita conservarlo como copia</translation>
    </message>
    <message>
        <source>an obstacle</source>
        <translation>un obstáculo</translation>
    </message>
    <message>
        <source>an obstacle has no shape</source>
        <translation>un obstáculo no tiene forma</translation>
    </message>
    <message>
        <source>an overlap of %1 leaves nothing of %2</source>
        <translation>un solape de %1 no deja nada de %2</translation>
    </message>
    <message>
        <source>boundary accuracy</source>
        <translation>precisión del límite</translation>
    </message>
    <message>
        <source>changes cannot be kept for the case of a crash: %1</source>
        <translation>los cambios no se pueden conservar por si falla el programa: %1</translation>
    </message>
    <message>
        <source>check its coordinates</source>
        <translation>compruebe sus coordenadas</translation>
    </message>
    <message>
        <source>check that the folder can be written to</source>
        <translation>compruebe que se puede escribir en la carpeta</translation>
    </message>
    <message>
        <source>check that you may read it</source>
        <translation>compruebe que tiene permiso para leerlo</translation>
    </message>
    <message>
        <source>check the boundary for crossings</source>
        <translation>compruebe si el límite se cruza</translation>
    </message>
    <message>
        <source>check the coordinate system, correct this point, or split the field</source>
        <translation>compruebe el sistema de coordenadas, corrija este punto o divida la parcela</translation>
    </message>
    <message>
        <source>check the file&apos;s coordinate system</source>
        <translation>compruebe el sistema de coordenadas del archivo</translation>
    </message>
    <message>
        <source>check the operating width and the overlap</source>
        <translation>compruebe el ancho de trabajo y el solape</translation>
    </message>
    <message>
        <source>check the path</source>
        <translation>compruebe la ruta</translation>
    </message>
    <message>
        <source>check the width and how far the edge lies from the line</source>
        <translation>compruebe el ancho y la distancia del borde a la línea</translation>
    </message>
    <message>
        <source>check the width of the implement, or take the track as driven around the field</source>
        <translation>compruebe el ancho del apero o tome el recorrido como vuelta alrededor de la parcela</translation>
    </message>
    <message>
        <source>choose a narrower headland or a narrower machine</source>
        <translation>elija una cabecera o una máquina más estrecha</translation>
    </message>
    <message>
        <source>choose a smaller machine or check the boundary&apos;s coordinate system</source>
        <translation>elija una máquina menor o compruebe el sistema de coordenadas del límite</translation>
    </message>
    <message>
        <source>choose another format</source>
        <translation>elija otro formato</translation>
    </message>
    <message>
        <source>choose one by its id: %1</source>
        <translation>elija uno por su identificador: %1</translation>
    </message>
    <message>
        <source>choose one by its number in the file: %1</source>
        <translation>elija una por su número en el archivo: %1</translation>
    </message>
    <message>
        <source>choose the format rosbag2-mcap</source>
        <translation>elija el formato rosbag2-mcap</translation>
    </message>
    <message>
        <source>close it there first</source>
        <translation>ciérrelo allí primero</translation>
    </message>
    <message>
        <source>contour needs heights</source>
        <translation>las curvas de nivel necesitan alturas</translation>
    </message>
    <message>
        <source>copy it again, or mend it with &apos;mcap recover&apos; or sqlite3&apos;s &apos;.recover&apos;</source>
        <translation>cópielo de nuevo o repárelo con «mcap recover» o con «.recover» de sqlite3</translation>
    </message>
    <message>
        <source>copy or export it again</source>
        <translation>cópielo o expórtelo de nuevo</translation>
    </message>
    <message>
        <source>copy or export the recording again</source>
        <translation>copie o exporte de nuevo la grabación</translation>
    </message>
    <message>
        <source>copy the whole folder</source>
        <translation>copie la carpeta entera</translation>
    </message>
    <message>
        <source>correct it, or remove the hole or obstacle from the file</source>
        <translation>corríjalo, o quite el hueco u obstáculo del archivo</translation>
    </message>
    <message>
        <source>correct or delete this point in the file</source>
        <translation>corrija o elimine este punto en el archivo</translation>
    </message>
    <message>
        <source>correct or remove the line</source>
        <translation>corrija o elimine la línea</translation>
    </message>
    <message>
        <source>correct or remove the point</source>
        <translation>corrija o elimine el punto</translation>
    </message>
    <message>
        <source>correct the line, or export the track in WGS84</source>
        <translation>corrija la línea o exporte el recorrido en WGS84</translation>
    </message>
    <message>
        <source>could not be read: %1</source>
        <translation>no se pudo leer: %1</translation>
    </message>
    <message>
        <source>could not be written: %1</source>
        <translation>no se pudo escribir: %1</translation>
    </message>
    <message>
        <source>crosses an obstacle</source>
        <translation>cruza un obstáculo</translation>
    </message>
    <message>
        <source>cut it into the days or fields that it holds</source>
        <translation>divídalo en los días o parcelas que contiene</translation>
    </message>
    <message>
        <source>decimal commas in the place of the field were taken for points</source>
        <translation>las comas decimales en la posición de la parcela se tomaron por puntos</translation>
    </message>
    <message>
        <source>delete some of them</source>
        <translation>elimine algunos</translation>
    </message>
    <message>
        <source>delete the hole that covers it</source>
        <translation>elimine el hueco que lo cubre</translation>
    </message>
    <message>
        <source>did you mean &apos;%1&apos;?</source>
        <translation>¿quería decir «%1»?</translation>
    </message>
    <message>
        <source>did you mean &apos;%1&apos;? use one of: %2; or give a machine file (.json)</source>
        <translation>¿quería decir «%1»? use una de: %2; o indique un archivo de máquina (.json)</translation>
    </message>
    <message>
        <source>download the file and give its path</source>
        <translation>descargue el archivo e indique su ruta</translation>
    </message>
    <message>
        <source>draw it again</source>
        <translation>dibújelo de nuevo</translation>
    </message>
    <message>
        <source>draw it again with at least 3 corners</source>
        <translation>dibújelo de nuevo con al menos 3 esquinas</translation>
    </message>
    <message>
        <source>draw it as an area, or remove it from the file</source>
        <translation>dibújelo como superficie, o quítelo del archivo</translation>
    </message>
    <message>
        <source>draw it, or remove it from the file</source>
        <translation>dibújelo, o quítelo del archivo</translation>
    </message>
    <message>
        <source>draw one or open a file that has one</source>
        <translation>dibuje uno o abra un archivo que lo tenga</translation>
    </message>
    <message>
        <source>draw or open one in the window first</source>
        <translation>dibuje o abra antes una en la ventana</translation>
    </message>
    <message>
        <source>drive on to where the recording began, or take the track as worked land</source>
        <translation>siga hasta donde empezó la grabación o tome el recorrido como tierra trabajada</translation>
    </message>
    <message>
        <source>export fewer fields at once</source>
        <translation>exporte menos parcelas a la vez</translation>
    </message>
    <message>
        <source>export it again</source>
        <translation>expórtela de nuevo</translation>
    </message>
    <message>
        <source>export it again with its coordinate system</source>
        <translation>expórtelo de nuevo con su sistema de coordenadas</translation>
    </message>
    <message>
        <source>export or copy it again</source>
        <translation>expórtelo o cópielo de nuevo</translation>
    </message>
    <message>
        <source>export the boundary as a polygon</source>
        <translation>exporte el límite como polígono</translation>
    </message>
    <message>
        <source>export the field again in WGS84 (longitude and latitude)</source>
        <translation>exporte la parcela de nuevo en WGS84 (longitud y latitud)</translation>
    </message>
    <message>
        <source>export the field with its boundary</source>
        <translation>exporte la parcela con su límite</translation>
    </message>
    <message>
        <source>export the field with its boundary; furrow-cli compare reads what a machine recorded</source>
        <translation>exporte la parcela con su límite; furrow-cli compare lee lo que grabó una máquina</translation>
    </message>
    <message>
        <source>export the fields again in one coordinate system</source>
        <translation>exporte las parcelas de nuevo en un solo sistema de coordenadas</translation>
    </message>
    <message>
        <source>export the recorded track, not only its waypoints</source>
        <translation>exporte el recorrido grabado, no solo sus puntos de paso</translation>
    </message>
    <message>
        <source>feature %1</source>
        <translation>objeto %1</translation>
    </message>
    <message>
        <source>fewer than 3 different points enclose nothing</source>
        <translation>menos de 3 puntos distintos no encierran nada</translation>
    </message>
    <message>
        <source>free some space on it, or use another one</source>
        <translation>libere espacio o use otra</translation>
    </message>
    <message>
        <source>free some space on the stick</source>
        <translation>libere espacio en la memoria USB</translation>
    </message>
    <message>
        <source>free some space or choose another folder</source>
        <translation>libere espacio o elija otra carpeta</translation>
    </message>
    <message>
        <source>gate %1</source>
        <translation>entrada %1</translation>
    </message>
    <message>
        <source>give %1</source>
        <translation>indique %1</translation>
    </message>
    <message>
        <source>give 0 m or more</source>
        <translation>indique 0 m o más</translation>
    </message>
    <message>
        <source>give GPX, CSV, an NMEA or gpsd log, ISOXML task data (folder, TASKDATA.XML or zip) or a rosbag2</source>
        <translation>indique GPX, CSV, un registro NMEA o gpsd, datos de tareas ISOXML (carpeta, TASKDATA.XML o zip) o un rosbag2</translation>
    </message>
    <message>
        <source>give GeoJSON, a shapefile (.shp or .zip), TASKDATA.XML, KML, KMZ, GeoPackage, GML, FlatGeobuf, DXF, WKT or CSV</source>
        <translation>indique GeoJSON, un shapefile (.shp o .zip), TASKDATA.XML, KML, KMZ, GeoPackage, GML, FlatGeobuf, DXF, WKT o CSV</translation>
    </message>
    <message>
        <source>give a GeoTIFF, or a world file (.pgw) beside the PNG</source>
        <translation>indique un GeoTIFF o un archivo de georreferencia (.pgw) junto al PNG</translation>
    </message>
    <message>
        <source>give a buffer of 0 m or more</source>
        <translation>indique una distancia de 0 m o más</translation>
    </message>
    <message>
        <source>give a distance up to 50 m</source>
        <translation>indique una distancia de hasta 50 m</translation>
    </message>
    <message>
        <source>give a gap up to 100 m</source>
        <translation>indique un hueco de hasta 100 m</translation>
    </message>
    <message>
        <source>give a plan and a track of the same field</source>
        <translation>indique un plan y un recorrido de la misma parcela</translation>
    </message>
    <message>
        <source>give a width up to 100 m</source>
        <translation>indique un ancho de hasta 100 m</translation>
    </message>
    <message>
        <source>give an overhang of 0 to 100 m</source>
        <translation>indique un voladizo de 0 a 100 m</translation>
    </message>
    <message>
        <source>give a curve that does not, or plan its parts apart</source>
        <translation>indique una curva que no se cruce o planifique sus partes por separado</translation>
    </message>
    <message>
        <source>give a file on a disk</source>
        <translation>indique un archivo en un disco</translation>
    </message>
    <message>
        <source>give a file with a line for each row</source>
        <translation>indique un archivo con una línea por hilera</translation>
    </message>
    <message>
        <source>give a gate, or a point in the field</source>
        <translation>indique una entrada o un punto de la parcela</translation>
    </message>
    <message>
        <source>give a gentler curve, or one without a turn back</source>
        <translation>indique una curva más suave o sin vuelta atrás</translation>
    </message>
    <message>
        <source>give a machine file (JSON)</source>
        <translation>indique un archivo de máquina (JSON)</translation>
    </message>
    <message>
        <source>give a number</source>
        <translation>indique un número</translation>
    </message>
    <message>
        <source>give a number from %1 to %2</source>
        <translation>indique un número de %1 a %2</translation>
    </message>
    <message>
        <source>give a number from 0 to %1</source>
        <translation>indique un número de 0 a %1</translation>
    </message>
    <message>
        <source>give a number in %1</source>
        <translation>indique un número en %1</translation>
    </message>
    <message>
        <source>give a picture of at most 100 million pixels</source>
        <translation>indique una imagen de 100 millones de píxeles como mucho</translation>
    </message>
    <message>
        <source>give a point such as POINT (4.1 52.0)</source>
        <translation>indique un punto como POINT (4.1 52.0)</translation>
    </message>
    <message>
        <source>give a smaller margin or check the obstacles</source>
        <translation>indique un margen menor o compruebe los obstáculos</translation>
    </message>
    <message>
        <source>give a smaller number</source>
        <translation>indique un número menor</translation>
    </message>
    <message>
        <source>give a text in quotes</source>
        <translation>indique un texto entre comillas</translation>
    </message>
    <message>
        <source>give a transverse Mercator with +lat_0 and +lon_0</source>
        <translation>indique una transversa de Mercator con +lat_0 y +lon_0</translation>
    </message>
    <message>
        <source>give a width of 0 m or more</source>
        <translation>indique un ancho de 0 m o más</translation>
    </message>
    <message>
        <source>give an EPSG code, as in SRID=4326;POLYGON(...)</source>
        <translation>indique un código EPSG, como SRID=4326;POLYGON(...)</translation>
    </message>
    <message>
        <source>give both in degrees, or remove the row</source>
        <translation>indique ambas en grados o quite la fila</translation>
    </message>
    <message>
        <source>give each point as [longitude, latitude]</source>
        <translation>indique cada punto como [longitud, latitud]</translation>
    </message>
    <message>
        <source>give heights as a GeoTIFF or an ASCII grid</source>
        <translation>indique alturas como GeoTIFF o malla ASCII</translation>
    </message>
    <message>
        <source>give heights that cover the field</source>
        <translation>indique alturas que cubran la parcela</translation>
    </message>
    <message>
        <source>give it a kind, or remove it from the file</source>
        <translation>indique su clase, o quítelo del archivo</translation>
    </message>
    <message>
        <source>give it as WKT in WGS84, %1</source>
        <translation>indíquela como WKT en WGS84, %1</translation>
    </message>
    <message>
        <source>give it as WKT in WGS84, such as LINESTRING (4.1 52.0, 4.2 52.0, 4.3 52.1)</source>
        <translation>indíquela como WKT en WGS84, como LINESTRING (4.1 52.0, 4.2 52.0, 4.3 52.1)</translation>
    </message>
    <message>
        <source>give it as WKT in WGS84, such as POINT (4.1 52.0)</source>
        <translation>indíquelo como WKT en WGS84, como POINT (4.1 52.0)</translation>
    </message>
    <message>
        <source>give it the field that it lies in, or remove it from the file</source>
        <translation>indique la parcela en la que está, o quítelo del archivo</translation>
    </message>
    <message>
        <source>give its width while it is folded</source>
        <translation>indique su ancho plegado</translation>
    </message>
    <message>
        <source>give less than the operating width</source>
        <translation>indique menos que el ancho de trabajo</translation>
    </message>
    <message>
        <source>give metres, 0 or more</source>
        <translation>indique metros, 0 o más</translation>
    </message>
    <message>
        <source>give min_turning_radius_m or max_steering_angle_deg</source>
        <translation>indique min_turning_radius_m o max_steering_angle_deg</translation>
    </message>
    <message>
        <source>give one of %1 or a point such as POINT (4.1 52.0)</source>
        <translation>indique una de %1 o un punto como POINT (4.1 52.0)</translation>
    </message>
    <message>
        <source>give one of the files in it</source>
        <translation>indique uno de sus archivos</translation>
    </message>
    <message>
        <source>give operating_width_m in metres</source>
        <translation>indique operating_width_m en metros</translation>
    </message>
    <message>
        <source>give the file TASKDATA.XML</source>
        <translation>indique el archivo TASKDATA.XML</translation>
    </message>
    <message>
        <source>give the folder of a field</source>
        <translation>indique la carpeta de una parcela</translation>
    </message>
    <message>
        <source>give the folder of one of these, or a file in it</source>
        <translation>indique la carpeta de uno de ellos o un archivo de ella</translation>
    </message>
    <message>
        <source>give the folder of one recording</source>
        <translation>indique la carpeta de una grabación</translation>
    </message>
    <message>
        <source>give the folder or zip with TASKDATA.XML and its TLG files, a rosbag2 folder, or one file</source>
        <translation>indique la carpeta o el zip con TASKDATA.XML y sus archivos TLG, una carpeta de rosbag2 o un archivo</translation>
    </message>
    <message>
        <source>give the points in degrees (WGS84), longitude in lon and latitude in lat</source>
        <translation>indique los puntos en grados (WGS84), longitud en lon y latitud en lat</translation>
    </message>
    <message>
        <source>give true or false</source>
        <translation>indique true o false</translation>
    </message>
    <message>
        <source>give two points at least 1 m apart</source>
        <translation>indique dos puntos separados al menos 1 m</translation>
    </message>
    <message>
        <source>give x_m and y_m in the plan&apos;s frame, or longitude and latitude</source>
        <translation>indique x_m e y_m en el sistema del plan, o longitud y latitud</translation>
    </message>
    <message>
        <source>guidance lines without two points</source>
        <translation>líneas de guiado sin dos puntos</translation>
    </message>
    <message>
        <source>guidance patterns whose points do not fit their kind</source>
        <translation>patrones de guiado cuyos puntos no concuerdan con su tipo</translation>
    </message>
    <message>
        <source>guidance patterns without a line</source>
        <translation>patrones de guiado sin línea</translation>
    </message>
    <message>
        <source>headland pass %1</source>
        <translation>pasada de cabecera %1</translation>
    </message>
    <message>
        <source>hole %1 encloses no area and was left out</source>
        <translation>el hueco %1 no encierra superficie y se ha omitido</translation>
    </message>
    <message>
        <source>it does not say in which coordinate system it is</source>
        <translation>no dice en qué sistema de coordenadas está</translation>
    </message>
    <message>
        <source>it does not say what it is</source>
        <translation>no dice qué es</translation>
    </message>
    <message>
        <source>it does not say which field it belongs to</source>
        <translation>no dice a qué parcela pertenece</translation>
    </message>
    <message>
        <source>it has %1 by %2 pixels</source>
        <translation>tiene %1 por %2 píxeles</translation>
    </message>
    <message>
        <source>it has %1: %2</source>
        <translation>tiene %1: %2</translation>
    </message>
    <message>
        <source>it has another coordinate system than the file</source>
        <translation>tiene otro sistema de coordenadas que el archivo</translation>
    </message>
    <message>
        <source>it has more than %1 parts</source>
        <translation>tiene más de %1 partes</translation>
    </message>
    <message>
        <source>it has no heights where the field is</source>
        <translation>no tiene alturas donde está la parcela</translation>
    </message>
    <message>
        <source>it has no shape</source>
        <translation>no tiene forma</translation>
    </message>
    <message>
        <source>it has: %1</source>
        <translation>tiene: %1</translation>
    </message>
    <message>
        <source>it holds more than %1 files</source>
        <translation>contiene más de %1 archivos</translation>
    </message>
    <message>
        <source>it holds more than %1 positions</source>
        <translation>contiene más de %1 posiciones</translation>
    </message>
    <message>
        <source>it is a line at %1 without a width</source>
        <translation>es una línea en %1 sin ancho</translation>
    </message>
    <message>
        <source>it is a point at %1 without a size</source>
        <translation>es un punto en %1 sin tamaño</translation>
    </message>
    <message>
        <source>it is no closed line</source>
        <translation>no es una línea cerrada</translation>
    </message>
    <message>
        <source>it is no raster of heights</source>
        <translation>no es un ráster de alturas</translation>
    </message>
    <message>
        <source>it is no rosbag2 that can be read (%1)</source>
        <translation>no es un rosbag2 legible (%1)</translation>
    </message>
    <message>
        <source>it is not a length</source>
        <translation>no es una longitud</translation>
    </message>
    <message>
        <source>it is not what a plan&apos;s is</source>
        <translation>no es el de un plan</translation>
    </message>
    <message>
        <source>it lies in none of the %1 fields</source>
        <translation>no está en ninguna de las %1 parcelas</translation>
    </message>
    <message>
        <source>it lies outside the field</source>
        <translation>queda fuera de la parcela</translation>
    </message>
    <message>
        <source>it may be damaged; copy or export it again</source>
        <translation>puede estar dañado; cópielo o expórtelo de nuevo</translation>
    </message>
    <message>
        <source>it names no local frame</source>
        <translation>no nombra ningún sistema local</translation>
    </message>
    <message>
        <source>it names no machine</source>
        <translation>no nombra ninguna máquina</translation>
    </message>
    <message>
        <source>it needs latitude and longitude, as in 52.09,5.66</source>
        <translation>necesita latitud y longitud, como 52.09,5.66</translation>
    </message>
    <message>
        <source>its buffer is not a length</source>
        <translation>su distancia no es una longitud</translation>
    </message>
    <message>
        <source>its compression &apos;%1&apos; is not known</source>
        <translation>su compresión «%1» no se conoce</translation>
    </message>
    <message>
        <source>its overhang is not a length from 0 to 100 m</source>
        <translation>su voladizo no es una longitud de 0 a 100 m</translation>
    </message>
    <message>
        <source>its coordinate system &apos;%1&apos; cannot be turned into WGS84</source>
        <translation>su sistema de coordenadas «%1» no se puede pasar a WGS84</translation>
    </message>
    <message>
        <source>its coordinate system &apos;%1&apos; is not known</source>
        <translation>su sistema de coordenadas «%1» no se conoce</translation>
    </message>
    <message>
        <source>its coordinate system cannot be turned into WGS84</source>
        <translation>su sistema de coordenadas no se puede pasar a WGS84</translation>
    </message>
    <message>
        <source>its coordinate system would have to be fetched from &apos;%1&apos;</source>
        <translation>su sistema de coordenadas tendría que descargarse de «%1»</translation>
    </message>
    <message>
        <source>its file is missing</source>
        <translation>falta su archivo</translation>
    </message>
    <message>
        <source>its heights cannot be read</source>
        <translation>no se pueden leer sus alturas</translation>
    </message>
    <message>
        <source>its holes leave nothing of it</source>
        <translation>los huecos no dejan nada</translation>
    </message>
    <message>
        <source>its kind &apos;%1&apos; is not known</source>
        <translation>su clase «%1» no se conoce</translation>
    </message>
    <message>
        <source>its points enclose no area</source>
        <translation>sus puntos no encierran superficie</translation>
    </message>
    <message>
        <source>its width is not a length</source>
        <translation>su ancho no es una longitud</translation>
    </message>
    <message>
        <source>keep one of them</source>
        <translation>deje una de ellas</translation>
    </message>
    <message>
        <source>keep the .shp, .shx, .dbf and .prj files together</source>
        <translation>mantenga juntos .shp, .shx, .dbf y .prj</translation>
    </message>
    <message>
        <source>leave it out, or give a project of the window</source>
        <translation>omítalo, o indique un proyecto de la ventana</translation>
    </message>
    <message>
        <source>leaves the field by %1</source>
        <translation>sale %1 de la parcela</translation>
    </message>
    <message>
        <source>left out: %1</source>
        <translation>omitido: %1</translation>
    </message>
    <message>
        <source>left out: %1 %2</source>
        <translation>omitido: %1 %2</translation>
    </message>
    <message>
        <source>line %1 is left out: it is damaged</source>
        <translation>se omite la línea %1: está dañada</translation>
    </message>
    <message>
        <source>line %1, column %2</source>
        <translation>línea %1, columna %2</translation>
    </message>
    <message>
        <source>lines in WGS84 such as MULTILINESTRING ((4.1 52.0, 4.2 52.0), (4.1 52.1, 4.2 52.1))</source>
        <translation>líneas en WGS84 como MULTILINESTRING ((4.1 52.0, 4.2 52.0), (4.1 52.1, 4.2 52.1))</translation>
    </message>
    <message>
        <source>lines that guide nothing</source>
        <translation>líneas que no guían nada</translation>
    </message>
    <message>
        <source>lon=&quot;%1&quot; lat=&quot;%2&quot; is no place on Earth</source>
        <translation>lon=&quot;%1&quot; lat=&quot;%2&quot; no es un lugar de la Tierra</translation>
    </message>
    <message>
        <source>look for a missing comma, quote or brace just before it</source>
        <translation>busque justo antes una coma, comilla o llave que falte</translation>
    </message>
    <message>
        <source>most of its lines are not JSON</source>
        <translation>la mayoría de sus líneas no son JSON</translation>
    </message>
    <message>
        <source>most of its sentences have a wrong checksum</source>
        <translation>la mayoría de sus sentencias tienen una suma de comprobación errónea</translation>
    </message>
    <message>
        <source>move one of the points there, so that it is clear which side is field</source>
        <translation>mueva ahí un punto para que quede claro de qué lado está la parcela</translation>
    </message>
    <message>
        <source>move or delete it</source>
        <translation>muévalo o elimínelo</translation>
    </message>
    <message>
        <source>name a raster of heights, such as a GeoTIFF</source>
        <translation>indique un ráster de alturas, como un GeoTIFF</translation>
    </message>
    <message>
        <source>name each swath once</source>
        <translation>indique cada pasada una vez</translation>
    </message>
    <message>
        <source>name each swath once, with a minus where it is driven backwards</source>
        <translation>indique cada pasada una vez, con un menos donde se hace al revés</translation>
    </message>
    <message>
        <source>name one, such as GeoJSON with a LineString for each row</source>
        <translation>indique uno, como GeoJSON con un LineString por hilera</translation>
    </message>
    <message>
        <source>name the columns in the first row</source>
        <translation>ponga nombre a las columnas en la primera fila</translation>
    </message>
    <message>
        <source>name the columns, for example time,lon,lat,speed_kmh in the first line</source>
        <translation>nombre las columnas, por ejemplo time,lon,lat,speed_kmh en la primera línea</translation>
    </message>
    <message>
        <source>name the folder of a plan, as furrow-cli plan writes it</source>
        <translation>indique la carpeta de un plan, como la escribe furrow-cli plan</translation>
    </message>
    <message>
        <source>neither turning radius nor steering angle is given</source>
        <translation>no se da ni radio de giro ni ángulo de dirección</translation>
    </message>
    <message>
        <source>no boundary can be read from this file (%1)</source>
        <translation>no se puede leer ningún límite de este archivo (%1)</translation>
    </message>
    <message>
        <source>no header names a longitude and a latitude (or x_m and y_m)</source>
        <translation>ninguna cabecera nombra longitud y latitud (o x_m e y_m)</translation>
    </message>
    <message>
        <source>no pixel of the picture is worked</source>
        <translation>ningún píxel de la imagen está trabajado</translation>
    </message>
    <message>
        <source>no row of this table has a position</source>
        <translation>ninguna fila de esta tabla tiene posición</translation>
    </message>
    <message>
        <source>no swath fits inside the headland</source>
        <translation>no cabe ninguna pasada en el interior de la parcela</translation>
    </message>
    <message>
        <source>no topic of this bag has a position</source>
        <translation>ningún topic de este bag tiene posición</translation>
    </message>
    <message>
        <source>none of its %1 RMC and GGA sentences has a position</source>
        <translation>ninguna de sus %1 sentencias RMC y GGA tiene posición</translation>
    </message>
    <message>
        <source>none of its %1 position reports has a position</source>
        <translation>ninguno de sus %1 avisos de posición tiene posición</translation>
    </message>
    <message>
        <source>none of its %1 time logs holds a position</source>
        <translation>ninguno de sus %1 registros de tiempo contiene posiciones</translation>
    </message>
    <message>
        <source>none of the tracks has more than one position</source>
        <translation>ninguno de los recorridos tiene más de una posición</translation>
    </message>
    <message>
        <source>nothing is left of the land inside of this track</source>
        <translation>no queda nada de la tierra dentro de este recorrido</translation>
    </message>
    <message>
        <source>obstacle %1</source>
        <translation>obstáculo %1</translation>
    </message>
    <message>
        <source>obstacles outside the boundary</source>
        <translation>obstáculos fuera del límite</translation>
    </message>
    <message>
        <source>obstacles that are holes already</source>
        <translation>obstáculos que ya son huecos</translation>
    </message>
    <message>
        <source>one of its choices</source>
        <translation>una de sus opciones</translation>
    </message>
    <message>
        <source>only files on this computer are read</source>
        <translation>solo se leen archivos de este ordenador</translation>
    </message>
    <message>
        <source>only the fields of a project have plans</source>
        <translation>solo las parcelas de un proyecto tienen planes</translation>
    </message>
    <message>
        <source>open a file of your own</source>
        <translation>abra un archivo propio</translation>
    </message>
    <message>
        <source>open it as a field boundary, or choose another file</source>
        <translation>ábralo como límite de parcela o elija otro archivo</translation>
    </message>
    <message>
        <source>open it with a newer Furrow; the file was left as it is</source>
        <translation>ábralo con un Furrow más nuevo; el archivo quedó como estaba</translation>
    </message>
    <message>
        <source>open the field of that plan first, or record longitude and latitude</source>
        <translation>abra antes la parcela de ese plan o grabe longitud y latitud</translation>
    </message>
    <message>
        <source>opennav_coverage goal</source>
        <translation>Objetivo de opennav_coverage</translation>
    </message>
    <message>
        <source>opennav_coverage lays swaths and turns of its own from the goal; they need not be those of this plan.</source>
        <translation>opennav_coverage traza sus propias pasadas y giros; no tienen por qué ser los de este plan.</translation>
    </message>
    <message>
        <source>part %1</source>
        <translation>parte %1</translation>
    </message>
    <message>
        <source>part %1, point %2</source>
        <translation>parte %1, punto %2</translation>
    </message>
    <message>
        <source>path.csv has %1 segments and plan.geojson %2</source>
        <translation>path.csv tiene %1 tramos y plan.geojson %2</translation>
    </message>
    <message>
        <source>per m²</source>
        <translation>por m²</translation>
    </message>
    <message>
        <source>pivot needs its centre</source>
        <translation>los círculos necesitan su centro</translation>
    </message>
    <message>
        <source>plan the field first: furrow-cli plan FIELD --out plan</source>
        <translation>planifique primero la parcela: furrow-cli plan FIELD --out plan</translation>
    </message>
    <message>
        <source>points that are no gates</source>
        <translation>puntos que no son entradas</translation>
    </message>
    <message>
        <source>polygons of a kind that is not used</source>
        <translation>polígonos de un tipo que no se usa</translation>
    </message>
    <message>
        <source>put the EPSG code into its name, as in field_EPSG32632.dxf</source>
        <translation>ponga el código EPSG en su nombre, como field_EPSG32632.dxf</translation>
    </message>
    <message>
        <source>record %1 has a value that its header does not name</source>
        <translation>el registro %1 tiene un valor que su cabecera no nombra</translation>
    </message>
    <message>
        <source>record a position every second, or every few metres</source>
        <translation>grabe una posición cada segundo o cada pocos metros</translation>
    </message>
    <message>
        <source>record or draw its boundary first</source>
        <translation>grabe o dibuje primero su límite</translation>
    </message>
    <message>
        <source>record or export it again</source>
        <translation>grábelo o expórtelo de nuevo</translation>
    </message>
    <message>
        <source>record sensor_msgs/NavSatFix, nav_msgs/Odometry, geometry_msgs/PoseStamped or nav_msgs/Path</source>
        <translation>grabe sensor_msgs/NavSatFix, nav_msgs/Odometry, geometry_msgs/PoseStamped o nav_msgs/Path</translation>
    </message>
    <message>
        <source>record the log again with a receiver that has a fix</source>
        <translation>grabe de nuevo con un receptor que conozca su posición</translation>
    </message>
    <message>
        <source>record the positions without pictures and point clouds</source>
        <translation>grabe las posiciones sin imágenes ni nubes de puntos</translation>
    </message>
    <message>
        <source>record with a correction signal (EGNOS, RTK), or under an open sky</source>
        <translation>grabe con señal de corrección (EGNOS, RTK) o a cielo abierto</translation>
    </message>
    <message>
        <source>record with zstd, lz4 or no compression</source>
        <translation>grabe con zstd, lz4 o sin compresión</translation>
    </message>
    <message>
        <source>remove it from the file, or add its field</source>
        <translation>quítelo del archivo o añada su parcela</translation>
    </message>
    <message>
        <source>remove it; keys look like operating_width_m, vehicle_width_m, can_reverse</source>
        <translation>quítelo; las claves son como operating_width_m, vehicle_width_m, can_reverse</translation>
    </message>
    <message>
        <source>restore a copy of the file</source>
        <translation>recupere una copia del archivo</translation>
    </message>
    <message>
        <source>rings that overlap each other were joined</source>
        <translation>se han unido anillos que se solapan</translation>
    </message>
    <message>
        <source>rings with fewer than three corners</source>
        <translation>anillos con menos de tres esquinas</translation>
    </message>
    <message>
        <source>rows needs a file of lines</source>
        <translation>las hileras necesitan un archivo de líneas</translation>
    </message>
    <message>
        <source>save it again in WGS84</source>
        <translation>guárdela de nuevo en WGS84</translation>
    </message>
    <message>
        <source>save it as GeoTIFF, or with a world file in degrees</source>
        <translation>guárdela como GeoTIFF o con un archivo de georreferencia en grados</translation>
    </message>
    <message>
        <source>save the field again, or remove this file</source>
        <translation>guarde la parcela de nuevo o quite este archivo</translation>
    </message>
    <message>
        <source>save the project, and free some space</source>
        <translation>guarde el proyecto y libere espacio</translation>
    </message>
    <message>
        <source>say how far to keep from it (buffer_m), or draw its outline</source>
        <translation>indique a qué distancia hay que mantenerse (buffer_m), o dibuje su contorno</translation>
    </message>
    <message>
        <source>several fields are called &apos;%1&apos;</source>
        <translation>varias parcelas se llaman «%1»</translation>
    </message>
    <message>
        <source>several plans of &apos;%1&apos; are called &apos;%2&apos;</source>
        <translation>varios planes de «%1» se llaman «%2»</translation>
    </message>
    <message>
        <source>simplify it to at most a million</source>
        <translation>simplifíquelo a un millón como máximo</translation>
    </message>
    <message>
        <source>such as LINESTRING (4.1 52.0, 4.2 52.0)</source>
        <translation>como LINESTRING (4.1 52.0, 4.2 52.0)</translation>
    </message>
    <message>
        <source>such as POINT (4.1 52.0)</source>
        <translation>como POINT (4.1 52.0)</translation>
    </message>
    <message>
        <source>swath %1</source>
        <translation>pasada %1</translation>
    </message>
    <message>
        <source>swath %1 is named twice</source>
        <translation>la pasada %1 se nombra dos veces</translation>
    </message>
    <message>
        <source>take it away</source>
        <translation>quítela</translation>
    </message>
    <message>
        <source>take off its write protection, or use another one</source>
        <translation>quite la protección o use otra</translation>
    </message>
    <message>
        <source>take off the write protection of the stick</source>
        <translation>quite la protección contra escritura de la memoria USB</translation>
    </message>
    <message>
        <source>take the track as driven around the field, or record the work</source>
        <translation>tome el recorrido como vuelta alrededor de la parcela o grabe el trabajo</translation>
    </message>
    <message>
        <source>the .shx file that belongs to it is missing</source>
        <translation>falta el archivo .shx correspondiente</translation>
    </message>
    <message>
        <source>the GPX file is damaged (%1)</source>
        <translation>el archivo GPX está dañado (%1)</translation>
    </message>
    <message>
        <source>the GPX file is larger than 256 MiB</source>
        <translation>el archivo GPX supera los 256 MiB</translation>
    </message>
    <message>
        <source>the boundary</source>
        <translation>el límite de parcela</translation>
    </message>
    <message>
        <source>the boundary has %1 points</source>
        <translation>el límite tiene %1 puntos</translation>
    </message>
    <message>
        <source>the boundary has no such edge</source>
        <translation>el límite no tiene ese lado</translation>
    </message>
    <message>
        <source>the boundary is that of the guidance group; the field itself has none</source>
        <translation>el límite es el del grupo de guiado; la parcela misma no tiene</translation>
    </message>
    <message>
        <source>the coordinate system that it names is not known</source>
        <translation>el sistema de coordenadas que nombra no se conoce</translation>
    </message>
    <message>
        <source>the coordinates lie outside longitude -180 to 180 and latitude -90 to 90</source>
        <translation>las coordenadas quedan fuera de longitud -180 a 180 y latitud -90 a 90</translation>
    </message>
    <message>
        <source>the curve bends more sharply than this machine can follow (%1 of radius)</source>
        <translation>la curva es más cerrada de lo que puede seguir esta máquina (%1 de radio)</translation>
    </message>
    <message>
        <source>the curve crosses itself, %1 from its start</source>
        <translation>la curva se cruza a sí misma, a %1 de su comienzo</translation>
    </message>
    <message>
        <source>the curves from line %1 on are left out: it is damaged</source>
        <translation>se omiten las curvas a partir de la línea %1: está dañada</translation>
    </message>
    <message>
        <source>the edge cannot lie that far from the line</source>
        <translation>el borde no puede estar tan lejos de la línea</translation>
    </message>
    <message>
        <source>the end</source>
        <translation>final</translation>
    </message>
    <message>
        <source>the field &apos;%1&apos; has no boundary</source>
        <translation>la parcela «%1» no tiene límite</translation>
    </message>
    <message>
        <source>the field &apos;%1&apos; has no plan &apos;%2&apos;</source>
        <translation>la parcela «%1» no tiene un plan «%2»</translation>
    </message>
    <message>
        <source>the field &apos;%1&apos; is left out: %2</source>
        <translation>se omite la parcela «%1»: %2</translation>
    </message>
    <message>
        <source>the field has neither boundary nor guidance line</source>
        <translation>la parcela no tiene ni límite ni línea de guiado</translation>
    </message>
    <message>
        <source>the field has no boundary</source>
        <translation>la parcela no tiene límite</translation>
    </message>
    <message>
        <source>the field is more than 100 km across; %1 is farthest from the others</source>
        <translation>la parcela mide más de 100 km; %1 es lo más alejado del resto</translation>
    </message>
    <message>
        <source>the field is nowhere as wide as the machine (%1%2)</source>
        <translation>la parcela no es en ningún sitio tan ancha como la máquina (%1%2)</translation>
    </message>
    <message>
        <source>the fields in this task data have neither boundary nor guidance line</source>
        <translation>las parcelas de estos datos no tienen ni límite ni línea de guiado</translation>
    </message>
    <message>
        <source>the file cannot be read</source>
        <translation>no se puede leer el archivo</translation>
    </message>
    <message>
        <source>the file has %1 fields: %2</source>
        <translation>el archivo tiene %1 parcelas: %2</translation>
    </message>
    <message>
        <source>the file is damaged</source>
        <translation>el archivo está dañado</translation>
    </message>
    <message>
        <source>the file is damaged (%1)</source>
        <translation>el archivo está dañado (%1)</translation>
    </message>
    <message>
        <source>the file is damaged here</source>
        <translation>el archivo está dañado aquí</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>el archivo está vacío</translation>
    </message>
    <message>
        <source>the file is empty or cannot be read</source>
        <translation>el archivo está vacío o no se puede leer</translation>
    </message>
    <message>
        <source>the file is larger than 1 GiB</source>
        <translation>el archivo es mayor de 1 GiB</translation>
    </message>
    <message>
        <source>the file may be cut off or damaged; copy or export it again</source>
        <translation>el archivo puede estar cortado o dañado; cópielo o expórtelo de nuevo</translation>
    </message>
    <message>
        <source>the file may be cut off or damaged; export it again</source>
        <translation>el archivo puede estar cortado o dañado; expórtelo de nuevo</translation>
    </message>
    <message>
        <source>the folder or zip cannot be read</source>
        <translation>no se puede leer la carpeta o el zip</translation>
    </message>
    <message>
        <source>the gap is out of range</source>
        <translation>el hueco está fuera de rango</translation>
    </message>
    <message>
        <source>the headland is left out: line %1 is damaged</source>
        <translation>se omite la cabecera: la línea %1 está dañada</translation>
    </message>
    <message>
        <source>the headland of edge %1</source>
        <translation>la cabecera del lado %1</translation>
    </message>
    <message>
        <source>the implement was nowhere down on this track</source>
        <translation>el apero no estuvo bajado en ningún punto de este recorrido</translation>
    </message>
    <message>
        <source>the log is cut off in record %1</source>
        <translation>el registro está cortado en la entrada %1</translation>
    </message>
    <message>
        <source>the operating width is out of range</source>
        <translation>el ancho de trabajo está fuera de rango</translation>
    </message>
    <message>
        <source>the overhang of edge %1</source>
        <translation>el voladizo del lado %1</translation>
    </message>
    <message>
        <source>edge %1</source>
        <translation>lado %1</translation>
    </message>
    <message>
        <source>the key is there twice</source>
        <translation>la clave está dos veces</translation>
    </message>
    <message>
        <source>the line after StartFix is no place</source>
        <translation>la línea tras StartFix no es una posición</translation>
    </message>
    <message>
        <source>the line crosses itself at %1</source>
        <translation>la línea se cruza a sí misma en %1</translation>
    </message>
    <message>
        <source>the line touches or crosses itself by a sliver; taken apart there</source>
        <translation>la línea se toca o se cruza por muy poco; se ha separado ahí</translation>
    </message>
    <message>
        <source>the lines from line %1 on are left out: it is damaged</source>
        <translation>se omiten las líneas a partir de la línea %1: está dañada</translation>
    </message>
    <message>
        <source>the machine (%1 wide, %2 long%3) fits nowhere into the field</source>
        <translation>la máquina (%1 de ancho, %2 de largo%3) no cabe en ningún sitio de la parcela</translation>
    </message>
    <message>
        <source>the name of a gate or a point in WGS84 such as POINT (4.1 52.0)</source>
        <translation>el nombre de una entrada o un punto en WGS84 como POINT (4.1 52.0)</translation>
    </message>
    <message>
        <source>the number after SRID= is no coordinate system that is known</source>
        <translation>el número tras SRID= no es un sistema de coordenadas conocido</translation>
    </message>
    <message>
        <source>the obstacles leave nothing of the field</source>
        <translation>los obstáculos no dejan nada de la parcela</translation>
    </message>
    <message>
        <source>the operating width is missing</source>
        <translation>falta el ancho de trabajo</translation>
    </message>
    <message>
        <source>the part %1 is left out: %2</source>
        <translation>se omite la parte %1: %2</translation>
    </message>
    <message>
        <source>the path of a file</source>
        <translation>la ruta de un archivo</translation>
    </message>
    <message>
        <source>the picture cannot be read (%1)</source>
        <translation>no se puede leer la imagen (%1)</translation>
    </message>
    <message>
        <source>the picture does not say where it lies</source>
        <translation>la imagen no dice dónde está</translation>
    </message>
    <message>
        <source>the picture does not say which coordinate system it uses</source>
        <translation>la imagen no dice qué sistema de coordenadas usa</translation>
    </message>
    <message>
        <source>the picture is damaged</source>
        <translation>la imagen está dañada</translation>
    </message>
    <message>
        <source>the place lies outside of the field</source>
        <translation>el lugar queda fuera de la parcela</translation>
    </message>
    <message>
        <source>the plan gives no reason</source>
        <translation>el plan no dice por qué</translation>
    </message>
    <message>
        <source>the positions of this track are metres in the plan that was driven, not places on Earth</source>
        <translation>las posiciones de este recorrido son metros en el plan que se siguió, no lugares de la Tierra</translation>
    </message>
    <message>
        <source>the recorded path is left out: it is damaged</source>
        <translation>se omite el recorrido grabado: está dañado</translation>
    </message>
    <message>
        <source>the recording cannot be made: %1</source>
        <translation>no se puede crear la grabación: %1</translation>
    </message>
    <message>
        <source>the recording is cut off in the middle of a record</source>
        <translation>la grabación está cortada en medio de un registro</translation>
    </message>
    <message>
        <source>the recording is cut off: its end is missing</source>
        <translation>la grabación está cortada: falta el final</translation>
    </message>
    <message>
        <source>the sample field cannot be read</source>
        <translation>no se puede leer la parcela de ejemplo</translation>
    </message>
    <message>
        <source>the shape could not be computed with (%1)</source>
        <translation>no se pudo calcular con la forma (%1)</translation>
    </message>
    <message>
        <source>the start</source>
        <translation>inicio</translation>
    </message>
    <message>
        <source>the stick does not answer any more (%1)</source>
        <translation>la memoria USB ya no responde (%1)</translation>
    </message>
    <message>
        <source>the stick has %1 MB free, and %2 MB are needed</source>
        <translation>la memoria USB tiene %1 MB libres y hacen falta %2 MB</translation>
    </message>
    <message>
        <source>the stick is damaged: use another one</source>
        <translation>la memoria USB está dañada: use otra</translation>
    </message>
    <message>
        <source>the stick is write-protected</source>
        <translation>la memoria USB está protegida contra escritura</translation>
    </message>
    <message>
        <source>the strips of this track lie nowhere beside each other</source>
        <translation>las franjas de este recorrido no están en ningún punto una junto a otra</translation>
    </message>
    <message>
        <source>the swaths are left out: %1</source>
        <translation>se omiten las pasadas: %1</translation>
    </message>
    <message>
        <source>the table has neither a column WKT nor columns lon and lat</source>
        <translation>la tabla no tiene ni columna WKT ni columnas lon y lat</translation>
    </message>
    <message>
        <source>the track does not come to the plan anywhere</source>
        <translation>el recorrido no llega al plan en ningún punto</translation>
    </message>
    <message>
        <source>the track goes around nothing: from its end to its beginning %1 are missing</source>
        <translation>el recorrido no rodea nada: faltan %1 desde su final hasta su comienzo</translation>
    </message>
    <message numerus="yes">
        <source>the track has %n positions only</source>
        <translation>
            <numerusform>el recorrido solo tiene %n posición</numerusform>
            <numerusform>el recorrido solo tiene %n posiciones</numerusform>
        </translation>
    </message>
    <message>
        <source>the transfer after %1</source>
        <translation>el trayecto tras %1</translation>
    </message>
    <message>
        <source>the transfer at %1</source>
        <translation>el trayecto en %1</translation>
    </message>
    <message>
        <source>the turn after %1</source>
        <translation>el giro tras %1</translation>
    </message>
    <message>
        <source>the turn at %1</source>
        <translation>el giro en %1</translation>
    </message>
    <message>
        <source>the way to refill</source>
        <translation>el trayecto para recargar</translation>
    </message>
    <message>
        <source>the zip cannot be made: %1</source>
        <translation>no se puede crear el zip: %1</translation>
    </message>
    <message>
        <source>there is no &apos;%1&apos;</source>
        <translation>no hay «%1»</translation>
    </message>
    <message>
        <source>there is no &apos;%1&apos; in a machine</source>
        <translation>en una máquina no hay «%1»</translation>
    </message>
    <message>
        <source>there is no Field.txt</source>
        <translation>falta Field.txt</translation>
    </message>
    <message>
        <source>there is no boundary</source>
        <translation>no hay límite de parcela</translation>
    </message>
    <message>
        <source>there is no boundary file in this zip</source>
        <translation>en este zip no hay ningún archivo de límites</translation>
    </message>
    <message>
        <source>there is no edge %1</source>
        <translation>no hay ningún lado %1</translation>
    </message>
    <message>
        <source>there is no field &apos;%1&apos; in the file</source>
        <translation>no hay ninguna parcela «%1» en el archivo</translation>
    </message>
    <message>
        <source>there is no field &apos;%1&apos; in the project</source>
        <translation>no hay ninguna parcela «%1» en el proyecto</translation>
    </message>
    <message>
        <source>there is no field boundary in it</source>
        <translation>no contiene ningún límite de parcela</translation>
    </message>
    <message>
        <source>there is no field boundary in it, only %1</source>
        <translation>no contiene ningún límite de parcela, solo %1</translation>
    </message>
    <message>
        <source>there is no field in this project</source>
        <translation>no hay ninguna parcela en este proyecto</translation>
    </message>
    <message>
        <source>there is no field in this task data</source>
        <translation>no hay ninguna parcela en estos datos</translation>
    </message>
    <message>
        <source>there is no gate &apos;%1&apos;</source>
        <translation>no hay ninguna entrada «%1»</translation>
    </message>
    <message>
        <source>there is no line in it</source>
        <translation>no contiene ninguna línea</translation>
    </message>
    <message>
        <source>there is no machine &apos;%1&apos;</source>
        <translation>no hay ninguna máquina «%1»</translation>
    </message>
    <message>
        <source>there is no path in it</source>
        <translation>no contiene ningún recorrido</translation>
    </message>
    <message>
        <source>there is no project format %1</source>
        <translation>no hay ningún formato de proyecto %1</translation>
    </message>
    <message>
        <source>there is no recorded track in it</source>
        <translation>no contiene ningún recorrido grabado</translation>
    </message>
    <message>
        <source>there is no setting &apos;%1&apos;</source>
        <translation>no hay ningún ajuste «%1»</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>no existe ese archivo</translation>
    </message>
    <message>
        <source>there is no swath %1</source>
        <translation>no hay ninguna pasada %1</translation>
    </message>
    <message>
        <source>there is no terminal &apos;%1&apos;</source>
        <translation>no hay ningún terminal «%1»</translation>
    </message>
    <message>
        <source>there is no track in this GPX file</source>
        <translation>no hay ningún recorrido en este archivo GPX</translation>
    </message>
    <message>
        <source>this XML file is cut off</source>
        <translation>este archivo XML está cortado</translation>
    </message>
    <message>
        <source>this XML is no task data</source>
        <translation>este XML no son datos de tarea</translation>
    </message>
    <message>
        <source>this folder holds no TASKDATA.XML, no field of AgOpenGPS and no AgGPS boundary</source>
        <translation>esta carpeta no contiene TASKDATA.XML, ni parcela de AgOpenGPS, ni límite AgGPS</translation>
    </message>
    <message>
        <source>this format holds the path of a plan, and there is only a field</source>
        <translation>este formato contiene el recorrido de un plan, y solo hay una parcela</translation>
    </message>
    <message>
        <source>this is a bag of ROS 1</source>
        <translation>es un bag de ROS 1</translation>
    </message>
    <message>
        <source>this is a folder</source>
        <translation>esto es una carpeta</translation>
    </message>
    <message>
        <source>this is no MCAP file of version 0</source>
        <translation>no es un archivo MCAP de la versión 0</translation>
    </message>
    <message>
        <source>this is no boundary file that can be read</source>
        <translation>no es un archivo de límites que se pueda leer</translation>
    </message>
    <message>
        <source>this is no header of a time log</source>
        <translation>no es la cabecera de un registro de tiempo</translation>
    </message>
    <message>
        <source>this is no ordinary file</source>
        <translation>no es un archivo normal</translation>
    </message>
    <message>
        <source>this is no track that can be read</source>
        <translation>no es un recorrido legible</translation>
    </message>
    <message>
        <source>this is no zip of fields or recordings</source>
        <translation>no es un zip de parcelas o grabaciones</translation>
    </message>
    <message>
        <source>this is not JSON from here on</source>
        <translation>a partir de aquí no es JSON</translation>
    </message>
    <message>
        <source>this is not XML from here on</source>
        <translation>a partir de aquí no es XML</translation>
    </message>
    <message>
        <source>this is not a project of Furrow</source>
        <translation>no es un proyecto de Furrow</translation>
    </message>
    <message>
        <source>this is not well-known text from here on</source>
        <translation>a partir de aquí no es well-known text</translation>
    </message>
    <message>
        <source>this place</source>
        <translation>este lugar</translation>
    </message>
    <message>
        <source>this polygon cannot be read</source>
        <translation>no se puede leer este polígono</translation>
    </message>
    <message>
        <source>this project file is damaged: %1</source>
        <translation>este archivo de proyecto está dañado: %1</translation>
    </message>
    <message>
        <source>this project is open in another window of Furrow</source>
        <translation>este proyecto está abierto en otra ventana de Furrow</translation>
    </message>
    <message>
        <source>this project was saved by a newer Furrow (format %1, this one knows %2)</source>
        <translation>este proyecto lo guardó un Furrow más nuevo (formato %1, este conoce %2)</translation>
    </message>
    <message>
        <source>topic %1 was left out for %2</source>
        <translation>el topic %1 se ha omitido en favor de %2</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true o false</translation>
    </message>
    <message>
        <source>try another stick</source>
        <translation>pruebe otra memoria USB</translation>
    </message>
    <message>
        <source>turn it into a rosbag2 with rosbags-convert</source>
        <translation>conviértalo en un rosbag2 con rosbags-convert</translation>
    </message>
    <message>
        <source>two points</source>
        <translation>dos puntos</translation>
    </message>
    <message>
        <source>use another terminal&apos;s format, and report this</source>
        <translation>use el formato de otro terminal y comuníquelo</translation>
    </message>
    <message>
        <source>use one of: %1</source>
        <translation>use uno de: %1</translation>
    </message>
    <message>
        <source>use one of: %1; or give a machine file (.json)</source>
        <translation>use una de: %1; o indique un archivo de máquina (.json)</translation>
    </message>
    <message>
        <source>use one or more of: %1</source>
        <translation>use uno o varios de: %1</translation>
    </message>
    <message>
        <source>use the numbers from 1 to %1</source>
        <translation>use los números del 1 al %1</translation>
    </message>
    <message>
        <source>was it pulled out? Plug it in again and write once more</source>
        <translation>¿se ha desconectado? Conéctela de nuevo y escriba otra vez</translation>
    </message>
    <message>
        <source>what is on the stick is not the plan: %1</source>
        <translation>lo que hay en la memoria USB no es el plan: %1</translation>
    </message>
    <message>
        <source>whole numbers divided by commas</source>
        <translation>números enteros separados por comas</translation>
    </message>
    <message>
        <source>worked pixels need a value other than 0</source>
        <translation>los píxeles trabajados necesitan un valor distinto de 0</translation>
    </message>
    <message>
        <source>write POLYGON((lon lat, lon lat, ...))</source>
        <translation>escriba POLYGON((lon lat, lon lat, ...))</translation>
    </message>
    <message>
        <source>write POLYGON((lon lat, lon lat, ...)), one polygon a line</source>
        <translation>escriba POLYGON((lon lat, lon lat, ...)), un polígono por línea</translation>
    </message>
    <message>
        <source>write it like LINESTRING (4.1 52.0, 4.2 52.0)</source>
        <translation>escríbalo como LINESTRING (4.1 52.0, 4.2 52.0)</translation>
    </message>
    <message>
        <source>write the plan again with furrow-cli plan</source>
        <translation>escriba el plan de nuevo con furrow-cli plan</translation>
    </message>
    <message>
        <source>write {&quot;name&quot;: ..., &quot;operating_width_m&quot;: ...}</source>
        <translation>escriba {&quot;name&quot;: ..., &quot;operating_width_m&quot;: ...}</translation>
    </message>
    <message>
        <source>a part of it cannot be read</source>
        <translation>una parte no se puede leer</translation>
    </message>
    <message>
        <source>a part of it is damaged: %1</source>
        <translation>una parte está dañada: %1</translation>
    </message>
    <message>
        <source>a tile is damaged</source>
        <translation>una tesela está dañada</translation>
    </message>
    <message>
        <source>choose a file or a folder of tiles</source>
        <translation>elija un archivo o una carpeta de teselas</translation>
    </message>
    <message>
        <source>choose the folder that holds the folders of the zooms, 0 to 24</source>
        <translation>elija la carpeta que contiene las carpetas de los niveles de zoom, de 0 a 24</translation>
    </message>
    <message>
        <source>copy or export the file again</source>
        <translation>copie o exporte el archivo de nuevo</translation>
    </message>
    <message>
        <source>give a GeoTIFF, MBTiles, or a folder of tiles</source>
        <translation>indique un GeoTIFF, MBTiles o una carpeta de teselas</translation>
    </message>
    <message>
        <source>give a GeoTIFF, or export it again with its coordinate system</source>
        <translation>indique un GeoTIFF o expórtela de nuevo con su sistema de coordenadas</translation>
    </message>
    <message>
        <source>it is damaged, or not a picture that Furrow can show</source>
        <translation>está dañado o no es una imagen que Furrow pueda mostrar</translation>
    </message>
    <message>
        <source>it is no file</source>
        <translation>no es un archivo</translation>
    </message>
    <message>
        <source>it is too large to be shown without overviews</source>
        <translation>es demasiado grande para mostrarla sin vistas generales</translation>
    </message>
    <message>
        <source>its tiles are in degrees, not in web Mercator</source>
        <translation>sus teselas están en grados, no en Web Mercator</translation>
    </message>
    <message>
        <source>make the tiles again</source>
        <translation>cree las teselas de nuevo</translation>
    </message>
    <message>
        <source>make them again with the profile mercator, or give the raster itself</source>
        <translation>créelas de nuevo con el perfil mercator o indique el ráster mismo</translation>
    </message>
    <message>
        <source>open it again</source>
        <translation>ábralo de nuevo</translation>
    </message>
    <message>
        <source>put it back, or choose another one</source>
        <translation>vuelva a ponerlo o elija otro</translation>
    </message>
    <message>
        <source>put it back, or remove the layer</source>
        <translation>vuelva a ponerlo o quite la capa</translation>
    </message>
    <message>
        <source>save it in tiles and with overviews (gdal_translate -of COG)</source>
        <translation>guárdela en teselas y con vistas generales (gdal_translate -of COG)</translation>
    </message>
    <message>
        <source>the file cannot be read any more</source>
        <translation>el archivo ya no se puede leer</translation>
    </message>
    <message>
        <source>the file is not there any more</source>
        <translation>el archivo ya no está</translation>
    </message>
    <message>
        <source>the file was changed while it was open</source>
        <translation>el archivo se modificó mientras estaba abierto</translation>
    </message>
    <message>
        <source>the folder is not there any more</source>
        <translation>la carpeta ya no está</translation>
    </message>
    <message>
        <source>there are no tiles in this folder</source>
        <translation>no hay teselas en esta carpeta</translation>
    </message>
    <message>
        <source>there is no picture in it</source>
        <translation>no contiene ninguna imagen</translation>
    </message>
    <message>
        <source>there is no such file or folder</source>
        <translation>no existe ese archivo o esa carpeta</translation>
    </message>
    <message>
        <source>Receivers may refuse %1: %2.</source>
        <translation>Es posible que los terminales rechacen %1: %2.</translation>
    </message>
    <message>
        <source>some systems do not allow a file of this name</source>
        <translation>algunos sistemas no permiten un archivo con este nombre</translation>
    </message>
    <message>
        <source>another file differs from it in capitals only</source>
        <translation>otro archivo solo se diferencia de él en las mayúsculas</translation>
    </message>
    <message>
        <source>%1 is far from the field</source>
        <translation>%1 está lejos de la parcela</translation>
    </message>
    <message>
        <source>a ring of &apos;%1&apos; has fewer than three corners</source>
        <translation>un anillo de «%1» tiene menos de tres esquinas</translation>
    </message>
    <message>
        <source>a ring of &apos;%1&apos; does not end where it begins</source>
        <translation>un anillo de «%1» no termina donde empieza</translation>
    </message>
    <message>
        <source>a ring of &apos;%1&apos; ends with its first point again</source>
        <translation>un anillo de «%1» repite al final su primer punto</translation>
    </message>
    <message>
        <source>&apos;%1&apos; crosses itself, or a hole lies outside of it</source>
        <translation>«%1» se cruza consigo mismo o tiene un hueco fuera de él</translation>
    </message>
    <message>
        <source>a ring of &apos;%1&apos; runs the wrong way round</source>
        <translation>un anillo de «%1» gira en el sentido equivocado</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is said to have %2, and has %3</source>
        <translation>«%1» debería tener %2 y tiene %3</translation>
    </message>
    <message>
        <source>the name &apos;%1&apos; is longer than %2 characters</source>
        <translation>el nombre «%1» tiene más de %2 caracteres</translation>
    </message>
    <message>
        <source>the name &apos;%1&apos; is there twice</source>
        <translation>el nombre «%1» está dos veces</translation>
    </message>
    <message>
        <source>the name &apos;%1&apos; has letters beyond A to Z</source>
        <translation>el nombre «%1» tiene letras que no van de la A a la Z</translation>
    </message>
    <message>
        <source>the name &apos;%1&apos; has characters that are no letters</source>
        <translation>el nombre «%1» tiene caracteres que no son letras</translation>
    </message>
    <message>
        <source>the line &apos;%1&apos; has fewer than two points</source>
        <translation>la línea «%1» tiene menos de dos puntos</translation>
    </message>
    <message>
        <source>A and B of &apos;%1&apos; are the same place</source>
        <translation>A y B de «%1» son el mismo lugar</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is said to be %2 wide</source>
        <translation>«%1» tendría %2 de ancho</translation>
    </message>
    <message>
        <source>%1 comes where %2 should</source>
        <translation>%1 está donde debería estar %2</translation>
    </message>
    <message>
        <source>%1 boundaries are in it, not %2</source>
        <translation>contiene %1 límites, no %2</translation>
    </message>
    <message>
        <source>%1 holes are in it, not %2</source>
        <translation>contiene %1 huecos, no %2</translation>
    </message>
    <message>
        <source>%1 guidance lines are in it, not %2</source>
        <translation>contiene %1 líneas de guiado, no %2</translation>
    </message>
    <message>
        <source>%1 swaths are in it, not %2</source>
        <translation>contiene %1 pasadas, no %2</translation>
    </message>
    <message>
        <source>%1 fields are in it, not %2</source>
        <translation>contiene %1 parcelas, no %2</translation>
    </message>
    <message>
        <source>the path is not in it</source>
        <translation>no contiene el recorrido</translation>
    </message>
    <message>
        <source>place %1 of the path is not where the plan goes next</source>
        <translation>el punto %1 del recorrido no está donde sigue el plan</translation>
    </message>
    <message>
        <source>the path does not begin and end as the plan does</source>
        <translation>el recorrido no empieza y termina como el plan</translation>
    </message>
    <message>
        <source>the path is %1 long, not %2</source>
        <translation>el recorrido mide %1, no %2</translation>
    </message>
    <message>
        <source>the time of place %1 of the path is before that of the place before</source>
        <translation>la hora del punto %1 del recorrido es anterior a la del punto previo</translation>
    </message>
    <message>
        <source>the times of the path stand still</source>
        <translation>las horas del recorrido no avanzan</translation>
    </message>
    <message>
        <source>the heading at place %1 of the path does not point along it</source>
        <translation>el rumbo en el punto %1 del recorrido no apunta a lo largo de él</translation>
    </message>
    <message>
        <source>the speed at place %1 of the path is negative</source>
        <translation>la velocidad en el punto %1 del recorrido es negativa</translation>
    </message>
    <message>
        <source>its largest speed is %1, not %2</source>
        <translation>su mayor velocidad es %1, no %2</translation>
    </message>
    <message>
        <source>line %1 is not as this format has it</source>
        <translation>la línea %1 no es conforme a este formato</translation>
    </message>
    <message>
        <source>this is no %1</source>
        <translation>esto no es %1</translation>
    </message>
    <message>
        <source>its content cannot be read</source>
        <translation>no se puede leer su contenido</translation>
    </message>
    <message>
        <source>%1 is missing</source>
        <translation>falta %1</translation>
    </message>
    <message>
        <source>%1 entries are announced, and %2 are there</source>
        <translation>se anuncian %1 entradas y hay %2</translation>
    </message>
    <message>
        <source>the id %1 is there twice</source>
        <translation>el identificador %1 está dos veces</translation>
    </message>
    <message>
        <source>%1 is referred to and not there</source>
        <translation>se hace referencia a %1 y no está</translation>
    </message>
    <message>
        <source>%1 is not known before version 4</source>
        <translation>%1 no se conoce antes de la versión 4</translation>
    </message>
    <message>
        <source>&apos;%1&apos; holds a line of kind %2</source>
        <translation>«%1» contiene una línea de tipo %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is of kind %2 and its points are of kinds %3</source>
        <translation>«%1» es de tipo %2 y sus puntos son de los tipos %3</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has %2 lines</source>
        <translation>«%1» tiene %2 líneas</translation>
    </message>
    <message>
        <source>the headings of a ring do not point along it</source>
        <translation>los rumbos de un anillo no apuntan a lo largo de él</translation>
    </message>
    <message>
        <source>its shapes have heights or measures, which displays do not read</source>
        <translation>sus formas tienen alturas o medidas, que los terminales no leen</translation>
    </message>
    <message>
        <source>this is the recording of a drive (%1), and no boundary</source>
        <translation>esto es la grabación de un recorrido (%1), no un límite</translation>
    </message>
    <message>
        <source>give the field&apos;s boundary; furrow-cli compare lays a recording over a plan</source>
        <translation>indique el límite de la parcela; furrow-cli compare superpone una grabación a un plan</translation>
    </message>
    <message>
        <source>Raster mask</source>
        <translation>Máscara ráster</translation>
    </message>
    <message>
        <source>What is worked and what is not, as a field.</source>
        <translation>Lo que se trabaja y lo que no, como parcela.</translation>
    </message>
    <message>
        <source>NMEA or gpsd log</source>
        <translation>Registro NMEA o gpsd</translation>
    </message>
    <message>
        <source>What a machine drove.</source>
        <translation>Lo que recorrió una máquina.</translation>
    </message>
    <message>
        <source>split line %1 ends %2 short of the headland and cuts nothing off there (decomposition.split); draw it right through</source>
        <translation>la línea de división %1 termina %2 antes de la cabecera y ahí no separa nada (decomposition.split); trácela de lado a lado</translation>
    </message>
    <message>
        <source>split line %1 does not lie inside the headland and cuts nothing (decomposition.split)</source>
        <translation>la línea de división %1 queda fuera del interior y no divide nada (decomposition.split)</translation>
    </message>
    <message numerus="yes">
        <source>%n swaths shorter than %1 are left out</source>
        <translation>
            <numerusform>se omite %n pasada de menos de %1</numerusform>
            <numerusform>se omiten %n pasadas de menos de %1</numerusform>
        </translation>
    </message>
    <message>
        <source>along the longest edge</source>
        <translation>a lo largo del lado más largo</translation>
    </message>
    <message>
        <source>along an edge</source>
        <translation>a lo largo de un lado</translation>
    </message>
    <message>
        <source>swaths run %1</source>
        <translation>las pasadas van %1</translation>
    </message>
    <message>
        <source>swaths run %1; about %2 slower than with the best heading</source>
        <translation>las pasadas van %1; unos %2 más que con la mejor dirección</translation>
    </message>
    <message>
        <source>swaths run %1; as quick as with the best heading</source>
        <translation>las pasadas van %1; tan rápido como con la mejor dirección</translation>
    </message>
    <message>
        <source>swaths run %1; %2 more than with the best heading</source>
        <translation>las pasadas van %1; %2 más que con la mejor dirección</translation>
    </message>
    <message>
        <source>swaths run %1; as short as with the best heading</source>
        <translation>las pasadas van %1; tan corto como con la mejor dirección</translation>
    </message>
    <message>
        <source>Shortest swath</source>
        <translation>Pasada más corta</translation>
    </message>
    <message>
        <source>Swaths that are shorter are left out; auto is the implement&apos;s length.</source>
        <translation>Las pasadas más cortas se omiten; auto es la longitud del apero.</translation>
    </message>
    <message>
        <source>Prefer edges within (%)</source>
        <translation>Preferir lados hasta (%)</translation>
    </message>
    <message>
        <source>Swaths run along the field&apos;s longest edge, or another long one, where that takes no more than this above the best heading; 0 takes the best whatever its direction.</source>
        <translation>Las pasadas siguen el lado más largo de la parcela, u otro lado largo, mientras no cueste más que esto por encima de la mejor dirección; 0 toma la mejor, sea cual sea.</translation>
    </message>
    <message>
        <source>%1 are out of this machine&apos;s reach; the largest piece, %2, lies here.</source>
        <translation>%1 quedan fuera del alcance de esta máquina; el trozo más grande, %2, está aquí.</translation>
    </message>
    <message>
        <source>The implement stands over the edge of the field or an obstacle, by up to %1, as the overhang allows.</source>
        <translation>El apero sobresale de la parcela o sobre un obstáculo, hasta %1, como permite el voladizo.</translation>
    </message>
    <message>
        <source>%1 within %2 of the centre: tighter than this machine can follow, left out</source>
        <translation>%1 a menos de %2 del centro: más cerrados de lo que esta máquina puede seguir, omitidos</translation>
    </message>
    <message numerus="yes">
        <source>%n circles</source>
        <translation>
            <numerusform>%n círculo</numerusform>
            <numerusform>%n círculos</numerusform>
        </translation>
    </message>
    <message>
        <source>A headland of %1 holds %2; it is %3 wide, and the rest belongs to the swaths</source>
        <translation>En una cabecera de %1 caben %2; tiene %3 de ancho y el resto es de las pasadas</translation>
    </message>
    <message>
        <source>Plan the sides of the obstacle apart.</source>
        <translation>Planifique por separado los lados del obstáculo.</translation>
    </message>
    <message>
        <source>Set &quot;%1&quot; to &quot;%2&quot;: with that this is gone.</source>
        <translation>Ponga «%1» en «%2»: con eso queda resuelto.</translation>
    </message>
    <message>
        <source>Swaths along the longest edge</source>
        <translation>Las pasadas a lo largo del lado más largo</translation>
    </message>
    <message>
        <source>Swaths at a bearing of %1</source>
        <translation>Las pasadas con rumbo %1</translation>
    </message>
    <message>
        <source>Take a machine that can.</source>
        <translation>Elija una máquina que pueda.</translation>
    </message>
    <message>
        <source>The field is too narrow for this machine to turn in: take a smaller machine.</source>
        <translation>La parcela es demasiado estrecha para girar con esta máquina: elija una más pequeña.</translation>
    </message>
    <message>
        <source>The quickest</source>
        <translation>El más rápido</translation>
    </message>
    <message>
        <source>give one of the two, or a width that holds just these passes</source>
        <translation>indique uno de los dos, o un ancho en el que quepan justo estas pasadas</translation>
    </message>
    <message>
        <source>headland.width_m and headland.passes do not agree</source>
        <translation>headland.width_m y headland.passes no concuerdan</translation>
    </message>
    <message>
        <source>off</source>
        <translation>desactivado</translation>
    </message>
    <message>
        <source>on</source>
        <translation>activado</translation>
    </message>
    <message>
        <source>&quot;%1&quot;: &quot;%2&quot; is planned instead of &quot;%3&quot;: %4</source>
        <translation>«%1»: se planifica «%2» en lugar de «%3»: %4</translation>
    </message>
    <message>
        <source>%1 are planned instead of the heading with the best estimate: %2</source>
        <translation>%1 se planifican en lugar de la dirección con la mejor estimación: %2</translation>
    </message>
    <message>
        <source>it has fewer problems</source>
        <translation>hay menos problemas</translation>
    </message>
    <message>
        <source>it is %1 quicker</source>
        <translation>es %1 más rápido</translation>
    </message>
    <message>
        <source>the margin and the obstacles that may be driven on leave nothing to work</source>
        <translation>el margen y los obstáculos transitables no dejan nada que trabajar</translation>
    </message>
    <message>
        <source>make them smaller, or delete some of them</source>
        <translation>hágalos más pequeños o elimine algunos</translation>
    </message>
    <message>
        <source>Without a headland (%1) there is no room to turn.</source>
        <translation>Sin cabecera (%1) no hay sitio para girar.</translation>
    </message>
    <message>
        <source>A turn of this machine needs %1 of headland; it is %2 (%3).</source>
        <translation>Un giro de esta máquina necesita %1 de cabecera; tiene %2 (%3).</translation>
    </message>
    <message>
        <source>The field is too narrow for this machine to turn in: take a smaller machine, or let the swaths run along the field (%1).</source>
        <translation>La parcela es demasiado estrecha para girar con esta máquina: elija una más pequeña, o trace las pasadas a lo largo de la parcela (%1).</translation>
    </message>
    <message>
        <source>The field is too narrow for this machine to turn in: take a smaller machine or a smaller margin (%1).</source>
        <translation>La parcela es demasiado estrecha para girar con esta máquina: elija una más pequeña o un margen menor (%1).</translation>
    </message>
    <message>
        <source>No passes are driven in the headland (%1).</source>
        <translation>No se hacen pasadas en la cabecera (%1).</translation>
    </message>
    <message>
        <source>The chosen swaths (%1) do not reach it.</source>
        <translation>Las pasadas elegidas (%1) no llegan hasta allí.</translation>
    </message>
    <message>
        <source>Land that is left is not finished if the machine may leave the field (%1).</source>
        <translation>Donde la máquina puede salir de la parcela (%1), no se repasa lo que queda.</translation>
    </message>
    <message>
        <source>Land that is left is not finished, because that is switched off (%1).</source>
        <translation>No se repasa lo que queda, porque está desactivado (%1).</translation>
    </message>
    <message>
        <source>choose a smaller machine or a smaller margin (%1)</source>
        <translation>elija una máquina más pequeña o un margen menor (%1)</translation>
    </message>
    <message>
        <source>no row is left inside the headland</source>
        <translation>no queda ninguna hilera en el interior de la parcela</translation>
    </message>
    <message>
        <source>skip fewer rows</source>
        <translation>omita menos hileras</translation>
    </message>
    <message>
        <source>no row lies inside the headland</source>
        <translation>no hay ninguna hilera en el interior de la parcela</translation>
    </message>
    <message>
        <source>check that the rows belong to this field, or choose a narrower headland</source>
        <translation>compruebe que las hileras son de esta parcela, o elija una cabecera más estrecha</translation>
    </message>
    <message>
        <source>Quickest</source>
        <translation>Lo más rápido</translation>
    </message>
    <message>
        <source>The kind below with which the whole plan takes the least time.</source>
        <translation>El tipo con el que el plan entero lleva menos tiempo.</translation>
    </message>
    <message>
        <source>A headland of %1 is planned instead of one that is wide enough for turns: %2</source>
        <translation>Se planifica una cabecera de %1 en lugar de una lo bastante ancha para girar: %2</translation>
    </message>
    <message>
        <source>Drive more slowly there, or plan again.</source>
        <translation>Conduzca más despacio allí o planifique de nuevo.</translation>
    </message>
    <message>
        <source>The steering is too slow for the planned speed in %1; %2 is the worst and would need %3.</source>
        <translation>La dirección es demasiado lenta para la velocidad planificada en %1; lo peor es %2, que necesitaría %3.</translation>
    </message>
    <message>
        <source>The implement is folded on the way from %1 to %2.</source>
        <translation>El apero va plegado en este trayecto: %1 → %2.</translation>
    </message>
    <message>
        <source>The machine has to stand for %1 s to fold its implement or to unfold it, and does not in %2.</source>
        <translation>La máquina debe estar parada %1 s para plegar o desplegar el apero; en %2 no lo está.</translation>
    </message>
    <message>
        <source>Time to fold</source>
        <translation>Tiempo para plegar</translation>
    </message>
    <message>
        <source>To fold to the transport width, standing; the same again to unfold.</source>
        <translation>Para plegar al ancho de transporte, parado; otro tanto para desplegar.</translation>
    </message>
    <message>
        <source>Fuel</source>
        <translation>Combustible</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longitud</translation>
    </message>
    <message>
        <source>Saves</source>
        <translation>Ahorra</translation>
    </message>
    <message>
        <source>The least fuel for turns and ways; the least time if the machine has no fuel figures.</source>
        <translation>El menor combustible para giros y trayectos; el menor tiempo si la máquina no tiene datos de consumo.</translation>
    </message>
    <message>
        <source>The least time for turns and ways.</source>
        <translation>El menor tiempo para giros y trayectos.</translation>
    </message>
    <message>
        <source>The shortest turns and ways.</source>
        <translation>Los giros y trayectos más cortos.</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tiempo</translation>
    </message>
    <message>
        <source>What the order of the swaths is to save.</source>
        <translation>Lo que debe ahorrar el orden de las pasadas.</translation>
    </message>
    <message>
        <source>Every pattern is tried and improved; the plan tells how near the order is to the best one.</source>
        <translation>Se prueban y mejoran todos los patrones; el plan indica lo cerca que está el orden del mejor.</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>Fijas</translation>
    </message>
    <message>
        <source>Swath numbers that follow each other in this order; a minus drives one the other way. The order of the others is searched.</source>
        <translation>Números de pasadas que se siguen en este orden; con un menos se hace al revés. El orden de las demás se busca.</translation>
    </message>
    <message>
        <source>Ends of swaths</source>
        <translation>Extremos de las pasadas</translation>
    </message>
    <message>
        <source>Heading of blocks</source>
        <translation>Dirección de las subparcelas</translation>
    </message>
    <message>
        <source>Heading: bearing %1</source>
        <translation>Dirección: %1</translation>
    </message>
    <message>
        <source>Headland passes</source>
        <translation>Pasadas de cabecera</translation>
    </message>
    <message>
        <source>Order of swaths</source>
        <translation>Orden de las pasadas</translation>
    </message>
    <message>
        <source>Small obstacles</source>
        <translation>Obstáculos pequeños</translation>
    </message>
    <message>
        <source>First swath</source>
        <translation>Primera pasada</translation>
    </message>
    <message>
        <source>Last swath</source>
        <translation>Última pasada</translation>
    </message>
    <message>
        <source>Most strips that are left between driven swaths for later. With 0 the machine never comes back to a gap, so that a second one can follow; auto sets no limit.</source>
        <translation>Máximo de franjas que se dejan para más tarde entre pasadas hechas. Con 0 la máquina nunca vuelve a un hueco, de modo que otra puede seguirla; «auto» no pone límite.</translation>
    </message>
    <message>
        <source>Open strips</source>
        <translation>Franjas abiertas</translation>
    </message>
    <message>
        <source>The number of the swath that is driven first; auto takes any.</source>
        <translation>El número de la pasada que se hace primero; con «auto», cualquiera.</translation>
    </message>
    <message>
        <source>The number of the swath that is driven last; auto takes any.</source>
        <translation>El número de la pasada que se hace al final; con «auto», cualquiera.</translation>
    </message>
    <message>
        <source>allow more open strips, or lock fewer swaths</source>
        <translation>permita más franjas abiertas, o fije menos pasadas</translation>
    </message>
    <message>
        <source>name another swath for the end</source>
        <translation>indique otra pasada para el final</translation>
    </message>
    <message>
        <source>no order was found that keeps to all that is said of the order of swaths</source>
        <translation>no se encontró ningún orden que cumpla todo lo indicado sobre el orden de las pasadas</translation>
    </message>
    <message>
        <source>swath %1 is driven first</source>
        <translation>la pasada %1 se hace primero</translation>
    </message>
    <message>
        <source>%1 are driven outside of the field</source>
        <translation>%1 se recorren fuera de la parcela</translation>
    </message>
    <message>
        <source>%1 costs %2 more than the longest edge (%3)</source>
        <translation>%1 cuesta %2 más que el lado más largo (%3)</translation>
    </message>
    <message>
        <source>%1 h %2 min</source>
        <translation>%1 h %2 min</translation>
    </message>
    <message>
        <source>%1 is as quick as the longest edge (%2)</source>
        <translation>%1 es tan rápido como el lado más largo (%2)</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>%1 of a work order is no amount</source>
        <translation>%1 de una orden de trabajo no es una cantidad</translation>
    </message>
    <message>
        <source>%1 of a work order is no text</source>
        <translation>%1 de una orden de trabajo no es un texto</translation>
    </message>
    <message>
        <source>%1 runs along the longest edge</source>
        <translation>%1 va a lo largo del lado más largo</translation>
    </message>
    <message>
        <source>%1 saves %2 against the longest edge (%3)</source>
        <translation>%1 ahorra %2 frente al lado más largo (%3)</translation>
    </message>
    <message>
        <source>%1 × %2, %3 each</source>
        <translation>%1 × %2, %3 cada uno</translation>
    </message>
    <message>
        <source>%1: a turn of this machine, with a radius of %2, needs %3.</source>
        <translation>%1: un giro de esta máquina, con un radio de %2, necesita %3.</translation>
    </message>
    <message>
        <source>%1: a turn to the next swath would need %2, so turns are made in other ways.</source>
        <translation>%1: un giro a la pasada siguiente necesitaría %2, por eso se gira de otra manera.</translation>
    </message>
    <message>
        <source>%1: its work order is not used: %2</source>
        <translation>%1: su orden de trabajo no se usa: %2</translation>
    </message>
    <message>
        <source>%1: the field is too narrow for the %2 that a turn of this machine needs.</source>
        <translation>%1: la parcela es demasiado estrecha para los %2 que necesita un giro de esta máquina.</translation>
    </message>
    <message>
        <source>%1; the machine keeps %2 from its edge at least.</source>
        <translation>%1; la máquina se mantiene al menos a %2 del borde.</translation>
    </message>
    <message numerus="yes">
        <source>%n blocks</source>
        <translation>
            <numerusform>%n subparcela</numerusform>
            <numerusform>%n subparcelas</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n passes of %1</source>
        <translation>
            <numerusform>%n pasada de %1</numerusform>
            <numerusform>%n pasadas de %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n swaths</source>
        <translation>
            <numerusform>%n pasada</numerusform>
            <numerusform>%n pasadas</numerusform>
        </translation>
    </message>
    <message>
        <source>Cut into %1 pieces where swaths are interrupted, joined to %2.</source>
        <translation>Cortado en %1 partes donde se interrumpen las pasadas, unidas en %2.</translation>
    </message>
    <message>
        <source>Cut into %1 pieces where swaths are interrupted; joining them to %2 saves %3 of turns and ways.</source>
        <translation>Cortado en %1 partes donde se interrumpen las pasadas; unirlas en %2 ahorra %3 de giros y trayectos.</translation>
    </message>
    <message>
        <source>Edges that swaths run along get %1, edges that they end at up to %2: a turn of this machine needs %3.</source>
        <translation>Los lados paralelos a las pasadas reciben %1; los lados donde terminan, hasta %2: un giro de esta máquina necesita %3.</translation>
    </message>
    <message>
        <source>Everything keeps %1 from the boundary, as chosen.</source>
        <translation>Todo se mantiene a %1 del límite, como se eligió.</translation>
    </message>
    <message>
        <source>Everything keeps %1 from the boundary: no more is known of where it runs.</source>
        <translation>Todo se mantiene a %1 del límite: no se sabe con más exactitud por dónde va.</translation>
    </message>
    <message numerus="yes">
        <source>No heading has fewer than %n swaths.</source>
        <translation>
            <numerusform>Ninguna dirección tiene menos de %n pasada.</numerusform>
            <numerusform>Ninguna dirección tiene menos de %n pasadas.</numerusform>
        </translation>
    </message>
    <message>
        <source>No heading that was tried covers more: %1 inside the headland.</source>
        <translation>Ninguna dirección probada trabaja más superficie: %1 dentro de la cabecera.</translation>
    </message>
    <message numerus="yes">
        <source>No heading that was tried has fewer than %n swaths.</source>
        <translation>
            <numerusform>Ninguna dirección probada tiene menos de %n pasada.</numerusform>
            <numerusform>Ninguna dirección probada tiene menos de %n pasadas.</numerusform>
        </translation>
    </message>
    <message>
        <source>No heading that was tried has shorter swaths: %1.</source>
        <translation>Ninguna dirección probada tiene pasadas más cortas: %1.</translation>
    </message>
    <message>
        <source>No heading that was tried works less land twice: %1.</source>
        <translation>Ninguna dirección probada trabaja menos superficie dos veces: %1.</translation>
    </message>
    <message>
        <source>No order of these swaths can save more than %1 of the turns, or %2 of all.</source>
        <translation>Ningún orden de estas pasadas puede ahorrar más del %1 de los giros, o el %2 de todo.</translation>
    </message>
    <message>
        <source>No order of these swaths is better; that is proved.</source>
        <translation>Ningún orden de estas pasadas es mejor; está demostrado.</translation>
    </message>
    <message>
        <source>Nothing divides the swaths: one block.</source>
        <translation>Nada divide las pasadas: una sola subparcela.</translation>
    </message>
    <message>
        <source>Nothing stands outside of the field</source>
        <translation>Nada queda fuera de la parcela</translation>
    </message>
    <message>
        <source>One pass all round works the whole field.</source>
        <translation>Una sola pasada alrededor trabaja toda la parcela.</translation>
    </message>
    <message numerus="yes">
        <source>Swaths are interrupted by corners or obstacles: %n blocks.</source>
        <translation>
            <numerusform>Esquinas u obstáculos interrumpen las pasadas: %n subparcela.</numerusform>
            <numerusform>Esquinas u obstáculos interrumpen las pasadas: %n subparcelas.</numerusform>
        </translation>
    </message>
    <message>
        <source>The longest way without work, %1, follows %2.</source>
        <translation>El trayecto más largo sin trabajar, %1, sigue a %2.</translation>
    </message>
    <message>
        <source>There is no headland, as chosen. Turns reach %1 beyond the ends of swaths.</source>
        <translation>No hay cabecera, como se eligió. Los giros llegan %1 más allá del final de las pasadas.</translation>
    </message>
    <message>
        <source>Turns take %1 less than with the pattern “%2” (%3).</source>
        <translation>Los giros cuestan %1 menos que con el patrón «%2» (%3).</translation>
    </message>
    <message>
        <source>Turns take %1 more than with the pattern “%2” (%3).</source>
        <translation>Los giros cuestan %1 más que con el patrón «%2» (%3).</translation>
    </message>
    <message>
        <source>Turns take about as much as with the pattern “%1”.</source>
        <translation>Los giros cuestan más o menos lo mismo que con el patrón «%1».</translation>
    </message>
    <message>
        <source>a member that every plan has is missing or of another kind</source>
        <translation>falta un dato que tiene todo plan, o es de otro tipo</translation>
    </message>
    <message>
        <source>a work order is a JSON object, and this is none</source>
        <translation>una orden de trabajo es un objeto JSON y esto no lo es</translation>
    </message>
    <message>
        <source>bulb turn</source>
        <translation>giro en omega</translation>
    </message>
    <message>
        <source>by this estimate %1 would save %2</source>
        <translation>según esta estimación, %1 ahorraría %2</translation>
    </message>
    <message>
        <source>fishtail turn</source>
        <translation>giro en cola de pez</translation>
    </message>
    <message>
        <source>give a number that is not negative, or leave it out</source>
        <translation>indique un número que no sea negativo o no lo ponga</translation>
    </message>
    <message>
        <source>it is draft, issued, in_progress or done</source>
        <translation>es draft, issued, in_progress o done</translation>
    </message>
    <message>
        <source>no heading is much quicker</source>
        <translation>ninguna dirección es mucho más rápida</translation>
    </message>
    <message>
        <source>no heading is quicker</source>
        <translation>ninguna dirección es más rápida</translation>
    </message>
    <message>
        <source>no plan of this project was sent for this review</source>
        <translation>ningún plan de este proyecto se envió para esta revisión</translation>
    </message>
    <message>
        <source>open the project that the plan was sent from, or open the file by itself</source>
        <translation>abra el proyecto desde el que se envió el plan, o abra el archivo solo</translation>
    </message>
    <message>
        <source>put it in quotation marks</source>
        <translation>póngalo entre comillas</translation>
    </message>
    <message>
        <source>see the README for the members of a work order</source>
        <translation>vea en el README los datos de una orden de trabajo</translation>
    </message>
    <message>
        <source>there is no such status of a work order</source>
        <translation>no existe ese estado de una orden de trabajo</translation>
    </message>
    <message>
        <source>there is no way to drive</source>
        <translation>no hay ningún camino posible</translation>
    </message>
    <message>
        <source>turn on the spot</source>
        <translation>giro en el sitio</translation>
    </message>
    <message>
        <source>turn with reversing</source>
        <translation>giro con marcha atrás</translation>
    </message>
    <message>
        <source>way straight on</source>
        <translation>trayecto recto</translation>
    </message>
    <message>
        <source>%1 are driven over the field with the implement up; longest: %2.</source>
        <translation>Se recorren %1 sobre la parcela con el apero levantado; lo más largo: %2.</translation>
    </message>
    <message>
        <source>%1 for each swath gives %2 swaths, and no plan may have more than %3</source>
        <translation>%1 por pasada dan %2 pasadas, y ningún plan puede tener más de %3</translation>
    </message>
    <message>
        <source>%1 is beyond what machines have</source>
        <translation>%1 está fuera de lo que tienen las máquinas</translation>
    </message>
    <message>
        <source>&apos;%1&apos; in it is a view</source>
        <translation>«%1» es una vista</translation>
    </message>
    <message>
        <source>a text with fields may take %1 MiB, and this one takes more</source>
        <translation>un texto con parcelas puede ocupar %1 MiB, y este ocupa más</translation>
    </message>
    <message>
        <source>a value in it is not of the kind that belongs there</source>
        <translation>un valor no es del tipo que corresponde ahí</translation>
    </message>
    <message>
        <source>correct one of them, or give min_turning_radius_m</source>
        <translation>corrija uno de los dos o indique min_turning_radius_m</translation>
    </message>
    <message>
        <source>cut it into parts, or export it as a GeoPackage</source>
        <translation>divídalo en partes o expórtelo como GeoPackage</translation>
    </message>
    <message>
        <source>did you mean %1?</source>
        <translation>¿quería decir %1?</translation>
    </message>
    <message>
        <source>export it as a table, or remove it</source>
        <translation>expórtela como tabla o quítela</translation>
    </message>
    <message>
        <source>it would grow more than three hundredfold when it is unpacked</source>
        <translation>crecería más de trescientas veces al descomprimirse</translation>
    </message>
    <message>
        <source>it would take more than 2 GiB when it is unpacked</source>
        <translation>descomprimido ocuparía más de 2 GiB</translation>
    </message>
    <message>
        <source>lists and objects lie too deep in one another here</source>
        <translation>aquí hay listas y objetos anidados a demasiada profundidad</translation>
    </message>
    <message>
        <source>remove what does not belong there</source>
        <translation>quite lo que no corresponde ahí</translation>
    </message>
    <message>
        <source>the file is far too large for what it should hold</source>
        <translation>el archivo es demasiado grande para lo que debería contener</translation>
    </message>
    <message>
        <source>unpack it and give one of its files</source>
        <translation>descomprímalo e indique uno de sus archivos</translation>
    </message>
    <message>
        <source>with this wheelbase, %1 give a turning radius of %2</source>
        <translation>con esta distancia entre ejes, %1 dan un radio de giro de %2</translation>
    </message>
    <message>
        <source>%1 is no number (%2), and nothing is written</source>
        <translation>%1 no es un número (%2), y no se escribe nada</translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: %2 (%3); the plan is made with %4 until then</source>
        <translation>%1: %2 (%3); hasta entonces se planifica con %4</translation>
    </message>
    <message>
        <source>a place</source>
        <translation>un lugar</translation>
    </message>
    <message>
        <source>a place of a guidance line</source>
        <translation>un lugar de una línea de guiado</translation>
    </message>
    <message>
        <source>a place of an obstacle</source>
        <translation>un lugar de un obstáculo</translation>
    </message>
    <message>
        <source>a place of swath %1</source>
        <translation>un lugar de la pasada %1</translation>
    </message>
    <message>
        <source>a place of the boundary</source>
        <translation>un lugar del límite</translation>
    </message>
    <message>
        <source>a place of the mainland</source>
        <translation>un lugar del interior</translation>
    </message>
    <message>
        <source>give one beside it, in WGS84, longitude first</source>
        <translation>indique una junto a ella, en WGS84, primero la longitud</translation>
    </message>
    <message>
        <source>plan parts of the field by themselves, choose another heading, or take small obstacles out of the boundary</source>
        <translation>planifique partes de la parcela por separado, elija otro rumbo o quite obstáculos pequeños del límite</translation>
    </message>
    <message>
        <source>the area of the field</source>
        <translation>la superficie de la parcela</translation>
    </message>
    <message>
        <source>the bearing of a guidance line</source>
        <translation>el rumbo de una línea de guiado</translation>
    </message>
    <message>
        <source>the buffer of an obstacle</source>
        <translation>el margen de un obstáculo</translation>
    </message>
    <message>
        <source>the coverage of the swaths</source>
        <translation>la parte que trabajan las pasadas</translation>
    </message>
    <message>
        <source>the curvature</source>
        <translation>la curvatura</translation>
    </message>
    <message>
        <source>the curve is %1 km away from the field</source>
        <translation>la curva está a %1 km de la parcela</translation>
    </message>
    <message>
        <source>the heading</source>
        <translation>el rumbo</translation>
    </message>
    <message>
        <source>the outline cuts the tracks into %1 swaths, and no plan may have more than %2</source>
        <translation>el contorno corta las pistas en %1 pasadas, y ningún plan puede tener más de %2</translation>
    </message>
    <message>
        <source>the overhang of an obstacle</source>
        <translation>el voladizo de un obstáculo</translation>
    </message>
    <message>
        <source>the overlap of the swaths</source>
        <translation>el solape de las pasadas</translation>
    </message>
    <message>
        <source>the place of a finding</source>
        <translation>el lugar de un aviso</translation>
    </message>
    <message>
        <source>the place of a gate</source>
        <translation>el lugar de una entrada</translation>
    </message>
    <message>
        <source>the radius of a guidance line</source>
        <translation>el radio de una línea de guiado</translation>
    </message>
    <message>
        <source>the share of the mainland</source>
        <translation>la parte del interior</translation>
    </message>
    <message>
        <source>the speed</source>
        <translation>la velocidad</translation>
    </message>
    <message>
        <source>the time</source>
        <translation>el tiempo</translation>
    </message>
    <message>
        <source>the way driven</source>
        <translation>el recorrido</translation>
    </message>
    <message>
        <source>the width of a gate</source>
        <translation>el ancho de una entrada</translation>
    </message>
    <message>
        <source>the width of a guidance line</source>
        <translation>el ancho de una línea de guiado</translation>
    </message>
    <message>
        <source>the width of the headland</source>
        <translation>el ancho de la cabecera</translation>
    </message>
    <message>
        <source>this is a mistake of Furrow, please report it with the field, the machine and the settings</source>
        <translation>es un error de Furrow; comuníquelo con la parcela, la máquina y los ajustes</translation>
    </message>
    <message>
        <source>%1 %2 is no place in WGS84</source>
        <translation>%1 %2 no es un lugar en WGS84</translation>
    </message>
    <message>
        <source>%1 gathers %2; the bunker holds %3.</source>
        <translation>%1 recoge %2; en la tolva caben %3.</translation>
    </message>
    <message>
        <source>%1 of standing</source>
        <translation>%1 de parada</translation>
    </message>
    <message>
        <source>%1 takes %2; the tank holds %3.</source>
        <translation>%1 gasta %2; en el depósito caben %3.</translation>
    </message>
    <message numerus="yes">
        <source>%n passes are too long for it.</source>
        <translation>
            <numerusform>%n pasada es demasiado larga.</numerusform>
            <numerusform>%n pasadas son demasiado largas.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n refills, with %1 of way to them and back and %2.</source>
        <translation>
            <numerusform>Una recarga, con %1 de camino de ida y vuelta y %2.</numerusform>
            <numerusform>%n recargas, con %1 de camino de ida y vuelta y %2.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n unloadings, with %1 of way to them and back and %2.</source>
        <translation>
            <numerusform>Una descarga, con %1 de camino de ida y vuelta y %2.</numerusform>
            <numerusform>%n descargas, con %1 de camino de ida y vuelta y %2.</numerusform>
        </translation>
    </message>
    <message>
        <source>Choose another refill point.</source>
        <translation>Elija otro punto de recarga.</translation>
    </message>
    <message>
        <source>Give more refill points, or ones that are nearer.</source>
        <translation>Indique más puntos de recarga, o más cercanos.</translation>
    </message>
    <message>
        <source>Let ways cross the mainland (route.traversal), so that swaths may be interrupted, or lay the swaths the short way.</source>
        <translation>Permita caminos por el interior (route.traversal), para que se puedan interrumpir las pasadas, o trace las pasadas en la dirección corta.</translation>
    </message>
    <message>
        <source>No trip to a refill point is needed: %1 of the %2 that the bunker holds are gathered.</source>
        <translation>No hace falta ir a un punto de descarga: se recogen %1 de los %2 que caben en la tolva.</translation>
    </message>
    <message>
        <source>No trip to a refill point is needed: %1 of the %2 that the tank holds are used.</source>
        <translation>No hace falta ir a un punto de recarga: se usan %1 de los %2 que caben en el depósito.</translation>
    </message>
    <message>
        <source>No way to a refill point leads from the work before %1.</source>
        <translation>Ningún camino lleva a un punto de recarga desde el trabajo antes de %1.</translation>
    </message>
    <message>
        <source>POINT (%1 %2) lies outside of the field</source>
        <translation>POINT (%1 %2) está fuera de la parcela</translation>
    </message>
    <message>
        <source>Plan again; the levels were changed.</source>
        <translation>Planifique de nuevo; se cambiaron los niveles.</translation>
    </message>
    <message>
        <source>Refill points</source>
        <translation>Puntos de recarga</translation>
    </message>
    <message>
        <source>That the machine stands each time its tank is filled or its bunker emptied; 300 s where it is not given.</source>
        <translation>Lo que la máquina está parada cada vez que se llena el depósito o se vacía la tolva; 300 s si no se indica.</translation>
    </message>
    <message>
        <source>The bunker is full in %1: %2 are worked beyond that.</source>
        <translation>La tolva está llena (%1): se trabajan %2 más.</translation>
    </message>
    <message>
        <source>The level changes %1 away from the refill points.</source>
        <translation>El nivel cambia a %1 de los puntos de recarga.</translation>
    </message>
    <message>
        <source>The machine has no room at this refill point.</source>
        <translation>La máquina no tiene sitio en este punto de recarga.</translation>
    </message>
    <message>
        <source>The machine has to stand for %1 s at a refill point, and does not in %2.</source>
        <translation>La máquina debe estar parada %1 s en un punto de recarga y no lo hace: %2.</translation>
    </message>
    <message>
        <source>The refill points are not used: this machine has no tank.</source>
        <translation>Los puntos de recarga no se usan: esta máquina no tiene depósito.</translation>
    </message>
    <message>
        <source>The refill points are not used: this machine&apos;s tank has no rate.</source>
        <translation>Los puntos de recarga no se usan: el depósito de esta máquina no tiene dosis.</translation>
    </message>
    <message>
        <source>The refill points are not used: this operation uses no tank.</source>
        <translation>Los puntos de recarga no se usan: esta labor no usa depósito.</translation>
    </message>
    <message>
        <source>The stated level differs from the work that is done, by up to %1 of the tank.</source>
        <translation>El nivel indicado difiere del trabajo hecho, hasta en %1 del depósito.</translation>
    </message>
    <message>
        <source>The tank is empty in %1: %2 are worked beyond that.</source>
        <translation>El depósito está vacío (%1): se trabajan %2 más.</translation>
    </message>
    <message>
        <source>Time to fill</source>
        <translation>Tiempo de llenado</translation>
    </message>
    <message>
        <source>Where the tank is filled or the bunker emptied: points or names of gates, divided by semicolons.</source>
        <translation>Dónde se llena el depósito o se vacía la tolva: puntos o nombres de entradas, separados por punto y coma.</translation>
    </message>
    <message>
        <source>give longitude, then latitude, in degrees</source>
        <translation>indique longitud, luego latitud, en grados</translation>
    </message>
    <message>
        <source>names of gates or points in WGS84 such as MULTIPOINT ((4.1 52.0), (4.2 52.0))</source>
        <translation>nombres de entradas o puntos en WGS84 como MULTIPOINT ((4.1 52.0), (4.2 52.0))</translation>
    </message>
    <message>
        <source>Always</source>
        <translation>Siempre</translation>
    </message>
    <message>
        <source>The quickest of them is taken.</source>
        <translation>Se toma el más rápido.</translation>
    </message>
    <message>
        <source>Only where the first one cannot be driven</source>
        <translation>Solo si el primero no es realizable</translation>
    </message>
    <message>
        <source>Planning is several times quicker, and the work takes some percent longer.</source>
        <translation>La planificación es varias veces más rápida, y el trabajo dura unos pocos por ciento más.</translation>
    </message>
    <message>
        <source>Compare plans</source>
        <translation>Comparar planes</translation>
    </message>
    <message>
        <source>Plans with other headings, orders, corners and fewer headland passes are driven beside the first one.</source>
        <translation>Además del primero se calculan por completo planes con otras direcciones, órdenes y esquinas y con menos pasadas de cabecera.</translation>
    </message>
    <message>
        <source>headings, orders and corners are not compared as driven: the path has %1 parts and the field %2 corners, and with more than %3 in all that takes too long</source>
        <translation>no se comparan direcciones, órdenes y esquinas recorridas: el recorrido tiene %1 partes y la parcela %2 esquinas, y con más de %3 en total tarda demasiado</translation>
    </message>
    <message>
        <source>Way back to work</source>
        <translation>Camino de vuelta al trabajo</translation>
    </message>
    <message>
        <source>Way to refill</source>
        <translation>Camino a la recarga</translation>
    </message>
    <message>
        <source>Way to unload</source>
        <translation>Camino a la descarga</translation>
    </message>
    <message>
        <source>Swaths reach to the boundary; for fields with room to turn outside, and for machines that turn on the spot.</source>
        <translation>Las pasadas llegan al límite; para parcelas con sitio para girar fuera y para máquinas que giran en el sitio.</translation>
    </message>
    <message>
        <source>There is no headland, as chosen. The machine turns on the spot inside the field.</source>
        <translation>No hay cabecera, como se eligió. La máquina gira en el sitio, dentro de la parcela.</translation>
    </message>
</context>
<context>
    <name>PreferencesDialog</name>
    <message>
        <source>Language and units</source>
        <translation>Idioma y unidades</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Idioma</translation>
    </message>
    <message>
        <source>Same as this computer</source>
        <translation>Como este ordenador</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>Unidades</translation>
    </message>
    <message>
        <source>Metres, hectares, km/h</source>
        <translation>Metros, hectáreas, km/h</translation>
    </message>
    <message>
        <source>Feet, acres, mph</source>
        <translation>Pies, acres, mph</translation>
    </message>
    <message>
        <source>Fields take both: 7.3 m, 24 ft, 10&apos;6&quot;, 8 km/h, 5 mph. Files always hold metres.</source>
        <translation>Las casillas admiten ambas: 7,3 m, 24 ft, 10&apos;6&quot;, 8 km/h, 5 mph. Los archivos siempre van en metros.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
</context>
<context>
    <name>PrintDialog</name>
    <message>
        <source>Print the work order</source>
        <translation>Imprimir la orden de trabajo</translation>
    </message>
    <message>
        <source>Plan again</source>
        <translation>Planificar de nuevo</translation>
    </message>
    <message numerus="yes">
        <source>%n problem(s) in this plan: it cannot be driven as drawn. The pages say so too.</source>
        <translation>
            <numerusform>%n problema en este plan: no se puede recorrer tal como está. Las páginas también lo dicen.</numerusform>
            <numerusform>%n problemas en este plan: no se puede recorrer tal como está. Las páginas también lo dicen.</numerusform>
        </translation>
    </message>
    <message>
        <source>Pages of</source>
        <translation>Páginas de</translation>
    </message>
    <message>
        <source>This field</source>
        <translation>Esta parcela</translation>
    </message>
    <message>
        <source>The whole farm (%1)</source>
        <translation>Toda la explotación (%1)</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>Papel</translation>
    </message>
    <message>
        <source>A4</source>
        <translation>A4</translation>
    </message>
    <message>
        <source>Letter</source>
        <translation>Carta</translation>
    </message>
    <message>
        <source>Printer</source>
        <translation>Impresora</translation>
    </message>
    <message>
        <source>No printer was found</source>
        <translation>No se encontró ninguna impresora</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Detener</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Save picture…</source>
        <translation>Guardar imagen…</translation>
    </message>
    <message>
        <source>Print</source>
        <translation>Imprimir</translation>
    </message>
    <message>
        <source>Save as PDF…</source>
        <translation>Guardar como PDF…</translation>
    </message>
    <message>
        <source>Save the work order</source>
        <translation>Guardar la orden de trabajo</translation>
    </message>
    <message>
        <source>PDF (%1)</source>
        <translation>PDF (%1)</translation>
    </message>
    <message>
        <source>Save the page with the map as a picture</source>
        <translation>Guardar la página del mapa como imagen</translation>
    </message>
    <message>
        <source>Pictures (%1)</source>
        <translation>Imágenes (%1)</translation>
    </message>
    <message numerus="yes">
        <source>%n field(s) of the list</source>
        <translation>
            <numerusform>%n parcela de la lista</numerusform>
            <numerusform>%n parcelas de la lista</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ProblemCard</name>
    <message>
        <source>Show the place</source>
        <translation>Mostrar el lugar</translation>
    </message>
    <message>
        <source>Open another file…</source>
        <translation>Abrir otro archivo…</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
</context>
<context>
    <name>ProjectDialogs</name>
    <message>
        <source>Open projects or field boundaries</source>
        <translation>Abrir proyectos o límites de parcela</translation>
    </message>
    <message>
        <source>Projects and field boundaries (%1)</source>
        <translation>Proyectos y límites de parcela (%1)</translation>
    </message>
    <message>
        <source>Projects (%1)</source>
        <translation>Proyectos (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Save the project</source>
        <translation>Guardar el proyecto</translation>
    </message>
</context>
<context>
    <name>RecentList</name>
    <message>
        <source>Open recent</source>
        <translation>Abrir reciente</translation>
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
        <translation>Seguir con</translation>
    </message>
    <message>
        <source>Project %1 in %2, %3</source>
        <translation>Proyecto %1 en %2, %3</translation>
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
            <numerusform>%n aviso</numerusform>
            <numerusform>%n avisos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n problem(s)</source>
        <translation>
            <numerusform>%n problema</numerusform>
            <numerusform>%n problemas</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n to look at</source>
        <translation>
            <numerusform>%n para revisar</numerusform>
            <numerusform>%n para revisar</numerusform>
        </translation>
    </message>
    <message>
        <source>Show the first %1 only</source>
        <translation>Mostrar solo los %1 primeros</translation>
    </message>
    <message>
        <source>Show all %1</source>
        <translation>Mostrar los %1</translation>
    </message>
    <message>
        <source>Out of date: figures and findings are those of the plan before the change.</source>
        <translation>Desactualizado: las cifras y los avisos son del plan anterior al cambio.</translation>
    </message>
    <message>
        <source>Nothing was found in this plan: all of it can be driven.</source>
        <translation>No se encontró nada en este plan: se puede recorrer entero.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>first plan: preliminary figures</source>
        <translation>primer plan: cifras provisionales</translation>
    </message>
    <message>
        <source>of the plan before</source>
        <translation>del plan anterior</translation>
    </message>
</context>
<context>
    <name>ReviewDialogs</name>
    <message>
        <source>Send for review</source>
        <translation>Enviar a revisión</translation>
    </message>
    <message>
        <source>Review files (%1)</source>
        <translation>Archivos de revisión (%1)</translation>
    </message>
    <message>
        <source>Take in what came back</source>
        <translation>Incorporar lo recibido</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Take in this review?</source>
        <translation>¿Incorporar esta revisión?</translation>
    </message>
    <message>
        <source>The file is a review of a plan of the project that is open. Its comments can be taken in here.</source>
        <translation>El archivo es una revisión de un plan del proyecto abierto. Sus comentarios se pueden incorporar aquí.</translation>
    </message>
    <message>
        <source>Take in</source>
        <translation>Incorporar</translation>
    </message>
    <message>
        <source>Open by itself</source>
        <translation>Abrir por separado</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
</context>
<context>
    <name>ReviewSection</name>
    <message numerus="yes">
        <source>Review · %n open comment(s)</source>
        <translation>
            <numerusform>Revisión · %n comentario abierto</numerusform>
            <numerusform>Revisión · %n comentarios abiertos</numerusform>
        </translation>
    </message>
    <message>
        <source>Review</source>
        <translation>Revisión</translation>
    </message>
    <message>
        <source>The plan has changed since.</source>
        <translation>El plan ha cambiado desde entonces.</translation>
    </message>
    <message>
        <source>Take back</source>
        <translation>Retirar</translation>
    </message>
    <message>
        <source>At the place that you clicked:</source>
        <translation>En el lugar en que hizo clic:</translation>
    </message>
    <message>
        <source>On the whole plan:</source>
        <translation>Sobre todo el plan:</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>Comentario</translation>
    </message>
    <message>
        <source>What should be changed here?</source>
        <translation>¿Qué hay que cambiar aquí?</translation>
    </message>
    <message>
        <source>Your name</source>
        <translation>Su nombre</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Añadir</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>On a place…</source>
        <translation>En un lugar…</translation>
    </message>
    <message>
        <source>On the whole plan…</source>
        <translation>En todo el plan…</translation>
    </message>
    <message>
        <source>Approve</source>
        <translation>Aprobar</translation>
    </message>
    <message>
        <source>Ask for changes</source>
        <translation>Pedir cambios</translation>
    </message>
    <message>
        <source>Take in what came back…</source>
        <translation>Incorporar lo recibido…</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Comment %1:</source>
        <translation>Comentario %1:</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Cambiar</translation>
    </message>
</context>
<context>
    <name>ScaleBar</name>
    <message>
        <source>Scale: the bar is %1 long</source>
        <translation>Escala: la barra mide %1</translation>
    </message>
</context>
<context>
    <name>SearchButton</name>
    <message>
        <source>Search commands</source>
        <translation>Buscar comandos</translation>
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
        <translation>Volver al plan (Esc)</translation>
    </message>
</context>
<context>
    <name>SketchHint</name>
    <message>
        <source>Click the first corner of the field</source>
        <translation>Haga clic en la primera esquina de la parcela</translation>
    </message>
    <message>
        <source>Click the first corner of the hole</source>
        <translation>Haga clic en la primera esquina del hueco</translation>
    </message>
    <message>
        <source>Click the first corner of the obstacle</source>
        <translation>Haga clic en la primera esquina del obstáculo</translation>
    </message>
    <message>
        <source>Click on the boundary where the gate is</source>
        <translation>Haga clic en el límite donde está la entrada</translation>
    </message>
    <message>
        <source>Click where the AB line begins</source>
        <translation>Haga clic donde empieza la línea AB</translation>
    </message>
    <message>
        <source>Length of the next edge</source>
        <translation>Longitud del lado siguiente</translation>
    </message>
    <message>
        <source>Direction of the next edge</source>
        <translation>Dirección del lado siguiente</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Añadir</translation>
    </message>
    <message>
        <source>By hand</source>
        <translation>A mano alzada</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>Terminar</translation>
    </message>
    <message>
        <source>Close boundary</source>
        <translation>Cerrar el límite</translation>
    </message>
    <message>
        <source>Click where the split line begins</source>
        <translation>Haga clic donde empieza la línea de división</translation>
    </message>
    <message>
        <source>Press and trace it with the pointer, to %1</source>
        <translation>Pulse y trace con el puntero, con %1 de precisión</translation>
    </message>
    <message>
        <source>Backspace or Ctrl+Z takes the last point back</source>
        <translation>Retroceso o Ctrl+Z quita el último punto</translation>
    </message>
</context>
<context>
    <name>StatusChip</name>
    <message>
        <source>Stop</source>
        <translation>Detener</translation>
    </message>
    <message>
        <source>Plan again</source>
        <translation>Planificar de nuevo</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Mostrar</translation>
    </message>
    <message>
        <source>Show the problems</source>
        <translation>Mostrar los problemas</translation>
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
        <translation>El contorno tiene %1 escalones de unos %2 %3, como los píxeles de una imagen.</translation>
    </message>
    <message>
        <source>Made straight, their outlines would be refused. Open one of them to see why.</source>
        <translation>Enderezados, sus contornos se rechazarían. Abra una para ver por qué.</translation>
    </message>
    <message>
        <source>No machine follows them. Straight edges lead through the middles of the steps.</source>
        <translation>Ninguna máquina los sigue. Los bordes rectos pasan por la mitad de los escalones.</translation>
    </message>
    <message>
        <source>Make them straight</source>
        <translation>Enderezar</translation>
    </message>
    <message>
        <source>In all fields</source>
        <translation>En todas las parcelas</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
</context>
<context>
    <name>StepsPanel</name>
    <message>
        <source>Find the best plan…</source>
        <translation>Buscar el mejor plan…</translation>
    </message>
</context>
<context>
    <name>ThemeSwitch</name>
    <message>
        <source>Sunlight colours; press for light</source>
        <translation>Colores para pleno sol; pulse para los claros</translation>
    </message>
    <message>
        <source>Dark colours; press for sunlight</source>
        <translation>Colores oscuros; pulse para pleno sol</translation>
    </message>
    <message>
        <source>Light colours; press for dark</source>
        <translation>Colores claros; pulse para los oscuros</translation>
    </message>
</context>
<context>
    <name>TopBar</name>
    <message>
        <source>Not saved yet</source>
        <translation>Aún sin guardar</translation>
    </message>
    <message>
        <source>There are changes that are not saved</source>
        <translation>Hay cambios sin guardar</translation>
    </message>
    <message>
        <source>Hide the results</source>
        <translation>Ocultar los resultados</translation>
    </message>
    <message>
        <source>Show the results</source>
        <translation>Mostrar los resultados</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Abrir</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportar</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Comparar</translation>
    </message>
    <message>
        <source>Hide the steps</source>
        <translation>Ocultar los pasos</translation>
    </message>
    <message>
        <source>Show the steps</source>
        <translation>Mostrar los pasos</translation>
    </message>
</context>
<context>
    <name>Tour</name>
    <message>
        <source>Get a field</source>
        <translation>Cargue una parcela</translation>
    </message>
    <message>
        <source>Open its boundary, draw it, or press here for a sample.</source>
        <translation>Abra su límite, dibújelo o pulse aquí para ver un ejemplo.</translation>
    </message>
    <message>
        <source>Choose your machine</source>
        <translation>Elija su máquina</translation>
    </message>
    <message>
        <source>The second step: the one most like yours, then its width.</source>
        <translation>El segundo paso: la más parecida a la suya y luego su ancho.</translation>
    </message>
    <message>
        <source>Change the field</source>
        <translation>Cambie la parcela</translation>
    </message>
    <message>
        <source>Drag a corner on the map. The plan follows; Ctrl+Z takes it back.</source>
        <translation>Arrastre una esquina en el mapa. El plan la sigue; Ctrl+Z lo deshace.</translation>
    </message>
    <message>
        <source>Take it to the tractor</source>
        <translation>Llévelo al tractor</translation>
    </message>
    <message>
        <source>Export writes the plan to a stick or a folder and checks it.</source>
        <translation>La exportación escribe el plan en una memoria USB o carpeta y lo comprueba.</translation>
    </message>
    <message>
        <source>That is all</source>
        <translation>Eso es todo</translation>
    </message>
    <message>
        <source>First things</source>
        <translation>Primeros pasos</translation>
    </message>
    <message>
        <source>Leave; it is in the Help menu</source>
        <translation>Salir; está en el menú Ayuda</translation>
    </message>
    <message>
        <source>%1: done</source>
        <translation>%1: hecho</translation>
    </message>
    <message>
        <source>Ctrl+S saves the project, F1 opens the guide.</source>
        <translation>Ctrl+S guarda el proyecto, F1 abre la guía.</translation>
    </message>
</context>
<context>
    <name>TrackQuestion</name>
    <message>
        <source>“%1” is a recorded track</source>
        <translation>«%1» es un recorrido grabado</translation>
    </message>
    <message>
        <source>It can become a field, or be laid over the plan to see how far beside it was driven.</source>
        <translation>Puede convertirse en una parcela, o ponerse sobre el plan para ver cuánto se desvió.</translation>
    </message>
    <message>
        <source>Make a field from it</source>
        <translation>Hacer una parcela de él</translation>
    </message>
    <message>
        <source>Lay it over the plan</source>
        <translation>Ponerlo sobre el plan</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
</context>
<context>
    <name>TroubleDialog</name>
    <message>
        <source>Report a problem</source>
        <translation>Informar de un problema</translation>
    </message>
    <message>
        <source>One file with all that is needed to find the cause: the version, the machine, the settings, the shape of the field, the findings, and the record of the last crash. No names and no other fields are in it.</source>
        <translation>Un archivo con todo lo necesario para hallar la causa: la versión, la máquina, los ajustes, la forma de la parcela, los avisos y el registro del último fallo. No lleva nombres ni otras parcelas.</translation>
    </message>
    <message>
        <source>Nothing is sent. You decide who gets the file; write to them what you did and what you expected.</source>
        <translation>No se envía nada. Usted decide quién recibe el archivo; escriba qué hizo y qué esperaba.</translation>
    </message>
    <message>
        <source>Save the report…</source>
        <translation>Guardar el informe…</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>Guardar el informe</translation>
    </message>
    <message>
        <source>Reports (%1)</source>
        <translation>Informes (%1)</translation>
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
        <translation>¿Guardar los cambios de «%1»?</translation>
    </message>
    <message>
        <source>Save your work?</source>
        <translation>¿Guardar el trabajo?</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Do not save</source>
        <translation>No guardar</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Guardar</translation>
    </message>
</context>
<context>
    <name>ViewCommands</name>
    <message>
        <source>View</source>
        <translation>Ver</translation>
    </message>
    <message>
        <source>What the map shows</source>
        <translation>Lo que muestra el mapa</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Colores</translation>
    </message>
    <message>
        <source>Size of everything</source>
        <translation>Tamaño de la interfaz</translation>
    </message>
    <message>
        <source>Everything at %1 %</source>
        <translation>Todo al %1 %</translation>
    </message>
    <message>
        <source>size scaling zoom large text</source>
        <translation>tamaño escala zoom texto grande</translation>
    </message>
    <message>
        <source>Follow the machine</source>
        <translation>Seguir la máquina</translation>
    </message>
    <message>
        <source>drive camera centre</source>
        <translation>recorrer mapa centro</translation>
    </message>
    <message>
        <source>Drive-through bar</source>
        <translation>Barra de recorrido</translation>
    </message>
    <message>
        <source>drive play slider</source>
        <translation>recorrer reproducir control</translation>
    </message>
    <message>
        <source>Show the whole field</source>
        <translation>Mostrar toda la parcela</translation>
    </message>
    <message>
        <source>Go to a place…</source>
        <translation>Ir a un lugar…</translation>
    </message>
    <message>
        <source>coordinates latitude longitude map</source>
        <translation>coordenadas latitud longitud mapa</translation>
    </message>
    <message>
        <source>Closer</source>
        <translation>Acercar</translation>
    </message>
    <message>
        <source>zoom in</source>
        <translation>ampliar zoom</translation>
    </message>
    <message>
        <source>Further away</source>
        <translation>Alejar</translation>
    </message>
    <message>
        <source>zoom out</source>
        <translation>reducir zoom</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Pasos</translation>
    </message>
    <message>
        <source>Results panel</source>
        <translation>Resultados</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Capas</translation>
    </message>
    <message>
        <source>imagery map background</source>
        <translation>imágenes mapa fondo</translation>
    </message>
    <message>
        <source>Layer: imagery</source>
        <translation>Capa: imágenes</translation>
    </message>
    <message>
        <source>Layer: OpenStreetMap from the network</source>
        <translation>Capa: OpenStreetMap de la red</translation>
    </message>
    <message>
        <source>online tiles</source>
        <translation>en línea teselas</translation>
    </message>
    <message>
        <source>Layer: boundary</source>
        <translation>Capa: límite de parcela</translation>
    </message>
    <message>
        <source>Layer: headland</source>
        <translation>Capa: cabecera</translation>
    </message>
    <message>
        <source>Layer: swaths</source>
        <translation>Capa: pasadas</translation>
    </message>
    <message>
        <source>Layer: turns</source>
        <translation>Capa: giros</translation>
    </message>
    <message>
        <source>Layer: driving direction</source>
        <translation>Capa: sentido de marcha</translation>
    </message>
    <message>
        <source>Layer: swath numbers</source>
        <translation>Capa: números de las pasadas</translation>
    </message>
    <message>
        <source>Layer: order numbers</source>
        <translation>Capa: números de orden</translation>
    </message>
    <message>
        <source>Layer: coverage</source>
        <translation>Capa: superficie trabajada</translation>
    </message>
    <message>
        <source>Layer: worked twice</source>
        <translation>Capa: trabajado dos veces</translation>
    </message>
    <message>
        <source>overlap</source>
        <translation>solape</translation>
    </message>
    <message>
        <source>Layer: missed</source>
        <translation>Capa: zonas sin trabajar</translation>
    </message>
    <message>
        <source>gap uncovered</source>
        <translation>hueco sin cubrir</translation>
    </message>
    <message>
        <source>Layer: driven over often</source>
        <translation>Capa: pasos de rueda</translation>
    </message>
    <message>
        <source>wheel passes traffic compaction</source>
        <translation>pasos de rueda tráfico compactación</translation>
    </message>
    <message>
        <source>Layer: findings</source>
        <translation>Capa: avisos</translation>
    </message>
    <message>
        <source>Language and units…</source>
        <translation>Idioma y unidades…</translation>
    </message>
    <message>
        <source>preferences settings metric imperial feet acres</source>
        <translation>preferencias ajustes métrico imperial pies acres</translation>
    </message>
    <message>
        <source>Light colours</source>
        <translation>Colores claros</translation>
    </message>
    <message>
        <source>theme</source>
        <translation>tema</translation>
    </message>
    <message>
        <source>Dark colours</source>
        <translation>Colores oscuros</translation>
    </message>
    <message>
        <source>theme night</source>
        <translation>tema noche</translation>
    </message>
    <message>
        <source>Sunlight colours</source>
        <translation>Colores para pleno sol</translation>
    </message>
    <message>
        <source>theme contrast</source>
        <translation>tema contraste</translation>
    </message>
</context>
<context>
    <name>WindowDialogs</name>
    <message>
        <source>Everything at %1 %</source>
        <translation>Todo al %1 %</translation>
    </message>
    <message>
        <source>This holds from the next start of Furrow.</source>
        <translation>Esto se aplica a partir del próximo inicio de Furrow.</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>Aceptar</translation>
    </message>
</context>
<context>
    <name>Words</name>
    <message>
        <source>Several moves</source>
        <translation>Varias maniobras</translation>
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
        <translation>como se dibujó</translation>
    </message>
    <message>
        <source>Draft</source>
        <comment>work order</comment>
        <translation>Borrador</translation>
    </message>
    <message>
        <source>Issued</source>
        <comment>work order</comment>
        <translation>Emitida</translation>
    </message>
    <message>
        <source>In progress</source>
        <comment>work order</comment>
        <translation>En curso</translation>
    </message>
    <message>
        <source>Done</source>
        <comment>work order</comment>
        <translation>Terminada</translation>
    </message>
    <message numerus="yes">
        <source>Not drivable: %n problem(s)</source>
        <translation>
            <numerusform>No realizable: %n problema</numerusform>
            <numerusform>No realizable: %n problemas</numerusform>
        </translation>
    </message>
    <message>
        <source>Work order</source>
        <translation>Orden de trabajo</translation>
    </message>
    <message>
        <source>Work order %1</source>
        <translation>Orden de trabajo %1</translation>
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
        <translation>Cliente</translation>
    </message>
    <message>
        <source>Field address</source>
        <translation>Ubicación de la parcela</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>Operario</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tiempo</translation>
    </message>
    <message>
        <source>Product</source>
        <translation>Producto</translation>
    </message>
    <message>
        <source>Rate and total</source>
        <translation>Dosis y total</translation>
    </message>
    <message>
        <source>%1 = %2</source>
        <comment>rate and total</comment>
        <translation>%1 = %2</translation>
    </message>
    <message>
        <source>Where the work starts</source>
        <translation>Donde empieza el trabajo</translation>
    </message>
    <message>
        <source>Gate</source>
        <translation>Entrada</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Superficie</translation>
    </message>
    <message>
        <source>Driven</source>
        <translation>Recorrido</translation>
    </message>
    <message>
        <source>Working</source>
        <translation>Trabajo</translation>
    </message>
    <message>
        <source>Turning</source>
        <translation>Giros</translation>
    </message>
    <message>
        <source>Covered</source>
        <translation>Trabajado</translation>
    </message>
    <message>
        <source>Worked twice</source>
        <translation>Trabajado dos veces</translation>
    </message>
    <message>
        <source>Outside the field</source>
        <translation>Fuera de la parcela</translation>
    </message>
    <message>
        <source>Fuel</source>
        <translation>Combustible</translation>
    </message>
    <message>
        <source>%1 l</source>
        <translation>%1 l</translation>
    </message>
    <message>
        <source>Above the best order</source>
        <translation>Por encima del mejor orden</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Máquina</translation>
    </message>
    <message>
        <source>Working width</source>
        <translation>Ancho de trabajo</translation>
    </message>
    <message>
        <source>Width in turns</source>
        <translation>Ancho en los giros</translation>
    </message>
    <message>
        <source>Turning radius</source>
        <translation>Radio de giro</translation>
    </message>
    <message>
        <source>Speed at work</source>
        <translation>Velocidad de trabajo</translation>
    </message>
    <message>
        <source>Speed in turns</source>
        <translation>Velocidad en los giros</translation>
    </message>
    <message>
        <source>Implement</source>
        <translation>Apero</translation>
    </message>
    <message>
        <source>trailed</source>
        <translation>arrastrado</translation>
    </message>
    <message>
        <source>mounted</source>
        <translation>suspendido</translation>
    </message>
    <message>
        <source>Tank</source>
        <translation>Depósito</translation>
    </message>
    <message>
        <source>full after %1</source>
        <translation>lleno tras %1</translation>
    </message>
    <message>
        <source>enough for %1</source>
        <translation>alcanza para %1</translation>
    </message>
    <message numerus="yes">
        <source>%n pass(es)</source>
        <translation>
            <numerusform>%n pasada</numerusform>
            <numerusform>%n pasadas</numerusform>
        </translation>
    </message>
    <message>
        <source>none</source>
        <comment>headland</comment>
        <translation>ninguna</translation>
    </message>
    <message>
        <source>Operation</source>
        <translation>Operación</translation>
    </message>
    <message>
        <source>Headland</source>
        <translation>Cabecera</translation>
    </message>
    <message>
        <source>Swaths</source>
        <translation>Pasadas</translation>
    </message>
    <message>
        <source>Kept free at the edge</source>
        <translation>Margen libre en el borde</translation>
    </message>
    <message>
        <source>Plan and settings</source>
        <translation>Plan y ajustes</translation>
    </message>
    <message>
        <source>What was done</source>
        <translation>Ejecución</translation>
    </message>
    <message>
        <source>Acres worked</source>
        <translation>Acres trabajados</translation>
    </message>
    <message>
        <source>Hectares worked</source>
        <translation>Hectáreas trabajadas</translation>
    </message>
    <message>
        <source>Hours</source>
        <translation>Horas</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>Inicio</translation>
    </message>
    <message>
        <source>End</source>
        <comment>of the work</comment>
        <translation>Fin</translation>
    </message>
    <message>
        <source>Wind</source>
        <translation>Viento</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>Temperatura</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Observaciones</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Fecha</translation>
    </message>
    <message>
        <source>Signature</source>
        <translation>Firma</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Avisos</translation>
    </message>
    <message>
        <source>None: the plan can be driven as drawn.</source>
        <translation>Ninguno: el plan se puede recorrer tal como está.</translation>
    </message>
    <message numerus="yes">
        <source>and %n more, in the window and in summary.json</source>
        <translation>
            <numerusform>y %n más, en la ventana y en summary.json</numerusform>
            <numerusform>y %n más, en la ventana y en summary.json</numerusform>
        </translation>
    </message>
    <message>
        <source>Comments</source>
        <translation>Comentarios</translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <comment>count and kind of turns</comment>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>%1 in reverse</source>
        <translation>%1 marcha atrás</translation>
    </message>
    <message>
        <source>Turns</source>
        <translation>Giros</translation>
    </message>
    <message>
        <source>H%1</source>
        <comment>headland pass</comment>
        <translation>C%1</translation>
    </message>
    <message>
        <source>Swath %1</source>
        <translation>Pasada %1</translation>
    </message>
    <message>
        <source>Order of the passes</source>
        <translation>Orden de las pasadas</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>N.º</translation>
    </message>
    <message>
        <source>Pass</source>
        <translation>Pasada</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longitud</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Hacia</translation>
    </message>
    <message>
        <source>This plan&apos;s path.csv has the SHA-256 sum below. A file with another sum is another plan.</source>
        <translation>El path.csv de este plan tiene la suma SHA-256 de abajo. Un archivo con otra suma es otro plan.</translation>
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
        <translation>Inicio</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Fin</translation>
    </message>
    <message>
        <source>Swath</source>
        <translation>Pasada</translation>
    </message>
    <message>
        <source>Headland pass</source>
        <translation>Pasada de cabecera</translation>
    </message>
    <message>
        <source>Implement up</source>
        <translation>Apero levantado</translation>
    </message>
    <message>
        <source>Finding</source>
        <translation>Aviso</translation>
    </message>
    <message>
        <source>Obstacle</source>
        <translation>Obstáculo</translation>
    </message>
    <message>
        <source>Farm</source>
        <translation>Explotación</translation>
    </message>
    <message>
        <source>Work orders</source>
        <translation>Órdenes de trabajo</translation>
    </message>
    <message numerus="yes">
        <source>%n field(s)</source>
        <translation>
            <numerusform>%n parcela</numerusform>
            <numerusform>%n parcelas</numerusform>
        </translation>
    </message>
    <message>
        <source>Field</source>
        <translation>Parcela</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Estado</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>Página</translation>
    </message>
    <message>
        <source>Not drivable</source>
        <translation>No realizable</translation>
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
        <translation>Página %1 de %2</translation>
    </message>
    <message>
        <source>Unloadings</source>
        <translation>Descargas</translation>
    </message>
    <message>
        <source>Refills</source>
        <translation>Recargas</translation>
    </message>
</context>
<context>
    <name>furrow::BestSearch</name>
    <message>
        <source>Take the best plan</source>
        <translation>Tomar el mejor plan</translation>
    </message>
</context>
<context>
    <name>furrow::CellSteps</name>
    <message numerus="yes">
        <source>%n block(s), %1</source>
        <translation>
            <numerusform>%n subparcela, %1</numerusform>
            <numerusform>%n subparcelas, %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Cut: %1</source>
        <translation>Dividido: %1</translation>
    </message>
    <message>
        <source>Cut: %1 → joined: %2</source>
        <translation>Dividido: %1 → unido: %2</translation>
    </message>
    <message>
        <source>Joining any two of them would save nothing.</source>
        <translation>Unir dos de ellas no ahorraría nada.</translation>
    </message>
    <message>
        <source>Step %1 of %2: %3</source>
        <translation>Paso %1 de %2: %3</translation>
    </message>
    <message>
        <source>As cut.</source>
        <translation>Como se dividió.</translation>
    </message>
    <message>
        <source>The two marked blocks become one: that saves %1.</source>
        <translation>Las dos subparcelas marcadas pasan a ser una: eso ahorra %1.</translation>
    </message>
    <message>
        <source>Blocks in which no swath lies go to their neighbours.</source>
        <translation>Las subparcelas sin pasadas se unen a sus vecinas.</translation>
    </message>
</context>
<context>
    <name>furrow::ChoiceTableModel</name>
    <message>
        <source>saves %1</source>
        <translation>ahorra %1</translation>
    </message>
    <message>
        <source>mends the plan</source>
        <translation>lo hace realizable</translation>
    </message>
    <message>
        <source>the same time</source>
        <translation>el mismo tiempo</translation>
    </message>
    <message>
        <source>%1 slower</source>
        <translation>%1 más lento</translation>
    </message>
    <message>
        <source>%1 quicker</source>
        <translation>%1 más rápido</translation>
    </message>
</context>
<context>
    <name>furrow::DriveThrough</name>
    <message>
        <source>Swath %1, %2 of %3</source>
        <translation>Pasada %1, %2 de %3</translation>
    </message>
    <message>
        <source>backwards</source>
        <translation>marcha atrás</translation>
    </message>
    <message>
        <source>implement down</source>
        <translation>apero bajado</translation>
    </message>
    <message>
        <source>implement folded</source>
        <translation>apero plegado</translation>
    </message>
    <message>
        <source>implement up</source>
        <translation>apero levantado</translation>
    </message>
    <message>
        <source>%1 done</source>
        <translation>%1 hechas</translation>
    </message>
    <message>
        <source>wheels straight</source>
        <translation>ruedas rectas</translation>
    </message>
    <message>
        <source>%1° left</source>
        <translation>%1° a la izquierda</translation>
    </message>
    <message>
        <source>%1° right</source>
        <translation>%1° a la derecha</translation>
    </message>
    <message>
        <source>tank %1</source>
        <translation>depósito %1</translation>
    </message>
    <message>
        <source>tank empty</source>
        <translation>depósito vacío</translation>
    </message>
    <message>
        <source>Way without work</source>
        <translation>Camino sin trabajar</translation>
    </message>
    <message>
        <source>bunker %1</source>
        <translation>tolva %1</translation>
    </message>
</context>
<context>
    <name>furrow::DrivenTrack</name>
    <message>
        <source>On the plan</source>
        <translation>En el plan</translation>
    </message>
    <message>
        <source>Positions within one and a half widths of it; the figures are of these</source>
        <translation>Posiciones a menos de una anchura y media; las cifras son de estas</translation>
    </message>
    <message>
        <source>Half are within</source>
        <translation>La mitad está dentro de</translation>
    </message>
    <message>
        <source>95 % are within</source>
        <translation>El 95 % está dentro de</translation>
    </message>
    <message>
        <source>Farthest</source>
        <translation>Lo más lejos</translation>
    </message>
    <message>
        <source>On average to the right</source>
        <translation>De media a la derecha</translation>
    </message>
    <message>
        <source>On average to the left</source>
        <translation>De media a la izquierda</translation>
    </message>
    <message>
        <source>The same everywhere: antenna or offset</source>
        <translation>Igual en todas partes: antena o desplazamiento</translation>
    </message>
    <message>
        <source>On swaths, 95 % within</source>
        <translation>En pasadas, 95 % dentro de</translation>
    </message>
    <message>
        <source>Covered</source>
        <translation>Trabajado</translation>
    </message>
    <message>
        <source>As if the implement ran in the middle of the recorded line</source>
        <translation>Como si el apero fuera centrado en la línea grabada</translation>
    </message>
    <message>
        <source>Missed</source>
        <translation>Sin trabajar</translation>
    </message>
    <message>
        <source>Driven</source>
        <translation>Recorrido</translation>
    </message>
    <message>
        <source>The plan: %1</source>
        <translation>El plan: %1</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tiempo</translation>
    </message>
    <message>
        <source>up to %1</source>
        <translation>hasta %1</translation>
    </message>
    <message>
        <source>farther</source>
        <translation>más lejos</translation>
    </message>
    <message>
        <source>off the plan</source>
        <translation>fuera del plan</translation>
    </message>
</context>
<context>
    <name>furrow::ExportModel</name>
    <message>
        <source>Furrow plan</source>
        <translation>Plan de Furrow</translation>
    </message>
    <message>
        <source>Furrow %1</source>
        <translation>Furrow %1</translation>
    </message>
    <message>
        <source>Writing …</source>
        <translation>Escribiendo…</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) written to %1</source>
        <translation>
            <numerusform>%n archivo escrito en %1</numerusform>
            <numerusform>%n archivos escritos en %1</numerusform>
        </translation>
    </message>
    <message>
        <source>There is no field yet, and no plan to export.</source>
        <translation>Todavía no hay parcela ni plan que exportar.</translation>
    </message>
    <message>
        <source>A field is being opened. Its plan can be exported when it is finished.</source>
        <translation>Se está abriendo una parcela. Su plan se podrá exportar cuando esté listo.</translation>
    </message>
    <message>
        <source>The plan is still being made. It can be exported when it is finished.</source>
        <translation>El plan todavía se está calculando. Se podrá exportar cuando esté listo.</translation>
    </message>
    <message>
        <source>The plan is out of date: the field, the machine or a setting was changed after it was made.</source>
        <translation>El plan está desactualizado: la parcela, la máquina o un ajuste cambió después de hacerlo.</translation>
    </message>
    <message>
        <source>There is no plan to export. The message on the map says why.</source>
        <translation>No hay plan que exportar. El mensaje en el mapa dice por qué.</translation>
    </message>
    <message numerus="yes">
        <source>%n field(s)</source>
        <translation>
            <numerusform>%n parcela</numerusform>
            <numerusform>%n parcelas</numerusform>
        </translation>
    </message>
    <message>
        <source>Furrow plans</source>
        <translation>Furrow planes</translation>
    </message>
    <message>
        <source>None of the fields could be exported.</source>
        <translation>No se pudo exportar ninguna de las parcelas.</translation>
    </message>
    <message numerus="yes">
        <source>%n field(s) written to %1</source>
        <translation>
            <numerusform>%n parcela escrita en %1</numerusform>
            <numerusform>%n parcelas escritas en %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n file(s)</source>
        <translation>
            <numerusform>%n archivo</numerusform>
            <numerusform>%n archivos</numerusform>
        </translation>
    </message>
    <message>
        <source>Writing was stopped.</source>
        <translation>Se detuvo la escritura.</translation>
    </message>
    <message>
        <source>Fields that were written before stay in the folder.</source>
        <translation>Las parcelas ya escritas quedan en la carpeta.</translation>
    </message>
</context>
<context>
    <name>furrow::FarmList</name>
    <message numerus="yes">
        <source>Plan %n field(s) alike</source>
        <translation>
            <numerusform>Planificar igual %n parcela</numerusform>
            <numerusform>Planificar igual %n parcelas</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Add a plan to %n field(s)</source>
        <translation>
            <numerusform>Añadir un plan a %n parcela</numerusform>
            <numerusform>Añadir un plan a %n parcelas</numerusform>
        </translation>
    </message>
    <message>
        <source>Not planned yet</source>
        <translation>Sin planificar</translation>
    </message>
    <message>
        <source>Out of date</source>
        <translation>Desactualizado</translation>
    </message>
    <message>
        <source>Waits</source>
        <translation>En espera</translation>
    </message>
    <message>
        <source>Planning …</source>
        <translation>Planificando…</translation>
    </message>
    <message>
        <source>Drivable</source>
        <translation>Realizable</translation>
    </message>
    <message numerus="yes">
        <source>%n problem(s)</source>
        <translation>
            <numerusform>%n problema</numerusform>
            <numerusform>%n problemas</numerusform>
        </translation>
    </message>
    <message>
        <source>No plan</source>
        <translation>Sin plan</translation>
    </message>
    <message numerus="yes">
        <source>%n field(s)</source>
        <translation>
            <numerusform>%n parcela</numerusform>
            <numerusform>%n parcelas</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n field(s)</source>
        <translation>
            <numerusform>%1 de %n parcela</numerusform>
            <numerusform>%1 de %n parcelas</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 drivable</source>
        <translation>%1 realizables</translation>
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
        <translation>Renombrar la parcela</translation>
    </message>
    <message>
        <source>Remove field %1</source>
        <translation>Quitar la parcela %1</translation>
    </message>
    <message>
        <source>Add a plan</source>
        <translation>Añadir un plan</translation>
    </message>
    <message>
        <source>Rename the plan</source>
        <translation>Renombrar el plan</translation>
    </message>
    <message>
        <source>Remove the plan</source>
        <translation>Quitar el plan</translation>
    </message>
</context>
<context>
    <name>furrow::FarmPlans</name>
    <message>
        <source>%1 of %2: %3</source>
        <translation>%1 de %2: %3</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Detenido</translation>
    </message>
    <message numerus="yes">
        <source>%n field(s) planned</source>
        <translation>
            <numerusform>%n parcela planificada</numerusform>
            <numerusform>%n parcelas planificadas</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n with problems</source>
        <translation>
            <numerusform>%n con problemas</numerusform>
            <numerusform>%n con problemas</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n without a plan</source>
        <translation>
            <numerusform>%n sin plan</numerusform>
            <numerusform>%n sin plan</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>furrow::FieldEditor</name>
    <message>
        <source>Add a point</source>
        <translation>Añadir un punto</translation>
    </message>
    <message>
        <source>Change the headland of an edge</source>
        <translation>Cambiar la cabecera de un lado</translation>
    </message>
    <message>
        <source>Headland of an edge as elsewhere</source>
        <translation>Cabecera de un lado como en el resto</translation>
    </message>
    <message>
        <source>Move a point</source>
        <translation>Mover un punto</translation>
    </message>
    <message>
        <source>Move an edge</source>
        <translation>Mover un lado</translation>
    </message>
    <message>
        <source>Move a hole</source>
        <translation>Mover un hueco</translation>
    </message>
    <message>
        <source>Move an obstacle</source>
        <translation>Mover un obstáculo</translation>
    </message>
    <message>
        <source>Move a gate</source>
        <translation>Mover una entrada</translation>
    </message>
    <message>
        <source>Change the buffer</source>
        <translation>Cambiar la distancia</translation>
    </message>
    <message>
        <source>Change the overhang of an obstacle</source>
        <translation>Cambiar el voladizo de un obstáculo</translation>
    </message>
    <message>
        <source>Change the overhang of an edge</source>
        <translation>Cambiar el voladizo de un lado</translation>
    </message>
    <message>
        <source>Draw a hole</source>
        <translation>Dibujar un hueco</translation>
    </message>
    <message>
        <source>Draw an obstacle</source>
        <translation>Dibujar un obstáculo</translation>
    </message>
    <message>
        <source>Obstacle %1</source>
        <translation>Obstáculo %1</translation>
    </message>
    <message>
        <source>Add a gate</source>
        <translation>Añadir una entrada</translation>
    </message>
    <message>
        <source>Gate %1</source>
        <translation>Entrada %1</translation>
    </message>
    <message>
        <source>Draw a guidance curve</source>
        <translation>Dibujar una curva de guiado</translation>
    </message>
    <message>
        <source>Draw an AB line</source>
        <translation>Dibujar una línea AB</translation>
    </message>
    <message>
        <source>Delete a point</source>
        <translation>Eliminar un punto</translation>
    </message>
    <message>
        <source>Delete a hole</source>
        <translation>Eliminar un hueco</translation>
    </message>
    <message>
        <source>Delete an obstacle</source>
        <translation>Eliminar un obstáculo</translation>
    </message>
    <message>
        <source>Delete a gate</source>
        <translation>Eliminar una entrada</translation>
    </message>
    <message>
        <source>Delete the guidance line</source>
        <translation>Eliminar la línea de guiado</translation>
    </message>
    <message>
        <source>Make steps straight</source>
        <translation>Enderezar escalones</translation>
    </message>
    <message>
        <source>Made straight, it would be refused: %1; %2.</source>
        <translation>Enderezado, se rechazaría: %1; %2.</translation>
    </message>
    <message numerus="yes">
        <source>%n field(s) stay as they are: %1.</source>
        <translation>
            <numerusform>%n parcela queda como está: %1.</numerusform>
            <numerusform>%n parcelas quedan como están: %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Mover</translation>
    </message>
    <message>
        <source>Change a length</source>
        <translation>Cambiar una longitud</translation>
    </message>
    <message>
        <source>Change a direction</source>
        <translation>Cambiar una dirección</translation>
    </message>
    <message>
        <source>Let the obstacle be driven on</source>
        <translation>Permitir pasar sobre el obstáculo</translation>
    </message>
    <message>
        <source>Keep off the obstacle</source>
        <translation>No pasar sobre el obstáculo</translation>
    </message>
    <message>
        <source>Change the gate</source>
        <translation>Cambiar la entrada</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Renombrar</translation>
    </message>
    <message>
        <source>AB line along an edge</source>
        <translation>Línea AB a lo largo de un lado</translation>
    </message>
    <message>
        <source>Draw a split line</source>
        <translation>Dibujar una línea de división</translation>
    </message>
    <message>
        <source>Delete a split line</source>
        <translation>Eliminar una línea de división</translation>
    </message>
</context>
<context>
    <name>furrow::FieldFromTrack</name>
    <message numerus="yes">
        <source>%n position(s)</source>
        <translation>
            <numerusform>%n posición</numerusform>
            <numerusform>%n posiciones</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n track(s)</source>
        <translation>
            <numerusform>%n recorrido</numerusform>
            <numerusform>%n recorridos</numerusform>
        </translation>
    </message>
    <message>
        <source>The pieces do not touch: each becomes a field of its own.</source>
        <translation>Los trozos no se tocan: cada uno será una parcela propia.</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Superficie</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>Trozos</translation>
    </message>
    <message>
        <source>Holes</source>
        <translation>Huecos</translation>
    </message>
    <message>
        <source>Points of the boundary</source>
        <translation>Puntos del límite</translation>
    </message>
    <message>
        <source>Around the field</source>
        <translation>Alrededor de la parcela</translation>
    </message>
    <message>
        <source>Over the whole field, at work</source>
        <translation>Por toda la parcela, trabajando</translation>
    </message>
    <message>
        <source>As it looks: around the field</source>
        <translation>Según parece: alrededor de la parcela</translation>
    </message>
    <message>
        <source>As it looks: over the field</source>
        <translation>Según parece: por la parcela</translation>
    </message>
    <message>
        <source>As it looks</source>
        <translation>Según parece</translation>
    </message>
</context>
<context>
    <name>furrow::FieldOpener</name>
    <message numerus="yes">
        <source>%n file(s)</source>
        <translation>
            <numerusform>%n archivo</numerusform>
            <numerusform>%n archivos</numerusform>
        </translation>
    </message>
    <message>
        <source>Add field %1</source>
        <translation>Añadir la parcela %1</translation>
    </message>
    <message numerus="yes">
        <source>Add %n field(s)</source>
        <translation>
            <numerusform>Añadir %n parcela</numerusform>
            <numerusform>Añadir %n parcelas</numerusform>
        </translation>
    </message>
    <message>
        <source>Field %1</source>
        <translation>Parcela %1</translation>
    </message>
    <message>
        <source>drawn on the map</source>
        <translation>dibujada en el mapa</translation>
    </message>
</context>
<context>
    <name>furrow::FiguresModel</name>
    <message>
        <source>Area</source>
        <translation>Superficie</translation>
    </message>
    <message>
        <source>Of the field, holes and obstacles taken out</source>
        <translation>De la parcela, sin huecos ni obstáculos</translation>
    </message>
    <message>
        <source>Inside the headland</source>
        <translation>Interior de la parcela</translation>
    </message>
    <message>
        <source>What is left inside the headland</source>
        <translation>Lo que queda dentro de la cabecera</translation>
    </message>
    <message>
        <source>Swaths</source>
        <translation>Pasadas</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Recorrido</translation>
    </message>
    <message>
        <source>Everything that is driven</source>
        <translation>Todo lo que se recorre</translation>
    </message>
    <message>
        <source>Working</source>
        <translation>Trabajo</translation>
    </message>
    <message>
        <source>Turning</source>
        <translation>Giros</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tiempo</translation>
    </message>
    <message>
        <source>Covered</source>
        <translation>Trabajado</translation>
    </message>
    <message>
        <source>Share of the field that is worked, measured on the finished path</source>
        <translation>Parte de la parcela trabajada, medida en el recorrido terminado</translation>
    </message>
    <message>
        <source>Overlap</source>
        <translation>Solape</translation>
    </message>
    <message>
        <source>Share of the field that is worked twice</source>
        <translation>Parte de la parcela trabajada dos veces</translation>
    </message>
    <message>
        <source>Land that is not worked</source>
        <translation>Terreno que no se trabaja</translation>
    </message>
    <message>
        <source>%1 cannot be reached by the implement, mostly in corners; %2 could be.</source>
        <translation>A %1 no llega el apero, casi siempre en esquinas; a %2 podría llegar.</translation>
    </message>
    <message>
        <source>Missed</source>
        <translation>Sin trabajar</translation>
    </message>
    <message>
        <source>Outside the field</source>
        <translation>Fuera de la parcela</translation>
    </message>
    <message>
        <source>Ground outside that the machine or its implement drives over</source>
        <translation>Suelo de fuera por el que pasa la máquina o su apero</translation>
    </message>
</context>
<context>
    <name>furrow::FileBrowser</name>
    <message>
        <source>This folder cannot be read.</source>
        <translation>Esta carpeta no se puede leer.</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Carpeta personal</translation>
    </message>
    <message>
        <source>Documents</source>
        <translation>Documentos</translation>
    </message>
    <message>
        <source>Downloads</source>
        <translation>Descargas</translation>
    </message>
    <message>
        <source>Desktop</source>
        <translation>Escritorio</translation>
    </message>
    <message>
        <source>Computer</source>
        <translation>Equipo</translation>
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
        <translation>ningún problema</translation>
    </message>
    <message numerus="yes">
        <source>%n problem(s)</source>
        <translation>
            <numerusform>%n problema</numerusform>
            <numerusform>%n problemas</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 → %2. Before: %3. Now: %4.</source>
        <translation>%1 → %2. Antes: %3. Ahora: %4.</translation>
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
        <translation>no cabe ninguna pasada</translation>
    </message>
    <message numerus="yes">
        <source>%n swath(s)</source>
        <translation>
            <numerusform>%n pasada</numerusform>
            <numerusform>%n pasadas</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 turning</source>
        <translation>%1 en giros</translation>
    </message>
    <message>
        <source>%1 twice</source>
        <translation>%1 dos veces</translation>
    </message>
    <message>
        <source>%1 missed</source>
        <translation>%1 sin trabajar</translation>
    </message>
    <message>
        <source>Swaths along %1</source>
        <translation>Pasadas en dirección %1</translation>
    </message>
    <message>
        <source>Search the heading</source>
        <translation>Buscar la dirección</translation>
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
        <translation>Añadir %1</translation>
    </message>
    <message>
        <source>Add imagery</source>
        <translation>Añadir imágenes</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>Quitar %1</translation>
    </message>
    <message>
        <source>Move a layer</source>
        <translation>Mover una capa</translation>
    </message>
    <message>
        <source>Rename a layer</source>
        <translation>Renombrar una capa</translation>
    </message>
    <message>
        <source>Show a layer</source>
        <translation>Mostrar una capa</translation>
    </message>
    <message>
        <source>Hide a layer</source>
        <translation>Ocultar una capa</translation>
    </message>
    <message>
        <source>Change how strong a layer is</source>
        <translation>Cambiar la opacidad de una capa</translation>
    </message>
    <message>
        <source>Turn the rows of tiles round</source>
        <translation>Invertir el orden de las filas de teselas</translation>
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
        <translation>Máquina</translation>
    </message>
    <message>
        <source>machine</source>
        <translation>máquina</translation>
    </message>
</context>
<context>
    <name>furrow::OrderModel</name>
    <message>
        <source>Order number</source>
        <translation>N.º de la orden</translation>
    </message>
    <message>
        <source>Customer</source>
        <translation>Cliente</translation>
    </message>
    <message>
        <source>Field address</source>
        <translation>Ubicación de la parcela</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>Operario</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Horario</translation>
    </message>
    <message>
        <source>Product</source>
        <translation>Producto</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Dosis</translation>
    </message>
    <message>
        <source>Unit of the rate</source>
        <translation>Unidad de la dosis</translation>
    </message>
    <message>
        <source>Area worked</source>
        <translation>Superficie trabajada</translation>
    </message>
    <message>
        <source>Hours worked</source>
        <translation>Horas trabajadas</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Observaciones</translation>
    </message>
    <message>
        <source>%1 per acre</source>
        <translation>%1 por acre</translation>
    </message>
    <message>
        <source>%1 per hectare</source>
        <translation>%1 por hectárea</translation>
    </message>
    <message>
        <source>Change the work order</source>
        <translation>Cambiar la orden de trabajo</translation>
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
            <numerusform>%n lugar en el mapa</numerusform>
            <numerusform>%n lugares en el mapa</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>a line of %n point(s)</source>
        <translation>
            <numerusform>una línea de %n punto</numerusform>
            <numerusform>una línea de %n puntos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n line(s)</source>
        <translation>
            <numerusform>%n línea</numerusform>
            <numerusform>%n líneas</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>furrow::PlanChange</name>
    <message>
        <source>time %1</source>
        <translation>tiempo %1</translation>
    </message>
    <message>
        <source>path %1</source>
        <translation>recorrido %1</translation>
    </message>
    <message>
        <source>covered %1</source>
        <translation>trabajado %1</translation>
    </message>
    <message>
        <source>worked twice %1</source>
        <translation>trabajado dos veces %1</translation>
    </message>
    <message>
        <source>With the last change: the same time, length and area.</source>
        <translation>Con el último cambio: el mismo tiempo, longitud y superficie.</translation>
    </message>
    <message>
        <source>With the last change: %1</source>
        <translation>Con el último cambio: %1</translation>
    </message>
</context>
<context>
    <name>furrow::PlanComparison</name>
    <message>
        <source>Time</source>
        <translation>Tiempo</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Recorrido</translation>
    </message>
    <message>
        <source>Working</source>
        <translation>Trabajo</translation>
    </message>
    <message>
        <source>Turning</source>
        <translation>Giros</translation>
    </message>
    <message>
        <source>Swaths</source>
        <translation>Pasadas</translation>
    </message>
    <message>
        <source>Covered</source>
        <translation>Trabajado</translation>
    </message>
    <message>
        <source>Missed</source>
        <translation>Sin trabajar</translation>
    </message>
    <message>
        <source>Overlap</source>
        <translation>Solape</translation>
    </message>
    <message>
        <source>Outside the field</source>
        <translation>Fuera de la parcela</translation>
    </message>
    <message>
        <source>In reverse</source>
        <translation>Marcha atrás</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Problemas</translation>
    </message>
    <message>
        <source>The standard settings</source>
        <translation>Los ajustes estándar</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Máquina</translation>
    </message>
    <message>
        <source>All swaths lie in the same places.</source>
        <translation>Todas las pasadas están en los mismos sitios.</translation>
    </message>
    <message numerus="yes">
        <source>%n swath(s) of the other plan lie elsewhere.</source>
        <translation>
            <numerusform>%n pasada del otro plan está en otro sitio.</numerusform>
            <numerusform>%n pasadas del otro plan están en otros sitios.</numerusform>
        </translation>
    </message>
    <message>
        <source>Take the standard settings</source>
        <translation>Tomar los ajustes estándar</translation>
    </message>
    <message>
        <source>Inside the headland</source>
        <translation>Interior de la parcela</translation>
    </message>
    <message>
        <source>Headland passes: %1 only in this plan, %2 only in the other.</source>
        <translation>Pasadas de cabecera: %1 solo en este plan, %2 solo en el otro.</translation>
    </message>
    <message>
        <source>Turns and ways: %1 only in this plan, %2 only in the other.</source>
        <translation>Giros y trayectos: %1 solo en este plan, %2 solo en el otro.</translation>
    </message>
    <message>
        <source>All headland passes lie in the same places.</source>
        <translation>Todas las pasadas de cabecera están en los mismos lugares.</translation>
    </message>
    <message>
        <source>All turns and ways lie in the same places.</source>
        <translation>Todos los giros y trayectos están en los mismos lugares.</translation>
    </message>
</context>
<context>
    <name>furrow::Planning</name>
    <message>
        <source>Change the machine</source>
        <translation>Cambiar la máquina</translation>
    </message>
    <message>
        <source>Reading %1 …</source>
        <translation>Leyendo %1…</translation>
    </message>
    <message numerus="yes">
        <source>%n field(s) in this file</source>
        <translation>
            <numerusform>%n parcela en este archivo</numerusform>
            <numerusform>%n parcelas en este archivo</numerusform>
        </translation>
    </message>
    <message>
        <source>Planning …</source>
        <translation>Planificando…</translation>
    </message>
    <message>
        <source>No plan</source>
        <translation>Sin plan</translation>
    </message>
    <message>
        <source>Plan ready · %1 ms</source>
        <translation>Plan listo · %1 ms</translation>
    </message>
    <message>
        <source>Plan ready · %1 s</source>
        <translation>Plan listo · %1 s</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>Change: %1</source>
        <translation>Cambiar: %1</translation>
    </message>
    <message>
        <source>Draft · planning …</source>
        <translation>Borrador · planificando…</translation>
    </message>
    <message>
        <source>Draft · the whole plan follows when you let go</source>
        <translation>Borrador · el plan completo llega al soltar</translation>
    </message>
    <message>
        <source>Out of date · this is a draft</source>
        <translation>Desactualizado · esto es un borrador</translation>
    </message>
    <message>
        <source>Out of date · this is the plan before the change</source>
        <translation>Desactualizado · este es el plan anterior al cambio</translation>
    </message>
    <message>
        <source>Stopped · there is no plan</source>
        <translation>Detenido · no hay plan</translation>
    </message>
    <message numerus="yes">
        <source>%n problem(s)</source>
        <translation>
            <numerusform>%n problema</numerusform>
            <numerusform>%n problemas</numerusform>
        </translation>
    </message>
    <message>
        <source>Out of date · this is a first plan</source>
        <translation>Desactualizado · esto es un primer plan</translation>
    </message>
    <message>
        <source>First plan · being improved …</source>
        <translation>Primer plan · mejorándolo…</translation>
    </message>
    <message>
        <source>First plan · comparing plan %1 …</source>
        <translation>Primer plan · comparando plan %1…</translation>
    </message>
    <message>
        <source>Planning … · comparing plan %1</source>
        <translation>Planificando… · comparando plan %1</translation>
    </message>
</context>
<context>
    <name>furrow::Printing</name>
    <message>
        <source>There is no field yet, and no plan to print.</source>
        <translation>Todavía no hay parcela ni plan que imprimir.</translation>
    </message>
    <message>
        <source>The plan is still being made. It can be printed when it is finished.</source>
        <translation>El plan aún se está haciendo. Se podrá imprimir cuando esté listo.</translation>
    </message>
    <message>
        <source>The plan is out of date. Plan again to print it.</source>
        <translation>El plan está desactualizado. Vuelva a planificar para imprimirlo.</translation>
    </message>
    <message>
        <source>There is no plan to print. The message on the map says why.</source>
        <translation>No hay plan que imprimir. El mensaje del mapa dice por qué.</translation>
    </message>
    <message>
        <source>Work order</source>
        <translation>Orden de trabajo</translation>
    </message>
    <message>
        <source>Work orders</source>
        <translation>Órdenes de trabajo</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Escrito: %1</translation>
    </message>
    <message>
        <source>The printer %1 did not take the pages.</source>
        <translation>La impresora %1 no aceptó las páginas.</translation>
    </message>
    <message>
        <source>Look whether it is on, or save a PDF and print that.</source>
        <translation>Compruebe si está encendida, o guarde un PDF e imprímalo.</translation>
    </message>
    <message>
        <source>Sent to %1</source>
        <translation>Enviado a %1</translation>
    </message>
</context>
<context>
    <name>furrow::ProjectFiles</name>
    <message>
        <source>Your last work was not saved. Here it is again.</source>
        <translation>El último trabajo no se guardó. Aquí está de nuevo.</translation>
    </message>
    <message>
        <source>Changes of “%1” were not saved. Here they are again.</source>
        <translation>Los cambios de «%1» no se guardaron. Aquí están de nuevo.</translation>
    </message>
    <message>
        <source>It is kept in the file all the same.</source>
        <translation>De todos modos se conserva en el archivo.</translation>
    </message>
    <message>
        <source>Restore changes that were not saved</source>
        <translation>Recuperar cambios no guardados</translation>
    </message>
    <message>
        <source>Another program changed “%1” while changes of yours were not saved. Yours are shown; undo shows the file.</source>
        <translation>Otro programa cambió «%1» mientras había cambios suyos sin guardar. Se muestran los suyos; deshacer muestra el archivo.</translation>
    </message>
    <message>
        <source>Another program has changed “%1” since it was opened here.</source>
        <translation>Otro programa ha cambiado «%1» desde que se abrió aquí.</translation>
    </message>
    <message>
        <source>Save over it, or save yours under another name.</source>
        <translation>Sobrescríbalo o guarde el suyo con otro nombre.</translation>
    </message>
    <message>
        <source>Farm</source>
        <translation>Explotación</translation>
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
        <translation>Esto no es una longitud. Escriba por ejemplo 7,3 m, 24 ft o 10&apos;6&quot;.</translation>
    </message>
    <message>
        <source>This is not an area. Type it like 12.5 ha or 30 ac.</source>
        <translation>Esto no es una superficie. Escriba por ejemplo 12,5 ha o 30 ac.</translation>
    </message>
    <message>
        <source>This is not a speed. Type it like 8 km/h or 5 mph.</source>
        <translation>Esto no es una velocidad. Escriba por ejemplo 8 km/h o 5 mph.</translation>
    </message>
    <message>
        <source>This is not an angle. Type it in degrees, like 87.5.</source>
        <translation>Esto no es un ángulo. Escríbalo en grados, por ejemplo 87,5.</translation>
    </message>
    <message>
        <source>This is not a number.</source>
        <translation>Esto no es un número.</translation>
    </message>
    <message>
        <source>This is not a whole number.</source>
        <translation>Esto no es un número entero.</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>Type something from %1 to %2.</source>
        <translation>Escriba un valor de %1 a %2.</translation>
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
        <translation>Esto no es un tiempo. Escríbalo como 45 s o 2 min.</translation>
    </message>
</context>
<context>
    <name>furrow::RecentFiles</name>
    <message numerus="yes">
        <source>%n field(s)</source>
        <translation>
            <numerusform>%n parcela</numerusform>
            <numerusform>%n parcelas</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>furrow::ReviewModel</name>
    <message>
        <source>Only a finished plan of what the panels show can be sent.</source>
        <translation>Solo se puede enviar un plan terminado de lo que muestran los paneles.</translation>
    </message>
    <message>
        <source>Approved: %1</source>
        <translation>Aprobado: %1</translation>
    </message>
    <message>
        <source>Changes wanted: %1</source>
        <translation>Se piden cambios: %1</translation>
    </message>
    <message>
        <source>Send back…</source>
        <translation>Devolver…</translation>
    </message>
    <message>
        <source>Send on…</source>
        <translation>Reenviar…</translation>
    </message>
    <message>
        <source>Send for review…</source>
        <translation>Enviar a revisión…</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>Comentario</translation>
    </message>
    <message>
        <source>Remove a comment</source>
        <translation>Quitar un comentario</translation>
    </message>
    <message>
        <source>Settle a comment</source>
        <translation>Resolver un comentario</translation>
    </message>
    <message>
        <source>Open a comment again</source>
        <translation>Reabrir un comentario</translation>
    </message>
    <message>
        <source>Approve the plan</source>
        <translation>Aprobar el plan</translation>
    </message>
    <message>
        <source>Ask for changes</source>
        <translation>Pedir cambios</translation>
    </message>
    <message>
        <source>Take the verdict back</source>
        <translation>Retirar el veredicto</translation>
    </message>
    <message>
        <source>review</source>
        <translation>revisión</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Send for review</source>
        <translation>Enviar a revisión</translation>
    </message>
    <message>
        <source>Written: %1. Whoever has Furrow can open it, comment on it and send it back.</source>
        <translation>Escrito: %1. Quien tenga Furrow puede abrirlo, comentarlo y devolverlo.</translation>
    </message>
    <message>
        <source>Take in a review</source>
        <translation>Incorporar una revisión</translation>
    </message>
    <message numerus="yes">
        <source>%n new comment(s)</source>
        <translation>
            <numerusform>%n comentario nuevo</numerusform>
            <numerusform>%n comentarios nuevos</numerusform>
        </translation>
    </message>
    <message>
        <source>The review was brought up to date</source>
        <translation>La revisión se ha actualizado</translation>
    </message>
    <message>
        <source>Nothing new in this review</source>
        <translation>Nada nuevo en esta revisión</translation>
    </message>
    <message>
        <source>%1. The plan has changed since it was sent.</source>
        <translation>%1. El plan ha cambiado desde que se envió.</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1.</translation>
    </message>
    <message>
        <source>Edit a comment</source>
        <translation>Editar un comentario</translation>
    </message>
</context>
<context>
    <name>furrow::StepsModel</name>
    <message numerus="yes">
        <source>%1 but for %n edge(s)</source>
        <translation>
            <numerusform>%1 salvo en %n lado</numerusform>
            <numerusform>%1 salvo en %n lados</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 inside</source>
        <translation>interior %1</translation>
    </message>
    <message numerus="yes">
        <source>%n pass(es)</source>
        <translation>
            <numerusform>%n pasada</numerusform>
            <numerusform>%n pasadas</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n block(s)</source>
        <translation>
            <numerusform>%n subparcela</numerusform>
            <numerusform>%n subparcelas</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n swath(s)</source>
        <translation>
            <numerusform>%n pasada</numerusform>
            <numerusform>%n pasadas</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 with turns on the spot</source>
        <translation>%1 con giros en el sitio</translation>
    </message>
    <message numerus="yes">
        <source>%n turn(s)</source>
        <translation>
            <numerusform>%n giro</numerusform>
            <numerusform>%n giros</numerusform>
        </translation>
    </message>
    <message>
        <source>No usable boundary</source>
        <translation>Sin límite utilizable</translation>
    </message>
    <message>
        <source>No field yet</source>
        <translation>Aún no hay parcela</translation>
    </message>
    <message numerus="yes">
        <source>%n obstacle(s)</source>
        <translation>
            <numerusform>%n obstáculo</numerusform>
            <numerusform>%n obstáculos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n hole(s)</source>
        <translation>
            <numerusform>%n hueco</numerusform>
            <numerusform>%n huecos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n boundary point(s)</source>
        <translation>
            <numerusform>%n punto del límite</numerusform>
            <numerusform>%n puntos del límite</numerusform>
        </translation>
    </message>
    <message>
        <source>The message on the map says why</source>
        <translation>El mensaje del mapa dice por qué</translation>
    </message>
    <message>
        <source>Open a file or draw a boundary</source>
        <translation>Abra un archivo o dibuje un límite</translation>
    </message>
    <message>
        <source>%1 wide</source>
        <translation>%1 de ancho</translation>
    </message>
    <message>
        <source>%1 radius</source>
        <translation>%1 de radio</translation>
    </message>
    <message>
        <source>Field</source>
        <translation>Parcela</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Máquina</translation>
    </message>
    <message numerus="yes">
        <source>%n problem(s)</source>
        <translation>
            <numerusform>%n problema</numerusform>
            <numerusform>%n problemas</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing to check yet</source>
        <translation>Nada que comprobar todavía</translation>
    </message>
    <message>
        <source>Planning …</source>
        <translation>Planificando…</translation>
    </message>
    <message>
        <source>No plan</source>
        <translation>Sin plan</translation>
    </message>
    <message>
        <source>Out of date</source>
        <translation>Desactualizado</translation>
    </message>
    <message>
        <source>Plan again to check what the panels show</source>
        <translation>Planificar de nuevo para comprobar esto</translation>
    </message>
    <message>
        <source>No problems</source>
        <translation>Sin problemas</translation>
    </message>
    <message numerus="yes">
        <source>%n note(s)</source>
        <translation>
            <numerusform>%n aviso</numerusform>
            <numerusform>%n avisos</numerusform>
        </translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Comprobación</translation>
    </message>
    <message>
        <source>proved: no order is better</source>
        <translation>el mejor, demostrado</translation>
    </message>
    <message>
        <source>turns within %1 of the best</source>
        <translation>giros: +%1 como mucho</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>To a stick, to files or on paper</source>
        <translation>A memoria USB, archivos o papel</translation>
    </message>
    <message>
        <source>No plan to export yet</source>
        <translation>Aún no hay plan que exportar</translation>
    </message>
    <message>
        <source>Waits for the finished plan</source>
        <translation>Espera el plan terminado</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportar</translation>
    </message>
    <message>
        <source>First plan, being improved</source>
        <translation>Primer plan, se está mejorando</translation>
    </message>
    <message>
        <source>Only the finished plan is checked</source>
        <translation>Solo se comprueba el plan terminado</translation>
    </message>
    <message>
        <source>Until then the map shows the plan before</source>
        <translation>Hasta entonces el mapa muestra el plan anterior</translation>
    </message>
</context>
<context>
    <name>furrow::StickExport</name>
    <message>
        <source>%1 free of %2</source>
        <translation>%1 libres de %2</translation>
    </message>
    <message>
        <source>Writing …</source>
        <translation>Escribiendo…</translation>
    </message>
    <message>
        <source>every byte was read back, and the plan read from there is this plan.</source>
        <translation>se ha releído cada byte, y el plan leído de ahí es este plan.</translation>
    </message>
    <message>
        <source>every byte was read back and is as written.</source>
        <translation>se ha releído cada byte y está como se escribió.</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Escrito: %1</translation>
    </message>
    <message>
        <source>Safe to unplug: %1</source>
        <translation>Ya puede retirar la memoria USB: %1</translation>
    </message>
    <message>
        <source>What was there before is kept as %1.</source>
        <translation>Lo que había antes se conserva como %1.</translation>
    </message>
    <message>
        <source>Writing was stopped, because the plan was changed meanwhile.</source>
        <translation>Se detuvo la escritura porque el plan cambió mientras tanto.</translation>
    </message>
    <message>
        <source>Write it again when the plan is finished.</source>
        <translation>Escríbalo de nuevo cuando el plan esté listo.</translation>
    </message>
    <message>
        <source>every byte was read back, and the fields read from there are these.</source>
        <translation>se ha releído cada byte, y las parcelas leídas de ahí son estas.</translation>
    </message>
</context>
<context>
    <name>furrow::SwathOrder</name>
    <message>
        <source>Search the order of the other swaths</source>
        <translation>Buscar el orden de las demás pasadas</translation>
    </message>
    <message>
        <source>Search the order</source>
        <translation>Buscar el orden</translation>
    </message>
    <message>
        <source>Change the order of swaths</source>
        <translation>Cambiar el orden de las pasadas</translation>
    </message>
</context>
<context>
    <name>furrow::TroubleReport</name>
    <message>
        <source>The report could not be written: %1</source>
        <translation>No se pudo escribir el informe: %1</translation>
    </message>
    <message>
        <source>The report is in %1.</source>
        <translation>El informe está en %1.</translation>
    </message>
</context>
</TS>
