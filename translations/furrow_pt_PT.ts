<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="pt_PT" sourcelanguage="en">
<context>
    <name>DrawingNotice</name>
    <message>
        <source>The map cannot show fields and plans: this window is drawn without OpenGL.</source>
        <translation>O mapa não pode mostrar talhões nem planos: esta janela é desenhada sem OpenGL.</translation>
    </message>
    <message>
        <source>Install a graphics driver with OpenGL; Mesa draws on any processor. The command line plans and exports all the same.</source>
        <translation>Instale um controlador gráfico com OpenGL; o Mesa desenha em qualquer processador. A linha de comandos planeia e exporta mesmo assim.</translation>
    </message>
</context>
<context>
    <name>EditCommands</name>
    <message>
        <source>Delete what is selected</source>
        <translation>Eliminar a seleção</translation>
    </message>
</context>
<context>
    <name>EmptyState</name>
    <message>
        <source>Open its boundary, or drop the file anywhere on this window. Shapefile, GeoJSON, KML, GeoPackage, GML and others are understood, zipped or not.</source>
        <translation>Abra o limite ou solte o ficheiro em qualquer parte desta janela. Shapefile, GeoJSON, KML, GeoPackage, GML e outros são lidos, comprimidos ou não.</translation>
    </message>
    <message>
        <source>Open a file…</source>
        <translation>Abrir um ficheiro…</translation>
    </message>
</context>
<context>
    <name>ExportChecks</name>
    <message>
        <source>Choose another format or terminal, and report this.</source>
        <translation>Escolha outro formato ou terminal e comunique isto.</translation>
    </message>
    <message numerus="yes">
        <source>The files were looked through for %n kind(s) of mistakes that receivers stumble over; there is none.</source>
        <translation>
            <numerusform>Os ficheiros foram examinados quanto a %n tipo de erro em que os recetores tropeçam; não há nenhum.</numerusform>
            <numerusform>Os ficheiros foram examinados quanto a %n tipos de erros em que os recetores tropeçam; não há nenhum.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ExportDialog</name>
    <message>
        <source>USB stick</source>
        <translation>Pen USB</translation>
    </message>
    <message>
        <source>Files in a folder</source>
        <translation>Ficheiros em uma pasta</translation>
    </message>
    <message>
        <source>Writing …</source>
        <translation>A gravar…</translation>
    </message>
    <message>
        <source>Write to the stick</source>
        <translation>Gravar na pen USB</translation>
    </message>
    <message>
        <source>Write files</source>
        <translation>Gravar os ficheiros</translation>
    </message>
    <message>
        <source>Plan again</source>
        <translation>Planear de novo</translation>
    </message>
    <message numerus="yes">
        <source>%n problem(s) in this plan: it cannot be driven as drawn. The files say so too.</source>
        <translation>
            <numerusform>%n problema neste plano: não pode ser percorrido como está. Os ficheiros também dizem isso.</numerusform>
            <numerusform>%n problemas neste plano: não pode ser percorrido como está. Os ficheiros também dizem isso.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ExportStickPage</name>
    <message>
        <source>Stick</source>
        <translation>Pen USB</translation>
    </message>
    <message>
        <source>No USB stick is plugged in. It appears here when it is; or choose a folder to carry the files yourself.</source>
        <translation>Nenhuma pen USB ligada. Aparece aqui quando for ligada; ou escolha uma pasta para levar os ficheiros por conta própria.</translation>
    </message>
    <message>
        <source>Folder in the place of a stick</source>
        <translation>Pasta no lugar de uma pen USB</translation>
    </message>
    <message>
        <source>Also in a task, for terminals that show lines in tasks only</source>
        <translation>Também numa tarefa, se o terminal o exigir</translation>
    </message>
</context>
<context>
    <name>FieldActions</name>
    <message>
        <source>Open file…</source>
        <translation>Abrir ficheiro…</translation>
    </message>
</context>
<context>
    <name>FieldCommands</name>
    <message>
        <source>pond tree pole wet</source>
        <translation>lagoa árvore poste húmido</translation>
    </message>
    <message>
        <source>delete</source>
        <translation>eliminar</translation>
    </message>
</context>
<context>
    <name>FileCommands</name>
    <message>
        <source>File</source>
        <translation>Ficheiro</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Guardar</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Guardar como…</translation>
    </message>
</context>
<context>
    <name>FilesNotice</name>
    <message>
        <source>Save as…</source>
        <translation>Guardar como…</translation>
    </message>
</context>
<context>
    <name>HelpCommands</name>
    <message>
        <source>Keys and mouse</source>
        <translation>Teclas e rato</translation>
    </message>
</context>
<context>
    <name>ImageryDialogs</name>
    <message>
        <source>All files (*)</source>
        <translation>Todos os ficheiros (*)</translation>
    </message>
</context>
<context>
    <name>ImageryList</name>
    <message>
        <source>Add files…</source>
        <translation>Adicionar ficheiros…</translation>
    </message>
    <message>
        <source>Your own pictures and heights: GeoTIFF, MBTiles or a folder of tiles. They stay on this computer.</source>
        <translation>As suas próprias imagens e altitudes: GeoTIFF, MBTiles ou uma pasta de blocos. Ficam neste computador.</translation>
    </message>
</context>
<context>
    <name>ImageryRow</name>
    <message>
        <source>Opening …</source>
        <translation>A abrir…</translation>
    </message>
</context>
<context>
    <name>Inspector</name>
    <message>
        <source>%1 with the implement up, in %2.</source>
        <translation>%1 com a alfaia levantada, em %2.</translation>
    </message>
    <message>
        <source>The swaths lie beside it. Drag its points, or delete it.</source>
        <translation>As passadas ficam ao lado. Arraste os pontos ou elimine a curva.</translation>
    </message>
    <message>
        <source>The mainland is cut along it, where it runs right through. Drag it or its points, or delete it.</source>
        <translation>O interior é dividido ao longo dela onde ela o atravessa por inteiro. Arraste a linha ou os pontos, ou elimine-a.</translation>
    </message>
    <message>
        <source>%1 with the implement folded, in %2.</source>
        <translation>%1 com a alfaia dobrada, em %2.</translation>
    </message>
