<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh" sourcelanguage="en">
<context>
    <name>AnalysisText</name>
    <message>
        <source>%1: peak %2 at %3 Hz</source>
        <translation>%1：%3 Hz 处峰值 %2</translation>
    </message>
    <message>
        <source>%1: fewer than 16 samples connect</source>
        <translation>%1：连续采样不足 16 个</translation>
    </message>
    <message>
        <source>the longest stretch without a gap</source>
        <translation>最长的无间断区段</translation>
    </message>
    <message>
        <source>%1 against %2</source>
        <translation>%1 对 %2</translation>
    </message>
    <message>
        <source>%1 points, every %2. sample</source>
        <translation>%1 点，每 %2 个采样取一</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 点</translation>
    </message>
    <message>
        <source>%1: peak –</source>
        <translation>%1：峰值 –</translation>
    </message>
</context>
<context>
    <name>AxisParameters</name>
    <message>
        <source>axis %1</source>
        <translation>轴 %1</translation>
    </message>
</context>
<context>
    <name>AxisText</name>
    <message>
        <source>Axis %1</source>
        <translation>轴 %1</translation>
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
        <translation>识别（闪烁）</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>重命名…</translation>
    </message>
    <message>
        <source>Assign another number…</source>
        <translation>分配其他编号…</translation>
    </message>
    <message>
        <source>Read and clear faults</source>
        <translation>读取并清除故障</translation>
    </message>
    <message>
        <source>faults read and cleared</source>
        <translation>故障已读取并清除</translation>
    </message>
    <message>
        <source>Stop and count from 0</source>
        <translation>停止并从 0 计数</translation>
    </message>
    <message>
        <source>position 0 is here; the motor is off</source>
        <translation>此处为位置 0；电机已关闭</translation>
    </message>
    <message>
        <source>Copy %1</source>
        <translation>复制%1</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation>重命名 %1</translation>
    </message>
    <message>
        <source>Name, 1 … 64 characters (some tools show only 28):</source>
        <translation>名称，1 … 64 个字符（某些工具只显示 28 个）：</translation>
    </message>
    <message>
        <source>renamed to %1</source>
        <translation>已重命名为 %1</translation>
    </message>
    <message>
        <source>Number of %1</source>
        <translation>%1 的编号</translation>
    </message>
    <message>
        <source>New number, 1 … %1. %2 is the next free one on this link:</source>
        <translation>新编号，1 … %1。%2 是此链路上下一个空闲编号：</translation>
    </message>
    <message>
        <source>number %1 is taken on this link; nothing was sent</source>
        <translation>编号 %1 在此链路上已被占用；未发送任何内容</translation>
    </message>
    <message>
        <source>answers as number %1 now</source>
        <translation>现在以编号 %1 应答</translation>
    </message>
    <message>
        <source>%1 cannot be opened: a link address has no place for the question mark in it. Rename it.</source>
        <translation>无法打开 %1：链路地址中不能包含文件名里的问号。请重命名文件。</translation>
    </message>
    <message>
        <source>blinks</source>
        <translation>闪烁</translation>
    </message>
</context>
<context>
    <name>DeviceText</name>
    <message>
        <source>%1 of %2 axes move</source>
        <translation>%2 轴中有 %1 轴在运动</translation>
    </message>
    <message>
        <source>%1 axes</source>
        <translation>%1 轴</translation>
    </message>
    <message>
        <source>No answer: %1</source>
        <translation>无应答：%1</translation>
    </message>
    <message>
        <source>The device refused: %1</source>
        <translation>设备拒绝：%1</translation>
    </message>
    <message>
        <source>Unexpected answer: %1</source>
        <translation>意外的应答：%1</translation>
    </message>
    <message>
        <source>Differs: %1</source>
        <translation>不一致：%1</translation>
    </message>
    <message>
        <source>Link lost: %1</source>
        <translation>链路丢失：%1</translation>
    </message>
    <message>
        <source>Not possible: %1</source>
        <translation>无法执行：%1</translation>
    </message>
    <message>
        <source>Cancelled</source>
        <translation>已取消</translation>
    </message>
    <message>
        <source>Not done: %1</source>
        <translation>未执行：%1</translation>
    </message>
    <message>
        <source>axis %1: %2</source>
        <translation>轴 %1：%2</translation>
    </message>
    <message>
        <source>off</source>
        <translation>关</translation>
    </message>
    <message>
        <source>duty</source>
        <translation>占空比</translation>
    </message>
    <message>
        <source>velocity</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>current</source>
        <translation>电流</translation>
    </message>
    <message>
        <source>voltage</source>
        <translation>电压</translation>
    </message>
    <message>
        <source>follow</source>
        <translation>跟随</translation>
    </message>
    <message>
        <source>profiled position</source>
        <translation>轮廓位置</translation>
    </message>
    <message>
        <source>profiled velocity</source>
        <translation>轮廓速度</translation>
    </message>
    <message>
        <source>busy</source>
        <translation>忙</translation>
    </message>
    <message>
        <source>two units, one number</source>
        <translation>两台设备，同一编号</translation>
    </message>
    <message>
        <source>no number yet</source>
        <translation>尚无编号</translation>
    </message>
    <message>
        <source>bootloader, needs firmware</source>
        <translation>处于引导程序，需要固件</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>无应答</translation>
    </message>
    <message>
        <source>online</source>
        <translation>在线</translation>
    </message>
    <message>
        <source>keeps a move</source>
        <translation>保留着一个运动</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>on</source>
        <translation>开</translation>
    </message>
    <message>
        <source>boot</source>
        <translation>引导</translation>
    </message>
    <message>
        <source>2 ×</source>
        <translation>2 ×</translation>
    </message>
    <message>
        <source>Serial number %1</source>
        <translation>序列号 %1</translation>
    </message>
    <message>
        <source>Dialect %1</source>
        <translation>方言 %1</translation>
    </message>
    <message>
        <source>It keeps a move that was stopped before it began, and would begin it with the next start on its line. A new move replaces it; switching the unit off clears it.</source>
        <translation>它保留着一个在开始之前就被停止的运动，会随其线路上的下一次启动而开始执行。新的运动会取代它；关闭设备会将其清除。</translation>
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
        <translation>无故障</translation>
    </message>
</context>
<context>
    <name>DialogText</name>
    <message>
        <source>Signals that a formula may use</source>
        <translation>公式可使用的信号</translation>
    </message>
    <message>
        <source>Double click puts the name into the formula</source>
        <translation>双击将名称插入公式</translation>
    </message>
    <message>
        <source>Note at this time</source>
        <translation>此时刻的注释</translation>
    </message>
    <message>
        <source>What happened</source>
        <translation>发生了什么</translation>
    </message>
    <message>
        <source>Add note</source>
        <translation>添加注释</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Derived signal</source>
        <translation>派生信号</translation>
    </message>
    <message>
        <source>counts/s², A, …</source>
        <translation>counts/s²、A、…</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>Formula</source>
        <translation>公式</translation>
    </message>
    <message>
        <source>+ − * / ^ ( ) · derivative(x) · integral(x) · average(x, seconds) · abs, sqrt, sin, min, max … · values are in the unit of the device</source>
        <translation>+ − * / ^ ( ) · derivative(x) · integral(x) · average(x, 秒) · abs、sqrt、sin、min、max … · 数值采用设备的单位</translation>
    </message>
    <message>
        <source>Add signal</source>
        <translation>添加信号</translation>
    </message>
    <message>
        <source>Export samples</source>
        <translation>导出采样数据</translation>
    </message>
    <message>
        <source>Stretch</source>
        <translation>区段</translation>
    </message>
    <message>
        <source>What is seen</source>
        <translation>可见范围</translation>
    </message>
    <message>
        <source>A … B</source>
        <translation>A … B</translation>
    </message>
    <message>
        <source>Whole session</source>
        <translation>整个会话</translation>
    </message>
    <message>
        <source>Show the cursors first: L</source>
        <translation>请先显示光标：L</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>信号</translation>
    </message>
    <message>
        <source>Plotted signals</source>
        <translation>已绘制的信号</translation>
    </message>
    <message>
        <source>All signals of all devices</source>
        <translation>所有设备的全部信号</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>CSV table</source>
        <translation>CSV 表格</translation>
    </message>
    <message>
        <source>MCAP recording</source>
        <translation>MCAP 记录</translation>
    </message>
    <message>
        <source>Both carry units, the devices with their parameters, notes, and how many samples were lost. MCAP opens in PlotJuggler and Foxglove.</source>
        <translation>两者都包含单位、设备及其参数、注释和丢失的采样数。MCAP 可用 PlotJuggler 和 Foxglove 打开。</translation>
    </message>
    <message>
        <source>Choose file…</source>
        <translation>选择文件…</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>表格 (*.csv)</translation>
    </message>
    <message>
        <source>MCAP recording (*.mcap)</source>
        <translation>MCAP 记录 (*.mcap)</translation>
    </message>
</context>
<context>
    <name>FileText</name>
    <message>
        <source>family “%1”</source>
        <translation>系列“%1”</translation>
    </message>
    <message>
        <source>Parameter files (*.json)</source>
        <translation>参数文件 (*.json)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>所有文件 (*)</translation>
    </message>
    <message>
        <source>Choose another file.</source>
        <translation>请选择其他文件。</translation>
    </message>
    <message>
        <source>Choose a file of this family. Nothing was changed.</source>
        <translation>请选择此系列的文件。未作任何更改。</translation>
    </message>
    <message>
        <source>Nothing was changed.</source>
        <translation>未作任何更改。</translation>
    </message>
    <message>
        <source>%1 is not a parameter file.</source>
        <translation>%1 不是参数文件。</translation>
    </message>
    <message>
        <source>Choose a file that Export… or motorbenchctl get --file wrote.</source>
        <translation>请选择由“导出…”或 motorbenchctl get --file 写出的文件。</translation>
    </message>
    <message>
        <source>%1 is for %2, which is not in this program.</source>
        <translation>%1 用于 %2，本程序不支持该系列。</translation>
    </message>
    <message>
        <source>%1 is for %2, %3 is of the family %4.</source>
        <translation>%1 用于 %2，而 %3 属于 %4 系列。</translation>
    </message>
</context>
<context>
    <name>FrameFilterParser</name>
    <message>
        <source>&apos;)&apos; has no &apos;(&apos; before it</source>
        <translation>“)”之前没有“(”</translation>
    </message>
    <message>
        <source>&apos;%1&apos; needs a term before it</source>
        <translation>“%1”之前需要一个条件项</translation>
    </message>
    <message>
        <source>a term is missing after &apos;%1&apos;</source>
        <translation>“%1”之后缺少条件项</translation>
    </message>
    <message>
        <source>&apos;(&apos; is not closed: a &apos;)&apos; is missing</source>
        <translation>“(”未闭合：缺少“)”</translation>
    </message>
    <message>
        <source>more than %1 brackets and negations inside each other</source>
        <translation>括号和否定的嵌套超过 %1 层</translation>
    </message>
</context>
<context>
    <name>FrameTermReader</name>
    <message>
        <source>&apos;%1&apos;: a comparison begins with field., such as field.%1</source>
        <translation>“%1”：比较须以 field. 开头，例如 field.%1</translation>
    </message>
    <message>
        <source>&apos;%1:&apos; has nothing after the colon</source>
        <translation>“%1:”的冒号之后没有内容</translation>
    </message>
    <message>
        <source>&apos;%1:&apos; is not known; id, family, message, device, dir, data, is and field. are</source>
        <translation>“%1:”未知；可用的有 id、family、message、device、dir、data、is 和 field.</translation>
    </message>
    <message>
        <source>&apos;%1:&apos; is not known; &apos;%2:&apos; is</source>
        <translation>“%1:”未知；可用的是“%2:”</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no identifier: hexadecimal such as 0x2061405, 0x2061* or 100..1FF</source>
        <translation>“%1”不是标识符：须为十六进制，例如 0x2061405、0x2061* 或 100..1FF</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no device number: such as 5, 5,7 or 1..9</source>
        <translation>“%1”不是设备编号：例如 5、5,7 或 1..9</translation>
    </message>
    <message>
        <source>&apos;%1&apos; are no bytes: hexadecimal such as A125*, without blanks</source>
        <translation>“%1”不是字节：须为不含空格的十六进制，例如 A125*</translation>
    </message>
    <message>
        <source>no family is called &apos;%1&apos;; there is %2</source>
        <translation>没有名为“%1”的系列；现有 %2</translation>
    </message>
    <message>
        <source>&apos;dir:%1&apos; is not known; dir:rx and dir:tx are</source>
        <translation>“dir:%1”未知；可用的有 dir:rx 和 dir:tx</translation>
    </message>
    <message>
        <source>&apos;is:%1&apos; is not known; tx, rx, extended, standard, remote, error, unknown, known and control are</source>
        <translation>“is:%1”未知；可用的有 tx、rx、extended、standard、remote、error、unknown、known 和 control</translation>
    </message>
    <message>
        <source>&apos;field.&apos; needs the name of a field, such as field.trgt&gt;100</source>
        <translation>“field.”需要字段名，例如 field.trgt&gt;100</translation>
    </message>
    <message>
        <source>&apos;field.%1%2&apos; needs a number behind it</source>
        <translation>“field.%1%2”之后需要一个数值</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no number</source>
        <translation>“%1”不是数值</translation>
    </message>
    <message>
        <source>identifier, hexadecimal</source>
        <translation>标识符，十六进制</translation>
    </message>
    <message>
        <source>what the decoder says</source>
        <translation>解码器的解释</translation>
    </message>
    <message>
        <source>a field by its name: its number, % of full scale, or that there is one</source>
        <translation>按名称指定字段：其数值、满量程的 % 或该字段是否存在</translation>
    </message>
    <message>
        <source>bytes, hexadecimal</source>
        <translation>字节，十六进制</translation>
    </message>
    <message>
        <source>direction; error, remote, extended, standard, unknown, known; makes a motor move</source>
        <translation>方向；error、remote、extended、standard、unknown、known；使电机运动</translation>
    </message>
    <message>
        <source>a bare word: part of a message, family or identifier</source>
        <translation>单独的词：消息、系列或标识符的一部分</translation>
    </message>
    <message>
        <source>terms beside each other must all hold</source>
        <translation>并列的条件项必须全部成立</translation>
    </message>
    <message>
        <source>* stands for any characters, ? for one, a comma for or.</source>
        <translation>* 代表任意字符，? 代表一个字符，逗号表示“或”。</translation>
    </message>
</context>
<context>
    <name>FrameText</name>
    <message>
        <source>remote</source>
        <translation>远程</translation>
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
        <translation>throttle × 除数 / %1</translation>
    </message>
    <message>
        <source>throttle per %1</source>
        <translation>throttle / %1</translation>
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
        <translation>间断 %1</translation>
    </message>
    <message>
        <source>%1 gaps, %2</source>
        <translation>%1 处间断，%2</translation>
    </message>
</context>
<context>
    <name>HelpTitles</name>
    <message>
        <source>First hour</source>
        <translation>入门一小时</translation>
    </message>
    <message>
        <source>Connecting</source>
        <translation>连接</translation>
    </message>
    <message>
        <source>Tuning by itself</source>
        <translation>自动整定</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>曲线图</translation>
    </message>
    <message>
        <source>Service</source>
        <translation>维护</translation>
    </message>
    <message>
        <source>Recipes</source>
        <translation>配方</translation>
    </message>
    <message>
        <source>Safety</source>
        <translation>安全</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>Troubleshooting</source>
        <translation>故障排除</translation>
    </message>
    <message>
        <source>Hardware: %1</source>
        <translation>硬件：%1</translation>
    </message>
</context>
<context>
    <name>Languages</name>
    <message>
        <source>English</source>
        <comment>the name of this language in itself</comment>
        <translation>简体中文</translation>
    </message>
    <message>
        <source>en</source>
        <comment>the code of this language, as in the name of its file</comment>
        <translation>zh</translation>
    </message>
</context>
<context>
    <name>LeapText</name>
    <message>
        <source>%1 × as large as now, %2.</source>
        <translation>为当前值的 %1 倍，%2。</translation>
    </message>
    <message>
        <source>%1 × smaller than now, %2.</source>
        <translation>缩小为当前值的 1/%1，%2。</translation>
    </message>
</context>
<context>
    <name>LinkChoices</name>
    <message>
        <source>up</source>
        <translation>已启用</translation>
    </message>
    <message>
        <source>switched off</source>
        <translation>已关闭</translation>
    </message>
    <message>
        <source>bus-off</source>
        <translation>总线关闭</translation>
    </message>
    <message>
        <source>no permission</source>
        <translation>无权限</translation>
    </message>
    <message>
        <source>not there</source>
        <translation>不存在</translation>
    </message>
    <message>
        <source>ready</source>
        <translation>就绪</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>A recording of frames…</source>
        <translation>帧记录…</translation>
    </message>
    <message>
        <source>file</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>Plays a candump or Vector ASC log as if its bus were here. Nothing can be sent.</source>
        <translation>回放 candump 或 Vector ASC 日志，如同其总线就在此处。无法发送任何内容。</translation>
    </message>
    <message>
        <source>The whole simulated bench</source>
        <translation>完整仿真台架</translation>
    </message>
    <message>
        <source>Simulated CAN bus</source>
        <translation>仿真 CAN 总线</translation>
    </message>
    <message>
        <source>Simulated serial line</source>
        <translation>仿真串行线路</translation>
    </message>
    <message>
        <source>Simulated SPI board</source>
        <translation>仿真 SPI 板卡</translation>
    </message>
    <message>
        <source>CAN interfaces</source>
        <translation>CAN 接口</translation>
    </message>
    <message>
        <source>Serial ports</source>
        <translation>串口</translation>
    </message>
    <message>
        <source>SPI devices</source>
        <translation>SPI 设备</translation>
    </message>
    <message>
        <source>Recordings</source>
        <translation>记录</translation>
    </message>
    <message>
        <source>Without hardware</source>
        <translation>无需硬件</translation>
    </message>
    <message>
        <source>Serial port</source>
        <translation>串口</translation>
    </message>
    <message>
        <source>SPI device</source>
        <translation>SPI 设备</translation>
    </message>
    <message>
        <source>CAN interface</source>
        <translation>CAN 接口</translation>
    </message>
    <message>
        <source>%1, at the real speed of their link.</source>
        <translation>%1，以其链路的真实速度运行。</translation>
    </message>
    <message>
        <source>Controllers of every family with real bus timing; nothing real can move.</source>
        <translation>所有系列的控制器，具有真实的总线时序；不会使任何真实电机运动。</translation>
    </message>
</context>
<context>
    <name>MuteUnits</name>
    <message>
        <source>Number of the unit that does not answer, %1 … %2. No other one of its family may answer there: a programmer would not tell them apart.</source>
        <translation>无应答设备的编号，%1 … %2。那里不得有同系列的其他设备应答：编程器无法区分它们。</translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <translation>%2 上的 %1</translation>
    </message>
    <message>
        <source>No link is open whose units a programmer writes</source>
        <translation>没有打开由编程器写入其设备的链路</translation>
    </message>
</context>
<context>
    <name>PlotFeed</name>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>live, %1</source>
        <translation>实时，%1</translation>
    </message>
    <message>
        <source>paused, %1</source>
        <translation>已暂停，%1</translation>
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
        <translation>A…B 平均值</translation>
    </message>
    <message>
        <source>min … max</source>
        <translation>最小 … 最大</translation>
    </message>
    <message>
        <source>%1 … %2</source>
        <translation>%1 … %2</translation>
    </message>
    <message>
        <source>σ, %1 samples</source>
        <translation>σ，%1 个采样</translation>
    </message>
    <message>
        <source>slope</source>
        <translation>斜率</translation>
    </message>
    <message>
        <source>/s</source>
        <translation>/s</translation>
    </message>
    <message>
        <source>%1 %2 to %3</source>
        <translation>%1 %2 至 %3</translation>
    </message>
    <message>
        <source>%1 no data</source>
        <translation>%1 无数据</translation>
    </message>
    <message>
        <source>, now %1</source>
        <translation>，现在 %1</translation>
    </message>
    <message>
        <source>, 1 gap</source>
        <translation>，1 处间断</translation>
    </message>
    <message numerus="yes">
        <source>, %n gaps</source>
        <translation>
            <numerusform>，%n 处间断</numerusform>
        </translation>
    </message>
    <message>
        <source>No traces</source>
        <translation>无曲线</translation>
    </message>
    <message>
        <source>Last %1: %2</source>
        <translation>最近 %1：%2</translation>
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
        <translation>撤销(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>恢复(&amp;R)</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>剪切(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>复制(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>粘贴(&amp;P)</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Select All</source>
        <translation>全选</translation>
    </message>
</context>
<context>
    <name>QPlatformTheme</name>
    <message>
        <source>OK</source>
        <translation>确定</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>帮助</translation>
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
        <translation>Shift</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>空格</translation>
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
        <translation>small</translation>
    </message>
</context>
<context>
    <name>SourceText</name>
    <message>
        <source>%1 Hz, %2 of %3 lost</source>
        <translation>%1 Hz，%3 中丢失 %2</translation>
    </message>
</context>
<context>
    <name>Stories</name>
    <message>
        <source>Select</source>
        <translation>选择</translation>
    </message>
    <message>
        <source>Click %1 in the list at the left. Everything that follows is about it.</source>
        <translation>在左侧列表中单击 %1。接下来的一切都针对它。</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>解锁</translation>
    </message>
    <message>
        <source>Hold the Arm button at the top, SAFE, for one second (or Ctrl+Shift+F12). Nothing moves before. Esc stops, always.</source>
        <translation>按住顶部的解锁按钮（“安全”）一秒钟（或按 Ctrl+Shift+F12）。在此之前不会有任何运动。Esc 随时停止。</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>阶跃</translation>
    </message>
    <message>
        <source>Tune</source>
        <translation>整定</translation>
    </message>
    <message>
        <source>Store</source>
        <translation>存储</translation>
    </message>
    <message>
        <source>Click %1 in the list at the left.</source>
        <translation>在左侧列表中单击 %1。</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>限制</translation>
    </message>
    <message>
        <source>Hold the Arm button at the top for one second (or Ctrl+Shift+F12).</source>
        <translation>按住顶部的解锁按钮一秒钟（或按 Ctrl+Shift+F12）。</translation>
    </message>
    <message>
        <source>%1 overshoots: tame it in a minute</source>
        <translation>%1 超调：一分钟内驯服它</translation>
    </message>
    <message>
        <source>velocity, set-point dashed</source>
        <translation>速度，设定值为虚线</translation>
    </message>
    <message>
        <source>%1 has no current limit: set one that saves it</source>
        <translation>%1 没有电流限制：设置一个来保护它</translation>
    </message>
    <message>
        <source>current, limit dashed</source>
        <translation>电流，限值为虚线</translation>
    </message>
    <message>
        <source>Press %2: the motor steps to a speed and back, and the overshoot is measured.</source>
        <translation>按 %2：电机阶跃到某一速度再返回，并测量超调量。</translation>
    </message>
    <message>
        <source>Press %2 on the page Design: the program finds gains and proves them. Tamed: a step overshoots by 5 % at most.</source>
        <translation>在“设计”页面按 %2：程序求出增益并加以验证。驯服的标准：阶跃超调不超过 5 %。</translation>
    </message>
    <message>
        <source>Press %2 on the page Tune: the peak current of the step stands in its table.</source>
        <translation>在“整定”页面按 %2：阶跃的峰值电流显示在表格中。</translation>
    </message>
    <message>
        <source>the button</source>
        <translation>按钮</translation>
    </message>
    <message>
        <source>Arrive</source>
        <translation>到位</translation>
    </message>
    <message>
        <source>What P makes of the last counts is less than friction. Enter among the gains %5 (a stiffer P overcomes it, and more D keeps it from swinging), and press %2 again: it rests within 5 counts of its target.</source>
        <translation>最后几个计数上 P 产生的输出小于摩擦力。在增益中输入 %5（更大的 P 能克服摩擦，更大的 D 防止振荡），再按 %2：电机停在距目标 5 个计数以内。</translation>
    </message>
    <message>
        <source>%1 stops short: make it arrive</source>
        <translation>%1 停在目标之前：让它到位</translation>
    </message>
    <message>
        <source>This one stops about %4 counts short and stays there. Make it arrive.</source>
        <translation>这台电机停在目标前约 %4 个计数处，不再移动。请让它到位。</translation>
    </message>
    <message>
        <source>position, set-point dashed</source>
        <translation>位置，设定值为虚线</translation>
    </message>
    <message>
        <source>On the page Tune choose Position: what is armed is armed for one mode. Then hold the Arm button at the top for one second (or Ctrl+Shift+F12).</source>
        <translation>在“整定”页面选择位置：解锁只对一种模式有效。然后按住顶部的解锁按钮一秒钟（或按 Ctrl+Shift+F12）。</translation>
    </message>
    <message>
        <source>Enter %3 as the target (behind ▸) and press %2: the motor goes there and back, and stops about %4 counts short.</source>
        <translation>在目标处（▸ 之后）输入 %3，然后按 %2：电机往返一次，并停在目标前约 %4 个计数处。</translation>
    </message>
    <message>
        <source>%6Press Store and prove on the page Parameters: done when the unit proves that its flash has the gains.</source>
        <translation>%6在“参数”页面按“存储并验证”：设备证实其闪存中已有这些增益即告完成。</translation>
    </message>
    <message>
        <source>On the page Parameters switch the current limit on (search: %7), set it to what the motor may have, and write.</source>
        <translation>在“参数”页面打开电流限制（搜索：%7），设为电机允许的值，然后写入。</translation>
    </message>
    <message>
        <source>%6Press Store and prove on the page Parameters.</source>
        <translation>%6在“参数”页面按“存储并验证”。</translation>
    </message>
    <message>
        <source>With these gains it goes too far. Find some with which it does not.</source>
        <translation>用这些增益它会超调。请找到不超调的增益。</translation>
    </message>
    <message>
        <source>Stalled, it draws all that its supply gives, and nothing holds it back. Limit it.</source>
        <translation>堵转时它会吸取电源能给的全部电流，没有任何限制。请加以限制。</translation>
    </message>
    <message>
        <source>It stores by itself %1 s after its last change: wait for that.</source>
        <translation>最后一次更改后 %1 s，它会自行存储：请等待。</translation>
    </message>
</context>
<context>
    <name>TriggerText</name>
    <message>
        <source>trigger armed, waiting</source>
        <translation>触发器已就绪，等待中</translation>
    </message>
    <message>
        <source>single event caught</source>
        <translation>已捕获单次事件</translation>
    </message>
    <message>
        <source>event %1, filling</source>
        <translation>事件 %1，正在填充</translation>
    </message>
    <message>
        <source>event %1, waiting for the next</source>
        <translation>事件 %1，等待下一个</translation>
    </message>
</context>
<context>
    <name>TypedFrameText</name>
    <message>
        <source>&apos;%1&apos; is no frame such as 02061405#8125</source>
        <translation>“%1”不是帧，格式例如 02061405#8125</translation>
    </message>
    <message>
        <source>The identifier is hexadecimal, such as 7FF or 02061405</source>
        <translation>标识符为十六进制，例如 7FF 或 02061405</translation>
    </message>
    <message>
        <source>%1 has more than 29 bits: at most 1FFFFFFF</source>
        <translation>%1 超过 29 位：最大为 1FFFFFFF</translation>
    </message>
    <message>
        <source>%1 has more than 11 bits: choose 29 bits</source>
        <translation>%1 超过 11 位：请选择 29 位</translation>
    </message>
    <message>
        <source>The data are pairs of hexadecimal digits, such as 81 25 11</source>
        <translation>数据为成对的十六进制数字，例如 81 25 11</translation>
    </message>
    <message>
        <source>%1 bytes: a frame has at most 8</source>
        <translation>%1 字节：一帧最多 8 字节</translation>
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
        <translation>一台已不存在的设备</translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <translation>%2 上的 %1</translation>
    </message>
</context>
<context>
    <name>ValueText</name>
    <message>
        <source>Enter %1.</source>
        <translation>请输入 %1。</translation>
    </message>
    <message>
        <source>Enter %1, or a percentage such as %2.</source>
        <translation>请输入 %1，或百分比，例如 %2。</translation>
    </message>
    <message>
        <source>%1 is above %2.</source>
        <translation>%1 高于 %2。</translation>
    </message>
    <message>
        <source>%1 is below %2.</source>
        <translation>%1 低于 %2。</translation>
    </message>
    <message>
        <source>%1 is not a whole number.</source>
        <translation>%1 不是整数。</translation>
    </message>
    <message>
        <source>A number is missing.</source>
        <translation>缺少数值。</translation>
    </message>
    <message>
        <source>“%1” is not a number.</source>
        <translation>“%1”不是数值。</translation>
    </message>
    <message>
        <source>on</source>
        <translation>开</translation>
    </message>
    <message>
        <source>off</source>
        <translation>关</translation>
    </message>
    <message>
        <source>off or on</source>
        <translation>关或开</translation>
    </message>
</context>
<context>
    <name>drawings</name>
    <message>
        <source>3.3 V only</source>
        <translation>只能用 3.3 V</translation>
    </message>
    <message>
        <source>57 600 or 115 200 bit/s</source>
        <translation>57 600 或 115 200 bit/s</translation>
    </message>
    <message>
        <source>60 A, 100 A for 2 s</source>
        <translation>60 A，2 s 内 100 A</translation>
    </message>
    <message>
        <source>A, B, index</source>
        <translation>A、B、索引</translation>
    </message>
    <message>
        <source>Battery, 12 V</source>
        <translation>电池，12 V</translation>
    </message>
    <message>
        <source>Breaker</source>
        <translation>断路器</translation>
    </message>
    <message>
        <source>Bridge and motor</source>
        <translation>桥和电机</translation>
    </message>
    <message>
        <source>CAN adapter</source>
        <translation>CAN 适配器</translation>
    </message>
    <message>
        <source>CAN high</source>
        <translation>CAN 高</translation>
    </message>
    <message>
        <source>CAN low</source>
        <translation>CAN 低</translation>
    </message>
    <message>
        <source>Drive, offset 1</source>
        <translation>驱动器，offset 1</translation>
    </message>
    <message>
        <source>Drive, offset 2</source>
        <translation>驱动器，offset 2</translation>
    </message>
    <message>
        <source>Encoder board</source>
        <translation>编码器板</translation>
    </message>
    <message>
        <source>GPIO in</source>
        <translation>GPIO 输入</translation>
    </message>
    <message>
        <source>GPIO out</source>
        <translation>GPIO 输出</translation>
    </message>
    <message>
        <source>Host</source>
        <translation>主机</translation>
    </message>
    <message>
        <source>J4 closed only for 3.3 V, before power</source>
        <translation>J4 仅在 3.3 V 时闭合，且须先于上电</translation>
    </message>
    <message>
        <source>Motor</source>
        <translation>电机</translation>
    </message>
    <message>
        <source>Motor supply</source>
        <translation>电机电源</translation>
    </message>
    <message>
        <source>P1 MISO · P2 Vcc · P3 SCK · P4 MOSI · P5 reset · P6 ground</source>
        <translation>P1 MISO · P2 Vcc · P3 SCK · P4 MOSI · P5 复位 · P6 地</translation>
    </message>
    <message>
        <source>PA4 current, PA3 heat</source>
        <translation>PA4 电流，PA3 温度</translation>
    </message>
    <message>
        <source>Pads for a programmer</source>
        <translation>编程器焊盘</translation>
    </message>
    <message>
        <source>Programmer</source>
        <translation>编程器</translation>
    </message>
    <message>
        <source>STM32F1 or F4</source>
        <translation>STM32F1 或 F4</translation>
    </message>
    <message>
        <source>Supermodified, node 4</source>
        <translation>Supermodified，节点 4</translation>
    </message>
    <message>
        <source>Supermodified, node 5</source>
        <translation>Supermodified，节点 5</translation>
    </message>
    <message>
        <source>USB to RS-485</source>
        <translation>USB 转 RS-485</translation>
    </message>
    <message>
        <source>a Raspberry Pi, say</source>
        <translation>例如 Raspberry Pi</translation>
    </message>
    <message>
        <source>and a switch</source>
        <translation>和开关，</translation>
    </message>
    <message>
        <source>closed: bootloader</source>
        <translation>闭合：引导程序</translation>
    </message>
    <message>
        <source>each its own number</source>
        <translation>各用自己的编号</translation>
    </message>
    <message>
        <source>each its own offset</source>
        <translation>各用自己的 offset</translation>
    </message>
    <message>
        <source>ground</source>
        <translation>地</translation>
    </message>
    <message>
        <source>ground in common</source>
        <translation>共地</translation>
    </message>
    <message>
        <source>ground, 3.3 V</source>
        <translation>地、3.3 V</translation>
    </message>
    <message>
        <source>motor, 6 A</source>
        <translation>电机，6 A</translation>
    </message>
    <message>
        <source>number 1 … 63</source>
        <translation>编号 1 … 63</translation>
    </message>
    <message>
        <source>on the computer</source>
        <translation>接在计算机上</translation>
    </message>
    <message>
        <source>one host only</source>
        <translation>只有一个主机</translation>
    </message>
    <message>
        <source>or a supply that</source>
        <translation>或能吸收</translation>
    </message>
    <message>
        <source>own driver</source>
        <translation>自备驱动</translation>
    </message>
    <message>
        <source>takes braking</source>
        <translation>制动能量的电源</translation>
    </message>
    <message>
        <source>transceiver at PA11, PA12</source>
        <translation>收发器在 PA11、PA12</translation>
    </message>
    <message>
        <source>up to 35 V</source>
        <translation>最高 35 V</translation>
    </message>
    <message>
        <source>with encoder</source>
        <translation>带编码器</translation>
    </message>
    <message>
        <source>within reach</source>
        <translation>伸手可及</translation>
    </message>
</context>
<context>
    <name>mb::About</name>
    <message>
        <source>About MotorBench</source>
        <translation>关于 MotorBench</translation>
    </message>
    <message>
        <source>Tunes and services brushed-DC motor controllers. Free software under the GNU General Public License, version 3 or later, without any warranty.</source>
        <translation>整定和维护有刷直流电机控制器。依据 GNU 通用公共许可证第 3 版或更高版本发布的自由软件，不提供任何担保。</translation>
    </message>
    <message>
        <source>Versions and licences</source>
        <translation>版本与许可证</translation>
    </message>
    <message>
        <source>Copy versions</source>
        <translation>复制版本信息</translation>
    </message>
</context>
<context>
    <name>mb::AddLinkDialog</name>
    <message>
        <source>Add a link</source>
        <translation>添加链路</translation>
    </message>
    <message>
        <source>Links that can be added</source>
        <translation>可添加的链路</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>链路</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>open</source>
        <translation>已打开</translation>
    </message>
    <message>
        <source>none found</source>
        <translation>未找到</translation>
    </message>
    <message>
        <source>Command for a terminal</source>
        <translation>终端命令</translation>
    </message>
    <message>
        <source>Address of the link</source>
        <translation>链路地址</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>地址</translation>
    </message>
    <message>
        <source>Open it at every start</source>
        <translation>每次启动时打开</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>打开</translation>
    </message>
    <message>
        <source>Choose the file…</source>
        <translation>选择文件…</translation>
    </message>
</context>
<context>
    <name>mb::AdvicePanel</name>
    <message>
        <source>Why it did that</source>
        <translation>为何如此</translation>
    </message>
    <message>
        <source>Stages these values; nothing is written yet.</source>
        <translation>暂存这些值；尚未写入任何内容。</translation>
    </message>
</context>
<context>
    <name>mb::AdviceText</name>
    <message>
        <source>F·K is %1 with I active: the initial lag is paid back as overshoot.</source>
        <translation>F·K 为 %1 且 I 有效：初始滞后会以超调的形式偿还。</translation>
    </message>
    <message>
        <source>It stops %1 counts short: P alone does not overcome friction there.</source>
        <translation>停在距目标 %1 个计数处：仅靠 P 无法克服那里的摩擦。</translation>
    </message>
    <message>
        <source>A gain has only %1 steps of its integer; it cannot be set finely.</source>
        <translation>某一增益的整数仅有 %1 个级差；无法精细设定。</translation>
    </message>
    <message>
        <source>One count of the sensor moves the duty by %1 % through D; 10 % is the most that is quiet.</source>
        <translation>传感器的一个计数经 D 使占空比变化 %1 %；不超过 10 % 才算平静。</translation>
    </message>
    <message>
        <source>The drive&apos;s ramp takes %1 to full duty, which is slower than this loop.</source>
        <translation>驱动器的斜坡需要 %1 才到满占空比，比此回路慢。</translation>
    </message>
    <message>
        <source>The duty was at its limit for %1: the loop cannot go faster there.</source>
        <translation>占空比处于限值达 %1：回路在此处无法更快。</translation>
    </message>
    <message>
        <source>The duty was at its limit for %1 while I went on; that is paid back as overshoot.</source>
        <translation>占空比处于限值达 %1 而 I 仍在积分；这会以超调的形式偿还。</translation>
    </message>
    <message>
        <source>The measured velocity is %1 late; the gains are too lively for that.</source>
        <translation>测得的速度滞后 %1；对此而言增益过于激进。</translation>
    </message>
    <message>
        <source>The velocity comes anew every %1 only; a loop cannot be quicker than that.</source>
        <translation>速度每 %1 才更新一次；回路不可能比这更快。</translation>
    </message>
    <message>
        <source>It moved late, at %1 % duty: friction holds it until then.</source>
        <translation>它启动较晚，占空比到 %1 % 才动：在此之前被摩擦力阻住。</translation>
    </message>
    <message>
        <source>It takes %1 % duty to stay in place: a load pulls one way.</source>
        <translation>需要 %1 % 占空比才能保持不动：负载朝一个方向拉。</translation>
    </message>
    <message>
        <source>It swings by %1 counts without end: play between motor and load.</source>
        <translation>它以 %1 个计数的幅度持续摆动：电机与负载之间有间隙。</translation>
    </message>
    <message>
        <source>Stage %1</source>
        <translation>暂存 %1</translation>
    </message>
</context>
<context>
    <name>mb::AdviserList</name>
    <message>
        <source>staged</source>
        <translation>已暂存</translation>
    </message>
    <message>
        <source>ok</source>
        <translation>正常</translation>
    </message>
    <message>
        <source>fixed in the set</source>
        <translation>本组已解决</translation>
    </message>
    <message>
        <source>mind it</source>
        <translation>注意</translation>
    </message>
    <message>
        <source>to fix</source>
        <translation>待解决</translation>
    </message>
    <message>
        <source>not read</source>
        <translation>未读取</translation>
    </message>
    <message>
        <source>This loop has no F that could fight with I.</source>
        <translation>此回路没有会与 I 冲突的 F。</translation>
    </message>
    <message>
        <source>uS/kp = %1: below this error only I moves the shaft.</source>
        <translation>uS/kp = %1：误差小于此值时只有 I 能转动轴。</translation>
    </message>
    <message>
        <source>uS/kp = %1: below this error nothing moves the shaft.</source>
        <translation>uS/kp = %1：误差小于此值时轴不会转动。</translation>
    </message>
    <message>
        <source>That is over 2 % of the step.</source>
        <translation>这超过阶跃的 2 %。</translation>
    </message>
    <message>
        <source>The drive&apos;s least output helps.</source>
        <translation>驱动器的最小输出可弥补。</translation>
    </message>
    <message>
        <source>No gain of the set is an integer of its own.</source>
        <translation>本组没有单独的整数增益。</translation>
    </message>
    <message>
        <source>%1 is %2 steps of its integer, at least %3 are wanted: one step is %4 %.</source>
        <translation>%1 为其整数的 %2 个级差，至少应有 %3 个：一个级差为 %4 %。</translation>
    </message>
    <message>
        <source>This drive has no ramp of its own.</source>
        <translation>此驱动器没有自带斜坡。</translation>
    </message>
    <message>
        <source>The drive&apos;s ramp was not read yet.</source>
        <translation>驱动器的斜坡尚未读取。</translation>
    </message>
    <message>
        <source>The drive&apos;s ramp is off.</source>
        <translation>驱动器的斜坡已关闭。</translation>
    </message>
    <message>
        <source>Full duty takes %1, over τc/2 = %2: it acts as lag.</source>
        <translation>到满占空比需 %1，超过 τc/2 = %2：起滞后作用。</translation>
    </message>
    <message>
        <source>Full duty takes %1, under τc/2 = %2.</source>
        <translation>到满占空比需 %1，低于 τc/2 = %2。</translation>
    </message>
    <message>
        <source>F–I conflict</source>
        <translation>F–I 冲突</translation>
    </message>
    <message>
        <source>Deadband</source>
        <translation>死区</translation>
    </message>
    <message>
        <source>D noise</source>
        <translation>D 噪声</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>分辨率</translation>
    </message>
    <message>
        <source>Ramp</source>
        <translation>斜坡</translation>
    </message>
    <message>
        <source>D is 0: one count moves no duty.</source>
        <translation>D 为 0：一个计数不会改变占空比。</translation>
    </message>
    <message>
        <source>One count moves the duty by %1 % through D; %2 % is the most that is quiet.</source>
        <translation>一个计数经 D 使占空比变化 %1 %；不超过 %2 % 才算平静。</translation>
    </message>
    <message>
        <source>Advisers</source>
        <translation>顾问</translation>
    </message>
    <message>
        <source>for %1, slot %2</source>
        <translation>%1，槽 %2</translation>
    </message>
    <message>
        <source>for %1</source>
        <translation>%1</translation>
    </message>
    <message>
        <source>Take back</source>
        <translation>撤回</translation>
    </message>
    <message>
        <source>Stages these values; nothing is written yet.</source>
        <translation>暂存这些值；尚未写入任何内容。</translation>
    </message>
    <message>
        <source>Stage</source>
        <translation>暂存</translation>
    </message>
    <message>
        <source>F and I in force give back %1 of the step as overshoot. The set has no F.</source>
        <translation>当前的 F 与 I 会把阶跃的 %1 以超调偿还。本组没有 F。</translation>
    </message>
    <message>
        <source>F and I give back %1 of the step as overshoot.</source>
        <translation>F 与 I 会把阶跃的 %1 以超调偿还。</translation>
    </message>
    <message>
        <source>F and I give nothing back as overshoot.</source>
        <translation>F 与 I 没有以超调偿还的滞后。</translation>
    </message>
</context>
<context>
    <name>mb::AgainstView</name>
    <message>
        <source>plot written to %1</source>
        <translation>曲线图已写入 %1</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>复制图片</translation>
    </message>
    <message>
        <source>One signal against another</source>
        <translation>一个信号对另一个信号</translation>
    </message>
    <message>
        <source>Signal across</source>
        <translation>横轴信号</translation>
    </message>
    <message>
        <source>Signal upwards</source>
        <translation>纵轴信号</translation>
    </message>
    <message>
        <source>against</source>
        <translation>对</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>A … B: </source>
        <translation>A … B: </translation>
    </message>
    <message>
        <source>what is seen: </source>
        <translation>可见范围: </translation>
    </message>
</context>
<context>
    <name>mb::Arming</name>
    <message>
        <source>%1: cut its power</source>
        <translation>%1：切断其电源</translation>
    </message>
    <message>
        <source>experiment</source>
        <translation>实验</translation>
    </message>
    <message>
        <source>until it is seen</source>
        <translation>直到看见为止</translation>
    </message>
    <message>
        <source>nothing to arm</source>
        <translation>没有可解锁的设备</translation>
    </message>
    <message>
        <source>arming off while busy</source>
        <translation>忙时不可解锁</translation>
    </message>
    <message>
        <source>%1 cannot be armed</source>
        <translation>%1 无法解锁</translation>
    </message>
    <message>
        <source>not sent to %1</source>
        <translation>未发送至 %1</translation>
    </message>
    <message>
        <source>it is not heard</source>
        <translation>收不到它的信号</translation>
    </message>
    <message>
        <source>%1 may still turn</source>
        <translation>%1 可能仍在转动</translation>
    </message>
    <message>
        <source>not armed: %1</source>
        <translation>未解锁：%1</translation>
    </message>
    <message>
        <source>armed</source>
        <translation>已解锁</translation>
    </message>
    <message>
        <source>%1 guard, %2</source>
        <comment>guard and what tripped it</comment>
        <translation>%1监护，%2</translation>
    </message>
    <message>
        <source>STOP: %1</source>
        <translation>STOP：%1</translation>
    </message>
    <message>
        <source>STOP: %1; not sent to %2</source>
        <translation>STOP：%1；未发送至 %2</translation>
    </message>
    <message>
        <source>this window did not respond for %1 s</source>
        <translation>此窗口已 %1 s 未响应</translation>
    </message>
    <message>
        <source>disarmed after %1 min without motion</source>
        <translation>%1 min 无运动后已上锁</translation>
    </message>
    <message>
        <source>the device is gone</source>
        <translation>设备已不存在</translation>
    </message>
    <message>
        <source>it has restarted</source>
        <translation>它已重新启动</translation>
    </message>
    <message>
        <source>an experiment on it has not ended</source>
        <translation>其上的实验尚未结束</translation>
    </message>
    <message>
        <source>the computer slept</source>
        <translation>计算机曾进入睡眠</translation>
    </message>
</context>
<context>
    <name>mb::AxesPanel</name>
    <message>
        <source>Axes</source>
        <translation>轴</translation>
    </message>
    <message>
        <source>together</source>
        <translation>同步</translation>
    </message>
    <message>
        <source>All axes run together</source>
        <translation>所有轴一起运行</translation>
    </message>
    <message>
        <source>Run starts every ticked axis at the same moment, each with its own mode and set-point.</source>
        <translation>“运行”同时启动每个勾选的轴，各用自己的模式和设定值。</translation>
    </message>
    <message>
        <source>Copy gains from…</source>
        <translation>复制增益自…</translation>
    </message>
    <message>
        <source>Stages the gains and limits of another axis for this one.</source>
        <translation>将另一轴的增益和限值暂存到此轴。</translation>
    </message>
    <message>
        <source>Same set-point for all ticked</source>
        <translation>所有勾选轴使用相同设定值</translation>
    </message>
    <message>
        <source>Mode and set-point of this axis for every ticked one; a position becomes the same distance.</source>
        <translation>将此轴的模式和设定值用于每个勾选的轴；位置则变为相同的距离。</translation>
    </message>
    <message>
        <source>Shows this axis: its mode, set-point, gains, limits and traces</source>
        <translation>显示此轴：其模式、设定值、增益、限值和曲线</translation>
    </message>
    <message>
        <source>Axis %1 runs together with the others</source>
        <translation>轴 %1 与其他轴一起运行</translation>
    </message>
    <message>
        <source>Run always moves the axis that is shown.</source>
        <translation>“运行”始终使所显示的轴运动。</translation>
    </message>
    <message>
        <source>Run moves this axis, too, at the same moment.</source>
        <translation>“运行”也同时使此轴运动。</translation>
    </message>
</context>
<context>
    <name>mb::AxisCells</name>
    <message>
        <source>Axes</source>
        <translation>轴</translation>
    </message>
    <message>
        <source>Shows this axis in Parameters, Tune and Plots</source>
        <translation>在“参数”、“整定”和“曲线图”中显示此轴</translation>
    </message>
</context>
<context>
    <name>mb::AxisChoice</name>
    <message>
        <source>Which axis</source>
        <translation>哪个轴</translation>
    </message>
    <message>
        <source>All axes</source>
        <translation>所有轴</translation>
    </message>
    <message>
        <source>Board</source>
        <translation>板卡</translation>
    </message>
    <message>
        <source>Copy from</source>
        <translation>复制自</translation>
    </message>
    <message>
        <source>Copy gains and limits from another axis</source>
        <translation>从另一轴复制增益和限值</translation>
    </message>
    <message>
        <source>Stages the gains and limits of another axis for this one; Write sends them.</source>
        <translation>将另一轴的增益和限值暂存到此轴；“写入”将其发送。</translation>
    </message>
    <message>
        <source>Gains and limits of axis %1</source>
        <translation>轴 %1 的增益和限值</translation>
    </message>
</context>
<context>
    <name>mb::Banner</name>
    <message>
        <source>Dismiss</source>
        <translation>忽略</translation>
    </message>
</context>
<context>
    <name>mb::BannerStack</name>
    <message>
        <source>1 more notice</source>
        <translation>还有 1 条通知</translation>
    </message>
    <message numerus="yes">
        <source>%n more notices</source>
        <translation>
            <numerusform>还有 %n 条通知</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mb::BatteryDialog</name>
    <message>
        <source>Battery of steps</source>
        <translation>阶跃序列</translation>
    </message>
    <message>
        <source>Run the battery</source>
        <translation>运行序列</translation>
    </message>
    <message>
        <source>Steps of the battery and the worst of each metric</source>
        <translation>序列中的各次阶跃及每项指标的最差值</translation>
    </message>
    <message>
        <source>Responses of the battery over each other</source>
        <translation>序列的响应叠加显示</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>share of the step</source>
        <translation>阶跃的份额</translation>
    </message>
    <message>
        <source>Step, %1</source>
        <translation>阶跃，%1</translation>
    </message>
    <message>
        <source>%1 steps, both ways in turn, from %2 to %3 %4, with the gains in force. The motor turns; each step keeps inside the limits of the page.</source>
        <translation>%1 次阶跃，两个方向交替，从 %2 到 %3 %4，使用当前生效的增益。电机会转动；每次阶跃都保持在页面的限值之内。</translation>
    </message>
    <message>
        <source>Step %1 of %2: to %3 %4. STOP ends it.</source>
        <translation>第 %1 次阶跃，共 %2 次：至 %3 %4。STOP 可将其结束。</translation>
    </message>
    <message>
        <source>Ended: %1</source>
        <translation>已结束：%1</translation>
    </message>
    <message>
        <source>Ended by: %1</source>
        <translation>结束原因：%1</translation>
    </message>
    <message>
        <source>Done: %1 trials in the notebook.</source>
        <translation>完成：试验记录本中有 %1 次试验。</translation>
    </message>
    <message>
        <source>Ended before all steps were run.</source>
        <translation>在所有阶跃运行完之前结束。</translation>
    </message>
    <message>
        <source>worst</source>
        <translation>最差</translation>
    </message>
    <message>
        <source>DEMO</source>
        <translation>演示</translation>
    </message>
    <message>
        <source>Arm the device first: hold the Arm button for 1 s.</source>
        <translation>请先解锁设备：按住“解锁”按钮 1 s。</translation>
    </message>
    <message>
        <source>Responses over each other</source>
        <translation>响应叠加显示</translation>
    </message>
    <message>
        <source>forwards</source>
        <translation>正向</translation>
    </message>
    <message>
        <source>backwards</source>
        <translation>反向</translation>
    </message>
    <message>
        <source>Not run: %1</source>
        <translation>未运行：%1</translation>
    </message>
    <message>
        <source>Not started, the page has changed: %1</source>
        <translation>未开始，页面已更改：%1</translation>
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
        <translation>最大 %1</translation>
    </message>
    <message>
        <source>firmware</source>
        <translation>固件</translation>
    </message>
    <message>
        <source>parameters</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>%1 equal</source>
        <translation>%1 项相同</translation>
    </message>
    <message>
        <source>unusual, %1</source>
        <translation>异常，%1</translation>
    </message>
    <message>
        <source>Connect a unit</source>
        <translation>请连接设备</translation>
    </message>
    <message>
        <source>It starts by itself when it answers on %1.</source>
        <translation>它在 %1 上应答后会自动开始。</translation>
    </message>
    <message>
        <source>Open a recipe, then Start</source>
        <translation>打开配方，然后按“启动”</translation>
    </message>
    <message>
        <source>The motor turns in a moment</source>
        <translation>电机即将转动</translation>
    </message>
    <message>
        <source>Safe to unplug</source>
        <translation>可以拔出</translation>
    </message>
    <message>
        <source>Do not unplug</source>
        <translation>请勿拔出</translation>
    </message>
    <message>
        <source>Unplug, connect next</source>
        <translation>拔出，连接下一台</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>合格</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>已跳过</translation>
    </message>
    <message>
        <source>waiting</source>
        <translation>等待中</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 至 %2</translation>
    </message>
    <message>
        <source>speed at most %1 counts/s</source>
        <translation>速度最大 %1 counts/s</translation>
    </message>
    <message>
        <source>travel at most %1 counts</source>
        <translation>行程最大 %1 counts</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>未通过</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>已拒绝</translation>
    </message>
    <message>
        <source>running</source>
        <translation>运行</translation>
    </message>
    <message>
        <source>Hold Arm to go on</source>
        <translation>按住“解锁”以继续</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>是</translation>
    </message>
    <message>
        <source>no</source>
        <translation>否</translation>
    </message>
    <message>
        <source>duty at most %1 %</source>
        <translation>占空比最大 %1 %</translation>
    </message>
    <message>
        <source>was there already</source>
        <translation>原已具备</translation>
    </message>
    <message>
        <source>it answers with it</source>
        <translation>以此版本应答</translation>
    </message>
    <message>
        <source>read back</source>
        <translation>已读回</translation>
    </message>
    <message>
        <source>backup</source>
        <translation>备份</translation>
    </message>
    <message>
        <source>kept</source>
        <translation>已保存</translation>
    </message>
    <message>
        <source>before the first write</source>
        <translation>首次写入之前</translation>
    </message>
    <message>
        <source>Start serves the next unit.</source>
        <translation>点击“启动”处理下一台。</translation>
    </message>
    <message>
        <source>written, not proved</source>
        <translation>已写入，未证实</translation>
    </message>
    <message>
        <source>%1 tests again · %2 sets it aside</source>
        <translation>%1 再次测试 · %2 搁置</translation>
    </message>
    <message>
        <source>Paused: no unit starts before the queue goes on.</source>
        <translation>已暂停：队列继续之前不会开始任何设备。</translation>
    </message>
    <message>
        <source>%1 from %2 to %3</source>
        <translation>%1，从 %2 到 %3</translation>
    </message>
    <message>
        <source>Start serves it once more</source>
        <translation>按开始再处理一次</translation>
    </message>
    <message>
        <source>No number was written to it this time.</source>
        <translation>这次没有给它写入编号。</translation>
    </message>
</context>
<context>
    <name>mb::BodePlot</name>
    <message>
        <source>Magnitude of loop and motor</source>
        <translation>回路与电机的幅值</translation>
    </message>
    <message>
        <source>Phase of loop and motor</source>
        <translation>回路与电机的相位</translation>
    </message>
    <message>
        <source>Hz</source>
        <translation>Hz</translation>
    </message>
    <message>
        <source>magnitude, dB</source>
        <translation>幅值，dB</translation>
    </message>
    <message>
        <source>phase, °</source>
        <translation>相位，°</translation>
    </message>
    <message>
        <source>loop</source>
        <translation>回路</translation>
    </message>
    <message>
        <source>motor ÷ gain</source>
        <translation>电机 ÷ 增益</translation>
    </message>
    <message>
        <source>motor ÷ gain, measured</source>
        <translation>电机 ÷ 增益，实测</translation>
    </message>
    <message>
        <source>0.90 … 0.97</source>
        <translation>0.90 … 0.97</translation>
    </message>
    <message>
        <source>not used</source>
        <translation>未使用</translation>
    </message>
    <message>
        <source>measured, γ² ≥ 0.97</source>
        <translation>实测，γ² ≥ 0.97</translation>
    </message>
    <message>
        <source>under 0.90, not used</source>
        <translation>低于 0.90，未使用</translation>
    </message>
</context>
<context>
    <name>mb::BodeText</name>
    <message>
        <source>crossover %1 Hz</source>
        <translation>穿越频率 %1 Hz</translation>
    </message>
    <message>
        <source>PM %1° at %2 Hz</source>
        <translation>PM %1°（%2 Hz）</translation>
    </message>
    <message>
        <source>GM %1 dB at %2 Hz</source>
        <translation>GM %1 dB（%2 Hz）</translation>
    </message>
    <message>
        <source>GM –, beyond what was measured</source>
        <translation>GM –，超出测量范围</translation>
    </message>
    <message>
        <source>usable up to %1 Hz</source>
        <translation>可用至 %1 Hz</translation>
    </message>
    <message>
        <source>unstable</source>
        <translation>不稳定</translation>
    </message>
    <message>
        <source>phase margin %1°</source>
        <translation>相位裕度 %1°</translation>
    </message>
    <message>
        <source>gain margin %1 dB</source>
        <translation>增益裕度 %1 dB</translation>
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
        <translation>链路</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>暂停</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>继续</translation>
    </message>
    <message>
        <source>Holds the frames still; everything is counted and kept meanwhile</source>
        <translation>使帧列表静止；期间所有帧仍会计数并保留</translation>
    </message>
    <message>
        <source>Clear the list</source>
        <translation>清空列表</translation>
    </message>
    <message>
        <source>Export frames</source>
        <translation>导出帧</translation>
    </message>
    <message>
        <source>Frames that are shown…</source>
        <translation>显示的帧…</translation>
    </message>
    <message>
        <source>All frames that are kept…</source>
        <translation>保留的全部帧…</translation>
    </message>
    <message>
        <source>Send frame…</source>
        <translation>发送帧…</translation>
    </message>
    <message>
        <source>What the expression does</source>
        <translation>表达式的作用</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>筛选</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>查找</translation>
    </message>
    <message>
        <source>such as message:STS* device:5 not is:error</source>
        <translation>例如 message:STS* device:5 not is:error</translation>
    </message>
    <message>
        <source>Filter frames</source>
        <translation>筛选帧</translation>
    </message>
    <message>
        <source>How to write a filter</source>
        <translation>如何编写筛选条件</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>All</source>
        <translation>全部</translation>
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
        <translation>错误</translation>
    </message>
    <message>
        <source>Filter hides what does not match; Find marks what does, Enter goes to the next</source>
        <translation>“筛选”隐藏不匹配项；“查找”标记匹配项，Enter 转到下一个</translation>
    </message>
</context>
<context>
    <name>mb::BusLoadView</name>
    <message>
        <source>Bus load of the last minute</source>
        <translation>最近一分钟的总线负载</translation>
    </message>
    <message>
        <source>now %1 %, peak %2 %</source>
        <translation>当前 %1 %，峰值 %2 %</translation>
    </message>
</context>
<context>
    <name>mb::BusPage</name>
    <message>
        <source>Bus</source>
        <translation>总线</translation>
    </message>
    <message>
        <source>pauses the list, and goes on</source>
        <translation>暂停列表，或继续</translation>
    </message>
    <message>
        <source>goes to the filter</source>
        <translation>转到筛选框</translation>
    </message>
    <message>
        <source>finds the next one</source>
        <translation>查找下一个</translation>
    </message>
    <message>
        <source>finds the one before</source>
        <translation>查找上一个</translation>
    </message>
    <message>
        <source>not kept %1</source>
        <translation>未保留 %1</translation>
    </message>
    <message>
        <source>%1 of %2 shown</source>
        <translation>显示 %1，共 %2</translation>
    </message>
    <message>
        <source>Export all frames</source>
        <translation>导出全部帧</translation>
    </message>
    <message>
        <source>Export the frames that are shown</source>
        <translation>导出显示的帧</translation>
    </message>
    <message>
        <source>candump log (*.log)</source>
        <translation>candump 日志 (*.log)</translation>
    </message>
    <message>
        <source>%1 frames written to %2</source>
        <translation>已将 %1 帧写入 %2</translation>
    </message>
    <message>
        <source>load %1 &amp;nbsp; frames/s %2</source>
        <translation>负载 %1 &amp;nbsp; 帧/s %2</translation>
    </message>
    <message>
        <source>dropped %1 &amp;nbsp; errors %2</source>
        <translation>丢弃 %1 &amp;nbsp; 错误 %2</translation>
    </message>
    <message>
        <source>No link yet</source>
        <translation>尚无链路</translation>
    </message>
    <message>
        <source>Open a link, or the simulated bench from the menu; what passes on it appears here.</source>
        <translation>打开链路，或从菜单打开仿真台架；链路上传输的内容会显示在此处。</translation>
    </message>
    <message>
        <source>%1 is not open</source>
        <translation>%1 未打开</translation>
    </message>
    <message>
        <source>load %1 &amp;nbsp; bytes/s %2</source>
        <translation>负载 %1 &amp;nbsp; 字节/s %2</translation>
    </message>
    <message>
        <source>records, or ends the recording</source>
        <translation>开始记录，或结束记录</translation>
    </message>
</context>
<context>
    <name>mb::BusSide</name>
    <message>
        <source>Bus load, %</source>
        <translation>总线负载，%</translation>
    </message>
    <message>
        <source>last 60 s, peak %1 %</source>
        <translation>最近 60 s，峰值 %1 %</translation>
    </message>
    <message>
        <source>%1 identifiers</source>
        <translation>%1 个标识符</translation>
    </message>
    <message>
        <source>busiest %1, %2 frames/s</source>
        <translation>最繁忙 %1，%2 帧/s</translation>
    </message>
    <message>
        <source>%1 frames of identifiers without a row</source>
        <translation>%1 帧的标识符没有对应行</translation>
    </message>
    <message>
        <source>%1 frames that no decoder knows</source>
        <translation>%1 帧没有解码器认识</translation>
    </message>
    <message>
        <source>error counters TEC %1, REC %2</source>
        <translation>错误计数器 TEC %1，REC %2</translation>
    </message>
</context>
<context>
    <name>mb::BusTables</name>
    <message>
        <source>Frames</source>
        <translation>帧</translation>
    </message>
    <message>
        <source>Identifiers</source>
        <translation>标识符</translation>
    </message>
</context>
<context>
    <name>mb::ByteStrip</name>
    <message>
        <source>Bytes %1</source>
        <translation>字节 %1</translation>
    </message>
</context>
<context>
    <name>mb::ChangeRow</name>
    <message>
        <source>fix first</source>
        <translation>请先修正</translation>
    </message>
    <message>
        <source>look again</source>
        <translation>请复查</translation>
    </message>
    <message>
        <source>Write %1: %2 to %3</source>
        <translation>写入 %1：由 %2 改为 %3</translation>
    </message>
    <message>
        <source>later</source>
        <translation>稍后</translation>
    </message>
    <message>
        <source>Written as number %1</source>
        <translation>第 %1 个写入</translation>
    </message>
    <message>
        <source>Stays staged</source>
        <translation>保持暂存</translation>
    </message>
</context>
<context>
    <name>mb::ChangesPanel</name>
    <message>
        <source>Changes to write</source>
        <translation>待写入的更改</translation>
    </message>
    <message>
        <source>order is chosen for you</source>
        <translation>顺序自动选定</translation>
    </message>
    <message>
        <source>Limits first, then what makes the loop calmer, then what makes it livelier: damping before P, P before I.</source>
        <translation>先写限值，再写使回路更平缓的值，最后写使其更激进的值：阻尼先于 P，P 先于 I。</translation>
    </message>
    <message>
        <source>Staged changes</source>
        <translation>暂存的更改</translation>
    </message>
    <message>
        <source>Nothing is staged. Edit a value in the table, or import a file.</source>
        <translation>没有暂存内容。请在表格中编辑值，或导入文件。</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>进度</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>放弃</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>写入</translation>
    </message>
    <message>
        <source>Each value is written, read back and compared.</source>
        <translation>每个值均会写入、回读并比较。</translation>
    </message>
    <message>
        <source>Each value is written. None can be read back: what stands here then is assumed.</source>
        <translation>每个值都会写入。均无法回读：之后此处显示的是假定值。</translation>
    </message>
    <message>
        <source>Each value is written. %1 of %2 cannot be read back: they are assumed then; the others are compared.</source>
        <translation>每个值都会写入。%2 个中有 %1 个无法回读：之后为假定值；其余的会比较。</translation>
    </message>
    <message>
        <source>nothing is staged</source>
        <translation>没有暂存内容</translation>
    </message>
    <message>
        <source>fix 1 value first</source>
        <translation>请先修正 1 个值</translation>
    </message>
    <message>
        <source>fix %1 values first</source>
        <translation>请先修正 %1 个值</translation>
    </message>
    <message>
        <source>look again first</source>
        <translation>请先复查</translation>
    </message>
    <message>
        <source>none is ticked</source>
        <translation>未勾选任何项</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>无应答</translation>
    </message>
    <message>
        <source>two units, one number</source>
        <translation>两台设备，同一编号</translation>
    </message>
    <message>
        <source>busy</source>
        <translation>忙</translation>
    </message>
    <message>
        <source>%1, %2 of %3</source>
        <translation>%1，%2 / %3</translation>
    </message>
    <message>
        <source>The drive stores by itself %1 s after the last change: keep power on.</source>
        <translation>驱动器在最后一次更改后 %1 s 自动存储：请保持通电。</translation>
    </message>
    <message>
        <source>Write %1</source>
        <translation>写入 %1</translation>
    </message>
    <message>
        <source>Write the staged changes</source>
        <translation>写入暂存的更改</translation>
    </message>
</context>
<context>
    <name>mb::Closing</name>
    <message>
        <source>Close MotorBench</source>
        <translation>关闭 MotorBench</translation>
    </message>
    <message>
        <source>Keep open</source>
        <translation>保持打开</translation>
    </message>
    <message>
        <source>Firmware is being written to %1. Cancel the update?</source>
        <translation>正在向 %1 写入固件。取消更新吗？</translation>
    </message>
    <message>
        <source>What is written now must not be cut: the window closes once it is over.</source>
        <translation>正在写入的内容不得中断：写完后窗口才会关闭。</translation>
    </message>
    <message>
        <source>Cancel the update and close</source>
        <translation>取消更新并关闭</translation>
    </message>
    <message>
        <source>%1 has not been seen to stop. Close anyway?</source>
        <translation>未确认 %1 已停止。仍要关闭吗？</translation>
    </message>
    <message>
        <source>It was told to stop. Without this window nobody sees whether it does.</source>
        <translation>停止命令已发出。没有此窗口，就无人知道它是否停止。</translation>
    </message>
    <message>
        <source>Close anyway</source>
        <translation>仍然关闭</translation>
    </message>
    <message>
        <source>Units are being served. Cancel the queue?</source>
        <translation>正在处理设备。取消队列？</translation>
    </message>
    <message>
        <source>The journal knows where it stood, and the queue can be gone on with.</source>
        <translation>日志簿记录了进度，队列可以继续。</translation>
    </message>
    <message>
        <source>Cancel the queue and close</source>
        <translation>取消队列并关闭</translation>
    </message>
    <message>
        <source>Samples are being written to %1. Cancel the export?</source>
        <translation>正在向 %1 写入采样。取消导出吗？</translation>
    </message>
    <message>
        <source>Nothing of it is kept then.</source>
        <translation>这样就不会留下任何内容。</translation>
    </message>
    <message>
        <source>Cancel the export and close</source>
        <translation>取消导出并关闭</translation>
    </message>
    <message>
        <source>The window closes once this has ended: %1</source>
        <translation>以下内容结束之后，窗口就会关闭：%1</translation>
    </message>
</context>
<context>
    <name>mb::CommandPalette</name>
    <message>
        <source>Commands</source>
        <translation>命令</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>命令</translation>
    </message>
    <message>
        <source>Type what you want to do</source>
        <translation>输入您想做的事</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>page: command</comment>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>No command begins so</source>
        <translation>没有以此开头的命令</translation>
    </message>
</context>
<context>
    <name>mb::ComparedText</name>
    <message>
        <source>in force</source>
        <translation>当前</translation>
    </message>
    <message>
        <source>before</source>
        <translation>之前</translation>
    </message>
    <message>
        <source>%1: unstable on this model</source>
        <translation>%1：在此模型上不稳定</translation>
    </message>
    <message>
        <source>%1: over %2 %, Ms %3</source>
        <translation>%1：超调 %2 %，Ms %3</translation>
    </message>
</context>
<context>
    <name>mb::ComparisonBox</name>
    <message>
        <source>Compare with</source>
        <translation>比较对象</translation>
    </message>
    <message>
        <source>as found %1</source>
        <translation>初始状态 %1</translation>
    </message>
    <message>
        <source>defaults</source>
        <translation>默认值</translation>
    </message>
    <message>
        <source>axis %1</source>
        <translation>轴 %1</translation>
    </message>
    <message>
        <source>a file…</source>
        <translation>文件…</translation>
    </message>
</context>
<context>
    <name>mb::Conditions</name>
    <message>
        <source>%1 may still turn: cut its power</source>
        <translation>%1 可能仍在转动：切断其电源</translation>
    </message>
    <message>
        <source>Its stop was not confirmed. It is sent again, and first of all when its line is back.</source>
        <translation>其停止未得到确认。停止命令会重复发送，线路恢复后首先发送。</translation>
    </message>
    <message>
        <source>I have looked: it stands</source>
        <translation>我已查看：它已静止</translation>
    </message>
    <message>
        <source>Stopped: %1</source>
        <translation>已停止：%1</translation>
    </message>
    <message>
        <source>Hold the Arm button for 1 s to arm again.</source>
        <translation>按住“解锁”按钮 1 s 以重新解锁。</translation>
    </message>
    <message>
        <source>%1 is lost</source>
        <translation>%1 已丢失</translation>
    </message>
    <message>
        <source>Another master drives %1</source>
        <translation>另一主站正在驱动 %1</translation>
    </message>
    <message>
        <source>Arming is off until it stops sending control frames.</source>
        <translation>在它停止发送控制帧之前不可解锁。</translation>
    </message>
    <message>
        <source>Several units answer as %1</source>
        <translation>有多台设备以 %1 应答</translation>
    </message>
    <message>
        <source>Control is locked. Assign one of them a new number from the menu of its row.</source>
        <translation>控制已锁定。请在其行菜单中为其中一台分配新编号。</translation>
    </message>
    <message>
        <source>Firmware is being written to %1</source>
        <translation>正在向 %1 写入固件</translation>
    </message>
    <message>
        <source>Do not unplug. %1 of %2.</source>
        <translation>请勿拔出。%1 / %2。</translation>
    </message>
    <message>
        <source>Writing the settings of %1 again: %2 of %3</source>
        <translation>正在重新写入 %1 的设置：%2 / %3</translation>
    </message>
    <message>
        <source>Each is confirmed by the board.</source>
        <translation>每项均由板卡确认。</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>%1 was reset: 1 setting is unknown</source>
        <translation>%1 已复位：1 项设置未知</translation>
    </message>
    <message>
        <source>%1 was reset: %2 settings are unknown</source>
        <translation>%1 已复位：%2 项设置未知</translation>
    </message>
    <message>
        <source>The board keeps nothing without power. This program knows what was last written.</source>
        <translation>板卡断电后不保留任何内容。本程序知道最后写入的值。</translation>
    </message>
    <message>
        <source>Write them again</source>
        <translation>重新写入</translation>
    </message>
    <message>
        <source>Trial #%1 on %2 was cut before it put its gains back</source>
        <translation>%2 上的试验 #%1 在恢复其增益之前中断</translation>
    </message>
    <message>
        <source>Before it: %1. The motor must stand.</source>
        <translation>之前的值：%1。电机必须静止。</translation>
    </message>
    <message>
        <source>Put them back</source>
        <translation>恢复原值</translation>
    </message>
    <message>
        <source>Writing was cancelled; what is missing can be written later.</source>
        <translation>写入已取消；缺少的可稍后写入。</translation>
    </message>
    <message>
        <source>%1 may have been reset: 1 setting is unknown</source>
        <translation>%1 可能已复位：1 项设置未知</translation>
    </message>
    <message>
        <source>%1 may have been reset: %2 settings are unknown</source>
        <translation>%1 可能已复位：%2 项设置未知</translation>
    </message>
    <message>
        <source>Nothing shows that it still has what was not saved. This program knows what was last written.</source>
        <translation>无法确认未保存的值是否仍在。本程序知道最后写入的值。</translation>
    </message>
    <message>
        <source>Safe to unplug: the update can be run again. %1 of %2.</source>
        <translation>可以拔出：更新可以重新进行。%1 / %2。</translation>
    </message>
    <message>
        <source>Keep what it has</source>
        <translation>保留现有值</translation>
    </message>
</context>
<context>
    <name>mb::CountTiles</name>
    <message>
        <source>passed</source>
        <translation>合格</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>未通过</translation>
    </message>
    <message>
        <source>refused before start</source>
        <translation>开始前拒绝</translation>
    </message>
    <message>
        <source>mean time</source>
        <translation>平均时间</translation>
    </message>
    <message>
        <source>units an hour</source>
        <translation>台/小时</translation>
    </message>
</context>
<context>
    <name>mb::CrashNotice</name>
    <message>
        <source>The program ended unexpectedly</source>
        <translation>程序意外结束</translation>
    </message>
    <message>
        <source>Open it again</source>
        <translation>重新打开</translation>
    </message>
    <message>
        <source>Read the report</source>
        <translation>阅读报告</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>忽略</translation>
    </message>
    <message>
        <source>Report of the crash</source>
        <translation>崩溃报告</translation>
    </message>
    <message>
        <source>File of the report</source>
        <translation>报告文件</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>复制</translation>
    </message>
</context>
<context>
    <name>mb::DemoStripe</name>
    <message>
        <source>simulated bench</source>
        <translation>仿真台架</translation>
    </message>
    <message>
        <source>Demo  ·  %1  ·  no real motor is connected</source>
        <translation>演示  ·  %1  ·  未连接真实电机</translation>
    </message>
    <message>
        <source>Replay  ·  %1  ·  shows what was recorded, moves no motor</source>
        <translation>回放  ·  %1  ·  显示所记录的内容，不驱动任何电机</translation>
    </message>
    <message>
        <source>Replay</source>
        <translation>回放</translation>
    </message>
    <message>
        <source>Demo</source>
        <translation>演示</translation>
    </message>
</context>
<context>
    <name>mb::DesignBook</name>
    <message>
        <source>%1 waits in its bootloader.</source>
        <translation>%1 在其引导程序中等待。</translation>
    </message>
    <message>
        <source>This family has no loop that can be tuned.</source>
        <translation>此系列没有可整定的回路。</translation>
    </message>
</context>
<context>
    <name>mb::DesignCourse</name>
    <message>
        <source>What the adviser proposes</source>
        <translation>顾问的建议</translation>
    </message>
</context>
<context>
    <name>mb::DesignFrame</name>
    <message>
        <source>Part of the page</source>
        <translation>页面部分</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>模型</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>曲线</translation>
    </message>
    <message>
        <source>Course</source>
        <translation>过程</translation>
    </message>
</context>
<context>
    <name>mb::DesignOrders</name>
    <message>
        <source>Loop</source>
        <translation>回路</translation>
    </message>
    <message>
        <source>Velocity</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Current</source>
        <translation>电流</translation>
    </message>
    <message>
        <source>Gain slot</source>
        <translation>增益槽</translation>
    </message>
    <message>
        <source>slot 0</source>
        <translation>槽 0</translation>
    </message>
    <message>
        <source>slot 1</source>
        <translation>槽 1</translation>
    </message>
    <message>
        <source>Identify</source>
        <translation>辨识</translation>
    </message>
    <message>
        <source>Autotune</source>
        <translation>自整定</translation>
    </message>
    <message>
        <source>Write and prove</source>
        <translation>写入并验证</translation>
    </message>
    <message>
        <source>Identifies, writes the chosen set and proves it, in one go</source>
        <translation>一次完成辨识、写入所选参数组并验证</translation>
    </message>
</context>
<context>
    <name>mb::DesignPage</name>
    <message>
        <source>writes the chosen set and proves it</source>
        <translation>写入所选参数组并验证</translation>
    </message>
    <message>
        <source>identifies, writes and proves in one go</source>
        <translation>一次完成辨识、写入和验证</translation>
    </message>
    <message>
        <source>identifies the motor</source>
        <translation>辨识电机</translation>
    </message>
    <message>
        <source>writes a report of what is shown</source>
        <translation>为所显示内容生成报告</translation>
    </message>
    <message>
        <source>Tuning</source>
        <translation>正在整定</translation>
    </message>
    <message>
        <source>STOP ends it; what was changed is put back.</source>
        <translation>STOP 可将其结束；更改过的值会恢复。</translation>
    </message>
    <message>
        <source>Moving</source>
        <translation>正在运动</translation>
    </message>
    <message>
        <source>Stop the motion before the motor is tuned.</source>
        <translation>请先停止运动，再整定电机。</translation>
    </message>
    <message>
        <source>Busy</source>
        <translation>忙</translation>
    </message>
    <message>
        <source>Armed</source>
        <translation>已解锁</translation>
    </message>
    <message>
        <source>Not armed</source>
        <translation>未解锁</translation>
    </message>
    <message>
        <source>Hold the Arm button for 1 s to arm %1.</source>
        <translation>按住“解锁”按钮 1 s 以解锁 %1。</translation>
    </message>
    <message>
        <source>No tuning here</source>
        <translation>此处不可整定</translation>
    </message>
    <message>
        <source>No device selected</source>
        <translation>未选择设备</translation>
    </message>
    <message>
        <source>Choose a controller in the list at the left.</source>
        <translation>请在左侧列表中选择控制器。</translation>
    </message>
    <message>
        <source>Not by itself</source>
        <translation>不能自动进行</translation>
    </message>
    <message>
        <source>DEMO</source>
        <translation>演示</translation>
    </message>
    <message>
        <source>No limit</source>
        <translation>不是限值</translation>
    </message>
    <message>
        <source>%1 will turn both ways.</source>
        <translation>%1 将双向转动。</translation>
    </message>
</context>
<context>
    <name>mb::DesignPlots</name>
    <message>
        <source>Step, predicted and measured</source>
        <translation>阶跃，预测与实测</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>What the gains will do appears here, before they are written.</source>
        <translation>写入之前，增益的效果会在此显示。</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>阶跃</translation>
    </message>
</context>
<context>
    <name>mb::DeviceCard</name>
    <message>
        <source>velocity</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>current</source>
        <translation>电流</translation>
    </message>
    <message>
        <source>duty</source>
        <translation>占空比</translation>
    </message>
    <message>
        <source>last 10 s</source>
        <translation>最近 10 s</translation>
    </message>
    <message>
        <source>Update firmware</source>
        <translation>更新固件</translation>
    </message>
    <message>
        <source>No application runs. Settings, number and name are kept.</source>
        <translation>没有应用程序在运行。设置、编号和名称均保留。</translation>
    </message>
    <message>
        <source>An update makes it whole again. It is safe to power off.</source>
        <translation>更新可使其恢复完整。可以安全断电。</translation>
    </message>
    <message>
        <source>boot %1 · no telemetry</source>
        <translation>引导 %1 · 无遥测</translation>
    </message>
    <message>
        <source>%1 Hz   lost %2</source>
        <translation>%1 Hz   丢失 %2</translation>
    </message>
    <message>
        <source>no watchdog</source>
        <translation>无看门狗</translation>
    </message>
    <message>
        <source>It keeps its last set-point if this program dies. A second process beside it, the guardian, stops it then.</source>
        <translation>如果本程序终止，它会保持最后的设定值。届时由旁边的第二个进程（守护进程）将其停止。</translation>
    </message>
</context>
<context>
    <name>mb::DeviceLine</name>
    <message>
        <source>Selected device</source>
        <translation>所选设备</translation>
    </message>
    <message>
        <source>position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>velocity</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>current</source>
        <translation>电流</translation>
    </message>
    <message>
        <source>duty</source>
        <translation>占空比</translation>
    </message>
    <message>
        <source>bus</source>
        <translation>总线</translation>
    </message>
    <message>
        <source>case</source>
        <translation>外壳</translation>
    </message>
    <message>
        <source>SN %1 · fw %2</source>
        <translation>SN %1 · 固件 %2</translation>
    </message>
</context>
<context>
    <name>mb::DeviceModel</name>
    <message>
        <source>lost</source>
        <translation>丢失</translation>
    </message>
    <message>
        <source>scanning</source>
        <translation>正在扫描</translation>
    </message>
    <message>
        <source>%1 of %2: %3, now %4
Its pages show this axis; drag it to a plot.</source>
        <translation>%2 的 %1：%3，现在 %4
其页面显示此轴；可拖到曲线图中。</translation>
    </message>
    <message>
        <source>%1
Double click or Enter plots it; drag it to a plot.</source>
        <translation>%1
双击或按 Enter 绘制；可拖到曲线图中。</translation>
    </message>
</context>
<context>
    <name>mb::DeviceTree</name>
    <message>
        <source>Devices</source>
        <translation>设备</translation>
    </message>
    <message>
        <source>Scan again</source>
        <translation>重新扫描</translation>
    </message>
    <message>
        <source>Filter devices</source>
        <translation>筛选设备</translation>
    </message>
    <message>
        <source>Hide devices</source>
        <translation>隐藏设备</translation>
    </message>
    <message>
        <source>Filter by name, number, serial</source>
        <translation>按名称、编号、序列号筛选</translation>
    </message>
    <message>
        <source>No device yet</source>
        <translation>尚无设备</translation>
    </message>
    <message>
        <source>Devices appear here by themselves as soon as a link answers.</source>
        <translation>链路一有应答，设备就会自动出现在此处。</translation>
    </message>
    <message>
        <source>Links and devices</source>
        <translation>链路与设备</translation>
    </message>
    <message>
        <source>Add link</source>
        <translation>添加链路</translation>
    </message>
    <message>
        <source>Simulate</source>
        <translation>仿真</translation>
    </message>
    <message>
        <source>Open a CAN interface, a serial port or another link</source>
        <translation>打开 CAN 接口、串口或其他链路</translation>
    </message>
    <message>
        <source>Open the simulated bench; no real motor is connected to it</source>
        <translation>打开仿真台架；未连接真实电机</translation>
    </message>
    <message>
        <source>Show 1 new device</source>
        <translation>显示 1 台新设备</translation>
    </message>
    <message>
        <source>Show %1 new devices</source>
        <translation>显示 %1 台新设备</translation>
    </message>
    <message>
        <source>Search every rate and address (takes minutes)</source>
        <translation>搜索所有速率和地址（需数分钟）</translation>
    </message>
    <message>
        <source>Cancel the scan</source>
        <translation>取消扫描</translation>
    </message>
    <message>
        <source>Plot %1</source>
        <translation>绘制 %1</translation>
    </message>
    <message>
        <source>Open it at every start</source>
        <translation>每次启动时打开</translation>
    </message>
    <message>
        <source>Close this link</source>
        <translation>关闭此链路</translation>
    </message>
</context>
<context>
    <name>mb::DifferenceTable</name>
    <message>
        <source>Differences</source>
        <translation>差异</translation>
    </message>
    <message>
        <source>parameter</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>key</source>
        <translation>键</translation>
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
        <translation>单位</translation>
    </message>
    <message>
        <source>belongs to one unit, copied only if you tick it</source>
        <translation>属于单个设备，仅在勾选时复制</translation>
    </message>
    <message>
        <source>assumed: it cannot be read</source>
        <translation>假定：无法读取</translation>
    </message>
    <message>
        <source>state</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>This unit</source>
        <translation>此设备</translation>
    </message>
    <message>
        <source>%1 of %2 differ</source>
        <translation>%2 项中 %1 项不同</translation>
    </message>
</context>
<context>
    <name>mb::DoctorCard</name>
    <message>
        <source>Connection doctor</source>
        <translation>连接诊断</translation>
    </message>
    <message>
        <source>looks by itself</source>
        <translation>自动检查</translation>
    </message>
    <message>
        <source>CAN</source>
        <translation>CAN</translation>
    </message>
    <message>
        <source>Command for a terminal</source>
        <translation>终端命令</translation>
    </message>
    <message>
        <source>Copy command</source>
        <translation>复制命令</translation>
    </message>
    <message>
        <source>Paste it into a terminal; this program never runs as root</source>
        <translation>将其粘贴到终端；本程序从不以 root 身份运行</translation>
    </message>
    <message>
        <source>Reconnect</source>
        <translation>重新连接</translation>
    </message>
    <message>
        <source>Open this link now</source>
        <translation>立即打开此链路</translation>
    </message>
    <message>
        <source>The command is in the clipboard; paste it into a terminal.</source>
        <translation>命令已在剪贴板中；请粘贴到终端。</translation>
    </message>
</context>
<context>
    <name>mb::DriveOptions</name>
    <message>
        <source>as the device is set</source>
        <translation>按设备的设置</translation>
    </message>
    <message>
        <source>brake</source>
        <translation>制动</translation>
    </message>
    <message>
        <source>coast</source>
        <translation>滑行</translation>
    </message>
    <message>
        <source>At zero output</source>
        <translation>输出为零时</translation>
    </message>
    <message>
        <source>At zero</source>
        <translation>为零时</translation>
    </message>
    <message>
        <source>Reverse motor</source>
        <translation>电机反向</translation>
    </message>
    <message>
        <source>Forward output turns the motor the other way. Changing it disarms.</source>
        <translation>正向输出使电机朝另一方向转动。更改后会上锁。</translation>
    </message>
    <message>
        <source>Reverse sensor</source>
        <translation>传感器反向</translation>
    </message>
    <message>
        <source>The encoder counts the other way. Changing it disarms.</source>
        <translation>编码器朝另一方向计数。更改后会上锁。</translation>
    </message>
    <message>
        <source>Override limits</source>
        <translation>覆盖限位</translation>
    </message>
    <message>
        <source>The two below replace the device&apos;s own settings for limit switches. Changing it disarms.</source>
        <translation>下面两项取代设备自身的限位开关设置。更改后会上锁。</translation>
    </message>
    <message>
        <source>Forward limit off</source>
        <translation>正向限位关闭</translation>
    </message>
    <message>
        <source>The motor runs past the forward limit. Changing it disarms.</source>
        <translation>电机会越过正向限位。更改后会上锁。</translation>
    </message>
    <message>
        <source>Reverse limit off</source>
        <translation>反向限位关闭</translation>
    </message>
    <message>
        <source>The motor runs past the reverse limit. Changing it disarms.</source>
        <translation>电机会越过反向限位。更改后会上锁。</translation>
    </message>
    <message>
        <source>Ramp of the output, duty per second</source>
        <translation>输出斜坡，每秒占空比</translation>
    </message>
    <message>
        <source>duty/s, 0 = none</source>
        <translation>duty/s，0 = 无</translation>
    </message>
    <message>
        <source>Ramp</source>
        <translation>斜坡</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>无</translation>
    </message>
    <message>
        <source>ramp %1 duty/s</source>
        <translation>斜坡 %1 duty/s</translation>
    </message>
    <message>
        <source>motor reversed</source>
        <translation>电机已反向</translation>
    </message>
    <message>
        <source>sensor reversed</source>
        <translation>传感器已反向</translation>
    </message>
    <message>
        <source>limits overridden</source>
        <translation>限位已覆盖</translation>
    </message>
    <message>
        <source>Greatest change of the output in duty per second: 2 takes 0.5 s from 0 to 100 %.</source>
        <translation>输出每秒的最大占空比变化：2 表示从 0 到 100 % 需 0.5 s。</translation>
    </message>
    <message>
        <source>duty/s, 0 = %1</source>
        <translation>duty/s，0 = %1</translation>
    </message>
    <message>
        <source>%1 is no ramp. Enter 0 or a positive number of duty per second.</source>
        <translation>%1 不是斜坡值。请输入 0，或输入每秒占空比的正数。</translation>
    </message>
</context>
<context>
    <name>mb::EntryText</name>
    <message>
        <source>passed</source>
        <translation>合格</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>未通过</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>已拒绝</translation>
    </message>
    <message>
        <source>not ended</source>
        <translation>未结束</translation>
    </message>
    <message>
        <source>as it is now</source>
        <translation>当前状态</translation>
    </message>
    <message>
        <source>%1 %2: %3</source>
        <translation>%1 %2：%3</translation>
    </message>
</context>
<context>
    <name>mb::EnvelopePanel</name>
    <message>
        <source>Travel ±</source>
        <translation>行程 ±</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Current</source>
        <translation>电流</translation>
    </message>
    <message>
        <source>Duty</source>
        <translation>占空比</translation>
    </message>
    <message>
        <source>Envelope</source>
        <translation>运行包络</translation>
    </message>
    <message>
        <source>Envelope: %1</source>
        <translation>运行包络：%1</translation>
    </message>
    <message>
        <source>Empty: what the device itself says</source>
        <translation>留空：采用设备自身的值</translation>
    </message>
    <message>
        <source>%1 holds</source>
        <translation>%1 有效</translation>
    </message>
    <message>
        <source>not bounded, %1</source>
        <translation>未限定，%1</translation>
    </message>
    <message>
        <source>%1: %2 is no limit. It is more than 0, and at most %3.</source>
        <translation>%1：%2 不是限值。应大于 0，且不超过 %3。</translation>
    </message>
</context>
<context>
    <name>mb::ExperimentDialog</name>
    <message>
        <source>Axis</source>
        <translation>轴</translation>
    </message>
    <message>
        <source>axis %1</source>
        <translation>轴 %1</translation>
    </message>
    <message>
        <source>Of which motor</source>
        <translation>属于哪台电机</translation>
    </message>
    <message>
        <source>Most power</source>
        <translation>最大功率</translation>
    </message>
    <message>
        <source>Not begun</source>
        <translation>未开始</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>步骤</translation>
    </message>
    <message>
        <source>Progress of the experiment</source>
        <translation>实验进度</translation>
    </message>
    <message>
        <source>Log of the experiment</source>
        <translation>实验日志</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>STOP, Esc or Cancel ends it at any time.</source>
        <translation>STOP、Esc 或“取消”可随时结束。</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Hold to turn the motor</source>
        <translation>按住以转动电机</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>开始</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Ended</source>
        <translation>已结束</translation>
    </message>
    <message>
        <source>Found and kept for this device.</source>
        <translation>已得出结果并为此设备保留。</translation>
    </message>
    <message>
        <source>Cancelled. The motor is stopped; gains and limits are as they were.</source>
        <translation>已取消。电机已停止；增益和限值保持原样。</translation>
    </message>
</context>
<context>
    <name>mb::ExperimentText</name>
    <message>
        <source>at most %1 s</source>
        <translation>最多 %1 s</translation>
    </message>
    <message>
        <source>inside the envelope · %1</source>
        <translation>在运行包络内 · %1</translation>
    </message>
    <message>
        <source>inside the envelope · %1 of %2 · %3</source>
        <translation>在运行包络内 · %1 / %2 · %3</translation>
    </message>
    <message>
        <source>This mode has no loop that can be tried; Live drives it.</source>
        <translation>此模式没有可试验的回路；请用“实时”驱动。</translation>
    </message>
    <message>
        <source>Nothing bounds the motor: enter travel, duty, and what else is empty here.</source>
        <translation>电机没有任何限定：请输入行程、占空比以及此处其他空白项。</translation>
    </message>
    <message>
        <source>Enter where the loop is to go.</source>
        <translation>请输入回路的目标。</translation>
    </message>
    <message>
        <source>It is there already; enter another place to go to.</source>
        <translation>已在该处；请输入其他目标。</translation>
    </message>
</context>
<context>
    <name>mb::ExportBar</name>
    <message>
        <source>Progress of the export</source>
        <translation>导出进度</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Writing samples</source>
        <translation>正在写入采样</translation>
    </message>
    <message>
        <source>One export at a time: %1 is being written.</source>
        <translation>一次只能进行一个导出：正在写入 %1。</translation>
    </message>
    <message>
        <source>writing %1</source>
        <translation>正在写入 %1</translation>
    </message>
    <message>
        <source>%1 written: %2 samples, %3 lost</source>
        <translation>%1 已写入：%2 个采样，丢失 %3 个</translation>
    </message>
    <message>
        <source>export cancelled, nothing was written</source>
        <translation>导出已取消，未写入任何内容</translation>
    </message>
</context>
<context>
    <name>mb::FaultLine</name>
    <message>
        <source>Is that meant?</source>
        <translation>确实如此吗？</translation>
    </message>
    <message>
        <source>Use %1</source>
        <translation>使用 %1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Revert to %1</source>
        <translation>还原为 %1</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>还原</translation>
    </message>
</context>
<context>
    <name>mb::FileExchange</name>
    <message>
        <source>%1 says what the device has.</source>
        <translation>%1 与设备内容一致。</translation>
    </message>
    <message>
        <source>Nothing is staged.</source>
        <translation>没有暂存内容。</translation>
    </message>
    <message>
        <source>Import of %1</source>
        <translation>导入 %1</translation>
    </message>
    <message>
        <source>Nothing is written yet: look through the list, then write.</source>
        <translation>尚未写入任何内容：请先查看列表，然后写入。</translation>
    </message>
    <message>
        <source>Left out: %1, for one: %2.</source>
        <translation>已略过：%1 项，例如：%2。</translation>
    </message>
    <message>
        <source>Staged from %1: %2 of its values differ.</source>
        <translation>已从 %1 暂存：其中 %2 个值不同。</translation>
    </message>
    <message>
        <source>Undo the import</source>
        <translation>撤销导入</translation>
    </message>
    <message>
        <source>Choose another place.</source>
        <translation>请选择其他位置。</translation>
    </message>
    <message>
        <source>%1 parameters exported to %2</source>
        <translation>已将 %1 个参数导出到 %2</translation>
    </message>
</context>
<context>
    <name>mb::FirmwarePage</name>
    <message>
        <source>Firmware</source>
        <translation>固件</translation>
    </message>
    <message>
        <source>starts the update</source>
        <translation>开始更新</translation>
    </message>
    <message>
        <source>What is updated</source>
        <translation>更新对象</translation>
    </message>
    <message>
        <source>Selected unit</source>
        <translation>所选设备</translation>
    </message>
    <message>
        <source>Queue of units</source>
        <translation>设备队列</translation>
    </message>
    <message>
        <source>Unit that does not answer</source>
        <translation>无应答的设备</translation>
    </message>
    <message>
        <source>A unit whose update was cut may be mute: say where it is, and it can be written again</source>
        <translation>更新被中断的设备可能不再应答：指出它在哪里，即可重新写入</translation>
    </message>
</context>
<context>
    <name>mb::FirmwareShelf</name>
    <message>
        <source>not read yet</source>
        <translation>尚未读取</translation>
    </message>
    <message>
        <source>%1 · checked · %2</source>
        <translation>%1 · 已检查 · %2</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>详细信息</translation>
    </message>
</context>
<context>
    <name>mb::FrameDetail</name>
    <message>
        <source>Selected frame</source>
        <translation>所选帧</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>帧</translation>
    </message>
    <message>
        <source>Fields</source>
        <translation>字段</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>复制</translation>
    </message>
    <message>
        <source>Copy the selected frames as candump text (Ctrl+C)</source>
        <translation>将所选帧复制为 candump 文本 (Ctrl+C)</translation>
    </message>
    <message>
        <source>Send again…</source>
        <translation>再次发送…</translation>
    </message>
    <message>
        <source>No frame selected</source>
        <translation>未选择帧</translation>
    </message>
    <message>
        <source>Select one to see its fields</source>
        <translation>选择一帧以查看其字段</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Error frame</source>
        <translation>错误帧</translation>
    </message>
    <message>
        <source>Unknown frame</source>
        <translation>未知帧</translation>
    </message>
    <message>
        <source>sent</source>
        <translation>已发送</translation>
    </message>
    <message>
        <source>received</source>
        <translation>已接收</translation>
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
        <translation>%1 = %2，位 %3</translation>
    </message>
    <message>
        <source>%1 bytes</source>
        <translation>%1 字节</translation>
    </message>
</context>
<context>
    <name>mb::FrameModel</name>
    <message>
        <source>err</source>
        <translation>错误</translation>
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
        <translation>%1 字节</translation>
    </message>
    <message>
        <source>error frame</source>
        <translation>错误帧</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>asks for data</source>
        <translation>请求数据</translation>
    </message>
    <message>
        <source>no decoder knows this identifier</source>
        <translation>没有解码器认识此标识符</translation>
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
        <translation>方向</translation>
    </message>
    <message>
        <source>id</source>
        <translation>id</translation>
    </message>
    <message>
        <source>message</source>
        <translation>消息</translation>
    </message>
    <message>
        <source>dev</source>
        <translation>设备</translation>
    </message>
    <message>
        <source>decoded</source>
        <translation>解码</translation>
    </message>
    <message>
        <source>data</source>
        <translation>数据</translation>
    </message>
</context>
<context>
    <name>mb::GainRow</name>
    <message>
        <source>Use it</source>
        <translation>采用</translation>
    </message>
    <message>
        <source>Use this %1</source>
        <translation>采用此 %1</translation>
    </message>
    <message>
        <source>Revert %1</source>
        <translation>还原 %1</translation>
    </message>
    <message>
        <source>%1, one decade either way</source>
        <translation>%1，上下各一个十倍程</translation>
    </message>
    <message>
        <source>One decade either way. ← → 2 %, with Shift 0.2 %, with Ctrl 20 %</source>
        <translation>上下各一个十倍程。← → 2 %，按 Shift 为 0.2 %，按 Ctrl 为 20 %</translation>
    </message>
    <message>
        <source>stored</source>
        <translation>已存储</translation>
    </message>
    <message>
        <source>RAM</source>
        <translation>RAM</translation>
    </message>
    <message>
        <source>volatile</source>
        <translation>易失</translation>
    </message>
    <message>
        <source>assumed</source>
        <translation>假定</translation>
    </message>
    <message>
        <source>edited</source>
        <translation>已编辑</translation>
    </message>
    <message>
        <source>range</source>
        <translation>超范围</translation>
    </message>
    <message>
        <source>reading</source>
        <translation>读取中</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>edited, was %1</source>
        <translation>已编辑，原为 %1</translation>
    </message>
    <message>
        <source>edited, was unknown</source>
        <translation>已编辑，原值未知</translation>
    </message>
    <message>
        <source>raw %1   %2</source>
        <translation>原始值 %1   %2</translation>
    </message>
    <message>
        <source>unknown until written</source>
        <translation>写入之前未知</translation>
    </message>
</context>
<context>
    <name>mb::GainsPanel</name>
    <message>
        <source>Gains</source>
        <translation>增益</translation>
    </message>
    <message>
        <source>G · ← → 2 % · Shift 0.2 %</source>
        <translation>G · ← → 2 % · Shift 0.2 %</translation>
    </message>
    <message>
        <source>Gains, slot %1</source>
        <translation>增益，槽 %1</translation>
    </message>
    <message>
        <source>Gains, axis %1</source>
        <translation>增益，轴 %1</translation>
    </message>
    <message>
        <source>Hide limits of the loop</source>
        <translation>隐藏回路限值</translation>
    </message>
    <message>
        <source>Divisor</source>
        <translation>除数</translation>
    </message>
    <message>
        <source>Limits of the axis</source>
        <translation>轴的限值</translation>
    </message>
    <message>
        <source>Limits of the loop</source>
        <translation>回路限值</translation>
    </message>
    <message>
        <source>No loop runs in %1 mode: only the limits of the axis act.</source>
        <translation>%1模式下没有回路运行：仅轴的限值起作用。</translation>
    </message>
    <message>
        <source>No loop runs in %1 mode: these gains act in velocity, position and current.</source>
        <translation>%1模式下没有回路运行：这些增益作用于速度、位置和电流模式。</translation>
    </message>
    <message>
        <source>off</source>
        <translation>关</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
</context>
<context>
    <name>mb::GainsWriteRow</name>
    <message>
        <source>Write gains</source>
        <translation>写入增益</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>还原</translation>
    </message>
    <message>
        <source>Revert all staged gains</source>
        <translation>还原所有暂存的增益</translation>
    </message>
    <message numerus="yes">
        <source>%n value(s)</source>
        <translation>
            <numerusform>%n 个值</numerusform>
        </translation>
    </message>
    <message>
        <source>Write %1 to slot %2</source>
        <translation>将 %1 写入槽 %2</translation>
    </message>
    <message>
        <source>Write %1</source>
        <translation>写入 %1</translation>
    </message>
    <message>
        <source>A gain is out of range</source>
        <translation>有增益超出范围</translation>
    </message>
    <message>
        <source>No gain is edited</source>
        <translation>未编辑任何增益</translation>
    </message>
    <message>
        <source>The device is busy</source>
        <translation>设备忙</translation>
    </message>
</context>
<context>
    <name>mb::GroupMotion</name>
    <message>
        <source>not prepared: hold the Arm button first</source>
        <translation>未准备：请先按住“解锁”按钮</translation>
    </message>
    <message>
        <source>not prepared: the selected device has to take part</source>
        <translation>未准备：所选设备必须参与</translation>
    </message>
    <message>
        <source>not started: not every device has acknowledged its move; prepare them again</source>
        <translation>未启动：并非每台设备都已确认其运动；请重新准备</translation>
    </message>
    <message>
        <source>stopped, and the others of its group with it: %1</source>
        <translation>已停止，同组的其他设备也随之停止：%1</translation>
    </message>
    <message>
        <source>it is gone</source>
        <translation>它已不存在</translation>
    </message>
    <message>
        <source>not prepared: an experiment on the selected device has not ended</source>
        <translation>未准备：所选设备上的实验尚未结束</translation>
    </message>
</context>
<context>
    <name>mb::GuardianCheck</name>
    <message>
        <source>stops a motor when this program is killed or hangs</source>
        <translation>本程序被终止或卡死时停止电机</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>检查</translation>
    </message>
    <message>
        <source>Check the guardian</source>
        <translation>检查守护进程</translation>
    </message>
    <message>
        <source>%1 cannot be started: %2</source>
        <translation>无法启动 %1：%2</translation>
    </message>
    <message>
        <source>It is in place and runs.</source>
        <translation>已就位且可以运行。</translation>
    </message>
    <message>
        <source>%1 does not run as it should.</source>
        <translation>%1 未按预期运行。</translation>
    </message>
</context>
<context>
    <name>mb::Guide</name>
    <message>
        <source>overshoot %1 % at first, %2 % now</source>
        <translation>超调起初为 %1 %，现在为 %2 %</translation>
    </message>
    <message>
        <source>overshoot %1 %</source>
        <translation>超调 %1 %</translation>
    </message>
    <message>
        <source>peak current %1 A</source>
        <translation>峰值电流 %1 A</translation>
    </message>
    <message>
        <source>%1 counts beside its target at first, %2 now</source>
        <translation>起初距目标 %1 个计数，现在 %2</translation>
    </message>
    <message>
        <source>%1 counts beside its target</source>
        <translation>距目标 %1 个计数</translation>
    </message>
</context>
<context>
    <name>mb::GuideStrip</name>
    <message>
        <source>Guide</source>
        <translation>向导</translation>
    </message>
    <message>
        <source>Show me where</source>
        <translation>指给我看</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>开始</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>忽略</translation>
    </message>
    <message>
        <source>Not now</source>
        <translation>暂不</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Simulated: nothing real moves. A guide says each step and waits until it has happened.</source>
        <translation>仿真：不会有真实的运动。向导逐步说明，并等待每步完成。</translation>
    </message>
    <message>
        <source>%1 done</source>
        <translation>%1 已完成</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>Done.</source>
        <translation>完成。</translation>
    </message>
    <message>
        <source>The simulated bench is opened; the unit answers in a moment.</source>
        <translation>仿真台架已打开；设备很快就会应答。</translation>
    </message>
    <message>
        <source>Measured: %1.</source>
        <translation>实测：%1。</translation>
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
        <translation>程序菜单</translation>
    </message>
    <message>
        <source>1 link</source>
        <translation>1 个链路</translation>
    </message>
    <message numerus="yes">
        <source>%n links</source>
        <translation>
            <numerusform>%n 个链路</numerusform>
        </translation>
    </message>
    <message>
        <source>Links</source>
        <translation>链路</translation>
    </message>
    <message>
        <source>no alarms</source>
        <translation>无报警</translation>
    </message>
    <message>
        <source>1 notice</source>
        <translation>1 条通知</translation>
    </message>
    <message numerus="yes">
        <source>%n notices</source>
        <translation>
            <numerusform>%n 条通知</numerusform>
        </translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>录制中</translation>
    </message>
</context>
<context>
    <name>mb::HelpBrowser</name>
    <message>
        <source>Help</source>
        <translation>帮助</translation>
    </message>
</context>
<context>
    <name>mb::HelpDesk</name>
    <message>
        <source>Help for this page</source>
        <translation>此页面的帮助</translation>
    </message>
</context>
<context>
    <name>mb::HelpWindow</name>
    <message>
        <source>Help</source>
        <translation>帮助</translation>
    </message>
    <message>
        <source>Pages of the help</source>
        <translation>帮助的页面</translation>
    </message>
</context>
<context>
    <name>mb::HistoryPanel</name>
    <message>
        <source>State A</source>
        <translation>状态 A</translation>
    </message>
    <message>
        <source>State B</source>
        <translation>状态 B</translation>
    </message>
    <message>
        <source>Which parameters</source>
        <translation>哪些参数</translation>
    </message>
    <message>
        <source>Only differences</source>
        <translation>仅差异</translation>
    </message>
    <message>
        <source>All</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>Restore what is ticked</source>
        <translation>恢复勾选项</translation>
    </message>
    <message>
        <source>Only differences %1</source>
        <translation>仅差异 %1</translation>
    </message>
    <message>
        <source>All %1</source>
        <translation>全部 %1</translation>
    </message>
    <message>
        <source>%1 ticked; a snapshot of what is there is taken first.</source>
        <translation>已勾选 %1 项；会先为当前内容建立快照。</translation>
    </message>
    <message>
        <source>Choose what the device has now as A to write values of B.</source>
        <translation>要写入 B 的值，请将设备当前值选为 A。</translation>
    </message>
    <message>
        <source>Restore %1</source>
        <translation>恢复 %1</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>时间线</translation>
    </message>
    <message>
        <source>differences from A</source>
        <translation>与 A 的差异</translation>
    </message>
    <message>
        <source>Click sets B, Shift+click sets A.</source>
        <translation>单击设置 B，Shift+单击设置 A。</translation>
    </message>
    <message>
        <source>Exchange A and B</source>
        <translation>交换 A 和 B</translation>
    </message>
    <message>
        <source>Copy as text</source>
        <translation>复制为文本</translation>
    </message>
    <message>
        <source>Keep or revert first</source>
        <translation>请先保留或恢复</translation>
    </message>
</context>
<context>
    <name>mb::IdModel</name>
    <message>
        <source>err</source>
        <translation>错误</translation>
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
        <translation>错误帧</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>every %1 ms, standard deviation %2 ms, largest deviation %3 ms, over the last 32 periods</source>
        <translation>每 %1 ms 一次，标准差 %2 ms，最大偏差 %3 ms，取自最近 32 个周期</translation>
    </message>
    <message>
        <source>Right click: choose the field</source>
        <translation>右键单击：选择字段</translation>
    </message>
    <message>
        <source>Standard deviation of the last 32 periods</source>
        <translation>最近 32 个周期的标准差</translation>
    </message>
    <message>
        <source>The last frame; bytes that changed within 0.7 s are marked</source>
        <translation>最后一帧；0.7 s 内变化过的字节会被标记</translation>
    </message>
    <message>
        <source>id</source>
        <translation>id</translation>
    </message>
    <message>
        <source>dir</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>message</source>
        <translation>消息</translation>
    </message>
    <message>
        <source>dev</source>
        <translation>设备</translation>
    </message>
    <message>
        <source>rate Hz</source>
        <translation>频率 Hz</translation>
    </message>
    <message>
        <source>jitter ms</source>
        <translation>抖动 ms</translation>
    </message>
    <message>
        <source>frames</source>
        <translation>帧数</translation>
    </message>
    <message>
        <source>data</source>
        <translation>数据</translation>
    </message>
    <message>
        <source>last value</source>
        <translation>最新值</translation>
    </message>
    <message>
        <source>last 5 s</source>
        <translation>最近 5 s</translation>
    </message>
</context>
<context>
    <name>mb::ImageText</name>
    <message>
        <source>no image yet</source>
        <translation>尚无映像</translation>
    </message>
    <message>
        <source>Open an Intel HEX file, or drop it here</source>
        <translation>打开 Intel HEX 文件，或将其拖放到此处</translation>
    </message>
    <message>
        <source>select a device to check it</source>
        <translation>选择设备以进行检查</translation>
    </message>
    <message>
        <source>version %1 · pages: %2</source>
        <translation>版本 %1 · 页：%2</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>未知</translation>
    </message>
</context>
<context>
    <name>mb::Inspector</name>
    <message>
        <source>Inspector</source>
        <translation>检查器</translation>
    </message>
    <message>
        <source>Identify</source>
        <translation>识别</translation>
    </message>
    <message>
        <source>Read all</source>
        <translation>全部读取</translation>
    </message>
    <message>
        <source>Read every parameter of this unit</source>
        <translation>读取此设备的所有参数</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>实时</translation>
    </message>
    <message>
        <source>position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>velocity</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>current</source>
        <translation>电流</translation>
    </message>
    <message>
        <source>duty</source>
        <translation>占空比</translation>
    </message>
    <message>
        <source>bus</source>
        <translation>总线</translation>
    </message>
    <message>
        <source>case</source>
        <translation>外壳</translation>
    </message>
    <message>
        <source>Identity</source>
        <translation>标识</translation>
    </message>
    <message>
        <source>serial</source>
        <translation>序列号</translation>
    </message>
    <message>
        <source>firmware</source>
        <translation>固件</translation>
    </message>
    <message>
        <source>bootloader</source>
        <translation>引导程序</translation>
    </message>
    <message>
        <source>session</source>
        <translation>会话</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>faults</source>
        <translation>故障</translation>
    </message>
    <message>
        <source>over-temperature</source>
        <translation>过温</translation>
    </message>
    <message>
        <source>limits</source>
        <translation>限位</translation>
    </message>
    <message>
        <source>changed from default</source>
        <translation>与默认值不同</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>in RAM only</source>
        <translation>仅在 RAM 中</translation>
    </message>
    <message>
        <source>No device selected</source>
        <translation>未选择设备</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Blink the lamps of this unit</source>
        <translation>使此设备的指示灯闪烁</translation>
    </message>
</context>
<context>
    <name>mb::JogPanel</name>
    <message>
        <source>Nudge −</source>
        <translation>微动 −</translation>
    </message>
    <message>
        <source>Nudge +</source>
        <translation>微动 +</translation>
    </message>
    <message>
        <source>Nudge backwards</source>
        <translation>反向微动</translation>
    </message>
    <message>
        <source>Nudge forwards</source>
        <translation>正向微动</translation>
    </message>
    <message>
        <source>A click moves it for a tenth of a second; held, it goes on until it is let go.</source>
        <translation>单击使其运动十分之一秒；按住则持续运动直到松开。</translation>
    </message>
</context>
<context>
    <name>mb::JournalCard</name>
    <message>
        <source>Journal</source>
        <translation>日志簿</translation>
    </message>
    <message>
        <source>Change…</source>
        <translation>更改…</translation>
    </message>
    <message>
        <source>Change the journal</source>
        <translation>更改日志簿</translation>
    </message>
    <message>
        <source>On this computer</source>
        <translation>在这台计算机上</translation>
    </message>
    <message>
        <source>PostgreSQL, %1</source>
        <translation>PostgreSQL，%1</translation>
    </message>
    <message>
        <source>station %1</source>
        <translation>工位 %1</translation>
    </message>
    <message numerus="yes">
        <source>%n entries wait for the server</source>
        <translation>
            <numerusform>%n 条记录等待服务器</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n units of this run are in it</source>
        <translation>
            <numerusform>本次的 %n 台已记入</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mb::KeepBar</name>
    <message>
        <source>30 s from when the unit has restarted with them</source>
        <translation>自设备以这些值重新启动起 30 s</translation>
    </message>
    <message>
        <source>they go back in %1 s</source>
        <translation>%1 s 后恢复原值</translation>
    </message>
    <message>
        <source>they go back as soon as the motor stands</source>
        <translation>电机一静止即恢复原值</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>保留</translation>
    </message>
    <message>
        <source>Time until the values go back</source>
        <translation>距恢复原值的时间</translation>
    </message>
    <message numerus="yes">
        <source>%1 · %n more change(s) after this one</source>
        <translation>
            <numerusform>%1 · 此后还有 %n 项更改</numerusform>
        </translation>
    </message>
    <message>
        <source>Keep these values of %1?</source>
        <translation>保留 %1 的这些值吗?</translation>
    </message>
    <message>
        <source>nothing goes back by itself</source>
        <translation>不会自动恢复</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>恢复</translation>
    </message>
</context>
<context>
    <name>mb::KeyBook</name>
    <message>
        <source>This key cannot be changed.</source>
        <translation>此按键不能更改。</translation>
    </message>
    <message>
        <source>%1 stops every motor, always.</source>
        <translation>%1 始终停止所有电机。</translation>
    </message>
    <message>
        <source>%1 is taken, %2: %3. Give that another key first.</source>
        <translation>%1 已被占用，%2：%3。请先给它另一个按键。</translation>
    </message>
    <message>
        <source>%1 belongs to the control that has the focus.</source>
        <translation>%1 属于具有焦点的控件。</translation>
    </message>
</context>
<context>
    <name>mb::KeyDesk</name>
    <message>
        <source>stop every motor</source>
        <translation>停止所有电机</translation>
    </message>
    <message>
        <source>stops every motor, unless words can be typed where the focus is</source>
        <translation>停止所有电机，焦点处可输入文字时除外</translation>
    </message>
    <message>
        <source>presses the button or ticks the box that has the focus</source>
        <translation>按下具有焦点的按钮或勾选复选框</translation>
    </message>
    <message>
        <source>held for 1 s: arms; let go early it does nothing</source>
        <translation>按住 1 s：解锁；提前松开则不起作用</translation>
    </message>
    <message>
        <source>keeps values that go back by themselves otherwise</source>
        <translation>保留否则会自动恢复的值</translation>
    </message>
    <message>
        <source>Everywhere</source>
        <translation>全局</translation>
    </message>
    <message>
        <source>Production</source>
        <translation>生产</translation>
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
        <translation>在此按下新按键</translation>
    </message>
    <message>
        <source>New key</source>
        <translation>新按键</translation>
    </message>
</context>
<context>
    <name>mb::KeysPanel</name>
    <message>
        <source>Search commands and keys</source>
        <translation>搜索命令和按键</translation>
    </message>
    <message>
        <source>Commands and their keys</source>
        <translation>命令及其按键</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>命令</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>按键</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>默认值</translation>
    </message>
    <message>
        <source>No key</source>
        <translation>无按键</translation>
    </message>
    <message>
        <source>All defaults</source>
        <translation>全部默认</translation>
    </message>
    <message>
        <source>All keys are those they came with.</source>
        <translation>所有按键已恢复默认。</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>It came with: %1</source>
        <translation>默认：%1</translation>
    </message>
    <message>
        <source>This key cannot be changed.</source>
        <translation>此按键不能更改。</translation>
    </message>
    <message>
        <source>Choose a command, then press its new key in the field.</source>
        <translation>选择一个命令，然后在输入框中按下新按键。</translation>
    </message>
</context>
<context>
    <name>mb::Lamp</name>
    <message>
        <source>Arm button: %1</source>
        <translation>解锁按钮：%1</translation>
    </message>
    <message>
        <source>A motor was told to stop and was not seen to. Cut its power, or look at it.</source>
        <translation>已命令一台电机停止，但未确认其停止。请切断其电源，或前去查看。</translation>
    </message>
    <message>
        <source>Press to make it safe again</source>
        <translation>按下以恢复安全状态</translation>
    </message>
    <message>
        <source>Hold for one second to arm</source>
        <translation>按住一秒钟以解锁</translation>
    </message>
</context>
<context>
    <name>mb::LampFace</name>
    <message>
        <source>SAFE</source>
        <translation>安全</translation>
    </message>
    <message>
        <source>ARMED</source>
        <translation>已解锁</translation>
    </message>
    <message>
        <source>MOVING</source>
        <translation>运动中</translation>
    </message>
    <message>
        <source>STOPPED</source>
        <translation>已停止</translation>
    </message>
    <message>
        <source>STOPPING</source>
        <translation>正在停止</translation>
    </message>
    <message>
        <source>MAY STILL TURN</source>
        <translation>可能仍在转动</translation>
    </message>
    <message>
        <source>keep holding</source>
        <translation>继续按住</translation>
    </message>
    <message>
        <source>hold to arm</source>
        <translation>按住以解锁</translation>
    </message>
    <message>
        <source>nothing to arm</source>
        <translation>没有可解锁的设备</translation>
    </message>
    <message>
        <source>hold to re-arm</source>
        <translation>按住重新解锁</translation>
    </message>
    <message>
        <source>cut its power</source>
        <translation>切断其电源</translation>
    </message>
    <message>
        <source>#88 velocity</source>
        <translation>#88 速度</translation>
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
        <translation>负载 %1</translation>
    </message>
    <message>
        <source>lost %1</source>
        <translation>丢失 %1</translation>
    </message>
    <message>
        <source>Link %1: %2</source>
        <translation>链路 %1：%2</translation>
    </message>
</context>
<context>
    <name>mb::LinkOptions</name>
    <message>
        <source>Bit rate</source>
        <translation>比特率</translation>
    </message>
    <message>
        <source>find it: all rates of the protocol</source>
        <translation>查找：该协议的所有速率</translation>
    </message>
    <message>
        <source>%1 bit/s</source>
        <translation>%1 bit/s</translation>
    </message>
    <message>
        <source>the computer&apos;s own RS-485 port</source>
        <translation>计算机自身的 RS-485 端口</translation>
    </message>
    <message>
        <source>RS-485</source>
        <translation>RS-485</translation>
    </message>
    <message>
        <source>Lets the kernel switch the driver of a port on the computer&apos;s board. Adapters on USB switch by themselves: leave it off.</source>
        <translation>由内核切换计算机主板上端口的驱动方向。USB 适配器会自行切换：请保持关闭。</translation>
    </message>
    <message>
        <source>Clock</source>
        <translation>时钟</translation>
    </message>
    <message>
        <source>%1 kHz</source>
        <translation>%1 kHz</translation>
    </message>
    <message>
        <source>Ready line (SRDY)</source>
        <translation>就绪线 (SRDY)</translation>
    </message>
    <message>
        <source>Reset line (MCLR)</source>
        <translation>复位线 (MCLR)</translation>
    </message>
    <message>
        <source>Lost frames</source>
        <translation>丢失的帧</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>not wired</source>
        <translation>未接线</translation>
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
        <translation>%1，进程 %2</translation>
    </message>
    <message>
        <source>%1 has this link too. Agree who drives: two masters on one motor disturb each other.</source>
        <translation>%1 也在使用此链路。请商定由谁驱动：一台电机有两个主站会互相干扰。</translation>
    </message>
    <message>
        <source>%1 has this port. Close it there, then reconnect.</source>
        <translation>%1 占用此端口。请在那里关闭，然后重新连接。</translation>
    </message>
</context>
<context>
    <name>mb::ListCard</name>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
</context>
<context>
    <name>mb::LiveStateBar</name>
    <message>
        <source>Limits and pins</source>
        <translation>限位与引脚</translation>
    </message>
    <message>
        <source>no limit holds</source>
        <translation>没有限位起作用</translation>
    </message>
</context>
<context>
    <name>mb::LogPage</name>
    <message>
        <source>Log</source>
        <translation>日志</translation>
    </message>
    <message>
        <source>Search the log</source>
        <translation>搜索日志</translation>
    </message>
    <message>
        <source>Severity</source>
        <translation>严重程度</translation>
    </message>
    <message>
        <source>All</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>Cautions</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>Faults</source>
        <translation>故障</translation>
    </message>
    <message>
        <source>Save log…</source>
        <translation>保存日志…</translation>
    </message>
    <message>
        <source>Nothing yet</source>
        <translation>尚无内容</translation>
    </message>
    <message>
        <source>Actions and faults appear here.</source>
        <translation>操作和故障会显示在此处。</translation>
    </message>
    <message>
        <source>Log lines</source>
        <translation>日志行</translation>
    </message>
    <message>
        <source>Save the log</source>
        <translation>保存日志</translation>
    </message>
    <message>
        <source>Text (*.log *.txt)</source>
        <translation>文本 (*.log *.txt)</translation>
    </message>
    <message>
        <source>log saved to %1</source>
        <translation>日志已保存到 %1</translation>
    </message>
    <message>
        <source>searches</source>
        <translation>搜索</translation>
    </message>
</context>
<context>
    <name>mb::MainWindow</name>
    <message>
        <source>lost</source>
        <translation>丢失</translation>
    </message>
    <message>
        <source>%1: %2 frames received, %3 sent, %4 dropped, %5 errors</source>
        <translation>%1：接收 %2 帧，发送 %3，丢弃 %4，错误 %5</translation>
    </message>
    <message>
        <source>%1: %2 bytes received, %3 sent, %4 dropped, %5 errors</source>
        <translation>%1：接收 %2 字节，发送 %3，丢弃 %4，错误 %5</translation>
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
        <translation>按钮</translation>
    </message>
    <message>
        <source>Overview</source>
        <translation>概览</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>Tune</source>
        <translation>整定</translation>
    </message>
    <message>
        <source>Design</source>
        <translation>设计</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>曲线图</translation>
    </message>
    <message>
        <source>Firmware</source>
        <translation>固件</translation>
    </message>
    <message>
        <source>Bus</source>
        <translation>总线</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>日志</translation>
    </message>
    <message>
        <source>Reports</source>
        <translation>报告</translation>
    </message>
    <message>
        <source>needs a device; open a link first</source>
        <translation>需要设备；请先打开链路</translation>
    </message>
    <message>
        <source>simulated bench</source>
        <translation>仿真台架</translation>
    </message>
    <message>
        <source>the window lost the focus</source>
        <translation>窗口失去焦点</translation>
    </message>
    <message>
        <source>The preferences hold as soon as nothing is armed, no job runs and no other window is open.</source>
        <translation>一旦没有设备处于已解锁状态、没有作业在运行、也没有打开其他窗口，首选项就会生效。</translation>
    </message>
    <message>
        <source>the limits were not kept: %1</source>
        <translation>限值未被保留：%1</translation>
    </message>
</context>
<context>
    <name>mb::MetricsPanel</name>
    <message>
        <source>Metrics</source>
        <translation>指标</translation>
    </message>
    <message>
        <source>Metrics of A and B</source>
        <translation>A 与 B 的指标</translation>
    </message>
    <message>
        <source>Loop health</source>
        <translation>回路健康状况</translation>
    </message>
    <message>
        <source>metric</source>
        <translation>指标</translation>
    </message>
    <message>
        <source>Δ B − A</source>
        <comment>difference</comment>
        <translation>Δ B − A</translation>
    </message>
    <message>
        <source>± from %1 repeats</source>
        <translation>± 取自 %1 次重复</translation>
    </message>
    <message>
        <source>%1= same</source>
        <translation>%1= 相同</translation>
    </message>
    <message>
        <source>SAT %1 %</source>
        <translation>饱和 %1 %</translation>
    </message>
    <message>
        <source>Share of the hold in which the duty was at its limit</source>
        <translation>保持期间占空比处于限值的份额</translation>
    </message>
    <message>
        <source>ILIM</source>
        <translation>限流</translation>
    </message>
    <message>
        <source>The current was at its limit</source>
        <translation>电流处于限值</translation>
    </message>
    <message>
        <source>RAMP</source>
        <translation>斜坡</translation>
    </message>
    <message>
        <source>The drive&apos;s own ramp was on</source>
        <translation>驱动器自身的斜坡已启用</translation>
    </message>
    <message>
        <source>LIMIT SW</source>
        <translation>限位</translation>
    </message>
    <message>
        <source>A limit switch was met</source>
        <translation>碰到限位开关</translation>
    </message>
    <message>
        <source>WINDUP %1</source>
        <translation>积分饱和 %1</translation>
    </message>
    <message>
        <source>WINDUP</source>
        <translation>积分饱和</translation>
    </message>
    <message>
        <source>The duty was at its limit while I went on; that is paid back as overshoot</source>
        <translation>占空比处于限值而 I 仍在积分；这会以超调的形式偿还</translation>
    </message>
    <message>
        <source>QUANT</source>
        <translation>量化</translation>
    </message>
    <message>
        <source>The step has few counts of the encoder</source>
        <translation>阶跃的编码器计数过少</translation>
    </message>
    <message>
        <source>LOST %1</source>
        <translation>丢失 %1</translation>
    </message>
    <message>
        <source>Samples that are missing</source>
        <translation>缺失的采样</translation>
    </message>
    <message>
        <source>SIMULATED</source>
        <translation>仿真</translation>
    </message>
    <message>
        <source>Made on a simulated controller, and marked so for ever</source>
        <translation>在仿真控制器上得出，并永久如此标记</translation>
    </message>
    <message>
        <source>means of %1 repeats</source>
        <translation>%1 次的平均值</translation>
    </message>
    <message>
        <source>%1= same ±%2</source>
        <translation>%1= 相同 ±%2</translation>
    </message>
</context>
<context>
    <name>mb::ModePanel</name>
    <message>
        <source>Mode</source>
        <translation>模式</translation>
    </message>
    <message>
        <source>%1 mode</source>
        <translation>%1模式</translation>
    </message>
</context>
<context>
    <name>mb::ModelPanel</name>
    <message>
        <source>Model</source>
        <translation>模型</translation>
    </message>
    <message>
        <source>Nobody has identified this motor yet. Identify pushes it both ways with a part of the duty, inside the limits below, and changes no gain.</source>
        <translation>此电机尚未辨识。“辨识”在下列限值内以部分占空比向两个方向推动电机，不更改任何增益。</translation>
    </message>
    <message>
        <source>good fit</source>
        <translation>拟合良好</translation>
    </message>
    <message>
        <source>not believed</source>
        <translation>不可信</translation>
    </message>
    <message>
        <source>counts/s</source>
        <translation>counts/s</translation>
    </message>
    <message>
        <source>velocity filter</source>
        <translation>速度滤波器</translation>
    </message>
    <message>
        <source>All figures</source>
        <translation>全部数值</translation>
    </message>
    <message>
        <source>Fold</source>
        <translation>收起</translation>
    </message>
</context>
<context>
    <name>mb::MotionTour</name>
    <message>
        <source>acceleration</source>
        <translation>加速度</translation>
    </message>
    <message>
        <source>counts/s²</source>
        <translation>counts/s²</translation>
    </message>
    <message>
        <source>at speed</source>
        <translation>恒速</translation>
    </message>
</context>
<context>
    <name>mb::MotionWords</name>
    <message>
        <source>%1 axes</source>
        <translation>%1 轴</translation>
    </message>
    <message>
        <source>axis %1 %2</source>
        <translation>轴 %1 %2</translation>
    </message>
    <message>
        <source>%1 on the adapter before</source>
        <translation>先前适配器上的 %1</translation>
    </message>
</context>
<context>
    <name>mb::MovesPanel</name>
    <message>
        <source>Moves together</source>
        <translation>同步运动</translation>
    </message>
    <message>
        <source>to a position</source>
        <translation>到某位置</translation>
    </message>
    <message>
        <source>by a distance</source>
        <translation>移动一段距离</translation>
    </message>
    <message>
        <source>at a velocity</source>
        <translation>以某速度</translation>
    </message>
    <message>
        <source>Kind of the moves</source>
        <translation>运动类型</translation>
    </message>
    <message>
        <source>profiled</source>
        <translation>带轮廓</translation>
    </message>
    <message>
        <source>With the stored acceleration and velocity</source>
        <translation>使用已存储的加速度和速度</translation>
    </message>
    <message>
        <source>With the acceleration and velocity that are stored in the device.</source>
        <translation>使用设备中存储的加速度和速度。</translation>
    </message>
    <message>
        <source>Prepare</source>
        <translation>准备</translation>
    </message>
    <message>
        <source>Switches the motors on where they stand, and gives each its move to keep.</source>
        <translation>在电机当前位置将其接通，并为每台设备预置其运动。</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>启动</translation>
    </message>
    <message>
        <source>Start the prepared moves together</source>
        <translation>同时启动已准备的运动</translation>
    </message>
    <message>
        <source>One command on the line starts all prepared moves at the same moment.</source>
        <translation>线路上的一条命令同时启动所有已准备的运动。</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>保持</translation>
    </message>
    <message>
        <source>Hold all of them where they are</source>
        <translation>将所有电机保持在当前位置</translation>
    </message>
    <message>
        <source>Brakes to a halt and holds the position. The motors stay on; STOP switches them off.</source>
        <translation>制动至静止并保持位置。电机保持接通；STOP 将其关闭。</translation>
    </message>
    <message>
        <source>%1 takes part</source>
        <translation>%1 参与</translation>
    </message>
    <message>
        <source>Target of %1</source>
        <translation>%1 的目标</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>无应答</translation>
    </message>
    <message>
        <source>started</source>
        <translation>已启动</translation>
    </message>
    <message>
        <source>prepared</source>
        <translation>已准备</translation>
    </message>
    <message>
        <source>being prepared</source>
        <translation>正在准备</translation>
    </message>
    <message>
        <source>moving</source>
        <translation>运动中</translation>
    </message>
    <message>
        <source>keeps a move</source>
        <translation>保留着一个运动</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>已锁定</translation>
    </message>
    <message>
        <source>off</source>
        <translation>关</translation>
    </message>
    <message>
        <source>All are prepared. Start begins them at the same moment.</source>
        <translation>全部已准备。“启动”使其同时开始。</translation>
    </message>
    <message>
        <source>Stop takes no move away that has not begun: %1 would begin it with the next start on this line. Prepare gives a new one; switching the unit off clears it.</source>
        <translation>停止不会取消尚未开始的运动：%1 会随此线路上的下一次启动而开始执行。“准备”会给出新的运动；关闭设备会将其清除。</translation>
    </message>
    <message>
        <source>Hold the Arm button. It covers all that take part.</source>
        <translation>按住“解锁”按钮。它对所有参与的设备有效。</translation>
    </message>
    <message>
        <source>Prepare switches the motors on where they stand; nothing turns before Start.</source>
        <translation>“准备”在电机当前位置将其接通；“启动”之前不会转动。</translation>
    </message>
    <message>
        <source>not prepared: &apos;%1&apos; is no number of counts</source>
        <translation>未准备：“%1”不是计数值</translation>
    </message>
</context>
<context>
    <name>mb::NoticeModel</name>
    <message>
        <source>time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>device</source>
        <translation>设备</translation>
    </message>
    <message>
        <source>what</source>
        <translation>内容</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
</context>
<context>
    <name>mb::OverviewPage</name>
    <message>
        <source>Overview</source>
        <translation>概览</translation>
    </message>
    <message>
        <source>load</source>
        <translation>负载</translation>
    </message>
    <message>
        <source>errors</source>
        <translation>错误</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>丢失</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>Frames received that no controller family knows: somebody else&apos;s traffic</source>
        <translation>收到的帧不属于任何已知控制器系列：其他设备的通信</translation>
    </message>
    <message>
        <source>round trip</source>
        <translation>往返时间</translation>
    </message>
    <message>
        <source>Load of the last minute</source>
        <translation>最近一分钟的负载</translation>
    </message>
</context>
<context>
    <name>mb::OwnProposal</name>
    <message>
        <source>own</source>
        <translation>自定</translation>
    </message>
    <message>
        <source>Own proposal</source>
        <translation>自定方案</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>calm</source>
        <translation>平缓</translation>
    </message>
    <message>
        <source>brisk</source>
        <translation>迅速</translation>
    </message>
    <message>
        <source>Damping</source>
        <translation>阻尼</translation>
    </message>
    <message>
        <source>robust</source>
        <translation>稳健</translation>
    </message>
    <message>
        <source>lively</source>
        <translation>激进</translation>
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
        <translation>设备无法采用此参数组：%1</translation>
    </message>
    <message>
        <source>Held at τc %1 by: %2</source>
        <translation>τc 停在 %1，受限于：%2</translation>
    </message>
    <message>
        <source>proposal %1</source>
        <translation>建议 %1</translation>
    </message>
</context>
<context>
    <name>mb::PageKeys</name>
    <message>
        <source>Keys: %1</source>
        <translation>按键：%1</translation>
    </message>
    <message>
        <source>Everywhere</source>
        <translation>全局</translation>
    </message>
</context>
<context>
    <name>mb::PageMap</name>
    <message>
        <source>Flash pages</source>
        <translation>闪存页</translation>
    </message>
    <message>
        <source>%1 of %2 pages written</source>
        <translation>已写入 %1 页，共 %2 页</translation>
    </message>
    <message>
        <source> · must not be interrupted</source>
        <translation> · 不得中断</translation>
    </message>
    <message>
        <source>page %1: waiting</source>
        <translation>第 %1 页：等待中</translation>
    </message>
    <message>
        <source>page %1: being written</source>
        <translation>第 %1 页：正在写入</translation>
    </message>
    <message>
        <source>page %1: written after it was sent again</source>
        <translation>第 %1 页：重发后写入</translation>
    </message>
    <message>
        <source>page %1: written</source>
        <translation>第 %1 页：已写入</translation>
    </message>
    <message>
        <source>page %1: sent again</source>
        <translation>第 %1 页：已重发</translation>
    </message>
    <message>
        <source>page %1: not in the image</source>
        <translation>第 %1 页：不在映像中</translation>
    </message>
</context>
<context>
    <name>mb::PageStack</name>
    <message>
        <source>Pages</source>
        <translation>页面</translation>
    </message>
</context>
<context>
    <name>mb::PageTabs</name>
    <message>
        <source>Pages</source>
        <translation>页面</translation>
    </message>
</context>
<context>
    <name>mb::ParameterCommands</name>
    <message>
        <source>What was written before it is in force; the rest is still staged. Nothing was stored.</source>
        <translation>在此之前写入的值已生效；其余仍为暂存。未存储任何内容。</translation>
    </message>
    <message>
        <source>Nothing is proved to be in flash. Store again, and keep power on.</source>
        <translation>没有任何值被证实已存入闪存。请重新存储，并保持通电。</translation>
    </message>
    <message>
        <source>Nothing is kept.</source>
        <translation>未保留任何内容。</translation>
    </message>
    <message>
        <source>What was written before it is in force. Undo takes it back.</source>
        <translation>在此之前写入的值已生效。“撤销”可撤回。</translation>
    </message>
</context>
<context>
    <name>mb::ParameterDelegate</name>
    <message>
        <source>%1, %2</source>
        <translation>%1，%2</translation>
    </message>
</context>
<context>
    <name>mb::ParameterFoot</name>
    <message>
        <source>What the parameter does</source>
        <translation>参数的作用</translation>
    </message>
    <message>
        <source>%1 edited</source>
        <translation>%1 项已编辑</translation>
    </message>
    <message>
        <source>%1 out of range</source>
        <translation>%1 项超范围</translation>
    </message>
    <message>
        <source>%1 without answer</source>
        <translation>%1 项无应答</translation>
    </message>
    <message>
        <source>%1 in RAM</source>
        <translation>%1 项在 RAM 中</translation>
    </message>
    <message>
        <source>%1 stored</source>
        <translation>%1 项已存储</translation>
    </message>
    <message>
        <source>%1 assumed</source>
        <translation>%1 项为假定值</translation>
    </message>
    <message>
        <source>%1 not persistent</source>
        <translation>%1 项易失</translation>
    </message>
    <message>
        <source>Choose a parameter to see what it does.</source>
        <translation>选择参数以查看其作用。</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1。</translation>
    </message>
    <message>
        <source>↑↓ row · Enter edit · %1 write</source>
        <translation>↑↓ 换行 · Enter 编辑 · %1 写入</translation>
    </message>
</context>
<context>
    <name>mb::ParameterGroups</name>
    <message>
        <source>1 parameter</source>
        <translation>1 个参数</translation>
    </message>
    <message>
        <source>%1 parameters</source>
        <translation>%1 个参数</translation>
    </message>
    <message>
        <source>not kept over a power cycle</source>
        <translation>断电后不保留</translation>
    </message>
    <message>
        <source>%1 not kept over a power cycle</source>
        <translation>%1 项断电后不保留</translation>
    </message>
</context>
<context>
    <name>mb::ParameterHead</name>
    <message>
        <source>Undo the last edit or write</source>
        <translation>撤销上一次编辑或写入</translation>
    </message>
    <message>
        <source>Redo the edit or write</source>
        <translation>重做编辑或写入</translation>
    </message>
    <message>
        <source>Read all</source>
        <translation>全部读取</translation>
    </message>
    <message>
        <source>Import…</source>
        <translation>导入…</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>导出…</translation>
    </message>
    <message>
        <source>Snapshot</source>
        <translation>快照</translation>
    </message>
    <message>
        <source>History</source>
        <translation>历史</translation>
    </message>
    <message>
        <source>More for the parameters</source>
        <translation>参数的更多操作</translation>
    </message>
</context>
<context>
    <name>mb::ParameterHeader</name>
    <message>
        <source>Columns</source>
        <translation>列</translation>
    </message>
</context>
<context>
    <name>mb::ParameterModel</name>
    <message>
        <source>edited, was %1</source>
        <translation>已编辑，原为 %1</translation>
    </message>
    <message>
        <source>unknown until written</source>
        <translation>写入之前未知</translation>
    </message>
    <message>
        <source>default</source>
        <translation>默认值</translation>
    </message>
    <message>
        <source>edited, was unknown</source>
        <translation>已编辑，原值未知</translation>
    </message>
    <message>
        <source>no answer, retry</source>
        <translation>无应答，请重试</translation>
    </message>
    <message>
        <source>not read</source>
        <translation>未读取</translation>
    </message>
    <message>
        <source>from a file</source>
        <translation>来自文件</translation>
    </message>
    <message>
        <source>Can only be read.</source>
        <translation>只读。</translation>
    </message>
    <message>
        <source>Is cleared with the faults, not by writing.</source>
        <translation>随故障一起清除，不能通过写入清除。</translation>
    </message>
    <message>
        <source>%1, default %2</source>
        <translation>%1，默认值 %2</translation>
    </message>
    <message>
        <source>%1 is 100 %</source>
        <translation>%1 即 100 %</translation>
    </message>
    <message>
        <source>Not kept over a power cycle.</source>
        <translation>断电后不保留。</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>parameter</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>key</source>
        <translation>键</translation>
    </message>
    <message>
        <source>value</source>
        <translation>值</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>state</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>raw</source>
        <translation>原始值</translation>
    </message>
</context>
<context>
    <name>mb::ParameterTools</name>
    <message>
        <source>Search parameters</source>
        <translation>搜索参数</translation>
    </message>
    <message>
        <source>Which parameters</source>
        <translation>哪些参数</translation>
    </message>
    <message>
        <source>All</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>Changed</source>
        <translation>非默认</translation>
    </message>
    <message>
        <source>Edited</source>
        <translation>已编辑</translation>
    </message>
    <message>
        <source>Errors</source>
        <translation>错误</translation>
    </message>
    <message>
        <source>All %1</source>
        <translation>全部 %1</translation>
    </message>
    <message>
        <source>Changed %1</source>
        <translation>非默认 %1</translation>
    </message>
    <message>
        <source>Edited %1</source>
        <translation>已编辑 %1</translation>
    </message>
    <message>
        <source>Errors %1</source>
        <translation>错误 %1</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
</context>
<context>
    <name>mb::ParameterView</name>
    <message>
        <source>Parameters</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>Copy as key=value</source>
        <translation>复制为 key=value</translation>
    </message>
    <message>
        <source>Revert the edit</source>
        <translation>还原编辑</translation>
    </message>
    <message>
        <source>Set to the default, %1</source>
        <translation>设为默认值 %1</translation>
    </message>
</context>
<context>
    <name>mb::ParametersPage</name>
    <message>
        <source>Open a parameter file…</source>
        <translation>打开参数文件…</translation>
    </message>
    <message>
        <source>Open a parameter file</source>
        <translation>打开参数文件</translation>
    </message>
    <message>
        <source>Import parameters</source>
        <translation>导入参数</translation>
    </message>
    <message>
        <source>Export parameters</source>
        <translation>导出参数</translation>
    </message>
    <message>
        <source>reads all parameters</source>
        <translation>读取全部参数</translation>
    </message>
    <message>
        <source>searches</source>
        <translation>搜索</translation>
    </message>
    <message>
        <source>writes what is staged</source>
        <translation>写入暂存内容</translation>
    </message>
    <message>
        <source>undoes the last edit, or else the last write to the unit</source>
        <translation>撤销上一次编辑，否则撤销上一次写入设备的操作</translation>
    </message>
    <message>
        <source>shows the history of the unit, or its values</source>
        <translation>显示设备的历史或其值</translation>
    </message>
    <message>
        <source>Select a device</source>
        <translation>请选择设备</translation>
    </message>
    <message>
        <source>Its parameters appear here. A parameter file can be looked at and compared without a device.</source>
        <translation>其参数会显示在此处。没有设备也可以查看和比较参数文件。</translation>
    </message>
    <message>
        <source>No parameters in the bootloader</source>
        <translation>引导程序中没有参数</translation>
    </message>
    <message>
        <source>%1 has no application running. Write firmware to it, then its parameters can be read.</source>
        <translation>%1 没有应用程序在运行。请为其写入固件，之后即可读取参数。</translation>
    </message>
    <message>
        <source>No parameters</source>
        <translation>没有参数</translation>
    </message>
    <message>
        <source>%1 has none.</source>
        <translation>%1 没有参数。</translation>
    </message>
    <message>
        <source>Compare with a parameter file</source>
        <translation>与参数文件比较</translation>
    </message>
    <message>
        <source>redoes the last edit or write</source>
        <translation>重做上一次编辑或写入</translation>
    </message>
</context>
<context>
    <name>mb::PdfText</name>
    <message>
        <source>page %1 of %2</source>
        <translation>第 %1 页，共 %2 页</translation>
    </message>
    <message>
        <source>DEMO, a simulated unit</source>
        <translation>演示，仿真设备</translation>
    </message>
</context>
<context>
    <name>mb::PlotBoard</name>
    <message>
        <source>DEMO</source>
        <translation>演示</translation>
    </message>
    <message>
        <source>REPLAY</source>
        <translation>回放</translation>
    </message>
    <message>
        <source>%1 signals, %2 samples/s, %3 of %4 lost</source>
        <translation>%1 个信号，%2 采样/s，%4 中丢失 %3</translation>
    </message>
    <message>
        <source>ref %1</source>
        <translation>参考 %1</translation>
    </message>
</context>
<context>
    <name>mb::PlotExport</name>
    <message>
        <source>Export plot</source>
        <translation>导出曲线图</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>复制图片</translation>
    </message>
    <message>
        <source>Copy numbers</source>
        <translation>复制数值</translation>
    </message>
    <message>
        <source>Copy summary</source>
        <translation>复制摘要</translation>
    </message>
    <message>
        <source>Export PNG…</source>
        <translation>导出 PNG…</translation>
    </message>
    <message>
        <source>PNG picture (*.png)</source>
        <translation>PNG 图片 (*.png)</translation>
    </message>
    <message>
        <source>Export SVG…</source>
        <translation>导出 SVG…</translation>
    </message>
    <message>
        <source>SVG drawing (*.svg)</source>
        <translation>SVG 图形 (*.svg)</translation>
    </message>
    <message>
        <source>Export PDF…</source>
        <translation>导出 PDF…</translation>
    </message>
    <message>
        <source>PDF document (*.pdf)</source>
        <translation>PDF 文档 (*.pdf)</translation>
    </message>
    <message>
        <source>Export CSV…</source>
        <translation>导出 CSV…</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>表格 (*.csv)</translation>
    </message>
</context>
<context>
    <name>mb::PlotLayoutBook</name>
    <message>
        <source>Save layout</source>
        <translation>保存布局</translation>
    </message>
    <message>
        <source>Save layout as…</source>
        <translation>布局另存为…</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>重置</translation>
    </message>
    <message>
        <source>Begin like this with every %1</source>
        <translation>每台 %1 均以此布局开始</translation>
    </message>
    <message>
        <source>Begin with the usual for every %1</source>
        <translation>每台 %1 均以常规布局开始</translation>
    </message>
</context>
<context>
    <name>mb::PlotScrubber</name>
    <message>
        <source>Whole session</source>
        <translation>整个会话</translation>
    </message>
    <message>
        <source>The whole session: drag the box or click to scroll back, End returns to the present.
The recording goes on meanwhile.</source>
        <translation>整个会话：拖动方框或单击可回看，End 返回当前。
期间记录继续进行。</translation>
    </message>
</context>
<context>
    <name>mb::PlotStack</name>
    <message>
        <source>Plot</source>
        <translation>曲线图</translation>
    </message>
    <message>
        <source>Pause view	P</source>
        <translation>暂停视图	P</translation>
    </message>
    <message>
        <source>Back to live	P</source>
        <translation>返回实时	P</translation>
    </message>
    <message>
        <source>Fit time and value	0</source>
        <translation>适配时间和数值	0</translation>
    </message>
    <message>
        <source>Cursors A and B	L</source>
        <translation>光标 A 和 B	L</translation>
    </message>
</context>
<context>
    <name>mb::PlotsBar</name>
    <message>
        <source>window %1 ms</source>
        <translation>窗口 %1 ms</translation>
    </message>
    <message>
        <source>window %1 s</source>
        <translation>窗口 %1 s</translation>
    </message>
    <message>
        <source>window %1 min</source>
        <translation>窗口 %1 min</translation>
    </message>
    <message>
        <source>window %1 h</source>
        <translation>窗口 %1 h</translation>
    </message>
    <message>
        <source>Pause view</source>
        <translation>暂停视图</translation>
    </message>
    <message>
        <source>Follow live</source>
        <translation>跟随实时</translation>
    </message>
    <message>
        <source>The recording goes on.</source>
        <translation>记录继续进行。</translation>
    </message>
    <message>
        <source>View</source>
        <translation>视图</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>X-Y</source>
        <translation>X-Y</translation>
    </message>
    <message>
        <source>Spectrum</source>
        <translation>频谱</translation>
    </message>
    <message>
        <source>Against time, one signal against another, or amplitude against frequency of what is seen or of A … B</source>
        <translation>随时间变化、一个信号对另一个信号，或可见范围或 A … B 的幅值随频率变化</translation>
    </message>
    <message>
        <source>Length of the time axis</source>
        <translation>时间轴长度</translation>
    </message>
    <message>
        <source>Trigger: stands still at an edge or a level</source>
        <translation>触发：在边沿或电平处静止</translation>
    </message>
    <message>
        <source>Cursors A and B</source>
        <translation>光标 A 和 B</translation>
    </message>
    <message>
        <source>Fit time and value</source>
        <translation>适配时间和数值</translation>
    </message>
    <message>
        <source>Keep what is seen as a reference</source>
        <translation>将可见内容保留为参考</translation>
    </message>
    <message>
        <source>Layouts: save, restore, reset</source>
        <translation>布局：保存、恢复、重置</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>导出</translation>
    </message>
    <message>
        <source>The picture as PNG, SVG or PDF; samples as CSV or MCAP</source>
        <translation>图片为 PNG、SVG 或 PDF；采样为 CSV 或 MCAP</translation>
    </message>
</context>
<context>
    <name>mb::PlotsPage</name>
    <message>
        <source>No device yet</source>
        <translation>尚无设备</translation>
    </message>
    <message>
        <source>Open a link, or the simulated bench from the menu; its signals appear here.</source>
        <translation>打开链路，或从菜单打开仿真台架；其信号会显示在此处。</translation>
    </message>
    <message>
        <source>Wheel zooms time, Ctrl+wheel values, Shift+wheel moves · drag moves · Shift+drag zooms into a box
double click or End returns to the present · right click for more</source>
        <translation>滚轮缩放时间，Ctrl+滚轮缩放数值，Shift+滚轮平移 · 拖动平移 · Shift+拖动放大到方框
双击或 End 返回当前 · 右键单击查看更多</translation>
    </message>
    <message>
        <source>Nothing is plotted</source>
        <translation>未绘制任何内容</translation>
    </message>
    <message>
        <source>Double click a signal in the list at the right or under a device at the left, or drag it here.</source>
        <translation>双击右侧列表中或左侧设备下的信号，或将其拖到此处。</translation>
    </message>
    <message>
        <source>plot written to %1</source>
        <translation>曲线图已写入 %1</translation>
    </message>
    <message>
        <source>pauses the plots, and goes on</source>
        <translation>暂停曲线图，或继续</translation>
    </message>
    <message>
        <source>fits time and value</source>
        <translation>适配时间和数值</translation>
    </message>
    <message>
        <source>cursors: arrows move one, C changes to the other</source>
        <translation>光标：方向键移动一个，C 切换到另一个</translation>
    </message>
    <message>
        <source>watches for a trigger, or no more</source>
        <translation>开始或停止等待触发</translation>
    </message>
    <message>
        <source>records, or ends the recording</source>
        <translation>开始记录，或结束记录</translation>
    </message>
    <message>
        <source>in the plots: less or more time</source>
        <translation>在曲线图中：缩短或延长时间</translation>
    </message>
    <message>
        <source>in the plots: larger or smaller values</source>
        <translation>在曲线图中：放大或缩小数值</translation>
    </message>
    <message>
        <source>in the plots: writes a note at this time</source>
        <translation>在曲线图中：在此时刻写注释</translation>
    </message>
    <message>
        <source>Note at this time…	N</source>
        <translation>此时刻的注释…	N</translation>
    </message>
    <message>
        <source>Keep what is seen as a reference</source>
        <translation>将可见内容保留为参考</translation>
    </message>
    <message>
        <source>Remove references</source>
        <translation>移除参考</translation>
    </message>
    <message>
        <source>Derived signal…</source>
        <translation>派生信号…</translation>
    </message>
    <message>
        <source>Spectrum of what is seen</source>
        <translation>可见范围的频谱</translation>
    </message>
    <message>
        <source>X-Y</source>
        <translation>X-Y</translation>
    </message>
    <message>
        <source>Trigger: stands still at an edge or a level</source>
        <translation>触发：在边沿或电平处静止</translation>
    </message>
    <message>
        <source>Export samples…</source>
        <translation>导出采样…</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
</context>
<context>
    <name>mb::Preferences</name>
    <message>
        <source>Preferences</source>
        <translation>首选项</translation>
    </message>
    <message>
        <source>dark</source>
        <translation>深色</translation>
    </message>
    <message>
        <source>light</source>
        <translation>浅色</translation>
    </message>
    <message>
        <source>as the desktop</source>
        <translation>跟随桌面</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Nothing moves but data</source>
        <translation>除数据外均不活动</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>主题</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>语言</translation>
    </message>
    <message>
        <source>Text size</source>
        <translation>文字大小</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>动效</translation>
    </message>
    <message>
        <source>Notebook, recordings</source>
        <translation>试验记录本、记录</translation>
    </message>
    <message>
        <source>Settings, layouts</source>
        <translation>设置、布局</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>打开</translation>
    </message>
    <message>
        <source>Open the folder: %1</source>
        <translation>打开文件夹：%1</translation>
    </message>
    <message>
        <source>General</source>
        <translation>常规</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>按键</translation>
    </message>
    <message>
        <source>high contrast</source>
        <translation>高对比度</translation>
    </message>
    <message>
        <source>counts</source>
        <translation>counts</translation>
    </message>
    <message>
        <source>rpm and degrees</source>
        <translation>rpm 和度</translation>
    </message>
    <message>
        <source>With every verdict in production</source>
        <translation>生产模式下每次判定时</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>Sounds</source>
        <translation>声音</translation>
    </message>
    <message>
        <source>Guardian</source>
        <translation>守护进程</translation>
    </message>
</context>
<context>
    <name>mb::ProductionHead</name>
    <message>
        <source>recipe</source>
        <translation>配方</translation>
    </message>
    <message>
        <source>image</source>
        <translation>映像</translation>
    </message>
    <message>
        <source>parameters</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>number rule</source>
        <translation>编号规则</translation>
    </message>
    <message>
        <source>self-test</source>
        <translation>自检</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>离开</translation>
    </message>
    <message>
        <source>Link that units are put on</source>
        <translation>设备所接入的链路</translation>
    </message>
    <message>
        <source>Serial number, scanned or typed</source>
        <translation>序列号，扫描或输入</translation>
    </message>
    <message>
        <source>Scan or type a serial number</source>
        <translation>扫描或输入序列号</translation>
    </message>
    <message>
        <source>Open recipe…</source>
        <translation>打开配方…</translation>
    </message>
    <message>
        <source>Hold to arm self-tests</source>
        <translation>按住以解锁自检</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>启动</translation>
    </message>
    <message>
        <source>End</source>
        <translation>结束</translation>
    </message>
    <message>
        <source>No recipe yet</source>
        <translation>尚无配方</translation>
    </message>
    <message>
        <source>ARMED, hold to disarm</source>
        <translation>已解锁，按住以上锁</translation>
    </message>
    <message>
        <source>%1, not open</source>
        <translation>%1，未打开</translation>
    </message>
</context>
<context>
    <name>mb::ProductionPage</name>
    <message>
        <source>Production</source>
        <translation>生产</translation>
    </message>
    <message>
        <source>Last ten units</source>
        <translation>最近十台设备</translation>
    </message>
    <message>
        <source>Sound</source>
        <translation>声音</translation>
    </message>
    <message>
        <source>Sound with every verdict</source>
        <translation>每次判定均发声</translation>
    </message>
    <message>
        <source>tests the last unit again</source>
        <translation>重新测试上一台设备</translation>
    </message>
    <message>
        <source>sets it aside, ready for the next</source>
        <translation>将其搁置，准备下一台</translation>
    </message>
    <message>
        <source>Open recipe</source>
        <translation>打开配方</translation>
    </message>
    <message>
        <source>Recipes (*.json);;All files (*)</source>
        <translation>配方 (*.json);;所有文件 (*)</translation>
    </message>
    <message>
        <source>The self-test turns the motor: %1</source>
        <translation>自检会转动电机：%1</translation>
    </message>
    <message>
        <source>not started: open a link first</source>
        <translation>未启动：请先打开链路</translation>
    </message>
    <message>
        <source>not started: open a recipe first</source>
        <translation>未启动：请先打开配方</translation>
    </message>
    <message>
        <source>no unit here has the serial number %1</source>
        <translation>此处没有序列号为 %1 的设备</translation>
    </message>
    <message>
        <source>test again</source>
        <translation>再次测试</translation>
    </message>
    <message>
        <source>set aside</source>
        <translation>搁置</translation>
    </message>
    <message>
        <source>serial number</source>
        <translation>序列号</translation>
    </message>
    <message>
        <source>leave</source>
        <translation>退出</translation>
    </message>
    <message>
        <source>stops every motor</source>
        <translation>停止所有电机</translation>
    </message>
    <message>
        <source>not tested again: %1</source>
        <translation>未重新测试：%1</translation>
    </message>
</context>
<context>
    <name>mb::ProfileFields</name>
    <message>
        <source>Velocity</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>counts/s</source>
        <translation>counts/s</translation>
    </message>
    <message>
        <source>Velocity of the profile</source>
        <translation>轮廓速度</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>加速度</translation>
    </message>
    <message>
        <source>counts/s²</source>
        <translation>counts/s²</translation>
    </message>
    <message>
        <source>Acceleration of the profile</source>
        <translation>轮廓加速度</translation>
    </message>
    <message>
        <source>The profile needs a velocity up to %1 counts/s.</source>
        <translation>轮廓需要不超过 %1 counts/s 的速度。</translation>
    </message>
    <message>
        <source>The profile needs an acceleration up to %1 counts/s²; 0 is none.</source>
        <translation>轮廓需要不超过 %1 counts/s² 的加速度；0 表示无。</translation>
    </message>
</context>
<context>
    <name>mb::ProfilePanel</name>
    <message>
        <source>What only you know</source>
        <translation>只有您知道的信息</translation>
    </message>
    <message>
        <source>Dialect</source>
        <translation>方言</translation>
    </message>
    <message>
        <source>How this unit is spoken to. The scan finds it out; choose another only if you know better.</source>
        <translation>与此设备通信的方式。扫描会自动确定；仅在您更清楚时才另选。</translation>
    </message>
    <message>
        <source>dialect as found</source>
        <translation>方言按检测结果</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>Speak another dialect?</source>
        <translation>使用其他方言吗？</translation>
    </message>
    <message>
        <source>Speak to this unit as %1?</source>
        <translation>以 %1 与此设备通信吗？</translation>
    </message>
    <message>
        <source>Speak it</source>
        <translation>使用</translation>
    </message>
    <message>
        <source>dialect as found: %1</source>
        <translation>方言按检测结果：%1</translation>
    </message>
</context>
<context>
    <name>mb::ProgrammerBox</name>
    <message>
        <source>Programmer</source>
        <translation>编程器</translation>
    </message>
    <message>
        <source>What writes the flash: one of the list, or the name that the program gives to another</source>
        <translation>写闪存的工具：列表中的一个，或程序对其他编程器的名称</translation>
    </message>
    <message>
        <source>Port of the programmer</source>
        <translation>编程器的端口</translation>
    </message>
    <message>
        <source>Where the programmer, or the line to the bootloader, is plugged in</source>
        <translation>编程器或通往引导程序的线路接在何处</translation>
    </message>
    <message>
        <source>at</source>
        <translation>接在</translation>
    </message>
    <message>
        <source>the device&apos;s own line</source>
        <translation>设备自身的线路</translation>
    </message>
    <message>
        <source>at USB</source>
        <translation>USB</translation>
    </message>
    <message>
        <source>Choose a programmer</source>
        <translation>选择编程器</translation>
    </message>
    <message>
        <source>No serial port is plugged in; choose or name the one of the programmer</source>
        <translation>未插入串口；请选择或指定编程器的串口</translation>
    </message>
</context>
<context>
    <name>mb::ProjectDesk</name>
    <message>
        <source>Save the machine into a folder</source>
        <translation>将整机保存到文件夹</translation>
    </message>
    <message>
        <source>Open the folder of a machine</source>
        <translation>打开整机的文件夹</translation>
    </message>
    <message numerus="yes">
        <source>%n unit(s) saved into %1</source>
        <translation>
            <numerusform>已将 %n 台设备保存到 %1</numerusform>
        </translation>
    </message>
    <message>
        <source>scales and limits of the project are in force</source>
        <translation>项目的比例和限值已生效</translation>
    </message>
    <message>
        <source>dialect %1 of the folder is not in force: choose it in the inspector if that is what it speaks</source>
        <translation>文件夹中的方言 %1 未生效：若设备使用该方言，请在检查器中选择</translation>
    </message>
</context>
<context>
    <name>mb::ProposalCard</name>
    <message>
        <source>quiet, forgiving</source>
        <translation>平静、宽容</translation>
    </message>
    <message>
        <source>hardly overshoots</source>
        <translation>几乎不超调</translation>
    </message>
    <message>
        <source>fastest rise</source>
        <translation>上升最快</translation>
    </message>
    <message>
        <source>Ms</source>
        <translation>Ms</translation>
    </message>
    <message>
        <source>calm</source>
        <translation>平缓</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>正常</translation>
    </message>
    <message>
        <source>brisk</source>
        <translation>迅速</translation>
    </message>
    <message>
        <source>τc %1</source>
        <translation>τc %1</translation>
    </message>
    <message>
        <source>raw %1</source>
        <translation>原始值 %1</translation>
    </message>
    <message>
        <source>%1 = 0</source>
        <translation>%1 = 0</translation>
    </message>
    <message>
        <source>Proposal: %1</source>
        <translation>建议方案：%1</translation>
    </message>
    <message>
        <source>over</source>
        <translation>超调</translation>
    </message>
    <message>
        <source>settle</source>
        <translation>调节</translation>
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
        <translation>峰值</translation>
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
        <translation>自定</translation>
    </message>
    <message>
        <source>Proposals</source>
        <translation>建议方案</translation>
    </message>
    <message>
        <source>to be found anew</source>
        <translation>将重新求取</translation>
    </message>
</context>
<context>
    <name>mb::QueueBar</name>
    <message>
        <source>State of the queue</source>
        <translation>队列状态</translation>
    </message>
    <message>
        <source>Progress of the queue</source>
        <translation>队列进度</translation>
    </message>
    <message>
        <source>Pause after this unit</source>
        <translation>此设备之后暂停</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>继续</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Retry failed</source>
        <translation>重试不合格</translation>
    </message>
    <message>
        <source>Save CSV…</source>
        <translation>保存 CSV…</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>启动</translation>
    </message>
    <message>
        <source>Ended before its time: %1</source>
        <translation>提前结束：%1</translation>
    </message>
    <message>
        <source>Pauses after this unit</source>
        <translation>此设备之后暂停</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>已暂停</translation>
    </message>
    <message>
        <source>Unit %1 of %2</source>
        <translation>第 %1 台，共 %2 台</translation>
    </message>
    <message numerus="yes">
        <source>Ended with %n unit(s) to go</source>
        <translation>
            <numerusform>已结束，还剩 %n 台</numerusform>
        </translation>
    </message>
    <message>
        <source>Ended: %1 of %2 units</source>
        <translation>已结束：%1 / %2 台</translation>
    </message>
    <message>
        <source>Nothing running</source>
        <translation>没有任务在运行</translation>
    </message>
    <message>
        <source>about %1 s left</source>
        <translation>约剩 %1 s</translation>
    </message>
    <message>
        <source>%1 done</source>
        <translation>完成 %1</translation>
    </message>
    <message>
        <source>%1 waiting</source>
        <translation>等待 %1</translation>
    </message>
    <message>
        <source>%1 failed</source>
        <translation>不合格 %1</translation>
    </message>
    <message>
        <source>%1 refused</source>
        <translation>拒绝 %1</translation>
    </message>
    <message>
        <source>mean %1</source>
        <translation>平均 %1</translation>
    </message>
</context>
<context>
    <name>mb::QueueBoard</name>
    <message>
        <source>Go on with it</source>
        <translation>继续</translation>
    </message>
    <message>
        <source>A queue runs already.</source>
        <translation>已有队列在运行。</translation>
    </message>
    <message>
        <source>Open an image or a recipe first.</source>
        <translation>请先打开映像或配方。</translation>
    </message>
    <message>
        <source>Tick the units first.</source>
        <translation>请先勾选设备。</translation>
    </message>
    <message>
        <source>Save what was done</source>
        <translation>保存处理结果</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>表格 (*.csv)</translation>
    </message>
    <message>
        <source>the units are in %1</source>
        <translation>设备列表在 %1</translation>
    </message>
    <message>
        <source>The last queue of this recipe was cut off: %1 done, %2 open</source>
        <translation>此配方的上一个队列被中断：完成 %1，未结束 %2</translation>
    </message>
    <message>
        <source>What has ended stays as it is; ticked units are taken along.</source>
        <translation>已结束的保持不变；勾选的设备一并处理。</translation>
    </message>
    <message>
        <source>One unit at a time on a bus, buses side by side. Real units keep this computer awake. The journal is on disk: after a crash the queue goes on.</source>
        <translation>每条总线一次一台，各总线并行。处理真实设备时计算机不休眠。日志簿在磁盘上：崩溃后队列可继续。</translation>
    </message>
    <message>
        <source>Every unit is backed up before and compared afterwards; the journal has it.</source>
        <translation>每台设备事先备份、事后比较；日志簿均有记录。</translation>
    </message>
    <message>
        <source>not tried again: %1</source>
        <translation>未重试：%1</translation>
    </message>
    <message>
        <source>not tried again: it was served by %1; tick it and start</source>
        <translation>未重试：它是按 %1 处理的；请勾选后开始</translation>
    </message>
    <message>
        <source>%1 waits until this queue has ended</source>
        <translation>%1 将等待此队列结束</translation>
    </message>
</context>
<context>
    <name>mb::QueueChecks</name>
    <message>
        <source>recipe checked</source>
        <translation>配方已检查</translation>
    </message>
    <message>
        <source>no image, no recipe</source>
        <translation>没有映像，没有配方</translation>
    </message>
    <message>
        <source>all motors stopped</source>
        <translation>所有电机已停止</translation>
    </message>
    <message>
        <source>a motor is moving</source>
        <translation>有电机在转动</translation>
    </message>
    <message>
        <source>no other master</source>
        <translation>没有其他主站</translation>
    </message>
    <message>
        <source>another master, or a number taken twice</source>
        <translation>有其他主站，或编号重复</translation>
    </message>
    <message>
        <source>bus %1 V</source>
        <translation>总线 %1 V</translation>
    </message>
    <message>
        <source>bus voltage not known</source>
        <translation>总线电压未知</translation>
    </message>
    <message>
        <source>Before start</source>
        <translation>开始之前</translation>
    </message>
</context>
<context>
    <name>mb::QueueHead</name>
    <message>
        <source>recipe</source>
        <translation>配方</translation>
    </message>
    <message>
        <source>image</source>
        <translation>映像</translation>
    </message>
    <message>
        <source>parameters</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>number rule</source>
        <translation>编号规则</translation>
    </message>
    <message>
        <source>Open image…</source>
        <translation>打开映像…</translation>
    </message>
    <message>
        <source>Open recipe…</source>
        <translation>打开配方…</translation>
    </message>
    <message>
        <source>none yet</source>
        <translation>尚无</translation>
    </message>
    <message>
        <source>Open a firmware image</source>
        <translation>打开固件映像</translation>
    </message>
    <message>
        <source>Intel HEX (*.hex *.ihex);;All files (*)</source>
        <translation>Intel HEX (*.hex *.ihex);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Open recipe</source>
        <translation>打开配方</translation>
    </message>
    <message>
        <source>Recipes (*.json);;All files (*)</source>
        <translation>配方 (*.json);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Write a recipe</source>
        <translation>编写配方</translation>
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
        <translation>序列号</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>设备</translation>
    </message>
    <message>
        <source>firmware</source>
        <translation>固件</translation>
    </message>
    <message>
        <source>step</source>
        <translation>步骤</translation>
    </message>
    <message>
        <source>progress</source>
        <translation>进度</translation>
    </message>
    <message>
        <source>time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>result</source>
        <translation>结果</translation>
    </message>
</context>
<context>
    <name>mb::QueueSide</name>
    <message>
        <source>The self-test turns the motor: %1. Hold Arm in the header once the queue runs.</source>
        <translation>自检会转动电机：%1。队列运行后按住顶栏的解锁按钮。</translation>
    </message>
</context>
<context>
    <name>mb::QueueTable</name>
    <message>
        <source>Every unit of this family</source>
        <translation>该系列的所有设备</translation>
    </message>
    <message>
        <source>Units of the queue</source>
        <translation>队列中的设备</translation>
    </message>
    <message>
        <source>Every %1</source>
        <translation>所有 %1</translation>
    </message>
</context>
<context>
    <name>mb::QueueText</name>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>verified</source>
        <translation>已验证</translation>
    </message>
    <message>
        <source>%1 parameters equal</source>
        <translation>%1 个参数一致</translation>
    </message>
    <message>
        <source>already %1</source>
        <translation>已是 %1</translation>
    </message>
    <message>
        <source>read back after the restart</source>
        <translation>重启后已回读</translation>
    </message>
    <message>
        <source>safe to unplug, resumes</source>
        <translation>可以拔下，能续传</translation>
    </message>
    <message>
        <source>do not unplug</source>
        <translation>请勿拔下</translation>
    </message>
    <message>
        <source>waiting</source>
        <translation>等待中</translation>
    </message>
    <message>
        <source>cut off, goes on</source>
        <translation>已中断，将继续</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>已跳过</translation>
    </message>
    <message>
        <source>cut off</source>
        <translation>被截断</translation>
    </message>
    <message>
        <source>failed: %1</source>
        <translation>不合格：%1</translation>
    </message>
    <message>
        <source>refused before start</source>
        <translation>开始前被拒绝</translation>
    </message>
    <message>
        <source>number taken twice</source>
        <translation>编号重复</translation>
    </message>
    <message>
        <source>in its bootloader</source>
        <translation>在引导程序中</translation>
    </message>
    <message>
        <source>motor is moving</source>
        <translation>电机正在运动</translation>
    </message>
    <message>
        <source>another master drives it</source>
        <translation>由其他主站驱动</translation>
    </message>
    <message>
        <source>Preflight</source>
        <translation>预检</translation>
    </message>
    <message>
        <source>Backup</source>
        <translation>备份</translation>
    </message>
    <message>
        <source>Firmware</source>
        <translation>固件</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>Self-test</source>
        <translation>自检</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>编号</translation>
    </message>
    <message>
        <source>Comparison and proof</source>
        <translation>比较与验证</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>完成</translation>
    </message>
    <message>
        <source>hold Arm in the header</source>
        <translation>按住标题栏中的“解锁”</translation>
    </message>
    <message>
        <source>written, not proved</source>
        <translation>已写入，未证实</translation>
    </message>
    <message>
        <source>answers with %1, as before</source>
        <translation>仍以 %1 应答，与之前相同</translation>
    </message>
</context>
<context>
    <name>mb::RamBlock</name>
    <message>
        <source>In RAM, not in flash</source>
        <translation>在 RAM 中，不在闪存中</translation>
    </message>
    <message>
        <source>Time until the device stores by itself</source>
        <translation>距设备自动存储的时间</translation>
    </message>
    <message>
        <source>Store and prove</source>
        <translation>存储并验证</translation>
    </message>
    <message>
        <source>%1 s to go</source>
        <translation>还剩 %1 s</translation>
    </message>
    <message>
        <source>not proved</source>
        <translation>未证实</translation>
    </message>
    <message>
        <source>Read back and equal. Lost at power-off until it is stored.</source>
        <translation>已回读且一致。存储之前断电会丢失。</translation>
    </message>
    <message>
        <source>Read back and equal. Do not cut power yet.</source>
        <translation>已回读且一致。请勿断电。</translation>
    </message>
    <message>
        <source>%1 more.</source>
        <translation>另有 %1 项。</translation>
    </message>
    <message>
        <source>The device should have stored by itself. Its own proof takes up to %1 s.</source>
        <translation>设备应已自动存储。其自身的证实最多需要 %1 s。</translation>
    </message>
</context>
<context>
    <name>mb::ReadStatus</name>
    <message>
        <source>Reading</source>
        <translation>正在读取</translation>
    </message>
    <message>
        <source>Reading %1 of %2</source>
        <translation>正在读取 %1 / %2</translation>
    </message>
    <message>
        <source>no answer, the values are old</source>
        <translation>无应答，值已陈旧</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>无应答</translation>
    </message>
    <message>
        <source>%1 of %2 are read, %3 gave no answer</source>
        <translation>已读取 %1 / %2，%3 项无应答</translation>
    </message>
    <message>
        <source>not read yet</source>
        <translation>尚未读取</translation>
    </message>
    <message>
        <source>%1 of %2 known</source>
        <translation>已知 %1 / %2</translation>
    </message>
    <message>
        <source>all %1 read</source>
        <translation>已读取全部 %1 项</translation>
    </message>
    <message>
        <source>all %1 read in %2</source>
        <translation>已读取全部 %1 项，用时 %2</translation>
    </message>
    <message>
        <source>%1, values for %2 from a file</source>
        <translation>%1，来自文件的 %2 的值</translation>
    </message>
</context>
<context>
    <name>mb::RecipeEditor</name>
    <message>
        <source>New recipe</source>
        <translation>新配方</translation>
    </message>
    <message>
        <source>Fields of the recipe</source>
        <translation>配方的字段</translation>
    </message>
    <message>
        <source>The file that is saved, line by line</source>
        <translation>要保存的文件，逐行显示</translation>
    </message>
    <message>
        <source>What is wrong with the recipe</source>
        <translation>配方中的错误</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Save recipe</source>
        <translation>保存配方</translation>
    </message>
    <message>
        <source>Recipe %1</source>
        <translation>配方 %1</translation>
    </message>
    <message>
        <source>Keep the recipe</source>
        <translation>保存配方文件</translation>
    </message>
    <message>
        <source>Recipes (*.json)</source>
        <translation>配方 (*.json)</translation>
    </message>
    <message>
        <source>This recipe is not saved.</source>
        <translation>此配方尚未保存。</translation>
    </message>
    <message>
        <source>Discard it</source>
        <translation>放弃它</translation>
    </message>
    <message>
        <source>Go on writing</source>
        <translation>继续编写</translation>
    </message>
    <message>
        <source>No mistake in the recipe</source>
        <translation>配方没有错误</translation>
    </message>
    <message>
        <source>Give the recipe a name.</source>
        <translation>请为配方命名。</translation>
    </message>
</context>
<context>
    <name>mb::RecipeForm</name>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Family</source>
        <translation>系列</translation>
    </message>
    <message>
        <source>Firmware file</source>
        <translation>固件文件</translation>
    </message>
    <message>
        <source>Other way in</source>
        <translation>其他写入途径</translation>
    </message>
    <message>
        <source>Parameter file</source>
        <translation>参数文件</translation>
    </message>
    <message>
        <source>Save them where the unit does not by itself</source>
        <translation>设备不自动保存时予以保存</translation>
    </message>
    <message>
        <source>First number to give</source>
        <translation>分配的第一个编号</translation>
    </message>
    <message>
        <source>Self-test: the motor turns</source>
        <translation>自检：电机会转动</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>回路</translation>
    </message>
    <message>
        <source>From</source>
        <translation>从</translation>
    </message>
    <message>
        <source>To</source>
        <translation>到</translation>
    </message>
    <message>
        <source>Time, s</source>
        <translation>时间, s</translation>
    </message>
    <message>
        <source>Repeats</source>
        <translation>重复次数</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>轴</translation>
    </message>
    <message>
        <source>Gain slot</source>
        <translation>增益槽</translation>
    </message>
    <message>
        <source>Travel at most, counts</source>
        <translation>最大行程, 计数</translation>
    </message>
    <message>
        <source>Speed at most, counts/s</source>
        <translation>最大速度, 计数/s</translation>
    </message>
    <message>
        <source>Current at most, A</source>
        <translation>最大电流, A</translation>
    </message>
    <message>
        <source>Duty at most, 0 to 1</source>
        <translation>最大占空比, 0 至 1</translation>
    </message>
    <message>
        <source>What the self-test accepts</source>
        <translation>自检的合格条件</translation>
    </message>
    <message>
        <source>Accepted</source>
        <translation>合格项</translation>
    </message>
    <message>
        <source>Least</source>
        <translation>最小</translation>
    </message>
    <message>
        <source>Greatest</source>
        <translation>最大</translation>
    </message>
    <message>
        <source>counts both ways</source>
        <translation>双向计数</translation>
    </message>
    <message>
        <source>Choose: %1</source>
        <translation>选择：%1</translation>
    </message>
    <message>
        <source>none: over its own link</source>
        <translation>无：经由自身链路</translation>
    </message>
    <message>
        <source>such as %1</source>
        <translation>例如 %1</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>field, unit</comment>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>0 to 1</source>
        <translation>0 至 1</translation>
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
        <translation>%1 · 版本 %2 · sha %3</translation>
    </message>
    <message>
        <source>%1 · %2 values</source>
        <translation>%1 · %2 个值</translation>
    </message>
    <message>
        <source>next free from %1</source>
        <translation>从 %1 起的下一个空号</translation>
    </message>
</context>
<context>
    <name>mb::RecordStrip</name>
    <message>
        <source>Record…</source>
        <translation>记录…</translation>
    </message>
    <message>
        <source>End recording</source>
        <translation>结束记录</translation>
    </message>
    <message>
        <source>Writes every frame of this link to a candump log or a Vector ASC file</source>
        <translation>将此链路的每一帧写入 candump 日志或 Vector ASC 文件</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>忽略</translation>
    </message>
    <message>
        <source>Record the frames of %1</source>
        <translation>记录 %1 的帧</translation>
    </message>
    <message>
        <source>Vector ASC log (*.asc)</source>
        <translation>Vector ASC 日志 (*.asc)</translation>
    </message>
    <message>
        <source>candump log (*.log)</source>
        <translation>candump 日志 (*.log)</translation>
    </message>
    <message>
        <source>nothing is recorded: %1</source>
        <translation>未记录任何内容：%1</translation>
    </message>
    <message>
        <source>The recording has ended: %1. %2 frames are missing in it.</source>
        <translation>记录已结束：%1。其中缺少 %2 帧。</translation>
    </message>
    <message>
        <source>Recording  %1   %2 frames   %3   %4 lost   %5</source>
        <translation>记录  %1   %2 帧   %3   丢失 %4   %5</translation>
    </message>
</context>
<context>
    <name>mb::Recorder</name>
    <message>
        <source>The last session did not end by itself. What it recorded is in %1.</source>
        <translation>上次会话未正常结束。其记录位于 %1。</translation>
    </message>
    <message>
        <source>Samples are recorded on disk again, those of the meantime too.</source>
        <translation>采样重新记录到磁盘，包括其间的采样。</translation>
    </message>
    <message>
        <source>Samples are not recorded on disk: %1</source>
        <translation>采样未记录到磁盘：%1</translation>
    </message>
    <message>
        <source>What the last session recorded waits for the next start: %1</source>
        <translation>上次会话的记录将等待下次启动：%1</translation>
    </message>
</context>
<context>
    <name>mb::RecordingControl</name>
    <message>
        <source>Record</source>
        <translation>记录</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Keeps everything that devices send, beginning with the last %1.
What was recorded lately is on disk all the time and outlives a crash.</source>
        <translation>保留设备发送的所有内容，从最近 %1 开始。
最近的记录始终在磁盘上，崩溃后仍可保留。</translation>
    </message>
    <message>
        <source>recording written to %1</source>
        <translation>记录已写入 %1</translation>
    </message>
    <message>
        <source>not recorded: %1</source>
        <translation>未记录：%1</translation>
    </message>
    <message>
        <source>%1 · %2 · %3 samples</source>
        <translation>%1 · %2 · %3 个采样</translation>
    </message>
    <message>
        <source>last %1 on disk · %2</source>
        <translation>最近 %1 在磁盘上 · %2</translation>
    </message>
</context>
<context>
    <name>mb::ReplayBar</name>
    <message>
        <source>Recording that is played</source>
        <translation>正在播放的记录</translation>
    </message>
    <message>
        <source>REPLAY</source>
        <translation>回放</translation>
    </message>
    <message>
        <source>Shows what was recorded. Nothing is sent, no motor moves.</source>
        <translation>显示所记录的内容。不发送任何内容，不驱动任何电机。</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>播放</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>暂停</translation>
    </message>
    <message>
        <source>Play again</source>
        <translation>重新播放</translation>
    </message>
    <message>
        <source>Plays the recording from where it stands, or halts it there</source>
        <translation>从当前位置播放记录，或在该处停住</translation>
    </message>
    <message>
        <source>Speed of the replay</source>
        <translation>回放速度</translation>
    </message>
    <message>
        <source>How fast the recording is played</source>
        <translation>播放记录的快慢</translation>
    </message>
    <message>
        <source>as fast as possible</source>
        <translation>尽可能快</translation>
    </message>
    <message>
        <source>Position in the recording</source>
        <translation>在记录中的位置</translation>
    </message>
    <message>
        <source>Where the recording stands; arrow keys move it by 1 s, Page Up and Page Down by 10 s</source>
        <translation>记录的当前位置；方向键移动 1 s，Page Up 和 Page Down 移动 10 s</translation>
    </message>
    <message>
        <source>%1: looking through it, %2 %</source>
        <translation>%1：正在浏览，%2 %</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>recorded %1</source>
        <translation>记录于 %1</translation>
    </message>
</context>
<context>
    <name>mb::ReportOrder</name>
    <message>
        <source>Write report</source>
        <translation>生成报告</translation>
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
        <translation>报告位于 %1</translation>
    </message>
    <message>
        <source>no report: %1</source>
        <translation>无报告：%1</translation>
    </message>
</context>
<context>
    <name>mb::ReportText</name>
    <message>
        <source>Rise, 10 to 90 %</source>
        <translation>上升时间，10 至 90 %</translation>
    </message>
    <message>
        <source>Settling to 2 %</source>
        <translation>调节时间（2 %）</translation>
    </message>
    <message>
        <source>Overshoot</source>
        <translation>超调</translation>
    </message>
    <message>
        <source>Undershoot of the way back</source>
        <translation>返回时的下冲</translation>
    </message>
    <message>
        <source>Error at rest</source>
        <translation>稳态误差</translation>
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
        <translation>峰值电流</translation>
    </message>
    <message>
        <source>Chatter of the duty, RMS</source>
        <translation>占空比抖动，RMS</translation>
    </message>
    <message>
        <source>Time at the duty limit</source>
        <translation>处于占空比限值的时间</translation>
    </message>
    <message>
        <source>Noise of the measurement</source>
        <translation>测量噪声</translation>
    </message>
    <message>
        <source>step</source>
        <translation>阶跃</translation>
    </message>
    <message>
        <source>square wave</source>
        <translation>方波</translation>
    </message>
    <message>
        <source>ramp</source>
        <translation>斜坡</translation>
    </message>
    <message>
        <source>sine</source>
        <translation>正弦</translation>
    </message>
    <message>
        <source>chirp</source>
        <translation>扫频</translation>
    </message>
    <message>
        <source>random steps</source>
        <translation>随机阶跃</translation>
    </message>
    <message>
        <source>velocity</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>current</source>
        <translation>电流</translation>
    </message>
    <message>
        <source>duty</source>
        <translation>占空比</translation>
    </message>
    <message>
        <source>%1 times</source>
        <translation>%1 次</translation>
    </message>
    <message>
        <source>done</source>
        <translation>完成</translation>
    </message>
    <message>
        <source>cut off</source>
        <translation>被截断</translation>
    </message>
    <message>
        <source>interrupted</source>
        <translation>被中断</translation>
    </message>
    <message>
        <source>stopped by the guard “%1”</source>
        <translation>由监护“%1”停止</translation>
    </message>
    <message>
        <source>DEMO: this unit is simulated. Nothing here was measured on a motor.</source>
        <translation>演示：此设备为仿真。此处内容均非在电机上实测。</translation>
    </message>
    <message>
        <source>Report on %1</source>
        <translation>%1 的报告</translation>
    </message>
    <message>
        <source>Made on %1 with %2</source>
        <translation>于 %1 用 %2 生成</translation>
    </message>
    <message>
        <source>There are no trials of this unit in the notebook.</source>
        <translation>试验记录本中没有此设备的试验。</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>标签</translation>
    </message>
    <message>
        <source>simulated</source>
        <translation>仿真</translation>
    </message>
    <message>
        <source>Firmware %1</source>
        <translation>固件 %1</translation>
    </message>
    <message>
        <source>s since the edge</source>
        <translation>距边沿的时间 s</translation>
    </message>
    <message>
        <source>Trial %1: %2</source>
        <translation>试验 %1：%2</translation>
    </message>
    <message>
        <source>target</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>%1, measured</source>
        <translation>%1，实测</translation>
    </message>
    <message>
        <source>duty, %</source>
        <translation>占空比，%</translation>
    </message>
    <message>
        <source>Metric</source>
        <translation>指标</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>值</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>增益</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>默认值</translation>
    </message>
    <message>
        <source>Parameters of this set that have their default: %1</source>
        <translation>此组中取默认值的参数：%1</translation>
    </message>
    <message>
        <source>travel ± %1</source>
        <translation>行程 ± %1</translation>
    </message>
    <message>
        <source>speed %1</source>
        <translation>速度 %1</translation>
    </message>
    <message>
        <source>current %1</source>
        <translation>电流 %1</translation>
    </message>
    <message>
        <source>duty %1</source>
        <translation>占空比 %1</translation>
    </message>
    <message>
        <source>Trial %1, %2 loop</source>
        <translation>试验 %1，%2回路</translation>
    </message>
    <message>
        <source>Trial %1, open loop</source>
        <translation>试验 %1，开环</translation>
    </message>
    <message>
        <source>axis %1</source>
        <translation>轴 %1</translation>
    </message>
    <message>
        <source>gain slot %1</source>
        <translation>增益槽 %1</translation>
    </message>
    <message>
        <source>firmware %1</source>
        <translation>固件 %1</translation>
    </message>
    <message>
        <source>motor seen stopped</source>
        <translation>已确认电机停止</translation>
    </message>
    <message>
        <source>stop not confirmed</source>
        <translation>停止未确认</translation>
    </message>
    <message>
        <source>%1 samples, %2 lost</source>
        <translation>%1 个采样，丢失 %2</translation>
    </message>
    <message>
        <source>Nothing was recorded.</source>
        <translation>未记录任何内容。</translation>
    </message>
    <message>
        <source>It ran within: %1.</source>
        <translation>运行范围：%1。</translation>
    </message>
    <message>
        <source>Note: %1</source>
        <translation>注释：%1</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>序号</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>回路</translation>
    </message>
    <message>
        <source>Stimulus</source>
        <translation>激励</translation>
    </message>
    <message>
        <source>Rise</source>
        <translation>上升时间</translation>
    </message>
    <message>
        <source>Settling</source>
        <translation>调节时间</translation>
    </message>
    <message>
        <source>End</source>
        <translation>结束</translation>
    </message>
    <message>
        <source>History of the unit</source>
        <translation>设备的历史</translation>
    </message>
    <message>
        <source>The newest %1 of %2 trials.</source>
        <translation>最新的 %1 次试验，共 %2 次。</translation>
    </message>
    <message>
        <source>Kept</source>
        <translation>已保留</translation>
    </message>
    <message>
        <source>Proposed, nothing was written</source>
        <translation>已建议，未写入任何内容</translation>
    </message>
    <message>
        <source>Put back</source>
        <translation>已恢复</translation>
    </message>
    <message>
        <source>Refused</source>
        <translation>已拒绝</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>已停止</translation>
    </message>
    <message>
        <source>none, as fresh as the position</source>
        <translation>无，与位置同样及时</translation>
    </message>
    <message>
        <source>rolling, %1</source>
        <translation>滑动，%1</translation>
    </message>
    <message>
        <source>in blocks, %1</source>
        <translation>分块，%1</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>模型</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>设备</translation>
    </message>
    <message>
        <source>Gain K</source>
        <translation>增益 K</translation>
    </message>
    <message>
        <source>Lag τ</source>
        <translation>滞后 τ</translation>
    </message>
    <message>
        <source>Friction kS</source>
        <translation>摩擦 kS</translation>
    </message>
    <message>
        <source>% duty</source>
        <translation>% 占空比</translation>
    </message>
    <message>
        <source>Velocity filter of the device: %1</source>
        <translation>设备的速度滤波器：%1</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>合格</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>未通过</translation>
    </message>
    <message>
        <source>What the model was judged by:</source>
        <translation>模型的评判依据：</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>之前</translation>
    </message>
    <message>
        <source>Proposed</source>
        <translation>建议</translation>
    </message>
    <message>
        <source>Raw</source>
        <translation>原始值</translation>
    </message>
    <message>
        <source>Proof</source>
        <translation>验证</translation>
    </message>
    <message>
        <source>Predicted</source>
        <translation>预测</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>实测</translation>
    </message>
    <message>
        <source>Sensitivity peak Ms</source>
        <translation>灵敏度峰值 Ms</translation>
    </message>
    <message>
        <source>Gain margin</source>
        <translation>增益裕度</translation>
    </message>
    <message>
        <source>Phase margin</source>
        <translation>相位裕度</translation>
    </message>
    <message>
        <source>forwards</source>
        <translation>正向</translation>
    </message>
    <message>
        <source>backwards</source>
        <translation>反向</translation>
    </message>
    <message>
        <source>predicted</source>
        <translation>预测</translation>
    </message>
    <message>
        <source>The step of the proof, predicted and measured</source>
        <translation>验证阶跃，预测与实测</translation>
    </message>
    <message>
        <source>Magnitude and phase of the open loop</source>
        <translation>开环的幅值和相位</translation>
    </message>
    <message>
        <source>magnitude of the loop, dB</source>
        <translation>回路幅值，dB</translation>
    </message>
    <message>
        <source>phase of the loop, °</source>
        <translation>回路相位，°</translation>
    </message>
    <message>
        <source>Tuning of the %1 loop</source>
        <translation>%1回路的整定</translation>
    </message>
    <message>
        <source>trials %1</source>
        <translation>试验 %1</translation>
    </message>
    <message>
        <source>Family</source>
        <translation>系列</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>地址</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation>序列号</translation>
    </message>
    <message>
        <source>Connected at</source>
        <translation>连接于</translation>
    </message>
    <message>
        <source>Firmware</source>
        <translation>固件</translation>
    </message>
    <message>
        <source>Bootloader</source>
        <translation>引导程序</translation>
    </message>
    <message>
        <source>Dialect</source>
        <translation>方言</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>%1 of %2 differ from their default and are set in bold.</source>
        <translation>%2 项中有 %1 项与默认值不同，以粗体显示。</translation>
    </message>
    <message>
        <source>Resistance R, Ω</source>
        <translation>电阻 R，Ω</translation>
    </message>
    <message>
        <source>Friction, V</source>
        <translation>摩擦，V</translation>
    </message>
    <message>
        <source>Gain 1/Ke, counts/s per V</source>
        <translation>增益 1/Ke，counts/s 每 V</translation>
    </message>
    <message>
        <source>Encoder counts both ways</source>
        <translation>编码器双向计数</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>是</translation>
    </message>
    <message>
        <source>no</source>
        <translation>否</translation>
    </message>
    <message>
        <source>Self-test</source>
        <translation>自检</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>限值</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>更改</translation>
    </message>
    <message>
        <source>%1 since %2</source>
        <translation>%1，自 %2 起</translation>
    </message>
    <message>
        <source>PASS</source>
        <translation>合格</translation>
    </message>
    <message>
        <source>FAIL</source>
        <translation>不合格</translation>
    </message>
    <message>
        <source>Not finished</source>
        <translation>未完成</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>Recipe</source>
        <translation>配方</translation>
    </message>
    <message>
        <source>Served</source>
        <translation>处理时间</translation>
    </message>
    <message>
        <source>Number given</source>
        <translation>分配的编号</translation>
    </message>
    <message>
        <source>Parameters of the recipe</source>
        <translation>配方的参数</translation>
    </message>
    <message numerus="yes">
        <source>%n in the unit, read back</source>
        <translation>
            <numerusform>设备中 %n 项，已回读</numerusform>
        </translation>
    </message>
    <message>
        <source>Service</source>
        <translation>维护</translation>
    </message>
    <message>
        <source>Cause or note</source>
        <translation>原因或注释</translation>
    </message>
    <message>
        <source>Every service of this unit</source>
        <translation>此设备的全部维护记录</translation>
    </message>
    <message>
        <source>Service card of %1</source>
        <translation>%1 的服务卡</translation>
    </message>
    <message>
        <source>Parameters that differ from their default</source>
        <translation>与默认值不同的参数</translation>
    </message>
    <message>
        <source>The first %1 of %2.</source>
        <translation>%2 个中的前 %1 个。</translation>
    </message>
    <message>
        <source>Counts/s per duty</source>
        <translation>每单位占空比的计数/s</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>相位</translation>
    </message>
    <message>
        <source>Coherence</source>
        <translation>相干性</translation>
    </message>
    <message>
        <source>Believed</source>
        <translation>可信</translation>
    </message>
    <message>
        <source>magnitude of the motor, dB</source>
        <translation>电机幅值，dB</translation>
    </message>
    <message>
        <source>phase of the motor, °</source>
        <translation>电机相位，°</translation>
    </message>
    <message>
        <source>model</source>
        <translation>模型</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>实测</translation>
    </message>
    <message>
        <source>Magnitude and phase of the motor, measured and of its model</source>
        <translation>电机的幅值与相位，实测值与模型值</translation>
    </message>
    <message>
        <source>Frequency response of the motor</source>
        <translation>电机的频率响应</translation>
    </message>
    <message>
        <source>Sines of duty around a speed at which it never reverses, the last on %1. Believed and drawn are %2 of %3: ten samples make a swing, and the sine explains 0.9 of the movement at least (coherence).</source>
        <translation>围绕不会反转的速度施加的占空比正弦波，最后一次在 %1。可信并绘出的为 %3 个中的 %2 个：每个周期有十个采样，且正弦波至少解释 0.9 的运动（相干性）。</translation>
    </message>
    <message>
        <source>Load one way kG</source>
        <translation>单向负载 kG</translation>
    </message>
    <message>
        <source>Gain forwards</source>
        <translation>正向增益</translation>
    </message>
    <message>
        <source>Gain backwards</source>
        <translation>反向增益</translation>
    </message>
    <message>
        <source>Noise at rest σ</source>
        <translation>静止时噪声 σ</translation>
    </message>
    <message>
        <source>Set-points that it can follow: at most %1 and %2</source>
        <translation>能跟随的设定值：最多 %1 和 %2</translation>
    </message>
    <message>
        <source>to be looked at</source>
        <translation>需要查看</translation>
    </message>
    <message>
        <source>Order to motion</source>
        <translation>指令到运动</translation>
    </message>
    <message>
        <source>Dead time θ</source>
        <translation>死区时间 θ</translation>
    </message>
    <message>
        <source>counts</source>
        <translation>counts</translation>
    </message>
    <message>
        <source>Breakaway forwards</source>
        <translation>正向起动</translation>
    </message>
    <message>
        <source>Breakaway backwards</source>
        <translation>反向起动</translation>
    </message>
    <message>
        <source>Tag</source>
        <translation>标签</translation>
    </message>
    <message>
        <source>Known by</source>
        <translation>识别依据</translation>
    </message>
    <message>
        <source>its place; another unit may stand there</source>
        <translation>其位置；那里可能是另一台设备</translation>
    </message>
    <message>
        <source>Friction, share of duty</source>
        <translation>摩擦（占空比份额）</translation>
    </message>
    <message>
        <source>Gain, counts/s at full duty</source>
        <translation>增益（满占空比时的 counts/s）</translation>
    </message>
    <message>
        <source>Not kept</source>
        <translation>未保留</translation>
    </message>
    <message>
        <source>duty %1, which stands in for a limit of current</source>
        <translation>占空比 %1（代替电流限制）</translation>
    </message>
    <message>
        <source>%1 (forgotten)</source>
        <translation>%1（已删除）</translation>
    </message>
    <message>
        <source>band: ± of the model</source>
        <translation>带：模型的 ±</translation>
    </message>
    <message>
        <source>Proposal</source>
        <translation>建议方案</translation>
    </message>
    <message>
        <source>Response</source>
        <translation>响应</translation>
    </message>
    <message>
        <source>Bounded by</source>
        <translation>受限于</translation>
    </message>
    <message>
        <source>chosen</source>
        <translation>所选</translation>
    </message>
    <message>
        <source>current, %1</source>
        <translation>电流，%1</translation>
    </message>
</context>
<context>
    <name>mb::ReportsPage</name>
    <message>
        <source>Reports</source>
        <translation>报告</translation>
    </message>
    <message>
        <source>Nothing to report yet</source>
        <translation>尚无可报告的内容</translation>
    </message>
    <message>
        <source>The cards of units, their tunings and their trials appear here.</source>
        <translation>设备的卡片、整定和试验会显示在此处。</translation>
    </message>
    <message>
        <source>Search the reports</source>
        <translation>搜索报告</translation>
    </message>
    <message>
        <source>Reports, newest first</source>
        <translation>报告，最新在前</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>预览</translation>
    </message>
    <message>
        <source>Write report…</source>
        <translation>生成报告…</translation>
    </message>
    <message>
        <source>Preview of the report</source>
        <translation>报告预览</translation>
    </message>
    <message>
        <source>writes the report that is looked at</source>
        <translation>生成正在查看的报告</translation>
    </message>
    <message>
        <source>goes to the search</source>
        <translation>转到搜索框</translation>
    </message>
    <message>
        <source>Card of %1</source>
        <translation>%1 的卡片</translation>
    </message>
    <message>
        <source>Tuning of %1</source>
        <translation>%1 的整定</translation>
    </message>
    <message>
        <source>%1 trials</source>
        <translation>%1 次试验</translation>
    </message>
    <message>
        <source>Trial #%1 of %2</source>
        <translation>%2 的试验 #%1</translation>
    </message>
    <message>
        <source>What is listed</source>
        <translation>列出的内容</translation>
    </message>
    <message>
        <source>All</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>Cards</source>
        <translation>卡片</translation>
    </message>
    <message>
        <source>Tuning</source>
        <translation>正在整定</translation>
    </message>
    <message>
        <source>Journal</source>
        <translation>日志簿</translation>
    </message>
    <message>
        <source>Note on this entry</source>
        <translation>此条目的备注</translation>
    </message>
    <message>
        <source>Note on this entry of the journal</source>
        <translation>此日志簿条目的备注</translation>
    </message>
    <message>
        <source>Size of the report</source>
        <translation>报告尺寸</translation>
    </message>
    <message>
        <source>Pages, A4</source>
        <translation>页面，A4</translation>
    </message>
    <message>
        <source>Label, 62 × 29 mm</source>
        <translation>标签，62 × 29 mm</translation>
    </message>
    <message>
        <source>Save CSV…</source>
        <translation>保存 CSV…</translation>
    </message>
    <message>
        <source>The entries of the journal that are listed, as a table</source>
        <translation>将列出的日志簿条目存为表格</translation>
    </message>
    <message>
        <source>Save the journal</source>
        <translation>保存日志簿</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>表格 (*.csv)</translation>
    </message>
    <message>
        <source>the journal is in %1</source>
        <translation>日志簿在 %1</translation>
    </message>
</context>
<context>
    <name>mb::ResolutionMeter</name>
    <message>
        <source>Resolution: off</source>
        <translation>分辨率：关</translation>
    </message>
    <message>
        <source>Resolution: %1 steps</source>
        <translation>分辨率：%1 级</translation>
    </message>
    <message>
        <source>The device knows this value as %1 whole steps: the smallest change is %2 %.</source>
        <translation>设备以 %1 个整数级表示此值：最小变化为 %2 %。</translation>
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
        <translation>演示</translation>
    </message>
    <message>
        <source>t = 0 at the edge, mean of %1 · %2 samples, %3 lost</source>
        <translation>边沿处 t = 0，%1 次平均 · %2 个采样，丢失 %3</translation>
    </message>
    <message>
        <source>t = 0 at the edge · %1 samples, %2 lost</source>
        <translation>边沿处 t = 0 · %1 个采样，丢失 %2</translation>
    </message>
    <message>
        <source>Responses</source>
        <translation>响应</translation>
    </message>
    <message>
        <source>%1 #%2</source>
        <translation>%1 #%2</translation>
    </message>
    <message>
        <source>set-point</source>
        <translation>设定值</translation>
    </message>
    <message>
        <source>±2 % band</source>
        <translation>±2 % 误差带</translation>
    </message>
    <message>
        <source>%1 peak %2 %</source>
        <translation>%1 峰值 %2 %</translation>
    </message>
    <message>
        <source>%1 settles %2</source>
        <translation>%1 调节时间 %2</translation>
    </message>
    <message>
        <source>%1: duty at %2 % limit, %3</source>
        <translation>%1：占空比处于 %2 % 限值，%3</translation>
    </message>
    <message>
        <source>%1: current at its limit, %2</source>
        <translation>%1：电流处于限值，%2</translation>
    </message>
    <message>
        <source>limit %1 %</source>
        <translation>限值 %1 %</translation>
    </message>
    <message>
        <source>limit %1 A</source>
        <translation>限值 %1 A</translation>
    </message>
</context>
<context>
    <name>mb::RoutePanel</name>
    <message>
        <source>Way in</source>
        <translation>接入途径</translation>
    </message>
    <message>
        <source>Programmer</source>
        <translation>编程器</translation>
    </message>
    <message>
        <source>Programmer or port and where it is plugged in, as after --via on the command line</source>
        <translation>编程器或端口及其接入位置，同命令行中 --via 之后的写法</translation>
    </message>
    <message>
        <source>Microcontroller</source>
        <translation>微控制器</translation>
    </message>
    <message>
        <source>Which microcontroller the unit has</source>
        <translation>设备采用哪种微控制器</translation>
    </message>
    <message>
        <source>Erase what the unit has stored: its gains are lost</source>
        <translation>擦除设备已存储的内容：其增益将丢失</translation>
    </message>
    <message>
        <source>What is not known of it…</source>
        <translation>其未知事项…</translation>
    </message>
    <message>
        <source>What the maker does not tell of the bootloader, with the likely values</source>
        <translation>制造商未说明的引导程序信息，附可能的值</translation>
    </message>
</context>
<context>
    <name>mb::SamplesWindow</name>
    <message>
        <source>%1 s, %2 samples, %3 lost</source>
        <translation>%1 s，%2 个采样，丢失 %3</translation>
    </message>
    <message>
        <source>; the end of the file is missing</source>
        <translation>；文件末尾缺失</translation>
    </message>
    <message>
        <source>%1 (recorded samples)</source>
        <translation>%1（记录的采样）</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>正在读取 %1</translation>
    </message>
    <message>
        <source>Fit time and value</source>
        <translation>适配时间和数值</translation>
    </message>
    <message>
        <source>Cursors</source>
        <translation>光标</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>导出</translation>
    </message>
    <message>
        <source>Channels</source>
        <translation>通道</translation>
    </message>
    <message>
        <source>Recorded samples</source>
        <translation>记录的采样</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>已写入：%1</translation>
    </message>
    <message>
        <source>shows everything</source>
        <translation>显示全部</translation>
    </message>
    <message>
        <source>shows or hides the cursors</source>
        <translation>显示或隐藏光标</translation>
    </message>
    <message>
        <source>closes this window</source>
        <translation>关闭此窗口</translation>
    </message>
    <message>
        <source>shows these keys</source>
        <translation>显示这些按键</translation>
    </message>
    <message>
        <source>%1: no samples</source>
        <translation>%1：无采样</translation>
    </message>
    <message>
        <source>One export at a time: %1 is being written.</source>
        <translation>一次只能进行一个导出：正在写入 %1。</translation>
    </message>
    <message>
        <source>; the file has more, of which nothing is shown: it is too large for the memory</source>
        <translation>；文件中还有更多内容，但因内存容纳不下而未显示</translation>
    </message>
</context>
<context>
    <name>mb::SavedLimits</name>
    <message>
        <source>Kept limits</source>
        <translation>保留的限值</translation>
    </message>
    <message>
        <source>kept limits</source>
        <translation>保留的限值</translation>
    </message>
    <message>
        <source>Name of the limits</source>
        <translation>限值的名称</translation>
    </message>
    <message>
        <source>Choose limits that were kept for this unit, or type a name to keep the present ones under</source>
        <translation>选择为此设备保留的限值，或输入名称以保留当前限值</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>保留</translation>
    </message>
    <message>
        <source>Keep these limits under this name</source>
        <translation>以此名称保留这些限值</translation>
    </message>
    <message>
        <source>Forget</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Forget the limits of this name</source>
        <translation>删除此名称的限值</translation>
    </message>
</context>
<context>
    <name>mb::ScanStrip</name>
    <message>
        <source>What the scan looks for</source>
        <translation>扫描的查找对象</translation>
    </message>
    <message>
        <source>Progress of the scan</source>
        <translation>扫描进度</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Cancel the scan</source>
        <translation>取消扫描</translation>
    </message>
    <message>
        <source>Ends the search; what it has found stays.</source>
        <translation>结束搜索；已找到的保留。</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
</context>
<context>
    <name>mb::SendPanel</name>
    <message>
        <source>Send a frame</source>
        <translation>发送帧</translation>
    </message>
    <message>
        <source>Identifier</source>
        <translation>标识符</translation>
    </message>
    <message>
        <source>id, such as 7FF</source>
        <translation>id，例如 7FF</translation>
    </message>
    <message>
        <source>Hexadecimal; a whole frame such as 02061405#8125 may be pasted here</source>
        <translation>十六进制；也可在此粘贴完整的帧，例如 02061405#8125</translation>
    </message>
    <message>
        <source>Length of the identifier</source>
        <translation>标识符长度</translation>
    </message>
    <message>
        <source>11 bits</source>
        <translation>11 位</translation>
    </message>
    <message>
        <source>29 bits</source>
        <translation>29 位</translation>
    </message>
    <message>
        <source>Data</source>
        <translation>数据</translation>
    </message>
    <message>
        <source>data, such as 81 25 11</source>
        <translation>数据，例如 81 25 11</translation>
    </message>
    <message>
        <source>Repeat every</source>
        <translation>重复间隔</translation>
    </message>
    <message>
        <source>Period</source>
        <translation>周期</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> ms</translation>
    </message>
    <message>
        <source>Send</source>
        <translation>发送</translation>
    </message>
    <message>
        <source>Hold to send</source>
        <translation>按住以发送</translation>
    </message>
    <message>
        <source>End repeating</source>
        <translation>结束重复</translation>
    </message>
    <message>
        <source>What is typed here is decoded before it is sent</source>
        <translation>此处输入的内容在发送前会被解码</translation>
    </message>
    <message>
        <source>Makes a motor move: %1</source>
        <translation>会使电机运动：%1</translation>
    </message>
    <message>
        <source>ended</source>
        <translation>已结束</translation>
    </message>
    <message>
        <source>The link does not take frames as fast as they are sent</source>
        <translation>链路接收帧的速度跟不上发送速度</translation>
    </message>
    <message>
        <source>%1 sent</source>
        <translation>已发送 %1</translation>
    </message>
    <message>
        <source>%1 sent, then: %2</source>
        <translation>已发送 %1，之后：%2</translation>
    </message>
    <message>
        <source>the page was left</source>
        <translation>已离开页面</translation>
    </message>
    <message>
        <source>the window lost the focus</source>
        <translation>窗口失去焦点</translation>
    </message>
    <message>
        <source>no decoder knows this identifier</source>
        <translation>没有解码器认识此标识符</translation>
    </message>
    <message>
        <source>%1 of %2 #%3   %4</source>
        <translation>%1，%2 #%3   %4</translation>
    </message>
</context>
<context>
    <name>mb::SessionDesk</name>
    <message>
        <source>today %1</source>
        <translation>今天 %1</translation>
    </message>
    <message>
        <source>yesterday %1</source>
        <translation>昨天 %1</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>%1 is used by %2 too</source>
        <translation>%1 也被 %2 使用</translation>
    </message>
    <message>
        <source>agree who drives: two masters disturb each other</source>
        <translation>请商定由谁驱动：两个主站会互相干扰</translation>
    </message>
    <message>
        <source>The program ended unexpectedly (%1). What was measured is kept. Open again: %2?</source>
        <translation>程序意外结束 (%1)。测得的数据已保留。重新打开 %2 吗？</translation>
    </message>
    <message numerus="yes">
        <source>%n unit(s)</source>
        <translation>
            <numerusform>%n 台设备</numerusform>
        </translation>
    </message>
    <message>
        <source>Open</source>
        <translation>打开</translation>
    </message>
</context>
<context>
    <name>mb::SessionKeeper</name>
    <message>
        <source>This session cannot be kept: %1</source>
        <translation>无法保留此会话：%1</translation>
    </message>
</context>
<context>
    <name>mb::SetPointPanel</name>
    <message>
        <source>Set-point</source>
        <translation>设定值</translation>
    </message>
    <message>
        <source>Enter applies it while the motor runs; it never starts one.</source>
        <translation>电机运行时按 Enter 生效；它从不启动电机。</translation>
    </message>
    <message>
        <source>Set-point, slider</source>
        <translation>设定值，滑块</translation>
    </message>
    <message>
        <source>Hide drive options</source>
        <translation>隐藏驱动选项</translation>
    </message>
    <message>
        <source>Stop and count from 0</source>
        <translation>停止并从 0 计数</translation>
    </message>
    <message>
        <source>Stops the motor, and makes where it stands position 0. It starts again with Run only: a motor that runs would jump.</source>
        <translation>停止电机，并将其所在处设为位置 0。只有按“运行”才会再次启动：运行中的电机会跳动。</translation>
    </message>
    <message>
        <source>device</source>
        <translation>设备</translation>
    </message>
    <message>
        <source>No set-point. Enter a number up to ± %1.</source>
        <translation>没有设定值。请输入不超过 ± %1 的数值。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no number. Enter one up to ± %2.</source>
        <translation>“%1”不是数值。请输入不超过 ± %2 的数值。</translation>
    </message>
    <message>
        <source>%1 is no device number. Enter the number of the device to follow.</source>
        <translation>%1 不是设备编号。请输入要跟随的设备的编号。</translation>
    </message>
    <message>
        <source>%1 is beyond the range of ± %2. Enter less, or widen the range.</source>
        <translation>%1 超出 ± %2 的范围。请输入较小的值，或扩大范围。</translation>
    </message>
    <message>
        <source>now %1</source>
        <translation>当前 %1</translation>
    </message>
    <message>
        <source>Drive options</source>
        <translation>驱动选项</translation>
    </message>
</context>
<context>
    <name>mb::SetPointRange</name>
    <message>
        <source>Range ±</source>
        <translation>范围 ±</translation>
    </message>
    <message>
        <source>Moves</source>
        <translation>变化率</translation>
    </message>
    <message>
        <source>Range of the set-point, either way</source>
        <translation>设定值的范围，正负方向</translation>
    </message>
    <message>
        <source>A set-point beyond it is refused: the limit of the hand, not of the drive.</source>
        <translation>超出此范围的设定值会被拒绝：这是手动操作的限值，而非驱动器的限值。</translation>
    </message>
    <message>
        <source>at once, as a step</source>
        <translation>立即，作为阶跃</translation>
    </message>
    <message>
        <source>full range in %1</source>
        <translation>全范围需 %1</translation>
    </message>
    <message>
        <source>How fast the set-point moves</source>
        <translation>设定值变化的快慢</translation>
    </message>
    <message>
        <source>This program moves the set-point no faster, whatever is typed.</source>
        <translation>无论输入什么，本程序都不会更快地改变设定值。</translation>
    </message>
</context>
<context>
    <name>mb::SideDocks</name>
    <message>
        <source>Devices</source>
        <translation>设备</translation>
    </message>
    <message>
        <source>Inspector</source>
        <translation>检查器</translation>
    </message>
    <message>
        <source>shows or hides the devices</source>
        <translation>显示或隐藏设备列表</translation>
    </message>
    <message>
        <source>shows or hides the inspector</source>
        <translation>显示或隐藏检查器</translation>
    </message>
    <message>
        <source>Show devices</source>
        <translation>显示设备</translation>
    </message>
</context>
<context>
    <name>mb::SignalBook</name>
    <message>
        <source>The signal needs a name.</source>
        <translation>信号需要名称。</translation>
    </message>
    <message>
        <source>There is a derived signal of this name.</source>
        <translation>已有同名的派生信号。</translation>
    </message>
    <message>
        <source>%1 may be one of %2</source>
        <translation>%1 可能是以下之一：%2</translation>
    </message>
</context>
<context>
    <name>mb::SignalList</name>
    <message>
        <source>Add a signal</source>
        <translation>添加信号</translation>
    </message>
    <message>
        <source>double click or drag</source>
        <translation>双击或拖动</translation>
    </message>
    <message>
        <source>Signals that can be plotted</source>
        <translation>可绘制的信号</translation>
    </message>
    <message>
        <source>Derived signal…</source>
        <translation>派生信号…</translation>
    </message>
    <message>
        <source>A formula over signals: derivative, moving average, difference …</source>
        <translation>基于信号的公式：导数、滑动平均、差值 …</translation>
    </message>
    <message>
        <source>derived</source>
        <translation>派生</translation>
    </message>
    <message>
        <source>%1
right click removes the signal</source>
        <translation>%1
右键单击可移除该信号</translation>
    </message>
    <message>
        <source>%1
double click plots it, drag it to a pane or below them</source>
        <translation>%1
双击绘制，或拖到窗格中或窗格下方</translation>
    </message>
    <message>
        <source>Remove this derived signal</source>
        <translation>移除此派生信号</translation>
    </message>
</context>
<context>
    <name>mb::SlotPanel</name>
    <message>
        <source>Gain slot, edit and run</source>
        <translation>增益槽，编辑与运行</translation>
    </message>
    <message>
        <source>The slot that is edited and that runs. Changing it disarms.</source>
        <translation>被编辑且运行的槽。更改后会上锁。</translation>
    </message>
    <message>
        <source>Split</source>
        <translation>拆分</translation>
    </message>
    <message>
        <source>Edit one slot while another runs</source>
        <translation>编辑一个槽，同时运行另一个</translation>
    </message>
    <message>
        <source>Slot</source>
        <translation>槽</translation>
    </message>
    <message>
        <source>edit and run</source>
        <translation>编辑与运行</translation>
    </message>
    <message>
        <source>Gain slot that is edited</source>
        <translation>被编辑的增益槽</translation>
    </message>
    <message>
        <source>Gain slot that runs</source>
        <translation>运行的增益槽</translation>
    </message>
    <message>
        <source>The slot of the next run. Changing it disarms.</source>
        <translation>下次运行所用的槽。更改后会上锁。</translation>
    </message>
    <message>
        <source>Editing slot</source>
        <translation>编辑槽</translation>
    </message>
    <message>
        <source>running</source>
        <translation>运行</translation>
    </message>
    <message>
        <source>Join</source>
        <translation>合并</translation>
    </message>
    <message>
        <source>Edit the slot that runs</source>
        <translation>编辑正在运行的槽</translation>
    </message>
    <message>
        <source>Split: both are slot %1 now.</source>
        <translation>已拆分：现在两者都是槽 %1。</translation>
    </message>
    <message>
        <source>Split: edits go to slot %1, slot %2 runs.</source>
        <translation>已拆分：编辑作用于槽 %1，运行槽 %2。</translation>
    </message>
</context>
<context>
    <name>mb::SpectrumView</name>
    <message>
        <source>Spectrum</source>
        <translation>频谱</translation>
    </message>
    <message>
        <source>frequency, Hz</source>
        <translation>频率，Hz</translation>
    </message>
    <message>
        <source>amplitude</source>
        <translation>幅值</translation>
    </message>
    <message>
        <source>amplitude, %1</source>
        <translation>幅值，%1</translation>
    </message>
    <message>
        <source>A … B</source>
        <translation>A … B</translation>
    </message>
    <message>
        <source>what is seen</source>
        <translation>可见范围</translation>
    </message>
    <message>
        <source>, Hann window, peak values. </source>
        <translation>，Hann 窗，峰值。 </translation>
    </message>
</context>
<context>
    <name>mb::SpokenNames</name>
    <message>
        <source>Places</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>文件夹</translation>
    </message>
    <message>
        <source>Kind of file</source>
        <translation>文件类型</translation>
    </message>
</context>
<context>
    <name>mb::StagedEdits</name>
    <message>
        <source>Discard</source>
        <translation>放弃</translation>
    </message>
</context>
<context>
    <name>mb::StartPage</name>
    <message>
        <source>Start</source>
        <translation>启动</translation>
    </message>
    <message>
        <source>Add link</source>
        <translation>添加链路</translation>
    </message>
    <message>
        <source>Open recording…</source>
        <translation>打开记录…</translation>
    </message>
    <message>
        <source>Try with a simulated motor</source>
        <translation>用仿真电机试用</translation>
    </message>
    <message>
        <source>Open the simulated bench</source>
        <translation>打开仿真台架</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>继续</translation>
    </message>
    <message>
        <source>Firmware on this computer</source>
        <translation>此计算机上的固件</translation>
    </message>
    <message>
        <source>Folder…</source>
        <translation>文件夹…</translation>
    </message>
    <message>
        <source>Choose the folder whose images are listed here</source>
        <translation>选择在此列出其映像的文件夹</translation>
    </message>
    <message>
        <source>First time here?</source>
        <translation>第一次使用？</translation>
    </message>
    <message>
        <source>STOP works on key press, everywhere, also while you type (use Esc then). It is software: keep a hardware stop in the supply.</source>
        <translation>STOP 在按下按键时立即生效，处处有效，输入文字时也有效（此时用 Esc）。它是软件功能：请在电源回路中保留硬件急停。</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>按键</translation>
    </message>
    <message>
        <source>Wiring guides</source>
        <translation>接线指南</translation>
    </message>
    <message>
        <source>Sessions and recordings that you have opened stand here.</source>
        <translation>您打开过的会话和记录显示在此处。</translation>
    </message>
    <message>
        <source>No image (.hex) in this folder.</source>
        <translation>此文件夹中没有映像 (.hex)。</translation>
    </message>
    <message>
        <source>Controllers of every family with real bus timing; nothing real can move.</source>
        <translation>所有系列的控制器，具有真实的总线时序；不会使任何真实电机运动。</translation>
    </message>
</context>
<context>
    <name>mb::StateGlyph</name>
    <message>
        <source>online</source>
        <translation>在线</translation>
    </message>
    <message>
        <source>moving</source>
        <translation>运动中</translation>
    </message>
    <message>
        <source>in bootloader</source>
        <translation>处于引导程序</translation>
    </message>
    <message>
        <source>2 ×</source>
        <translation>2 ×</translation>
    </message>
    <message>
        <source>number 0</source>
        <translation>编号 0</translation>
    </message>
    <message>
        <source>fault</source>
        <translation>故障</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>无应答</translation>
    </message>
    <message>
        <source>stored</source>
        <translation>已存储</translation>
    </message>
    <message>
        <source>RAM, not in flash</source>
        <translation>RAM，不在闪存中</translation>
    </message>
    <message>
        <source>edited</source>
        <translation>已编辑</translation>
    </message>
    <message>
        <source>out of range</source>
        <translation>超范围</translation>
    </message>
    <message>
        <source>assumed</source>
        <translation>假定</translation>
    </message>
    <message>
        <source>volatile</source>
        <translation>易失</translation>
    </message>
    <message>
        <source>busy</source>
        <translation>忙</translation>
    </message>
    <message>
        <source>done</source>
        <translation>完成</translation>
    </message>
    <message>
        <source>waiting</source>
        <translation>等待中</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>recording</source>
        <translation>记录中</translation>
    </message>
</context>
<context>
    <name>mb::StationDialog</name>
    <message>
        <source>Journal of this station</source>
        <translation>本工位的日志簿</translation>
    </message>
    <message>
        <source>Name of this station</source>
        <translation>本工位的名称</translation>
    </message>
    <message>
        <source>Server that stations share</source>
        <translation>各工位共享的服务器</translation>
    </message>
    <message>
        <source>Without a server the journal is in the file of this computer alone. With one, every entry is there first and delivered as soon as the server answers; numbers come in blocks of five.</source>
        <translation>没有服务器时，日志簿只在这台计算机的文件中。有服务器时，每条记录先写在那里，服务器一应答就送达；编号每次分配五个。</translation>
    </message>
</context>
<context>
    <name>mb::StationLamp</name>
    <message>
        <source>%1 self-test</source>
        <translation>%1 自检</translation>
    </message>
    <message>
        <source>turns in a moment</source>
        <translation>即将转动</translation>
    </message>
    <message>
        <source>self-tests</source>
        <translation>自检</translation>
    </message>
    <message>
        <source>nothing turns here</source>
        <translation>这里没有转动的电机</translation>
    </message>
    <message>
        <source>Arm button</source>
        <translation>解锁按钮</translation>
    </message>
</context>
<context>
    <name>mb::StatusBar</name>
    <message>
        <source>samples %1   lost %2   memory %3</source>
        <translation>采样 %1   丢失 %2   内存 %3</translation>
    </message>
</context>
<context>
    <name>mb::StepText</name>
    <message>
        <source>%1, predicted</source>
        <translation>%1，预测</translation>
    </message>
    <message>
        <source>measured, forwards</source>
        <translation>实测，正向</translation>
    </message>
    <message>
        <source>measured, backwards</source>
        <translation>实测，反向</translation>
    </message>
    <message>
        <source>measured: %1 % over, settled after %2</source>
        <translation>实测：超调 %1 %，%2 后稳定</translation>
    </message>
    <message>
        <source>%1 % over</source>
        <translation>超调 %1 %</translation>
    </message>
    <message>
        <source>%1 A peak</source>
        <translation>峰值 %1 A</translation>
    </message>
    <message>
        <source>±2 %</source>
        <translation>±2 %</translation>
    </message>
    <message>
        <source>%1 settles %2</source>
        <translation>%1：调节 %2</translation>
    </message>
    <message>
        <source>%1 does not settle</source>
        <translation>%1：不稳定到位</translation>
    </message>
    <message>
        <source>measured: peak %1, %2 % over</source>
        <translation>实测：峰值 %1，超调 %2 %</translation>
    </message>
    <message>
        <source>measured: settles %1</source>
        <translation>实测：调节 %1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
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
        <translation>%1 %2 的阶跃</translation>
    </message>
    <message>
        <source>band: ± of the model</source>
        <translation>带：模型的 ±</translation>
    </message>
</context>
<context>
    <name>mb::StepsPanel</name>
    <message>
        <source>Steps of the update</source>
        <translation>更新的步骤</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>步骤</translation>
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
        <translation>到达并稳定，然后返回</translation>
    </message>
    <message>
        <source>to and fro, 0.5 Hz</source>
        <translation>往复，0.5 Hz</translation>
    </message>
    <message>
        <source>evenly there and back</source>
        <translation>匀速往返</translation>
    </message>
    <message>
        <source>1 Hz, six swings</source>
        <translation>1 Hz，六次摆动</translation>
    </message>
    <message>
        <source>0.1 to 15 Hz in 30 s</source>
        <translation>30 s 内 0.1 至 15 Hz</translation>
    </message>
    <message>
        <source>random bits of 125 ms</source>
        <translation>125 ms 的随机位</translation>
    </message>
    <message>
        <source>Stimulus</source>
        <translation>激励</translation>
    </message>
    <message>
        <source>From</source>
        <translation>从</translation>
    </message>
    <message>
        <source>Where the experiment begins and ends; empty: where the motor is, or 0</source>
        <translation>实验开始和结束之处；留空：电机所在处，或 0</translation>
    </message>
    <message>
        <source>To</source>
        <translation>到</translation>
    </message>
    <message>
        <source>Where the loop is asked to go</source>
        <translation>要求回路到达之处</translation>
    </message>
    <message>
        <source>hold</source>
        <translation>保持</translation>
    </message>
    <message>
        <source>Time of the stimulus</source>
        <translation>激励时间</translation>
    </message>
    <message>
        <source>Seconds; empty: the usual, and a step ends once it has settled</source>
        <translation>秒；留空：采用常规值，阶跃在稳定后结束</translation>
    </message>
    <message>
        <source>settled</source>
        <translation>稳定后</translation>
    </message>
    <message>
        <source>usual</source>
        <translation>常规</translation>
    </message>
    <message>
        <source>Repeats</source>
        <translation>重复</translation>
    </message>
    <message>
        <source>Each repeat starts a little later between two samples: together they show what is finer than the telemetry</source>
        <translation>每次重复都在两个采样之间稍晚开始：合在一起可显示比遥测更精细的内容</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>here</source>
        <translation>此处</translation>
    </message>
    <message>
        <source>rise</source>
        <translation>上升</translation>
    </message>
    <message>
        <source>time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Enter where the loop is to go.</source>
        <translation>请输入回路的目标。</translation>
    </message>
    <message>
        <source>%1 is no number.</source>
        <translation>%1 不是数值。</translation>
    </message>
    <message>
        <source>The time is 0.001 to %1 s.</source>
        <translation>时间为 0.001 至 %1 s。</translation>
    </message>
</context>
<context>
    <name>mb::StopButton</name>
    <message>
        <source>Space · Esc</source>
        <translation>空格 · Esc</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>STOP</translation>
    </message>
    <message>
        <source>Stop every motor</source>
        <translation>停止所有电机</translation>
    </message>
    <message>
        <source>Stop every motor  Space, Esc, Pause</source>
        <translation>停止所有电机  空格、Esc、Pause</translation>
    </message>
</context>
<context>
    <name>mb::StoryCard</name>
    <message numerus="yes">
        <source>about %n min</source>
        <translation>
            <numerusform>约 %n min</numerusform>
        </translation>
    </message>
    <message>
        <source>Try it</source>
        <translation>试一试</translation>
    </message>
    <message>
        <source>Try it: %1</source>
        <translation>试一试：%1</translation>
    </message>
</context>
<context>
    <name>mb::SweepPanel</name>
    <message>
        <source>%1 sines from %2 to %3 Hz, both ways in turn: duty %4 ± %5 %, at most %6 counts/s, %7 counts one way, %8.</source>
        <translation>%1 个正弦，%2 至 %3 Hz，两个方向交替：占空比 %4 ± %5 %，最大 %6 counts/s，单方向 %7 counts，%8。</translation>
    </message>
    <message>
        <source>Frequency response</source>
        <translation>频率响应</translation>
    </message>
    <message>
        <source>Measures the motor by sines and draws it over its model, as far as it may be trusted</source>
        <translation>用正弦测量电机，并在可信范围内叠加绘制在其模型上</translation>
    </message>
</context>
<context>
    <name>mb::TimelineList</name>
    <message>
        <source>window</source>
        <translation>窗口</translation>
    </message>
    <message>
        <source>console</source>
        <translation>控制台</translation>
    </message>
    <message>
        <source>autotune</source>
        <translation>自整定</translation>
    </message>
    <message>
        <source>recipe</source>
        <translation>配方</translation>
    </message>
    <message>
        <source>elsewhere</source>
        <translation>其他来源</translation>
    </message>
    <message>
        <source>States of this unit</source>
        <translation>此设备的各个状态</translation>
    </message>
    <message>
        <source>Today, %1</source>
        <translation>今天，%1</translation>
    </message>
    <message>
        <source>like A</source>
        <translation>同 A</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>undone: %1</source>
        <translation>已撤销：%1</translation>
    </message>
    <message>
        <source>done again: %1</source>
        <translation>已重做：%1</translation>
    </message>
    <message numerus="yes">
        <source>%n differ</source>
        <translation>
            <numerusform>%n 项不同</numerusform>
        </translation>
    </message>
    <message>
        <source>Always there</source>
        <translation>始终可用</translation>
    </message>
    <message>
        <source>This place, not this unit</source>
        <translation>此位置，而非此设备</translation>
    </message>
    <message>
        <source>reverted: %1</source>
        <translation>已恢复：%1</translation>
    </message>
</context>
<context>
    <name>mb::TourStage</name>
    <message>
        <source>tour</source>
        <translation>导览</translation>
    </message>
</context>
<context>
    <name>mb::TraceList</name>
    <message>
        <source>Remove the trace</source>
        <translation>移除曲线</translation>
    </message>
    <message>
        <source>Pane, axis, trigger, reference …</source>
        <translation>窗格、轴、触发、参考 …</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>移除 %1</translation>
    </message>
    <message>
        <source>Traces</source>
        <translation>曲线</translation>
    </message>
</context>
<context>
    <name>mb::TracePanel</name>
    <message>
        <source>Traces</source>
        <translation>曲线</translation>
    </message>
    <message>
        <source>rate      lost</source>
        <translation>频率      丢失</translation>
    </message>
    <message>
        <source>mean %1 · σ %2 · %3 … %4 · %5 samples</source>
        <translation>平均 %1 · σ %2 · %3 … %4 · %5 个采样</translation>
    </message>
    <message>
        <source> · %1 lost</source>
        <translation> · 丢失 %1</translation>
    </message>
    <message>
        <source>derived</source>
        <translation>派生</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source>%1 lost</source>
        <translation>丢失 %1</translation>
    </message>
    <message>
        <source>A %1   B %2</source>
        <translation>A %1   B %2</translation>
    </message>
    <message>
        <source>In a pane of its own</source>
        <translation>放入单独的窗格</translation>
    </message>
    <message>
        <source>Into the pane above</source>
        <translation>放入上方窗格</translation>
    </message>
    <message>
        <source>With its unit</source>
        <translation>与同单位曲线合并</translation>
    </message>
    <message>
        <source>Scale at the right</source>
        <translation>刻度在右侧</translation>
    </message>
    <message>
        <source>Trigger on it	T</source>
        <translation>以此触发	T</translation>
    </message>
    <message>
        <source>Keep all as references</source>
        <translation>全部保留为参考</translation>
    </message>
    <message>
        <source>Remove references</source>
        <translation>移除参考</translation>
    </message>
    <message>
        <source>Spectrum</source>
        <translation>频谱</translation>
    </message>
    <message>
        <source>Remove the trace</source>
        <translation>移除曲线</translation>
    </message>
    <message>
        <source>%1 cursors · %2 fits · + − zooms · %3 pauses · N note</source>
        <translation>%1 光标 · %2 适配 · + − 缩放 · %3 暂停 · N 注释</translation>
    </message>
    <message>
        <source>%1, of another time</source>
        <translation>%1，其他时间</translation>
    </message>
</context>
<context>
    <name>mb::TrafficView</name>
    <message>
        <source>Columns of %1</source>
        <translation>%1 的列</translation>
    </message>
</context>
<context>
    <name>mb::TrialList</name>
    <message>
        <source>Which trials</source>
        <translation>哪些试验</translation>
    </message>
    <message>
        <source>All</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>Starred</source>
        <translation>已加星标</translation>
    </message>
    <message>
        <source>Clean</source>
        <translation>无瑕疵</translation>
    </message>
    <message>
        <source>Back to best</source>
        <translation>返回最佳</translation>
    </message>
    <message>
        <source>Stages the gains of the quickest clean trial with no more than 5 % overshoot; runs nothing.</source>
        <translation>暂存超调不超过 5 % 的最快无瑕疵试验的增益；不运行任何内容。</translation>
    </message>
    <message>
        <source>Export the trials as CSV or JSON</source>
        <translation>将试验导出为 CSV 或 JSON</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>试验</translation>
    </message>
    <message>
        <source>Trials of this loop</source>
        <translation>此回路的试验</translation>
    </message>
    <message>
        <source>Every experiment appears here with its gains and what became of it.</source>
        <translation>每次实验都会连同其增益和结果显示在此处。</translation>
    </message>
    <message>
        <source>stopped: speed</source>
        <translation>已停止：速度</translation>
    </message>
    <message numerus="yes">
        <source>%n, every run is kept</source>
        <translation>
            <numerusform>%n 次，每次运行均保留</numerusform>
        </translation>
    </message>
    <message>
        <source>All %1</source>
        <translation>全部 %1</translation>
    </message>
    <message>
        <source>Starred %1</source>
        <translation>已加星标 %1</translation>
    </message>
    <message>
        <source>Clean %1</source>
        <translation>无瑕疵 %1</translation>
    </message>
    <message>
        <source>Back to best #%1</source>
        <translation>返回最佳 #%1</translation>
    </message>
    <message>
        <source>Show as B</source>
        <translation>显示为 B</translation>
    </message>
    <message>
        <source>Pin as A  A</source>
        <translation>固定为 A  A</translation>
    </message>
    <message>
        <source>Use these gains</source>
        <translation>使用这些增益</translation>
    </message>
    <message>
        <source>Take the star away</source>
        <translation>去除星标</translation>
    </message>
    <message>
        <source>Give it a star</source>
        <translation>加星标</translation>
    </message>
    <message>
        <source>Edit the note</source>
        <translation>编辑注释</translation>
    </message>
    <message>
        <source>Forget this trial</source>
        <translation>删除此试验</translation>
    </message>
</context>
<context>
    <name>mb::TrialModel</name>
    <message>
        <source>Use</source>
        <translation>使用</translation>
    </message>
    <message>
        <source>Take the star away</source>
        <translation>去除星标</translation>
    </message>
    <message>
        <source>Give it a star</source>
        <translation>加星标</translation>
    </message>
    <message>
        <source>Stages the gains of this trial; nothing is written yet.</source>
        <translation>暂存此试验的增益；尚未写入任何内容。</translation>
    </message>
    <message>
        <source>starred</source>
        <translation>已加星标</translation>
    </message>
    <message>
        <source>no star</source>
        <translation>无星标</translation>
    </message>
    <message>
        <source>Use the gains of trial #%1</source>
        <translation>使用试验 #%1 的增益</translation>
    </message>
    <message>
        <source>trial</source>
        <translation>试验</translation>
    </message>
    <message>
        <source>time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>stimulus</source>
        <translation>激励</translation>
    </message>
    <message>
        <source>over %</source>
        <translation>超调 %</translation>
    </message>
    <message>
        <source>settle</source>
        <translation>调节</translation>
    </message>
    <message>
        <source>rise</source>
        <translation>上升</translation>
    </message>
    <message>
        <source>peak A</source>
        <translation>峰值 A</translation>
    </message>
    <message>
        <source>flags</source>
        <translation>标志</translation>
    </message>
    <message>
        <source>note</source>
        <translation>注释</translation>
    </message>
</context>
<context>
    <name>mb::TrialOrders</name>
    <message>
        <source>the notebook: %1</source>
        <translation>试验记录本：%1</translation>
    </message>
    <message>
        <source>Export trials</source>
        <translation>导出试验</translation>
    </message>
    <message>
        <source>Table (*.csv);;JSON (*.json)</source>
        <translation>表格 (*.csv);;JSON (*.json)</translation>
    </message>
    <message>
        <source>trials written to %1</source>
        <translation>试验已写入 %1</translation>
    </message>
</context>
<context>
    <name>mb::TrialWords</name>
    <message>
        <source>better</source>
        <translation>更好</translation>
    </message>
    <message>
        <source>worse</source>
        <translation>更差</translation>
    </message>
    <message>
        <source>faster</source>
        <translation>更快</translation>
    </message>
    <message>
        <source>slower</source>
        <translation>更慢</translation>
    </message>
    <message>
        <source>Rise 10–90</source>
        <translation>上升 10–90</translation>
    </message>
    <message>
        <source>Settle 2 %</source>
        <translation>调节 2 %</translation>
    </message>
    <message>
        <source>Overshoot</source>
        <translation>超调</translation>
    </message>
    <message>
        <source>Undershoot</source>
        <translation>下冲</translation>
    </message>
    <message>
        <source>Steady error</source>
        <translation>稳态误差</translation>
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
        <translation>峰值电流</translation>
    </message>
    <message>
        <source>Duty chatter</source>
        <translation>占空比抖动</translation>
    </message>
    <message>
        <source>Saturated</source>
        <translation>饱和</translation>
    </message>
    <message>
        <source>Noise σ</source>
        <translation>噪声 σ</translation>
    </message>
    <message>
        <source>Step and back</source>
        <translation>阶跃往返</translation>
    </message>
    <message>
        <source>Square</source>
        <translation>方波</translation>
    </message>
    <message>
        <source>Ramp</source>
        <translation>斜坡</translation>
    </message>
    <message>
        <source>Sine</source>
        <translation>正弦</translation>
    </message>
    <message>
        <source>Chirp</source>
        <translation>扫频</translation>
    </message>
    <message>
        <source>PRBS</source>
        <translation>PRBS</translation>
    </message>
    <message>
        <source>stopped: %1</source>
        <translation>已停止：%1</translation>
    </message>
    <message>
        <source>nobody saw its end</source>
        <translation>无人看到其结束</translation>
    </message>
    <message>
        <source>%1 samples lost</source>
        <translation>丢失 %1 个采样</translation>
    </message>
    <message>
        <source>saturated %1 %</source>
        <translation>饱和 %1 %</translation>
    </message>
</context>
<context>
    <name>mb::TrialsHead</name>
    <message>
        <source>Flip A and B</source>
        <translation>交换 A 和 B</translation>
    </message>
    <message>
        <source>Pin B as A</source>
        <translation>将 B 固定为 A</translation>
    </message>
    <message>
        <source>Cursors A and B</source>
        <translation>光标 A 和 B</translation>
    </message>
    <message>
        <source>Fit time and value</source>
        <translation>适配时间和数值</translation>
    </message>
    <message>
        <source>A #%1 is another stimulus, it is not drawn</source>
        <translation>A #%1 的激励不同，未绘制</translation>
    </message>
    <message>
        <source>Shift+click on a trial pins it as A</source>
        <translation>Shift+单击试验可将其固定为 A</translation>
    </message>
    <message>
        <source>No trial yet. Run makes the first.</source>
        <translation>尚无试验。“运行”进行第一次。</translation>
    </message>
</context>
<context>
    <name>mb::TrialsView</name>
    <message>
        <source>Below the plot</source>
        <translation>曲线图下方</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>试验</translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation>指标</translation>
    </message>
    <message>
        <source>not kept: %1</source>
        <translation>未保留：%1</translation>
    </message>
</context>
<context>
    <name>mb::TriggerBar</name>
    <message>
        <source>Trigger off</source>
        <translation>触发关闭</translation>
    </message>
    <message>
        <source>Arm again: forgets this event, waits for the next</source>
        <translation>重新就绪：丢弃此事件，等待下一个</translation>
    </message>
    <message>
        <source>Trace that triggers</source>
        <translation>触发曲线</translation>
    </message>
    <message>
        <source>↑ rises through</source>
        <translation>↑ 上升穿过</translation>
    </message>
    <message>
        <source>↓ falls through</source>
        <translation>↓ 下降穿过</translation>
    </message>
    <message>
        <source>↕ crosses</source>
        <translation>↕ 穿过</translation>
    </message>
    <message>
        <source>is above</source>
        <translation>高于</translation>
    </message>
    <message>
        <source>is below</source>
        <translation>低于</translation>
    </message>
    <message>
        <source>Edge or level</source>
        <translation>边沿或电平</translation>
    </message>
    <message>
        <source>%1 % before</source>
        <translation>之前 %1 %</translation>
    </message>
    <message>
        <source>Part of the window before the event</source>
        <translation>事件之前的窗口份额</translation>
    </message>
    <message>
        <source>What follows an event</source>
        <translation>事件之后的动作</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>正常</translation>
    </message>
    <message>
        <source>Single</source>
        <translation>单次</translation>
    </message>
    <message>
        <source>Normal shows every event, single stops at the first</source>
        <translation>“正常”显示每个事件，“单次”在第一个事件处停止</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>电平</translation>
    </message>
    <message>
        <source>The level; the handle ▸ at the left of the plot drags it, too</source>
        <translation>电平；也可拖动曲线图左侧的手柄 ▸</translation>
    </message>
    <message>
        <source>trigger %1 %2 %3, %4 before</source>
        <translation>触发 %1 %2 %3，之前 %4</translation>
    </message>
</context>
<context>
    <name>mb::TuneAxes</name>
    <message>
        <source>%1 %2, at rest</source>
        <comment>mode and target</comment>
        <translation>%1 %2，静止</translation>
    </message>
    <message>
        <source>axis %1 moves in another mode; stop it first</source>
        <translation>轴 %1 正以另一模式运动；请先停止它</translation>
    </message>
</context>
<context>
    <name>mb::TuneColumn</name>
    <message>
        <source>The power limit of axis %1 is unknown: its first motion sets it to %2. Write another under Limits of the axis.</source>
        <translation>轴 %1 的功率限值未知：首次运动会将其设为 %2。可在“轴的限值”中写入其他值。</translation>
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
        <translation>停止运动</translation>
    </message>
    <message>
        <source>Ends the motion and stays armed. STOP, Esc and Pause stop everything.</source>
        <translation>结束运动并保持解锁。STOP、Esc 和 Pause 停止一切。</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>运行</translation>
    </message>
    <message>
        <source>Write and run</source>
        <translation>写入并运行</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>应用</translation>
    </message>
    <message>
        <source>Run %1 axes</source>
        <translation>运行 %1 轴</translation>
    </message>
    <message>
        <source>View</source>
        <translation>视图</translation>
    </message>
    <message>
        <source>Experiment</source>
        <translation>实验</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>实时</translation>
    </message>
    <message>
        <source>Stop axis %1</source>
        <translation>停止轴 %1</translation>
    </message>
</context>
<context>
    <name>mb::TuneExperiments</name>
    <message>
        <source>Experiment</source>
        <translation>实验</translation>
    </message>
    <message>
        <source>Moving</source>
        <translation>正在运动</translation>
    </message>
    <message>
        <source>Stop the motion before an experiment.</source>
        <translation>请先停止运动，再进行实验。</translation>
    </message>
    <message>
        <source>The stimulus cannot be sent</source>
        <translation>无法发送激励</translation>
    </message>
    <message>
        <source>No experiment yet</source>
        <translation>尚不能实验</translation>
    </message>
    <message>
        <source>No experiment in this mode</source>
        <translation>此模式下不能实验</translation>
    </message>
    <message>
        <source>Armed</source>
        <translation>已解锁</translation>
    </message>
    <message>
        <source>Not armed</source>
        <translation>未解锁</translation>
    </message>
    <message>
        <source>Hold the Arm button for 1 s to arm %1.</source>
        <translation>按住“解锁”按钮 1 s 以解锁 %1。</translation>
    </message>
    <message>
        <source>The position of axis %1 is not known yet</source>
        <translation>轴 %1 的位置尚不清楚</translation>
    </message>
    <message>
        <source>no device</source>
        <translation>没有设备</translation>
    </message>
    <message>
        <source>its position is not known yet</source>
        <translation>其位置尚不清楚</translation>
    </message>
    <message>
        <source>Run begins the experiment.</source>
        <translation>“运行”开始实验。</translation>
    </message>
</context>
<context>
    <name>mb::TuneForm</name>
    <message>
        <source>the running slot</source>
        <translation>运行的槽</translation>
    </message>
    <message>
        <source>a direction or a limit</source>
        <translation>方向或限位</translation>
    </message>
    <message>
        <source>the mode</source>
        <translation>模式</translation>
    </message>
</context>
<context>
    <name>mb::TuneFrame</name>
    <message>
        <source>Part of the page</source>
        <translation>页面部分</translation>
    </message>
    <message>
        <source>Set-up</source>
        <translation>设置</translation>
    </message>
    <message>
        <source>Plot</source>
        <translation>曲线图</translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation>指标</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>试验</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>实时</translation>
    </message>
</context>
<context>
    <name>mb::TuneGains</name>
    <message>
        <source>A gain is out of range</source>
        <translation>有增益超出范围</translation>
    </message>
    <message>
        <source>Correct or revert it first.</source>
        <translation>请先更正或还原它。</translation>
    </message>
    <message>
        <source>Look at a gain again</source>
        <translation>请复查一项增益</translation>
    </message>
    <message>
        <source>Writing gains</source>
        <translation>正在写入增益</translation>
    </message>
    <message>
        <source>Reading gains</source>
        <translation>正在读取增益</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>gains not written: %1</source>
        <translation>增益未写入：%1</translation>
    </message>
    <message>
        <source>Gains of trial #%1</source>
        <translation>试验 #%1 的增益</translation>
    </message>
    <message>
        <source>What the adviser proposes</source>
        <translation>顾问的建议</translation>
    </message>
    <message>
        <source>nothing copied: no gain of axis %1 is known for this mode; write it first</source>
        <translation>未复制任何内容：轴 %1 在此模式下没有已知的增益；请先写入</translation>
    </message>
    <message>
        <source>Gains and limits of axis %1</source>
        <translation>轴 %1 的增益和限值</translation>
    </message>
</context>
<context>
    <name>mb::TuneKeys</name>
    <message>
        <source>writes what is staged and runs</source>
        <translation>写入暂存内容并运行</translation>
    </message>
    <message>
        <source>the same, four times over</source>
        <translation>同上，连续四次</translation>
    </message>
    <message>
        <source>a battery of steps: several sizes, both ways, and the worst of them</source>
        <translation>阶跃序列：多种幅度、两个方向，以及其中最差的结果</translation>
    </message>
    <message>
        <source>goes to the first gain</source>
        <translation>转到第一个增益</translation>
    </message>
    <message>
        <source>swaps the gain slots; disarms</source>
        <translation>交换增益槽；会上锁</translation>
    </message>
    <message>
        <source>flips trials A and B</source>
        <translation>交换试验 A 和 B</translation>
    </message>
    <message>
        <source>pins trial B as A</source>
        <translation>将试验 B 固定为 A</translation>
    </message>
    <message>
        <source>cursors in the plot: arrows move one, C changes to the other</source>
        <translation>曲线图中的光标：方向键移动一个，C 切换到另一个</translation>
    </message>
    <message>
        <source>fits time and value of the plot</source>
        <translation>适配曲线图的时间和数值</translation>
    </message>
    <message>
        <source>pauses the live view, and goes on</source>
        <translation>暂停实时视图，或继续</translation>
    </message>
    <message>
        <source>identifies the device: it blinks</source>
        <translation>识别设备：使其闪烁</translation>
    </message>
    <message>
        <source>undoes the last edit of gains, or else the last write to the unit</source>
        <translation>撤销上一次增益编辑，否则撤销上一次写入设备的操作</translation>
    </message>
    <message>
        <source>writes a report of the trials that are shown</source>
        <translation>为所显示的试验生成报告</translation>
    </message>
    <message>
        <source>held: moves the armed motor gently forwards or backwards</source>
        <translation>按住：使已解锁的电机平缓地正向或反向运动</translation>
    </message>
    <message>
        <source>on a gain&apos;s slider: 2 %, with Shift 0.2 %, with Ctrl 20 %; the wheel does the same by 2 %</source>
        <translation>在增益滑块上：2 %，按 Shift 为 0.2 %，按 Ctrl 为 20 %；滚轮同样每次 2 %</translation>
    </message>
    <message>
        <source>redoes the last edit or write</source>
        <translation>重做上一次编辑或写入</translation>
    </message>
</context>
<context>
    <name>mb::TuneMotion</name>
    <message>
        <source>position 0 is here; the motor is off until Run</source>
        <translation>此处为位置 0；在“运行”之前电机关闭</translation>
    </message>
    <message>
        <source>it has no lamp that could blink</source>
        <translation>它没有可闪烁的指示灯</translation>
    </message>
    <message>
        <source>not identified: %1</source>
        <translation>未识别：%1</translation>
    </message>
    <message>
        <source>disarmed: %1 changed</source>
        <translation>已上锁：%1已更改</translation>
    </message>
    <message>
        <source>Moving</source>
        <translation>正在运动</translation>
    </message>
    <message>
        <source>Armed</source>
        <translation>已解锁</translation>
    </message>
    <message>
        <source>Not armed</source>
        <translation>未解锁</translation>
    </message>
    <message>
        <source>Hold the Arm button for 1 s to arm %1.</source>
        <translation>按住“解锁”按钮 1 s 以解锁 %1。</translation>
    </message>
    <message>
        <source>axis %1: %2</source>
        <translation>轴 %1：%2</translation>
    </message>
    <message>
        <source>%1, slot %2</source>
        <translation>%1，槽 %2</translation>
    </message>
    <message>
        <source> · also moving: axis %1</source>
        <translation> · 同时运动：轴 %1</translation>
    </message>
    <message>
        <source>Its position is not known yet</source>
        <translation>其位置尚不清楚</translation>
    </message>
    <message>
        <source>It starts where it is once it has told where that is.</source>
        <translation>一旦报告了所在位置，就从那里开始。</translation>
    </message>
    <message>
        <source>%1: holds</source>
        <translation>%1：保持</translation>
    </message>
    <message>
        <source>%1 by %2</source>
        <translation>%1 移动 %2</translation>
    </message>
    <message>
        <source>Run begins %1</source>
        <translation>“运行”开始%1</translation>
    </message>
</context>
<context>
    <name>mb::TunePage</name>
    <message>
        <source>disarmed: another device is selected</source>
        <translation>已上锁：选择了另一台设备</translation>
    </message>
    <message>
        <source>%1 is in its bootloader</source>
        <translation>%1 处于引导程序</translation>
    </message>
    <message>
        <source>It cannot drive a motor until it has firmware. Write an image on the Firmware page.</source>
        <translation>在写入固件之前，它无法驱动电机。请在“固件”页面写入映像。</translation>
    </message>
    <message>
        <source>Select a device</source>
        <translation>请选择设备</translation>
    </message>
    <message>
        <source>No device yet</source>
        <translation>尚无设备</translation>
    </message>
    <message>
        <source>Choose one in the list at the left; its loop is tuned here.</source>
        <translation>请在左侧列表中选择一个；其回路在此整定。</translation>
    </message>
    <message>
        <source>Open a link, or the simulated bench from the menu, to drive a motor.</source>
        <translation>要驱动电机，请打开链路，或从菜单打开仿真台架。</translation>
    </message>
    <message>
        <source>No device</source>
        <translation>无设备</translation>
    </message>
    <message>
        <source>No answer from %1</source>
        <translation>%1 无应答</translation>
    </message>
    <message>
        <source>The plot keeps what it has.</source>
        <translation>曲线图保留已有内容。</translation>
    </message>
    <message>
        <source>Stopped: %1</source>
        <translation>已停止：%1</translation>
    </message>
    <message>
        <source>Hold the Arm button for 1 s to arm again.</source>
        <translation>按住“解锁”按钮 1 s 以重新解锁。</translation>
    </message>
    <message>
        <source>%1 cannot be armed</source>
        <translation>%1 无法解锁</translation>
    </message>
    <message>
        <source>The set-point cannot be sent</source>
        <translation>无法发送设定值</translation>
    </message>
    <message>
        <source>Something moves</source>
        <translation>有设备在运动</translation>
    </message>
    <message>
        <source>Hold the Arm button for 1 s to arm it first.</source>
        <translation>请先按住“解锁”按钮 1 s 以解锁。</translation>
    </message>
    <message>
        <source>not run: %1. %2</source>
        <translation>未运行：%1。%2</translation>
    </message>
</context>
<context>
    <name>mb::TunePlot</name>
    <message>
        <source>Units</source>
        <translation>单位</translation>
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
        <translation>每转计数</translation>
    </message>
    <message>
        <source>Encoder counts of one turn of the shaft, four for each line. Used for rpm, degrees and gains in physical units.</source>
        <translation>轴转一圈的编码器计数，每线四个。用于 rpm、度和物理单位的增益。</translation>
    </message>
    <message>
        <source>counts/rev</source>
        <translation>counts/rev</translation>
    </message>
    <message>
        <source>last %1 s</source>
        <translation>最近 %1 s</translation>
    </message>
    <message>
        <source>Length of the time axis</source>
        <translation>时间轴长度</translation>
    </message>
    <message>
        <source>Pause the view</source>
        <translation>暂停视图</translation>
    </message>
    <message>
        <source>Cursors A and B</source>
        <translation>光标 A 和 B</translation>
    </message>
    <message>
        <source>Fit time and value</source>
        <translation>适配时间和数值</translation>
    </message>
    <message>
        <source>plot written to %1</source>
        <translation>曲线图已写入 %1</translation>
    </message>
    <message>
        <source>Set-point</source>
        <translation>设定值</translation>
    </message>
    <message>
        <source>ch%1 set-point</source>
        <translation>ch%1 设定值</translation>
    </message>
    <message>
        <source>DEMO</source>
        <translation>演示</translation>
    </message>
</context>
<context>
    <name>mb::TuneSteps</name>
    <message>
        <source>Direction</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>Envelope</source>
        <translation>限界</translation>
    </message>
    <message>
        <source>Identify</source>
        <translation>辨识</translation>
    </message>
    <message>
        <source>Gains</source>
        <translation>增益</translation>
    </message>
    <message>
        <source>Verify</source>
        <translation>验证</translation>
    </message>
    <message>
        <source>Store</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>The direction of motor and encoder was checked; the first closed loop of a run checks it again.</source>
        <translation>电机与编码器的方向已检查；每次运行的首个闭环会再次检查。</translation>
    </message>
    <message>
        <source>Checked by itself before the first closed loop of a run.</source>
        <translation>在每次运行的首个闭环之前自动检查。</translation>
    </message>
    <message>
        <source>Every limit of an experiment is known.</source>
        <translation>实验的各项限值均已知。</translation>
    </message>
    <message>
        <source>Trial #%1 pushed the motor without a loop.</source>
        <translation>试验 #%1 在无闭环下推动了电机。</translation>
    </message>
    <message>
        <source>The device has the gains that are shown.</source>
        <translation>设备中的增益与显示一致。</translation>
    </message>
    <message>
        <source>Edited gains wait to be written.</source>
        <translation>已编辑的增益等待写入。</translation>
    </message>
    <message>
        <source>The gains of the device are not known yet.</source>
        <translation>设备的增益尚不清楚。</translation>
    </message>
    <message>
        <source>Trial #%1 ran with these gains.</source>
        <translation>试验 #%1 使用了这些增益。</translation>
    </message>
    <message>
        <source>The gains are in flash.</source>
        <translation>增益已在闪存中。</translation>
    </message>
    <message>
        <source>The gains are not known to be in flash.</source>
        <translation>不确定增益是否已在闪存中。</translation>
    </message>
    <message>
        <source>%1: done</source>
        <comment>step</comment>
        <translation>%1：已完成</translation>
    </message>
    <message>
        <source>Steps; next is %1</source>
        <translation>步骤；下一步是%1</translation>
    </message>
    <message>
        <source>Steps; all are done</source>
        <translation>步骤；全部完成</translation>
    </message>
    <message>
        <source>The last check found it wrong: the encoder is reversed, or the motor did not move.</source>
        <translation>上次检查发现不正确：编码器接反，或电机没有转动。</translation>
    </message>
    <message>
        <source>No model of the motor yet: the page Design identifies it.</source>
        <translation>尚无电机模型：在“设计”页辨识。</translation>
    </message>
    <message>
        <source>No trial with these gains yet: Run makes one.</source>
        <translation>尚无使用这些增益的试验：“运行”进行一次。</translation>
    </message>
</context>
<context>
    <name>mb::TuningSteps</name>
    <message>
        <source>Kept</source>
        <translation>已保留</translation>
    </message>
    <message>
        <source>Proposed, nothing written</source>
        <translation>已建议，未写入任何内容</translation>
    </message>
    <message>
        <source>Rolled back</source>
        <translation>已回退</translation>
    </message>
    <message>
        <source>Refused</source>
        <translation>已拒绝</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>已停止</translation>
    </message>
    <message>
        <source>What happens</source>
        <translation>过程说明</translation>
    </message>
    <message>
        <source>Working: the motor turns</source>
        <translation>进行中：电机转动</translation>
    </message>
    <message>
        <source>STOP ends it at any moment; what was changed is put back.</source>
        <translation>STOP 可随时将其结束；更改过的值会恢复。</translation>
    </message>
    <message>
        <source>Nothing has moved yet</source>
        <translation>尚无任何运动</translation>
    </message>
    <message>
        <source>over ≤ %1 %, settle ≤ %2, error ≤ %3 %</source>
        <translation>超调 ≤ %1 %，调节 ≤ %2，误差 ≤ %3 %</translation>
    </message>
    <message>
        <source>over ≤ %1 %, error ≤ %2 %</source>
        <translation>超调 ≤ %1 %，误差 ≤ %2 %</translation>
    </message>
    <message>
        <source>over %1 %, settle %2, error %3 %</source>
        <translation>超调 %1 %，调节 %2，误差 %3 %</translation>
    </message>
    <message>
        <source>Identify the motor</source>
        <translation>辨识电机</translation>
    </message>
    <message>
        <source>Pushes with a part of the duty, both ways. No gain is changed.</source>
        <translation>以部分占空比向两个方向推动。不更改任何增益。</translation>
    </message>
    <message>
        <source>Choose a set</source>
        <translation>选择一组</translation>
    </message>
    <message>
        <source>The plots show what each would do.</source>
        <translation>曲线图显示每组的效果。</translation>
    </message>
    <message>
        <source>Write and prove it</source>
        <translation>写入并验证</translation>
    </message>
    <message>
        <source>The gains are written, steps both ways are measured.</source>
        <translation>写入增益，测量两个方向的阶跃。</translation>
    </message>
    <message>
        <source>Keep it, or put everything back</source>
        <translation>保留，或全部恢复</translation>
    </message>
    <message>
        <source>It stays if it does what was predicted; else the reason is said.</source>
        <translation>若效果与预测相符则保留；否则说明原因。</translation>
    </message>
    <message>
        <source>Write %1 to slot %2</source>
        <translation>将 %1 写入槽 %2</translation>
    </message>
    <message>
        <source>Write %1</source>
        <translation>写入 %1</translation>
    </message>
    <message>
        <source>The slot that the result is not for; what it had comes back.</source>
        <translation>非结果所属的槽；其原值会恢复。</translation>
    </message>
    <message>
        <source>What is replaced is kept, to be put back.</source>
        <translation>被替换的值会保留，以便恢复。</translation>
    </message>
    <message>
        <source>Run %1 steps of %2 %3</source>
        <translation>运行 %1 次 %2 %3 的阶跃</translation>
    </message>
    <message>
        <source>Both ways, every guard on; each is a trial.</source>
        <translation>双向，所有监护有效；每次都是一次试验。</translation>
    </message>
    <message>
        <source>Keep it in slot %1 when all hold</source>
        <translation>全部满足则保留在槽 %1</translation>
    </message>
    <message>
        <source>Keep it when all hold</source>
        <translation>全部满足则保留</translation>
    </message>
    <message>
        <source>measured: %1</source>
        <translation>实测：%1</translation>
    </message>
    <message>
        <source>Else put everything back</source>
        <translation>否则全部恢复</translation>
    </message>
    <message>
        <source>Gains as before, the reason in the log.</source>
        <translation>增益如前，原因见日志。</translation>
    </message>
    <message>
        <source>motor turns %1 s</source>
        <translation>电机转动 %1 s</translation>
    </message>
    <message>
        <source>Identify and Autotune push first: %1</source>
        <translation>辨识和自整定会先推动电机：%1</translation>
    </message>
    <message>
        <source>Not kept</source>
        <translation>未保留</translation>
    </message>
    <message>
        <source>Find the gains anew</source>
        <translation>重新求取增益</translation>
    </message>
    <message>
        <source>Those that are shown were found for other limits, or elsewhere.</source>
        <translation>所示增益是在其他限值下或在其他位置求得的。</translation>
    </message>
</context>
<context>
    <name>mb::UnitChecks</name>
    <message>
        <source>no unit answers yet</source>
        <translation>尚无设备应答</translation>
    </message>
    <message numerus="yes">
        <source>%n units answer, one at a time</source>
        <translation>
            <numerusform>%n 台应答，逐台处理</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 may turn</source>
        <translation>%1 可能在转动</translation>
    </message>
    <message>
        <source>no motor turns</source>
        <translation>无电机转动</translation>
    </message>
    <message>
        <source>no link is open</source>
        <translation>没有打开的链路</translation>
    </message>
    <message>
        <source>%1 is open</source>
        <translation>%1 已打开</translation>
    </message>
    <message>
        <source>the journal takes entries</source>
        <translation>日志可写入</translation>
    </message>
    <message>
        <source>the journal keeps entries on this computer</source>
        <translation>日志条目暂存于本机</translation>
    </message>
    <message>
        <source>Before each unit</source>
        <translation>每台之前</translation>
    </message>
    <message>
        <source>%1 is not open</source>
        <translation>%1 未打开</translation>
    </message>
</context>
<context>
    <name>mb::UnitList</name>
    <message>
        <source>Last ten units, newest first</source>
        <translation>最近十台设备，最新在前</translation>
    </message>
</context>
<context>
    <name>mb::UnitStates</name>
    <message>
        <source>Device, now</source>
        <translation>设备，当前</translation>
    </message>
    <message>
        <source>factory defaults</source>
        <translation>出厂默认值</translation>
    </message>
    <message>
        <source>live</source>
        <translation>实时</translation>
    </message>
    <message numerus="yes">
        <source>%n values</source>
        <translation>
            <numerusform>%n 个值</numerusform>
        </translation>
    </message>
    <message>
        <source>by hand, %1</source>
        <translation>手动，%1</translation>
    </message>
    <message>
        <source>automatic, %1</source>
        <translation>自动，%1</translation>
    </message>
    <message>
        <source>from the device description</source>
        <translation>来自设备描述</translation>
    </message>
</context>
<context>
    <name>mb::UnitSteps</name>
    <message>
        <source>Steps of this unit</source>
        <translation>此设备的步骤</translation>
    </message>
    <message>
        <source>Skip this unit</source>
        <translation>跳过此设备</translation>
    </message>
    <message>
        <source>Do it again</source>
        <translation>再做一次</translation>
    </message>
    <message>
        <source>No unit selected</source>
        <translation>未选择设备</translation>
    </message>
</context>
<context>
    <name>mb::UnitUpdate</name>
    <message>
        <source>Verified: %1</source>
        <translation>已校验：%1</translation>
    </message>
    <message>
        <source>Not needed: %1</source>
        <translation>无需更新：%1</translation>
    </message>
    <message>
        <source>Refused: %1</source>
        <translation>已拒绝：%1</translation>
    </message>
    <message>
        <source>Failed: %1</source>
        <translation>失败：%1</translation>
    </message>
    <message>
        <source>Cancelled. %1.</source>
        <translation>已取消。%1。</translation>
    </message>
    <message>
        <source>device</source>
        <translation>设备</translation>
    </message>
    <message>
        <source>firmware</source>
        <translation>固件</translation>
    </message>
    <message>
        <source>image</source>
        <translation>映像</translation>
    </message>
    <message>
        <source>Open image…</source>
        <translation>打开映像…</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>步骤</translation>
    </message>
    <message>
        <source>Progress of the update</source>
        <translation>更新进度</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Update</source>
        <translation>更新</translation>
    </message>
    <message>
        <source>Run the update again</source>
        <translation>再次运行更新</translation>
    </message>
    <message>
        <source>One update a bus: %1 is being written.</source>
        <translation>每条总线一次只能更新一台：正在写入 %1。</translation>
    </message>
    <message>
        <source>no device selected</source>
        <translation>未选择设备</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>%1 → %2</source>
        <translation>%1 → %2</translation>
    </message>
    <message>
        <source>image fits this family</source>
        <translation>映像适合此系列</translation>
    </message>
    <message>
        <source>no usable image</source>
        <translation>没有可用的映像</translation>
    </message>
    <message>
        <source>motor is moving</source>
        <translation>电机正在运动</translation>
    </message>
    <message>
        <source>motor stopped</source>
        <translation>电机已停止</translation>
    </message>
    <message>
        <source>no other master, number unique</source>
        <translation>无其他主站，编号唯一</translation>
    </message>
    <message>
        <source>another master, or a number taken twice</source>
        <translation>有其他主站，或编号重复</translation>
    </message>
    <message>
        <source>no device</source>
        <translation>无设备</translation>
    </message>
    <message>
        <source>%1 s a page, about %2 s left</source>
        <translation>每页 %1 s，剩余约 %2 s</translation>
    </message>
    <message>
        <source>Nothing running</source>
        <translation>没有任务在运行</translation>
    </message>
    <message>
        <source>%1, %2 of %3 written</source>
        <translation>%1，已写入 %2 / %3</translation>
    </message>
    <message>
        <source>%1 s, pages sent again: %2</source>
        <translation>%1 s，重发的页：%2</translation>
    </message>
    <message>
        <source>Open a firmware image</source>
        <translation>打开固件映像</translation>
    </message>
    <message>
        <source>Intel HEX (*.hex *.ihex);;All files (*)</source>
        <translation>Intel HEX (*.hex *.ihex);;所有文件 (*)</translation>
    </message>
    <message>
        <source>motor not known</source>
        <translation>电机未知</translation>
    </message>
    <message>
        <source>Cancelled: %1</source>
        <translation>已取消：%1</translation>
    </message>
    <message>
        <source>Cancelled: nothing was written.</source>
        <translation>已取消：未写入任何内容。</translation>
    </message>
    <message>
        <source>%1, as in the image</source>
        <translation>%1，与映像相同</translation>
    </message>
    <message>
        <source>Written, not proved: %1</source>
        <translation>已写入，未证实：%1</translation>
    </message>
    <message>
        <source>%1 has changed since it was opened and is read again; start the update once more</source>
        <translation>%1 在打开后已更改，现已重新读取；请再次开始更新</translation>
    </message>
    <message>
        <source>Before start</source>
        <translation>开始之前</translation>
    </message>
    <message>
        <source>Units are served on this link.</source>
        <translation>此链路上正在处理设备。</translation>
    </message>
</context>
<context>
    <name>mb::UpdateLog</name>
    <message>
        <source>Log</source>
        <translation>日志</translation>
    </message>
    <message>
        <source>Save log…</source>
        <translation>保存日志…</translation>
    </message>
    <message>
        <source>Log of the update</source>
        <translation>更新日志</translation>
    </message>
    <message>
        <source>Save the log of the update</source>
        <translation>保存更新日志</translation>
    </message>
    <message>
        <source>Text (*.log *.txt)</source>
        <translation>文本 (*.log *.txt)</translation>
    </message>
</context>
<context>
    <name>mb::UpdateSide</name>
    <message>
        <source>Flash pages</source>
        <translation>闪存页</translation>
    </message>
    <message>
        <source>In the order they are written. Green: written. Amber edge: sent again. Dashed: not in the image. Red: must not be cut.</source>
        <translation>按写入顺序排列。绿色：已写入。琥珀色边框：已重发。虚线：不在映像中。红色：不得中断。</translation>
    </message>
    <message>
        <source>Do not unplug</source>
        <translation>请勿拔出</translation>
    </message>
    <message>
        <source>Safe to unplug</source>
        <translation>可以拔出</translation>
    </message>
    <message>
        <source>Nothing is written now</source>
        <translation>当前没有写入</translation>
    </message>
    <message>
        <source>The motor turns as soon as Arm in the header is held.</source>
        <translation>按住标题栏中的“解锁”后，电机立即转动。</translation>
    </message>
    <message>
        <source>The self-test turns the motor.</source>
        <translation>自检会转动电机。</translation>
    </message>
</context>
<context>
    <name>mb::VerdictView</name>
    <message>
        <source>READY</source>
        <translation>就绪</translation>
    </message>
    <message>
        <source>WORKING</source>
        <translation>进行中</translation>
    </message>
    <message>
        <source>PASS</source>
        <translation>合格</translation>
    </message>
    <message>
        <source>FAIL</source>
        <translation>不合格</translation>
    </message>
    <message>
        <source>REFUSED</source>
        <translation>已拒绝</translation>
    </message>
    <message>
        <source>LEFT OUT</source>
        <translation>已跳过</translation>
    </message>
</context>
<context>
    <name>mb::Welcome</name>
    <message>
        <source>Folder with firmware</source>
        <translation>固件文件夹</translation>
    </message>
</context>
<context>
    <name>mb::WindowKeys</name>
    <message>
        <source>shows these keys; once more, the help for this page</source>
        <translation>显示这些按键；再按一次显示此页面的帮助</translation>
    </message>
    <message>
        <source>production: unit after unit, full screen; and back</source>
        <translation>生产：逐台处理设备，全屏；以及返回</translation>
    </message>
    <message>
        <source>shows page %1</source>
        <translation>显示页面“%1”</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>窗口</translation>
    </message>
    <message>
        <source>Menu</source>
        <translation>菜单</translation>
    </message>
    <message>
        <source>renames the selected device; in production: goes to the serial number</source>
        <translation>重命名所选设备；在生产模式下：转到序列号</translation>
    </message>
    <message>
        <source>stores what the selected device has in RAM only</source>
        <translation>存储所选设备仅在 RAM 中的值</translation>
    </message>
    <message>
        <source>takes a snapshot of the selected device</source>
        <translation>为所选设备建立快照</translation>
    </message>
</context>
<context>
    <name>mb::WindowMenu</name>
    <message>
        <source>Add link…</source>
        <translation>添加链路…</translation>
    </message>
    <message>
        <source>Open recording…</source>
        <translation>打开记录…</translation>
    </message>
    <message>
        <source>Open the simulated bench</source>
        <translation>打开仿真台架</translation>
    </message>
    <message>
        <source>Open the folder of a machine…</source>
        <translation>打开整机的文件夹…</translation>
    </message>
    <message>
        <source>Save the machine into a folder…</source>
        <translation>将整机保存到文件夹…</translation>
    </message>
    <message>
        <source>Commands…</source>
        <translation>命令…</translation>
    </message>
    <message>
        <source>Switch between dark and light</source>
        <translation>在深色与浅色之间切换</translation>
    </message>
    <message>
        <source>Preferences…</source>
        <translation>首选项…</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>帮助</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>按键</translation>
    </message>
    <message>
        <source>About MotorBench</source>
        <translation>关于 MotorBench</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>退出</translation>
    </message>
    <message>
        <source>Open a recording</source>
        <translation>打开记录</translation>
    </message>
    <message>
        <source>All recordings (*.log *.asc *.txt *.mcap *.csv)</source>
        <translation>所有记录 (*.log *.asc *.txt *.mcap *.csv)</translation>
    </message>
    <message>
        <source>Frames: candump and Vector ASC logs (*.log *.asc *.txt)</source>
        <translation>帧：candump 和 Vector ASC 日志 (*.log *.asc *.txt)</translation>
    </message>
    <message>
        <source>Samples: MCAP, CSV (*.mcap *.csv)</source>
        <translation>采样：MCAP、CSV (*.mcap *.csv)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>所有文件 (*)</translation>
    </message>
    <message>
        <source>lists everything that can be done, by name</source>
        <translation>按名称列出所有可执行的操作</translation>
    </message>
    <message>
        <source>shows the preferences</source>
        <translation>显示首选项</translation>
    </message>
    <message>
        <source>switches between dark and light</source>
        <translation>在深色与浅色之间切换</translation>
    </message>
    <message>
        <source>opens a recording</source>
        <translation>打开记录</translation>
    </message>
    <message>
        <source>quits</source>
        <translation>退出</translation>
    </message>
</context>
<context>
    <name>table</name>
    <message>
        <source>Position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Velocity</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Current</source>
        <translation>电流</translation>
    </message>
    <message>
        <source>Duty</source>
        <translation>占空比</translation>
    </message>
    <message>
        <source>Set-point</source>
        <translation>设定值</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>温度</translation>
    </message>
    <message>
        <source>F: the firmware&apos;s codes</source>
        <translation>F：固件的代码</translation>
    </message>
    <message>
        <source>A unit that speaks the document&apos;s codes would take position for current and current for position.</source>
        <translation>使用文档代码的设备会把位置当作电流，把电流当作位置。</translation>
    </message>
    <message>
        <source>L: legacy frames of 8 bytes</source>
        <translation>L：8 字节的旧式帧</translation>
    </message>
    <message>
        <source>A unit with today&apos;s firmware ignores these frames, the stop excepted, which is sent both ways.</source>
        <translation>使用当前固件的设备会忽略这些帧，停止除外，停止以两种方式发送。</translation>
    </message>
    <message>
        <source>LL: older, cannot be stopped</source>
        <translation>LL：更旧，无法停止</translation>
    </message>
    <message>
        <source>It is only watched: there is no code that stops it.</source>
        <translation>仅可监视：没有能停止它的代码。</translation>
    </message>
    <message>
        <source>D: the document&apos;s codes</source>
        <translation>D：文档的代码</translation>
    </message>
    <message>
        <source>A unit that speaks the firmware&apos;s codes runs at full power when it is told a position, and loses its divisor when D is written.</source>
        <translation>使用固件代码的设备在收到位置命令时会全功率运行，并在写入 D 时丢失其除数。</translation>
    </message>
    <message>
        <source>Counts per revolution</source>
        <translation>每转计数</translation>
    </message>
    <message>
        <source>Encoder edges in one turn: four times its lines.</source>
        <translation>一转中的编码器边沿数：线数的四倍。</translation>
    </message>
    <message>
        <source>Ampere per count</source>
        <translation>每计数安培</translation>
    </message>
    <message>
        <source>What one count of the current converter stands for; it depends on the board.</source>
        <translation>电流转换器一个计数代表的值；取决于板卡。</translation>
    </message>
    <message>
        <source>Degrees per count</source>
        <translation>每计数度数</translation>
    </message>
    <message>
        <source>What one count of the temperature converter stands for; it depends on the board.</source>
        <translation>温度转换器一个计数代表的值；取决于板卡。</translation>
    </message>
    <message>
        <source>Nothing is written yet; the update can be run again</source>
        <translation>尚未写入任何内容；可以再次运行更新</translation>
    </message>
    <message>
        <source>The flash is being written: it must not be cut</source>
        <translation>正在写入闪存：不得中断</translation>
    </message>
    <message>
        <source>A unit that is cut while it is written holds half a program. It runs again once an update has succeeded.</source>
        <translation>写入期间被中断的设备只含半个程序。更新成功后即可重新运行。</translation>
    </message>
    <message>
        <source>output saturated</source>
        <translation>输出饱和</translation>
    </message>
    <message>
        <source>output wrapped around</source>
        <translation>输出翻转</translation>
    </message>
    <message>
        <source>count/s</source>
        <translation>count/s</translation>
    </message>
    <message>
        <source>ADC count</source>
        <translation>ADC count</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>OpenOCD finds no debug probe</source>
        <translation>OpenOCD 找不到调试探针</translation>
    </message>
    <message>
        <source>plug it in, and check that its kind is the one named after openocd:</source>
        <translation>将其插入，并检查其类型是否与 openocd: 之后指定的一致</translation>
    </message>
    <message>
        <source>OpenOCD has no interface of this name</source>
        <translation>OpenOCD 没有此名称的接口</translation>
    </message>
    <message>
        <source>name one of its interface files, such as openocd:stlink</source>
        <translation>指定其接口文件之一，例如 openocd:stlink</translation>
    </message>
    <message>
        <source>this interface does not speak SWD</source>
        <translation>此接口不支持 SWD</translation>
    </message>
    <message>
        <source>name a debug probe that does, such as openocd:stlink</source>
        <translation>指定支持 SWD 的调试探针，例如 openocd:stlink</translation>
    </message>
    <message>
        <source>the microcontroller does not hold what was written</source>
        <translation>微控制器中的内容与写入的不符</translation>
    </message>
    <message>
        <source>run it again with shorter wires or a lower speed</source>
        <translation>用更短的导线或更低的速度再次运行</translation>
    </message>
    <message>
        <source>the microcontroller refused to be written</source>
        <translation>微控制器拒绝写入</translation>
    </message>
    <message>
        <source>it may be protected, or be another kind than --target says</source>
        <translation>它可能受保护，或与 --target 指定的类型不同</translation>
    </message>
    <message>
        <source>the microcontroller is another kind than --target says</source>
        <translation>微控制器与 --target 指定的类型不同</translation>
    </message>
    <message>
        <source>choose the other one of f1 and f4</source>
        <translation>在 f1 和 f4 中选择另一个</translation>
    </message>
    <message>
        <source>the probe is there, but no microcontroller answers it</source>
        <translation>调试探针存在，但没有微控制器应答</translation>
    </message>
    <message>
        <source>check SWDIO, SWCLK, ground and the power of the drive</source>
        <translation>检查 SWDIO、SWCLK、地线和驱动器的电源</translation>
    </message>
    <message>
        <source>the microcontroller could not be halted</source>
        <translation>无法使微控制器暂停</translation>
    </message>
    <message>
        <source>check the reset wire and the power of the drive</source>
        <translation>检查复位线和驱动器的电源</translation>
    </message>
    <message>
        <source>the debug probe is there but may not be opened</source>
        <translation>调试探针存在，但不允许打开</translation>
    </message>
    <message>
        <source>install OpenOCD&apos;s udev rules or ask your administrator</source>
        <translation>安装 OpenOCD 的 udev 规则，或询问您的管理员</translation>
    </message>
    <message>
        <source>Velocity loop</source>
        <translation>速度环</translation>
    </message>
    <message>
        <source>Current loop</source>
        <translation>电流环</translation>
    </message>
    <message>
        <source>Position loop</source>
        <translation>位置环</translation>
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
        <translation>除数</translation>
    </message>
    <message>
        <source>Output (255 = 100 %) per unit of error, times the divisor. Above 32767 the output wraps to full reverse: the program keeps set-points close enough to the motor for that.</source>
        <translation>每单位误差的输出（255 = 100 %），乘以除数。超过 32767 时输出会翻转为全反向：程序为此使设定值与电机保持足够接近。</translation>
    </message>
    <message>
        <source>Output per unit of error and millisecond, times the divisor. Each step of 20 ms is cut to a whole number, so small gains do nothing, and nothing limits the sum.</source>
        <translation>每单位误差、每毫秒的输出，乘以除数。每个 20 ms 步都截断为整数，因此小增益不起作用，且总和没有任何限制。</translation>
    </message>
    <message>
        <source>Output times milliseconds per change of error, times the divisor. Its sign is inverted in the drive: only negative numbers damp.</source>
        <translation>误差每变化一单位的输出乘毫秒，再乘以除数。其符号在驱动器中取反：只有负数才有阻尼作用。</translation>
    </message>
    <message>
        <source>Averaging</source>
        <translation>平均</translation>
    </message>
    <message>
        <source>Loop error</source>
        <translation>回路误差</translation>
    </message>
    <message>
        <source>Supply</source>
        <translation>电源</translation>
    </message>
    <message>
        <source>Analog input</source>
        <translation>模拟输入</translation>
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
        <translation>周期</translation>
    </message>
    <message>
        <source>over-current</source>
        <translation>过流</translation>
    </message>
    <message>
        <source>over-temperature</source>
        <translation>过温</translation>
    </message>
    <message>
        <source>under-voltage</source>
        <translation>欠压</translation>
    </message>
    <message>
        <source>gate driver</source>
        <translation>栅极驱动器</translation>
    </message>
    <message>
        <source>communication</source>
        <translation>通信</translation>
    </message>
    <message>
        <source>The unit then waits in its bootloader; the update can be run again</source>
        <translation>之后设备在其引导程序中等待；可以再次运行更新</translation>
    </message>
    <message>
        <source>Page 0 is being written: it must not be cut</source>
        <translation>正在写入第 0 页：不得中断</translation>
    </message>
    <message>
        <source>A unit that is cut stays in its bootloader and can be updated again. Only page 0, the last, must not be interrupted.</source>
        <translation>被中断的设备停留在其引导程序中，可以再次更新。只有最后写入的第 0 页不得中断。</translation>
    </message>
    <message>
        <source>Page 0 holds the reset vector. A cut now cannot be repaired over the bus.</source>
        <translation>第 0 页含有复位向量。此时中断将无法通过总线修复。</translation>
    </message>
    <message>
        <source>Limit switches</source>
        <translation>限位开关</translation>
    </message>
    <message>
        <source>Soft limits</source>
        <translation>软限位</translation>
    </message>
    <message>
        <source>Loop, slot 0</source>
        <translation>回路，槽 0</translation>
    </message>
    <message>
        <source>Loop, slot 1</source>
        <translation>回路，槽 1</translation>
    </message>
    <message>
        <source>Current limiter</source>
        <translation>电流限制器</translation>
    </message>
    <message>
        <source>Encoder</source>
        <translation>编码器</translation>
    </message>
    <message>
        <source>Faults</source>
        <translation>故障</translation>
    </message>
    <message>
        <source>Current limit</source>
        <translation>电流限制</translation>
    </message>
    <message>
        <source>Status frames</source>
        <translation>状态帧</translation>
    </message>
    <message>
        <source>Normally closed is hit when the switch opens, normally open when it closes. A hit blocks output in this direction.</source>
        <translation>常闭型在开关断开时触发，常开型在闭合时触发。触发后禁止此方向的输出。</translation>
    </message>
    <message>
        <source>On switches the limit OFF: the sense is the opposite of the soft limits&apos; Enabled.</source>
        <translation>“开”表示关闭限位：含义与软限位的“启用”相反。</translation>
    </message>
    <message>
        <source>Output (32767 = 100 %) per unit of error: counts/100 ms, counts or A, depending on the mode.</source>
        <translation>每单位误差的输出（32767 = 100 %）：误差单位视模式为 counts/100 ms、counts 或 A。</translation>
    </message>
    <message>
        <source>Output per unit of error and loop of 500 µs. With F·K = 1 any I overshoots.</source>
        <translation>每单位误差、每 500 µs 回路周期的输出。F·K = 1 时任何 I 都会超调。</translation>
    </message>
    <message>
        <source>Output per change of error in one loop of 500 µs. One count of noise makes a spike of D.</source>
        <translation>一个 500 µs 回路周期内误差每变化一单位的输出。一个计数的噪声会产生大小为 D 的尖峰。</translation>
    </message>
    <message>
        <source>Bound of the integral accumulator, raw integer. 0 means unlimited, not zero.</source>
        <translation>积分累加器的界限，原始整数。0 表示不限，而非零。</translation>
    </message>
    <message>
        <source>Output per unit of set-point, added to P, I and D.</source>
        <translation>每单位设定值的输出，与 P、I 和 D 相加。</translation>
    </message>
    <message>
        <source>Below it P, I and D contribute nothing and the integral is cleared; F still applies. 0 switches the feature off.</source>
        <translation>低于此值时 P、I 和 D 不起作用，积分被清除；F 仍有效。0 关闭此功能。</translation>
    </message>
    <message>
        <source>Greatest change of output in a loop of 500 µs; 16 takes 1.024 s from 0 to 100 %. Lower is slower, but 0 is no ramp.</source>
        <translation>每 500 µs 回路周期的最大输出变化；16 表示从 0 到 100 % 需 1.024 s。越小越慢，但 0 表示无斜坡。</translation>
    </message>
    <message>
        <source>Greatest forward output, 32767 = 100 %.</source>
        <translation>最大正向输出，32767 = 100 %。</translation>
    </message>
    <message>
        <source>Greatest reverse output, −32768 = −100 %. A number at or below 0.</source>
        <translation>最大反向输出，−32768 = −100 %。为 0 或负数。</translation>
    </message>
    <message>
        <source>Least forward output outside the allowable error; overcomes friction. Closed-loop modes only.</source>
        <translation>允许误差之外的最小正向输出；用于克服摩擦。仅闭环模式。</translation>
    </message>
    <message>
        <source>Least reverse output outside the allowable error, a number at or below 0. Closed-loop modes only.</source>
        <translation>允许误差之外的最小反向输出，为 0 或负数。仅闭环模式。</translation>
    </message>
    <message>
        <source>Keeps clearing as long as the switch is active, even if its limit is disabled. Lost at power-off.</source>
        <translation>只要开关动作就持续清零，即使其限位已禁用。断电后丢失。</translation>
    </message>
    <message>
        <source>Writing anything but 0 reads the count and clears it.</source>
        <translation>写入非 0 值会读取计数并将其清除。</translation>
    </message>
    <message>
        <source>Forward switch is normally closed</source>
        <translation>正向开关为常闭</translation>
    </message>
    <message>
        <source>Forward switch disabled</source>
        <translation>正向开关禁用</translation>
    </message>
    <message>
        <source>Reverse switch is normally closed</source>
        <translation>反向开关为常闭</translation>
    </message>
    <message>
        <source>Reverse switch disabled</source>
        <translation>反向开关禁用</translation>
    </message>
    <message>
        <source>Forward soft limit</source>
        <translation>正向软限位</translation>
    </message>
    <message>
        <source>At or above this position forward output is blocked, if enabled.</source>
        <translation>启用后，达到或高于此位置时禁止正向输出。</translation>
    </message>
    <message>
        <source>Forward soft limit enabled</source>
        <translation>正向软限位启用</translation>
    </message>
    <message>
        <source>On switches the limit ON: the sense is the opposite of the switches&apos; Disabled.</source>
        <translation>“开”表示打开限位：含义与开关的“禁用”相反。</translation>
    </message>
    <message>
        <source>Reverse soft limit</source>
        <translation>反向软限位</translation>
    </message>
    <message>
        <source>At or below this position reverse output is blocked, if enabled.</source>
        <translation>启用后，达到或低于此位置时禁止反向输出。</translation>
    </message>
    <message>
        <source>Reverse soft limit enabled</source>
        <translation>反向软限位启用</translation>
    </message>
    <message>
        <source>Current scale</source>
        <translation>电流比例</translation>
    </message>
    <message>
        <source>Calibrated at the factory. All current limiting depends on it: change it only to trim the reading.</source>
        <translation>出厂时已校准。所有电流限制都取决于它：仅可用于微调读数。</translation>
    </message>
    <message>
        <source>I zone</source>
        <translation>I 区</translation>
    </message>
    <message>
        <source>Allowable error</source>
        <translation>允许误差</translation>
    </message>
    <message>
        <source>Ramp</source>
        <translation>斜坡</translation>
    </message>
    <message>
        <source>Maximum forward</source>
        <translation>正向最大值</translation>
    </message>
    <message>
        <source>Maximum reverse</source>
        <translation>反向最大值</translation>
    </message>
    <message>
        <source>Nominal forward</source>
        <translation>正向标称值</translation>
    </message>
    <message>
        <source>Nominal reverse</source>
        <translation>反向标称值</translation>
    </message>
    <message>
        <source>The factory value suits most motors.</source>
        <translation>出厂值适合大多数电机。</translation>
    </message>
    <message>
        <source>The live count. Written only while the output is off.</source>
        <translation>实时计数。仅在输出关闭时写入。</translation>
    </message>
    <message>
        <source>Index clears position</source>
        <translation>索引清零位置</translation>
    </message>
    <message>
        <source>At the index edge chosen below. Lost at power-off.</source>
        <translation>在下面选定的索引边沿处。断电后丢失。</translation>
    </message>
    <message>
        <source>Forward switch clears position</source>
        <translation>正向开关清零位置</translation>
    </message>
    <message>
        <source>Reverse switch clears position</source>
        <translation>反向开关清零位置</translation>
    </message>
    <message>
        <source>Index acts on its rising edge</source>
        <translation>索引上升沿有效</translation>
    </message>
    <message>
        <source>Off is the falling edge. Lost at power-off.</source>
        <translation>“关”为下降沿。断电后丢失。</translation>
    </message>
    <message>
        <source>Present faults</source>
        <translation>当前故障</translation>
    </message>
    <message>
        <source>1 over-current, 2 over-temperature, 4 under-voltage, 8 gate driver, 16 communication.</source>
        <translation>1 过流，2 过温，4 欠压，8 栅极驱动器，16 通信。</translation>
    </message>
    <message>
        <source>Faults since the last clear</source>
        <translation>上次清除以来的故障</translation>
    </message>
    <message>
        <source>The bits of the present faults. Writing anything but 0 reads them and clears them.</source>
        <translation>当前故障的各位。写入非 0 值会读取并清除它们。</translation>
    </message>
    <message>
        <source>Over-current count</source>
        <translation>过流计数</translation>
    </message>
    <message>
        <source>Over-temperature count</source>
        <translation>过温计数</translation>
    </message>
    <message>
        <source>Under-voltage count</source>
        <translation>欠压计数</translation>
    </message>
    <message>
        <source>Supply below 5.75 V for 5 s. Writing anything but 0 reads the count and clears it.</source>
        <translation>电源低于 5.75 V 达 5 s。写入非 0 值会读取计数并将其清除。</translation>
    </message>
    <message>
        <source>Gate driver count</source>
        <translation>栅极驱动器计数</translation>
    </message>
    <message>
        <source>Usually a short between M+ and M−. Writing anything but 0 reads the count and clears it.</source>
        <translation>通常是 M+ 与 M− 之间短路。写入非 0 值会读取计数并将其清除。</translation>
    </message>
    <message>
        <source>Communication loss count</source>
        <translation>通信丢失计数</translation>
    </message>
    <message>
        <source>Since the last power-up. Writing anything but 0 reads the count and clears it.</source>
        <translation>自上次上电以来。写入非 0 值会读取计数并将其清除。</translation>
    </message>
    <message>
        <source>Continuous limit</source>
        <translation>持续限值</translation>
    </message>
    <message>
        <source>At or above the peak limit, limiting starts as soon as this is exceeded.</source>
        <translation>若不低于峰值限值，则一超过此值即开始限制。</translation>
    </message>
    <message>
        <source>Peak limit</source>
        <translation>峰值限值</translation>
    </message>
    <message>
        <source>Above it for the peak duration, the current is brought down to the continuous limit.</source>
        <translation>超过此值达峰值持续时间后，电流降至持续限值。</translation>
    </message>
    <message>
        <source>Peak duration</source>
        <translation>峰值持续时间</translation>
    </message>
    <message>
        <source>Time above the peak limit before limiting starts; 0 limits at once.</source>
        <translation>开始限制之前超过峰值限值的时间；0 表示立即限制。</translation>
    </message>
    <message>
        <source>Current limit enabled</source>
        <translation>电流限制启用</translation>
    </message>
    <message>
        <source>Off is the factory setting: nothing limits the current.</source>
        <translation>出厂设置为“关”：电流没有任何限制。</translation>
    </message>
    <message>
        <source>Analog period</source>
        <translation>模拟量周期</translation>
    </message>
    <message>
        <source>Milliseconds between frames, although the vendor calls it a rate. Back to 100 at every restart.</source>
        <translation>帧之间的毫秒数，尽管厂商称之为频率。每次重新启动后恢复为 100。</translation>
    </message>
    <message>
        <source>Encoder period</source>
        <translation>编码器周期</translation>
    </message>
    <message>
        <source>General period</source>
        <translation>常规周期</translation>
    </message>
    <message>
        <source>Milliseconds between frames. At most 50, because followers stop after 104 ms without one.</source>
        <translation>帧之间的毫秒数。最大 50，因为跟随设备在 104 ms 收不到帧时会停止。</translation>
    </message>
    <message>
        <source>current is limited</source>
        <translation>电流受限</translation>
    </message>
    <message>
        <source>Forward limit switch</source>
        <translation>正向限位开关</translation>
    </message>
    <message>
        <source>forward limit switch holds</source>
        <translation>正向限位开关起作用</translation>
    </message>
    <message>
        <source>Reverse limit switch</source>
        <translation>反向限位开关</translation>
    </message>
    <message>
        <source>reverse limit switch holds</source>
        <translation>反向限位开关起作用</translation>
    </message>
    <message>
        <source>forward soft limit holds</source>
        <translation>正向软限位起作用</translation>
    </message>
    <message>
        <source>reverse soft limit holds</source>
        <translation>反向软限位起作用</translation>
    </message>
    <message>
        <source>Limit override</source>
        <translation>限位覆盖</translation>
    </message>
    <message>
        <source>the set-point decides which limit switches count</source>
        <translation>由设定值决定哪些限位开关有效</translation>
    </message>
    <message>
        <source>Halt</source>
        <translation>停住</translation>
    </message>
    <message>
        <source>halted</source>
        <translation>已停住</translation>
    </message>
    <message>
        <source>Pin of the forward limit switch</source>
        <translation>正向限位开关的引脚</translation>
    </message>
    <message>
        <source>Pin of the reverse limit switch</source>
        <translation>反向限位开关的引脚</translation>
    </message>
    <message>
        <source>Encoder pin A</source>
        <translation>编码器引脚 A</translation>
    </message>
    <message>
        <source>Encoder pin B</source>
        <translation>编码器引脚 B</translation>
    </message>
    <message>
        <source>Encoder index pin</source>
        <translation>编码器索引引脚</translation>
    </message>
    <message>
        <source>baud rate</source>
        <translation>波特率</translation>
    </message>
    <message>
        <source>From the data sheet.</source>
        <translation>取自数据手册。</translation>
    </message>
    <message>
        <source>format</source>
        <translation>格式</translation>
    </message>
    <message>
        <source>Data bits, parity, stop bits. Not told.</source>
        <translation>数据位、校验、停止位。未说明。</translation>
    </message>
    <message>
        <source>line ending</source>
        <translation>行结束符</translation>
    </message>
    <message>
        <source>Not told; the terminal program that the data sheet names sends cr.</source>
        <translation>未说明；数据手册提到的终端程序发送 cr。</translation>
    </message>
    <message>
        <source>greeting holds</source>
        <translation>问候包含</translation>
    </message>
    <message>
        <source>The data sheet tells this word, and not the whole greeting.</source>
        <translation>数据手册给出此词，但未给出完整的问候。</translation>
    </message>
    <message>
        <source>refusal holds</source>
        <translation>拒绝包含</translation>
    </message>
    <message>
        <source>Not told. Words with | between them, in whatever case.</source>
        <translation>未说明。以 | 分隔的词，不区分大小写。</translation>
    </message>
    <message>
        <source>pause</source>
        <translation>停顿</translation>
    </message>
    <message>
        <source>Least time from one line to the next in milliseconds, from the data sheet.</source>
        <translation>行与行之间的最短时间，单位毫秒，取自数据手册。</translation>
    </message>
    <message>
        <source>leaves with</source>
        <translation>退出方式</translation>
    </message>
    <message>
        <source>Typed at the end. &quot;none&quot; leaves it to jumper and reset.</source>
        <translation>在末尾键入。“none”表示交由跳线和复位处理。</translation>
    </message>
    <message>
        <source>counts/s (safe)</source>
        <translation>counts/s（安全）</translation>
    </message>
    <message>
        <source>counts/s × 4096</source>
        <translation>counts/s × 4096</translation>
    </message>
    <message>
        <source>as the library</source>
        <translation>按库</translation>
    </message>
    <message>
        <source>as the data sheet</source>
        <translation>按数据手册</translation>
    </message>
    <message>
        <source>The data sheet contradicts itself on velocity targets. With plain counts/s a board that wants × 4096 hardly moves; the opposite mistake asks for full speed. Change it only when a board hardly moves, and with a small power limit.</source>
        <translation>数据手册对速度目标的说明自相矛盾。用普通的 counts/s 时，需要 × 4096 的板卡几乎不动；相反的错误则会要求全速。仅当板卡几乎不动时才更改，并使用较小的功率限值。</translation>
    </message>
    <message>
        <source>Data sheet and the maker&apos;s library give polarity and edges of the inputs opposite bits. The library is more likely right; an experiment with the status bit tells.</source>
        <translation>数据手册与制造商的库对输入的极性和边沿给出相反的位。库更可能正确；借助状态位的实验可以查明。</translation>
    </message>
    <message>
        <source>Power units (8191 is full power) that a raw gain of 1 gives. The maker does not tell; an experiment finds it.</source>
        <translation>原始增益 1 对应的功率单位（8191 为全功率）。制造商未说明；实验可以求得。</translation>
    </message>
    <message>
        <source>velocity target</source>
        <translation>速度目标</translation>
    </message>
    <message>
        <source>input polarity</source>
        <translation>输入极性</translation>
    </message>
    <message>
        <source>velocity P scale</source>
        <translation>速度 P 比例</translation>
    </message>
    <message>
        <source>velocity I scale</source>
        <translation>速度 I 比例</translation>
    </message>
    <message>
        <source>position P scale</source>
        <translation>位置 P 比例</translation>
    </message>
    <message>
        <source>position I scale</source>
        <translation>位置 I 比例</translation>
    </message>
    <message>
        <source>position D scale</source>
        <translation>位置 D 比例</translation>
    </message>
    <message>
        <source>Status bits</source>
        <translation>状态位</translation>
    </message>
    <message>
        <source>adapter, 3.3 V</source>
        <translation>适配器，3.3 V</translation>
    </message>
    <message>
        <source>Drawing: the jumper connects AUX1 and AUX2; adapter TX to board RX, RX to TX, 3.3 V, GND</source>
        <translation>图：跳线连接 AUX1 和 AUX2；适配器 TX 接板卡 RX，RX 接 TX，3.3 V，GND</translation>
    </message>
    <message>
        <source>Drawing: the jumper between AUX1 and AUX2 is taken out</source>
        <translation>图：AUX1 与 AUX2 之间的跳线已取下</translation>
    </message>
    <message>
        <source>open: nothing is connected, the pin is high</source>
        <translation>悬空：未连接任何东西，引脚为高</translation>
    </message>
    <message>
        <source>connected to GND: the pin is low</source>
        <translation>接到 GND：引脚为低</translation>
    </message>
    <message>
        <source>Find the gain scales</source>
        <translation>求取增益比例</translation>
    </message>
    <message>
        <source>The maker does not tell what a raw gain is worth. The motor of one axis is turned to and fro for one to two minutes, with the power that you allow here: first with constant power, then with one gain alone at a time, which grows until the motor moves. The shaft must turn freely, some turns each way, and nobody may touch it. Gains and limits are put back at the end.</source>
        <translation>制造商未说明原始增益的大小。一个轴的电机会以您在此允许的功率往复转动一到两分钟：先以恒定功率，然后每次仅用一个增益，并逐渐增大直到电机运动。轴必须能自由转动，每个方向数转，且任何人不得触碰。结束时恢复增益和限值。</translation>
    </message>
    <message>
        <source>Find the input polarity</source>
        <translation>确定输入极性</translation>
    </message>
    <message>
        <source>Data sheet and the maker&apos;s library give the polarity of the inputs opposite bits. The input of one axis is set up with both, and the status bit tells which of them is active at the level that the pin has. Nothing moves, the counter stays, and the input is set up afterwards as it was.</source>
        <translation>数据手册与制造商的库对输入的极性给出相反的位。一个轴的输入会分别按两种方式设置，状态位会表明在引脚当前电平下哪一种有效。不会有任何运动，计数器保持不变，之后输入恢复原来的设置。</translation>
    </message>
    <message>
        <source>The input pin of this axis is</source>
        <translation>此轴的输入引脚</translation>
    </message>
    <message>
        <source>encoder glitch</source>
        <translation>编码器异常</translation>
    </message>
    <message>
        <source>overspeed</source>
        <translation>超速</translation>
    </message>
    <message>
        <source>Close the jumper</source>
        <translation>插上跳线</translation>
    </message>
    <message>
        <source>Put a jumper on AUX1 and AUX2. The serial adapter has 3.3 V levels, its TX goes to RX and its RX to TX; the board gets 3.3 V only.</source>
        <translation>在 AUX1 和 AUX2 上插跳线。串口适配器为 3.3 V 电平，其 TX 接 RX，其 RX 接 TX；板卡只供 3.3 V。</translation>
    </message>
    <message>
        <source>Reset the board</source>
        <translation>复位板卡</translation>
    </message>
    <message>
        <source>Press its reset, or switch it off and on. Where the reset line is wired, this program pulses it.</source>
        <translation>按其复位键，或将其断电再上电。若已接复位线，本程序会给出复位脉冲。</translation>
    </message>
    <message>
        <source>The bootloader greets</source>
        <translation>引导程序发出问候</translation>
    </message>
    <message>
        <source>Its greeting on the serial port holds the word &quot;bootloader&quot;.</source>
        <translation>其在串口上的问候包含“bootloader”一词。</translation>
    </message>
    <message>
        <source>The file is sent</source>
        <translation>正在发送文件</translation>
    </message>
    <message>
        <source>Line by line, each after the confirmation of the one before. Leave the jumper where it is.</source>
        <translation>逐行发送，每行都在前一行得到确认之后。请保留跳线。</translation>
    </message>
    <message>
        <source>Take the jumper out</source>
        <translation>取下跳线</translation>
    </message>
    <message>
        <source>Then the board starts its new firmware. If it does not, reset it once more.</source>
        <translation>然后板卡启动其新固件。若未启动，请再次复位。</translation>
    </message>
    <message>
        <source>The version is compared</source>
        <translation>正在比较版本</translation>
    </message>
    <message>
        <source>The board is asked for it over SPI.</source>
        <translation>通过 SPI 向板卡查询。</translation>
    </message>
    <message>
        <source>A board that is cut stays in its bootloader. Leave the jumper in and run the update again.</source>
        <translation>被中断的板卡停留在其引导程序中。请保留跳线并再次运行更新。</translation>
    </message>
    <message>
        <source>Channel 1</source>
        <translation>通道 1</translation>
    </message>
    <message>
        <source>Channel 2</source>
        <translation>通道 2</translation>
    </message>
    <message>
        <source>Channel 3</source>
        <translation>通道 3</translation>
    </message>
    <message>
        <source>Channel 4</source>
        <translation>通道 4</translation>
    </message>
    <message>
        <source>Stream and velocity</source>
        <translation>数据流与速度</translation>
    </message>
    <message>
        <source>disabled</source>
        <translation>禁用</translation>
    </message>
    <message>
        <source>home switch</source>
        <translation>原点开关</translation>
    </message>
    <message>
        <source>index pulse</source>
        <translation>索引脉冲</translation>
    </message>
    <message>
        <source>both edges</source>
        <translation>双边沿</translation>
    </message>
    <message>
        <source>active high</source>
        <translation>高电平有效</translation>
    </message>
    <message>
        <source>active low</source>
        <translation>低电平有效</translation>
    </message>
    <message>
        <source>record at the positive end</source>
        <translation>在正端记录</translation>
    </message>
    <message>
        <source>set at the positive end</source>
        <translation>在正端置位</translation>
    </message>
    <message>
        <source>record at the negative end</source>
        <translation>在负端记录</translation>
    </message>
    <message>
        <source>set at the negative end</source>
        <translation>在负端置位</translation>
    </message>
    <message>
        <source>Of the position loop, in the board&apos;s own units, whose scale is not documented. Cannot be read back; the four are sent together.</source>
        <translation>位置环的参数，采用板卡自有单位，其比例未见文档说明。无法回读；四项一起发送。</translation>
    </message>
    <message>
        <source>Bound of the position loop&apos;s integral, in power units: 8191 is full power. Cannot be read back.</source>
        <translation>位置环积分的界限，采用功率单位：8191 为全功率。无法回读。</translation>
    </message>
    <message>
        <source>Of the velocity loop, in the board&apos;s own units, whose scale is not documented. Cannot be read back; the three are sent together.</source>
        <translation>速度环的参数，采用板卡自有单位，其比例未见文档说明。无法回读；三项一起发送。</translation>
    </message>
    <message>
        <source>Greatest power in every mode, 1 is full. What the board starts with is not documented: begin small. Cannot be read back.</source>
        <translation>各模式下的最大功率，1 为全功率。板卡的初始值未见文档说明：请从小值开始。无法回读。</translation>
    </message>
    <message>
        <source>Greatest speed in both closed loops. What the board starts with is not documented. Cannot be read back.</source>
        <translation>两种闭环中的最大速度。板卡的初始值未见文档说明。无法回读。</translation>
    </message>
    <message>
        <source>Greatest acceleration in both closed loops; 0 is no limit. Cannot be read back.</source>
        <translation>两种闭环中的最大加速度；0 表示无限制。无法回读。</translation>
    </message>
    <message>
        <source>What the input of the channel is for. Cannot be read back; the five values of an input are sent together.</source>
        <translation>该通道输入的用途。无法回读；一个输入的五个值一起发送。</translation>
    </message>
    <message>
        <source>At which level the input is active. Data sheet and the maker&apos;s library say it with opposite bits: which one the board follows is a setting of the device, and an experiment tells.</source>
        <translation>输入在哪种电平下有效。数据手册与制造商的库以相反的位表示：板卡遵循哪一种是设备的一项设置，可通过实验查明。</translation>
    </message>
    <message>
        <source>At which end of the switch the position is recorded, or also set as the counter. Data sheet and library disagree, as for the polarity.</source>
        <translation>在开关的哪一端记录位置，或同时置为计数器的值。数据手册与库不一致，与极性相同。</translation>
    </message>
    <message>
        <source>Distance between the two ends of the switch; 0 is a single end stop. Cannot be read back.</source>
        <translation>开关两端之间的距离；0 表示单个终端限位。无法回读。</translation>
    </message>
    <message>
        <source>What the counter becomes at the edge. Cannot be read back.</source>
        <translation>计数器在边沿处变为的值。无法回读。</translation>
    </message>
    <message>
        <source>What the board sends of this channel: bits 0 and 1 size of the position, 2 relative, 3 velocity, 5 status. The program needs the full position.</source>
        <translation>板卡发送此通道的哪些内容：位 0 和 1 为位置的长度，2 为相对，3 为速度，5 为状态。程序需要完整位置。</translation>
    </message>
    <message>
        <source>The encoder&apos;s counter. Writing it moves the zero, not the motor.</source>
        <translation>编码器的计数器。写入会移动零点，而不移动电机。</translation>
    </message>
    <message>
        <source>Of the telemetry, in units of 40.96 µs: 244 is 10 ms, 49 is 2 ms, 0 is off.</source>
        <translation>遥测的周期，单位为 40.96 µs：244 为 10 ms，49 为 2 ms，0 为关闭。</translation>
    </message>
    <message>
        <source>What a stream packet has besides: bit 0 timing, bit 1 number of skipped periods.</source>
        <translation>数据流包中另含的内容：位 0 为计时，位 1 为跳过的周期数。</translation>
    </message>
    <message>
        <source>Edges, times four, over which velocity is measured: fewer is faster and coarser. 8 is good for tuning.</source>
        <translation>测量速度所用的边沿数（乘以四）：越少越快、越粗。8 适合整定。</translation>
    </message>
    <message>
        <source>Longest time over which velocity is measured: 2 to this power, times 0.64 µs; 20 is 671 ms.</source>
        <translation>测量速度所用的最长时间：2 的此数次幂，乘以 0.64 µs；20 为 671 ms。</translation>
    </message>
    <message>
        <source>Position P</source>
        <translation>位置 P</translation>
    </message>
    <message>
        <source>Position I</source>
        <translation>位置 I</translation>
    </message>
    <message>
        <source>Position D</source>
        <translation>位置 D</translation>
    </message>
    <message>
        <source>Position windup</source>
        <translation>位置积分饱和</translation>
    </message>
    <message>
        <source>Velocity P</source>
        <translation>速度 P</translation>
    </message>
    <message>
        <source>Velocity I</source>
        <translation>速度 I</translation>
    </message>
    <message>
        <source>Velocity D</source>
        <translation>速度 D</translation>
    </message>
    <message>
        <source>Power limit</source>
        <translation>功率限值</translation>
    </message>
    <message>
        <source>Velocity limit</source>
        <translation>速度限值</translation>
    </message>
    <message>
        <source>Acceleration limit</source>
        <translation>加速度限值</translation>
    </message>
    <message>
        <source>Input mode</source>
        <translation>输入模式</translation>
    </message>
    <message>
        <source>Input polarity</source>
        <translation>输入极性</translation>
    </message>
    <message>
        <source>Input edge</source>
        <translation>输入边沿</translation>
    </message>
    <message>
        <source>Input spacing</source>
        <translation>输入间距</translation>
    </message>
    <message>
        <source>Input position</source>
        <translation>输入位置</translation>
    </message>
    <message>
        <source>Data mask</source>
        <translation>数据掩码</translation>
    </message>
    <message>
        <source>Position counter</source>
        <translation>位置计数器</translation>
    </message>
    <message>
        <source>Stream period</source>
        <translation>数据流周期</translation>
    </message>
    <message>
        <source>Stream contents</source>
        <translation>数据流内容</translation>
    </message>
    <message>
        <source>History length</source>
        <translation>历史长度</translation>
    </message>
    <message>
        <source>History time bits</source>
        <translation>历史时间位数</translation>
    </message>
    <message>
        <source>Input</source>
        <translation>输入</translation>
    </message>
    <message>
        <source>the port cannot be opened</source>
        <translation>无法打开端口</translation>
    </message>
    <message>
        <source>check its name and that it is plugged in</source>
        <translation>检查其名称以及是否已插入</translation>
    </message>
    <message>
        <source>avrdude finds no such programmer on USB</source>
        <translation>avrdude 在 USB 上找不到此编程器</translation>
    </message>
    <message>
        <source>plug it in, and check that its kind is the one named after avrdude:</source>
        <translation>将其插入，并检查其类型是否与 avrdude: 之后指定的一致</translation>
    </message>
    <message>
        <source>run it again, with a shorter cable</source>
        <translation>用更短的电缆再次运行</translation>
    </message>
    <message>
        <source>the programmer is there, but no microcontroller answers it</source>
        <translation>编程器存在，但没有微控制器应答</translation>
    </message>
    <message>
        <source>check the six pins and the supply</source>
        <translation>检查六个引脚和电源</translation>
    </message>
    <message>
        <source>avrdude knows no programmer of this name</source>
        <translation>avrdude 不认识此名称的编程器</translation>
    </message>
    <message>
        <source>&apos;avrdude -c ?&apos; lists them</source>
        <translation>“avrdude -c ?”可列出它们</translation>
    </message>
    <message>
        <source>the port may not be opened</source>
        <translation>不允许打开端口</translation>
    </message>
    <message>
        <source>add yourself to the group dialout and log in again</source>
        <translation>将自己加入 dialout 组并重新登录</translation>
    </message>
    <message>
        <source>what answers is no ATmega328P</source>
        <translation>应答的不是 ATmega328P</translation>
    </message>
    <message>
        <source>check that the programmer sits on the controller</source>
        <translation>检查编程器是否接在控制器上</translation>
    </message>
    <message>
        <source>no bootloader answers</source>
        <translation>没有引导程序应答</translation>
    </message>
    <message>
        <source>restart the controller just before the start, or use a programmer on its pins</source>
        <translation>在即将开始之前重新启动控制器，或使用接在其引脚上的编程器</translation>
    </message>
    <message>
        <source>nothing answers the programmer</source>
        <translation>编程器得不到任何应答</translation>
    </message>
    <message>
        <source>check its cable and the supply of the controller</source>
        <translation>检查其电缆和控制器的电源</translation>
    </message>
    <message>
        <source>Velocity as reported</source>
        <translation>报告的速度</translation>
    </message>
    <message>
        <source>Position in the turn</source>
        <translation>转内位置</translation>
    </message>
    <message>
        <source>Analog input 1</source>
        <translation>模拟输入 1</translation>
    </message>
    <message>
        <source>Analog input 2</source>
        <translation>模拟输入 2</translation>
    </message>
    <message>
        <source>Analog input 3</source>
        <translation>模拟输入 3</translation>
    </message>
    <message>
        <source>Analog input 4</source>
        <translation>模拟输入 4</translation>
    </message>
    <message>
        <source>Digital inputs</source>
        <translation>数字输入</translation>
    </message>
    <message>
        <source>the motor stalled</source>
        <translation>电机堵转</translation>
    </message>
    <message>
        <source>the position left its range upwards</source>
        <translation>位置向上超出其范围</translation>
    </message>
    <message>
        <source>the position left its range downwards</source>
        <translation>位置向下超出其范围</translation>
    </message>
    <message>
        <source>it has no such command</source>
        <translation>它没有此命令</translation>
    </message>
    <message>
        <source>wrong number of data bytes</source>
        <translation>数据字节数错误</translation>
    </message>
    <message>
        <source>a value that it does not take</source>
        <translation>它不接受的值</translation>
    </message>
    <message>
        <source>not possible while the motor is not started</source>
        <translation>电机未启动时无法执行</translation>
    </message>
    <message>
        <source>data bytes where none belong</source>
        <translation>不应有数据字节之处出现数据字节</translation>
    </message>
    <message>
        <source>I2C: nobody answers</source>
        <translation>I2C：无人应答</translation>
    </message>
    <message>
        <source>I2C: bus error</source>
        <translation>I2C：总线错误</translation>
    </message>
    <message>
        <source>I2C: arbitration lost</source>
        <translation>I2C：仲裁丢失</translation>
    </message>
    <message>
        <source>I2C: indeterminate state</source>
        <translation>I2C：状态不确定</translation>
    </message>
    <message>
        <source>I2C: the bus did not become ready</source>
        <translation>I2C：总线未就绪</translation>
    </message>
    <message>
        <source>I2C: sending took too long</source>
        <translation>I2C：发送超时</translation>
    </message>
    <message>
        <source>I2C: receiving took too long</source>
        <translation>I2C：接收超时</translation>
    </message>
    <message>
        <source>I2C: a packet was overwritten</source>
        <translation>I2C：数据包被覆盖</translation>
    </message>
    <message>
        <source>I2C: a packet of wrong length</source>
        <translation>I2C：数据包长度错误</translation>
    </message>
    <message>
        <source>UART: out of memory</source>
        <translation>UART：内存不足</translation>
    </message>
    <message>
        <source>UART: framing error</source>
        <translation>UART：帧格式错误</translation>
    </message>
    <message>
        <source>UART: parity error</source>
        <translation>UART：奇偶校验错误</translation>
    </message>
    <message>
        <source>UART: receive buffer overflow</source>
        <translation>UART：接收缓冲区溢出</translation>
    </message>
    <message>
        <source>UART: data overrun (the datasheet means a framing error)</source>
        <translation>UART：数据溢出（数据手册意指帧格式错误）</translation>
    </message>
    <message>
        <source>UART: sending took too long (the datasheet means a parity error)</source>
        <translation>UART：发送超时（数据手册意指奇偶校验错误）</translation>
    </message>
    <message>
        <source>UART: receive buffer overflow, by the datasheet&apos;s number</source>
        <translation>UART：接收缓冲区溢出，按数据手册的编号</translation>
    </message>
    <message>
        <source>UART: data overrun, by the datasheet&apos;s number</source>
        <translation>UART：数据溢出，按数据手册的编号</translation>
    </message>
    <message>
        <source>a frame paused for more than 50 ms</source>
        <translation>一帧中间停顿超过 50 ms</translation>
    </message>
    <message>
        <source>wrong checksum</source>
        <translation>校验和错误</translation>
    </message>
    <message>
        <source>D1 and D2: what one count of the current converter stands for; D3 tells ampere.</source>
        <translation>D1 和 D2：电流转换器一个计数代表的值；D3 直接给出安培。</translation>
    </message>
    <message>
        <source>serial bootloader</source>
        <translation>串行引导程序</translation>
    </message>
    <message>
        <source>serial bootloader, without reset</source>
        <translation>串行引导程序，无复位</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>回路</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>轮廓</translation>
    </message>
    <message>
        <source>Digital lines</source>
        <translation>数字线</translation>
    </message>
    <message>
        <source>Bus</source>
        <translation>总线</translation>
    </message>
    <message>
        <source>Errors</source>
        <translation>错误</translation>
    </message>
    <message>
        <source>D1, D2: 1/65280 of full output per count of error; 4000 is full output at 16 counts. The scale of D3 is not documented.</source>
        <translation>D1、D2：每计数误差为满输出的 1/65280；4000 表示 16 个计数时满输出。D3 的比例未见文档说明。</translation>
    </message>
    <message>
        <source>D1, D2: 1/16711680 of full output per count of error and loop of 1.024 ms. The bound of the integral follows P at the next restart only.</source>
        <translation>D1、D2：每计数误差、每 1.024 ms 回路周期为满输出的 1/16711680。积分的界限在下次重新启动后才随 P 变化。</translation>
    </message>
    <message>
        <source>D1, D2: 1/65280 of full output per count that the error changes in one loop of 1.024 ms.</source>
        <translation>D1、D2：一个 1.024 ms 回路周期内误差每变化一个计数为满输出的 1/65280。</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>加速度</translation>
    </message>
    <message>
        <source>Of profiled moves. D1: at most 65535.</source>
        <translation>用于轮廓运动。D1：最大 65535。</translation>
    </message>
    <message>
        <source>Of profiled moves. D1: at most 65535. D1 and D2 may pass their target above 2500, and compute wrongly from 46340 on.</source>
        <translation>用于轮廓运动。D1：最大 65535。D1 和 D2 在 2500 以上可能越过目标，从 46340 起计算错误。</translation>
    </message>
    <message>
        <source>Firmware of D1 and D2 stores it and does not limit anything.</source>
        <translation>D1 和 D2 的固件会存储它，但不限制任何内容。</translation>
    </message>
    <message>
        <source>Time above the limit</source>
        <translation>超过限值的时间</translation>
    </message>
    <message>
        <source>In force after a restart. D1 and D2 take it for the current limit until then; the limit is therefore written again behind it.</source>
        <translation>重新启动后生效。在此之前 D1 和 D2 将其当作电流限值；因此之后会再次写入限值。</translation>
    </message>
    <message>
        <source>Outputs among the lines</source>
        <translation>线路中的输出</translation>
    </message>
    <message>
        <source>1, 2, 4, 8 for DIO1 to DIO4; a set bit makes an output. DIO1 and DIO3 low for 3 s start the analog programming of the device, DIO2 and DIO4 low restore its factory settings.</source>
        <translation>1、2、4、8 对应 DIO1 至 DIO4；置位表示输出。DIO1 和 DIO3 为低 3 s 会启动设备的模拟编程，DIO2 和 DIO4 为低会恢复其出厂设置。</translation>
    </message>
    <message>
        <source>Levels of the outputs</source>
        <translation>输出的电平</translation>
    </message>
    <message>
        <source>Bits as for the directions; inputs ignore theirs. Cannot be read back and is lost at power-off.</source>
        <translation>各位与方向相同；输入忽略其对应位。无法回读，断电后丢失。</translation>
    </message>
    <message>
        <source>Node id</source>
        <translation>节点 ID</translation>
    </message>
    <message>
        <source>Its address on the line. In force after a restart; until then it answers under the old one.</source>
        <translation>其在线路上的地址。重新启动后生效；在此之前以旧地址应答。</translation>
    </message>
    <message>
        <source>Acceptance mask</source>
        <translation>接收掩码</translation>
    </message>
    <message>
        <source>Bits of an address that count. 255: only its own; less makes a group that acts on what is sent to any of its members, and on their answers. In force after a restart.</source>
        <translation>地址中起作用的位。255：仅其自身；较小的值构成一个组，该组会执行发送给任一成员的内容，也会对成员的应答作出反应。重新启动后生效。</translation>
    </message>
    <message>
        <source>Bit rate</source>
        <translation>比特率</translation>
    </message>
    <message>
        <source>In force after a restart. Reads as the rate at which it answers. 115200 is really 119048: prefer 57600.</source>
        <translation>重新启动后生效。读出的是它应答所用的速率。115200 实际为 119048：宜用 57600。</translation>
    </message>
    <message>
        <source>Error level</source>
        <translation>错误级别</translation>
    </message>
    <message>
        <source>D1 and D2. Level 1 would make every reading fail, so only 0 is offered: write it where another program set 1.</source>
        <translation>D1 和 D2。级别 1 会使每次读取失败，因此只提供 0：若其他程序设成了 1，请写入 0。</translation>
    </message>
    <message>
        <source>Reactions to errors</source>
        <translation>对错误的反应</translation>
    </message>
    <message>
        <source>D3. Two bits for each of 20 errors, the first lowest: 0 nothing, 1 stop, 2 halt. Which error is which is not documented.</source>
        <translation>D3。20 个错误各占两位，第一个在最低位：0 无，1 停止，2 停住。各错误的对应关系未见文档说明。</translation>
    </message>
    <message>
        <source>Anti-windup</source>
        <translation>抗积分饱和</translation>
    </message>
    <message>
        <source>D3. Bound of the integral; its scale is not documented.</source>
        <translation>D3。积分的界限；其比例未见文档说明。</translation>
    </message>
    <message>
        <source>Digital input 1</source>
        <translation>数字输入 1</translation>
    </message>
    <message>
        <source>Digital input 2</source>
        <translation>数字输入 2</translation>
    </message>
    <message>
        <source>Digital input 3</source>
        <translation>数字输入 3</translation>
    </message>
    <message>
        <source>Digital input 4</source>
        <translation>数字输入 4</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>手动</translation>
    </message>
    <message>
        <source>as found</source>
        <translation>初始状态</translation>
    </message>
    <message>
        <source>before restore</source>
        <translation>恢复之前</translation>
    </message>
    <message>
        <source>before import</source>
        <translation>导入之前</translation>
    </message>
    <message>
        <source>before tuning</source>
        <translation>整定之前</translation>
    </message>
    <message>
        <source>before update</source>
        <translation>更新之前</translation>
    </message>
    <message>
        <source>%1 % of the samples were lost in a second</source>
        <translation>一秒内丢失 %1 % 的采样</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1 %2 is outside %3 … %4</source>
        <translation>%1 %2 超出 %3 … %4</translation>
    </message>
    <message>
        <source>%1 %2 is outside %3 … %4 %5</source>
        <translation>%1 %2 超出 %3 … %4 %5</translation>
    </message>
    <message>
        <source>%1 %2 is outside %3 … %4, what firmware of dialect %5 takes</source>
        <translation>%1 %2 超出 %3 … %4，即方言 %5 的固件可接受的范围</translation>
    </message>
    <message>
        <source>%1 %2 is outside the envelope, which ends at %3</source>
        <translation>%1 %2 超出运行包络，其上限为 %3</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>%1 (code %2)</source>
        <translation>%1（代码 %2）</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 和 %2</translation>
    </message>
    <message>
        <source>%1 at %2 % duty</source>
        <translation>%1，占空比 %2 %</translation>
    </message>
    <message>
        <source>%1 at byte %2</source>
        <translation>%1，位于字节 %2</translation>
    </message>
    <message>
        <source>%1 becomes %2, it was %3: the device stores it</source>
        <translation>%1 变为 %2，原为 %3：设备会存储它</translation>
    </message>
    <message>
        <source>%1 becomes %2: the device stores it</source>
        <translation>%1 变为 %2：设备会存储它</translation>
    </message>
    <message>
        <source>%1 begins no line of such a log</source>
        <translation>此类日志的行不会以 %1 开头</translation>
    </message>
    <message>
        <source>%1 belongs to the unit that the file was saved from</source>
        <translation>%1 属于保存该文件的那台设备</translation>
    </message>
    <message>
        <source>%1 bit/s is no rate of a serial line</source>
        <translation>%1 bit/s 不是串行线路的速率</translation>
    </message>
    <message>
        <source>%1 bytes</source>
        <translation>%1 字节</translation>
    </message>
    <message>
        <source>%1 cannot be made</source>
        <translation>无法创建 %1</translation>
    </message>
    <message>
        <source>%1 cannot be made: %2</source>
        <translation>无法创建 %1：%2</translation>
    </message>
    <message>
        <source>%1 cannot be opened: %2</source>
        <translation>无法打开 %1：%2</translation>
    </message>
    <message>
        <source>%1 cannot be painted</source>
        <translation>无法绘制 %1</translation>
    </message>
    <message>
        <source>%1 cannot be read from the device</source>
        <translation>无法从设备读取 %1</translation>
    </message>
    <message>
        <source>%1 cannot be read, so it could not be put back</source>
        <translation>无法读取 %1，因此无法将其恢复</translation>
    </message>
    <message>
        <source>%1 cannot be read: %2</source>
        <translation>无法读取 %1：%2</translation>
    </message>
    <message>
        <source>%1 cannot be restarted from here</source>
        <translation>无法从此处重新启动 %1</translation>
    </message>
    <message>
        <source>%1 cannot be started: %2</source>
        <translation>无法启动 %1：%2</translation>
    </message>
    <message>
        <source>%1 cannot be written</source>
        <translation>无法写入 %1</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2</source>
        <translation>无法写入 %1：%2</translation>
    </message>
    <message>
        <source>%1 cannot do %2 bit/s</source>
        <translation>%1 不支持 %2 bit/s</translation>
    </message>
    <message>
        <source>%1 cannot do %2 bit/s: %3</source>
        <translation>%1 不支持 %2 bit/s：%3</translation>
    </message>
    <message>
        <source>%1 cannot do %2: %3</source>
        <translation>%1 不支持 %2：%3</translation>
    </message>
    <message>
        <source>%1 cannot do SPI mode 1 at this speed</source>
        <translation>%1 不支持此速度下的 SPI 模式 1</translation>
    </message>
    <message>
        <source>%1 cannot take old samples: %2</source>
        <translation>%1 无法接收旧采样：%2</translation>
    </message>
    <message>
        <source>%1 could not be measured</source>
        <translation>无法测量 %1</translation>
    </message>
    <message>
        <source>%1 data bytes are announced, %2 are there</source>
        <translation>声明有 %1 个数据字节，实有 %2 个</translation>
    </message>
    <message>
        <source>%1 did not come back within %2</source>
        <translation>%1 未在 %2 内恢复</translation>
    </message>
    <message>
        <source>%1 digits, an even number is needed</source>
        <translation>%1 位数字，需要偶数位</translation>
    </message>
    <message>
        <source>%1 does not answer</source>
        <translation>%1 无应答</translation>
    </message>
    <message>
        <source>%1 does not answer: %2</source>
        <translation>%1 无应答：%2</translation>
    </message>
    <message>
        <source>%1 does not exist in this device&apos;s dialect</source>
        <translation>%1 在此设备的方言中不存在</translation>
    </message>
    <message>
        <source>%1 does not open: its driver has not answered for %2 s</source>
        <translation>%1 无法打开：其驱动程序已 %2 s 无应答</translation>
    </message>
    <message>
        <source>%1 does not tell its position</source>
        <translation>%1 不报告其位置</translation>
    </message>
    <message>
        <source>%1 exists and is no socket</source>
        <translation>%1 已存在且不是套接字</translation>
    </message>
    <message>
        <source>%1 failed (%2)</source>
        <translation>%1 失败 (%2)</translation>
    </message>
    <message>
        <source>%1 failed: %2</source>
        <translation>%1 失败：%2</translation>
    </message>
    <message>
        <source>%1 frames recorded, %2 are missing</source>
        <translation>已记录 %1 帧，缺失 %2 帧</translation>
    </message>
    <message>
        <source>%1 frames recorded, none is missing</source>
        <translation>已记录 %1 帧，无缺失</translation>
    </message>
    <message>
        <source>%1 frames were lost, the kernel keeps only %2 for this program</source>
        <translation>丢失 %1 帧，内核只为本程序保留 %2</translation>
    </message>
    <message>
        <source>%1 has %2 axes and %3 sets of gains</source>
        <translation>%1 有 %2 个轴和 %3 组增益</translation>
    </message>
    <message>
        <source>%1 has a name that ends in no kind of picture</source>
        <translation>%1 的名称不以任何图片类型结尾</translation>
    </message>
    <message>
        <source>%1 has a name that ends in no kind of report</source>
        <translation>%1 的名称不以任何报告类型结尾</translation>
    </message>
    <message>
        <source>%1 has no %2</source>
        <translation>%1 没有 %2</translation>
    </message>
    <message>
        <source>%1 has no &apos;%2&apos; to be set</source>
        <translation>%1 没有可设置的“%2”</translation>
    </message>
    <message>
        <source>%1 has no buffered moves</source>
        <translation>%1 没有缓冲运动</translation>
    </message>
    <message>
        <source>%1 has no channel of samples</source>
        <translation>%1 没有采样通道</translation>
    </message>
    <message>
        <source>%1 has no command that zeroes its position</source>
        <translation>%1 没有将其位置归零的命令</translation>
    </message>
    <message>
        <source>%1 has no dialect &apos;%2&apos;</source>
        <translation>%1 没有方言“%2”</translation>
    </message>
    <message>
        <source>%1 has no duty command</source>
        <translation>%1 没有占空比命令</translation>
    </message>
    <message>
        <source>%1 has no duty command, so &apos;%2&apos; is not measured</source>
        <translation>%1 没有占空比命令，因此不测量“%2”</translation>
    </message>
    <message>
        <source>%1 has no firmware update here</source>
        <translation>%1 在此处没有固件更新</translation>
    </message>
    <message>
        <source>%1 has no frame in it</source>
        <translation>%1 中没有帧</translation>
    </message>
    <message>
        <source>%1 has no frame of %2</source>
        <translation>%1 中没有 %2 的帧</translation>
    </message>
    <message>
        <source>%1 has no loop &apos;%2&apos; that can be tried</source>
        <translation>%1 没有可试验的回路“%2”</translation>
    </message>
    <message>
        <source>%1 has no loop &apos;%2&apos; that can be tuned</source>
        <translation>%1 没有可整定的回路“%2”</translation>
    </message>
    <message>
        <source>%1 has no loop that can be tried</source>
        <translation>%1 没有可试验的回路</translation>
    </message>
    <message>
        <source>%1 has no number that could be set</source>
        <translation>%1 没有可设置的编号</translation>
    </message>
    <message>
        <source>%1 has no option &apos;%2&apos;</source>
        <translation>%1 没有选项“%2”</translation>
    </message>
    <message>
        <source>%1 has no samples</source>
        <translation>%1 没有采样</translation>
    </message>
    <message>
        <source>%1 has no setting that could be written to every unit</source>
        <translation>%1 没有可写入每台设备的设置</translation>
    </message>
    <message>
        <source>%1 has no such limit of its own, so nothing bounds the motor</source>
        <translation>%1 自身没有此限值，因此电机不受任何限定</translation>
    </message>
    <message>
        <source>%1 has not told where it stands</source>
        <translation>%1 未报告其所在位置</translation>
    </message>
    <message>
        <source>%1 holds no limits of experiments</source>
        <translation>%1 不含实验的限值</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1，位于%2</translation>
    </message>
    <message>
        <source>%1 in its bootloader instead of %2</source>
        <translation>%1 处于引导程序，而非 %2</translation>
    </message>
    <message>
        <source>%1 instead of %2</source>
        <translation>%1，而非 %2</translation>
    </message>
    <message>
        <source>%1 is %2</source>
        <translation>%1 为 %2</translation>
    </message>
    <message>
        <source>%1 is %2, %3</source>
        <translation>%1 为 %2，%3</translation>
    </message>
    <message>
        <source>%1 is a device and has no end</source>
        <translation>%1 是设备，没有结尾</translation>
    </message>
    <message>
        <source>%1 is a folder</source>
        <translation>%1 是文件夹</translation>
    </message>
    <message>
        <source>%1 is a network interface, but not one for CAN</source>
        <translation>%1 是网络接口，但不是 CAN 接口</translation>
    </message>
    <message>
        <source>%1 is a recording: it can be watched, not written to or driven</source>
        <translation>%1 是记录：可监视，不可写入或驱动</translation>
    </message>
    <message>
        <source>%1 is back</source>
        <translation>%1 已恢复</translation>
    </message>
    <message>
        <source>%1 is being opened already</source>
        <translation>%1 已在打开中</translation>
    </message>
    <message>
        <source>%1 is being recorded already</source>
        <translation>%1 已在记录中</translation>
    </message>
    <message>
        <source>%1 is bus-off</source>
        <translation>%1 处于总线关闭状态</translation>
    </message>
    <message>
        <source>%1 is busy: it serves one client at a time</source>
        <translation>%1 忙：它一次只服务一个客户端</translation>
    </message>
    <message>
        <source>%1 is damaged and cannot be put aside</source>
        <translation>%1 已损坏且无法移开</translation>
    </message>
    <message>
        <source>%1 is error-passive</source>
        <translation>%1 处于错误被动状态</translation>
    </message>
    <message>
        <source>%1 is error-warning</source>
        <translation>%1 处于错误警告状态</translation>
    </message>
    <message>
        <source>%1 is gone</source>
        <translation>%1 已不存在</translation>
    </message>
    <message>
        <source>%1 is in use by another program</source>
        <translation>%1 正被另一程序使用</translation>
    </message>
    <message>
        <source>%1 is locked by another program</source>
        <translation>%1 被另一程序锁定</translation>
    </message>
    <message>
        <source>%1 is lost: %2; waiting up to %3 for it to come back</source>
        <translation>%1 已丢失：%2；最多等待 %3 使其恢复</translation>
    </message>
    <message>
        <source>%1 is missing</source>
        <translation>缺少 %1</translation>
    </message>
    <message>
        <source>%1 is never part of an experiment</source>
        <translation>%1 从不属于实验</translation>
    </message>
    <message>
        <source>%1 is no CAN identifier in dec</source>
        <translation>%1 不是 dec 格式的 CAN 标识符</translation>
    </message>
    <message>
        <source>%1 is no CAN identifier in hex</source>
        <translation>%1 不是 hex 格式的 CAN 标识符</translation>
    </message>
    <message>
        <source>%1 is no CAN link</source>
        <translation>%1 不是 CAN 链路</translation>
    </message>
    <message>
        <source>%1 is no device profile</source>
        <translation>%1 不是设备配置文件</translation>
    </message>
    <message>
        <source>%1 is no list of devices and is ignored: the next scan takes its full time and writes it anew</source>
        <translation>%1 不是设备列表，已忽略：下次扫描将耗费完整时间并重新写入它</translation>
    </message>
    <message>
        <source>%1 is no project of this version</source>
        <translation>%1 不是此版本的项目</translation>
    </message>
    <message>
        <source>%1 is no recording</source>
        <translation>%1 不是记录</translation>
    </message>
    <message>
        <source>%1 is no serial port</source>
        <translation>%1 不是串口</translation>
    </message>
    <message>
        <source>%1 is no time stamp</source>
        <translation>%1 不是时间戳</translation>
    </message>
    <message>
        <source>%1 is not a file</source>
        <translation>%1 不是文件</translation>
    </message>
    <message>
        <source>%1 is not a hexadecimal digit</source>
        <translation>%1 不是十六进制数字</translation>
    </message>
    <message>
        <source>%1 is not an MCAP file</source>
        <translation>%1 不是 MCAP 文件</translation>
    </message>
    <message>
        <source>%1 is not an object</source>
        <translation>%1 不是对象</translation>
    </message>
    <message>
        <source>%1 is not in this program</source>
        <translation>本程序中没有 %1</translation>
    </message>
    <message>
        <source>%1 is not installed</source>
        <translation>%1 未安装</translation>
    </message>
    <message>
        <source>%1 is not known to firmware of dialect %2</source>
        <translation>方言 %2 的固件不认识 %1</translation>
    </message>
    <message>
        <source>%1 is not open</source>
        <translation>%1 未打开</translation>
    </message>
    <message>
        <source>%1 is not updated over its own link</source>
        <translation>%1 不通过其自身的链路更新</translation>
    </message>
    <message>
        <source>%1 is read-only</source>
        <translation>%1 为只读</translation>
    </message>
    <message>
        <source>%1 is served by another program already</source>
        <translation>%1 已由另一程序提供服务</translation>
    </message>
    <message>
        <source>%1 is served by another simulator</source>
        <translation>%1 已由另一仿真器提供服务</translation>
    </message>
    <message>
        <source>%1 is switched off</source>
        <translation>%1 已关闭</translation>
    </message>
    <message>
        <source>%1 is there already and no link to a terminal</source>
        <translation>%1 已存在，且不是指向终端的链接</translation>
    </message>
    <message>
        <source>%1 is updated over its own link</source>
        <translation>%1 通过其自身的链路更新</translation>
    </message>
    <message>
        <source>%1 is used by another program</source>
        <translation>%1 被另一程序使用</translation>
    </message>
    <message>
        <source>%1 lines, %2 bytes; the file does not name its version</source>
        <translation>%1 行，%2 字节；文件未注明其版本</translation>
    </message>
    <message>
        <source>%1 links are not supported yet</source>
        <translation>尚不支持 %1 链路</translation>
    </message>
    <message>
        <source>%1 needs a number</source>
        <translation>%1 需要一个数值</translation>
    </message>
    <message>
        <source>%1 of %2 lines were confirmed. The bootloader keeps waiting: leave the jumper in and run the update again</source>
        <translation>%2 行中已确认 %1 行。引导程序继续等待：请保留跳线并再次运行更新</translation>
    </message>
    <message>
        <source>%1 of %2 settings were written again; %3: %4</source>
        <translation>%2 项设置中已重新写入 %1 项；%3：%4</translation>
    </message>
    <message>
        <source>%1 of %2 settings were written again; then the board was reset once more</source>
        <translation>%2 项设置中已重新写入 %1 项；随后板卡再次复位</translation>
    </message>
    <message>
        <source>%1 of the recipe read back different, first %2</source>
        <translation>配方中有 %1 项回读不同，首项为 %2</translation>
    </message>
    <message>
        <source>%1 only listens, nothing can be sent</source>
        <translation>%1 只监听，无法发送任何内容</translation>
    </message>
    <message>
        <source>%1 parameters gave no answer</source>
        <translation>%1 个参数无应答</translation>
    </message>
    <message>
        <source>%1 said nothing for a minute and was ended</source>
        <translation>%1 一分钟没有任何响应，已被结束</translation>
    </message>
    <message>
        <source>%1 said nothing for too long</source>
        <translation>%1 过久没有任何响应</translation>
    </message>
    <message>
        <source>%1 settings written again</source>
        <translation>已重新写入 %1 项设置</translation>
    </message>
    <message>
        <source>%1 takes no frames: %2 wait to be sent</source>
        <translation>%1 不接收帧：有 %2 帧等待发送</translation>
    </message>
    <message>
        <source>%1 to number %2: %3</source>
        <translation>%1 发往编号 %2：%3</translation>
    </message>
    <message>
        <source>%1 transmit and %2 receive errors</source>
        <translation>%1 个发送错误和 %2 个接收错误</translation>
    </message>
    <message>
        <source>%1 units answer as number %2</source>
        <translation>%1 台设备以编号 %2 应答</translation>
    </message>
    <message>
        <source>%1 values are not what they were left as; the history has both</source>
        <translation>%1 个值与上次离开时不同；历史中两者都有</translation>
    </message>
    <message>
        <source>%1 was %2 and is not known to be cleared</source>
        <translation>%1 原为 %2，无法确知是否已清除</translation>
    </message>
    <message>
        <source>%1 was changed while it was played</source>
        <translation>%1 在播放期间被更改</translation>
    </message>
    <message>
        <source>%1 was closed before it was open</source>
        <translation>%1 在打开之前已被关闭</translation>
    </message>
    <message>
        <source>%1 was disconnected</source>
        <translation>%1 已断开</translation>
    </message>
    <message>
        <source>%1 was made by a newer version of this program (schema %2, known here is %3)</source>
        <translation>%1 由本程序的较新版本生成（模式版本 %2，此处已知 %3）</translation>
    </message>
    <message>
        <source>%1 was not confirmed</source>
        <translation>%1 未得到确认</translation>
    </message>
    <message>
        <source>%1 was refused: %2</source>
        <translation>%1 被拒绝：%2</translation>
    </message>
    <message>
        <source>%1 was stopped: %2, %3</source>
        <translation>%1 已停止：%2，%3</translation>
    </message>
    <message>
        <source>%1 was switched off</source>
        <translation>%1 已被关闭</translation>
    </message>
    <message>
        <source>%1 was unknown when the file was written</source>
        <translation>写文件时 %1 未知</translation>
    </message>
    <message>
        <source>%1 was unplugged</source>
        <translation>%1 已被拔出</translation>
    </message>
    <message>
        <source>%1 was written as %2 but reads %3</source>
        <translation>%1 写入为 %2，但读出为 %3</translation>
    </message>
    <message>
        <source>%1 where a record begins with a colon, is this an Intel HEX file?</source>
        <translation>记录应以冒号开头，此处却是 %1；这是 Intel HEX 文件吗？</translation>
    </message>
    <message>
        <source>%1 with %2 transmit and %3 receive errors</source>
        <translation>%1，有 %2 个发送错误和 %3 个接收错误</translation>
    </message>
    <message>
        <source>%1 would be %2 of its smallest steps, too few to mean anything</source>
        <translation>%1 将只有其最小级差的 %2 倍，过小而没有意义</translation>
    </message>
    <message>
        <source>%1 would have to be %2, which it cannot be</source>
        <translation>%1 须为 %2，而这不可能</translation>
    </message>
    <message>
        <source>%1 written, read back and equal</source>
        <translation>%1 已写入、回读且一致</translation>
    </message>
    <message>
        <source>%1 written; %2 of them cannot be read back</source>
        <translation>已写入 %1；其中 %2 无法回读</translation>
    </message>
    <message>
        <source>%1 written; they cannot be read back</source>
        <translation>已写入 %1；无法回读</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>%1, and the device switched its output off</source>
        <translation>%1，设备已关闭其输出</translation>
    </message>
    <message>
        <source>%1, line %2: %3</source>
        <translation>%1，第 %2 行：%3</translation>
    </message>
    <message>
        <source>%1, more than half a step from its target</source>
        <translation>%1，距目标超过半个阶跃</translation>
    </message>
    <message>
        <source>%1, told to run at more than half a step</source>
        <translation>%1，被命令以超过半个阶跃运行</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>%1: %2 is above %3</source>
        <translation>%1：%2 高于 %3</translation>
    </message>
    <message>
        <source>%1: %2 is below %3</source>
        <translation>%1：%2 低于 %3</translation>
    </message>
    <message>
        <source>%1: %2 is not a whole number</source>
        <translation>%1：%2 不是整数</translation>
    </message>
    <message>
        <source>%1: %2 of %3 ms is finer than the device follows, which takes a set-point every %4 ms</source>
        <translation>%1：%3 ms 的%2过于精细，设备无法跟随，它每 %4 ms 接收一个设定值</translation>
    </message>
    <message>
        <source>%1: &apos;%2&apos; is neither on nor off</source>
        <translation>%1：“%2”既不是 on 也不是 off</translation>
    </message>
    <message>
        <source>%1: &apos;%2&apos; is not a number</source>
        <translation>%1：“%2”不是数值</translation>
    </message>
    <message>
        <source>%1: cannot be read (system error %2)</source>
        <translation>%1：无法读取（系统错误 %2）</translation>
    </message>
    <message>
        <source>%1: its value is of the wrong kind</source>
        <translation>%1：其值的类型错误</translation>
    </message>
    <message>
        <source>%1: its value says %2, its raw value %3</source>
        <translation>%1：其值为 %2，其原始值为 %3</translation>
    </message>
    <message>
        <source>%1: legal is %2</source>
        <translation>%1：允许值为 %2</translation>
    </message>
    <message>
        <source>%1: legal is %2 … %3</source>
        <translation>%1：允许值为 %2 … %3</translation>
    </message>
    <message>
        <source>%1: no permission to read it</source>
        <translation>%1：没有读取权限</translation>
    </message>
    <message>
        <source>%1: no such file</source>
        <translation>%1：没有此文件</translation>
    </message>
    <message>
        <source>%1: not a number</source>
        <translation>%1：不是数值</translation>
    </message>
    <message>
        <source>%1: raw is not a whole number</source>
        <translation>%1：raw 不是整数</translation>
    </message>
    <message>
        <source>%1: raw value %2 is out of range</source>
        <translation>%1：原始值 %2 超出范围</translation>
    </message>
    <message>
        <source>%1: status %2 has no meaning</source>
        <translation>%1：状态 %2 没有含义</translation>
    </message>
    <message>
        <source>%1: the device answers &apos;%2&apos;</source>
        <translation>%1：设备应答“%2”</translation>
    </message>
    <message>
        <source>%1: the device refused the value</source>
        <translation>%1：设备拒绝该值</translation>
    </message>
    <message>
        <source>%1: this firmware does not know the parameter</source>
        <translation>%1：此固件不认识该参数</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1；%2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no journal that stations share</source>
        <translation>“%1”不是各工位共享的日志簿</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no number</source>
        <translation>“%1”不是数值</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no path of a socket: it has 1 to 107 characters</source>
        <translation>“%1”不是套接字路径：其长度为 1 到 107 个字符</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no time in seconds</source>
        <translation>“%1”不是以秒为单位的时间</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no value for the option &apos;%2&apos; of %3</source>
        <translation>“%1”不是 %3 的选项“%2”的有效值</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a device: LINK/FAMILY:ADDRESS is needed, such as sim:can/dmc60c:5</source>
        <translation>“%1”不是设备：格式须为 LINK/FAMILY:ADDRESS，例如 sim:can/dmc60c:5</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a link: SCHEME:PATH is needed, such as socketcan:can0 or sim:</source>
        <translation>“%1”不是链路：格式须为 SCHEME:PATH，例如 socketcan:can0 或 sim:</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a simulated device: %2</source>
        <translation>“%1”不是仿真设备：%2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not qtcan:PLUGIN:INTERFACE</source>
        <translation>“%1”不是 qtcan:PLUGIN:INTERFACE</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be a number</source>
        <translation>“%1”必须是数值</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be a text</source>
        <translation>“%1”必须是文本</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be a whole number</source>
        <translation>“%1”必须是整数</translation>
    </message>
    <message>
        <source>a name has no line break, tabulator or other control character</source>
        <translation>名称中不能有换行符、制表符或其他控制字符</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be an object in braces</source>
        <translation>“%1”必须是花括号中的对象</translation>
    </message>
    <message>
        <source>&apos;%1&apos; names no interface</source>
        <translation>“%1”未指定接口</translation>
    </message>
    <message>
        <source>&apos;encoder&apos; is true: it counts both ways</source>
        <translation>“encoder”为 true：它双向计数</translation>
    </message>
    <message>
        <source>&apos;motorbenchctl snapshots&apos; lists those there are</source>
        <translation>“motorbenchctl snapshots”可列出现有的快照</translation>
    </message>
    <message>
        <source>&apos;motorbenchctl trials&apos; lists those there are</source>
        <translation>“motorbenchctl trials”可列出现有的试验</translation>
    </message>
    <message>
        <source>&apos;store&apos; must be true or false</source>
        <translation>“store”必须是 true 或 false</translation>
    </message>
    <message>
        <source>&apos;to&apos; is missing</source>
        <translation>缺少“to”</translation>
    </message>
    <message>
        <source>--font-scale takes 0.5 to 3</source>
        <translation>--font-scale 接受 0.5 至 3</translation>
    </message>
    <message>
        <source>--language takes one of %1</source>
        <translation>--language 只接受以下之一：%1</translation>
    </message>
    <message>
        <source>--out &apos;%1&apos; is no picture</source>
        <translation>--out “%1”不是图片</translation>
    </message>
    <message>
        <source>%1 is no report</source>
        <translation>%1 不是报告</translation>
    </message>
    <message>
        <source>--out &apos;%1&apos; is no PDF</source>
        <translation>--out“%1”不是 PDF</translation>
    </message>
    <message>
        <source>--help tells what there is</source>
        <translation>--help 列出所有选项</translation>
    </message>
    <message>
        <source>--plot FILE or --report FILE, and --out FILE belong together</source>
        <translation>--plot FILE 或 --report FILE 须与 --out FILE 一起使用</translation>
    </message>
    <message>
        <source>--size takes WIDTHxHEIGHT, such as 1280x800</source>
        <translation>--size 接受 WIDTHxHEIGHT，例如 1280x800</translation>
    </message>
    <message>
        <source>--target is missing</source>
        <translation>缺少 --target</translation>
    </message>
    <message>
        <source>--target: &apos;%1&apos; is unknown</source>
        <translation>--target：“%1”未知</translation>
    </message>
    <message>
        <source>--tour needs a folder for its pictures</source>
        <translation>--tour 需要用于存放图片的文件夹</translation>
    </message>
    <message>
        <source>--via: &apos;%1&apos; is no way into a Supermodified</source>
        <translation>--via：“%1”不是 Supermodified 的接入途径</translation>
    </message>
    <message>
        <source>--via: &apos;%1&apos; is no way into an Abstract DC Drive</source>
        <translation>--via：“%1”不是 Abstract DC Drive 的接入途径</translation>
    </message>
    <message>
        <source>0 is no divisor</source>
        <translation>0 不能作为除数</translation>
    </message>
    <message>
        <source>1 byte</source>
        <translation>1 字节</translation>
    </message>
    <message>
        <source>A programmer on the pins erases the chip first, the stored settings and the serial bootloader with it: save the parameters before. The bootloader keeps both.</source>
        <translation>接在引脚上的编程器会先擦除芯片，已存储的设置和串行引导程序也一并擦除：请事先保存参数。使用引导程序则两者均保留。</translation>
    </message>
    <message>
        <source>Abstract DC Drives are found on CAN links only</source>
        <translation>Abstract DC Drive 仅出现在 CAN 链路上</translation>
    </message>
    <message>
        <source>Abstract DC Drives found: %1</source>
        <translation>找到 Abstract DC Drive：%1</translation>
    </message>
    <message>
        <source>Abstract DC Drives live on CAN links only</source>
        <translation>Abstract DC Drive 仅存在于 CAN 链路上</translation>
    </message>
    <message>
        <source>All pages written</source>
        <translation>所有页已写入</translation>
    </message>
    <message>
        <source>Assign number</source>
        <translation>分配编号</translation>
    </message>
    <message>
        <source>Autotune</source>
        <translation>自整定</translation>
    </message>
    <message>
        <source>CAN high is not connected</source>
        <translation>CAN high 未连接</translation>
    </message>
    <message>
        <source>CAN high is short to battery</source>
        <translation>CAN high 与电池短路</translation>
    </message>
    <message>
        <source>CAN high is short to ground</source>
        <translation>CAN high 与地短路</translation>
    </message>
    <message>
        <source>CAN high is short to supply</source>
        <translation>CAN high 与电源短路</translation>
    </message>
    <message>
        <source>CAN low is not connected</source>
        <translation>CAN low 未连接</translation>
    </message>
    <message>
        <source>CAN low is short to CAN high</source>
        <translation>CAN low 与 CAN high 短路</translation>
    </message>
    <message>
        <source>CAN low is short to battery</source>
        <translation>CAN low 与电池短路</translation>
    </message>
    <message>
        <source>CAN low is short to ground</source>
        <translation>CAN low 与地短路</translation>
    </message>
    <message>
        <source>CAN low is short to supply</source>
        <translation>CAN low 与电源短路</translation>
    </message>
    <message>
        <source>CAN sockets cannot be opened: %1</source>
        <translation>无法打开 CAN 套接字：%1</translation>
    </message>
    <message>
        <source>CRC refused, nothing was erased; trying variant %1</source>
        <translation>CRC 被拒绝，未擦除任何内容；正在尝试变体 %1</translation>
    </message>
    <message>
        <source>Connecting through OpenOCD</source>
        <translation>正在通过 OpenOCD 连接</translation>
    </message>
    <message>
        <source>Connecting through avrdude</source>
        <translation>正在通过 avrdude 连接</translation>
    </message>
    <message>
        <source>Count from 0</source>
        <translation>从 0 计数</translation>
    </message>
    <message>
        <source>DMC60C controllers are found on CAN links only</source>
        <translation>DMC60C 控制器仅出现在 CAN 链路上</translation>
    </message>
    <message>
        <source>DMC60C found: %1</source>
        <translation>找到 DMC60C：%1</translation>
    </message>
    <message>
        <source>Dialect %1 was chosen by hand, none was proven. %2</source>
        <translation>方言 %1 为手动选择，未证实任何方言。%2</translation>
    </message>
    <message>
        <source>Dialect %1 was chosen by hand, the unit answered as %2. %3</source>
        <translation>方言 %1 为手动选择，设备以 %2 应答。%3</translation>
    </message>
    <message>
        <source>Do a write again</source>
        <translation>重做写入</translation>
    </message>
    <message>
        <source>Drives of two dialects answer with this offset in the recording.</source>
        <translation>记录中有两种方言的驱动器以此偏移量应答。</translation>
    </message>
    <message>
        <source>Enter bootloader</source>
        <translation>进入引导程序</translation>
    </message>
    <message>
        <source>Erasing flash</source>
        <translation>正在擦除闪存</translation>
    </message>
    <message>
        <source>Erasing the stored settings</source>
        <translation>正在擦除已存储的设置</translation>
    </message>
    <message>
        <source>Experiment</source>
        <translation>实验</translation>
    </message>
    <message>
        <source>FAMILY:ADDRESS is needed, such as dmc60c:5</source>
        <translation>格式须为 FAMILY:ADDRESS，例如 dmc60c:5</translation>
    </message>
    <message>
        <source>Frequency response</source>
        <translation>频率响应</translation>
    </message>
    <message>
        <source>GPIO line %1 is used by another program or driver</source>
        <translation>GPIO 线 %1 被另一程序或驱动程序使用</translation>
    </message>
    <message>
        <source>GPIO line %1: %2</source>
        <translation>GPIO 线 %1：%2</translation>
    </message>
    <message>
        <source>GetDescriptors: a field ends too early</source>
        <translation>GetDescriptors：某字段过早结束</translation>
    </message>
    <message>
        <source>GetFlashSeqnum: 4 bytes were expected</source>
        <translation>GetFlashSeqnum：应为 4 字节</translation>
    </message>
    <message>
        <source>GetFwver answered with %1 bytes</source>
        <translation>GetFwver 应答了 %1 字节</translation>
    </message>
    <message>
        <source>GetFwver: 6 bytes were expected</source>
        <translation>GetFwver：应为 6 字节</translation>
    </message>
    <message>
        <source>Giving it number %1</source>
        <translation>正在为其分配编号 %1</translation>
    </message>
    <message>
        <source>Identify</source>
        <translation>识别</translation>
    </message>
    <message>
        <source>It answers, but not as any known dialect; it can be watched but not driven.</source>
        <translation>它有应答，但不是任何已知方言；可监视但不可驱动。</translation>
    </message>
    <message>
        <source>It is not driven: %1.</source>
        <translation>不驱动它：%1。</translation>
    </message>
    <message>
        <source>Its answers fit no known dialect.</source>
        <translation>其应答不符合任何已知方言。</translation>
    </message>
    <message>
        <source>Its error level is 1, so every reading fails. Set error.level to 0.</source>
        <translation>其错误级别为 1，因此每次读取都会失败。请将 error.level 设为 0。</translation>
    </message>
    <message>
        <source>Keep the gains of a trial</source>
        <translation>保留试验的增益</translation>
    </message>
    <message>
        <source>Look at the restarted unit</source>
        <translation>检查重新启动的设备</translation>
    </message>
    <message>
        <source>Look for gains that are owed</source>
        <translation>查找待恢复的增益</translation>
    </message>
    <message>
        <source>Looking for Abstract DC Drives</source>
        <translation>正在查找 Abstract DC Drive</translation>
    </message>
    <message>
        <source>Looking for DMC60C</source>
        <translation>正在查找 DMC60C</translation>
    </message>
    <message>
        <source>Looking for Supermodified nodes at %1 bit/s</source>
        <translation>正在以 %1 bit/s 查找 Supermodified 节点</translation>
    </message>
    <message>
        <source>Looking for the controller</source>
        <translation>正在查找控制器</translation>
    </message>
    <message>
        <source>Looking for the drive</source>
        <translation>正在查找驱动器</translation>
    </message>
    <message>
        <source>No application runs; update its firmware.</source>
        <translation>没有应用程序在运行；请更新其固件。</translation>
    </message>
    <message>
        <source>Number %1 is used by %2 units; give each its own before one is driven.</source>
        <translation>编号 %1 被 %2 台设备使用；驱动之前请为每台分配各自的编号。</translation>
    </message>
    <message>
        <source>OpenOCD ended without saying why</source>
        <translation>OpenOCD 未说明原因即结束</translation>
    </message>
    <message>
        <source>OpenOCD verified the flash, and the drive answers again</source>
        <translation>OpenOCD 已校验闪存，驱动器重新应答</translation>
    </message>
    <message>
        <source>OpenOCD verified the flash, but nothing answers as %1; the new firmware may have another offset or bit rate: scan again</source>
        <translation>OpenOCD 已校验闪存，但没有设备以 %1 应答；新固件可能使用其他偏移量或比特率：请重新扫描</translation>
    </message>
    <message>
        <source>OpenOCD: %1</source>
        <translation>OpenOCD：%1</translation>
    </message>
    <message>
        <source>Page %1</source>
        <translation>第 %1 页</translation>
    </message>
    <message>
        <source>Preflight</source>
        <translation>预检</translation>
    </message>
    <message>
        <source>Product %1 is not known to be a DMC60C.</source>
        <translation>产品 %1 不是已知的 DMC60C。</translation>
    </message>
    <message>
        <source>Put gains back</source>
        <translation>恢复增益</translation>
    </message>
    <message>
        <source>Put values back</source>
        <translation>恢复原值</translation>
    </message>
    <message>
        <source>Read</source>
        <translation>已读取</translation>
    </message>
    <message>
        <source>Read and clear faults</source>
        <translation>读取并清除故障</translation>
    </message>
    <message>
        <source>Read parameters</source>
        <translation>读取参数</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>正在读取 %1</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>重命名</translation>
    </message>
    <message>
        <source>Restart</source>
        <translation>重新启动</translation>
    </message>
    <message>
        <source>Restarting the drive</source>
        <translation>正在重新启动驱动器</translation>
    </message>
    <message>
        <source>STOP was pressed</source>
        <translation>STOP 已按下</translation>
    </message>
    <message>
        <source>Saved</source>
        <translation>已保存</translation>
    </message>
    <message>
        <source>Saving the %1 loop</source>
        <translation>正在保存%1回路</translation>
    </message>
    <message>
        <source>Set telemetry rate</source>
        <translation>设置遥测频率</translation>
    </message>
    <message>
        <source>Set telemetry rate: %1</source>
        <translation>设置遥测频率：%1</translation>
    </message>
    <message>
        <source>Several drives answer with offset %1; offsets are compiled into the firmware, so give one of them another and flash it.</source>
        <translation>有多台驱动器以偏移量 %1 应答；偏移量编译在固件中，请为其中一台改用其他偏移量并烧写。</translation>
    </message>
    <message>
        <source>So old that nothing but its power stops it; it can be watched but not driven.</source>
        <translation>过于陈旧，只有断电才能停止；可监视但不可驱动。</translation>
    </message>
    <message>
        <source>Speaks the document&apos;s codes, which no published firmware does.</source>
        <translation>使用文档的代码，没有任何已发布的固件如此。</translation>
    </message>
    <message>
        <source>Speaks the firmware&apos;s codes, not the document&apos;s.</source>
        <translation>使用固件的代码，而非文档的代码。</translation>
    </message>
    <message>
        <source>Speaks the legacy frames of 8 bytes, as the published master does.</source>
        <translation>使用 8 字节的旧式帧，与已发布的主站相同。</translation>
    </message>
    <message>
        <source>Store to flash</source>
        <translation>存储到闪存</translation>
    </message>
    <message>
        <source>Supermodified controllers are found on serial links only</source>
        <translation>Supermodified 控制器仅出现在串行链路上</translation>
    </message>
    <message>
        <source>Supermodified found: %1</source>
        <translation>找到 Supermodified：%1</translation>
    </message>
    <message>
        <source>Take a snapshot</source>
        <translation>建立快照</translation>
    </message>
    <message>
        <source>The adapter has no %1 bit/s</source>
        <translation>适配器不支持 %1 bit/s</translation>
    </message>
    <message>
        <source>The bootloader runs; restart the unit or update its firmware.</source>
        <translation>引导程序正在运行；请重新启动设备或更新其固件。</translation>
    </message>
    <message>
        <source>The controller tells no version: the programmer&apos;s own verify and the controller&apos;s answer prove the update.</source>
        <translation>控制器不报告版本：编程器自身的校验和控制器的应答即证实更新。</translation>
    </message>
    <message>
        <source>The drive tells no version: the programmer&apos;s own verify and the drive&apos;s answer prove the update.</source>
        <translation>驱动器不报告版本：编程器自身的校验和驱动器的应答即证实更新。</translation>
    </message>
    <message>
        <source>The image holds a bootloader too, so it needs a programmer on the pins.</source>
        <translation>映像还包含引导程序，因此需要接在引脚上的编程器。</translation>
    </message>
    <message>
        <source>The image writes the settings pages: stored gains are replaced.</source>
        <translation>映像会写入设置页：已存储的增益将被替换。</translation>
    </message>
    <message>
        <source>The recording does not tell which codes it speaks: it was asked for what all answer alike.</source>
        <translation>从记录中无法得知它使用哪些代码：只查询了所有方言应答相同的内容。</translation>
    </message>
    <message>
        <source>The serial bootloader listens for a moment after power-up only: restart the controller when the update begins.</source>
        <translation>串行引导程序仅在上电后片刻内监听：请在更新开始时重新启动控制器。</translation>
    </message>
    <message>
        <source>This unit has no number and no application; assign a number, then update its firmware.</source>
        <translation>此设备没有编号也没有应用程序；请分配编号，然后更新其固件。</translation>
    </message>
    <message>
        <source>This unit has no number yet; assign one from 1 to 63.</source>
        <translation>此设备尚无编号；请分配 1 到 63 之间的编号。</translation>
    </message>
    <message>
        <source>Undo a write</source>
        <translation>撤销写入</translation>
    </message>
    <message>
        <source>Update firmware</source>
        <translation>更新固件</translation>
    </message>
    <message>
        <source>Verifying flash</source>
        <translation>正在校验闪存</translation>
    </message>
    <message>
        <source>Wait for %1</source>
        <translation>等待 %1</translation>
    </message>
    <message>
        <source>Waiting until the device has written its flash</source>
        <translation>正在等待设备写入其闪存</translation>
    </message>
    <message>
        <source>Write parameters</source>
        <translation>写入参数</translation>
    </message>
    <message>
        <source>Write settings again</source>
        <translation>重新写入设置</translation>
    </message>
    <message>
        <source>Writing %1</source>
        <translation>正在写入 %1</translation>
    </message>
    <message>
        <source>Writing flash</source>
        <translation>正在写入闪存</translation>
    </message>
    <message>
        <source>Written</source>
        <translation>已写入</translation>
    </message>
    <message>
        <source>&quot;via&quot; must name the other way in, such as &quot;%1&quot;</source>
        <translation>&quot;via&quot; 必须指定另一种接入途径，例如 &quot;%1&quot;</translation>
    </message>
    <message>
        <source>a DMC60C has a number from 0 to 63, not %1</source>
        <translation>DMC60C 的编号为 0 到 63，而非 %1</translation>
    </message>
    <message>
        <source>a DMC60C has no mode &apos;%1&apos;</source>
        <translation>DMC60C 没有模式“%1”</translation>
    </message>
    <message>
        <source>a DMC60C has one axis</source>
        <translation>DMC60C 有一个轴</translation>
    </message>
    <message>
        <source>a DMC60C has the gain slots 0 and 1</source>
        <translation>DMC60C 有增益槽 0 和 1</translation>
    </message>
    <message>
        <source>a DMC60C is simulated on a CAN link</source>
        <translation>DMC60C 在 CAN 链路上仿真</translation>
    </message>
    <message>
        <source>a DMC60C is updated over its own link</source>
        <translation>DMC60C 通过其自身的链路更新</translation>
    </message>
    <message>
        <source>a GPIO line is CHIP:LINE, as in gpiochip0:25, not &apos;%1&apos;</source>
        <translation>GPIO 线的格式为 CHIP:LINE，如 gpiochip0:25，而非“%1”</translation>
    </message>
    <message>
        <source>a QuadQuad2Drv has no address but 0</source>
        <translation>QuadQuad2Drv 除 0 之外没有地址</translation>
    </message>
    <message>
        <source>a QuadQuad2Drv has one kind of chip</source>
        <translation>QuadQuad2Drv 只有一种芯片</translation>
    </message>
    <message>
        <source>a QuadQuad2Drv is simulated on the board&apos;s end of an SPI link</source>
        <translation>QuadQuad2Drv 在 SPI 链路的板卡端仿真</translation>
    </message>
    <message>
        <source>a QuadQuad2Drv lives on an SPI link</source>
        <translation>QuadQuad2Drv 存在于 SPI 链路上</translation>
    </message>
    <message>
        <source>a Supermodified has an id from 1 to 127, not %1</source>
        <translation>Supermodified 的 ID 为 1 到 127，而非 %1</translation>
    </message>
    <message>
        <source>a Supermodified has no mode &apos;%1&apos;</source>
        <translation>Supermodified 没有模式“%1”</translation>
    </message>
    <message>
        <source>a Supermodified has one axis and one set of gains</source>
        <translation>Supermodified 有一个轴和一组增益</translation>
    </message>
    <message>
        <source>a Supermodified has one kind of microcontroller</source>
        <translation>Supermodified 只有一种微控制器</translation>
    </message>
    <message>
        <source>a Supermodified is simulated on a serial link</source>
        <translation>Supermodified 在串行链路上仿真</translation>
    </message>
    <message>
        <source>a Supermodified is written by avrdude</source>
        <translation>Supermodified 由 avrdude 写入</translation>
    </message>
    <message>
        <source>a bit</source>
        <translation>位</translation>
    </message>
    <message>
        <source>a bootloader needs the board&apos;s serial line, such as boot=pty:./boot</source>
        <translation>引导程序需要板卡的串行线路，例如 boot=pty:./boot</translation>
    </message>
    <message>
        <source>a buffered move is not acknowledged yet</source>
        <translation>有缓冲运动尚未得到确认</translation>
    </message>
    <message>
        <source>a demo remembers no layouts</source>
        <translation>演示不保存布局</translation>
    </message>
    <message>
        <source>a device cannot follow itself</source>
        <translation>设备不能跟随自身</translation>
    </message>
    <message>
        <source>a device number is 1 … 63</source>
        <translation>设备编号为 1 … 63</translation>
    </message>
    <message>
        <source>a divisor changes all gains at once</source>
        <translation>除数会同时改变所有增益</translation>
    </message>
    <message>
        <source>a drive of dialect LL has no code for stop</source>
        <translation>方言 LL 的驱动器没有停止代码</translation>
    </message>
    <message>
        <source>a formula assigns nothing</source>
        <translation>公式不能赋值</translation>
    </message>
    <message>
        <source>a formula has at most 4000 characters</source>
        <translation>公式最多 4000 个字符</translation>
    </message>
    <message>
        <source>a half swing</source>
        <translation>半次摆动</translation>
    </message>
    <message>
        <source>a load takes %1 of what P makes of a step, at most 10 %</source>
        <translation>负载占去 P 由阶跃产生的输出的 %1，最多允许 10 %</translation>
    </message>
    <message>
        <source>a motor is driven on this line</source>
        <translation>此线路上正在驱动一台电机</translation>
    </message>
    <message>
        <source>a motor is driven on this line at %1 bit/s, and this node has another rate</source>
        <translation>此线路上正以 %1 bit/s 驱动一台电机，而此节点使用其他速率</translation>
    </message>
    <message>
        <source>a name has 1 to 64 characters</source>
        <translation>名称为 1 到 64 个字符</translation>
    </message>
    <message>
        <source>a name may hold Latin-1 characters only</source>
        <translation>名称只能包含 Latin-1 字符</translation>
    </message>
    <message>
        <source>a node id is 1 … 127</source>
        <translation>节点 ID 为 1 … 127</translation>
    </message>
    <message>
        <source>a parenthesis is not closed</source>
        <translation>括号未闭合</translation>
    </message>
    <message>
        <source>a part of them is in force after a restart only</source>
        <translation>其中一部分在重新启动后才生效</translation>
    </message>
    <message>
        <source>a profile has up to 100000 counts/s and 1000000 counts/s²</source>
        <translation>轮廓最大为 100000 counts/s 和 1000000 counts/s²</translation>
    </message>
    <message>
        <source>a push has fewer than 8 positions</source>
        <translation>某次推动的位置点少于 8 个</translation>
    </message>
    <message>
        <source>a push moved the motor by fewer than 50 counts</source>
        <translation>某次推动使电机移动不足 50 个计数</translation>
    </message>
    <message>
        <source>a push of %1 duty drew %2 A, more than half of what is allowed</source>
        <translation>占空比 %1 的推动消耗 %2 A，超过允许值的一半</translation>
    </message>
    <message>
        <source>a rate is a positive number, or 0 for the usual one</source>
        <translation>频率为正数，或 0 表示常规频率</translation>
    </message>
    <message>
        <source>a recipe is a JSON object</source>
        <translation>配方是 JSON 对象</translation>
    </message>
    <message>
        <source>a record of type %1 has %2 data bytes, not %3</source>
        <translation>类型 %1 的记录有 %2 个数据字节，而非 %3</translation>
    </message>
    <message>
        <source>a relative move was not answered, and is never sent twice: look where the motor stands</source>
        <translation>相对运动未得到应答，且绝不会发送两次：请查看电机停在何处</translation>
    </message>
    <message>
        <source>a reserved bit</source>
        <translation>保留位</translation>
    </message>
    <message>
        <source>a scan of the recording lists who does</source>
        <translation>扫描该记录可列出有哪些设备</translation>
    </message>
    <message>
        <source>a simulated Abstract DC Drive</source>
        <translation>仿真的 Abstract DC Drive</translation>
    </message>
    <message>
        <source>a simulated DMC60C</source>
        <translation>仿真的 DMC60C</translation>
    </message>
    <message>
        <source>a simulated QuadQuad2Drv</source>
        <translation>仿真的 QuadQuad2Drv</translation>
    </message>
    <message>
        <source>a simulated Supermodified</source>
        <translation>仿真的 Supermodified</translation>
    </message>
    <message>
        <source>a step from the wrong place could be far too large</source>
        <translation>从错误位置出发的阶跃可能过大</translation>
    </message>
    <message>
        <source>a step of %1 counts overflows the loop of this firmware</source>
        <translation>%1 个计数的阶跃会使此固件的回路溢出</translation>
    </message>
    <message>
        <source>a step of %1 counts with P %2, D %3</source>
        <translation>%1 个计数的阶跃，P %2，D %3</translation>
    </message>
    <message>
        <source>a step of %1 counts with the gains as they are</source>
        <translation>%1 个计数的阶跃，使用现有增益</translation>
    </message>
    <message>
        <source>a stop went first</source>
        <translation>停止命令优先</translation>
    </message>
    <message>
        <source>a swing</source>
        <translation>一次摆动</translation>
    </message>
    <message>
        <source>a temporary file for %1 cannot be written: %2</source>
        <translation>无法写入用于 %1 的临时文件：%2</translation>
    </message>
    <message>
        <source>a time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>a trial that is not kept</source>
        <translation>不保留的试验</translation>
    </message>
    <message>
        <source>a unit that has a serial number needs no tag</source>
        <translation>有序列号的设备不需要标签</translation>
    </message>
    <message>
        <source>travel</source>
        <translation>行程</translation>
    </message>
    <message>
        <source>accepted</source>
        <translation>已接受</translation>
    </message>
    <message>
        <source>active error flag</source>
        <translation>主动错误标志</translation>
    </message>
    <message>
        <source>add --via %1</source>
        <translation>添加 --via %1</translation>
    </message>
    <message>
        <source>add --via openocd:INTERFACE --target f1|f4, such as --via openocd:stlink --target f1</source>
        <translation>添加 --via openocd:INTERFACE --target f1|f4，例如 --via openocd:stlink --target f1</translation>
    </message>
    <message>
        <source>add ready=CHIP:LINE to the address</source>
        <translation>在地址中添加 ready=CHIP:LINE</translation>
    </message>
    <message>
        <source>add reset=CHIP:LINE to the address</source>
        <translation>在地址中添加 reset=CHIP:LINE</translation>
    </message>
    <message>
        <source>address %1 is %2 here and %3 in line %4</source>
        <translation>地址 %1 在此处为 %2，在第 %4 行为 %3</translation>
    </message>
    <message>
        <source>aim for a calmer loop</source>
        <translation>选用更平缓的回路</translation>
    </message>
    <message>
        <source>all %1 read</source>
        <translation>已读取全部 %1 项</translation>
    </message>
    <message>
        <source>all pages are in the unit</source>
        <translation>所有页均已在设备中</translation>
    </message>
    <message>
        <source>allow CAN sockets in the container or sandbox</source>
        <translation>在容器或沙箱中允许 CAN 套接字</translation>
    </message>
    <message>
        <source>allow it more power, or free its shaft</source>
        <translation>允许更大功率，或使其轴能自由转动</translation>
    </message>
    <message>
        <source>allow more current</source>
        <translation>允许更大电流</translation>
    </message>
    <message>
        <source>allow more current or duty</source>
        <translation>允许更大电流或占空比</translation>
    </message>
    <message>
        <source>allow more duty</source>
        <translation>允许更大占空比</translation>
    </message>
    <message>
        <source>allow more speed</source>
        <translation>允许更高速度</translation>
    </message>
    <message>
        <source>allow more travel</source>
        <translation>允许更大行程</translation>
    </message>
    <message>
        <source>allow more travel or duty</source>
        <translation>允许更大行程或占空比</translation>
    </message>
    <message>
        <source>allow more travel or speed</source>
        <translation>允许更大行程或速度</translation>
    </message>
    <message>
        <source>allow more, then close and open the link</source>
        <translation>允许更多，然后关闭并打开链路</translation>
    </message>
    <message>
        <source>allow them in the container or sandbox</source>
        <translation>在容器或沙箱中允许它们</translation>
    </message>
    <message>
        <source>an Abstract DC Drive cannot be asked for its settings</source>
        <translation>无法向 Abstract DC Drive 查询其设置</translation>
    </message>
    <message>
        <source>an Abstract DC Drive has an offset from 0 to 99, not %1</source>
        <translation>Abstract DC Drive 的偏移量为 0 到 99，而非 %1</translation>
    </message>
    <message>
        <source>an Abstract DC Drive has no mode &apos;%1&apos;</source>
        <translation>Abstract DC Drive 没有模式“%1”</translation>
    </message>
    <message>
        <source>an Abstract DC Drive is written through a debug probe</source>
        <translation>Abstract DC Drive 通过调试探针写入</translation>
    </message>
    <message>
        <source>an answer of %1 bytes</source>
        <translation>%1 字节的应答</translation>
    </message>
    <message>
        <source>an axis from 1 to 4 and a power limit above 0 are needed</source>
        <translation>需要 1 到 4 的轴和大于 0 的功率限值</translation>
    </message>
    <message>
        <source>an experiment is run once at least</source>
        <translation>实验至少运行一次</translation>
    </message>
    <message>
        <source>another master drives %1</source>
        <translation>另一主站正在驱动 %1</translation>
    </message>
    <message>
        <source>another master sends control frames to this device</source>
        <translation>另一主站正在向此设备发送控制帧</translation>
    </message>
    <message>
        <source>another program or controller drives this unit</source>
        <translation>另一程序或控制器正在驱动此设备</translation>
    </message>
    <message>
        <source>answers again</source>
        <translation>重新应答</translation>
    </message>
    <message>
        <source>arbitration lost</source>
        <translation>仲裁丢失</translation>
    </message>
    <message>
        <source>arbitration lost at bit %1</source>
        <translation>在位 %1 处仲裁丢失</translation>
    </message>
    <message>
        <source>arm again</source>
        <translation>重新解锁</translation>
    </message>
    <message>
        <source>arm it first</source>
        <translation>先解锁它</translation>
    </message>
    <message>
        <source>arrived damaged, nothing was erased</source>
        <translation>到达时已损坏，未擦除任何内容</translation>
    </message>
    <message>
        <source>asking for the version</source>
        <translation>正在查询版本</translation>
    </message>
    <message>
        <source>assign one before it is driven</source>
        <translation>驱动之前请分配一个</translation>
    </message>
    <message>
        <source>at most %1 with its P: use a profiled mode or several moves</source>
        <translation>以其 P 值最大为 %1：请使用轮廓模式或分多次运动</translation>
    </message>
    <message>
        <source>average takes 0 to 3600 seconds, not &apos;%1&apos;</source>
        <translation>average 接受 0 至 3600 秒，而非“%1”</translation>
    </message>
    <message>
        <source>average takes a signal and seconds, such as average(x, 0.1)</source>
        <translation>average 接受一个信号和秒数，例如 average(x, 0.1)</translation>
    </message>
    <message>
        <source>avrdude ended without saying why</source>
        <translation>avrdude 未说明原因即结束</translation>
    </message>
    <message>
        <source>avrdude had the port</source>
        <translation>端口曾被 avrdude 占用</translation>
    </message>
    <message>
        <source>avrdude is not installed</source>
        <translation>avrdude 未安装</translation>
    </message>
    <message>
        <source>avrdude read back all %1 bytes and they are equal, but the controller does not answer; cut its power for a moment, and scan: a new firmware may have another rate or node id</source>
        <translation>avrdude 已回读全部 %1 字节且一致，但控制器无应答；请短暂切断其电源再扫描：新固件可能使用其他速率或节点 ID</translation>
    </message>
    <message>
        <source>avrdude read back all %1 bytes and they are equal; the controller answers again, dialect %2</source>
        <translation>avrdude 已回读全部 %1 字节且一致；控制器重新应答，方言 %2</translation>
    </message>
    <message>
        <source>baud, format, rs485 and echo are known</source>
        <translation>已知的有 baud、format、rs485 和 echo</translation>
    </message>
    <message>
        <source>become a member of its group</source>
        <translation>加入其用户组</translation>
    </message>
    <message>
        <source>begin another recipe, or another bus</source>
        <translation>开始另一个配方，或另一条总线</translation>
    </message>
    <message>
        <source>bit error</source>
        <translation>位错误</translation>
    </message>
    <message>
        <source>boot= names a serial link, such as pty:./boot</source>
        <translation>boot= 指定一个串行链路，例如 pty:./boot</translation>
    </message>
    <message>
        <source>bootloader</source>
        <translation>引导程序</translation>
    </message>
    <message>
        <source>bring it to rest first</source>
        <translation>先使其静止</translation>
    </message>
    <message>
        <source>bring it up</source>
        <translation>将其启用</translation>
    </message>
    <message>
        <source>bring it up as a full member</source>
        <translation>将其作为完整节点启用</translation>
    </message>
    <message>
        <source>bus error</source>
        <translation>总线错误</translation>
    </message>
    <message>
        <source>bus overload</source>
        <translation>总线过载</translation>
    </message>
    <message>
        <source>bus-off</source>
        <translation>总线关闭</translation>
    </message>
    <message>
        <source>bus-off: %1 left the bus after too many errors</source>
        <translation>总线关闭：%1 因错误过多退出总线</translation>
    </message>
    <message>
        <source>bus-off: the adapter left the bus after too many errors</source>
        <translation>总线关闭：适配器因错误过多退出总线</translation>
    </message>
    <message>
        <source>bus-off: the controller left the bus after too many errors</source>
        <translation>总线关闭：CAN 控制器因错误过多退出总线</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>已取消</translation>
    </message>
    <message>
        <source>cannot be read (system error %1)</source>
        <translation>无法读取（系统错误 %1）</translation>
    </message>
    <message>
        <source>change its mode, or copy it</source>
        <translation>更改其权限模式，或复制它</translation>
    </message>
    <message>
        <source>check its rights</source>
        <translation>检查其权限</translation>
    </message>
    <message>
        <source>check that somebody else is on the bus</source>
        <translation>检查总线上是否还有其他设备</translation>
    </message>
    <message>
        <source>check the cable, both 120 Ω resistors, and that no number is taken twice</source>
        <translation>检查电缆、两个 120 Ω 电阻，以及编号有无重复</translation>
    </message>
    <message>
        <source>check the cables and try again</source>
        <translation>检查电缆并重试</translation>
    </message>
    <message>
        <source>check the disk</source>
        <translation>检查磁盘</translation>
    </message>
    <message>
        <source>check the jumper AUX1–AUX2, the crossed wires TX and RX, and the 3.3 V levels, then reset the board</source>
        <translation>检查跳线 AUX1–AUX2、交叉的 TX 和 RX 导线以及 3.3 V 电平，然后复位板卡</translation>
    </message>
    <message>
        <source>check the path</source>
        <translation>检查路径</translation>
    </message>
    <message>
        <source>check the probe and try again</source>
        <translation>检查探针并重试</translation>
    </message>
    <message>
        <source>check the rights of the folder above it</source>
        <translation>检查其上级文件夹的权限</translation>
    </message>
    <message>
        <source>check wiring, termination and bit rate</source>
        <translation>检查接线、终端电阻和比特率</translation>
    </message>
    <message>
        <source>check wiring, termination and bit rate, then</source>
        <translation>检查接线、终端电阻和比特率，然后</translation>
    </message>
    <message>
        <source>check wiring, termination and bit rate, then reconnect</source>
        <translation>检查接线、终端电阻和比特率，然后重新连接</translation>
    </message>
    <message>
        <source>check wiring, termination and bit rate; it starts again by itself</source>
        <translation>检查接线、终端电阻和比特率；它会自动重新开始</translation>
    </message>
    <message>
        <source>checksum is %1, %2 is needed</source>
        <translation>校验和为 %1，应为 %2</translation>
    </message>
    <message>
        <source>chirp: %1 s hold no whole swing of %2 Hz</source>
        <translation>扫频：%1 s 内不足 %2 Hz 的一个完整摆动</translation>
    </message>
    <message>
        <source>choose a smaller --size</source>
        <translation>选择更小的 --size</translation>
    </message>
    <message>
        <source>choose another folder</source>
        <translation>选择其他文件夹</translation>
    </message>
    <message>
        <source>choose another one</source>
        <translation>选择另一个</translation>
    </message>
    <message>
        <source>choose another path</source>
        <translation>选择其他路径</translation>
    </message>
    <message>
        <source>choose another place</source>
        <translation>选择其他位置</translation>
    </message>
    <message>
        <source>close that one first (&apos;fuser %1&apos; names it)</source>
        <translation>先关闭那个程序（“fuser %1”可显示其名称）</translation>
    </message>
    <message>
        <source>close the jumper between AUX1 and AUX2, then reset the board or switch it off and on</source>
        <translation>插上 AUX1 与 AUX2 之间的跳线，然后复位板卡或将其断电再上电</translation>
    </message>
    <message>
        <source>control is locked until one has another number</source>
        <translation>在其中一台改用其他编号之前，控制被锁定</translation>
    </message>
    <message>
        <source>copy the recording to another one</source>
        <translation>将该记录复制到另一磁盘</translation>
    </message>
    <message>
        <source>current</source>
        <translation>电流</translation>
    </message>
    <message>
        <source>current %1 A is above 1.5 × %2 A</source>
        <translation>电流 %1 A 高于 1.5 × %2 A</translation>
    </message>
    <message>
        <source>current was above %1 A for %2</source>
        <translation>电流高于 %1 A 达 %2</translation>
    </message>
    <message>
        <source>cut the power if the motor still turns</source>
        <translation>若电机仍在转动，请切断电源</translation>
    </message>
    <message>
        <source>delete it, the value says the same</source>
        <translation>删除它，值的含义相同</translation>
    </message>
    <message>
        <source>delete the one of the two that is old</source>
        <translation>删除两者中较旧的一个</translation>
    </message>
    <message>
        <source>derivative and integral take one signal</source>
        <translation>derivative 和 integral 接受一个信号</translation>
    </message>
    <message>
        <source>dialect LL has no code for stop</source>
        <translation>方言 LL 没有停止代码</translation>
    </message>
    <message>
        <source>do it again</source>
        <translation>再做一次</translation>
    </message>
    <message>
        <source>does not answer any more</source>
        <translation>不再应答</translation>
    </message>
    <message>
        <source>dominant bit not sent</source>
        <translation>显性位未发送</translation>
    </message>
    <message>
        <source>dry run: %1 lines would be sent over %2</source>
        <translation>试运行：将通过 %2 发送 %1 行</translation>
    </message>
    <message>
        <source>dry run: %1 pages would be written</source>
        <translation>试运行：将写入 %1 页</translation>
    </message>
    <message>
        <source>dry run: %1 pages would be written, version %2</source>
        <translation>试运行：将写入 %1 页，版本 %2</translation>
    </message>
    <message>
        <source>duty</source>
        <translation>占空比</translation>
    </message>
    <message>
        <source>duty %1 % is above %2 %</source>
        <translation>占空比 %1 % 高于 %2 %</translation>
    </message>
    <message>
        <source>duty %1 ± %2 %, at most %3 counts/s, %4 counts one way, %5 s</source>
        <translation>占空比 %1 ± %2 %，最大 %3 counts/s，单方向 %4 counts，%5 s</translation>
    </message>
    <message>
        <source>duty is a fraction from −1 to 1</source>
        <translation>占空比为 −1 到 1 的小数</translation>
    </message>
    <message>
        <source>enable SPI in the device tree (on a Raspberry Pi: dtparam=spi=on) and restart</source>
        <translation>在设备树中启用 SPI（在 Raspberry Pi 上：dtparam=spi=on）并重新启动</translation>
    </message>
    <message>
        <source>end it in .pdf or .html</source>
        <translation>使其以 .pdf 或 .html 结尾</translation>
    </message>
    <message>
        <source>end it in .png, .svg or .pdf</source>
        <translation>使其以 .png、.svg 或 .pdf 结尾</translation>
    </message>
    <message>
        <source>end that first</source>
        <translation>先结束那个</translation>
    </message>
    <message>
        <source>end that one first, or choose another path</source>
        <translation>先结束那个，或选择其他路径</translation>
    </message>
    <message>
        <source>ending=%1: legal are cr, lf and crlf</source>
        <translation>ending=%1：允许值为 cr、lf 和 crlf</translation>
    </message>
    <message>
        <source>error</source>
        <translation>错误</translation>
    </message>
    <message>
        <source>error-active</source>
        <translation>错误主动</translation>
    </message>
    <message>
        <source>error-passive</source>
        <translation>错误被动</translation>
    </message>
    <message>
        <source>error-warning</source>
        <translation>错误警告</translation>
    </message>
    <message>
        <source>every id that this program could use on the line belongs to the group of a node, so answers would be taken for commands; set node.mask to 255 and restart the nodes</source>
        <translation>本程序在线路上可用的每个 ID 都属于某个节点的组，应答会被当作命令；请将 node.mask 设为 255 并重新启动各节点</translation>
    </message>
    <message>
        <source>every line was confirmed, and the board answers with version %1</source>
        <translation>每行均已确认，板卡以版本 %1 应答</translation>
    </message>
    <message>
        <source>every line was confirmed, and the board answers with version %1, the same as before, so that nothing proves the new firmware</source>
        <translation>每行均已确认，板卡以版本 %1 应答，与之前相同，因此无法证实新固件</translation>
    </message>
    <message>
        <source>every line was confirmed, but the board does not answer over SPI</source>
        <translation>每行均已确认，但板卡在 SPI 上无应答</translation>
    </message>
    <message>
        <source>exchange the wires of the motor or the phases of the encoder</source>
        <translation>对调电机的导线或编码器的相线</translation>
    </message>
    <message>
        <source>exchange the wires of the motor or the phases of the encoder before any loop is closed</source>
        <translation>在闭合任何回路之前，对调电机的导线或编码器的相线</translation>
    </message>
    <message>
        <source>expected time, channel, value and unit</source>
        <translation>应为时间、通道、值和单位</translation>
    </message>
    <message>
        <source>fault &apos;%1&apos; does not parse</source>
        <translation>无法解析故障“%1”</translation>
    </message>
    <message>
        <source>fewer than 16 samples connect</source>
        <translation>连续采样不足 16 个</translation>
    </message>
    <message>
        <source>find it by listening only</source>
        <translation>仅通过监听来查找</translation>
    </message>
    <message>
        <source>find its gain scales first: Overview, Find the gain scales</source>
        <translation>先求取其增益比例：“概览”、“求取增益比例”</translation>
    </message>
    <message>
        <source>find the sender that fills it, on the Bus page or with &apos;motorbenchctl monitor&apos;</source>
        <translation>在“总线”页面或用“motorbenchctl monitor”找出占满总线的发送者</translation>
    </message>
    <message>
        <source>firmware update</source>
        <translation>固件更新</translation>
    </message>
    <message>
        <source>firmware: %1</source>
        <translation>固件：%1</translation>
    </message>
    <message>
        <source>follow needs the number of a device</source>
        <translation>跟随模式需要一个设备编号</translation>
    </message>
    <message>
        <source>form error</source>
        <translation>格式错误</translation>
    </message>
    <message>
        <source>found on %1</source>
        <translation>在 %1 上找到</translation>
    </message>
    <message>
        <source>free the shaft and see that no brake is on, then test again</source>
        <translation>使轴能自由转动并检查没有制动器作用，然后重新测试</translation>
    </message>
    <message>
        <source>frequency response: %1</source>
        <translation>频率响应：%1</translation>
    </message>
    <message>
        <source>friction takes %1 duty of pushes of %2</source>
        <translation>在 %2 的推动中，摩擦占去 %1 占空比</translation>
    </message>
    <message>
        <source>friction takes %1 of what P makes of a step, at most 60 %</source>
        <translation>摩擦占去 P 由阶跃产生的输出的 %1，最多允许 60 %</translation>
    </message>
    <message>
        <source>gave no sign after the stop</source>
        <translation>停止后没有任何反应</translation>
    </message>
    <message>
        <source>gave no sign after the stop; its own watchdog switches it off</source>
        <translation>停止后没有任何反应；其自身的看门狗会将其关闭</translation>
    </message>
    <message>
        <source>give %1</source>
        <translation>请给出 %1</translation>
    </message>
    <message>
        <source>keep what is tried, or name a notebook that can be written</source>
        <translation>保留所试的值，或给出可写入的试验记录本</translation>
    </message>
    <message>
        <source>give it a longer time</source>
        <translation>给它更长的时间</translation>
    </message>
    <message>
        <source>give a name that ends in .png, .svg or .pdf</source>
        <translation>给出以 .png、.svg 或 .pdf 结尾的名称</translation>
    </message>
    <message>
        <source>give a recording, or --help for what else there is</source>
        <translation>给出一个记录，或用 --help 查看其他选项</translation>
    </message>
    <message>
        <source>give another target</source>
        <translation>给出另一个目标</translation>
    </message>
    <message>
        <source>give at least %1 s</source>
        <translation>至少给出 %1 s</translation>
    </message>
    <message>
        <source>give it a new one, or switch it off and on</source>
        <translation>给它一个新的，或将其断电再上电</translation>
    </message>
    <message>
        <source>give it a number first, or take the self-test out of the recipe</source>
        <translation>先给它一个编号，或从配方中去掉自检</translation>
    </message>
    <message>
        <source>gpiodetect lists those there are</source>
        <translation>gpiodetect 可列出现有的</translation>
    </message>
    <message>
        <source>identify it anew</source>
        <translation>重新辨识</translation>
    </message>
    <message>
        <source>image %1 of %2 pages, unit runs %3, bootloader %4</source>
        <translation>映像 %1 有 %2 页，设备运行 %3，引导程序 %4</translation>
    </message>
    <message>
        <source>image %1 of %2 pages, unit without application, bootloader %3</source>
        <translation>映像 %1 有 %2 页，设备无应用程序，引导程序 %3</translation>
    </message>
    <message>
        <source>in bootloader %1, session kept</source>
        <translation>处于引导程序 %1，会话保持</translation>
    </message>
    <message>
        <source>in position mode a new counter would make the motor jump</source>
        <translation>在位置模式下，新的计数会使电机跳动</translation>
    </message>
    <message>
        <source>install %1</source>
        <translation>安装 %1</translation>
    </message>
    <message>
        <source>install it with</source>
        <translation>用以下命令安装</translation>
    </message>
    <message>
        <source>install its vendor&apos;s driver</source>
        <translation>安装其厂商的驱动程序</translation>
    </message>
    <message>
        <source>install the package that has it and try again</source>
        <translation>安装包含它的软件包并重试</translation>
    </message>
    <message>
        <source>installed are: %1</source>
        <translation>已安装的有：%1</translation>
    </message>
    <message>
        <source>is a directory</source>
        <translation>是目录</translation>
    </message>
    <message>
        <source>is back</source>
        <translation>已恢复</translation>
    </message>
    <message>
        <source>is gone</source>
        <translation>已不存在</translation>
    </message>
    <message>
        <source>is longer than %1 bytes</source>
        <translation>超过 %1 字节</translation>
    </message>
    <message>
        <source>is not a regular file</source>
        <translation>不是普通文件</translation>
    </message>
    <message>
        <source>is there</source>
        <translation>已存在</translation>
    </message>
    <message>
        <source>it begins with &quot;recipe&quot;: 1</source>
        <translation>它以 &quot;recipe&quot;: 1 开头</translation>
    </message>
    <message>
        <source>it begins with {</source>
        <translation>它以 { 开头</translation>
    </message>
    <message>
        <source>it came to rest %1 of the step away from its target</source>
        <translation>它停在距目标为阶跃的 %1 处</translation>
    </message>
    <message>
        <source>it cannot be tried</source>
        <translation>无法对其试验</translation>
    </message>
    <message>
        <source>it cannot be written (system error %1)</source>
        <translation>无法写入（系统错误 %1）</translation>
    </message>
    <message>
        <source>it did not come back</source>
        <translation>它没有恢复</translation>
    </message>
    <message>
        <source>it did not settle</source>
        <translation>它未稳定下来</translation>
    </message>
    <message>
        <source>it has %1</source>
        <translation>它有 %1</translation>
    </message>
    <message>
        <source>it is a Vector BLF log</source>
        <translation>这是 Vector BLF 日志</translation>
    </message>
    <message>
        <source>it is a disk</source>
        <translation>这是磁盘</translation>
    </message>
    <message>
        <source>it is a folder</source>
        <translation>这是文件夹</translation>
    </message>
    <message>
        <source>it is a recording</source>
        <translation>这是记录</translation>
    </message>
    <message>
        <source>it is not known how to stop this device from outside</source>
        <translation>不知道如何从外部停止此设备</translation>
    </message>
    <message>
        <source>it is not proven which codes it speaks, and a stop of others may start it</source>
        <translation>尚未证实它使用哪些代码，用其他代码的停止可能会启动它</translation>
    </message>
    <message>
        <source>it is not proven which codes this drive speaks</source>
        <translation>尚未证实此驱动器使用哪些代码</translation>
    </message>
    <message>
        <source>it is not proven which codes this drive speaks, and the wrong ones start it at full power</source>
        <translation>尚未证实此驱动器使用哪些代码，错误的代码会使其全功率启动</translation>
    </message>
    <message>
        <source>it may rest %1 short of its target, less does not move its integral</source>
        <translation>它可能停在距目标 %1 处，更小的偏差不会使其积分变化</translation>
    </message>
    <message>
        <source>it may rest %1 short of its target, less does not move its motor</source>
        <translation>它可能停在距目标 %1 处，更小的偏差不会使其电机运动</translation>
    </message>
    <message>
        <source>it overshot by %1, predicted were %2</source>
        <translation>它超调 %1，预测为 %2</translation>
    </message>
    <message>
        <source>it swung itself up with P %1 and D %2</source>
        <translation>在 P %1 和 D %2 下它自行振荡增大</translation>
    </message>
    <message>
        <source>it took %1 to settle, predicted were %2</source>
        <translation>它稳定用了 %1，预测为 %2</translation>
    </message>
    <message>
        <source>it took longer than 1.5 × %1 s</source>
        <translation>用时超过 1.5 × %1 s</translation>
    </message>
    <message>
        <source>it was put aside as %1, and what it kept of the device is unknown again</source>
        <translation>它已移开为 %1，其中关于该设备的信息重新变为未知</translation>
    </message>
    <message>
        <source>it was stopped</source>
        <translation>它已停止</translation>
    </message>
    <message>
        <source>it would stop %1 counts from the start, %2 are allowed</source>
        <translation>它将停在距起点 %1 个计数处，允许 %2</translation>
    </message>
    <message>
        <source>its P or its position is not known, so whether this step overflows its loop is not either</source>
        <translation>其 P 或位置未知，因此也无法得知此阶跃是否会使其回路溢出</translation>
    </message>
    <message>
        <source>its address is not a number</source>
        <translation>其地址不是数值</translation>
    </message>
    <message>
        <source>its dialect is not known</source>
        <translation>其方言未知</translation>
    </message>
    <message>
        <source>its dialect is not known yet</source>
        <translation>其方言尚未知</translation>
    </message>
    <message>
        <source>its dialect is not known, so no move can be sent</source>
        <translation>其方言未知，因此无法发送运动</translation>
    </message>
    <message>
        <source>its error level is 1, which makes every reading fail: set error.level to 0</source>
        <translation>其错误级别为 1，会使每次读取失败：请将 error.level 设为 0</translation>
    </message>
    <message>
        <source>its motor is turning or driven already</source>
        <translation>其电机正在转动或已被驱动</translation>
    </message>
    <message>
        <source>its position is not known yet</source>
        <translation>其位置尚未知</translation>
    </message>
    <message>
        <source>its profile is not known, so a move that passes its target could not be told</source>
        <translation>其轮廓未知，因此无法判断运动是否越过目标</translation>
    </message>
    <message>
        <source>its reader has gone</source>
        <translation>其读取方已不存在</translation>
    </message>
    <message>
        <source>known are %1</source>
        <translation>已知的有 %1</translation>
    </message>
    <message>
        <source>leave it out</source>
        <translation>略去它</translation>
    </message>
    <message>
        <source>leave out --target</source>
        <translation>略去 --target</translation>
    </message>
    <message>
        <source>leave out erasing them</source>
        <translation>略去对它们的擦除</translation>
    </message>
    <message>
        <source>leave out interface=</source>
        <translation>略去 interface=</translation>
    </message>
    <message>
        <source>leave the other way in out</source>
        <translation>略去另一种接入途径</translation>
    </message>
    <message>
        <source>leave the target out</source>
        <translation>略去目标</translation>
    </message>
    <message>
        <source>legal is %1</source>
        <translation>允许值为 %1</translation>
    </message>
    <message>
        <source>legal is 0.01 … 1000, or max</source>
        <translation>允许值为 0.01 … 1000，或 max</translation>
    </message>
    <message>
        <source>legal is 1 … 500</source>
        <translation>允许值为 1 … 500</translation>
    </message>
    <message>
        <source>limit %1</source>
        <translation>限值 %1</translation>
    </message>
    <message>
        <source>limits %1 … %2</source>
        <translation>限值 %1 … %2</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>第 %1 行</translation>
    </message>
    <message>
        <source>line %1 is neither a line of candump -L nor the beginning of a Vector ASC log</source>
        <translation>第 %1 行既不是 candump -L 的行，也不是 Vector ASC 日志的开头</translation>
    </message>
    <message>
        <source>line %1 is not a line of a Vector ASC log</source>
        <translation>第 %1 行不是 Vector ASC 日志的行</translation>
    </message>
    <message>
        <source>line %1 is not a line of candump -L</source>
        <translation>第 %1 行不是 candump -L 的行</translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>第 %1 行：%2</translation>
    </message>
    <message>
        <source>link option %1=%2 is out of range</source>
        <translation>链路选项 %1=%2 超出范围</translation>
    </message>
    <message>
        <source>link option &apos;%1&apos; is not KEY=VALUE</source>
        <translation>链路选项“%1”不是 KEY=VALUE</translation>
    </message>
    <message>
        <source>link option bitrate=%1 is out of range</source>
        <translation>链路选项 bitrate=%1 超出范围</translation>
    </message>
    <message>
        <source>listen-only: nothing can be sent</source>
        <translation>仅监听：无法发送任何内容</translation>
    </message>
    <message>
        <source>load it</source>
        <translation>加载它</translation>
    </message>
    <message>
        <source>look at brushes, plugs and leads, then test again</source>
        <translation>检查电刷、插头和引线，然后重新测试</translation>
    </message>
    <message>
        <source>look at it again</source>
        <translation>请复查</translation>
    </message>
    <message>
        <source>look at the cable and test again</source>
        <translation>检查电缆并重新测试</translation>
    </message>
    <message>
        <source>look at the plug and the polarity of encoder and motor, then test again</source>
        <translation>检查插头以及编码器和电机的极性，然后重新测试</translation>
    </message>
    <message>
        <source>look at the wiring of the input</source>
        <translation>检查输入的接线</translation>
    </message>
    <message>
        <source>look for units again</source>
        <translation>重新查找设备</translation>
    </message>
    <message>
        <source>look whether something brakes or limits the motor</source>
        <translation>检查是否有什么在制动或限制电机</translation>
    </message>
    <message>
        <source>looking at the status bit</source>
        <translation>正在查看状态位</translation>
    </message>
    <message>
        <source>looking for position D</source>
        <translation>正在查找位置 D</translation>
    </message>
    <message>
        <source>looking for position I</source>
        <translation>正在查找位置 I</translation>
    </message>
    <message>
        <source>looking for position P</source>
        <translation>正在查找位置 P</translation>
    </message>
    <message>
        <source>looking for velocity I</source>
        <translation>正在查找速度 I</translation>
    </message>
    <message>
        <source>looking for velocity P</source>
        <translation>正在查找速度 P</translation>
    </message>
    <message>
        <source>lower the gains or the steps</source>
        <translation>减小增益或阶跃</translation>
    </message>
    <message>
        <source>made way for an order</source>
        <translation>已让位于一条命令</translation>
    </message>
    <message>
        <source>make room in %1</source>
        <translation>在 %1 中腾出空间</translation>
    </message>
    <message>
        <source>make room, or choose another place</source>
        <translation>腾出空间，或选择其他位置</translation>
    </message>
    <message>
        <source>more bytes than the device announced</source>
        <translation>字节数超过设备声明的数量</translation>
    </message>
    <message>
        <source>more columns than the first line has</source>
        <translation>列数多于第一行</translation>
    </message>
    <message>
        <source>more than 1000 channels</source>
        <translation>超过 1000 个通道</translation>
    </message>
    <message>
        <source>move it away</source>
        <translation>将其移走</translation>
    </message>
    <message>
        <source>name a file</source>
        <translation>请指定文件</translation>
    </message>
    <message>
        <source>name a firmware in the recipe</source>
        <translation>在配方中指定固件</translation>
    </message>
    <message>
        <source>name a recording</source>
        <translation>请指定记录</translation>
    </message>
    <message>
        <source>name another folder</source>
        <translation>请指定其他文件夹</translation>
    </message>
    <message>
        <source>name it by its number; &apos;motorbenchctl snapshots&apos; lists them</source>
        <translation>用其编号指定；“motorbenchctl snapshots”可列出它们</translation>
    </message>
    <message>
        <source>name its serial port, for example --via serial:/dev/ttyUSB0</source>
        <translation>指定其串口，例如 --via serial:/dev/ttyUSB0</translation>
    </message>
    <message>
        <source>name one such as /dev/ttyUSB0</source>
        <translation>指定一个，例如 /dev/ttyUSB0</translation>
    </message>
    <message>
        <source>name one, such as sim:can</source>
        <translation>指定一个，例如 sim:can</translation>
    </message>
    <message>
        <source>name one: %1 or %2</source>
        <translation>指定一个：%1 或 %2</translation>
    </message>
    <message>
        <source>no %1 answers as number %2 on %3</source>
        <translation>%3 上没有以编号 %2 应答的 %1</translation>
    </message>
    <message>
        <source>no %1 sends as number %2 in %3</source>
        <translation>%3 中没有以编号 %2 发送的 %1</translation>
    </message>
    <message>
        <source>no CAN frame: its identifier or size is out of range</source>
        <translation>不是 CAN 帧：其标识符或长度超出范围</translation>
    </message>
    <message>
        <source>no D was found with which a small P neither swings nor creeps</source>
        <translation>未找到能使小的 P 既不摆动也不爬行的 D</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>无应答</translation>
    </message>
    <message>
        <source>no application runs in this unit</source>
        <translation>此设备没有应用程序在运行</translation>
    </message>
    <message>
        <source>no bootloader answers at %1 bit/s</source>
        <translation>没有引导程序以 %1 bit/s 应答</translation>
    </message>
    <message>
        <source>no data in page 0 (0x00000-0x00FFF), the file is not a whole application</source>
        <translation>第 0 页 (0x00000-0x00FFF) 没有数据，文件不是完整的应用程序</translation>
    </message>
    <message>
        <source>no data in page 30 (0x1E000-0x1EFFF), where the version is</source>
        <translation>第 30 页 (0x1E000-0x1EFFF) 没有数据，版本信息应在此处</translation>
    </message>
    <message>
        <source>no experiment: %1</source>
        <translation>没有实验：%1</translation>
    </message>
    <message>
        <source>no gain of the position loop turns the motor</source>
        <translation>位置环没有任何增益能使电机转动</translation>
    </message>
    <message>
        <source>no gain of the velocity loop turns the motor</source>
        <translation>速度环没有任何增益能使电机转动</translation>
    </message>
    <message>
        <source>no guardian came within two seconds</source>
        <translation>两秒内没有守护进程出现</translation>
    </message>
    <message>
        <source>no guardian can be started: %1</source>
        <translation>无法启动守护进程：%1</translation>
    </message>
    <message>
        <source>no history is kept here</source>
        <translation>此处不保留历史</translation>
    </message>
    <message>
        <source>no instruction at the entry point 0x00400</source>
        <translation>入口点 0x00400 处没有指令</translation>
    </message>
    <message>
        <source>no number: server silent</source>
        <translation>无编号：服务器无响应</translation>
    </message>
    <message>
        <source>no object at the top</source>
        <translation>顶层没有对象</translation>
    </message>
    <message>
        <source>no permission to open CAN sockets here</source>
        <translation>没有在此打开 CAN 套接字的权限</translation>
    </message>
    <message>
        <source>no permission to read it</source>
        <translation>没有读取它的权限</translation>
    </message>
    <message>
        <source>no permission to use %1</source>
        <translation>没有使用 %1 的权限</translation>
    </message>
    <message>
        <source>no permission to write there</source>
        <translation>没有在该处写入的权限</translation>
    </message>
    <message>
        <source>no pseudo terminal can be had: %1</source>
        <translation>无法获得伪终端：%1</translation>
    </message>
    <message>
        <source>no push met the current limit</source>
        <translation>没有任何推动达到电流限值</translation>
    </message>
    <message>
        <source>no ready line is wired</source>
        <translation>未接就绪线</translation>
    </message>
    <message>
        <source>no reset line is wired</source>
        <translation>未接复位线</translation>
    </message>
    <message>
        <source>no sample for %1</source>
        <translation>已 %1 无采样</translation>
    </message>
    <message>
        <source>no snapshot of what was found: %1</source>
        <translation>未对初始状态建立快照：%1</translation>
    </message>
    <message>
        <source>no snapshot of what was there: %1</source>
        <translation>未对原有内容建立快照：%1</translation>
    </message>
    <message>
        <source>no snapshot: %1</source>
        <translation>无快照：%1</translation>
    </message>
    <message>
        <source>no snapshots are kept here</source>
        <translation>此处不保留快照</translation>
    </message>
    <message>
        <source>no status within 2 s</source>
        <translation>2 s 内无状态</translation>
    </message>
    <message>
        <source>no step met the end of the output</source>
        <translation>没有任何阶跃达到输出的极限</translation>
    </message>
    <message>
        <source>no such file</source>
        <translation>没有此文件</translation>
    </message>
    <message>
        <source>no version at 0x1EFFC</source>
        <translation>0x1EFFC 处没有版本</translation>
    </message>
    <message>
        <source>nobody acknowledged</source>
        <translation>无人确认</translation>
    </message>
    <message>
        <source>nobody acknowledges what %1 sends</source>
        <translation>%1 发送的内容无人确认</translation>
    </message>
    <message>
        <source>nobody reads from this pipe</source>
        <translation>无人读取此管道</translation>
    </message>
    <message>
        <source>nobody renewed the motion lease</source>
        <translation>无人续期运动租约</translation>
    </message>
    <message>
        <source>nobody serves %1</source>
        <translation>无人为 %1 提供服务</translation>
    </message>
    <message>
        <source>nobody watches over this self-test, and it moves the motor</source>
        <translation>此自检无人监护，而它会使电机运动</translation>
    </message>
    <message>
        <source>node %1 does not answer</source>
        <translation>节点 %1 无应答</translation>
    </message>
    <message>
        <source>node id %1 is used by another node of this line</source>
        <translation>节点 ID %1 已被此线路上的另一节点使用</translation>
    </message>
    <message>
        <source>not a parameter file: %1</source>
        <translation>不是参数文件：%1</translation>
    </message>
    <message>
        <source>not a parameter file: it has no &quot;parameters&quot;</source>
        <translation>不是参数文件：其中没有 &quot;parameters&quot;</translation>
    </message>
    <message>
        <source>not sent: %1 for %2</source>
        <translation>未发送：%1，属于 %2</translation>
    </message>
    <message>
        <source>not sent: %1 outside the controller&apos;s flash</source>
        <translation>未发送：%1，在控制器闪存之外</translation>
    </message>
    <message>
        <source>not sent: %1 where a 24-bit instruction has none, the file may be for another processor</source>
        <translation>未发送：%1 出现在 24 位指令不应有内容之处，文件可能用于其他处理器</translation>
    </message>
    <message>
        <source>nothing could put the gains back after a crash</source>
        <translation>崩溃后将无法恢复增益</translation>
    </message>
    <message>
        <source>nothing has been recorded yet</source>
        <translation>尚未记录任何内容</translation>
    </message>
    <message>
        <source>nothing to send</source>
        <translation>没有可发送的内容</translation>
    </message>
    <message>
        <source>nothing was measured</source>
        <translation>未测得任何内容</translation>
    </message>
    <message>
        <source>nothing was saved</source>
        <translation>未保存任何内容</translation>
    </message>
    <message>
        <source>nothing was written</source>
        <translation>未写入任何内容</translation>
    </message>
    <message>
        <source>nothing was written; the image fits, %1 pages</source>
        <translation>未写入任何内容；映像适合，%1 页</translation>
    </message>
    <message>
        <source>now the calm ones</source>
        <translation>现在用平缓的增益</translation>
    </message>
    <message>
        <source>number %1 is used by another unit</source>
        <translation>编号 %1 已被另一台设备使用</translation>
    </message>
    <message>
        <source>number %1 still keeps a move that was stopped before it began, and would begin it too</source>
        <translation>编号 %1 仍保留着一个在开始之前就被停止的运动，也会随之开始执行</translation>
    </message>
    <message>
        <source>one more would make the drive load something else. Erase its settings pages with a firmware update (erase settings), then save again</source>
        <translation>再保存一次会使驱动器加载其他内容。请通过固件更新（擦除设置）擦除其设置页，然后再保存</translation>
    </message>
    <message>
        <source>one update a bus: %1 is being written; nothing was sent</source>
        <translation>每条总线一次只能更新一台：正在写入 %1；未发送任何内容</translation>
    </message>
    <message>
        <source>only disturbed frames arrive on %1, the bus has another bit rate</source>
        <translation>%1 上只收到受干扰的帧，总线的比特率不同</translation>
    </message>
    <message>
        <source>only disturbed frames arrive on %1, the bus has another bit rate than %2</source>
        <translation>%1 上只收到受干扰的帧，总线的比特率不是 %2</translation>
    </message>
    <message>
        <source>only its power stops it</source>
        <translation>只有断电才能停止它</translation>
    </message>
    <message>
        <source>only those are recorded</source>
        <translation>只记录这些</translation>
    </message>
    <message>
        <source>open it again</source>
        <translation>重新打开</translation>
    </message>
    <message>
        <source>open that terminal as serial:%1</source>
        <translation>将该终端作为 serial:%1 打开</translation>
    </message>
    <message>
        <source>open the link that it was made on</source>
        <translation>打开生成它时所用的链路</translation>
    </message>
    <message>
        <source>openocd is not installed</source>
        <translation>openocd 未安装</translation>
    </message>
    <message>
        <source>option &apos;%1&apos; is not KEY=VALUE</source>
        <translation>选项“%1”不是 KEY=VALUE</translation>
    </message>
    <message>
        <source>page %1 accepted with CRC variant %2</source>
        <translation>第 %1 页以 CRC 变体 %2 被接受</translation>
    </message>
    <message>
        <source>page %1 cannot be written: its flash failed the device&apos;s own check %2 times</source>
        <translation>无法写入第 %1 页：其闪存有 %2 次未通过设备自身的检查</translation>
    </message>
    <message>
        <source>page %1 was not accepted in %2 tries</source>
        <translation>第 %1 页尝试 %2 次均未被接受</translation>
    </message>
    <message>
        <source>page %1 was said to be written before its bytes can have arrived</source>
        <translation>第 %1 页在其字节尚不可能到达时就报告已写入</translation>
    </message>
    <message>
        <source>page %1: %2, sent again</source>
        <translation>第 %1 页：%2，已重发</translation>
    </message>
    <message>
        <source>page 0: its status was lost, but the version is there; it is not written again</source>
        <translation>第 0 页：其状态丢失，但版本信息已存在；不再重写</translation>
    </message>
    <message>
        <source>pages 31-34 (configuration and descriptors)</source>
        <translation>第 31-34 页（配置和描述符）</translation>
    </message>
    <message>
        <source>pages 35-42 (bootloader and flash configuration)</source>
        <translation>第 35-42 页（引导程序和闪存配置）</translation>
    </message>
    <message>
        <source>parameters that were changed last may be lost: %1</source>
        <translation>最后更改的参数可能已丢失：%1</translation>
    </message>
    <message>
        <source>pause=%1: legal are 0 to 1000 milliseconds</source>
        <translation>pause=%1：允许值为 0 到 1000 毫秒</translation>
    </message>
    <message>
        <source>plug in an adapter</source>
        <translation>插入适配器</translation>
    </message>
    <message>
        <source>plug in an adapter at any time; it is opened by itself once it is up</source>
        <translation>可随时插入适配器；启用后会自动打开</translation>
    </message>
    <message>
        <source>plug in the adapter, or name another port</source>
        <translation>插入适配器，或指定其他端口</translation>
    </message>
    <message>
        <source>plug it in again</source>
        <translation>重新插入</translation>
    </message>
    <message>
        <source>plug one in</source>
        <translation>插入一个</translation>
    </message>
    <message>
        <source>plug the adapter in again; the link is opened by itself as soon as it is up</source>
        <translation>重新插入适配器；链路在其启用后自动打开</translation>
    </message>
    <message>
        <source>polarity 0 is active high: the board follows the maker&apos;s library</source>
        <translation>极性 0 为高电平有效：板卡遵循制造商的库</translation>
    </message>
    <message>
        <source>polarity 0 is active low: the board follows the data sheet</source>
        <translation>极性 0 为低电平有效：板卡遵循数据手册</translation>
    </message>
    <message>
        <source>polarity bit %1: the input is active</source>
        <translation>极性位 %1：输入有效</translation>
    </message>
    <message>
        <source>polarity bit %1: the input is not active</source>
        <translation>极性位 %1：输入无效</translation>
    </message>
    <message>
        <source>position D has no effect that could be measured; its scale stays unknown</source>
        <translation>位置 D 没有可测量的作用；其比例仍未知</translation>
    </message>
    <message>
        <source>position has 32 bits</source>
        <translation>位置为 32 位</translation>
    </message>
    <message>
        <source>power %1: %2 and %3 counts/s</source>
        <translation>功率 %1：%2 和 %3 counts/s</translation>
    </message>
    <message>
        <source>protocol error</source>
        <translation>协议错误</translation>
    </message>
    <message>
        <source>proving: a step of %1 A</source>
        <translation>正在验证：%1 A 的阶跃</translation>
    </message>
    <message>
        <source>proving: a step of %1 counts</source>
        <translation>正在验证：%1 counts 的阶跃</translation>
    </message>
    <message>
        <source>proving: a step of %1 counts/s</source>
        <translation>正在验证：%1 counts/s 的阶跃</translation>
    </message>
    <message>
        <source>pty links have the option baud=BITS_PER_SECOND, not &apos;%1=%2&apos;</source>
        <translation>pty 链路的选项为 baud=BITS_PER_SECOND，而非“%1=%2”</translation>
    </message>
    <message>
        <source>pty: is where &apos;simulate&apos; puts its devices</source>
        <translation>pty: 是“simulate”放置其设备之处</translation>
    </message>
    <message>
        <source>push harder or longer</source>
        <translation>更强或更久地推动</translation>
    </message>
    <message>
        <source>push longer, or ask for faster samples</source>
        <translation>更久地推动，或要求更快的采样</translation>
    </message>
    <message>
        <source>push with two sizes</source>
        <translation>以两种幅度推动</translation>
    </message>
    <message>
        <source>pushes of one size do not tell friction from gain</source>
        <translation>单一幅度的推动无法区分摩擦与增益</translation>
    </message>
    <message>
        <source>pushing with %1 duty for %2 s</source>
        <translation>正在以占空比 %1 推动 %2 s</translation>
    </message>
    <message>
        <source>pushing with %1 duty for %2 s, %3 times</source>
        <translation>正在以占空比 %1 推动 %2 s，%3 次</translation>
    </message>
    <message>
        <source>putting the settings back</source>
        <translation>正在恢复设置</translation>
    </message>
    <message>
        <source>qtcan links have the option bitrate=BITS_PER_SECOND, not &apos;%1=%2&apos;</source>
        <translation>qtcan 链路的选项为 bitrate=BITS_PER_SECOND，而非“%1=%2”</translation>
    </message>
    <message>
        <source>read gain.p</source>
        <translation>读取 gain.p</translation>
    </message>
    <message>
        <source>read it again</source>
        <translation>重新读取</translation>
    </message>
    <message>
        <source>read it first</source>
        <translation>先读取它</translation>
    </message>
    <message>
        <source>read profile.velocity and profile.acceleration</source>
        <translation>读取 profile.velocity 和 profile.acceleration</translation>
    </message>
    <message>
        <source>recessive bit not sent</source>
        <translation>隐性位未发送</translation>
    </message>
    <message>
        <source>reconnect</source>
        <translation>重新连接</translation>
    </message>
    <message>
        <source>record again</source>
        <translation>重新记录</translation>
    </message>
    <message>
        <source>record type %1 is unknown</source>
        <translation>记录类型 %1 未知</translation>
    </message>
    <message>
        <source>refused: %1</source>
        <translation>已拒绝：%1</translation>
    </message>
    <message>
        <source>remove it</source>
        <translation>移除它</translation>
    </message>
    <message>
        <source>remove it, or make it readable</source>
        <translation>移除它，或使其可读</translation>
    </message>
    <message>
        <source>remove the cause, then test again</source>
        <translation>消除原因，然后重新测试</translation>
    </message>
    <message>
        <source>replay links have no option &apos;%1&apos;</source>
        <translation>replay 链路没有选项“%1”</translation>
    </message>
    <message>
        <source>residual %1 of what counts and clocks explain, at most 3</source>
        <translation>残差为计数和时钟可解释部分的 %1，最大为 3</translation>
    </message>
    <message>
        <source>restarted, the application answers</source>
        <translation>已重新启动，应用程序应答</translation>
    </message>
    <message>
        <source>run avrdude by hand to see all it says</source>
        <translation>手动运行 avrdude 以查看其全部输出</translation>
    </message>
    <message>
        <source>run it by hand to see all it says</source>
        <translation>手动运行它以查看其全部输出</translation>
    </message>
    <message>
        <source>run it by hand with -c %1</source>
        <translation>用 -c %1 手动运行它</translation>
    </message>
    <message>
        <source>run it by hand with interface %1</source>
        <translation>用接口 %1 手动运行它</translation>
    </message>
    <message>
        <source>sample point %1 %</source>
        <translation>采样点 %1 %</translation>
    </message>
    <message>
        <source>save it as ASC and take that</source>
        <translation>将其另存为 ASC 并使用该文件</translation>
    </message>
    <message>
        <source>scan again, or choose its dialect by hand</source>
        <translation>重新扫描，或手动选择其方言</translation>
    </message>
    <message>
        <source>see that motor and load are those of the recipe, then test again</source>
        <translation>检查电机和负载是否为配方所指定的，然后重新测试</translation>
    </message>
    <message>
        <source>see that nothing is loose and that steps look alike</source>
        <translation>检查有无松动，以及各次阶跃是否相似</translation>
    </message>
    <message>
        <source>see that nothing is loose, and write gains once with which it comes to rest</source>
        <translation>检查有无松动，并写入一次能使其静止的增益</translation>
    </message>
    <message>
        <source>see that nothing is loose; a stronger load than it was built for cannot be tuned</source>
        <translation>检查有无松动；负载超过其设计能力时无法整定</translation>
    </message>
    <message>
        <source>see that the motor is connected</source>
        <translation>检查电机是否已连接</translation>
    </message>
    <message>
        <source>see that the server runs; entries wait here until it does</source>
        <translation>检查服务器是否运行；条目在此等待直到其运行</translation>
    </message>
    <message>
        <source>see that this is the motor and the encoder of the recipe, then test again</source>
        <translation>检查这是否为配方所指定的电机和编码器，然后重新测试</translation>
    </message>
    <message>
        <source>see whether a load always pulls one way</source>
        <translation>检查是否有负载始终朝一个方向拉</translation>
    </message>
    <message>
        <source>see whether brushes and plugs make contact</source>
        <translation>检查电刷和插头是否接触良好</translation>
    </message>
    <message>
        <source>select a longer stretch</source>
        <translation>选择更长的区段</translation>
    </message>
    <message>
        <source>sending the firmware</source>
        <translation>正在发送固件</translation>
    </message>
    <message>
        <source>serial number %1</source>
        <translation>序列号 %1</translation>
    </message>
    <message>
        <source>service</source>
        <translation>维护</translation>
    </message>
    <message>
        <source>several units answer as number %1</source>
        <translation>有多台设备以编号 %1 应答</translation>
    </message>
    <message>
        <source>several units answer under this number in the recording</source>
        <translation>记录中有多台设备以此编号应答</translation>
    </message>
    <message>
        <source>several units have a snapshot &apos;%1&apos;</source>
        <translation>有多台设备具有快照“%1”</translation>
    </message>
    <message>
        <source>sim: stands for several links</source>
        <translation>sim: 代表多个链路</translation>
    </message>
    <message>
        <source>simulated links belong to a bench</source>
        <translation>仿真链路属于台架</translation>
    </message>
    <message>
        <source>sine %1 of %2, %3 Hz: %4</source>
        <translation>正弦 %1 / %2，%3 Hz：%4</translation>
    </message>
    <message>
        <source>snapshot %1, %2: %3 values</source>
        <translation>快照 %1，%2：%3 个值</translation>
    </message>
    <message>
        <source>socketcan links have no option &apos;%1&apos;</source>
        <translation>socketcan 链路没有选项“%1”</translation>
    </message>
    <message>
        <source>somebody may have started it again, so the position was not reset</source>
        <translation>可能有人已重新启动它，因此未重置位置</translation>
    </message>
    <message>
        <source>something follows the end-of-file record</source>
        <translation>文件结束记录之后还有内容</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>speed %1 counts/s is above 1.2 × %2 counts/s</source>
        <translation>速度 %1 counts/s 高于 1.2 × %2 counts/s</translation>
    </message>
    <message>
        <source>speed is 10000 to 10000000 Hz, not &apos;%1&apos;</source>
        <translation>speed 为 10000 到 10000000 Hz，而非“%1”</translation>
    </message>
    <message>
        <source>speed, ready and reset are known</source>
        <translation>已知的有 speed、ready 和 reset</translation>
    </message>
    <message>
        <source>speed=%1 is no speed</source>
        <translation>speed=%1 不是速度</translation>
    </message>
    <message>
        <source>spidev links have no option &apos;%1&apos;</source>
        <translation>spidev 链路没有选项“%1”</translation>
    </message>
    <message>
        <source>stalled, or the encoder is dead: less than 3 counts in %1</source>
        <translation>堵转，或编码器失效：%1 内不足 3 个计数</translation>
    </message>
    <message>
        <source>start it again</source>
        <translation>重新启动它</translation>
    </message>
    <message>
        <source>start the reader first</source>
        <translation>先启动读取方</translation>
    </message>
    <message>
        <source>start the simulator again</source>
        <translation>重新启动仿真器</translation>
    </message>
    <message>
        <source>start the simulator first</source>
        <translation>先启动仿真器</translation>
    </message>
    <message>
        <source>steps with one pair of gains only do not tell what each of them does</source>
        <translation>仅用一对增益的阶跃无法说明各增益的作用</translation>
    </message>
    <message>
        <source>stop it before its gains are put back</source>
        <translation>恢复其增益之前先停止它</translation>
    </message>
    <message>
        <source>stop it first</source>
        <translation>先停止它</translation>
    </message>
    <message>
        <source>stop it there first</source>
        <translation>先在那里停止它</translation>
    </message>
    <message>
        <source>stop it, then put the values back</source>
        <translation>停止它，然后恢复原值</translation>
    </message>
    <message>
        <source>stop the motor before an experiment begins</source>
        <translation>实验开始之前请先停止电机</translation>
    </message>
    <message>
        <source>stop the motor before its dialect is changed</source>
        <translation>更改方言之前请先停止电机</translation>
    </message>
    <message>
        <source>stop the motor first</source>
        <translation>先停止电机</translation>
    </message>
    <message>
        <source>stop the motor first: the drive stands still while it writes its flash</source>
        <translation>请先停止电机：驱动器写入闪存期间不工作</translation>
    </message>
    <message>
        <source>stop the motors before settings are written again</source>
        <translation>重新写入设置之前请先停止电机</translation>
    </message>
    <message>
        <source>stop the motors first</source>
        <translation>请先停止电机</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>已停止</translation>
    </message>
    <message>
        <source>stopped while it waited for a number</source>
        <translation>在等待编号时已停止</translation>
    </message>
    <message>
        <source>stopped: %1</source>
        <translation>已停止：%1</translation>
    </message>
    <message>
        <source>stopped: the window did not respond in time</source>
        <translation>已停止：窗口未及时响应</translation>
    </message>
    <message>
        <source>stored, not verifiable</source>
        <translation>已存储，无法验证</translation>
    </message>
    <message>
        <source>stuff error</source>
        <translation>位填充错误</translation>
    </message>
    <message>
        <source>such a line reads %1</source>
        <translation>此类行的写法为 %1</translation>
    </message>
    <message>
        <source>such as %1</source>
        <translation>例如 %1</translation>
    </message>
    <message>
        <source>supply %1 V is outside %2 … %3 V</source>
        <translation>电源 %1 V 超出 %2 … %3 V</translation>
    </message>
    <message>
        <source>switch it off and on</source>
        <translation>将其断电再上电</translation>
    </message>
    <message>
        <source>switch the devices on, check the cable and that two 120 Ω resistors end the bus, and that every device has the bit rate %1</source>
        <translation>接通设备，检查电缆、总线两端是否有两个 120 Ω 电阻，以及每台设备的比特率是否为 %1</translation>
    </message>
    <message>
        <source>switch the devices on, check the cable and that two 120 Ω resistors end the bus, and that every device has the bit rate of this interface</source>
        <translation>接通设备，检查电缆、总线两端是否有两个 120 Ω 电阻，以及每台设备的比特率是否与此接口一致</translation>
    </message>
    <message>
        <source>take a finer encoder or a calmer loop</source>
        <translation>使用更精细的编码器或更平缓的回路</translation>
    </message>
    <message>
        <source>take a smaller step or widen it</source>
        <translation>取更小的阶跃或将其放宽</translation>
    </message>
    <message>
        <source>take one of them</source>
        <translation>取其中之一</translation>
    </message>
    <message>
        <source>take the jumper out and reset it</source>
        <translation>取下跳线并复位</translation>
    </message>
    <message>
        <source>take the jumper out; the board is asked for its version</source>
        <translation>取下跳线；将向板卡查询其版本</translation>
    </message>
    <message>
        <source>take the other one off, or give one of them another number</source>
        <translation>取下另一台，或为其中一台分配其他编号</translation>
    </message>
    <message>
        <source>temperature %1 °C is within 5 K of %2 °C</source>
        <translation>温度 %1 °C 距 %2 °C 不足 5 K</translation>
    </message>
    <message>
        <source>test again when it is safe</source>
        <translation>安全时重新测试</translation>
    </message>
    <message>
        <source>the %1 gains did not: %2</source>
        <translation>%1增益未做到：%2</translation>
    </message>
    <message>
        <source>the %1 loop was saved %2 times; after %3 its settings pages must be erased</source>
        <translation>%1回路已保存 %2 次；达到 %3 次后须擦除其设置页</translation>
    </message>
    <message>
        <source>the acknowledge delimiter</source>
        <translation>确认界定符</translation>
    </message>
    <message>
        <source>the acknowledge slot</source>
        <translation>确认间隙</translation>
    </message>
    <message>
        <source>the answer to the reset was lost; found again by enumeration</source>
        <translation>复位的应答丢失；经枚举重新找到</translation>
    </message>
    <message>
        <source>the axis has a power limit of %1 %, which is kept</source>
        <translation>该轴的功率限值为 %1 %，予以遵守</translation>
    </message>
    <message>
        <source>the base of the numbers is %1, not hex or dec</source>
        <translation>数字的进制为 %1，不是 hex 或 dec</translation>
    </message>
    <message>
        <source>the board answered with an error that its documents do not name</source>
        <translation>板卡以其文档未提及的错误应答</translation>
    </message>
    <message>
        <source>the board did not answer</source>
        <translation>板卡没有应答</translation>
    </message>
    <message>
        <source>the board did not tell its status</source>
        <translation>板卡未报告其状态</translation>
    </message>
    <message>
        <source>the board does not know this command</source>
        <translation>板卡不认识此命令</translation>
    </message>
    <message>
        <source>the board does not tell its position</source>
        <translation>板卡不报告其位置</translation>
    </message>
    <message>
        <source>the board found the packet malformed</source>
        <translation>板卡认为数据包格式有误</translation>
    </message>
    <message>
        <source>the board has axes 1 to 4</source>
        <translation>板卡有轴 1 到 4</translation>
    </message>
    <message>
        <source>the board has no number: chip select tells boards apart</source>
        <translation>板卡没有编号：通过片选区分板卡</translation>
    </message>
    <message>
        <source>the board has no such mode</source>
        <translation>板卡没有此模式</translation>
    </message>
    <message>
        <source>the board has one set of gains per axis</source>
        <translation>板卡每轴有一组增益</translation>
    </message>
    <message>
        <source>the board is updated over its UART</source>
        <translation>板卡通过其 UART 更新</translation>
    </message>
    <message>
        <source>the board keeps nothing without power</source>
        <translation>板卡断电后不保留任何内容</translation>
    </message>
    <message>
        <source>the board may want velocity targets times 4096: choose that setting, and try again</source>
        <translation>板卡可能需要乘以 4096 的速度目标：请选择该设置并重试</translation>
    </message>
    <message>
        <source>the board refused a value</source>
        <translation>板卡拒绝了某个值</translation>
    </message>
    <message>
        <source>the board restarted at %1</source>
        <translation>板卡在 %1 重新启动</translation>
    </message>
    <message>
        <source>the board sent a reply without a return code</source>
        <translation>板卡发送了没有返回码的应答</translation>
    </message>
    <message>
        <source>the board speaks protocol %1, this program was written for protocol 1; watch it before it is driven</source>
        <translation>板卡使用协议 %1，本程序为协议 1 编写；驱动之前请先监视它</translation>
    </message>
    <message>
        <source>the board was reset since its settings were written</source>
        <translation>自写入设置以来板卡已复位</translation>
    </message>
    <message>
        <source>the board was unplugged</source>
        <translation>板卡已被拔出</translation>
    </message>
    <message>
        <source>the bootloader did not announce itself</source>
        <translation>引导程序未作出通告</translation>
    </message>
    <message>
        <source>the bootloader refuses page %1</source>
        <translation>引导程序拒绝第 %1 页</translation>
    </message>
    <message>
        <source>the bootloader said nothing</source>
        <translation>引导程序没有任何响应</translation>
    </message>
    <message>
        <source>the bus leaves no room for what %1 sends</source>
        <translation>总线没有余量容纳 %1 发送的内容</translation>
    </message>
    <message>
        <source>the byte count was out of step</source>
        <translation>字节计数不同步</translation>
    </message>
    <message>
        <source>the cable was pulled out</source>
        <translation>电缆已被拔出</translation>
    </message>
    <message>
        <source>the checksum</source>
        <translation>校验和</translation>
    </message>
    <message>
        <source>the checksum delimiter</source>
        <translation>校验和界定符</translation>
    </message>
    <message>
        <source>the computer slept</source>
        <translation>计算机曾休眠</translation>
    </message>
    <message>
        <source>the controller lost frames to send</source>
        <translation>控制器丢失了待发送的帧</translation>
    </message>
    <message>
        <source>the controller lost received frames</source>
        <translation>控制器丢失了已接收的帧</translation>
    </message>
    <message>
        <source>the controller may hold half a program, and runs again once an update has succeeded</source>
        <translation>控制器中可能只有半个程序，更新成功后才能重新运行</translation>
    </message>
    <message>
        <source>the controller started again</source>
        <translation>控制器重新启动了</translation>
    </message>
    <message>
        <source>the current did not follow the duty, so its resistance is not known</source>
        <translation>电流未跟随占空比，因此其电阻未知</translation>
    </message>
    <message>
        <source>the current limit cut into the pushes</source>
        <translation>电流限制切入了推动过程</translation>
    </message>
    <message>
        <source>the data</source>
        <translation>数据</translation>
    </message>
    <message>
        <source>the data masks have an unexpected length</source>
        <translation>数据掩码的长度与预期不符</translation>
    </message>
    <message>
        <source>the data runs past the end of 32-bit addresses</source>
        <translation>数据超出 32 位地址的末尾</translation>
    </message>
    <message>
        <source>the data runs past the end of its 64 KiB segment</source>
        <translation>数据超出其 64 KiB 段的末尾</translation>
    </message>
    <message>
        <source>the device already runs %1</source>
        <translation>设备已在运行 %1</translation>
    </message>
    <message>
        <source>the device answers with no application</source>
        <translation>设备应答，但没有应用程序</translation>
    </message>
    <message>
        <source>the device answers with version %1</source>
        <translation>设备以版本 %1 应答</translation>
    </message>
    <message>
        <source>the device could not verify its flash</source>
        <translation>设备无法校验其闪存</translation>
    </message>
    <message>
        <source>the device does not answer</source>
        <translation>设备无应答</translation>
    </message>
    <message>
        <source>the device is busy with something else</source>
        <translation>设备正忙于其他操作</translation>
    </message>
    <message>
        <source>the device is gone</source>
        <translation>设备已不存在</translation>
    </message>
    <message>
        <source>the device is not heard any more</source>
        <translation>不再收到设备的信号</translation>
    </message>
    <message>
        <source>the device may have restarted: once more from page %1</source>
        <translation>设备可能已重新启动：从第 %1 页再来一次</translation>
    </message>
    <message>
        <source>the device restarted</source>
        <translation>设备已重新启动</translation>
    </message>
    <message>
        <source>the device restarted %1 times during the update</source>
        <translation>更新期间设备重新启动了 %1 次</translation>
    </message>
    <message>
        <source>the device restarted before its flash was proved to be written</source>
        <translation>在证实闪存已写入之前设备重新启动了</translation>
    </message>
    <message>
        <source>the device says that the motor is not started; it may have lost its supply</source>
        <translation>设备报告电机未启动；可能是电源曾中断</translation>
    </message>
    <message>
        <source>the device&apos;s rate was not put back: %1</source>
        <translation>设备的频率未恢复：%1</translation>
    </message>
    <message>
        <source>the disk has not made %1 within 10 s</source>
        <translation>磁盘未在 10 s 内创建 %1</translation>
    </message>
    <message>
        <source>the disk has not taken %1 for 30 s</source>
        <translation>磁盘已有 30 s 未接受 %1</translation>
    </message>
    <message>
        <source>the disk is full</source>
        <translation>磁盘已满</translation>
    </message>
    <message>
        <source>the disk of %1 does not answer</source>
        <translation>%1 所在的磁盘无响应</translation>
    </message>
    <message>
        <source>the drive does not check it and would overwrite its memory</source>
        <translation>驱动器不会检查它，并会覆盖自身的存储器</translation>
    </message>
    <message>
        <source>the driver of %1 cannot switch the direction of an RS-485 line, so the adapter has to do it by itself; if nothing answers, use one that does</source>
        <translation>%1 的驱动程序无法切换 RS-485 线路的方向，须由适配器自行切换；若无应答，请使用能自行切换的适配器</translation>
    </message>
    <message>
        <source>the duty changed its direction %1 times in a second</source>
        <translation>占空比在一秒内换向 %1 次</translation>
    </message>
    <message>
        <source>the encoder counts against the power</source>
        <translation>编码器计数方向与功率方向相反</translation>
    </message>
    <message>
        <source>the encoder does not count both ways</source>
        <translation>编码器不能双向计数</translation>
    </message>
    <message>
        <source>the end of frame</source>
        <translation>帧结束</translation>
    </message>
    <message>
        <source>the end-of-file record is missing, the file may be cut off</source>
        <translation>缺少文件结束记录，文件可能被截断</translation>
    </message>
    <message>
        <source>the file has no lines to send</source>
        <translation>文件没有可发送的行</translation>
    </message>
    <message>
        <source>the file has reached the greatest size there</source>
        <translation>文件已达到该处允许的最大长度</translation>
    </message>
    <message>
        <source>the file holds no data</source>
        <translation>文件不含数据</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>文件为空</translation>
    </message>
    <message>
        <source>the folder %1 cannot be made</source>
        <translation>无法创建文件夹 %1</translation>
    </message>
    <message>
        <source>the folder %1 cannot be written</source>
        <translation>无法写入文件夹 %1</translation>
    </message>
    <message>
        <source>the formula is nested too deeply</source>
        <translation>公式嵌套过深</translation>
    </message>
    <message>
        <source>the formula uses no signal</source>
        <translation>公式未使用任何信号</translation>
    </message>
    <message>
        <source>the frame has %1 of %2 bytes</source>
        <translation>帧有 %1 字节，应为 %2 字节</translation>
    </message>
    <message>
        <source>the frame is of the kind %1, not d or r</source>
        <translation>帧的类型为 %1，不是 d 或 r</translation>
    </message>
    <message>
        <source>the frame says %1 in the place of Rx or Tx</source>
        <translation>帧在 Rx 或 Tx 的位置上为 %1</translation>
    </message>
    <message>
        <source>the gain had nothing to act on</source>
        <translation>增益没有可作用的对象</translation>
    </message>
    <message>
        <source>the gain scale is too coarse to be measured with so little power</source>
        <translation>增益比例过粗，无法以如此小的功率测量</translation>
    </message>
    <message>
        <source>the gains found at different values do not agree, so that a gain is no simple factor</source>
        <translation>在不同值下求得的增益不一致，因此增益并非简单的比例系数</translation>
    </message>
    <message>
        <source>the gains of this loop are not known here, so its target stays within %1 of where it is: a weak loop may not move it; write its p, d and divisor once</source>
        <translation>此处不知道此回路的增益，因此其目标保持在当前位置的 %1 以内：弱回路可能无法使其运动；请写入一次其 p、d 和 divisor</translation>
    </message>
    <message>
        <source>the gains stored in the drive are erased; all its loops do nothing until they are written again</source>
        <translation>驱动器中存储的增益已擦除；重新写入之前，其所有回路均不起作用</translation>
    </message>
    <message>
        <source>the gains that trial #%1 had changed are put back</source>
        <translation>试验 #%1 更改过的增益已恢复</translation>
    </message>
    <message>
        <source>the guardian does not answer</source>
        <translation>守护进程无应答</translation>
    </message>
    <message>
        <source>the guardian does not stand by yet</source>
        <translation>守护进程尚未待命</translation>
    </message>
    <message>
        <source>the guardian ended unexpectedly</source>
        <translation>守护进程意外结束</translation>
    </message>
    <message>
        <source>the guardian has sent the stop, which nothing on this link confirms; look whether the motor stands</source>
        <translation>守护进程已发送停止命令，此链路上无法对其确认；请查看电机是否静止</translation>
    </message>
    <message>
        <source>the guardian has stopped the motor</source>
        <translation>守护进程已停止电机</translation>
    </message>
    <message>
        <source>the guardian is of another version</source>
        <translation>守护进程的版本不同</translation>
    </message>
    <message>
        <source>the guardian sent the stop because this program was held up, not confirmed</source>
        <translation>因本程序被延误，守护进程已发送停止命令，未得到确认</translation>
    </message>
    <message>
        <source>the guardian stopped the motor because this program was held up</source>
        <translation>因本程序被延误，守护进程已停止电机</translation>
    </message>
    <message>
        <source>the guardian tried in vain to stop the motor; it may still turn: cut its power</source>
        <translation>守护进程尝试停止电机未果；它可能仍在转动：请切断其电源</translation>
    </message>
    <message>
        <source>the guardian tried to stop the motor because this program was held up, without an answer</source>
        <translation>因本程序被延误，守护进程尝试停止电机，无应答</translation>
    </message>
    <message>
        <source>the history does not have this write: %1</source>
        <translation>历史中没有此次写入：%1</translation>
    </message>
    <message>
        <source>the history has an unexpected length</source>
        <translation>历史的长度与预期不符</translation>
    </message>
    <message>
        <source>the history of %1 has nothing to do again</source>
        <translation>%1 的历史中没有可重做的内容</translation>
    </message>
    <message>
        <source>the history of %1 has nothing to undo</source>
        <translation>%1 的历史中没有可撤销的内容</translation>
    </message>
    <message>
        <source>the identifier</source>
        <translation>标识符</translation>
    </message>
    <message>
        <source>the identifier extension bit</source>
        <translation>标识符扩展位</translation>
    </message>
    <message>
        <source>the image is for product 602, this unit is product %1%2%3</source>
        <translation>映像用于产品 602，此设备为产品 %1%2%3</translation>
    </message>
    <message>
        <source>the image itself writes the settings pages</source>
        <translation>映像本身会写入设置页</translation>
    </message>
    <message>
        <source>the intermission</source>
        <translation>帧间间歇</translation>
    </message>
    <message>
        <source>the journal on the server was made by a newer version of this program</source>
        <translation>服务器上的日志簿由本程序的较新版本生成</translation>
    </message>
    <message>
        <source>the journal&apos;s server: %1</source>
        <translation>日志簿的服务器：%1</translation>
    </message>
    <message>
        <source>the jumper is still in: take it out, then reset the board</source>
        <translation>跳线仍插着：请取下，然后复位板卡</translation>
    </message>
    <message>
        <source>the kernel does not list its interfaces: %1</source>
        <translation>内核未列出其接口：%1</translation>
    </message>
    <message>
        <source>the key &apos;%1&apos; is there twice</source>
        <translation>键“%1”出现了两次</translation>
    </message>
    <message>
        <source>the layout has more than 500 traces</source>
        <translation>布局的曲线超过 500 条</translation>
    </message>
    <message>
        <source>the length</source>
        <translation>长度</translation>
    </message>
    <message>
        <source>the length of the frame is %1</source>
        <translation>帧的长度为 %1</translation>
    </message>
    <message>
        <source>the limit of &apos;%1&apos; must be the greatest value, 0 or more, or [least, greatest]</source>
        <translation>“%1”的限值必须是 0 或更大的最大值，或 [最小值, 最大值]</translation>
    </message>
    <message>
        <source>the link is not open</source>
        <translation>链路未打开</translation>
    </message>
    <message>
        <source>the link was opened anew</source>
        <translation>链路已重新打开</translation>
    </message>
    <message>
        <source>the loop drives the motor the wrong way</source>
        <translation>回路朝错误方向驱动电机</translation>
    </message>
    <message>
        <source>the loop swings itself up: %1 swings, each larger than the last or with full duty</source>
        <translation>回路自行振荡增大：%1 次摆动，每次都大于上一次或达到满占空比</translation>
    </message>
    <message>
        <source>the loop does not come to rest: %1 swings</source>
        <translation>回路不能静止：%1 次摆动</translation>
    </message>
    <message>
        <source>the loop would be undefined</source>
        <translation>回路将无定义</translation>
    </message>
    <message>
        <source>the microcontroller of the drive is f1 (STM32F1) or f4 (STM32F4)</source>
        <translation>驱动器的微控制器为 f1 (STM32F1) 或 f4 (STM32F4)</translation>
    </message>
    <message>
        <source>the model is not to be believed: %1</source>
        <translation>模型不可信：%1</translation>
    </message>
    <message>
        <source>the motor did not follow a step: stalled, or the encoder is dead</source>
        <translation>电机未跟随阶跃：堵转，或编码器失效</translation>
    </message>
    <message>
        <source>the motor did not move at up to %1 % duty (%2 counts): stalled, or the encoder is dead</source>
        <translation>占空比高达 %1 % 时电机仍未运动（%2 个计数）：堵转，或编码器失效</translation>
    </message>
    <message>
        <source>the motor did not turn at two of the powers</source>
        <translation>在其中两种功率下电机未转动</translation>
    </message>
    <message>
        <source>the motor did not turn at up to %1 duty: stalled, or the encoder is dead</source>
        <translation>占空比高达 %1 时电机仍未转动：堵转，或编码器失效</translation>
    </message>
    <message>
        <source>the motor did not turn the way it was pushed</source>
        <translation>电机未朝推动的方向转动</translation>
    </message>
    <message>
        <source>the motor gives %1 counts/s per power unit, friction takes %2 units, it follows within %3 ms</source>
        <translation>电机每功率单位给出 %1 counts/s，摩擦消耗 %2 单位，它在 %3 ms 内跟随</translation>
    </message>
    <message>
        <source>the motor is not seen to stand</source>
        <translation>未确认电机静止</translation>
    </message>
    <message>
        <source>the motor ran faster than the power limit allows</source>
        <translation>电机转速超过功率限值所允许的</translation>
    </message>
    <message>
        <source>the motor reversed during a sine of %1 Hz: friction is in it</source>
        <translation>电机在 %1 Hz 正弦期间反转：其中包含摩擦</translation>
    </message>
    <message>
        <source>the motor took the heat of %1 s at %2 A, 10 s are allowed; let it cool</source>
        <translation>电机吸收了 %2 A 下 %1 s 的热量，允许 10 s；请使其冷却</translation>
    </message>
    <message>
        <source>the motor turned too short a time below the power limit to be measured</source>
        <translation>电机在功率限值以下转动的时间太短，无法测量</translation>
    </message>
    <message>
        <source>the motor turns differently in both directions</source>
        <translation>电机在两个方向上的转动不同</translation>
    </message>
    <message>
        <source>the motor was not seen to stand</source>
        <translation>未确认电机静止</translation>
    </message>
    <message>
        <source>the motor was stopped</source>
        <translation>电机已停止</translation>
    </message>
    <message>
        <source>the motor was stopped: %1</source>
        <translation>电机已停止：%1</translation>
    </message>
    <message>
        <source>the motors that were not seen to stand were looked at; their stops are dismissed</source>
        <translation>未确认静止的电机已查看过；其停止提示已消除</translation>
    </message>
    <message>
        <source>the motors were told to stop, and are not seen to stand</source>
        <translation>已命令电机停止，但未确认其静止</translation>
    </message>
    <message>
        <source>the name was written, but the device answers &apos;%1&apos;</source>
        <translation>名称已写入，但设备应答“%1”</translation>
    </message>
    <message>
        <source>the nearest it can is %1</source>
        <translation>最接近的可行值为 %1</translation>
    </message>
    <message>
        <source>the offset of an Abstract DC Drive is compiled into its firmware</source>
        <translation>Abstract DC Drive 的偏移量编译在其固件中</translation>
    </message>
    <message>
        <source>the order was dropped: what it was for has ended</source>
        <translation>命令已撤除：其目的已结束</translation>
    </message>
    <message>
        <source>the other end of %1 closed it</source>
        <translation>%1 的另一端已将其关闭</translation>
    </message>
    <message>
        <source>the other end of %1 hung up</source>
        <translation>%1 的另一端已挂断</translation>
    </message>
    <message>
        <source>the output of its loop passed 32767, where it turns to full reverse</source>
        <translation>其回路的输出超过 32767，在该处会翻转为全反向</translation>
    </message>
    <message>
        <source>the packet is too long for the board</source>
        <translation>数据包对板卡而言过长</translation>
    </message>
    <message>
        <source>the plugin %1 finds no adapter</source>
        <translation>插件 %1 找不到适配器</translation>
    </message>
    <message>
        <source>the plugin %1 finds no adapter (%2)</source>
        <translation>插件 %1 找不到适配器 (%2)</translation>
    </message>
    <message>
        <source>the position is not known yet, so nothing would keep the motor from jumping</source>
        <translation>位置尚未知，因此无法防止电机跳动</translation>
    </message>
    <message>
        <source>the position is written only while the output is off</source>
        <translation>位置仅在输出关闭时写入</translation>
    </message>
    <message>
        <source>the position was not reset: %1</source>
        <translation>未重置位置：%1</translation>
    </message>
    <message>
        <source>the positions have an unexpected length</source>
        <translation>位置数据的长度与预期不符</translation>
    </message>
    <message>
        <source>the profiled move passed its target by more than its stopping distance, as this firmware may above 2500 counts/s; use a lower profile.velocity</source>
        <translation>轮廓运动越过目标的距离超过其制动距离，此固件在 2500 counts/s 以上可能如此；请使用较低的 profile.velocity</translation>
    </message>
    <message>
        <source>the pushes differ by %1 in their resistance, at most 15 %</source>
        <translation>各次推动的电阻相差 %1，最多允许 15 %</translation>
    </message>
    <message>
        <source>the ramp must be 0 (immediate) or a positive number of duty per second</source>
        <translation>斜坡必须为 0（立即）或每秒占空比的正数</translation>
    </message>
    <message>
        <source>the ramp must be 0 or a positive number of duty per second</source>
        <translation>斜坡必须为 0 或每秒占空比的正数</translation>
    </message>
    <message>
        <source>the ready line stayed low</source>
        <translation>就绪线保持为低</translation>
    </message>
    <message>
        <source>the record is cut off after %1 bytes</source>
        <translation>记录在 %1 字节后被截断</translation>
    </message>
    <message>
        <source>the recording has ended: %1</source>
        <translation>记录已结束：%1</translation>
    </message>
    <message>
        <source>the remote bit</source>
        <translation>远程位</translation>
    </message>
    <message>
        <source>the reply has an unexpected length</source>
        <translation>应答的长度与预期不符</translation>
    </message>
    <message>
        <source>the report cannot be painted</source>
        <translation>无法绘制报告</translation>
    </message>
    <message>
        <source>the reset line was pulsed</source>
        <translation>已给出复位脉冲</translation>
    </message>
    <message>
        <source>the resistance is known within %1, at most 10 %</source>
        <translation>电阻的已知精度为 %1，最多允许 10 %</translation>
    </message>
    <message>
        <source>the response could not be measured</source>
        <translation>无法测量响应</translation>
    </message>
    <message>
        <source>the same interface as socketcan:%1, which also counts losses</source>
        <translation>与 socketcan:%1 是同一接口，后者还统计丢失数</translation>
    </message>
    <message>
        <source>the scale of its gains is not known yet, and is found first: one to two minutes, with %1 % of its power at most</source>
        <translation>其增益比例尚未知，将首先求取：一到两分钟，最多使用其功率的 %1 %</translation>
    </message>
    <message>
        <source>the search was cancelled; what it found stays</source>
        <translation>搜索已取消；已找到的保留</translation>
    </message>
    <message>
        <source>the self-test could not go on: %1</source>
        <translation>自检无法继续：%1</translation>
    </message>
    <message>
        <source>the self-test was ended by the guard &apos;%1&apos;: %2</source>
        <translation>自检被监护“%1”结束：%2</translation>
    </message>
    <message>
        <source>the self-test was stopped by hand</source>
        <translation>自检被手动停止</translation>
    </message>
    <message>
        <source>the sensor counts down when the motor is driven up (%1 counts): one of them is reversed</source>
        <translation>向上驱动电机时传感器向下计数（%1 个计数）：两者之一接反</translation>
    </message>
    <message>
        <source>the sensor is reversed: it counts down</source>
        <translation>传感器接反：它向下计数</translation>
    </message>
    <message>
        <source>the sensor is reversed: it counts up</source>
        <translation>传感器接反：它向上计数</translation>
    </message>
    <message>
        <source>the set-point comes from here, not from the device</source>
        <translation>设定值来自此处，而非设备</translation>
    </message>
    <message>
        <source>the set-point of the step</source>
        <translation>阶跃的设定值</translation>
    </message>
    <message>
        <source>the settings of the %1 loop were saved %2 times</source>
        <translation>%1回路的设置已保存 %2 次</translation>
    </message>
    <message>
        <source>the settings that the reset took are written again</source>
        <translation>正在重新写入因复位而丢失的设置</translation>
    </message>
    <message>
        <source>the shaft must be free, without load on one side</source>
        <translation>轴必须能自由转动，没有单侧负载</translation>
    </message>
    <message>
        <source>the simulated board is in use by another link</source>
        <translation>仿真板卡正被另一链路使用</translation>
    </message>
    <message>
        <source>the simulator at %1 closed the connection</source>
        <translation>%1 处的仿真器关闭了连接</translation>
    </message>
    <message>
        <source>the simulator at %1 sent bytes that nobody asked for</source>
        <translation>%1 处的仿真器发送了未请求的字节</translation>
    </message>
    <message>
        <source>the speed does not grow evenly with the power</source>
        <translation>速度不随功率均匀增大</translation>
    </message>
    <message>
        <source>the start of frame</source>
        <translation>帧起始</translation>
    </message>
    <message>
        <source>the status bit is the same with both polarities, so it tells nothing</source>
        <translation>两种极性下状态位相同，因此无法说明任何问题</translation>
    </message>
    <message>
        <source>the steps met the end of the output</source>
        <translation>阶跃达到输出的极限</translation>
    </message>
    <message>
        <source>the stop before it is not acknowledged yet</source>
        <translation>之前的停止尚未得到确认</translation>
    </message>
    <message>
        <source>the stop could not be sent, and is the first thing that goes out when the line is back; cut its power</source>
        <translation>停止命令未能发送，线路恢复后将首先发出；请切断其电源</translation>
    </message>
    <message>
        <source>the stop of the self-test was not confirmed: %1</source>
        <translation>自检的停止未得到确认：%1</translation>
    </message>
    <message>
        <source>the stop script of this device is not one that a guardian can carry out</source>
        <translation>此设备的停止脚本不是守护进程能够执行的</translation>
    </message>
    <message>
        <source>the stop was not acknowledged, so the position was not reset: a motor that runs would jump</source>
        <translation>停止未得到确认，因此未重置位置：运行中的电机会跳动</translation>
    </message>
    <message>
        <source>the stream settings have an unexpected length</source>
        <translation>数据流设置的长度与预期不符</translation>
    </message>
    <message>
        <source>the substitute remote bit</source>
        <translation>替代远程位</translation>
    </message>
    <message>
        <source>the target</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>the text is longer than %1 MiB</source>
        <translation>文本超过 %1 MiB</translation>
    </message>
    <message>
        <source>the time stamp %1 is out of range</source>
        <translation>时间戳 %1 超出范围</translation>
    </message>
    <message>
        <source>the time stamps are %1, not absolute or relative</source>
        <translation>时间戳为 %1，不是 absolute 或 relative</translation>
    </message>
    <message>
        <source>the transceiver reports an error</source>
        <translation>收发器报告错误</translation>
    </message>
    <message>
        <source>the transcript of the update is in %1</source>
        <translation>更新的记录文本位于 %1</translation>
    </message>
    <message>
        <source>the transcript of the update is not kept: %1</source>
        <translation>未保留更新的记录文本：%1</translation>
    </message>
    <message>
        <source>the tuning is not in the notebook: %1</source>
        <translation>整定未记入试验记录本：%1</translation>
    </message>
    <message>
        <source>the two directions differ by %1, at most 10 %</source>
        <translation>两个方向相差 %1，最多允许 10 %</translation>
    </message>
    <message>
        <source>the unit answers with firmware %1, the image is %2</source>
        <translation>设备以固件 %1 应答，映像为 %2</translation>
    </message>
    <message>
        <source>the unit does not answer an enumeration</source>
        <translation>设备不应答枚举</translation>
    </message>
    <message>
        <source>the unit may have restarted meanwhile: once more from page %1</source>
        <translation>设备可能已在其间重新启动：从第 %1 页再来一次</translation>
    </message>
    <message>
        <source>the unit restarted: what is volatile was lost, its parameters are read again</source>
        <translation>设备已重新启动：易失内容已丢失，正在重新读取其参数</translation>
    </message>
    <message>
        <source>the unit said it is in its bootloader, but its application answers</source>
        <translation>设备称处于引导程序，但其应用程序有应答</translation>
    </message>
    <message>
        <source>the unit stays %1 away from where the experiment begins, more than 2 % of its step</source>
        <translation>设备停在距实验起点 %1 处，超过其阶跃的 2 %</translation>
    </message>
    <message>
        <source>the unit stores no P, so nothing moves it</source>
        <translation>设备没有存储 P，因此无法使其运动</translation>
    </message>
    <message>
        <source>the unit stores them by itself within %1 s</source>
        <translation>设备会在 %1 s 内自动存储它们</translation>
    </message>
    <message>
        <source>the unit tells no duty, no current or no position, so its resistance is not known</source>
        <translation>设备不报告占空比、电流或位置，因此其电阻未知</translation>
    </message>
    <message>
        <source>the unit waits in its bootloader, run the update again</source>
        <translation>设备在其引导程序中等待，请再次运行更新</translation>
    </message>
    <message>
        <source>the unit was not heard during the self-test: %1</source>
        <translation>自检期间未收到设备的信号：%1</translation>
    </message>
    <message>
        <source>the user stopped it</source>
        <translation>用户将其停止</translation>
    </message>
    <message>
        <source>the user-ID words</source>
        <translation>用户 ID 字</translation>
    </message>
    <message>
        <source>the values are not put back: %1</source>
        <translation>未恢复原值：%1</translation>
    </message>
    <message>
        <source>the values are put back</source>
        <translation>已恢复原值</translation>
    </message>
    <message>
        <source>the values stay with this program and are written again after a reset</source>
        <translation>这些值保留在本程序中，并在复位后重新写入</translation>
    </message>
    <message>
        <source>the version at 0x1EFFC is 0x0000</source>
        <translation>0x1EFFC 处的版本为 0x0000</translation>
    </message>
    <message>
        <source>the version at 0x1EFFC is 0xFFFF, which means no application</source>
        <translation>0x1EFFC 处的版本为 0xFFFF，表示没有应用程序</translation>
    </message>
    <message>
        <source>the version has an unexpected length</source>
        <translation>版本的长度与预期不符</translation>
    </message>
    <message>
        <source>the window of the layout is out of range</source>
        <translation>布局的窗口超出范围</translation>
    </message>
    <message>
        <source>the wire lost too many frames; the same again</source>
        <translation>线路丢失的帧过多；请再来一次</translation>
    </message>
    <message>
        <source>there is no %1</source>
        <translation>没有 %1</translation>
    </message>
    <message>
        <source>there is no CAN interface</source>
        <translation>没有 CAN 接口</translation>
    </message>
    <message>
        <source>there is no CAN interface %1</source>
        <translation>没有 CAN 接口 %1</translation>
    </message>
    <message>
        <source>there is no CAN plugin %1</source>
        <translation>没有 CAN 插件 %1</translation>
    </message>
    <message>
        <source>there is no GPIO chip for %1</source>
        <translation>没有用于 %1 的 GPIO 芯片</translation>
    </message>
    <message>
        <source>there is no entry %1 in the journal</source>
        <translation>日志簿中没有条目 %1</translation>
    </message>
    <message>
        <source>there is no file &apos;%1&apos;</source>
        <translation>没有文件“%1”</translation>
    </message>
    <message>
        <source>there is no layout of this name</source>
        <translation>没有此名称的布局</translation>
    </message>
    <message>
        <source>there is no simulated link &apos;sim:%1&apos;: can, serial and spi are known</source>
        <translation>没有仿真链路“sim:%1”：已知的有 can、serial 和 spi</translation>
    </message>
    <message>
        <source>there is no snapshot &apos;%1&apos;</source>
        <translation>没有快照“%1”</translation>
    </message>
    <message>
        <source>there is no snapshot &apos;%1&apos; of this unit</source>
        <translation>此设备没有快照“%1”</translation>
    </message>
    <message>
        <source>there is no socket %1</source>
        <translation>没有套接字 %1</translation>
    </message>
    <message>
        <source>there is no such folder</source>
        <translation>没有此文件夹</translation>
    </message>
    <message>
        <source>there is no table here: expected time_s,name (unit),… or t,channel,value,unit</source>
        <translation>此处没有表格：应为 time_s,name (unit),… 或 t,channel,value,unit</translation>
    </message>
    <message>
        <source>there is no trial %1</source>
        <translation>没有试验 %1</translation>
    </message>
    <message>
        <source>there is no way from %1 to itself</source>
        <translation>%1 没有通往自身的途径</translation>
    </message>
    <message>
        <source>there is not enough room for a frequency response: its limits leave a speed of %1 counts/s for %2 s</source>
        <translation>没有足够余地进行频率响应测量：其限值在 %2 s 内只允许 %1 counts/s 的速度</translation>
    </message>
    <message>
        <source>there is not enough room to identify the motor: its limits leave pushes of %1 duty only</source>
        <translation>没有足够余地辨识电机：其限值只允许占空比 %1 的推动</translation>
    </message>
    <message>
        <source>there is not enough room: its limits leave steps of %1 counts</source>
        <translation>没有足够余地：其限值只允许 %1 个计数的阶跃</translation>
    </message>
    <message>
        <source>these are the calm gains, %1</source>
        <translation>这些是平缓的增益，%1</translation>
    </message>
    <message>
        <source>they have speed and interface</source>
        <translation>它们的选项为 speed 和 interface</translation>
    </message>
    <message>
        <source>this build knows %1</source>
        <translation>此构建版本认识 %1</translation>
    </message>
    <message>
        <source>this build simulates no devices on sim:%1</source>
        <translation>此构建版本不在 sim:%1 上仿真设备</translation>
    </message>
    <message>
        <source>this change waits for nobody</source>
        <translation>此更改没有人在等待</translation>
    </message>
    <message>
        <source>this command is not known to firmware of dialect %1</source>
        <translation>方言 %1 的固件不认识此命令</translation>
    </message>
    <message>
        <source>this computer has no driver for PostgreSQL</source>
        <translation>此计算机没有 PostgreSQL 的驱动程序</translation>
    </message>
    <message>
        <source>this computer is not kept awake while motors are driven or firmware is written: %1; switch its automatic suspend off meanwhile</source>
        <translation>驱动电机或写入固件期间未能阻止此计算机休眠：%1；请在此期间关闭自动挂起</translation>
    </message>
    <message>
        <source>this device has no experiment &apos;%1&apos;</source>
        <translation>此设备没有实验“%1”</translation>
    </message>
    <message>
        <source>this device has no watchdog, and nothing here would stop it if the program died</source>
        <translation>此设备没有看门狗，若程序崩溃，此处没有任何手段能使其停止</translation>
    </message>
    <message>
        <source>this device has no watchdog, and on %1 nothing could stop it if the program died</source>
        <translation>此设备没有看门狗，若程序崩溃，在 %1 上没有任何手段能使其停止</translation>
    </message>
    <message>
        <source>this firmware may pass the target of a profiled move above 2500 counts/s; it is stopped then</source>
        <translation>此固件在 2500 counts/s 以上可能越过轮廓运动的目标；届时会将其停止</translation>
    </message>
    <message>
        <source>this image holds a bootloader too, which cannot write itself</source>
        <translation>此映像还包含引导程序，而引导程序无法写入自身</translation>
    </message>
    <message>
        <source>this interface cannot listen without disturbing the bus, so ask who set it up; usual are 1 Mbit/s, 500, 250 and 125 kbit/s</source>
        <translation>此接口无法在不干扰总线的情况下监听，请询问总线的设置者；常用的有 1 Mbit/s、500、250 和 125 kbit/s</translation>
    </message>
    <message>
        <source>this is another unit by now, number %1</source>
        <translation>现在已是另一台设备，编号 %1</translation>
    </message>
    <message>
        <source>this is no layout of plots</source>
        <translation>这不是曲线图的布局</translation>
    </message>
    <message>
        <source>this is no program for the controller: it does not begin with a jump of an AVR at address 0</source>
        <translation>这不是用于该控制器的程序：地址 0 处不以 AVR 的跳转指令开头</translation>
    </message>
    <message>
        <source>this is no program for the controller: it has bytes outside the 32 KiB of an ATmega328P</source>
        <translation>这不是用于该控制器的程序：它有字节在 ATmega328P 的 32 KiB 之外</translation>
    </message>
    <message>
        <source>this is no program for the drive: it has bytes outside the flash of an STM32, 0x08000000 … 0x081FFFFF</source>
        <translation>这不是用于该驱动器的程序：它有字节在 STM32 的闪存 0x08000000 … 0x081FFFFF 之外</translation>
    </message>
    <message>
        <source>this is no program for the drive: there are no vectors of an STM32 at 0x08000000. Make the Intel HEX file with: arm-none-eabi-objcopy -O ihex abstract_DC_drive.elf</source>
        <translation>这不是用于该驱动器的程序：0x08000000 处没有 STM32 的向量。请用以下命令生成 Intel HEX 文件：arm-none-eabi-objcopy -O ihex abstract_DC_drive.elf</translation>
    </message>
    <message>
        <source>this is no recipe of version 1</source>
        <translation>这不是版本 1 的配方</translation>
    </message>
    <message>
        <source>this is no session of MotorBench</source>
        <translation>这不是 MotorBench 的会话</translation>
    </message>
    <message>
        <source>this kernel has no CAN support</source>
        <translation>此内核不支持 CAN</translation>
    </message>
    <message>
        <source>this program was held up for %1 ms, longer than the motor goes without a set-point</source>
        <translation>本程序被延误 %1 ms，超过电机无设定值可运行的时间</translation>
    </message>
    <message>
        <source>this program was held up for so long that the guardian may have stopped the motor</source>
        <translation>本程序被延误过久，守护进程可能已停止电机</translation>
    </message>
    <message>
        <source>this takes too long</source>
        <translation>用时过长</translation>
    </message>
    <message>
        <source>this trial has no sine and no positions</source>
        <translation>此试验没有正弦也没有位置</translation>
    </message>
    <message>
        <source>this trial is kept without its result: %1</source>
        <translation>此试验已保留，但不含其结果：%1</translation>
    </message>
    <message>
        <source>this trial is not kept: %1</source>
        <translation>此试验未保留：%1</translation>
    </message>
    <message>
        <source>this trial owes nothing to the unit</source>
        <translation>此试验对设备没有待恢复项</translation>
    </message>
    <message>
        <source>this unit has no number yet</source>
        <translation>此设备尚无编号</translation>
    </message>
    <message>
        <source>this unit has no number yet, and without one its motor may not be driven</source>
        <translation>此设备尚无编号，没有编号不得驱动其电机</translation>
    </message>
    <message>
        <source>this unit waits in its bootloader, and the recipe has no firmware for it</source>
        <translation>此设备在其引导程序中等待，而配方中没有用于它的固件</translation>
    </message>
    <message>
        <source>to be trusted up to %1 Hz, as far as ten samples a swing and a coherence of 0.9</source>
        <translation>按每次摆动十个采样和 0.9 的相干性，可信至 %1 Hz</translation>
    </message>
    <message>
        <source>too few samples for a sine of %1 Hz</source>
        <translation>对 %1 Hz 的正弦而言采样过少</translation>
    </message>
    <message>
        <source>too few steps to tell what the gains of this loop do</source>
        <translation>阶跃过少，无法判断此回路各增益的作用</translation>
    </message>
    <message>
        <source>transmission timed out</source>
        <translation>发送超时</translation>
    </message>
    <message>
        <source>trial #%1</source>
        <translation>试验 #%1</translation>
    </message>
    <message>
        <source>try a lower speed=</source>
        <translation>尝试更低的 speed=</translation>
    </message>
    <message>
        <source>try again</source>
        <translation>重试</translation>
    </message>
    <message>
        <source>try its position loop</source>
        <translation>尝试其位置环</translation>
    </message>
    <message>
        <source>tune it by hand with &apos;motorbenchctl step&apos;</source>
        <translation>用“motorbenchctl step”手动整定</translation>
    </message>
    <message>
        <source>tuning %1: %2</source>
        <translation>整定%1：%2</translation>
    </message>
    <message>
        <source>turning the motor with several powers</source>
        <translation>正以多种功率转动电机</translation>
    </message>
    <message>
        <source>undone: %1</source>
        <translation>已撤销：%1</translation>
    </message>
    <message>
        <source>units are served already</source>
        <translation>已在处理设备</translation>
    </message>
    <message>
        <source>units are served on this link</source>
        <translation>此链路上正在处理设备</translation>
    </message>
    <message>
        <source>unix links have no option &apos;%1&apos;</source>
        <translation>unix 链路没有选项“%1”</translation>
    </message>
    <message>
        <source>unknown error</source>
        <translation>未知错误</translation>
    </message>
    <message>
        <source>unknown family &apos;%1&apos;</source>
        <translation>未知系列“%1”</translation>
    </message>
    <message>
        <source>unknown fault &apos;%1&apos;</source>
        <translation>未知故障“%1”</translation>
    </message>
    <message>
        <source>unknown key %1</source>
        <translation>未知的键 %1</translation>
    </message>
    <message>
        <source>unknown key &apos;%1&apos;</source>
        <translation>未知的键“%1”</translation>
    </message>
    <message>
        <source>unknown link kind &apos;%1&apos;: sim, socketcan, qtcan, serial, spidev, unix and replay are known</source>
        <translation>未知的链路类型“%1”：已知的有 sim、socketcan、qtcan、serial、spidev、unix 和 replay</translation>
    </message>
    <message>
        <source>unknown loop &apos;%1&apos;</source>
        <translation>未知回路“%1”</translation>
    </message>
    <message>
        <source>unknown option &apos;%1&apos; of a serial link</source>
        <translation>串行链路的未知选项“%1”</translation>
    </message>
    <message>
        <source>unknown option &apos;%1&apos; of a simulated link</source>
        <translation>仿真链路的未知选项“%1”</translation>
    </message>
    <message>
        <source>unplug it and plug it in again</source>
        <translation>拔出后重新插入</translation>
    </message>
    <message>
        <source>unreadable</source>
        <translation>不可读</translation>
    </message>
    <message>
        <source>update its firmware first</source>
        <translation>先更新其固件</translation>
    </message>
    <message>
        <source>use a programmer on the pins</source>
        <translation>使用接在引脚上的编程器</translation>
    </message>
    <message>
        <source>use an interface of the kernel</source>
        <translation>使用内核的接口</translation>
    </message>
    <message>
        <source>use that one</source>
        <translation>使用那个</translation>
    </message>
    <message>
        <source>velocity is −100000 to 100000 counts/s</source>
        <translation>速度为 −100000 到 100000 counts/s</translation>
    </message>
    <message>
        <source>virtual</source>
        <translation>虚拟</translation>
    </message>
    <message>
        <source>wait until it is heard</source>
        <translation>等待直到收到它的信号</translation>
    </message>
    <message>
        <source>was not seen to stop: the motor may still turn, cut its power</source>
        <translation>未确认其停止：电机可能仍在转动，请切断其电源</translation>
    </message>
    <message>
        <source>was seen to stand</source>
        <translation>已确认静止</translation>
    </message>
    <message>
        <source>what D does is known within %1, at most 30 %</source>
        <translation>D 的作用的已知精度为 %1，最多允许 30 %</translation>
    </message>
    <message>
        <source>what a gain of %1 means in this loop is not known</source>
        <translation>不知道增益 %1 在此回路中的含义</translation>
    </message>
    <message>
        <source>what a raw gain of this board puts out is not known (%1)</source>
        <translation>不知道此板卡的原始增益对应的输出 (%1)</translation>
    </message>
    <message>
        <source>what another program has changed within the last 15 s is not in the flash of the unit yet, and is lost with the restart</source>
        <translation>另一程序在最近 15 s 内更改的内容尚未存入设备的闪存，会因重新启动而丢失</translation>
    </message>
    <message>
        <source>what is left over is %1 of the steps, at most 8 %</source>
        <translation>剩余部分为阶跃的 %1，最多允许 8 %</translation>
    </message>
    <message>
        <source>what is missing is still unknown, do it again</source>
        <translation>缺少的内容仍未知，请再做一次</translation>
    </message>
    <message>
        <source>what is sent to node %1 is also done by node %2, now or after a restart, because of an acceptance mask; set its node.mask to 255 and restart it</source>
        <translation>由于接收掩码，发送给节点 %1 的内容现在或重新启动后也会被节点 %2 执行；请将其 node.mask 设为 255 并重新启动</translation>
    </message>
    <message>
        <source>what the gains of this loop make is not known any more</source>
        <translation>此回路增益的作用已不再知道</translation>
    </message>
    <message>
        <source>where it is neither, its gain.p is too small for so short a way</source>
        <translation>若两者都不是，则其 gain.p 对如此短的行程而言过小</translation>
    </message>
    <message>
        <source>without a ready line the board is asked 100 times a second, and cannot stream</source>
        <translation>没有就绪线时，板卡每秒被查询 100 次，且不能发送数据流</translation>
    </message>
    <message>
        <source>without it nothing would stop this motor if the program died: install it there</source>
        <translation>没有它，若程序崩溃，没有任何手段能停止此电机：请将其安装在该处</translation>
    </message>
    <message>
        <source>write %1</source>
        <translation>写入 %1</translation>
    </message>
    <message>
        <source>write == to compare</source>
        <translation>比较请写 ==</translation>
    </message>
    <message>
        <source>write a larger gain.d once, with which it still comes to rest</source>
        <translation>写入一次能使其仍可静止的较大 gain.d</translation>
    </message>
    <message>
        <source>write a number</source>
        <translation>请写数值</translation>
    </message>
    <message>
        <source>write a small gain.p once, with which it moves</source>
        <translation>写入一次能使其运动的较小 gain.p</translation>
    </message>
    <message>
        <source>write a smaller gain.p once</source>
        <translation>写入一次更小的 gain.p</translation>
    </message>
    <message>
        <source>write it like 2.5</source>
        <translation>请写成 2.5 的形式</translation>
    </message>
    <message>
        <source>write it with &apos;motorbenchctl set&apos;</source>
        <translation>用“motorbenchctl set”写入</translation>
    </message>
    <message>
        <source>write it with a dot, like 1.5, and no comma</source>
        <translation>请用小数点书写，如 1.5，不用逗号</translation>
    </message>
    <message>
        <source>write on or off</source>
        <translation>请写 on 或 off</translation>
    </message>
    <message>
        <source>write openocd:INTERFACE, such as openocd:stlink</source>
        <translation>请写 openocd:INTERFACE，例如 openocd:stlink</translation>
    </message>
    <message>
        <source>write the gains of this loop once, or keep what is tried</source>
        <translation>写入一次此回路的增益，或保留所试的值</translation>
    </message>
    <message>
        <source>write true or false</source>
        <translation>请写 true 或 false</translation>
    </message>
    <message>
        <source>written again: %1</source>
        <translation>已重新写入：%1</translation>
    </message>
    <message>
        <source>written, but the current limit, which this firmware overwrites with it, could not be put back to %1 mA: %2</source>
        <translation>已写入，但此固件会随之覆盖电流限值，无法将其恢复为 %1 mA：%2</translation>
    </message>
    <message>
        <source>brisk</source>
        <translation>迅速</translation>
    </message>
    <message>
        <source>calm</source>
        <translation>平缓</translation>
    </message>
    <message>
        <source>kept</source>
        <translation>已保留</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>正常</translation>
    </message>
    <message>
        <source>proposed</source>
        <translation>已建议</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>已拒绝</translation>
    </message>
    <message>
        <source>rolled-back</source>
        <translation>已回退</translation>
    </message>
    <message>
        <source>P alone, in a loop that looks at the current every %1, holds %2 of what is asked for when it overshoots by %3</source>
        <translation>在每 %1 查看一次电流的环中，仅用 P 时若超调 %3，只能保持所要求值的 %2</translation>
    </message>
    <message>
        <source>allow more travel, so that pushes may last</source>
        <translation>允许更大行程，使推动可以持续</translation>
    </message>
    <message>
        <source>drive it by duty, or try its I with &apos;motorbenchctl step&apos;: not every build of the firmware runs it</source>
        <translation>用占空比驱动，或用“motorbenchctl step”试用其 I：并非每个固件版本都计算它</translation>
    </message>
    <message>
        <source>friction takes %1 duty, and %2 may push: too little for a motor to swing</source>
        <translation>摩擦占去 %1 占空比，而允许的推动为 %2：不足以使电机摆动</translation>
    </message>
    <message>
        <source>its current stays %1 A behind while the motor speeds up</source>
        <translation>电机加速期间，其电流落后 %1 A</translation>
    </message>
    <message>
        <source>no motor of this gain swings by %1 counts every %2</source>
        <translation>没有这种增益的电机会每 %2 摆动 %1 个计数</translation>
    </message>
    <message>
        <source>now those of the model as that step has corrected it</source>
        <translation>现在用该阶跃修正后的模型的增益</translation>
    </message>
    <message>
        <source>off</source>
        <translation>关</translation>
    </message>
    <message>
        <source>on</source>
        <translation>开</translation>
    </message>
    <message>
        <source>swinging with %1 duty to and fro</source>
        <translation>正在以占空比 %1 来回摆动</translation>
    </message>
    <message>
        <source>the %1 gains of the first model did not: %2</source>
        <translation>第一个模型的%1增益未做到：%2</translation>
    </message>
    <message>
        <source>the gain is known within %1, at most 15 %</source>
        <translation>增益的已知精度为 %1，最多允许 15 %</translation>
    </message>
    <message>
        <source>the motor did not swing evenly under a duty that changes its sign</source>
        <translation>在符号变换的占空比下，电机没有均匀摆动</translation>
    </message>
    <message>
        <source>their model was corrected by a step, %1</source>
        <translation>其模型已由一次阶跃修正，%1</translation>
    </message>
    <message>
        <source>there is no room for pushes that last</source>
        <translation>没有空间进行持续的推动</translation>
    </message>
    <message>
        <source>there was no room for long pushes; under %1 duty to and fro it swings by %2 counts every %3, the periods differ by %4, at most 10 %</source>
        <translation>没有空间进行长时间推动；在 %1 占空比来回作用下，它每 %3 摆动 %2 个计数，周期相差 %4，最多允许 10 %</translation>
    </message>
    <message>
        <source>this unit is for motors of more current</source>
        <translation>本单元适用于更大电流的电机</translation>
    </message>
    <message>
        <source>%1 %2 is unusual: %3 units have %4 to %5</source>
        <translation>%1 %2 异常：%3 台设备为 %4 到 %5</translation>
    </message>
    <message>
        <source>%1 besides those of the recipe differ from the backup</source>
        <translation>除配方中的以外，%1与备份不同</translation>
    </message>
    <message>
        <source>%1 of %2 written</source>
        <translation>已写入%2中的 %1 项</translation>
    </message>
    <message>
        <source>%1 pages, %2 sent again</source>
        <translation>%1 页，重发 %2</translation>
    </message>
    <message>
        <source>%1 settings</source>
        <translation>%1 项设置</translation>
    </message>
    <message>
        <source>1 setting</source>
        <translation>1 项设置</translation>
    </message>
    <message>
        <source>all numbers are used up, the highest is %1</source>
        <translation>所有编号已用完，最大为 %1</translation>
    </message>
    <message>
        <source>already %1</source>
        <translation>已是 %1</translation>
    </message>
    <message>
        <source>backup</source>
        <translation>备份</translation>
    </message>
    <message>
        <source>done</source>
        <translation>完成</translation>
    </message>
    <message>
        <source>firmware</source>
        <translation>固件</translation>
    </message>
    <message>
        <source>firmware %1</source>
        <translation>固件 %1</translation>
    </message>
    <message>
        <source>its flash has it</source>
        <translation>已在其闪存中</translation>
    </message>
    <message>
        <source>no version is told</source>
        <translation>未告知版本</translation>
    </message>
    <message>
        <source>not kept: there is no notebook</source>
        <translation>未保留：没有记录本</translation>
    </message>
    <message>
        <source>nothing can be read in the bootloader</source>
        <translation>在引导加载程序中无法读取任何内容</translation>
    </message>
    <message>
        <source>nothing had to be stored</source>
        <translation>无需存储</translation>
    </message>
    <message>
        <source>number</source>
        <translation>编号</translation>
    </message>
    <message>
        <source>number %1</source>
        <translation>编号 %1</translation>
    </message>
    <message>
        <source>number %1, as before</source>
        <translation>编号 %1，与之前相同</translation>
    </message>
    <message>
        <source>parameters</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>合格</translation>
    </message>
    <message>
        <source>preflight</source>
        <translation>预检</translation>
    </message>
    <message>
        <source>proof</source>
        <translation>证明</translation>
    </message>
    <message>
        <source>read back</source>
        <translation>已回读</translation>
    </message>
    <message>
        <source>self-test</source>
        <translation>自检</translation>
    </message>
    <message>
        <source>snapshot %1 has %2 values</source>
        <translation>快照 %1 有 %2 个值</translation>
    </message>
    <message>
        <source>within its limits</source>
        <translation>在限值内</translation>
    </message>
    <message>
        <source>%1 is for no unit that is here and takes firmware over its own link</source>
        <translation>%1 不适用于此处任何通过自身链路更新固件的设备</translation>
    </message>
    <message>
        <source>%1 is not open, or something runs there</source>
        <translation>%1 未打开，或有任务在运行</translation>
    </message>
    <message>
        <source>for the others write a recipe that names the way in</source>
        <translation>其他设备请编写指明途径的配方</translation>
    </message>
    <message>
        <source>open it, or end what runs there first</source>
        <translation>请打开它，或先结束那里的任务</translation>
    </message>
    <message>
        <source>this unit was never served, so there is nothing for a label</source>
        <translation>此设备从未处理过，标签没有内容</translation>
    </message>
    <message>
        <source>units are served here; the link stays open</source>
        <translation>此处正在处理设备；链路保持打开</translation>
    </message>
    <message>
        <source>write a page</source>
        <translation>请写成页面</translation>
    </message>
    <message>
        <source>does not answer</source>
        <translation>无应答</translation>
    </message>
    <message>
        <source>hold Arm, then put it on again</source>
        <translation>按住“解锁”，然后重新接上</translation>
    </message>
    <message>
        <source>it was cut off at &apos;%1&apos; and does not answer any more</source>
        <translation>在“%1”处中断，不再应答</translation>
    </message>
    <message>
        <source>left before the station was armed</source>
        <translation>工位解锁之前已离开</translation>
    </message>
    <message>
        <source>look at cable and supply; when it answers again it is served from the beginning</source>
        <translation>检查电缆和电源；重新应答后将从头处理</translation>
    </message>
    <message>
        <source>the unit was taken off while it waited for the station to be armed</source>
        <translation>等待工位解锁时设备被取下</translation>
    </message>
    <message>
        <source>waits until the station is armed</source>
        <translation>等待工位解锁</translation>
    </message>
    <message>
        <source>a step of %1 stands in noise of %2, at most %3; the mean of %4 tells it</source>
        <translation>%1 的阶跃处于 %2 的噪声中，最多 %3；由 %4 次的平均得出</translation>
    </message>
    <message>
        <source>on the model as these steps have corrected it, other gains leave less error; now those</source>
        <translation>在由这些阶跃修正的模型上，其他增益的误差更小；现在试用它们</translation>
    </message>
    <message>
        <source>those that were proven first left more error, these leave %1 of it</source>
        <translation>最先验证的增益误差更大，现在的误差为其 %1</translation>
    </message>
    <message>
        <source>their model was corrected by those that were proven first, which left no clearly more error</source>
        <translation>其模型已由最先验证的增益修正，后者的误差并未明显更大</translation>
    </message>
    <message>
        <source>a chunk of it is damaged</source>
        <translation>其中一个数据块已损坏</translation>
    </message>
    <message>
        <source>a chunk of it is larger than %1 MB</source>
        <translation>其中一个数据块大于 %1 MB</translation>
    </message>
    <message>
        <source>its chunks are packed by &apos;%1&apos;; zstd and lz4 are known</source>
        <translation>其数据块由 &apos;%1&apos; 压缩；支持 zstd 和 lz4</translation>
    </message>
    <message>
        <source>messages in JSON can be read, and what this program wrote</source>
        <translation>可读取 JSON 消息以及本程序写出的文件</translation>
    </message>
    <message>
        <source>--theme takes dark, light, contrast or system</source>
        <translation>--theme 接受 dark、light、contrast 或 system</translation>
    </message>
    <message>
        <source>give an .mcap with messages in JSON or of this program, a .csv, or the output of watch</source>
        <translation>请给出含 JSON 消息或由本程序写出的 .mcap、.csv，或 watch 的输出</translation>
    </message>
    <message>
        <source>overshoot %1, not settled</source>
        <translation>超调 %1，未稳定</translation>
    </message>
    <message>
        <source>overshoot %1, settled in %2</source>
        <translation>超调 %1，稳定用时 %2</translation>
    </message>
    <message>
        <source>seed, loss, bitrate and fault are known</source>
        <translation>已知的有 seed、loss、bitrate 和 fault</translation>
    </message>
    <message>
        <source>within its limits, at attempt %1: samples were lost before</source>
        <translation>第 %1 次尝试时在限值内：此前有采样丢失</translation>
    </message>
    <message>
        <source>its speed goes on swinging by %1 where it should rest, whole counts alone would make %2</source>
        <translation>在应当稳定时其速度仍持续摆动 %1，仅由整数计数引起的为 %2</translation>
    </message>
    <message>
        <source>a count or their largest error makes more output than it may</source>
        <translation>一个计数或其最大误差产生的输出超过允许值</translation>
    </message>
    <message>
        <source>the gains that were there may leave as little error; now those</source>
        <translation>原有的增益也许误差同样小；现在试用它们</translation>
    </message>
    <message>
        <source>their largest sensitivity is %1, at most %2 are allowed, and %3 with more gain and delay</source>
        <translation>其最大灵敏度为 %1，最多允许 %2，增益和时延更大时为 %3</translation>
    </message>
    <message>
        <source>there was no time to compare them with those that were there</source>
        <translation>没有时间与原有的增益比较</translation>
    </message>
    <message>
        <source>they would draw more current than is allowed</source>
        <translation>它们会消耗超过允许的电流</translation>
    </message>
    <message>
        <source>they would overshoot by %1</source>
        <translation>它们会超调 %1</translation>
    </message>
    <message>
        <source>those that were found left more error: these, which were there, leave %1 of it</source>
        <translation>找到的增益误差更大：原有的这些增益误差为其 %1</translation>
    </message>
    <message>
        <source>those that were there leave more error</source>
        <translation>原有的增益误差更大</translation>
    </message>
    <message>
        <source>those that were there would leave less error, but are not for keeping: %1</source>
        <translation>原有的增益误差会更小，但不宜保留：%1</translation>
    </message>
    <message>
        <source>what is left over is much of so small steps; the same with larger ones</source>
        <translation>对这么小的阶跃来说剩余误差太大；用更大的阶跃再做一次</translation>
    </message>
    <message>
        <source>what was there is not known, and these were not compared with it</source>
        <translation>原有的值未知，未与之比较</translation>
    </message>
    <message>
        <source>bus voltage</source>
        <translation>总线电压</translation>
    </message>
    <message>
        <source>direction</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>energy</source>
        <translation>能量</translation>
    </message>
    <message>
        <source>foreign master</source>
        <translation>其他主站</translation>
    </message>
    <message>
        <source>interrupted</source>
        <translation>被中断</translation>
    </message>
    <message>
        <source>lateness</source>
        <translation>延误</translation>
    </message>
    <message>
        <source>link</source>
        <translation>链路</translation>
    </message>
    <message>
        <source>missing guardian</source>
        <translation>无守护进程</translation>
    </message>
    <message>
        <source>no motion</source>
        <translation>无运动</translation>
    </message>
    <message>
        <source>oscillation</source>
        <translation>振荡</translation>
    </message>
    <message>
        <source>refusal</source>
        <translation>拒绝</translation>
    </message>
    <message>
        <source>restart</source>
        <translation>重新启动</translation>
    </message>
    <message>
        <source>sleep</source>
        <translation>休眠</translation>
    </message>
    <message>
        <source>temperature</source>
        <translation>温度</translation>
    </message>
    <message>
        <source>time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>user</source>
        <translation>用户</translation>
    </message>
    <message>
        <source>a step would draw too much current: the unit&apos;s own profile leads, at %1 counts/s at most</source>
        <translation>阶跃会消耗过大的电流：由设备自身的轮廓引导，最高 %1 counts/s</translation>
    </message>
    <message>
        <source>allow more travel, duty or current</source>
        <translation>允许更大行程、占空比或电流</translation>
    </message>
    <message>
        <source>an answer was lost; the same again</source>
        <translation>丢失了一个应答；再来一次</translation>
    </message>
    <message>
        <source>friction takes %1 of what its current limit and its room allow, at most 60 %</source>
        <translation>摩擦占去电流限值和行程所允许的输出的 %1，最多允许 60 %</translation>
    </message>
    <message>
        <source>friction takes more than half of what P makes of a step</source>
        <translation>摩擦占去 P 由阶跃产生的输出的一半以上</translation>
    </message>
    <message>
        <source>its own profile leads there at %1 counts/s</source>
        <translation>由其自身的轮廓以 %1 counts/s 引导到位</translation>
    </message>
    <message>
        <source>see whether the motor is too strong for this unit</source>
        <translation>检查电机对此设备而言是否过强</translation>
    </message>
    <message>
        <source>the unit&apos;s own profile led at %1 counts/s, for a step would draw too much current</source>
        <translation>由设备自身的轮廓以 %1 counts/s 引导，因为阶跃会消耗过大的电流</translation>
    </message>
    <message>
        <source>at most %1 duty, %2 counts/s and %3 counts from where it stands</source>
        <translation>最多占空比 %1、%2 counts/s，离当前位置 %3 个计数</translation>
    </message>
    <message>
        <source>first its direction is checked: %1 counts up</source>
        <translation>先检查方向：向上 %1 个计数</translation>
    </message>
    <message>
        <source>its loop takes its velocity every %1 ms, every %2 ms was expected</source>
        <translation>其环路每 %1 ms 取一次速度，预期为每 %2 ms</translation>
    </message>
    <message>
        <source>perhaps its D acts the other way round than in the firmware that is known</source>
        <translation>也许其 D 的作用方向与已知固件相反</translation>
    </message>
    <message>
        <source>see which firmware it runs</source>
        <translation>检查它运行的是哪个固件</translation>
    </message>
    <message>
        <source>a regression of mean speeds makes the lag %1, %2 beside what was fitted</source>
        <translation>平均速度的回归给出滞后 %1，与拟合值相差 %2</translation>
    </message>
    <message>
        <source>F is 0: in a position loop it would push by where the target lies, not by how far it is</source>
        <translation>F 为 0：在位置环中它会按目标所在的位置出力，而不是按与目标的距离出力</translation>
    </message>
    <message>
        <source>F is 0: with an integral both would give what friction and speed take, and it would overshoot</source>
        <translation>F 为 0：有积分时，两者都会给出摩擦和速度所需的输出，从而产生超调</translation>
    </message>
    <message>
        <source>it is %1</source>
        <translation>它是 %1</translation>
    </message>
    <message>
        <source>number %1 has another session</source>
        <translation>编号 %1 的会话不同</translation>
    </message>
    <message>
        <source>chatter of the duty</source>
        <translation>占空比抖动</translation>
    </message>
    <message>
        <source>encoder</source>
        <translation>编码器</translation>
    </message>
    <message>
        <source>error at rest</source>
        <translation>稳态误差</translation>
    </message>
    <message>
        <source>friction</source>
        <translation>摩擦</translation>
    </message>
    <message>
        <source>gain</source>
        <translation>增益</translation>
    </message>
    <message>
        <source>noise</source>
        <translation>噪声</translation>
    </message>
    <message>
        <source>overshoot</source>
        <translation>超调</translation>
    </message>
    <message>
        <source>peak current</source>
        <translation>峰值电流</translation>
    </message>
    <message>
        <source>resistance</source>
        <translation>电阻</translation>
    </message>
    <message>
        <source>rise</source>
        <translation>上升</translation>
    </message>
    <message>
        <source>settle</source>
        <translation>调节</translation>
    </message>
    <message>
        <source>time at the duty limit</source>
        <translation>处于占空比限值的时间</translation>
    </message>
    <message>
        <source>undershoot</source>
        <translation>下冲</translation>
    </message>
    <message>
        <source>%1 was cleared but reads %2</source>
        <translation>%1 已清除，但读出为 %2</translation>
    </message>
    <message>
        <source>%1: unknown key %2</source>
        <translation>%1：未知的键 %2</translation>
    </message>
    <message>
        <source>%1; the gains of the axis were not known, and are now those that the board starts with</source>
        <translation>%1；该轴的增益此前未知，现在是板启动时的增益</translation>
    </message>
    <message>
        <source>correct it, or delete its row</source>
        <translation>请更正，或删除该行</translation>
    </message>
    <message>
        <source>its cause is there again, or still</source>
        <translation>其原因再次出现，或仍然存在</translation>
    </message>
    <message>
        <source>the gains of axis %1 are not known here: it will be left with those that the board starts with</source>
        <translation>此处不知道轴 %1 的增益：结束后将保留板启动时的增益</translation>
    </message>
    <message>
        <source>the gains of this loop are not known here, so its target begins within %1 of where it is, and goes further as its output is seen to allow it; write its p, d and divisor once</source>
        <translation>此处不知道此回路的增益，因此其目标从当前位置的 %1 以内开始，并在看到其输出允许时逐步放远；请写入一次其 p、d 和 divisor</translation>
    </message>
    <message>
        <source>write &quot;value&quot; or &quot;raw&quot;</source>
        <translation>请写 “value” 或 “raw”</translation>
    </message>
    <message>
        <source>%1 duty makes the motor quicker than %2 counts/s, which are allowed</source>
        <translation>%1 占空比会使电机快于允许的 %2 counts/s</translation>
    </message>
    <message>
        <source>&apos;sqlite3 %1 .recover&apos; tells what it still holds; where it is moved away, a new one is begun</source>
        <translation>“sqlite3 %1 .recover”可显示其中仍有的内容；将其移走后会新建一个</translation>
    </message>
    <message>
        <source>another program holds it: try again when that has ended</source>
        <translation>另一个程序正在占用它：待其结束后重试</translation>
    </message>
    <message>
        <source>look whether its disk is there, has room and is in order</source>
        <translation>检查其磁盘是否存在、有空间且完好</translation>
    </message>
    <message>
        <source>make room on its disk</source>
        <translation>在其磁盘上腾出空间</translation>
    </message>
    <message>
        <source>%1: its value is in &apos;%2&apos;, its unit is &apos;%3&apos;</source>
        <translation>%1：其值以“%2”为单位，而它的单位是“%3”</translation>
    </message>
    <message>
        <source>write it in that unit</source>
        <translation>请用该单位书写</translation>
    </message>
    <message>
        <source>a line has more than %1 bytes</source>
        <translation>有一行超过 %1 字节</translation>
    </message>
    <message>
        <source>allow more duty, speed or travel</source>
        <translation>允许更大占空比、速度或行程</translation>
    </message>
    <message>
        <source>it came to %1 of its step while that was held</source>
        <translation>在阶跃保持期间只到达其 %1</translation>
    </message>
    <message>
        <source>the pushes that its limits leave hardly moved the motor</source>
        <translation>其限值所允许的推动几乎没有使电机移动</translation>
    </message>
    <message>
        <source>it may rest %1 short of its target until its integral has overcome friction</source>
        <translation>在其积分克服摩擦之前，它可能停在目标前 %1 处</translation>
    </message>
    <message>
        <source>%1 has restarted and did not say yet whether it is the same unit</source>
        <translation>%1 已重新启动，尚未说明是否为同一单元</translation>
    </message>
    <message>
        <source>another unit stands in its place by now</source>
        <translation>其位置上现在是另一个单元</translation>
    </message>
    <message>
        <source>look at what it says, then order it again</source>
        <translation>查看其报告的内容，然后再次下达命令</translation>
    </message>
    <message>
        <source>compile an offset of its own, 1 … 99, into its firmware, or leave it alone on the bus</source>
        <translation>在其固件中编译一个专用偏移量（1 … 99），或让它单独留在总线上</translation>
    </message>
    <message>
        <source>what is sent to offset 0 is done by every drive of the bus, and others answer on this one</source>
        <translation>发送到偏移量 0 的内容会被总线上的所有驱动器执行，而此总线上还有其他驱动器应答</translation>
    </message>
    <message>
        <source>the board is told to tell its whole counters; look at the position, and run it again</source>
        <translation>已要求板卡报告其完整计数器；请查看位置，然后再运行一次</translation>
    </message>
    <message>
        <source>%1 settings were written and cannot be read back</source>
        <translation>已写入 %1 项设置，无法回读</translation>
    </message>
    <message>
        <source>1 setting was written and cannot be read back</source>
        <translation>已写入 1 项设置，无法回读</translation>
    </message>
    <message>
        <source>put it on again, and do it again</source>
        <translation>请重新接上，然后再做一次</translation>
    </message>
    <message>
        <source>the unit was taken off while it waited for a number</source>
        <translation>设备在等待编号时被取下</translation>
    </message>
    <message>
        <source>%1 is not told as often as was asked for: %2</source>
        <translation>%1 未按要求的频率上报：%2</translation>
    </message>
    <message>
        <source>%1: the gains were not put back: %2</source>
        <translation>%1：增益未恢复：%2</translation>
    </message>
    <message>
        <source>let it come to rest first</source>
        <translation>请先让它静止</translation>
    </message>
    <message>
        <source>no position for %1</source>
        <translation>%1 内没有位置</translation>
    </message>
    <message>
        <source>the gains were not put back: %1</source>
        <translation>增益未恢复：%1</translation>
    </message>
    <message>
        <source>the gains were not put back: %1; they are offered at the next connection</source>
        <translation>增益未恢复：%1；下次连接时会再次提供</translation>
    </message>
    <message>
        <source>the shaft still turns, so nobody can tell which way it is pushed</source>
        <translation>轴仍在转动，无法判断它被推向哪个方向</translation>
    </message>
    <message>
        <source>the stop was not confirmed by %1</source>
        <translation>%1 未确认停止</translation>
    </message>
    <message>
        <source>what was proven could not be written: %1</source>
        <translation>已验证的值无法写入：%1</translation>
    </message>
    <message>
        <source>what was proven could not be written: %1; what was there before is in force again</source>
        <translation>已验证的值无法写入：%1；之前的值已重新生效</translation>
    </message>
    <message>
        <source>what was proven could not be written: %1; what was there before was not put back: %2; it is offered at the next connection</source>
        <translation>已验证的值无法写入：%1；之前的值未恢复：%2；下次连接时会再次提供</translation>
    </message>
    <message>
        <source>a duty that grew to %1 did not move the motor both ways</source>
        <translation>逐渐增大到 %1 的占空比未能使电机在两个方向上都转动</translation>
    </message>
    <message>
        <source>it lets go at %1 forwards and %2 backwards, known within %3, and takes %4 and %5 while it turns (R² %6)</source>
        <translation>正向在 %1、反向在 %2 时开始转动（误差 %3 以内），转动时需要 %4 和 %5（R² %6）</translation>
    </message>
    <message>
        <source>pushing with a duty that grows to %1 in %2 s</source>
        <translation>正在以 %2 s 内增大到 %1 的占空比推动</translation>
    </message>
    <message>
        <source>there is no room for a duty that grows slowly</source>
        <translation>没有空间施加缓慢增大的占空比</translation>
    </message>
    <message>
        <source>%1 has a time that is more than 140 years from 1970</source>
        <translation>%1 中有距 1970 年超过 140 年的时间</translation>
    </message>
    <message>
        <source>record with the clock set</source>
        <translation>请在校准时钟后录制</translation>
    </message>
    <message>
        <source>an experiment on it has not ended</source>
        <translation>其上的实验尚未结束</translation>
    </message>
    <message>
        <source>begin a queue first</source>
        <translation>请先开始一个队列</translation>
    </message>
    <message>
        <source>firmware is written to a unit here; the link stays open</source>
        <translation>此处正在向一台设备写入固件；链路保持打开</translation>
    </message>
    <message>
        <source>it has passed</source>
        <translation>它已通过</translation>
    </message>
    <message>
        <source>it is being served, or waits for its turn</source>
        <translation>它正在处理或等待轮到</translation>
    </message>
    <message>
        <source>it is not armed, or moves</source>
        <translation>它未解锁，或正在运动</translation>
    </message>
    <message>
        <source>it is not in the queue</source>
        <translation>它不在队列中</translation>
    </message>
    <message>
        <source>it was taken off</source>
        <translation>它已被取下</translation>
    </message>
    <message>
        <source>nothing is served here</source>
        <translation>此处没有处理任何设备</translation>
    </message>
    <message>
        <source>put it on again; it gets a row of its own</source>
        <translation>请重新接上；它会得到自己的一行</translation>
    </message>
    <message>
        <source>take it off and put it on again to serve it once more</source>
        <translation>要再次处理，请取下后重新接上</translation>
    </message>
    <message>
        <source>wait until it has, or stop it</source>
        <translation>请等它结束，或将其停止</translation>
    </message>
    <message>
        <source>wait until it is done, or cancel it</source>
        <translation>请等它完成，或将其取消</translation>
    </message>
    <message>
        <source>after a move with a velocity or a profile it is not known from where this distance counts</source>
        <translation>在速度运动或曲线运动之后，不知道这段距离从哪里算起</translation>
    </message>
    <message>
        <source>avrdude read back all %1 bytes and they are equal, but the port is away</source>
        <translation>avrdude 已读回全部 %1 个字节且一致，但端口不见了</translation>
    </message>
    <message>
        <source>halt it first, or give a position</source>
        <translation>请先让它停住，或给出位置</translation>
    </message>
    <message>
        <source>restart the unit: its old firmware is still there</source>
        <translation>请重启该单元：其旧固件仍在</translation>
    </message>
    <message>
        <source>the drive may hold half a program, and runs again once an update has succeeded</source>
        <translation>驱动器里可能只有半个程序，更新成功后才能再次运行</translation>
    </message>
    <message>
        <source>the motor may be %1 counts from where its loop holds it, and with this P that overflows</source>
        <translation>电机可能距其控制环保持的位置 %1 个计数，用这个 P 会溢出</translation>
    </message>
    <message>
        <source>another adapter has this name now; what was found on the one before is not in the list any more</source>
        <translation>现在另一个适配器使用此名称；先前适配器上找到的设备已不在列表中</translation>
    </message>
    <message>
        <source>another adapter is called %1 now</source>
        <translation>现在另一个适配器名为 %1</translation>
    </message>
    <message>
        <source>close the link, and open it again to see who is there</source>
        <translation>关闭连接后重新打开，以查看那里有谁</translation>
    </message>
    <message>
        <source>another unit answers as number %1: serial number &apos;%2&apos; instead of &apos;%3&apos;</source>
        <translation>另一台设备以编号 %1 应答：序列号为“%2”而不是“%3”</translation>
    </message>
    <message>
        <source>scan again, and update it if it is the one that is meant</source>
        <translation>请重新扫描，确认是所要的设备后再更新</translation>
    </message>
    <message>
        <source>the unit with number %1 has another session than before, and may be another unit: its serial number was not known</source>
        <translation>编号 %1 的设备的会话与之前不同，可能是另一台设备：其序列号未知</translation>
    </message>
    <message>
        <source>begin it once more to serve this unit again</source>
        <translation>重新开始队列即可再次处理此设备</translation>
    </message>
    <message>
        <source>the queue was ended</source>
        <translation>队列已结束</translation>
    </message>
    <message>
        <source>%1 has more than %2 MB that are no samples</source>
        <translation>%1 中有超过 %2 MB 的内容不是采样</translation>
    </message>
    <message>
        <source>%1 was taken away; what memory still has of it is recorded anew</source>
        <translation>%1 已被移走；内存中尚存的部分将重新记录</translation>
    </message>
    <message>
        <source>leave that folder where it is</source>
        <translation>请勿移动或删除该文件夹</translation>
    </message>
    <message>
        <source>the file was deleted while it was written</source>
        <translation>文件在写入过程中被删除</translation>
    </message>
    <message>
        <source>write it anew</source>
        <translation>请重新写入</translation>
    </message>
    <message>
        <source>the kernel does not say what %1 is: a driver holds it up</source>
        <translation>内核未说明 %1 是什么：某个驱动程序阻塞了它</translation>
    </message>
    <message>
        <source>unplug the adapter and plug it in again</source>
        <translation>请拔下适配器后重新插入</translation>
    </message>
    <message>
        <source>its velocity loop begins with the mean speed since it ran last: from %1 to %2 counts/s, with the speed of now, is so much that with its gains the output would turn to full reverse</source>
        <translation>其速度回路以上次运行以来的平均速度开始：连同当前速度从 %1 到 %2 counts/s，跨度过大，按其增益输出会翻转为全反向</translation>
    </message>
    <message>
        <source>stop the motor and let it stand for a while, or lower p</source>
        <translation>停止电机并静置一段时间，或减小 p</translation>
    </message>
    <message>
        <source>stop the motor and let it stand for a while, or write p, d and divisor of the loop once</source>
        <translation>停止电机并静置一段时间，或将该回路的 p、d 和 divisor 写入一次</translation>
    </message>
    <message>
        <source>%1 has restarted, and nobody has looked at it since</source>
        <translation>%1 已重新启动，此后还没有人查看过它</translation>
    </message>
    <message>
        <source>Answers with offset %1 are destroyed on the bus, as where several drives have it and answer at once; offsets are compiled into the firmware, so give one of them another and flash it.</source>
        <translation>偏移量 %1 的应答在总线上被破坏，就像多个驱动器具有同一偏移量并同时应答时那样；偏移量编译在固件中，请为其中一台改用其他偏移量并烧写。</translation>
    </message>
    <message>
        <source>the notebook may offer to put back what was there before: %1</source>
        <translation>试验记录本可能会提出恢复先前的值：%1</translation>
    </message>
    <message>
        <source>turn its shaft until its position is %1 counts away from 0, which shows that it was off, then switch it off and on</source>
        <translation>请转动其轴，直到位置离 0 有 %1 个计数（由此可看出它断过电），然后将其断电再上电</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be above 0 and at most %2</source>
        <translation>“%1”必须大于 0 且不超过 %2</translation>
    </message>
    <message>
        <source>nothing was written, because what is there cannot be kept: %1</source>
        <translation>未写入任何内容，因为无法保留现有内容：%1</translation>
    </message>
    <message>
        <source>where it is left out the unit&apos;s own limit serves</source>
        <translation>省略时采用设备自身的限值</translation>
    </message>
    <message>
        <source>its number holds from its next power cycle on, and nothing proves it before</source>
        <translation>其编号从下次断电重启后生效，此前无法证明</translation>
    </message>
    <message>
        <source>put it back first, as &apos;motorbenchctl set %1 %2&apos; does</source>
        <translation>请先恢复，例如用“motorbenchctl set %1 %2”</translation>
    </message>
    <message>
        <source>trial %1 did not put back what it changed</source>
        <translation>试验 %1 没有恢复它所改的值</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must not be empty</source>
        <translation>“%1”不能为空</translation>
    </message>
    <message>
        <source>the steps in both directions kept their limits; the gains are as they were</source>
        <translation>两个方向的阶跃均在限值之内；增益保持原样</translation>
    </message>
    <message>
        <source>the steps in both directions kept their limits; the gains were written and read back</source>
        <translation>两个方向的阶跃均在限值之内；增益已写入并回读</translation>
    </message>
    <message>
        <source>the steps in both directions kept their limits; the gains were written, which this family cannot read back</source>
        <translation>两个方向的阶跃均在限值之内；增益已写入，此系列无法回读</translation>
    </message>
    <message>
        <source>%1 CAN FD frames are left out, because only classic CAN is read</source>
        <translation>略去了 %1 个 CAN FD 帧，因为只能读取经典 CAN</translation>
    </message>
    <message>
        <source>1 CAN FD frame is left out, because only classic CAN is read</source>
        <translation>略去了 1 个 CAN FD 帧，因为只能读取经典 CAN</translation>
    </message>
    <message>
        <source>a simulated board&apos;s socket has no option &apos;%1&apos;</source>
        <translation>仿真板的套接字没有选项“%1”</translation>
    </message>
    <message>
        <source>it has pace</source>
        <translation>它有 pace</translation>
    </message>
    <message>
        <source>leave one of the two out</source>
        <translation>请去掉其中一个</translation>
    </message>
    <message>
        <source>legal are 0 and 1</source>
        <translation>允许 0 和 1</translation>
    </message>
    <message>
        <source>link option &apos;%1&apos; is there twice</source>
        <translation>链路选项“%1”出现了两次</translation>
    </message>
    <message>
        <source>pace=%1 is no choice</source>
        <translation>pace=%1 不是可选值</translation>
    </message>
    <message>
        <source>the last line has no end, so its frame may be cut short</source>
        <translation>最后一行没有行尾，因此其帧可能被截短</translation>
    </message>
    <message>
        <source>the last line is cut off, and left out</source>
        <translation>最后一行被截断，已略去</translation>
    </message>
    <message>
        <source>nothing proves that its flash has what was written</source>
        <translation>无法证明所写内容已存入其闪存</translation>
    </message>
    <message>
        <source>switch its supply off and on, then do it again: what is read then comes from its flash</source>
        <translation>请断电再上电，然后重做：那时读到的就是其闪存中的内容</translation>
    </message>
    <message>
        <source>take it out of the recipe&apos;s parameters, or serve such units by a recipe of their own</source>
        <translation>请将其从配方的参数中去掉，或为此类设备使用单独的配方</translation>
    </message>
    <message>
        <source>take one of them off, then test the other again</source>
        <translation>请取下其中一台，然后再次测试另一台</translation>
    </message>
    <message>
        <source>this unit does not have %1 of the recipe</source>
        <translation>此设备没有配方中的 %1</translation>
    </message>
    <message>
        <source>two units tell the serial number %1</source>
        <translation>两台设备报告相同的序列号 %1</translation>
    </message>
    <message>
        <source>a stop came before it was begun</source>
        <translation>在它开始之前已下达停止</translation>
    </message>
    <message>
        <source>it has restarted, or a second unit has number %1: another session answers</source>
        <translation>它已重新启动，或者另有一台设备使用编号 %1：应答的是另一个会话</translation>
    </message>
    <message>
        <source>its position is being reset</source>
        <translation>正在将其位置清零</translation>
    </message>
    <message>
        <source>it did not say that it restarts, and may have done so or not</source>
        <translation>它没有应答要重新启动，可能已经重启，也可能没有</translation>
    </message>
    <message>
        <source>restart it once more</source>
        <translation>请再重新启动一次</translation>
    </message>
    <message>
        <source>%1 leads to a terminal that another program serves</source>
        <translation>%1 指向由另一个程序提供服务的终端</translation>
    </message>
    <message>
        <source>%1 takes no bytes any more</source>
        <translation>%1 不再接收字节</translation>
    </message>
    <message>
        <source>a stop that is owed cannot be written down: %1 cannot be used</source>
        <translation>无法记录尚未完成的停止：%1 无法使用</translation>
    </message>
    <message>
        <source>it must be a folder of yours that nobody else may write to</source>
        <translation>它必须是您自己的文件夹，且其他人不能写入</translation>
    </message>
    <message>
        <source>the simulator at %1 does not answer</source>
        <translation>%1 处的模拟器没有应答</translation>
    </message>
    <message>
        <source>a limit switch was met</source>
        <translation>碰到了限位开关</translation>
    </message>
    <message>
        <source>no time was left to prove others</source>
        <translation>没有剩余时间验证其他方案</translation>
    </message>
    <message>
        <source>what these gains do is predicted, and not proven on the motor</source>
        <translation>这些增益的效果是预测的，尚未在电机上验证</translation>
    </message>
    <message>
        <source>what was there is not known, and those that were tried are in force</source>
        <translation>原有内容未知，试过的值正在生效</translation>
    </message>
    <message>
        <source>its averaging was lowered, or set beyond 500, as far as can be known, and until it has lost its power once it may overwrite its own memory</source>
        <translation>据所知，其平均数已减小或被设为超过 500，在断电一次之前，它可能会覆盖自身的存储器</translation>
    </message>
    <message>
        <source>stop the motor before its calibration is changed</source>
        <translation>更改校准之前请先停止电机</translation>
    </message>
    <message>
        <source>the power limit of axis %1 is %2: its motor gets no more</source>
        <translation>轴 %1 的功率限值为 %2：其电机得不到更多</translation>
    </message>
    <message>
        <source>the velocity limit of axis %1 is %2: its motor goes no faster</source>
        <translation>轴 %1 的速度限值为 %2：其电机不会更快</translation>
    </message>
    <message>
        <source>write an averaging of 1 … 500, then switch it off and on</source>
        <translation>请写入 1 … 500 的平均数，然后将其断电再上电</translation>
    </message>
    <message>
        <source>Nothing is written yet. Where OpenOCD has halted the drive already it stands still: switch it off and on</source>
        <translation>尚未写入任何内容。若 OpenOCD 已暂停驱动器，它会保持停止：请断电再上电</translation>
    </message>
    <message>
        <source>firmware is written here, or units are served; nothing was searched</source>
        <translation>此处正在写入固件或正在处理设备；未进行任何搜索</translation>
    </message>
    <message>
        <source>put the programmer on it, and look at the other one</source>
        <translation>请将编程器接到它上面，并检查另一台</translation>
    </message>
    <message>
        <source>the programmer wrote another unit: %1 answered all the while</source>
        <translation>编程器写入了另一台设备：%1 期间一直在应答</translation>
    </message>
    <message>
        <source>wait until it is done</source>
        <translation>请等待其完成</translation>
    </message>
    <message>
        <source>averaging changed: it may overwrite its memory</source>
        <translation>平均数已更改：可能覆盖其内存</translation>
    </message>
    <message>
        <source>the acceptance mask of node %1 is not known, so it may do what is sent to node %2, too; set its error.level to 0 where it is 1, then scan again</source>
        <translation>节点 %1 的接收掩码未知，发送给节点 %2 的内容它可能也会执行；若其 error.level 为 1，请设为 0 后重新扫描</translation>
    </message>
    <message>
        <source>All of it is written; whether the unit runs it is not known then</source>
        <translation>已全部写入；设备能否用它运行则未知</translation>
    </message>
    <message>
        <source>%1 settings are lost with its power</source>
        <translation>%1 项设置断电后丢失</translation>
    </message>
    <message>
        <source>%1 settings hold from its next power cycle on, and nothing proves them before</source>
        <translation>%1 项设置从下次断电重启后生效，此前无法证明</translation>
    </message>
    <message>
        <source>1 setting holds from its next power cycle on, and nothing proves it before</source>
        <translation>1 项设置从下次断电重启后生效，此前无法证明</translation>
    </message>
    <message>
        <source>1 setting is lost with its power</source>
        <translation>1 项设置断电后丢失</translation>
    </message>
    <message>
        <source>a unit whose %1 was lowered must lose its power once before its motor may be driven</source>
        <translation>%1 被减小的设备必须先断电一次，才允许驱动其电机</translation>
    </message>
    <message>
        <source>leave &apos;store&apos; out: its settings are lost with its power</source>
        <translation>去掉 &apos;store&apos;：其设置断电后丢失</translation>
    </message>
    <message>
        <source>leave it out of the file, or the self-test out of the recipe</source>
        <translation>从文件中去掉它，或从配方中去掉自检</translation>
    </message>
    <message>
        <source>no link is open on which such units may be</source>
        <translation>没有打开可能连接此类设备的链路</translation>
    </message>
    <message>
        <source>no unit has failed that is still there</source>
        <translation>没有仍在线的失败设备</translation>
    </message>
    <message>
        <source>open it first</source>
        <translation>请先打开它</translation>
    </message>
    <message>
        <source>the search ends here, because firmware is written or units are served; what it found stays</source>
        <translation>因正在写入固件或处理设备，搜索到此结束；已找到的保留</translation>
    </message>
    <message>
        <source>Abstract DC Drives so old that they answer no broadcast (dialect LL) are found at this bit rate only by their number, or by %1</source>
        <translation>不响应广播的旧式 Abstract DC Drive（方言 LL）在此比特率下只能通过其编号或 %1 找到</translation>
    </message>
    <message>
        <source>interrupted before it was done</source>
        <translation>完成之前被中断</translation>
    </message>
    <message>
        <source>run it again to finish</source>
        <translation>再运行一次以完成</translation>
    </message>
    <message>
        <source>the last run of %1 was begun by another program, which still runs</source>
        <translation>%1 的上一次运行由另一个程序开始，该程序仍在运行</translation>
    </message>
    <message>
        <source>a drive of dialect LL hears its stop, too, and would be started by it</source>
        <translation>方言 LL 的驱动器也会收到它的停止命令，并会因此启动</translation>
    </message>
    <message>
        <source>coarse</source>
        <translation>粗糙</translation>
    </message>
    <message>
        <source>current limit</source>
        <translation>电流限制</translation>
    </message>
    <message>
        <source>derivative noise</source>
        <translation>微分噪声</translation>
    </message>
    <message>
        <source>did not move</source>
        <translation>未运动</translation>
    </message>
    <message>
        <source>do it once more if it is the same</source>
        <translation>若是同一台，请再执行一次</translation>
    </message>
    <message>
        <source>largest error</source>
        <translation>最大误差</translation>
    </message>
    <message>
        <source>limit switch</source>
        <translation>限位开关</translation>
    </message>
    <message>
        <source>margin</source>
        <translation>裕度</translation>
    </message>
    <message>
        <source>not symmetric</source>
        <translation>不对称</translation>
    </message>
    <message>
        <source>ramp</source>
        <translation>斜坡</translation>
    </message>
    <message>
        <source>restart needed</source>
        <translation>需要重启</translation>
    </message>
    <message>
        <source>samples lost</source>
        <translation>采样丢失</translation>
    </message>
    <message>
        <source>saturated</source>
        <translation>饱和</translation>
    </message>
    <message>
        <source>stop not confirmed</source>
        <translation>停止未确认</translation>
    </message>
    <message>
        <source>stopped before its motor turned</source>
        <translation>在其电机转动之前已停止</translation>
    </message>
    <message>
        <source>the unit tells no current in ampere: the duty limit stands in for %1 A</source>
        <translation>设备不以安培给出电流：由占空比限值代替 %1 A</translation>
    </message>
    <message>
        <source>this place, not this unit: what is kept may be of another</source>
        <translation>是此位置，而非此设备：所保存的可能属于另一台</translation>
    </message>
    <message>
        <source>%1 answers, and a programmer would not tell them apart: take all others off the line</source>
        <translation>%1 有应答，而编程器无法区分它们：请将其他设备全部从线路上取下</translation>
    </message>
    <message>
        <source>P, I and D are divided by it. Blank flash holds 0, with which no loop works; 0 is never written. A negative divisor keeps the integral across modes: to reverse the loop, change the signs of P, I and D.</source>
        <translation>P、I 和 D 除以它。空白闪存中为 0，此时任何回路都不工作；绝不会写入 0。负除数会在切换模式时保留积分：要使回路反向，请更改 P、I 和 D 的符号。</translation>
    </message>
    <message>
        <source>Samples of 20 ms in a mean of the current, which reads wrong until so many were taken: it is changed at a standstill. Once lowered, the drive must lose its power for a moment before it is driven.</source>
        <translation>电流平均值中 20 ms 采样的个数；采满这么多之前电流读数是错误的，因此在电机静止时更改。一旦减小，驱动器在被驱动之前必须短暂断电。</translation>
    </message>
    <message>
        <source>%1 cannot blink</source>
        <translation>%1 不能闪烁</translation>
    </message>
    <message>
        <source>%1 has no name</source>
        <translation>%1 没有名称</translation>
    </message>
    <message>
        <source>choose a free one</source>
        <translation>请选择空闲的一个</translation>
    </message>
    <message>
        <source>lower them, or raise the divisor</source>
        <translation>减小它们，或增大除数</translation>
    </message>
    <message>
        <source>no device of %1 can have the fault &apos;%2&apos;</source>
        <translation>%1 上没有设备可以有故障“%2”</translation>
    </message>
    <message>
        <source>p and d are so high for the divisor that an error of 1 turns the output to full reverse</source>
        <translation>p 和 d 相对于除数过大，偏差为 1 就会使输出翻转为全反向</translation>
    </message>
    <message>
        <source>the motor is so far from its target that with this value the output would turn to full reverse</source>
        <translation>电机离目标太远，用这个值输出会翻转为全反向</translation>
    </message>
    <message>
        <source>until it has averaged once it reads a wrong current</source>
        <translation>在完成一次平均之前，读到的电流是错误的</translation>
    </message>
    <message>
        <source>give --velocity, or write a lower profile.velocity</source>
        <translation>请指定 --velocity，或写入更小的 profile.velocity</translation>
    </message>
    <message>
        <source>somebody searches here already</source>
        <translation>这里已经在搜索</translation>
    </message>
    <message>
        <source>%1 no longer goes back by itself: the unit was gone or has restarted</source>
        <translation>%1 不再自动恢复：该单元曾无应答或已重新启动</translation>
    </message>
    <message>
        <source>at most %1 counts/s with its P</source>
        <translation>用它的 P 最多 %1 counts/s</translation>
    </message>
    <message>
        <source>its adapter has another name now; what was found under this one is not in the list any more</source>
        <translation>其适配器现在使用另一个名称；在此名称下找到的设备已不在列表中</translation>
    </message>
    <message>
        <source>node %1 is on this line, too: it hears what the bootloader is told, and may be the one that is written</source>
        <translation>节点 %1 也在这条线路上：它会听到发给引导程序的内容，被写入的可能就是它</translation>
    </message>
    <message>
        <source>take all others off the line and scan it, or use a programmer on the pins</source>
        <translation>将其他所有设备从线路上断开并搜索该线路，或使用接在引脚上的编程器</translation>
    </message>
    <message>
        <source>%1 cannot be told to brake or to coast</source>
        <translation>无法指示 %1 制动或滑行</translation>
    </message>
    <message>
        <source>%1 cannot exchange directions</source>
        <translation>%1 不能交换方向</translation>
    </message>
    <message>
        <source>%1 has no limit override</source>
        <translation>%1 不能覆盖限位</translation>
    </message>
    <message>
        <source>%1 has no ramp of the output in mode &apos;%2&apos;</source>
        <translation>%1 在模式“%2”下没有输出斜坡</translation>
    </message>
    <message>
        <source>docs/bench.md has the options of each family, and what they take</source>
        <translation>各系列的选项及其取值见 docs/bench.md</translation>
    </message>
    <message>
        <source>it is being recorded or replayed</source>
        <translation>正在记录或回放</translation>
    </message>
    <message>
        <source>name a notebook that can be written</source>
        <translation>给出可写入的试验记录本</translation>
    </message>
    <message>
        <source>option &apos;%1&apos; is there twice</source>
        <translation>选项“%1”出现了两次</translation>
    </message>
    <message>
        <source>seed and bitrate are whole numbers, loss is a fraction below 1</source>
        <translation>seed 和 bitrate 是整数，loss 是小于 1 的小数</translation>
    </message>
    <message>
        <source>the file is for family &apos;%1&apos;, the device is of &apos;%2&apos;</source>
        <translation>文件用于系列“%1”，而设备属于“%2”</translation>
    </message>
    <message>
        <source>the rest of its disk is left to others</source>
        <translation>磁盘的剩余空间留给其他程序</translation>
    </message>
    <message>
        <source>%1 keeps no setting without power</source>
        <translation>%1 断电后不保留任何设置</translation>
    </message>
    <message>
        <source>cut its power and try again after 10 minutes, or look at it and say in the window that it stands</source>
        <translation>切断其电源，10 分钟后重试，或查看后在窗口中确认它已静止</translation>
    </message>
    <message>
        <source>the motor did not move when it was sent %1 counts up (%2 counts): stalled, or the encoder is dead</source>
        <translation>命令电机向上移动 %1 个计数时它未运动（%2 个计数）：堵转，或编码器失效</translation>
    </message>
    <message>
        <source>see that motor and load are those of the recipe and that its time is enough, then test again</source>
        <translation>检查电机和负载是否为配方所指定的，以及配方的时间是否足够，然后重新测试</translation>
    </message>
    <message>
        <source>%1 is %2 of its smallest steps, fewer than %3: one of them is %4</source>
        <translation>%1 只有其最小级差的 %2 倍，少于 %3：一个级差为 %4</translation>
    </message>
    <message>
        <source>allow more current or aim for a calmer loop</source>
        <translation>允许更大电流或选用更平缓的回路</translation>
    </message>
    <message>
        <source>any step of these gains draws more than the %1 A that are allowed</source>
        <translation>用这些增益做任何阶跃都会超过允许的 %1 A</translation>
    </message>
    <message>
        <source>at most %1 duty and %2 counts from where it stands, at a speed that nobody knows yet</source>
        <translation>最多占空比 %1，离当前位置 %2 个计数，速度尚不可知</translation>
    </message>
    <message>
        <source>first its direction is checked: pushes of 0.3 s, until it turns</source>
        <translation>先检查方向：每次推 0.3 s，直到转动</translation>
    </message>
    <message>
        <source>no gains as the device stores them keep a largest sensitivity of %1 in this loop</source>
        <translation>按设备存储的取值，此回路没有增益能保持最大灵敏度 %1</translation>
    </message>
    <message>
        <source>left out before it was done</source>
        <translation>未完成即被跳过</translation>
    </message>
    <message>
        <source>load 9 × rotor inertia · 4096 counts a turn</source>
        <translation>负载 9 × 转子惯量 · 每转 4096 个计数</translation>
    </message>
    <message>
        <source>4096 counts a turn</source>
        <translation>每转 4096 个计数</translation>
    </message>
    <message>
        <source>reset it without the jumper of its bootloader</source>
        <translation>取下其引导程序的跳线后复位</translation>
    </message>
    <message>
        <source>N20 geared</source>
        <translation>带减速箱的 N20</translation>
    </message>
    <message>
        <source>gear 75.81:1 · 32768 counts a turn</source>
        <translation>减速比 75.81:1 · 每转 32768 个计数</translation>
    </message>
    <message>
        <source>%1; update it</source>
        <translation>%1；请更新它</translation>
    </message>
    <message>
        <source>%1; update it, or %2</source>
        <translation>%1；请更新它，或%2</translation>
    </message>
    <message>
        <source>nothing answers: no power, wrong wiring, another rate, or no program that runs</source>
        <translation>无应答：没有电源、接线错误、速率不同，或没有可运行的程序</translation>
    </message>
    <message>
        <source>stored, and the unit has proved it</source>
        <translation>已存储，并由设备证实</translation>
    </message>
    <message>
        <source>the device did not write its flash within %1 s</source>
        <translation>设备未在 %1 s 内写入其闪存</translation>
    </message>
    <message>
        <source>%1 is busy: %2</source>
        <translation>%1 忙：%2</translation>
    </message>
    <message>
        <source>%1 is driven already</source>
        <translation>%1 已在被驱动</translation>
    </message>
    <message>
        <source>%1 is not armed</source>
        <translation>%1 未解锁</translation>
    </message>
    <message>
        <source>%1 keeps its last set-point for ever: it has no watchdog</source>
        <translation>%1 会永久保持其最后的设定值：它没有看门狗</translation>
    </message>
    <message>
        <source>assign one a new number first</source>
        <translation>请先为其中一台分配新编号</translation>
    </message>
    <message>
        <source>drive it from the Tune page</source>
        <translation>请从“整定”页面驱动它</translation>
    </message>
    <message>
        <source>halt it first</source>
        <translation>请先停止它</translation>
    </message>
    <message>
        <source>no %1 is known on this link, so STOP could not reach it</source>
        <translation>此链路上没有已知的 %1，STOP 将无法到达它</translation>
    </message>
    <message>
        <source>no open CAN link is shown</source>
        <translation>当前未显示已打开的 CAN 链路</translation>
    </message>
    <message>
        <source>open one first</source>
        <translation>请先打开一个</translation>
    </message>
    <message>
        <source>scan first</source>
        <translation>请先扫描</translation>
    </message>
    <message>
        <source>select it, then hold Arm in the header</source>
        <translation>请选中它，然后按住标题栏中的“解锁”</translation>
    </message>
    <message>
        <source>they were proven by %1 steps instead of %2</source>
        <translation>经 %1 次而非 %2 次阶跃验证</translation>
    </message>
    <message>
        <source>two units answer as %1</source>
        <translation>有两台设备以 %1 应答</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>is told no more to stop after 10 minutes: the motor may still turn, cut its power</source>
        <translation>10 分钟后不再向其发送停止指令：电机可能仍在转动，请切断其电源</translation>
    </message>
    <message>
        <source>no time was left to do the same again</source>
        <translation>没有剩余时间再做一次</translation>
    </message>
    <message>
        <source>%1: %2 → %3</source>
        <translation>%1：%2 → %3</translation>
    </message>
    <message>
        <source>%1: ? → %2</source>
        <translation>%1：? → %2</translation>
    </message>
    <message>
        <source>allow all of it within little travel, or tune it by hand with &apos;motorbenchctl step&apos;</source>
        <translation>在较小行程内允许全部占空比，或用 'motorbenchctl step' 手动整定</translation>
    </message>
    <message>
        <source>allow more duty or aim for a calmer loop</source>
        <translation>允许更大占空比或选用更平缓的回路</translation>
    </message>
    <message>
        <source>it may rest %1 short of its target, which its allowable error lets it</source>
        <translation>它可能停在距目标 %1 处，其允许误差容许如此</translation>
    </message>
    <message>
        <source>nothing of its own keeps a position loop of %1 to %2 duty</source>
        <translation>%1 没有自身的限值能把位置回路保持在占空比 %2</translation>
    </message>
    <message>
        <source>others that may leave less error were given up: %1</source>
        <translation>其他可能误差更小的增益已放弃：%1</translation>
    </message>
    <message>
        <source>take a larger response</source>
        <translation>选用更长的响应时间</translation>
    </message>
    <message>
        <source>the smallest step that proves these gains puts out %1 duty, %2 are allowed, and the unit has no limit of its own that keeps it to them</source>
        <translation>验证这些增益的最小阶跃输出占空比 %1，允许 %2，而该单元没有能使其保持在此范围内的自身限值</translation>
    </message>
    <message>
        <source>the smallest step that proves these gains takes %1 counts of travel, %2 are allowed</source>
        <translation>验证这些增益的最小阶跃需要 %1 个计数的行程，允许 %2</translation>
    </message>
    <message>
        <source>these are given up: %1</source>
        <translation>放弃这些：%1</translation>
    </message>
    <message>
        <source>these gains would overshoot by %1, and at most %2 are kept</source>
        <translation>这些增益会超调 %1，最多保留 %2</translation>
    </message>
    <message>
        <source>they would put out more duty than is allowed</source>
        <translation>它们会输出超过允许的占空比</translation>
    </message>
    <message>
        <source>whether gains of an experiment are still to be put back is not known yet: %1</source>
        <translation>尚不清楚是否还有实验更改的增益需要恢复：%1</translation>
    </message>
</context>
</TS>
