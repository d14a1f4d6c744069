<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>PlotReadings</name>
    <message numerus="yes">
        <source>, %n gaps</source>
        <translation>
            <numerusform>, %n gap</numerusform>
            <numerusform>, %n gaps</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mb::BannerStack</name>
    <message numerus="yes">
        <source>%n more notices</source>
        <translation>
            <numerusform>%n more notice</numerusform>
            <numerusform>%n more notices</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mb::GainsWriteRow</name>
    <message numerus="yes">
        <source>%n value(s)</source>
        <translation>
            <numerusform>%n value</numerusform>
            <numerusform>%n values</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mb::HeaderBar</name>
    <message numerus="yes">
        <source>%n links</source>
        <translation>
            <numerusform>%n link</numerusform>
            <numerusform>%n links</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n notices</source>
        <translation>
            <numerusform>%n notice</numerusform>
            <numerusform>%n notices</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mb::JournalCard</name>
    <message numerus="yes">
        <source>%n entries wait for the server</source>
        <translation>
            <numerusform>%n entry waits for the server</numerusform>
            <numerusform>%n entries wait for the server</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n units of this run are in it</source>
        <translation>
            <numerusform>%n unit of this run is in it</numerusform>
            <numerusform>%n units of this run are in it</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mb::KeepBar</name>
    <message numerus="yes">
        <source>%1 · %n more change(s) after this one</source>
        <translation>
            <numerusform>%1 · %n more change after this one</numerusform>
            <numerusform>%1 · %n more changes after this one</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mb::ProjectDesk</name>
    <message numerus="yes">
        <source>%n unit(s) saved into %1</source>
        <translation>
            <numerusform>%n unit saved into %1</numerusform>
            <numerusform>%n units saved into %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mb::QueueBar</name>
    <message numerus="yes">
        <source>Ended with %n unit(s) to go</source>
        <translation>
            <numerusform>Ended with %n unit to go</numerusform>
            <numerusform>Ended with %n units to go</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mb::ReportText</name>
    <message numerus="yes">
        <source>%n in the unit, read back</source>
        <translation>
            <numerusform>%n in the unit, read back</numerusform>
            <numerusform>%n in the unit, read back</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mb::SessionDesk</name>
    <message numerus="yes">
        <source>%n unit(s)</source>
        <translation>
            <numerusform>%n unit</numerusform>
            <numerusform>%n units</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mb::StoryCard</name>
    <message numerus="yes">
        <source>about %n min</source>
        <translation>
            <numerusform>about %n min</numerusform>
            <numerusform>about %n min</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mb::TimelineList</name>
    <message numerus="yes">
        <source>%n differ</source>
        <translation>
            <numerusform>%n differs</numerusform>
            <numerusform>%n differ</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mb::TrialList</name>
    <message numerus="yes">
        <source>%n, every run is kept</source>
        <translation>
            <numerusform>%n, every run is kept</numerusform>
            <numerusform>%n, every run is kept</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mb::UnitChecks</name>
    <message numerus="yes">
        <source>%n units answer, one at a time</source>
        <translation>
            <numerusform>%n unit answers</numerusform>
            <numerusform>%n units answer, one at a time</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mb::UnitStates</name>
    <message numerus="yes">
        <source>%n values</source>
        <translation>
            <numerusform>%n value</numerusform>
            <numerusform>%n values</numerusform>
        </translation>
    </message>
</context>
</TS>