</context>
<context>
    <name>InspectorPanel</name>
    <message>
        <source>Delete</source>
        <translation>Eliminar</translation>
    </message>
</context>
<context>
    <name>KeysDialog</name>
    <message>
        <source>Keys and mouse</source>
        <translation>Teclas e rato</translation>
    </message>
</context>
<context>
    <name>PlanCommands</name>
    <message>
        <source>delete</source>
        <translation>eliminar</translation>
    </message>
    <message>
        <source>Plan again</source>
        <translation>Planear de novo</translation>
    </message>
</context>
<context>
    <name>PlanTitle</name>
    <message>
        <source>planned %1</source>
        <translation>planeado em %1</translation>
    </message>
</context>
<context>
    <name>Planner</name>
    <message>
        <source>%1 are driven in reverse; the trailed implement cannot.</source>
        <translation>%1 são percorridos de ré; a alfaia rebocada não consegue.</translation>
    </message>
    <message>
        <source>%1 is on the stick already</source>
        <translation>%1 já está na pen USB</translation>
    </message>
    <message>
        <source>%1 is planned, but nothing of it is driven with the implement down.</source>
        <translation>%1 está prevista, mas nada dela é percorrido com a alfaia abaixada.</translation>
    </message>
    <message>
        <source>%1 is planned, but only %2 of it is driven with the implement down.</source>
        <translation>%1 está prevista, mas só %2 dela é percorrido com a alfaia abaixada.</translation>
    </message>
    <message>
        <source>%1 of its sentences have a wrong checksum</source>
        <translation>%1 das suas sentenças têm uma soma de verificação errada</translation>
    </message>
    <message>
        <source>%1, %2 is more than 1,000 km from the plan</source>
        <translation>%1, %2 está a mais de 1.000 km do plano</translation>
    </message>
    <message>
        <source>%1, %2 is no longitude and latitude, and the file does not say which coordinate system it uses</source>
        <translation>%1, %2 não é longitude e latitude, e o ficheiro não diz qual sistema de coordenadas usa</translation>
    </message>
    <message>
        <source>%1: the setting %2 is not used: %3</source>
        <translation>%1: a definição %2 não é usada: %3</translation>
    </message>
    <message numerus="yes">
        <source>%n areas in the file are neither field nor obstacle and were not used</source>
        <translation>
            <numerusform>%n área no ficheiro não é talhão nem obstáculo e não foi usada</numerusform>
            <numerusform>%n áreas no ficheiro não são talhão nem obstáculo e não foram usadas</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n records without a position were passed over</source>
        <translation>
            <numerusform>%n registo sem posição foi ignorado</numerusform>
            <numerusform>%n registos sem posição foram ignorados</numerusform>
        </translation>
    </message>
    <message>
        <source>&apos;%1&apos; files hold no recorded track</source>
        <translation>ficheiros “%1” não contêm nenhum percurso gravado</translation>
    </message>
    <message>
        <source>A file of lines: planted rows, or the tramlines of a plan.</source>
        <translation>Um ficheiro de linhas: fileiras plantadas ou os rastros de pulverização de um plano.</translation>
    </message>
    <message>
        <source>Boundaries, also field files of Fields2Cover and GAOS.</source>
        <translation>Limites, também ficheiros do Fields2Cover e GAOS.</translation>
    </message>
    <message>
        <source>Carried by the tractor, or pulled on a hitch and following its own track.</source>
        <translation>Montado no tractor, ou rebocado em um engate seguindo seu próprio rastro.</translation>
    </message>
    <message>
        <source>Combine harvester, 7.5 m header</source>
        <translation>Ceifeira-debulhadora, plataforma de 7,5 m</translation>
    </message>
    <message>
        <source>Cutting grass: headland first, swaths overlap a little.</source>
        <translation>Corte de erva: cabeceira primeiro, as passadas se sobrepõem um pouco.</translation>
    </message>
    <message>
        <source>Drives the path from waypoint to waypoint, rounding corners its own way; relay 1 is on where the implement works. Not tested on the machine by us.</source>
        <translation>Vai de ponto em ponto, arredondando cantos a seu modo; o relé 1 fica ligado onde a alfaia trabalha. Não testado por nós na máquina.</translation>
    </message>
    <message>
        <source>Drives the whole path, turns included, as a recorded path; stretches in reverse gear are left to the driver. Shows boundary, headland and guidance lines. Copy the field&apos;s folder to Documents/AgOpenGPS/Fields.</source>
        <translation>Percorre tudo, inclusive as manobras, como percurso gravado; os trechos de ré ficam para o condutor. Mostra limite, cabeceira e linhas de orientação. Copie a pasta do talhão para Documents/AgOpenGPS/Fields.</translation>
    </message>
    <message>
        <source>From the fixed axle to the tractor&apos;s rear end.</source>
        <translation>Do eixo fixo até a traseira do tractor.</translation>
    </message>
    <message>
        <source>From the tractor&apos;s nose to its rear end.</source>
        <translation>Da frente do tractor até a traseira.</translation>
    </message>
    <message>
        <source>How far a trailed implement may swing to one side.</source>
        <translation>Quanto uma alfaia rebocada pode virar para um lado.</translation>
    </message>
    <message>
        <source>How fast the curvature may change along the path; from the steering rate where it is not given.</source>
        <translation>Com que rapidez a curvatura pode mudar ao longo do percurso; da velocidade de direção onde não é dada.</translation>
    </message>
    <message>
        <source>Implement can reverse</source>
        <translation>A alfaia aceita ré</translation>
    </message>
    <message>
        <source>Implement length</source>
        <translation>Comprimento da alfaia</translation>
    </message>
    <message>
        <source>Implement offset</source>
        <translation>Posição da alfaia</translation>
    </message>
    <message>
        <source>Largest steering angle</source>
        <translation>Ângulo de direção máximo</translation>
    </message>
    <message>
        <source>Most terminals read FAT32 only; this stick has %1. Format it as FAT32.</source>
        <translation>A maioria dos terminais só lê FAT32; esta pen USB tem %1. Formate como FAT32.</translation>
    </message>
    <message>
        <source>Omega turn</source>
        <translation>Manobra em ómega</translation>
    </message>
    <message>
        <source>Orchard tractor with 1.5 m sprayer</source>
        <translation>Tractor de pomar com pulverizador de 1,5 m</translation>
    </message>
    <message>
        <source>Plan again with this machine&apos;s turning radius.</source>
        <translation>Planeie de novo com o raio de giro desta máquina.</translation>
    </message>
    <message>
        <source>Plan again, or trust the positions.</source>
        <translation>Planeie de novo ou confie nas posições.</translation>
    </message>
    <message>
        <source>Plan again; the heading or the gear is wrong here.</source>
        <translation>Planeie de novo; o rumo ou a marcha está errada aqui.</translation>
    </message>
    <message>
        <source>Plan again; the path lacks this pass.</source>
        <translation>Planeie de novo; falta esta passada no percurso.</translation>
    </message>
    <message>
        <source>Plan again; the path was changed or cut here.</source>
        <translation>Planeie de novo; o percurso foi alterado ou cortado aqui.</translation>
    </message>
    <message>
        <source>Plan again; the times were changed.</source>
        <translation>Planeie de novo; os tempos foram alterados.</translation>
    </message>
    <message>
        <source>Plan the turn that is missing here.</source>
        <translation>Planeie a manobra que falta aqui.</translation>
    </message>
    <message>
        <source>Raised width</source>
        <translation>Largura levantada</translation>
    </message>
    <message>
        <source>Relay 1 is on where the implement works.</source>
        <translation>O relé 1 fica ligado onde a alfaia trabalha.</translation>
    </message>
    <message>
        <source>Rows that are left out, numbered from 1 as in the file; between rows, that on the right.</source>
        <translation>Fileiras que ficam de fora, a partir de 1 como no ficheiro; entre fileiras, a da direita.</translation>
    </message>
    <message>
        <source>Shows the boundary and the guidance lines; it plans turns and order itself. Not tested on the machine by us.</source>
        <translation>Mostra o limite e as linhas de orientação; ele mesmo planeia manobras e ordem. Não testado por nós na máquina.</translation>
    </message>
    <message>
        <source>Shows the boundary with holes and obstacles and the guidance lines; it plans turns and order itself. The import may have to be unlocked. Not tested on the machine by us.</source>
        <translation>Mostra o limite com vazios e obstáculos e as linhas de orientação; ele mesmo planeia manobras e ordem. Talvez seja preciso desbloquear a importação. Não testado por nós na máquina.</translation>
    </message>
    <message>
        <source>Shows the boundary with holes and obstacles, the headland where the terminal knows it, and the guidance lines; it plans turns and order itself. The import may have to be unlocked. Not tested on the machine by us.</source>
        <translation>Mostra o limite com vazios e obstáculos, a cabeceira se o terminal a conhece, e as linhas de orientação; ele mesmo planeia manobras e ordem. Talvez seja preciso desbloquear a importação. Não testado por nós na máquina.</translation>
    </message>
    <message>
        <source>Six-row planter, 4.5 m</source>
        <translation>Plantador de seis fileiras, 4,5 m</translation>
    </message>
    <message>
        <source>Smallest circle the middle of the fixed axle can follow; from the steering angle where it is not given.</source>
        <translation>Menor círculo que o meio do eixo fixo consegue seguir; do ângulo de direção onde não é dado.</translation>
    </message>
    <message>
        <source>Speed on longer ways with the implement lifted.</source>
        <translation>Velocidade em deslocações longas com a alfaia levantada.</translation>
    </message>
    <message>
        <source>Speed with the implement at work.</source>
        <translation>Velocidade com a alfaia a trabalhar.</translation>
    </message>
    <message>
        <source>Steering rate</source>
        <translation>Velocidade de direção</translation>
    </message>
    <message>
        <source>Straight way needed before the implement is lowered.</source>
        <translation>Caminho reto necessário antes de abaixar a alfaia.</translation>
    </message>
    <message>
        <source>The boundary alone as a flat zipped shapefile, as operations centres take it.</source>
        <translation>Só o limite como shapefile comprimido plano, como aceitam os centros de operações.</translation>
    </message>
    <message>
        <source>The path as a mission for ArduPilot Rover: waypoints, speeds, gear, implement.</source>
        <translation>O percurso como missão para ArduPilot Rover: pontos, velocidades, marcha, alfaia.</translation>
    </message>
    <message>
        <source>The path as a track, swath ends as a route, gates as waypoints; for phones.</source>
        <translation>O percurso como trilha, pontas das passadas como rota, entradas como pontos; para telemóveis.</translation>
    </message>
    <message>
        <source>The same as KML, zipped.</source>
        <translation>O mesmo que KML, comprimido.</translation>
    </message>
    <message>
        <source>The tractor may drive backwards with it.</source>
        <translation>O tractor pode dar ré com ele.</translation>
    </message>
    <message>
        <source>The tractor may drive backwards.</source>
        <translation>O tractor pode andar de ré.</translation>
    </message>
    <message>
        <source>The tractor may turn about its own middle.</source>
        <translation>O tractor pode girar sobre o próprio centro.</translation>
    </message>
    <message>
        <source>This stick has %1 partitions; terminals see the first one only, if any.</source>
        <translation>Esta pen USB tem %1 partições; os terminais veem no máximo a primeira.</translation>
    </message>
    <message>
        <source>Width the tractor occupies, wheels included.</source>
        <translation>Largura que o tractor ocupa, rodas incluídas.</translation>
    </message>
    <message>
        <source>Width while lifted or folded for a turn; the operating width where it is not given.</source>
        <translation>Largura levantada ou dobrada para uma manobra; a largura de trabalho onde não é dada.</translation>
    </message>
    <message>
        <source>With the implement up, %1 are driven over worked land and %2 over land that is worked later; %3 is the longest.</source>
        <translation>Com a alfaia levantado, passa-se %1 sobre solo trabalhado e %2 sobre solo trabalhado depois; o mais longo é %3.</translation>
    </message>
    <message>
        <source>Zipped boundary</source>
        <translation>Limite comprimido</translation>
    </message>
    <message>
        <source>a chunk of the recording has a wrong checksum</source>
        <translation>um bloco da gravação tem uma soma de verificação errada</translation>
    </message>
    <message>
        <source>a record of the recording is damaged</source>
        <translation>um registo da gravação está danificado</translation>
    </message>
    <message>
        <source>add the .prj file that belongs to it, or export the field again in WGS84</source>
        <translation>adicione o ficheiro .prj correspondente ou exporte o talhão de novo em WGS84</translation>
    </message>
    <message>
        <source>check the file&apos;s coordinate system</source>
        <translation>verifique o sistema de coordenadas do ficheiro</translation>
    </message>
    <message>
        <source>check the width of the implement, or take the track as driven around the field</source>
        <translation>verifique a largura da alfaia ou tome o percurso como volta ao redor do talhão</translation>
    </message>
    <message>
        <source>choose one by its number in the file: %1</source>
        <translation>escolha um pelo número no ficheiro: %1</translation>
    </message>
    <message>
        <source>correct it, or remove the hole or obstacle from the file</source>
        <translation>corrija-o, ou remova o vazio ou obstáculo do ficheiro</translation>
    </message>
    <message>
        <source>correct or delete this point in the file</source>
        <translation>corrija ou elimine este ponto no ficheiro</translation>
    </message>
    <message>
        <source>delete some of them</source>
        <translation>elimine alguns</translation>
    </message>
    <message>
        <source>delete the hole that covers it</source>
        <translation>elimine o vazio que o cobre</translation>
    </message>
    <message>
        <source>did you mean &apos;%1&apos;? use one of: %2; or give a machine file (.json)</source>
        <translation>seria “%1”? use uma de: %2; ou indique um ficheiro de máquina (.json)</translation>
    </message>
    <message>
        <source>download the file and give its path</source>
        <translation>transfira o ficheiro e indique o caminho</translation>
    </message>
    <message>
        <source>draw it as an area, or remove it from the file</source>
        <translation>desenhe-o como área, ou remova-o do ficheiro</translation>
    </message>
    <message>
        <source>draw it, or remove it from the file</source>
        <translation>desenhe-o, ou remova-o do ficheiro</translation>
    </message>
    <message>
        <source>draw one or open a file that has one</source>
        <translation>desenhe um ou abra um ficheiro que o tenha</translation>
    </message>
    <message>
        <source>export the fields again in one coordinate system</source>
        <translation>exporte os talhões de novo num único sistema de coordenadas</translation>
    </message>
    <message>
        <source>free some space on the stick</source>
        <translation>libere espaço na pen USB</translation>
    </message>
    <message>
        <source>give GPX, CSV, an NMEA or gpsd log, ISOXML task data (folder, TASKDATA.XML or zip) or a rosbag2</source>
        <translation>indique GPX, CSV, um registo NMEA ou gpsd, dados de tarefas ISOXML (pasta, TASKDATA.XML ou zip) ou um rosbag2</translation>
    </message>
    <message>
        <source>give a GeoTIFF, or a world file (.pgw) beside the PNG</source>
        <translation>indique um GeoTIFF ou um ficheiro de georreferência (.pgw) ao lado do PNG</translation>
    </message>
    <message>
        <source>give a curve that does not, or plan its parts apart</source>
        <translation>indique uma curva que não se cruze ou planeie as partes separadamente</translation>
    </message>
    <message>
        <source>give a distance up to 50 m</source>
        <translation>indique uma distância de até 50 m</translation>
    </message>
    <message>
        <source>give a file on a disk</source>
        <translation>indique um ficheiro em um disco</translation>
    </message>
    <message>
        <source>give a file with a line for each row</source>
        <translation>indique um ficheiro com uma linha por fileira</translation>
    </message>
    <message>
        <source>give a gap up to 100 m</source>
        <translation>indique uma lacuna de até 100 m</translation>
    </message>
    <message>
        <source>give a machine file (JSON)</source>
        <translation>indique um ficheiro de máquina (JSON)</translation>
    </message>
    <message>
        <source>give a plan and a track of the same field</source>
        <translation>indique um plano e um percurso do mesmo talhão</translation>
    </message>
    <message>
        <source>give a width up to 100 m</source>
        <translation>indique uma largura de até 100 m</translation>
    </message>
    <message>
        <source>give it a kind, or remove it from the file</source>
        <translation>indique o tipo, ou remova-o do ficheiro</translation>
    </message>
    <message>
        <source>give it the field that it lies in, or remove it from the file</source>
        <translation>indique o talhão em que está, ou remova-o do ficheiro</translation>
    </message>
    <message>
        <source>give one of the files in it</source>
        <translation>indique um dos ficheiros nela</translation>
    </message>
    <message>
        <source>give the file TASKDATA.XML</source>
        <translation>indique o ficheiro TASKDATA.XML</translation>
    </message>
    <message>
        <source>give the folder of one of these, or a file in it</source>
        <translation>indique a pasta de um deles ou um ficheiro nela</translation>
    </message>
    <message>
        <source>give the folder or zip with TASKDATA.XML and its TLG files, a rosbag2 folder, or one file</source>
        <translation>indique a pasta ou o zip com TASKDATA.XML e os seus ficheiros TLG, uma pasta de rosbag2 ou um ficheiro</translation>
    </message>
    <message>
        <source>give x_m and y_m in the plan&apos;s frame, or longitude and latitude</source>
        <translation>indique x_m e y_m no sistema do plano, ou longitude e latitude</translation>
    </message>
    <message>
        <source>it has another coordinate system than the file</source>
        <translation>tem outro sistema de coordenadas que o ficheiro</translation>
    </message>
    <message>
        <source>it has: %1</source>
        <translation>tem: %1</translation>
    </message>
    <message>
        <source>it holds more than %1 files</source>
        <translation>contém mais de %1 ficheiros</translation>
    </message>
    <message>
        <source>its coordinate system &apos;%1&apos; is not known</source>
        <translation>o seu sistema de coordenadas &apos;%1&apos; não é conhecido</translation>
    </message>
    <message>
        <source>its coordinate system would have to be fetched from &apos;%1&apos;</source>
        <translation>o seu sistema de coordenadas teria de ser descarregado de &apos;%1&apos;</translation>
    </message>
    <message>
        <source>its file is missing</source>
        <translation>falta o ficheiro</translation>
    </message>
    <message>
        <source>its kind &apos;%1&apos; is not known</source>
        <translation>o seu tipo &apos;%1&apos; não é conhecido</translation>
    </message>
    <message>
        <source>most of its sentences have a wrong checksum</source>
        <translation>a maioria das sentenças tem uma soma de verificação errada</translation>
    </message>
    <message>
        <source>move or delete it</source>
        <translation>mova ou elimine</translation>
    </message>
    <message>
        <source>neither turning radius nor steering angle is given</source>
        <translation>não foi dado raio de giro nem ângulo de direção</translation>
    </message>
    <message>
        <source>no boundary can be read from this file (%1)</source>
        <translation>não é possível ler limite deste ficheiro (%1)</translation>
    </message>
    <message>
        <source>none of its %1 time logs holds a position</source>
        <translation>nenhum dos %1 registos de tempo contém posições</translation>
    </message>
    <message>
        <source>only files on this computer are read</source>
        <translation>só são lidos ficheiros deste computador</translation>
    </message>
    <message>
        <source>open a file of your own</source>
        <translation>abra um ficheiro seu</translation>
    </message>
    <message>
        <source>open it as a field boundary, or choose another file</source>
        <translation>abra como limite de talhão ou escolha outro ficheiro</translation>
    </message>
    <message>
        <source>open it with a newer Furrow; the file was left as it is</source>
        <translation>abra com um Furrow mais novo; o ficheiro ficou como estava</translation>
    </message>
    <message>
        <source>plan the field first: furrow-cli plan FIELD --out plan</source>
        <translation>planeie primeiro o talhão: furrow-cli plan FIELD --out plan</translation>
    </message>
    <message>
        <source>record %1 has a value that its header does not name</source>
        <translation>o registo %1 tem um valor que o cabeçalho não indica</translation>
    </message>
    <message>
        <source>record the log again with a receiver that has a fix</source>
        <translation>grave de novo com um receptor que conheça a sua posição</translation>
    </message>
    <message>
        <source>remove it from the file, or add its field</source>
        <translation>remova-o do ficheiro ou adicione seu talhão</translation>
    </message>
    <message>
        <source>restore a copy of the file</source>
        <translation>restaure uma cópia do ficheiro</translation>
    </message>
    <message>
        <source>rows needs a file of lines</source>
        <translation>as fileiras precisam de um ficheiro de linhas</translation>
    </message>
    <message>
        <source>save it again in WGS84</source>
        <translation>guarde de novo em WGS84</translation>
    </message>
    <message>
        <source>save it as GeoTIFF, or with a world file in degrees</source>
        <translation>guarde como GeoTIFF ou com ficheiro de georreferência em graus</translation>
    </message>
    <message>
        <source>save the field again, or remove this file</source>
        <translation>guarde o talhão de novo ou remova este ficheiro</translation>
    </message>
    <message>
        <source>save the project, and free some space</source>
        <translation>guarde o projeto e libere espaço</translation>
    </message>
    <message>
        <source>several plans of &apos;%1&apos; are called &apos;%2&apos;</source>
        <translation>vários planos de &apos;%1&apos; chamam-se &apos;%2&apos;</translation>
    </message>
    <message>
        <source>take off the write protection of the stick</source>
        <translation>tire a proteção contra gravação da pen USB</translation>
    </message>
    <message>
        <source>the .shx file that belongs to it is missing</source>
        <translation>falta o ficheiro .shx correspondente</translation>
    </message>
    <message>
        <source>the GPX file is damaged (%1)</source>
        <translation>o ficheiro GPX está danificado (%1)</translation>
    </message>
    <message>
        <source>the GPX file is larger than 256 MiB</source>
        <translation>o ficheiro GPX é maior que 256 MiB</translation>
    </message>
    <message>
        <source>the coordinate system that it names is not known</source>
        <translation>o sistema de coordenadas que indica não é conhecido</translation>
    </message>
    <message>
        <source>the file cannot be read</source>
        <translation>não é possível ler o ficheiro</translation>
    </message>
    <message>
        <source>the file has %1 fields: %2</source>
        <translation>o ficheiro tem %1 talhões: %2</translation>
    </message>
    <message>
        <source>the file is damaged</source>
        <translation>o ficheiro está danificado</translation>
    </message>
    <message>
        <source>the file is damaged (%1)</source>
        <translation>o ficheiro está danificado (%1)</translation>
    </message>
    <message>
        <source>the file is damaged here</source>
        <translation>o ficheiro está danificado aqui</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>o ficheiro está vazio</translation>
    </message>
    <message>
        <source>the file is empty or cannot be read</source>
        <translation>o ficheiro está vazio ou não pode ser lido</translation>
    </message>
    <message>
        <source>the file is larger than 1 GiB</source>
        <translation>o ficheiro é maior que 1 GiB</translation>
    </message>
    <message>
        <source>the file may be cut off or damaged; copy or export it again</source>
        <translation>o ficheiro pode estar cortado ou danificado; copie ou exporte de novo</translation>
    </message>
    <message>
        <source>the file may be cut off or damaged; export it again</source>
        <translation>o ficheiro pode estar cortado ou danificado; exporte de novo</translation>
    </message>
    <message>
        <source>the implement was nowhere down on this track</source>
        <translation>a alfaia não esteve baixada em nenhum ponto deste percurso</translation>
    </message>
    <message>
        <source>the log is cut off in record %1</source>
        <translation>o registo está cortado na entrada %1</translation>
    </message>
    <message>
        <source>the path of a file</source>
        <translation>o caminho de um ficheiro</translation>
    </message>
    <message>
        <source>the recording is cut off in the middle of a record</source>
        <translation>a gravação está cortada no meio de um registo</translation>
    </message>
    <message>
        <source>the stick does not answer any more (%1)</source>
        <translation>a pen USB não responde mais (%1)</translation>
    </message>
    <message>
        <source>the stick has %1 MB free, and %2 MB are needed</source>
        <translation>a pen USB tem %1 MB livres, e são necessários %2 MB</translation>
    </message>
    <message>
        <source>the stick is damaged: use another one</source>
        <translation>a pen USB está danificada: use outra</translation>
    </message>
    <message>
        <source>the stick is write-protected</source>
        <translation>a pen USB está protegida contra gravação</translation>
    </message>
    <message>
        <source>there is no boundary file in this zip</source>
        <translation>não há ficheiro de limites neste zip</translation>
    </message>
    <message>
        <source>there is no field &apos;%1&apos; in the file</source>
        <translation>não há talhão “%1” no ficheiro</translation>
    </message>
    <message>
        <source>there is no setting &apos;%1&apos;</source>
        <translation>não há definição “%1”</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>esse ficheiro não existe</translation>
    </message>
    <message>
        <source>there is no track in this GPX file</source>
        <translation>não há percurso neste ficheiro GPX</translation>
    </message>
    <message>
        <source>this XML file is cut off</source>
        <translation>este ficheiro XML está cortado</translation>
    </message>
    <message>
        <source>this is no MCAP file of version 0</source>
        <translation>não é um ficheiro MCAP da versão 0</translation>
    </message>
    <message>
        <source>this is no boundary file that can be read</source>
        <translation>não é um ficheiro de limites que possa ser lido</translation>
    </message>
    <message>
        <source>this is no header of a time log</source>
        <translation>não é o cabeçalho de um registo de tempo</translation>
    </message>
    <message>
        <source>this is no ordinary file</source>
        <translation>não é um ficheiro comum</translation>
    </message>
    <message>
        <source>this project file is damaged: %1</source>
        <translation>este ficheiro de projeto está danificado: %1</translation>
    </message>
    <message>
        <source>this project was saved by a newer Furrow (format %1, this one knows %2)</source>
        <translation>este projeto foi guardado por um Furrow mais novo (formato %1, este conhece %2)</translation>
    </message>
    <message>
        <source>try another stick</source>
        <translation>tente outra pen USB</translation>
    </message>
    <message>
        <source>turn it into a rosbag2 with rosbags-convert</source>
        <translation>converta-o num rosbag2 com rosbags-convert</translation>
    </message>
    <message>
        <source>use one of: %1; or give a machine file (.json)</source>
        <translation>use uma de: %1; ou indique um ficheiro de máquina (.json)</translation>
    </message>
    <message>
        <source>what is on the stick is not the plan: %1</source>
        <translation>o que está na pen USB não é o plano: %1</translation>
    </message>
    <message>
        <source>it is no file</source>
        <translation>não é um ficheiro</translation>
    </message>
    <message>
        <source>there is no such file or folder</source>
        <translation>esse ficheiro ou essa pasta não existe</translation>
    </message>
    <message>
        <source>choose a file or a folder of tiles</source>
        <translation>escolha um ficheiro ou uma pasta de blocos</translation>
    </message>
    <message>
        <source>the file is not there any more</source>
        <translation>o ficheiro já não está lá</translation>
    </message>
    <message>
        <source>the folder is not there any more</source>
        <translation>a pasta já não está lá</translation>
    </message>
    <message>
        <source>the file was changed while it was open</source>
        <translation>o ficheiro foi alterado enquanto estava aberto</translation>
    </message>
    <message>
        <source>the file cannot be read any more</source>
        <translation>o ficheiro já não pode ser lido</translation>
    </message>
    <message>
        <source>copy or export the file again</source>
        <translation>copie ou exporte o ficheiro novamente</translation>
    </message>
    <message>
        <source>save it in tiles and with overviews (gdal_translate -of COG)</source>
        <translation>guarde-a em blocos e com vistas gerais (gdal_translate -of COG)</translation>
    </message>
    <message>
        <source>it is too large to be shown without overviews</source>
        <translation>é demasiado grande para ser mostrada sem vistas gerais</translation>
    </message>
    <message>
        <source>Receivers may refuse %1: %2.</source>
        <translation>Os recetores podem recusar %1: %2.</translation>
    </message>
    <message>
        <source>some systems do not allow a file of this name</source>
        <translation>alguns sistemas não permitem um ficheiro com este nome</translation>
    </message>
    <message>
        <source>another file differs from it in capitals only</source>
        <translation>outro ficheiro só difere dele nas maiúsculas</translation>
    </message>
    <message>
        <source>its shapes have heights or measures, which displays do not read</source>
        <translation>as suas formas têm alturas ou medidas, que os ecrãs não leem</translation>
    </message>
    <message>
        <source>this is the recording of a drive (%1), and no boundary</source>
        <translation>isto é o registo de um percurso (%1), e não um limite</translation>
    </message>
    <message>
        <source>give the field&apos;s boundary; furrow-cli compare lays a recording over a plan</source>
        <translation>indique o limite do talhão; furrow-cli compare sobrepõe um registo a um plano</translation>
    </message>
    <message>
        <source>NMEA or gpsd log</source>
        <translation>Registo NMEA ou gpsd</translation>
    </message>
    <message>
        <source>This machine cannot reverse.</source>
        <translation>Esta máquina não consegue andar em marcha-atrás.</translation>
    </message>
    <message>
        <source>The implement is folded on the way from %1 to %2.</source>
        <translation>A alfaia vai dobrada nesta deslocação: %1 → %2.</translation>
    </message>
    <message>
        <source>The machine has to stand for %1 s to fold its implement or to unfold it, and does not in %2.</source>
        <translation>A máquina tem de ficar parada %1 s para dobrar ou desdobrar a alfaia; em %2 não fica.</translation>
    </message>
    <message>
        <source>How far the implement may stand over the boundary and obstacles, its sections there switched off; the tractor and all wheels stay inside.</source>
        <translation>Até onde a alfaia pode ficar sobre o limite do talhão e os obstáculos, com as secções aí desligadas; o tractor e todas as rodas ficam dentro.</translation>
    </message>
    <message>
        <source>give an overhang of 0 to 100 m</source>
        <translation>indique um balanço de 0 a 100 m</translation>
    </message>
    <message>
        <source>The implement stands over the edge of the field or an obstacle, by up to %1, as the overhang allows.</source>
        <translation>A alfaia fica sobre a borda do talhão ou um obstáculo, até %1, como o balanço permite.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; in it is a view</source>
        <translation>«%1» nele é uma vista (view)</translation>
    </message>
    <message>
        <source>a text with fields may take %1 MiB, and this one takes more</source>
        <translation>um texto com parcelas pode ocupar %1 MiB, e este ocupa mais</translation>
    </message>
    <message>
        <source>correct one of them, or give min_turning_radius_m</source>
        <translation>corrija um deles ou indique min_turning_radius_m</translation>
    </message>
    <message>
        <source>did you mean %1?</source>
        <translation>queria dizer %1?</translation>
    </message>
    <message>
        <source>export it as a table, or remove it</source>
        <translation>exporte-a como tabela ou retire-a</translation>
    </message>
    <message>
        <source>give a number from %1 to %2</source>
        <translation>indique um número de %1 a %2</translation>
    </message>
    <message>
        <source>it would grow more than three hundredfold when it is unpacked</source>
        <translation>cresceria mais de trezentas vezes ao descomprimir</translation>
    </message>
    <message>
        <source>it would take more than 2 GiB when it is unpacked</source>
        <translation>descomprimido ocuparia mais de 2 GiB</translation>
    </message>
    <message>
        <source>lists and objects lie too deep in one another here</source>
        <translation>aqui há listas e objetos aninhados demasiado fundo</translation>
    </message>
    <message>
        <source>remove what does not belong there</source>
        <translation>retire o que não pertence ali</translation>
    </message>
    <message>
        <source>the file is far too large for what it should hold</source>
        <translation>o ficheiro é demasiado grande para o que deveria conter</translation>
    </message>
    <message>
        <source>unpack it and give one of its files</source>
        <translation>descomprima-o e indique um dos ficheiros</translation>
    </message>
    <message>
        <source>with this wheelbase, %1 give a turning radius of %2</source>
        <translation>com esta distância entre eixos, %1 dão um raio de viragem de %2</translation>
    </message>
