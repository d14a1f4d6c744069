<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>DeviceActions</name>
    <message>
        <source>Identify (blink)</source>
        <translation>Identifizieren (blinken)</translation>
    </message>
    <message>
        <source>blinks for 5 s</source>
        <translation>blinkt 5 s lang</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>Umbenennen…</translation>
    </message>
    <message>
        <source>Assign another number…</source>
        <translation>Andere Nummer zuweisen…</translation>
    </message>
    <message>
        <source>Read and clear faults</source>
        <translation>Fehler lesen und löschen</translation>
    </message>
    <message>
        <source>faults read and cleared</source>
        <translation>Fehler gelesen und gelöscht</translation>
    </message>
    <message>
        <source>Copy %1</source>
        <translation>%1 kopieren</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation>%1 umbenennen</translation>
    </message>
    <message>
        <source>Name, 1 … 64 characters (some tools show only 28):</source>
        <translation>Name, 1 … 64 Zeichen (manche Werkzeuge zeigen nur 28):</translation>
    </message>
    <message>
        <source>renamed to %1</source>
        <translation>umbenannt in %1</translation>
    </message>
    <message>
        <source>Number of %1</source>
        <translation>Nummer von %1</translation>
    </message>
    <message>
        <source>New number, 1 … %1. %2 is the next free one on this link:</source>
        <translation>Neue Nummer, 1 … %1. %2 ist die nächste freie an dieser Verbindung:</translation>
    </message>
    <message>
        <source>number %1 is taken on this link; nothing was sent</source>
        <translation>Nummer %1 ist an dieser Verbindung vergeben; nichts wurde gesendet</translation>
    </message>
    <message>
        <source>answers as number %1 now</source>
        <translation>antwortet jetzt als Nummer %1</translation>
    </message>
    <message>
        <source>Add a link</source>
        <translation>Verbindung hinzufügen</translation>
    </message>
    <message>
        <source>Link address, such as socketcan:can0 or sim:can?loss=0.01:</source>
        <translation>Adresse der Verbindung, etwa socketcan:can0 oder sim:can?loss=0.01:</translation>
    </message>
</context>
<context>
    <name>DeviceText</name>
    <message>
        <source>No answer: %1</source>
        <translation>Keine Antwort: %1</translation>
    </message>
    <message>
        <source>The device refused: %1</source>
        <translation>Vom Gerät abgelehnt: %1</translation>
    </message>
    <message>
        <source>Unexpected answer: %1</source>
        <translation>Unerwartete Antwort: %1</translation>
    </message>
    <message>
        <source>Differs: %1</source>
        <translation>Abweichung: %1</translation>
    </message>
    <message>
        <source>Link lost: %1</source>
        <translation>Verbindung verloren: %1</translation>
    </message>
    <message>
        <source>Not possible: %1</source>
        <translation>Nicht möglich: %1</translation>
    </message>
    <message>
        <source>Cancelled</source>
        <translation>Abgebrochen</translation>
    </message>
    <message>
        <source>Not done: %1</source>
        <translation>Nicht ausgeführt: %1</translation>
    </message>
    <message>
        <source>over-current</source>
        <translation>Überstrom</translation>
    </message>
    <message>
        <source>over-temperature</source>
        <translation>Übertemperatur</translation>
    </message>
    <message>
        <source>under-voltage</source>
        <translation>Unterspannung</translation>
    </message>
    <message>
        <source>gate driver</source>
        <translation>Gatetreiber</translation>
    </message>
    <message>
        <source>communication</source>
        <translation>Kommunikation</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>duty</source>
        <translation>Tastgrad</translation>
    </message>
    <message>
        <source>velocity</source>
        <translation>Drehzahl</translation>
    </message>
    <message>
        <source>position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>current</source>
        <translation>Strom</translation>
    </message>
    <message>
        <source>voltage</source>
        <translation>Spannung</translation>
    </message>
    <message>
        <source>follow</source>
        <translation>Folgen</translation>
    </message>
    <message>
        <source>profiled position</source>
        <translation>Positionsprofil</translation>
    </message>
    <message>
        <source>profiled velocity</source>
        <translation>Drehzahlprofil</translation>
    </message>
    <message>
        <source>busy</source>
        <translation>beschäftigt</translation>
    </message>
    <message>
        <source>two units, one number</source>
        <translation>zwei Geräte, eine Nummer</translation>
    </message>
    <message>
        <source>no number yet</source>
        <translation>noch ohne Nummer</translation>
    </message>
    <message>
        <source>bootloader, needs firmware</source>
        <translation>Firmware fehlt</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>keine Antwort</translation>
    </message>
    <message>
        <source>counts/s</source>
        <translation>counts/s</translation>
    </message>
    <message>
        <source>online</source>
        <translation>online</translation>
    </message>
    <message>
        <source>boot</source>
        <translation>Boot</translation>
    </message>
    <message>
        <source>2 ×</source>
        <translation>2 ×</translation>
    </message>
    <message>
        <source>Serial number %1</source>
        <translation>Seriennummer %1</translation>
    </message>
</context>
<context>
    <name>FileText</name>
    <message>
        <source>family “%1”</source>
        <translation>Familie „%1“</translation>
    </message>
    <message>
        <source>Parameter files (*.json)</source>
        <translation>Parameterdateien (*.json)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Choose another file.</source>
        <translation>Andere Datei wählen.</translation>
    </message>
    <message>
        <source>%1 is for %2, %3 is a %4.</source>
        <translation>%1 ist für %2, %3 ist ein %4.</translation>
    </message>
    <message>
        <source>Choose a file of this family. Nothing was changed.</source>
        <translation>Datei dieser Familie wählen. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>Nothing was changed.</source>
        <translation>Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>%1 is not a parameter file.</source>
        <translation>%1 ist keine Parameterdatei.</translation>
    </message>
    <message>
        <source>Choose a file that Export… or motorbenchctl get --file wrote.</source>
        <translation>Eine Datei wählen, die Export… oder motorbenchctl get --file schrieb.</translation>
    </message>
    <message>
        <source>%1 is for %2, which is not in this program.</source>
        <translation>%1 ist für %2, das dieses Programm nicht kennt.</translation>
    </message>
</context>
<context>
    <name>FrameText</name>
    <message>
        <source>remote</source>
        <translation>Remote</translation>
    </message>
    <message>
        <source>&apos;%1:&apos; is not known; msg, dev, id, fam and dir are</source>
        <translation>„%1:“ ist unbekannt; bekannt sind msg, dev, id, fam und dir</translation>
    </message>
</context>
<context>
    <name>GainText</name>
    <message>
        <source>count/100&#xa0;ms</source>
        <translation>count/100&#xa0;ms</translation>
    </message>
    <message>
        <source>duty/(A·s)</source>
        <translation>duty/(A·s)</translation>
    </message>
    <message>
        <source>duty·s/A</source>
        <translation>duty·s/A</translation>
    </message>
    <message>
        <source>duty/A</source>
        <translation>duty/A</translation>
    </message>
    <message>
        <source>duty/rad</source>
        <translation>duty/rad</translation>
    </message>
    <message>
        <source>duty/(rad·s)</source>
        <translation>duty/(rad·s)</translation>
    </message>
    <message>
        <source>duty/(rad/s²)</source>
        <translation>duty/(rad/s²)</translation>
    </message>
    <message>
        <source>duty/(rad/s)</source>
        <translation>duty/(rad/s)</translation>
    </message>
    <message>
        <source>count</source>
        <translation>count</translation>
    </message>
    <message>
        <source>A</source>
        <translation>A</translation>
    </message>
    <message>
        <source>throttle per %1 · loop</source>
        <translation>throttle je %1 · Zyklus</translation>
    </message>
    <message>
        <source>throttle per %1 / loop</source>
        <translation>throttle je %1 / Zyklus</translation>
    </message>
    <message>
        <source>throttle per %1</source>
        <translation>throttle je %1</translation>
    </message>
</context>
<context>
    <name>QLineEdit</name>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>&amp;Ausschneiden</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>&amp;Einfügen</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Select All</source>
        <translation>Alles auswählen</translation>
    </message>
</context>
<context>
    <name>QPlatformTheme</name>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>QShortcut</name>
    <message>
        <source>Ctrl</source>
        <translation>Strg</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Umschalt</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Leertaste</translation>
    </message>
</context>
<context>
    <name>SourceText</name>
    <message>
        <source>%1 Hz, %2 of %3 lost</source>
        <translation>%1 Hz, %2 von %3 verloren</translation>
    </message>
</context>
<context>
    <name>UnitText</name>
    <message>
        <source>rpm</source>
        <translation>1/min</translation>
    </message>
    <message>
        <source>counts/s</source>
        <translation>counts/s</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>counts</source>
        <translation>counts</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
</context>
<context>
    <name>ValueText</name>
    <message>
        <source>Enter %1.</source>
        <translation>%1 eingeben.</translation>
    </message>
    <message>
        <source>Enter %1, or a percentage such as %2.</source>
        <translation>%1 eingeben oder Prozent, etwa %2.</translation>
    </message>
    <message>
        <source>%1 is above %2.</source>
        <translation>%1 liegt über %2.</translation>
    </message>
    <message>
        <source>%1 is below %2.</source>
        <translation>%1 liegt unter %2.</translation>
    </message>
    <message>
        <source>%1 is not a whole number.</source>
        <translation>%1 ist keine ganze Zahl.</translation>
    </message>
    <message>
        <source>A number is missing.</source>
        <translation>Eine Zahl fehlt.</translation>
    </message>
    <message>
        <source>“%1” is not a number.</source>
        <translation>„%1“ ist keine Zahl.</translation>
    </message>
    <message>
        <source>on</source>
        <translation>ein</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>off or on</source>
        <translation>aus oder ein</translation>
    </message>
</context>
<context>
    <name>mb::Arming</name>
    <message>
        <source>nothing to arm</source>
        <translation>nichts bereit</translation>
    </message>
    <message>
        <source>arming off while busy</source>
        <translation>während einer Aufgabe nicht scharf</translation>
    </message>
    <message>
        <source>%1 cannot be armed</source>
        <translation>%1 lässt sich nicht scharf schalten</translation>
    </message>
    <message>
        <source>it is not heard</source>
        <translation>es ist nichts zu hören</translation>
    </message>
    <message>
        <source>not armed: %1</source>
        <translation>nicht scharf: %1</translation>
    </message>
    <message>
        <source>armed</source>
        <translation>scharf</translation>
    </message>
    <message>
        <source>STOP: %1</source>
        <translation>STOP: %1</translation>
    </message>
    <message>
        <source>disarmed after %1 min without motion</source>
        <translation>gesichert nach %1 min ohne Bewegung</translation>
    </message>
    <message>
        <source>the device is gone</source>
        <translation>das Gerät ist weg</translation>
    </message>
</context>
<context>
    <name>mb::Banner</name>
    <message>
        <source>Dismiss</source>
        <translation>Schließen</translation>
    </message>
</context>
<context>
    <name>mb::BannerStack</name>
    <message>
        <source>1 more notice</source>
        <translation>1 weitere Meldung</translation>
    </message>
    <message numerus="yes">
        <source>%n more notices</source>
        <translation>
            <numerusform>%n weitere Meldung</numerusform>
            <numerusform>%n weitere Meldungen</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mb::BusPage</name>
    <message>
        <source>Bus</source>
        <translation>Bus</translation>
    </message>
    <message>
        <source>msg:STS* dev:5 -id:0206</source>
        <translation>msg:STS* dev:5 -id:0206</translation>
    </message>
    <message>
        <source>Filter frames</source>
        <translation>Frames filtern</translation>
    </message>
    <message>
        <source>All words must hold: msg:STS* dev:5 id:0206 fam:dmc60c dir:tx, a minus turns one round</source>
        <translation>Alle Wörter müssen zutreffen: msg:STS* dev:5 id:0206 fam:dmc60c dir:tx, ein Minus kehrt eines um</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alle</translation>
    </message>
    <message>
        <source>rx</source>
        <translation>rx</translation>
    </message>
    <message>
        <source>tx</source>
        <translation>tx</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>Verbindung</translation>
    </message>
    <message>
        <source>Pause view</source>
        <translation>Anzeige anhalten</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Leeren</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Frames</translation>
    </message>
    <message>
        <source>load %1 %   %2 frames/s   lost %3</source>
        <translation>Last %1 %   %2 Frames/s   verloren %3</translation>
    </message>
    <message>
        <source>%1 shown</source>
        <translation>%1 angezeigt</translation>
    </message>
</context>
<context>
    <name>mb::ChangeRow</name>
    <message>
        <source>fix first</source>
        <translation>erst korrigieren</translation>
    </message>
    <message>
        <source>Write %1: %2 to %3</source>
        <translation>%1 schreiben: %2 auf %3</translation>
    </message>
    <message>
        <source>later</source>
        <translation>später</translation>
    </message>
    <message>
        <source>Written as number %1</source>
        <translation>Wird als Nummer %1 geschrieben</translation>
    </message>
    <message>
        <source>Stays staged</source>
        <translation>Bleibt vorgemerkt</translation>
    </message>
</context>
<context>
    <name>mb::ChangesPanel</name>
    <message>
        <source>Changes to write</source>
        <translation>Zu schreiben</translation>
    </message>
    <message>
        <source>order is chosen for you</source>
        <translation>Reihenfolge automatisch</translation>
    </message>
    <message>
        <source>Limits first, then what makes the loop calmer, then what makes it livelier: damping before P, P before I.</source>
        <translation>Zuerst Grenzen, dann was den Regler ruhiger macht, dann was ihn lebhafter macht: Dämpfung vor P, P vor I.</translation>
    </message>
    <message>
        <source>Staged changes</source>
        <translation>Vorgemerkte Änderungen</translation>
    </message>
    <message>
        <source>Nothing is staged. Edit a value in the table, or import a file.</source>
        <translation>Nichts vorgemerkt. Einen Wert in der Tabelle ändern oder eine Datei importieren.</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>Schreiben</translation>
    </message>
    <message>
        <source>nothing is staged</source>
        <translation>nichts vorgemerkt</translation>
    </message>
    <message>
        <source>fix 1 value first</source>
        <translation>erst 1 Wert korrigieren</translation>
    </message>
    <message>
        <source>fix %1 values first</source>
        <translation>erst %1 Werte korrigieren</translation>
    </message>
    <message>
        <source>none is ticked</source>
        <translation>keiner ist angehakt</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>keine Antwort</translation>
    </message>
    <message>
        <source>two units, one number</source>
        <translation>zwei Geräte, eine Nummer</translation>
    </message>
    <message>
        <source>busy</source>
        <translation>beschäftigt</translation>
    </message>
    <message>
        <source>%1, %2 of %3</source>
        <translation>%1, %2 von %3</translation>
    </message>
    <message>
        <source>Each value is written, read back and compared.</source>
        <translation>Jeder Wert wird geschrieben, zurückgelesen und verglichen.</translation>
    </message>
    <message>
        <source>The drive stores by itself %1 s after the last change: keep power on.</source>
        <translation>Das Gerät speichert %1 s nach der letzten Änderung von selbst: Versorgung an lassen.</translation>
    </message>
    <message>
        <source>Write %1</source>
        <translation>%1 schreiben</translation>
    </message>
    <message>
        <source>Write the staged changes  Ctrl+S</source>
        <translation>Vorgemerkte Änderungen schreiben  Strg+S</translation>
    </message>
    <message>
        <source>Ctrl+S</source>
        <translation>Strg+S</translation>
    </message>
