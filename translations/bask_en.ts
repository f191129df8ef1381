<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>bask::AlarmHistoryDialog</name>
    <message numerus="yes">
        <source>No alarm was raised in %n run(s).</source>
        <translation>
            <numerusform>No alarm was raised in %n run.</numerusform>
            <numerusform>No alarm was raised in %n runs.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Alarms in %1 of %n run(s)</source>
        <translation>
            <numerusform>Alarms in %1 of %n run</numerusform>
            <numerusform>Alarms in %1 of %n runs</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n recording(s) could not be read: %1</source>
        <translation>
            <numerusform>%n recording could not be read: %1</numerusform>
            <numerusform>%n recordings could not be read: %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1, and %n time(s) while nothing was recorded</source>
        <comment>%1: Alarms in 2 of 5 runs</comment>
        <translation>
            <numerusform>%1, and %n time while nothing was recorded</numerusform>
            <numerusform>%1, and %n times while nothing was recorded</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n line(s) with alarms that were raised while nothing was recorded could not be read.</source>
        <translation>
            <numerusform>%n line with alarms that were raised while nothing was recorded could not be read.</numerusform>
            <numerusform>%n lines with alarms that were raised while nothing was recorded could not be read.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bask::AlarmList</name>
    <message numerus="yes">
        <source>, %n follow(s)</source>
        <comment>from this alarm</comment>
        <translation>
            <numerusform>, %n follows</numerusform>
            <numerusform>, %n follow</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bask::CalibrationAge</name>
    <message numerus="yes">
        <source>%n minute(s) ago</source>
        <translation>
            <numerusform>%n minute ago</numerusform>
            <numerusform>%n minutes ago</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n hour(s) ago</source>
        <translation>
            <numerusform>%n hour ago</numerusform>
            <numerusform>%n hours ago</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n day(s) ago</source>
        <translation>
            <numerusform>%n day ago</numerusform>
            <numerusform>%n days ago</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bask::ComparisonView</name>
    <message numerus="yes">
        <source>Copied %n row(s)</source>
        <translation>
            <numerusform>Copied %n row</numerusform>
            <numerusform>Copied %n rows</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bask::DeviceCard</name>
    <message numerus="yes">
        <source>%n answer(s) discarded</source>
        <translation>
            <numerusform>%n answer discarded</numerusform>
            <numerusform>%n answers discarded</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bask::RecipeControl</name>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>and %n more</numerusform>
            <numerusform>and %n more</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bask::RecipePanel</name>
    <message numerus="yes">
        <source>%n step(s), at most %1</source>
        <translation>
            <numerusform>%n step, at most %1</numerusform>
            <numerusform>%n steps, at most %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bask::ReviewDesk</name>
    <message numerus="yes">
        <source>It is shown already, or there are %n runs over the open one: take one away first.</source>
        <translation>
            <numerusform>It is shown already, or there is %n run over the open one: take it away first.</numerusform>
            <numerusform>It is shown already, or there are %n runs over the open one: take one away first.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bask::RunReport</name>
    <message numerus="yes">
        <source>%1 (min:s), %n sample(s)</source>
        <translation>
            <numerusform>%1 (min:s), %n sample</numerusform>
            <numerusform>%1 (min:s), %n samples</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 pixels, fx = %2 px, fy = %3 px, %4, %n view(s)</source>
        <translation>
            <numerusform>%1 pixels, fx = %2 px, fy = %3 px, %4, %n view</numerusform>
            <numerusform>%1 pixels, fx = %2 px, fy = %3 px, %4, %n views</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n alarm(s)</source>
        <translation>
            <numerusform>%n alarm</numerusform>
            <numerusform>%n alarms</numerusform>
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
        <source>%n marker(s) of dictionary %1</source>
        <translation>
            <numerusform>%n marker of dictionary %1</numerusform>
            <numerusform>%n markers of dictionary %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n more row(s) are in the session file; bask export --csv lists them.</source>
        <translation>
            <numerusform>%n more row is in the session file; bask export --csv lists it.</numerusform>
            <numerusform>%n more rows are in the session file; bask export --csv lists them.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bask::SessionExport</name>
    <message numerus="yes">
        <source>%n file(s) written to %1</source>
        <translation>
            <numerusform>%n file written to %1</numerusform>
            <numerusform>%n files written to %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bask::SessionList</name>
    <message numerus="yes">
        <source>%1 of %n session(s)</source>
        <translation>
            <numerusform>%1 of %n session</numerusform>
            <numerusform>%1 of %n sessions</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n session(s)</source>
        <translation>
            <numerusform>%n session</numerusform>
            <numerusform>%n sessions</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sample(s)</source>
        <translation>
            <numerusform>%n sample</numerusform>
            <numerusform>%n samples</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bask::StatusLine</name>
    <message numerus="yes">
        <source>What the run does is published (View &gt; Monitoring): %n message(s)</source>
        <translation>
            <numerusform>What the run does is published (View &gt; Monitoring): %n message</numerusform>
            <numerusform>What the run does is published (View &gt; Monitoring): %n messages</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n event(s) were not published</source>
        <translation>
            <numerusform>%n event was not published</numerusform>
            <numerusform>%n events were not published</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bask::ThermalHistogramPlot</name>
    <message numerus="yes">
        <source>%1: %n pixel(s)</source>
        <translation>
            <numerusform>%1: %n pixel</numerusform>
            <numerusform>%1: %n pixels</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bask::ThermalPictureView</name>
    <message numerus="yes">
        <source>%n picture(s) left out</source>
        <translation>
            <numerusform>%n picture left out</numerusform>
            <numerusform>%n pictures left out</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bask::TracePlot</name>
    <message numerus="yes">
        <source>%n more without a number</source>
        <comment>moments that are close to another one</comment>
        <translation>
            <numerusform>%n more without a number</numerusform>
            <numerusform>%n more without a number</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>bask::TrafficModel</name>
    <message numerus="yes">
        <source>%1… (%n bytes)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
</context>
</TS>