</context>
<context>
    <name>PreferencesDialog</name>
    <message>
        <source>Fields take both: 7.3 m, 24 ft, 10&apos;6&quot;, 8 km/h, 5 mph. Files always hold metres.</source>
        <translation>As caixas aceitam ambas: 7,3 m, 24 ft, 10&apos;6&quot;, 8 km/h, 5 mph. Os ficheiros contêm sempre metros.</translation>
    </message>
</context>
<context>
    <name>ProblemCard</name>
    <message>
        <source>Open another file…</source>
        <translation>Abrir outro ficheiro…</translation>
    </message>
</context>
<context>
    <name>ProjectDialogs</name>
    <message>
        <source>All files (*)</source>
        <translation>Todos os ficheiros (*)</translation>
    </message>
    <message>
        <source>Save the project</source>
        <translation>Guardar o projeto</translation>
    </message>
</context>
<context>
    <name>StatusChip</name>
    <message>
        <source>Plan again</source>
        <translation>Planear de novo</translation>
    </message>
</context>
<context>
    <name>TopBar</name>
    <message>
        <source>Not saved yet</source>
        <translation>Ainda não guardado</translation>
    </message>
    <message>
        <source>There are changes that are not saved</source>
        <translation>Há alterações não guardadas</translation>
    </message>