</context>
<context>
    <name>mb::DemoStripe</name>
    <message>
        <source>simulated bench</source>
        <translation>simulierter Prüfstand</translation>
    </message>
    <message>
        <source>Demo  ·  %1  ·  no real motor is connected</source>
        <translation>Demo  ·  %1  ·  kein echter Motor angeschlossen</translation>
    </message>
</context>
<context>
    <name>mb::DeviceCard</name>
    <message>
        <source>velocity</source>
        <translation>Drehzahl</translation>
    </message>
    <message>
        <source>counts/s</source>
        <translation>counts/s</translation>
    </message>
    <message>
        <source>current</source>
        <translation>Strom</translation>
    </message>
    <message>
        <source>duty</source>
        <translation>Tastgrad</translation>
    </message>
    <message>
        <source>last 10 s</source>
        <translation>letzte 10 s</translation>
    </message>
    <message>
        <source>Update firmware</source>
        <translation>Firmware aktualisieren</translation>
    </message>
    <message>
        <source>No application runs. Settings, number and name are kept.</source>
        <translation>Keine Anwendung läuft. Einstellungen, Nummer und Name bleiben.</translation>
    </message>
    <message>
        <source>An update makes it whole again. It is safe to power off.</source>
        <translation>Ein Update stellt sie wieder her. Ausschalten ist unbedenklich.</translation>
    </message>
    <message>
        <source>boot %1 · no telemetry</source>
        <translation>Boot %1 · keine Telemetrie</translation>
    </message>
    <message>
        <source>%1 Hz   lost %2</source>
        <translation>%1 Hz   verloren %2</translation>
    </message>
    <message>
        <source>no faults</source>
        <translation>keine Fehler</translation>
    </message>
</context>
<context>
    <name>mb::DeviceLine</name>
    <message>
        <source>Selected device</source>
        <translation>Gewähltes Gerät</translation>
    </message>
    <message>
        <source>velocity</source>
        <translation>Drehzahl</translation>
    </message>
    <message>
        <source>counts/s</source>
        <translation>counts/s</translation>
    </message>
    <message>
        <source>current</source>
        <translation>Strom</translation>
    </message>
    <message>
        <source>duty</source>
        <translation>Tastgrad</translation>
    </message>
    <message>
        <source>bus</source>
        <translation>Bus</translation>
    </message>
    <message>
        <source>case</source>
        <translation>Gehäuse</translation>
    </message>
    <message>
        <source>SN %1 · fw %2</source>
        <translation>SN %1 · FW %2</translation>
    </message>
    <message>
        <source>no faults</source>
        <translation>keine Fehler</translation>
    </message>
</context>
<context>
    <name>mb::DeviceModel</name>
    <message>
        <source>lost</source>
        <translation>verloren</translation>
    </message>
    <message>
        <source>%1 Mbit/s</source>
        <translation>%1 Mbit/s</translation>
    </message>
    <message>
        <source>%1 kbit/s</source>
        <translation>%1 kbit/s</translation>
    </message>
    <message>
        <source>scanning</source>
        <translation>sucht</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
</context>
<context>
    <name>mb::DeviceTree</name>
    <message>
        <source>Devices</source>
        <translation>Geräte</translation>
    </message>
    <message>
        <source>Scan again</source>
        <translation>Neu suchen</translation>
    </message>
    <message>
        <source>Filter devices</source>
        <translation>Geräte filtern</translation>
    </message>
    <message>
        <source>Hide devices</source>
        <translation>Geräte ausblenden</translation>
    </message>
    <message>
        <source>Filter by name, number, serial</source>
        <translation>Name, Nummer, Seriennummer</translation>
    </message>
    <message>
        <source>No device yet</source>
        <translation>Noch kein Gerät</translation>
    </message>
    <message>
        <source>Devices appear here by themselves as soon as a link answers.</source>
        <translation>Geräte erscheinen hier von selbst, sobald eine Verbindung antwortet.</translation>
    </message>
    <message>
        <source>Links and devices</source>
        <translation>Verbindungen und Geräte</translation>
    </message>
    <message>
        <source>Add link</source>
        <translation>Verbinden</translation>
    </message>
    <message>
        <source>Simulate</source>
        <translation>Demo</translation>
    </message>
    <message>
        <source>Open a CAN interface, a serial port or another link</source>
        <translation>CAN-Schnittstelle, serielle Schnittstelle oder andere Verbindung öffnen</translation>
    </message>
    <message>
        <source>Open the simulated bench; no real motor is connected to it</source>
        <translation>Simulierten Prüfstand öffnen; kein echter Motor ist angeschlossen</translation>
    </message>
    <message>
        <source>Close this link</source>
        <translation>Diese Verbindung schließen</translation>
    </message>
</context>
<context>
    <name>mb::DriveOptions</name>
    <message>
        <source>Ramp of the output, duty per second</source>
        <translation>Rampe des Ausgangs, Tastgrad pro Sekunde</translation>
    </message>
    <message>
        <source>Greatest change of the output in duty per second, kept by the drive. 0 is immediate; 2 takes 0.5 s from 0 to 100 %.</source>
        <translation>Größte Änderung des Ausgangs in Tastgrad pro Sekunde, vom Gerät eingehalten. 0 ist sofort; 2 braucht 0.5 s von 0 auf 100 %.</translation>
    </message>
    <message>
        <source>duty/s, 0 = none</source>
        <translation>/s, 0 = keine</translation>
    </message>
    <message>
        <source>Ramp</source>
        <translation>Rampe</translation>
    </message>
    <message>
        <source>as the device is set</source>
        <translation>wie im Gerät eingestellt</translation>
    </message>
    <message>
        <source>brake</source>
        <translation>Bremsen</translation>
    </message>
    <message>
        <source>coast</source>
        <translation>Auslaufen</translation>
    </message>
    <message>
        <source>At zero output</source>
        <translation>Bei Ausgang null</translation>
    </message>
    <message>
        <source>At zero</source>
        <translation>Bei null</translation>
    </message>
    <message>
        <source>Reverse motor</source>
        <translation>Motor umkehren</translation>
    </message>
    <message>
        <source>Forward output turns the motor the other way. Changing it disarms.</source>
        <translation>Vorwärts dreht den Motor andersherum. Eine Änderung sichert.</translation>
    </message>
    <message>
        <source>Reverse sensor</source>
        <translation>Sensor umkehren</translation>
    </message>
    <message>
        <source>The encoder counts the other way. Changing it disarms.</source>
        <translation>Der Encoder zählt andersherum. Eine Änderung sichert.</translation>
    </message>
    <message>
        <source>Override limits</source>
        <translation>Grenzen übergehen</translation>
    </message>
    <message>
        <source>The two below replace the device&apos;s own settings for limit switches. Changing it disarms.</source>
        <translation>Die beiden darunter ersetzen die Einstellungen des Geräts für Endschalter. Eine Änderung sichert.</translation>
    </message>
    <message>
        <source>Forward limit off</source>
        <translation>Grenze vorwärts aus</translation>
    </message>
    <message>
        <source>The motor runs past the forward limit. Changing it disarms.</source>
        <translation>Der Motor läuft über die Grenze vorwärts hinaus. Eine Änderung sichert.</translation>
    </message>
    <message>
        <source>Reverse limit off</source>
        <translation>Grenze rückwärts aus</translation>
    </message>
    <message>
        <source>The motor runs past the reverse limit. Changing it disarms.</source>
        <translation>Der Motor läuft über die Grenze rückwärts hinaus. Eine Änderung sichert.</translation>
    </message>
    <message>
        <source>%1 is no ramp. Enter 0 for none, or a positive number of duty per second.</source>
        <translation>%1 ist keine Rampe. 0 für keine oder einen positiven Tastgrad pro Sekunde eingeben.</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>Nichts</translation>
    </message>
    <message>
        <source>ramp %1 duty/s</source>
        <translation>Rampe %1/s</translation>
    </message>
    <message>
        <source>motor reversed</source>
        <translation>Motor umgekehrt</translation>
    </message>
    <message>
        <source>sensor reversed</source>
        <translation>Sensor umgekehrt</translation>
    </message>
    <message>
        <source>limits overridden</source>
        <translation>Grenzen übergangen</translation>
    </message>
</context>
<context>
    <name>mb::FaultLine</name>
    <message>
        <source>Use %1</source>
        <translation>%1 verwenden</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Revert to %1</source>
        <translation>Zurück auf %1</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>Zurücksetzen</translation>
    </message>
</context>
<context>
    <name>mb::FirmwarePage</name>
    <message>
        <source>Firmware</source>
        <translation>Firmware</translation>
    </message>
    <message>
        <source>device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>firmware</source>
        <translation>Firmware</translation>
    </message>
    <message>
        <source>image</source>
        <translation>Image</translation>
    </message>
    <message>
        <source>Open image…</source>
        <translation>Image öffnen…</translation>
    </message>
    <message>
        <source>Before start</source>
        <translation>Vor dem Start</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Progress of the update</source>
        <translation>Fortschritt des Updates</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Update</source>
        <translation>Aktualisieren</translation>
    </message>
    <message>
        <source>Run the update again</source>
        <translation>Update wiederholen</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>Save log…</source>
        <translation>Protokoll speichern…</translation>
    </message>
    <message>
        <source>Log of the update</source>
        <translation>Protokoll des Updates</translation>
    </message>
    <message>
        <source>Flash pages</source>
        <translation>Flash-Seiten</translation>
    </message>
    <message>
        <source>In the order they are written. Green: written. Amber edge: sent again. Dashed: not in the image. Red: must not be cut.</source>
        <translation>In der Reihenfolge des Schreibens. Grün: geschrieben. Gelber Rand: erneut gesendet. Gestrichelt: nicht im Image. Rot: nicht unterbrechen.</translation>
    </message>
    <message>
        <source>no image yet</source>
        <translation>noch kein Image</translation>
    </message>
    <message>
        <source>version %1 · pages: %2</source>
        <translation>Version %1 · Seiten: %2</translation>
    </message>
    <message>
        <source>Open an Intel HEX file, or drop it here</source>
        <translation>Intel-HEX-Datei öffnen oder hier ablegen</translation>
    </message>
    <message>
        <source>select a device to check it</source>
        <translation>zum Prüfen ein Gerät wählen</translation>
    </message>
    <message>
        <source>no device selected</source>
        <translation>kein Gerät gewählt</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>%1 → %2</source>
        <translation>%1 → %2</translation>
    </message>
    <message>
        <source>image fits this family</source>
        <translation>Image passt zur Familie</translation>
    </message>
    <message>
        <source>no usable image</source>
        <translation>kein brauchbares Image</translation>
    </message>
    <message>
        <source>motor is moving</source>
        <translation>Motor bewegt sich</translation>
    </message>
    <message>
        <source>motor stopped</source>
        <translation>Motor steht</translation>
    </message>
    <message>
        <source>no other master, number unique</source>
        <translation>kein anderer Master, Nummer eindeutig</translation>
    </message>
    <message>
        <source>another master, or a number taken twice</source>
        <translation>anderer Master oder doppelte Nummer</translation>
    </message>
    <message>
        <source>no device</source>
        <translation>kein Gerät</translation>
    </message>
    <message>
        <source>bus %1 V</source>
        <translation>Bus %1 V</translation>
    </message>
    <message>
        <source>bus voltage not known</source>
        <translation>Busspannung unbekannt</translation>
    </message>
    <message>
        <source>Page 0 is being written: it must not be cut</source>
        <translation>Seite 0 wird geschrieben: nicht unterbrechen</translation>
    </message>
    <message>
        <source>The unit then waits in its bootloader; the update can be run again</source>
        <translation>Das Gerät wartet dann im Bootloader; das Update lässt sich wiederholen</translation>
    </message>
    <message>
        <source>%1 s a page, about %2 s left</source>
        <translation>%1 s je Seite, noch etwa %2 s</translation>
    </message>
    <message>
        <source>Verified: %1</source>
        <translation>Geprüft: %1</translation>
    </message>
    <message>
        <source>Not needed: %1</source>
        <translation>Nicht nötig: %1</translation>
    </message>
    <message>
        <source>Refused: %1</source>
        <translation>Abgelehnt: %1</translation>
    </message>
    <message>
        <source>Failed: %1</source>
        <translation>Fehlgeschlagen: %1</translation>
    </message>
    <message>
        <source>Cancelled. The unit waits in its bootloader; run the update again.</source>
        <translation>Abgebrochen. Das Gerät wartet im Bootloader; Update wiederholen.</translation>
    </message>
    <message>
        <source>Nothing running</source>
        <translation>Nichts läuft</translation>
    </message>
    <message>
        <source>%1, %2 of %3 written</source>
        <translation>%1, %2 von %3 geschrieben</translation>
    </message>
    <message>
        <source>%1 s, pages sent again: %2</source>
        <translation>%1 s, erneut gesendete Seiten: %2</translation>
    </message>
    <message>
        <source>Do not unplug</source>
        <translation>Nicht trennen</translation>
    </message>
    <message>
        <source>Safe to unplug</source>
        <translation>Trennen erlaubt</translation>
    </message>
    <message>
        <source>Nothing is written now</source>
        <translation>Jetzt wird nichts geschrieben</translation>
    </message>
    <message>
        <source>Page 0 holds the reset vector. A cut now cannot be repaired over the bus.</source>
        <translation>Seite 0 enthält den Reset-Vektor. Eine Unterbrechung jetzt lässt sich über den Bus nicht beheben.</translation>
    </message>
    <message>
        <source>A unit that is cut stays in its bootloader and can be updated again. Only page 0, the last, must not be interrupted.</source>
        <translation>Ein unterbrochenes Gerät bleibt im Bootloader und lässt sich erneut aktualisieren. Nur Seite 0, die letzte, darf nicht unterbrochen werden.</translation>
    </message>
    <message>
        <source>Open a firmware image</source>
        <translation>Firmware-Image öffnen</translation>
    </message>
    <message>
        <source>Intel HEX (*.hex *.ihex);;All files (*)</source>
        <translation>Intel HEX (*.hex *.ihex);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Save the log of the update</source>
        <translation>Protokoll des Updates speichern</translation>
    </message>
    <message>
        <source>Text (*.log *.txt)</source>
        <translation>Text (*.log *.txt)</translation>
    </message>
