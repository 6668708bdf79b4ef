<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="pt_BR" sourcelanguage="en">
<context>
    <name>AboutDialog</name>
    <message>
        <source>Furrow %1</source>
        <translation>Furrow %1</translation>
    </message>
    <message>
        <source>Furrow plans how a machine covers a farm field.</source>
        <translation>O Furrow planeja como uma máquina trabalha um talhão.</translation>
    </message>
    <message>
        <source>Free software under the BSD 3-Clause licence: use it, change it and pass it on, without any warranty.</source>
        <translation>Software livre sob a licença BSD de 3 cláusulas: use, altere e passe adiante, sem nenhuma garantia.</translation>
    </message>
    <message>
        <source>The methods follow the Fields2Cover paper (Mier, Valente and de Bruin, 2023) and the sources that the design names.</source>
        <translation>Os métodos seguem o artigo do Fields2Cover (Mier, Valente e de Bruin, 2023) e as fontes citadas no documento de projeto.</translation>
    </message>
    <message>
        <source>Built with %1.</source>
        <translation>Construído com %1.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fechar</translation>
    </message>
</context>
<context>
    <name>BestPlanDialog</name>
    <message>
        <source>The best plan found</source>
        <translation>O melhor plano encontrado</translation>
    </message>
    <message>
        <source>Your plan is the best one found</source>
        <translation>Seu plano é o melhor encontrado</translation>
    </message>
    <message>
        <source>Find the best plan</source>
        <translation>Buscar o melhor plano</translation>
    </message>
    <message>
        <source>Other choices are planned, and the quickest plan that can be driven is taken. Margins, overlap and what the operation needs stay as they are.</source>
        <translation>Outras escolhas são planejadas e o plano executável mais rápido é usado. Margens, sobreposição e o que a operação exige ficam como estão.</translation>
    </message>
    <message>
        <source>May change</source>
        <translation>Pode mudar</translation>
    </message>
    <message>
        <source>%1 (set by you)</source>
        <translation>%1 (sua escolha)</translation>
    </message>
    <message>
        <source>Best plan</source>
        <translation>Melhor plano</translation>
    </message>
    <message>
        <source>Best so far</source>
        <translation>Melhor até agora</translation>
    </message>
    <message>
        <source>As it was</source>
        <translation>Antes</translation>
    </message>
    <message>
        <source>Saved</source>
        <translation>Economizado</translation>
    </message>
    <message>
        <source>Time of the best plan during the search</source>
        <translation>Tempo do melhor plano durante a busca</translation>
    </message>
    <message numerus="yes">
        <source>%n alternative(s) were planned.</source>
        <translation>
            <numerusform>%n alternativa foi planejada.</numerusform>
            <numerusform>%n alternativas foram planejadas.</numerusform>
        </translation>
    </message>
    <message>
        <source>Times include working separately what a plan leaves.</source>
        <translation>Os tempos incluem trabalhar à parte o que um plano deixa.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fechar</translation>
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
        <translation>Parar e manter</translation>
    </message>
    <message>
        <source>Use this plan</source>
        <translation>Usar este plano</translation>
    </message>
</context>
<context>
    <name>CellStepper</name>
    <message>
        <source>Done</source>
        <translation>Concluir</translation>
    </message>
    <message>
        <source>Go through the steps</source>
        <translation>Percorrer as etapas</translation>
    </message>
    <message>
        <source>Next step</source>
        <translation>Próxima etapa</translation>
    </message>
    <message>
        <source>Previous step</source>
        <translation>Etapa anterior</translation>
    </message>
    <message>
        <source>Show the blocks</source>
        <translation>Mostrar os subtalhões</translation>
    </message>
    <message>
        <source>Step of the blocks</source>
        <translation>Etapa dos subtalhões</translation>
    </message>
    <message>
        <source>Turns and ways from block to block, estimated.</source>
        <translation>Manobras e deslocamentos de um subtalhão a outro, estimados.</translation>
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
            <numerusform>%n outra é ainda mais lenta ou não é executável.</numerusform>
            <numerusform>%n outras são ainda mais lentas ou não são executáveis.</numerusform>
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
        <translation>Não há comando nem configuração com esse nome</translation>
    </message>
    <message>
        <source>Search commands, settings, coordinates</source>
        <translation>Buscar comandos, configurações, coordenadas</translation>
    </message>
    <message>
        <source>As maps, phones and receivers write them</source>
        <translation>Como mapas, telefones e receptores as escrevem</translation>
    </message>
</context>
<context>
    <name>CommentPins</name>
    <message>
        <source>Comment %1: %2</source>
        <translation>Comentário %1: %2</translation>
    </message>
    <message>
        <source>Click the place that you want to comment on. Esc ends it.</source>
        <translation>Clique no lugar que quer comentar. Esc para encerrar.</translation>
    </message>
</context>
<context>
    <name>CommentRow</name>
    <message>
        <source>Comment %1 by %2: %3</source>
        <translation>Comentário %1 de %2: %3</translation>
    </message>
    <message>
        <source>Of a plan before the last change</source>
        <translation>De um plano anterior à última mudança</translation>
    </message>
    <message>
        <source>Open again</source>
        <translation>Reabrir</translation>
    </message>
    <message>
        <source>Settled</source>
        <translation>Resolvido</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Remover</translation>
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
        <translation>%1 ao lado de</translation>
    </message>
    <message>
        <source>The other plan</source>
        <translation>O outro plano</translation>
    </message>
    <message>
        <source>Keep this plan as a variant…</source>
        <translation>Guardar este plano como variante…</translation>
    </message>
    <message>
        <source>The other plan is being made …</source>
        <translation>O outro plano está sendo calculado…</translation>
    </message>
    <message>
        <source>This plan</source>
        <translation>Este plano</translation>
    </message>
    <message>
        <source>The other</source>
        <translation>O outro</translation>
    </message>
    <message>
        <source>%1: %2, the other %3</source>
        <translation>%1: %2, o outro %3</translation>
    </message>
    <message>
        <source>Hold to see the other plan (key X)</source>
        <translation>Segure para ver o outro plano (tecla X)</translation>
    </message>
    <message>
        <source>What was chosen otherwise</source>
        <translation>Escolhas diferentes</translation>
    </message>
    <message>
        <source>Machine and settings are the same.</source>
        <translation>Máquina e configurações são iguais.</translation>
    </message>
    <message>
        <source>%1 → %2</source>
        <translation>%1 → %2</translation>
    </message>
    <message>
        <source>Go on with the other plan</source>
        <translation>Continuar com o outro plano</translation>
    </message>
    <message>
        <source>Two maps side by side (Ctrl+Shift+D)</source>
        <translation>Dois mapas lado a lado (Ctrl+Shift+D)</translation>
    </message>
    <message>
        <source>On the maps, swaths, headland passes and turns are coloured that the other plan has not: full lines in this plan, dashes in the other.</source>
        <translation>Nos mapas ficam coloridas as passadas, passadas de cabeceira e manobras que o outro plano não tem: linhas contínuas neste plano, tracejadas no outro.</translation>
    </message>
    <message>
        <source>On the map, swaths, headland passes and turns: full lines only in this plan, dashes only in the other.</source>
        <translation>No mapa, passadas, passadas de cabeceira e manobras: linhas contínuas só neste plano, tracejadas só no outro.</translation>
    </message>
</context>
<context>
    <name>CrashNotice</name>
    <message>
        <source>Furrow ended unexpectedly the last time.</source>
        <translation>O Furrow fechou inesperadamente da última vez.</translation>
    </message>
    <message>
        <source>Your work was kept up to the last half second. What happened is recorded on this computer; a report helps to mend it.</source>
        <translation>Seu trabalho foi guardado até o último meio segundo. O que aconteceu está registrado neste computador; um relatório ajuda a corrigir.</translation>
    </message>
    <message>
        <source>Report a problem…</source>
        <translation>Relatar um problema…</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fechar</translation>
    </message>
</context>
<context>
    <name>DrawingNotice</name>
    <message>
        <source>The map cannot show fields and plans: this window is drawn without OpenGL.</source>
        <translation>O mapa não pode mostrar talhões nem planos: esta janela é desenhada sem OpenGL.</translation>
    </message>
    <message>
        <source>Install a graphics driver with OpenGL; Mesa draws on any processor. The command line plans and exports all the same.</source>
        <translation>Instale um driver gráfico com OpenGL; o Mesa desenha em qualquer processador. A linha de comando planeja e exporta mesmo assim.</translation>
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
        <translation>Percurso</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pausar</translation>
    </message>
    <message>
        <source>Drive through the plan</source>
        <translation>Percorrer o plano</translation>
    </message>
    <message>
        <source>Moment of the drive</source>
        <translation>Momento do percurso</translation>
    </message>
    <message>
        <source>Pace: %1 times as fast</source>
        <translation>Ritmo: %1 vezes mais rápido</translation>
    </message>
    <message>
        <source>%1×</source>
        <translation>%1×</translation>
    </message>
    <message>
        <source>Let the map rest</source>
        <translation>Deixar o mapa parado</translation>
    </message>
    <message>
        <source>Follow the machine</source>
        <translation>Seguir a máquina</translation>
    </message>
    <message>
        <source>Hide the drive-through</source>
        <translation>Ocultar o percurso</translation>
    </message>