</context>
<context>
    <name>Tour</name>
    <message>
        <source>In three minutes from a field to a plan that can be driven. A sample field is opened for you; Ctrl+Z takes everything back. Leave whenever you like: the tour is in the Help menu.</source>
        <translation>Em três minutos, de um talhão a um plano que pode ser conduzido. É-lhe aberto um talhão de exemplo; Ctrl+Z desfaz tudo. Saia quando quiser: a visita guiada está no menu Ajuda.</translation>
    </message>
    <message>
        <source>From top to bottom: the field, the machine, and how it works. Each step says what is chosen and what came of it; press one to change it. Every change plans anew at once.</source>
        <translation>De cima para baixo: o talhão, a máquina e como ela trabalha. Cada passo diz o que foi escolhido e o que resultou; clique num para o alterar. Cada alteração planeia de novo de imediato.</translation>
    </message>
    <message>
        <source>The steps</source>
        <translation>Os passos</translation>
    </message>
    <message>
        <source>Drag a corner of the field and watch the plan follow. The wheel zooms, dragging the ground moves the map. The dot in the middle of an edge makes another corner; Alt lets go of what catches.</source>
        <translation>Arraste um canto do talhão e veja o plano acompanhar. A roda amplia, arrastar o fundo move o mapa. O ponto a meio de uma aresta cria outro canto; Alt solta o encaixe automático.</translation>
    </message>
    <message>
        <source>Draw a field, a hole, an obstacle, an AB line or a gate. The lowest button shows the layers: what is drawn of the plan, and your own aerial photos or heights beneath it.</source>
        <translation>Desenhe um talhão, um vazio, um obstáculo, uma linha AB ou uma entrada. O botão de baixo mostra as camadas: o que é desenhado do plano e, por baixo, as suas próprias fotos aéreas ou altitudes.</translation>
    </message>
    <message>
        <source>Area, way and time, and what was found: press a finding and the map goes there. Findings in the way of driving come first, with what would help.</source>
        <translation>Área, distância e tempo, e o que foi encontrado: clique num aviso e o mapa vai até lá. Os avisos que impedem de conduzir vêm primeiro, com o que ajudaria.</translation>
    </message>
    <message>
        <source>Export writes the plan to a folder or a USB stick, for many terminals, reads it back and compares it. Then save the project: Ctrl+S. Ctrl+K finds every command by name.</source>
        <translation>Exportar grava o plano numa pasta ou numa pen USB, para muitos terminais, volta a lê-lo e compara-o. Depois guarde o projeto: Ctrl+S. Ctrl+K encontra qualquer comando pelo nome.</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Seguinte</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Anterior</translation>
    </message>