</context>
<context>
    <name>mb::FrameDetail</name>
    <message>
        <source>Selected frame</source>
        <translation>Gewählter Frame</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Frame</translation>
    </message>
    <message>
        <source>Select a frame</source>
        <translation>Frame wählen</translation>
    </message>
    <message>
        <source>Fields</source>
        <translation>Felder</translation>
    </message>
    <message>
        <source>field</source>
        <translation>Feld</translation>
    </message>
    <message>
        <source>value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Copy as candump text</source>
        <translation>Als candump-Text kopieren</translation>
    </message>
    <message>
        <source>Unknown frame</source>
        <translation>Unbekannter Frame</translation>
    </message>
    <message>
        <source>sent</source>
        <translation>gesendet</translation>
    </message>
    <message>
        <source>received</source>
        <translation>empfangen</translation>
    </message>
    <message>
        <source>%1 · %2 %3 · %4</source>
        <translation>%1 · %2 %3 · %4</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
</context>
<context>
    <name>mb::FrameModel</name>
    <message>
        <source>err</source>
        <translation>err</translation>
    </message>
    <message>
        <source>tx</source>
        <translation>tx</translation>
    </message>
    <message>
        <source>rx</source>
        <translation>rx</translation>
    </message>
    <message>
        <source>error frame</source>
        <translation>Fehlerframe</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>class %1</source>
        <translation>Klasse %1</translation>
    </message>
    <message>
        <source>no decoder knows this identifier</source>
        <translation>kein Decoder kennt diesen Identifier</translation>
    </message>
    <message>
        <source>t, s</source>
        <translation>t, s</translation>
    </message>
    <message>
        <source>Δ ms</source>
        <translation>Δ ms</translation>
    </message>
    <message>
        <source>dir</source>
        <translation>Ri.</translation>
    </message>
    <message>
        <source>id</source>
        <translation>ID</translation>
    </message>
    <message>
        <source>message</source>
        <translation>Nachricht</translation>
    </message>
    <message>
        <source>dev</source>
        <translation>Ger.</translation>
    </message>
    <message>
        <source>decoded</source>
        <translation>dekodiert</translation>
    </message>
    <message>
        <source>data</source>
        <translation>Daten</translation>
    </message>
</context>
<context>
    <name>mb::GainRow</name>
    <message>
        <source>Revert %1</source>
        <translation>%1 zurücksetzen</translation>
    </message>
    <message>
        <source>%1, one decade either way</source>
        <translation>%1, eine Dekade je Richtung</translation>
    </message>
    <message>
        <source>One decade either way. ← → 2 %, with Shift 0.2 %, with Ctrl 20 %</source>
        <translation>Eine Dekade je Richtung. ← → 2 %, mit Umschalt 0.2 %, mit Strg 20 %</translation>
    </message>
    <message>
        <source>stored</source>
        <translation>Flash</translation>
    </message>
    <message>
        <source>RAM</source>
        <translation>RAM</translation>
    </message>
    <message>
        <source>volatile</source>
        <translation>flüchtig</translation>
    </message>
    <message>
        <source>assumed</source>
        <translation>angen.</translation>
    </message>
    <message>
        <source>edited</source>
        <translation>geändert</translation>
    </message>
    <message>
        <source>range</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <source>reading</source>
        <translation>liest</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>edited, was %1</source>
        <translation>geändert, war %1</translation>
    </message>
    <message>
        <source>edited, was unknown</source>
        <translation>geändert, war unbekannt</translation>
    </message>
    <message>
        <source>raw %1   %2</source>
        <translation>roh %1   %2</translation>
    </message>
</context>
<context>
    <name>mb::GainsPanel</name>
    <message>
        <source>Gains</source>
        <translation>Verstärkungen</translation>
    </message>
    <message>
        <source>G · ← → 2 % · Shift 0.2 %</source>
        <translation>G · ← → 2 % · Umsch 0.2 %</translation>
    </message>
    <message>
        <source>Gains, slot %1</source>
        <translation>Regler, Slot %1</translation>
    </message>
    <message>
        <source>Hide limits of the loop</source>
        <translation>Grenzen des Reglers ausblenden</translation>
    </message>
    <message>
        <source>I zone, allowable error, ramp, output limits</source>
        <translation>I-Zone, Toleranz, Rampe, Grenzen</translation>
    </message>
    <message>
        <source>No loop runs in %1 mode: these gains act in velocity, position and current.</source>
        <translation>Bei %1 läuft kein Regler: diese Verstärkungen wirken bei Drehzahl, Position und Strom.</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
</context>
<context>
    <name>mb::HeaderBar</name>
    <message>
        <source>MotorBench</source>
        <translation>MotorBench</translation>
    </message>
    <message>
        <source>Program menu</source>
        <translation>Programmmenü</translation>
    </message>
    <message numerus="yes">
        <source>%n links</source>
        <translation>
            <numerusform>%n Verbindung</numerusform>
            <numerusform>%n Verbindungen</numerusform>
        </translation>
    </message>
    <message>
        <source>Links</source>
        <translation>Verbindungen</translation>
    </message>
    <message>
        <source>no alarms</source>
        <translation>keine Alarme</translation>
    </message>
    <message>
        <source>1 notice</source>
        <translation>1 Meldung</translation>
    </message>
    <message numerus="yes">
        <source>%n notices</source>
        <translation>
            <numerusform>%n Meldung</numerusform>
            <numerusform>%n Meldungen</numerusform>
        </translation>
    </message>
    <message>
        <source>Recording %1</source>
        <translation>Aufnahme %1</translation>
    </message>
    <message>
        <source>1 link</source>
        <translation>1 Verbindung</translation>
    </message>
</context>
<context>
    <name>mb::Inspector</name>
    <message>
        <source>Inspector</source>
        <translation>Inspektor</translation>
    </message>
    <message>
        <source>Identify</source>
        <translation>Identifizieren</translation>
    </message>
    <message>
        <source>Blink the lamps of this unit for 5 s</source>
        <translation>Lampen dieses Geräts 5 s blinken lassen</translation>
    </message>
    <message>
        <source>Read all</source>
        <translation>Alle lesen</translation>
    </message>
    <message>
        <source>Read every parameter of this unit</source>
        <translation>Alle Parameter dieses Geräts lesen</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>Live</translation>
    </message>
    <message>
        <source>position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>counts</source>
        <translation>counts</translation>
    </message>
    <message>
        <source>velocity</source>
        <translation>Drehzahl</translation>
    </message>
    <message>
        <source>counts/s</source>
        <translation>counts/s</translation>
    </message>
    <message>
        <source>current</source>
        <translation>Strom</translation>
    </message>
    <message>
        <source>duty</source>
        <translation>Tastgrad</translation>
    </message>
    <message>
        <source>bus</source>
        <translation>Bus</translation>
    </message>
    <message>
        <source>case</source>
        <translation>Gehäuse</translation>
    </message>
    <message>
        <source>Identity</source>
        <translation>Identität</translation>
    </message>
    <message>
        <source>serial</source>
        <translation>Seriennr.</translation>
    </message>
    <message>
        <source>firmware</source>
        <translation>Firmware</translation>
    </message>
    <message>
        <source>bootloader</source>
        <translation>Bootloader</translation>
    </message>
    <message>
        <source>session</source>
        <translation>Sitzung</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>faults</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>over-temperature</source>
        <translation>Übertemperatur</translation>
    </message>
    <message>
        <source>changed from default</source>
        <translation>abweichend</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>in RAM only</source>
        <translation>nur im RAM</translation>
    </message>
    <message>
        <source>No device selected</source>
        <translation>Kein Gerät gewählt</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
</context>
<context>
    <name>mb::Lamp</name>
    <message>
        <source>SAFE</source>
        <translation>SICHER</translation>
    </message>
    <message>
        <source>ARMED</source>
        <translation>SCHARF</translation>
    </message>
    <message>
        <source>MOVING</source>
        <translation>LÄUFT</translation>
    </message>
    <message>
        <source>STOPPED</source>
        <translation>GESTOPPT</translation>
    </message>
    <message>
        <source>keep holding</source>
        <translation>weiter halten</translation>
    </message>
    <message>
        <source>hold to arm</source>
        <translation>1 s halten</translation>
    </message>
    <message>
        <source>nothing to arm</source>
        <translation>nichts bereit</translation>
    </message>
    <message>
        <source>hold to re-arm</source>
        <translation>1 s halten</translation>
    </message>
    <message>
        <source>Arming lamp: %1</source>
        <translation>Lampe: %1</translation>
    </message>
    <message>
        <source>Press to make it safe again</source>
        <translation>Drücken zum Sichern</translation>
    </message>
    <message>
        <source>Hold for one second to arm</source>
        <translation>Eine Sekunde halten zum Scharfschalten</translation>
    </message>
    <message>
        <source>#88 velocity</source>
        <translation>#88 Drehzahl</translation>
    </message>
</context>
<context>
    <name>mb::LinkChip</name>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>load %1</source>
        <translation>Last %1</translation>
    </message>
    <message>
        <source>lost %1</source>
        <translation>verloren %1</translation>
    </message>
    <message>
        <source>Link %1: %2</source>
        <translation>Verbindung %1: %2</translation>
    </message>
</context>
<context>
    <name>mb::LogPage</name>
    <message>
        <source>Log</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>Search the log</source>
        <translation>Protokoll durchsuchen</translation>
    </message>
    <message>
        <source>Severity</source>
        <translation>Schwere</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alle</translation>
    </message>
    <message>
        <source>Cautions</source>
        <translation>Warnungen</translation>
    </message>
    <message>
        <source>Faults</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Save log…</source>
        <translation>Protokoll speichern…</translation>
    </message>
    <message>
        <source>Nothing yet</source>
        <translation>Noch nichts</translation>
    </message>
    <message>
        <source>Actions and faults appear here.</source>
        <translation>Hier erscheinen Aktionen und Fehler.</translation>
    </message>
    <message>
        <source>Log lines</source>
        <translation>Protokollzeilen</translation>
    </message>
    <message>
        <source>Save the log</source>
        <translation>Protokoll speichern</translation>
    </message>
    <message>
        <source>Text (*.log *.txt)</source>
        <translation>Text (*.log *.txt)</translation>
    </message>
    <message>
        <source>log saved to %1</source>
        <translation>Protokoll gespeichert unter %1</translation>
    </message>
</context>
<context>
    <name>mb::MainWindow</name>
    <message>
        <source>MotorBench</source>
        <translation>MotorBench</translation>
    </message>
    <message>
        <source>Add link…</source>
        <translation>Verbindung hinzufügen…</translation>
    </message>
    <message>
        <source>Open the simulated bench</source>
        <translation>Simulierten Prüfstand öffnen</translation>
    </message>
    <message>
        <source>Switch between dark and light</source>
        <translation>Zwischen dunkel und hell wechseln</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>button</source>
        <translation>Schaltfläche</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>Geräte</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>Seiten</translation>
    </message>
    <message>
        <source>Overview</source>
        <translation>Übersicht</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Tune</source>
        <translation>Regler</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Kurven</translation>
    </message>
    <message>
        <source>Firmware</source>
        <translation>Firmware</translation>
    </message>
    <message>
        <source>Bus</source>
        <translation>Bus</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>Inspector</source>
        <translation>Inspektor</translation>
    </message>
    <message>
        <source>%1  Ctrl+%2</source>
        <translation>%1  Strg+%2</translation>
    </message>
    <message>
        <source>needs a device; open a link first</source>
        <translation>braucht ein Gerät; zuerst eine Verbindung öffnen</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>verloren</translation>
    </message>
    <message>
        <source>%1: %2 frames received, %3 sent, %4 lost, %5 errors</source>
        <translation>%1: %2 Frames empfangen, %3 gesendet, %4 verloren, %5 Fehler</translation>
    </message>
    <message>
        <source>simulated bench</source>
        <translation>simulierter Prüfstand</translation>
    </message>
    <message>
        <source>%1 is lost</source>
        <translation>%1 ist verloren</translation>
    </message>
    <message>
        <source>Another master drives %1</source>
        <translation>Ein anderer Master steuert %1 an</translation>
    </message>
    <message>
        <source>Arming is off until it stops sending control frames.</source>
        <translation>Scharfschalten ist gesperrt, bis er keine Steuerframes mehr sendet.</translation>
    </message>
    <message>
        <source>Several units answer as %1</source>
        <translation>Mehrere Geräte antworten als %1</translation>
    </message>
    <message>
        <source>Control is locked. Assign one of them a new number from the menu of its row.</source>
        <translation>Ansteuerung gesperrt. Einem davon im Menü seiner Zeile eine neue Nummer zuweisen.</translation>
    </message>
    <message>
        <source>Stopped: %1</source>
        <translation>Gestoppt: %1</translation>
    </message>
    <message>
        <source>Hold the lamp for 1 s to arm again.</source>
        <translation>Lampe 1 s halten, um neu scharf zu schalten.</translation>
    </message>
    <message>
        <source>samples %1   lost %2   memory %3</source>
        <translation>Werte %1   verloren %2   Speicher %3</translation>
    </message>
    <message>
        <source>the window lost the focus</source>
        <translation>das Fenster verlor den Fokus</translation>
    </message>
</context>
<context>
    <name>mb::ModePanel</name>
    <message>
        <source>Mode</source>
        <translation>Betriebsart</translation>
    </message>
    <message>
        <source>%1 mode</source>
        <translation>Betriebsart %1</translation>
    </message>
    <message>
        <source>Gain slot that is edited</source>
        <translation>Slot, der bearbeitet wird</translation>
    </message>
    <message>
        <source>Gain slot that runs</source>
        <translation>Slot, der läuft</translation>
    </message>
    <message>
        <source>The slot of the next run. Changing it disarms.</source>
        <translation>Slot des nächsten Laufs. Eine Änderung sichert.</translation>
    </message>
    <message>
        <source>Editing slot</source>
        <translation>Slot ändern</translation>
    </message>
    <message>
        <source>running</source>
        <translation>läuft</translation>
    </message>
