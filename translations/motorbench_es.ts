<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es" sourcelanguage="en">
<context>
    <name>AnalysisText</name>
    <message>
        <source>%1: peak %2 at %3 Hz</source>
        <translation>%1: pico %2 a %3 Hz</translation>
    </message>
    <message>
        <source>%1: fewer than 16 samples connect</source>
        <translation>%1: menos de 16 muestras contiguas</translation>
    </message>
    <message>
        <source>the longest stretch without a gap</source>
        <translation>el tramo más largo sin huecos</translation>
    </message>
    <message>
        <source>%1 against %2</source>
        <translation>%1 frente a %2</translation>
    </message>
    <message>
        <source>%1 points, every %2. sample</source>
        <translation>%1 puntos, 1 de cada %2 muestras</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 puntos</translation>
    </message>
    <message>
        <source>%1: peak –</source>
        <translation>%1: pico –</translation>
    </message>
</context>
<context>
    <name>AxisParameters</name>
    <message>
        <source>axis %1</source>
        <translation>eje %1</translation>
    </message>
</context>
<context>
    <name>AxisText</name>
    <message>
        <source>Axis %1</source>
        <translation>Eje %1</translation>
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
        <translation>Identificar (parpadeo)</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>Renombrar…</translation>
    </message>
    <message>
        <source>Assign another number…</source>
        <translation>Asignar otro número…</translation>
    </message>
    <message>
        <source>Read and clear faults</source>
        <translation>Leer y borrar fallos</translation>
    </message>
    <message>
        <source>faults read and cleared</source>
        <translation>fallos leídos y borrados</translation>
    </message>
    <message>
        <source>Stop and count from 0</source>
        <translation>Parar y contar desde 0</translation>
    </message>
    <message>
        <source>position 0 is here; the motor is off</source>
        <translation>la posición 0 está aquí; el motor está apagado</translation>
    </message>
    <message>
        <source>Copy %1</source>
        <translation>Copiar %1</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation>Renombrar %1</translation>
    </message>
    <message>
        <source>Name, 1 … 64 characters (some tools show only 28):</source>
        <translation>Nombre, 1 … 64 caracteres (algunas herramientas solo muestran 28):</translation>
    </message>
    <message>
        <source>renamed to %1</source>
        <translation>renombrado como %1</translation>
    </message>
    <message>
        <source>Number of %1</source>
        <translation>Número de %1</translation>
    </message>
    <message>
        <source>New number, 1 … %1. %2 is the next free one on this link:</source>
        <translation>Número nuevo, 1 … %1. %2 es el siguiente libre en este enlace:</translation>
    </message>
    <message>
        <source>number %1 is taken on this link; nothing was sent</source>
        <translation>el número %1 ya está en uso en este enlace; no se envió nada</translation>
    </message>
    <message>
        <source>answers as number %1 now</source>
        <translation>ahora responde con el número %1</translation>
    </message>
    <message>
        <source>%1 cannot be opened: a link address has no place for the question mark in it. Rename it.</source>
        <translation>No se puede abrir %1: la dirección de un enlace no admite el signo de interrogación que contiene. Renómbrelo.</translation>
    </message>
    <message>
        <source>blinks</source>
        <translation>parpadea</translation>
    </message>
</context>
<context>
    <name>DeviceText</name>
    <message>
        <source>%1 of %2 axes move</source>
        <translation>%1 de %2 ejes en movimiento</translation>
    </message>
    <message>
        <source>%1 axes</source>
        <translation>%1 ejes</translation>
    </message>
    <message>
        <source>No answer: %1</source>
        <translation>Sin respuesta: %1</translation>
    </message>
    <message>
        <source>The device refused: %1</source>
        <translation>El dispositivo lo rechazó: %1</translation>
    </message>
    <message>
        <source>Unexpected answer: %1</source>
        <translation>Respuesta inesperada: %1</translation>
    </message>
    <message>
        <source>Differs: %1</source>
        <translation>Difiere: %1</translation>
    </message>
    <message>
        <source>Link lost: %1</source>
        <translation>Enlace perdido: %1</translation>
    </message>
    <message>
        <source>Not possible: %1</source>
        <translation>No es posible: %1</translation>
    </message>
    <message>
        <source>Cancelled</source>
        <translation>Cancelado</translation>
    </message>
    <message>
        <source>Not done: %1</source>
        <translation>No realizado: %1</translation>
    </message>
    <message>
        <source>axis %1: %2</source>
        <translation>eje %1: %2</translation>
    </message>
    <message>
        <source>off</source>
        <translation>apagado</translation>
    </message>
    <message>
        <source>duty</source>
        <translation>ciclo de trabajo</translation>
    </message>
    <message>
        <source>velocity</source>
        <translation>velocidad</translation>
    </message>
    <message>
        <source>position</source>
        <translation>posición</translation>
    </message>
    <message>
        <source>current</source>
        <translation>corriente</translation>
    </message>
    <message>
        <source>voltage</source>
        <translation>tensión</translation>
    </message>
    <message>
        <source>follow</source>
        <translation>seguimiento</translation>
    </message>
    <message>
        <source>profiled position</source>
        <translation>posición con perfil</translation>
    </message>
    <message>
        <source>profiled velocity</source>
        <translation>velocidad con perfil</translation>
    </message>
    <message>
        <source>busy</source>
        <translation>ocupado</translation>
    </message>
    <message>
        <source>two units, one number</source>
        <translation>dos equipos, un número</translation>
    </message>
    <message>
        <source>no number yet</source>
        <translation>aún sin número</translation>
    </message>
    <message>
        <source>bootloader, needs firmware</source>
        <translation>bootloader, falta firmware</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>sin respuesta</translation>
    </message>
    <message>
        <source>online</source>
        <translation>en línea</translation>
    </message>
    <message>
        <source>keeps a move</source>
        <translation>retiene un movimiento</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>on</source>
        <translation>encendido</translation>
    </message>
    <message>
        <source>boot</source>
        <translation>boot</translation>
    </message>
    <message>
        <source>2 ×</source>
        <translation>2 ×</translation>
    </message>
    <message>
        <source>Serial number %1</source>
        <translation>Número de serie %1</translation>
    </message>
    <message>
        <source>Dialect %1</source>
        <translation>Dialecto %1</translation>
    </message>
    <message>
        <source>It keeps a move that was stopped before it began, and would begin it with the next start on its line. A new move replaces it; switching the unit off clears it.</source>
        <translation>Retiene un movimiento que se detuvo antes de empezar y lo iniciaría con el próximo arranque en su línea. Un movimiento nuevo lo sustituye; apagar el equipo lo borra.</translation>
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
        <translation>sin fallos</translation>
    </message>
</context>
<context>
    <name>DialogText</name>
    <message>
        <source>Signals that a formula may use</source>
        <translation>Señales que puede usar una fórmula</translation>
    </message>
    <message>
        <source>Double click puts the name into the formula</source>
        <translation>El doble clic inserta el nombre en la fórmula</translation>
    </message>
    <message>
        <source>Note at this time</source>
        <translation>Nota en este instante</translation>
    </message>
    <message>
        <source>What happened</source>
        <translation>Qué ocurrió</translation>
    </message>
    <message>
        <source>Add note</source>
        <translation>Añadir nota</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Guardar</translation>
    </message>
    <message>
        <source>Derived signal</source>
        <translation>Señal derivada</translation>
    </message>
    <message>
        <source>counts/s², A, …</source>
        <translation>counts/s², A, …</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unidad</translation>
    </message>
    <message>
        <source>Formula</source>
        <translation>Fórmula</translation>
    </message>
    <message>
        <source>+ − * / ^ ( ) · derivative(x) · integral(x) · average(x, seconds) · abs, sqrt, sin, min, max … · values are in the unit of the device</source>
        <translation>+ − * / ^ ( ) · derivative(x) · integral(x) · average(x, segundos) · abs, sqrt, sin, min, max … · los valores están en la unidad del dispositivo</translation>
    </message>
    <message>
        <source>Add signal</source>
        <translation>Añadir señal</translation>
    </message>
    <message>
        <source>Export samples</source>
        <translation>Exportar muestras</translation>
    </message>
    <message>
        <source>Stretch</source>
        <translation>Tramo</translation>
    </message>
    <message>
        <source>What is seen</source>
        <translation>Lo visible</translation>
    </message>
    <message>
        <source>A … B</source>
        <translation>A … B</translation>
    </message>
    <message>
        <source>Whole session</source>
        <translation>Toda la sesión</translation>
    </message>
    <message>
        <source>Show the cursors first: L</source>
        <translation>Muestre antes los cursores: L</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>Señales</translation>
    </message>
    <message>
        <source>Plotted signals</source>
        <translation>Señales representadas</translation>
    </message>
    <message>
        <source>All signals of all devices</source>
        <translation>Todas las señales de todos los dispositivos</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>CSV table</source>
        <translation>Tabla CSV</translation>
    </message>
    <message>
        <source>MCAP recording</source>
        <translation>Grabación MCAP</translation>
    </message>
    <message>
        <source>Both carry units, the devices with their parameters, notes, and how many samples were lost. MCAP opens in PlotJuggler and Foxglove.</source>
        <translation>Ambos incluyen unidades, los dispositivos con sus parámetros, notas y cuántas muestras se perdieron. MCAP se abre en PlotJuggler y Foxglove.</translation>
    </message>
    <message>
        <source>Choose file…</source>
        <translation>Elegir archivo…</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tabla (*.csv)</translation>
    </message>
    <message>
        <source>MCAP recording (*.mcap)</source>
        <translation>Grabación MCAP (*.mcap)</translation>
    </message>
</context>
<context>
    <name>FileText</name>
    <message>
        <source>family “%1”</source>
        <translation>familia «%1»</translation>
    </message>
    <message>
        <source>Parameter files (*.json)</source>
        <translation>Archivos de parámetros (*.json)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Choose another file.</source>
        <translation>Elija otro archivo.</translation>
    </message>
    <message>
        <source>Choose a file of this family. Nothing was changed.</source>
        <translation>Elija un archivo de esta familia. No se cambió nada.</translation>
    </message>
    <message>
        <source>Nothing was changed.</source>
        <translation>No se cambió nada.</translation>
    </message>
    <message>
        <source>%1 is not a parameter file.</source>
        <translation>%1 no es un archivo de parámetros.</translation>
    </message>
    <message>
        <source>Choose a file that Export… or motorbenchctl get --file wrote.</source>
        <translation>Elija un archivo escrito por Exportar… o por motorbenchctl get --file.</translation>
    </message>
    <message>
        <source>%1 is for %2, which is not in this program.</source>
        <translation>%1 es para %2, que este programa no conoce.</translation>
    </message>
    <message>
        <source>%1 is for %2, %3 is of the family %4.</source>
        <translation>%1 es para %2, %3 es de la familia %4.</translation>
    </message>
</context>
<context>
    <name>FrameFilterParser</name>
    <message>
        <source>&apos;)&apos; has no &apos;(&apos; before it</source>
        <translation>falta «(» antes de «)»</translation>
    </message>
    <message>
        <source>&apos;%1&apos; needs a term before it</source>
        <translation>«%1» necesita un término delante</translation>
    </message>
    <message>
        <source>a term is missing after &apos;%1&apos;</source>
        <translation>falta un término después de «%1»</translation>
    </message>
    <message>
        <source>&apos;(&apos; is not closed: a &apos;)&apos; is missing</source>
        <translation>«(» sin cerrar: falta «)»</translation>
    </message>
    <message>
        <source>more than %1 brackets and negations inside each other</source>
        <translation>más de %1 paréntesis y negaciones unos dentro de otros</translation>
    </message>
</context>
<context>
    <name>FrameTermReader</name>
    <message>
        <source>&apos;%1&apos;: a comparison begins with field., such as field.%1</source>
        <translation>«%1»: una comparación empieza por field., por ejemplo field.%1</translation>
    </message>
    <message>
        <source>&apos;%1:&apos; has nothing after the colon</source>
        <translation>«%1:» no tiene nada tras los dos puntos</translation>
    </message>
    <message>
        <source>&apos;%1:&apos; is not known; id, family, message, device, dir, data, is and field. are</source>
        <translation>«%1:» no se conoce; sí id, family, message, device, dir, data, is y field.</translation>
    </message>
    <message>
        <source>&apos;%1:&apos; is not known; &apos;%2:&apos; is</source>
        <translation>«%1:» no se conoce; sí «%2:»</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no identifier: hexadecimal such as 0x2061405, 0x2061* or 100..1FF</source>
        <translation>«%1» no es un identificador: hexadecimal, como 0x2061405, 0x2061* o 100..1FF</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no device number: such as 5, 5,7 or 1..9</source>
        <translation>«%1» no es un número de dispositivo: como 5, 5,7 o 1..9</translation>
    </message>
    <message>
        <source>&apos;%1&apos; are no bytes: hexadecimal such as A125*, without blanks</source>
        <translation>«%1» no son bytes: hexadecimal, como A125*, sin espacios</translation>
    </message>
    <message>
        <source>no family is called &apos;%1&apos;; there is %2</source>
        <translation>ninguna familia se llama «%1»; existe %2</translation>
    </message>
    <message>
        <source>&apos;dir:%1&apos; is not known; dir:rx and dir:tx are</source>
        <translation>«dir:%1» no se conoce; sí dir:rx y dir:tx</translation>
    </message>
    <message>
        <source>&apos;is:%1&apos; is not known; tx, rx, extended, standard, remote, error, unknown, known and control are</source>
        <translation>«is:%1» no se conoce; sí tx, rx, extended, standard, remote, error, unknown, known y control</translation>
    </message>
    <message>
        <source>&apos;field.&apos; needs the name of a field, such as field.trgt&gt;100</source>
        <translation>«field.» necesita el nombre de un campo, por ejemplo field.trgt&gt;100</translation>
    </message>
    <message>
        <source>&apos;field.%1%2&apos; needs a number behind it</source>
        <translation>«field.%1%2» necesita un número detrás</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no number</source>
        <translation>«%1» no es un número</translation>
    </message>
    <message>
        <source>identifier, hexadecimal</source>
        <translation>identificador, hexadecimal</translation>
    </message>
    <message>
        <source>what the decoder says</source>
        <translation>lo que dice el decodificador</translation>
    </message>
    <message>
        <source>a field by its name: its number, % of full scale, or that there is one</source>
        <translation>un campo por su nombre: su número, % del fondo de escala o que exista</translation>
    </message>
    <message>
        <source>bytes, hexadecimal</source>
        <translation>bytes, hexadecimal</translation>
    </message>
    <message>
        <source>direction; error, remote, extended, standard, unknown, known; makes a motor move</source>
        <translation>dirección; error, remote, extended, standard, unknown, known; mueve un motor</translation>
    </message>
    <message>
        <source>a bare word: part of a message, family or identifier</source>
        <translation>una palabra suelta: parte de un mensaje, familia o identificador</translation>
    </message>
    <message>
        <source>terms beside each other must all hold</source>
        <translation>los términos seguidos deben cumplirse todos</translation>
    </message>
    <message>
        <source>* stands for any characters, ? for one, a comma for or.</source>
        <translation>* equivale a cualquier secuencia, ? a un carácter, una coma a «o».</translation>
    </message>
</context>
<context>
    <name>FrameText</name>
    <message>
        <source>remote</source>
        <translation>remota</translation>
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
        <source>throttle × divisor per %1</source>
        <translation>throttle × divisor por %1</translation>
    </message>
    <message>
        <source>throttle per %1</source>
        <translation>throttle por %1</translation>
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
        <translation>hueco %1</translation>
    </message>
    <message>
        <source>%1 gaps, %2</source>
        <translation>%1 huecos, %2</translation>
    </message>
</context>
<context>
    <name>HelpTitles</name>
    <message>
        <source>First hour</source>
        <translation>La primera hora</translation>
    </message>
    <message>
        <source>Connecting</source>
        <translation>Conexión</translation>
    </message>
    <message>
        <source>Tuning by itself</source>
        <translation>Ajuste automático</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Gráficas</translation>
    </message>
    <message>
        <source>Service</source>
        <translation>Servicio</translation>
    </message>
    <message>
        <source>Recipes</source>
        <translation>Recetas</translation>
    </message>
    <message>
        <source>Safety</source>
        <translation>Seguridad</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Archivos</translation>
    </message>
    <message>
        <source>Troubleshooting</source>
        <translation>Solución de problemas</translation>
    </message>
    <message>
        <source>Hardware: %1</source>
        <translation>Hardware: %1</translation>
    </message>
</context>
<context>
    <name>Languages</name>
    <message>
        <source>English</source>
        <comment>the name of this language in itself</comment>
        <translation>Español</translation>
    </message>
    <message>
        <source>en</source>
        <comment>the code of this language, as in the name of its file</comment>
        <translation>es</translation>
    </message>
</context>
<context>
    <name>LeapText</name>
    <message>
        <source>%1 × as large as now, %2.</source>
        <translation>%1 veces mayor que ahora, %2.</translation>
    </message>
    <message>
        <source>%1 × smaller than now, %2.</source>
        <translation>%1 veces menor que ahora, %2.</translation>
    </message>
</context>
<context>
    <name>LinkChoices</name>
    <message>
        <source>up</source>
        <translation>activo</translation>
    </message>
    <message>
        <source>switched off</source>
        <translation>desactivado</translation>
    </message>
    <message>
        <source>bus-off</source>
        <translation>bus-off</translation>
    </message>
    <message>
        <source>no permission</source>
        <translation>sin permiso</translation>
    </message>
    <message>
        <source>not there</source>
        <translation>no está</translation>
    </message>
    <message>
        <source>ready</source>
        <translation>listo</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>A recording of frames…</source>
        <translation>Una grabación de tramas…</translation>
    </message>
    <message>
        <source>file</source>
        <translation>archivo</translation>
    </message>
    <message>
        <source>Plays a candump or Vector ASC log as if its bus were here. Nothing can be sent.</source>
        <translation>Reproduce un registro candump o Vector ASC como si su bus estuviera aquí. No se puede enviar nada.</translation>
    </message>
    <message>
        <source>The whole simulated bench</source>
        <translation>Todo el banco simulado</translation>
    </message>
    <message>
        <source>Simulated CAN bus</source>
        <translation>Bus CAN simulado</translation>
    </message>
    <message>
        <source>Simulated serial line</source>
        <translation>Línea serie simulada</translation>
    </message>
    <message>
        <source>Simulated SPI board</source>
        <translation>Placa SPI simulada</translation>
    </message>
    <message>
        <source>CAN interfaces</source>
        <translation>Interfaces CAN</translation>
    </message>
    <message>
        <source>Serial ports</source>
        <translation>Puertos serie</translation>
    </message>
    <message>
        <source>SPI devices</source>
        <translation>Dispositivos SPI</translation>
    </message>
    <message>
        <source>Recordings</source>
        <translation>Grabaciones</translation>
    </message>
    <message>
        <source>Without hardware</source>
        <translation>Sin hardware</translation>
    </message>
    <message>
        <source>Serial port</source>
        <translation>Puerto serie</translation>
    </message>
    <message>
        <source>SPI device</source>
        <translation>Dispositivo SPI</translation>
    </message>
    <message>
        <source>CAN interface</source>
        <translation>Interfaz CAN</translation>
    </message>
    <message>
        <source>%1, at the real speed of their link.</source>
        <translation>%1, a la velocidad real de su enlace.</translation>
    </message>
    <message>
        <source>Controllers of every family with real bus timing; nothing real can move.</source>
        <translation>Controladores de todas las familias con tiempos de bus reales; nada real puede moverse.</translation>
    </message>
</context>
<context>
    <name>MuteUnits</name>
    <message>
        <source>Number of the unit that does not answer, %1 … %2. No other one of its family may answer there: a programmer would not tell them apart.</source>
        <translation>Número del equipo que no responde, %1 … %2. Allí no debe responder ningún otro de su familia: un programador no podría distinguirlos.</translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <translation>%1 en %2</translation>
    </message>
    <message>
        <source>No link is open whose units a programmer writes</source>
        <translation>No hay abierto ningún enlace cuyos equipos escriba un programador</translation>
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
        <translation>en vivo, %1</translation>
    </message>
    <message>
        <source>paused, %1</source>
        <translation>en pausa, %1</translation>
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
        <translation>media A…B</translation>
    </message>
    <message>
        <source>min … max</source>
        <translation>mín … máx</translation>
    </message>
    <message>
        <source>%1 … %2</source>
        <translation>%1 … %2</translation>
    </message>
    <message>
        <source>σ, %1 samples</source>
        <translation>σ, %1 muestras</translation>
    </message>
    <message>
        <source>slope</source>
        <translation>pendiente</translation>
    </message>
    <message>
        <source>/s</source>
        <translation>/s</translation>
    </message>
    <message>
        <source>%1 %2 to %3</source>
        <translation>%1 %2 a %3</translation>
    </message>
    <message>
        <source>%1 no data</source>
        <translation>%1 sin datos</translation>
    </message>
    <message>
        <source>, now %1</source>
        <translation>, ahora %1</translation>
    </message>
    <message>
        <source>, 1 gap</source>
        <translation>, 1 hueco</translation>
    </message>
    <message numerus="yes">
        <source>, %n gaps</source>
        <translation>
            <numerusform>, %n hueco</numerusform>
            <numerusform>, %n huecos</numerusform>
        </translation>
    </message>
    <message>
        <source>No traces</source>
        <translation>Sin curvas</translation>
    </message>
    <message>
        <source>Last %1: %2</source>
        <translation>Últimos %1: %2</translation>
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
        <translation>&amp;Deshacer</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rehacer</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>Cor&amp;tar</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Copiar</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>&amp;Pegar</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Eliminar</translation>
    </message>
    <message>
        <source>Select All</source>
        <translation>Seleccionar todo</translation>
    </message>
</context>
<context>
    <name>QPlatformTheme</name>
    <message>
        <source>OK</source>
        <translation>Aceptar</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Ayuda</translation>
    </message>
</context>
<context>
    <name>QShortcut</name>
    <message>
        <source>Ctrl</source>
        <translation>Ctrl</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Mayús</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Espacio</translation>
    </message>
    <message>
        <source>Return</source>
        <translation>Intro</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Intro</translation>
    </message>
</context>
<context>
    <name>SignalText</name>
    <message>
        <source>small</source>
        <extracomment>Translate as &quot;capital&quot; where a noun has a capital letter in the middle of a line too.</extracomment>
        <translation>small</translation>
    </message>
</context>
<context>
    <name>SourceText</name>
    <message>
        <source>%1 Hz, %2 of %3 lost</source>
        <translation>%1 Hz, %2 de %3 perdidas</translation>
    </message>
</context>
<context>
    <name>Stories</name>
    <message>
        <source>Select</source>
        <translation>Seleccionar</translation>
    </message>
    <message>
        <source>Click %1 in the list at the left. Everything that follows is about it.</source>
        <translation>Haga clic en %1 en la lista de la izquierda. Todo lo que sigue trata de él.</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>Armar</translation>
    </message>
    <message>
        <source>Hold the Arm button at the top, SAFE, for one second (or Ctrl+Shift+F12). Nothing moves before. Esc stops, always.</source>
        <translation>Mantenga pulsado un segundo el botón Armar de arriba, SEGURO (o Ctrl+Mayús+F12). Antes no se mueve nada. Esc detiene todo, en cualquier momento.</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Escalón</translation>
    </message>
    <message>
        <source>Tune</source>
        <translation>Ajustar</translation>
    </message>
    <message>
        <source>Store</source>
        <translation>Guardar</translation>
    </message>
    <message>
        <source>Click %1 in the list at the left.</source>
        <translation>Haga clic en %1 en la lista de la izquierda.</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>Limitar</translation>
    </message>
    <message>
        <source>Hold the Arm button at the top for one second (or Ctrl+Shift+F12).</source>
        <translation>Mantenga pulsado un segundo el botón Armar de arriba (o Ctrl+Mayús+F12).</translation>
    </message>
    <message>
        <source>%1 overshoots: tame it in a minute</source>
        <translation>%1 tiene sobreimpulso: dómelo en un minuto</translation>
    </message>
    <message>
        <source>velocity, set-point dashed</source>
        <translation>velocidad, consigna a trazos</translation>
    </message>
    <message>
        <source>%1 has no current limit: set one that saves it</source>
        <translation>%1 no tiene límite de corriente: fije uno que lo salve</translation>
    </message>
    <message>
        <source>current, limit dashed</source>
        <translation>corriente, límite a trazos</translation>
    </message>
    <message>
        <source>Press %2: the motor steps to a speed and back, and the overshoot is measured.</source>
        <translation>Pulse %2: el motor salta a una velocidad y vuelve, y se mide el sobreimpulso.</translation>
    </message>
    <message>
        <source>Press %2 on the page Design: the program finds gains and proves them. Tamed: a step overshoots by 5 % at most.</source>
        <translation>Pulse %2 en la página Diseño: el programa halla ganancias y las verifica. Domado: un escalón tiene como máximo un 5 % de sobreimpulso.</translation>
    </message>
    <message>
        <source>Press %2 on the page Tune: the peak current of the step stands in its table.</source>
        <translation>Pulse %2 en la página Ajuste: la corriente de pico del escalón figura en su tabla.</translation>
    </message>
    <message>
        <source>the button</source>
        <translation>el botón</translation>
    </message>
    <message>
        <source>Arrive</source>
        <translation>Llegar</translation>
    </message>
    <message>
        <source>What P makes of the last counts is less than friction. Enter among the gains %5 (a stiffer P overcomes it, and more D keeps it from swinging), and press %2 again: it rests within 5 counts of its target.</source>
        <translation>Lo que P saca de las últimas cuentas es menos que el rozamiento. Escriba en las ganancias %5 (una P más rígida lo vence, y más D impide que oscile) y pulse otra vez %2: queda a 5 cuentas de su destino como mucho.</translation>
    </message>
    <message>
        <source>%1 stops short: make it arrive</source>
        <translation>%1 se queda corto: hágalo llegar</translation>
    </message>
    <message>
        <source>This one stops about %4 counts short and stays there. Make it arrive.</source>
        <translation>Este se detiene unas %4 cuentas antes y ahí se queda. Hágalo llegar.</translation>
    </message>
    <message>
        <source>position, set-point dashed</source>
        <translation>posición, consigna a trazos</translation>
    </message>
    <message>
        <source>On the page Tune choose Position: what is armed is armed for one mode. Then hold the Arm button at the top for one second (or Ctrl+Shift+F12).</source>
        <translation>En la página Ajuste elija Posición: lo armado lo está para un solo modo. Luego mantenga pulsado un segundo el botón Armar de arriba (o Ctrl+Mayús+F12).</translation>
    </message>
    <message>
        <source>Enter %3 as the target (behind ▸) and press %2: the motor goes there and back, and stops about %4 counts short.</source>
        <translation>Escriba %3 como destino (detrás de ▸) y pulse %2: el motor va y vuelve, y se detiene unas %4 cuentas antes.</translation>
    </message>
    <message>
        <source>%6Press Store and prove on the page Parameters: done when the unit proves that its flash has the gains.</source>
        <translation>%6Pulse «Guardar y verificar» en la página Parámetros: listo cuando el equipo demuestre que su flash tiene las ganancias.</translation>
    </message>
    <message>
        <source>On the page Parameters switch the current limit on (search: %7), set it to what the motor may have, and write.</source>
        <translation>En la página Parámetros active el límite de corriente (buscar: %7), fíjelo en lo que admite el motor y escriba.</translation>
    </message>
    <message>
        <source>%6Press Store and prove on the page Parameters.</source>
        <translation>%6Pulse «Guardar y verificar» en la página Parámetros.</translation>
    </message>
    <message>
        <source>With these gains it goes too far. Find some with which it does not.</source>
        <translation>Con estas ganancias se pasa. Encuentre otras con las que no lo haga.</translation>
    </message>
    <message>
        <source>Stalled, it draws all that its supply gives, and nothing holds it back. Limit it.</source>
        <translation>Bloqueado, consume todo lo que da la alimentación, y nada lo frena. Limítelo.</translation>
    </message>
    <message>
        <source>It stores by itself %1 s after its last change: wait for that.</source>
        <translation>Guarda por sí solo %1 s después de su último cambio: espérelo.</translation>
    </message>
</context>
<context>
    <name>TriggerText</name>
    <message>
        <source>trigger armed, waiting</source>
        <translation>disparo armado, esperando</translation>
    </message>
    <message>
        <source>single event caught</source>
        <translation>evento único capturado</translation>
    </message>
    <message>
        <source>event %1, filling</source>
        <translation>evento %1, llenando</translation>
    </message>
    <message>
        <source>event %1, waiting for the next</source>
        <translation>evento %1, esperando el siguiente</translation>
    </message>
</context>
<context>
    <name>TypedFrameText</name>
    <message>
        <source>&apos;%1&apos; is no frame such as 02061405#8125</source>
        <translation>«%1» no es una trama como 02061405#8125</translation>
    </message>
    <message>
        <source>The identifier is hexadecimal, such as 7FF or 02061405</source>
        <translation>El identificador es hexadecimal, como 7FF o 02061405</translation>
    </message>
    <message>
        <source>%1 has more than 29 bits: at most 1FFFFFFF</source>
        <translation>%1 tiene más de 29 bits: como máximo 1FFFFFFF</translation>
    </message>
    <message>
        <source>%1 has more than 11 bits: choose 29 bits</source>
        <translation>%1 tiene más de 11 bits: elija 29 bits</translation>
    </message>
    <message>
        <source>The data are pairs of hexadecimal digits, such as 81 25 11</source>
        <translation>Los datos son pares de dígitos hexadecimales, como 81 25 11</translation>
    </message>
    <message>
        <source>%1 bytes: a frame has at most 8</source>
        <translation>%1 bytes: una trama tiene 8 como máximo</translation>
    </message>
</context>
<context>
    <name>UnitText</name>
    <message>
        <source>rpm</source>
        <translation>rpm</translation>
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
        <translation>un dispositivo que ya no está</translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <translation>%1 en %2</translation>
    </message>
</context>
<context>
    <name>ValueText</name>
    <message>
        <source>Enter %1.</source>
        <translation>Introduzca %1.</translation>
    </message>
    <message>
        <source>Enter %1, or a percentage such as %2.</source>
        <translation>Introduzca %1 o un porcentaje como %2.</translation>
    </message>
    <message>
        <source>%1 is above %2.</source>
        <translation>%1 es mayor que %2.</translation>
    </message>
    <message>
        <source>%1 is below %2.</source>
        <translation>%1 es menor que %2.</translation>
    </message>
    <message>
        <source>%1 is not a whole number.</source>
        <translation>%1 no es un número entero.</translation>
    </message>
    <message>
        <source>A number is missing.</source>
        <translation>Falta un número.</translation>
    </message>
    <message>
        <source>“%1” is not a number.</source>
        <translation>«%1» no es un número.</translation>
    </message>
    <message>
        <source>on</source>
        <translation>encendido</translation>
    </message>
    <message>
        <source>off</source>
        <translation>apagado</translation>
    </message>
    <message>
        <source>off or on</source>
        <translation>apagado o encendido</translation>
    </message>
</context>
<context>
    <name>drawings</name>
    <message>
        <source>3.3 V only</source>
        <translation>solo 3,3 V</translation>
    </message>
    <message>
        <source>57 600 or 115 200 bit/s</source>
        <translation>57 600 o 115 200 bit/s</translation>
    </message>
    <message>
        <source>60 A, 100 A for 2 s</source>
        <translation>60 A, 100 A durante 2 s</translation>
    </message>
    <message>
        <source>A, B, index</source>
        <translation>A, B, índice</translation>
    </message>
    <message>
        <source>Battery, 12 V</source>
        <translation>Batería, 12 V</translation>
    </message>
    <message>
        <source>Breaker</source>
        <translation>Disyuntor</translation>
    </message>
    <message>
        <source>Bridge and motor</source>
        <translation>Puente y motor</translation>
    </message>
    <message>
        <source>CAN adapter</source>
        <translation>Adaptador CAN</translation>
    </message>
    <message>
        <source>CAN high</source>
        <translation>CAN high</translation>
    </message>
    <message>
        <source>CAN low</source>
        <translation>CAN low</translation>
    </message>
    <message>
        <source>Drive, offset 1</source>
        <translation>Accionamiento, offset 1</translation>
    </message>
    <message>
        <source>Drive, offset 2</source>
        <translation>Accionamiento, offset 2</translation>
    </message>
    <message>
        <source>Encoder board</source>
        <translation>Placa del encoder</translation>
    </message>
    <message>
        <source>GPIO in</source>
        <translation>entrada GPIO</translation>
    </message>
    <message>
        <source>GPIO out</source>
        <translation>salida GPIO</translation>
    </message>
    <message>
        <source>Host</source>
        <translation>Anfitrión</translation>
    </message>
    <message>
        <source>J4 closed only for 3.3 V, before power</source>
        <translation>J4 cerrado solo para 3,3 V, sin tensión</translation>
    </message>
    <message>
        <source>Motor</source>
        <translation>Motor</translation>
    </message>
    <message>
        <source>Motor supply</source>
        <translation>Alimentación del motor</translation>
    </message>
    <message>
        <source>P1 MISO · P2 Vcc · P3 SCK · P4 MOSI · P5 reset · P6 ground</source>
        <translation>P1 MISO · P2 Vcc · P3 SCK · P4 MOSI · P5 reset · P6 masa</translation>
    </message>
    <message>
        <source>PA4 current, PA3 heat</source>
        <translation>PA4 corriente, PA3 calor</translation>
    </message>
    <message>
        <source>Pads for a programmer</source>
        <translation>Pads para un programador</translation>
    </message>
    <message>
        <source>Programmer</source>
        <translation>Programador</translation>
    </message>
    <message>
        <source>STM32F1 or F4</source>
        <translation>STM32F1 o F4</translation>
    </message>
    <message>
        <source>Supermodified, node 4</source>
        <translation>Supermodified, nodo 4</translation>
    </message>
    <message>
        <source>Supermodified, node 5</source>
        <translation>Supermodified, nodo 5</translation>
    </message>
    <message>
        <source>USB to RS-485</source>
        <translation>USB a RS-485</translation>
    </message>
    <message>
        <source>a Raspberry Pi, say</source>
        <translation>p. ej. una Raspberry Pi</translation>
    </message>
    <message>
        <source>and a switch</source>
        <translation>y un interruptor</translation>
    </message>
    <message>
        <source>closed: bootloader</source>
        <translation>cerrado: bootloader</translation>
    </message>
    <message>
        <source>each its own number</source>
        <translation>cada uno su número</translation>
    </message>
    <message>
        <source>each its own offset</source>
        <translation>cada uno su offset</translation>
    </message>
    <message>
        <source>ground</source>
        <translation>masa</translation>
    </message>
    <message>
        <source>ground in common</source>
        <translation>masa común</translation>
    </message>
    <message>
        <source>ground, 3.3 V</source>
        <translation>masa, 3,3 V</translation>
    </message>
    <message>
        <source>motor, 6 A</source>
        <translation>motor, 6 A</translation>
    </message>
    <message>
        <source>number 1 … 63</source>
        <translation>número 1 … 63</translation>
    </message>
    <message>
        <source>on the computer</source>
        <translation>en el ordenador</translation>
    </message>
    <message>
        <source>one host only</source>
        <translation>un solo anfitrión</translation>
    </message>
    <message>
        <source>or a supply that</source>
        <translation>o una fuente que</translation>
    </message>
    <message>
        <source>own driver</source>
        <translation>etapa propia</translation>
    </message>
    <message>
        <source>takes braking</source>
        <translation>absorba el frenado</translation>
    </message>
    <message>
        <source>transceiver at PA11, PA12</source>
        <translation>transceptor en PA11, PA12</translation>
    </message>
    <message>
        <source>up to 35 V</source>
        <translation>hasta 35 V</translation>
    </message>
    <message>
        <source>with encoder</source>
        <translation>con encoder</translation>
    </message>
    <message>
        <source>within reach</source>
        <translation>al alcance</translation>
    </message>
</context>
<context>
    <name>mb::About</name>
    <message>
        <source>About MotorBench</source>
        <translation>Acerca de MotorBench</translation>
    </message>
    <message>
        <source>Tunes and services brushed-DC motor controllers. Free software under the GNU General Public License, version 3 or later, without any warranty.</source>
        <translation>Ajusta y mantiene controladores de motores de CC con escobillas. Software libre bajo la GNU General Public License, versión 3 o posterior, sin garantía alguna.</translation>
    </message>
    <message>
        <source>Versions and licences</source>
        <translation>Versiones y licencias</translation>
    </message>
    <message>
        <source>Copy versions</source>
        <translation>Copiar versiones</translation>
    </message>
</context>
<context>
    <name>mb::AddLinkDialog</name>
    <message>
        <source>Add a link</source>
        <translation>Añadir un enlace</translation>
    </message>
    <message>
        <source>Links that can be added</source>
        <translation>Enlaces que se pueden añadir</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>Enlace</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Estado</translation>
    </message>
    <message>
        <source>open</source>
        <translation>abierto</translation>
    </message>
    <message>
        <source>none found</source>
        <translation>no se encontró ninguno</translation>
    </message>
    <message>
        <source>Command for a terminal</source>
        <translation>Orden para un terminal</translation>
    </message>
    <message>
        <source>Address of the link</source>
        <translation>Dirección del enlace</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Dirección</translation>
    </message>
    <message>
        <source>Open it at every start</source>
        <translation>Abrirlo en cada inicio</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Abrir</translation>
    </message>
    <message>
        <source>Choose the file…</source>
        <translation>Elegir el archivo…</translation>
    </message>
</context>
<context>
    <name>mb::AdvicePanel</name>
    <message>
        <source>Why it did that</source>
        <translation>Por qué hizo eso</translation>
    </message>
    <message>
        <source>Stages these values; nothing is written yet.</source>
        <translation>Deja pendientes estos valores; aún no se escribe nada.</translation>
    </message>
</context>
<context>
    <name>mb::AdviceText</name>
    <message>
        <source>F·K is %1 with I active: the initial lag is paid back as overshoot.</source>
        <translation>F·K es %1 con I activo: el retraso inicial se paga como sobreimpulso.</translation>
    </message>
    <message>
        <source>It stops %1 counts short: P alone does not overcome friction there.</source>
        <translation>Se detiene %1 cuentas antes: P por sí solo no vence ahí la fricción.</translation>
    </message>
    <message>
        <source>A gain has only %1 steps of its integer; it cannot be set finely.</source>
        <translation>Una ganancia tiene solo %1 pasos de su entero; no admite ajuste fino.</translation>
    </message>
    <message>
        <source>One count of the sensor moves the duty by %1 % through D; 10 % is the most that is quiet.</source>
        <translation>Una cuenta del sensor cambia el ciclo un %1 % a través de D; hasta un 10 % es silencioso.</translation>
    </message>
    <message>
        <source>The drive&apos;s ramp takes %1 to full duty, which is slower than this loop.</source>
        <translation>La rampa del controlador tarda %1 hasta el ciclo máximo: es más lenta que este lazo.</translation>
    </message>
    <message>
        <source>The duty was at its limit for %1: the loop cannot go faster there.</source>
        <translation>El ciclo estuvo en su límite durante %1: ahí el lazo no puede ir más rápido.</translation>
    </message>
    <message>
        <source>The duty was at its limit for %1 while I went on; that is paid back as overshoot.</source>
        <translation>El ciclo estuvo en su límite durante %1 mientras I seguía; eso se paga como sobreimpulso.</translation>
    </message>
    <message>
        <source>The measured velocity is %1 late; the gains are too lively for that.</source>
        <translation>La velocidad medida llega %1 tarde; las ganancias son demasiado vivas para eso.</translation>
    </message>
    <message>
        <source>The velocity comes anew every %1 only; a loop cannot be quicker than that.</source>
        <translation>La velocidad solo se renueva cada %1; un lazo no puede ser más rápido.</translation>
    </message>
    <message>
        <source>It moved late, at %1 % duty: friction holds it until then.</source>
        <translation>Se movió tarde, con un ciclo del %1 %: hasta ahí lo retiene la fricción.</translation>
    </message>
    <message>
        <source>It takes %1 % duty to stay in place: a load pulls one way.</source>
        <translation>Necesita un ciclo del %1 % para quedarse en su sitio: una carga tira hacia un lado.</translation>
    </message>
    <message>
        <source>It swings by %1 counts without end: play between motor and load.</source>
        <translation>Oscila %1 cuentas sin fin: holgura entre motor y carga.</translation>
    </message>
    <message>
        <source>Stage %1</source>
        <translation>Dejar pendiente %1</translation>
    </message>
</context>
<context>
    <name>mb::AdviserList</name>
    <message>
        <source>staged</source>
        <translation>pendiente</translation>
    </message>
    <message>
        <source>ok</source>
        <translation>correcto</translation>
    </message>
    <message>
        <source>fixed in the set</source>
        <translation>resuelto en el juego</translation>
    </message>
    <message>
        <source>mind it</source>
        <translation>a tener en cuenta</translation>
    </message>
    <message>
        <source>to fix</source>
        <translation>por resolver</translation>
    </message>
    <message>
        <source>not read</source>
        <translation>no leído</translation>
    </message>
    <message>
        <source>This loop has no F that could fight with I.</source>
        <translation>Este lazo no tiene una F que pueda oponerse a I.</translation>
    </message>
    <message>
        <source>uS/kp = %1: below this error only I moves the shaft.</source>
        <translation>uS/kp = %1: por debajo de este error solo I mueve el eje.</translation>
    </message>
    <message>
        <source>uS/kp = %1: below this error nothing moves the shaft.</source>
        <translation>uS/kp = %1: por debajo de este error nada mueve el eje.</translation>
    </message>
    <message>
        <source>That is over 2 % of the step.</source>
        <translation>Eso supera el 2 % del escalón.</translation>
    </message>
    <message>
        <source>The drive&apos;s least output helps.</source>
        <translation>La salida mínima del controlador ayuda.</translation>
    </message>
    <message>
        <source>No gain of the set is an integer of its own.</source>
        <translation>Ninguna ganancia del juego es un entero propio.</translation>
    </message>
    <message>
        <source>%1 is %2 steps of its integer, at least %3 are wanted: one step is %4 %.</source>
        <translation>%1 tiene %2 pasos de su entero, se quieren al menos %3: un paso es el %4 %.</translation>
    </message>
    <message>
        <source>This drive has no ramp of its own.</source>
        <translation>Este controlador no tiene rampa propia.</translation>
    </message>
    <message>
        <source>The drive&apos;s ramp was not read yet.</source>
        <translation>La rampa del controlador aún no se ha leído.</translation>
    </message>
    <message>
        <source>The drive&apos;s ramp is off.</source>
        <translation>La rampa del controlador está desactivada.</translation>
    </message>
    <message>
        <source>Full duty takes %1, over τc/2 = %2: it acts as lag.</source>
        <translation>El ciclo máximo tarda %1, más que τc/2 = %2: actúa como retardo.</translation>
    </message>
    <message>
        <source>Full duty takes %1, under τc/2 = %2.</source>
        <translation>El ciclo máximo tarda %1, menos que τc/2 = %2.</translation>
    </message>
    <message>
        <source>F–I conflict</source>
        <translation>Conflicto F–I</translation>
    </message>
    <message>
        <source>Deadband</source>
        <translation>Banda muerta</translation>
    </message>
    <message>
        <source>D noise</source>
        <translation>Ruido de D</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Resolución</translation>
    </message>
    <message>
        <source>Ramp</source>
        <translation>Rampa</translation>
    </message>
    <message>
        <source>D is 0: one count moves no duty.</source>
        <translation>D es 0: una cuenta no cambia el ciclo.</translation>
    </message>
    <message>
        <source>One count moves the duty by %1 % through D; %2 % is the most that is quiet.</source>
        <translation>Una cuenta cambia el ciclo un %1 % a través de D; hasta un %2 % es silencioso.</translation>
    </message>
    <message>
        <source>Advisers</source>
        <translation>Asesores</translation>
    </message>
    <message>
        <source>for %1, slot %2</source>
        <translation>para %1, ranura %2</translation>
    </message>
    <message>
        <source>for %1</source>
        <translation>para %1</translation>
    </message>
    <message>
        <source>Take back</source>
        <translation>Retirar</translation>
    </message>
    <message>
        <source>Stages these values; nothing is written yet.</source>
        <translation>Deja pendientes estos valores; aún no se escribe nada.</translation>
    </message>
    <message>
        <source>Stage</source>
        <translation>Dejar pendiente</translation>
    </message>
    <message>
        <source>F and I in force give back %1 of the step as overshoot. The set has no F.</source>
        <translation>F e I vigentes devuelven %1 del escalón como sobreimpulso. El juego no tiene F.</translation>
    </message>
    <message>
        <source>F and I give back %1 of the step as overshoot.</source>
        <translation>F e I devuelven %1 del escalón como sobreimpulso.</translation>
    </message>
    <message>
        <source>F and I give nothing back as overshoot.</source>
        <translation>F e I no devuelven nada como sobreimpulso.</translation>
    </message>
</context>
<context>
    <name>mb::AgainstView</name>
    <message>
        <source>plot written to %1</source>
        <translation>gráfica escrita en %1</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>Copiar imagen</translation>
    </message>
    <message>
        <source>One signal against another</source>
        <translation>Una señal frente a otra</translation>
    </message>
    <message>
        <source>Signal across</source>
        <translation>Señal horizontal</translation>
    </message>
    <message>
        <source>Signal upwards</source>
        <translation>Señal vertical</translation>
    </message>
    <message>
        <source>against</source>
        <translation>frente a</translation>
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
        <translation>lo visible: </translation>
    </message>
</context>
<context>
    <name>mb::Arming</name>
    <message>
        <source>%1: cut its power</source>
        <translation>%1: corte su alimentación</translation>
    </message>
    <message>
        <source>experiment</source>
        <translation>experimento</translation>
    </message>
    <message>
        <source>until it is seen</source>
        <translation>hasta que se vea</translation>
    </message>
    <message>
        <source>nothing to arm</source>
        <translation>nada que armar</translation>
    </message>
    <message>
        <source>arming off while busy</source>
        <translation>no se arma durante una tarea</translation>
    </message>
    <message>
        <source>%1 cannot be armed</source>
        <translation>%1 no se puede armar</translation>
    </message>
    <message>
        <source>not sent to %1</source>
        <translation>no enviado a %1</translation>
    </message>
    <message>
        <source>it is not heard</source>
        <translation>no se recibe nada de él</translation>
    </message>
    <message>
        <source>%1 may still turn</source>
        <translation>%1 podría seguir girando</translation>
    </message>
    <message>
        <source>not armed: %1</source>
        <translation>no armado: %1</translation>
    </message>
    <message>
        <source>armed</source>
        <translation>armado</translation>
    </message>
    <message>
        <source>%1 guard, %2</source>
        <comment>guard and what tripped it</comment>
        <translation>protección de %1, %2</translation>
    </message>
    <message>
        <source>STOP: %1</source>
        <translation>STOP: %1</translation>
    </message>
    <message>
        <source>STOP: %1; not sent to %2</source>
        <translation>STOP: %1; no enviado a %2</translation>
    </message>
    <message>
        <source>this window did not respond for %1 s</source>
        <translation>esta ventana no respondió durante %1 s</translation>
    </message>
    <message>
        <source>disarmed after %1 min without motion</source>
        <translation>desarmado tras %1 min sin movimiento</translation>
    </message>
    <message>
        <source>the device is gone</source>
        <translation>el dispositivo ya no está</translation>
    </message>
    <message>
        <source>it has restarted</source>
        <translation>se ha reiniciado</translation>
    </message>
    <message>
        <source>an experiment on it has not ended</source>
        <translation>un ensayo con él aún no ha terminado</translation>
    </message>
    <message>
        <source>the computer slept</source>
        <translation>el ordenador estuvo suspendido</translation>
    </message>
</context>
<context>
    <name>mb::AxesPanel</name>
    <message>
        <source>Axes</source>
        <translation>Ejes</translation>
    </message>
    <message>
        <source>together</source>
        <translation>juntos</translation>
    </message>
    <message>
        <source>All axes run together</source>
        <translation>Todos los ejes se mueven juntos</translation>
    </message>
    <message>
        <source>Run starts every ticked axis at the same moment, each with its own mode and set-point.</source>
        <translation>Iniciar arranca a la vez todos los ejes marcados, cada uno con su modo y su consigna.</translation>
    </message>
    <message>
        <source>Copy gains from…</source>
        <translation>Copiar ganancias de…</translation>
    </message>
    <message>
        <source>Stages the gains and limits of another axis for this one.</source>
        <translation>Deja pendientes para este eje las ganancias y los límites de otro.</translation>
    </message>
    <message>
        <source>Same set-point for all ticked</source>
        <translation>Misma consigna para los marcados</translation>
    </message>
    <message>
        <source>Mode and set-point of this axis for every ticked one; a position becomes the same distance.</source>
        <translation>Modo y consigna de este eje para todos los marcados; una posición pasa a ser la misma distancia.</translation>
    </message>
    <message>
        <source>Shows this axis: its mode, set-point, gains, limits and traces</source>
        <translation>Muestra este eje: modo, consigna, ganancias, límites y curvas</translation>
    </message>
    <message>
        <source>Axis %1 runs together with the others</source>
        <translation>El eje %1 se mueve junto con los demás</translation>
    </message>
    <message>
        <source>Run always moves the axis that is shown.</source>
        <translation>Iniciar mueve siempre el eje que se muestra.</translation>
    </message>
    <message>
        <source>Run moves this axis, too, at the same moment.</source>
        <translation>Iniciar mueve también este eje, en el mismo instante.</translation>
    </message>
</context>
<context>
    <name>mb::AxisCells</name>
    <message>
        <source>Axes</source>
        <translation>Ejes</translation>
    </message>
    <message>
        <source>Shows this axis in Parameters, Tune and Plots</source>
        <translation>Muestra este eje en Parámetros, Ajuste y Gráficas</translation>
    </message>
</context>
<context>
    <name>mb::AxisChoice</name>
    <message>
        <source>Which axis</source>
        <translation>Qué eje</translation>
    </message>
    <message>
        <source>All axes</source>
        <translation>Todos los ejes</translation>
    </message>
    <message>
        <source>Board</source>
        <translation>Placa</translation>
    </message>
    <message>
        <source>Copy from</source>
        <translation>Copiar de</translation>
    </message>
    <message>
        <source>Copy gains and limits from another axis</source>
        <translation>Copiar ganancias y límites de otro eje</translation>
    </message>
    <message>
        <source>Stages the gains and limits of another axis for this one; Write sends them.</source>
        <translation>Deja pendientes para este eje las ganancias y los límites de otro; Escribir los envía.</translation>
    </message>
    <message>
        <source>Gains and limits of axis %1</source>
        <translation>Ganancias y límites del eje %1</translation>
    </message>
</context>
<context>
    <name>mb::Banner</name>
    <message>
        <source>Dismiss</source>
        <translation>Descartar</translation>
    </message>
</context>
<context>
    <name>mb::BannerStack</name>
    <message>
        <source>1 more notice</source>
        <translation>1 aviso más</translation>
    </message>
    <message numerus="yes">
        <source>%n more notices</source>
        <translation>
            <numerusform>%n aviso más</numerusform>
            <numerusform>%n avisos más</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mb::BatteryDialog</name>
    <message>
        <source>Battery of steps</source>
        <translation>Serie de escalones</translation>
    </message>
    <message>
        <source>Run the battery</source>
        <translation>Ejecutar la serie</translation>
    </message>
    <message>
        <source>Steps of the battery and the worst of each metric</source>
        <translation>Escalones de la serie y lo peor de cada índice</translation>
    </message>
    <message>
        <source>Responses of the battery over each other</source>
        <translation>Respuestas de la serie superpuestas</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>share of the step</source>
        <translation>fracción del escalón</translation>
    </message>
    <message>
        <source>Step, %1</source>
        <translation>Escalón, %1</translation>
    </message>
    <message>
        <source>%1 steps, both ways in turn, from %2 to %3 %4, with the gains in force. The motor turns; each step keeps inside the limits of the page.</source>
        <translation>%1 escalones, alternando el sentido, de %2 a %3 %4, con las ganancias vigentes. El motor gira; cada escalón respeta los límites de la página.</translation>
    </message>
    <message>
        <source>Step %1 of %2: to %3 %4. STOP ends it.</source>
        <translation>Escalón %1 de %2: a %3 %4. STOP lo termina.</translation>
    </message>
    <message>
        <source>Ended: %1</source>
        <translation>Terminado: %1</translation>
    </message>
    <message>
        <source>Ended by: %1</source>
        <translation>Terminado por: %1</translation>
    </message>
    <message>
        <source>Done: %1 trials in the notebook.</source>
        <translation>Listo: %1 ensayos en el cuaderno.</translation>
    </message>
    <message>
        <source>Ended before all steps were run.</source>
        <translation>Terminado antes de ejecutar todos los escalones.</translation>
    </message>
    <message>
        <source>worst</source>
        <translation>peor</translation>
    </message>
    <message>
        <source>DEMO</source>
        <translation>DEMO</translation>
    </message>
    <message>
        <source>Arm the device first: hold the Arm button for 1 s.</source>
        <translation>Arme antes el dispositivo: mantenga pulsado Armar 1 s.</translation>
    </message>
    <message>
        <source>Responses over each other</source>
        <translation>Respuestas superpuestas</translation>
    </message>
    <message>
        <source>forwards</source>
        <translation>hacia delante</translation>
    </message>
    <message>
        <source>backwards</source>
        <translation>hacia atrás</translation>
    </message>
    <message>
        <source>Not run: %1</source>
        <translation>No se ejecuta: %1</translation>
    </message>
    <message>
        <source>Not started, the page has changed: %1</source>
        <translation>No se ha iniciado, la página ha cambiado: %1</translation>
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
        <translation>como máximo %1</translation>
    </message>
    <message>
        <source>firmware</source>
        <translation>firmware</translation>
    </message>
    <message>
        <source>parameters</source>
        <translation>parámetros</translation>
    </message>
    <message>
        <source>%1 equal</source>
        <translation>%1 iguales</translation>
    </message>
    <message>
        <source>unusual, %1</source>
        <translation>inusual, %1</translation>
    </message>
    <message>
        <source>Connect a unit</source>
        <translation>Conecte un equipo</translation>
    </message>
    <message>
        <source>It starts by itself when it answers on %1.</source>
        <translation>Empieza solo en cuanto responde en %1.</translation>
    </message>
    <message>
        <source>Open a recipe, then Start</source>
        <translation>Abra una receta y pulse Iniciar</translation>
    </message>
    <message>
        <source>The motor turns in a moment</source>
        <translation>El motor va a girar</translation>
    </message>
    <message>
        <source>Safe to unplug</source>
        <translation>Se puede desconectar</translation>
    </message>
    <message>
        <source>Do not unplug</source>
        <translation>No desconectar</translation>
    </message>
    <message>
        <source>Unplug, connect next</source>
        <translation>Desconecte y conecte el siguiente</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>superado</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>omitido</translation>
    </message>
    <message>
        <source>waiting</source>
        <translation>en espera</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 a %2</translation>
    </message>
    <message>
        <source>speed at most %1 counts/s</source>
        <translation>velocidad: máximo %1 counts/s</translation>
    </message>
    <message>
        <source>travel at most %1 counts</source>
        <translation>recorrido: máximo %1 counts</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>no superado</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>rechazado</translation>
    </message>
    <message>
        <source>running</source>
        <translation>en marcha</translation>
    </message>
    <message>
        <source>Hold Arm to go on</source>
        <translation>Mantenga Armar para continuar</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>sí</translation>
    </message>
    <message>
        <source>no</source>
        <translation>no</translation>
    </message>
    <message>
        <source>duty at most %1 %</source>
        <translation>ciclo de trabajo: máximo %1 %</translation>
    </message>
    <message>
        <source>was there already</source>
        <translation>ya estaba</translation>
    </message>
    <message>
        <source>it answers with it</source>
        <translation>responde con él</translation>
    </message>
    <message>
        <source>read back</source>
        <translation>releídos</translation>
    </message>
    <message>
        <source>backup</source>
        <translation>copia</translation>
    </message>
    <message>
        <source>kept</source>
        <translation>guardada</translation>
    </message>
    <message>
        <source>before the first write</source>
        <translation>antes de la primera escritura</translation>
    </message>
    <message>
        <source>Start serves the next unit.</source>
        <translation>Iniciar atiende la siguiente unidad.</translation>
    </message>
    <message>
        <source>written, not proved</source>
        <translation>escrito, sin demostrar</translation>
    </message>
    <message>
        <source>%1 tests again · %2 sets it aside</source>
        <translation>%1 prueba de nuevo · %2 la aparta</translation>
    </message>
    <message>
        <source>Paused: no unit starts before the queue goes on.</source>
        <translation>En pausa: ningún equipo empieza antes de que la cola continúe.</translation>
    </message>
    <message>
        <source>%1 from %2 to %3</source>
        <translation>%1 de %2 a %3</translation>
    </message>
    <message>
        <source>Start serves it once more</source>
        <translation>Iniciar la atiende otra vez</translation>
    </message>
    <message>
        <source>No number was written to it this time.</source>
        <translation>Esta vez no se le escribió ningún número.</translation>
    </message>
</context>
<context>
    <name>mb::BodePlot</name>
    <message>
        <source>Magnitude of loop and motor</source>
        <translation>Módulo del lazo y del motor</translation>
    </message>
    <message>
        <source>Phase of loop and motor</source>
        <translation>Fase del lazo y del motor</translation>
    </message>
    <message>
        <source>Hz</source>
        <translation>Hz</translation>
    </message>
    <message>
        <source>magnitude, dB</source>
        <translation>módulo, dB</translation>
    </message>
    <message>
        <source>phase, °</source>
        <translation>fase, °</translation>
    </message>
    <message>
        <source>loop</source>
        <translation>lazo</translation>
    </message>
    <message>
        <source>motor ÷ gain</source>
        <translation>motor ÷ ganancia</translation>
    </message>
    <message>
        <source>motor ÷ gain, measured</source>
        <translation>motor ÷ ganancia, medido</translation>
    </message>
    <message>
        <source>0.90 … 0.97</source>
        <translation>0,90 … 0,97</translation>
    </message>
    <message>
        <source>not used</source>
        <translation>no usado</translation>
    </message>
    <message>
        <source>measured, γ² ≥ 0.97</source>
        <translation>medido, γ² ≥ 0,97</translation>
    </message>
    <message>
        <source>under 0.90, not used</source>
        <translation>menos de 0,90, no usado</translation>
    </message>
</context>
<context>
    <name>mb::BodeText</name>
    <message>
        <source>crossover %1 Hz</source>
        <translation>cruce %1 Hz</translation>
    </message>
    <message>
        <source>PM %1° at %2 Hz</source>
        <translation>PM %1° a %2 Hz</translation>
    </message>
    <message>
        <source>GM %1 dB at %2 Hz</source>
        <translation>GM %1 dB a %2 Hz</translation>
    </message>
    <message>
        <source>GM –, beyond what was measured</source>
        <translation>GM –, más allá de lo medido</translation>
    </message>
    <message>
        <source>usable up to %1 Hz</source>
        <translation>utilizable hasta %1 Hz</translation>
    </message>
    <message>
        <source>unstable</source>
        <translation>inestable</translation>
    </message>
    <message>
        <source>phase margin %1°</source>
        <translation>margen de fase %1°</translation>
    </message>
    <message>
        <source>gain margin %1 dB</source>
        <translation>margen de ganancia %1 dB</translation>
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
        <translation>Enlace</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pausa</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Continuar</translation>
    </message>
    <message>
        <source>Holds the frames still; everything is counted and kept meanwhile</source>
        <translation>Congela las tramas; mientras tanto todo se cuenta y se conserva</translation>
    </message>
    <message>
        <source>Clear the list</source>
        <translation>Vaciar la lista</translation>
    </message>
    <message>
        <source>Export frames</source>
        <translation>Exportar tramas</translation>
    </message>
    <message>
        <source>Frames that are shown…</source>
        <translation>Tramas mostradas…</translation>
    </message>
    <message>
        <source>All frames that are kept…</source>
        <translation>Todas las tramas conservadas…</translation>
    </message>
    <message>
        <source>Send frame…</source>
        <translation>Enviar trama…</translation>
    </message>
    <message>
        <source>What the expression does</source>
        <translation>Qué hace la expresión</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filtrar</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>Buscar</translation>
    </message>
    <message>
        <source>such as message:STS* device:5 not is:error</source>
        <translation>por ejemplo message:STS* device:5 not is:error</translation>
    </message>
    <message>
        <source>Filter frames</source>
        <translation>Filtrar tramas</translation>
    </message>
    <message>
        <source>How to write a filter</source>
        <translation>Cómo escribir un filtro</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Dirección</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Todas</translation>
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
        <translation>errores</translation>
    </message>
    <message>
        <source>Filter hides what does not match; Find marks what does, Enter goes to the next</source>
        <translation>Filtrar oculta lo que no coincide; Buscar marca lo que coincide, Intro va al siguiente</translation>
    </message>
</context>
<context>
    <name>mb::BusLoadView</name>
    <message>
        <source>Bus load of the last minute</source>
        <translation>Carga del bus en el último minuto</translation>
    </message>
    <message>
        <source>now %1 %, peak %2 %</source>
        <translation>ahora %1 %, pico %2 %</translation>
    </message>
</context>
<context>
    <name>mb::BusPage</name>
    <message>
        <source>Bus</source>
        <translation>Bus</translation>
    </message>
    <message>
        <source>pauses the list, and goes on</source>
        <translation>pausa la lista y la reanuda</translation>
    </message>
    <message>
        <source>goes to the filter</source>
        <translation>va al filtro</translation>
    </message>
    <message>
        <source>finds the next one</source>
        <translation>busca el siguiente</translation>
    </message>
    <message>
        <source>finds the one before</source>
        <translation>busca el anterior</translation>
    </message>
    <message>
        <source>not kept %1</source>
        <translation>no conservadas %1</translation>
    </message>
    <message>
        <source>%1 of %2 shown</source>
        <translation>%1 de %2 mostradas</translation>
    </message>
    <message>
        <source>Export all frames</source>
        <translation>Exportar todas las tramas</translation>
    </message>
    <message>
        <source>Export the frames that are shown</source>
        <translation>Exportar las tramas mostradas</translation>
    </message>
    <message>
        <source>candump log (*.log)</source>
        <translation>Registro candump (*.log)</translation>
    </message>
    <message>
        <source>%1 frames written to %2</source>
        <translation>%1 tramas escritas en %2</translation>
    </message>
    <message>
        <source>load %1 &amp;nbsp; frames/s %2</source>
        <translation>carga %1 &amp;nbsp; tramas/s %2</translation>
    </message>
    <message>
        <source>dropped %1 &amp;nbsp; errors %2</source>
        <translation>descartadas %1 &amp;nbsp; errores %2</translation>
    </message>
    <message>
        <source>No link yet</source>
        <translation>Aún no hay ningún enlace</translation>
    </message>
    <message>
        <source>Open a link, or the simulated bench from the menu; what passes on it appears here.</source>
        <translation>Abra un enlace, o el banco simulado desde el menú; lo que pase por él aparece aquí.</translation>
    </message>
    <message>
        <source>%1 is not open</source>
        <translation>%1 no está abierto</translation>
    </message>
    <message>
        <source>load %1 &amp;nbsp; bytes/s %2</source>
        <translation>carga %1 &amp;nbsp; bytes/s %2</translation>
    </message>
    <message>
        <source>records, or ends the recording</source>
        <translation>graba o termina la grabación</translation>
    </message>
</context>
<context>
    <name>mb::BusSide</name>
    <message>
        <source>Bus load, %</source>
        <translation>Carga del bus, %</translation>
    </message>
    <message>
        <source>last 60 s, peak %1 %</source>
        <translation>últimos 60 s, pico %1 %</translation>
    </message>
    <message>
        <source>%1 identifiers</source>
        <translation>%1 identificadores</translation>
    </message>
    <message>
        <source>busiest %1, %2 frames/s</source>
        <translation>más activo %1, %2 tramas/s</translation>
    </message>
    <message>
        <source>%1 frames of identifiers without a row</source>
        <translation>%1 tramas de identificadores sin fila</translation>
    </message>
    <message>
        <source>%1 frames that no decoder knows</source>
        <translation>%1 tramas que ningún decodificador conoce</translation>
    </message>
    <message>
        <source>error counters TEC %1, REC %2</source>
        <translation>contadores de errores TEC %1, REC %2</translation>
    </message>
</context>
<context>
    <name>mb::BusTables</name>
    <message>
        <source>Frames</source>
        <translation>Tramas</translation>
    </message>
    <message>
        <source>Identifiers</source>
        <translation>Identificadores</translation>
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
        <translation>corregir antes</translation>
    </message>
    <message>
        <source>look again</source>
        <translation>volver a mirar</translation>
    </message>
    <message>
        <source>Write %1: %2 to %3</source>
        <translation>Escribir %1: de %2 a %3</translation>
    </message>
    <message>
        <source>later</source>
        <translation>después</translation>
    </message>
    <message>
        <source>Written as number %1</source>
        <translation>Se escribe como número %1</translation>
    </message>
    <message>
        <source>Stays staged</source>
        <translation>Sigue pendiente</translation>
    </message>
</context>
<context>
    <name>mb::ChangesPanel</name>
    <message>
        <source>Changes to write</source>
        <translation>Cambios por escribir</translation>
    </message>
    <message>
        <source>order is chosen for you</source>
        <translation>orden automático</translation>
    </message>
    <message>
        <source>Limits first, then what makes the loop calmer, then what makes it livelier: damping before P, P before I.</source>
        <translation>Primero los límites, luego lo que calma el lazo y después lo que lo aviva: amortiguamiento antes que P, P antes que I.</translation>
    </message>
    <message>
        <source>Staged changes</source>
        <translation>Cambios pendientes</translation>
    </message>
    <message>
        <source>Nothing is staged. Edit a value in the table, or import a file.</source>
        <translation>No hay nada pendiente. Edite un valor en la tabla o importe un archivo.</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Progreso</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Descartar</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>Escribir</translation>
    </message>
    <message>
        <source>Each value is written, read back and compared.</source>
        <translation>Cada valor se escribe, se relee y se compara.</translation>
    </message>
    <message>
        <source>Each value is written. None can be read back: what stands here then is assumed.</source>
        <translation>Cada valor se escribe. Ninguno se puede releer: lo que figure aquí después será supuesto.</translation>
    </message>
    <message>
        <source>Each value is written. %1 of %2 cannot be read back: they are assumed then; the others are compared.</source>
        <translation>Cada valor se escribe. %1 de %2 no se pueden releer y pasan a ser supuestos; los demás se comparan.</translation>
    </message>
    <message>
        <source>nothing is staged</source>
        <translation>nada pendiente</translation>
    </message>
    <message>
        <source>fix 1 value first</source>
        <translation>corrija antes 1 valor</translation>
    </message>
    <message>
        <source>fix %1 values first</source>
        <translation>corrija antes %1 valores</translation>
    </message>
    <message>
        <source>look again first</source>
        <translation>vuelva a mirar antes</translation>
    </message>
    <message>
        <source>none is ticked</source>
        <translation>ninguno marcado</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>sin respuesta</translation>
    </message>
    <message>
        <source>two units, one number</source>
        <translation>dos equipos, un número</translation>
    </message>
    <message>
        <source>busy</source>
        <translation>ocupado</translation>
    </message>
    <message>
        <source>%1, %2 of %3</source>
        <translation>%1, %2 de %3</translation>
    </message>
    <message>
        <source>The drive stores by itself %1 s after the last change: keep power on.</source>
        <translation>El controlador guarda por sí mismo %1 s después del último cambio: mantenga la alimentación.</translation>
    </message>
    <message>
        <source>Write %1</source>
        <translation>Escribir %1</translation>
    </message>
    <message>
        <source>Write the staged changes</source>
        <translation>Escribir los cambios pendientes</translation>
    </message>
</context>
<context>
    <name>mb::Closing</name>
    <message>
        <source>Close MotorBench</source>
        <translation>Cerrar MotorBench</translation>
    </message>
    <message>
        <source>Keep open</source>
        <translation>Mantener abierto</translation>
    </message>
    <message>
        <source>Firmware is being written to %1. Cancel the update?</source>
        <translation>Se está escribiendo firmware en %1. ¿Cancelar la actualización?</translation>
    </message>
    <message>
        <source>What is written now must not be cut: the window closes once it is over.</source>
        <translation>Lo que se escribe ahora no debe interrumpirse: la ventana se cierra cuando termine.</translation>
    </message>
    <message>
        <source>Cancel the update and close</source>
        <translation>Cancelar la actualización y cerrar</translation>
    </message>
    <message>
        <source>%1 has not been seen to stop. Close anyway?</source>
        <translation>No se ha visto parar %1. ¿Cerrar de todos modos?</translation>
    </message>
    <message>
        <source>It was told to stop. Without this window nobody sees whether it does.</source>
        <translation>Se le ordenó parar. Sin esta ventana nadie ve si lo hace.</translation>
    </message>
    <message>
        <source>Close anyway</source>
        <translation>Cerrar de todos modos</translation>
    </message>
    <message>
        <source>Units are being served. Cancel the queue?</source>
        <translation>Se están atendiendo equipos. ¿Cancelar la cola?</translation>
    </message>
    <message>
        <source>The journal knows where it stood, and the queue can be gone on with.</source>
        <translation>El diario sabe dónde estaba, y la cola se puede continuar.</translation>
    </message>
    <message>
        <source>Cancel the queue and close</source>
        <translation>Cancelar la cola y cerrar</translation>
    </message>
    <message>
        <source>Samples are being written to %1. Cancel the export?</source>
        <translation>Se están escribiendo muestras en %1. ¿Cancelar la exportación?</translation>
    </message>
    <message>
        <source>Nothing of it is kept then.</source>
        <translation>Entonces no queda nada de ella.</translation>
    </message>
    <message>
        <source>Cancel the export and close</source>
        <translation>Cancelar la exportación y cerrar</translation>
    </message>
    <message>
        <source>The window closes once this has ended: %1</source>
        <translation>La ventana se cierra en cuanto termine esto: %1</translation>
    </message>
</context>
<context>
    <name>mb::CommandPalette</name>
    <message>
        <source>Commands</source>
        <translation>Órdenes</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Orden</translation>
    </message>
    <message>
        <source>Type what you want to do</source>
        <translation>Escriba lo que quiere hacer</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>page: command</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>No command begins so</source>
        <translation>Ninguna orden empieza así</translation>
    </message>
</context>
<context>
    <name>mb::ComparedText</name>
    <message>
        <source>in force</source>
        <translation>vigente</translation>
    </message>
    <message>
        <source>before</source>
        <translation>antes</translation>
    </message>
    <message>
        <source>%1: unstable on this model</source>
        <translation>%1: inestable con este modelo</translation>
    </message>
    <message>
        <source>%1: over %2 %, Ms %3</source>
        <translation>%1: sobre %2 %, Ms %3</translation>
    </message>
</context>
<context>
    <name>mb::ComparisonBox</name>
    <message>
        <source>Compare with</source>
        <translation>Comparar con</translation>
    </message>
    <message>
        <source>as found %1</source>
        <translation>lo encontrado %1</translation>
    </message>
    <message>
        <source>defaults</source>
        <translation>valores predeterminados</translation>
    </message>
    <message>
        <source>axis %1</source>
        <translation>eje %1</translation>
    </message>
    <message>
        <source>a file…</source>
        <translation>un archivo…</translation>
    </message>
</context>
<context>
    <name>mb::Conditions</name>
    <message>
        <source>%1 may still turn: cut its power</source>
        <translation>%1 podría seguir girando: corte su alimentación</translation>
    </message>
    <message>
        <source>Its stop was not confirmed. It is sent again, and first of all when its line is back.</source>
        <translation>Su parada no se confirmó. Se envía otra vez, y antes que nada cuando vuelva su línea.</translation>
    </message>
    <message>
        <source>I have looked: it stands</source>
        <translation>Lo he mirado: está parado</translation>
    </message>
    <message>
        <source>Stopped: %1</source>
        <translation>Parado: %1</translation>
    </message>
    <message>
        <source>Hold the Arm button for 1 s to arm again.</source>
        <translation>Mantenga pulsado Armar 1 s para volver a armar.</translation>
    </message>
    <message>
        <source>%1 is lost</source>
        <translation>%1 se ha perdido</translation>
    </message>
    <message>
        <source>Another master drives %1</source>
        <translation>Otro maestro acciona %1</translation>
    </message>
    <message>
        <source>Arming is off until it stops sending control frames.</source>
        <translation>No se puede armar hasta que deje de enviar tramas de control.</translation>
    </message>
    <message>
        <source>Several units answer as %1</source>
        <translation>Varios equipos responden como %1</translation>
    </message>
    <message>
        <source>Control is locked. Assign one of them a new number from the menu of its row.</source>
        <translation>Control bloqueado. Asigne a uno de ellos un número nuevo en el menú de su fila.</translation>
    </message>
    <message>
        <source>Firmware is being written to %1</source>
        <translation>Se está escribiendo firmware en %1</translation>
    </message>
    <message>
        <source>Do not unplug. %1 of %2.</source>
        <translation>No desconectar. %1 de %2.</translation>
    </message>
    <message>
        <source>Writing the settings of %1 again: %2 of %3</source>
        <translation>Reescribiendo los ajustes de %1: %2 de %3</translation>
    </message>
    <message>
        <source>Each is confirmed by the board.</source>
        <translation>La placa confirma cada uno.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>%1 was reset: 1 setting is unknown</source>
        <translation>%1 se reinició: 1 ajuste es desconocido</translation>
    </message>
    <message>
        <source>%1 was reset: %2 settings are unknown</source>
        <translation>%1 se reinició: %2 ajustes son desconocidos</translation>
    </message>
    <message>
        <source>The board keeps nothing without power. This program knows what was last written.</source>
        <translation>La placa no conserva nada sin alimentación. Este programa sabe qué se escribió por última vez.</translation>
    </message>
    <message>
        <source>Write them again</source>
        <translation>Escribirlos de nuevo</translation>
    </message>
    <message>
        <source>Trial #%1 on %2 was cut before it put its gains back</source>
        <translation>El ensayo #%1 en %2 se cortó antes de restituir sus ganancias</translation>
    </message>
    <message>
        <source>Before it: %1. The motor must stand.</source>
        <translation>Antes: %1. El motor debe estar parado.</translation>
    </message>
    <message>
        <source>Put them back</source>
        <translation>Restituirlas</translation>
    </message>
    <message>
        <source>Writing was cancelled; what is missing can be written later.</source>
        <translation>Escritura cancelada; lo que falta se puede escribir después.</translation>
    </message>
    <message>
        <source>%1 may have been reset: 1 setting is unknown</source>
        <translation>Puede que %1 se haya reiniciado: 1 ajuste es desconocido</translation>
    </message>
    <message>
        <source>%1 may have been reset: %2 settings are unknown</source>
        <translation>Puede que %1 se haya reiniciado: %2 ajustes son desconocidos</translation>
    </message>
    <message>
        <source>Nothing shows that it still has what was not saved. This program knows what was last written.</source>
        <translation>Nada muestra que aún tenga lo que no se guardó. Este programa sabe lo último que se escribió.</translation>
    </message>
    <message>
        <source>Safe to unplug: the update can be run again. %1 of %2.</source>
        <translation>Se puede desconectar: la actualización puede repetirse. %1 de %2.</translation>
    </message>
    <message>
        <source>Keep what it has</source>
        <translation>Conservar lo que tiene</translation>
    </message>
</context>
<context>
    <name>mb::CountTiles</name>
    <message>
        <source>passed</source>
        <translation>superado</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>no superado</translation>
    </message>
    <message>
        <source>refused before start</source>
        <translation>rechazados antes de empezar</translation>
    </message>
    <message>
        <source>mean time</source>
        <translation>tiempo medio</translation>
    </message>
    <message>
        <source>units an hour</source>
        <translation>equipos por hora</translation>
    </message>
</context>
<context>
    <name>mb::CrashNotice</name>
    <message>
        <source>The program ended unexpectedly</source>
        <translation>El programa terminó de forma inesperada</translation>
    </message>
    <message>
        <source>Open it again</source>
        <translation>Abrirlo de nuevo</translation>
    </message>
    <message>
        <source>Read the report</source>
        <translation>Leer el informe</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>Descartar</translation>
    </message>
    <message>
        <source>Report of the crash</source>
        <translation>Informe del fallo</translation>
    </message>
    <message>
        <source>File of the report</source>
        <translation>Archivo del informe</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copiar</translation>
    </message>
</context>
<context>
    <name>mb::DemoStripe</name>
    <message>
        <source>simulated bench</source>
        <translation>banco simulado</translation>
    </message>
    <message>
        <source>Demo  ·  %1  ·  no real motor is connected</source>
        <translation>Demo  ·  %1  ·  no hay ningún motor real conectado</translation>
    </message>
    <message>
        <source>Replay  ·  %1  ·  shows what was recorded, moves no motor</source>
        <translation>Reproducción  ·  %1  ·  muestra lo grabado, no mueve ningún motor</translation>
    </message>
    <message>
        <source>Replay</source>
        <translation>Reproducción</translation>
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
        <translation>%1 espera en su bootloader.</translation>
    </message>
    <message>
        <source>This family has no loop that can be tuned.</source>
        <translation>Esta familia no tiene ningún lazo que se pueda ajustar.</translation>
    </message>
</context>
<context>
    <name>mb::DesignCourse</name>
    <message>
        <source>What the adviser proposes</source>
        <translation>Lo que propone el asesor</translation>
    </message>
</context>
<context>
    <name>mb::DesignFrame</name>
    <message>
        <source>Part of the page</source>
        <translation>Parte de la página</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modelo</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>Curvas</translation>
    </message>
    <message>
        <source>Course</source>
        <translation>Desarrollo</translation>
    </message>
</context>
<context>
    <name>mb::DesignOrders</name>
    <message>
        <source>Loop</source>
        <translation>Lazo</translation>
    </message>
    <message>
        <source>Velocity</source>
        <translation>Velocidad</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Posición</translation>
    </message>
    <message>
        <source>Current</source>
        <translation>Corriente</translation>
    </message>
    <message>
        <source>Gain slot</source>
        <translation>Ranura de ganancias</translation>
    </message>
    <message>
        <source>slot 0</source>
        <translation>ranura 0</translation>
    </message>
    <message>
        <source>slot 1</source>
        <translation>ranura 1</translation>
    </message>
    <message>
        <source>Identify</source>
        <translation>Identificar</translation>
    </message>
    <message>
        <source>Autotune</source>
        <translation>Autoajuste</translation>
    </message>
    <message>
        <source>Write and prove</source>
        <translation>Escribir y verificar</translation>
    </message>
    <message>
        <source>Identifies, writes the chosen set and proves it, in one go</source>
        <translation>Identifica, escribe el juego elegido y lo verifica, todo seguido</translation>
    </message>
</context>
<context>
    <name>mb::DesignPage</name>
    <message>
        <source>writes the chosen set and proves it</source>
        <translation>escribe el juego elegido y lo verifica</translation>
    </message>
    <message>
        <source>identifies, writes and proves in one go</source>
        <translation>identifica, escribe y verifica, todo seguido</translation>
    </message>
    <message>
        <source>identifies the motor</source>
        <translation>identifica el motor</translation>
    </message>
    <message>
        <source>writes a report of what is shown</source>
        <translation>escribe un informe de lo mostrado</translation>
    </message>
    <message>
        <source>Tuning</source>
        <translation>Ajustando</translation>
    </message>
    <message>
        <source>STOP ends it; what was changed is put back.</source>
        <translation>STOP lo termina; lo que se cambió se restituye.</translation>
    </message>
    <message>
        <source>Moving</source>
        <translation>En movimiento</translation>
    </message>
    <message>
        <source>Stop the motion before the motor is tuned.</source>
        <translation>Pare el movimiento antes de ajustar el motor.</translation>
    </message>
    <message>
        <source>Busy</source>
        <translation>Ocupado</translation>
    </message>
    <message>
        <source>Armed</source>
        <translation>Armado</translation>
    </message>
    <message>
        <source>Not armed</source>
        <translation>No armado</translation>
    </message>
    <message>
        <source>Hold the Arm button for 1 s to arm %1.</source>
        <translation>Mantenga pulsado Armar 1 s para armar %1.</translation>
    </message>
    <message>
        <source>No tuning here</source>
        <translation>Aquí no hay ajuste</translation>
    </message>
    <message>
        <source>No device selected</source>
        <translation>Ningún dispositivo seleccionado</translation>
    </message>
    <message>
        <source>Choose a controller in the list at the left.</source>
        <translation>Elija un controlador en la lista de la izquierda.</translation>
    </message>
    <message>
        <source>Not by itself</source>
        <translation>No automático</translation>
    </message>
    <message>
        <source>DEMO</source>
        <translation>DEMO</translation>
    </message>
    <message>
        <source>No limit</source>
        <translation>Sin límite</translation>
    </message>
    <message>
        <source>%1 will turn both ways.</source>
        <translation>%1 girará en ambos sentidos.</translation>
    </message>
</context>
<context>
    <name>mb::DesignPlots</name>
    <message>
        <source>Step, predicted and measured</source>
        <translation>Escalón, previsto y medido</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>What the gains will do appears here, before they are written.</source>
        <translation>Aquí aparece lo que harán las ganancias, antes de escribirlas.</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Escalón</translation>
    </message>
</context>
<context>
    <name>mb::DeviceCard</name>
    <message>
        <source>velocity</source>
        <translation>velocidad</translation>
    </message>
    <message>
        <source>current</source>
        <translation>corriente</translation>
    </message>
    <message>
        <source>duty</source>
        <translation>ciclo de trabajo</translation>
    </message>
    <message>
        <source>last 10 s</source>
        <translation>últimos 10 s</translation>
    </message>
    <message>
        <source>Update firmware</source>
        <translation>Actualizar firmware</translation>
    </message>
    <message>
        <source>No application runs. Settings, number and name are kept.</source>
        <translation>No se ejecuta ninguna aplicación. Los ajustes, el número y el nombre se conservan.</translation>
    </message>
    <message>
        <source>An update makes it whole again. It is safe to power off.</source>
        <translation>Una actualización lo repara. Se puede apagar sin riesgo.</translation>
    </message>
    <message>
        <source>boot %1 · no telemetry</source>
        <translation>boot %1 · sin telemetría</translation>
    </message>
    <message>
        <source>%1 Hz   lost %2</source>
        <translation>%1 Hz   perdidas %2</translation>
    </message>
    <message>
        <source>no watchdog</source>
        <translation>sin watchdog</translation>
    </message>
    <message>
        <source>It keeps its last set-point if this program dies. A second process beside it, the guardian, stops it then.</source>
        <translation>Conserva su última consigna si este programa se cierra. Un segundo proceso, el vigilante, lo detiene entonces.</translation>
    </message>
</context>
<context>
    <name>mb::DeviceLine</name>
    <message>
        <source>Selected device</source>
        <translation>Dispositivo seleccionado</translation>
    </message>
    <message>
        <source>position</source>
        <translation>posición</translation>
    </message>
    <message>
        <source>velocity</source>
        <translation>velocidad</translation>
    </message>
    <message>
        <source>current</source>
        <translation>corriente</translation>
    </message>
    <message>
        <source>duty</source>
        <translation>ciclo de trabajo</translation>
    </message>
    <message>
        <source>bus</source>
        <translation>bus</translation>
    </message>
    <message>
        <source>case</source>
        <translation>carcasa</translation>
    </message>
    <message>
        <source>SN %1 · fw %2</source>
        <translation>N.º %1 · fw %2</translation>
    </message>
</context>
<context>
    <name>mb::DeviceModel</name>
    <message>
        <source>lost</source>
        <translation>perdido</translation>
    </message>
    <message>
        <source>scanning</source>
        <translation>buscando</translation>
    </message>
    <message>
        <source>%1 of %2: %3, now %4
Its pages show this axis; drag it to a plot.</source>
        <translation>%1 de %2: %3, ahora %4
Sus páginas muestran este eje; arrástrelo a una gráfica.</translation>
    </message>
    <message>
        <source>%1
Double click or Enter plots it; drag it to a plot.</source>
        <translation>%1
Doble clic o Intro lo representa; arrástrelo a una gráfica.</translation>
    </message>
</context>
<context>
    <name>mb::DeviceTree</name>
    <message>
        <source>Devices</source>
        <translation>Dispositivos</translation>
    </message>
    <message>
        <source>Scan again</source>
        <translation>Buscar de nuevo</translation>
    </message>
    <message>
        <source>Filter devices</source>
        <translation>Filtrar dispositivos</translation>
    </message>
    <message>
        <source>Hide devices</source>
        <translation>Ocultar dispositivos</translation>
    </message>
    <message>
        <source>Filter by name, number, serial</source>
        <translation>Nombre, número, n.º de serie</translation>
    </message>
    <message>
        <source>No device yet</source>
        <translation>Aún no hay dispositivos</translation>
    </message>
    <message>
        <source>Devices appear here by themselves as soon as a link answers.</source>
        <translation>Los dispositivos aparecen aquí solos en cuanto un enlace responde.</translation>
    </message>
    <message>
        <source>Links and devices</source>
        <translation>Enlaces y dispositivos</translation>
    </message>
    <message>
        <source>Add link</source>
        <translation>Añadir enlace</translation>
    </message>
    <message>
        <source>Simulate</source>
        <translation>Simular</translation>
    </message>
    <message>
        <source>Open a CAN interface, a serial port or another link</source>
        <translation>Abrir una interfaz CAN, un puerto serie u otro enlace</translation>
    </message>
    <message>
        <source>Open the simulated bench; no real motor is connected to it</source>
        <translation>Abrir el banco simulado; no tiene conectado ningún motor real</translation>
    </message>
    <message>
        <source>Show 1 new device</source>
        <translation>Mostrar 1 dispositivo nuevo</translation>
    </message>
    <message>
        <source>Show %1 new devices</source>
        <translation>Mostrar %1 dispositivos nuevos</translation>
    </message>
    <message>
        <source>Search every rate and address (takes minutes)</source>
        <translation>Buscar en todas las velocidades y direcciones (tarda minutos)</translation>
    </message>
    <message>
        <source>Cancel the scan</source>
        <translation>Cancelar la búsqueda</translation>
    </message>
    <message>
        <source>Plot %1</source>
        <translation>Representar %1</translation>
    </message>
    <message>
        <source>Open it at every start</source>
        <translation>Abrirlo en cada inicio</translation>
    </message>
    <message>
        <source>Close this link</source>
        <translation>Cerrar este enlace</translation>
    </message>
</context>
<context>
    <name>mb::DifferenceTable</name>
    <message>
        <source>Differences</source>
        <translation>Diferencias</translation>
    </message>
    <message>
        <source>parameter</source>
        <translation>parámetro</translation>
    </message>
    <message>
        <source>key</source>
        <translation>clave</translation>
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
        <translation>unidad</translation>
    </message>
    <message>
        <source>belongs to one unit, copied only if you tick it</source>
        <translation>propio de un equipo, solo se copia si se marca</translation>
    </message>
    <message>
        <source>assumed: it cannot be read</source>
        <translation>supuesto: no se puede leer</translation>
    </message>
    <message>
        <source>state</source>
        <translation>estado</translation>
    </message>
    <message>
        <source>This unit</source>
        <translation>Esta unidad</translation>
    </message>
    <message>
        <source>%1 of %2 differ</source>
        <translation>%1 de %2 distintos</translation>
    </message>
</context>
<context>
    <name>mb::DoctorCard</name>
    <message>
        <source>Connection doctor</source>
        <translation>Diagnóstico de la conexión</translation>
    </message>
    <message>
        <source>looks by itself</source>
        <translation>comprueba por sí solo</translation>
    </message>
    <message>
        <source>CAN</source>
        <translation>CAN</translation>
    </message>
    <message>
        <source>Command for a terminal</source>
        <translation>Orden para un terminal</translation>
    </message>
    <message>
        <source>Copy command</source>
        <translation>Copiar orden</translation>
    </message>
    <message>
        <source>Paste it into a terminal; this program never runs as root</source>
        <translation>Péguela en un terminal; este programa nunca se ejecuta como root</translation>
    </message>
    <message>
        <source>Reconnect</source>
        <translation>Reconectar</translation>
    </message>
    <message>
        <source>Open this link now</source>
        <translation>Abrir este enlace ahora</translation>
    </message>
    <message>
        <source>The command is in the clipboard; paste it into a terminal.</source>
        <translation>La orden está en el portapapeles; péguela en un terminal.</translation>
    </message>
</context>
<context>
    <name>mb::DriveOptions</name>
    <message>
        <source>as the device is set</source>
        <translation>según el dispositivo</translation>
    </message>
    <message>
        <source>brake</source>
        <translation>freno</translation>
    </message>
    <message>
        <source>coast</source>
        <translation>rueda libre</translation>
    </message>
    <message>
        <source>At zero output</source>
        <translation>Con salida cero</translation>
    </message>
    <message>
        <source>At zero</source>
        <translation>En cero</translation>
    </message>
    <message>
        <source>Reverse motor</source>
        <translation>Invertir motor</translation>
    </message>
    <message>
        <source>Forward output turns the motor the other way. Changing it disarms.</source>
        <translation>La salida hacia delante gira el motor al revés. Cambiarlo desarma.</translation>
    </message>
    <message>
        <source>Reverse sensor</source>
        <translation>Invertir sensor</translation>
    </message>
    <message>
        <source>The encoder counts the other way. Changing it disarms.</source>
        <translation>El encoder cuenta al revés. Cambiarlo desarma.</translation>
    </message>
    <message>
        <source>Override limits</source>
        <translation>Anular límites</translation>
    </message>
    <message>
        <source>The two below replace the device&apos;s own settings for limit switches. Changing it disarms.</source>
        <translation>Los dos de abajo sustituyen los ajustes del dispositivo para los finales de carrera. Cambiarlo desarma.</translation>
    </message>
    <message>
        <source>Forward limit off</source>
        <translation>Límite adelante desactivado</translation>
    </message>
    <message>
        <source>The motor runs past the forward limit. Changing it disarms.</source>
        <translation>El motor sobrepasa el límite hacia delante. Cambiarlo desarma.</translation>
    </message>
    <message>
        <source>Reverse limit off</source>
        <translation>Límite atrás desactivado</translation>
    </message>
    <message>
        <source>The motor runs past the reverse limit. Changing it disarms.</source>
        <translation>El motor sobrepasa el límite hacia atrás. Cambiarlo desarma.</translation>
    </message>
    <message>
        <source>Ramp of the output, duty per second</source>
        <translation>Rampa de la salida, ciclo de trabajo por segundo</translation>
    </message>
    <message>
        <source>duty/s, 0 = none</source>
        <translation>duty/s, 0 = ninguna</translation>
    </message>
    <message>
        <source>Ramp</source>
        <translation>Rampa</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>Nada</translation>
    </message>
    <message>
        <source>ramp %1 duty/s</source>
        <translation>rampa %1 duty/s</translation>
    </message>
    <message>
        <source>motor reversed</source>
        <translation>motor invertido</translation>
    </message>
    <message>
        <source>sensor reversed</source>
        <translation>sensor invertido</translation>
    </message>
    <message>
        <source>limits overridden</source>
        <translation>límites anulados</translation>
    </message>
    <message>
        <source>Greatest change of the output in duty per second: 2 takes 0.5 s from 0 to 100 %.</source>
        <translation>Variación máxima de la salida en ciclo de trabajo por segundo: 2 tarda 0,5 s de 0 a 100 %.</translation>
    </message>
    <message>
        <source>duty/s, 0 = %1</source>
        <translation>duty/s, 0 = %1</translation>
    </message>
    <message>
        <source>%1 is no ramp. Enter 0 or a positive number of duty per second.</source>
        <translation>%1 no es una rampa. Introduzca 0 o un número positivo de ciclo por segundo.</translation>
    </message>
</context>
<context>
    <name>mb::EntryText</name>
    <message>
        <source>passed</source>
        <translation>superado</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>no superado</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>rechazado</translation>
    </message>
    <message>
        <source>not ended</source>
        <translation>sin terminar</translation>
    </message>
    <message>
        <source>as it is now</source>
        <translation>como está ahora</translation>
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
        <translation>Recorrido ±</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Velocidad</translation>
    </message>
    <message>
        <source>Current</source>
        <translation>Corriente</translation>
    </message>
    <message>
        <source>Duty</source>
        <translation>Ciclo</translation>
    </message>
    <message>
        <source>Envelope</source>
        <translation>Límites</translation>
    </message>
    <message>
        <source>Envelope: %1</source>
        <translation>Límites: %1</translation>
    </message>
    <message>
        <source>Empty: what the device itself says</source>
        <translation>Vacío: lo que indique el dispositivo</translation>
    </message>
    <message>
        <source>%1 holds</source>
        <translation>rige %1</translation>
    </message>
    <message>
        <source>not bounded, %1</source>
        <translation>sin límite, %1</translation>
    </message>
    <message>
        <source>%1: %2 is no limit. It is more than 0, and at most %3.</source>
        <translation>%1: %2 no es un límite. Es mayor que 0 y como máximo %3.</translation>
    </message>
</context>
<context>
    <name>mb::ExperimentDialog</name>
    <message>
        <source>Axis</source>
        <translation>Eje</translation>
    </message>
    <message>
        <source>axis %1</source>
        <translation>eje %1</translation>
    </message>
    <message>
        <source>Of which motor</source>
        <translation>De qué motor</translation>
    </message>
    <message>
        <source>Most power</source>
        <translation>Potencia máxima</translation>
    </message>
    <message>
        <source>Not begun</source>
        <translation>No iniciado</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Paso</translation>
    </message>
    <message>
        <source>Progress of the experiment</source>
        <translation>Progreso del experimento</translation>
    </message>
    <message>
        <source>Log of the experiment</source>
        <translation>Registro del experimento</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Resultado</translation>
    </message>
    <message>
        <source>STOP, Esc or Cancel ends it at any time.</source>
        <translation>STOP, Esc o Cancelar lo terminan en cualquier momento.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Hold to turn the motor</source>
        <translation>Mantener para girar el motor</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>Empezar</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Ended</source>
        <translation>Terminado</translation>
    </message>
    <message>
        <source>Found and kept for this device.</source>
        <translation>Hallado y conservado para este dispositivo.</translation>
    </message>
    <message>
        <source>Cancelled. The motor is stopped; gains and limits are as they were.</source>
        <translation>Cancelado. El motor está parado; ganancias y límites están como antes.</translation>
    </message>
</context>
<context>
    <name>mb::ExperimentText</name>
    <message>
        <source>at most %1 s</source>
        <translation>como máximo %1 s</translation>
    </message>
    <message>
        <source>inside the envelope · %1</source>
        <translation>dentro de los límites · %1</translation>
    </message>
    <message>
        <source>inside the envelope · %1 of %2 · %3</source>
        <translation>dentro de los límites · %1 de %2 · %3</translation>
    </message>
    <message>
        <source>This mode has no loop that can be tried; Live drives it.</source>
        <translation>Este modo no tiene ningún lazo que ensayar; En vivo lo acciona.</translation>
    </message>
    <message>
        <source>Nothing bounds the motor: enter travel, duty, and what else is empty here.</source>
        <translation>Nada limita el motor: introduzca recorrido, ciclo y lo que aquí siga vacío.</translation>
    </message>
    <message>
        <source>Enter where the loop is to go.</source>
        <translation>Introduzca adónde debe ir el lazo.</translation>
    </message>
    <message>
        <source>It is there already; enter another place to go to.</source>
        <translation>Ya está ahí; introduzca otro destino.</translation>
    </message>
</context>
<context>
    <name>mb::ExportBar</name>
    <message>
        <source>Progress of the export</source>
        <translation>Progreso de la exportación</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Writing samples</source>
        <translation>Escribiendo muestras</translation>
    </message>
    <message>
        <source>One export at a time: %1 is being written.</source>
        <translation>Solo una exportación a la vez: se está escribiendo %1.</translation>
    </message>
    <message>
        <source>writing %1</source>
        <translation>escribiendo %1</translation>
    </message>
    <message>
        <source>%1 written: %2 samples, %3 lost</source>
        <translation>%1 escrito: %2 muestras, %3 perdidas</translation>
    </message>
    <message>
        <source>export cancelled, nothing was written</source>
        <translation>exportación cancelada, no se escribió nada</translation>
    </message>
</context>
<context>
    <name>mb::FaultLine</name>
    <message>
        <source>Is that meant?</source>
        <translation>¿Es intencionado?</translation>
    </message>
    <message>
        <source>Use %1</source>
        <translation>Usar %1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Revert to %1</source>
        <translation>Volver a %1</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>Revertir</translation>
    </message>
</context>
<context>
    <name>mb::FileExchange</name>
    <message>
        <source>%1 says what the device has.</source>
        <translation>%1 coincide con el dispositivo.</translation>
    </message>
    <message>
        <source>Nothing is staged.</source>
        <translation>No hay nada pendiente.</translation>
    </message>
    <message>
        <source>Import of %1</source>
        <translation>Importación de %1</translation>
    </message>
    <message>
        <source>Nothing is written yet: look through the list, then write.</source>
        <translation>Aún no se ha escrito nada: revise la lista y después escriba.</translation>
    </message>
    <message>
        <source>Left out: %1, for one: %2.</source>
        <translation>Omitidos: %1, por ejemplo: %2.</translation>
    </message>
    <message>
        <source>Staged from %1: %2 of its values differ.</source>
        <translation>Pendiente desde %1: %2 de sus valores difieren.</translation>
    </message>
    <message>
        <source>Undo the import</source>
        <translation>Deshacer la importación</translation>
    </message>
    <message>
        <source>Choose another place.</source>
        <translation>Elija otro lugar.</translation>
    </message>
    <message>
        <source>%1 parameters exported to %2</source>
        <translation>%1 parámetros exportados a %2</translation>
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
        <translation>inicia la actualización</translation>
    </message>
    <message>
        <source>What is updated</source>
        <translation>Qué se actualiza</translation>
    </message>
    <message>
        <source>Selected unit</source>
        <translation>Equipo seleccionado</translation>
    </message>
    <message>
        <source>Queue of units</source>
        <translation>Cola de equipos</translation>
    </message>
    <message>
        <source>Unit that does not answer</source>
        <translation>Equipo que no responde</translation>
    </message>
    <message>
        <source>A unit whose update was cut may be mute: say where it is, and it can be written again</source>
        <translation>Un equipo cuya actualización se interrumpió puede quedar mudo: indique dónde está y se podrá escribir de nuevo</translation>
    </message>
</context>
<context>
    <name>mb::FirmwareShelf</name>
    <message>
        <source>not read yet</source>
        <translation>aún sin leer</translation>
    </message>
    <message>
        <source>%1 · checked · %2</source>
        <translation>%1 · comprobado · %2</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Detalles</translation>
    </message>
</context>
<context>
    <name>mb::FrameDetail</name>
    <message>
        <source>Selected frame</source>
        <translation>Trama seleccionada</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Trama</translation>
    </message>
    <message>
        <source>Fields</source>
        <translation>Campos</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copiar</translation>
    </message>
    <message>
        <source>Copy the selected frames as candump text (Ctrl+C)</source>
        <translation>Copiar las tramas seleccionadas como texto candump (Ctrl+C)</translation>
    </message>
    <message>
        <source>Send again…</source>
        <translation>Enviar de nuevo…</translation>
    </message>
    <message>
        <source>No frame selected</source>
        <translation>Ninguna trama seleccionada</translation>
    </message>
    <message>
        <source>Select one to see its fields</source>
        <translation>Seleccione una para ver sus campos</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Error frame</source>
        <translation>Trama de error</translation>
    </message>
    <message>
        <source>Unknown frame</source>
        <translation>Trama desconocida</translation>
    </message>
    <message>
        <source>sent</source>
        <translation>enviada</translation>
    </message>
    <message>
        <source>received</source>
        <translation>recibida</translation>
    </message>
    <message>
        <source>%1 · %2 #%3 · %4</source>
        <translation>%1 · %2 #%3 · %4</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>%1 = %2, bits %3</source>
        <translation>%1 = %2, bits %3</translation>
    </message>
    <message>
        <source>%1 bytes</source>
        <translation>%1 bytes</translation>
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
        <source>%1 bytes</source>
        <translation>%1 bytes</translation>
    </message>
    <message>
        <source>error frame</source>
        <translation>trama de error</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>desconocido</translation>
    </message>
    <message>
        <source>asks for data</source>
        <translation>solicita datos</translation>
    </message>
    <message>
        <source>no decoder knows this identifier</source>
        <translation>ningún decodificador conoce este identificador</translation>
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
        <translation>dir</translation>
    </message>
    <message>
        <source>id</source>
        <translation>id</translation>
    </message>
    <message>
        <source>message</source>
        <translation>mensaje</translation>
    </message>
    <message>
        <source>dev</source>
        <translation>disp.</translation>
    </message>
    <message>
        <source>decoded</source>
        <translation>decodificado</translation>
    </message>
    <message>
        <source>data</source>
        <translation>datos</translation>
    </message>
</context>
<context>
    <name>mb::GainRow</name>
    <message>
        <source>Use it</source>
        <translation>Usarlo</translation>
    </message>
    <message>
        <source>Use this %1</source>
        <translation>Usar este %1</translation>
    </message>
    <message>
        <source>Revert %1</source>
        <translation>Revertir %1</translation>
    </message>
    <message>
        <source>%1, one decade either way</source>
        <translation>%1, una década en cada sentido</translation>
    </message>
    <message>
        <source>One decade either way. ← → 2 %, with Shift 0.2 %, with Ctrl 20 %</source>
        <translation>Una década en cada sentido. ← → 2 %, con Mayús 0,2 %, con Ctrl 20 %</translation>
    </message>
    <message>
        <source>stored</source>
        <translation>guardado</translation>
    </message>
    <message>
        <source>RAM</source>
        <translation>RAM</translation>
    </message>
    <message>
        <source>volatile</source>
        <translation>volátil</translation>
    </message>
    <message>
        <source>assumed</source>
        <translation>supuesto</translation>
    </message>
    <message>
        <source>edited</source>
        <translation>editado</translation>
    </message>
    <message>
        <source>range</source>
        <translation>rango</translation>
    </message>
    <message>
        <source>reading</source>
        <translation>leyendo</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>desconocido</translation>
    </message>
    <message>
        <source>edited, was %1</source>
        <translation>editado, era %1</translation>
    </message>
    <message>
        <source>edited, was unknown</source>
        <translation>editado, era desconocido</translation>
    </message>
    <message>
        <source>raw %1   %2</source>
        <translation>bruto %1   %2</translation>
    </message>
    <message>
        <source>unknown until written</source>
        <translation>desconocido hasta escribirlo</translation>
    </message>
</context>
<context>
    <name>mb::GainsPanel</name>
    <message>
        <source>Gains</source>
        <translation>Ganancias</translation>
    </message>
    <message>
        <source>G · ← → 2 % · Shift 0.2 %</source>
        <translation>G · ←→ 2 % · ⇧ 0,2 %</translation>
    </message>
    <message>
        <source>Gains, slot %1</source>
        <translation>Ganancias, ranura %1</translation>
    </message>
    <message>
        <source>Gains, axis %1</source>
        <translation>Ganancias, eje %1</translation>
    </message>
    <message>
        <source>Hide limits of the loop</source>
        <translation>Ocultar límites del lazo</translation>
    </message>
    <message>
        <source>Divisor</source>
        <translation>Divisor</translation>
    </message>
    <message>
        <source>Limits of the axis</source>
        <translation>Límites del eje</translation>
    </message>
    <message>
        <source>Limits of the loop</source>
        <translation>Límites del lazo</translation>
    </message>
    <message>
        <source>No loop runs in %1 mode: only the limits of the axis act.</source>
        <translation>En el modo %1 no actúa ningún lazo: solo los límites del eje.</translation>
    </message>
    <message>
        <source>No loop runs in %1 mode: these gains act in velocity, position and current.</source>
        <translation>En el modo %1 no actúa ningún lazo: estas ganancias actúan en velocidad, posición y corriente.</translation>
    </message>
    <message>
        <source>off</source>
        <translation>apagado</translation>
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
        <translation>Escribir ganancias</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>Revertir</translation>
    </message>
    <message>
        <source>Revert all staged gains</source>
        <translation>Revertir todas las ganancias pendientes</translation>
    </message>
    <message numerus="yes">
        <source>%n value(s)</source>
        <translation>
            <numerusform>%n valor</numerusform>
            <numerusform>%n valores</numerusform>
        </translation>
    </message>
    <message>
        <source>Write %1 to slot %2</source>
        <translation>Escribir %1 en la ranura %2</translation>
    </message>
    <message>
        <source>Write %1</source>
        <translation>Escribir %1</translation>
    </message>
    <message>
        <source>A gain is out of range</source>
        <translation>Una ganancia está fuera de rango</translation>
    </message>
    <message>
        <source>No gain is edited</source>
        <translation>No hay ganancias editadas</translation>
    </message>
    <message>
        <source>The device is busy</source>
        <translation>El dispositivo está ocupado</translation>
    </message>
</context>
<context>
    <name>mb::GroupMotion</name>
    <message>
        <source>not prepared: hold the Arm button first</source>
        <translation>no preparado: mantenga pulsado antes el botón Armar</translation>
    </message>
    <message>
        <source>not prepared: the selected device has to take part</source>
        <translation>no preparado: el dispositivo seleccionado debe participar</translation>
    </message>
    <message>
        <source>not started: not every device has acknowledged its move; prepare them again</source>
        <translation>no iniciado: no todos los dispositivos confirmaron su movimiento; prepárelos de nuevo</translation>
    </message>
    <message>
        <source>stopped, and the others of its group with it: %1</source>
        <translation>parado, y con él los demás de su grupo: %1</translation>
    </message>
    <message>
        <source>it is gone</source>
        <translation>ya no está</translation>
    </message>
    <message>
        <source>not prepared: an experiment on the selected device has not ended</source>
        <translation>no preparado: un ensayo con el dispositivo seleccionado aún no ha terminado</translation>
    </message>
</context>
<context>
    <name>mb::GuardianCheck</name>
    <message>
        <source>stops a motor when this program is killed or hangs</source>
        <translation>detiene un motor si este programa muere o se cuelga</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Comprobar</translation>
    </message>
    <message>
        <source>Check the guardian</source>
        <translation>Comprobar el vigilante</translation>
    </message>
    <message>
        <source>%1 cannot be started: %2</source>
        <translation>%1 no se puede iniciar: %2</translation>
    </message>
    <message>
        <source>It is in place and runs.</source>
        <translation>Está en su sitio y funciona.</translation>
    </message>
    <message>
        <source>%1 does not run as it should.</source>
        <translation>%1 no funciona como debería.</translation>
    </message>
</context>
<context>
    <name>mb::Guide</name>
    <message>
        <source>overshoot %1 % at first, %2 % now</source>
        <translation>sobreimpulso %1 % al principio, %2 % ahora</translation>
    </message>
    <message>
        <source>overshoot %1 %</source>
        <translation>sobreimpulso %1 %</translation>
    </message>
    <message>
        <source>peak current %1 A</source>
        <translation>corriente de pico %1 A</translation>
    </message>
    <message>
        <source>%1 counts beside its target at first, %2 now</source>
        <translation>a %1 cuentas de su destino al principio, a %2 ahora</translation>
    </message>
    <message>
        <source>%1 counts beside its target</source>
        <translation>a %1 cuentas de su destino</translation>
    </message>
</context>
<context>
    <name>mb::GuideStrip</name>
    <message>
        <source>Guide</source>
        <translation>Guía</translation>
    </message>
    <message>
        <source>Show me where</source>
        <translation>Mostrar dónde</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>Empezar</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>Descartar</translation>
    </message>
    <message>
        <source>Not now</source>
        <translation>Ahora no</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Simulated: nothing real moves. A guide says each step and waits until it has happened.</source>
        <translation>Simulado: nada real se mueve. Una guía indica cada paso y espera a que se haya realizado.</translation>
    </message>
    <message>
        <source>%1 done</source>
        <translation>%1 hecho</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>Done.</source>
        <translation>Hecho.</translation>
    </message>
    <message>
        <source>The simulated bench is opened; the unit answers in a moment.</source>
        <translation>Se abre el banco simulado; el equipo responde en un momento.</translation>
    </message>
    <message>
        <source>Measured: %1.</source>
        <translation>Medido: %1.</translation>
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
        <translation>Menú del programa</translation>
    </message>
    <message>
        <source>1 link</source>
        <translation>1 enlace</translation>
    </message>
    <message numerus="yes">
        <source>%n links</source>
        <translation>
            <numerusform>%n enlace</numerusform>
            <numerusform>%n enlaces</numerusform>
        </translation>
    </message>
    <message>
        <source>Links</source>
        <translation>Enlaces</translation>
    </message>
    <message>
        <source>no alarms</source>
        <translation>sin alarmas</translation>
    </message>
    <message>
        <source>1 notice</source>
        <translation>1 aviso</translation>
    </message>
    <message numerus="yes">
        <source>%n notices</source>
        <translation>
            <numerusform>%n aviso</numerusform>
            <numerusform>%n avisos</numerusform>
        </translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Grabación</translation>
    </message>
</context>
<context>
    <name>mb::HelpBrowser</name>
    <message>
        <source>Help</source>
        <translation>Ayuda</translation>
    </message>
</context>
<context>
    <name>mb::HelpDesk</name>
    <message>
        <source>Help for this page</source>
        <translation>Ayuda de esta página</translation>
    </message>
</context>
<context>
    <name>mb::HelpWindow</name>
    <message>
        <source>Help</source>
        <translation>Ayuda</translation>
    </message>
    <message>
        <source>Pages of the help</source>
        <translation>Páginas de la ayuda</translation>
    </message>
</context>
<context>
    <name>mb::HistoryPanel</name>
    <message>
        <source>State A</source>
        <translation>Estado A</translation>
    </message>
    <message>
        <source>State B</source>
        <translation>Estado B</translation>
    </message>
    <message>
        <source>Which parameters</source>
        <translation>Qué parámetros</translation>
    </message>
    <message>
        <source>Only differences</source>
        <translation>Solo diferencias</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Todas</translation>
    </message>
    <message>
        <source>Restore what is ticked</source>
        <translation>Restaurar lo marcado</translation>
    </message>
    <message>
        <source>Only differences %1</source>
        <translation>Solo diferencias %1</translation>
    </message>
    <message>
        <source>All %1</source>
        <translation>Todos %1</translation>
    </message>
    <message>
        <source>%1 ticked; a snapshot of what is there is taken first.</source>
        <translation>%1 marcados; antes se toma una instantánea de lo que hay.</translation>
    </message>
    <message>
        <source>Choose what the device has now as A to write values of B.</source>
        <translation>Elija como A lo que tiene ahora el dispositivo para escribir valores de B.</translation>
    </message>
    <message>
        <source>Restore %1</source>
        <translation>Restaurar %1</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Cronología</translation>
    </message>
    <message>
        <source>differences from A</source>
        <translation>diferencias con A</translation>
    </message>
    <message>
        <source>Click sets B, Shift+click sets A.</source>
        <translation>Clic fija B, Mayús+clic fija A.</translation>
    </message>
    <message>
        <source>Exchange A and B</source>
        <translation>Intercambiar A y B</translation>
    </message>
    <message>
        <source>Copy as text</source>
        <translation>Copiar como texto</translation>
    </message>
    <message>
        <source>Keep or revert first</source>
        <translation>Antes, conservar o restituir</translation>
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
        <translation>trama de error</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>desconocido</translation>
    </message>
    <message>
        <source>every %1 ms, standard deviation %2 ms, largest deviation %3 ms, over the last 32 periods</source>
        <translation>cada %1 ms, desviación estándar %2 ms, desviación máxima %3 ms, en los últimos 32 periodos</translation>
    </message>
    <message>
        <source>Right click: choose the field</source>
        <translation>Clic derecho: elegir el campo</translation>
    </message>
    <message>
        <source>Standard deviation of the last 32 periods</source>
        <translation>Desviación estándar de los últimos 32 periodos</translation>
    </message>
    <message>
        <source>The last frame; bytes that changed within 0.7 s are marked</source>
        <translation>La última trama; los bytes que cambiaron hace menos de 0,7 s están marcados</translation>
    </message>
    <message>
        <source>id</source>
        <translation>id</translation>
    </message>
    <message>
        <source>dir</source>
        <translation>dir</translation>
    </message>
    <message>
        <source>message</source>
        <translation>mensaje</translation>
    </message>
    <message>
        <source>dev</source>
        <translation>disp.</translation>
    </message>
    <message>
        <source>rate Hz</source>
        <translation>frec. Hz</translation>
    </message>
    <message>
        <source>jitter ms</source>
        <translation>jitter ms</translation>
    </message>
    <message>
        <source>frames</source>
        <translation>tramas</translation>
    </message>
    <message>
        <source>data</source>
        <translation>datos</translation>
    </message>
    <message>
        <source>last value</source>
        <translation>último valor</translation>
    </message>
    <message>
        <source>last 5 s</source>
        <translation>últimos 5 s</translation>
    </message>
</context>
<context>
    <name>mb::ImageText</name>
    <message>
        <source>no image yet</source>
        <translation>aún sin imagen</translation>
    </message>
    <message>
        <source>Open an Intel HEX file, or drop it here</source>
        <translation>Abra un archivo Intel HEX o suéltelo aquí</translation>
    </message>
    <message>
        <source>select a device to check it</source>
        <translation>seleccione un dispositivo para comprobarla</translation>
    </message>
    <message>
        <source>version %1 · pages: %2</source>
        <translation>versión %1 · páginas: %2</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>desconocido</translation>
    </message>
</context>
<context>
    <name>mb::Inspector</name>
    <message>
        <source>Inspector</source>
        <translation>Inspector</translation>
    </message>
    <message>
        <source>Identify</source>
        <translation>Identificar</translation>
    </message>
    <message>
        <source>Read all</source>
        <translation>Leer todo</translation>
    </message>
    <message>
        <source>Read every parameter of this unit</source>
        <translation>Leer todos los parámetros de este equipo</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>En vivo</translation>
    </message>
    <message>
        <source>position</source>
        <translation>posición</translation>
    </message>
    <message>
        <source>velocity</source>
        <translation>velocidad</translation>
    </message>
    <message>
        <source>current</source>
        <translation>corriente</translation>
    </message>
    <message>
        <source>duty</source>
        <translation>ciclo de trabajo</translation>
    </message>
    <message>
        <source>bus</source>
        <translation>bus</translation>
    </message>
    <message>
        <source>case</source>
        <translation>carcasa</translation>
    </message>
    <message>
        <source>Identity</source>
        <translation>Identidad</translation>
    </message>
    <message>
        <source>serial</source>
        <translation>n.º de serie</translation>
    </message>
    <message>
        <source>firmware</source>
        <translation>firmware</translation>
    </message>
    <message>
        <source>bootloader</source>
        <translation>bootloader</translation>
    </message>
    <message>
        <source>session</source>
        <translation>sesión</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Estado</translation>
    </message>
    <message>
        <source>faults</source>
        <translation>fallos</translation>
    </message>
    <message>
        <source>over-temperature</source>
        <translation>sobretemperatura</translation>
    </message>
    <message>
        <source>limits</source>
        <translation>límites</translation>
    </message>
    <message>
        <source>changed from default</source>
        <translation>no predeterminados</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>in RAM only</source>
        <translation>solo en RAM</translation>
    </message>
    <message>
        <source>No device selected</source>
        <translation>Ningún dispositivo seleccionado</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguna</translation>
    </message>
    <message>
        <source>Blink the lamps of this unit</source>
        <translation>Hacer parpadear los LED de este equipo</translation>
    </message>
</context>
<context>
    <name>mb::JogPanel</name>
    <message>
        <source>Nudge −</source>
        <translation>Impulso −</translation>
    </message>
    <message>
        <source>Nudge +</source>
        <translation>Impulso +</translation>
    </message>
    <message>
        <source>Nudge backwards</source>
        <translation>Impulso hacia atrás</translation>
    </message>
    <message>
        <source>Nudge forwards</source>
        <translation>Impulso hacia delante</translation>
    </message>
    <message>
        <source>A click moves it for a tenth of a second; held, it goes on until it is let go.</source>
        <translation>Un clic lo mueve una décima de segundo; si se mantiene, sigue hasta soltarlo.</translation>
    </message>
</context>
<context>
    <name>mb::JournalCard</name>
    <message>
        <source>Journal</source>
        <translation>Diario</translation>
    </message>
    <message>
        <source>Change…</source>
        <translation>Cambiar…</translation>
    </message>
    <message>
        <source>Change the journal</source>
        <translation>Cambiar el diario</translation>
    </message>
    <message>
        <source>On this computer</source>
        <translation>En este equipo</translation>
    </message>
    <message>
        <source>PostgreSQL, %1</source>
        <translation>PostgreSQL, %1</translation>
    </message>
    <message>
        <source>station %1</source>
        <translation>estación %1</translation>
    </message>
    <message numerus="yes">
        <source>%n entries wait for the server</source>
        <translation>
            <numerusform>%n entrada espera al servidor</numerusform>
            <numerusform>%n entradas esperan al servidor</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n units of this run are in it</source>
        <translation>
            <numerusform>%n unidad de esta tanda está en él</numerusform>
            <numerusform>%n unidades de esta tanda están en él</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mb::KeepBar</name>
    <message>
        <source>30 s from when the unit has restarted with them</source>
        <translation>30 s desde que el equipo se reinicie con ellos</translation>
    </message>
    <message>
        <source>they go back in %1 s</source>
        <translation>se restituyen en %1 s</translation>
    </message>
    <message>
        <source>they go back as soon as the motor stands</source>
        <translation>se restituyen en cuanto el motor esté parado</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Conservar</translation>
    </message>
    <message>
        <source>Time until the values go back</source>
        <translation>Tiempo hasta que se restituyan los valores</translation>
    </message>
    <message numerus="yes">
        <source>%1 · %n more change(s) after this one</source>
        <translation>
            <numerusform>%1 · queda %n cambio más</numerusform>
            <numerusform>%1 · quedan %n cambios más</numerusform>
        </translation>
    </message>
    <message>
        <source>Keep these values of %1?</source>
        <translation>¿Conservar estos valores de %1?</translation>
    </message>
    <message>
        <source>nothing goes back by itself</source>
        <translation>nada se restituye solo</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>Restituir</translation>
    </message>
</context>
<context>
    <name>mb::KeyBook</name>
    <message>
        <source>This key cannot be changed.</source>
        <translation>Esta tecla no se puede cambiar.</translation>
    </message>
    <message>
        <source>%1 stops every motor, always.</source>
        <translation>%1 detiene todos los motores, siempre.</translation>
    </message>
    <message>
        <source>%1 is taken, %2: %3. Give that another key first.</source>
        <translation>%1 está ocupada, %2: %3. Dele antes otra tecla.</translation>
    </message>
    <message>
        <source>%1 belongs to the control that has the focus.</source>
        <translation>%1 pertenece al control que tiene el foco.</translation>
    </message>
</context>
<context>
    <name>mb::KeyDesk</name>
    <message>
        <source>stop every motor</source>
        <translation>detienen todos los motores</translation>
    </message>
    <message>
        <source>stops every motor, unless words can be typed where the focus is</source>
        <translation>detiene todos los motores, salvo si el foco admite texto</translation>
    </message>
    <message>
        <source>presses the button or ticks the box that has the focus</source>
        <translation>pulsa el botón o marca la casilla que tiene el foco</translation>
    </message>
    <message>
        <source>held for 1 s: arms; let go early it does nothing</source>
        <translation>pulsado 1 s: arma; si se suelta antes, no hace nada</translation>
    </message>
    <message>
        <source>keeps values that go back by themselves otherwise</source>
        <translation>conserva los valores que si no vuelven solos</translation>
    </message>
    <message>
        <source>Everywhere</source>
        <translation>En todas partes</translation>
    </message>
    <message>
        <source>Production</source>
        <translation>Producción</translation>
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
        <translation>Pulse aquí la nueva tecla</translation>
    </message>
    <message>
        <source>New key</source>
        <translation>Nueva tecla</translation>
    </message>
</context>
<context>
    <name>mb::KeysPanel</name>
    <message>
        <source>Search commands and keys</source>
        <translation>Buscar órdenes y teclas</translation>
    </message>
    <message>
        <source>Commands and their keys</source>
        <translation>Órdenes y sus teclas</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Orden</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Tecla</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>Predeterminado</translation>
    </message>
    <message>
        <source>No key</source>
        <translation>Sin tecla</translation>
    </message>
    <message>
        <source>All defaults</source>
        <translation>Todo por defecto</translation>
    </message>
    <message>
        <source>All keys are those they came with.</source>
        <translation>Todas las teclas son las originales.</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguna</translation>
    </message>
    <message>
        <source>It came with: %1</source>
        <translation>Tecla original: %1</translation>
    </message>
    <message>
        <source>This key cannot be changed.</source>
        <translation>Esta tecla no se puede cambiar.</translation>
    </message>
    <message>
        <source>Choose a command, then press its new key in the field.</source>
        <translation>Elija una orden y pulse su nueva tecla en el campo.</translation>
    </message>
</context>
<context>
    <name>mb::Lamp</name>
    <message>
        <source>Arm button: %1</source>
        <translation>Botón Armar: %1</translation>
    </message>
    <message>
        <source>A motor was told to stop and was not seen to. Cut its power, or look at it.</source>
        <translation>Se ordenó parar a un motor y no se le vio hacerlo. Corte su alimentación o compruébelo.</translation>
    </message>
    <message>
        <source>Press to make it safe again</source>
        <translation>Pulse para volver a desarmar</translation>
    </message>
    <message>
        <source>Hold for one second to arm</source>
        <translation>Mantenga pulsado un segundo para armar</translation>
    </message>
</context>
<context>
    <name>mb::LampFace</name>
    <message>
        <source>SAFE</source>
        <translation>SEGURO</translation>
    </message>
    <message>
        <source>ARMED</source>
        <translation>ARMADO</translation>
    </message>
    <message>
        <source>MOVING</source>
        <translation>EN MARCHA</translation>
    </message>
    <message>
        <source>STOPPED</source>
        <translation>PARADO</translation>
    </message>
    <message>
        <source>STOPPING</source>
        <translation>PARANDO</translation>
    </message>
    <message>
        <source>MAY STILL TURN</source>
        <translation>¿SIGUE GIRANDO?</translation>
    </message>
    <message>
        <source>keep holding</source>
        <translation>siga pulsando</translation>
    </message>
    <message>
        <source>hold to arm</source>
        <translation>mantener: armar</translation>
    </message>
    <message>
        <source>nothing to arm</source>
        <translation>nada que armar</translation>
    </message>
    <message>
        <source>hold to re-arm</source>
        <translation>mantener: rearmar</translation>
    </message>
    <message>
        <source>cut its power</source>
        <translation>corte su alimentación</translation>
    </message>
    <message>
        <source>#88 velocity</source>
        <translation>#88 velocidad</translation>
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
        <translation>carga %1</translation>
    </message>
    <message>
        <source>lost %1</source>
        <translation>perdidas %1</translation>
    </message>
    <message>
        <source>Link %1: %2</source>
        <translation>Enlace %1: %2</translation>
    </message>
</context>
<context>
    <name>mb::LinkOptions</name>
    <message>
        <source>Bit rate</source>
        <translation>Velocidad en bits</translation>
    </message>
    <message>
        <source>find it: all rates of the protocol</source>
        <translation>buscarla: todas las del protocolo</translation>
    </message>
    <message>
        <source>%1 bit/s</source>
        <translation>%1 bit/s</translation>
    </message>
    <message>
        <source>the computer&apos;s own RS-485 port</source>
        <translation>puerto RS-485 propio del ordenador</translation>
    </message>
    <message>
        <source>RS-485</source>
        <translation>RS-485</translation>
    </message>
    <message>
        <source>Lets the kernel switch the driver of a port on the computer&apos;s board. Adapters on USB switch by themselves: leave it off.</source>
        <translation>Deja que el núcleo conmute el transmisor de un puerto de la placa del ordenador. Los adaptadores USB conmutan solos: déjelo desactivado.</translation>
    </message>
    <message>
        <source>Clock</source>
        <translation>Reloj</translation>
    </message>
    <message>
        <source>%1 kHz</source>
        <translation>%1 kHz</translation>
    </message>
    <message>
        <source>Ready line (SRDY)</source>
        <translation>Línea de listo (SRDY)</translation>
    </message>
    <message>
        <source>Reset line (MCLR)</source>
        <translation>Línea de reset (MCLR)</translation>
    </message>
    <message>
        <source>Lost frames</source>
        <translation>Tramas perdidas</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguna</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>not wired</source>
        <translation>sin cablear</translation>
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
        <translation>%1, proceso %2</translation>
    </message>
    <message>
        <source>%1 has this link too. Agree who drives: two masters on one motor disturb each other.</source>
        <translation>%1 también tiene este enlace. Acuerden quién acciona: dos maestros en un motor se estorban.</translation>
    </message>
    <message>
        <source>%1 has this port. Close it there, then reconnect.</source>
        <translation>%1 tiene este puerto. Ciérrelo allí y reconecte.</translation>
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
        <translation>Límites y pines</translation>
    </message>
    <message>
        <source>no limit holds</source>
        <translation>ningún límite actúa</translation>
    </message>
</context>
<context>
    <name>mb::LogPage</name>
    <message>
        <source>Log</source>
        <translation>Registro</translation>
    </message>
    <message>
        <source>Search the log</source>
        <translation>Buscar en el registro</translation>
    </message>
    <message>
        <source>Severity</source>
        <translation>Gravedad</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Todas</translation>
    </message>
    <message>
        <source>Cautions</source>
        <translation>Advertencias</translation>
    </message>
    <message>
        <source>Faults</source>
        <translation>Fallos</translation>
    </message>
    <message>
        <source>Save log…</source>
        <translation>Guardar registro…</translation>
    </message>
    <message>
        <source>Nothing yet</source>
        <translation>Aún nada</translation>
    </message>
    <message>
        <source>Actions and faults appear here.</source>
        <translation>Las acciones y los fallos aparecen aquí.</translation>
    </message>
    <message>
        <source>Log lines</source>
        <translation>Líneas del registro</translation>
    </message>
    <message>
        <source>Save the log</source>
        <translation>Guardar el registro</translation>
    </message>
    <message>
        <source>Text (*.log *.txt)</source>
        <translation>Texto (*.log *.txt)</translation>
    </message>
    <message>
        <source>log saved to %1</source>
        <translation>registro guardado en %1</translation>
    </message>
    <message>
        <source>searches</source>
        <translation>busca</translation>
    </message>
</context>
<context>
    <name>mb::MainWindow</name>
    <message>
        <source>lost</source>
        <translation>perdido</translation>
    </message>
    <message>
        <source>%1: %2 frames received, %3 sent, %4 dropped, %5 errors</source>
        <translation>%1: %2 tramas recibidas, %3 enviadas, %4 descartadas, %5 errores</translation>
    </message>
    <message>
        <source>%1: %2 bytes received, %3 sent, %4 dropped, %5 errors</source>
        <translation>%1: %2 bytes recibidos, %3 enviados, %4 descartados, %5 errores</translation>
    </message>
    <message>
        <source>REC %1</source>
        <translation>REC %1</translation>
    </message>
    <message>
        <source>MotorBench</source>
        <translation>MotorBench</translation>
    </message>
    <message>
        <source>button</source>
        <translation>botón</translation>
    </message>
    <message>
        <source>Overview</source>
        <translation>Resumen</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parámetros</translation>
    </message>
    <message>
        <source>Tune</source>
        <translation>Ajuste</translation>
    </message>
    <message>
        <source>Design</source>
        <translation>Diseño</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Gráficas</translation>
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
        <translation>Registro</translation>
    </message>
    <message>
        <source>Reports</source>
        <translation>Informes</translation>
    </message>
    <message>
        <source>needs a device; open a link first</source>
        <translation>necesita un dispositivo; abra antes un enlace</translation>
    </message>
    <message>
        <source>simulated bench</source>
        <translation>banco simulado</translation>
    </message>
    <message>
        <source>the window lost the focus</source>
        <translation>la ventana perdió el foco</translation>
    </message>
    <message>
        <source>The preferences hold as soon as nothing is armed, no job runs and no other window is open.</source>
        <translation>Las preferencias se aplican en cuanto nada esté armado, no haya ningún proceso en marcha ni otra ventana abierta.</translation>
    </message>
    <message>
        <source>the limits were not kept: %1</source>
        <translation>los límites no se conservaron: %1</translation>
    </message>
</context>
<context>
    <name>mb::MetricsPanel</name>
    <message>
        <source>Metrics</source>
        <translation>Índices</translation>
    </message>
    <message>
        <source>Metrics of A and B</source>
        <translation>Índices de A y B</translation>
    </message>
    <message>
        <source>Loop health</source>
        <translation>Estado del lazo</translation>
    </message>
    <message>
        <source>metric</source>
        <translation>índice</translation>
    </message>
    <message>
        <source>Δ B − A</source>
        <comment>difference</comment>
        <translation>Δ B − A</translation>
    </message>
    <message>
        <source>± from %1 repeats</source>
        <translation>± de %1 repeticiones</translation>
    </message>
    <message>
        <source>%1= same</source>
        <translation>%1= igual</translation>
    </message>
    <message>
        <source>SAT %1 %</source>
        <translation>SAT %1 %</translation>
    </message>
    <message>
        <source>Share of the hold in which the duty was at its limit</source>
        <translation>Fracción de la espera en que el ciclo estuvo en su límite</translation>
    </message>
    <message>
        <source>ILIM</source>
        <translation>ILIM</translation>
    </message>
    <message>
        <source>The current was at its limit</source>
        <translation>La corriente estuvo en su límite</translation>
    </message>
    <message>
        <source>RAMP</source>
        <translation>RAMPA</translation>
    </message>
    <message>
        <source>The drive&apos;s own ramp was on</source>
        <translation>Actuó la rampa propia del controlador</translation>
    </message>
    <message>
        <source>LIMIT SW</source>
        <translation>FIN CARR</translation>
    </message>
    <message>
        <source>A limit switch was met</source>
        <translation>Se alcanzó un final de carrera</translation>
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
        <translation>El ciclo estuvo en su límite mientras I seguía; eso se paga como sobreimpulso</translation>
    </message>
    <message>
        <source>QUANT</source>
        <translation>CUANT</translation>
    </message>
    <message>
        <source>The step has few counts of the encoder</source>
        <translation>El escalón tiene pocas cuentas del encoder</translation>
    </message>
    <message>
        <source>LOST %1</source>
        <translation>PERD %1</translation>
    </message>
    <message>
        <source>Samples that are missing</source>
        <translation>Muestras que faltan</translation>
    </message>
    <message>
        <source>SIMULATED</source>
        <translation>SIMULADO</translation>
    </message>
    <message>
        <source>Made on a simulated controller, and marked so for ever</source>
        <translation>Hecho en un controlador simulado, y marcado así para siempre</translation>
    </message>
    <message>
        <source>means of %1 repeats</source>
        <translation>medias de %1 repeticiones</translation>
    </message>
    <message>
        <source>%1= same ±%2</source>
        <translation>%1= igual ±%2</translation>
    </message>
</context>
<context>
    <name>mb::ModePanel</name>
    <message>
        <source>Mode</source>
        <translation>Modo</translation>
    </message>
    <message>
        <source>%1 mode</source>
        <translation>Modo %1</translation>
    </message>
</context>
<context>
    <name>mb::ModelPanel</name>
    <message>
        <source>Model</source>
        <translation>Modelo</translation>
    </message>
    <message>
        <source>Nobody has identified this motor yet. Identify pushes it both ways with a part of the duty, inside the limits below, and changes no gain.</source>
        <translation>Nadie ha identificado aún este motor. Identificar lo empuja en ambos sentidos con una parte del ciclo, dentro de los límites de abajo, y no cambia ninguna ganancia.</translation>
    </message>
    <message>
        <source>good fit</source>
        <translation>buen ajuste</translation>
    </message>
    <message>
        <source>not believed</source>
        <translation>no fiable</translation>
    </message>
    <message>
        <source>counts/s</source>
        <translation>counts/s</translation>
    </message>
    <message>
        <source>velocity filter</source>
        <translation>filtro de velocidad</translation>
    </message>
    <message>
        <source>All figures</source>
        <translation>Todos los valores</translation>
    </message>
    <message>
        <source>Fold</source>
        <translation>Plegar</translation>
    </message>
</context>
<context>
    <name>mb::MotionTour</name>
    <message>
        <source>acceleration</source>
        <translation>aceleración</translation>
    </message>
    <message>
        <source>counts/s²</source>
        <translation>counts/s²</translation>
    </message>
    <message>
        <source>at speed</source>
        <translation>a velocidad</translation>
    </message>
</context>
<context>
    <name>mb::MotionWords</name>
    <message>
        <source>%1 axes</source>
        <translation>%1 ejes</translation>
    </message>
    <message>
        <source>axis %1 %2</source>
        <translation>eje %1 %2</translation>
    </message>
    <message>
        <source>%1 on the adapter before</source>
        <translation>%1 en el adaptador anterior</translation>
    </message>
</context>
<context>
    <name>mb::MovesPanel</name>
    <message>
        <source>Moves together</source>
        <translation>Movimientos conjuntos</translation>
    </message>
    <message>
        <source>to a position</source>
        <translation>a una posición</translation>
    </message>
    <message>
        <source>by a distance</source>
        <translation>una distancia</translation>
    </message>
    <message>
        <source>at a velocity</source>
        <translation>a una velocidad</translation>
    </message>
    <message>
        <source>Kind of the moves</source>
        <translation>Tipo de los movimientos</translation>
    </message>
    <message>
        <source>profiled</source>
        <translation>con perfil</translation>
    </message>
    <message>
        <source>With the stored acceleration and velocity</source>
        <translation>Con la aceleración y la velocidad guardadas</translation>
    </message>
    <message>
        <source>With the acceleration and velocity that are stored in the device.</source>
        <translation>Con la aceleración y la velocidad guardadas en el dispositivo.</translation>
    </message>
    <message>
        <source>Prepare</source>
        <translation>Preparar</translation>
    </message>
    <message>
        <source>Switches the motors on where they stand, and gives each its move to keep.</source>
        <translation>Enciende los motores donde están y da a cada uno el movimiento que debe retener.</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Iniciar</translation>
    </message>
    <message>
        <source>Start the prepared moves together</source>
        <translation>Iniciar juntos los movimientos preparados</translation>
    </message>
    <message>
        <source>One command on the line starts all prepared moves at the same moment.</source>
        <translation>Una orden en la línea inicia en el mismo instante todos los movimientos preparados.</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>Retener</translation>
    </message>
    <message>
        <source>Hold all of them where they are</source>
        <translation>Retener todos donde están</translation>
    </message>
    <message>
        <source>Brakes to a halt and holds the position. The motors stay on; STOP switches them off.</source>
        <translation>Frena hasta parar y mantiene la posición. Los motores siguen encendidos; STOP los apaga.</translation>
    </message>
    <message>
        <source>%1 takes part</source>
        <translation>%1 participa</translation>
    </message>
    <message>
        <source>Target of %1</source>
        <translation>Destino de %1</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>sin respuesta</translation>
    </message>
    <message>
        <source>started</source>
        <translation>iniciado</translation>
    </message>
    <message>
        <source>prepared</source>
        <translation>preparado</translation>
    </message>
    <message>
        <source>being prepared</source>
        <translation>preparando</translation>
    </message>
    <message>
        <source>moving</source>
        <translation>en movimiento</translation>
    </message>
    <message>
        <source>keeps a move</source>
        <translation>retiene un movimiento</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>bloqueado</translation>
    </message>
    <message>
        <source>off</source>
        <translation>apagado</translation>
    </message>
    <message>
        <source>All are prepared. Start begins them at the same moment.</source>
        <translation>Todos están preparados. Iniciar los arranca en el mismo instante.</translation>
    </message>
    <message>
        <source>Stop takes no move away that has not begun: %1 would begin it with the next start on this line. Prepare gives a new one; switching the unit off clears it.</source>
        <translation>Parar no anula un movimiento que no ha empezado: %1 lo iniciaría con el próximo arranque en esta línea. Preparar da uno nuevo; apagar el equipo lo borra.</translation>
    </message>
    <message>
        <source>Hold the Arm button. It covers all that take part.</source>
        <translation>Mantenga pulsado el botón Armar. Vale para todos los que participan.</translation>
    </message>
    <message>
        <source>Prepare switches the motors on where they stand; nothing turns before Start.</source>
        <translation>Preparar enciende los motores donde están; nada gira antes de Iniciar.</translation>
    </message>
    <message>
        <source>not prepared: &apos;%1&apos; is no number of counts</source>
        <translation>no preparado: «%1» no es un número de cuentas</translation>
    </message>
</context>
<context>
    <name>mb::NoticeModel</name>
    <message>
        <source>time</source>
        <translation>hora</translation>
    </message>
    <message>
        <source>device</source>
        <translation>dispositivo</translation>
    </message>
    <message>
        <source>what</source>
        <translation>qué</translation>
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
        <translation>Resumen</translation>
    </message>
    <message>
        <source>load</source>
        <translation>carga</translation>
    </message>
    <message>
        <source>errors</source>
        <translation>errores</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>perdido</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>desconocido</translation>
    </message>
    <message>
        <source>Frames received that no controller family knows: somebody else&apos;s traffic</source>
        <translation>Tramas recibidas que ninguna familia de controladores conoce: tráfico ajeno</translation>
    </message>
    <message>
        <source>round trip</source>
        <translation>ida y vuelta</translation>
    </message>
    <message>
        <source>Load of the last minute</source>
        <translation>Carga del último minuto</translation>
    </message>
</context>
<context>
    <name>mb::OwnProposal</name>
    <message>
        <source>own</source>
        <translation>propia</translation>
    </message>
    <message>
        <source>Own proposal</source>
        <translation>Propuesta propia</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Velocidad</translation>
    </message>
    <message>
        <source>calm</source>
        <translation>suave</translation>
    </message>
    <message>
        <source>brisk</source>
        <translation>rápido</translation>
    </message>
    <message>
        <source>Damping</source>
        <translation>Amortiguamiento</translation>
    </message>
    <message>
        <source>robust</source>
        <translation>robusto</translation>
    </message>
    <message>
        <source>lively</source>
        <translation>vivo</translation>
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
        <translation>El dispositivo no admite este juego: %1</translation>
    </message>
    <message>
        <source>Held at τc %1 by: %2</source>
        <translation>Retenido en τc %1 por: %2</translation>
    </message>
    <message>
        <source>proposal %1</source>
        <translation>propuesta %1</translation>
    </message>
</context>
<context>
    <name>mb::PageKeys</name>
    <message>
        <source>Keys: %1</source>
        <translation>Teclas: %1</translation>
    </message>
    <message>
        <source>Everywhere</source>
        <translation>En todas partes</translation>
    </message>
</context>
<context>
    <name>mb::PageMap</name>
    <message>
        <source>Flash pages</source>
        <translation>Páginas de flash</translation>
    </message>
    <message>
        <source>%1 of %2 pages written</source>
        <translation>%1 de %2 páginas escritas</translation>
    </message>
    <message>
        <source> · must not be interrupted</source>
        <translation> · no debe interrumpirse</translation>
    </message>
    <message>
        <source>page %1: waiting</source>
        <translation>página %1: en espera</translation>
    </message>
    <message>
        <source>page %1: being written</source>
        <translation>página %1: escribiendo</translation>
    </message>
    <message>
        <source>page %1: written after it was sent again</source>
        <translation>página %1: escrita tras reenviarla</translation>
    </message>
    <message>
        <source>page %1: written</source>
        <translation>página %1: escrita</translation>
    </message>
    <message>
        <source>page %1: sent again</source>
        <translation>página %1: reenviada</translation>
    </message>
    <message>
        <source>page %1: not in the image</source>
        <translation>página %1: no está en la imagen</translation>
    </message>
</context>
<context>
    <name>mb::PageStack</name>
    <message>
        <source>Pages</source>
        <translation>Páginas</translation>
    </message>
</context>
<context>
    <name>mb::PageTabs</name>
    <message>
        <source>Pages</source>
        <translation>Páginas</translation>
    </message>
</context>
<context>
    <name>mb::ParameterCommands</name>
    <message>
        <source>What was written before it is in force; the rest is still staged. Nothing was stored.</source>
        <translation>Lo escrito antes está vigente; el resto sigue pendiente. No se guardó nada.</translation>
    </message>
    <message>
        <source>Nothing is proved to be in flash. Store again, and keep power on.</source>
        <translation>No hay prueba de que algo esté en flash. Guarde de nuevo y mantenga la alimentación.</translation>
    </message>
    <message>
        <source>Nothing is kept.</source>
        <translation>No se conservó nada.</translation>
    </message>
    <message>
        <source>What was written before it is in force. Undo takes it back.</source>
        <translation>Lo escrito antes está vigente. Deshacer lo devuelve.</translation>
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
        <translation>Qué hace el parámetro</translation>
    </message>
    <message>
        <source>%1 edited</source>
        <translation>%1 editados</translation>
    </message>
    <message>
        <source>%1 out of range</source>
        <translation>%1 fuera de rango</translation>
    </message>
    <message>
        <source>%1 without answer</source>
        <translation>%1 sin respuesta</translation>
    </message>
    <message>
        <source>%1 in RAM</source>
        <translation>%1 en RAM</translation>
    </message>
    <message>
        <source>%1 stored</source>
        <translation>%1 guardados</translation>
    </message>
    <message>
        <source>%1 assumed</source>
        <translation>%1 supuestos</translation>
    </message>
    <message>
        <source>%1 not persistent</source>
        <translation>%1 no persistentes</translation>
    </message>
    <message>
        <source>Choose a parameter to see what it does.</source>
        <translation>Elija un parámetro para ver qué hace.</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1.</translation>
    </message>
    <message>
        <source>↑↓ row · Enter edit · %1 write</source>
        <translation>↑↓ fila · Intro editar · %1 escribir</translation>
    </message>
</context>
<context>
    <name>mb::ParameterGroups</name>
    <message>
        <source>1 parameter</source>
        <translation>1 parámetro</translation>
    </message>
    <message>
        <source>%1 parameters</source>
        <translation>%1 parámetros</translation>
    </message>
    <message>
        <source>not kept over a power cycle</source>
        <translation>no se conserva al apagar</translation>
    </message>
    <message>
        <source>%1 not kept over a power cycle</source>
        <translation>%1 no se conservan al apagar</translation>
    </message>
</context>
<context>
    <name>mb::ParameterHead</name>
    <message>
        <source>Undo the last edit or write</source>
        <translation>Deshacer la última edición o escritura</translation>
    </message>
    <message>
        <source>Redo the edit or write</source>
        <translation>Rehacer la edición o escritura</translation>
    </message>
    <message>
        <source>Read all</source>
        <translation>Leer todo</translation>
    </message>
    <message>
        <source>Import…</source>
        <translation>Importar…</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportar…</translation>
    </message>
    <message>
        <source>Snapshot</source>
        <translation>Instantánea</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Historial</translation>
    </message>
    <message>
        <source>More for the parameters</source>
        <translation>Más para los parámetros</translation>
    </message>
</context>
<context>
    <name>mb::ParameterHeader</name>
    <message>
        <source>Columns</source>
        <translation>Columnas</translation>
    </message>
</context>
<context>
    <name>mb::ParameterModel</name>
    <message>
        <source>edited, was %1</source>
        <translation>editado, era %1</translation>
    </message>
    <message>
        <source>unknown until written</source>
        <translation>desconocido hasta escribirlo</translation>
    </message>
    <message>
        <source>default</source>
        <translation>predeterminado</translation>
    </message>
    <message>
        <source>edited, was unknown</source>
        <translation>editado, era desconocido</translation>
    </message>
    <message>
        <source>no answer, retry</source>
        <translation>sin respuesta, reintentar</translation>
    </message>
    <message>
        <source>not read</source>
        <translation>sin leer</translation>
    </message>
    <message>
        <source>from a file</source>
        <translation>de un archivo</translation>
    </message>
    <message>
        <source>Can only be read.</source>
        <translation>Solo lectura.</translation>
    </message>
    <message>
        <source>Is cleared with the faults, not by writing.</source>
        <translation>Se borra con los fallos, no escribiendo.</translation>
    </message>
    <message>
        <source>%1, default %2</source>
        <translation>%1, predeterminado %2</translation>
    </message>
    <message>
        <source>%1 is 100 %</source>
        <translation>%1 es 100 %</translation>
    </message>
    <message>
        <source>Not kept over a power cycle.</source>
        <translation>No se conserva al apagar.</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>parameter</source>
        <translation>parámetro</translation>
    </message>
    <message>
        <source>key</source>
        <translation>clave</translation>
    </message>
    <message>
        <source>value</source>
        <translation>valor</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>unidad</translation>
    </message>
    <message>
        <source>state</source>
        <translation>estado</translation>
    </message>
    <message>
        <source>raw</source>
        <translation>bruto</translation>
    </message>
</context>
<context>
    <name>mb::ParameterTools</name>
    <message>
        <source>Search parameters</source>
        <translation>Buscar parámetros</translation>
    </message>
    <message>
        <source>Which parameters</source>
        <translation>Qué parámetros</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Todas</translation>
    </message>
    <message>
        <source>Changed</source>
        <translation>Modificados</translation>
    </message>
    <message>
        <source>Edited</source>
        <translation>Editados</translation>
    </message>
    <message>
        <source>Errors</source>
        <translation>Errores</translation>
    </message>
    <message>
        <source>All %1</source>
        <translation>Todos %1</translation>
    </message>
    <message>
        <source>Changed %1</source>
        <translation>Modificados %1</translation>
    </message>
    <message>
        <source>Edited %1</source>
        <translation>Editados %1</translation>
    </message>
    <message>
        <source>Errors %1</source>
        <translation>Errores %1</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
</context>
<context>
    <name>mb::ParameterView</name>
    <message>
        <source>Parameters</source>
        <translation>Parámetros</translation>
    </message>
    <message>
        <source>Copy as key=value</source>
        <translation>Copiar como key=value</translation>
    </message>
    <message>
        <source>Revert the edit</source>
        <translation>Revertir la edición</translation>
    </message>
    <message>
        <source>Set to the default, %1</source>
        <translation>Poner el predeterminado, %1</translation>
    </message>
</context>
<context>
    <name>mb::ParametersPage</name>
    <message>
        <source>Open a parameter file…</source>
        <translation>Abrir un archivo de parámetros…</translation>
    </message>
    <message>
        <source>Open a parameter file</source>
        <translation>Abrir un archivo de parámetros</translation>
    </message>
    <message>
        <source>Import parameters</source>
        <translation>Importar parámetros</translation>
    </message>
    <message>
        <source>Export parameters</source>
        <translation>Exportar parámetros</translation>
    </message>
    <message>
        <source>reads all parameters</source>
        <translation>lee todos los parámetros</translation>
    </message>
    <message>
        <source>searches</source>
        <translation>busca</translation>
    </message>
    <message>
        <source>writes what is staged</source>
        <translation>escribe lo pendiente</translation>
    </message>
    <message>
        <source>undoes the last edit, or else the last write to the unit</source>
        <translation>deshace la última edición o, si no la hay, la última escritura en el equipo</translation>
    </message>
    <message>
        <source>shows the history of the unit, or its values</source>
        <translation>muestra el historial del equipo o sus valores</translation>
    </message>
    <message>
        <source>Select a device</source>
        <translation>Seleccione un dispositivo</translation>
    </message>
    <message>
        <source>Its parameters appear here. A parameter file can be looked at and compared without a device.</source>
        <translation>Aquí aparecen sus parámetros. Un archivo de parámetros se puede ver y comparar sin dispositivo.</translation>
    </message>
    <message>
        <source>No parameters in the bootloader</source>
        <translation>Sin parámetros en el bootloader</translation>
    </message>
    <message>
        <source>%1 has no application running. Write firmware to it, then its parameters can be read.</source>
        <translation>%1 no ejecuta ninguna aplicación. Escriba firmware en él; después se podrán leer sus parámetros.</translation>
    </message>
    <message>
        <source>No parameters</source>
        <translation>Sin parámetros</translation>
    </message>
    <message>
        <source>%1 has none.</source>
        <translation>%1 no tiene ninguno.</translation>
    </message>
    <message>
        <source>Compare with a parameter file</source>
        <translation>Comparar con un archivo de parámetros</translation>
    </message>
    <message>
        <source>redoes the last edit or write</source>
        <translation>rehace la última edición o escritura</translation>
    </message>
</context>
<context>
    <name>mb::PdfText</name>
    <message>
        <source>page %1 of %2</source>
        <translation>página %1 de %2</translation>
    </message>
    <message>
        <source>DEMO, a simulated unit</source>
        <translation>DEMO, un equipo simulado</translation>
    </message>
</context>
<context>
    <name>mb::PlotBoard</name>
    <message>
        <source>DEMO</source>
        <translation>DEMO</translation>
    </message>
    <message>
        <source>REPLAY</source>
        <translation>REPRODUCCIÓN</translation>
    </message>
    <message>
        <source>%1 signals, %2 samples/s, %3 of %4 lost</source>
        <translation>%1 señales, %2 muestras/s, %3 de %4 perdidas</translation>
    </message>
    <message>
        <source>ref %1</source>
        <translation>ref. %1</translation>
    </message>
</context>
<context>
    <name>mb::PlotExport</name>
    <message>
        <source>Export plot</source>
        <translation>Exportar gráfica</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>Copiar imagen</translation>
    </message>
    <message>
        <source>Copy numbers</source>
        <translation>Copiar números</translation>
    </message>
    <message>
        <source>Copy summary</source>
        <translation>Copiar resumen</translation>
    </message>
    <message>
        <source>Export PNG…</source>
        <translation>Exportar PNG…</translation>
    </message>
    <message>
        <source>PNG picture (*.png)</source>
        <translation>Imagen PNG (*.png)</translation>
    </message>
    <message>
        <source>Export SVG…</source>
        <translation>Exportar SVG…</translation>
    </message>
    <message>
        <source>SVG drawing (*.svg)</source>
        <translation>Dibujo SVG (*.svg)</translation>
    </message>
    <message>
        <source>Export PDF…</source>
        <translation>Exportar PDF…</translation>
    </message>
    <message>
        <source>PDF document (*.pdf)</source>
        <translation>Documento PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Export CSV…</source>
        <translation>Exportar CSV…</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tabla (*.csv)</translation>
    </message>
</context>
<context>
    <name>mb::PlotLayoutBook</name>
    <message>
        <source>Save layout</source>
        <translation>Guardar disposición</translation>
    </message>
    <message>
        <source>Save layout as…</source>
        <translation>Guardar disposición como…</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Restablecer</translation>
    </message>
    <message>
        <source>Begin like this with every %1</source>
        <translation>Empezar así con cada %1</translation>
    </message>
    <message>
        <source>Begin with the usual for every %1</source>
        <translation>Empezar como de costumbre con cada %1</translation>
    </message>
</context>
<context>
    <name>mb::PlotScrubber</name>
    <message>
        <source>Whole session</source>
        <translation>Toda la sesión</translation>
    </message>
    <message>
        <source>The whole session: drag the box or click to scroll back, End returns to the present.
The recording goes on meanwhile.</source>
        <translation>Toda la sesión: arrastre el recuadro o haga clic para retroceder; Fin vuelve al presente.
La grabación continúa mientras tanto.</translation>
    </message>
</context>
<context>
    <name>mb::PlotStack</name>
    <message>
        <source>Plot</source>
        <translation>Gráfica</translation>
    </message>
    <message>
        <source>Pause view	P</source>
        <translation>Pausar la vista	P</translation>
    </message>
    <message>
        <source>Back to live	P</source>
        <translation>Volver a en vivo	P</translation>
    </message>
    <message>
        <source>Fit time and value	0</source>
        <translation>Encajar tiempo y valor	0</translation>
    </message>
    <message>
        <source>Cursors A and B	L</source>
        <translation>Cursores A y B	L</translation>
    </message>
</context>
<context>
    <name>mb::PlotsBar</name>
    <message>
        <source>window %1 ms</source>
        <translation>ventana %1 ms</translation>
    </message>
    <message>
        <source>window %1 s</source>
        <translation>ventana %1 s</translation>
    </message>
    <message>
        <source>window %1 min</source>
        <translation>ventana %1 min</translation>
    </message>
    <message>
        <source>window %1 h</source>
        <translation>ventana %1 h</translation>
    </message>
    <message>
        <source>Pause view</source>
        <translation>Pausar la vista</translation>
    </message>
    <message>
        <source>Follow live</source>
        <translation>Seguir en vivo</translation>
    </message>
    <message>
        <source>The recording goes on.</source>
        <translation>La grabación continúa.</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vista</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tiempo</translation>
    </message>
    <message>
        <source>X-Y</source>
        <translation>X-Y</translation>
    </message>
    <message>
        <source>Spectrum</source>
        <translation>Espectro</translation>
    </message>
    <message>
        <source>Against time, one signal against another, or amplitude against frequency of what is seen or of A … B</source>
        <translation>Frente al tiempo, una señal frente a otra o amplitud frente a frecuencia de lo visible o de A … B</translation>
    </message>
    <message>
        <source>Length of the time axis</source>
        <translation>Longitud del eje de tiempo</translation>
    </message>
    <message>
        <source>Trigger: stands still at an edge or a level</source>
        <translation>Disparo: se detiene en un flanco o un nivel</translation>
    </message>
    <message>
        <source>Cursors A and B</source>
        <translation>Cursores A y B</translation>
    </message>
    <message>
        <source>Fit time and value</source>
        <translation>Encajar tiempo y valor</translation>
    </message>
    <message>
        <source>Keep what is seen as a reference</source>
        <translation>Conservar lo visible como referencia</translation>
    </message>
    <message>
        <source>Layouts: save, restore, reset</source>
        <translation>Disposiciones: guardar, restaurar, restablecer</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportar</translation>
    </message>
    <message>
        <source>The picture as PNG, SVG or PDF; samples as CSV or MCAP</source>
        <translation>La imagen como PNG, SVG o PDF; las muestras como CSV o MCAP</translation>
    </message>
</context>
<context>
    <name>mb::PlotsPage</name>
    <message>
        <source>No device yet</source>
        <translation>Aún no hay dispositivos</translation>
    </message>
    <message>
        <source>Open a link, or the simulated bench from the menu; its signals appear here.</source>
        <translation>Abra un enlace, o el banco simulado desde el menú; sus señales aparecen aquí.</translation>
    </message>
    <message>
        <source>Wheel zooms time, Ctrl+wheel values, Shift+wheel moves · drag moves · Shift+drag zooms into a box
double click or End returns to the present · right click for more</source>
        <translation>La rueda amplía el tiempo, Ctrl+rueda los valores, Mayús+rueda desplaza · arrastrar desplaza · Mayús+arrastrar amplía un recuadro
doble clic o Fin vuelve al presente · clic derecho para más</translation>
    </message>
    <message>
        <source>Nothing is plotted</source>
        <translation>No hay nada representado</translation>
    </message>
    <message>
        <source>Double click a signal in the list at the right or under a device at the left, or drag it here.</source>
        <translation>Haga doble clic en una señal de la lista de la derecha o bajo un dispositivo a la izquierda, o arrástrela aquí.</translation>
    </message>
    <message>
        <source>plot written to %1</source>
        <translation>gráfica escrita en %1</translation>
    </message>
    <message>
        <source>pauses the plots, and goes on</source>
        <translation>pausa las gráficas y las reanuda</translation>
    </message>
    <message>
        <source>fits time and value</source>
        <translation>encaja tiempo y valor</translation>
    </message>
    <message>
        <source>cursors: arrows move one, C changes to the other</source>
        <translation>cursores: las flechas mueven uno, C cambia al otro</translation>
    </message>
    <message>
        <source>watches for a trigger, or no more</source>
        <translation>vigila un disparo o deja de hacerlo</translation>
    </message>
    <message>
        <source>records, or ends the recording</source>
        <translation>graba o termina la grabación</translation>
    </message>
    <message>
        <source>in the plots: less or more time</source>
        <translation>en las gráficas: menos o más tiempo</translation>
    </message>
    <message>
        <source>in the plots: larger or smaller values</source>
        <translation>en las gráficas: valores más grandes o más pequeños</translation>
    </message>
    <message>
        <source>in the plots: writes a note at this time</source>
        <translation>en las gráficas: escribe una nota en este instante</translation>
    </message>
    <message>
        <source>Note at this time…	N</source>
        <translation>Nota en este instante…	N</translation>
    </message>
    <message>
        <source>Keep what is seen as a reference</source>
        <translation>Conservar lo visible como referencia</translation>
    </message>
    <message>
        <source>Remove references</source>
        <translation>Quitar referencias</translation>
    </message>
    <message>
        <source>Derived signal…</source>
        <translation>Señal derivada…</translation>
    </message>
    <message>
        <source>Spectrum of what is seen</source>
        <translation>Espectro de lo visible</translation>
    </message>
    <message>
        <source>X-Y</source>
        <translation>X-Y</translation>
    </message>
    <message>
        <source>Trigger: stands still at an edge or a level</source>
        <translation>Disparo: se detiene en un flanco o un nivel</translation>
    </message>
    <message>
        <source>Export samples…</source>
        <translation>Exportar muestras…</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>mb::Preferences</name>
    <message>
        <source>Preferences</source>
        <translation>Preferencias</translation>
    </message>
    <message>
        <source>dark</source>
        <translation>oscuro</translation>
    </message>
    <message>
        <source>light</source>
        <translation>claro</translation>
    </message>
    <message>
        <source>as the desktop</source>
        <translation>como el escritorio</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Nothing moves but data</source>
        <translation>Solo se mueven los datos</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Tema</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Idioma</translation>
    </message>
    <message>
        <source>Text size</source>
        <translation>Tamaño del texto</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Movimiento</translation>
    </message>
    <message>
        <source>Notebook, recordings</source>
        <translation>Cuaderno, grabaciones</translation>
    </message>
    <message>
        <source>Settings, layouts</source>
        <translation>Ajustes, disposiciones</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Abrir</translation>
    </message>
    <message>
        <source>Open the folder: %1</source>
        <translation>Abrir la carpeta: %1</translation>
    </message>
    <message>
        <source>General</source>
        <translation>General</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Teclas</translation>
    </message>
    <message>
        <source>high contrast</source>
        <translation>alto contraste</translation>
    </message>
    <message>
        <source>counts</source>
        <translation>counts</translation>
    </message>
    <message>
        <source>rpm and degrees</source>
        <translation>rpm y grados</translation>
    </message>
    <message>
        <source>With every verdict in production</source>
        <translation>Con cada veredicto en producción</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>Unidades</translation>
    </message>
    <message>
        <source>Sounds</source>
        <translation>Sonidos</translation>
    </message>
    <message>
        <source>Guardian</source>
        <translation>Vigilante</translation>
    </message>
</context>
<context>
    <name>mb::ProductionHead</name>
    <message>
        <source>recipe</source>
        <translation>receta</translation>
    </message>
    <message>
        <source>image</source>
        <translation>imagen</translation>
    </message>
    <message>
        <source>parameters</source>
        <translation>parámetros</translation>
    </message>
    <message>
        <source>number rule</source>
        <translation>regla de número</translation>
    </message>
    <message>
        <source>self-test</source>
        <translation>autoprueba</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>Salir</translation>
    </message>
    <message>
        <source>Link that units are put on</source>
        <translation>Enlace al que se conectan los equipos</translation>
    </message>
    <message>
        <source>Serial number, scanned or typed</source>
        <translation>Número de serie, escaneado o tecleado</translation>
    </message>
    <message>
        <source>Scan or type a serial number</source>
        <translation>Escanee o teclee un número de serie</translation>
    </message>
    <message>
        <source>Open recipe…</source>
        <translation>Abrir receta…</translation>
    </message>
    <message>
        <source>Hold to arm self-tests</source>
        <translation>Mantener: armar autopruebas</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Iniciar</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Terminar</translation>
    </message>
    <message>
        <source>No recipe yet</source>
        <translation>Aún no hay receta</translation>
    </message>
    <message>
        <source>ARMED, hold to disarm</source>
        <translation>ARMADO, mantener: desarmar</translation>
    </message>
    <message>
        <source>%1, not open</source>
        <translation>%1, no abierto</translation>
    </message>
</context>
<context>
    <name>mb::ProductionPage</name>
    <message>
        <source>Production</source>
        <translation>Producción</translation>
    </message>
    <message>
        <source>Last ten units</source>
        <translation>Últimos diez equipos</translation>
    </message>
    <message>
        <source>Sound</source>
        <translation>Sonido</translation>
    </message>
    <message>
        <source>Sound with every verdict</source>
        <translation>Sonido con cada veredicto</translation>
    </message>
    <message>
        <source>tests the last unit again</source>
        <translation>prueba de nuevo el último equipo</translation>
    </message>
    <message>
        <source>sets it aside, ready for the next</source>
        <translation>lo aparta, listo para el siguiente</translation>
    </message>
    <message>
        <source>Open recipe</source>
        <translation>Abrir receta</translation>
    </message>
    <message>
        <source>Recipes (*.json);;All files (*)</source>
        <translation>Recetas (*.json);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>The self-test turns the motor: %1</source>
        <translation>La autoprueba gira el motor: %1</translation>
    </message>
    <message>
        <source>not started: open a link first</source>
        <translation>no iniciado: abra antes un enlace</translation>
    </message>
    <message>
        <source>not started: open a recipe first</source>
        <translation>no iniciado: abra antes una receta</translation>
    </message>
    <message>
        <source>no unit here has the serial number %1</source>
        <translation>ningún equipo aquí tiene el número de serie %1</translation>
    </message>
    <message>
        <source>test again</source>
        <translation>probar de nuevo</translation>
    </message>
    <message>
        <source>set aside</source>
        <translation>apartar</translation>
    </message>
    <message>
        <source>serial number</source>
        <translation>número de serie</translation>
    </message>
    <message>
        <source>leave</source>
        <translation>salir</translation>
    </message>
    <message>
        <source>stops every motor</source>
        <translation>para todos los motores</translation>
    </message>
    <message>
        <source>not tested again: %1</source>
        <translation>no se vuelve a probar: %1</translation>
    </message>
</context>
<context>
    <name>mb::ProfileFields</name>
    <message>
        <source>Velocity</source>
        <translation>Velocidad</translation>
    </message>
    <message>
        <source>counts/s</source>
        <translation>counts/s</translation>
    </message>
    <message>
        <source>Velocity of the profile</source>
        <translation>Velocidad del perfil</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>Aceleración</translation>
    </message>
    <message>
        <source>counts/s²</source>
        <translation>counts/s²</translation>
    </message>
    <message>
        <source>Acceleration of the profile</source>
        <translation>Aceleración del perfil</translation>
    </message>
    <message>
        <source>The profile needs a velocity up to %1 counts/s.</source>
        <translation>El perfil necesita una velocidad de hasta %1 counts/s.</translation>
    </message>
    <message>
        <source>The profile needs an acceleration up to %1 counts/s²; 0 is none.</source>
        <translation>El perfil necesita una aceleración de hasta %1 counts/s²; 0 es ninguna.</translation>
    </message>
</context>
<context>
    <name>mb::ProfilePanel</name>
    <message>
        <source>What only you know</source>
        <translation>Lo que solo usted sabe</translation>
    </message>
    <message>
        <source>Dialect</source>
        <translation>Dialecto</translation>
    </message>
    <message>
        <source>How this unit is spoken to. The scan finds it out; choose another only if you know better.</source>
        <translation>Cómo se habla con este equipo. La búsqueda lo averigua; elija otro solo si lo sabe mejor.</translation>
    </message>
    <message>
        <source>dialect as found</source>
        <translation>dialecto detectado</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>desconocido</translation>
    </message>
    <message>
        <source>Speak another dialect?</source>
        <translation>¿Usar otro dialecto?</translation>
    </message>
    <message>
        <source>Speak to this unit as %1?</source>
        <translation>¿Hablar con este equipo como %1?</translation>
    </message>
    <message>
        <source>Speak it</source>
        <translation>Usarlo</translation>
    </message>
    <message>
        <source>dialect as found: %1</source>
        <translation>dialecto detectado: %1</translation>
    </message>
</context>
<context>
    <name>mb::ProgrammerBox</name>
    <message>
        <source>Programmer</source>
        <translation>Programador</translation>
    </message>
    <message>
        <source>What writes the flash: one of the list, or the name that the program gives to another</source>
        <translation>Lo que escribe la flash: uno de la lista o el nombre que el programa da a otro</translation>
    </message>
    <message>
        <source>Port of the programmer</source>
        <translation>Puerto del programador</translation>
    </message>
    <message>
        <source>Where the programmer, or the line to the bootloader, is plugged in</source>
        <translation>Dónde está conectado el programador o la línea hacia el bootloader</translation>
    </message>
    <message>
        <source>at</source>
        <translation>en</translation>
    </message>
    <message>
        <source>the device&apos;s own line</source>
        <translation>la línea propia del dispositivo</translation>
    </message>
    <message>
        <source>at USB</source>
        <translation>en USB</translation>
    </message>
    <message>
        <source>Choose a programmer</source>
        <translation>Elija un programador</translation>
    </message>
    <message>
        <source>No serial port is plugged in; choose or name the one of the programmer</source>
        <translation>No hay ningún puerto serie conectado; elija o indique el del programador</translation>
    </message>
</context>
<context>
    <name>mb::ProjectDesk</name>
    <message>
        <source>Save the machine into a folder</source>
        <translation>Guardar la máquina en una carpeta</translation>
    </message>
    <message>
        <source>Open the folder of a machine</source>
        <translation>Abrir la carpeta de una máquina</translation>
    </message>
    <message numerus="yes">
        <source>%n unit(s) saved into %1</source>
        <translation>
            <numerusform>%n equipo guardado en %1</numerusform>
            <numerusform>%n equipos guardados en %1</numerusform>
        </translation>
    </message>
    <message>
        <source>scales and limits of the project are in force</source>
        <translation>rigen las escalas y los límites del proyecto</translation>
    </message>
    <message>
        <source>dialect %1 of the folder is not in force: choose it in the inspector if that is what it speaks</source>
        <translation>el dialecto %1 de la carpeta no está en vigor: elíjalo en el inspector si es el que habla</translation>
    </message>
</context>
<context>
    <name>mb::ProposalCard</name>
    <message>
        <source>quiet, forgiving</source>
        <translation>tranquilo, tolerante</translation>
    </message>
    <message>
        <source>hardly overshoots</source>
        <translation>casi sin sobreimpulso</translation>
    </message>
    <message>
        <source>fastest rise</source>
        <translation>subida más rápida</translation>
    </message>
    <message>
        <source>Ms</source>
        <translation>Ms</translation>
    </message>
    <message>
        <source>calm</source>
        <translation>suave</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>normal</translation>
    </message>
    <message>
        <source>brisk</source>
        <translation>rápido</translation>
    </message>
    <message>
        <source>τc %1</source>
        <translation>τc %1</translation>
    </message>
    <message>
        <source>raw %1</source>
        <translation>bruto %1</translation>
    </message>
    <message>
        <source>%1 = 0</source>
        <translation>%1 = 0</translation>
    </message>
    <message>
        <source>Proposal: %1</source>
        <translation>Propuesta: %1</translation>
    </message>
    <message>
        <source>over</source>
        <translation>sobre</translation>
    </message>
    <message>
        <source>settle</source>
        <translation>estab.</translation>
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
        <translation>pico</translation>
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
        <translation>propia</translation>
    </message>
    <message>
        <source>Proposals</source>
        <translation>Propuestas</translation>
    </message>
    <message>
        <source>to be found anew</source>
        <translation>se buscarán de nuevo</translation>
    </message>
</context>
<context>
    <name>mb::QueueBar</name>
    <message>
        <source>State of the queue</source>
        <translation>Estado de la cola</translation>
    </message>
    <message>
        <source>Progress of the queue</source>
        <translation>Progreso de la cola</translation>
    </message>
    <message>
        <source>Pause after this unit</source>
        <translation>Pausar tras este equipo</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Continuar</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Retry failed</source>
        <translation>Repetir los no superados</translation>
    </message>
    <message>
        <source>Save CSV…</source>
        <translation>Guardar CSV…</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Iniciar</translation>
    </message>
    <message>
        <source>Ended before its time: %1</source>
        <translation>Terminó antes de tiempo: %1</translation>
    </message>
    <message>
        <source>Pauses after this unit</source>
        <translation>Se detiene tras este equipo</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>En pausa</translation>
    </message>
    <message>
        <source>Unit %1 of %2</source>
        <translation>Equipo %1 de %2</translation>
    </message>
    <message numerus="yes">
        <source>Ended with %n unit(s) to go</source>
        <translation>
            <numerusform>Terminado, falta %n equipo</numerusform>
            <numerusform>Terminado, faltan %n equipos</numerusform>
        </translation>
    </message>
    <message>
        <source>Ended: %1 of %2 units</source>
        <translation>Terminado: %1 de %2 equipos</translation>
    </message>
    <message>
        <source>Nothing running</source>
        <translation>Nada en curso</translation>
    </message>
    <message>
        <source>about %1 s left</source>
        <translation>quedan unos %1 s</translation>
    </message>
    <message>
        <source>%1 done</source>
        <translation>%1 hechos</translation>
    </message>
    <message>
        <source>%1 waiting</source>
        <translation>%1 en espera</translation>
    </message>
    <message>
        <source>%1 failed</source>
        <translation>%1 no superados</translation>
    </message>
    <message>
        <source>%1 refused</source>
        <translation>%1 rechazados</translation>
    </message>
    <message>
        <source>mean %1</source>
        <translation>media %1</translation>
    </message>
</context>
<context>
    <name>mb::QueueBoard</name>
    <message>
        <source>Go on with it</source>
        <translation>Continuar</translation>
    </message>
    <message>
        <source>A queue runs already.</source>
        <translation>Ya hay una cola en marcha.</translation>
    </message>
    <message>
        <source>Open an image or a recipe first.</source>
        <translation>Abra primero una imagen o una receta.</translation>
    </message>
    <message>
        <source>Tick the units first.</source>
        <translation>Marque primero los equipos.</translation>
    </message>
    <message>
        <source>Save what was done</source>
        <translation>Guardar lo que se hizo</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tabla (*.csv)</translation>
    </message>
    <message>
        <source>the units are in %1</source>
        <translation>los equipos están en %1</translation>
    </message>
    <message>
        <source>The last queue of this recipe was cut off: %1 done, %2 open</source>
        <translation>La última cola de esta receta se interrumpió: %1 hechos, %2 abiertos</translation>
    </message>
    <message>
        <source>What has ended stays as it is; ticked units are taken along.</source>
        <translation>Lo terminado queda como está; los equipos marcados se incluyen.</translation>
    </message>
    <message>
        <source>One unit at a time on a bus, buses side by side. Real units keep this computer awake. The journal is on disk: after a crash the queue goes on.</source>
        <translation>Un equipo a la vez por bus, los buses en paralelo. Los equipos reales mantienen despierto este ordenador. El diario está en disco: tras un fallo la cola continúa.</translation>
    </message>
    <message>
        <source>Every unit is backed up before and compared afterwards; the journal has it.</source>
        <translation>Cada equipo se guarda antes y se compara después; el diario lo recoge.</translation>
    </message>
    <message>
        <source>not tried again: %1</source>
        <translation>no se vuelve a intentar: %1</translation>
    </message>
    <message>
        <source>not tried again: it was served by %1; tick it and start</source>
        <translation>no se vuelve a intentar: se atendió con %1; márquelo e inicie</translation>
    </message>
    <message>
        <source>%1 waits until this queue has ended</source>
        <translation>%1 espera a que termine esta cola</translation>
    </message>
</context>
<context>
    <name>mb::QueueChecks</name>
    <message>
        <source>recipe checked</source>
        <translation>receta comprobada</translation>
    </message>
    <message>
        <source>no image, no recipe</source>
        <translation>sin imagen ni receta</translation>
    </message>
    <message>
        <source>all motors stopped</source>
        <translation>todos los motores parados</translation>
    </message>
    <message>
        <source>a motor is moving</source>
        <translation>un motor se mueve</translation>
    </message>
    <message>
        <source>no other master</source>
        <translation>ningún otro maestro</translation>
    </message>
    <message>
        <source>another master, or a number taken twice</source>
        <translation>otro maestro o número duplicado</translation>
    </message>
    <message>
        <source>bus %1 V</source>
        <translation>bus %1 V</translation>
    </message>
    <message>
        <source>bus voltage not known</source>
        <translation>tensión de bus desconocida</translation>
    </message>
    <message>
        <source>Before start</source>
        <translation>Antes de empezar</translation>
    </message>
</context>
<context>
    <name>mb::QueueHead</name>
    <message>
        <source>recipe</source>
        <translation>receta</translation>
    </message>
    <message>
        <source>image</source>
        <translation>imagen</translation>
    </message>
    <message>
        <source>parameters</source>
        <translation>parámetros</translation>
    </message>
    <message>
        <source>number rule</source>
        <translation>regla de números</translation>
    </message>
    <message>
        <source>Open image…</source>
        <translation>Abrir imagen…</translation>
    </message>
    <message>
        <source>Open recipe…</source>
        <translation>Abrir receta…</translation>
    </message>
    <message>
        <source>none yet</source>
        <translation>ninguna aún</translation>
    </message>
    <message>
        <source>Open a firmware image</source>
        <translation>Abrir una imagen de firmware</translation>
    </message>
    <message>
        <source>Intel HEX (*.hex *.ihex);;All files (*)</source>
        <translation>Intel HEX (*.hex *.ihex);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Open recipe</source>
        <translation>Abrir receta</translation>
    </message>
    <message>
        <source>Recipes (*.json);;All files (*)</source>
        <translation>Recetas (*.json);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Write a recipe</source>
        <translation>Escribir una receta</translation>
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
        <translation>número de serie</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>unidad</translation>
    </message>
    <message>
        <source>firmware</source>
        <translation>firmware</translation>
    </message>
    <message>
        <source>step</source>
        <translation>paso</translation>
    </message>
    <message>
        <source>progress</source>
        <translation>progreso</translation>
    </message>
    <message>
        <source>time</source>
        <translation>tiempo</translation>
    </message>
    <message>
        <source>result</source>
        <translation>resultado</translation>
    </message>
</context>
<context>
    <name>mb::QueueSide</name>
    <message>
        <source>The self-test turns the motor: %1. Hold Arm in the header once the queue runs.</source>
        <translation>La autoprueba hace girar el motor: %1. Mantenga Armar en la cabecera cuando la cola esté en marcha.</translation>
    </message>
</context>
<context>
    <name>mb::QueueTable</name>
    <message>
        <source>Every unit of this family</source>
        <translation>Todos los equipos de esta familia</translation>
    </message>
    <message>
        <source>Units of the queue</source>
        <translation>Equipos de la cola</translation>
    </message>
    <message>
        <source>Every %1</source>
        <translation>Todos los %1</translation>
    </message>
</context>
<context>
    <name>mb::QueueText</name>
    <message>
        <source>none</source>
        <translation>ninguna</translation>
    </message>
    <message>
        <source>verified</source>
        <translation>verificado</translation>
    </message>
    <message>
        <source>%1 parameters equal</source>
        <translation>%1 parámetros iguales</translation>
    </message>
    <message>
        <source>already %1</source>
        <translation>ya en %1</translation>
    </message>
    <message>
        <source>read back after the restart</source>
        <translation>releído tras el reinicio</translation>
    </message>
    <message>
        <source>safe to unplug, resumes</source>
        <translation>se puede desenchufar, continúa</translation>
    </message>
    <message>
        <source>do not unplug</source>
        <translation>no desenchufar</translation>
    </message>
    <message>
        <source>waiting</source>
        <translation>en espera</translation>
    </message>
    <message>
        <source>cut off, goes on</source>
        <translation>interrumpido, continúa</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>omitido</translation>
    </message>
    <message>
        <source>cut off</source>
        <translation>cortado</translation>
    </message>
    <message>
        <source>failed: %1</source>
        <translation>no superado: %1</translation>
    </message>
    <message>
        <source>refused before start</source>
        <translation>rechazado antes de empezar</translation>
    </message>
    <message>
        <source>number taken twice</source>
        <translation>número repetido</translation>
    </message>
    <message>
        <source>in its bootloader</source>
        <translation>en su bootloader</translation>
    </message>
    <message>
        <source>motor is moving</source>
        <translation>motor en movimiento</translation>
    </message>
    <message>
        <source>another master drives it</source>
        <translation>lo maneja otro maestro</translation>
    </message>
    <message>
        <source>Preflight</source>
        <translation>Comprobación previa</translation>
    </message>
    <message>
        <source>Backup</source>
        <translation>Copia</translation>
    </message>
    <message>
        <source>Firmware</source>
        <translation>Firmware</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parámetros</translation>
    </message>
    <message>
        <source>Self-test</source>
        <translation>Autoprueba</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Número</translation>
    </message>
    <message>
        <source>Comparison and proof</source>
        <translation>Comparación y prueba</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Hecho</translation>
    </message>
    <message>
        <source>hold Arm in the header</source>
        <translation>mantenga Armar en la cabecera</translation>
    </message>
    <message>
        <source>written, not proved</source>
        <translation>escrito, sin demostrar</translation>
    </message>
    <message>
        <source>answers with %1, as before</source>
        <translation>responde con %1, como antes</translation>
    </message>
</context>
<context>
    <name>mb::RamBlock</name>
    <message>
        <source>In RAM, not in flash</source>
        <translation>En RAM, no en flash</translation>
    </message>
    <message>
        <source>Time until the device stores by itself</source>
        <translation>Tiempo hasta que el dispositivo guarde por sí mismo</translation>
    </message>
    <message>
        <source>Store and prove</source>
        <translation>Guardar y verificar</translation>
    </message>
    <message>
        <source>%1 s to go</source>
        <translation>quedan %1 s</translation>
    </message>
    <message>
        <source>not proved</source>
        <translation>sin verificar</translation>
    </message>
    <message>
        <source>Read back and equal. Lost at power-off until it is stored.</source>
        <translation>Releído e igual. Se pierde al apagar hasta que se guarde.</translation>
    </message>
    <message>
        <source>Read back and equal. Do not cut power yet.</source>
        <translation>Releído e igual. No corte aún la alimentación.</translation>
    </message>
    <message>
        <source>%1 more.</source>
        <translation>%1 más.</translation>
    </message>
    <message>
        <source>The device should have stored by itself. Its own proof takes up to %1 s.</source>
        <translation>El dispositivo debería haber guardado por sí mismo. Su propia verificación tarda hasta %1 s.</translation>
    </message>
</context>
<context>
    <name>mb::ReadStatus</name>
    <message>
        <source>Reading</source>
        <translation>Lectura</translation>
    </message>
    <message>
        <source>Reading %1 of %2</source>
        <translation>Leyendo %1 de %2</translation>
    </message>
    <message>
        <source>no answer, the values are old</source>
        <translation>sin respuesta, los valores son antiguos</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>sin respuesta</translation>
    </message>
    <message>
        <source>%1 of %2 are read, %3 gave no answer</source>
        <translation>leídos %1 de %2, %3 sin respuesta</translation>
    </message>
    <message>
        <source>not read yet</source>
        <translation>aún sin leer</translation>
    </message>
    <message>
        <source>%1 of %2 known</source>
        <translation>%1 de %2 conocidos</translation>
    </message>
    <message>
        <source>all %1 read</source>
        <translation>leídos los %1</translation>
    </message>
    <message>
        <source>all %1 read in %2</source>
        <translation>leídos los %1 en %2</translation>
    </message>
    <message>
        <source>%1, values for %2 from a file</source>
        <translation>%1, valores para %2 de un archivo</translation>
    </message>
</context>
<context>
    <name>mb::RecipeEditor</name>
    <message>
        <source>New recipe</source>
        <translation>Receta nueva</translation>
    </message>
    <message>
        <source>Fields of the recipe</source>
        <translation>Campos de la receta</translation>
    </message>
    <message>
        <source>The file that is saved, line by line</source>
        <translation>El archivo que se guarda, línea por línea</translation>
    </message>
    <message>
        <source>What is wrong with the recipe</source>
        <translation>Qué está mal en la receta</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Save recipe</source>
        <translation>Guardar receta</translation>
    </message>
    <message>
        <source>Recipe %1</source>
        <translation>Receta %1</translation>
    </message>
    <message>
        <source>Keep the recipe</source>
        <translation>Conservar la receta</translation>
    </message>
    <message>
        <source>Recipes (*.json)</source>
        <translation>Recetas (*.json)</translation>
    </message>
    <message>
        <source>This recipe is not saved.</source>
        <translation>Esta receta no está guardada.</translation>
    </message>
    <message>
        <source>Discard it</source>
        <translation>Descartarla</translation>
    </message>
    <message>
        <source>Go on writing</source>
        <translation>Seguir escribiendo</translation>
    </message>
    <message>
        <source>No mistake in the recipe</source>
        <translation>Ningún error en la receta</translation>
    </message>
    <message>
        <source>Give the recipe a name.</source>
        <translation>Dé un nombre a la receta.</translation>
    </message>
</context>
<context>
    <name>mb::RecipeForm</name>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Family</source>
        <translation>Familia</translation>
    </message>
    <message>
        <source>Firmware file</source>
        <translation>Archivo de firmware</translation>
    </message>
    <message>
        <source>Other way in</source>
        <translation>Otra vía de acceso</translation>
    </message>
    <message>
        <source>Parameter file</source>
        <translation>Archivo de parámetros</translation>
    </message>
    <message>
        <source>Save them where the unit does not by itself</source>
        <translation>Guardarlos si el equipo no lo hace por sí mismo</translation>
    </message>
    <message>
        <source>First number to give</source>
        <translation>Primer número que se asigna</translation>
    </message>
    <message>
        <source>Self-test: the motor turns</source>
        <translation>Autoprueba: el motor gira</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>Lazo</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Desde</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Hasta</translation>
    </message>
    <message>
        <source>Time, s</source>
        <translation>Tiempo, s</translation>
    </message>
    <message>
        <source>Repeats</source>
        <translation>Repeticiones</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Eje</translation>
    </message>
    <message>
        <source>Gain slot</source>
        <translation>Ranura de ganancias</translation>
    </message>
    <message>
        <source>Travel at most, counts</source>
        <translation>Recorrido máximo, cuentas</translation>
    </message>
    <message>
        <source>Speed at most, counts/s</source>
        <translation>Velocidad máxima, cuentas/s</translation>
    </message>
    <message>
        <source>Current at most, A</source>
        <translation>Corriente máxima, A</translation>
    </message>
    <message>
        <source>Duty at most, 0 to 1</source>
        <translation>Ciclo de trabajo máximo, 0 a 1</translation>
    </message>
    <message>
        <source>What the self-test accepts</source>
        <translation>Lo que acepta la autoprueba</translation>
    </message>
    <message>
        <source>Accepted</source>
        <translation>Aceptado</translation>
    </message>
    <message>
        <source>Least</source>
        <translation>Mínimo</translation>
    </message>
    <message>
        <source>Greatest</source>
        <translation>Máximo</translation>
    </message>
    <message>
        <source>counts both ways</source>
        <translation>cuenta en ambos sentidos</translation>
    </message>
    <message>
        <source>Choose: %1</source>
        <translation>Elegir: %1</translation>
    </message>
    <message>
        <source>none: over its own link</source>
        <translation>ninguna: por su propio enlace</translation>
    </message>
    <message>
        <source>such as %1</source>
        <translation>por ejemplo, %1</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>field, unit</comment>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>0 to 1</source>
        <translation>0 a 1</translation>
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
        <translation>%1 · versión %2 · sha %3</translation>
    </message>
    <message>
        <source>%1 · %2 values</source>
        <translation>%1 · %2 valores</translation>
    </message>
    <message>
        <source>next free from %1</source>
        <translation>siguiente libre desde %1</translation>
    </message>
</context>
<context>
    <name>mb::RecordStrip</name>
    <message>
        <source>Record…</source>
        <translation>Grabar…</translation>
    </message>
    <message>
        <source>End recording</source>
        <translation>Terminar grabación</translation>
    </message>
    <message>
        <source>Writes every frame of this link to a candump log or a Vector ASC file</source>
        <translation>Escribe todas las tramas de este enlace en un registro candump o un archivo Vector ASC</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>Descartar</translation>
    </message>
    <message>
        <source>Record the frames of %1</source>
        <translation>Grabar las tramas de %1</translation>
    </message>
    <message>
        <source>Vector ASC log (*.asc)</source>
        <translation>Registro Vector ASC (*.asc)</translation>
    </message>
    <message>
        <source>candump log (*.log)</source>
        <translation>Registro candump (*.log)</translation>
    </message>
    <message>
        <source>nothing is recorded: %1</source>
        <translation>no se graba nada: %1</translation>
    </message>
    <message>
        <source>The recording has ended: %1. %2 frames are missing in it.</source>
        <translation>La grabación ha terminado: %1. Faltan %2 tramas en ella.</translation>
    </message>
    <message>
        <source>Recording  %1   %2 frames   %3   %4 lost   %5</source>
        <translation>Grabando  %1   %2 tramas   %3   %4 perdidas   %5</translation>
    </message>
</context>
<context>
    <name>mb::Recorder</name>
    <message>
        <source>The last session did not end by itself. What it recorded is in %1.</source>
        <translation>La última sesión no terminó con normalidad. Lo que grabó está en %1.</translation>
    </message>
    <message>
        <source>Samples are recorded on disk again, those of the meantime too.</source>
        <translation>Las muestras vuelven a grabarse en disco, también las del intervalo.</translation>
    </message>
    <message>
        <source>Samples are not recorded on disk: %1</source>
        <translation>Las muestras no se graban en disco: %1</translation>
    </message>
    <message>
        <source>What the last session recorded waits for the next start: %1</source>
        <translation>Lo que grabó la última sesión espera al próximo inicio: %1</translation>
    </message>
</context>
<context>
    <name>mb::RecordingControl</name>
    <message>
        <source>Record</source>
        <translation>Grabar</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Guardar</translation>
    </message>
    <message>
        <source>Keeps everything that devices send, beginning with the last %1.
What was recorded lately is on disk all the time and outlives a crash.</source>
        <translation>Conserva todo lo que envían los dispositivos, empezando por los últimos %1.
Lo grabado recientemente está siempre en disco y sobrevive a un cierre inesperado.</translation>
    </message>
    <message>
        <source>recording written to %1</source>
        <translation>grabación escrita en %1</translation>
    </message>
    <message>
        <source>not recorded: %1</source>
        <translation>no grabado: %1</translation>
    </message>
    <message>
        <source>%1 · %2 · %3 samples</source>
        <translation>%1 · %2 · %3 muestras</translation>
    </message>
    <message>
        <source>last %1 on disk · %2</source>
        <translation>últimos %1 en disco · %2</translation>
    </message>
</context>
<context>
    <name>mb::ReplayBar</name>
    <message>
        <source>Recording that is played</source>
        <translation>Grabación que se reproduce</translation>
    </message>
    <message>
        <source>REPLAY</source>
        <translation>REPRODUCCIÓN</translation>
    </message>
    <message>
        <source>Shows what was recorded. Nothing is sent, no motor moves.</source>
        <translation>Muestra lo que se grabó. No se envía nada, no se mueve ningún motor.</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Reproducir</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pausa</translation>
    </message>
    <message>
        <source>Play again</source>
        <translation>Reproducir de nuevo</translation>
    </message>
    <message>
        <source>Plays the recording from where it stands, or halts it there</source>
        <translation>Reproduce la grabación desde donde está o la detiene ahí</translation>
    </message>
    <message>
        <source>Speed of the replay</source>
        <translation>Velocidad de reproducción</translation>
    </message>
    <message>
        <source>How fast the recording is played</source>
        <translation>A qué velocidad se reproduce la grabación</translation>
    </message>
    <message>
        <source>as fast as possible</source>
        <translation>lo más rápido posible</translation>
    </message>
    <message>
        <source>Position in the recording</source>
        <translation>Posición en la grabación</translation>
    </message>
    <message>
        <source>Where the recording stands; arrow keys move it by 1 s, Page Up and Page Down by 10 s</source>
        <translation>Dónde está la grabación; las flechas la mueven 1 s, RePág y AvPág 10 s</translation>
    </message>
    <message>
        <source>%1: looking through it, %2 %</source>
        <translation>%1: examinando, %2 %</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>recorded %1</source>
        <translation>grabado %1</translation>
    </message>
</context>
<context>
    <name>mb::ReportOrder</name>
    <message>
        <source>Write report</source>
        <translation>Escribir informe</translation>
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
        <translation>el informe está en %1</translation>
    </message>
    <message>
        <source>no report: %1</source>
        <translation>sin informe: %1</translation>
    </message>
</context>
<context>
    <name>mb::ReportText</name>
    <message>
        <source>Rise, 10 to 90 %</source>
        <translation>Subida, 10 a 90 %</translation>
    </message>
    <message>
        <source>Settling to 2 %</source>
        <translation>Establecimiento al 2 %</translation>
    </message>
    <message>
        <source>Overshoot</source>
        <translation>Sobreimpulso</translation>
    </message>
    <message>
        <source>Undershoot of the way back</source>
        <translation>Subimpulso de la vuelta</translation>
    </message>
    <message>
        <source>Error at rest</source>
        <translation>Error en reposo</translation>
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
        <translation>Corriente de pico</translation>
    </message>
    <message>
        <source>Chatter of the duty, RMS</source>
        <translation>Agitación del ciclo, RMS</translation>
    </message>
    <message>
        <source>Time at the duty limit</source>
        <translation>Tiempo en el límite del ciclo</translation>
    </message>
    <message>
        <source>Noise of the measurement</source>
        <translation>Ruido de la medida</translation>
    </message>
    <message>
        <source>step</source>
        <translation>escalón</translation>
    </message>
    <message>
        <source>square wave</source>
        <translation>onda cuadrada</translation>
    </message>
    <message>
        <source>ramp</source>
        <translation>rampa</translation>
    </message>
    <message>
        <source>sine</source>
        <translation>seno</translation>
    </message>
    <message>
        <source>chirp</source>
        <translation>chirp</translation>
    </message>
    <message>
        <source>random steps</source>
        <translation>escalones aleatorios</translation>
    </message>
    <message>
        <source>velocity</source>
        <translation>velocidad</translation>
    </message>
    <message>
        <source>position</source>
        <translation>posición</translation>
    </message>
    <message>
        <source>current</source>
        <translation>corriente</translation>
    </message>
    <message>
        <source>duty</source>
        <translation>ciclo de trabajo</translation>
    </message>
    <message>
        <source>%1 times</source>
        <translation>%1 veces</translation>
    </message>
    <message>
        <source>done</source>
        <translation>hecho</translation>
    </message>
    <message>
        <source>cut off</source>
        <translation>cortado</translation>
    </message>
    <message>
        <source>interrupted</source>
        <translation>interrumpido</translation>
    </message>
    <message>
        <source>stopped by the guard “%1”</source>
        <translation>parado por la protección «%1»</translation>
    </message>
    <message>
        <source>DEMO: this unit is simulated. Nothing here was measured on a motor.</source>
        <translation>DEMO: este equipo es simulado. Nada de esto se midió en un motor.</translation>
    </message>
    <message>
        <source>Report on %1</source>
        <translation>Informe de %1</translation>
    </message>
    <message>
        <source>Made on %1 with %2</source>
        <translation>Creado el %1 con %2</translation>
    </message>
    <message>
        <source>There are no trials of this unit in the notebook.</source>
        <translation>No hay ensayos de este equipo en el cuaderno.</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>Etiquetas</translation>
    </message>
    <message>
        <source>simulated</source>
        <translation>simulado</translation>
    </message>
    <message>
        <source>Firmware %1</source>
        <translation>Firmware %1</translation>
    </message>
    <message>
        <source>s since the edge</source>
        <translation>s desde el flanco</translation>
    </message>
    <message>
        <source>Trial %1: %2</source>
        <translation>Ensayo %1: %2</translation>
    </message>
    <message>
        <source>target</source>
        <translation>consigna</translation>
    </message>
    <message>
        <source>%1, measured</source>
        <translation>%1, medido</translation>
    </message>
    <message>
        <source>duty, %</source>
        <translation>ciclo, %</translation>
    </message>
    <message>
        <source>Metric</source>
        <translation>Índice</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valor</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>Ganancia</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>Predeterminado</translation>
    </message>
    <message>
        <source>Parameters of this set that have their default: %1</source>
        <translation>Parámetros de este juego con su valor predeterminado: %1</translation>
    </message>
    <message>
        <source>travel ± %1</source>
        <translation>recorrido ± %1</translation>
    </message>
    <message>
        <source>speed %1</source>
        <translation>velocidad %1</translation>
    </message>
    <message>
        <source>current %1</source>
        <translation>corriente %1</translation>
    </message>
    <message>
        <source>duty %1</source>
        <translation>ciclo %1</translation>
    </message>
    <message>
        <source>Trial %1, %2 loop</source>
        <translation>Ensayo %1, lazo de %2</translation>
    </message>
    <message>
        <source>Trial %1, open loop</source>
        <translation>Ensayo %1, lazo abierto</translation>
    </message>
    <message>
        <source>axis %1</source>
        <translation>eje %1</translation>
    </message>
    <message>
        <source>gain slot %1</source>
        <translation>ranura de ganancias %1</translation>
    </message>
    <message>
        <source>firmware %1</source>
        <translation>firmware %1</translation>
    </message>
    <message>
        <source>motor seen stopped</source>
        <translation>motor visto parado</translation>
    </message>
    <message>
        <source>stop not confirmed</source>
        <translation>parada no confirmada</translation>
    </message>
    <message>
        <source>%1 samples, %2 lost</source>
        <translation>%1 muestras, %2 perdidas</translation>
    </message>
    <message>
        <source>Nothing was recorded.</source>
        <translation>No se grabó nada.</translation>
    </message>
    <message>
        <source>It ran within: %1.</source>
        <translation>Se ejecutó dentro de: %1.</translation>
    </message>
    <message>
        <source>Note: %1</source>
        <translation>Nota: %1</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>N.º</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tiempo</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>Lazo</translation>
    </message>
    <message>
        <source>Stimulus</source>
        <translation>Excitación</translation>
    </message>
    <message>
        <source>Rise</source>
        <translation>Subida</translation>
    </message>
    <message>
        <source>Settling</source>
        <translation>Establecimiento</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Terminar</translation>
    </message>
    <message>
        <source>History of the unit</source>
        <translation>Historial del equipo</translation>
    </message>
    <message>
        <source>The newest %1 of %2 trials.</source>
        <translation>Los %1 ensayos más recientes de %2.</translation>
    </message>
    <message>
        <source>Kept</source>
        <translation>Conservado</translation>
    </message>
    <message>
        <source>Proposed, nothing was written</source>
        <translation>Propuesto, no se escribió nada</translation>
    </message>
    <message>
        <source>Put back</source>
        <translation>Restituido</translation>
    </message>
    <message>
        <source>Refused</source>
        <translation>Rechazado</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Parado</translation>
    </message>
    <message>
        <source>none, as fresh as the position</source>
        <translation>ninguno, tan actual como la posición</translation>
    </message>
    <message>
        <source>rolling, %1</source>
        <translation>móvil, %1</translation>
    </message>
    <message>
        <source>in blocks, %1</source>
        <translation>por bloques, %1</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modelo</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Unidad</translation>
    </message>
    <message>
        <source>Gain K</source>
        <translation>Ganancia K</translation>
    </message>
    <message>
        <source>Lag τ</source>
        <translation>Constante τ</translation>
    </message>
    <message>
        <source>Friction kS</source>
        <translation>Fricción kS</translation>
    </message>
    <message>
        <source>% duty</source>
        <translation>% de ciclo</translation>
    </message>
    <message>
        <source>Velocity filter of the device: %1</source>
        <translation>Filtro de velocidad del dispositivo: %1</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>superado</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>no superado</translation>
    </message>
    <message>
        <source>What the model was judged by:</source>
        <translation>Criterios con que se juzgó el modelo:</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Antes</translation>
    </message>
    <message>
        <source>Proposed</source>
        <translation>Propuesto</translation>
    </message>
    <message>
        <source>Raw</source>
        <translation>Bruto</translation>
    </message>
    <message>
        <source>Proof</source>
        <translation>Verificación</translation>
    </message>
    <message>
        <source>Predicted</source>
        <translation>Previsto</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Medido</translation>
    </message>
    <message>
        <source>Sensitivity peak Ms</source>
        <translation>Pico de sensibilidad Ms</translation>
    </message>
    <message>
        <source>Gain margin</source>
        <translation>Margen de ganancia</translation>
    </message>
    <message>
        <source>Phase margin</source>
        <translation>Margen de fase</translation>
    </message>
    <message>
        <source>forwards</source>
        <translation>hacia delante</translation>
    </message>
    <message>
        <source>backwards</source>
        <translation>hacia atrás</translation>
    </message>
    <message>
        <source>predicted</source>
        <translation>previsto</translation>
    </message>
    <message>
        <source>The step of the proof, predicted and measured</source>
        <translation>El escalón de la verificación, previsto y medido</translation>
    </message>
    <message>
        <source>Magnitude and phase of the open loop</source>
        <translation>Módulo y fase del lazo abierto</translation>
    </message>
    <message>
        <source>magnitude of the loop, dB</source>
        <translation>módulo del lazo, dB</translation>
    </message>
    <message>
        <source>phase of the loop, °</source>
        <translation>fase del lazo, °</translation>
    </message>
    <message>
        <source>Tuning of the %1 loop</source>
        <translation>Ajuste del lazo de %1</translation>
    </message>
    <message>
        <source>trials %1</source>
        <translation>ensayos %1</translation>
    </message>
    <message>
        <source>Family</source>
        <translation>Familia</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Dirección</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation>Número de serie</translation>
    </message>
    <message>
        <source>Connected at</source>
        <translation>Conectado en</translation>
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
        <translation>Dialecto</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Parámetro</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parámetros</translation>
    </message>
    <message>
        <source>%1 of %2 differ from their default and are set in bold.</source>
        <translation>%1 de %2 difieren de su valor predeterminado y figuran en negrita.</translation>
    </message>
    <message>
        <source>Resistance R, Ω</source>
        <translation>Resistencia R, Ω</translation>
    </message>
    <message>
        <source>Friction, V</source>
        <translation>Fricción, V</translation>
    </message>
    <message>
        <source>Gain 1/Ke, counts/s per V</source>
        <translation>Ganancia 1/Ke, counts/s por V</translation>
    </message>
    <message>
        <source>Encoder counts both ways</source>
        <translation>El encoder cuenta en ambos sentidos</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>sí</translation>
    </message>
    <message>
        <source>no</source>
        <translation>no</translation>
    </message>
    <message>
        <source>Self-test</source>
        <translation>Autoprueba</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>Límites</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Cambio</translation>
    </message>
    <message>
        <source>%1 since %2</source>
        <translation>%1 desde %2</translation>
    </message>
    <message>
        <source>PASS</source>
        <translation>SUPERADO</translation>
    </message>
    <message>
        <source>FAIL</source>
        <translation>NO SUPERADO</translation>
    </message>
    <message>
        <source>Not finished</source>
        <translation>Sin terminar</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Resultado</translation>
    </message>
    <message>
        <source>Recipe</source>
        <translation>Receta</translation>
    </message>
    <message>
        <source>Served</source>
        <translation>Atendido</translation>
    </message>
    <message>
        <source>Number given</source>
        <translation>Número asignado</translation>
    </message>
    <message>
        <source>Parameters of the recipe</source>
        <translation>Parámetros de la receta</translation>
    </message>
    <message numerus="yes">
        <source>%n in the unit, read back</source>
        <translation>
            <numerusform>%n en el equipo, releído</numerusform>
            <numerusform>%n en el equipo, releídos</numerusform>
        </translation>
    </message>
    <message>
        <source>Service</source>
        <translation>Servicio</translation>
    </message>
    <message>
        <source>Cause or note</source>
        <translation>Causa o nota</translation>
    </message>
    <message>
        <source>Every service of this unit</source>
        <translation>Cada servicio de este equipo</translation>
    </message>
    <message>
        <source>Service card of %1</source>
        <translation>Ficha de servicio de %1</translation>
    </message>
    <message>
        <source>Parameters that differ from their default</source>
        <translation>Parámetros que difieren de su valor predeterminado</translation>
    </message>
    <message>
        <source>The first %1 of %2.</source>
        <translation>Los primeros %1 de %2.</translation>
    </message>
    <message>
        <source>Counts/s per duty</source>
        <translation>Cuentas/s por ciclo de trabajo</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>Fase</translation>
    </message>
    <message>
        <source>Coherence</source>
        <translation>Coherencia</translation>
    </message>
    <message>
        <source>Believed</source>
        <translation>Fiable</translation>
    </message>
    <message>
        <source>magnitude of the motor, dB</source>
        <translation>magnitud del motor, dB</translation>
    </message>
    <message>
        <source>phase of the motor, °</source>
        <translation>fase del motor, °</translation>
    </message>
    <message>
        <source>model</source>
        <translation>modelo</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>medido</translation>
    </message>
    <message>
        <source>Magnitude and phase of the motor, measured and of its model</source>
        <translation>Magnitud y fase del motor, medidas y según su modelo</translation>
    </message>
    <message>
        <source>Frequency response of the motor</source>
        <translation>Respuesta en frecuencia del motor</translation>
    </message>
    <message>
        <source>Sines of duty around a speed at which it never reverses, the last on %1. Believed and drawn are %2 of %3: ten samples make a swing, and the sine explains 0.9 of the movement at least (coherence).</source>
        <translation>Senos de ciclo de trabajo en torno a una velocidad a la que nunca se invierte, el último el %1. Fiables y dibujados son %2 de %3: diez muestras por oscilación, y el seno explica al menos 0.9 del movimiento (coherencia).</translation>
    </message>
    <message>
        <source>Load one way kG</source>
        <translation>Carga hacia un lado kG</translation>
    </message>
    <message>
        <source>Gain forwards</source>
        <translation>Ganancia hacia delante</translation>
    </message>
    <message>
        <source>Gain backwards</source>
        <translation>Ganancia hacia atrás</translation>
    </message>
    <message>
        <source>Noise at rest σ</source>
        <translation>Ruido en reposo σ</translation>
    </message>
    <message>
        <source>Set-points that it can follow: at most %1 and %2</source>
        <translation>Consignas que puede seguir: como máximo %1 y %2</translation>
    </message>
    <message>
        <source>to be looked at</source>
        <translation>para revisar</translation>
    </message>
    <message>
        <source>Order to motion</source>
        <translation>Orden a movimiento</translation>
    </message>
    <message>
        <source>Dead time θ</source>
        <translation>Tiempo muerto θ</translation>
    </message>
    <message>
        <source>counts</source>
        <translation>counts</translation>
    </message>
    <message>
        <source>Breakaway forwards</source>
        <translation>Arranque hacia delante</translation>
    </message>
    <message>
        <source>Breakaway backwards</source>
        <translation>Arranque hacia atrás</translation>
    </message>
    <message>
        <source>Tag</source>
        <translation>Etiqueta</translation>
    </message>
    <message>
        <source>Known by</source>
        <translation>Conocido por</translation>
    </message>
    <message>
        <source>its place; another unit may stand there</source>
        <translation>su lugar; allí puede haber otro equipo</translation>
    </message>
    <message>
        <source>Friction, share of duty</source>
        <translation>Fricción, fracción del ciclo de trabajo</translation>
    </message>
    <message>
        <source>Gain, counts/s at full duty</source>
        <translation>Ganancia, counts/s con ciclo de trabajo pleno</translation>
    </message>
    <message>
        <source>Not kept</source>
        <translation>No conservado</translation>
    </message>
    <message>
        <source>duty %1, which stands in for a limit of current</source>
        <translation>ciclo %1, que sustituye a un límite de corriente</translation>
    </message>
    <message>
        <source>%1 (forgotten)</source>
        <translation>%1 (olvidado)</translation>
    </message>
    <message>
        <source>band: ± of the model</source>
        <translation>banda: ± del modelo</translation>
    </message>
    <message>
        <source>Proposal</source>
        <translation>Propuesta</translation>
    </message>
    <message>
        <source>Response</source>
        <translation>Respuesta</translation>
    </message>
    <message>
        <source>Bounded by</source>
        <translation>Limitado por</translation>
    </message>
    <message>
        <source>chosen</source>
        <translation>elegida</translation>
    </message>
    <message>
        <source>current, %1</source>
        <translation>corriente, %1</translation>
    </message>
</context>
<context>
    <name>mb::ReportsPage</name>
    <message>
        <source>Reports</source>
        <translation>Informes</translation>
    </message>
    <message>
        <source>Nothing to report yet</source>
        <translation>Aún no hay nada que informar</translation>
    </message>
    <message>
        <source>The cards of units, their tunings and their trials appear here.</source>
        <translation>Aquí aparecen las fichas de los equipos, sus ajustes y sus ensayos.</translation>
    </message>
    <message>
        <source>Search the reports</source>
        <translation>Buscar en los informes</translation>
    </message>
    <message>
        <source>Reports, newest first</source>
        <translation>Informes, el más reciente primero</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Vista previa</translation>
    </message>
    <message>
        <source>Write report…</source>
        <translation>Escribir informe…</translation>
    </message>
    <message>
        <source>Preview of the report</source>
        <translation>Vista previa del informe</translation>
    </message>
    <message>
        <source>writes the report that is looked at</source>
        <translation>escribe el informe que se ve</translation>
    </message>
    <message>
        <source>goes to the search</source>
        <translation>va a la búsqueda</translation>
    </message>
    <message>
        <source>Card of %1</source>
        <translation>Ficha de %1</translation>
    </message>
    <message>
        <source>Tuning of %1</source>
        <translation>Ajuste de %1</translation>
    </message>
    <message>
        <source>%1 trials</source>
        <translation>%1 ensayos</translation>
    </message>
    <message>
        <source>Trial #%1 of %2</source>
        <translation>Ensayo #%1 de %2</translation>
    </message>
    <message>
        <source>What is listed</source>
        <translation>Qué se muestra</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Todas</translation>
    </message>
    <message>
        <source>Cards</source>
        <translation>Fichas</translation>
    </message>
    <message>
        <source>Tuning</source>
        <translation>Ajustando</translation>
    </message>
    <message>
        <source>Journal</source>
        <translation>Diario</translation>
    </message>
    <message>
        <source>Note on this entry</source>
        <translation>Nota sobre esta entrada</translation>
    </message>
    <message>
        <source>Note on this entry of the journal</source>
        <translation>Nota sobre esta entrada del diario</translation>
    </message>
    <message>
        <source>Size of the report</source>
        <translation>Tamaño del informe</translation>
    </message>
    <message>
        <source>Pages, A4</source>
        <translation>Páginas, A4</translation>
    </message>
    <message>
        <source>Label, 62 × 29 mm</source>
        <translation>Etiqueta, 62 × 29 mm</translation>
    </message>
    <message>
        <source>Save CSV…</source>
        <translation>Guardar CSV…</translation>
    </message>
    <message>
        <source>The entries of the journal that are listed, as a table</source>
        <translation>Las entradas del diario mostradas, como tabla</translation>
    </message>
    <message>
        <source>Save the journal</source>
        <translation>Guardar el diario</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tabla (*.csv)</translation>
    </message>
    <message>
        <source>the journal is in %1</source>
        <translation>el diario está en %1</translation>
    </message>
</context>
<context>
    <name>mb::ResolutionMeter</name>
    <message>
        <source>Resolution: off</source>
        <translation>Resolución: apagada</translation>
    </message>
    <message>
        <source>Resolution: %1 steps</source>
        <translation>Resolución: %1 pasos</translation>
    </message>
    <message>
        <source>The device knows this value as %1 whole steps: the smallest change is %2 %.</source>
        <translation>El dispositivo conoce este valor como %1 pasos enteros: el cambio mínimo es %2 %.</translation>
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
        <translation>t = 0 en el flanco, media de %1 · %2 muestras, %3 perdidas</translation>
    </message>
    <message>
        <source>t = 0 at the edge · %1 samples, %2 lost</source>
        <translation>t = 0 en el flanco · %1 muestras, %2 perdidas</translation>
    </message>
    <message>
        <source>Responses</source>
        <translation>Respuestas</translation>
    </message>
    <message>
        <source>%1 #%2</source>
        <translation>%1 #%2</translation>
    </message>
    <message>
        <source>set-point</source>
        <translation>consigna</translation>
    </message>
    <message>
        <source>±2 % band</source>
        <translation>banda ±2 %</translation>
    </message>
    <message>
        <source>%1 peak %2 %</source>
        <translation>%1 pico %2 %</translation>
    </message>
    <message>
        <source>%1 settles %2</source>
        <translation>%1 se establece %2</translation>
    </message>
    <message>
        <source>%1: duty at %2 % limit, %3</source>
        <translation>%1: ciclo en el límite de %2 %, %3</translation>
    </message>
    <message>
        <source>%1: current at its limit, %2</source>
        <translation>%1: corriente en su límite, %2</translation>
    </message>
    <message>
        <source>limit %1 %</source>
        <translation>límite %1 %</translation>
    </message>
    <message>
        <source>limit %1 A</source>
        <translation>límite %1 A</translation>
    </message>
</context>
<context>
    <name>mb::RoutePanel</name>
    <message>
        <source>Way in</source>
        <translation>Acceso</translation>
    </message>
    <message>
        <source>Programmer</source>
        <translation>Programador</translation>
    </message>
    <message>
        <source>Programmer or port and where it is plugged in, as after --via on the command line</source>
        <translation>Programador o puerto y dónde está conectado, como tras --via en la línea de órdenes</translation>
    </message>
    <message>
        <source>Microcontroller</source>
        <translation>Microcontrolador</translation>
    </message>
    <message>
        <source>Which microcontroller the unit has</source>
        <translation>Qué microcontrolador tiene el equipo</translation>
    </message>
    <message>
        <source>Erase what the unit has stored: its gains are lost</source>
        <translation>Borrar lo que el equipo tiene guardado: sus ganancias se pierden</translation>
    </message>
    <message>
        <source>What is not known of it…</source>
        <translation>Lo que no se sabe de él…</translation>
    </message>
    <message>
        <source>What the maker does not tell of the bootloader, with the likely values</source>
        <translation>Lo que el fabricante no dice del bootloader, con los valores probables</translation>
    </message>
</context>
<context>
    <name>mb::SamplesWindow</name>
    <message>
        <source>%1 s, %2 samples, %3 lost</source>
        <translation>%1 s, %2 muestras, %3 perdidas</translation>
    </message>
    <message>
        <source>; the end of the file is missing</source>
        <translation>; falta el final del archivo</translation>
    </message>
    <message>
        <source>%1 (recorded samples)</source>
        <translation>%1 (muestras grabadas)</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>Leyendo %1</translation>
    </message>
    <message>
        <source>Fit time and value</source>
        <translation>Encajar tiempo y valor</translation>
    </message>
    <message>
        <source>Cursors</source>
        <translation>Cursores</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportar</translation>
    </message>
    <message>
        <source>Channels</source>
        <translation>Canales</translation>
    </message>
    <message>
        <source>Recorded samples</source>
        <translation>Muestras grabadas</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Escrito: %1</translation>
    </message>
    <message>
        <source>shows everything</source>
        <translation>muestra todo</translation>
    </message>
    <message>
        <source>shows or hides the cursors</source>
        <translation>muestra u oculta los cursores</translation>
    </message>
    <message>
        <source>closes this window</source>
        <translation>cierra esta ventana</translation>
    </message>
    <message>
        <source>shows these keys</source>
        <translation>muestra estas teclas</translation>
    </message>
    <message>
        <source>%1: no samples</source>
        <translation>%1: sin muestras</translation>
    </message>
    <message>
        <source>One export at a time: %1 is being written.</source>
        <translation>Solo una exportación a la vez: se está escribiendo %1.</translation>
    </message>
    <message>
        <source>; the file has more, of which nothing is shown: it is too large for the memory</source>
        <translation>; el archivo tiene más, de lo que no se muestra nada: es demasiado grande para la memoria</translation>
    </message>
</context>
<context>
    <name>mb::SavedLimits</name>
    <message>
        <source>Kept limits</source>
        <translation>Límites conservados</translation>
    </message>
    <message>
        <source>kept limits</source>
        <translation>límites conservados</translation>
    </message>
    <message>
        <source>Name of the limits</source>
        <translation>Nombre de los límites</translation>
    </message>
    <message>
        <source>Choose limits that were kept for this unit, or type a name to keep the present ones under</source>
        <translation>Elija límites conservados para este equipo o escriba un nombre con el que conservar los actuales</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Conservar</translation>
    </message>
    <message>
        <source>Keep these limits under this name</source>
        <translation>Conservar estos límites con este nombre</translation>
    </message>
    <message>
        <source>Forget</source>
        <translation>Olvidar</translation>
    </message>
    <message>
        <source>Forget the limits of this name</source>
        <translation>Olvidar los límites de este nombre</translation>
    </message>
</context>
<context>
    <name>mb::ScanStrip</name>
    <message>
        <source>What the scan looks for</source>
        <translation>Qué busca la búsqueda</translation>
    </message>
    <message>
        <source>Progress of the scan</source>
        <translation>Progreso de la búsqueda</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Cancel the scan</source>
        <translation>Cancelar la búsqueda</translation>
    </message>
    <message>
        <source>Ends the search; what it has found stays.</source>
        <translation>Termina la búsqueda; lo que ha encontrado se queda.</translation>
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
        <translation>Enviar una trama</translation>
    </message>
    <message>
        <source>Identifier</source>
        <translation>Identificador</translation>
    </message>
    <message>
        <source>id, such as 7FF</source>
        <translation>id, como 7FF</translation>
    </message>
    <message>
        <source>Hexadecimal; a whole frame such as 02061405#8125 may be pasted here</source>
        <translation>Hexadecimal; también se puede pegar aquí una trama completa como 02061405#8125</translation>
    </message>
    <message>
        <source>Length of the identifier</source>
        <translation>Longitud del identificador</translation>
    </message>
    <message>
        <source>11 bits</source>
        <translation>11 bits</translation>
    </message>
    <message>
        <source>29 bits</source>
        <translation>29 bits</translation>
    </message>
    <message>
        <source>Data</source>
        <translation>Datos</translation>
    </message>
    <message>
        <source>data, such as 81 25 11</source>
        <translation>datos, como 81 25 11</translation>
    </message>
    <message>
        <source>Repeat every</source>
        <translation>Repetir cada</translation>
    </message>
    <message>
        <source>Period</source>
        <translation>Periodo</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> ms</translation>
    </message>
    <message>
        <source>Send</source>
        <translation>Enviar</translation>
    </message>
    <message>
        <source>Hold to send</source>
        <translation>Mantener para enviar</translation>
    </message>
    <message>
        <source>End repeating</source>
        <translation>Terminar repetición</translation>
    </message>
    <message>
        <source>What is typed here is decoded before it is sent</source>
        <translation>Lo que se escribe aquí se decodifica antes de enviarlo</translation>
    </message>
    <message>
        <source>Makes a motor move: %1</source>
        <translation>Mueve un motor: %1</translation>
    </message>
    <message>
        <source>ended</source>
        <translation>terminado</translation>
    </message>
    <message>
        <source>The link does not take frames as fast as they are sent</source>
        <translation>El enlace no admite las tramas tan rápido como se envían</translation>
    </message>
    <message>
        <source>%1 sent</source>
        <translation>%1 enviadas</translation>
    </message>
    <message>
        <source>%1 sent, then: %2</source>
        <translation>%1 enviadas, después: %2</translation>
    </message>
    <message>
        <source>the page was left</source>
        <translation>se abandonó la página</translation>
    </message>
    <message>
        <source>the window lost the focus</source>
        <translation>la ventana perdió el foco</translation>
    </message>
    <message>
        <source>no decoder knows this identifier</source>
        <translation>ningún decodificador conoce este identificador</translation>
    </message>
    <message>
        <source>%1 of %2 #%3   %4</source>
        <translation>%1 de %2 #%3   %4</translation>
    </message>
</context>
<context>
    <name>mb::SessionDesk</name>
    <message>
        <source>today %1</source>
        <translation>hoy %1</translation>
    </message>
    <message>
        <source>yesterday %1</source>
        <translation>ayer %1</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1 is used by %2 too</source>
        <translation>%1 también lo usa %2</translation>
    </message>
    <message>
        <source>agree who drives: two masters disturb each other</source>
        <translation>acuerden quién acciona: dos maestros se estorban</translation>
    </message>
    <message>
        <source>The program ended unexpectedly (%1). What was measured is kept. Open again: %2?</source>
        <translation>El programa terminó de forma inesperada (%1). Lo medido se conserva. ¿Abrir de nuevo: %2?</translation>
    </message>
    <message numerus="yes">
        <source>%n unit(s)</source>
        <translation>
            <numerusform>%n equipo</numerusform>
            <numerusform>%n equipos</numerusform>
        </translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Abrir</translation>
    </message>
</context>
<context>
    <name>mb::SessionKeeper</name>
    <message>
        <source>This session cannot be kept: %1</source>
        <translation>Esta sesión no se puede conservar: %1</translation>
    </message>
</context>
<context>
    <name>mb::SetPointPanel</name>
    <message>
        <source>Set-point</source>
        <translation>Consigna</translation>
    </message>
    <message>
        <source>Enter applies it while the motor runs; it never starts one.</source>
        <translation>Intro la aplica con el motor en marcha; nunca lo arranca.</translation>
    </message>
    <message>
        <source>Set-point, slider</source>
        <translation>Consigna, deslizador</translation>
    </message>
    <message>
        <source>Hide drive options</source>
        <translation>Ocultar opciones</translation>
    </message>
    <message>
        <source>Stop and count from 0</source>
        <translation>Parar y contar desde 0</translation>
    </message>
    <message>
        <source>Stops the motor, and makes where it stands position 0. It starts again with Run only: a motor that runs would jump.</source>
        <translation>Detiene el motor y hace que su posición actual sea la 0. Solo vuelve a arrancar con Iniciar: un motor en marcha daría un salto.</translation>
    </message>
    <message>
        <source>device</source>
        <translation>dispositivo</translation>
    </message>
    <message>
        <source>No set-point. Enter a number up to ± %1.</source>
        <translation>Sin consigna. Introduzca un número hasta ± %1.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no number. Enter one up to ± %2.</source>
        <translation>«%1» no es un número. Introduzca uno hasta ± %2.</translation>
    </message>
    <message>
        <source>%1 is no device number. Enter the number of the device to follow.</source>
        <translation>%1 no es un número de dispositivo. Introduzca el número del dispositivo que se debe seguir.</translation>
    </message>
    <message>
        <source>%1 is beyond the range of ± %2. Enter less, or widen the range.</source>
        <translation>%1 supera el rango de ± %2. Introduzca menos o amplíe el rango.</translation>
    </message>
    <message>
        <source>now %1</source>
        <translation>ahora %1</translation>
    </message>
    <message>
        <source>Drive options</source>
        <translation>Opciones</translation>
    </message>
</context>
<context>
    <name>mb::SetPointRange</name>
    <message>
        <source>Range ±</source>
        <translation>Rango ±</translation>
    </message>
    <message>
        <source>Moves</source>
        <translation>Variación</translation>
    </message>
    <message>
        <source>Range of the set-point, either way</source>
        <translation>Rango de la consigna, en ambos sentidos</translation>
    </message>
    <message>
        <source>A set-point beyond it is refused: the limit of the hand, not of the drive.</source>
        <translation>Una consigna mayor se rechaza: es el límite del mando, no del controlador.</translation>
    </message>
    <message>
        <source>at once, as a step</source>
        <translation>de inmediato, como escalón</translation>
    </message>
    <message>
        <source>full range in %1</source>
        <translation>rango completo en %1</translation>
    </message>
    <message>
        <source>How fast the set-point moves</source>
        <translation>Con qué rapidez varía la consigna</translation>
    </message>
    <message>
        <source>This program moves the set-point no faster, whatever is typed.</source>
        <translation>Este programa no varía la consigna más rápido, se escriba lo que se escriba.</translation>
    </message>
</context>
<context>
    <name>mb::SideDocks</name>
    <message>
        <source>Devices</source>
        <translation>Dispositivos</translation>
    </message>
    <message>
        <source>Inspector</source>
        <translation>Inspector</translation>
    </message>
    <message>
        <source>shows or hides the devices</source>
        <translation>muestra u oculta los dispositivos</translation>
    </message>
    <message>
        <source>shows or hides the inspector</source>
        <translation>muestra u oculta el inspector</translation>
    </message>
    <message>
        <source>Show devices</source>
        <translation>Mostrar dispositivos</translation>
    </message>
</context>
<context>
    <name>mb::SignalBook</name>
    <message>
        <source>The signal needs a name.</source>
        <translation>La señal necesita un nombre.</translation>
    </message>
    <message>
        <source>There is a derived signal of this name.</source>
        <translation>Ya existe una señal derivada con este nombre.</translation>
    </message>
    <message>
        <source>%1 may be one of %2</source>
        <translation>%1 puede ser uno de %2</translation>
    </message>
</context>
<context>
    <name>mb::SignalList</name>
    <message>
        <source>Add a signal</source>
        <translation>Añadir una señal</translation>
    </message>
    <message>
        <source>double click or drag</source>
        <translation>doble clic o arrastrar</translation>
    </message>
    <message>
        <source>Signals that can be plotted</source>
        <translation>Señales que se pueden representar</translation>
    </message>
    <message>
        <source>Derived signal…</source>
        <translation>Señal derivada…</translation>
    </message>
    <message>
        <source>A formula over signals: derivative, moving average, difference …</source>
        <translation>Una fórmula sobre señales: derivada, media móvil, diferencia …</translation>
    </message>
    <message>
        <source>derived</source>
        <translation>derivada</translation>
    </message>
    <message>
        <source>%1
right click removes the signal</source>
        <translation>%1
el clic derecho quita la señal</translation>
    </message>
    <message>
        <source>%1
double click plots it, drag it to a pane or below them</source>
        <translation>%1
doble clic la representa; arrástrela a una gráfica o debajo de ellas</translation>
    </message>
    <message>
        <source>Remove this derived signal</source>
        <translation>Quitar esta señal derivada</translation>
    </message>
</context>
<context>
    <name>mb::SlotPanel</name>
    <message>
        <source>Gain slot, edit and run</source>
        <translation>Ranura de ganancias, editar y ejecutar</translation>
    </message>
    <message>
        <source>The slot that is edited and that runs. Changing it disarms.</source>
        <translation>La ranura que se edita y se ejecuta. Cambiarla desarma.</translation>
    </message>
    <message>
        <source>Split</source>
        <translation>Separar</translation>
    </message>
    <message>
        <source>Edit one slot while another runs</source>
        <translation>Editar una ranura mientras se ejecuta otra</translation>
    </message>
    <message>
        <source>Slot</source>
        <translation>Ranura</translation>
    </message>
    <message>
        <source>edit and run</source>
        <translation>editar y ejecutar</translation>
    </message>
    <message>
        <source>Gain slot that is edited</source>
        <translation>Ranura de ganancias que se edita</translation>
    </message>
    <message>
        <source>Gain slot that runs</source>
        <translation>Ranura de ganancias que se ejecuta</translation>
    </message>
    <message>
        <source>The slot of the next run. Changing it disarms.</source>
        <translation>La ranura de la próxima marcha. Cambiarla desarma.</translation>
    </message>
    <message>
        <source>Editing slot</source>
        <translation>Editando ranura</translation>
    </message>
    <message>
        <source>running</source>
        <translation>en marcha</translation>
    </message>
    <message>
        <source>Join</source>
        <translation>Unir</translation>
    </message>
    <message>
        <source>Edit the slot that runs</source>
        <translation>Editar la ranura que se ejecuta</translation>
    </message>
    <message>
        <source>Split: both are slot %1 now.</source>
        <translation>Separadas: ambas son ahora la ranura %1.</translation>
    </message>
    <message>
        <source>Split: edits go to slot %1, slot %2 runs.</source>
        <translation>Separadas: se edita la ranura %1, se ejecuta la ranura %2.</translation>
    </message>
</context>
<context>
    <name>mb::SpectrumView</name>
    <message>
        <source>Spectrum</source>
        <translation>Espectro</translation>
    </message>
    <message>
        <source>frequency, Hz</source>
        <translation>frecuencia, Hz</translation>
    </message>
    <message>
        <source>amplitude</source>
        <translation>amplitud</translation>
    </message>
    <message>
        <source>amplitude, %1</source>
        <translation>amplitud, %1</translation>
    </message>
    <message>
        <source>A … B</source>
        <translation>A … B</translation>
    </message>
    <message>
        <source>what is seen</source>
        <translation>lo visible</translation>
    </message>
    <message>
        <source>, Hann window, peak values. </source>
        <translation>, ventana de Hann, valores de pico. </translation>
    </message>
</context>
<context>
    <name>mb::SpokenNames</name>
    <message>
        <source>Places</source>
        <translation>Lugares</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Archivos</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Carpeta</translation>
    </message>
    <message>
        <source>Kind of file</source>
        <translation>Tipo de archivo</translation>
    </message>
</context>
<context>
    <name>mb::StagedEdits</name>
    <message>
        <source>Discard</source>
        <translation>Descartar</translation>
    </message>
</context>
<context>
    <name>mb::StartPage</name>
    <message>
        <source>Start</source>
        <translation>Iniciar</translation>
    </message>
    <message>
        <source>Add link</source>
        <translation>Añadir enlace</translation>
    </message>
    <message>
        <source>Open recording…</source>
        <translation>Abrir grabación…</translation>
    </message>
    <message>
        <source>Try with a simulated motor</source>
        <translation>Probar con un motor simulado</translation>
    </message>
    <message>
        <source>Open the simulated bench</source>
        <translation>Abrir el banco simulado</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Continuar</translation>
    </message>
    <message>
        <source>Firmware on this computer</source>
        <translation>Firmware en este ordenador</translation>
    </message>
    <message>
        <source>Folder…</source>
        <translation>Carpeta…</translation>
    </message>
    <message>
        <source>Choose the folder whose images are listed here</source>
        <translation>Elegir la carpeta cuyas imágenes se muestran aquí</translation>
    </message>
    <message>
        <source>First time here?</source>
        <translation>¿Es su primera vez?</translation>
    </message>
    <message>
        <source>STOP works on key press, everywhere, also while you type (use Esc then). It is software: keep a hardware stop in the supply.</source>
        <translation>STOP actúa al pulsar, en todas partes, también mientras escribe (use entonces Esc). Es software: tenga un paro físico en la alimentación.</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Teclas</translation>
    </message>
    <message>
        <source>Wiring guides</source>
        <translation>Guías de cableado</translation>
    </message>
    <message>
        <source>Sessions and recordings that you have opened stand here.</source>
        <translation>Aquí figuran las sesiones y grabaciones que ha abierto.</translation>
    </message>
    <message>
        <source>No image (.hex) in this folder.</source>
        <translation>No hay ninguna imagen (.hex) en esta carpeta.</translation>
    </message>
    <message>
        <source>Controllers of every family with real bus timing; nothing real can move.</source>
        <translation>Controladores de todas las familias con tiempos de bus reales; nada real puede moverse.</translation>
    </message>
</context>
<context>
    <name>mb::StateGlyph</name>
    <message>
        <source>online</source>
        <translation>en línea</translation>
    </message>
    <message>
        <source>moving</source>
        <translation>en movimiento</translation>
    </message>
    <message>
        <source>in bootloader</source>
        <translation>en bootloader</translation>
    </message>
    <message>
        <source>2 ×</source>
        <translation>2 ×</translation>
    </message>
    <message>
        <source>number 0</source>
        <translation>número 0</translation>
    </message>
    <message>
        <source>fault</source>
        <translation>fallo</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>sin respuesta</translation>
    </message>
    <message>
        <source>stored</source>
        <translation>guardado</translation>
    </message>
    <message>
        <source>RAM, not in flash</source>
        <translation>RAM, no en flash</translation>
    </message>
    <message>
        <source>edited</source>
        <translation>editado</translation>
    </message>
    <message>
        <source>out of range</source>
        <translation>fuera de rango</translation>
    </message>
    <message>
        <source>assumed</source>
        <translation>supuesto</translation>
    </message>
    <message>
        <source>volatile</source>
        <translation>volátil</translation>
    </message>
    <message>
        <source>busy</source>
        <translation>ocupado</translation>
    </message>
    <message>
        <source>done</source>
        <translation>hecho</translation>
    </message>
    <message>
        <source>waiting</source>
        <translation>en espera</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>advertencia</translation>
    </message>
    <message>
        <source>recording</source>
        <translation>grabando</translation>
    </message>
</context>
<context>
    <name>mb::StationDialog</name>
    <message>
        <source>Journal of this station</source>
        <translation>Diario de esta estación</translation>
    </message>
    <message>
        <source>Name of this station</source>
        <translation>Nombre de esta estación</translation>
    </message>
    <message>
        <source>Server that stations share</source>
        <translation>Servidor que comparten las estaciones</translation>
    </message>
    <message>
        <source>Without a server the journal is in the file of this computer alone. With one, every entry is there first and delivered as soon as the server answers; numbers come in blocks of five.</source>
        <translation>Sin servidor, el diario está solo en el archivo de este ordenador. Con servidor, cada entrada está primero ahí y se entrega en cuanto el servidor responde; los números llegan en bloques de cinco.</translation>
    </message>
</context>
<context>
    <name>mb::StationLamp</name>
    <message>
        <source>%1 self-test</source>
        <translation>autoprueba de %1</translation>
    </message>
    <message>
        <source>turns in a moment</source>
        <translation>gira en un momento</translation>
    </message>
    <message>
        <source>self-tests</source>
        <translation>autopruebas</translation>
    </message>
    <message>
        <source>nothing turns here</source>
        <translation>aquí no gira nada</translation>
    </message>
    <message>
        <source>Arm button</source>
        <translation>botón Armar</translation>
    </message>
</context>
<context>
    <name>mb::StatusBar</name>
    <message>
        <source>samples %1   lost %2   memory %3</source>
        <translation>muestras %1   perdidas %2   memoria %3</translation>
    </message>
</context>
<context>
    <name>mb::StepText</name>
    <message>
        <source>%1, predicted</source>
        <translation>%1, previsto</translation>
    </message>
    <message>
        <source>measured, forwards</source>
        <translation>medido, hacia delante</translation>
    </message>
    <message>
        <source>measured, backwards</source>
        <translation>medido, hacia atrás</translation>
    </message>
    <message>
        <source>measured: %1 % over, settled after %2</source>
        <translation>medido: %1 % de sobreimpulso, establecido tras %2</translation>
    </message>
    <message>
        <source>%1 % over</source>
        <translation>%1 % sobre</translation>
    </message>
    <message>
        <source>%1 A peak</source>
        <translation>pico de %1 A</translation>
    </message>
    <message>
        <source>±2 %</source>
        <translation>±2 %</translation>
    </message>
    <message>
        <source>%1 settles %2</source>
        <translation>%1: estab. %2</translation>
    </message>
    <message>
        <source>%1 does not settle</source>
        <translation>%1 no se establece</translation>
    </message>
    <message>
        <source>measured: peak %1, %2 % over</source>
        <translation>medido: pico %1, %2 % sobre</translation>
    </message>
    <message>
        <source>measured: settles %1</source>
        <translation>medido: estab. %1</translation>
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
        <translation>Escalón de %1 %2</translation>
    </message>
    <message>
        <source>band: ± of the model</source>
        <translation>banda: ± del modelo</translation>
    </message>
</context>
<context>
    <name>mb::StepsPanel</name>
    <message>
        <source>Steps of the update</source>
        <translation>Pasos de la actualización</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Pasos</translation>
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
        <translation>ida, hasta establecerse, y vuelta</translation>
    </message>
    <message>
        <source>to and fro, 0.5 Hz</source>
        <translation>de un lado a otro, 0,5 Hz</translation>
    </message>
    <message>
        <source>evenly there and back</source>
        <translation>ida y vuelta uniformes</translation>
    </message>
    <message>
        <source>1 Hz, six swings</source>
        <translation>1 Hz, seis oscilaciones</translation>
    </message>
    <message>
        <source>0.1 to 15 Hz in 30 s</source>
        <translation>de 0,1 a 15 Hz en 30 s</translation>
    </message>
    <message>
        <source>random bits of 125 ms</source>
        <translation>bits aleatorios de 125 ms</translation>
    </message>
    <message>
        <source>Stimulus</source>
        <translation>Excitación</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Desde</translation>
    </message>
    <message>
        <source>Where the experiment begins and ends; empty: where the motor is, or 0</source>
        <translation>Dónde empieza y termina el experimento; vacío: donde está el motor, o 0</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Hasta</translation>
    </message>
    <message>
        <source>Where the loop is asked to go</source>
        <translation>Adónde debe ir el lazo</translation>
    </message>
    <message>
        <source>hold</source>
        <translation>espera</translation>
    </message>
    <message>
        <source>Time of the stimulus</source>
        <translation>Tiempo de la excitación</translation>
    </message>
    <message>
        <source>Seconds; empty: the usual, and a step ends once it has settled</source>
        <translation>Segundos; vacío: lo habitual, y un escalón termina al establecerse</translation>
    </message>
    <message>
        <source>settled</source>
        <translation>estable</translation>
    </message>
    <message>
        <source>usual</source>
        <translation>habitual</translation>
    </message>
    <message>
        <source>Repeats</source>
        <translation>Repeticiones</translation>
    </message>
    <message>
        <source>Each repeat starts a little later between two samples: together they show what is finer than the telemetry</source>
        <translation>Cada repetición empieza un poco más tarde entre dos muestras: juntas muestran lo que es más fino que la telemetría</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>here</source>
        <translation>aquí</translation>
    </message>
    <message>
        <source>rise</source>
        <translation>subida</translation>
    </message>
    <message>
        <source>time</source>
        <translation>duración</translation>
    </message>
    <message>
        <source>Enter where the loop is to go.</source>
        <translation>Introduzca adónde debe ir el lazo.</translation>
    </message>
    <message>
        <source>%1 is no number.</source>
        <translation>%1 no es un número.</translation>
    </message>
    <message>
        <source>The time is 0.001 to %1 s.</source>
        <translation>La duración es de 0,001 a %1 s.</translation>
    </message>
</context>
<context>
    <name>mb::StopButton</name>
    <message>
        <source>Space · Esc</source>
        <translation>Espacio · Esc</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>STOP</translation>
    </message>
    <message>
        <source>Stop every motor</source>
        <translation>Detener todos los motores</translation>
    </message>
    <message>
        <source>Stop every motor  Space, Esc, Pause</source>
        <translation>Detener todos los motores  Espacio, Esc, Pausa</translation>
    </message>
</context>
<context>
    <name>mb::StoryCard</name>
    <message numerus="yes">
        <source>about %n min</source>
        <translation>
            <numerusform>aprox. %n min</numerusform>
            <numerusform>aprox. %n min</numerusform>
        </translation>
    </message>
    <message>
        <source>Try it</source>
        <translation>Probar</translation>
    </message>
    <message>
        <source>Try it: %1</source>
        <translation>Probar: %1</translation>
    </message>
</context>
<context>
    <name>mb::SweepPanel</name>
    <message>
        <source>%1 sines from %2 to %3 Hz, both ways in turn: duty %4 ± %5 %, at most %6 counts/s, %7 counts one way, %8.</source>
        <translation>%1 senos de %2 a %3 Hz, alternando el sentido: ciclo %4 ± %5 %, como máximo %6 counts/s, %7 counts en un sentido, %8.</translation>
    </message>
    <message>
        <source>Frequency response</source>
        <translation>Respuesta en frecuencia</translation>
    </message>
    <message>
        <source>Measures the motor by sines and draws it over its model, as far as it may be trusted</source>
        <translation>Mide el motor con senos y la dibuja sobre su modelo, hasta donde es fiable</translation>
    </message>
</context>
<context>
    <name>mb::TimelineList</name>
    <message>
        <source>window</source>
        <translation>ventana</translation>
    </message>
    <message>
        <source>console</source>
        <translation>consola</translation>
    </message>
    <message>
        <source>autotune</source>
        <translation>autoajuste</translation>
    </message>
    <message>
        <source>recipe</source>
        <translation>receta</translation>
    </message>
    <message>
        <source>elsewhere</source>
        <translation>en otro lugar</translation>
    </message>
    <message>
        <source>States of this unit</source>
        <translation>Estados de este equipo</translation>
    </message>
    <message>
        <source>Today, %1</source>
        <translation>Hoy, %1</translation>
    </message>
    <message>
        <source>like A</source>
        <translation>como A</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>undone: %1</source>
        <translation>deshecho: %1</translation>
    </message>
    <message>
        <source>done again: %1</source>
        <translation>rehecho: %1</translation>
    </message>
    <message numerus="yes">
        <source>%n differ</source>
        <translation>
            <numerusform>%n distinto</numerusform>
            <numerusform>%n distintos</numerusform>
        </translation>
    </message>
    <message>
        <source>Always there</source>
        <translation>Siempre disponible</translation>
    </message>
    <message>
        <source>This place, not this unit</source>
        <translation>Este sitio, no este equipo</translation>
    </message>
    <message>
        <source>reverted: %1</source>
        <translation>restituido: %1</translation>
    </message>
</context>
<context>
    <name>mb::TourStage</name>
    <message>
        <source>tour</source>
        <translation>recorrido guiado</translation>
    </message>
</context>
<context>
    <name>mb::TraceList</name>
    <message>
        <source>Remove the trace</source>
        <translation>Quitar la curva</translation>
    </message>
    <message>
        <source>Pane, axis, trigger, reference …</source>
        <translation>Gráfica, eje, disparo, referencia …</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>Quitar %1</translation>
    </message>
    <message>
        <source>Traces</source>
        <translation>Curvas</translation>
    </message>
</context>
<context>
    <name>mb::TracePanel</name>
    <message>
        <source>Traces</source>
        <translation>Curvas</translation>
    </message>
    <message>
        <source>rate      lost</source>
        <translation>frec.      perd.</translation>
    </message>
    <message>
        <source>mean %1 · σ %2 · %3 … %4 · %5 samples</source>
        <translation>media %1 · σ %2 · %3 … %4 · %5 muestras</translation>
    </message>
    <message>
        <source> · %1 lost</source>
        <translation> · %1 perdidas</translation>
    </message>
    <message>
        <source>derived</source>
        <translation>derivada</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source>%1 lost</source>
        <translation>%1 perdidas</translation>
    </message>
    <message>
        <source>A %1   B %2</source>
        <translation>A %1   B %2</translation>
    </message>
    <message>
        <source>In a pane of its own</source>
        <translation>En una gráfica propia</translation>
    </message>
    <message>
        <source>Into the pane above</source>
        <translation>En la gráfica de arriba</translation>
    </message>
    <message>
        <source>With its unit</source>
        <translation>Con su unidad</translation>
    </message>
    <message>
        <source>Scale at the right</source>
        <translation>Escala a la derecha</translation>
    </message>
    <message>
        <source>Trigger on it	T</source>
        <translation>Disparar con ella	T</translation>
    </message>
    <message>
        <source>Keep all as references</source>
        <translation>Conservar todas como referencias</translation>
    </message>
    <message>
        <source>Remove references</source>
        <translation>Quitar referencias</translation>
    </message>
    <message>
        <source>Spectrum</source>
        <translation>Espectro</translation>
    </message>
    <message>
        <source>Remove the trace</source>
        <translation>Quitar la curva</translation>
    </message>
    <message>
        <source>%1 cursors · %2 fits · + − zooms · %3 pauses · N note</source>
        <translation>%1 cursores · %2 encaja · + − amplía · %3 pausa · N nota</translation>
    </message>
    <message>
        <source>%1, of another time</source>
        <translation>%1, de otro tiempo</translation>
    </message>
</context>
<context>
    <name>mb::TrafficView</name>
    <message>
        <source>Columns of %1</source>
        <translation>Columnas de %1</translation>
    </message>
</context>
<context>
    <name>mb::TrialList</name>
    <message>
        <source>Which trials</source>
        <translation>Qué ensayos</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Todas</translation>
    </message>
    <message>
        <source>Starred</source>
        <translation>Con estrella</translation>
    </message>
    <message>
        <source>Clean</source>
        <translation>Limpios</translation>
    </message>
    <message>
        <source>Back to best</source>
        <translation>Volver al mejor</translation>
    </message>
    <message>
        <source>Stages the gains of the quickest clean trial with no more than 5 % overshoot; runs nothing.</source>
        <translation>Deja pendientes las ganancias del ensayo limpio más rápido con 5 % de sobreimpulso como máximo; no ejecuta nada.</translation>
    </message>
    <message>
        <source>Export the trials as CSV or JSON</source>
        <translation>Exportar los ensayos como CSV o JSON</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Ensayos</translation>
    </message>
    <message>
        <source>Trials of this loop</source>
        <translation>Ensayos de este lazo</translation>
    </message>
    <message>
        <source>Every experiment appears here with its gains and what became of it.</source>
        <translation>Aquí aparece cada experimento con sus ganancias y su resultado.</translation>
    </message>
    <message>
        <source>stopped: speed</source>
        <translation>parado: velocidad</translation>
    </message>
    <message numerus="yes">
        <source>%n, every run is kept</source>
        <translation>
            <numerusform>%n, cada marcha se conserva</numerusform>
            <numerusform>%n, cada marcha se conserva</numerusform>
        </translation>
    </message>
    <message>
        <source>All %1</source>
        <translation>Todos %1</translation>
    </message>
    <message>
        <source>Starred %1</source>
        <translation>Con estrella %1</translation>
    </message>
    <message>
        <source>Clean %1</source>
        <translation>Limpios %1</translation>
    </message>
    <message>
        <source>Back to best #%1</source>
        <translation>Volver al mejor #%1</translation>
    </message>
    <message>
        <source>Show as B</source>
        <translation>Mostrar como B</translation>
    </message>
    <message>
        <source>Pin as A  A</source>
        <translation>Fijar como A  A</translation>
    </message>
    <message>
        <source>Use these gains</source>
        <translation>Usar estas ganancias</translation>
    </message>
    <message>
        <source>Take the star away</source>
        <translation>Quitar la estrella</translation>
    </message>
    <message>
        <source>Give it a star</source>
        <translation>Poner una estrella</translation>
    </message>
    <message>
        <source>Edit the note</source>
        <translation>Editar la nota</translation>
    </message>
    <message>
        <source>Forget this trial</source>
        <translation>Olvidar este ensayo</translation>
    </message>
</context>
<context>
    <name>mb::TrialModel</name>
    <message>
        <source>Use</source>
        <translation>Usar</translation>
    </message>
    <message>
        <source>Take the star away</source>
        <translation>Quitar la estrella</translation>
    </message>
    <message>
        <source>Give it a star</source>
        <translation>Poner una estrella</translation>
    </message>
    <message>
        <source>Stages the gains of this trial; nothing is written yet.</source>
        <translation>Deja pendientes las ganancias de este ensayo; aún no se escribe nada.</translation>
    </message>
    <message>
        <source>starred</source>
        <translation>con estrella</translation>
    </message>
    <message>
        <source>no star</source>
        <translation>sin estrella</translation>
    </message>
    <message>
        <source>Use the gains of trial #%1</source>
        <translation>Usar las ganancias del ensayo #%1</translation>
    </message>
    <message>
        <source>trial</source>
        <translation>ensayo</translation>
    </message>
    <message>
        <source>time</source>
        <translation>hora</translation>
    </message>
    <message>
        <source>stimulus</source>
        <translation>excitación</translation>
    </message>
    <message>
        <source>over %</source>
        <translation>sobre %</translation>
    </message>
    <message>
        <source>settle</source>
        <translation>estab.</translation>
    </message>
    <message>
        <source>rise</source>
        <translation>subida</translation>
    </message>
    <message>
        <source>peak A</source>
        <translation>pico A</translation>
    </message>
    <message>
        <source>flags</source>
        <translation>marcas</translation>
    </message>
    <message>
        <source>note</source>
        <translation>nota</translation>
    </message>
</context>
<context>
    <name>mb::TrialOrders</name>
    <message>
        <source>the notebook: %1</source>
        <translation>el cuaderno: %1</translation>
    </message>
    <message>
        <source>Export trials</source>
        <translation>Exportar ensayos</translation>
    </message>
    <message>
        <source>Table (*.csv);;JSON (*.json)</source>
        <translation>Tabla (*.csv);;JSON (*.json)</translation>
    </message>
    <message>
        <source>trials written to %1</source>
        <translation>ensayos escritos en %1</translation>
    </message>
</context>
<context>
    <name>mb::TrialWords</name>
    <message>
        <source>better</source>
        <translation>mejor</translation>
    </message>
    <message>
        <source>worse</source>
        <translation>peor</translation>
    </message>
    <message>
        <source>faster</source>
        <translation>más rápido</translation>
    </message>
    <message>
        <source>slower</source>
        <translation>más lento</translation>
    </message>
    <message>
        <source>Rise 10–90</source>
        <translation>Subida 10–90</translation>
    </message>
    <message>
        <source>Settle 2 %</source>
        <translation>Estab. 2 %</translation>
    </message>
    <message>
        <source>Overshoot</source>
        <translation>Sobreimpulso</translation>
    </message>
    <message>
        <source>Undershoot</source>
        <translation>Subimpulso</translation>
    </message>
    <message>
        <source>Steady error</source>
        <translation>Error estacionario</translation>
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
        <translation>Corriente de pico</translation>
    </message>
    <message>
        <source>Duty chatter</source>
        <translation>Agitación del ciclo</translation>
    </message>
    <message>
        <source>Saturated</source>
        <translation>Saturado</translation>
    </message>
    <message>
        <source>Noise σ</source>
        <translation>Ruido σ</translation>
    </message>
    <message>
        <source>Step and back</source>
        <translation>Escalón y vuelta</translation>
    </message>
    <message>
        <source>Square</source>
        <translation>Cuadrada</translation>
    </message>
    <message>
        <source>Ramp</source>
        <translation>Rampa</translation>
    </message>
    <message>
        <source>Sine</source>
        <translation>Seno</translation>
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
        <translation>parado: %1</translation>
    </message>
    <message>
        <source>nobody saw its end</source>
        <translation>nadie vio su final</translation>
    </message>
    <message>
        <source>%1 samples lost</source>
        <translation>%1 muestras perdidas</translation>
    </message>
    <message>
        <source>saturated %1 %</source>
        <translation>saturado %1 %</translation>
    </message>
</context>
<context>
    <name>mb::TrialsHead</name>
    <message>
        <source>Flip A and B</source>
        <translation>Intercambiar A y B</translation>
    </message>
    <message>
        <source>Pin B as A</source>
        <translation>Fijar B como A</translation>
    </message>
    <message>
        <source>Cursors A and B</source>
        <translation>Cursores A y B</translation>
    </message>
    <message>
        <source>Fit time and value</source>
        <translation>Encajar tiempo y valor</translation>
    </message>
    <message>
        <source>A #%1 is another stimulus, it is not drawn</source>
        <translation>A #%1 tiene otra excitación y no se dibuja</translation>
    </message>
    <message>
        <source>Shift+click on a trial pins it as A</source>
        <translation>Mayús+clic en un ensayo lo fija como A</translation>
    </message>
    <message>
        <source>No trial yet. Run makes the first.</source>
        <translation>Aún no hay ensayos. Iniciar hace el primero.</translation>
    </message>
</context>
<context>
    <name>mb::TrialsView</name>
    <message>
        <source>Below the plot</source>
        <translation>Debajo de la gráfica</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Ensayos</translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation>Índices</translation>
    </message>
    <message>
        <source>not kept: %1</source>
        <translation>no conservado: %1</translation>
    </message>
</context>
<context>
    <name>mb::TriggerBar</name>
    <message>
        <source>Trigger off</source>
        <translation>Sin disparo</translation>
    </message>
    <message>
        <source>Arm again: forgets this event, waits for the next</source>
        <translation>Rearmar: olvida este evento y espera el siguiente</translation>
    </message>
    <message>
        <source>Trace that triggers</source>
        <translation>Curva que dispara</translation>
    </message>
    <message>
        <source>↑ rises through</source>
        <translation>↑ sube por</translation>
    </message>
    <message>
        <source>↓ falls through</source>
        <translation>↓ baja por</translation>
    </message>
    <message>
        <source>↕ crosses</source>
        <translation>↕ cruza</translation>
    </message>
    <message>
        <source>is above</source>
        <translation>está por encima</translation>
    </message>
    <message>
        <source>is below</source>
        <translation>está por debajo</translation>
    </message>
    <message>
        <source>Edge or level</source>
        <translation>Flanco o nivel</translation>
    </message>
    <message>
        <source>%1 % before</source>
        <translation>%1 % antes</translation>
    </message>
    <message>
        <source>Part of the window before the event</source>
        <translation>Parte de la ventana anterior al evento</translation>
    </message>
    <message>
        <source>What follows an event</source>
        <translation>Qué sigue a un evento</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normal</translation>
    </message>
    <message>
        <source>Single</source>
        <translation>Único</translation>
    </message>
    <message>
        <source>Normal shows every event, single stops at the first</source>
        <translation>Normal muestra cada evento, Único se detiene en el primero</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Nivel</translation>
    </message>
    <message>
        <source>The level; the handle ▸ at the left of the plot drags it, too</source>
        <translation>El nivel; también lo arrastra el tirador ▸ a la izquierda de la gráfica</translation>
    </message>
    <message>
        <source>trigger %1 %2 %3, %4 before</source>
        <translation>disparo %1 %2 %3, %4 antes</translation>
    </message>
</context>
<context>
    <name>mb::TuneAxes</name>
    <message>
        <source>%1 %2, at rest</source>
        <comment>mode and target</comment>
        <translation>%1 %2, en reposo</translation>
    </message>
    <message>
        <source>axis %1 moves in another mode; stop it first</source>
        <translation>el eje %1 se mueve en otro modo; párelo primero</translation>
    </message>
</context>
<context>
    <name>mb::TuneColumn</name>
    <message>
        <source>The power limit of axis %1 is unknown: its first motion sets it to %2. Write another under Limits of the axis.</source>
        <translation>El límite de potencia del eje %1 es desconocido: su primer movimiento lo fija en %2. Escriba otro en Límites del eje.</translation>
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
        <translation>Parar movimiento</translation>
    </message>
    <message>
        <source>Ends the motion and stays armed. STOP, Esc and Pause stop everything.</source>
        <translation>Termina el movimiento y sigue armado. STOP, Esc y Pausa lo detienen todo.</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Iniciar</translation>
    </message>
    <message>
        <source>Write and run</source>
        <translation>Escribir e iniciar</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Aplicar</translation>
    </message>
    <message>
        <source>Run %1 axes</source>
        <translation>Iniciar %1 ejes</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vista</translation>
    </message>
    <message>
        <source>Experiment</source>
        <translation>Experimento</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>En vivo</translation>
    </message>
    <message>
        <source>Stop axis %1</source>
        <translation>Parar eje %1</translation>
    </message>
</context>
<context>
    <name>mb::TuneExperiments</name>
    <message>
        <source>Experiment</source>
        <translation>Experimento</translation>
    </message>
    <message>
        <source>Moving</source>
        <translation>En movimiento</translation>
    </message>
    <message>
        <source>Stop the motion before an experiment.</source>
        <translation>Pare el movimiento antes de un experimento.</translation>
    </message>
    <message>
        <source>The stimulus cannot be sent</source>
        <translation>No se puede enviar la excitación</translation>
    </message>
    <message>
        <source>No experiment yet</source>
        <translation>Aún no hay experimento posible</translation>
    </message>
    <message>
        <source>No experiment in this mode</source>
        <translation>En este modo no hay experimentos</translation>
    </message>
    <message>
        <source>Armed</source>
        <translation>Armado</translation>
    </message>
    <message>
        <source>Not armed</source>
        <translation>No armado</translation>
    </message>
    <message>
        <source>Hold the Arm button for 1 s to arm %1.</source>
        <translation>Mantenga pulsado Armar 1 s para armar %1.</translation>
    </message>
    <message>
        <source>The position of axis %1 is not known yet</source>
        <translation>La posición del eje %1 aún no se conoce</translation>
    </message>
    <message>
        <source>no device</source>
        <translation>ningún dispositivo</translation>
    </message>
    <message>
        <source>its position is not known yet</source>
        <translation>su posición aún no se conoce</translation>
    </message>
    <message>
        <source>Run begins the experiment.</source>
        <translation>Iniciar comienza el experimento.</translation>
    </message>
</context>
<context>
    <name>mb::TuneForm</name>
    <message>
        <source>the running slot</source>
        <translation>la ranura en uso</translation>
    </message>
    <message>
        <source>a direction or a limit</source>
        <translation>un sentido o un límite</translation>
    </message>
    <message>
        <source>the mode</source>
        <translation>el modo</translation>
    </message>
</context>
<context>
    <name>mb::TuneFrame</name>
    <message>
        <source>Part of the page</source>
        <translation>Parte de la página</translation>
    </message>
    <message>
        <source>Set-up</source>
        <translation>Consigna</translation>
    </message>
    <message>
        <source>Plot</source>
        <translation>Gráfica</translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation>Índices</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Ensayos</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>En vivo</translation>
    </message>
</context>
<context>
    <name>mb::TuneGains</name>
    <message>
        <source>A gain is out of range</source>
        <translation>Una ganancia está fuera de rango</translation>
    </message>
    <message>
        <source>Correct or revert it first.</source>
        <translation>Corríjala o reviértala primero.</translation>
    </message>
    <message>
        <source>Look at a gain again</source>
        <translation>Vuelva a mirar una ganancia</translation>
    </message>
    <message>
        <source>Writing gains</source>
        <translation>Escribiendo ganancias</translation>
    </message>
    <message>
        <source>Reading gains</source>
        <translation>Leyendo ganancias</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>gains not written: %1</source>
        <translation>ganancias no escritas: %1</translation>
    </message>
    <message>
        <source>Gains of trial #%1</source>
        <translation>Ganancias del ensayo #%1</translation>
    </message>
    <message>
        <source>What the adviser proposes</source>
        <translation>Lo que propone el asesor</translation>
    </message>
    <message>
        <source>nothing copied: no gain of axis %1 is known for this mode; write it first</source>
        <translation>nada copiado: no se conoce ninguna ganancia del eje %1 para este modo; escríbala primero</translation>
    </message>
    <message>
        <source>Gains and limits of axis %1</source>
        <translation>Ganancias y límites del eje %1</translation>
    </message>
</context>
<context>
    <name>mb::TuneKeys</name>
    <message>
        <source>writes what is staged and runs</source>
        <translation>escribe lo pendiente e inicia</translation>
    </message>
    <message>
        <source>the same, four times over</source>
        <translation>lo mismo, cuatro veces seguidas</translation>
    </message>
    <message>
        <source>a battery of steps: several sizes, both ways, and the worst of them</source>
        <translation>una serie de escalones: varios tamaños, ambos sentidos y el peor de ellos</translation>
    </message>
    <message>
        <source>goes to the first gain</source>
        <translation>va a la primera ganancia</translation>
    </message>
    <message>
        <source>swaps the gain slots; disarms</source>
        <translation>intercambia las ranuras de ganancias; desarma</translation>
    </message>
    <message>
        <source>flips trials A and B</source>
        <translation>intercambia los ensayos A y B</translation>
    </message>
    <message>
        <source>pins trial B as A</source>
        <translation>fija el ensayo B como A</translation>
    </message>
    <message>
        <source>cursors in the plot: arrows move one, C changes to the other</source>
        <translation>cursores en la gráfica: las flechas mueven uno, C cambia al otro</translation>
    </message>
    <message>
        <source>fits time and value of the plot</source>
        <translation>encaja tiempo y valor de la gráfica</translation>
    </message>
    <message>
        <source>pauses the live view, and goes on</source>
        <translation>pausa la vista en vivo y la reanuda</translation>
    </message>
    <message>
        <source>identifies the device: it blinks</source>
        <translation>identifica el dispositivo: parpadea</translation>
    </message>
    <message>
        <source>undoes the last edit of gains, or else the last write to the unit</source>
        <translation>deshace la última edición de ganancias o, si no la hay, la última escritura en el equipo</translation>
    </message>
    <message>
        <source>writes a report of the trials that are shown</source>
        <translation>escribe un informe de los ensayos mostrados</translation>
    </message>
    <message>
        <source>held: moves the armed motor gently forwards or backwards</source>
        <translation>mantenido: mueve suavemente el motor armado hacia delante o hacia atrás</translation>
    </message>
    <message>
        <source>on a gain&apos;s slider: 2 %, with Shift 0.2 %, with Ctrl 20 %; the wheel does the same by 2 %</source>
        <translation>en el deslizador de una ganancia: 2 %, con Mayús 0,2 %, con Ctrl 20 %; la rueda hace lo mismo con 2 %</translation>
    </message>
    <message>
        <source>redoes the last edit or write</source>
        <translation>rehace la última edición o escritura</translation>
    </message>
</context>
<context>
    <name>mb::TuneMotion</name>
    <message>
        <source>position 0 is here; the motor is off until Run</source>
        <translation>la posición 0 está aquí; el motor está apagado hasta Iniciar</translation>
    </message>
    <message>
        <source>it has no lamp that could blink</source>
        <translation>no tiene ningún LED que pueda parpadear</translation>
    </message>
    <message>
        <source>not identified: %1</source>
        <translation>no identificado: %1</translation>
    </message>
    <message>
        <source>disarmed: %1 changed</source>
        <translation>desarmado: ha cambiado %1</translation>
    </message>
    <message>
        <source>Moving</source>
        <translation>En movimiento</translation>
    </message>
    <message>
        <source>Armed</source>
        <translation>Armado</translation>
    </message>
    <message>
        <source>Not armed</source>
        <translation>No armado</translation>
    </message>
    <message>
        <source>Hold the Arm button for 1 s to arm %1.</source>
        <translation>Mantenga pulsado Armar 1 s para armar %1.</translation>
    </message>
    <message>
        <source>axis %1: %2</source>
        <translation>eje %1: %2</translation>
    </message>
    <message>
        <source>%1, slot %2</source>
        <translation>%1, ranura %2</translation>
    </message>
    <message>
        <source> · also moving: axis %1</source>
        <translation> · también se mueve: eje %1</translation>
    </message>
    <message>
        <source>Its position is not known yet</source>
        <translation>Su posición aún no se conoce</translation>
    </message>
    <message>
        <source>It starts where it is once it has told where that is.</source>
        <translation>Empieza donde está, en cuanto haya dicho dónde es.</translation>
    </message>
    <message>
        <source>%1: holds</source>
        <translation>%1: mantiene</translation>
    </message>
    <message>
        <source>%1 by %2</source>
        <translation>%1 en %2</translation>
    </message>
    <message>
        <source>Run begins %1</source>
        <translation>Iniciar comienza %1</translation>
    </message>
</context>
<context>
    <name>mb::TunePage</name>
    <message>
        <source>disarmed: another device is selected</source>
        <translation>desarmado: se seleccionó otro dispositivo</translation>
    </message>
    <message>
        <source>%1 is in its bootloader</source>
        <translation>%1 está en su bootloader</translation>
    </message>
    <message>
        <source>It cannot drive a motor until it has firmware. Write an image on the Firmware page.</source>
        <translation>No puede accionar un motor hasta que tenga firmware. Escriba una imagen en la página Firmware.</translation>
    </message>
    <message>
        <source>Select a device</source>
        <translation>Seleccione un dispositivo</translation>
    </message>
    <message>
        <source>No device yet</source>
        <translation>Aún no hay dispositivos</translation>
    </message>
    <message>
        <source>Choose one in the list at the left; its loop is tuned here.</source>
        <translation>Elija uno en la lista de la izquierda; su lazo se ajusta aquí.</translation>
    </message>
    <message>
        <source>Open a link, or the simulated bench from the menu, to drive a motor.</source>
        <translation>Para accionar un motor, abra un enlace, o el banco simulado desde el menú.</translation>
    </message>
    <message>
        <source>No device</source>
        <translation>Ningún dispositivo</translation>
    </message>
    <message>
        <source>No answer from %1</source>
        <translation>Sin respuesta de %1</translation>
    </message>
    <message>
        <source>The plot keeps what it has.</source>
        <translation>La gráfica conserva lo que tiene.</translation>
    </message>
    <message>
        <source>Stopped: %1</source>
        <translation>Parado: %1</translation>
    </message>
    <message>
        <source>Hold the Arm button for 1 s to arm again.</source>
        <translation>Mantenga pulsado Armar 1 s para volver a armar.</translation>
    </message>
    <message>
        <source>%1 cannot be armed</source>
        <translation>%1 no se puede armar</translation>
    </message>
    <message>
        <source>The set-point cannot be sent</source>
        <translation>No se puede enviar la consigna</translation>
    </message>
    <message>
        <source>Something moves</source>
        <translation>Algo se mueve</translation>
    </message>
    <message>
        <source>Hold the Arm button for 1 s to arm it first.</source>
        <translation>Mantenga pulsado Armar 1 s para armarlo primero.</translation>
    </message>
    <message>
        <source>not run: %1. %2</source>
        <translation>no iniciado: %1. %2</translation>
    </message>
</context>
<context>
    <name>mb::TunePlot</name>
    <message>
        <source>Units</source>
        <translation>Unidades</translation>
    </message>
    <message>
        <source>counts</source>
        <translation>counts</translation>
    </message>
    <message>
        <source>rpm</source>
        <translation>rpm</translation>
    </message>
    <message>
        <source>Counts per revolution</source>
        <translation>Cuentas por vuelta</translation>
    </message>
    <message>
        <source>Encoder counts of one turn of the shaft, four for each line. Used for rpm, degrees and gains in physical units.</source>
        <translation>Cuentas del encoder en una vuelta del eje, cuatro por línea. Se usa para rpm, grados y ganancias en unidades físicas.</translation>
    </message>
    <message>
        <source>counts/rev</source>
        <translation>counts/vuelta</translation>
    </message>
    <message>
        <source>last %1 s</source>
        <translation>últimos %1 s</translation>
    </message>
    <message>
        <source>Length of the time axis</source>
        <translation>Longitud del eje de tiempo</translation>
    </message>
    <message>
        <source>Pause the view</source>
        <translation>Pausar la vista</translation>
    </message>
    <message>
        <source>Cursors A and B</source>
        <translation>Cursores A y B</translation>
    </message>
    <message>
        <source>Fit time and value</source>
        <translation>Encajar tiempo y valor</translation>
    </message>
    <message>
        <source>plot written to %1</source>
        <translation>gráfica escrita en %1</translation>
    </message>
    <message>
        <source>Set-point</source>
        <translation>Consigna</translation>
    </message>
    <message>
        <source>ch%1 set-point</source>
        <translation>ch%1 consigna</translation>
    </message>
    <message>
        <source>DEMO</source>
        <translation>DEMO</translation>
    </message>
</context>
<context>
    <name>mb::TuneSteps</name>
    <message>
        <source>Direction</source>
        <translation>Sentido</translation>
    </message>
    <message>
        <source>Envelope</source>
        <translation>Límites</translation>
    </message>
    <message>
        <source>Identify</source>
        <translation>Modelo</translation>
    </message>
    <message>
        <source>Gains</source>
        <translation>Ganancias</translation>
    </message>
    <message>
        <source>Verify</source>
        <translation>Verificar</translation>
    </message>
    <message>
        <source>Store</source>
        <translation>Guardar</translation>
    </message>
    <message>
        <source>The direction of motor and encoder was checked; the first closed loop of a run checks it again.</source>
        <translation>El sentido del motor y del encoder se comprobó; el primer lazo cerrado de una ejecución lo comprueba otra vez.</translation>
    </message>
    <message>
        <source>Checked by itself before the first closed loop of a run.</source>
        <translation>Se comprueba por sí solo antes del primer lazo cerrado de una ejecución.</translation>
    </message>
    <message>
        <source>Every limit of an experiment is known.</source>
        <translation>Se conocen todos los límites de un ensayo.</translation>
    </message>
    <message>
        <source>Trial #%1 pushed the motor without a loop.</source>
        <translation>El ensayo n.º %1 empujó el motor sin lazo.</translation>
    </message>
    <message>
        <source>The device has the gains that are shown.</source>
        <translation>El equipo tiene las ganancias que se muestran.</translation>
    </message>
    <message>
        <source>Edited gains wait to be written.</source>
        <translation>Las ganancias editadas esperan a ser escritas.</translation>
    </message>
    <message>
        <source>The gains of the device are not known yet.</source>
        <translation>Aún no se conocen las ganancias del equipo.</translation>
    </message>
    <message>
        <source>Trial #%1 ran with these gains.</source>
        <translation>El ensayo n.º %1 se hizo con estas ganancias.</translation>
    </message>
    <message>
        <source>The gains are in flash.</source>
        <translation>Las ganancias están en la flash.</translation>
    </message>
    <message>
        <source>The gains are not known to be in flash.</source>
        <translation>No se sabe si las ganancias están en la flash.</translation>
    </message>
    <message>
        <source>%1: done</source>
        <comment>step</comment>
        <translation>%1: hecho</translation>
    </message>
    <message>
        <source>Steps; next is %1</source>
        <translation>Pasos; sigue %1</translation>
    </message>
    <message>
        <source>Steps; all are done</source>
        <translation>Pasos; todos están hechos</translation>
    </message>
    <message>
        <source>The last check found it wrong: the encoder is reversed, or the motor did not move.</source>
        <translation>La última comprobación la encontró mal: el encóder está invertido o el motor no se movió.</translation>
    </message>
    <message>
        <source>No model of the motor yet: the page Design identifies it.</source>
        <translation>Aún no hay modelo del motor: la página Diseño lo identifica.</translation>
    </message>
    <message>
        <source>No trial with these gains yet: Run makes one.</source>
        <translation>Aún no hay ensayo con estas ganancias: Iniciar hace uno.</translation>
    </message>
</context>
<context>
    <name>mb::TuningSteps</name>
    <message>
        <source>Kept</source>
        <translation>Conservado</translation>
    </message>
    <message>
        <source>Proposed, nothing written</source>
        <translation>Propuesto, nada escrito</translation>
    </message>
    <message>
        <source>Rolled back</source>
        <translation>Restituido</translation>
    </message>
    <message>
        <source>Refused</source>
        <translation>Rechazado</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Parado</translation>
    </message>
    <message>
        <source>What happens</source>
        <translation>Qué ocurre</translation>
    </message>
    <message>
        <source>Working: the motor turns</source>
        <translation>En curso: el motor gira</translation>
    </message>
    <message>
        <source>STOP ends it at any moment; what was changed is put back.</source>
        <translation>STOP lo termina en cualquier momento; lo que se cambió se restituye.</translation>
    </message>
    <message>
        <source>Nothing has moved yet</source>
        <translation>Aún no se ha movido nada</translation>
    </message>
    <message>
        <source>over ≤ %1 %, settle ≤ %2, error ≤ %3 %</source>
        <translation>sobre ≤ %1 %, estab. ≤ %2, error ≤ %3 %</translation>
    </message>
    <message>
        <source>over ≤ %1 %, error ≤ %2 %</source>
        <translation>sobre ≤ %1 %, error ≤ %2 %</translation>
    </message>
    <message>
        <source>over %1 %, settle %2, error %3 %</source>
        <translation>sobre %1 %, estab. %2, error %3 %</translation>
    </message>
    <message>
        <source>Identify the motor</source>
        <translation>Identificar el motor</translation>
    </message>
    <message>
        <source>Pushes with a part of the duty, both ways. No gain is changed.</source>
        <translation>Empuja con una parte del ciclo, en ambos sentidos. No se cambia ninguna ganancia.</translation>
    </message>
    <message>
        <source>Choose a set</source>
        <translation>Elegir un juego</translation>
    </message>
    <message>
        <source>The plots show what each would do.</source>
        <translation>Las gráficas muestran qué haría cada uno.</translation>
    </message>
    <message>
        <source>Write and prove it</source>
        <translation>Escribirlo y verificarlo</translation>
    </message>
    <message>
        <source>The gains are written, steps both ways are measured.</source>
        <translation>Se escriben las ganancias y se miden escalones en ambos sentidos.</translation>
    </message>
    <message>
        <source>Keep it, or put everything back</source>
        <translation>Conservarlo o restituirlo todo</translation>
    </message>
    <message>
        <source>It stays if it does what was predicted; else the reason is said.</source>
        <translation>Se queda si hace lo previsto; si no, se indica el motivo.</translation>
    </message>
    <message>
        <source>Write %1 to slot %2</source>
        <translation>Escribir %1 en la ranura %2</translation>
    </message>
    <message>
        <source>Write %1</source>
        <translation>Escribir %1</translation>
    </message>
    <message>
        <source>The slot that the result is not for; what it had comes back.</source>
        <translation>La ranura a la que no va el resultado; lo que tenía vuelve.</translation>
    </message>
    <message>
        <source>What is replaced is kept, to be put back.</source>
        <translation>Lo que se sustituye se guarda para restituirlo.</translation>
    </message>
    <message>
        <source>Run %1 steps of %2 %3</source>
        <translation>Ejecutar %1 escalones de %2 %3</translation>
    </message>
    <message>
        <source>Both ways, every guard on; each is a trial.</source>
        <translation>En ambos sentidos, con todas las guardas; cada uno es un ensayo.</translation>
    </message>
    <message>
        <source>Keep it in slot %1 when all hold</source>
        <translation>Conservarlo en la ranura %1 si todo se cumple</translation>
    </message>
    <message>
        <source>Keep it when all hold</source>
        <translation>Conservarlo si todo se cumple</translation>
    </message>
    <message>
        <source>measured: %1</source>
        <translation>medido: %1</translation>
    </message>
    <message>
        <source>Else put everything back</source>
        <translation>Si no, restituirlo todo</translation>
    </message>
    <message>
        <source>Gains as before, the reason in the log.</source>
        <translation>Ganancias como antes, el motivo en el registro.</translation>
    </message>
    <message>
        <source>motor turns %1 s</source>
        <translation>el motor gira %1 s</translation>
    </message>
    <message>
        <source>Identify and Autotune push first: %1</source>
        <translation>Identificar y Autoajuste empujan primero: %1</translation>
    </message>
    <message>
        <source>Not kept</source>
        <translation>No conservado</translation>
    </message>
    <message>
        <source>Find the gains anew</source>
        <translation>Buscar de nuevo las ganancias</translation>
    </message>
    <message>
        <source>Those that are shown were found for other limits, or elsewhere.</source>
        <translation>Las que se muestran se hallaron con otros límites o en otro lugar.</translation>
    </message>
</context>
<context>
    <name>mb::UnitChecks</name>
    <message>
        <source>no unit answers yet</source>
        <translation>aún no responde ninguna unidad</translation>
    </message>
    <message numerus="yes">
        <source>%n units answer, one at a time</source>
        <translation>
            <numerusform>%n unidad responde</numerusform>
            <numerusform>%n unidades responden, una tras otra</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 may turn</source>
        <translation>%1 puede estar girando</translation>
    </message>
    <message>
        <source>no motor turns</source>
        <translation>ningún motor gira</translation>
    </message>
    <message>
        <source>no link is open</source>
        <translation>no hay ningún enlace abierto</translation>
    </message>
    <message>
        <source>%1 is open</source>
        <translation>%1 está abierto</translation>
    </message>
    <message>
        <source>the journal takes entries</source>
        <translation>el diario admite entradas</translation>
    </message>
    <message>
        <source>the journal keeps entries on this computer</source>
        <translation>el diario guarda las entradas en este equipo</translation>
    </message>
    <message>
        <source>Before each unit</source>
        <translation>Antes de cada unidad</translation>
    </message>
    <message>
        <source>%1 is not open</source>
        <translation>%1 no está abierto</translation>
    </message>
</context>
<context>
    <name>mb::UnitList</name>
    <message>
        <source>Last ten units, newest first</source>
        <translation>Últimos diez equipos, el más reciente primero</translation>
    </message>
</context>
<context>
    <name>mb::UnitStates</name>
    <message>
        <source>Device, now</source>
        <translation>Dispositivo, ahora</translation>
    </message>
    <message>
        <source>factory defaults</source>
        <translation>valores de fábrica</translation>
    </message>
    <message>
        <source>live</source>
        <translation>en vivo</translation>
    </message>
    <message numerus="yes">
        <source>%n values</source>
        <translation>
            <numerusform>%n valor</numerusform>
            <numerusform>%n valores</numerusform>
        </translation>
    </message>
    <message>
        <source>by hand, %1</source>
        <translation>a mano, %1</translation>
    </message>
    <message>
        <source>automatic, %1</source>
        <translation>automático, %1</translation>
    </message>
    <message>
        <source>from the device description</source>
        <translation>de la descripción del dispositivo</translation>
    </message>
</context>
<context>
    <name>mb::UnitSteps</name>
    <message>
        <source>Steps of this unit</source>
        <translation>Pasos de este equipo</translation>
    </message>
    <message>
        <source>Skip this unit</source>
        <translation>Omitir este equipo</translation>
    </message>
    <message>
        <source>Do it again</source>
        <translation>Hacerlo otra vez</translation>
    </message>
    <message>
        <source>No unit selected</source>
        <translation>Ningún equipo seleccionado</translation>
    </message>
</context>
<context>
    <name>mb::UnitUpdate</name>
    <message>
        <source>Verified: %1</source>
        <translation>Verificado: %1</translation>
    </message>
    <message>
        <source>Not needed: %1</source>
        <translation>No es necesario: %1</translation>
    </message>
    <message>
        <source>Refused: %1</source>
        <translation>Rechazado: %1</translation>
    </message>
    <message>
        <source>Failed: %1</source>
        <translation>Error: %1</translation>
    </message>
    <message>
        <source>Cancelled. %1.</source>
        <translation>Cancelado. %1.</translation>
    </message>
    <message>
        <source>device</source>
        <translation>dispositivo</translation>
    </message>
    <message>
        <source>firmware</source>
        <translation>firmware</translation>
    </message>
    <message>
        <source>image</source>
        <translation>imagen</translation>
    </message>
    <message>
        <source>Open image…</source>
        <translation>Abrir imagen…</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Paso</translation>
    </message>
    <message>
        <source>Progress of the update</source>
        <translation>Progreso de la actualización</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Update</source>
        <translation>Actualizar</translation>
    </message>
    <message>
        <source>Run the update again</source>
        <translation>Repetir la actualización</translation>
    </message>
    <message>
        <source>One update a bus: %1 is being written.</source>
        <translation>Una actualización por bus: se está escribiendo %1.</translation>
    </message>
    <message>
        <source>no device selected</source>
        <translation>ningún dispositivo seleccionado</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguna</translation>
    </message>
    <message>
        <source>%1 → %2</source>
        <translation>%1 → %2</translation>
    </message>
    <message>
        <source>image fits this family</source>
        <translation>la imagen es de esta familia</translation>
    </message>
    <message>
        <source>no usable image</source>
        <translation>ninguna imagen utilizable</translation>
    </message>
    <message>
        <source>motor is moving</source>
        <translation>motor en movimiento</translation>
    </message>
    <message>
        <source>motor stopped</source>
        <translation>motor parado</translation>
    </message>
    <message>
        <source>no other master, number unique</source>
        <translation>sin otro maestro, número único</translation>
    </message>
    <message>
        <source>another master, or a number taken twice</source>
        <translation>otro maestro o número duplicado</translation>
    </message>
    <message>
        <source>no device</source>
        <translation>ningún dispositivo</translation>
    </message>
    <message>
        <source>%1 s a page, about %2 s left</source>
        <translation>%1 s por página, quedan unos %2 s</translation>
    </message>
    <message>
        <source>Nothing running</source>
        <translation>Nada en curso</translation>
    </message>
    <message>
        <source>%1, %2 of %3 written</source>
        <translation>%1, %2 de %3 escritas</translation>
    </message>
    <message>
        <source>%1 s, pages sent again: %2</source>
        <translation>%1 s, páginas reenviadas: %2</translation>
    </message>
    <message>
        <source>Open a firmware image</source>
        <translation>Abrir una imagen de firmware</translation>
    </message>
    <message>
        <source>Intel HEX (*.hex *.ihex);;All files (*)</source>
        <translation>Intel HEX (*.hex *.ihex);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>motor not known</source>
        <translation>motor desconocido</translation>
    </message>
    <message>
        <source>Cancelled: %1</source>
        <translation>Cancelado: %1</translation>
    </message>
    <message>
        <source>Cancelled: nothing was written.</source>
        <translation>Cancelado: no se escribió nada.</translation>
    </message>
    <message>
        <source>%1, as in the image</source>
        <translation>%1, como en la imagen</translation>
    </message>
    <message>
        <source>Written, not proved: %1</source>
        <translation>Escrito, sin demostrar: %1</translation>
    </message>
    <message>
        <source>%1 has changed since it was opened and is read again; start the update once more</source>
        <translation>%1 ha cambiado desde que se abrió y se ha leído de nuevo; inicie la actualización otra vez</translation>
    </message>
    <message>
        <source>Before start</source>
        <translation>Antes de empezar</translation>
    </message>
    <message>
        <source>Units are served on this link.</source>
        <translation>Se atienden equipos en este enlace.</translation>
    </message>
</context>
<context>
    <name>mb::UpdateLog</name>
    <message>
        <source>Log</source>
        <translation>Registro</translation>
    </message>
    <message>
        <source>Save log…</source>
        <translation>Guardar registro…</translation>
    </message>
    <message>
        <source>Log of the update</source>
        <translation>Registro de la actualización</translation>
    </message>
    <message>
        <source>Save the log of the update</source>
        <translation>Guardar el registro de la actualización</translation>
    </message>
    <message>
        <source>Text (*.log *.txt)</source>
        <translation>Texto (*.log *.txt)</translation>
    </message>
</context>
<context>
    <name>mb::UpdateSide</name>
    <message>
        <source>Flash pages</source>
        <translation>Páginas de flash</translation>
    </message>
    <message>
        <source>In the order they are written. Green: written. Amber edge: sent again. Dashed: not in the image. Red: must not be cut.</source>
        <translation>En el orden en que se escriben. Verde: escrita. Borde ámbar: reenviada. A trazos: no está en la imagen. Rojo: no interrumpir.</translation>
    </message>
    <message>
        <source>Do not unplug</source>
        <translation>No desconectar</translation>
    </message>
    <message>
        <source>Safe to unplug</source>
        <translation>Se puede desconectar</translation>
    </message>
    <message>
        <source>Nothing is written now</source>
        <translation>Ahora no se escribe nada</translation>
    </message>
    <message>
        <source>The motor turns as soon as Arm in the header is held.</source>
        <translation>El motor gira en cuanto se mantiene Armar en la cabecera.</translation>
    </message>
    <message>
        <source>The self-test turns the motor.</source>
        <translation>La autoprueba gira el motor.</translation>
    </message>
</context>
<context>
    <name>mb::VerdictView</name>
    <message>
        <source>READY</source>
        <translation>LISTO</translation>
    </message>
    <message>
        <source>WORKING</source>
        <translation>EN CURSO</translation>
    </message>
    <message>
        <source>PASS</source>
        <translation>SUPERADO</translation>
    </message>
    <message>
        <source>FAIL</source>
        <translation>NO SUPERADO</translation>
    </message>
    <message>
        <source>REFUSED</source>
        <translation>RECHAZADO</translation>
    </message>
    <message>
        <source>LEFT OUT</source>
        <translation>OMITIDO</translation>
    </message>
</context>
<context>
    <name>mb::Welcome</name>
    <message>
        <source>Folder with firmware</source>
        <translation>Carpeta con firmware</translation>
    </message>
</context>
<context>
    <name>mb::WindowKeys</name>
    <message>
        <source>shows these keys; once more, the help for this page</source>
        <translation>muestra estas teclas; otra vez, la ayuda de esta página</translation>
    </message>
    <message>
        <source>production: unit after unit, full screen; and back</source>
        <translation>producción: equipo tras equipo, a pantalla completa; y vuelta</translation>
    </message>
    <message>
        <source>shows page %1</source>
        <translation>muestra la página %1</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Ventana</translation>
    </message>
    <message>
        <source>Menu</source>
        <translation>Menú</translation>
    </message>
    <message>
        <source>renames the selected device; in production: goes to the serial number</source>
        <translation>renombra el dispositivo seleccionado; en producción: va al número de serie</translation>
    </message>
    <message>
        <source>stores what the selected device has in RAM only</source>
        <translation>guarda lo que el dispositivo seleccionado solo tiene en RAM</translation>
    </message>
    <message>
        <source>takes a snapshot of the selected device</source>
        <translation>toma una instantánea del dispositivo seleccionado</translation>
    </message>
</context>
<context>
    <name>mb::WindowMenu</name>
    <message>
        <source>Add link…</source>
        <translation>Añadir enlace…</translation>
    </message>
    <message>
        <source>Open recording…</source>
        <translation>Abrir grabación…</translation>
    </message>
    <message>
        <source>Open the simulated bench</source>
        <translation>Abrir el banco simulado</translation>
    </message>
    <message>
        <source>Open the folder of a machine…</source>
        <translation>Abrir la carpeta de una máquina…</translation>
    </message>
    <message>
        <source>Save the machine into a folder…</source>
        <translation>Guardar la máquina en una carpeta…</translation>
    </message>
    <message>
        <source>Commands…</source>
        <translation>Órdenes…</translation>
    </message>
    <message>
        <source>Switch between dark and light</source>
        <translation>Cambiar entre oscuro y claro</translation>
    </message>
    <message>
        <source>Preferences…</source>
        <translation>Preferencias…</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Ayuda</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Teclas</translation>
    </message>
    <message>
        <source>About MotorBench</source>
        <translation>Acerca de MotorBench</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Salir</translation>
    </message>
    <message>
        <source>Open a recording</source>
        <translation>Abrir una grabación</translation>
    </message>
    <message>
        <source>All recordings (*.log *.asc *.txt *.mcap *.csv)</source>
        <translation>Todas las grabaciones (*.log *.asc *.txt *.mcap *.csv)</translation>
    </message>
    <message>
        <source>Frames: candump and Vector ASC logs (*.log *.asc *.txt)</source>
        <translation>Tramas: registros candump y Vector ASC (*.log *.asc *.txt)</translation>
    </message>
    <message>
        <source>Samples: MCAP, CSV (*.mcap *.csv)</source>
        <translation>Muestras: MCAP, CSV (*.mcap *.csv)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Todos los archivos (*)</translation>
    </message>
    <message>
        <source>lists everything that can be done, by name</source>
        <translation>enumera por nombre todo lo que se puede hacer</translation>
    </message>
    <message>
        <source>shows the preferences</source>
        <translation>muestra las preferencias</translation>
    </message>
    <message>
        <source>switches between dark and light</source>
        <translation>cambia entre oscuro y claro</translation>
    </message>
    <message>
        <source>opens a recording</source>
        <translation>abre una grabación</translation>
    </message>
    <message>
        <source>quits</source>
        <translation>sale del programa</translation>
    </message>
</context>
<context>
    <name>table</name>
    <message>
        <source>Position</source>
        <translation>Posición</translation>
    </message>
    <message>
        <source>Velocity</source>
        <translation>Velocidad</translation>
    </message>
    <message>
        <source>Current</source>
        <translation>Corriente</translation>
    </message>
    <message>
        <source>Duty</source>
        <translation>Ciclo de trabajo</translation>
    </message>
    <message>
        <source>Set-point</source>
        <translation>Consigna</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>Temperatura</translation>
    </message>
    <message>
        <source>F: the firmware&apos;s codes</source>
        <translation>F: códigos del firmware</translation>
    </message>
    <message>
        <source>A unit that speaks the document&apos;s codes would take position for current and current for position.</source>
        <translation>Un equipo que usa los códigos del documento tomaría posición por corriente y corriente por posición.</translation>
    </message>
    <message>
        <source>L: legacy frames of 8 bytes</source>
        <translation>L: tramas antiguas de 8 bytes</translation>
    </message>
    <message>
        <source>A unit with today&apos;s firmware ignores these frames, the stop excepted, which is sent both ways.</source>
        <translation>Un equipo con firmware actual ignora estas tramas, salvo la parada, que se envía de ambas formas.</translation>
    </message>
    <message>
        <source>LL: older, cannot be stopped</source>
        <translation>LL: más antiguo, no se puede parar</translation>
    </message>
    <message>
        <source>It is only watched: there is no code that stops it.</source>
        <translation>Solo se observa: no hay ningún código que lo pare.</translation>
    </message>
    <message>
        <source>D: the document&apos;s codes</source>
        <translation>D: códigos del documento</translation>
    </message>
    <message>
        <source>A unit that speaks the firmware&apos;s codes runs at full power when it is told a position, and loses its divisor when D is written.</source>
        <translation>Un equipo que usa los códigos del firmware marcha a plena potencia cuando se le indica una posición, y pierde su divisor cuando se escribe D.</translation>
    </message>
    <message>
        <source>Counts per revolution</source>
        <translation>Cuentas por vuelta</translation>
    </message>
    <message>
        <source>Encoder edges in one turn: four times its lines.</source>
        <translation>Flancos del encoder en una vuelta: cuatro veces sus líneas.</translation>
    </message>
    <message>
        <source>Ampere per count</source>
        <translation>Amperios por cuenta</translation>
    </message>
    <message>
        <source>What one count of the current converter stands for; it depends on the board.</source>
        <translation>Lo que representa una cuenta del convertidor de corriente; depende de la placa.</translation>
    </message>
    <message>
        <source>Degrees per count</source>
        <translation>Grados por cuenta</translation>
    </message>
    <message>
        <source>What one count of the temperature converter stands for; it depends on the board.</source>
        <translation>Lo que representa una cuenta del convertidor de temperatura; depende de la placa.</translation>
    </message>
    <message>
        <source>Nothing is written yet; the update can be run again</source>
        <translation>Aún no se ha escrito nada; la actualización se puede repetir</translation>
    </message>
    <message>
        <source>The flash is being written: it must not be cut</source>
        <translation>Se está escribiendo la flash: no debe interrumpirse</translation>
    </message>
    <message>
        <source>A unit that is cut while it is written holds half a program. It runs again once an update has succeeded.</source>
        <translation>Un equipo interrumpido durante la escritura contiene medio programa. Vuelve a funcionar cuando una actualización se complete.</translation>
    </message>
    <message>
        <source>output saturated</source>
        <translation>salida saturada</translation>
    </message>
    <message>
        <source>output wrapped around</source>
        <translation>salida desbordada</translation>
    </message>
    <message>
        <source>count/s</source>
        <translation>count/s</translation>
    </message>
    <message>
        <source>ADC count</source>
        <translation>cuenta ADC</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>OpenOCD finds no debug probe</source>
        <translation>OpenOCD no encuentra ninguna sonda de depuración</translation>
    </message>
    <message>
        <source>plug it in, and check that its kind is the one named after openocd:</source>
        <translation>conéctela y compruebe que su tipo sea el indicado tras openocd:</translation>
    </message>
    <message>
        <source>OpenOCD has no interface of this name</source>
        <translation>OpenOCD no tiene ninguna interfaz con este nombre</translation>
    </message>
    <message>
        <source>name one of its interface files, such as openocd:stlink</source>
        <translation>indique uno de sus archivos de interfaz, como openocd:stlink</translation>
    </message>
    <message>
        <source>this interface does not speak SWD</source>
        <translation>esta interfaz no admite SWD</translation>
    </message>
    <message>
        <source>name a debug probe that does, such as openocd:stlink</source>
        <translation>indique una sonda de depuración que lo admita, como openocd:stlink</translation>
    </message>
    <message>
        <source>the microcontroller does not hold what was written</source>
        <translation>el microcontrolador no contiene lo que se escribió</translation>
    </message>
    <message>
        <source>run it again with shorter wires or a lower speed</source>
        <translation>repítalo con cables más cortos o menor velocidad</translation>
    </message>
    <message>
        <source>the microcontroller refused to be written</source>
        <translation>el microcontrolador rechazó la escritura</translation>
    </message>
    <message>
        <source>it may be protected, or be another kind than --target says</source>
        <translation>puede estar protegido o ser de otro tipo que el indicado en --target</translation>
    </message>
    <message>
        <source>the microcontroller is another kind than --target says</source>
        <translation>el microcontrolador es de otro tipo que el indicado en --target</translation>
    </message>
    <message>
        <source>choose the other one of f1 and f4</source>
        <translation>elija el otro entre f1 y f4</translation>
    </message>
    <message>
        <source>the probe is there, but no microcontroller answers it</source>
        <translation>la sonda está, pero ningún microcontrolador le responde</translation>
    </message>
    <message>
        <source>check SWDIO, SWCLK, ground and the power of the drive</source>
        <translation>compruebe SWDIO, SWCLK, masa y la alimentación del accionamiento</translation>
    </message>
    <message>
        <source>the microcontroller could not be halted</source>
        <translation>no se pudo detener el microcontrolador</translation>
    </message>
    <message>
        <source>check the reset wire and the power of the drive</source>
        <translation>compruebe el cable de reset y la alimentación del accionamiento</translation>
    </message>
    <message>
        <source>the debug probe is there but may not be opened</source>
        <translation>la sonda de depuración está, pero no se permite abrirla</translation>
    </message>
    <message>
        <source>install OpenOCD&apos;s udev rules or ask your administrator</source>
        <translation>instale las reglas udev de OpenOCD o consulte al administrador</translation>
    </message>
    <message>
        <source>Velocity loop</source>
        <translation>Lazo de velocidad</translation>
    </message>
    <message>
        <source>Current loop</source>
        <translation>Lazo de corriente</translation>
    </message>
    <message>
        <source>Position loop</source>
        <translation>Lazo de posición</translation>
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
        <translation>Salida (255 = 100 %) por unidad de error, por el divisor. Por encima de 32767 la salida salta a plena marcha atrás: el programa mantiene las consignas lo bastante cerca del motor para evitarlo.</translation>
    </message>
    <message>
        <source>Output per unit of error and millisecond, times the divisor. Each step of 20 ms is cut to a whole number, so small gains do nothing, and nothing limits the sum.</source>
        <translation>Salida por unidad de error y milisegundo, por el divisor. Cada paso de 20 ms se trunca a un entero, así que las ganancias pequeñas no hacen nada, y nada limita la suma.</translation>
    </message>
    <message>
        <source>Output times milliseconds per change of error, times the divisor. Its sign is inverted in the drive: only negative numbers damp.</source>
        <translation>Salida por milisegundos por variación del error, por el divisor. Su signo está invertido en el accionamiento: solo amortiguan los números negativos.</translation>
    </message>
    <message>
        <source>Averaging</source>
        <translation>Promediado</translation>
    </message>
    <message>
        <source>Loop error</source>
        <translation>Error del lazo</translation>
    </message>
    <message>
        <source>Supply</source>
        <translation>Alimentación</translation>
    </message>
    <message>
        <source>Analog input</source>
        <translation>Entrada analógica</translation>
    </message>
    <message>
        <source>count/100&#xa0;ms</source>
        <translation>count/100 ms</translation>
    </message>
    <message>
        <source>A</source>
        <translation>A</translation>
    </message>
    <message>
        <source>loop</source>
        <translation>ciclo de lazo</translation>
    </message>
    <message>
        <source>over-current</source>
        <translation>sobrecorriente</translation>
    </message>
    <message>
        <source>over-temperature</source>
        <translation>sobretemperatura</translation>
    </message>
    <message>
        <source>under-voltage</source>
        <translation>subtensión</translation>
    </message>
    <message>
        <source>gate driver</source>
        <translation>driver de puerta</translation>
    </message>
    <message>
        <source>communication</source>
        <translation>comunicación</translation>
    </message>
    <message>
        <source>The unit then waits in its bootloader; the update can be run again</source>
        <translation>El equipo espera entonces en su bootloader; la actualización se puede repetir</translation>
    </message>
    <message>
        <source>Page 0 is being written: it must not be cut</source>
        <translation>Se está escribiendo la página 0: no debe interrumpirse</translation>
    </message>
    <message>
        <source>A unit that is cut stays in its bootloader and can be updated again. Only page 0, the last, must not be interrupted.</source>
        <translation>Un equipo interrumpido queda en su bootloader y se puede actualizar de nuevo. Solo la página 0, la última, no debe interrumpirse.</translation>
    </message>
    <message>
        <source>Page 0 holds the reset vector. A cut now cannot be repaired over the bus.</source>
        <translation>La página 0 contiene el vector de reset. Una interrupción ahora no se puede reparar por el bus.</translation>
    </message>
    <message>
        <source>Limit switches</source>
        <translation>Finales de carrera</translation>
    </message>
    <message>
        <source>Soft limits</source>
        <translation>Límites por software</translation>
    </message>
    <message>
        <source>Loop, slot 0</source>
        <translation>Lazo, ranura 0</translation>
    </message>
    <message>
        <source>Loop, slot 1</source>
        <translation>Lazo, ranura 1</translation>
    </message>
    <message>
        <source>Current limiter</source>
        <translation>Limitador de corriente</translation>
    </message>
    <message>
        <source>Encoder</source>
        <translation>Encoder</translation>
    </message>
    <message>
        <source>Faults</source>
        <translation>Fallos</translation>
    </message>
    <message>
        <source>Current limit</source>
        <translation>Límite de corriente</translation>
    </message>
    <message>
        <source>Status frames</source>
        <translation>Tramas de estado</translation>
    </message>
    <message>
        <source>Normally closed is hit when the switch opens, normally open when it closes. A hit blocks output in this direction.</source>
        <translation>Un contacto normalmente cerrado actúa al abrirse, uno normalmente abierto al cerrarse. Al actuar, bloquea la salida en este sentido.</translation>
    </message>
    <message>
        <source>On switches the limit OFF: the sense is the opposite of the soft limits&apos; Enabled.</source>
        <translation>Encendido DESACTIVA el límite: al revés que «activado» en los límites por software.</translation>
    </message>
    <message>
        <source>Output (32767 = 100 %) per unit of error: counts/100 ms, counts or A, depending on the mode.</source>
        <translation>Salida (32767 = 100 %) por unidad de error: counts/100 ms, counts o A, según el modo.</translation>
    </message>
    <message>
        <source>Output per unit of error and loop of 500 µs. With F·K = 1 any I overshoots.</source>
        <translation>Salida por unidad de error y ciclo de lazo de 500 µs. Con F·K = 1 cualquier I produce sobreimpulso.</translation>
    </message>
    <message>
        <source>Output per change of error in one loop of 500 µs. One count of noise makes a spike of D.</source>
        <translation>Salida por variación del error en un ciclo de lazo de 500 µs. Una cuenta de ruido produce un pico de D.</translation>
    </message>
    <message>
        <source>Bound of the integral accumulator, raw integer. 0 means unlimited, not zero.</source>
        <translation>Límite del acumulador integral, entero bruto. 0 significa sin límite, no cero.</translation>
    </message>
    <message>
        <source>Output per unit of set-point, added to P, I and D.</source>
        <translation>Salida por unidad de consigna, sumada a P, I y D.</translation>
    </message>
    <message>
        <source>Below it P, I and D contribute nothing and the integral is cleared; F still applies. 0 switches the feature off.</source>
        <translation>Por debajo, P, I y D no aportan nada y la integral se borra; F sigue actuando. 0 desactiva la función.</translation>
    </message>
    <message>
        <source>Greatest change of output in a loop of 500 µs; 16 takes 1.024 s from 0 to 100 %. Lower is slower, but 0 is no ramp.</source>
        <translation>Variación máxima de la salida en un ciclo de lazo de 500 µs; 16 tarda 1,024 s de 0 a 100 %. Menor es más lento, pero 0 es sin rampa.</translation>
    </message>
    <message>
        <source>Greatest forward output, 32767 = 100 %.</source>
        <translation>Salida máxima hacia delante, 32767 = 100 %.</translation>
    </message>
    <message>
        <source>Greatest reverse output, −32768 = −100 %. A number at or below 0.</source>
        <translation>Salida máxima hacia atrás, −32768 = −100 %. Un número menor o igual que 0.</translation>
    </message>
    <message>
        <source>Least forward output outside the allowable error; overcomes friction. Closed-loop modes only.</source>
        <translation>Salida mínima hacia delante fuera del error admisible; vence la fricción. Solo en lazo cerrado.</translation>
    </message>
    <message>
        <source>Least reverse output outside the allowable error, a number at or below 0. Closed-loop modes only.</source>
        <translation>Salida mínima hacia atrás fuera del error admisible, un número menor o igual que 0. Solo en lazo cerrado.</translation>
    </message>
    <message>
        <source>Keeps clearing as long as the switch is active, even if its limit is disabled. Lost at power-off.</source>
        <translation>Sigue borrando mientras el final de carrera esté activo, aunque su límite esté desactivado. Se pierde al apagar.</translation>
    </message>
    <message>
        <source>Writing anything but 0 reads the count and clears it.</source>
        <translation>Escribir algo distinto de 0 lee la cuenta y la borra.</translation>
    </message>
    <message>
        <source>Forward switch is normally closed</source>
        <translation>Contacto adelante NC</translation>
    </message>
    <message>
        <source>Forward switch disabled</source>
        <translation>Contacto adelante inactivo</translation>
    </message>
    <message>
        <source>Reverse switch is normally closed</source>
        <translation>Contacto atrás NC</translation>
    </message>
    <message>
        <source>Reverse switch disabled</source>
        <translation>Contacto atrás inactivo</translation>
    </message>
    <message>
        <source>Forward soft limit</source>
        <translation>Límite sw. adelante</translation>
    </message>
    <message>
        <source>At or above this position forward output is blocked, if enabled.</source>
        <translation>Desde esta posición en adelante se bloquea la salida hacia delante, si está activado.</translation>
    </message>
    <message>
        <source>Forward soft limit enabled</source>
        <translation>Límite sw. adelante activado</translation>
    </message>
    <message>
        <source>On switches the limit ON: the sense is the opposite of the switches&apos; Disabled.</source>
        <translation>Encendido ACTIVA el límite: al revés que «inactivo» en los contactos.</translation>
    </message>
    <message>
        <source>Reverse soft limit</source>
        <translation>Límite sw. atrás</translation>
    </message>
    <message>
        <source>At or below this position reverse output is blocked, if enabled.</source>
        <translation>Desde esta posición hacia abajo se bloquea la salida hacia atrás, si está activado.</translation>
    </message>
    <message>
        <source>Reverse soft limit enabled</source>
        <translation>Límite sw. atrás activado</translation>
    </message>
    <message>
        <source>Current scale</source>
        <translation>Escala de corriente</translation>
    </message>
    <message>
        <source>Calibrated at the factory. All current limiting depends on it: change it only to trim the reading.</source>
        <translation>Calibrada en fábrica. Toda la limitación de corriente depende de ella: cámbiela solo para corregir la lectura.</translation>
    </message>
    <message>
        <source>I zone</source>
        <translation>Zona I</translation>
    </message>
    <message>
        <source>Allowable error</source>
        <translation>Error admisible</translation>
    </message>
    <message>
        <source>Ramp</source>
        <translation>Rampa</translation>
    </message>
    <message>
        <source>Maximum forward</source>
        <translation>Máximo adelante</translation>
    </message>
    <message>
        <source>Maximum reverse</source>
        <translation>Máximo atrás</translation>
    </message>
    <message>
        <source>Nominal forward</source>
        <translation>Nominal adelante</translation>
    </message>
    <message>
        <source>Nominal reverse</source>
        <translation>Nominal atrás</translation>
    </message>
    <message>
        <source>The factory value suits most motors.</source>
        <translation>El valor de fábrica sirve para la mayoría de los motores.</translation>
    </message>
    <message>
        <source>The live count. Written only while the output is off.</source>
        <translation>La cuenta actual. Solo se escribe con la salida apagada.</translation>
    </message>
    <message>
        <source>Index clears position</source>
        <translation>El índice borra la posición</translation>
    </message>
    <message>
        <source>At the index edge chosen below. Lost at power-off.</source>
        <translation>En el flanco del índice elegido abajo. Se pierde al apagar.</translation>
    </message>
    <message>
        <source>Forward switch clears position</source>
        <translation>Contacto adelante borra la posición</translation>
    </message>
    <message>
        <source>Reverse switch clears position</source>
        <translation>Contacto atrás borra la posición</translation>
    </message>
    <message>
        <source>Index acts on its rising edge</source>
        <translation>Índice en flanco de subida</translation>
    </message>
    <message>
        <source>Off is the falling edge. Lost at power-off.</source>
        <translation>Apagado es el flanco de bajada. Se pierde al apagar.</translation>
    </message>
    <message>
        <source>Present faults</source>
        <translation>Fallos presentes</translation>
    </message>
    <message>
        <source>1 over-current, 2 over-temperature, 4 under-voltage, 8 gate driver, 16 communication.</source>
        <translation>1 sobrecorriente, 2 sobretemperatura, 4 subtensión, 8 driver de puerta, 16 comunicación.</translation>
    </message>
    <message>
        <source>Faults since the last clear</source>
        <translation>Fallos desde el último borrado</translation>
    </message>
    <message>
        <source>The bits of the present faults. Writing anything but 0 reads them and clears them.</source>
        <translation>Los bits de los fallos presentes. Escribir algo distinto de 0 los lee y los borra.</translation>
    </message>
    <message>
        <source>Over-current count</source>
        <translation>Sobrecorrientes</translation>
    </message>
    <message>
        <source>Over-temperature count</source>
        <translation>Sobretemperaturas</translation>
    </message>
    <message>
        <source>Under-voltage count</source>
        <translation>Subtensiones</translation>
    </message>
    <message>
        <source>Supply below 5.75 V for 5 s. Writing anything but 0 reads the count and clears it.</source>
        <translation>Alimentación por debajo de 5,75 V durante 5 s. Escribir algo distinto de 0 lee la cuenta y la borra.</translation>
    </message>
    <message>
        <source>Gate driver count</source>
        <translation>Fallos del driver de puerta</translation>
    </message>
    <message>
        <source>Usually a short between M+ and M−. Writing anything but 0 reads the count and clears it.</source>
        <translation>Normalmente un cortocircuito entre M+ y M−. Escribir algo distinto de 0 lee la cuenta y la borra.</translation>
    </message>
    <message>
        <source>Communication loss count</source>
        <translation>Pérdidas de comunicación</translation>
    </message>
    <message>
        <source>Since the last power-up. Writing anything but 0 reads the count and clears it.</source>
        <translation>Desde el último encendido. Escribir algo distinto de 0 lee la cuenta y la borra.</translation>
    </message>
    <message>
        <source>Continuous limit</source>
        <translation>Límite continuo</translation>
    </message>
    <message>
        <source>At or above the peak limit, limiting starts as soon as this is exceeded.</source>
        <translation>Si no es menor que el límite de pico, la limitación empieza en cuanto se supera.</translation>
    </message>
    <message>
        <source>Peak limit</source>
        <translation>Límite de pico</translation>
    </message>
    <message>
        <source>Above it for the peak duration, the current is brought down to the continuous limit.</source>
        <translation>Si se supera durante la duración de pico, la corriente se reduce al límite continuo.</translation>
    </message>
    <message>
        <source>Peak duration</source>
        <translation>Duración de pico</translation>
    </message>
    <message>
        <source>Time above the peak limit before limiting starts; 0 limits at once.</source>
        <translation>Tiempo por encima del límite de pico antes de limitar; 0 limita de inmediato.</translation>
    </message>
    <message>
        <source>Current limit enabled</source>
        <translation>Límite de corriente activado</translation>
    </message>
    <message>
        <source>Off is the factory setting: nothing limits the current.</source>
        <translation>Apagado es el ajuste de fábrica: nada limita la corriente.</translation>
    </message>
    <message>
        <source>Analog period</source>
        <translation>Periodo analógico</translation>
    </message>
    <message>
        <source>Milliseconds between frames, although the vendor calls it a rate. Back to 100 at every restart.</source>
        <translation>Milisegundos entre tramas, aunque el fabricante lo llame frecuencia. Vuelve a 100 en cada reinicio.</translation>
    </message>
    <message>
        <source>Encoder period</source>
        <translation>Periodo del encoder</translation>
    </message>
    <message>
        <source>General period</source>
        <translation>Periodo general</translation>
    </message>
    <message>
        <source>Milliseconds between frames. At most 50, because followers stop after 104 ms without one.</source>
        <translation>Milisegundos entre tramas. Como máximo 50, porque los seguidores se paran tras 104 ms sin ninguna.</translation>
    </message>
    <message>
        <source>current is limited</source>
        <translation>la corriente está limitada</translation>
    </message>
    <message>
        <source>Forward limit switch</source>
        <translation>Final de carrera adelante</translation>
    </message>
    <message>
        <source>forward limit switch holds</source>
        <translation>actúa el final de carrera adelante</translation>
    </message>
    <message>
        <source>Reverse limit switch</source>
        <translation>Final de carrera atrás</translation>
    </message>
    <message>
        <source>reverse limit switch holds</source>
        <translation>actúa el final de carrera atrás</translation>
    </message>
    <message>
        <source>forward soft limit holds</source>
        <translation>actúa el límite por software adelante</translation>
    </message>
    <message>
        <source>reverse soft limit holds</source>
        <translation>actúa el límite por software atrás</translation>
    </message>
    <message>
        <source>Limit override</source>
        <translation>Anulación de límites</translation>
    </message>
    <message>
        <source>the set-point decides which limit switches count</source>
        <translation>la consigna decide qué finales de carrera cuentan</translation>
    </message>
    <message>
        <source>Halt</source>
        <translation>Detención</translation>
    </message>
    <message>
        <source>halted</source>
        <translation>detenido</translation>
    </message>
    <message>
        <source>Pin of the forward limit switch</source>
        <translation>Pin del final de carrera adelante</translation>
    </message>
    <message>
        <source>Pin of the reverse limit switch</source>
        <translation>Pin del final de carrera atrás</translation>
    </message>
    <message>
        <source>Encoder pin A</source>
        <translation>Pin A del encoder</translation>
    </message>
    <message>
        <source>Encoder pin B</source>
        <translation>Pin B del encoder</translation>
    </message>
    <message>
        <source>Encoder index pin</source>
        <translation>Pin de índice del encoder</translation>
    </message>
    <message>
        <source>baud rate</source>
        <translation>velocidad en baudios</translation>
    </message>
    <message>
        <source>From the data sheet.</source>
        <translation>De la hoja de datos.</translation>
    </message>
    <message>
        <source>format</source>
        <translation>formato</translation>
    </message>
    <message>
        <source>Data bits, parity, stop bits. Not told.</source>
        <translation>Bits de datos, paridad, bits de parada. No indicado.</translation>
    </message>
    <message>
        <source>line ending</source>
        <translation>fin de línea</translation>
    </message>
    <message>
        <source>Not told; the terminal program that the data sheet names sends cr.</source>
        <translation>No indicado; el programa de terminal que cita la hoja de datos envía cr.</translation>
    </message>
    <message>
        <source>greeting holds</source>
        <translation>el saludo contiene</translation>
    </message>
    <message>
        <source>The data sheet tells this word, and not the whole greeting.</source>
        <translation>La hoja de datos indica esta palabra, no el saludo completo.</translation>
    </message>
    <message>
        <source>refusal holds</source>
        <translation>el rechazo contiene</translation>
    </message>
    <message>
        <source>Not told. Words with | between them, in whatever case.</source>
        <translation>No indicado. Palabras separadas por |, en mayúsculas o minúsculas.</translation>
    </message>
    <message>
        <source>pause</source>
        <translation>pausa</translation>
    </message>
    <message>
        <source>Least time from one line to the next in milliseconds, from the data sheet.</source>
        <translation>Tiempo mínimo de una línea a la siguiente en milisegundos, de la hoja de datos.</translation>
    </message>
    <message>
        <source>leaves with</source>
        <translation>sale con</translation>
    </message>
    <message>
        <source>Typed at the end. &quot;none&quot; leaves it to jumper and reset.</source>
        <translation>Se escribe al final. «none» lo deja al puente y al reset.</translation>
    </message>
    <message>
        <source>counts/s (safe)</source>
        <translation>counts/s (seguro)</translation>
    </message>
    <message>
        <source>counts/s × 4096</source>
        <translation>counts/s × 4096</translation>
    </message>
    <message>
        <source>as the library</source>
        <translation>según la biblioteca</translation>
    </message>
    <message>
        <source>as the data sheet</source>
        <translation>según la hoja de datos</translation>
    </message>
    <message>
        <source>The data sheet contradicts itself on velocity targets. With plain counts/s a board that wants × 4096 hardly moves; the opposite mistake asks for full speed. Change it only when a board hardly moves, and with a small power limit.</source>
        <translation>La hoja de datos se contradice sobre las consignas de velocidad. Con counts/s simples, una placa que espera × 4096 apenas se mueve; el error contrario pide plena velocidad. Cámbielo solo si una placa apenas se mueve, y con un límite de potencia pequeño.</translation>
    </message>
    <message>
        <source>Data sheet and the maker&apos;s library give polarity and edges of the inputs opposite bits. The library is more likely right; an experiment with the status bit tells.</source>
        <translation>La hoja de datos y la biblioteca del fabricante dan bits opuestos a la polaridad y los flancos de las entradas. Es más probable que acierte la biblioteca; un experimento con el bit de estado lo aclara.</translation>
    </message>
    <message>
        <source>Power units (8191 is full power) that a raw gain of 1 gives. The maker does not tell; an experiment finds it.</source>
        <translation>Unidades de potencia (8191 es plena potencia) que da una ganancia bruta de 1. El fabricante no lo indica; un experimento lo averigua.</translation>
    </message>
    <message>
        <source>velocity target</source>
        <translation>consigna de velocidad</translation>
    </message>
    <message>
        <source>input polarity</source>
        <translation>polaridad de entrada</translation>
    </message>
    <message>
        <source>velocity P scale</source>
        <translation>escala de velocidad P</translation>
    </message>
    <message>
        <source>velocity I scale</source>
        <translation>escala de velocidad I</translation>
    </message>
    <message>
        <source>position P scale</source>
        <translation>escala de posición P</translation>
    </message>
    <message>
        <source>position I scale</source>
        <translation>escala de posición I</translation>
    </message>
    <message>
        <source>position D scale</source>
        <translation>escala de posición D</translation>
    </message>
    <message>
        <source>Status bits</source>
        <translation>Bits de estado</translation>
    </message>
    <message>
        <source>adapter, 3.3 V</source>
        <translation>adaptador, 3,3 V</translation>
    </message>
    <message>
        <source>Drawing: the jumper connects AUX1 and AUX2; adapter TX to board RX, RX to TX, 3.3 V, GND</source>
        <translation>Dibujo: el puente conecta AUX1 y AUX2; TX del adaptador a RX de la placa, RX a TX, 3,3 V, GND</translation>
    </message>
    <message>
        <source>Drawing: the jumper between AUX1 and AUX2 is taken out</source>
        <translation>Dibujo: se ha quitado el puente entre AUX1 y AUX2</translation>
    </message>
    <message>
        <source>open: nothing is connected, the pin is high</source>
        <translation>abierta: no hay nada conectado, el pin está a nivel alto</translation>
    </message>
    <message>
        <source>connected to GND: the pin is low</source>
        <translation>conectada a GND: el pin está a nivel bajo</translation>
    </message>
    <message>
        <source>Find the gain scales</source>
        <translation>Hallar las escalas de ganancia</translation>
    </message>
    <message>
        <source>The maker does not tell what a raw gain is worth. The motor of one axis is turned to and fro for one to two minutes, with the power that you allow here: first with constant power, then with one gain alone at a time, which grows until the motor moves. The shaft must turn freely, some turns each way, and nobody may touch it. Gains and limits are put back at the end.</source>
        <translation>El fabricante no indica cuánto vale una ganancia bruta. El motor de un eje se gira de un lado a otro de uno a dos minutos, con la potencia que permita aquí: primero con potencia constante y después con una sola ganancia cada vez, que crece hasta que el motor se mueve. El eje debe girar libre, varias vueltas en cada sentido, y nadie debe tocarlo. Al final se restituyen ganancias y límites.</translation>
    </message>
    <message>
        <source>Find the input polarity</source>
        <translation>Hallar la polaridad de entrada</translation>
    </message>
    <message>
        <source>Data sheet and the maker&apos;s library give the polarity of the inputs opposite bits. The input of one axis is set up with both, and the status bit tells which of them is active at the level that the pin has. Nothing moves, the counter stays, and the input is set up afterwards as it was.</source>
        <translation>La hoja de datos y la biblioteca del fabricante dan bits opuestos a la polaridad de las entradas. La entrada de un eje se configura con ambas y el bit de estado indica cuál está activa con el nivel que tiene el pin. Nada se mueve, el contador se mantiene y la entrada queda después configurada como estaba.</translation>
    </message>
    <message>
        <source>The input pin of this axis is</source>
        <translation>El pin de entrada de este eje está</translation>
    </message>
    <message>
        <source>encoder glitch</source>
        <translation>perturbación del encoder</translation>
    </message>
    <message>
        <source>overspeed</source>
        <translation>sobrevelocidad</translation>
    </message>
    <message>
        <source>Close the jumper</source>
        <translation>Ponga el puente</translation>
    </message>
    <message>
        <source>Put a jumper on AUX1 and AUX2. The serial adapter has 3.3 V levels, its TX goes to RX and its RX to TX; the board gets 3.3 V only.</source>
        <translation>Ponga un puente entre AUX1 y AUX2. El adaptador serie tiene niveles de 3,3 V, su TX va a RX y su RX a TX; la placa recibe solo 3,3 V.</translation>
    </message>
    <message>
        <source>Reset the board</source>
        <translation>Reinicie la placa</translation>
    </message>
    <message>
        <source>Press its reset, or switch it off and on. Where the reset line is wired, this program pulses it.</source>
        <translation>Pulse su reset, o apáguela y enciéndala. Si la línea de reset está cableada, este programa le da un pulso.</translation>
    </message>
    <message>
        <source>The bootloader greets</source>
        <translation>El bootloader saluda</translation>
    </message>
    <message>
        <source>Its greeting on the serial port holds the word &quot;bootloader&quot;.</source>
        <translation>Su saludo en el puerto serie contiene la palabra «bootloader».</translation>
    </message>
    <message>
        <source>The file is sent</source>
        <translation>Se envía el archivo</translation>
    </message>
    <message>
        <source>Line by line, each after the confirmation of the one before. Leave the jumper where it is.</source>
        <translation>Línea a línea, cada una tras la confirmación de la anterior. Deje el puente donde está.</translation>
    </message>
    <message>
        <source>Take the jumper out</source>
        <translation>Quite el puente</translation>
    </message>
    <message>
        <source>Then the board starts its new firmware. If it does not, reset it once more.</source>
        <translation>La placa arranca entonces su nuevo firmware. Si no, reiníciela otra vez.</translation>
    </message>
    <message>
        <source>The version is compared</source>
        <translation>Se compara la versión</translation>
    </message>
    <message>
        <source>The board is asked for it over SPI.</source>
        <translation>Se le pregunta a la placa por SPI.</translation>
    </message>
    <message>
        <source>A board that is cut stays in its bootloader. Leave the jumper in and run the update again.</source>
        <translation>Una placa interrumpida queda en su bootloader. Deje el puente y repita la actualización.</translation>
    </message>
    <message>
        <source>Channel 1</source>
        <translation>Canal 1</translation>
    </message>
    <message>
        <source>Channel 2</source>
        <translation>Canal 2</translation>
    </message>
    <message>
        <source>Channel 3</source>
        <translation>Canal 3</translation>
    </message>
    <message>
        <source>Channel 4</source>
        <translation>Canal 4</translation>
    </message>
    <message>
        <source>Stream and velocity</source>
        <translation>Stream y velocidad</translation>
    </message>
    <message>
        <source>disabled</source>
        <translation>desactivado</translation>
    </message>
    <message>
        <source>home switch</source>
        <translation>interruptor de referencia</translation>
    </message>
    <message>
        <source>index pulse</source>
        <translation>pulso de índice</translation>
    </message>
    <message>
        <source>both edges</source>
        <translation>ambos flancos</translation>
    </message>
    <message>
        <source>active high</source>
        <translation>activa a nivel alto</translation>
    </message>
    <message>
        <source>active low</source>
        <translation>activa a nivel bajo</translation>
    </message>
    <message>
        <source>record at the positive end</source>
        <translation>registrar en el extremo positivo</translation>
    </message>
    <message>
        <source>set at the positive end</source>
        <translation>fijar en el extremo positivo</translation>
    </message>
    <message>
        <source>record at the negative end</source>
        <translation>registrar en el extremo negativo</translation>
    </message>
    <message>
        <source>set at the negative end</source>
        <translation>fijar en el extremo negativo</translation>
    </message>
    <message>
        <source>Of the position loop, in the board&apos;s own units, whose scale is not documented. Cannot be read back; the four are sent together.</source>
        <translation>Del lazo de posición, en unidades propias de la placa, cuya escala no está documentada. No se puede releer; los cuatro se envían juntos.</translation>
    </message>
    <message>
        <source>Bound of the position loop&apos;s integral, in power units: 8191 is full power. Cannot be read back.</source>
        <translation>Límite de la integral del lazo de posición, en unidades de potencia: 8191 es plena potencia. No se puede releer.</translation>
    </message>
    <message>
        <source>Of the velocity loop, in the board&apos;s own units, whose scale is not documented. Cannot be read back; the three are sent together.</source>
        <translation>Del lazo de velocidad, en unidades propias de la placa, cuya escala no está documentada. No se puede releer; los tres se envían juntos.</translation>
    </message>
    <message>
        <source>Greatest power in every mode, 1 is full. What the board starts with is not documented: begin small. Cannot be read back.</source>
        <translation>Potencia máxima en todos los modos, 1 es plena. Con qué arranca la placa no está documentado: empiece bajo. No se puede releer.</translation>
    </message>
    <message>
        <source>Greatest speed in both closed loops. What the board starts with is not documented. Cannot be read back.</source>
        <translation>Velocidad máxima en ambos lazos cerrados. Con qué arranca la placa no está documentado. No se puede releer.</translation>
    </message>
    <message>
        <source>Greatest acceleration in both closed loops; 0 is no limit. Cannot be read back.</source>
        <translation>Aceleración máxima en ambos lazos cerrados; 0 es sin límite. No se puede releer.</translation>
    </message>
    <message>
        <source>What the input of the channel is for. Cannot be read back; the five values of an input are sent together.</source>
        <translation>Para qué sirve la entrada del canal. No se puede releer; los cinco valores de una entrada se envían juntos.</translation>
    </message>
    <message>
        <source>At which level the input is active. Data sheet and the maker&apos;s library say it with opposite bits: which one the board follows is a setting of the device, and an experiment tells.</source>
        <translation>Con qué nivel está activa la entrada. La hoja de datos y la biblioteca del fabricante lo indican con bits opuestos: a cuál obedece la placa es un ajuste del dispositivo, y un experimento lo aclara.</translation>
    </message>
    <message>
        <source>At which end of the switch the position is recorded, or also set as the counter. Data sheet and library disagree, as for the polarity.</source>
        <translation>En qué extremo del interruptor se registra la posición, o también se fija como contador. La hoja de datos y la biblioteca discrepan, como en la polaridad.</translation>
    </message>
    <message>
        <source>Distance between the two ends of the switch; 0 is a single end stop. Cannot be read back.</source>
        <translation>Distancia entre los dos extremos del interruptor; 0 es un único tope. No se puede releer.</translation>
    </message>
    <message>
        <source>What the counter becomes at the edge. Cannot be read back.</source>
        <translation>Qué valor toma el contador en el flanco. No se puede releer.</translation>
    </message>
    <message>
        <source>What the board sends of this channel: bits 0 and 1 size of the position, 2 relative, 3 velocity, 5 status. The program needs the full position.</source>
        <translation>Qué envía la placa de este canal: bits 0 y 1 tamaño de la posición, 2 relativa, 3 velocidad, 5 estado. El programa necesita la posición completa.</translation>
    </message>
    <message>
        <source>The encoder&apos;s counter. Writing it moves the zero, not the motor.</source>
        <translation>El contador del encoder. Escribirlo mueve el cero, no el motor.</translation>
    </message>
    <message>
        <source>Of the telemetry, in units of 40.96 µs: 244 is 10 ms, 49 is 2 ms, 0 is off.</source>
        <translation>De la telemetría, en unidades de 40,96 µs: 244 son 10 ms, 49 son 2 ms, 0 es apagado.</translation>
    </message>
    <message>
        <source>What a stream packet has besides: bit 0 timing, bit 1 number of skipped periods.</source>
        <translation>Qué más contiene un paquete de stream: bit 0 temporización, bit 1 número de periodos omitidos.</translation>
    </message>
    <message>
        <source>Edges, times four, over which velocity is measured: fewer is faster and coarser. 8 is good for tuning.</source>
        <translation>Flancos, por cuatro, en los que se mide la velocidad: menos es más rápido y más grueso. 8 va bien para ajustar.</translation>
    </message>
    <message>
        <source>Longest time over which velocity is measured: 2 to this power, times 0.64 µs; 20 is 671 ms.</source>
        <translation>Tiempo máximo en el que se mide la velocidad: 2 elevado a este número, por 0,64 µs; 20 son 671 ms.</translation>
    </message>
    <message>
        <source>Position P</source>
        <translation>Posición P</translation>
    </message>
    <message>
        <source>Position I</source>
        <translation>Posición I</translation>
    </message>
    <message>
        <source>Position D</source>
        <translation>Posición D</translation>
    </message>
    <message>
        <source>Position windup</source>
        <translation>Posición windup</translation>
    </message>
    <message>
        <source>Velocity P</source>
        <translation>Velocidad P</translation>
    </message>
    <message>
        <source>Velocity I</source>
        <translation>Velocidad I</translation>
    </message>
    <message>
        <source>Velocity D</source>
        <translation>Velocidad D</translation>
    </message>
    <message>
        <source>Power limit</source>
        <translation>Límite de potencia</translation>
    </message>
    <message>
        <source>Velocity limit</source>
        <translation>Límite de velocidad</translation>
    </message>
    <message>
        <source>Acceleration limit</source>
        <translation>Límite de aceleración</translation>
    </message>
    <message>
        <source>Input mode</source>
        <translation>Entrada: modo</translation>
    </message>
    <message>
        <source>Input polarity</source>
        <translation>Entrada: polaridad</translation>
    </message>
    <message>
        <source>Input edge</source>
        <translation>Entrada: flanco</translation>
    </message>
    <message>
        <source>Input spacing</source>
        <translation>Entrada: separación</translation>
    </message>
    <message>
        <source>Input position</source>
        <translation>Entrada: posición</translation>
    </message>
    <message>
        <source>Data mask</source>
        <translation>Máscara de datos</translation>
    </message>
    <message>
        <source>Position counter</source>
        <translation>Contador de posición</translation>
    </message>
    <message>
        <source>Stream period</source>
        <translation>Periodo del stream</translation>
    </message>
    <message>
        <source>Stream contents</source>
        <translation>Contenido del stream</translation>
    </message>
    <message>
        <source>History length</source>
        <translation>Longitud del historial</translation>
    </message>
    <message>
        <source>History time bits</source>
        <translation>Bits de tiempo del historial</translation>
    </message>
    <message>
        <source>Input</source>
        <translation>Entrada</translation>
    </message>
    <message>
        <source>the port cannot be opened</source>
        <translation>no se puede abrir el puerto</translation>
    </message>
    <message>
        <source>check its name and that it is plugged in</source>
        <translation>compruebe su nombre y que esté conectado</translation>
    </message>
    <message>
        <source>avrdude finds no such programmer on USB</source>
        <translation>avrdude no encuentra ese programador en USB</translation>
    </message>
    <message>
        <source>plug it in, and check that its kind is the one named after avrdude:</source>
        <translation>conéctelo y compruebe que su tipo sea el indicado tras avrdude:</translation>
    </message>
    <message>
        <source>run it again, with a shorter cable</source>
        <translation>repítalo con un cable más corto</translation>
    </message>
    <message>
        <source>the programmer is there, but no microcontroller answers it</source>
        <translation>el programador está, pero ningún microcontrolador le responde</translation>
    </message>
    <message>
        <source>check the six pins and the supply</source>
        <translation>compruebe los seis pines y la alimentación</translation>
    </message>
    <message>
        <source>avrdude knows no programmer of this name</source>
        <translation>avrdude no conoce ningún programador con este nombre</translation>
    </message>
    <message>
        <source>&apos;avrdude -c ?&apos; lists them</source>
        <translation>«avrdude -c ?» los enumera</translation>
    </message>
    <message>
        <source>the port may not be opened</source>
        <translation>no se permite abrir el puerto</translation>
    </message>
    <message>
        <source>add yourself to the group dialout and log in again</source>
        <translation>añádase al grupo dialout e inicie sesión de nuevo</translation>
    </message>
    <message>
        <source>what answers is no ATmega328P</source>
        <translation>lo que responde no es un ATmega328P</translation>
    </message>
    <message>
        <source>check that the programmer sits on the controller</source>
        <translation>compruebe que el programador esté en el controlador</translation>
    </message>
    <message>
        <source>no bootloader answers</source>
        <translation>no responde ningún bootloader</translation>
    </message>
    <message>
        <source>restart the controller just before the start, or use a programmer on its pins</source>
        <translation>reinicie el controlador justo antes de empezar o use un programador en sus pines</translation>
    </message>
    <message>
        <source>nothing answers the programmer</source>
        <translation>nada responde al programador</translation>
    </message>
    <message>
        <source>check its cable and the supply of the controller</source>
        <translation>compruebe su cable y la alimentación del controlador</translation>
    </message>
    <message>
        <source>Velocity as reported</source>
        <translation>Velocidad notificada</translation>
    </message>
    <message>
        <source>Position in the turn</source>
        <translation>Posición en la vuelta</translation>
    </message>
    <message>
        <source>Analog input 1</source>
        <translation>Entrada analógica 1</translation>
    </message>
    <message>
        <source>Analog input 2</source>
        <translation>Entrada analógica 2</translation>
    </message>
    <message>
        <source>Analog input 3</source>
        <translation>Entrada analógica 3</translation>
    </message>
    <message>
        <source>Analog input 4</source>
        <translation>Entrada analógica 4</translation>
    </message>
    <message>
        <source>Digital inputs</source>
        <translation>Entradas digitales</translation>
    </message>
    <message>
        <source>the motor stalled</source>
        <translation>el motor se bloqueó</translation>
    </message>
    <message>
        <source>the position left its range upwards</source>
        <translation>la posición salió de su rango por arriba</translation>
    </message>
    <message>
        <source>the position left its range downwards</source>
        <translation>la posición salió de su rango por abajo</translation>
    </message>
    <message>
        <source>it has no such command</source>
        <translation>no tiene esa orden</translation>
    </message>
    <message>
        <source>wrong number of data bytes</source>
        <translation>número incorrecto de bytes de datos</translation>
    </message>
    <message>
        <source>a value that it does not take</source>
        <translation>un valor que no admite</translation>
    </message>
    <message>
        <source>not possible while the motor is not started</source>
        <translation>no es posible sin arrancar el motor</translation>
    </message>
    <message>
        <source>data bytes where none belong</source>
        <translation>bytes de datos donde no corresponden</translation>
    </message>
    <message>
        <source>I2C: nobody answers</source>
        <translation>I2C: nadie responde</translation>
    </message>
    <message>
        <source>I2C: bus error</source>
        <translation>I2C: error de bus</translation>
    </message>
    <message>
        <source>I2C: arbitration lost</source>
        <translation>I2C: arbitraje perdido</translation>
    </message>
    <message>
        <source>I2C: indeterminate state</source>
        <translation>I2C: estado indeterminado</translation>
    </message>
    <message>
        <source>I2C: the bus did not become ready</source>
        <translation>I2C: el bus no quedó listo</translation>
    </message>
    <message>
        <source>I2C: sending took too long</source>
        <translation>I2C: el envío tardó demasiado</translation>
    </message>
    <message>
        <source>I2C: receiving took too long</source>
        <translation>I2C: la recepción tardó demasiado</translation>
    </message>
    <message>
        <source>I2C: a packet was overwritten</source>
        <translation>I2C: se sobrescribió un paquete</translation>
    </message>
    <message>
        <source>I2C: a packet of wrong length</source>
        <translation>I2C: un paquete de longitud incorrecta</translation>
    </message>
    <message>
        <source>UART: out of memory</source>
        <translation>UART: memoria agotada</translation>
    </message>
    <message>
        <source>UART: framing error</source>
        <translation>UART: error de trama</translation>
    </message>
    <message>
        <source>UART: parity error</source>
        <translation>UART: error de paridad</translation>
    </message>
    <message>
        <source>UART: receive buffer overflow</source>
        <translation>UART: desbordamiento del búfer de recepción</translation>
    </message>
    <message>
        <source>UART: data overrun (the datasheet means a framing error)</source>
        <translation>UART: desbordamiento de datos (la hoja de datos se refiere a un error de trama)</translation>
    </message>
    <message>
        <source>UART: sending took too long (the datasheet means a parity error)</source>
        <translation>UART: el envío tardó demasiado (la hoja de datos se refiere a un error de paridad)</translation>
    </message>
    <message>
        <source>UART: receive buffer overflow, by the datasheet&apos;s number</source>
        <translation>UART: desbordamiento del búfer de recepción, según el número de la hoja de datos</translation>
    </message>
    <message>
        <source>UART: data overrun, by the datasheet&apos;s number</source>
        <translation>UART: desbordamiento de datos, según el número de la hoja de datos</translation>
    </message>
    <message>
        <source>a frame paused for more than 50 ms</source>
        <translation>una trama se interrumpió más de 50 ms</translation>
    </message>
    <message>
        <source>wrong checksum</source>
        <translation>suma de comprobación incorrecta</translation>
    </message>
    <message>
        <source>D1 and D2: what one count of the current converter stands for; D3 tells ampere.</source>
        <translation>D1 y D2: lo que representa una cuenta del convertidor de corriente; D3 indica amperios.</translation>
    </message>
    <message>
        <source>serial bootloader</source>
        <translation>bootloader serie</translation>
    </message>
    <message>
        <source>serial bootloader, without reset</source>
        <translation>bootloader serie, sin reset</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>Lazo</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Perfil</translation>
    </message>
    <message>
        <source>Digital lines</source>
        <translation>Líneas digitales</translation>
    </message>
    <message>
        <source>Bus</source>
        <translation>Bus</translation>
    </message>
    <message>
        <source>Errors</source>
        <translation>Errores</translation>
    </message>
    <message>
        <source>D1, D2: 1/65280 of full output per count of error; 4000 is full output at 16 counts. The scale of D3 is not documented.</source>
        <translation>D1, D2: 1/65280 de la salida plena por cuenta de error; 4000 es salida plena con 16 cuentas. La escala de D3 no está documentada.</translation>
    </message>
    <message>
        <source>D1, D2: 1/16711680 of full output per count of error and loop of 1.024 ms. The bound of the integral follows P at the next restart only.</source>
        <translation>D1, D2: 1/16711680 de la salida plena por cuenta de error y ciclo de lazo de 1,024 ms. El límite de la integral solo sigue a P en el próximo reinicio.</translation>
    </message>
    <message>
        <source>D1, D2: 1/65280 of full output per count that the error changes in one loop of 1.024 ms.</source>
        <translation>D1, D2: 1/65280 de la salida plena por cada cuenta que el error varía en un ciclo de lazo de 1,024 ms.</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>Aceleración</translation>
    </message>
    <message>
        <source>Of profiled moves. D1: at most 65535.</source>
        <translation>De los movimientos con perfil. D1: como máximo 65535.</translation>
    </message>
    <message>
        <source>Of profiled moves. D1: at most 65535. D1 and D2 may pass their target above 2500, and compute wrongly from 46340 on.</source>
        <translation>De los movimientos con perfil. D1: como máximo 65535. D1 y D2 pueden rebasar su destino por encima de 2500 y calculan mal desde 46340.</translation>
    </message>
    <message>
        <source>Firmware of D1 and D2 stores it and does not limit anything.</source>
        <translation>El firmware de D1 y D2 lo guarda y no limita nada.</translation>
    </message>
    <message>
        <source>Time above the limit</source>
        <translation>Tiempo sobre el límite</translation>
    </message>
    <message>
        <source>In force after a restart. D1 and D2 take it for the current limit until then; the limit is therefore written again behind it.</source>
        <translation>Vigente tras un reinicio. D1 y D2 lo toman hasta entonces por el límite de corriente; por eso el límite se escribe de nuevo a continuación.</translation>
    </message>
    <message>
        <source>Outputs among the lines</source>
        <translation>Líneas como salidas</translation>
    </message>
    <message>
        <source>1, 2, 4, 8 for DIO1 to DIO4; a set bit makes an output. DIO1 and DIO3 low for 3 s start the analog programming of the device, DIO2 and DIO4 low restore its factory settings.</source>
        <translation>1, 2, 4, 8 para DIO1 a DIO4; un bit a uno hace una salida. DIO1 y DIO3 a nivel bajo durante 3 s inician la programación analógica del dispositivo; DIO2 y DIO4 a nivel bajo restauran los ajustes de fábrica.</translation>
    </message>
    <message>
        <source>Levels of the outputs</source>
        <translation>Niveles de las salidas</translation>
    </message>
    <message>
        <source>Bits as for the directions; inputs ignore theirs. Cannot be read back and is lost at power-off.</source>
        <translation>Bits como en las direcciones; las entradas ignoran el suyo. No se puede releer y se pierde al apagar.</translation>
    </message>
    <message>
        <source>Node id</source>
        <translation>Id de nodo</translation>
    </message>
    <message>
        <source>Its address on the line. In force after a restart; until then it answers under the old one.</source>
        <translation>Su dirección en la línea. Vigente tras un reinicio; hasta entonces responde con la antigua.</translation>
    </message>
    <message>
        <source>Acceptance mask</source>
        <translation>Máscara de aceptación</translation>
    </message>
    <message>
        <source>Bits of an address that count. 255: only its own; less makes a group that acts on what is sent to any of its members, and on their answers. In force after a restart.</source>
        <translation>Bits de una dirección que cuentan. 255: solo la propia; menos forma un grupo que actúa ante lo enviado a cualquiera de sus miembros y ante sus respuestas. Vigente tras un reinicio.</translation>
    </message>
    <message>
        <source>Bit rate</source>
        <translation>Velocidad en bits</translation>
    </message>
    <message>
        <source>In force after a restart. Reads as the rate at which it answers. 115200 is really 119048: prefer 57600.</source>
        <translation>Vigente tras un reinicio. Se lee la velocidad a la que responde. 115200 es en realidad 119048: prefiera 57600.</translation>
    </message>
    <message>
        <source>Error level</source>
        <translation>Nivel de error</translation>
    </message>
    <message>
        <source>D1 and D2. Level 1 would make every reading fail, so only 0 is offered: write it where another program set 1.</source>
        <translation>D1 y D2. El nivel 1 haría fallar toda lectura, así que solo se ofrece 0: escríbalo donde otro programa puso 1.</translation>
    </message>
    <message>
        <source>Reactions to errors</source>
        <translation>Reacciones a errores</translation>
    </message>
    <message>
        <source>D3. Two bits for each of 20 errors, the first lowest: 0 nothing, 1 stop, 2 halt. Which error is which is not documented.</source>
        <translation>D3. Dos bits por cada uno de 20 errores, el primero el más bajo: 0 nada, 1 parada, 2 detención. Qué error es cada uno no está documentado.</translation>
    </message>
    <message>
        <source>Anti-windup</source>
        <translation>Anti-windup</translation>
    </message>
    <message>
        <source>D3. Bound of the integral; its scale is not documented.</source>
        <translation>D3. Límite de la integral; su escala no está documentada.</translation>
    </message>
    <message>
        <source>Digital input 1</source>
        <translation>Entrada digital 1</translation>
    </message>
    <message>
        <source>Digital input 2</source>
        <translation>Entrada digital 2</translation>
    </message>
    <message>
        <source>Digital input 3</source>
        <translation>Entrada digital 3</translation>
    </message>
    <message>
        <source>Digital input 4</source>
        <translation>Entrada digital 4</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>a mano</translation>
    </message>
    <message>
        <source>as found</source>
        <translation>como se encontró</translation>
    </message>
    <message>
        <source>before restore</source>
        <translation>antes de restaurar</translation>
    </message>
    <message>
        <source>before import</source>
        <translation>antes de importar</translation>
    </message>
    <message>
        <source>before tuning</source>
        <translation>antes del ajuste</translation>
    </message>
    <message>
        <source>before update</source>
        <translation>antes de actualizar</translation>
    </message>
    <message>
        <source>%1 % of the samples were lost in a second</source>
        <translation>se perdió el %1 % de las muestras en un segundo</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1 %2 is outside %3 … %4</source>
        <translation>%1 %2 está fuera de %3 … %4</translation>
    </message>
    <message>
        <source>%1 %2 is outside %3 … %4 %5</source>
        <translation>%1 %2 está fuera de %3 … %4 %5</translation>
    </message>
    <message>
        <source>%1 %2 is outside %3 … %4, what firmware of dialect %5 takes</source>
        <translation>%1 %2 está fuera de %3 … %4, que es lo que admite el firmware del dialecto %5</translation>
    </message>
    <message>
        <source>%1 %2 is outside the envelope, which ends at %3</source>
        <translation>%1 %2 está fuera de los límites, que terminan en %3</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>%1 (code %2)</source>
        <translation>%1 (código %2)</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 y %2</translation>
    </message>
    <message>
        <source>%1 at %2 % duty</source>
        <translation>%1 con ciclo del %2 %</translation>
    </message>
    <message>
        <source>%1 at byte %2</source>
        <translation>%1 en el byte %2</translation>
    </message>
    <message>
        <source>%1 becomes %2, it was %3: the device stores it</source>
        <translation>%1 pasa a %2, era %3: el dispositivo lo guarda</translation>
    </message>
    <message>
        <source>%1 becomes %2: the device stores it</source>
        <translation>%1 pasa a %2: el dispositivo lo guarda</translation>
    </message>
    <message>
        <source>%1 begins no line of such a log</source>
        <translation>ninguna línea de un registro así empieza por %1</translation>
    </message>
    <message>
        <source>%1 belongs to the unit that the file was saved from</source>
        <translation>%1 pertenece al equipo del que se guardó el archivo</translation>
    </message>
    <message>
        <source>%1 bit/s is no rate of a serial line</source>
        <translation>%1 bit/s no es una velocidad de línea serie</translation>
    </message>
    <message>
        <source>%1 bytes</source>
        <translation>%1 bytes</translation>
    </message>
    <message>
        <source>%1 cannot be made</source>
        <translation>%1 no se puede crear</translation>
    </message>
    <message>
        <source>%1 cannot be made: %2</source>
        <translation>%1 no se puede crear: %2</translation>
    </message>
    <message>
        <source>%1 cannot be opened: %2</source>
        <translation>%1 no se puede abrir: %2</translation>
    </message>
    <message>
        <source>%1 cannot be painted</source>
        <translation>%1 no se puede dibujar</translation>
    </message>
    <message>
        <source>%1 cannot be read from the device</source>
        <translation>%1 no se puede leer del dispositivo</translation>
    </message>
    <message>
        <source>%1 cannot be read, so it could not be put back</source>
        <translation>%1 no se puede leer, así que no se podría restituir</translation>
    </message>
    <message>
        <source>%1 cannot be read: %2</source>
        <translation>%1 no se puede leer: %2</translation>
    </message>
    <message>
        <source>%1 cannot be restarted from here</source>
        <translation>%1 no se puede reiniciar desde aquí</translation>
    </message>
    <message>
        <source>%1 cannot be started: %2</source>
        <translation>%1 no se puede iniciar: %2</translation>
    </message>
    <message>
        <source>%1 cannot be written</source>
        <translation>%1 no se puede escribir</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2</source>
        <translation>%1 no se puede escribir: %2</translation>
    </message>
    <message>
        <source>%1 cannot do %2 bit/s</source>
        <translation>%1 no admite %2 bit/s</translation>
    </message>
    <message>
        <source>%1 cannot do %2 bit/s: %3</source>
        <translation>%1 no admite %2 bit/s: %3</translation>
    </message>
    <message>
        <source>%1 cannot do %2: %3</source>
        <translation>%1 no admite %2: %3</translation>
    </message>
    <message>
        <source>%1 cannot do SPI mode 1 at this speed</source>
        <translation>%1 no admite el modo 1 de SPI a esta velocidad</translation>
    </message>
    <message>
        <source>%1 cannot take old samples: %2</source>
        <translation>%1 no admite muestras antiguas: %2</translation>
    </message>
    <message>
        <source>%1 could not be measured</source>
        <translation>%1 no se pudo medir</translation>
    </message>
    <message>
        <source>%1 data bytes are announced, %2 are there</source>
        <translation>se anuncian %1 bytes de datos, hay %2</translation>
    </message>
    <message>
        <source>%1 did not come back within %2</source>
        <translation>%1 no volvió en %2</translation>
    </message>
    <message>
        <source>%1 digits, an even number is needed</source>
        <translation>%1 dígitos, se necesita un número par</translation>
    </message>
    <message>
        <source>%1 does not answer</source>
        <translation>%1 no responde</translation>
    </message>
    <message>
        <source>%1 does not answer: %2</source>
        <translation>%1 no responde: %2</translation>
    </message>
    <message>
        <source>%1 does not exist in this device&apos;s dialect</source>
        <translation>%1 no existe en el dialecto de este dispositivo</translation>
    </message>
    <message>
        <source>%1 does not open: its driver has not answered for %2 s</source>
        <translation>%1 no se abre: su driver no ha respondido durante %2 s</translation>
    </message>
    <message>
        <source>%1 does not tell its position</source>
        <translation>%1 no indica su posición</translation>
    </message>
    <message>
        <source>%1 exists and is no socket</source>
        <translation>%1 existe y no es un socket</translation>
    </message>
    <message>
        <source>%1 failed (%2)</source>
        <translation>%1 falló (%2)</translation>
    </message>
    <message>
        <source>%1 failed: %2</source>
        <translation>%1 falló: %2</translation>
    </message>
    <message>
        <source>%1 frames recorded, %2 are missing</source>
        <translation>%1 tramas grabadas, faltan %2</translation>
    </message>
    <message>
        <source>%1 frames recorded, none is missing</source>
        <translation>%1 tramas grabadas, no falta ninguna</translation>
    </message>
    <message>
        <source>%1 frames were lost, the kernel keeps only %2 for this program</source>
        <translation>se perdieron %1 tramas; el núcleo solo conserva %2 para este programa</translation>
    </message>
    <message>
        <source>%1 has %2 axes and %3 sets of gains</source>
        <translation>%1 tiene %2 ejes y %3 juegos de ganancias</translation>
    </message>
    <message>
        <source>%1 has a name that ends in no kind of picture</source>
        <translation>el nombre de %1 no termina en ningún tipo de imagen</translation>
    </message>
    <message>
        <source>%1 has a name that ends in no kind of report</source>
        <translation>el nombre de %1 no termina en ningún tipo de informe</translation>
    </message>
    <message>
        <source>%1 has no %2</source>
        <translation>%1 no tiene %2</translation>
    </message>
    <message>
        <source>%1 has no &apos;%2&apos; to be set</source>
        <translation>%1 no tiene ningún «%2» que fijar</translation>
    </message>
    <message>
        <source>%1 has no buffered moves</source>
        <translation>%1 no tiene movimientos en búfer</translation>
    </message>
    <message>
        <source>%1 has no channel of samples</source>
        <translation>%1 no tiene ningún canal de muestras</translation>
    </message>
    <message>
        <source>%1 has no command that zeroes its position</source>
        <translation>%1 no tiene ninguna orden que ponga a cero su posición</translation>
    </message>
    <message>
        <source>%1 has no dialect &apos;%2&apos;</source>
        <translation>%1 no tiene el dialecto «%2»</translation>
    </message>
    <message>
        <source>%1 has no duty command</source>
        <translation>%1 no tiene orden de ciclo de trabajo</translation>
    </message>
    <message>
        <source>%1 has no duty command, so &apos;%2&apos; is not measured</source>
        <translation>%1 no tiene orden de ciclo de trabajo, así que «%2» no se mide</translation>
    </message>
    <message>
        <source>%1 has no firmware update here</source>
        <translation>%1 no tiene aquí actualización de firmware</translation>
    </message>
    <message>
        <source>%1 has no frame in it</source>
        <translation>%1 no contiene ninguna trama</translation>
    </message>
    <message>
        <source>%1 has no frame of %2</source>
        <translation>%1 no tiene ninguna trama de %2</translation>
    </message>
    <message>
        <source>%1 has no loop &apos;%2&apos; that can be tried</source>
        <translation>%1 no tiene un lazo «%2» que se pueda ensayar</translation>
    </message>
    <message>
        <source>%1 has no loop &apos;%2&apos; that can be tuned</source>
        <translation>%1 no tiene un lazo «%2» que se pueda ajustar</translation>
    </message>
    <message>
        <source>%1 has no loop that can be tried</source>
        <translation>%1 no tiene ningún lazo que se pueda ensayar</translation>
    </message>
    <message>
        <source>%1 has no number that could be set</source>
        <translation>%1 no tiene ningún número que se pueda fijar</translation>
    </message>
    <message>
        <source>%1 has no option &apos;%2&apos;</source>
        <translation>%1 no tiene la opción «%2»</translation>
    </message>
    <message>
        <source>%1 has no samples</source>
        <translation>%1 no tiene muestras</translation>
    </message>
    <message>
        <source>%1 has no setting that could be written to every unit</source>
        <translation>%1 no tiene ningún ajuste que se pueda escribir en todos los equipos</translation>
    </message>
    <message>
        <source>%1 has no such limit of its own, so nothing bounds the motor</source>
        <translation>%1 no tiene un límite propio así, de modo que nada limita el motor</translation>
    </message>
    <message>
        <source>%1 has not told where it stands</source>
        <translation>%1 no ha indicado dónde está</translation>
    </message>
    <message>
        <source>%1 holds no limits of experiments</source>
        <translation>%1 no contiene límites de experimentos</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1 en %2</translation>
    </message>
    <message>
        <source>%1 in its bootloader instead of %2</source>
        <translation>%1 en su bootloader en vez de %2</translation>
    </message>
    <message>
        <source>%1 instead of %2</source>
        <translation>%1 en vez de %2</translation>
    </message>
    <message>
        <source>%1 is %2</source>
        <translation>%1 es %2</translation>
    </message>
    <message>
        <source>%1 is %2, %3</source>
        <translation>%1 es %2, %3</translation>
    </message>
    <message>
        <source>%1 is a device and has no end</source>
        <translation>%1 es un dispositivo y no tiene fin</translation>
    </message>
    <message>
        <source>%1 is a folder</source>
        <translation>%1 es una carpeta</translation>
    </message>
    <message>
        <source>%1 is a network interface, but not one for CAN</source>
        <translation>%1 es una interfaz de red, pero no de CAN</translation>
    </message>
    <message>
        <source>%1 is a recording: it can be watched, not written to or driven</source>
        <translation>%1 es una grabación: se puede observar, no escribir ni accionar</translation>
    </message>
    <message>
        <source>%1 is back</source>
        <translation>%1 ha vuelto</translation>
    </message>
    <message>
        <source>%1 is being opened already</source>
        <translation>%1 ya se está abriendo</translation>
    </message>
    <message>
        <source>%1 is being recorded already</source>
        <translation>%1 ya se está grabando</translation>
    </message>
    <message>
        <source>%1 is bus-off</source>
        <translation>%1 está en bus-off</translation>
    </message>
    <message>
        <source>%1 is busy: it serves one client at a time</source>
        <translation>%1 está ocupado: atiende a un cliente a la vez</translation>
    </message>
    <message>
        <source>%1 is damaged and cannot be put aside</source>
        <translation>%1 está dañado y no se puede apartar</translation>
    </message>
    <message>
        <source>%1 is error-passive</source>
        <translation>%1 está en error-passive</translation>
    </message>
    <message>
        <source>%1 is error-warning</source>
        <translation>%1 está en error-warning</translation>
    </message>
    <message>
        <source>%1 is gone</source>
        <translation>%1 ya no está</translation>
    </message>
    <message>
        <source>%1 is in use by another program</source>
        <translation>%1 está en uso por otro programa</translation>
    </message>
    <message>
        <source>%1 is locked by another program</source>
        <translation>%1 está bloqueado por otro programa</translation>
    </message>
    <message>
        <source>%1 is lost: %2; waiting up to %3 for it to come back</source>
        <translation>%1 se ha perdido: %2; se espera hasta %3 a que vuelva</translation>
    </message>
    <message>
        <source>%1 is missing</source>
        <translation>falta %1</translation>
    </message>
    <message>
        <source>%1 is never part of an experiment</source>
        <translation>%1 nunca forma parte de un experimento</translation>
    </message>
    <message>
        <source>%1 is no CAN identifier in dec</source>
        <translation>%1 no es un identificador CAN en dec</translation>
    </message>
    <message>
        <source>%1 is no CAN identifier in hex</source>
        <translation>%1 no es un identificador CAN en hex</translation>
    </message>
    <message>
        <source>%1 is no CAN link</source>
        <translation>%1 no es un enlace CAN</translation>
    </message>
    <message>
        <source>%1 is no device profile</source>
        <translation>%1 no es un perfil de dispositivo</translation>
    </message>
    <message>
        <source>%1 is no list of devices and is ignored: the next scan takes its full time and writes it anew</source>
        <translation>%1 no es una lista de dispositivos y se ignora: la próxima búsqueda tarda todo su tiempo y la escribe de nuevo</translation>
    </message>
    <message>
        <source>%1 is no project of this version</source>
        <translation>%1 no es un proyecto de esta versión</translation>
    </message>
    <message>
        <source>%1 is no recording</source>
        <translation>%1 no es una grabación</translation>
    </message>
    <message>
        <source>%1 is no serial port</source>
        <translation>%1 no es un puerto serie</translation>
    </message>
    <message>
        <source>%1 is no time stamp</source>
        <translation>%1 no es una marca de tiempo</translation>
    </message>
    <message>
        <source>%1 is not a file</source>
        <translation>%1 no es un archivo</translation>
    </message>
    <message>
        <source>%1 is not a hexadecimal digit</source>
        <translation>%1 no es un dígito hexadecimal</translation>
    </message>
    <message>
        <source>%1 is not an MCAP file</source>
        <translation>%1 no es un archivo MCAP</translation>
    </message>
    <message>
        <source>%1 is not an object</source>
        <translation>%1 no es un objeto</translation>
    </message>
    <message>
        <source>%1 is not in this program</source>
        <translation>%1 no está en este programa</translation>
    </message>
    <message>
        <source>%1 is not installed</source>
        <translation>%1 no está instalado</translation>
    </message>
    <message>
        <source>%1 is not known to firmware of dialect %2</source>
        <translation>el firmware del dialecto %2 no conoce %1</translation>
    </message>
    <message>
        <source>%1 is not open</source>
        <translation>%1 no está abierto</translation>
    </message>
    <message>
        <source>%1 is not updated over its own link</source>
        <translation>%1 no se actualiza por su propio enlace</translation>
    </message>
    <message>
        <source>%1 is read-only</source>
        <translation>%1 es de solo lectura</translation>
    </message>
    <message>
        <source>%1 is served by another program already</source>
        <translation>otro programa ya atiende %1</translation>
    </message>
    <message>
        <source>%1 is served by another simulator</source>
        <translation>otro simulador atiende %1</translation>
    </message>
    <message>
        <source>%1 is switched off</source>
        <translation>%1 está desactivado</translation>
    </message>
    <message>
        <source>%1 is there already and no link to a terminal</source>
        <translation>%1 ya existe y no es un vínculo a un terminal</translation>
    </message>
    <message>
        <source>%1 is updated over its own link</source>
        <translation>%1 se actualiza por su propio enlace</translation>
    </message>
    <message>
        <source>%1 is used by another program</source>
        <translation>otro programa usa %1</translation>
    </message>
    <message>
        <source>%1 lines, %2 bytes; the file does not name its version</source>
        <translation>%1 líneas, %2 bytes; el archivo no indica su versión</translation>
    </message>
    <message>
        <source>%1 links are not supported yet</source>
        <translation>los enlaces %1 aún no se admiten</translation>
    </message>
    <message>
        <source>%1 needs a number</source>
        <translation>%1 necesita un número</translation>
    </message>
    <message>
        <source>%1 of %2 lines were confirmed. The bootloader keeps waiting: leave the jumper in and run the update again</source>
        <translation>se confirmaron %1 de %2 líneas. El bootloader sigue esperando: deje el puente y repita la actualización</translation>
    </message>
    <message>
        <source>%1 of %2 settings were written again; %3: %4</source>
        <translation>se reescribieron %1 de %2 ajustes; %3: %4</translation>
    </message>
    <message>
        <source>%1 of %2 settings were written again; then the board was reset once more</source>
        <translation>se reescribieron %1 de %2 ajustes; después la placa se reinició otra vez</translation>
    </message>
    <message>
        <source>%1 of the recipe read back different, first %2</source>
        <translation>%1 de la receta se releen distintos, el primero %2</translation>
    </message>
    <message>
        <source>%1 only listens, nothing can be sent</source>
        <translation>%1 solo escucha, no se puede enviar nada</translation>
    </message>
    <message>
        <source>%1 parameters gave no answer</source>
        <translation>%1 parámetros sin respuesta</translation>
    </message>
    <message>
        <source>%1 said nothing for a minute and was ended</source>
        <translation>%1 no dijo nada durante un minuto y se terminó</translation>
    </message>
    <message>
        <source>%1 said nothing for too long</source>
        <translation>%1 no dijo nada durante demasiado tiempo</translation>
    </message>
    <message>
        <source>%1 settings written again</source>
        <translation>%1 ajustes reescritos</translation>
    </message>
    <message>
        <source>%1 takes no frames: %2 wait to be sent</source>
        <translation>%1 no acepta tramas: %2 esperan su envío</translation>
    </message>
    <message>
        <source>%1 to number %2: %3</source>
        <translation>%1 al número %2: %3</translation>
    </message>
    <message>
        <source>%1 transmit and %2 receive errors</source>
        <translation>%1 errores de transmisión y %2 de recepción</translation>
    </message>
    <message>
        <source>%1 units answer as number %2</source>
        <translation>%1 equipos responden con el número %2</translation>
    </message>
    <message>
        <source>%1 values are not what they were left as; the history has both</source>
        <translation>%1 valores no están como se dejaron; el historial tiene ambos</translation>
    </message>
    <message>
        <source>%1 was %2 and is not known to be cleared</source>
        <translation>%1 era %2 y no consta que se haya borrado</translation>
    </message>
    <message>
        <source>%1 was changed while it was played</source>
        <translation>%1 se modificó mientras se reproducía</translation>
    </message>
    <message>
        <source>%1 was closed before it was open</source>
        <translation>%1 se cerró antes de abrirse</translation>
    </message>
    <message>
        <source>%1 was disconnected</source>
        <translation>%1 se desconectó</translation>
    </message>
    <message>
        <source>%1 was made by a newer version of this program (schema %2, known here is %3)</source>
        <translation>%1 es de una versión más reciente de este programa (esquema %2, aquí se conoce %3)</translation>
    </message>
    <message>
        <source>%1 was not confirmed</source>
        <translation>%1 no se confirmó</translation>
    </message>
    <message>
        <source>%1 was refused: %2</source>
        <translation>%1 se rechazó: %2</translation>
    </message>
    <message>
        <source>%1 was stopped: %2, %3</source>
        <translation>%1 se paró: %2, %3</translation>
    </message>
    <message>
        <source>%1 was switched off</source>
        <translation>%1 se desactivó</translation>
    </message>
    <message>
        <source>%1 was unknown when the file was written</source>
        <translation>%1 era desconocido cuando se escribió el archivo</translation>
    </message>
    <message>
        <source>%1 was unplugged</source>
        <translation>%1 se desconectó</translation>
    </message>
    <message>
        <source>%1 was written as %2 but reads %3</source>
        <translation>%1 se escribió como %2 pero se lee %3</translation>
    </message>
    <message>
        <source>%1 where a record begins with a colon, is this an Intel HEX file?</source>
        <translation>%1 donde un registro empieza con dos puntos, ¿es un archivo Intel HEX?</translation>
    </message>
    <message>
        <source>%1 with %2 transmit and %3 receive errors</source>
        <translation>%1 con %2 errores de transmisión y %3 de recepción</translation>
    </message>
    <message>
        <source>%1 would be %2 of its smallest steps, too few to mean anything</source>
        <translation>%1 serían %2 de sus pasos mínimos, demasiado pocos para significar algo</translation>
    </message>
    <message>
        <source>%1 would have to be %2, which it cannot be</source>
        <translation>%1 tendría que ser %2, lo que no es posible</translation>
    </message>
    <message>
        <source>%1 written, read back and equal</source>
        <translation>%1 escritos, releídos e iguales</translation>
    </message>
    <message>
        <source>%1 written; %2 of them cannot be read back</source>
        <translation>%1 escritos; %2 de ellos no se pueden releer</translation>
    </message>
    <message>
        <source>%1 written; they cannot be read back</source>
        <translation>%1 escritos; no se pueden releer</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1, and the device switched its output off</source>
        <translation>%1, y el dispositivo apagó su salida</translation>
    </message>
    <message>
        <source>%1, line %2: %3</source>
        <translation>%1, línea %2: %3</translation>
    </message>
    <message>
        <source>%1, more than half a step from its target</source>
        <translation>%1, a más de medio escalón de su destino</translation>
    </message>
    <message>
        <source>%1, told to run at more than half a step</source>
        <translation>%1, con orden de marchar a más de medio escalón</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: %2 is above %3</source>
        <translation>%1: %2 es mayor que %3</translation>
    </message>
    <message>
        <source>%1: %2 is below %3</source>
        <translation>%1: %2 es menor que %3</translation>
    </message>
    <message>
        <source>%1: %2 is not a whole number</source>
        <translation>%1: %2 no es un número entero</translation>
    </message>
    <message>
        <source>%1: %2 of %3 ms is finer than the device follows, which takes a set-point every %4 ms</source>
        <translation>%1: %2 de %3 ms es más fino de lo que sigue el dispositivo, que admite una consigna cada %4 ms</translation>
    </message>
    <message>
        <source>%1: &apos;%2&apos; is neither on nor off</source>
        <translation>%1: «%2» no es ni on ni off</translation>
    </message>
    <message>
        <source>%1: &apos;%2&apos; is not a number</source>
        <translation>%1: «%2» no es un número</translation>
    </message>
    <message>
        <source>%1: cannot be read (system error %2)</source>
        <translation>%1: no se puede leer (error del sistema %2)</translation>
    </message>
    <message>
        <source>%1: its value is of the wrong kind</source>
        <translation>%1: su valor es de otro tipo</translation>
    </message>
    <message>
        <source>%1: its value says %2, its raw value %3</source>
        <translation>%1: su valor indica %2, su valor bruto %3</translation>
    </message>
    <message>
        <source>%1: legal is %2</source>
        <translation>%1: se admite %2</translation>
    </message>
    <message>
        <source>%1: legal is %2 … %3</source>
        <translation>%1: se admite %2 … %3</translation>
    </message>
    <message>
        <source>%1: no permission to read it</source>
        <translation>%1: sin permiso de lectura</translation>
    </message>
    <message>
        <source>%1: no such file</source>
        <translation>%1: no existe el archivo</translation>
    </message>
    <message>
        <source>%1: not a number</source>
        <translation>%1: no es un número</translation>
    </message>
    <message>
        <source>%1: raw is not a whole number</source>
        <translation>%1: raw no es un número entero</translation>
    </message>
    <message>
        <source>%1: raw value %2 is out of range</source>
        <translation>%1: el valor bruto %2 está fuera de rango</translation>
    </message>
    <message>
        <source>%1: status %2 has no meaning</source>
        <translation>%1: el estado %2 no tiene significado</translation>
    </message>
    <message>
        <source>%1: the device answers &apos;%2&apos;</source>
        <translation>%1: el dispositivo responde «%2»</translation>
    </message>
    <message>
        <source>%1: the device refused the value</source>
        <translation>%1: el dispositivo rechazó el valor</translation>
    </message>
    <message>
        <source>%1: this firmware does not know the parameter</source>
        <translation>%1: este firmware no conoce el parámetro</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1; %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no journal that stations share</source>
        <translation>«%1» no es un diario compartido entre estaciones</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no number</source>
        <translation>«%1» no es un número</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no path of a socket: it has 1 to 107 characters</source>
        <translation>«%1» no es una ruta de socket: debe tener de 1 a 107 caracteres</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no time in seconds</source>
        <translation>«%1» no es un tiempo en segundos</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no value for the option &apos;%2&apos; of %3</source>
        <translation>«%1» no es un valor para la opción «%2» de %3</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a device: LINK/FAMILY:ADDRESS is needed, such as sim:can/dmc60c:5</source>
        <translation>«%1» no es un dispositivo: se necesita LINK/FAMILY:ADDRESS, como sim:can/dmc60c:5</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a link: SCHEME:PATH is needed, such as socketcan:can0 or sim:</source>
        <translation>«%1» no es un enlace: se necesita SCHEME:PATH, como socketcan:can0 o sim:</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a simulated device: %2</source>
        <translation>«%1» no es un dispositivo simulado: %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not qtcan:PLUGIN:INTERFACE</source>
        <translation>«%1» no es qtcan:PLUGIN:INTERFACE</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be a number</source>
        <translation>«%1» debe ser un número</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be a text</source>
        <translation>«%1» debe ser un texto</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be a whole number</source>
        <translation>«%1» debe ser un número entero</translation>
    </message>
    <message>
        <source>a name has no line break, tabulator or other control character</source>
        <translation>un nombre no tiene saltos de línea, tabuladores ni otros caracteres de control</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be an object in braces</source>
        <translation>«%1» debe ser un objeto entre llaves</translation>
    </message>
    <message>
        <source>&apos;%1&apos; names no interface</source>
        <translation>«%1» no nombra ninguna interfaz</translation>
    </message>
    <message>
        <source>&apos;encoder&apos; is true: it counts both ways</source>
        <translation>«encoder» es true: cuenta en ambos sentidos</translation>
    </message>
    <message>
        <source>&apos;motorbenchctl snapshots&apos; lists those there are</source>
        <translation>«motorbenchctl snapshots» enumera las que hay</translation>
    </message>
    <message>
        <source>&apos;motorbenchctl trials&apos; lists those there are</source>
        <translation>«motorbenchctl trials» enumera los que hay</translation>
    </message>
    <message>
        <source>&apos;store&apos; must be true or false</source>
        <translation>«store» debe ser true o false</translation>
    </message>
    <message>
        <source>&apos;to&apos; is missing</source>
        <translation>falta «to»</translation>
    </message>
    <message>
        <source>--font-scale takes 0.5 to 3</source>
        <translation>--font-scale admite de 0.5 a 3</translation>
    </message>
    <message>
        <source>--language takes one of %1</source>
        <translation>--language admite uno de %1</translation>
    </message>
    <message>
        <source>--out &apos;%1&apos; is no picture</source>
        <translation>--out «%1» no es una imagen</translation>
    </message>
    <message>
        <source>%1 is no report</source>
        <translation>%1 no es un informe</translation>
    </message>
    <message>
        <source>--out &apos;%1&apos; is no PDF</source>
        <translation>--out «%1» no es un PDF</translation>
    </message>
    <message>
        <source>--help tells what there is</source>
        <translation>--help dice qué hay</translation>
    </message>
    <message>
        <source>--plot FILE or --report FILE, and --out FILE belong together</source>
        <translation>--plot FILE o --report FILE van junto con --out FILE</translation>
    </message>
    <message>
        <source>--size takes WIDTHxHEIGHT, such as 1280x800</source>
        <translation>--size admite WIDTHxHEIGHT, como 1280x800</translation>
    </message>
    <message>
        <source>--target is missing</source>
        <translation>falta --target</translation>
    </message>
    <message>
        <source>--target: &apos;%1&apos; is unknown</source>
        <translation>--target: «%1» es desconocido</translation>
    </message>
    <message>
        <source>--tour needs a folder for its pictures</source>
        <translation>--tour necesita una carpeta para sus imágenes</translation>
    </message>
    <message>
        <source>--via: &apos;%1&apos; is no way into a Supermodified</source>
        <translation>--via: «%1» no es un acceso a un Supermodified</translation>
    </message>
    <message>
        <source>--via: &apos;%1&apos; is no way into an Abstract DC Drive</source>
        <translation>--via: «%1» no es un acceso a un Abstract DC Drive</translation>
    </message>
    <message>
        <source>0 is no divisor</source>
        <translation>0 no es un divisor</translation>
    </message>
    <message>
        <source>1 byte</source>
        <translation>1 byte</translation>
    </message>
    <message>
        <source>A programmer on the pins erases the chip first, the stored settings and the serial bootloader with it: save the parameters before. The bootloader keeps both.</source>
        <translation>Un programador en los pines borra antes el chip, con él los ajustes guardados y el bootloader serie: guarde antes los parámetros. El bootloader conserva ambos.</translation>
    </message>
    <message>
        <source>Abstract DC Drives are found on CAN links only</source>
        <translation>Los Abstract DC Drive solo se encuentran en enlaces CAN</translation>
    </message>
    <message>
        <source>Abstract DC Drives found: %1</source>
        <translation>Abstract DC Drive encontrados: %1</translation>
    </message>
    <message>
        <source>Abstract DC Drives live on CAN links only</source>
        <translation>los Abstract DC Drive solo existen en enlaces CAN</translation>
    </message>
    <message>
        <source>All pages written</source>
        <translation>Todas las páginas escritas</translation>
    </message>
    <message>
        <source>Assign number</source>
        <translation>Asignar número</translation>
    </message>
    <message>
        <source>Autotune</source>
        <translation>Autoajuste</translation>
    </message>
    <message>
        <source>CAN high is not connected</source>
        <translation>CAN high no está conectada</translation>
    </message>
    <message>
        <source>CAN high is short to battery</source>
        <translation>CAN high en cortocircuito con la batería</translation>
    </message>
    <message>
        <source>CAN high is short to ground</source>
        <translation>CAN high en cortocircuito con masa</translation>
    </message>
    <message>
        <source>CAN high is short to supply</source>
        <translation>CAN high en cortocircuito con la alimentación</translation>
    </message>
    <message>
        <source>CAN low is not connected</source>
        <translation>CAN low no está conectada</translation>
    </message>
    <message>
        <source>CAN low is short to CAN high</source>
        <translation>CAN low en cortocircuito con CAN high</translation>
    </message>
    <message>
        <source>CAN low is short to battery</source>
        <translation>CAN low en cortocircuito con la batería</translation>
    </message>
    <message>
        <source>CAN low is short to ground</source>
        <translation>CAN low en cortocircuito con masa</translation>
    </message>
    <message>
        <source>CAN low is short to supply</source>
        <translation>CAN low en cortocircuito con la alimentación</translation>
    </message>
    <message>
        <source>CAN sockets cannot be opened: %1</source>
        <translation>no se pueden abrir sockets CAN: %1</translation>
    </message>
    <message>
        <source>CRC refused, nothing was erased; trying variant %1</source>
        <translation>CRC rechazado, no se borró nada; se prueba la variante %1</translation>
    </message>
    <message>
        <source>Connecting through OpenOCD</source>
        <translation>Conectando mediante OpenOCD</translation>
    </message>
    <message>
        <source>Connecting through avrdude</source>
        <translation>Conectando mediante avrdude</translation>
    </message>
    <message>
        <source>Count from 0</source>
        <translation>Contar desde 0</translation>
    </message>
    <message>
        <source>DMC60C controllers are found on CAN links only</source>
        <translation>los controladores DMC60C solo se encuentran en enlaces CAN</translation>
    </message>
    <message>
        <source>DMC60C found: %1</source>
        <translation>DMC60C encontrados: %1</translation>
    </message>
    <message>
        <source>Dialect %1 was chosen by hand, none was proven. %2</source>
        <translation>El dialecto %1 se eligió a mano, no se probó ninguno. %2</translation>
    </message>
    <message>
        <source>Dialect %1 was chosen by hand, the unit answered as %2. %3</source>
        <translation>El dialecto %1 se eligió a mano, el equipo respondió como %2. %3</translation>
    </message>
    <message>
        <source>Do a write again</source>
        <translation>Rehacer una escritura</translation>
    </message>
    <message>
        <source>Drives of two dialects answer with this offset in the recording.</source>
        <translation>En la grabación responden accionamientos de dos dialectos con este offset.</translation>
    </message>
    <message>
        <source>Enter bootloader</source>
        <translation>Entrada en el bootloader</translation>
    </message>
    <message>
        <source>Erasing flash</source>
        <translation>Borrando la flash</translation>
    </message>
    <message>
        <source>Erasing the stored settings</source>
        <translation>Borrando los ajustes guardados</translation>
    </message>
    <message>
        <source>Experiment</source>
        <translation>Experimento</translation>
    </message>
    <message>
        <source>FAMILY:ADDRESS is needed, such as dmc60c:5</source>
        <translation>se necesita FAMILY:ADDRESS, como dmc60c:5</translation>
    </message>
    <message>
        <source>Frequency response</source>
        <translation>Respuesta en frecuencia</translation>
    </message>
    <message>
        <source>GPIO line %1 is used by another program or driver</source>
        <translation>la línea GPIO %1 la usa otro programa o driver</translation>
    </message>
    <message>
        <source>GPIO line %1: %2</source>
        <translation>línea GPIO %1: %2</translation>
    </message>
    <message>
        <source>GetDescriptors: a field ends too early</source>
        <translation>GetDescriptors: un campo termina demasiado pronto</translation>
    </message>
    <message>
        <source>GetFlashSeqnum: 4 bytes were expected</source>
        <translation>GetFlashSeqnum: se esperaban 4 bytes</translation>
    </message>
    <message>
        <source>GetFwver answered with %1 bytes</source>
        <translation>GetFwver respondió con %1 bytes</translation>
    </message>
    <message>
        <source>GetFwver: 6 bytes were expected</source>
        <translation>GetFwver: se esperaban 6 bytes</translation>
    </message>
    <message>
        <source>Giving it number %1</source>
        <translation>Asignando el número %1</translation>
    </message>
    <message>
        <source>Identify</source>
        <translation>Identificar</translation>
    </message>
    <message>
        <source>It answers, but not as any known dialect; it can be watched but not driven.</source>
        <translation>Responde, pero en ningún dialecto conocido; se puede observar, pero no accionar.</translation>
    </message>
    <message>
        <source>It is not driven: %1.</source>
        <translation>No se acciona: %1.</translation>
    </message>
    <message>
        <source>Its answers fit no known dialect.</source>
        <translation>Sus respuestas no encajan en ningún dialecto conocido.</translation>
    </message>
    <message>
        <source>Its error level is 1, so every reading fails. Set error.level to 0.</source>
        <translation>Su nivel de error es 1, así que toda lectura falla. Ponga error.level a 0.</translation>
    </message>
    <message>
        <source>Keep the gains of a trial</source>
        <translation>Conservar las ganancias de un ensayo</translation>
    </message>
    <message>
        <source>Look at the restarted unit</source>
        <translation>Examinar el equipo reiniciado</translation>
    </message>
    <message>
        <source>Look for gains that are owed</source>
        <translation>Buscar ganancias por restituir</translation>
    </message>
    <message>
        <source>Looking for Abstract DC Drives</source>
        <translation>Buscando Abstract DC Drive</translation>
    </message>
    <message>
        <source>Looking for DMC60C</source>
        <translation>Buscando DMC60C</translation>
    </message>
    <message>
        <source>Looking for Supermodified nodes at %1 bit/s</source>
        <translation>Buscando nodos Supermodified a %1 bit/s</translation>
    </message>
    <message>
        <source>Looking for the controller</source>
        <translation>Buscando el controlador</translation>
    </message>
    <message>
        <source>Looking for the drive</source>
        <translation>Buscando el accionamiento</translation>
    </message>
    <message>
        <source>No application runs; update its firmware.</source>
        <translation>No se ejecuta ninguna aplicación; actualice su firmware.</translation>
    </message>
    <message>
        <source>Number %1 is used by %2 units; give each its own before one is driven.</source>
        <translation>El número %1 lo usan %2 equipos; dé a cada uno el suyo antes de accionar alguno.</translation>
    </message>
    <message>
        <source>OpenOCD ended without saying why</source>
        <translation>OpenOCD terminó sin indicar el motivo</translation>
    </message>
    <message>
        <source>OpenOCD verified the flash, and the drive answers again</source>
        <translation>OpenOCD verificó la flash y el accionamiento responde de nuevo</translation>
    </message>
    <message>
        <source>OpenOCD verified the flash, but nothing answers as %1; the new firmware may have another offset or bit rate: scan again</source>
        <translation>OpenOCD verificó la flash, pero nada responde como %1; el firmware nuevo puede tener otro offset u otra velocidad en bits: busque de nuevo</translation>
    </message>
    <message>
        <source>OpenOCD: %1</source>
        <translation>OpenOCD: %1</translation>
    </message>
    <message>
        <source>Page %1</source>
        <translation>Página %1</translation>
    </message>
    <message>
        <source>Preflight</source>
        <translation>Comprobación previa</translation>
    </message>
    <message>
        <source>Product %1 is not known to be a DMC60C.</source>
        <translation>No consta que el producto %1 sea un DMC60C.</translation>
    </message>
    <message>
        <source>Put gains back</source>
        <translation>Restituir ganancias</translation>
    </message>
    <message>
        <source>Put values back</source>
        <translation>Restituir valores</translation>
    </message>
    <message>
        <source>Read</source>
        <translation>Leído</translation>
    </message>
    <message>
        <source>Read and clear faults</source>
        <translation>Leer y borrar fallos</translation>
    </message>
    <message>
        <source>Read parameters</source>
        <translation>Leer parámetros</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>Leyendo %1</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Renombrar</translation>
    </message>
    <message>
        <source>Restart</source>
        <translation>Reinicio</translation>
    </message>
    <message>
        <source>Restarting the drive</source>
        <translation>Reiniciando el accionamiento</translation>
    </message>
    <message>
        <source>STOP was pressed</source>
        <translation>se pulsó STOP</translation>
    </message>
    <message>
        <source>Saved</source>
        <translation>Guardado</translation>
    </message>
    <message>
        <source>Saving the %1 loop</source>
        <translation>Guardando el lazo de %1</translation>
    </message>
    <message>
        <source>Set telemetry rate</source>
        <translation>Fijar frecuencia de telemetría</translation>
    </message>
    <message>
        <source>Set telemetry rate: %1</source>
        <translation>Fijar frecuencia de telemetría: %1</translation>
    </message>
    <message>
        <source>Several drives answer with offset %1; offsets are compiled into the firmware, so give one of them another and flash it.</source>
        <translation>Varios accionamientos responden con el offset %1; los offsets están compilados en el firmware: dé otro a uno de ellos y grábelo.</translation>
    </message>
    <message>
        <source>So old that nothing but its power stops it; it can be watched but not driven.</source>
        <translation>Tan antiguo que solo lo para cortar la alimentación; se puede observar, pero no accionar.</translation>
    </message>
    <message>
        <source>Speaks the document&apos;s codes, which no published firmware does.</source>
        <translation>Usa los códigos del documento, cosa que ningún firmware publicado hace.</translation>
    </message>
    <message>
        <source>Speaks the firmware&apos;s codes, not the document&apos;s.</source>
        <translation>Usa los códigos del firmware, no los del documento.</translation>
    </message>
    <message>
        <source>Speaks the legacy frames of 8 bytes, as the published master does.</source>
        <translation>Usa las tramas antiguas de 8 bytes, como el maestro publicado.</translation>
    </message>
    <message>
        <source>Store to flash</source>
        <translation>Guardar en flash</translation>
    </message>
    <message>
        <source>Supermodified controllers are found on serial links only</source>
        <translation>los controladores Supermodified solo se encuentran en enlaces serie</translation>
    </message>
    <message>
        <source>Supermodified found: %1</source>
        <translation>Supermodified encontrados: %1</translation>
    </message>
    <message>
        <source>Take a snapshot</source>
        <translation>Tomar una instantánea</translation>
    </message>
    <message>
        <source>The adapter has no %1 bit/s</source>
        <translation>El adaptador no tiene %1 bit/s</translation>
    </message>
    <message>
        <source>The bootloader runs; restart the unit or update its firmware.</source>
        <translation>Se ejecuta el bootloader; reinicie el equipo o actualice su firmware.</translation>
    </message>
    <message>
        <source>The controller tells no version: the programmer&apos;s own verify and the controller&apos;s answer prove the update.</source>
        <translation>El controlador no indica versión: la verificación del programador y la respuesta del controlador prueban la actualización.</translation>
    </message>
    <message>
        <source>The drive tells no version: the programmer&apos;s own verify and the drive&apos;s answer prove the update.</source>
        <translation>El accionamiento no indica versión: la verificación del programador y la respuesta del accionamiento prueban la actualización.</translation>
    </message>
    <message>
        <source>The image holds a bootloader too, so it needs a programmer on the pins.</source>
        <translation>La imagen contiene también un bootloader, así que necesita un programador en los pines.</translation>
    </message>
    <message>
        <source>The image writes the settings pages: stored gains are replaced.</source>
        <translation>La imagen escribe las páginas de ajustes: las ganancias guardadas se sustituyen.</translation>
    </message>
    <message>
        <source>The recording does not tell which codes it speaks: it was asked for what all answer alike.</source>
        <translation>La grabación no indica qué códigos usa: se le consultó lo que todos responden igual.</translation>
    </message>
    <message>
        <source>The serial bootloader listens for a moment after power-up only: restart the controller when the update begins.</source>
        <translation>El bootloader serie solo escucha un momento tras el encendido: reinicie el controlador cuando empiece la actualización.</translation>
    </message>
    <message>
        <source>This unit has no number and no application; assign a number, then update its firmware.</source>
        <translation>Este equipo no tiene número ni aplicación; asígnele un número y después actualice su firmware.</translation>
    </message>
    <message>
        <source>This unit has no number yet; assign one from 1 to 63.</source>
        <translation>Este equipo aún no tiene número; asígnele uno de 1 a 63.</translation>
    </message>
    <message>
        <source>Undo a write</source>
        <translation>Deshacer una escritura</translation>
    </message>
    <message>
        <source>Update firmware</source>
        <translation>Actualizar firmware</translation>
    </message>
    <message>
        <source>Verifying flash</source>
        <translation>Verificando la flash</translation>
    </message>
    <message>
        <source>Wait for %1</source>
        <translation>Esperar a %1</translation>
    </message>
    <message>
        <source>Waiting until the device has written its flash</source>
        <translation>Esperando a que el dispositivo escriba su flash</translation>
    </message>
    <message>
        <source>Write parameters</source>
        <translation>Escribir parámetros</translation>
    </message>
    <message>
        <source>Write settings again</source>
        <translation>Reescribir ajustes</translation>
    </message>
    <message>
        <source>Writing %1</source>
        <translation>Escribiendo %1</translation>
    </message>
    <message>
        <source>Writing flash</source>
        <translation>Escribiendo la flash</translation>
    </message>
    <message>
        <source>Written</source>
        <translation>Escrito</translation>
    </message>
    <message>
        <source>&quot;via&quot; must name the other way in, such as &quot;%1&quot;</source>
        <translation>&quot;via&quot; debe indicar el otro acceso, como &quot;%1&quot;</translation>
    </message>
    <message>
        <source>a DMC60C has a number from 0 to 63, not %1</source>
        <translation>un DMC60C tiene un número de 0 a 63, no %1</translation>
    </message>
    <message>
        <source>a DMC60C has no mode &apos;%1&apos;</source>
        <translation>un DMC60C no tiene el modo «%1»</translation>
    </message>
    <message>
        <source>a DMC60C has one axis</source>
        <translation>un DMC60C tiene un eje</translation>
    </message>
    <message>
        <source>a DMC60C has the gain slots 0 and 1</source>
        <translation>un DMC60C tiene las ranuras de ganancias 0 y 1</translation>
    </message>
    <message>
        <source>a DMC60C is simulated on a CAN link</source>
        <translation>un DMC60C se simula en un enlace CAN</translation>
    </message>
    <message>
        <source>a DMC60C is updated over its own link</source>
        <translation>un DMC60C se actualiza por su propio enlace</translation>
    </message>
    <message>
        <source>a GPIO line is CHIP:LINE, as in gpiochip0:25, not &apos;%1&apos;</source>
        <translation>una línea GPIO es CHIP:LINE, como gpiochip0:25, no «%1»</translation>
    </message>
    <message>
        <source>a QuadQuad2Drv has no address but 0</source>
        <translation>un QuadQuad2Drv no tiene otra dirección que 0</translation>
    </message>
    <message>
        <source>a QuadQuad2Drv has one kind of chip</source>
        <translation>un QuadQuad2Drv tiene un solo tipo de chip</translation>
    </message>
    <message>
        <source>a QuadQuad2Drv is simulated on the board&apos;s end of an SPI link</source>
        <translation>un QuadQuad2Drv se simula en el extremo de la placa de un enlace SPI</translation>
    </message>
    <message>
        <source>a QuadQuad2Drv lives on an SPI link</source>
        <translation>un QuadQuad2Drv está en un enlace SPI</translation>
    </message>
    <message>
        <source>a Supermodified has an id from 1 to 127, not %1</source>
        <translation>un Supermodified tiene un id de 1 a 127, no %1</translation>
    </message>
    <message>
        <source>a Supermodified has no mode &apos;%1&apos;</source>
        <translation>un Supermodified no tiene el modo «%1»</translation>
    </message>
    <message>
        <source>a Supermodified has one axis and one set of gains</source>
        <translation>un Supermodified tiene un eje y un juego de ganancias</translation>
    </message>
    <message>
        <source>a Supermodified has one kind of microcontroller</source>
        <translation>un Supermodified tiene un solo tipo de microcontrolador</translation>
    </message>
    <message>
        <source>a Supermodified is simulated on a serial link</source>
        <translation>un Supermodified se simula en un enlace serie</translation>
    </message>
    <message>
        <source>a Supermodified is written by avrdude</source>
        <translation>un Supermodified se escribe con avrdude</translation>
    </message>
    <message>
        <source>a bit</source>
        <translation>un bit</translation>
    </message>
    <message>
        <source>a bootloader needs the board&apos;s serial line, such as boot=pty:./boot</source>
        <translation>un bootloader necesita la línea serie de la placa, como boot=pty:./boot</translation>
    </message>
    <message>
        <source>a buffered move is not acknowledged yet</source>
        <translation>un movimiento en búfer aún no está confirmado</translation>
    </message>
    <message>
        <source>a demo remembers no layouts</source>
        <translation>una demo no recuerda disposiciones</translation>
    </message>
    <message>
        <source>a device cannot follow itself</source>
        <translation>un dispositivo no puede seguirse a sí mismo</translation>
    </message>
    <message>
        <source>a device number is 1 … 63</source>
        <translation>un número de dispositivo es 1 … 63</translation>
    </message>
    <message>
        <source>a divisor changes all gains at once</source>
        <translation>un divisor cambia todas las ganancias a la vez</translation>
    </message>
    <message>
        <source>a drive of dialect LL has no code for stop</source>
        <translation>un accionamiento de dialecto LL no tiene código de parada</translation>
    </message>
    <message>
        <source>a formula assigns nothing</source>
        <translation>una fórmula no asigna nada</translation>
    </message>
    <message>
        <source>a formula has at most 4000 characters</source>
        <translation>una fórmula tiene como máximo 4000 caracteres</translation>
    </message>
    <message>
        <source>a half swing</source>
        <translation>media oscilación</translation>
    </message>
    <message>
        <source>a load takes %1 of what P makes of a step, at most 10 %</source>
        <translation>una carga toma %1 de lo que P hace de un escalón, como máximo 10 %</translation>
    </message>
    <message>
        <source>a motor is driven on this line</source>
        <translation>en esta línea se acciona un motor</translation>
    </message>
    <message>
        <source>a motor is driven on this line at %1 bit/s, and this node has another rate</source>
        <translation>en esta línea se acciona un motor a %1 bit/s y este nodo tiene otra velocidad</translation>
    </message>
    <message>
        <source>a name has 1 to 64 characters</source>
        <translation>un nombre tiene de 1 a 64 caracteres</translation>
    </message>
    <message>
        <source>a name may hold Latin-1 characters only</source>
        <translation>un nombre solo admite caracteres Latin-1</translation>
    </message>
    <message>
        <source>a node id is 1 … 127</source>
        <translation>un id de nodo es 1 … 127</translation>
    </message>
    <message>
        <source>a parenthesis is not closed</source>
        <translation>un paréntesis está sin cerrar</translation>
    </message>
    <message>
        <source>a part of them is in force after a restart only</source>
        <translation>una parte de ellos solo está vigente tras un reinicio</translation>
    </message>
    <message>
        <source>a profile has up to 100000 counts/s and 1000000 counts/s²</source>
        <translation>un perfil admite hasta 100000 counts/s y 1000000 counts/s²</translation>
    </message>
    <message>
        <source>a push has fewer than 8 positions</source>
        <translation>un empuje tiene menos de 8 posiciones</translation>
    </message>
    <message>
        <source>a push moved the motor by fewer than 50 counts</source>
        <translation>un empuje movió el motor menos de 50 cuentas</translation>
    </message>
    <message>
        <source>a push of %1 duty drew %2 A, more than half of what is allowed</source>
        <translation>un empuje con ciclo %1 consumió %2 A, más de la mitad de lo permitido</translation>
    </message>
    <message>
        <source>a rate is a positive number, or 0 for the usual one</source>
        <translation>una frecuencia es un número positivo, o 0 para la habitual</translation>
    </message>
    <message>
        <source>a recipe is a JSON object</source>
        <translation>una receta es un objeto JSON</translation>
    </message>
    <message>
        <source>a record of type %1 has %2 data bytes, not %3</source>
        <translation>un registro de tipo %1 tiene %2 bytes de datos, no %3</translation>
    </message>
    <message>
        <source>a relative move was not answered, and is never sent twice: look where the motor stands</source>
        <translation>un movimiento relativo quedó sin respuesta y nunca se envía dos veces: mire dónde está el motor</translation>
    </message>
    <message>
        <source>a reserved bit</source>
        <translation>un bit reservado</translation>
    </message>
    <message>
        <source>a scan of the recording lists who does</source>
        <translation>una búsqueda en la grabación enumera quién lo hace</translation>
    </message>
    <message>
        <source>a simulated Abstract DC Drive</source>
        <translation>un Abstract DC Drive simulado</translation>
    </message>
    <message>
        <source>a simulated DMC60C</source>
        <translation>un DMC60C simulado</translation>
    </message>
    <message>
        <source>a simulated QuadQuad2Drv</source>
        <translation>un QuadQuad2Drv simulado</translation>
    </message>
    <message>
        <source>a simulated Supermodified</source>
        <translation>un Supermodified simulado</translation>
    </message>
    <message>
        <source>a step from the wrong place could be far too large</source>
        <translation>un escalón desde el lugar equivocado podría ser demasiado grande</translation>
    </message>
    <message>
        <source>a step of %1 counts overflows the loop of this firmware</source>
        <translation>un escalón de %1 cuentas desborda el lazo de este firmware</translation>
    </message>
    <message>
        <source>a step of %1 counts with P %2, D %3</source>
        <translation>un escalón de %1 cuentas con P %2, D %3</translation>
    </message>
    <message>
        <source>a step of %1 counts with the gains as they are</source>
        <translation>un escalón de %1 cuentas con las ganancias tal como están</translation>
    </message>
    <message>
        <source>a stop went first</source>
        <translation>una parada pasó antes</translation>
    </message>
    <message>
        <source>a swing</source>
        <translation>una oscilación</translation>
    </message>
    <message>
        <source>a temporary file for %1 cannot be written: %2</source>
        <translation>no se puede escribir un archivo temporal para %1: %2</translation>
    </message>
    <message>
        <source>a time</source>
        <translation>un tiempo</translation>
    </message>
    <message>
        <source>a trial that is not kept</source>
        <translation>un ensayo que no se conserva</translation>
    </message>
    <message>
        <source>a unit that has a serial number needs no tag</source>
        <translation>un equipo con número de serie no necesita etiqueta</translation>
    </message>
    <message>
        <source>travel</source>
        <translation>recorrido</translation>
    </message>
    <message>
        <source>accepted</source>
        <translation>aceptado</translation>
    </message>
    <message>
        <source>active error flag</source>
        <translation>indicador de error activo</translation>
    </message>
    <message>
        <source>add --via %1</source>
        <translation>añada --via %1</translation>
    </message>
    <message>
        <source>add --via openocd:INTERFACE --target f1|f4, such as --via openocd:stlink --target f1</source>
        <translation>añada --via openocd:INTERFACE --target f1|f4, como --via openocd:stlink --target f1</translation>
    </message>
    <message>
        <source>add ready=CHIP:LINE to the address</source>
        <translation>añada ready=CHIP:LINE a la dirección</translation>
    </message>
    <message>
        <source>add reset=CHIP:LINE to the address</source>
        <translation>añada reset=CHIP:LINE a la dirección</translation>
    </message>
    <message>
        <source>address %1 is %2 here and %3 in line %4</source>
        <translation>la dirección %1 es %2 aquí y %3 en la línea %4</translation>
    </message>
    <message>
        <source>aim for a calmer loop</source>
        <translation>busque un lazo más suave</translation>
    </message>
    <message>
        <source>all %1 read</source>
        <translation>leídos los %1</translation>
    </message>
    <message>
        <source>all pages are in the unit</source>
        <translation>todas las páginas están en el equipo</translation>
    </message>
    <message>
        <source>allow CAN sockets in the container or sandbox</source>
        <translation>permita sockets CAN en el contenedor o sandbox</translation>
    </message>
    <message>
        <source>allow it more power, or free its shaft</source>
        <translation>permítale más potencia o libere su eje</translation>
    </message>
    <message>
        <source>allow more current</source>
        <translation>permita más corriente</translation>
    </message>
    <message>
        <source>allow more current or duty</source>
        <translation>permita más corriente o ciclo</translation>
    </message>
    <message>
        <source>allow more duty</source>
        <translation>permita más ciclo</translation>
    </message>
    <message>
        <source>allow more speed</source>
        <translation>permita más velocidad</translation>
    </message>
    <message>
        <source>allow more travel</source>
        <translation>permita más recorrido</translation>
    </message>
    <message>
        <source>allow more travel or duty</source>
        <translation>permita más recorrido o ciclo</translation>
    </message>
    <message>
        <source>allow more travel or speed</source>
        <translation>permita más recorrido o velocidad</translation>
    </message>
    <message>
        <source>allow more, then close and open the link</source>
        <translation>permita más; después cierre y abra el enlace</translation>
    </message>
    <message>
        <source>allow them in the container or sandbox</source>
        <translation>permítalos en el contenedor o sandbox</translation>
    </message>
    <message>
        <source>an Abstract DC Drive cannot be asked for its settings</source>
        <translation>a un Abstract DC Drive no se le pueden consultar sus ajustes</translation>
    </message>
    <message>
        <source>an Abstract DC Drive has an offset from 0 to 99, not %1</source>
        <translation>un Abstract DC Drive tiene un offset de 0 a 99, no %1</translation>
    </message>
    <message>
        <source>an Abstract DC Drive has no mode &apos;%1&apos;</source>
        <translation>un Abstract DC Drive no tiene el modo «%1»</translation>
    </message>
    <message>
        <source>an Abstract DC Drive is written through a debug probe</source>
        <translation>un Abstract DC Drive se escribe mediante una sonda de depuración</translation>
    </message>
    <message>
        <source>an answer of %1 bytes</source>
        <translation>una respuesta de %1 bytes</translation>
    </message>
    <message>
        <source>an axis from 1 to 4 and a power limit above 0 are needed</source>
        <translation>se necesitan un eje de 1 a 4 y un límite de potencia mayor que 0</translation>
    </message>
    <message>
        <source>an experiment is run once at least</source>
        <translation>un experimento se ejecuta al menos una vez</translation>
    </message>
    <message>
        <source>another master drives %1</source>
        <translation>otro maestro acciona %1</translation>
    </message>
    <message>
        <source>another master sends control frames to this device</source>
        <translation>otro maestro envía tramas de control a este dispositivo</translation>
    </message>
    <message>
        <source>another program or controller drives this unit</source>
        <translation>otro programa o controlador acciona este equipo</translation>
    </message>
    <message>
        <source>answers again</source>
        <translation>responde de nuevo</translation>
    </message>
    <message>
        <source>arbitration lost</source>
        <translation>arbitraje perdido</translation>
    </message>
    <message>
        <source>arbitration lost at bit %1</source>
        <translation>arbitraje perdido en el bit %1</translation>
    </message>
    <message>
        <source>arm again</source>
        <translation>arme de nuevo</translation>
    </message>
    <message>
        <source>arm it first</source>
        <translation>ármelo primero</translation>
    </message>
    <message>
        <source>arrived damaged, nothing was erased</source>
        <translation>llegó dañada, no se borró nada</translation>
    </message>
    <message>
        <source>asking for the version</source>
        <translation>preguntando la versión</translation>
    </message>
    <message>
        <source>assign one before it is driven</source>
        <translation>asigne uno antes de accionarlo</translation>
    </message>
    <message>
        <source>at most %1 with its P: use a profiled mode or several moves</source>
        <translation>como máximo %1 con su P: use un modo con perfil o varios movimientos</translation>
    </message>
    <message>
        <source>average takes 0 to 3600 seconds, not &apos;%1&apos;</source>
        <translation>average admite de 0 a 3600 segundos, no «%1»</translation>
    </message>
    <message>
        <source>average takes a signal and seconds, such as average(x, 0.1)</source>
        <translation>average admite una señal y segundos, como average(x, 0.1)</translation>
    </message>
    <message>
        <source>avrdude ended without saying why</source>
        <translation>avrdude terminó sin indicar el motivo</translation>
    </message>
    <message>
        <source>avrdude had the port</source>
        <translation>avrdude tenía el puerto</translation>
    </message>
    <message>
        <source>avrdude is not installed</source>
        <translation>avrdude no está instalado</translation>
    </message>
    <message>
        <source>avrdude read back all %1 bytes and they are equal, but the controller does not answer; cut its power for a moment, and scan: a new firmware may have another rate or node id</source>
        <translation>avrdude releyó los %1 bytes y son iguales, pero el controlador no responde; corte un momento su alimentación y busque: un firmware nuevo puede tener otra velocidad u otro id de nodo</translation>
    </message>
    <message>
        <source>avrdude read back all %1 bytes and they are equal; the controller answers again, dialect %2</source>
        <translation>avrdude releyó los %1 bytes y son iguales; el controlador responde de nuevo, dialecto %2</translation>
    </message>
    <message>
        <source>baud, format, rs485 and echo are known</source>
        <translation>se conocen baud, format, rs485 y echo</translation>
    </message>
    <message>
        <source>become a member of its group</source>
        <translation>hágase miembro de su grupo</translation>
    </message>
    <message>
        <source>begin another recipe, or another bus</source>
        <translation>empiece otra receta u otro bus</translation>
    </message>
    <message>
        <source>bit error</source>
        <translation>error de bit</translation>
    </message>
    <message>
        <source>boot= names a serial link, such as pty:./boot</source>
        <translation>boot= indica un enlace serie, como pty:./boot</translation>
    </message>
    <message>
        <source>bootloader</source>
        <translation>bootloader</translation>
    </message>
    <message>
        <source>bring it to rest first</source>
        <translation>párelo primero</translation>
    </message>
    <message>
        <source>bring it up</source>
        <translation>activarla</translation>
    </message>
    <message>
        <source>bring it up as a full member</source>
        <translation>activarla como miembro pleno</translation>
    </message>
    <message>
        <source>bus error</source>
        <translation>error de bus</translation>
    </message>
    <message>
        <source>bus overload</source>
        <translation>sobrecarga del bus</translation>
    </message>
    <message>
        <source>bus-off</source>
        <translation>bus-off</translation>
    </message>
    <message>
        <source>bus-off: %1 left the bus after too many errors</source>
        <translation>bus-off: %1 abandonó el bus tras demasiados errores</translation>
    </message>
    <message>
        <source>bus-off: the adapter left the bus after too many errors</source>
        <translation>bus-off: el adaptador abandonó el bus tras demasiados errores</translation>
    </message>
    <message>
        <source>bus-off: the controller left the bus after too many errors</source>
        <translation>bus-off: el controlador abandonó el bus tras demasiados errores</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>cancelado</translation>
    </message>
    <message>
        <source>cannot be read (system error %1)</source>
        <translation>no se puede leer (error del sistema %1)</translation>
    </message>
    <message>
        <source>change its mode, or copy it</source>
        <translation>cambie sus permisos o cópielo</translation>
    </message>
    <message>
        <source>check its rights</source>
        <translation>compruebe sus permisos</translation>
    </message>
    <message>
        <source>check that somebody else is on the bus</source>
        <translation>compruebe que haya alguien más en el bus</translation>
    </message>
    <message>
        <source>check the cable, both 120 Ω resistors, and that no number is taken twice</source>
        <translation>compruebe el cable, las dos resistencias de 120 Ω y que ningún número esté duplicado</translation>
    </message>
    <message>
        <source>check the cables and try again</source>
        <translation>compruebe los cables e inténtelo de nuevo</translation>
    </message>
    <message>
        <source>check the disk</source>
        <translation>compruebe el disco</translation>
    </message>
    <message>
        <source>check the jumper AUX1–AUX2, the crossed wires TX and RX, and the 3.3 V levels, then reset the board</source>
        <translation>compruebe el puente AUX1–AUX2, los cables TX y RX cruzados y los niveles de 3,3 V; después reinicie la placa</translation>
    </message>
    <message>
        <source>check the path</source>
        <translation>compruebe la ruta</translation>
    </message>
    <message>
        <source>check the probe and try again</source>
        <translation>compruebe la sonda e inténtelo de nuevo</translation>
    </message>
    <message>
        <source>check the rights of the folder above it</source>
        <translation>compruebe los permisos de la carpeta superior</translation>
    </message>
    <message>
        <source>check wiring, termination and bit rate</source>
        <translation>compruebe cableado, terminación y velocidad en bits</translation>
    </message>
    <message>
        <source>check wiring, termination and bit rate, then</source>
        <translation>compruebe cableado, terminación y velocidad en bits; después</translation>
    </message>
    <message>
        <source>check wiring, termination and bit rate, then reconnect</source>
        <translation>compruebe cableado, terminación y velocidad en bits, y reconecte</translation>
    </message>
    <message>
        <source>check wiring, termination and bit rate; it starts again by itself</source>
        <translation>compruebe cableado, terminación y velocidad en bits; arranca de nuevo por sí solo</translation>
    </message>
    <message>
        <source>checksum is %1, %2 is needed</source>
        <translation>la suma de comprobación es %1, debe ser %2</translation>
    </message>
    <message>
        <source>chirp: %1 s hold no whole swing of %2 Hz</source>
        <translation>chirp: en %1 s no cabe ninguna oscilación completa de %2 Hz</translation>
    </message>
    <message>
        <source>choose a smaller --size</source>
        <translation>elija un --size menor</translation>
    </message>
    <message>
        <source>choose another folder</source>
        <translation>elija otra carpeta</translation>
    </message>
    <message>
        <source>choose another one</source>
        <translation>elija otro</translation>
    </message>
    <message>
        <source>choose another path</source>
        <translation>elija otra ruta</translation>
    </message>
    <message>
        <source>choose another place</source>
        <translation>elija otro lugar</translation>
    </message>
    <message>
        <source>close that one first (&apos;fuser %1&apos; names it)</source>
        <translation>cierre antes ese («fuser %1» indica cuál)</translation>
    </message>
    <message>
        <source>close the jumper between AUX1 and AUX2, then reset the board or switch it off and on</source>
        <translation>ponga el puente entre AUX1 y AUX2; después reinicie la placa o apáguela y enciéndala</translation>
    </message>
    <message>
        <source>control is locked until one has another number</source>
        <translation>el control está bloqueado hasta que uno tenga otro número</translation>
    </message>
    <message>
        <source>copy the recording to another one</source>
        <translation>copie la grabación a otro</translation>
    </message>
    <message>
        <source>current</source>
        <translation>corriente</translation>
    </message>
    <message>
        <source>current %1 A is above 1.5 × %2 A</source>
        <translation>la corriente %1 A supera 1,5 × %2 A</translation>
    </message>
    <message>
        <source>current was above %1 A for %2</source>
        <translation>la corriente superó %1 A durante %2</translation>
    </message>
    <message>
        <source>cut the power if the motor still turns</source>
        <translation>corte la alimentación si el motor sigue girando</translation>
    </message>
    <message>
        <source>delete it, the value says the same</source>
        <translation>bórrelo, el valor indica lo mismo</translation>
    </message>
    <message>
        <source>delete the one of the two that is old</source>
        <translation>borre de los dos el que sea antiguo</translation>
    </message>
    <message>
        <source>derivative and integral take one signal</source>
        <translation>derivative e integral admiten una señal</translation>
    </message>
    <message>
        <source>dialect LL has no code for stop</source>
        <translation>el dialecto LL no tiene código de parada</translation>
    </message>
    <message>
        <source>do it again</source>
        <translation>repítalo</translation>
    </message>
    <message>
        <source>does not answer any more</source>
        <translation>ya no responde</translation>
    </message>
    <message>
        <source>dominant bit not sent</source>
        <translation>bit dominante no enviado</translation>
    </message>
    <message>
        <source>dry run: %1 lines would be sent over %2</source>
        <translation>simulacro: se enviarían %1 líneas por %2</translation>
    </message>
    <message>
        <source>dry run: %1 pages would be written</source>
        <translation>simulacro: se escribirían %1 páginas</translation>
    </message>
    <message>
        <source>dry run: %1 pages would be written, version %2</source>
        <translation>simulacro: se escribirían %1 páginas, versión %2</translation>
    </message>
    <message>
        <source>duty</source>
        <translation>ciclo de trabajo</translation>
    </message>
    <message>
        <source>duty %1 % is above %2 %</source>
        <translation>el ciclo %1 % supera %2 %</translation>
    </message>
    <message>
        <source>duty %1 ± %2 %, at most %3 counts/s, %4 counts one way, %5 s</source>
        <translation>ciclo %1 ± %2 %, como máximo %3 counts/s, %4 counts en un sentido, %5 s</translation>
    </message>
    <message>
        <source>duty is a fraction from −1 to 1</source>
        <translation>el ciclo de trabajo es una fracción de −1 a 1</translation>
    </message>
    <message>
        <source>enable SPI in the device tree (on a Raspberry Pi: dtparam=spi=on) and restart</source>
        <translation>active SPI en el árbol de dispositivos (en una Raspberry Pi: dtparam=spi=on) y reinicie</translation>
    </message>
    <message>
        <source>end it in .pdf or .html</source>
        <translation>termínelo en .pdf o .html</translation>
    </message>
    <message>
        <source>end it in .png, .svg or .pdf</source>
        <translation>termínelo en .png, .svg o .pdf</translation>
    </message>
    <message>
        <source>end that first</source>
        <translation>termínelo primero</translation>
    </message>
    <message>
        <source>end that one first, or choose another path</source>
        <translation>termine antes ese o elija otra ruta</translation>
    </message>
    <message>
        <source>ending=%1: legal are cr, lf and crlf</source>
        <translation>ending=%1: se admiten cr, lf y crlf</translation>
    </message>
    <message>
        <source>error</source>
        <translation>error</translation>
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
        <source>every id that this program could use on the line belongs to the group of a node, so answers would be taken for commands; set node.mask to 255 and restart the nodes</source>
        <translation>todo id que este programa podría usar en la línea pertenece al grupo de un nodo, así que las respuestas se tomarían por órdenes; ponga node.mask a 255 y reinicie los nodos</translation>
    </message>
    <message>
        <source>every line was confirmed, and the board answers with version %1</source>
        <translation>se confirmaron todas las líneas y la placa responde con la versión %1</translation>
    </message>
    <message>
        <source>every line was confirmed, and the board answers with version %1, the same as before, so that nothing proves the new firmware</source>
        <translation>se confirmaron todas las líneas y la placa responde con la versión %1, la misma de antes, así que nada prueba el firmware nuevo</translation>
    </message>
    <message>
        <source>every line was confirmed, but the board does not answer over SPI</source>
        <translation>se confirmaron todas las líneas, pero la placa no responde por SPI</translation>
    </message>
    <message>
        <source>exchange the wires of the motor or the phases of the encoder</source>
        <translation>intercambie los cables del motor o las fases del encoder</translation>
    </message>
    <message>
        <source>exchange the wires of the motor or the phases of the encoder before any loop is closed</source>
        <translation>intercambie los cables del motor o las fases del encoder antes de cerrar ningún lazo</translation>
    </message>
    <message>
        <source>expected time, channel, value and unit</source>
        <translation>se esperaba tiempo, canal, valor y unidad</translation>
    </message>
    <message>
        <source>fault &apos;%1&apos; does not parse</source>
        <translation>el fallo «%1» no se puede interpretar</translation>
    </message>
    <message>
        <source>fewer than 16 samples connect</source>
        <translation>menos de 16 muestras contiguas</translation>
    </message>
    <message>
        <source>find it by listening only</source>
        <translation>averiguarla solo escuchando</translation>
    </message>
    <message>
        <source>find its gain scales first: Overview, Find the gain scales</source>
        <translation>halle antes sus escalas de ganancia: Resumen, «Hallar las escalas de ganancia»</translation>
    </message>
    <message>
        <source>find the sender that fills it, on the Bus page or with &apos;motorbenchctl monitor&apos;</source>
        <translation>busque el emisor que lo llena, en la página Bus o con «motorbenchctl monitor»</translation>
    </message>
    <message>
        <source>firmware update</source>
        <translation>actualización de firmware</translation>
    </message>
    <message>
        <source>firmware: %1</source>
        <translation>firmware: %1</translation>
    </message>
    <message>
        <source>follow needs the number of a device</source>
        <translation>el seguimiento necesita el número de un dispositivo</translation>
    </message>
    <message>
        <source>form error</source>
        <translation>error de formato</translation>
    </message>
    <message>
        <source>found on %1</source>
        <translation>encontrado en %1</translation>
    </message>
    <message>
        <source>free the shaft and see that no brake is on, then test again</source>
        <translation>libere el eje, compruebe que no haya ningún freno puesto y pruebe de nuevo</translation>
    </message>
    <message>
        <source>frequency response: %1</source>
        <translation>respuesta en frecuencia: %1</translation>
    </message>
    <message>
        <source>friction takes %1 duty of pushes of %2</source>
        <translation>la fricción toma ciclo %1 de empujes de %2</translation>
    </message>
    <message>
        <source>friction takes %1 of what P makes of a step, at most 60 %</source>
        <translation>la fricción toma %1 de lo que P hace de un escalón, como máximo 60 %</translation>
    </message>
    <message>
        <source>gave no sign after the stop</source>
        <translation>no dio señales tras la parada</translation>
    </message>
    <message>
        <source>gave no sign after the stop; its own watchdog switches it off</source>
        <translation>no dio señales tras la parada; lo apaga su propio watchdog</translation>
    </message>
    <message>
        <source>give %1</source>
        <translation>indique %1</translation>
    </message>
    <message>
        <source>keep what is tried, or name a notebook that can be written</source>
        <translation>conserve lo que se prueba o indique un cuaderno en el que se pueda escribir</translation>
    </message>
    <message>
        <source>give it a longer time</source>
        <translation>déle más tiempo</translation>
    </message>
    <message>
        <source>give a name that ends in .png, .svg or .pdf</source>
        <translation>indique un nombre que termine en .png, .svg o .pdf</translation>
    </message>
    <message>
        <source>give a recording, or --help for what else there is</source>
        <translation>indique una grabación, o --help para ver qué más hay</translation>
    </message>
    <message>
        <source>give another target</source>
        <translation>indique otro objetivo</translation>
    </message>
    <message>
        <source>give at least %1 s</source>
        <translation>indique al menos %1 s</translation>
    </message>
    <message>
        <source>give it a new one, or switch it off and on</source>
        <translation>dele uno nuevo o apáguelo y enciéndalo</translation>
    </message>
    <message>
        <source>give it a number first, or take the self-test out of the recipe</source>
        <translation>dele antes un número o quite la autoprueba de la receta</translation>
    </message>
    <message>
        <source>gpiodetect lists those there are</source>
        <translation>gpiodetect enumera los que hay</translation>
    </message>
    <message>
        <source>identify it anew</source>
        <translation>identifíquelo de nuevo</translation>
    </message>
    <message>
        <source>image %1 of %2 pages, unit runs %3, bootloader %4</source>
        <translation>imagen %1 de %2 páginas, el equipo ejecuta %3, bootloader %4</translation>
    </message>
    <message>
        <source>image %1 of %2 pages, unit without application, bootloader %3</source>
        <translation>imagen %1 de %2 páginas, equipo sin aplicación, bootloader %3</translation>
    </message>
    <message>
        <source>in bootloader %1, session kept</source>
        <translation>en bootloader %1, sesión conservada</translation>
    </message>
    <message>
        <source>in position mode a new counter would make the motor jump</source>
        <translation>en modo de posición un contador nuevo haría saltar el motor</translation>
    </message>
    <message>
        <source>install %1</source>
        <translation>instale %1</translation>
    </message>
    <message>
        <source>install it with</source>
        <translation>instálelo con</translation>
    </message>
    <message>
        <source>install its vendor&apos;s driver</source>
        <translation>instale el driver de su fabricante</translation>
    </message>
    <message>
        <source>install the package that has it and try again</source>
        <translation>instale el paquete que lo contiene e inténtelo de nuevo</translation>
    </message>
    <message>
        <source>installed are: %1</source>
        <translation>están instalados: %1</translation>
    </message>
    <message>
        <source>is a directory</source>
        <translation>es un directorio</translation>
    </message>
    <message>
        <source>is back</source>
        <translation>ha vuelto</translation>
    </message>
    <message>
        <source>is gone</source>
        <translation>ya no está</translation>
    </message>
    <message>
        <source>is longer than %1 bytes</source>
        <translation>tiene más de %1 bytes</translation>
    </message>
    <message>
        <source>is not a regular file</source>
        <translation>no es un archivo normal</translation>
    </message>
    <message>
        <source>is there</source>
        <translation>está presente</translation>
    </message>
    <message>
        <source>it begins with &quot;recipe&quot;: 1</source>
        <translation>empieza por &quot;recipe&quot;: 1</translation>
    </message>
    <message>
        <source>it begins with {</source>
        <translation>empieza por {</translation>
    </message>
    <message>
        <source>it came to rest %1 of the step away from its target</source>
        <translation>quedó en reposo a %1 del escalón de su destino</translation>
    </message>
    <message>
        <source>it cannot be tried</source>
        <translation>no se puede ensayar</translation>
    </message>
    <message>
        <source>it cannot be written (system error %1)</source>
        <translation>no se puede escribir (error del sistema %1)</translation>
    </message>
    <message>
        <source>it did not come back</source>
        <translation>no volvió</translation>
    </message>
    <message>
        <source>it did not settle</source>
        <translation>no se estableció</translation>
    </message>
    <message>
        <source>it has %1</source>
        <translation>tiene %1</translation>
    </message>
    <message>
        <source>it is a Vector BLF log</source>
        <translation>es un registro Vector BLF</translation>
    </message>
    <message>
        <source>it is a disk</source>
        <translation>es un disco</translation>
    </message>
    <message>
        <source>it is a folder</source>
        <translation>es una carpeta</translation>
    </message>
    <message>
        <source>it is a recording</source>
        <translation>es una grabación</translation>
    </message>
    <message>
        <source>it is not known how to stop this device from outside</source>
        <translation>no se sabe cómo parar este dispositivo desde fuera</translation>
    </message>
    <message>
        <source>it is not proven which codes it speaks, and a stop of others may start it</source>
        <translation>no está probado qué códigos usa, y una parada con otros puede arrancarlo</translation>
    </message>
    <message>
        <source>it is not proven which codes this drive speaks</source>
        <translation>no está probado qué códigos usa este accionamiento</translation>
    </message>
    <message>
        <source>it is not proven which codes this drive speaks, and the wrong ones start it at full power</source>
        <translation>no está probado qué códigos usa este accionamiento, y los erróneos lo arrancan a plena potencia</translation>
    </message>
    <message>
        <source>it may rest %1 short of its target, less does not move its integral</source>
        <translation>puede quedar %1 antes de su destino, menos no mueve su integral</translation>
    </message>
    <message>
        <source>it may rest %1 short of its target, less does not move its motor</source>
        <translation>puede quedar %1 antes de su destino, menos no mueve su motor</translation>
    </message>
    <message>
        <source>it overshot by %1, predicted were %2</source>
        <translation>tuvo un sobreimpulso de %1, lo previsto era %2</translation>
    </message>
    <message>
        <source>it swung itself up with P %1 and D %2</source>
        <translation>entró en oscilación creciente con P %1 y D %2</translation>
    </message>
    <message>
        <source>it took %1 to settle, predicted were %2</source>
        <translation>tardó %1 en establecerse, lo previsto era %2</translation>
    </message>
    <message>
        <source>it took longer than 1.5 × %1 s</source>
        <translation>tardó más de 1,5 × %1 s</translation>
    </message>
    <message>
        <source>it was put aside as %1, and what it kept of the device is unknown again</source>
        <translation>se apartó como %1, y lo que conservaba del dispositivo vuelve a ser desconocido</translation>
    </message>
    <message>
        <source>it was stopped</source>
        <translation>se paró</translation>
    </message>
    <message>
        <source>it would stop %1 counts from the start, %2 are allowed</source>
        <translation>se pararía a %1 cuentas del inicio, se permiten %2</translation>
    </message>
    <message>
        <source>its P or its position is not known, so whether this step overflows its loop is not either</source>
        <translation>no se conocen su P o su posición, así que tampoco si este escalón desborda su lazo</translation>
    </message>
    <message>
        <source>its address is not a number</source>
        <translation>su dirección no es un número</translation>
    </message>
    <message>
        <source>its dialect is not known</source>
        <translation>no se conoce su dialecto</translation>
    </message>
    <message>
        <source>its dialect is not known yet</source>
        <translation>aún no se conoce su dialecto</translation>
    </message>
    <message>
        <source>its dialect is not known, so no move can be sent</source>
        <translation>no se conoce su dialecto, así que no se puede enviar ningún movimiento</translation>
    </message>
    <message>
        <source>its error level is 1, which makes every reading fail: set error.level to 0</source>
        <translation>su nivel de error es 1, lo que hace fallar toda lectura: ponga error.level a 0</translation>
    </message>
    <message>
        <source>its motor is turning or driven already</source>
        <translation>su motor ya gira o ya se acciona</translation>
    </message>
    <message>
        <source>its position is not known yet</source>
        <translation>aún no se conoce su posición</translation>
    </message>
    <message>
        <source>its profile is not known, so a move that passes its target could not be told</source>
        <translation>no se conoce su perfil, así que no se detectaría un movimiento que rebase su destino</translation>
    </message>
    <message>
        <source>its reader has gone</source>
        <translation>su lector ya no está</translation>
    </message>
    <message>
        <source>known are %1</source>
        <translation>se conocen %1</translation>
    </message>
    <message>
        <source>leave it out</source>
        <translation>omítalo</translation>
    </message>
    <message>
        <source>leave out --target</source>
        <translation>omita --target</translation>
    </message>
    <message>
        <source>leave out erasing them</source>
        <translation>omita su borrado</translation>
    </message>
    <message>
        <source>leave out interface=</source>
        <translation>omita interface=</translation>
    </message>
    <message>
        <source>leave the other way in out</source>
        <translation>omita el otro acceso</translation>
    </message>
    <message>
        <source>leave the target out</source>
        <translation>omita el destino</translation>
    </message>
    <message>
        <source>legal is %1</source>
        <translation>se admite %1</translation>
    </message>
    <message>
        <source>legal is 0.01 … 1000, or max</source>
        <translation>se admite 0.01 … 1000, o max</translation>
    </message>
    <message>
        <source>legal is 1 … 500</source>
        <translation>se admite 1 … 500</translation>
    </message>
    <message>
        <source>limit %1</source>
        <translation>límite %1</translation>
    </message>
    <message>
        <source>limits %1 … %2</source>
        <translation>límites %1 … %2</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>línea %1</translation>
    </message>
    <message>
        <source>line %1 is neither a line of candump -L nor the beginning of a Vector ASC log</source>
        <translation>la línea %1 no es ni una línea de candump -L ni el principio de un registro Vector ASC</translation>
    </message>
    <message>
        <source>line %1 is not a line of a Vector ASC log</source>
        <translation>la línea %1 no es una línea de un registro Vector ASC</translation>
    </message>
    <message>
        <source>line %1 is not a line of candump -L</source>
        <translation>la línea %1 no es una línea de candump -L</translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>línea %1: %2</translation>
    </message>
    <message>
        <source>link option %1=%2 is out of range</source>
        <translation>la opción de enlace %1=%2 está fuera de rango</translation>
    </message>
    <message>
        <source>link option &apos;%1&apos; is not KEY=VALUE</source>
        <translation>la opción de enlace «%1» no es KEY=VALUE</translation>
    </message>
    <message>
        <source>link option bitrate=%1 is out of range</source>
        <translation>la opción de enlace bitrate=%1 está fuera de rango</translation>
    </message>
    <message>
        <source>listen-only: nothing can be sent</source>
        <translation>solo escucha: no se puede enviar nada</translation>
    </message>
    <message>
        <source>load it</source>
        <translation>cargarlo</translation>
    </message>
    <message>
        <source>look at brushes, plugs and leads, then test again</source>
        <translation>revise escobillas, conectores y cables, y pruebe de nuevo</translation>
    </message>
    <message>
        <source>look at it again</source>
        <translation>vuelva a mirarlo</translation>
    </message>
    <message>
        <source>look at the cable and test again</source>
        <translation>revise el cable y pruebe de nuevo</translation>
    </message>
    <message>
        <source>look at the plug and the polarity of encoder and motor, then test again</source>
        <translation>revise el conector y la polaridad de encoder y motor, y pruebe de nuevo</translation>
    </message>
    <message>
        <source>look at the wiring of the input</source>
        <translation>compruebe el cableado de la entrada</translation>
    </message>
    <message>
        <source>look for units again</source>
        <translation>busque equipos de nuevo</translation>
    </message>
    <message>
        <source>look whether something brakes or limits the motor</source>
        <translation>mire si algo frena o limita el motor</translation>
    </message>
    <message>
        <source>looking at the status bit</source>
        <translation>mirando el bit de estado</translation>
    </message>
    <message>
        <source>looking for position D</source>
        <translation>buscando posición D</translation>
    </message>
    <message>
        <source>looking for position I</source>
        <translation>buscando posición I</translation>
    </message>
    <message>
        <source>looking for position P</source>
        <translation>buscando posición P</translation>
    </message>
    <message>
        <source>looking for velocity I</source>
        <translation>buscando velocidad I</translation>
    </message>
    <message>
        <source>looking for velocity P</source>
        <translation>buscando velocidad P</translation>
    </message>
    <message>
        <source>lower the gains or the steps</source>
        <translation>reduzca las ganancias o los escalones</translation>
    </message>
    <message>
        <source>made way for an order</source>
        <translation>cedió el paso a una orden</translation>
    </message>
    <message>
        <source>make room in %1</source>
        <translation>libere espacio en %1</translation>
    </message>
    <message>
        <source>make room, or choose another place</source>
        <translation>libere espacio o elija otro lugar</translation>
    </message>
    <message>
        <source>more bytes than the device announced</source>
        <translation>más bytes de los que anunció el dispositivo</translation>
    </message>
    <message>
        <source>more columns than the first line has</source>
        <translation>más columnas que la primera línea</translation>
    </message>
    <message>
        <source>more than 1000 channels</source>
        <translation>más de 1000 canales</translation>
    </message>
    <message>
        <source>move it away</source>
        <translation>muévalo a otro sitio</translation>
    </message>
    <message>
        <source>name a file</source>
        <translation>indique un archivo</translation>
    </message>
    <message>
        <source>name a firmware in the recipe</source>
        <translation>indique un firmware en la receta</translation>
    </message>
    <message>
        <source>name a recording</source>
        <translation>indique una grabación</translation>
    </message>
    <message>
        <source>name another folder</source>
        <translation>indique otra carpeta</translation>
    </message>
    <message>
        <source>name it by its number; &apos;motorbenchctl snapshots&apos; lists them</source>
        <translation>indíquela por su número; «motorbenchctl snapshots» las enumera</translation>
    </message>
    <message>
        <source>name its serial port, for example --via serial:/dev/ttyUSB0</source>
        <translation>indique su puerto serie, por ejemplo --via serial:/dev/ttyUSB0</translation>
    </message>
    <message>
        <source>name one such as /dev/ttyUSB0</source>
        <translation>indique uno, como /dev/ttyUSB0</translation>
    </message>
    <message>
        <source>name one, such as sim:can</source>
        <translation>indique uno, como sim:can</translation>
    </message>
    <message>
        <source>name one: %1 or %2</source>
        <translation>indique uno: %1 o %2</translation>
    </message>
    <message>
        <source>no %1 answers as number %2 on %3</source>
        <translation>ningún %1 responde con el número %2 en %3</translation>
    </message>
    <message>
        <source>no %1 sends as number %2 in %3</source>
        <translation>ningún %1 envía con el número %2 en %3</translation>
    </message>
    <message>
        <source>no CAN frame: its identifier or size is out of range</source>
        <translation>no es una trama CAN: su identificador o tamaño está fuera de rango</translation>
    </message>
    <message>
        <source>no D was found with which a small P neither swings nor creeps</source>
        <translation>no se halló ningún D con el que un P pequeño no oscile ni se arrastre</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>sin respuesta</translation>
    </message>
    <message>
        <source>no application runs in this unit</source>
        <translation>en este equipo no se ejecuta ninguna aplicación</translation>
    </message>
    <message>
        <source>no bootloader answers at %1 bit/s</source>
        <translation>ningún bootloader responde a %1 bit/s</translation>
    </message>
    <message>
        <source>no data in page 0 (0x00000-0x00FFF), the file is not a whole application</source>
        <translation>sin datos en la página 0 (0x00000-0x00FFF), el archivo no es una aplicación completa</translation>
    </message>
    <message>
        <source>no data in page 30 (0x1E000-0x1EFFF), where the version is</source>
        <translation>sin datos en la página 30 (0x1E000-0x1EFFF), donde está la versión</translation>
    </message>
    <message>
        <source>no experiment: %1</source>
        <translation>sin experimento: %1</translation>
    </message>
    <message>
        <source>no gain of the position loop turns the motor</source>
        <translation>ninguna ganancia del lazo de posición gira el motor</translation>
    </message>
    <message>
        <source>no gain of the velocity loop turns the motor</source>
        <translation>ninguna ganancia del lazo de velocidad gira el motor</translation>
    </message>
    <message>
        <source>no guardian came within two seconds</source>
        <translation>no llegó ningún vigilante en dos segundos</translation>
    </message>
    <message>
        <source>no guardian can be started: %1</source>
        <translation>no se puede iniciar ningún vigilante: %1</translation>
    </message>
    <message>
        <source>no history is kept here</source>
        <translation>aquí no se lleva historial</translation>
    </message>
    <message>
        <source>no instruction at the entry point 0x00400</source>
        <translation>no hay instrucción en el punto de entrada 0x00400</translation>
    </message>
    <message>
        <source>no number: server silent</source>
        <translation>sin número: el servidor no responde</translation>
    </message>
    <message>
        <source>no object at the top</source>
        <translation>no hay un objeto en el nivel superior</translation>
    </message>
    <message>
        <source>no permission to open CAN sockets here</source>
        <translation>sin permiso para abrir aquí sockets CAN</translation>
    </message>
    <message>
        <source>no permission to read it</source>
        <translation>sin permiso para leerlo</translation>
    </message>
    <message>
        <source>no permission to use %1</source>
        <translation>sin permiso para usar %1</translation>
    </message>
    <message>
        <source>no permission to write there</source>
        <translation>sin permiso para escribir ahí</translation>
    </message>
    <message>
        <source>no pseudo terminal can be had: %1</source>
        <translation>no se puede obtener un pseudoterminal: %1</translation>
    </message>
    <message>
        <source>no push met the current limit</source>
        <translation>ningún empuje alcanzó el límite de corriente</translation>
    </message>
    <message>
        <source>no ready line is wired</source>
        <translation>no hay línea de listo cableada</translation>
    </message>
    <message>
        <source>no reset line is wired</source>
        <translation>no hay línea de reset cableada</translation>
    </message>
    <message>
        <source>no sample for %1</source>
        <translation>ninguna muestra durante %1</translation>
    </message>
    <message>
        <source>no snapshot of what was found: %1</source>
        <translation>sin instantánea de lo encontrado: %1</translation>
    </message>
    <message>
        <source>no snapshot of what was there: %1</source>
        <translation>sin instantánea de lo que había: %1</translation>
    </message>
    <message>
        <source>no snapshot: %1</source>
        <translation>sin instantánea: %1</translation>
    </message>
    <message>
        <source>no snapshots are kept here</source>
        <translation>aquí no se guardan instantáneas</translation>
    </message>
    <message>
        <source>no status within 2 s</source>
        <translation>sin estado en 2 s</translation>
    </message>
    <message>
        <source>no step met the end of the output</source>
        <translation>ningún escalón alcanzó el tope de la salida</translation>
    </message>
    <message>
        <source>no such file</source>
        <translation>no existe el archivo</translation>
    </message>
    <message>
        <source>no version at 0x1EFFC</source>
        <translation>no hay versión en 0x1EFFC</translation>
    </message>
    <message>
        <source>nobody acknowledged</source>
        <translation>nadie confirmó la recepción</translation>
    </message>
    <message>
        <source>nobody acknowledges what %1 sends</source>
        <translation>nadie confirma lo que envía %1</translation>
    </message>
    <message>
        <source>nobody reads from this pipe</source>
        <translation>nadie lee de esta tubería</translation>
    </message>
    <message>
        <source>nobody renewed the motion lease</source>
        <translation>nadie renovó el permiso de movimiento</translation>
    </message>
    <message>
        <source>nobody serves %1</source>
        <translation>nadie atiende %1</translation>
    </message>
    <message>
        <source>nobody watches over this self-test, and it moves the motor</source>
        <translation>nadie supervisa esta autoprueba, y mueve el motor</translation>
    </message>
    <message>
        <source>node %1 does not answer</source>
        <translation>el nodo %1 no responde</translation>
    </message>
    <message>
        <source>node id %1 is used by another node of this line</source>
        <translation>el id de nodo %1 lo usa otro nodo de esta línea</translation>
    </message>
    <message>
        <source>not a parameter file: %1</source>
        <translation>no es un archivo de parámetros: %1</translation>
    </message>
    <message>
        <source>not a parameter file: it has no &quot;parameters&quot;</source>
        <translation>no es un archivo de parámetros: no tiene &quot;parameters&quot;</translation>
    </message>
    <message>
        <source>not sent: %1 for %2</source>
        <translation>no enviado: %1 para %2</translation>
    </message>
    <message>
        <source>not sent: %1 outside the controller&apos;s flash</source>
        <translation>no enviado: %1 fuera de la flash del controlador</translation>
    </message>
    <message>
        <source>not sent: %1 where a 24-bit instruction has none, the file may be for another processor</source>
        <translation>no enviado: %1 donde una instrucción de 24 bits no tiene ninguno; el archivo puede ser para otro procesador</translation>
    </message>
    <message>
        <source>nothing could put the gains back after a crash</source>
        <translation>nada podría restituir las ganancias tras un fallo del programa</translation>
    </message>
    <message>
        <source>nothing has been recorded yet</source>
        <translation>aún no se ha grabado nada</translation>
    </message>
    <message>
        <source>nothing to send</source>
        <translation>nada que enviar</translation>
    </message>
    <message>
        <source>nothing was measured</source>
        <translation>no se midió nada</translation>
    </message>
    <message>
        <source>nothing was saved</source>
        <translation>no se guardó nada</translation>
    </message>
    <message>
        <source>nothing was written</source>
        <translation>no se escribió nada</translation>
    </message>
    <message>
        <source>nothing was written; the image fits, %1 pages</source>
        <translation>no se escribió nada; la imagen es adecuada, %1 páginas</translation>
    </message>
    <message>
        <source>now the calm ones</source>
        <translation>ahora las suaves</translation>
    </message>
    <message>
        <source>number %1 is used by another unit</source>
        <translation>el número %1 lo usa otro equipo</translation>
    </message>
    <message>
        <source>number %1 still keeps a move that was stopped before it began, and would begin it too</source>
        <translation>el número %1 aún retiene un movimiento que se detuvo antes de empezar, y también lo iniciaría</translation>
    </message>
    <message>
        <source>one more would make the drive load something else. Erase its settings pages with a firmware update (erase settings), then save again</source>
        <translation>uno más haría que el accionamiento cargara otra cosa. Borre sus páginas de ajustes con una actualización de firmware (borrar ajustes) y guarde de nuevo</translation>
    </message>
    <message>
        <source>one update a bus: %1 is being written; nothing was sent</source>
        <translation>una actualización por bus: se está escribiendo %1; no se envió nada</translation>
    </message>
    <message>
        <source>only disturbed frames arrive on %1, the bus has another bit rate</source>
        <translation>a %1 solo llegan tramas alteradas; el bus tiene otra velocidad en bits</translation>
    </message>
    <message>
        <source>only disturbed frames arrive on %1, the bus has another bit rate than %2</source>
        <translation>a %1 solo llegan tramas alteradas; el bus tiene otra velocidad en bits que %2</translation>
    </message>
    <message>
        <source>only its power stops it</source>
        <translation>solo lo para cortar la alimentación</translation>
    </message>
    <message>
        <source>only those are recorded</source>
        <translation>solo se graban esos</translation>
    </message>
    <message>
        <source>open it again</source>
        <translation>ábralo de nuevo</translation>
    </message>
    <message>
        <source>open that terminal as serial:%1</source>
        <translation>abra ese terminal como serial:%1</translation>
    </message>
    <message>
        <source>open the link that it was made on</source>
        <translation>abra el enlace en el que se hizo</translation>
    </message>
    <message>
        <source>openocd is not installed</source>
        <translation>openocd no está instalado</translation>
    </message>
    <message>
        <source>option &apos;%1&apos; is not KEY=VALUE</source>
        <translation>la opción «%1» no es KEY=VALUE</translation>
    </message>
    <message>
        <source>page %1 accepted with CRC variant %2</source>
        <translation>página %1 aceptada con la variante de CRC %2</translation>
    </message>
    <message>
        <source>page %1 cannot be written: its flash failed the device&apos;s own check %2 times</source>
        <translation>la página %1 no se puede escribir: su flash no superó la comprobación del dispositivo %2 veces</translation>
    </message>
    <message>
        <source>page %1 was not accepted in %2 tries</source>
        <translation>la página %1 no se aceptó en %2 intentos</translation>
    </message>
    <message>
        <source>page %1 was said to be written before its bytes can have arrived</source>
        <translation>la página %1 se dio por escrita antes de que pudieran llegar sus bytes</translation>
    </message>
    <message>
        <source>page %1: %2, sent again</source>
        <translation>página %1: %2, reenviada</translation>
    </message>
    <message>
        <source>page 0: its status was lost, but the version is there; it is not written again</source>
        <translation>página 0: se perdió su estado, pero la versión está ahí; no se escribe de nuevo</translation>
    </message>
    <message>
        <source>pages 31-34 (configuration and descriptors)</source>
        <translation>páginas 31-34 (configuración y descriptores)</translation>
    </message>
    <message>
        <source>pages 35-42 (bootloader and flash configuration)</source>
        <translation>páginas 35-42 (bootloader y configuración de la flash)</translation>
    </message>
    <message>
        <source>parameters that were changed last may be lost: %1</source>
        <translation>los últimos parámetros cambiados pueden haberse perdido: %1</translation>
    </message>
    <message>
        <source>pause=%1: legal are 0 to 1000 milliseconds</source>
        <translation>pause=%1: se admiten de 0 a 1000 milisegundos</translation>
    </message>
    <message>
        <source>plug in an adapter</source>
        <translation>conecte un adaptador</translation>
    </message>
    <message>
        <source>plug in an adapter at any time; it is opened by itself once it is up</source>
        <translation>conecte un adaptador en cualquier momento; se abre solo en cuanto esté activo</translation>
    </message>
    <message>
        <source>plug in the adapter, or name another port</source>
        <translation>conecte el adaptador o indique otro puerto</translation>
    </message>
    <message>
        <source>plug it in again</source>
        <translation>conéctelo de nuevo</translation>
    </message>
    <message>
        <source>plug one in</source>
        <translation>conecte uno</translation>
    </message>
    <message>
        <source>plug the adapter in again; the link is opened by itself as soon as it is up</source>
        <translation>vuelva a conectar el adaptador; el enlace se abre solo en cuanto esté activo</translation>
    </message>
    <message>
        <source>polarity 0 is active high: the board follows the maker&apos;s library</source>
        <translation>la polaridad 0 es activa a nivel alto: la placa sigue la biblioteca del fabricante</translation>
    </message>
    <message>
        <source>polarity 0 is active low: the board follows the data sheet</source>
        <translation>la polaridad 0 es activa a nivel bajo: la placa sigue la hoja de datos</translation>
    </message>
    <message>
        <source>polarity bit %1: the input is active</source>
        <translation>bit de polaridad %1: la entrada está activa</translation>
    </message>
    <message>
        <source>polarity bit %1: the input is not active</source>
        <translation>bit de polaridad %1: la entrada no está activa</translation>
    </message>
    <message>
        <source>position D has no effect that could be measured; its scale stays unknown</source>
        <translation>posición D no tiene un efecto medible; su escala sigue siendo desconocida</translation>
    </message>
    <message>
        <source>position has 32 bits</source>
        <translation>la posición tiene 32 bits</translation>
    </message>
    <message>
        <source>power %1: %2 and %3 counts/s</source>
        <translation>potencia %1: %2 y %3 counts/s</translation>
    </message>
    <message>
        <source>protocol error</source>
        <translation>error de protocolo</translation>
    </message>
    <message>
        <source>proving: a step of %1 A</source>
        <translation>verificando: un escalón de %1 A</translation>
    </message>
    <message>
        <source>proving: a step of %1 counts</source>
        <translation>verificando: un escalón de %1 cuentas</translation>
    </message>
    <message>
        <source>proving: a step of %1 counts/s</source>
        <translation>verificando: un escalón de %1 counts/s</translation>
    </message>
    <message>
        <source>pty links have the option baud=BITS_PER_SECOND, not &apos;%1=%2&apos;</source>
        <translation>los enlaces pty tienen la opción baud=BITS_PER_SECOND, no «%1=%2»</translation>
    </message>
    <message>
        <source>pty: is where &apos;simulate&apos; puts its devices</source>
        <translation>pty: es donde «simulate» pone sus dispositivos</translation>
    </message>
    <message>
        <source>push harder or longer</source>
        <translation>empuje más fuerte o más tiempo</translation>
    </message>
    <message>
        <source>push longer, or ask for faster samples</source>
        <translation>empuje más tiempo o pida muestras más rápidas</translation>
    </message>
    <message>
        <source>push with two sizes</source>
        <translation>empuje con dos tamaños</translation>
    </message>
    <message>
        <source>pushes of one size do not tell friction from gain</source>
        <translation>empujes de un solo tamaño no distinguen fricción y ganancia</translation>
    </message>
    <message>
        <source>pushing with %1 duty for %2 s</source>
        <translation>empujando con ciclo %1 durante %2 s</translation>
    </message>
    <message>
        <source>pushing with %1 duty for %2 s, %3 times</source>
        <translation>empujando con ciclo %1 durante %2 s, %3 veces</translation>
    </message>
    <message>
        <source>putting the settings back</source>
        <translation>restituyendo los ajustes</translation>
    </message>
    <message>
        <source>qtcan links have the option bitrate=BITS_PER_SECOND, not &apos;%1=%2&apos;</source>
        <translation>los enlaces qtcan tienen la opción bitrate=BITS_PER_SECOND, no «%1=%2»</translation>
    </message>
    <message>
        <source>read gain.p</source>
        <translation>lea gain.p</translation>
    </message>
    <message>
        <source>read it again</source>
        <translation>léalo de nuevo</translation>
    </message>
    <message>
        <source>read it first</source>
        <translation>léalo primero</translation>
    </message>
    <message>
        <source>read profile.velocity and profile.acceleration</source>
        <translation>lea profile.velocity y profile.acceleration</translation>
    </message>
    <message>
        <source>recessive bit not sent</source>
        <translation>bit recesivo no enviado</translation>
    </message>
    <message>
        <source>reconnect</source>
        <translation>reconectar</translation>
    </message>
    <message>
        <source>record again</source>
        <translation>grabe de nuevo</translation>
    </message>
    <message>
        <source>record type %1 is unknown</source>
        <translation>el tipo de registro %1 es desconocido</translation>
    </message>
    <message>
        <source>refused: %1</source>
        <translation>rechazado: %1</translation>
    </message>
    <message>
        <source>remove it</source>
        <translation>quítelo</translation>
    </message>
    <message>
        <source>remove it, or make it readable</source>
        <translation>quítelo o hágalo legible</translation>
    </message>
    <message>
        <source>remove the cause, then test again</source>
        <translation>elimine la causa y pruebe de nuevo</translation>
    </message>
    <message>
        <source>replay links have no option &apos;%1&apos;</source>
        <translation>los enlaces replay no tienen la opción «%1»</translation>
    </message>
    <message>
        <source>residual %1 of what counts and clocks explain, at most 3</source>
        <translation>residuo %1 de lo que explican cuentas y relojes, como máximo 3</translation>
    </message>
    <message>
        <source>restarted, the application answers</source>
        <translation>reiniciado, la aplicación responde</translation>
    </message>
    <message>
        <source>run avrdude by hand to see all it says</source>
        <translation>ejecute avrdude a mano para ver todo lo que dice</translation>
    </message>
    <message>
        <source>run it by hand to see all it says</source>
        <translation>ejecútelo a mano para ver todo lo que dice</translation>
    </message>
    <message>
        <source>run it by hand with -c %1</source>
        <translation>ejecútelo a mano con -c %1</translation>
    </message>
    <message>
        <source>run it by hand with interface %1</source>
        <translation>ejecútelo a mano con la interfaz %1</translation>
    </message>
    <message>
        <source>sample point %1 %</source>
        <translation>punto de muestreo %1 %</translation>
    </message>
    <message>
        <source>save it as ASC and take that</source>
        <translation>guárdelo como ASC y use ese</translation>
    </message>
    <message>
        <source>scan again, or choose its dialect by hand</source>
        <translation>busque de nuevo o elija su dialecto a mano</translation>
    </message>
    <message>
        <source>see that motor and load are those of the recipe, then test again</source>
        <translation>compruebe que motor y carga sean los de la receta y pruebe de nuevo</translation>
    </message>
    <message>
        <source>see that nothing is loose and that steps look alike</source>
        <translation>compruebe que nada esté suelto y que los escalones se parezcan</translation>
    </message>
    <message>
        <source>see that nothing is loose, and write gains once with which it comes to rest</source>
        <translation>compruebe que nada esté suelto y escriba una vez ganancias con las que quede en reposo</translation>
    </message>
    <message>
        <source>see that nothing is loose; a stronger load than it was built for cannot be tuned</source>
        <translation>compruebe que nada esté suelto; una carga mayor que la de diseño no se puede ajustar</translation>
    </message>
    <message>
        <source>see that the motor is connected</source>
        <translation>compruebe que el motor esté conectado</translation>
    </message>
    <message>
        <source>see that the server runs; entries wait here until it does</source>
        <translation>compruebe que el servidor funcione; las entradas esperan aquí hasta entonces</translation>
    </message>
    <message>
        <source>see that this is the motor and the encoder of the recipe, then test again</source>
        <translation>compruebe que sean el motor y el encoder de la receta y pruebe de nuevo</translation>
    </message>
    <message>
        <source>see whether a load always pulls one way</source>
        <translation>mire si una carga tira siempre hacia un lado</translation>
    </message>
    <message>
        <source>see whether brushes and plugs make contact</source>
        <translation>mire si escobillas y conectores hacen contacto</translation>
    </message>
    <message>
        <source>select a longer stretch</source>
        <translation>seleccione un tramo más largo</translation>
    </message>
    <message>
        <source>sending the firmware</source>
        <translation>enviando el firmware</translation>
    </message>
    <message>
        <source>serial number %1</source>
        <translation>número de serie %1</translation>
    </message>
    <message>
        <source>service</source>
        <translation>servicio</translation>
    </message>
    <message>
        <source>several units answer as number %1</source>
        <translation>varios equipos responden con el número %1</translation>
    </message>
    <message>
        <source>several units answer under this number in the recording</source>
        <translation>varios equipos responden con este número en la grabación</translation>
    </message>
    <message>
        <source>several units have a snapshot &apos;%1&apos;</source>
        <translation>varios equipos tienen una instantánea «%1»</translation>
    </message>
    <message>
        <source>sim: stands for several links</source>
        <translation>sim: equivale a varios enlaces</translation>
    </message>
    <message>
        <source>simulated links belong to a bench</source>
        <translation>los enlaces simulados pertenecen a un banco</translation>
    </message>
    <message>
        <source>sine %1 of %2, %3 Hz: %4</source>
        <translation>seno %1 de %2, %3 Hz: %4</translation>
    </message>
    <message>
        <source>snapshot %1, %2: %3 values</source>
        <translation>instantánea %1, %2: %3 valores</translation>
    </message>
    <message>
        <source>socketcan links have no option &apos;%1&apos;</source>
        <translation>los enlaces socketcan no tienen la opción «%1»</translation>
    </message>
    <message>
        <source>somebody may have started it again, so the position was not reset</source>
        <translation>alguien puede haberlo arrancado de nuevo, así que la posición no se puso a cero</translation>
    </message>
    <message>
        <source>something follows the end-of-file record</source>
        <translation>hay algo después del registro de fin de archivo</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>velocidad</translation>
    </message>
    <message>
        <source>speed %1 counts/s is above 1.2 × %2 counts/s</source>
        <translation>la velocidad %1 counts/s supera 1,2 × %2 counts/s</translation>
    </message>
    <message>
        <source>speed is 10000 to 10000000 Hz, not &apos;%1&apos;</source>
        <translation>speed es de 10000 a 10000000 Hz, no «%1»</translation>
    </message>
    <message>
        <source>speed, ready and reset are known</source>
        <translation>se conocen speed, ready y reset</translation>
    </message>
    <message>
        <source>speed=%1 is no speed</source>
        <translation>speed=%1 no es una velocidad</translation>
    </message>
    <message>
        <source>spidev links have no option &apos;%1&apos;</source>
        <translation>los enlaces spidev no tienen la opción «%1»</translation>
    </message>
    <message>
        <source>stalled, or the encoder is dead: less than 3 counts in %1</source>
        <translation>bloqueado o el encoder no funciona: menos de 3 cuentas en %1</translation>
    </message>
    <message>
        <source>start it again</source>
        <translation>inícielo de nuevo</translation>
    </message>
    <message>
        <source>start the reader first</source>
        <translation>inicie antes el lector</translation>
    </message>
    <message>
        <source>start the simulator again</source>
        <translation>inicie de nuevo el simulador</translation>
    </message>
    <message>
        <source>start the simulator first</source>
        <translation>inicie antes el simulador</translation>
    </message>
    <message>
        <source>steps with one pair of gains only do not tell what each of them does</source>
        <translation>escalones con un solo par de ganancias no indican qué hace cada una</translation>
    </message>
    <message>
        <source>stop it before its gains are put back</source>
        <translation>párelo antes de restituir sus ganancias</translation>
    </message>
    <message>
        <source>stop it first</source>
        <translation>párelo primero</translation>
    </message>
    <message>
        <source>stop it there first</source>
        <translation>párelo allí primero</translation>
    </message>
    <message>
        <source>stop it, then put the values back</source>
        <translation>párelo y restituya los valores</translation>
    </message>
    <message>
        <source>stop the motor before an experiment begins</source>
        <translation>pare el motor antes de que empiece un experimento</translation>
    </message>
    <message>
        <source>stop the motor before its dialect is changed</source>
        <translation>pare el motor antes de cambiar su dialecto</translation>
    </message>
    <message>
        <source>stop the motor first</source>
        <translation>pare antes el motor</translation>
    </message>
    <message>
        <source>stop the motor first: the drive stands still while it writes its flash</source>
        <translation>pare antes el motor: el accionamiento queda inmóvil mientras escribe su flash</translation>
    </message>
    <message>
        <source>stop the motors before settings are written again</source>
        <translation>pare los motores antes de reescribir los ajustes</translation>
    </message>
    <message>
        <source>stop the motors first</source>
        <translation>pare antes los motores</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>parado</translation>
    </message>
    <message>
        <source>stopped while it waited for a number</source>
        <translation>parado mientras esperaba un número</translation>
    </message>
    <message>
        <source>stopped: %1</source>
        <translation>parado: %1</translation>
    </message>
    <message>
        <source>stopped: the window did not respond in time</source>
        <translation>parado: la ventana no respondió a tiempo</translation>
    </message>
    <message>
        <source>stored, not verifiable</source>
        <translation>guardado, no verificable</translation>
    </message>
    <message>
        <source>stuff error</source>
        <translation>error de relleno (stuff)</translation>
    </message>
    <message>
        <source>such a line reads %1</source>
        <translation>una línea así es %1</translation>
    </message>
    <message>
        <source>such as %1</source>
        <translation>por ejemplo %1</translation>
    </message>
    <message>
        <source>supply %1 V is outside %2 … %3 V</source>
        <translation>la alimentación %1 V está fuera de %2 … %3 V</translation>
    </message>
    <message>
        <source>switch it off and on</source>
        <translation>apáguelo y enciéndalo</translation>
    </message>
    <message>
        <source>switch the devices on, check the cable and that two 120 Ω resistors end the bus, and that every device has the bit rate %1</source>
        <translation>encienda los dispositivos, compruebe el cable y que dos resistencias de 120 Ω terminen el bus, y que cada dispositivo tenga la velocidad %1</translation>
    </message>
    <message>
        <source>switch the devices on, check the cable and that two 120 Ω resistors end the bus, and that every device has the bit rate of this interface</source>
        <translation>encienda los dispositivos, compruebe el cable y que dos resistencias de 120 Ω terminen el bus, y que cada dispositivo tenga la velocidad en bits de esta interfaz</translation>
    </message>
    <message>
        <source>take a finer encoder or a calmer loop</source>
        <translation>use un encoder más fino o un lazo más suave</translation>
    </message>
    <message>
        <source>take a smaller step or widen it</source>
        <translation>use un escalón menor o amplíelo</translation>
    </message>
    <message>
        <source>take one of them</source>
        <translation>use uno de ellos</translation>
    </message>
    <message>
        <source>take the jumper out and reset it</source>
        <translation>quite el puente y reiníciela</translation>
    </message>
    <message>
        <source>take the jumper out; the board is asked for its version</source>
        <translation>quite el puente; se pregunta la versión a la placa</translation>
    </message>
    <message>
        <source>take the other one off, or give one of them another number</source>
        <translation>quite el otro o dé otro número a uno de ellos</translation>
    </message>
    <message>
        <source>temperature %1 °C is within 5 K of %2 °C</source>
        <translation>la temperatura %1 °C está a menos de 5 K de %2 °C</translation>
    </message>
    <message>
        <source>test again when it is safe</source>
        <translation>pruebe de nuevo cuando sea seguro</translation>
    </message>
    <message>
        <source>the %1 gains did not: %2</source>
        <translation>las ganancias «%1» no lo hicieron: %2</translation>
    </message>
    <message>
        <source>the %1 loop was saved %2 times; after %3 its settings pages must be erased</source>
        <translation>el lazo de %1 se guardó %2 veces; tras %3 deben borrarse sus páginas de ajustes</translation>
    </message>
    <message>
        <source>the acknowledge delimiter</source>
        <translation>el delimitador de confirmación</translation>
    </message>
    <message>
        <source>the acknowledge slot</source>
        <translation>la ranura de confirmación</translation>
    </message>
    <message>
        <source>the answer to the reset was lost; found again by enumeration</source>
        <translation>la respuesta al reinicio se perdió; se encontró de nuevo por enumeración</translation>
    </message>
    <message>
        <source>the axis has a power limit of %1 %, which is kept</source>
        <translation>el eje tiene un límite de potencia de %1 %, que se respeta</translation>
    </message>
    <message>
        <source>the base of the numbers is %1, not hex or dec</source>
        <translation>la base de los números es %1, no hex ni dec</translation>
    </message>
    <message>
        <source>the board answered with an error that its documents do not name</source>
        <translation>la placa respondió con un error que sus documentos no nombran</translation>
    </message>
    <message>
        <source>the board did not answer</source>
        <translation>la placa no respondió</translation>
    </message>
    <message>
        <source>the board did not tell its status</source>
        <translation>la placa no indicó su estado</translation>
    </message>
    <message>
        <source>the board does not know this command</source>
        <translation>la placa no conoce esta orden</translation>
    </message>
    <message>
        <source>the board does not tell its position</source>
        <translation>la placa no indica su posición</translation>
    </message>
    <message>
        <source>the board found the packet malformed</source>
        <translation>la placa consideró el paquete mal formado</translation>
    </message>
    <message>
        <source>the board has axes 1 to 4</source>
        <translation>la placa tiene los ejes 1 a 4</translation>
    </message>
    <message>
        <source>the board has no number: chip select tells boards apart</source>
        <translation>la placa no tiene número: chip select distingue las placas</translation>
    </message>
    <message>
        <source>the board has no such mode</source>
        <translation>la placa no tiene ese modo</translation>
    </message>
    <message>
        <source>the board has one set of gains per axis</source>
        <translation>la placa tiene un juego de ganancias por eje</translation>
    </message>
    <message>
        <source>the board is updated over its UART</source>
        <translation>la placa se actualiza por su UART</translation>
    </message>
    <message>
        <source>the board keeps nothing without power</source>
        <translation>la placa no conserva nada sin alimentación</translation>
    </message>
    <message>
        <source>the board may want velocity targets times 4096: choose that setting, and try again</source>
        <translation>la placa puede esperar consignas de velocidad por 4096: elija ese ajuste e inténtelo de nuevo</translation>
    </message>
    <message>
        <source>the board refused a value</source>
        <translation>la placa rechazó un valor</translation>
    </message>
    <message>
        <source>the board restarted at %1</source>
        <translation>la placa se reinició en %1</translation>
    </message>
    <message>
        <source>the board sent a reply without a return code</source>
        <translation>la placa envió una respuesta sin código de retorno</translation>
    </message>
    <message>
        <source>the board speaks protocol %1, this program was written for protocol 1; watch it before it is driven</source>
        <translation>la placa usa el protocolo %1, este programa se escribió para el protocolo 1; obsérvela antes de accionarla</translation>
    </message>
    <message>
        <source>the board was reset since its settings were written</source>
        <translation>la placa se reinició después de escribir sus ajustes</translation>
    </message>
    <message>
        <source>the board was unplugged</source>
        <translation>la placa se desconectó</translation>
    </message>
    <message>
        <source>the bootloader did not announce itself</source>
        <translation>el bootloader no se anunció</translation>
    </message>
    <message>
        <source>the bootloader refuses page %1</source>
        <translation>el bootloader rechaza la página %1</translation>
    </message>
    <message>
        <source>the bootloader said nothing</source>
        <translation>el bootloader no dijo nada</translation>
    </message>
    <message>
        <source>the bus leaves no room for what %1 sends</source>
        <translation>el bus no deja espacio para lo que envía %1</translation>
    </message>
    <message>
        <source>the byte count was out of step</source>
        <translation>el número de bytes no cuadraba</translation>
    </message>
    <message>
        <source>the cable was pulled out</source>
        <translation>se desenchufó el cable</translation>
    </message>
    <message>
        <source>the checksum</source>
        <translation>la suma de comprobación</translation>
    </message>
    <message>
        <source>the checksum delimiter</source>
        <translation>el delimitador de la suma de comprobación</translation>
    </message>
    <message>
        <source>the computer slept</source>
        <translation>el ordenador estuvo suspendido</translation>
    </message>
    <message>
        <source>the controller lost frames to send</source>
        <translation>el controlador perdió tramas por enviar</translation>
    </message>
    <message>
        <source>the controller lost received frames</source>
        <translation>el controlador perdió tramas recibidas</translation>
    </message>
    <message>
        <source>the controller may hold half a program, and runs again once an update has succeeded</source>
        <translation>el controlador puede contener medio programa, y vuelve a funcionar cuando una actualización se complete</translation>
    </message>
    <message>
        <source>the controller started again</source>
        <translation>el controlador arrancó de nuevo</translation>
    </message>
    <message>
        <source>the current did not follow the duty, so its resistance is not known</source>
        <translation>la corriente no siguió al ciclo, así que no se conoce su resistencia</translation>
    </message>
    <message>
        <source>the current limit cut into the pushes</source>
        <translation>el límite de corriente recortó los empujes</translation>
    </message>
    <message>
        <source>the data</source>
        <translation>los datos</translation>
    </message>
    <message>
        <source>the data masks have an unexpected length</source>
        <translation>las máscaras de datos tienen una longitud inesperada</translation>
    </message>
    <message>
        <source>the data runs past the end of 32-bit addresses</source>
        <translation>los datos rebasan el final de las direcciones de 32 bits</translation>
    </message>
    <message>
        <source>the data runs past the end of its 64 KiB segment</source>
        <translation>los datos rebasan el final de su segmento de 64 KiB</translation>
    </message>
    <message>
        <source>the device already runs %1</source>
        <translation>el dispositivo ya ejecuta %1</translation>
    </message>
    <message>
        <source>the device answers with no application</source>
        <translation>el dispositivo responde sin aplicación</translation>
    </message>
    <message>
        <source>the device answers with version %1</source>
        <translation>el dispositivo responde con la versión %1</translation>
    </message>
    <message>
        <source>the device could not verify its flash</source>
        <translation>el dispositivo no pudo verificar su flash</translation>
    </message>
    <message>
        <source>the device does not answer</source>
        <translation>el dispositivo no responde</translation>
    </message>
    <message>
        <source>the device is busy with something else</source>
        <translation>el dispositivo está ocupado con otra cosa</translation>
    </message>
    <message>
        <source>the device is gone</source>
        <translation>el dispositivo ya no está</translation>
    </message>
    <message>
        <source>the device is not heard any more</source>
        <translation>ya no se recibe nada del dispositivo</translation>
    </message>
    <message>
        <source>the device may have restarted: once more from page %1</source>
        <translation>el dispositivo puede haberse reiniciado: otra vez desde la página %1</translation>
    </message>
    <message>
        <source>the device restarted</source>
        <translation>el dispositivo se reinició</translation>
    </message>
    <message>
        <source>the device restarted %1 times during the update</source>
        <translation>el dispositivo se reinició %1 veces durante la actualización</translation>
    </message>
    <message>
        <source>the device restarted before its flash was proved to be written</source>
        <translation>el dispositivo se reinició antes de verificarse la escritura de su flash</translation>
    </message>
    <message>
        <source>the device says that the motor is not started; it may have lost its supply</source>
        <translation>el dispositivo indica que el motor no está arrancado; puede haber perdido la alimentación</translation>
    </message>
    <message>
        <source>the device&apos;s rate was not put back: %1</source>
        <translation>la frecuencia del dispositivo no se restituyó: %1</translation>
    </message>
    <message>
        <source>the disk has not made %1 within 10 s</source>
        <translation>el disco no ha creado %1 en 10 s</translation>
    </message>
    <message>
        <source>the disk has not taken %1 for 30 s</source>
        <translation>el disco no ha aceptado %1 desde hace 30 s</translation>
    </message>
    <message>
        <source>the disk is full</source>
        <translation>el disco está lleno</translation>
    </message>
    <message>
        <source>the disk of %1 does not answer</source>
        <translation>el disco de %1 no responde</translation>
    </message>
    <message>
        <source>the drive does not check it and would overwrite its memory</source>
        <translation>el accionamiento no lo comprueba y sobrescribiría su memoria</translation>
    </message>
    <message>
        <source>the driver of %1 cannot switch the direction of an RS-485 line, so the adapter has to do it by itself; if nothing answers, use one that does</source>
        <translation>el driver de %1 no puede conmutar el sentido de una línea RS-485, así que debe hacerlo el adaptador; si nada responde, use uno que lo haga</translation>
    </message>
    <message>
        <source>the duty changed its direction %1 times in a second</source>
        <translation>el ciclo cambió de sentido %1 veces en un segundo</translation>
    </message>
    <message>
        <source>the encoder counts against the power</source>
        <translation>el encoder cuenta en contra de la potencia</translation>
    </message>
    <message>
        <source>the encoder does not count both ways</source>
        <translation>el encoder no cuenta en ambos sentidos</translation>
    </message>
    <message>
        <source>the end of frame</source>
        <translation>el fin de trama</translation>
    </message>
    <message>
        <source>the end-of-file record is missing, the file may be cut off</source>
        <translation>falta el registro de fin de archivo; el archivo puede estar cortado</translation>
    </message>
    <message>
        <source>the file has no lines to send</source>
        <translation>el archivo no tiene líneas que enviar</translation>
    </message>
    <message>
        <source>the file has reached the greatest size there</source>
        <translation>el archivo ha alcanzado ahí el tamaño máximo</translation>
    </message>
    <message>
        <source>the file holds no data</source>
        <translation>el archivo no contiene datos</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>el archivo está vacío</translation>
    </message>
    <message>
        <source>the folder %1 cannot be made</source>
        <translation>no se puede crear la carpeta %1</translation>
    </message>
    <message>
        <source>the folder %1 cannot be written</source>
        <translation>no se puede escribir en la carpeta %1</translation>
    </message>
    <message>
        <source>the formula is nested too deeply</source>
        <translation>la fórmula tiene demasiados niveles anidados</translation>
    </message>
    <message>
        <source>the formula uses no signal</source>
        <translation>la fórmula no usa ninguna señal</translation>
    </message>
    <message>
        <source>the frame has %1 of %2 bytes</source>
        <translation>la trama tiene %1 de %2 bytes</translation>
    </message>
    <message>
        <source>the frame is of the kind %1, not d or r</source>
        <translation>la trama es del tipo %1, no d ni r</translation>
    </message>
    <message>
        <source>the frame says %1 in the place of Rx or Tx</source>
        <translation>la trama indica %1 en lugar de Rx o Tx</translation>
    </message>
    <message>
        <source>the gain had nothing to act on</source>
        <translation>la ganancia no tuvo sobre qué actuar</translation>
    </message>
    <message>
        <source>the gain scale is too coarse to be measured with so little power</source>
        <translation>la escala de ganancia es demasiado gruesa para medirla con tan poca potencia</translation>
    </message>
    <message>
        <source>the gains found at different values do not agree, so that a gain is no simple factor</source>
        <translation>las ganancias halladas con distintos valores no concuerdan; una ganancia no es un simple factor</translation>
    </message>
    <message>
        <source>the gains of this loop are not known here, so its target stays within %1 of where it is: a weak loop may not move it; write its p, d and divisor once</source>
        <translation>aquí no se conocen las ganancias de este lazo, así que su destino queda a menos de %1 de donde está: un lazo débil puede no moverlo; escriba una vez su p, su d y su divisor</translation>
    </message>
    <message>
        <source>the gains stored in the drive are erased; all its loops do nothing until they are written again</source>
        <translation>las ganancias guardadas en el accionamiento se han borrado; sus lazos no hacen nada hasta que se escriban de nuevo</translation>
    </message>
    <message>
        <source>the gains that trial #%1 had changed are put back</source>
        <translation>las ganancias que cambió el ensayo #%1 se han restituido</translation>
    </message>
    <message>
        <source>the guardian does not answer</source>
        <translation>el vigilante no responde</translation>
    </message>
    <message>
        <source>the guardian does not stand by yet</source>
        <translation>el vigilante aún no está preparado</translation>
    </message>
    <message>
        <source>the guardian ended unexpectedly</source>
        <translation>el vigilante terminó de forma inesperada</translation>
    </message>
    <message>
        <source>the guardian has sent the stop, which nothing on this link confirms; look whether the motor stands</source>
        <translation>el vigilante ha enviado la parada, que nada en este enlace confirma; mire si el motor está parado</translation>
    </message>
    <message>
        <source>the guardian has stopped the motor</source>
        <translation>el vigilante ha parado el motor</translation>
    </message>
    <message>
        <source>the guardian is of another version</source>
        <translation>el vigilante es de otra versión</translation>
    </message>
    <message>
        <source>the guardian sent the stop because this program was held up, not confirmed</source>
        <translation>el vigilante envió la parada porque este programa estuvo retenido, sin confirmar</translation>
    </message>
    <message>
        <source>the guardian stopped the motor because this program was held up</source>
        <translation>el vigilante paró el motor porque este programa estuvo retenido</translation>
    </message>
    <message>
        <source>the guardian tried in vain to stop the motor; it may still turn: cut its power</source>
        <translation>el vigilante intentó en vano parar el motor; podría seguir girando: corte su alimentación</translation>
    </message>
    <message>
        <source>the guardian tried to stop the motor because this program was held up, without an answer</source>
        <translation>el vigilante intentó parar el motor porque este programa estuvo retenido, sin respuesta</translation>
    </message>
    <message>
        <source>the history does not have this write: %1</source>
        <translation>el historial no tiene esta escritura: %1</translation>
    </message>
    <message>
        <source>the history has an unexpected length</source>
        <translation>el historial tiene una longitud inesperada</translation>
    </message>
    <message>
        <source>the history of %1 has nothing to do again</source>
        <translation>el historial de %1 no tiene nada que rehacer</translation>
    </message>
    <message>
        <source>the history of %1 has nothing to undo</source>
        <translation>el historial de %1 no tiene nada que deshacer</translation>
    </message>
    <message>
        <source>the identifier</source>
        <translation>el identificador</translation>
    </message>
    <message>
        <source>the identifier extension bit</source>
        <translation>el bit de extensión del identificador</translation>
    </message>
    <message>
        <source>the image is for product 602, this unit is product %1%2%3</source>
        <translation>la imagen es para el producto 602, este equipo es el producto %1%2%3</translation>
    </message>
    <message>
        <source>the image itself writes the settings pages</source>
        <translation>la propia imagen escribe las páginas de ajustes</translation>
    </message>
    <message>
        <source>the intermission</source>
        <translation>la pausa entre tramas</translation>
    </message>
    <message>
        <source>the journal on the server was made by a newer version of this program</source>
        <translation>el diario del servidor es de una versión más reciente de este programa</translation>
    </message>
    <message>
        <source>the journal&apos;s server: %1</source>
        <translation>el servidor del diario: %1</translation>
    </message>
    <message>
        <source>the jumper is still in: take it out, then reset the board</source>
        <translation>el puente sigue puesto: quítelo y reinicie la placa</translation>
    </message>
    <message>
        <source>the kernel does not list its interfaces: %1</source>
        <translation>el núcleo no enumera sus interfaces: %1</translation>
    </message>
    <message>
        <source>the key &apos;%1&apos; is there twice</source>
        <translation>la clave «%1» aparece dos veces</translation>
    </message>
    <message>
        <source>the layout has more than 500 traces</source>
        <translation>la disposición tiene más de 500 curvas</translation>
    </message>
    <message>
        <source>the length</source>
        <translation>la longitud</translation>
    </message>
    <message>
        <source>the length of the frame is %1</source>
        <translation>la longitud de la trama es %1</translation>
    </message>
    <message>
        <source>the limit of &apos;%1&apos; must be the greatest value, 0 or more, or [least, greatest]</source>
        <translation>el límite de «%1» debe ser el valor máximo, 0 o más, o [mínimo, máximo]</translation>
    </message>
    <message>
        <source>the link is not open</source>
        <translation>el enlace no está abierto</translation>
    </message>
    <message>
        <source>the link was opened anew</source>
        <translation>el enlace se abrió de nuevo</translation>
    </message>
    <message>
        <source>the loop drives the motor the wrong way</source>
        <translation>el lazo acciona el motor en el sentido equivocado</translation>
    </message>
    <message>
        <source>the loop swings itself up: %1 swings, each larger than the last or with full duty</source>
        <translation>el lazo entra en oscilación creciente: %1 oscilaciones, cada una mayor que la anterior o con ciclo máximo</translation>
    </message>
    <message>
        <source>the loop does not come to rest: %1 swings</source>
        <translation>el lazo no llega al reposo: %1 oscilaciones</translation>
    </message>
    <message>
        <source>the loop would be undefined</source>
        <translation>el lazo quedaría indefinido</translation>
    </message>
    <message>
        <source>the microcontroller of the drive is f1 (STM32F1) or f4 (STM32F4)</source>
        <translation>el microcontrolador del accionamiento es f1 (STM32F1) o f4 (STM32F4)</translation>
    </message>
    <message>
        <source>the model is not to be believed: %1</source>
        <translation>el modelo no es fiable: %1</translation>
    </message>
    <message>
        <source>the motor did not follow a step: stalled, or the encoder is dead</source>
        <translation>el motor no siguió un escalón: bloqueado o el encoder no funciona</translation>
    </message>
    <message>
        <source>the motor did not move at up to %1 % duty (%2 counts): stalled, or the encoder is dead</source>
        <translation>el motor no se movió con ciclo de hasta %1 % (%2 cuentas): bloqueado o el encoder no funciona</translation>
    </message>
    <message>
        <source>the motor did not turn at two of the powers</source>
        <translation>el motor no giró con dos de las potencias</translation>
    </message>
    <message>
        <source>the motor did not turn at up to %1 duty: stalled, or the encoder is dead</source>
        <translation>el motor no giró con ciclo de hasta %1: bloqueado o el encoder no funciona</translation>
    </message>
    <message>
        <source>the motor did not turn the way it was pushed</source>
        <translation>el motor no giró hacia donde se empujó</translation>
    </message>
    <message>
        <source>the motor gives %1 counts/s per power unit, friction takes %2 units, it follows within %3 ms</source>
        <translation>el motor da %1 counts/s por unidad de potencia, la fricción toma %2 unidades, sigue en %3 ms</translation>
    </message>
    <message>
        <source>the motor is not seen to stand</source>
        <translation>no se ve parado el motor</translation>
    </message>
    <message>
        <source>the motor ran faster than the power limit allows</source>
        <translation>el motor giró más rápido de lo que permite el límite de potencia</translation>
    </message>
    <message>
        <source>the motor reversed during a sine of %1 Hz: friction is in it</source>
        <translation>el motor invirtió el giro durante un seno de %1 Hz: contiene fricción</translation>
    </message>
    <message>
        <source>the motor took the heat of %1 s at %2 A, 10 s are allowed; let it cool</source>
        <translation>el motor recibió el calor de %1 s a %2 A, se permiten 10 s; déjelo enfriar</translation>
    </message>
    <message>
        <source>the motor turned too short a time below the power limit to be measured</source>
        <translation>el motor giró muy poco tiempo por debajo del límite de potencia para medirlo</translation>
    </message>
    <message>
        <source>the motor turns differently in both directions</source>
        <translation>el motor gira distinto en ambos sentidos</translation>
    </message>
    <message>
        <source>the motor was not seen to stand</source>
        <translation>no se vio el motor parado</translation>
    </message>
    <message>
        <source>the motor was stopped</source>
        <translation>el motor se paró</translation>
    </message>
    <message>
        <source>the motor was stopped: %1</source>
        <translation>el motor se paró: %1</translation>
    </message>
    <message>
        <source>the motors that were not seen to stand were looked at; their stops are dismissed</source>
        <translation>se miraron los motores que no se vieron parar; sus paradas se dan por resueltas</translation>
    </message>
    <message>
        <source>the motors were told to stop, and are not seen to stand</source>
        <translation>se ordenó parar a los motores y no se les ve parados</translation>
    </message>
    <message>
        <source>the name was written, but the device answers &apos;%1&apos;</source>
        <translation>el nombre se escribió, pero el dispositivo responde «%1»</translation>
    </message>
    <message>
        <source>the nearest it can is %1</source>
        <translation>lo más próximo posible es %1</translation>
    </message>
    <message>
        <source>the offset of an Abstract DC Drive is compiled into its firmware</source>
        <translation>el offset de un Abstract DC Drive está compilado en su firmware</translation>
    </message>
    <message>
        <source>the order was dropped: what it was for has ended</source>
        <translation>la orden se descartó: aquello para lo que era ha terminado</translation>
    </message>
    <message>
        <source>the other end of %1 closed it</source>
        <translation>el otro extremo de %1 lo cerró</translation>
    </message>
    <message>
        <source>the other end of %1 hung up</source>
        <translation>el otro extremo de %1 cortó la conexión</translation>
    </message>
    <message>
        <source>the output of its loop passed 32767, where it turns to full reverse</source>
        <translation>la salida de su lazo superó 32767, donde pasa a plena marcha atrás</translation>
    </message>
    <message>
        <source>the packet is too long for the board</source>
        <translation>el paquete es demasiado largo para la placa</translation>
    </message>
    <message>
        <source>the plugin %1 finds no adapter</source>
        <translation>el plugin %1 no encuentra ningún adaptador</translation>
    </message>
    <message>
        <source>the plugin %1 finds no adapter (%2)</source>
        <translation>el plugin %1 no encuentra ningún adaptador (%2)</translation>
    </message>
    <message>
        <source>the position is not known yet, so nothing would keep the motor from jumping</source>
        <translation>aún no se conoce la posición, así que nada impediría que el motor saltara</translation>
    </message>
    <message>
        <source>the position is written only while the output is off</source>
        <translation>la posición solo se escribe con la salida apagada</translation>
    </message>
    <message>
        <source>the position was not reset: %1</source>
        <translation>la posición no se puso a cero: %1</translation>
    </message>
    <message>
        <source>the positions have an unexpected length</source>
        <translation>las posiciones tienen una longitud inesperada</translation>
    </message>
    <message>
        <source>the profiled move passed its target by more than its stopping distance, as this firmware may above 2500 counts/s; use a lower profile.velocity</source>
        <translation>el movimiento con perfil rebasó su destino más que su distancia de frenado, como puede ocurrir con este firmware por encima de 2500 counts/s; use un profile.velocity menor</translation>
    </message>
    <message>
        <source>the pushes differ by %1 in their resistance, at most 15 %</source>
        <translation>los empujes difieren %1 en su resistencia, como máximo 15 %</translation>
    </message>
    <message>
        <source>the ramp must be 0 (immediate) or a positive number of duty per second</source>
        <translation>la rampa debe ser 0 (inmediata) o un número positivo de ciclo por segundo</translation>
    </message>
    <message>
        <source>the ramp must be 0 or a positive number of duty per second</source>
        <translation>la rampa debe ser 0 o un número positivo de ciclo por segundo</translation>
    </message>
    <message>
        <source>the ready line stayed low</source>
        <translation>la línea de listo siguió a nivel bajo</translation>
    </message>
    <message>
        <source>the record is cut off after %1 bytes</source>
        <translation>el registro está cortado tras %1 bytes</translation>
    </message>
    <message>
        <source>the recording has ended: %1</source>
        <translation>la grabación ha terminado: %1</translation>
    </message>
    <message>
        <source>the remote bit</source>
        <translation>el bit remoto</translation>
    </message>
    <message>
        <source>the reply has an unexpected length</source>
        <translation>la respuesta tiene una longitud inesperada</translation>
    </message>
    <message>
        <source>the report cannot be painted</source>
        <translation>el informe no se puede dibujar</translation>
    </message>
    <message>
        <source>the reset line was pulsed</source>
        <translation>se dio un pulso a la línea de reset</translation>
    </message>
    <message>
        <source>the resistance is known within %1, at most 10 %</source>
        <translation>la resistencia se conoce con ±%1, como máximo 10 %</translation>
    </message>
    <message>
        <source>the response could not be measured</source>
        <translation>no se pudo medir la respuesta</translation>
    </message>
    <message>
        <source>the same interface as socketcan:%1, which also counts losses</source>
        <translation>la misma interfaz que socketcan:%1, que además cuenta las pérdidas</translation>
    </message>
    <message>
        <source>the scale of its gains is not known yet, and is found first: one to two minutes, with %1 % of its power at most</source>
        <translation>aún no se conoce la escala de sus ganancias y se averigua antes: de uno a dos minutos, con %1 % de su potencia como máximo</translation>
    </message>
    <message>
        <source>the search was cancelled; what it found stays</source>
        <translation>la búsqueda se canceló; lo encontrado se queda</translation>
    </message>
    <message>
        <source>the self-test could not go on: %1</source>
        <translation>la autoprueba no pudo continuar: %1</translation>
    </message>
    <message>
        <source>the self-test was ended by the guard &apos;%1&apos;: %2</source>
        <translation>la protección «%1» terminó la autoprueba: %2</translation>
    </message>
    <message>
        <source>the self-test was stopped by hand</source>
        <translation>la autoprueba se paró a mano</translation>
    </message>
    <message>
        <source>the sensor counts down when the motor is driven up (%1 counts): one of them is reversed</source>
        <translation>el sensor cuenta hacia abajo cuando el motor se acciona hacia arriba (%1 cuentas): uno de los dos está invertido</translation>
    </message>
    <message>
        <source>the sensor is reversed: it counts down</source>
        <translation>el sensor está invertido: cuenta hacia abajo</translation>
    </message>
    <message>
        <source>the sensor is reversed: it counts up</source>
        <translation>el sensor está invertido: cuenta hacia arriba</translation>
    </message>
    <message>
        <source>the set-point comes from here, not from the device</source>
        <translation>la consigna viene de aquí, no del dispositivo</translation>
    </message>
    <message>
        <source>the set-point of the step</source>
        <translation>la consigna del escalón</translation>
    </message>
    <message>
        <source>the settings of the %1 loop were saved %2 times</source>
        <translation>los ajustes del lazo de %1 se guardaron %2 veces</translation>
    </message>
    <message>
        <source>the settings that the reset took are written again</source>
        <translation>los ajustes que se llevó el reinicio se reescriben</translation>
    </message>
    <message>
        <source>the shaft must be free, without load on one side</source>
        <translation>el eje debe estar libre, sin carga hacia un lado</translation>
    </message>
    <message>
        <source>the simulated board is in use by another link</source>
        <translation>la placa simulada la usa otro enlace</translation>
    </message>
    <message>
        <source>the simulator at %1 closed the connection</source>
        <translation>el simulador en %1 cerró la conexión</translation>
    </message>
    <message>
        <source>the simulator at %1 sent bytes that nobody asked for</source>
        <translation>el simulador en %1 envió bytes que nadie pidió</translation>
    </message>
    <message>
        <source>the speed does not grow evenly with the power</source>
        <translation>la velocidad no crece de manera uniforme con la potencia</translation>
    </message>
    <message>
        <source>the start of frame</source>
        <translation>el inicio de trama</translation>
    </message>
    <message>
        <source>the status bit is the same with both polarities, so it tells nothing</source>
        <translation>el bit de estado es igual con ambas polaridades, así que no indica nada</translation>
    </message>
    <message>
        <source>the steps met the end of the output</source>
        <translation>los escalones alcanzaron el tope de la salida</translation>
    </message>
    <message>
        <source>the stop before it is not acknowledged yet</source>
        <translation>la parada anterior aún no está confirmada</translation>
    </message>
    <message>
        <source>the stop could not be sent, and is the first thing that goes out when the line is back; cut its power</source>
        <translation>la parada no se pudo enviar y es lo primero que saldrá cuando vuelva la línea; corte su alimentación</translation>
    </message>
    <message>
        <source>the stop of the self-test was not confirmed: %1</source>
        <translation>la parada de la autoprueba no se confirmó: %1</translation>
    </message>
    <message>
        <source>the stop script of this device is not one that a guardian can carry out</source>
        <translation>el guion de parada de este dispositivo no es uno que un vigilante pueda ejecutar</translation>
    </message>
    <message>
        <source>the stop was not acknowledged, so the position was not reset: a motor that runs would jump</source>
        <translation>la parada no se confirmó, así que la posición no se puso a cero: un motor en marcha daría un salto</translation>
    </message>
    <message>
        <source>the stream settings have an unexpected length</source>
        <translation>los ajustes del stream tienen una longitud inesperada</translation>
    </message>
    <message>
        <source>the substitute remote bit</source>
        <translation>el bit remoto sustituto</translation>
    </message>
    <message>
        <source>the target</source>
        <translation>el destino</translation>
    </message>
    <message>
        <source>the text is longer than %1 MiB</source>
        <translation>el texto tiene más de %1 MiB</translation>
    </message>
    <message>
        <source>the time stamp %1 is out of range</source>
        <translation>la marca de tiempo %1 está fuera de rango</translation>
    </message>
    <message>
        <source>the time stamps are %1, not absolute or relative</source>
        <translation>las marcas de tiempo son %1, no absolute ni relative</translation>
    </message>
    <message>
        <source>the transceiver reports an error</source>
        <translation>el transceptor notifica un error</translation>
    </message>
    <message>
        <source>the transcript of the update is in %1</source>
        <translation>la transcripción de la actualización está en %1</translation>
    </message>
    <message>
        <source>the transcript of the update is not kept: %1</source>
        <translation>la transcripción de la actualización no se conserva: %1</translation>
    </message>
    <message>
        <source>the tuning is not in the notebook: %1</source>
        <translation>el ajuste no está en el cuaderno: %1</translation>
    </message>
    <message>
        <source>the two directions differ by %1, at most 10 %</source>
        <translation>los dos sentidos difieren %1, como máximo 10 %</translation>
    </message>
    <message>
        <source>the unit answers with firmware %1, the image is %2</source>
        <translation>el equipo responde con el firmware %1, la imagen es %2</translation>
    </message>
    <message>
        <source>the unit does not answer an enumeration</source>
        <translation>el equipo no responde a una enumeración</translation>
    </message>
    <message>
        <source>the unit may have restarted meanwhile: once more from page %1</source>
        <translation>el equipo puede haberse reiniciado entretanto: otra vez desde la página %1</translation>
    </message>
    <message>
        <source>the unit restarted: what is volatile was lost, its parameters are read again</source>
        <translation>el equipo se reinició: lo volátil se perdió, sus parámetros se leen de nuevo</translation>
    </message>
    <message>
        <source>the unit said it is in its bootloader, but its application answers</source>
        <translation>el equipo dijo estar en su bootloader, pero responde su aplicación</translation>
    </message>
    <message>
        <source>the unit stays %1 away from where the experiment begins, more than 2 % of its step</source>
        <translation>el equipo queda a %1 de donde empieza el experimento, más del 2 % de su escalón</translation>
    </message>
    <message>
        <source>the unit stores no P, so nothing moves it</source>
        <translation>el equipo no guarda ningún P, así que nada lo mueve</translation>
    </message>
    <message>
        <source>the unit stores them by itself within %1 s</source>
        <translation>el equipo los guarda por sí mismo en %1 s</translation>
    </message>
    <message>
        <source>the unit tells no duty, no current or no position, so its resistance is not known</source>
        <translation>el equipo no indica ciclo, corriente o posición, así que no se conoce su resistencia</translation>
    </message>
    <message>
        <source>the unit waits in its bootloader, run the update again</source>
        <translation>el equipo espera en su bootloader, repita la actualización</translation>
    </message>
    <message>
        <source>the unit was not heard during the self-test: %1</source>
        <translation>no se recibió nada del equipo durante la autoprueba: %1</translation>
    </message>
    <message>
        <source>the user stopped it</source>
        <translation>lo paró el usuario</translation>
    </message>
    <message>
        <source>the user-ID words</source>
        <translation>las palabras de ID de usuario</translation>
    </message>
    <message>
        <source>the values are not put back: %1</source>
        <translation>los valores no se han restituido: %1</translation>
    </message>
    <message>
        <source>the values are put back</source>
        <translation>los valores se han restituido</translation>
    </message>
    <message>
        <source>the values stay with this program and are written again after a reset</source>
        <translation>los valores quedan en este programa y se escriben de nuevo tras un reinicio</translation>
    </message>
    <message>
        <source>the version at 0x1EFFC is 0x0000</source>
        <translation>la versión en 0x1EFFC es 0x0000</translation>
    </message>
    <message>
        <source>the version at 0x1EFFC is 0xFFFF, which means no application</source>
        <translation>la versión en 0x1EFFC es 0xFFFF, es decir, sin aplicación</translation>
    </message>
    <message>
        <source>the version has an unexpected length</source>
        <translation>la versión tiene una longitud inesperada</translation>
    </message>
    <message>
        <source>the window of the layout is out of range</source>
        <translation>la ventana de la disposición está fuera de rango</translation>
    </message>
    <message>
        <source>the wire lost too many frames; the same again</source>
        <translation>la línea perdió demasiadas tramas; lo mismo otra vez</translation>
    </message>
    <message>
        <source>there is no %1</source>
        <translation>no existe %1</translation>
    </message>
    <message>
        <source>there is no CAN interface</source>
        <translation>no hay ninguna interfaz CAN</translation>
    </message>
    <message>
        <source>there is no CAN interface %1</source>
        <translation>no existe la interfaz CAN %1</translation>
    </message>
    <message>
        <source>there is no CAN plugin %1</source>
        <translation>no existe el plugin CAN %1</translation>
    </message>
    <message>
        <source>there is no GPIO chip for %1</source>
        <translation>no hay chip GPIO para %1</translation>
    </message>
    <message>
        <source>there is no entry %1 in the journal</source>
        <translation>no existe la entrada %1 en el diario</translation>
    </message>
    <message>
        <source>there is no file &apos;%1&apos;</source>
        <translation>no existe el archivo «%1»</translation>
    </message>
    <message>
        <source>there is no layout of this name</source>
        <translation>no existe una disposición con este nombre</translation>
    </message>
    <message>
        <source>there is no simulated link &apos;sim:%1&apos;: can, serial and spi are known</source>
        <translation>no existe el enlace simulado «sim:%1»: se conocen can, serial y spi</translation>
    </message>
    <message>
        <source>there is no snapshot &apos;%1&apos;</source>
        <translation>no existe la instantánea «%1»</translation>
    </message>
    <message>
        <source>there is no snapshot &apos;%1&apos; of this unit</source>
        <translation>no existe la instantánea «%1» de este equipo</translation>
    </message>
    <message>
        <source>there is no socket %1</source>
        <translation>no existe el socket %1</translation>
    </message>
    <message>
        <source>there is no such folder</source>
        <translation>no existe esa carpeta</translation>
    </message>
    <message>
        <source>there is no table here: expected time_s,name (unit),… or t,channel,value,unit</source>
        <translation>aquí no hay ninguna tabla: se esperaba time_s,name (unit),… o t,channel,value,unit</translation>
    </message>
    <message>
        <source>there is no trial %1</source>
        <translation>no existe el ensayo %1</translation>
    </message>
    <message>
        <source>there is no way from %1 to itself</source>
        <translation>no hay recorrido de %1 a sí mismo</translation>
    </message>
    <message>
        <source>there is not enough room for a frequency response: its limits leave a speed of %1 counts/s for %2 s</source>
        <translation>no hay espacio suficiente para una respuesta en frecuencia: sus límites dejan una velocidad de %1 counts/s durante %2 s</translation>
    </message>
    <message>
        <source>there is not enough room to identify the motor: its limits leave pushes of %1 duty only</source>
        <translation>no hay espacio suficiente para identificar el motor: sus límites solo dejan empujes con ciclo %1</translation>
    </message>
    <message>
        <source>there is not enough room: its limits leave steps of %1 counts</source>
        <translation>no hay espacio suficiente: sus límites dejan escalones de %1 cuentas</translation>
    </message>
    <message>
        <source>these are the calm gains, %1</source>
        <translation>estas son las ganancias suaves, %1</translation>
    </message>
    <message>
        <source>they have speed and interface</source>
        <translation>tienen speed e interface</translation>
    </message>
    <message>
        <source>this build knows %1</source>
        <translation>esta versión conoce %1</translation>
    </message>
    <message>
        <source>this build simulates no devices on sim:%1</source>
        <translation>esta versión no simula dispositivos en sim:%1</translation>
    </message>
    <message>
        <source>this change waits for nobody</source>
        <translation>este cambio no espera a nadie</translation>
    </message>
    <message>
        <source>this command is not known to firmware of dialect %1</source>
        <translation>el firmware del dialecto %1 no conoce esta orden</translation>
    </message>
    <message>
        <source>this computer has no driver for PostgreSQL</source>
        <translation>este ordenador no tiene driver para PostgreSQL</translation>
    </message>
    <message>
        <source>this computer is not kept awake while motors are driven or firmware is written: %1; switch its automatic suspend off meanwhile</source>
        <translation>este ordenador no se mantiene despierto mientras se accionan motores o se escribe firmware: %1; desactive entretanto su suspensión automática</translation>
    </message>
    <message>
        <source>this device has no experiment &apos;%1&apos;</source>
        <translation>este dispositivo no tiene el experimento «%1»</translation>
    </message>
    <message>
        <source>this device has no watchdog, and nothing here would stop it if the program died</source>
        <translation>este dispositivo no tiene watchdog, y nada lo pararía si el programa se cerrara</translation>
    </message>
    <message>
        <source>this device has no watchdog, and on %1 nothing could stop it if the program died</source>
        <translation>este dispositivo no tiene watchdog, y en %1 nada podría pararlo si el programa se cerrara</translation>
    </message>
    <message>
        <source>this firmware may pass the target of a profiled move above 2500 counts/s; it is stopped then</source>
        <translation>este firmware puede rebasar el destino de un movimiento con perfil por encima de 2500 counts/s; entonces se para</translation>
    </message>
    <message>
        <source>this image holds a bootloader too, which cannot write itself</source>
        <translation>esta imagen contiene también un bootloader, que no puede escribirse a sí mismo</translation>
    </message>
    <message>
        <source>this interface cannot listen without disturbing the bus, so ask who set it up; usual are 1 Mbit/s, 500, 250 and 125 kbit/s</source>
        <translation>esta interfaz no puede escuchar sin perturbar el bus; pregunte a quien lo configuró; lo habitual es 1 Mbit/s, 500, 250 y 125 kbit/s</translation>
    </message>
    <message>
        <source>this is another unit by now, number %1</source>
        <translation>ahora es otro equipo, número %1</translation>
    </message>
    <message>
        <source>this is no layout of plots</source>
        <translation>esto no es una disposición de gráficas</translation>
    </message>
    <message>
        <source>this is no program for the controller: it does not begin with a jump of an AVR at address 0</source>
        <translation>no es un programa para el controlador: no empieza con un salto de AVR en la dirección 0</translation>
    </message>
    <message>
        <source>this is no program for the controller: it has bytes outside the 32 KiB of an ATmega328P</source>
        <translation>no es un programa para el controlador: tiene bytes fuera de los 32 KiB de un ATmega328P</translation>
    </message>
    <message>
        <source>this is no program for the drive: it has bytes outside the flash of an STM32, 0x08000000 … 0x081FFFFF</source>
        <translation>no es un programa para el accionamiento: tiene bytes fuera de la flash de un STM32, 0x08000000 … 0x081FFFFF</translation>
    </message>
    <message>
        <source>this is no program for the drive: there are no vectors of an STM32 at 0x08000000. Make the Intel HEX file with: arm-none-eabi-objcopy -O ihex abstract_DC_drive.elf</source>
        <translation>no es un programa para el accionamiento: no hay vectores de un STM32 en 0x08000000. Genere el archivo Intel HEX con: arm-none-eabi-objcopy -O ihex abstract_DC_drive.elf</translation>
    </message>
    <message>
        <source>this is no recipe of version 1</source>
        <translation>no es una receta de la versión 1</translation>
    </message>
    <message>
        <source>this is no session of MotorBench</source>
        <translation>no es una sesión de MotorBench</translation>
    </message>
    <message>
        <source>this kernel has no CAN support</source>
        <translation>este núcleo no admite CAN</translation>
    </message>
    <message>
        <source>this program was held up for %1 ms, longer than the motor goes without a set-point</source>
        <translation>este programa estuvo retenido %1 ms, más de lo que el motor marcha sin consigna</translation>
    </message>
    <message>
        <source>this program was held up for so long that the guardian may have stopped the motor</source>
        <translation>este programa estuvo retenido tanto tiempo que el vigilante puede haber parado el motor</translation>
    </message>
    <message>
        <source>this takes too long</source>
        <translation>esto tarda demasiado</translation>
    </message>
    <message>
        <source>this trial has no sine and no positions</source>
        <translation>este ensayo no tiene seno ni posiciones</translation>
    </message>
    <message>
        <source>this trial is kept without its result: %1</source>
        <translation>este ensayo se conserva sin su resultado: %1</translation>
    </message>
    <message>
        <source>this trial is not kept: %1</source>
        <translation>este ensayo no se conserva: %1</translation>
    </message>
    <message>
        <source>this trial owes nothing to the unit</source>
        <translation>este ensayo no debe nada al equipo</translation>
    </message>
    <message>
        <source>this unit has no number yet</source>
        <translation>este equipo aún no tiene número</translation>
    </message>
    <message>
        <source>this unit has no number yet, and without one its motor may not be driven</source>
        <translation>este equipo aún no tiene número, y sin él no se puede accionar su motor</translation>
    </message>
    <message>
        <source>this unit waits in its bootloader, and the recipe has no firmware for it</source>
        <translation>este equipo espera en su bootloader, y la receta no tiene firmware para él</translation>
    </message>
    <message>
        <source>to be trusted up to %1 Hz, as far as ten samples a swing and a coherence of 0.9</source>
        <translation>fiable hasta %1 Hz, hasta donde alcanzan diez muestras por oscilación y una coherencia de 0,9</translation>
    </message>
    <message>
        <source>too few samples for a sine of %1 Hz</source>
        <translation>muy pocas muestras para un seno de %1 Hz</translation>
    </message>
    <message>
        <source>too few steps to tell what the gains of this loop do</source>
        <translation>muy pocos escalones para saber qué hacen las ganancias de este lazo</translation>
    </message>
    <message>
        <source>transmission timed out</source>
        <translation>el envío superó el tiempo de espera</translation>
    </message>
    <message>
        <source>trial #%1</source>
        <translation>ensayo #%1</translation>
    </message>
    <message>
        <source>try a lower speed=</source>
        <translation>pruebe un speed= menor</translation>
    </message>
    <message>
        <source>try again</source>
        <translation>inténtelo de nuevo</translation>
    </message>
    <message>
        <source>try its position loop</source>
        <translation>pruebe su lazo de posición</translation>
    </message>
    <message>
        <source>tune it by hand with &apos;motorbenchctl step&apos;</source>
        <translation>ajústelo a mano con «motorbenchctl step»</translation>
    </message>
    <message>
        <source>tuning %1: %2</source>
        <translation>ajuste %1: %2</translation>
    </message>
    <message>
        <source>turning the motor with several powers</source>
        <translation>girando el motor con varias potencias</translation>
    </message>
    <message>
        <source>undone: %1</source>
        <translation>deshecho: %1</translation>
    </message>
    <message>
        <source>units are served already</source>
        <translation>ya se atienden equipos</translation>
    </message>
    <message>
        <source>units are served on this link</source>
        <translation>se atienden equipos en este enlace</translation>
    </message>
    <message>
        <source>unix links have no option &apos;%1&apos;</source>
        <translation>los enlaces unix no tienen la opción «%1»</translation>
    </message>
    <message>
        <source>unknown error</source>
        <translation>error desconocido</translation>
    </message>
    <message>
        <source>unknown family &apos;%1&apos;</source>
        <translation>familia desconocida «%1»</translation>
    </message>
    <message>
        <source>unknown fault &apos;%1&apos;</source>
        <translation>fallo desconocido «%1»</translation>
    </message>
    <message>
        <source>unknown key %1</source>
        <translation>clave desconocida %1</translation>
    </message>
    <message>
        <source>unknown key &apos;%1&apos;</source>
        <translation>clave desconocida «%1»</translation>
    </message>
    <message>
        <source>unknown link kind &apos;%1&apos;: sim, socketcan, qtcan, serial, spidev, unix and replay are known</source>
        <translation>tipo de enlace desconocido «%1»: se conocen sim, socketcan, qtcan, serial, spidev, unix y replay</translation>
    </message>
    <message>
        <source>unknown loop &apos;%1&apos;</source>
        <translation>lazo desconocido «%1»</translation>
    </message>
    <message>
        <source>unknown option &apos;%1&apos; of a serial link</source>
        <translation>opción desconocida «%1» de un enlace serie</translation>
    </message>
    <message>
        <source>unknown option &apos;%1&apos; of a simulated link</source>
        <translation>opción desconocida «%1» de un enlace simulado</translation>
    </message>
    <message>
        <source>unplug it and plug it in again</source>
        <translation>desconéctelo y conéctelo de nuevo</translation>
    </message>
    <message>
        <source>unreadable</source>
        <translation>ilegible</translation>
    </message>
    <message>
        <source>update its firmware first</source>
        <translation>actualice antes su firmware</translation>
    </message>
    <message>
        <source>use a programmer on the pins</source>
        <translation>use un programador en los pines</translation>
    </message>
    <message>
        <source>use an interface of the kernel</source>
        <translation>use una interfaz del núcleo</translation>
    </message>
    <message>
        <source>use that one</source>
        <translation>use ese</translation>
    </message>
    <message>
        <source>velocity is −100000 to 100000 counts/s</source>
        <translation>la velocidad es de −100000 a 100000 counts/s</translation>
    </message>
    <message>
        <source>virtual</source>
        <translation>virtual</translation>
    </message>
    <message>
        <source>wait until it is heard</source>
        <translation>espere a que se reciba algo de él</translation>
    </message>
    <message>
        <source>was not seen to stop: the motor may still turn, cut its power</source>
        <translation>no se vio parar: el motor podría seguir girando, corte su alimentación</translation>
    </message>
    <message>
        <source>was seen to stand</source>
        <translation>se vio parado</translation>
    </message>
    <message>
        <source>what D does is known within %1, at most 30 %</source>
        <translation>lo que hace D se conoce con ±%1, como máximo 30 %</translation>
    </message>
    <message>
        <source>what a gain of %1 means in this loop is not known</source>
        <translation>no se sabe qué significa una ganancia de %1 en este lazo</translation>
    </message>
    <message>
        <source>what a raw gain of this board puts out is not known (%1)</source>
        <translation>no se sabe qué salida da una ganancia bruta de esta placa (%1)</translation>
    </message>
    <message>
        <source>what another program has changed within the last 15 s is not in the flash of the unit yet, and is lost with the restart</source>
        <translation>lo que otro programa cambió en los últimos 15 s aún no está en la flash del equipo y se pierde con el reinicio</translation>
    </message>
    <message>
        <source>what is left over is %1 of the steps, at most 8 %</source>
        <translation>lo que sobra es %1 de los escalones, como máximo 8 %</translation>
    </message>
    <message>
        <source>what is missing is still unknown, do it again</source>
        <translation>lo que falta sigue siendo desconocido, repítalo</translation>
    </message>
    <message>
        <source>what is sent to node %1 is also done by node %2, now or after a restart, because of an acceptance mask; set its node.mask to 255 and restart it</source>
        <translation>lo que se envía al nodo %1 también lo ejecuta el nodo %2, ahora o tras un reinicio, por una máscara de aceptación; ponga su node.mask a 255 y reinícielo</translation>
    </message>
    <message>
        <source>what the gains of this loop make is not known any more</source>
        <translation>ya no se sabe qué hacen las ganancias de este lazo</translation>
    </message>
    <message>
        <source>where it is neither, its gain.p is too small for so short a way</source>
        <translation>donde no es ninguna de las dos cosas, su gain.p es demasiado pequeño para un recorrido tan corto</translation>
    </message>
    <message>
        <source>without a ready line the board is asked 100 times a second, and cannot stream</source>
        <translation>sin línea de listo se consulta la placa 100 veces por segundo y no puede emitir un stream</translation>
    </message>
    <message>
        <source>without it nothing would stop this motor if the program died: install it there</source>
        <translation>sin él nada pararía este motor si el programa se cerrara: instálelo allí</translation>
    </message>
    <message>
        <source>write %1</source>
        <translation>escribir %1</translation>
    </message>
    <message>
        <source>write == to compare</source>
        <translation>escriba == para comparar</translation>
    </message>
    <message>
        <source>write a larger gain.d once, with which it still comes to rest</source>
        <translation>escriba una vez un gain.d mayor con el que aún quede en reposo</translation>
    </message>
    <message>
        <source>write a number</source>
        <translation>escriba un número</translation>
    </message>
    <message>
        <source>write a small gain.p once, with which it moves</source>
        <translation>escriba una vez un gain.p pequeño con el que se mueva</translation>
    </message>
    <message>
        <source>write a smaller gain.p once</source>
        <translation>escriba una vez un gain.p menor</translation>
    </message>
    <message>
        <source>write it like 2.5</source>
        <translation>escríbalo como 2.5</translation>
    </message>
    <message>
        <source>write it with &apos;motorbenchctl set&apos;</source>
        <translation>escríbalo con «motorbenchctl set»</translation>
    </message>
    <message>
        <source>write it with a dot, like 1.5, and no comma</source>
        <translation>escríbalo con punto, como 1.5, y sin coma</translation>
    </message>
    <message>
        <source>write on or off</source>
        <translation>escriba on u off</translation>
    </message>
    <message>
        <source>write openocd:INTERFACE, such as openocd:stlink</source>
        <translation>escriba openocd:INTERFACE, como openocd:stlink</translation>
    </message>
    <message>
        <source>write the gains of this loop once, or keep what is tried</source>
        <translation>escriba una vez las ganancias de este lazo o conserve lo que se prueba</translation>
    </message>
    <message>
        <source>write true or false</source>
        <translation>escriba true o false</translation>
    </message>
    <message>
        <source>written again: %1</source>
        <translation>reescrito: %1</translation>
    </message>
    <message>
        <source>written, but the current limit, which this firmware overwrites with it, could not be put back to %1 mA: %2</source>
        <translation>escrito, pero el límite de corriente, que este firmware sobrescribe con ello, no se pudo restituir a %1 mA: %2</translation>
    </message>
    <message>
        <source>brisk</source>
        <translation>rápido</translation>
    </message>
    <message>
        <source>calm</source>
        <translation>suave</translation>
    </message>
    <message>
        <source>kept</source>
        <translation>conservado</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>normal</translation>
    </message>
    <message>
        <source>proposed</source>
        <translation>propuesto</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>rechazado</translation>
    </message>
    <message>
        <source>rolled-back</source>
        <translation>restituido</translation>
    </message>
    <message>
        <source>P alone, in a loop that looks at the current every %1, holds %2 of what is asked for when it overshoots by %3</source>
        <translation>P sola, en un lazo que mira la corriente cada %1, mantiene %2 de lo pedido cuando sobreimpulsa %3</translation>
    </message>
    <message>
        <source>allow more travel, so that pushes may last</source>
        <translation>permita más recorrido, para que los empujes puedan durar</translation>
    </message>
    <message>
        <source>drive it by duty, or try its I with &apos;motorbenchctl step&apos;: not every build of the firmware runs it</source>
        <translation>muévalo por ciclo, o pruebe su I con «motorbenchctl step»: no todas las versiones del firmware la calculan</translation>
    </message>
    <message>
        <source>friction takes %1 duty, and %2 may push: too little for a motor to swing</source>
        <translation>la fricción toma ciclo %1 y se permite empujar con %2: demasiado poco para que un motor oscile</translation>
    </message>
    <message>
        <source>its current stays %1 A behind while the motor speeds up</source>
        <translation>su corriente queda %1 A por detrás mientras el motor acelera</translation>
    </message>
    <message>
        <source>no motor of this gain swings by %1 counts every %2</source>
        <translation>ningún motor de esta ganancia oscila %1 cuentas cada %2</translation>
    </message>
    <message>
        <source>now those of the model as that step has corrected it</source>
        <translation>ahora las del modelo tal como lo ha corregido ese escalón</translation>
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
        <source>swinging with %1 duty to and fro</source>
        <translation>oscilando con ciclo %1 de un lado a otro</translation>
    </message>
    <message>
        <source>the %1 gains of the first model did not: %2</source>
        <translation>las ganancias «%1» del primer modelo no lo hicieron: %2</translation>
    </message>
    <message>
        <source>the gain is known within %1, at most 15 %</source>
        <translation>la ganancia se conoce con ±%1, como máximo 15 %</translation>
    </message>
    <message>
        <source>the motor did not swing evenly under a duty that changes its sign</source>
        <translation>el motor no osciló de manera uniforme con un ciclo que cambia de signo</translation>
    </message>
    <message>
        <source>their model was corrected by a step, %1</source>
        <translation>un escalón corrigió su modelo, %1</translation>
    </message>
    <message>
        <source>there is no room for pushes that last</source>
        <translation>no hay sitio para empujes que duren</translation>
    </message>
    <message>
        <source>there was no room for long pushes; under %1 duty to and fro it swings by %2 counts every %3, the periods differ by %4, at most 10 %</source>
        <translation>no había sitio para empujes largos; con ciclo %1 de un lado a otro oscila %2 cuentas cada %3, los períodos difieren en %4, como máximo 10 %</translation>
    </message>
    <message>
        <source>this unit is for motors of more current</source>
        <translation>este equipo es para motores de más corriente</translation>
    </message>
    <message>
        <source>%1 %2 is unusual: %3 units have %4 to %5</source>
        <translation>%1 %2 es inusual: %3 equipos tienen de %4 a %5</translation>
    </message>
    <message>
        <source>%1 besides those of the recipe differ from the backup</source>
        <translation>%1 además de los de la receta difieren de la copia de seguridad</translation>
    </message>
    <message>
        <source>%1 of %2 written</source>
        <translation>%1 de %2 escritos</translation>
    </message>
    <message>
        <source>%1 pages, %2 sent again</source>
        <translation>%1 páginas, %2 enviadas de nuevo</translation>
    </message>
    <message>
        <source>%1 settings</source>
        <translation>%1 ajustes</translation>
    </message>
    <message>
        <source>1 setting</source>
        <translation>1 ajuste</translation>
    </message>
    <message>
        <source>all numbers are used up, the highest is %1</source>
        <translation>todos los números están asignados, el más alto es %1</translation>
    </message>
    <message>
        <source>already %1</source>
        <translation>ya %1</translation>
    </message>
    <message>
        <source>backup</source>
        <translation>copia de seguridad</translation>
    </message>
    <message>
        <source>done</source>
        <translation>terminado</translation>
    </message>
    <message>
        <source>firmware</source>
        <translation>firmware</translation>
    </message>
    <message>
        <source>firmware %1</source>
        <translation>firmware %1</translation>
    </message>
    <message>
        <source>its flash has it</source>
        <translation>está en su flash</translation>
    </message>
    <message>
        <source>no version is told</source>
        <translation>no indica ninguna versión</translation>
    </message>
    <message>
        <source>not kept: there is no notebook</source>
        <translation>no se guardó: no hay cuaderno</translation>
    </message>
    <message>
        <source>nothing can be read in the bootloader</source>
        <translation>en el cargador de arranque no se puede leer nada</translation>
    </message>
    <message>
        <source>nothing had to be stored</source>
        <translation>no hubo que guardar nada</translation>
    </message>
    <message>
        <source>number</source>
        <translation>número</translation>
    </message>
    <message>
        <source>number %1</source>
        <translation>número %1</translation>
    </message>
    <message>
        <source>number %1, as before</source>
        <translation>número %1, como antes</translation>
    </message>
    <message>
        <source>parameters</source>
        <translation>parámetros</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>superado</translation>
    </message>
    <message>
        <source>preflight</source>
        <translation>comprobación previa</translation>
    </message>
    <message>
        <source>proof</source>
        <translation>prueba</translation>
    </message>
    <message>
        <source>read back</source>
        <translation>leído de vuelta</translation>
    </message>
    <message>
        <source>self-test</source>
        <translation>autoprueba</translation>
    </message>
    <message>
        <source>snapshot %1 has %2 values</source>
        <translation>la instantánea %1 tiene %2 valores</translation>
    </message>
    <message>
        <source>within its limits</source>
        <translation>dentro de sus límites</translation>
    </message>
    <message>
        <source>%1 is for no unit that is here and takes firmware over its own link</source>
        <translation>%1 no es para ningún equipo presente que reciba firmware por su propio enlace</translation>
    </message>
    <message>
        <source>%1 is not open, or something runs there</source>
        <translation>%1 no está abierto, o algo se ejecuta allí</translation>
    </message>
    <message>
        <source>for the others write a recipe that names the way in</source>
        <translation>para los demás escriba una receta que indique la vía de entrada</translation>
    </message>
    <message>
        <source>open it, or end what runs there first</source>
        <translation>ábralo, o termine antes lo que se ejecuta allí</translation>
    </message>
    <message>
        <source>this unit was never served, so there is nothing for a label</source>
        <translation>este equipo nunca fue atendido, así que no hay nada para una etiqueta</translation>
    </message>
    <message>
        <source>units are served here; the link stays open</source>
        <translation>aquí se atienden equipos; el enlace sigue abierto</translation>
    </message>
    <message>
        <source>write a page</source>
        <translation>escriba una página</translation>
    </message>
    <message>
        <source>does not answer</source>
        <translation>no responde</translation>
    </message>
    <message>
        <source>hold Arm, then put it on again</source>
        <translation>mantenga Armar y vuelva a conectarlo</translation>
    </message>
    <message>
        <source>it was cut off at &apos;%1&apos; and does not answer any more</source>
        <translation>se interrumpió en «%1» y ya no responde</translation>
    </message>
    <message>
        <source>left before the station was armed</source>
        <translation>se salió antes de armar la estación</translation>
    </message>
    <message>
        <source>look at cable and supply; when it answers again it is served from the beginning</source>
        <translation>revise el cable y la alimentación; cuando responda se atenderá desde el principio</translation>
    </message>
    <message>
        <source>the unit was taken off while it waited for the station to be armed</source>
        <translation>se retiró el equipo mientras esperaba a que se armara la estación</translation>
    </message>
    <message>
        <source>waits until the station is armed</source>
        <translation>espera a que se arme la estación</translation>
    </message>
    <message>
        <source>a step of %1 stands in noise of %2, at most %3; the mean of %4 tells it</source>
        <translation>un escalón de %1 está en un ruido de %2, como máximo %3; la media de %4 lo muestra</translation>
    </message>
    <message>
        <source>on the model as these steps have corrected it, other gains leave less error; now those</source>
        <translation>en el modelo tal como estos escalones lo han corregido, otras ganancias dejan menos error; ahora esas</translation>
    </message>
    <message>
        <source>those that were proven first left more error, these leave %1 of it</source>
        <translation>las que se probaron primero dejaban más error, estas dejan el %1 de él</translation>
    </message>
    <message>
        <source>their model was corrected by those that were proven first, which left no clearly more error</source>
        <translation>su modelo se corrigió con las que se probaron primero, que no dejaban claramente más error</translation>
    </message>
    <message>
        <source>a chunk of it is damaged</source>
        <translation>un bloque está dañado</translation>
    </message>
    <message>
        <source>a chunk of it is larger than %1 MB</source>
        <translation>un bloque supera %1 MB</translation>
    </message>
    <message>
        <source>its chunks are packed by &apos;%1&apos;; zstd and lz4 are known</source>
        <translation>sus bloques están comprimidos con &apos;%1&apos;; se conocen zstd y lz4</translation>
    </message>
    <message>
        <source>messages in JSON can be read, and what this program wrote</source>
        <translation>se pueden leer mensajes en JSON y lo que escribió este programa</translation>
    </message>
    <message>
        <source>--theme takes dark, light, contrast or system</source>
        <translation>--theme admite dark, light, contrast o system</translation>
    </message>
    <message>
        <source>give an .mcap with messages in JSON or of this program, a .csv, or the output of watch</source>
        <translation>indique un .mcap con mensajes JSON o de este programa, un .csv, o la salida de watch</translation>
    </message>
    <message>
        <source>overshoot %1, not settled</source>
        <translation>sobreimpulso %1, sin asentarse</translation>
    </message>
    <message>
        <source>overshoot %1, settled in %2</source>
        <translation>sobreimpulso %1, asentado en %2</translation>
    </message>
    <message>
        <source>seed, loss, bitrate and fault are known</source>
        <translation>se conocen seed, loss, bitrate y fault</translation>
    </message>
    <message>
        <source>within its limits, at attempt %1: samples were lost before</source>
        <translation>dentro de sus límites, en el intento %1: antes se perdieron muestras</translation>
    </message>
    <message>
        <source>its speed goes on swinging by %1 where it should rest, whole counts alone would make %2</source>
        <translation>su velocidad sigue oscilando un %1 donde debería reposar, las cuentas enteras por sí solas darían %2</translation>
    </message>
    <message>
        <source>a count or their largest error makes more output than it may</source>
        <translation>un incremento o su mayor error produce más salida de la permitida</translation>
    </message>
    <message>
        <source>the gains that were there may leave as little error; now those</source>
        <translation>las ganancias que había quizá dejen igual de poco error; ahora esas</translation>
    </message>
    <message>
        <source>their largest sensitivity is %1, at most %2 are allowed, and %3 with more gain and delay</source>
        <translation>su mayor sensibilidad es %1, se permite %2 como máximo, y %3 con más ganancia y retardo</translation>
    </message>
    <message>
        <source>there was no time to compare them with those that were there</source>
        <translation>no hubo tiempo de compararlas con las que había</translation>
    </message>
    <message>
        <source>they would draw more current than is allowed</source>
        <translation>consumirían más corriente de la permitida</translation>
    </message>
    <message>
        <source>they would overshoot by %1</source>
        <translation>sobrepasarían en un %1</translation>
    </message>
    <message>
        <source>those that were found left more error: these, which were there, leave %1 of it</source>
        <translation>las halladas dejaban más error: estas, que ya había, dejan el %1 de él</translation>
    </message>
    <message>
        <source>those that were there leave more error</source>
        <translation>las que había dejan más error</translation>
    </message>
    <message>
        <source>those that were there would leave less error, but are not for keeping: %1</source>
        <translation>las que había dejarían menos error, pero no son para conservarlas: %1</translation>
    </message>
    <message>
        <source>what is left over is much of so small steps; the same with larger ones</source>
        <translation>lo que sobra es mucho para escalones tan pequeños; lo mismo con otros mayores</translation>
    </message>
    <message>
        <source>what was there is not known, and these were not compared with it</source>
        <translation>no se sabe qué había, y estas no se compararon con ello</translation>
    </message>
    <message>
        <source>bus voltage</source>
        <translation>tensión de bus</translation>
    </message>
    <message>
        <source>direction</source>
        <translation>sentido</translation>
    </message>
    <message>
        <source>energy</source>
        <translation>energía</translation>
    </message>
    <message>
        <source>foreign master</source>
        <translation>otro maestro</translation>
    </message>
    <message>
        <source>interrupted</source>
        <translation>interrumpido</translation>
    </message>
    <message>
        <source>lateness</source>
        <translation>retraso</translation>
    </message>
    <message>
        <source>link</source>
        <translation>enlace</translation>
    </message>
    <message>
        <source>missing guardian</source>
        <translation>sin vigilante</translation>
    </message>
    <message>
        <source>no motion</source>
        <translation>sin movimiento</translation>
    </message>
    <message>
        <source>oscillation</source>
        <translation>oscilación</translation>
    </message>
    <message>
        <source>refusal</source>
        <translation>rechazo</translation>
    </message>
    <message>
        <source>restart</source>
        <translation>reinicio</translation>
    </message>
    <message>
        <source>sleep</source>
        <translation>suspensión</translation>
    </message>
    <message>
        <source>temperature</source>
        <translation>temperatura</translation>
    </message>
    <message>
        <source>time</source>
        <translation>tiempo</translation>
    </message>
    <message>
        <source>user</source>
        <translation>usuario</translation>
    </message>
    <message>
        <source>a step would draw too much current: the unit&apos;s own profile leads, at %1 counts/s at most</source>
        <translation>un escalón tomaría demasiada corriente: guía el propio perfil del equipo, a %1 counts/s como máximo</translation>
    </message>
    <message>
        <source>allow more travel, duty or current</source>
        <translation>permita más recorrido, ciclo o corriente</translation>
    </message>
    <message>
        <source>an answer was lost; the same again</source>
        <translation>se perdió una respuesta; lo mismo otra vez</translation>
    </message>
    <message>
        <source>friction takes %1 of what its current limit and its room allow, at most 60 %</source>
        <translation>la fricción toma %1 de lo que permiten su límite de corriente y su recorrido, como máximo 60 %</translation>
    </message>
    <message>
        <source>friction takes more than half of what P makes of a step</source>
        <translation>la fricción toma más de la mitad de lo que P hace de un escalón</translation>
    </message>
    <message>
        <source>its own profile leads there at %1 counts/s</source>
        <translation>su propio perfil guía hasta allí, a %1 counts/s</translation>
    </message>
    <message>
        <source>see whether the motor is too strong for this unit</source>
        <translation>compruebe si el motor es demasiado fuerte para este equipo</translation>
    </message>
    <message>
        <source>the unit&apos;s own profile led at %1 counts/s, for a step would draw too much current</source>
        <translation>guió el propio perfil del equipo a %1 counts/s, pues un escalón tomaría demasiada corriente</translation>
    </message>
    <message>
        <source>at most %1 duty, %2 counts/s and %3 counts from where it stands</source>
        <translation>como máximo ciclo %1, %2 counts/s y %3 cuentas desde donde está</translation>
    </message>
    <message>
        <source>first its direction is checked: %1 counts up</source>
        <translation>primero se comprueba su sentido: %1 cuentas hacia arriba</translation>
    </message>
    <message>
        <source>its loop takes its velocity every %1 ms, every %2 ms was expected</source>
        <translation>su lazo toma la velocidad cada %1 ms, se esperaba cada %2 ms</translation>
    </message>
    <message>
        <source>perhaps its D acts the other way round than in the firmware that is known</source>
        <translation>quizá su D actúa al revés que en el firmware conocido</translation>
    </message>
    <message>
        <source>see which firmware it runs</source>
        <translation>mire qué firmware ejecuta</translation>
    </message>
    <message>
        <source>a regression of mean speeds makes the lag %1, %2 beside what was fitted</source>
        <translation>una regresión de velocidades medias da una constante de tiempo de %1, %2 respecto al ajuste</translation>
    </message>
    <message>
        <source>F is 0: in a position loop it would push by where the target lies, not by how far it is</source>
        <translation>F es 0: en un lazo de posición empujaría según dónde está el objetivo, no según lo lejos que está</translation>
    </message>
    <message>
        <source>F is 0: with an integral both would give what friction and speed take, and it would overshoot</source>
        <translation>F es 0: junto con una integral ambos darían lo que piden la fricción y la velocidad, y habría sobreimpulso</translation>
    </message>
    <message>
        <source>it is %1</source>
        <translation>es %1</translation>
    </message>
    <message>
        <source>number %1 has another session</source>
        <translation>el número %1 tiene otra sesión</translation>
    </message>
    <message>
        <source>chatter of the duty</source>
        <translation>agitación del ciclo</translation>
    </message>
    <message>
        <source>encoder</source>
        <translation>encoder</translation>
    </message>
    <message>
        <source>error at rest</source>
        <translation>error en reposo</translation>
    </message>
    <message>
        <source>friction</source>
        <translation>fricción</translation>
    </message>
    <message>
        <source>gain</source>
        <translation>ganancia</translation>
    </message>
    <message>
        <source>noise</source>
        <translation>ruido</translation>
    </message>
    <message>
        <source>overshoot</source>
        <translation>sobreimpulso</translation>
    </message>
    <message>
        <source>peak current</source>
        <translation>pico de corriente</translation>
    </message>
    <message>
        <source>resistance</source>
        <translation>resistencia</translation>
    </message>
    <message>
        <source>rise</source>
        <translation>subida</translation>
    </message>
    <message>
        <source>settle</source>
        <translation>estabilización</translation>
    </message>
    <message>
        <source>time at the duty limit</source>
        <translation>tiempo en el límite del ciclo</translation>
    </message>
    <message>
        <source>undershoot</source>
        <translation>subimpulso</translation>
    </message>
    <message>
        <source>%1 was cleared but reads %2</source>
        <translation>%1 se borró pero se lee %2</translation>
    </message>
    <message>
        <source>%1: unknown key %2</source>
        <translation>%1: clave desconocida %2</translation>
    </message>
    <message>
        <source>%1; the gains of the axis were not known, and are now those that the board starts with</source>
        <translation>%1; no se conocían las ganancias del eje, y ahora son aquellas con las que arranca la placa</translation>
    </message>
    <message>
        <source>correct it, or delete its row</source>
        <translation>corríjala o borre su fila</translation>
    </message>
    <message>
        <source>its cause is there again, or still</source>
        <translation>su causa está presente de nuevo, o todavía</translation>
    </message>
    <message>
        <source>the gains of axis %1 are not known here: it will be left with those that the board starts with</source>
        <translation>aquí no se conocen las ganancias del eje %1: al final quedará con aquellas con las que arranca la placa</translation>
    </message>
    <message>
        <source>the gains of this loop are not known here, so its target begins within %1 of where it is, and goes further as its output is seen to allow it; write its p, d and divisor once</source>
        <translation>aquí no se conocen las ganancias de este lazo, así que su destino empieza a menos de %1 de donde está, y avanza a medida que se ve que su salida lo permite; escriba una vez su p, su d y su divisor</translation>
    </message>
    <message>
        <source>write &quot;value&quot; or &quot;raw&quot;</source>
        <translation>escriba «value» o «raw»</translation>
    </message>
    <message>
        <source>%1 duty makes the motor quicker than %2 counts/s, which are allowed</source>
        <translation>con un ciclo de trabajo del %1 el motor va más rápido que los %2 counts/s permitidos</translation>
    </message>
    <message>
        <source>&apos;sqlite3 %1 .recover&apos; tells what it still holds; where it is moved away, a new one is begun</source>
        <translation>&apos;sqlite3 %1 .recover&apos; muestra lo que aún contiene; si se aparta, se empieza uno nuevo</translation>
    </message>
    <message>
        <source>another program holds it: try again when that has ended</source>
        <translation>otro programa lo tiene en uso: vuelva a intentarlo cuando haya terminado</translation>
    </message>
    <message>
        <source>look whether its disk is there, has room and is in order</source>
        <translation>compruebe que su disco está presente, tiene espacio y está en buen estado</translation>
    </message>
    <message>
        <source>make room on its disk</source>
        <translation>libere espacio en su disco</translation>
    </message>
    <message>
        <source>%1: its value is in &apos;%2&apos;, its unit is &apos;%3&apos;</source>
        <translation>%1: su valor está en «%2», su unidad es «%3»</translation>
    </message>
    <message>
        <source>write it in that unit</source>
        <translation>escríbalo en esa unidad</translation>
    </message>
    <message>
        <source>a line has more than %1 bytes</source>
        <translation>una línea tiene más de %1 bytes</translation>
    </message>
    <message>
        <source>allow more duty, speed or travel</source>
        <translation>permita más ciclo, velocidad o recorrido</translation>
    </message>
    <message>
        <source>it came to %1 of its step while that was held</source>
        <translation>solo llegó a %1 de su escalón mientras este se mantuvo</translation>
    </message>
    <message>
        <source>the pushes that its limits leave hardly moved the motor</source>
        <translation>los empujes que dejan sus límites apenas movieron el motor</translation>
    </message>
    <message>
        <source>it may rest %1 short of its target until its integral has overcome friction</source>
        <translation>puede quedar %1 antes de su destino hasta que su integral haya vencido el rozamiento</translation>
    </message>
    <message>
        <source>%1 has restarted and did not say yet whether it is the same unit</source>
        <translation>%1 se ha reiniciado y aún no ha indicado si es la misma unidad</translation>
    </message>
    <message>
        <source>another unit stands in its place by now</source>
        <translation>en su lugar hay ahora otra unidad</translation>
    </message>
    <message>
        <source>look at what it says, then order it again</source>
        <translation>mire lo que indica y vuelva a dar la orden</translation>
    </message>
    <message>
        <source>compile an offset of its own, 1 … 99, into its firmware, or leave it alone on the bus</source>
        <translation>compile en su firmware un offset propio, 1 … 99, o déjelo solo en el bus</translation>
    </message>
    <message>
        <source>what is sent to offset 0 is done by every drive of the bus, and others answer on this one</source>
        <translation>lo que se envía al offset 0 lo ejecutan todos los accionamientos del bus, y en este responden otros</translation>
    </message>
    <message>
        <source>the board is told to tell its whole counters; look at the position, and run it again</source>
        <translation>se ha pedido a la placa que dé sus contadores completos; mire la posición y vuelva a ejecutarlo</translation>
    </message>
    <message>
        <source>%1 settings were written and cannot be read back</source>
        <translation>se escribieron %1 ajustes que no pueden volver a leerse</translation>
    </message>
    <message>
        <source>1 setting was written and cannot be read back</source>
        <translation>se escribió 1 ajuste que no puede volver a leerse</translation>
    </message>
    <message>
        <source>put it on again, and do it again</source>
        <translation>vuelva a conectarlo y hágalo otra vez</translation>
    </message>
    <message>
        <source>the unit was taken off while it waited for a number</source>
        <translation>la unidad se retiró mientras esperaba un número</translation>
    </message>
    <message>
        <source>%1 is not told as often as was asked for: %2</source>
        <translation>%1 no se comunica con la frecuencia pedida: %2</translation>
    </message>
    <message>
        <source>%1: the gains were not put back: %2</source>
        <translation>%1: las ganancias no se restablecieron: %2</translation>
    </message>
    <message>
        <source>let it come to rest first</source>
        <translation>deje que se detenga primero</translation>
    </message>
    <message>
        <source>no position for %1</source>
        <translation>sin posición desde hace %1</translation>
    </message>
    <message>
        <source>the gains were not put back: %1</source>
        <translation>las ganancias no se restablecieron: %1</translation>
    </message>
    <message>
        <source>the gains were not put back: %1; they are offered at the next connection</source>
        <translation>las ganancias no se restablecieron: %1; se ofrecerán en la próxima conexión</translation>
    </message>
    <message>
        <source>the shaft still turns, so nobody can tell which way it is pushed</source>
        <translation>el eje aún gira, así que no se puede saber hacia dónde se empuja</translation>
    </message>
    <message>
        <source>the stop was not confirmed by %1</source>
        <translation>%1 no confirmó la parada</translation>
    </message>
    <message>
        <source>what was proven could not be written: %1</source>
        <translation>lo comprobado no se pudo escribir: %1</translation>
    </message>
    <message>
        <source>what was proven could not be written: %1; what was there before is in force again</source>
        <translation>lo comprobado no se pudo escribir: %1; vuelve a estar en vigor lo que había antes</translation>
    </message>
    <message>
        <source>what was proven could not be written: %1; what was there before was not put back: %2; it is offered at the next connection</source>
        <translation>lo comprobado no se pudo escribir: %1; lo que había antes no se restableció: %2; se ofrecerá en la próxima conexión</translation>
    </message>
    <message>
        <source>a duty that grew to %1 did not move the motor both ways</source>
        <translation>un ciclo que creció hasta %1 no movió el motor en ambos sentidos</translation>
    </message>
    <message>
        <source>it lets go at %1 forwards and %2 backwards, known within %3, and takes %4 and %5 while it turns (R² %6)</source>
        <translation>se suelta con %1 hacia delante y %2 hacia atrás, conocido con ±%3, y requiere %4 y %5 mientras gira (R² %6)</translation>
    </message>
    <message>
        <source>pushing with a duty that grows to %1 in %2 s</source>
        <translation>empujando con un ciclo que crece hasta %1 en %2 s</translation>
    </message>
    <message>
        <source>there is no room for a duty that grows slowly</source>
        <translation>no hay sitio para un ciclo que crezca despacio</translation>
    </message>
    <message>
        <source>%1 has a time that is more than 140 years from 1970</source>
        <translation>%1 tiene una hora a más de 140 años de 1970</translation>
    </message>
    <message>
        <source>record with the clock set</source>
        <translation>grabe con el reloj ajustado</translation>
    </message>
    <message>
        <source>an experiment on it has not ended</source>
        <translation>un ensayo con él aún no ha terminado</translation>
    </message>
    <message>
        <source>begin a queue first</source>
        <translation>empiece antes una cola</translation>
    </message>
    <message>
        <source>firmware is written to a unit here; the link stays open</source>
        <translation>aquí se escribe firmware en un equipo; el enlace sigue abierto</translation>
    </message>
    <message>
        <source>it has passed</source>
        <translation>ha pasado</translation>
    </message>
    <message>
        <source>it is being served, or waits for its turn</source>
        <translation>se está atendiendo o espera su turno</translation>
    </message>
    <message>
        <source>it is not armed, or moves</source>
        <translation>no está armado, o se mueve</translation>
    </message>
    <message>
        <source>it is not in the queue</source>
        <translation>no está en la cola</translation>
    </message>
    <message>
        <source>it was taken off</source>
        <translation>se ha retirado</translation>
    </message>
    <message>
        <source>nothing is served here</source>
        <translation>aquí no se atiende nada</translation>
    </message>
    <message>
        <source>put it on again; it gets a row of its own</source>
        <translation>vuelva a conectarlo; tendrá una fila propia</translation>
    </message>
    <message>
        <source>take it off and put it on again to serve it once more</source>
        <translation>retírelo y vuelva a conectarlo para atenderlo otra vez</translation>
    </message>
    <message>
        <source>wait until it has, or stop it</source>
        <translation>espere a que termine, o deténgalo</translation>
    </message>
    <message>
        <source>wait until it is done, or cancel it</source>
        <translation>espere a que termine, o cancélelo</translation>
    </message>
    <message>
        <source>after a move with a velocity or a profile it is not known from where this distance counts</source>
        <translation>después de un movimiento con velocidad o perfil no se sabe desde dónde cuenta esta distancia</translation>
    </message>
    <message>
        <source>avrdude read back all %1 bytes and they are equal, but the port is away</source>
        <translation>avrdude ha releído los %1 bytes y son iguales, pero el puerto ya no está</translation>
    </message>
    <message>
        <source>halt it first, or give a position</source>
        <translation>deténgalo primero o indique una posición</translation>
    </message>
    <message>
        <source>restart the unit: its old firmware is still there</source>
        <translation>reinicie la unidad: su firmware anterior sigue ahí</translation>
    </message>
    <message>
        <source>the drive may hold half a program, and runs again once an update has succeeded</source>
        <translation>el accionamiento puede tener medio programa y volverá a funcionar cuando una actualización termine bien</translation>
    </message>
    <message>
        <source>the motor may be %1 counts from where its loop holds it, and with this P that overflows</source>
        <translation>el motor puede estar a %1 cuentas de donde su lazo lo mantiene, y con esta P eso desborda</translation>
    </message>
    <message>
        <source>another adapter has this name now; what was found on the one before is not in the list any more</source>
        <translation>otro adaptador tiene ahora este nombre; lo encontrado en el anterior ya no está en la lista</translation>
    </message>
    <message>
        <source>another adapter is called %1 now</source>
        <translation>ahora otro adaptador se llama %1</translation>
    </message>
    <message>
        <source>close the link, and open it again to see who is there</source>
        <translation>cierre el enlace y ábralo de nuevo para ver quién está ahí</translation>
    </message>
    <message>
        <source>another unit answers as number %1: serial number &apos;%2&apos; instead of &apos;%3&apos;</source>
        <translation>otro equipo responde con el número %1: número de serie «%2» en lugar de «%3»</translation>
    </message>
    <message>
        <source>scan again, and update it if it is the one that is meant</source>
        <translation>busque de nuevo y actualícelo si es el deseado</translation>
    </message>
    <message>
        <source>the unit with number %1 has another session than before, and may be another unit: its serial number was not known</source>
        <translation>el equipo con el número %1 tiene otra sesión que antes y puede ser otro equipo: no se conocía su número de serie</translation>
    </message>
    <message>
        <source>begin it once more to serve this unit again</source>
        <translation>empiécela de nuevo para volver a tratar este equipo</translation>
    </message>
    <message>
        <source>the queue was ended</source>
        <translation>la cola se terminó</translation>
    </message>
    <message>
        <source>%1 has more than %2 MB that are no samples</source>
        <translation>%1 tiene más de %2 MB que no son muestras</translation>
    </message>
    <message>
        <source>%1 was taken away; what memory still has of it is recorded anew</source>
        <translation>%1 ha desaparecido; lo que la memoria aún tiene se graba de nuevo</translation>
    </message>
    <message>
        <source>leave that folder where it is</source>
        <translation>deje esa carpeta donde está</translation>
    </message>
    <message>
        <source>the file was deleted while it was written</source>
        <translation>el archivo fue borrado mientras se escribía</translation>
    </message>
    <message>
        <source>write it anew</source>
        <translation>escríbalo de nuevo</translation>
    </message>
    <message>
        <source>the kernel does not say what %1 is: a driver holds it up</source>
        <translation>el núcleo no dice qué es %1: un controlador lo retiene</translation>
    </message>
    <message>
        <source>unplug the adapter and plug it in again</source>
        <translation>desenchufe el adaptador y vuelva a enchufarlo</translation>
    </message>
    <message>
        <source>its velocity loop begins with the mean speed since it ran last: from %1 to %2 counts/s, with the speed of now, is so much that with its gains the output would turn to full reverse</source>
        <translation>su lazo de velocidad empieza con la velocidad media desde que funcionó por última vez: de %1 a %2 counts/s, con la velocidad de ahora, es tanto que con sus ganancias la salida pasaría a plena marcha atrás</translation>
    </message>
    <message>
        <source>stop the motor and let it stand for a while, or lower p</source>
        <translation>pare el motor y déjelo quieto un rato, o reduzca p</translation>
    </message>
    <message>
        <source>stop the motor and let it stand for a while, or write p, d and divisor of the loop once</source>
        <translation>pare el motor y déjelo quieto un rato, o escriba una vez p, d y divisor del lazo</translation>
    </message>
    <message>
        <source>%1 has restarted, and nobody has looked at it since</source>
        <translation>%1 se ha reiniciado y nadie lo ha mirado desde entonces</translation>
    </message>
    <message>
        <source>Answers with offset %1 are destroyed on the bus, as where several drives have it and answer at once; offsets are compiled into the firmware, so give one of them another and flash it.</source>
        <translation>Las respuestas con el offset %1 se destruyen en el bus, como donde varios accionamientos lo tienen y responden a la vez; los offsets están compilados en el firmware, así que dé otro a uno de ellos y grábelo.</translation>
    </message>
    <message>
        <source>the notebook may offer to put back what was there before: %1</source>
        <translation>es posible que el cuaderno ofrezca restablecer lo que había antes: %1</translation>
    </message>
    <message>
        <source>turn its shaft until its position is %1 counts away from 0, which shows that it was off, then switch it off and on</source>
        <translation>gire su eje hasta que su posición esté a %1 cuentas de 0, lo que mostrará que estuvo apagado; después apáguelo y enciéndalo</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be above 0 and at most %2</source>
        <translation>«%1» debe ser mayor que 0 y como máximo %2</translation>
    </message>
    <message>
        <source>nothing was written, because what is there cannot be kept: %1</source>
        <translation>no se ha escrito nada, porque no se puede conservar lo que hay: %1</translation>
    </message>
    <message>
        <source>where it is left out the unit&apos;s own limit serves</source>
        <translation>si se omite, rige el límite propio de la unidad</translation>
    </message>
    <message>
        <source>its number holds from its next power cycle on, and nothing proves it before</source>
        <translation>su número rige desde el próximo ciclo de alimentación, y nada lo demuestra antes</translation>
    </message>
    <message>
        <source>put it back first, as &apos;motorbenchctl set %1 %2&apos; does</source>
        <translation>restablecerlo primero, como lo hace «motorbenchctl set %1 %2»</translation>
    </message>
    <message>
        <source>trial %1 did not put back what it changed</source>
        <translation>el ensayo %1 no restableció lo que cambió</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must not be empty</source>
        <translation>«%1» no debe estar vacío</translation>
    </message>
    <message>
        <source>the steps in both directions kept their limits; the gains are as they were</source>
        <translation>los escalones en ambos sentidos respetaron sus límites; las ganancias están como estaban</translation>
    </message>
    <message>
        <source>the steps in both directions kept their limits; the gains were written and read back</source>
        <translation>los escalones en ambos sentidos respetaron sus límites; las ganancias se escribieron y se releyeron</translation>
    </message>
    <message>
        <source>the steps in both directions kept their limits; the gains were written, which this family cannot read back</source>
        <translation>los escalones en ambos sentidos respetaron sus límites; las ganancias se escribieron, pero esta familia no permite releerlas</translation>
    </message>
    <message>
        <source>%1 CAN FD frames are left out, because only classic CAN is read</source>
        <translation>se omiten %1 tramas CAN FD, porque solo se lee CAN clásico</translation>
    </message>
    <message>
        <source>1 CAN FD frame is left out, because only classic CAN is read</source>
        <translation>se omite 1 trama CAN FD, porque solo se lee CAN clásico</translation>
    </message>
    <message>
        <source>a simulated board&apos;s socket has no option &apos;%1&apos;</source>
        <translation>el socket de una placa simulada no tiene la opción «%1»</translation>
    </message>
    <message>
        <source>it has pace</source>
        <translation>tiene pace</translation>
    </message>
    <message>
        <source>leave one of the two out</source>
        <translation>omita una de las dos</translation>
    </message>
    <message>
        <source>legal are 0 and 1</source>
        <translation>se admiten 0 y 1</translation>
    </message>
    <message>
        <source>link option &apos;%1&apos; is there twice</source>
        <translation>la opción «%1» del enlace aparece dos veces</translation>
    </message>
    <message>
        <source>pace=%1 is no choice</source>
        <translation>pace=%1 no es una opción</translation>
    </message>
    <message>
        <source>the last line has no end, so its frame may be cut short</source>
        <translation>la última línea no tiene fin, así que su trama puede estar cortada</translation>
    </message>
    <message>
        <source>the last line is cut off, and left out</source>
        <translation>la última línea está cortada y se omite</translation>
    </message>
    <message>
        <source>nothing proves that its flash has what was written</source>
        <translation>nada prueba que su flash tenga lo que se escribió</translation>
    </message>
    <message>
        <source>switch its supply off and on, then do it again: what is read then comes from its flash</source>
        <translation>apague y encienda su alimentación y repítalo: lo que se lea entonces viene de su flash</translation>
    </message>
    <message>
        <source>take it out of the recipe&apos;s parameters, or serve such units by a recipe of their own</source>
        <translation>quítelo de los parámetros de la receta o atienda esos equipos con una receta propia</translation>
    </message>
    <message>
        <source>take one of them off, then test the other again</source>
        <translation>retire uno de ellos y vuelva a probar el otro</translation>
    </message>
    <message>
        <source>this unit does not have %1 of the recipe</source>
        <translation>este equipo no tiene %1 de la receta</translation>
    </message>
    <message>
        <source>two units tell the serial number %1</source>
        <translation>dos equipos indican el número de serie %1</translation>
    </message>
    <message>
        <source>a stop came before it was begun</source>
        <translation>llegó una parada antes de que empezara</translation>
    </message>
    <message>
        <source>it has restarted, or a second unit has number %1: another session answers</source>
        <translation>se ha reiniciado, o un segundo equipo tiene el número %1: responde otra sesión</translation>
    </message>
    <message>
        <source>its position is being reset</source>
        <translation>su posición se está poniendo a cero</translation>
    </message>
    <message>
        <source>it did not say that it restarts, and may have done so or not</source>
        <translation>no ha dicho que se reinicia, y puede haberlo hecho o no</translation>
    </message>
    <message>
        <source>restart it once more</source>
        <translation>reinícielo una vez más</translation>
    </message>
    <message>
        <source>%1 leads to a terminal that another program serves</source>
        <translation>%1 lleva a un terminal que atiende otro programa</translation>
    </message>
    <message>
        <source>%1 takes no bytes any more</source>
        <translation>%1 ya no acepta bytes</translation>
    </message>
    <message>
        <source>a stop that is owed cannot be written down: %1 cannot be used</source>
        <translation>no se puede anotar una parada pendiente: %1 no se puede usar</translation>
    </message>
    <message>
        <source>it must be a folder of yours that nobody else may write to</source>
        <translation>debe ser una carpeta suya en la que nadie más pueda escribir</translation>
    </message>
    <message>
        <source>the simulator at %1 does not answer</source>
        <translation>el simulador en %1 no responde</translation>
    </message>
    <message>
        <source>a limit switch was met</source>
        <translation>se alcanzó un final de carrera</translation>
    </message>
    <message>
        <source>no time was left to prove others</source>
        <translation>no quedó tiempo para verificar otras</translation>
    </message>
    <message>
        <source>what these gains do is predicted, and not proven on the motor</source>
        <translation>lo que hacen estas ganancias está previsto y no verificado en el motor</translation>
    </message>
    <message>
        <source>what was there is not known, and those that were tried are in force</source>
        <translation>no se sabe lo que había, y las que se probaron están vigentes</translation>
    </message>
    <message>
        <source>its averaging was lowered, or set beyond 500, as far as can be known, and until it has lost its power once it may overwrite its own memory</source>
        <translation>su promediado se redujo o pasó de 500, hasta donde se puede saber, y mientras no haya perdido una vez la alimentación puede sobrescribir su propia memoria</translation>
    </message>
    <message>
        <source>stop the motor before its calibration is changed</source>
        <translation>pare el motor antes de cambiar su calibración</translation>
    </message>
    <message>
        <source>the power limit of axis %1 is %2: its motor gets no more</source>
        <translation>el límite de potencia del eje %1 es %2: su motor no recibe más</translation>
    </message>
    <message>
        <source>the velocity limit of axis %1 is %2: its motor goes no faster</source>
        <translation>el límite de velocidad del eje %1 es %2: su motor no va más rápido</translation>
    </message>
    <message>
        <source>write an averaging of 1 … 500, then switch it off and on</source>
        <translation>escriba un promediado de 1 … 500, luego apáguelo y enciéndalo</translation>
    </message>
    <message>
        <source>Nothing is written yet. Where OpenOCD has halted the drive already it stands still: switch it off and on</source>
        <translation>Aún no se ha escrito nada. Si OpenOCD ya detuvo el accionamiento, está parado: apáguelo y enciéndalo</translation>
    </message>
    <message>
        <source>firmware is written here, or units are served; nothing was searched</source>
        <translation>aquí se escribe firmware o se atienden unidades; no se buscó nada</translation>
    </message>
    <message>
        <source>put the programmer on it, and look at the other one</source>
        <translation>conecte el programador a ella y revise la otra</translation>
    </message>
    <message>
        <source>the programmer wrote another unit: %1 answered all the while</source>
        <translation>el programador escribió otra unidad: %1 respondió todo el tiempo</translation>
    </message>
    <message>
        <source>wait until it is done</source>
        <translation>espere a que termine</translation>
    </message>
    <message>
        <source>averaging changed: it may overwrite its memory</source>
        <translation>promediado cambiado: puede sobrescribir su memoria</translation>
    </message>
    <message>
        <source>the acceptance mask of node %1 is not known, so it may do what is sent to node %2, too; set its error.level to 0 where it is 1, then scan again</source>
        <translation>no se conoce la máscara de aceptación del nodo %1, así que quizá ejecute también lo que se envía al nodo %2; ponga su error.level a 0 si es 1 y busque de nuevo</translation>
    </message>
    <message>
        <source>All of it is written; whether the unit runs it is not known then</source>
        <translation>Todo está escrito; no se sabe entonces si el equipo funciona con ello</translation>
    </message>
    <message>
        <source>%1 settings are lost with its power</source>
        <translation>%1 ajustes se pierden al quitarle la alimentación</translation>
    </message>
    <message>
        <source>%1 settings hold from its next power cycle on, and nothing proves them before</source>
        <translation>%1 ajustes rigen desde el próximo ciclo de alimentación, y nada los demuestra antes</translation>
    </message>
    <message>
        <source>1 setting holds from its next power cycle on, and nothing proves it before</source>
        <translation>1 ajuste rige desde el próximo ciclo de alimentación, y nada lo demuestra antes</translation>
    </message>
    <message>
        <source>1 setting is lost with its power</source>
        <translation>1 ajuste se pierde al quitarle la alimentación</translation>
    </message>
    <message>
        <source>a unit whose %1 was lowered must lose its power once before its motor may be driven</source>
        <translation>una unidad cuyo %1 se redujo debe perder una vez la alimentación antes de que se pueda accionar su motor</translation>
    </message>
    <message>
        <source>leave &apos;store&apos; out: its settings are lost with its power</source>
        <translation>omita &apos;store&apos;: sus ajustes se pierden al quitarle la alimentación</translation>
    </message>
    <message>
        <source>leave it out of the file, or the self-test out of the recipe</source>
        <translation>omítalo en el archivo o quite la autoprueba de la receta</translation>
    </message>
    <message>
        <source>no link is open on which such units may be</source>
        <translation>no hay abierta ninguna conexión en la que pueda haber tales unidades</translation>
    </message>
    <message>
        <source>no unit has failed that is still there</source>
        <translation>no ha fallado ninguna unidad que siga ahí</translation>
    </message>
    <message>
        <source>open it first</source>
        <translation>ábrala primero</translation>
    </message>
    <message>
        <source>the search ends here, because firmware is written or units are served; what it found stays</source>
        <translation>la búsqueda termina aquí, porque se escribe firmware o se atienden unidades; lo encontrado se queda</translation>
    </message>
    <message>
        <source>Abstract DC Drives so old that they answer no broadcast (dialect LL) are found at this bit rate only by their number, or by %1</source>
        <translation>los Abstract DC Drive tan antiguos que no responden a ninguna difusión (dialecto LL) solo se encuentran a esta velocidad por su número, o con %1</translation>
    </message>
    <message>
        <source>interrupted before it was done</source>
        <translation>interrumpido antes de terminar</translation>
    </message>
    <message>
        <source>run it again to finish</source>
        <translation>ejecútelo de nuevo para terminar</translation>
    </message>
    <message>
        <source>the last run of %1 was begun by another program, which still runs</source>
        <translation>la última ejecución de %1 la empezó otro programa, que sigue en marcha</translation>
    </message>
    <message>
        <source>a drive of dialect LL hears its stop, too, and would be started by it</source>
        <translation>un accionamiento de dialecto LL también oye su parada y arrancaría con ella</translation>
    </message>
    <message>
        <source>coarse</source>
        <translation>grueso</translation>
    </message>
    <message>
        <source>current limit</source>
        <translation>límite de corriente</translation>
    </message>
    <message>
        <source>derivative noise</source>
        <translation>ruido de la derivada</translation>
    </message>
    <message>
        <source>did not move</source>
        <translation>no se movió</translation>
    </message>
    <message>
        <source>do it once more if it is the same</source>
        <translation>hágalo otra vez si es el mismo</translation>
    </message>
    <message>
        <source>largest error</source>
        <translation>error máximo</translation>
    </message>
    <message>
        <source>limit switch</source>
        <translation>final de carrera</translation>
    </message>
    <message>
        <source>margin</source>
        <translation>margen</translation>
    </message>
    <message>
        <source>not symmetric</source>
        <translation>no simétrico</translation>
    </message>
    <message>
        <source>ramp</source>
        <translation>rampa</translation>
    </message>
    <message>
        <source>restart needed</source>
        <translation>requiere reinicio</translation>
    </message>
    <message>
        <source>samples lost</source>
        <translation>muestras perdidas</translation>
    </message>
    <message>
        <source>saturated</source>
        <translation>saturado</translation>
    </message>
    <message>
        <source>stop not confirmed</source>
        <translation>parada no confirmada</translation>
    </message>
    <message>
        <source>stopped before its motor turned</source>
        <translation>detenido antes de que girara su motor</translation>
    </message>
    <message>
        <source>the unit tells no current in ampere: the duty limit stands in for %1 A</source>
        <translation>la unidad no indica la corriente en amperios: el límite del ciclo sustituye a %1 A</translation>
    </message>
    <message>
        <source>this place, not this unit: what is kept may be of another</source>
        <translation>este sitio, no este equipo: lo guardado puede ser de otro</translation>
    </message>
    <message>
        <source>%1 answers, and a programmer would not tell them apart: take all others off the line</source>
        <translation>%1 responde, y un programador no podría distinguirlos: quite de la línea todos los demás</translation>
    </message>
    <message>
        <source>P, I and D are divided by it. Blank flash holds 0, with which no loop works; 0 is never written. A negative divisor keeps the integral across modes: to reverse the loop, change the signs of P, I and D.</source>
        <translation>P, I y D se dividen por él. La flash en blanco contiene 0, con lo que ningún lazo funciona; 0 no se escribe nunca. Un divisor negativo conserva la integral entre modos: para invertir el lazo, cambie los signos de P, I y D.</translation>
    </message>
    <message>
        <source>Samples of 20 ms in a mean of the current, which reads wrong until so many were taken: it is changed at a standstill. Once lowered, the drive must lose its power for a moment before it is driven.</source>
        <translation>Muestras de 20 ms en una media de la corriente, que es errónea hasta que se han tomado tantas: se cambia con el motor parado. Una vez reducido, el accionamiento debe perder un momento la alimentación antes de accionarlo.</translation>
    </message>
    <message>
        <source>%1 cannot blink</source>
        <translation>%1 no puede parpadear</translation>
    </message>
    <message>
        <source>%1 has no name</source>
        <translation>%1 no tiene nombre</translation>
    </message>
    <message>
        <source>choose a free one</source>
        <translation>elija uno libre</translation>
    </message>
    <message>
        <source>lower them, or raise the divisor</source>
        <translation>redúzcalas o aumente el divisor</translation>
    </message>
    <message>
        <source>no device of %1 can have the fault &apos;%2&apos;</source>
        <translation>ningún dispositivo de %1 puede tener el fallo «%2»</translation>
    </message>
    <message>
        <source>p and d are so high for the divisor that an error of 1 turns the output to full reverse</source>
        <translation>p y d son tan grandes para el divisor que un error de 1 hace pasar la salida a plena marcha atrás</translation>
    </message>
    <message>
        <source>the motor is so far from its target that with this value the output would turn to full reverse</source>
        <translation>el motor está tan lejos de su objetivo que con este valor la salida pasaría a plena marcha atrás</translation>
    </message>
    <message>
        <source>until it has averaged once it reads a wrong current</source>
        <translation>hasta que haya promediado una vez, lee una corriente errónea</translation>
    </message>
    <message>
        <source>give --velocity, or write a lower profile.velocity</source>
        <translation>indique --velocity o escriba un profile.velocity menor</translation>
    </message>
    <message>
        <source>somebody searches here already</source>
        <translation>alguien ya busca aquí</translation>
    </message>
    <message>
        <source>%1 no longer goes back by itself: the unit was gone or has restarted</source>
        <translation>%1 ya no se restituye solo: la unidad no estaba o se ha reiniciado</translation>
    </message>
    <message>
        <source>at most %1 counts/s with its P</source>
        <translation>como máximo %1 counts/s con su P</translation>
    </message>
    <message>
        <source>its adapter has another name now; what was found under this one is not in the list any more</source>
        <translation>su adaptador tiene ahora otro nombre; lo encontrado con este ya no está en la lista</translation>
    </message>
    <message>
        <source>node %1 is on this line, too: it hears what the bootloader is told, and may be the one that is written</source>
        <translation>el nodo %1 también está en esta línea: oye lo que se dice al bootloader, y puede ser el que se escribe</translation>
    </message>
    <message>
        <source>take all others off the line and scan it, or use a programmer on the pins</source>
        <translation>quite de la línea todos los demás y busque en ella, o use un programador en los pines</translation>
    </message>
    <message>
        <source>%1 cannot be told to brake or to coast</source>
        <translation>a %1 no se le puede indicar si frena o gira libre</translation>
    </message>
    <message>
        <source>%1 cannot exchange directions</source>
        <translation>%1 no puede intercambiar sentidos</translation>
    </message>
    <message>
        <source>%1 has no limit override</source>
        <translation>%1 no puede anular límites</translation>
    </message>
    <message>
        <source>%1 has no ramp of the output in mode &apos;%2&apos;</source>
        <translation>%1 no tiene rampa de la salida en el modo «%2»</translation>
    </message>
    <message>
        <source>docs/bench.md has the options of each family, and what they take</source>
        <translation>docs/bench.md contiene las opciones de cada familia y sus valores</translation>
    </message>
    <message>
        <source>it is being recorded or replayed</source>
        <translation>se está grabando o reproduciendo</translation>
    </message>
    <message>
        <source>name a notebook that can be written</source>
        <translation>indique un cuaderno en el que se pueda escribir</translation>
    </message>
    <message>
        <source>option &apos;%1&apos; is there twice</source>
        <translation>la opción «%1» aparece dos veces</translation>
    </message>
    <message>
        <source>seed and bitrate are whole numbers, loss is a fraction below 1</source>
        <translation>seed y bitrate son números enteros, loss es una fracción menor que 1</translation>
    </message>
    <message>
        <source>the file is for family &apos;%1&apos;, the device is of &apos;%2&apos;</source>
        <translation>el archivo es para la familia «%1», el dispositivo es de «%2»</translation>
    </message>
    <message>
        <source>the rest of its disk is left to others</source>
        <translation>el resto de su disco queda para los demás</translation>
    </message>
    <message>
        <source>%1 keeps no setting without power</source>
        <translation>%1 no conserva ningún ajuste sin alimentación</translation>
    </message>
    <message>
        <source>cut its power and try again after 10 minutes, or look at it and say in the window that it stands</source>
        <translation>corte su alimentación y vuelva a intentarlo después de 10 minutos, o mírelo y confirme en la ventana que está parado</translation>
    </message>
    <message>
        <source>the motor did not move when it was sent %1 counts up (%2 counts): stalled, or the encoder is dead</source>
        <translation>el motor no se movió al enviarlo %1 cuentas hacia arriba (%2 cuentas): bloqueado o el encoder no funciona</translation>
    </message>
    <message>
        <source>see that motor and load are those of the recipe and that its time is enough, then test again</source>
        <translation>compruebe que motor y carga sean los de la receta y que su tiempo baste, y pruebe de nuevo</translation>
    </message>
    <message>
        <source>%1 is %2 of its smallest steps, fewer than %3: one of them is %4</source>
        <translation>%1 son %2 de sus pasos mínimos, menos de %3: uno de ellos es %4</translation>
    </message>
    <message>
        <source>allow more current or aim for a calmer loop</source>
        <translation>permita más corriente o busque un lazo más suave</translation>
    </message>
    <message>
        <source>any step of these gains draws more than the %1 A that are allowed</source>
        <translation>cualquier escalón con estas ganancias consume más de los %1 A permitidos</translation>
    </message>
    <message>
        <source>at most %1 duty and %2 counts from where it stands, at a speed that nobody knows yet</source>
        <translation>como máximo ciclo %1 y %2 cuentas desde donde está, a una velocidad que aún nadie conoce</translation>
    </message>
    <message>
        <source>first its direction is checked: pushes of 0.3 s, until it turns</source>
        <translation>primero se comprueba su sentido: empujes de 0,3 s, hasta que gire</translation>
    </message>
    <message>
        <source>no gains as the device stores them keep a largest sensitivity of %1 in this loop</source>
        <translation>ninguna ganancia tal como la guarda el equipo mantiene en este lazo una sensibilidad máxima de %1</translation>
    </message>
    <message>
        <source>left out before it was done</source>
        <translation>omitida antes de terminar</translation>
    </message>
    <message>
        <source>load 9 × rotor inertia · 4096 counts a turn</source>
        <translation>carga 9 × inercia del rotor · 4096 cuentas por vuelta</translation>
    </message>
    <message>
        <source>4096 counts a turn</source>
        <translation>4096 cuentas por vuelta</translation>
    </message>
    <message>
        <source>reset it without the jumper of its bootloader</source>
        <translation>reinícielo sin el puente de su bootloader</translation>
    </message>
    <message>
        <source>N20 geared</source>
        <translation>N20 con reductora</translation>
    </message>
    <message>
        <source>gear 75.81:1 · 32768 counts a turn</source>
        <translation>reductora 75,81:1 · 32768 cuentas por vuelta</translation>
    </message>
    <message>
        <source>%1; update it</source>
        <translation>%1; actualícelo</translation>
    </message>
    <message>
        <source>%1; update it, or %2</source>
        <translation>%1; actualícelo, o %2</translation>
    </message>
    <message>
        <source>nothing answers: no power, wrong wiring, another rate, or no program that runs</source>
        <translation>nada responde: sin alimentación, mal cableado, otra velocidad o ningún programa en marcha</translation>
    </message>
    <message>
        <source>stored, and the unit has proved it</source>
        <translation>guardado, y el equipo lo ha demostrado</translation>
    </message>
    <message>
        <source>the device did not write its flash within %1 s</source>
        <translation>el dispositivo no escribió su flash en %1 s</translation>
    </message>
    <message>
        <source>%1 is busy: %2</source>
        <translation>%1 está ocupado: %2</translation>
    </message>
    <message>
        <source>%1 is driven already</source>
        <translation>%1 ya se está accionando</translation>
    </message>
    <message>
        <source>%1 is not armed</source>
        <translation>%1 no está armado</translation>
    </message>
    <message>
        <source>%1 keeps its last set-point for ever: it has no watchdog</source>
        <translation>%1 conserva su última consigna para siempre: no tiene watchdog</translation>
    </message>
    <message>
        <source>assign one a new number first</source>
        <translation>asigne antes un número nuevo a uno de ellos</translation>
    </message>
    <message>
        <source>drive it from the Tune page</source>
        <translation>acciónelo desde la página Ajuste</translation>
    </message>
    <message>
        <source>halt it first</source>
        <translation>deténgalo primero</translation>
    </message>
    <message>
        <source>no %1 is known on this link, so STOP could not reach it</source>
        <translation>no se conoce ningún %1 en este enlace, así que STOP no podría alcanzarlo</translation>
    </message>
    <message>
        <source>no open CAN link is shown</source>
        <translation>no se muestra ningún enlace CAN abierto</translation>
    </message>
    <message>
        <source>open one first</source>
        <translation>abra uno primero</translation>
    </message>
    <message>
        <source>scan first</source>
        <translation>busque primero</translation>
    </message>
    <message>
        <source>select it, then hold Arm in the header</source>
        <translation>selecciónelo y mantenga pulsado Armar en la cabecera</translation>
    </message>
    <message>
        <source>they were proven by %1 steps instead of %2</source>
        <translation>se verificaron con %1 escalones en lugar de %2</translation>
    </message>
    <message>
        <source>two units answer as %1</source>
        <translation>dos equipos responden como %1</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>desconocido</translation>
    </message>
    <message>
        <source>is told no more to stop after 10 minutes: the motor may still turn, cut its power</source>
        <translation>tras 10 minutos ya no se le ordena parar: el motor podría seguir girando, corte su alimentación</translation>
    </message>
    <message>
        <source>no time was left to do the same again</source>
        <translation>no quedó tiempo para repetir lo mismo</translation>
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
        <translation>permítalo todo con poco recorrido, o ajústelo a mano con 'motorbenchctl step'</translation>
    </message>
    <message>
        <source>allow more duty or aim for a calmer loop</source>
        <translation>permita más ciclo o busque un lazo más suave</translation>
    </message>
    <message>
        <source>it may rest %1 short of its target, which its allowable error lets it</source>
        <translation>puede quedar %1 antes de su destino, lo que permite su error admisible</translation>
    </message>
    <message>
        <source>nothing of its own keeps a position loop of %1 to %2 duty</source>
        <translation>nada propio mantiene un lazo de posición de %1 en un ciclo de %2</translation>
    </message>
    <message>
        <source>others that may leave less error were given up: %1</source>
        <translation>otras que quizá dejen menos error se abandonaron: %1</translation>
    </message>
    <message>
        <source>take a larger response</source>
        <translation>tome una respuesta más larga</translation>
    </message>
    <message>
        <source>the smallest step that proves these gains puts out %1 duty, %2 are allowed, and the unit has no limit of its own that keeps it to them</source>
        <translation>el menor escalón que prueba estas ganancias da un ciclo de %1, se permiten %2, y la unidad no tiene límite propio que la mantenga en ellos</translation>
    </message>
    <message>
        <source>the smallest step that proves these gains takes %1 counts of travel, %2 are allowed</source>
        <translation>el menor escalón que prueba estas ganancias necesita %1 cuentas de recorrido, se permiten %2</translation>
    </message>
    <message>
        <source>these are given up: %1</source>
        <translation>estas se abandonan: %1</translation>
    </message>
    <message>
        <source>these gains would overshoot by %1, and at most %2 are kept</source>
        <translation>estas ganancias sobrepasarían en %1, y como máximo se conservan %2</translation>
    </message>
    <message>
        <source>they would put out more duty than is allowed</source>
        <translation>darían más ciclo del permitido</translation>
    </message>
    <message>
        <source>whether gains of an experiment are still to be put back is not known yet: %1</source>
        <translation>aún no se sabe si quedan ganancias de un ensayo por restituir: %1</translation>
    </message>
</context>
</TS>