</context>
<context>
    <name>UnsavedDialog</name>
    <message>
        <source>Save the changes of “%1”?</source>
        <translation>Guardar as alterações de “%1”?</translation>
    </message>
    <message>
        <source>Save your work?</source>
        <translation>Guardar o trabalho?</translation>
    </message>
    <message>
        <source>Do not save</source>
        <translation>Não guardar</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Guardar</translation>
    </message>
</context>
<context>
    <name>furrow::ExportModel</name>
    <message>
        <source>Writing …</source>
        <translation>A gravar…</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) written to %1</source>
        <translation>
            <numerusform>%n ficheiro gravado em %1</numerusform>
            <numerusform>%n ficheiros gravados em %1</numerusform>
        </translation>
    </message>
    <message>
        <source>A field is being opened. Its plan can be exported when it is finished.</source>
        <translation>Um talhão está a ser aberto. O plano poderá ser exportado quando estiver pronto.</translation>
    </message>
    <message>
        <source>The plan is still being made. It can be exported when it is finished.</source>
        <translation>O plano ainda está a ser calculado. Poderá ser exportado quando estiver pronto.</translation>
    </message>
</context>
<context>
    <name>furrow::FieldEditor</name>
    <message>
        <source>Delete a point</source>
        <translation>Eliminar um ponto</translation>
    </message>
    <message>
        <source>Delete a hole</source>
        <translation>Eliminar um vazio</translation>
    </message>
    <message>
        <source>Delete an obstacle</source>
        <translation>Eliminar um obstáculo</translation>
    </message>
    <message>
        <source>Delete a gate</source>
        <translation>Eliminar uma entrada</translation>
    </message>
    <message>
        <source>Delete the guidance line</source>
        <translation>Eliminar a linha de orientação</translation>
    </message>
    <message>
        <source>Delete a split line</source>
        <translation>Eliminar uma linha de divisão</translation>
    </message>