</context>
<context>
    <name>DrivenDialog</name>
    <message>
        <source>Open a recorded track</source>
        <translation>Abrir um percurso gravado</translation>
    </message>
    <message>
        <source>Recorded tracks (%1)</source>
        <translation>Percursos gravados (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Todos os arquivos (*)</translation>
    </message>
</context>
<context>
    <name>DrivenPanel</name>
    <message>
        <source>Planned and driven</source>
        <translation>Planejado e percorrido</translation>
    </message>
    <message>
        <source>Go to the farthest place</source>
        <translation>Ir ao lugar mais distante</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Distance from the plan</source>
        <translation>Distância do plano</translation>
    </message>
    <message>
        <source>Another track…</source>
        <translation>Outro percurso…</translation>
    </message>
    <message>
        <source>Make a field from it</source>
        <translation>Fazer um talhão dele</translation>
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
        <translation>Desfazer: %1</translation>
    </message>
    <message>
        <source>Draw a point</source>
        <translation>Desenhar um ponto</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Desfazer</translation>
    </message>
    <message>
        <source>Redo: %1</source>
        <translation>Refazer: %1</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Refazer</translation>
    </message>
    <message>
        <source>Delete what is selected</source>
        <translation>Excluir a seleção</translation>
    </message>
    <message>
        <source>Del</source>
        <translation>Del</translation>
    </message>
    <message>
        <source>Select the next point</source>
        <translation>Selecionar o próximo ponto</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Espaço</translation>
    </message>
    <message>
        <source>Select the next edge</source>
        <translation>Selecionar o próximo lado</translation>
    </message>
    <message>
        <source>Select the next outline, line or gate</source>
        <translation>Próximo contorno, linha ou entrada</translation>
    </message>
    <message>
        <source>PgDown</source>
        <translation>PgDn</translation>
    </message>
    <message>
        <source>Find a command…</source>
        <translation>Buscar um comando…</translation>
    </message>
</context>
<context>
    <name>EmptyState</name>
    <message>
        <source>Which field?</source>
        <translation>Qual talhão?</translation>
    </message>
    <message>
        <source>Open its boundary, or drop the file anywhere on this window. Shapefile, GeoJSON, KML, GeoPackage, GML and others are understood, zipped or not.</source>
        <translation>Abra o limite ou solte o arquivo em qualquer parte desta janela. Shapefile, GeoJSON, KML, GeoPackage, GML e outros são lidos, compactados ou não.</translation>
    </message>
    <message>
        <source>Open a file…</source>
        <translation>Abrir um arquivo…</translation>
    </message>
    <message>
        <source>Draw it</source>
        <translation>Desenhar</translation>
    </message>
    <message>
        <source>Or try one of these</source>
        <translation>Ou experimente um destes</translation>
    </message>
    <message>
        <source>Sample field %1</source>
        <translation>Talhão de exemplo %1</translation>
    </message>
</context>
<context>
    <name>ErrorCourse</name>
    <message>
        <source>Distance from the plan along the recording, up to %1</source>
        <translation>Distância do plano ao longo da gravação, até %1</translation>
    </message>
    <message>
        <source>%1 to the left</source>
        <translation>%1 à esquerda</translation>
    </message>
    <message>
        <source>%1 to the right</source>
        <translation>%1 à direita</translation>
    </message>
</context>
<context>
    <name>ExportChecks</name>
    <message>
        <source>Choose another format or terminal, and report this.</source>
        <translation>Escolha outro formato ou terminal e relate isto.</translation>
    </message>
    <message numerus="yes">
        <source>%n check(s) passed: nothing in the files that receivers stumble over.</source>
        <translation>
            <numerusform>%n verificação aprovada: nada nos arquivos que cause problemas nos terminais.</numerusform>
            <numerusform>%n verificações aprovadas: nada nos arquivos que cause problemas nos terminais.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ExportDialog</name>
    <message>
        <source>Export the plan</source>
        <translation>Exportar o plano</translation>
    </message>
    <message>
        <source>USB stick</source>
        <translation>Pen drive</translation>
    </message>
    <message>
        <source>Files in a folder</source>
        <translation>Arquivos em uma pasta</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fechar</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Writing …</source>
        <translation>Gravando…</translation>
    </message>
    <message>
        <source>Write to the stick</source>
        <translation>Gravar no pen drive</translation>
    </message>
    <message>
        <source>Write files</source>
        <translation>Gravar os arquivos</translation>
    </message>
    <message>
        <source>Plan again</source>
        <translation>Planejar de novo</translation>
    </message>
    <message numerus="yes">
        <source>%n problem(s) in this plan: it cannot be driven as drawn. The files say so too.</source>
        <translation>
            <numerusform>%n problema neste plano: ele não pode ser percorrido como está. Os arquivos também dizem isso.</numerusform>
            <numerusform>%n problemas neste plano: ele não pode ser percorrido como está. Os arquivos também dizem isso.</numerusform>
        </translation>
    </message>
    <message>
        <source>Export fields</source>
        <translation>Exportar talhões</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Parar</translation>
    </message>
</context>
<context>
    <name>ExportFolderPage</name>
    <message>
        <source>Folder</source>
        <translation>Pasta</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Escolher…</translation>
    </message>
    <message>
        <source>Folder for the plan</source>
        <translation>Pasta para o plano</translation>
    </message>
    <message>
        <source>Fields without a plan are planned on the way. Each field gets a folder of its own; ISOXML and AgGPS hold all fields in one.</source>
        <translation>Talhões sem plano são planejados no caminho. Cada talhão tem sua própria pasta; ISOXML e AgGPS contêm todos os talhões juntos.</translation>
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
        <translation>Pen drive</translation>
    </message>
    <message>
        <source>No USB stick is plugged in. It appears here when it is; or choose a folder to carry the files yourself.</source>
        <translation>Nenhum pen drive conectado. Ele aparece aqui ao ser conectado; ou escolha uma pasta para levar os arquivos por conta própria.</translation>
    </message>
    <message>
        <source>Another folder…</source>
        <translation>Outra pasta…</translation>
    </message>
    <message>
        <source>%1 is on it already.</source>
        <translation>%1 já está nele.</translation>
    </message>
    <message>
        <source>It will not be deleted: it is kept under another name.</source>
        <translation>Não será apagado: fica guardado com outro nome.</translation>
    </message>
    <message>
        <source>Keep it as a backup and write the plan</source>
        <translation>Guardar como cópia e gravar o plano</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>e mais %n</numerusform>
            <numerusform>e mais %n</numerusform>
        </translation>
    </message>
    <message>
        <source>Folder in the place of a stick</source>
        <translation>Pasta no lugar de um pen drive</translation>
    </message>
    <message>
        <source>Also in a task, for terminals that show lines in tasks only</source>
        <translation>Também em uma tarefa, se o terminal o exigir</translation>
    </message>
</context>
<context>
    <name>FarImageryNotice</name>
    <message>
        <source>This picture does not show the field: it lies %1 away.</source>
        <translation>Esta imagem não mostra o talhão: fica a %1.</translation>
    </message>
    <message>
        <source>Go there</source>
        <translation>Ir para lá</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fechar</translation>
    </message>
</context>
<context>
    <name>FarmHeader</name>
    <message>
        <source>%1, sorted downwards</source>
        <translation>%1, ordem decrescente</translation>
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
        <translation>A fazenda</translation>
    </message>
    <message>
        <source>Find a field</source>
        <translation>Buscar um talhão</translation>
    </message>
    <message>
        <source>Find a field, season or machine</source>
        <translation>Buscar talhão, safra ou máquina</translation>
    </message>
    <message>
        <source>Back to the field (Esc)</source>
        <translation>Voltar ao talhão (Esc)</translation>
    </message>
    <message>
        <source>Field</source>
        <translation>Talhão</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Máquina</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Área</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Percurso</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Situação</translation>
    </message>
    <message>
        <source>Fields of the farm</source>
        <translation>Talhões da fazenda</translation>
    </message>
    <message>
        <source>No field has these words.</source>
        <translation>Nenhum talhão tem estas palavras.</translation>
    </message>
    <message>
        <source>There is no field yet.</source>
        <translation>Ainda não há talhão.</translation>
    </message>
    <message>
        <source>Select none</source>
        <translation>Não selecionar nenhum</translation>
    </message>
    <message>
        <source>Select all</source>
        <translation>Selecionar todos</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Parar</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
    <message numerus="yes">
        <source>Plan %n field(s)</source>
        <translation>
            <numerusform>Planejar %n talhão</numerusform>
            <numerusform>Planejar %n talhões</numerusform>
        </translation>
    </message>
    <message>
        <source>Planning …</source>
        <translation>Planejando…</translation>
    </message>
    <message>
        <source>All are planned</source>
        <translation>Todos planejados</translation>
    </message>
    <message>
        <source>Machine and settings of this plan</source>
        <translation>Máquina e configurações deste plano</translation>
    </message>
    <message>
        <source>Add a plan to each…</source>
        <translation>Adicionar um plano a cada um…</translation>
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
        <translation>Abrir arquivo…</translation>
    </message>
    <message>
        <source>Draw</source>
        <translation>Desenhar</translation>
    </message>
    <message>
        <source>Sample field</source>
        <translation>Talhão de exemplo</translation>
    </message>
    <message>
        <source>Add one to look at</source>
        <translation>Adicionar um para ver</translation>
    </message>
</context>
<context>
    <name>FieldChooser</name>
    <message numerus="yes">
        <source>Which of the %n field(s)?</source>
        <translation>
            <numerusform>Qual talhão (%n)?</numerusform>
            <numerusform>Qual dos %n talhões?</numerusform>
        </translation>
    </message>
    <message>
        <source>Open none of them</source>
        <translation>Não abrir nenhum</translation>
    </message>
    <message>
        <source>Open all of them</source>
        <translation>Abrir todos</translation>
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
        <translation>Talhão</translation>
    </message>
    <message>
        <source>Draw a field</source>
        <translation>Desenhar um talhão</translation>
    </message>
    <message>
        <source>boundary polygon</source>
        <translation>limite polígono</translation>
    </message>
    <message>
        <source>Make a field from a recorded track…</source>
        <translation>Fazer um talhão de um trajeto gravado…</translation>
    </message>
    <message>
        <source>boundary driven recorded GPX NMEA log drive around</source>
        <translation>limite percorrido gravado GPX NMEA contorno</translation>
    </message>
    <message>
        <source>Draw a hole</source>
        <translation>Desenhar um vazio</translation>
    </message>
    <message>
        <source>Draw an obstacle</source>
        <translation>Desenhar um obstáculo</translation>
    </message>
    <message>
        <source>pond tree pole wet</source>
        <translation>lagoa árvore poste úmido</translation>
    </message>
    <message>
        <source>Draw an AB line</source>
        <translation>Desenhar uma linha AB</translation>
    </message>
    <message>
        <source>guidance curve direction</source>
        <translation>orientação curva direção</translation>
    </message>
    <message>
        <source>Draw a split line</source>
        <translation>Desenhar uma linha de divisão</translation>
    </message>
    <message>
        <source>cut divide mainland parts</source>
        <translation>cortar dividir interior partes</translation>
    </message>
    <message>
        <source>Add a gate</source>
        <translation>Adicionar uma entrada</translation>
    </message>
    <message>
        <source>entry road</source>
        <translation>acesso estrada</translation>
    </message>
    <message>
        <source>Select and change</source>
        <translation>Selecionar e alterar</translation>
    </message>
    <message>
        <source>Make the outline&apos;s steps straight</source>
        <translation>Endireitar os degraus do contorno</translation>
    </message>
    <message>
        <source>pixels image stairs smooth simplify</source>
        <translation>pixels imagem escada suavizar simplificar</translation>
    </message>
    <message>
        <source>Rename the field…</source>
        <translation>Renomear o talhão…</translation>
    </message>
    <message>
        <source>Remove the field</source>
        <translation>Remover o talhão</translation>
    </message>
    <message>
        <source>delete</source>
        <translation>excluir</translation>
    </message>
    <message>
        <source>Next field</source>
        <translation>Próximo talhão</translation>
    </message>
    <message>
        <source>All fields of the farm</source>
        <translation>Todos os talhões da fazenda</translation>
    </message>
    <message>
        <source>list overview plan all batch totals</source>
        <translation>lista resumo planejar todos totais</translation>
    </message>
</context>
<context>
    <name>FieldFromTrackPanel</name>
    <message>
        <source>Field from a track</source>
        <translation>Talhão de um trajeto</translation>
    </message>
    <message>
        <source>How it was driven</source>
        <translation>Como foi percorrido</translation>
    </message>
    <message>
        <source>Operating width</source>
        <translation>Largura de trabalho</translation>
    </message>
    <message>
        <source>The edge lies outside of the line by</source>
        <translation>A borda fica fora da linha por</translation>
    </message>
    <message>
        <source>Half a width: the implement ran along the edge</source>
        <translation>Meia largura: o implemento ia pela borda</translation>
    </message>
    <message>
        <source>None: the line is the edge</source>
        <translation>Nada: a linha é a borda</translation>
    </message>
    <message>
        <source>Gaps between strips are closed up to</source>
        <translation>Vãos entre faixas são fechados até</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Make the field</source>
        <translation>Criar o talhão</translation>
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
            <numerusform>%1 e mais %n</numerusform>
            <numerusform>%1 e mais %n</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: the plan has problems and cannot be driven as drawn. The files say so too.</source>
        <translation>%1: o plano tem problemas e não pode ser percorrido como está desenhado. Os arquivos também dizem isso.</translation>
    </message>
</context>
<context>
    <name>FileCommands</name>
    <message>
        <source>File</source>
        <translation>Arquivo</translation>
    </message>
    <message>
        <source>New project</source>
        <translation>Novo projeto</translation>
    </message>
    <message>
        <source>farm</source>
        <translation>fazenda propriedade</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Abrir…</translation>
    </message>
    <message>
        <source>boundary import project</source>
        <translation>limite importar projeto</translation>
    </message>
    <message>
        <source>Add imagery…</source>
        <translation>Adicionar imagens…</translation>
    </message>
    <message>
        <source>GeoTIFF MBTiles aerial photo satellite background heights elevation</source>
        <translation>GeoTIFF MBTiles foto aérea satélite fundo altitude relevo</translation>
    </message>
    <message>
        <source>Add a folder of tiles…</source>
        <translation>Adicionar uma pasta de blocos…</translation>
    </message>
    <message>
        <source>imagery XYZ TMS</source>
        <translation>imagens XYZ TMS</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Salvar</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Salvar como…</translation>
    </message>
    <message>
        <source>Export the plan…</source>
        <translation>Exportar o plano…</translation>
    </message>
    <message>
        <source>ISOXML USB terminal</source>
        <translation>ISOXML USB terminal</translation>
    </message>
    <message>
        <source>Print the work order…</source>
        <translation>Imprimir a ordem de serviço…</translation>
    </message>
    <message>
        <source>print pdf report work order picture printer</source>
        <translation>imprimir PDF relatório ordem de serviço imagem impressora</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Sair</translation>
    </message>
</context>
<context>
    <name>FileList</name>
    <message>
        <source>%1, falling</source>
        <translation>%1, decrescente</translation>
    </message>
    <message>
        <source>%1, rising</source>
        <translation>%1, crescente</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nome</translation>
    </message>
    <message>
        <source>Changed</source>
        <translation>Alterado</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Tamanho</translation>
    </message>
    <message>
        <source>Files of %1</source>
        <translation>Arquivos de %1</translation>
    </message>
    <message>
        <source>Folder %1</source>
        <translation>Pasta %1</translation>
    </message>
    <message>
        <source>%1, %2, %3</source>
        <translation>%1, %2, %3</translation>
    </message>
    <message>
        <source>Reading the folder …</source>
        <translation>Lendo a pasta …</translation>
    </message>
    <message>
        <source>Nothing to choose here.</source>
        <translation>Não há nada para escolher aqui.</translation>
    </message>
</context>
<context>
    <name>FileWindow</name>
    <message>
        <source>The folder around it (Backspace)</source>
        <translation>A pasta acima (Backspace)</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Pasta</translation>
    </message>
    <message>
        <source>New folder…</source>
        <translation>Nova pasta…</translation>
    </message>
    <message>
        <source>“%1” is already there. Write over it?</source>
        <translation>“%1” já existe. Substituir?</translation>
    </message>
    <message>
        <source>There is no folder “%1”. Make it?</source>
        <translation>Não há pasta “%1”. Criar?</translation>
    </message>
    <message>
        <source>Name of the new folder</source>
        <translation>Nome da nova pasta</translation>
    </message>
    <message>
        <source>No</source>
        <translation>Não</translation>
    </message>
    <message>
        <source>Write over it</source>
        <translation>Substituir</translation>
    </message>
    <message>
        <source>Make the folder</source>
        <translation>Criar a pasta</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nome</translation>
    </message>
    <message>
        <source>Which files are shown</source>
        <translation>Quais arquivos são mostrados</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Salvar</translation>
    </message>
    <message>
        <source>Choose this folder</source>
        <translation>Escolher esta pasta</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Abrir</translation>
    </message>
    <message>
        <source>The folder “%1” cannot be made.</source>
        <translation>A pasta “%1” não pode ser criada.</translation>
    </message>
    <message>
        <source>There is nothing called “%1”.</source>
        <translation>Não há nada chamado “%1”.</translation>
    </message>
    <message>
        <source>Choose files only, or one folder to look into.</source>
        <translation>Escolha só arquivos, ou uma pasta para abrir.</translation>
    </message>
    <message>
        <source>Choose a file first.</source>
        <translation>Escolha primeiro um arquivo.</translation>
    </message>
    <message>
        <source>Nothing can be written in “%1”. Choose another folder.</source>
        <translation>Não é possível gravar em “%1”. Escolha outra pasta.</translation>
    </message>
    <message>
        <source>Give the file a name.</source>
        <translation>Dê um nome ao arquivo.</translation>
    </message>
</context>
<context>
    <name>FilesNotice</name>
    <message>
        <source>Keep</source>
        <translation>Manter</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
    <message>
        <source>Throw away</source>
        <translation>Descartar</translation>
    </message>
    <message>
        <source>Save over it</source>
        <translation>Substituir</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Salvar como…</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Mais tarde</translation>
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
        <translation>Guia</translation>
    </message>
    <message>
        <source>Sample field</source>
        <translation>Talhão de exemplo</translation>
    </message>
    <message>
        <source>example try</source>
        <translation>exemplo experimentar</translation>
    </message>
    <message>
        <source>Fields</source>
        <translation>Talhões</translation>
    </message>
    <message>
        <source>field</source>
        <translation>talhão</translation>
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
        <translation>Ir para %1</translation>
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
        <translation>Para informação</translation>
    </message>
    <message>
        <source>%1 of %2 of this kind</source>
        <translation>%1 de %2 deste tipo</translation>
    </message>
    <message>
        <source>The one before, of this kind (Ctrl+Shift+F8)</source>
        <translation>O anterior deste tipo (Ctrl+Shift+F8)</translation>
    </message>
    <message>
        <source>The next of this kind (Ctrl+F8)</source>
        <translation>O próximo deste tipo (Ctrl+F8)</translation>
    </message>
</context>
<context>
    <name>GuidePanel</name>
    <message>
        <source>All chapters</source>
        <translation>Todos os capítulos</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>Guia</translation>
    </message>
    <message>
        <source>Close the guide (Esc)</source>
        <translation>Fechar o guia (Esc)</translation>
    </message>
    <message>
        <source>Search the guide</source>
        <translation>Buscar no guia</translation>
    </message>
    <message>
        <source>Nothing is found. Try another word.</source>
        <translation>Nada encontrado. Tente outra palavra.</translation>
    </message>
</context>
<context>
    <name>HeadingChart</name>
    <message>
        <source>Time by</source>
        <translation>Tempo por</translation>
    </message>
    <message>
        <source>direction</source>
        <translation>direção</translation>
    </message>
    <message>
        <source>overlap</source>
        <translation>sobreposição</translation>
    </message>
    <message>
        <source>missed</source>
        <translation>falhas</translation>
    </message>
    <message>
        <source>turning</source>
        <translation>manobras</translation>
    </message>
    <message>
        <source>Time by %1</source>
        <translation>Tempo por %1</translation>
    </message>
    <message>
        <source>Directions of swaths and their times</source>
        <translation>Direções das passadas e seus tempos</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>%1 at least</source>
        <translation>no mínimo %1</translation>
    </message>
    <message>
        <source>Estimates for the land inside the headland, to and fro. The plan adds headland, short passes and ways.</source>
        <translation>Estimativas para a área dentro da cabeceira, em vaivém. O plano acrescenta cabeceira, passadas curtas e trajetos.</translation>
    </message>
    <message>
        <source>Let Furrow search the direction</source>
        <translation>Deixar o Furrow buscar a direção</translation>
    </message>
</context>
<context>
    <name>HelpCommands</name>
    <message>
        <source>Help</source>
        <translation>Ajuda</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>Guia</translation>
    </message>
    <message>
        <source>help manual how to documentation</source>
        <translation>ajuda manual documentação como</translation>
    </message>
    <message>
        <source>Take the tour</source>
        <translation>Fazer a visita guiada</translation>
    </message>
    <message>
        <source>help introduction first start</source>
        <translation>ajuda introdução primeiro início</translation>
    </message>
    <message>
        <source>Keys and mouse</source>
        <translation>Teclas e mouse</translation>
    </message>
    <message>
        <source>shortcuts help</source>
        <translation>atalhos ajuda</translation>
    </message>
    <message>
        <source>Report a problem…</source>
        <translation>Relatar um problema…</translation>
    </message>
    <message>
        <source>bug crash support error</source>
        <translation>erro falha suporte</translation>
    </message>
    <message>
        <source>About Furrow</source>
        <translation>Sobre o Furrow</translation>
    </message>
    <message>
        <source>version licence credits</source>
        <translation>versão licença créditos</translation>
    </message>
</context>
<context>
    <name>ImageryDialogs</name>
    <message>
        <source>All files (*)</source>
        <translation>Todos os arquivos (*)</translation>
    </message>
    <message>
        <source>Add imagery</source>
        <translation>Adicionar imagens</translation>
    </message>
    <message>
        <source>Pictures and heights (%1)</source>
        <translation>Imagens e altitudes (%1)</translation>
    </message>
    <message>
        <source>Add a folder of tiles</source>
        <translation>Adicionar uma pasta de blocos</translation>
    </message>
</context>
<context>
    <name>ImageryList</name>
    <message>
        <source>Your own pictures and heights: GeoTIFF, MBTiles or a folder of tiles. They stay on this computer.</source>
        <translation>Suas próprias imagens e altitudes: GeoTIFF, MBTiles ou uma pasta de blocos. Elas ficam neste computador.</translation>
    </message>
    <message>
        <source>Add files…</source>
        <translation>Adicionar arquivos…</translation>
    </message>
    <message>
        <source>Add a folder of tiles…</source>
        <translation>Adicionar uma pasta de blocos…</translation>
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
        <translation>Mostrar %1 por inteiro</translation>
    </message>
    <message>
        <source>Move %1 up</source>
        <translation>Mover %1 para cima</translation>
    </message>
    <message>
        <source>Move %1 down</source>
        <translation>Mover %1 para baixo</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>Remover %1</translation>
    </message>
    <message>
        <source>How strong %1 is</source>
        <translation>Opacidade de %1</translation>
    </message>
    <message>
        <source>Opening …</source>
        <translation>Abrindo…</translation>
    </message>
    <message>
        <source>Contour lines every %1</source>
        <translation>Curvas de nível a cada %1</translation>
    </message>
    <message>
        <source>Rows count from the south (TMS)</source>
        <translation>Linhas contadas a partir do sul (TMS)</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Tentar de novo</translation>
    </message>
</context>
<context>
    <name>Inspector</name>
    <message>
        <source>Headland</source>
        <translation>Cabeceira</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nome</translation>
    </message>
    <message>
        <source>boundary</source>
        <translation>limite do talhão</translation>
    </message>
    <message>
        <source>hole</source>
        <translation>vazio</translation>
    </message>
    <message>
        <source>obstacle</source>
        <translation>obstáculo</translation>
    </message>
    <message>
        <source>guidance line</source>
        <translation>linha de orientação</translation>
    </message>
    <message>
        <source>Point %1 of the %2</source>
        <translation>Ponto %1 (%2)</translation>
    </message>
    <message>
        <source>Drag it on the map, move it by arrow keys, or type where it is.</source>
        <translation>Arraste no mapa, mova com as setas ou digite onde fica.</translation>
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
        <translation>Ângulo</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>AB line</source>
        <translation>Linha AB</translation>
    </message>
    <message>
        <source>Edge %1 of the %2</source>
        <translation>Lado %1 (%2)</translation>
    </message>
    <message>
        <source>One swath lies on it, the others beside it. Drag it or its ends, or type its direction.</source>
        <translation>Uma passada fica sobre ela, as outras ao lado. Arraste a linha ou as pontas, ou digite a direção.</translation>
    </message>
    <message>
        <source>Drag it to move it sideways; the dot in its middle makes another point.</source>
        <translation>Arrastar move o lado lateralmente; o ponto no meio cria mais um vértice.</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Comprimento</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Direção</translation>
    </message>
    <message>
        <source>Obstacle</source>
        <translation>Obstáculo</translation>
    </message>
    <message>
        <source>It is not worked, but may be driven on.</source>
        <translation>Não é trabalhado, mas pode-se passar sobre ele.</translation>
    </message>
    <message>
        <source>It is not worked, and nothing drives nearer than its buffer.</source>
        <translation>Não é trabalhado, e nada chega mais perto que essa distância.</translation>
    </message>
    <message>
        <source>Buffer</source>
        <translation>Distância</translation>
    </message>
    <message>
        <source>Overhang</source>
        <translation>Balanço</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Área</translation>
    </message>
    <message>
        <source>the end</source>
        <translation>fim</translation>
    </message>
    <message>
        <source>swath %1</source>
        <translation>passada %1</translation>
    </message>
    <message>
        <source>pass %1</source>
        <translation>passada de cabeceira %1</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>Swath %1</source>
        <translation>Passada %1</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Largura</translation>
    </message>
    <message>
        <source>Headland pass %1</source>
        <translation>Passada de cabeceira %1</translation>
    </message>
    <message>
        <source>Counted from the outside; %1 are worked here in %2.</source>
        <translation>Contada de fora; aqui são trabalhados %1 em %2.</translation>
    </message>
    <message>
        <source>Turn from %1 to %2</source>
        <translation>Manobra: %1 → %2</translation>
    </message>
    <message>
        <source>%1 in reverse, in %2.</source>
        <translation>%1 de ré, em %2.</translation>
    </message>
    <message>
        <source>%1 with the implement up, in %2.</source>
        <translation>%1 com o implemento levantado, em %2.</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Way from %1 to %2</source>
        <translation>Deslocamento: %1 → %2</translation>
    </message>
    <message>
        <source>%1 without working, in %2.</source>
        <translation>%1 sem trabalhar, em %2.</translation>
    </message>
    <message>
        <source>It cannot be driven like this: %1.</source>
        <translation>Assim não pode ser percorrido: %1.</translation>
    </message>
    <message>
        <source>Block %1</source>
        <translation>Subtalhão %1</translation>
    </message>
    <message numerus="yes">
        <source>A piece of the field whose %n swath(s) are driven together.</source>
        <translation>
            <numerusform>Um pedaço do interior do talhão com %n passada.</numerusform>
            <numerusform>Um pedaço do interior do talhão cujas %n passadas são feitas juntas.</numerusform>
        </translation>
    </message>
    <message>
        <source>Swaths</source>
        <translation>Passadas</translation>
    </message>
    <message>
        <source>Gate</source>
        <translation>Entrada</translation>
    </message>
    <message>
        <source>Here the machine may enter and leave the field. Drag it along the boundary.</source>
        <translation>Aqui a máquina pode entrar e sair. Arraste ao longo do limite.</translation>
    </message>
    <message>
        <source>Guidance curve</source>
        <translation>Curva de orientação</translation>
    </message>
    <message>
        <source>The swaths lie beside it. Drag its points, or delete it.</source>
        <translation>As passadas ficam ao lado. Arraste os pontos ou exclua a curva.</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Pontos</translation>
    </message>
    <message>
        <source>Hole</source>
        <translation>Vazio</translation>
    </message>
    <message>
        <source>It is no part of the field. Drag it, or its points and edges.</source>
        <translation>Não faz parte do talhão. Arraste-o, ou seus pontos e lados.</translation>
    </message>
    <message>
        <source>split line</source>
        <translation>linha de divisão</translation>
    </message>
    <message>
        <source>The field inside the headland is cut along it, where it runs right through. Drag it or its points, or delete it.</source>
        <translation>O interior é dividido ao longo dela onde ela o atravessa por inteiro. Arraste a linha ou os pontos, ou exclua-a.</translation>
    </message>
    <message>
        <source>Split line %1</source>
        <translation>Linha de divisão %1</translation>
    </message>
    <message>
        <source>%1 with the implement folded, in %2.</source>
        <translation>%1 com o implemento dobrado, em %2.</translation>
    </message>
    <message>
        <source>Whole turn</source>
        <translation>Manobra inteira</translation>
    </message>
    <message>
        <source>Driven as number %1 of %2: %3 in %4.</source>
        <translation>Feita como número %1 de %2: %3 em %4.</translation>
    </message>
    <message>
        <source>From the edge</source>
        <translation>Distância da borda</translation>
    </message>
    <message>
        <source>Instead: %1</source>
        <translation>Em vez disso: %1</translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>cerca de %1</translation>
    </message>
    <message>
        <source>no room</source>
        <translation>não cabe</translation>
    </message>
    <message>
        <source>In the bunker</source>
        <translation>No tanque graneleiro</translation>
    </message>
    <message>
        <source>In the tank</source>
        <translation>No tanque</translation>
    </message>
    <message>
        <source>Then stands</source>
        <translation>Depois fica parado</translation>
    </message>
</context>
<context>
    <name>InspectorPanel</name>
    <message>
        <source>Headland as elsewhere</source>
        <translation>Cabeceira como no resto</translation>
    </message>
    <message>
        <source>selected</source>
        <translation>selecionado</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>May be driven on</source>
        <translation>Pode-se passar sobre ele</translation>
    </message>
    <message>
        <source>Swaths along it</source>
        <translation>Passadas paralelas</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Excluir</translation>
    </message>
    <message>
        <source>Drive from here</source>
        <translation>Percorrer daqui</translation>
    </message>
</context>
<context>
    <name>KeysDialog</name>
    <message>
        <source>Drag the map, wheel</source>
        <translation>Arrastar o mapa, roda</translation>
    </message>
    <message>
        <source>move, zoom</source>
        <translation>mover, ampliar</translation>
    </message>
    <message>
        <source>Arrows, + and −</source>
        <translation>Setas, + e −</translation>
    </message>
    <message>
        <source>move the selection or the map, zoom</source>
        <translation>mover a seleção ou o mapa, ampliar</translation>
    </message>
    <message>
        <source>, and .</source>
        <translation>, e .</translation>
    </message>
    <message>
        <source>the point before, the next point</source>
        <translation>ponto anterior, próximo</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Enter</translation>
    </message>
    <message>
        <source>finish drawing; type into the inspector</source>
        <translation>concluir o desenho; digitar à direita</translation>
    </message>
    <message>
        <source>Alt</source>
        <translation>Alt</translation>
    </message>
    <message>
        <source>no snapping while it is held</source>
        <translation>sem encaixe enquanto pressionada</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>stop what was begun</source>
        <translation>parar o que foi começado</translation>
    </message>
    <message>
        <source>Keys and mouse</source>
        <translation>Teclas e mouse</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fechar</translation>
    </message>
</context>
<context>
    <name>LayerSwitches</name>
    <message>
        <source>Boundary</source>
        <translation>Limite do talhão</translation>
    </message>
    <message>
        <source>Headland</source>
        <translation>Cabeceira</translation>
    </message>
    <message>
        <source>Swaths</source>
        <translation>Passadas</translation>
    </message>
    <message>
        <source>Order numbers</source>
        <translation>Números de ordem</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Avisos</translation>
    </message>
    <message>
        <source>Imagery</source>
        <translation>Imagens</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Percurso</translation>
    </message>
    <message>
        <source>Directions</source>
        <translation>Sentido de marcha</translation>
    </message>
    <message>
        <source>Coverage</source>
        <translation>Trabalhado</translation>
    </message>
    <message>
        <source>Worked twice</source>
        <translation>Trabalhado duas vezes</translation>
    </message>
    <message>
        <source>Missed</source>
        <translation>Falhas</translation>
    </message>
    <message>
        <source>Wheel passes</source>
        <translation>Passagens de roda</translation>
    </message>
    <message>
        <source>Swath numbers</source>
        <translation>Números das passadas</translation>
    </message>
</context>
<context>
    <name>LayersPanel</name>
    <message>
        <source>Layers</source>
        <translation>Camadas</translation>
    </message>
    <message>
        <source>Close the layers</source>
        <translation>Fechar as camadas</translation>
    </message>
    <message>
        <source>Imagery</source>
        <translation>Imagens</translation>
    </message>
    <message>
        <source>From the network</source>
        <translation>Da rede</translation>
    </message>
    <message>
        <source>OpenStreetMap</source>
        <translation>OpenStreetMap</translation>
    </message>
    <message>
        <source>Asks openstreetmap.org for what is in view. Off, nothing leaves this computer.</source>
        <translation>Pede a openstreetmap.org o que está à vista. Desativado, nada sai deste computador.</translation>
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
        <translation>Valores originais</translation>
    </message>
    <message>
        <source>Keep as your own…</source>
        <translation>Guardar como sua…</translation>
    </message>
    <message>
        <source>Remove from your own</source>
        <translation>Remover das suas</translation>
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
        <translation>Renomear o talhão</translation>
    </message>
    <message>
        <source>Add a plan</source>
        <translation>Adicionar um plano</translation>
    </message>
    <message>
        <source>Rename the plan</source>
        <translation>Renomear o plano</translation>
    </message>
    <message>
        <source>Add a plan to each field</source>
        <translation>Adicionar um plano a cada talhão</translation>
    </message>
    <message>
        <source>Keep as a variant</source>
        <translation>Guardar como variante</translation>
    </message>
    <message>
        <source>Keep the machine as</source>
        <translation>Guardar a máquina como</translation>
    </message>
    <message>
        <source>This plan: %1</source>
        <translation>Este plano: %1</translation>
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
        <translation>Selecionar e alterar (V)</translation>
    </message>
    <message>
        <source>Draw a field (B)</source>
        <translation>Desenhar um talhão (B)</translation>
    </message>
    <message>
        <source>Draw a hole (H)</source>
        <translation>Desenhar um vazio (H)</translation>
    </message>
    <message>
        <source>Draw an obstacle (O)</source>
        <translation>Desenhar um obstáculo (O)</translation>
    </message>
    <message>
        <source>Draw an AB line (L)</source>
        <translation>Desenhar uma linha AB (L)</translation>
    </message>
    <message>
        <source>Add a gate (G)</source>
        <translation>Adicionar uma entrada (G)</translation>
    </message>
    <message>
        <source>Show the whole field (F)</source>
        <translation>Mostrar todo o talhão (F)</translation>
    </message>
    <message>
        <source>Closer (+)</source>
        <translation>Aproximar (+)</translation>
    </message>
    <message>
        <source>Further away (−)</source>
        <translation>Afastar (−)</translation>
    </message>
    <message>
        <source>Layers (Ctrl+L)</source>
        <translation>Camadas (Ctrl+L)</translation>
    </message>
    <message>
        <source>Draw a split line (S)</source>
        <translation>Desenhar uma linha de divisão (S)</translation>
    </message>
</context>
<context>
    <name>NameDialog</name>
    <message>
        <source>Name</source>
        <translation>Nome</translation>
    </message>
    <message>
        <source>Season</source>
        <translation>Safra</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
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
        <translation>© Colaboradores do OpenStreetMap</translation>
    </message>
</context>
<context>
    <name>OrderEditor</name>
    <message>
        <source>Change the order by hand…</source>
        <translation>Mudar a ordem à mão…</translation>
    </message>
    <message>
        <source>Drag a swath to its new place. Or click swaths on the map: each is driven after the one clicked before.</source>
        <translation>Arraste uma passada ao novo lugar. Ou clique em passadas no mapa: cada uma segue a anterior.</translation>
    </message>
    <message>
        <source>Order of swaths</source>
        <translation>Ordem das passadas</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Concluir</translation>
    </message>
    <message>
        <source>Search the order of the others</source>
        <translation>Buscar a ordem das outras</translation>
    </message>
    <message>
        <source>Search the order again</source>
        <translation>Buscar a ordem de novo</translation>
    </message>
</context>
<context>
    <name>OrderForm</name>
    <message>
        <source>Status</source>
        <translation>Situação</translation>
    </message>
</context>
<context>
    <name>OrderRow</name>
    <message>
        <source>%1. Swath %2, %3</source>
        <translation>%1. Passada %2, %3</translation>
    </message>
    <message>
        <source>Swath %1</source>
        <translation>Passada %1</translation>
    </message>
    <message>
        <source>Drive swath %1 the other way</source>
        <translation>Percorrer a passada %1 ao contrário</translation>
    </message>
</context>
<context>
    <name>OtherMap</name>
    <message>
        <source>Map of the other plan: %1</source>
        <translation>Mapa do outro plano: %1</translation>
    </message>
    <message>
        <source>The other plan is being made …</source>
        <translation>O outro plano está sendo calculado…</translation>
    </message>
    <message>
        <source>The other: %1</source>
        <translation>O outro: %1</translation>
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
        <translation>Planejando para as páginas …</translation>
    </message>
    <message>
        <source>Stopped before there were pages.</source>
        <translation>Parado antes de haver páginas.</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Tentar de novo</translation>
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
        <translation>%1: deixar o Furrow escolher</translation>
    </message>
    <message>
        <source>as text</source>
        <translation>como texto</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Escolher…</translation>
    </message>
    <message>
        <source>On the map</source>
        <translation>No mapa</translation>
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
        <translation>não escolhido</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Remover</translation>
    </message>
    <message>
        <source>%1: remove</source>
        <translation>%1: remover</translation>
    </message>
</context>
<context>
    <name>Pickers</name>
    <message>
        <source>Click the place on the map. Esc ends it.</source>
        <translation>Clique no lugar no mapa. Esc para encerrar.</translation>
    </message>
    <message>
        <source>Click the places on the map</source>
        <translation>Clique nos lugares no mapa</translation>
    </message>
    <message>
        <source>Click another place, or one of them to remove it</source>
        <translation>Clique em outro lugar, ou em um deles para removê-lo</translation>
    </message>
</context>
<context>
    <name>PlacesPicker</name>
    <message>
        <source>Place %1: remove it</source>
        <translation>Lugar %1: remover</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Concluída</translation>
    </message>
</context>
<context>
    <name>PlanCommands</name>
    <message>
        <source>Plan</source>
        <translation>Plano</translation>
    </message>
    <message>
        <source>Drive-through</source>
        <translation>Percurso</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>Revisão</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Avisos</translation>
    </message>
    <message>
        <source>Add a plan…</source>
        <translation>Adicionar um plano…</translation>
    </message>
    <message>
        <source>season operation copy</source>
        <translation>safra operação cópia</translation>
    </message>
    <message>
        <source>Compare with another plan</source>
        <translation>Comparar com outro plano</translation>
    </message>
    <message>
        <source>compare variants differences side by side better</source>
        <translation>comparar variantes diferenças lado a lado melhor</translation>
    </message>
    <message>
        <source>Compare on two maps</source>
        <translation>Comparar em dois mapas</translation>
    </message>
    <message>
        <source>compare side by side split map</source>
        <translation>comparar lado a lado mapa dividido dois</translation>
    </message>
    <message>
        <source>Compare with a recorded track…</source>
        <translation>Comparar com um percurso gravado…</translation>
    </message>
    <message>
        <source>driven recorded GPX NMEA log cross-track error compare</source>
        <translation>percorrido gravado GPX NMEA desvio comparar</translation>
    </message>
    <message>
        <source>Rename the plan…</source>
        <translation>Renomear o plano…</translation>
    </message>
    <message>
        <source>Remove the plan</source>
        <translation>Remover o plano</translation>
    </message>
    <message>
        <source>delete</source>
        <translation>excluir</translation>
    </message>
    <message>
        <source>Plan again</source>
        <translation>Planejar de novo</translation>
    </message>
    <message>
        <source>Find the best plan…</source>
        <translation>Buscar o melhor plano…</translation>
    </message>
    <message>
        <source>quickest optimise compare alternatives</source>
        <translation>mais rápido otimizar comparar alternativas</translation>
    </message>
    <message>
        <source>Change the order by hand…</source>
        <translation>Mudar a ordem à mão…</translation>
    </message>
    <message>
        <source>order swaths list drag sequence</source>
        <translation>ordem passadas lista arrastar sequência</translation>
    </message>
    <message>
        <source>Drive through the plan</source>
        <translation>Percorrer o plano</translation>
    </message>
    <message>
        <source>Pause the drive</source>
        <translation>Pausar o percurso</translation>
    </message>
    <message>
        <source>drive play pause simulate machine</source>
        <translation>percorrer reproduzir pausar simular máquina</translation>
    </message>
    <message>
        <source>Drive from what is selected</source>
        <translation>Percorrer a partir da seleção</translation>
    </message>
    <message>
        <source>drive play here swath turn</source>
        <translation>percorrer aqui passada manobra</translation>
    </message>
    <message>
        <source>Drive faster</source>
        <translation>Percorrer mais rápido</translation>
    </message>
    <message>
        <source>pace speed</source>
        <translation>ritmo velocidade</translation>
    </message>
    <message>
        <source>Drive slower</source>
        <translation>Percorrer mais devagar</translation>
    </message>
    <message>
        <source>Comment on a place…</source>
        <translation>Comentar um lugar…</translation>
    </message>
    <message>
        <source>review note remark pin</source>
        <translation>revisão nota observação lugar</translation>
    </message>
    <message>
        <source>Comment on the whole plan…</source>
        <translation>Comentar o plano todo…</translation>
    </message>
    <message>
        <source>review note remark</source>
        <translation>revisão nota observação</translation>
    </message>
    <message>
        <source>contractor share file approve</source>
        <translation>prestador compartilhar arquivo aprovar</translation>
    </message>
    <message>
        <source>Take in a review that came back…</source>
        <translation>Incorporar uma revisão que voltou…</translation>
    </message>
    <message>
        <source>merge comments contractor</source>
        <translation>juntar comentários prestador</translation>
    </message>
    <message>
        <source>Next finding</source>
        <translation>Próximo aviso</translation>
    </message>
    <message>
        <source>problem check step through</source>
        <translation>problema verificar percorrer</translation>
    </message>
    <message>
        <source>Previous finding</source>
        <translation>Aviso anterior</translation>
    </message>
    <message>
        <source>problem check step back</source>
        <translation>problema verificar voltar</translation>
    </message>
    <message>
        <source>Next finding of the same kind</source>
        <translation>Próximo aviso do mesmo tipo</translation>
    </message>
    <message>
        <source>Previous finding of the same kind</source>
        <translation>Aviso anterior do mesmo tipo</translation>
    </message>
</context>
<context>
    <name>PlanTitle</name>
    <message>
        <source>%1 wide</source>
        <translation>%1 de largura</translation>
    </message>
    <message>
        <source>takes %1</source>
        <translation>leva %1</translation>
    </message>
    <message>
        <source>planned %1</source>
        <translation>planejado em %1</translation>
    </message>
</context>
<context>
    <name>Planner</name>
    <message>
        <source> and twice %1 of margin</source>
        <translation> e duas vezes %1 de margem</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 e %2</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 e mais %2</translation>
    </message>
    <message>
        <source>%1 are driven in reverse; the trailed implement cannot.</source>
        <translation>%1 são percorridos de ré; o implemento rebocado não consegue.</translation>
    </message>
    <message>
        <source>%1 are driven in reverse; this machine cannot.</source>
        <translation>%1 são percorridos de ré; esta máquina não consegue.</translation>
    </message>
    <message>
        <source>%1 are not worked, %2 of the field, in %3; this is the largest.</source>
        <translation>%1 não são trabalhados, %2 do talhão, em %3; esta é a maior falha.</translation>
    </message>
    <message>
        <source>%1 bends with a radius of %2; this machine needs %3.</source>
        <translation>%1 tem curvas com raio de %2; esta máquina precisa de %3.</translation>
    </message>
    <message>
        <source>%1 cannot be driven: %2.</source>
        <translation>%1 não pode ser percorrido: %2.</translation>
    </message>
    <message>
        <source>%1 cannot be made: %2</source>
        <translation>não é possível criar %1: %2</translation>
    </message>
    <message>
        <source>%1 crosses an obstacle, by %2.</source>
        <translation>%1 avança %2 sobre um obstáculo.</translation>
    </message>
    <message>
        <source>%1 crosses an obstacle.</source>
        <translation>%1 cruza um obstáculo.</translation>
    </message>
    <message>
        <source>%1 does not fit here</source>
        <translation>%1 não serve aqui</translation>
    </message>
    <message>
        <source>%1 for transport is wider than the machine at work, %2</source>
        <translation>%1 para transporte é mais largo que a máquina em trabalho, %2</translation>
    </message>
    <message>
        <source>%1 holds no positions</source>
        <translation>%1 não contém posições</translation>
    </message>
    <message>
        <source>%1 in one piece are not worked.</source>
        <translation>%1 em um só pedaço não são trabalhados.</translation>
    </message>
    <message>
        <source>%1 is %2 wide; this machine is %3 wide for transport.</source>
        <translation>%1 tem %2 de largura; esta máquina tem %3 de largura para transporte.</translation>
    </message>
    <message>
        <source>%1 is not a whole number</source>
        <translation>%1 não é um número inteiro</translation>
    </message>
    <message>
        <source>%1 is on the stick already</source>
        <translation>%1 já está no pen drive</translation>
    </message>
    <message>
        <source>%1 is out of range</source>
        <translation>%1 está fora da faixa</translation>
    </message>
    <message>
        <source>%1 is planned, but nothing of it is driven with the implement down.</source>
        <translation>%1 está prevista, mas nada dela é percorrido com o implemento abaixado.</translation>
    </message>
    <message>
        <source>%1 is planned, but only %2 of it is driven with the implement down.</source>
        <translation>%1 está prevista, mas só %2 dela é percorrido com o implemento abaixado.</translation>
    </message>
    <message>
        <source>%1 jumps by %2.</source>
        <translation>%1 salta %2.</translation>
    </message>
    <message>
        <source>%1 leads from one part of the field to another that this machine cannot drive to.</source>
        <translation>%1 leva de uma parte do talhão a outra que esta máquina não alcança.</translation>
    </message>
    <message>
        <source>%1 leaves the field by %2.</source>
        <translation>%1 sai %2 do talhão.</translation>
    </message>
    <message>
        <source>%1 leaves the field or crosses an obstacle, by up to %2, as this plan allows.</source>
        <translation>%1 sai do talhão ou avança sobre um obstáculo, em até %2, como este plano permite.</translation>
    </message>
    <message>
        <source>%1 moves %2 off where the machine points.</source>
        <translation>%1 se desvia %2 do rumo da máquina.</translation>
    </message>
    <message>
        <source>%1 needs %2</source>
        <translation>%1 precisa de: %2</translation>
    </message>
    <message>
        <source>%1 of %2 guidance lines of &apos;%3&apos; are there</source>
        <translation>há %1 de %2 linhas de orientação de “%3”</translation>
    </message>
    <message>
        <source>%1 of %2 swaths are not in the order: %3</source>
        <translation>%1 de %2 passadas não estão na ordem: %3</translation>
    </message>
    <message>
        <source>%1 of %2 tracks are of another place and were left out</source>
        <translation>%1 de %2 percursos são de outro lugar e ficaram de fora</translation>
    </message>
    <message>
        <source>%1 of its sentences have a wrong checksum</source>
        <translation>%1 de suas sentenças têm uma soma de verificação errada</translation>
    </message>
    <message>
        <source>%1 of margin leaves nothing of the field to work</source>
        <translation>%1 de margem não deixam nada do talhão para trabalhar</translation>
    </message>
    <message>
        <source>%1 of the positions jump away and back</source>
        <translation>%1 das posições saltam para longe e voltam</translation>
    </message>
    <message>
        <source>%1 reads back other bytes than were written</source>
        <translation>%1, relido, não é igual ao que foi gravado</translation>
    </message>
    <message>
        <source>%1 small patches of worked pixels are left out</source>
        <translation>%1 pequenas manchas de pixels trabalhados ficam de fora</translation>
    </message>
    <message>
        <source>%1 swaths and turns leave the field or cross an obstacle, by up to %2, as this plan allows.</source>
        <translation>%1 passadas e manobras saem do talhão ou avançam sobre um obstáculo, em até %2, como este plano permite.</translation>
    </message>
    <message>
        <source>%1, %2 is more than 1,000 km from the plan</source>
        <translation>%1, %2 fica a mais de 1.000 km do plano</translation>
    </message>
    <message>
        <source>%1, %2 is no longitude and latitude</source>
        <translation>%1, %2 não é longitude e latitude</translation>
    </message>
    <message>
        <source>%1, %2 is no longitude and latitude, and the file does not say which coordinate system it uses</source>
        <translation>%1, %2 não é longitude e latitude, e o arquivo não diz qual sistema de coordenadas usa</translation>
    </message>
    <message>
        <source>%1, %2 is outside longitude -180 to 180 and latitude -90 to 90</source>
        <translation>%1, %2 está fora da longitude -180 a 180 e latitude -90 a 90</translation>
    </message>
    <message>
        <source>%1, %2, line %3</source>
        <translation>%1, %2, linha %3</translation>
    </message>
    <message>
        <source>%1, %2, point %3</source>
        <translation>%1, %2, ponto %3</translation>
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
        <translation>%1, vazio %2</translation>
    </message>
    <message>
        <source>%1, line %2</source>
        <translation>%1, linha %2</translation>
    </message>
    <message>
        <source>%1, obstacle %2</source>
        <translation>%1, obstáculo %2</translation>
    </message>
    <message>
        <source>%1, point %2</source>
        <translation>%1, ponto %2</translation>
    </message>
    <message>
        <source>%1, row %2</source>
        <translation>%1, linha %2</translation>
    </message>
    <message>
        <source>%1.bin is not there</source>
        <translation>%1.bin não existe</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: the setting %2 is not used: %3</source>
        <translation>%1: a configuração %2 não é usada: %3</translation>
    </message>
    <message>
        <source>%1; %2 × other turns</source>
        <translation>%1; %2 × outras manobras</translation>
    </message>
    <message>
        <source>%1; what it belongs to was left out</source>
        <translation>%1; aquilo a que pertence foi deixado de fora</translation>
    </message>
    <message numerus="yes">
        <source>%n areas are neither field, hole nor obstacle by their layer or kind and were not used</source>
        <translation>
            <numerusform>%n área não é, pela camada ou pelo tipo, nem talhão, nem vazio, nem obstáculo e não foi usada</numerusform>
            <numerusform>%n áreas não são, pela camada ou pelo tipo, nem talhão, nem vazio, nem obstáculo e não foram usadas</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n areas in the file are neither field nor obstacle and were not used</source>
        <translation>
            <numerusform>%n área no arquivo não é talhão nem obstáculo e não foi usada</numerusform>
            <numerusform>%n áreas no arquivo não são talhão nem obstáculo e não foram usadas</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n damaged lines were passed over</source>
        <translation>
            <numerusform>%n linha danificada foi ignorada</numerusform>
            <numerusform>%n linhas danificadas foram ignoradas</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n entries without a shape</source>
        <translation>
            <numerusform>%n item sem forma</numerusform>
            <numerusform>%n itens sem forma</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n fields</source>
        <translation>
            <numerusform>%n talhão</numerusform>
            <numerusform>%n talhões</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n messages without a position were passed over</source>
        <translation>
            <numerusform>%n mensagem sem posição foi ignorada</numerusform>
            <numerusform>%n mensagens sem posição foram ignoradas</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n open lines</source>
        <translation>
            <numerusform>%n linha aberta</numerusform>
            <numerusform>%n linhas abertas</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n passes</source>
        <translation>
            <numerusform>%n passada</numerusform>
            <numerusform>%n passadas</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pieces</source>
        <translation>
            <numerusform>%n pedaço</numerusform>
            <numerusform>%n pedaços</numerusform>
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
            <numerusform>%n ponto</numerusform>
            <numerusform>%n pontos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n points were given twice and taken once</source>
        <translation>
            <numerusform>%n ponto estava repetido e conta uma vez</numerusform>
            <numerusform>%n pontos estavam repetidos e contam uma vez</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n positions that jumped away were left out</source>
        <translation>
            <numerusform>%n posição que saltou para longe ficou de fora</numerusform>
            <numerusform>%n posições que saltaram para longe ficaram de fora</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n records without a position were passed over</source>
        <translation>
            <numerusform>%n registro sem posição foi ignorado</numerusform>
            <numerusform>%n registros sem posição foram ignorados</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n reports without a position were passed over</source>
        <translation>
            <numerusform>%n relatório sem posição foi ignorado</numerusform>
            <numerusform>%n relatórios sem posição foram ignorados</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n rings did not end where they began and were closed</source>
        <translation>
            <numerusform>%n anel não terminava onde começou e foi fechado</numerusform>
            <numerusform>%n anéis não terminavam onde começaram e foram fechados</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n rings ran the wrong way round and were turned</source>
        <translation>
            <numerusform>%n anel estava ao contrário e foi invertido</numerusform>
            <numerusform>%n anéis estavam ao contrário e foram invertidos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n rows without a position were passed over</source>
        <translation>
            <numerusform>%n linha sem posição foi ignorada</numerusform>
            <numerusform>%n linhas sem posição foram ignoradas</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sentences with a wrong checksum were passed over</source>
        <translation>
            <numerusform>%n sentença com soma de verificação errada foi ignorada</numerusform>
            <numerusform>%n sentenças com soma de verificação errada foram ignoradas</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sentences without a position were passed over</source>
        <translation>
            <numerusform>%n sentença sem posição foi ignorada</numerusform>
            <numerusform>%n sentenças sem posição foram ignoradas</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n spikes without area were removed</source>
        <translation>
            <numerusform>%n ponta sem área foi removida</numerusform>
            <numerusform>%n pontas sem área foram removidas</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n stretches of one strip were left out, as ways to the field: %1 together</source>
        <translation>
            <numerusform>%n trecho de uma só faixa ficou de fora, como caminho até o talhão: %1</numerusform>
            <numerusform>%n trechos de uma só faixa ficaram de fora, como caminhos até o talhão: %1 no total</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n turns</source>
        <translation>
            <numerusform>%n manobra</numerusform>
            <numerusform>%n manobras</numerusform>
        </translation>
    </message>
    <message>
        <source>&apos;%1&apos; files hold no recorded track</source>
        <translation>arquivos “%1” não contêm nenhum percurso gravado</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is left out: its kind %2 is not known</source>
        <translation>“%1” fica de fora: o tipo %2 não é conhecido</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no length</source>
        <translation>“%1” não é um comprimento</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no local frame</source>
        <translation>“%1” não é um sistema local</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not %2</source>
        <translation>“%1” não é: %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a line</source>
        <translation>“%1” não é uma linha</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not well-known text</source>
        <translation>“%1” não é well-known text</translation>
    </message>
    <message>
        <source>&apos;%1&apos;, &apos;%2&apos; is no latitude and longitude</source>
        <translation>“%1”, “%2” não é latitude e longitude</translation>
    </message>
    <message>
        <source>&apos;%1&apos;, &apos;%2&apos; is no longitude and latitude</source>
        <translation>“%1”, “%2” não é longitude e latitude</translation>
    </message>
    <message>
        <source>&apos;%1&apos;, &apos;%2&apos; is no position</source>
        <translation>“%1”, “%2” não é uma posição</translation>
    </message>
    <message>
        <source>A and B are %1 apart</source>
        <translation>A e B estão a %1 um do outro</translation>
    </message>
    <message>
        <source>A bulb to both sides; for swaths nearer than two turning radii.</source>
        <translation>Abre para os dois lados; para passadas a menos de dois raios de giro.</translation>
    </message>
    <message>
        <source>A bulb to one side and straight back; for swaths nearer than two turning radii.</source>
        <translation>Abre para um lado e volta reto; para passadas a menos de dois raios de giro.</translation>
    </message>
    <message>
        <source>A block gets a heading of its own where that saves time.</source>
        <translation>Um subtalhão tem direção própria onde isso economiza tempo.</translation>
    </message>
    <message>
        <source>A file of lines: planted rows, or the tramlines of a plan.</source>
        <translation>Um arquivo de linhas: fileiras plantadas ou os rastros de pulverização de um plano.</translation>
    </message>
    <message>
        <source>A gate&apos;s name or a point; the first gate where nothing is given.</source>
        <translation>Nome de uma entrada ou um ponto; a primeira entrada se nada for informado.</translation>
    </message>
    <message>
        <source>A goal of opennav_coverage has one outline: %1 of %2 parts are left out.</source>
        <translation>Um objetivo do opennav_coverage tem um contorno: %1 de %2 partes ficam de fora.</translation>
    </message>
    <message>
        <source>A raster of heights in metres that covers the field, such as a GeoTIFF.</source>
        <translation>Um raster de altitudes em metros que cubra o talhão, como um GeoTIFF.</translation>
    </message>
    <message>
        <source>A robot with ROS 2</source>
        <translation>Um robô com ROS 2</translation>
    </message>
    <message>
        <source>A snake within each cluster of swaths, cluster after cluster.</source>
        <translation>Uma serpentina em cada grupo de passadas, grupo após grupo.</translation>
    </message>
    <message>
        <source>A strip of the same width along the boundary and around obstacles, for turning.</source>
        <translation>Uma faixa de mesma largura ao longo do limite e em volta de obstáculos, para manobrar.</translation>
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
        <translation>Linha AB</translation>
    </message>
    <message>
        <source>Across the slope: beside a line of equal height, and a new one where that no longer fits.</source>
        <translation>Cruzando o declive: ao lado de uma curva de nível, e de uma nova onde não serve mais.</translation>
    </message>
    <message>
        <source>After the swaths</source>
        <translation>Depois das passadas</translation>
    </message>
    <message>
        <source>AgBot</source>
        <translation>AgBot</translation>
    </message>
    <message>
        <source>AgGPS folder</source>
        <translation>Pasta AgGPS</translation>
    </message>
    <message>
        <source>AgOpenGPS 6, import of ISOXML</source>
        <translation>AgOpenGPS 6, importação de ISOXML</translation>
    </message>
    <message>
        <source>AgOpenGPS drives recorded paths forwards only, and this one reverses %1 times: its %2 forward stretches are &apos;Part 01.rec&apos; and so on, RecPath.txt is the first; %3 under 5 m are left out.</source>
        <translation>O AgOpenGPS só percorre para a frente, e este percurso dá ré %1 vezes: seus %2 trechos para a frente são &apos;Part 01.rec&apos; e assim por diante, RecPath.txt é o primeiro; %3 com menos de 5 m ficam de fora.</translation>
    </message>
    <message>
        <source>AgOpenGPS field</source>
        <translation>Talhão do AgOpenGPS</translation>
    </message>
    <message>
        <source>AgOpenGPS keeps one outline to a field: the %1 parts of &apos;%2&apos; are fields of their own, and the whole path is in the first.</source>
        <translation>O AgOpenGPS guarda um contorno por talhão: as %1 partes de “%2” são talhões próprios, e todo o percurso está no primeiro.</translation>
    </message>
    <message>
        <source>AgOpenGPS keeps one outline to a field: the %1 parts of &apos;%2&apos; are fields of their own.</source>
        <translation>O AgOpenGPS guarda um contorno por talhão: as %1 partes de “%2” são talhões próprios.</translation>
    </message>
    <message>
        <source>All swaths along the edge of the boundary that you pick.</source>
        <translation>Todas as passadas ao longo do lado escolhido do limite.</translation>
    </message>
    <message>
        <source>All swaths along the longest straight edge inside the headland.</source>
        <translation>Todas as passadas ao longo do lado reto mais longo do interior.</translation>
    </message>
    <message>
        <source>All swaths in the direction that you type.</source>
        <translation>Todas as passadas na direção digitada.</translation>
    </message>
    <message>
        <source>Along an edge</source>
        <translation>Ao longo de um lado</translation>
    </message>
    <message>
        <source>Along each edge as wide as the turns there need it; a single pass where no swath ends, or nothing if it is not worked.</source>
        <translation>Em cada lado tão larga quanto as manobras pedem; uma única passada onde nenhuma termina, ou nada se não for trabalhada.</translation>
    </message>
    <message>
        <source>Along rows that are there already, or between them.</source>
        <translation>Ao longo de fileiras que já existem ou entre elas.</translation>
    </message>
    <message>
        <source>Along the boundary</source>
        <translation>Ao longo do limite</translation>
    </message>
    <message>
        <source>Along the contours</source>
        <translation>Pelas curvas de nível</translation>
    </message>
    <message>
        <source>Along the direction of travel.</source>
        <translation>No sentido da marcha.</translation>
    </message>
    <message>
        <source>Along the headland</source>
        <translation>Pela cabeceira</translation>
    </message>
    <message>
        <source>Along the line from A to B; one swath lies on it.</source>
        <translation>Ao longo da linha de A a B; uma passada fica sobre ela.</translation>
    </message>
    <message>
        <source>Along the longest edge</source>
        <translation>Ao longo do lado mais longo</translation>
    </message>
    <message>
        <source>An older ISOBUS terminal</source>
        <translation>Um terminal ISOBUS mais antigo</translation>
    </message>
    <message>
        <source>Another ISOBUS terminal</source>
        <translation>Outro terminal ISOBUS</translation>
    </message>
    <message>
        <source>Anywhere</source>
        <translation>Em qualquer lugar</translation>
    </message>
    <message>
        <source>Arc, straight, arc; for swaths at least two turning radii apart.</source>
        <translation>Arco, reta, arco; para passadas separadas por pelo menos dois raios de giro.</translation>
    </message>
    <message>
        <source>Choose the best that fits, which takes the quickest everywhere.</source>
        <translation>Escolha “A melhor que cabe”, que usa em toda parte a mais rápida.</translation>
    </message>
    <message>
        <source>Joined where that is quicker</source>
        <translation>Unidos onde é mais rápido</translation>
    </message>
    <message>
        <source>As few swaths, and so turns, as possible.</source>
        <translation>O mínimo de passadas, e portanto de manobras.</translation>
    </message>
    <message>
        <source>At obstacles</source>
        <translation>Nos obstáculos</translation>
    </message>
    <message>
        <source>At the left edge</source>
        <translation>Na borda esquerda</translation>
    </message>
    <message>
        <source>At the right edge</source>
        <translation>Na borda direita</translation>
    </message>
    <message>
        <source>At the start of the first swath.</source>
        <translation>No começo da primeira passada.</translation>
    </message>
    <message>
        <source>Before the swaths</source>
        <translation>Antes das passadas</translation>
    </message>
    <message>
        <source>Beside a curve of your own, or beside the edges around the one that you pick.</source>
        <translation>Ao lado de uma curva própria ou dos lados em torno do escolhido.</translation>
    </message>
    <message>
        <source>Best heading</source>
        <translation>Melhor direção</translation>
    </message>
    <message>
        <source>Best of all headings</source>
        <translation>Melhor de todas</translation>
    </message>
    <message>
        <source>Best that fits</source>
        <translation>A melhor que cabe</translation>
    </message>
    <message>
        <source>Between the fixed and the steered axle.</source>
        <translation>Entre o eixo fixo e o direcional.</translation>
    </message>
    <message>
        <source>Between the headings that are tried.</source>
        <translation>Entre as direções testadas.</translation>
    </message>
    <message>
        <source>Between the rows</source>
        <translation>Entre as fileiras</translation>
    </message>
    <message>
        <source>Boundaries in longitude and latitude.</source>
        <translation>Limites em longitude e latitude.</translation>
    </message>
    <message>
        <source>Boundaries, also field files of Fields2Cover and GAOS.</source>
        <translation>Limites, também arquivos do Fields2Cover e GAOS.</translation>
    </message>
    <message>
        <source>Boundaries.</source>
        <translation>Limites de talhão.</translation>
    </message>
    <message>
        <source>Boundary and guidance lines for Trimble and FM displays; no driving order.</source>
        <translation>Limite e linhas de orientação para monitores Trimble e FM; sem ordem das passadas.</translation>
    </message>
    <message>
        <source>Boundary, headland, heading and order; the robot lays swaths and turns itself.</source>
        <translation>Limite, cabeceira, direção e ordem; o robô traça ele mesmo passadas e manobras.</translation>
    </message>
    <message>
        <source>Boundary, holes, headland, guidance lines, and the whole driven path as a recorded path.</source>
        <translation>Limite, vazios, cabeceira, linhas de orientação e todo o percurso como percurso gravado.</translation>
    </message>
    <message>
        <source>Boundary, holes, obstacles and guidance lines for older terminals; no headland, no driving order.</source>
        <translation>Limite, vazios, obstáculos e linhas de orientação para terminais antigos; sem cabeceira nem ordem das passadas.</translation>
    </message>
    <message>
        <source>Boundary, holes, obstacles, gates, headland and guidance lines for terminals; no driving order.</source>
        <translation>Limite, vazios, obstáculos, entradas, cabeceira e linhas de orientação para terminais; sem ordem das passadas.</translation>
    </message>
    <message>
        <source>Boundary, holes, obstacles, headland, swaths and path in metres of the UTM zone.</source>
        <translation>Limite, vazios, obstáculos, cabeceira, passadas e percurso em metros da zona UTM.</translation>
    </message>
    <message>
        <source>Boundary, obstacles, gates, headland, swaths and path, to look at.</source>
        <translation>Limite, obstáculos, entradas, cabeceira, passadas e percurso, para ver.</translation>
    </message>
    <message>
        <source>Boundary, obstacles, gates, headland, swaths, path and findings; for maps and programs.</source>
        <translation>Limite, obstáculos, entradas, cabeceira, passadas, percurso e avisos; para mapas e programas.</translation>
    </message>
    <message>
        <source>Boundary, obstacles, gates, inside of the headland, swaths and path as layers for a GIS.</source>
        <translation>Limite, obstáculos, entradas, interior, passadas e percurso como camadas para um SIG.</translation>
    </message>
    <message>
        <source>Boundary, obstacles, gates, inside of the headland, swaths and path, a shapefile of each.</source>
        <translation>Limite, obstáculos, entradas, interior, passadas e percurso, um shapefile de cada.</translation>
    </message>
    <message>
        <source>Bringing the crop in: headland first, swaths overlap a little.</source>
        <translation>Colher a safra: cabeceira primeiro, as passadas se sobrepõem um pouco.</translation>
    </message>
    <message>
        <source>CSV table</source>
        <translation>Tabela CSV</translation>
    </message>
    <message>
        <source>Can reverse</source>
        <translation>Pode dar ré</translation>
    </message>
    <message>
        <source>Can turn in place</source>
        <translation>Pode girar no lugar</translation>
    </message>
    <message>
        <source>Carried by the tractor, or pulled on a hitch and following its own track.</source>
        <translation>Montado no trator, ou rebocado em um engate seguindo seu próprio rastro.</translation>
    </message>
    <message>
        <source>Blocks</source>
        <translation>Subtalhões</translation>
    </message>
    <message>
        <source>Centre line</source>
        <translation>Linha central</translation>
    </message>
    <message>
        <source>Check that the machine stays inside the field while it turns.</source>
        <translation>Verifique se a máquina fica dentro do talhão ao manobrar.</translation>
    </message>
    <message>
        <source>Choose another place.</source>
        <translation>Escolha outro lugar.</translation>
    </message>
    <message>
        <source>Circles</source>
        <translation>Círculos</translation>
    </message>
    <message>
        <source>Clockwise</source>
        <translation>Sentido horário</translation>
    </message>
    <message>
        <source>Cluster</source>
        <translation>Grupo</translation>
    </message>
    <message>
        <source>Combine harvester, 7.5 m header</source>
        <translation>Colheitadeira, plataforma de 7,5 m</translation>
    </message>
    <message>
        <source>Corners</source>
        <translation>Cantos</translation>
    </message>
    <message>
        <source>Counter-clockwise</source>
        <translation>Sentido anti-horário</translation>
    </message>
    <message>
        <source>Crop protection: headland first, ways along the headland.</source>
        <translation>Aplicação de defensivos: cabeceira primeiro, deslocamentos pela cabeceira.</translation>
    </message>
    <message>
        <source>Curves are driven with up to %1 sideways; the machine&apos;s limit is less.</source>
        <translation>As curvas são feitas com até %1 lateral; o limite da máquina é menor.</translation>
    </message>
    <message>
        <source>Curves with reversing</source>
        <translation>Curvas com ré</translation>
    </message>
    <message>
        <source>Curves with reversing, smooth steering</source>
        <translation>Curvas com ré, esterçamento suave</translation>
    </message>
    <message>
        <source>Cut along the swaths at every corner, sharp or rounded.</source>
        <translation>Dividido ao longo das passadas em cada canto, vivo ou arredondado.</translation>
    </message>
    <message>
        <source>Cut along the swaths where an obstacle or a bay begins or ends.</source>
        <translation>Dividido ao longo das passadas onde começa ou termina um obstáculo ou uma reentrância.</translation>
    </message>
    <message>
        <source>Cut where an obstacle or a bay begins or ends, and joined again where that saves turns and ways.</source>
        <translation>Dividido onde começa ou termina um obstáculo ou uma reentrância, e unido de novo onde isso economiza manobras e deslocamentos.</translation>
    </message>
    <message>
        <source>Cutting grass: headland first, swaths overlap a little.</source>
        <translation>Corte de capim: cabeceira primeiro, as passadas se sobrepõem um pouco.</translation>
    </message>
    <message>
        <source>DXF drawing</source>
        <translation>Desenho DXF</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Direção</translation>
    </message>
    <message>
        <source>Drawn out until the whole width is covered, as far as there is room.</source>
        <translation>Prolongado até cobrir toda a largura, enquanto houver espaço.</translation>
    </message>
    <message>
        <source>Drilling or planting: headland last, ways along the headland.</source>
        <translation>Semeadura ou plantio: cabeceira por último, deslocamentos pela cabeceira.</translation>
    </message>
    <message>
        <source>Drive</source>
        <translation>Andar</translation>
    </message>
    <message>
        <source>Drive the curves more slowly.</source>
        <translation>Faça as curvas mais devagar.</translation>
    </message>
    <message>
        <source>Drives the path from waypoint to waypoint, rounding corners its own way; relay 1 is on where the implement works. Not tested on the machine by us.</source>
        <translation>Vai de ponto em ponto, arredondando cantos a seu modo; o relé 1 fica ligado onde o implemento trabalha. Não testado por nós na máquina.</translation>
    </message>
    <message>
        <source>Drives the whole path, turns included, as a recorded path; stretches in reverse gear are left to the driver. Shows boundary, headland and guidance lines. Copy the field&apos;s folder to Documents/AgOpenGPS/Fields.</source>
        <translation>Percorre tudo, inclusive as manobras, como percurso gravado; os trechos de ré ficam para o operador. Mostra limite, cabeceira e linhas de orientação. Copie a pasta do talhão para Documents/AgOpenGPS/Fields.</translation>
    </message>
    <message>
        <source>Each its own</source>
        <translation>Cada um a sua</translation>
    </message>
    <message>
        <source>Edge</source>
        <translation>Lado</translation>
    </message>
    <message>
        <source>Edge directions and every tenth of a degree, refined; says when nothing better exists.</source>
        <translation>Direções dos lados e cada décimo de grau, refinado; diz quando não há nada melhor.</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Fim</translation>
    </message>
    <message>
        <source>Ends</source>
        <translation>Pontas</translation>
    </message>
    <message>
        <source>Every how many swaths a wider machine will drive again; 0 for none.</source>
        <translation>A cada quantas passadas uma máquina mais larga passará; 0 para nenhuma.</translation>
    </message>
    <message>
        <source>Every sample of the path; without a plan boundaries as WKT, or as points.</source>
        <translation>Cada ponto do percurso; sem plano, limites como WKT ou pontos.</translation>
    </message>
    <message>
        <source>Every second swath on the way out, the others on the way back.</source>
        <translation>Uma passada sim, outra não na ida; as outras na volta.</translation>
    </message>
    <message>
        <source>Every swath after its neighbour, back and forth.</source>
        <translation>Cada passada após sua vizinha, ida e volta.</translation>
    </message>
    <message>
        <source>Fendt One, Vario terminal</source>
        <translation>Fendt One, Varioterminal</translation>
    </message>
    <message>
        <source>Fertiliser or manure: headland first, ways along the headland.</source>
        <translation>Adubo ou esterco: cabeceira primeiro, deslocamentos pela cabeceira.</translation>
    </message>
    <message>
        <source>Fertiliser spreader, 36 m</source>
        <translation>Distribuidor de adubo, 36 m</translation>
    </message>
    <message>
        <source>Fewest swaths</source>
        <translation>Menos passadas</translation>
    </message>
    <message>
        <source>Field robot, 1.5 m weeder</source>
        <translation>Robô agrícola, capinadeira de 1,5 m</translation>
    </message>
    <message>
        <source>Finish corners</source>
        <translation>Terminar os cantos</translation>
    </message>
    <message>
        <source>First tramline</source>
        <translation>Primeiro rastro de pulverização</translation>
    </message>
    <message>
        <source>Fishtail</source>
        <translation>Manobra rabo de peixe</translation>
    </message>
    <message>
        <source>Five-furrow mounted plough, 2.5 m</source>
        <translation>Arado montado de cinco corpos, 2,5 m</translation>
    </message>
    <message>
        <source>Forward arc, straight back, forward arc; little room for near swaths.</source>
        <translation>Arco à frente, reto de ré, arco à frente; pouco espaço para passadas próximas.</translation>
    </message>
    <message>
        <source>Forward curves</source>
        <translation>Curvas para a frente</translation>
    </message>
    <message>
        <source>Forward curves, smooth steering</source>
        <translation>Curvas para a frente, esterçamento suave</translation>
    </message>
    <message>
        <source>Forward, back with the wheels the other way, forward again.</source>
        <translation>À frente, de ré com as rodas para o outro lado, à frente de novo.</translation>
    </message>
    <message>
        <source>Forwards and backwards, the wheels turned no faster than the machine can (clothoids).</source>
        <translation>Para a frente e de ré, sem virar as rodas mais rápido do que a máquina consegue (clotoides).</translation>
    </message>
    <message>
        <source>From clear of the ground to working depth.</source>
        <translation>De fora do solo até a profundidade de trabalho.</translation>
    </message>
    <message>
        <source>From inside out</source>
        <translation>De dentro para fora</translation>
    </message>
    <message>
        <source>From outside in</source>
        <translation>De fora para dentro</translation>
    </message>
    <message>
        <source>From the boundary inwards; holds as many passes as fit.</source>
        <translation>Do limite ao interior do talhão; contém tantas passadas quantas couberem.</translation>
    </message>
    <message>
        <source>From the fixed axle to the hitch, negative behind the axle.</source>
        <translation>Do eixo fixo ao engate, negativo atrás do eixo.</translation>
    </message>
    <message>
        <source>From the fixed axle to the middle of the working parts, negative behind the axle.</source>
        <translation>Do eixo fixo ao meio das partes de trabalho, negativo atrás do eixo.</translation>
    </message>
    <message>
        <source>From the fixed axle to the tractor&apos;s rear end.</source>
        <translation>Do eixo fixo até a traseira do trator.</translation>
    </message>
    <message>
        <source>From the tractor&apos;s nose to its rear end.</source>
        <translation>Da frente do trator até a traseira.</translation>
    </message>
    <message>
        <source>From working depth to clear of the ground.</source>
        <translation>Da profundidade de trabalho até sair do solo.</translation>
    </message>
    <message>
        <source>Front and rear mower, 9 m</source>
        <translation>Segadora frontal e traseira, 9 m</translation>
    </message>
    <message>
        <source>Fuel at work</source>
        <translation>Combustível no trabalho</translation>
    </message>
    <message>
        <source>Fuel in turns</source>
        <translation>Combustível nas manobras</translation>
    </message>
    <message>
        <source>Full spacing; the last swath is moved back to the edge.</source>
        <translation>Espaçamento completo; a última passada é levada à borda.</translation>
    </message>
    <message>
        <source>Full spacing; a rest of less than half a width stays uncovered, where it costs least.</source>
        <translation>Espaçamento completo; um resto de menos de meia largura fica sem cobrir onde custa menos.</translation>
    </message>
    <message>
        <source>Full width</source>
        <translation>Largura total</translation>
    </message>
    <message>
        <source>Gets the whole path as nav_msgs/Path, and stretches in one gear each where it reverses.</source>
        <translation>Recebe todo o percurso como nav_msgs/Path, e trechos de uma só marcha onde dá ré.</translation>
    </message>
    <message>
        <source>Given direction</source>
        <translation>Direção dada</translation>
    </message>
    <message>
        <source>Go round obstacles up to</source>
        <translation>Contornar obstáculos de até</translation>
    </message>
    <message>
        <source>Great Field</source>
        <translation>Campo Grande</translation>
    </message>
    <message>
        <source>Half way in</source>
        <translation>A meia largura</translation>
    </message>
    <message>
        <source>Make them straight: &quot;Field&quot; menu, or furrow-cli convert --straighten-steps.</source>
        <translation>Endireite-os: menu &quot;Talhão&quot;, ou furrow-cli convert --straighten-steps.</translation>
    </message>
    <message>
        <source>Quick search</source>
        <translation>Busca rápida</translation>
    </message>
    <message>
        <source>Harvest</source>
        <translation>Colheita</translation>
    </message>
    <message>
        <source>Heading</source>
        <translation>Direção das passadas</translation>
    </message>
    <message>
        <source>Headland</source>
        <translation>Cabeceira</translation>
    </message>
    <message>
        <source>Headland first or last.</source>
        <translation>Cabeceira primeiro ou por último.</translation>
    </message>
    <message>
        <source>Heights</source>
        <translation>Altitudes</translation>
    </message>
    <message>
        <source>Hitch offset</source>
        <translation>Posição do engate</translation>
    </message>
    <message>
        <source>Home Field</source>
        <translation>Campo da Sede</translation>
    </message>
    <message>
        <source>How far a trailed implement may swing to one side.</source>
        <translation>Quanto um implemento rebocado pode virar para um lado.</translation>
    </message>
    <message>
        <source>How far the steered wheels turn to one side.</source>
        <translation>Quanto as rodas direcionais viram para um lado.</translation>
    </message>
    <message>
        <source>How fast the curvature may change along the path; from the steering rate where it is not given.</source>
        <translation>Com que rapidez a curvatura pode mudar ao longo do percurso; se não for informada, vem da velocidade de esterçamento.</translation>
    </message>
    <message>
        <source>How fast the steered wheels turn.</source>
        <translation>Com que rapidez as rodas direcionais viram.</translation>
    </message>
    <message>
        <source>How headland passes get round corners.</source>
        <translation>Como as passadas de cabeceira passam pelos cantos.</translation>
    </message>
    <message>
        <source>How much neighbouring swaths overlap.</source>
        <translation>Quanto as passadas vizinhas se sobrepõem.</translation>
    </message>
    <message>
        <source>How the direction of the swaths is found.</source>
        <translation>Como se encontra a direção das passadas.</translation>
    </message>
    <message>
        <source>How the machine gets from one swath to the next.</source>
        <translation>Como a máquina vai de uma passada à próxima.</translation>
    </message>
    <message>
        <source>How the field is divided; the swaths of a block are driven together.</source>
        <translation>Como o interior é dividido; as passadas de um subtalhão são feitas juntas.</translation>
    </message>
    <message>
        <source>Implement can reverse</source>
        <translation>O implemento aceita ré</translation>
    </message>
    <message>
        <source>Implement length</source>
        <translation>Comprimento do implemento</translation>
    </message>
    <message>
        <source>Implement offset</source>
        <translation>Posição do implemento</translation>
    </message>
    <message>
        <source>In WGS84: A and B of a line, a curve, A alone with a direction, or a pivot&apos;s centre.</source>
        <translation>Em WGS84: A e B de uma linha, uma curva, só A com uma direção, ou o centro de um pivô.</translation>
    </message>
    <message>
        <source>In which order the headland passes are driven.</source>
        <translation>Em que ordem são feitas as passadas de cabeceira.</translation>
    </message>
    <message>
        <source>In which order the swaths are driven.</source>
        <translation>Em que ordem as passadas são feitas.</translation>
    </message>
    <message>
        <source>Largest acceleration</source>
        <translation>Aceleração máxima</translation>
    </message>
    <message>
        <source>Largest curvature rate</source>
        <translation>Variação de curvatura máxima</translation>
    </message>
    <message>
        <source>Largest hitch angle</source>
        <translation>Ângulo de engate máximo</translation>
    </message>
    <message>
        <source>Largest lateral acceleration</source>
        <translation>Aceleração lateral máxima</translation>
    </message>
    <message>
        <source>Largest speed in turns.</source>
        <translation>Velocidade máxima nas manobras.</translation>
    </message>
    <message>
        <source>Largest steering angle</source>
        <translation>Ângulo de esterçamento máximo</translation>
    </message>
    <message>
        <source>Last pass</source>
        <translation>Última passada</translation>
    </message>
    <message>
        <source>Lateral offset</source>
        <translation>Deslocamento lateral</translation>
    </message>
    <message>
        <source>Least overlap</source>
        <translation>Menos sobreposição</translation>
    </message>
    <message>
        <source>Least time</source>
        <translation>Menos tempo</translation>
    </message>
    <message>
        <source>Leaves some swaths out at each turn and comes back for them.</source>
        <translation>Pula passadas em cada manobra e volta para fazê-las.</translation>
    </message>
    <message>
        <source>Left out</source>
        <translation>Puladas</translation>
    </message>
    <message>
        <source>Limits the speed in tight bends.</source>
        <translation>Limita a velocidade em curvas fechadas.</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Linha</translation>
    </message>
    <message>
        <source>Lines along which the field inside the headland is cut; they run right through it, or end no farther than an operating width from its edge.</source>
        <translation>Linhas ao longo das quais o interior é dividido; atravessam-no por completo ou terminam no máximo a uma largura de trabalho da borda.</translation>
    </message>
    <message>
        <source>Litres of fuel per hour of turns and transfers.</source>
        <translation>Litros de combustível por hora de manobras e deslocamentos.</translation>
    </message>
    <message>
        <source>Litres of fuel per hour of work.</source>
        <translation>Litros de combustível por hora de trabalho.</translation>
    </message>
    <message>
        <source>Long Strip</source>
        <translation>Faixa Longa</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>Laço</translation>
    </message>
    <message>
        <source>Lower the speeds, or correct the machine&apos;s.</source>
        <translation>Reduza as velocidades ou corrija as da máquina.</translation>
    </message>
    <message>
        <source>MAVLink waypoints</source>
        <translation>Pontos de passagem MAVLink</translation>
    </message>
    <message>
        <source>Make the gate wider, or take another.</source>
        <translation>Alargue a entrada ou use outra.</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Margem</translation>
    </message>
    <message>
        <source>Overhang</source>
        <translation>Balanço</translation>
    </message>
    <message>
        <source>Most covered</source>
        <translation>Maior área</translation>
    </message>
    <message>
        <source>Most terminals read FAT32 only; this stick has %1. Format it as FAT32.</source>
        <translation>A maioria dos terminais só lê FAT32; este pen drive tem %1. Formate como FAT32.</translation>
    </message>
    <message>
        <source>Mounted cultivator, 6 m</source>
        <translation>Cultivador montado, 6 m</translation>
    </message>
    <message>
        <source>Mounted drill, 12 m</source>
        <translation>Semeadora montada, 12 m</translation>
    </message>
    <message>
        <source>Mounting</source>
        <translation>Acoplamento</translation>
    </message>
    <message>
        <source>Mowing</source>
        <translation>Corte</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nome</translation>
    </message>
    <message>
        <source>No headland</source>
        <translation>Sem cabeceira</translation>
    </message>
    <message>
        <source>Nothing leads to the start of %1, %2 away.</source>
        <translation>Nada leva ao começo, a %2: %1.</translation>
    </message>
    <message>
        <source>Number of the boundary&apos;s edge, from 0 in the order of its points; for curves with all around it up to a corner of 35 degrees within a width, or a bend of 90 in all.</source>
        <translation>Número do lado do limite, a partir de 0 na ordem dos pontos; em curvas com todos em volta até um canto de 35 graus em uma largura, ou uma curva de 90 ao todo.</translation>
    </message>
    <message>
        <source>Of the four corners and both ways the one with the quickest turns.</source>
        <translation>Dos quatro cantos e dos dois sentidos, o de manobras mais rápidas.</translation>
    </message>
    <message>
        <source>Of the middle of the operating width, positive to the left.</source>
        <translation>Do meio da largura de trabalho, positivo para a esquerda.</translation>
    </message>
    <message>
        <source>Of the swaths.</source>
        <translation>Das passadas.</translation>
    </message>
    <message>
        <source>Off: the strip is kept for turning only.</source>
        <translation>Não: a faixa serve só para manobrar.</translation>
    </message>
    <message>
        <source>Omega turn</source>
        <translation>Manobra em ômega</translation>
    </message>
    <message>
        <source>On the rows</source>
        <translation>Sobre as fileiras</translation>
    </message>
    <message>
        <source>On the rows, or between them.</source>
        <translation>Sobre as fileiras ou entre elas.</translation>
    </message>
    <message>
        <source>On the spot</source>
        <translation>No lugar</translation>
    </message>
    <message>
        <source>One for all</source>
        <translation>Uma para todos</translation>
    </message>
    <message>
        <source>One piece</source>
        <translation>Inteiro</translation>
    </message>
    <message>
        <source>Only where it turns</source>
        <translation>Somente onde se manobra</translation>
    </message>
    <message>
        <source>Operating width</source>
        <translation>Largura de trabalho</translation>
    </message>
    <message>
        <source>Operation</source>
        <translation>Operação</translation>
    </message>
    <message>
        <source>Orchard tractor with 1.5 m sprayer</source>
        <translation>Trator de pomar com pulverizador de 1,5 m</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Ordem</translation>
    </message>
    <message>
        <source>Overlap</source>
        <translation>Sobreposição</translation>
    </message>
    <message>
        <source>Overlaps its neighbour</source>
        <translation>Sobrepõe a vizinha</translation>
    </message>
    <message>
        <source>P turn</source>
        <translation>Manobra em P</translation>
    </message>
    <message>
        <source>Passes</source>
        <translation>Passadas</translation>
    </message>
    <message>
        <source>Plan again with this machine&apos;s turning radius.</source>
        <translation>Planeje de novo com o raio de giro desta máquina.</translation>
    </message>
    <message>
        <source>Plan again, or trust the positions.</source>
        <translation>Planeje de novo ou confie nas posições.</translation>
    </message>
    <message>
        <source>Plan again; the heading or the gear is wrong here.</source>
        <translation>Planeje de novo; o rumo ou a marcha está errada aqui.</translation>
    </message>
    <message>
        <source>Plan again; the path lacks this pass.</source>
        <translation>Planeje de novo; falta esta passada no percurso.</translation>
    </message>
    <message>
        <source>Plan again; the path was changed or cut here.</source>
        <translation>Planeje de novo; o percurso foi alterado ou cortado aqui.</translation>
    </message>
    <message>
        <source>Plan again; the times were changed.</source>
        <translation>Planeje de novo; os tempos foram alterados.</translation>
    </message>
    <message>
        <source>Plan the parts of the field apart, or widen the passage between them.</source>
        <translation>Planeje as partes do talhão separadamente ou alargue a passagem entre elas.</translation>
    </message>
    <message>
        <source>Plan the turn that is missing here.</source>
        <translation>Planeje a manobra que falta aqui.</translation>
    </message>
    <message>
        <source>Power harrow and drill, 3 m</source>
        <translation>Grade rotativa e semeadora, 3 m</translation>
    </message>
    <message>
        <source>Prefer</source>
        <translation>Preferir</translation>
    </message>
    <message>
        <source>Protobuf message</source>
        <translation>Mensagem Protobuf</translation>
    </message>
    <message>
        <source>QGroundControl plan</source>
        <translation>Plano do QGroundControl</translation>
    </message>
    <message>
        <source>Racetrack</source>
        <translation>Circuito</translation>
    </message>
    <message>
        <source>Raised width</source>
        <translation>Largura ao manobrar</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Dose</translation>
    </message>
    <message>
        <source>Rear overhang</source>
        <translation>Balanço traseiro</translation>
    </message>
    <message>
        <source>Recorded path</source>
        <translation>Percurso gravado</translation>
    </message>
    <message>
        <source>Relay 1 is on where the implement works.</source>
        <translation>O relé 1 fica ligado onde o implemento trabalha.</translation>
    </message>
    <message>
        <source>Repaired in %1: %2.</source>
        <translation>Corrigido (%1): %2.</translation>
    </message>
    <message>
        <source>Reverse</source>
        <translation>Ré</translation>
    </message>
    <message>
        <source>Reverse speed</source>
        <translation>Velocidade de ré</translation>
    </message>
    <message>
        <source>Round and round the centre of a pivot, from the rim inwards.</source>
        <translation>Em volta do centro de um pivô, da borda para dentro.</translation>
    </message>
    <message>
        <source>Round and round, with half of the swaths between the way out and the way back.</source>
        <translation>Em círculo, com metade das passadas entre a ida e a volta.</translation>
    </message>
    <message>
        <source>Round the field</source>
        <translation>Em volta do talhão</translation>
    </message>
    <message>
        <source>Rounded</source>
        <translation>Arredondado</translation>
    </message>
    <message>
        <source>Route</source>
        <translation>Rota</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>Fileiras</translation>
    </message>
    <message>
        <source>Rows that are left out, numbered from 1 as in the file; between rows, that on the right.</source>
        <translation>Fileiras que ficam de fora, a partir de 1 como no arquivo; entre fileiras, a da direita.</translation>
    </message>
    <message>
        <source>Run-in</source>
        <translation>Distância de aproximação</translation>
    </message>
    <message>
        <source>Same width all round</source>
        <translation>Mesma largura em volta</translation>
    </message>
    <message>
        <source>Seen from above, turning left at corners.</source>
        <translation>Visto de cima, virando à esquerda nos cantos.</translation>
    </message>
    <message>
        <source>Seen from above, turning right at corners.</source>
        <translation>Visto de cima, virando à direita nos cantos.</translation>
    </message>
    <message>
        <source>Short name for the command line.</source>
        <translation>Nome curto para a linha de comando.</translation>
    </message>
    <message>
        <source>Short passes where corners would leave more than 1 % of the field.</source>
        <translation>Passadas curtas onde os cantos deixariam mais de 1 % do talhão.</translation>
    </message>
    <message>
        <source>Shortest swaths</source>
        <translation>Passadas mais curtas</translation>
    </message>
    <message>
        <source>Shows the boundary and the guidance lines; it plans turns and order itself. Not tested on the machine by us.</source>
        <translation>Mostra o limite e as linhas de orientação; ele mesmo planeja manobras e ordem. Não testado por nós na máquina.</translation>
    </message>
    <message>
        <source>Shows the boundary with holes and obstacles and the guidance lines; it plans turns and order itself. The import may have to be unlocked. Not tested on the machine by us.</source>
        <translation>Mostra o limite com vazios e obstáculos e as linhas de orientação; ele mesmo planeja manobras e ordem. Talvez seja preciso desbloquear a importação. Não testado por nós na máquina.</translation>
    </message>
    <message>
        <source>Shows the boundary with holes and obstacles, the headland where the terminal knows it, and the guidance lines; it plans turns and order itself. The import may have to be unlocked. Not tested on the machine by us.</source>
        <translation>Mostra o limite com vazios e obstáculos, a cabeceira se o terminal a conhece, e as linhas de orientação; ele mesmo planeja manobras e ordem. Talvez seja preciso desbloquear a importação. Não testado por nós na máquina.</translation>
    </message>
    <message>
        <source>Shows the boundary, its holes, the headland and the guidance lines, not the path. Holes are written as obstacles, since it overlooks others.</source>
        <translation>Mostra o limite, os vazios, a cabeceira e as linhas de orientação, não o percurso. Os vazios são gravados como obstáculos, pois ele ignora os outros.</translation>
    </message>
    <message>
        <source>Shows the path as a mission, and the boundary and obstacles as fences. Not tested on the machine by us.</source>
        <translation>Mostra o percurso como missão, e o limite e os obstáculos como cercas. Não testado por nós na máquina.</translation>
    </message>
    <message>
        <source>Six directions, then ever finer around the best three (Oksanen &amp; Visala).</source>
        <translation>Seis direções, depois cada vez mais fino em torno das três melhores (Oksanen &amp; Visala).</translation>
    </message>
    <message>
        <source>Six-row planter, 4.5 m</source>
        <translation>Plantadeira de seis linhas, 4,5 m</translation>
    </message>
    <message>
        <source>Skip</source>
        <translation>Pular</translation>
    </message>
    <message>
        <source>Skip and fill</source>
        <translation>Pular e preencher</translation>
    </message>
    <message>
        <source>Slanted Field</source>
        <translation>Campo Inclinado</translation>
    </message>
    <message>
        <source>Slurry tanker, 15 m trailing shoe</source>
        <translation>Tanque de esterco líquido, sapatas de 15 m</translation>
    </message>
    <message>
        <source>Smallest circle the middle of the fixed axle can follow; from the steering angle where it is not given.</source>
        <translation>Menor círculo que o meio do eixo fixo consegue seguir; se não for informado, vem do ângulo de esterçamento.</translation>
    </message>
    <message>
        <source>Smallest turning radius</source>
        <translation>Raio de giro mínimo</translation>
    </message>
    <message>
        <source>Snake</source>
        <translation>Serpentina</translation>
    </message>
    <message>
        <source>So that the wide machine begins flush with the left edge, or beside the line that was given.</source>
        <translation>Para que a máquina larga comece rente à borda esquerda ou ao lado da linha dada.</translation>
    </message>
    <message>
        <source>Sowing</source>
        <translation>Semeadura</translation>
    </message>
    <message>
        <source>Speed backwards.</source>
        <translation>Velocidade para trás.</translation>
    </message>
    <message>
        <source>Speed on longer ways with the implement lifted.</source>
        <translation>Velocidade em deslocamentos longos com o implemento levantado.</translation>
    </message>
    <message>
        <source>Speed with the implement at work.</source>
        <translation>Velocidade com o implemento trabalhando.</translation>
    </message>
    <message>
        <source>Spiral in clusters</source>
        <translation>Espiral em grupos</translation>
    </message>
    <message>
        <source>Split lines</source>
        <translation>Linhas de divisão</translation>
    </message>
    <message>
        <source>Spraying</source>
        <translation>Pulverização</translation>
    </message>
    <message>
        <source>Spread over all</source>
        <translation>Distribuído entre todas</translation>
    </message>
    <message>
        <source>Spreading</source>
        <translation>Adubação</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Início</translation>
    </message>
    <message>
        <source>Start at</source>
        <translation>Começar em</translation>
    </message>
    <message>
        <source>Stay inside</source>
        <translation>Ficar dentro</translation>
    </message>
    <message>
        <source>Steering rate</source>
        <translation>Velocidade de esterçamento</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Passo</translation>
    </message>
    <message>
        <source>Straight into the corner and back into it on the next side.</source>
        <translation>Reto até o canto e de ré no lado seguinte.</translation>
    </message>
    <message>
        <source>Straight into the corner and on after a loop, where there is room for it.</source>
        <translation>Reto até o canto e adiante após um laço, onde houver espaço.</translation>
    </message>
    <message>
        <source>Straight way needed before the implement is lowered.</source>
        <translation>Trecho reto necessário antes de abaixar o implemento.</translation>
    </message>
    <message>
        <source>Swath after swath over all of the field, whatever cuts them.</source>
        <translation>Passada após passada por todo o interior, não importa o que as corte.</translation>
    </message>
    <message>
        <source>Swath numbers in driving order; a minus drives one the other way.</source>
        <translation>Números das passadas em ordem; um menos inverte o sentido.</translation>
    </message>
    <message>
        <source>Swaths</source>
        <translation>Passadas</translation>
    </message>
    <message>
        <source>Swaths go on from block to block.</source>
        <translation>As passadas continuam de um subtalhão ao outro.</translation>
    </message>
    <message>
        <source>Swaths go round obstacles of up to this size; larger ones get a headland. Auto is the operating width.</source>
        <translation>As passadas contornam obstáculos de até este tamanho; os maiores recebem uma cabeceira. Auto é a largura de trabalho.</translation>
    </message>
    <message>
        <source>Swaths left out at each turn and driven on the way back.</source>
        <translation>Passadas puladas em cada manobra e feitas na volta.</translation>
    </message>
    <message>
        <source>Swaths that are finished together.</source>
        <translation>Passadas concluídas juntas.</translation>
    </message>
    <message>
        <source>Takes the boundary only, as an upload from a computer; no guidance lines, no path.</source>
        <translation>Recebe só o limite, enviado de um computador; sem linhas de orientação, sem percurso.</translation>
    </message>
    <message>
        <source>Tank or bunker</source>
        <translation>Tanque ou graneleiro</translation>
    </message>
    <message>
        <source>The Bend</source>
        <translation>A Curva</translation>
    </message>
    <message>
        <source>The best corner</source>
        <translation>O melhor canto</translation>
    </message>
    <message>
        <source>The boundary alone as a flat zipped shapefile, as operations centres take it.</source>
        <translation>Só o limite como shapefile compactado sem pastas, como aceitam os centros de operações.</translation>
    </message>
    <message>
        <source>The chosen one cannot be driven between these swaths.</source>
        <translation>A escolhida não é possível entre estas passadas.</translation>
    </message>
    <message>
        <source>The corner where the route starts.</source>
        <translation>O canto onde a rota começa.</translation>
    </message>
    <message>
        <source>The field is narrower here than the %1 in which this machine turns without reversing: leave this strip out, or work it with a machine that turns more tightly.</source>
        <translation>O talhão é aqui mais estreito que os %1 em que esta máquina manobra sem dar ré: deixe esta faixa de fora ou trabalhe-a com uma máquina que vire mais fechado.</translation>
    </message>
    <message>
        <source>The field is narrower here than this machine, which takes %1: leave this strip out, or work it with a narrower machine.</source>
        <translation>O talhão é aqui mais estreito que esta máquina, que precisa de %1: deixe esta faixa de fora ou trabalhe-a com uma máquina mais estreita.</translation>
    </message>
    <message>
        <source>The field is too narrow for %1 of headland; it is %2 with %3</source>
        <translation>O talhão é estreito demais para %1 de cabeceira; ficam %2, com %3</translation>
    </message>
    <message>
        <source>The field is too narrow for %1 of headland; there is none</source>
        <translation>O talhão é estreito demais para %1 de cabeceira; não há nenhuma</translation>
    </message>
    <message>
        <source>The first swath</source>
        <translation>A primeira passada</translation>
    </message>
    <message>
        <source>The first swath on the left is one, or the line that was given.</source>
        <translation>A primeira passada à esquerda é um, ou a linha dada.</translation>
    </message>
    <message>
        <source>The first swath on the right is one, or the line that was given.</source>
        <translation>A primeira passada à direita é um, ou a linha dada.</translation>
    </message>
    <message>
        <source>The headland is worked first.</source>
        <translation>A cabeceira é trabalhada primeiro.</translation>
    </message>
    <message>
        <source>The headland is worked last.</source>
        <translation>A cabeceira é trabalhada por último.</translation>
    </message>
    <message>
        <source>The headland strip, %1, is not worked by this plan, nor are %2 at the ends of the swaths beside it.</source>
        <translation>A faixa da cabeceira, %1, não é trabalhada neste plano, nem %2 nas pontas das passadas ao lado.</translation>
    </message>
    <message>
        <source>The headland strip, %1, is not worked by this plan.</source>
        <translation>A faixa da cabeceira, %1, não é trabalhada neste plano.</translation>
    </message>
    <message>
        <source>The hitch bends by %1 in %2; %3 are allowed.</source>
        <translation>O engate dobra %1 em %2; são permitidos %3.</translation>
    </message>
    <message>
        <source>The largest covered share inside the headland.</source>
        <translation>A maior parte trabalhada do interior.</translation>
    </message>
    <message>
        <source>The least metres driven in swaths, with what is missed added as metres.</source>
        <translation>Os menos metros percorridos em passadas; as falhas contam como metros.</translation>
    </message>
    <message>
        <source>The machine does not get in at %1.</source>
        <translation>A máquina não consegue entrar por aqui: %1.</translation>
    </message>
    <message>
        <source>The machine does not get out at %1.</source>
        <translation>A máquina não consegue sair por aqui: %1.</translation>
    </message>
    <message>
        <source>The machine drives half way between two neighbours.</source>
        <translation>A máquina vai no meio entre duas vizinhas.</translation>
    </message>
    <message>
        <source>The machine drives over them.</source>
        <translation>A máquina passa sobre elas.</translation>
    </message>
    <message>
        <source>The machine turns on the spot in %1, by up to %2.</source>
        <translation>A máquina gira no lugar em %1, até %2.</translation>
    </message>
    <message>
        <source>The machine turns on the spot in %1, by up to %2; it cannot.</source>
        <translation>A máquina gira no lugar em %1, até %2; ela não consegue.</translation>
    </message>
    <message>
        <source>The mission has %1 items; controllers without a memory card hold about %2.</source>
        <translation>A missão tem %1 itens; controladores sem cartão guardam cerca de %2.</translation>
    </message>
    <message>
        <source>The outermost pass goes round with the machine&apos;s radius where little is left; others reach into corners.</source>
        <translation>A passada externa segue o raio da máquina onde sobra pouco; as outras entram nos cantos.</translation>
    </message>
    <message>
        <source>The outline has %1 steps of about %2, like the pixels of an image.</source>
        <translation>O contorno tem %1 degraus de cerca de %2, como os pixels de uma imagem.</translation>
    </message>
    <message>
        <source>The pass along the boundary first.</source>
        <translation>Primeiro a passada junto ao limite.</translation>
    </message>
    <message>
        <source>The innermost pass first.</source>
        <translation>Primeiro a passada junto ao interior.</translation>
    </message>
    <message>
        <source>The path as a mission for ArduPilot Rover: waypoints, speeds, gear, implement.</source>
        <translation>O percurso como missão para ArduPilot Rover: pontos, velocidades, marcha, implemento.</translation>
    </message>
    <message>
        <source>The path as a track, swath ends as a route, gates as waypoints; for phones.</source>
        <translation>O percurso como trilha, pontas das passadas como rota, entradas como pontos; para celulares.</translation>
    </message>
    <message>
        <source>The path as nav_msgs/Path in a recording of ROS 2.</source>
        <translation>O percurso como nav_msgs/Path em uma gravação do ROS 2.</translation>
    </message>
    <message>
        <source>The path as one message for ros2 topic pub.</source>
        <translation>O percurso como uma mensagem para ros2 topic pub.</translation>
    </message>
    <message>
        <source>The path with times, velocities and orientations, and the boundary as a fence; for own robots.</source>
        <translation>O percurso com tempos, velocidades e orientações, e o limite como cerca; para robôs próprios.</translation>
    </message>
    <message>
        <source>The quickest turn of any kind that stays inside the field, in several moves where it must.</source>
        <translation>A manobra mais rápida de qualquer tipo que fica dentro do talhão, em vários movimentos se preciso.</translation>
    </message>
    <message>
        <source>The same as KML, zipped.</source>
        <translation>O mesmo que KML, compactado.</translation>
    </message>
    <message>
        <source>The same mission with the boundary and obstacles as fences.</source>
        <translation>A mesma missão com o limite e os obstáculos como cercas.</translation>
    </message>
    <message>
        <source>The shortest curve forwards and backwards, at the smallest turning radius (Reeds and Shepp).</source>
        <translation>A curva mais curta para a frente e de ré, com o menor raio de giro (Reeds e Shepp).</translation>
    </message>
    <message>
        <source>The shortest curve without reversing, at the smallest turning radius (Dubins).</source>
        <translation>A curva mais curta sem ré, com o menor raio de giro (Dubins).</translation>
    </message>
    <message>
        <source>The shortest time in swaths and turns.</source>
        <translation>O menor tempo em passadas e manobras.</translation>
    </message>
    <message>
        <source>The smallest area worked twice.</source>
        <translation>A menor área trabalhada duas vezes.</translation>
    </message>
    <message>
        <source>The spacing is reduced evenly so that all fit.</source>
        <translation>O espaçamento é reduzido por igual para caberem todas.</translation>
    </message>
    <message>
        <source>The stated curvature differs from the path in %1, by up to %2 1/m.</source>
        <translation>A curvatura indicada difere do percurso em %1, até %2 1/m.</translation>
    </message>
    <message>
        <source>The stated speed is up to %1 above the machine&apos;s.</source>
        <translation>A velocidade indicada passa em até %1 a da máquina.</translation>
    </message>
    <message>
        <source>The strip kept for turning.</source>
        <translation>A faixa reservada para manobrar.</translation>
    </message>
    <message>
        <source>The swaths in the order and direction that you type.</source>
        <translation>As passadas na ordem e no sentido digitados.</translation>
    </message>
    <message>
        <source>The table holds boundaries only: obstacles, gates and lines are left out.</source>
        <translation>A tabela contém só limites: obstáculos, entradas e linhas ficam de fora.</translation>
    </message>
    <message>
        <source>The task data has %1 MB; old terminals take at most 2 MB.</source>
        <translation>Os dados de tarefa têm %1 MB; terminais antigos aceitam no máximo 2 MB.</translation>
    </message>
    <message>
        <source>The tractor may drive backwards with it.</source>
        <translation>O trator pode dar ré com ele.</translation>
    </message>
    <message>
        <source>The tractor may drive backwards.</source>
        <translation>O trator pode andar de ré.</translation>
    </message>
    <message>
        <source>The tractor may turn about its own middle.</source>
        <translation>O trator pode girar sobre o próprio centro.</translation>
    </message>
    <message>
        <source>The way from %1 to %2</source>
        <translation>O deslocamento %1 → %2</translation>
    </message>
    <message>
        <source>There the chosen one does not fit into the field or cannot be driven between these swaths.</source>
        <translation>A escolhida não cabe ali no talhão ou não é possível entre estas passadas.</translation>
    </message>
    <message>
        <source>There the chosen one does not fit into the field.</source>
        <translation>A escolhida não cabe ali no talhão.</translation>
    </message>
    <message>
        <source>This machine cannot reverse.</source>
        <translation>Esta máquina não consegue andar de ré.</translation>
    </message>
    <message>
        <source>This stick has %1 partitions; terminals see the first one only, if any.</source>
        <translation>Este pen drive tem %1 partições; os terminais veem no máximo a primeira.</translation>
    </message>
    <message>
        <source>Three Ponds</source>
        <translation>Três Lagoas</translation>
    </message>
    <message>
        <source>Three-point turn</source>
        <translation>Manobra em três pontos</translation>
    </message>
    <message>
        <source>Through point A in the direction that you type.</source>
        <translation>Pelo ponto A na direção digitada.</translation>
    </message>
    <message>
        <source>Tillage</source>
        <translation>Preparo do solo</translation>
    </message>
    <message>
        <source>Time and way do not fit the speed in %1.</source>
        <translation>O tempo e a distância não combinam com a velocidade em %1.</translation>
    </message>
    <message>
        <source>Time to lift</source>
        <translation>Tempo para levantar</translation>
    </message>
    <message>
        <source>Time to lower</source>
        <translation>Tempo para abaixar</translation>
    </message>
    <message>
        <source>To and fro</source>
        <translation>Ida e volta</translation>
    </message>
    <message>
        <source>Trailed sprayer, 24 m boom</source>
        <translation>Pulverizador rebocado, barra de 24 m</translation>
    </message>
    <message>
        <source>Tramline every</source>
        <translation>Rastro de pulverização a cada</translation>
    </message>
    <message>
        <source>Transfer speed</source>
        <translation>Velocidade de deslocamento</translation>
    </message>
    <message>
        <source>Transport width</source>
        <translation>Largura de transporte</translation>
    </message>
    <message>
        <source>Trapezoids</source>
        <translation>Trapézios</translation>
    </message>
    <message>
        <source>Tries every heading in steps and keeps the best.</source>
        <translation>Testa todas as direções em passos e fica com a melhor.</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Manobra</translation>
    </message>
    <message>
        <source>Turning speed</source>
        <translation>Velocidade de manobra</translation>
    </message>
    <message>
        <source>Turns</source>
        <translation>Manobras</translation>
    </message>
    <message>
        <source>Turns between swaths that are of another kind than chosen (path.method): %1 of %2. %3</source>
        <translation>Manobras entre passadas de outro tipo que o escolhido (path.method): %1 de %2. %3</translation>
    </message>
    <message>
        <source>Turns in place and drives straight to the next swath; only for machines that can.</source>
        <translation>Gira no lugar e vai reto à próxima passada; só para máquinas que conseguem.</translation>
    </message>
    <message>
        <source>Turns on the spot are chosen (path.method), and this machine cannot turn on the spot.</source>
        <translation>Foram escolhidas manobras no lugar (path.method), e esta máquina não consegue girar no lugar.</translation>
    </message>
    <message>
        <source>U turn</source>
        <translation>Manobra em U</translation>
    </message>
    <message>
        <source>Vehicle length</source>
        <translation>Comprimento do veículo</translation>
    </message>
    <message>
        <source>Vehicle width</source>
        <translation>Largura do veículo</translation>
    </message>
    <message>
        <source>Ways</source>
        <translation>Deslocamentos</translation>
    </message>
    <message>
        <source>Ways keep to the field&apos;s edge.</source>
        <translation>Os deslocamentos ficam na borda do talhão.</translation>
    </message>
    <message>
        <source>Ways keep to the headland; crop and seedbed are not driven over.</source>
        <translation>Os deslocamentos ficam na cabeceira; não se passa sobre a cultura nem o leito de semeadura.</translation>
    </message>
    <message>
        <source>Ways may cross worked land.</source>
        <translation>Os deslocamentos podem cruzar o interior.</translation>
    </message>
    <message>
        <source>Well-known text</source>
        <translation>Well-known text</translation>
    </message>
    <message>
        <source>What becomes of the width that is left over at the far side.</source>
        <translation>O que acontece com a largura que sobra do outro lado.</translation>
    </message>
    <message>
        <source>Distance from the boundary that nothing enters; auto is the boundary&apos;s accuracy.</source>
        <translation>Distância do limite em que nada entra; auto é a precisão do limite.</translation>
    </message>
    <message>
        <source>How far the implement may stand over the boundary and obstacles, its sections there switched off; the tractor and all wheels stay inside.</source>
        <translation>Até onde o implemento pode ficar sobre o limite do talhão e os obstáculos, com as seções ali desligadas; o trator e todas as rodas ficam dentro.</translation>
    </message>
    <message>
        <source>What is spread or gathered on a square metre, in the same unit.</source>
        <translation>O que se aplica ou se colhe em um metro quadrado, na mesma unidade.</translation>
    </message>
    <message>
        <source>What it holds, in your own unit: litres, kilograms, seeds.</source>
        <translation>O que cabe, na sua própria unidade: litros, quilos, sementes.</translation>
    </message>
    <message>
        <source>What the field is driven over for: sets when the headland is worked, ways and overlap.</source>
        <translation>O trabalho a fazer: define quando a cabeceira é trabalhada, os deslocamentos e a sobreposição.</translation>
    </message>
    <message>
        <source>What the machine is called.</source>
        <translation>Como a máquina se chama.</translation>
    </message>
    <message>
        <source>What the search for the best heading looks for.</source>
        <translation>O objetivo da busca da melhor direção.</translation>
    </message>
    <message>
        <source>Wheelbase</source>
        <translation>Entre-eixos</translation>
    </message>
    <message>
        <source>When</source>
        <translation>Quando</translation>
    </message>
    <message>
        <source>When speeding up and when braking.</source>
        <translation>Ao acelerar e ao frear.</translation>
    </message>
    <message>
        <source>Where a swath ends at a slanting edge.</source>
        <translation>Onde uma passada termina em uma borda oblíqua.</translation>
    </message>
    <message>
        <source>Where the machine may drive from swath to swath; follows from the operation.</source>
        <translation>Por onde a máquina pode ir de passada a passada; depende da operação.</translation>
    </message>
    <message>
        <source>Where the middle of the swath meets the headland.</source>
        <translation>Onde o meio da passada encontra a cabeceira.</translation>
    </message>
    <message>
        <source>Where tramlines are counted from.</source>
        <translation>De onde se contam os rastros de pulverização.</translation>
    </message>
    <message>
        <source>Whether blocks have a heading of their own.</source>
        <translation>Se os subtalhões têm direção própria.</translation>
    </message>
    <message>
        <source>Which way round the headland passes are driven.</source>
        <translation>Em que sentido são feitas as passadas de cabeceira.</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Largura</translation>
    </message>
    <message>
        <source>Width in operating widths; auto leaves room for the turns.</source>
        <translation>Largura em larguras de trabalho; auto deixa espaço para as manobras.</translation>
    </message>
    <message>
        <source>Width the tractor occupies, wheels included.</source>
        <translation>Largura que o trator ocupa, rodas incluídas.</translation>
    </message>
    <message>
        <source>Width while folded for the road, through gates and on ways in and out; the raised width where it is not given.</source>
        <translation>Largura com o implemento dobrado para a estrada, nas entradas e nos deslocamentos de entrada e saída; sem indicação, a largura ao manobrar.</translation>
    </message>
    <message>
        <source>Width while lifted or folded for a turn; the operating width where it is not given.</source>
        <translation>Largura com o implemento levantado ou dobrado para uma manobra; sem indicação, a largura de trabalho.</translation>
    </message>
    <message>
        <source>Width worked in one pass.</source>
        <translation>Largura trabalhada em uma passada.</translation>
    </message>
    <message>
        <source>Without reversing, the wheels turned no faster than the machine can (clothoids).</source>
        <translation>Sem ré, sem virar as rodas mais rápido do que a máquina consegue (clotoides).</translation>
    </message>
    <message>
        <source>Work it along the boundary, before or after the swaths.</source>
        <translation>Trabalhe-a ao longo do limite, antes ou depois das passadas.</translation>
    </message>
    <message>
        <source>Work the headland</source>
        <translation>Trabalhar a cabeceira</translation>
    </message>
    <message>
        <source>Working speed</source>
        <translation>Velocidade de trabalho</translation>
    </message>
    <message>
        <source>Working the soil: worked land may be driven over.</source>
        <translation>Preparo do solo: o interior pode ser cruzado.</translation>
    </message>
    <message>
        <source>Your own order</source>
        <translation>Ordem própria</translation>
    </message>
    <message>
        <source>Zipped boundary</source>
        <translation>Limite compactado</translation>
    </message>
    <message>
        <source>a chunk of the recording has a wrong checksum</source>
        <translation>um bloco da gravação tem uma soma de verificação errada</translation>
    </message>
    <message>
        <source>a chunk of the recording is cut off</source>
        <translation>um bloco da gravação está cortado</translation>
    </message>
    <message>
        <source>a chunk of the recording is damaged</source>
        <translation>um bloco da gravação está danificado</translation>
    </message>
    <message>
        <source>a compressed chunk of the recording is damaged</source>
        <translation>um bloco comprimido da gravação está danificado</translation>
    </message>
    <message>
        <source>a coordinate is not a number</source>
        <translation>uma coordenada não é um número</translation>
    </message>
    <message>
        <source>a curve needs at least two points that differ</source>
        <translation>uma curva precisa de pelo menos dois pontos diferentes</translation>
    </message>
    <message>
        <source>a drawing does not say which coordinate system it uses</source>
        <translation>um desenho não diz qual sistema de coordenadas usa</translation>
    </message>
    <message>
        <source>a hole lies outside the boundary</source>
        <translation>um vazio fica fora do limite</translation>
    </message>
    <message>
        <source>a hole of &apos;%1&apos; is missing or another</source>
        <translation>um vazio de “%1” falta ou é outro</translation>
    </message>
    <message>
        <source>a machine is one JSON object</source>
        <translation>uma máquina é um objeto JSON</translation>
    </message>
    <message>
        <source>a message is cut off</source>
        <translation>uma mensagem está cortada</translation>
    </message>
    <message>
        <source>a message is not plain CDR</source>
        <translation>uma mensagem não é CDR simples</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>um número</translation>
    </message>
    <message>
        <source>a number is too large to be read</source>
        <translation>um número é grande demais para ser lido</translation>
    </message>
    <message>
        <source>a part of it states %1 bytes, more than 256 MiB</source>
        <translation>uma parte indica %1 bytes, mais de 256 MiB</translation>
    </message>
    <message>
        <source>a part of the boundary of &apos;%1&apos; is missing or another</source>
        <translation>uma parte do limite de “%1” falta ou é outra</translation>
    </message>
    <message>
        <source>a point</source>
        <translation>um ponto</translation>
    </message>
    <message>
        <source>a point has no place in EPSG:%1</source>
        <translation>um ponto não tem lugar em EPSG:%1</translation>
    </message>
    <message>
        <source>a point or a line in WGS84 such as LINESTRING (4.1 52.0, 4.2 52.0)</source>
        <translation>um ponto ou uma linha em WGS84 como LINESTRING (4.1 52.0, 4.2 52.0)</translation>
    </message>
    <message>
        <source>a record of the recording is damaged</source>
        <translation>um registro da gravação está danificado</translation>
    </message>
    <message>
        <source>a sliver of %1 was left out</source>
        <translation>uma sobra de %1 foi deixada de fora</translation>
    </message>
    <message>
        <source>a track that ended %1 from where it began was closed</source>
        <translation>uma trilha que terminava a %1 do começo foi fechada</translation>
    </message>
    <message>
        <source>a value of its own</source>
        <translation>um valor próprio</translation>
    </message>
    <message>
        <source>add the .prj file that belongs to it, or export the field again in WGS84</source>
        <translation>adicione o arquivo .prj correspondente ou exporte o talhão de novo em WGS84</translation>
    </message>
    <message>
        <source>allow it to be kept as a backup</source>
        <translation>permita guardá-lo como cópia</translation>
    </message>
    <message>
        <source>an obstacle</source>
        <translation>um obstáculo</translation>
    </message>
    <message>
        <source>an obstacle has no shape</source>
        <translation>um obstáculo não tem forma</translation>
    </message>
    <message>
        <source>an overlap of %1 leaves nothing of %2</source>
        <translation>uma sobreposição de %1 não deixa nada de %2</translation>
    </message>
    <message>
        <source>boundary accuracy</source>
        <translation>precisão do limite</translation>
    </message>
    <message>
        <source>changes cannot be kept for the case of a crash: %1</source>
        <translation>as alterações não podem ser guardadas para o caso de uma falha: %1</translation>
    </message>
    <message>
        <source>check its coordinates</source>
        <translation>verifique as coordenadas</translation>
    </message>
    <message>
        <source>check that the folder can be written to</source>
        <translation>verifique se é possível gravar na pasta</translation>
    </message>
    <message>
        <source>check that you may read it</source>
        <translation>verifique se há permissão para lê-lo</translation>
    </message>
    <message>
        <source>check the boundary for crossings</source>
        <translation>verifique se o limite se cruza</translation>
    </message>
    <message>
        <source>check the coordinate system, correct this point, or split the field</source>
        <translation>verifique o sistema de coordenadas, corrija este ponto ou divida o talhão</translation>
    </message>
    <message>
        <source>check the file&apos;s coordinate system</source>
        <translation>verifique o sistema de coordenadas do arquivo</translation>
    </message>
    <message>
        <source>check the operating width and the overlap</source>
        <translation>verifique a largura de trabalho e a sobreposição</translation>
    </message>
    <message>
        <source>check the path</source>
        <translation>verifique o caminho</translation>
    </message>
    <message>
        <source>check the width and how far the edge lies from the line</source>
        <translation>verifique a largura e a distância da borda até a linha</translation>
    </message>
    <message>
        <source>check the width of the implement, or take the track as driven around the field</source>
        <translation>verifique a largura do implemento ou tome o percurso como volta ao redor do talhão</translation>
    </message>
    <message>
        <source>choose a narrower headland or a narrower machine</source>
        <translation>escolha uma cabeceira ou uma máquina mais estreita</translation>
    </message>
    <message>
        <source>choose a smaller machine or check the boundary&apos;s coordinate system</source>
        <translation>escolha uma máquina menor ou verifique o sistema de coordenadas do limite</translation>
    </message>
    <message>
        <source>choose another format</source>
        <translation>escolha outro formato</translation>
    </message>
    <message>
        <source>choose one by its id: %1</source>
        <translation>escolha um pelo identificador: %1</translation>
    </message>
    <message>
        <source>choose one by its number in the file: %1</source>
        <translation>escolha um pelo número no arquivo: %1</translation>
    </message>
    <message>
        <source>choose the format rosbag2-mcap</source>
        <translation>escolha o formato rosbag2-mcap</translation>
    </message>
    <message>
        <source>close it there first</source>
        <translation>feche-o lá primeiro</translation>
    </message>
    <message>
        <source>contour needs heights</source>
        <translation>curvas de nível precisam de altitudes</translation>
    </message>
    <message>
        <source>copy it again, or mend it with &apos;mcap recover&apos; or sqlite3&apos;s &apos;.recover&apos;</source>
        <translation>copie de novo ou repare com “mcap recover” ou “.recover” do sqlite3</translation>
    </message>
    <message>
        <source>copy or export it again</source>
        <translation>copie ou exporte de novo</translation>
    </message>
    <message>
        <source>copy or export the recording again</source>
        <translation>copie ou exporte a gravação de novo</translation>
    </message>
    <message>
        <source>copy the whole folder</source>
        <translation>copie a pasta inteira</translation>
    </message>
    <message>
        <source>correct it, or remove the hole or obstacle from the file</source>
        <translation>corrija-o, ou remova o vazio ou obstáculo do arquivo</translation>
    </message>
    <message>
        <source>correct or delete this point in the file</source>
        <translation>corrija ou exclua este ponto no arquivo</translation>
    </message>
    <message>
        <source>correct or remove the line</source>
        <translation>corrija ou remova a linha</translation>
    </message>
    <message>
        <source>correct or remove the point</source>
        <translation>corrija ou remova o ponto</translation>
    </message>
    <message>
        <source>correct the line, or export the track in WGS84</source>
        <translation>corrija a linha ou exporte o percurso em WGS84</translation>
    </message>
    <message>
        <source>could not be read: %1</source>
        <translation>não foi possível ler: %1</translation>
    </message>
    <message>
        <source>could not be written: %1</source>
        <translation>não foi possível gravar: %1</translation>
    </message>
    <message>
        <source>crosses an obstacle</source>
        <translation>cruza um obstáculo</translation>
    </message>
    <message>
        <source>cut it into the days or fields that it holds</source>
        <translation>divida-o nos dias ou talhões que contém</translation>
    </message>
    <message>
        <source>decimal commas in the place of the field were taken for points</source>
        <translation>vírgulas decimais na posição do talhão foram lidas como pontos</translation>
    </message>
    <message>
        <source>delete some of them</source>
        <translation>exclua alguns</translation>
    </message>
    <message>
        <source>delete the hole that covers it</source>
        <translation>exclua o vazio que o cobre</translation>
    </message>
    <message>
        <source>did you mean &apos;%1&apos;?</source>
        <translation>seria “%1”?</translation>
    </message>
    <message>
        <source>did you mean &apos;%1&apos;? use one of: %2; or give a machine file (.json)</source>
        <translation>seria “%1”? use uma de: %2; ou informe um arquivo de máquina (.json)</translation>
    </message>
    <message>
        <source>download the file and give its path</source>
        <translation>baixe o arquivo e informe o caminho</translation>
    </message>
    <message>
        <source>draw it again</source>
        <translation>desenhe de novo</translation>
    </message>
    <message>
        <source>draw it again with at least 3 corners</source>
        <translation>desenhe de novo com pelo menos 3 cantos</translation>
    </message>
    <message>
        <source>draw it as an area, or remove it from the file</source>
        <translation>desenhe-o como área, ou remova-o do arquivo</translation>
    </message>
    <message>
        <source>draw it, or remove it from the file</source>
        <translation>desenhe-o, ou remova-o do arquivo</translation>
    </message>
    <message>
        <source>draw one or open a file that has one</source>
        <translation>desenhe um ou abra um arquivo que o tenha</translation>
    </message>
    <message>
        <source>draw or open one in the window first</source>
        <translation>desenhe ou abra um primeiro na janela</translation>
    </message>
    <message>
        <source>drive on to where the recording began, or take the track as worked land</source>
        <translation>siga até onde a gravação começou ou tome o percurso como terra trabalhada</translation>
    </message>
    <message>
        <source>export fewer fields at once</source>
        <translation>exporte menos talhões de cada vez</translation>
    </message>
    <message>
        <source>export it again</source>
        <translation>exporte de novo</translation>
    </message>
    <message>
        <source>export it again with its coordinate system</source>
        <translation>exporte de novo com o sistema de coordenadas</translation>
    </message>
    <message>
        <source>export or copy it again</source>
        <translation>exporte ou copie de novo</translation>
    </message>
    <message>
        <source>export the boundary as a polygon</source>
        <translation>exporte o limite como polígono</translation>
    </message>
    <message>
        <source>export the field again in WGS84 (longitude and latitude)</source>
        <translation>exporte o talhão de novo em WGS84 (longitude e latitude)</translation>
    </message>
    <message>
        <source>export the field with its boundary</source>
        <translation>exporte o talhão com seu limite</translation>
    </message>
    <message>
        <source>export the field with its boundary; furrow-cli compare reads what a machine recorded</source>
        <translation>exporte o talhão com seu limite; furrow-cli compare lê o que uma máquina gravou</translation>
    </message>
    <message>
        <source>export the fields again in one coordinate system</source>
        <translation>exporte os talhões de novo em um único sistema de coordenadas</translation>
    </message>
    <message>
        <source>export the recorded track, not only its waypoints</source>
        <translation>exporte o percurso gravado, não só os pontos de passagem</translation>
    </message>
    <message>
        <source>feature %1</source>
        <translation>objeto %1</translation>
    </message>
    <message>
        <source>fewer than 3 different points enclose nothing</source>
        <translation>menos de 3 pontos diferentes não cercam nada</translation>
    </message>
    <message>
        <source>free some space on it, or use another one</source>
        <translation>libere espaço ou use outro</translation>
    </message>
    <message>
        <source>free some space on the stick</source>
        <translation>libere espaço no pen drive</translation>
    </message>
    <message>
        <source>free some space or choose another folder</source>
        <translation>libere espaço ou escolha outra pasta</translation>
    </message>
    <message>
        <source>gate %1</source>
        <translation>entrada %1</translation>
    </message>
    <message>
        <source>give %1</source>
        <translation>informe %1</translation>
    </message>
    <message>
        <source>give 0 m or more</source>
        <translation>informe 0 m ou mais</translation>
    </message>
    <message>
        <source>give GPX, CSV, an NMEA or gpsd log, ISOXML task data (folder, TASKDATA.XML or zip) or a rosbag2</source>
        <translation>informe GPX, CSV, um registro NMEA ou gpsd, dados de tarefas ISOXML (pasta, TASKDATA.XML ou zip) ou um rosbag2</translation>
    </message>
    <message>
        <source>give GeoJSON, a shapefile (.shp or .zip), TASKDATA.XML, KML, KMZ, GeoPackage, GML, FlatGeobuf, DXF, WKT or CSV</source>
        <translation>informe GeoJSON, um shapefile (.shp ou .zip), TASKDATA.XML, KML, KMZ, GeoPackage, GML, FlatGeobuf, DXF, WKT ou CSV</translation>
    </message>
    <message>
        <source>give a GeoTIFF, or a world file (.pgw) beside the PNG</source>
        <translation>informe um GeoTIFF ou um arquivo de georreferência (.pgw) ao lado do PNG</translation>
    </message>
    <message>
        <source>give a buffer of 0 m or more</source>
        <translation>informe uma distância de 0 m ou mais</translation>
    </message>
    <message>
        <source>give a distance up to 50 m</source>
        <translation>informe uma distância de até 50 m</translation>
    </message>
    <message>
        <source>give a gap up to 100 m</source>
        <translation>informe uma lacuna de até 100 m</translation>
    </message>
    <message>
        <source>give a plan and a track of the same field</source>
        <translation>informe um plano e um percurso do mesmo talhão</translation>
    </message>
    <message>
        <source>give a width up to 100 m</source>
        <translation>informe uma largura de até 100 m</translation>
    </message>
    <message>
        <source>give an overhang of 0 to 100 m</source>
        <translation>informe um balanço de 0 a 100 m</translation>
    </message>
    <message>
        <source>give a curve that does not, or plan its parts apart</source>
        <translation>informe uma curva que não se cruze ou planeje as partes separadamente</translation>
    </message>
    <message>
        <source>give a file on a disk</source>
        <translation>informe um arquivo em um disco</translation>
    </message>
    <message>
        <source>give a file with a line for each row</source>
        <translation>informe um arquivo com uma linha por fileira</translation>
    </message>
    <message>
        <source>give a gate, or a point in the field</source>
        <translation>informe uma entrada ou um ponto no talhão</translation>
    </message>
    <message>
        <source>give a gentler curve, or one without a turn back</source>
        <translation>informe uma curva mais suave ou sem volta para trás</translation>
    </message>
    <message>
        <source>give a machine file (JSON)</source>
        <translation>informe um arquivo de máquina (JSON)</translation>
    </message>
    <message>
        <source>give a number</source>
        <translation>informe um número</translation>
    </message>
    <message>
        <source>give a number from %1 to %2</source>
        <translation>informe um número de %1 a %2</translation>
    </message>
    <message>
        <source>give a number from 0 to %1</source>
        <translation>informe um número de 0 a %1</translation>
    </message>
    <message>
        <source>give a number in %1</source>
        <translation>informe um número em %1</translation>
    </message>
    <message>
        <source>give a picture of at most 100 million pixels</source>
        <translation>informe uma imagem de no máximo 100 milhões de pixels</translation>
    </message>
    <message>
        <source>give a point such as POINT (4.1 52.0)</source>
        <translation>informe um ponto como POINT (4.1 52.0)</translation>
    </message>
    <message>
        <source>give a smaller margin or check the obstacles</source>
        <translation>informe uma margem menor ou verifique os obstáculos</translation>
    </message>
    <message>
        <source>give a smaller number</source>
        <translation>informe um número menor</translation>
    </message>
    <message>
        <source>give a text in quotes</source>
        <translation>informe um texto entre aspas</translation>
    </message>
    <message>
        <source>give a transverse Mercator with +lat_0 and +lon_0</source>
        <translation>informe uma transversa de Mercator com +lat_0 e +lon_0</translation>
    </message>
    <message>
        <source>give a width of 0 m or more</source>
        <translation>informe uma largura de 0 m ou mais</translation>
    </message>
    <message>
        <source>give an EPSG code, as in SRID=4326;POLYGON(...)</source>
        <translation>informe um código EPSG, como SRID=4326;POLYGON(...)</translation>
    </message>
    <message>
        <source>give both in degrees, or remove the row</source>
        <translation>informe ambas em graus ou remova a linha</translation>
    </message>
    <message>
        <source>give each point as [longitude, latitude]</source>
        <translation>informe cada ponto como [longitude, latitude]</translation>
    </message>
    <message>
        <source>give heights as a GeoTIFF or an ASCII grid</source>
        <translation>informe as altitudes como GeoTIFF ou grade ASCII</translation>
    </message>
    <message>
        <source>give heights that cover the field</source>
        <translation>informe altitudes que cubram o talhão</translation>
    </message>
    <message>
        <source>give it a kind, or remove it from the file</source>
        <translation>informe o tipo, ou remova-o do arquivo</translation>
    </message>
    <message>
        <source>give it as WKT in WGS84, %1</source>
        <translation>informe como WKT em WGS84, %1</translation>
    </message>
    <message>
        <source>give it as WKT in WGS84, such as LINESTRING (4.1 52.0, 4.2 52.0, 4.3 52.1)</source>
        <translation>informe como WKT em WGS84, como LINESTRING (4.1 52.0, 4.2 52.0, 4.3 52.1)</translation>
    </message>
    <message>
        <source>give it as WKT in WGS84, such as POINT (4.1 52.0)</source>
        <translation>informe como WKT em WGS84, como POINT (4.1 52.0)</translation>
    </message>
    <message>
        <source>give it the field that it lies in, or remove it from the file</source>
        <translation>indique o talhão em que está, ou remova-o do arquivo</translation>
    </message>
    <message>
        <source>give its width while it is folded</source>
        <translation>informe a largura com o implemento dobrado</translation>
    </message>
    <message>
        <source>give less than the operating width</source>
        <translation>informe menos que a largura de trabalho</translation>
    </message>
    <message>
        <source>give metres, 0 or more</source>
        <translation>informe metros, 0 ou mais</translation>
    </message>
    <message>
        <source>give min_turning_radius_m or max_steering_angle_deg</source>
        <translation>informe min_turning_radius_m ou max_steering_angle_deg</translation>
    </message>
    <message>
        <source>give one of %1 or a point such as POINT (4.1 52.0)</source>
        <translation>informe uma de %1 ou um ponto como POINT (4.1 52.0)</translation>
    </message>
    <message>
        <source>give one of the files in it</source>
        <translation>informe um dos arquivos dela</translation>
    </message>
    <message>
        <source>give operating_width_m in metres</source>
        <translation>informe operating_width_m em metros</translation>
    </message>
    <message>
        <source>give the file TASKDATA.XML</source>
        <translation>informe o arquivo TASKDATA.XML</translation>
    </message>
    <message>
        <source>give the folder of a field</source>
        <translation>informe a pasta de um talhão</translation>
    </message>
    <message>
        <source>give the folder of one of these, or a file in it</source>
        <translation>informe a pasta de um deles ou um arquivo dela</translation>
    </message>
    <message>
        <source>give the folder of one recording</source>
        <translation>informe a pasta de uma gravação</translation>
    </message>
    <message>
        <source>give the folder or zip with TASKDATA.XML and its TLG files, a rosbag2 folder, or one file</source>
        <translation>informe a pasta ou o zip com TASKDATA.XML e seus arquivos TLG, uma pasta de rosbag2 ou um arquivo</translation>
    </message>
    <message>
        <source>give the points in degrees (WGS84), longitude in lon and latitude in lat</source>
        <translation>informe os pontos em graus (WGS84), longitude em lon e latitude em lat</translation>
    </message>
    <message>
        <source>give true or false</source>
        <translation>informe true ou false</translation>
    </message>
    <message>
        <source>give two points at least 1 m apart</source>
        <translation>informe dois pontos separados por pelo menos 1 m</translation>
    </message>
    <message>
        <source>give x_m and y_m in the plan&apos;s frame, or longitude and latitude</source>
        <translation>informe x_m e y_m no sistema do plano, ou longitude e latitude</translation>
    </message>
    <message>
        <source>guidance lines without two points</source>
        <translation>linhas de orientação sem dois pontos</translation>
    </message>
    <message>
        <source>guidance patterns whose points do not fit their kind</source>
        <translation>padrões de orientação cujos pontos não combinam com o tipo</translation>
    </message>
    <message>
        <source>guidance patterns without a line</source>
        <translation>padrões de orientação sem linha</translation>
    </message>
    <message>
        <source>headland pass %1</source>
        <translation>passada de cabeceira %1</translation>
    </message>
    <message>
        <source>hole %1 encloses no area and was left out</source>
        <translation>o vazio %1 não cerca área e foi deixado de fora</translation>
    </message>
    <message>
        <source>it does not say in which coordinate system it is</source>
        <translation>não diz em qual sistema de coordenadas está</translation>
    </message>
    <message>
        <source>it does not say what it is</source>
        <translation>não diz o que é</translation>
    </message>
    <message>
        <source>it does not say which field it belongs to</source>
        <translation>não diz a que talhão pertence</translation>
    </message>
    <message>
        <source>it has %1 by %2 pixels</source>
        <translation>tem %1 por %2 pixels</translation>
    </message>
    <message>
        <source>it has %1: %2</source>
        <translation>ele tem %1: %2</translation>
    </message>
    <message>
        <source>it has another coordinate system than the file</source>
        <translation>tem outro sistema de coordenadas que o arquivo</translation>
    </message>
    <message>
        <source>it has more than %1 parts</source>
        <translation>tem mais de %1 partes</translation>
    </message>
    <message>
        <source>it has no heights where the field is</source>
        <translation>não tem altitudes onde fica o talhão</translation>
    </message>
    <message>
        <source>it has no shape</source>
        <translation>não tem forma</translation>
    </message>
    <message>
        <source>it has: %1</source>
        <translation>ele tem: %1</translation>
    </message>
    <message>
        <source>it holds more than %1 files</source>
        <translation>contém mais de %1 arquivos</translation>
    </message>
    <message>
        <source>it holds more than %1 positions</source>
        <translation>contém mais de %1 posições</translation>
    </message>
    <message>
        <source>it is a line at %1 without a width</source>
        <translation>é uma linha em %1 sem largura</translation>
    </message>
    <message>
        <source>it is a point at %1 without a size</source>
        <translation>é um ponto em %1 sem tamanho</translation>
    </message>
    <message>
        <source>it is no closed line</source>
        <translation>não é uma linha fechada</translation>
    </message>
    <message>
        <source>it is no raster of heights</source>
        <translation>não é um raster de altitudes</translation>
    </message>
    <message>
        <source>it is no rosbag2 that can be read (%1)</source>
        <translation>não é um rosbag2 legível (%1)</translation>
    </message>
    <message>
        <source>it is not a length</source>
        <translation>não é um comprimento</translation>
    </message>
    <message>
        <source>it is not what a plan&apos;s is</source>
        <translation>não é o de um plano</translation>
    </message>
    <message>
        <source>it lies in none of the %1 fields</source>
        <translation>não fica em nenhum dos %1 talhões</translation>
    </message>
    <message>
        <source>it lies outside the field</source>
        <translation>fica fora do talhão</translation>
    </message>
    <message>
        <source>it may be damaged; copy or export it again</source>
        <translation>pode estar danificado; copie ou exporte de novo</translation>
    </message>
    <message>
        <source>it names no local frame</source>
        <translation>não nomeia um sistema local</translation>
    </message>
    <message>
        <source>it names no machine</source>
        <translation>não nomeia uma máquina</translation>
    </message>
    <message>
        <source>it needs latitude and longitude, as in 52.09,5.66</source>
        <translation>precisa de latitude e longitude, como 52.09,5.66</translation>
    </message>
    <message>
        <source>its buffer is not a length</source>
        <translation>sua distância não é um comprimento</translation>
    </message>
    <message>
        <source>its compression &apos;%1&apos; is not known</source>
        <translation>a compressão “%1” não é conhecida</translation>
    </message>
    <message>
        <source>its overhang is not a length from 0 to 100 m</source>
        <translation>o balanço não é um comprimento de 0 a 100 m</translation>
    </message>
    <message>
        <source>its coordinate system &apos;%1&apos; cannot be turned into WGS84</source>
        <translation>o sistema de coordenadas “%1” não pode ser convertido para WGS84</translation>
    </message>
    <message>
        <source>its coordinate system &apos;%1&apos; is not known</source>
        <translation>seu sistema de coordenadas “%1” não é conhecido</translation>
    </message>
    <message>
        <source>its coordinate system cannot be turned into WGS84</source>
        <translation>o sistema de coordenadas não pode ser convertido para WGS84</translation>
    </message>
    <message>
        <source>its coordinate system would have to be fetched from &apos;%1&apos;</source>
        <translation>seu sistema de coordenadas teria de ser baixado de “%1”</translation>
    </message>
    <message>
        <source>its file is missing</source>
        <translation>falta o arquivo</translation>
    </message>
    <message>
        <source>its heights cannot be read</source>
        <translation>não é possível ler as altitudes</translation>
    </message>
    <message>
        <source>its holes leave nothing of it</source>
        <translation>os vazios não deixam nada</translation>
    </message>
    <message>
        <source>its kind &apos;%1&apos; is not known</source>
        <translation>seu tipo “%1” não é conhecido</translation>
    </message>
    <message>
        <source>its points enclose no area</source>
        <translation>seus pontos não cercam área</translation>
    </message>
    <message>
        <source>its width is not a length</source>
        <translation>sua largura não é um comprimento</translation>
    </message>
    <message>
        <source>keep one of them</source>
        <translation>mantenha uma delas</translation>
    </message>
    <message>
        <source>keep the .shp, .shx, .dbf and .prj files together</source>
        <translation>mantenha juntos .shp, .shx, .dbf e .prj</translation>
    </message>
    <message>
        <source>leave it out, or give a project of the window</source>
        <translation>omita-o, ou informe um projeto da janela</translation>
    </message>
    <message>
        <source>leaves the field by %1</source>
        <translation>sai %1 do talhão</translation>
    </message>
    <message>
        <source>left out: %1</source>
        <translation>deixado de fora: %1</translation>
    </message>
    <message>
        <source>left out: %1 %2</source>
        <translation>deixado de fora: %1 %2</translation>
    </message>
    <message>
        <source>line %1 is left out: it is damaged</source>
        <translation>a linha %1 fica de fora: está danificada</translation>
    </message>
    <message>
        <source>line %1, column %2</source>
        <translation>linha %1, coluna %2</translation>
    </message>
    <message>
        <source>lines in WGS84 such as MULTILINESTRING ((4.1 52.0, 4.2 52.0), (4.1 52.1, 4.2 52.1))</source>
        <translation>linhas em WGS84 como MULTILINESTRING ((4.1 52.0, 4.2 52.0), (4.1 52.1, 4.2 52.1))</translation>
    </message>
    <message>
        <source>lines that guide nothing</source>
        <translation>linhas que não orientam nada</translation>
    </message>
    <message>
        <source>lon=&quot;%1&quot; lat=&quot;%2&quot; is no place on Earth</source>
        <translation>lon=&quot;%1&quot; lat=&quot;%2&quot; não é um lugar na Terra</translation>
    </message>
    <message>
        <source>look for a missing comma, quote or brace just before it</source>
        <translation>procure logo antes uma vírgula, aspas ou chave que falte</translation>
    </message>
    <message>
        <source>most of its lines are not JSON</source>
        <translation>a maioria das linhas não é JSON</translation>
    </message>
    <message>
        <source>most of its sentences have a wrong checksum</source>
        <translation>a maioria das sentenças tem uma soma de verificação errada</translation>
    </message>
    <message>
        <source>move one of the points there, so that it is clear which side is field</source>
        <translation>mova ali um ponto, para ficar claro de que lado está o talhão</translation>
    </message>
    <message>
        <source>move or delete it</source>
        <translation>mova ou exclua</translation>
    </message>
    <message>
        <source>name a raster of heights, such as a GeoTIFF</source>
        <translation>indique um raster de altitudes, como um GeoTIFF</translation>
    </message>
    <message>
        <source>name each swath once</source>
        <translation>indique cada passada uma vez</translation>
    </message>
    <message>
        <source>name each swath once, with a minus where it is driven backwards</source>
        <translation>indique cada passada uma vez, com um menos onde é feita ao contrário</translation>
    </message>
    <message>
        <source>name one, such as GeoJSON with a LineString for each row</source>
        <translation>indique um, como GeoJSON com um LineString por fileira</translation>
    </message>
    <message>
        <source>name the columns in the first row</source>
        <translation>nomeie as colunas na primeira linha</translation>
    </message>
    <message>
        <source>name the columns, for example time,lon,lat,speed_kmh in the first line</source>
        <translation>dê nome às colunas, por exemplo time,lon,lat,speed_kmh na primeira linha</translation>
    </message>
    <message>
        <source>name the folder of a plan, as furrow-cli plan writes it</source>
        <translation>informe a pasta de um plano, como furrow-cli plan a grava</translation>
    </message>
    <message>
        <source>neither turning radius nor steering angle is given</source>
        <translation>não foi informado nem raio de giro nem ângulo de esterçamento</translation>
    </message>
    <message>
        <source>no boundary can be read from this file (%1)</source>
        <translation>não é possível ler limite deste arquivo (%1)</translation>
    </message>
    <message>
        <source>no header names a longitude and a latitude (or x_m and y_m)</source>
        <translation>nenhum cabeçalho indica longitude e latitude (ou x_m e y_m)</translation>
    </message>
    <message>
        <source>no pixel of the picture is worked</source>
        <translation>nenhum pixel da imagem está trabalhado</translation>
    </message>
    <message>
        <source>no row of this table has a position</source>
        <translation>nenhuma linha desta tabela tem posição</translation>
    </message>
    <message>
        <source>no swath fits inside the headland</source>
        <translation>não cabe nenhuma passada no interior do talhão</translation>
    </message>
    <message>
        <source>no topic of this bag has a position</source>
        <translation>nenhum tópico deste bag tem posição</translation>
    </message>
    <message>
        <source>none of its %1 RMC and GGA sentences has a position</source>
        <translation>nenhuma das %1 sentenças RMC e GGA tem posição</translation>
    </message>
    <message>
        <source>none of its %1 position reports has a position</source>
        <translation>nenhum dos %1 relatórios de posição tem posição</translation>
    </message>
    <message>
        <source>none of its %1 time logs holds a position</source>
        <translation>nenhum dos %1 registros de tempo contém posições</translation>
    </message>
    <message>
        <source>none of the tracks has more than one position</source>
        <translation>nenhum dos percursos tem mais de uma posição</translation>
    </message>
    <message>
        <source>nothing is left of the land inside of this track</source>
        <translation>não sobra nada da terra dentro deste percurso</translation>
    </message>
    <message>
        <source>obstacle %1</source>
        <translation>obstáculo %1</translation>
    </message>
    <message>
        <source>obstacles outside the boundary</source>
        <translation>obstáculos fora do limite</translation>
    </message>
    <message>
        <source>obstacles that are holes already</source>
        <translation>obstáculos que já são vazios</translation>
    </message>
    <message>
        <source>one of its choices</source>
        <translation>uma das opções</translation>
    </message>
    <message>
        <source>only files on this computer are read</source>
        <translation>só são lidos arquivos deste computador</translation>
    </message>
    <message>
        <source>only the fields of a project have plans</source>
        <translation>só os talhões de um projeto têm planos</translation>
    </message>
    <message>
        <source>open a file of your own</source>
        <translation>abra um arquivo seu</translation>
    </message>
    <message>
        <source>open it as a field boundary, or choose another file</source>
        <translation>abra como limite de talhão ou escolha outro arquivo</translation>
    </message>
    <message>
        <source>open it with a newer Furrow; the file was left as it is</source>
        <translation>abra com um Furrow mais novo; o arquivo ficou como estava</translation>
    </message>
    <message>
        <source>open the field of that plan first, or record longitude and latitude</source>
        <translation>abra primeiro o talhão desse plano ou grave longitude e latitude</translation>
    </message>
    <message>
        <source>opennav_coverage goal</source>
        <translation>Objetivo do opennav_coverage</translation>
    </message>
    <message>
        <source>opennav_coverage lays swaths and turns of its own from the goal; they need not be those of this plan.</source>
        <translation>O opennav_coverage traça passadas e manobras próprias; não precisam ser as deste plano.</translation>
    </message>
    <message>
        <source>part %1</source>
        <translation>parte %1</translation>
    </message>
    <message>
        <source>part %1, point %2</source>
        <translation>parte %1, ponto %2</translation>
    </message>
    <message>
        <source>path.csv has %1 segments and plan.geojson %2</source>
        <translation>path.csv tem %1 trechos e plan.geojson %2</translation>
    </message>
    <message>
        <source>per m²</source>
        <translation>por m²</translation>
    </message>
    <message>
        <source>pivot needs its centre</source>
        <translation>os círculos precisam do centro</translation>
    </message>
    <message>
        <source>plan the field first: furrow-cli plan FIELD --out plan</source>
        <translation>planeje primeiro o talhão: furrow-cli plan FIELD --out plan</translation>
    </message>
    <message>
        <source>points that are no gates</source>
        <translation>pontos que não são entradas</translation>
    </message>
    <message>
        <source>polygons of a kind that is not used</source>
        <translation>polígonos de um tipo não usado</translation>
    </message>
    <message>
        <source>put the EPSG code into its name, as in field_EPSG32632.dxf</source>
        <translation>ponha o código EPSG no nome, como field_EPSG32632.dxf</translation>
    </message>
    <message>
        <source>record %1 has a value that its header does not name</source>
        <translation>o registro %1 tem um valor que o cabeçalho não indica</translation>
    </message>
    <message>
        <source>record a position every second, or every few metres</source>
        <translation>grave uma posição a cada segundo ou a cada poucos metros</translation>
    </message>
    <message>
        <source>record or draw its boundary first</source>
        <translation>grave ou desenhe primeiro o limite</translation>
    </message>
    <message>
        <source>record or export it again</source>
        <translation>grave ou exporte de novo</translation>
    </message>
    <message>
        <source>record sensor_msgs/NavSatFix, nav_msgs/Odometry, geometry_msgs/PoseStamped or nav_msgs/Path</source>
        <translation>grave sensor_msgs/NavSatFix, nav_msgs/Odometry, geometry_msgs/PoseStamped ou nav_msgs/Path</translation>
    </message>
    <message>
        <source>record the log again with a receiver that has a fix</source>
        <translation>grave de novo com um receptor que conheça sua posição</translation>
    </message>
    <message>
        <source>record the positions without pictures and point clouds</source>
        <translation>grave as posições sem imagens nem nuvens de pontos</translation>
    </message>
    <message>
        <source>record with a correction signal (EGNOS, RTK), or under an open sky</source>
        <translation>grave com sinal de correção (EGNOS, RTK) ou a céu aberto</translation>
    </message>
    <message>
        <source>record with zstd, lz4 or no compression</source>
        <translation>grave com zstd, lz4 ou sem compressão</translation>
    </message>
    <message>
        <source>remove it from the file, or add its field</source>
        <translation>remova-o do arquivo ou adicione seu talhão</translation>
    </message>
    <message>
        <source>remove it; keys look like operating_width_m, vehicle_width_m, can_reverse</source>
        <translation>remova; as chaves são como operating_width_m, vehicle_width_m, can_reverse</translation>
    </message>
    <message>
        <source>restore a copy of the file</source>
        <translation>restaure uma cópia do arquivo</translation>
    </message>
    <message>
        <source>rings that overlap each other were joined</source>
        <translation>anéis que se sobrepõem foram unidos</translation>
    </message>
    <message>
        <source>rings with fewer than three corners</source>
        <translation>anéis com menos de três cantos</translation>
    </message>
    <message>
        <source>rows needs a file of lines</source>
        <translation>as fileiras precisam de um arquivo de linhas</translation>
    </message>
    <message>
        <source>save it again in WGS84</source>
        <translation>salve de novo em WGS84</translation>
    </message>
    <message>
        <source>save it as GeoTIFF, or with a world file in degrees</source>
        <translation>salve como GeoTIFF ou com arquivo de georreferência em graus</translation>
    </message>
    <message>
        <source>save the field again, or remove this file</source>
        <translation>salve o talhão de novo ou remova este arquivo</translation>
    </message>
    <message>
        <source>save the project, and free some space</source>
        <translation>salve o projeto e libere espaço</translation>
    </message>
    <message>
        <source>say how far to keep from it (buffer_m), or draw its outline</source>
        <translation>indique a distância a manter (buffer_m), ou desenhe o contorno</translation>
    </message>
    <message>
        <source>several fields are called &apos;%1&apos;</source>
        <translation>vários talhões se chamam “%1”</translation>
    </message>
    <message>
        <source>several plans of &apos;%1&apos; are called &apos;%2&apos;</source>
        <translation>vários planos de “%1” se chamam “%2”</translation>
    </message>
    <message>
        <source>simplify it to at most a million</source>
        <translation>simplifique-o a no máximo um milhão</translation>
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
        <translation>passada %1</translation>
    </message>
    <message>
        <source>swath %1 is named twice</source>
        <translation>a passada %1 foi indicada duas vezes</translation>
    </message>
    <message>
        <source>take it away</source>
        <translation>retire-a</translation>
    </message>
    <message>
        <source>take off its write protection, or use another one</source>
        <translation>tire a proteção ou use outro</translation>
    </message>
    <message>
        <source>take off the write protection of the stick</source>
        <translation>tire a proteção contra gravação do pen drive</translation>
    </message>
    <message>
        <source>take the track as driven around the field, or record the work</source>
        <translation>tome o percurso como volta ao redor do talhão ou grave o trabalho</translation>
    </message>
    <message>
        <source>the .shx file that belongs to it is missing</source>
        <translation>falta o arquivo .shx correspondente</translation>
    </message>
    <message>
        <source>the GPX file is damaged (%1)</source>
        <translation>o arquivo GPX está danificado (%1)</translation>
    </message>
    <message>
        <source>the GPX file is larger than 256 MiB</source>
        <translation>o arquivo GPX é maior que 256 MiB</translation>
    </message>
    <message>
        <source>the boundary</source>
        <translation>o limite do talhão</translation>
    </message>
    <message>
        <source>the boundary has %1 points</source>
        <translation>o limite tem %1 pontos</translation>
    </message>
    <message>
        <source>the boundary has no such edge</source>
        <translation>o limite não tem esse lado</translation>
    </message>
    <message>
        <source>the boundary is that of the guidance group; the field itself has none</source>
        <translation>o limite é o do grupo de orientação; o próprio talhão não tem</translation>
    </message>
    <message>
        <source>the coordinate system that it names is not known</source>
        <translation>o sistema de coordenadas que ele indica não é conhecido</translation>
    </message>
    <message>
        <source>the coordinates lie outside longitude -180 to 180 and latitude -90 to 90</source>
        <translation>as coordenadas estão fora da longitude -180 a 180 e latitude -90 a 90</translation>
    </message>
    <message>
        <source>the curve bends more sharply than this machine can follow (%1 of radius)</source>
        <translation>a curva é mais fechada do que esta máquina consegue seguir (raio de %1)</translation>
    </message>
    <message>
        <source>the curve crosses itself, %1 from its start</source>
        <translation>a curva cruza a si mesma, a %1 do começo</translation>
    </message>
    <message>
        <source>the curves from line %1 on are left out: it is damaged</source>
        <translation>as curvas a partir da linha %1 ficam de fora: ela está danificada</translation>
    </message>
    <message>
        <source>the edge cannot lie that far from the line</source>
        <translation>a borda não pode ficar tão longe da linha</translation>
    </message>
    <message>
        <source>the end</source>
        <translation>fim</translation>
    </message>
    <message>
        <source>the field &apos;%1&apos; has no boundary</source>
        <translation>o talhão “%1” não tem limite</translation>
    </message>
    <message>
        <source>the field &apos;%1&apos; has no plan &apos;%2&apos;</source>
        <translation>o talhão “%1” não tem o plano “%2”</translation>
    </message>
    <message>
        <source>the field &apos;%1&apos; is left out: %2</source>
        <translation>o talhão “%1” fica de fora: %2</translation>
    </message>
    <message>
        <source>the field has neither boundary nor guidance line</source>
        <translation>o talhão não tem limite nem linha de orientação</translation>
    </message>
    <message>
        <source>the field has no boundary</source>
        <translation>o talhão não tem limite</translation>
    </message>
    <message>
        <source>the field is more than 100 km across; %1 is farthest from the others</source>
        <translation>o talhão tem mais de 100 km; %1 é o mais distante dos outros</translation>
    </message>
    <message>
        <source>the field is nowhere as wide as the machine (%1%2)</source>
        <translation>o talhão não é em lugar nenhum tão largo quanto a máquina (%1%2)</translation>
    </message>
    <message>
        <source>the fields in this task data have neither boundary nor guidance line</source>
        <translation>os talhões destes dados não têm limite nem linha de orientação</translation>
    </message>
    <message>
        <source>the file cannot be read</source>
        <translation>não é possível ler o arquivo</translation>
    </message>
    <message>
        <source>the file has %1 fields: %2</source>
        <translation>o arquivo tem %1 talhões: %2</translation>
    </message>
    <message>
        <source>the file is damaged</source>
        <translation>o arquivo está danificado</translation>
    </message>
    <message>
        <source>the file is damaged (%1)</source>
        <translation>o arquivo está danificado (%1)</translation>
    </message>
    <message>
        <source>the file is damaged here</source>
        <translation>o arquivo está danificado aqui</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>o arquivo está vazio</translation>
    </message>
    <message>
        <source>the file is empty or cannot be read</source>
        <translation>o arquivo está vazio ou não pode ser lido</translation>
    </message>
    <message>
        <source>the file is larger than 1 GiB</source>
        <translation>o arquivo é maior que 1 GiB</translation>
    </message>
    <message>
        <source>the file may be cut off or damaged; copy or export it again</source>
        <translation>o arquivo pode estar cortado ou danificado; copie ou exporte de novo</translation>
    </message>
    <message>
        <source>the file may be cut off or damaged; export it again</source>
        <translation>o arquivo pode estar cortado ou danificado; exporte de novo</translation>
    </message>
    <message>
        <source>the folder or zip cannot be read</source>
        <translation>não é possível ler a pasta ou o zip</translation>
    </message>
    <message>
        <source>the gap is out of range</source>
        <translation>a lacuna está fora do intervalo</translation>
    </message>
    <message>
        <source>the headland is left out: line %1 is damaged</source>
        <translation>a cabeceira fica de fora: a linha %1 está danificada</translation>
    </message>
    <message>
        <source>the headland of edge %1</source>
        <translation>a cabeceira do lado %1</translation>
    </message>
    <message>
        <source>the implement was nowhere down on this track</source>
        <translation>o implemento não esteve abaixado em nenhum ponto deste percurso</translation>
    </message>
    <message>
        <source>the log is cut off in record %1</source>
        <translation>o registro está cortado na entrada %1</translation>
    </message>
    <message>
        <source>the operating width is out of range</source>
        <translation>a largura de trabalho está fora do intervalo</translation>
    </message>
    <message>
        <source>the overhang of edge %1</source>
        <translation>o balanço do lado %1</translation>
    </message>
    <message>
        <source>edge %1</source>
        <translation>lado %1</translation>
    </message>
    <message>
        <source>the key is there twice</source>
        <translation>a chave aparece duas vezes</translation>
    </message>
    <message>
        <source>the line after StartFix is no place</source>
        <translation>a linha após StartFix não é uma posição</translation>
    </message>
    <message>
        <source>the line crosses itself at %1</source>
        <translation>a linha cruza a si mesma em %1</translation>
    </message>
    <message>
        <source>the line touches or crosses itself by a sliver; taken apart there</source>
        <translation>a linha toca ou cruza a si mesma por muito pouco; foi separada ali</translation>
    </message>
    <message>
        <source>the lines from line %1 on are left out: it is damaged</source>
        <translation>as linhas a partir da linha %1 ficam de fora: ela está danificada</translation>
    </message>
    <message>
        <source>the machine (%1 wide, %2 long%3) fits nowhere into the field</source>
        <translation>a máquina (%1 de largura, %2 de comprimento%3) não cabe em lugar nenhum do talhão</translation>
    </message>
    <message>
        <source>the name of a gate or a point in WGS84 such as POINT (4.1 52.0)</source>
        <translation>o nome de uma entrada ou um ponto em WGS84 como POINT (4.1 52.0)</translation>
    </message>
    <message>
        <source>the number after SRID= is no coordinate system that is known</source>
        <translation>o número após SRID= não é um sistema de coordenadas conhecido</translation>
    </message>
    <message>
        <source>the obstacles leave nothing of the field</source>
        <translation>os obstáculos não deixam nada do talhão</translation>
    </message>
    <message>
        <source>the operating width is missing</source>
        <translation>falta a largura de trabalho</translation>
    </message>
    <message>
        <source>the part %1 is left out: %2</source>
        <translation>a parte %1 fica de fora: %2</translation>
    </message>
    <message>
        <source>the path of a file</source>
        <translation>o caminho de um arquivo</translation>
    </message>
    <message>
        <source>the picture cannot be read (%1)</source>
        <translation>não é possível ler a imagem (%1)</translation>
    </message>
    <message>
        <source>the picture does not say where it lies</source>
        <translation>a imagem não diz onde fica</translation>
    </message>
    <message>
        <source>the picture does not say which coordinate system it uses</source>
        <translation>a imagem não diz qual sistema de coordenadas usa</translation>
    </message>
    <message>
        <source>the picture is damaged</source>
        <translation>a imagem está danificada</translation>
    </message>
    <message>
        <source>the place lies outside of the field</source>
        <translation>o lugar fica fora do talhão</translation>
    </message>
    <message>
        <source>the plan gives no reason</source>
        <translation>o plano não diz por quê</translation>
    </message>
    <message>
        <source>the positions of this track are metres in the plan that was driven, not places on Earth</source>
        <translation>as posições deste percurso são metros no plano seguido, e não lugares na Terra</translation>
    </message>
    <message>
        <source>the recorded path is left out: it is damaged</source>
        <translation>o percurso gravado fica de fora: está danificado</translation>
    </message>
    <message>
        <source>the recording cannot be made: %1</source>
        <translation>não é possível criar a gravação: %1</translation>
    </message>
    <message>
        <source>the recording is cut off in the middle of a record</source>
        <translation>a gravação está cortada no meio de um registro</translation>
    </message>
    <message>
        <source>the recording is cut off: its end is missing</source>
        <translation>a gravação está cortada: falta o fim</translation>
    </message>
    <message>
        <source>the sample field cannot be read</source>
        <translation>não é possível ler o talhão de exemplo</translation>
    </message>
    <message>
        <source>the shape could not be computed with (%1)</source>
        <translation>não foi possível calcular com a forma (%1)</translation>
    </message>
    <message>
        <source>the start</source>
        <translation>início</translation>
    </message>
    <message>
        <source>the stick does not answer any more (%1)</source>
        <translation>o pen drive não responde mais (%1)</translation>
    </message>
    <message>
        <source>the stick has %1 MB free, and %2 MB are needed</source>
        <translation>o pen drive tem %1 MB livres, e são necessários %2 MB</translation>
    </message>
    <message>
        <source>the stick is damaged: use another one</source>
        <translation>o pen drive está danificado: use outro</translation>
    </message>
    <message>
        <source>the stick is write-protected</source>
        <translation>o pen drive está protegido contra gravação</translation>
    </message>
    <message>
        <source>the strips of this track lie nowhere beside each other</source>
        <translation>as faixas deste percurso não ficam lado a lado em nenhum ponto</translation>
    </message>
    <message>
        <source>the swaths are left out: %1</source>
        <translation>as passadas ficam de fora: %1</translation>
    </message>
    <message>
        <source>the table has neither a column WKT nor columns lon and lat</source>
        <translation>a tabela não tem coluna WKT nem colunas lon e lat</translation>
    </message>
    <message>
        <source>the track does not come to the plan anywhere</source>
        <translation>o percurso não chega ao plano em nenhum ponto</translation>
    </message>
    <message>
        <source>the track goes around nothing: from its end to its beginning %1 are missing</source>
        <translation>o percurso não contorna nada: faltam %1 do fim até o início</translation>
    </message>
    <message numerus="yes">
        <source>the track has %n positions only</source>
        <translation>
            <numerusform>o percurso só tem %n posição</numerusform>
            <numerusform>o percurso só tem %n posições</numerusform>
        </translation>
    </message>
    <message>
        <source>the transfer after %1</source>
        <translation>o deslocamento após %1</translation>
    </message>
    <message>
        <source>the transfer at %1</source>
        <translation>o deslocamento em %1</translation>
    </message>
    <message>
        <source>the turn after %1</source>
        <translation>a manobra após %1</translation>
    </message>
    <message>
        <source>the turn at %1</source>
        <translation>a manobra em %1</translation>
    </message>
    <message>
        <source>the way to refill</source>
        <translation>o deslocamento para reabastecer</translation>
    </message>
    <message>
        <source>the zip cannot be made: %1</source>
        <translation>não é possível criar o zip: %1</translation>
    </message>
    <message>
        <source>there is no &apos;%1&apos;</source>
        <translation>não há “%1”</translation>
    </message>
    <message>
        <source>there is no &apos;%1&apos; in a machine</source>
        <translation>em uma máquina não há “%1”</translation>
    </message>
    <message>
        <source>there is no Field.txt</source>
        <translation>falta o Field.txt</translation>
    </message>
    <message>
        <source>there is no boundary</source>
        <translation>não há limite do talhão</translation>
    </message>
    <message>
        <source>there is no boundary file in this zip</source>
        <translation>não há arquivo de limites neste zip</translation>
    </message>
    <message>
        <source>there is no edge %1</source>
        <translation>não há lado %1</translation>
    </message>
    <message>
        <source>there is no field &apos;%1&apos; in the file</source>
        <translation>não há talhão “%1” no arquivo</translation>
    </message>
    <message>
        <source>there is no field &apos;%1&apos; in the project</source>
        <translation>não há talhão “%1” no projeto</translation>
    </message>
    <message>
        <source>there is no field boundary in it</source>
        <translation>não há limite de talhão nele</translation>
    </message>
    <message>
        <source>there is no field boundary in it, only %1</source>
        <translation>não há limite de talhão nele, só %1</translation>
    </message>
    <message>
        <source>there is no field in this project</source>
        <translation>não há talhão neste projeto</translation>
    </message>
    <message>
        <source>there is no field in this task data</source>
        <translation>não há talhão nestes dados</translation>
    </message>
    <message>
        <source>there is no gate &apos;%1&apos;</source>
        <translation>não há entrada “%1”</translation>
    </message>
    <message>
        <source>there is no line in it</source>
        <translation>não há linha nele</translation>
    </message>
    <message>
        <source>there is no machine &apos;%1&apos;</source>
        <translation>não há máquina “%1”</translation>
    </message>
    <message>
        <source>there is no path in it</source>
        <translation>não há percurso nele</translation>
    </message>
    <message>
        <source>there is no project format %1</source>
        <translation>não há formato de projeto %1</translation>
    </message>
    <message>
        <source>there is no recorded track in it</source>
        <translation>não há percurso gravado nele</translation>
    </message>
    <message>
        <source>there is no setting &apos;%1&apos;</source>
        <translation>não há configuração “%1”</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>esse arquivo não existe</translation>
    </message>
    <message>
        <source>there is no swath %1</source>
        <translation>não há passada %1</translation>
    </message>
    <message>
        <source>there is no terminal &apos;%1&apos;</source>
        <translation>não há terminal “%1”</translation>
    </message>
    <message>
        <source>there is no track in this GPX file</source>
        <translation>não há percurso neste arquivo GPX</translation>
    </message>
    <message>
        <source>this XML file is cut off</source>
        <translation>este arquivo XML está cortado</translation>
    </message>
    <message>
        <source>this XML is no task data</source>
        <translation>este XML não são dados de tarefa</translation>
    </message>
    <message>
        <source>this folder holds no TASKDATA.XML, no field of AgOpenGPS and no AgGPS boundary</source>
        <translation>esta pasta não contém TASKDATA.XML, nem talhão do AgOpenGPS, nem limite AgGPS</translation>
    </message>
    <message>
        <source>this format holds the path of a plan, and there is only a field</source>
        <translation>este formato contém o percurso de um plano, e há só um talhão</translation>
    </message>
    <message>
        <source>this is a bag of ROS 1</source>
        <translation>este é um bag do ROS 1</translation>
    </message>
    <message>
        <source>this is a folder</source>
        <translation>isto é uma pasta</translation>
    </message>
    <message>
        <source>this is no MCAP file of version 0</source>
        <translation>não é um arquivo MCAP da versão 0</translation>
    </message>
    <message>
        <source>this is no boundary file that can be read</source>
        <translation>não é um arquivo de limites que possa ser lido</translation>
    </message>
    <message>
        <source>this is no header of a time log</source>
        <translation>não é o cabeçalho de um registro de tempo</translation>
    </message>
    <message>
        <source>this is no ordinary file</source>
        <translation>não é um arquivo comum</translation>
    </message>
    <message>
        <source>this is no track that can be read</source>
        <translation>não é um percurso legível</translation>
    </message>
    <message>
        <source>this is no zip of fields or recordings</source>
        <translation>não é um zip de talhões ou gravações</translation>
    </message>
    <message>
        <source>this is not JSON from here on</source>
        <translation>daqui em diante não é JSON</translation>
    </message>
    <message>
        <source>this is not XML from here on</source>
        <translation>daqui em diante não é XML</translation>
    </message>
    <message>
        <source>this is not a project of Furrow</source>
        <translation>não é um projeto do Furrow</translation>
    </message>
    <message>
        <source>this is not well-known text from here on</source>
        <translation>daqui em diante não é well-known text</translation>
    </message>
    <message>
        <source>this place</source>
        <translation>este lugar</translation>
    </message>
    <message>
        <source>this polygon cannot be read</source>
        <translation>não é possível ler este polígono</translation>
    </message>
    <message>
        <source>this project file is damaged: %1</source>
        <translation>este arquivo de projeto está danificado: %1</translation>
    </message>
    <message>
        <source>this project is open in another window of Furrow</source>
        <translation>este projeto está aberto em outra janela do Furrow</translation>
    </message>
    <message>
        <source>this project was saved by a newer Furrow (format %1, this one knows %2)</source>
        <translation>este projeto foi salvo por um Furrow mais novo (formato %1, este conhece %2)</translation>
    </message>
    <message>
        <source>topic %1 was left out for %2</source>
        <translation>o tópico %1 ficou de fora em favor de %2</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true ou false</translation>
    </message>
    <message>
        <source>try another stick</source>
        <translation>tente outro pen drive</translation>
    </message>
    <message>
        <source>turn it into a rosbag2 with rosbags-convert</source>
        <translation>converta-o em um rosbag2 com rosbags-convert</translation>
    </message>
    <message>
        <source>two points</source>
        <translation>dois pontos</translation>
    </message>
    <message>
        <source>use another terminal&apos;s format, and report this</source>
        <translation>use o formato de outro terminal e relate isto</translation>
    </message>
    <message>
        <source>use one of: %1</source>
        <translation>use um de: %1</translation>
    </message>
    <message>
        <source>use one of: %1; or give a machine file (.json)</source>
        <translation>use uma de: %1; ou informe um arquivo de máquina (.json)</translation>
    </message>
    <message>
        <source>use one or more of: %1</source>
        <translation>use um ou mais de: %1</translation>
    </message>
    <message>
        <source>use the numbers from 1 to %1</source>
        <translation>use os números de 1 a %1</translation>
    </message>
    <message>
        <source>was it pulled out? Plug it in again and write once more</source>
        <translation>foi retirado? Conecte de novo e grave outra vez</translation>
    </message>
    <message>
        <source>what is on the stick is not the plan: %1</source>
        <translation>o que está no pen drive não é o plano: %1</translation>
    </message>
    <message>
        <source>whole numbers divided by commas</source>
        <translation>números inteiros separados por vírgulas</translation>
    </message>
    <message>
        <source>worked pixels need a value other than 0</source>
        <translation>pixels trabalhados precisam de valor diferente de 0</translation>
    </message>
    <message>
        <source>write POLYGON((lon lat, lon lat, ...))</source>
        <translation>escreva POLYGON((lon lat, lon lat, ...))</translation>
    </message>
    <message>
        <source>write POLYGON((lon lat, lon lat, ...)), one polygon a line</source>
        <translation>escreva POLYGON((lon lat, lon lat, ...)), um polígono por linha</translation>
    </message>
    <message>
        <source>write it like LINESTRING (4.1 52.0, 4.2 52.0)</source>
        <translation>escreva como LINESTRING (4.1 52.0, 4.2 52.0)</translation>
    </message>
    <message>
        <source>write the plan again with furrow-cli plan</source>
        <translation>grave o plano de novo com furrow-cli plan</translation>
    </message>
    <message>
        <source>write {&quot;name&quot;: ..., &quot;operating_width_m&quot;: ...}</source>
        <translation>escreva {&quot;name&quot;: ..., &quot;operating_width_m&quot;: ...}</translation>
    </message>
    <message>
        <source>a part of it cannot be read</source>
        <translation>uma parte não pode ser lida</translation>
    </message>
    <message>
        <source>a part of it is damaged: %1</source>
        <translation>uma parte está danificada: %1</translation>
    </message>
    <message>
        <source>a tile is damaged</source>
        <translation>um bloco está danificado</translation>
    </message>
    <message>
        <source>choose a file or a folder of tiles</source>
        <translation>escolha um arquivo ou uma pasta de blocos</translation>
    </message>
    <message>
        <source>choose the folder that holds the folders of the zooms, 0 to 24</source>
        <translation>escolha a pasta que contém as pastas dos níveis de zoom, de 0 a 24</translation>
    </message>
    <message>
        <source>copy or export the file again</source>
        <translation>copie ou exporte o arquivo de novo</translation>
    </message>
    <message>
        <source>give a GeoTIFF, MBTiles, or a folder of tiles</source>
        <translation>informe um GeoTIFF, MBTiles ou uma pasta de blocos</translation>
    </message>
    <message>
        <source>give a GeoTIFF, or export it again with its coordinate system</source>
        <translation>informe um GeoTIFF ou exporte-a de novo com seu sistema de coordenadas</translation>
    </message>
    <message>
        <source>it is damaged, or not a picture that Furrow can show</source>
        <translation>está danificado ou não é uma imagem que o Furrow possa mostrar</translation>
    </message>
    <message>
        <source>it is no file</source>
        <translation>não é um arquivo</translation>
    </message>
    <message>
        <source>it is too large to be shown without overviews</source>
        <translation>é grande demais para ser mostrada sem visões gerais</translation>
    </message>
    <message>
        <source>its tiles are in degrees, not in web Mercator</source>
        <translation>seus blocos estão em graus, não em Web Mercator</translation>
    </message>
    <message>
        <source>make the tiles again</source>
        <translation>crie os blocos de novo</translation>
    </message>
    <message>
        <source>make them again with the profile mercator, or give the raster itself</source>
        <translation>crie-os de novo com o perfil mercator ou informe o próprio raster</translation>
    </message>
    <message>
        <source>open it again</source>
        <translation>abra-o de novo</translation>
    </message>
    <message>
        <source>put it back, or choose another one</source>
        <translation>coloque-o de volta ou escolha outro</translation>
    </message>
    <message>
        <source>put it back, or remove the layer</source>
        <translation>coloque-o de volta ou remova a camada</translation>
    </message>
    <message>
        <source>save it in tiles and with overviews (gdal_translate -of COG)</source>
        <translation>salve-a em blocos e com visões gerais (gdal_translate -of COG)</translation>
    </message>
    <message>
        <source>the file cannot be read any more</source>
        <translation>o arquivo não pode mais ser lido</translation>
    </message>
    <message>
        <source>the file is not there any more</source>
        <translation>o arquivo não está mais lá</translation>
    </message>
    <message>
        <source>the file was changed while it was open</source>
        <translation>o arquivo foi alterado enquanto estava aberto</translation>
    </message>
    <message>
        <source>the folder is not there any more</source>
        <translation>a pasta não está mais lá</translation>
    </message>
    <message>
        <source>there are no tiles in this folder</source>
        <translation>não há blocos nesta pasta</translation>
    </message>
    <message>
        <source>there is no picture in it</source>
        <translation>não contém nenhuma imagem</translation>
    </message>
    <message>
        <source>there is no such file or folder</source>
        <translation>esse arquivo ou essa pasta não existe</translation>
    </message>
    <message>
        <source>Receivers may refuse %1: %2.</source>
        <translation>Os terminais podem recusar %1: %2.</translation>
    </message>
    <message>
        <source>some systems do not allow a file of this name</source>
        <translation>alguns sistemas não permitem um arquivo com este nome</translation>
    </message>
    <message>
        <source>another file differs from it in capitals only</source>
        <translation>outro arquivo só difere dele nas maiúsculas</translation>
    </message>
    <message>
        <source>%1 is far from the field</source>
        <translation>%1 fica longe do talhão</translation>
    </message>
    <message>
        <source>a ring of &apos;%1&apos; has fewer than three corners</source>
        <translation>um anel de “%1” tem menos de três cantos</translation>
    </message>
    <message>
        <source>a ring of &apos;%1&apos; does not end where it begins</source>
        <translation>um anel de “%1” não termina onde começa</translation>
    </message>
    <message>
        <source>a ring of &apos;%1&apos; ends with its first point again</source>
        <translation>um anel de “%1” repete no fim seu primeiro ponto</translation>
    </message>
    <message>
        <source>&apos;%1&apos; crosses itself, or a hole lies outside of it</source>
        <translation>“%1” cruza a si mesmo ou tem um vazio fora dele</translation>
    </message>
    <message>
        <source>a ring of &apos;%1&apos; runs the wrong way round</source>
        <translation>um anel de “%1” gira no sentido errado</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is said to have %2, and has %3</source>
        <translation>“%1” teria %2 e tem %3</translation>
    </message>
    <message>
        <source>the name &apos;%1&apos; is longer than %2 characters</source>
        <translation>o nome “%1” tem mais de %2 caracteres</translation>
    </message>
    <message>
        <source>the name &apos;%1&apos; is there twice</source>
        <translation>o nome “%1” aparece duas vezes</translation>
    </message>
    <message>
        <source>the name &apos;%1&apos; has letters beyond A to Z</source>
        <translation>o nome “%1” tem letras além de A a Z</translation>
    </message>
    <message>
        <source>the name &apos;%1&apos; has characters that are no letters</source>
        <translation>o nome “%1” tem caracteres que não são letras</translation>
    </message>
    <message>
        <source>the line &apos;%1&apos; has fewer than two points</source>
        <translation>a linha “%1” tem menos de dois pontos</translation>
    </message>
    <message>
        <source>A and B of &apos;%1&apos; are the same place</source>
        <translation>A e B de “%1” são o mesmo lugar</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is said to be %2 wide</source>
        <translation>“%1” teria %2 de largura</translation>
    </message>
    <message>
        <source>%1 comes where %2 should</source>
        <translation>%1 está onde deveria estar %2</translation>
    </message>
    <message>
        <source>%1 boundaries are in it, not %2</source>
        <translation>contém %1 limites, não %2</translation>
    </message>
    <message>
        <source>%1 holes are in it, not %2</source>
        <translation>contém %1 vazios, não %2</translation>
    </message>
    <message>
        <source>%1 guidance lines are in it, not %2</source>
        <translation>contém %1 linhas de orientação, não %2</translation>
    </message>
    <message>
        <source>%1 swaths are in it, not %2</source>
        <translation>contém %1 passadas, não %2</translation>
    </message>
    <message>
        <source>%1 fields are in it, not %2</source>
        <translation>contém %1 talhões, não %2</translation>
    </message>
    <message>
        <source>the path is not in it</source>
        <translation>não contém o percurso</translation>
    </message>
    <message>
        <source>place %1 of the path is not where the plan goes next</source>
        <translation>o ponto %1 do percurso não está onde o plano continua</translation>
    </message>
    <message>
        <source>the path does not begin and end as the plan does</source>
        <translation>o percurso não começa e termina como o plano</translation>
    </message>
    <message>
        <source>the path is %1 long, not %2</source>
        <translation>o percurso mede %1, não %2</translation>
    </message>
    <message>
        <source>the time of place %1 of the path is before that of the place before</source>
        <translation>a hora do ponto %1 do percurso é anterior à do ponto antes dele</translation>
    </message>
    <message>
        <source>the times of the path stand still</source>
        <translation>as horas do percurso não avançam</translation>
    </message>
    <message>
        <source>the heading at place %1 of the path does not point along it</source>
        <translation>o rumo no ponto %1 do percurso não aponta ao longo dele</translation>
    </message>
    <message>
        <source>the speed at place %1 of the path is negative</source>
        <translation>a velocidade no ponto %1 do percurso é negativa</translation>
    </message>
    <message>
        <source>its largest speed is %1, not %2</source>
        <translation>sua maior velocidade é %1, não %2</translation>
    </message>
    <message>
        <source>line %1 is not as this format has it</source>
        <translation>a linha %1 não está conforme este formato</translation>
    </message>
    <message>
        <source>this is no %1</source>
        <translation>isto não é %1</translation>
    </message>
    <message>
        <source>its content cannot be read</source>
        <translation>não é possível ler seu conteúdo</translation>
    </message>
    <message>
        <source>%1 is missing</source>
        <translation>falta %1</translation>
    </message>
    <message>
        <source>%1 entries are announced, and %2 are there</source>
        <translation>são anunciadas %1 entradas e há %2</translation>
    </message>
    <message>
        <source>the id %1 is there twice</source>
        <translation>o identificador %1 aparece duas vezes</translation>
    </message>
    <message>
        <source>%1 is referred to and not there</source>
        <translation>há referência a %1, que não está lá</translation>
    </message>
    <message>
        <source>%1 is not known before version 4</source>
        <translation>%1 não é conhecido antes da versão 4</translation>
    </message>
    <message>
        <source>&apos;%1&apos; holds a line of kind %2</source>
        <translation>“%1” contém uma linha de tipo %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is of kind %2 and its points are of kinds %3</source>
        <translation>“%1” é de tipo %2 e seus pontos são dos tipos %3</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has %2 lines</source>
        <translation>“%1” tem %2 linhas</translation>
    </message>
    <message>
        <source>the headings of a ring do not point along it</source>
        <translation>os rumos de um anel não apontam ao longo dele</translation>
    </message>
    <message>
        <source>its shapes have heights or measures, which displays do not read</source>
        <translation>suas formas têm alturas ou medidas, que os monitores não leem</translation>
    </message>
    <message>
        <source>this is the recording of a drive (%1), and no boundary</source>
        <translation>isto é a gravação de um percurso (%1), e não um limite</translation>
    </message>
    <message>
        <source>give the field&apos;s boundary; furrow-cli compare lays a recording over a plan</source>
        <translation>informe o limite do talhão; furrow-cli compare sobrepõe uma gravação a um plano</translation>
    </message>
    <message>
        <source>Raster mask</source>
        <translation>Máscara raster</translation>
    </message>
    <message>
        <source>What is worked and what is not, as a field.</source>
        <translation>O que é trabalhado e o que não é, como talhão.</translation>
    </message>
    <message>
        <source>NMEA or gpsd log</source>
        <translation>Registro NMEA ou gpsd</translation>
    </message>
    <message>
        <source>What a machine drove.</source>
        <translation>O que uma máquina percorreu.</translation>
    </message>
    <message>
        <source>split line %1 ends %2 short of the headland and cuts nothing off there (decomposition.split); draw it right through</source>
        <translation>a linha de divisão %1 termina %2 antes da cabeceira e não separa nada ali (decomposition.split); trace-a de lado a lado</translation>
    </message>
    <message>
        <source>split line %1 does not lie inside the headland and cuts nothing (decomposition.split)</source>
        <translation>a linha de divisão %1 fica fora do interior e não divide nada (decomposition.split)</translation>
    </message>
    <message numerus="yes">
        <source>%n swaths shorter than %1 are left out</source>
        <translation>
            <numerusform>%n passada com menos de %1 é omitida</numerusform>
            <numerusform>%n passadas com menos de %1 são omitidas</numerusform>
        </translation>
    </message>
    <message>
        <source>along the longest edge</source>
        <translation>ao longo do lado mais longo</translation>
    </message>
    <message>
        <source>along an edge</source>
        <translation>ao longo de um lado</translation>
    </message>
    <message>
        <source>swaths run %1</source>
        <translation>as passadas vão %1</translation>
    </message>
    <message>
        <source>swaths run %1; about %2 slower than with the best heading</source>
        <translation>as passadas vão %1; cerca de %2 a mais que com a melhor direção</translation>
    </message>
    <message>
        <source>swaths run %1; as quick as with the best heading</source>
        <translation>as passadas vão %1; tão rápido quanto com a melhor direção</translation>
    </message>
    <message>
        <source>swaths run %1; %2 more than with the best heading</source>
        <translation>as passadas vão %1; %2 a mais que com a melhor direção</translation>
    </message>
    <message>
        <source>swaths run %1; as short as with the best heading</source>
        <translation>as passadas vão %1; tão curto quanto com a melhor direção</translation>
    </message>
    <message>
        <source>Shortest swath</source>
        <translation>Passada mais curta</translation>
    </message>
    <message>
        <source>Swaths that are shorter are left out; auto is the implement&apos;s length.</source>
        <translation>Passadas mais curtas são omitidas; auto é o comprimento do implemento.</translation>
    </message>
    <message>
        <source>Prefer edges within (%)</source>
        <translation>Preferir lados até (%)</translation>
    </message>
    <message>
        <source>Swaths run along the field&apos;s longest edge, or another long one, where that takes no more than this above the best heading; 0 takes the best whatever its direction.</source>
        <translation>As passadas seguem o lado mais longo do talhão, ou outro lado longo, enquanto isso não custar mais do que este valor acima da melhor direção; 0 usa a melhor, seja qual for.</translation>
    </message>
    <message>
        <source>%1 are out of this machine&apos;s reach; the largest piece, %2, lies here.</source>
        <translation>%1 estão fora do alcance desta máquina; o maior pedaço, %2, fica aqui.</translation>
    </message>
    <message>
        <source>The implement stands over the edge of the field or an obstacle, by up to %1, as the overhang allows.</source>
        <translation>O implemento fica sobre a borda do talhão ou um obstáculo, em até %1, como o balanço permite.</translation>
    </message>
    <message>
        <source>%1 within %2 of the centre: tighter than this machine can follow, left out</source>
        <translation>%1 a menos de %2 do centro: mais fechados do que esta máquina consegue seguir, omitidos</translation>
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
        <translation>Em uma cabeceira de %1 cabem %2; ela tem %3 de largura e o resto é das passadas</translation>
    </message>
    <message>
        <source>Plan the sides of the obstacle apart.</source>
        <translation>Planeje os lados do obstáculo separadamente.</translation>
    </message>
    <message>
        <source>Set &quot;%1&quot; to &quot;%2&quot;: with that this is gone.</source>
        <translation>Defina “%1” como “%2”: com isso fica resolvido.</translation>
    </message>
    <message>
        <source>Swaths along the longest edge</source>
        <translation>Passadas ao longo do lado mais longo</translation>
    </message>
    <message>
        <source>Swaths at a bearing of %1</source>
        <translation>Passadas no rumo %1</translation>
    </message>
    <message>
        <source>Take a machine that can.</source>
        <translation>Use uma máquina que consiga.</translation>
    </message>
    <message>
        <source>The field is too narrow for this machine to turn in: take a smaller machine.</source>
        <translation>O talhão é estreito demais para manobrar esta máquina: use uma menor.</translation>
    </message>
    <message>
        <source>The quickest</source>
        <translation>A mais rápida</translation>
    </message>
    <message>
        <source>give one of the two, or a width that holds just these passes</source>
        <translation>informe um dos dois, ou uma largura em que caibam exatamente essas passadas</translation>
    </message>
    <message>
        <source>headland.width_m and headland.passes do not agree</source>
        <translation>headland.width_m e headland.passes não combinam</translation>
    </message>
    <message>
        <source>off</source>
        <translation>desativado</translation>
    </message>
    <message>
        <source>on</source>
        <translation>ativado</translation>
    </message>
    <message>
        <source>&quot;%1&quot;: &quot;%2&quot; is planned instead of &quot;%3&quot;: %4</source>
        <translation>“%1”: planeja-se “%2” em vez de “%3”: %4</translation>
    </message>
    <message>
        <source>%1 are planned instead of the heading with the best estimate: %2</source>
        <translation>%1 são planejadas em vez da direção com a melhor estimativa: %2</translation>
    </message>
    <message>
        <source>it has fewer problems</source>
        <translation>há menos problemas</translation>
    </message>
    <message>
        <source>it is %1 quicker</source>
        <translation>é %1 mais rápido</translation>
    </message>
    <message>
        <source>the margin and the obstacles that may be driven on leave nothing to work</source>
        <translation>a margem e os obstáculos transitáveis não deixam nada para trabalhar</translation>
    </message>
    <message>
        <source>make them smaller, or delete some of them</source>
        <translation>diminua-os ou exclua alguns</translation>
    </message>
    <message>
        <source>Without a headland (%1) there is no room to turn.</source>
        <translation>Sem cabeceira (%1) não há espaço para manobrar.</translation>
    </message>
    <message>
        <source>A turn of this machine needs %1 of headland; it is %2 (%3).</source>
        <translation>Uma manobra desta máquina precisa de %1 de cabeceira; ela tem %2 (%3).</translation>
    </message>
    <message>
        <source>The field is too narrow for this machine to turn in: take a smaller machine, or let the swaths run along the field (%1).</source>
        <translation>O talhão é estreito demais para manobrar esta máquina: use uma menor, ou faça as passadas ao longo do talhão (%1).</translation>
    </message>
    <message>
        <source>The field is too narrow for this machine to turn in: take a smaller machine or a smaller margin (%1).</source>
        <translation>O talhão é estreito demais para manobrar esta máquina: use uma menor ou uma margem menor (%1).</translation>
    </message>
    <message>
        <source>No passes are driven in the headland (%1).</source>
        <translation>Nenhuma passada é feita na cabeceira (%1).</translation>
    </message>
    <message>
        <source>The chosen swaths (%1) do not reach it.</source>
        <translation>As passadas escolhidas (%1) não chegam até lá.</translation>
    </message>
    <message>
        <source>Land that is left is not finished if the machine may leave the field (%1).</source>
        <translation>Onde a máquina pode sair do talhão (%1), o que sobra não é terminado.</translation>
    </message>
    <message>
        <source>Land that is left is not finished, because that is switched off (%1).</source>
        <translation>O que sobra não é terminado, porque isso está desativado (%1).</translation>
    </message>
    <message>
        <source>choose a smaller machine or a smaller margin (%1)</source>
        <translation>escolha uma máquina menor ou uma margem menor (%1)</translation>
    </message>
    <message>
        <source>no row is left inside the headland</source>
        <translation>não sobra nenhuma fileira no interior do talhão</translation>
    </message>
    <message>
        <source>skip fewer rows</source>
        <translation>pule menos fileiras</translation>
    </message>
    <message>
        <source>no row lies inside the headland</source>
        <translation>não há nenhuma fileira no interior do talhão</translation>
    </message>
    <message>
        <source>check that the rows belong to this field, or choose a narrower headland</source>
        <translation>verifique se as fileiras pertencem a este talhão, ou escolha uma cabeceira mais estreita</translation>
    </message>
    <message>
        <source>Quickest</source>
        <translation>Mais rápido</translation>
    </message>
    <message>
        <source>The kind below with which the whole plan takes the least time.</source>
        <translation>O tipo com o qual o plano inteiro leva menos tempo.</translation>
    </message>
    <message>
        <source>A headland of %1 is planned instead of one that is wide enough for turns: %2</source>
        <translation>É planejada uma cabeceira de %1 em vez de uma larga o bastante para as manobras: %2</translation>
    </message>
    <message>
        <source>Drive more slowly there, or plan again.</source>
        <translation>Dirija mais devagar ali ou planeje de novo.</translation>
    </message>
    <message>
        <source>The steering is too slow for the planned speed in %1; %2 is the worst and would need %3.</source>
        <translation>A direção é lenta demais para a velocidade planejada em %1; o pior é %2, que precisaria de %3.</translation>
    </message>
    <message>
        <source>The implement is folded on the way from %1 to %2.</source>
        <translation>O implemento vai dobrado neste deslocamento: %1 → %2.</translation>
    </message>
    <message>
        <source>The machine has to stand for %1 s to fold its implement or to unfold it, and does not in %2.</source>
        <translation>A máquina precisa ficar parada %1 s para dobrar ou desdobrar o implemento; em %2 não fica.</translation>
    </message>
    <message>
        <source>Time to fold</source>
        <translation>Tempo para dobrar</translation>
    </message>
    <message>
        <source>To fold to the transport width, standing; the same again to unfold.</source>
        <translation>Para dobrar até a largura de transporte, parado; o mesmo tempo para desdobrar.</translation>
    </message>
    <message>
        <source>Fuel</source>
        <translation>Combustível</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Comprimento</translation>
    </message>
    <message>
        <source>Saves</source>
        <translation>Economiza</translation>
    </message>
    <message>
        <source>The least fuel for turns and ways; the least time if the machine has no fuel figures.</source>
        <translation>O menor consumo de combustível para manobras e deslocamentos; o menor tempo se a máquina não tiver dados de consumo.</translation>
    </message>
    <message>
        <source>The least time for turns and ways.</source>
        <translation>O menor tempo para manobras e deslocamentos.</translation>
    </message>
    <message>
        <source>The shortest turns and ways.</source>
        <translation>As manobras e os deslocamentos mais curtos.</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>What the order of the swaths is to save.</source>
        <translation>O que a ordem das passadas deve economizar.</translation>
    </message>
    <message>
        <source>Every pattern is tried and improved; the plan tells how near the order is to the best one.</source>
        <translation>Todos os padrões são experimentados e melhorados; o plano diz quão perto a ordem está da melhor.</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>Fixas</translation>
    </message>
    <message>
        <source>Swath numbers that follow each other in this order; a minus drives one the other way. The order of the others is searched.</source>
        <translation>Números de passadas que se seguem nesta ordem; um menos inverte o sentido. A ordem das outras é buscada.</translation>
    </message>
    <message>
        <source>Ends of swaths</source>
        <translation>Pontas das passadas</translation>
    </message>
    <message>
        <source>Heading of blocks</source>
        <translation>Direção dos subtalhões</translation>
    </message>
    <message>
        <source>Heading: bearing %1</source>
        <translation>Direção: %1</translation>
    </message>
    <message>
        <source>Headland passes</source>
        <translation>Passadas de cabeceira</translation>
    </message>
    <message>
        <source>Order of swaths</source>
        <translation>Ordem das passadas</translation>
    </message>
    <message>
        <source>Small obstacles</source>
        <translation>Obstáculos pequenos</translation>
    </message>
    <message>
        <source>First swath</source>
        <translation>Primeira passada</translation>
    </message>
    <message>
        <source>Last swath</source>
        <translation>Última passada</translation>
    </message>
    <message>
        <source>Most strips that are left between driven swaths for later. With 0 the machine never comes back to a gap, so that a second one can follow; auto sets no limit.</source>
        <translation>Máximo de faixas que ficam para depois entre passadas feitas. Com 0 a máquina nunca volta a uma lacuna, e outra pode segui-la; “auto” não põe limite.</translation>
    </message>
    <message>
        <source>Open strips</source>
        <translation>Faixas abertas</translation>
    </message>
    <message>
        <source>The number of the swath that is driven first; auto takes any.</source>
        <translation>O número da passada feita primeiro; com “auto”, qualquer uma.</translation>
    </message>
    <message>
        <source>The number of the swath that is driven last; auto takes any.</source>
        <translation>O número da passada feita por último; com “auto”, qualquer uma.</translation>
    </message>
    <message>
        <source>allow more open strips, or lock fewer swaths</source>
        <translation>permita mais faixas abertas, ou fixe menos passadas</translation>
    </message>
    <message>
        <source>name another swath for the end</source>
        <translation>indique outra passada para o fim</translation>
    </message>
    <message>
        <source>no order was found that keeps to all that is said of the order of swaths</source>
        <translation>não foi encontrada nenhuma ordem que respeite tudo o que foi definido para a ordem das passadas</translation>
    </message>
    <message>
        <source>swath %1 is driven first</source>
        <translation>a passada %1 é feita primeiro</translation>
    </message>
    <message>
        <source>%1 are driven outside of the field</source>
        <translation>%1 são percorridos fora do talhão</translation>
    </message>
    <message>
        <source>%1 costs %2 more than the longest edge (%3)</source>
        <translation>%1 custa %2 a mais que o lado mais longo (%3)</translation>
    </message>
    <message>
        <source>%1 h %2 min</source>
        <translation>%1 h %2 min</translation>
    </message>
    <message>
        <source>%1 is as quick as the longest edge (%2)</source>
        <translation>%1 é tão rápido quanto o lado mais longo (%2)</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>%1 of a work order is no amount</source>
        <translation>%1 de uma ordem de serviço não é uma quantidade</translation>
    </message>
    <message>
        <source>%1 of a work order is no text</source>
        <translation>%1 de uma ordem de serviço não é um texto</translation>
    </message>
    <message>
        <source>%1 runs along the longest edge</source>
        <translation>%1 segue o lado mais longo</translation>
    </message>
    <message>
        <source>%1 saves %2 against the longest edge (%3)</source>
        <translation>%1 economiza %2 em relação ao lado mais longo (%3)</translation>
    </message>
    <message>
        <source>%1 × %2, %3 each</source>
        <translation>%1 × %2, %3 cada</translation>
    </message>
    <message>
        <source>%1: a turn of this machine, with a radius of %2, needs %3.</source>
        <translation>%1: uma manobra desta máquina, com raio de %2, precisa de %3.</translation>
    </message>
    <message>
        <source>%1: a turn to the next swath would need %2, so turns are made in other ways.</source>
        <translation>%1: uma manobra para a passada seguinte precisaria de %2, por isso manobra-se de outra forma.</translation>
    </message>
    <message>
        <source>%1: its work order is not used: %2</source>
        <translation>%1: a ordem de serviço não é usada: %2</translation>
    </message>
    <message>
        <source>%1: the field is too narrow for the %2 that a turn of this machine needs.</source>
        <translation>%1: o talhão é estreito demais para os %2 de que uma manobra desta máquina precisa.</translation>
    </message>
    <message>
        <source>%1; the machine keeps %2 from its edge at least.</source>
        <translation>%1; a máquina mantém pelo menos %2 da borda.</translation>
    </message>
    <message numerus="yes">
        <source>%n blocks</source>
        <translation>
            <numerusform>%n subtalhão</numerusform>
            <numerusform>%n subtalhões</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n passes of %1</source>
        <translation>
            <numerusform>%n passada de %1</numerusform>
            <numerusform>%n passadas de %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n swaths</source>
        <translation>
            <numerusform>%n passada</numerusform>
            <numerusform>%n passadas</numerusform>
        </translation>
    </message>
    <message>
        <source>Cut into %1 pieces where swaths are interrupted, joined to %2.</source>
        <translation>Cortado em %1 partes onde as passadas são interrompidas, juntas em %2.</translation>
    </message>
    <message>
        <source>Cut into %1 pieces where swaths are interrupted; joining them to %2 saves %3 of turns and ways.</source>
        <translation>Cortado em %1 partes onde as passadas são interrompidas; juntá-las em %2 economiza %3 de manobras e deslocamentos.</translation>
    </message>
    <message>
        <source>Edges that swaths run along get %1, edges that they end at up to %2: a turn of this machine needs %3.</source>
        <translation>Lados ao longo das passadas recebem %1, lados onde elas terminam até %2: uma manobra desta máquina precisa de %3.</translation>
    </message>
    <message>
        <source>Everything keeps %1 from the boundary, as chosen.</source>
        <translation>Tudo fica a %1 do limite, como escolhido.</translation>
    </message>
    <message>
        <source>Everything keeps %1 from the boundary: no more is known of where it runs.</source>
        <translation>Tudo fica a %1 do limite: não se sabe com mais exatidão onde ele passa.</translation>
    </message>
    <message numerus="yes">
        <source>No heading has fewer than %n swaths.</source>
        <translation>
            <numerusform>Nenhuma direção tem menos de %n passada.</numerusform>
            <numerusform>Nenhuma direção tem menos de %n passadas.</numerusform>
        </translation>
    </message>
    <message>
        <source>No heading that was tried covers more: %1 inside the headland.</source>
        <translation>Nenhuma direção testada trabalha mais área: %1 dentro da cabeceira.</translation>
    </message>
    <message numerus="yes">
        <source>No heading that was tried has fewer than %n swaths.</source>
        <translation>
            <numerusform>Nenhuma direção testada tem menos de %n passada.</numerusform>
            <numerusform>Nenhuma direção testada tem menos de %n passadas.</numerusform>
        </translation>
    </message>
    <message>
        <source>No heading that was tried has shorter swaths: %1.</source>
        <translation>Nenhuma direção testada tem passadas mais curtas: %1.</translation>
    </message>
    <message>
        <source>No heading that was tried works less land twice: %1.</source>
        <translation>Nenhuma direção testada trabalha menos área duas vezes: %1.</translation>
    </message>
    <message>
        <source>No order of these swaths can save more than %1 of the turns, or %2 of all.</source>
        <translation>Nenhuma ordem destas passadas pode economizar mais de %1 das manobras, ou %2 de tudo.</translation>
    </message>
    <message>
        <source>No order of these swaths is better; that is proved.</source>
        <translation>Nenhuma ordem destas passadas é melhor; isso está provado.</translation>
    </message>
    <message>
        <source>Nothing divides the swaths: one block.</source>
        <translation>Nada divide as passadas: um só subtalhão.</translation>
    </message>
    <message>
        <source>Nothing stands outside of the field</source>
        <translation>Nada fica fora do talhão</translation>
    </message>
    <message>
        <source>One pass all round works the whole field.</source>
        <translation>Uma só passada em volta trabalha o talhão todo.</translation>
    </message>
    <message numerus="yes">
        <source>Swaths are interrupted by corners or obstacles: %n blocks.</source>
        <translation>
            <numerusform>Cantos ou obstáculos interrompem as passadas: %n subtalhão.</numerusform>
            <numerusform>Cantos ou obstáculos interrompem as passadas: %n subtalhões.</numerusform>
        </translation>
    </message>
    <message>
        <source>The longest way without work, %1, follows %2.</source>
        <translation>O deslocamento mais longo sem trabalho, %1, vem depois de %2.</translation>
    </message>
    <message>
        <source>There is no headland, as chosen. Turns reach %1 beyond the ends of swaths.</source>
        <translation>Sem cabeceira, como escolhido. As manobras vão %1 além das pontas das passadas.</translation>
    </message>
    <message>
        <source>Turns take %1 less than with the pattern “%2” (%3).</source>
        <translation>As manobras custam %1 a menos que com o padrão “%2” (%3).</translation>
    </message>
    <message>
        <source>Turns take %1 more than with the pattern “%2” (%3).</source>
        <translation>As manobras custam %1 a mais que com o padrão “%2” (%3).</translation>
    </message>
    <message>
        <source>Turns take about as much as with the pattern “%1”.</source>
        <translation>As manobras custam mais ou menos o mesmo que com o padrão “%1”.</translation>
    </message>
    <message>
        <source>a member that every plan has is missing or of another kind</source>
        <translation>falta um dado que todo plano tem, ou é de outro tipo</translation>
    </message>
    <message>
        <source>a work order is a JSON object, and this is none</source>
        <translation>uma ordem de serviço é um objeto JSON, e isto não é</translation>
    </message>
    <message>
        <source>bulb turn</source>
        <translation>manobra em ômega</translation>
    </message>
    <message>
        <source>by this estimate %1 would save %2</source>
        <translation>por esta estimativa, %1 economizaria %2</translation>
    </message>
    <message>
        <source>fishtail turn</source>
        <translation>manobra rabo de peixe</translation>
    </message>
    <message>
        <source>give a number that is not negative, or leave it out</source>
        <translation>informe um número não negativo ou deixe de fora</translation>
    </message>
    <message>
        <source>it is draft, issued, in_progress or done</source>
        <translation>é draft, issued, in_progress ou done</translation>
    </message>
    <message>
        <source>no heading is much quicker</source>
        <translation>nenhuma direção é muito mais rápida</translation>
    </message>
    <message>
        <source>no heading is quicker</source>
        <translation>nenhuma direção é mais rápida</translation>
    </message>
    <message>
        <source>no plan of this project was sent for this review</source>
        <translation>nenhum plano deste projeto foi enviado para esta revisão</translation>
    </message>
    <message>
        <source>open the project that the plan was sent from, or open the file by itself</source>
        <translation>abra o projeto de onde o plano foi enviado, ou o arquivo sozinho</translation>
    </message>
    <message>
        <source>put it in quotation marks</source>
        <translation>coloque entre aspas</translation>
    </message>
    <message>
        <source>see the README for the members of a work order</source>
        <translation>veja no README os dados de uma ordem de serviço</translation>
    </message>
    <message>
        <source>there is no such status of a work order</source>
        <translation>não existe essa situação de ordem de serviço</translation>
    </message>
    <message>
        <source>there is no way to drive</source>
        <translation>não há caminho possível</translation>
    </message>
    <message>
        <source>turn on the spot</source>
        <translation>manobra no lugar</translation>
    </message>
    <message>
        <source>turn with reversing</source>
        <translation>manobra com ré</translation>
    </message>
    <message>
        <source>way straight on</source>
        <translation>deslocamento reto</translation>
    </message>
    <message>
        <source>%1 are driven over the field with the implement up; longest: %2.</source>
        <translation>%1 são percorridos sobre o talhão com o implemento levantado; o mais longo: %2.</translation>
    </message>
    <message>
        <source>%1 for each swath gives %2 swaths, and no plan may have more than %3</source>
        <translation>%1 por passada dão %2 passadas, e nenhum plano pode ter mais de %3</translation>
    </message>
    <message>
        <source>%1 is beyond what machines have</source>
        <translation>%1 está fora do que as máquinas têm</translation>
    </message>
    <message>
        <source>&apos;%1&apos; in it is a view</source>
        <translation>“%1” nele é uma visão</translation>
    </message>
    <message>
        <source>a text with fields may take %1 MiB, and this one takes more</source>
        <translation>um texto com talhões pode ocupar %1 MiB, e este ocupa mais</translation>
    </message>
    <message>
        <source>a value in it is not of the kind that belongs there</source>
        <translation>um valor não é do tipo que pertence ali</translation>
    </message>
    <message>
        <source>correct one of them, or give min_turning_radius_m</source>
        <translation>corrija um deles ou informe min_turning_radius_m</translation>
    </message>
    <message>
        <source>cut it into parts, or export it as a GeoPackage</source>
        <translation>divida-o em partes ou exporte-o como GeoPackage</translation>
    </message>
    <message>
        <source>did you mean %1?</source>
        <translation>você quis dizer %1?</translation>
    </message>
    <message>
        <source>export it as a table, or remove it</source>
        <translation>exporte-a como tabela ou remova-a</translation>
    </message>
    <message>
        <source>it would grow more than three hundredfold when it is unpacked</source>
        <translation>cresceria mais de trezentas vezes ao ser descompactado</translation>
    </message>
    <message>
        <source>it would take more than 2 GiB when it is unpacked</source>
        <translation>descompactado ocuparia mais de 2 GiB</translation>
    </message>
    <message>
        <source>lists and objects lie too deep in one another here</source>
        <translation>aqui há listas e objetos aninhados fundo demais</translation>
    </message>
    <message>
        <source>remove what does not belong there</source>
        <translation>remova o que não pertence ali</translation>
    </message>
    <message>
        <source>the file is far too large for what it should hold</source>
        <translation>o arquivo é grande demais para o que deveria conter</translation>
    </message>
    <message>
        <source>unpack it and give one of its files</source>
        <translation>descompacte-o e informe um dos arquivos</translation>
    </message>
    <message>
        <source>with this wheelbase, %1 give a turning radius of %2</source>
        <translation>com esta distância entre eixos, %1 dão um raio de giro de %2</translation>
    </message>
    <message>
        <source>%1 is no number (%2), and nothing is written</source>
        <translation>%1 não é um número (%2), e nada é gravado</translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: %2 (%3); the plan is made with %4 until then</source>
        <translation>%1: %2 (%3); até lá o plano é feito com %4</translation>
    </message>
    <message>
        <source>a place</source>
        <translation>um lugar</translation>
    </message>
    <message>
        <source>a place of a guidance line</source>
        <translation>um lugar de uma linha de orientação</translation>
    </message>
    <message>
        <source>a place of an obstacle</source>
        <translation>um lugar de um obstáculo</translation>
    </message>
    <message>
        <source>a place of swath %1</source>
        <translation>um lugar da passada %1</translation>
    </message>
    <message>
        <source>a place of the boundary</source>
        <translation>um lugar do limite</translation>
    </message>
    <message>
        <source>a place of the mainland</source>
        <translation>um lugar do interior</translation>
    </message>
    <message>
        <source>give one beside it, in WGS84, longitude first</source>
        <translation>informe uma ao lado dele, em WGS84, longitude primeiro</translation>
    </message>
    <message>
        <source>plan parts of the field by themselves, choose another heading, or take small obstacles out of the boundary</source>
        <translation>planeje partes do talhão separadamente, escolha outra direção ou tire obstáculos pequenos do limite</translation>
    </message>
    <message>
        <source>the area of the field</source>
        <translation>a área do talhão</translation>
    </message>
    <message>
        <source>the bearing of a guidance line</source>
        <translation>o rumo de uma linha de orientação</translation>
    </message>
    <message>
        <source>the buffer of an obstacle</source>
        <translation>a margem de um obstáculo</translation>
    </message>
    <message>
        <source>the coverage of the swaths</source>
        <translation>a parte que as passadas trabalham</translation>
    </message>
    <message>
        <source>the curvature</source>
        <translation>a curvatura</translation>
    </message>
    <message>
        <source>the curve is %1 km away from the field</source>
        <translation>a curva está a %1 km do talhão</translation>
    </message>
    <message>
        <source>the heading</source>
        <translation>a direção</translation>
    </message>
    <message>
        <source>the outline cuts the tracks into %1 swaths, and no plan may have more than %2</source>
        <translation>o contorno corta as faixas em %1 passadas, e nenhum plano pode ter mais de %2</translation>
    </message>
    <message>
        <source>the overhang of an obstacle</source>
        <translation>o balanço de um obstáculo</translation>
    </message>
    <message>
        <source>the overlap of the swaths</source>
        <translation>a sobreposição das passadas</translation>
    </message>
    <message>
        <source>the place of a finding</source>
        <translation>o lugar de um aviso</translation>
    </message>
    <message>
        <source>the place of a gate</source>
        <translation>o lugar de uma entrada</translation>
    </message>
    <message>
        <source>the radius of a guidance line</source>
        <translation>o raio de uma linha de orientação</translation>
    </message>
    <message>
        <source>the share of the mainland</source>
        <translation>a parte do interior</translation>
    </message>
    <message>
        <source>the speed</source>
        <translation>a velocidade</translation>
    </message>
    <message>
        <source>the time</source>
        <translation>o tempo</translation>
    </message>
    <message>
        <source>the way driven</source>
        <translation>o percurso</translation>
    </message>
    <message>
        <source>the width of a gate</source>
        <translation>a largura de uma entrada</translation>
    </message>
    <message>
        <source>the width of a guidance line</source>
        <translation>a largura de uma linha de orientação</translation>
    </message>
    <message>
        <source>the width of the headland</source>
        <translation>a largura da cabeceira</translation>
    </message>
    <message>
        <source>this is a mistake of Furrow, please report it with the field, the machine and the settings</source>
        <translation>é um erro do Furrow; comunique-o com o talhão, a máquina e as configurações</translation>
    </message>
    <message>
        <source>%1 %2 is no place in WGS84</source>
        <translation>%1 %2 não é um lugar em WGS84</translation>
    </message>
    <message>
        <source>%1 gathers %2; the bunker holds %3.</source>
        <translation>%1 colhe %2; no tanque graneleiro cabem %3.</translation>
    </message>
    <message>
        <source>%1 of standing</source>
        <translation>%1 de parada</translation>
    </message>
    <message>
        <source>%1 takes %2; the tank holds %3.</source>
        <translation>%1 consome %2; no tanque cabem %3.</translation>
    </message>
    <message numerus="yes">
        <source>%n passes are too long for it.</source>
        <translation>
            <numerusform>%n passada é longa demais.</numerusform>
            <numerusform>%n passadas são longas demais.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n refills, with %1 of way to them and back and %2.</source>
        <translation>
            <numerusform>Um reabastecimento, com %1 de caminho de ida e volta e %2.</numerusform>
            <numerusform>%n reabastecimentos, com %1 de caminho de ida e volta e %2.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n unloadings, with %1 of way to them and back and %2.</source>
        <translation>
            <numerusform>Uma descarga, com %1 de caminho de ida e volta e %2.</numerusform>
            <numerusform>%n descargas, com %1 de caminho de ida e volta e %2.</numerusform>
        </translation>
    </message>
    <message>
        <source>Choose another refill point.</source>
        <translation>Escolha outro ponto de reabastecimento.</translation>
    </message>
    <message>
        <source>Give more refill points, or ones that are nearer.</source>
        <translation>Indique mais pontos de reabastecimento, ou mais próximos.</translation>
    </message>
    <message>
        <source>Let ways cross the mainland (route.traversal), so that swaths may be interrupted, or lay the swaths the short way.</source>
        <translation>Permita caminhos pelo interior (route.traversal), para que as passadas possam ser interrompidas, ou trace as passadas no sentido curto.</translation>
    </message>
    <message>
        <source>No trip to a refill point is needed: %1 of the %2 that the bunker holds are gathered.</source>
        <translation>Nenhuma ida a um ponto de descarga é necessária: colhem-se %1 dos %2 que cabem no tanque graneleiro.</translation>
    </message>
    <message>
        <source>No trip to a refill point is needed: %1 of the %2 that the tank holds are used.</source>
        <translation>Nenhuma ida a um ponto de reabastecimento é necessária: usam-se %1 dos %2 que cabem no tanque.</translation>
    </message>
    <message>
        <source>No way to a refill point leads from the work before %1.</source>
        <translation>Nenhum caminho leva a um ponto de reabastecimento a partir do trabalho antes de %1.</translation>
    </message>
    <message>
        <source>POINT (%1 %2) lies outside of the field</source>
        <translation>POINT (%1 %2) está fora do talhão</translation>
    </message>
    <message>
        <source>Plan again; the levels were changed.</source>
        <translation>Planeje de novo; os níveis foram alterados.</translation>
    </message>
    <message>
        <source>Refill points</source>
        <translation>Pontos de reabastecimento</translation>
    </message>
    <message>
        <source>That the machine stands each time its tank is filled or its bunker emptied; 300 s where it is not given.</source>
        <translation>Quanto a máquina fica parada a cada vez que o tanque é abastecido ou o graneleiro esvaziado; 300 s se não for informado.</translation>
    </message>
    <message>
        <source>The bunker is full in %1: %2 are worked beyond that.</source>
        <translation>O tanque graneleiro está cheio (%1): %2 são trabalhados além disso.</translation>
    </message>
    <message>
        <source>The level changes %1 away from the refill points.</source>
        <translation>O nível muda a %1 dos pontos de reabastecimento.</translation>
    </message>
    <message>
        <source>The machine has no room at this refill point.</source>
        <translation>A máquina não tem espaço neste ponto de reabastecimento.</translation>
    </message>
    <message>
        <source>The machine has to stand for %1 s at a refill point, and does not in %2.</source>
        <translation>A máquina tem de ficar parada %1 s em um ponto de reabastecimento e não fica: %2.</translation>
    </message>
    <message>
        <source>The refill points are not used: this machine has no tank.</source>
        <translation>Os pontos de reabastecimento não são usados: esta máquina não tem tanque.</translation>
    </message>
    <message>
        <source>The refill points are not used: this machine&apos;s tank has no rate.</source>
        <translation>Os pontos de reabastecimento não são usados: o tanque desta máquina não tem dose.</translation>
    </message>
    <message>
        <source>The refill points are not used: this operation uses no tank.</source>
        <translation>Os pontos de reabastecimento não são usados: esta operação não usa tanque.</translation>
    </message>
    <message>
        <source>The stated level differs from the work that is done, by up to %1 of the tank.</source>
        <translation>O nível informado difere do trabalho feito, em até %1 do tanque.</translation>
    </message>
    <message>
        <source>The tank is empty in %1: %2 are worked beyond that.</source>
        <translation>O tanque está vazio (%1): %2 são trabalhados além disso.</translation>
    </message>
    <message>
        <source>Time to fill</source>
        <translation>Tempo de enchimento</translation>
    </message>
    <message>
        <source>Where the tank is filled or the bunker emptied: points or names of gates, divided by semicolons.</source>
        <translation>Onde o tanque é abastecido ou o tanque graneleiro esvaziado: pontos ou nomes de entradas, separados por ponto e vírgula.</translation>
    </message>
    <message>
        <source>give longitude, then latitude, in degrees</source>
        <translation>indique longitude, depois latitude, em graus</translation>
    </message>
    <message>
        <source>names of gates or points in WGS84 such as MULTIPOINT ((4.1 52.0), (4.2 52.0))</source>
        <translation>nomes de entradas ou pontos em WGS84 como MULTIPOINT ((4.1 52.0), (4.2 52.0))</translation>
    </message>
    <message>
        <source>Always</source>
        <translation>Sempre</translation>
    </message>
    <message>
        <source>The quickest of them is taken.</source>
        <translation>O mais rápido é usado.</translation>
    </message>
    <message>
        <source>Only where the first one cannot be driven</source>
        <translation>Só se o primeiro não for executável</translation>
    </message>
    <message>
        <source>Planning is several times quicker, and the work takes some percent longer.</source>
        <translation>O plano é calculado várias vezes mais depressa, e o trabalho leva alguns por cento a mais.</translation>
    </message>
    <message>
        <source>Compare plans</source>
        <translation>Comparar planos</translation>
    </message>
    <message>
        <source>Plans with other headings, orders, corners and fewer headland passes are driven beside the first one.</source>
        <translation>Além do primeiro são calculados por inteiro planos com outras direções, ordens e cantos e com menos passadas de cabeceira.</translation>
    </message>
    <message>
        <source>headings, orders and corners are not compared as driven: the path has %1 parts and the field %2 corners, and with more than %3 in all that takes too long</source>
        <translation>direções, ordens e cantos não são comparados como percorridos: o percurso tem %1 partes e o talhão %2 cantos, e com mais de %3 no total isso demora demais</translation>
    </message>
    <message>
        <source>Way back to work</source>
        <translation>Caminho de volta ao trabalho</translation>
    </message>
    <message>
        <source>Way to refill</source>
        <translation>Caminho para o reabastecimento</translation>
    </message>
    <message>
        <source>Way to unload</source>
        <translation>Caminho para a descarga</translation>
    </message>
    <message>
        <source>Swaths reach to the boundary; for fields with room to turn outside, and for machines that turn on the spot.</source>
        <translation>As passadas vão até o limite; para talhões com espaço para manobrar fora e para máquinas que giram no lugar.</translation>
    </message>
    <message>
        <source>There is no headland, as chosen. The machine turns on the spot inside the field.</source>
        <translation>Sem cabeceira, como escolhido. A máquina gira no lugar, dentro do talhão.</translation>
    </message>
</context>
<context>
    <name>PreferencesDialog</name>
    <message>
        <source>Language and units</source>
        <translation>Idioma e unidades</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Idioma</translation>
    </message>
    <message>
        <source>Same as this computer</source>
        <translation>Como este computador</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>Unidades</translation>
    </message>
    <message>
        <source>Metres, hectares, km/h</source>
        <translation>Metros, hectares, km/h</translation>
    </message>
    <message>
        <source>Feet, acres, mph</source>
        <translation>Pés, acres, mph</translation>
    </message>
    <message>
        <source>Fields take both: 7.3 m, 24 ft, 10&apos;6&quot;, 8 km/h, 5 mph. Files always hold metres.</source>
        <translation>As caixas aceitam ambas: 7,3 m, 24 ft, 10&apos;6&quot;, 8 km/h, 5 mph. Os arquivos contêm sempre metros.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fechar</translation>
    </message>
</context>
<context>
    <name>PrintDialog</name>
    <message>
        <source>Print the work order</source>
        <translation>Imprimir a ordem de serviço</translation>
    </message>
    <message>
        <source>Plan again</source>
        <translation>Planejar de novo</translation>
    </message>
    <message numerus="yes">
        <source>%n problem(s) in this plan: it cannot be driven as drawn. The pages say so too.</source>
        <translation>
            <numerusform>%n problema neste plano: não pode ser percorrido como está. As páginas também dizem isso.</numerusform>
            <numerusform>%n problemas neste plano: não pode ser percorrido como está. As páginas também dizem isso.</numerusform>
        </translation>
    </message>
    <message>
        <source>Pages of</source>
        <translation>Páginas de</translation>
    </message>
    <message>
        <source>This field</source>
        <translation>Este talhão</translation>
    </message>
    <message>
        <source>The whole farm (%1)</source>
        <translation>A fazenda toda (%1)</translation>
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
        <translation>Impressora</translation>
    </message>
    <message>
        <source>No printer was found</source>
        <translation>Nenhuma impressora encontrada</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Parar</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fechar</translation>
    </message>
    <message>
        <source>Save picture…</source>
        <translation>Salvar imagem…</translation>
    </message>
    <message>
        <source>Print</source>
        <translation>Imprimir</translation>
    </message>
    <message>
        <source>Save as PDF…</source>
        <translation>Salvar como PDF…</translation>
    </message>
    <message>
        <source>Save the work order</source>
        <translation>Salvar a ordem de serviço</translation>
    </message>
    <message>
        <source>PDF (%1)</source>
        <translation>PDF (%1)</translation>
    </message>
    <message>
        <source>Save the page with the map as a picture</source>
        <translation>Salvar a página do mapa como imagem</translation>
    </message>
    <message>
        <source>Pictures (%1)</source>
        <translation>Imagens (%1)</translation>
    </message>
    <message numerus="yes">
        <source>%n field(s) of the list</source>
        <translation>
            <numerusform>%n talhão da lista</numerusform>
            <numerusform>%n talhões da lista</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ProblemCard</name>
    <message>
        <source>Show the place</source>
        <translation>Mostrar o lugar</translation>
    </message>
    <message>
        <source>Open another file…</source>
        <translation>Abrir outro arquivo…</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fechar</translation>
    </message>
</context>
<context>
    <name>ProjectDialogs</name>
    <message>
        <source>Open projects or field boundaries</source>
        <translation>Abrir projetos ou limites de talhão</translation>
    </message>
    <message>
        <source>Projects and field boundaries (%1)</source>
        <translation>Projetos e limites de talhão (%1)</translation>
    </message>
    <message>
        <source>Projects (%1)</source>
        <translation>Projetos (%1)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Todos os arquivos (*)</translation>
    </message>
    <message>
        <source>Save the project</source>
        <translation>Salvar o projeto</translation>
    </message>
</context>
<context>
    <name>RecentList</name>
    <message>
        <source>Open recent</source>
        <translation>Abrir recente</translation>
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
        <translation>Continuar com</translation>
    </message>
    <message>
        <source>Project %1 in %2, %3</source>
        <translation>Projeto %1 em %2, %3</translation>
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
        <translation>Plano</translation>
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
            <numerusform>%n para ver</numerusform>
            <numerusform>%n para ver</numerusform>
        </translation>
    </message>
    <message>
        <source>Show the first %1 only</source>
        <translation>Mostrar só os primeiros %1</translation>
    </message>
    <message>
        <source>Show all %1</source>
        <translation>Mostrar todos os %1</translation>
    </message>
    <message>
        <source>Out of date: figures and findings are those of the plan before the change.</source>
        <translation>Desatualizado: os números e os avisos são do plano anterior à alteração.</translation>
    </message>
    <message>
        <source>Nothing was found in this plan: all of it can be driven.</source>
        <translation>Nada foi encontrado neste plano: ele pode ser percorrido por inteiro.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fechar</translation>
    </message>
    <message>
        <source>first plan: preliminary figures</source>
        <translation>primeiro plano: números provisórios</translation>
    </message>
    <message>
        <source>of the plan before</source>
        <translation>do plano anterior</translation>
    </message>
</context>
<context>
    <name>ReviewDialogs</name>
    <message>
        <source>Send for review</source>
        <translation>Enviar para revisão</translation>
    </message>
    <message>
        <source>Review files (%1)</source>
        <translation>Arquivos de revisão (%1)</translation>
    </message>
    <message>
        <source>Take in what came back</source>
        <translation>Incorporar o que voltou</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Todos os arquivos (*)</translation>
    </message>
    <message>
        <source>Take in this review?</source>
        <translation>Incorporar esta revisão?</translation>
    </message>
    <message>
        <source>The file is a review of a plan of the project that is open. Its comments can be taken in here.</source>
        <translation>O arquivo é uma revisão de um plano do projeto aberto. Seus comentários podem ser incorporados aqui.</translation>
    </message>
    <message>
        <source>Take in</source>
        <translation>Incorporar</translation>
    </message>
    <message>
        <source>Open by itself</source>
        <translation>Abrir à parte</translation>
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
            <numerusform>Revisão · %n comentário aberto</numerusform>
            <numerusform>Revisão · %n comentários abertos</numerusform>
        </translation>
    </message>
    <message>
        <source>Review</source>
        <translation>Revisão</translation>
    </message>
    <message>
        <source>The plan has changed since.</source>
        <translation>O plano mudou desde então.</translation>
    </message>
    <message>
        <source>Take back</source>
        <translation>Retirar</translation>
    </message>
    <message>
        <source>At the place that you clicked:</source>
        <translation>No lugar clicado:</translation>
    </message>
    <message>
        <source>On the whole plan:</source>
        <translation>Sobre o plano todo:</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>Comentário</translation>
    </message>
    <message>
        <source>What should be changed here?</source>
        <translation>O que deve mudar aqui?</translation>
    </message>
    <message>
        <source>Your name</source>
        <translation>Seu nome</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Adicionar</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>On a place…</source>
        <translation>Em um lugar…</translation>
    </message>
    <message>
        <source>On the whole plan…</source>
        <translation>No plano todo…</translation>
    </message>
    <message>
        <source>Approve</source>
        <translation>Aprovar</translation>
    </message>
    <message>
        <source>Ask for changes</source>
        <translation>Pedir mudanças</translation>
    </message>
    <message>
        <source>Take in what came back…</source>
        <translation>Incorporar o que voltou…</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fechar</translation>
    </message>
    <message>
        <source>Comment %1:</source>
        <translation>Comentário %1:</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Alterar</translation>
    </message>
</context>
<context>
    <name>ScaleBar</name>
    <message>
        <source>Scale: the bar is %1 long</source>
        <translation>Escala: a barra mede %1</translation>
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
        <translation>Voltar ao plano (Esc)</translation>
    </message>
</context>
<context>
    <name>SketchHint</name>
    <message>
        <source>Click the first corner of the field</source>
        <translation>Clique no primeiro canto do talhão</translation>
    </message>
    <message>
        <source>Click the first corner of the hole</source>
        <translation>Clique no primeiro canto do vazio</translation>
    </message>
    <message>
        <source>Click the first corner of the obstacle</source>
        <translation>Clique no primeiro canto do obstáculo</translation>
    </message>
    <message>
        <source>Click on the boundary where the gate is</source>
        <translation>Clique no limite onde fica a entrada</translation>
    </message>
    <message>
        <source>Click where the AB line begins</source>
        <translation>Clique onde começa a linha AB</translation>
    </message>
    <message>
        <source>Length of the next edge</source>
        <translation>Comprimento do próximo lado</translation>
    </message>
    <message>
        <source>Direction of the next edge</source>
        <translation>Direção do próximo lado</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Adicionar</translation>
    </message>
    <message>
        <source>By hand</source>
        <translation>À mão livre</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>Concluir</translation>
    </message>
    <message>
        <source>Close boundary</source>
        <translation>Fechar o limite</translation>
    </message>
    <message>
        <source>Click where the split line begins</source>
        <translation>Clique onde começa a linha de divisão</translation>
    </message>
    <message>
        <source>Press and trace it with the pointer, to %1</source>
        <translation>Pressione e trace com o ponteiro, com precisão de %1</translation>
    </message>
    <message>
        <source>Backspace or Ctrl+Z takes the last point back</source>
        <translation>Backspace ou Ctrl+Z desfaz o último ponto</translation>
    </message>
</context>
<context>
    <name>StatusChip</name>
    <message>
        <source>Stop</source>
        <translation>Parar</translation>
    </message>
    <message>
        <source>Plan again</source>
        <translation>Planejar de novo</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Mostrar</translation>
    </message>
    <message>
        <source>Show the problems</source>
        <translation>Mostrar os problemas</translation>
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
        <translation>O contorno tem %1 degraus de cerca de %2 %3, como os pixels de uma imagem.</translation>
    </message>
    <message>
        <source>Made straight, their outlines would be refused. Open one of them to see why.</source>
        <translation>Endireitados, os contornos seriam recusados. Abra um deles para ver por quê.</translation>
    </message>
    <message>
        <source>No machine follows them. Straight edges lead through the middles of the steps.</source>
        <translation>Nenhuma máquina os segue. Bordas retas passam pelo meio dos degraus.</translation>
    </message>
    <message>
        <source>Make them straight</source>
        <translation>Endireitar</translation>
    </message>
    <message>
        <source>In all fields</source>
        <translation>Em todos os talhões</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fechar</translation>
    </message>
</context>
<context>
    <name>StepsPanel</name>
    <message>
        <source>Find the best plan…</source>
        <translation>Buscar o melhor plano…</translation>
    </message>
</context>
<context>
    <name>ThemeSwitch</name>
    <message>
        <source>Sunlight colours; press for light</source>
        <translation>Cores para pleno sol; pressione para claras</translation>
    </message>
    <message>
        <source>Dark colours; press for sunlight</source>
        <translation>Cores escuras; pressione para pleno sol</translation>
    </message>
    <message>
        <source>Light colours; press for dark</source>
        <translation>Cores claras; pressione para escuras</translation>
    </message>
</context>
<context>
    <name>TopBar</name>
    <message>
        <source>Not saved yet</source>
        <translation>Ainda não salvo</translation>
    </message>
    <message>
        <source>There are changes that are not saved</source>
        <translation>Há alterações não salvas</translation>
    </message>
    <message>
        <source>Hide the results</source>
        <translation>Ocultar os resultados</translation>
    </message>
    <message>
        <source>Show the results</source>
        <translation>Mostrar os resultados</translation>
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
        <translation>Ocultar as etapas</translation>
    </message>
    <message>
        <source>Show the steps</source>
        <translation>Mostrar as etapas</translation>
    </message>
</context>
<context>
    <name>Tour</name>
    <message>
        <source>Get a field</source>
        <translation>Carregue um talhão</translation>
    </message>
    <message>
        <source>Open its boundary, draw it, or press here for a sample.</source>
        <translation>Abra o limite, desenhe-o ou clique aqui para um exemplo.</translation>
    </message>
    <message>
        <source>Choose your machine</source>
        <translation>Escolha sua máquina</translation>
    </message>
    <message>
        <source>The second step: the one most like yours, then its width.</source>
        <translation>A segunda etapa: a mais parecida com a sua e depois a largura.</translation>
    </message>
    <message>
        <source>Change the field</source>
        <translation>Altere o talhão</translation>
    </message>
    <message>
        <source>Drag a corner on the map. The plan follows; Ctrl+Z takes it back.</source>
        <translation>Arraste um canto no mapa. O plano acompanha; Ctrl+Z desfaz.</translation>
    </message>
    <message>
        <source>Take it to the tractor</source>
        <translation>Leve ao trator</translation>
    </message>
    <message>
        <source>Export writes the plan to a stick or a folder and checks it.</source>
        <translation>A exportação grava o plano em um pen drive ou pasta e o confere.</translation>
    </message>
    <message>
        <source>That is all</source>
        <translation>É só isso</translation>
    </message>
    <message>
        <source>First things</source>
        <translation>Primeiros passos</translation>
    </message>
    <message>
        <source>Leave; it is in the Help menu</source>
        <translation>Sair; está no menu Ajuda</translation>
    </message>
    <message>
        <source>%1: done</source>
        <translation>%1: feito</translation>
    </message>
    <message>
        <source>Ctrl+S saves the project, F1 opens the guide.</source>
        <translation>Ctrl+S salva o projeto, F1 abre o guia.</translation>
    </message>
</context>
<context>
    <name>TrackQuestion</name>
    <message>
        <source>“%1” is a recorded track</source>
        <translation>“%1” é um trajeto gravado</translation>
    </message>
    <message>
        <source>It can become a field, or be laid over the plan to see how far beside it was driven.</source>
        <translation>Ele pode virar um talhão, ou ser posto sobre o plano para ver o quanto se desviou.</translation>
    </message>
    <message>
        <source>Make a field from it</source>
        <translation>Fazer um talhão dele</translation>
    </message>
    <message>
        <source>Lay it over the plan</source>
        <translation>Pôr sobre o plano</translation>
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
        <translation>Relatar um problema</translation>
    </message>
    <message>
        <source>One file with all that is needed to find the cause: the version, the machine, the settings, the shape of the field, the findings, and the record of the last crash. No names and no other fields are in it.</source>
        <translation>Um arquivo com tudo o que é preciso para achar a causa: a versão, a máquina, as configurações, a forma do talhão, os avisos e o registro da última falha. Não contém nomes nem outros talhões.</translation>
    </message>
    <message>
        <source>Nothing is sent. You decide who gets the file; write to them what you did and what you expected.</source>
        <translation>Nada é enviado. Você decide quem recebe o arquivo; escreva o que fez e o que esperava.</translation>
    </message>
    <message>
        <source>Save the report…</source>
        <translation>Salvar o relatório…</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fechar</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>Salvar o relatório</translation>
    </message>
    <message>
        <source>Reports (%1)</source>
        <translation>Relatórios (%1)</translation>
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
        <translation>Salvar as alterações de “%1”?</translation>
    </message>
    <message>
        <source>Save your work?</source>
        <translation>Salvar o trabalho?</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Do not save</source>
        <translation>Não salvar</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Salvar</translation>
    </message>
</context>
<context>
    <name>ViewCommands</name>
    <message>
        <source>View</source>
        <translation>Exibir</translation>
    </message>
    <message>
        <source>What the map shows</source>
        <translation>O que o mapa mostra</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Cores</translation>
    </message>
    <message>
        <source>Size of everything</source>
        <translation>Tamanho da interface</translation>
    </message>
    <message>
        <source>Everything at %1 %</source>
        <translation>Tudo em %1 %</translation>
    </message>
    <message>
        <source>size scaling zoom large text</source>
        <translation>tamanho escala zoom texto grande</translation>
    </message>
    <message>
        <source>Follow the machine</source>
        <translation>Seguir a máquina</translation>
    </message>
    <message>
        <source>drive camera centre</source>
        <translation>percorrer mapa centro</translation>
    </message>
    <message>
        <source>Drive-through bar</source>
        <translation>Barra de percurso</translation>
    </message>
    <message>
        <source>drive play slider</source>
        <translation>percorrer reproduzir controle</translation>
    </message>
    <message>
        <source>Show the whole field</source>
        <translation>Mostrar todo o talhão</translation>
    </message>
    <message>
        <source>Go to a place…</source>
        <translation>Ir para um lugar…</translation>
    </message>
    <message>
        <source>coordinates latitude longitude map</source>
        <translation>coordenadas latitude longitude mapa</translation>
    </message>
    <message>
        <source>Closer</source>
        <translation>Aproximar</translation>
    </message>
    <message>
        <source>zoom in</source>
        <translation>ampliar zoom</translation>
    </message>
    <message>
        <source>Further away</source>
        <translation>Afastar</translation>
    </message>
    <message>
        <source>zoom out</source>
        <translation>reduzir zoom</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Etapas</translation>
    </message>
    <message>
        <source>Results panel</source>
        <translation>Resultados</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Camadas</translation>
    </message>
    <message>
        <source>imagery map background</source>
        <translation>imagens mapa fundo</translation>
    </message>
    <message>
        <source>Layer: imagery</source>
        <translation>Camada: imagens</translation>
    </message>
    <message>
        <source>Layer: OpenStreetMap from the network</source>
        <translation>Camada: OpenStreetMap da rede</translation>
    </message>
    <message>
        <source>online tiles</source>
        <translation>on-line blocos</translation>
    </message>
    <message>
        <source>Layer: boundary</source>
        <translation>Camada: limite do talhão</translation>
    </message>
    <message>
        <source>Layer: headland</source>
        <translation>Camada: cabeceira</translation>
    </message>
    <message>
        <source>Layer: swaths</source>
        <translation>Camada: passadas</translation>
    </message>
    <message>
        <source>Layer: turns</source>
        <translation>Camada: manobras</translation>
    </message>
    <message>
        <source>Layer: driving direction</source>
        <translation>Camada: sentido de marcha</translation>
    </message>
    <message>
        <source>Layer: swath numbers</source>
        <translation>Camada: números das passadas</translation>
    </message>
    <message>
        <source>Layer: order numbers</source>
        <translation>Camada: números de ordem</translation>
    </message>
    <message>
        <source>Layer: coverage</source>
        <translation>Camada: área trabalhada</translation>
    </message>
    <message>
        <source>Layer: worked twice</source>
        <translation>Camada: trabalhado duas vezes</translation>
    </message>
    <message>
        <source>overlap</source>
        <translation>sobreposição</translation>
    </message>
    <message>
        <source>Layer: missed</source>
        <translation>Camada: falhas</translation>
    </message>
    <message>
        <source>gap uncovered</source>
        <translation>lacuna não coberta</translation>
    </message>
    <message>
        <source>Layer: driven over often</source>
        <translation>Camada: passagens de roda</translation>
    </message>
    <message>
        <source>wheel passes traffic compaction</source>
        <translation>passagens de roda tráfego compactação</translation>
    </message>
    <message>
        <source>Layer: findings</source>
        <translation>Camada: avisos</translation>
    </message>
    <message>
        <source>Language and units…</source>
        <translation>Idioma e unidades…</translation>
    </message>
    <message>
        <source>preferences settings metric imperial feet acres</source>
        <translation>preferências configurações métrico imperial pés acres</translation>
    </message>
    <message>
        <source>Light colours</source>
        <translation>Cores claras</translation>
    </message>
    <message>
        <source>theme</source>
        <translation>tema</translation>
    </message>
    <message>
        <source>Dark colours</source>
        <translation>Cores escuras</translation>
    </message>
    <message>
        <source>theme night</source>
        <translation>tema noite</translation>
    </message>
    <message>
        <source>Sunlight colours</source>
        <translation>Cores para pleno sol</translation>
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
        <translation>Tudo em %1 %</translation>
    </message>
    <message>
        <source>This holds from the next start of Furrow.</source>
        <translation>Isto vale a partir do próximo início do Furrow.</translation>
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
        <translation>Várias manobras</translation>
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
        <translation>como desenhado</translation>
    </message>
    <message>
        <source>Draft</source>
        <comment>work order</comment>
        <translation>Rascunho</translation>
    </message>
    <message>
        <source>Issued</source>
        <comment>work order</comment>
        <translation>Emitida</translation>
    </message>
    <message>
        <source>In progress</source>
        <comment>work order</comment>
        <translation>Em andamento</translation>
    </message>
    <message>
        <source>Done</source>
        <comment>work order</comment>
        <translation>Concluída</translation>
    </message>
    <message numerus="yes">
        <source>Not drivable: %n problem(s)</source>
        <translation>
            <numerusform>Não executável: %n problema</numerusform>
            <numerusform>Não executável: %n problemas</numerusform>
        </translation>
    </message>
    <message>
        <source>Work order</source>
        <translation>Ordem de serviço</translation>
    </message>
    <message>
        <source>Work order %1</source>
        <translation>Ordem de serviço %1</translation>
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
        <translation>Endereço do talhão</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>Operador</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>Product</source>
        <translation>Produto</translation>
    </message>
    <message>
        <source>Rate and total</source>
        <translation>Dose e total</translation>
    </message>
    <message>
        <source>%1 = %2</source>
        <comment>rate and total</comment>
        <translation>%1 = %2</translation>
    </message>
    <message>
        <source>Where the work starts</source>
        <translation>Onde o trabalho começa</translation>
    </message>
    <message>
        <source>Gate</source>
        <translation>Entrada</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Área</translation>
    </message>
    <message>
        <source>Driven</source>
        <translation>Percorrido</translation>
    </message>
    <message>
        <source>Working</source>
        <translation>Trabalho</translation>
    </message>
    <message>
        <source>Turning</source>
        <translation>Manobras</translation>
    </message>
    <message>
        <source>Covered</source>
        <translation>Trabalhado</translation>
    </message>
    <message>
        <source>Worked twice</source>
        <translation>Trabalhado duas vezes</translation>
    </message>
    <message>
        <source>Outside the field</source>
        <translation>Fora do talhão</translation>
    </message>
    <message>
        <source>Fuel</source>
        <translation>Combustível</translation>
    </message>
    <message>
        <source>%1 l</source>
        <translation>%1 l</translation>
    </message>
    <message>
        <source>Above the best order</source>
        <translation>Acima da melhor ordem</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Máquina</translation>
    </message>
    <message>
        <source>Working width</source>
        <translation>Largura de trabalho</translation>
    </message>
    <message>
        <source>Width in turns</source>
        <translation>Largura nas manobras</translation>
    </message>
    <message>
        <source>Turning radius</source>
        <translation>Raio de giro</translation>
    </message>
    <message>
        <source>Speed at work</source>
        <translation>Velocidade de trabalho</translation>
    </message>
    <message>
        <source>Speed in turns</source>
        <translation>Velocidade nas manobras</translation>
    </message>
    <message>
        <source>Implement</source>
        <translation>Implemento</translation>
    </message>
    <message>
        <source>trailed</source>
        <translation>rebocado</translation>
    </message>
    <message>
        <source>mounted</source>
        <translation>montado</translation>
    </message>
    <message>
        <source>Tank</source>
        <translation>Tanque</translation>
    </message>
    <message>
        <source>full after %1</source>
        <translation>cheio após %1</translation>
    </message>
    <message>
        <source>enough for %1</source>
        <translation>suficiente para %1</translation>
    </message>
    <message numerus="yes">
        <source>%n pass(es)</source>
        <translation>
            <numerusform>%n passada</numerusform>
            <numerusform>%n passadas</numerusform>
        </translation>
    </message>
    <message>
        <source>none</source>
        <comment>headland</comment>
        <translation>nenhuma</translation>
    </message>
    <message>
        <source>Operation</source>
        <translation>Operação</translation>
    </message>
    <message>
        <source>Headland</source>
        <translation>Cabeceira</translation>
    </message>
    <message>
        <source>Swaths</source>
        <translation>Passadas</translation>
    </message>
    <message>
        <source>Kept free at the edge</source>
        <translation>Margem livre na borda</translation>
    </message>
    <message>
        <source>Plan and settings</source>
        <translation>Plano e configurações</translation>
    </message>
    <message>
        <source>What was done</source>
        <translation>Execução</translation>
    </message>
    <message>
        <source>Acres worked</source>
        <translation>Acres trabalhados</translation>
    </message>
    <message>
        <source>Hectares worked</source>
        <translation>Hectares trabalhados</translation>
    </message>
    <message>
        <source>Hours</source>
        <translation>Horas</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>Início</translation>
    </message>
    <message>
        <source>End</source>
        <comment>of the work</comment>
        <translation>Fim</translation>
    </message>
    <message>
        <source>Wind</source>
        <translation>Vento</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>Temperatura</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Observações</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Data</translation>
    </message>
    <message>
        <source>Signature</source>
        <translation>Assinatura</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Avisos</translation>
    </message>
    <message>
        <source>None: the plan can be driven as drawn.</source>
        <translation>Nenhum: o plano pode ser percorrido como está.</translation>
    </message>
    <message numerus="yes">
        <source>and %n more, in the window and in summary.json</source>
        <translation>
            <numerusform>e mais %n, na janela e em summary.json</numerusform>
            <numerusform>e mais %n, na janela e em summary.json</numerusform>
        </translation>
    </message>
    <message>
        <source>Comments</source>
        <translation>Comentários</translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <comment>count and kind of turns</comment>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>%1 in reverse</source>
        <translation>%1 de ré</translation>
    </message>
    <message>
        <source>Turns</source>
        <translation>Manobras</translation>
    </message>
    <message>
        <source>H%1</source>
        <comment>headland pass</comment>
        <translation>C%1</translation>
    </message>
    <message>
        <source>Swath %1</source>
        <translation>Passada %1</translation>
    </message>
    <message>
        <source>Order of the passes</source>
        <translation>Ordem das passadas</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>N.º</translation>
    </message>
    <message>
        <source>Pass</source>
        <translation>Passada</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Comprimento</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Para</translation>
    </message>
    <message>
        <source>This plan&apos;s path.csv has the SHA-256 sum below. A file with another sum is another plan.</source>
        <translation>O path.csv deste plano tem a soma SHA-256 abaixo. Um arquivo com outra soma é outro plano.</translation>
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
        <translation>Início</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Fim</translation>
    </message>
    <message>
        <source>Swath</source>
        <translation>Passada</translation>
    </message>
    <message>
        <source>Headland pass</source>
        <translation>Passada de cabeceira</translation>
    </message>
    <message>
        <source>Implement up</source>
        <translation>Implemento levantado</translation>
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
        <translation>Fazenda</translation>
    </message>
    <message>
        <source>Work orders</source>
        <translation>Ordens de serviço</translation>
    </message>
    <message numerus="yes">
        <source>%n field(s)</source>
        <translation>
            <numerusform>%n talhão</numerusform>
            <numerusform>%n talhões</numerusform>
        </translation>
    </message>
    <message>
        <source>Field</source>
        <translation>Talhão</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Plano</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Situação</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>Página</translation>
    </message>
    <message>
        <source>Not drivable</source>
        <translation>Não executável</translation>
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
        <translation>plano %1</translation>
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
        <translation>Reabastecimentos</translation>
    </message>
</context>
<context>
    <name>furrow::BestSearch</name>
    <message>
        <source>Take the best plan</source>
        <translation>Usar o melhor plano</translation>
    </message>
</context>
<context>
    <name>furrow::CellSteps</name>
    <message numerus="yes">
        <source>%n block(s), %1</source>
        <translation>
            <numerusform>%n subtalhão, %1</numerusform>
            <numerusform>%n subtalhões, %1</numerusform>
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
        <translation>Unir dois deles não economizaria nada.</translation>
    </message>
    <message>
        <source>Step %1 of %2: %3</source>
        <translation>Etapa %1 de %2: %3</translation>
    </message>
    <message>
        <source>As cut.</source>
        <translation>Como foi dividido.</translation>
    </message>
    <message>
        <source>The two marked blocks become one: that saves %1.</source>
        <translation>Os dois subtalhões marcados viram um só: isso economiza %1.</translation>
    </message>
    <message>
        <source>Blocks in which no swath lies go to their neighbours.</source>
        <translation>Subtalhões sem passadas vão para os vizinhos.</translation>
    </message>
</context>
<context>
    <name>furrow::ChoiceTableModel</name>
    <message>
        <source>saves %1</source>
        <translation>economiza %1</translation>
    </message>
    <message>
        <source>mends the plan</source>
        <translation>torna-o executável</translation>
    </message>
    <message>
        <source>the same time</source>
        <translation>mesmo tempo</translation>
    </message>
    <message>
        <source>%1 slower</source>
        <translation>%1 mais lento</translation>
    </message>
    <message>
        <source>%1 quicker</source>
        <translation>%1 mais rápido</translation>
    </message>
</context>
<context>
    <name>furrow::DriveThrough</name>
    <message>
        <source>Swath %1, %2 of %3</source>
        <translation>Passada %1, %2 de %3</translation>
    </message>
    <message>
        <source>backwards</source>
        <translation>de ré</translation>
    </message>
    <message>
        <source>implement down</source>
        <translation>implemento abaixado</translation>
    </message>
    <message>
        <source>implement folded</source>
        <translation>implemento dobrado</translation>
    </message>
    <message>
        <source>implement up</source>
        <translation>implemento levantado</translation>
    </message>
    <message>
        <source>%1 done</source>
        <translation>%1 feitos</translation>
    </message>
    <message>
        <source>wheels straight</source>
        <translation>rodas retas</translation>
    </message>
    <message>
        <source>%1° left</source>
        <translation>%1° à esquerda</translation>
    </message>
    <message>
        <source>%1° right</source>
        <translation>%1° à direita</translation>
    </message>
    <message>
        <source>tank %1</source>
        <translation>tanque %1</translation>
    </message>
    <message>
        <source>tank empty</source>
        <translation>tanque vazio</translation>
    </message>
    <message>
        <source>Way without work</source>
        <translation>Caminho sem trabalho</translation>
    </message>
    <message>
        <source>bunker %1</source>
        <translation>tanque graneleiro %1</translation>
    </message>
</context>
<context>
    <name>furrow::DrivenTrack</name>
    <message>
        <source>On the plan</source>
        <translation>No plano</translation>
    </message>
    <message>
        <source>Positions within one and a half widths of it; the figures are of these</source>
        <translation>Posições a até uma largura e meia; os números são destas</translation>
    </message>
    <message>
        <source>Half are within</source>
        <translation>Metade está dentro de</translation>
    </message>
    <message>
        <source>95 % are within</source>
        <translation>95 % estão dentro de</translation>
    </message>
    <message>
        <source>Farthest</source>
        <translation>Mais distante</translation>
    </message>
    <message>
        <source>On average to the right</source>
        <translation>Em média à direita</translation>
    </message>
    <message>
        <source>On average to the left</source>
        <translation>Em média à esquerda</translation>
    </message>
    <message>
        <source>The same everywhere: antenna or offset</source>
        <translation>Igual em toda parte: antena ou deslocamento</translation>
    </message>
    <message>
        <source>On swaths, 95 % within</source>
        <translation>Nas passadas, 95 % dentro de</translation>
    </message>
    <message>
        <source>Covered</source>
        <translation>Trabalhado</translation>
    </message>
    <message>
        <source>As if the implement ran in the middle of the recorded line</source>
        <translation>Como se o implemento fosse no centro da linha gravada</translation>
    </message>
    <message>
        <source>Missed</source>
        <translation>Falhas</translation>
    </message>
    <message>
        <source>Driven</source>
        <translation>Percorrido</translation>
    </message>
    <message>
        <source>The plan: %1</source>
        <translation>O plano: %1</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>up to %1</source>
        <translation>até %1</translation>
    </message>
    <message>
        <source>farther</source>
        <translation>mais longe</translation>
    </message>
    <message>
        <source>off the plan</source>
        <translation>fora do plano</translation>
    </message>
</context>
<context>
    <name>furrow::ExportModel</name>
    <message>
        <source>Furrow plan</source>
        <translation>Plano do Furrow</translation>
    </message>
    <message>
        <source>Furrow %1</source>
        <translation>Furrow %1</translation>
    </message>
    <message>
        <source>Writing …</source>
        <translation>Gravando…</translation>
    </message>
    <message numerus="yes">
        <source>%n file(s) written to %1</source>
        <translation>
            <numerusform>%n arquivo gravado em %1</numerusform>
            <numerusform>%n arquivos gravados em %1</numerusform>
        </translation>
    </message>
    <message>
        <source>There is no field yet, and no plan to export.</source>
        <translation>Ainda não há talhão nem plano para exportar.</translation>
    </message>
    <message>
        <source>A field is being opened. Its plan can be exported when it is finished.</source>
        <translation>Um talhão está sendo aberto. O plano poderá ser exportado quando estiver pronto.</translation>
    </message>
    <message>
        <source>The plan is still being made. It can be exported when it is finished.</source>
        <translation>O plano ainda está sendo calculado. Poderá ser exportado quando estiver pronto.</translation>
    </message>
    <message>
        <source>The plan is out of date: the field, the machine or a setting was changed after it was made.</source>
        <translation>O plano está desatualizado: o talhão, a máquina ou uma configuração mudou depois.</translation>
    </message>
    <message>
        <source>There is no plan to export. The message on the map says why.</source>
        <translation>Não há plano para exportar. A mensagem no mapa diz por quê.</translation>
    </message>
    <message numerus="yes">
        <source>%n field(s)</source>
        <translation>
            <numerusform>%n talhão</numerusform>
            <numerusform>%n talhões</numerusform>
        </translation>
    </message>
    <message>
        <source>Furrow plans</source>
        <translation>Furrow planos</translation>
    </message>
    <message>
        <source>None of the fields could be exported.</source>
        <translation>Nenhum dos talhões pôde ser exportado.</translation>
    </message>
    <message numerus="yes">
        <source>%n field(s) written to %1</source>
        <translation>
            <numerusform>%n talhão gravado em %1</numerusform>
            <numerusform>%n talhões gravados em %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n file(s)</source>
        <translation>
            <numerusform>%n arquivo</numerusform>
            <numerusform>%n arquivos</numerusform>
        </translation>
    </message>
    <message>
        <source>Writing was stopped.</source>
        <translation>A gravação foi interrompida.</translation>
    </message>
    <message>
        <source>Fields that were written before stay in the folder.</source>
        <translation>Os talhões já gravados ficam na pasta.</translation>
    </message>
</context>
<context>
    <name>furrow::FarmList</name>
    <message numerus="yes">
        <source>Plan %n field(s) alike</source>
        <translation>
            <numerusform>Planejar %n talhão do mesmo modo</numerusform>
            <numerusform>Planejar %n talhões do mesmo modo</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Add a plan to %n field(s)</source>
        <translation>
            <numerusform>Adicionar um plano a %n talhão</numerusform>
            <numerusform>Adicionar um plano a %n talhões</numerusform>
        </translation>
    </message>
    <message>
        <source>Not planned yet</source>
        <translation>Não planejado</translation>
    </message>
    <message>
        <source>Out of date</source>
        <translation>Desatualizado</translation>
    </message>
    <message>
        <source>Waits</source>
        <translation>Na fila</translation>
    </message>
    <message>
        <source>Planning …</source>
        <translation>Planejando…</translation>
    </message>
    <message>
        <source>Drivable</source>
        <translation>Executável</translation>
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
        <translation>Sem plano</translation>
    </message>
    <message numerus="yes">
        <source>%n field(s)</source>
        <translation>
            <numerusform>%n talhão</numerusform>
            <numerusform>%n talhões</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n field(s)</source>
        <translation>
            <numerusform>%1 de %n talhão</numerusform>
            <numerusform>%1 de %n talhões</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 drivable</source>
        <translation>%1 executáveis</translation>
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
        <translation>Renomear o talhão</translation>
    </message>
    <message>
        <source>Remove field %1</source>
        <translation>Remover o talhão %1</translation>
    </message>
    <message>
        <source>Add a plan</source>
        <translation>Adicionar um plano</translation>
    </message>
    <message>
        <source>Rename the plan</source>
        <translation>Renomear o plano</translation>
    </message>
    <message>
        <source>Remove the plan</source>
        <translation>Remover o plano</translation>
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
        <translation>Parado</translation>
    </message>
    <message numerus="yes">
        <source>%n field(s) planned</source>
        <translation>
            <numerusform>%n talhão planejado</numerusform>
            <numerusform>%n talhões planejados</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n with problems</source>
        <translation>
            <numerusform>%n com problemas</numerusform>
            <numerusform>%n com problemas</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n without a plan</source>
        <translation>
            <numerusform>%n sem plano</numerusform>
            <numerusform>%n sem plano</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>furrow::FieldEditor</name>
    <message>
        <source>Add a point</source>
        <translation>Adicionar um ponto</translation>
    </message>
    <message>
        <source>Change the headland of an edge</source>
        <translation>Mudar a cabeceira de um lado</translation>
    </message>
    <message>
        <source>Headland of an edge as elsewhere</source>
        <translation>Cabeceira de um lado como no resto</translation>
    </message>
    <message>
        <source>Move a point</source>
        <translation>Mover um ponto</translation>
    </message>
    <message>
        <source>Move an edge</source>
        <translation>Mover um lado</translation>
    </message>
    <message>
        <source>Move a hole</source>
        <translation>Mover um vazio</translation>
    </message>
    <message>
        <source>Move an obstacle</source>
        <translation>Mover um obstáculo</translation>
    </message>
    <message>
        <source>Move a gate</source>
        <translation>Mover uma entrada</translation>
    </message>
    <message>
        <source>Change the buffer</source>
        <translation>Alterar a distância</translation>
    </message>
    <message>
        <source>Change the overhang of an obstacle</source>
        <translation>Alterar o balanço de um obstáculo</translation>
    </message>
    <message>
        <source>Change the overhang of an edge</source>
        <translation>Alterar o balanço de um lado</translation>
    </message>
    <message>
        <source>Draw a hole</source>
        <translation>Desenhar um vazio</translation>
    </message>
    <message>
        <source>Draw an obstacle</source>
        <translation>Desenhar um obstáculo</translation>
    </message>
    <message>
        <source>Obstacle %1</source>
        <translation>Obstáculo %1</translation>
    </message>
    <message>
        <source>Add a gate</source>
        <translation>Adicionar uma entrada</translation>
    </message>
    <message>
        <source>Gate %1</source>
        <translation>Entrada %1</translation>
    </message>
    <message>
        <source>Draw a guidance curve</source>
        <translation>Desenhar uma curva de orientação</translation>
    </message>
    <message>
        <source>Draw an AB line</source>
        <translation>Desenhar uma linha AB</translation>
    </message>
    <message>
        <source>Delete a point</source>
        <translation>Excluir um ponto</translation>
    </message>
    <message>
        <source>Delete a hole</source>
        <translation>Excluir um vazio</translation>
    </message>
    <message>
        <source>Delete an obstacle</source>
        <translation>Excluir um obstáculo</translation>
    </message>
    <message>
        <source>Delete a gate</source>
        <translation>Excluir uma entrada</translation>
    </message>
    <message>
        <source>Delete the guidance line</source>
        <translation>Excluir a linha de orientação</translation>
    </message>
    <message>
        <source>Make steps straight</source>
        <translation>Endireitar degraus</translation>
    </message>
    <message>
        <source>Made straight, it would be refused: %1; %2.</source>
        <translation>Endireitado, ele seria recusado: %1; %2.</translation>
    </message>
    <message numerus="yes">
        <source>%n field(s) stay as they are: %1.</source>
        <translation>
            <numerusform>%n talhão fica como está: %1.</numerusform>
            <numerusform>%n talhões ficam como estão: %1.</numerusform>
        </translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Mover</translation>
    </message>
    <message>
        <source>Change a length</source>
        <translation>Alterar um comprimento</translation>
    </message>
    <message>
        <source>Change a direction</source>
        <translation>Alterar uma direção</translation>
    </message>
    <message>
        <source>Let the obstacle be driven on</source>
        <translation>Permitir passar sobre o obstáculo</translation>
    </message>
    <message>
        <source>Keep off the obstacle</source>
        <translation>Não passar sobre o obstáculo</translation>
    </message>
    <message>
        <source>Change the gate</source>
        <translation>Alterar a entrada</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Renomear</translation>
    </message>
    <message>
        <source>AB line along an edge</source>
        <translation>Linha AB ao longo de um lado</translation>
    </message>
    <message>
        <source>Draw a split line</source>
        <translation>Desenhar uma linha de divisão</translation>
    </message>
    <message>
        <source>Delete a split line</source>
        <translation>Excluir uma linha de divisão</translation>
    </message>
</context>
<context>
    <name>furrow::FieldFromTrack</name>
    <message numerus="yes">
        <source>%n position(s)</source>
        <translation>
            <numerusform>%n posição</numerusform>
            <numerusform>%n posições</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n track(s)</source>
        <translation>
            <numerusform>%n trajeto</numerusform>
            <numerusform>%n trajetos</numerusform>
        </translation>
    </message>
    <message>
        <source>The pieces do not touch: each becomes a field of its own.</source>
        <translation>Os pedaços não se tocam: cada um vira um talhão próprio.</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Área</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>Pedaços</translation>
    </message>
    <message>
        <source>Holes</source>
        <translation>Buracos</translation>
    </message>
    <message>
        <source>Points of the boundary</source>
        <translation>Pontos do limite</translation>
    </message>
    <message>
        <source>Around the field</source>
        <translation>Ao redor do talhão</translation>
    </message>
    <message>
        <source>Over the whole field, at work</source>
        <translation>Por todo o talhão, em trabalho</translation>
    </message>
    <message>
        <source>As it looks: around the field</source>
        <translation>Conforme parece: ao redor do talhão</translation>
    </message>
    <message>
        <source>As it looks: over the field</source>
        <translation>Conforme parece: por todo o talhão</translation>
    </message>
    <message>
        <source>As it looks</source>
        <translation>Conforme parece</translation>
    </message>
</context>
<context>
    <name>furrow::FieldOpener</name>
    <message numerus="yes">
        <source>%n file(s)</source>
        <translation>
            <numerusform>%n arquivo</numerusform>
            <numerusform>%n arquivos</numerusform>
        </translation>
    </message>
    <message>
        <source>Add field %1</source>
        <translation>Adicionar o talhão %1</translation>
    </message>
    <message numerus="yes">
        <source>Add %n field(s)</source>
        <translation>
            <numerusform>Adicionar %n talhão</numerusform>
            <numerusform>Adicionar %n talhões</numerusform>
        </translation>
    </message>
    <message>
        <source>Field %1</source>
        <translation>Talhão %1</translation>
    </message>
    <message>
        <source>drawn on the map</source>
        <translation>desenhado no mapa</translation>
    </message>
</context>
<context>
    <name>furrow::FiguresModel</name>
    <message>
        <source>Area</source>
        <translation>Área</translation>
    </message>
    <message>
        <source>Of the field, holes and obstacles taken out</source>
        <translation>Do talhão, sem vazios nem obstáculos</translation>
    </message>
    <message>
        <source>Inside the headland</source>
        <translation>Interior do talhão</translation>
    </message>
    <message>
        <source>What is left inside the headland</source>
        <translation>O que resta dentro da cabeceira</translation>
    </message>
    <message>
        <source>Swaths</source>
        <translation>Passadas</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Percurso</translation>
    </message>
    <message>
        <source>Everything that is driven</source>
        <translation>Tudo o que é percorrido</translation>
    </message>
    <message>
        <source>Working</source>
        <translation>Trabalho</translation>
    </message>
    <message>
        <source>Turning</source>
        <translation>Manobras</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>Covered</source>
        <translation>Trabalhado</translation>
    </message>
    <message>
        <source>Share of the field that is worked, measured on the finished path</source>
        <translation>Parte do talhão trabalhada, medida no percurso concluído</translation>
    </message>
    <message>
        <source>Overlap</source>
        <translation>Sobreposição</translation>
    </message>
    <message>
        <source>Share of the field that is worked twice</source>
        <translation>Parte do talhão trabalhada duas vezes</translation>
    </message>
    <message>
        <source>Land that is not worked</source>
        <translation>Área que não é trabalhada</translation>
    </message>
    <message>
        <source>%1 cannot be reached by the implement, mostly in corners; %2 could be.</source>
        <translation>A %1 o implemento não chega, quase sempre em cantos; a %2 poderia chegar.</translation>
    </message>
    <message>
        <source>Missed</source>
        <translation>Falhas</translation>
    </message>
    <message>
        <source>Outside the field</source>
        <translation>Fora do talhão</translation>
    </message>
    <message>
        <source>Ground outside that the machine or its implement drives over</source>
        <translation>Solo de fora por onde a máquina ou o implemento passa</translation>
    </message>
</context>
<context>
    <name>furrow::FileBrowser</name>
    <message>
        <source>This folder cannot be read.</source>
        <translation>Esta pasta não pode ser lida.</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Pasta pessoal</translation>
    </message>
    <message>
        <source>Documents</source>
        <translation>Documentos</translation>
    </message>
    <message>
        <source>Downloads</source>
        <translation>Downloads</translation>
    </message>
    <message>
        <source>Desktop</source>
        <translation>Área de trabalho</translation>
    </message>
    <message>
        <source>Computer</source>
        <translation>Computador</translation>
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
        <translation>nenhum problema</translation>
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
        <translation>%1 → %2. Antes: %3. Agora: %4.</translation>
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
        <translation>nenhuma passada cabe</translation>
    </message>
    <message numerus="yes">
        <source>%n swath(s)</source>
        <translation>
            <numerusform>%n passada</numerusform>
            <numerusform>%n passadas</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 turning</source>
        <translation>%1 em manobras</translation>
    </message>
    <message>
        <source>%1 twice</source>
        <translation>%1 duas vezes</translation>
    </message>
    <message>
        <source>%1 missed</source>
        <translation>%1 de falhas</translation>
    </message>
    <message>
        <source>Swaths along %1</source>
        <translation>Passadas na direção %1</translation>
    </message>
    <message>
        <source>Search the heading</source>
        <translation>Buscar a direção</translation>
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
        <translation>Adicionar %1</translation>
    </message>
    <message>
        <source>Add imagery</source>
        <translation>Adicionar imagens</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>Remover %1</translation>
    </message>
    <message>
        <source>Move a layer</source>
        <translation>Mover uma camada</translation>
    </message>
    <message>
        <source>Rename a layer</source>
        <translation>Renomear uma camada</translation>
    </message>
    <message>
        <source>Show a layer</source>
        <translation>Mostrar uma camada</translation>
    </message>
    <message>
        <source>Hide a layer</source>
        <translation>Ocultar uma camada</translation>
    </message>
    <message>
        <source>Change how strong a layer is</source>
        <translation>Alterar a opacidade de uma camada</translation>
    </message>
    <message>
        <source>Turn the rows of tiles round</source>
        <translation>Inverter a ordem das linhas de blocos</translation>
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
        <translation>Número da ordem</translation>
    </message>
    <message>
        <source>Customer</source>
        <translation>Cliente</translation>
    </message>
    <message>
        <source>Field address</source>
        <translation>Endereço do talhão</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>Operador</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Horário</translation>
    </message>
    <message>
        <source>Product</source>
        <translation>Produto</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Dose</translation>
    </message>
    <message>
        <source>Unit of the rate</source>
        <translation>Unidade da dose</translation>
    </message>
    <message>
        <source>Area worked</source>
        <translation>Área trabalhada</translation>
    </message>
    <message>
        <source>Hours worked</source>
        <translation>Horas trabalhadas</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Observações</translation>
    </message>
    <message>
        <source>%1 per acre</source>
        <translation>%1 por acre</translation>
    </message>
    <message>
        <source>%1 per hectare</source>
        <translation>%1 por hectare</translation>
    </message>
    <message>
        <source>Change the work order</source>
        <translation>Alterar a ordem de serviço</translation>
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
            <numerusform>%n lugar no mapa</numerusform>
            <numerusform>%n lugares no mapa</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>a line of %n point(s)</source>
        <translation>
            <numerusform>uma linha de %n ponto</numerusform>
            <numerusform>uma linha de %n pontos</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n line(s)</source>
        <translation>
            <numerusform>%n linha</numerusform>
            <numerusform>%n linhas</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>furrow::PlanChange</name>
    <message>
        <source>time %1</source>
        <translation>tempo %1</translation>
    </message>
    <message>
        <source>path %1</source>
        <translation>percurso %1</translation>
    </message>
    <message>
        <source>covered %1</source>
        <translation>trabalhado %1</translation>
    </message>
    <message>
        <source>worked twice %1</source>
        <translation>trabalhado duas vezes %1</translation>
    </message>
    <message>
        <source>With the last change: the same time, length and area.</source>
        <translation>Com a última mudança: o mesmo tempo, comprimento e área.</translation>
    </message>
    <message>
        <source>With the last change: %1</source>
        <translation>Com a última mudança: %1</translation>
    </message>
</context>
<context>
    <name>furrow::PlanComparison</name>
    <message>
        <source>Time</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Percurso</translation>
    </message>
    <message>
        <source>Working</source>
        <translation>Trabalho</translation>
    </message>
    <message>
        <source>Turning</source>
        <translation>Manobras</translation>
    </message>
    <message>
        <source>Swaths</source>
        <translation>Passadas</translation>
    </message>
    <message>
        <source>Covered</source>
        <translation>Trabalhado</translation>
    </message>
    <message>
        <source>Missed</source>
        <translation>Falhas</translation>
    </message>
    <message>
        <source>Overlap</source>
        <translation>Sobreposição</translation>
    </message>
    <message>
        <source>Outside the field</source>
        <translation>Fora do talhão</translation>
    </message>
    <message>
        <source>In reverse</source>
        <translation>De ré</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Problemas</translation>
    </message>
    <message>
        <source>The standard settings</source>
        <translation>As configurações padrão</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Máquina</translation>
    </message>
    <message>
        <source>All swaths lie in the same places.</source>
        <translation>Todas as passadas estão nos mesmos lugares.</translation>
    </message>
    <message numerus="yes">
        <source>%n swath(s) of the other plan lie elsewhere.</source>
        <translation>
            <numerusform>%n passada do outro plano está em outro lugar.</numerusform>
            <numerusform>%n passadas do outro plano estão em outros lugares.</numerusform>
        </translation>
    </message>
    <message>
        <source>Take the standard settings</source>
        <translation>Usar as configurações padrão</translation>
    </message>
    <message>
        <source>Inside the headland</source>
        <translation>Interior do talhão</translation>
    </message>
    <message>
        <source>Headland passes: %1 only in this plan, %2 only in the other.</source>
        <translation>Passadas de cabeceira: %1 só neste plano, %2 só no outro.</translation>
    </message>
    <message>
        <source>Turns and ways: %1 only in this plan, %2 only in the other.</source>
        <translation>Manobras e trajetos: %1 só neste plano, %2 só no outro.</translation>
    </message>
    <message>
        <source>All headland passes lie in the same places.</source>
        <translation>Todas as passadas de cabeceira ficam nos mesmos lugares.</translation>
    </message>
    <message>
        <source>All turns and ways lie in the same places.</source>
        <translation>Todas as manobras e trajetos ficam nos mesmos lugares.</translation>
    </message>
</context>
<context>
    <name>furrow::Planning</name>
    <message>
        <source>Change the machine</source>
        <translation>Alterar a máquina</translation>
    </message>
    <message>
        <source>Reading %1 …</source>
        <translation>Lendo %1…</translation>
    </message>
    <message numerus="yes">
        <source>%n field(s) in this file</source>
        <translation>
            <numerusform>%n talhão neste arquivo</numerusform>
            <numerusform>%n talhões neste arquivo</numerusform>
        </translation>
    </message>
    <message>
        <source>Planning …</source>
        <translation>Planejando…</translation>
    </message>
    <message>
        <source>No plan</source>
        <translation>Sem plano</translation>
    </message>
    <message>
        <source>Plan ready · %1 ms</source>
        <translation>Plano pronto · %1 ms</translation>
    </message>
    <message>
        <source>Plan ready · %1 s</source>
        <translation>Plano pronto · %1 s</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>Change: %1</source>
        <translation>Alterar: %1</translation>
    </message>
    <message>
        <source>Draft · planning …</source>
        <translation>Rascunho · planejando…</translation>
    </message>
    <message>
        <source>Draft · the whole plan follows when you let go</source>
        <translation>Rascunho · o plano completo vem ao soltar</translation>
    </message>
    <message>
        <source>Out of date · this is a draft</source>
        <translation>Desatualizado · este é um rascunho</translation>
    </message>
    <message>
        <source>Out of date · this is the plan before the change</source>
        <translation>Desatualizado · este é o plano anterior à alteração</translation>
    </message>
    <message>
        <source>Stopped · there is no plan</source>
        <translation>Parado · não há plano</translation>
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
        <translation>Desatualizado · este é um primeiro plano</translation>
    </message>
    <message>
        <source>First plan · being improved …</source>
        <translation>Primeiro plano · sendo melhorado…</translation>
    </message>
    <message>
        <source>First plan · comparing plan %1 …</source>
        <translation>Primeiro plano · comparando plano %1…</translation>
    </message>
    <message>
        <source>Planning … · comparing plan %1</source>
        <translation>Planejando… · comparando plano %1</translation>
    </message>
</context>
<context>
    <name>furrow::Printing</name>
    <message>
        <source>There is no field yet, and no plan to print.</source>
        <translation>Ainda não há talhão nem plano para imprimir.</translation>
    </message>
    <message>
        <source>The plan is still being made. It can be printed when it is finished.</source>
        <translation>O plano ainda está sendo feito. Poderá ser impresso quando estiver pronto.</translation>
    </message>
    <message>
        <source>The plan is out of date. Plan again to print it.</source>
        <translation>O plano está desatualizado. Planeje de novo para imprimi-lo.</translation>
    </message>
    <message>
        <source>There is no plan to print. The message on the map says why.</source>
        <translation>Não há plano para imprimir. A mensagem no mapa diz por quê.</translation>
    </message>
    <message>
        <source>Work order</source>
        <translation>Ordem de serviço</translation>
    </message>
    <message>
        <source>Work orders</source>
        <translation>Ordens de serviço</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Gravado: %1</translation>
    </message>
    <message>
        <source>The printer %1 did not take the pages.</source>
        <translation>A impressora %1 não aceitou as páginas.</translation>
    </message>
    <message>
        <source>Look whether it is on, or save a PDF and print that.</source>
        <translation>Veja se está ligada, ou salve um PDF e imprima-o.</translation>
    </message>
    <message>
        <source>Sent to %1</source>
        <translation>Enviado para %1</translation>
    </message>
</context>
<context>
    <name>furrow::ProjectFiles</name>
    <message>
        <source>Your last work was not saved. Here it is again.</source>
        <translation>O último trabalho não foi salvo. Aqui está ele.</translation>
    </message>
    <message>
        <source>Changes of “%1” were not saved. Here they are again.</source>
        <translation>As alterações de “%1” não foram salvas. Aqui estão elas.</translation>
    </message>
    <message>
        <source>It is kept in the file all the same.</source>
        <translation>Mesmo assim continua no arquivo.</translation>
    </message>
    <message>
        <source>Restore changes that were not saved</source>
        <translation>Recuperar alterações não salvas</translation>
    </message>
    <message>
        <source>Another program changed “%1” while changes of yours were not saved. Yours are shown; undo shows the file.</source>
        <translation>Outro programa alterou “%1” enquanto havia alterações suas não salvas. As suas são mostradas; desfazer mostra o arquivo.</translation>
    </message>
    <message>
        <source>Another program has changed “%1” since it was opened here.</source>
        <translation>Outro programa alterou “%1” desde que foi aberto aqui.</translation>
    </message>
    <message>
        <source>Save over it, or save yours under another name.</source>
        <translation>Substitua-o ou salve o seu com outro nome.</translation>
    </message>
    <message>
        <source>Farm</source>
        <translation>Fazenda</translation>
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
        <translation>Isto não é um comprimento. Digite por exemplo 7,3 m, 24 ft ou 10&apos;6&quot;.</translation>
    </message>
    <message>
        <source>This is not an area. Type it like 12.5 ha or 30 ac.</source>
        <translation>Isto não é uma área. Digite por exemplo 12,5 ha ou 30 ac.</translation>
    </message>
    <message>
        <source>This is not a speed. Type it like 8 km/h or 5 mph.</source>
        <translation>Isto não é uma velocidade. Digite por exemplo 8 km/h ou 5 mph.</translation>
    </message>
    <message>
        <source>This is not an angle. Type it in degrees, like 87.5.</source>
        <translation>Isto não é um ângulo. Digite em graus, por exemplo 87,5.</translation>
    </message>
    <message>
        <source>This is not a number.</source>
        <translation>Isto não é um número.</translation>
    </message>
    <message>
        <source>This is not a whole number.</source>
        <translation>Isto não é um número inteiro.</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>Type something from %1 to %2.</source>
        <translation>Digite um valor de %1 a %2.</translation>
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
        <translation>Isto não é um tempo. Digite como 45 s ou 2 min.</translation>
    </message>
</context>
<context>
    <name>furrow::RecentFiles</name>
    <message numerus="yes">
        <source>%n field(s)</source>
        <translation>
            <numerusform>%n talhão</numerusform>
            <numerusform>%n talhões</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>furrow::ReviewModel</name>
    <message>
        <source>Only a finished plan of what the panels show can be sent.</source>
        <translation>Só um plano pronto do que os painéis mostram pode ser enviado.</translation>
    </message>
    <message>
        <source>Approved: %1</source>
        <translation>Aprovado: %1</translation>
    </message>
    <message>
        <source>Changes wanted: %1</source>
        <translation>Mudanças desejadas: %1</translation>
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
        <translation>Enviar para revisão…</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>Comentário</translation>
    </message>
    <message>
        <source>Remove a comment</source>
        <translation>Remover um comentário</translation>
    </message>
    <message>
        <source>Settle a comment</source>
        <translation>Resolver um comentário</translation>
    </message>
    <message>
        <source>Open a comment again</source>
        <translation>Reabrir um comentário</translation>
    </message>
    <message>
        <source>Approve the plan</source>
        <translation>Aprovar o plano</translation>
    </message>
    <message>
        <source>Ask for changes</source>
        <translation>Pedir mudanças</translation>
    </message>
    <message>
        <source>Take the verdict back</source>
        <translation>Retirar o parecer</translation>
    </message>
    <message>
        <source>review</source>
        <translation>revisão</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Send for review</source>
        <translation>Enviar para revisão</translation>
    </message>
    <message>
        <source>Written: %1. Whoever has Furrow can open it, comment on it and send it back.</source>
        <translation>Escrito: %1. Quem tem o Furrow pode abrir, comentar e devolver.</translation>
    </message>
    <message>
        <source>Take in a review</source>
        <translation>Incorporar uma revisão</translation>
    </message>
    <message numerus="yes">
        <source>%n new comment(s)</source>
        <translation>
            <numerusform>%n comentário novo</numerusform>
            <numerusform>%n comentários novos</numerusform>
        </translation>
    </message>
    <message>
        <source>The review was brought up to date</source>
        <translation>A revisão foi atualizada</translation>
    </message>
    <message>
        <source>Nothing new in this review</source>
        <translation>Nada de novo nesta revisão</translation>
    </message>
    <message>
        <source>%1. The plan has changed since it was sent.</source>
        <translation>%1. O plano mudou desde que foi enviado.</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1.</translation>
    </message>
    <message>
        <source>Edit a comment</source>
        <translation>Editar um comentário</translation>
    </message>
</context>
<context>
    <name>furrow::StepsModel</name>
    <message numerus="yes">
        <source>%1 but for %n edge(s)</source>
        <translation>
            <numerusform>%1 exceto em %n lado</numerusform>
            <numerusform>%1 exceto em %n lados</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 inside</source>
        <translation>interior %1</translation>
    </message>
    <message numerus="yes">
        <source>%n pass(es)</source>
        <translation>
            <numerusform>%n passada</numerusform>
            <numerusform>%n passadas</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n block(s)</source>
        <translation>
            <numerusform>%n subtalhão</numerusform>
            <numerusform>%n subtalhões</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n swath(s)</source>
        <translation>
            <numerusform>%n passada</numerusform>
            <numerusform>%n passadas</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 with turns on the spot</source>
        <translation>%1 com manobras no lugar</translation>
    </message>
    <message numerus="yes">
        <source>%n turn(s)</source>
        <translation>
            <numerusform>%n manobra</numerusform>
            <numerusform>%n manobras</numerusform>
        </translation>
    </message>
    <message>
        <source>No usable boundary</source>
        <translation>Sem limite utilizável</translation>
    </message>
    <message>
        <source>No field yet</source>
        <translation>Ainda sem talhão</translation>
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
            <numerusform>%n vazio</numerusform>
            <numerusform>%n vazios</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n boundary point(s)</source>
        <translation>
            <numerusform>%n ponto do limite</numerusform>
            <numerusform>%n pontos do limite</numerusform>
        </translation>
    </message>
    <message>
        <source>The message on the map says why</source>
        <translation>A mensagem no mapa diz por quê</translation>
    </message>
    <message>
        <source>Open a file or draw a boundary</source>
        <translation>Abra um arquivo ou desenhe um limite</translation>
    </message>
    <message>
        <source>%1 wide</source>
        <translation>%1 de largura</translation>
    </message>
    <message>
        <source>%1 radius</source>
        <translation>%1 de raio</translation>
    </message>
    <message>
        <source>Field</source>
        <translation>Talhão</translation>
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
        <translation>Nada para verificar ainda</translation>
    </message>
    <message>
        <source>Planning …</source>
        <translation>Planejando…</translation>
    </message>
    <message>
        <source>No plan</source>
        <translation>Sem plano</translation>
    </message>
    <message>
        <source>Out of date</source>
        <translation>Desatualizado</translation>
    </message>
    <message>
        <source>Plan again to check what the panels show</source>
        <translation>Planejar de novo para verificar isto</translation>
    </message>
    <message>
        <source>No problems</source>
        <translation>Sem problemas</translation>
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
        <translation>Verificação</translation>
    </message>
    <message>
        <source>proved: no order is better</source>
        <translation>a melhor, provado</translation>
    </message>
    <message>
        <source>turns within %1 of the best</source>
        <translation>manobras: +%1 no máximo</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>To a stick, to files or on paper</source>
        <translation>Para pen drive, arquivos, papel</translation>
    </message>
    <message>
        <source>No plan to export yet</source>
        <translation>Ainda não há plano para exportar</translation>
    </message>
    <message>
        <source>Waits for the finished plan</source>
        <translation>Aguarda o plano pronto</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportar</translation>
    </message>
    <message>
        <source>First plan, being improved</source>
        <translation>Primeiro plano, sendo melhorado</translation>
    </message>
    <message>
        <source>Only the finished plan is checked</source>
        <translation>Só o plano pronto é verificado</translation>
    </message>
    <message>
        <source>Until then the map shows the plan before</source>
        <translation>Até lá o mapa mostra o plano anterior</translation>
    </message>
</context>
<context>
    <name>furrow::StickExport</name>
    <message>
        <source>%1 free of %2</source>
        <translation>%1 livres de %2</translation>
    </message>
    <message>
        <source>Writing …</source>
        <translation>Gravando…</translation>
    </message>
    <message>
        <source>every byte was read back, and the plan read from there is this plan.</source>
        <translation>cada byte foi relido, e o plano lido de lá é este plano.</translation>
    </message>
    <message>
        <source>every byte was read back and is as written.</source>
        <translation>cada byte foi relido e está como foi gravado.</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Gravado: %1</translation>
    </message>
    <message>
        <source>Safe to unplug: %1</source>
        <translation>O pen drive pode ser retirado: %1</translation>
    </message>
    <message>
        <source>What was there before is kept as %1.</source>
        <translation>O que havia antes fica guardado como %1.</translation>
    </message>
    <message>
        <source>Writing was stopped, because the plan was changed meanwhile.</source>
        <translation>A gravação foi interrompida porque o plano mudou nesse meio-tempo.</translation>
    </message>
    <message>
        <source>Write it again when the plan is finished.</source>
        <translation>Grave de novo quando o plano estiver pronto.</translation>
    </message>
    <message>
        <source>every byte was read back, and the fields read from there are these.</source>
        <translation>cada byte foi lido de volta, e os talhões lidos dali são estes.</translation>
    </message>
</context>
<context>
    <name>furrow::SwathOrder</name>
    <message>
        <source>Search the order of the other swaths</source>
        <translation>Buscar a ordem das outras passadas</translation>
    </message>
    <message>
        <source>Search the order</source>
        <translation>Buscar a ordem</translation>
    </message>
    <message>
        <source>Change the order of swaths</source>
        <translation>Mudar a ordem das passadas</translation>
    </message>
</context>
<context>
    <name>furrow::TroubleReport</name>
    <message>
        <source>The report could not be written: %1</source>
        <translation>Não foi possível gravar o relatório: %1</translation>
    </message>
    <message>
        <source>The report is in %1.</source>
        <translation>O relatório está em %1.</translation>
    </message>
</context>
</TS>
