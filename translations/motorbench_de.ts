<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>AnalysisText</name>
    <message>
        <source>%1: peak %2 at %3 Hz</source>
        <translation>%1: Spitze %2 bei %3 Hz</translation>
    </message>
    <message>
        <source>%1: fewer than 16 samples connect</source>
        <translation>%1: weniger als 16 zusammenhängende Werte</translation>
    </message>
    <message>
        <source>the longest stretch without a gap</source>
        <translation>der längste Abschnitt ohne Lücke</translation>
    </message>
    <message>
        <source>%1 against %2</source>
        <translation>%1 über %2</translation>
    </message>
    <message>
        <source>%1 points, every %2. sample</source>
        <translation>%1 Punkte, jeder %2. Wert</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 Punkte</translation>
    </message>
    <message>
        <source>%1: peak –</source>
        <translation>%1: Spitze –</translation>
    </message>
</context>
<context>
    <name>AxisParameters</name>
    <message>
        <source>axis %1</source>
        <translation>Achse %1</translation>
    </message>
</context>
<context>
    <name>AxisText</name>
    <message>
        <source>Axis %1</source>
        <translation>Achse %1</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <comment>mode and target</comment>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
</context>
<context>
    <name>DeviceActions</name>
    <message>
        <source>Identify (blink)</source>
        <translation>Identifizieren (blinken)</translation>
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
        <source>Stop and count from 0</source>
        <translation>Stoppen und ab 0 zählen</translation>
    </message>
    <message>
        <source>position 0 is here; the motor is off</source>
        <translation>Position 0 ist hier; der Motor ist aus</translation>
    </message>
    <message>
        <source>%1 cannot be opened: a link address has no place for the question mark in it. Rename it.</source>
        <translation>%1 lässt sich nicht öffnen: die Adresse einer Verbindung kann das Fragezeichen darin nicht aufnehmen. Datei umbenennen.</translation>
    </message>
    <message>
        <source>blinks</source>
        <translation>blinkt</translation>
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
    <message>
        <source>axis %1: %2</source>
        <translation>Achse %1: %2</translation>
    </message>
    <message>
        <source>Dialect %1</source>
        <translation>Dialekt %1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>on</source>
        <translation>ein</translation>
    </message>
    <message>
        <source>keeps a move</source>
        <translation>behält eine Bewegung</translation>
    </message>
    <message>
        <source>It keeps a move that was stopped before it began, and would begin it with the next start on its line. A new move replaces it; switching the unit off clears it.</source>
        <translation>Er behält eine Bewegung, die vor ihrem Beginn gestoppt wurde, und begänne sie mit dem nächsten Start auf seiner Leitung. Eine neue Bewegung ersetzt sie; Ausschalten löscht sie.</translation>
    </message>
    <message>
        <source>%1 of %2 axes move</source>
        <translation>%1 von %2 Achsen in Bewegung</translation>
    </message>
    <message>
        <source>%1 axes</source>
        <translation>%1 Achsen</translation>
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
        <source>no faults</source>
        <translation>keine Fehler</translation>
    </message>
</context>
<context>
    <name>DialogText</name>
    <message>
        <source>Signals that a formula may use</source>
        <translation>Signale, die eine Formel verwenden darf</translation>
    </message>
    <message>
        <source>Double click puts the name into the formula</source>
        <translation>Doppelklick setzt den Namen in die Formel ein</translation>
    </message>
    <message>
        <source>Note at this time</source>
        <translation>Notiz zu diesem Zeitpunkt</translation>
    </message>
    <message>
        <source>What happened</source>
        <translation>Was geschehen ist</translation>
    </message>
    <message>
        <source>Add note</source>
        <translation>Notiz hinzufügen</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Derived signal</source>
        <translation>Abgeleitetes Signal</translation>
    </message>
    <message>
        <source>counts/s², A, …</source>
        <translation>counts/s², A, …</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Formula</source>
        <translation>Formel</translation>
    </message>
    <message>
        <source>+ − * / ^ ( ) · derivative(x) · integral(x) · average(x, seconds) · abs, sqrt, sin, min, max … · values are in the unit of the device</source>
        <translation>+ − * / ^ ( ) · derivative(x) · integral(x) · average(x, Sekunden) · abs, sqrt, sin, min, max … · Werte in der Einheit des Geräts</translation>
    </message>
    <message>
        <source>Add signal</source>
        <translation>Signal hinzufügen</translation>
    </message>
    <message>
        <source>Export samples</source>
        <translation>Werte exportieren</translation>
    </message>
    <message>
        <source>Stretch</source>
        <translation>Abschnitt</translation>
    </message>
    <message>
        <source>What is seen</source>
        <translation>Sichtbarer Bereich</translation>
    </message>
    <message>
        <source>A … B</source>
        <translation>A … B</translation>
    </message>
    <message>
        <source>Whole session</source>
        <translation>Ganze Sitzung</translation>
    </message>
    <message>
        <source>Show the cursors first: L</source>
        <translation>Zuerst die Cursor einblenden: L</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>Signale</translation>
    </message>
    <message>
        <source>Plotted signals</source>
        <translation>Dargestellte Signale</translation>
    </message>
    <message>
        <source>All signals of all devices</source>
        <translation>Alle Signale aller Geräte</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>CSV table</source>
        <translation>CSV-Tabelle</translation>
    </message>
    <message>
        <source>MCAP recording</source>
        <translation>MCAP-Aufnahme</translation>
    </message>
    <message>
        <source>Both carry units, the devices with their parameters, notes, and how many samples were lost. MCAP opens in PlotJuggler and Foxglove.</source>
        <translation>Beide enthalten Einheiten, die Geräte mit ihren Parametern, Notizen und die Anzahl verlorener Werte. MCAP lässt sich in PlotJuggler und Foxglove öffnen.</translation>
    </message>
    <message>
        <source>Choose file…</source>
        <translation>Datei wählen…</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tabelle (*.csv)</translation>
    </message>
    <message>
        <source>MCAP recording (*.mcap)</source>
        <translation>MCAP-Aufnahme (*.mcap)</translation>
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
    <message>
        <source>%1 is for %2, %3 is of the family %4.</source>
        <translation>%1 ist für %2, %3 ist von der Familie %4.</translation>
    </message>
</context>
<context>
    <name>FrameFilterParser</name>
    <message>
        <source>&apos;)&apos; has no &apos;(&apos; before it</source>
        <translation>vor „)“ fehlt ein „(“</translation>
    </message>
    <message>
        <source>&apos;%1&apos; needs a term before it</source>
        <translation>„%1“ braucht einen Ausdruck davor</translation>
    </message>
    <message>
        <source>a term is missing after &apos;%1&apos;</source>
        <translation>nach „%1“ fehlt ein Ausdruck</translation>
    </message>
    <message>
        <source>&apos;(&apos; is not closed: a &apos;)&apos; is missing</source>
        <translation>„(“ ist nicht geschlossen: ein „)“ fehlt</translation>
    </message>
    <message>
        <source>more than %1 brackets and negations inside each other</source>
        <translation>mehr als %1 Klammern und Verneinungen ineinander</translation>
    </message>
</context>
<context>
    <name>FrameTermReader</name>
    <message>
        <source>&apos;%1&apos;: a comparison begins with field., such as field.%1</source>
        <translation>„%1“: ein Vergleich beginnt mit field., etwa field.%1</translation>
    </message>
    <message>
        <source>&apos;%1:&apos; has nothing after the colon</source>
        <translation>„%1:“ hat nichts nach dem Doppelpunkt</translation>
    </message>
    <message>
        <source>&apos;%1:&apos; is not known; id, family, message, device, dir, data, is and field. are</source>
        <translation>„%1:“ ist unbekannt; bekannt sind id, family, message, device, dir, data, is und field.</translation>
    </message>
    <message>
        <source>&apos;%1:&apos; is not known; &apos;%2:&apos; is</source>
        <translation>„%1:“ ist unbekannt; bekannt ist „%2:“</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no identifier: hexadecimal such as 0x2061405, 0x2061* or 100..1FF</source>
        <translation>„%1“ ist kein Identifier: hexadezimal, etwa 0x2061405, 0x2061* oder 100..1FF</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no device number: such as 5, 5,7 or 1..9</source>
        <translation>„%1“ ist keine Gerätenummer: etwa 5, 5,7 oder 1..9</translation>
    </message>
    <message>
        <source>&apos;%1&apos; are no bytes: hexadecimal such as A125*, without blanks</source>
        <translation>„%1“ sind keine Bytes: hexadezimal, etwa A125*, ohne Leerzeichen</translation>
    </message>
    <message>
        <source>no family is called &apos;%1&apos;; there is %2</source>
        <translation>keine Familie heißt „%1“; es gibt %2</translation>
    </message>
    <message>
        <source>&apos;dir:%1&apos; is not known; dir:rx and dir:tx are</source>
        <translation>„dir:%1“ ist unbekannt; bekannt sind dir:rx und dir:tx</translation>
    </message>
    <message>
        <source>&apos;is:%1&apos; is not known; tx, rx, extended, standard, remote, error, unknown, known and control are</source>
        <translation>„is:%1“ ist unbekannt; bekannt sind tx, rx, extended, standard, remote, error, unknown, known und control</translation>
    </message>
    <message>
        <source>&apos;field.&apos; needs the name of a field, such as field.trgt&gt;100</source>
        <translation>„field.“ braucht den Namen eines Felds, etwa field.trgt&gt;100</translation>
    </message>
    <message>
        <source>&apos;field.%1%2&apos; needs a number behind it</source>
        <translation>„field.%1%2“ braucht eine Zahl dahinter</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no number</source>
        <translation>„%1“ ist keine Zahl</translation>
    </message>
    <message>
        <source>identifier, hexadecimal</source>
        <translation>Identifier, hexadezimal</translation>
    </message>
    <message>
        <source>what the decoder says</source>
        <translation>was der Decoder sagt</translation>
    </message>
    <message>
        <source>a field by its name: its number, % of full scale, or that there is one</source>
        <translation>ein Feld über seinen Namen: seine Zahl, % vom Endwert oder dass es vorhanden ist</translation>
    </message>
    <message>
        <source>bytes, hexadecimal</source>
        <translation>Bytes, hexadezimal</translation>
    </message>
    <message>
        <source>direction; error, remote, extended, standard, unknown, known; makes a motor move</source>
        <translation>Richtung; error, remote, extended, standard, unknown, known; bewegt einen Motor</translation>
    </message>
    <message>
        <source>a bare word: part of a message, family or identifier</source>
        <translation>ein einzelnes Wort: Teil von Nachricht, Familie oder Identifier</translation>
    </message>
    <message>
        <source>terms beside each other must all hold</source>
        <translation>Ausdrücke nebeneinander müssen alle zutreffen</translation>
    </message>
    <message>
        <source>* stands for any characters, ? for one, a comma for or.</source>
        <translation>* steht für beliebige Zeichen, ? für eines, ein Komma für oder.</translation>
    </message>
</context>
<context>
    <name>FrameText</name>
    <message>
        <source>remote</source>
        <translation>Remote</translation>
    </message>
</context>
<context>
    <name>GainText</name>
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
        <source>throttle per %1</source>
        <translation>throttle je %1</translation>
    </message>
    <message>
        <source>throttle × divisor per %1</source>
        <translation>throttle × Divisor je %1</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>%1 / %2</source>
        <translation>%1 / %2</translation>
    </message>
</context>
<context>
    <name>GapText</name>
    <message>
        <source>gap %1</source>
        <translation>Lücke %1</translation>
    </message>
    <message>
        <source>%1 gaps, %2</source>
        <translation>%1 Lücken, %2</translation>
    </message>
</context>
<context>
    <name>HelpTitles</name>
    <message>
        <source>First hour</source>
        <translation>Die erste Stunde</translation>
    </message>
    <message>
        <source>Connecting</source>
        <translation>Anschließen</translation>
    </message>
    <message>
        <source>Tuning by itself</source>
        <translation>Selbst abstimmen</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Kurven</translation>
    </message>
    <message>
        <source>Service</source>
        <translation>Service</translation>
    </message>
    <message>
        <source>Safety</source>
        <translation>Sicherheit</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Dateien</translation>
    </message>
    <message>
        <source>Troubleshooting</source>
        <translation>Fehler suchen</translation>
    </message>
    <message>
        <source>Hardware: %1</source>
        <translation>Hardware: %1</translation>
    </message>
    <message>
        <source>Recipes</source>
        <translation>Rezepte</translation>
    </message>
</context>
<context>
    <name>Languages</name>
    <message>
        <source>English</source>
        <comment>the name of this language in itself</comment>
        <translation>Deutsch</translation>
    </message>
    <message>
        <source>en</source>
        <comment>the code of this language, as in the name of its file</comment>
        <translation>de</translation>
    </message>
</context>
<context>
    <name>LeapText</name>
    <message>
        <source>%1 × as large as now, %2.</source>
        <translation>%1-mal so groß wie jetzt, %2.</translation>
    </message>
    <message>
        <source>%1 × smaller than now, %2.</source>
        <translation>%1-mal kleiner als jetzt, %2.</translation>
    </message>
</context>
<context>
    <name>LinkChoices</name>
    <message>
        <source>up</source>
        <translation>an</translation>
    </message>
    <message>
        <source>switched off</source>
        <translation>ausgeschaltet</translation>
    </message>
    <message>
        <source>bus-off</source>
        <translation>Bus-Off</translation>
    </message>
    <message>
        <source>no permission</source>
        <translation>kein Zugriff</translation>
    </message>
    <message>
        <source>not there</source>
        <translation>nicht da</translation>
    </message>
    <message>
        <source>ready</source>
        <translation>bereit</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>A recording of frames…</source>
        <translation>Eine Aufnahme von Frames…</translation>
    </message>
    <message>
        <source>file</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Plays a candump or Vector ASC log as if its bus were here. Nothing can be sent.</source>
        <translation>Spielt ein candump- oder Vector-ASC-Log ab, als wäre sein Bus hier. Gesendet werden kann nichts.</translation>
    </message>
    <message>
        <source>The whole simulated bench</source>
        <translation>Der ganze simulierte Prüfstand</translation>
    </message>
    <message>
        <source>Simulated CAN bus</source>
        <translation>Simulierter CAN-Bus</translation>
    </message>
    <message>
        <source>Simulated serial line</source>
        <translation>Simulierte serielle Leitung</translation>
    </message>
    <message>
        <source>Simulated SPI board</source>
        <translation>Simulierte SPI-Platine</translation>
    </message>
    <message>
        <source>CAN interfaces</source>
        <translation>CAN-Schnittstellen</translation>
    </message>
    <message>
        <source>Serial ports</source>
        <translation>Serielle Ports</translation>
    </message>
    <message>
        <source>SPI devices</source>
        <translation>SPI-Geräte</translation>
    </message>
    <message>
        <source>Recordings</source>
        <translation>Aufnahmen</translation>
    </message>
    <message>
        <source>Without hardware</source>
        <translation>Ohne Hardware</translation>
    </message>
    <message>
        <source>Serial port</source>
        <translation>Serieller Anschluss</translation>
    </message>
    <message>
        <source>SPI device</source>
        <translation>SPI-Gerät</translation>
    </message>
    <message>
        <source>CAN interface</source>
        <translation>CAN-Schnittstelle</translation>
    </message>
    <message>
        <source>%1, at the real speed of their link.</source>
        <translation>%1, in der echten Geschwindigkeit ihrer Verbindung.</translation>
    </message>
    <message>
        <source>Controllers of every family with real bus timing; nothing real can move.</source>
        <translation>Steuerungen aller Familien mit echtem Zeitverhalten des Busses; nichts Echtes kann sich bewegen.</translation>
    </message>
</context>
<context>
    <name>MuteUnits</name>
    <message>
        <source>Number of the unit that does not answer, %1 … %2. No other one of its family may answer there: a programmer would not tell them apart.</source>
        <translation>Nummer des Geräts, das nicht antwortet, %1 … %2. Dort darf kein anderes seiner Familie antworten: ein Programmiergerät könnte sie nicht unterscheiden.</translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <translation>%1 an %2</translation>
    </message>
    <message>
        <source>No link is open whose units a programmer writes</source>
        <translation>Keine Verbindung ist offen, deren Geräte ein Programmiergerät schreibt</translation>
    </message>
</context>
<context>
    <name>PlotFeed</name>
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
</context>
<context>
    <name>PlotReadings</name>
    <message>
        <source>t</source>
        <comment>time of both cursors</comment>
        <translation>t</translation>
    </message>
    <message>
        <source>%1 → %2</source>
        <translation>%1 → %2</translation>
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
        <source>mean A…B</source>
        <translation>Mittel A…B</translation>
    </message>
    <message>
        <source>min … max</source>
        <translation>min … max</translation>
    </message>
    <message>
        <source>%1 … %2</source>
        <translation>%1 … %2</translation>
    </message>
    <message>
        <source>σ, %1 samples</source>
        <translation>σ, %1 Werte</translation>
    </message>
    <message>
        <source>slope</source>
        <translation>Steigung</translation>
    </message>
    <message>
        <source>/s</source>
        <translation>/s</translation>
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
</context>
<context>
    <name>PlotStrip</name>
    <message>
        <source>s</source>
        <translation>s</translation>
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
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
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
    <message>
        <source>Return</source>
        <translation>Enter</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Enter</translation>
    </message>
</context>
<context>
    <name>SignalText</name>
    <message>
        <source>small</source>
        <extracomment>Translate as &quot;capital&quot; where a noun has a capital letter in the middle of a line too.</extracomment>
        <translation>capital</translation>
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
    <name>Stories</name>
    <message>
        <source>Select</source>
        <translation>Auswählen</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>Scharf schalten</translation>
    </message>
    <message>
        <source>Hold the Arm button at the top, SAFE, for one second (or Ctrl+Shift+F12). Nothing moves before. Esc stops, always.</source>
        <translation>Die Scharf-Taste oben, SICHER, eine Sekunde halten (oder Strg+Umschalt+F12). Vorher bewegt sich nichts. Esc stoppt, immer.</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Sprung</translation>
    </message>
    <message>
        <source>Tune</source>
        <translation>Abstimmen</translation>
    </message>
    <message>
        <source>Store</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>Begrenzen</translation>
    </message>
    <message>
        <source>Hold the Arm button at the top for one second (or Ctrl+Shift+F12).</source>
        <translation>Die Scharf-Taste oben eine Sekunde halten (oder Strg+Umschalt+F12).</translation>
    </message>
    <message>
        <source>velocity, set-point dashed</source>
        <translation>Drehzahl, Sollwert gestrichelt</translation>
    </message>
    <message>
        <source>current, limit dashed</source>
        <translation>Strom, Grenze gestrichelt</translation>
    </message>
    <message>
        <source>Click %1 in the list at the left. Everything that follows is about it.</source>
        <translation>%1 links in der Liste anklicken. Um ihn geht es ab jetzt.</translation>
    </message>
    <message>
        <source>Click %1 in the list at the left.</source>
        <translation>%1 links in der Liste anklicken.</translation>
    </message>
    <message>
        <source>%1 overshoots: tame it in a minute</source>
        <translation>%1 schwingt über: in einer Minute gezähmt</translation>
    </message>
    <message>
        <source>%1 has no current limit: set one that saves it</source>
        <translation>%1 hat keine Stromgrenze: eine setzen, die ihn rettet</translation>
    </message>
    <message>
        <source>Press %2: the motor steps to a speed and back, and the overshoot is measured.</source>
        <translation>%2 drücken: der Motor springt auf eine Drehzahl und zurück, das Überschwingen wird gemessen.</translation>
    </message>
    <message>
        <source>Press %2 on the page Design: the program finds gains and proves them. Tamed: a step overshoots by 5 % at most.</source>
        <translation>%2 auf der Seite Entwurf: das Programm findet Verstärkungen und beweist sie. Gezähmt: ein Sprung schwingt höchstens 5 % über.</translation>
    </message>
    <message>
        <source>Press %2 on the page Tune: the peak current of the step stands in its table.</source>
        <translation>%2 auf der Seite Regler: der Spitzenstrom des Sprungs steht in der Tabelle.</translation>
    </message>
    <message>
        <source>the button</source>
        <translation>die Schaltfläche</translation>
    </message>
    <message>
        <source>Arrive</source>
        <translation>Ankommen</translation>
    </message>
    <message>
        <source>What P makes of the last counts is less than friction. Enter among the gains %5 (a stiffer P overcomes it, and more D keeps it from swinging), and press %2 again: it rests within 5 counts of its target.</source>
        <translation>Was P aus den letzten Schritten macht, ist weniger als die Reibung. Bei den Verstärkungen %5 eingeben (ein steiferes P überwindet sie, mehr D verhindert Schwingen) und noch einmal %2 drücken: er ruht höchstens 5 Schritte neben dem Ziel.</translation>
    </message>
    <message>
        <source>%1 stops short: make it arrive</source>
        <translation>%1 bleibt vor dem Ziel stehen: ans Ziel bringen</translation>
    </message>
    <message>
        <source>This one stops about %4 counts short and stays there. Make it arrive.</source>
        <translation>Dieser bleibt etwa %4 Schritte vor dem Ziel stehen, und dabei bleibt es. Ans Ziel bringen.</translation>
    </message>
    <message>
        <source>position, set-point dashed</source>
        <translation>Position, Sollwert gestrichelt</translation>
    </message>
    <message>
        <source>On the page Tune choose Position: what is armed is armed for one mode. Then hold the Arm button at the top for one second (or Ctrl+Shift+F12).</source>
        <translation>Auf der Seite Regler Position wählen: scharf ist ein Gerät für eine Betriebsart. Dann die Scharf-Taste oben eine Sekunde halten (oder Strg+Umschalt+F12).</translation>
    </message>
    <message>
        <source>Enter %3 as the target (behind ▸) and press %2: the motor goes there and back, and stops about %4 counts short.</source>
        <translation>Als Ziel (hinter ▸) %3 eingeben und %2 drücken: der Motor fährt hin und zurück und bleibt etwa %4 Schritte vor dem Ziel stehen.</translation>
    </message>
    <message>
        <source>%6Press Store and prove on the page Parameters: done when the unit proves that its flash has the gains.</source>
        <translation>%6Auf der Seite Parameter „Speichern und nachweisen“ drücken: Fertig, wenn das Gerät nachweist, dass sein Flash die Verstärkungen hat.</translation>
    </message>
    <message>
        <source>On the page Parameters switch the current limit on (search: %7), set it to what the motor may have, and write.</source>
        <translation>Auf der Seite Parameter die Stromgrenze einschalten (suchen: %7), auf das setzen, was der Motor darf, und schreiben.</translation>
    </message>
    <message>
        <source>%6Press Store and prove on the page Parameters.</source>
        <translation>%6Auf der Seite Parameter „Speichern und nachweisen“ drücken.</translation>
    </message>
    <message>
        <source>With these gains it goes too far. Find some with which it does not.</source>
        <translation>Mit diesen Verstärkungen schwingt er über. Solche finden, mit denen er es nicht tut.</translation>
    </message>
    <message>
        <source>Stalled, it draws all that its supply gives, and nothing holds it back. Limit it.</source>
        <translation>Blockiert zieht er alles, was die Versorgung hergibt, und nichts hält ihn zurück. Begrenzen.</translation>
    </message>
    <message>
        <source>It stores by itself %1 s after its last change: wait for that.</source>
        <translation>%1 s nach der letzten Änderung speichert es von selbst: darauf warten.</translation>
    </message>
</context>
<context>
    <name>TriggerText</name>
    <message>
        <source>trigger armed, waiting</source>
        <translation>Trigger scharf, wartet</translation>
    </message>
    <message>
        <source>single event caught</source>
        <translation>Einzelereignis erfasst</translation>
    </message>
    <message>
        <source>event %1, filling</source>
        <translation>Ereignis %1, wird gefüllt</translation>
    </message>
    <message>
        <source>event %1, waiting for the next</source>
        <translation>Ereignis %1, wartet auf das nächste</translation>
    </message>
</context>
<context>
    <name>TypedFrameText</name>
    <message>
        <source>&apos;%1&apos; is no frame such as 02061405#8125</source>
        <translation>„%1“ ist kein Frame wie etwa 02061405#8125</translation>
    </message>
    <message>
        <source>The identifier is hexadecimal, such as 7FF or 02061405</source>
        <translation>Der Identifier ist hexadezimal, etwa 7FF oder 02061405</translation>
    </message>
    <message>
        <source>%1 has more than 29 bits: at most 1FFFFFFF</source>
        <translation>%1 hat mehr als 29 Bit: höchstens 1FFFFFFF</translation>
    </message>
    <message>
        <source>%1 has more than 11 bits: choose 29 bits</source>
        <translation>%1 hat mehr als 11 Bit: 29 Bit wählen</translation>
    </message>
    <message>
        <source>The data are pairs of hexadecimal digits, such as 81 25 11</source>
        <translation>Die Daten sind Paare von Hexadezimalziffern, etwa 81 25 11</translation>
    </message>
    <message>
        <source>%1 bytes: a frame has at most 8</source>
        <translation>%1 Byte: ein Frame hat höchstens 8</translation>
    </message>
</context>
<context>
    <name>UnitText</name>
    <message>
        <source>rpm</source>
        <translation>1/min</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
</context>
<context>
    <name>UpdateText</name>
    <message>
        <source>a device that is gone</source>
        <translation>ein Gerät, das weg ist</translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <translation>%1 an %2</translation>
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
    <name>drawings</name>
    <message>
        <source>3.3 V only</source>
        <translation>nur 3,3 V</translation>
    </message>
    <message>
        <source>57 600 or 115 200 bit/s</source>
        <translation>57 600 oder 115 200 bit/s</translation>
    </message>
    <message>
        <source>60 A, 100 A for 2 s</source>
        <translation>60 A, für 2 s 100 A</translation>
    </message>
    <message>
        <source>A, B, index</source>
        <translation>A, B, Index</translation>
    </message>
    <message>
        <source>Battery, 12 V</source>
        <translation>Batterie, 12 V</translation>
    </message>
    <message>
        <source>Breaker</source>
        <translation>Sicherung</translation>
    </message>
    <message>
        <source>Bridge and motor</source>
        <translation>Brücke und Motor</translation>
    </message>
    <message>
        <source>CAN adapter</source>
        <translation>CAN-Adapter</translation>
    </message>
    <message>
        <source>CAN high</source>
        <translation>CAN High</translation>
    </message>
    <message>
        <source>CAN low</source>
        <translation>CAN Low</translation>
    </message>
    <message>
        <source>Drive, offset 1</source>
        <translation>Antrieb, Offset 1</translation>
    </message>
    <message>
        <source>Drive, offset 2</source>
        <translation>Antrieb, Offset 2</translation>
    </message>
    <message>
        <source>Encoder board</source>
        <translation>Encoderplatine</translation>
    </message>
    <message>
        <source>GPIO in</source>
        <translation>GPIO-Eingang</translation>
    </message>
    <message>
        <source>GPIO out</source>
        <translation>GPIO-Ausgang</translation>
    </message>
    <message>
        <source>Host</source>
        <translation>Host</translation>
    </message>
    <message>
        <source>J4 closed only for 3.3 V, before power</source>
        <translation>J4 nur für 3,3 V zu, vor dem Einschalten</translation>
    </message>
    <message>
        <source>Motor</source>
        <translation>Motor</translation>
    </message>
    <message>
        <source>Motor supply</source>
        <translation>Motorversorgung</translation>
    </message>
    <message>
        <source>P1 MISO · P2 Vcc · P3 SCK · P4 MOSI · P5 reset · P6 ground</source>
        <translation>P1 MISO · P2 Vcc · P3 SCK · P4 MOSI · P5 Reset · P6 Masse</translation>
    </message>
    <message>
        <source>PA4 current, PA3 heat</source>
        <translation>PA4 Strom, PA3 Wärme</translation>
    </message>
    <message>
        <source>Pads for a programmer</source>
        <translation>Pads für ein Programmiergerät</translation>
    </message>
    <message>
        <source>Programmer</source>
        <translation>Programmiergerät</translation>
    </message>
    <message>
        <source>STM32F1 or F4</source>
        <translation>STM32F1 oder F4</translation>
    </message>
    <message>
        <source>Supermodified, node 4</source>
        <translation>Supermodified, Knoten 4</translation>
    </message>
    <message>
        <source>Supermodified, node 5</source>
        <translation>Supermodified, Knoten 5</translation>
    </message>
    <message>
        <source>USB to RS-485</source>
        <translation>USB auf RS-485</translation>
    </message>
    <message>
        <source>a Raspberry Pi, say</source>
        <translation>etwa ein Raspberry Pi</translation>
    </message>
    <message>
        <source>and a switch</source>
        <translation>und ein Schalter</translation>
    </message>
    <message>
        <source>closed: bootloader</source>
        <translation>zu: Bootloader</translation>
    </message>
    <message>
        <source>each its own number</source>
        <translation>jeder seine Nummer</translation>
    </message>
    <message>
        <source>each its own offset</source>
        <translation>jeder seinen Offset</translation>
    </message>
    <message>
        <source>ground</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>ground in common</source>
        <translation>gemeinsame Masse</translation>
    </message>
    <message>
        <source>ground, 3.3 V</source>
        <translation>Masse, 3,3 V</translation>
    </message>
    <message>
        <source>motor, 6 A</source>
        <translation>Motor, 6 A</translation>
    </message>
    <message>
        <source>number 1 … 63</source>
        <translation>Nummer 1 … 63</translation>
    </message>
    <message>
        <source>on the computer</source>
        <translation>am Rechner</translation>
    </message>
    <message>
        <source>one host only</source>
        <translation>nur ein Host</translation>
    </message>
    <message>
        <source>or a supply that</source>
        <translation>oder ein Netzteil,</translation>
    </message>
    <message>
        <source>own driver</source>
        <translation>eigener Treiber</translation>
    </message>
    <message>
        <source>takes braking</source>
        <translation>das Bremsen aufnimmt</translation>
    </message>
    <message>
        <source>transceiver at PA11, PA12</source>
        <translation>Transceiver an PA11, PA12</translation>
    </message>
    <message>
        <source>up to 35 V</source>
        <translation>bis 35 V</translation>
    </message>
    <message>
        <source>with encoder</source>
        <translation>mit Encoder</translation>
    </message>
    <message>
        <source>within reach</source>
        <translation>in Reichweite</translation>
    </message>
</context>
<context>
    <name>mb::About</name>
    <message>
        <source>About MotorBench</source>
        <translation>Über MotorBench</translation>
    </message>
    <message>
        <source>Tunes and services brushed-DC motor controllers. Free software under the GNU General Public License, version 3 or later, without any warranty.</source>
        <translation>Stimmt Regler für Gleichstrommotoren ab und wartet sie. Freie Software unter der GNU General Public License, Version 3 oder später, ohne jede Gewähr.</translation>
    </message>
    <message>
        <source>Versions and licences</source>
        <translation>Versionen und Lizenzen</translation>
    </message>
    <message>
        <source>Copy versions</source>
        <translation>Versionen kopieren</translation>
    </message>
</context>
<context>
    <name>mb::AddLinkDialog</name>
    <message>
        <source>Add a link</source>
        <translation>Verbindung hinzufügen</translation>
    </message>
    <message>
        <source>Links that can be added</source>
        <translation>Verbindungen zum Hinzufügen</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>Verbindung</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>open</source>
        <translation>offen</translation>
    </message>
    <message>
        <source>none found</source>
        <translation>keine gefunden</translation>
    </message>
    <message>
        <source>Command for a terminal</source>
        <translation>Befehl für ein Terminal</translation>
    </message>
    <message>
        <source>Address of the link</source>
        <translation>Adresse der Verbindung</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>Open it at every start</source>
        <translation>Bei jedem Start öffnen</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Choose the file…</source>
        <translation>Datei wählen…</translation>
    </message>
</context>
<context>
    <name>mb::AdvicePanel</name>
    <message>
        <source>Why it did that</source>
        <translation>Warum das so war</translation>
    </message>
    <message>
        <source>Stages these values; nothing is written yet.</source>
        <translation>Merkt diese Werte vor; geschrieben wird noch nichts.</translation>
    </message>
</context>
<context>
    <name>mb::AdviceText</name>
    <message>
        <source>F·K is %1 with I active: the initial lag is paid back as overshoot.</source>
        <translation>F·K ist %1 bei aktivem I: der anfängliche Rückstand wird als Überschwingen zurückgezahlt.</translation>
    </message>
    <message>
        <source>It stops %1 counts short: P alone does not overcome friction there.</source>
        <translation>Es bleibt %1 Schritte davor stehen: P allein überwindet dort die Reibung nicht.</translation>
    </message>
    <message>
        <source>A gain has only %1 steps of its integer; it cannot be set finely.</source>
        <translation>Eine Verstärkung hat nur %1 Stufen ihrer Ganzzahl; sie lässt sich nicht fein einstellen.</translation>
    </message>
    <message>
        <source>One count of the sensor moves the duty by %1 % through D; 10 % is the most that is quiet.</source>
        <translation>Ein Schritt des Gebers ändert den Tastgrad über D um %1 %; ruhig bleibt es bis 10 %.</translation>
    </message>
    <message>
        <source>The drive&apos;s ramp takes %1 to full duty, which is slower than this loop.</source>
        <translation>Die Rampe des Reglers braucht %1 bis zum vollen Tastgrad und ist damit langsamer als dieser Regelkreis.</translation>
    </message>
    <message>
        <source>The duty was at its limit for %1: the loop cannot go faster there.</source>
        <translation>Der Tastgrad war %1 lang an seiner Grenze: schneller kann der Regelkreis dort nicht.</translation>
    </message>
    <message>
        <source>The duty was at its limit for %1 while I went on; that is paid back as overshoot.</source>
        <translation>Der Tastgrad war %1 lang an seiner Grenze, während I weiterlief; das wird als Überschwingen zurückgezahlt.</translation>
    </message>
    <message>
        <source>The measured velocity is %1 late; the gains are too lively for that.</source>
        <translation>Die gemessene Drehzahl kommt %1 zu spät; dafür sind die Verstärkungen zu lebhaft.</translation>
    </message>
    <message>
        <source>The velocity comes anew every %1 only; a loop cannot be quicker than that.</source>
        <translation>Die Drehzahl kommt nur alle %1 neu; schneller kann ein Regelkreis nicht sein.</translation>
    </message>
    <message>
        <source>It moved late, at %1 % duty: friction holds it until then.</source>
        <translation>Er bewegte sich spät, bei %1 % Tastgrad: so lange hält ihn die Reibung.</translation>
    </message>
    <message>
        <source>It takes %1 % duty to stay in place: a load pulls one way.</source>
        <translation>Er braucht %1 % Tastgrad, um stehen zu bleiben: eine Last zieht in eine Richtung.</translation>
    </message>
    <message>
        <source>It swings by %1 counts without end: play between motor and load.</source>
        <translation>Es schwingt endlos um %1 Schritte: Spiel zwischen Motor und Last.</translation>
    </message>
    <message>
        <source>Stage %1</source>
        <translation>%1 vormerken</translation>
    </message>
</context>
<context>
    <name>mb::AdviserList</name>
    <message>
        <source>staged</source>
        <translation>vorgemerkt</translation>
    </message>
    <message>
        <source>ok</source>
        <translation>in Ordnung</translation>
    </message>
    <message>
        <source>fixed in the set</source>
        <translation>im Satz behoben</translation>
    </message>
    <message>
        <source>mind it</source>
        <translation>beachten</translation>
    </message>
    <message>
        <source>to fix</source>
        <translation>zu beheben</translation>
    </message>
    <message>
        <source>not read</source>
        <translation>nicht gelesen</translation>
    </message>
    <message>
        <source>This loop has no F that could fight with I.</source>
        <translation>Dieser Regelkreis hat kein F, das gegen I arbeiten könnte.</translation>
    </message>
    <message>
        <source>uS/kp = %1: below this error only I moves the shaft.</source>
        <translation>uS/kp = %1: unter diesem Fehler bewegt nur I die Welle.</translation>
    </message>
    <message>
        <source>uS/kp = %1: below this error nothing moves the shaft.</source>
        <translation>uS/kp = %1: unter diesem Fehler bewegt nichts die Welle.</translation>
    </message>
    <message>
        <source>That is over 2 % of the step.</source>
        <translation>Das sind mehr als 2 % des Sprungs.</translation>
    </message>
    <message>
        <source>The drive&apos;s least output helps.</source>
        <translation>Die kleinste Ausgabe des Reglers hilft.</translation>
    </message>
    <message>
        <source>No gain of the set is an integer of its own.</source>
        <translation>Keine Verstärkung des Satzes ist eine eigene Ganzzahl.</translation>
    </message>
    <message>
        <source>%1 is %2 steps of its integer, at least %3 are wanted: one step is %4 %.</source>
        <translation>%1 hat %2 Stufen seiner Ganzzahl, mindestens %3 sollen es sein: eine Stufe ist %4 %.</translation>
    </message>
    <message>
        <source>This drive has no ramp of its own.</source>
        <translation>Dieser Regler hat keine eigene Rampe.</translation>
    </message>
    <message>
        <source>The drive&apos;s ramp was not read yet.</source>
        <translation>Die Rampe des Reglers wurde noch nicht gelesen.</translation>
    </message>
    <message>
        <source>The drive&apos;s ramp is off.</source>
        <translation>Die Rampe des Reglers ist aus.</translation>
    </message>
    <message>
        <source>Full duty takes %1, over τc/2 = %2: it acts as lag.</source>
        <translation>Voller Tastgrad braucht %1, mehr als τc/2 = %2: sie wirkt als Verzögerung.</translation>
    </message>
    <message>
        <source>Full duty takes %1, under τc/2 = %2.</source>
        <translation>Voller Tastgrad braucht %1, weniger als τc/2 = %2.</translation>
    </message>
    <message>
        <source>F–I conflict</source>
        <translation>F–I-Konflikt</translation>
    </message>
    <message>
        <source>Deadband</source>
        <translation>Totband</translation>
    </message>
    <message>
        <source>D noise</source>
        <translation>D-Rauschen</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Auflösung</translation>
    </message>
    <message>
        <source>Ramp</source>
        <translation>Rampe</translation>
    </message>
    <message>
        <source>D is 0: one count moves no duty.</source>
        <translation>D ist 0: ein Schritt ändert keinen Tastgrad.</translation>
    </message>
    <message>
        <source>One count moves the duty by %1 % through D; %2 % is the most that is quiet.</source>
        <translation>Ein Schritt ändert den Tastgrad über D um %1 %; ruhig bleibt es bis %2 %.</translation>
    </message>
    <message>
        <source>Advisers</source>
        <translation>Ratgeber</translation>
    </message>
    <message>
        <source>for %1, slot %2</source>
        <translation>für %1, Slot %2</translation>
    </message>
    <message>
        <source>for %1</source>
        <translation>für %1</translation>
    </message>
    <message>
        <source>Take back</source>
        <translation>Zurücknehmen</translation>
    </message>
    <message>
        <source>Stages these values; nothing is written yet.</source>
        <translation>Merkt diese Werte vor; geschrieben wird noch nichts.</translation>
    </message>
    <message>
        <source>Stage</source>
        <translation>Vormerken</translation>
    </message>
    <message>
        <source>F and I in force give back %1 of the step as overshoot. The set has no F.</source>
        <translation>F und I, wie sie jetzt gelten, geben %1 des Sprungs als Überschwingen zurück. Der Satz hat kein F.</translation>
    </message>
    <message>
        <source>F and I give back %1 of the step as overshoot.</source>
        <translation>F und I geben %1 des Sprungs als Überschwingen zurück.</translation>
    </message>
    <message>
        <source>F and I give nothing back as overshoot.</source>
        <translation>F und I geben nichts als Überschwingen zurück.</translation>
    </message>
</context>
<context>
    <name>mb::AgainstView</name>
    <message>
        <source>plot written to %1</source>
        <translation>Kurve geschrieben nach %1</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>Bild kopieren</translation>
    </message>
    <message>
        <source>One signal against another</source>
        <translation>Ein Signal über einem anderen</translation>
    </message>
    <message>
        <source>Signal across</source>
        <translation>Signal waagerecht</translation>
    </message>
    <message>
        <source>Signal upwards</source>
        <translation>Signal senkrecht</translation>
    </message>
    <message>
        <source>against</source>
        <translation>über</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>A … B: </source>
        <translation>A … B: </translation>
    </message>
    <message>
        <source>what is seen: </source>
        <translation>Sichtbares: </translation>
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
    <message>
        <source>experiment</source>
        <translation>Experiment</translation>
    </message>
    <message>
        <source>%1: cut its power</source>
        <translation>%1: Strom abschalten</translation>
    </message>
    <message>
        <source>until it is seen</source>
        <translation>bis es zu sehen ist</translation>
    </message>
    <message>
        <source>not sent to %1</source>
        <translation>nicht an %1</translation>
    </message>
    <message>
        <source>%1 may still turn</source>
        <translation>%1 läuft vielleicht noch</translation>
    </message>
    <message>
        <source>STOP: %1; not sent to %2</source>
        <translation>STOP: %1; nicht an %2 gesendet</translation>
    </message>
    <message>
        <source>this window did not respond for %1 s</source>
        <translation>dieses Fenster hat %1 s lang nicht reagiert</translation>
    </message>
    <message>
        <source>%1 guard, %2</source>
        <comment>guard and what tripped it</comment>
        <translation>Überwachung %1, %2</translation>
    </message>
    <message>
        <source>it has restarted</source>
        <translation>es ist neu gestartet</translation>
    </message>
    <message>
        <source>an experiment on it has not ended</source>
        <translation>ein Versuch damit ist noch nicht zu Ende</translation>
    </message>
    <message>
        <source>the computer slept</source>
        <translation>der Rechner hat geschlafen</translation>
    </message>
</context>
<context>
    <name>mb::AxesPanel</name>
    <message>
        <source>Axes</source>
        <translation>Achsen</translation>
    </message>
    <message>
        <source>together</source>
        <translation>gemeinsam</translation>
    </message>
    <message>
        <source>All axes run together</source>
        <translation>Alle Achsen laufen gemeinsam</translation>
    </message>
    <message>
        <source>Run starts every ticked axis at the same moment, each with its own mode and set-point.</source>
        <translation>Start startet alle angehakten Achsen im selben Augenblick, jede mit eigener Betriebsart und eigenem Sollwert.</translation>
    </message>
    <message>
        <source>Copy gains from…</source>
        <translation>Verstärkungen kopieren von…</translation>
    </message>
    <message>
        <source>Stages the gains and limits of another axis for this one.</source>
        <translation>Merkt Verstärkungen und Grenzen einer anderen Achse für diese vor.</translation>
    </message>
    <message>
        <source>Same set-point for all ticked</source>
        <translation>Gleicher Sollwert für alle angehakten</translation>
    </message>
    <message>
        <source>Mode and set-point of this axis for every ticked one; a position becomes the same distance.</source>
        <translation>Betriebsart und Sollwert dieser Achse für alle angehakten; aus einer Position wird der gleiche Weg.</translation>
    </message>
    <message>
        <source>Shows this axis: its mode, set-point, gains, limits and traces</source>
        <translation>Zeigt diese Achse: Betriebsart, Sollwert, Verstärkungen, Grenzen und Kurven</translation>
    </message>
    <message>
        <source>Axis %1 runs together with the others</source>
        <translation>Achse %1 läuft gemeinsam mit den anderen</translation>
    </message>
    <message>
        <source>Run always moves the axis that is shown.</source>
        <translation>Start bewegt immer die gezeigte Achse.</translation>
    </message>
    <message>
        <source>Run moves this axis, too, at the same moment.</source>
        <translation>Start bewegt im selben Augenblick auch diese Achse.</translation>
    </message>
</context>
<context>
    <name>mb::AxisCells</name>
    <message>
        <source>Axes</source>
        <translation>Achsen</translation>
    </message>
    <message>
        <source>Shows this axis in Parameters, Tune and Plots</source>
        <translation>Zeigt diese Achse in Parameter, Regler und Kurven</translation>
    </message>
</context>
<context>
    <name>mb::AxisChoice</name>
    <message>
        <source>Which axis</source>
        <translation>Welche Achse</translation>
    </message>
    <message>
        <source>All axes</source>
        <translation>Alle Achsen</translation>
    </message>
    <message>
        <source>Board</source>
        <translation>Platine</translation>
    </message>
    <message>
        <source>Copy from</source>
        <translation>Kopieren von</translation>
    </message>
    <message>
        <source>Copy gains and limits from another axis</source>
        <translation>Verstärkungen und Grenzen von einer anderen Achse kopieren</translation>
    </message>
    <message>
        <source>Stages the gains and limits of another axis for this one; Write sends them.</source>
        <translation>Merkt Verstärkungen und Grenzen einer anderen Achse für diese vor; Schreiben sendet sie.</translation>
    </message>
    <message>
        <source>Gains and limits of axis %1</source>
        <translation>Verstärkungen und Grenzen von Achse %1</translation>
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
    <name>mb::BatteryDialog</name>
    <message>
        <source>Battery of steps</source>
        <translation>Reihe von Sprüngen</translation>
    </message>
    <message>
        <source>Run the battery</source>
        <translation>Reihe starten</translation>
    </message>
    <message>
        <source>Steps of the battery and the worst of each metric</source>
        <translation>Sprünge der Reihe und das Schlechteste jedes Kennwerts</translation>
    </message>
    <message>
        <source>Responses of the battery over each other</source>
        <translation>Antworten der Reihe übereinander</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>share of the step</source>
        <translation>Anteil des Sprungs</translation>
    </message>
    <message>
        <source>Step, %1</source>
        <translation>Sprung, %1</translation>
    </message>
    <message>
        <source>%1 steps, both ways in turn, from %2 to %3 %4, with the gains in force. The motor turns; each step keeps inside the limits of the page.</source>
        <translation>%1 Sprünge, abwechselnd in beide Richtungen, von %2 bis %3 %4, mit den geltenden Verstärkungen. Der Motor dreht; jeder Sprung bleibt in den Grenzen der Seite.</translation>
    </message>
    <message>
        <source>Step %1 of %2: to %3 %4. STOP ends it.</source>
        <translation>Sprung %1 von %2: auf %3 %4. STOP beendet es.</translation>
    </message>
    <message>
        <source>Ended: %1</source>
        <translation>Beendet: %1</translation>
    </message>
    <message>
        <source>Ended by: %1</source>
        <translation>Beendet durch: %1</translation>
    </message>
    <message>
        <source>Done: %1 trials in the notebook.</source>
        <translation>Fertig: %1 Versuche im Versuchsbuch.</translation>
    </message>
    <message>
        <source>Ended before all steps were run.</source>
        <translation>Beendet, bevor alle Sprünge gelaufen sind.</translation>
    </message>
    <message>
        <source>worst</source>
        <translation>schlechtester</translation>
    </message>
    <message>
        <source>DEMO</source>
        <translation>DEMO</translation>
    </message>
    <message>
        <source>Arm the device first: hold the Arm button for 1 s.</source>
        <translation>Erst das Gerät scharf schalten: Scharf-Taste 1 s halten.</translation>
    </message>
    <message>
        <source>Responses over each other</source>
        <translation>Antworten übereinander</translation>
    </message>
    <message>
        <source>forwards</source>
        <translation>vorwärts</translation>
    </message>
    <message>
        <source>backwards</source>
        <translation>rückwärts</translation>
    </message>
    <message>
        <source>Not run: %1</source>
        <translation>Nicht ausgeführt: %1</translation>
    </message>
    <message>
        <source>Not started, the page has changed: %1</source>
        <translation>Nicht begonnen, die Seite hat sich geändert: %1</translation>
    </message>
</context>
<context>
    <name>mb::BenchText</name>
    <message>
        <source>%1 … %2</source>
        <translation>%1 … %2</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>höchstens %1</translation>
    </message>
    <message>
        <source>firmware</source>
        <translation>Firmware</translation>
    </message>
    <message>
        <source>parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>%1 equal</source>
        <translation>%1 gleich</translation>
    </message>
    <message>
        <source>unusual, %1</source>
        <translation>ungewöhnlich, %1</translation>
    </message>
    <message>
        <source>Connect a unit</source>
        <translation>Gerät anschließen</translation>
    </message>
    <message>
        <source>It starts by itself when it answers on %1.</source>
        <translation>Es beginnt von selbst, sobald es auf %1 antwortet.</translation>
    </message>
    <message>
        <source>Open a recipe, then Start</source>
        <translation>Rezept öffnen, dann Start</translation>
    </message>
    <message>
        <source>The motor turns in a moment</source>
        <translation>Der Motor dreht gleich</translation>
    </message>
    <message>
        <source>Safe to unplug</source>
        <translation>Trennen erlaubt</translation>
    </message>
    <message>
        <source>Do not unplug</source>
        <translation>Nicht trennen</translation>
    </message>
    <message>
        <source>Unplug, connect next</source>
        <translation>Abziehen, nächstes anschließen</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>bestanden</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>ausgelassen</translation>
    </message>
    <message>
        <source>waiting</source>
        <translation>wartet</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>speed at most %1 counts/s</source>
        <translation>Drehzahl höchstens %1 counts/s</translation>
    </message>
    <message>
        <source>travel at most %1 counts</source>
        <translation>Weg höchstens %1 counts</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>nicht bestanden</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>abgelehnt</translation>
    </message>
    <message>
        <source>running</source>
        <translation>läuft</translation>
    </message>
    <message>
        <source>Hold Arm to go on</source>
        <translation>Zum Fortfahren Scharf-Taste halten</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>duty at most %1 %</source>
        <translation>Tastgrad höchstens %1 %</translation>
    </message>
    <message>
        <source>was there already</source>
        <translation>war schon da</translation>
    </message>
    <message>
        <source>it answers with it</source>
        <translation>meldet sich damit</translation>
    </message>
    <message>
        <source>read back</source>
        <translation>zurückgelesen</translation>
    </message>
    <message>
        <source>backup</source>
        <translation>Sicherung</translation>
    </message>
    <message>
        <source>kept</source>
        <translation>aufbewahrt</translation>
    </message>
    <message>
        <source>before the first write</source>
        <translation>vor dem ersten Schreiben</translation>
    </message>
    <message>
        <source>Start serves the next unit.</source>
        <translation>Start bearbeitet das nächste Gerät.</translation>
    </message>
    <message>
        <source>written, not proved</source>
        <translation>geschrieben, nicht bewiesen</translation>
    </message>
    <message>
        <source>%1 tests again · %2 sets it aside</source>
        <translation>%1 prüft erneut · %2 legt beiseite</translation>
    </message>
    <message>
        <source>Paused: no unit starts before the queue goes on.</source>
        <translation>Angehalten: Kein Gerät beginnt, bevor die Warteschlange weiterläuft.</translation>
    </message>
    <message>
        <source>%1 from %2 to %3</source>
        <translation>%1 von %2 auf %3</translation>
    </message>
    <message>
        <source>Start serves it once more</source>
        <translation>Start bearbeitet es noch einmal</translation>
    </message>
    <message>
        <source>No number was written to it this time.</source>
        <translation>Diesmal wurde ihm keine Nummer geschrieben.</translation>
    </message>
</context>
<context>
    <name>mb::BodePlot</name>
    <message>
        <source>Magnitude of loop and motor</source>
        <translation>Betrag von Regelkreis und Motor</translation>
    </message>
    <message>
        <source>Phase of loop and motor</source>
        <translation>Phase von Regelkreis und Motor</translation>
    </message>
    <message>
        <source>Hz</source>
        <translation>Hz</translation>
    </message>
    <message>
        <source>magnitude, dB</source>
        <translation>Betrag, dB</translation>
    </message>
    <message>
        <source>phase, °</source>
        <translation>Phase, °</translation>
    </message>
    <message>
        <source>loop</source>
        <translation>Regelkreis</translation>
    </message>
    <message>
        <source>motor ÷ gain</source>
        <translation>Motor ÷ Verstärkung</translation>
    </message>
    <message>
        <source>motor ÷ gain, measured</source>
        <translation>Motor ÷ Verstärkung, gemessen</translation>
    </message>
    <message>
        <source>0.90 … 0.97</source>
        <translation>0,90 … 0,97</translation>
    </message>
    <message>
        <source>not used</source>
        <translation>nicht verwendet</translation>
    </message>
    <message>
        <source>measured, γ² ≥ 0.97</source>
        <translation>gemessen, γ² ≥ 0,97</translation>
    </message>
    <message>
        <source>under 0.90, not used</source>
        <translation>unter 0,90, nicht verwendet</translation>
    </message>
</context>
<context>
    <name>mb::BodeText</name>
    <message>
        <source>crossover %1 Hz</source>
        <translation>Durchtritt %1 Hz</translation>
    </message>
    <message>
        <source>PM %1° at %2 Hz</source>
        <translation>PM %1° bei %2 Hz</translation>
    </message>
    <message>
        <source>GM %1 dB at %2 Hz</source>
        <translation>GM %1 dB bei %2 Hz</translation>
    </message>
    <message>
        <source>GM –, beyond what was measured</source>
        <translation>GM –, jenseits des Gemessenen</translation>
    </message>
    <message>
        <source>usable up to %1 Hz</source>
        <translation>brauchbar bis %1 Hz</translation>
    </message>
    <message>
        <source>unstable</source>
        <translation>instabil</translation>
    </message>
    <message>
        <source>phase margin %1°</source>
        <translation>Phasenreserve %1°</translation>
    </message>
    <message>
        <source>gain margin %1 dB</source>
        <translation>Amplitudenreserve %1 dB</translation>
    </message>
    <message>
        <source>Ms %1</source>
        <translation>Ms %1</translation>
    </message>
</context>
<context>
    <name>mb::BusBar</name>
    <message>
        <source>Link</source>
        <translation>Verbindung</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Holds the frames still; everything is counted and kept meanwhile</source>
        <translation>Hält die Frames an; gezählt und aufbewahrt wird inzwischen alles</translation>
    </message>
    <message>
        <source>Frames that are shown…</source>
        <translation>Angezeigte Frames…</translation>
    </message>
    <message>
        <source>All frames that are kept…</source>
        <translation>Alle aufbewahrten Frames…</translation>
    </message>
    <message>
        <source>Send frame…</source>
        <translation>Frame senden…</translation>
    </message>
    <message>
        <source>What the expression does</source>
        <translation>Was der Ausdruck bewirkt</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filtern</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>such as message:STS* device:5 not is:error</source>
        <translation>etwa message:STS* device:5 not is:error</translation>
    </message>
    <message>
        <source>Filter frames</source>
        <translation>Frames filtern</translation>
    </message>
    <message>
        <source>How to write a filter</source>
        <translation>So wird ein Filter geschrieben</translation>
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
        <source>errors</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Clear the list</source>
        <translation>Liste leeren</translation>
    </message>
    <message>
        <source>Export frames</source>
        <translation>Frames exportieren</translation>
    </message>
    <message>
        <source>Filter hides what does not match; Find marks what does, Enter goes to the next</source>
        <translation>Filtern blendet aus, was nicht passt; Suchen markiert, was passt, Enter springt zum nächsten</translation>
    </message>
</context>
<context>
    <name>mb::BusLoadView</name>
    <message>
        <source>Bus load of the last minute</source>
        <translation>Buslast der letzten Minute</translation>
    </message>
    <message>
        <source>now %1 %, peak %2 %</source>
        <translation>jetzt %1 %, Spitze %2 %</translation>
    </message>
</context>
<context>
    <name>mb::BusPage</name>
    <message>
        <source>Bus</source>
        <translation>Bus</translation>
    </message>
    <message>
        <source>not kept %1</source>
        <translation>nicht aufbewahrt %1</translation>
    </message>
    <message>
        <source>%1 of %2 shown</source>
        <translation>%1 von %2 angezeigt</translation>
    </message>
    <message>
        <source>Export all frames</source>
        <translation>Alle Frames exportieren</translation>
    </message>
    <message>
        <source>Export the frames that are shown</source>
        <translation>Angezeigte Frames exportieren</translation>
    </message>
    <message>
        <source>candump log (*.log)</source>
        <translation>candump-Protokoll (*.log)</translation>
    </message>
    <message>
        <source>%1 frames written to %2</source>
        <translation>%1 Frames geschrieben nach %2</translation>
    </message>
    <message>
        <source>pauses the list, and goes on</source>
        <translation>hält die Liste an und lässt sie weiterlaufen</translation>
    </message>
    <message>
        <source>goes to the filter</source>
        <translation>geht zum Filter</translation>
    </message>
    <message>
        <source>finds the next one</source>
        <translation>findet den nächsten</translation>
    </message>
    <message>
        <source>finds the one before</source>
        <translation>findet den vorigen</translation>
    </message>
    <message>
        <source>load %1 &amp;nbsp; frames/s %2</source>
        <translation>Last %1 &amp;nbsp; Frames/s %2</translation>
    </message>
    <message>
        <source>dropped %1 &amp;nbsp; errors %2</source>
        <translation>verworfen %1 &amp;nbsp; Fehler %2</translation>
    </message>
    <message>
        <source>No link yet</source>
        <translation>Noch keine Verbindung</translation>
    </message>
    <message>
        <source>Open a link, or the simulated bench from the menu; what passes on it appears here.</source>
        <translation>Eine Verbindung oder im Menü den simulierten Prüfstand öffnen; hier erscheint, was darüber läuft.</translation>
    </message>
    <message>
        <source>%1 is not open</source>
        <translation>%1 ist nicht offen</translation>
    </message>
    <message>
        <source>load %1 &amp;nbsp; bytes/s %2</source>
        <translation>Last %1 &amp;nbsp; Bytes/s %2</translation>
    </message>
    <message>
        <source>records, or ends the recording</source>
        <translation>nimmt auf oder beendet die Aufnahme</translation>
    </message>
</context>
<context>
    <name>mb::BusSide</name>
    <message>
        <source>Bus load, %</source>
        <translation>Buslast, %</translation>
    </message>
    <message>
        <source>last 60 s, peak %1 %</source>
        <translation>letzte 60 s, Spitze %1 %</translation>
    </message>
    <message>
        <source>%1 identifiers</source>
        <translation>%1 Identifier</translation>
    </message>
    <message>
        <source>busiest %1, %2 frames/s</source>
        <translation>am häufigsten %1, %2 Frames/s</translation>
    </message>
    <message>
        <source>%1 frames of identifiers without a row</source>
        <translation>%1 Frames von Identifiern ohne Zeile</translation>
    </message>
    <message>
        <source>%1 frames that no decoder knows</source>
        <translation>%1 Frames, die kein Decoder kennt</translation>
    </message>
    <message>
        <source>error counters TEC %1, REC %2</source>
        <translation>Fehlerzähler TEC %1, REC %2</translation>
    </message>
</context>
<context>
    <name>mb::BusTables</name>
    <message>
        <source>Frames</source>
        <translation>Frames</translation>
    </message>
    <message>
        <source>Identifiers</source>
        <translation>Identifier</translation>
    </message>
</context>
<context>
    <name>mb::ByteStrip</name>
    <message>
        <source>Bytes %1</source>
        <translation>Bytes %1</translation>
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
    <message>
        <source>look again</source>
        <translation>noch einmal ansehen</translation>
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
        <source>Each value is written. None can be read back: what stands here then is assumed.</source>
        <translation>Jeder Wert wird geschrieben. Keiner kann zurückgelesen werden: Was dann hier steht, ist angenommen.</translation>
    </message>
    <message>
        <source>Each value is written. %1 of %2 cannot be read back: they are assumed then; the others are compared.</source>
        <translation>Jeder Wert wird geschrieben. %1 von %2 können nicht zurückgelesen werden und sind dann angenommen; die anderen werden verglichen.</translation>
    </message>
    <message>
        <source>look again first</source>
        <translation>erst noch einmal ansehen</translation>
    </message>
    <message>
        <source>Write the staged changes</source>
        <translation>Vorgemerkte Änderungen schreiben</translation>
    </message>
</context>
<context>
    <name>mb::Closing</name>
    <message>
        <source>Close MotorBench</source>
        <translation>MotorBench schließen</translation>
    </message>
    <message>
        <source>Keep open</source>
        <translation>Offen lassen</translation>
    </message>
    <message>
        <source>Firmware is being written to %1. Cancel the update?</source>
        <translation>In %1 wird Firmware geschrieben. Aktualisierung abbrechen?</translation>
    </message>
    <message>
        <source>What is written now must not be cut: the window closes once it is over.</source>
        <translation>Was jetzt geschrieben wird, darf nicht unterbrochen werden: Das Fenster schließt, sobald es fertig ist.</translation>
    </message>
    <message>
        <source>Cancel the update and close</source>
        <translation>Aktualisierung abbrechen und schließen</translation>
    </message>
    <message>
        <source>%1 has not been seen to stop. Close anyway?</source>
        <translation>%1 wurde nicht stehend gesehen. Trotzdem schließen?</translation>
    </message>
    <message>
        <source>It was told to stop. Without this window nobody sees whether it does.</source>
        <translation>Der Befehl zum Halten ist gesendet. Ohne dieses Fenster sieht niemand, ob er befolgt wird.</translation>
    </message>
    <message>
        <source>Close anyway</source>
        <translation>Trotzdem schließen</translation>
    </message>
    <message>
        <source>Units are being served. Cancel the queue?</source>
        <translation>Einheiten werden gerade bearbeitet. Die Warteschlange abbrechen?</translation>
    </message>
    <message>
        <source>The journal knows where it stood, and the queue can be gone on with.</source>
        <translation>Das Journal weiß, wo sie stand, und die Warteschlange kann fortgesetzt werden.</translation>
    </message>
    <message>
        <source>Cancel the queue and close</source>
        <translation>Warteschlange abbrechen und schließen</translation>
    </message>
    <message>
        <source>Samples are being written to %1. Cancel the export?</source>
        <translation>Werte werden in %1 geschrieben. Export abbrechen?</translation>
    </message>
    <message>
        <source>Nothing of it is kept then.</source>
        <translation>Dann bleibt nichts davon.</translation>
    </message>
    <message>
        <source>Cancel the export and close</source>
        <translation>Export abbrechen und schließen</translation>
    </message>
    <message>
        <source>The window closes once this has ended: %1</source>
        <translation>Das Fenster schließt sich, sobald dies beendet ist: %1</translation>
    </message>
</context>
<context>
    <name>mb::CommandPalette</name>
    <message>
        <source>Commands</source>
        <translation>Befehle</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>Type what you want to do</source>
        <translation>Schreiben, was geschehen soll</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>page: command</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>No command begins so</source>
        <translation>Kein Befehl beginnt so</translation>
    </message>
</context>
<context>
    <name>mb::ComparedText</name>
    <message>
        <source>in force</source>
        <translation>in Kraft</translation>
    </message>
    <message>
        <source>before</source>
        <translation>vorher</translation>
    </message>
    <message>
        <source>%1: unstable on this model</source>
        <translation>%1: instabil an diesem Modell</translation>
    </message>
    <message>
        <source>%1: over %2 %, Ms %3</source>
        <translation>%1: über %2 %, Ms %3</translation>
    </message>
</context>
<context>
    <name>mb::ComparisonBox</name>
    <message>
        <source>Compare with</source>
        <translation>Vergleich mit</translation>
    </message>
    <message>
        <source>as found %1</source>
        <translation>Stand %1</translation>
    </message>
    <message>
        <source>defaults</source>
        <translation>Standardwerten</translation>
    </message>
    <message>
        <source>axis %1</source>
        <translation>Achse %1</translation>
    </message>
    <message>
        <source>a file…</source>
        <translation>einer Datei…</translation>
    </message>
</context>
<context>
    <name>mb::Conditions</name>
    <message>
        <source>%1 is lost</source>
        <translation>%1 ist verloren</translation>
    </message>
    <message>
        <source>Stopped: %1</source>
        <translation>Gestoppt: %1</translation>
    </message>
    <message>
        <source>Hold the Arm button for 1 s to arm again.</source>
        <translation>Scharf-Taste 1 s halten, um neu scharf zu schalten.</translation>
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
        <source>Writing the settings of %1 again: %2 of %3</source>
        <translation>Einstellungen von %1 werden erneut geschrieben: %2 von %3</translation>
    </message>
    <message>
        <source>Each is confirmed by the board.</source>
        <translation>Jede wird von der Platine bestätigt.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>%1 was reset: 1 setting is unknown</source>
        <translation>%1 wurde zurückgesetzt: 1 Einstellung ist unbekannt</translation>
    </message>
    <message>
        <source>%1 was reset: %2 settings are unknown</source>
        <translation>%1 wurde zurückgesetzt: %2 Einstellungen sind unbekannt</translation>
    </message>
    <message>
        <source>The board keeps nothing without power. This program knows what was last written.</source>
        <translation>Ohne Spannungsversorgung behält die Platine nichts. Dieses Programm kennt das zuletzt Geschriebene.</translation>
    </message>
    <message>
        <source>Write them again</source>
        <translation>Erneut schreiben</translation>
    </message>
    <message>
        <source>Writing was cancelled; what is missing can be written later.</source>
        <translation>Schreiben abgebrochen; Fehlendes lässt sich später schreiben.</translation>
    </message>
    <message>
        <source>Firmware is being written to %1</source>
        <translation>In %1 wird Firmware geschrieben</translation>
    </message>
    <message>
        <source>Do not unplug. %1 of %2.</source>
        <translation>Nicht trennen. %1 von %2.</translation>
    </message>
    <message>
        <source>%1 may still turn: cut its power</source>
        <translation>%1 läuft vielleicht noch: Strom abschalten</translation>
    </message>
    <message>
        <source>Its stop was not confirmed. It is sent again, and first of all when its line is back.</source>
        <translation>Sein Stopp wurde nicht bestätigt. Er wird wiederholt, und als Erstes gesendet, wenn die Leitung wieder da ist.</translation>
    </message>
    <message>
        <source>I have looked: it stands</source>
        <translation>Nachgesehen: er steht</translation>
    </message>
    <message>
        <source>Trial #%1 on %2 was cut before it put its gains back</source>
        <translation>Versuch #%1 an %2 brach ab, bevor er seine Verstärkungen zurückgab</translation>
    </message>
    <message>
        <source>Before it: %1. The motor must stand.</source>
        <translation>Davor: %1. Der Motor muss stehen.</translation>
    </message>
    <message>
        <source>Put them back</source>
        <translation>Zurückgeben</translation>
    </message>
    <message>
        <source>%1 may have been reset: 1 setting is unknown</source>
        <translation>%1 wurde vielleicht zurückgesetzt: 1 Einstellung ist unbekannt</translation>
    </message>
    <message>
        <source>%1 may have been reset: %2 settings are unknown</source>
        <translation>%1 wurde vielleicht zurückgesetzt: %2 Einstellungen sind unbekannt</translation>
    </message>
    <message>
        <source>Nothing shows that it still has what was not saved. This program knows what was last written.</source>
        <translation>Nichts zeigt, dass es noch hat, was nicht gespeichert war. Dieses Programm weiß, was zuletzt geschrieben wurde.</translation>
    </message>
    <message>
        <source>Safe to unplug: the update can be run again. %1 of %2.</source>
        <translation>Trennen erlaubt: die Aktualisierung lässt sich wiederholen. %1 von %2.</translation>
    </message>
    <message>
        <source>Keep what it has</source>
        <translation>Behalten, was es hat</translation>
    </message>
</context>
<context>
    <name>mb::CountTiles</name>
    <message>
        <source>passed</source>
        <translation>bestanden</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>nicht bestanden</translation>
    </message>
    <message>
        <source>refused before start</source>
        <translation>vor Beginn abgelehnt</translation>
    </message>
    <message>
        <source>mean time</source>
        <translation>mittlere Zeit</translation>
    </message>
    <message>
        <source>units an hour</source>
        <translation>Geräte pro Stunde</translation>
    </message>
</context>
<context>
    <name>mb::CrashNotice</name>
    <message>
        <source>The program ended unexpectedly</source>
        <translation>Das Programm endete unerwartet</translation>
    </message>
    <message>
        <source>Open it again</source>
        <translation>Wieder öffnen</translation>
    </message>
    <message>
        <source>Read the report</source>
        <translation>Bericht lesen</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Report of the crash</source>
        <translation>Bericht des Absturzes</translation>
    </message>
    <message>
        <source>File of the report</source>
        <translation>Datei des Berichts</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
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
    <message>
        <source>Replay  ·  %1  ·  shows what was recorded, moves no motor</source>
        <translation>Wiedergabe  ·  %1  ·  zeigt Aufgenommenes, bewegt keinen Motor</translation>
    </message>
    <message>
        <source>Replay</source>
        <translation>Wiedergabe</translation>
    </message>
    <message>
        <source>Demo</source>
        <translation>Demo</translation>
    </message>
</context>
<context>
    <name>mb::DesignBook</name>
    <message>
        <source>%1 waits in its bootloader.</source>
        <translation>%1 wartet im Bootloader.</translation>
    </message>
    <message>
        <source>This family has no loop that can be tuned.</source>
        <translation>Diese Familie hat keinen Regelkreis, der sich abstimmen lässt.</translation>
    </message>
</context>
<context>
    <name>mb::DesignCourse</name>
    <message>
        <source>What the adviser proposes</source>
        <translation>Was der Ratgeber vorschlägt</translation>
    </message>
</context>
<context>
    <name>mb::DesignFrame</name>
    <message>
        <source>Part of the page</source>
        <translation>Teil der Seite</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>Kurven</translation>
    </message>
    <message>
        <source>Course</source>
        <translation>Verlauf</translation>
    </message>
</context>
<context>
    <name>mb::DesignOrders</name>
    <message>
        <source>Loop</source>
        <translation>Regelkreis</translation>
    </message>
    <message>
        <source>Velocity</source>
        <translation>Drehzahl</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Current</source>
        <translation>Strom</translation>
    </message>
    <message>
        <source>Gain slot</source>
        <translation>Slot der Verstärkungen</translation>
    </message>
    <message>
        <source>slot 0</source>
        <translation>Slot 0</translation>
    </message>
    <message>
        <source>slot 1</source>
        <translation>Slot 1</translation>
    </message>
    <message>
        <source>Identify</source>
        <translation>Vermessen</translation>
    </message>
    <message>
        <source>Autotune</source>
        <translation>Selbst abstimmen</translation>
    </message>
    <message>
        <source>Write and prove</source>
        <translation>Schreiben und beweisen</translation>
    </message>
    <message>
        <source>Identifies, writes the chosen set and proves it, in one go</source>
        <translation>Vermisst, schreibt den gewählten Satz und beweist ihn, in einem Zug</translation>
    </message>
</context>
<context>
    <name>mb::DesignPage</name>
    <message>
        <source>writes the chosen set and proves it</source>
        <translation>schreibt den gewählten Satz und beweist ihn</translation>
    </message>
    <message>
        <source>identifies, writes and proves in one go</source>
        <translation>vermisst, schreibt und beweist in einem Zug</translation>
    </message>
    <message>
        <source>identifies the motor</source>
        <translation>vermisst den Motor</translation>
    </message>
    <message>
        <source>Tuning</source>
        <translation>Abstimmung läuft</translation>
    </message>
    <message>
        <source>STOP ends it; what was changed is put back.</source>
        <translation>STOP beendet sie; was geändert war, wird zurückgestellt.</translation>
    </message>
    <message>
        <source>Moving</source>
        <translation>In Bewegung</translation>
    </message>
    <message>
        <source>Stop the motion before the motor is tuned.</source>
        <translation>Die Bewegung anhalten, bevor der Motor abgestimmt wird.</translation>
    </message>
    <message>
        <source>Busy</source>
        <translation>Beschäftigt</translation>
    </message>
    <message>
        <source>Armed</source>
        <translation>Scharf</translation>
    </message>
    <message>
        <source>Not armed</source>
        <translation>Nicht scharf</translation>
    </message>
    <message>
        <source>Hold the Arm button for 1 s to arm %1.</source>
        <translation>Scharf-Taste 1 s halten, um %1 scharf zu schalten.</translation>
    </message>
    <message>
        <source>No tuning here</source>
        <translation>Hier nicht abstimmbar</translation>
    </message>
    <message>
        <source>No device selected</source>
        <translation>Kein Gerät gewählt</translation>
    </message>
    <message>
        <source>Choose a controller in the list at the left.</source>
        <translation>Links in der Liste einen Controller wählen.</translation>
    </message>
    <message>
        <source>Not by itself</source>
        <translation>Nicht von selbst</translation>
    </message>
    <message>
        <source>DEMO</source>
        <translation>DEMO</translation>
    </message>
    <message>
        <source>writes a report of what is shown</source>
        <translation>schreibt einen Bericht über das, was zu sehen ist</translation>
    </message>
    <message>
        <source>No limit</source>
        <translation>Keine Grenze</translation>
    </message>
    <message>
        <source>%1 will turn both ways.</source>
        <translation>%1 wird vor und zurück drehen.</translation>
    </message>
</context>
<context>
    <name>mb::DesignPlots</name>
    <message>
        <source>Step, predicted and measured</source>
        <translation>Sprung, vorhergesagt und gemessen</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>What the gains will do appears here, before they are written.</source>
        <translation>Was die Verstärkungen tun werden, steht hier, bevor sie geschrieben sind.</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Sprung</translation>
    </message>
</context>
<context>
    <name>mb::DeviceCard</name>
    <message>
        <source>velocity</source>
        <translation>Drehzahl</translation>
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
        <source>no watchdog</source>
        <translation>kein Watchdog</translation>
    </message>
    <message>
        <source>It keeps its last set-point if this program dies. A second process beside it, the guardian, stops it then.</source>
        <translation>Es behält seinen letzten Sollwert, wenn dieses Programm abstürzt. Ein zweiter Prozess daneben, der Wächter, hält es dann an.</translation>
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
        <source>position</source>
        <translation>Position</translation>
    </message>
</context>
<context>
    <name>mb::DeviceModel</name>
    <message>
        <source>lost</source>
        <translation>verloren</translation>
    </message>
    <message>
        <source>scanning</source>
        <translation>sucht</translation>
    </message>
    <message>
        <source>%1 of %2: %3, now %4
Its pages show this axis; drag it to a plot.</source>
        <translation>%1 von %2: %3, jetzt %4
Die Seiten des Geräts zeigen diese Achse; in ein Diagramm ziehen.</translation>
    </message>
    <message>
        <source>%1
Double click or Enter plots it; drag it to a plot.</source>
        <translation>%1
Doppelklick oder Enter stellt es dar; in ein Diagramm ziehen.</translation>
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
    <message>
        <source>Search every rate and address (takes minutes)</source>
        <translation>Alle Übertragungsraten und Adressen durchsuchen (dauert Minuten)</translation>
    </message>
    <message>
        <source>Cancel the scan</source>
        <translation>Suche abbrechen</translation>
    </message>
    <message>
        <source>Plot %1</source>
        <translation>%1 darstellen</translation>
    </message>
    <message>
        <source>Show 1 new device</source>
        <translation>1 neues Gerät zeigen</translation>
    </message>
    <message>
        <source>Show %1 new devices</source>
        <translation>%1 neue Geräte zeigen</translation>
    </message>
    <message>
        <source>Open it at every start</source>
        <translation>Bei jedem Start öffnen</translation>
    </message>
</context>
<context>
    <name>mb::DifferenceTable</name>
    <message>
        <source>Differences</source>
        <translation>Unterschiede</translation>
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
        <source>A</source>
        <translation>A</translation>
    </message>
    <message>
        <source>B</source>
        <translation>B</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>belongs to one unit, copied only if you tick it</source>
        <translation>gehört zu einem Gerät, wird nur kopiert, wenn es angehakt ist</translation>
    </message>
    <message>
        <source>assumed: it cannot be read</source>
        <translation>angenommen: nicht lesbar</translation>
    </message>
    <message>
        <source>state</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>This unit</source>
        <translation>Dieses Gerät</translation>
    </message>
    <message>
        <source>%1 of %2 differ</source>
        <translation>%1 von %2 verschieden</translation>
    </message>
</context>
<context>
    <name>mb::DoctorCard</name>
    <message>
        <source>Connection doctor</source>
        <translation>Verbindungsdoktor</translation>
    </message>
    <message>
        <source>looks by itself</source>
        <translation>sieht von selbst nach</translation>
    </message>
    <message>
        <source>CAN</source>
        <translation>CAN</translation>
    </message>
    <message>
        <source>Command for a terminal</source>
        <translation>Befehl für ein Terminal</translation>
    </message>
    <message>
        <source>Copy command</source>
        <translation>Befehl kopieren</translation>
    </message>
    <message>
        <source>Paste it into a terminal; this program never runs as root</source>
        <translation>In ein Terminal einfügen; dieses Programm läuft nie als root</translation>
    </message>
    <message>
        <source>Reconnect</source>
        <translation>Neu verbinden</translation>
    </message>
    <message>
        <source>Open this link now</source>
        <translation>Diese Verbindung jetzt öffnen</translation>
    </message>
    <message>
        <source>The command is in the clipboard; paste it into a terminal.</source>
        <translation>Der Befehl ist in der Zwischenablage; in ein Terminal einfügen.</translation>
    </message>
</context>
<context>
    <name>mb::DriveOptions</name>
    <message>
        <source>Ramp of the output, duty per second</source>
        <translation>Rampe des Ausgangs, Tastgrad pro Sekunde</translation>
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
    <message>
        <source>Greatest change of the output in duty per second: 2 takes 0.5 s from 0 to 100 %.</source>
        <translation>Größte Änderung des Ausgangs in Tastgrad pro Sekunde: 2 braucht 0,5 s von 0 auf 100 %.</translation>
    </message>
    <message>
        <source>duty/s, 0 = %1</source>
        <translation>/s, 0 = %1</translation>
    </message>
    <message>
        <source>%1 is no ramp. Enter 0 or a positive number of duty per second.</source>
        <translation>%1 ist keine Rampe. 0 oder einen positiven Tastgrad pro Sekunde eingeben.</translation>
    </message>
</context>
<context>
    <name>mb::EntryText</name>
    <message>
        <source>passed</source>
        <translation>bestanden</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>nicht bestanden</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>abgelehnt</translation>
    </message>
    <message>
        <source>not ended</source>
        <translation>nicht beendet</translation>
    </message>
    <message>
        <source>as it is now</source>
        <translation>wie es jetzt ist</translation>
    </message>
    <message>
        <source>%1 %2: %3</source>
        <translation>%1 %2: %3</translation>
    </message>
</context>
<context>
    <name>mb::EnvelopePanel</name>
    <message>
        <source>Travel ±</source>
        <translation>Weg ±</translation>
    </message>
    <message>
        <source>Speed</source>
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
        <source>Envelope</source>
        <translation>Grenzen</translation>
    </message>
    <message>
        <source>Envelope: %1</source>
        <translation>Grenzen: %1</translation>
    </message>
    <message>
        <source>Empty: what the device itself says</source>
        <translation>Leer: was das Gerät selbst sagt</translation>
    </message>
    <message>
        <source>%1 holds</source>
        <translation>%1 gilt</translation>
    </message>
    <message>
        <source>not bounded, %1</source>
        <translation>nicht begrenzt, %1</translation>
    </message>
    <message>
        <source>%1: %2 is no limit. It is more than 0, and at most %3.</source>
        <translation>%1: %2 ist keine Grenze. Sie ist mehr als 0 und höchstens %3.</translation>
    </message>
</context>
<context>
    <name>mb::ExperimentDialog</name>
    <message>
        <source>Axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>axis %1</source>
        <translation>Achse %1</translation>
    </message>
    <message>
        <source>Of which motor</source>
        <translation>Zu welchem Motor</translation>
    </message>
    <message>
        <source>Most power</source>
        <translation>Größte Leistung</translation>
    </message>
    <message>
        <source>Not begun</source>
        <translation>Nicht begonnen</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Progress of the experiment</source>
        <translation>Fortschritt des Experiments</translation>
    </message>
    <message>
        <source>Log of the experiment</source>
        <translation>Protokoll des Experiments</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>STOP, Esc or Cancel ends it at any time.</source>
        <translation>STOP, Esc oder Abbrechen beendet es jederzeit.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Hold to turn the motor</source>
        <translation>Halten zum Drehen des Motors</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>Beginnen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Ended</source>
        <translation>Beendet</translation>
    </message>
    <message>
        <source>Found and kept for this device.</source>
        <translation>Gefunden und für dieses Gerät aufbewahrt.</translation>
    </message>
    <message>
        <source>Cancelled. The motor is stopped; gains and limits are as they were.</source>
        <translation>Abgebrochen. Der Motor ist gestoppt; Verstärkungen und Grenzen sind wie zuvor.</translation>
    </message>
</context>
<context>
    <name>mb::ExperimentText</name>
    <message>
        <source>at most %1 s</source>
        <translation>höchstens %1 s</translation>
    </message>
    <message>
        <source>inside the envelope · %1</source>
        <translation>erlaubt · %1</translation>
    </message>
    <message>
        <source>inside the envelope · %1 of %2 · %3</source>
        <translation>erlaubt · %1 von %2 · %3</translation>
    </message>
    <message>
        <source>This mode has no loop that can be tried; Live drives it.</source>
        <translation>Diese Betriebsart hat keinen Regelkreis zum Erproben; „Live“ fährt sie.</translation>
    </message>
    <message>
        <source>Nothing bounds the motor: enter travel, duty, and what else is empty here.</source>
        <translation>Nichts begrenzt den Motor: Weg, Tastgrad und was hier sonst leer ist, eingeben.</translation>
    </message>
    <message>
        <source>Enter where the loop is to go.</source>
        <translation>Eingeben, wohin der Regelkreis soll.</translation>
    </message>
    <message>
        <source>It is there already; enter another place to go to.</source>
        <translation>Dort ist er schon; ein anderes Ziel eingeben.</translation>
    </message>
</context>
<context>
    <name>mb::ExportBar</name>
    <message>
        <source>Progress of the export</source>
        <translation>Fortschritt des Exports</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Writing samples</source>
        <translation>Schreibt Werte</translation>
    </message>
    <message>
        <source>One export at a time: %1 is being written.</source>
        <translation>Nur ein Export zur selben Zeit: %1 wird gerade geschrieben.</translation>
    </message>
    <message>
        <source>writing %1</source>
        <translation>schreibt %1</translation>
    </message>
    <message>
        <source>%1 written: %2 samples, %3 lost</source>
        <translation>%1 geschrieben: %2 Werte, %3 verloren</translation>
    </message>
    <message>
        <source>export cancelled, nothing was written</source>
        <translation>Export abgebrochen, nichts wurde geschrieben</translation>
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
    <message>
        <source>Is that meant?</source>
        <translation>Ist das so gemeint?</translation>
    </message>
</context>
<context>
    <name>mb::FileExchange</name>
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
</context>
<context>
    <name>mb::FirmwarePage</name>
    <message>
        <source>Firmware</source>
        <translation>Firmware</translation>
    </message>
    <message>
        <source>starts the update</source>
        <translation>beginnt die Aktualisierung</translation>
    </message>
    <message>
        <source>What is updated</source>
        <translation>Was aktualisiert wird</translation>
    </message>
    <message>
        <source>Selected unit</source>
        <translation>Gewähltes Gerät</translation>
    </message>
    <message>
        <source>Queue of units</source>
        <translation>Warteschlange</translation>
    </message>
    <message>
        <source>Unit that does not answer</source>
        <translation>Gerät, das nicht antwortet</translation>
    </message>
    <message>
        <source>A unit whose update was cut may be mute: say where it is, and it can be written again</source>
        <translation>Ein Gerät, dessen Update unterbrochen wurde, kann stumm sein: sagen, wo es ist, und es kann neu geschrieben werden</translation>
    </message>
</context>
<context>
    <name>mb::FirmwareShelf</name>
    <message>
        <source>not read yet</source>
        <translation>noch nicht gelesen</translation>
    </message>
    <message>
        <source>%1 · checked · %2</source>
        <translation>%1 · geprüft · %2</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Details</translation>
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
        <source>Fields</source>
        <translation>Felder</translation>
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
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copy the selected frames as candump text (Ctrl+C)</source>
        <translation>Gewählte Frames als candump-Text kopieren (Strg+C)</translation>
    </message>
    <message>
        <source>Send again…</source>
        <translation>Erneut senden…</translation>
    </message>
    <message>
        <source>No frame selected</source>
        <translation>Kein Frame gewählt</translation>
    </message>
    <message>
        <source>Select one to see its fields</source>
        <translation>Einen wählen, um seine Felder zu sehen</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Error frame</source>
        <translation>Fehlerframe</translation>
    </message>
    <message>
        <source>%1 · %2 #%3 · %4</source>
        <translation>%1 · %2 #%3 · %4</translation>
    </message>
    <message>
        <source>%1 = %2, bits %3</source>
        <translation>%1 = %2, Bits %3</translation>
    </message>
    <message>
        <source>%1 bytes</source>
        <translation>%1 Byte</translation>
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
    <message>
        <source>%1 bytes</source>
        <translation>%1 Byte</translation>
    </message>
    <message>
        <source>asks for data</source>
        <translation>fordert Daten an</translation>
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
        <translation>Eine Dekade je Richtung. ← → 2 %, mit Umschalt 0,2 %, mit Strg 20 %</translation>
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
    <message>
        <source>unknown until written</source>
        <translation>bis zum Schreiben unbekannt</translation>
    </message>
    <message>
        <source>Use it</source>
        <translation>Verwenden</translation>
    </message>
    <message>
        <source>Use this %1</source>
        <translation>%1 so verwenden</translation>
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
        <translation>G · ←→ 2 % · ⇧ 0,2 %</translation>
    </message>
    <message>
        <source>Gains, slot %1</source>
        <translation>Verstärkungen, Slot %1</translation>
    </message>
    <message>
        <source>Hide limits of the loop</source>
        <translation>Grenzen des Reglers ausblenden</translation>
    </message>
    <message>
        <source>No loop runs in %1 mode: these gains act in velocity, position and current.</source>
        <translation>Bei %1 läuft kein Regler: diese Verstärkungen wirken bei Drehzahl, Position und Strom.</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>Divisor</source>
        <translation>Divisor</translation>
    </message>
    <message>
        <source>Gains, axis %1</source>
        <translation>Regler, Achse %1</translation>
    </message>
    <message>
        <source>Limits of the axis</source>
        <translation>Grenzen der Achse</translation>
    </message>
    <message>
        <source>Limits of the loop</source>
        <translation>Grenzen des Reglers</translation>
    </message>
    <message>
        <source>No loop runs in %1 mode: only the limits of the axis act.</source>
        <translation>Bei %1 läuft kein Regler: nur die Grenzen der Achse wirken.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>mb::GainsWriteRow</name>
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
    <message numerus="yes">
        <source>%n value(s)</source>
        <translation>
            <numerusform>%n Wert</numerusform>
            <numerusform>%n Werte</numerusform>
        </translation>
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
        <source>A gain is out of range</source>
        <translation>Eine Verstärkung liegt außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>No gain is edited</source>
        <translation>Keine Verstärkung ist geändert</translation>
    </message>
    <message>
        <source>The device is busy</source>
        <translation>Das Gerät ist beschäftigt</translation>
    </message>
</context>
<context>
    <name>mb::GroupMotion</name>
    <message>
        <source>not prepared: hold the Arm button first</source>
        <translation>nicht vorbereitet: zuerst die Scharf-Taste halten</translation>
    </message>
    <message>
        <source>not prepared: the selected device has to take part</source>
        <translation>nicht vorbereitet: das gewählte Gerät muss teilnehmen</translation>
    </message>
    <message>
        <source>not started: not every device has acknowledged its move; prepare them again</source>
        <translation>nicht gestartet: nicht jedes Gerät hat seine Bewegung bestätigt; erneut vorbereiten</translation>
    </message>
    <message>
        <source>stopped, and the others of its group with it: %1</source>
        <translation>gestoppt, und mit ihm die anderen seiner Gruppe: %1</translation>
    </message>
    <message>
        <source>it is gone</source>
        <translation>es ist weg</translation>
    </message>
    <message>
        <source>not prepared: an experiment on the selected device has not ended</source>
        <translation>nicht vorbereitet: ein Versuch mit dem gewählten Gerät ist noch nicht zu Ende</translation>
    </message>
</context>
<context>
    <name>mb::GuardianCheck</name>
    <message>
        <source>stops a motor when this program is killed or hangs</source>
        <translation>hält einen Motor an, wenn dieses Programm beendet wird oder hängt</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>Check the guardian</source>
        <translation>Den Wächter prüfen</translation>
    </message>
    <message>
        <source>%1 cannot be started: %2</source>
        <translation>%1 lässt sich nicht starten: %2</translation>
    </message>
    <message>
        <source>It is in place and runs.</source>
        <translation>Er ist da und läuft.</translation>
    </message>
    <message>
        <source>%1 does not run as it should.</source>
        <translation>%1 läuft nicht, wie es soll.</translation>
    </message>
</context>
<context>
    <name>mb::Guide</name>
    <message>
        <source>overshoot %1 % at first, %2 % now</source>
        <translation>Überschwingen erst %1 %, jetzt %2 %</translation>
    </message>
    <message>
        <source>overshoot %1 %</source>
        <translation>Überschwingen %1 %</translation>
    </message>
    <message>
        <source>peak current %1 A</source>
        <translation>Spitzenstrom %1 A</translation>
    </message>
    <message>
        <source>%1 counts beside its target at first, %2 now</source>
        <translation>erst %1 Schritte neben dem Ziel, jetzt %2</translation>
    </message>
    <message>
        <source>%1 counts beside its target</source>
        <translation>%1 Schritte neben dem Ziel</translation>
    </message>
</context>
<context>
    <name>mb::GuideStrip</name>
    <message>
        <source>Guide</source>
        <translation>Anleitung</translation>
    </message>
    <message>
        <source>Show me where</source>
        <translation>Zeigen, wo</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>Beginnen</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Not now</source>
        <translation>Jetzt nicht</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Simulated: nothing real moves. A guide says each step and waits until it has happened.</source>
        <translation>Simuliert: nichts Echtes bewegt sich. Eine Anleitung nennt jeden Schritt und wartet, bis er geschehen ist.</translation>
    </message>
    <message>
        <source>%1 done</source>
        <translation>%1 fertig</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>Done.</source>
        <translation>Fertig.</translation>
    </message>
    <message>
        <source>The simulated bench is opened; the unit answers in a moment.</source>
        <translation>Der simulierte Prüfstand wird geöffnet; das Gerät antwortet gleich.</translation>
    </message>
    <message>
        <source>Measured: %1.</source>
        <translation>Gemessen: %1.</translation>
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
        <source>1 link</source>
        <translation>1 Verbindung</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Aufnahme</translation>
    </message>
</context>
<context>
    <name>mb::HelpBrowser</name>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
</context>
<context>
    <name>mb::HelpDesk</name>
    <message>
        <source>Help for this page</source>
        <translation>Hilfe zu dieser Seite</translation>
    </message>
</context>
<context>
    <name>mb::HelpWindow</name>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>Pages of the help</source>
        <translation>Seiten der Hilfe</translation>
    </message>
</context>
<context>
    <name>mb::HistoryPanel</name>
    <message>
        <source>State A</source>
        <translation>Stand A</translation>
    </message>
    <message>
        <source>State B</source>
        <translation>Stand B</translation>
    </message>
    <message>
        <source>Which parameters</source>
        <translation>Welche Parameter</translation>
    </message>
    <message>
        <source>Only differences</source>
        <translation>Nur Unterschiede</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alle</translation>
    </message>
    <message>
        <source>Restore what is ticked</source>
        <translation>Angehaktes zurückschreiben</translation>
    </message>
    <message>
        <source>Only differences %1</source>
        <translation>Nur Unterschiede %1</translation>
    </message>
    <message>
        <source>All %1</source>
        <translation>Alle %1</translation>
    </message>
    <message>
        <source>%1 ticked; a snapshot of what is there is taken first.</source>
        <translation>%1 angehakt; was jetzt da ist, wird vorher festgehalten.</translation>
    </message>
    <message>
        <source>Choose what the device has now as A to write values of B.</source>
        <translation>Als A wählen, was das Gerät jetzt hat, um Werte von B zu schreiben.</translation>
    </message>
    <message>
        <source>Restore %1</source>
        <translation>%1 zurückschreiben</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Zeitachse</translation>
    </message>
    <message>
        <source>differences from A</source>
        <translation>Unterschiede zu A</translation>
    </message>
    <message>
        <source>Click sets B, Shift+click sets A.</source>
        <translation>Klick setzt B, Umschalt+Klick setzt A.</translation>
    </message>
    <message>
        <source>Exchange A and B</source>
        <translation>A und B vertauschen</translation>
    </message>
    <message>
        <source>Copy as text</source>
        <translation>Als Text kopieren</translation>
    </message>
    <message>
        <source>Keep or revert first</source>
        <translation>Erst behalten oder zurück</translation>
    </message>
</context>
<context>
    <name>mb::IdModel</name>
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
        <source>every %1 ms, standard deviation %2 ms, largest deviation %3 ms, over the last 32 periods</source>
        <translation>alle %1 ms, Standardabweichung %2 ms, größte Abweichung %3 ms, über die letzten 32 Perioden</translation>
    </message>
    <message>
        <source>Right click: choose the field</source>
        <translation>Rechtsklick: Feld wählen</translation>
    </message>
    <message>
        <source>Standard deviation of the last 32 periods</source>
        <translation>Standardabweichung der letzten 32 Perioden</translation>
    </message>
    <message>
        <source>The last frame; bytes that changed within 0.7 s are marked</source>
        <translation>Der letzte Frame; Bytes, die sich innerhalb von 0,7 s geändert haben, sind markiert</translation>
    </message>
    <message>
        <source>id</source>
        <translation>ID</translation>
    </message>
    <message>
        <source>dir</source>
        <translation>Ri.</translation>
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
        <source>rate Hz</source>
        <translation>Rate Hz</translation>
    </message>
    <message>
        <source>jitter ms</source>
        <translation>Jitter ms</translation>
    </message>
    <message>
        <source>frames</source>
        <translation>Frames</translation>
    </message>
    <message>
        <source>data</source>
        <translation>Daten</translation>
    </message>
    <message>
        <source>last value</source>
        <translation>letzter Wert</translation>
    </message>
    <message>
        <source>last 5 s</source>
        <translation>letzte 5 s</translation>
    </message>
</context>
<context>
    <name>mb::ImageText</name>
    <message>
        <source>no image yet</source>
        <translation>noch kein Image</translation>
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
        <source>version %1 · pages: %2</source>
        <translation>Version %1 · Seiten: %2</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
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
        <source>velocity</source>
        <translation>Drehzahl</translation>
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
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>limits</source>
        <translation>Grenzen</translation>
    </message>
    <message>
        <source>Blink the lamps of this unit</source>
        <translation>Die Lampen dieses Geräts blinken lassen</translation>
    </message>
</context>
<context>
    <name>mb::JogPanel</name>
    <message>
        <source>Nudge −</source>
        <translation>Schubs −</translation>
    </message>
    <message>
        <source>Nudge +</source>
        <translation>Schubs +</translation>
    </message>
    <message>
        <source>Nudge backwards</source>
        <translation>Rückwärts anschubsen</translation>
    </message>
    <message>
        <source>Nudge forwards</source>
        <translation>Vorwärts anschubsen</translation>
    </message>
    <message>
        <source>A click moves it for a tenth of a second; held, it goes on until it is let go.</source>
        <translation>Ein Klick bewegt ihn eine Zehntelsekunde; gehalten läuft er, bis man loslässt.</translation>
    </message>
</context>
<context>
    <name>mb::JournalCard</name>
    <message>
        <source>Journal</source>
        <translation>Journal</translation>
    </message>
    <message>
        <source>Change…</source>
        <translation>Ändern…</translation>
    </message>
    <message>
        <source>Change the journal</source>
        <translation>Journal ändern</translation>
    </message>
    <message>
        <source>On this computer</source>
        <translation>Auf diesem Rechner</translation>
    </message>
    <message>
        <source>PostgreSQL, %1</source>
        <translation>PostgreSQL, %1</translation>
    </message>
    <message>
        <source>station %1</source>
        <translation>Station %1</translation>
    </message>
    <message numerus="yes">
        <source>%n entries wait for the server</source>
        <translation>
            <numerusform>%n Eintrag wartet auf den Server</numerusform>
            <numerusform>%n Einträge warten auf den Server</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n units of this run are in it</source>
        <translation>
            <numerusform>%n Gerät dieses Laufs steht darin</numerusform>
            <numerusform>%n Geräte dieses Laufs stehen darin</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mb::KeepBar</name>
    <message>
        <source>30 s from when the unit has restarted with them</source>
        <translation>30 s, sobald das Gerät damit neu gestartet ist</translation>
    </message>
    <message>
        <source>they go back in %1 s</source>
        <translation>zurück in %1 s</translation>
    </message>
    <message>
        <source>they go back as soon as the motor stands</source>
        <translation>zurück, sobald der Motor steht</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Behalten</translation>
    </message>
    <message>
        <source>Time until the values go back</source>
        <translation>Zeit, bis die Werte zurückgehen</translation>
    </message>
    <message numerus="yes">
        <source>%1 · %n more change(s) after this one</source>
        <translation>
            <numerusform>%1 · danach noch %n Änderung</numerusform>
            <numerusform>%1 · danach noch %n Änderungen</numerusform>
        </translation>
    </message>
    <message>
        <source>Keep these values of %1?</source>
        <translation>Diese Werte von %1 behalten?</translation>
    </message>
    <message>
        <source>nothing goes back by itself</source>
        <translation>nichts geht von selbst zurück</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>Zurückschreiben</translation>
    </message>
</context>
<context>
    <name>mb::KeyBook</name>
    <message>
        <source>This key cannot be changed.</source>
        <translation>Diese Taste lässt sich nicht ändern.</translation>
    </message>
    <message>
        <source>%1 stops every motor, always.</source>
        <translation>%1 hält jeden Motor an, immer.</translation>
    </message>
    <message>
        <source>%1 is taken, %2: %3. Give that another key first.</source>
        <translation>%1 ist vergeben, %2: %3. Geben Sie dem erst eine andere Taste.</translation>
    </message>
    <message>
        <source>%1 belongs to the control that has the focus.</source>
        <translation>%1 gehört dem Bedienelement, das den Fokus hat.</translation>
    </message>
</context>
<context>
    <name>mb::KeyDesk</name>
    <message>
        <source>stop every motor</source>
        <translation>halten jeden Motor an</translation>
    </message>
    <message>
        <source>stops every motor, unless words can be typed where the focus is</source>
        <translation>hält jeden Motor an, außer wo gerade Text eingegeben wird</translation>
    </message>
    <message>
        <source>presses the button or ticks the box that has the focus</source>
        <translation>drückt die Schaltfläche oder setzt das Häkchen, wo der Fokus ist</translation>
    </message>
    <message>
        <source>held for 1 s: arms; let go early it does nothing</source>
        <translation>1 s gehalten: schaltet scharf; zu früh losgelassen geschieht nichts</translation>
    </message>
    <message>
        <source>keeps values that go back by themselves otherwise</source>
        <translation>behält Werte, die sonst von selbst zurückgehen</translation>
    </message>
    <message>
        <source>Everywhere</source>
        <translation>Überall</translation>
    </message>
    <message>
        <source>Production</source>
        <translation>Produktion</translation>
    </message>
    <message>
        <source>%1  %2</source>
        <comment>page, key</comment>
        <translation>%1  %2</translation>
    </message>
</context>
<context>
    <name>mb::KeyField</name>
    <message>
        <source>Press the new key here</source>
        <translation>Hier die neue Taste drücken</translation>
    </message>
    <message>
        <source>New key</source>
        <translation>Neue Taste</translation>
    </message>
</context>
<context>
    <name>mb::KeysPanel</name>
    <message>
        <source>Search commands and keys</source>
        <translation>Befehle und Tasten suchen</translation>
    </message>
    <message>
        <source>Commands and their keys</source>
        <translation>Befehle und ihre Tasten</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Taste</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>Vorgabe</translation>
    </message>
    <message>
        <source>No key</source>
        <translation>Keine Taste</translation>
    </message>
    <message>
        <source>All defaults</source>
        <translation>Alle Vorgaben</translation>
    </message>
    <message>
        <source>All keys are those they came with.</source>
        <translation>Alle Tasten sind wieder wie ausgeliefert.</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>It came with: %1</source>
        <translation>Ausgeliefert mit: %1</translation>
    </message>
    <message>
        <source>This key cannot be changed.</source>
        <translation>Diese Taste lässt sich nicht ändern.</translation>
    </message>
    <message>
        <source>Choose a command, then press its new key in the field.</source>
        <translation>Befehl wählen, dann im Feld seine neue Taste drücken.</translation>
    </message>
</context>
<context>
    <name>mb::Lamp</name>
    <message>
        <source>Arm button: %1</source>
        <translation>Scharf-Taste: %1</translation>
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
        <source>A motor was told to stop and was not seen to. Cut its power, or look at it.</source>
        <translation>Ein Motor sollte stoppen, und niemand hat ihn stehen sehen. Strom abschalten oder nachsehen.</translation>
    </message>
</context>
<context>
    <name>mb::LampFace</name>
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
        <source>STOPPING</source>
        <translation>STOPPT</translation>
    </message>
    <message>
        <source>MAY STILL TURN</source>
        <translation>LÄUFT VIELLEICHT</translation>
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
        <source>cut its power</source>
        <translation>Strom abschalten</translation>
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
    <name>mb::LinkOptions</name>
    <message>
        <source>Bit rate</source>
        <translation>Bitrate</translation>
    </message>
    <message>
        <source>find it: all rates of the protocol</source>
        <translation>suchen: alle Raten des Protokolls</translation>
    </message>
    <message>
        <source>%1 bit/s</source>
        <translation>%1 bit/s</translation>
    </message>
    <message>
        <source>the computer&apos;s own RS-485 port</source>
        <translation>eigener RS-485-Port des Rechners</translation>
    </message>
    <message>
        <source>RS-485</source>
        <translation>RS-485</translation>
    </message>
    <message>
        <source>Lets the kernel switch the driver of a port on the computer&apos;s board. Adapters on USB switch by themselves: leave it off.</source>
        <translation>Der Kernel schaltet den Treiber eines Ports auf der Platine des Rechners. USB-Adapter schalten selbst: dann aus lassen.</translation>
    </message>
    <message>
        <source>Clock</source>
        <translation>Takt</translation>
    </message>
    <message>
        <source>%1 kHz</source>
        <translation>%1 kHz</translation>
    </message>
    <message>
        <source>Ready line (SRDY)</source>
        <translation>Bereit-Leitung (SRDY)</translation>
    </message>
    <message>
        <source>Reset line (MCLR)</source>
        <translation>Reset-Leitung (MCLR)</translation>
    </message>
    <message>
        <source>Lost frames</source>
        <translation>Verlorene Frames</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>not wired</source>
        <translation>nicht verdrahtet</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
</context>
<context>
    <name>mb::LinkOwners</name>
    <message>
        <source>%1, process %2</source>
        <translation>%1, Prozess %2</translation>
    </message>
    <message>
        <source>%1 has this link too. Agree who drives: two masters on one motor disturb each other.</source>
        <translation>%1 hat diese Verbindung auch. Absprechen, wer fährt: zwei Master an einem Motor stören einander.</translation>
    </message>
    <message>
        <source>%1 has this port. Close it there, then reconnect.</source>
        <translation>%1 hat diesen Port. Dort schließen, dann neu verbinden.</translation>
    </message>
</context>
<context>
    <name>mb::ListCard</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>mb::LiveStateBar</name>
    <message>
        <source>Limits and pins</source>
        <translation>Grenzen und Eingänge</translation>
    </message>
    <message>
        <source>no limit holds</source>
        <translation>keine Grenze hält</translation>
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
    <message>
        <source>searches</source>
        <translation>sucht</translation>
    </message>
</context>
<context>
    <name>mb::MainWindow</name>
    <message>
        <source>MotorBench</source>
        <translation>MotorBench</translation>
    </message>
    <message>
        <source>button</source>
        <translation>Schaltfläche</translation>
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
        <source>needs a device; open a link first</source>
        <translation>braucht ein Gerät; zuerst eine Verbindung öffnen</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>verloren</translation>
    </message>
    <message>
        <source>simulated bench</source>
        <translation>simulierter Prüfstand</translation>
    </message>
    <message>
        <source>the window lost the focus</source>
        <translation>das Fenster verlor den Fokus</translation>
    </message>
    <message>
        <source>REC %1</source>
        <translation>REC %1</translation>
    </message>
    <message>
        <source>%1: %2 frames received, %3 sent, %4 dropped, %5 errors</source>
        <translation>%1: %2 Frames empfangen, %3 gesendet, %4 verworfen, %5 Fehler</translation>
    </message>
    <message>
        <source>%1: %2 bytes received, %3 sent, %4 dropped, %5 errors</source>
        <translation>%1: %2 Bytes empfangen, %3 gesendet, %4 verworfen, %5 Fehler</translation>
    </message>
    <message>
        <source>Design</source>
        <translation>Entwurf</translation>
    </message>
    <message>
        <source>Reports</source>
        <translation>Berichte</translation>
    </message>
    <message>
        <source>The preferences hold as soon as nothing is armed, no job runs and no other window is open.</source>
        <translation>Die Einstellungen gelten, sobald nichts scharf ist, kein Vorgang läuft und kein anderes Fenster offen ist.</translation>
    </message>
    <message>
        <source>the limits were not kept: %1</source>
        <translation>die Grenzen wurden nicht behalten: %1</translation>
    </message>
</context>
<context>
    <name>mb::MetricsPanel</name>
    <message>
        <source>Metrics</source>
        <translation>Kennwerte</translation>
    </message>
    <message>
        <source>Metrics of A and B</source>
        <translation>Kennwerte von A und B</translation>
    </message>
    <message>
        <source>Loop health</source>
        <translation>Zustand des Regelkreises</translation>
    </message>
    <message>
        <source>metric</source>
        <translation>Kennwert</translation>
    </message>
    <message>
        <source>Δ B − A</source>
        <comment>difference</comment>
        <translation>Δ B − A</translation>
    </message>
    <message>
        <source>± from %1 repeats</source>
        <translation>± aus %1 Läufen</translation>
    </message>
    <message>
        <source>SAT %1 %</source>
        <translation>SAT %1 %</translation>
    </message>
    <message>
        <source>Share of the hold in which the duty was at its limit</source>
        <translation>Anteil der Haltezeit mit dem Tastgrad an seiner Grenze</translation>
    </message>
    <message>
        <source>ILIM</source>
        <translation>ILIM</translation>
    </message>
    <message>
        <source>The current was at its limit</source>
        <translation>Der Strom war an seiner Grenze</translation>
    </message>
    <message>
        <source>RAMP</source>
        <translation>RAMPE</translation>
    </message>
    <message>
        <source>The drive&apos;s own ramp was on</source>
        <translation>Die Rampe des Reglers war an</translation>
    </message>
    <message>
        <source>LIMIT SW</source>
        <translation>ENDSCH</translation>
    </message>
    <message>
        <source>A limit switch was met</source>
        <translation>Ein Endschalter wurde erreicht</translation>
    </message>
    <message>
        <source>QUANT</source>
        <translation>QUANT</translation>
    </message>
    <message>
        <source>The step has few counts of the encoder</source>
        <translation>Der Sprung hat wenige Geberschritte</translation>
    </message>
    <message>
        <source>LOST %1</source>
        <translation>FEHLT %1</translation>
    </message>
    <message>
        <source>Samples that are missing</source>
        <translation>Messwerte, die fehlen</translation>
    </message>
    <message>
        <source>SIMULATED</source>
        <translation>SIMULIERT</translation>
    </message>
    <message>
        <source>Made on a simulated controller, and marked so for ever</source>
        <translation>An einem simulierten Regler entstanden und für immer so bezeichnet</translation>
    </message>
    <message>
        <source>%1= same</source>
        <translation>%1= gleich</translation>
    </message>
    <message>
        <source>WINDUP %1</source>
        <translation>WINDUP %1</translation>
    </message>
    <message>
        <source>WINDUP</source>
        <translation>WINDUP</translation>
    </message>
    <message>
        <source>The duty was at its limit while I went on; that is paid back as overshoot</source>
        <translation>Der Tastgrad war an seiner Grenze, während I weiterlief; das wird als Überschwingen zurückgezahlt</translation>
    </message>
    <message>
        <source>means of %1 repeats</source>
        <translation>Mittel aus %1 Läufen</translation>
    </message>
    <message>
        <source>%1= same ±%2</source>
        <translation>%1= gleich ±%2</translation>
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
</context>
<context>
    <name>mb::ModelPanel</name>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>Nobody has identified this motor yet. Identify pushes it both ways with a part of the duty, inside the limits below, and changes no gain.</source>
        <translation>Dieser Motor ist noch nicht vermessen. Vermessen stößt ihn in beide Richtungen mit einem Teil des Tastgrads an, innerhalb der Grenzen unten, und ändert keine Verstärkung.</translation>
    </message>
    <message>
        <source>good fit</source>
        <translation>passt gut</translation>
    </message>
    <message>
        <source>not believed</source>
        <translation>nicht geglaubt</translation>
    </message>
    <message>
        <source>velocity filter</source>
        <translation>Drehzahlfilter</translation>
    </message>
    <message>
        <source>counts/s</source>
        <translation>counts/s</translation>
    </message>
    <message>
        <source>All figures</source>
        <translation>Alle Werte</translation>
    </message>
    <message>
        <source>Fold</source>
        <translation>Einklappen</translation>
    </message>
</context>
<context>
    <name>mb::MotionTour</name>
    <message>
        <source>acceleration</source>
        <translation>Beschleunigung</translation>
    </message>
    <message>
        <source>counts/s²</source>
        <translation>counts/s²</translation>
    </message>
    <message>
        <source>at speed</source>
        <translation>auf Drehzahl</translation>
    </message>
</context>
<context>
    <name>mb::MotionWords</name>
    <message>
        <source>%1 axes</source>
        <translation>%1 Achsen</translation>
    </message>
    <message>
        <source>axis %1 %2</source>
        <translation>Achse %1 %2</translation>
    </message>
    <message>
        <source>%1 on the adapter before</source>
        <translation>%1 am vorigen Adapter</translation>
    </message>
</context>
<context>
    <name>mb::MovesPanel</name>
    <message>
        <source>Moves together</source>
        <translation>Gemeinsame Bewegungen</translation>
    </message>
    <message>
        <source>to a position</source>
        <translation>auf eine Position</translation>
    </message>
    <message>
        <source>by a distance</source>
        <translation>um eine Strecke</translation>
    </message>
    <message>
        <source>at a velocity</source>
        <translation>mit einer Drehzahl</translation>
    </message>
    <message>
        <source>Kind of the moves</source>
        <translation>Art der Bewegungen</translation>
    </message>
    <message>
        <source>profiled</source>
        <translation>mit Profil</translation>
    </message>
    <message>
        <source>With the stored acceleration and velocity</source>
        <translation>Mit gespeicherter Beschleunigung und Drehzahl</translation>
    </message>
    <message>
        <source>With the acceleration and velocity that are stored in the device.</source>
        <translation>Mit der Beschleunigung und Drehzahl, die im Gerät gespeichert sind.</translation>
    </message>
    <message>
        <source>Prepare</source>
        <translation>Vorbereiten</translation>
    </message>
    <message>
        <source>Switches the motors on where they stand, and gives each its move to keep.</source>
        <translation>Schaltet die Motoren ein, wo sie stehen, und gibt jedem seine Bewegung zum Bereithalten.</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Start the prepared moves together</source>
        <translation>Vorbereitete Bewegungen gemeinsam starten</translation>
    </message>
    <message>
        <source>One command on the line starts all prepared moves at the same moment.</source>
        <translation>Ein Befehl auf der Leitung startet alle vorbereiteten Bewegungen im selben Augenblick.</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>Halten</translation>
    </message>
    <message>
        <source>Hold all of them where they are</source>
        <translation>Alle dort halten, wo sie sind</translation>
    </message>
    <message>
        <source>Brakes to a halt and holds the position. The motors stay on; STOP switches them off.</source>
        <translation>Bremst bis zum Stillstand und hält die Position. Die Motoren bleiben eingeschaltet; STOP schaltet sie ab.</translation>
    </message>
    <message>
        <source>%1 takes part</source>
        <translation>%1 nimmt teil</translation>
    </message>
    <message>
        <source>Target of %1</source>
        <translation>Ziel von %1</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>keine Antwort</translation>
    </message>
    <message>
        <source>started</source>
        <translation>gestartet</translation>
    </message>
    <message>
        <source>prepared</source>
        <translation>vorbereitet</translation>
    </message>
    <message>
        <source>being prepared</source>
        <translation>wird vorbereitet</translation>
    </message>
    <message>
        <source>moving</source>
        <translation>in Bewegung</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>gesperrt</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>Hold the Arm button. It covers all that take part.</source>
        <translation>Die Scharf-Taste halten. Sie gilt für alle, die teilnehmen.</translation>
    </message>
    <message>
        <source>All are prepared. Start begins them at the same moment.</source>
        <translation>Alle sind vorbereitet. Start beginnt sie im selben Augenblick.</translation>
    </message>
    <message>
        <source>Prepare switches the motors on where they stand; nothing turns before Start.</source>
        <translation>Vorbereiten schaltet die Motoren ein, wo sie stehen; vor dem Start dreht sich nichts.</translation>
    </message>
    <message>
        <source>not prepared: &apos;%1&apos; is no number of counts</source>
        <translation>nicht vorbereitet: „%1“ ist keine Anzahl von counts</translation>
    </message>
    <message>
        <source>keeps a move</source>
        <translation>behält eine Bewegung</translation>
    </message>
    <message>
        <source>Stop takes no move away that has not begun: %1 would begin it with the next start on this line. Prepare gives a new one; switching the unit off clears it.</source>
        <translation>Stopp nimmt keine Bewegung weg, die nicht begonnen hat: %1 begänne sie mit dem nächsten Start auf dieser Leitung. Vorbereiten gibt eine neue; Ausschalten löscht sie.</translation>
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
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>mb::OverviewPage</name>
    <message>
        <source>Overview</source>
        <translation>Übersicht</translation>
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
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>Frames received that no controller family knows: somebody else&apos;s traffic</source>
        <translation>Empfangene Frames, die keine Controllerfamilie kennt: fremder Verkehr</translation>
    </message>
    <message>
        <source>round trip</source>
        <translation>Umlaufzeit</translation>
    </message>
    <message>
        <source>Load of the last minute</source>
        <translation>Auslastung der letzten Minute</translation>
    </message>
</context>
<context>
    <name>mb::OwnProposal</name>
    <message>
        <source>own</source>
        <translation>eigener</translation>
    </message>
    <message>
        <source>Own proposal</source>
        <translation>Eigener Vorschlag</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>calm</source>
        <translation>ruhig</translation>
    </message>
    <message>
        <source>brisk</source>
        <translation>flott</translation>
    </message>
    <message>
        <source>Damping</source>
        <translation>Dämpfung</translation>
    </message>
    <message>
        <source>robust</source>
        <translation>robust</translation>
    </message>
    <message>
        <source>lively</source>
        <translation>lebhaft</translation>
    </message>
    <message>
        <source>τc %1</source>
        <translation>τc %1</translation>
    </message>
    <message>
        <source>Ms ≤ %1</source>
        <translation>Ms ≤ %1</translation>
    </message>
    <message>
        <source>The device cannot have this set: %1</source>
        <translation>Diesen Satz kann das Gerät nicht haben: %1</translation>
    </message>
    <message>
        <source>Held at τc %1 by: %2</source>
        <translation>Bei τc %1 gehalten durch: %2</translation>
    </message>
    <message>
        <source>proposal %1</source>
        <translation>Vorschlag %1</translation>
    </message>
</context>
<context>
    <name>mb::PageKeys</name>
    <message>
        <source>Keys: %1</source>
        <translation>Tasten: %1</translation>
    </message>
    <message>
        <source>Everywhere</source>
        <translation>Überall</translation>
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
    <name>mb::PageStack</name>
    <message>
        <source>Pages</source>
        <translation>Seiten</translation>
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
    <name>mb::ParameterCommands</name>
    <message>
        <source>What was written before it is in force; the rest is still staged. Nothing was stored.</source>
        <translation>Das davor Geschriebene gilt; der Rest bleibt vorgemerkt. Nichts wurde gespeichert.</translation>
    </message>
    <message>
        <source>Nothing is proved to be in flash. Store again, and keep power on.</source>
        <translation>Nichts ist als gespeichert nachgewiesen. Erneut speichern, Versorgung an lassen.</translation>
    </message>
    <message>
        <source>Nothing is kept.</source>
        <translation>Nichts wurde festgehalten.</translation>
    </message>
    <message>
        <source>What was written before it is in force. Undo takes it back.</source>
        <translation>Was davor geschrieben wurde, gilt. Rückgängig nimmt es zurück.</translation>
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
    <message>
        <source>↑↓ row · Enter edit · %1 write</source>
        <translation>↑↓ Zeile · Enter ändern · %1 schreiben</translation>
    </message>
</context>
<context>
    <name>mb::ParameterGroups</name>
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
</context>
<context>
    <name>mb::ParameterHead</name>
    <message>
        <source>Undo the last edit or write</source>
        <translation>Letzte Änderung oder letztes Schreiben zurücknehmen</translation>
    </message>
    <message>
        <source>Redo the edit or write</source>
        <translation>Änderung oder Schreiben wiederholen</translation>
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
        <source>Snapshot</source>
        <translation>Festhalten</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>More for the parameters</source>
        <translation>Mehr für die Parameter</translation>
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
    <message>
        <source>unknown until written</source>
        <translation>bis zum Schreiben unbekannt</translation>
    </message>
</context>
<context>
    <name>mb::ParameterTools</name>
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
        <source>Import parameters</source>
        <translation>Parameter importieren</translation>
    </message>
    <message>
        <source>Export parameters</source>
        <translation>Parameter exportieren</translation>
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
        <source>Compare with a parameter file</source>
        <translation>Mit einer Parameterdatei vergleichen</translation>
    </message>
    <message>
        <source>reads all parameters</source>
        <translation>liest alle Parameter</translation>
    </message>
    <message>
        <source>searches</source>
        <translation>sucht</translation>
    </message>
    <message>
        <source>writes what is staged</source>
        <translation>schreibt, was vorgemerkt ist</translation>
    </message>
    <message>
        <source>undoes the last edit, or else the last write to the unit</source>
        <translation>nimmt die letzte Änderung zurück, sonst das letzte Schreiben ins Gerät</translation>
    </message>
    <message>
        <source>shows the history of the unit, or its values</source>
        <translation>zeigt den Verlauf des Geräts oder seine Werte</translation>
    </message>
    <message>
        <source>redoes the last edit or write</source>
        <translation>stellt die letzte Änderung oder das letzte Schreiben wieder her</translation>
    </message>
</context>
<context>
    <name>mb::PdfText</name>
    <message>
        <source>page %1 of %2</source>
        <translation>Seite %1 von %2</translation>
    </message>
    <message>
        <source>DEMO, a simulated unit</source>
        <translation>DEMO, ein simuliertes Gerät</translation>
    </message>
</context>
<context>
    <name>mb::PlotBoard</name>
    <message>
        <source>DEMO</source>
        <translation>DEMO</translation>
    </message>
    <message>
        <source>%1 signals, %2 samples/s, %3 of %4 lost</source>
        <translation>%1 Signale, %2 Werte/s, %3 von %4 verloren</translation>
    </message>
    <message>
        <source>ref %1</source>
        <translation>Ref. %1</translation>
    </message>
    <message>
        <source>REPLAY</source>
        <translation>WIEDERGABE</translation>
    </message>
</context>
<context>
    <name>mb::PlotExport</name>
    <message>
        <source>Export plot</source>
        <translation>Kurve exportieren</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>Bild kopieren</translation>
    </message>
    <message>
        <source>Copy numbers</source>
        <translation>Zahlen kopieren</translation>
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
</context>
<context>
    <name>mb::PlotLayoutBook</name>
    <message>
        <source>Save layout</source>
        <translation>Anordnung speichern</translation>
    </message>
    <message>
        <source>Save layout as…</source>
        <translation>Anordnung speichern unter…</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>Begin like this with every %1</source>
        <translation>Bei jedem %1 so beginnen</translation>
    </message>
    <message>
        <source>Begin with the usual for every %1</source>
        <translation>Bei jedem %1 wie üblich beginnen</translation>
    </message>
</context>
<context>
    <name>mb::PlotScrubber</name>
    <message>
        <source>Whole session</source>
        <translation>Ganze Sitzung</translation>
    </message>
    <message>
        <source>The whole session: drag the box or click to scroll back, End returns to the present.
The recording goes on meanwhile.</source>
        <translation>Die ganze Sitzung: Rahmen ziehen oder klicken, um zurückzublättern, Ende führt zurück zur Gegenwart.
Die Aufnahme läuft dabei weiter.</translation>
    </message>
</context>
<context>
    <name>mb::PlotStack</name>
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
        <source>Plot</source>
        <translation>Diagramm</translation>
    </message>
</context>
<context>
    <name>mb::PlotsBar</name>
    <message>
        <source>window %1 ms</source>
        <translation>Fenster %1 ms</translation>
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
        <source>window %1 h</source>
        <translation>Fenster %1 h</translation>
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
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>X-Y</source>
        <translation>X-Y</translation>
    </message>
    <message>
        <source>Spectrum</source>
        <translation>Spektrum</translation>
    </message>
    <message>
        <source>Against time, one signal against another, or amplitude against frequency of what is seen or of A … B</source>
        <translation>Über der Zeit, ein Signal über einem anderen oder Amplitude über Frequenz für das Sichtbare oder A … B</translation>
    </message>
    <message>
        <source>Length of the time axis</source>
        <translation>Länge der Zeitachse</translation>
    </message>
    <message>
        <source>Trigger: stands still at an edge or a level</source>
        <translation>Trigger: steht an einer Flanke oder einem Pegel still</translation>
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
        <source>Keep what is seen as a reference</source>
        <translation>Das Sichtbare als Referenz behalten</translation>
    </message>
    <message>
        <source>Layouts: save, restore, reset</source>
        <translation>Anordnungen: speichern, wiederherstellen, zurücksetzen</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Export</translation>
    </message>
    <message>
        <source>The picture as PNG, SVG or PDF; samples as CSV or MCAP</source>
        <translation>Das Bild als PNG, SVG oder PDF; Werte als CSV oder MCAP</translation>
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
        <source>plot written to %1</source>
        <translation>Kurve geschrieben nach %1</translation>
    </message>
    <message>
        <source>Wheel zooms time, Ctrl+wheel values, Shift+wheel moves · drag moves · Shift+drag zooms into a box
double click or End returns to the present · right click for more</source>
        <translation>Rad zoomt die Zeit, Strg+Rad die Werte, Umschalt+Rad verschiebt · Ziehen verschiebt · Umschalt+Ziehen zoomt in einen Rahmen
Doppelklick oder Ende führt zurück zur Gegenwart · Rechtsklick für mehr</translation>
    </message>
    <message>
        <source>X-Y</source>
        <translation>X-Y</translation>
    </message>
    <message>
        <source>Trigger: stands still at an edge or a level</source>
        <translation>Trigger: steht an einer Flanke oder einem Pegel still</translation>
    </message>
    <message>
        <source>Keep what is seen as a reference</source>
        <translation>Das Sichtbare als Referenz behalten</translation>
    </message>
    <message>
        <source>Remove references</source>
        <translation>Referenzen entfernen</translation>
    </message>
    <message>
        <source>Note at this time…	N</source>
        <translation>Notiz zu diesem Zeitpunkt…	N</translation>
    </message>
    <message>
        <source>Derived signal…</source>
        <translation>Abgeleitetes Signal…</translation>
    </message>
    <message>
        <source>Spectrum of what is seen</source>
        <translation>Spektrum des Sichtbaren</translation>
    </message>
    <message>
        <source>Export samples…</source>
        <translation>Werte exportieren…</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Double click a signal in the list at the right or under a device at the left, or drag it here.</source>
        <translation>Ein Signal rechts in der Liste oder links unter einem Gerät doppelklicken oder hierher ziehen.</translation>
    </message>
    <message>
        <source>pauses the plots, and goes on</source>
        <translation>hält die Kurven an und lässt sie weiterlaufen</translation>
    </message>
    <message>
        <source>fits time and value</source>
        <translation>passt Zeit und Wert ein</translation>
    </message>
    <message>
        <source>cursors: arrows move one, C changes to the other</source>
        <translation>Cursor: Pfeile bewegen einen, C wechselt zum anderen</translation>
    </message>
    <message>
        <source>watches for a trigger, or no more</source>
        <translation>wartet auf einen Trigger oder nicht mehr</translation>
    </message>
    <message>
        <source>records, or ends the recording</source>
        <translation>nimmt auf oder beendet die Aufnahme</translation>
    </message>
    <message>
        <source>in the plots: less or more time</source>
        <translation>in den Kurven: weniger oder mehr Zeit</translation>
    </message>
    <message>
        <source>in the plots: larger or smaller values</source>
        <translation>in den Kurven: größere oder kleinere Werte</translation>
    </message>
    <message>
        <source>in the plots: writes a note at this time</source>
        <translation>in den Kurven: schreibt eine Notiz zu dieser Zeit</translation>
    </message>
</context>
<context>
    <name>mb::Preferences</name>
    <message>
        <source>as the desktop</source>
        <translation>wie der Desktop</translation>
    </message>
    <message>
        <source>Preferences</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>dark</source>
        <translation>dunkel</translation>
    </message>
    <message>
        <source>light</source>
        <translation>hell</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Nothing moves but data</source>
        <translation>Nichts bewegt sich außer Daten</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>Text size</source>
        <translation>Schriftgröße</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>Notebook, recordings</source>
        <translation>Versuchsbuch, Aufnahmen</translation>
    </message>
    <message>
        <source>Settings, layouts</source>
        <translation>Einstellungen, Anordnungen</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Open the folder: %1</source>
        <translation>Den Ordner öffnen: %1</translation>
    </message>
    <message>
        <source>General</source>
        <translation>Allgemein</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>high contrast</source>
        <translation>hoher Kontrast</translation>
    </message>
    <message>
        <source>counts</source>
        <translation>counts</translation>
    </message>
    <message>
        <source>rpm and degrees</source>
        <translation>1/min und Grad</translation>
    </message>
    <message>
        <source>With every verdict in production</source>
        <translation>Zu jedem Urteil in der Fertigung</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>Einheiten</translation>
    </message>
    <message>
        <source>Sounds</source>
        <translation>Töne</translation>
    </message>
    <message>
        <source>Guardian</source>
        <translation>Wächter</translation>
    </message>
</context>
<context>
    <name>mb::ProductionHead</name>
    <message>
        <source>recipe</source>
        <translation>Rezept</translation>
    </message>
    <message>
        <source>image</source>
        <translation>Image</translation>
    </message>
    <message>
        <source>parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>number rule</source>
        <translation>Nummernregel</translation>
    </message>
    <message>
        <source>self-test</source>
        <translation>Selbsttest</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>Verlassen</translation>
    </message>
    <message>
        <source>Link that units are put on</source>
        <translation>Verbindung, an die Geräte kommen</translation>
    </message>
    <message>
        <source>Serial number, scanned or typed</source>
        <translation>Seriennummer, gescannt oder getippt</translation>
    </message>
    <message>
        <source>Scan or type a serial number</source>
        <translation>Seriennummer scannen oder tippen</translation>
    </message>
    <message>
        <source>Open recipe…</source>
        <translation>Rezept öffnen…</translation>
    </message>
    <message>
        <source>Hold to arm self-tests</source>
        <translation>Halten: Selbsttests scharf</translation>
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
        <source>No recipe yet</source>
        <translation>Noch kein Rezept</translation>
    </message>
    <message>
        <source>ARMED, hold to disarm</source>
        <translation>SCHARF, halten: sichern</translation>
    </message>
    <message>
        <source>%1, not open</source>
        <translation>%1, nicht offen</translation>
    </message>
</context>
<context>
    <name>mb::ProductionPage</name>
    <message>
        <source>Production</source>
        <translation>Produktion</translation>
    </message>
    <message>
        <source>Last ten units</source>
        <translation>Letzte zehn Geräte</translation>
    </message>
    <message>
        <source>Sound</source>
        <translation>Ton</translation>
    </message>
    <message>
        <source>Sound with every verdict</source>
        <translation>Ton zu jedem Urteil</translation>
    </message>
    <message>
        <source>tests the last unit again</source>
        <translation>prüft das letzte Gerät noch einmal</translation>
    </message>
    <message>
        <source>sets it aside, ready for the next</source>
        <translation>legt es beiseite, bereit für das nächste</translation>
    </message>
    <message>
        <source>Open recipe</source>
        <translation>Rezept öffnen</translation>
    </message>
    <message>
        <source>Recipes (*.json);;All files (*)</source>
        <translation>Rezepte (*.json);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>The self-test turns the motor: %1</source>
        <translation>Der Selbsttest dreht den Motor: %1</translation>
    </message>
    <message>
        <source>not started: open a link first</source>
        <translation>nicht gestartet: erst eine Verbindung öffnen</translation>
    </message>
    <message>
        <source>not started: open a recipe first</source>
        <translation>nicht gestartet: erst ein Rezept öffnen</translation>
    </message>
    <message>
        <source>no unit here has the serial number %1</source>
        <translation>kein Gerät hier hat die Seriennummer %1</translation>
    </message>
    <message>
        <source>test again</source>
        <translation>erneut prüfen</translation>
    </message>
    <message>
        <source>set aside</source>
        <translation>beiseitelegen</translation>
    </message>
    <message>
        <source>serial number</source>
        <translation>Seriennummer</translation>
    </message>
    <message>
        <source>leave</source>
        <translation>verlassen</translation>
    </message>
    <message>
        <source>stops every motor</source>
        <translation>hält jeden Motor an</translation>
    </message>
    <message>
        <source>not tested again: %1</source>
        <translation>nicht noch einmal geprüft: %1</translation>
    </message>
</context>
<context>
    <name>mb::ProfileFields</name>
    <message>
        <source>Velocity</source>
        <translation>Drehzahl</translation>
    </message>
    <message>
        <source>counts/s</source>
        <translation>counts/s</translation>
    </message>
    <message>
        <source>Velocity of the profile</source>
        <translation>Drehzahl des Profils</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>Beschleunigung</translation>
    </message>
    <message>
        <source>counts/s²</source>
        <translation>counts/s²</translation>
    </message>
    <message>
        <source>Acceleration of the profile</source>
        <translation>Beschleunigung des Profils</translation>
    </message>
    <message>
        <source>The profile needs a velocity up to %1 counts/s.</source>
        <translation>Das Profil braucht eine Drehzahl bis %1 counts/s.</translation>
    </message>
    <message>
        <source>The profile needs an acceleration up to %1 counts/s²; 0 is none.</source>
        <translation>Das Profil braucht eine Beschleunigung bis %1 counts/s²; 0 ist keine.</translation>
    </message>
</context>
<context>
    <name>mb::ProfilePanel</name>
    <message>
        <source>What only you know</source>
        <translation>Was nur Sie wissen</translation>
    </message>
    <message>
        <source>Dialect</source>
        <translation>Dialekt</translation>
    </message>
    <message>
        <source>How this unit is spoken to. The scan finds it out; choose another only if you know better.</source>
        <translation>Wie dieses Gerät angesprochen wird. Die Suche stellt es fest; nur bei besserem Wissen einen anderen wählen.</translation>
    </message>
    <message>
        <source>dialect as found</source>
        <translation>Dialekt wie gefunden</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>Speak another dialect?</source>
        <translation>Anderen Dialekt verwenden?</translation>
    </message>
    <message>
        <source>Speak to this unit as %1?</source>
        <translation>Dieses Gerät als %1 ansprechen?</translation>
    </message>
    <message>
        <source>Speak it</source>
        <translation>Verwenden</translation>
    </message>
    <message>
        <source>dialect as found: %1</source>
        <translation>Dialekt wie gefunden: %1</translation>
    </message>
</context>
<context>
    <name>mb::ProgrammerBox</name>
    <message>
        <source>Programmer</source>
        <translation>Programmiergerät</translation>
    </message>
    <message>
        <source>What writes the flash: one of the list, or the name that the program gives to another</source>
        <translation>Was den Flash schreibt: eines aus der Liste oder der Name, den das Programm einem anderen gibt</translation>
    </message>
    <message>
        <source>Port of the programmer</source>
        <translation>Anschluss des Programmiergeräts</translation>
    </message>
    <message>
        <source>Where the programmer, or the line to the bootloader, is plugged in</source>
        <translation>Wo das Programmiergerät oder die Leitung zum Bootloader angesteckt ist</translation>
    </message>
    <message>
        <source>at</source>
        <translation>an</translation>
    </message>
    <message>
        <source>the device&apos;s own line</source>
        <translation>die eigene Leitung des Geräts</translation>
    </message>
    <message>
        <source>at USB</source>
        <translation>an USB</translation>
    </message>
    <message>
        <source>Choose a programmer</source>
        <translation>Programmiergerät wählen</translation>
    </message>
    <message>
        <source>No serial port is plugged in; choose or name the one of the programmer</source>
        <translation>Keine serielle Schnittstelle ist angesteckt; die des Programmiergeräts wählen oder nennen</translation>
    </message>
</context>
<context>
    <name>mb::ProjectDesk</name>
    <message>
        <source>Save the machine into a folder</source>
        <translation>Maschine in einen Ordner sichern</translation>
    </message>
    <message>
        <source>Open the folder of a machine</source>
        <translation>Ordner einer Maschine öffnen</translation>
    </message>
    <message numerus="yes">
        <source>%n unit(s) saved into %1</source>
        <translation>
            <numerusform>%n Gerät nach %1 gesichert</numerusform>
            <numerusform>%n Geräte nach %1 gesichert</numerusform>
        </translation>
    </message>
    <message>
        <source>scales and limits of the project are in force</source>
        <translation>Skalen und Grenzen des Projekts gelten</translation>
    </message>
    <message>
        <source>dialect %1 of the folder is not in force: choose it in the inspector if that is what it speaks</source>
        <translation>Dialekt %1 aus dem Ordner gilt nicht: im Inspektor wählen, wenn das Gerät ihn spricht</translation>
    </message>
</context>
<context>
    <name>mb::ProposalCard</name>
    <message>
        <source>quiet, forgiving</source>
        <translation>ruhig, verzeihend</translation>
    </message>
    <message>
        <source>fastest rise</source>
        <translation>schnellster Anstieg</translation>
    </message>
    <message>
        <source>Ms</source>
        <translation>Ms</translation>
    </message>
    <message>
        <source>calm</source>
        <translation>ruhig</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>normal</translation>
    </message>
    <message>
        <source>brisk</source>
        <translation>flott</translation>
    </message>
    <message>
        <source>τc %1</source>
        <translation>τc %1</translation>
    </message>
    <message>
        <source>raw %1</source>
        <translation>roh %1</translation>
    </message>
    <message>
        <source>Proposal: %1</source>
        <translation>Vorschlag: %1</translation>
    </message>
    <message>
        <source>hardly overshoots</source>
        <translation>schwingt kaum über</translation>
    </message>
    <message>
        <source>%1 = 0</source>
        <translation>%1 = 0</translation>
    </message>
    <message>
        <source>over</source>
        <translation>über</translation>
    </message>
    <message>
        <source>settle</source>
        <translation>Ausregelzeit</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>GM</source>
        <translation>GM</translation>
    </message>
    <message>
        <source>dB</source>
        <translation>dB</translation>
    </message>
    <message>
        <source>PM</source>
        <translation>PM</translation>
    </message>
    <message>
        <source>peak</source>
        <translation>Spitze</translation>
    </message>
    <message>
        <source>A</source>
        <translation>A</translation>
    </message>
</context>
<context>
    <name>mb::ProposalList</name>
    <message>
        <source>own</source>
        <translation>eigener</translation>
    </message>
    <message>
        <source>Proposals</source>
        <translation>Vorschläge</translation>
    </message>
    <message>
        <source>to be found anew</source>
        <translation>werden neu gesucht</translation>
    </message>
</context>
<context>
    <name>mb::QueueBar</name>
    <message>
        <source>State of the queue</source>
        <translation>Stand der Warteschlange</translation>
    </message>
    <message>
        <source>Progress of the queue</source>
        <translation>Fortschritt der Warteschlange</translation>
    </message>
    <message>
        <source>Pause after this unit</source>
        <translation>Danach anhalten</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Fortfahren</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Retry failed</source>
        <translation>Fehler wiederholen</translation>
    </message>
    <message>
        <source>Save CSV…</source>
        <translation>CSV speichern…</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Ended before its time: %1</source>
        <translation>Vorzeitig beendet: %1</translation>
    </message>
    <message>
        <source>Pauses after this unit</source>
        <translation>Hält nach diesem Gerät an</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>Angehalten</translation>
    </message>
    <message>
        <source>Unit %1 of %2</source>
        <translation>Gerät %1 von %2</translation>
    </message>
    <message numerus="yes">
        <source>Ended with %n unit(s) to go</source>
        <translation>
            <numerusform>Beendet, %n Gerät steht noch aus</numerusform>
            <numerusform>Beendet, %n Geräte stehen noch aus</numerusform>
        </translation>
    </message>
    <message>
        <source>Ended: %1 of %2 units</source>
        <translation>Beendet: %1 von %2 Geräten</translation>
    </message>
    <message>
        <source>Nothing running</source>
        <translation>Nichts läuft</translation>
    </message>
    <message>
        <source>about %1 s left</source>
        <translation>noch etwa %1 s</translation>
    </message>
    <message>
        <source>%1 done</source>
        <translation>%1 fertig</translation>
    </message>
    <message>
        <source>%1 waiting</source>
        <translation>%1 warten</translation>
    </message>
    <message>
        <source>%1 failed</source>
        <translation>%1 mit Fehler</translation>
    </message>
    <message>
        <source>%1 refused</source>
        <translation>%1 abgelehnt</translation>
    </message>
    <message>
        <source>mean %1</source>
        <translation>Mittel %1</translation>
    </message>
</context>
<context>
    <name>mb::QueueBoard</name>
    <message>
        <source>Go on with it</source>
        <translation>Fortsetzen</translation>
    </message>
    <message>
        <source>A queue runs already.</source>
        <translation>Eine Warteschlange läuft schon.</translation>
    </message>
    <message>
        <source>Open an image or a recipe first.</source>
        <translation>Zuerst ein Abbild oder ein Rezept öffnen.</translation>
    </message>
    <message>
        <source>Tick the units first.</source>
        <translation>Zuerst die Geräte ankreuzen.</translation>
    </message>
    <message>
        <source>Save what was done</source>
        <translation>Speichern, was getan wurde</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tabelle (*.csv)</translation>
    </message>
    <message>
        <source>the units are in %1</source>
        <translation>die Geräte sind in %1</translation>
    </message>
    <message>
        <source>The last queue of this recipe was cut off: %1 done, %2 open</source>
        <translation>Die letzte Warteschlange dieses Rezepts wurde unterbrochen: %1 fertig, %2 offen</translation>
    </message>
    <message>
        <source>What has ended stays as it is; ticked units are taken along.</source>
        <translation>Was beendet ist, bleibt so; angekreuzte Geräte werden mitgenommen.</translation>
    </message>
    <message>
        <source>One unit at a time on a bus, buses side by side. Real units keep this computer awake. The journal is on disk: after a crash the queue goes on.</source>
        <translation>Auf einem Bus ein Gerät nach dem anderen, Busse nebeneinander. Echte Geräte halten diesen Rechner wach. Das Journal liegt auf der Platte: nach einem Absturz geht es weiter.</translation>
    </message>
    <message>
        <source>Every unit is backed up before and compared afterwards; the journal has it.</source>
        <translation>Jedes Gerät wird vorher gesichert und danach verglichen; das Journal hält es fest.</translation>
    </message>
    <message>
        <source>not tried again: %1</source>
        <translation>nicht noch einmal versucht: %1</translation>
    </message>
    <message>
        <source>not tried again: it was served by %1; tick it and start</source>
        <translation>nicht noch einmal versucht: es wurde nach %1 bedient; ankreuzen und starten</translation>
    </message>
    <message>
        <source>%1 waits until this queue has ended</source>
        <translation>%1 wartet, bis diese Warteschlange zu Ende ist</translation>
    </message>
</context>
<context>
    <name>mb::QueueChecks</name>
    <message>
        <source>recipe checked</source>
        <translation>Rezept geprüft</translation>
    </message>
    <message>
        <source>no image, no recipe</source>
        <translation>kein Abbild, kein Rezept</translation>
    </message>
    <message>
        <source>all motors stopped</source>
        <translation>alle Motoren stehen</translation>
    </message>
    <message>
        <source>a motor is moving</source>
        <translation>ein Motor dreht sich</translation>
    </message>
    <message>
        <source>no other master</source>
        <translation>kein anderer Master</translation>
    </message>
    <message>
        <source>another master, or a number taken twice</source>
        <translation>anderer Master oder doppelte Nummer</translation>
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
        <source>Before start</source>
        <translation>Vor dem Start</translation>
    </message>
</context>
<context>
    <name>mb::QueueHead</name>
    <message>
        <source>recipe</source>
        <translation>Rezept</translation>
    </message>
    <message>
        <source>image</source>
        <translation>Image</translation>
    </message>
    <message>
        <source>parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>number rule</source>
        <translation>Nummernregel</translation>
    </message>
    <message>
        <source>Open image…</source>
        <translation>Image öffnen…</translation>
    </message>
    <message>
        <source>Open recipe…</source>
        <translation>Rezept öffnen…</translation>
    </message>
    <message>
        <source>none yet</source>
        <translation>noch keines</translation>
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
        <source>Open recipe</source>
        <translation>Rezept öffnen</translation>
    </message>
    <message>
        <source>Recipes (*.json);;All files (*)</source>
        <translation>Rezepte (*.json);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Write a recipe</source>
        <translation>Rezept schreiben</translation>
    </message>
</context>
<context>
    <name>mb::QueueModel</name>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>serial number</source>
        <translation>Seriennummer</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>firmware</source>
        <translation>Firmware</translation>
    </message>
    <message>
        <source>step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>result</source>
        <translation>Ergebnis</translation>
    </message>
</context>
<context>
    <name>mb::QueueSide</name>
    <message>
        <source>The self-test turns the motor: %1. Hold Arm in the header once the queue runs.</source>
        <translation>Der Selbsttest dreht den Motor: %1. Die Scharf-Taste in der Kopfzeile halten, sobald die Warteschlange läuft.</translation>
    </message>
</context>
<context>
    <name>mb::QueueTable</name>
    <message>
        <source>Every unit of this family</source>
        <translation>Jedes Gerät dieser Familie</translation>
    </message>
    <message>
        <source>Units of the queue</source>
        <translation>Einheiten der Warteschlange</translation>
    </message>
    <message>
        <source>Every %1</source>
        <translation>Jeder %1</translation>
    </message>
</context>
<context>
    <name>mb::QueueText</name>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>verified</source>
        <translation>geprüft</translation>
    </message>
    <message>
        <source>%1 parameters equal</source>
        <translation>%1 Parameter gleich</translation>
    </message>
    <message>
        <source>already %1</source>
        <translation>schon %1</translation>
    </message>
    <message>
        <source>read back after the restart</source>
        <translation>nach dem Neustart zurückgelesen</translation>
    </message>
    <message>
        <source>safe to unplug, resumes</source>
        <translation>darf abgezogen werden, setzt fort</translation>
    </message>
    <message>
        <source>do not unplug</source>
        <translation>nicht abziehen</translation>
    </message>
    <message>
        <source>waiting</source>
        <translation>wartet</translation>
    </message>
    <message>
        <source>cut off, goes on</source>
        <translation>unterbrochen, geht weiter</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>ausgelassen</translation>
    </message>
    <message>
        <source>cut off</source>
        <translation>unterbrochen</translation>
    </message>
    <message>
        <source>failed: %1</source>
        <translation>Fehler: %1</translation>
    </message>
    <message>
        <source>refused before start</source>
        <translation>vor dem Start abgelehnt</translation>
    </message>
    <message>
        <source>number taken twice</source>
        <translation>Nummer doppelt vergeben</translation>
    </message>
    <message>
        <source>in its bootloader</source>
        <translation>im Bootloader</translation>
    </message>
    <message>
        <source>motor is moving</source>
        <translation>Motor dreht sich</translation>
    </message>
    <message>
        <source>another master drives it</source>
        <translation>ein anderer Master steuert sie</translation>
    </message>
    <message>
        <source>Preflight</source>
        <translation>Vorprüfung</translation>
    </message>
    <message>
        <source>Backup</source>
        <translation>Sicherung</translation>
    </message>
    <message>
        <source>Firmware</source>
        <translation>Firmware</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Self-test</source>
        <translation>Selbsttest</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Nummer</translation>
    </message>
    <message>
        <source>Comparison and proof</source>
        <translation>Vergleich und Nachweis</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>hold Arm in the header</source>
        <translation>Scharf-Taste in der Kopfzeile halten</translation>
    </message>
    <message>
        <source>written, not proved</source>
        <translation>geschrieben, nicht bewiesen</translation>
    </message>
    <message>
        <source>answers with %1, as before</source>
        <translation>antwortet mit %1, wie zuvor</translation>
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
        <source>%1 more.</source>
        <translation>%1 weitere.</translation>
    </message>
    <message>
        <source>The device should have stored by itself. Its own proof takes up to %1 s.</source>
        <translation>Das Gerät sollte selbst gespeichert haben. Der Nachweis dauert bis zu %1 s.</translation>
    </message>
</context>
<context>
    <name>mb::ReadStatus</name>
    <message>
        <source>Reading</source>
        <translation>Lesen</translation>
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
    <message>
        <source>%1, values for %2 from a file</source>
        <translation>%1, Werte für %2 aus einer Datei</translation>
    </message>
</context>
<context>
    <name>mb::RecipeEditor</name>
    <message>
        <source>New recipe</source>
        <translation>Neues Rezept</translation>
    </message>
    <message>
        <source>Fields of the recipe</source>
        <translation>Felder des Rezepts</translation>
    </message>
    <message>
        <source>The file that is saved, line by line</source>
        <translation>Die Datei, die gespeichert wird, Zeile für Zeile</translation>
    </message>
    <message>
        <source>What is wrong with the recipe</source>
        <translation>Was am Rezept falsch ist</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Save recipe</source>
        <translation>Rezept speichern</translation>
    </message>
    <message>
        <source>Recipe %1</source>
        <translation>Rezept %1</translation>
    </message>
    <message>
        <source>Keep the recipe</source>
        <translation>Rezept ablegen</translation>
    </message>
    <message>
        <source>Recipes (*.json)</source>
        <translation>Rezepte (*.json)</translation>
    </message>
    <message>
        <source>This recipe is not saved.</source>
        <translation>Dieses Rezept ist nicht gespeichert.</translation>
    </message>
    <message>
        <source>Discard it</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Go on writing</source>
        <translation>Weiterschreiben</translation>
    </message>
    <message>
        <source>No mistake in the recipe</source>
        <translation>Kein Fehler im Rezept</translation>
    </message>
    <message>
        <source>Give the recipe a name.</source>
        <translation>Dem Rezept einen Namen geben.</translation>
    </message>
</context>
<context>
    <name>mb::RecipeForm</name>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Family</source>
        <translation>Familie</translation>
    </message>
    <message>
        <source>Firmware file</source>
        <translation>Firmware-Datei</translation>
    </message>
    <message>
        <source>Other way in</source>
        <translation>Anderer Zugang</translation>
    </message>
    <message>
        <source>Parameter file</source>
        <translation>Parameterdatei</translation>
    </message>
    <message>
        <source>Save them where the unit does not by itself</source>
        <translation>Speichern, wo das Gerät es nicht selbst tut</translation>
    </message>
    <message>
        <source>First number to give</source>
        <translation>Erste zu vergebende Nummer</translation>
    </message>
    <message>
        <source>Self-test: the motor turns</source>
        <translation>Selbsttest: der Motor dreht</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>Regelkreis</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Bis</translation>
    </message>
    <message>
        <source>Time, s</source>
        <translation>Zeit, s</translation>
    </message>
    <message>
        <source>Repeats</source>
        <translation>Wiederholungen</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>Gain slot</source>
        <translation>Slot der Verstärkungen</translation>
    </message>
    <message>
        <source>Travel at most, counts</source>
        <translation>Weg höchstens, counts</translation>
    </message>
    <message>
        <source>Speed at most, counts/s</source>
        <translation>Drehzahl höchstens, counts/s</translation>
    </message>
    <message>
        <source>Current at most, A</source>
        <translation>Strom höchstens, A</translation>
    </message>
    <message>
        <source>Duty at most, 0 to 1</source>
        <translation>Tastgrad höchstens, 0 bis 1</translation>
    </message>
    <message>
        <source>What the self-test accepts</source>
        <translation>Was der Selbsttest annimmt</translation>
    </message>
    <message>
        <source>Accepted</source>
        <translation>Angenommen</translation>
    </message>
    <message>
        <source>Least</source>
        <translation>Mindestens</translation>
    </message>
    <message>
        <source>Greatest</source>
        <translation>Höchstens</translation>
    </message>
    <message>
        <source>counts both ways</source>
        <translation>zählt in beide Richtungen</translation>
    </message>
    <message>
        <source>Choose: %1</source>
        <translation>Wählen: %1</translation>
    </message>
    <message>
        <source>none: over its own link</source>
        <translation>keiner: über die eigene Verbindung</translation>
    </message>
    <message>
        <source>such as %1</source>
        <translation>etwa %1</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>field, unit</comment>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>0 to 1</source>
        <translation>0 bis 1</translation>
    </message>
</context>
<context>
    <name>mb::RecipeText</name>
    <message>
        <source>%1 · sha %2</source>
        <translation>%1 · sha %2</translation>
    </message>
    <message>
        <source>%1 · version %2 · sha %3</source>
        <translation>%1 · Version %2 · sha %3</translation>
    </message>
    <message>
        <source>%1 · %2 values</source>
        <translation>%1 · %2 Werte</translation>
    </message>
    <message>
        <source>next free from %1</source>
        <translation>nächste freie ab %1</translation>
    </message>
</context>
<context>
    <name>mb::RecordStrip</name>
    <message>
        <source>Record…</source>
        <translation>Aufnehmen…</translation>
    </message>
    <message>
        <source>End recording</source>
        <translation>Aufn. beenden</translation>
    </message>
    <message>
        <source>Writes every frame of this link to a candump log or a Vector ASC file</source>
        <translation>Schreibt jeden Frame dieser Verbindung in ein candump-Protokoll oder eine Vector-ASC-Datei</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Record the frames of %1</source>
        <translation>Frames von %1 aufnehmen</translation>
    </message>
    <message>
        <source>Vector ASC log (*.asc)</source>
        <translation>Vector-ASC-Protokoll (*.asc)</translation>
    </message>
    <message>
        <source>candump log (*.log)</source>
        <translation>candump-Protokoll (*.log)</translation>
    </message>
    <message>
        <source>nothing is recorded: %1</source>
        <translation>nichts wird aufgenommen: %1</translation>
    </message>
    <message>
        <source>The recording has ended: %1. %2 frames are missing in it.</source>
        <translation>Die Aufnahme ist beendet: %1. %2 Frames fehlen darin.</translation>
    </message>
    <message>
        <source>Recording  %1   %2 frames   %3   %4 lost   %5</source>
        <translation>Aufnahme  %1   %2 Frames   %3   %4 verloren   %5</translation>
    </message>
</context>
<context>
    <name>mb::Recorder</name>
    <message>
        <source>The last session did not end by itself. What it recorded is in %1.</source>
        <translation>Die letzte Sitzung wurde nicht regulär beendet. Ihre Aufnahme liegt in %1.</translation>
    </message>
    <message>
        <source>Samples are recorded on disk again, those of the meantime too.</source>
        <translation>Messwerte werden wieder auf die Platte geschrieben, auch die der Zwischenzeit.</translation>
    </message>
    <message>
        <source>Samples are not recorded on disk: %1</source>
        <translation>Messwerte werden nicht auf die Platte geschrieben: %1</translation>
    </message>
    <message>
        <source>What the last session recorded waits for the next start: %1</source>
        <translation>Was die letzte Sitzung aufgezeichnet hat, wartet auf den nächsten Start: %1</translation>
    </message>
</context>
<context>
    <name>mb::RecordingControl</name>
    <message>
        <source>Record</source>
        <translation>Aufnehmen</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Keeps everything that devices send, beginning with the last %1.
What was recorded lately is on disk all the time and outlives a crash.</source>
        <translation>Behält alles, was Geräte senden, beginnend mit den letzten %1.
Das zuletzt Aufgenommene liegt stets auf der Festplatte und übersteht einen Absturz.</translation>
    </message>
    <message>
        <source>recording written to %1</source>
        <translation>Aufnahme geschrieben nach %1</translation>
    </message>
    <message>
        <source>not recorded: %1</source>
        <translation>nicht aufgenommen: %1</translation>
    </message>
    <message>
        <source>%1 · %2 · %3 samples</source>
        <translation>%1 · %2 · %3 Werte</translation>
    </message>
    <message>
        <source>last %1 on disk · %2</source>
        <translation>letzte %1 auf Festplatte · %2</translation>
    </message>
</context>
<context>
    <name>mb::ReplayBar</name>
    <message>
        <source>Recording that is played</source>
        <translation>Aufnahme, die abgespielt wird</translation>
    </message>
    <message>
        <source>REPLAY</source>
        <translation>WIEDERGABE</translation>
    </message>
    <message>
        <source>Shows what was recorded. Nothing is sent, no motor moves.</source>
        <translation>Zeigt, was aufgenommen wurde. Nichts wird gesendet, kein Motor bewegt sich.</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Play again</source>
        <translation>Erneut abspielen</translation>
    </message>
    <message>
        <source>Plays the recording from where it stands, or halts it there</source>
        <translation>Spielt die Aufnahme ab der aktuellen Stelle ab oder hält sie dort an</translation>
    </message>
    <message>
        <source>Speed of the replay</source>
        <translation>Geschwindigkeit der Wiedergabe</translation>
    </message>
    <message>
        <source>How fast the recording is played</source>
        <translation>Wie schnell die Aufnahme abgespielt wird</translation>
    </message>
    <message>
        <source>as fast as possible</source>
        <translation>so schnell wie möglich</translation>
    </message>
    <message>
        <source>Position in the recording</source>
        <translation>Stelle in der Aufnahme</translation>
    </message>
    <message>
        <source>Where the recording stands; arrow keys move it by 1 s, Page Up and Page Down by 10 s</source>
        <translation>Wo die Aufnahme steht; Pfeiltasten verschieben um 1 s, Bild auf und Bild ab um 10 s</translation>
    </message>
    <message>
        <source>%1: looking through it, %2 %</source>
        <translation>%1: wird durchgesehen, %2 %</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>recorded %1</source>
        <translation>aufgenommen %1</translation>
    </message>
</context>
<context>
    <name>mb::ReportOrder</name>
    <message>
        <source>Write report</source>
        <translation>Bericht schreiben</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>HTML (*.html)</source>
        <translation>HTML (*.html)</translation>
    </message>
    <message>
        <source>the report is in %1</source>
        <translation>der Bericht steht in %1</translation>
    </message>
    <message>
        <source>no report: %1</source>
        <translation>kein Bericht: %1</translation>
    </message>
</context>
<context>
    <name>mb::ReportText</name>
    <message>
        <source>Rise, 10 to 90 %</source>
        <translation>Anstieg, 10 bis 90 %</translation>
    </message>
    <message>
        <source>Settling to 2 %</source>
        <translation>Ausregelzeit auf 2 %</translation>
    </message>
    <message>
        <source>Overshoot</source>
        <translation>Überschwingen</translation>
    </message>
    <message>
        <source>Undershoot of the way back</source>
        <translation>Unterschwingen des Rückwegs</translation>
    </message>
    <message>
        <source>Error at rest</source>
        <translation>Bleibende Abweichung</translation>
    </message>
    <message>
        <source>IAE</source>
        <translation>IAE</translation>
    </message>
    <message>
        <source>ITAE</source>
        <translation>ITAE</translation>
    </message>
    <message>
        <source>Peak current</source>
        <translation>Stromspitze</translation>
    </message>
    <message>
        <source>Chatter of the duty, RMS</source>
        <translation>Unruhe des Tastgrads, effektiv</translation>
    </message>
    <message>
        <source>Time at the duty limit</source>
        <translation>Zeit an der Tastgradgrenze</translation>
    </message>
    <message>
        <source>Noise of the measurement</source>
        <translation>Rauschen der Messung</translation>
    </message>
    <message>
        <source>step</source>
        <translation>Sprung</translation>
    </message>
    <message>
        <source>square wave</source>
        <translation>Rechteck</translation>
    </message>
    <message>
        <source>ramp</source>
        <translation>Rampe</translation>
    </message>
    <message>
        <source>sine</source>
        <translation>Sinus</translation>
    </message>
    <message>
        <source>chirp</source>
        <translation>Chirp</translation>
    </message>
    <message>
        <source>random steps</source>
        <translation>Zufallssprünge</translation>
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
        <source>duty</source>
        <translation>Tastgrad</translation>
    </message>
    <message>
        <source>%1 times</source>
        <translation>%1-mal</translation>
    </message>
    <message>
        <source>done</source>
        <translation>fertig</translation>
    </message>
    <message>
        <source>cut off</source>
        <translation>abgeschnitten</translation>
    </message>
    <message>
        <source>interrupted</source>
        <translation>abgebrochen</translation>
    </message>
    <message>
        <source>stopped by the guard “%1”</source>
        <translation>gestoppt von der Überwachung „%1“</translation>
    </message>
    <message>
        <source>DEMO: this unit is simulated. Nothing here was measured on a motor.</source>
        <translation>DEMO: Dieses Gerät ist simuliert. Nichts hiervon wurde an einem Motor gemessen.</translation>
    </message>
    <message>
        <source>Report on %1</source>
        <translation>Bericht über %1</translation>
    </message>
    <message>
        <source>Made on %1 with %2</source>
        <translation>Erstellt am %1 mit %2</translation>
    </message>
    <message>
        <source>There are no trials of this unit in the notebook.</source>
        <translation>Im Versuchsbuch stehen keine Versuche dieses Geräts.</translation>
    </message>
    <message>
        <source>s since the edge</source>
        <translation>s seit der Flanke</translation>
    </message>
    <message>
        <source>Trial %1: %2</source>
        <translation>Versuch %1: %2</translation>
    </message>
    <message>
        <source>target</source>
        <translation>Sollwert</translation>
    </message>
    <message>
        <source>%1, measured</source>
        <translation>%1, gemessen</translation>
    </message>
    <message>
        <source>duty, %</source>
        <translation>Tastgrad, %</translation>
    </message>
    <message>
        <source>Metric</source>
        <translation>Kennwert</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>Verstärkung</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>Vorgabe</translation>
    </message>
    <message>
        <source>Parameters of this set that have their default: %1</source>
        <translation>Parameter dieses Satzes mit ihrer Vorgabe: %1</translation>
    </message>
    <message>
        <source>travel ± %1</source>
        <translation>Weg ± %1</translation>
    </message>
    <message>
        <source>speed %1</source>
        <translation>Drehzahl %1</translation>
    </message>
    <message>
        <source>current %1</source>
        <translation>Strom %1</translation>
    </message>
    <message>
        <source>duty %1</source>
        <translation>Tastgrad %1</translation>
    </message>
    <message>
        <source>Trial %1, %2 loop</source>
        <translation>Versuch %1, Regelkreis %2</translation>
    </message>
    <message>
        <source>Trial %1, open loop</source>
        <translation>Versuch %1, offener Kreis</translation>
    </message>
    <message>
        <source>axis %1</source>
        <translation>Achse %1</translation>
    </message>
    <message>
        <source>gain slot %1</source>
        <translation>Slot %1</translation>
    </message>
    <message>
        <source>firmware %1</source>
        <translation>Firmware %1</translation>
    </message>
    <message>
        <source>motor seen stopped</source>
        <translation>Motor stand nachweislich</translation>
    </message>
    <message>
        <source>stop not confirmed</source>
        <translation>Stopp nicht bestätigt</translation>
    </message>
    <message>
        <source>%1 samples, %2 lost</source>
        <translation>%1 Messwerte, %2 verloren</translation>
    </message>
    <message>
        <source>Nothing was recorded.</source>
        <translation>Nichts wurde aufgezeichnet.</translation>
    </message>
    <message>
        <source>It ran within: %1.</source>
        <translation>Er lief innerhalb von: %1.</translation>
    </message>
    <message>
        <source>Note: %1</source>
        <translation>Notiz: %1</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>Kreis</translation>
    </message>
    <message>
        <source>Stimulus</source>
        <translation>Anregung</translation>
    </message>
    <message>
        <source>Rise</source>
        <translation>Anstieg</translation>
    </message>
    <message>
        <source>Settling</source>
        <translation>Ausregelzeit</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>History of the unit</source>
        <translation>Verlauf des Geräts</translation>
    </message>
    <message>
        <source>The newest %1 of %2 trials.</source>
        <translation>Die neuesten %1 von %2 Versuchen.</translation>
    </message>
    <message>
        <source>Kept</source>
        <translation>Behalten</translation>
    </message>
    <message>
        <source>Proposed, nothing was written</source>
        <translation>Vorgeschlagen, nichts wurde geschrieben</translation>
    </message>
    <message>
        <source>Put back</source>
        <translation>Zurückgestellt</translation>
    </message>
    <message>
        <source>Refused</source>
        <translation>Abgelehnt</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Gestoppt</translation>
    </message>
    <message>
        <source>none, as fresh as the position</source>
        <translation>keines, so frisch wie die Position</translation>
    </message>
    <message>
        <source>rolling, %1</source>
        <translation>gleitend, %1</translation>
    </message>
    <message>
        <source>in blocks, %1</source>
        <translation>blockweise, %1</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Gain K</source>
        <translation>Verstärkung K</translation>
    </message>
    <message>
        <source>Lag τ</source>
        <translation>Verzögerung τ</translation>
    </message>
    <message>
        <source>Friction kS</source>
        <translation>Reibung kS</translation>
    </message>
    <message>
        <source>% duty</source>
        <translation>% Tastgrad</translation>
    </message>
    <message>
        <source>Velocity filter of the device: %1</source>
        <translation>Drehzahlfilter des Geräts: %1</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>bestanden</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>nicht bestanden</translation>
    </message>
    <message>
        <source>What the model was judged by:</source>
        <translation>Wonach das Modell beurteilt wurde:</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Vorher</translation>
    </message>
    <message>
        <source>Proposed</source>
        <translation>Vorschlag</translation>
    </message>
    <message>
        <source>Raw</source>
        <translation>Roh</translation>
    </message>
    <message>
        <source>Proof</source>
        <translation>Nachweis</translation>
    </message>
    <message>
        <source>Predicted</source>
        <translation>Vorhergesagt</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Gemessen</translation>
    </message>
    <message>
        <source>Sensitivity peak Ms</source>
        <translation>Empfindlichkeitsspitze Ms</translation>
    </message>
    <message>
        <source>Gain margin</source>
        <translation>Amplitudenreserve</translation>
    </message>
    <message>
        <source>Phase margin</source>
        <translation>Phasenreserve</translation>
    </message>
    <message>
        <source>forwards</source>
        <translation>vorwärts</translation>
    </message>
    <message>
        <source>backwards</source>
        <translation>rückwärts</translation>
    </message>
    <message>
        <source>predicted</source>
        <translation>vorhergesagt</translation>
    </message>
    <message>
        <source>The step of the proof, predicted and measured</source>
        <translation>Der Sprung des Nachweises, vorhergesagt und gemessen</translation>
    </message>
    <message>
        <source>Magnitude and phase of the open loop</source>
        <translation>Betrag und Phase des offenen Kreises</translation>
    </message>
    <message>
        <source>magnitude of the loop, dB</source>
        <translation>Betrag des Kreises, dB</translation>
    </message>
    <message>
        <source>phase of the loop, °</source>
        <translation>Phase des Kreises, °</translation>
    </message>
    <message>
        <source>Tuning of the %1 loop</source>
        <translation>Abstimmung des Regelkreises: %1</translation>
    </message>
    <message>
        <source>trials %1</source>
        <translation>Versuche %1</translation>
    </message>
    <message>
        <source>Family</source>
        <translation>Familie</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation>Seriennummer</translation>
    </message>
    <message>
        <source>Connected at</source>
        <translation>Angeschlossen an</translation>
    </message>
    <message>
        <source>Firmware</source>
        <translation>Firmware</translation>
    </message>
    <message>
        <source>Bootloader</source>
        <translation>Bootloader</translation>
    </message>
    <message>
        <source>Dialect</source>
        <translation>Dialekt</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>%1 of %2 differ from their default and are set in bold.</source>
        <translation>%1 von %2 weichen von ihrer Vorgabe ab und sind fett gesetzt.</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>Etiketten</translation>
    </message>
    <message>
        <source>simulated</source>
        <translation>simuliert</translation>
    </message>
    <message>
        <source>Firmware %1</source>
        <translation>Firmware %1</translation>
    </message>
    <message>
        <source>Resistance R, Ω</source>
        <translation>Widerstand R, Ω</translation>
    </message>
    <message>
        <source>Friction, V</source>
        <translation>Reibung, V</translation>
    </message>
    <message>
        <source>Gain 1/Ke, counts/s per V</source>
        <translation>Verstärkung 1/Ke, counts/s je V</translation>
    </message>
    <message>
        <source>Encoder counts both ways</source>
        <translation>Encoder zählt in beide Richtungen</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>Self-test</source>
        <translation>Selbsttest</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Grenzen</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Änderung</translation>
    </message>
    <message>
        <source>%1 since %2</source>
        <translation>%1 seit %2</translation>
    </message>
    <message>
        <source>PASS</source>
        <translation>BESTANDEN</translation>
    </message>
    <message>
        <source>FAIL</source>
        <translation>NICHT BESTANDEN</translation>
    </message>
    <message>
        <source>Not finished</source>
        <translation>Nicht beendet</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Recipe</source>
        <translation>Rezept</translation>
    </message>
    <message>
        <source>Served</source>
        <translation>Bearbeitet</translation>
    </message>
    <message>
        <source>Number given</source>
        <translation>Vergebene Nummer</translation>
    </message>
    <message>
        <source>Parameters of the recipe</source>
        <translation>Parameter des Rezepts</translation>
    </message>
    <message numerus="yes">
        <source>%n in the unit, read back</source>
        <translation>
            <numerusform>%n im Gerät, zurückgelesen</numerusform>
            <numerusform>%n im Gerät, zurückgelesen</numerusform>
        </translation>
    </message>
    <message>
        <source>Service</source>
        <translation>Service</translation>
    </message>
    <message>
        <source>Cause or note</source>
        <translation>Ursache oder Notiz</translation>
    </message>
    <message>
        <source>Every service of this unit</source>
        <translation>Jeder Service dieses Geräts</translation>
    </message>
    <message>
        <source>Service card of %1</source>
        <translation>Servicekarte von %1</translation>
    </message>
    <message>
        <source>Parameters that differ from their default</source>
        <translation>Parameter, die von ihrer Vorgabe abweichen</translation>
    </message>
    <message>
        <source>The first %1 of %2.</source>
        <translation>Die ersten %1 von %2.</translation>
    </message>
    <message>
        <source>Counts/s per duty</source>
        <translation>Counts/s je Tastgrad</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>Phase</translation>
    </message>
    <message>
        <source>Coherence</source>
        <translation>Kohärenz</translation>
    </message>
    <message>
        <source>Believed</source>
        <translation>Geglaubt</translation>
    </message>
    <message>
        <source>magnitude of the motor, dB</source>
        <translation>Betrag des Motors, dB</translation>
    </message>
    <message>
        <source>phase of the motor, °</source>
        <translation>Phase des Motors, °</translation>
    </message>
    <message>
        <source>model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>gemessen</translation>
    </message>
    <message>
        <source>Magnitude and phase of the motor, measured and of its model</source>
        <translation>Betrag und Phase des Motors, gemessen und nach seinem Modell</translation>
    </message>
    <message>
        <source>Frequency response of the motor</source>
        <translation>Frequenzgang des Motors</translation>
    </message>
    <message>
        <source>Sines of duty around a speed at which it never reverses, the last on %1. Believed and drawn are %2 of %3: ten samples make a swing, and the sine explains 0.9 of the movement at least (coherence).</source>
        <translation>Sinusse des Tastgrads um eine Drehzahl, bei der er nie umkehrt, der letzte am %1. Geglaubt und gezeichnet werden %2 von %3: zehn Messwerte je Schwingung, und der Sinus erklärt mindestens 0,9 der Bewegung (Kohärenz).</translation>
    </message>
    <message>
        <source>Load one way kG</source>
        <translation>Last in eine Richtung kG</translation>
    </message>
    <message>
        <source>Gain forwards</source>
        <translation>Verstärkung vorwärts</translation>
    </message>
    <message>
        <source>Gain backwards</source>
        <translation>Verstärkung rückwärts</translation>
    </message>
    <message>
        <source>Noise at rest σ</source>
        <translation>Rauschen in Ruhe σ</translation>
    </message>
    <message>
        <source>Set-points that it can follow: at most %1 and %2</source>
        <translation>Sollwerte, denen er folgen kann: höchstens %1 und %2</translation>
    </message>
    <message>
        <source>to be looked at</source>
        <translation>zu prüfen</translation>
    </message>
    <message>
        <source>Order to motion</source>
        <translation>Befehl bis Bewegung</translation>
    </message>
    <message>
        <source>Dead time θ</source>
        <translation>Totzeit θ</translation>
    </message>
    <message>
        <source>counts</source>
        <translation>counts</translation>
    </message>
    <message>
        <source>Breakaway forwards</source>
        <translation>Losbrechen vorwärts</translation>
    </message>
    <message>
        <source>Breakaway backwards</source>
        <translation>Losbrechen rückwärts</translation>
    </message>
    <message>
        <source>Tag</source>
        <translation>Kennung</translation>
    </message>
    <message>
        <source>Known by</source>
        <translation>Bekannt durch</translation>
    </message>
    <message>
        <source>its place; another unit may stand there</source>
        <translation>seinen Platz; dort kann ein anderes Gerät stehen</translation>
    </message>
    <message>
        <source>Friction, share of duty</source>
        <translation>Reibung, Anteil des Tastgrads</translation>
    </message>
    <message>
        <source>Gain, counts/s at full duty</source>
        <translation>Verstärkung, counts/s bei vollem Tastgrad</translation>
    </message>
    <message>
        <source>Not kept</source>
        <translation>Nicht behalten</translation>
    </message>
    <message>
        <source>duty %1, which stands in for a limit of current</source>
        <translation>Tastgrad %1, der für eine Stromgrenze einsteht</translation>
    </message>
    <message>
        <source>%1 (forgotten)</source>
        <translation>%1 (vergessen)</translation>
    </message>
    <message>
        <source>band: ± of the model</source>
        <translation>Band: ± des Modells</translation>
    </message>
    <message>
        <source>Proposal</source>
        <translation>Vorschlag</translation>
    </message>
    <message>
        <source>Response</source>
        <translation>Antwort</translation>
    </message>
    <message>
        <source>Bounded by</source>
        <translation>Begrenzt durch</translation>
    </message>
    <message>
        <source>chosen</source>
        <translation>gewählt</translation>
    </message>
    <message>
        <source>current, %1</source>
        <translation>Strom, %1</translation>
    </message>
</context>
<context>
    <name>mb::ReportsPage</name>
    <message>
        <source>Reports</source>
        <translation>Berichte</translation>
    </message>
    <message>
        <source>Nothing to report yet</source>
        <translation>Noch nichts zu berichten</translation>
    </message>
    <message>
        <source>The cards of units, their tunings and their trials appear here.</source>
        <translation>Hier erscheinen Karten der Geräte, ihre Abstimmungen und Versuche.</translation>
    </message>
    <message>
        <source>Search the reports</source>
        <translation>Berichte durchsuchen</translation>
    </message>
    <message>
        <source>Reports, newest first</source>
        <translation>Berichte, neueste zuerst</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>Write report…</source>
        <translation>Bericht schreiben…</translation>
    </message>
    <message>
        <source>Preview of the report</source>
        <translation>Vorschau des Berichts</translation>
    </message>
    <message>
        <source>writes the report that is looked at</source>
        <translation>schreibt den angezeigten Bericht</translation>
    </message>
    <message>
        <source>goes to the search</source>
        <translation>geht zur Suche</translation>
    </message>
    <message>
        <source>Card of %1</source>
        <translation>Karte von %1</translation>
    </message>
    <message>
        <source>Tuning of %1</source>
        <translation>Abstimmung von %1</translation>
    </message>
    <message>
        <source>%1 trials</source>
        <translation>%1 Versuche</translation>
    </message>
    <message>
        <source>Trial #%1 of %2</source>
        <translation>Versuch #%1 von %2</translation>
    </message>
    <message>
        <source>What is listed</source>
        <translation>Was aufgeführt wird</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alle</translation>
    </message>
    <message>
        <source>Cards</source>
        <translation>Karten</translation>
    </message>
    <message>
        <source>Tuning</source>
        <translation>Abstimmung</translation>
    </message>
    <message>
        <source>Journal</source>
        <translation>Journal</translation>
    </message>
    <message>
        <source>Note on this entry</source>
        <translation>Notiz zu diesem Eintrag</translation>
    </message>
    <message>
        <source>Note on this entry of the journal</source>
        <translation>Notiz zu diesem Eintrag des Journals</translation>
    </message>
    <message>
        <source>Size of the report</source>
        <translation>Größe des Berichts</translation>
    </message>
    <message>
        <source>Pages, A4</source>
        <translation>Seiten, A4</translation>
    </message>
    <message>
        <source>Label, 62 × 29 mm</source>
        <translation>Etikett, 62 × 29 mm</translation>
    </message>
    <message>
        <source>Save CSV…</source>
        <translation>CSV speichern…</translation>
    </message>
    <message>
        <source>The entries of the journal that are listed, as a table</source>
        <translation>Die aufgeführten Einträge des Journals als Tabelle</translation>
    </message>
    <message>
        <source>Save the journal</source>
        <translation>Journal speichern</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tabelle (*.csv)</translation>
    </message>
    <message>
        <source>the journal is in %1</source>
        <translation>das Journal ist in %1</translation>
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
    <name>mb::ResponsePlot</name>
    <message>
        <source>DEMO</source>
        <translation>DEMO</translation>
    </message>
    <message>
        <source>t = 0 at the edge, mean of %1 · %2 samples, %3 lost</source>
        <translation>t = 0 an der Flanke, Mittel aus %1 · %2 Messwerte, %3 fehlen</translation>
    </message>
    <message>
        <source>t = 0 at the edge · %1 samples, %2 lost</source>
        <translation>t = 0 an der Flanke · %1 Messwerte, %2 fehlen</translation>
    </message>
    <message>
        <source>Responses</source>
        <translation>Antworten</translation>
    </message>
    <message>
        <source>%1 #%2</source>
        <translation>%1 #%2</translation>
    </message>
    <message>
        <source>set-point</source>
        <translation>Sollwert</translation>
    </message>
    <message>
        <source>±2 % band</source>
        <translation>Band ±2 %</translation>
    </message>
    <message>
        <source>%1 peak %2 %</source>
        <translation>%1 Spitze %2 %</translation>
    </message>
    <message>
        <source>%1 settles %2</source>
        <translation>%1 ausgeregelt nach %2</translation>
    </message>
    <message>
        <source>%1: duty at %2 % limit, %3</source>
        <translation>%1: Tastgrad an der Grenze %2 %, %3</translation>
    </message>
    <message>
        <source>%1: current at its limit, %2</source>
        <translation>%1: Strom an seiner Grenze, %2</translation>
    </message>
    <message>
        <source>limit %1 %</source>
        <translation>Grenze %1 %</translation>
    </message>
    <message>
        <source>limit %1 A</source>
        <translation>Grenze %1 A</translation>
    </message>
</context>
<context>
    <name>mb::RoutePanel</name>
    <message>
        <source>Way in</source>
        <translation>Zugang</translation>
    </message>
    <message>
        <source>Programmer</source>
        <translation>Programmiergerät</translation>
    </message>
    <message>
        <source>Microcontroller</source>
        <translation>Mikrocontroller</translation>
    </message>
    <message>
        <source>Which microcontroller the unit has</source>
        <translation>Welchen Mikrocontroller das Gerät hat</translation>
    </message>
    <message>
        <source>Erase what the unit has stored: its gains are lost</source>
        <translation>Löschen, was das Gerät gespeichert hat: seine Verstärkungen gehen verloren</translation>
    </message>
    <message>
        <source>Programmer or port and where it is plugged in, as after --via on the command line</source>
        <translation>Programmiergerät oder Anschluss und wo es angesteckt ist, wie nach --via in der Befehlszeile</translation>
    </message>
    <message>
        <source>What is not known of it…</source>
        <translation>Was davon nicht bekannt ist…</translation>
    </message>
    <message>
        <source>What the maker does not tell of the bootloader, with the likely values</source>
        <translation>Was der Hersteller über den Bootloader nicht mitteilt, mit den wahrscheinlichen Werten</translation>
    </message>
</context>
<context>
    <name>mb::SamplesWindow</name>
    <message>
        <source>%1 s, %2 samples, %3 lost</source>
        <translation>%1 s, %2 Messwerte, %3 verloren</translation>
    </message>
    <message>
        <source>; the end of the file is missing</source>
        <translation>; das Ende der Datei fehlt</translation>
    </message>
    <message>
        <source>%1 (recorded samples)</source>
        <translation>%1 (aufgezeichnete Messwerte)</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>Liest %1</translation>
    </message>
    <message>
        <source>Fit time and value</source>
        <translation>Zeit und Wert einpassen</translation>
    </message>
    <message>
        <source>Cursors</source>
        <translation>Cursor</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Ausgeben</translation>
    </message>
    <message>
        <source>Channels</source>
        <translation>Kanäle</translation>
    </message>
    <message>
        <source>Recorded samples</source>
        <translation>Aufgezeichnete Messwerte</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Geschrieben: %1</translation>
    </message>
    <message>
        <source>shows everything</source>
        <translation>zeigt alles</translation>
    </message>
    <message>
        <source>shows or hides the cursors</source>
        <translation>zeigt oder verbirgt die Cursor</translation>
    </message>
    <message>
        <source>closes this window</source>
        <translation>schließt dieses Fenster</translation>
    </message>
    <message>
        <source>shows these keys</source>
        <translation>zeigt diese Tasten</translation>
    </message>
    <message>
        <source>%1: no samples</source>
        <translation>%1: keine Messwerte</translation>
    </message>
    <message>
        <source>One export at a time: %1 is being written.</source>
        <translation>Nur ein Export zur selben Zeit: %1 wird gerade geschrieben.</translation>
    </message>
    <message>
        <source>; the file has more, of which nothing is shown: it is too large for the memory</source>
        <translation>; die Datei hat mehr, wovon nichts gezeigt wird: Sie ist zu groß für den Speicher</translation>
    </message>
</context>
<context>
    <name>mb::SavedLimits</name>
    <message>
        <source>Kept limits</source>
        <translation>Behaltene Grenzen</translation>
    </message>
    <message>
        <source>kept limits</source>
        <translation>behaltene Grenzen</translation>
    </message>
    <message>
        <source>Name of the limits</source>
        <translation>Name der Grenzen</translation>
    </message>
    <message>
        <source>Choose limits that were kept for this unit, or type a name to keep the present ones under</source>
        <translation>Grenzen wählen, die für dieses Gerät behalten wurden, oder einen Namen eingeben, unter dem die jetzigen behalten werden</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Behalten</translation>
    </message>
    <message>
        <source>Keep these limits under this name</source>
        <translation>Diese Grenzen unter diesem Namen behalten</translation>
    </message>
    <message>
        <source>Forget</source>
        <translation>Vergessen</translation>
    </message>
    <message>
        <source>Forget the limits of this name</source>
        <translation>Die Grenzen dieses Namens vergessen</translation>
    </message>
</context>
<context>
    <name>mb::ScanStrip</name>
    <message>
        <source>What the scan looks for</source>
        <translation>Wonach die Suche sucht</translation>
    </message>
    <message>
        <source>Progress of the scan</source>
        <translation>Fortschritt der Suche</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Cancel the scan</source>
        <translation>Suche abbrechen</translation>
    </message>
    <message>
        <source>Ends the search; what it has found stays.</source>
        <translation>Beendet die Suche; was sie gefunden hat, bleibt.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>mb::SendPanel</name>
    <message>
        <source>Send a frame</source>
        <translation>Frame senden</translation>
    </message>
    <message>
        <source>Identifier</source>
        <translation>Identifier</translation>
    </message>
    <message>
        <source>id, such as 7FF</source>
        <translation>ID, etwa 7FF</translation>
    </message>
    <message>
        <source>Hexadecimal; a whole frame such as 02061405#8125 may be pasted here</source>
        <translation>Hexadezimal; auch ein ganzer Frame wie 02061405#8125 lässt sich hier einfügen</translation>
    </message>
    <message>
        <source>Length of the identifier</source>
        <translation>Länge des Identifiers</translation>
    </message>
    <message>
        <source>11 bits</source>
        <translation>11 Bit</translation>
    </message>
    <message>
        <source>29 bits</source>
        <translation>29 Bit</translation>
    </message>
    <message>
        <source>Data</source>
        <translation>Daten</translation>
    </message>
    <message>
        <source>data, such as 81 25 11</source>
        <translation>Daten, etwa 81 25 11</translation>
    </message>
    <message>
        <source>Repeat every</source>
        <translation>Wiederholen alle</translation>
    </message>
    <message>
        <source>Period</source>
        <translation>Periode</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> ms</translation>
    </message>
    <message>
        <source>Send</source>
        <translation>Senden</translation>
    </message>
    <message>
        <source>Hold to send</source>
        <translation>Halten zum Senden</translation>
    </message>
    <message>
        <source>End repeating</source>
        <translation>Wiederholen beenden</translation>
    </message>
    <message>
        <source>What is typed here is decoded before it is sent</source>
        <translation>Was hier eingegeben wird, wird vor dem Senden dekodiert</translation>
    </message>
    <message>
        <source>Makes a motor move: %1</source>
        <translation>Bewegt einen Motor: %1</translation>
    </message>
    <message>
        <source>ended</source>
        <translation>beendet</translation>
    </message>
    <message>
        <source>The link does not take frames as fast as they are sent</source>
        <translation>Die Verbindung nimmt Frames nicht so schnell an, wie sie gesendet werden</translation>
    </message>
    <message>
        <source>%1 sent</source>
        <translation>%1 gesendet</translation>
    </message>
    <message>
        <source>%1 sent, then: %2</source>
        <translation>%1 gesendet, dann: %2</translation>
    </message>
    <message>
        <source>the page was left</source>
        <translation>die Seite wurde verlassen</translation>
    </message>
    <message>
        <source>the window lost the focus</source>
        <translation>das Fenster verlor den Fokus</translation>
    </message>
    <message>
        <source>no decoder knows this identifier</source>
        <translation>kein Decoder kennt diesen Identifier</translation>
    </message>
    <message>
        <source>%1 of %2 #%3   %4</source>
        <translation>%1 von %2 #%3   %4</translation>
    </message>
</context>
<context>
    <name>mb::SessionDesk</name>
    <message>
        <source>today %1</source>
        <translation>heute %1</translation>
    </message>
    <message>
        <source>yesterday %1</source>
        <translation>gestern %1</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1 is used by %2 too</source>
        <translation>%1 wird auch von %2 benutzt</translation>
    </message>
    <message>
        <source>agree who drives: two masters disturb each other</source>
        <translation>absprechen, wer fährt: zwei Master stören einander</translation>
    </message>
    <message>
        <source>The program ended unexpectedly (%1). What was measured is kept. Open again: %2?</source>
        <translation>Das Programm endete unerwartet (%1). Was gemessen wurde, ist aufbewahrt. Wieder öffnen: %2?</translation>
    </message>
    <message numerus="yes">
        <source>%n unit(s)</source>
        <translation>
            <numerusform>%n Gerät</numerusform>
            <numerusform>%n Geräte</numerusform>
        </translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
</context>
<context>
    <name>mb::SessionKeeper</name>
    <message>
        <source>This session cannot be kept: %1</source>
        <translation>Diese Sitzung kann nicht aufbewahrt werden: %1</translation>
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
    <message>
        <source>Stop and count from 0</source>
        <translation>Stoppen und ab 0 zählen</translation>
    </message>
    <message>
        <source>Stops the motor, and makes where it stands position 0. It starts again with Run only: a motor that runs would jump.</source>
        <translation>Stoppt den Motor und macht die Stelle, an der er steht, zur Position 0. Er läuft erst mit Start wieder an: ein laufender Motor würde springen.</translation>
    </message>
    <message>
        <source>Drive options</source>
        <translation>Optionen</translation>
    </message>
</context>
<context>
    <name>mb::SetPointRange</name>
    <message>
        <source>Range ±</source>
        <translation>Bereich ±</translation>
    </message>
    <message>
        <source>Moves</source>
        <translation>Verlauf</translation>
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
</context>
<context>
    <name>mb::SideDocks</name>
    <message>
        <source>Devices</source>
        <translation>Geräte</translation>
    </message>
    <message>
        <source>Inspector</source>
        <translation>Inspektor</translation>
    </message>
    <message>
        <source>shows or hides the devices</source>
        <translation>zeigt oder verbirgt die Geräte</translation>
    </message>
    <message>
        <source>shows or hides the inspector</source>
        <translation>zeigt oder verbirgt den Inspektor</translation>
    </message>
    <message>
        <source>Show devices</source>
        <translation>Geräte einblenden</translation>
    </message>
</context>
<context>
    <name>mb::SignalBook</name>
    <message>
        <source>The signal needs a name.</source>
        <translation>Das Signal braucht einen Namen.</translation>
    </message>
    <message>
        <source>There is a derived signal of this name.</source>
        <translation>Ein abgeleitetes Signal dieses Namens gibt es schon.</translation>
    </message>
    <message>
        <source>%1 may be one of %2</source>
        <translation>%1 kann eines von %2 sein</translation>
    </message>
</context>
<context>
    <name>mb::SignalList</name>
    <message>
        <source>Add a signal</source>
        <translation>Signale</translation>
    </message>
    <message>
        <source>Signals that can be plotted</source>
        <translation>Darstellbare Signale</translation>
    </message>
    <message>
        <source>double click or drag</source>
        <translation>Doppelklick oder ziehen</translation>
    </message>
    <message>
        <source>Derived signal…</source>
        <translation>Abgeleitetes Signal…</translation>
    </message>
    <message>
        <source>A formula over signals: derivative, moving average, difference …</source>
        <translation>Eine Formel über Signale: Ableitung, gleitender Mittelwert, Differenz …</translation>
    </message>
    <message>
        <source>derived</source>
        <translation>abgeleitet</translation>
    </message>
    <message>
        <source>%1
right click removes the signal</source>
        <translation>%1
Rechtsklick entfernt das Signal</translation>
    </message>
    <message>
        <source>%1
double click plots it, drag it to a pane or below them</source>
        <translation>%1
Doppelklick stellt es dar; in ein Diagramm oder darunter ziehen</translation>
    </message>
    <message>
        <source>Remove this derived signal</source>
        <translation>Dieses abgeleitete Signal entfernen</translation>
    </message>
</context>
<context>
    <name>mb::SlotPanel</name>
    <message>
        <source>Gain slot, edit and run</source>
        <translation>Slot, bearbeiten und laufen lassen</translation>
    </message>
    <message>
        <source>The slot that is edited and that runs. Changing it disarms.</source>
        <translation>Der Slot, der bearbeitet wird und läuft. Eine Änderung sichert.</translation>
    </message>
    <message>
        <source>Split</source>
        <translation>Trennen</translation>
    </message>
    <message>
        <source>Edit one slot while another runs</source>
        <translation>Einen Slot bearbeiten, während ein anderer läuft</translation>
    </message>
    <message>
        <source>Slot</source>
        <translation>Slot</translation>
    </message>
    <message>
        <source>edit and run</source>
        <translation>ändern, laufen</translation>
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
    <message>
        <source>Join</source>
        <translation>Verbinden</translation>
    </message>
    <message>
        <source>Edit the slot that runs</source>
        <translation>Den Slot bearbeiten, der läuft</translation>
    </message>
    <message>
        <source>Split: both are slot %1 now.</source>
        <translation>Getrennt: beide sind jetzt Slot %1.</translation>
    </message>
    <message>
        <source>Split: edits go to slot %1, slot %2 runs.</source>
        <translation>Getrennt: bearbeitet wird Slot %1, es läuft Slot %2.</translation>
    </message>
</context>
<context>
    <name>mb::SpectrumView</name>
    <message>
        <source>Spectrum</source>
        <translation>Spektrum</translation>
    </message>
    <message>
        <source>frequency, Hz</source>
        <translation>Frequenz, Hz</translation>
    </message>
    <message>
        <source>amplitude</source>
        <translation>Amplitude</translation>
    </message>
    <message>
        <source>amplitude, %1</source>
        <translation>Amplitude, %1</translation>
    </message>
    <message>
        <source>A … B</source>
        <translation>A … B</translation>
    </message>
    <message>
        <source>what is seen</source>
        <translation>was zu sehen ist</translation>
    </message>
    <message>
        <source>, Hann window, peak values. </source>
        <translation>, Hann-Fenster, Scheitelwerte. </translation>
    </message>
</context>
<context>
    <name>mb::SpokenNames</name>
    <message>
        <source>Places</source>
        <translation>Orte</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Dateien</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>Kind of file</source>
        <translation>Art der Datei</translation>
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
    <name>mb::StartPage</name>
    <message>
        <source>Start</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Add link</source>
        <translation>Verbindung hinzufügen</translation>
    </message>
    <message>
        <source>Open recording…</source>
        <translation>Aufnahme öffnen…</translation>
    </message>
    <message>
        <source>Try with a simulated motor</source>
        <translation>Mit einem simulierten Motor ausprobieren</translation>
    </message>
    <message>
        <source>Open the simulated bench</source>
        <translation>Simulierten Prüfstand öffnen</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Weitermachen</translation>
    </message>
    <message>
        <source>Firmware on this computer</source>
        <translation>Firmware auf diesem Rechner</translation>
    </message>
    <message>
        <source>Folder…</source>
        <translation>Ordner…</translation>
    </message>
    <message>
        <source>Choose the folder whose images are listed here</source>
        <translation>Den Ordner wählen, dessen Abbilder hier stehen</translation>
    </message>
    <message>
        <source>First time here?</source>
        <translation>Zum ersten Mal hier?</translation>
    </message>
    <message>
        <source>STOP works on key press, everywhere, also while you type (use Esc then). It is software: keep a hardware stop in the supply.</source>
        <translation>STOP wirkt beim Drücken, überall, auch beim Tippen (dann mit Esc). Es ist Software: einen echten Schalter in der Versorgung behalten.</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>Wiring guides</source>
        <translation>Verdrahtung</translation>
    </message>
    <message>
        <source>Sessions and recordings that you have opened stand here.</source>
        <translation>Hier stehen Sitzungen und Aufnahmen von früher.</translation>
    </message>
    <message>
        <source>No image (.hex) in this folder.</source>
        <translation>Kein Abbild (.hex) in diesem Ordner.</translation>
    </message>
    <message>
        <source>Controllers of every family with real bus timing; nothing real can move.</source>
        <translation>Steuerungen aller Familien mit echtem Zeitverhalten des Busses; nichts Echtes kann sich bewegen.</translation>
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
    <name>mb::StationDialog</name>
    <message>
        <source>Journal of this station</source>
        <translation>Journal dieser Station</translation>
    </message>
    <message>
        <source>Name of this station</source>
        <translation>Name dieser Station</translation>
    </message>
    <message>
        <source>Server that stations share</source>
        <translation>Gemeinsamer Server der Stationen</translation>
    </message>
    <message>
        <source>Without a server the journal is in the file of this computer alone. With one, every entry is there first and delivered as soon as the server answers; numbers come in blocks of five.</source>
        <translation>Ohne Server steht das Journal nur in der Datei dieses Rechners. Mit einem steht jeder Eintrag zuerst dort und wird übergeben, sobald der Server antwortet; Nummern kommen in Fünferblöcken.</translation>
    </message>
</context>
<context>
    <name>mb::StationLamp</name>
    <message>
        <source>%1 self-test</source>
        <translation>%1 Selbsttest</translation>
    </message>
    <message>
        <source>turns in a moment</source>
        <translation>dreht sich gleich</translation>
    </message>
    <message>
        <source>self-tests</source>
        <translation>Selbsttests</translation>
    </message>
    <message>
        <source>nothing turns here</source>
        <translation>hier dreht sich nichts</translation>
    </message>
    <message>
        <source>Arm button</source>
        <translation>Scharf-Taste</translation>
    </message>
</context>
<context>
    <name>mb::StatusBar</name>
    <message>
        <source>samples %1   lost %2   memory %3</source>
        <translation>Werte %1   verloren %2   Speicher %3</translation>
    </message>
</context>
<context>
    <name>mb::StepText</name>
    <message>
        <source>%1, predicted</source>
        <translation>%1, vorhergesagt</translation>
    </message>
    <message>
        <source>measured, forwards</source>
        <translation>gemessen, vorwärts</translation>
    </message>
    <message>
        <source>measured, backwards</source>
        <translation>gemessen, rückwärts</translation>
    </message>
    <message>
        <source>measured: %1 % over, settled after %2</source>
        <translation>gemessen: %1 % Überschwingen, ausgeregelt nach %2</translation>
    </message>
    <message>
        <source>%1 % over</source>
        <translation>%1 % über</translation>
    </message>
    <message>
        <source>%1 A peak</source>
        <translation>Spitze %1 A</translation>
    </message>
    <message>
        <source>±2 %</source>
        <translation>±2 %</translation>
    </message>
    <message>
        <source>%1 settles %2</source>
        <translation>%1: Ausregelzeit %2</translation>
    </message>
    <message>
        <source>%1 does not settle</source>
        <translation>%1 schwingt nicht ein</translation>
    </message>
    <message>
        <source>measured: peak %1, %2 % over</source>
        <translation>gemessen: Spitze %1, %2 % über</translation>
    </message>
    <message>
        <source>measured: settles %1</source>
        <translation>gemessen: Ausregelzeit %1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>counts/s</source>
        <translation>counts/s</translation>
    </message>
    <message>
        <source>A</source>
        <translation>A</translation>
    </message>
    <message>
        <source>counts</source>
        <translation>counts</translation>
    </message>
    <message>
        <source>Step of %1 %2</source>
        <translation>Sprung von %1 %2</translation>
    </message>
    <message>
        <source>band: ± of the model</source>
        <translation>Band: ± des Modells</translation>
    </message>
</context>
<context>
    <name>mb::StepsPanel</name>
    <message>
        <source>Steps of the update</source>
        <translation>Schritte des Updates</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
</context>
<context>
    <name>mb::StimulusBar</name>
    <message>
        <source>there, until it has settled, and back</source>
        <translation>hin, bis ausgeregelt, und zurück</translation>
    </message>
    <message>
        <source>to and fro, 0.5 Hz</source>
        <translation>hin und her, 0,5 Hz</translation>
    </message>
    <message>
        <source>evenly there and back</source>
        <translation>gleichmäßig hin und zurück</translation>
    </message>
    <message>
        <source>1 Hz, six swings</source>
        <translation>1 Hz, sechs Schwingungen</translation>
    </message>
    <message>
        <source>0.1 to 15 Hz in 30 s</source>
        <translation>0,1 bis 15 Hz in 30 s</translation>
    </message>
    <message>
        <source>random bits of 125 ms</source>
        <translation>zufällige Bits von 125 ms</translation>
    </message>
    <message>
        <source>Stimulus</source>
        <translation>Anregung</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>Where the experiment begins and ends; empty: where the motor is, or 0</source>
        <translation>Wo der Versuch beginnt und endet; leer: wo der Motor ist, oder 0</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Nach</translation>
    </message>
    <message>
        <source>Where the loop is asked to go</source>
        <translation>Wohin der Regelkreis soll</translation>
    </message>
    <message>
        <source>hold</source>
        <translation>halten</translation>
    </message>
    <message>
        <source>Time of the stimulus</source>
        <translation>Zeit der Anregung</translation>
    </message>
    <message>
        <source>Seconds; empty: the usual, and a step ends once it has settled</source>
        <translation>Sekunden; leer: wie üblich, und ein Sprung endet, wenn er ausgeregelt ist</translation>
    </message>
    <message>
        <source>Repeats</source>
        <translation>Läufe</translation>
    </message>
    <message>
        <source>Each repeat starts a little later between two samples: together they show what is finer than the telemetry</source>
        <translation>Jeder Lauf beginnt etwas später zwischen zwei Messwerten: zusammen zeigen sie, was feiner ist als die Telemetrie</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>here</source>
        <translation>hier</translation>
    </message>
    <message>
        <source>rise</source>
        <translation>Anstieg</translation>
    </message>
    <message>
        <source>time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>settled</source>
        <translation>ausgeregelt</translation>
    </message>
    <message>
        <source>usual</source>
        <translation>üblich</translation>
    </message>
    <message>
        <source>Enter where the loop is to go.</source>
        <translation>Eingeben, wohin der Regelkreis soll.</translation>
    </message>
    <message>
        <source>%1 is no number.</source>
        <translation>%1 ist keine Zahl.</translation>
    </message>
    <message>
        <source>The time is 0.001 to %1 s.</source>
        <translation>Die Zeit ist 0,001 bis %1 s.</translation>
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
    <name>mb::StoryCard</name>
    <message numerus="yes">
        <source>about %n min</source>
        <translation>
            <numerusform>etwa %n min</numerusform>
            <numerusform>etwa %n min</numerusform>
        </translation>
    </message>
    <message>
        <source>Try it</source>
        <translation>Ausprobieren</translation>
    </message>
    <message>
        <source>Try it: %1</source>
        <translation>Ausprobieren: %1</translation>
    </message>
</context>
<context>
    <name>mb::SweepPanel</name>
    <message>
        <source>%1 sines from %2 to %3 Hz, both ways in turn: duty %4 ± %5 %, at most %6 counts/s, %7 counts one way, %8.</source>
        <translation>%1 Sinusse von %2 bis %3 Hz, abwechselnd in beide Richtungen: Tastgrad %4 ± %5 %, höchstens %6 counts/s, %7 counts in eine Richtung, %8.</translation>
    </message>
    <message>
        <source>Frequency response</source>
        <translation>Frequenzgang</translation>
    </message>
    <message>
        <source>Measures the motor by sines and draws it over its model, as far as it may be trusted</source>
        <translation>Misst den Motor mit Sinussen und zeichnet ihn über sein Modell, so weit ihm zu trauen ist</translation>
    </message>
</context>
<context>
    <name>mb::TimelineList</name>
    <message>
        <source>window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>console</source>
        <translation>Konsole</translation>
    </message>
    <message>
        <source>autotune</source>
        <translation>selbst abgestimmt</translation>
    </message>
    <message>
        <source>recipe</source>
        <translation>Rezept</translation>
    </message>
    <message>
        <source>elsewhere</source>
        <translation>anderswo</translation>
    </message>
    <message>
        <source>States of this unit</source>
        <translation>Stände dieses Geräts</translation>
    </message>
    <message>
        <source>Today, %1</source>
        <translation>Heute, %1</translation>
    </message>
    <message>
        <source>like A</source>
        <translation>wie A</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>undone: %1</source>
        <translation>zurückgenommen: %1</translation>
    </message>
    <message>
        <source>done again: %1</source>
        <translation>wiederholt: %1</translation>
    </message>
    <message numerus="yes">
        <source>%n differ</source>
        <translation>
            <numerusform>%n verschieden</numerusform>
            <numerusform>%n verschieden</numerusform>
        </translation>
    </message>
    <message>
        <source>Always there</source>
        <translation>Immer da</translation>
    </message>
    <message>
        <source>This place, not this unit</source>
        <translation>Dieser Platz, nicht dieses Gerät</translation>
    </message>
    <message>
        <source>reverted: %1</source>
        <translation>zurückgeschrieben: %1</translation>
    </message>
</context>
<context>
    <name>mb::TourStage</name>
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
    <message>
        <source>Pane, axis, trigger, reference …</source>
        <translation>Diagramm, Achse, Trigger, Referenz …</translation>
    </message>
</context>
<context>
    <name>mb::TracePanel</name>
    <message>
        <source>Traces</source>
        <translation>Kurven</translation>
    </message>
    <message>
        <source>rate      lost</source>
        <translation>Rate   verl.</translation>
    </message>
    <message>
        <source>mean %1 · σ %2 · %3 … %4 · %5 samples</source>
        <translation>Mittel %1 · σ %2 · %3 … %4 · %5 Werte</translation>
    </message>
    <message>
        <source> · %1 lost</source>
        <translation> · %1 verloren</translation>
    </message>
    <message>
        <source>derived</source>
        <translation>abgeleitet</translation>
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
    <message>
        <source>In a pane of its own</source>
        <translation>In ein eigenes Diagramm</translation>
    </message>
    <message>
        <source>Into the pane above</source>
        <translation>In das Diagramm darüber</translation>
    </message>
    <message>
        <source>With its unit</source>
        <translation>Zur gleichen Einheit</translation>
    </message>
    <message>
        <source>Scale at the right</source>
        <translation>Skala rechts</translation>
    </message>
    <message>
        <source>Trigger on it	T</source>
        <translation>Darauf triggern	T</translation>
    </message>
    <message>
        <source>Keep all as references</source>
        <translation>Alle als Referenz behalten</translation>
    </message>
    <message>
        <source>Remove references</source>
        <translation>Referenzen entfernen</translation>
    </message>
    <message>
        <source>Spectrum</source>
        <translation>Spektrum</translation>
    </message>
    <message>
        <source>Remove the trace</source>
        <translation>Kurve entfernen</translation>
    </message>
    <message>
        <source>%1 cursors · %2 fits · + − zooms · %3 pauses · N note</source>
        <translation>%1 Cursor · %2 passt ein · + − zoomt · %3 hält an · N Notiz</translation>
    </message>
    <message>
        <source>%1, of another time</source>
        <translation>%1, aus anderer Zeit</translation>
    </message>
</context>
<context>
    <name>mb::TrafficView</name>
    <message>
        <source>Columns of %1</source>
        <translation>Spalten von %1</translation>
    </message>
</context>
<context>
    <name>mb::TrialList</name>
    <message>
        <source>Which trials</source>
        <translation>Welche Versuche</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alle</translation>
    </message>
    <message>
        <source>Starred</source>
        <translation>Mit Stern</translation>
    </message>
    <message>
        <source>Clean</source>
        <translation>Saubere</translation>
    </message>
    <message>
        <source>Back to best</source>
        <translation>Zum besten zurück</translation>
    </message>
    <message>
        <source>Stages the gains of the quickest clean trial with no more than 5 % overshoot; runs nothing.</source>
        <translation>Merkt die Verstärkungen des schnellsten sauberen Versuchs mit höchstens 5 % Überschwingen vor; startet nichts.</translation>
    </message>
    <message>
        <source>Use these gains</source>
        <translation>Diese Verstärkungen nehmen</translation>
    </message>
    <message>
        <source>Export the trials as CSV or JSON</source>
        <translation>Versuche als CSV oder JSON ausgeben</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <source>Trials of this loop</source>
        <translation>Versuche an diesem Regelkreis</translation>
    </message>
    <message>
        <source>Every experiment appears here with its gains and what became of it.</source>
        <translation>Jeder Versuch erscheint hier mit seinen Verstärkungen und dem, was daraus wurde.</translation>
    </message>
    <message numerus="yes">
        <source>%n, every run is kept</source>
        <translation>
            <numerusform>%n, jeder Lauf bleibt erhalten</numerusform>
            <numerusform>%n, jeder Lauf bleibt erhalten</numerusform>
        </translation>
    </message>
    <message>
        <source>All %1</source>
        <translation>Alle %1</translation>
    </message>
    <message>
        <source>Starred %1</source>
        <translation>Mit Stern %1</translation>
    </message>
    <message>
        <source>Clean %1</source>
        <translation>Saubere %1</translation>
    </message>
    <message>
        <source>Back to best #%1</source>
        <translation>Zum besten zurück #%1</translation>
    </message>
    <message>
        <source>Show as B</source>
        <translation>Als B zeigen</translation>
    </message>
    <message>
        <source>Pin as A  A</source>
        <translation>Als A anheften  A</translation>
    </message>
    <message>
        <source>Take the star away</source>
        <translation>Stern wegnehmen</translation>
    </message>
    <message>
        <source>Give it a star</source>
        <translation>Stern geben</translation>
    </message>
    <message>
        <source>Edit the note</source>
        <translation>Notiz bearbeiten</translation>
    </message>
    <message>
        <source>Forget this trial</source>
        <translation>Diesen Versuch vergessen</translation>
    </message>
    <message>
        <source>stopped: speed</source>
        <translation>gestoppt: Drehzahl</translation>
    </message>
</context>
<context>
    <name>mb::TrialModel</name>
    <message>
        <source>Take the star away</source>
        <translation>Stern wegnehmen</translation>
    </message>
    <message>
        <source>Give it a star</source>
        <translation>Stern geben</translation>
    </message>
    <message>
        <source>starred</source>
        <translation>mit Stern</translation>
    </message>
    <message>
        <source>no star</source>
        <translation>ohne Stern</translation>
    </message>
    <message>
        <source>trial</source>
        <translation>Versuch</translation>
    </message>
    <message>
        <source>time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>stimulus</source>
        <translation>Anregung</translation>
    </message>
    <message>
        <source>over %</source>
        <translation>Über %</translation>
    </message>
    <message>
        <source>settle</source>
        <translation>Ausregelzeit</translation>
    </message>
    <message>
        <source>rise</source>
        <translation>Anstieg</translation>
    </message>
    <message>
        <source>peak A</source>
        <translation>Spitze A</translation>
    </message>
    <message>
        <source>flags</source>
        <translation>Zeichen</translation>
    </message>
    <message>
        <source>note</source>
        <translation>Notiz</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>Nehmen</translation>
    </message>
    <message>
        <source>Stages the gains of this trial; nothing is written yet.</source>
        <translation>Merkt die Verstärkungen dieses Versuchs vor; geschrieben wird noch nichts.</translation>
    </message>
    <message>
        <source>Use the gains of trial #%1</source>
        <translation>Die Verstärkungen von Versuch #%1 nehmen</translation>
    </message>
</context>
<context>
    <name>mb::TrialOrders</name>
    <message>
        <source>the notebook: %1</source>
        <translation>das Versuchsbuch: %1</translation>
    </message>
    <message>
        <source>Export trials</source>
        <translation>Versuche ausgeben</translation>
    </message>
    <message>
        <source>Table (*.csv);;JSON (*.json)</source>
        <translation>Tabelle (*.csv);;JSON (*.json)</translation>
    </message>
    <message>
        <source>trials written to %1</source>
        <translation>Versuche nach %1 geschrieben</translation>
    </message>
</context>
<context>
    <name>mb::TrialWords</name>
    <message>
        <source>better</source>
        <translation>besser</translation>
    </message>
    <message>
        <source>worse</source>
        <translation>schlechter</translation>
    </message>
    <message>
        <source>faster</source>
        <translation>schneller</translation>
    </message>
    <message>
        <source>slower</source>
        <translation>langsamer</translation>
    </message>
    <message>
        <source>Rise 10–90</source>
        <translation>Anstieg 10–90</translation>
    </message>
    <message>
        <source>Settle 2 %</source>
        <translation>Ausregelzeit 2 %</translation>
    </message>
    <message>
        <source>Overshoot</source>
        <translation>Überschwingen</translation>
    </message>
    <message>
        <source>Undershoot</source>
        <translation>Unterschwingen</translation>
    </message>
    <message>
        <source>Steady error</source>
        <translation>Restfehler</translation>
    </message>
    <message>
        <source>IAE</source>
        <translation>IAE</translation>
    </message>
    <message>
        <source>ITAE</source>
        <translation>ITAE</translation>
    </message>
    <message>
        <source>Peak current</source>
        <translation>Stromspitze</translation>
    </message>
    <message>
        <source>Duty chatter</source>
        <translation>Stellunruhe</translation>
    </message>
    <message>
        <source>Saturated</source>
        <translation>Gesättigt</translation>
    </message>
    <message>
        <source>Noise σ</source>
        <translation>Rauschen σ</translation>
    </message>
    <message>
        <source>Step and back</source>
        <translation>Sprung und zurück</translation>
    </message>
    <message>
        <source>Square</source>
        <translation>Rechteck</translation>
    </message>
    <message>
        <source>Ramp</source>
        <translation>Rampe</translation>
    </message>
    <message>
        <source>Sine</source>
        <translation>Sinus</translation>
    </message>
    <message>
        <source>Chirp</source>
        <translation>Chirp</translation>
    </message>
    <message>
        <source>PRBS</source>
        <translation>PRBS</translation>
    </message>
    <message>
        <source>stopped: %1</source>
        <translation>gestoppt: %1</translation>
    </message>
    <message>
        <source>nobody saw its end</source>
        <translation>niemand sah das Ende</translation>
    </message>
    <message>
        <source>%1 samples lost</source>
        <translation>%1 Messwerte fehlen</translation>
    </message>
    <message>
        <source>saturated %1 %</source>
        <translation>gesättigt %1 %</translation>
    </message>
</context>
<context>
    <name>mb::TrialsHead</name>
    <message>
        <source>Flip A and B</source>
        <translation>A und B tauschen</translation>
    </message>
    <message>
        <source>Pin B as A</source>
        <translation>B als A anheften</translation>
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
        <source>A #%1 is another stimulus, it is not drawn</source>
        <translation>A #%1 hat eine andere Anregung und wird nicht gezeichnet</translation>
    </message>
    <message>
        <source>Shift+click on a trial pins it as A</source>
        <translation>Umschalt+Klick auf einen Versuch heftet ihn als A an</translation>
    </message>
    <message>
        <source>No trial yet. Run makes the first.</source>
        <translation>Noch kein Versuch. Start macht den ersten.</translation>
    </message>
</context>
<context>
    <name>mb::TrialsView</name>
    <message>
        <source>Below the plot</source>
        <translation>Unter dem Diagramm</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation>Kennwerte</translation>
    </message>
    <message>
        <source>not kept: %1</source>
        <translation>nicht aufbewahrt: %1</translation>
    </message>
</context>
<context>
    <name>mb::TriggerBar</name>
    <message>
        <source>Trigger off</source>
        <translation>Trigger aus</translation>
    </message>
    <message>
        <source>Arm again: forgets this event, waits for the next</source>
        <translation>Neu scharf: vergisst dieses Ereignis, wartet auf das nächste</translation>
    </message>
    <message>
        <source>Trace that triggers</source>
        <translation>Kurve, die triggert</translation>
    </message>
    <message>
        <source>↑ rises through</source>
        <translation>↑ überschreitet</translation>
    </message>
    <message>
        <source>↓ falls through</source>
        <translation>↓ unterschreitet</translation>
    </message>
    <message>
        <source>↕ crosses</source>
        <translation>↕ kreuzt</translation>
    </message>
    <message>
        <source>is above</source>
        <translation>liegt über</translation>
    </message>
    <message>
        <source>is below</source>
        <translation>liegt unter</translation>
    </message>
    <message>
        <source>Edge or level</source>
        <translation>Flanke oder Pegel</translation>
    </message>
    <message>
        <source>%1 % before</source>
        <translation>%1 % davor</translation>
    </message>
    <message>
        <source>Part of the window before the event</source>
        <translation>Anteil des Fensters vor dem Ereignis</translation>
    </message>
    <message>
        <source>What follows an event</source>
        <translation>Was auf ein Ereignis folgt</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normal</translation>
    </message>
    <message>
        <source>Single</source>
        <translation>Einzeln</translation>
    </message>
    <message>
        <source>Normal shows every event, single stops at the first</source>
        <translation>Normal zeigt jedes Ereignis, Einzeln hält beim ersten an</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Pegel</translation>
    </message>
    <message>
        <source>The level; the handle ▸ at the left of the plot drags it, too</source>
        <translation>Der Pegel; auch der Griff ▸ links am Diagramm verschiebt ihn</translation>
    </message>
    <message>
        <source>trigger %1 %2 %3, %4 before</source>
        <translation>Trigger %1 %2 %3, %4 davor</translation>
    </message>
</context>
<context>
    <name>mb::TuneAxes</name>
    <message>
        <source>%1 %2, at rest</source>
        <comment>mode and target</comment>
        <translation>%1 %2, in Ruhe</translation>
    </message>
    <message>
        <source>axis %1 moves in another mode; stop it first</source>
        <translation>Achse %1 bewegt sich in einer anderen Betriebsart; zuerst stoppen</translation>
    </message>
</context>
<context>
    <name>mb::TuneColumn</name>
    <message>
        <source>The power limit of axis %1 is unknown: its first motion sets it to %2. Write another under Limits of the axis.</source>
        <translation>Die Leistungsgrenze der Achse %1 ist unbekannt: ihre erste Bewegung setzt sie auf %2. Eine andere unter Grenzen der Achse schreiben.</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
</context>
<context>
    <name>mb::TuneCommands</name>
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
        <source>Run %1 axes</source>
        <translation>%1 Achsen starten</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Experiment</source>
        <translation>Versuch</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>Live</translation>
    </message>
    <message>
        <source>Stop axis %1</source>
        <translation>Achse %1 stoppen</translation>
    </message>
</context>
<context>
    <name>mb::TuneExperiments</name>
    <message>
        <source>Experiment</source>
        <translation>Versuch</translation>
    </message>
    <message>
        <source>Moving</source>
        <translation>In Bewegung</translation>
    </message>
    <message>
        <source>Stop the motion before an experiment.</source>
        <translation>Vor einem Versuch die Bewegung anhalten.</translation>
    </message>
    <message>
        <source>The stimulus cannot be sent</source>
        <translation>Die Anregung lässt sich nicht senden</translation>
    </message>
    <message>
        <source>No experiment yet</source>
        <translation>Noch kein Versuch möglich</translation>
    </message>
    <message>
        <source>No experiment in this mode</source>
        <translation>Kein Versuch in dieser Betriebsart</translation>
    </message>
    <message>
        <source>Armed</source>
        <translation>Scharf</translation>
    </message>
    <message>
        <source>Not armed</source>
        <translation>Nicht scharf</translation>
    </message>
    <message>
        <source>Hold the Arm button for 1 s to arm %1.</source>
        <translation>Scharf-Taste 1 s halten, um %1 scharf zu schalten.</translation>
    </message>
    <message>
        <source>The position of axis %1 is not known yet</source>
        <translation>Die Position von Achse %1 ist noch nicht bekannt</translation>
    </message>
    <message>
        <source>no device</source>
        <translation>kein Gerät</translation>
    </message>
    <message>
        <source>its position is not known yet</source>
        <translation>die Position ist noch nicht bekannt</translation>
    </message>
    <message>
        <source>Run begins the experiment.</source>
        <translation>Start beginnt den Versuch.</translation>
    </message>
</context>
<context>
    <name>mb::TuneForm</name>
    <message>
        <source>the running slot</source>
        <translation>der laufende Slot</translation>
    </message>
    <message>
        <source>a direction or a limit</source>
        <translation>eine Richtung oder Grenze</translation>
    </message>
    <message>
        <source>the mode</source>
        <translation>Betriebsart</translation>
    </message>
</context>
<context>
    <name>mb::TuneFrame</name>
    <message>
        <source>Part of the page</source>
        <translation>Teil der Seite</translation>
    </message>
    <message>
        <source>Set-up</source>
        <translation>Vorgabe</translation>
    </message>
    <message>
        <source>Plot</source>
        <translation>Kurve</translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>Live</translation>
    </message>
</context>
<context>
    <name>mb::TuneGains</name>
    <message>
        <source>A gain is out of range</source>
        <translation>Eine Verstärkung liegt außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>Correct or revert it first.</source>
        <translation>Zuerst korrigieren oder zurücksetzen.</translation>
    </message>
    <message>
        <source>Look at a gain again</source>
        <translation>Eine Verstärkung noch einmal ansehen</translation>
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
        <source>gains not written: %1</source>
        <translation>Verstärkungen nicht geschrieben: %1</translation>
    </message>
    <message>
        <source>Gains of trial #%1</source>
        <translation>Verstärkungen von Versuch #%1</translation>
    </message>
    <message>
        <source>What the adviser proposes</source>
        <translation>Was der Ratgeber vorschlägt</translation>
    </message>
    <message>
        <source>nothing copied: no gain of axis %1 is known for this mode; write it first</source>
        <translation>nichts kopiert: für diese Betriebsart ist keine Verstärkung der Achse %1 bekannt; zuerst schreiben</translation>
    </message>
    <message>
        <source>Gains and limits of axis %1</source>
        <translation>Verstärkungen und Grenzen der Achse %1</translation>
    </message>
</context>
<context>
    <name>mb::TuneKeys</name>
    <message>
        <source>writes what is staged and runs</source>
        <translation>schreibt, was vorgemerkt ist, und startet</translation>
    </message>
    <message>
        <source>the same, four times over</source>
        <translation>dasselbe, viermal nacheinander</translation>
    </message>
    <message>
        <source>goes to the first gain</source>
        <translation>geht zur ersten Verstärkung</translation>
    </message>
    <message>
        <source>swaps the gain slots; disarms</source>
        <translation>tauscht die Slots; entschärft</translation>
    </message>
    <message>
        <source>flips trials A and B</source>
        <translation>vertauscht die Versuche A und B</translation>
    </message>
    <message>
        <source>pins trial B as A</source>
        <translation>heftet Versuch B als A an</translation>
    </message>
    <message>
        <source>cursors in the plot: arrows move one, C changes to the other</source>
        <translation>Cursor in der Kurve: Pfeile bewegen einen, C wechselt zum anderen</translation>
    </message>
    <message>
        <source>fits time and value of the plot</source>
        <translation>passt Zeit und Wert der Kurve ein</translation>
    </message>
    <message>
        <source>pauses the live view, and goes on</source>
        <translation>hält die Live-Ansicht an und lässt sie weiterlaufen</translation>
    </message>
    <message>
        <source>identifies the device: it blinks</source>
        <translation>zeigt das Gerät: es blinkt</translation>
    </message>
    <message>
        <source>held: moves the armed motor gently forwards or backwards</source>
        <translation>gehalten: bewegt den scharfen Motor sanft vorwärts oder rückwärts</translation>
    </message>
    <message>
        <source>on a gain&apos;s slider: 2 %, with Shift 0.2 %, with Ctrl 20 %; the wheel does the same by 2 %</source>
        <translation>am Schieber einer Verstärkung: 2 %, mit Umschalt 0,2 %, mit Strg 20 %; das Mausrad ändert um 2 %</translation>
    </message>
    <message>
        <source>writes a report of the trials that are shown</source>
        <translation>schreibt einen Bericht über die gezeigten Versuche</translation>
    </message>
    <message>
        <source>a battery of steps: several sizes, both ways, and the worst of them</source>
        <translation>eine Reihe von Sprüngen: mehrere Größen, beide Richtungen und das Schlechteste davon</translation>
    </message>
    <message>
        <source>undoes the last edit of gains, or else the last write to the unit</source>
        <translation>nimmt die letzte Änderung der Verstärkungen zurück, sonst das letzte Schreiben in das Gerät</translation>
    </message>
    <message>
        <source>redoes the last edit or write</source>
        <translation>stellt die letzte Änderung oder das letzte Schreiben wieder her</translation>
    </message>
</context>
<context>
    <name>mb::TuneMotion</name>
    <message>
        <source>position 0 is here; the motor is off until Run</source>
        <translation>Position 0 ist hier; der Motor ist bis Start aus</translation>
    </message>
    <message>
        <source>it has no lamp that could blink</source>
        <translation>es hat keine Lampe, die blinken könnte</translation>
    </message>
    <message>
        <source>not identified: %1</source>
        <translation>nicht gezeigt: %1</translation>
    </message>
    <message>
        <source>disarmed: %1 changed</source>
        <translation>gesichert: %1 geändert</translation>
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
        <source>Not armed</source>
        <translation>Nicht scharf</translation>
    </message>
    <message>
        <source>Hold the Arm button for 1 s to arm %1.</source>
        <translation>Scharf-Taste 1 s halten, um %1 scharf zu schalten.</translation>
    </message>
    <message>
        <source>axis %1: %2</source>
        <translation>Achse %1: %2</translation>
    </message>
    <message>
        <source>%1, slot %2</source>
        <translation>%1, Slot %2</translation>
    </message>
    <message>
        <source> · also moving: axis %1</source>
        <translation> · bewegt sich auch: Achse %1</translation>
    </message>
    <message>
        <source>Its position is not known yet</source>
        <translation>Die Position ist noch nicht bekannt</translation>
    </message>
    <message>
        <source>It starts where it is once it has told where that is.</source>
        <translation>Er beginnt, wo er steht, sobald er gemeldet hat, wo das ist.</translation>
    </message>
    <message>
        <source>%1: holds</source>
        <translation>%1: hält</translation>
    </message>
    <message>
        <source>%1 by %2</source>
        <translation>%1 um %2</translation>
    </message>
    <message>
        <source>Run begins %1</source>
        <translation>Start beginnt %1</translation>
    </message>
</context>
<context>
    <name>mb::TunePage</name>
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
        <translation>Links in der Liste eines wählen; hier wird sein Regler abgestimmt.</translation>
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
        <source>Hold the Arm button for 1 s to arm again.</source>
        <translation>Scharf-Taste 1 s halten, um neu scharf zu schalten.</translation>
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
        <source>not run: %1. %2</source>
        <translation>nicht gestartet: %1. %2</translation>
    </message>
    <message>
        <source>Something moves</source>
        <translation>Es bewegt sich etwas</translation>
    </message>
    <message>
        <source>Hold the Arm button for 1 s to arm it first.</source>
        <translation>Zuerst die Scharf-Taste 1 s halten, um es scharf zu schalten.</translation>
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
        <source>Set-point</source>
        <translation>Sollwert</translation>
    </message>
    <message>
        <source>DEMO</source>
        <translation>DEMO</translation>
    </message>
    <message>
        <source>ch%1 set-point</source>
        <translation>ch%1 Sollwert</translation>
    </message>
</context>
<context>
    <name>mb::TuneSteps</name>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Envelope</source>
        <translation>Grenzen</translation>
    </message>
    <message>
        <source>Identify</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>Gains</source>
        <translation>Verstärkungen</translation>
    </message>
    <message>
        <source>Verify</source>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>Store</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>The direction of motor and encoder was checked; the first closed loop of a run checks it again.</source>
        <translation>Die Richtung von Motor und Geber wurde geprüft; die erste geschlossene Regelung eines Laufs prüft sie noch einmal.</translation>
    </message>
    <message>
        <source>Checked by itself before the first closed loop of a run.</source>
        <translation>Wird vor der ersten geschlossenen Regelung eines Laufs von selbst geprüft.</translation>
    </message>
    <message>
        <source>Every limit of an experiment is known.</source>
        <translation>Jede Grenze eines Versuchs ist bekannt.</translation>
    </message>
    <message>
        <source>Trial #%1 pushed the motor without a loop.</source>
        <translation>Versuch #%1 hat den Motor ohne Regelung angestoßen.</translation>
    </message>
    <message>
        <source>The device has the gains that are shown.</source>
        <translation>Das Gerät hat die gezeigten Verstärkungen.</translation>
    </message>
    <message>
        <source>Edited gains wait to be written.</source>
        <translation>Bearbeitete Verstärkungen warten aufs Schreiben.</translation>
    </message>
    <message>
        <source>The gains of the device are not known yet.</source>
        <translation>Die Verstärkungen des Geräts sind noch nicht bekannt.</translation>
    </message>
    <message>
        <source>Trial #%1 ran with these gains.</source>
        <translation>Versuch #%1 lief mit diesen Verstärkungen.</translation>
    </message>
    <message>
        <source>The gains are in flash.</source>
        <translation>Die Verstärkungen sind im Flash.</translation>
    </message>
    <message>
        <source>The gains are not known to be in flash.</source>
        <translation>Es ist nicht bekannt, dass die Verstärkungen im Flash sind.</translation>
    </message>
    <message>
        <source>%1: done</source>
        <comment>step</comment>
        <translation>%1: erledigt</translation>
    </message>
    <message>
        <source>Steps; next is %1</source>
        <translation>Schritte; der nächste ist %1</translation>
    </message>
    <message>
        <source>Steps; all are done</source>
        <translation>Schritte; alle sind erledigt</translation>
    </message>
    <message>
        <source>The last check found it wrong: the encoder is reversed, or the motor did not move.</source>
        <translation>Die letzte Prüfung fand es falsch: Der Sensor ist umgekehrt, oder der Motor bewegte sich nicht.</translation>
    </message>
    <message>
        <source>No model of the motor yet: the page Design identifies it.</source>
        <translation>Noch kein Modell des Motors: Die Seite Entwurf bestimmt es.</translation>
    </message>
    <message>
        <source>No trial with these gains yet: Run makes one.</source>
        <translation>Noch kein Versuch mit diesen Verstärkungen: Start macht einen.</translation>
    </message>
</context>
<context>
    <name>mb::TuningSteps</name>
    <message>
        <source>Kept</source>
        <translation>Behalten</translation>
    </message>
    <message>
        <source>Proposed, nothing written</source>
        <translation>Vorgeschlagen, nichts geschrieben</translation>
    </message>
    <message>
        <source>Rolled back</source>
        <translation>Zurückgenommen</translation>
    </message>
    <message>
        <source>Refused</source>
        <translation>Abgelehnt</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Gestoppt</translation>
    </message>
    <message>
        <source>What happens</source>
        <translation>Was geschieht</translation>
    </message>
    <message>
        <source>Working: the motor turns</source>
        <translation>In Arbeit: der Motor dreht</translation>
    </message>
    <message>
        <source>STOP ends it at any moment; what was changed is put back.</source>
        <translation>STOP beendet es jederzeit; was geändert war, wird zurückgestellt.</translation>
    </message>
    <message>
        <source>Nothing has moved yet</source>
        <translation>Noch hat sich nichts bewegt</translation>
    </message>
    <message>
        <source>over ≤ %1 %, settle ≤ %2, error ≤ %3 %</source>
        <translation>über ≤ %1 %, Ausregelzeit ≤ %2, Fehler ≤ %3 %</translation>
    </message>
    <message>
        <source>over ≤ %1 %, error ≤ %2 %</source>
        <translation>über ≤ %1 %, Fehler ≤ %2 %</translation>
    </message>
    <message>
        <source>over %1 %, settle %2, error %3 %</source>
        <translation>über %1 %, Ausregelzeit %2, Fehler %3 %</translation>
    </message>
    <message>
        <source>Identify the motor</source>
        <translation>Den Motor vermessen</translation>
    </message>
    <message>
        <source>Pushes with a part of the duty, both ways. No gain is changed.</source>
        <translation>Stöße mit einem Teil des Tastgrads in beide Richtungen. Keine Verstärkung wird geändert.</translation>
    </message>
    <message>
        <source>Choose a set</source>
        <translation>Einen Satz wählen</translation>
    </message>
    <message>
        <source>The plots show what each would do.</source>
        <translation>Die Kurven zeigen, was jeder täte.</translation>
    </message>
    <message>
        <source>Write and prove it</source>
        <translation>Schreiben und beweisen</translation>
    </message>
    <message>
        <source>The gains are written, steps both ways are measured.</source>
        <translation>Die Verstärkungen werden geschrieben, Sprünge in beide Richtungen gemessen.</translation>
    </message>
    <message>
        <source>Keep it, or put everything back</source>
        <translation>Behalten oder alles zurückstellen</translation>
    </message>
    <message>
        <source>It stays if it does what was predicted; else the reason is said.</source>
        <translation>Er bleibt, wenn er tut, was vorhergesagt war; sonst wird der Grund genannt.</translation>
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
        <source>The slot that the result is not for; what it had comes back.</source>
        <translation>Der Slot, für den das Ergebnis nicht ist; was er hatte, kommt zurück.</translation>
    </message>
    <message>
        <source>What is replaced is kept, to be put back.</source>
        <translation>Was ersetzt wird, ist aufgehoben und kann zurück.</translation>
    </message>
    <message>
        <source>Run %1 steps of %2 %3</source>
        <translation>%1 Sprünge von %2 %3 fahren</translation>
    </message>
    <message>
        <source>Both ways, every guard on; each is a trial.</source>
        <translation>In beide Richtungen, alle Wächter aktiv; jeder ist ein Versuch.</translation>
    </message>
    <message>
        <source>Keep it in slot %1 when all hold</source>
        <translation>In Slot %1 behalten, wenn alle gelten</translation>
    </message>
    <message>
        <source>Keep it when all hold</source>
        <translation>Behalten, wenn alle gelten</translation>
    </message>
    <message>
        <source>measured: %1</source>
        <translation>gemessen: %1</translation>
    </message>
    <message>
        <source>Else put everything back</source>
        <translation>Sonst alles zurückstellen</translation>
    </message>
    <message>
        <source>Gains as before, the reason in the log.</source>
        <translation>Verstärkungen wie zuvor, der Grund im Protokoll.</translation>
    </message>
    <message>
        <source>motor turns %1 s</source>
        <translation>Motor dreht %1 s</translation>
    </message>
    <message>
        <source>Identify and Autotune push first: %1</source>
        <translation>Vermessen und Selbst abstimmen stoßen zuerst an: %1</translation>
    </message>
    <message>
        <source>Not kept</source>
        <translation>Nicht behalten</translation>
    </message>
    <message>
        <source>Find the gains anew</source>
        <translation>Die Verstärkungen neu suchen</translation>
    </message>
    <message>
        <source>Those that are shown were found for other limits, or elsewhere.</source>
        <translation>Die gezeigten wurden unter anderen Grenzen oder an anderer Stelle gefunden.</translation>
    </message>
</context>
<context>
    <name>mb::UnitChecks</name>
    <message>
        <source>no unit answers yet</source>
        <translation>noch antwortet kein Gerät</translation>
    </message>
    <message numerus="yes">
        <source>%n units answer, one at a time</source>
        <translation>
            <numerusform>%n Gerät antwortet</numerusform>
            <numerusform>%n Geräte antworten, eins nach dem anderen</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 may turn</source>
        <translation>%1 dreht vielleicht</translation>
    </message>
    <message>
        <source>no motor turns</source>
        <translation>kein Motor dreht</translation>
    </message>
    <message>
        <source>no link is open</source>
        <translation>keine Verbindung ist offen</translation>
    </message>
    <message>
        <source>%1 is open</source>
        <translation>%1 ist offen</translation>
    </message>
    <message>
        <source>the journal takes entries</source>
        <translation>das Journal nimmt Einträge an</translation>
    </message>
    <message>
        <source>the journal keeps entries on this computer</source>
        <translation>das Journal bewahrt Einträge auf diesem Rechner auf</translation>
    </message>
    <message>
        <source>Before each unit</source>
        <translation>Vor jedem Gerät</translation>
    </message>
    <message>
        <source>%1 is not open</source>
        <translation>%1 ist nicht offen</translation>
    </message>
</context>
<context>
    <name>mb::UnitList</name>
    <message>
        <source>Last ten units, newest first</source>
        <translation>Letzte zehn Geräte, neueste zuerst</translation>
    </message>
</context>
<context>
    <name>mb::UnitStates</name>
    <message>
        <source>Device, now</source>
        <translation>Gerät, jetzt</translation>
    </message>
    <message>
        <source>factory defaults</source>
        <translation>Werkseinstellungen</translation>
    </message>
    <message>
        <source>live</source>
        <translation>aktuell</translation>
    </message>
    <message numerus="yes">
        <source>%n values</source>
        <translation>
            <numerusform>%n Wert</numerusform>
            <numerusform>%n Werte</numerusform>
        </translation>
    </message>
    <message>
        <source>by hand, %1</source>
        <translation>von Hand, %1</translation>
    </message>
    <message>
        <source>automatic, %1</source>
        <translation>automatisch, %1</translation>
    </message>
    <message>
        <source>from the device description</source>
        <translation>aus der Gerätebeschreibung</translation>
    </message>
</context>
<context>
    <name>mb::UnitSteps</name>
    <message>
        <source>Steps of this unit</source>
        <translation>Schritte dieses Geräts</translation>
    </message>
    <message>
        <source>Skip this unit</source>
        <translation>Dieses Gerät auslassen</translation>
    </message>
    <message>
        <source>Do it again</source>
        <translation>Noch einmal</translation>
    </message>
    <message>
        <source>No unit selected</source>
        <translation>Kein Gerät gewählt</translation>
    </message>
</context>
<context>
    <name>mb::UnitUpdate</name>
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
        <source>Cancelled. %1.</source>
        <translation>Abgebrochen. %1.</translation>
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
        <source>One update a bus: %1 is being written.</source>
        <translation>Eine Aktualisierung je Bus: %1 wird gerade beschrieben.</translation>
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
        <translation>Motor dreht sich</translation>
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
        <source>%1 s a page, about %2 s left</source>
        <translation>%1 s je Seite, noch etwa %2 s</translation>
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
        <source>Open a firmware image</source>
        <translation>Firmware-Image öffnen</translation>
    </message>
    <message>
        <source>Intel HEX (*.hex *.ihex);;All files (*)</source>
        <translation>Intel HEX (*.hex *.ihex);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>motor not known</source>
        <translation>Motor unbekannt</translation>
    </message>
    <message>
        <source>Cancelled: %1</source>
        <translation>Abgebrochen: %1</translation>
    </message>
    <message>
        <source>Cancelled: nothing was written.</source>
        <translation>Abgebrochen: Es wurde nichts geschrieben.</translation>
    </message>
    <message>
        <source>%1, as in the image</source>
        <translation>%1, wie im Image</translation>
    </message>
    <message>
        <source>Written, not proved: %1</source>
        <translation>Geschrieben, nicht bewiesen: %1</translation>
    </message>
    <message>
        <source>%1 has changed since it was opened and is read again; start the update once more</source>
        <translation>%1 hat sich seit dem Öffnen geändert und ist neu gelesen; das Update noch einmal starten</translation>
    </message>
    <message>
        <source>Before start</source>
        <translation>Vor dem Start</translation>
    </message>
    <message>
        <source>Units are served on this link.</source>
        <translation>An dieser Verbindung werden Geräte bedient.</translation>
    </message>
</context>
<context>
    <name>mb::UpdateLog</name>
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
        <source>Save the log of the update</source>
        <translation>Protokoll des Updates speichern</translation>
    </message>
    <message>
        <source>Text (*.log *.txt)</source>
        <translation>Text (*.log *.txt)</translation>
    </message>
</context>
<context>
    <name>mb::UpdateSide</name>
    <message>
        <source>Flash pages</source>
        <translation>Flash-Seiten</translation>
    </message>
    <message>
        <source>In the order they are written. Green: written. Amber edge: sent again. Dashed: not in the image. Red: must not be cut.</source>
        <translation>In der Reihenfolge des Schreibens. Grün: geschrieben. Gelber Rand: erneut gesendet. Gestrichelt: nicht im Image. Rot: nicht unterbrechen.</translation>
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
        <source>The motor turns as soon as Arm in the header is held.</source>
        <translation>Der Motor dreht, sobald die Scharf-Taste in der Kopfzeile gehalten wird.</translation>
    </message>
    <message>
        <source>The self-test turns the motor.</source>
        <translation>Der Selbsttest dreht den Motor.</translation>
    </message>
</context>
<context>
    <name>mb::VerdictView</name>
    <message>
        <source>READY</source>
        <translation>BEREIT</translation>
    </message>
    <message>
        <source>WORKING</source>
        <translation>LÄUFT</translation>
    </message>
    <message>
        <source>PASS</source>
        <translation>BESTANDEN</translation>
    </message>
    <message>
        <source>FAIL</source>
        <translation>NICHT BESTANDEN</translation>
    </message>
    <message>
        <source>REFUSED</source>
        <translation>ABGELEHNT</translation>
    </message>
    <message>
        <source>LEFT OUT</source>
        <translation>AUSGELASSEN</translation>
    </message>
</context>
<context>
    <name>mb::Welcome</name>
    <message>
        <source>Folder with firmware</source>
        <translation>Ordner mit Firmware</translation>
    </message>
</context>
<context>
    <name>mb::WindowKeys</name>
    <message>
        <source>shows these keys; once more, the help for this page</source>
        <translation>zeigt diese Tasten; noch einmal, die Hilfe zu dieser Seite</translation>
    </message>
    <message>
        <source>production: unit after unit, full screen; and back</source>
        <translation>Produktion: Gerät um Gerät, ganzer Bildschirm; und zurück</translation>
    </message>
    <message>
        <source>shows page %1</source>
        <translation>zeigt die Seite %1</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>Menu</source>
        <translation>Menü</translation>
    </message>
    <message>
        <source>renames the selected device; in production: goes to the serial number</source>
        <translation>benennt das gewählte Gerät um; in der Produktion: geht zur Seriennummer</translation>
    </message>
    <message>
        <source>stores what the selected device has in RAM only</source>
        <translation>speichert, was das gewählte Gerät nur im RAM hat</translation>
    </message>
    <message>
        <source>takes a snapshot of the selected device</source>
        <translation>hält alle Werte des gewählten Geräts fest</translation>
    </message>
</context>
<context>
    <name>mb::WindowMenu</name>
    <message>
        <source>Add link…</source>
        <translation>Verbindung hinzufügen…</translation>
    </message>
    <message>
        <source>Open recording…</source>
        <translation>Aufnahme öffnen…</translation>
    </message>
    <message>
        <source>Open the simulated bench</source>
        <translation>Den simulierten Prüfstand öffnen</translation>
    </message>
    <message>
        <source>Commands…</source>
        <translation>Befehle…</translation>
    </message>
    <message>
        <source>Switch between dark and light</source>
        <translation>Zwischen dunkel und hell wechseln</translation>
    </message>
    <message>
        <source>Preferences…</source>
        <translation>Einstellungen…</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>About MotorBench</source>
        <translation>Über MotorBench</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>Open a recording</source>
        <translation>Eine Aufnahme öffnen</translation>
    </message>
    <message>
        <source>All recordings (*.log *.asc *.txt *.mcap *.csv)</source>
        <translation>Alle Aufnahmen (*.log *.asc *.txt *.mcap *.csv)</translation>
    </message>
    <message>
        <source>Frames: candump and Vector ASC logs (*.log *.asc *.txt)</source>
        <translation>Rahmen: Logs von candump und Vector ASC (*.log *.asc *.txt)</translation>
    </message>
    <message>
        <source>Samples: MCAP, CSV (*.mcap *.csv)</source>
        <translation>Messwerte: MCAP, CSV (*.mcap *.csv)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Open the folder of a machine…</source>
        <translation>Ordner einer Maschine öffnen…</translation>
    </message>
    <message>
        <source>Save the machine into a folder…</source>
        <translation>Maschine in einen Ordner sichern…</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>lists everything that can be done, by name</source>
        <translation>listet alles auf, was getan werden kann, nach Namen</translation>
    </message>
    <message>
        <source>shows the preferences</source>
        <translation>zeigt die Einstellungen</translation>
    </message>
    <message>
        <source>switches between dark and light</source>
        <translation>wechselt zwischen dunkel und hell</translation>
    </message>
    <message>
        <source>opens a recording</source>
        <translation>öffnet eine Aufnahme</translation>
    </message>
    <message>
        <source>quits</source>
        <translation>beendet das Programm</translation>
    </message>
</context>
<context>
    <name>table</name>
    <message>
        <source>CAN sockets cannot be opened: %1</source>
        <translation>CAN-Sockets lassen sich nicht öffnen: %1</translation>
    </message>
    <message>
        <source>the kernel does not list its interfaces: %1</source>
        <translation>der Kernel nennt seine Schnittstellen nicht: %1</translation>
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
        <source>%1 was disconnected</source>
        <translation>%1 wurde getrennt</translation>
    </message>
    <message>
        <source>virtual</source>
        <translation>virtuell</translation>
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
        <source>several units answer as number %1</source>
        <translation>mehrere Geräte antworten als Nummer %1</translation>
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
        <source>stored, not verifiable</source>
        <translation>gespeichert, nicht nachweisbar</translation>
    </message>
    <message>
        <source>Waiting until the device has written its flash</source>
        <translation>Warte, bis das Gerät seinen Flash geschrieben hat</translation>
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
        <source>no answer</source>
        <translation>keine Antwort</translation>
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
        <source>%1: no such file</source>
        <translation>%1: keine solche Datei</translation>
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
        <source>the device already runs %1</source>
        <translation>das Gerät hat bereits %1</translation>
    </message>
    <message>
        <source>the device answers with version %1</source>
        <translation>das Gerät antwortet mit Version %1</translation>
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
        <translation>Größte Änderung des Ausgangs je Zyklus von 500 µs; 16 braucht 1,024 s von 0 auf 100 %. Kleiner ist langsamer, aber 0 ist keine Rampe.</translation>
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
        <translation>Versorgung 5 s lang unter 5,75 V. Schreiben eines Werts ungleich 0 liest den Zähler und löscht ihn.</translation>
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
        <source>%1 cannot be opened: %2</source>
        <translation>%1 lässt sich nicht öffnen: %2</translation>
    </message>
    <message>
        <source>%1 cannot do %2 bit/s: %3</source>
        <translation>%1 kann %2 bit/s nicht: %3</translation>
    </message>
    <message>
        <source>%1 bit/s is no rate of a serial line</source>
        <translation>%1 bit/s ist keine Übertragungsrate einer seriellen Leitung</translation>
    </message>
    <message>
        <source>the driver of %1 cannot switch the direction of an RS-485 line, so the adapter has to do it by itself; if nothing answers, use one that does</source>
        <translation>der Treiber von %1 kann die Richtung einer RS-485-Leitung nicht umschalten, das muss der Adapter selbst tun; antwortet nichts, einen verwenden, der es kann</translation>
    </message>
    <message>
        <source>is there</source>
        <translation>ist da</translation>
    </message>
    <message>
        <source>%1 is switched off</source>
        <translation>%1 ist ausgeschaltet</translation>
    </message>
    <message>
        <source>%1 is bus-off</source>
        <translation>%1 ist bus-off</translation>
    </message>
    <message>
        <source>%1 only listens, nothing can be sent</source>
        <translation>%1 empfängt nur, Senden ist nicht möglich</translation>
    </message>
    <message>
        <source>nobody acknowledges what %1 sends</source>
        <translation>niemand bestätigt, was %1 sendet</translation>
    </message>
    <message>
        <source>only disturbed frames arrive on %1, the bus has another bit rate than %2</source>
        <translation>an %1 kommen nur gestörte Frames an, der Bus hat eine andere Bitrate als %2</translation>
    </message>
    <message>
        <source>only disturbed frames arrive on %1, the bus has another bit rate</source>
        <translation>an %1 kommen nur gestörte Frames an, der Bus hat eine andere Bitrate</translation>
    </message>
    <message>
        <source>the bus leaves no room for what %1 sends</source>
        <translation>der Bus lässt keinen Platz für das, was %1 sendet</translation>
    </message>
    <message>
        <source>%1 is error-passive</source>
        <translation>%1 ist error-passive</translation>
    </message>
    <message>
        <source>%1 is error-warning</source>
        <translation>%1 ist error-warning</translation>
    </message>
    <message>
        <source>%1 frames were lost, the kernel keeps only %2 for this program</source>
        <translation>%1 Frames gingen verloren, der Kernel hält nur %2 für dieses Programm vor</translation>
    </message>
    <message>
        <source>no permission to open CAN sockets here</source>
        <translation>keine Berechtigung für CAN-Sockets</translation>
    </message>
    <message>
        <source>no permission to use %1</source>
        <translation>keine Berechtigung für %1</translation>
    </message>
    <message>
        <source>this kernel has no CAN support</source>
        <translation>dieser Kernel kennt kein CAN</translation>
    </message>
    <message>
        <source>there is no CAN interface</source>
        <translation>keine CAN-Schnittstelle vorhanden</translation>
    </message>
    <message>
        <source>bring it up</source>
        <translation>einschalten</translation>
    </message>
    <message>
        <source>bring it up as a full member</source>
        <translation>als vollwertigen Teilnehmer einschalten</translation>
    </message>
    <message>
        <source>load it</source>
        <translation>laden</translation>
    </message>
    <message>
        <source>plug in an adapter</source>
        <translation>Adapter einstecken</translation>
    </message>
    <message>
        <source>plug in an adapter at any time; it is opened by itself once it is up</source>
        <translation>jederzeit einen Adapter einstecken; er wird von selbst geöffnet, sobald er eingeschaltet ist</translation>
    </message>
    <message>
        <source>plug the adapter in again; the link is opened by itself as soon as it is up</source>
        <translation>Adapter wieder einstecken; die Verbindung wird von selbst geöffnet, sobald er eingeschaltet ist</translation>
    </message>
    <message>
        <source>allow them in the container or sandbox</source>
        <translation>im Container oder in der Sandbox freigeben</translation>
    </message>
    <message>
        <source>become a member of its group</source>
        <translation>der Gruppe beitreten</translation>
    </message>
    <message>
        <source>check wiring, termination and bit rate, then</source>
        <translation>Verdrahtung, Abschluss und Bitrate prüfen, dann</translation>
    </message>
    <message>
        <source>check wiring, termination and bit rate, then reconnect</source>
        <translation>Verdrahtung, Abschluss und Bitrate prüfen, dann neu verbinden</translation>
    </message>
    <message>
        <source>check wiring, termination and bit rate; it starts again by itself</source>
        <translation>Verdrahtung, Abschluss und Bitrate prüfen; Neustart erfolgt von selbst</translation>
    </message>
    <message>
        <source>check the cable, both 120 Ω resistors, and that no number is taken twice</source>
        <translation>Kabel und beide Widerstände mit 120 Ω prüfen, und dass keine Nummer doppelt vergeben ist</translation>
    </message>
    <message>
        <source>switch the devices on, check the cable and that two 120 Ω resistors end the bus, and that every device has the bit rate %1</source>
        <translation>Geräte einschalten, Kabel prüfen, und dass zwei Widerstände mit 120 Ω den Bus abschließen und jedes Gerät die Bitrate %1 hat</translation>
    </message>
    <message>
        <source>find it by listening only</source>
        <translation>durch reines Mithören ermitteln</translation>
    </message>
    <message>
        <source>this interface cannot listen without disturbing the bus, so ask who set it up; usual are 1 Mbit/s, 500, 250 and 125 kbit/s</source>
        <translation>diese Schnittstelle kann nicht mithören, ohne den Bus zu stören, also den fragen, der ihn eingerichtet hat; üblich sind 1 Mbit/s, 500, 250 und 125 kbit/s</translation>
    </message>
    <message>
        <source>find the sender that fills it, on the Bus page or with &apos;motorbenchctl monitor&apos;</source>
        <translation>den Sender suchen, der ihn füllt, auf der Seite Bus oder mit „motorbenchctl monitor“</translation>
    </message>
    <message>
        <source>allow more, then close and open the link</source>
        <translation>mehr zulassen, dann die Verbindung schließen und öffnen</translation>
    </message>
    <message>
        <source>reconnect</source>
        <translation>neu verbinden</translation>
    </message>
    <message>
        <source>this device has no watchdog, and nothing here would stop it if the program died</source>
        <translation>dieses Gerät hat keinen Watchdog, und nichts hier würde es stoppen, wenn das Programm abstürzt</translation>
    </message>
    <message>
        <source>it is not known how to stop this device from outside</source>
        <translation>es ist nicht bekannt, wie sich dieses Gerät von außen stoppen lässt</translation>
    </message>
    <message>
        <source>the guardian does not stand by yet</source>
        <translation>der Wächter steht noch nicht bereit</translation>
    </message>
    <message>
        <source>no guardian came within two seconds</source>
        <translation>innerhalb von zwei Sekunden kam kein Wächter</translation>
    </message>
    <message>
        <source>this program was held up for so long that the guardian may have stopped the motor</source>
        <translation>dieses Programm war so lange aufgehalten, dass der Wächter den Motor gestoppt haben kann</translation>
    </message>
    <message>
        <source>%1 does not answer</source>
        <translation>%1 antwortet nicht</translation>
    </message>
    <message>
        <source>stop the motor before its dialect is changed</source>
        <translation>vor dem Wechsel des Dialekts den Motor stoppen</translation>
    </message>
    <message>
        <source>%1 has no &apos;%2&apos; to be set</source>
        <translation>%1 hat kein „%2“, das sich setzen lässt</translation>
    </message>
    <message>
        <source>Looking for Supermodified nodes at %1 bit/s</source>
        <translation>Suche Supermodified-Knoten mit %1 bit/s</translation>
    </message>
    <message>
        <source>Supermodified found: %1</source>
        <translation>Supermodified gefunden: %1</translation>
    </message>
    <message>
        <source>Its error level is 1, so every reading fails. Set error.level to 0.</source>
        <translation>Die Fehlerstufe ist 1, daher schlägt jedes Lesen fehl. error.level auf 0 setzen.</translation>
    </message>
    <message>
        <source>Its answers fit no known dialect.</source>
        <translation>Die Antworten passen zu keinem bekannten Dialekt.</translation>
    </message>
    <message>
        <source>%1, and the device switched its output off</source>
        <translation>%1, und das Gerät hat seinen Ausgang abgeschaltet</translation>
    </message>
    <message>
        <source>a relative move was not answered, and is never sent twice: look where the motor stands</source>
        <translation>eine relative Bewegung blieb ohne Antwort und wird nie zweimal gesendet: nachsehen, wo der Motor steht</translation>
    </message>
    <message>
        <source>the device does not answer</source>
        <translation>das Gerät antwortet nicht</translation>
    </message>
    <message>
        <source>the device says that the motor is not started; it may have lost its supply</source>
        <translation>das Gerät meldet, dass der Motor nicht gestartet ist; vielleicht war die Versorgung unterbrochen</translation>
    </message>
    <message>
        <source>the stop before it is not acknowledged yet</source>
        <translation>der Stopp davor ist noch nicht bestätigt</translation>
    </message>
    <message>
        <source>refused: %1</source>
        <translation>abgelehnt: %1</translation>
    </message>
    <message>
        <source>node %1 does not answer</source>
        <translation>Knoten %1 antwortet nicht</translation>
    </message>
    <message>
        <source>node id %1 is used by another node of this line</source>
        <translation>Knoten-ID %1 hat schon ein anderer Knoten an dieser Leitung</translation>
    </message>
    <message>
        <source>Connecting through avrdude</source>
        <translation>Verbinde über avrdude</translation>
    </message>
    <message>
        <source>Erasing flash</source>
        <translation>Lösche Flash</translation>
    </message>
    <message>
        <source>Writing flash</source>
        <translation>Schreibe Flash</translation>
    </message>
    <message>
        <source>Verifying flash</source>
        <translation>Prüfe Flash</translation>
    </message>
    <message>
        <source>Looking for the controller</source>
        <translation>Suche den Controller</translation>
    </message>
    <message>
        <source>no bootloader answers at %1 bit/s</source>
        <translation>kein Bootloader antwortet mit %1 bit/s</translation>
    </message>
    <message>
        <source>avrdude read back all %1 bytes and they are equal; the controller answers again, dialect %2</source>
        <translation>avrdude hat alle %1 Byte zurückgelesen, sie sind gleich; der Controller antwortet wieder, Dialekt %2</translation>
    </message>
    <message>
        <source>avrdude read back all %1 bytes and they are equal, but the controller does not answer; cut its power for a moment, and scan: a new firmware may have another rate or node id</source>
        <translation>avrdude hat alle %1 Byte zurückgelesen, sie sind gleich, aber der Controller antwortet nicht; Versorgung kurz trennen und neu suchen: eine neue Firmware kann eine andere Übertragungsrate oder Knoten-ID haben</translation>
    </message>
    <message>
        <source>an Abstract DC Drive cannot be asked for its settings</source>
        <translation>ein Abstract DC Drive lässt sich nicht nach seinen Einstellungen fragen</translation>
    </message>
    <message>
        <source>stop the motor first: the drive stands still while it writes its flash</source>
        <translation>zuerst den Motor stoppen: der Antrieb steht still, während er seinen Flash schreibt</translation>
    </message>
    <message>
        <source>the offset of an Abstract DC Drive is compiled into its firmware</source>
        <translation>der Offset eines Abstract DC Drive ist fest in seine Firmware kompiliert</translation>
    </message>
    <message>
        <source>the set-point comes from here, not from the device</source>
        <translation>der Sollwert kommt von hier, nicht vom Gerät</translation>
    </message>
    <message>
        <source>a rate is a positive number, or 0 for the usual one</source>
        <translation>eine Rate ist eine positive Zahl, oder 0 für die übliche</translation>
    </message>
    <message>
        <source>F: the firmware&apos;s codes</source>
        <translation>F: Codes der Firmware</translation>
    </message>
    <message>
        <source>A unit that speaks the document&apos;s codes would take position for current and current for position.</source>
        <translation>Ein Gerät, das die Codes des Dokuments spricht, hielte Position für Strom und Strom für Position.</translation>
    </message>
    <message>
        <source>L: legacy frames of 8 bytes</source>
        <translation>L: alte Frames mit 8 Byte</translation>
    </message>
    <message>
        <source>A unit with today&apos;s firmware ignores these frames, the stop excepted, which is sent both ways.</source>
        <translation>Ein Gerät mit heutiger Firmware ignoriert diese Frames, außer dem Stopp, der auf beide Arten gesendet wird.</translation>
    </message>
    <message>
        <source>LL: older, cannot be stopped</source>
        <translation>LL: älter, nicht stoppbar</translation>
    </message>
    <message>
        <source>It is only watched: there is no code that stops it.</source>
        <translation>Es wird nur beobachtet: es gibt keinen Code, der es stoppt.</translation>
    </message>
    <message>
        <source>D: the document&apos;s codes</source>
        <translation>D: Codes des Dokuments</translation>
    </message>
    <message>
        <source>A unit that speaks the firmware&apos;s codes runs at full power when it is told a position, and loses its divisor when D is written.</source>
        <translation>Ein Gerät, das die Codes der Firmware spricht, läuft mit voller Leistung, wenn ihm eine Position vorgegeben wird, und verliert seinen Divisor, wenn D geschrieben wird.</translation>
    </message>
    <message>
        <source>Counts per revolution</source>
        <translation>Counts je Umdrehung</translation>
    </message>
    <message>
        <source>Encoder edges in one turn: four times its lines.</source>
        <translation>Encoderflanken einer Umdrehung: das Vierfache der Striche.</translation>
    </message>
    <message>
        <source>Ampere per count</source>
        <translation>Ampere je count</translation>
    </message>
    <message>
        <source>What one count of the current converter stands for; it depends on the board.</source>
        <translation>Wofür ein count des Stromwandlers steht; hängt von der Platine ab.</translation>
    </message>
    <message>
        <source>Degrees per count</source>
        <translation>Grad je count</translation>
    </message>
    <message>
        <source>What one count of the temperature converter stands for; it depends on the board.</source>
        <translation>Wofür ein count des Temperaturwandlers steht; hängt von der Platine ab.</translation>
    </message>
    <message>
        <source>count/s</source>
        <translation>count/s</translation>
    </message>
    <message>
        <source>ADC count</source>
        <translation>ADC-count</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>this is no program for the drive: it has bytes outside the flash of an STM32, 0x08000000 … 0x081FFFFF</source>
        <translation>das ist kein Programm für den Antrieb: es hat Bytes außerhalb des Flash eines STM32, 0x08000000 … 0x081FFFFF</translation>
    </message>
    <message>
        <source>this is no program for the drive: there are no vectors of an STM32 at 0x08000000. Make the Intel HEX file with: arm-none-eabi-objcopy -O ihex abstract_DC_drive.elf</source>
        <translation>das ist kein Programm für den Antrieb: bei 0x08000000 stehen keine Vektoren eines STM32. Die Intel-HEX-Datei erzeugen mit: arm-none-eabi-objcopy -O ihex abstract_DC_drive.elf</translation>
    </message>
    <message>
        <source>Velocity loop</source>
        <translation>Drehzahlregler</translation>
    </message>
    <message>
        <source>Current loop</source>
        <translation>Stromregler</translation>
    </message>
    <message>
        <source>Position loop</source>
        <translation>Positionsregler</translation>
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
        <source>Divisor</source>
        <translation>Divisor</translation>
    </message>
    <message>
        <source>Output (255 = 100 %) per unit of error, times the divisor. Above 32767 the output wraps to full reverse: the program keeps set-points close enough to the motor for that.</source>
        <translation>Ausgang (255 = 100 %) je Einheit der Abweichung, mal Divisor. Über 32767 schlägt der Ausgang auf voll rückwärts um: das Programm hält die Sollwerte dafür nah genug am Motor.</translation>
    </message>
    <message>
        <source>Output per unit of error and millisecond, times the divisor. Each step of 20 ms is cut to a whole number, so small gains do nothing, and nothing limits the sum.</source>
        <translation>Ausgang je Einheit der Abweichung und Millisekunde, mal Divisor. Jeder Schritt von 20 ms wird auf eine ganze Zahl abgeschnitten, kleine Verstärkungen bewirken also nichts, und nichts begrenzt die Summe.</translation>
    </message>
    <message>
        <source>Output times milliseconds per change of error, times the divisor. Its sign is inverted in the drive: only negative numbers damp.</source>
        <translation>Ausgang mal Millisekunden je Änderung der Abweichung, mal Divisor. Das Vorzeichen ist im Antrieb umgekehrt: nur negative Zahlen dämpfen.</translation>
    </message>
    <message>
        <source>Averaging</source>
        <translation>Mittelung</translation>
    </message>
    <message>
        <source>It answers, but not as any known dialect; it can be watched but not driven.</source>
        <translation>Antwortet, aber in keinem bekannten Dialekt; lässt sich beobachten, aber nicht ansteuern.</translation>
    </message>
    <message>
        <source>Speaks the firmware&apos;s codes, not the document&apos;s.</source>
        <translation>Spricht die Codes der Firmware, nicht die des Dokuments.</translation>
    </message>
    <message>
        <source>Speaks the legacy frames of 8 bytes, as the published master does.</source>
        <translation>Spricht die alten Frames mit 8 Byte, wie der veröffentlichte Master.</translation>
    </message>
    <message>
        <source>So old that nothing but its power stops it; it can be watched but not driven.</source>
        <translation>So alt, dass nur Trennen der Versorgung ihn stoppt; lässt sich beobachten, aber nicht ansteuern.</translation>
    </message>
    <message>
        <source>Speaks the document&apos;s codes, which no published firmware does.</source>
        <translation>Spricht die Codes des Dokuments, was keine veröffentlichte Firmware tut.</translation>
    </message>
    <message>
        <source>Abstract DC Drives are found on CAN links only</source>
        <translation>Abstract DC Drives gibt es nur an CAN-Verbindungen</translation>
    </message>
    <message>
        <source>the ramp must be 0 or a positive number of duty per second</source>
        <translation>die Rampe ist 0 oder ein positiver Tastgrad pro Sekunde</translation>
    </message>
    <message>
        <source>count/100&#xa0;ms</source>
        <translation>count/100&#xa0;ms</translation>
    </message>
    <message>
        <source>A</source>
        <translation>A</translation>
    </message>
    <message>
        <source>loop</source>
        <translation>Zyklus</translation>
    </message>
    <message>
        <source>Status bits</source>
        <translation>Statusbits</translation>
    </message>
    <message>
        <source>Channel 1</source>
        <translation>Kanal 1</translation>
    </message>
    <message>
        <source>Channel 2</source>
        <translation>Kanal 2</translation>
    </message>
    <message>
        <source>Channel 3</source>
        <translation>Kanal 3</translation>
    </message>
    <message>
        <source>Channel 4</source>
        <translation>Kanal 4</translation>
    </message>
    <message>
        <source>Stream and velocity</source>
        <translation>Stream und Drehzahl</translation>
    </message>
    <message>
        <source>disabled</source>
        <translation>abgeschaltet</translation>
    </message>
    <message>
        <source>home switch</source>
        <translation>Referenzschalter</translation>
    </message>
    <message>
        <source>index pulse</source>
        <translation>Indexpuls</translation>
    </message>
    <message>
        <source>both edges</source>
        <translation>beide Flanken</translation>
    </message>
    <message>
        <source>Of the position loop, in the board&apos;s own units, whose scale is not documented. Cannot be read back; the four are sent together.</source>
        <translation>Des Positionsreglers, in eigenen Einheiten der Platine mit undokumentierter Skalierung. Nicht rücklesbar; die vier werden zusammen gesendet.</translation>
    </message>
    <message>
        <source>Bound of the position loop&apos;s integral, in power units: 8191 is full power. Cannot be read back.</source>
        <translation>Grenze des Integrals im Positionsregler, in Leistungseinheiten: 8191 ist volle Leistung. Nicht rücklesbar.</translation>
    </message>
    <message>
        <source>Of the velocity loop, in the board&apos;s own units, whose scale is not documented. Cannot be read back; the three are sent together.</source>
        <translation>Des Drehzahlreglers, in eigenen Einheiten der Platine mit undokumentierter Skalierung. Nicht rücklesbar; die drei werden zusammen gesendet.</translation>
    </message>
    <message>
        <source>Greatest power in every mode, 1 is full. What the board starts with is not documented: begin small. Cannot be read back.</source>
        <translation>Größte Leistung in jeder Betriebsart, 1 ist voll. Womit die Platine startet, ist nicht dokumentiert: klein beginnen. Nicht rücklesbar.</translation>
    </message>
    <message>
        <source>Greatest speed in both closed loops. What the board starts with is not documented. Cannot be read back.</source>
        <translation>Größte Drehzahl bei beiden Regelungen. Womit die Platine startet, ist nicht dokumentiert. Nicht rücklesbar.</translation>
    </message>
    <message>
        <source>Greatest acceleration in both closed loops; 0 is no limit. Cannot be read back.</source>
        <translation>Größte Beschleunigung bei beiden Regelungen; 0 ist keine Grenze. Nicht rücklesbar.</translation>
    </message>
    <message>
        <source>What the input of the channel is for. Cannot be read back; the five values of an input are sent together.</source>
        <translation>Wozu der Eingang des Kanals dient. Nicht rücklesbar; die fünf Werte eines Eingangs werden zusammen gesendet.</translation>
    </message>
    <message>
        <source>Distance between the two ends of the switch; 0 is a single end stop. Cannot be read back.</source>
        <translation>Abstand zwischen den beiden Enden des Schalters; 0 ist ein einzelner Endanschlag. Nicht rücklesbar.</translation>
    </message>
    <message>
        <source>What the counter becomes at the edge. Cannot be read back.</source>
        <translation>Welchen Wert der Zähler an der Flanke annimmt. Nicht rücklesbar.</translation>
    </message>
    <message>
        <source>What the board sends of this channel: bits 0 and 1 size of the position, 2 relative, 3 velocity, 5 status. The program needs the full position.</source>
        <translation>Was die Platine von diesem Kanal sendet: Bits 0 und 1 Größe der Position, 2 relativ, 3 Drehzahl, 5 Status. Das Programm braucht die volle Position.</translation>
    </message>
    <message>
        <source>The encoder&apos;s counter. Writing it moves the zero, not the motor.</source>
        <translation>Der Zähler des Encoders. Schreiben verschiebt den Nullpunkt, nicht den Motor.</translation>
    </message>
    <message>
        <source>Of the telemetry, in units of 40.96 µs: 244 is 10 ms, 49 is 2 ms, 0 is off.</source>
        <translation>Der Telemetrie, in Einheiten von 40,96 µs: 244 ist 10 ms, 49 ist 2 ms, 0 ist aus.</translation>
    </message>
    <message>
        <source>What a stream packet has besides: bit 0 timing, bit 1 number of skipped periods.</source>
        <translation>Was ein Stream-Paket außerdem enthält: Bit 0 Zeitangabe, Bit 1 Anzahl übersprungener Perioden.</translation>
    </message>
    <message>
        <source>Edges, times four, over which velocity is measured: fewer is faster and coarser. 8 is good for tuning.</source>
        <translation>Flanken, mal vier, über die die Drehzahl gemessen wird: weniger ist schneller und gröber. 8 ist gut zum Abstimmen.</translation>
    </message>
    <message>
        <source>Longest time over which velocity is measured: 2 to this power, times 0.64 µs; 20 is 671 ms.</source>
        <translation>Längste Zeit, über die die Drehzahl gemessen wird: 2 hoch diese Zahl, mal 0,64 µs; 20 ist 671 ms.</translation>
    </message>
    <message>
        <source>Position P</source>
        <translation>Position P</translation>
    </message>
    <message>
        <source>Position I</source>
        <translation>Position I</translation>
    </message>
    <message>
        <source>Position D</source>
        <translation>Position D</translation>
    </message>
    <message>
        <source>Position windup</source>
        <translation>Position Windup</translation>
    </message>
    <message>
        <source>Velocity P</source>
        <translation>Drehzahl P</translation>
    </message>
    <message>
        <source>Velocity I</source>
        <translation>Drehzahl I</translation>
    </message>
    <message>
        <source>Velocity D</source>
        <translation>Drehzahl D</translation>
    </message>
    <message>
        <source>Power limit</source>
        <translation>Leistungsgrenze</translation>
    </message>
    <message>
        <source>Velocity limit</source>
        <translation>Drehzahlgrenze</translation>
    </message>
    <message>
        <source>Acceleration limit</source>
        <translation>Beschleunigungsgrenze</translation>
    </message>
    <message>
        <source>Input mode</source>
        <translation>Eingang Funktion</translation>
    </message>
    <message>
        <source>Input polarity</source>
        <translation>Eingang Polarität</translation>
    </message>
    <message>
        <source>Input edge</source>
        <translation>Eingang Flanke</translation>
    </message>
    <message>
        <source>Input spacing</source>
        <translation>Eingang Abstand</translation>
    </message>
    <message>
        <source>Input position</source>
        <translation>Eingang Position</translation>
    </message>
    <message>
        <source>Data mask</source>
        <translation>Datenmaske</translation>
    </message>
    <message>
        <source>Position counter</source>
        <translation>Positionszähler</translation>
    </message>
    <message>
        <source>Stream period</source>
        <translation>Stream-Periode</translation>
    </message>
    <message>
        <source>Stream contents</source>
        <translation>Stream-Inhalt</translation>
    </message>
    <message>
        <source>History length</source>
        <translation>Verlaufslänge</translation>
    </message>
    <message>
        <source>History time bits</source>
        <translation>Verlaufszeit-Bits</translation>
    </message>
    <message>
        <source>Velocity as reported</source>
        <translation>Drehzahl wie gemeldet</translation>
    </message>
    <message>
        <source>Position in the turn</source>
        <translation>Position in der Umdrehung</translation>
    </message>
    <message>
        <source>Analog input 1</source>
        <translation>Analogeingang 1</translation>
    </message>
    <message>
        <source>Analog input 2</source>
        <translation>Analogeingang 2</translation>
    </message>
    <message>
        <source>Analog input 3</source>
        <translation>Analogeingang 3</translation>
    </message>
    <message>
        <source>Analog input 4</source>
        <translation>Analogeingang 4</translation>
    </message>
    <message>
        <source>Digital inputs</source>
        <translation>Digitaleingänge</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>Regler</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>Digital lines</source>
        <translation>Digitalleitungen</translation>
    </message>
    <message>
        <source>Bus</source>
        <translation>Bus</translation>
    </message>
    <message>
        <source>Errors</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>D1, D2: 1/65280 of full output per count of error; 4000 is full output at 16 counts. The scale of D3 is not documented.</source>
        <translation>D1, D2: 1/65280 des vollen Ausgangs je count Abweichung; 4000 ist voller Ausgang bei 16 counts. Die Skalierung bei D3 ist nicht dokumentiert.</translation>
    </message>
    <message>
        <source>D1, D2: 1/16711680 of full output per count of error and loop of 1.024 ms. The bound of the integral follows P at the next restart only.</source>
        <translation>D1, D2: 1/16711680 des vollen Ausgangs je count Abweichung und Zyklus von 1,024 ms. Die Grenze des Integrals folgt P erst beim nächsten Neustart.</translation>
    </message>
    <message>
        <source>D1, D2: 1/65280 of full output per count that the error changes in one loop of 1.024 ms.</source>
        <translation>D1, D2: 1/65280 des vollen Ausgangs je count, um den sich die Abweichung in einem Zyklus von 1,024 ms ändert.</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>Beschleunigung</translation>
    </message>
    <message>
        <source>Of profiled moves. D1: at most 65535.</source>
        <translation>Bei Bewegungen mit Profil. D1: höchstens 65535.</translation>
    </message>
    <message>
        <source>Firmware of D1 and D2 stores it and does not limit anything.</source>
        <translation>Die Firmware von D1 und D2 speichert es und begrenzt nichts.</translation>
    </message>
    <message>
        <source>Time above the limit</source>
        <translation>Zeit über der Grenze</translation>
    </message>
    <message>
        <source>In force after a restart. D1 and D2 take it for the current limit until then; the limit is therefore written again behind it.</source>
        <translation>Gilt nach einem Neustart. D1 und D2 nehmen sie bis dahin als Stromgrenze; die Grenze wird deshalb danach noch einmal geschrieben.</translation>
    </message>
    <message>
        <source>Outputs among the lines</source>
        <translation>Leitungen als Ausgang</translation>
    </message>
    <message>
        <source>1, 2, 4, 8 for DIO1 to DIO4; a set bit makes an output. DIO1 and DIO3 low for 3 s start the analog programming of the device, DIO2 and DIO4 low restore its factory settings.</source>
        <translation>1, 2, 4, 8 für DIO1 bis DIO4; ein gesetztes Bit macht einen Ausgang. DIO1 und DIO3 3 s auf low starten die analoge Programmierung des Geräts, DIO2 und DIO4 auf low stellen die Werkseinstellungen wieder her.</translation>
    </message>
    <message>
        <source>Levels of the outputs</source>
        <translation>Pegel der Ausgänge</translation>
    </message>
    <message>
        <source>Bits as for the directions; inputs ignore theirs. Cannot be read back and is lost at power-off.</source>
        <translation>Bits wie bei den Richtungen; Eingänge ignorieren ihre. Nicht rücklesbar, geht beim Ausschalten verloren.</translation>
    </message>
    <message>
        <source>Node id</source>
        <translation>Knoten-ID</translation>
    </message>
    <message>
        <source>Its address on the line. In force after a restart; until then it answers under the old one.</source>
        <translation>Die Adresse an der Leitung. Gilt nach einem Neustart; bis dahin antwortet das Gerät unter der alten.</translation>
    </message>
    <message>
        <source>Acceptance mask</source>
        <translation>Akzeptanzmaske</translation>
    </message>
    <message>
        <source>Bits of an address that count. 255: only its own; less makes a group that acts on what is sent to any of its members, and on their answers. In force after a restart.</source>
        <translation>Bits einer Adresse, die zählen. 255: nur die eigene; weniger bildet eine Gruppe, die ausführt, was an eines ihrer Mitglieder gesendet wird, und auch auf deren Antworten reagiert. Gilt nach einem Neustart.</translation>
    </message>
    <message>
        <source>Bit rate</source>
        <translation>Bitrate</translation>
    </message>
    <message>
        <source>In force after a restart. Reads as the rate at which it answers. 115200 is really 119048: prefer 57600.</source>
        <translation>Gilt nach einem Neustart. Gelesen wird die Rate, mit der das Gerät antwortet. 115200 ist tatsächlich 119048: besser 57600.</translation>
    </message>
    <message>
        <source>Error level</source>
        <translation>Fehlerstufe</translation>
    </message>
    <message>
        <source>D1 and D2. Level 1 would make every reading fail, so only 0 is offered: write it where another program set 1.</source>
        <translation>D1 und D2. Bei Stufe 1 schlüge jedes Lesen fehl, daher wird nur 0 angeboten: schreiben, wo ein anderes Programm 1 gesetzt hat.</translation>
    </message>
    <message>
        <source>Reactions to errors</source>
        <translation>Reaktionen auf Fehler</translation>
    </message>
    <message>
        <source>D3. Two bits for each of 20 errors, the first lowest: 0 nothing, 1 stop, 2 halt. Which error is which is not documented.</source>
        <translation>D3. Zwei Bits für jeden von 20 Fehlern, der erste zuunterst: 0 nichts, 1 Stopp, 2 Halt. Welcher Fehler welcher ist, ist nicht dokumentiert.</translation>
    </message>
    <message>
        <source>Anti-windup</source>
        <translation>Anti-Windup</translation>
    </message>
    <message>
        <source>D3. Bound of the integral; its scale is not documented.</source>
        <translation>D3. Grenze des Integrals; ihre Skalierung ist nicht dokumentiert.</translation>
    </message>
    <message>
        <source>D1 and D2: what one count of the current converter stands for; D3 tells ampere.</source>
        <translation>D1 und D2: wofür ein Count des Stromwandlers steht; D3 nennt Ampere.</translation>
    </message>
    <message>
        <source>%1 is being recorded already</source>
        <translation>%1 wird bereits aufgenommen</translation>
    </message>
    <message>
        <source>the recording has ended: %1</source>
        <translation>die Aufnahme ist beendet: %1</translation>
    </message>
    <message>
        <source>%1 frames recorded, none is missing</source>
        <translation>%1 Frames aufgenommen, keiner fehlt</translation>
    </message>
    <message>
        <source>%1 frames recorded, %2 are missing</source>
        <translation>%1 Frames aufgenommen, %2 fehlen</translation>
    </message>
    <message>
        <source>several units answer under this number in the recording</source>
        <translation>mehrere Geräte antworten in der Aufnahme unter dieser Nummer</translation>
    </message>
    <message>
        <source>%1 written; they cannot be read back</source>
        <translation>%1 geschrieben; nicht rücklesbar</translation>
    </message>
    <message>
        <source>%1 written; %2 of them cannot be read back</source>
        <translation>%1 geschrieben; %2 davon nicht rücklesbar</translation>
    </message>
    <message>
        <source>Write settings again</source>
        <translation>Einstellungen erneut schreiben</translation>
    </message>
    <message>
        <source>%1 settings written again</source>
        <translation>%1 Einstellungen erneut geschrieben</translation>
    </message>
    <message>
        <source>stop the motors before settings are written again</source>
        <translation>vor dem erneuten Schreiben der Einstellungen die Motoren stoppen</translation>
    </message>
    <message>
        <source>the settings that the reset took are written again</source>
        <translation>die durch den Reset verlorenen Einstellungen werden erneut geschrieben</translation>
    </message>
    <message>
        <source>stop the motor before an experiment begins</source>
        <translation>vor Beginn eines Versuchs den Motor stoppen</translation>
    </message>
    <message>
        <source>stop the motors first</source>
        <translation>zuerst die Motoren stoppen</translation>
    </message>
    <message>
        <source>looking at the status bit</source>
        <translation>das Statusbit wird angesehen</translation>
    </message>
    <message>
        <source>polarity bit %1: the input is active</source>
        <translation>Polaritätsbit %1: der Eingang ist aktiv</translation>
    </message>
    <message>
        <source>polarity bit %1: the input is not active</source>
        <translation>Polaritätsbit %1: der Eingang ist nicht aktiv</translation>
    </message>
    <message>
        <source>polarity 0 is active high: the board follows the maker&apos;s library</source>
        <translation>Polarität 0 ist high-aktiv: die Platine folgt der Bibliothek des Herstellers</translation>
    </message>
    <message>
        <source>polarity 0 is active low: the board follows the data sheet</source>
        <translation>Polarität 0 ist low-aktiv: die Platine folgt dem Datenblatt</translation>
    </message>
    <message>
        <source>turning the motor with several powers</source>
        <translation>dreht den Motor mit verschiedenen Leistungen</translation>
    </message>
    <message>
        <source>looking for velocity P</source>
        <translation>sucht Drehzahl P</translation>
    </message>
    <message>
        <source>looking for velocity I</source>
        <translation>sucht Drehzahl I</translation>
    </message>
    <message>
        <source>looking for position P</source>
        <translation>sucht Position P</translation>
    </message>
    <message>
        <source>looking for position I</source>
        <translation>sucht Position I</translation>
    </message>
    <message>
        <source>looking for position D</source>
        <translation>sucht Position D</translation>
    </message>
    <message>
        <source>putting the settings back</source>
        <translation>stellt die Einstellungen wieder her</translation>
    </message>
    <message>
        <source>position D has no effect that could be measured; its scale stays unknown</source>
        <translation>Position D hat keine messbare Wirkung; die Skalierung bleibt unbekannt</translation>
    </message>
    <message>
        <source>power %1: %2 and %3 counts/s</source>
        <translation>Leistung %1: %2 und %3 counts/s</translation>
    </message>
    <message>
        <source>the axis has a power limit of %1 %, which is kept</source>
        <translation>die Achse hat eine Leistungsgrenze von %1 %, sie wird eingehalten</translation>
    </message>
    <message>
        <source>the motor gives %1 counts/s per power unit, friction takes %2 units, it follows within %3 ms</source>
        <translation>der Motor erreicht %1 counts/s je Leistungseinheit, die Reibung braucht %2 Einheiten, er folgt innerhalb von %3 ms</translation>
    </message>
    <message>
        <source>the motors were told to stop, and are not seen to stand</source>
        <translation>den Motoren wurde Stopp befohlen, ihr Stillstand ist nicht zu erkennen</translation>
    </message>
    <message>
        <source>the motor was stopped: %1</source>
        <translation>der Motor wurde gestoppt: %1</translation>
    </message>
    <message>
        <source>no gain of the position loop turns the motor</source>
        <translation>keine Verstärkung des Positionsreglers dreht den Motor</translation>
    </message>
    <message>
        <source>the gain scale is too coarse to be measured with so little power</source>
        <translation>die Skalierung der Verstärkung ist zu grob, um mit so wenig Leistung gemessen zu werden</translation>
    </message>
    <message>
        <source>the motor turned too short a time below the power limit to be measured</source>
        <translation>der Motor drehte sich zu kurz unterhalb der Leistungsgrenze, um gemessen zu werden</translation>
    </message>
    <message>
        <source>the gains found at different values do not agree, so that a gain is no simple factor</source>
        <translation>die bei verschiedenen Werten gefundenen Verstärkungen stimmen nicht überein, eine Verstärkung ist also kein einfacher Faktor</translation>
    </message>
    <message>
        <source>the board does not tell its position</source>
        <translation>die Platine nennt ihre Position nicht</translation>
    </message>
    <message>
        <source>the transcript of the update is in %1</source>
        <translation>die Mitschrift des Updates steht in %1</translation>
    </message>
    <message>
        <source>the transcript of the update is not kept: %1</source>
        <translation>die Mitschrift des Updates wird nicht aufbewahrt: %1</translation>
    </message>
    <message>
        <source>the jumper is still in: take it out, then reset the board</source>
        <translation>die Steckbrücke steckt noch: abziehen, dann die Platine zurücksetzen</translation>
    </message>
    <message>
        <source>%1: legal is %2</source>
        <translation>%1: zulässig ist %2</translation>
    </message>
    <message>
        <source>%1 is lost: %2; waiting up to %3 for it to come back</source>
        <translation>%1 ist verloren: %2; warte bis zu %3 auf die Rückkehr</translation>
    </message>
    <message>
        <source>Wait for %1</source>
        <translation>Auf %1 warten</translation>
    </message>
    <message>
        <source>%1 is back</source>
        <translation>%1 ist wieder da</translation>
    </message>
    <message>
        <source>all pages are in the unit</source>
        <translation>alle Seiten sind im Gerät</translation>
    </message>
    <message>
        <source>the unit may have restarted meanwhile: once more from page %1</source>
        <translation>das Gerät ist inzwischen wohl neu gestartet: noch einmal ab Seite %1</translation>
    </message>
    <message>
        <source>The adapter has no %1 bit/s</source>
        <translation>Der Adapter kann keine %1 bit/s</translation>
    </message>
    <message>
        <source>the search was cancelled; what it found stays</source>
        <translation>die Suche wurde abgebrochen; was sie gefunden hat, bleibt</translation>
    </message>
    <message>
        <source>the stop was not acknowledged, so the position was not reset: a motor that runs would jump</source>
        <translation>der Stopp wurde nicht bestätigt, daher wurde die Position nicht zurückgesetzt: ein laufender Motor würde springen</translation>
    </message>
    <message>
        <source>%1 has no command that zeroes its position</source>
        <translation>%1 hat keinen Befehl, der die Position auf null setzt</translation>
    </message>
    <message>
        <source>%1 is no list of devices and is ignored: the next scan takes its full time and writes it anew</source>
        <translation>%1 ist keine Geräteliste und wird ignoriert: die nächste Suche dauert ihre volle Zeit und schreibt sie neu</translation>
    </message>
    <message>
        <source>The recording does not tell which codes it speaks: it was asked for what all answer alike.</source>
        <translation>Aus der Aufnahme geht nicht hervor, welche Codes das Gerät spricht: abgefragt wurde, was alle gleich beantworten.</translation>
    </message>
    <message>
        <source>Drives of two dialects answer with this offset in the recording.</source>
        <translation>In der Aufnahme antworten Antriebe zweier Dialekte mit diesem Offset.</translation>
    </message>
    <message>
        <source>counts/s (safe)</source>
        <translation>counts/s (sicher)</translation>
    </message>
    <message>
        <source>counts/s × 4096</source>
        <translation>counts/s × 4096</translation>
    </message>
    <message>
        <source>as the library</source>
        <translation>wie die Bibliothek</translation>
    </message>
    <message>
        <source>as the data sheet</source>
        <translation>wie das Datenblatt</translation>
    </message>
    <message>
        <source>The data sheet contradicts itself on velocity targets. With plain counts/s a board that wants × 4096 hardly moves; the opposite mistake asks for full speed. Change it only when a board hardly moves, and with a small power limit.</source>
        <translation>Das Datenblatt widerspricht sich bei den Drehzahlsollwerten. Mit einfachen counts/s bewegt sich eine Platine, die × 4096 erwartet, kaum; der umgekehrte Fehler fordert volle Drehzahl. Nur ändern, wenn sich eine Platine kaum bewegt, und mit kleiner Leistungsgrenze.</translation>
    </message>
    <message>
        <source>Data sheet and the maker&apos;s library give polarity and edges of the inputs opposite bits. The library is more likely right; an experiment with the status bit tells.</source>
        <translation>Datenblatt und Bibliothek des Herstellers geben Polarität und Flanken der Eingänge mit entgegengesetzten Bits an. Eher stimmt die Bibliothek; ein Versuch mit dem Statusbit klärt es.</translation>
    </message>
    <message>
        <source>Power units (8191 is full power) that a raw gain of 1 gives. The maker does not tell; an experiment finds it.</source>
        <translation>Leistungseinheiten (8191 ist volle Leistung), die eine rohe Verstärkung von 1 ergibt. Der Hersteller nennt sie nicht; ein Versuch ermittelt sie.</translation>
    </message>
    <message>
        <source>velocity target</source>
        <translation>Drehzahlsollwert</translation>
    </message>
    <message>
        <source>input polarity</source>
        <translation>Eingangspolarität</translation>
    </message>
    <message>
        <source>velocity P scale</source>
        <translation>Skalierung Drehzahl P</translation>
    </message>
    <message>
        <source>velocity I scale</source>
        <translation>Skalierung Drehzahl I</translation>
    </message>
    <message>
        <source>position P scale</source>
        <translation>Skalierung Position P</translation>
    </message>
    <message>
        <source>position I scale</source>
        <translation>Skalierung Position I</translation>
    </message>
    <message>
        <source>position D scale</source>
        <translation>Skalierung Position D</translation>
    </message>
    <message>
        <source>open: nothing is connected, the pin is high</source>
        <translation>offen: nichts ist angeschlossen, der Pin ist high</translation>
    </message>
    <message>
        <source>connected to GND: the pin is low</source>
        <translation>mit GND verbunden: der Pin ist low</translation>
    </message>
    <message>
        <source>Find the gain scales</source>
        <translation>Skalierung der Verstärkungen ermitteln</translation>
    </message>
    <message>
        <source>The maker does not tell what a raw gain is worth. The motor of one axis is turned to and fro for one to two minutes, with the power that you allow here: first with constant power, then with one gain alone at a time, which grows until the motor moves. The shaft must turn freely, some turns each way, and nobody may touch it. Gains and limits are put back at the end.</source>
        <translation>Der Hersteller nennt nicht, was eine rohe Verstärkung wert ist. Der Motor einer Achse wird ein bis zwei Minuten lang hin und her gedreht, mit der hier zugelassenen Leistung: zuerst mit konstanter Leistung, dann mit jeweils nur einer Verstärkung, die wächst, bis sich der Motor bewegt. Die Welle muss frei drehen, einige Umdrehungen in jede Richtung, und niemand darf sie berühren. Verstärkungen und Grenzen werden am Ende wiederhergestellt.</translation>
    </message>
    <message>
        <source>Find the input polarity</source>
        <translation>Polarität des Eingangs ermitteln</translation>
    </message>
    <message>
        <source>Data sheet and the maker&apos;s library give the polarity of the inputs opposite bits. The input of one axis is set up with both, and the status bit tells which of them is active at the level that the pin has. Nothing moves, the counter stays, and the input is set up afterwards as it was.</source>
        <translation>Datenblatt und Bibliothek des Herstellers geben die Polarität der Eingänge mit entgegengesetzten Bits an. Der Eingang einer Achse wird mit beiden eingerichtet, und das Statusbit zeigt, welche davon bei dem Pegel aktiv ist, den der Pin hat. Nichts bewegt sich, der Zähler bleibt, und der Eingang wird danach wieder wie zuvor eingerichtet.</translation>
    </message>
    <message>
        <source>The input pin of this axis is</source>
        <translation>Der Eingangspin dieser Achse ist</translation>
    </message>
    <message>
        <source>Close the jumper</source>
        <translation>Steckbrücke stecken</translation>
    </message>
    <message>
        <source>Put a jumper on AUX1 and AUX2. The serial adapter has 3.3 V levels, its TX goes to RX and its RX to TX; the board gets 3.3 V only.</source>
        <translation>Eine Steckbrücke auf AUX1 und AUX2 stecken. Der serielle Adapter hat 3,3-V-Pegel, sein TX geht an RX und sein RX an TX; die Platine erhält nur 3,3 V.</translation>
    </message>
    <message>
        <source>Reset the board</source>
        <translation>Platine zurücksetzen</translation>
    </message>
    <message>
        <source>Press its reset, or switch it off and on. Where the reset line is wired, this program pulses it.</source>
        <translation>Ihren Reset drücken oder sie aus- und einschalten. Ist die Reset-Leitung angeschlossen, gibt dieses Programm einen Impuls darauf.</translation>
    </message>
    <message>
        <source>The bootloader greets</source>
        <translation>Der Bootloader meldet sich</translation>
    </message>
    <message>
        <source>Its greeting on the serial port holds the word &quot;bootloader&quot;.</source>
        <translation>Seine Begrüßung an der seriellen Schnittstelle enthält das Wort „bootloader“.</translation>
    </message>
    <message>
        <source>The file is sent</source>
        <translation>Die Datei wird gesendet</translation>
    </message>
    <message>
        <source>Line by line, each after the confirmation of the one before. Leave the jumper where it is.</source>
        <translation>Zeile für Zeile, jede nach der Bestätigung der vorigen. Die Steckbrücke stecken lassen.</translation>
    </message>
    <message>
        <source>Take the jumper out</source>
        <translation>Steckbrücke abziehen</translation>
    </message>
    <message>
        <source>Then the board starts its new firmware. If it does not, reset it once more.</source>
        <translation>Dann startet die Platine ihre neue Firmware. Wenn nicht, noch einmal zurücksetzen.</translation>
    </message>
    <message>
        <source>The version is compared</source>
        <translation>Die Version wird verglichen</translation>
    </message>
    <message>
        <source>The board is asked for it over SPI.</source>
        <translation>Sie wird über SPI von der Platine abgefragt.</translation>
    </message>
    <message>
        <source>baud rate</source>
        <translation>Übertragungsrate</translation>
    </message>
    <message>
        <source>From the data sheet.</source>
        <translation>Aus dem Datenblatt.</translation>
    </message>
    <message>
        <source>format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>Data bits, parity, stop bits. Not told.</source>
        <translation>Datenbits, Parität, Stoppbits. Nicht angegeben.</translation>
    </message>
    <message>
        <source>line ending</source>
        <translation>Zeilenende</translation>
    </message>
    <message>
        <source>Not told; the terminal program that the data sheet names sends cr.</source>
        <translation>Nicht angegeben; das im Datenblatt genannte Terminalprogramm sendet cr.</translation>
    </message>
    <message>
        <source>greeting holds</source>
        <translation>Begrüßung enthält</translation>
    </message>
    <message>
        <source>The data sheet tells this word, and not the whole greeting.</source>
        <translation>Das Datenblatt nennt dieses Wort, nicht aber die ganze Begrüßung.</translation>
    </message>
    <message>
        <source>refusal holds</source>
        <translation>Ablehnung enthält</translation>
    </message>
    <message>
        <source>Not told. Words with | between them, in whatever case.</source>
        <translation>Nicht angegeben. Wörter, durch | getrennt, Groß- und Kleinschreibung beliebig.</translation>
    </message>
    <message>
        <source>pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Least time from one line to the next in milliseconds, from the data sheet.</source>
        <translation>Mindestzeit von einer Zeile zur nächsten in Millisekunden, aus dem Datenblatt.</translation>
    </message>
    <message>
        <source>leaves with</source>
        <translation>verlassen mit</translation>
    </message>
    <message>
        <source>Typed at the end. &quot;none&quot; leaves it to jumper and reset.</source>
        <translation>Wird am Ende eingegeben. „none“ überlässt es Steckbrücke und Reset.</translation>
    </message>
    <message>
        <source>active high</source>
        <translation>high-aktiv</translation>
    </message>
    <message>
        <source>active low</source>
        <translation>low-aktiv</translation>
    </message>
    <message>
        <source>record at the positive end</source>
        <translation>am positiven Ende aufzeichnen</translation>
    </message>
    <message>
        <source>set at the positive end</source>
        <translation>am positiven Ende setzen</translation>
    </message>
    <message>
        <source>record at the negative end</source>
        <translation>am negativen Ende aufzeichnen</translation>
    </message>
    <message>
        <source>set at the negative end</source>
        <translation>am negativen Ende setzen</translation>
    </message>
    <message>
        <source>At which level the input is active. Data sheet and the maker&apos;s library say it with opposite bits: which one the board follows is a setting of the device, and an experiment tells.</source>
        <translation>Bei welchem Pegel der Eingang aktiv ist. Datenblatt und Bibliothek des Herstellers geben es mit entgegengesetzten Bits an: welchem die Platine folgt, ist eine Einstellung des Geräts, und ein Versuch klärt es.</translation>
    </message>
    <message>
        <source>At which end of the switch the position is recorded, or also set as the counter. Data sheet and library disagree, as for the polarity.</source>
        <translation>An welchem Ende des Schalters die Position aufgezeichnet oder auch als Zähler gesetzt wird. Datenblatt und Bibliothek widersprechen sich, wie bei der Polarität.</translation>
    </message>
    <message>
        <source>serial bootloader</source>
        <translation>serieller Bootloader</translation>
    </message>
    <message>
        <source>serial bootloader, without reset</source>
        <translation>serieller Bootloader, ohne Reset</translation>
    </message>
    <message>
        <source>one update a bus: %1 is being written; nothing was sent</source>
        <translation>eine Aktualisierung je Bus: %1 wird gerade beschrieben; nichts wurde gesendet</translation>
    </message>
    <message>
        <source>it is not proven which codes it speaks, and a stop of others may start it</source>
        <translation>es ist nicht erwiesen, welche Codes er spricht, und ein Stopp mit anderen kann ihn starten</translation>
    </message>
    <message>
        <source>dialect LL has no code for stop</source>
        <translation>Dialekt LL hat keinen Code für Stopp</translation>
    </message>
    <message>
        <source>the motors that were not seen to stand were looked at; their stops are dismissed</source>
        <translation>nach den Motoren, die niemand stehen sah, wurde gesehen; ihr Stopp ist erledigt</translation>
    </message>
    <message>
        <source>the stop could not be sent, and is the first thing that goes out when the line is back; cut its power</source>
        <translation>der Stopp konnte nicht gesendet werden und geht als Erstes hinaus, wenn die Leitung wieder da ist; Strom abschalten</translation>
    </message>
    <message>
        <source>was not seen to stop: the motor may still turn, cut its power</source>
        <translation>wurde nicht stehen gesehen: der Motor läuft vielleicht noch, Strom abschalten</translation>
    </message>
    <message>
        <source>gave no sign after the stop; its own watchdog switches it off</source>
        <translation>gab nach dem Stopp kein Zeichen; sein eigener Watchdog schaltet ihn ab</translation>
    </message>
    <message>
        <source>gave no sign after the stop</source>
        <translation>gab nach dem Stopp kein Zeichen</translation>
    </message>
    <message>
        <source>was seen to stand</source>
        <translation>wurde stehen gesehen</translation>
    </message>
    <message>
        <source>the guardian has stopped the motor</source>
        <translation>der Wächter hat den Motor gestoppt</translation>
    </message>
    <message>
        <source>the guardian tried in vain to stop the motor; it may still turn: cut its power</source>
        <translation>der Wächter wollte den Motor stoppen, vergeblich; er läuft vielleicht noch: Strom abschalten</translation>
    </message>
    <message>
        <source>It is not driven: %1.</source>
        <translation>Dieses Gerät wird nicht angetrieben: %1.</translation>
    </message>
    <message>
        <source>what is sent to node %1 is also done by node %2, now or after a restart, because of an acceptance mask; set its node.mask to 255 and restart it</source>
        <translation>was an Knoten %1 geht, führt wegen einer Akzeptanzmaske auch Knoten %2 aus, jetzt oder nach einem Neustart; dessen node.mask auf 255 setzen und ihn neu starten</translation>
    </message>
    <message>
        <source>every id that this program could use on the line belongs to the group of a node, so answers would be taken for commands; set node.mask to 255 and restart the nodes</source>
        <translation>jede Nummer, die dieses Programm auf der Leitung haben könnte, gehört zur Gruppe eines Knotens, der Antworten für Befehle hielte; node.mask auf 255 setzen und die Knoten neu starten</translation>
    </message>
    <message>
        <source>the profiled move passed its target by more than its stopping distance, as this firmware may above 2500 counts/s; use a lower profile.velocity</source>
        <translation>die Bewegung mit Profil ist um mehr als ihren Bremsweg über das Ziel hinausgegangen, was bei dieser Firmware über 2500 counts/s vorkommt; profile.velocity kleiner wählen</translation>
    </message>
    <message>
        <source>somebody may have started it again, so the position was not reset</source>
        <translation>jemand kann es wieder gestartet haben, deshalb wurde die Position nicht zurückgesetzt</translation>
    </message>
    <message>
        <source>the position was not reset: %1</source>
        <translation>die Position wurde nicht zurückgesetzt: %1</translation>
    </message>
    <message>
        <source>Of profiled moves. D1: at most 65535. D1 and D2 may pass their target above 2500, and compute wrongly from 46340 on.</source>
        <translation>Bei Bewegungen mit Profil. D1: höchstens 65535. D1 und D2 können über 2500 ihr Ziel überfahren und rechnen ab 46340 falsch.</translation>
    </message>
    <message>
        <source>%1 becomes %2, it was %3: the device stores it</source>
        <translation>%1 wird %2, bisher %3: das Gerät speichert es</translation>
    </message>
    <message>
        <source>%1 becomes %2: the device stores it</source>
        <translation>%1 wird %2: das Gerät speichert es</translation>
    </message>
    <message>
        <source>this firmware may pass the target of a profiled move above 2500 counts/s; it is stopped then</source>
        <translation>diese Firmware kann bei einer Bewegung mit Profil über 2500 counts/s das Ziel überfahren; sie wird dann gestoppt</translation>
    </message>
    <message>
        <source>current is limited</source>
        <translation>Strom ist begrenzt</translation>
    </message>
    <message>
        <source>forward limit switch holds</source>
        <translation>Endschalter vorwärts hält</translation>
    </message>
    <message>
        <source>reverse limit switch holds</source>
        <translation>Endschalter rückwärts hält</translation>
    </message>
    <message>
        <source>forward soft limit holds</source>
        <translation>Weggrenze vorwärts hält</translation>
    </message>
    <message>
        <source>reverse soft limit holds</source>
        <translation>Weggrenze rückwärts hält</translation>
    </message>
    <message>
        <source>halted</source>
        <translation>angehalten</translation>
    </message>
    <message>
        <source>the computer slept</source>
        <translation>der Rechner war im Schlafzustand</translation>
    </message>
    <message>
        <source>this computer is not kept awake while motors are driven or firmware is written: %1; switch its automatic suspend off meanwhile</source>
        <translation>dieser Rechner wird nicht wach gehalten, während Motoren laufen oder Firmware geschrieben wird: %1; schalten Sie den automatischen Schlafzustand solange aus</translation>
    </message>
    <message>
        <source>this program was held up for %1 ms, longer than the motor goes without a set-point</source>
        <translation>dieses Programm war %1 ms lang aufgehalten, länger als der Motor ohne Sollwert läuft</translation>
    </message>
    <message>
        <source>found on %1</source>
        <translation>gefunden an %1</translation>
    </message>
    <message>
        <source>does not answer any more</source>
        <translation>antwortet nicht mehr</translation>
    </message>
    <message>
        <source>answers again</source>
        <translation>antwortet wieder</translation>
    </message>
    <message>
        <source>is gone</source>
        <translation>ist weg</translation>
    </message>
    <message>
        <source>Forward limit switch</source>
        <translation>Endschalter vorwärts</translation>
    </message>
    <message>
        <source>Reverse limit switch</source>
        <translation>Endschalter rückwärts</translation>
    </message>
    <message>
        <source>Limit override</source>
        <translation>Endschalter übersteuert</translation>
    </message>
    <message>
        <source>the set-point decides which limit switches count</source>
        <translation>der Sollwert bestimmt, welche Endschalter gelten</translation>
    </message>
    <message>
        <source>Halt</source>
        <translation>Halt</translation>
    </message>
    <message>
        <source>Pin of the forward limit switch</source>
        <translation>Pin des Endschalters vorwärts</translation>
    </message>
    <message>
        <source>Pin of the reverse limit switch</source>
        <translation>Pin des Endschalters rückwärts</translation>
    </message>
    <message>
        <source>Encoder pin A</source>
        <translation>Geberpin A</translation>
    </message>
    <message>
        <source>Encoder pin B</source>
        <translation>Geberpin B</translation>
    </message>
    <message>
        <source>Encoder index pin</source>
        <translation>Indexpin des Gebers</translation>
    </message>
    <message>
        <source>Input</source>
        <translation>Eingang</translation>
    </message>
    <message>
        <source>Digital input 1</source>
        <translation>Digitaleingang 1</translation>
    </message>
    <message>
        <source>Digital input 2</source>
        <translation>Digitaleingang 2</translation>
    </message>
    <message>
        <source>Digital input 3</source>
        <translation>Digitaleingang 3</translation>
    </message>
    <message>
        <source>Digital input 4</source>
        <translation>Digitaleingang 4</translation>
    </message>
    <message>
        <source>the guardian has sent the stop, which nothing on this link confirms; look whether the motor stands</source>
        <translation>der Wächter hat den Stopp gesendet, den auf dieser Verbindung nichts bestätigt; nachsehen, ob der Motor steht</translation>
    </message>
    <message>
        <source>%1 is being opened already</source>
        <translation>%1 wird schon geöffnet</translation>
    </message>
    <message>
        <source>%1 was closed before it was open</source>
        <translation>%1 wurde geschlossen, bevor es offen war</translation>
    </message>
    <message>
        <source>the disk has not taken %1 for 30 s</source>
        <translation>der Datenträger hat %1 seit 30 s nicht angenommen</translation>
    </message>
    <message>
        <source>the guardian stopped the motor because this program was held up</source>
        <translation>der Wächter hat den Motor gestoppt, weil dieses Programm aufgehalten wurde</translation>
    </message>
    <message>
        <source>the guardian sent the stop because this program was held up, not confirmed</source>
        <translation>der Wächter hat den Stopp gesendet, weil dieses Programm aufgehalten wurde; unbestätigt</translation>
    </message>
    <message>
        <source>the guardian tried to stop the motor because this program was held up, without an answer</source>
        <translation>der Wächter hat versucht, den Motor zu stoppen, weil dieses Programm aufgehalten wurde, ohne Antwort</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>von Hand</translation>
    </message>
    <message>
        <source>as found</source>
        <translation>wie vorgefunden</translation>
    </message>
    <message>
        <source>before restore</source>
        <translation>vor dem Zurückschreiben</translation>
    </message>
    <message>
        <source>before import</source>
        <translation>vor dem Import</translation>
    </message>
    <message>
        <source>before tuning</source>
        <translation>vor dem Abstimmen</translation>
    </message>
    <message>
        <source>before update</source>
        <translation>vor dem Update</translation>
    </message>
    <message>
        <source>OpenOCD finds no debug probe</source>
        <translation>OpenOCD findet keinen Debug-Adapter</translation>
    </message>
    <message>
        <source>plug it in, and check that its kind is the one named after openocd:</source>
        <translation>einstecken und prüfen, ob seine Art die hinter openocd: genannte ist</translation>
    </message>
    <message>
        <source>OpenOCD has no interface of this name</source>
        <translation>OpenOCD hat keine Schnittstelle dieses Namens</translation>
    </message>
    <message>
        <source>name one of its interface files, such as openocd:stlink</source>
        <translation>eine seiner Schnittstellendateien nennen, etwa openocd:stlink</translation>
    </message>
    <message>
        <source>this interface does not speak SWD</source>
        <translation>diese Schnittstelle spricht kein SWD</translation>
    </message>
    <message>
        <source>name a debug probe that does, such as openocd:stlink</source>
        <translation>einen Debug-Adapter nennen, der es kann, etwa openocd:stlink</translation>
    </message>
    <message>
        <source>the microcontroller does not hold what was written</source>
        <translation>der Mikrocontroller enthält nicht, was geschrieben wurde</translation>
    </message>
    <message>
        <source>run it again with shorter wires or a lower speed</source>
        <translation>mit kürzeren Leitungen oder geringerer Geschwindigkeit wiederholen</translation>
    </message>
    <message>
        <source>the microcontroller refused to be written</source>
        <translation>der Mikrocontroller ließ sich nicht beschreiben</translation>
    </message>
    <message>
        <source>it may be protected, or be another kind than --target says</source>
        <translation>er ist vielleicht geschützt oder von anderer Art, als --target angibt</translation>
    </message>
    <message>
        <source>the microcontroller is another kind than --target says</source>
        <translation>der Mikrocontroller ist von anderer Art, als --target angibt</translation>
    </message>
    <message>
        <source>choose the other one of f1 and f4</source>
        <translation>das andere von f1 und f4 wählen</translation>
    </message>
    <message>
        <source>the probe is there, but no microcontroller answers it</source>
        <translation>der Debug-Adapter ist da, aber kein Mikrocontroller antwortet ihm</translation>
    </message>
    <message>
        <source>check SWDIO, SWCLK, ground and the power of the drive</source>
        <translation>SWDIO, SWCLK, Masse und die Versorgung des Antriebs prüfen</translation>
    </message>
    <message>
        <source>the microcontroller could not be halted</source>
        <translation>der Mikrocontroller ließ sich nicht anhalten</translation>
    </message>
    <message>
        <source>check the reset wire and the power of the drive</source>
        <translation>Reset-Leitung und Versorgung des Antriebs prüfen</translation>
    </message>
    <message>
        <source>the debug probe is there but may not be opened</source>
        <translation>der Debug-Adapter ist da, darf aber nicht geöffnet werden</translation>
    </message>
    <message>
        <source>install OpenOCD&apos;s udev rules or ask your administrator</source>
        <translation>die udev-Regeln von OpenOCD installieren oder die Systemverwaltung fragen</translation>
    </message>
    <message>
        <source>the port cannot be opened</source>
        <translation>der Anschluss lässt sich nicht öffnen</translation>
    </message>
    <message>
        <source>check its name and that it is plugged in</source>
        <translation>seinen Namen prüfen, und ob er eingesteckt ist</translation>
    </message>
    <message>
        <source>avrdude finds no such programmer on USB</source>
        <translation>avrdude findet kein solches Programmiergerät am USB</translation>
    </message>
    <message>
        <source>plug it in, and check that its kind is the one named after avrdude:</source>
        <translation>es einstecken und prüfen, ob seine Art die hinter avrdude: genannte ist</translation>
    </message>
    <message>
        <source>run it again, with a shorter cable</source>
        <translation>erneut mit kürzerem Kabel versuchen</translation>
    </message>
    <message>
        <source>the programmer is there, but no microcontroller answers it</source>
        <translation>das Programmiergerät ist da, aber kein Mikrocontroller antwortet ihm</translation>
    </message>
    <message>
        <source>check the six pins and the supply</source>
        <translation>die sechs Stifte und die Versorgung prüfen</translation>
    </message>
    <message>
        <source>avrdude knows no programmer of this name</source>
        <translation>avrdude kennt kein Programmiergerät dieses Namens</translation>
    </message>
    <message>
        <source>&apos;avrdude -c ?&apos; lists them</source>
        <translation>&apos;avrdude -c ?&apos; nennt sie</translation>
    </message>
    <message>
        <source>the port may not be opened</source>
        <translation>der Anschluss darf nicht geöffnet werden</translation>
    </message>
    <message>
        <source>add yourself to the group dialout and log in again</source>
        <translation>sich in die Gruppe dialout aufnehmen und neu anmelden</translation>
    </message>
    <message>
        <source>what answers is no ATmega328P</source>
        <translation>was antwortet, ist kein ATmega328P</translation>
    </message>
    <message>
        <source>check that the programmer sits on the controller</source>
        <translation>prüfen, ob das Programmiergerät am Controller sitzt</translation>
    </message>
    <message>
        <source>no bootloader answers</source>
        <translation>kein Bootloader antwortet</translation>
    </message>
    <message>
        <source>restart the controller just before the start, or use a programmer on its pins</source>
        <translation>den Controller kurz vor Beginn neu starten, oder ein Programmiergerät an seinen Stiften nehmen</translation>
    </message>
    <message>
        <source>nothing answers the programmer</source>
        <translation>nichts antwortet dem Programmiergerät</translation>
    </message>
    <message>
        <source>check its cable and the supply of the controller</source>
        <translation>sein Kabel und die Versorgung des Controllers prüfen</translation>
    </message>
    <message>
        <source>the motor stalled</source>
        <translation>der Motor blockierte</translation>
    </message>
    <message>
        <source>the position left its range upwards</source>
        <translation>die Position hat ihren Bereich nach oben verlassen</translation>
    </message>
    <message>
        <source>the position left its range downwards</source>
        <translation>die Position hat ihren Bereich nach unten verlassen</translation>
    </message>
    <message>
        <source>it has no such command</source>
        <translation>es kennt diesen Befehl nicht</translation>
    </message>
    <message>
        <source>wrong number of data bytes</source>
        <translation>falsche Zahl von Datenbytes</translation>
    </message>
    <message>
        <source>a value that it does not take</source>
        <translation>ein Wert, den es nicht annimmt</translation>
    </message>
    <message>
        <source>not possible while the motor is not started</source>
        <translation>nicht möglich, solange der Motor nicht gestartet ist</translation>
    </message>
    <message>
        <source>data bytes where none belong</source>
        <translation>Datenbytes, wo keine hingehören</translation>
    </message>
    <message>
        <source>I2C: nobody answers</source>
        <translation>I2C: niemand antwortet</translation>
    </message>
    <message>
        <source>I2C: bus error</source>
        <translation>I2C: Busfehler</translation>
    </message>
    <message>
        <source>I2C: arbitration lost</source>
        <translation>I2C: Arbitrierung verloren</translation>
    </message>
    <message>
        <source>I2C: indeterminate state</source>
        <translation>I2C: unbestimmter Zustand</translation>
    </message>
    <message>
        <source>I2C: the bus did not become ready</source>
        <translation>I2C: der Bus wurde nicht bereit</translation>
    </message>
    <message>
        <source>I2C: sending took too long</source>
        <translation>I2C: das Senden dauerte zu lange</translation>
    </message>
    <message>
        <source>I2C: receiving took too long</source>
        <translation>I2C: das Empfangen dauerte zu lange</translation>
    </message>
    <message>
        <source>I2C: a packet was overwritten</source>
        <translation>I2C: ein Paket wurde überschrieben</translation>
    </message>
    <message>
        <source>I2C: a packet of wrong length</source>
        <translation>I2C: ein Paket falscher Länge</translation>
    </message>
    <message>
        <source>UART: out of memory</source>
        <translation>UART: Speicher erschöpft</translation>
    </message>
    <message>
        <source>UART: framing error</source>
        <translation>UART: Rahmenfehler</translation>
    </message>
    <message>
        <source>UART: parity error</source>
        <translation>UART: Paritätsfehler</translation>
    </message>
    <message>
        <source>UART: receive buffer overflow</source>
        <translation>UART: Überlauf des Empfangspuffers</translation>
    </message>
    <message>
        <source>UART: data overrun (the datasheet means a framing error)</source>
        <translation>UART: Datenüberlauf (das Datenblatt meint einen Rahmenfehler)</translation>
    </message>
    <message>
        <source>UART: sending took too long (the datasheet means a parity error)</source>
        <translation>UART: das Senden dauerte zu lange (das Datenblatt meint einen Paritätsfehler)</translation>
    </message>
    <message>
        <source>UART: receive buffer overflow, by the datasheet&apos;s number</source>
        <translation>UART: Überlauf des Empfangspuffers, nach der Nummer des Datenblatts</translation>
    </message>
    <message>
        <source>UART: data overrun, by the datasheet&apos;s number</source>
        <translation>UART: Datenüberlauf, nach der Nummer des Datenblatts</translation>
    </message>
    <message>
        <source>a frame paused for more than 50 ms</source>
        <translation>ein Frame pausierte länger als 50 ms</translation>
    </message>
    <message>
        <source>wrong checksum</source>
        <translation>falsche Prüfsumme</translation>
    </message>
    <message>
        <source>%1 % of the samples were lost in a second</source>
        <translation>%1 % der Messwerte gingen in einer Sekunde verloren</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1 %2 is outside %3 … %4</source>
        <translation>%1 %2 liegt außerhalb von %3 … %4</translation>
    </message>
    <message>
        <source>%1 %2 is outside %3 … %4 %5</source>
        <translation>%1 %2 liegt außerhalb von %3 … %4 %5</translation>
    </message>
    <message>
        <source>%1 %2 is outside %3 … %4, what firmware of dialect %5 takes</source>
        <translation>%1 %2 liegt außerhalb von %3 … %4, was Firmware des Dialekts %5 annimmt</translation>
    </message>
    <message>
        <source>%1 %2 is outside the envelope, which ends at %3</source>
        <translation>%1 %2 liegt außerhalb der Grenzen, die bei %3 enden</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>%1 (code %2)</source>
        <translation>%1 (Code %2)</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 und %2</translation>
    </message>
    <message>
        <source>%1 at %2 % duty</source>
        <translation>%1 bei %2 % Tastgrad</translation>
    </message>
    <message>
        <source>%1 at byte %2</source>
        <translation>%1 bei Byte %2</translation>
    </message>
    <message>
        <source>%1 begins no line of such a log</source>
        <translation>mit %1 beginnt keine Zeile eines solchen Protokolls</translation>
    </message>
    <message>
        <source>%1 cannot be made</source>
        <translation>%1 lässt sich nicht anlegen</translation>
    </message>
    <message>
        <source>%1 cannot be made: %2</source>
        <translation>%1 lässt sich nicht anlegen: %2</translation>
    </message>
    <message>
        <source>%1 cannot be read, so it could not be put back</source>
        <translation>%1 lässt sich nicht lesen, also auch nicht zurückschreiben</translation>
    </message>
    <message>
        <source>%1 cannot be restarted from here</source>
        <translation>%1 lässt sich von hier nicht neu starten</translation>
    </message>
    <message>
        <source>%1 cannot be started: %2</source>
        <translation>%1 lässt sich nicht starten: %2</translation>
    </message>
    <message>
        <source>%1 cannot be written</source>
        <translation>%1 lässt sich nicht schreiben</translation>
    </message>
    <message>
        <source>%1 cannot do %2 bit/s</source>
        <translation>%1 kann %2 bit/s nicht</translation>
    </message>
    <message>
        <source>%1 cannot do %2: %3</source>
        <translation>%1 kann %2 nicht: %3</translation>
    </message>
    <message>
        <source>%1 cannot do SPI mode 1 at this speed</source>
        <translation>%1 kann SPI-Modus 1 bei dieser Geschwindigkeit nicht</translation>
    </message>
    <message>
        <source>%1 cannot take old samples: %2</source>
        <translation>%1 kann alte Messwerte nicht aufnehmen: %2</translation>
    </message>
    <message>
        <source>%1 data bytes are announced, %2 are there</source>
        <translation>%1 Datenbytes sind angekündigt, %2 sind da</translation>
    </message>
    <message>
        <source>%1 did not come back within %2</source>
        <translation>%1 kam innerhalb von %2 nicht wieder</translation>
    </message>
    <message>
        <source>%1 digits, an even number is needed</source>
        <translation>%1 Ziffern, nötig ist eine gerade Zahl</translation>
    </message>
    <message>
        <source>%1 does not exist in this device&apos;s dialect</source>
        <translation>%1 gibt es im Dialekt dieses Geräts nicht</translation>
    </message>
    <message>
        <source>%1 does not open: its driver has not answered for %2 s</source>
        <translation>%1 öffnet sich nicht: sein Treiber hat %2 s lang nicht geantwortet</translation>
    </message>
    <message>
        <source>%1 does not tell its position</source>
        <translation>%1 nennt seine Position nicht</translation>
    </message>
    <message>
        <source>%1 exists and is no socket</source>
        <translation>%1 gibt es und ist kein Socket</translation>
    </message>
    <message>
        <source>%1 failed (%2)</source>
        <translation>%1 ist ausgefallen (%2)</translation>
    </message>
    <message>
        <source>%1 failed: %2</source>
        <translation>%1 ist ausgefallen: %2</translation>
    </message>
    <message>
        <source>%1 has %2 axes and %3 sets of gains</source>
        <translation>%1 hat %2 Achsen und %3 Sätze von Verstärkungen</translation>
    </message>
    <message>
        <source>%1 has a name that ends in no kind of picture</source>
        <translation>%1 hat einen Namen, der auf keine Bildart endet</translation>
    </message>
    <message>
        <source>%1 has a name that ends in no kind of report</source>
        <translation>%1 hat einen Namen, der auf keine Art von Bericht endet</translation>
    </message>
    <message>
        <source>%1 has no %2</source>
        <translation>%1 hat kein %2</translation>
    </message>
    <message>
        <source>%1 has no buffered moves</source>
        <translation>%1 hat keine gepufferten Bewegungen</translation>
    </message>
    <message>
        <source>%1 has no channel of samples</source>
        <translation>%1 hat keinen Kanal mit Messwerten</translation>
    </message>
    <message>
        <source>%1 has no dialect &apos;%2&apos;</source>
        <translation>%1 hat keinen Dialekt &apos;%2&apos;</translation>
    </message>
    <message>
        <source>%1 has no duty command</source>
        <translation>%1 hat kein Kommando für den Tastgrad</translation>
    </message>
    <message>
        <source>%1 has no frame in it</source>
        <translation>%1 enthält keinen Frame</translation>
    </message>
    <message>
        <source>%1 has no frame of %2</source>
        <translation>%1 enthält keinen Frame von %2</translation>
    </message>
    <message>
        <source>%1 has no loop &apos;%2&apos; that can be tried</source>
        <translation>%1 hat keinen Regler &apos;%2&apos;, der sich probieren lässt</translation>
    </message>
    <message>
        <source>%1 has no loop &apos;%2&apos; that can be tuned</source>
        <translation>%1 hat keinen Regler &apos;%2&apos;, der sich abstimmen lässt</translation>
    </message>
    <message>
        <source>%1 has no loop that can be tried</source>
        <translation>%1 hat keinen Regler, der sich probieren lässt</translation>
    </message>
    <message>
        <source>%1 has no samples</source>
        <translation>%1 hat keine Messwerte</translation>
    </message>
    <message>
        <source>%1 has no such limit of its own, so nothing bounds the motor</source>
        <translation>%1 hat selbst keine solche Grenze, nichts begrenzt also den Motor</translation>
    </message>
    <message>
        <source>%1 has not told where it stands</source>
        <translation>%1 hat nicht gesagt, wo es steht</translation>
    </message>
    <message>
        <source>%1 holds no limits of experiments</source>
        <translation>%1 enthält keine Grenzen von Versuchen</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1 in %2</translation>
    </message>
    <message>
        <source>%1 in its bootloader instead of %2</source>
        <translation>%1 im Bootloader statt mit %2</translation>
    </message>
    <message>
        <source>%1 instead of %2</source>
        <translation>%1 statt mit %2</translation>
    </message>
    <message>
        <source>%1 is %2</source>
        <translation>%1 ist %2</translation>
    </message>
    <message>
        <source>%1 is a device and has no end</source>
        <translation>%1 ist ein Gerät und endet nie</translation>
    </message>
    <message>
        <source>%1 is a folder</source>
        <translation>%1 ist ein Ordner</translation>
    </message>
    <message>
        <source>%1 is a recording: it can be watched, not written to or driven</source>
        <translation>%1 ist eine Aufnahme: sie lässt sich beobachten, nicht beschreiben oder ansteuern</translation>
    </message>
    <message>
        <source>%1 is busy: it serves one client at a time</source>
        <translation>%1 ist beschäftigt: es bedient einen Partner zugleich</translation>
    </message>
    <message>
        <source>%1 is damaged and cannot be put aside</source>
        <translation>%1 ist beschädigt und lässt sich nicht beiseitelegen</translation>
    </message>
    <message>
        <source>%1 is in use by another program</source>
        <translation>%1 wird von einem anderen Programm benutzt</translation>
    </message>
    <message>
        <source>%1 is never part of an experiment</source>
        <translation>%1 gehört nie zu einem Versuch</translation>
    </message>
    <message>
        <source>%1 is no CAN identifier in dec</source>
        <translation>%1 ist kein dezimaler CAN-Identifier</translation>
    </message>
    <message>
        <source>%1 is no CAN identifier in hex</source>
        <translation>%1 ist kein hexadezimaler CAN-Identifier</translation>
    </message>
    <message>
        <source>%1 is no CAN link</source>
        <translation>%1 ist keine CAN-Verbindung</translation>
    </message>
    <message>
        <source>%1 is no device profile</source>
        <translation>%1 ist kein Geräteprofil</translation>
    </message>
    <message>
        <source>%1 is no serial port</source>
        <translation>%1 ist keine serielle Schnittstelle</translation>
    </message>
    <message>
        <source>%1 is no time stamp</source>
        <translation>%1 ist kein Zeitstempel</translation>
    </message>
    <message>
        <source>%1 is not a file</source>
        <translation>%1 ist keine Datei</translation>
    </message>
    <message>
        <source>%1 is not a hexadecimal digit</source>
        <translation>%1 ist keine Hexadezimalziffer</translation>
    </message>
    <message>
        <source>%1 is not an MCAP file</source>
        <translation>%1 ist keine MCAP-Datei</translation>
    </message>
    <message>
        <source>%1 is not an object</source>
        <translation>%1 ist kein Objekt</translation>
    </message>
    <message>
        <source>%1 is not in this program</source>
        <translation>%1 gibt es in diesem Programm nicht</translation>
    </message>
    <message>
        <source>%1 is not installed</source>
        <translation>%1 ist nicht installiert</translation>
    </message>
    <message>
        <source>%1 is not known to firmware of dialect %2</source>
        <translation>%1 kennt Firmware des Dialekts %2 nicht</translation>
    </message>
    <message>
        <source>%1 is served by another program already</source>
        <translation>%1 wird schon von einem anderen Programm bedient</translation>
    </message>
    <message>
        <source>%1 is served by another simulator</source>
        <translation>%1 wird von einem anderen Simulator bedient</translation>
    </message>
    <message>
        <source>%1 is there already and no link to a terminal</source>
        <translation>%1 gibt es schon, und es ist keine Verknüpfung mit einem Terminal</translation>
    </message>
    <message>
        <source>%1 is used by another program</source>
        <translation>%1 wird von einem anderen Programm benutzt</translation>
    </message>
    <message>
        <source>%1 lines, %2 bytes; the file does not name its version</source>
        <translation>%1 Zeilen, %2 Bytes; die Datei nennt ihre Version nicht</translation>
    </message>
    <message>
        <source>%1 needs a number</source>
        <translation>%1 braucht eine Zahl</translation>
    </message>
    <message>
        <source>%1 of %2 lines were confirmed. The bootloader keeps waiting: leave the jumper in and run the update again</source>
        <translation>%1 von %2 Zeilen wurden bestätigt. Der Bootloader wartet weiter: Steckbrücke stecken lassen und die Aktualisierung erneut beginnen</translation>
    </message>
    <message>
        <source>%1 of %2 settings were written again; %3: %4</source>
        <translation>%1 von %2 Einstellungen wurden neu geschrieben; %3: %4</translation>
    </message>
    <message>
        <source>%1 of %2 settings were written again; then the board was reset once more</source>
        <translation>%1 von %2 Einstellungen wurden neu geschrieben; dann wurde die Platine nochmals zurückgesetzt</translation>
    </message>
    <message>
        <source>%1 said nothing for too long</source>
        <translation>%1 hat zu lange nichts gesagt</translation>
    </message>
    <message>
        <source>%1 takes no frames: %2 wait to be sent</source>
        <translation>%1 nimmt keine Frames an: %2 warten auf das Senden</translation>
    </message>
    <message>
        <source>%1 to number %2: %3</source>
        <translation>%1 an Nummer %2: %3</translation>
    </message>
    <message>
        <source>%1 transmit and %2 receive errors</source>
        <translation>%1 Sende- und %2 Empfangsfehler</translation>
    </message>
    <message>
        <source>%1 units answer as number %2</source>
        <translation>%1 Geräte antworten als Nummer %2</translation>
    </message>
    <message>
        <source>%1 values are not what they were left as; the history has both</source>
        <translation>%1 Werte sind nicht, wie sie verlassen wurden; die Historie hat beide</translation>
    </message>
    <message>
        <source>%1 was changed while it was played</source>
        <translation>%1 wurde während der Wiedergabe geändert</translation>
    </message>
    <message>
        <source>%1 was made by a newer version of this program (schema %2, known here is %3)</source>
        <translation>%1 stammt von einer neueren Version dieses Programms (Schema %2, hier bekannt ist %3)</translation>
    </message>
    <message>
        <source>%1 was not confirmed</source>
        <translation>%1 wurde nicht bestätigt</translation>
    </message>
    <message>
        <source>%1 was refused: %2</source>
        <translation>%1 wurde abgelehnt: %2</translation>
    </message>
    <message>
        <source>%1 was stopped: %2, %3</source>
        <translation>%1 wurde gestoppt: %2, %3</translation>
    </message>
    <message>
        <source>%1 was unplugged</source>
        <translation>%1 wurde abgezogen</translation>
    </message>
    <message>
        <source>%1 with %2 transmit and %3 receive errors</source>
        <translation>%1 mit %2 Sende- und %3 Empfangsfehlern</translation>
    </message>
    <message>
        <source>%1 would be %2 of its smallest steps, too few to mean anything</source>
        <translation>%1 wäre %2 seiner kleinsten Schritte, zu wenige, um etwas zu bedeuten</translation>
    </message>
    <message>
        <source>%1 would have to be %2, which it cannot be</source>
        <translation>%1 müsste %2 sein, was es nicht sein kann</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1, line %2: %3</source>
        <translation>%1, Zeile %2: %3</translation>
    </message>
    <message>
        <source>%1, more than half a step from its target</source>
        <translation>%1, mehr als einen halben Sprung von seinem Ziel entfernt</translation>
    </message>
    <message>
        <source>%1, told to run at more than half a step</source>
        <translation>%1, mit mehr als einem halben Sprung als Sollwert</translation>
    </message>
    <message>
        <source>%1: %2 is above %3</source>
        <translation>%1: %2 liegt über %3</translation>
    </message>
    <message>
        <source>%1: %2 is below %3</source>
        <translation>%1: %2 liegt unter %3</translation>
    </message>
    <message>
        <source>%1: %2 is not a whole number</source>
        <translation>%1: %2 ist keine ganze Zahl</translation>
    </message>
    <message>
        <source>%1: %2 of %3 ms is finer than the device follows, which takes a set-point every %4 ms</source>
        <translation>%1: %2 von %3 ms ist feiner, als das Gerät folgt, das alle %4 ms einen Sollwert annimmt</translation>
    </message>
    <message>
        <source>%1: &apos;%2&apos; is neither on nor off</source>
        <translation>%1: &apos;%2&apos; ist weder on noch off</translation>
    </message>
    <message>
        <source>%1: &apos;%2&apos; is not a number</source>
        <translation>%1: &apos;%2&apos; ist keine Zahl</translation>
    </message>
    <message>
        <source>%1: cannot be read (system error %2)</source>
        <translation>%1: lässt sich nicht lesen (Systemfehler %2)</translation>
    </message>
    <message>
        <source>%1: its value is of the wrong kind</source>
        <translation>%1: der Wert ist von der falschen Art</translation>
    </message>
    <message>
        <source>%1: its value says %2, its raw value %3</source>
        <translation>%1: der Wert sagt %2, der Rohwert %3</translation>
    </message>
    <message>
        <source>%1: legal is %2 … %3</source>
        <translation>%1: zulässig ist %2 … %3</translation>
    </message>
    <message>
        <source>%1: no permission to read it</source>
        <translation>%1: keine Berechtigung zum Lesen</translation>
    </message>
    <message>
        <source>%1: not a number</source>
        <translation>%1: keine Zahl</translation>
    </message>
    <message>
        <source>%1: raw is not a whole number</source>
        <translation>%1: raw ist keine ganze Zahl</translation>
    </message>
    <message>
        <source>%1: raw value %2 is out of range</source>
        <translation>%1: Rohwert %2 liegt außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>%1: status %2 has no meaning</source>
        <translation>%1: Status %2 hat keine Bedeutung</translation>
    </message>
    <message>
        <source>%1: the device answers &apos;%2&apos;</source>
        <translation>%1: das Gerät antwortet &apos;%2&apos;</translation>
    </message>
    <message>
        <source>%1: the device refused the value</source>
        <translation>%1: das Gerät hat den Wert abgelehnt</translation>
    </message>
    <message>
        <source>%1: this firmware does not know the parameter</source>
        <translation>%1: diese Firmware kennt den Parameter nicht</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1; %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no number</source>
        <translation>„%1“ ist keine Zahl</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no path of a socket: it has 1 to 107 characters</source>
        <translation>&apos;%1&apos; ist kein Pfad eines Sockets: er hat 1 bis 107 Zeichen</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no time in seconds</source>
        <translation>&apos;%1&apos; ist keine Zeit in Sekunden</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a device: LINK/FAMILY:ADDRESS is needed, such as sim:can/dmc60c:5</source>
        <translation>&apos;%1&apos; ist kein Gerät: nötig ist LINK/FAMILIE:ADRESSE, etwa sim:can/dmc60c:5</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a simulated device: %2</source>
        <translation>&apos;%1&apos; ist kein simuliertes Gerät: %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not qtcan:PLUGIN:INTERFACE</source>
        <translation>&apos;%1&apos; ist nicht qtcan:PLUGIN:SCHNITTSTELLE</translation>
    </message>
    <message>
        <source>&apos;motorbenchctl snapshots&apos; lists those there are</source>
        <translation>&apos;motorbenchctl snapshots&apos; nennt die vorhandenen</translation>
    </message>
    <message>
        <source>&apos;motorbenchctl trials&apos; lists those there are</source>
        <translation>&apos;motorbenchctl trials&apos; nennt die vorhandenen</translation>
    </message>
    <message>
        <source>--font-scale takes 0.5 to 3</source>
        <translation>--font-scale nimmt 0.5 bis 3</translation>
    </message>
    <message>
        <source>--out &apos;%1&apos; is no picture</source>
        <translation>--out &apos;%1&apos; ist kein Bild</translation>
    </message>
    <message>
        <source>%1 is no report</source>
        <translation>%1 ist kein Bericht</translation>
    </message>
    <message>
        <source>--out &apos;%1&apos; is no PDF</source>
        <translation>--out &apos;%1&apos; ist kein PDF</translation>
    </message>
    <message>
        <source>--help tells what there is</source>
        <translation>--help sagt, was es gibt</translation>
    </message>
    <message>
        <source>--plot FILE or --report FILE, and --out FILE belong together</source>
        <translation>--plot DATEI oder --report DATEI gehört mit --out DATEI zusammen</translation>
    </message>
    <message>
        <source>--size takes WIDTHxHEIGHT, such as 1280x800</source>
        <translation>--size nimmt BREITExHÖHE, etwa 1280x800</translation>
    </message>
    <message>
        <source>--target is missing</source>
        <translation>--target fehlt</translation>
    </message>
    <message>
        <source>--target: &apos;%1&apos; is unknown</source>
        <translation>--target: &apos;%1&apos; ist unbekannt</translation>
    </message>
    <message>
        <source>--tour needs a folder for its pictures</source>
        <translation>--tour braucht einen Ordner für seine Bilder</translation>
    </message>
    <message>
        <source>--via: &apos;%1&apos; is no way into a Supermodified</source>
        <translation>--via: &apos;%1&apos; ist kein Weg in einen Supermodified</translation>
    </message>
    <message>
        <source>--via: &apos;%1&apos; is no way into an Abstract DC Drive</source>
        <translation>--via: &apos;%1&apos; ist kein Weg in einen Abstract DC Drive</translation>
    </message>
    <message>
        <source>0 is no divisor</source>
        <translation>0 ist kein Divisor</translation>
    </message>
    <message>
        <source>1 byte</source>
        <translation>1 Byte</translation>
    </message>
    <message>
        <source>A programmer on the pins erases the chip first, the stored settings and the serial bootloader with it: save the parameters before. The bootloader keeps both.</source>
        <translation>Ein Programmiergerät an den Stiften löscht zuerst den Baustein, mit ihm die gespeicherten Einstellungen und den seriellen Bootloader: vorher die Parameter sichern. Der Bootloader behält beides.</translation>
    </message>
    <message>
        <source>Abstract DC Drives found: %1</source>
        <translation>Abstract DC Drives gefunden: %1</translation>
    </message>
    <message>
        <source>Abstract DC Drives live on CAN links only</source>
        <translation>Abstract DC Drives gibt es nur an CAN-Links</translation>
    </message>
    <message>
        <source>Autotune</source>
        <translation>Selbst abstimmen</translation>
    </message>
    <message>
        <source>CAN high is not connected</source>
        <translation>CAN high ist nicht angeschlossen</translation>
    </message>
    <message>
        <source>CAN high is short to battery</source>
        <translation>CAN high hat Schluss zur Batterie</translation>
    </message>
    <message>
        <source>CAN high is short to ground</source>
        <translation>CAN high hat Schluss nach Masse</translation>
    </message>
    <message>
        <source>CAN high is short to supply</source>
        <translation>CAN high hat Schluss zur Versorgung</translation>
    </message>
    <message>
        <source>CAN low is not connected</source>
        <translation>CAN low ist nicht angeschlossen</translation>
    </message>
    <message>
        <source>CAN low is short to CAN high</source>
        <translation>CAN low hat Schluss nach CAN high</translation>
    </message>
    <message>
        <source>CAN low is short to battery</source>
        <translation>CAN low hat Schluss zur Batterie</translation>
    </message>
    <message>
        <source>CAN low is short to ground</source>
        <translation>CAN low hat Schluss nach Masse</translation>
    </message>
    <message>
        <source>CAN low is short to supply</source>
        <translation>CAN low hat Schluss zur Versorgung</translation>
    </message>
    <message>
        <source>Connecting through OpenOCD</source>
        <translation>Verbinden über OpenOCD</translation>
    </message>
    <message>
        <source>Count from 0</source>
        <translation>Ab 0 zählen</translation>
    </message>
    <message>
        <source>DMC60C controllers are found on CAN links only</source>
        <translation>DMC60C-Controller werden nur an CAN-Links gefunden</translation>
    </message>
    <message>
        <source>DMC60C found: %1</source>
        <translation>DMC60C gefunden: %1</translation>
    </message>
    <message>
        <source>Dialect %1 was chosen by hand, none was proven. %2</source>
        <translation>Dialekt %1 wurde von Hand gewählt, nachgewiesen war keiner. %2</translation>
    </message>
    <message>
        <source>Dialect %1 was chosen by hand, the unit answered as %2. %3</source>
        <translation>Dialekt %1 wurde von Hand gewählt, das Gerät antwortete als %2. %3</translation>
    </message>
    <message>
        <source>Do a write again</source>
        <translation>Schreiben wiederholen</translation>
    </message>
    <message>
        <source>Erasing the stored settings</source>
        <translation>Löschen der gespeicherten Einstellungen</translation>
    </message>
    <message>
        <source>Experiment</source>
        <translation>Versuch</translation>
    </message>
    <message>
        <source>FAMILY:ADDRESS is needed, such as dmc60c:5</source>
        <translation>nötig ist FAMILIE:ADRESSE, etwa dmc60c:5</translation>
    </message>
    <message>
        <source>Frequency response</source>
        <translation>Frequenzgang</translation>
    </message>
    <message>
        <source>GPIO line %1 is used by another program or driver</source>
        <translation>die GPIO-Leitung %1 wird von einem anderen Programm oder Treiber benutzt</translation>
    </message>
    <message>
        <source>GPIO line %1: %2</source>
        <translation>GPIO-Leitung %1: %2</translation>
    </message>
    <message>
        <source>GetDescriptors: a field ends too early</source>
        <translation>GetDescriptors: ein Feld endet zu früh</translation>
    </message>
    <message>
        <source>GetFlashSeqnum: 4 bytes were expected</source>
        <translation>GetFlashSeqnum: erwartet waren 4 Bytes</translation>
    </message>
    <message>
        <source>GetFwver answered with %1 bytes</source>
        <translation>GetFwver antwortete mit %1 Bytes</translation>
    </message>
    <message>
        <source>GetFwver: 6 bytes were expected</source>
        <translation>GetFwver: erwartet waren 6 Bytes</translation>
    </message>
    <message>
        <source>Keep the gains of a trial</source>
        <translation>Verstärkungen eines Versuchs behalten</translation>
    </message>
    <message>
        <source>Look for gains that are owed</source>
        <translation>Nach geschuldeten Verstärkungen sehen</translation>
    </message>
    <message>
        <source>Looking for Abstract DC Drives</source>
        <translation>Suche nach Abstract DC Drives</translation>
    </message>
    <message>
        <source>Looking for DMC60C</source>
        <translation>Suche nach DMC60C</translation>
    </message>
    <message>
        <source>Looking for the drive</source>
        <translation>Suche nach dem Antrieb</translation>
    </message>
    <message>
        <source>OpenOCD ended without saying why</source>
        <translation>OpenOCD endete ohne Angabe eines Grundes</translation>
    </message>
    <message>
        <source>OpenOCD verified the flash, and the drive answers again</source>
        <translation>OpenOCD hat den Flash geprüft, und der Antrieb antwortet wieder</translation>
    </message>
    <message>
        <source>OpenOCD verified the flash, but nothing answers as %1; the new firmware may have another offset or bit rate: scan again</source>
        <translation>OpenOCD hat den Flash geprüft, aber nichts antwortet als %1; die neue Firmware kann einen anderen Offset oder eine andere Bitrate haben: neu suchen</translation>
    </message>
    <message>
        <source>OpenOCD: %1</source>
        <translation>OpenOCD: %1</translation>
    </message>
    <message>
        <source>Put gains back</source>
        <translation>Verstärkungen zurückschreiben</translation>
    </message>
    <message>
        <source>Restarting the drive</source>
        <translation>Neustart des Antriebs</translation>
    </message>
    <message>
        <source>STOP was pressed</source>
        <translation>STOP wurde gedrückt</translation>
    </message>
    <message>
        <source>Saved</source>
        <translation>Gespeichert</translation>
    </message>
    <message>
        <source>Saving the %1 loop</source>
        <translation>Speichern des Reglers %1</translation>
    </message>
    <message>
        <source>Set telemetry rate: %1</source>
        <translation>Telemetrierate setzen: %1</translation>
    </message>
    <message>
        <source>Several drives answer with offset %1; offsets are compiled into the firmware, so give one of them another and flash it.</source>
        <translation>Mehrere Antriebe antworten mit Offset %1; Offsets stecken in der Firmware, also einem einen anderen geben und ihn flashen.</translation>
    </message>
    <message>
        <source>Supermodified controllers are found on serial links only</source>
        <translation>Supermodified-Controller werden nur an seriellen Links gefunden</translation>
    </message>
    <message>
        <source>Take a snapshot</source>
        <translation>Schnappschuss aufnehmen</translation>
    </message>
    <message>
        <source>The controller tells no version: the programmer&apos;s own verify and the controller&apos;s answer prove the update.</source>
        <translation>Der Controller nennt keine Version: die Prüfung des Programmiergeräts und die Antwort des Controllers belegen die Aktualisierung.</translation>
    </message>
    <message>
        <source>The drive tells no version: the programmer&apos;s own verify and the drive&apos;s answer prove the update.</source>
        <translation>Der Antrieb nennt keine Version: die Prüfung des Programmiergeräts und die Antwort des Antriebs belegen die Aktualisierung.</translation>
    </message>
    <message>
        <source>The image holds a bootloader too, so it needs a programmer on the pins.</source>
        <translation>Das Image enthält auch einen Bootloader, braucht also ein Programmiergerät an den Stiften.</translation>
    </message>
    <message>
        <source>The image writes the settings pages: stored gains are replaced.</source>
        <translation>Das Image schreibt die Seiten der Einstellungen: gespeicherte Verstärkungen werden ersetzt.</translation>
    </message>
    <message>
        <source>The serial bootloader listens for a moment after power-up only: restart the controller when the update begins.</source>
        <translation>Der serielle Bootloader hört nur kurz nach dem Einschalten zu: den Controller zu Beginn der Aktualisierung neu starten.</translation>
    </message>
    <message>
        <source>Undo a write</source>
        <translation>Schreiben rückgängig machen</translation>
    </message>
    <message>
        <source>a DMC60C has a number from 0 to 63, not %1</source>
        <translation>ein DMC60C hat eine Nummer von 0 bis 63, nicht %1</translation>
    </message>
    <message>
        <source>a DMC60C has no mode &apos;%1&apos;</source>
        <translation>ein DMC60C hat keine Betriebsart &apos;%1&apos;</translation>
    </message>
    <message>
        <source>a DMC60C has one axis</source>
        <translation>ein DMC60C hat eine Achse</translation>
    </message>
    <message>
        <source>a DMC60C has the gain slots 0 and 1</source>
        <translation>ein DMC60C hat die Slots 0 und 1</translation>
    </message>
    <message>
        <source>a DMC60C is simulated on a CAN link</source>
        <translation>ein DMC60C wird an einem CAN-Link simuliert</translation>
    </message>
    <message>
        <source>a DMC60C is updated over its own link</source>
        <translation>ein DMC60C wird über seinen eigenen Link aktualisiert</translation>
    </message>
    <message>
        <source>a GPIO line is CHIP:LINE, as in gpiochip0:25, not &apos;%1&apos;</source>
        <translation>eine GPIO-Leitung ist CHIP:LEITUNG, wie in gpiochip0:25, nicht &apos;%1&apos;</translation>
    </message>
    <message>
        <source>a QuadQuad2Drv has no address but 0</source>
        <translation>ein QuadQuad2Drv hat keine Adresse außer 0</translation>
    </message>
    <message>
        <source>a QuadQuad2Drv has one kind of chip</source>
        <translation>ein QuadQuad2Drv hat eine Art von Baustein</translation>
    </message>
    <message>
        <source>a QuadQuad2Drv is simulated on the board&apos;s end of an SPI link</source>
        <translation>ein QuadQuad2Drv wird am Platinenende eines SPI-Links simuliert</translation>
    </message>
    <message>
        <source>a QuadQuad2Drv lives on an SPI link</source>
        <translation>ein QuadQuad2Drv sitzt an einem SPI-Link</translation>
    </message>
    <message>
        <source>a Supermodified has an id from 1 to 127, not %1</source>
        <translation>ein Supermodified hat eine Kennung von 1 bis 127, nicht %1</translation>
    </message>
    <message>
        <source>a Supermodified has no mode &apos;%1&apos;</source>
        <translation>ein Supermodified hat keine Betriebsart &apos;%1&apos;</translation>
    </message>
    <message>
        <source>a Supermodified has one axis and one set of gains</source>
        <translation>ein Supermodified hat eine Achse und einen Satz Verstärkungen</translation>
    </message>
    <message>
        <source>a Supermodified has one kind of microcontroller</source>
        <translation>ein Supermodified hat eine Art von Mikrocontroller</translation>
    </message>
    <message>
        <source>a Supermodified is simulated on a serial link</source>
        <translation>ein Supermodified wird an einem seriellen Link simuliert</translation>
    </message>
    <message>
        <source>a Supermodified is written by avrdude</source>
        <translation>ein Supermodified wird von avrdude geschrieben</translation>
    </message>
    <message>
        <source>a bit</source>
        <translation>ein Bit</translation>
    </message>
    <message>
        <source>a bootloader needs the board&apos;s serial line, such as boot=pty:./boot</source>
        <translation>ein Bootloader braucht die serielle Leitung der Platine, etwa boot=pty:./boot</translation>
    </message>
    <message>
        <source>a buffered move is not acknowledged yet</source>
        <translation>eine gepufferte Bewegung ist noch nicht bestätigt</translation>
    </message>
    <message>
        <source>a demo remembers no layouts</source>
        <translation>eine Demo merkt sich keine Layouts</translation>
    </message>
    <message>
        <source>a divisor changes all gains at once</source>
        <translation>ein Divisor ändert alle Verstärkungen zugleich</translation>
    </message>
    <message>
        <source>a drive of dialect LL has no code for stop</source>
        <translation>ein Antrieb mit Dialekt LL hat keinen Code für Stopp</translation>
    </message>
    <message>
        <source>a formula assigns nothing</source>
        <translation>eine Formel weist nichts zu</translation>
    </message>
    <message>
        <source>a formula has at most 4000 characters</source>
        <translation>eine Formel hat höchstens 4000 Zeichen</translation>
    </message>
    <message>
        <source>a half swing</source>
        <translation>eine halbe Schwingung</translation>
    </message>
    <message>
        <source>a load takes %1 of what P makes of a step, at most 10 %</source>
        <translation>eine Last nimmt %1 dessen, was P aus einem Sprung macht, höchstens 10 %</translation>
    </message>
    <message>
        <source>a motor is driven on this line</source>
        <translation>an dieser Leitung wird ein Motor angesteuert</translation>
    </message>
    <message>
        <source>a motor is driven on this line at %1 bit/s, and this node has another rate</source>
        <translation>an dieser Leitung wird mit %1 bit/s ein Motor angesteuert, und dieser Knoten hat eine andere Rate</translation>
    </message>
    <message>
        <source>a node id is 1 … 127</source>
        <translation>eine Knotenkennung ist 1 … 127</translation>
    </message>
    <message>
        <source>a parenthesis is not closed</source>
        <translation>eine Klammer ist nicht geschlossen</translation>
    </message>
    <message>
        <source>a part of them is in force after a restart only</source>
        <translation>ein Teil davon gilt erst nach einem Neustart</translation>
    </message>
    <message>
        <source>a profile has up to 100000 counts/s and 1000000 counts/s²</source>
        <translation>ein Profil hat bis zu 100000 counts/s und 1000000 counts/s²</translation>
    </message>
    <message>
        <source>a push has fewer than 8 positions</source>
        <translation>ein Stoß hat weniger als 8 Positionen</translation>
    </message>
    <message>
        <source>a push moved the motor by fewer than 50 counts</source>
        <translation>ein Stoß hat den Motor um weniger als 50 counts bewegt</translation>
    </message>
    <message>
        <source>a push of %1 duty drew %2 A, more than half of what is allowed</source>
        <translation>ein Stoß mit %1 Tastgrad zog %2 A, mehr als die Hälfte des Erlaubten</translation>
    </message>
    <message>
        <source>a record of type %1 has %2 data bytes, not %3</source>
        <translation>ein Datensatz der Art %1 hat %2 Datenbytes, nicht %3</translation>
    </message>
    <message>
        <source>a reserved bit</source>
        <translation>ein reserviertes Bit</translation>
    </message>
    <message>
        <source>a scan of the recording lists who does</source>
        <translation>eine Suche in der Aufnahme nennt, wer es tut</translation>
    </message>
    <message>
        <source>a step from the wrong place could be far too large</source>
        <translation>ein Sprung von der falschen Stelle könnte viel zu groß sein</translation>
    </message>
    <message>
        <source>a step of %1 counts overflows the loop of this firmware</source>
        <translation>ein Sprung von %1 counts lässt den Regler dieser Firmware überlaufen</translation>
    </message>
    <message>
        <source>a step of %1 counts with P %2, D %3</source>
        <translation>ein Sprung von %1 counts mit P %2, D %3</translation>
    </message>
    <message>
        <source>a step of %1 counts with the gains as they are</source>
        <translation>ein Sprung von %1 counts mit den Verstärkungen, wie sie sind</translation>
    </message>
    <message>
        <source>a stop went first</source>
        <translation>ein Stopp ging vor</translation>
    </message>
    <message>
        <source>a swing</source>
        <translation>eine Schwingung</translation>
    </message>
    <message>
        <source>a time</source>
        <translation>eine Zeit</translation>
    </message>
    <message>
        <source>a trial that is not kept</source>
        <translation>ein Versuch, der nicht aufbewahrt wird</translation>
    </message>
    <message>
        <source>a unit that has a serial number needs no tag</source>
        <translation>ein Gerät mit Seriennummer braucht kein Kennzeichen</translation>
    </message>
    <message>
        <source>travel</source>
        <translation>Weg</translation>
    </message>
    <message>
        <source>accepted</source>
        <translation>angenommen</translation>
    </message>
    <message>
        <source>active error flag</source>
        <translation>Active-Error-Flag</translation>
    </message>
    <message>
        <source>add --via %1</source>
        <translation>--via %1 hinzufügen</translation>
    </message>
    <message>
        <source>add --via openocd:INTERFACE --target f1|f4, such as --via openocd:stlink --target f1</source>
        <translation>--via openocd:SCHNITTSTELLE --target f1|f4 hinzufügen, etwa --via openocd:stlink --target f1</translation>
    </message>
    <message>
        <source>add ready=CHIP:LINE to the address</source>
        <translation>der Adresse ready=CHIP:LEITUNG hinzufügen</translation>
    </message>
    <message>
        <source>add reset=CHIP:LINE to the address</source>
        <translation>der Adresse reset=CHIP:LEITUNG hinzufügen</translation>
    </message>
    <message>
        <source>address %1 is %2 here and %3 in line %4</source>
        <translation>Adresse %1 ist hier %2 und in Zeile %4 %3</translation>
    </message>
    <message>
        <source>aim for a calmer loop</source>
        <translation>einen ruhigeren Regler anstreben</translation>
    </message>
    <message>
        <source>allow CAN sockets in the container or sandbox</source>
        <translation>CAN-Sockets im Container oder in der Sandbox freigeben</translation>
    </message>
    <message>
        <source>allow it more power, or free its shaft</source>
        <translation>mehr Leistung zulassen oder die Welle freimachen</translation>
    </message>
    <message>
        <source>allow more current</source>
        <translation>mehr Strom erlauben</translation>
    </message>
    <message>
        <source>allow more current or duty</source>
        <translation>mehr Strom oder Tastgrad erlauben</translation>
    </message>
    <message>
        <source>allow more duty</source>
        <translation>mehr Tastgrad erlauben</translation>
    </message>
    <message>
        <source>allow more speed</source>
        <translation>mehr Drehzahl erlauben</translation>
    </message>
    <message>
        <source>allow more travel</source>
        <translation>mehr Weg erlauben</translation>
    </message>
    <message>
        <source>allow more travel or duty</source>
        <translation>mehr Weg oder Tastgrad erlauben</translation>
    </message>
    <message>
        <source>allow more travel or speed</source>
        <translation>mehr Weg oder Drehzahl erlauben</translation>
    </message>
    <message>
        <source>an Abstract DC Drive has an offset from 0 to 99, not %1</source>
        <translation>ein Abstract DC Drive hat einen Offset von 0 bis 99, nicht %1</translation>
    </message>
    <message>
        <source>an Abstract DC Drive has no mode &apos;%1&apos;</source>
        <translation>ein Abstract DC Drive hat keine Betriebsart &apos;%1&apos;</translation>
    </message>
    <message>
        <source>an Abstract DC Drive is written through a debug probe</source>
        <translation>ein Abstract DC Drive wird über einen Debug-Adapter geschrieben</translation>
    </message>
    <message>
        <source>an answer of %1 bytes</source>
        <translation>eine Antwort von %1 Bytes</translation>
    </message>
    <message>
        <source>an axis from 1 to 4 and a power limit above 0 are needed</source>
        <translation>nötig sind eine Achse von 1 bis 4 und eine Leistungsgrenze über 0</translation>
    </message>
    <message>
        <source>an experiment is run once at least</source>
        <translation>ein Versuch läuft mindestens einmal</translation>
    </message>
    <message>
        <source>another master drives %1</source>
        <translation>ein anderer Master steuert %1 an</translation>
    </message>
    <message>
        <source>arbitration lost</source>
        <translation>Arbitrierung verloren</translation>
    </message>
    <message>
        <source>arbitration lost at bit %1</source>
        <translation>Arbitrierung bei Bit %1 verloren</translation>
    </message>
    <message>
        <source>arm again</source>
        <translation>neu scharf schalten</translation>
    </message>
    <message>
        <source>asking for the version</source>
        <translation>Frage nach der Version</translation>
    </message>
    <message>
        <source>assign one before it is driven</source>
        <translation>vor dem Ansteuern eine zuweisen</translation>
    </message>
    <message>
        <source>at most %1 with its P: use a profiled mode or several moves</source>
        <translation>mit diesem P höchstens %1: eine Betriebsart mit Profil oder mehrere Bewegungen verwenden</translation>
    </message>
    <message>
        <source>average takes 0 to 3600 seconds, not &apos;%1&apos;</source>
        <translation>average nimmt 0 bis 3600 Sekunden, nicht &apos;%1&apos;</translation>
    </message>
    <message>
        <source>average takes a signal and seconds, such as average(x, 0.1)</source>
        <translation>average nimmt ein Signal und Sekunden, etwa average(x, 0.1)</translation>
    </message>
    <message>
        <source>avrdude ended without saying why</source>
        <translation>avrdude endete ohne Angabe eines Grundes</translation>
    </message>
    <message>
        <source>avrdude had the port</source>
        <translation>avrdude hatte den Anschluss</translation>
    </message>
    <message>
        <source>avrdude is not installed</source>
        <translation>avrdude ist nicht installiert</translation>
    </message>
    <message>
        <source>baud, format, rs485 and echo are known</source>
        <translation>bekannt sind baud, format, rs485 und echo</translation>
    </message>
    <message>
        <source>bit error</source>
        <translation>Bitfehler</translation>
    </message>
    <message>
        <source>boot= names a serial link, such as pty:./boot</source>
        <translation>boot= nennt einen seriellen Link, etwa pty:./boot</translation>
    </message>
    <message>
        <source>bootloader</source>
        <translation>Bootloader</translation>
    </message>
    <message>
        <source>bus error</source>
        <translation>Busfehler</translation>
    </message>
    <message>
        <source>bus overload</source>
        <translation>Busüberlast</translation>
    </message>
    <message>
        <source>bus-off</source>
        <translation>bus-off</translation>
    </message>
    <message>
        <source>bus-off: %1 left the bus after too many errors</source>
        <translation>bus-off: %1 hat den Bus nach zu vielen Fehlern verlassen</translation>
    </message>
    <message>
        <source>bus-off: the adapter left the bus after too many errors</source>
        <translation>bus-off: der Adapter hat den Bus nach zu vielen Fehlern verlassen</translation>
    </message>
    <message>
        <source>bus-off: the controller left the bus after too many errors</source>
        <translation>bus-off: der CAN-Controller hat den Bus nach zu vielen Fehlern verlassen</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>abgebrochen</translation>
    </message>
    <message>
        <source>cannot be read (system error %1)</source>
        <translation>nicht lesbar (Systemfehler %1)</translation>
    </message>
    <message>
        <source>change its mode, or copy it</source>
        <translation>Zugriffsrechte ändern oder die Datei kopieren</translation>
    </message>
    <message>
        <source>check its rights</source>
        <translation>seine Rechte prüfen</translation>
    </message>
    <message>
        <source>check that somebody else is on the bus</source>
        <translation>prüfen, ob noch jemand am Bus ist</translation>
    </message>
    <message>
        <source>check the cables and try again</source>
        <translation>die Kabel prüfen und erneut versuchen</translation>
    </message>
    <message>
        <source>check the disk</source>
        <translation>Festplatte prüfen</translation>
    </message>
    <message>
        <source>check the jumper AUX1–AUX2, the crossed wires TX and RX, and the 3.3 V levels, then reset the board</source>
        <translation>die Steckbrücke AUX1–AUX2, die gekreuzten Leitungen TX und RX und die 3,3-V-Pegel prüfen, dann die Platine zurücksetzen</translation>
    </message>
    <message>
        <source>check the path</source>
        <translation>Pfad prüfen</translation>
    </message>
    <message>
        <source>check the probe and try again</source>
        <translation>den Adapter prüfen und erneut versuchen</translation>
    </message>
    <message>
        <source>check the rights of the folder above it</source>
        <translation>die Rechte des Ordners darüber prüfen</translation>
    </message>
    <message>
        <source>check wiring, termination and bit rate</source>
        <translation>Verdrahtung, Abschluss und Bitrate prüfen</translation>
    </message>
    <message>
        <source>chirp: %1 s hold no whole swing of %2 Hz</source>
        <translation>Chirp: in %1 s passt keine ganze Schwingung von %2 Hz</translation>
    </message>
    <message>
        <source>choose another folder</source>
        <translation>anderen Ordner wählen</translation>
    </message>
    <message>
        <source>choose another one</source>
        <translation>anderen wählen</translation>
    </message>
    <message>
        <source>choose another path</source>
        <translation>einen anderen Pfad wählen</translation>
    </message>
    <message>
        <source>choose another place</source>
        <translation>einen anderen Ort wählen</translation>
    </message>
    <message>
        <source>close that one first (&apos;fuser %1&apos; names it)</source>
        <translation>zuerst jenes schließen (&apos;fuser %1&apos; nennt es)</translation>
    </message>
    <message>
        <source>close the jumper between AUX1 and AUX2, then reset the board or switch it off and on</source>
        <translation>die Steckbrücke zwischen AUX1 und AUX2 stecken, dann die Platine zurücksetzen oder aus- und einschalten</translation>
    </message>
    <message>
        <source>control is locked until one has another number</source>
        <translation>Ansteuerung gesperrt, bis eines eine andere Nummer hat</translation>
    </message>
    <message>
        <source>copy the recording to another one</source>
        <translation>die Aufnahme auf eine andere kopieren</translation>
    </message>
    <message>
        <source>current</source>
        <translation>Strom</translation>
    </message>
    <message>
        <source>current %1 A is above 1.5 × %2 A</source>
        <translation>Strom %1 A liegt über 1,5 × %2 A</translation>
    </message>
    <message>
        <source>current was above %1 A for %2</source>
        <translation>der Strom lag %2 lang über %1 A</translation>
    </message>
    <message>
        <source>delete it, the value says the same</source>
        <translation>löschen, der Wert sagt dasselbe</translation>
    </message>
    <message>
        <source>delete the one of the two that is old</source>
        <translation>den veralteten der beiden löschen</translation>
    </message>
    <message>
        <source>derivative and integral take one signal</source>
        <translation>derivative und integral nehmen ein Signal</translation>
    </message>
    <message>
        <source>do it again</source>
        <translation>wiederholen</translation>
    </message>
    <message>
        <source>dominant bit not sent</source>
        <translation>dominantes Bit nicht gesendet</translation>
    </message>
    <message>
        <source>dry run: %1 lines would be sent over %2</source>
        <translation>Probelauf: %1 Zeilen würden über %2 gesendet</translation>
    </message>
    <message>
        <source>dry run: %1 pages would be written</source>
        <translation>Probelauf: %1 Seiten würden geschrieben</translation>
    </message>
    <message>
        <source>dry run: %1 pages would be written, version %2</source>
        <translation>Probelauf: %1 Seiten würden geschrieben, Version %2</translation>
    </message>
    <message>
        <source>duty</source>
        <translation>Tastgrad</translation>
    </message>
    <message>
        <source>duty %1 % is above %2 %</source>
        <translation>Tastgrad %1 % liegt über %2 %</translation>
    </message>
    <message>
        <source>duty %1 ± %2 %, at most %3 counts/s, %4 counts one way, %5 s</source>
        <translation>Tastgrad %1 ± %2 %, höchstens %3 counts/s, %4 counts in eine Richtung, %5 s</translation>
    </message>
    <message>
        <source>duty is a fraction from −1 to 1</source>
        <translation>der Tastgrad ist ein Bruchteil von −1 bis 1</translation>
    </message>
    <message>
        <source>enable SPI in the device tree (on a Raspberry Pi: dtparam=spi=on) and restart</source>
        <translation>SPI im Device Tree freigeben (am Raspberry Pi: dtparam=spi=on) und neu starten</translation>
    </message>
    <message>
        <source>end it in .pdf or .html</source>
        <translation>ihn auf .pdf oder .html enden lassen</translation>
    </message>
    <message>
        <source>end it in .png, .svg or .pdf</source>
        <translation>mit .png, .svg oder .pdf enden lassen</translation>
    </message>
    <message>
        <source>end that one first, or choose another path</source>
        <translation>zuerst jenen beenden oder einen anderen Pfad wählen</translation>
    </message>
    <message>
        <source>ending=%1: legal are cr, lf and crlf</source>
        <translation>ending=%1: zulässig sind cr, lf und crlf</translation>
    </message>
    <message>
        <source>error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>error-active</source>
        <translation>error-active</translation>
    </message>
    <message>
        <source>error-passive</source>
        <translation>error-passive</translation>
    </message>
    <message>
        <source>error-warning</source>
        <translation>error-warning</translation>
    </message>
    <message>
        <source>every line was confirmed, and the board answers with version %1</source>
        <translation>jede Zeile wurde bestätigt, und die Platine antwortet mit Version %1</translation>
    </message>
    <message>
        <source>every line was confirmed, and the board answers with version %1, the same as before, so that nothing proves the new firmware</source>
        <translation>jede Zeile wurde bestätigt, und die Platine antwortet mit Version %1, derselben wie zuvor, was die neue Firmware nicht belegt</translation>
    </message>
    <message>
        <source>every line was confirmed, but the board does not answer over SPI</source>
        <translation>jede Zeile wurde bestätigt, aber die Platine antwortet nicht über SPI</translation>
    </message>
    <message>
        <source>exchange the wires of the motor or the phases of the encoder</source>
        <translation>Leitungen des Motors oder Phasen des Encoders tauschen</translation>
    </message>
    <message>
        <source>exchange the wires of the motor or the phases of the encoder before any loop is closed</source>
        <translation>Leitungen des Motors oder Phasen des Encoders tauschen, bevor ein Regler geschlossen wird</translation>
    </message>
    <message>
        <source>expected time, channel, value and unit</source>
        <translation>erwartet: Zeit, Kanal, Wert und Einheit</translation>
    </message>
    <message>
        <source>fault &apos;%1&apos; does not parse</source>
        <translation>der Fehler &apos;%1&apos; ist nicht zu verstehen</translation>
    </message>
    <message>
        <source>fewer than 16 samples connect</source>
        <translation>weniger als 16 zusammenhängende Werte</translation>
    </message>
    <message>
        <source>form error</source>
        <translation>Formfehler</translation>
    </message>
    <message>
        <source>frequency response: %1</source>
        <translation>Frequenzgang: %1</translation>
    </message>
    <message>
        <source>friction takes %1 duty of pushes of %2</source>
        <translation>die Reibung nimmt %1 Tastgrad von Stößen mit %2</translation>
    </message>
    <message>
        <source>friction takes %1 of what P makes of a step, at most 60 %</source>
        <translation>die Reibung nimmt %1 dessen, was P aus einem Sprung macht, höchstens 60 %</translation>
    </message>
    <message>
        <source>give %1</source>
        <translation>%1 angeben</translation>
    </message>
    <message>
        <source>keep what is tried, or name a notebook that can be written</source>
        <translation>behalten, was versucht wird, oder ein Versuchsbuch nennen, das sich schreiben lässt</translation>
    </message>
    <message>
        <source>give it a longer time</source>
        <translation>mehr Zeit geben</translation>
    </message>
    <message>
        <source>give a name that ends in .png, .svg or .pdf</source>
        <translation>einen Namen angeben, der auf .png, .svg oder .pdf endet</translation>
    </message>
    <message>
        <source>give a recording, or --help for what else there is</source>
        <translation>eine Aufnahme angeben, oder --help für alles Weitere</translation>
    </message>
    <message>
        <source>give another target</source>
        <translation>ein anderes Ziel angeben</translation>
    </message>
    <message>
        <source>give at least %1 s</source>
        <translation>mindestens %1 s angeben</translation>
    </message>
    <message>
        <source>give it a new one, or switch it off and on</source>
        <translation>ihm eine neue geben oder es aus- und einschalten</translation>
    </message>
    <message>
        <source>gpiodetect lists those there are</source>
        <translation>gpiodetect nennt die vorhandenen</translation>
    </message>
    <message>
        <source>identify it anew</source>
        <translation>neu identifizieren</translation>
    </message>
    <message>
        <source>image %1 of %2 pages, unit runs %3, bootloader %4</source>
        <translation>Image %1 mit %2 Seiten, Gerät läuft mit %3, Bootloader %4</translation>
    </message>
    <message>
        <source>image %1 of %2 pages, unit without application, bootloader %3</source>
        <translation>Image %1 mit %2 Seiten, Gerät ohne Anwendung, Bootloader %3</translation>
    </message>
    <message>
        <source>in position mode a new counter would make the motor jump</source>
        <translation>in der Positionsregelung ließe ein neuer Zähler den Motor springen</translation>
    </message>
    <message>
        <source>install it with</source>
        <translation>installieren mit</translation>
    </message>
    <message>
        <source>install its vendor&apos;s driver</source>
        <translation>den Treiber des Herstellers installieren</translation>
    </message>
    <message>
        <source>install the package that has it and try again</source>
        <translation>das Paket installieren, das es enthält, und erneut versuchen</translation>
    </message>
    <message>
        <source>installed are: %1</source>
        <translation>installiert sind: %1</translation>
    </message>
    <message>
        <source>is a directory</source>
        <translation>ist ein Verzeichnis</translation>
    </message>
    <message>
        <source>is longer than %1 bytes</source>
        <translation>ist länger als %1 Bytes</translation>
    </message>
    <message>
        <source>is not a regular file</source>
        <translation>ist keine gewöhnliche Datei</translation>
    </message>
    <message>
        <source>it came to rest %1 of the step away from its target</source>
        <translation>er kam %1 des Sprungs neben seinem Ziel zur Ruhe</translation>
    </message>
    <message>
        <source>it cannot be tried</source>
        <translation>es lässt sich nicht probieren</translation>
    </message>
    <message>
        <source>it cannot be written (system error %1)</source>
        <translation>sie lässt sich nicht schreiben (Systemfehler %1)</translation>
    </message>
    <message>
        <source>it did not come back</source>
        <translation>es kam nicht zurück</translation>
    </message>
    <message>
        <source>it did not settle</source>
        <translation>er kam nicht zur Ruhe</translation>
    </message>
    <message>
        <source>it has %1</source>
        <translation>es hat %1</translation>
    </message>
    <message>
        <source>it is a Vector BLF log</source>
        <translation>es ist ein Vector-BLF-Protokoll</translation>
    </message>
    <message>
        <source>it is a disk</source>
        <translation>es ist ein Datenträger</translation>
    </message>
    <message>
        <source>it is a folder</source>
        <translation>ist ein Ordner</translation>
    </message>
    <message>
        <source>it is a recording</source>
        <translation>es ist eine Aufnahme</translation>
    </message>
    <message>
        <source>it is not proven which codes this drive speaks</source>
        <translation>es ist nicht nachgewiesen, welche Codes dieser Antrieb spricht</translation>
    </message>
    <message>
        <source>it is not proven which codes this drive speaks, and the wrong ones start it at full power</source>
        <translation>es ist nicht nachgewiesen, welche Codes dieser Antrieb spricht, und die falschen starten ihn mit voller Leistung</translation>
    </message>
    <message>
        <source>it may rest %1 short of its target, less does not move its integral</source>
        <translation>er kann %1 vor seinem Ziel stehen bleiben, weniger bewegt sein Integral nicht</translation>
    </message>
    <message>
        <source>it may rest %1 short of its target, less does not move its motor</source>
        <translation>er kann %1 vor seinem Ziel stehen bleiben, weniger bewegt seinen Motor nicht</translation>
    </message>
    <message>
        <source>it overshot by %1, predicted were %2</source>
        <translation>er schwang um %1 über, vorhergesagt waren %2</translation>
    </message>
    <message>
        <source>it swung itself up with P %1 and D %2</source>
        <translation>er schwang sich mit P %1 und D %2 auf</translation>
    </message>
    <message>
        <source>it took %1 to settle, predicted were %2</source>
        <translation>er brauchte %1 bis zur Ruhe, vorhergesagt waren %2</translation>
    </message>
    <message>
        <source>it took longer than 1.5 × %1 s</source>
        <translation>es dauerte länger als 1,5 × %1 s</translation>
    </message>
    <message>
        <source>it was put aside as %1, and what it kept of the device is unknown again</source>
        <translation>es wurde als %1 beiseitegelegt, und was es vom Gerät festhielt, ist wieder unbekannt</translation>
    </message>
    <message>
        <source>it was stopped</source>
        <translation>er wurde gestoppt</translation>
    </message>
    <message>
        <source>it would stop %1 counts from the start, %2 are allowed</source>
        <translation>er käme %1 counts vom Start zum Stehen, erlaubt sind %2</translation>
    </message>
    <message>
        <source>its P or its position is not known, so whether this step overflows its loop is not either</source>
        <translation>P oder Position sind nicht bekannt, also auch nicht, ob dieser Sprung den Regler überlaufen lässt</translation>
    </message>
    <message>
        <source>its address is not a number</source>
        <translation>seine Adresse ist keine Zahl</translation>
    </message>
    <message>
        <source>its dialect is not known</source>
        <translation>sein Dialekt ist nicht bekannt</translation>
    </message>
    <message>
        <source>its dialect is not known yet</source>
        <translation>sein Dialekt ist noch nicht bekannt</translation>
    </message>
    <message>
        <source>its dialect is not known, so no move can be sent</source>
        <translation>der Dialekt ist nicht bekannt, daher lässt sich keine Bewegung senden</translation>
    </message>
    <message>
        <source>its error level is 1, which makes every reading fail: set error.level to 0</source>
        <translation>seine Fehlerstufe ist 1, jedes Lesen schlägt fehl: error.level auf 0 setzen</translation>
    </message>
    <message>
        <source>its position is not known yet</source>
        <translation>die Position ist noch nicht bekannt</translation>
    </message>
    <message>
        <source>its profile is not known, so a move that passes its target could not be told</source>
        <translation>sein Profil ist nicht bekannt, eine Fahrt über das Ziel hinaus wäre nicht zu erkennen</translation>
    </message>
    <message>
        <source>its reader has gone</source>
        <translation>wer daraus las, ist weg</translation>
    </message>
    <message>
        <source>leave it out</source>
        <translation>es weglassen</translation>
    </message>
    <message>
        <source>leave out --target</source>
        <translation>--target weglassen</translation>
    </message>
    <message>
        <source>leave out erasing them</source>
        <translation>deren Löschen weglassen</translation>
    </message>
    <message>
        <source>leave out interface=</source>
        <translation>interface= weglassen</translation>
    </message>
    <message>
        <source>leave the other way in out</source>
        <translation>den anderen Weg weglassen</translation>
    </message>
    <message>
        <source>leave the target out</source>
        <translation>das Ziel weglassen</translation>
    </message>
    <message>
        <source>legal is %1</source>
        <translation>zulässig ist %1</translation>
    </message>
    <message>
        <source>legal is 0.01 … 1000, or max</source>
        <translation>zulässig ist 0.01 … 1000 oder max</translation>
    </message>
    <message>
        <source>legal is 1 … 500</source>
        <translation>zulässig ist 1 … 500</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>Zeile %1</translation>
    </message>
    <message>
        <source>line %1 is neither a line of candump -L nor the beginning of a Vector ASC log</source>
        <translation>Zeile %1 ist weder eine Zeile von candump -L noch der Anfang eines Vector-ASC-Protokolls</translation>
    </message>
    <message>
        <source>line %1 is not a line of a Vector ASC log</source>
        <translation>Zeile %1 ist keine Zeile eines Vector-ASC-Protokolls</translation>
    </message>
    <message>
        <source>line %1 is not a line of candump -L</source>
        <translation>Zeile %1 ist keine Zeile von candump -L</translation>
    </message>
    <message>
        <source>link option %1=%2 is out of range</source>
        <translation>Linkoption %1=%2 liegt außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>link option bitrate=%1 is out of range</source>
        <translation>Linkoption bitrate=%1 liegt außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>listen-only: nothing can be sent</source>
        <translation>nur hörend: senden ist nicht möglich</translation>
    </message>
    <message>
        <source>look at it again</source>
        <translation>erneut ansehen</translation>
    </message>
    <message>
        <source>look at the wiring of the input</source>
        <translation>Verdrahtung des Eingangs prüfen</translation>
    </message>
    <message>
        <source>look whether something brakes or limits the motor</source>
        <translation>prüfen, ob etwas den Motor bremst oder begrenzt</translation>
    </message>
    <message>
        <source>lower the gains or the steps</source>
        <translation>Verstärkungen oder Sprünge verkleinern</translation>
    </message>
    <message>
        <source>made way for an order</source>
        <translation>hat einem Auftrag Platz gemacht</translation>
    </message>
    <message>
        <source>make room in %1</source>
        <translation>in %1 Platz schaffen</translation>
    </message>
    <message>
        <source>make room, or choose another place</source>
        <translation>Platz schaffen oder einen anderen Ort wählen</translation>
    </message>
    <message>
        <source>more bytes than the device announced</source>
        <translation>mehr Bytes, als das Gerät ankündigte</translation>
    </message>
    <message>
        <source>more columns than the first line has</source>
        <translation>mehr Spalten als die erste Zeile</translation>
    </message>
    <message>
        <source>more than 1000 channels</source>
        <translation>mehr als 1000 Kanäle</translation>
    </message>
    <message>
        <source>move it away</source>
        <translation>sie verschieben</translation>
    </message>
    <message>
        <source>name a file</source>
        <translation>eine Datei nennen</translation>
    </message>
    <message>
        <source>name a recording</source>
        <translation>eine Aufnahme nennen</translation>
    </message>
    <message>
        <source>name another folder</source>
        <translation>einen anderen Ordner nennen</translation>
    </message>
    <message>
        <source>name it by its number; &apos;motorbenchctl snapshots&apos; lists them</source>
        <translation>ihn mit seiner Nummer nennen; &apos;motorbenchctl snapshots&apos; listet sie</translation>
    </message>
    <message>
        <source>name its serial port, for example --via serial:/dev/ttyUSB0</source>
        <translation>den seriellen Anschluss nennen, etwa --via serial:/dev/ttyUSB0</translation>
    </message>
    <message>
        <source>name one such as /dev/ttyUSB0</source>
        <translation>eine nennen, etwa /dev/ttyUSB0</translation>
    </message>
    <message>
        <source>name one, such as sim:can</source>
        <translation>eine nennen, etwa sim:can</translation>
    </message>
    <message>
        <source>name one: %1 or %2</source>
        <translation>eines nennen: %1 oder %2</translation>
    </message>
    <message>
        <source>no %1 answers as number %2 on %3</source>
        <translation>kein %1 antwortet als Nummer %2 an %3</translation>
    </message>
    <message>
        <source>no %1 sends as number %2 in %3</source>
        <translation>kein %1 sendet als Nummer %2 in %3</translation>
    </message>
    <message>
        <source>no CAN frame: its identifier or size is out of range</source>
        <translation>kein CAN-Frame: Identifier oder Größe liegen außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>no D was found with which a small P neither swings nor creeps</source>
        <translation>kein D gefunden, mit dem ein kleines P weder schwingt noch kriecht</translation>
    </message>
    <message>
        <source>no application runs in this unit</source>
        <translation>in diesem Gerät läuft keine Anwendung</translation>
    </message>
    <message>
        <source>no experiment: %1</source>
        <translation>kein Versuch: %1</translation>
    </message>
    <message>
        <source>no gain of the velocity loop turns the motor</source>
        <translation>keine Verstärkung des Drehzahlreglers dreht den Motor</translation>
    </message>
    <message>
        <source>no history is kept here</source>
        <translation>hier wird keine Historie geführt</translation>
    </message>
    <message>
        <source>no instruction at the entry point 0x00400</source>
        <translation>keine Anweisung am Einsprung 0x00400</translation>
    </message>
    <message>
        <source>no permission to read it</source>
        <translation>keine Erlaubnis, es zu lesen</translation>
    </message>
    <message>
        <source>no permission to write there</source>
        <translation>keine Berechtigung, dort zu schreiben</translation>
    </message>
    <message>
        <source>no pseudo terminal can be had: %1</source>
        <translation>es gibt kein Pseudoterminal: %1</translation>
    </message>
    <message>
        <source>no push met the current limit</source>
        <translation>kein Stoß traf die Strombegrenzung</translation>
    </message>
    <message>
        <source>no ready line is wired</source>
        <translation>keine Ready-Leitung ist verdrahtet</translation>
    </message>
    <message>
        <source>no reset line is wired</source>
        <translation>keine Reset-Leitung ist verdrahtet</translation>
    </message>
    <message>
        <source>no sample for %1</source>
        <translation>%1 lang kein Messwert</translation>
    </message>
    <message>
        <source>no snapshot of what was found: %1</source>
        <translation>kein Schnappschuss des Vorgefundenen: %1</translation>
    </message>
    <message>
        <source>no snapshot of what was there: %1</source>
        <translation>kein Schnappschuss des Vorherigen: %1</translation>
    </message>
    <message>
        <source>no snapshot: %1</source>
        <translation>kein Schnappschuss: %1</translation>
    </message>
    <message>
        <source>no snapshots are kept here</source>
        <translation>hier werden keine Schnappschüsse geführt</translation>
    </message>
    <message>
        <source>no step met the end of the output</source>
        <translation>kein Sprung traf das Ende des Ausgangs</translation>
    </message>
    <message>
        <source>no such file</source>
        <translation>keine solche Datei</translation>
    </message>
    <message>
        <source>no version at 0x1EFFC</source>
        <translation>keine Version bei 0x1EFFC</translation>
    </message>
    <message>
        <source>nobody acknowledged</source>
        <translation>niemand hat quittiert</translation>
    </message>
    <message>
        <source>nobody reads from this pipe</source>
        <translation>niemand liest aus dieser Pipe</translation>
    </message>
    <message>
        <source>nobody serves %1</source>
        <translation>niemand bedient %1</translation>
    </message>
    <message>
        <source>not a parameter file: it has no &quot;parameters&quot;</source>
        <translation>keine Parameterdatei: sie hat kein &quot;parameters&quot;</translation>
    </message>
    <message>
        <source>not sent: %1 where a 24-bit instruction has none, the file may be for another processor</source>
        <translation>nicht gesendet: %1, wo eine 24-Bit-Anweisung keine hat; die Datei ist vielleicht für einen anderen Prozessor</translation>
    </message>
    <message>
        <source>nothing could put the gains back after a crash</source>
        <translation>nach einem Absturz könnte nichts die Verstärkungen zurückschreiben</translation>
    </message>
    <message>
        <source>nothing has been recorded yet</source>
        <translation>noch wurde nichts aufgezeichnet</translation>
    </message>
    <message>
        <source>nothing to send</source>
        <translation>nichts zu senden</translation>
    </message>
    <message>
        <source>nothing was measured</source>
        <translation>nichts wurde gemessen</translation>
    </message>
    <message>
        <source>nothing was saved</source>
        <translation>nichts wurde gespeichert</translation>
    </message>
    <message>
        <source>nothing was written</source>
        <translation>nichts wurde geschrieben</translation>
    </message>
    <message>
        <source>nothing was written; the image fits, %1 pages</source>
        <translation>nichts wurde geschrieben; das Image passt, %1 Seiten</translation>
    </message>
    <message>
        <source>number %1 still keeps a move that was stopped before it began, and would begin it too</source>
        <translation>Nummer %1 hält noch eine Bewegung, die vor ihrem Beginn gestoppt wurde, und würde sie auch beginnen</translation>
    </message>
    <message>
        <source>one more would make the drive load something else. Erase its settings pages with a firmware update (erase settings), then save again</source>
        <translation>einmal mehr, und der Antrieb lädt etwas anderes. Die Seiten der Einstellungen mit einer Aktualisierung löschen (Einstellungen löschen), dann neu speichern</translation>
    </message>
    <message>
        <source>only its power stops it</source>
        <translation>nur Trennen der Versorgung stoppt ihn</translation>
    </message>
    <message>
        <source>only those are recorded</source>
        <translation>nur solche werden aufgenommen</translation>
    </message>
    <message>
        <source>open it again</source>
        <translation>erneut öffnen</translation>
    </message>
    <message>
        <source>open that terminal as serial:%1</source>
        <translation>dieses Terminal als serial:%1 öffnen</translation>
    </message>
    <message>
        <source>open the link that it was made on</source>
        <translation>die Verbindung öffnen, an der sie entstand</translation>
    </message>
    <message>
        <source>openocd is not installed</source>
        <translation>openocd ist nicht installiert</translation>
    </message>
    <message>
        <source>option &apos;%1&apos; is not KEY=VALUE</source>
        <translation>Option &apos;%1&apos; ist nicht SCHLÜSSEL=WERT</translation>
    </message>
    <message>
        <source>page %1 was said to be written before its bytes can have arrived</source>
        <translation>Seite %1 wurde als geschrieben gemeldet, bevor ihre Bytes angekommen sein können</translation>
    </message>
    <message>
        <source>parameters that were changed last may be lost: %1</source>
        <translation>zuletzt geänderte Parameter können verloren sein: %1</translation>
    </message>
    <message>
        <source>pause=%1: legal are 0 to 1000 milliseconds</source>
        <translation>pause=%1: zulässig sind 0 bis 1000 Millisekunden</translation>
    </message>
    <message>
        <source>plug in the adapter, or name another port</source>
        <translation>Adapter einstecken oder anderen Anschluss nennen</translation>
    </message>
    <message>
        <source>plug it in again</source>
        <translation>wieder einstecken</translation>
    </message>
    <message>
        <source>plug one in</source>
        <translation>einen einstecken</translation>
    </message>
    <message>
        <source>position has 32 bits</source>
        <translation>die Position hat 32 Bit</translation>
    </message>
    <message>
        <source>protocol error</source>
        <translation>Protokollfehler</translation>
    </message>
    <message>
        <source>proving: a step of %1 A</source>
        <translation>Nachweis: ein Sprung von %1 A</translation>
    </message>
    <message>
        <source>proving: a step of %1 counts</source>
        <translation>Nachweis: ein Sprung von %1 counts</translation>
    </message>
    <message>
        <source>proving: a step of %1 counts/s</source>
        <translation>Nachweis: ein Sprung von %1 counts/s</translation>
    </message>
    <message>
        <source>pty links have the option baud=BITS_PER_SECOND, not &apos;%1=%2&apos;</source>
        <translation>pty-Links haben die Option baud=BIT_PRO_SEKUNDE, nicht &apos;%1=%2&apos;</translation>
    </message>
    <message>
        <source>pty: is where &apos;simulate&apos; puts its devices</source>
        <translation>unter pty: legt „simulate“ seine Geräte an</translation>
    </message>
    <message>
        <source>push harder or longer</source>
        <translation>stärker oder länger stoßen</translation>
    </message>
    <message>
        <source>push longer, or ask for faster samples</source>
        <translation>länger stoßen oder schnellere Messwerte anfordern</translation>
    </message>
    <message>
        <source>push with two sizes</source>
        <translation>mit zwei Größen stoßen</translation>
    </message>
    <message>
        <source>pushes of one size do not tell friction from gain</source>
        <translation>Stöße einer Größe trennen Reibung und Verstärkung nicht</translation>
    </message>
    <message>
        <source>pushing with %1 duty for %2 s</source>
        <translation>Stoß mit %1 Tastgrad für %2 s</translation>
    </message>
    <message>
        <source>pushing with %1 duty for %2 s, %3 times</source>
        <translation>Stoß mit %1 Tastgrad für %2 s, %3-mal</translation>
    </message>
    <message>
        <source>qtcan links have the option bitrate=BITS_PER_SECOND, not &apos;%1=%2&apos;</source>
        <translation>qtcan-Links haben die Option bitrate=BIT_PRO_SEKUNDE, nicht &apos;%1=%2&apos;</translation>
    </message>
    <message>
        <source>read gain.p</source>
        <translation>gain.p lesen</translation>
    </message>
    <message>
        <source>read it again</source>
        <translation>neu lesen</translation>
    </message>
    <message>
        <source>read it first</source>
        <translation>es zuerst lesen</translation>
    </message>
    <message>
        <source>read profile.velocity and profile.acceleration</source>
        <translation>profile.velocity und profile.acceleration lesen</translation>
    </message>
    <message>
        <source>recessive bit not sent</source>
        <translation>rezessives Bit nicht gesendet</translation>
    </message>
    <message>
        <source>record again</source>
        <translation>erneut aufnehmen</translation>
    </message>
    <message>
        <source>record type %1 is unknown</source>
        <translation>Datensatzart %1 ist unbekannt</translation>
    </message>
    <message>
        <source>remove it</source>
        <translation>sie entfernen</translation>
    </message>
    <message>
        <source>remove it, or make it readable</source>
        <translation>sie entfernen oder lesbar machen</translation>
    </message>
    <message>
        <source>replay links have no option &apos;%1&apos;</source>
        <translation>replay kennt die Option „%1“ nicht</translation>
    </message>
    <message>
        <source>residual %1 of what counts and clocks explain, at most 3</source>
        <translation>Rest %1 dessen, was Zähler und Uhr erklären, höchstens 3</translation>
    </message>
    <message>
        <source>run avrdude by hand to see all it says</source>
        <translation>avrdude von Hand starten, um alles zu sehen</translation>
    </message>
    <message>
        <source>run it by hand to see all it says</source>
        <translation>es von Hand starten, um alles zu sehen</translation>
    </message>
    <message>
        <source>run it by hand with -c %1</source>
        <translation>es von Hand mit -c %1 starten</translation>
    </message>
    <message>
        <source>run it by hand with interface %1</source>
        <translation>es von Hand mit der Schnittstelle %1 starten</translation>
    </message>
    <message>
        <source>sample point %1 %</source>
        <translation>Abtastpunkt %1 %</translation>
    </message>
    <message>
        <source>save it as ASC and take that</source>
        <translation>als ASC speichern und dieses verwenden</translation>
    </message>
    <message>
        <source>scan again, or choose its dialect by hand</source>
        <translation>neu suchen oder den Dialekt von Hand wählen</translation>
    </message>
    <message>
        <source>see that nothing is loose and that steps look alike</source>
        <translation>prüfen, ob nichts lose ist und die Sprünge einander gleichen</translation>
    </message>
    <message>
        <source>see that nothing is loose, and write gains once with which it comes to rest</source>
        <translation>prüfen, ob nichts lose ist, und einmal Verstärkungen schreiben, mit denen er zur Ruhe kommt</translation>
    </message>
    <message>
        <source>see that nothing is loose; a stronger load than it was built for cannot be tuned</source>
        <translation>prüfen, ob nichts lose ist; eine stärkere Last, als er verträgt, lässt sich nicht abstimmen</translation>
    </message>
    <message>
        <source>see that the motor is connected</source>
        <translation>prüfen, ob der Motor angeschlossen ist</translation>
    </message>
    <message>
        <source>see whether a load always pulls one way</source>
        <translation>prüfen, ob eine Last stets in eine Richtung zieht</translation>
    </message>
    <message>
        <source>see whether brushes and plugs make contact</source>
        <translation>prüfen, ob Bürsten und Stecker Kontakt haben</translation>
    </message>
    <message>
        <source>select a longer stretch</source>
        <translation>eine längere Strecke wählen</translation>
    </message>
    <message>
        <source>sending the firmware</source>
        <translation>Senden der Firmware</translation>
    </message>
    <message>
        <source>serial number %1</source>
        <translation>Seriennummer %1</translation>
    </message>
    <message>
        <source>several units have a snapshot &apos;%1&apos;</source>
        <translation>mehrere Geräte haben einen Schnappschuss &apos;%1&apos;</translation>
    </message>
    <message>
        <source>sim: stands for several links</source>
        <translation>sim: steht für mehrere Verbindungen</translation>
    </message>
    <message>
        <source>simulated links belong to a bench</source>
        <translation>simulierte Links gehören zu einem Prüfstand</translation>
    </message>
    <message>
        <source>sine %1 of %2, %3 Hz: %4</source>
        <translation>Sinus %1 von %2, %3 Hz: %4</translation>
    </message>
    <message>
        <source>snapshot %1, %2: %3 values</source>
        <translation>Schnappschuss %1, %2: %3 Werte</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>Drehzahl</translation>
    </message>
    <message>
        <source>speed %1 counts/s is above 1.2 × %2 counts/s</source>
        <translation>Drehzahl %1 counts/s liegt über 1,2 × %2 counts/s</translation>
    </message>
    <message>
        <source>speed is 10000 to 10000000 Hz, not &apos;%1&apos;</source>
        <translation>speed ist 10000 bis 10000000 Hz, nicht &apos;%1&apos;</translation>
    </message>
    <message>
        <source>speed, ready and reset are known</source>
        <translation>bekannt sind speed, ready und reset</translation>
    </message>
    <message>
        <source>speed=%1 is no speed</source>
        <translation>speed=%1 ist keine Drehzahl</translation>
    </message>
    <message>
        <source>spidev links have no option &apos;%1&apos;</source>
        <translation>spidev-Links haben keine Option &apos;%1&apos;</translation>
    </message>
    <message>
        <source>stalled, or the encoder is dead: less than 3 counts in %1</source>
        <translation>blockiert, oder der Encoder ist tot: weniger als 3 counts in %1</translation>
    </message>
    <message>
        <source>start it again</source>
        <translation>neu starten</translation>
    </message>
    <message>
        <source>start the reader first</source>
        <translation>zuerst den Leser starten</translation>
    </message>
    <message>
        <source>start the simulator again</source>
        <translation>den Simulator neu starten</translation>
    </message>
    <message>
        <source>start the simulator first</source>
        <translation>zuerst den Simulator starten</translation>
    </message>
    <message>
        <source>steps with one pair of gains only do not tell what each of them does</source>
        <translation>Sprünge mit nur einem Paar Verstärkungen sagen nicht, was jede bewirkt</translation>
    </message>
    <message>
        <source>stop it before its gains are put back</source>
        <translation>ihn stoppen, bevor seine Verstärkungen zurückgeschrieben werden</translation>
    </message>
    <message>
        <source>stop it first</source>
        <translation>zuerst stoppen</translation>
    </message>
    <message>
        <source>stop it there first</source>
        <translation>zuerst dort stoppen</translation>
    </message>
    <message>
        <source>stop the motor first</source>
        <translation>zuerst den Motor stoppen</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>gestoppt</translation>
    </message>
    <message>
        <source>stopped: the window did not respond in time</source>
        <translation>gestoppt: das Fenster reagierte nicht rechtzeitig</translation>
    </message>
    <message>
        <source>stuff error</source>
        <translation>Stuff-Fehler</translation>
    </message>
    <message>
        <source>such a line reads %1</source>
        <translation>eine solche Zeile lautet %1</translation>
    </message>
    <message>
        <source>supply %1 V is outside %2 … %3 V</source>
        <translation>Versorgung %1 V liegt außerhalb von %2 … %3 V</translation>
    </message>
    <message>
        <source>switch it off and on</source>
        <translation>schalten Sie ihn aus und wieder ein</translation>
    </message>
    <message>
        <source>switch the devices on, check the cable and that two 120 Ω resistors end the bus, and that every device has the bit rate of this interface</source>
        <translation>die Geräte einschalten, Kabel und zwei 120-Ω-Abschlusswiderstände prüfen, und ob jedes Gerät die Bitrate dieser Schnittstelle hat</translation>
    </message>
    <message>
        <source>take a finer encoder or a calmer loop</source>
        <translation>einen feineren Encoder oder einen ruhigeren Regler nehmen</translation>
    </message>
    <message>
        <source>take a smaller step or widen it</source>
        <translation>einen kleineren Sprung nehmen oder sie erweitern</translation>
    </message>
    <message>
        <source>take one of them</source>
        <translation>eines davon nehmen</translation>
    </message>
    <message>
        <source>take the jumper out and reset it</source>
        <translation>die Steckbrücke abziehen und sie zurücksetzen</translation>
    </message>
    <message>
        <source>take the jumper out; the board is asked for its version</source>
        <translation>die Steckbrücke abziehen; die Platine wird nach ihrer Version gefragt</translation>
    </message>
    <message>
        <source>temperature %1 °C is within 5 K of %2 °C</source>
        <translation>Temperatur %1 °C liegt innerhalb 5 K von %2 °C</translation>
    </message>
    <message>
        <source>the %1 loop was saved %2 times; after %3 its settings pages must be erased</source>
        <translation>der Regler %1 wurde %2-mal gespeichert; nach %3 müssen seine Seiten gelöscht werden</translation>
    </message>
    <message>
        <source>the acknowledge delimiter</source>
        <translation>dem Acknowledge-Delimiter</translation>
    </message>
    <message>
        <source>the acknowledge slot</source>
        <translation>dem Acknowledge-Slot</translation>
    </message>
    <message>
        <source>the base of the numbers is %1, not hex or dec</source>
        <translation>die Basis der Zahlen ist %1, nicht hex oder dec</translation>
    </message>
    <message>
        <source>the board answered with an error that its documents do not name</source>
        <translation>die Platine antwortete mit einem Fehler, den ihre Unterlagen nicht nennen</translation>
    </message>
    <message>
        <source>the board did not answer</source>
        <translation>die Platine hat nicht geantwortet</translation>
    </message>
    <message>
        <source>the board did not tell its status</source>
        <translation>die Platine hat ihren Zustand nicht genannt</translation>
    </message>
    <message>
        <source>the board does not know this command</source>
        <translation>die Platine kennt diesen Befehl nicht</translation>
    </message>
    <message>
        <source>the board found the packet malformed</source>
        <translation>die Platine hielt das Paket für fehlerhaft</translation>
    </message>
    <message>
        <source>the board has axes 1 to 4</source>
        <translation>die Platine hat die Achsen 1 bis 4</translation>
    </message>
    <message>
        <source>the board has no number: chip select tells boards apart</source>
        <translation>die Platine hat keine Nummer: Chip Select unterscheidet Platinen</translation>
    </message>
    <message>
        <source>the board has no such mode</source>
        <translation>die Platine hat keine solche Betriebsart</translation>
    </message>
    <message>
        <source>the board has one set of gains per axis</source>
        <translation>die Platine hat je Achse einen Satz Verstärkungen</translation>
    </message>
    <message>
        <source>the board is updated over its UART</source>
        <translation>die Platine wird über ihren UART aktualisiert</translation>
    </message>
    <message>
        <source>the board keeps nothing without power</source>
        <translation>die Platine behält ohne Strom nichts</translation>
    </message>
    <message>
        <source>the board may want velocity targets times 4096: choose that setting, and try again</source>
        <translation>die Platine erwartet Drehzahlsollwerte vielleicht mal 4096: diese Einstellung wählen und erneut versuchen</translation>
    </message>
    <message>
        <source>the board refused a value</source>
        <translation>die Platine hat einen Wert abgelehnt</translation>
    </message>
    <message>
        <source>the board restarted at %1</source>
        <translation>die Platine startete bei %1 neu</translation>
    </message>
    <message>
        <source>the board sent a reply without a return code</source>
        <translation>die Platine sandte eine Antwort ohne Rückgabewert</translation>
    </message>
    <message>
        <source>the board speaks protocol %1, this program was written for protocol 1; watch it before it is driven</source>
        <translation>die Platine spricht Protokoll %1, dieses Programm wurde für Protokoll 1 geschrieben; vor dem Ansteuern beobachten</translation>
    </message>
    <message>
        <source>the board was reset since its settings were written</source>
        <translation>die Platine wurde zurückgesetzt, seit ihre Einstellungen geschrieben wurden</translation>
    </message>
    <message>
        <source>the board was unplugged</source>
        <translation>die Platine wurde abgezogen</translation>
    </message>
    <message>
        <source>the bootloader did not announce itself</source>
        <translation>der Bootloader hat sich nicht gemeldet</translation>
    </message>
    <message>
        <source>the bootloader refuses page %1</source>
        <translation>der Bootloader lehnt Seite %1 ab</translation>
    </message>
    <message>
        <source>the bootloader said nothing</source>
        <translation>der Bootloader sagte nichts</translation>
    </message>
    <message>
        <source>the cable was pulled out</source>
        <translation>das Kabel wurde abgezogen</translation>
    </message>
    <message>
        <source>the checksum</source>
        <translation>der Prüfsumme</translation>
    </message>
    <message>
        <source>the checksum delimiter</source>
        <translation>dem Prüfsummen-Delimiter</translation>
    </message>
    <message>
        <source>the controller lost frames to send</source>
        <translation>der Controller verlor zu sendende Frames</translation>
    </message>
    <message>
        <source>the controller lost received frames</source>
        <translation>der Controller verlor empfangene Frames</translation>
    </message>
    <message>
        <source>the controller may hold half a program, and runs again once an update has succeeded</source>
        <translation>der Controller enthält womöglich ein halbes Programm und läuft erst nach einem erfolgreichen Update wieder</translation>
    </message>
    <message>
        <source>the controller started again</source>
        <translation>der Controller ist neu gestartet</translation>
    </message>
    <message>
        <source>the current did not follow the duty, so its resistance is not known</source>
        <translation>der Strom folgte dem Tastgrad nicht, sein Widerstand ist also unbekannt</translation>
    </message>
    <message>
        <source>the current limit cut into the pushes</source>
        <translation>die Strombegrenzung griff in die Stöße ein</translation>
    </message>
    <message>
        <source>the data</source>
        <translation>den Daten</translation>
    </message>
    <message>
        <source>the data masks have an unexpected length</source>
        <translation>die Datenmasken haben eine unerwartete Länge</translation>
    </message>
    <message>
        <source>the data runs past the end of 32-bit addresses</source>
        <translation>die Daten reichen über das Ende der 32-Bit-Adressen</translation>
    </message>
    <message>
        <source>the data runs past the end of its 64 KiB segment</source>
        <translation>die Daten reichen über das Ende ihres 64-KiB-Segments</translation>
    </message>
    <message>
        <source>the device answers with no application</source>
        <translation>das Gerät antwortet ohne Anwendung</translation>
    </message>
    <message>
        <source>the device restarted before its flash was proved to be written</source>
        <translation>Neustart, bevor das Schreiben des Flash nachgewiesen war</translation>
    </message>
    <message>
        <source>the device&apos;s rate was not put back: %1</source>
        <translation>die Rate des Geräts wurde nicht zurückgesetzt: %1</translation>
    </message>
    <message>
        <source>the disk has not made %1 within 10 s</source>
        <translation>der Datenträger hat %1 nicht innerhalb von 10 s angelegt</translation>
    </message>
    <message>
        <source>the disk is full</source>
        <translation>die Festplatte ist voll</translation>
    </message>
    <message>
        <source>the disk of %1 does not answer</source>
        <translation>der Datenträger von %1 antwortet nicht</translation>
    </message>
    <message>
        <source>the drive does not check it and would overwrite its memory</source>
        <translation>der Antrieb prüft es nicht und würde seinen Speicher überschreiben</translation>
    </message>
    <message>
        <source>the duty changed its direction %1 times in a second</source>
        <translation>der Tastgrad wechselte in einer Sekunde %1-mal die Richtung</translation>
    </message>
    <message>
        <source>the encoder counts against the power</source>
        <translation>der Encoder zählt entgegen der Leistung</translation>
    </message>
    <message>
        <source>the end of frame</source>
        <translation>dem Ende des Frames</translation>
    </message>
    <message>
        <source>the file has no lines to send</source>
        <translation>die Datei hat keine Zeilen zum Senden</translation>
    </message>
    <message>
        <source>the file has reached the greatest size there</source>
        <translation>die Datei hat dort die größte zulässige Größe erreicht</translation>
    </message>
    <message>
        <source>the formula is nested too deeply</source>
        <translation>die Formel ist zu tief geschachtelt</translation>
    </message>
    <message>
        <source>the formula uses no signal</source>
        <translation>die Formel benutzt kein Signal</translation>
    </message>
    <message>
        <source>the frame has %1 of %2 bytes</source>
        <translation>der Frame hat %1 von %2 Bytes</translation>
    </message>
    <message>
        <source>the frame is of the kind %1, not d or r</source>
        <translation>der Frame ist von der Art %1, nicht d oder r</translation>
    </message>
    <message>
        <source>the frame says %1 in the place of Rx or Tx</source>
        <translation>der Frame sagt %1 an der Stelle von Rx oder Tx</translation>
    </message>
    <message>
        <source>the gain had nothing to act on</source>
        <translation>die Verstärkung hatte nichts, worauf sie wirkt</translation>
    </message>
    <message>
        <source>the gains of this loop are not known here, so its target stays within %1 of where it is: a weak loop may not move it; write its p, d and divisor once</source>
        <translation>die Verstärkungen dieses Reglers sind hier unbekannt, sein Ziel bleibt also innerhalb %1 von seinem Ort: ein schwacher Regler bewegt ihn vielleicht nicht; einmal p, d und divisor schreiben</translation>
    </message>
    <message>
        <source>the gains stored in the drive are erased; all its loops do nothing until they are written again</source>
        <translation>die im Antrieb gespeicherten Verstärkungen sind gelöscht; seine Regler tun nichts, bis sie neu geschrieben sind</translation>
    </message>
    <message>
        <source>the gains that trial #%1 had changed are put back</source>
        <translation>die von Versuch #%1 geänderten Verstärkungen sind zurückgeschrieben</translation>
    </message>
    <message>
        <source>the history does not have this write: %1</source>
        <translation>die Historie hat dieses Schreiben nicht: %1</translation>
    </message>
    <message>
        <source>the history has an unexpected length</source>
        <translation>die Historie hat eine unerwartete Länge</translation>
    </message>
    <message>
        <source>the history of %1 has nothing to do again</source>
        <translation>die Historie von %1 hat nichts zu wiederholen</translation>
    </message>
    <message>
        <source>the history of %1 has nothing to undo</source>
        <translation>die Historie von %1 hat nichts rückgängig zu machen</translation>
    </message>
    <message>
        <source>the identifier</source>
        <translation>dem Identifier</translation>
    </message>
    <message>
        <source>the identifier extension bit</source>
        <translation>dem Identifier-Extension-Bit</translation>
    </message>
    <message>
        <source>the image is for product 602, this unit is product %1%2%3</source>
        <translation>das Image ist für Produkt 602, dieses Gerät ist Produkt %1%2%3</translation>
    </message>
    <message>
        <source>the image itself writes the settings pages</source>
        <translation>das Image schreibt selbst die Seiten der Einstellungen</translation>
    </message>
    <message>
        <source>the intermission</source>
        <translation>der Intermission</translation>
    </message>
    <message>
        <source>the layout has more than 500 traces</source>
        <translation>das Layout hat mehr als 500 Kurven</translation>
    </message>
    <message>
        <source>the length</source>
        <translation>der Länge</translation>
    </message>
    <message>
        <source>the length of the frame is %1</source>
        <translation>die Länge des Frames ist %1</translation>
    </message>
    <message>
        <source>the link was opened anew</source>
        <translation>der Link wurde neu geöffnet</translation>
    </message>
    <message>
        <source>the loop drives the motor the wrong way</source>
        <translation>der Regler treibt den Motor in die falsche Richtung</translation>
    </message>
    <message>
        <source>the loop swings itself up: %1 swings, each larger than the last or with full duty</source>
        <translation>der Regler schwingt sich auf: %1 Schwingungen, jede größer als die vorige oder mit vollem Tastgrad</translation>
    </message>
    <message>
        <source>the loop does not come to rest: %1 swings</source>
        <translation>der Regler kommt nicht zur Ruhe: %1 Schwingungen</translation>
    </message>
    <message>
        <source>the loop would be undefined</source>
        <translation>der Regler wäre undefiniert</translation>
    </message>
    <message>
        <source>the microcontroller of the drive is f1 (STM32F1) or f4 (STM32F4)</source>
        <translation>der Mikrocontroller des Antriebs ist f1 (STM32F1) oder f4 (STM32F4)</translation>
    </message>
    <message>
        <source>the model is not to be believed: %1</source>
        <translation>dem Modell ist nicht zu trauen: %1</translation>
    </message>
    <message>
        <source>the motor did not follow a step: stalled, or the encoder is dead</source>
        <translation>der Motor folgte einem Sprung nicht: blockiert, oder der Encoder ist tot</translation>
    </message>
    <message>
        <source>the motor did not move at up to %1 % duty (%2 counts): stalled, or the encoder is dead</source>
        <translation>der Motor bewegte sich bei bis zu %1 % Tastgrad nicht (%2 counts): blockiert, oder der Encoder ist tot</translation>
    </message>
    <message>
        <source>the motor did not turn at two of the powers</source>
        <translation>der Motor drehte sich bei zwei der Leistungen nicht</translation>
    </message>
    <message>
        <source>the motor did not turn at up to %1 duty: stalled, or the encoder is dead</source>
        <translation>der Motor drehte sich bei bis zu %1 Tastgrad nicht: blockiert, oder der Encoder ist tot</translation>
    </message>
    <message>
        <source>the motor did not turn the way it was pushed</source>
        <translation>der Motor drehte sich nicht in die Richtung, in die er gestoßen wurde</translation>
    </message>
    <message>
        <source>the motor ran faster than the power limit allows</source>
        <translation>der Motor lief schneller, als die Leistungsgrenze zulässt</translation>
    </message>
    <message>
        <source>the motor reversed during a sine of %1 Hz: friction is in it</source>
        <translation>der Motor kehrte während eines Sinus von %1 Hz um: Reibung ist darin</translation>
    </message>
    <message>
        <source>the motor took the heat of %1 s at %2 A, 10 s are allowed; let it cool</source>
        <translation>der Motor nahm die Wärme von %1 s bei %2 A auf, erlaubt sind 10 s; abkühlen lassen</translation>
    </message>
    <message>
        <source>the motor turns differently in both directions</source>
        <translation>der Motor dreht in beiden Richtungen unterschiedlich</translation>
    </message>
    <message>
        <source>the motor was not seen to stand</source>
        <translation>der Motor war nicht im Stillstand zu sehen</translation>
    </message>
    <message>
        <source>the motor was stopped</source>
        <translation>der Motor wurde gestoppt</translation>
    </message>
    <message>
        <source>the name was written, but the device answers &apos;%1&apos;</source>
        <translation>der Name wurde geschrieben, aber das Gerät antwortet &apos;%1&apos;</translation>
    </message>
    <message>
        <source>the nearest it can is %1</source>
        <translation>am nächsten kommt %1</translation>
    </message>
    <message>
        <source>the other end of %1 hung up</source>
        <translation>die Gegenseite von %1 hat aufgelegt</translation>
    </message>
    <message>
        <source>the output of its loop passed 32767, where it turns to full reverse</source>
        <translation>der Ausgang des Reglers überschritt 32767, wo er auf voll rückwärts umschlägt</translation>
    </message>
    <message>
        <source>the packet is too long for the board</source>
        <translation>das Paket ist zu lang für die Platine</translation>
    </message>
    <message>
        <source>the plugin %1 finds no adapter</source>
        <translation>das Plugin %1 findet keinen Adapter</translation>
    </message>
    <message>
        <source>the plugin %1 finds no adapter (%2)</source>
        <translation>das Plugin %1 findet keinen Adapter (%2)</translation>
    </message>
    <message>
        <source>the position is not known yet, so nothing would keep the motor from jumping</source>
        <translation>die Position ist noch unbekannt, nichts hielte den Motor also vom Springen ab</translation>
    </message>
    <message>
        <source>the position is written only while the output is off</source>
        <translation>die Position wird nur bei abgeschaltetem Ausgang geschrieben</translation>
    </message>
    <message>
        <source>the positions have an unexpected length</source>
        <translation>die Positionen haben eine unerwartete Länge</translation>
    </message>
    <message>
        <source>the pushes differ by %1 in their resistance, at most 15 %</source>
        <translation>die Stöße unterscheiden sich im Widerstand um %1, höchstens 15 %</translation>
    </message>
    <message>
        <source>the ready line stayed low</source>
        <translation>die Ready-Leitung blieb auf low</translation>
    </message>
    <message>
        <source>the record is cut off after %1 bytes</source>
        <translation>der Datensatz ist nach %1 Bytes abgeschnitten</translation>
    </message>
    <message>
        <source>the remote bit</source>
        <translation>dem Remote-Bit</translation>
    </message>
    <message>
        <source>the reply has an unexpected length</source>
        <translation>die Antwort hat eine unerwartete Länge</translation>
    </message>
    <message>
        <source>the report cannot be painted</source>
        <translation>der Bericht lässt sich nicht zeichnen</translation>
    </message>
    <message>
        <source>the reset line was pulsed</source>
        <translation>die Reset-Leitung wurde gepulst</translation>
    </message>
    <message>
        <source>the resistance is known within %1, at most 10 %</source>
        <translation>der Widerstand ist auf %1 bekannt, höchstens 10 %</translation>
    </message>
    <message>
        <source>the response could not be measured</source>
        <translation>die Antwort ließ sich nicht messen</translation>
    </message>
    <message>
        <source>the same interface as socketcan:%1, which also counts losses</source>
        <translation>dieselbe Schnittstelle wie socketcan:%1, die auch Verluste zählt</translation>
    </message>
    <message>
        <source>the scale of its gains is not known yet, and is found first: one to two minutes, with %1 % of its power at most</source>
        <translation>die Skalierung seiner Verstärkungen ist noch unbekannt und wird zuerst bestimmt: ein bis zwei Minuten, mit höchstens %1 % seiner Leistung</translation>
    </message>
    <message>
        <source>the sensor counts down when the motor is driven up (%1 counts): one of them is reversed</source>
        <translation>der Geber zählt abwärts, wenn der Motor aufwärts getrieben wird (%1 counts): eines von beiden ist verpolt</translation>
    </message>
    <message>
        <source>the sensor is reversed: it counts down</source>
        <translation>der Geber ist verpolt: er zählt abwärts</translation>
    </message>
    <message>
        <source>the sensor is reversed: it counts up</source>
        <translation>der Geber ist verpolt: er zählt aufwärts</translation>
    </message>
    <message>
        <source>the settings of the %1 loop were saved %2 times</source>
        <translation>die Einstellungen des Reglers %1 wurden %2-mal gespeichert</translation>
    </message>
    <message>
        <source>the shaft must be free, without load on one side</source>
        <translation>die Welle muss frei sein, ohne einseitige Last</translation>
    </message>
    <message>
        <source>the simulated board is in use by another link</source>
        <translation>die simulierte Platine wird von einem anderen Link benutzt</translation>
    </message>
    <message>
        <source>the simulator at %1 closed the connection</source>
        <translation>der Simulator bei %1 hat die Verbindung geschlossen</translation>
    </message>
    <message>
        <source>the simulator at %1 sent bytes that nobody asked for</source>
        <translation>der Simulator bei %1 sandte Bytes, nach denen niemand fragte</translation>
    </message>
    <message>
        <source>the speed does not grow evenly with the power</source>
        <translation>die Drehzahl wächst nicht gleichmäßig mit der Leistung</translation>
    </message>
    <message>
        <source>the start of frame</source>
        <translation>dem Frame-Anfang</translation>
    </message>
    <message>
        <source>the status bit is the same with both polarities, so it tells nothing</source>
        <translation>das Statusbit ist bei beiden Polaritäten gleich und sagt daher nichts aus</translation>
    </message>
    <message>
        <source>the steps met the end of the output</source>
        <translation>die Sprünge trafen das Ende des Ausgangs</translation>
    </message>
    <message>
        <source>the stream settings have an unexpected length</source>
        <translation>die Stream-Einstellungen haben eine unerwartete Länge</translation>
    </message>
    <message>
        <source>the substitute remote bit</source>
        <translation>dem Substitute-Remote-Bit</translation>
    </message>
    <message>
        <source>the target</source>
        <translation>das Ziel</translation>
    </message>
    <message>
        <source>the text is longer than %1 MiB</source>
        <translation>der Text ist länger als %1 MiB</translation>
    </message>
    <message>
        <source>the time stamp %1 is out of range</source>
        <translation>der Zeitstempel %1 liegt außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>the time stamps are %1, not absolute or relative</source>
        <translation>die Zeitstempel sind %1, nicht absolute oder relative</translation>
    </message>
    <message>
        <source>the transceiver reports an error</source>
        <translation>der Transceiver meldet einen Fehler</translation>
    </message>
    <message>
        <source>the tuning is not in the notebook: %1</source>
        <translation>die Abstimmung ist nicht im Versuchsbuch: %1</translation>
    </message>
    <message>
        <source>the two directions differ by %1, at most 10 %</source>
        <translation>die beiden Richtungen unterscheiden sich um %1, höchstens 10 %</translation>
    </message>
    <message>
        <source>the unit said it is in its bootloader, but its application answers</source>
        <translation>das Gerät sagte, es sei im Bootloader, aber seine Anwendung antwortet</translation>
    </message>
    <message>
        <source>the unit stays %1 away from where the experiment begins, more than 2 % of its step</source>
        <translation>das Gerät bleibt %1 vom Beginn des Versuchs entfernt, mehr als 2 % seines Sprungs</translation>
    </message>
    <message>
        <source>the unit stores no P, so nothing moves it</source>
        <translation>das Gerät speichert kein P, nichts bewegt es also</translation>
    </message>
    <message>
        <source>the unit stores them by itself within %1 s</source>
        <translation>das Gerät speichert sie von selbst innerhalb von %1 s</translation>
    </message>
    <message>
        <source>the unit tells no duty, no current or no position, so its resistance is not known</source>
        <translation>das Gerät nennt Tastgrad, Strom oder Position nicht, sein Widerstand ist also unbekannt</translation>
    </message>
    <message>
        <source>the unit waits in its bootloader, run the update again</source>
        <translation>das Gerät wartet im Bootloader, Update wiederholen</translation>
    </message>
    <message>
        <source>the user stopped it</source>
        <translation>der Benutzer hat ihn gestoppt</translation>
    </message>
    <message>
        <source>the values stay with this program and are written again after a reset</source>
        <translation>die Werte bleiben in diesem Programm und werden nach einem Rücksetzen neu geschrieben</translation>
    </message>
    <message>
        <source>the version at 0x1EFFC is 0x0000</source>
        <translation>die Version bei 0x1EFFC ist 0x0000</translation>
    </message>
    <message>
        <source>the version at 0x1EFFC is 0xFFFF, which means no application</source>
        <translation>die Version bei 0x1EFFC ist 0xFFFF, das heißt keine Anwendung</translation>
    </message>
    <message>
        <source>the version has an unexpected length</source>
        <translation>die Version hat eine unerwartete Länge</translation>
    </message>
    <message>
        <source>the window of the layout is out of range</source>
        <translation>das Fenster des Layouts liegt außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>the wire lost too many frames; the same again</source>
        <translation>die Leitung verlor zu viele Frames; dasselbe noch einmal</translation>
    </message>
    <message>
        <source>there is no %1</source>
        <translation>%1 ist nicht vorhanden</translation>
    </message>
    <message>
        <source>there is no CAN plugin %1</source>
        <translation>kein CAN-Plugin %1 vorhanden</translation>
    </message>
    <message>
        <source>there is no GPIO chip for %1</source>
        <translation>es gibt keinen GPIO-Baustein für %1</translation>
    </message>
    <message>
        <source>there is no file &apos;%1&apos;</source>
        <translation>es gibt keine Datei &apos;%1&apos;</translation>
    </message>
    <message>
        <source>there is no layout of this name</source>
        <translation>es gibt kein Layout dieses Namens</translation>
    </message>
    <message>
        <source>there is no simulated link &apos;sim:%1&apos;: can, serial and spi are known</source>
        <translation>es gibt keinen simulierten Link &apos;sim:%1&apos;: bekannt sind can, serial und spi</translation>
    </message>
    <message>
        <source>there is no snapshot &apos;%1&apos;</source>
        <translation>es gibt keinen Schnappschuss &apos;%1&apos;</translation>
    </message>
    <message>
        <source>there is no snapshot &apos;%1&apos; of this unit</source>
        <translation>es gibt keinen Schnappschuss &apos;%1&apos; dieses Geräts</translation>
    </message>
    <message>
        <source>there is no socket %1</source>
        <translation>es gibt keinen Socket %1</translation>
    </message>
    <message>
        <source>there is no such folder</source>
        <translation>diesen Ordner gibt es nicht</translation>
    </message>
    <message>
        <source>there is no table here: expected time_s,name (unit),… or t,channel,value,unit</source>
        <translation>hier ist keine Tabelle: erwartet wird time_s,name (unit),… oder t,channel,value,unit</translation>
    </message>
    <message>
        <source>there is no trial %1</source>
        <translation>es gibt keinen Versuch %1</translation>
    </message>
    <message>
        <source>there is no way from %1 to itself</source>
        <translation>von %1 zu sich selbst führt kein Weg</translation>
    </message>
    <message>
        <source>there is not enough room for a frequency response: its limits leave a speed of %1 counts/s for %2 s</source>
        <translation>für einen Frequenzgang ist nicht genug Platz: seine Grenzen lassen %1 counts/s für %2 s</translation>
    </message>
    <message>
        <source>there is not enough room to identify the motor: its limits leave pushes of %1 duty only</source>
        <translation>zum Identifizieren des Motors ist nicht genug Platz: seine Grenzen lassen nur Stöße mit %1 Tastgrad</translation>
    </message>
    <message>
        <source>there is not enough room: its limits leave steps of %1 counts</source>
        <translation>es ist nicht genug Platz: seine Grenzen lassen Sprünge von %1 counts</translation>
    </message>
    <message>
        <source>they have speed and interface</source>
        <translation>bekannt sind speed und interface</translation>
    </message>
    <message>
        <source>this build simulates no devices on sim:%1</source>
        <translation>diese Fassung simuliert keine Geräte an sim:%1</translation>
    </message>
    <message>
        <source>this command is not known to firmware of dialect %1</source>
        <translation>diesen Befehl kennt Firmware des Dialekts %1 nicht</translation>
    </message>
    <message>
        <source>this device has no experiment &apos;%1&apos;</source>
        <translation>dieses Gerät hat keinen Versuch &apos;%1&apos;</translation>
    </message>
    <message>
        <source>this device has no watchdog, and on %1 nothing could stop it if the program died</source>
        <translation>dieses Gerät hat keinen Watchdog, und an %1 könnte nichts es stoppen, wenn das Programm abstürzt</translation>
    </message>
    <message>
        <source>this image holds a bootloader too, which cannot write itself</source>
        <translation>dieses Image enthält auch einen Bootloader, der sich nicht selbst schreiben kann</translation>
    </message>
    <message>
        <source>this is no layout of plots</source>
        <translation>dies ist kein Layout von Plots</translation>
    </message>
    <message>
        <source>this is no program for the controller: it does not begin with a jump of an AVR at address 0</source>
        <translation>dies ist kein Programm für den Controller: es beginnt nicht mit einem AVR-Sprung an Adresse 0</translation>
    </message>
    <message>
        <source>this is no program for the controller: it has bytes outside the 32 KiB of an ATmega328P</source>
        <translation>dies ist kein Programm für den Controller: es hat Bytes außerhalb der 32 KiB eines ATmega328P</translation>
    </message>
    <message>
        <source>this takes too long</source>
        <translation>dies dauert zu lange</translation>
    </message>
    <message>
        <source>this trial has no sine and no positions</source>
        <translation>dieser Versuch hat keinen Sinus und keine Positionen</translation>
    </message>
    <message>
        <source>this trial is kept without its result: %1</source>
        <translation>dieser Versuch wird ohne sein Ergebnis aufbewahrt: %1</translation>
    </message>
    <message>
        <source>this trial is not kept: %1</source>
        <translation>dieser Versuch wird nicht aufbewahrt: %1</translation>
    </message>
    <message>
        <source>this trial owes nothing to the unit</source>
        <translation>dieser Versuch schuldet dem Gerät nichts</translation>
    </message>
    <message>
        <source>this unit has no number yet</source>
        <translation>dieses Gerät hat noch keine Nummer</translation>
    </message>
    <message>
        <source>to be trusted up to %1 Hz, as far as ten samples a swing and a coherence of 0.9</source>
        <translation>vertrauenswürdig bis %1 Hz, soweit zehn Messwerte je Schwingung und eine Kohärenz von 0,9 reichen</translation>
    </message>
    <message>
        <source>too few samples for a sine of %1 Hz</source>
        <translation>zu wenige Messwerte für einen Sinus von %1 Hz</translation>
    </message>
    <message>
        <source>too few steps to tell what the gains of this loop do</source>
        <translation>zu wenige Sprünge, um zu sagen, was die Verstärkungen dieses Reglers bewirken</translation>
    </message>
    <message>
        <source>transmission timed out</source>
        <translation>das Senden dauerte zu lange</translation>
    </message>
    <message>
        <source>trial #%1</source>
        <translation>Versuch #%1</translation>
    </message>
    <message>
        <source>try a lower speed=</source>
        <translation>ein kleineres speed= versuchen</translation>
    </message>
    <message>
        <source>try again</source>
        <translation>erneut versuchen</translation>
    </message>
    <message>
        <source>try its position loop</source>
        <translation>seinen Positionsregler versuchen</translation>
    </message>
    <message>
        <source>tune it by hand with &apos;motorbenchctl step&apos;</source>
        <translation>ihn von Hand mit &apos;motorbenchctl step&apos; abstimmen</translation>
    </message>
    <message>
        <source>tuning %1: %2</source>
        <translation>Abstimmung %1: %2</translation>
    </message>
    <message>
        <source>undone: %1</source>
        <translation>zurückgenommen: %1</translation>
    </message>
    <message>
        <source>unix links have no option &apos;%1&apos;</source>
        <translation>unix-Links haben keine Option &apos;%1&apos;</translation>
    </message>
    <message>
        <source>unknown error</source>
        <translation>unbekannter Fehler</translation>
    </message>
    <message>
        <source>unknown fault &apos;%1&apos;</source>
        <translation>unbekannter Fehler &apos;%1&apos;</translation>
    </message>
    <message>
        <source>unknown option &apos;%1&apos; of a serial link</source>
        <translation>unbekannte Option „%1“ einer seriellen Verbindung</translation>
    </message>
    <message>
        <source>unknown option &apos;%1&apos; of a simulated link</source>
        <translation>unbekannte Option &apos;%1&apos; eines simulierten Links</translation>
    </message>
    <message>
        <source>unplug it and plug it in again</source>
        <translation>abziehen und wieder einstecken</translation>
    </message>
    <message>
        <source>update its firmware first</source>
        <translation>zuerst die Firmware aktualisieren</translation>
    </message>
    <message>
        <source>use a programmer on the pins</source>
        <translation>ein Programmiergerät an den Stiften nehmen</translation>
    </message>
    <message>
        <source>use an interface of the kernel</source>
        <translation>eine Schnittstelle des Kernels verwenden</translation>
    </message>
    <message>
        <source>use that one</source>
        <translation>jene benutzen</translation>
    </message>
    <message>
        <source>velocity is −100000 to 100000 counts/s</source>
        <translation>die Drehzahl ist −100000 bis 100000 counts/s</translation>
    </message>
    <message>
        <source>wait until it is heard</source>
        <translation>warten, bis es zu hören ist</translation>
    </message>
    <message>
        <source>what D does is known within %1, at most 30 %</source>
        <translation>was D bewirkt, ist auf %1 bekannt, höchstens 30 %</translation>
    </message>
    <message>
        <source>what a gain of %1 means in this loop is not known</source>
        <translation>was eine Verstärkung von %1 in diesem Regler bedeutet, ist nicht bekannt</translation>
    </message>
    <message>
        <source>what a raw gain of this board puts out is not known (%1)</source>
        <translation>was eine rohe Verstärkung dieser Platine ausgibt, ist nicht bekannt (%1)</translation>
    </message>
    <message>
        <source>what another program has changed within the last 15 s is not in the flash of the unit yet, and is lost with the restart</source>
        <translation>was ein anderes Programm in den letzten 15 s geändert hat, ist noch nicht im Flash des Geräts und geht mit dem Neustart verloren</translation>
    </message>
    <message>
        <source>what is left over is %1 of the steps, at most 8 %</source>
        <translation>übrig bleiben %1 der Sprünge, höchstens 8 %</translation>
    </message>
    <message>
        <source>what is missing is still unknown, do it again</source>
        <translation>was fehlt, ist weiterhin unbekannt, wiederholen</translation>
    </message>
    <message>
        <source>what the gains of this loop make is not known any more</source>
        <translation>was die Verstärkungen dieses Reglers bewirken, ist nicht mehr bekannt</translation>
    </message>
    <message>
        <source>where it is neither, its gain.p is too small for so short a way</source>
        <translation>wo es keines von beiden ist, ist sein gain.p zu klein für einen so kurzen Weg</translation>
    </message>
    <message>
        <source>without a ready line the board is asked 100 times a second, and cannot stream</source>
        <translation>ohne Ready-Leitung wird die Platine 100-mal pro Sekunde gefragt und kann nicht streamen</translation>
    </message>
    <message>
        <source>write %1</source>
        <translation>%1 schreiben</translation>
    </message>
    <message>
        <source>write == to compare</source>
        <translation>zum Vergleichen == schreiben</translation>
    </message>
    <message>
        <source>write a larger gain.d once, with which it still comes to rest</source>
        <translation>einmal ein größeres gain.d schreiben, mit dem er noch zur Ruhe kommt</translation>
    </message>
    <message>
        <source>write a number</source>
        <translation>eine Zahl schreiben</translation>
    </message>
    <message>
        <source>write a small gain.p once, with which it moves</source>
        <translation>einmal ein kleines gain.p schreiben, mit dem er sich bewegt</translation>
    </message>
    <message>
        <source>write a smaller gain.p once</source>
        <translation>einmal ein kleineres gain.p schreiben</translation>
    </message>
    <message>
        <source>write it like 2.5</source>
        <translation>es wie 2.5 schreiben</translation>
    </message>
    <message>
        <source>write it with &apos;motorbenchctl set&apos;</source>
        <translation>es mit &apos;motorbenchctl set&apos; schreiben</translation>
    </message>
    <message>
        <source>write it with a dot, like 1.5, and no comma</source>
        <translation>es mit Punkt schreiben, wie 1.5, und ohne Komma</translation>
    </message>
    <message>
        <source>write on or off</source>
        <translation>on oder off schreiben</translation>
    </message>
    <message>
        <source>write openocd:INTERFACE, such as openocd:stlink</source>
        <translation>openocd:SCHNITTSTELLE schreiben, etwa openocd:stlink</translation>
    </message>
    <message>
        <source>write the gains of this loop once, or keep what is tried</source>
        <translation>die Verstärkungen dieses Reglers einmal schreiben, oder behalten, was versucht wird</translation>
    </message>
    <message>
        <source>write true or false</source>
        <translation>true oder false schreiben</translation>
    </message>
    <message>
        <source>written again: %1</source>
        <translation>neu geschrieben: %1</translation>
    </message>
    <message>
        <source>written, but the current limit, which this firmware overwrites with it, could not be put back to %1 mA: %2</source>
        <translation>geschrieben, aber die Strombegrenzung, die diese Firmware damit überschreibt, ließ sich nicht auf %1 mA zurücksetzen: %2</translation>
    </message>
    <message>
        <source>the order was dropped: what it was for has ended</source>
        <translation>der Auftrag entfiel: wofür er war, ist zu Ende</translation>
    </message>
    <message>
        <source>%1 is missing</source>
        <translation>%1 fehlt</translation>
    </message>
    <message>
        <source>no guardian can be started: %1</source>
        <translation>kein Wächter lässt sich starten: %1</translation>
    </message>
    <message>
        <source>the guardian does not answer</source>
        <translation>der Wächter antwortet nicht</translation>
    </message>
    <message>
        <source>the guardian ended unexpectedly</source>
        <translation>der Wächter endete unerwartet</translation>
    </message>
    <message>
        <source>the guardian is of another version</source>
        <translation>der Wächter ist von einer anderen Version</translation>
    </message>
    <message>
        <source>the stop script of this device is not one that a guardian can carry out</source>
        <translation>das Stopp-Skript dieses Geräts kann ein Wächter nicht ausführen</translation>
    </message>
    <message>
        <source>without it nothing would stop this motor if the program died: install it there</source>
        <translation>ohne ihn hielte nichts diesen Motor an, wenn das Programm stürbe: dort installieren</translation>
    </message>
    <message>
        <source>%1 belongs to the unit that the file was saved from</source>
        <translation>%1 gehört zu dem Gerät, von dem die Datei stammt</translation>
    </message>
    <message>
        <source>%1 could not be measured</source>
        <translation>%1 ließ sich nicht messen</translation>
    </message>
    <message>
        <source>%1 has no duty command, so &apos;%2&apos; is not measured</source>
        <translation>%1 hat kein Kommando für den Tastgrad, &apos;%2&apos; wird also nicht gemessen</translation>
    </message>
    <message>
        <source>%1 has no firmware update here</source>
        <translation>%1 lässt sich hier nicht mit Firmware aktualisieren</translation>
    </message>
    <message>
        <source>%1 has no number that could be set</source>
        <translation>%1 hat keine Nummer, die sich setzen ließe</translation>
    </message>
    <message>
        <source>%1 has no setting that could be written to every unit</source>
        <translation>%1 hat keine Einstellung, die sich in jedes Gerät schreiben ließe</translation>
    </message>
    <message>
        <source>%1 is %2, %3</source>
        <translation>%1 ist %2, %3</translation>
    </message>
    <message>
        <source>%1 is not updated over its own link</source>
        <translation>%1 wird nicht über seinen eigenen Link aktualisiert</translation>
    </message>
    <message>
        <source>%1 is updated over its own link</source>
        <translation>%1 wird über seinen eigenen Link aktualisiert</translation>
    </message>
    <message>
        <source>%1 of the recipe read back different, first %2</source>
        <translation>%1 des Rezepts lesen sich anders zurück, als erstes %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be a number</source>
        <translation>&apos;%1&apos; muss eine Zahl sein</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be a text</source>
        <translation>&apos;%1&apos; muss ein Text sein</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be a whole number</source>
        <translation>&apos;%1&apos; muss eine ganze Zahl sein</translation>
    </message>
    <message>
        <source>a name has no line break, tabulator or other control character</source>
        <translation>ein Name hat keinen Zeilenumbruch, Tabulator und kein anderes Steuerzeichen</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be an object in braces</source>
        <translation>&apos;%1&apos; muss ein Objekt in geschweiften Klammern sein</translation>
    </message>
    <message>
        <source>&apos;encoder&apos; is true: it counts both ways</source>
        <translation>&apos;encoder&apos; ist true: er zählt in beide Richtungen</translation>
    </message>
    <message>
        <source>&apos;store&apos; must be true or false</source>
        <translation>&apos;store&apos; muss true oder false sein</translation>
    </message>
    <message>
        <source>&apos;to&apos; is missing</source>
        <translation>&apos;to&apos; fehlt</translation>
    </message>
    <message>
        <source>Giving it number %1</source>
        <translation>Vergabe der Nummer %1</translation>
    </message>
    <message>
        <source>&quot;via&quot; must name the other way in, such as &quot;%1&quot;</source>
        <translation>&quot;via&quot; muss den anderen Weg nennen, etwa &quot;%1&quot;</translation>
    </message>
    <message>
        <source>a recipe is a JSON object</source>
        <translation>ein Rezept ist ein JSON-Objekt</translation>
    </message>
    <message>
        <source>another program or controller drives this unit</source>
        <translation>ein anderes Programm oder Steuergerät steuert dieses Gerät an</translation>
    </message>
    <message>
        <source>arm it first</source>
        <translation>es zuerst scharf schalten</translation>
    </message>
    <message>
        <source>begin another recipe, or another bus</source>
        <translation>ein anderes Rezept oder einen anderen Bus beginnen</translation>
    </message>
    <message>
        <source>bring it to rest first</source>
        <translation>ihn zuerst zum Stillstand bringen</translation>
    </message>
    <message>
        <source>cut the power if the motor still turns</source>
        <translation>den Strom abschalten, wenn der Motor noch dreht</translation>
    </message>
    <message>
        <source>free the shaft and see that no brake is on, then test again</source>
        <translation>die Welle freimachen, prüfen, dass keine Bremse anliegt, dann erneut prüfen</translation>
    </message>
    <message>
        <source>give it a number first, or take the self-test out of the recipe</source>
        <translation>ihm zuerst eine Nummer geben, oder den Selbsttest aus dem Rezept nehmen</translation>
    </message>
    <message>
        <source>it begins with &quot;recipe&quot;: 1</source>
        <translation>es beginnt mit &quot;recipe&quot;: 1</translation>
    </message>
    <message>
        <source>it begins with {</source>
        <translation>es beginnt mit {</translation>
    </message>
    <message>
        <source>its motor is turning or driven already</source>
        <translation>sein Motor dreht sich oder wird schon angesteuert</translation>
    </message>
    <message>
        <source>known are %1</source>
        <translation>bekannt sind %1</translation>
    </message>
    <message>
        <source>limit %1</source>
        <translation>Grenze %1</translation>
    </message>
    <message>
        <source>limits %1 … %2</source>
        <translation>Grenzen %1 … %2</translation>
    </message>
    <message>
        <source>look at brushes, plugs and leads, then test again</source>
        <translation>Bürsten, Stecker und Leitungen prüfen, dann erneut prüfen</translation>
    </message>
    <message>
        <source>look at the cable and test again</source>
        <translation>das Kabel prüfen und erneut prüfen</translation>
    </message>
    <message>
        <source>look at the plug and the polarity of encoder and motor, then test again</source>
        <translation>Stecker und Polung von Encoder und Motor prüfen, dann erneut prüfen</translation>
    </message>
    <message>
        <source>look for units again</source>
        <translation>erneut nach Geräten suchen</translation>
    </message>
    <message>
        <source>name a firmware in the recipe</source>
        <translation>im Rezept eine Firmware nennen</translation>
    </message>
    <message>
        <source>no number: server silent</source>
        <translation>keine Nummer: der Server schweigt</translation>
    </message>
    <message>
        <source>nobody watches over this self-test, and it moves the motor</source>
        <translation>niemand überwacht diesen Selbsttest, und er bewegt den Motor</translation>
    </message>
    <message>
        <source>remove the cause, then test again</source>
        <translation>die Ursache beseitigen, dann erneut prüfen</translation>
    </message>
    <message>
        <source>see that motor and load are those of the recipe, then test again</source>
        <translation>prüfen, ob Motor und Last die des Rezepts sind, dann erneut prüfen</translation>
    </message>
    <message>
        <source>see that this is the motor and the encoder of the recipe, then test again</source>
        <translation>prüfen, ob dies Motor und Encoder des Rezepts sind, dann erneut prüfen</translation>
    </message>
    <message>
        <source>take the other one off, or give one of them another number</source>
        <translation>das andere abnehmen, oder einem der beiden eine andere Nummer geben</translation>
    </message>
    <message>
        <source>test again when it is safe</source>
        <translation>erneut prüfen, wenn es sicher ist</translation>
    </message>
    <message>
        <source>the encoder does not count both ways</source>
        <translation>der Encoder zählt nicht in beide Richtungen</translation>
    </message>
    <message>
        <source>the key &apos;%1&apos; is there twice</source>
        <translation>der Schlüssel &apos;%1&apos; steht zweimal da</translation>
    </message>
    <message>
        <source>the limit of &apos;%1&apos; must be the greatest value, 0 or more, or [least, greatest]</source>
        <translation>die Grenze von &apos;%1&apos; muss der größte Wert sein, 0 oder mehr, oder [kleinster, größter]</translation>
    </message>
    <message>
        <source>the self-test could not go on: %1</source>
        <translation>der Selbsttest konnte nicht weitergehen: %1</translation>
    </message>
    <message>
        <source>the self-test was ended by the guard &apos;%1&apos;: %2</source>
        <translation>der Selbsttest wurde von der Überwachung &apos;%1&apos; beendet: %2</translation>
    </message>
    <message>
        <source>the self-test was stopped by hand</source>
        <translation>der Selbsttest wurde von Hand gestoppt</translation>
    </message>
    <message>
        <source>the set-point of the step</source>
        <translation>der Sollwert des Sprungs</translation>
    </message>
    <message>
        <source>the stop of the self-test was not confirmed: %1</source>
        <translation>der Stopp des Selbsttests wurde nicht bestätigt: %1</translation>
    </message>
    <message>
        <source>the unit answers with firmware %1, the image is %2</source>
        <translation>das Gerät antwortet mit Firmware %1, das Image ist %2</translation>
    </message>
    <message>
        <source>the unit was not heard during the self-test: %1</source>
        <translation>das Gerät war während des Selbsttests nicht zu hören: %1</translation>
    </message>
    <message>
        <source>there is no entry %1 in the journal</source>
        <translation>es gibt keinen Eintrag %1 im Journal</translation>
    </message>
    <message>
        <source>this build knows %1</source>
        <translation>diese Fassung kennt %1</translation>
    </message>
    <message>
        <source>this is another unit by now, number %1</source>
        <translation>dies ist inzwischen ein anderes Gerät, Nummer %1</translation>
    </message>
    <message>
        <source>this is no recipe of version 1</source>
        <translation>dies ist kein Rezept der Version 1</translation>
    </message>
    <message>
        <source>this unit has no number yet, and without one its motor may not be driven</source>
        <translation>dieses Gerät hat noch keine Nummer, und ohne eine darf sein Motor nicht angesteuert werden</translation>
    </message>
    <message>
        <source>this unit waits in its bootloader, and the recipe has no firmware for it</source>
        <translation>dieses Gerät wartet in seinem Bootloader, und das Rezept hat keine Firmware dafür</translation>
    </message>
    <message>
        <source>unknown family &apos;%1&apos;</source>
        <translation>unbekannte Familie &apos;%1&apos;</translation>
    </message>
    <message>
        <source>unknown key &apos;%1&apos;</source>
        <translation>unbekannter Schlüssel &apos;%1&apos;</translation>
    </message>
    <message>
        <source>unknown loop &apos;%1&apos;</source>
        <translation>unbekannter Regler &apos;%1&apos;</translation>
    </message>
    <message>
        <source>%1 cannot be painted</source>
        <translation>%1 lässt sich nicht zeichnen</translation>
    </message>
    <message>
        <source>choose a smaller --size</source>
        <translation>ein kleineres --size wählen</translation>
    </message>
    <message>
        <source>now the calm ones</source>
        <translation>nun die ruhigen</translation>
    </message>
    <message>
        <source>the %1 gains did not: %2</source>
        <translation>die Verstärkungen „%1“ taten es nicht: %2</translation>
    </message>
    <message>
        <source>these are the calm gains, %1</source>
        <translation>dies sind die ruhigen Verstärkungen, %1</translation>
    </message>
    <message>
        <source>Nothing is written yet; the update can be run again</source>
        <translation>Noch ist nichts geschrieben; das Update kann noch einmal gestartet werden</translation>
    </message>
    <message>
        <source>The flash is being written: it must not be cut</source>
        <translation>Der Flash wird geschrieben: nicht unterbrechen</translation>
    </message>
    <message>
        <source>A unit that is cut while it is written holds half a program. It runs again once an update has succeeded.</source>
        <translation>Ein Gerät, das beim Schreiben unterbrochen wird, enthält ein halbes Programm. Es läuft wieder, sobald ein Update gelungen ist.</translation>
    </message>
    <message>
        <source>output saturated</source>
        <translation>Ausgang am Anschlag</translation>
    </message>
    <message>
        <source>output wrapped around</source>
        <translation>Ausgang übergelaufen</translation>
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
        <source>The unit then waits in its bootloader; the update can be run again</source>
        <translation>Das Gerät wartet dann im Bootloader; das Update lässt sich wiederholen</translation>
    </message>
    <message>
        <source>Page 0 is being written: it must not be cut</source>
        <translation>Seite 0 wird geschrieben: nicht unterbrechen</translation>
    </message>
    <message>
        <source>A unit that is cut stays in its bootloader and can be updated again. Only page 0, the last, must not be interrupted.</source>
        <translation>Ein unterbrochenes Gerät bleibt im Bootloader und lässt sich erneut aktualisieren. Nur Seite 0, die letzte, darf nicht unterbrochen werden.</translation>
    </message>
    <message>
        <source>Page 0 holds the reset vector. A cut now cannot be repaired over the bus.</source>
        <translation>Seite 0 enthält den Reset-Vektor. Eine Unterbrechung jetzt lässt sich über den Bus nicht beheben.</translation>
    </message>
    <message>
        <source>adapter, 3.3 V</source>
        <translation>Adapter, 3,3 V</translation>
    </message>
    <message>
        <source>Drawing: the jumper connects AUX1 and AUX2; adapter TX to board RX, RX to TX, 3.3 V, GND</source>
        <translation>Zeichnung: die Steckbrücke verbindet AUX1 und AUX2; TX des Adapters an RX der Platine, RX an TX, 3,3 V, GND</translation>
    </message>
    <message>
        <source>Drawing: the jumper between AUX1 and AUX2 is taken out</source>
        <translation>Zeichnung: die Steckbrücke zwischen AUX1 und AUX2 ist abgezogen</translation>
    </message>
    <message>
        <source>encoder glitch</source>
        <translation>Encoderstörung</translation>
    </message>
    <message>
        <source>overspeed</source>
        <translation>Überdrehzahl</translation>
    </message>
    <message>
        <source>A board that is cut stays in its bootloader. Leave the jumper in and run the update again.</source>
        <translation>Eine unterbrochene Platine bleibt im Bootloader. Steckbrücke stecken lassen und Update wiederholen.</translation>
    </message>
    <message>
        <source>%1 has no option &apos;%2&apos;</source>
        <translation>%1 hat keine Option &apos;%2&apos;</translation>
    </message>
    <message>
        <source>%1 said nothing for a minute and was ended</source>
        <translation>%1 sagte eine Minute lang nichts und wurde beendet</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no value for the option &apos;%2&apos; of %3</source>
        <translation>%3: &apos;%1&apos; ist kein Wert für die Option &apos;%2&apos;</translation>
    </message>
    <message>
        <source>a simulated Abstract DC Drive</source>
        <translation>ein simulierter Abstract DC Drive</translation>
    </message>
    <message>
        <source>a simulated DMC60C</source>
        <translation>ein simulierter DMC60C</translation>
    </message>
    <message>
        <source>a simulated QuadQuad2Drv</source>
        <translation>ein simulierter QuadQuad2Drv</translation>
    </message>
    <message>
        <source>a simulated Supermodified</source>
        <translation>ein simulierter Supermodified</translation>
    </message>
    <message>
        <source>a temporary file for %1 cannot be written: %2</source>
        <translation>eine temporäre Datei für %1 lässt sich nicht schreiben: %2</translation>
    </message>
    <message>
        <source>%1 does not answer: %2</source>
        <translation>%1 antwortet nicht: %2</translation>
    </message>
    <message>
        <source>%1 is locked by another program</source>
        <translation>%1 ist von einem anderen Programm gesperrt</translation>
    </message>
    <message>
        <source>%1 is no project of this version</source>
        <translation>%1 ist kein Projekt dieser Version</translation>
    </message>
    <message>
        <source>%1 is no recording</source>
        <translation>%1 ist keine Aufnahme</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no journal that stations share</source>
        <translation>&apos;%1&apos; ist kein Journal, das Stationen sich teilen</translation>
    </message>
    <message>
        <source>Put values back</source>
        <translation>Werte zurückstellen</translation>
    </message>
    <message>
        <source>end that first</source>
        <translation>das zuerst beenden</translation>
    </message>
    <message>
        <source>install %1</source>
        <translation>%1 installieren</translation>
    </message>
    <message>
        <source>see that the server runs; entries wait here until it does</source>
        <translation>nachsehen, ob der Server läuft; Einträge warten hier, bis er es tut</translation>
    </message>
    <message>
        <source>stop it, then put the values back</source>
        <translation>ihn anhalten, dann die Werte zurückstellen</translation>
    </message>
    <message>
        <source>stopped while it waited for a number</source>
        <translation>angehalten, während auf eine Nummer gewartet wurde</translation>
    </message>
    <message>
        <source>such as %1</source>
        <translation>etwa %1</translation>
    </message>
    <message>
        <source>the folder %1 cannot be made</source>
        <translation>der Ordner %1 lässt sich nicht anlegen</translation>
    </message>
    <message>
        <source>the folder %1 cannot be written</source>
        <translation>in den Ordner %1 lässt sich nicht schreiben</translation>
    </message>
    <message>
        <source>the journal on the server was made by a newer version of this program</source>
        <translation>das Journal auf dem Server stammt von einer neueren Version dieses Programms</translation>
    </message>
    <message>
        <source>the journal&apos;s server: %1</source>
        <translation>der Server des Journals: %1</translation>
    </message>
    <message>
        <source>the motor is not seen to stand</source>
        <translation>es ist nicht zu sehen, dass der Motor steht</translation>
    </message>
    <message>
        <source>the values are not put back: %1</source>
        <translation>die Werte sind nicht zurückgestellt: %1</translation>
    </message>
    <message>
        <source>the values are put back</source>
        <translation>die Werte sind zurückgestellt</translation>
    </message>
    <message>
        <source>this change waits for nobody</source>
        <translation>diese Änderung wartet auf niemanden</translation>
    </message>
    <message>
        <source>this computer has no driver for PostgreSQL</source>
        <translation>dieser Rechner hat keinen Treiber für PostgreSQL</translation>
    </message>
    <message>
        <source>this is no session of MotorBench</source>
        <translation>das ist keine Sitzung von MotorBench</translation>
    </message>
    <message>
        <source>units are served already</source>
        <translation>es werden schon Geräte bedient</translation>
    </message>
    <message>
        <source>units are served on this link</source>
        <translation>an dieser Verbindung werden Geräte bedient</translation>
    </message>
    <message>
        <source>unreadable</source>
        <translation>nicht lesbar</translation>
    </message>
    <message>
        <source>service</source>
        <translation>Bedienung</translation>
    </message>
    <message>
        <source>--language takes one of %1</source>
        <translation>--language nimmt eines von %1</translation>
    </message>
    <message>
        <source>brisk</source>
        <translation>flott</translation>
    </message>
    <message>
        <source>calm</source>
        <translation>ruhig</translation>
    </message>
    <message>
        <source>kept</source>
        <translation>behalten</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>normal</translation>
    </message>
    <message>
        <source>proposed</source>
        <translation>vorgeschlagen</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>abgelehnt</translation>
    </message>
    <message>
        <source>rolled-back</source>
        <translation>zurückgenommen</translation>
    </message>
    <message>
        <source>P alone, in a loop that looks at the current every %1, holds %2 of what is asked for when it overshoots by %3</source>
        <translation>P allein hält in einem Regler, der den Strom alle %1 ansieht, %2 des verlangten, wenn er um %3 überschwingt</translation>
    </message>
    <message>
        <source>allow more travel, so that pushes may last</source>
        <translation>mehr Weg zulassen, damit Stöße dauern dürfen</translation>
    </message>
    <message>
        <source>drive it by duty, or try its I with &apos;motorbenchctl step&apos;: not every build of the firmware runs it</source>
        <translation>mit Tastgrad fahren, oder sein I mit &apos;motorbenchctl step&apos; versuchen: nicht jede Firmware rechnet es</translation>
    </message>
    <message>
        <source>friction takes %1 duty, and %2 may push: too little for a motor to swing</source>
        <translation>die Reibung nimmt %1 Tastgrad, %2 dürfen treiben: zu wenig, damit ein Motor schwingt</translation>
    </message>
    <message>
        <source>its current stays %1 A behind while the motor speeds up</source>
        <translation>sein Strom bleibt %1 A zurück, solange der Motor schneller wird</translation>
    </message>
    <message>
        <source>no motor of this gain swings by %1 counts every %2</source>
        <translation>kein Motor dieser Verstärkung schwingt alle %2 um %1 Inkremente</translation>
    </message>
    <message>
        <source>now those of the model as that step has corrected it</source>
        <translation>nun die des Modells, wie es dieser Schritt berichtigt hat</translation>
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
        <source>swinging with %1 duty to and fro</source>
        <translation>schwingt mit %1 Tastgrad hin und her</translation>
    </message>
    <message>
        <source>the %1 gains of the first model did not: %2</source>
        <translation>die Verstärkungen „%1“ des ersten Modells taten es nicht: %2</translation>
    </message>
    <message>
        <source>the gain is known within %1, at most 15 %</source>
        <translation>die Verstärkung ist auf %1 bekannt, höchstens 15 %</translation>
    </message>
    <message>
        <source>the motor did not swing evenly under a duty that changes its sign</source>
        <translation>der Motor schwang nicht gleichmäßig unter einem Tastgrad, der sein Vorzeichen wechselt</translation>
    </message>
    <message>
        <source>their model was corrected by a step, %1</source>
        <translation>ihr Modell wurde durch einen Schritt berichtigt, %1</translation>
    </message>
    <message>
        <source>there is no room for pushes that last</source>
        <translation>für Stöße, die dauern, ist kein Platz</translation>
    </message>
    <message>
        <source>there was no room for long pushes; under %1 duty to and fro it swings by %2 counts every %3, the periods differ by %4, at most 10 %</source>
        <translation>für lange Stöße war kein Platz; unter %1 Tastgrad hin und her schwingt er alle %3 um %2 Inkremente, die Perioden unterscheiden sich um %4, höchstens 10 %</translation>
    </message>
    <message>
        <source>this unit is for motors of more current</source>
        <translation>dieses Gerät ist für Motoren mit mehr Strom</translation>
    </message>
    <message>
        <source>%1 %2 is unusual: %3 units have %4 to %5</source>
        <translation>%1 %2 ist ungewöhnlich: %3 Geräte haben %4 bis %5</translation>
    </message>
    <message>
        <source>%1 besides those of the recipe differ from the backup</source>
        <translation>%1 außer denen des Rezepts weichen von der Sicherung ab</translation>
    </message>
    <message>
        <source>%1 of %2 written</source>
        <translation>%1 von %2 geschrieben</translation>
    </message>
    <message>
        <source>%1 pages, %2 sent again</source>
        <translation>%1 Seiten, %2 noch einmal gesendet</translation>
    </message>
    <message>
        <source>%1 settings</source>
        <translation>%1 Einstellungen</translation>
    </message>
    <message>
        <source>1 setting</source>
        <translation>1 Einstellung</translation>
    </message>
    <message>
        <source>all numbers are used up, the highest is %1</source>
        <translation>alle Nummern sind vergeben, die höchste ist %1</translation>
    </message>
    <message>
        <source>already %1</source>
        <translation>schon %1</translation>
    </message>
    <message>
        <source>backup</source>
        <translation>Sicherung</translation>
    </message>
    <message>
        <source>done</source>
        <translation>fertig</translation>
    </message>
    <message>
        <source>firmware</source>
        <translation>Firmware</translation>
    </message>
    <message>
        <source>firmware %1</source>
        <translation>Firmware %1</translation>
    </message>
    <message>
        <source>its flash has it</source>
        <translation>es steht in seinem Flash</translation>
    </message>
    <message>
        <source>no version is told</source>
        <translation>keine Version wird genannt</translation>
    </message>
    <message>
        <source>not kept: there is no notebook</source>
        <translation>nicht aufgehoben: es gibt kein Versuchsbuch</translation>
    </message>
    <message>
        <source>nothing can be read in the bootloader</source>
        <translation>im Bootloader kann nichts gelesen werden</translation>
    </message>
    <message>
        <source>nothing had to be stored</source>
        <translation>nichts musste gespeichert werden</translation>
    </message>
    <message>
        <source>number</source>
        <translation>Nummer</translation>
    </message>
    <message>
        <source>number %1</source>
        <translation>Nummer %1</translation>
    </message>
    <message>
        <source>number %1, as before</source>
        <translation>Nummer %1, wie zuvor</translation>
    </message>
    <message>
        <source>parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>bestanden</translation>
    </message>
    <message>
        <source>preflight</source>
        <translation>Vorprüfung</translation>
    </message>
    <message>
        <source>proof</source>
        <translation>Nachweis</translation>
    </message>
    <message>
        <source>read back</source>
        <translation>zurückgelesen</translation>
    </message>
    <message>
        <source>self-test</source>
        <translation>Selbsttest</translation>
    </message>
    <message>
        <source>snapshot %1 has %2 values</source>
        <translation>Schnappschuss %1 hat %2 Werte</translation>
    </message>
    <message>
        <source>within its limits</source>
        <translation>in seinen Grenzen</translation>
    </message>
    <message>
        <source>%1 is for no unit that is here and takes firmware over its own link</source>
        <translation>%1 ist für kein Gerät, das hier ist und Firmware über seinen eigenen Anschluss nimmt</translation>
    </message>
    <message>
        <source>%1 is not open, or something runs there</source>
        <translation>%1 ist nicht offen, oder dort läuft etwas</translation>
    </message>
    <message>
        <source>for the others write a recipe that names the way in</source>
        <translation>für die anderen ein Rezept schreiben, das den Weg hinein nennt</translation>
    </message>
    <message>
        <source>open it, or end what runs there first</source>
        <translation>öffnen, oder erst beenden, was dort läuft</translation>
    </message>
    <message>
        <source>this unit was never served, so there is nothing for a label</source>
        <translation>dieses Gerät war nie in Bearbeitung; für ein Etikett gibt es nichts</translation>
    </message>
    <message>
        <source>units are served here; the link stays open</source>
        <translation>hier werden Geräte bearbeitet; der Anschluss bleibt offen</translation>
    </message>
    <message>
        <source>write a page</source>
        <translation>eine Seite schreiben</translation>
    </message>
    <message>
        <source>does not answer</source>
        <translation>antwortet nicht</translation>
    </message>
    <message>
        <source>hold Arm, then put it on again</source>
        <translation>Scharf-Taste halten, dann das Gerät erneut anschließen</translation>
    </message>
    <message>
        <source>it was cut off at &apos;%1&apos; and does not answer any more</source>
        <translation>es wurde bei „%1“ abgebrochen und antwortet nicht mehr</translation>
    </message>
    <message>
        <source>left before the station was armed</source>
        <translation>verlassen, bevor die Station scharf war</translation>
    </message>
    <message>
        <source>look at cable and supply; when it answers again it is served from the beginning</source>
        <translation>Kabel und Versorgung prüfen; antwortet es wieder, wird es von vorn bearbeitet</translation>
    </message>
    <message>
        <source>the unit was taken off while it waited for the station to be armed</source>
        <translation>das Gerät wurde abgenommen, während es auf das Scharfschalten der Station wartete</translation>
    </message>
    <message>
        <source>waits until the station is armed</source>
        <translation>wartet auf Scharfschalten</translation>
    </message>
    <message>
        <source>a step of %1 stands in noise of %2, at most %3; the mean of %4 tells it</source>
        <translation>ein Schritt von %1 steht in einem Rauschen von %2, höchstens %3; das Mittel aus %4 zeigt ihn</translation>
    </message>
    <message>
        <source>on the model as these steps have corrected it, other gains leave less error; now those</source>
        <translation>auf dem Modell, wie diese Schritte es berichtigt haben, lassen andere Verstärkungen weniger Fehler; jetzt diese</translation>
    </message>
    <message>
        <source>those that were proven first left more error, these leave %1 of it</source>
        <translation>die zuerst geprüften ließen mehr Fehler, diese lassen %1 davon</translation>
    </message>
    <message>
        <source>their model was corrected by those that were proven first, which left no clearly more error</source>
        <translation>ihr Modell wurde durch die zuerst geprüften berichtigt, die nicht deutlich mehr Fehler ließen</translation>
    </message>
    <message>
        <source>a chunk of it is damaged</source>
        <translation>ein Stück davon ist beschädigt</translation>
    </message>
    <message>
        <source>a chunk of it is larger than %1 MB</source>
        <translation>ein Stück davon ist größer als %1 MB</translation>
    </message>
    <message>
        <source>its chunks are packed by &apos;%1&apos;; zstd and lz4 are known</source>
        <translation>seine Stücke sind mit &apos;%1&apos; gepackt; bekannt sind zstd und lz4</translation>
    </message>
    <message>
        <source>messages in JSON can be read, and what this program wrote</source>
        <translation>lesbar sind Nachrichten in JSON und was dieses Programm geschrieben hat</translation>
    </message>
    <message>
        <source>--theme takes dark, light, contrast or system</source>
        <translation>--theme nimmt dark, light, contrast oder system</translation>
    </message>
    <message>
        <source>give an .mcap with messages in JSON or of this program, a .csv, or the output of watch</source>
        <translation>eine .mcap mit Nachrichten in JSON oder von diesem Programm, eine .csv oder die Ausgabe von watch angeben</translation>
    </message>
    <message>
        <source>overshoot %1, not settled</source>
        <translation>Überschwingen %1, nicht ausgeregelt</translation>
    </message>
    <message>
        <source>overshoot %1, settled in %2</source>
        <translation>Überschwingen %1, ausgeregelt in %2</translation>
    </message>
    <message>
        <source>seed, loss, bitrate and fault are known</source>
        <translation>bekannt sind seed, loss, bitrate und fault</translation>
    </message>
    <message>
        <source>within its limits, at attempt %1: samples were lost before</source>
        <translation>in seinen Grenzen, beim Versuch %1: vorher gingen Messwerte verloren</translation>
    </message>
    <message>
        <source>its speed goes on swinging by %1 where it should rest, whole counts alone would make %2</source>
        <translation>seine Drehzahl schwingt um %1 weiter, wo sie ruhen sollte, ganze Counts allein ergäben %2</translation>
    </message>
    <message>
        <source>This unit has no number yet; assign one from 1 to 63.</source>
        <translation>Dieses Gerät hat noch keine Nummer; eine von 1 bis 63 zuweisen.</translation>
    </message>
    <message>
        <source>find its gain scales first: Overview, Find the gain scales</source>
        <translation>zuerst die Skalierung der Verstärkungen ermitteln: Übersicht, „Skalierung der Verstärkungen ermitteln“</translation>
    </message>
    <message>
        <source>a count or their largest error makes more output than it may</source>
        <translation>ein Inkrement oder ihr größter Fehler macht mehr Ausgang, als er darf</translation>
    </message>
    <message>
        <source>the gains that were there may leave as little error; now those</source>
        <translation>die Verstärkungen, die da waren, lassen vielleicht ebenso wenig Fehler; jetzt diese</translation>
    </message>
    <message>
        <source>their largest sensitivity is %1, at most %2 are allowed, and %3 with more gain and delay</source>
        <translation>ihre größte Empfindlichkeit ist %1, erlaubt sind höchstens %2, und %3 mit mehr Verstärkung und Totzeit</translation>
    </message>
    <message>
        <source>there was no time to compare them with those that were there</source>
        <translation>für den Vergleich mit den vorherigen blieb keine Zeit</translation>
    </message>
    <message>
        <source>they would draw more current than is allowed</source>
        <translation>sie zögen mehr Strom als erlaubt</translation>
    </message>
    <message>
        <source>they would overshoot by %1</source>
        <translation>sie schwängen um %1 über</translation>
    </message>
    <message>
        <source>those that were found left more error: these, which were there, leave %1 of it</source>
        <translation>die gefundenen ließen mehr Fehler: diese, die schon da waren, lassen %1 davon</translation>
    </message>
    <message>
        <source>those that were there leave more error</source>
        <translation>die vorherigen lassen mehr Fehler</translation>
    </message>
    <message>
        <source>those that were there would leave less error, but are not for keeping: %1</source>
        <translation>die vorherigen ließen weniger Fehler, sind aber nichts zum Behalten: %1</translation>
    </message>
    <message>
        <source>what is left over is much of so small steps; the same with larger ones</source>
        <translation>was übrig bleibt, ist viel von so kleinen Sprüngen; dasselbe mit größeren</translation>
    </message>
    <message>
        <source>what was there is not known, and these were not compared with it</source>
        <translation>was da war, ist nicht bekannt, und diese wurden nicht damit verglichen</translation>
    </message>
    <message>
        <source>bus voltage</source>
        <translation>Busspannung</translation>
    </message>
    <message>
        <source>direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>energy</source>
        <translation>Energie</translation>
    </message>
    <message>
        <source>foreign master</source>
        <translation>anderer Master</translation>
    </message>
    <message>
        <source>interrupted</source>
        <translation>abgebrochen</translation>
    </message>
    <message>
        <source>lateness</source>
        <translation>Verspätung</translation>
    </message>
    <message>
        <source>link</source>
        <translation>Verbindung</translation>
    </message>
    <message>
        <source>missing guardian</source>
        <translation>Wächter fehlt</translation>
    </message>
    <message>
        <source>no motion</source>
        <translation>keine Bewegung</translation>
    </message>
    <message>
        <source>oscillation</source>
        <translation>Schwingung</translation>
    </message>
    <message>
        <source>refusal</source>
        <translation>Ablehnung</translation>
    </message>
    <message>
        <source>restart</source>
        <translation>Neustart</translation>
    </message>
    <message>
        <source>sleep</source>
        <translation>Schlafzustand</translation>
    </message>
    <message>
        <source>temperature</source>
        <translation>Temperatur</translation>
    </message>
    <message>
        <source>time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>user</source>
        <translation>Benutzer</translation>
    </message>
    <message>
        <source>a step would draw too much current: the unit&apos;s own profile leads, at %1 counts/s at most</source>
        <translation>ein Sprung zöge zu viel Strom: das eigene Profil des Geräts führt, mit höchstens %1 counts/s</translation>
    </message>
    <message>
        <source>allow more travel, duty or current</source>
        <translation>mehr Weg, Tastgrad oder Strom erlauben</translation>
    </message>
    <message>
        <source>an answer was lost; the same again</source>
        <translation>eine Antwort ging verloren; dasselbe noch einmal</translation>
    </message>
    <message>
        <source>friction takes %1 of what its current limit and its room allow, at most 60 %</source>
        <translation>die Reibung nimmt %1 dessen, was Stromgrenze und Weg erlauben, höchstens 60 %</translation>
    </message>
    <message>
        <source>friction takes more than half of what P makes of a step</source>
        <translation>die Reibung nimmt mehr als die Hälfte dessen, was P aus einem Sprung macht</translation>
    </message>
    <message>
        <source>its own profile leads there at %1 counts/s</source>
        <translation>sein eigenes Profil führt dorthin, mit %1 counts/s</translation>
    </message>
    <message>
        <source>see whether the motor is too strong for this unit</source>
        <translation>prüfen, ob der Motor für dieses Gerät zu stark ist</translation>
    </message>
    <message>
        <source>the unit&apos;s own profile led at %1 counts/s, for a step would draw too much current</source>
        <translation>das eigene Profil des Geräts führte mit %1 counts/s, denn ein Sprung zöge zu viel Strom</translation>
    </message>
    <message>
        <source>at most %1 duty, %2 counts/s and %3 counts from where it stands</source>
        <translation>höchstens %1 Tastgrad, %2 counts/s und %3 counts von der jetzigen Stelle</translation>
    </message>
    <message>
        <source>first its direction is checked: %1 counts up</source>
        <translation>zuerst wird seine Richtung geprüft: %1 counts aufwärts</translation>
    </message>
    <message>
        <source>its loop takes its velocity every %1 ms, every %2 ms was expected</source>
        <translation>sein Regelkreis bestimmt die Drehzahl alle %1 ms, erwartet waren %2 ms</translation>
    </message>
    <message>
        <source>perhaps its D acts the other way round than in the firmware that is known</source>
        <translation>vielleicht wirkt sein D andersherum als in der bekannten Firmware</translation>
    </message>
    <message>
        <source>see which firmware it runs</source>
        <translation>prüfen, welche Firmware läuft</translation>
    </message>
    <message>
        <source>a regression of mean speeds makes the lag %1, %2 beside what was fitted</source>
        <translation>eine Regression mittlerer Drehzahlen ergibt als Zeitkonstante %1, %2 neben der Anpassung</translation>
    </message>
    <message>
        <source>F is 0: in a position loop it would push by where the target lies, not by how far it is</source>
        <translation>F ist 0: In der Positionsregelung würde es nach dem Ort des Ziels drücken, nicht nach seiner Entfernung</translation>
    </message>
    <message>
        <source>F is 0: with an integral both would give what friction and speed take, and it would overshoot</source>
        <translation>F ist 0: Zusammen mit einem Integral gäben beide, was Reibung und Drehzahl brauchen, und es schwänge über</translation>
    </message>
    <message>
        <source>it is %1</source>
        <translation>es ist %1</translation>
    </message>
    <message>
        <source>number %1 has another session</source>
        <translation>Nummer %1 hat eine andere Session</translation>
    </message>
    <message>
        <source>chatter of the duty</source>
        <translation>Unruhe des Tastgrads</translation>
    </message>
    <message>
        <source>encoder</source>
        <translation>Encoder</translation>
    </message>
    <message>
        <source>error at rest</source>
        <translation>bleibende Abweichung</translation>
    </message>
    <message>
        <source>friction</source>
        <translation>Reibung</translation>
    </message>
    <message>
        <source>gain</source>
        <translation>Verstärkung</translation>
    </message>
    <message>
        <source>noise</source>
        <translation>Rauschen</translation>
    </message>
    <message>
        <source>overshoot</source>
        <translation>Überschwingen</translation>
    </message>
    <message>
        <source>peak current</source>
        <translation>Stromspitze</translation>
    </message>
    <message>
        <source>resistance</source>
        <translation>Widerstand</translation>
    </message>
    <message>
        <source>rise</source>
        <translation>Anstieg</translation>
    </message>
    <message>
        <source>settle</source>
        <translation>Ausregelzeit</translation>
    </message>
    <message>
        <source>time at the duty limit</source>
        <translation>Zeit an der Tastgradgrenze</translation>
    </message>
    <message>
        <source>undershoot</source>
        <translation>Unterschwingen</translation>
    </message>
    <message>
        <source>%1 was cleared but reads %2</source>
        <translation>%1 wurde gelöscht, gelesen wird %2</translation>
    </message>
    <message>
        <source>%1: unknown key %2</source>
        <translation>%1: unbekannter Schlüssel %2</translation>
    </message>
    <message>
        <source>%1; the gains of the axis were not known, and are now those that the board starts with</source>
        <translation>%1; die Verstärkungen der Achse waren unbekannt und sind jetzt die, mit denen die Platine startet</translation>
    </message>
    <message>
        <source>correct it, or delete its row</source>
        <translation>berichtigen oder die Zeile löschen</translation>
    </message>
    <message>
        <source>its cause is there again, or still</source>
        <translation>die Ursache besteht wieder oder noch immer</translation>
    </message>
    <message>
        <source>the gains of axis %1 are not known here: it will be left with those that the board starts with</source>
        <translation>die Verstärkungen der Achse %1 sind hier unbekannt: sie behält am Ende die, mit denen die Platine startet</translation>
    </message>
    <message>
        <source>the gains of this loop are not known here, so its target begins within %1 of where it is, and goes further as its output is seen to allow it; write its p, d and divisor once</source>
        <translation>die Verstärkungen dieses Reglers sind hier unbekannt, sein Ziel beginnt also innerhalb %1 von seinem Ort und geht weiter, sobald seine Ausgabe es sichtlich erlaubt; einmal p, d und divisor schreiben</translation>
    </message>
    <message>
        <source>write &quot;value&quot; or &quot;raw&quot;</source>
        <translation>&quot;value&quot; oder &quot;raw&quot; schreiben</translation>
    </message>
    <message>
        <source>%1 duty makes the motor quicker than %2 counts/s, which are allowed</source>
        <translation>%1 Tastgrad machen den Motor schneller als die erlaubten %2 counts/s</translation>
    </message>
    <message>
        <source>&apos;sqlite3 %1 .recover&apos; tells what it still holds; where it is moved away, a new one is begun</source>
        <translation>&apos;sqlite3 %1 .recover&apos; zeigt, was sie noch enthält; ist sie weggeräumt, wird eine neue begonnen</translation>
    </message>
    <message>
        <source>another program holds it: try again when that has ended</source>
        <translation>Ein anderes Programm hält sie: noch einmal versuchen, wenn es beendet ist</translation>
    </message>
    <message>
        <source>look whether its disk is there, has room and is in order</source>
        <translation>prüfen, ob ihr Datenträger da ist, Platz hat und in Ordnung ist</translation>
    </message>
    <message>
        <source>make room on its disk</source>
        <translation>Platz auf ihrem Datenträger schaffen</translation>
    </message>
    <message>
        <source>%1: its value is in &apos;%2&apos;, its unit is &apos;%3&apos;</source>
        <translation>%1: Der Wert steht in „%2“, die Einheit ist „%3“</translation>
    </message>
    <message>
        <source>write it in that unit</source>
        <translation>In dieser Einheit schreiben</translation>
    </message>
    <message>
        <source>a line has more than %1 bytes</source>
        <translation>eine Zeile hat mehr als %1 Bytes</translation>
    </message>
    <message>
        <source>allow more duty, speed or travel</source>
        <translation>mehr Tastgrad, Drehzahl oder Weg erlauben</translation>
    </message>
    <message>
        <source>it came to %1 of its step while that was held</source>
        <translation>er kam nur auf %1 seines Sprungs, solange dieser gehalten wurde</translation>
    </message>
    <message>
        <source>the pushes that its limits leave hardly moved the motor</source>
        <translation>die Stöße, die seine Grenzen übrig lassen, haben den Motor kaum bewegt</translation>
    </message>
    <message>
        <source>it may rest %1 short of its target until its integral has overcome friction</source>
        <translation>er kann %1 vor seinem Ziel stehen bleiben, bis sein Integral die Reibung überwunden hat</translation>
    </message>
    <message>
        <source>%1 has restarted and did not say yet whether it is the same unit</source>
        <translation>%1 wurde neu gestartet und hat noch nicht gesagt, ob es dasselbe Gerät ist</translation>
    </message>
    <message>
        <source>another unit stands in its place by now</source>
        <translation>an seiner Stelle steht inzwischen ein anderes Gerät</translation>
    </message>
    <message>
        <source>look at what it says, then order it again</source>
        <translation>ansehen, was es meldet, dann erneut anordnen</translation>
    </message>
    <message>
        <source>compile an offset of its own, 1 … 99, into its firmware, or leave it alone on the bus</source>
        <translation>in seine Firmware einen eigenen Offset von 1 … 99 kompilieren oder ihn allein am Bus lassen</translation>
    </message>
    <message>
        <source>what is sent to offset 0 is done by every drive of the bus, and others answer on this one</source>
        <translation>was an Offset 0 gesendet wird, tut jeder Antrieb am Bus, und an diesem antworten weitere</translation>
    </message>
    <message>
        <source>the board is told to tell its whole counters; look at the position, and run it again</source>
        <translation>Das Board soll jetzt seine ganzen Zähler nennen; die Position ansehen, dann erneut starten</translation>
    </message>
    <message>
        <source>%1 settings were written and cannot be read back</source>
        <translation>%1 Einstellungen wurden geschrieben und lassen sich nicht zurücklesen</translation>
    </message>
    <message>
        <source>1 setting was written and cannot be read back</source>
        <translation>1 Einstellung wurde geschrieben und lässt sich nicht zurücklesen</translation>
    </message>
    <message>
        <source>put it on again, and do it again</source>
        <translation>Wieder anstecken und noch einmal ausführen</translation>
    </message>
    <message>
        <source>the unit was taken off while it waited for a number</source>
        <translation>Das Gerät wurde abgenommen, während es auf eine Nummer wartete</translation>
    </message>
    <message>
        <source>%1 is not told as often as was asked for: %2</source>
        <translation>%1 wird nicht so oft gemeldet wie verlangt: %2</translation>
    </message>
    <message>
        <source>%1: the gains were not put back: %2</source>
        <translation>%1: die Verstärkungen wurden nicht zurückgeschrieben: %2</translation>
    </message>
    <message>
        <source>let it come to rest first</source>
        <translation>erst zur Ruhe kommen lassen</translation>
    </message>
    <message>
        <source>no position for %1</source>
        <translation>seit %1 keine Position</translation>
    </message>
    <message>
        <source>the gains were not put back: %1</source>
        <translation>die Verstärkungen wurden nicht zurückgeschrieben: %1</translation>
    </message>
    <message>
        <source>the gains were not put back: %1; they are offered at the next connection</source>
        <translation>die Verstärkungen wurden nicht zurückgeschrieben: %1; bei der nächsten Verbindung werden sie angeboten</translation>
    </message>
    <message>
        <source>the shaft still turns, so nobody can tell which way it is pushed</source>
        <translation>die Welle dreht sich noch, darum ist nicht zu erkennen, wohin sie geschoben wird</translation>
    </message>
    <message>
        <source>the stop was not confirmed by %1</source>
        <translation>%1 hat das Anhalten nicht bestätigt</translation>
    </message>
    <message>
        <source>what was proven could not be written: %1</source>
        <translation>das Erprobte konnte nicht geschrieben werden: %1</translation>
    </message>
    <message>
        <source>what was proven could not be written: %1; what was there before is in force again</source>
        <translation>das Erprobte konnte nicht geschrieben werden: %1; was vorher da war, gilt wieder</translation>
    </message>
    <message>
        <source>what was proven could not be written: %1; what was there before was not put back: %2; it is offered at the next connection</source>
        <translation>das Erprobte konnte nicht geschrieben werden: %1; was vorher da war, wurde nicht zurückgeschrieben: %2; bei der nächsten Verbindung wird es angeboten</translation>
    </message>
    <message>
        <source>a duty that grew to %1 did not move the motor both ways</source>
        <translation>ein Tastgrad, der auf %1 wuchs, hat den Motor nicht in beide Richtungen bewegt</translation>
    </message>
    <message>
        <source>it lets go at %1 forwards and %2 backwards, known within %3, and takes %4 and %5 while it turns (R² %6)</source>
        <translation>er löst sich bei %1 vorwärts und %2 rückwärts, bekannt auf %3, und braucht %4 und %5, während er sich dreht (R² %6)</translation>
    </message>
    <message>
        <source>pushing with a duty that grows to %1 in %2 s</source>
        <translation>Stoß mit einem Tastgrad, der in %2 s auf %1 wächst</translation>
    </message>
    <message>
        <source>there is no room for a duty that grows slowly</source>
        <translation>für einen Tastgrad, der langsam wächst, ist kein Platz</translation>
    </message>
    <message>
        <source>%1 has a time that is more than 140 years from 1970</source>
        <translation>%1 hat eine Zeit, die mehr als 140 Jahre von 1970 entfernt ist</translation>
    </message>
    <message>
        <source>record with the clock set</source>
        <translation>mit gestellter Uhr aufzeichnen</translation>
    </message>
    <message>
        <source>an experiment on it has not ended</source>
        <translation>ein Versuch damit ist noch nicht zu Ende</translation>
    </message>
    <message>
        <source>begin a queue first</source>
        <translation>zuerst eine Reihe beginnen</translation>
    </message>
    <message>
        <source>firmware is written to a unit here; the link stays open</source>
        <translation>hier wird in ein Gerät Firmware geschrieben; der Anschluss bleibt offen</translation>
    </message>
    <message>
        <source>it has passed</source>
        <translation>es hat bestanden</translation>
    </message>
    <message>
        <source>it is being served, or waits for its turn</source>
        <translation>es ist gerade dran oder wartet darauf</translation>
    </message>
    <message>
        <source>it is not armed, or moves</source>
        <translation>es ist nicht scharf, oder es bewegt sich</translation>
    </message>
    <message>
        <source>it is not in the queue</source>
        <translation>es ist nicht in der Reihe</translation>
    </message>
    <message>
        <source>it was taken off</source>
        <translation>es wurde abgenommen</translation>
    </message>
    <message>
        <source>nothing is served here</source>
        <translation>hier ist nichts in Arbeit</translation>
    </message>
    <message>
        <source>put it on again; it gets a row of its own</source>
        <translation>wieder anschließen; es bekommt eine eigene Zeile</translation>
    </message>
    <message>
        <source>take it off and put it on again to serve it once more</source>
        <translation>abnehmen und wieder anschließen, dann kommt es noch einmal dran</translation>
    </message>
    <message>
        <source>wait until it has, or stop it</source>
        <translation>warten, bis er zu Ende ist, oder ihn anhalten</translation>
    </message>
    <message>
        <source>wait until it is done, or cancel it</source>
        <translation>warten, bis das fertig ist, oder es abbrechen</translation>
    </message>
    <message>
        <source>after a move with a velocity or a profile it is not known from where this distance counts</source>
        <translation>nach einer Fahrt mit Drehzahl oder Profil ist nicht bekannt, von wo diese Strecke zählt</translation>
    </message>
    <message>
        <source>avrdude read back all %1 bytes and they are equal, but the port is away</source>
        <translation>avrdude hat alle %1 Byte zurückgelesen und sie sind gleich, aber der Anschluss ist weg</translation>
    </message>
    <message>
        <source>halt it first, or give a position</source>
        <translation>zuerst anhalten oder eine Position angeben</translation>
    </message>
    <message>
        <source>restart the unit: its old firmware is still there</source>
        <translation>das Gerät neu starten: seine alte Firmware ist noch da</translation>
    </message>
    <message>
        <source>the drive may hold half a program, and runs again once an update has succeeded</source>
        <translation>der Antrieb hat vielleicht nur ein halbes Programm und läuft wieder, sobald ein Update gelungen ist</translation>
    </message>
    <message>
        <source>the motor may be %1 counts from where its loop holds it, and with this P that overflows</source>
        <translation>der Motor ist vielleicht %1 Schritte von dort entfernt, wo sein Regler ihn hält, und mit diesem P läuft das über</translation>
    </message>
    <message>
        <source>another adapter has this name now; what was found on the one before is not in the list any more</source>
        <translation>ein anderer Adapter hat jetzt diesen Namen; was am vorigen gefunden wurde, steht nicht mehr in der Liste</translation>
    </message>
    <message>
        <source>another adapter is called %1 now</source>
        <translation>jetzt heißt ein anderer Adapter %1</translation>
    </message>
    <message>
        <source>close the link, and open it again to see who is there</source>
        <translation>schließen Sie die Verbindung und öffnen Sie sie wieder, um zu sehen, wer dort ist</translation>
    </message>
    <message>
        <source>another unit answers as number %1: serial number &apos;%2&apos; instead of &apos;%3&apos;</source>
        <translation>ein anderes Gerät antwortet als Nummer %1: Seriennummer „%2“ statt „%3“</translation>
    </message>
    <message>
        <source>scan again, and update it if it is the one that is meant</source>
        <translation>neu suchen und es aktualisieren, wenn es das gemeinte ist</translation>
    </message>
    <message>
        <source>the unit with number %1 has another session than before, and may be another unit: its serial number was not known</source>
        <translation>das Gerät mit der Nummer %1 hat eine andere Sitzung als vorher und kann ein anderes sein: seine Seriennummer war nicht bekannt</translation>
    </message>
    <message>
        <source>begin it once more to serve this unit again</source>
        <translation>beginnen Sie sie noch einmal, um dieses Gerät erneut zu bearbeiten</translation>
    </message>
    <message>
        <source>the queue was ended</source>
        <translation>die Warteschlange wurde beendet</translation>
    </message>
    <message>
        <source>%1 has more than %2 MB that are no samples</source>
        <translation>%1 hat mehr als %2 MB, die keine Messwerte sind</translation>
    </message>
    <message>
        <source>%1 was taken away; what memory still has of it is recorded anew</source>
        <translation>%1 wurde weggenommen; was der Speicher davon noch hat, wird neu aufgezeichnet</translation>
    </message>
    <message>
        <source>leave that folder where it is</source>
        <translation>diesen Ordner lassen, wo er ist</translation>
    </message>
    <message>
        <source>the file was deleted while it was written</source>
        <translation>die Datei wurde gelöscht, während sie geschrieben wurde</translation>
    </message>
    <message>
        <source>write it anew</source>
        <translation>neu schreiben</translation>
    </message>
    <message>
        <source>the kernel does not say what %1 is: a driver holds it up</source>
        <translation>der Kernel sagt nicht, was %1 ist: Ein Treiber hält ihn auf</translation>
    </message>
    <message>
        <source>unplug the adapter and plug it in again</source>
        <translation>den Adapter abziehen und wieder anstecken</translation>
    </message>
    <message>
        <source>its velocity loop begins with the mean speed since it ran last: from %1 to %2 counts/s, with the speed of now, is so much that with its gains the output would turn to full reverse</source>
        <translation>sein Drehzahlregler beginnt mit der mittleren Drehzahl, seit er zuletzt lief: von %1 bis %2 counts/s, mit der jetzigen Drehzahl, ist so viel, dass der Ausgang mit seinen Verstärkungen auf voll rückwärts umschlagen würde</translation>
    </message>
    <message>
        <source>stop the motor and let it stand for a while, or lower p</source>
        <translation>den Motor anhalten und eine Weile stehen lassen oder p verkleinern</translation>
    </message>
    <message>
        <source>stop the motor and let it stand for a while, or write p, d and divisor of the loop once</source>
        <translation>den Motor anhalten und eine Weile stehen lassen oder p, d und divisor des Reglers einmal schreiben</translation>
    </message>
    <message>
        <source>%1 has restarted, and nobody has looked at it since</source>
        <translation>%1 ist neu gestartet, und niemand hat seither danach gesehen</translation>
    </message>
    <message>
        <source>Answers with offset %1 are destroyed on the bus, as where several drives have it and answer at once; offsets are compiled into the firmware, so give one of them another and flash it.</source>
        <translation>Antworten mit Offset %1 werden auf dem Bus zerstört, wie wo mehrere Antriebe ihn haben und zugleich antworten; Offsets stecken in der Firmware, also einem davon einen anderen geben und ihn flashen.</translation>
    </message>
    <message>
        <source>the notebook may offer to put back what was there before: %1</source>
        <translation>das Versuchsbuch bietet womöglich an, zurückzuschreiben, was vorher da war: %1</translation>
    </message>
    <message>
        <source>turn its shaft until its position is %1 counts away from 0, which shows that it was off, then switch it off and on</source>
        <translation>drehen Sie seine Welle, bis seine Position %1 Schritte von 0 entfernt ist, denn daran ist zu sehen, dass er aus war; schalten Sie ihn dann aus und wieder ein</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be above 0 and at most %2</source>
        <translation>&apos;%1&apos; muss größer als 0 und höchstens %2 sein</translation>
    </message>
    <message>
        <source>nothing was written, because what is there cannot be kept: %1</source>
        <translation>nichts wurde geschrieben, weil das Vorhandene nicht aufbewahrt werden kann: %1</translation>
    </message>
    <message>
        <source>where it is left out the unit&apos;s own limit serves</source>
        <translation>wo er fehlt, gilt die eigene Grenze des Geräts</translation>
    </message>
    <message>
        <source>its number holds from its next power cycle on, and nothing proves it before</source>
        <translation>seine Nummer gilt ab dem nächsten Aus- und Einschalten, und nichts beweist sie vorher</translation>
    </message>
    <message>
        <source>put it back first, as &apos;motorbenchctl set %1 %2&apos; does</source>
        <translation>zuerst zurückstellen, wie es &apos;motorbenchctl set %1 %2&apos; tut</translation>
    </message>
    <message>
        <source>trial %1 did not put back what it changed</source>
        <translation>Versuch %1 hat nicht zurückgestellt, was er geändert hat</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must not be empty</source>
        <translation>&apos;%1&apos; darf nicht leer sein</translation>
    </message>
    <message>
        <source>the steps in both directions kept their limits; the gains are as they were</source>
        <translation>die Sprünge in beide Richtungen hielten ihre Grenzen ein; die Verstärkungen sind, wie sie waren</translation>
    </message>
    <message>
        <source>the steps in both directions kept their limits; the gains were written and read back</source>
        <translation>die Sprünge in beide Richtungen hielten ihre Grenzen ein; die Verstärkungen wurden geschrieben und zurückgelesen</translation>
    </message>
    <message>
        <source>the steps in both directions kept their limits; the gains were written, which this family cannot read back</source>
        <translation>die Sprünge in beide Richtungen hielten ihre Grenzen ein; die Verstärkungen wurden geschrieben, diese Familie lässt sie nicht zurücklesen</translation>
    </message>
    <message>
        <source>%1 CAN FD frames are left out, because only classic CAN is read</source>
        <translation>%1 CAN-FD-Frames sind ausgelassen, denn gelesen wird nur klassisches CAN</translation>
    </message>
    <message>
        <source>1 CAN FD frame is left out, because only classic CAN is read</source>
        <translation>1 CAN-FD-Frame ist ausgelassen, denn gelesen wird nur klassisches CAN</translation>
    </message>
    <message>
        <source>a simulated board&apos;s socket has no option &apos;%1&apos;</source>
        <translation>der Socket einer simulierten Platine hat keine Option „%1“</translation>
    </message>
    <message>
        <source>it has pace</source>
        <translation>sie hat pace</translation>
    </message>
    <message>
        <source>leave one of the two out</source>
        <translation>lassen Sie eine der beiden weg</translation>
    </message>
    <message>
        <source>legal are 0 and 1</source>
        <translation>zulässig sind 0 und 1</translation>
    </message>
    <message>
        <source>link option &apos;%1&apos; is there twice</source>
        <translation>die Option „%1“ der Verbindung steht zweimal da</translation>
    </message>
    <message>
        <source>pace=%1 is no choice</source>
        <translation>pace=%1 ist keine Auswahl</translation>
    </message>
    <message>
        <source>the last line has no end, so its frame may be cut short</source>
        <translation>die letzte Zeile hat kein Ende, ihr Frame kann also gekürzt sein</translation>
    </message>
    <message>
        <source>the last line is cut off, and left out</source>
        <translation>die letzte Zeile ist abgeschnitten und ausgelassen</translation>
    </message>
    <message>
        <source>nothing proves that its flash has what was written</source>
        <translation>nichts beweist, dass in seinem Flash steht, was geschrieben wurde</translation>
    </message>
    <message>
        <source>switch its supply off and on, then do it again: what is read then comes from its flash</source>
        <translation>die Versorgung aus- und einschalten, dann noch einmal: was dann gelesen wird, kommt aus seinem Flash</translation>
    </message>
    <message>
        <source>take it out of the recipe&apos;s parameters, or serve such units by a recipe of their own</source>
        <translation>ihn aus den Parametern des Rezepts nehmen oder solche Geräte nach einem eigenen Rezept bedienen</translation>
    </message>
    <message>
        <source>take one of them off, then test the other again</source>
        <translation>eines davon abnehmen, dann das andere noch einmal prüfen</translation>
    </message>
    <message>
        <source>this unit does not have %1 of the recipe</source>
        <translation>dieses Gerät hat %1 des Rezepts nicht</translation>
    </message>
    <message>
        <source>two units tell the serial number %1</source>
        <translation>zwei Geräte melden die Seriennummer %1</translation>
    </message>
    <message>
        <source>a stop came before it was begun</source>
        <translation>ein Stopp kam, bevor es begonnen war</translation>
    </message>
    <message>
        <source>it has restarted, or a second unit has number %1: another session answers</source>
        <translation>es hat neu gestartet, oder ein zweites Gerät hat die Nummer %1: eine andere Sitzung antwortet</translation>
    </message>
    <message>
        <source>its position is being reset</source>
        <translation>seine Position wird gerade zurückgesetzt</translation>
    </message>
    <message>
        <source>it did not say that it restarts, and may have done so or not</source>
        <translation>es hat nicht gemeldet, dass es neu startet, und kann es getan haben oder nicht</translation>
    </message>
    <message>
        <source>restart it once more</source>
        <translation>noch einmal neu starten</translation>
    </message>
    <message>
        <source>%1 leads to a terminal that another program serves</source>
        <translation>%1 führt zu einem Terminal, das ein anderes Programm bedient</translation>
    </message>
    <message>
        <source>%1 takes no bytes any more</source>
        <translation>%1 nimmt keine Bytes mehr an</translation>
    </message>
    <message>
        <source>a stop that is owed cannot be written down: %1 cannot be used</source>
        <translation>ein ausstehender Stopp kann nicht festgehalten werden: %1 ist nicht benutzbar</translation>
    </message>
    <message>
        <source>it must be a folder of yours that nobody else may write to</source>
        <translation>es muss ein eigener Ordner sein, in den sonst niemand schreiben darf</translation>
    </message>
    <message>
        <source>the simulator at %1 does not answer</source>
        <translation>der Simulator an %1 antwortet nicht</translation>
    </message>
    <message>
        <source>a limit switch was met</source>
        <translation>ein Endschalter wurde erreicht</translation>
    </message>
    <message>
        <source>no time was left to prove others</source>
        <translation>für einen Nachweis anderer blieb keine Zeit</translation>
    </message>
    <message>
        <source>what these gains do is predicted, and not proven on the motor</source>
        <translation>was diese Verstärkungen bewirken, ist vorhergesagt und nicht am Motor bewiesen</translation>
    </message>
    <message>
        <source>what was there is not known, and those that were tried are in force</source>
        <translation>was da war, ist nicht bekannt, und die zuletzt versuchten gelten</translation>
    </message>
    <message>
        <source>its averaging was lowered, or set beyond 500, as far as can be known, and until it has lost its power once it may overwrite its own memory</source>
        <translation>seine Mittelung wurde verkleinert oder über 500 gesetzt, soweit man das wissen kann, und bis er einmal stromlos war, kann er seinen eigenen Speicher überschreiben</translation>
    </message>
    <message>
        <source>stop the motor before its calibration is changed</source>
        <translation>stoppen Sie den Motor, bevor seine Kalibrierung geändert wird</translation>
    </message>
    <message>
        <source>the power limit of axis %1 is %2: its motor gets no more</source>
        <translation>die Leistungsgrenze der Achse %1 ist %2: mehr bekommt ihr Motor nicht</translation>
    </message>
    <message>
        <source>the velocity limit of axis %1 is %2: its motor goes no faster</source>
        <translation>die Drehzahlgrenze der Achse %1 ist %2: schneller wird ihr Motor nicht</translation>
    </message>
    <message>
        <source>write an averaging of 1 … 500, then switch it off and on</source>
        <translation>schreiben Sie eine Mittelung von 1 … 500, dann schalten Sie ihn aus und wieder ein</translation>
    </message>
    <message>
        <source>Nothing is written yet. Where OpenOCD has halted the drive already it stands still: switch it off and on</source>
        <translation>Noch ist nichts geschrieben. Hat OpenOCD den Antrieb schon angehalten, so steht er: aus- und wieder einschalten</translation>
    </message>
    <message>
        <source>firmware is written here, or units are served; nothing was searched</source>
        <translation>hier wird Firmware geschrieben, oder Geräte werden bedient; nichts wurde gesucht</translation>
    </message>
    <message>
        <source>put the programmer on it, and look at the other one</source>
        <translation>den Programmer dort anschließen, und nach dem anderen sehen</translation>
    </message>
    <message>
        <source>the programmer wrote another unit: %1 answered all the while</source>
        <translation>der Programmer hat ein anderes Gerät beschrieben: %1 hat die ganze Zeit geantwortet</translation>
    </message>
    <message>
        <source>wait until it is done</source>
        <translation>warten, bis es fertig ist</translation>
    </message>
    <message>
        <source>averaging changed: it may overwrite its memory</source>
        <translation>Mittelung geändert: das Gerät kann seinen Speicher überschreiben</translation>
    </message>
    <message>
        <source>the acceptance mask of node %1 is not known, so it may do what is sent to node %2, too; set its error.level to 0 where it is 1, then scan again</source>
        <translation>die Akzeptanzmaske von Knoten %1 ist nicht bekannt, er führt also vielleicht auch aus, was an Knoten %2 geht; sein error.level auf 0 setzen, falls es 1 ist, dann neu suchen</translation>
    </message>
    <message>
        <source>All of it is written; whether the unit runs it is not known then</source>
        <translation>Alles ist geschrieben; ob das Gerät damit läuft, ist dann nicht bekannt</translation>
    </message>
    <message>
        <source>%1 settings are lost with its power</source>
        <translation>%1 Einstellungen gehen mit seiner Stromversorgung verloren</translation>
    </message>
    <message>
        <source>%1 settings hold from its next power cycle on, and nothing proves them before</source>
        <translation>%1 Einstellungen gelten ab dem nächsten Aus- und Einschalten, und nichts beweist sie vorher</translation>
    </message>
    <message>
        <source>1 setting holds from its next power cycle on, and nothing proves it before</source>
        <translation>1 Einstellung gilt ab dem nächsten Aus- und Einschalten, und nichts beweist sie vorher</translation>
    </message>
    <message>
        <source>1 setting is lost with its power</source>
        <translation>1 Einstellung geht mit seiner Stromversorgung verloren</translation>
    </message>
    <message>
        <source>a unit whose %1 was lowered must lose its power once before its motor may be driven</source>
        <translation>ein Gerät, dessen %1 verkleinert wurde, muss einmal stromlos gewesen sein, bevor sein Motor angesteuert werden darf</translation>
    </message>
    <message>
        <source>leave &apos;store&apos; out: its settings are lost with its power</source>
        <translation>&apos;store&apos; weglassen: seine Einstellungen gehen mit seiner Stromversorgung verloren</translation>
    </message>
    <message>
        <source>leave it out of the file, or the self-test out of the recipe</source>
        <translation>aus der Datei weglassen, oder den Selbsttest aus dem Rezept nehmen</translation>
    </message>
    <message>
        <source>no link is open on which such units may be</source>
        <translation>keine Verbindung ist offen, an der solche Geräte sein können</translation>
    </message>
    <message>
        <source>no unit has failed that is still there</source>
        <translation>kein Gerät ist gescheitert, das noch da ist</translation>
    </message>
    <message>
        <source>open it first</source>
        <translation>sie zuerst öffnen</translation>
    </message>
    <message>
        <source>the search ends here, because firmware is written or units are served; what it found stays</source>
        <translation>die Suche endet hier, weil Firmware geschrieben wird oder Geräte bedient werden; was sie gefunden hat, bleibt</translation>
    </message>
    <message>
        <source>Abstract DC Drives so old that they answer no broadcast (dialect LL) are found at this bit rate only by their number, or by %1</source>
        <translation>Abstract DC Drives, die so alt sind, dass sie auf keinen Rundruf antworten (Dialekt LL), werden bei dieser Bitrate nur mit ihrer Nummer gefunden, oder mit %1</translation>
    </message>
    <message>
        <source>interrupted before it was done</source>
        <translation>abgebrochen, bevor es fertig war</translation>
    </message>
    <message>
        <source>run it again to finish</source>
        <translation>zum Fertigstellen noch einmal ausführen</translation>
    </message>
    <message>
        <source>the last run of %1 was begun by another program, which still runs</source>
        <translation>der letzte Durchlauf von %1 wurde von einem anderen Programm begonnen, das noch läuft</translation>
    </message>
    <message>
        <source>a drive of dialect LL hears its stop, too, and would be started by it</source>
        <translation>ein Antrieb mit Dialekt LL hört seinen Stopp auch und würde davon gestartet</translation>
    </message>
    <message>
        <source>coarse</source>
        <translation>grob</translation>
    </message>
    <message>
        <source>current limit</source>
        <translation>Stromgrenze</translation>
    </message>
    <message>
        <source>derivative noise</source>
        <translation>Rauschen des D-Anteils</translation>
    </message>
    <message>
        <source>did not move</source>
        <translation>bewegte sich nicht</translation>
    </message>
    <message>
        <source>do it once more if it is the same</source>
        <translation>noch einmal, wenn es dasselbe ist</translation>
    </message>
    <message>
        <source>largest error</source>
        <translation>größte Abweichung</translation>
    </message>
    <message>
        <source>limit switch</source>
        <translation>Endschalter</translation>
    </message>
    <message>
        <source>margin</source>
        <translation>Reserve</translation>
    </message>
    <message>
        <source>not symmetric</source>
        <translation>nicht symmetrisch</translation>
    </message>
    <message>
        <source>ramp</source>
        <translation>Rampe</translation>
    </message>
    <message>
        <source>restart needed</source>
        <translation>Neustart nötig</translation>
    </message>
    <message>
        <source>samples lost</source>
        <translation>Messwerte fehlen</translation>
    </message>
    <message>
        <source>saturated</source>
        <translation>gesättigt</translation>
    </message>
    <message>
        <source>stop not confirmed</source>
        <translation>Stopp nicht bestätigt</translation>
    </message>
    <message>
        <source>stopped before its motor turned</source>
        <translation>angehalten, bevor sein Motor drehte</translation>
    </message>
    <message>
        <source>the unit tells no current in ampere: the duty limit stands in for %1 A</source>
        <translation>das Gerät nennt keinen Strom in Ampere: die Tastgradgrenze steht für %1 A ein</translation>
    </message>
    <message>
        <source>this place, not this unit: what is kept may be of another</source>
        <translation>dieser Platz, nicht dieses Gerät: Das Aufbewahrte kann von einem anderen sein</translation>
    </message>
    <message>
        <source>%1 answers, and a programmer would not tell them apart: take all others off the line</source>
        <translation>%1 antwortet, und ein Programmiergerät könnte sie nicht unterscheiden: alle anderen von der Leitung nehmen</translation>
    </message>
    <message>
        <source>P, I and D are divided by it. Blank flash holds 0, with which no loop works; 0 is never written. A negative divisor keeps the integral across modes: to reverse the loop, change the signs of P, I and D.</source>
        <translation>P, I und D werden durch ihn geteilt. Leerer Flash enthält 0, damit arbeitet kein Regler; 0 wird nie geschrieben. Ein negativer Divisor behält das Integral über Betriebsarten hinweg: Um den Regler umzukehren, die Vorzeichen von P, I und D ändern.</translation>
    </message>
    <message>
        <source>Samples of 20 ms in a mean of the current, which reads wrong until so many were taken: it is changed at a standstill. Once lowered, the drive must lose its power for a moment before it is driven.</source>
        <translation>Werte zu je 20 ms in einem Mittelwert des Stroms, der falsch ist, bis so viele genommen wurden: Geändert wird bei stehendem Motor. Nach dem Verringern muss die Versorgung des Antriebs kurz getrennt werden, bevor er angesteuert wird.</translation>
    </message>
    <message>
        <source>%1 cannot blink</source>
        <translation>%1 kann nicht blinken</translation>
    </message>
    <message>
        <source>%1 has no name</source>
        <translation>%1 hat keinen Namen</translation>
    </message>
    <message>
        <source>choose a free one</source>
        <translation>eine freie wählen</translation>
    </message>
    <message>
        <source>lower them, or raise the divisor</source>
        <translation>sie verkleinern oder den Divisor vergrößern</translation>
    </message>
    <message>
        <source>no device of %1 can have the fault &apos;%2&apos;</source>
        <translation>kein Gerät an %1 kann den Fehler &apos;%2&apos; haben</translation>
    </message>
    <message>
        <source>p and d are so high for the divisor that an error of 1 turns the output to full reverse</source>
        <translation>p und d sind für den Divisor so groß, dass eine Abweichung von 1 den Ausgang auf voll rückwärts umschlagen lässt</translation>
    </message>
    <message>
        <source>the motor is so far from its target that with this value the output would turn to full reverse</source>
        <translation>der Motor ist so weit von seinem Ziel entfernt, dass mit diesem Wert der Ausgang auf voll rückwärts umschlüge</translation>
    </message>
    <message>
        <source>until it has averaged once it reads a wrong current</source>
        <translation>bis er einmal gemittelt hat, liest er einen falschen Strom</translation>
    </message>
    <message>
        <source>give --velocity, or write a lower profile.velocity</source>
        <translation>--velocity angeben oder eine kleinere profile.velocity schreiben</translation>
    </message>
    <message>
        <source>somebody searches here already</source>
        <translation>hier sucht schon jemand</translation>
    </message>
    <message>
        <source>%1 no longer goes back by itself: the unit was gone or has restarted</source>
        <translation>%1 geht nicht mehr von selbst zurück: Das Gerät war weg oder ist neu gestartet</translation>
    </message>
    <message>
        <source>at most %1 counts/s with its P</source>
        <translation>höchstens %1 counts/s mit diesem P</translation>
    </message>
    <message>
        <source>its adapter has another name now; what was found under this one is not in the list any more</source>
        <translation>sein Adapter hat jetzt einen anderen Namen; was unter diesem gefunden wurde, steht nicht mehr in der Liste</translation>
    </message>
    <message>
        <source>node %1 is on this line, too: it hears what the bootloader is told, and may be the one that is written</source>
        <translation>auch Knoten %1 ist an dieser Leitung: er hört, was dem Bootloader gesagt wird, und vielleicht wird er beschrieben</translation>
    </message>
    <message>
        <source>take all others off the line and scan it, or use a programmer on the pins</source>
        <translation>alle anderen von der Leitung nehmen und dort suchen, oder ein Programmiergerät an den Stiften nehmen</translation>
    </message>
    <message>
        <source>%1 cannot be told to brake or to coast</source>
        <translation>%1 lässt sich nicht sagen, ob es bremst oder ausläuft</translation>
    </message>
    <message>
        <source>%1 cannot exchange directions</source>
        <translation>%1 kann Richtungen nicht tauschen</translation>
    </message>
    <message>
        <source>%1 has no limit override</source>
        <translation>%1 kann Grenzen nicht übergehen</translation>
    </message>
    <message>
        <source>%1 has no ramp of the output in mode &apos;%2&apos;</source>
        <translation>%1 hat in der Betriebsart &apos;%2&apos; keine Rampe des Ausgangs</translation>
    </message>
    <message>
        <source>docs/bench.md has the options of each family, and what they take</source>
        <translation>docs/bench.md hat die Optionen jeder Familie und ihre Werte</translation>
    </message>
    <message>
        <source>it is being recorded or replayed</source>
        <translation>sie wird gerade aufgenommen oder abgespielt</translation>
    </message>
    <message>
        <source>name a notebook that can be written</source>
        <translation>ein Versuchsbuch nennen, das sich schreiben lässt</translation>
    </message>
    <message>
        <source>option &apos;%1&apos; is there twice</source>
        <translation>die Option &apos;%1&apos; steht zweimal da</translation>
    </message>
    <message>
        <source>seed and bitrate are whole numbers, loss is a fraction below 1</source>
        <translation>seed und bitrate sind ganze Zahlen, loss ist ein Anteil unter 1</translation>
    </message>
    <message>
        <source>the file is for family &apos;%1&apos;, the device is of &apos;%2&apos;</source>
        <translation>die Datei ist für die Familie „%1“, das Gerät ist von „%2“</translation>
    </message>
    <message>
        <source>the rest of its disk is left to others</source>
        <translation>der Rest der Festplatte bleibt anderen überlassen</translation>
    </message>
    <message>
        <source>%1 keeps no setting without power</source>
        <translation>%1 behält ohne Strom keine Einstellung</translation>
    </message>
    <message>
        <source>cut its power and try again after 10 minutes, or look at it and say in the window that it stands</source>
        <translation>Strom abschalten und nach 10 Minuten erneut versuchen, oder nachsehen und im Fenster bestätigen, dass er steht</translation>
    </message>
    <message>
        <source>the motor did not move when it was sent %1 counts up (%2 counts): stalled, or the encoder is dead</source>
        <translation>der Motor bewegte sich nicht, als er %1 counts aufwärts geschickt wurde (%2 counts): blockiert, oder der Encoder ist tot</translation>
    </message>
    <message>
        <source>see that motor and load are those of the recipe and that its time is enough, then test again</source>
        <translation>prüfen, ob Motor und Last die des Rezepts sind und ob seine Zeit reicht, dann erneut prüfen</translation>
    </message>
    <message>
        <source>%1 is %2 of its smallest steps, fewer than %3: one of them is %4</source>
        <translation>%1 ist %2 seiner kleinsten Schritte, weniger als %3: einer davon ist %4</translation>
    </message>
    <message>
        <source>allow more current or aim for a calmer loop</source>
        <translation>mehr Strom erlauben oder einen ruhigeren Regler anstreben</translation>
    </message>
    <message>
        <source>any step of these gains draws more than the %1 A that are allowed</source>
        <translation>jeder Sprung mit diesen Verstärkungen zieht mehr als die erlaubten %1 A</translation>
    </message>
    <message>
        <source>at most %1 duty and %2 counts from where it stands, at a speed that nobody knows yet</source>
        <translation>höchstens %1 Tastgrad und %2 counts von der jetzigen Stelle, mit einer Drehzahl, die noch niemand kennt</translation>
    </message>
    <message>
        <source>first its direction is checked: pushes of 0.3 s, until it turns</source>
        <translation>zuerst wird seine Richtung geprüft: Stöße von 0,3 s, bis er dreht</translation>
    </message>
    <message>
        <source>no gains as the device stores them keep a largest sensitivity of %1 in this loop</source>
        <translation>keine Verstärkungen, wie das Gerät sie speichert, halten in diesem Kreis eine größte Empfindlichkeit von %1</translation>
    </message>
    <message>
        <source>left out before it was done</source>
        <translation>ausgelassen, bevor es fertig war</translation>
    </message>
    <message>
        <source>load 9 × rotor inertia · 4096 counts a turn</source>
        <translation>Last 9 × Rotorträgheit · 4096 Schritte je Umdrehung</translation>
    </message>
    <message>
        <source>4096 counts a turn</source>
        <translation>4096 Schritte je Umdrehung</translation>
    </message>
    <message>
        <source>reset it without the jumper of its bootloader</source>
        <translation>setzen Sie es ohne die Brücke seines Bootloaders zurück</translation>
    </message>
    <message>
        <source>N20 geared</source>
        <translation>N20 mit Getriebe</translation>
    </message>
    <message>
        <source>gear 75.81:1 · 32768 counts a turn</source>
        <translation>Getriebe 75,81:1 · 32768 Schritte je Umdrehung</translation>
    </message>
    <message>
        <source>%1; update it</source>
        <translation>%1; aktualisieren Sie es</translation>
    </message>
    <message>
        <source>%1; update it, or %2</source>
        <translation>%1; aktualisieren Sie es, oder %2</translation>
    </message>
    <message>
        <source>nothing answers: no power, wrong wiring, another rate, or no program that runs</source>
        <translation>nichts antwortet: kein Strom, falsche Verdrahtung, eine andere Rate oder kein lauffähiges Programm</translation>
    </message>
    <message>
        <source>stored, and the unit has proved it</source>
        <translation>gespeichert, und das Gerät hat es nachgewiesen</translation>
    </message>
    <message>
        <source>the device did not write its flash within %1 s</source>
        <translation>das Gerät hat seinen Flash nicht innerhalb von %1 s geschrieben</translation>
    </message>
    <message>
        <source>%1 is busy: %2</source>
        <translation>%1 ist beschäftigt: %2</translation>
    </message>
    <message>
        <source>%1 is driven already</source>
        <translation>%1 wird bereits angesteuert</translation>
    </message>
    <message>
        <source>%1 is not armed</source>
        <translation>%1 ist nicht scharf</translation>
    </message>
    <message>
        <source>%1 keeps its last set-point for ever: it has no watchdog</source>
        <translation>%1 behält seinen letzten Sollwert für immer: es hat keinen Watchdog</translation>
    </message>
    <message>
        <source>assign one a new number first</source>
        <translation>zuerst einem eine neue Nummer zuweisen</translation>
    </message>
    <message>
        <source>drive it from the Tune page</source>
        <translation>auf der Seite Regler ansteuern</translation>
    </message>
    <message>
        <source>halt it first</source>
        <translation>zuerst anhalten</translation>
    </message>
    <message>
        <source>no %1 is known on this link, so STOP could not reach it</source>
        <translation>an dieser Verbindung ist kein %1 bekannt, STOP könnte es nicht erreichen</translation>
    </message>
    <message>
        <source>no open CAN link is shown</source>
        <translation>keine offene CAN-Verbindung wird angezeigt</translation>
    </message>
    <message>
        <source>open one first</source>
        <translation>zuerst eine öffnen</translation>
    </message>
    <message>
        <source>scan first</source>
        <translation>zuerst suchen</translation>
    </message>
    <message>
        <source>select it, then hold Arm in the header</source>
        <translation>Gerät wählen, dann die Scharf-Taste in der Kopfzeile halten</translation>
    </message>
    <message>
        <source>they were proven by %1 steps instead of %2</source>
        <translation>%1 Sprünge statt %2 haben sie nachgewiesen</translation>
    </message>
    <message>
        <source>two units answer as %1</source>
        <translation>zwei Geräte antworten als %1</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>is told no more to stop after 10 minutes: the motor may still turn, cut its power</source>
        <translation>bekommt nach 10 Minuten keinen Stopp mehr: der Motor läuft vielleicht noch, Strom abschalten</translation>
    </message>
    <message>
        <source>no time was left to do the same again</source>
        <translation>um dasselbe noch einmal zu tun, blieb keine Zeit</translation>
    </message>
    <message>
        <source>%1: %2 → %3</source>
        <translation>%1: %2 → %3</translation>
    </message>
    <message>
        <source>%1: ? → %2</source>
        <translation>%1: ? → %2</translation>
    </message>
    <message>
        <source>allow all of it within little travel, or tune it by hand with &apos;motorbenchctl step&apos;</source>
        <translation>bei wenig Weg alles davon erlauben oder von Hand mit &apos;motorbenchctl step&apos; einstellen</translation>
    </message>
    <message>
        <source>allow more duty or aim for a calmer loop</source>
        <translation>mehr Tastgrad erlauben oder einen ruhigeren Regler anstreben</translation>
    </message>
    <message>
        <source>it may rest %1 short of its target, which its allowable error lets it</source>
        <translation>er kann %1 vor seinem Ziel stehen bleiben, so viel lässt sein zulässiger Fehler zu</translation>
    </message>
    <message>
        <source>nothing of its own keeps a position loop of %1 to %2 duty</source>
        <translation>nichts Eigenes hält einen Lageregler von %1 auf %2 Tastgrad</translation>
    </message>
    <message>
        <source>others that may leave less error were given up: %1</source>
        <translation>andere, die vielleicht weniger Fehler lassen, wurden aufgegeben: %1</translation>
    </message>
    <message>
        <source>take a larger response</source>
        <translation>eine längere Antwortzeit nehmen</translation>
    </message>
    <message>
        <source>the smallest step that proves these gains puts out %1 duty, %2 are allowed, and the unit has no limit of its own that keeps it to them</source>
        <translation>der kleinste Sprung, der diese Verstärkungen belegt, gibt %1 Tastgrad aus, erlaubt sind %2, und das Gerät hat keine eigene Grenze, die es darauf hält</translation>
    </message>
    <message>
        <source>the smallest step that proves these gains takes %1 counts of travel, %2 are allowed</source>
        <translation>der kleinste Sprung, der diese Verstärkungen belegt, braucht %1 counts Weg, erlaubt sind %2</translation>
    </message>
    <message>
        <source>these are given up: %1</source>
        <translation>diese werden aufgegeben: %1</translation>
    </message>
    <message>
        <source>these gains would overshoot by %1, and at most %2 are kept</source>
        <translation>diese Verstärkungen schwängen um %1 über, behalten wird höchstens %2</translation>
    </message>
    <message>
        <source>they would put out more duty than is allowed</source>
        <translation>sie gäben mehr Tastgrad aus als erlaubt</translation>
    </message>
    <message>
        <source>whether gains of an experiment are still to be put back is not known yet: %1</source>
        <translation>ob Verstärkungen eines Versuchs noch zurückzuschreiben sind, ist noch nicht bekannt: %1</translation>
    </message>
</context>
</TS>