</context>
<context>
    <name>mb::NoticeModel</name>
    <message>
        <source>time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>what</source>
        <translation>Was</translation>
    </message>
</context>
<context>
    <name>mb::OverviewPage</name>
    <message>
        <source>Overview</source>
        <translation>Übersicht</translation>
    </message>
    <message>
        <source>Connection doctor</source>
        <translation>Verbindungsdoktor</translation>
    </message>
    <message>
        <source>looks again every 2 s</source>
        <translation>prüft alle 2 s</translation>
    </message>
    <message>
        <source>Try with simulated motors</source>
        <translation>Mit simulierten Motoren ausprobieren</translation>
    </message>
    <message>
        <source>A bench of simulated controllers with real bus timing: #5 a CIM that is tuned well, #7 a 775pro that overshoots about 20 %, #9 a unit that waits in its bootloader for firmware. Everything works as on a real bus, and nothing can move.</source>
        <translation>Ein Prüfstand simulierter Controller mit echtem Zeitverhalten am Bus: #5 ein gut eingestellter CIM, #7 ein 775pro mit etwa 20 % Überschwingen, #9 ein Gerät, das im Bootloader auf Firmware wartet. Alles verhält sich wie am echten Bus, und nichts kann sich bewegen.</translation>
    </message>
    <message>
        <source>Open the simulated bench</source>
        <translation>Simulierten Prüfstand öffnen</translation>
    </message>
    <message>
        <source>Add link</source>
        <translation>Verbindung hinzufügen</translation>
    </message>
    <message>
        <source>No interface found</source>
        <translation>Keine Schnittstelle gefunden</translation>
    </message>
    <message>
        <source>Plug in a CAN adapter at any time; it appears here and is opened by itself once it is up.</source>
        <translation>CAN-Adapter jederzeit einstecken; er erscheint hier und wird von selbst geöffnet, sobald er eingeschaltet ist.</translation>
    </message>
    <message>
        <source>load</source>
        <translation>Last</translation>
    </message>
    <message>
        <source>errors</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>verloren</translation>
    </message>
    <message>
        <source>%1 kbit/s</source>
        <translation>%1 kbit/s</translation>
    </message>
</context>
<context>
    <name>mb::PageMap</name>
    <message>
        <source>Flash pages</source>
        <translation>Flash-Seiten</translation>
    </message>
    <message>
        <source>%1 of %2 pages written</source>
        <translation>%1 von %2 Seiten geschrieben</translation>
    </message>
    <message>
        <source> · must not be interrupted</source>
        <translation> · nicht unterbrechen</translation>
    </message>
    <message>
        <source>page %1: waiting</source>
        <translation>Seite %1: wartet</translation>
    </message>
    <message>
        <source>page %1: being written</source>
        <translation>Seite %1: wird geschrieben</translation>
    </message>
    <message>
        <source>page %1: written after it was sent again</source>
        <translation>Seite %1: nach erneutem Senden geschrieben</translation>
    </message>
    <message>
        <source>page %1: written</source>
        <translation>Seite %1: geschrieben</translation>
    </message>
    <message>
        <source>page %1: sent again</source>
        <translation>Seite %1: erneut gesendet</translation>
    </message>
    <message>
        <source>page %1: not in the image</source>
        <translation>Seite %1: nicht im Image</translation>
    </message>
</context>
<context>
    <name>mb::PageTabs</name>
    <message>
        <source>Pages</source>
        <translation>Seiten</translation>
    </message>
</context>
<context>
    <name>mb::ParameterDelegate</name>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
</context>
<context>
    <name>mb::ParameterFoot</name>
    <message>
        <source>What the parameter does</source>
        <translation>Was der Parameter bewirkt</translation>
    </message>
    <message>
        <source>↑↓ row · Enter edit · Ctrl+S write</source>
        <translation>↑↓ Zeile · Enter ändern · Strg+S schreiben</translation>
    </message>
    <message>
        <source>%1 edited</source>
        <translation>%1 geändert</translation>
    </message>
    <message>
        <source>%1 out of range</source>
        <translation>%1 außerhalb</translation>
    </message>
    <message>
        <source>%1 without answer</source>
        <translation>%1 ohne Antwort</translation>
    </message>
    <message>
        <source>%1 in RAM</source>
        <translation>%1 im RAM</translation>
    </message>
    <message>
        <source>%1 stored</source>
        <translation>%1 gespeichert</translation>
    </message>
    <message>
        <source>%1 assumed</source>
        <translation>%1 angenommen</translation>
    </message>
    <message>
        <source>%1 not persistent</source>
        <translation>%1 flüchtig</translation>
    </message>
    <message>
        <source>Choose a parameter to see what it does.</source>
        <translation>Parameter wählen, um zu sehen, was er bewirkt.</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1.</translation>
    </message>
</context>
<context>
    <name>mb::ParameterHeader</name>
    <message>
        <source>Columns</source>
        <translation>Spalten</translation>
    </message>
</context>
<context>
    <name>mb::ParameterModel</name>
    <message>
        <source>edited, was %1</source>
        <translation>geändert, war %1</translation>
    </message>
    <message>
        <source>default</source>
        <translation>Standard</translation>
    </message>
    <message>
        <source>edited, was unknown</source>
        <translation>geändert, war unbekannt</translation>
    </message>
    <message>
        <source>no answer, retry</source>
        <translation>keine Antwort, erneut</translation>
    </message>
    <message>
        <source>not read</source>
        <translation>nicht gelesen</translation>
    </message>
    <message>
        <source>from a file</source>
        <translation>aus Datei</translation>
    </message>
    <message>
        <source>1 parameter</source>
        <translation>1 Parameter</translation>
    </message>
    <message>
        <source>%1 parameters</source>
        <translation>%1 Parameter</translation>
    </message>
    <message>
        <source>not kept over a power cycle</source>
        <translation>nach Ausschalten verloren</translation>
    </message>
    <message>
        <source>%1 not kept over a power cycle</source>
        <translation>%1 nach Ausschalten verloren</translation>
    </message>
    <message>
        <source>Can only be read.</source>
        <translation>Nur lesbar.</translation>
    </message>
    <message>
        <source>Is cleared with the faults, not by writing.</source>
        <translation>Wird mit den Fehlern gelöscht, nicht durch Schreiben.</translation>
    </message>
    <message>
        <source>%1, default %2</source>
        <translation>%1, Standard %2</translation>
    </message>
    <message>
        <source>%1 is 100 %</source>
        <translation>%1 ist 100 %</translation>
    </message>
    <message>
        <source>Not kept over a power cycle.</source>
        <translation>Geht beim Ausschalten verloren.</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>parameter</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>key</source>
        <translation>Schlüssel</translation>
    </message>
    <message>
        <source>value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>state</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>raw</source>
        <translation>roh</translation>
    </message>
</context>
<context>
    <name>mb::ParameterView</name>
    <message>
        <source>Parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Copy as key=value</source>
        <translation>Als key=value kopieren</translation>
    </message>
    <message>
        <source>Revert the edit</source>
        <translation>Änderung zurücksetzen</translation>
    </message>
    <message>
        <source>Set to the default, %1</source>
        <translation>Auf Standard setzen, %1</translation>
    </message>
</context>
<context>
    <name>mb::ParametersPage</name>
    <message>
        <source>Open a parameter file…</source>
        <translation>Parameterdatei öffnen…</translation>
    </message>
    <message>
        <source>Open a parameter file</source>
        <translation>Parameterdatei öffnen</translation>
    </message>
    <message>
        <source>Undo the last edit</source>
        <translation>Letzte Änderung rückgängig</translation>
    </message>
    <message>
        <source>Redo the edit</source>
        <translation>Änderung wiederholen</translation>
    </message>
    <message>
        <source>Read all</source>
        <translation>Alle lesen</translation>
    </message>
    <message>
        <source>Import…</source>
        <translation>Import…</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Export…</translation>
    </message>
    <message>
        <source>Import parameters</source>
        <translation>Parameter importieren</translation>
    </message>
    <message>
        <source>Export parameters</source>
        <translation>Parameter exportieren</translation>
    </message>
    <message>
        <source>Search parameters</source>
        <translation>Parameter suchen</translation>
    </message>
    <message>
        <source>Which parameters</source>
        <translation>Welche Parameter</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alle</translation>
    </message>
    <message>
        <source>Changed</source>
        <translation>Abweichend</translation>
    </message>
    <message>
        <source>Edited</source>
        <translation>Geändert</translation>
    </message>
    <message>
        <source>Errors</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Compare with</source>
        <translation>Vergleich mit</translation>
    </message>
    <message>
        <source>as found %1</source>
        <translation>Stand %1</translation>
    </message>
    <message>
        <source>Select a device</source>
        <translation>Gerät wählen</translation>
    </message>
    <message>
        <source>Its parameters appear here. A parameter file can be looked at and compared without a device.</source>
        <translation>Hier erscheinen seine Parameter. Eine Parameterdatei lässt sich auch ohne Gerät ansehen und vergleichen.</translation>
    </message>
    <message>
        <source>No parameters in the bootloader</source>
        <translation>Keine Parameter im Bootloader</translation>
    </message>
    <message>
        <source>%1 has no application running. Write firmware to it, then its parameters can be read.</source>
        <translation>In %1 läuft keine Anwendung. Firmware schreiben, dann lassen sich die Parameter lesen.</translation>
    </message>
    <message>
        <source>No parameters</source>
        <translation>Keine Parameter</translation>
    </message>
    <message>
        <source>%1 has none.</source>
        <translation>%1 hat keine.</translation>
    </message>
    <message>
        <source>All %1</source>
        <translation>Alle %1</translation>
    </message>
    <message>
        <source>Changed %1</source>
        <translation>Abweichend %1</translation>
    </message>
    <message>
        <source>Edited %1</source>
        <translation>Geändert %1</translation>
    </message>
    <message>
        <source>Errors %1</source>
        <translation>Fehler %1</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>defaults</source>
        <translation>Standardwerten</translation>
    </message>
    <message>
        <source>a file…</source>
        <translation>einer Datei…</translation>
    </message>
    <message>
        <source>Compare with a parameter file</source>
        <translation>Mit einer Parameterdatei vergleichen</translation>
    </message>
    <message>
        <source>What was written before it is in force; the rest is still staged. Nothing was stored.</source>
        <translation>Das davor Geschriebene gilt; der Rest bleibt vorgemerkt. Nichts wurde gespeichert.</translation>
    </message>
    <message>
        <source>Nothing is proved to be in flash. Store again, and keep power on.</source>
        <translation>Nichts ist als gespeichert nachgewiesen. Erneut speichern, Versorgung an lassen.</translation>
    </message>
    <message>
        <source>%1 says what the device has.</source>
        <translation>%1 entspricht dem Gerät.</translation>
    </message>
    <message>
        <source>Nothing is staged.</source>
        <translation>Nichts vorgemerkt.</translation>
    </message>
    <message>
        <source>Import of %1</source>
        <translation>Import von %1</translation>
    </message>
    <message>
        <source>Nothing is written yet: look through the list, then write.</source>
        <translation>Noch nichts geschrieben: Liste durchsehen, dann schreiben.</translation>
    </message>
    <message>
        <source>Left out: %1, for one: %2.</source>
        <translation>Ausgelassen: %1, zum Beispiel: %2.</translation>
    </message>
    <message>
        <source>Staged from %1: %2 of its values differ.</source>
        <translation>Vorgemerkt aus %1: %2 Werte weichen ab.</translation>
    </message>
    <message>
        <source>Undo the import</source>
        <translation>Import rückgängig</translation>
    </message>
    <message>
        <source>Choose another place.</source>
        <translation>Anderen Ort wählen.</translation>
    </message>
    <message>
        <source>%1 parameters exported to %2</source>
        <translation>%1 Parameter exportiert nach %2</translation>
    </message>
    <message>
        <source>Ctrl+Z</source>
        <translation>Strg+Z</translation>
    </message>
    <message>
        <source>Ctrl+Y</source>
        <translation>Strg+Y</translation>
    </message>
    <message>
        <source>Ctrl+F</source>
        <translation>Strg+F</translation>
    </message>
</context>
<context>
    <name>mb::PlotStack</name>
    <message>
        <source>Export plot</source>
        <translation>Kurve exportieren</translation>
    </message>
    <message>
        <source>Pause view	P</source>
        <translation>Anzeige anhalten	P</translation>
    </message>
    <message>
        <source>Back to live	P</source>
        <translation>Zurück zu live	P</translation>
    </message>
    <message>
        <source>Fit time and value	0</source>
        <translation>Zeit und Wert einpassen	0</translation>
    </message>
    <message>
        <source>Cursors A and B	L</source>
        <translation>Cursor A und B	L</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>Bild kopieren</translation>
    </message>
    <message>
        <source>Copy summary</source>
        <translation>Zusammenfassung kopieren</translation>
    </message>
    <message>
        <source>Export PNG…</source>
        <translation>PNG exportieren…</translation>
    </message>
    <message>
        <source>PNG picture (*.png)</source>
        <translation>PNG-Bild (*.png)</translation>
    </message>
    <message>
        <source>Export SVG…</source>
        <translation>SVG exportieren…</translation>
    </message>
    <message>
        <source>SVG drawing (*.svg)</source>
        <translation>SVG-Zeichnung (*.svg)</translation>
    </message>
    <message>
        <source>Export PDF…</source>
        <translation>PDF exportieren…</translation>
    </message>
    <message>
        <source>PDF document (*.pdf)</source>
        <translation>PDF-Dokument (*.pdf)</translation>
    </message>
    <message>
        <source>Export CSV…</source>
        <translation>CSV exportieren…</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tabelle (*.csv)</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>live, %1</source>
        <translation>live, %1</translation>
    </message>
    <message>
        <source>paused, %1</source>
        <translation>angehalten, %1</translation>
    </message>
    <message>
        <source>Δt</source>
        <translation>Δt</translation>
    </message>
    <message>
        <source>1/Δt</source>
        <translation>1/Δt</translation>
    </message>
    <message>
        <source>Hz</source>
        <translation>Hz</translation>
    </message>
    <message>
        <source>Δ %1</source>
        <translation>Δ %1</translation>
    </message>
    <message>
        <source>%1 %2 to %3</source>
        <translation>%1 %2 bis %3</translation>
    </message>
    <message>
        <source>%1 no data</source>
        <translation>%1 ohne Daten</translation>
    </message>
    <message>
        <source>, now %1</source>
        <translation>, jetzt %1</translation>
    </message>
    <message>
        <source>, 1 gap</source>
        <translation>, 1 Lücke</translation>
    </message>
    <message numerus="yes">
        <source>, %n gaps</source>
        <translation>
            <numerusform>, %n Lücke</numerusform>
            <numerusform>, %n Lücken</numerusform>
        </translation>
    </message>
    <message>
        <source>No traces</source>
        <translation>Keine Kurven</translation>
    </message>
    <message>
        <source>Last %1: %2</source>
        <translation>Letzte %1: %2</translation>
    </message>
    <message>
        <source>Plot</source>
        <translation>Diagramm</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>gap %1</source>
        <translation>Lücke %1</translation>
    </message>
