<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>BestPlanDialog</name>
    <message numerus="yes">
        <source>%n alternative(s) were planned.</source>
        <translation>
            <numerusform>%n alternative was planned.</numerusform>
            <numerusform>%n alternatives were planned.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ChoiceTable</name>
    <message numerus="yes">
        <source>%n other(s) are slower still, or cannot be driven.</source>
        <translation>
            <numerusform>%n other is slower still, or cannot be driven.</numerusform>
            <numerusform>%n others are slower still, or cannot be driven.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ExportChecks</name>
    <message numerus="yes">
        <source>%n check(s) passed: nothing in the files that receivers stumble over.</source>
        <translation>
            <numerusform>%n check passed: nothing in the files that receivers stumble over.</numerusform>
            <numerusform>%n checks passed: nothing in the files that receivers stumble over.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ExportDialog</name>
    <message numerus="yes">
        <source>%n problem(s) in this plan: it cannot be driven as drawn. The files say so too.</source>
        <translation>
            <numerusform>%n problem in this plan: it cannot be driven as drawn. The files say so too.</numerusform>
            <numerusform>%n problems in this plan: it cannot be driven as drawn. The files say so too.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ExportStickPage</name>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>and %n more</numerusform>
            <numerusform>and %n more</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>FarmPanel</name>
    <message numerus="yes">
        <source>Plan %n field(s)</source>
        <translation>
            <numerusform>Plan %n field</numerusform>
            <numerusform>Plan %n fields</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>FieldChooser</name>
    <message numerus="yes">
        <source>Which of the %n field(s)?</source>
        <translation>
            <numerusform>Is it this %n field?</numerusform>
            <numerusform>Which of the %n fields?</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>FieldsToExport</name>
    <message numerus="yes">
        <source>%1 and %n more</source>
        <translation>
            <numerusform>%1 and %n more</numerusform>
            <numerusform>%1 and %n more</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Inspector</name>
    <message numerus="yes">
        <source>A piece of the field whose %n swath(s) are driven together.</source>
        <translation>
            <numerusform>A piece of the field with %n swath.</numerusform>
            <numerusform>A piece of the field whose %n swaths are driven together.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>PrintDialog</name>
    <message numerus="yes">
        <source>%n problem(s) in this plan: it cannot be driven as drawn. The pages say so too.</source>
        <translation>
            <numerusform>%n problem in this plan: it cannot be driven as drawn. The pages say so too.</numerusform>
            <numerusform>%n problems in this plan: it cannot be driven as drawn. The pages say so too.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n field(s) of the list</source>
        <translation>
            <numerusform>%n field of the list</numerusform>
            <numerusform>%n fields of the list</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ResultsPanel</name>
    <message numerus="yes">
        <source>%n finding(s)</source>
        <translation>
            <numerusform>%n finding</numerusform>
            <numerusform>%n findings</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n problem(s)</source>
        <translation>
            <numerusform>%n problem</numerusform>
            <numerusform>%n problems</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n to look at</source>
        <translation>
            <numerusform>%n to look at</numerusform>
            <numerusform>%n to look at</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ReviewSection</name>
    <message numerus="yes">
        <source>Review · %n open comment(s)</source>
        <translation>
            <numerusform>Review · %n open comment</numerusform>
            <numerusform>Review · %n open comments</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>WorkOrderPages</name>
    <message numerus="yes">
        <source>Not drivable: %n problem(s)</source>
        <translation>
            <numerusform>Not drivable: %n problem</numerusform>
            <numerusform>Not drivable: %n problems</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pass(es)</source>
        <translation>
            <numerusform>%n pass</numerusform>
            <numerusform>%n passes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>and %n more, in the window and in summary.json</source>
        <translation>
            <numerusform>and %n more, in the window and in summary.json</numerusform>
            <numerusform>and %n more, in the window and in summary.json</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n field(s)</source>
        <translation>
            <numerusform>%n field</numerusform>
            <numerusform>%n fields</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>furrow::CellSteps</name>
    <message numerus="yes">
        <source>%n block(s), %1</source>
        <translation>
            <numerusform>%n block, %1</numerusform>
            <numerusform>%n blocks, %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>furrow::ExportModel</name>
    <message numerus="yes">
        <source>%n file(s) written to %1</source>
        <translation>
            <numerusform>%n file written to %1</numerusform>
            <numerusform>%n files written to %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n field(s)</source>
        <translation>
            <numerusform>%n field</numerusform>
            <numerusform>%n fields</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n field(s) written to %1</source>
        <translation>
            <numerusform>%n field written to %1</numerusform>
            <numerusform>%n fields written to %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n file(s)</source>
        <translation>
            <numerusform>%n file</numerusform>
            <numerusform>%n files</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>furrow::FarmList</name>
    <message numerus="yes">
        <source>Plan %n field(s) alike</source>
        <translation>
            <numerusform>Plan %n field alike</numerusform>
            <numerusform>Plan %n fields alike</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Add a plan to %n field(s)</source>
        <translation>
            <numerusform>Add a plan to %n field</numerusform>
            <numerusform>Add a plan to %n fields</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n problem(s)</source>
        <translation>
            <numerusform>%n problem</numerusform>
            <numerusform>%n problems</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n field(s)</source>
        <translation>
            <numerusform>%n field</numerusform>
            <numerusform>%n fields</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n field(s)</source>
        <translation>
            <numerusform>%1 of %n field</numerusform>
            <numerusform>%1 of %n fields</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>furrow::FarmPlans</name>
    <message numerus="yes">
        <source>%n field(s) planned</source>
        <translation>
            <numerusform>%n field planned</numerusform>
            <numerusform>%n fields planned</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n with problems</source>
        <translation>
            <numerusform>%n with problems</numerusform>
            <numerusform>%n with problems</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n without a plan</source>
        <translation>
            <numerusform>%n without a plan</numerusform>
            <numerusform>%n without a plan</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>furrow::FieldEditor</name>
    <message numerus="yes">
        <source>%n field(s) stay as they are: %1.</source>
        <translation>
            <numerusform>%n field stays as it is: %1.</numerusform>
            <numerusform>%n fields stay as they are: %1.</numerusform>
        </translation>
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
            <numerusform>%n track</numerusform>
            <numerusform>%n tracks</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>furrow::FieldOpener</name>
    <message numerus="yes">
        <source>%n file(s)</source>
        <translation>
            <numerusform>%n file</numerusform>
            <numerusform>%n files</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Add %n field(s)</source>
        <translation>
            <numerusform>Add %n field</numerusform>
            <numerusform>Add %n fields</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>furrow::FindingsModel</name>
    <message numerus="yes">
        <source>%n problem(s)</source>
        <translation>
            <numerusform>%n problem</numerusform>
            <numerusform>%n problems</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>furrow::HeadingChoice</name>
    <message numerus="yes">
        <source>%n swath(s)</source>
        <translation>
            <numerusform>%n swath</numerusform>
            <numerusform>%n swaths</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>furrow::ParameterModel</name>
    <message numerus="yes">
        <source>%n place(s) on the map</source>
        <translation>
            <numerusform>%n place on the map</numerusform>
            <numerusform>%n places on the map</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>a line of %n point(s)</source>
        <translation>
            <numerusform>a line of %n point</numerusform>
            <numerusform>a line of %n points</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n line(s)</source>
        <translation>
            <numerusform>%n line</numerusform>
            <numerusform>%n lines</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>furrow::PlanComparison</name>
    <message numerus="yes">
        <source>%n swath(s) of the other plan lie elsewhere.</source>
        <translation>
            <numerusform>%n swath of the other plan lies elsewhere.</numerusform>
            <numerusform>%n swaths of the other plan lie elsewhere.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>furrow::Planning</name>
    <message numerus="yes">
        <source>%n field(s) in this file</source>
        <translation>
            <numerusform>%n field in this file</numerusform>
            <numerusform>%n fields in this file</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n problem(s)</source>
        <translation>
            <numerusform>%n problem</numerusform>
            <numerusform>%n problems</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>furrow::RecentFiles</name>
    <message numerus="yes">
        <source>%n field(s)</source>
        <translation>
            <numerusform>%n field</numerusform>
            <numerusform>%n fields</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>furrow::ReviewModel</name>
    <message numerus="yes">
        <source>%n new comment(s)</source>
        <translation>
            <numerusform>%n new comment</numerusform>
            <numerusform>%n new comments</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>furrow::StepsModel</name>
    <message numerus="yes">
        <source>%1 but for %n edge(s)</source>
        <translation>
            <numerusform>%1 but for %n edge</numerusform>
            <numerusform>%1 but for %n edges</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pass(es)</source>
        <translation>
            <numerusform>%n pass</numerusform>
            <numerusform>%n passes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n block(s)</source>
        <translation>
            <numerusform>%n block</numerusform>
            <numerusform>%n blocks</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n swath(s)</source>
        <translation>
            <numerusform>%n swath</numerusform>
            <numerusform>%n swaths</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n turn(s)</source>
        <translation>
            <numerusform>%n turn</numerusform>
            <numerusform>%n turns</numerusform>
        </translation>
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
            <numerusform>%n hole</numerusform>
            <numerusform>%n holes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n boundary point(s)</source>
        <translation>
            <numerusform>%n boundary point</numerusform>
            <numerusform>%n boundary points</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n problem(s)</source>
        <translation>
            <numerusform>%n problem</numerusform>
            <numerusform>%n problems</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n note(s)</source>
        <translation>
            <numerusform>%n note</numerusform>
            <numerusform>%n notes</numerusform>
        </translation>
    </message>
</context>
</TS>
