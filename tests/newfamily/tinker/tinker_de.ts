<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en">
<context>
    <name>table</name>
    <message>
        <source>Tinkered loop</source>
        <translation>Gebastelter Regelkreis</translation>
    </message>
    <message>
        <source>Tinkered stiffness</source>
        <translation>Gebastelte Steifigkeit</translation>
    </message>
    <message>
        <source>Tinkered damping</source>
        <translation>Gebastelte Dämpfung</translation>
    </message>
    <message>
        <source>Tinkered limit</source>
        <translation>Gebastelte Grenze</translation>
    </message>
    <message>
        <source>Tinkered end switch</source>
        <translation>Gebastelter Endschalter</translation>
    </message>
    <message>
        <source>tinkered end switch holds</source>
        <translation>gebastelter Endschalter hält</translation>
    </message>
    <message>
        <source>tinkered to a standstill</source>
        <translation>stillgebastelt</translation>
    </message>
    <message>
        <source>tinkered handle</source>
        <translation>gebastelte Kurbel</translation>
    </message>
    <message>
        <source>Turn the tinkered handle</source>
        <translation>Drehen Sie die gebastelte Kurbel</translation>
    </message>
    <message>
        <source>Drawing: a tinkered handle</source>
        <translation>Zeichnung: eine gebastelte Kurbel</translation>
    </message>
    <message>
        <source>A tinkered unit that is cut waits in its loader.</source>
        <translation>Ein gebasteltes Gerät, das unterbrochen wird, wartet in seinem Lader.</translation>
    </message>
</context>
</TS>