</context>
<context>
    <name>mb::PlotsPage</name>
    <message>
        <source>No device yet</source>
        <translation>Noch kein Gerät</translation>
    </message>
    <message>
        <source>Open a link, or the simulated bench from the menu; its signals appear here.</source>
        <translation>Eine Verbindung oder im Menü den simulierten Prüfstand öffnen; hier erscheinen die Signale.</translation>
    </message>
    <message>
        <source>Nothing is plotted</source>
        <translation>Nichts dargestellt</translation>
    </message>
    <message>
        <source>Double click a signal in the list at the right.</source>
        <translation>Ein Signal in der Liste rechts doppelklicken.</translation>
    </message>
    <message>
        <source>plot written to %1</source>
        <translation>Kurve geschrieben nach %1</translation>
    </message>
    <message>
        <source>%1 cannot be written</source>
        <translation>%1 lässt sich nicht schreiben</translation>
    </message>
    <message>
        <source>Pause view</source>
        <translation>Anzeige anhalten</translation>
    </message>
    <message>
        <source>Follow live</source>
        <translation>Live folgen</translation>
    </message>
    <message>
        <source>The recording goes on.</source>
        <translation>Die Aufnahme läuft weiter.</translation>
    </message>
    <message>
        <source>window %1 s</source>
        <translation>Fenster %1 s</translation>
    </message>
    <message>
        <source>window %1 min</source>
        <translation>Fenster %1 min</translation>
    </message>
    <message>
        <source>Length of the time axis</source>
        <translation>Länge der Zeitachse</translation>
    </message>
    <message>
        <source>Cursors A and B</source>
        <translation>Cursor A und B</translation>
    </message>
    <message>
        <source>Fit time and value</source>
        <translation>Zeit und Wert einpassen</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Export</translation>
    </message>
    <message>
        <source>The picture as PNG, SVG or PDF, or what is visible as CSV</source>
        <translation>Das Bild als PNG, SVG oder PDF oder das Sichtbare als CSV</translation>
    </message>
    <message>
        <source>Traces</source>
        <translation>Kurven</translation>
    </message>
    <message>
        <source>rate      lost</source>
        <translation>Rate   verl.</translation>
    </message>
    <message>
        <source>L cursors · 0 fits · + − zooms · P pauses</source>
        <translation>L Cursor · 0 alles · + − Zoom · P Pause</translation>
    </message>
    <message>
        <source>DEMO</source>
        <translation>DEMO</translation>
    </message>
    <message>
        <source>%1 signals, %2 samples/s, %3 of %4 lost</source>
        <translation>%1 Signale, %2 Werte/s, %3 von %4 verloren</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source>%1 lost</source>
        <translation>%1 verloren</translation>
    </message>
    <message>
        <source>A %1   B %2</source>
        <translation>A %1   B %2</translation>
    </message>
</context>
<context>
    <name>mb::RamBlock</name>
    <message>
        <source>In RAM, not in flash</source>
        <translation>Im RAM, nicht im Flash</translation>
    </message>
    <message>
        <source>Time until the device stores by itself</source>
        <translation>Zeit, bis das Gerät von selbst speichert</translation>
    </message>
    <message>
        <source>Store and prove</source>
        <translation>Speichern und nachweisen</translation>
    </message>
    <message>
        <source>%1 s to go</source>
        <translation>noch %1 s</translation>
    </message>
    <message>
        <source>not proved</source>
        <translation>nicht nachgewiesen</translation>
    </message>
    <message>
        <source>Read back and equal. Lost at power-off until it is stored.</source>
        <translation>Zurückgelesen und gleich. Bis zum Speichern beim Ausschalten verloren.</translation>
    </message>
    <message>
        <source>Read back and equal. Do not cut power yet.</source>
        <translation>Zurückgelesen und gleich. Versorgung noch nicht trennen.</translation>
    </message>
    <message>
        <source>The device should have stored by itself. Its own proof takes up to 20 s.</source>
        <translation>Das Gerät sollte selbst gespeichert haben. Der Nachweis dauert bis zu 20 s.</translation>
    </message>
    <message>
        <source>%1 more.</source>
        <translation>%1 weitere.</translation>
    </message>
</context>
<context>
    <name>mb::ReadStatus</name>
    <message>
        <source>Reading</source>
        <translation>Lesen</translation>
    </message>
    <message>
        <source>%1, values of a %2 from a file</source>
        <translation>%1, Werte eines %2 aus einer Datei</translation>
    </message>
    <message>
        <source>Reading %1 of %2</source>
        <translation>Lese %1 von %2</translation>
    </message>
    <message>
        <source>no answer, the values are old</source>
        <translation>keine Antwort, die Werte sind alt</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>keine Antwort</translation>
    </message>
    <message>
        <source>%1 of %2 are read, %3 gave no answer</source>
        <translation>%1 von %2 gelesen, %3 ohne Antwort</translation>
    </message>
    <message>
        <source>not read yet</source>
        <translation>noch nicht gelesen</translation>
    </message>
    <message>
        <source>%1 of %2 known</source>
        <translation>%1 von %2 bekannt</translation>
    </message>
    <message>
        <source>all %1 read</source>
        <translation>alle %1 gelesen</translation>
    </message>
    <message>
        <source>all %1 read in %2</source>
        <translation>alle %1 in %2 gelesen</translation>
    </message>
</context>
<context>
    <name>mb::ResolutionMeter</name>
    <message>
        <source>Resolution: off</source>
        <translation>Auflösung: aus</translation>
    </message>
    <message>
        <source>Resolution: %1 steps</source>
        <translation>Auflösung: %1 Stufen</translation>
    </message>
    <message>
        <source>The device knows this value as %1 whole steps: the smallest change is %2 %.</source>
        <translation>Das Gerät kennt diesen Wert als %1 ganze Stufen: die kleinste Änderung ist %2 %.</translation>
    </message>
    <message>
        <source>%1 LSB</source>
        <translation>%1 LSB</translation>
    </message>
    <message>
        <source>%1 k LSB</source>
        <translation>%1 k LSB</translation>
    </message>
</context>
<context>
    <name>mb::SetPointPanel</name>
    <message>
        <source>Set-point</source>
        <translation>Sollwert</translation>
    </message>
    <message>
        <source>Enter applies it while the motor runs; it never starts one.</source>
        <translation>Enter übernimmt ihn bei laufendem Motor; gestartet wird damit nie.</translation>
    </message>
    <message>
        <source>Set-point, slider</source>
        <translation>Sollwert, Schieber</translation>
    </message>
    <message>
        <source>Range of the set-point, either way</source>
        <translation>Bereich des Sollwerts, je Richtung</translation>
    </message>
    <message>
        <source>A set-point beyond it is refused: the limit of the hand, not of the drive.</source>
        <translation>Ein Sollwert darüber wird abgelehnt: Grenze der Bedienung, nicht des Geräts.</translation>
    </message>
    <message>
        <source>at once, as a step</source>
        <translation>sofort, als Sprung</translation>
    </message>
    <message>
        <source>full range in %1</source>
        <translation>voller Bereich in %1</translation>
    </message>
    <message>
        <source>How fast the set-point moves</source>
        <translation>Wie schnell sich der Sollwert ändert</translation>
    </message>
    <message>
        <source>This program moves the set-point no faster, whatever is typed.</source>
        <translation>Schneller ändert dieses Programm den Sollwert nicht, was auch eingegeben wird.</translation>
    </message>
    <message>
        <source>Range ±</source>
        <translation>Bereich ±</translation>
    </message>
    <message>
        <source>Moves</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>Ramp, brake, direction, limits</source>
        <translation>Rampe, Bremse, Richtung, Grenzen</translation>
    </message>
    <message>
        <source>Hide drive options</source>
        <translation>Optionen ausblenden</translation>
    </message>
    <message>
        <source>device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>No set-point. Enter a number up to ± %1.</source>
        <translation>Kein Sollwert. Zahl bis ± %1 eingeben.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no number. Enter one up to ± %2.</source>
        <translation>„%1“ ist keine Zahl. Eine bis ± %2 eingeben.</translation>
    </message>
    <message>
        <source>%1 is no device number. Enter the number of the device to follow.</source>
        <translation>%1 ist keine Gerätenummer. Nummer des Geräts eingeben, dem gefolgt wird.</translation>
    </message>
    <message>
        <source>%1 is beyond the range of ± %2. Enter less, or widen the range.</source>
        <translation>%1 liegt außerhalb von ± %2. Weniger eingeben oder den Bereich erweitern.</translation>
    </message>
    <message>
        <source>now %1</source>
        <translation>jetzt %1</translation>
    </message>
</context>
<context>
    <name>mb::SignalList</name>
    <message>
        <source>Add a signal</source>
        <translation>Signale</translation>
    </message>
    <message>
        <source>double click or tick</source>
        <translation>Doppelklick oder Haken</translation>
    </message>
    <message>
        <source>Signals that can be plotted</source>
        <translation>Darstellbare Signale</translation>
    </message>
    <message>
        <source>small</source>
        <extracomment>Translate as &quot;capital&quot; where a noun has a capital letter in the middle of a line too.</extracomment>
        <translation>capital</translation>
    </message>
</context>
<context>
    <name>mb::StagedEdits</name>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
</context>
<context>
    <name>mb::StateGlyph</name>
    <message>
        <source>online</source>
        <translation>online</translation>
    </message>
    <message>
        <source>moving</source>
        <translation>in Bewegung</translation>
    </message>
    <message>
        <source>in bootloader</source>
        <translation>im Bootloader</translation>
    </message>
    <message>
        <source>2 ×</source>
        <translation>2 ×</translation>
    </message>
    <message>
        <source>number 0</source>
        <translation>Nummer 0</translation>
    </message>
    <message>
        <source>fault</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>keine Antwort</translation>
    </message>
    <message>
        <source>stored</source>
        <translation>gespeichert</translation>
    </message>
    <message>
        <source>RAM, not in flash</source>
        <translation>RAM, nicht im Flash</translation>
    </message>
    <message>
        <source>edited</source>
        <translation>geändert</translation>
    </message>
    <message>
        <source>out of range</source>
        <translation>außerhalb</translation>
    </message>
    <message>
        <source>assumed</source>
        <translation>angenommen</translation>
    </message>
    <message>
        <source>volatile</source>
        <translation>flüchtig</translation>
    </message>
    <message>
        <source>busy</source>
        <translation>beschäftigt</translation>
    </message>
    <message>
        <source>done</source>
        <translation>fertig</translation>
    </message>
    <message>
        <source>waiting</source>
        <translation>wartet</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>recording</source>
        <translation>Aufnahme</translation>
    </message>
</context>
<context>
    <name>mb::StepTable</name>
    <message>
        <source>Show in plot</source>
        <translation>Im Diagramm zeigen</translation>
    </message>
    <message>
        <source>Use these gains</source>
        <translation>Diese Verstärkungen</translation>
    </message>
    <message>
        <source>Stages the gains of the step that is selected; nothing is written yet.</source>
        <translation>Merkt die Verstärkungen des gewählten Sprungs vor; geschrieben wird noch nichts.</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Sprünge</translation>
    </message>
    <message>
        <source>Steps of this session</source>
        <translation>Sprünge dieser Sitzung</translation>
    </message>
    <message>
        <source>step</source>
        <translation>Sprung</translation>
    </message>
    <message>
        <source>set-point</source>
        <translation>Sollwert</translation>
    </message>
    <message>
        <source>P</source>
        <translation>P</translation>
    </message>
    <message>
        <source>I</source>
        <translation>I</translation>
    </message>
    <message>
        <source>D</source>
        <translation>D</translation>
    </message>
    <message>
        <source>F</source>
        <translation>F</translation>
    </message>
    <message>
        <source>over %</source>
        <translation>über %</translation>
    </message>
    <message>
        <source>settle</source>
        <translation>Ausregel</translation>
    </message>
    <message>
        <source>rise</source>
        <translation>Anstieg</translation>
    </message>
    <message>
        <source>error %</source>
        <translation>Abw. %</translation>
    </message>
    <message>
        <source>peak A</source>
        <translation>Spitze A</translation>
    </message>
    <message>
        <source>note</source>
        <translation>Notiz</translation>
    </message>
    <message>
        <source>Overshoot in per cent of the step</source>
        <translation>Überschwingen in Prozent des Sprungs</translation>
    </message>
    <message>
        <source>Milliseconds until it stays within 2 %, or within the noise</source>
        <translation>Millisekunden, bis die Größe innerhalb 2 % oder des Rauschens bleibt</translation>
    </message>
    <message>
        <source>Milliseconds from 10 to 90 %</source>
        <translation>Millisekunden von 10 auf 90 %</translation>
    </message>
    <message>
        <source>What is missing to the set-point in the end</source>
        <translation>Was am Ende zum Sollwert fehlt</translation>
    </message>
    <message>
        <source>Every run appears here with its gains and what became of it.</source>
        <translation>Jeder Lauf erscheint hier mit seinen Verstärkungen und dem Ergebnis.</translation>
    </message>
    <message>
        <source>%1 this session, every run is kept</source>
        <translation>%1 in dieser Sitzung, jeder Lauf bleibt</translation>
    </message>
    <message>
        <source>running</source>
        <translation>läuft</translation>
    </message>
    <message>
        <source>did not move</source>
        <translation>nicht bewegt</translation>
    </message>
    <message>
        <source>cut short</source>
        <translation>abgebrochen</translation>
    </message>
    <message>
        <source>%1 lost</source>
        <translation>%1 verloren</translation>
    </message>
    <message>
        <source>ramp %1</source>
        <translation>Rampe %1</translation>
    </message>
    <message>
        <source>band ±%1 %</source>
        <translation>Band ±%1 %</translation>
    </message>
    <message>
        <source>does not settle</source>
        <translation>schwingt nicht ein</translation>
    </message>