</context>
<context>
    <name>furrow::FieldOpener</name>
    <message numerus="yes">
        <source>%n file(s)</source>
        <translation>
            <numerusform>%n ficheiro</numerusform>
            <numerusform>%n ficheiros</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>furrow::Planning</name>
    <message>
        <source>Reading %1 …</source>
        <translation>A ler %1…</translation>
    </message>
    <message numerus="yes">
        <source>%n field(s) in this file</source>
        <translation>
            <numerusform>%n talhão neste ficheiro</numerusform>
            <numerusform>%n talhões neste ficheiro</numerusform>
        </translation>
    </message>
    <message>
        <source>Planning …</source>
        <translation>A planear…</translation>
    </message>
    <message>
        <source>Draft · planning …</source>
        <translation>Rascunho · a planear…</translation>
    </message>
</context>
<context>
    <name>furrow::ProjectFiles</name>
    <message>
        <source>Your last work was not saved. Here it is again.</source>
        <translation>O último trabalho não foi guardado. Aqui está ele.</translation>
    </message>
    <message>
        <source>Changes of “%1” were not saved. Here they are again.</source>
        <translation>As alterações de “%1” não foram guardadas. Aqui estão elas.</translation>
    </message>
    <message>
        <source>It is kept in the file all the same.</source>
        <translation>Mesmo assim continua no ficheiro.</translation>
    </message>
    <message>
        <source>Restore changes that were not saved</source>
        <translation>Recuperar alterações não guardadas</translation>
    </message>
    <message>
        <source>Another program changed “%1” while changes of yours were not saved. Yours are shown; undo shows the file.</source>
        <translation>Outro programa alterou “%1” enquanto havia alterações suas não guardadas. As suas são mostradas; desfazer mostra o ficheiro.</translation>
    </message>
    <message>
        <source>Save over it, or save yours under another name.</source>
        <translation>Substitua-o ou guarde o seu com outro nome.</translation>
    </message>
</context>
<context>
    <name>furrow::QuantityText</name>
    <message>
        <source>This is not a time. Type it like 45 s or 2 min.</source>
        <translation>Isto não é um tempo. Escreva como 45 s ou 2 min.</translation>
    </message>
</context>
<context>
    <name>furrow::StepsModel</name>
    <message>
        <source>Open a file or draw a boundary</source>
        <translation>Abra um ficheiro ou desenhe um limite</translation>
    </message>
    <message>
        <source>Planning …</source>
        <translation>A planear…</translation>
    </message>
    <message>
        <source>Plan again to check what the panels show</source>
        <translation>Planear de novo para verificar isto</translation>
    </message>
</context>
<context>
    <name>furrow::StickExport</name>
    <message>
        <source>Writing …</source>
        <translation>A gravar…</translation>
    </message>
    <message>
        <source>Safe to unplug: %1</source>
        <translation>A pen USB pode ser retirada: %1</translation>
    </message>
</context>
<context>
    <name>ViewCommands</name>
    <message>
        <source>online tiles</source>
        <translation>online blocos</translation>
    </message>
    <message>
        <source>preferences settings metric imperial feet acres</source>
        <translation>preferências definições métrico imperial pés acres</translation>
    </message>
</context>
</TS>