</context>
<context>
    <name>mb::StopButton</name>
    <message>
        <source>Space · Esc</source>
        <translation>Leertaste · Esc</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>STOP</translation>
    </message>
    <message>
        <source>Stop every motor</source>
        <translation>Alle Motoren stoppen</translation>
    </message>
    <message>
        <source>Stop every motor  Space, Esc, Pause</source>
        <translation>Alle Motoren stoppen  Leertaste, Esc, Pause</translation>
    </message>
</context>
<context>
    <name>mb::Tour</name>
    <message>
        <source>tour</source>
        <translation>Rundgang</translation>
    </message>
</context>
<context>
    <name>mb::TraceList</name>
    <message>
        <source>Remove the trace</source>
        <translation>Kurve entfernen</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>%1 entfernen</translation>
    </message>
    <message>
        <source>Traces</source>
        <translation>Kurven</translation>
    </message>
</context>
<context>
    <name>mb::TunePage</name>
    <message>
        <source>Stop motion</source>
        <translation>Bewegung stoppen</translation>
    </message>
    <message>
        <source>Ends the motion and stays armed. STOP, Esc and Pause stop everything.</source>
        <translation>Beendet die Bewegung und bleibt scharf. STOP, Esc und Pause stoppen alles.</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Write and run</source>
        <translation>Schreiben + Start</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Übernehmen</translation>
    </message>
    <message>
        <source>Write gains</source>
        <translation>Schreiben</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>Revert all staged gains</source>
        <translation>Alle vorgemerkten Verstärkungen zurücksetzen</translation>
    </message>
    <message>
        <source>the running slot</source>
        <translation>der laufende Slot</translation>
    </message>
    <message>
        <source>a direction or a limit</source>
        <translation>eine Richtung oder Grenze</translation>
    </message>
    <message>
        <source>disarmed: another device is selected</source>
        <translation>gesichert: ein anderes Gerät ist gewählt</translation>
    </message>
    <message>
        <source>%1 is in its bootloader</source>
        <translation>%1 ist im Bootloader</translation>
    </message>
    <message>
        <source>It cannot drive a motor until it has firmware. Write an image on the Firmware page.</source>
        <translation>Ohne Firmware steuert es keinen Motor an. Auf der Seite Firmware ein Image schreiben.</translation>
    </message>
    <message>
        <source>Select a device</source>
        <translation>Gerät wählen</translation>
    </message>
    <message>
        <source>No device yet</source>
        <translation>Noch kein Gerät</translation>
    </message>
    <message>
        <source>Choose one in the list at the left; its loop is tuned here.</source>
        <translation>Links in der Liste eines wählen; hier wird sein Regler eingestellt.</translation>
    </message>
    <message>
        <source>Open a link, or the simulated bench from the menu, to drive a motor.</source>
        <translation>Eine Verbindung oder im Menü den simulierten Prüfstand öffnen, um einen Motor anzusteuern.</translation>
    </message>
    <message>
        <source>No device</source>
        <translation>Kein Gerät</translation>
    </message>
    <message>
        <source>No answer from %1</source>
        <translation>Keine Antwort von %1</translation>
    </message>
    <message>
        <source>The plot keeps what it has.</source>
        <translation>Die Kurve behält, was sie hat.</translation>
    </message>
    <message>
        <source>Stopped: %1</source>
        <translation>Gestoppt: %1</translation>
    </message>
    <message>
        <source>Hold the lamp for 1 s to arm again.</source>
        <translation>Lampe 1 s halten, um neu scharf zu schalten.</translation>
    </message>
    <message>
        <source>%1 cannot be armed</source>
        <translation>%1 lässt sich nicht scharf schalten</translation>
    </message>
    <message>
        <source>The set-point cannot be sent</source>
        <translation>Der Sollwert lässt sich nicht senden</translation>
    </message>
    <message>
        <source>A gain is out of range</source>
        <translation>Eine Verstärkung liegt außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>Correct or revert it first.</source>
        <translation>Zuerst korrigieren oder zurücksetzen.</translation>
    </message>
    <message>
        <source>Writing gains</source>
        <translation>Schreibt Verstärkungen</translation>
    </message>
    <message>
        <source>Reading gains</source>
        <translation>Liest Verstärkungen</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Moving</source>
        <translation>In Bewegung</translation>
    </message>
    <message>
        <source>Armed</source>
        <translation>Scharf</translation>
    </message>
    <message>
        <source>F5 runs %1</source>
        <translation>F5 startet %1</translation>
    </message>
    <message>
        <source>Not armed</source>
        <translation>Nicht scharf</translation>
    </message>
    <message>
        <source>Hold the lamp for 1 s to arm %1.</source>
        <translation>Lampe 1 s halten, um %1 scharf zu schalten.</translation>
    </message>
    <message>
        <source>%1, slot %2</source>
        <translation>%1, Slot %2</translation>
    </message>
    <message numerus="yes">
        <source>%n value(s)</source>
        <translation>
            <numerusform>%n Wert</numerusform>
            <numerusform>%n Werte</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing to write</source>
        <translation>Nichts zu schreiben</translation>
    </message>
    <message>
        <source>Write %1 to slot %2</source>
        <translation>%1 in Slot %2 schreiben</translation>
    </message>
    <message>
        <source>Write %1</source>
        <translation>%1 schreiben</translation>
    </message>
    <message>
        <source>No gain is edited</source>
        <translation>Keine Verstärkung ist geändert</translation>
    </message>
    <message>
        <source>The device is busy</source>
        <translation>Das Gerät ist beschäftigt</translation>
    </message>
    <message>
        <source>disarmed: %1 changed</source>
        <translation>gesichert: %1 geändert</translation>
    </message>
    <message>
        <source>the mode</source>
        <translation>Betriebsart</translation>
    </message>
    <message>
        <source>not run: %1. %2</source>
        <translation>nicht gestartet: %1. %2</translation>
    </message>
    <message>
        <source>gains not written: %1</source>
        <translation>Verstärkungen nicht geschrieben: %1</translation>
    </message>
    <message>
        <source>Gains of step #%1</source>
        <translation>Verstärkungen von Sprung #%1</translation>
    </message>
</context>
<context>
    <name>mb::TunePlot</name>
    <message>
        <source>Units</source>
        <translation>Einheiten</translation>
    </message>
    <message>
        <source>counts</source>
        <translation>counts</translation>
    </message>
    <message>
        <source>rpm</source>
        <translation>1/min</translation>
    </message>
    <message>
        <source>Counts per revolution</source>
        <translation>Counts je Umdrehung</translation>
    </message>
    <message>
        <source>Encoder counts of one turn of the shaft, four for each line. Used for rpm, degrees and gains in physical units.</source>
        <translation>Encoder-Counts einer Wellenumdrehung, vier je Strich. Für 1/min, Grad und Verstärkungen in physikalischen Einheiten.</translation>
    </message>
    <message>
        <source>counts/rev</source>
        <translation>counts/U</translation>
    </message>
    <message>
        <source>last %1 s</source>
        <translation>letzte %1 s</translation>
    </message>
    <message>
        <source>Length of the time axis</source>
        <translation>Länge der Zeitachse</translation>
    </message>
    <message>
        <source>Pause the view</source>
        <translation>Anzeige anhalten</translation>
    </message>
    <message>
        <source>Cursors A and B</source>
        <translation>Cursor A und B</translation>
    </message>
    <message>
        <source>Fit time and value</source>
        <translation>Zeit und Wert einpassen</translation>
    </message>
    <message>
        <source>plot written to %1</source>
        <translation>Kurve geschrieben nach %1</translation>
    </message>
    <message>
        <source>%1 cannot be written</source>
        <translation>%1 lässt sich nicht schreiben</translation>
    </message>
    <message>
        <source>Set-point</source>
        <translation>Sollwert</translation>
    </message>
    <message>
        <source>DEMO</source>
        <translation>DEMO</translation>
    </message>
    <message>
        <source>±%1 % of the step</source>
        <translation>±%1 % des Sprungs</translation>
    </message>
    <message>
        <source>peak %1 %</source>
        <translation>Spitze %1 %</translation>
    </message>
    <message>
        <source>#%1 settles %2</source>
        <translation>#%1 ausgeregelt %2</translation>
    </message>
</context>
<context>
    <name>table</name>
    <message>
        <source>%1 is switched off; bring it up: %2</source>
        <translation>%1 ist ausgeschaltet; einschalten: %2</translation>
    </message>
    <message>
        <source>%1 is bus-off: check wiring, termination and bit rate, then: %2</source>
        <translation>%1 ist bus-off: Verdrahtung, Abschluss und Bitrate prüfen, dann: %2</translation>
    </message>
    <message>
        <source>no permission to open CAN sockets here; allow them in the container or sandbox</source>
        <translation>keine Berechtigung für CAN-Sockets; im Container oder in der Sandbox freigeben</translation>
    </message>
    <message>
        <source>this kernel has no CAN support; load it: %1</source>
        <translation>dieser Kernel kennt kein CAN; laden: %1</translation>
    </message>
    <message>
        <source>CAN sockets cannot be opened: %1</source>
        <translation>CAN-Sockets lassen sich nicht öffnen: %1</translation>
    </message>
    <message>
        <source>the kernel does not list its interfaces: %1</source>
        <translation>der Kernel nennt seine Schnittstellen nicht: %1</translation>
    </message>
    <message>
        <source>there is no CAN interface; plug in an adapter</source>
        <translation>keine CAN-Schnittstelle vorhanden; Adapter einstecken</translation>
    </message>
    <message>
        <source>there is no CAN interface %1</source>
        <translation>keine CAN-Schnittstelle %1 vorhanden</translation>
    </message>
    <message>
        <source>%1 is a network interface, but not one for CAN</source>
        <translation>%1 ist eine Netzwerkschnittstelle, aber keine für CAN</translation>
    </message>
    <message>
        <source>%1 was switched off</source>
        <translation>%1 wurde ausgeschaltet</translation>
    </message>
    <message>
        <source>%1 is gone</source>
        <translation>%1 ist weg</translation>
    </message>
    <message>
        <source>the other end of %1 closed it</source>
        <translation>die Gegenseite hat %1 geschlossen</translation>
    </message>
    <message>
        <source>no permission to use %1; allow CAN sockets in the container or sandbox</source>
        <translation>keine Berechtigung für %1; CAN-Sockets im Container oder in der Sandbox freigeben</translation>
    </message>
    <message>
        <source>no permission to use %1; become a member of its group: %2</source>
        <translation>keine Berechtigung für %1; der Gruppe beitreten: %2</translation>
    </message>
    <message>
        <source>there is no CAN plugin %1; installed are: %2</source>
        <translation>kein CAN-Plugin %1 vorhanden; installiert sind: %2</translation>
    </message>
    <message>
        <source>%1 was disconnected</source>
        <translation>%1 wurde getrennt</translation>
    </message>
    <message>
        <source>bus-off: the adapter left the bus after too many errors; check wiring, termination and bit rate</source>
        <translation>bus-off: der Adapter hat den Bus nach zu vielen Fehlern verlassen; Verdrahtung, Abschluss und Bitrate prüfen</translation>
    </message>
    <message>
        <source>bus-off: the controller left the bus after too many errors; check wiring, termination and bit rate</source>
        <translation>bus-off: der CAN-Controller hat den Bus nach zu vielen Fehlern verlassen; Verdrahtung, Abschluss und Bitrate prüfen</translation>
    </message>
    <message>
        <source>bus-off: %1 left the bus after too many errors; check wiring, termination and bit rate</source>
        <translation>bus-off: %1 hat den Bus nach zu vielen Fehlern verlassen; Verdrahtung, Abschluss und Bitrate prüfen</translation>
    </message>
    <message>
        <source>%1, listen-only: nothing can be sent</source>
        <translation>%1, nur Empfang: Senden ist nicht möglich</translation>
    </message>
    <message>
        <source>virtual</source>
        <translation>virtuell</translation>
    </message>
    <message>
        <source>%1; %2 links are not supported yet</source>
        <translation>%1; Verbindungen über %2 werden noch nicht unterstützt</translation>
    </message>
    <message>
        <source>%1 links are not supported yet</source>
        <translation>Verbindungen über %1 werden noch nicht unterstützt</translation>
    </message>
    <message>
        <source>socketcan links have no option &apos;%1&apos;</source>
        <translation>socketcan kennt die Option „%1“ nicht</translation>
    </message>
    <message>
        <source>unknown link kind &apos;%1&apos;: sim, socketcan, qtcan, serial, spidev, unix and replay are known</source>
        <translation>unbekannte Art von Verbindung „%1“: bekannt sind sim, socketcan, qtcan, serial, spidev, unix und replay</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a link: SCHEME:PATH is needed, such as socketcan:can0 or sim:</source>
        <translation>„%1“ ist keine Verbindung: nötig ist SCHEME:PATH, etwa socketcan:can0 oder sim:</translation>
    </message>
    <message>
        <source>&apos;%1&apos; names no interface</source>
        <translation>„%1“ nennt keine Schnittstelle</translation>
    </message>
    <message>
        <source>link option &apos;%1&apos; is not KEY=VALUE</source>
        <translation>Option „%1“ der Verbindung ist nicht KEY=VALUE</translation>
    </message>
    <message>
        <source>link option %1 is out of range</source>
        <translation>Option %1 der Verbindung liegt außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>%1 is not open</source>
        <translation>%1 ist nicht offen</translation>
    </message>
    <message>
        <source>the link is not open</source>
        <translation>die Verbindung ist nicht offen</translation>
    </message>
    <message>
        <source>is back</source>
        <translation>ist wieder da</translation>
    </message>
    <message>
        <source>several units answer as number %1; control is locked until one has another number</source>
        <translation>mehrere Geräte antworten als Nummer %1; Ansteuerung gesperrt, bis eines eine andere Nummer hat</translation>
    </message>
    <message>
        <source>several units answer as number %1</source>
        <translation>mehrere Geräte antworten als Nummer %1</translation>
    </message>
    <message>
        <source>this unit has no number yet; assign one before it is driven</source>
        <translation>dieses Gerät hat noch keine Nummer; vor dem Ansteuern eine zuweisen</translation>
    </message>
    <message>
        <source>no application runs in this unit; update its firmware first</source>
        <translation>in diesem Gerät läuft keine Anwendung; zuerst die Firmware aktualisieren</translation>
    </message>
    <message>
        <source>another master drives %1; stop it there first</source>
        <translation>ein anderer Master steuert %1 an; zuerst dort stoppen</translation>
    </message>
    <message>
        <source>another master sends control frames to this device</source>
        <translation>ein anderer Master sendet Steuerframes an dieses Gerät</translation>
    </message>
    <message>
        <source>nobody renewed the motion lease</source>
        <translation>niemand hat die Freigabe der Bewegung erneuert</translation>
    </message>
    <message>
        <source>the motor was stopped; arm again</source>
        <translation>der Motor wurde gestoppt; neu scharf schalten</translation>
    </message>
    <message>
        <source>the device restarted</source>
        <translation>das Gerät ist neu gestartet</translation>
    </message>
    <message>
        <source>the device is not heard any more</source>
        <translation>vom Gerät kommt nichts mehr</translation>
    </message>
    <message>
        <source>the device is gone</source>
        <translation>das Gerät ist weg</translation>
    </message>
    <message>
        <source>the device is busy with something else</source>
        <translation>das Gerät ist mit etwas anderem beschäftigt</translation>
    </message>
    <message>
        <source>firmware update</source>
        <translation>Firmware-Update</translation>
    </message>
    <message>
        <source>stopped: %1</source>
        <translation>gestoppt: %1</translation>
    </message>
    <message>
        <source>follow needs the number of a device</source>
        <translation>Folgen braucht die Nummer eines Geräts</translation>
    </message>
    <message>
        <source>a device cannot follow itself</source>
        <translation>ein Gerät kann sich nicht selbst folgen</translation>
    </message>
    <message>
        <source>the ramp must be 0 (immediate) or a positive number of duty per second</source>
        <translation>die Rampe ist 0 (sofort) oder ein positiver Tastgrad pro Sekunde</translation>
    </message>
    <message>
        <source>This unit has no number yet; assign one from 1 to 62.</source>
        <translation>Dieses Gerät hat noch keine Nummer; eine von 1 bis 62 zuweisen.</translation>
    </message>
    <message>
        <source>This unit has no number and no application; assign a number, then update its firmware.</source>
        <translation>Dieses Gerät hat weder Nummer noch Anwendung; Nummer zuweisen, dann Firmware aktualisieren.</translation>
    </message>
    <message>
        <source>The bootloader runs; restart the unit or update its firmware.</source>
        <translation>Der Bootloader läuft; Gerät neu starten oder Firmware aktualisieren.</translation>
    </message>
    <message>
        <source>No application runs; update its firmware.</source>
        <translation>Es läuft keine Anwendung; Firmware aktualisieren.</translation>
    </message>
    <message>
        <source>Number %1 is used by %2 units; give each its own before one is driven.</source>
        <translation>Nummer %1 haben %2 Geräte; jedem eine eigene geben, bevor eines angesteuert wird.</translation>
    </message>
    <message>
        <source>Product %1 is not known to be a DMC60C.</source>
        <translation>Produkt %1 ist nicht als DMC60C bekannt.</translation>
    </message>
    <message>
        <source>the unit restarted: what is volatile was lost, its parameters are read again</source>
        <translation>das Gerät ist neu gestartet: Flüchtiges ist verloren, die Parameter werden neu gelesen</translation>
    </message>
    <message>
        <source>number %1 is used by another unit</source>
        <translation>Nummer %1 hat schon ein anderes Gerät</translation>
    </message>
    <message>
        <source>a device number is 1 … 63</source>
        <translation>eine Gerätenummer ist 1 … 63</translation>
    </message>
    <message>
        <source>a name has 1 to 64 characters</source>
        <translation>ein Name hat 1 bis 64 Zeichen</translation>
    </message>
    <message>
        <source>a name may hold Latin-1 characters only</source>
        <translation>ein Name darf nur Latin-1-Zeichen enthalten</translation>
    </message>
    <message>
        <source>Identify</source>
        <translation>Identifizieren</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>Look at the restarted unit</source>
        <translation>Neu gestartetes Gerät erfassen</translation>
    </message>
    <message>
        <source>Read parameters</source>
        <translation>Parameter lesen</translation>
    </message>
    <message>
        <source>Write parameters</source>
        <translation>Parameter schreiben</translation>
    </message>
    <message>
        <source>Store to flash</source>
        <translation>Im Flash speichern</translation>
    </message>
    <message>
        <source>Assign number</source>
        <translation>Nummer zuweisen</translation>
    </message>
    <message>
        <source>Read and clear faults</source>
        <translation>Fehler lesen und löschen</translation>
    </message>
    <message>
        <source>Set telemetry rate</source>
        <translation>Telemetrierate setzen</translation>
    </message>
    <message>
        <source>Update firmware</source>
        <translation>Firmware aktualisieren</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>Lese %1</translation>
    </message>
    <message>
        <source>Read</source>
        <translation>Gelesen</translation>
    </message>
    <message>
        <source>Writing %1</source>
        <translation>Schreibe %1</translation>
    </message>
    <message>
        <source>Written</source>
        <translation>Geschrieben</translation>
    </message>
    <message>
        <source>%1 parameters gave no answer</source>
        <translation>%1 Parameter ohne Antwort</translation>
    </message>
    <message>
        <source>all %1 read</source>
        <translation>alle %1 gelesen</translation>
    </message>
    <message>
        <source>%1 written, read back and equal</source>
        <translation>%1 geschrieben, zurückgelesen und gleich</translation>
    </message>
    <message>
        <source>stored, the flash sequence number advanced</source>
        <translation>gespeichert, die Flash-Sequenznummer ist gestiegen</translation>
    </message>
    <message>
        <source>stored, not verifiable</source>
        <translation>gespeichert, nicht nachweisbar</translation>
    </message>
    <message>
        <source>Waiting until the device has written its flash</source>
        <translation>Warte, bis das Gerät seinen Flash geschrieben hat</translation>
    </message>
    <message>
        <source>the device did not write its flash within 20 s</source>
        <translation>das Gerät hat seinen Flash nicht innerhalb von 20 s geschrieben</translation>
    </message>
    <message>
        <source>the device restarted before its flash was proved to be written; read it again</source>
        <translation>Neustart, bevor das Schreiben des Flash nachgewiesen war; neu lesen</translation>
    </message>
    <message>
        <source>the position is written only while the output is off; stop the motor first</source>
        <translation>die Position wird nur bei abgeschaltetem Ausgang geschrieben; zuerst den Motor stoppen</translation>
    </message>
    <message>
        <source>%1 was %2 and is not known to be cleared</source>
        <translation>%1 war %2; ob gelöscht, ist nicht bekannt</translation>
    </message>
    <message>
        <source>%1 was written as %2 but reads %3</source>
        <translation>%1 wurde als %2 geschrieben, gelesen wird %3</translation>
    </message>
    <message>
        <source>%1 cannot be read from the device</source>
        <translation>%1 lässt sich nicht vom Gerät lesen</translation>
    </message>
    <message>
        <source>%1 is read-only</source>
        <translation>%1 ist nur lesbar</translation>
    </message>
    <message>
        <source>%1 is above %2; legal is %3</source>
        <translation>%1 liegt über %2; zulässig ist %3</translation>
    </message>
    <message>
        <source>%1 is below %2; legal is %3</source>
        <translation>%1 liegt unter %2; zulässig ist %3</translation>
    </message>
    <message>
        <source>this firmware does not know the parameter</source>
        <translation>diese Firmware kennt den Parameter nicht</translation>
    </message>
    <message>
        <source>the device refused the value</source>
        <translation>das Gerät hat den Wert abgelehnt</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>keine Antwort</translation>
    </message>
    <message>
        <source>the device answers &apos;%1&apos;</source>
        <translation>das Gerät antwortet „%1“</translation>
    </message>
    <message>
        <source>%1 to number %2</source>
        <translation>%1 an Nummer %2</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2</source>
        <translation>%1 lässt sich nicht schreiben: %2</translation>
    </message>
    <message>
        <source>%1 cannot be read: %2</source>
        <translation>%1 lässt sich nicht lesen: %2</translation>
    </message>
    <message>
        <source>%1 does not exist</source>
        <translation>%1 gibt es nicht</translation>
    </message>
    <message>
        <source>%1 is a directory</source>
        <translation>%1 ist ein Ordner</translation>
    </message>
    <message>
        <source>%1 is larger than %2 bytes</source>
        <translation>%1 ist größer als %2 Byte</translation>
    </message>
    <message>
        <source>not a parameter file: %1</source>
        <translation>keine Parameterdatei: %1</translation>
    </message>
    <message>
        <source>no object at the top</source>
        <translation>kein Objekt auf oberster Ebene</translation>
    </message>
    <message>
        <source>unknown key %1</source>
        <translation>unbekannter Schlüssel %1</translation>
    </message>
    <message>
        <source>%1 was unknown when the file was written</source>
        <translation>%1 war beim Schreiben der Datei unbekannt</translation>
    </message>
    <message>
        <source>the file is for family &apos;%1&apos;, the device is a %2</source>
        <translation>die Datei ist für die Familie „%1“, das Gerät ist ein %2</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>die Datei ist leer</translation>
    </message>
    <message>
        <source>the end-of-file record is missing, the file may be cut off</source>
        <translation>der Endesatz fehlt, die Datei ist wohl abgeschnitten</translation>
    </message>
    <message>
        <source>the file holds no data</source>
        <translation>die Datei enthält keine Daten</translation>
    </message>
    <message>
        <source>something follows the end-of-file record</source>
        <translation>hinter dem Endesatz folgt noch etwas</translation>
    </message>
    <message>
        <source>%1 where a record begins with a colon, is this an Intel HEX file?</source>
        <translation>%1, wo ein Satz mit Doppelpunkt beginnt: ist das eine Intel-HEX-Datei?</translation>
    </message>
    <message>
        <source>checksum is %1, %2 is needed</source>
        <translation>Prüfsumme ist %1, nötig ist %2</translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>Zeile %1: %2</translation>
    </message>
    <message>
        <source>no data in page 0 (0x00000-0x00FFF), the file is not a whole application</source>
        <translation>keine Daten in Seite 0 (0x00000-0x00FFF), die Datei ist keine vollständige Anwendung</translation>
    </message>
    <message>
        <source>no data in page 30 (0x1E000-0x1EFFF), where the version is</source>
        <translation>keine Daten in Seite 30 (0x1E000-0x1EFFF), wo die Version steht</translation>
    </message>
    <message>
        <source>not sent: %1 for %2</source>
        <translation>nicht gesendet: %1 für %2</translation>
    </message>
    <message>
        <source>not sent: %1 outside the controller&apos;s flash</source>
        <translation>nicht gesendet: %1 außerhalb des Flash</translation>
    </message>
    <message>
        <source>%1 bytes</source>
        <translation>%1 Byte</translation>
    </message>
    <message>
        <source>pages 31-34 (configuration and descriptors)</source>
        <translation>Seiten 31-34 (Konfiguration und Deskriptoren)</translation>
    </message>
    <message>
        <source>pages 35-42 (bootloader and flash configuration)</source>
        <translation>Seiten 35-42 (Bootloader und Flash-Konfiguration)</translation>
    </message>
    <message>
        <source>the user-ID words</source>
        <translation>die User-ID-Worte</translation>
    </message>
    <message>
        <source>Preflight</source>
        <translation>Vorprüfung</translation>
    </message>
    <message>
        <source>Enter bootloader</source>
        <translation>Wechsel in den Bootloader</translation>
    </message>
    <message>
        <source>All pages written</source>
        <translation>Alle Seiten geschrieben</translation>
    </message>
    <message>
        <source>Restart</source>
        <translation>Neustart</translation>
    </message>
    <message>
        <source>Page %1</source>
        <translation>Seite %1</translation>
    </message>
    <message>
        <source>image %1 of %2 pages, unit %3, bootloader %4</source>
        <translation>Image %1 mit %2 Seiten, Gerät %3, Bootloader %4</translation>
    </message>
    <message>
        <source>without application</source>
        <translation>ohne Anwendung</translation>
    </message>
    <message>
        <source>runs %1</source>
        <translation>mit %1</translation>
    </message>
    <message>
        <source>in bootloader %1, session kept</source>
        <translation>im Bootloader %1, Sitzung bleibt</translation>
    </message>
    <message>
        <source>the device may have restarted: once more from page %1</source>
        <translation>das Gerät ist wohl neu gestartet: noch einmal ab Seite %1</translation>
    </message>
    <message>
        <source>the device restarted %1 times during the update</source>
        <translation>das Gerät ist während des Updates %1-mal neu gestartet</translation>
    </message>
    <message>
        <source>CRC refused, nothing was erased; trying variant %1</source>
        <translation>CRC abgelehnt, nichts gelöscht; Versuch mit Variante %1</translation>
    </message>
    <message>
        <source>page %1 accepted with CRC variant %2</source>
        <translation>Seite %1 mit CRC-Variante %2 angenommen</translation>
    </message>
    <message>
        <source>page 0: its status was lost, but the version is there; it is not written again</source>
        <translation>Seite 0: Status verloren, aber die Version ist da; sie wird nicht noch einmal geschrieben</translation>
    </message>
    <message>
        <source>page %1: %2, sent again</source>
        <translation>Seite %1: %2, erneut gesendet</translation>
    </message>
    <message>
        <source>arrived damaged, nothing was erased</source>
        <translation>beschädigt angekommen, nichts gelöscht</translation>
    </message>
    <message>
        <source>the device could not verify its flash</source>
        <translation>das Gerät konnte seinen Flash nicht prüfen</translation>
    </message>
    <message>
        <source>the byte count was out of step</source>
        <translation>die Byteanzahl stimmte nicht</translation>
    </message>
    <message>
        <source>no status within 2 s</source>
        <translation>kein Status innerhalb von 2 s</translation>
    </message>
    <message>
        <source>page %1 cannot be written: its flash failed the device&apos;s own check %2 times</source>
        <translation>Seite %1 lässt sich nicht schreiben: die Prüfung durch das Gerät schlug %2-mal fehl</translation>
    </message>
    <message>
        <source>page %1 was not accepted in %2 tries</source>
        <translation>Seite %1 wurde in %2 Versuchen nicht angenommen</translation>
    </message>
    <message>
        <source>restarted, the application answers</source>
        <translation>neu gestartet, die Anwendung antwortet</translation>
    </message>
    <message>
        <source>the answer to the reset was lost; found again by enumeration</source>
        <translation>die Antwort auf den Reset ging verloren; durch Enumeration wiedergefunden</translation>
    </message>
    <message>
        <source>%1; the unit waits in its bootloader, run the update again</source>
        <translation>%1; das Gerät wartet im Bootloader, Update wiederholen</translation>
    </message>
    <message>
        <source>the device already runs %1</source>
        <translation>das Gerät hat bereits %1</translation>
    </message>
    <message>
        <source>the device answers with version %1 instead of %2</source>
        <translation>das Gerät antwortet mit Version %1 statt %2</translation>
    </message>
    <message>
        <source>the device answers with version %1</source>
        <translation>das Gerät antwortet mit Version %1</translation>
    </message>
    <message>
        <source>the image is for product 602, this unit is product %1; nothing was written</source>
        <translation>das Image ist für Produkt 602, dieses Gerät ist Produkt %1; nichts wurde geschrieben</translation>
    </message>
    <message>
        <source>the unit does not answer an enumeration</source>
        <translation>das Gerät antwortet nicht auf eine Enumeration</translation>
    </message>
    <message>
        <source>firmware: %1</source>
        <translation>Firmware: %1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Velocity</source>
        <translation>Drehzahl</translation>
    </message>
    <message>
        <source>Current</source>
        <translation>Strom</translation>
    </message>
    <message>
        <source>Duty</source>
        <translation>Tastgrad</translation>
    </message>
    <message>
        <source>Set-point</source>
        <translation>Sollwert</translation>
    </message>
    <message>
        <source>Loop error</source>
        <translation>Regelabweichung</translation>
    </message>
    <message>
        <source>Supply</source>
        <translation>Versorgung</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>Temperatur</translation>
    </message>
    <message>
        <source>Analog input</source>
        <translation>Analogeingang</translation>
    </message>
    <message>
        <source>Limit switches</source>
        <translation>Endschalter</translation>
    </message>
    <message>
        <source>Soft limits</source>
        <translation>Softwaregrenzen</translation>
    </message>
    <message>
        <source>Loop, slot 0</source>
        <translation>Regler, Slot 0</translation>
    </message>
    <message>
        <source>Loop, slot 1</source>
        <translation>Regler, Slot 1</translation>
    </message>
    <message>
        <source>Current limiter</source>
        <translation>Strombegrenzer</translation>
    </message>
    <message>
        <source>Encoder</source>
        <translation>Encoder</translation>
    </message>
    <message>
        <source>Faults</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Current limit</source>
        <translation>Stromgrenze</translation>
    </message>
    <message>
        <source>Status frames</source>
        <translation>Statusframes</translation>
    </message>
    <message>
        <source>Normally closed is hit when the switch opens, normally open when it closes. A hit blocks output in this direction.</source>
        <translation>Ein Öffner spricht an, wenn er öffnet, ein Schließer, wenn er schließt. Dann ist der Ausgang in dieser Richtung gesperrt.</translation>
    </message>
    <message>
        <source>On switches the limit OFF: the sense is the opposite of the soft limits&apos; Enabled.</source>
        <translation>Ein schaltet den Endschalter AUS: umgekehrt wie „aktiv“ bei den Softwaregrenzen.</translation>
    </message>
    <message>
        <source>Output (32767 = 100 %) per unit of error: counts/100 ms, counts or A, depending on the mode.</source>
        <translation>Ausgang (32767 = 100 %) je Einheit der Abweichung: counts/100 ms, counts oder A, je nach Betriebsart.</translation>
    </message>
    <message>
        <source>Output per unit of error and loop of 500 µs. With F·K = 1 any I overshoots.</source>
        <translation>Ausgang je Einheit der Abweichung und Zyklus von 500 µs. Bei F·K = 1 schwingt jedes I über.</translation>
    </message>
    <message>
        <source>Output per change of error in one loop of 500 µs. One count of noise makes a spike of D.</source>
        <translation>Ausgang je Änderung der Abweichung in einem Zyklus von 500 µs. Ein count Rauschen ergibt eine Spitze von D.</translation>
    </message>
    <message>
        <source>Bound of the integral accumulator, raw integer. 0 means unlimited, not zero.</source>
        <translation>Grenze des Integrators, ganzzahliger Rohwert. 0 heißt unbegrenzt, nicht null.</translation>
    </message>
    <message>
        <source>Output per unit of set-point, added to P, I and D.</source>
        <translation>Ausgang je Einheit des Sollwerts, addiert zu P, I und D.</translation>
    </message>
    <message>
        <source>Below it P, I and D contribute nothing and the integral is cleared; F still applies. 0 switches the feature off.</source>
        <translation>Darunter wirken P, I und D nicht und der Integrator wird gelöscht; F wirkt weiter. 0 schaltet dies ab.</translation>
    </message>
    <message>
        <source>Greatest change of output in a loop of 500 µs; 16 takes 1.024 s from 0 to 100 %. Lower is slower, but 0 is no ramp.</source>
        <translation>Größte Änderung des Ausgangs je Zyklus von 500 µs; 16 braucht 1.024 s von 0 auf 100 %. Kleiner ist langsamer, aber 0 ist keine Rampe.</translation>
    </message>
    <message>
        <source>Greatest forward output, 32767 = 100 %.</source>
        <translation>Größter Ausgang vorwärts, 32767 = 100 %.</translation>
    </message>
    <message>
        <source>Greatest reverse output, −32768 = −100 %. A number at or below 0.</source>
        <translation>Größter Ausgang rückwärts, −32768 = −100 %. Eine Zahl bis höchstens 0.</translation>
    </message>
    <message>
        <source>Least forward output outside the allowable error; overcomes friction. Closed-loop modes only.</source>
        <translation>Kleinster Ausgang vorwärts außerhalb der zulässigen Abweichung; überwindet Reibung. Nur bei Regelung.</translation>
    </message>
    <message>
        <source>Least reverse output outside the allowable error, a number at or below 0. Closed-loop modes only.</source>
        <translation>Kleinster Ausgang rückwärts außerhalb der zulässigen Abweichung, höchstens 0. Nur bei Regelung.</translation>
    </message>
    <message>
        <source>Keeps clearing as long as the switch is active, even if its limit is disabled. Lost at power-off.</source>
        <translation>Löscht, solange der Schalter anspricht, auch bei abgeschalteter Grenze. Geht beim Ausschalten verloren.</translation>
    </message>
    <message>
        <source>Writing anything but 0 reads the count and clears it.</source>
        <translation>Schreiben eines Werts ungleich 0 liest den Zähler und löscht ihn.</translation>
    </message>
    <message>
        <source>Forward switch is normally closed</source>
        <translation>Öffner vorwärts</translation>
    </message>
    <message>
        <source>Forward switch disabled</source>
        <translation>Schalter vorw. aus</translation>
    </message>
    <message>
        <source>Reverse switch is normally closed</source>
        <translation>Öffner rückwärts</translation>
    </message>
    <message>
        <source>Reverse switch disabled</source>
        <translation>Schalter rückw. aus</translation>
    </message>
    <message>
        <source>Forward soft limit</source>
        <translation>Grenze vorwärts</translation>
    </message>
    <message>
        <source>At or above this position forward output is blocked, if enabled.</source>
        <translation>Ab dieser Position ist der Ausgang vorwärts gesperrt, wenn aktiv.</translation>
    </message>
    <message>
        <source>Forward soft limit enabled</source>
        <translation>Grenze vorw. aktiv</translation>
    </message>
    <message>
        <source>On switches the limit ON: the sense is the opposite of the switches&apos; Disabled.</source>
        <translation>Ein schaltet die Grenze EIN: umgekehrt wie „aus“ bei den Schaltern.</translation>
    </message>
    <message>
        <source>Reverse soft limit</source>
        <translation>Grenze rückwärts</translation>
    </message>
    <message>
        <source>At or below this position reverse output is blocked, if enabled.</source>
        <translation>Bis zu dieser Position ist der Ausgang rückwärts gesperrt, wenn aktiv.</translation>
    </message>
    <message>
        <source>Reverse soft limit enabled</source>
        <translation>Grenze rückw. aktiv</translation>
    </message>
    <message>
        <source>Current scale</source>
        <translation>Stromskalierung</translation>
    </message>
    <message>
        <source>Calibrated at the factory. All current limiting depends on it: change it only to trim the reading.</source>
        <translation>Im Werk abgeglichen. Die gesamte Strombegrenzung hängt davon ab: nur zum Abgleich der Messung ändern.</translation>
    </message>
    <message>
        <source>I zone</source>
        <translation>I-Zone</translation>
    </message>
    <message>
        <source>Allowable error</source>
        <translation>Zul. Abweichung</translation>
    </message>
    <message>
        <source>Ramp</source>
        <translation>Rampe</translation>
    </message>
    <message>
        <source>Maximum forward</source>
        <translation>Maximum vorwärts</translation>
    </message>
    <message>
        <source>Maximum reverse</source>
        <translation>Maximum rückwärts</translation>
    </message>
    <message>
        <source>Nominal forward</source>
        <translation>Minimum vorwärts</translation>
    </message>
    <message>
        <source>Nominal reverse</source>
        <translation>Minimum rückwärts</translation>
    </message>
    <message>
        <source>The factory value suits most motors.</source>
        <translation>Der Werkswert passt für die meisten Motoren.</translation>
    </message>
    <message>
        <source>The live count. Written only while the output is off.</source>
        <translation>Der aktuelle Zählerstand. Wird nur bei abgeschaltetem Ausgang geschrieben.</translation>
    </message>
    <message>
        <source>Index clears position</source>
        <translation>Index nullt Position</translation>
    </message>
    <message>
        <source>At the index edge chosen below. Lost at power-off.</source>
        <translation>An der unten gewählten Flanke des Index. Geht beim Ausschalten verloren.</translation>
    </message>
    <message>
        <source>Forward switch clears position</source>
        <translation>Vorw. Schalter nullt</translation>
    </message>
    <message>
        <source>Reverse switch clears position</source>
        <translation>Rückw. Schalter nullt</translation>
    </message>
    <message>
        <source>Index acts on its rising edge</source>
        <translation>Index steigend</translation>
    </message>
    <message>
        <source>Off is the falling edge. Lost at power-off.</source>
        <translation>Aus ist die fallende Flanke. Geht beim Ausschalten verloren.</translation>
    </message>
    <message>
        <source>Present faults</source>
        <translation>Anstehende Fehler</translation>
    </message>
    <message>
        <source>1 over-current, 2 over-temperature, 4 under-voltage, 8 gate driver, 16 communication.</source>
        <translation>1 Überstrom, 2 Übertemperatur, 4 Unterspannung, 8 Gatetreiber, 16 Kommunikation.</translation>
    </message>
    <message>
        <source>Faults since the last clear</source>
        <translation>Gemerkte Fehler</translation>
    </message>
    <message>
        <source>The bits of the present faults. Writing anything but 0 reads them and clears them.</source>
        <translation>Die Bits der anstehenden Fehler. Schreiben eines Werts ungleich 0 liest und löscht sie.</translation>
    </message>
    <message>
        <source>Over-current count</source>
        <translation>Überströme</translation>
    </message>
    <message>
        <source>Over-temperature count</source>
        <translation>Übertemperaturen</translation>
    </message>
    <message>
        <source>Under-voltage count</source>
        <translation>Unterspannungen</translation>
    </message>
    <message>
        <source>Supply below 5.75 V for 5 s. Writing anything but 0 reads the count and clears it.</source>
        <translation>Versorgung 5 s lang unter 5.75 V. Schreiben eines Werts ungleich 0 liest den Zähler und löscht ihn.</translation>
    </message>
    <message>
        <source>Gate driver count</source>
        <translation>Gatetreiberfehler</translation>
    </message>
    <message>
        <source>Usually a short between M+ and M−. Writing anything but 0 reads the count and clears it.</source>
        <translation>Meist ein Kurzschluss zwischen M+ und M−. Schreiben eines Werts ungleich 0 liest den Zähler und löscht ihn.</translation>
    </message>
    <message>
        <source>Communication loss count</source>
        <translation>Busausfälle</translation>
    </message>
    <message>
        <source>Since the last power-up. Writing anything but 0 reads the count and clears it.</source>
        <translation>Seit dem Einschalten. Schreiben eines Werts ungleich 0 liest den Zähler und löscht ihn.</translation>
    </message>
    <message>
        <source>Continuous limit</source>
        <translation>Dauergrenze</translation>
    </message>
    <message>
        <source>At or above the peak limit, limiting starts as soon as this is exceeded.</source>
        <translation>Ist sie nicht kleiner als die Spitzengrenze, wird begrenzt, sobald sie überschritten ist.</translation>
    </message>
    <message>
        <source>Peak limit</source>
        <translation>Spitzengrenze</translation>
    </message>
    <message>
        <source>Above it for the peak duration, the current is brought down to the continuous limit.</source>
        <translation>Liegt der Strom für die Spitzendauer darüber, wird er auf die Dauergrenze gesenkt.</translation>
    </message>
    <message>
        <source>Peak duration</source>
        <translation>Spitzendauer</translation>
    </message>
    <message>
        <source>Time above the peak limit before limiting starts; 0 limits at once.</source>
        <translation>Zeit über der Spitzengrenze, bevor begrenzt wird; 0 begrenzt sofort.</translation>
    </message>
    <message>
        <source>Current limit enabled</source>
        <translation>Begrenzung aktiv</translation>
    </message>
    <message>
        <source>Off is the factory setting: nothing limits the current.</source>
        <translation>Aus ist die Werkseinstellung: nichts begrenzt den Strom.</translation>
    </message>
    <message>
        <source>Analog period</source>
        <translation>Periode Analog</translation>
    </message>
    <message>
        <source>Milliseconds between frames, although the vendor calls it a rate. Back to 100 at every restart.</source>
        <translation>Millisekunden zwischen Frames, obwohl der Hersteller es Rate nennt. Nach jedem Neustart wieder 100.</translation>
    </message>
    <message>
        <source>Encoder period</source>
        <translation>Periode Encoder</translation>
    </message>
    <message>
        <source>General period</source>
        <translation>Periode Allgemein</translation>
    </message>
    <message>
        <source>Milliseconds between frames. At most 50, because followers stop after 104 ms without one.</source>
        <translation>Millisekunden zwischen Frames. Höchstens 50, weil Folger nach 104 ms ohne Frame anhalten.</translation>
    </message>
    <message>
        <source>the bootloader refuses %1</source>
        <translation>der Bootloader lehnt %1 ab</translation>
    </message>
    <message>
        <source>page %1</source>
        <translation>Seite %1</translation>
    </message>
</context>
</TS>
