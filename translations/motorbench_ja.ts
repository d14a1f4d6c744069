<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ja" sourcelanguage="en">
<context>
    <name>AnalysisText</name>
    <message>
        <source>%1: peak %2 at %3 Hz</source>
        <translation>%1: ピーク %2 (%3 Hz)</translation>
    </message>
    <message>
        <source>%1: fewer than 16 samples connect</source>
        <translation>%1: 連続するサンプルが16未満です</translation>
    </message>
    <message>
        <source>the longest stretch without a gap</source>
        <translation>欠落のない最長区間</translation>
    </message>
    <message>
        <source>%1 against %2</source>
        <translation>%1 対 %2</translation>
    </message>
    <message>
        <source>%1 points, every %2. sample</source>
        <translation>%1 点、%2 サンプルごと</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 点</translation>
    </message>
    <message>
        <source>%1: peak –</source>
        <translation>%1: ピーク –</translation>
    </message>
</context>
<context>
    <name>AxisParameters</name>
    <message>
        <source>axis %1</source>
        <translation>軸 %1</translation>
    </message>
</context>
<context>
    <name>AxisText</name>
    <message>
        <source>Axis %1</source>
        <translation>軸 %1</translation>
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
        <translation>識別 (点滅)</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>名前の変更…</translation>
    </message>
    <message>
        <source>Assign another number…</source>
        <translation>別の番号を割り当て…</translation>
    </message>
    <message>
        <source>Read and clear faults</source>
        <translation>フォルトの読出しとクリア</translation>
    </message>
    <message>
        <source>faults read and cleared</source>
        <translation>フォルトを読み出してクリアしました</translation>
    </message>
    <message>
        <source>Stop and count from 0</source>
        <translation>停止して 0 から計数</translation>
    </message>
    <message>
        <source>position 0 is here; the motor is off</source>
        <translation>現在位置を 0 としました。モーターはオフです</translation>
    </message>
    <message>
        <source>Copy %1</source>
        <translation>%1 をコピー</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation>%1 の名前の変更</translation>
    </message>
    <message>
        <source>Name, 1 … 64 characters (some tools show only 28):</source>
        <translation>名前、1 … 64 文字 (28 文字しか表示しないツールもあります):</translation>
    </message>
    <message>
        <source>renamed to %1</source>
        <translation>名前を %1 に変更しました</translation>
    </message>
    <message>
        <source>Number of %1</source>
        <translation>%1 の番号</translation>
    </message>
    <message>
        <source>New number, 1 … %1. %2 is the next free one on this link:</source>
        <translation>新しい番号、1 … %1。このリンクで次に空いている番号は %2 です:</translation>
    </message>
    <message>
        <source>number %1 is taken on this link; nothing was sent</source>
        <translation>番号 %1 はこのリンクで使用中です。何も送信していません</translation>
    </message>
    <message>
        <source>answers as number %1 now</source>
        <translation>番号 %1 で応答するようになりました</translation>
    </message>
    <message>
        <source>%1 cannot be opened: a link address has no place for the question mark in it. Rename it.</source>
        <translation>%1 を開けません: リンクアドレスにはファイル名の疑問符を入れられません。ファイル名を変更してください。</translation>
    </message>
    <message>
        <source>blinks</source>
        <translation>点滅します</translation>
    </message>
</context>
<context>
    <name>DeviceText</name>
    <message>
        <source>%1 of %2 axes move</source>
        <translation>%2 軸中 %1 軸が動作中</translation>
    </message>
    <message>
        <source>%1 axes</source>
        <translation>%1 軸</translation>
    </message>
    <message>
        <source>No answer: %1</source>
        <translation>応答なし: %1</translation>
    </message>
    <message>
        <source>The device refused: %1</source>
        <translation>機器が拒否しました: %1</translation>
    </message>
    <message>
        <source>Unexpected answer: %1</source>
        <translation>予期しない応答: %1</translation>
    </message>
    <message>
        <source>Differs: %1</source>
        <translation>不一致: %1</translation>
    </message>
    <message>
        <source>Link lost: %1</source>
        <translation>リンク切断: %1</translation>
    </message>
    <message>
        <source>Not possible: %1</source>
        <translation>実行できません: %1</translation>
    </message>
    <message>
        <source>Cancelled</source>
        <translation>キャンセルしました</translation>
    </message>
    <message>
        <source>Not done: %1</source>
        <translation>未実行: %1</translation>
    </message>
    <message>
        <source>axis %1: %2</source>
        <translation>軸 %1: %2</translation>
    </message>
    <message>
        <source>off</source>
        <translation>オフ</translation>
    </message>
    <message>
        <source>duty</source>
        <translation>デューティ</translation>
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
        <translation>電流</translation>
    </message>
    <message>
        <source>voltage</source>
        <translation>電圧</translation>
    </message>
    <message>
        <source>follow</source>
        <translation>追従</translation>
    </message>
    <message>
        <source>profiled position</source>
        <translation>プロファイル位置</translation>
    </message>
    <message>
        <source>profiled velocity</source>
        <translation>プロファイル速度</translation>
    </message>
    <message>
        <source>busy</source>
        <translation>ビジー</translation>
    </message>
    <message>
        <source>two units, one number</source>
        <translation>2 台が同じ番号</translation>
    </message>
    <message>
        <source>no number yet</source>
        <translation>番号未設定</translation>
    </message>
    <message>
        <source>bootloader, needs firmware</source>
        <translation>ブートローダ、要ファームウェア</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>応答なし</translation>
    </message>
    <message>
        <source>online</source>
        <translation>オンライン</translation>
    </message>
    <message>
        <source>keeps a move</source>
        <translation>動作指令を保持</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>on</source>
        <translation>オン</translation>
    </message>
    <message>
        <source>boot</source>
        <translation>ブート</translation>
    </message>
    <message>
        <source>2 ×</source>
        <translation>2 ×</translation>
    </message>
    <message>
        <source>Serial number %1</source>
        <translation>シリアル番号 %1</translation>
    </message>
    <message>
        <source>Dialect %1</source>
        <translation>ダイアレクト %1</translation>
    </message>
    <message>
        <source>It keeps a move that was stopped before it began, and would begin it with the next start on its line. A new move replaces it; switching the unit off clears it.</source>
        <translation>開始前に停止した動作指令を保持しており、同じ回線で次の開始指令が出ると動き始めます。新しい動作指令で置き換わり、機器の電源を切ると消えます。</translation>
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
        <translation>フォルトなし</translation>
    </message>
</context>
<context>
    <name>DialogText</name>
    <message>
        <source>Signals that a formula may use</source>
        <translation>数式で使用できる信号</translation>
    </message>
    <message>
        <source>Double click puts the name into the formula</source>
        <translation>ダブルクリックで名前を数式に挿入します</translation>
    </message>
    <message>
        <source>Note at this time</source>
        <translation>この時刻のメモ</translation>
    </message>
    <message>
        <source>What happened</source>
        <translation>何が起きたか</translation>
    </message>
    <message>
        <source>Add note</source>
        <translation>メモの追加</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名前</translation>
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
        <translation>counts/s², A, …</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>単位</translation>
    </message>
    <message>
        <source>Formula</source>
        <translation>数式</translation>
    </message>
    <message>
        <source>+ − * / ^ ( ) · derivative(x) · integral(x) · average(x, seconds) · abs, sqrt, sin, min, max … · values are in the unit of the device</source>
        <translation>+ − * / ^ ( ) · derivative(x) · integral(x) · average(x, 秒) · abs, sqrt, sin, min, max … · 値は機器の単位</translation>
    </message>
    <message>
        <source>Add signal</source>
        <translation>信号の追加</translation>
    </message>
    <message>
        <source>Export samples</source>
        <translation>サンプルのエクスポート</translation>
    </message>
    <message>
        <source>Stretch</source>
        <translation>区間</translation>
    </message>
    <message>
        <source>What is seen</source>
        <translation>表示範囲</translation>
    </message>
    <message>
        <source>A … B</source>
        <translation>A … B</translation>
    </message>
    <message>
        <source>Whole session</source>
        <translation>セッション全体</translation>
    </message>
    <message>
        <source>Show the cursors first: L</source>
        <translation>先にカーソルを表示: L</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>信号</translation>
    </message>
    <message>
        <source>Plotted signals</source>
        <translation>プロット中の信号</translation>
    </message>
    <message>
        <source>All signals of all devices</source>
        <translation>全機器の全信号</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>種類</translation>
    </message>
    <message>
        <source>CSV table</source>
        <translation>CSV 表</translation>
    </message>
    <message>
        <source>MCAP recording</source>
        <translation>MCAP 記録</translation>
    </message>
    <message>
        <source>Both carry units, the devices with their parameters, notes, and how many samples were lost. MCAP opens in PlotJuggler and Foxglove.</source>
        <translation>どちらも単位、機器とそのパラメータ、メモ、欠落したサンプル数を含みます。MCAP は PlotJuggler と Foxglove で開けます。</translation>
    </message>
    <message>
        <source>Choose file…</source>
        <translation>ファイルの選択…</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>表 (*.csv)</translation>
    </message>
    <message>
        <source>MCAP recording (*.mcap)</source>
        <translation>MCAP 記録 (*.mcap)</translation>
    </message>
</context>
<context>
    <name>FileText</name>
    <message>
        <source>family “%1”</source>
        <translation>ファミリ「%1」</translation>
    </message>
    <message>
        <source>Parameter files (*.json)</source>
        <translation>パラメータファイル (*.json)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>すべてのファイル (*)</translation>
    </message>
    <message>
        <source>Choose another file.</source>
        <translation>別のファイルを選択してください。</translation>
    </message>
    <message>
        <source>Choose a file of this family. Nothing was changed.</source>
        <translation>このファミリのファイルを選択してください。何も変更していません。</translation>
    </message>
    <message>
        <source>Nothing was changed.</source>
        <translation>何も変更していません。</translation>
    </message>
    <message>
        <source>%1 is not a parameter file.</source>
        <translation>%1 はパラメータファイルではありません。</translation>
    </message>
    <message>
        <source>Choose a file that Export… or motorbenchctl get --file wrote.</source>
        <translation>「エクスポート…」または motorbenchctl get --file で書き出したファイルを選択してください。</translation>
    </message>
    <message>
        <source>%1 is for %2, which is not in this program.</source>
        <translation>%1 は %2 用ですが、そのファミリはこのプログラムにありません。</translation>
    </message>
    <message>
        <source>%1 is for %2, %3 is of the family %4.</source>
        <translation>%1 は %2 用ですが、%3 は %4 ファミリです。</translation>
    </message>
</context>
<context>
    <name>FrameFilterParser</name>
    <message>
        <source>&apos;)&apos; has no &apos;(&apos; before it</source>
        <translation>「)」の前に「(」がありません</translation>
    </message>
    <message>
        <source>&apos;%1&apos; needs a term before it</source>
        <translation>「%1」の前に項が必要です</translation>
    </message>
    <message>
        <source>a term is missing after &apos;%1&apos;</source>
        <translation>「%1」の後に項がありません</translation>
    </message>
    <message>
        <source>&apos;(&apos; is not closed: a &apos;)&apos; is missing</source>
        <translation>「(」が閉じていません: 「)」がありません</translation>
    </message>
    <message>
        <source>more than %1 brackets and negations inside each other</source>
        <translation>括弧と否定の入れ子が %1 段を超えています</translation>
    </message>
</context>
<context>
    <name>FrameTermReader</name>
    <message>
        <source>&apos;%1&apos;: a comparison begins with field., such as field.%1</source>
        <translation>「%1」: 比較は field. で始めます (例: field.%1)</translation>
    </message>
    <message>
        <source>&apos;%1:&apos; has nothing after the colon</source>
        <translation>「%1:」のコロンの後に何もありません</translation>
    </message>
    <message>
        <source>&apos;%1:&apos; is not known; id, family, message, device, dir, data, is and field. are</source>
        <translation>「%1:」は不明です。使えるのは id、family、message、device、dir、data、is、field. です</translation>
    </message>
    <message>
        <source>&apos;%1:&apos; is not known; &apos;%2:&apos; is</source>
        <translation>「%1:」は不明です。「%2:」が使えます</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no identifier: hexadecimal such as 0x2061405, 0x2061* or 100..1FF</source>
        <translation>「%1」は識別子ではありません: 16 進数で指定します (例: 0x2061405、0x2061*、100..1FF)</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no device number: such as 5, 5,7 or 1..9</source>
        <translation>「%1」は機器番号ではありません (例: 5、5,7、1..9)</translation>
    </message>
    <message>
        <source>&apos;%1&apos; are no bytes: hexadecimal such as A125*, without blanks</source>
        <translation>「%1」はバイト列ではありません: 空白なしの 16 進数で指定します (例: A125*)</translation>
    </message>
    <message>
        <source>no family is called &apos;%1&apos;; there is %2</source>
        <translation>「%1」というファミリはありません。あるのは %2 です</translation>
    </message>
    <message>
        <source>&apos;dir:%1&apos; is not known; dir:rx and dir:tx are</source>
        <translation>「dir:%1」は不明です。使えるのは dir:rx と dir:tx です</translation>
    </message>
    <message>
        <source>&apos;is:%1&apos; is not known; tx, rx, extended, standard, remote, error, unknown, known and control are</source>
        <translation>「is:%1」は不明です。使えるのは tx、rx、extended、standard、remote、error、unknown、known、control です</translation>
    </message>
    <message>
        <source>&apos;field.&apos; needs the name of a field, such as field.trgt&gt;100</source>
        <translation>「field.」にはフィールド名が必要です (例: field.trgt&gt;100)</translation>
    </message>
    <message>
        <source>&apos;field.%1%2&apos; needs a number behind it</source>
        <translation>「field.%1%2」の後に数値が必要です</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no number</source>
        <translation>「%1」は数値ではありません</translation>
    </message>
    <message>
        <source>identifier, hexadecimal</source>
        <translation>識別子、16 進数</translation>
    </message>
    <message>
        <source>what the decoder says</source>
        <translation>デコーダの表示内容</translation>
    </message>
    <message>
        <source>a field by its name: its number, % of full scale, or that there is one</source>
        <translation>名前で指定するフィールド: その数値、フルスケールに対する %、または有無</translation>
    </message>
    <message>
        <source>bytes, hexadecimal</source>
        <translation>バイト列、16 進数</translation>
    </message>
    <message>
        <source>direction; error, remote, extended, standard, unknown, known; makes a motor move</source>
        <translation>方向。error、remote、extended、standard、unknown、known。モーターを動かすもの</translation>
    </message>
    <message>
        <source>a bare word: part of a message, family or identifier</source>
        <translation>単独の語: メッセージ、ファミリ、識別子の一部</translation>
    </message>
    <message>
        <source>terms beside each other must all hold</source>
        <translation>並べた項はすべて成立する必要があります</translation>
    </message>
    <message>
        <source>* stands for any characters, ? for one, a comma for or.</source>
        <translation>* は任意の文字列、? は任意の 1 文字、コンマは「または」を表します。</translation>
    </message>
</context>
<context>
    <name>FrameText</name>
    <message>
        <source>remote</source>
        <translation>リモート</translation>
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
        <translation>%1 あたりの throttle × 除数</translation>
    </message>
    <message>
        <source>throttle per %1</source>
        <translation>%1 あたりの throttle</translation>
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
        <translation>欠落 %1</translation>
    </message>
    <message>
        <source>%1 gaps, %2</source>
        <translation>欠落 %1 か所、%2</translation>
    </message>
</context>
<context>
    <name>HelpTitles</name>
    <message>
        <source>First hour</source>
        <translation>最初の 1 時間</translation>
    </message>
    <message>
        <source>Connecting</source>
        <translation>接続</translation>
    </message>
    <message>
        <source>Tuning by itself</source>
        <translation>オートチューニング</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>プロット</translation>
    </message>
    <message>
        <source>Service</source>
        <translation>保守</translation>
    </message>
    <message>
        <source>Recipes</source>
        <translation>レシピ</translation>
    </message>
    <message>
        <source>Safety</source>
        <translation>安全</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>Troubleshooting</source>
        <translation>トラブルシューティング</translation>
    </message>
    <message>
        <source>Hardware: %1</source>
        <translation>ハードウェア: %1</translation>
    </message>
</context>
<context>
    <name>Languages</name>
    <message>
        <source>English</source>
        <comment>the name of this language in itself</comment>
        <translation>日本語</translation>
    </message>
    <message>
        <source>en</source>
        <comment>the code of this language, as in the name of its file</comment>
        <translation>ja</translation>
    </message>
</context>
<context>
    <name>LeapText</name>
    <message>
        <source>%1 × as large as now, %2.</source>
        <translation>現在の %1 倍、%2。</translation>
    </message>
    <message>
        <source>%1 × smaller than now, %2.</source>
        <translation>現在の 1/%1、%2。</translation>
    </message>
</context>
<context>
    <name>LinkChoices</name>
    <message>
        <source>up</source>
        <translation>動作中</translation>
    </message>
    <message>
        <source>switched off</source>
        <translation>オフ</translation>
    </message>
    <message>
        <source>bus-off</source>
        <translation>バスオフ</translation>
    </message>
    <message>
        <source>no permission</source>
        <translation>権限なし</translation>
    </message>
    <message>
        <source>not there</source>
        <translation>存在しません</translation>
    </message>
    <message>
        <source>ready</source>
        <translation>準備完了</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>A recording of frames…</source>
        <translation>フレームの記録…</translation>
    </message>
    <message>
        <source>file</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>Plays a candump or Vector ASC log as if its bus were here. Nothing can be sent.</source>
        <translation>candump または Vector ASC のログを、そのバスがあるかのように再生します。送信はできません。</translation>
    </message>
    <message>
        <source>The whole simulated bench</source>
        <translation>シミュレーションベンチ全体</translation>
    </message>
    <message>
        <source>Simulated CAN bus</source>
        <translation>シミュレーション CAN バス</translation>
    </message>
    <message>
        <source>Simulated serial line</source>
        <translation>シミュレーションシリアル回線</translation>
    </message>
    <message>
        <source>Simulated SPI board</source>
        <translation>シミュレーション SPI 基板</translation>
    </message>
    <message>
        <source>CAN interfaces</source>
        <translation>CAN インターフェース</translation>
    </message>
    <message>
        <source>Serial ports</source>
        <translation>シリアルポート</translation>
    </message>
    <message>
        <source>SPI devices</source>
        <translation>SPI デバイス</translation>
    </message>
    <message>
        <source>Recordings</source>
        <translation>記録</translation>
    </message>
    <message>
        <source>Without hardware</source>
        <translation>ハードウェアなし</translation>
    </message>
    <message>
        <source>Serial port</source>
        <translation>シリアルポート</translation>
    </message>
    <message>
        <source>SPI device</source>
        <translation>SPI デバイス</translation>
    </message>
    <message>
        <source>CAN interface</source>
        <translation>CAN インターフェース</translation>
    </message>
    <message>
        <source>%1, at the real speed of their link.</source>
        <translation>%1。リンクの実際の速度で動きます。</translation>
    </message>
    <message>
        <source>Controllers of every family with real bus timing; nothing real can move.</source>
        <translation>実際のバスタイミングで動くすべてのファミリのコントローラ。実物は動きません。</translation>
    </message>
</context>
<context>
    <name>MuteUnits</name>
    <message>
        <source>Number of the unit that does not answer, %1 … %2. No other one of its family may answer there: a programmer would not tell them apart.</source>
        <translation>応答しない機器の番号、%1 … %2。そこで同じファミリの別の機器が応答してはいけません。書き込み装置では区別できません。</translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>No link is open whose units a programmer writes</source>
        <translation>書き込み装置で書き込む機器のリンクは開いていません</translation>
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
        <translation>ライブ、%1</translation>
    </message>
    <message>
        <source>paused, %1</source>
        <translation>一時停止、%1</translation>
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
        <translation>平均 A…B</translation>
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
        <translation>σ、%1 サンプル</translation>
    </message>
    <message>
        <source>slope</source>
        <translation>傾き</translation>
    </message>
    <message>
        <source>/s</source>
        <translation>/s</translation>
    </message>
    <message>
        <source>%1 %2 to %3</source>
        <translation>%1 %2 ～ %3</translation>
    </message>
    <message>
        <source>%1 no data</source>
        <translation>%1 データなし</translation>
    </message>
    <message>
        <source>, now %1</source>
        <translation>、現在 %1</translation>
    </message>
    <message>
        <source>, 1 gap</source>
        <translation>、欠落 1 か所</translation>
    </message>
    <message numerus="yes">
        <source>, %n gaps</source>
        <translation>
            <numerusform>、欠落 %n か所</numerusform>
        </translation>
    </message>
    <message>
        <source>No traces</source>
        <translation>波形なし</translation>
    </message>
    <message>
        <source>Last %1: %2</source>
        <translation>直近 %1: %2</translation>
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
        <translation>元に戻す(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>やり直し(&amp;R)</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>切り取り(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>コピー(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>貼り付け(&amp;P)</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>削除</translation>
    </message>
    <message>
        <source>Select All</source>
        <translation>すべて選択</translation>
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
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>ヘルプ</translation>
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
        <translation>Space</translation>
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
        <translation>%1 Hz、%3 中 %2 欠落</translation>
    </message>
</context>
<context>
    <name>Stories</name>
    <message>
        <source>Select</source>
        <translation>選択</translation>
    </message>
    <message>
        <source>Click %1 in the list at the left. Everything that follows is about it.</source>
        <translation>左のリストで %1 をクリックします。以降はすべてこの機器についての操作です。</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>駆動許可</translation>
    </message>
    <message>
        <source>Hold the Arm button at the top, SAFE, for one second (or Ctrl+Shift+F12). Nothing moves before. Esc stops, always.</source>
        <translation>上部の駆動許可ボタン「安全」を 1 秒間押し続けます (または Ctrl+Shift+F12)。それまでは何も動きません。Esc でいつでも停止します。</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>ステップ</translation>
    </message>
    <message>
        <source>Tune</source>
        <translation>調整</translation>
    </message>
    <message>
        <source>Store</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Click %1 in the list at the left.</source>
        <translation>左のリストで %1 をクリックします。</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>制限</translation>
    </message>
    <message>
        <source>Hold the Arm button at the top for one second (or Ctrl+Shift+F12).</source>
        <translation>上部の駆動許可ボタンを 1 秒間押し続けます (または Ctrl+Shift+F12)。</translation>
    </message>
    <message>
        <source>%1 overshoots: tame it in a minute</source>
        <translation>%1 がオーバーシュート: 1 分で抑える</translation>
    </message>
    <message>
        <source>velocity, set-point dashed</source>
        <translation>速度、破線は目標値</translation>
    </message>
    <message>
        <source>%1 has no current limit: set one that saves it</source>
        <translation>%1 に電流制限なし: 保護する値を設定</translation>
    </message>
    <message>
        <source>current, limit dashed</source>
        <translation>電流、破線は制限値</translation>
    </message>
    <message>
        <source>Press %2: the motor steps to a speed and back, and the overshoot is measured.</source>
        <translation>%2 を押します: モーターがある速度までステップ応答して戻り、オーバーシュートが測定されます。</translation>
    </message>
    <message>
        <source>Press %2 on the page Design: the program finds gains and proves them. Tamed: a step overshoots by 5 % at most.</source>
        <translation>「設計」ページで %2 を押します: プログラムがゲインを求めて検証します。ステップのオーバーシュートが 5 % 以下になれば完了です。</translation>
    </message>
    <message>
        <source>Press %2 on the page Tune: the peak current of the step stands in its table.</source>
        <translation>「調整」ページで %2 を押します: ステップのピーク電流が表に表示されます。</translation>
    </message>
    <message>
        <source>the button</source>
        <translation>ボタン</translation>
    </message>
    <message>
        <source>Arrive</source>
        <translation>到達</translation>
    </message>
    <message>
        <source>What P makes of the last counts is less than friction. Enter among the gains %5 (a stiffer P overcomes it, and more D keeps it from swinging), and press %2 again: it rests within 5 counts of its target.</source>
        <translation>最後の数カウントで P が出す力は摩擦に足りません。ゲインに %5 を入力し (P を上げると摩擦に勝ち、D を上げると振動しません)、もう一度 %2 を押します: 目標から 5 カウント以内で止まります。</translation>
    </message>
    <message>
        <source>%1 stops short: make it arrive</source>
        <translation>%1 が手前で止まる: 目標まで届かせる</translation>
    </message>
    <message>
        <source>This one stops about %4 counts short and stays there. Make it arrive.</source>
        <translation>約 %4 カウント手前で止まったままになります。目標まで届かせましょう。</translation>
    </message>
    <message>
        <source>position, set-point dashed</source>
        <translation>位置、破線は目標値</translation>
    </message>
    <message>
        <source>On the page Tune choose Position: what is armed is armed for one mode. Then hold the Arm button at the top for one second (or Ctrl+Shift+F12).</source>
        <translation>「調整」ページで位置を選びます: 駆動許可は一つのモードにだけ有効です。次に上部の駆動許可ボタンを 1 秒間押し続けます (または Ctrl+Shift+F12)。</translation>
    </message>
    <message>
        <source>Enter %3 as the target (behind ▸) and press %2: the motor goes there and back, and stops about %4 counts short.</source>
        <translation>目標 (▸ の後) に %3 を入力して %2 を押します: モータは往復し、約 %4 カウント手前で止まります。</translation>
    </message>
    <message>
        <source>%6Press Store and prove on the page Parameters: done when the unit proves that its flash has the gains.</source>
        <translation>%6「パラメータ」ページで「保存して検証」を押してください。機器のフラッシュにゲインがあることが証明されると完了です。</translation>
    </message>
    <message>
        <source>On the page Parameters switch the current limit on (search: %7), set it to what the motor may have, and write.</source>
        <translation>「パラメータ」ページで電流制限をオンにし (検索: %7)、モーターの許容値に設定して書き込みます。</translation>
    </message>
    <message>
        <source>%6Press Store and prove on the page Parameters.</source>
        <translation>%6「パラメータ」ページで「保存して検証」を押してください。</translation>
    </message>
    <message>
        <source>With these gains it goes too far. Find some with which it does not.</source>
        <translation>このゲインでは行き過ぎます。行き過ぎないゲインを見つけてください。</translation>
    </message>
    <message>
        <source>Stalled, it draws all that its supply gives, and nothing holds it back. Limit it.</source>
        <translation>拘束されると電源が出せるだけの電流が流れ、抑えるものがありません。制限してください。</translation>
    </message>
    <message>
        <source>It stores by itself %1 s after its last change: wait for that.</source>
        <translation>最後の変更から %1 s 後に自動で保存します。それを待ってください。</translation>
    </message>
</context>
<context>
    <name>TriggerText</name>
    <message>
        <source>trigger armed, waiting</source>
        <translation>トリガ待機中</translation>
    </message>
    <message>
        <source>single event caught</source>
        <translation>単発イベントを捕捉</translation>
    </message>
    <message>
        <source>event %1, filling</source>
        <translation>イベント %1、取込み中</translation>
    </message>
    <message>
        <source>event %1, waiting for the next</source>
        <translation>イベント %1、次を待機中</translation>
    </message>
</context>
<context>
    <name>TypedFrameText</name>
    <message>
        <source>&apos;%1&apos; is no frame such as 02061405#8125</source>
        <translation>「%1」はフレームではありません (例: 02061405#8125)</translation>
    </message>
    <message>
        <source>The identifier is hexadecimal, such as 7FF or 02061405</source>
        <translation>識別子は 16 進数です (例: 7FF、02061405)</translation>
    </message>
    <message>
        <source>%1 has more than 29 bits: at most 1FFFFFFF</source>
        <translation>%1 は 29 ビットを超えています: 最大 1FFFFFFF</translation>
    </message>
    <message>
        <source>%1 has more than 11 bits: choose 29 bits</source>
        <translation>%1 は 11 ビットを超えています: 29 ビットを選択してください</translation>
    </message>
    <message>
        <source>The data are pairs of hexadecimal digits, such as 81 25 11</source>
        <translation>データは 2 桁ずつの 16 進数です (例: 81 25 11)</translation>
    </message>
    <message>
        <source>%1 bytes: a frame has at most 8</source>
        <translation>%1 バイト: フレームは最大 8 バイトです</translation>
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
        <translation>なくなった機器</translation>
    </message>
    <message>
        <source>%1 on %2</source>
        <translation>%1 (%2)</translation>
    </message>
</context>
<context>
    <name>ValueText</name>
    <message>
        <source>Enter %1.</source>
        <translation>%1 を入力してください。</translation>
    </message>
    <message>
        <source>Enter %1, or a percentage such as %2.</source>
        <translation>%1、または %2 のような百分率を入力してください。</translation>
    </message>
    <message>
        <source>%1 is above %2.</source>
        <translation>%1 は %2 を上回っています。</translation>
    </message>
    <message>
        <source>%1 is below %2.</source>
        <translation>%1 は %2 を下回っています。</translation>
    </message>
    <message>
        <source>%1 is not a whole number.</source>
        <translation>%1 は整数ではありません。</translation>
    </message>
    <message>
        <source>A number is missing.</source>
        <translation>数値がありません。</translation>
    </message>
    <message>
        <source>“%1” is not a number.</source>
        <translation>「%1」は数値ではありません。</translation>
    </message>
    <message>
        <source>on</source>
        <translation>オン</translation>
    </message>
    <message>
        <source>off</source>
        <translation>オフ</translation>
    </message>
    <message>
        <source>off or on</source>
        <translation>オフまたはオン</translation>
    </message>
</context>
<context>
    <name>drawings</name>
    <message>
        <source>3.3 V only</source>
        <translation>3.3 V 専用</translation>
    </message>
    <message>
        <source>57 600 or 115 200 bit/s</source>
        <translation>57 600 または 115 200 bit/s</translation>
    </message>
    <message>
        <source>60 A, 100 A for 2 s</source>
        <translation>60 A、2 s 間は 100 A</translation>
    </message>
    <message>
        <source>A, B, index</source>
        <translation>A、B、インデックス</translation>
    </message>
    <message>
        <source>Battery, 12 V</source>
        <translation>バッテリー、12 V</translation>
    </message>
    <message>
        <source>Breaker</source>
        <translation>ブレーカー</translation>
    </message>
    <message>
        <source>Bridge and motor</source>
        <translation>ブリッジとモータ</translation>
    </message>
    <message>
        <source>CAN adapter</source>
        <translation>CAN アダプタ</translation>
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
        <translation>ドライブ、オフセット 1</translation>
    </message>
    <message>
        <source>Drive, offset 2</source>
        <translation>ドライブ、オフセット 2</translation>
    </message>
    <message>
        <source>Encoder board</source>
        <translation>エンコーダ基板</translation>
    </message>
    <message>
        <source>GPIO in</source>
        <translation>GPIO 入力</translation>
    </message>
    <message>
        <source>GPIO out</source>
        <translation>GPIO 出力</translation>
    </message>
    <message>
        <source>Host</source>
        <translation>ホスト</translation>
    </message>
    <message>
        <source>J4 closed only for 3.3 V, before power</source>
        <translation>J4 は 3.3 V のときだけ、通電前に閉じる</translation>
    </message>
    <message>
        <source>Motor</source>
        <translation>モータ</translation>
    </message>
    <message>
        <source>Motor supply</source>
        <translation>モータ電源</translation>
    </message>
    <message>
        <source>P1 MISO · P2 Vcc · P3 SCK · P4 MOSI · P5 reset · P6 ground</source>
        <translation>P1 MISO · P2 Vcc · P3 SCK · P4 MOSI · P5 リセット · P6 グラウンド</translation>
    </message>
    <message>
        <source>PA4 current, PA3 heat</source>
        <translation>PA4 電流、PA3 温度</translation>
    </message>
    <message>
        <source>Pads for a programmer</source>
        <translation>プログラマ用パッド</translation>
    </message>
    <message>
        <source>Programmer</source>
        <translation>プログラマ</translation>
    </message>
    <message>
        <source>STM32F1 or F4</source>
        <translation>STM32F1 または F4</translation>
    </message>
    <message>
        <source>Supermodified, node 4</source>
        <translation>Supermodified、ノード 4</translation>
    </message>
    <message>
        <source>Supermodified, node 5</source>
        <translation>Supermodified、ノード 5</translation>
    </message>
    <message>
        <source>USB to RS-485</source>
        <translation>USB – RS-485</translation>
    </message>
    <message>
        <source>a Raspberry Pi, say</source>
        <translation>例: Raspberry Pi</translation>
    </message>
    <message>
        <source>and a switch</source>
        <translation>とスイッチを</translation>
    </message>
    <message>
        <source>closed: bootloader</source>
        <translation>閉: ブートローダ</translation>
    </message>
    <message>
        <source>each its own number</source>
        <translation>それぞれ別の番号</translation>
    </message>
    <message>
        <source>each its own offset</source>
        <translation>それぞれ別のオフセット</translation>
    </message>
    <message>
        <source>ground</source>
        <translation>グラウンド</translation>
    </message>
    <message>
        <source>ground in common</source>
        <translation>グラウンド共通</translation>
    </message>
    <message>
        <source>ground, 3.3 V</source>
        <translation>グラウンド、3.3 V</translation>
    </message>
    <message>
        <source>motor, 6 A</source>
        <translation>モータ、6 A</translation>
    </message>
    <message>
        <source>number 1 … 63</source>
        <translation>番号 1 … 63</translation>
    </message>
    <message>
        <source>on the computer</source>
        <translation>コンピュータに接続</translation>
    </message>
    <message>
        <source>one host only</source>
        <translation>ホストは 1 台だけ</translation>
    </message>
    <message>
        <source>or a supply that</source>
        <translation>または回生を</translation>
    </message>
    <message>
        <source>own driver</source>
        <translation>専用ドライバ</translation>
    </message>
    <message>
        <source>takes braking</source>
        <translation>吸収できる電源</translation>
    </message>
    <message>
        <source>transceiver at PA11, PA12</source>
        <translation>PA11、PA12 にトランシーバ</translation>
    </message>
    <message>
        <source>up to 35 V</source>
        <translation>35 V まで</translation>
    </message>
    <message>
        <source>with encoder</source>
        <translation>エンコーダ付き</translation>
    </message>
    <message>
        <source>within reach</source>
        <translation>手の届く所に</translation>
    </message>
</context>
<context>
    <name>mb::About</name>
    <message>
        <source>About MotorBench</source>
        <translation>MotorBench について</translation>
    </message>
    <message>
        <source>Tunes and services brushed-DC motor controllers. Free software under the GNU General Public License, version 3 or later, without any warranty.</source>
        <translation>ブラシ付き DC モーターコントローラの調整と保守を行います。GNU General Public License バージョン 3 以降によるフリーソフトウェアであり、いかなる保証もありません。</translation>
    </message>
    <message>
        <source>Versions and licences</source>
        <translation>バージョンとライセンス</translation>
    </message>
    <message>
        <source>Copy versions</source>
        <translation>バージョン情報をコピー</translation>
    </message>
</context>
<context>
    <name>mb::AddLinkDialog</name>
    <message>
        <source>Add a link</source>
        <translation>リンクの追加</translation>
    </message>
    <message>
        <source>Links that can be added</source>
        <translation>追加できるリンク</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>リンク</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状態</translation>
    </message>
    <message>
        <source>open</source>
        <translation>接続中</translation>
    </message>
    <message>
        <source>none found</source>
        <translation>見つかりません</translation>
    </message>
    <message>
        <source>Command for a terminal</source>
        <translation>端末用コマンド</translation>
    </message>
    <message>
        <source>Address of the link</source>
        <translation>リンクのアドレス</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>アドレス</translation>
    </message>
    <message>
        <source>Open it at every start</source>
        <translation>起動のたびに開く</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>開く</translation>
    </message>
    <message>
        <source>Choose the file…</source>
        <translation>ファイルを選択…</translation>
    </message>
</context>
<context>
    <name>mb::AdvicePanel</name>
    <message>
        <source>Why it did that</source>
        <translation>この動きの理由</translation>
    </message>
    <message>
        <source>Stages these values; nothing is written yet.</source>
        <translation>これらの値を書込み待ちにします。まだ書き込みません。</translation>
    </message>
</context>
<context>
    <name>mb::AdviceText</name>
    <message>
        <source>F·K is %1 with I active: the initial lag is paid back as overshoot.</source>
        <translation>I が有効で F·K が %1 です: 初期の遅れがオーバーシュートとして現れます。</translation>
    </message>
    <message>
        <source>It stops %1 counts short: P alone does not overcome friction there.</source>
        <translation>%1 カウント手前で止まります: そこでは P だけでは摩擦に勝てません。</translation>
    </message>
    <message>
        <source>A gain has only %1 steps of its integer; it cannot be set finely.</source>
        <translation>ゲインの整数が %1 段階しかなく、細かく設定できません。</translation>
    </message>
    <message>
        <source>One count of the sensor moves the duty by %1 % through D; 10 % is the most that is quiet.</source>
        <translation>センサの 1 カウントが D を介してデューティを %1 % 動かします。静かに動く上限は 10 % です。</translation>
    </message>
    <message>
        <source>The drive&apos;s ramp takes %1 to full duty, which is slower than this loop.</source>
        <translation>ドライブのランプは最大デューティまで %1 かかり、この制御ループより遅くなっています。</translation>
    </message>
    <message>
        <source>The duty was at its limit for %1: the loop cannot go faster there.</source>
        <translation>デューティが %1 の間、上限に達していました: 制御ループはそこではこれ以上速くできません。</translation>
    </message>
    <message>
        <source>The duty was at its limit for %1 while I went on; that is paid back as overshoot.</source>
        <translation>I が積分を続ける間、デューティが %1 の間上限に達していました。これがオーバーシュートとして現れます。</translation>
    </message>
    <message>
        <source>The measured velocity is %1 late; the gains are too lively for that.</source>
        <translation>測定速度が %1 遅れています。それに対してゲインが過敏です。</translation>
    </message>
    <message>
        <source>The velocity comes anew every %1 only; a loop cannot be quicker than that.</source>
        <translation>速度は %1 ごとにしか更新されません。制御ループはそれより速くできません。</translation>
    </message>
    <message>
        <source>It moved late, at %1 % duty: friction holds it until then.</source>
        <translation>動き出しが遅く、デューティ %1 % で動きました: それまでは摩擦で止まっています。</translation>
    </message>
    <message>
        <source>It takes %1 % duty to stay in place: a load pulls one way.</source>
        <translation>位置の保持にデューティ %1 % が必要です: 負荷が一方向に引いています。</translation>
    </message>
    <message>
        <source>It swings by %1 counts without end: play between motor and load.</source>
        <translation>%1 カウントの振れが止まりません: モーターと負荷の間に遊びがあります。</translation>
    </message>
    <message>
        <source>Stage %1</source>
        <translation>%1 を書込み待ちに追加</translation>
    </message>
</context>
<context>
    <name>mb::AdviserList</name>
    <message>
        <source>staged</source>
        <translation>書込み待ち</translation>
    </message>
    <message>
        <source>ok</source>
        <translation>正常</translation>
    </message>
    <message>
        <source>fixed in the set</source>
        <translation>この組で解消</translation>
    </message>
    <message>
        <source>mind it</source>
        <translation>注意</translation>
    </message>
    <message>
        <source>to fix</source>
        <translation>要対処</translation>
    </message>
    <message>
        <source>not read</source>
        <translation>未読取り</translation>
    </message>
    <message>
        <source>This loop has no F that could fight with I.</source>
        <translation>このループには I と競合する F がありません。</translation>
    </message>
    <message>
        <source>uS/kp = %1: below this error only I moves the shaft.</source>
        <translation>uS/kp = %1: これより小さい誤差では I だけが軸を動かします。</translation>
    </message>
    <message>
        <source>uS/kp = %1: below this error nothing moves the shaft.</source>
        <translation>uS/kp = %1: これより小さい誤差では軸は動きません。</translation>
    </message>
    <message>
        <source>That is over 2 % of the step.</source>
        <translation>ステップの 2 % を超えています。</translation>
    </message>
    <message>
        <source>The drive&apos;s least output helps.</source>
        <translation>ドライブの最小出力が補います。</translation>
    </message>
    <message>
        <source>No gain of the set is an integer of its own.</source>
        <translation>この組に整数のゲインはありません。</translation>
    </message>
    <message>
        <source>%1 is %2 steps of its integer, at least %3 are wanted: one step is %4 %.</source>
        <translation>%1 は整数で %2 段階です。%3 以上が望まれます: 1 段階は %4 % です。</translation>
    </message>
    <message>
        <source>This drive has no ramp of its own.</source>
        <translation>このドライブに独自のランプはありません。</translation>
    </message>
    <message>
        <source>The drive&apos;s ramp was not read yet.</source>
        <translation>ドライブのランプはまだ読み取っていません。</translation>
    </message>
    <message>
        <source>The drive&apos;s ramp is off.</source>
        <translation>ドライブのランプはオフです。</translation>
    </message>
    <message>
        <source>Full duty takes %1, over τc/2 = %2: it acts as lag.</source>
        <translation>最大デューティまで %1 かかり、τc/2 = %2 を超えています: 遅れとして働きます。</translation>
    </message>
    <message>
        <source>Full duty takes %1, under τc/2 = %2.</source>
        <translation>最大デューティまで %1 で、τc/2 = %2 未満です。</translation>
    </message>
    <message>
        <source>F–I conflict</source>
        <translation>F–I の競合</translation>
    </message>
    <message>
        <source>Deadband</source>
        <translation>不感帯</translation>
    </message>
    <message>
        <source>D noise</source>
        <translation>D のノイズ</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>分解能</translation>
    </message>
    <message>
        <source>Ramp</source>
        <translation>ランプ</translation>
    </message>
    <message>
        <source>D is 0: one count moves no duty.</source>
        <translation>D は 0 です: 1 カウントではデューティは動きません。</translation>
    </message>
    <message>
        <source>One count moves the duty by %1 % through D; %2 % is the most that is quiet.</source>
        <translation>1 カウントが D を介してデューティを %1 % 動かします。静かに動く上限は %2 % です。</translation>
    </message>
    <message>
        <source>Advisers</source>
        <translation>アドバイザ</translation>
    </message>
    <message>
        <source>for %1, slot %2</source>
        <translation>%1、スロット %2</translation>
    </message>
    <message>
        <source>for %1</source>
        <translation>%1</translation>
    </message>
    <message>
        <source>Take back</source>
        <translation>取り消す</translation>
    </message>
    <message>
        <source>Stages these values; nothing is written yet.</source>
        <translation>これらの値を書込み待ちにします。まだ書き込みません。</translation>
    </message>
    <message>
        <source>Stage</source>
        <translation>書込み待ちに追加</translation>
    </message>
    <message>
        <source>F and I in force give back %1 of the step as overshoot. The set has no F.</source>
        <translation>現在の F と I ではステップの %1 がオーバーシュートとして現れます。この組に F はありません。</translation>
    </message>
    <message>
        <source>F and I give back %1 of the step as overshoot.</source>
        <translation>F と I によりステップの %1 がオーバーシュートとして現れます。</translation>
    </message>
    <message>
        <source>F and I give nothing back as overshoot.</source>
        <translation>F と I によりオーバーシュートとして現れるものはありません。</translation>
    </message>
</context>
<context>
    <name>mb::AgainstView</name>
    <message>
        <source>plot written to %1</source>
        <translation>プロットを %1 に書き出しました</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>画像をコピー</translation>
    </message>
    <message>
        <source>One signal against another</source>
        <translation>信号対信号</translation>
    </message>
    <message>
        <source>Signal across</source>
        <translation>横軸の信号</translation>
    </message>
    <message>
        <source>Signal upwards</source>
        <translation>縦軸の信号</translation>
    </message>
    <message>
        <source>against</source>
        <translation>対</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1、%2</translation>
    </message>
    <message>
        <source>A … B: </source>
        <translation>A … B: </translation>
    </message>
    <message>
        <source>what is seen: </source>
        <translation>表示範囲: </translation>
    </message>
</context>
<context>
    <name>mb::Arming</name>
    <message>
        <source>%1: cut its power</source>
        <translation>%1: 電源を切ってください</translation>
    </message>
    <message>
        <source>experiment</source>
        <translation>実験</translation>
    </message>
    <message>
        <source>until it is seen</source>
        <translation>確認できるまで</translation>
    </message>
    <message>
        <source>nothing to arm</source>
        <translation>駆動許可の対象なし</translation>
    </message>
    <message>
        <source>arming off while busy</source>
        <translation>処理中は駆動許可不可</translation>
    </message>
    <message>
        <source>%1 cannot be armed</source>
        <translation>%1 は駆動許可できません</translation>
    </message>
    <message>
        <source>not sent to %1</source>
        <translation>%1 には未送信</translation>
    </message>
    <message>
        <source>it is not heard</source>
        <translation>信号が届いていません</translation>
    </message>
    <message>
        <source>%1 may still turn</source>
        <translation>%1 はまだ回転している可能性があります</translation>
    </message>
    <message>
        <source>not armed: %1</source>
        <translation>駆動許可できません: %1</translation>
    </message>
    <message>
        <source>armed</source>
        <translation>駆動許可中</translation>
    </message>
    <message>
        <source>%1 guard, %2</source>
        <comment>guard and what tripped it</comment>
        <translation>%1 ガード、%2</translation>
    </message>
    <message>
        <source>STOP: %1</source>
        <translation>STOP: %1</translation>
    </message>
    <message>
        <source>STOP: %1; not sent to %2</source>
        <translation>STOP: %1。%2 には送信されていません</translation>
    </message>
    <message>
        <source>this window did not respond for %1 s</source>
        <translation>このウィンドウが %1 s 間応答しませんでした</translation>
    </message>
    <message>
        <source>disarmed after %1 min without motion</source>
        <translation>%1 min 間動作がなかったため駆動許可を解除しました</translation>
    </message>
    <message>
        <source>the device is gone</source>
        <translation>機器がなくなりました</translation>
    </message>
    <message>
        <source>it has restarted</source>
        <translation>再起動しました</translation>
    </message>
    <message>
        <source>an experiment on it has not ended</source>
        <translation>この機器での実験がまだ終わっていません</translation>
    </message>
    <message>
        <source>the computer slept</source>
        <translation>コンピューターがスリープしていました</translation>
    </message>
</context>
<context>
    <name>mb::AxesPanel</name>
    <message>
        <source>Axes</source>
        <translation>軸</translation>
    </message>
    <message>
        <source>together</source>
        <translation>同時</translation>
    </message>
    <message>
        <source>All axes run together</source>
        <translation>全軸を同時に動作</translation>
    </message>
    <message>
        <source>Run starts every ticked axis at the same moment, each with its own mode and set-point.</source>
        <translation>実行すると、チェックした全軸がそれぞれのモードと目標値で同時に開始します。</translation>
    </message>
    <message>
        <source>Copy gains from…</source>
        <translation>ゲインをコピー…</translation>
    </message>
    <message>
        <source>Stages the gains and limits of another axis for this one.</source>
        <translation>別の軸のゲインと制限を、この軸の書込み待ちにします。</translation>
    </message>
    <message>
        <source>Same set-point for all ticked</source>
        <translation>チェックした全軸に同じ目標値</translation>
    </message>
    <message>
        <source>Mode and set-point of this axis for every ticked one; a position becomes the same distance.</source>
        <translation>この軸のモードと目標値を、チェックした全軸に適用します。位置は同じ移動量になります。</translation>
    </message>
    <message>
        <source>Shows this axis: its mode, set-point, gains, limits and traces</source>
        <translation>この軸を表示: モード、目標値、ゲイン、制限、波形</translation>
    </message>
    <message>
        <source>Axis %1 runs together with the others</source>
        <translation>軸 %1 は他の軸と同時に動作します</translation>
    </message>
    <message>
        <source>Run always moves the axis that is shown.</source>
        <translation>実行すると、表示中の軸が必ず動きます。</translation>
    </message>
    <message>
        <source>Run moves this axis, too, at the same moment.</source>
        <translation>実行すると、この軸も同時に動きます。</translation>
    </message>
</context>
<context>
    <name>mb::AxisCells</name>
    <message>
        <source>Axes</source>
        <translation>軸</translation>
    </message>
    <message>
        <source>Shows this axis in Parameters, Tune and Plots</source>
        <translation>この軸をパラメータ、調整、プロットに表示します</translation>
    </message>
</context>
<context>
    <name>mb::AxisChoice</name>
    <message>
        <source>Which axis</source>
        <translation>対象の軸</translation>
    </message>
    <message>
        <source>All axes</source>
        <translation>全軸</translation>
    </message>
    <message>
        <source>Board</source>
        <translation>基板</translation>
    </message>
    <message>
        <source>Copy from</source>
        <translation>コピー元</translation>
    </message>
    <message>
        <source>Copy gains and limits from another axis</source>
        <translation>別の軸からゲインと制限をコピー</translation>
    </message>
    <message>
        <source>Stages the gains and limits of another axis for this one; Write sends them.</source>
        <translation>別の軸のゲインと制限を、この軸の書込み待ちにします。「書込み」で送信します。</translation>
    </message>
    <message>
        <source>Gains and limits of axis %1</source>
        <translation>軸 %1 のゲインと制限</translation>
    </message>
</context>
<context>
    <name>mb::Banner</name>
    <message>
        <source>Dismiss</source>
        <translation>閉じる</translation>
    </message>
</context>
<context>
    <name>mb::BannerStack</name>
    <message>
        <source>1 more notice</source>
        <translation>ほか 1 件の通知</translation>
    </message>
    <message numerus="yes">
        <source>%n more notices</source>
        <translation>
            <numerusform>ほか %n 件の通知</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mb::BatteryDialog</name>
    <message>
        <source>Battery of steps</source>
        <translation>連続ステップ試験</translation>
    </message>
    <message>
        <source>Run the battery</source>
        <translation>連続試験を実行</translation>
    </message>
    <message>
        <source>Steps of the battery and the worst of each metric</source>
        <translation>連続試験のステップと各指標の最悪値</translation>
    </message>
    <message>
        <source>Responses of the battery over each other</source>
        <translation>連続試験の応答の重ね表示</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>share of the step</source>
        <translation>ステップに対する比</translation>
    </message>
    <message>
        <source>Step, %1</source>
        <translation>ステップ、%1</translation>
    </message>
    <message>
        <source>%1 steps, both ways in turn, from %2 to %3 %4, with the gains in force. The motor turns; each step keeps inside the limits of the page.</source>
        <translation>%1 回のステップを両方向交互に、%2 から %3 %4 まで、現在のゲインで行います。モーターが回転します。各ステップはページの制限内に収まります。</translation>
    </message>
    <message>
        <source>Step %1 of %2: to %3 %4. STOP ends it.</source>
        <translation>ステップ %1/%2: %3 %4 へ。STOP で終了します。</translation>
    </message>
    <message>
        <source>Ended: %1</source>
        <translation>終了: %1</translation>
    </message>
    <message>
        <source>Ended by: %1</source>
        <translation>終了要因: %1</translation>
    </message>
    <message>
        <source>Done: %1 trials in the notebook.</source>
        <translation>完了: %1 件の試行をノートに記録しました。</translation>
    </message>
    <message>
        <source>Ended before all steps were run.</source>
        <translation>全ステップの実行前に終了しました。</translation>
    </message>
    <message>
        <source>worst</source>
        <translation>最悪</translation>
    </message>
    <message>
        <source>DEMO</source>
        <translation>デモ</translation>
    </message>
    <message>
        <source>Arm the device first: hold the Arm button for 1 s.</source>
        <translation>先に機器を駆動許可してください: 駆動許可ボタンを 1 s 押し続けます。</translation>
    </message>
    <message>
        <source>Responses over each other</source>
        <translation>応答の重ね表示</translation>
    </message>
    <message>
        <source>forwards</source>
        <translation>正方向</translation>
    </message>
    <message>
        <source>backwards</source>
        <translation>逆方向</translation>
    </message>
    <message>
        <source>Not run: %1</source>
        <translation>実行しません: %1</translation>
    </message>
    <message>
        <source>Not started, the page has changed: %1</source>
        <translation>開始していません。ページが変わりました: %1</translation>
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
        <translation>ファームウェア</translation>
    </message>
    <message>
        <source>parameters</source>
        <translation>パラメータ</translation>
    </message>
    <message>
        <source>%1 equal</source>
        <translation>%1 一致</translation>
    </message>
    <message>
        <source>unusual, %1</source>
        <translation>通常と異なる、%1</translation>
    </message>
    <message>
        <source>Connect a unit</source>
        <translation>機器を接続</translation>
    </message>
    <message>
        <source>It starts by itself when it answers on %1.</source>
        <translation>%1 で応答すると自動的に開始します。</translation>
    </message>
    <message>
        <source>Open a recipe, then Start</source>
        <translation>レシピを開いて開始</translation>
    </message>
    <message>
        <source>The motor turns in a moment</source>
        <translation>まもなくモーターが回転します</translation>
    </message>
    <message>
        <source>Safe to unplug</source>
        <translation>取り外し可</translation>
    </message>
    <message>
        <source>Do not unplug</source>
        <translation>取り外さないでください</translation>
    </message>
    <message>
        <source>Unplug, connect next</source>
        <translation>取り外して次を接続</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>合格</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>省略</translation>
    </message>
    <message>
        <source>waiting</source>
        <translation>待機中</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 ～ %2</translation>
    </message>
    <message>
        <source>speed at most %1 counts/s</source>
        <translation>速度最大 %1 counts/s</translation>
    </message>
    <message>
        <source>travel at most %1 counts</source>
        <translation>移動量最大 %1 counts</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>不合格</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>拒否</translation>
    </message>
    <message>
        <source>running</source>
        <translation>実行中</translation>
    </message>
    <message>
        <source>Hold Arm to go on</source>
        <translation>続けるには駆動許可ボタンを長押し</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>はい</translation>
    </message>
    <message>
        <source>no</source>
        <translation>いいえ</translation>
    </message>
    <message>
        <source>duty at most %1 %</source>
        <translation>デューティ最大 %1 %</translation>
    </message>
    <message>
        <source>was there already</source>
        <translation>書き込み済みでした</translation>
    </message>
    <message>
        <source>it answers with it</source>
        <translation>この版で応答</translation>
    </message>
    <message>
        <source>read back</source>
        <translation>読み戻し済み</translation>
    </message>
    <message>
        <source>backup</source>
        <translation>バックアップ</translation>
    </message>
    <message>
        <source>kept</source>
        <translation>保存済み</translation>
    </message>
    <message>
        <source>before the first write</source>
        <translation>最初の書き込み前</translation>
    </message>
    <message>
        <source>Start serves the next unit.</source>
        <translation>「開始」で次の機器を処理します。</translation>
    </message>
    <message>
        <source>written, not proved</source>
        <translation>書き込み済み、未確認</translation>
    </message>
    <message>
        <source>%1 tests again · %2 sets it aside</source>
        <translation>%1 で再テスト · %2 でよける</translation>
    </message>
    <message>
        <source>Paused: no unit starts before the queue goes on.</source>
        <translation>一時停止中: キューが再開するまで、次の機器は開始しません。</translation>
    </message>
    <message>
        <source>%1 from %2 to %3</source>
        <translation>%1、%2 から %3</translation>
    </message>
    <message>
        <source>Start serves it once more</source>
        <translation>開始でもう一度処理します</translation>
    </message>
    <message>
        <source>No number was written to it this time.</source>
        <translation>今回、番号は書き込まれていません。</translation>
    </message>
</context>
<context>
    <name>mb::BodePlot</name>
    <message>
        <source>Magnitude of loop and motor</source>
        <translation>制御ループとモーターのゲイン特性</translation>
    </message>
    <message>
        <source>Phase of loop and motor</source>
        <translation>制御ループとモーターの位相特性</translation>
    </message>
    <message>
        <source>Hz</source>
        <translation>Hz</translation>
    </message>
    <message>
        <source>magnitude, dB</source>
        <translation>振幅、dB</translation>
    </message>
    <message>
        <source>phase, °</source>
        <translation>位相、°</translation>
    </message>
    <message>
        <source>loop</source>
        <translation>制御ループ</translation>
    </message>
    <message>
        <source>motor ÷ gain</source>
        <translation>モーター ÷ ゲイン</translation>
    </message>
    <message>
        <source>motor ÷ gain, measured</source>
        <translation>モーター ÷ ゲイン、実測</translation>
    </message>
    <message>
        <source>0.90 … 0.97</source>
        <translation>0.90 … 0.97</translation>
    </message>
    <message>
        <source>not used</source>
        <translation>不使用</translation>
    </message>
    <message>
        <source>measured, γ² ≥ 0.97</source>
        <translation>実測、γ² ≥ 0.97</translation>
    </message>
    <message>
        <source>under 0.90, not used</source>
        <translation>0.90 未満、不使用</translation>
    </message>
</context>
<context>
    <name>mb::BodeText</name>
    <message>
        <source>crossover %1 Hz</source>
        <translation>交差周波数 %1 Hz</translation>
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
        <translation>GM –、測定範囲外</translation>
    </message>
    <message>
        <source>usable up to %1 Hz</source>
        <translation>%1 Hz まで有効</translation>
    </message>
    <message>
        <source>unstable</source>
        <translation>不安定</translation>
    </message>
    <message>
        <source>phase margin %1°</source>
        <translation>位相余裕 %1°</translation>
    </message>
    <message>
        <source>gain margin %1 dB</source>
        <translation>ゲイン余裕 %1 dB</translation>
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
        <translation>リンク</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>一時停止</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>再開</translation>
    </message>
    <message>
        <source>Holds the frames still; everything is counted and kept meanwhile</source>
        <translation>フレームの表示を止めます。その間も計数と保存は続きます</translation>
    </message>
    <message>
        <source>Clear the list</source>
        <translation>リストを消去</translation>
    </message>
    <message>
        <source>Export frames</source>
        <translation>フレームのエクスポート</translation>
    </message>
    <message>
        <source>Frames that are shown…</source>
        <translation>表示中のフレーム…</translation>
    </message>
    <message>
        <source>All frames that are kept…</source>
        <translation>保存されている全フレーム…</translation>
    </message>
    <message>
        <source>Send frame…</source>
        <translation>フレームを送信…</translation>
    </message>
    <message>
        <source>What the expression does</source>
        <translation>式の働き</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>フィルタ</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>検索</translation>
    </message>
    <message>
        <source>such as message:STS* device:5 not is:error</source>
        <translation>例: message:STS* device:5 not is:error</translation>
    </message>
    <message>
        <source>Filter frames</source>
        <translation>フレームの絞り込み</translation>
    </message>
    <message>
        <source>How to write a filter</source>
        <translation>フィルタの書き方</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>All</source>
        <translation>すべて</translation>
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
        <translation>エラー</translation>
    </message>
    <message>
        <source>Filter hides what does not match; Find marks what does, Enter goes to the next</source>
        <translation>フィルタは一致しないものを隠し、検索は一致するものに印を付けます。Enter で次へ移動します</translation>
    </message>
</context>
<context>
    <name>mb::BusLoadView</name>
    <message>
        <source>Bus load of the last minute</source>
        <translation>直近 1 分間のバス負荷</translation>
    </message>
    <message>
        <source>now %1 %, peak %2 %</source>
        <translation>現在 %1 %、ピーク %2 %</translation>
    </message>
</context>
<context>
    <name>mb::BusPage</name>
    <message>
        <source>Bus</source>
        <translation>バス</translation>
    </message>
    <message>
        <source>pauses the list, and goes on</source>
        <translation>リストを一時停止、再開します</translation>
    </message>
    <message>
        <source>goes to the filter</source>
        <translation>フィルタへ移動します</translation>
    </message>
    <message>
        <source>finds the next one</source>
        <translation>次を検索します</translation>
    </message>
    <message>
        <source>finds the one before</source>
        <translation>前を検索します</translation>
    </message>
    <message>
        <source>not kept %1</source>
        <translation>未保存 %1</translation>
    </message>
    <message>
        <source>%1 of %2 shown</source>
        <translation>%2 中 %1 を表示</translation>
    </message>
    <message>
        <source>Export all frames</source>
        <translation>全フレームのエクスポート</translation>
    </message>
    <message>
        <source>Export the frames that are shown</source>
        <translation>表示中のフレームのエクスポート</translation>
    </message>
    <message>
        <source>candump log (*.log)</source>
        <translation>candump ログ (*.log)</translation>
    </message>
    <message>
        <source>%1 frames written to %2</source>
        <translation>%1 フレームを %2 に書き出しました</translation>
    </message>
    <message>
        <source>load %1 &amp;nbsp; frames/s %2</source>
        <translation>負荷 %1 &amp;nbsp; フレーム/s %2</translation>
    </message>
    <message>
        <source>dropped %1 &amp;nbsp; errors %2</source>
        <translation>破棄 %1 &amp;nbsp; エラー %2</translation>
    </message>
    <message>
        <source>No link yet</source>
        <translation>リンクはまだありません</translation>
    </message>
    <message>
        <source>Open a link, or the simulated bench from the menu; what passes on it appears here.</source>
        <translation>リンク、またはメニューからシミュレーションベンチを開いてください。流れるデータがここに表示されます。</translation>
    </message>
    <message>
        <source>%1 is not open</source>
        <translation>%1 は開いていません</translation>
    </message>
    <message>
        <source>load %1 &amp;nbsp; bytes/s %2</source>
        <translation>負荷 %1 &amp;nbsp; バイト/s %2</translation>
    </message>
    <message>
        <source>records, or ends the recording</source>
        <translation>記録を開始、終了します</translation>
    </message>
</context>
<context>
    <name>mb::BusSide</name>
    <message>
        <source>Bus load, %</source>
        <translation>バス負荷、%</translation>
    </message>
    <message>
        <source>last 60 s, peak %1 %</source>
        <translation>直近 60 s、ピーク %1 %</translation>
    </message>
    <message>
        <source>%1 identifiers</source>
        <translation>識別子 %1 個</translation>
    </message>
    <message>
        <source>busiest %1, %2 frames/s</source>
        <translation>最多 %1、%2 フレーム/s</translation>
    </message>
    <message>
        <source>%1 frames of identifiers without a row</source>
        <translation>行のない識別子のフレーム %1 個</translation>
    </message>
    <message>
        <source>%1 frames that no decoder knows</source>
        <translation>対応デコーダのないフレーム %1 個</translation>
    </message>
    <message>
        <source>error counters TEC %1, REC %2</source>
        <translation>エラーカウンタ TEC %1、REC %2</translation>
    </message>
</context>
<context>
    <name>mb::BusTables</name>
    <message>
        <source>Frames</source>
        <translation>フレーム</translation>
    </message>
    <message>
        <source>Identifiers</source>
        <translation>識別子</translation>
    </message>
</context>
<context>
    <name>mb::ByteStrip</name>
    <message>
        <source>Bytes %1</source>
        <translation>バイト %1</translation>
    </message>
</context>
<context>
    <name>mb::ChangeRow</name>
    <message>
        <source>fix first</source>
        <translation>要修正</translation>
    </message>
    <message>
        <source>look again</source>
        <translation>要再確認</translation>
    </message>
    <message>
        <source>Write %1: %2 to %3</source>
        <translation>%1 を書込み: %2 → %3</translation>
    </message>
    <message>
        <source>later</source>
        <translation>後で</translation>
    </message>
    <message>
        <source>Written as number %1</source>
        <translation>%1 番目に書込み</translation>
    </message>
    <message>
        <source>Stays staged</source>
        <translation>書込み待ちのまま</translation>
    </message>
</context>
<context>
    <name>mb::ChangesPanel</name>
    <message>
        <source>Changes to write</source>
        <translation>書き込む変更</translation>
    </message>
    <message>
        <source>order is chosen for you</source>
        <translation>順序は自動で決まります</translation>
    </message>
    <message>
        <source>Limits first, then what makes the loop calmer, then what makes it livelier: damping before P, P before I.</source>
        <translation>まず制限、次に制御ループを安定させるもの、最後に応答を速めるものの順です: P より先に制動、I より先に P。</translation>
    </message>
    <message>
        <source>Staged changes</source>
        <translation>書込み待ちの変更</translation>
    </message>
    <message>
        <source>Nothing is staged. Edit a value in the table, or import a file.</source>
        <translation>書込み待ちの変更はありません。表の値を編集するか、ファイルをインポートしてください。</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>進捗</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>破棄</translation>
    </message>
    <message>
        <source>Write</source>
        <translation>書込み</translation>
    </message>
    <message>
        <source>Each value is written, read back and compared.</source>
        <translation>各値を書き込み、読み戻して照合します。</translation>
    </message>
    <message>
        <source>Each value is written. None can be read back: what stands here then is assumed.</source>
        <translation>各値を書き込みます。読み戻しはできません: その後の表示は推定値です。</translation>
    </message>
    <message>
        <source>Each value is written. %1 of %2 cannot be read back: they are assumed then; the others are compared.</source>
        <translation>各値を書き込みます。%2 個中 %1 個は読み戻せないため推定値となり、残りは照合します。</translation>
    </message>
    <message>
        <source>nothing is staged</source>
        <translation>書込み待ちなし</translation>
    </message>
    <message>
        <source>fix 1 value first</source>
        <translation>先に 1 個の値を修正</translation>
    </message>
    <message>
        <source>fix %1 values first</source>
        <translation>先に %1 個の値を修正</translation>
    </message>
    <message>
        <source>look again first</source>
        <translation>先に再確認</translation>
    </message>
    <message>
        <source>none is ticked</source>
        <translation>チェックなし</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>応答なし</translation>
    </message>
    <message>
        <source>two units, one number</source>
        <translation>2 台が同じ番号</translation>
    </message>
    <message>
        <source>busy</source>
        <translation>ビジー</translation>
    </message>
    <message>
        <source>%1, %2 of %3</source>
        <translation>%1、%3 中 %2</translation>
    </message>
    <message>
        <source>The drive stores by itself %1 s after the last change: keep power on.</source>
        <translation>ドライブは最後の変更から %1 s 後に自動保存します: 電源を切らないでください。</translation>
    </message>
    <message>
        <source>Write %1</source>
        <translation>%1 を書込み</translation>
    </message>
    <message>
        <source>Write the staged changes</source>
        <translation>書込み待ちの変更を書込み</translation>
    </message>
</context>
<context>
    <name>mb::Closing</name>
    <message>
        <source>Close MotorBench</source>
        <translation>MotorBench を閉じる</translation>
    </message>
    <message>
        <source>Keep open</source>
        <translation>開いたままにする</translation>
    </message>
    <message>
        <source>Firmware is being written to %1. Cancel the update?</source>
        <translation>%1 にファームウェアを書込み中です。更新を中止しますか?</translation>
    </message>
    <message>
        <source>What is written now must not be cut: the window closes once it is over.</source>
        <translation>現在の書込みは中断できません: 終わりしだいウィンドウを閉じます。</translation>
    </message>
    <message>
        <source>Cancel the update and close</source>
        <translation>更新を中止して閉じる</translation>
    </message>
    <message>
        <source>%1 has not been seen to stop. Close anyway?</source>
        <translation>%1 の停止が確認できていません。それでも閉じますか?</translation>
    </message>
    <message>
        <source>It was told to stop. Without this window nobody sees whether it does.</source>
        <translation>停止指令は送信済みです。このウィンドウを閉じると、停止したかどうかを誰も確認できません。</translation>
    </message>
    <message>
        <source>Close anyway</source>
        <translation>それでも閉じる</translation>
    </message>
    <message>
        <source>Units are being served. Cancel the queue?</source>
        <translation>機器を処理しています。キューを中止しますか?</translation>
    </message>
    <message>
        <source>The journal knows where it stood, and the queue can be gone on with.</source>
        <translation>進み具合はジャーナルに残るので、キューは続きから再開できます。</translation>
    </message>
    <message>
        <source>Cancel the queue and close</source>
        <translation>キューを中止して閉じる</translation>
    </message>
    <message>
        <source>Samples are being written to %1. Cancel the export?</source>
        <translation>サンプルを %1 に書出し中です。エクスポートを中止しますか?</translation>
    </message>
    <message>
        <source>Nothing of it is kept then.</source>
        <translation>その場合、何も残りません。</translation>
    </message>
    <message>
        <source>Cancel the export and close</source>
        <translation>エクスポートを中止して閉じる</translation>
    </message>
    <message>
        <source>The window closes once this has ended: %1</source>
        <translation>次が終わるとウィンドウを閉じます: %1</translation>
    </message>
</context>
<context>
    <name>mb::CommandPalette</name>
    <message>
        <source>Commands</source>
        <translation>コマンド</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>コマンド</translation>
    </message>
    <message>
        <source>Type what you want to do</source>
        <translation>行いたい操作を入力</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>page: command</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>No command begins so</source>
        <translation>この文字で始まるコマンドはありません</translation>
    </message>
</context>
<context>
    <name>mb::ComparedText</name>
    <message>
        <source>in force</source>
        <translation>現在</translation>
    </message>
    <message>
        <source>before</source>
        <translation>変更前</translation>
    </message>
    <message>
        <source>%1: unstable on this model</source>
        <translation>%1: このモデルでは不安定</translation>
    </message>
    <message>
        <source>%1: over %2 %, Ms %3</source>
        <translation>%1: OS %2 %、Ms %3</translation>
    </message>
</context>
<context>
    <name>mb::ComparisonBox</name>
    <message>
        <source>Compare with</source>
        <translation>比較対象</translation>
    </message>
    <message>
        <source>as found %1</source>
        <translation>当初の状態 %1</translation>
    </message>
    <message>
        <source>defaults</source>
        <translation>既定値</translation>
    </message>
    <message>
        <source>axis %1</source>
        <translation>軸 %1</translation>
    </message>
    <message>
        <source>a file…</source>
        <translation>ファイル…</translation>
    </message>
</context>
<context>
    <name>mb::Conditions</name>
    <message>
        <source>%1 may still turn: cut its power</source>
        <translation>%1 はまだ回転している可能性があります: 電源を切ってください</translation>
    </message>
    <message>
        <source>Its stop was not confirmed. It is sent again, and first of all when its line is back.</source>
        <translation>停止が確認できていません。停止指令を再送し、回線が復帰したら最初に送信します。</translation>
    </message>
    <message>
        <source>I have looked: it stands</source>
        <translation>停止を目視で確認しました</translation>
    </message>
    <message>
        <source>Stopped: %1</source>
        <translation>停止: %1</translation>
    </message>
    <message>
        <source>Hold the Arm button for 1 s to arm again.</source>
        <translation>再び駆動許可するには、駆動許可ボタンを 1 s 押し続けてください。</translation>
    </message>
    <message>
        <source>%1 is lost</source>
        <translation>%1 が切断されました</translation>
    </message>
    <message>
        <source>Another master drives %1</source>
        <translation>別のマスタが %1 を駆動しています</translation>
    </message>
    <message>
        <source>Arming is off until it stops sending control frames.</source>
        <translation>別のマスタが制御フレームの送信をやめるまで駆動許可できません。</translation>
    </message>
    <message>
        <source>Several units answer as %1</source>
        <translation>複数の機器が %1 として応答しています</translation>
    </message>
    <message>
        <source>Control is locked. Assign one of them a new number from the menu of its row.</source>
        <translation>制御はロックされています。行のメニューから一方に新しい番号を割り当ててください。</translation>
    </message>
    <message>
        <source>Firmware is being written to %1</source>
        <translation>%1 にファームウェアを書込み中</translation>
    </message>
    <message>
        <source>Do not unplug. %1 of %2.</source>
        <translation>取り外さないでください。%1/%2。</translation>
    </message>
    <message>
        <source>Writing the settings of %1 again: %2 of %3</source>
        <translation>%1 の設定を再書込み中: %2/%3</translation>
    </message>
    <message>
        <source>Each is confirmed by the board.</source>
        <translation>各設定は基板が確認応答します。</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>%1 was reset: 1 setting is unknown</source>
        <translation>%1 がリセットされました: 1 個の設定が不明です</translation>
    </message>
    <message>
        <source>%1 was reset: %2 settings are unknown</source>
        <translation>%1 がリセットされました: %2 個の設定が不明です</translation>
    </message>
    <message>
        <source>The board keeps nothing without power. This program knows what was last written.</source>
        <translation>基板は電源が切れると何も保持しません。最後に書き込んだ内容はこのプログラムが記憶しています。</translation>
    </message>
    <message>
        <source>Write them again</source>
        <translation>再書込み</translation>
    </message>
    <message>
        <source>Trial #%1 on %2 was cut before it put its gains back</source>
        <translation>%2 の試行 #%1 は、ゲインを元に戻す前に中断されました</translation>
    </message>
    <message>
        <source>Before it: %1. The motor must stand.</source>
        <translation>試行前: %1。モーターが停止している必要があります。</translation>
    </message>
    <message>
        <source>Put them back</source>
        <translation>元に戻す</translation>
    </message>
    <message>
        <source>Writing was cancelled; what is missing can be written later.</source>
        <translation>書込みをキャンセルしました。残りは後で書き込めます。</translation>
    </message>
    <message>
        <source>%1 may have been reset: 1 setting is unknown</source>
        <translation>%1 はリセットされた可能性があります: 1 個の設定が不明です</translation>
    </message>
    <message>
        <source>%1 may have been reset: %2 settings are unknown</source>
        <translation>%1 はリセットされた可能性があります: %2 個の設定が不明です</translation>
    </message>
    <message>
        <source>Nothing shows that it still has what was not saved. This program knows what was last written.</source>
        <translation>保存していなかった値がまだ残っているかどうかは分かりません。最後に書き込んだ値は、このプログラムが知っています。</translation>
    </message>
    <message>
        <source>Safe to unplug: the update can be run again. %1 of %2.</source>
        <translation>取り外し可：更新はやり直せます。%1/%2。</translation>
    </message>
    <message>
        <source>Keep what it has</source>
        <translation>現在の値を維持</translation>
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
        <translation>不合格</translation>
    </message>
    <message>
        <source>refused before start</source>
        <translation>開始前に拒否</translation>
    </message>
    <message>
        <source>mean time</source>
        <translation>平均時間</translation>
    </message>
    <message>
        <source>units an hour</source>
        <translation>台／時</translation>
    </message>
</context>
<context>
    <name>mb::CrashNotice</name>
    <message>
        <source>The program ended unexpectedly</source>
        <translation>プログラムが予期せず終了しました</translation>
    </message>
    <message>
        <source>Open it again</source>
        <translation>もう一度開く</translation>
    </message>
    <message>
        <source>Read the report</source>
        <translation>レポートを読む</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Report of the crash</source>
        <translation>クラッシュレポート</translation>
    </message>
    <message>
        <source>File of the report</source>
        <translation>レポートのファイル</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>コピー</translation>
    </message>
</context>
<context>
    <name>mb::DemoStripe</name>
    <message>
        <source>simulated bench</source>
        <translation>シミュレーションベンチ</translation>
    </message>
    <message>
        <source>Demo  ·  %1  ·  no real motor is connected</source>
        <translation>デモ  ·  %1  ·  実物のモーターは接続されていません</translation>
    </message>
    <message>
        <source>Replay  ·  %1  ·  shows what was recorded, moves no motor</source>
        <translation>再生  ·  %1  ·  記録の表示のみ、モーターは動きません</translation>
    </message>
    <message>
        <source>Replay</source>
        <translation>再生</translation>
    </message>
    <message>
        <source>Demo</source>
        <translation>デモ</translation>
    </message>
</context>
<context>
    <name>mb::DesignBook</name>
    <message>
        <source>%1 waits in its bootloader.</source>
        <translation>%1 はブートローダで待機しています。</translation>
    </message>
    <message>
        <source>This family has no loop that can be tuned.</source>
        <translation>このファミリには調整できる制御ループがありません。</translation>
    </message>
</context>
<context>
    <name>mb::DesignCourse</name>
    <message>
        <source>What the adviser proposes</source>
        <translation>アドバイザの提案</translation>
    </message>
</context>
<context>
    <name>mb::DesignFrame</name>
    <message>
        <source>Part of the page</source>
        <translation>ページの部分</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>モデル</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>曲線</translation>
    </message>
    <message>
        <source>Course</source>
        <translation>経過</translation>
    </message>
</context>
<context>
    <name>mb::DesignOrders</name>
    <message>
        <source>Loop</source>
        <translation>制御ループ</translation>
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
        <translation>電流</translation>
    </message>
    <message>
        <source>Gain slot</source>
        <translation>ゲインスロット</translation>
    </message>
    <message>
        <source>slot 0</source>
        <translation>スロット 0</translation>
    </message>
    <message>
        <source>slot 1</source>
        <translation>スロット 1</translation>
    </message>
    <message>
        <source>Identify</source>
        <translation>同定</translation>
    </message>
    <message>
        <source>Autotune</source>
        <translation>オートチューニング</translation>
    </message>
    <message>
        <source>Write and prove</source>
        <translation>書込みと検証</translation>
    </message>
    <message>
        <source>Identifies, writes the chosen set and proves it, in one go</source>
        <translation>同定、選択した組の書込み、検証を一括で行います</translation>
    </message>
</context>
<context>
    <name>mb::DesignPage</name>
    <message>
        <source>writes the chosen set and proves it</source>
        <translation>選択した組を書き込んで検証します</translation>
    </message>
    <message>
        <source>identifies, writes and proves in one go</source>
        <translation>同定、書込み、検証を一括で行います</translation>
    </message>
    <message>
        <source>identifies the motor</source>
        <translation>モーターを同定します</translation>
    </message>
    <message>
        <source>writes a report of what is shown</source>
        <translation>表示内容のレポートを書き出します</translation>
    </message>
    <message>
        <source>Tuning</source>
        <translation>調整</translation>
    </message>
    <message>
        <source>STOP ends it; what was changed is put back.</source>
        <translation>STOP で終了します。変更した値は元に戻します。</translation>
    </message>
    <message>
        <source>Moving</source>
        <translation>動作中</translation>
    </message>
    <message>
        <source>Stop the motion before the motor is tuned.</source>
        <translation>モーターを調整する前に動作を停止してください。</translation>
    </message>
    <message>
        <source>Busy</source>
        <translation>ビジー</translation>
    </message>
    <message>
        <source>Armed</source>
        <translation>駆動許可中</translation>
    </message>
    <message>
        <source>Not armed</source>
        <translation>駆動未許可</translation>
    </message>
    <message>
        <source>Hold the Arm button for 1 s to arm %1.</source>
        <translation>%1 を駆動許可するには、駆動許可ボタンを 1 s 押し続けてください。</translation>
    </message>
    <message>
        <source>No tuning here</source>
        <translation>ここでは調整不可</translation>
    </message>
    <message>
        <source>No device selected</source>
        <translation>機器が選択されていません</translation>
    </message>
    <message>
        <source>Choose a controller in the list at the left.</source>
        <translation>左のリストでコントローラを選択してください。</translation>
    </message>
    <message>
        <source>Not by itself</source>
        <translation>自動では不可</translation>
    </message>
    <message>
        <source>DEMO</source>
        <translation>デモ</translation>
    </message>
    <message>
        <source>No limit</source>
        <translation>制限ではありません</translation>
    </message>
    <message>
        <source>%1 will turn both ways.</source>
        <translation>%1 は両方向に回転します。</translation>
    </message>
</context>
<context>
    <name>mb::DesignPlots</name>
    <message>
        <source>Step, predicted and measured</source>
        <translation>ステップ応答、予測と実測</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>What the gains will do appears here, before they are written.</source>
        <translation>書込み前に、ゲインの効果がここに表示されます。</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>ステップ</translation>
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
        <translation>電流</translation>
    </message>
    <message>
        <source>duty</source>
        <translation>デューティ</translation>
    </message>
    <message>
        <source>last 10 s</source>
        <translation>直近 10 s</translation>
    </message>
    <message>
        <source>Update firmware</source>
        <translation>ファームウェアの更新</translation>
    </message>
    <message>
        <source>No application runs. Settings, number and name are kept.</source>
        <translation>アプリケーションが動作していません。設定、番号、名前は保持されています。</translation>
    </message>
    <message>
        <source>An update makes it whole again. It is safe to power off.</source>
        <translation>更新すれば復旧します。電源を切っても安全です。</translation>
    </message>
    <message>
        <source>boot %1 · no telemetry</source>
        <translation>ブート %1 · テレメトリなし</translation>
    </message>
    <message>
        <source>%1 Hz   lost %2</source>
        <translation>%1 Hz   欠落 %2</translation>
    </message>
    <message>
        <source>no watchdog</source>
        <translation>ウォッチドッグなし</translation>
    </message>
    <message>
        <source>It keeps its last set-point if this program dies. A second process beside it, the guardian, stops it then.</source>
        <translation>このプログラムが停止しても最後の目標値を保持します。その場合は別プロセスの監視プロセスが停止させます。</translation>
    </message>
</context>
<context>
    <name>mb::DeviceLine</name>
    <message>
        <source>Selected device</source>
        <translation>選択中の機器</translation>
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
        <translation>電流</translation>
    </message>
    <message>
        <source>duty</source>
        <translation>デューティ</translation>
    </message>
    <message>
        <source>bus</source>
        <translation>バス</translation>
    </message>
    <message>
        <source>case</source>
        <translation>ケース</translation>
    </message>
    <message>
        <source>SN %1 · fw %2</source>
        <translation>SN %1 · FW %2</translation>
    </message>
</context>
<context>
    <name>mb::DeviceModel</name>
    <message>
        <source>lost</source>
        <translation>欠落</translation>
    </message>
    <message>
        <source>scanning</source>
        <translation>スキャン中</translation>
    </message>
    <message>
        <source>%1 of %2: %3, now %4
Its pages show this axis; drag it to a plot.</source>
        <translation>%2 の %1: %3、現在 %4
機器の各ページはこの軸を表示します。プロットへドラッグできます。</translation>
    </message>
    <message>
        <source>%1
Double click or Enter plots it; drag it to a plot.</source>
        <translation>%1
ダブルクリックまたは Enter でプロットします。プロットへドラッグもできます。</translation>
    </message>
</context>
<context>
    <name>mb::DeviceTree</name>
    <message>
        <source>Devices</source>
        <translation>機器</translation>
    </message>
    <message>
        <source>Scan again</source>
        <translation>再スキャン</translation>
    </message>
    <message>
        <source>Filter devices</source>
        <translation>機器の絞り込み</translation>
    </message>
    <message>
        <source>Hide devices</source>
        <translation>機器を隠す</translation>
    </message>
    <message>
        <source>Filter by name, number, serial</source>
        <translation>名前、番号、シリアル番号で絞り込み</translation>
    </message>
    <message>
        <source>No device yet</source>
        <translation>機器はまだありません</translation>
    </message>
    <message>
        <source>Devices appear here by themselves as soon as a link answers.</source>
        <translation>リンクが応答すると、機器が自動的にここに表示されます。</translation>
    </message>
    <message>
        <source>Links and devices</source>
        <translation>リンクと機器</translation>
    </message>
    <message>
        <source>Add link</source>
        <translation>リンクを追加</translation>
    </message>
    <message>
        <source>Simulate</source>
        <translation>シミュレート</translation>
    </message>
    <message>
        <source>Open a CAN interface, a serial port or another link</source>
        <translation>CAN インターフェース、シリアルポートなどのリンクを開きます</translation>
    </message>
    <message>
        <source>Open the simulated bench; no real motor is connected to it</source>
        <translation>シミュレーションベンチを開きます。実物のモーターは接続されません</translation>
    </message>
    <message>
        <source>Show 1 new device</source>
        <translation>新しい機器 1 台を表示</translation>
    </message>
    <message>
        <source>Show %1 new devices</source>
        <translation>新しい機器 %1 台を表示</translation>
    </message>
    <message>
        <source>Search every rate and address (takes minutes)</source>
        <translation>全通信速度と全アドレスを検索 (数分かかります)</translation>
    </message>
    <message>
        <source>Cancel the scan</source>
        <translation>スキャンを中止</translation>
    </message>
    <message>
        <source>Plot %1</source>
        <translation>%1 をプロット</translation>
    </message>
    <message>
        <source>Open it at every start</source>
        <translation>起動のたびに開く</translation>
    </message>
    <message>
        <source>Close this link</source>
        <translation>このリンクを閉じる</translation>
    </message>
</context>
<context>
    <name>mb::DifferenceTable</name>
    <message>
        <source>Differences</source>
        <translation>差分</translation>
    </message>
    <message>
        <source>parameter</source>
        <translation>パラメータ</translation>
    </message>
    <message>
        <source>key</source>
        <translation>キー</translation>
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
        <translation>単位</translation>
    </message>
    <message>
        <source>belongs to one unit, copied only if you tick it</source>
        <translation>この機器固有の値です。チェックした場合だけコピーされます</translation>
    </message>
    <message>
        <source>assumed: it cannot be read</source>
        <translation>推定: 読出し不可</translation>
    </message>
    <message>
        <source>state</source>
        <translation>状態</translation>
    </message>
    <message>
        <source>This unit</source>
        <translation>この機器</translation>
    </message>
    <message>
        <source>%1 of %2 differ</source>
        <translation>%2 件中 %1 件が異なる</translation>
    </message>
</context>
<context>
    <name>mb::DoctorCard</name>
    <message>
        <source>Connection doctor</source>
        <translation>接続診断</translation>
    </message>
    <message>
        <source>looks by itself</source>
        <translation>自動で診断します</translation>
    </message>
    <message>
        <source>CAN</source>
        <translation>CAN</translation>
    </message>
    <message>
        <source>Command for a terminal</source>
        <translation>端末用コマンド</translation>
    </message>
    <message>
        <source>Copy command</source>
        <translation>コマンドをコピー</translation>
    </message>
    <message>
        <source>Paste it into a terminal; this program never runs as root</source>
        <translation>端末に貼り付けてください。このプログラムが root で動作することはありません</translation>
    </message>
    <message>
        <source>Reconnect</source>
        <translation>再接続</translation>
    </message>
    <message>
        <source>Open this link now</source>
        <translation>このリンクを今すぐ開きます</translation>
    </message>
    <message>
        <source>The command is in the clipboard; paste it into a terminal.</source>
        <translation>コマンドをクリップボードにコピーしました。端末に貼り付けてください。</translation>
    </message>
</context>
<context>
    <name>mb::DriveOptions</name>
    <message>
        <source>as the device is set</source>
        <translation>機器の設定どおり</translation>
    </message>
    <message>
        <source>brake</source>
        <translation>ブレーキ</translation>
    </message>
    <message>
        <source>coast</source>
        <translation>フリーラン</translation>
    </message>
    <message>
        <source>At zero output</source>
        <translation>出力ゼロ時</translation>
    </message>
    <message>
        <source>At zero</source>
        <translation>ゼロ時</translation>
    </message>
    <message>
        <source>Reverse motor</source>
        <translation>モーター反転</translation>
    </message>
    <message>
        <source>Forward output turns the motor the other way. Changing it disarms.</source>
        <translation>正転出力でモーターが逆方向に回ります。変更すると駆動許可が解除されます。</translation>
    </message>
    <message>
        <source>Reverse sensor</source>
        <translation>センサ反転</translation>
    </message>
    <message>
        <source>The encoder counts the other way. Changing it disarms.</source>
        <translation>エンコーダが逆方向に計数します。変更すると駆動許可が解除されます。</translation>
    </message>
    <message>
        <source>Override limits</source>
        <translation>リミットを無効化</translation>
    </message>
    <message>
        <source>The two below replace the device&apos;s own settings for limit switches. Changing it disarms.</source>
        <translation>下の 2 項目が機器自身のリミットスイッチ設定に優先します。変更すると駆動許可が解除されます。</translation>
    </message>
    <message>
        <source>Forward limit off</source>
        <translation>正転リミットをオフ</translation>
    </message>
    <message>
        <source>The motor runs past the forward limit. Changing it disarms.</source>
        <translation>モーターは正転リミットを越えて動きます。変更すると駆動許可が解除されます。</translation>
    </message>
    <message>
        <source>Reverse limit off</source>
        <translation>逆転リミットをオフ</translation>
    </message>
    <message>
        <source>The motor runs past the reverse limit. Changing it disarms.</source>
        <translation>モーターは逆転リミットを越えて動きます。変更すると駆動許可が解除されます。</translation>
    </message>
    <message>
        <source>Ramp of the output, duty per second</source>
        <translation>出力ランプ、1 秒あたりのデューティ</translation>
    </message>
    <message>
        <source>duty/s, 0 = none</source>
        <translation>duty/s、0 = なし</translation>
    </message>
    <message>
        <source>Ramp</source>
        <translation>ランプ</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>ramp %1 duty/s</source>
        <translation>ランプ %1 duty/s</translation>
    </message>
    <message>
        <source>motor reversed</source>
        <translation>モーター反転</translation>
    </message>
    <message>
        <source>sensor reversed</source>
        <translation>センサ反転</translation>
    </message>
    <message>
        <source>limits overridden</source>
        <translation>リミット無効化</translation>
    </message>
    <message>
        <source>Greatest change of the output in duty per second: 2 takes 0.5 s from 0 to 100 %.</source>
        <translation>1 秒あたりのデューティで表した出力の最大変化率。2 は 0 から 100 % まで 0.5 s です。</translation>
    </message>
    <message>
        <source>duty/s, 0 = %1</source>
        <translation>duty/s、0 = %1</translation>
    </message>
    <message>
        <source>%1 is no ramp. Enter 0 or a positive number of duty per second.</source>
        <translation>%1 はランプの値ではありません。0、または 1 秒あたりのデューティを正の数で入力してください。</translation>
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
        <translation>不合格</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>拒否</translation>
    </message>
    <message>
        <source>not ended</source>
        <translation>未完了</translation>
    </message>
    <message>
        <source>as it is now</source>
        <translation>現在の状態</translation>
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
        <translation>移動量 ±</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Current</source>
        <translation>電流</translation>
    </message>
    <message>
        <source>Duty</source>
        <translation>デューティ</translation>
    </message>
    <message>
        <source>Envelope</source>
        <translation>動作範囲</translation>
    </message>
    <message>
        <source>Envelope: %1</source>
        <translation>動作範囲: %1</translation>
    </message>
    <message>
        <source>Empty: what the device itself says</source>
        <translation>空欄: 機器自身の設定に従う</translation>
    </message>
    <message>
        <source>%1 holds</source>
        <translation>%1 が有効</translation>
    </message>
    <message>
        <source>not bounded, %1</source>
        <translation>制限なし、%1</translation>
    </message>
    <message>
        <source>%1: %2 is no limit. It is more than 0, and at most %3.</source>
        <translation>%1: %2 は制限になりません。0 より大きく、%3 以下です。</translation>
    </message>
</context>
<context>
    <name>mb::ExperimentDialog</name>
    <message>
        <source>Axis</source>
        <translation>軸</translation>
    </message>
    <message>
        <source>axis %1</source>
        <translation>軸 %1</translation>
    </message>
    <message>
        <source>Of which motor</source>
        <translation>対象モーター</translation>
    </message>
    <message>
        <source>Most power</source>
        <translation>最大出力</translation>
    </message>
    <message>
        <source>Not begun</source>
        <translation>未開始</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>手順</translation>
    </message>
    <message>
        <source>Progress of the experiment</source>
        <translation>実験の進捗</translation>
    </message>
    <message>
        <source>Log of the experiment</source>
        <translation>実験のログ</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>結果</translation>
    </message>
    <message>
        <source>STOP, Esc or Cancel ends it at any time.</source>
        <translation>STOP、Esc、「キャンセル」でいつでも終了します。</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Hold to turn the motor</source>
        <translation>長押しでモーターを回転</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>開始</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Ended</source>
        <translation>終了</translation>
    </message>
    <message>
        <source>Found and kept for this device.</source>
        <translation>求めた値をこの機器用に保存しました。</translation>
    </message>
    <message>
        <source>Cancelled. The motor is stopped; gains and limits are as they were.</source>
        <translation>キャンセルしました。モーターは停止し、ゲインと制限は元のままです。</translation>
    </message>
</context>
<context>
    <name>mb::ExperimentText</name>
    <message>
        <source>at most %1 s</source>
        <translation>最大 %1 s</translation>
    </message>
    <message>
        <source>inside the envelope · %1</source>
        <translation>動作範囲内 · %1</translation>
    </message>
    <message>
        <source>inside the envelope · %1 of %2 · %3</source>
        <translation>動作範囲内 · %1/%2 · %3</translation>
    </message>
    <message>
        <source>This mode has no loop that can be tried; Live drives it.</source>
        <translation>このモードには試せる制御ループがありません。「ライブ」で駆動します。</translation>
    </message>
    <message>
        <source>Nothing bounds the motor: enter travel, duty, and what else is empty here.</source>
        <translation>モーターに制限がありません: 移動量、デューティなど、空欄の項目を入力してください。</translation>
    </message>
    <message>
        <source>Enter where the loop is to go.</source>
        <translation>制御ループの行き先を入力してください。</translation>
    </message>
    <message>
        <source>It is there already; enter another place to go to.</source>
        <translation>すでにその位置です。別の行き先を入力してください。</translation>
    </message>
</context>
<context>
    <name>mb::ExportBar</name>
    <message>
        <source>Progress of the export</source>
        <translation>エクスポートの進捗</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Writing samples</source>
        <translation>サンプルの書出し中</translation>
    </message>
    <message>
        <source>One export at a time: %1 is being written.</source>
        <translation>エクスポートは一度に 1 件です: %1 を書出し中です。</translation>
    </message>
    <message>
        <source>writing %1</source>
        <translation>%1 を書出し中</translation>
    </message>
    <message>
        <source>%1 written: %2 samples, %3 lost</source>
        <translation>%1 を書き出しました: %2 サンプル、欠落 %3</translation>
    </message>
    <message>
        <source>export cancelled, nothing was written</source>
        <translation>エクスポートをキャンセルしました。何も書き出していません</translation>
    </message>
</context>
<context>
    <name>mb::FaultLine</name>
    <message>
        <source>Is that meant?</source>
        <translation>この値で正しいですか?</translation>
    </message>
    <message>
        <source>Use %1</source>
        <translation>%1 を使用</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Revert to %1</source>
        <translation>%1 に戻す</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>元に戻す</translation>
    </message>
</context>
<context>
    <name>mb::FileExchange</name>
    <message>
        <source>%1 says what the device has.</source>
        <translation>%1 は機器の内容と一致しています。</translation>
    </message>
    <message>
        <source>Nothing is staged.</source>
        <translation>書込み待ちの変更はありません。</translation>
    </message>
    <message>
        <source>Import of %1</source>
        <translation>%1 のインポート</translation>
    </message>
    <message>
        <source>Nothing is written yet: look through the list, then write.</source>
        <translation>まだ何も書き込んでいません: リストを確認してから書き込んでください。</translation>
    </message>
    <message>
        <source>Left out: %1, for one: %2.</source>
        <translation>除外: %1 個、例: %2。</translation>
    </message>
    <message>
        <source>Staged from %1: %2 of its values differ.</source>
        <translation>%1 から書込み待ちに追加: %2 個の値が異なります。</translation>
    </message>
    <message>
        <source>Undo the import</source>
        <translation>インポートを元に戻す</translation>
    </message>
    <message>
        <source>Choose another place.</source>
        <translation>別の場所を選択してください。</translation>
    </message>
    <message>
        <source>%1 parameters exported to %2</source>
        <translation>%1 個のパラメータを %2 にエクスポートしました</translation>
    </message>
</context>
<context>
    <name>mb::FirmwarePage</name>
    <message>
        <source>Firmware</source>
        <translation>ファームウェア</translation>
    </message>
    <message>
        <source>starts the update</source>
        <translation>更新を開始</translation>
    </message>
    <message>
        <source>What is updated</source>
        <translation>更新の対象</translation>
    </message>
    <message>
        <source>Selected unit</source>
        <translation>選択した機器</translation>
    </message>
    <message>
        <source>Queue of units</source>
        <translation>機器のキュー</translation>
    </message>
    <message>
        <source>Unit that does not answer</source>
        <translation>応答しない機器</translation>
    </message>
    <message>
        <source>A unit whose update was cut may be mute: say where it is, and it can be written again</source>
        <translation>更新が中断された機器は応答しないことがあります。場所を指定すれば、もう一度書き込めます</translation>
    </message>
</context>
<context>
    <name>mb::FirmwareShelf</name>
    <message>
        <source>not read yet</source>
        <translation>未読込み</translation>
    </message>
    <message>
        <source>%1 · checked · %2</source>
        <translation>%1 · 確認済み · %2</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>詳細</translation>
    </message>
</context>
<context>
    <name>mb::FrameDetail</name>
    <message>
        <source>Selected frame</source>
        <translation>選択中のフレーム</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>フレーム</translation>
    </message>
    <message>
        <source>Fields</source>
        <translation>フィールド</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>コピー</translation>
    </message>
    <message>
        <source>Copy the selected frames as candump text (Ctrl+C)</source>
        <translation>選択したフレームを candump テキストとしてコピー (Ctrl+C)</translation>
    </message>
    <message>
        <source>Send again…</source>
        <translation>再送信…</translation>
    </message>
    <message>
        <source>No frame selected</source>
        <translation>フレームが選択されていません</translation>
    </message>
    <message>
        <source>Select one to see its fields</source>
        <translation>選択するとフィールドを表示します</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Error frame</source>
        <translation>エラーフレーム</translation>
    </message>
    <message>
        <source>Unknown frame</source>
        <translation>不明なフレーム</translation>
    </message>
    <message>
        <source>sent</source>
        <translation>送信</translation>
    </message>
    <message>
        <source>received</source>
        <translation>受信</translation>
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
        <translation>%1 = %2、ビット %3</translation>
    </message>
    <message>
        <source>%1 bytes</source>
        <translation>%1 バイト</translation>
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
        <translation>%1 バイト</translation>
    </message>
    <message>
        <source>error frame</source>
        <translation>エラーフレーム</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>不明</translation>
    </message>
    <message>
        <source>asks for data</source>
        <translation>データを要求</translation>
    </message>
    <message>
        <source>no decoder knows this identifier</source>
        <translation>この識別子に対応するデコーダがありません</translation>
    </message>
    <message>
        <source>t, s</source>
        <translation>t、s</translation>
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
        <translation>ID</translation>
    </message>
    <message>
        <source>message</source>
        <translation>メッセージ</translation>
    </message>
    <message>
        <source>dev</source>
        <translation>機器</translation>
    </message>
    <message>
        <source>decoded</source>
        <translation>デコード結果</translation>
    </message>
    <message>
        <source>data</source>
        <translation>データ</translation>
    </message>
</context>
<context>
    <name>mb::GainRow</name>
    <message>
        <source>Use it</source>
        <translation>使用</translation>
    </message>
    <message>
        <source>Use this %1</source>
        <translation>この %1 を使用</translation>
    </message>
    <message>
        <source>Revert %1</source>
        <translation>%1 を元に戻す</translation>
    </message>
    <message>
        <source>%1, one decade either way</source>
        <translation>%1、前後 1 桁</translation>
    </message>
    <message>
        <source>One decade either way. ← → 2 %, with Shift 0.2 %, with Ctrl 20 %</source>
        <translation>前後 1 桁。← → 2 %、Shift 併用で 0.2 %、Ctrl 併用で 20 %</translation>
    </message>
    <message>
        <source>stored</source>
        <translation>保存済み</translation>
    </message>
    <message>
        <source>RAM</source>
        <translation>RAM</translation>
    </message>
    <message>
        <source>volatile</source>
        <translation>揮発性</translation>
    </message>
    <message>
        <source>assumed</source>
        <translation>推定</translation>
    </message>
    <message>
        <source>edited</source>
        <translation>編集済み</translation>
    </message>
    <message>
        <source>range</source>
        <translation>範囲</translation>
    </message>
    <message>
        <source>reading</source>
        <translation>読込み中</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>不明</translation>
    </message>
    <message>
        <source>edited, was %1</source>
        <translation>編集済み、元の値 %1</translation>
    </message>
    <message>
        <source>edited, was unknown</source>
        <translation>編集済み、元の値は不明</translation>
    </message>
    <message>
        <source>raw %1   %2</source>
        <translation>生値 %1   %2</translation>
    </message>
    <message>
        <source>unknown until written</source>
        <translation>書込みまで不明</translation>
    </message>
</context>
<context>
    <name>mb::GainsPanel</name>
    <message>
        <source>Gains</source>
        <translation>ゲイン</translation>
    </message>
    <message>
        <source>G · ← → 2 % · Shift 0.2 %</source>
        <translation>G · ← → 2 % · Shift 0.2 %</translation>
    </message>
    <message>
        <source>Gains, slot %1</source>
        <translation>ゲイン、スロット %1</translation>
    </message>
    <message>
        <source>Gains, axis %1</source>
        <translation>ゲイン、軸 %1</translation>
    </message>
    <message>
        <source>Hide limits of the loop</source>
        <translation>制御ループの制限を隠す</translation>
    </message>
    <message>
        <source>Divisor</source>
        <translation>除数</translation>
    </message>
    <message>
        <source>Limits of the axis</source>
        <translation>軸の制限</translation>
    </message>
    <message>
        <source>Limits of the loop</source>
        <translation>制御ループの制限</translation>
    </message>
    <message>
        <source>No loop runs in %1 mode: only the limits of the axis act.</source>
        <translation>%1 モードでは制御ループが動作しません: 軸の制限だけが作用します。</translation>
    </message>
    <message>
        <source>No loop runs in %1 mode: these gains act in velocity, position and current.</source>
        <translation>%1 モードでは制御ループが動作しません: これらのゲインは速度、位置、電流で作用します。</translation>
    </message>
    <message>
        <source>off</source>
        <translation>オフ</translation>
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
        <translation>ゲインを書込み</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>元に戻す</translation>
    </message>
    <message>
        <source>Revert all staged gains</source>
        <translation>書込み待ちのゲインをすべて元に戻す</translation>
    </message>
    <message numerus="yes">
        <source>%n value(s)</source>
        <translation>
            <numerusform>%n 個の値</numerusform>
        </translation>
    </message>
    <message>
        <source>Write %1 to slot %2</source>
        <translation>%1 をスロット %2 に書込み</translation>
    </message>
    <message>
        <source>Write %1</source>
        <translation>%1 を書込み</translation>
    </message>
    <message>
        <source>A gain is out of range</source>
        <translation>ゲインが範囲外です</translation>
    </message>
    <message>
        <source>No gain is edited</source>
        <translation>編集されたゲインはありません</translation>
    </message>
    <message>
        <source>The device is busy</source>
        <translation>機器はビジーです</translation>
    </message>
</context>
<context>
    <name>mb::GroupMotion</name>
    <message>
        <source>not prepared: hold the Arm button first</source>
        <translation>準備できません: 先に駆動許可ボタンを長押ししてください</translation>
    </message>
    <message>
        <source>not prepared: the selected device has to take part</source>
        <translation>準備できません: 選択中の機器が参加する必要があります</translation>
    </message>
    <message>
        <source>not started: not every device has acknowledged its move; prepare them again</source>
        <translation>開始していません: 一部の機器が動作指令を確認応答していません。再度準備してください</translation>
    </message>
    <message>
        <source>stopped, and the others of its group with it: %1</source>
        <translation>停止、同じグループの他の機器も停止しました: %1</translation>
    </message>
    <message>
        <source>it is gone</source>
        <translation>なくなりました</translation>
    </message>
    <message>
        <source>not prepared: an experiment on the selected device has not ended</source>
        <translation>準備できません: 選択中の機器での実験がまだ終わっていません</translation>
    </message>
</context>
<context>
    <name>mb::GuardianCheck</name>
    <message>
        <source>stops a motor when this program is killed or hangs</source>
        <translation>このプログラムが強制終了したり固まったりしたとき、モーターを止めます</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>確認</translation>
    </message>
    <message>
        <source>Check the guardian</source>
        <translation>監視プロセスを確認</translation>
    </message>
    <message>
        <source>%1 cannot be started: %2</source>
        <translation>%1 を起動できません: %2</translation>
    </message>
    <message>
        <source>It is in place and runs.</source>
        <translation>所定の場所にあり、動作します。</translation>
    </message>
    <message>
        <source>%1 does not run as it should.</source>
        <translation>%1 が正しく動作しません。</translation>
    </message>
</context>
<context>
    <name>mb::Guide</name>
    <message>
        <source>overshoot %1 % at first, %2 % now</source>
        <translation>オーバーシュート 当初 %1 %、現在 %2 %</translation>
    </message>
    <message>
        <source>overshoot %1 %</source>
        <translation>オーバーシュート %1 %</translation>
    </message>
    <message>
        <source>peak current %1 A</source>
        <translation>ピーク電流 %1 A</translation>
    </message>
    <message>
        <source>%1 counts beside its target at first, %2 now</source>
        <translation>目標との差 当初 %1 カウント、現在 %2</translation>
    </message>
    <message>
        <source>%1 counts beside its target</source>
        <translation>目標との差 %1 カウント</translation>
    </message>
</context>
<context>
    <name>mb::GuideStrip</name>
    <message>
        <source>Guide</source>
        <translation>ガイド</translation>
    </message>
    <message>
        <source>Show me where</source>
        <translation>場所を表示</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>開始</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Not now</source>
        <translation>後で</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Simulated: nothing real moves. A guide says each step and waits until it has happened.</source>
        <translation>シミュレーション: 実物は動きません。ガイドは各手順を示し、実行されるまで待ちます。</translation>
    </message>
    <message>
        <source>%1 done</source>
        <translation>%1 完了</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>Done.</source>
        <translation>完了。</translation>
    </message>
    <message>
        <source>The simulated bench is opened; the unit answers in a moment.</source>
        <translation>シミュレーションベンチを開いています。まもなく機器が応答します。</translation>
    </message>
    <message>
        <source>Measured: %1.</source>
        <translation>測定値: %1。</translation>
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
        <translation>プログラムメニュー</translation>
    </message>
    <message>
        <source>1 link</source>
        <translation>リンク 1 本</translation>
    </message>
    <message numerus="yes">
        <source>%n links</source>
        <translation>
            <numerusform>リンク %n 本</numerusform>
        </translation>
    </message>
    <message>
        <source>Links</source>
        <translation>リンク</translation>
    </message>
    <message>
        <source>no alarms</source>
        <translation>アラームなし</translation>
    </message>
    <message>
        <source>1 notice</source>
        <translation>通知 1 件</translation>
    </message>
    <message numerus="yes">
        <source>%n notices</source>
        <translation>
            <numerusform>通知 %n 件</numerusform>
        </translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>記録中</translation>
    </message>
</context>
<context>
    <name>mb::HelpBrowser</name>
    <message>
        <source>Help</source>
        <translation>ヘルプ</translation>
    </message>
</context>
<context>
    <name>mb::HelpDesk</name>
    <message>
        <source>Help for this page</source>
        <translation>このページのヘルプ</translation>
    </message>
</context>
<context>
    <name>mb::HelpWindow</name>
    <message>
        <source>Help</source>
        <translation>ヘルプ</translation>
    </message>
    <message>
        <source>Pages of the help</source>
        <translation>ヘルプの目次</translation>
    </message>
</context>
<context>
    <name>mb::HistoryPanel</name>
    <message>
        <source>State A</source>
        <translation>状態 A</translation>
    </message>
    <message>
        <source>State B</source>
        <translation>状態 B</translation>
    </message>
    <message>
        <source>Which parameters</source>
        <translation>表示するパラメータ</translation>
    </message>
    <message>
        <source>Only differences</source>
        <translation>差分のみ</translation>
    </message>
    <message>
        <source>All</source>
        <translation>すべて</translation>
    </message>
    <message>
        <source>Restore what is ticked</source>
        <translation>チェックした項目を復元</translation>
    </message>
    <message>
        <source>Only differences %1</source>
        <translation>差分のみ %1</translation>
    </message>
    <message>
        <source>All %1</source>
        <translation>すべて %1</translation>
    </message>
    <message>
        <source>%1 ticked; a snapshot of what is there is taken first.</source>
        <translation>%1 個をチェック。先に現在の内容のスナップショットを取得します。</translation>
    </message>
    <message>
        <source>Choose what the device has now as A to write values of B.</source>
        <translation>B の値を書き込むには、A に機器の現在の状態を選択してください。</translation>
    </message>
    <message>
        <source>Restore %1</source>
        <translation>%1 を復元</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>履歴</translation>
    </message>
    <message>
        <source>differences from A</source>
        <translation>A との差</translation>
    </message>
    <message>
        <source>Click sets B, Shift+click sets A.</source>
        <translation>クリックで B、Shift+クリックで A。</translation>
    </message>
    <message>
        <source>Exchange A and B</source>
        <translation>A と B を入れ替え</translation>
    </message>
    <message>
        <source>Copy as text</source>
        <translation>テキストとしてコピー</translation>
    </message>
    <message>
        <source>Keep or revert first</source>
        <translation>先に維持か復元を選択</translation>
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
        <translation>エラーフレーム</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>不明</translation>
    </message>
    <message>
        <source>every %1 ms, standard deviation %2 ms, largest deviation %3 ms, over the last 32 periods</source>
        <translation>周期 %1 ms、標準偏差 %2 ms、最大偏差 %3 ms、直近 32 周期</translation>
    </message>
    <message>
        <source>Right click: choose the field</source>
        <translation>右クリック: フィールドを選択</translation>
    </message>
    <message>
        <source>Standard deviation of the last 32 periods</source>
        <translation>直近 32 周期の標準偏差</translation>
    </message>
    <message>
        <source>The last frame; bytes that changed within 0.7 s are marked</source>
        <translation>最後のフレーム。0.7 s 以内に変化したバイトに印を付けます</translation>
    </message>
    <message>
        <source>id</source>
        <translation>ID</translation>
    </message>
    <message>
        <source>dir</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>message</source>
        <translation>メッセージ</translation>
    </message>
    <message>
        <source>dev</source>
        <translation>機器</translation>
    </message>
    <message>
        <source>rate Hz</source>
        <translation>周波数 Hz</translation>
    </message>
    <message>
        <source>jitter ms</source>
        <translation>ジッタ ms</translation>
    </message>
    <message>
        <source>frames</source>
        <translation>フレーム</translation>
    </message>
    <message>
        <source>data</source>
        <translation>データ</translation>
    </message>
    <message>
        <source>last value</source>
        <translation>最終値</translation>
    </message>
    <message>
        <source>last 5 s</source>
        <translation>直近 5 s</translation>
    </message>
</context>
<context>
    <name>mb::ImageText</name>
    <message>
        <source>no image yet</source>
        <translation>イメージなし</translation>
    </message>
    <message>
        <source>Open an Intel HEX file, or drop it here</source>
        <translation>Intel HEX ファイルを開くか、ここにドロップします</translation>
    </message>
    <message>
        <source>select a device to check it</source>
        <translation>確認するには機器を選択してください</translation>
    </message>
    <message>
        <source>version %1 · pages: %2</source>
        <translation>バージョン %1 · ページ数: %2</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>不明</translation>
    </message>
</context>
<context>
    <name>mb::Inspector</name>
    <message>
        <source>Inspector</source>
        <translation>インスペクタ</translation>
    </message>
    <message>
        <source>Identify</source>
        <translation>識別</translation>
    </message>
    <message>
        <source>Read all</source>
        <translation>すべて読出し</translation>
    </message>
    <message>
        <source>Read every parameter of this unit</source>
        <translation>この機器の全パラメータを読み出します</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>ライブ</translation>
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
        <translation>電流</translation>
    </message>
    <message>
        <source>duty</source>
        <translation>デューティ</translation>
    </message>
    <message>
        <source>bus</source>
        <translation>バス</translation>
    </message>
    <message>
        <source>case</source>
        <translation>ケース</translation>
    </message>
    <message>
        <source>Identity</source>
        <translation>識別情報</translation>
    </message>
    <message>
        <source>serial</source>
        <translation>シリアル番号</translation>
    </message>
    <message>
        <source>firmware</source>
        <translation>ファームウェア</translation>
    </message>
    <message>
        <source>bootloader</source>
        <translation>ブートローダ</translation>
    </message>
    <message>
        <source>session</source>
        <translation>セッション</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状態</translation>
    </message>
    <message>
        <source>faults</source>
        <translation>フォルト</translation>
    </message>
    <message>
        <source>over-temperature</source>
        <translation>過熱</translation>
    </message>
    <message>
        <source>limits</source>
        <translation>制限</translation>
    </message>
    <message>
        <source>changed from default</source>
        <translation>既定値から変更</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1/%2</translation>
    </message>
    <message>
        <source>in RAM only</source>
        <translation>RAM のみ</translation>
    </message>
    <message>
        <source>No device selected</source>
        <translation>機器が選択されていません</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>Blink the lamps of this unit</source>
        <translation>この機器のランプを点滅させます</translation>
    </message>
</context>
<context>
    <name>mb::JogPanel</name>
    <message>
        <source>Nudge −</source>
        <translation>微動 −</translation>
    </message>
    <message>
        <source>Nudge +</source>
        <translation>微動 +</translation>
    </message>
    <message>
        <source>Nudge backwards</source>
        <translation>逆方向に微動</translation>
    </message>
    <message>
        <source>Nudge forwards</source>
        <translation>正方向に微動</translation>
    </message>
    <message>
        <source>A click moves it for a tenth of a second; held, it goes on until it is let go.</source>
        <translation>クリックすると 0.1 秒間動きます。押し続けると、離すまで動きます。</translation>
    </message>
</context>
<context>
    <name>mb::JournalCard</name>
    <message>
        <source>Journal</source>
        <translation>ジャーナル</translation>
    </message>
    <message>
        <source>Change…</source>
        <translation>変更…</translation>
    </message>
    <message>
        <source>Change the journal</source>
        <translation>ジャーナルを変更</translation>
    </message>
    <message>
        <source>On this computer</source>
        <translation>このコンピューター</translation>
    </message>
    <message>
        <source>PostgreSQL, %1</source>
        <translation>PostgreSQL、%1</translation>
    </message>
    <message>
        <source>station %1</source>
        <translation>ステーション %1</translation>
    </message>
    <message numerus="yes">
        <source>%n entries wait for the server</source>
        <translation>
            <numerusform>%n 件がサーバーを待っています</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n units of this run are in it</source>
        <translation>
            <numerusform>今回の %n 台を記録済み</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>mb::KeepBar</name>
    <message>
        <source>30 s from when the unit has restarted with them</source>
        <translation>新しい値で機器が再起動してから 30 s</translation>
    </message>
    <message>
        <source>they go back in %1 s</source>
        <translation>%1 s 後に元の値に戻ります</translation>
    </message>
    <message>
        <source>they go back as soon as the motor stands</source>
        <translation>モーターが停止しだい元の値に戻ります</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>維持</translation>
    </message>
    <message>
        <source>Time until the values go back</source>
        <translation>値が元に戻るまでの時間</translation>
    </message>
    <message numerus="yes">
        <source>%1 · %n more change(s) after this one</source>
        <translation>
            <numerusform>%1 · この後に変更 %n 件</numerusform>
        </translation>
    </message>
    <message>
        <source>Keep these values of %1?</source>
        <translation>%1 のこの値を維持しますか?</translation>
    </message>
    <message>
        <source>nothing goes back by itself</source>
        <translation>自動では戻りません</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>元に戻す</translation>
    </message>
</context>
<context>
    <name>mb::KeyBook</name>
    <message>
        <source>This key cannot be changed.</source>
        <translation>このキーは変更できません。</translation>
    </message>
    <message>
        <source>%1 stops every motor, always.</source>
        <translation>%1 は常に全モーターを停止します。</translation>
    </message>
    <message>
        <source>%1 is taken, %2: %3. Give that another key first.</source>
        <translation>%1 は使用中です。%2: %3。先にそちらへ別のキーを割り当ててください。</translation>
    </message>
    <message>
        <source>%1 belongs to the control that has the focus.</source>
        <translation>%1 はフォーカスのある部品が使います。</translation>
    </message>
</context>
<context>
    <name>mb::KeyDesk</name>
    <message>
        <source>stop every motor</source>
        <translation>全モーターを停止します</translation>
    </message>
    <message>
        <source>stops every motor, unless words can be typed where the focus is</source>
        <translation>全モーターを停止します (フォーカスが文字入力中の場合を除く)</translation>
    </message>
    <message>
        <source>presses the button or ticks the box that has the focus</source>
        <translation>フォーカスのあるボタンを押す、またはチェックを切り替えます</translation>
    </message>
    <message>
        <source>held for 1 s: arms; let go early it does nothing</source>
        <translation>1 s 長押しで駆動許可。途中で離すと何も起きません</translation>
    </message>
    <message>
        <source>keeps values that go back by themselves otherwise</source>
        <translation>自動で元に戻る値を保持します</translation>
    </message>
    <message>
        <source>Everywhere</source>
        <translation>共通</translation>
    </message>
    <message>
        <source>Production</source>
        <translation>生産</translation>
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
        <translation>ここで新しいキーを押す</translation>
    </message>
    <message>
        <source>New key</source>
        <translation>新しいキー</translation>
    </message>
</context>
<context>
    <name>mb::KeysPanel</name>
    <message>
        <source>Search commands and keys</source>
        <translation>コマンドとキーを検索</translation>
    </message>
    <message>
        <source>Commands and their keys</source>
        <translation>コマンドとそのキー</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>コマンド</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>キー</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>既定値</translation>
    </message>
    <message>
        <source>No key</source>
        <translation>キーなし</translation>
    </message>
    <message>
        <source>All defaults</source>
        <translation>すべて既定値</translation>
    </message>
    <message>
        <source>All keys are those they came with.</source>
        <translation>すべてのキーを既定値に戻しました。</translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>It came with: %1</source>
        <translation>既定値: %1</translation>
    </message>
    <message>
        <source>This key cannot be changed.</source>
        <translation>このキーは変更できません。</translation>
    </message>
    <message>
        <source>Choose a command, then press its new key in the field.</source>
        <translation>コマンドを選び、欄で新しいキーを押してください。</translation>
    </message>
</context>
<context>
    <name>mb::Lamp</name>
    <message>
        <source>Arm button: %1</source>
        <translation>駆動許可ボタン: %1</translation>
    </message>
    <message>
        <source>A motor was told to stop and was not seen to. Cut its power, or look at it.</source>
        <translation>モーターに停止を指令しましたが、停止を確認できていません。電源を切るか、目視で確認してください。</translation>
    </message>
    <message>
        <source>Press to make it safe again</source>
        <translation>押すと安全状態に戻ります</translation>
    </message>
    <message>
        <source>Hold for one second to arm</source>
        <translation>1 秒間押し続けると駆動許可します</translation>
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
        <translation>駆動許可</translation>
    </message>
    <message>
        <source>MOVING</source>
        <translation>動作中</translation>
    </message>
    <message>
        <source>STOPPED</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>STOPPING</source>
        <translation>停止処理中</translation>
    </message>
    <message>
        <source>MAY STILL TURN</source>
        <translation>回転中の可能性</translation>
    </message>
    <message>
        <source>keep holding</source>
        <translation>押し続けてください</translation>
    </message>
    <message>
        <source>hold to arm</source>
        <translation>長押しで駆動許可</translation>
    </message>
    <message>
        <source>nothing to arm</source>
        <translation>駆動許可の対象なし</translation>
    </message>
    <message>
        <source>hold to re-arm</source>
        <translation>長押しで再許可</translation>
    </message>
    <message>
        <source>cut its power</source>
        <translation>電源を切る</translation>
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
        <translation>負荷 %1</translation>
    </message>
    <message>
        <source>lost %1</source>
        <translation>欠落 %1</translation>
    </message>
    <message>
        <source>Link %1: %2</source>
        <translation>リンク %1: %2</translation>
    </message>
</context>
<context>
    <name>mb::LinkOptions</name>
    <message>
        <source>Bit rate</source>
        <translation>ビットレート</translation>
    </message>
    <message>
        <source>find it: all rates of the protocol</source>
        <translation>自動検出: プロトコルの全ビットレート</translation>
    </message>
    <message>
        <source>%1 bit/s</source>
        <translation>%1 bit/s</translation>
    </message>
    <message>
        <source>the computer&apos;s own RS-485 port</source>
        <translation>コンピューター内蔵の RS-485 ポート</translation>
    </message>
    <message>
        <source>RS-485</source>
        <translation>RS-485</translation>
    </message>
    <message>
        <source>Lets the kernel switch the driver of a port on the computer&apos;s board. Adapters on USB switch by themselves: leave it off.</source>
        <translation>コンピューター基板上のポートのドライバ切替えをカーネルに任せます。USB アダプタは自動で切り替わるため、オフのままにしてください。</translation>
    </message>
    <message>
        <source>Clock</source>
        <translation>クロック</translation>
    </message>
    <message>
        <source>%1 kHz</source>
        <translation>%1 kHz</translation>
    </message>
    <message>
        <source>Ready line (SRDY)</source>
        <translation>レディ線 (SRDY)</translation>
    </message>
    <message>
        <source>Reset line (MCLR)</source>
        <translation>リセット線 (MCLR)</translation>
    </message>
    <message>
        <source>Lost frames</source>
        <translation>欠落フレーム</translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>not wired</source>
        <translation>未配線</translation>
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
        <translation>%1、プロセス %2</translation>
    </message>
    <message>
        <source>%1 has this link too. Agree who drives: two masters on one motor disturb each other.</source>
        <translation>%1 もこのリンクを使用しています。どちらが駆動するか決めてください: 1 台のモーターに 2 つのマスタがあると干渉します。</translation>
    </message>
    <message>
        <source>%1 has this port. Close it there, then reconnect.</source>
        <translation>%1 がこのポートを使用しています。そちらで閉じてから再接続してください。</translation>
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
        <translation>制限と端子</translation>
    </message>
    <message>
        <source>no limit holds</source>
        <translation>作用中の制限なし</translation>
    </message>
</context>
<context>
    <name>mb::LogPage</name>
    <message>
        <source>Log</source>
        <translation>ログ</translation>
    </message>
    <message>
        <source>Search the log</source>
        <translation>ログを検索</translation>
    </message>
    <message>
        <source>Severity</source>
        <translation>重大度</translation>
    </message>
    <message>
        <source>All</source>
        <translation>すべて</translation>
    </message>
    <message>
        <source>Cautions</source>
        <translation>注意</translation>
    </message>
    <message>
        <source>Faults</source>
        <translation>フォルト</translation>
    </message>
    <message>
        <source>Save log…</source>
        <translation>ログを保存…</translation>
    </message>
    <message>
        <source>Nothing yet</source>
        <translation>まだありません</translation>
    </message>
    <message>
        <source>Actions and faults appear here.</source>
        <translation>操作とフォルトがここに表示されます。</translation>
    </message>
    <message>
        <source>Log lines</source>
        <translation>ログの行</translation>
    </message>
    <message>
        <source>Save the log</source>
        <translation>ログを保存</translation>
    </message>
    <message>
        <source>Text (*.log *.txt)</source>
        <translation>テキスト (*.log *.txt)</translation>
    </message>
    <message>
        <source>log saved to %1</source>
        <translation>ログを %1 に保存しました</translation>
    </message>
    <message>
        <source>searches</source>
        <translation>検索します</translation>
    </message>
</context>
<context>
    <name>mb::MainWindow</name>
    <message>
        <source>lost</source>
        <translation>欠落</translation>
    </message>
    <message>
        <source>%1: %2 frames received, %3 sent, %4 dropped, %5 errors</source>
        <translation>%1: 受信 %2 フレーム、送信 %3、破棄 %4、エラー %5</translation>
    </message>
    <message>
        <source>%1: %2 bytes received, %3 sent, %4 dropped, %5 errors</source>
        <translation>%1: 受信 %2 バイト、送信 %3、破棄 %4、エラー %5</translation>
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
        <translation>ボタン</translation>
    </message>
    <message>
        <source>Overview</source>
        <translation>概要</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>パラメータ</translation>
    </message>
    <message>
        <source>Tune</source>
        <translation>調整</translation>
    </message>
    <message>
        <source>Design</source>
        <translation>設計</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>プロット</translation>
    </message>
    <message>
        <source>Firmware</source>
        <translation>ファームウェア</translation>
    </message>
    <message>
        <source>Bus</source>
        <translation>バス</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>ログ</translation>
    </message>
    <message>
        <source>Reports</source>
        <translation>レポート</translation>
    </message>
    <message>
        <source>needs a device; open a link first</source>
        <translation>機器が必要です。先にリンクを開いてください</translation>
    </message>
    <message>
        <source>simulated bench</source>
        <translation>シミュレーションベンチ</translation>
    </message>
    <message>
        <source>the window lost the focus</source>
        <translation>ウィンドウがフォーカスを失いました</translation>
    </message>
    <message>
        <source>The preferences hold as soon as nothing is armed, no job runs and no other window is open.</source>
        <translation>環境設定は、駆動許可中の機器、実行中の処理、ほかに開いているウィンドウがなくなり次第、有効になります。</translation>
    </message>
    <message>
        <source>the limits were not kept: %1</source>
        <translation>制限が保持されませんでした: %1</translation>
    </message>
</context>
<context>
    <name>mb::MetricsPanel</name>
    <message>
        <source>Metrics</source>
        <translation>指標</translation>
    </message>
    <message>
        <source>Metrics of A and B</source>
        <translation>A と B の指標</translation>
    </message>
    <message>
        <source>Loop health</source>
        <translation>制御ループの状態</translation>
    </message>
    <message>
        <source>metric</source>
        <translation>指標</translation>
    </message>
    <message>
        <source>Δ B − A</source>
        <comment>difference</comment>
        <translation>Δ B − A</translation>
    </message>
    <message>
        <source>± from %1 repeats</source>
        <translation>± は %1 回の繰返しから算出</translation>
    </message>
    <message>
        <source>%1= same</source>
        <translation>%1= 同じ</translation>
    </message>
    <message>
        <source>SAT %1 %</source>
        <translation>飽和 %1 %</translation>
    </message>
    <message>
        <source>Share of the hold in which the duty was at its limit</source>
        <translation>保持時間のうちデューティが上限に達していた割合</translation>
    </message>
    <message>
        <source>ILIM</source>
        <translation>電流制限</translation>
    </message>
    <message>
        <source>The current was at its limit</source>
        <translation>電流が制限に達しました</translation>
    </message>
    <message>
        <source>RAMP</source>
        <translation>ランプ</translation>
    </message>
    <message>
        <source>The drive&apos;s own ramp was on</source>
        <translation>ドライブ自身のランプが有効でした</translation>
    </message>
    <message>
        <source>LIMIT SW</source>
        <translation>リミットSW</translation>
    </message>
    <message>
        <source>A limit switch was met</source>
        <translation>リミットスイッチに当たりました</translation>
    </message>
    <message>
        <source>WINDUP %1</source>
        <translation>ワインドアップ %1</translation>
    </message>
    <message>
        <source>WINDUP</source>
        <translation>ワインドアップ</translation>
    </message>
    <message>
        <source>The duty was at its limit while I went on; that is paid back as overshoot</source>
        <translation>デューティが上限にある間も I が積分を続けました。これがオーバーシュートとして現れます</translation>
    </message>
    <message>
        <source>QUANT</source>
        <translation>量子化</translation>
    </message>
    <message>
        <source>The step has few counts of the encoder</source>
        <translation>ステップのエンコーダカウント数が少なすぎます</translation>
    </message>
    <message>
        <source>LOST %1</source>
        <translation>欠落 %1</translation>
    </message>
    <message>
        <source>Samples that are missing</source>
        <translation>欠落したサンプル</translation>
    </message>
    <message>
        <source>SIMULATED</source>
        <translation>シミュレーション</translation>
    </message>
    <message>
        <source>Made on a simulated controller, and marked so for ever</source>
        <translation>シミュレーションのコントローラで得た結果であり、その印は消えません</translation>
    </message>
    <message>
        <source>means of %1 repeats</source>
        <translation>%1 回の平均</translation>
    </message>
    <message>
        <source>%1= same ±%2</source>
        <translation>%1= 同じ ±%2</translation>
    </message>
</context>
<context>
    <name>mb::ModePanel</name>
    <message>
        <source>Mode</source>
        <translation>モード</translation>
    </message>
    <message>
        <source>%1 mode</source>
        <translation>%1 モード</translation>
    </message>
</context>
<context>
    <name>mb::ModelPanel</name>
    <message>
        <source>Model</source>
        <translation>モデル</translation>
    </message>
    <message>
        <source>Nobody has identified this motor yet. Identify pushes it both ways with a part of the duty, inside the limits below, and changes no gain.</source>
        <translation>このモーターはまだ同定されていません。「同定」は下の制限内でデューティの一部を使ってモーターを両方向に動かします。ゲインは変更しません。</translation>
    </message>
    <message>
        <source>good fit</source>
        <translation>適合良好</translation>
    </message>
    <message>
        <source>not believed</source>
        <translation>信頼性なし</translation>
    </message>
    <message>
        <source>counts/s</source>
        <translation>counts/s</translation>
    </message>
    <message>
        <source>velocity filter</source>
        <translation>速度フィルタ</translation>
    </message>
    <message>
        <source>All figures</source>
        <translation>すべての値</translation>
    </message>
    <message>
        <source>Fold</source>
        <translation>折りたたむ</translation>
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
        <translation>定速時</translation>
    </message>
</context>
<context>
    <name>mb::MotionWords</name>
    <message>
        <source>%1 axes</source>
        <translation>%1 軸</translation>
    </message>
    <message>
        <source>axis %1 %2</source>
        <translation>軸 %1 %2</translation>
    </message>
    <message>
        <source>%1 on the adapter before</source>
        <translation>前のアダプターの %1</translation>
    </message>
</context>
<context>
    <name>mb::MovesPanel</name>
    <message>
        <source>Moves together</source>
        <translation>同時動作</translation>
    </message>
    <message>
        <source>to a position</source>
        <translation>位置へ移動</translation>
    </message>
    <message>
        <source>by a distance</source>
        <translation>距離だけ移動</translation>
    </message>
    <message>
        <source>at a velocity</source>
        <translation>速度で動作</translation>
    </message>
    <message>
        <source>Kind of the moves</source>
        <translation>動作の種類</translation>
    </message>
    <message>
        <source>profiled</source>
        <translation>プロファイル</translation>
    </message>
    <message>
        <source>With the stored acceleration and velocity</source>
        <translation>保存済みの加速度と速度で</translation>
    </message>
    <message>
        <source>With the acceleration and velocity that are stored in the device.</source>
        <translation>機器に保存されている加速度と速度で動作します。</translation>
    </message>
    <message>
        <source>Prepare</source>
        <translation>準備</translation>
    </message>
    <message>
        <source>Switches the motors on where they stand, and gives each its move to keep.</source>
        <translation>各モーターを現在位置でオンにし、動作指令を渡して保持させます。</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>開始</translation>
    </message>
    <message>
        <source>Start the prepared moves together</source>
        <translation>準備した動作を同時に開始</translation>
    </message>
    <message>
        <source>One command on the line starts all prepared moves at the same moment.</source>
        <translation>回線上の 1 つのコマンドで、準備した動作がすべて同時に始まります。</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>保持</translation>
    </message>
    <message>
        <source>Hold all of them where they are</source>
        <translation>すべてを現在位置で保持</translation>
    </message>
    <message>
        <source>Brakes to a halt and holds the position. The motors stay on; STOP switches them off.</source>
        <translation>減速停止して位置を保持します。モーターはオンのままです。STOP でオフになります。</translation>
    </message>
    <message>
        <source>%1 takes part</source>
        <translation>%1 は参加します</translation>
    </message>
    <message>
        <source>Target of %1</source>
        <translation>%1 の目標</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>応答なし</translation>
    </message>
    <message>
        <source>started</source>
        <translation>開始済み</translation>
    </message>
    <message>
        <source>prepared</source>
        <translation>準備済み</translation>
    </message>
    <message>
        <source>being prepared</source>
        <translation>準備中</translation>
    </message>
    <message>
        <source>moving</source>
        <translation>動作中</translation>
    </message>
    <message>
        <source>keeps a move</source>
        <translation>動作指令を保持</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>ロック中</translation>
    </message>
    <message>
        <source>off</source>
        <translation>オフ</translation>
    </message>
    <message>
        <source>All are prepared. Start begins them at the same moment.</source>
        <translation>すべて準備できました。「開始」で同時に動き始めます。</translation>
    </message>
    <message>
        <source>Stop takes no move away that has not begun: %1 would begin it with the next start on this line. Prepare gives a new one; switching the unit off clears it.</source>
        <translation>停止しても、開始していない動作指令は消えません: %1 はこの回線の次の開始指令で動き始めます。「準備」で新しい指令に置き換わり、機器の電源を切ると消えます。</translation>
    </message>
    <message>
        <source>Hold the Arm button. It covers all that take part.</source>
        <translation>駆動許可ボタンを長押ししてください。参加する全機器に適用されます。</translation>
    </message>
    <message>
        <source>Prepare switches the motors on where they stand; nothing turns before Start.</source>
        <translation>「準備」は各モーターを現在位置でオンにします。「開始」まで何も回転しません。</translation>
    </message>
    <message>
        <source>not prepared: &apos;%1&apos; is no number of counts</source>
        <translation>準備できません: 「%1」は counts の数値ではありません</translation>
    </message>
</context>
<context>
    <name>mb::NoticeModel</name>
    <message>
        <source>time</source>
        <translation>時刻</translation>
    </message>
    <message>
        <source>device</source>
        <translation>機器</translation>
    </message>
    <message>
        <source>what</source>
        <translation>内容</translation>
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
        <translation>概要</translation>
    </message>
    <message>
        <source>load</source>
        <translation>負荷</translation>
    </message>
    <message>
        <source>errors</source>
        <translation>エラー</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>欠落</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>不明</translation>
    </message>
    <message>
        <source>Frames received that no controller family knows: somebody else&apos;s traffic</source>
        <translation>どのコントローラファミリにも該当しない受信フレーム: 他の機器の通信です</translation>
    </message>
    <message>
        <source>round trip</source>
        <translation>往復時間</translation>
    </message>
    <message>
        <source>Load of the last minute</source>
        <translation>直近 1 分間の負荷</translation>
    </message>
</context>
<context>
    <name>mb::OwnProposal</name>
    <message>
        <source>own</source>
        <translation>独自</translation>
    </message>
    <message>
        <source>Own proposal</source>
        <translation>独自の候補</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>calm</source>
        <translation>緩やか</translation>
    </message>
    <message>
        <source>brisk</source>
        <translation>速応</translation>
    </message>
    <message>
        <source>Damping</source>
        <translation>ダンピング</translation>
    </message>
    <message>
        <source>robust</source>
        <translation>ロバスト</translation>
    </message>
    <message>
        <source>lively</source>
        <translation>敏感</translation>
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
        <translation>この組は機器に設定できません: %1</translation>
    </message>
    <message>
        <source>Held at τc %1 by: %2</source>
        <translation>τc %1 で制限: %2</translation>
    </message>
    <message>
        <source>proposal %1</source>
        <translation>候補 %1</translation>
    </message>
</context>
<context>
    <name>mb::PageKeys</name>
    <message>
        <source>Keys: %1</source>
        <translation>キー: %1</translation>
    </message>
    <message>
        <source>Everywhere</source>
        <translation>共通</translation>
    </message>
</context>
<context>
    <name>mb::PageMap</name>
    <message>
        <source>Flash pages</source>
        <translation>フラッシュページ</translation>
    </message>
    <message>
        <source>%1 of %2 pages written</source>
        <translation>%2 ページ中 %1 ページ書込み済み</translation>
    </message>
    <message>
        <source> · must not be interrupted</source>
        <translation> · 中断禁止</translation>
    </message>
    <message>
        <source>page %1: waiting</source>
        <translation>ページ %1: 待機中</translation>
    </message>
    <message>
        <source>page %1: being written</source>
        <translation>ページ %1: 書込み中</translation>
    </message>
    <message>
        <source>page %1: written after it was sent again</source>
        <translation>ページ %1: 再送後に書込み済み</translation>
    </message>
    <message>
        <source>page %1: written</source>
        <translation>ページ %1: 書込み済み</translation>
    </message>
    <message>
        <source>page %1: sent again</source>
        <translation>ページ %1: 再送</translation>
    </message>
    <message>
        <source>page %1: not in the image</source>
        <translation>ページ %1: イメージになし</translation>
    </message>
</context>
<context>
    <name>mb::PageStack</name>
    <message>
        <source>Pages</source>
        <translation>ページ</translation>
    </message>
</context>
<context>
    <name>mb::PageTabs</name>
    <message>
        <source>Pages</source>
        <translation>ページ</translation>
    </message>
</context>
<context>
    <name>mb::ParameterCommands</name>
    <message>
        <source>What was written before it is in force; the rest is still staged. Nothing was stored.</source>
        <translation>それ以前に書き込んだ値は有効です。残りは書込み待ちのままです。保存はしていません。</translation>
    </message>
    <message>
        <source>Nothing is proved to be in flash. Store again, and keep power on.</source>
        <translation>フラッシュへの保存は証明されていません。もう一度保存し、電源を切らないでください。</translation>
    </message>
    <message>
        <source>Nothing is kept.</source>
        <translation>何も保存していません。</translation>
    </message>
    <message>
        <source>What was written before it is in force. Undo takes it back.</source>
        <translation>それ以前に書き込んだ値は有効です。「元に戻す」で戻せます。</translation>
    </message>
</context>
<context>
    <name>mb::ParameterDelegate</name>
    <message>
        <source>%1, %2</source>
        <translation>%1、%2</translation>
    </message>
</context>
<context>
    <name>mb::ParameterFoot</name>
    <message>
        <source>What the parameter does</source>
        <translation>パラメータの働き</translation>
    </message>
    <message>
        <source>%1 edited</source>
        <translation>編集済み %1</translation>
    </message>
    <message>
        <source>%1 out of range</source>
        <translation>範囲外 %1</translation>
    </message>
    <message>
        <source>%1 without answer</source>
        <translation>応答なし %1</translation>
    </message>
    <message>
        <source>%1 in RAM</source>
        <translation>RAM %1</translation>
    </message>
    <message>
        <source>%1 stored</source>
        <translation>保存済み %1</translation>
    </message>
    <message>
        <source>%1 assumed</source>
        <translation>推定 %1</translation>
    </message>
    <message>
        <source>%1 not persistent</source>
        <translation>揮発性 %1</translation>
    </message>
    <message>
        <source>Choose a parameter to see what it does.</source>
        <translation>パラメータを選択すると働きを表示します。</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1。</translation>
    </message>
    <message>
        <source>↑↓ row · Enter edit · %1 write</source>
        <translation>↑↓ 行 · Enter 編集 · %1 書込み</translation>
    </message>
</context>
<context>
    <name>mb::ParameterGroups</name>
    <message>
        <source>1 parameter</source>
        <translation>パラメータ 1 個</translation>
    </message>
    <message>
        <source>%1 parameters</source>
        <translation>パラメータ %1 個</translation>
    </message>
    <message>
        <source>not kept over a power cycle</source>
        <translation>電源を切ると失われます</translation>
    </message>
    <message>
        <source>%1 not kept over a power cycle</source>
        <translation>%1 個は電源を切ると失われます</translation>
    </message>
</context>
<context>
    <name>mb::ParameterHead</name>
    <message>
        <source>Undo the last edit or write</source>
        <translation>直前の編集または書込みを元に戻す</translation>
    </message>
    <message>
        <source>Redo the edit or write</source>
        <translation>編集または書込みをやり直す</translation>
    </message>
    <message>
        <source>Read all</source>
        <translation>すべて読出し</translation>
    </message>
    <message>
        <source>Import…</source>
        <translation>インポート…</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>エクスポート…</translation>
    </message>
    <message>
        <source>Snapshot</source>
        <translation>スナップショット</translation>
    </message>
    <message>
        <source>History</source>
        <translation>履歴</translation>
    </message>
    <message>
        <source>More for the parameters</source>
        <translation>パラメータのその他の操作</translation>
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
        <translation>編集済み、元の値 %1</translation>
    </message>
    <message>
        <source>unknown until written</source>
        <translation>書込みまで不明</translation>
    </message>
    <message>
        <source>default</source>
        <translation>既定値</translation>
    </message>
    <message>
        <source>edited, was unknown</source>
        <translation>編集済み、元の値は不明</translation>
    </message>
    <message>
        <source>no answer, retry</source>
        <translation>応答なし、再試行</translation>
    </message>
    <message>
        <source>not read</source>
        <translation>未読出し</translation>
    </message>
    <message>
        <source>from a file</source>
        <translation>ファイルから</translation>
    </message>
    <message>
        <source>Can only be read.</source>
        <translation>読出し専用です。</translation>
    </message>
    <message>
        <source>Is cleared with the faults, not by writing.</source>
        <translation>書込みではなく、フォルトのクリアで消えます。</translation>
    </message>
    <message>
        <source>%1, default %2</source>
        <translation>%1、既定値 %2</translation>
    </message>
    <message>
        <source>%1 is 100 %</source>
        <translation>%1 が 100 %</translation>
    </message>
    <message>
        <source>Not kept over a power cycle.</source>
        <translation>電源を切ると失われます。</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1、%2</translation>
    </message>
    <message>
        <source>parameter</source>
        <translation>パラメータ</translation>
    </message>
    <message>
        <source>key</source>
        <translation>キー</translation>
    </message>
    <message>
        <source>value</source>
        <translation>値</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>単位</translation>
    </message>
    <message>
        <source>state</source>
        <translation>状態</translation>
    </message>
    <message>
        <source>raw</source>
        <translation>生値</translation>
    </message>
</context>
<context>
    <name>mb::ParameterTools</name>
    <message>
        <source>Search parameters</source>
        <translation>パラメータの検索</translation>
    </message>
    <message>
        <source>Which parameters</source>
        <translation>表示するパラメータ</translation>
    </message>
    <message>
        <source>All</source>
        <translation>すべて</translation>
    </message>
    <message>
        <source>Changed</source>
        <translation>変更あり</translation>
    </message>
    <message>
        <source>Edited</source>
        <translation>編集済み</translation>
    </message>
    <message>
        <source>Errors</source>
        <translation>エラー</translation>
    </message>
    <message>
        <source>All %1</source>
        <translation>すべて %1</translation>
    </message>
    <message>
        <source>Changed %1</source>
        <translation>変更あり %1</translation>
    </message>
    <message>
        <source>Edited %1</source>
        <translation>編集済み %1</translation>
    </message>
    <message>
        <source>Errors %1</source>
        <translation>エラー %1</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1/%2</translation>
    </message>
</context>
<context>
    <name>mb::ParameterView</name>
    <message>
        <source>Parameters</source>
        <translation>パラメータ</translation>
    </message>
    <message>
        <source>Copy as key=value</source>
        <translation>key=value としてコピー</translation>
    </message>
    <message>
        <source>Revert the edit</source>
        <translation>編集を元に戻す</translation>
    </message>
    <message>
        <source>Set to the default, %1</source>
        <translation>既定値 %1 に設定</translation>
    </message>
</context>
<context>
    <name>mb::ParametersPage</name>
    <message>
        <source>Open a parameter file…</source>
        <translation>パラメータファイルを開く…</translation>
    </message>
    <message>
        <source>Open a parameter file</source>
        <translation>パラメータファイルを開く</translation>
    </message>
    <message>
        <source>Import parameters</source>
        <translation>パラメータのインポート</translation>
    </message>
    <message>
        <source>Export parameters</source>
        <translation>パラメータのエクスポート</translation>
    </message>
    <message>
        <source>reads all parameters</source>
        <translation>全パラメータを読み出します</translation>
    </message>
    <message>
        <source>searches</source>
        <translation>検索します</translation>
    </message>
    <message>
        <source>writes what is staged</source>
        <translation>書込み待ちの変更を書き込みます</translation>
    </message>
    <message>
        <source>undoes the last edit, or else the last write to the unit</source>
        <translation>直前の編集、なければ機器への直前の書込みを元に戻します</translation>
    </message>
    <message>
        <source>shows the history of the unit, or its values</source>
        <translation>機器の履歴と値の表示を切り替えます</translation>
    </message>
    <message>
        <source>Select a device</source>
        <translation>機器を選択</translation>
    </message>
    <message>
        <source>Its parameters appear here. A parameter file can be looked at and compared without a device.</source>
        <translation>機器のパラメータがここに表示されます。パラメータファイルは機器がなくても表示、比較できます。</translation>
    </message>
    <message>
        <source>No parameters in the bootloader</source>
        <translation>ブートローダにはパラメータがありません</translation>
    </message>
    <message>
        <source>%1 has no application running. Write firmware to it, then its parameters can be read.</source>
        <translation>%1 ではアプリケーションが動作していません。ファームウェアを書き込むとパラメータを読み出せます。</translation>
    </message>
    <message>
        <source>No parameters</source>
        <translation>パラメータなし</translation>
    </message>
    <message>
        <source>%1 has none.</source>
        <translation>%1 にはありません。</translation>
    </message>
    <message>
        <source>Compare with a parameter file</source>
        <translation>パラメータファイルと比較</translation>
    </message>
    <message>
        <source>redoes the last edit or write</source>
        <translation>直前の編集または書込みをやり直します</translation>
    </message>
</context>
<context>
    <name>mb::PdfText</name>
    <message>
        <source>page %1 of %2</source>
        <translation>%1/%2 ページ</translation>
    </message>
    <message>
        <source>DEMO, a simulated unit</source>
        <translation>デモ、シミュレーションの機器</translation>
    </message>
</context>
<context>
    <name>mb::PlotBoard</name>
    <message>
        <source>DEMO</source>
        <translation>デモ</translation>
    </message>
    <message>
        <source>REPLAY</source>
        <translation>再生</translation>
    </message>
    <message>
        <source>%1 signals, %2 samples/s, %3 of %4 lost</source>
        <translation>%1 信号、%2 サンプル/s、%4 中 %3 欠落</translation>
    </message>
    <message>
        <source>ref %1</source>
        <translation>基準 %1</translation>
    </message>
</context>
<context>
    <name>mb::PlotExport</name>
    <message>
        <source>Export plot</source>
        <translation>プロットのエクスポート</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>画像をコピー</translation>
    </message>
    <message>
        <source>Copy numbers</source>
        <translation>数値をコピー</translation>
    </message>
    <message>
        <source>Copy summary</source>
        <translation>概要をコピー</translation>
    </message>
    <message>
        <source>Export PNG…</source>
        <translation>PNG をエクスポート…</translation>
    </message>
    <message>
        <source>PNG picture (*.png)</source>
        <translation>PNG 画像 (*.png)</translation>
    </message>
    <message>
        <source>Export SVG…</source>
        <translation>SVG をエクスポート…</translation>
    </message>
    <message>
        <source>SVG drawing (*.svg)</source>
        <translation>SVG 図面 (*.svg)</translation>
    </message>
    <message>
        <source>Export PDF…</source>
        <translation>PDF をエクスポート…</translation>
    </message>
    <message>
        <source>PDF document (*.pdf)</source>
        <translation>PDF 文書 (*.pdf)</translation>
    </message>
    <message>
        <source>Export CSV…</source>
        <translation>CSV をエクスポート…</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>表 (*.csv)</translation>
    </message>
</context>
<context>
    <name>mb::PlotLayoutBook</name>
    <message>
        <source>Save layout</source>
        <translation>レイアウトを保存</translation>
    </message>
    <message>
        <source>Save layout as…</source>
        <translation>レイアウトに名前を付けて保存…</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>リセット</translation>
    </message>
    <message>
        <source>Begin like this with every %1</source>
        <translation>%1 では常にこの表示で開始</translation>
    </message>
    <message>
        <source>Begin with the usual for every %1</source>
        <translation>%1 では常に標準の表示で開始</translation>
    </message>
</context>
<context>
    <name>mb::PlotScrubber</name>
    <message>
        <source>Whole session</source>
        <translation>セッション全体</translation>
    </message>
    <message>
        <source>The whole session: drag the box or click to scroll back, End returns to the present.
The recording goes on meanwhile.</source>
        <translation>セッション全体: 枠をドラッグまたはクリックすると過去に戻り、End で現在に戻ります。
その間も記録は続きます。</translation>
    </message>
</context>
<context>
    <name>mb::PlotStack</name>
    <message>
        <source>Plot</source>
        <translation>プロット</translation>
    </message>
    <message>
        <source>Pause view	P</source>
        <translation>表示を一時停止	P</translation>
    </message>
    <message>
        <source>Back to live	P</source>
        <translation>ライブに戻る	P</translation>
    </message>
    <message>
        <source>Fit time and value	0</source>
        <translation>時間と値を全体表示	0</translation>
    </message>
    <message>
        <source>Cursors A and B	L</source>
        <translation>カーソル A と B	L</translation>
    </message>
</context>
<context>
    <name>mb::PlotsBar</name>
    <message>
        <source>window %1 ms</source>
        <translation>時間幅 %1 ms</translation>
    </message>
    <message>
        <source>window %1 s</source>
        <translation>時間幅 %1 s</translation>
    </message>
    <message>
        <source>window %1 min</source>
        <translation>時間幅 %1 min</translation>
    </message>
    <message>
        <source>window %1 h</source>
        <translation>時間幅 %1 h</translation>
    </message>
    <message>
        <source>Pause view</source>
        <translation>表示を一時停止</translation>
    </message>
    <message>
        <source>Follow live</source>
        <translation>ライブ表示</translation>
    </message>
    <message>
        <source>The recording goes on.</source>
        <translation>記録は続きます。</translation>
    </message>
    <message>
        <source>View</source>
        <translation>表示</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>時間</translation>
    </message>
    <message>
        <source>X-Y</source>
        <translation>X-Y</translation>
    </message>
    <message>
        <source>Spectrum</source>
        <translation>スペクトル</translation>
    </message>
    <message>
        <source>Against time, one signal against another, or amplitude against frequency of what is seen or of A … B</source>
        <translation>時間に対する表示、信号対信号、または表示範囲か A … B の周波数に対する振幅</translation>
    </message>
    <message>
        <source>Length of the time axis</source>
        <translation>時間軸の長さ</translation>
    </message>
    <message>
        <source>Trigger: stands still at an edge or a level</source>
        <translation>トリガ: エッジまたはレベルで停止</translation>
    </message>
    <message>
        <source>Cursors A and B</source>
        <translation>カーソル A と B</translation>
    </message>
    <message>
        <source>Fit time and value</source>
        <translation>時間と値を全体表示</translation>
    </message>
    <message>
        <source>Keep what is seen as a reference</source>
        <translation>表示内容を基準波形として保持</translation>
    </message>
    <message>
        <source>Layouts: save, restore, reset</source>
        <translation>レイアウト: 保存、復元、リセット</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>エクスポート</translation>
    </message>
    <message>
        <source>The picture as PNG, SVG or PDF; samples as CSV or MCAP</source>
        <translation>画像を PNG、SVG、PDF で、サンプルを CSV、MCAP で書き出します</translation>
    </message>
</context>
<context>
    <name>mb::PlotsPage</name>
    <message>
        <source>No device yet</source>
        <translation>機器はまだありません</translation>
    </message>
    <message>
        <source>Open a link, or the simulated bench from the menu; its signals appear here.</source>
        <translation>リンク、またはメニューからシミュレーションベンチを開いてください。信号がここに表示されます。</translation>
    </message>
    <message>
        <source>Wheel zooms time, Ctrl+wheel values, Shift+wheel moves · drag moves · Shift+drag zooms into a box
double click or End returns to the present · right click for more</source>
        <translation>ホイールで時間を拡大縮小、Ctrl+ホイールで値、Shift+ホイールで移動 · ドラッグで移動 · Shift+ドラッグで枠内を拡大
ダブルクリックまたは End で現在に戻る · 右クリックでその他</translation>
    </message>
    <message>
        <source>Nothing is plotted</source>
        <translation>プロットなし</translation>
    </message>
    <message>
        <source>Double click a signal in the list at the right or under a device at the left, or drag it here.</source>
        <translation>右のリストまたは左の機器の下にある信号をダブルクリックするか、ここへドラッグしてください。</translation>
    </message>
    <message>
        <source>plot written to %1</source>
        <translation>プロットを %1 に書き出しました</translation>
    </message>
    <message>
        <source>pauses the plots, and goes on</source>
        <translation>プロットを一時停止、再開します</translation>
    </message>
    <message>
        <source>fits time and value</source>
        <translation>時間と値を全体表示します</translation>
    </message>
    <message>
        <source>cursors: arrows move one, C changes to the other</source>
        <translation>カーソル: 矢印キーで一方を移動、C で他方に切替え</translation>
    </message>
    <message>
        <source>watches for a trigger, or no more</source>
        <translation>トリガの監視を開始、終了します</translation>
    </message>
    <message>
        <source>records, or ends the recording</source>
        <translation>記録を開始、終了します</translation>
    </message>
    <message>
        <source>in the plots: less or more time</source>
        <translation>プロット内: 時間幅の縮小、拡大</translation>
    </message>
    <message>
        <source>in the plots: larger or smaller values</source>
        <translation>プロット内: 値の拡大、縮小</translation>
    </message>
    <message>
        <source>in the plots: writes a note at this time</source>
        <translation>プロット内: この時刻にメモを記入します</translation>
    </message>
    <message>
        <source>Note at this time…	N</source>
        <translation>この時刻にメモ…	N</translation>
    </message>
    <message>
        <source>Keep what is seen as a reference</source>
        <translation>表示内容を基準波形として保持</translation>
    </message>
    <message>
        <source>Remove references</source>
        <translation>基準波形を削除</translation>
    </message>
    <message>
        <source>Derived signal…</source>
        <translation>派生信号…</translation>
    </message>
    <message>
        <source>Spectrum of what is seen</source>
        <translation>表示範囲のスペクトル</translation>
    </message>
    <message>
        <source>X-Y</source>
        <translation>X-Y</translation>
    </message>
    <message>
        <source>Trigger: stands still at an edge or a level</source>
        <translation>トリガ: エッジまたはレベルで停止</translation>
    </message>
    <message>
        <source>Export samples…</source>
        <translation>サンプルをエクスポート…</translation>
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
        <translation>環境設定</translation>
    </message>
    <message>
        <source>dark</source>
        <translation>ダーク</translation>
    </message>
    <message>
        <source>light</source>
        <translation>ライト</translation>
    </message>
    <message>
        <source>as the desktop</source>
        <translation>デスクトップに合わせる</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Nothing moves but data</source>
        <translation>データ以外は動かさない</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>テーマ</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>言語</translation>
    </message>
    <message>
        <source>Text size</source>
        <translation>文字サイズ</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>アニメーション</translation>
    </message>
    <message>
        <source>Notebook, recordings</source>
        <translation>ノート、記録</translation>
    </message>
    <message>
        <source>Settings, layouts</source>
        <translation>設定、レイアウト</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>開く</translation>
    </message>
    <message>
        <source>Open the folder: %1</source>
        <translation>フォルダを開く: %1</translation>
    </message>
    <message>
        <source>General</source>
        <translation>一般</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>キー</translation>
    </message>
    <message>
        <source>high contrast</source>
        <translation>ハイコントラスト</translation>
    </message>
    <message>
        <source>counts</source>
        <translation>counts</translation>
    </message>
    <message>
        <source>rpm and degrees</source>
        <translation>rpm と度</translation>
    </message>
    <message>
        <source>With every verdict in production</source>
        <translation>生産モードの判定ごとに鳴らす</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>単位</translation>
    </message>
    <message>
        <source>Sounds</source>
        <translation>音</translation>
    </message>
    <message>
        <source>Guardian</source>
        <translation>監視プロセス</translation>
    </message>
</context>
<context>
    <name>mb::ProductionHead</name>
    <message>
        <source>recipe</source>
        <translation>レシピ</translation>
    </message>
    <message>
        <source>image</source>
        <translation>イメージ</translation>
    </message>
    <message>
        <source>parameters</source>
        <translation>パラメータ</translation>
    </message>
    <message>
        <source>number rule</source>
        <translation>番号の規則</translation>
    </message>
    <message>
        <source>self-test</source>
        <translation>セルフテスト</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>退出</translation>
    </message>
    <message>
        <source>Link that units are put on</source>
        <translation>機器を接続するリンク</translation>
    </message>
    <message>
        <source>Serial number, scanned or typed</source>
        <translation>シリアル番号、スキャンまたは入力</translation>
    </message>
    <message>
        <source>Scan or type a serial number</source>
        <translation>シリアル番号をスキャンまたは入力</translation>
    </message>
    <message>
        <source>Open recipe…</source>
        <translation>レシピを開く…</translation>
    </message>
    <message>
        <source>Hold to arm self-tests</source>
        <translation>長押しでセルフテストを駆動許可</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>開始</translation>
    </message>
    <message>
        <source>End</source>
        <translation>終了</translation>
    </message>
    <message>
        <source>No recipe yet</source>
        <translation>レシピなし</translation>
    </message>
    <message>
        <source>ARMED, hold to disarm</source>
        <translation>駆動許可中、長押しで解除</translation>
    </message>
    <message>
        <source>%1, not open</source>
        <translation>%1、開いていません</translation>
    </message>
</context>
<context>
    <name>mb::ProductionPage</name>
    <message>
        <source>Production</source>
        <translation>生産</translation>
    </message>
    <message>
        <source>Last ten units</source>
        <translation>直近 10 台</translation>
    </message>
    <message>
        <source>Sound</source>
        <translation>音</translation>
    </message>
    <message>
        <source>Sound with every verdict</source>
        <translation>判定ごとに音を鳴らす</translation>
    </message>
    <message>
        <source>tests the last unit again</source>
        <translation>直前の機器を再試験します</translation>
    </message>
    <message>
        <source>sets it aside, ready for the next</source>
        <translation>機器を除外し、次に備えます</translation>
    </message>
    <message>
        <source>Open recipe</source>
        <translation>レシピを開く</translation>
    </message>
    <message>
        <source>Recipes (*.json);;All files (*)</source>
        <translation>レシピ (*.json);;すべてのファイル (*)</translation>
    </message>
    <message>
        <source>The self-test turns the motor: %1</source>
        <translation>セルフテストでモーターが回転します: %1</translation>
    </message>
    <message>
        <source>not started: open a link first</source>
        <translation>開始できません: 先にリンクを開いてください</translation>
    </message>
    <message>
        <source>not started: open a recipe first</source>
        <translation>開始できません: 先にレシピを開いてください</translation>
    </message>
    <message>
        <source>no unit here has the serial number %1</source>
        <translation>シリアル番号 %1 の機器はここにありません</translation>
    </message>
    <message>
        <source>test again</source>
        <translation>再テスト</translation>
    </message>
    <message>
        <source>set aside</source>
        <translation>よける</translation>
    </message>
    <message>
        <source>serial number</source>
        <translation>シリアル番号</translation>
    </message>
    <message>
        <source>leave</source>
        <translation>終了</translation>
    </message>
    <message>
        <source>stops every motor</source>
        <translation>すべてのモーターを停止</translation>
    </message>
    <message>
        <source>not tested again: %1</source>
        <translation>再試験しません: %1</translation>
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
        <translation>プロファイルの速度</translation>
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
        <translation>プロファイルの加速度</translation>
    </message>
    <message>
        <source>The profile needs a velocity up to %1 counts/s.</source>
        <translation>プロファイルには %1 counts/s 以下の速度が必要です。</translation>
    </message>
    <message>
        <source>The profile needs an acceleration up to %1 counts/s²; 0 is none.</source>
        <translation>プロファイルには %1 counts/s² 以下の加速度が必要です。0 はなしを表します。</translation>
    </message>
</context>
<context>
    <name>mb::ProfilePanel</name>
    <message>
        <source>What only you know</source>
        <translation>利用者だけが知る情報</translation>
    </message>
    <message>
        <source>Dialect</source>
        <translation>ダイアレクト</translation>
    </message>
    <message>
        <source>How this unit is spoken to. The scan finds it out; choose another only if you know better.</source>
        <translation>この機器との通信方式です。スキャンで判別します。確かな場合だけ別のものを選択してください。</translation>
    </message>
    <message>
        <source>dialect as found</source>
        <translation>検出したダイアレクト</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>不明</translation>
    </message>
    <message>
        <source>Speak another dialect?</source>
        <translation>別のダイアレクトで通信しますか?</translation>
    </message>
    <message>
        <source>Speak to this unit as %1?</source>
        <translation>この機器と %1 として通信しますか?</translation>
    </message>
    <message>
        <source>Speak it</source>
        <translation>使用する</translation>
    </message>
    <message>
        <source>dialect as found: %1</source>
        <translation>検出したダイアレクト: %1</translation>
    </message>
</context>
<context>
    <name>mb::ProgrammerBox</name>
    <message>
        <source>Programmer</source>
        <translation>書込み器</translation>
    </message>
    <message>
        <source>What writes the flash: one of the list, or the name that the program gives to another</source>
        <translation>フラッシュに書き込むもの: リストから選ぶか、プログラムが付けた別の名前を指定します</translation>
    </message>
    <message>
        <source>Port of the programmer</source>
        <translation>書込み器のポート</translation>
    </message>
    <message>
        <source>Where the programmer, or the line to the bootloader, is plugged in</source>
        <translation>書込み器またはブートローダへの回線の接続先</translation>
    </message>
    <message>
        <source>at</source>
        <translation>接続先</translation>
    </message>
    <message>
        <source>the device&apos;s own line</source>
        <translation>機器自身の回線</translation>
    </message>
    <message>
        <source>at USB</source>
        <translation>USB 接続</translation>
    </message>
    <message>
        <source>Choose a programmer</source>
        <translation>書込み器を選択してください</translation>
    </message>
    <message>
        <source>No serial port is plugged in; choose or name the one of the programmer</source>
        <translation>シリアルポートが接続されていません。書込み器のポートを選択または指定してください</translation>
    </message>
</context>
<context>
    <name>mb::ProjectDesk</name>
    <message>
        <source>Save the machine into a folder</source>
        <translation>装置をフォルダに保存</translation>
    </message>
    <message>
        <source>Open the folder of a machine</source>
        <translation>装置のフォルダを開く</translation>
    </message>
    <message numerus="yes">
        <source>%n unit(s) saved into %1</source>
        <translation>
            <numerusform>%n 台の機器を %1 に保存しました</numerusform>
        </translation>
    </message>
    <message>
        <source>scales and limits of the project are in force</source>
        <translation>プロジェクトのスケールと制限が有効です</translation>
    </message>
    <message>
        <source>dialect %1 of the folder is not in force: choose it in the inspector if that is what it speaks</source>
        <translation>フォルダのダイアレクト %1 は有効ではありません。機器がそれを使うなら、インスペクタで選んでください</translation>
    </message>
</context>
<context>
    <name>mb::ProposalCard</name>
    <message>
        <source>quiet, forgiving</source>
        <translation>静か、寛容</translation>
    </message>
    <message>
        <source>hardly overshoots</source>
        <translation>オーバーシュートほぼなし</translation>
    </message>
    <message>
        <source>fastest rise</source>
        <translation>立上り最速</translation>
    </message>
    <message>
        <source>Ms</source>
        <translation>Ms</translation>
    </message>
    <message>
        <source>calm</source>
        <translation>緩やか</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>標準</translation>
    </message>
    <message>
        <source>brisk</source>
        <translation>速応</translation>
    </message>
    <message>
        <source>τc %1</source>
        <translation>τc %1</translation>
    </message>
    <message>
        <source>raw %1</source>
        <translation>生値 %1</translation>
    </message>
    <message>
        <source>%1 = 0</source>
        <translation>%1 = 0</translation>
    </message>
    <message>
        <source>Proposal: %1</source>
        <translation>候補: %1</translation>
    </message>
    <message>
        <source>over</source>
        <translation>OS</translation>
    </message>
    <message>
        <source>settle</source>
        <translation>整定</translation>
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
        <translation>ピーク</translation>
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
        <translation>独自</translation>
    </message>
    <message>
        <source>Proposals</source>
        <translation>候補</translation>
    </message>
    <message>
        <source>to be found anew</source>
        <translation>求め直します</translation>
    </message>
</context>
<context>
    <name>mb::QueueBar</name>
    <message>
        <source>State of the queue</source>
        <translation>キューの状態</translation>
    </message>
    <message>
        <source>Progress of the queue</source>
        <translation>キューの進捗</translation>
    </message>
    <message>
        <source>Pause after this unit</source>
        <translation>この機器の後で一時停止</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>再開</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Retry failed</source>
        <translation>不合格をやり直す</translation>
    </message>
    <message>
        <source>Save CSV…</source>
        <translation>CSV を保存…</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>開始</translation>
    </message>
    <message>
        <source>Ended before its time: %1</source>
        <translation>途中で終了: %1</translation>
    </message>
    <message>
        <source>Pauses after this unit</source>
        <translation>この機器の後で停止します</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>一時停止中</translation>
    </message>
    <message>
        <source>Unit %1 of %2</source>
        <translation>%2 台中 %1 台目</translation>
    </message>
    <message numerus="yes">
        <source>Ended with %n unit(s) to go</source>
        <translation>
            <numerusform>終了、残り %n 台</numerusform>
        </translation>
    </message>
    <message>
        <source>Ended: %1 of %2 units</source>
        <translation>終了: %2 台中 %1 台</translation>
    </message>
    <message>
        <source>Nothing running</source>
        <translation>実行中の処理なし</translation>
    </message>
    <message>
        <source>about %1 s left</source>
        <translation>残り約 %1 s</translation>
    </message>
    <message>
        <source>%1 done</source>
        <translation>完了 %1</translation>
    </message>
    <message>
        <source>%1 waiting</source>
        <translation>待機 %1</translation>
    </message>
    <message>
        <source>%1 failed</source>
        <translation>不合格 %1</translation>
    </message>
    <message>
        <source>%1 refused</source>
        <translation>拒否 %1</translation>
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
        <translation>続ける</translation>
    </message>
    <message>
        <source>A queue runs already.</source>
        <translation>キューはすでに実行中です。</translation>
    </message>
    <message>
        <source>Open an image or a recipe first.</source>
        <translation>先にイメージかレシピを開いてください。</translation>
    </message>
    <message>
        <source>Tick the units first.</source>
        <translation>先に機器にチェックを入れてください。</translation>
    </message>
    <message>
        <source>Save what was done</source>
        <translation>実施内容を保存</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>表 (*.csv)</translation>
    </message>
    <message>
        <source>the units are in %1</source>
        <translation>機器の一覧は %1 にあります</translation>
    </message>
    <message>
        <source>The last queue of this recipe was cut off: %1 done, %2 open</source>
        <translation>このレシピの前回のキューは中断されました: 完了 %1、未完了 %2</translation>
    </message>
    <message>
        <source>What has ended stays as it is; ticked units are taken along.</source>
        <translation>完了したものはそのまま残り、チェックした機器も処理します。</translation>
    </message>
    <message>
        <source>One unit at a time on a bus, buses side by side. Real units keep this computer awake. The journal is on disk: after a crash the queue goes on.</source>
        <translation>1 つのバスで 1 台ずつ、バスは並行に処理します。実機の処理中はコンピューターをスリープさせません。ジャーナルはディスクにあり、異常終了後も続きから再開します。</translation>
    </message>
    <message>
        <source>Every unit is backed up before and compared afterwards; the journal has it.</source>
        <translation>どの機器も事前にバックアップし、事後に比較します。結果はジャーナルに残ります。</translation>
    </message>
    <message>
        <source>not tried again: %1</source>
        <translation>再試行しません: %1</translation>
    </message>
    <message>
        <source>not tried again: it was served by %1; tick it and start</source>
        <translation>再試行しません: %1 で処理されました。チェックを入れて開始してください</translation>
    </message>
    <message>
        <source>%1 waits until this queue has ended</source>
        <translation>%1 はこのキューが終わるまで待ちます</translation>
    </message>
</context>
<context>
    <name>mb::QueueChecks</name>
    <message>
        <source>recipe checked</source>
        <translation>レシピ確認済み</translation>
    </message>
    <message>
        <source>no image, no recipe</source>
        <translation>イメージもレシピもありません</translation>
    </message>
    <message>
        <source>all motors stopped</source>
        <translation>全モーター停止</translation>
    </message>
    <message>
        <source>a motor is moving</source>
        <translation>モーターが動いています</translation>
    </message>
    <message>
        <source>no other master</source>
        <translation>ほかのマスタなし</translation>
    </message>
    <message>
        <source>another master, or a number taken twice</source>
        <translation>他のマスタあり、または番号が重複</translation>
    </message>
    <message>
        <source>bus %1 V</source>
        <translation>バス %1 V</translation>
    </message>
    <message>
        <source>bus voltage not known</source>
        <translation>バス電圧不明</translation>
    </message>
    <message>
        <source>Before start</source>
        <translation>開始前の確認</translation>
    </message>
</context>
<context>
    <name>mb::QueueHead</name>
    <message>
        <source>recipe</source>
        <translation>レシピ</translation>
    </message>
    <message>
        <source>image</source>
        <translation>イメージ</translation>
    </message>
    <message>
        <source>parameters</source>
        <translation>パラメータ</translation>
    </message>
    <message>
        <source>number rule</source>
        <translation>番号の規則</translation>
    </message>
    <message>
        <source>Open image…</source>
        <translation>イメージを開く…</translation>
    </message>
    <message>
        <source>Open recipe…</source>
        <translation>レシピを開く…</translation>
    </message>
    <message>
        <source>none yet</source>
        <translation>まだありません</translation>
    </message>
    <message>
        <source>Open a firmware image</source>
        <translation>ファームウェアイメージを開く</translation>
    </message>
    <message>
        <source>Intel HEX (*.hex *.ihex);;All files (*)</source>
        <translation>Intel HEX (*.hex *.ihex);;すべてのファイル (*)</translation>
    </message>
    <message>
        <source>Open recipe</source>
        <translation>レシピを開く</translation>
    </message>
    <message>
        <source>Recipes (*.json);;All files (*)</source>
        <translation>レシピ (*.json);;すべてのファイル (*)</translation>
    </message>
    <message>
        <source>Write a recipe</source>
        <translation>レシピを書く</translation>
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
        <translation>シリアル番号</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>機器</translation>
    </message>
    <message>
        <source>firmware</source>
        <translation>ファームウェア</translation>
    </message>
    <message>
        <source>step</source>
        <translation>手順</translation>
    </message>
    <message>
        <source>progress</source>
        <translation>進捗</translation>
    </message>
    <message>
        <source>time</source>
        <translation>時間</translation>
    </message>
    <message>
        <source>result</source>
        <translation>結果</translation>
    </message>
</context>
<context>
    <name>mb::QueueSide</name>
    <message>
        <source>The self-test turns the motor: %1. Hold Arm in the header once the queue runs.</source>
        <translation>セルフテストはモーターを回します: %1。キューの開始後、ヘッダの駆動許可ボタンを長押ししてください。</translation>
    </message>
</context>
<context>
    <name>mb::QueueTable</name>
    <message>
        <source>Every unit of this family</source>
        <translation>このファミリのすべての機器</translation>
    </message>
    <message>
        <source>Units of the queue</source>
        <translation>キューの機器</translation>
    </message>
    <message>
        <source>Every %1</source>
        <translation>すべての %1</translation>
    </message>
</context>
<context>
    <name>mb::QueueText</name>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>verified</source>
        <translation>確認済み</translation>
    </message>
    <message>
        <source>%1 parameters equal</source>
        <translation>パラメータ %1 個が一致</translation>
    </message>
    <message>
        <source>already %1</source>
        <translation>すでに %1</translation>
    </message>
    <message>
        <source>read back after the restart</source>
        <translation>再起動後に読み戻しました</translation>
    </message>
    <message>
        <source>safe to unplug, resumes</source>
        <translation>抜いても安全、再開可能</translation>
    </message>
    <message>
        <source>do not unplug</source>
        <translation>抜かないでください</translation>
    </message>
    <message>
        <source>waiting</source>
        <translation>待機中</translation>
    </message>
    <message>
        <source>cut off, goes on</source>
        <translation>中断、続きから</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>省略</translation>
    </message>
    <message>
        <source>cut off</source>
        <translation>打切り</translation>
    </message>
    <message>
        <source>failed: %1</source>
        <translation>不合格: %1</translation>
    </message>
    <message>
        <source>refused before start</source>
        <translation>開始前に拒否</translation>
    </message>
    <message>
        <source>number taken twice</source>
        <translation>番号が重複</translation>
    </message>
    <message>
        <source>in its bootloader</source>
        <translation>ブートローダ内</translation>
    </message>
    <message>
        <source>motor is moving</source>
        <translation>モーター動作中</translation>
    </message>
    <message>
        <source>another master drives it</source>
        <translation>別のマスタが駆動中</translation>
    </message>
    <message>
        <source>Preflight</source>
        <translation>事前確認</translation>
    </message>
    <message>
        <source>Backup</source>
        <translation>バックアップ</translation>
    </message>
    <message>
        <source>Firmware</source>
        <translation>ファームウェア</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>パラメータ</translation>
    </message>
    <message>
        <source>Self-test</source>
        <translation>セルフテスト</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>番号</translation>
    </message>
    <message>
        <source>Comparison and proof</source>
        <translation>比較と証明</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>完了</translation>
    </message>
    <message>
        <source>hold Arm in the header</source>
        <translation>ヘッダの駆動許可ボタンを長押し</translation>
    </message>
    <message>
        <source>written, not proved</source>
        <translation>書き込み済み、未確認</translation>
    </message>
    <message>
        <source>answers with %1, as before</source>
        <translation>以前と同じく %1 と応答</translation>
    </message>
</context>
<context>
    <name>mb::RamBlock</name>
    <message>
        <source>In RAM, not in flash</source>
        <translation>RAM のみ、フラッシュ未保存</translation>
    </message>
    <message>
        <source>Time until the device stores by itself</source>
        <translation>機器が自動保存するまでの時間</translation>
    </message>
    <message>
        <source>Store and prove</source>
        <translation>保存して検証</translation>
    </message>
    <message>
        <source>%1 s to go</source>
        <translation>残り %1 s</translation>
    </message>
    <message>
        <source>not proved</source>
        <translation>未証明</translation>
    </message>
    <message>
        <source>Read back and equal. Lost at power-off until it is stored.</source>
        <translation>読み戻して一致しました。保存するまでは、電源を切ると失われます。</translation>
    </message>
    <message>
        <source>Read back and equal. Do not cut power yet.</source>
        <translation>読み戻して一致しました。まだ電源を切らないでください。</translation>
    </message>
    <message>
        <source>%1 more.</source>
        <translation>ほか %1 個。</translation>
    </message>
    <message>
        <source>The device should have stored by itself. Its own proof takes up to %1 s.</source>
        <translation>機器は自動保存を終えているはずです。機器による証明には最大 %1 s かかります。</translation>
    </message>
</context>
<context>
    <name>mb::ReadStatus</name>
    <message>
        <source>Reading</source>
        <translation>読出し中</translation>
    </message>
    <message>
        <source>Reading %1 of %2</source>
        <translation>読出し中 %1/%2</translation>
    </message>
    <message>
        <source>no answer, the values are old</source>
        <translation>応答なし、値は古いものです</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>応答なし</translation>
    </message>
    <message>
        <source>%1 of %2 are read, %3 gave no answer</source>
        <translation>%2 個中 %1 個を読出し、%3 個は応答なし</translation>
    </message>
    <message>
        <source>not read yet</source>
        <translation>未読込み</translation>
    </message>
    <message>
        <source>%1 of %2 known</source>
        <translation>%2 個中 %1 個が既知</translation>
    </message>
    <message>
        <source>all %1 read</source>
        <translation>全 %1 個を読出し済み</translation>
    </message>
    <message>
        <source>all %1 read in %2</source>
        <translation>全 %1 個を %2 で読出し済み</translation>
    </message>
    <message>
        <source>%1, values for %2 from a file</source>
        <translation>%1、ファイルから読んだ %2 の値</translation>
    </message>
</context>
<context>
    <name>mb::RecipeEditor</name>
    <message>
        <source>New recipe</source>
        <translation>新しいレシピ</translation>
    </message>
    <message>
        <source>Fields of the recipe</source>
        <translation>レシピの項目</translation>
    </message>
    <message>
        <source>The file that is saved, line by line</source>
        <translation>保存されるファイル（行ごと）</translation>
    </message>
    <message>
        <source>What is wrong with the recipe</source>
        <translation>レシピの誤り</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Save recipe</source>
        <translation>レシピを保存</translation>
    </message>
    <message>
        <source>Recipe %1</source>
        <translation>レシピ %1</translation>
    </message>
    <message>
        <source>Keep the recipe</source>
        <translation>レシピを保管</translation>
    </message>
    <message>
        <source>Recipes (*.json)</source>
        <translation>レシピ (*.json)</translation>
    </message>
    <message>
        <source>This recipe is not saved.</source>
        <translation>このレシピは保存されていません。</translation>
    </message>
    <message>
        <source>Discard it</source>
        <translation>破棄する</translation>
    </message>
    <message>
        <source>Go on writing</source>
        <translation>編集を続ける</translation>
    </message>
    <message>
        <source>No mistake in the recipe</source>
        <translation>レシピに誤りはありません</translation>
    </message>
    <message>
        <source>Give the recipe a name.</source>
        <translation>レシピに名前を付けてください。</translation>
    </message>
</context>
<context>
    <name>mb::RecipeForm</name>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>Family</source>
        <translation>ファミリ</translation>
    </message>
    <message>
        <source>Firmware file</source>
        <translation>ファームウェアのファイル</translation>
    </message>
    <message>
        <source>Other way in</source>
        <translation>別の書き込み経路</translation>
    </message>
    <message>
        <source>Parameter file</source>
        <translation>パラメータのファイル</translation>
    </message>
    <message>
        <source>Save them where the unit does not by itself</source>
        <translation>機器が自動で保存しない場合は保存する</translation>
    </message>
    <message>
        <source>First number to give</source>
        <translation>割り当てる最初の番号</translation>
    </message>
    <message>
        <source>Self-test: the motor turns</source>
        <translation>セルフテスト: モーターが回転します</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>制御ループ</translation>
    </message>
    <message>
        <source>From</source>
        <translation>開始値</translation>
    </message>
    <message>
        <source>To</source>
        <translation>目標値</translation>
    </message>
    <message>
        <source>Time, s</source>
        <translation>時間, s</translation>
    </message>
    <message>
        <source>Repeats</source>
        <translation>繰り返し</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>軸</translation>
    </message>
    <message>
        <source>Gain slot</source>
        <translation>ゲインスロット</translation>
    </message>
    <message>
        <source>Travel at most, counts</source>
        <translation>最大移動量, カウント</translation>
    </message>
    <message>
        <source>Speed at most, counts/s</source>
        <translation>最大速度, カウント/s</translation>
    </message>
    <message>
        <source>Current at most, A</source>
        <translation>最大電流, A</translation>
    </message>
    <message>
        <source>Duty at most, 0 to 1</source>
        <translation>最大デューティ, 0～1</translation>
    </message>
    <message>
        <source>What the self-test accepts</source>
        <translation>セルフテストの合格条件</translation>
    </message>
    <message>
        <source>Accepted</source>
        <translation>合格条件</translation>
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
        <translation>両方向に計数する</translation>
    </message>
    <message>
        <source>Choose: %1</source>
        <translation>選択: %1</translation>
    </message>
    <message>
        <source>none: over its own link</source>
        <translation>なし: 自身のリンク経由</translation>
    </message>
    <message>
        <source>such as %1</source>
        <translation>例: %1</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>field, unit</comment>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>0 to 1</source>
        <translation>0～1</translation>
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
        <translation>%1 · バージョン %2 · sha %3</translation>
    </message>
    <message>
        <source>%1 · %2 values</source>
        <translation>%1 · 値 %2 個</translation>
    </message>
    <message>
        <source>next free from %1</source>
        <translation>%1 以降の空き番号</translation>
    </message>
</context>
<context>
    <name>mb::RecordStrip</name>
    <message>
        <source>Record…</source>
        <translation>記録…</translation>
    </message>
    <message>
        <source>End recording</source>
        <translation>記録を終了</translation>
    </message>
    <message>
        <source>Writes every frame of this link to a candump log or a Vector ASC file</source>
        <translation>このリンクの全フレームを candump ログまたは Vector ASC ファイルに書き出します</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Record the frames of %1</source>
        <translation>%1 のフレームを記録</translation>
    </message>
    <message>
        <source>Vector ASC log (*.asc)</source>
        <translation>Vector ASC ログ (*.asc)</translation>
    </message>
    <message>
        <source>candump log (*.log)</source>
        <translation>candump ログ (*.log)</translation>
    </message>
    <message>
        <source>nothing is recorded: %1</source>
        <translation>記録していません: %1</translation>
    </message>
    <message>
        <source>The recording has ended: %1. %2 frames are missing in it.</source>
        <translation>記録が終了しました: %1。%2 フレームが欠けています。</translation>
    </message>
    <message>
        <source>Recording  %1   %2 frames   %3   %4 lost   %5</source>
        <translation>記録中  %1   %2 フレーム   %3   欠落 %4   %5</translation>
    </message>
</context>
<context>
    <name>mb::Recorder</name>
    <message>
        <source>The last session did not end by itself. What it recorded is in %1.</source>
        <translation>前回のセッションは正常に終了しませんでした。その記録は %1 にあります。</translation>
    </message>
    <message>
        <source>Samples are recorded on disk again, those of the meantime too.</source>
        <translation>サンプルのディスクへの記録が再開しました。中断中の分も含みます。</translation>
    </message>
    <message>
        <source>Samples are not recorded on disk: %1</source>
        <translation>サンプルをディスクに記録できません: %1</translation>
    </message>
    <message>
        <source>What the last session recorded waits for the next start: %1</source>
        <translation>前回のセッションの記録は次の起動を待っています: %1</translation>
    </message>
</context>
<context>
    <name>mb::RecordingControl</name>
    <message>
        <source>Record</source>
        <translation>記録</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Keeps everything that devices send, beginning with the last %1.
What was recorded lately is on disk all the time and outlives a crash.</source>
        <translation>直近の %1 から始めて、機器が送信する内容をすべて保存します。
最近の記録は常にディスク上にあり、クラッシュしても残ります。</translation>
    </message>
    <message>
        <source>recording written to %1</source>
        <translation>記録を %1 に書き出しました</translation>
    </message>
    <message>
        <source>not recorded: %1</source>
        <translation>記録していません: %1</translation>
    </message>
    <message>
        <source>%1 · %2 · %3 samples</source>
        <translation>%1 · %2 · %3 サンプル</translation>
    </message>
    <message>
        <source>last %1 on disk · %2</source>
        <translation>直近 %1 をディスクに保持 · %2</translation>
    </message>
</context>
<context>
    <name>mb::ReplayBar</name>
    <message>
        <source>Recording that is played</source>
        <translation>再生する記録</translation>
    </message>
    <message>
        <source>REPLAY</source>
        <translation>再生</translation>
    </message>
    <message>
        <source>Shows what was recorded. Nothing is sent, no motor moves.</source>
        <translation>記録内容を表示します。何も送信せず、モーターも動きません。</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>再生</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>一時停止</translation>
    </message>
    <message>
        <source>Play again</source>
        <translation>もう一度再生</translation>
    </message>
    <message>
        <source>Plays the recording from where it stands, or halts it there</source>
        <translation>現在の位置から記録を再生、またはそこで停止します</translation>
    </message>
    <message>
        <source>Speed of the replay</source>
        <translation>再生速度</translation>
    </message>
    <message>
        <source>How fast the recording is played</source>
        <translation>記録の再生の速さ</translation>
    </message>
    <message>
        <source>as fast as possible</source>
        <translation>最高速</translation>
    </message>
    <message>
        <source>Position in the recording</source>
        <translation>記録内の位置</translation>
    </message>
    <message>
        <source>Where the recording stands; arrow keys move it by 1 s, Page Up and Page Down by 10 s</source>
        <translation>記録の現在位置。矢印キーで 1 s、Page Up と Page Down で 10 s 移動します</translation>
    </message>
    <message>
        <source>%1: looking through it, %2 %</source>
        <translation>%1: 走査中、%2 %</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1/%2</translation>
    </message>
    <message>
        <source>recorded %1</source>
        <translation>記録日時 %1</translation>
    </message>
</context>
<context>
    <name>mb::ReportOrder</name>
    <message>
        <source>Write report</source>
        <translation>レポートを書き出す</translation>
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
        <translation>レポートを %1 に書き出しました</translation>
    </message>
    <message>
        <source>no report: %1</source>
        <translation>レポートなし: %1</translation>
    </message>
</context>
<context>
    <name>mb::ReportText</name>
    <message>
        <source>Rise, 10 to 90 %</source>
        <translation>立上り時間、10 ～ 90 %</translation>
    </message>
    <message>
        <source>Settling to 2 %</source>
        <translation>整定時間、2 %</translation>
    </message>
    <message>
        <source>Overshoot</source>
        <translation>オーバーシュート</translation>
    </message>
    <message>
        <source>Undershoot of the way back</source>
        <translation>戻りのアンダーシュート</translation>
    </message>
    <message>
        <source>Error at rest</source>
        <translation>定常偏差</translation>
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
        <translation>ピーク電流</translation>
    </message>
    <message>
        <source>Chatter of the duty, RMS</source>
        <translation>デューティの変動、RMS</translation>
    </message>
    <message>
        <source>Time at the duty limit</source>
        <translation>デューティ上限の時間</translation>
    </message>
    <message>
        <source>Noise of the measurement</source>
        <translation>測定ノイズ</translation>
    </message>
    <message>
        <source>step</source>
        <translation>ステップ</translation>
    </message>
    <message>
        <source>square wave</source>
        <translation>方形波</translation>
    </message>
    <message>
        <source>ramp</source>
        <translation>ランプ</translation>
    </message>
    <message>
        <source>sine</source>
        <translation>正弦波</translation>
    </message>
    <message>
        <source>chirp</source>
        <translation>チャープ</translation>
    </message>
    <message>
        <source>random steps</source>
        <translation>ランダムステップ</translation>
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
        <translation>電流</translation>
    </message>
    <message>
        <source>duty</source>
        <translation>デューティ</translation>
    </message>
    <message>
        <source>%1 times</source>
        <translation>%1 回</translation>
    </message>
    <message>
        <source>done</source>
        <translation>完了</translation>
    </message>
    <message>
        <source>cut off</source>
        <translation>打切り</translation>
    </message>
    <message>
        <source>interrupted</source>
        <translation>中断</translation>
    </message>
    <message>
        <source>stopped by the guard “%1”</source>
        <translation>ガード「%1」により停止</translation>
    </message>
    <message>
        <source>DEMO: this unit is simulated. Nothing here was measured on a motor.</source>
        <translation>デモ: この機器はシミュレーションです。実際のモーターで測定した値はありません。</translation>
    </message>
    <message>
        <source>Report on %1</source>
        <translation>%1 のレポート</translation>
    </message>
    <message>
        <source>Made on %1 with %2</source>
        <translation>%1、%2 で作成</translation>
    </message>
    <message>
        <source>There are no trials of this unit in the notebook.</source>
        <translation>この機器の試行はノートにありません。</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>ラベル</translation>
    </message>
    <message>
        <source>simulated</source>
        <translation>シミュレーション</translation>
    </message>
    <message>
        <source>Firmware %1</source>
        <translation>ファームウェア %1</translation>
    </message>
    <message>
        <source>s since the edge</source>
        <translation>エッジからの s</translation>
    </message>
    <message>
        <source>Trial %1: %2</source>
        <translation>試行 %1: %2</translation>
    </message>
    <message>
        <source>target</source>
        <translation>目標値</translation>
    </message>
    <message>
        <source>%1, measured</source>
        <translation>%1、実測</translation>
    </message>
    <message>
        <source>duty, %</source>
        <translation>デューティ、%</translation>
    </message>
    <message>
        <source>Metric</source>
        <translation>指標</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>値</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>ゲイン</translation>
    </message>
    <message>
        <source>Default</source>
        <translation>既定値</translation>
    </message>
    <message>
        <source>Parameters of this set that have their default: %1</source>
        <translation>この組のうち既定値のままのパラメータ: %1</translation>
    </message>
    <message>
        <source>travel ± %1</source>
        <translation>移動量 ± %1</translation>
    </message>
    <message>
        <source>speed %1</source>
        <translation>速度 %1</translation>
    </message>
    <message>
        <source>current %1</source>
        <translation>電流 %1</translation>
    </message>
    <message>
        <source>duty %1</source>
        <translation>デューティ %1</translation>
    </message>
    <message>
        <source>Trial %1, %2 loop</source>
        <translation>試行 %1、%2 ループ</translation>
    </message>
    <message>
        <source>Trial %1, open loop</source>
        <translation>試行 %1、開ループ</translation>
    </message>
    <message>
        <source>axis %1</source>
        <translation>軸 %1</translation>
    </message>
    <message>
        <source>gain slot %1</source>
        <translation>ゲインスロット %1</translation>
    </message>
    <message>
        <source>firmware %1</source>
        <translation>ファームウェア %1</translation>
    </message>
    <message>
        <source>motor seen stopped</source>
        <translation>モーターの停止を確認</translation>
    </message>
    <message>
        <source>stop not confirmed</source>
        <translation>停止未確認</translation>
    </message>
    <message>
        <source>%1 samples, %2 lost</source>
        <translation>%1 サンプル、欠落 %2</translation>
    </message>
    <message>
        <source>Nothing was recorded.</source>
        <translation>記録はありません。</translation>
    </message>
    <message>
        <source>It ran within: %1.</source>
        <translation>次の範囲内で実行: %1。</translation>
    </message>
    <message>
        <source>Note: %1</source>
        <translation>メモ: %1</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>番号</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>時間</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>制御ループ</translation>
    </message>
    <message>
        <source>Stimulus</source>
        <translation>励振</translation>
    </message>
    <message>
        <source>Rise</source>
        <translation>立上り</translation>
    </message>
    <message>
        <source>Settling</source>
        <translation>整定</translation>
    </message>
    <message>
        <source>End</source>
        <translation>終了</translation>
    </message>
    <message>
        <source>History of the unit</source>
        <translation>機器の履歴</translation>
    </message>
    <message>
        <source>The newest %1 of %2 trials.</source>
        <translation>%2 件の試行のうち最新 %1 件。</translation>
    </message>
    <message>
        <source>Kept</source>
        <translation>維持</translation>
    </message>
    <message>
        <source>Proposed, nothing was written</source>
        <translation>候補の提示のみ、書込みなし</translation>
    </message>
    <message>
        <source>Put back</source>
        <translation>元に戻し</translation>
    </message>
    <message>
        <source>Refused</source>
        <translation>拒否</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>none, as fresh as the position</source>
        <translation>なし、位置と同じ鮮度</translation>
    </message>
    <message>
        <source>rolling, %1</source>
        <translation>移動平均、%1</translation>
    </message>
    <message>
        <source>in blocks, %1</source>
        <translation>ブロック、%1</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>モデル</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>機器</translation>
    </message>
    <message>
        <source>Gain K</source>
        <translation>ゲイン K</translation>
    </message>
    <message>
        <source>Lag τ</source>
        <translation>時定数 τ</translation>
    </message>
    <message>
        <source>Friction kS</source>
        <translation>摩擦 kS</translation>
    </message>
    <message>
        <source>% duty</source>
        <translation>% デューティ</translation>
    </message>
    <message>
        <source>Velocity filter of the device: %1</source>
        <translation>機器の速度フィルタ: %1</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>合格</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>不合格</translation>
    </message>
    <message>
        <source>What the model was judged by:</source>
        <translation>モデルの判定基準:</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>変更前</translation>
    </message>
    <message>
        <source>Proposed</source>
        <translation>候補</translation>
    </message>
    <message>
        <source>Raw</source>
        <translation>生値</translation>
    </message>
    <message>
        <source>Proof</source>
        <translation>検証</translation>
    </message>
    <message>
        <source>Predicted</source>
        <translation>予測</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>実測</translation>
    </message>
    <message>
        <source>Sensitivity peak Ms</source>
        <translation>最大感度 Ms</translation>
    </message>
    <message>
        <source>Gain margin</source>
        <translation>ゲイン余裕</translation>
    </message>
    <message>
        <source>Phase margin</source>
        <translation>位相余裕</translation>
    </message>
    <message>
        <source>forwards</source>
        <translation>正方向</translation>
    </message>
    <message>
        <source>backwards</source>
        <translation>逆方向</translation>
    </message>
    <message>
        <source>predicted</source>
        <translation>予測</translation>
    </message>
    <message>
        <source>The step of the proof, predicted and measured</source>
        <translation>検証ステップ、予測と実測</translation>
    </message>
    <message>
        <source>Magnitude and phase of the open loop</source>
        <translation>開ループの振幅と位相</translation>
    </message>
    <message>
        <source>magnitude of the loop, dB</source>
        <translation>ループの振幅、dB</translation>
    </message>
    <message>
        <source>phase of the loop, °</source>
        <translation>ループの位相、°</translation>
    </message>
    <message>
        <source>Tuning of the %1 loop</source>
        <translation>%1 ループの調整</translation>
    </message>
    <message>
        <source>trials %1</source>
        <translation>試行 %1</translation>
    </message>
    <message>
        <source>Family</source>
        <translation>ファミリ</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>アドレス</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation>シリアル番号</translation>
    </message>
    <message>
        <source>Connected at</source>
        <translation>接続先</translation>
    </message>
    <message>
        <source>Firmware</source>
        <translation>ファームウェア</translation>
    </message>
    <message>
        <source>Bootloader</source>
        <translation>ブートローダ</translation>
    </message>
    <message>
        <source>Dialect</source>
        <translation>ダイアレクト</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>パラメータ</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>パラメータ</translation>
    </message>
    <message>
        <source>%1 of %2 differ from their default and are set in bold.</source>
        <translation>%2 個中 %1 個が既定値と異なり、太字で示します。</translation>
    </message>
    <message>
        <source>Resistance R, Ω</source>
        <translation>抵抗 R、Ω</translation>
    </message>
    <message>
        <source>Friction, V</source>
        <translation>摩擦、V</translation>
    </message>
    <message>
        <source>Gain 1/Ke, counts/s per V</source>
        <translation>ゲイン 1/Ke、counts/s/V</translation>
    </message>
    <message>
        <source>Encoder counts both ways</source>
        <translation>エンコーダは両方向に計数</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>はい</translation>
    </message>
    <message>
        <source>no</source>
        <translation>いいえ</translation>
    </message>
    <message>
        <source>Self-test</source>
        <translation>セルフテスト</translation>
    </message>
    <message>
        <source>Limits</source>
        <translation>制限</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>変更</translation>
    </message>
    <message>
        <source>%1 since %2</source>
        <translation>%1、%2 から</translation>
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
        <translation>未完了</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>結果</translation>
    </message>
    <message>
        <source>Recipe</source>
        <translation>レシピ</translation>
    </message>
    <message>
        <source>Served</source>
        <translation>処理日時</translation>
    </message>
    <message>
        <source>Number given</source>
        <translation>割り当てた番号</translation>
    </message>
    <message>
        <source>Parameters of the recipe</source>
        <translation>レシピのパラメータ</translation>
    </message>
    <message numerus="yes">
        <source>%n in the unit, read back</source>
        <translation>
            <numerusform>機器に %n 個、読み戻し済み</numerusform>
        </translation>
    </message>
    <message>
        <source>Service</source>
        <translation>保守</translation>
    </message>
    <message>
        <source>Cause or note</source>
        <translation>原因またはメモ</translation>
    </message>
    <message>
        <source>Every service of this unit</source>
        <translation>この機器の全保守履歴</translation>
    </message>
    <message>
        <source>Service card of %1</source>
        <translation>%1 のサービスカード</translation>
    </message>
    <message>
        <source>Parameters that differ from their default</source>
        <translation>既定値と異なるパラメータ</translation>
    </message>
    <message>
        <source>The first %1 of %2.</source>
        <translation>%2 個のうち最初の %1 個。</translation>
    </message>
    <message>
        <source>Counts/s per duty</source>
        <translation>デューティあたりカウント/s</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>位相</translation>
    </message>
    <message>
        <source>Coherence</source>
        <translation>コヒーレンス</translation>
    </message>
    <message>
        <source>Believed</source>
        <translation>信頼できる</translation>
    </message>
    <message>
        <source>magnitude of the motor, dB</source>
        <translation>モータのゲイン、dB</translation>
    </message>
    <message>
        <source>phase of the motor, °</source>
        <translation>モータの位相、°</translation>
    </message>
    <message>
        <source>model</source>
        <translation>モデル</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>測定値</translation>
    </message>
    <message>
        <source>Magnitude and phase of the motor, measured and of its model</source>
        <translation>モータのゲインと位相、測定値とモデル</translation>
    </message>
    <message>
        <source>Frequency response of the motor</source>
        <translation>モータの周波数応答</translation>
    </message>
    <message>
        <source>Sines of duty around a speed at which it never reverses, the last on %1. Believed and drawn are %2 of %3: ten samples make a swing, and the sine explains 0.9 of the movement at least (coherence).</source>
        <translation>反転しない速度を中心とするデューティの正弦波、最後は %1。信頼して描いたのは %3 個中 %2 個：1 周期に 10 サンプルあり、正弦波が動きの 0.9 以上を説明するもの（コヒーレンス）。</translation>
    </message>
    <message>
        <source>Load one way kG</source>
        <translation>一方向の負荷 kG</translation>
    </message>
    <message>
        <source>Gain forwards</source>
        <translation>正方向のゲイン</translation>
    </message>
    <message>
        <source>Gain backwards</source>
        <translation>逆方向のゲイン</translation>
    </message>
    <message>
        <source>Noise at rest σ</source>
        <translation>静止時のノイズ σ</translation>
    </message>
    <message>
        <source>Set-points that it can follow: at most %1 and %2</source>
        <translation>追従できる目標値: 最大 %1、%2</translation>
    </message>
    <message>
        <source>to be looked at</source>
        <translation>要確認</translation>
    </message>
    <message>
        <source>Order to motion</source>
        <translation>指令から動き出し</translation>
    </message>
    <message>
        <source>Dead time θ</source>
        <translation>むだ時間 θ</translation>
    </message>
    <message>
        <source>counts</source>
        <translation>counts</translation>
    </message>
    <message>
        <source>Breakaway forwards</source>
        <translation>正方向の始動</translation>
    </message>
    <message>
        <source>Breakaway backwards</source>
        <translation>逆方向の始動</translation>
    </message>
    <message>
        <source>Tag</source>
        <translation>タグ</translation>
    </message>
    <message>
        <source>Known by</source>
        <translation>識別</translation>
    </message>
    <message>
        <source>its place; another unit may stand there</source>
        <translation>場所による。別のユニットがそこにある場合もあります</translation>
    </message>
    <message>
        <source>Friction, share of duty</source>
        <translation>摩擦（デューティの割合）</translation>
    </message>
    <message>
        <source>Gain, counts/s at full duty</source>
        <translation>ゲイン（全デューティでの counts/s）</translation>
    </message>
    <message>
        <source>Not kept</source>
        <translation>採用せず</translation>
    </message>
    <message>
        <source>duty %1, which stands in for a limit of current</source>
        <translation>デューティ %1 (電流制限の代わり)</translation>
    </message>
    <message>
        <source>%1 (forgotten)</source>
        <translation>%1 (削除済み)</translation>
    </message>
    <message>
        <source>band: ± of the model</source>
        <translation>帯: モデルの ±</translation>
    </message>
    <message>
        <source>Proposal</source>
        <translation>候補</translation>
    </message>
    <message>
        <source>Response</source>
        <translation>応答</translation>
    </message>
    <message>
        <source>Bounded by</source>
        <translation>制限要因</translation>
    </message>
    <message>
        <source>chosen</source>
        <translation>選択</translation>
    </message>
    <message>
        <source>current, %1</source>
        <translation>電流、%1</translation>
    </message>
</context>
<context>
    <name>mb::ReportsPage</name>
    <message>
        <source>Reports</source>
        <translation>レポート</translation>
    </message>
    <message>
        <source>Nothing to report yet</source>
        <translation>レポートの対象はまだありません</translation>
    </message>
    <message>
        <source>The cards of units, their tunings and their trials appear here.</source>
        <translation>機器のカード、調整、試行がここに表示されます。</translation>
    </message>
    <message>
        <source>Search the reports</source>
        <translation>レポートの検索</translation>
    </message>
    <message>
        <source>Reports, newest first</source>
        <translation>レポート、新しい順</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>プレビュー</translation>
    </message>
    <message>
        <source>Write report…</source>
        <translation>レポートを書き出す…</translation>
    </message>
    <message>
        <source>Preview of the report</source>
        <translation>レポートのプレビュー</translation>
    </message>
    <message>
        <source>writes the report that is looked at</source>
        <translation>表示中のレポートを書き出します</translation>
    </message>
    <message>
        <source>goes to the search</source>
        <translation>検索へ移動します</translation>
    </message>
    <message>
        <source>Card of %1</source>
        <translation>%1 のカード</translation>
    </message>
    <message>
        <source>Tuning of %1</source>
        <translation>%1 の調整</translation>
    </message>
    <message>
        <source>%1 trials</source>
        <translation>試行 %1 件</translation>
    </message>
    <message>
        <source>Trial #%1 of %2</source>
        <translation>%2 の試行 #%1</translation>
    </message>
    <message>
        <source>What is listed</source>
        <translation>表示する内容</translation>
    </message>
    <message>
        <source>All</source>
        <translation>すべて</translation>
    </message>
    <message>
        <source>Cards</source>
        <translation>カード</translation>
    </message>
    <message>
        <source>Tuning</source>
        <translation>調整</translation>
    </message>
    <message>
        <source>Journal</source>
        <translation>ジャーナル</translation>
    </message>
    <message>
        <source>Note on this entry</source>
        <translation>この項目へのメモ</translation>
    </message>
    <message>
        <source>Note on this entry of the journal</source>
        <translation>ジャーナルのこの項目へのメモ</translation>
    </message>
    <message>
        <source>Size of the report</source>
        <translation>レポートのサイズ</translation>
    </message>
    <message>
        <source>Pages, A4</source>
        <translation>ページ (A4)</translation>
    </message>
    <message>
        <source>Label, 62 × 29 mm</source>
        <translation>ラベル (62 × 29 mm)</translation>
    </message>
    <message>
        <source>Save CSV…</source>
        <translation>CSV を保存…</translation>
    </message>
    <message>
        <source>The entries of the journal that are listed, as a table</source>
        <translation>表示中のジャーナル項目を表として保存</translation>
    </message>
    <message>
        <source>Save the journal</source>
        <translation>ジャーナルを保存</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>表 (*.csv)</translation>
    </message>
    <message>
        <source>the journal is in %1</source>
        <translation>ジャーナルは %1 にあります</translation>
    </message>
</context>
<context>
    <name>mb::ResolutionMeter</name>
    <message>
        <source>Resolution: off</source>
        <translation>分解能: オフ</translation>
    </message>
    <message>
        <source>Resolution: %1 steps</source>
        <translation>分解能: %1 段階</translation>
    </message>
    <message>
        <source>The device knows this value as %1 whole steps: the smallest change is %2 %.</source>
        <translation>機器はこの値を %1 段階の整数で扱います: 最小の変化は %2 % です。</translation>
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
        <translation>デモ</translation>
    </message>
    <message>
        <source>t = 0 at the edge, mean of %1 · %2 samples, %3 lost</source>
        <translation>エッジで t = 0、%1 回の平均 · %2 サンプル、欠落 %3</translation>
    </message>
    <message>
        <source>t = 0 at the edge · %1 samples, %2 lost</source>
        <translation>エッジで t = 0 · %1 サンプル、欠落 %2</translation>
    </message>
    <message>
        <source>Responses</source>
        <translation>応答</translation>
    </message>
    <message>
        <source>%1 #%2</source>
        <translation>%1 #%2</translation>
    </message>
    <message>
        <source>set-point</source>
        <translation>目標値</translation>
    </message>
    <message>
        <source>±2 % band</source>
        <translation>±2 % 帯</translation>
    </message>
    <message>
        <source>%1 peak %2 %</source>
        <translation>%1 ピーク %2 %</translation>
    </message>
    <message>
        <source>%1 settles %2</source>
        <translation>%1 整定 %2</translation>
    </message>
    <message>
        <source>%1: duty at %2 % limit, %3</source>
        <translation>%1: デューティが上限 %2 % に到達、%3</translation>
    </message>
    <message>
        <source>%1: current at its limit, %2</source>
        <translation>%1: 電流が制限に到達、%2</translation>
    </message>
    <message>
        <source>limit %1 %</source>
        <translation>上限 %1 %</translation>
    </message>
    <message>
        <source>limit %1 A</source>
        <translation>上限 %1 A</translation>
    </message>
</context>
<context>
    <name>mb::RoutePanel</name>
    <message>
        <source>Way in</source>
        <translation>接続経路</translation>
    </message>
    <message>
        <source>Programmer</source>
        <translation>書込み器</translation>
    </message>
    <message>
        <source>Programmer or port and where it is plugged in, as after --via on the command line</source>
        <translation>書込み器またはポートとその接続先。コマンドラインの --via に続く書式です</translation>
    </message>
    <message>
        <source>Microcontroller</source>
        <translation>マイクロコントローラ</translation>
    </message>
    <message>
        <source>Which microcontroller the unit has</source>
        <translation>機器のマイクロコントローラの種類</translation>
    </message>
    <message>
        <source>Erase what the unit has stored: its gains are lost</source>
        <translation>機器の保存内容を消去: ゲインは失われます</translation>
    </message>
    <message>
        <source>What is not known of it…</source>
        <translation>不明な項目…</translation>
    </message>
    <message>
        <source>What the maker does not tell of the bootloader, with the likely values</source>
        <translation>ブートローダについてメーカーが公開していない項目と、その推定値</translation>
    </message>
</context>
<context>
    <name>mb::SamplesWindow</name>
    <message>
        <source>%1 s, %2 samples, %3 lost</source>
        <translation>%1 s、%2 サンプル、欠落 %3</translation>
    </message>
    <message>
        <source>; the end of the file is missing</source>
        <translation>。ファイルの末尾が欠けています</translation>
    </message>
    <message>
        <source>%1 (recorded samples)</source>
        <translation>%1 (記録サンプル)</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>%1 を読込み中</translation>
    </message>
    <message>
        <source>Fit time and value</source>
        <translation>時間と値を全体表示</translation>
    </message>
    <message>
        <source>Cursors</source>
        <translation>カーソル</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>エクスポート</translation>
    </message>
    <message>
        <source>Channels</source>
        <translation>チャネル</translation>
    </message>
    <message>
        <source>Recorded samples</source>
        <translation>記録サンプル</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>書出し完了: %1</translation>
    </message>
    <message>
        <source>shows everything</source>
        <translation>全体を表示します</translation>
    </message>
    <message>
        <source>shows or hides the cursors</source>
        <translation>カーソルの表示/非表示を切り替えます</translation>
    </message>
    <message>
        <source>closes this window</source>
        <translation>このウィンドウを閉じます</translation>
    </message>
    <message>
        <source>shows these keys</source>
        <translation>キー一覧を表示します</translation>
    </message>
    <message>
        <source>%1: no samples</source>
        <translation>%1: サンプルなし</translation>
    </message>
    <message>
        <source>One export at a time: %1 is being written.</source>
        <translation>エクスポートは一度に 1 件です: %1 を書出し中です。</translation>
    </message>
    <message>
        <source>; the file has more, of which nothing is shown: it is too large for the memory</source>
        <translation>。ファイルにはさらにデータがありますが、メモリに収まらないため表示していません</translation>
    </message>
</context>
<context>
    <name>mb::SavedLimits</name>
    <message>
        <source>Kept limits</source>
        <translation>保存した制限</translation>
    </message>
    <message>
        <source>kept limits</source>
        <translation>保存した制限</translation>
    </message>
    <message>
        <source>Name of the limits</source>
        <translation>制限の名前</translation>
    </message>
    <message>
        <source>Choose limits that were kept for this unit, or type a name to keep the present ones under</source>
        <translation>この機器用に保存した制限を選択するか、現在の制限を保存する名前を入力してください</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>維持</translation>
    </message>
    <message>
        <source>Keep these limits under this name</source>
        <translation>この名前で制限を保存</translation>
    </message>
    <message>
        <source>Forget</source>
        <translation>消去</translation>
    </message>
    <message>
        <source>Forget the limits of this name</source>
        <translation>この名前の制限を消去</translation>
    </message>
</context>
<context>
    <name>mb::ScanStrip</name>
    <message>
        <source>What the scan looks for</source>
        <translation>スキャンの対象</translation>
    </message>
    <message>
        <source>Progress of the scan</source>
        <translation>スキャンの進捗</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Cancel the scan</source>
        <translation>スキャンを中止</translation>
    </message>
    <message>
        <source>Ends the search; what it has found stays.</source>
        <translation>スキャンを終了します。見つかったものは残ります。</translation>
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
        <translation>フレームの送信</translation>
    </message>
    <message>
        <source>Identifier</source>
        <translation>識別子</translation>
    </message>
    <message>
        <source>id, such as 7FF</source>
        <translation>ID (例: 7FF)</translation>
    </message>
    <message>
        <source>Hexadecimal; a whole frame such as 02061405#8125 may be pasted here</source>
        <translation>16 進数。02061405#8125 のようなフレーム全体も貼り付けられます</translation>
    </message>
    <message>
        <source>Length of the identifier</source>
        <translation>識別子の長さ</translation>
    </message>
    <message>
        <source>11 bits</source>
        <translation>11 ビット</translation>
    </message>
    <message>
        <source>29 bits</source>
        <translation>29 ビット</translation>
    </message>
    <message>
        <source>Data</source>
        <translation>データ</translation>
    </message>
    <message>
        <source>data, such as 81 25 11</source>
        <translation>データ (例: 81 25 11)</translation>
    </message>
    <message>
        <source>Repeat every</source>
        <translation>繰返し間隔</translation>
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
        <translation>送信</translation>
    </message>
    <message>
        <source>Hold to send</source>
        <translation>長押しで送信</translation>
    </message>
    <message>
        <source>End repeating</source>
        <translation>繰返しを終了</translation>
    </message>
    <message>
        <source>What is typed here is decoded before it is sent</source>
        <translation>入力内容を送信前にデコードします</translation>
    </message>
    <message>
        <source>Makes a motor move: %1</source>
        <translation>モーターが動きます: %1</translation>
    </message>
    <message>
        <source>ended</source>
        <translation>終了</translation>
    </message>
    <message>
        <source>The link does not take frames as fast as they are sent</source>
        <translation>送信の速さにリンクが追いつきません</translation>
    </message>
    <message>
        <source>%1 sent</source>
        <translation>%1 送信済み</translation>
    </message>
    <message>
        <source>%1 sent, then: %2</source>
        <translation>%1 送信後: %2</translation>
    </message>
    <message>
        <source>the page was left</source>
        <translation>ページを離れました</translation>
    </message>
    <message>
        <source>the window lost the focus</source>
        <translation>ウィンドウがフォーカスを失いました</translation>
    </message>
    <message>
        <source>no decoder knows this identifier</source>
        <translation>この識別子に対応するデコーダがありません</translation>
    </message>
    <message>
        <source>%1 of %2 #%3   %4</source>
        <translation>%2 #%3 の %1   %4</translation>
    </message>
</context>
<context>
    <name>mb::SessionDesk</name>
    <message>
        <source>today %1</source>
        <translation>今日 %1</translation>
    </message>
    <message>
        <source>yesterday %1</source>
        <translation>昨日 %1</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1、%2</translation>
    </message>
    <message>
        <source>%1 is used by %2 too</source>
        <translation>%1 は %2 も使用しています</translation>
    </message>
    <message>
        <source>agree who drives: two masters disturb each other</source>
        <translation>どちらが駆動するか決めてください: マスタが 2 つあると干渉します</translation>
    </message>
    <message>
        <source>The program ended unexpectedly (%1). What was measured is kept. Open again: %2?</source>
        <translation>プログラムが予期せず終了しました (%1)。測定結果は保存されています。もう一度開きますか: %2</translation>
    </message>
    <message numerus="yes">
        <source>%n unit(s)</source>
        <translation>
            <numerusform>機器 %n 台</numerusform>
        </translation>
    </message>
    <message>
        <source>Open</source>
        <translation>開く</translation>
    </message>
</context>
<context>
    <name>mb::SessionKeeper</name>
    <message>
        <source>This session cannot be kept: %1</source>
        <translation>このセッションは保存できません: %1</translation>
    </message>
</context>
<context>
    <name>mb::SetPointPanel</name>
    <message>
        <source>Set-point</source>
        <translation>目標値</translation>
    </message>
    <message>
        <source>Enter applies it while the motor runs; it never starts one.</source>
        <translation>Enter でモーター動作中に適用します。モーターを始動することはありません。</translation>
    </message>
    <message>
        <source>Set-point, slider</source>
        <translation>目標値、スライダ</translation>
    </message>
    <message>
        <source>Hide drive options</source>
        <translation>ドライブオプションを隠す</translation>
    </message>
    <message>
        <source>Stop and count from 0</source>
        <translation>停止して 0 から計数</translation>
    </message>
    <message>
        <source>Stops the motor, and makes where it stands position 0. It starts again with Run only: a motor that runs would jump.</source>
        <translation>モーターを停止し、その位置を 0 とします。再始動は「実行」でのみ行います: 動作中のモーターでは位置が飛ぶためです。</translation>
    </message>
    <message>
        <source>device</source>
        <translation>機器</translation>
    </message>
    <message>
        <source>No set-point. Enter a number up to ± %1.</source>
        <translation>目標値がありません。± %1 までの数値を入力してください。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no number. Enter one up to ± %2.</source>
        <translation>&quot;%1&quot; は数値ではありません。± %2 までの数値を入力してください。</translation>
    </message>
    <message>
        <source>%1 is no device number. Enter the number of the device to follow.</source>
        <translation>%1 は機器番号ではありません。追従する機器の番号を入力してください。</translation>
    </message>
    <message>
        <source>%1 is beyond the range of ± %2. Enter less, or widen the range.</source>
        <translation>%1 は範囲 ± %2 を超えています。小さい値を入力するか、範囲を広げてください。</translation>
    </message>
    <message>
        <source>now %1</source>
        <translation>現在 %1</translation>
    </message>
    <message>
        <source>Drive options</source>
        <translation>ドライブオプション</translation>
    </message>
</context>
<context>
    <name>mb::SetPointRange</name>
    <message>
        <source>Range ±</source>
        <translation>範囲 ±</translation>
    </message>
    <message>
        <source>Moves</source>
        <translation>変化</translation>
    </message>
    <message>
        <source>Range of the set-point, either way</source>
        <translation>目標値の範囲、両方向</translation>
    </message>
    <message>
        <source>A set-point beyond it is refused: the limit of the hand, not of the drive.</source>
        <translation>これを超える目標値は拒否します: ドライブではなく手動操作の制限です。</translation>
    </message>
    <message>
        <source>at once, as a step</source>
        <translation>即時、ステップ状</translation>
    </message>
    <message>
        <source>full range in %1</source>
        <translation>全範囲を %1 で</translation>
    </message>
    <message>
        <source>How fast the set-point moves</source>
        <translation>目標値の変化の速さ</translation>
    </message>
    <message>
        <source>This program moves the set-point no faster, whatever is typed.</source>
        <translation>入力値によらず、このプログラムは目標値をこれより速く変化させません。</translation>
    </message>
</context>
<context>
    <name>mb::SideDocks</name>
    <message>
        <source>Devices</source>
        <translation>機器</translation>
    </message>
    <message>
        <source>Inspector</source>
        <translation>インスペクタ</translation>
    </message>
    <message>
        <source>shows or hides the devices</source>
        <translation>機器の表示/非表示を切り替えます</translation>
    </message>
    <message>
        <source>shows or hides the inspector</source>
        <translation>インスペクタの表示/非表示を切り替えます</translation>
    </message>
    <message>
        <source>Show devices</source>
        <translation>機器を表示</translation>
    </message>
</context>
<context>
    <name>mb::SignalBook</name>
    <message>
        <source>The signal needs a name.</source>
        <translation>信号には名前が必要です。</translation>
    </message>
    <message>
        <source>There is a derived signal of this name.</source>
        <translation>同じ名前の派生信号があります。</translation>
    </message>
    <message>
        <source>%1 may be one of %2</source>
        <translation>%1 は次のいずれかの可能性があります: %2</translation>
    </message>
</context>
<context>
    <name>mb::SignalList</name>
    <message>
        <source>Add a signal</source>
        <translation>信号の追加</translation>
    </message>
    <message>
        <source>double click or drag</source>
        <translation>ダブルクリックまたはドラッグ</translation>
    </message>
    <message>
        <source>Signals that can be plotted</source>
        <translation>プロットできる信号</translation>
    </message>
    <message>
        <source>Derived signal…</source>
        <translation>派生信号…</translation>
    </message>
    <message>
        <source>A formula over signals: derivative, moving average, difference …</source>
        <translation>信号の数式: 微分、移動平均、差 …</translation>
    </message>
    <message>
        <source>derived</source>
        <translation>派生</translation>
    </message>
    <message>
        <source>%1
right click removes the signal</source>
        <translation>%1
右クリックで信号を削除します</translation>
    </message>
    <message>
        <source>%1
double click plots it, drag it to a pane or below them</source>
        <translation>%1
ダブルクリックでプロットします。プロット枠またはその下へドラッグもできます</translation>
    </message>
    <message>
        <source>Remove this derived signal</source>
        <translation>この派生信号を削除</translation>
    </message>
</context>
<context>
    <name>mb::SlotPanel</name>
    <message>
        <source>Gain slot, edit and run</source>
        <translation>ゲインスロット、編集と実行</translation>
    </message>
    <message>
        <source>The slot that is edited and that runs. Changing it disarms.</source>
        <translation>編集し、実行するスロット。変更すると駆動許可が解除されます。</translation>
    </message>
    <message>
        <source>Split</source>
        <translation>分離</translation>
    </message>
    <message>
        <source>Edit one slot while another runs</source>
        <translation>あるスロットを実行しながら別のスロットを編集</translation>
    </message>
    <message>
        <source>Slot</source>
        <translation>スロット</translation>
    </message>
    <message>
        <source>edit and run</source>
        <translation>編集と実行</translation>
    </message>
    <message>
        <source>Gain slot that is edited</source>
        <translation>編集するゲインスロット</translation>
    </message>
    <message>
        <source>Gain slot that runs</source>
        <translation>実行するゲインスロット</translation>
    </message>
    <message>
        <source>The slot of the next run. Changing it disarms.</source>
        <translation>次の実行に使うスロット。変更すると駆動許可が解除されます。</translation>
    </message>
    <message>
        <source>Editing slot</source>
        <translation>編集スロット</translation>
    </message>
    <message>
        <source>running</source>
        <translation>実行中</translation>
    </message>
    <message>
        <source>Join</source>
        <translation>統合</translation>
    </message>
    <message>
        <source>Edit the slot that runs</source>
        <translation>実行するスロットを編集</translation>
    </message>
    <message>
        <source>Split: both are slot %1 now.</source>
        <translation>分離: 現在はどちらもスロット %1 です。</translation>
    </message>
    <message>
        <source>Split: edits go to slot %1, slot %2 runs.</source>
        <translation>分離: 編集はスロット %1、実行はスロット %2 です。</translation>
    </message>
</context>
<context>
    <name>mb::SpectrumView</name>
    <message>
        <source>Spectrum</source>
        <translation>スペクトル</translation>
    </message>
    <message>
        <source>frequency, Hz</source>
        <translation>周波数、Hz</translation>
    </message>
    <message>
        <source>amplitude</source>
        <translation>振幅</translation>
    </message>
    <message>
        <source>amplitude, %1</source>
        <translation>振幅、%1</translation>
    </message>
    <message>
        <source>A … B</source>
        <translation>A … B</translation>
    </message>
    <message>
        <source>what is seen</source>
        <translation>表示範囲</translation>
    </message>
    <message>
        <source>, Hann window, peak values. </source>
        <translation>、Hann 窓、ピーク値。 </translation>
    </message>
</context>
<context>
    <name>mb::SpokenNames</name>
    <message>
        <source>Places</source>
        <translation>場所</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>フォルダー</translation>
    </message>
    <message>
        <source>Kind of file</source>
        <translation>ファイルの種類</translation>
    </message>
</context>
<context>
    <name>mb::StagedEdits</name>
    <message>
        <source>Discard</source>
        <translation>破棄</translation>
    </message>
</context>
<context>
    <name>mb::StartPage</name>
    <message>
        <source>Start</source>
        <translation>開始</translation>
    </message>
    <message>
        <source>Add link</source>
        <translation>リンクを追加</translation>
    </message>
    <message>
        <source>Open recording…</source>
        <translation>記録を開く…</translation>
    </message>
    <message>
        <source>Try with a simulated motor</source>
        <translation>シミュレーションモーターで試す</translation>
    </message>
    <message>
        <source>Open the simulated bench</source>
        <translation>シミュレーションベンチを開く</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>続ける</translation>
    </message>
    <message>
        <source>Firmware on this computer</source>
        <translation>このコンピューター上のファームウェア</translation>
    </message>
    <message>
        <source>Folder…</source>
        <translation>フォルダ…</translation>
    </message>
    <message>
        <source>Choose the folder whose images are listed here</source>
        <translation>ここに一覧表示するイメージのフォルダを選択</translation>
    </message>
    <message>
        <source>First time here?</source>
        <translation>初めてお使いですか?</translation>
    </message>
    <message>
        <source>STOP works on key press, everywhere, also while you type (use Esc then). It is software: keep a hardware stop in the supply.</source>
        <translation>STOP はどこでもキーを押した瞬間に働きます (文字入力中は Esc)。ただしソフトウェアによる停止です: 電源系には必ずハードウェアの停止手段を設けてください。</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>キー</translation>
    </message>
    <message>
        <source>Wiring guides</source>
        <translation>配線ガイド</translation>
    </message>
    <message>
        <source>Sessions and recordings that you have opened stand here.</source>
        <translation>これまでに開いたセッションと記録がここに表示されます。</translation>
    </message>
    <message>
        <source>No image (.hex) in this folder.</source>
        <translation>このフォルダにイメージ (.hex) はありません。</translation>
    </message>
    <message>
        <source>Controllers of every family with real bus timing; nothing real can move.</source>
        <translation>実際のバスタイミングで動くすべてのファミリのコントローラ。実物は動きません。</translation>
    </message>
</context>
<context>
    <name>mb::StateGlyph</name>
    <message>
        <source>online</source>
        <translation>オンライン</translation>
    </message>
    <message>
        <source>moving</source>
        <translation>動作中</translation>
    </message>
    <message>
        <source>in bootloader</source>
        <translation>ブートローダ中</translation>
    </message>
    <message>
        <source>2 ×</source>
        <translation>2 ×</translation>
    </message>
    <message>
        <source>number 0</source>
        <translation>番号 0</translation>
    </message>
    <message>
        <source>fault</source>
        <translation>フォルト</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>応答なし</translation>
    </message>
    <message>
        <source>stored</source>
        <translation>保存済み</translation>
    </message>
    <message>
        <source>RAM, not in flash</source>
        <translation>RAM、フラッシュ未保存</translation>
    </message>
    <message>
        <source>edited</source>
        <translation>編集済み</translation>
    </message>
    <message>
        <source>out of range</source>
        <translation>範囲外</translation>
    </message>
    <message>
        <source>assumed</source>
        <translation>推定</translation>
    </message>
    <message>
        <source>volatile</source>
        <translation>揮発性</translation>
    </message>
    <message>
        <source>busy</source>
        <translation>ビジー</translation>
    </message>
    <message>
        <source>done</source>
        <translation>完了</translation>
    </message>
    <message>
        <source>waiting</source>
        <translation>待機中</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>recording</source>
        <translation>記録中</translation>
    </message>
</context>
<context>
    <name>mb::StationDialog</name>
    <message>
        <source>Journal of this station</source>
        <translation>このステーションのジャーナル</translation>
    </message>
    <message>
        <source>Name of this station</source>
        <translation>このステーションの名前</translation>
    </message>
    <message>
        <source>Server that stations share</source>
        <translation>ステーションが共有するサーバー</translation>
    </message>
    <message>
        <source>Without a server the journal is in the file of this computer alone. With one, every entry is there first and delivered as soon as the server answers; numbers come in blocks of five.</source>
        <translation>サーバーがなければ、ジャーナルはこのコンピューターのファイルだけにあります。あれば、各項目はまずそこに書かれ、サーバーが応答し次第渡されます。番号は 5 個ずつ割り当てられます。</translation>
    </message>
</context>
<context>
    <name>mb::StationLamp</name>
    <message>
        <source>%1 self-test</source>
        <translation>%1 セルフテスト</translation>
    </message>
    <message>
        <source>turns in a moment</source>
        <translation>まもなく回転</translation>
    </message>
    <message>
        <source>self-tests</source>
        <translation>セルフテスト</translation>
    </message>
    <message>
        <source>nothing turns here</source>
        <translation>ここでは何も回りません</translation>
    </message>
    <message>
        <source>Arm button</source>
        <translation>駆動許可ボタン</translation>
    </message>
</context>
<context>
    <name>mb::StatusBar</name>
    <message>
        <source>samples %1   lost %2   memory %3</source>
        <translation>サンプル %1   欠落 %2   メモリ %3</translation>
    </message>
</context>
<context>
    <name>mb::StepText</name>
    <message>
        <source>%1, predicted</source>
        <translation>%1、予測</translation>
    </message>
    <message>
        <source>measured, forwards</source>
        <translation>実測、正方向</translation>
    </message>
    <message>
        <source>measured, backwards</source>
        <translation>実測、逆方向</translation>
    </message>
    <message>
        <source>measured: %1 % over, settled after %2</source>
        <translation>実測: オーバーシュート %1 %、整定 %2</translation>
    </message>
    <message>
        <source>%1 % over</source>
        <translation>OS %1 %</translation>
    </message>
    <message>
        <source>%1 A peak</source>
        <translation>ピーク %1 A</translation>
    </message>
    <message>
        <source>±2 %</source>
        <translation>±2 %</translation>
    </message>
    <message>
        <source>%1 settles %2</source>
        <translation>%1: 整定 %2</translation>
    </message>
    <message>
        <source>%1 does not settle</source>
        <translation>%1: 整定しません</translation>
    </message>
    <message>
        <source>measured: peak %1, %2 % over</source>
        <translation>実測: ピーク %1、OS %2 %</translation>
    </message>
    <message>
        <source>measured: settles %1</source>
        <translation>実測: 整定 %1</translation>
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
        <translation>%1 %2 のステップ</translation>
    </message>
    <message>
        <source>band: ± of the model</source>
        <translation>帯: モデルの ±</translation>
    </message>
</context>
<context>
    <name>mb::StepsPanel</name>
    <message>
        <source>Steps of the update</source>
        <translation>更新の手順</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>手順</translation>
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
        <translation>整定するまで移動し、戻る</translation>
    </message>
    <message>
        <source>to and fro, 0.5 Hz</source>
        <translation>往復、0.5 Hz</translation>
    </message>
    <message>
        <source>evenly there and back</source>
        <translation>一定の速さで往復</translation>
    </message>
    <message>
        <source>1 Hz, six swings</source>
        <translation>1 Hz、6 周期</translation>
    </message>
    <message>
        <source>0.1 to 15 Hz in 30 s</source>
        <translation>0.1 ～ 15 Hz、30 s</translation>
    </message>
    <message>
        <source>random bits of 125 ms</source>
        <translation>125 ms のランダムビット</translation>
    </message>
    <message>
        <source>Stimulus</source>
        <translation>励振</translation>
    </message>
    <message>
        <source>From</source>
        <translation>開始値</translation>
    </message>
    <message>
        <source>Where the experiment begins and ends; empty: where the motor is, or 0</source>
        <translation>実験の開始および終了の値。空欄: モーターの現在値または 0</translation>
    </message>
    <message>
        <source>To</source>
        <translation>到達値</translation>
    </message>
    <message>
        <source>Where the loop is asked to go</source>
        <translation>制御ループに指令する到達値</translation>
    </message>
    <message>
        <source>hold</source>
        <translation>保持</translation>
    </message>
    <message>
        <source>Time of the stimulus</source>
        <translation>励振の時間</translation>
    </message>
    <message>
        <source>Seconds; empty: the usual, and a step ends once it has settled</source>
        <translation>秒。空欄: 標準値、ステップは整定すると終了</translation>
    </message>
    <message>
        <source>settled</source>
        <translation>整定まで</translation>
    </message>
    <message>
        <source>usual</source>
        <translation>標準</translation>
    </message>
    <message>
        <source>Repeats</source>
        <translation>繰り返し</translation>
    </message>
    <message>
        <source>Each repeat starts a little later between two samples: together they show what is finer than the telemetry</source>
        <translation>繰返しごとに、2 つのサンプルの間で少しずつ遅らせて開始します: 合わせるとテレメトリより細かい変化が見えます</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>here</source>
        <translation>現在値</translation>
    </message>
    <message>
        <source>rise</source>
        <translation>立上り</translation>
    </message>
    <message>
        <source>time</source>
        <translation>時間</translation>
    </message>
    <message>
        <source>Enter where the loop is to go.</source>
        <translation>制御ループの行き先を入力してください。</translation>
    </message>
    <message>
        <source>%1 is no number.</source>
        <translation>%1 は数値ではありません。</translation>
    </message>
    <message>
        <source>The time is 0.001 to %1 s.</source>
        <translation>時間は 0.001 ～ %1 s です。</translation>
    </message>
</context>
<context>
    <name>mb::StopButton</name>
    <message>
        <source>Space · Esc</source>
        <translation>Space · Esc</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>STOP</translation>
    </message>
    <message>
        <source>Stop every motor</source>
        <translation>全モーターを停止</translation>
    </message>
    <message>
        <source>Stop every motor  Space, Esc, Pause</source>
        <translation>全モーターを停止  Space、Esc、Pause</translation>
    </message>
</context>
<context>
    <name>mb::StoryCard</name>
    <message numerus="yes">
        <source>about %n min</source>
        <translation>
            <numerusform>約 %n min</numerusform>
        </translation>
    </message>
    <message>
        <source>Try it</source>
        <translation>試す</translation>
    </message>
    <message>
        <source>Try it: %1</source>
        <translation>試す: %1</translation>
    </message>
</context>
<context>
    <name>mb::SweepPanel</name>
    <message>
        <source>%1 sines from %2 to %3 Hz, both ways in turn: duty %4 ± %5 %, at most %6 counts/s, %7 counts one way, %8.</source>
        <translation>%2 ～ %3 Hz の正弦波 %1 種を両方向交互に: デューティ %4 ± %5 %、最大 %6 counts/s、片方向 %7 counts、%8。</translation>
    </message>
    <message>
        <source>Frequency response</source>
        <translation>周波数応答</translation>
    </message>
    <message>
        <source>Measures the motor by sines and draws it over its model, as far as it may be trusted</source>
        <translation>正弦波でモーターを測定し、信頼できる範囲でモデルに重ねて描きます</translation>
    </message>
</context>
<context>
    <name>mb::TimelineList</name>
    <message>
        <source>window</source>
        <translation>ウィンドウ</translation>
    </message>
    <message>
        <source>console</source>
        <translation>コンソール</translation>
    </message>
    <message>
        <source>autotune</source>
        <translation>オートチューニング</translation>
    </message>
    <message>
        <source>recipe</source>
        <translation>レシピ</translation>
    </message>
    <message>
        <source>elsewhere</source>
        <translation>その他</translation>
    </message>
    <message>
        <source>States of this unit</source>
        <translation>この機器の状態</translation>
    </message>
    <message>
        <source>Today, %1</source>
        <translation>今日、%1</translation>
    </message>
    <message>
        <source>like A</source>
        <translation>A と同じ</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1、%2</translation>
    </message>
    <message>
        <source>undone: %1</source>
        <translation>元に戻し: %1</translation>
    </message>
    <message>
        <source>done again: %1</source>
        <translation>やり直し: %1</translation>
    </message>
    <message numerus="yes">
        <source>%n differ</source>
        <translation>
            <numerusform>%n 件異なる</numerusform>
        </translation>
    </message>
    <message>
        <source>Always there</source>
        <translation>常時利用可能</translation>
    </message>
    <message>
        <source>This place, not this unit</source>
        <translation>この機器ではなく、この場所</translation>
    </message>
    <message>
        <source>reverted: %1</source>
        <translation>復元: %1</translation>
    </message>
</context>
<context>
    <name>mb::TourStage</name>
    <message>
        <source>tour</source>
        <translation>ツアー</translation>
    </message>
</context>
<context>
    <name>mb::TraceList</name>
    <message>
        <source>Remove the trace</source>
        <translation>波形を削除</translation>
    </message>
    <message>
        <source>Pane, axis, trigger, reference …</source>
        <translation>プロット枠、軸、トリガ、基準波形 …</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>%1 を削除</translation>
    </message>
    <message>
        <source>Traces</source>
        <translation>波形</translation>
    </message>
</context>
<context>
    <name>mb::TracePanel</name>
    <message>
        <source>Traces</source>
        <translation>波形</translation>
    </message>
    <message>
        <source>rate      lost</source>
        <translation>周波数   欠落</translation>
    </message>
    <message>
        <source>mean %1 · σ %2 · %3 … %4 · %5 samples</source>
        <translation>平均 %1 · σ %2 · %3 … %4 · %5 サンプル</translation>
    </message>
    <message>
        <source> · %1 lost</source>
        <translation> · 欠落 %1</translation>
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
        <translation>欠落 %1</translation>
    </message>
    <message>
        <source>A %1   B %2</source>
        <translation>A %1   B %2</translation>
    </message>
    <message>
        <source>In a pane of its own</source>
        <translation>独立したプロット枠へ</translation>
    </message>
    <message>
        <source>Into the pane above</source>
        <translation>上のプロット枠へ</translation>
    </message>
    <message>
        <source>With its unit</source>
        <translation>同じ単位へ</translation>
    </message>
    <message>
        <source>Scale at the right</source>
        <translation>右側に目盛</translation>
    </message>
    <message>
        <source>Trigger on it	T</source>
        <translation>この信号でトリガ	T</translation>
    </message>
    <message>
        <source>Keep all as references</source>
        <translation>すべて基準波形として保持</translation>
    </message>
    <message>
        <source>Remove references</source>
        <translation>基準波形を削除</translation>
    </message>
    <message>
        <source>Spectrum</source>
        <translation>スペクトル</translation>
    </message>
    <message>
        <source>Remove the trace</source>
        <translation>波形を削除</translation>
    </message>
    <message>
        <source>%1 cursors · %2 fits · + − zooms · %3 pauses · N note</source>
        <translation>%1 カーソル · %2 全体表示 · + − 拡大縮小 · %3 一時停止 · N メモ</translation>
    </message>
    <message>
        <source>%1, of another time</source>
        <translation>%1、別の時刻</translation>
    </message>
</context>
<context>
    <name>mb::TrafficView</name>
    <message>
        <source>Columns of %1</source>
        <translation>%1 の列</translation>
    </message>
</context>
<context>
    <name>mb::TrialList</name>
    <message>
        <source>Which trials</source>
        <translation>表示する試行</translation>
    </message>
    <message>
        <source>All</source>
        <translation>すべて</translation>
    </message>
    <message>
        <source>Starred</source>
        <translation>スター付き</translation>
    </message>
    <message>
        <source>Clean</source>
        <translation>正常</translation>
    </message>
    <message>
        <source>Back to best</source>
        <translation>最良に戻す</translation>
    </message>
    <message>
        <source>Stages the gains of the quickest clean trial with no more than 5 % overshoot; runs nothing.</source>
        <translation>オーバーシュート 5 % 以下の正常な試行のうち最速のゲインを書込み待ちにします。何も実行しません。</translation>
    </message>
    <message>
        <source>Export the trials as CSV or JSON</source>
        <translation>試行を CSV または JSON でエクスポート</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>試行</translation>
    </message>
    <message>
        <source>Trials of this loop</source>
        <translation>この制御ループの試行</translation>
    </message>
    <message>
        <source>Every experiment appears here with its gains and what became of it.</source>
        <translation>すべての実験が、ゲインと結果とともにここに表示されます。</translation>
    </message>
    <message>
        <source>stopped: speed</source>
        <translation>停止: 速度</translation>
    </message>
    <message numerus="yes">
        <source>%n, every run is kept</source>
        <translation>
            <numerusform>%n 件、すべて保存済み</numerusform>
        </translation>
    </message>
    <message>
        <source>All %1</source>
        <translation>すべて %1</translation>
    </message>
    <message>
        <source>Starred %1</source>
        <translation>スター付き %1</translation>
    </message>
    <message>
        <source>Clean %1</source>
        <translation>正常 %1</translation>
    </message>
    <message>
        <source>Back to best #%1</source>
        <translation>最良 #%1 に戻す</translation>
    </message>
    <message>
        <source>Show as B</source>
        <translation>B として表示</translation>
    </message>
    <message>
        <source>Pin as A  A</source>
        <translation>A として固定  A</translation>
    </message>
    <message>
        <source>Use these gains</source>
        <translation>このゲインを使用</translation>
    </message>
    <message>
        <source>Take the star away</source>
        <translation>スターを外す</translation>
    </message>
    <message>
        <source>Give it a star</source>
        <translation>スターを付ける</translation>
    </message>
    <message>
        <source>Edit the note</source>
        <translation>メモを編集</translation>
    </message>
    <message>
        <source>Forget this trial</source>
        <translation>この試行を消去</translation>
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
        <translation>スターを外す</translation>
    </message>
    <message>
        <source>Give it a star</source>
        <translation>スターを付ける</translation>
    </message>
    <message>
        <source>Stages the gains of this trial; nothing is written yet.</source>
        <translation>この試行のゲインを書込み待ちにします。まだ書き込みません。</translation>
    </message>
    <message>
        <source>starred</source>
        <translation>スター付き</translation>
    </message>
    <message>
        <source>no star</source>
        <translation>スターなし</translation>
    </message>
    <message>
        <source>Use the gains of trial #%1</source>
        <translation>試行 #%1 のゲインを使用</translation>
    </message>
    <message>
        <source>trial</source>
        <translation>試行</translation>
    </message>
    <message>
        <source>time</source>
        <translation>時刻</translation>
    </message>
    <message>
        <source>stimulus</source>
        <translation>励振</translation>
    </message>
    <message>
        <source>over %</source>
        <translation>OS %</translation>
    </message>
    <message>
        <source>settle</source>
        <translation>整定</translation>
    </message>
    <message>
        <source>rise</source>
        <translation>立上り</translation>
    </message>
    <message>
        <source>peak A</source>
        <translation>ピーク A</translation>
    </message>
    <message>
        <source>flags</source>
        <translation>フラグ</translation>
    </message>
    <message>
        <source>note</source>
        <translation>メモ</translation>
    </message>
</context>
<context>
    <name>mb::TrialOrders</name>
    <message>
        <source>the notebook: %1</source>
        <translation>ノート: %1</translation>
    </message>
    <message>
        <source>Export trials</source>
        <translation>試行のエクスポート</translation>
    </message>
    <message>
        <source>Table (*.csv);;JSON (*.json)</source>
        <translation>表 (*.csv);;JSON (*.json)</translation>
    </message>
    <message>
        <source>trials written to %1</source>
        <translation>試行を %1 に書き出しました</translation>
    </message>
</context>
<context>
    <name>mb::TrialWords</name>
    <message>
        <source>better</source>
        <translation>改善</translation>
    </message>
    <message>
        <source>worse</source>
        <translation>悪化</translation>
    </message>
    <message>
        <source>faster</source>
        <translation>速い</translation>
    </message>
    <message>
        <source>slower</source>
        <translation>遅い</translation>
    </message>
    <message>
        <source>Rise 10–90</source>
        <translation>立上り 10–90</translation>
    </message>
    <message>
        <source>Settle 2 %</source>
        <translation>整定 2 %</translation>
    </message>
    <message>
        <source>Overshoot</source>
        <translation>オーバーシュート</translation>
    </message>
    <message>
        <source>Undershoot</source>
        <translation>アンダーシュート</translation>
    </message>
    <message>
        <source>Steady error</source>
        <translation>定常偏差</translation>
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
        <translation>ピーク電流</translation>
    </message>
    <message>
        <source>Duty chatter</source>
        <translation>デューティ変動</translation>
    </message>
    <message>
        <source>Saturated</source>
        <translation>飽和</translation>
    </message>
    <message>
        <source>Noise σ</source>
        <translation>ノイズ σ</translation>
    </message>
    <message>
        <source>Step and back</source>
        <translation>往復ステップ</translation>
    </message>
    <message>
        <source>Square</source>
        <translation>方形波</translation>
    </message>
    <message>
        <source>Ramp</source>
        <translation>ランプ</translation>
    </message>
    <message>
        <source>Sine</source>
        <translation>正弦波</translation>
    </message>
    <message>
        <source>Chirp</source>
        <translation>チャープ</translation>
    </message>
    <message>
        <source>PRBS</source>
        <translation>PRBS</translation>
    </message>
    <message>
        <source>stopped: %1</source>
        <translation>停止: %1</translation>
    </message>
    <message>
        <source>nobody saw its end</source>
        <translation>終了を確認できず</translation>
    </message>
    <message>
        <source>%1 samples lost</source>
        <translation>サンプル欠落 %1</translation>
    </message>
    <message>
        <source>saturated %1 %</source>
        <translation>飽和 %1 %</translation>
    </message>
</context>
<context>
    <name>mb::TrialsHead</name>
    <message>
        <source>Flip A and B</source>
        <translation>A と B を入替え</translation>
    </message>
    <message>
        <source>Pin B as A</source>
        <translation>B を A として固定</translation>
    </message>
    <message>
        <source>Cursors A and B</source>
        <translation>カーソル A と B</translation>
    </message>
    <message>
        <source>Fit time and value</source>
        <translation>時間と値を全体表示</translation>
    </message>
    <message>
        <source>A #%1 is another stimulus, it is not drawn</source>
        <translation>A #%1 は励振が異なるため描画しません</translation>
    </message>
    <message>
        <source>Shift+click on a trial pins it as A</source>
        <translation>試行を Shift+クリックすると A として固定します</translation>
    </message>
    <message>
        <source>No trial yet. Run makes the first.</source>
        <translation>試行はまだありません。「実行」で最初の試行を行います。</translation>
    </message>
</context>
<context>
    <name>mb::TrialsView</name>
    <message>
        <source>Below the plot</source>
        <translation>プロットの下</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>試行</translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation>指標</translation>
    </message>
    <message>
        <source>not kept: %1</source>
        <translation>未保存: %1</translation>
    </message>
</context>
<context>
    <name>mb::TriggerBar</name>
    <message>
        <source>Trigger off</source>
        <translation>トリガオフ</translation>
    </message>
    <message>
        <source>Arm again: forgets this event, waits for the next</source>
        <translation>トリガ再待機: このイベントを消去して次を待ちます</translation>
    </message>
    <message>
        <source>Trace that triggers</source>
        <translation>トリガする波形</translation>
    </message>
    <message>
        <source>↑ rises through</source>
        <translation>↑ 上昇して通過</translation>
    </message>
    <message>
        <source>↓ falls through</source>
        <translation>↓ 下降して通過</translation>
    </message>
    <message>
        <source>↕ crosses</source>
        <translation>↕ 通過</translation>
    </message>
    <message>
        <source>is above</source>
        <translation>上回る</translation>
    </message>
    <message>
        <source>is below</source>
        <translation>下回る</translation>
    </message>
    <message>
        <source>Edge or level</source>
        <translation>エッジまたはレベル</translation>
    </message>
    <message>
        <source>%1 % before</source>
        <translation>%1 % 前</translation>
    </message>
    <message>
        <source>Part of the window before the event</source>
        <translation>イベント前の表示割合</translation>
    </message>
    <message>
        <source>What follows an event</source>
        <translation>イベント後の動作</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>ノーマル</translation>
    </message>
    <message>
        <source>Single</source>
        <translation>シングル</translation>
    </message>
    <message>
        <source>Normal shows every event, single stops at the first</source>
        <translation>ノーマルは全イベントを表示し、シングルは最初のイベントで停止します</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>レベル</translation>
    </message>
    <message>
        <source>The level; the handle ▸ at the left of the plot drags it, too</source>
        <translation>レベル。プロット左のつまみ ▸ のドラッグでも変更できます</translation>
    </message>
    <message>
        <source>trigger %1 %2 %3, %4 before</source>
        <translation>トリガ %1 %2 %3、%4 前</translation>
    </message>
</context>
<context>
    <name>mb::TuneAxes</name>
    <message>
        <source>%1 %2, at rest</source>
        <comment>mode and target</comment>
        <translation>%1 %2、静止中</translation>
    </message>
    <message>
        <source>axis %1 moves in another mode; stop it first</source>
        <translation>軸 %1 は別のモードで動作中です。先に停止してください</translation>
    </message>
</context>
<context>
    <name>mb::TuneColumn</name>
    <message>
        <source>The power limit of axis %1 is unknown: its first motion sets it to %2. Write another under Limits of the axis.</source>
        <translation>軸 %1 の出力制限が不明です: 最初の動作で %2 に設定されます。変更する場合は「軸の制限」で書き込んでください。</translation>
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
        <translation>動作を停止</translation>
    </message>
    <message>
        <source>Ends the motion and stays armed. STOP, Esc and Pause stop everything.</source>
        <translation>動作を終了し、駆動許可は維持します。STOP、Esc、Pause はすべてを停止します。</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>実行</translation>
    </message>
    <message>
        <source>Write and run</source>
        <translation>書込みと実行</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>適用</translation>
    </message>
    <message>
        <source>Run %1 axes</source>
        <translation>%1 軸を実行</translation>
    </message>
    <message>
        <source>View</source>
        <translation>表示</translation>
    </message>
    <message>
        <source>Experiment</source>
        <translation>実験</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>ライブ</translation>
    </message>
    <message>
        <source>Stop axis %1</source>
        <translation>軸 %1 を停止</translation>
    </message>
</context>
<context>
    <name>mb::TuneExperiments</name>
    <message>
        <source>Experiment</source>
        <translation>実験</translation>
    </message>
    <message>
        <source>Moving</source>
        <translation>動作中</translation>
    </message>
    <message>
        <source>Stop the motion before an experiment.</source>
        <translation>実験の前に動作を停止してください。</translation>
    </message>
    <message>
        <source>The stimulus cannot be sent</source>
        <translation>励振を送信できません</translation>
    </message>
    <message>
        <source>No experiment yet</source>
        <translation>まだ実験できません</translation>
    </message>
    <message>
        <source>No experiment in this mode</source>
        <translation>このモードでは実験できません</translation>
    </message>
    <message>
        <source>Armed</source>
        <translation>駆動許可中</translation>
    </message>
    <message>
        <source>Not armed</source>
        <translation>駆動未許可</translation>
    </message>
    <message>
        <source>Hold the Arm button for 1 s to arm %1.</source>
        <translation>%1 を駆動許可するには、駆動許可ボタンを 1 s 押し続けてください。</translation>
    </message>
    <message>
        <source>The position of axis %1 is not known yet</source>
        <translation>軸 %1 の位置がまだ分かりません</translation>
    </message>
    <message>
        <source>no device</source>
        <translation>機器がありません</translation>
    </message>
    <message>
        <source>its position is not known yet</source>
        <translation>位置がまだ分かりません</translation>
    </message>
    <message>
        <source>Run begins the experiment.</source>
        <translation>「実行」で実験を開始します。</translation>
    </message>
</context>
<context>
    <name>mb::TuneForm</name>
    <message>
        <source>the running slot</source>
        <translation>実行スロット</translation>
    </message>
    <message>
        <source>a direction or a limit</source>
        <translation>方向またはリミット</translation>
    </message>
    <message>
        <source>the mode</source>
        <translation>モード</translation>
    </message>
</context>
<context>
    <name>mb::TuneFrame</name>
    <message>
        <source>Part of the page</source>
        <translation>ページの部分</translation>
    </message>
    <message>
        <source>Set-up</source>
        <translation>設定</translation>
    </message>
    <message>
        <source>Plot</source>
        <translation>プロット</translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation>指標</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>試行</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>ライブ</translation>
    </message>
</context>
<context>
    <name>mb::TuneGains</name>
    <message>
        <source>A gain is out of range</source>
        <translation>ゲインが範囲外です</translation>
    </message>
    <message>
        <source>Correct or revert it first.</source>
        <translation>先に修正するか、元に戻してください。</translation>
    </message>
    <message>
        <source>Look at a gain again</source>
        <translation>ゲインを再確認</translation>
    </message>
    <message>
        <source>Writing gains</source>
        <translation>ゲインを書込み中</translation>
    </message>
    <message>
        <source>Reading gains</source>
        <translation>ゲインを読出し中</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1/%2</translation>
    </message>
    <message>
        <source>gains not written: %1</source>
        <translation>ゲインを書き込んでいません: %1</translation>
    </message>
    <message>
        <source>Gains of trial #%1</source>
        <translation>試行 #%1 のゲイン</translation>
    </message>
    <message>
        <source>What the adviser proposes</source>
        <translation>アドバイザの提案</translation>
    </message>
    <message>
        <source>nothing copied: no gain of axis %1 is known for this mode; write it first</source>
        <translation>コピーしていません: このモードでは軸 %1 のゲインが不明です。先に書き込んでください</translation>
    </message>
    <message>
        <source>Gains and limits of axis %1</source>
        <translation>軸 %1 のゲインと制限</translation>
    </message>
</context>
<context>
    <name>mb::TuneKeys</name>
    <message>
        <source>writes what is staged and runs</source>
        <translation>書込み待ちの変更を書き込んで実行します</translation>
    </message>
    <message>
        <source>the same, four times over</source>
        <translation>同じ動作を 4 回繰り返します</translation>
    </message>
    <message>
        <source>a battery of steps: several sizes, both ways, and the worst of them</source>
        <translation>連続ステップ試験: 複数の大きさを両方向に行い、最悪値を求めます</translation>
    </message>
    <message>
        <source>goes to the first gain</source>
        <translation>最初のゲインへ移動します</translation>
    </message>
    <message>
        <source>swaps the gain slots; disarms</source>
        <translation>ゲインスロットを入れ替えます。駆動許可は解除されます</translation>
    </message>
    <message>
        <source>flips trials A and B</source>
        <translation>試行 A と B を入れ替えます</translation>
    </message>
    <message>
        <source>pins trial B as A</source>
        <translation>試行 B を A として固定します</translation>
    </message>
    <message>
        <source>cursors in the plot: arrows move one, C changes to the other</source>
        <translation>プロット内のカーソル: 矢印キーで一方を移動、C で他方に切替え</translation>
    </message>
    <message>
        <source>fits time and value of the plot</source>
        <translation>プロットの時間と値を全体表示します</translation>
    </message>
    <message>
        <source>pauses the live view, and goes on</source>
        <translation>ライブ表示を一時停止、再開します</translation>
    </message>
    <message>
        <source>identifies the device: it blinks</source>
        <translation>機器を識別します: 点滅します</translation>
    </message>
    <message>
        <source>undoes the last edit of gains, or else the last write to the unit</source>
        <translation>ゲインの直前の編集、なければ機器への直前の書込みを元に戻します</translation>
    </message>
    <message>
        <source>writes a report of the trials that are shown</source>
        <translation>表示中の試行のレポートを書き出します</translation>
    </message>
    <message>
        <source>held: moves the armed motor gently forwards or backwards</source>
        <translation>長押し: 駆動許可中のモーターを正方向または逆方向にゆっくり動かします</translation>
    </message>
    <message>
        <source>on a gain&apos;s slider: 2 %, with Shift 0.2 %, with Ctrl 20 %; the wheel does the same by 2 %</source>
        <translation>ゲインのスライダ上: 2 %、Shift 併用で 0.2 %、Ctrl 併用で 20 %。ホイールでも 2 % 変わります</translation>
    </message>
    <message>
        <source>redoes the last edit or write</source>
        <translation>直前の編集または書込みをやり直します</translation>
    </message>
</context>
<context>
    <name>mb::TuneMotion</name>
    <message>
        <source>position 0 is here; the motor is off until Run</source>
        <translation>現在位置を 0 としました。「実行」までモーターはオフです</translation>
    </message>
    <message>
        <source>it has no lamp that could blink</source>
        <translation>点滅できるランプがありません</translation>
    </message>
    <message>
        <source>not identified: %1</source>
        <translation>識別できません: %1</translation>
    </message>
    <message>
        <source>disarmed: %1 changed</source>
        <translation>駆動許可を解除しました: %1 が変更されました</translation>
    </message>
    <message>
        <source>Moving</source>
        <translation>動作中</translation>
    </message>
    <message>
        <source>Armed</source>
        <translation>駆動許可中</translation>
    </message>
    <message>
        <source>Not armed</source>
        <translation>駆動未許可</translation>
    </message>
    <message>
        <source>Hold the Arm button for 1 s to arm %1.</source>
        <translation>%1 を駆動許可するには、駆動許可ボタンを 1 s 押し続けてください。</translation>
    </message>
    <message>
        <source>axis %1: %2</source>
        <translation>軸 %1: %2</translation>
    </message>
    <message>
        <source>%1, slot %2</source>
        <translation>%1、スロット %2</translation>
    </message>
    <message>
        <source> · also moving: axis %1</source>
        <translation> · 軸 %1 も動作中</translation>
    </message>
    <message>
        <source>Its position is not known yet</source>
        <translation>位置がまだ分かりません</translation>
    </message>
    <message>
        <source>It starts where it is once it has told where that is.</source>
        <translation>現在の位置が伝えられると、そこから始まります。</translation>
    </message>
    <message>
        <source>%1: holds</source>
        <translation>%1: 保持</translation>
    </message>
    <message>
        <source>%1 by %2</source>
        <translation>%1 を %2 だけ</translation>
    </message>
    <message>
        <source>Run begins %1</source>
        <translation>「実行」で %1 を開始</translation>
    </message>
</context>
<context>
    <name>mb::TunePage</name>
    <message>
        <source>disarmed: another device is selected</source>
        <translation>駆動許可を解除しました: 別の機器が選択されました</translation>
    </message>
    <message>
        <source>%1 is in its bootloader</source>
        <translation>%1 はブートローダで動作しています</translation>
    </message>
    <message>
        <source>It cannot drive a motor until it has firmware. Write an image on the Firmware page.</source>
        <translation>ファームウェアがないとモーターを駆動できません。「ファームウェア」ページでイメージを書き込んでください。</translation>
    </message>
    <message>
        <source>Select a device</source>
        <translation>機器を選択</translation>
    </message>
    <message>
        <source>No device yet</source>
        <translation>機器はまだありません</translation>
    </message>
    <message>
        <source>Choose one in the list at the left; its loop is tuned here.</source>
        <translation>左のリストで機器を選択してください。その制御ループをここで調整します。</translation>
    </message>
    <message>
        <source>Open a link, or the simulated bench from the menu, to drive a motor.</source>
        <translation>モーターを駆動するには、リンク、またはメニューからシミュレーションベンチを開いてください。</translation>
    </message>
    <message>
        <source>No device</source>
        <translation>機器なし</translation>
    </message>
    <message>
        <source>No answer from %1</source>
        <translation>%1 から応答がありません</translation>
    </message>
    <message>
        <source>The plot keeps what it has.</source>
        <translation>プロットの内容は保持されます。</translation>
    </message>
    <message>
        <source>Stopped: %1</source>
        <translation>停止: %1</translation>
    </message>
    <message>
        <source>Hold the Arm button for 1 s to arm again.</source>
        <translation>再び駆動許可するには、駆動許可ボタンを 1 s 押し続けてください。</translation>
    </message>
    <message>
        <source>%1 cannot be armed</source>
        <translation>%1 は駆動許可できません</translation>
    </message>
    <message>
        <source>The set-point cannot be sent</source>
        <translation>目標値を送信できません</translation>
    </message>
    <message>
        <source>Something moves</source>
        <translation>動作中のものがあります</translation>
    </message>
    <message>
        <source>Hold the Arm button for 1 s to arm it first.</source>
        <translation>先に駆動許可ボタンを 1 s 押し続けて駆動許可してください。</translation>
    </message>
    <message>
        <source>not run: %1. %2</source>
        <translation>実行していません: %1。%2</translation>
    </message>
</context>
<context>
    <name>mb::TunePlot</name>
    <message>
        <source>Units</source>
        <translation>単位</translation>
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
        <translation>1 回転のカウント数</translation>
    </message>
    <message>
        <source>Encoder counts of one turn of the shaft, four for each line. Used for rpm, degrees and gains in physical units.</source>
        <translation>シャフト 1 回転あたりのエンコーダカウント数 (1 スリットにつき 4)。rpm、度、物理単位のゲインに使用します。</translation>
    </message>
    <message>
        <source>counts/rev</source>
        <translation>counts/rev</translation>
    </message>
    <message>
        <source>last %1 s</source>
        <translation>直近 %1 s</translation>
    </message>
    <message>
        <source>Length of the time axis</source>
        <translation>時間軸の長さ</translation>
    </message>
    <message>
        <source>Pause the view</source>
        <translation>表示を一時停止</translation>
    </message>
    <message>
        <source>Cursors A and B</source>
        <translation>カーソル A と B</translation>
    </message>
    <message>
        <source>Fit time and value</source>
        <translation>時間と値を全体表示</translation>
    </message>
    <message>
        <source>plot written to %1</source>
        <translation>プロットを %1 に書き出しました</translation>
    </message>
    <message>
        <source>Set-point</source>
        <translation>目標値</translation>
    </message>
    <message>
        <source>ch%1 set-point</source>
        <translation>ch%1 目標値</translation>
    </message>
    <message>
        <source>DEMO</source>
        <translation>デモ</translation>
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
        <translation>範囲</translation>
    </message>
    <message>
        <source>Identify</source>
        <translation>同定</translation>
    </message>
    <message>
        <source>Gains</source>
        <translation>ゲイン</translation>
    </message>
    <message>
        <source>Verify</source>
        <translation>検証</translation>
    </message>
    <message>
        <source>Store</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>The direction of motor and encoder was checked; the first closed loop of a run checks it again.</source>
        <translation>モーターとエンコーダーの方向は確認済みです。起動後最初の閉ループで再確認します。</translation>
    </message>
    <message>
        <source>Checked by itself before the first closed loop of a run.</source>
        <translation>起動後最初の閉ループの前に自動で確認します。</translation>
    </message>
    <message>
        <source>Every limit of an experiment is known.</source>
        <translation>実験の限界値はすべて分かっています。</translation>
    </message>
    <message>
        <source>Trial #%1 pushed the motor without a loop.</source>
        <translation>試行 #%1 がループなしでモーターを動かしました。</translation>
    </message>
    <message>
        <source>The device has the gains that are shown.</source>
        <translation>機器のゲインは表示のとおりです。</translation>
    </message>
    <message>
        <source>Edited gains wait to be written.</source>
        <translation>編集したゲインが書き込み待ちです。</translation>
    </message>
    <message>
        <source>The gains of the device are not known yet.</source>
        <translation>機器のゲインはまだ分かりません。</translation>
    </message>
    <message>
        <source>Trial #%1 ran with these gains.</source>
        <translation>試行 #%1 はこのゲインで実行しました。</translation>
    </message>
    <message>
        <source>The gains are in flash.</source>
        <translation>ゲインはフラッシュにあります。</translation>
    </message>
    <message>
        <source>The gains are not known to be in flash.</source>
        <translation>ゲインがフラッシュにあるかは分かりません。</translation>
    </message>
    <message>
        <source>%1: done</source>
        <comment>step</comment>
        <translation>%1: 完了</translation>
    </message>
    <message>
        <source>Steps; next is %1</source>
        <translation>手順。次は %1</translation>
    </message>
    <message>
        <source>Steps; all are done</source>
        <translation>手順。すべて完了</translation>
    </message>
    <message>
        <source>The last check found it wrong: the encoder is reversed, or the motor did not move.</source>
        <translation>最後の確認で誤りが見つかりました。エンコーダーが逆か、モーターが動きませんでした。</translation>
    </message>
    <message>
        <source>No model of the motor yet: the page Design identifies it.</source>
        <translation>モーターのモデルはまだありません。設計ページで同定します。</translation>
    </message>
    <message>
        <source>No trial with these gains yet: Run makes one.</source>
        <translation>このゲインでの試行はまだありません。「実行」で行います。</translation>
    </message>
</context>
<context>
    <name>mb::TuningSteps</name>
    <message>
        <source>Kept</source>
        <translation>維持</translation>
    </message>
    <message>
        <source>Proposed, nothing written</source>
        <translation>候補の提示のみ、書込みなし</translation>
    </message>
    <message>
        <source>Rolled back</source>
        <translation>元に戻しました</translation>
    </message>
    <message>
        <source>Refused</source>
        <translation>拒否</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>What happens</source>
        <translation>手順の内容</translation>
    </message>
    <message>
        <source>Working: the motor turns</source>
        <translation>実行中: モーターが回転します</translation>
    </message>
    <message>
        <source>STOP ends it at any moment; what was changed is put back.</source>
        <translation>STOP でいつでも終了できます。変更した値は元に戻します。</translation>
    </message>
    <message>
        <source>Nothing has moved yet</source>
        <translation>まだ何も動いていません</translation>
    </message>
    <message>
        <source>over ≤ %1 %, settle ≤ %2, error ≤ %3 %</source>
        <translation>OS ≤ %1 %、整定 ≤ %2、誤差 ≤ %3 %</translation>
    </message>
    <message>
        <source>over ≤ %1 %, error ≤ %2 %</source>
        <translation>OS ≤ %1 %、誤差 ≤ %2 %</translation>
    </message>
    <message>
        <source>over %1 %, settle %2, error %3 %</source>
        <translation>OS %1 %、整定 %2、誤差 %3 %</translation>
    </message>
    <message>
        <source>Identify the motor</source>
        <translation>モーターを同定</translation>
    </message>
    <message>
        <source>Pushes with a part of the duty, both ways. No gain is changed.</source>
        <translation>デューティの一部で両方向に動かします。ゲインは変更しません。</translation>
    </message>
    <message>
        <source>Choose a set</source>
        <translation>組を選択</translation>
    </message>
    <message>
        <source>The plots show what each would do.</source>
        <translation>プロットに各組の効果が表示されます。</translation>
    </message>
    <message>
        <source>Write and prove it</source>
        <translation>書き込んで検証</translation>
    </message>
    <message>
        <source>The gains are written, steps both ways are measured.</source>
        <translation>ゲインを書き込み、両方向のステップを測定します。</translation>
    </message>
    <message>
        <source>Keep it, or put everything back</source>
        <translation>維持、またはすべて元に戻す</translation>
    </message>
    <message>
        <source>It stays if it does what was predicted; else the reason is said.</source>
        <translation>予測どおりであれば維持します。そうでなければ理由を示します。</translation>
    </message>
    <message>
        <source>Write %1 to slot %2</source>
        <translation>%1 をスロット %2 に書込み</translation>
    </message>
    <message>
        <source>Write %1</source>
        <translation>%1 を書込み</translation>
    </message>
    <message>
        <source>The slot that the result is not for; what it had comes back.</source>
        <translation>結果を入れない側のスロット。元の値は戻します。</translation>
    </message>
    <message>
        <source>What is replaced is kept, to be put back.</source>
        <translation>置き換える値は保管し、戻せます。</translation>
    </message>
    <message>
        <source>Run %1 steps of %2 %3</source>
        <translation>%2 %3 のステップを %1 回実行</translation>
    </message>
    <message>
        <source>Both ways, every guard on; each is a trial.</source>
        <translation>両方向、すべての監視が有効。それぞれ試行になります。</translation>
    </message>
    <message>
        <source>Keep it in slot %1 when all hold</source>
        <translation>すべて満たせばスロット %1 に維持</translation>
    </message>
    <message>
        <source>Keep it when all hold</source>
        <translation>すべて満たせば維持</translation>
    </message>
    <message>
        <source>measured: %1</source>
        <translation>実測: %1</translation>
    </message>
    <message>
        <source>Else put everything back</source>
        <translation>そうでなければすべて元に戻す</translation>
    </message>
    <message>
        <source>Gains as before, the reason in the log.</source>
        <translation>ゲインは元のまま、理由はログに記録します。</translation>
    </message>
    <message>
        <source>motor turns %1 s</source>
        <translation>モーターが %1 秒回転</translation>
    </message>
    <message>
        <source>Identify and Autotune push first: %1</source>
        <translation>同定とオートチューニングは先に押します: %1</translation>
    </message>
    <message>
        <source>Not kept</source>
        <translation>採用せず</translation>
    </message>
    <message>
        <source>Find the gains anew</source>
        <translation>ゲインを求め直す</translation>
    </message>
    <message>
        <source>Those that are shown were found for other limits, or elsewhere.</source>
        <translation>表示中のゲインは別の限度、または別の位置で求めたものです。</translation>
    </message>
</context>
<context>
    <name>mb::UnitChecks</name>
    <message>
        <source>no unit answers yet</source>
        <translation>応答する機器はまだありません</translation>
    </message>
    <message numerus="yes">
        <source>%n units answer, one at a time</source>
        <translation>
            <numerusform>%n 台が応答、1 台ずつ処理</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 may turn</source>
        <translation>%1 が回転中の可能性</translation>
    </message>
    <message>
        <source>no motor turns</source>
        <translation>回転中のモーターなし</translation>
    </message>
    <message>
        <source>no link is open</source>
        <translation>開いているリンクがありません</translation>
    </message>
    <message>
        <source>%1 is open</source>
        <translation>%1 は接続中</translation>
    </message>
    <message>
        <source>the journal takes entries</source>
        <translation>記録簿に書き込めます</translation>
    </message>
    <message>
        <source>the journal keeps entries on this computer</source>
        <translation>記録はこのコンピューターに保存されます</translation>
    </message>
    <message>
        <source>Before each unit</source>
        <translation>各機器の前</translation>
    </message>
    <message>
        <source>%1 is not open</source>
        <translation>%1 は開いていません</translation>
    </message>
</context>
<context>
    <name>mb::UnitList</name>
    <message>
        <source>Last ten units, newest first</source>
        <translation>直近 10 台、新しい順</translation>
    </message>
</context>
<context>
    <name>mb::UnitStates</name>
    <message>
        <source>Device, now</source>
        <translation>機器、現在</translation>
    </message>
    <message>
        <source>factory defaults</source>
        <translation>工場出荷時の値</translation>
    </message>
    <message>
        <source>live</source>
        <translation>現在値</translation>
    </message>
    <message numerus="yes">
        <source>%n values</source>
        <translation>
            <numerusform>%n 個の値</numerusform>
        </translation>
    </message>
    <message>
        <source>by hand, %1</source>
        <translation>手動、%1</translation>
    </message>
    <message>
        <source>automatic, %1</source>
        <translation>自動、%1</translation>
    </message>
    <message>
        <source>from the device description</source>
        <translation>機器の記述による</translation>
    </message>
</context>
<context>
    <name>mb::UnitSteps</name>
    <message>
        <source>Steps of this unit</source>
        <translation>この機器の手順</translation>
    </message>
    <message>
        <source>Skip this unit</source>
        <translation>この機器を飛ばす</translation>
    </message>
    <message>
        <source>Do it again</source>
        <translation>もう一度</translation>
    </message>
    <message>
        <source>No unit selected</source>
        <translation>機器が選択されていません</translation>
    </message>
</context>
<context>
    <name>mb::UnitUpdate</name>
    <message>
        <source>Verified: %1</source>
        <translation>検証済み: %1</translation>
    </message>
    <message>
        <source>Not needed: %1</source>
        <translation>不要: %1</translation>
    </message>
    <message>
        <source>Refused: %1</source>
        <translation>拒否: %1</translation>
    </message>
    <message>
        <source>Failed: %1</source>
        <translation>失敗: %1</translation>
    </message>
    <message>
        <source>Cancelled. %1.</source>
        <translation>キャンセルしました。%1。</translation>
    </message>
    <message>
        <source>device</source>
        <translation>機器</translation>
    </message>
    <message>
        <source>firmware</source>
        <translation>ファームウェア</translation>
    </message>
    <message>
        <source>image</source>
        <translation>イメージ</translation>
    </message>
    <message>
        <source>Open image…</source>
        <translation>イメージを開く…</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>手順</translation>
    </message>
    <message>
        <source>Progress of the update</source>
        <translation>更新の進捗</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Update</source>
        <translation>更新</translation>
    </message>
    <message>
        <source>Run the update again</source>
        <translation>更新を再実行</translation>
    </message>
    <message>
        <source>One update a bus: %1 is being written.</source>
        <translation>更新は 1 バスにつき 1 件です: %1 に書込み中です。</translation>
    </message>
    <message>
        <source>no device selected</source>
        <translation>機器が選択されていません</translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>%1 → %2</source>
        <translation>%1 → %2</translation>
    </message>
    <message>
        <source>image fits this family</source>
        <translation>イメージはこのファミリに適合</translation>
    </message>
    <message>
        <source>no usable image</source>
        <translation>使用できるイメージなし</translation>
    </message>
    <message>
        <source>motor is moving</source>
        <translation>モーター動作中</translation>
    </message>
    <message>
        <source>motor stopped</source>
        <translation>モーター停止</translation>
    </message>
    <message>
        <source>no other master, number unique</source>
        <translation>他のマスタなし、番号の重複なし</translation>
    </message>
    <message>
        <source>another master, or a number taken twice</source>
        <translation>他のマスタあり、または番号が重複</translation>
    </message>
    <message>
        <source>no device</source>
        <translation>機器なし</translation>
    </message>
    <message>
        <source>%1 s a page, about %2 s left</source>
        <translation>1 ページ %1 s、残り約 %2 s</translation>
    </message>
    <message>
        <source>Nothing running</source>
        <translation>実行中の処理なし</translation>
    </message>
    <message>
        <source>%1, %2 of %3 written</source>
        <translation>%1、%2/%3 書込み済み</translation>
    </message>
    <message>
        <source>%1 s, pages sent again: %2</source>
        <translation>%1 s、再送ページ数: %2</translation>
    </message>
    <message>
        <source>Open a firmware image</source>
        <translation>ファームウェアイメージを開く</translation>
    </message>
    <message>
        <source>Intel HEX (*.hex *.ihex);;All files (*)</source>
        <translation>Intel HEX (*.hex *.ihex);;すべてのファイル (*)</translation>
    </message>
    <message>
        <source>motor not known</source>
        <translation>モーター不明</translation>
    </message>
    <message>
        <source>Cancelled: %1</source>
        <translation>中止しました: %1</translation>
    </message>
    <message>
        <source>Cancelled: nothing was written.</source>
        <translation>中止しました: 何も書き込まれていません。</translation>
    </message>
    <message>
        <source>%1, as in the image</source>
        <translation>%1（イメージと同じ）</translation>
    </message>
    <message>
        <source>Written, not proved: %1</source>
        <translation>書き込み済み、未確認: %1</translation>
    </message>
    <message>
        <source>%1 has changed since it was opened and is read again; start the update once more</source>
        <translation>%1 は開いた後に変更されたため読み直しました。もう一度更新を開始してください</translation>
    </message>
    <message>
        <source>Before start</source>
        <translation>開始前の確認</translation>
    </message>
    <message>
        <source>Units are served on this link.</source>
        <translation>このリンクでは機器を処理中です。</translation>
    </message>
</context>
<context>
    <name>mb::UpdateLog</name>
    <message>
        <source>Log</source>
        <translation>ログ</translation>
    </message>
    <message>
        <source>Save log…</source>
        <translation>ログを保存…</translation>
    </message>
    <message>
        <source>Log of the update</source>
        <translation>更新のログ</translation>
    </message>
    <message>
        <source>Save the log of the update</source>
        <translation>更新のログを保存</translation>
    </message>
    <message>
        <source>Text (*.log *.txt)</source>
        <translation>テキスト (*.log *.txt)</translation>
    </message>
</context>
<context>
    <name>mb::UpdateSide</name>
    <message>
        <source>Flash pages</source>
        <translation>フラッシュページ</translation>
    </message>
    <message>
        <source>In the order they are written. Green: written. Amber edge: sent again. Dashed: not in the image. Red: must not be cut.</source>
        <translation>書込み順。緑: 書込み済み。黄枠: 再送。破線: イメージになし。赤: 中断禁止。</translation>
    </message>
    <message>
        <source>Do not unplug</source>
        <translation>取り外さないでください</translation>
    </message>
    <message>
        <source>Safe to unplug</source>
        <translation>取り外し可</translation>
    </message>
    <message>
        <source>Nothing is written now</source>
        <translation>現在は何も書き込んでいません</translation>
    </message>
    <message>
        <source>The motor turns as soon as Arm in the header is held.</source>
        <translation>ヘッダの駆動許可ボタンを長押しすると、すぐにモーターが回転します。</translation>
    </message>
    <message>
        <source>The self-test turns the motor.</source>
        <translation>セルフテストでモーターが回転します。</translation>
    </message>
</context>
<context>
    <name>mb::VerdictView</name>
    <message>
        <source>READY</source>
        <translation>準備完了</translation>
    </message>
    <message>
        <source>WORKING</source>
        <translation>実行中</translation>
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
        <translation>拒否</translation>
    </message>
    <message>
        <source>LEFT OUT</source>
        <translation>省略</translation>
    </message>
</context>
<context>
    <name>mb::Welcome</name>
    <message>
        <source>Folder with firmware</source>
        <translation>ファームウェアのフォルダ</translation>
    </message>
</context>
<context>
    <name>mb::WindowKeys</name>
    <message>
        <source>shows these keys; once more, the help for this page</source>
        <translation>キー一覧を表示します。もう一度押すとこのページのヘルプを表示します</translation>
    </message>
    <message>
        <source>production: unit after unit, full screen; and back</source>
        <translation>生産: 機器を次々に処理、全画面表示。もう一度で戻ります</translation>
    </message>
    <message>
        <source>shows page %1</source>
        <translation>「%1」ページを表示します</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>ウィンドウ</translation>
    </message>
    <message>
        <source>Menu</source>
        <translation>メニュー</translation>
    </message>
    <message>
        <source>renames the selected device; in production: goes to the serial number</source>
        <translation>選択した機器の名前を変更します。生産ではシリアル番号へ移動します</translation>
    </message>
    <message>
        <source>stores what the selected device has in RAM only</source>
        <translation>選択した機器が RAM にのみ持つ値を保存します</translation>
    </message>
    <message>
        <source>takes a snapshot of the selected device</source>
        <translation>選択した機器のスナップショットを取得します</translation>
    </message>
</context>
<context>
    <name>mb::WindowMenu</name>
    <message>
        <source>Add link…</source>
        <translation>リンクを追加…</translation>
    </message>
    <message>
        <source>Open recording…</source>
        <translation>記録を開く…</translation>
    </message>
    <message>
        <source>Open the simulated bench</source>
        <translation>シミュレーションベンチを開く</translation>
    </message>
    <message>
        <source>Open the folder of a machine…</source>
        <translation>装置のフォルダを開く…</translation>
    </message>
    <message>
        <source>Save the machine into a folder…</source>
        <translation>装置をフォルダに保存…</translation>
    </message>
    <message>
        <source>Commands…</source>
        <translation>コマンド…</translation>
    </message>
    <message>
        <source>Switch between dark and light</source>
        <translation>ダーク/ライトを切替え</translation>
    </message>
    <message>
        <source>Preferences…</source>
        <translation>環境設定…</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>ヘルプ</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>キー</translation>
    </message>
    <message>
        <source>About MotorBench</source>
        <translation>MotorBench について</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>終了</translation>
    </message>
    <message>
        <source>Open a recording</source>
        <translation>記録を開く</translation>
    </message>
    <message>
        <source>All recordings (*.log *.asc *.txt *.mcap *.csv)</source>
        <translation>すべての記録 (*.log *.asc *.txt *.mcap *.csv)</translation>
    </message>
    <message>
        <source>Frames: candump and Vector ASC logs (*.log *.asc *.txt)</source>
        <translation>フレーム: candump と Vector ASC のログ (*.log *.asc *.txt)</translation>
    </message>
    <message>
        <source>Samples: MCAP, CSV (*.mcap *.csv)</source>
        <translation>サンプル: MCAP、CSV (*.mcap *.csv)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>すべてのファイル (*)</translation>
    </message>
    <message>
        <source>lists everything that can be done, by name</source>
        <translation>実行できる操作を名前順に一覧表示します</translation>
    </message>
    <message>
        <source>shows the preferences</source>
        <translation>環境設定を表示します</translation>
    </message>
    <message>
        <source>switches between dark and light</source>
        <translation>ダーク/ライトを切り替えます</translation>
    </message>
    <message>
        <source>opens a recording</source>
        <translation>記録を開きます</translation>
    </message>
    <message>
        <source>quits</source>
        <translation>終了します</translation>
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
        <translation>電流</translation>
    </message>
    <message>
        <source>Duty</source>
        <translation>デューティ</translation>
    </message>
    <message>
        <source>Set-point</source>
        <translation>目標値</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>温度</translation>
    </message>
    <message>
        <source>F: the firmware&apos;s codes</source>
        <translation>F: ファームウェアのコード</translation>
    </message>
    <message>
        <source>A unit that speaks the document&apos;s codes would take position for current and current for position.</source>
        <translation>文書のコードで通信する機器は、位置を電流、電流を位置と解釈します。</translation>
    </message>
    <message>
        <source>L: legacy frames of 8 bytes</source>
        <translation>L: 旧形式の 8 バイトフレーム</translation>
    </message>
    <message>
        <source>A unit with today&apos;s firmware ignores these frames, the stop excepted, which is sent both ways.</source>
        <translation>現行ファームウェアの機器はこれらのフレームを無視します。停止だけは両方の形式で送信します。</translation>
    </message>
    <message>
        <source>LL: older, cannot be stopped</source>
        <translation>LL: さらに旧式、停止不可</translation>
    </message>
    <message>
        <source>It is only watched: there is no code that stops it.</source>
        <translation>監視のみです: 停止させるコードがありません。</translation>
    </message>
    <message>
        <source>D: the document&apos;s codes</source>
        <translation>D: 文書のコード</translation>
    </message>
    <message>
        <source>A unit that speaks the firmware&apos;s codes runs at full power when it is told a position, and loses its divisor when D is written.</source>
        <translation>ファームウェアのコードで通信する機器は、位置指令で全出力運転となり、D の書込みで除数を失います。</translation>
    </message>
    <message>
        <source>Counts per revolution</source>
        <translation>1 回転のカウント数</translation>
    </message>
    <message>
        <source>Encoder edges in one turn: four times its lines.</source>
        <translation>1 回転のエンコーダエッジ数: スリット数の 4 倍。</translation>
    </message>
    <message>
        <source>Ampere per count</source>
        <translation>1 カウントあたりのアンペア</translation>
    </message>
    <message>
        <source>What one count of the current converter stands for; it depends on the board.</source>
        <translation>電流変換器の 1 カウントの値。基板により異なります。</translation>
    </message>
    <message>
        <source>Degrees per count</source>
        <translation>1 カウントあたりの度</translation>
    </message>
    <message>
        <source>What one count of the temperature converter stands for; it depends on the board.</source>
        <translation>温度変換器の 1 カウントの値。基板により異なります。</translation>
    </message>
    <message>
        <source>Nothing is written yet; the update can be run again</source>
        <translation>まだ何も書き込んでいません。更新を再実行できます</translation>
    </message>
    <message>
        <source>The flash is being written: it must not be cut</source>
        <translation>フラッシュを書込み中です: 中断しないでください</translation>
    </message>
    <message>
        <source>A unit that is cut while it is written holds half a program. It runs again once an update has succeeded.</source>
        <translation>書込み中に中断された機器はプログラムが不完全です。更新に成功すれば再び動作します。</translation>
    </message>
    <message>
        <source>output saturated</source>
        <translation>出力飽和</translation>
    </message>
    <message>
        <source>output wrapped around</source>
        <translation>出力ラップアラウンド</translation>
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
        <translation>OpenOCD がデバッグプローブを検出できません</translation>
    </message>
    <message>
        <source>plug it in, and check that its kind is the one named after openocd:</source>
        <translation>接続し、種類が openocd: の後の名前と一致することを確認してください</translation>
    </message>
    <message>
        <source>OpenOCD has no interface of this name</source>
        <translation>OpenOCD にこの名前のインターフェースはありません</translation>
    </message>
    <message>
        <source>name one of its interface files, such as openocd:stlink</source>
        <translation>OpenOCD のインターフェースファイルを指定してください (例: openocd:stlink)</translation>
    </message>
    <message>
        <source>this interface does not speak SWD</source>
        <translation>このインターフェースは SWD に対応していません</translation>
    </message>
    <message>
        <source>name a debug probe that does, such as openocd:stlink</source>
        <translation>対応するデバッグプローブを指定してください (例: openocd:stlink)</translation>
    </message>
    <message>
        <source>the microcontroller does not hold what was written</source>
        <translation>マイクロコントローラの内容が書き込んだものと一致しません</translation>
    </message>
    <message>
        <source>run it again with shorter wires or a lower speed</source>
        <translation>配線を短くするか速度を下げて再実行してください</translation>
    </message>
    <message>
        <source>the microcontroller refused to be written</source>
        <translation>マイクロコントローラが書込みを拒否しました</translation>
    </message>
    <message>
        <source>it may be protected, or be another kind than --target says</source>
        <translation>保護されているか、--target の指定と種類が異なる可能性があります</translation>
    </message>
    <message>
        <source>the microcontroller is another kind than --target says</source>
        <translation>マイクロコントローラの種類が --target の指定と異なります</translation>
    </message>
    <message>
        <source>choose the other one of f1 and f4</source>
        <translation>f1 と f4 のもう一方を選択してください</translation>
    </message>
    <message>
        <source>the probe is there, but no microcontroller answers it</source>
        <translation>プローブはありますが、マイクロコントローラが応答しません</translation>
    </message>
    <message>
        <source>check SWDIO, SWCLK, ground and the power of the drive</source>
        <translation>SWDIO、SWCLK、グランド、ドライブの電源を確認してください</translation>
    </message>
    <message>
        <source>the microcontroller could not be halted</source>
        <translation>マイクロコントローラを停止できません</translation>
    </message>
    <message>
        <source>check the reset wire and the power of the drive</source>
        <translation>リセット線とドライブの電源を確認してください</translation>
    </message>
    <message>
        <source>the debug probe is there but may not be opened</source>
        <translation>デバッグプローブはありますが、開く権限がありません</translation>
    </message>
    <message>
        <source>install OpenOCD&apos;s udev rules or ask your administrator</source>
        <translation>OpenOCD の udev ルールをインストールするか、管理者に問い合わせてください</translation>
    </message>
    <message>
        <source>Velocity loop</source>
        <translation>速度ループ</translation>
    </message>
    <message>
        <source>Current loop</source>
        <translation>電流ループ</translation>
    </message>
    <message>
        <source>Position loop</source>
        <translation>位置ループ</translation>
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
        <translation>偏差 1 単位あたりの出力 (255 = 100 %) × 除数。32767 を超えると出力が逆転最大に反転します: そのためプログラムは目標値をモーターの現在値の近くに保ちます。</translation>
    </message>
    <message>
        <source>Output per unit of error and millisecond, times the divisor. Each step of 20 ms is cut to a whole number, so small gains do nothing, and nothing limits the sum.</source>
        <translation>偏差 1 単位、1 ミリ秒あたりの出力 × 除数。20 ms ごとに整数に切り捨てるため小さいゲインは効かず、積算値に上限はありません。</translation>
    </message>
    <message>
        <source>Output times milliseconds per change of error, times the divisor. Its sign is inverted in the drive: only negative numbers damp.</source>
        <translation>偏差の変化あたりの出力とミリ秒の積 × 除数。ドライブ内で符号が反転します: 負の数だけが制動に働きます。</translation>
    </message>
    <message>
        <source>Averaging</source>
        <translation>平均化</translation>
    </message>
    <message>
        <source>Loop error</source>
        <translation>制御偏差</translation>
    </message>
    <message>
        <source>Supply</source>
        <translation>電源</translation>
    </message>
    <message>
        <source>Analog input</source>
        <translation>アナログ入力</translation>
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
        <translation>ループ周期</translation>
    </message>
    <message>
        <source>over-current</source>
        <translation>過電流</translation>
    </message>
    <message>
        <source>over-temperature</source>
        <translation>過熱</translation>
    </message>
    <message>
        <source>under-voltage</source>
        <translation>不足電圧</translation>
    </message>
    <message>
        <source>gate driver</source>
        <translation>ゲートドライバ</translation>
    </message>
    <message>
        <source>communication</source>
        <translation>通信</translation>
    </message>
    <message>
        <source>The unit then waits in its bootloader; the update can be run again</source>
        <translation>機器はブートローダで待機し、更新を再実行できます</translation>
    </message>
    <message>
        <source>Page 0 is being written: it must not be cut</source>
        <translation>ページ 0 を書込み中です: 中断しないでください</translation>
    </message>
    <message>
        <source>A unit that is cut stays in its bootloader and can be updated again. Only page 0, the last, must not be interrupted.</source>
        <translation>中断された機器はブートローダに留まり、再び更新できます。最後のページ 0 だけは中断してはいけません。</translation>
    </message>
    <message>
        <source>Page 0 holds the reset vector. A cut now cannot be repaired over the bus.</source>
        <translation>ページ 0 にはリセットベクタがあります。今中断すると、バス経由では復旧できません。</translation>
    </message>
    <message>
        <source>Limit switches</source>
        <translation>リミットスイッチ</translation>
    </message>
    <message>
        <source>Soft limits</source>
        <translation>ソフトリミット</translation>
    </message>
    <message>
        <source>Loop, slot 0</source>
        <translation>制御ループ、スロット 0</translation>
    </message>
    <message>
        <source>Loop, slot 1</source>
        <translation>制御ループ、スロット 1</translation>
    </message>
    <message>
        <source>Current limiter</source>
        <translation>電流リミッタ</translation>
    </message>
    <message>
        <source>Encoder</source>
        <translation>エンコーダ</translation>
    </message>
    <message>
        <source>Faults</source>
        <translation>フォルト</translation>
    </message>
    <message>
        <source>Current limit</source>
        <translation>電流制限</translation>
    </message>
    <message>
        <source>Status frames</source>
        <translation>ステータスフレーム</translation>
    </message>
    <message>
        <source>Normally closed is hit when the switch opens, normally open when it closes. A hit blocks output in this direction.</source>
        <translation>b 接点 (NC) は開くと、a 接点 (NO) は閉じると作動します。作動すると、その方向の出力を遮断します。</translation>
    </message>
    <message>
        <source>On switches the limit OFF: the sense is the opposite of the soft limits&apos; Enabled.</source>
        <translation>オンでリミットが無効になります: ソフトリミットの「有効」とは逆の意味です。</translation>
    </message>
    <message>
        <source>Output (32767 = 100 %) per unit of error: counts/100 ms, counts or A, depending on the mode.</source>
        <translation>偏差 1 単位あたりの出力 (32767 = 100 %)。単位はモードにより counts/100 ms、counts、A です。</translation>
    </message>
    <message>
        <source>Output per unit of error and loop of 500 µs. With F·K = 1 any I overshoots.</source>
        <translation>偏差 1 単位、ループ周期 500 µs あたりの出力。F·K = 1 では I があるだけでオーバーシュートします。</translation>
    </message>
    <message>
        <source>Output per change of error in one loop of 500 µs. One count of noise makes a spike of D.</source>
        <translation>ループ周期 500 µs の偏差変化あたりの出力。1 カウントのノイズで D にスパイクが生じます。</translation>
    </message>
    <message>
        <source>Bound of the integral accumulator, raw integer. 0 means unlimited, not zero.</source>
        <translation>積分器の上限、整数の生値。0 はゼロではなく無制限です。</translation>
    </message>
    <message>
        <source>Output per unit of set-point, added to P, I and D.</source>
        <translation>目標値 1 単位あたりの出力。P、I、D に加算されます。</translation>
    </message>
    <message>
        <source>Below it P, I and D contribute nothing and the integral is cleared; F still applies. 0 switches the feature off.</source>
        <translation>偏差がこれ未満では P、I、D は作用せず、積分器はクリアされます。F は作用します。0 で機能オフ。</translation>
    </message>
    <message>
        <source>Greatest change of output in a loop of 500 µs; 16 takes 1.024 s from 0 to 100 %. Lower is slower, but 0 is no ramp.</source>
        <translation>ループ周期 500 µs あたりの出力の最大変化。16 で 0 から 100 % まで 1.024 s です。小さいほど遅くなりますが、0 はランプなしです。</translation>
    </message>
    <message>
        <source>Greatest forward output, 32767 = 100 %.</source>
        <translation>正転方向の最大出力、32767 = 100 %。</translation>
    </message>
    <message>
        <source>Greatest reverse output, −32768 = −100 %. A number at or below 0.</source>
        <translation>逆転方向の最大出力、−32768 = −100 %。0 以下の数値。</translation>
    </message>
    <message>
        <source>Least forward output outside the allowable error; overcomes friction. Closed-loop modes only.</source>
        <translation>許容偏差の外での正転方向の最小出力。摩擦に打ち勝ちます。閉ループモードのみ。</translation>
    </message>
    <message>
        <source>Least reverse output outside the allowable error, a number at or below 0. Closed-loop modes only.</source>
        <translation>許容偏差の外での逆転方向の最小出力、0 以下の数値。閉ループモードのみ。</translation>
    </message>
    <message>
        <source>Keeps clearing as long as the switch is active, even if its limit is disabled. Lost at power-off.</source>
        <translation>リミットが無効でも、スイッチが作動している間はクリアし続けます。電源を切ると失われます。</translation>
    </message>
    <message>
        <source>Writing anything but 0 reads the count and clears it.</source>
        <translation>0 以外を書き込むと、カウントを読み出してクリアします。</translation>
    </message>
    <message>
        <source>Forward switch is normally closed</source>
        <translation>正転スイッチ b 接点</translation>
    </message>
    <message>
        <source>Forward switch disabled</source>
        <translation>正転スイッチ無効</translation>
    </message>
    <message>
        <source>Reverse switch is normally closed</source>
        <translation>逆転スイッチ b 接点</translation>
    </message>
    <message>
        <source>Reverse switch disabled</source>
        <translation>逆転スイッチ無効</translation>
    </message>
    <message>
        <source>Forward soft limit</source>
        <translation>正転ソフトリミット</translation>
    </message>
    <message>
        <source>At or above this position forward output is blocked, if enabled.</source>
        <translation>有効な場合、この位置以上で正転方向の出力を遮断します。</translation>
    </message>
    <message>
        <source>Forward soft limit enabled</source>
        <translation>正転ソフトリミット有効</translation>
    </message>
    <message>
        <source>On switches the limit ON: the sense is the opposite of the switches&apos; Disabled.</source>
        <translation>オンでリミットが有効になります: スイッチの「無効」とは逆の意味です。</translation>
    </message>
    <message>
        <source>Reverse soft limit</source>
        <translation>逆転ソフトリミット</translation>
    </message>
    <message>
        <source>At or below this position reverse output is blocked, if enabled.</source>
        <translation>有効な場合、この位置以下で逆転方向の出力を遮断します。</translation>
    </message>
    <message>
        <source>Reverse soft limit enabled</source>
        <translation>逆転ソフトリミット有効</translation>
    </message>
    <message>
        <source>Current scale</source>
        <translation>電流スケール</translation>
    </message>
    <message>
        <source>Calibrated at the factory. All current limiting depends on it: change it only to trim the reading.</source>
        <translation>工場で校正されています。電流制限はすべてこの値に依存します: 測定値の微調整以外では変更しないでください。</translation>
    </message>
    <message>
        <source>I zone</source>
        <translation>I ゾーン</translation>
    </message>
    <message>
        <source>Allowable error</source>
        <translation>許容偏差</translation>
    </message>
    <message>
        <source>Ramp</source>
        <translation>ランプ</translation>
    </message>
    <message>
        <source>Maximum forward</source>
        <translation>正転最大出力</translation>
    </message>
    <message>
        <source>Maximum reverse</source>
        <translation>逆転最大出力</translation>
    </message>
    <message>
        <source>Nominal forward</source>
        <translation>正転最小出力</translation>
    </message>
    <message>
        <source>Nominal reverse</source>
        <translation>逆転最小出力</translation>
    </message>
    <message>
        <source>The factory value suits most motors.</source>
        <translation>ほとんどのモーターには工場出荷時の値が適します。</translation>
    </message>
    <message>
        <source>The live count. Written only while the output is off.</source>
        <translation>現在のカウント値。出力がオフのときだけ書き込みます。</translation>
    </message>
    <message>
        <source>Index clears position</source>
        <translation>インデックスで位置クリア</translation>
    </message>
    <message>
        <source>At the index edge chosen below. Lost at power-off.</source>
        <translation>下で選択したインデックスのエッジで作用します。電源を切ると失われます。</translation>
    </message>
    <message>
        <source>Forward switch clears position</source>
        <translation>正転スイッチで位置クリア</translation>
    </message>
    <message>
        <source>Reverse switch clears position</source>
        <translation>逆転スイッチで位置クリア</translation>
    </message>
    <message>
        <source>Index acts on its rising edge</source>
        <translation>インデックス立上りエッジ</translation>
    </message>
    <message>
        <source>Off is the falling edge. Lost at power-off.</source>
        <translation>オフは立下りエッジです。電源を切ると失われます。</translation>
    </message>
    <message>
        <source>Present faults</source>
        <translation>現在のフォルト</translation>
    </message>
    <message>
        <source>1 over-current, 2 over-temperature, 4 under-voltage, 8 gate driver, 16 communication.</source>
        <translation>1 過電流、2 過熱、4 不足電圧、8 ゲートドライバ、16 通信。</translation>
    </message>
    <message>
        <source>Faults since the last clear</source>
        <translation>前回クリア後のフォルト</translation>
    </message>
    <message>
        <source>The bits of the present faults. Writing anything but 0 reads them and clears them.</source>
        <translation>現在のフォルトと同じビット構成。0 以外を書き込むと、読み出してクリアします。</translation>
    </message>
    <message>
        <source>Over-current count</source>
        <translation>過電流回数</translation>
    </message>
    <message>
        <source>Over-temperature count</source>
        <translation>過熱回数</translation>
    </message>
    <message>
        <source>Under-voltage count</source>
        <translation>不足電圧回数</translation>
    </message>
    <message>
        <source>Supply below 5.75 V for 5 s. Writing anything but 0 reads the count and clears it.</source>
        <translation>電源が 5 s 間 5.75 V を下回った回数。0 以外を書き込むと、カウントを読み出してクリアします。</translation>
    </message>
    <message>
        <source>Gate driver count</source>
        <translation>ゲートドライバ回数</translation>
    </message>
    <message>
        <source>Usually a short between M+ and M−. Writing anything but 0 reads the count and clears it.</source>
        <translation>通常は M+ と M− の短絡です。0 以外を書き込むと、カウントを読み出してクリアします。</translation>
    </message>
    <message>
        <source>Communication loss count</source>
        <translation>通信途絶回数</translation>
    </message>
    <message>
        <source>Since the last power-up. Writing anything but 0 reads the count and clears it.</source>
        <translation>前回の電源投入以降。0 以外を書き込むと、カウントを読み出してクリアします。</translation>
    </message>
    <message>
        <source>Continuous limit</source>
        <translation>連続電流制限</translation>
    </message>
    <message>
        <source>At or above the peak limit, limiting starts as soon as this is exceeded.</source>
        <translation>ピーク制限以上の場合は、これを超えるとただちに制限します。</translation>
    </message>
    <message>
        <source>Peak limit</source>
        <translation>ピーク電流制限</translation>
    </message>
    <message>
        <source>Above it for the peak duration, the current is brought down to the continuous limit.</source>
        <translation>これを超えた状態がピーク時間続くと、電流を連続電流制限まで下げます。</translation>
    </message>
    <message>
        <source>Peak duration</source>
        <translation>ピーク時間</translation>
    </message>
    <message>
        <source>Time above the peak limit before limiting starts; 0 limits at once.</source>
        <translation>ピーク制限を超えてから制限を始めるまでの時間。0 は即時です。</translation>
    </message>
    <message>
        <source>Current limit enabled</source>
        <translation>電流制限有効</translation>
    </message>
    <message>
        <source>Off is the factory setting: nothing limits the current.</source>
        <translation>工場出荷時の設定はオフです: 電流は制限されません。</translation>
    </message>
    <message>
        <source>Analog period</source>
        <translation>アナログ周期</translation>
    </message>
    <message>
        <source>Milliseconds between frames, although the vendor calls it a rate. Back to 100 at every restart.</source>
        <translation>フレーム間隔のミリ秒値です (メーカーは rate と呼んでいます)。再起動のたびに 100 に戻ります。</translation>
    </message>
    <message>
        <source>Encoder period</source>
        <translation>エンコーダ周期</translation>
    </message>
    <message>
        <source>General period</source>
        <translation>一般周期</translation>
    </message>
    <message>
        <source>Milliseconds between frames. At most 50, because followers stop after 104 ms without one.</source>
        <translation>フレーム間隔のミリ秒値。追従側の機器はフレームが 104 ms 途絶えると停止するため、最大 50 です。</translation>
    </message>
    <message>
        <source>current is limited</source>
        <translation>電流制限中</translation>
    </message>
    <message>
        <source>Forward limit switch</source>
        <translation>正転リミットスイッチ</translation>
    </message>
    <message>
        <source>forward limit switch holds</source>
        <translation>正転リミットスイッチ作動中</translation>
    </message>
    <message>
        <source>Reverse limit switch</source>
        <translation>逆転リミットスイッチ</translation>
    </message>
    <message>
        <source>reverse limit switch holds</source>
        <translation>逆転リミットスイッチ作動中</translation>
    </message>
    <message>
        <source>forward soft limit holds</source>
        <translation>正転ソフトリミット作動中</translation>
    </message>
    <message>
        <source>reverse soft limit holds</source>
        <translation>逆転ソフトリミット作動中</translation>
    </message>
    <message>
        <source>Limit override</source>
        <translation>リミットの無効化</translation>
    </message>
    <message>
        <source>the set-point decides which limit switches count</source>
        <translation>どのリミットスイッチを有効とするかは目標値で決まります</translation>
    </message>
    <message>
        <source>Halt</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>halted</source>
        <translation>停止済み</translation>
    </message>
    <message>
        <source>Pin of the forward limit switch</source>
        <translation>正転リミットスイッチの端子</translation>
    </message>
    <message>
        <source>Pin of the reverse limit switch</source>
        <translation>逆転リミットスイッチの端子</translation>
    </message>
    <message>
        <source>Encoder pin A</source>
        <translation>エンコーダ端子 A</translation>
    </message>
    <message>
        <source>Encoder pin B</source>
        <translation>エンコーダ端子 B</translation>
    </message>
    <message>
        <source>Encoder index pin</source>
        <translation>エンコーダインデックス端子</translation>
    </message>
    <message>
        <source>baud rate</source>
        <translation>ボーレート</translation>
    </message>
    <message>
        <source>From the data sheet.</source>
        <translation>データシートによる値です。</translation>
    </message>
    <message>
        <source>format</source>
        <translation>形式</translation>
    </message>
    <message>
        <source>Data bits, parity, stop bits. Not told.</source>
        <translation>データビット、パリティ、ストップビット。公開されていません。</translation>
    </message>
    <message>
        <source>line ending</source>
        <translation>行末</translation>
    </message>
    <message>
        <source>Not told; the terminal program that the data sheet names sends cr.</source>
        <translation>公開されていません。データシートに記載の端末プログラムは cr を送信します。</translation>
    </message>
    <message>
        <source>greeting holds</source>
        <translation>起動メッセージに含む語</translation>
    </message>
    <message>
        <source>The data sheet tells this word, and not the whole greeting.</source>
        <translation>データシートにあるのはこの語だけで、メッセージ全体は記載されていません。</translation>
    </message>
    <message>
        <source>refusal holds</source>
        <translation>拒否メッセージに含む語</translation>
    </message>
    <message>
        <source>Not told. Words with | between them, in whatever case.</source>
        <translation>公開されていません。語を | で区切ります。大文字と小文字は区別しません。</translation>
    </message>
    <message>
        <source>pause</source>
        <translation>休止時間</translation>
    </message>
    <message>
        <source>Least time from one line to the next in milliseconds, from the data sheet.</source>
        <translation>行間の最小時間 (ミリ秒)、データシートによる値です。</translation>
    </message>
    <message>
        <source>leaves with</source>
        <translation>終了コマンド</translation>
    </message>
    <message>
        <source>Typed at the end. &quot;none&quot; leaves it to jumper and reset.</source>
        <translation>最後に送信します。&quot;none&quot; の場合はジャンパとリセットに任せます。</translation>
    </message>
    <message>
        <source>counts/s (safe)</source>
        <translation>counts/s (安全)</translation>
    </message>
    <message>
        <source>counts/s × 4096</source>
        <translation>counts/s × 4096</translation>
    </message>
    <message>
        <source>as the library</source>
        <translation>ライブラリに従う</translation>
    </message>
    <message>
        <source>as the data sheet</source>
        <translation>データシートに従う</translation>
    </message>
    <message>
        <source>The data sheet contradicts itself on velocity targets. With plain counts/s a board that wants × 4096 hardly moves; the opposite mistake asks for full speed. Change it only when a board hardly moves, and with a small power limit.</source>
        <translation>データシートの速度目標値の記述には矛盾があります。× 4096 を前提とする基板に counts/s をそのまま送るとほとんど動かず、逆の誤りでは最高速度の指令になります。基板がほとんど動かない場合だけ、小さい出力制限のもとで変更してください。</translation>
    </message>
    <message>
        <source>Data sheet and the maker&apos;s library give polarity and edges of the inputs opposite bits. The library is more likely right; an experiment with the status bit tells.</source>
        <translation>入力の極性とエッジのビットが、データシートとメーカーのライブラリで逆になっています。ライブラリの方が正しい可能性が高く、状態ビットの実験で確認できます。</translation>
    </message>
    <message>
        <source>Power units (8191 is full power) that a raw gain of 1 gives. The maker does not tell; an experiment finds it.</source>
        <translation>ゲインの生値 1 が与える出力単位 (8191 が最大出力)。メーカーは公開していませんが、実験で求められます。</translation>
    </message>
    <message>
        <source>velocity target</source>
        <translation>速度目標値</translation>
    </message>
    <message>
        <source>input polarity</source>
        <translation>入力極性</translation>
    </message>
    <message>
        <source>velocity P scale</source>
        <translation>速度 P スケール</translation>
    </message>
    <message>
        <source>velocity I scale</source>
        <translation>速度 I スケール</translation>
    </message>
    <message>
        <source>position P scale</source>
        <translation>位置 P スケール</translation>
    </message>
    <message>
        <source>position I scale</source>
        <translation>位置 I スケール</translation>
    </message>
    <message>
        <source>position D scale</source>
        <translation>位置 D スケール</translation>
    </message>
    <message>
        <source>Status bits</source>
        <translation>状態ビット</translation>
    </message>
    <message>
        <source>adapter, 3.3 V</source>
        <translation>アダプタ、3.3 V</translation>
    </message>
    <message>
        <source>Drawing: the jumper connects AUX1 and AUX2; adapter TX to board RX, RX to TX, 3.3 V, GND</source>
        <translation>図: ジャンパで AUX1 と AUX2 を接続。アダプタの TX を基板の RX に、RX を TX に、3.3 V、GND</translation>
    </message>
    <message>
        <source>Drawing: the jumper between AUX1 and AUX2 is taken out</source>
        <translation>図: AUX1 と AUX2 の間のジャンパを外した状態</translation>
    </message>
    <message>
        <source>open: nothing is connected, the pin is high</source>
        <translation>開放: 何も接続せず、端子は high</translation>
    </message>
    <message>
        <source>connected to GND: the pin is low</source>
        <translation>GND に接続: 端子は low</translation>
    </message>
    <message>
        <source>Find the gain scales</source>
        <translation>ゲインスケールの測定</translation>
    </message>
    <message>
        <source>The maker does not tell what a raw gain is worth. The motor of one axis is turned to and fro for one to two minutes, with the power that you allow here: first with constant power, then with one gain alone at a time, which grows until the motor moves. The shaft must turn freely, some turns each way, and nobody may touch it. Gains and limits are put back at the end.</source>
        <translation>ゲインの生値の意味をメーカーは公開していません。1 軸のモーターを、ここで許可した出力で 1 ～ 2 分間往復させます: まず一定出力で、次にゲインを 1 つずつ、モーターが動くまで増やします。シャフトは各方向に数回転、自由に回れる必要があり、誰も触れてはいけません。ゲインと制限は最後に元に戻します。</translation>
    </message>
    <message>
        <source>Find the input polarity</source>
        <translation>入力極性の判定</translation>
    </message>
    <message>
        <source>Data sheet and the maker&apos;s library give the polarity of the inputs opposite bits. The input of one axis is set up with both, and the status bit tells which of them is active at the level that the pin has. Nothing moves, the counter stays, and the input is set up afterwards as it was.</source>
        <translation>入力の極性ビットが、データシートとメーカーのライブラリで逆になっています。1 軸の入力を両方の設定にし、端子の現在のレベルでどちらがアクティブかを状態ビットで判定します。何も動かず、カウンタも変わりません。入力の設定は後で元に戻します。</translation>
    </message>
    <message>
        <source>The input pin of this axis is</source>
        <translation>この軸の入力端子の状態</translation>
    </message>
    <message>
        <source>encoder glitch</source>
        <translation>エンコーダの異常パルス</translation>
    </message>
    <message>
        <source>overspeed</source>
        <translation>過速度</translation>
    </message>
    <message>
        <source>Close the jumper</source>
        <translation>ジャンパの取付け</translation>
    </message>
    <message>
        <source>Put a jumper on AUX1 and AUX2. The serial adapter has 3.3 V levels, its TX goes to RX and its RX to TX; the board gets 3.3 V only.</source>
        <translation>AUX1 と AUX2 にジャンパを付けます。シリアルアダプタは 3.3 V レベルで、TX を RX に、RX を TX に接続します。基板に与えるのは 3.3 V だけです。</translation>
    </message>
    <message>
        <source>Reset the board</source>
        <translation>基板のリセット</translation>
    </message>
    <message>
        <source>Press its reset, or switch it off and on. Where the reset line is wired, this program pulses it.</source>
        <translation>基板のリセットを押すか、電源を入れ直します。リセット線が配線されていれば、このプログラムがパルスを出力します。</translation>
    </message>
    <message>
        <source>The bootloader greets</source>
        <translation>ブートローダの起動メッセージ</translation>
    </message>
    <message>
        <source>Its greeting on the serial port holds the word &quot;bootloader&quot;.</source>
        <translation>シリアルポートの起動メッセージに &quot;bootloader&quot; という語が含まれます。</translation>
    </message>
    <message>
        <source>The file is sent</source>
        <translation>ファイルの送信</translation>
    </message>
    <message>
        <source>Line by line, each after the confirmation of the one before. Leave the jumper where it is.</source>
        <translation>前の行の確認を待って 1 行ずつ送信します。ジャンパはそのままにしてください。</translation>
    </message>
    <message>
        <source>Take the jumper out</source>
        <translation>ジャンパの取外し</translation>
    </message>
    <message>
        <source>Then the board starts its new firmware. If it does not, reset it once more.</source>
        <translation>その後、基板が新しいファームウェアを起動します。起動しない場合は、もう一度リセットしてください。</translation>
    </message>
    <message>
        <source>The version is compared</source>
        <translation>バージョンの照合</translation>
    </message>
    <message>
        <source>The board is asked for it over SPI.</source>
        <translation>SPI 経由で基板に問い合わせます。</translation>
    </message>
    <message>
        <source>A board that is cut stays in its bootloader. Leave the jumper in and run the update again.</source>
        <translation>中断された基板はブートローダに留まります。ジャンパを付けたまま更新を再実行してください。</translation>
    </message>
    <message>
        <source>Channel 1</source>
        <translation>チャネル 1</translation>
    </message>
    <message>
        <source>Channel 2</source>
        <translation>チャネル 2</translation>
    </message>
    <message>
        <source>Channel 3</source>
        <translation>チャネル 3</translation>
    </message>
    <message>
        <source>Channel 4</source>
        <translation>チャネル 4</translation>
    </message>
    <message>
        <source>Stream and velocity</source>
        <translation>ストリームと速度</translation>
    </message>
    <message>
        <source>disabled</source>
        <translation>無効</translation>
    </message>
    <message>
        <source>home switch</source>
        <translation>原点スイッチ</translation>
    </message>
    <message>
        <source>index pulse</source>
        <translation>インデックスパルス</translation>
    </message>
    <message>
        <source>both edges</source>
        <translation>両エッジ</translation>
    </message>
    <message>
        <source>active high</source>
        <translation>アクティブハイ</translation>
    </message>
    <message>
        <source>active low</source>
        <translation>アクティブロー</translation>
    </message>
    <message>
        <source>record at the positive end</source>
        <translation>正側の端で記録</translation>
    </message>
    <message>
        <source>set at the positive end</source>
        <translation>正側の端で設定</translation>
    </message>
    <message>
        <source>record at the negative end</source>
        <translation>負側の端で記録</translation>
    </message>
    <message>
        <source>set at the negative end</source>
        <translation>負側の端で設定</translation>
    </message>
    <message>
        <source>Of the position loop, in the board&apos;s own units, whose scale is not documented. Cannot be read back; the four are sent together.</source>
        <translation>位置ループの値。基板独自の単位で、スケールは文書化されていません。読み戻せません。4 つ一括で送信します。</translation>
    </message>
    <message>
        <source>Bound of the position loop&apos;s integral, in power units: 8191 is full power. Cannot be read back.</source>
        <translation>位置ループの積分の上限、出力単位: 8191 が最大出力。読み戻せません。</translation>
    </message>
    <message>
        <source>Of the velocity loop, in the board&apos;s own units, whose scale is not documented. Cannot be read back; the three are sent together.</source>
        <translation>速度ループの値。基板独自の単位で、スケールは文書化されていません。読み戻せません。3 つ一括で送信します。</translation>
    </message>
    <message>
        <source>Greatest power in every mode, 1 is full. What the board starts with is not documented: begin small. Cannot be read back.</source>
        <translation>全モードでの最大出力、1 が最大。基板の初期値は文書化されていません: 小さい値から始めてください。読み戻せません。</translation>
    </message>
    <message>
        <source>Greatest speed in both closed loops. What the board starts with is not documented. Cannot be read back.</source>
        <translation>両方の閉ループでの最大速度。基板の初期値は文書化されていません。読み戻せません。</translation>
    </message>
    <message>
        <source>Greatest acceleration in both closed loops; 0 is no limit. Cannot be read back.</source>
        <translation>両方の閉ループでの最大加速度。0 は制限なし。読み戻せません。</translation>
    </message>
    <message>
        <source>What the input of the channel is for. Cannot be read back; the five values of an input are sent together.</source>
        <translation>チャネルの入力の用途。読み戻せません。入力の 5 つの値は一括で送信します。</translation>
    </message>
    <message>
        <source>At which level the input is active. Data sheet and the maker&apos;s library say it with opposite bits: which one the board follows is a setting of the device, and an experiment tells.</source>
        <translation>入力がアクティブになるレベル。データシートとメーカーのライブラリではビットが逆です: 基板がどちらに従うかは機器の設定で指定し、実験で確認できます。</translation>
    </message>
    <message>
        <source>At which end of the switch the position is recorded, or also set as the counter. Data sheet and library disagree, as for the polarity.</source>
        <translation>スイッチのどちらの端で位置を記録するか、さらにカウンタに設定するか。極性と同様、データシートとライブラリで一致しません。</translation>
    </message>
    <message>
        <source>Distance between the two ends of the switch; 0 is a single end stop. Cannot be read back.</source>
        <translation>スイッチの両端の間隔。0 は片側のエンドストップ。読み戻せません。</translation>
    </message>
    <message>
        <source>What the counter becomes at the edge. Cannot be read back.</source>
        <translation>エッジでカウンタに設定する値。読み戻せません。</translation>
    </message>
    <message>
        <source>What the board sends of this channel: bits 0 and 1 size of the position, 2 relative, 3 velocity, 5 status. The program needs the full position.</source>
        <translation>基板がこのチャネルについて送信する内容: ビット 0 と 1 位置のサイズ、2 相対、3 速度、5 状態。プログラムには完全な位置が必要です。</translation>
    </message>
    <message>
        <source>The encoder&apos;s counter. Writing it moves the zero, not the motor.</source>
        <translation>エンコーダのカウンタ。書き込むとモーターではなく原点が移動します。</translation>
    </message>
    <message>
        <source>Of the telemetry, in units of 40.96 µs: 244 is 10 ms, 49 is 2 ms, 0 is off.</source>
        <translation>テレメトリの周期、40.96 µs 単位: 244 で 10 ms、49 で 2 ms、0 はオフ。</translation>
    </message>
    <message>
        <source>What a stream packet has besides: bit 0 timing, bit 1 number of skipped periods.</source>
        <translation>ストリームパケットの追加内容: ビット 0 時間情報、ビット 1 飛ばした周期の数。</translation>
    </message>
    <message>
        <source>Edges, times four, over which velocity is measured: fewer is faster and coarser. 8 is good for tuning.</source>
        <translation>速度の測定に使うエッジ数 (× 4): 少ないほど速く、粗くなります。調整には 8 が適します。</translation>
    </message>
    <message>
        <source>Longest time over which velocity is measured: 2 to this power, times 0.64 µs; 20 is 671 ms.</source>
        <translation>速度の測定に使う最長時間: 2 のこの値乗 × 0.64 µs。20 で 671 ms。</translation>
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
        <translation>位置ワインドアップ</translation>
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
        <translation>出力制限</translation>
    </message>
    <message>
        <source>Velocity limit</source>
        <translation>速度制限</translation>
    </message>
    <message>
        <source>Acceleration limit</source>
        <translation>加速度制限</translation>
    </message>
    <message>
        <source>Input mode</source>
        <translation>入力モード</translation>
    </message>
    <message>
        <source>Input polarity</source>
        <translation>入力極性</translation>
    </message>
    <message>
        <source>Input edge</source>
        <translation>入力エッジ</translation>
    </message>
    <message>
        <source>Input spacing</source>
        <translation>入力間隔</translation>
    </message>
    <message>
        <source>Input position</source>
        <translation>入力位置</translation>
    </message>
    <message>
        <source>Data mask</source>
        <translation>データマスク</translation>
    </message>
    <message>
        <source>Position counter</source>
        <translation>位置カウンタ</translation>
    </message>
    <message>
        <source>Stream period</source>
        <translation>ストリーム周期</translation>
    </message>
    <message>
        <source>Stream contents</source>
        <translation>ストリーム内容</translation>
    </message>
    <message>
        <source>History length</source>
        <translation>履歴長</translation>
    </message>
    <message>
        <source>History time bits</source>
        <translation>履歴時間ビット</translation>
    </message>
    <message>
        <source>Input</source>
        <translation>入力</translation>
    </message>
    <message>
        <source>the port cannot be opened</source>
        <translation>ポートを開けません</translation>
    </message>
    <message>
        <source>check its name and that it is plugged in</source>
        <translation>名前と、接続されていることを確認してください</translation>
    </message>
    <message>
        <source>avrdude finds no such programmer on USB</source>
        <translation>avrdude が USB 上にこの書込み器を検出できません</translation>
    </message>
    <message>
        <source>plug it in, and check that its kind is the one named after avrdude:</source>
        <translation>接続し、種類が avrdude: の後の名前と一致することを確認してください</translation>
    </message>
    <message>
        <source>run it again, with a shorter cable</source>
        <translation>ケーブルを短くして再実行してください</translation>
    </message>
    <message>
        <source>the programmer is there, but no microcontroller answers it</source>
        <translation>書込み器はありますが、マイクロコントローラが応答しません</translation>
    </message>
    <message>
        <source>check the six pins and the supply</source>
        <translation>6 本のピンと電源を確認してください</translation>
    </message>
    <message>
        <source>avrdude knows no programmer of this name</source>
        <translation>avrdude にこの名前の書込み器はありません</translation>
    </message>
    <message>
        <source>&apos;avrdude -c ?&apos; lists them</source>
        <translation>&apos;avrdude -c ?&apos; で一覧を表示できます</translation>
    </message>
    <message>
        <source>the port may not be opened</source>
        <translation>ポートを開く権限がありません</translation>
    </message>
    <message>
        <source>add yourself to the group dialout and log in again</source>
        <translation>グループ dialout に自分を追加し、ログインし直してください</translation>
    </message>
    <message>
        <source>what answers is no ATmega328P</source>
        <translation>応答したものは ATmega328P ではありません</translation>
    </message>
    <message>
        <source>check that the programmer sits on the controller</source>
        <translation>書込み器がコントローラに接続されていることを確認してください</translation>
    </message>
    <message>
        <source>no bootloader answers</source>
        <translation>ブートローダが応答しません</translation>
    </message>
    <message>
        <source>restart the controller just before the start, or use a programmer on its pins</source>
        <translation>開始の直前にコントローラを再起動するか、ピンに接続する書込み器を使用してください</translation>
    </message>
    <message>
        <source>nothing answers the programmer</source>
        <translation>書込み器に応答がありません</translation>
    </message>
    <message>
        <source>check its cable and the supply of the controller</source>
        <translation>ケーブルとコントローラの電源を確認してください</translation>
    </message>
    <message>
        <source>Velocity as reported</source>
        <translation>報告された速度</translation>
    </message>
    <message>
        <source>Position in the turn</source>
        <translation>回転内の位置</translation>
    </message>
    <message>
        <source>Analog input 1</source>
        <translation>アナログ入力 1</translation>
    </message>
    <message>
        <source>Analog input 2</source>
        <translation>アナログ入力 2</translation>
    </message>
    <message>
        <source>Analog input 3</source>
        <translation>アナログ入力 3</translation>
    </message>
    <message>
        <source>Analog input 4</source>
        <translation>アナログ入力 4</translation>
    </message>
    <message>
        <source>Digital inputs</source>
        <translation>デジタル入力</translation>
    </message>
    <message>
        <source>the motor stalled</source>
        <translation>モーターがストールしました</translation>
    </message>
    <message>
        <source>the position left its range upwards</source>
        <translation>位置が範囲を上側に外れました</translation>
    </message>
    <message>
        <source>the position left its range downwards</source>
        <translation>位置が範囲を下側に外れました</translation>
    </message>
    <message>
        <source>it has no such command</source>
        <translation>そのコマンドはありません</translation>
    </message>
    <message>
        <source>wrong number of data bytes</source>
        <translation>データバイト数が正しくありません</translation>
    </message>
    <message>
        <source>a value that it does not take</source>
        <translation>受け付けられない値です</translation>
    </message>
    <message>
        <source>not possible while the motor is not started</source>
        <translation>モーターが始動していない間は実行できません</translation>
    </message>
    <message>
        <source>data bytes where none belong</source>
        <translation>不要な位置にデータバイトがあります</translation>
    </message>
    <message>
        <source>I2C: nobody answers</source>
        <translation>I2C: 応答なし</translation>
    </message>
    <message>
        <source>I2C: bus error</source>
        <translation>I2C: バスエラー</translation>
    </message>
    <message>
        <source>I2C: arbitration lost</source>
        <translation>I2C: アービトレーション負け</translation>
    </message>
    <message>
        <source>I2C: indeterminate state</source>
        <translation>I2C: 不定状態</translation>
    </message>
    <message>
        <source>I2C: the bus did not become ready</source>
        <translation>I2C: バスがレディになりません</translation>
    </message>
    <message>
        <source>I2C: sending took too long</source>
        <translation>I2C: 送信タイムアウト</translation>
    </message>
    <message>
        <source>I2C: receiving took too long</source>
        <translation>I2C: 受信タイムアウト</translation>
    </message>
    <message>
        <source>I2C: a packet was overwritten</source>
        <translation>I2C: パケットが上書きされました</translation>
    </message>
    <message>
        <source>I2C: a packet of wrong length</source>
        <translation>I2C: パケット長が不正</translation>
    </message>
    <message>
        <source>UART: out of memory</source>
        <translation>UART: メモリ不足</translation>
    </message>
    <message>
        <source>UART: framing error</source>
        <translation>UART: フレーミングエラー</translation>
    </message>
    <message>
        <source>UART: parity error</source>
        <translation>UART: パリティエラー</translation>
    </message>
    <message>
        <source>UART: receive buffer overflow</source>
        <translation>UART: 受信バッファのオーバーフロー</translation>
    </message>
    <message>
        <source>UART: data overrun (the datasheet means a framing error)</source>
        <translation>UART: データオーバーラン (データシートではフレーミングエラー)</translation>
    </message>
    <message>
        <source>UART: sending took too long (the datasheet means a parity error)</source>
        <translation>UART: 送信タイムアウト (データシートではパリティエラー)</translation>
    </message>
    <message>
        <source>UART: receive buffer overflow, by the datasheet&apos;s number</source>
        <translation>UART: 受信バッファのオーバーフロー (データシートの番号による)</translation>
    </message>
    <message>
        <source>UART: data overrun, by the datasheet&apos;s number</source>
        <translation>UART: データオーバーラン (データシートの番号による)</translation>
    </message>
    <message>
        <source>a frame paused for more than 50 ms</source>
        <translation>フレームが 50 ms を超えて途切れました</translation>
    </message>
    <message>
        <source>wrong checksum</source>
        <translation>チェックサムが不正</translation>
    </message>
    <message>
        <source>D1 and D2: what one count of the current converter stands for; D3 tells ampere.</source>
        <translation>D1 と D2: 電流変換器の 1 カウントの値。D3 はアンペアで通知します。</translation>
    </message>
    <message>
        <source>serial bootloader</source>
        <translation>シリアルブートローダ</translation>
    </message>
    <message>
        <source>serial bootloader, without reset</source>
        <translation>シリアルブートローダ、リセットなし</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>制御ループ</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>プロファイル</translation>
    </message>
    <message>
        <source>Digital lines</source>
        <translation>デジタル入出力線</translation>
    </message>
    <message>
        <source>Bus</source>
        <translation>バス</translation>
    </message>
    <message>
        <source>Errors</source>
        <translation>エラー</translation>
    </message>
    <message>
        <source>D1, D2: 1/65280 of full output per count of error; 4000 is full output at 16 counts. The scale of D3 is not documented.</source>
        <translation>D1、D2: 偏差 1 カウントあたり最大出力の 1/65280。4000 では 16 カウントで最大出力です。D3 のスケールは文書化されていません。</translation>
    </message>
    <message>
        <source>D1, D2: 1/16711680 of full output per count of error and loop of 1.024 ms. The bound of the integral follows P at the next restart only.</source>
        <translation>D1、D2: 偏差 1 カウント、ループ周期 1.024 ms あたり最大出力の 1/16711680。積分の上限は次の再起動時に初めて P に追従します。</translation>
    </message>
    <message>
        <source>D1, D2: 1/65280 of full output per count that the error changes in one loop of 1.024 ms.</source>
        <translation>D1、D2: ループ周期 1.024 ms の偏差変化 1 カウントあたり最大出力の 1/65280。</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>加速度</translation>
    </message>
    <message>
        <source>Of profiled moves. D1: at most 65535.</source>
        <translation>プロファイル動作の値。D1: 最大 65535。</translation>
    </message>
    <message>
        <source>Of profiled moves. D1: at most 65535. D1 and D2 may pass their target above 2500, and compute wrongly from 46340 on.</source>
        <translation>プロファイル動作の値。D1: 最大 65535。D1 と D2 は 2500 を超えると目標を行き過ぎることがあり、46340 以上では計算を誤ります。</translation>
    </message>
    <message>
        <source>Firmware of D1 and D2 stores it and does not limit anything.</source>
        <translation>D1 と D2 のファームウェアは保存するだけで、何も制限しません。</translation>
    </message>
    <message>
        <source>Time above the limit</source>
        <translation>制限超過時間</translation>
    </message>
    <message>
        <source>In force after a restart. D1 and D2 take it for the current limit until then; the limit is therefore written again behind it.</source>
        <translation>再起動後に有効になります。D1 と D2 はそれまでこの値を電流制限とみなすため、続けて電流制限を書き直します。</translation>
    </message>
    <message>
        <source>Outputs among the lines</source>
        <translation>出力に使う線</translation>
    </message>
    <message>
        <source>1, 2, 4, 8 for DIO1 to DIO4; a set bit makes an output. DIO1 and DIO3 low for 3 s start the analog programming of the device, DIO2 and DIO4 low restore its factory settings.</source>
        <translation>DIO1 ～ DIO4 が 1、2、4、8。ビットを立てると出力になります。DIO1 と DIO3 を 3 s 間 low にすると機器のアナログ設定が始まり、DIO2 と DIO4 を low にすると工場出荷時の設定に戻ります。</translation>
    </message>
    <message>
        <source>Levels of the outputs</source>
        <translation>出力レベル</translation>
    </message>
    <message>
        <source>Bits as for the directions; inputs ignore theirs. Cannot be read back and is lost at power-off.</source>
        <translation>ビットは方向と同じです。入力では無視されます。読み戻せず、電源を切ると失われます。</translation>
    </message>
    <message>
        <source>Node id</source>
        <translation>ノード ID</translation>
    </message>
    <message>
        <source>Its address on the line. In force after a restart; until then it answers under the old one.</source>
        <translation>回線上のアドレス。再起動後に有効になります。それまでは古いアドレスで応答します。</translation>
    </message>
    <message>
        <source>Acceptance mask</source>
        <translation>アクセプタンスマスク</translation>
    </message>
    <message>
        <source>Bits of an address that count. 255: only its own; less makes a group that acts on what is sent to any of its members, and on their answers. In force after a restart.</source>
        <translation>アドレスのうち有効なビット。255: 自分のアドレスのみ。それ以外ではグループとなり、メンバー宛の指令やメンバーの応答にも反応します。再起動後に有効になります。</translation>
    </message>
    <message>
        <source>Bit rate</source>
        <translation>ビットレート</translation>
    </message>
    <message>
        <source>In force after a restart. Reads as the rate at which it answers. 115200 is really 119048: prefer 57600.</source>
        <translation>再起動後に有効になります。読出し値は応答に使っている通信速度です。115200 は実際には 119048 です: 57600 を推奨します。</translation>
    </message>
    <message>
        <source>Error level</source>
        <translation>エラーレベル</translation>
    </message>
    <message>
        <source>D1 and D2. Level 1 would make every reading fail, so only 0 is offered: write it where another program set 1.</source>
        <translation>D1 と D2。レベル 1 では読出しがすべて失敗するため、0 だけを選択できます: 他のプログラムが 1 にした場合に書き込んでください。</translation>
    </message>
    <message>
        <source>Reactions to errors</source>
        <translation>エラー時の動作</translation>
    </message>
    <message>
        <source>D3. Two bits for each of 20 errors, the first lowest: 0 nothing, 1 stop, 2 halt. Which error is which is not documented.</source>
        <translation>D3。20 種のエラーに各 2 ビット、最初が最下位: 0 何もしない、1 stop、2 halt。各エラーの対応は文書化されていません。</translation>
    </message>
    <message>
        <source>Anti-windup</source>
        <translation>アンチワインドアップ</translation>
    </message>
    <message>
        <source>D3. Bound of the integral; its scale is not documented.</source>
        <translation>D3。積分の上限。スケールは文書化されていません。</translation>
    </message>
    <message>
        <source>Digital input 1</source>
        <translation>デジタル入力 1</translation>
    </message>
    <message>
        <source>Digital input 2</source>
        <translation>デジタル入力 2</translation>
    </message>
    <message>
        <source>Digital input 3</source>
        <translation>デジタル入力 3</translation>
    </message>
    <message>
        <source>Digital input 4</source>
        <translation>デジタル入力 4</translation>
    </message>
    <message>
        <source>by hand</source>
        <translation>手動</translation>
    </message>
    <message>
        <source>as found</source>
        <translation>当初の状態</translation>
    </message>
    <message>
        <source>before restore</source>
        <translation>復元前</translation>
    </message>
    <message>
        <source>before import</source>
        <translation>インポート前</translation>
    </message>
    <message>
        <source>before tuning</source>
        <translation>調整前</translation>
    </message>
    <message>
        <source>before update</source>
        <translation>更新前</translation>
    </message>
    <message>
        <source>%1 % of the samples were lost in a second</source>
        <translation>1 秒間にサンプルの %1 % が欠落しました</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1 %2 is outside %3 … %4</source>
        <translation>%1 %2 は範囲 %3 … %4 の外です</translation>
    </message>
    <message>
        <source>%1 %2 is outside %3 … %4 %5</source>
        <translation>%1 %2 は範囲 %3 … %4 %5 の外です</translation>
    </message>
    <message>
        <source>%1 %2 is outside %3 … %4, what firmware of dialect %5 takes</source>
        <translation>%1 %2 は、ダイアレクト %5 のファームウェアが受け付ける範囲 %3 … %4 の外です</translation>
    </message>
    <message>
        <source>%1 %2 is outside the envelope, which ends at %3</source>
        <translation>%1 %2 は動作範囲の外です（上限 %3）</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>%1 (code %2)</source>
        <translation>%1 (コード %2)</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 と %2</translation>
    </message>
    <message>
        <source>%1 at %2 % duty</source>
        <translation>%1 (デューティ %2 %)</translation>
    </message>
    <message>
        <source>%1 at byte %2</source>
        <translation>%1 (バイト %2)</translation>
    </message>
    <message>
        <source>%1 becomes %2, it was %3: the device stores it</source>
        <translation>%1 は %3 から %2 になります: 機器が保存します</translation>
    </message>
    <message>
        <source>%1 becomes %2: the device stores it</source>
        <translation>%1 は %2 になります: 機器が保存します</translation>
    </message>
    <message>
        <source>%1 begins no line of such a log</source>
        <translation>%1 で始まる行はこの種のログにありません</translation>
    </message>
    <message>
        <source>%1 belongs to the unit that the file was saved from</source>
        <translation>%1 はファイルの保存元の機器に固有です</translation>
    </message>
    <message>
        <source>%1 bit/s is no rate of a serial line</source>
        <translation>%1 bit/s はシリアル回線の通信速度ではありません</translation>
    </message>
    <message>
        <source>%1 bytes</source>
        <translation>%1 バイト</translation>
    </message>
    <message>
        <source>%1 cannot be made</source>
        <translation>%1 を作成できません</translation>
    </message>
    <message>
        <source>%1 cannot be made: %2</source>
        <translation>%1 を作成できません: %2</translation>
    </message>
    <message>
        <source>%1 cannot be opened: %2</source>
        <translation>%1 を開けません: %2</translation>
    </message>
    <message>
        <source>%1 cannot be painted</source>
        <translation>%1 を描画できません</translation>
    </message>
    <message>
        <source>%1 cannot be read from the device</source>
        <translation>%1 は機器から読み出せません</translation>
    </message>
    <message>
        <source>%1 cannot be read, so it could not be put back</source>
        <translation>%1 は読み出せないため、元に戻せません</translation>
    </message>
    <message>
        <source>%1 cannot be read: %2</source>
        <translation>%1 を読み出せません: %2</translation>
    </message>
    <message>
        <source>%1 cannot be restarted from here</source>
        <translation>%1 はここから再起動できません</translation>
    </message>
    <message>
        <source>%1 cannot be started: %2</source>
        <translation>%1 を起動できません: %2</translation>
    </message>
    <message>
        <source>%1 cannot be written</source>
        <translation>%1 に書き込めません</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2</source>
        <translation>%1 を書き込めません: %2</translation>
    </message>
    <message>
        <source>%1 cannot do %2 bit/s</source>
        <translation>%1 は %2 bit/s に対応できません</translation>
    </message>
    <message>
        <source>%1 cannot do %2 bit/s: %3</source>
        <translation>%1 は %2 bit/s に対応できません: %3</translation>
    </message>
    <message>
        <source>%1 cannot do %2: %3</source>
        <translation>%1 は %2 を実行できません: %3</translation>
    </message>
    <message>
        <source>%1 cannot do SPI mode 1 at this speed</source>
        <translation>%1 はこの速度では SPI モード 1 に対応できません</translation>
    </message>
    <message>
        <source>%1 cannot take old samples: %2</source>
        <translation>%1 は古いサンプルを取り込めません: %2</translation>
    </message>
    <message>
        <source>%1 could not be measured</source>
        <translation>%1 を測定できませんでした</translation>
    </message>
    <message>
        <source>%1 data bytes are announced, %2 are there</source>
        <translation>データバイト数は %1 と示されていますが、%2 です</translation>
    </message>
    <message>
        <source>%1 did not come back within %2</source>
        <translation>%1 は %2 以内に復帰しませんでした</translation>
    </message>
    <message>
        <source>%1 digits, an even number is needed</source>
        <translation>%1 桁です。偶数桁が必要です</translation>
    </message>
    <message>
        <source>%1 does not answer</source>
        <translation>%1 が応答しません</translation>
    </message>
    <message>
        <source>%1 does not answer: %2</source>
        <translation>%1 が応答しません: %2</translation>
    </message>
    <message>
        <source>%1 does not exist in this device&apos;s dialect</source>
        <translation>%1 はこの機器のダイアレクトにありません</translation>
    </message>
    <message>
        <source>%1 does not open: its driver has not answered for %2 s</source>
        <translation>%1 を開けません: ドライバが %2 s 間応答していません</translation>
    </message>
    <message>
        <source>%1 does not tell its position</source>
        <translation>%1 は位置を通知しません</translation>
    </message>
    <message>
        <source>%1 exists and is no socket</source>
        <translation>%1 は存在しますが、ソケットではありません</translation>
    </message>
    <message>
        <source>%1 failed (%2)</source>
        <translation>%1 が失敗しました (%2)</translation>
    </message>
    <message>
        <source>%1 failed: %2</source>
        <translation>%1 が失敗しました: %2</translation>
    </message>
    <message>
        <source>%1 frames recorded, %2 are missing</source>
        <translation>%1 フレームを記録、%2 欠落</translation>
    </message>
    <message>
        <source>%1 frames recorded, none is missing</source>
        <translation>%1 フレームを記録、欠落なし</translation>
    </message>
    <message>
        <source>%1 frames were lost, the kernel keeps only %2 for this program</source>
        <translation>%1 フレームが失われました。カーネルがこのプログラム用に保持するのは %2 だけです</translation>
    </message>
    <message>
        <source>%1 has %2 axes and %3 sets of gains</source>
        <translation>%1 には %2 個の軸と %3 組のゲインがあります</translation>
    </message>
    <message>
        <source>%1 has a name that ends in no kind of picture</source>
        <translation>%1 の拡張子はどの画像形式にも該当しません</translation>
    </message>
    <message>
        <source>%1 has a name that ends in no kind of report</source>
        <translation>%1 の拡張子はどのレポート形式にも該当しません</translation>
    </message>
    <message>
        <source>%1 has no %2</source>
        <translation>%1 に %2 はありません</translation>
    </message>
    <message>
        <source>%1 has no &apos;%2&apos; to be set</source>
        <translation>%1 には設定できる「%2」がありません</translation>
    </message>
    <message>
        <source>%1 has no buffered moves</source>
        <translation>%1 にはバッファ動作がありません</translation>
    </message>
    <message>
        <source>%1 has no channel of samples</source>
        <translation>%1 にはサンプルのチャネルがありません</translation>
    </message>
    <message>
        <source>%1 has no command that zeroes its position</source>
        <translation>%1 には位置をゼロにするコマンドがありません</translation>
    </message>
    <message>
        <source>%1 has no dialect &apos;%2&apos;</source>
        <translation>%1 にダイアレクト「%2」はありません</translation>
    </message>
    <message>
        <source>%1 has no duty command</source>
        <translation>%1 にはデューティ指令がありません</translation>
    </message>
    <message>
        <source>%1 has no duty command, so &apos;%2&apos; is not measured</source>
        <translation>%1 にはデューティ指令がないため、「%2」は測定しません</translation>
    </message>
    <message>
        <source>%1 has no firmware update here</source>
        <translation>%1 のファームウェアはここでは更新できません</translation>
    </message>
    <message>
        <source>%1 has no frame in it</source>
        <translation>%1 にフレームがありません</translation>
    </message>
    <message>
        <source>%1 has no frame of %2</source>
        <translation>%1 に %2 のフレームがありません</translation>
    </message>
    <message>
        <source>%1 has no loop &apos;%2&apos; that can be tried</source>
        <translation>%1 には試せる制御ループ「%2」がありません</translation>
    </message>
    <message>
        <source>%1 has no loop &apos;%2&apos; that can be tuned</source>
        <translation>%1 には調整できる制御ループ「%2」がありません</translation>
    </message>
    <message>
        <source>%1 has no loop that can be tried</source>
        <translation>%1 には試せる制御ループがありません</translation>
    </message>
    <message>
        <source>%1 has no number that could be set</source>
        <translation>%1 には設定できる番号がありません</translation>
    </message>
    <message>
        <source>%1 has no option &apos;%2&apos;</source>
        <translation>%1 にオプション「%2」はありません</translation>
    </message>
    <message>
        <source>%1 has no samples</source>
        <translation>%1 にサンプルがありません</translation>
    </message>
    <message>
        <source>%1 has no setting that could be written to every unit</source>
        <translation>%1 には全機器に書き込める設定がありません</translation>
    </message>
    <message>
        <source>%1 has no such limit of its own, so nothing bounds the motor</source>
        <translation>%1 自身にはその制限がなく、モーターは何にも制限されません</translation>
    </message>
    <message>
        <source>%1 has not told where it stands</source>
        <translation>%1 が位置を通知していません</translation>
    </message>
    <message>
        <source>%1 holds no limits of experiments</source>
        <translation>%1 に実験の制限がありません</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>%1 in its bootloader instead of %2</source>
        <translation>%2 ではなくブートローダの %1</translation>
    </message>
    <message>
        <source>%1 instead of %2</source>
        <translation>%2 ではなく %1</translation>
    </message>
    <message>
        <source>%1 is %2</source>
        <translation>%1 は %2 です</translation>
    </message>
    <message>
        <source>%1 is %2, %3</source>
        <translation>%1 は %2、%3</translation>
    </message>
    <message>
        <source>%1 is a device and has no end</source>
        <translation>%1 はデバイスであり、終わりがありません</translation>
    </message>
    <message>
        <source>%1 is a folder</source>
        <translation>%1 はフォルダです</translation>
    </message>
    <message>
        <source>%1 is a network interface, but not one for CAN</source>
        <translation>%1 はネットワークインターフェースですが、CAN 用ではありません</translation>
    </message>
    <message>
        <source>%1 is a recording: it can be watched, not written to or driven</source>
        <translation>%1 は記録です: 監視はできますが、書込みや駆動はできません</translation>
    </message>
    <message>
        <source>%1 is back</source>
        <translation>%1 が復帰しました</translation>
    </message>
    <message>
        <source>%1 is being opened already</source>
        <translation>%1 はすでに開いている途中です</translation>
    </message>
    <message>
        <source>%1 is being recorded already</source>
        <translation>%1 はすでに記録中です</translation>
    </message>
    <message>
        <source>%1 is bus-off</source>
        <translation>%1 はバスオフです</translation>
    </message>
    <message>
        <source>%1 is busy: it serves one client at a time</source>
        <translation>%1 はビジーです: 同時に接続できるクライアントは 1 つです</translation>
    </message>
    <message>
        <source>%1 is damaged and cannot be put aside</source>
        <translation>%1 は破損しており、退避できません</translation>
    </message>
    <message>
        <source>%1 is error-passive</source>
        <translation>%1 はエラーパッシブです</translation>
    </message>
    <message>
        <source>%1 is error-warning</source>
        <translation>%1 はエラーワーニングです</translation>
    </message>
    <message>
        <source>%1 is gone</source>
        <translation>%1 がなくなりました</translation>
    </message>
    <message>
        <source>%1 is in use by another program</source>
        <translation>%1 は別のプログラムが使用中です</translation>
    </message>
    <message>
        <source>%1 is locked by another program</source>
        <translation>%1 は別のプログラムがロックしています</translation>
    </message>
    <message>
        <source>%1 is lost: %2; waiting up to %3 for it to come back</source>
        <translation>%1 が切断されました: %2。復帰を最大 %3 待ちます</translation>
    </message>
    <message>
        <source>%1 is missing</source>
        <translation>%1 がありません</translation>
    </message>
    <message>
        <source>%1 is never part of an experiment</source>
        <translation>%1 は実験の対象になりません</translation>
    </message>
    <message>
        <source>%1 is no CAN identifier in dec</source>
        <translation>%1 は 10 進数の CAN 識別子ではありません</translation>
    </message>
    <message>
        <source>%1 is no CAN identifier in hex</source>
        <translation>%1 は 16 進数の CAN 識別子ではありません</translation>
    </message>
    <message>
        <source>%1 is no CAN link</source>
        <translation>%1 は CAN リンクではありません</translation>
    </message>
    <message>
        <source>%1 is no device profile</source>
        <translation>%1 は機器プロファイルではありません</translation>
    </message>
    <message>
        <source>%1 is no list of devices and is ignored: the next scan takes its full time and writes it anew</source>
        <translation>%1 は機器一覧ではないため無視します: 次のスキャンは全時間をかけて行い、書き直します</translation>
    </message>
    <message>
        <source>%1 is no project of this version</source>
        <translation>%1 はこのバージョンのプロジェクトではありません</translation>
    </message>
    <message>
        <source>%1 is no recording</source>
        <translation>%1 は記録ではありません</translation>
    </message>
    <message>
        <source>%1 is no serial port</source>
        <translation>%1 はシリアルポートではありません</translation>
    </message>
    <message>
        <source>%1 is no time stamp</source>
        <translation>%1 はタイムスタンプではありません</translation>
    </message>
    <message>
        <source>%1 is not a file</source>
        <translation>%1 はファイルではありません</translation>
    </message>
    <message>
        <source>%1 is not a hexadecimal digit</source>
        <translation>%1 は 16 進数字ではありません</translation>
    </message>
    <message>
        <source>%1 is not an MCAP file</source>
        <translation>%1 は MCAP ファイルではありません</translation>
    </message>
    <message>
        <source>%1 is not an object</source>
        <translation>%1 はオブジェクトではありません</translation>
    </message>
    <message>
        <source>%1 is not in this program</source>
        <translation>%1 はこのプログラムにありません</translation>
    </message>
    <message>
        <source>%1 is not installed</source>
        <translation>%1 はインストールされていません</translation>
    </message>
    <message>
        <source>%1 is not known to firmware of dialect %2</source>
        <translation>%1 はダイアレクト %2 のファームウェアにありません</translation>
    </message>
    <message>
        <source>%1 is not open</source>
        <translation>%1 は開いていません</translation>
    </message>
    <message>
        <source>%1 is not updated over its own link</source>
        <translation>%1 は自身のリンク経由では更新できません</translation>
    </message>
    <message>
        <source>%1 is read-only</source>
        <translation>%1 は読出し専用です</translation>
    </message>
    <message>
        <source>%1 is served by another program already</source>
        <translation>%1 はすでに別のプログラムが提供しています</translation>
    </message>
    <message>
        <source>%1 is served by another simulator</source>
        <translation>%1 は別のシミュレータが提供しています</translation>
    </message>
    <message>
        <source>%1 is switched off</source>
        <translation>%1 はオフです</translation>
    </message>
    <message>
        <source>%1 is there already and no link to a terminal</source>
        <translation>%1 はすでに存在し、端末へのリンクではありません</translation>
    </message>
    <message>
        <source>%1 is updated over its own link</source>
        <translation>%1 の更新は自身のリンク経由で行います</translation>
    </message>
    <message>
        <source>%1 is used by another program</source>
        <translation>%1 は別のプログラムが使用しています</translation>
    </message>
    <message>
        <source>%1 lines, %2 bytes; the file does not name its version</source>
        <translation>%1 行、%2 バイト。ファイルにバージョンの記載はありません</translation>
    </message>
    <message>
        <source>%1 links are not supported yet</source>
        <translation>%1 リンクにはまだ対応していません</translation>
    </message>
    <message>
        <source>%1 needs a number</source>
        <translation>%1 には数値が必要です</translation>
    </message>
    <message>
        <source>%1 of %2 lines were confirmed. The bootloader keeps waiting: leave the jumper in and run the update again</source>
        <translation>%2 行中 %1 行が確認されました。ブートローダは待機を続けています: ジャンパを付けたまま更新を再実行してください</translation>
    </message>
    <message>
        <source>%1 of %2 settings were written again; %3: %4</source>
        <translation>%2 個中 %1 個の設定を再書込みしました。%3: %4</translation>
    </message>
    <message>
        <source>%1 of %2 settings were written again; then the board was reset once more</source>
        <translation>%2 個中 %1 個の設定を再書込みしましたが、その後基板が再びリセットされました</translation>
    </message>
    <message>
        <source>%1 of the recipe read back different, first %2</source>
        <translation>レシピの値のうち %1 個の読み戻し値が異なります、最初は %2</translation>
    </message>
    <message>
        <source>%1 only listens, nothing can be sent</source>
        <translation>%1 はリッスンオンリーのため送信できません</translation>
    </message>
    <message>
        <source>%1 parameters gave no answer</source>
        <translation>%1 個のパラメータが応答しませんでした</translation>
    </message>
    <message>
        <source>%1 said nothing for a minute and was ended</source>
        <translation>%1 は 1 分間応答がなかったため終了しました</translation>
    </message>
    <message>
        <source>%1 said nothing for too long</source>
        <translation>%1 からの応答が長く途絶えています</translation>
    </message>
    <message>
        <source>%1 settings written again</source>
        <translation>%1 個の設定を再書込みしました</translation>
    </message>
    <message>
        <source>%1 takes no frames: %2 wait to be sent</source>
        <translation>%1 がフレームを受け付けません: %2 個が送信待ちです</translation>
    </message>
    <message>
        <source>%1 to number %2: %3</source>
        <translation>%1 を番号 %2 へ: %3</translation>
    </message>
    <message>
        <source>%1 transmit and %2 receive errors</source>
        <translation>送信エラー %1、受信エラー %2</translation>
    </message>
    <message>
        <source>%1 units answer as number %2</source>
        <translation>%1 台の機器が番号 %2 で応答しています</translation>
    </message>
    <message>
        <source>%1 values are not what they were left as; the history has both</source>
        <translation>%1 個の値が前回終了時と異なります。両方とも履歴にあります</translation>
    </message>
    <message>
        <source>%1 was %2 and is not known to be cleared</source>
        <translation>%1 は %2 でした。クリアされたかどうかは不明です</translation>
    </message>
    <message>
        <source>%1 was changed while it was played</source>
        <translation>%1 は再生中に変更されました</translation>
    </message>
    <message>
        <source>%1 was closed before it was open</source>
        <translation>%1 は開く前に閉じられました</translation>
    </message>
    <message>
        <source>%1 was disconnected</source>
        <translation>%1 が取り外されました</translation>
    </message>
    <message>
        <source>%1 was made by a newer version of this program (schema %2, known here is %3)</source>
        <translation>%1 はこのプログラムの新しいバージョンで作成されました (スキーマ %2、対応しているのは %3)</translation>
    </message>
    <message>
        <source>%1 was not confirmed</source>
        <translation>%1 は確認されませんでした</translation>
    </message>
    <message>
        <source>%1 was refused: %2</source>
        <translation>%1 は拒否されました: %2</translation>
    </message>
    <message>
        <source>%1 was stopped: %2, %3</source>
        <translation>%1 は停止しました: %2、%3</translation>
    </message>
    <message>
        <source>%1 was switched off</source>
        <translation>%1 がオフになりました</translation>
    </message>
    <message>
        <source>%1 was unknown when the file was written</source>
        <translation>%1 はファイルの書出し時に不明でした</translation>
    </message>
    <message>
        <source>%1 was unplugged</source>
        <translation>%1 が取り外されました</translation>
    </message>
    <message>
        <source>%1 was written as %2 but reads %3</source>
        <translation>%1 は %2 を書き込みましたが、読出し値は %3 です</translation>
    </message>
    <message>
        <source>%1 where a record begins with a colon, is this an Intel HEX file?</source>
        <translation>レコード先頭のコロンがあるべき位置に %1 があります。Intel HEX ファイルですか?</translation>
    </message>
    <message>
        <source>%1 with %2 transmit and %3 receive errors</source>
        <translation>%1、送信エラー %2、受信エラー %3</translation>
    </message>
    <message>
        <source>%1 would be %2 of its smallest steps, too few to mean anything</source>
        <translation>%1 は最小刻みの %2 個分にしかならず、少なすぎて意味がありません</translation>
    </message>
    <message>
        <source>%1 would have to be %2, which it cannot be</source>
        <translation>%1 は %2 である必要がありますが、その値にはできません</translation>
    </message>
    <message>
        <source>%1 written, read back and equal</source>
        <translation>%1 を書き込み、読み戻して一致しました</translation>
    </message>
    <message>
        <source>%1 written; %2 of them cannot be read back</source>
        <translation>%1 個を書き込みました。うち %2 個は読み戻せません</translation>
    </message>
    <message>
        <source>%1 written; they cannot be read back</source>
        <translation>%1 を書き込みました。読み戻せません</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1、%2</translation>
    </message>
    <message>
        <source>%1, and the device switched its output off</source>
        <translation>%1。機器が出力をオフにしました</translation>
    </message>
    <message>
        <source>%1, line %2: %3</source>
        <translation>%1、%2 行目: %3</translation>
    </message>
    <message>
        <source>%1, more than half a step from its target</source>
        <translation>%1、目標からステップの半分を超えて離れています</translation>
    </message>
    <message>
        <source>%1, told to run at more than half a step</source>
        <translation>%1、ステップの半分を超える目標値で動作中です</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: %2 is above %3</source>
        <translation>%1: %2 は %3 を上回っています</translation>
    </message>
    <message>
        <source>%1: %2 is below %3</source>
        <translation>%1: %2 は %3 を下回っています</translation>
    </message>
    <message>
        <source>%1: %2 is not a whole number</source>
        <translation>%1: %2 は整数ではありません</translation>
    </message>
    <message>
        <source>%1: %2 of %3 ms is finer than the device follows, which takes a set-point every %4 ms</source>
        <translation>%1: %3 ms の %2 は機器が追従できる細かさを超えています。機器は %4 ms ごとに目標値を受け取ります</translation>
    </message>
    <message>
        <source>%1: &apos;%2&apos; is neither on nor off</source>
        <translation>%1: 「%2」は on でも off でもありません</translation>
    </message>
    <message>
        <source>%1: &apos;%2&apos; is not a number</source>
        <translation>%1: 「%2」は数値ではありません</translation>
    </message>
    <message>
        <source>%1: cannot be read (system error %2)</source>
        <translation>%1: 読み込めません (システムエラー %2)</translation>
    </message>
    <message>
        <source>%1: its value is of the wrong kind</source>
        <translation>%1: 値の種類が正しくありません</translation>
    </message>
    <message>
        <source>%1: its value says %2, its raw value %3</source>
        <translation>%1: 値は %2、生値は %3 です</translation>
    </message>
    <message>
        <source>%1: legal is %2</source>
        <translation>%1: 有効な値は %2 です</translation>
    </message>
    <message>
        <source>%1: legal is %2 … %3</source>
        <translation>%1: 有効な値は %2 … %3 です</translation>
    </message>
    <message>
        <source>%1: no permission to read it</source>
        <translation>%1: 読み込む権限がありません</translation>
    </message>
    <message>
        <source>%1: no such file</source>
        <translation>%1: ファイルがありません</translation>
    </message>
    <message>
        <source>%1: not a number</source>
        <translation>%1: 数値ではありません</translation>
    </message>
    <message>
        <source>%1: raw is not a whole number</source>
        <translation>%1: raw が整数ではありません</translation>
    </message>
    <message>
        <source>%1: raw value %2 is out of range</source>
        <translation>%1: 生値 %2 は範囲外です</translation>
    </message>
    <message>
        <source>%1: status %2 has no meaning</source>
        <translation>%1: 状態 %2 は未定義です</translation>
    </message>
    <message>
        <source>%1: the device answers &apos;%2&apos;</source>
        <translation>%1: 機器の応答は「%2」です</translation>
    </message>
    <message>
        <source>%1: the device refused the value</source>
        <translation>%1: 機器が値を拒否しました</translation>
    </message>
    <message>
        <source>%1: this firmware does not know the parameter</source>
        <translation>%1: このファームウェアにはこのパラメータがありません</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1。%2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no journal that stations share</source>
        <translation>「%1」は複数のステーションで共有するジャーナルではありません</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no number</source>
        <translation>「%1」は数値ではありません</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no path of a socket: it has 1 to 107 characters</source>
        <translation>「%1」はソケットのパスではありません: 1 ～ 107 文字です</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no time in seconds</source>
        <translation>「%1」は秒単位の時間ではありません</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no value for the option &apos;%2&apos; of %3</source>
        <translation>「%1」は %3 のオプション「%2」の値ではありません</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a device: LINK/FAMILY:ADDRESS is needed, such as sim:can/dmc60c:5</source>
        <translation>「%1」は機器ではありません: LINK/FAMILY:ADDRESS が必要です (例: sim:can/dmc60c:5)</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a link: SCHEME:PATH is needed, such as socketcan:can0 or sim:</source>
        <translation>「%1」はリンクではありません: SCHEME:PATH が必要です (例: socketcan:can0、sim:)</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a simulated device: %2</source>
        <translation>「%1」はシミュレーション機器ではありません: %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not qtcan:PLUGIN:INTERFACE</source>
        <translation>「%1」は qtcan:PLUGIN:INTERFACE の形式ではありません</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be a number</source>
        <translation>「%1」は数値でなければなりません</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be a text</source>
        <translation>「%1」は文字列でなければなりません</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be a whole number</source>
        <translation>「%1」は整数でなければなりません</translation>
    </message>
    <message>
        <source>a name has no line break, tabulator or other control character</source>
        <translation>名前には改行、タブ、その他の制御文字を使えません</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be an object in braces</source>
        <translation>「%1」は波括弧で囲んだオブジェクトでなければなりません</translation>
    </message>
    <message>
        <source>&apos;%1&apos; names no interface</source>
        <translation>「%1」にインターフェース名がありません</translation>
    </message>
    <message>
        <source>&apos;encoder&apos; is true: it counts both ways</source>
        <translation>&apos;encoder&apos; は true です: 両方向に計数します</translation>
    </message>
    <message>
        <source>&apos;motorbenchctl snapshots&apos; lists those there are</source>
        <translation>&apos;motorbenchctl snapshots&apos; で一覧を表示できます</translation>
    </message>
    <message>
        <source>&apos;motorbenchctl trials&apos; lists those there are</source>
        <translation>&apos;motorbenchctl trials&apos; で一覧を表示できます</translation>
    </message>
    <message>
        <source>&apos;store&apos; must be true or false</source>
        <translation>&apos;store&apos; は true または false でなければなりません</translation>
    </message>
    <message>
        <source>&apos;to&apos; is missing</source>
        <translation>&apos;to&apos; がありません</translation>
    </message>
    <message>
        <source>--font-scale takes 0.5 to 3</source>
        <translation>--font-scale は 0.5 ～ 3 です</translation>
    </message>
    <message>
        <source>--language takes one of %1</source>
        <translation>--language に指定できるのは %1 のいずれかです</translation>
    </message>
    <message>
        <source>--out &apos;%1&apos; is no picture</source>
        <translation>--out「%1」は画像ではありません</translation>
    </message>
    <message>
        <source>%1 is no report</source>
        <translation>%1 はレポートではありません</translation>
    </message>
    <message>
        <source>--out &apos;%1&apos; is no PDF</source>
        <translation>--out「%1」は PDF ではありません</translation>
    </message>
    <message>
        <source>--help tells what there is</source>
        <translation>--help で一覧を表示できます</translation>
    </message>
    <message>
        <source>--plot FILE or --report FILE, and --out FILE belong together</source>
        <translation>--plot FILE または --report FILE は、--out FILE と組み合わせて指定します</translation>
    </message>
    <message>
        <source>--size takes WIDTHxHEIGHT, such as 1280x800</source>
        <translation>--size は WIDTHxHEIGHT の形式です (例: 1280x800)</translation>
    </message>
    <message>
        <source>--target is missing</source>
        <translation>--target がありません</translation>
    </message>
    <message>
        <source>--target: &apos;%1&apos; is unknown</source>
        <translation>--target: 「%1」は不明です</translation>
    </message>
    <message>
        <source>--tour needs a folder for its pictures</source>
        <translation>--tour には画像用のフォルダが必要です</translation>
    </message>
    <message>
        <source>--via: &apos;%1&apos; is no way into a Supermodified</source>
        <translation>--via: 「%1」では Supermodified に接続できません</translation>
    </message>
    <message>
        <source>--via: &apos;%1&apos; is no way into an Abstract DC Drive</source>
        <translation>--via: 「%1」では Abstract DC Drive に接続できません</translation>
    </message>
    <message>
        <source>0 is no divisor</source>
        <translation>0 は除数にできません</translation>
    </message>
    <message>
        <source>1 byte</source>
        <translation>1 バイト</translation>
    </message>
    <message>
        <source>A programmer on the pins erases the chip first, the stored settings and the serial bootloader with it: save the parameters before. The bootloader keeps both.</source>
        <translation>ピンに接続する書込み器は、最初にチップ全体を消去し、保存された設定とシリアルブートローダも消します: 事前にパラメータを保存してください。ブートローダ経由ならどちらも残ります。</translation>
    </message>
    <message>
        <source>Abstract DC Drives are found on CAN links only</source>
        <translation>Abstract DC Drive は CAN リンクでのみ検出されます</translation>
    </message>
    <message>
        <source>Abstract DC Drives found: %1</source>
        <translation>Abstract DC Drive を検出: %1</translation>
    </message>
    <message>
        <source>Abstract DC Drives live on CAN links only</source>
        <translation>Abstract DC Drive は CAN リンク専用です</translation>
    </message>
    <message>
        <source>All pages written</source>
        <translation>全ページ書込み済み</translation>
    </message>
    <message>
        <source>Assign number</source>
        <translation>番号の割当て</translation>
    </message>
    <message>
        <source>Autotune</source>
        <translation>オートチューニング</translation>
    </message>
    <message>
        <source>CAN high is not connected</source>
        <translation>CAN high が未接続</translation>
    </message>
    <message>
        <source>CAN high is short to battery</source>
        <translation>CAN high がバッテリに短絡</translation>
    </message>
    <message>
        <source>CAN high is short to ground</source>
        <translation>CAN high がグランドに短絡</translation>
    </message>
    <message>
        <source>CAN high is short to supply</source>
        <translation>CAN high が電源に短絡</translation>
    </message>
    <message>
        <source>CAN low is not connected</source>
        <translation>CAN low が未接続</translation>
    </message>
    <message>
        <source>CAN low is short to CAN high</source>
        <translation>CAN low が CAN high に短絡</translation>
    </message>
    <message>
        <source>CAN low is short to battery</source>
        <translation>CAN low がバッテリに短絡</translation>
    </message>
    <message>
        <source>CAN low is short to ground</source>
        <translation>CAN low がグランドに短絡</translation>
    </message>
    <message>
        <source>CAN low is short to supply</source>
        <translation>CAN low が電源に短絡</translation>
    </message>
    <message>
        <source>CAN sockets cannot be opened: %1</source>
        <translation>CAN ソケットを開けません: %1</translation>
    </message>
    <message>
        <source>CRC refused, nothing was erased; trying variant %1</source>
        <translation>CRC が拒否されました。何も消去していません。方式 %1 を試します</translation>
    </message>
    <message>
        <source>Connecting through OpenOCD</source>
        <translation>OpenOCD で接続中</translation>
    </message>
    <message>
        <source>Connecting through avrdude</source>
        <translation>avrdude で接続中</translation>
    </message>
    <message>
        <source>Count from 0</source>
        <translation>0 から計数</translation>
    </message>
    <message>
        <source>DMC60C controllers are found on CAN links only</source>
        <translation>DMC60C コントローラは CAN リンクでのみ検出されます</translation>
    </message>
    <message>
        <source>DMC60C found: %1</source>
        <translation>DMC60C を検出: %1</translation>
    </message>
    <message>
        <source>Dialect %1 was chosen by hand, none was proven. %2</source>
        <translation>ダイアレクト %1 は手動で選択されました。実証されたものはありません。%2</translation>
    </message>
    <message>
        <source>Dialect %1 was chosen by hand, the unit answered as %2. %3</source>
        <translation>ダイアレクト %1 は手動で選択されました。機器の応答は %2 でした。%3</translation>
    </message>
    <message>
        <source>Do a write again</source>
        <translation>書込みのやり直し</translation>
    </message>
    <message>
        <source>Drives of two dialects answer with this offset in the recording.</source>
        <translation>記録の中で、2 種類のダイアレクトのドライブがこのオフセットで応答しています。</translation>
    </message>
    <message>
        <source>Enter bootloader</source>
        <translation>ブートローダへ移行</translation>
    </message>
    <message>
        <source>Erasing flash</source>
        <translation>フラッシュを消去中</translation>
    </message>
    <message>
        <source>Erasing the stored settings</source>
        <translation>保存された設定を消去中</translation>
    </message>
    <message>
        <source>Experiment</source>
        <translation>実験</translation>
    </message>
    <message>
        <source>FAMILY:ADDRESS is needed, such as dmc60c:5</source>
        <translation>FAMILY:ADDRESS が必要です (例: dmc60c:5)</translation>
    </message>
    <message>
        <source>Frequency response</source>
        <translation>周波数応答</translation>
    </message>
    <message>
        <source>GPIO line %1 is used by another program or driver</source>
        <translation>GPIO 線 %1 は別のプログラムまたはドライバが使用しています</translation>
    </message>
    <message>
        <source>GPIO line %1: %2</source>
        <translation>GPIO 線 %1: %2</translation>
    </message>
    <message>
        <source>GetDescriptors: a field ends too early</source>
        <translation>GetDescriptors: フィールドが途中で終わっています</translation>
    </message>
    <message>
        <source>GetFlashSeqnum: 4 bytes were expected</source>
        <translation>GetFlashSeqnum: 4 バイトであるべきです</translation>
    </message>
    <message>
        <source>GetFwver answered with %1 bytes</source>
        <translation>GetFwver の応答が %1 バイトでした</translation>
    </message>
    <message>
        <source>GetFwver: 6 bytes were expected</source>
        <translation>GetFwver: 6 バイトであるべきです</translation>
    </message>
    <message>
        <source>Giving it number %1</source>
        <translation>番号 %1 を割当て中</translation>
    </message>
    <message>
        <source>Identify</source>
        <translation>識別</translation>
    </message>
    <message>
        <source>It answers, but not as any known dialect; it can be watched but not driven.</source>
        <translation>応答しますが、既知のダイアレクトではありません。監視はできますが、駆動はできません。</translation>
    </message>
    <message>
        <source>It is not driven: %1.</source>
        <translation>この機器は駆動できません: %1。</translation>
    </message>
    <message>
        <source>Its answers fit no known dialect.</source>
        <translation>応答が既知のどのダイアレクトにも一致しません。</translation>
    </message>
    <message>
        <source>Its error level is 1, so every reading fails. Set error.level to 0.</source>
        <translation>エラーレベルが 1 のため、読出しはすべて失敗します。error.level を 0 にしてください。</translation>
    </message>
    <message>
        <source>Keep the gains of a trial</source>
        <translation>試行のゲインを維持</translation>
    </message>
    <message>
        <source>Look at the restarted unit</source>
        <translation>再起動した機器の確認</translation>
    </message>
    <message>
        <source>Look for gains that are owed</source>
        <translation>未復元のゲインを確認</translation>
    </message>
    <message>
        <source>Looking for Abstract DC Drives</source>
        <translation>Abstract DC Drive を検索中</translation>
    </message>
    <message>
        <source>Looking for DMC60C</source>
        <translation>DMC60C を検索中</translation>
    </message>
    <message>
        <source>Looking for Supermodified nodes at %1 bit/s</source>
        <translation>%1 bit/s で Supermodified ノードを検索中</translation>
    </message>
    <message>
        <source>Looking for the controller</source>
        <translation>コントローラを検索中</translation>
    </message>
    <message>
        <source>Looking for the drive</source>
        <translation>ドライブを検索中</translation>
    </message>
    <message>
        <source>No application runs; update its firmware.</source>
        <translation>アプリケーションが動作していません。ファームウェアを更新してください。</translation>
    </message>
    <message>
        <source>Number %1 is used by %2 units; give each its own before one is driven.</source>
        <translation>番号 %1 を %2 台の機器が使用しています。駆動する前に、それぞれ固有の番号を割り当ててください。</translation>
    </message>
    <message>
        <source>OpenOCD ended without saying why</source>
        <translation>OpenOCD が理由を示さずに終了しました</translation>
    </message>
    <message>
        <source>OpenOCD verified the flash, and the drive answers again</source>
        <translation>OpenOCD がフラッシュを検証し、ドライブが再び応答しました</translation>
    </message>
    <message>
        <source>OpenOCD verified the flash, but nothing answers as %1; the new firmware may have another offset or bit rate: scan again</source>
        <translation>OpenOCD がフラッシュを検証しましたが、%1 として応答するものがありません。新しいファームウェアはオフセットまたはビットレートが異なる可能性があります: 再スキャンしてください</translation>
    </message>
    <message>
        <source>OpenOCD: %1</source>
        <translation>OpenOCD: %1</translation>
    </message>
    <message>
        <source>Page %1</source>
        <translation>ページ %1</translation>
    </message>
    <message>
        <source>Preflight</source>
        <translation>事前確認</translation>
    </message>
    <message>
        <source>Product %1 is not known to be a DMC60C.</source>
        <translation>製品 %1 は DMC60C として登録されていません。</translation>
    </message>
    <message>
        <source>Put gains back</source>
        <translation>ゲインを元に戻す</translation>
    </message>
    <message>
        <source>Put values back</source>
        <translation>値を元に戻す</translation>
    </message>
    <message>
        <source>Read</source>
        <translation>読出し完了</translation>
    </message>
    <message>
        <source>Read and clear faults</source>
        <translation>フォルトの読出しとクリア</translation>
    </message>
    <message>
        <source>Read parameters</source>
        <translation>パラメータの読出し</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>%1 を読出し中</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>名前の変更</translation>
    </message>
    <message>
        <source>Restart</source>
        <translation>再起動</translation>
    </message>
    <message>
        <source>Restarting the drive</source>
        <translation>ドライブを再起動中</translation>
    </message>
    <message>
        <source>STOP was pressed</source>
        <translation>STOP が押されました</translation>
    </message>
    <message>
        <source>Saved</source>
        <translation>保存しました</translation>
    </message>
    <message>
        <source>Saving the %1 loop</source>
        <translation>%1 ループを保存中</translation>
    </message>
    <message>
        <source>Set telemetry rate</source>
        <translation>テレメトリ周波数の設定</translation>
    </message>
    <message>
        <source>Set telemetry rate: %1</source>
        <translation>テレメトリ周波数の設定: %1</translation>
    </message>
    <message>
        <source>Several drives answer with offset %1; offsets are compiled into the firmware, so give one of them another and flash it.</source>
        <translation>複数のドライブがオフセット %1 で応答しています。オフセットはファームウェアに組み込まれているため、一方に別のオフセットを与えて書き込んでください。</translation>
    </message>
    <message>
        <source>So old that nothing but its power stops it; it can be watched but not driven.</source>
        <translation>旧式のため、電源を切る以外に停止手段がありません。監視はできますが、駆動はできません。</translation>
    </message>
    <message>
        <source>Speaks the document&apos;s codes, which no published firmware does.</source>
        <translation>文書のコードで通信します。公開されているファームウェアにはない方式です。</translation>
    </message>
    <message>
        <source>Speaks the firmware&apos;s codes, not the document&apos;s.</source>
        <translation>文書ではなくファームウェアのコードで通信します。</translation>
    </message>
    <message>
        <source>Speaks the legacy frames of 8 bytes, as the published master does.</source>
        <translation>公開されているマスタと同じ、旧形式の 8 バイトフレームで通信します。</translation>
    </message>
    <message>
        <source>Store to flash</source>
        <translation>フラッシュへの保存</translation>
    </message>
    <message>
        <source>Supermodified controllers are found on serial links only</source>
        <translation>Supermodified コントローラはシリアルリンクでのみ検出されます</translation>
    </message>
    <message>
        <source>Supermodified found: %1</source>
        <translation>Supermodified を検出: %1</translation>
    </message>
    <message>
        <source>Take a snapshot</source>
        <translation>スナップショットの取得</translation>
    </message>
    <message>
        <source>The adapter has no %1 bit/s</source>
        <translation>アダプタは %1 bit/s に対応していません</translation>
    </message>
    <message>
        <source>The bootloader runs; restart the unit or update its firmware.</source>
        <translation>ブートローダが動作しています。機器を再起動するか、ファームウェアを更新してください。</translation>
    </message>
    <message>
        <source>The controller tells no version: the programmer&apos;s own verify and the controller&apos;s answer prove the update.</source>
        <translation>コントローラはバージョンを通知しません: 書込み器のベリファイとコントローラの応答が更新の証明です。</translation>
    </message>
    <message>
        <source>The drive tells no version: the programmer&apos;s own verify and the drive&apos;s answer prove the update.</source>
        <translation>ドライブはバージョンを通知しません: 書込み器のベリファイとドライブの応答が更新の証明です。</translation>
    </message>
    <message>
        <source>The image holds a bootloader too, so it needs a programmer on the pins.</source>
        <translation>イメージにブートローダも含まれるため、ピンに接続する書込み器が必要です。</translation>
    </message>
    <message>
        <source>The image writes the settings pages: stored gains are replaced.</source>
        <translation>イメージが設定ページを書き込みます: 保存されたゲインは置き換わります。</translation>
    </message>
    <message>
        <source>The recording does not tell which codes it speaks: it was asked for what all answer alike.</source>
        <translation>使用するコードは記録からは判別できません: どの方式でも応答が同じ問い合わせだけが記録されています。</translation>
    </message>
    <message>
        <source>The serial bootloader listens for a moment after power-up only: restart the controller when the update begins.</source>
        <translation>シリアルブートローダは電源投入直後の短時間だけ受信します: 更新の開始時にコントローラを再起動してください。</translation>
    </message>
    <message>
        <source>This unit has no number and no application; assign a number, then update its firmware.</source>
        <translation>この機器には番号もアプリケーションもありません。番号を割り当ててからファームウェアを更新してください。</translation>
    </message>
    <message>
        <source>This unit has no number yet; assign one from 1 to 63.</source>
        <translation>この機器にはまだ番号がありません。1 から 63 の番号を割り当ててください。</translation>
    </message>
    <message>
        <source>Undo a write</source>
        <translation>書込みを元に戻す</translation>
    </message>
    <message>
        <source>Update firmware</source>
        <translation>ファームウェアの更新</translation>
    </message>
    <message>
        <source>Verifying flash</source>
        <translation>フラッシュを検証中</translation>
    </message>
    <message>
        <source>Wait for %1</source>
        <translation>%1 を待機</translation>
    </message>
    <message>
        <source>Waiting until the device has written its flash</source>
        <translation>機器のフラッシュ書込みを待っています</translation>
    </message>
    <message>
        <source>Write parameters</source>
        <translation>パラメータの書込み</translation>
    </message>
    <message>
        <source>Write settings again</source>
        <translation>設定の再書込み</translation>
    </message>
    <message>
        <source>Writing %1</source>
        <translation>%1 を書込み中</translation>
    </message>
    <message>
        <source>Writing flash</source>
        <translation>フラッシュを書込み中</translation>
    </message>
    <message>
        <source>Written</source>
        <translation>書込み完了</translation>
    </message>
    <message>
        <source>&quot;via&quot; must name the other way in, such as &quot;%1&quot;</source>
        <translation>&quot;via&quot; にはもう一方の接続経路を指定します (例: &quot;%1&quot;)</translation>
    </message>
    <message>
        <source>a DMC60C has a number from 0 to 63, not %1</source>
        <translation>DMC60C の番号は 0 ～ 63 です。%1 は使えません</translation>
    </message>
    <message>
        <source>a DMC60C has no mode &apos;%1&apos;</source>
        <translation>DMC60C にモード「%1」はありません</translation>
    </message>
    <message>
        <source>a DMC60C has one axis</source>
        <translation>DMC60C の軸は 1 つです</translation>
    </message>
    <message>
        <source>a DMC60C has the gain slots 0 and 1</source>
        <translation>DMC60C のゲインスロットは 0 と 1 です</translation>
    </message>
    <message>
        <source>a DMC60C is simulated on a CAN link</source>
        <translation>DMC60C のシミュレーションは CAN リンク上で行います</translation>
    </message>
    <message>
        <source>a DMC60C is updated over its own link</source>
        <translation>DMC60C の更新は自身のリンク経由で行います</translation>
    </message>
    <message>
        <source>a GPIO line is CHIP:LINE, as in gpiochip0:25, not &apos;%1&apos;</source>
        <translation>GPIO 線は gpiochip0:25 のように CHIP:LINE で指定します。「%1」は使えません</translation>
    </message>
    <message>
        <source>a QuadQuad2Drv has no address but 0</source>
        <translation>QuadQuad2Drv のアドレスは 0 だけです</translation>
    </message>
    <message>
        <source>a QuadQuad2Drv has one kind of chip</source>
        <translation>QuadQuad2Drv のチップは 1 種類です</translation>
    </message>
    <message>
        <source>a QuadQuad2Drv is simulated on the board&apos;s end of an SPI link</source>
        <translation>QuadQuad2Drv のシミュレーションは SPI リンクの基板側で行います</translation>
    </message>
    <message>
        <source>a QuadQuad2Drv lives on an SPI link</source>
        <translation>QuadQuad2Drv は SPI リンク専用です</translation>
    </message>
    <message>
        <source>a Supermodified has an id from 1 to 127, not %1</source>
        <translation>Supermodified の ID は 1 ～ 127 です。%1 は使えません</translation>
    </message>
    <message>
        <source>a Supermodified has no mode &apos;%1&apos;</source>
        <translation>Supermodified にモード「%1」はありません</translation>
    </message>
    <message>
        <source>a Supermodified has one axis and one set of gains</source>
        <translation>Supermodified の軸は 1 つ、ゲインは 1 組です</translation>
    </message>
    <message>
        <source>a Supermodified has one kind of microcontroller</source>
        <translation>Supermodified のマイクロコントローラは 1 種類です</translation>
    </message>
    <message>
        <source>a Supermodified is simulated on a serial link</source>
        <translation>Supermodified のシミュレーションはシリアルリンク上で行います</translation>
    </message>
    <message>
        <source>a Supermodified is written by avrdude</source>
        <translation>Supermodified の書込みは avrdude で行います</translation>
    </message>
    <message>
        <source>a bit</source>
        <translation>ビット</translation>
    </message>
    <message>
        <source>a bootloader needs the board&apos;s serial line, such as boot=pty:./boot</source>
        <translation>ブートローダには基板のシリアル回線が必要です (例: boot=pty:./boot)</translation>
    </message>
    <message>
        <source>a buffered move is not acknowledged yet</source>
        <translation>バッファ動作がまだ確認応答されていません</translation>
    </message>
    <message>
        <source>a demo remembers no layouts</source>
        <translation>デモではレイアウトを保存しません</translation>
    </message>
    <message>
        <source>a device cannot follow itself</source>
        <translation>機器は自分自身に追従できません</translation>
    </message>
    <message>
        <source>a device number is 1 … 63</source>
        <translation>機器番号は 1 … 63 です</translation>
    </message>
    <message>
        <source>a divisor changes all gains at once</source>
        <translation>除数は全ゲインを一度に変えます</translation>
    </message>
    <message>
        <source>a drive of dialect LL has no code for stop</source>
        <translation>ダイアレクト LL のドライブには停止のコードがありません</translation>
    </message>
    <message>
        <source>a formula assigns nothing</source>
        <translation>数式では代入できません</translation>
    </message>
    <message>
        <source>a formula has at most 4000 characters</source>
        <translation>数式は最大 4000 文字です</translation>
    </message>
    <message>
        <source>a half swing</source>
        <translation>半周期</translation>
    </message>
    <message>
        <source>a load takes %1 of what P makes of a step, at most 10 %</source>
        <translation>負荷がステップに対する P の出力の %1 を占めています (最大 10 %)</translation>
    </message>
    <message>
        <source>a motor is driven on this line</source>
        <translation>この回線ではモーターを駆動中です</translation>
    </message>
    <message>
        <source>a motor is driven on this line at %1 bit/s, and this node has another rate</source>
        <translation>この回線では %1 bit/s でモーターを駆動中で、このノードは通信速度が異なります</translation>
    </message>
    <message>
        <source>a name has 1 to 64 characters</source>
        <translation>名前は 1 ～ 64 文字です</translation>
    </message>
    <message>
        <source>a name may hold Latin-1 characters only</source>
        <translation>名前に使えるのは Latin-1 文字だけです</translation>
    </message>
    <message>
        <source>a node id is 1 … 127</source>
        <translation>ノード ID は 1 … 127 です</translation>
    </message>
    <message>
        <source>a parenthesis is not closed</source>
        <translation>括弧が閉じていません</translation>
    </message>
    <message>
        <source>a part of them is in force after a restart only</source>
        <translation>一部は再起動後に初めて有効になります</translation>
    </message>
    <message>
        <source>a profile has up to 100000 counts/s and 1000000 counts/s²</source>
        <translation>プロファイルは最大 100000 counts/s、1000000 counts/s² です</translation>
    </message>
    <message>
        <source>a push has fewer than 8 positions</source>
        <translation>パルス中の位置データが 8 個未満です</translation>
    </message>
    <message>
        <source>a push moved the motor by fewer than 50 counts</source>
        <translation>パルスによるモーターの動きが 50 counts 未満です</translation>
    </message>
    <message>
        <source>a push of %1 duty drew %2 A, more than half of what is allowed</source>
        <translation>デューティ %1 のパルスで %2 A 流れ、許容値の半分を超えました</translation>
    </message>
    <message>
        <source>a rate is a positive number, or 0 for the usual one</source>
        <translation>周波数は正の数、または標準値を表す 0 です</translation>
    </message>
    <message>
        <source>a recipe is a JSON object</source>
        <translation>レシピは JSON オブジェクトです</translation>
    </message>
    <message>
        <source>a record of type %1 has %2 data bytes, not %3</source>
        <translation>タイプ %1 のレコードのデータが %3 バイトではなく %2 バイトです</translation>
    </message>
    <message>
        <source>a relative move was not answered, and is never sent twice: look where the motor stands</source>
        <translation>相対移動に応答がありません。相対移動は二度送信しません: モーターの位置を確認してください</translation>
    </message>
    <message>
        <source>a reserved bit</source>
        <translation>予約ビット</translation>
    </message>
    <message>
        <source>a scan of the recording lists who does</source>
        <translation>記録をスキャンすると送信元の一覧を表示できます</translation>
    </message>
    <message>
        <source>a simulated Abstract DC Drive</source>
        <translation>シミュレーションの Abstract DC Drive</translation>
    </message>
    <message>
        <source>a simulated DMC60C</source>
        <translation>シミュレーションの DMC60C</translation>
    </message>
    <message>
        <source>a simulated QuadQuad2Drv</source>
        <translation>シミュレーションの QuadQuad2Drv</translation>
    </message>
    <message>
        <source>a simulated Supermodified</source>
        <translation>シミュレーションの Supermodified</translation>
    </message>
    <message>
        <source>a step from the wrong place could be far too large</source>
        <translation>誤った位置からのステップは過大になるおそれがあります</translation>
    </message>
    <message>
        <source>a step of %1 counts overflows the loop of this firmware</source>
        <translation>%1 counts のステップでは、このファームウェアの制御ループがオーバーフローします</translation>
    </message>
    <message>
        <source>a step of %1 counts with P %2, D %3</source>
        <translation>%1 counts のステップ、P %2、D %3</translation>
    </message>
    <message>
        <source>a step of %1 counts with the gains as they are</source>
        <translation>現在のゲインで %1 counts のステップ</translation>
    </message>
    <message>
        <source>a stop went first</source>
        <translation>停止が優先されました</translation>
    </message>
    <message>
        <source>a swing</source>
        <translation>周期</translation>
    </message>
    <message>
        <source>a temporary file for %1 cannot be written: %2</source>
        <translation>%1 の一時ファイルを書き込めません: %2</translation>
    </message>
    <message>
        <source>a time</source>
        <translation>時間</translation>
    </message>
    <message>
        <source>a trial that is not kept</source>
        <translation>保存されない試行</translation>
    </message>
    <message>
        <source>a unit that has a serial number needs no tag</source>
        <translation>シリアル番号のある機器にタグは不要です</translation>
    </message>
    <message>
        <source>travel</source>
        <translation>移動量</translation>
    </message>
    <message>
        <source>accepted</source>
        <translation>受理</translation>
    </message>
    <message>
        <source>active error flag</source>
        <translation>アクティブエラーフラグ</translation>
    </message>
    <message>
        <source>add --via %1</source>
        <translation>--via %1 を追加してください</translation>
    </message>
    <message>
        <source>add --via openocd:INTERFACE --target f1|f4, such as --via openocd:stlink --target f1</source>
        <translation>--via openocd:INTERFACE --target f1|f4 を追加してください (例: --via openocd:stlink --target f1)</translation>
    </message>
    <message>
        <source>add ready=CHIP:LINE to the address</source>
        <translation>アドレスに ready=CHIP:LINE を追加してください</translation>
    </message>
    <message>
        <source>add reset=CHIP:LINE to the address</source>
        <translation>アドレスに reset=CHIP:LINE を追加してください</translation>
    </message>
    <message>
        <source>address %1 is %2 here and %3 in line %4</source>
        <translation>アドレス %1 はここでは %2、%4 行目では %3 です</translation>
    </message>
    <message>
        <source>aim for a calmer loop</source>
        <translation>より緩やかな制御ループを目標にしてください</translation>
    </message>
    <message>
        <source>all %1 read</source>
        <translation>全 %1 個を読出し済み</translation>
    </message>
    <message>
        <source>all pages are in the unit</source>
        <translation>全ページが機器に書き込まれました</translation>
    </message>
    <message>
        <source>allow CAN sockets in the container or sandbox</source>
        <translation>コンテナまたはサンドボックスで CAN ソケットを許可してください</translation>
    </message>
    <message>
        <source>allow it more power, or free its shaft</source>
        <translation>出力の許容値を上げるか、シャフトが自由に回るようにしてください</translation>
    </message>
    <message>
        <source>allow more current</source>
        <translation>電流の許容値を上げてください</translation>
    </message>
    <message>
        <source>allow more current or duty</source>
        <translation>電流またはデューティの許容値を上げてください</translation>
    </message>
    <message>
        <source>allow more duty</source>
        <translation>デューティの許容値を上げてください</translation>
    </message>
    <message>
        <source>allow more speed</source>
        <translation>速度の許容値を上げてください</translation>
    </message>
    <message>
        <source>allow more travel</source>
        <translation>移動量の許容値を上げてください</translation>
    </message>
    <message>
        <source>allow more travel or duty</source>
        <translation>移動量またはデューティの許容値を上げてください</translation>
    </message>
    <message>
        <source>allow more travel or speed</source>
        <translation>移動量または速度の許容値を上げてください</translation>
    </message>
    <message>
        <source>allow more, then close and open the link</source>
        <translation>上限を増やしてから、リンクを閉じて開き直してください</translation>
    </message>
    <message>
        <source>allow them in the container or sandbox</source>
        <translation>コンテナまたはサンドボックスで許可してください</translation>
    </message>
    <message>
        <source>an Abstract DC Drive cannot be asked for its settings</source>
        <translation>Abstract DC Drive の設定は問い合わせできません</translation>
    </message>
    <message>
        <source>an Abstract DC Drive has an offset from 0 to 99, not %1</source>
        <translation>Abstract DC Drive のオフセットは 0 ～ 99 です。%1 は使えません</translation>
    </message>
    <message>
        <source>an Abstract DC Drive has no mode &apos;%1&apos;</source>
        <translation>Abstract DC Drive にモード「%1」はありません</translation>
    </message>
    <message>
        <source>an Abstract DC Drive is written through a debug probe</source>
        <translation>Abstract DC Drive の書込みはデバッグプローブ経由で行います</translation>
    </message>
    <message>
        <source>an answer of %1 bytes</source>
        <translation>%1 バイトの応答</translation>
    </message>
    <message>
        <source>an axis from 1 to 4 and a power limit above 0 are needed</source>
        <translation>1 ～ 4 の軸と 0 より大きい出力制限が必要です</translation>
    </message>
    <message>
        <source>an experiment is run once at least</source>
        <translation>実験は 1 回以上実行します</translation>
    </message>
    <message>
        <source>another master drives %1</source>
        <translation>別のマスタが %1 を駆動しています</translation>
    </message>
    <message>
        <source>another master sends control frames to this device</source>
        <translation>別のマスタがこの機器へ制御フレームを送信しています</translation>
    </message>
    <message>
        <source>another program or controller drives this unit</source>
        <translation>別のプログラムまたはコントローラがこの機器を駆動しています</translation>
    </message>
    <message>
        <source>answers again</source>
        <translation>再び応答しました</translation>
    </message>
    <message>
        <source>arbitration lost</source>
        <translation>アービトレーション負け</translation>
    </message>
    <message>
        <source>arbitration lost at bit %1</source>
        <translation>ビット %1 でアービトレーション負け</translation>
    </message>
    <message>
        <source>arm again</source>
        <translation>再度駆動許可してください</translation>
    </message>
    <message>
        <source>arm it first</source>
        <translation>先に駆動許可してください</translation>
    </message>
    <message>
        <source>arrived damaged, nothing was erased</source>
        <translation>データ破損、何も消去していません</translation>
    </message>
    <message>
        <source>asking for the version</source>
        <translation>バージョンを問合せ中</translation>
    </message>
    <message>
        <source>assign one before it is driven</source>
        <translation>駆動する前に割り当ててください</translation>
    </message>
    <message>
        <source>at most %1 with its P: use a profiled mode or several moves</source>
        <translation>この P では最大 %1 です: プロファイルモードを使うか、動作を分割してください</translation>
    </message>
    <message>
        <source>average takes 0 to 3600 seconds, not &apos;%1&apos;</source>
        <translation>average の秒数は 0 ～ 3600 です。「%1」は使えません</translation>
    </message>
    <message>
        <source>average takes a signal and seconds, such as average(x, 0.1)</source>
        <translation>average には信号と秒数を指定します (例: average(x, 0.1))</translation>
    </message>
    <message>
        <source>avrdude ended without saying why</source>
        <translation>avrdude が理由を示さずに終了しました</translation>
    </message>
    <message>
        <source>avrdude had the port</source>
        <translation>avrdude がポートを使用していました</translation>
    </message>
    <message>
        <source>avrdude is not installed</source>
        <translation>avrdude がインストールされていません</translation>
    </message>
    <message>
        <source>avrdude read back all %1 bytes and they are equal, but the controller does not answer; cut its power for a moment, and scan: a new firmware may have another rate or node id</source>
        <translation>avrdude が全 %1 バイトを読み戻し、一致しましたが、コントローラが応答しません。電源をいったん切って再スキャンしてください: 新しいファームウェアは通信速度やノード ID が異なる場合があります</translation>
    </message>
    <message>
        <source>avrdude read back all %1 bytes and they are equal; the controller answers again, dialect %2</source>
        <translation>avrdude が全 %1 バイトを読み戻し、一致しました。コントローラが再び応答しました、ダイアレクト %2</translation>
    </message>
    <message>
        <source>baud, format, rs485 and echo are known</source>
        <translation>使えるのは baud、format、rs485、echo です</translation>
    </message>
    <message>
        <source>become a member of its group</source>
        <translation>そのグループのメンバーになってください</translation>
    </message>
    <message>
        <source>begin another recipe, or another bus</source>
        <translation>別のレシピまたは別のバスで開始してください</translation>
    </message>
    <message>
        <source>bit error</source>
        <translation>ビットエラー</translation>
    </message>
    <message>
        <source>boot= names a serial link, such as pty:./boot</source>
        <translation>boot= にはシリアルリンクを指定します (例: pty:./boot)</translation>
    </message>
    <message>
        <source>bootloader</source>
        <translation>ブートローダ</translation>
    </message>
    <message>
        <source>bring it to rest first</source>
        <translation>先に静止させてください</translation>
    </message>
    <message>
        <source>bring it up</source>
        <translation>オンにしてください</translation>
    </message>
    <message>
        <source>bring it up as a full member</source>
        <translation>通常のノードとしてオンにしてください</translation>
    </message>
    <message>
        <source>bus error</source>
        <translation>バスエラー</translation>
    </message>
    <message>
        <source>bus overload</source>
        <translation>バス過負荷</translation>
    </message>
    <message>
        <source>bus-off</source>
        <translation>バスオフ</translation>
    </message>
    <message>
        <source>bus-off: %1 left the bus after too many errors</source>
        <translation>バスオフ: エラーが多すぎたため %1 がバスから離脱しました</translation>
    </message>
    <message>
        <source>bus-off: the adapter left the bus after too many errors</source>
        <translation>バスオフ: エラーが多すぎたためアダプタがバスから離脱しました</translation>
    </message>
    <message>
        <source>bus-off: the controller left the bus after too many errors</source>
        <translation>バスオフ: エラーが多すぎたため CAN コントローラがバスから離脱しました</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>キャンセルしました</translation>
    </message>
    <message>
        <source>cannot be read (system error %1)</source>
        <translation>読み込めません (システムエラー %1)</translation>
    </message>
    <message>
        <source>change its mode, or copy it</source>
        <translation>アクセス権を変更するか、コピーしてください</translation>
    </message>
    <message>
        <source>check its rights</source>
        <translation>アクセス権を確認してください</translation>
    </message>
    <message>
        <source>check that somebody else is on the bus</source>
        <translation>バスに他のノードがあることを確認してください</translation>
    </message>
    <message>
        <source>check the cable, both 120 Ω resistors, and that no number is taken twice</source>
        <translation>ケーブルと 2 個の 120 Ω 抵抗、番号の重複がないことを確認してください</translation>
    </message>
    <message>
        <source>check the cables and try again</source>
        <translation>ケーブルを確認して再試行してください</translation>
    </message>
    <message>
        <source>check the disk</source>
        <translation>ディスクを確認してください</translation>
    </message>
    <message>
        <source>check the jumper AUX1–AUX2, the crossed wires TX and RX, and the 3.3 V levels, then reset the board</source>
        <translation>ジャンパ AUX1–AUX2、TX と RX の交差配線、3.3 V レベルを確認してから基板をリセットしてください</translation>
    </message>
    <message>
        <source>check the path</source>
        <translation>パスを確認してください</translation>
    </message>
    <message>
        <source>check the probe and try again</source>
        <translation>プローブを確認して再試行してください</translation>
    </message>
    <message>
        <source>check the rights of the folder above it</source>
        <translation>上位フォルダのアクセス権を確認してください</translation>
    </message>
    <message>
        <source>check wiring, termination and bit rate</source>
        <translation>配線、終端、ビットレートを確認してください</translation>
    </message>
    <message>
        <source>check wiring, termination and bit rate, then</source>
        <translation>配線、終端、ビットレートを確認してから</translation>
    </message>
    <message>
        <source>check wiring, termination and bit rate, then reconnect</source>
        <translation>配線、終端、ビットレートを確認してから再接続してください</translation>
    </message>
    <message>
        <source>check wiring, termination and bit rate; it starts again by itself</source>
        <translation>配線、終端、ビットレートを確認してください。自動的に再開します</translation>
    </message>
    <message>
        <source>checksum is %1, %2 is needed</source>
        <translation>チェックサムは %1 ですが、正しくは %2 です</translation>
    </message>
    <message>
        <source>chirp: %1 s hold no whole swing of %2 Hz</source>
        <translation>チャープ: %1 s の中に %2 Hz の 1 周期が収まりません</translation>
    </message>
    <message>
        <source>choose a smaller --size</source>
        <translation>--size を小さくしてください</translation>
    </message>
    <message>
        <source>choose another folder</source>
        <translation>別のフォルダを選択してください</translation>
    </message>
    <message>
        <source>choose another one</source>
        <translation>別のものを選択してください</translation>
    </message>
    <message>
        <source>choose another path</source>
        <translation>別のパスを選択してください</translation>
    </message>
    <message>
        <source>choose another place</source>
        <translation>別の場所を選択してください</translation>
    </message>
    <message>
        <source>close that one first (&apos;fuser %1&apos; names it)</source>
        <translation>先にそのプログラムを閉じてください (&apos;fuser %1&apos; で名前がわかります)</translation>
    </message>
    <message>
        <source>close the jumper between AUX1 and AUX2, then reset the board or switch it off and on</source>
        <translation>AUX1 と AUX2 の間にジャンパを付けてから、基板をリセットするか電源を入れ直してください</translation>
    </message>
    <message>
        <source>control is locked until one has another number</source>
        <translation>一方に別の番号を割り当てるまで制御はロックされます</translation>
    </message>
    <message>
        <source>copy the recording to another one</source>
        <translation>記録を別のディスクにコピーしてください</translation>
    </message>
    <message>
        <source>current</source>
        <translation>電流</translation>
    </message>
    <message>
        <source>current %1 A is above 1.5 × %2 A</source>
        <translation>電流 %1 A が 1.5 × %2 A を超えています</translation>
    </message>
    <message>
        <source>current was above %1 A for %2</source>
        <translation>電流が %2 の間 %1 A を超えていました</translation>
    </message>
    <message>
        <source>cut the power if the motor still turns</source>
        <translation>モーターがまだ回転している場合は電源を切ってください</translation>
    </message>
    <message>
        <source>delete it, the value says the same</source>
        <translation>削除してください。値から同じことがわかります</translation>
    </message>
    <message>
        <source>delete the one of the two that is old</source>
        <translation>2 つのうち古い方を削除してください</translation>
    </message>
    <message>
        <source>derivative and integral take one signal</source>
        <translation>derivative と integral に指定する信号は 1 つです</translation>
    </message>
    <message>
        <source>dialect LL has no code for stop</source>
        <translation>ダイアレクト LL には停止のコードがありません</translation>
    </message>
    <message>
        <source>do it again</source>
        <translation>やり直してください</translation>
    </message>
    <message>
        <source>does not answer any more</source>
        <translation>応答しなくなりました</translation>
    </message>
    <message>
        <source>dominant bit not sent</source>
        <translation>ドミナントビットを送信できません</translation>
    </message>
    <message>
        <source>dry run: %1 lines would be sent over %2</source>
        <translation>ドライラン: %2 経由で %1 行を送信します</translation>
    </message>
    <message>
        <source>dry run: %1 pages would be written</source>
        <translation>ドライラン: %1 ページを書き込みます</translation>
    </message>
    <message>
        <source>dry run: %1 pages would be written, version %2</source>
        <translation>ドライラン: %1 ページを書き込みます、バージョン %2</translation>
    </message>
    <message>
        <source>duty</source>
        <translation>デューティ</translation>
    </message>
    <message>
        <source>duty %1 % is above %2 %</source>
        <translation>デューティ %1 % が %2 % を超えています</translation>
    </message>
    <message>
        <source>duty %1 ± %2 %, at most %3 counts/s, %4 counts one way, %5 s</source>
        <translation>デューティ %1 ± %2 %、最大 %3 counts/s、片方向 %4 counts、%5 s</translation>
    </message>
    <message>
        <source>duty is a fraction from −1 to 1</source>
        <translation>デューティは −1 ～ 1 の小数です</translation>
    </message>
    <message>
        <source>enable SPI in the device tree (on a Raspberry Pi: dtparam=spi=on) and restart</source>
        <translation>デバイスツリーで SPI を有効にし (Raspberry Pi では dtparam=spi=on)、再起動してください</translation>
    </message>
    <message>
        <source>end it in .pdf or .html</source>
        <translation>拡張子を .pdf または .html にしてください</translation>
    </message>
    <message>
        <source>end it in .png, .svg or .pdf</source>
        <translation>拡張子を .png、.svg、.pdf のいずれかにしてください</translation>
    </message>
    <message>
        <source>end that first</source>
        <translation>先にそれを終了してください</translation>
    </message>
    <message>
        <source>end that one first, or choose another path</source>
        <translation>先にそれを終了するか、別のパスを選択してください</translation>
    </message>
    <message>
        <source>ending=%1: legal are cr, lf and crlf</source>
        <translation>ending=%1: 有効な値は cr、lf、crlf です</translation>
    </message>
    <message>
        <source>error</source>
        <translation>エラー</translation>
    </message>
    <message>
        <source>error-active</source>
        <translation>エラーアクティブ</translation>
    </message>
    <message>
        <source>error-passive</source>
        <translation>エラーパッシブ</translation>
    </message>
    <message>
        <source>error-warning</source>
        <translation>エラーワーニング</translation>
    </message>
    <message>
        <source>every id that this program could use on the line belongs to the group of a node, so answers would be taken for commands; set node.mask to 255 and restart the nodes</source>
        <translation>このプログラムが回線上で使える ID がすべて、あるノードのグループに属しており、応答が指令とみなされます。node.mask を 255 にしてノードを再起動してください</translation>
    </message>
    <message>
        <source>every line was confirmed, and the board answers with version %1</source>
        <translation>全行が確認され、基板はバージョン %1 で応答しました</translation>
    </message>
    <message>
        <source>every line was confirmed, and the board answers with version %1, the same as before, so that nothing proves the new firmware</source>
        <translation>全行が確認され、基板はバージョン %1 で応答しましたが、以前と同じため新しいファームウェアの証明にはなりません</translation>
    </message>
    <message>
        <source>every line was confirmed, but the board does not answer over SPI</source>
        <translation>全行が確認されましたが、基板が SPI で応答しません</translation>
    </message>
    <message>
        <source>exchange the wires of the motor or the phases of the encoder</source>
        <translation>モーターの配線またはエンコーダの相を入れ替えてください</translation>
    </message>
    <message>
        <source>exchange the wires of the motor or the phases of the encoder before any loop is closed</source>
        <translation>閉ループ制御を始める前に、モーターの配線またはエンコーダの相を入れ替えてください</translation>
    </message>
    <message>
        <source>expected time, channel, value and unit</source>
        <translation>時間、チャネル、値、単位が必要です</translation>
    </message>
    <message>
        <source>fault &apos;%1&apos; does not parse</source>
        <translation>fault「%1」を解釈できません</translation>
    </message>
    <message>
        <source>fewer than 16 samples connect</source>
        <translation>連続するサンプルが16未満です</translation>
    </message>
    <message>
        <source>find it by listening only</source>
        <translation>受信のみで調べてください</translation>
    </message>
    <message>
        <source>find its gain scales first: Overview, Find the gain scales</source>
        <translation>先にゲインスケールを測定してください: 「概要」の「ゲインスケールの測定」</translation>
    </message>
    <message>
        <source>find the sender that fills it, on the Bus page or with &apos;motorbenchctl monitor&apos;</source>
        <translation>バスを占有している送信元を「バス」ページまたは &apos;motorbenchctl monitor&apos; で探してください</translation>
    </message>
    <message>
        <source>firmware update</source>
        <translation>ファームウェアの更新</translation>
    </message>
    <message>
        <source>firmware: %1</source>
        <translation>ファームウェア: %1</translation>
    </message>
    <message>
        <source>follow needs the number of a device</source>
        <translation>追従には機器の番号が必要です</translation>
    </message>
    <message>
        <source>form error</source>
        <translation>フォームエラー</translation>
    </message>
    <message>
        <source>found on %1</source>
        <translation>%1 で検出</translation>
    </message>
    <message>
        <source>free the shaft and see that no brake is on, then test again</source>
        <translation>シャフトが自由に回り、ブレーキがかかっていないことを確認して再試験してください</translation>
    </message>
    <message>
        <source>frequency response: %1</source>
        <translation>周波数応答: %1</translation>
    </message>
    <message>
        <source>friction takes %1 duty of pushes of %2</source>
        <translation>摩擦が、パルスのデューティ %2 のうち %1 を占めています</translation>
    </message>
    <message>
        <source>friction takes %1 of what P makes of a step, at most 60 %</source>
        <translation>摩擦がステップに対する P の出力の %1 を占めています (最大 60 %)</translation>
    </message>
    <message>
        <source>gave no sign after the stop</source>
        <translation>停止後に反応がありません</translation>
    </message>
    <message>
        <source>gave no sign after the stop; its own watchdog switches it off</source>
        <translation>停止後に反応がありません。機器自身のウォッチドッグが出力をオフにします</translation>
    </message>
    <message>
        <source>give %1</source>
        <translation>%1 を指定してください</translation>
    </message>
    <message>
        <source>keep what is tried, or name a notebook that can be written</source>
        <translation>試す値をそのまま残すか、書込み可能なノートを指定してください</translation>
    </message>
    <message>
        <source>give it a longer time</source>
        <translation>時間を長くしてください</translation>
    </message>
    <message>
        <source>give a name that ends in .png, .svg or .pdf</source>
        <translation>拡張子が .png、.svg、.pdf のいずれかの名前を指定してください</translation>
    </message>
    <message>
        <source>give a recording, or --help for what else there is</source>
        <translation>記録を指定してください。その他の使い方は --help で表示できます</translation>
    </message>
    <message>
        <source>give another target</source>
        <translation>別の目標を指定してください</translation>
    </message>
    <message>
        <source>give at least %1 s</source>
        <translation>%1 s 以上を指定してください</translation>
    </message>
    <message>
        <source>give it a new one, or switch it off and on</source>
        <translation>新しい動作指令を与えるか、電源を入れ直してください</translation>
    </message>
    <message>
        <source>give it a number first, or take the self-test out of the recipe</source>
        <translation>先に番号を割り当てるか、レシピからセルフテストを外してください</translation>
    </message>
    <message>
        <source>gpiodetect lists those there are</source>
        <translation>gpiodetect で一覧を表示できます</translation>
    </message>
    <message>
        <source>identify it anew</source>
        <translation>同定し直してください</translation>
    </message>
    <message>
        <source>image %1 of %2 pages, unit runs %3, bootloader %4</source>
        <translation>イメージ %1、%2 ページ、機器は %3 で動作中、ブートローダ %4</translation>
    </message>
    <message>
        <source>image %1 of %2 pages, unit without application, bootloader %3</source>
        <translation>イメージ %1、%2 ページ、機器はアプリケーションなし、ブートローダ %3</translation>
    </message>
    <message>
        <source>in bootloader %1, session kept</source>
        <translation>ブートローダ %1 で動作中、セッションは維持</translation>
    </message>
    <message>
        <source>in position mode a new counter would make the motor jump</source>
        <translation>位置モードで新しいカウンタ値にすると、モーターの位置が飛びます</translation>
    </message>
    <message>
        <source>install %1</source>
        <translation>%1 をインストールしてください</translation>
    </message>
    <message>
        <source>install it with</source>
        <translation>次のコマンドでインストールしてください</translation>
    </message>
    <message>
        <source>install its vendor&apos;s driver</source>
        <translation>メーカーのドライバをインストールしてください</translation>
    </message>
    <message>
        <source>install the package that has it and try again</source>
        <translation>それを含むパッケージをインストールして再試行してください</translation>
    </message>
    <message>
        <source>installed are: %1</source>
        <translation>インストール済み: %1</translation>
    </message>
    <message>
        <source>is a directory</source>
        <translation>ディレクトリです</translation>
    </message>
    <message>
        <source>is back</source>
        <translation>復帰しました</translation>
    </message>
    <message>
        <source>is gone</source>
        <translation>なくなりました</translation>
    </message>
    <message>
        <source>is longer than %1 bytes</source>
        <translation>%1 バイトを超えています</translation>
    </message>
    <message>
        <source>is not a regular file</source>
        <translation>通常のファイルではありません</translation>
    </message>
    <message>
        <source>is there</source>
        <translation>接続されました</translation>
    </message>
    <message>
        <source>it begins with &quot;recipe&quot;: 1</source>
        <translation>&quot;recipe&quot;: 1 で始まります</translation>
    </message>
    <message>
        <source>it begins with {</source>
        <translation>{ で始まります</translation>
    </message>
    <message>
        <source>it came to rest %1 of the step away from its target</source>
        <translation>目標からステップの %1 だけ離れて静止しました</translation>
    </message>
    <message>
        <source>it cannot be tried</source>
        <translation>試せません</translation>
    </message>
    <message>
        <source>it cannot be written (system error %1)</source>
        <translation>書き込めません (システムエラー %1)</translation>
    </message>
    <message>
        <source>it did not come back</source>
        <translation>復帰しませんでした</translation>
    </message>
    <message>
        <source>it did not settle</source>
        <translation>整定しませんでした</translation>
    </message>
    <message>
        <source>it has %1</source>
        <translation>あるのは %1 です</translation>
    </message>
    <message>
        <source>it is a Vector BLF log</source>
        <translation>Vector BLF ログです</translation>
    </message>
    <message>
        <source>it is a disk</source>
        <translation>ディスクです</translation>
    </message>
    <message>
        <source>it is a folder</source>
        <translation>フォルダです</translation>
    </message>
    <message>
        <source>it is a recording</source>
        <translation>記録です</translation>
    </message>
    <message>
        <source>it is not known how to stop this device from outside</source>
        <translation>この機器を外部から停止させる方法が不明です</translation>
    </message>
    <message>
        <source>it is not proven which codes it speaks, and a stop of others may start it</source>
        <translation>使用するコードが実証されておらず、別のコードの停止指令で始動する可能性があります</translation>
    </message>
    <message>
        <source>it is not proven which codes this drive speaks</source>
        <translation>このドライブが使うコードは実証されていません</translation>
    </message>
    <message>
        <source>it is not proven which codes this drive speaks, and the wrong ones start it at full power</source>
        <translation>このドライブが使うコードは実証されておらず、誤ったコードでは全出力で始動します</translation>
    </message>
    <message>
        <source>it may rest %1 short of its target, less does not move its integral</source>
        <translation>目標の %1 手前で止まることがあります。それ未満では積分が働きません</translation>
    </message>
    <message>
        <source>it may rest %1 short of its target, less does not move its motor</source>
        <translation>目標の %1 手前で止まることがあります。それ未満ではモーターが動きません</translation>
    </message>
    <message>
        <source>it overshot by %1, predicted were %2</source>
        <translation>オーバーシュートは %1、予測は %2 でした</translation>
    </message>
    <message>
        <source>it swung itself up with P %1 and D %2</source>
        <translation>P %1、D %2 で発振しました</translation>
    </message>
    <message>
        <source>it took %1 to settle, predicted were %2</source>
        <translation>整定に %1 かかりました。予測は %2 でした</translation>
    </message>
    <message>
        <source>it took longer than 1.5 × %1 s</source>
        <translation>1.5 × %1 s より長くかかりました</translation>
    </message>
    <message>
        <source>it was put aside as %1, and what it kept of the device is unknown again</source>
        <translation>%1 として退避しました。それに保存されていた機器の情報は再び不明です</translation>
    </message>
    <message>
        <source>it was stopped</source>
        <translation>停止しました</translation>
    </message>
    <message>
        <source>it would stop %1 counts from the start, %2 are allowed</source>
        <translation>開始点から %1 counts で停止する見込みですが、許容値は %2 です</translation>
    </message>
    <message>
        <source>its P or its position is not known, so whether this step overflows its loop is not either</source>
        <translation>P または位置が不明なため、このステップで制御ループがオーバーフローするかどうかも不明です</translation>
    </message>
    <message>
        <source>its address is not a number</source>
        <translation>アドレスが数値ではありません</translation>
    </message>
    <message>
        <source>its dialect is not known</source>
        <translation>ダイアレクトが不明です</translation>
    </message>
    <message>
        <source>its dialect is not known yet</source>
        <translation>ダイアレクトがまだ不明です</translation>
    </message>
    <message>
        <source>its dialect is not known, so no move can be sent</source>
        <translation>ダイアレクトが不明なため、動作指令を送信できません</translation>
    </message>
    <message>
        <source>its error level is 1, which makes every reading fail: set error.level to 0</source>
        <translation>エラーレベルが 1 のため、読出しがすべて失敗します: error.level を 0 にしてください</translation>
    </message>
    <message>
        <source>its motor is turning or driven already</source>
        <translation>モーターがすでに回転中または駆動中です</translation>
    </message>
    <message>
        <source>its position is not known yet</source>
        <translation>位置がまだ不明です</translation>
    </message>
    <message>
        <source>its profile is not known, so a move that passes its target could not be told</source>
        <translation>プロファイルが不明なため、目標の行き過ぎを検出できません</translation>
    </message>
    <message>
        <source>its reader has gone</source>
        <translation>読み手がいなくなりました</translation>
    </message>
    <message>
        <source>known are %1</source>
        <translation>使えるのは %1 です</translation>
    </message>
    <message>
        <source>leave it out</source>
        <translation>省いてください</translation>
    </message>
    <message>
        <source>leave out --target</source>
        <translation>--target を省いてください</translation>
    </message>
    <message>
        <source>leave out erasing them</source>
        <translation>設定の消去を省いてください</translation>
    </message>
    <message>
        <source>leave out interface=</source>
        <translation>interface= を省いてください</translation>
    </message>
    <message>
        <source>leave the other way in out</source>
        <translation>もう一方の接続経路を省いてください</translation>
    </message>
    <message>
        <source>leave the target out</source>
        <translation>ターゲットを省いてください</translation>
    </message>
    <message>
        <source>legal is %1</source>
        <translation>有効な値は %1 です</translation>
    </message>
    <message>
        <source>legal is 0.01 … 1000, or max</source>
        <translation>有効な値は 0.01 … 1000、または max です</translation>
    </message>
    <message>
        <source>legal is 1 … 500</source>
        <translation>有効な値は 1 … 500 です</translation>
    </message>
    <message>
        <source>limit %1</source>
        <translation>上限 %1</translation>
    </message>
    <message>
        <source>limits %1 … %2</source>
        <translation>範囲 %1 … %2</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>%1 行目</translation>
    </message>
    <message>
        <source>line %1 is neither a line of candump -L nor the beginning of a Vector ASC log</source>
        <translation>%1 行目は candump -L の行でも Vector ASC ログの先頭でもありません</translation>
    </message>
    <message>
        <source>line %1 is not a line of a Vector ASC log</source>
        <translation>%1 行目は Vector ASC ログの行ではありません</translation>
    </message>
    <message>
        <source>line %1 is not a line of candump -L</source>
        <translation>%1 行目は candump -L の行ではありません</translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>%1 行目: %2</translation>
    </message>
    <message>
        <source>link option %1=%2 is out of range</source>
        <translation>リンクオプション %1=%2 は範囲外です</translation>
    </message>
    <message>
        <source>link option &apos;%1&apos; is not KEY=VALUE</source>
        <translation>リンクオプション「%1」は KEY=VALUE の形式ではありません</translation>
    </message>
    <message>
        <source>link option bitrate=%1 is out of range</source>
        <translation>リンクオプション bitrate=%1 は範囲外です</translation>
    </message>
    <message>
        <source>listen-only: nothing can be sent</source>
        <translation>リッスンオンリー: 送信できません</translation>
    </message>
    <message>
        <source>load it</source>
        <translation>読み込んでください</translation>
    </message>
    <message>
        <source>look at brushes, plugs and leads, then test again</source>
        <translation>ブラシ、コネクタ、リード線を確認して再試験してください</translation>
    </message>
    <message>
        <source>look at it again</source>
        <translation>再確認してください</translation>
    </message>
    <message>
        <source>look at the cable and test again</source>
        <translation>ケーブルを確認して再試験してください</translation>
    </message>
    <message>
        <source>look at the plug and the polarity of encoder and motor, then test again</source>
        <translation>コネクタと、エンコーダおよびモーターの極性を確認して再試験してください</translation>
    </message>
    <message>
        <source>look at the wiring of the input</source>
        <translation>入力の配線を確認してください</translation>
    </message>
    <message>
        <source>look for units again</source>
        <translation>機器を再検索してください</translation>
    </message>
    <message>
        <source>look whether something brakes or limits the motor</source>
        <translation>モーターにブレーキや制限がかかっていないか確認してください</translation>
    </message>
    <message>
        <source>looking at the status bit</source>
        <translation>状態ビットを確認中</translation>
    </message>
    <message>
        <source>looking for position D</source>
        <translation>位置 D を探索中</translation>
    </message>
    <message>
        <source>looking for position I</source>
        <translation>位置 I を探索中</translation>
    </message>
    <message>
        <source>looking for position P</source>
        <translation>位置 P を探索中</translation>
    </message>
    <message>
        <source>looking for velocity I</source>
        <translation>速度 I を探索中</translation>
    </message>
    <message>
        <source>looking for velocity P</source>
        <translation>速度 P を探索中</translation>
    </message>
    <message>
        <source>lower the gains or the steps</source>
        <translation>ゲインまたはステップを小さくしてください</translation>
    </message>
    <message>
        <source>made way for an order</source>
        <translation>指令を優先して中止しました</translation>
    </message>
    <message>
        <source>make room in %1</source>
        <translation>%1 の空き容量を増やしてください</translation>
    </message>
    <message>
        <source>make room, or choose another place</source>
        <translation>空き容量を増やすか、別の場所を選択してください</translation>
    </message>
    <message>
        <source>more bytes than the device announced</source>
        <translation>機器の通知より多いバイト数です</translation>
    </message>
    <message>
        <source>more columns than the first line has</source>
        <translation>列数が先頭行より多くなっています</translation>
    </message>
    <message>
        <source>more than 1000 channels</source>
        <translation>チャネルが 1000 を超えています</translation>
    </message>
    <message>
        <source>move it away</source>
        <translation>別の場所へ移してください</translation>
    </message>
    <message>
        <source>name a file</source>
        <translation>ファイルを指定してください</translation>
    </message>
    <message>
        <source>name a firmware in the recipe</source>
        <translation>レシピでファームウェアを指定してください</translation>
    </message>
    <message>
        <source>name a recording</source>
        <translation>記録を指定してください</translation>
    </message>
    <message>
        <source>name another folder</source>
        <translation>別のフォルダを指定してください</translation>
    </message>
    <message>
        <source>name it by its number; &apos;motorbenchctl snapshots&apos; lists them</source>
        <translation>番号で指定してください。&apos;motorbenchctl snapshots&apos; で一覧を表示できます</translation>
    </message>
    <message>
        <source>name its serial port, for example --via serial:/dev/ttyUSB0</source>
        <translation>シリアルポートを指定してください (例: --via serial:/dev/ttyUSB0)</translation>
    </message>
    <message>
        <source>name one such as /dev/ttyUSB0</source>
        <translation>/dev/ttyUSB0 のように指定してください</translation>
    </message>
    <message>
        <source>name one, such as sim:can</source>
        <translation>指定してください (例: sim:can)</translation>
    </message>
    <message>
        <source>name one: %1 or %2</source>
        <translation>指定してください: %1 または %2</translation>
    </message>
    <message>
        <source>no %1 answers as number %2 on %3</source>
        <translation>%3 で番号 %2 として応答する %1 はありません</translation>
    </message>
    <message>
        <source>no %1 sends as number %2 in %3</source>
        <translation>%3 に番号 %2 として送信する %1 はありません</translation>
    </message>
    <message>
        <source>no CAN frame: its identifier or size is out of range</source>
        <translation>CAN フレームではありません: 識別子またはサイズが範囲外です</translation>
    </message>
    <message>
        <source>no D was found with which a small P neither swings nor creeps</source>
        <translation>小さい P で振動もクリープもしない D が見つかりません</translation>
    </message>
    <message>
        <source>no answer</source>
        <translation>応答なし</translation>
    </message>
    <message>
        <source>no application runs in this unit</source>
        <translation>この機器ではアプリケーションが動作していません</translation>
    </message>
    <message>
        <source>no bootloader answers at %1 bit/s</source>
        <translation>%1 bit/s で応答するブートローダがありません</translation>
    </message>
    <message>
        <source>no data in page 0 (0x00000-0x00FFF), the file is not a whole application</source>
        <translation>ページ 0 (0x00000-0x00FFF) にデータがありません。完全なアプリケーションではありません</translation>
    </message>
    <message>
        <source>no data in page 30 (0x1E000-0x1EFFF), where the version is</source>
        <translation>バージョンのあるページ 30 (0x1E000-0x1EFFF) にデータがありません</translation>
    </message>
    <message>
        <source>no experiment: %1</source>
        <translation>実験なし: %1</translation>
    </message>
    <message>
        <source>no gain of the position loop turns the motor</source>
        <translation>位置ループのどのゲインでもモーターが回転しません</translation>
    </message>
    <message>
        <source>no gain of the velocity loop turns the motor</source>
        <translation>速度ループのどのゲインでもモーターが回転しません</translation>
    </message>
    <message>
        <source>no guardian came within two seconds</source>
        <translation>2 秒以内に監視プロセスが起動しませんでした</translation>
    </message>
    <message>
        <source>no guardian can be started: %1</source>
        <translation>監視プロセスを起動できません: %1</translation>
    </message>
    <message>
        <source>no history is kept here</source>
        <translation>ここでは履歴を保存していません</translation>
    </message>
    <message>
        <source>no instruction at the entry point 0x00400</source>
        <translation>エントリポイント 0x00400 に命令がありません</translation>
    </message>
    <message>
        <source>no number: server silent</source>
        <translation>番号なし: サーバーが応答しません</translation>
    </message>
    <message>
        <source>no object at the top</source>
        <translation>最上位にオブジェクトがありません</translation>
    </message>
    <message>
        <source>no permission to open CAN sockets here</source>
        <translation>ここで CAN ソケットを開く権限がありません</translation>
    </message>
    <message>
        <source>no permission to read it</source>
        <translation>読み込む権限がありません</translation>
    </message>
    <message>
        <source>no permission to use %1</source>
        <translation>%1 を使用する権限がありません</translation>
    </message>
    <message>
        <source>no permission to write there</source>
        <translation>そこに書き込む権限がありません</translation>
    </message>
    <message>
        <source>no pseudo terminal can be had: %1</source>
        <translation>擬似端末を取得できません: %1</translation>
    </message>
    <message>
        <source>no push met the current limit</source>
        <translation>どのパルスも電流制限に達しませんでした</translation>
    </message>
    <message>
        <source>no ready line is wired</source>
        <translation>レディ線が配線されていません</translation>
    </message>
    <message>
        <source>no reset line is wired</source>
        <translation>リセット線が配線されていません</translation>
    </message>
    <message>
        <source>no sample for %1</source>
        <translation>%1 の間サンプルがありません</translation>
    </message>
    <message>
        <source>no snapshot of what was found: %1</source>
        <translation>当初の状態のスナップショットなし: %1</translation>
    </message>
    <message>
        <source>no snapshot of what was there: %1</source>
        <translation>以前の状態のスナップショットなし: %1</translation>
    </message>
    <message>
        <source>no snapshot: %1</source>
        <translation>スナップショットなし: %1</translation>
    </message>
    <message>
        <source>no snapshots are kept here</source>
        <translation>ここではスナップショットを保存していません</translation>
    </message>
    <message>
        <source>no status within 2 s</source>
        <translation>2 s 以内に状態が届きませんでした</translation>
    </message>
    <message>
        <source>no step met the end of the output</source>
        <translation>どのステップも出力の上限に達しませんでした</translation>
    </message>
    <message>
        <source>no such file</source>
        <translation>ファイルがありません</translation>
    </message>
    <message>
        <source>no version at 0x1EFFC</source>
        <translation>0x1EFFC にバージョンがありません</translation>
    </message>
    <message>
        <source>nobody acknowledged</source>
        <translation>ACK が返りませんでした</translation>
    </message>
    <message>
        <source>nobody acknowledges what %1 sends</source>
        <translation>%1 の送信に ACK を返すノードがありません</translation>
    </message>
    <message>
        <source>nobody reads from this pipe</source>
        <translation>このパイプを読むプログラムがありません</translation>
    </message>
    <message>
        <source>nobody renewed the motion lease</source>
        <translation>動作の継続許可が更新されませんでした</translation>
    </message>
    <message>
        <source>nobody serves %1</source>
        <translation>%1 を提供するプログラムがありません</translation>
    </message>
    <message>
        <source>nobody watches over this self-test, and it moves the motor</source>
        <translation>モーターを動かすこのセルフテストを監視する者がいません</translation>
    </message>
    <message>
        <source>node %1 does not answer</source>
        <translation>ノード %1 が応答しません</translation>
    </message>
    <message>
        <source>node id %1 is used by another node of this line</source>
        <translation>ノード ID %1 はこの回線の別のノードが使用しています</translation>
    </message>
    <message>
        <source>not a parameter file: %1</source>
        <translation>パラメータファイルではありません: %1</translation>
    </message>
    <message>
        <source>not a parameter file: it has no &quot;parameters&quot;</source>
        <translation>パラメータファイルではありません: &quot;parameters&quot; がありません</translation>
    </message>
    <message>
        <source>not sent: %1 for %2</source>
        <translation>未送信: %1 (%2 用)</translation>
    </message>
    <message>
        <source>not sent: %1 outside the controller&apos;s flash</source>
        <translation>未送信: コントローラのフラッシュ外の %1</translation>
    </message>
    <message>
        <source>not sent: %1 where a 24-bit instruction has none, the file may be for another processor</source>
        <translation>未送信: 24 ビット命令にはない位置の %1。別のプロセッサ用のファイルかもしれません</translation>
    </message>
    <message>
        <source>nothing could put the gains back after a crash</source>
        <translation>クラッシュ後にゲインを元に戻す手段がありません</translation>
    </message>
    <message>
        <source>nothing has been recorded yet</source>
        <translation>まだ何も記録されていません</translation>
    </message>
    <message>
        <source>nothing to send</source>
        <translation>送信するものがありません</translation>
    </message>
    <message>
        <source>nothing was measured</source>
        <translation>何も測定されていません</translation>
    </message>
    <message>
        <source>nothing was saved</source>
        <translation>何も保存していません</translation>
    </message>
    <message>
        <source>nothing was written</source>
        <translation>何も書き込んでいません</translation>
    </message>
    <message>
        <source>nothing was written; the image fits, %1 pages</source>
        <translation>何も書き込んでいません。イメージは適合、%1 ページ</translation>
    </message>
    <message>
        <source>now the calm ones</source>
        <translation>次に緩やかなゲインを試します</translation>
    </message>
    <message>
        <source>number %1 is used by another unit</source>
        <translation>番号 %1 は別の機器が使用しています</translation>
    </message>
    <message>
        <source>number %1 still keeps a move that was stopped before it began, and would begin it too</source>
        <translation>番号 %1 は開始前に停止した動作指令を保持しており、同時に動き始めます</translation>
    </message>
    <message>
        <source>one more would make the drive load something else. Erase its settings pages with a firmware update (erase settings), then save again</source>
        <translation>もう一度保存すると、ドライブが別の内容を読み込みます。ファームウェアの更新で設定ページを消去 (設定の消去) してから、保存し直してください</translation>
    </message>
    <message>
        <source>one update a bus: %1 is being written; nothing was sent</source>
        <translation>更新は 1 バスにつき 1 件です: %1 に書込み中のため、何も送信していません</translation>
    </message>
    <message>
        <source>only disturbed frames arrive on %1, the bus has another bit rate</source>
        <translation>%1 では破損フレームしか受信できません。バスのビットレートが異なります</translation>
    </message>
    <message>
        <source>only disturbed frames arrive on %1, the bus has another bit rate than %2</source>
        <translation>%1 では破損フレームしか受信できません。バスのビットレートが %2 と異なります</translation>
    </message>
    <message>
        <source>only its power stops it</source>
        <translation>停止手段は電源を切ることだけです</translation>
    </message>
    <message>
        <source>only those are recorded</source>
        <translation>記録できるのはそれだけです</translation>
    </message>
    <message>
        <source>open it again</source>
        <translation>もう一度開いてください</translation>
    </message>
    <message>
        <source>open that terminal as serial:%1</source>
        <translation>その端末を serial:%1 として開いてください</translation>
    </message>
    <message>
        <source>open the link that it was made on</source>
        <translation>作成時のリンクを開いてください</translation>
    </message>
    <message>
        <source>openocd is not installed</source>
        <translation>openocd がインストールされていません</translation>
    </message>
    <message>
        <source>option &apos;%1&apos; is not KEY=VALUE</source>
        <translation>オプション「%1」は KEY=VALUE の形式ではありません</translation>
    </message>
    <message>
        <source>page %1 accepted with CRC variant %2</source>
        <translation>ページ %1 は CRC 方式 %2 で受理されました</translation>
    </message>
    <message>
        <source>page %1 cannot be written: its flash failed the device&apos;s own check %2 times</source>
        <translation>ページ %1 を書き込めません: 機器によるフラッシュの検査に %2 回失敗しました</translation>
    </message>
    <message>
        <source>page %1 was not accepted in %2 tries</source>
        <translation>ページ %1 は %2 回試みましたが受理されませんでした</translation>
    </message>
    <message>
        <source>page %1 was said to be written before its bytes can have arrived</source>
        <translation>ページ %1 は、全バイトが届くはずのない時点で書込み完了と通知されました</translation>
    </message>
    <message>
        <source>page %1: %2, sent again</source>
        <translation>ページ %1: %2、再送しました</translation>
    </message>
    <message>
        <source>page 0: its status was lost, but the version is there; it is not written again</source>
        <translation>ページ 0: 状態は受信できませんでしたが、バージョンは書き込まれています。再書込みしません</translation>
    </message>
    <message>
        <source>pages 31-34 (configuration and descriptors)</source>
        <translation>ページ 31-34 (構成とディスクリプタ)</translation>
    </message>
    <message>
        <source>pages 35-42 (bootloader and flash configuration)</source>
        <translation>ページ 35-42 (ブートローダとフラッシュ構成)</translation>
    </message>
    <message>
        <source>parameters that were changed last may be lost: %1</source>
        <translation>最後に変更したパラメータが失われる可能性があります: %1</translation>
    </message>
    <message>
        <source>pause=%1: legal are 0 to 1000 milliseconds</source>
        <translation>pause=%1: 有効な値は 0 ～ 1000 ミリ秒です</translation>
    </message>
    <message>
        <source>plug in an adapter</source>
        <translation>アダプタを接続してください</translation>
    </message>
    <message>
        <source>plug in an adapter at any time; it is opened by itself once it is up</source>
        <translation>アダプタはいつでも接続できます。オンになると自動的に開きます</translation>
    </message>
    <message>
        <source>plug in the adapter, or name another port</source>
        <translation>アダプタを接続するか、別のポートを指定してください</translation>
    </message>
    <message>
        <source>plug it in again</source>
        <translation>接続し直してください</translation>
    </message>
    <message>
        <source>plug one in</source>
        <translation>接続してください</translation>
    </message>
    <message>
        <source>plug the adapter in again; the link is opened by itself as soon as it is up</source>
        <translation>アダプタを再接続してください。オンになるとリンクが自動的に開きます</translation>
    </message>
    <message>
        <source>polarity 0 is active high: the board follows the maker&apos;s library</source>
        <translation>極性 0 はアクティブハイです: 基板はメーカーのライブラリに従っています</translation>
    </message>
    <message>
        <source>polarity 0 is active low: the board follows the data sheet</source>
        <translation>極性 0 はアクティブローです: 基板はデータシートに従っています</translation>
    </message>
    <message>
        <source>polarity bit %1: the input is active</source>
        <translation>極性ビット %1: 入力はアクティブです</translation>
    </message>
    <message>
        <source>polarity bit %1: the input is not active</source>
        <translation>極性ビット %1: 入力はアクティブではありません</translation>
    </message>
    <message>
        <source>position D has no effect that could be measured; its scale stays unknown</source>
        <translation>位置 D には測定できる効果がありません。スケールは不明のままです</translation>
    </message>
    <message>
        <source>position has 32 bits</source>
        <translation>位置は 32 ビットです</translation>
    </message>
    <message>
        <source>power %1: %2 and %3 counts/s</source>
        <translation>出力 %1: %2 と %3 counts/s</translation>
    </message>
    <message>
        <source>protocol error</source>
        <translation>プロトコルエラー</translation>
    </message>
    <message>
        <source>proving: a step of %1 A</source>
        <translation>検証中: %1 A のステップ</translation>
    </message>
    <message>
        <source>proving: a step of %1 counts</source>
        <translation>検証中: %1 counts のステップ</translation>
    </message>
    <message>
        <source>proving: a step of %1 counts/s</source>
        <translation>検証中: %1 counts/s のステップ</translation>
    </message>
    <message>
        <source>pty links have the option baud=BITS_PER_SECOND, not &apos;%1=%2&apos;</source>
        <translation>pty リンクのオプションは baud=BITS_PER_SECOND です。「%1=%2」は使えません</translation>
    </message>
    <message>
        <source>pty: is where &apos;simulate&apos; puts its devices</source>
        <translation>pty: は &apos;simulate&apos; が機器を置く場所です</translation>
    </message>
    <message>
        <source>push harder or longer</source>
        <translation>パルスを強くするか長くしてください</translation>
    </message>
    <message>
        <source>push longer, or ask for faster samples</source>
        <translation>パルスを長くするか、サンプルを速くしてください</translation>
    </message>
    <message>
        <source>push with two sizes</source>
        <translation>2 種類の大きさのパルスを使用してください</translation>
    </message>
    <message>
        <source>pushes of one size do not tell friction from gain</source>
        <translation>1 種類の大きさのパルスでは摩擦とゲインを区別できません</translation>
    </message>
    <message>
        <source>pushing with %1 duty for %2 s</source>
        <translation>デューティ %1 のパルスを %2 s 印加中</translation>
    </message>
    <message>
        <source>pushing with %1 duty for %2 s, %3 times</source>
        <translation>デューティ %1 のパルスを %2 s、%3 回印加中</translation>
    </message>
    <message>
        <source>putting the settings back</source>
        <translation>設定を元に戻しています</translation>
    </message>
    <message>
        <source>qtcan links have the option bitrate=BITS_PER_SECOND, not &apos;%1=%2&apos;</source>
        <translation>qtcan リンクのオプションは bitrate=BITS_PER_SECOND です。「%1=%2」は使えません</translation>
    </message>
    <message>
        <source>read gain.p</source>
        <translation>gain.p を読み出してください</translation>
    </message>
    <message>
        <source>read it again</source>
        <translation>読み直してください</translation>
    </message>
    <message>
        <source>read it first</source>
        <translation>先に読み出してください</translation>
    </message>
    <message>
        <source>read profile.velocity and profile.acceleration</source>
        <translation>profile.velocity と profile.acceleration を読み出してください</translation>
    </message>
    <message>
        <source>recessive bit not sent</source>
        <translation>レセシブビットを送信できません</translation>
    </message>
    <message>
        <source>reconnect</source>
        <translation>再接続してください</translation>
    </message>
    <message>
        <source>record again</source>
        <translation>記録し直してください</translation>
    </message>
    <message>
        <source>record type %1 is unknown</source>
        <translation>レコードタイプ %1 は不明です</translation>
    </message>
    <message>
        <source>refused: %1</source>
        <translation>拒否: %1</translation>
    </message>
    <message>
        <source>remove it</source>
        <translation>取り除いてください</translation>
    </message>
    <message>
        <source>remove it, or make it readable</source>
        <translation>取り除くか、読込み可能にしてください</translation>
    </message>
    <message>
        <source>remove the cause, then test again</source>
        <translation>原因を取り除いて再試験してください</translation>
    </message>
    <message>
        <source>replay links have no option &apos;%1&apos;</source>
        <translation>replay リンクにオプション「%1」はありません</translation>
    </message>
    <message>
        <source>residual %1 of what counts and clocks explain, at most 3</source>
        <translation>残差がカウントとクロックで説明できる値の %1 倍です (最大 3)</translation>
    </message>
    <message>
        <source>restarted, the application answers</source>
        <translation>再起動し、アプリケーションが応答しました</translation>
    </message>
    <message>
        <source>run avrdude by hand to see all it says</source>
        <translation>詳細を確認するには avrdude を手動で実行してください</translation>
    </message>
    <message>
        <source>run it by hand to see all it says</source>
        <translation>詳細を確認するには手動で実行してください</translation>
    </message>
    <message>
        <source>run it by hand with -c %1</source>
        <translation>-c %1 を付けて手動で実行してください</translation>
    </message>
    <message>
        <source>run it by hand with interface %1</source>
        <translation>インターフェース %1 で手動で実行してください</translation>
    </message>
    <message>
        <source>sample point %1 %</source>
        <translation>サンプルポイント %1 %</translation>
    </message>
    <message>
        <source>save it as ASC and take that</source>
        <translation>ASC 形式で保存し、それを使用してください</translation>
    </message>
    <message>
        <source>scan again, or choose its dialect by hand</source>
        <translation>再スキャンするか、ダイアレクトを手動で選択してください</translation>
    </message>
    <message>
        <source>see that motor and load are those of the recipe, then test again</source>
        <translation>モーターと負荷がレシピどおりであることを確認して再試験してください</translation>
    </message>
    <message>
        <source>see that nothing is loose and that steps look alike</source>
        <translation>緩みがないこと、各ステップの応答がそろっていることを確認してください</translation>
    </message>
    <message>
        <source>see that nothing is loose, and write gains once with which it comes to rest</source>
        <translation>緩みがないことを確認し、静止するゲインを一度書き込んでください</translation>
    </message>
    <message>
        <source>see that nothing is loose; a stronger load than it was built for cannot be tuned</source>
        <translation>緩みがないことを確認してください。設計を超える強い負荷は調整できません</translation>
    </message>
    <message>
        <source>see that the motor is connected</source>
        <translation>モーターが接続されていることを確認してください</translation>
    </message>
    <message>
        <source>see that the server runs; entries wait here until it does</source>
        <translation>サーバーの動作を確認してください。項目はそれまでここで待機します</translation>
    </message>
    <message>
        <source>see that this is the motor and the encoder of the recipe, then test again</source>
        <translation>モーターとエンコーダがレシピどおりであることを確認して再試験してください</translation>
    </message>
    <message>
        <source>see whether a load always pulls one way</source>
        <translation>負荷が常に一方向に引いていないか確認してください</translation>
    </message>
    <message>
        <source>see whether brushes and plugs make contact</source>
        <translation>ブラシとコネクタの接触を確認してください</translation>
    </message>
    <message>
        <source>select a longer stretch</source>
        <translation>より長い区間を選択してください</translation>
    </message>
    <message>
        <source>sending the firmware</source>
        <translation>ファームウェアを送信中</translation>
    </message>
    <message>
        <source>serial number %1</source>
        <translation>シリアル番号 %1</translation>
    </message>
    <message>
        <source>service</source>
        <translation>保守</translation>
    </message>
    <message>
        <source>several units answer as number %1</source>
        <translation>複数の機器が番号 %1 で応答しています</translation>
    </message>
    <message>
        <source>several units answer under this number in the recording</source>
        <translation>記録の中で、複数の機器がこの番号で応答しています</translation>
    </message>
    <message>
        <source>several units have a snapshot &apos;%1&apos;</source>
        <translation>スナップショット「%1」は複数の機器にあります</translation>
    </message>
    <message>
        <source>sim: stands for several links</source>
        <translation>sim: は複数のリンクを表します</translation>
    </message>
    <message>
        <source>simulated links belong to a bench</source>
        <translation>シミュレーションリンクはベンチに属します</translation>
    </message>
    <message>
        <source>sine %1 of %2, %3 Hz: %4</source>
        <translation>正弦波 %1/%2、%3 Hz: %4</translation>
    </message>
    <message>
        <source>snapshot %1, %2: %3 values</source>
        <translation>スナップショット %1、%2: 値 %3 個</translation>
    </message>
    <message>
        <source>socketcan links have no option &apos;%1&apos;</source>
        <translation>socketcan リンクにオプション「%1」はありません</translation>
    </message>
    <message>
        <source>somebody may have started it again, so the position was not reset</source>
        <translation>再び始動された可能性があるため、位置をリセットしていません</translation>
    </message>
    <message>
        <source>something follows the end-of-file record</source>
        <translation>ファイル終端レコードの後に何かあります</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>speed %1 counts/s is above 1.2 × %2 counts/s</source>
        <translation>速度 %1 counts/s が 1.2 × %2 counts/s を超えています</translation>
    </message>
    <message>
        <source>speed is 10000 to 10000000 Hz, not &apos;%1&apos;</source>
        <translation>speed は 10000 ～ 10000000 Hz です。「%1」は使えません</translation>
    </message>
    <message>
        <source>speed, ready and reset are known</source>
        <translation>使えるのは speed、ready、reset です</translation>
    </message>
    <message>
        <source>speed=%1 is no speed</source>
        <translation>speed=%1 は速度ではありません</translation>
    </message>
    <message>
        <source>spidev links have no option &apos;%1&apos;</source>
        <translation>spidev リンクにオプション「%1」はありません</translation>
    </message>
    <message>
        <source>stalled, or the encoder is dead: less than 3 counts in %1</source>
        <translation>ストール、またはエンコーダの故障: %1 の間に 3 counts 未満です</translation>
    </message>
    <message>
        <source>start it again</source>
        <translation>再起動してください</translation>
    </message>
    <message>
        <source>start the reader first</source>
        <translation>先に読み手を起動してください</translation>
    </message>
    <message>
        <source>start the simulator again</source>
        <translation>シミュレータを再起動してください</translation>
    </message>
    <message>
        <source>start the simulator first</source>
        <translation>先にシミュレータを起動してください</translation>
    </message>
    <message>
        <source>steps with one pair of gains only do not tell what each of them does</source>
        <translation>1 組のゲインによるステップだけでは、各ゲインの働きがわかりません</translation>
    </message>
    <message>
        <source>stop it before its gains are put back</source>
        <translation>ゲインを元に戻す前に停止してください</translation>
    </message>
    <message>
        <source>stop it first</source>
        <translation>先に停止してください</translation>
    </message>
    <message>
        <source>stop it there first</source>
        <translation>先にそちらで停止してください</translation>
    </message>
    <message>
        <source>stop it, then put the values back</source>
        <translation>停止してから値を元に戻してください</translation>
    </message>
    <message>
        <source>stop the motor before an experiment begins</source>
        <translation>実験を始める前にモーターを停止してください</translation>
    </message>
    <message>
        <source>stop the motor before its dialect is changed</source>
        <translation>ダイアレクトを変更する前にモーターを停止してください</translation>
    </message>
    <message>
        <source>stop the motor first</source>
        <translation>先にモーターを停止してください</translation>
    </message>
    <message>
        <source>stop the motor first: the drive stands still while it writes its flash</source>
        <translation>先にモーターを停止してください: フラッシュの書込み中、ドライブは動作しません</translation>
    </message>
    <message>
        <source>stop the motors before settings are written again</source>
        <translation>設定を再書込みする前にモーターを停止してください</translation>
    </message>
    <message>
        <source>stop the motors first</source>
        <translation>先にモーターを停止してください</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>stopped while it waited for a number</source>
        <translation>番号の割当て待ちの間に停止されました</translation>
    </message>
    <message>
        <source>stopped: %1</source>
        <translation>停止: %1</translation>
    </message>
    <message>
        <source>stopped: the window did not respond in time</source>
        <translation>停止: ウィンドウが時間内に応答しませんでした</translation>
    </message>
    <message>
        <source>stored, not verifiable</source>
        <translation>保存しましたが、検証できません</translation>
    </message>
    <message>
        <source>stuff error</source>
        <translation>スタッフエラー</translation>
    </message>
    <message>
        <source>such a line reads %1</source>
        <translation>行の形式は %1 です</translation>
    </message>
    <message>
        <source>such as %1</source>
        <translation>例: %1</translation>
    </message>
    <message>
        <source>supply %1 V is outside %2 … %3 V</source>
        <translation>電源 %1 V が %2 … %3 V の範囲外です</translation>
    </message>
    <message>
        <source>switch it off and on</source>
        <translation>電源を入れ直してください</translation>
    </message>
    <message>
        <source>switch the devices on, check the cable and that two 120 Ω resistors end the bus, and that every device has the bit rate %1</source>
        <translation>機器の電源を入れ、ケーブル、バス両端の 120 Ω 抵抗 2 個、全機器のビットレートが %1 であることを確認してください</translation>
    </message>
    <message>
        <source>switch the devices on, check the cable and that two 120 Ω resistors end the bus, and that every device has the bit rate of this interface</source>
        <translation>機器の電源を入れ、ケーブル、バス両端の 120 Ω 抵抗 2 個、全機器のビットレートがこのインターフェースと同じことを確認してください</translation>
    </message>
    <message>
        <source>take a finer encoder or a calmer loop</source>
        <translation>分解能の高いエンコーダまたはより緩やかな制御ループを使用してください</translation>
    </message>
    <message>
        <source>take a smaller step or widen it</source>
        <translation>ステップを小さくするか、範囲を広げてください</translation>
    </message>
    <message>
        <source>take one of them</source>
        <translation>そのいずれかを使用してください</translation>
    </message>
    <message>
        <source>take the jumper out and reset it</source>
        <translation>ジャンパを外してリセットしてください</translation>
    </message>
    <message>
        <source>take the jumper out; the board is asked for its version</source>
        <translation>ジャンパを外してください。基板にバージョンを問い合わせます</translation>
    </message>
    <message>
        <source>take the other one off, or give one of them another number</source>
        <translation>もう一方を取り外すか、どちらかに別の番号を割り当ててください</translation>
    </message>
    <message>
        <source>temperature %1 °C is within 5 K of %2 °C</source>
        <translation>温度 %1 °C が %2 °C まで 5 K 以内です</translation>
    </message>
    <message>
        <source>test again when it is safe</source>
        <translation>安全を確認してから再試験してください</translation>
    </message>
    <message>
        <source>the %1 gains did not: %2</source>
        <translation>ゲイン「%1」では達成できませんでした: %2</translation>
    </message>
    <message>
        <source>the %1 loop was saved %2 times; after %3 its settings pages must be erased</source>
        <translation>%1 ループは %2 回保存されました。%3 回を超えたら設定ページの消去が必要です</translation>
    </message>
    <message>
        <source>the acknowledge delimiter</source>
        <translation>ACK デリミタ</translation>
    </message>
    <message>
        <source>the acknowledge slot</source>
        <translation>ACK スロット</translation>
    </message>
    <message>
        <source>the answer to the reset was lost; found again by enumeration</source>
        <translation>リセットへの応答を受信できませんでしたが、列挙で再検出しました</translation>
    </message>
    <message>
        <source>the axis has a power limit of %1 %, which is kept</source>
        <translation>この軸の出力制限は %1 % で、これを守ります</translation>
    </message>
    <message>
        <source>the base of the numbers is %1, not hex or dec</source>
        <translation>数値の基数が hex または dec ではなく %1 です</translation>
    </message>
    <message>
        <source>the board answered with an error that its documents do not name</source>
        <translation>基板が文書にないエラーで応答しました</translation>
    </message>
    <message>
        <source>the board did not answer</source>
        <translation>基板が応答しませんでした</translation>
    </message>
    <message>
        <source>the board did not tell its status</source>
        <translation>基板が状態を通知しませんでした</translation>
    </message>
    <message>
        <source>the board does not know this command</source>
        <translation>基板にこのコマンドはありません</translation>
    </message>
    <message>
        <source>the board does not tell its position</source>
        <translation>基板が位置を通知しません</translation>
    </message>
    <message>
        <source>the board found the packet malformed</source>
        <translation>基板がパケットを不正と判断しました</translation>
    </message>
    <message>
        <source>the board has axes 1 to 4</source>
        <translation>基板の軸は 1 ～ 4 です</translation>
    </message>
    <message>
        <source>the board has no number: chip select tells boards apart</source>
        <translation>基板には番号がありません: チップセレクトで区別します</translation>
    </message>
    <message>
        <source>the board has no such mode</source>
        <translation>基板にそのモードはありません</translation>
    </message>
    <message>
        <source>the board has one set of gains per axis</source>
        <translation>基板のゲインは軸ごとに 1 組です</translation>
    </message>
    <message>
        <source>the board is updated over its UART</source>
        <translation>基板の更新は UART 経由で行います</translation>
    </message>
    <message>
        <source>the board keeps nothing without power</source>
        <translation>基板は電源が切れると何も保持しません</translation>
    </message>
    <message>
        <source>the board may want velocity targets times 4096: choose that setting, and try again</source>
        <translation>基板の速度目標値は × 4096 かもしれません: その設定を選択して再試行してください</translation>
    </message>
    <message>
        <source>the board refused a value</source>
        <translation>基板が値を拒否しました</translation>
    </message>
    <message>
        <source>the board restarted at %1</source>
        <translation>基板が %1 に再起動しました</translation>
    </message>
    <message>
        <source>the board sent a reply without a return code</source>
        <translation>基板の応答に戻り値がありませんでした</translation>
    </message>
    <message>
        <source>the board speaks protocol %1, this program was written for protocol 1; watch it before it is driven</source>
        <translation>基板のプロトコルは %1 ですが、このプログラムはプロトコル 1 用です。駆動する前に動作を監視してください</translation>
    </message>
    <message>
        <source>the board was reset since its settings were written</source>
        <translation>設定の書込み後に基板がリセットされました</translation>
    </message>
    <message>
        <source>the board was unplugged</source>
        <translation>基板が取り外されました</translation>
    </message>
    <message>
        <source>the bootloader did not announce itself</source>
        <translation>ブートローダの起動メッセージがありませんでした</translation>
    </message>
    <message>
        <source>the bootloader refuses page %1</source>
        <translation>ブートローダがページ %1 を拒否しました</translation>
    </message>
    <message>
        <source>the bootloader said nothing</source>
        <translation>ブートローダから応答がありませんでした</translation>
    </message>
    <message>
        <source>the bus leaves no room for what %1 sends</source>
        <translation>バスに %1 が送信する余裕がありません</translation>
    </message>
    <message>
        <source>the byte count was out of step</source>
        <translation>バイト数が一致しませんでした</translation>
    </message>
    <message>
        <source>the cable was pulled out</source>
        <translation>ケーブルが抜かれました</translation>
    </message>
    <message>
        <source>the checksum</source>
        <translation>チェックサム</translation>
    </message>
    <message>
        <source>the checksum delimiter</source>
        <translation>CRC デリミタ</translation>
    </message>
    <message>
        <source>the computer slept</source>
        <translation>コンピューターがスリープしました</translation>
    </message>
    <message>
        <source>the controller lost frames to send</source>
        <translation>CAN コントローラが送信フレームを失いました</translation>
    </message>
    <message>
        <source>the controller lost received frames</source>
        <translation>CAN コントローラが受信フレームを失いました</translation>
    </message>
    <message>
        <source>the controller may hold half a program, and runs again once an update has succeeded</source>
        <translation>コントローラのプログラムが不完全な可能性があります。更新に成功すれば再び動作します</translation>
    </message>
    <message>
        <source>the controller started again</source>
        <translation>コントローラが再起動しました</translation>
    </message>
    <message>
        <source>the current did not follow the duty, so its resistance is not known</source>
        <translation>電流がデューティに追従しなかったため、抵抗が不明です</translation>
    </message>
    <message>
        <source>the current limit cut into the pushes</source>
        <translation>パルス中に電流制限が働きました</translation>
    </message>
    <message>
        <source>the data</source>
        <translation>データ</translation>
    </message>
    <message>
        <source>the data masks have an unexpected length</source>
        <translation>データマスクの長さが想定と異なります</translation>
    </message>
    <message>
        <source>the data runs past the end of 32-bit addresses</source>
        <translation>データが 32 ビットアドレスの終わりを超えています</translation>
    </message>
    <message>
        <source>the data runs past the end of its 64 KiB segment</source>
        <translation>データが 64 KiB セグメントの終わりを超えています</translation>
    </message>
    <message>
        <source>the device already runs %1</source>
        <translation>機器はすでに %1 で動作しています</translation>
    </message>
    <message>
        <source>the device answers with no application</source>
        <translation>機器の応答によると、アプリケーションがありません</translation>
    </message>
    <message>
        <source>the device answers with version %1</source>
        <translation>機器はバージョン %1 で応答しました</translation>
    </message>
    <message>
        <source>the device could not verify its flash</source>
        <translation>機器がフラッシュを検証できませんでした</translation>
    </message>
    <message>
        <source>the device does not answer</source>
        <translation>機器が応答しません</translation>
    </message>
    <message>
        <source>the device is busy with something else</source>
        <translation>機器は別の処理でビジーです</translation>
    </message>
    <message>
        <source>the device is gone</source>
        <translation>機器がなくなりました</translation>
    </message>
    <message>
        <source>the device is not heard any more</source>
        <translation>機器からの受信が途絶えました</translation>
    </message>
    <message>
        <source>the device may have restarted: once more from page %1</source>
        <translation>機器が再起動した可能性があります: ページ %1 からやり直します</translation>
    </message>
    <message>
        <source>the device restarted</source>
        <translation>機器が再起動しました</translation>
    </message>
    <message>
        <source>the device restarted %1 times during the update</source>
        <translation>更新中に機器が %1 回再起動しました</translation>
    </message>
    <message>
        <source>the device restarted before its flash was proved to be written</source>
        <translation>フラッシュへの書込みが証明される前に機器が再起動しました</translation>
    </message>
    <message>
        <source>the device says that the motor is not started; it may have lost its supply</source>
        <translation>機器によるとモーターが始動していません。電源が失われた可能性があります</translation>
    </message>
    <message>
        <source>the device&apos;s rate was not put back: %1</source>
        <translation>機器の周波数を元に戻していません: %1</translation>
    </message>
    <message>
        <source>the disk has not made %1 within 10 s</source>
        <translation>ディスクが 10 s 以内に %1 を作成しませんでした</translation>
    </message>
    <message>
        <source>the disk has not taken %1 for 30 s</source>
        <translation>ディスクが 30 s 間 %1 を受け付けていません</translation>
    </message>
    <message>
        <source>the disk is full</source>
        <translation>ディスクがいっぱいです</translation>
    </message>
    <message>
        <source>the disk of %1 does not answer</source>
        <translation>%1 のディスクが応答しません</translation>
    </message>
    <message>
        <source>the drive does not check it and would overwrite its memory</source>
        <translation>ドライブはこれを検査せず、メモリを上書きします</translation>
    </message>
    <message>
        <source>the driver of %1 cannot switch the direction of an RS-485 line, so the adapter has to do it by itself; if nothing answers, use one that does</source>
        <translation>%1 のドライバは RS-485 の方向切替えができないため、アダプタが自動で切り替える必要があります。応答がない場合は、自動切替えのアダプタを使用してください</translation>
    </message>
    <message>
        <source>the duty changed its direction %1 times in a second</source>
        <translation>デューティの方向が 1 秒間に %1 回変わりました</translation>
    </message>
    <message>
        <source>the encoder counts against the power</source>
        <translation>エンコーダの計数方向が出力と逆です</translation>
    </message>
    <message>
        <source>the encoder does not count both ways</source>
        <translation>エンコーダが両方向に計数しません</translation>
    </message>
    <message>
        <source>the end of frame</source>
        <translation>エンドオブフレーム</translation>
    </message>
    <message>
        <source>the end-of-file record is missing, the file may be cut off</source>
        <translation>ファイル終端レコードがありません。ファイルが途中で切れている可能性があります</translation>
    </message>
    <message>
        <source>the file has no lines to send</source>
        <translation>ファイルに送信する行がありません</translation>
    </message>
    <message>
        <source>the file has reached the greatest size there</source>
        <translation>ファイルがその場所での最大サイズに達しました</translation>
    </message>
    <message>
        <source>the file holds no data</source>
        <translation>ファイルにデータがありません</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>ファイルが空です</translation>
    </message>
    <message>
        <source>the folder %1 cannot be made</source>
        <translation>フォルダ %1 を作成できません</translation>
    </message>
    <message>
        <source>the folder %1 cannot be written</source>
        <translation>フォルダ %1 に書き込めません</translation>
    </message>
    <message>
        <source>the formula is nested too deeply</source>
        <translation>数式の入れ子が深すぎます</translation>
    </message>
    <message>
        <source>the formula uses no signal</source>
        <translation>数式に信号がありません</translation>
    </message>
    <message>
        <source>the frame has %1 of %2 bytes</source>
        <translation>フレームは %2 バイト中 %1 バイトです</translation>
    </message>
    <message>
        <source>the frame is of the kind %1, not d or r</source>
        <translation>フレームの種類が d または r ではなく %1 です</translation>
    </message>
    <message>
        <source>the frame says %1 in the place of Rx or Tx</source>
        <translation>フレームの Rx または Tx の位置が %1 です</translation>
    </message>
    <message>
        <source>the gain had nothing to act on</source>
        <translation>ゲインの作用する対象がありませんでした</translation>
    </message>
    <message>
        <source>the gain scale is too coarse to be measured with so little power</source>
        <translation>ゲインのスケールが粗く、この小さい出力では測定できません</translation>
    </message>
    <message>
        <source>the gains found at different values do not agree, so that a gain is no simple factor</source>
        <translation>異なる値で求めたゲインが一致しません。ゲインは単純な係数ではありません</translation>
    </message>
    <message>
        <source>the gains of this loop are not known here, so its target stays within %1 of where it is: a weak loop may not move it; write its p, d and divisor once</source>
        <translation>この制御ループのゲインが不明なため、目標は現在位置から %1 以内とします: 弱いループでは動かないことがあります。p、d と divisor を一度書き込んでください</translation>
    </message>
    <message>
        <source>the gains stored in the drive are erased; all its loops do nothing until they are written again</source>
        <translation>ドライブに保存されたゲインを消去しました。書き直すまで、どの制御ループも働きません</translation>
    </message>
    <message>
        <source>the gains that trial #%1 had changed are put back</source>
        <translation>試行 #%1 で変更したゲインを元に戻しました</translation>
    </message>
    <message>
        <source>the guardian does not answer</source>
        <translation>監視プロセスが応答しません</translation>
    </message>
    <message>
        <source>the guardian does not stand by yet</source>
        <translation>監視プロセスがまだ待機していません</translation>
    </message>
    <message>
        <source>the guardian ended unexpectedly</source>
        <translation>監視プロセスが予期せず終了しました</translation>
    </message>
    <message>
        <source>the guardian has sent the stop, which nothing on this link confirms; look whether the motor stands</source>
        <translation>監視プロセスが停止を送信しましたが、このリンクでは確認されません。モーターが停止しているか目視で確認してください</translation>
    </message>
    <message>
        <source>the guardian has stopped the motor</source>
        <translation>監視プロセスがモーターを停止しました</translation>
    </message>
    <message>
        <source>the guardian is of another version</source>
        <translation>監視プロセスのバージョンが異なります</translation>
    </message>
    <message>
        <source>the guardian sent the stop because this program was held up, not confirmed</source>
        <translation>このプログラムが停滞したため、監視プロセスが停止を送信しました (未確認)</translation>
    </message>
    <message>
        <source>the guardian stopped the motor because this program was held up</source>
        <translation>このプログラムが停滞したため、監視プロセスがモーターを停止しました</translation>
    </message>
    <message>
        <source>the guardian tried in vain to stop the motor; it may still turn: cut its power</source>
        <translation>監視プロセスがモーターの停止を試みましたが失敗しました。まだ回転している可能性があります: 電源を切ってください</translation>
    </message>
    <message>
        <source>the guardian tried to stop the motor because this program was held up, without an answer</source>
        <translation>このプログラムが停滞したため、監視プロセスがモーターの停止を試みましたが、応答がありません</translation>
    </message>
    <message>
        <source>the history does not have this write: %1</source>
        <translation>この書込みは履歴にありません: %1</translation>
    </message>
    <message>
        <source>the history has an unexpected length</source>
        <translation>履歴の長さが想定と異なります</translation>
    </message>
    <message>
        <source>the history of %1 has nothing to do again</source>
        <translation>%1 の履歴にやり直すものがありません</translation>
    </message>
    <message>
        <source>the history of %1 has nothing to undo</source>
        <translation>%1 の履歴に元に戻すものがありません</translation>
    </message>
    <message>
        <source>the identifier</source>
        <translation>識別子</translation>
    </message>
    <message>
        <source>the identifier extension bit</source>
        <translation>識別子拡張ビット (IDE)</translation>
    </message>
    <message>
        <source>the image is for product 602, this unit is product %1%2%3</source>
        <translation>イメージは製品 602 用ですが、この機器は製品 %1%2%3 です</translation>
    </message>
    <message>
        <source>the image itself writes the settings pages</source>
        <translation>イメージ自体が設定ページを書き込みます</translation>
    </message>
    <message>
        <source>the intermission</source>
        <translation>インターミッション</translation>
    </message>
    <message>
        <source>the journal on the server was made by a newer version of this program</source>
        <translation>サーバー上のジャーナルは、このプログラムの新しいバージョンで作成されました</translation>
    </message>
    <message>
        <source>the journal&apos;s server: %1</source>
        <translation>ジャーナルのサーバー: %1</translation>
    </message>
    <message>
        <source>the jumper is still in: take it out, then reset the board</source>
        <translation>ジャンパが付いたままです: 外してから基板をリセットしてください</translation>
    </message>
    <message>
        <source>the kernel does not list its interfaces: %1</source>
        <translation>カーネルからインターフェース一覧を取得できません: %1</translation>
    </message>
    <message>
        <source>the key &apos;%1&apos; is there twice</source>
        <translation>キー「%1」が重複しています</translation>
    </message>
    <message>
        <source>the layout has more than 500 traces</source>
        <translation>レイアウトの波形が 500 を超えています</translation>
    </message>
    <message>
        <source>the length</source>
        <translation>データ長</translation>
    </message>
    <message>
        <source>the length of the frame is %1</source>
        <translation>フレームの長さが %1 です</translation>
    </message>
    <message>
        <source>the limit of &apos;%1&apos; must be the greatest value, 0 or more, or [least, greatest]</source>
        <translation>「%1」の制限は 0 以上の最大値、または [最小値, 最大値] でなければなりません</translation>
    </message>
    <message>
        <source>the link is not open</source>
        <translation>リンクが開いていません</translation>
    </message>
    <message>
        <source>the link was opened anew</source>
        <translation>リンクを開き直しました</translation>
    </message>
    <message>
        <source>the loop drives the motor the wrong way</source>
        <translation>制御ループがモーターを逆方向に駆動しています</translation>
    </message>
    <message>
        <source>the loop swings itself up: %1 swings, each larger than the last or with full duty</source>
        <translation>制御ループが発振しています: %1 回の振動で、毎回増大するか最大デューティに達しました</translation>
    </message>
    <message>
        <source>the loop does not come to rest: %1 swings</source>
        <translation>制御ループが静止しません: %1 回の振動</translation>
    </message>
    <message>
        <source>the loop would be undefined</source>
        <translation>制御ループが未定義になります</translation>
    </message>
    <message>
        <source>the microcontroller of the drive is f1 (STM32F1) or f4 (STM32F4)</source>
        <translation>ドライブのマイクロコントローラは f1 (STM32F1) または f4 (STM32F4) です</translation>
    </message>
    <message>
        <source>the model is not to be believed: %1</source>
        <translation>モデルを信頼できません: %1</translation>
    </message>
    <message>
        <source>the motor did not follow a step: stalled, or the encoder is dead</source>
        <translation>モーターがステップに追従しませんでした: ストール、またはエンコーダの故障です</translation>
    </message>
    <message>
        <source>the motor did not move at up to %1 % duty (%2 counts): stalled, or the encoder is dead</source>
        <translation>デューティ %1 % までモーターが動きませんでした (%2 counts): ストール、またはエンコーダの故障です</translation>
    </message>
    <message>
        <source>the motor did not turn at two of the powers</source>
        <translation>2 種類の出力でモーターが回転しませんでした</translation>
    </message>
    <message>
        <source>the motor did not turn at up to %1 duty: stalled, or the encoder is dead</source>
        <translation>デューティ %1 までモーターが回転しませんでした: ストール、またはエンコーダの故障です</translation>
    </message>
    <message>
        <source>the motor did not turn the way it was pushed</source>
        <translation>モーターがパルスの方向に回転しませんでした</translation>
    </message>
    <message>
        <source>the motor gives %1 counts/s per power unit, friction takes %2 units, it follows within %3 ms</source>
        <translation>モーターは出力 1 単位あたり %1 counts/s、摩擦は %2 単位、追従は %3 ms 以内です</translation>
    </message>
    <message>
        <source>the motor is not seen to stand</source>
        <translation>モーターの停止を確認できません</translation>
    </message>
    <message>
        <source>the motor ran faster than the power limit allows</source>
        <translation>モーターが出力制限から見込まれる速度を超えました</translation>
    </message>
    <message>
        <source>the motor reversed during a sine of %1 Hz: friction is in it</source>
        <translation>%1 Hz の正弦波でモーターが反転しました: 摩擦の影響が含まれます</translation>
    </message>
    <message>
        <source>the motor took the heat of %1 s at %2 A, 10 s are allowed; let it cool</source>
        <translation>モーターが %2 A で %1 s 相当の熱を受けました。許容は 10 s です。冷ましてください</translation>
    </message>
    <message>
        <source>the motor turned too short a time below the power limit to be measured</source>
        <translation>出力制限未満で回転した時間が短く、測定できません</translation>
    </message>
    <message>
        <source>the motor turns differently in both directions</source>
        <translation>モーターの回転が方向によって異なります</translation>
    </message>
    <message>
        <source>the motor was not seen to stand</source>
        <translation>モーターの停止を確認できませんでした</translation>
    </message>
    <message>
        <source>the motor was stopped</source>
        <translation>モーターを停止しました</translation>
    </message>
    <message>
        <source>the motor was stopped: %1</source>
        <translation>モーターを停止しました: %1</translation>
    </message>
    <message>
        <source>the motors that were not seen to stand were looked at; their stops are dismissed</source>
        <translation>停止を確認できなかったモーターは目視で確認されました。停止の警告を取り下げます</translation>
    </message>
    <message>
        <source>the motors were told to stop, and are not seen to stand</source>
        <translation>モーターに停止を指令しましたが、停止を確認できません</translation>
    </message>
    <message>
        <source>the name was written, but the device answers &apos;%1&apos;</source>
        <translation>名前を書き込みましたが、機器の応答は「%1」です</translation>
    </message>
    <message>
        <source>the nearest it can is %1</source>
        <translation>最も近い値は %1 です</translation>
    </message>
    <message>
        <source>the offset of an Abstract DC Drive is compiled into its firmware</source>
        <translation>Abstract DC Drive のオフセットはファームウェアに組み込まれています</translation>
    </message>
    <message>
        <source>the order was dropped: what it was for has ended</source>
        <translation>指令を破棄しました: 対象の処理が終了しました</translation>
    </message>
    <message>
        <source>the other end of %1 closed it</source>
        <translation>%1 の相手側が閉じました</translation>
    </message>
    <message>
        <source>the other end of %1 hung up</source>
        <translation>%1 の相手側が切断しました</translation>
    </message>
    <message>
        <source>the output of its loop passed 32767, where it turns to full reverse</source>
        <translation>制御ループの出力が 32767 を超えました。超えると逆転最大に反転します</translation>
    </message>
    <message>
        <source>the packet is too long for the board</source>
        <translation>パケットが基板には長すぎます</translation>
    </message>
    <message>
        <source>the plugin %1 finds no adapter</source>
        <translation>プラグイン %1 がアダプタを検出できません</translation>
    </message>
    <message>
        <source>the plugin %1 finds no adapter (%2)</source>
        <translation>プラグイン %1 がアダプタを検出できません (%2)</translation>
    </message>
    <message>
        <source>the position is not known yet, so nothing would keep the motor from jumping</source>
        <translation>位置がまだ不明なため、モーターの位置飛びを防げません</translation>
    </message>
    <message>
        <source>the position is written only while the output is off</source>
        <translation>位置は出力がオフのときだけ書き込みます</translation>
    </message>
    <message>
        <source>the position was not reset: %1</source>
        <translation>位置をリセットしていません: %1</translation>
    </message>
    <message>
        <source>the positions have an unexpected length</source>
        <translation>位置の長さが想定と異なります</translation>
    </message>
    <message>
        <source>the profiled move passed its target by more than its stopping distance, as this firmware may above 2500 counts/s; use a lower profile.velocity</source>
        <translation>プロファイル動作が停止距離を超えて目標を行き過ぎました。このファームウェアでは 2500 counts/s を超えると起こり得ます。profile.velocity を小さくしてください</translation>
    </message>
    <message>
        <source>the pushes differ by %1 in their resistance, at most 15 %</source>
        <translation>パルス間で抵抗値が %1 異なります (最大 15 %)</translation>
    </message>
    <message>
        <source>the ramp must be 0 (immediate) or a positive number of duty per second</source>
        <translation>ランプは 0 (即時) または 1 秒あたりのデューティを正の数で指定してください</translation>
    </message>
    <message>
        <source>the ramp must be 0 or a positive number of duty per second</source>
        <translation>ランプは 0、または 1 秒あたりのデューティを正の数で指定してください</translation>
    </message>
    <message>
        <source>the ready line stayed low</source>
        <translation>レディ線が low のままです</translation>
    </message>
    <message>
        <source>the record is cut off after %1 bytes</source>
        <translation>レコードが %1 バイトで途切れています</translation>
    </message>
    <message>
        <source>the recording has ended: %1</source>
        <translation>記録が終了しました: %1</translation>
    </message>
    <message>
        <source>the remote bit</source>
        <translation>リモートビット (RTR)</translation>
    </message>
    <message>
        <source>the reply has an unexpected length</source>
        <translation>応答の長さが想定と異なります</translation>
    </message>
    <message>
        <source>the report cannot be painted</source>
        <translation>レポートを描画できません</translation>
    </message>
    <message>
        <source>the reset line was pulsed</source>
        <translation>リセット線にパルスを出力しました</translation>
    </message>
    <message>
        <source>the resistance is known within %1, at most 10 %</source>
        <translation>抵抗値の不確かさが %1 です (最大 10 %)</translation>
    </message>
    <message>
        <source>the response could not be measured</source>
        <translation>応答を測定できませんでした</translation>
    </message>
    <message>
        <source>the same interface as socketcan:%1, which also counts losses</source>
        <translation>socketcan:%1 と同じインターフェースです。socketcan では欠落も計数します</translation>
    </message>
    <message>
        <source>the scale of its gains is not known yet, and is found first: one to two minutes, with %1 % of its power at most</source>
        <translation>ゲインのスケールがまだ不明なため、先に測定します: 1 ～ 2 分、最大で出力の %1 %</translation>
    </message>
    <message>
        <source>the search was cancelled; what it found stays</source>
        <translation>検索をキャンセルしました。見つかったものは残ります</translation>
    </message>
    <message>
        <source>the self-test could not go on: %1</source>
        <translation>セルフテストを続行できません: %1</translation>
    </message>
    <message>
        <source>the self-test was ended by the guard &apos;%1&apos;: %2</source>
        <translation>セルフテストはガード「%1」により終了しました: %2</translation>
    </message>
    <message>
        <source>the self-test was stopped by hand</source>
        <translation>セルフテストは手動で停止されました</translation>
    </message>
    <message>
        <source>the sensor counts down when the motor is driven up (%1 counts): one of them is reversed</source>
        <translation>正方向に駆動するとセンサが減少方向に計数します (%1 counts): どちらかが逆です</translation>
    </message>
    <message>
        <source>the sensor is reversed: it counts down</source>
        <translation>センサが逆です: 減少方向に計数します</translation>
    </message>
    <message>
        <source>the sensor is reversed: it counts up</source>
        <translation>センサが逆です: 増加方向に計数します</translation>
    </message>
    <message>
        <source>the set-point comes from here, not from the device</source>
        <translation>目標値は機器からではなくここから送られます</translation>
    </message>
    <message>
        <source>the set-point of the step</source>
        <translation>ステップの目標値</translation>
    </message>
    <message>
        <source>the settings of the %1 loop were saved %2 times</source>
        <translation>%1 ループの設定は %2 回保存されました</translation>
    </message>
    <message>
        <source>the settings that the reset took are written again</source>
        <translation>リセットで失われた設定を再書込みしています</translation>
    </message>
    <message>
        <source>the shaft must be free, without load on one side</source>
        <translation>シャフトは自由に回り、片側の負荷がない必要があります</translation>
    </message>
    <message>
        <source>the simulated board is in use by another link</source>
        <translation>シミュレーション基板は別のリンクが使用中です</translation>
    </message>
    <message>
        <source>the simulator at %1 closed the connection</source>
        <translation>%1 のシミュレータが接続を閉じました</translation>
    </message>
    <message>
        <source>the simulator at %1 sent bytes that nobody asked for</source>
        <translation>%1 のシミュレータが要求されていないバイトを送信しました</translation>
    </message>
    <message>
        <source>the speed does not grow evenly with the power</source>
        <translation>速度が出力に比例して増えません</translation>
    </message>
    <message>
        <source>the start of frame</source>
        <translation>スタートオブフレーム</translation>
    </message>
    <message>
        <source>the status bit is the same with both polarities, so it tells nothing</source>
        <translation>状態ビットが両方の極性で同じため、判定できません</translation>
    </message>
    <message>
        <source>the steps met the end of the output</source>
        <translation>ステップが出力の上限に達しました</translation>
    </message>
    <message>
        <source>the stop before it is not acknowledged yet</source>
        <translation>直前の停止がまだ確認応答されていません</translation>
    </message>
    <message>
        <source>the stop could not be sent, and is the first thing that goes out when the line is back; cut its power</source>
        <translation>停止を送信できませんでした。回線が復帰したら最初に送信します。電源を切ってください</translation>
    </message>
    <message>
        <source>the stop of the self-test was not confirmed: %1</source>
        <translation>セルフテストの停止が確認できませんでした: %1</translation>
    </message>
    <message>
        <source>the stop script of this device is not one that a guardian can carry out</source>
        <translation>この機器の停止スクリプトは監視プロセスでは実行できません</translation>
    </message>
    <message>
        <source>the stop was not acknowledged, so the position was not reset: a motor that runs would jump</source>
        <translation>停止が確認応答されなかったため、位置をリセットしていません: 動作中のモーターでは位置が飛ぶためです</translation>
    </message>
    <message>
        <source>the stream settings have an unexpected length</source>
        <translation>ストリーム設定の長さが想定と異なります</translation>
    </message>
    <message>
        <source>the substitute remote bit</source>
        <translation>代替リモートビット (SRR)</translation>
    </message>
    <message>
        <source>the target</source>
        <translation>ターゲット</translation>
    </message>
    <message>
        <source>the text is longer than %1 MiB</source>
        <translation>テキストが %1 MiB を超えています</translation>
    </message>
    <message>
        <source>the time stamp %1 is out of range</source>
        <translation>タイムスタンプ %1 は範囲外です</translation>
    </message>
    <message>
        <source>the time stamps are %1, not absolute or relative</source>
        <translation>タイムスタンプが absolute または relative ではなく %1 です</translation>
    </message>
    <message>
        <source>the transceiver reports an error</source>
        <translation>トランシーバがエラーを通知しました</translation>
    </message>
    <message>
        <source>the transcript of the update is in %1</source>
        <translation>更新の記録は %1 にあります</translation>
    </message>
    <message>
        <source>the transcript of the update is not kept: %1</source>
        <translation>更新の記録は保存されていません: %1</translation>
    </message>
    <message>
        <source>the tuning is not in the notebook: %1</source>
        <translation>調整がノートにありません: %1</translation>
    </message>
    <message>
        <source>the two directions differ by %1, at most 10 %</source>
        <translation>両方向の差が %1 です (最大 10 %)</translation>
    </message>
    <message>
        <source>the unit answers with firmware %1, the image is %2</source>
        <translation>機器はファームウェア %1 で応答しましたが、イメージは %2 です</translation>
    </message>
    <message>
        <source>the unit does not answer an enumeration</source>
        <translation>機器が列挙に応答しません</translation>
    </message>
    <message>
        <source>the unit may have restarted meanwhile: once more from page %1</source>
        <translation>機器がその間に再起動した可能性があります: ページ %1 からやり直します</translation>
    </message>
    <message>
        <source>the unit restarted: what is volatile was lost, its parameters are read again</source>
        <translation>機器が再起動しました: 揮発性の値は失われ、パラメータを読み直しています</translation>
    </message>
    <message>
        <source>the unit said it is in its bootloader, but its application answers</source>
        <translation>機器はブートローダ中と通知しましたが、アプリケーションが応答しています</translation>
    </message>
    <message>
        <source>the unit stays %1 away from where the experiment begins, more than 2 % of its step</source>
        <translation>機器が実験の開始点から %1 離れたままです。ステップの 2 % を超えています</translation>
    </message>
    <message>
        <source>the unit stores no P, so nothing moves it</source>
        <translation>機器に P が保存されていないため、動きません</translation>
    </message>
    <message>
        <source>the unit stores them by itself within %1 s</source>
        <translation>機器は %1 s 以内に自動保存します</translation>
    </message>
    <message>
        <source>the unit tells no duty, no current or no position, so its resistance is not known</source>
        <translation>機器がデューティ、電流、位置のいずれかを通知しないため、抵抗が不明です</translation>
    </message>
    <message>
        <source>the unit waits in its bootloader, run the update again</source>
        <translation>機器はブートローダで待機しています。更新を再実行してください</translation>
    </message>
    <message>
        <source>the unit was not heard during the self-test: %1</source>
        <translation>セルフテスト中に機器から受信できませんでした: %1</translation>
    </message>
    <message>
        <source>the user stopped it</source>
        <translation>ユーザが停止しました</translation>
    </message>
    <message>
        <source>the user-ID words</source>
        <translation>ユーザ ID ワード</translation>
    </message>
    <message>
        <source>the values are not put back: %1</source>
        <translation>値を元に戻していません: %1</translation>
    </message>
    <message>
        <source>the values are put back</source>
        <translation>値を元に戻しました</translation>
    </message>
    <message>
        <source>the values stay with this program and are written again after a reset</source>
        <translation>値はこのプログラムに残り、リセット後に再書込みします</translation>
    </message>
    <message>
        <source>the version at 0x1EFFC is 0x0000</source>
        <translation>0x1EFFC のバージョンが 0x0000 です</translation>
    </message>
    <message>
        <source>the version at 0x1EFFC is 0xFFFF, which means no application</source>
        <translation>0x1EFFC のバージョンが 0xFFFF で、アプリケーションがないことを示します</translation>
    </message>
    <message>
        <source>the version has an unexpected length</source>
        <translation>バージョンの長さが想定と異なります</translation>
    </message>
    <message>
        <source>the window of the layout is out of range</source>
        <translation>レイアウトの時間幅が範囲外です</translation>
    </message>
    <message>
        <source>the wire lost too many frames; the same again</source>
        <translation>回線で失われたフレームが多すぎるため、やり直します</translation>
    </message>
    <message>
        <source>there is no %1</source>
        <translation>%1 はありません</translation>
    </message>
    <message>
        <source>there is no CAN interface</source>
        <translation>CAN インターフェースがありません</translation>
    </message>
    <message>
        <source>there is no CAN interface %1</source>
        <translation>CAN インターフェース %1 がありません</translation>
    </message>
    <message>
        <source>there is no CAN plugin %1</source>
        <translation>CAN プラグイン %1 はありません</translation>
    </message>
    <message>
        <source>there is no GPIO chip for %1</source>
        <translation>%1 の GPIO チップがありません</translation>
    </message>
    <message>
        <source>there is no entry %1 in the journal</source>
        <translation>ジャーナルに項目 %1 はありません</translation>
    </message>
    <message>
        <source>there is no file &apos;%1&apos;</source>
        <translation>ファイル「%1」はありません</translation>
    </message>
    <message>
        <source>there is no layout of this name</source>
        <translation>この名前のレイアウトはありません</translation>
    </message>
    <message>
        <source>there is no simulated link &apos;sim:%1&apos;: can, serial and spi are known</source>
        <translation>シミュレーションリンク「sim:%1」はありません: 使えるのは can、serial、spi です</translation>
    </message>
    <message>
        <source>there is no snapshot &apos;%1&apos;</source>
        <translation>スナップショット「%1」はありません</translation>
    </message>
    <message>
        <source>there is no snapshot &apos;%1&apos; of this unit</source>
        <translation>この機器のスナップショット「%1」はありません</translation>
    </message>
    <message>
        <source>there is no socket %1</source>
        <translation>ソケット %1 はありません</translation>
    </message>
    <message>
        <source>there is no such folder</source>
        <translation>そのフォルダはありません</translation>
    </message>
    <message>
        <source>there is no table here: expected time_s,name (unit),… or t,channel,value,unit</source>
        <translation>表がありません: time_s,name (unit),… または t,channel,value,unit が必要です</translation>
    </message>
    <message>
        <source>there is no trial %1</source>
        <translation>試行 %1 はありません</translation>
    </message>
    <message>
        <source>there is no way from %1 to itself</source>
        <translation>%1 からそれ自身への移動はできません</translation>
    </message>
    <message>
        <source>there is not enough room for a frequency response: its limits leave a speed of %1 counts/s for %2 s</source>
        <translation>周波数応答には余裕が足りません: 制限により %1 counts/s で %2 s しか動かせません</translation>
    </message>
    <message>
        <source>there is not enough room to identify the motor: its limits leave pushes of %1 duty only</source>
        <translation>モーターの同定には余裕が足りません: 制限によりデューティ %1 のパルスしか使えません</translation>
    </message>
    <message>
        <source>there is not enough room: its limits leave steps of %1 counts</source>
        <translation>余裕が足りません: 制限により %1 counts のステップしか使えません</translation>
    </message>
    <message>
        <source>these are the calm gains, %1</source>
        <translation>緩やかなゲインを採用しました、%1</translation>
    </message>
    <message>
        <source>they have speed and interface</source>
        <translation>使えるのは speed と interface です</translation>
    </message>
    <message>
        <source>this build knows %1</source>
        <translation>このビルドで使えるのは %1 です</translation>
    </message>
    <message>
        <source>this build simulates no devices on sim:%1</source>
        <translation>このビルドは sim:%1 の機器をシミュレートしません</translation>
    </message>
    <message>
        <source>this change waits for nobody</source>
        <translation>この変更は確認待ちではありません</translation>
    </message>
    <message>
        <source>this command is not known to firmware of dialect %1</source>
        <translation>このコマンドはダイアレクト %1 のファームウェアにありません</translation>
    </message>
    <message>
        <source>this computer has no driver for PostgreSQL</source>
        <translation>このコンピューターには PostgreSQL のドライバがありません</translation>
    </message>
    <message>
        <source>this computer is not kept awake while motors are driven or firmware is written: %1; switch its automatic suspend off meanwhile</source>
        <translation>モーターの駆動中やファームウェアの書込み中にこのコンピューターのスリープを防止できません: %1。その間は自動サスペンドをオフにしてください</translation>
    </message>
    <message>
        <source>this device has no experiment &apos;%1&apos;</source>
        <translation>この機器に実験「%1」はありません</translation>
    </message>
    <message>
        <source>this device has no watchdog, and nothing here would stop it if the program died</source>
        <translation>この機器にはウォッチドッグがなく、プログラムが異常終了した場合に停止させる手段がここにはありません</translation>
    </message>
    <message>
        <source>this device has no watchdog, and on %1 nothing could stop it if the program died</source>
        <translation>この機器にはウォッチドッグがなく、プログラムが異常終了した場合に %1 では停止させる手段がありません</translation>
    </message>
    <message>
        <source>this firmware may pass the target of a profiled move above 2500 counts/s; it is stopped then</source>
        <translation>このファームウェアは 2500 counts/s を超えるとプロファイル動作の目標を行き過ぎることがあります。その場合は停止します</translation>
    </message>
    <message>
        <source>this image holds a bootloader too, which cannot write itself</source>
        <translation>このイメージにはブートローダも含まれ、ブートローダは自身を書き込めません</translation>
    </message>
    <message>
        <source>this interface cannot listen without disturbing the bus, so ask who set it up; usual are 1 Mbit/s, 500, 250 and 125 kbit/s</source>
        <translation>このインターフェースはバスを乱さずに受信できないため、設定した人に確認してください。一般的な値は 1 Mbit/s、500、250、125 kbit/s です</translation>
    </message>
    <message>
        <source>this is another unit by now, number %1</source>
        <translation>現在は別の機器、番号 %1 になっています</translation>
    </message>
    <message>
        <source>this is no layout of plots</source>
        <translation>プロットのレイアウトではありません</translation>
    </message>
    <message>
        <source>this is no program for the controller: it does not begin with a jump of an AVR at address 0</source>
        <translation>コントローラ用のプログラムではありません: アドレス 0 が AVR のジャンプ命令で始まっていません</translation>
    </message>
    <message>
        <source>this is no program for the controller: it has bytes outside the 32 KiB of an ATmega328P</source>
        <translation>コントローラ用のプログラムではありません: ATmega328P の 32 KiB の外にバイトがあります</translation>
    </message>
    <message>
        <source>this is no program for the drive: it has bytes outside the flash of an STM32, 0x08000000 … 0x081FFFFF</source>
        <translation>ドライブ用のプログラムではありません: STM32 のフラッシュ 0x08000000 … 0x081FFFFF の外にバイトがあります</translation>
    </message>
    <message>
        <source>this is no program for the drive: there are no vectors of an STM32 at 0x08000000. Make the Intel HEX file with: arm-none-eabi-objcopy -O ihex abstract_DC_drive.elf</source>
        <translation>ドライブ用のプログラムではありません: 0x08000000 に STM32 のベクタがありません。Intel HEX ファイルは次のコマンドで作成してください: arm-none-eabi-objcopy -O ihex abstract_DC_drive.elf</translation>
    </message>
    <message>
        <source>this is no recipe of version 1</source>
        <translation>バージョン 1 のレシピではありません</translation>
    </message>
    <message>
        <source>this is no session of MotorBench</source>
        <translation>MotorBench のセッションではありません</translation>
    </message>
    <message>
        <source>this kernel has no CAN support</source>
        <translation>このカーネルは CAN に対応していません</translation>
    </message>
    <message>
        <source>this program was held up for %1 ms, longer than the motor goes without a set-point</source>
        <translation>このプログラムが %1 ms 停滞しました。モーターが目標値なしで動作を続ける時間を超えています</translation>
    </message>
    <message>
        <source>this program was held up for so long that the guardian may have stopped the motor</source>
        <translation>このプログラムが長く停滞したため、監視プロセスがモーターを停止した可能性があります</translation>
    </message>
    <message>
        <source>this takes too long</source>
        <translation>時間がかかりすぎています</translation>
    </message>
    <message>
        <source>this trial has no sine and no positions</source>
        <translation>この試行には正弦波も位置もありません</translation>
    </message>
    <message>
        <source>this trial is kept without its result: %1</source>
        <translation>この試行は結果なしで保存されました: %1</translation>
    </message>
    <message>
        <source>this trial is not kept: %1</source>
        <translation>この試行は保存されていません: %1</translation>
    </message>
    <message>
        <source>this trial owes nothing to the unit</source>
        <translation>この試行に未復元のゲインはありません</translation>
    </message>
    <message>
        <source>this unit has no number yet</source>
        <translation>この機器にはまだ番号がありません</translation>
    </message>
    <message>
        <source>this unit has no number yet, and without one its motor may not be driven</source>
        <translation>この機器にはまだ番号がなく、番号がないモーターは駆動できません</translation>
    </message>
    <message>
        <source>this unit waits in its bootloader, and the recipe has no firmware for it</source>
        <translation>この機器はブートローダで待機中で、レシピに対応するファームウェアがありません</translation>
    </message>
    <message>
        <source>to be trusted up to %1 Hz, as far as ten samples a swing and a coherence of 0.9</source>
        <translation>%1 Hz まで信頼できます。1 周期 10 サンプル、コヒーレンス 0.9 が基準です</translation>
    </message>
    <message>
        <source>too few samples for a sine of %1 Hz</source>
        <translation>%1 Hz の正弦波にはサンプルが足りません</translation>
    </message>
    <message>
        <source>too few steps to tell what the gains of this loop do</source>
        <translation>この制御ループのゲインの働きを知るにはステップが足りません</translation>
    </message>
    <message>
        <source>transmission timed out</source>
        <translation>送信タイムアウト</translation>
    </message>
    <message>
        <source>trial #%1</source>
        <translation>試行 #%1</translation>
    </message>
    <message>
        <source>try a lower speed=</source>
        <translation>speed= を小さくしてください</translation>
    </message>
    <message>
        <source>try again</source>
        <translation>再試行してください</translation>
    </message>
    <message>
        <source>try its position loop</source>
        <translation>位置ループを試してください</translation>
    </message>
    <message>
        <source>tune it by hand with &apos;motorbenchctl step&apos;</source>
        <translation>&apos;motorbenchctl step&apos; で手動調整してください</translation>
    </message>
    <message>
        <source>tuning %1: %2</source>
        <translation>調整 %1: %2</translation>
    </message>
    <message>
        <source>turning the motor with several powers</source>
        <translation>各種の出力でモーターを回転中</translation>
    </message>
    <message>
        <source>undone: %1</source>
        <translation>元に戻し: %1</translation>
    </message>
    <message>
        <source>units are served already</source>
        <translation>すでに機器を処理中です</translation>
    </message>
    <message>
        <source>units are served on this link</source>
        <translation>このリンクでは機器を処理中です</translation>
    </message>
    <message>
        <source>unix links have no option &apos;%1&apos;</source>
        <translation>unix リンクにオプション「%1」はありません</translation>
    </message>
    <message>
        <source>unknown error</source>
        <translation>不明なエラー</translation>
    </message>
    <message>
        <source>unknown family &apos;%1&apos;</source>
        <translation>不明なファミリ「%1」</translation>
    </message>
    <message>
        <source>unknown fault &apos;%1&apos;</source>
        <translation>不明な fault「%1」</translation>
    </message>
    <message>
        <source>unknown key %1</source>
        <translation>不明なキー %1</translation>
    </message>
    <message>
        <source>unknown key &apos;%1&apos;</source>
        <translation>不明なキー「%1」</translation>
    </message>
    <message>
        <source>unknown link kind &apos;%1&apos;: sim, socketcan, qtcan, serial, spidev, unix and replay are known</source>
        <translation>リンクの種類「%1」は不明です: 使えるのは sim、socketcan、qtcan、serial、spidev、unix、replay です</translation>
    </message>
    <message>
        <source>unknown loop &apos;%1&apos;</source>
        <translation>不明な制御ループ「%1」</translation>
    </message>
    <message>
        <source>unknown option &apos;%1&apos; of a serial link</source>
        <translation>シリアルリンクのオプション「%1」は不明です</translation>
    </message>
    <message>
        <source>unknown option &apos;%1&apos; of a simulated link</source>
        <translation>シミュレーションリンクのオプション「%1」は不明です</translation>
    </message>
    <message>
        <source>unplug it and plug it in again</source>
        <translation>取り外して接続し直してください</translation>
    </message>
    <message>
        <source>unreadable</source>
        <translation>読込み不可</translation>
    </message>
    <message>
        <source>update its firmware first</source>
        <translation>先にファームウェアを更新してください</translation>
    </message>
    <message>
        <source>use a programmer on the pins</source>
        <translation>ピンに接続する書込み器を使用してください</translation>
    </message>
    <message>
        <source>use an interface of the kernel</source>
        <translation>カーネルのインターフェースを使用してください</translation>
    </message>
    <message>
        <source>use that one</source>
        <translation>そちらを使用してください</translation>
    </message>
    <message>
        <source>velocity is −100000 to 100000 counts/s</source>
        <translation>速度は −100000 ～ 100000 counts/s です</translation>
    </message>
    <message>
        <source>virtual</source>
        <translation>仮想</translation>
    </message>
    <message>
        <source>wait until it is heard</source>
        <translation>受信できるまで待ってください</translation>
    </message>
    <message>
        <source>was not seen to stop: the motor may still turn, cut its power</source>
        <translation>停止を確認できません: モーターがまだ回転している可能性があります。電源を切ってください</translation>
    </message>
    <message>
        <source>was seen to stand</source>
        <translation>停止を確認しました</translation>
    </message>
    <message>
        <source>what D does is known within %1, at most 30 %</source>
        <translation>D の働きの不確かさが %1 です (最大 30 %)</translation>
    </message>
    <message>
        <source>what a gain of %1 means in this loop is not known</source>
        <translation>この制御ループでのゲイン %1 の意味が不明です</translation>
    </message>
    <message>
        <source>what a raw gain of this board puts out is not known (%1)</source>
        <translation>この基板のゲインの生値に対する出力が不明です (%1)</translation>
    </message>
    <message>
        <source>what another program has changed within the last 15 s is not in the flash of the unit yet, and is lost with the restart</source>
        <translation>別のプログラムが直近 15 s に変更した内容は、まだ機器のフラッシュになく、再起動で失われます</translation>
    </message>
    <message>
        <source>what is left over is %1 of the steps, at most 8 %</source>
        <translation>残差がステップの %1 です (最大 8 %)</translation>
    </message>
    <message>
        <source>what is missing is still unknown, do it again</source>
        <translation>残りはまだ不明です。やり直してください</translation>
    </message>
    <message>
        <source>what is sent to node %1 is also done by node %2, now or after a restart, because of an acceptance mask; set its node.mask to 255 and restart it</source>
        <translation>アクセプタンスマスクのため、ノード %1 への指令はノード %2 も (現在または再起動後に) 実行します。その node.mask を 255 にして再起動してください</translation>
    </message>
    <message>
        <source>what the gains of this loop make is not known any more</source>
        <translation>この制御ループのゲインの働きが不明になりました</translation>
    </message>
    <message>
        <source>where it is neither, its gain.p is too small for so short a way</source>
        <translation>いずれでもない場合は、この短い移動に対して gain.p が小さすぎます</translation>
    </message>
    <message>
        <source>without a ready line the board is asked 100 times a second, and cannot stream</source>
        <translation>レディ線がない場合、基板への問合せは毎秒 100 回となり、ストリームは使えません</translation>
    </message>
    <message>
        <source>without it nothing would stop this motor if the program died: install it there</source>
        <translation>これがないと、プログラムが異常終了した場合にこのモーターを停止させる手段がありません: そこにインストールしてください</translation>
    </message>
    <message>
        <source>write %1</source>
        <translation>%1 を書き込んでください</translation>
    </message>
    <message>
        <source>write == to compare</source>
        <translation>比較には == を使用してください</translation>
    </message>
    <message>
        <source>write a larger gain.d once, with which it still comes to rest</source>
        <translation>静止できる範囲で、より大きい gain.d を一度書き込んでください</translation>
    </message>
    <message>
        <source>write a number</source>
        <translation>数値で入力してください</translation>
    </message>
    <message>
        <source>write a small gain.p once, with which it moves</source>
        <translation>動き出す程度の小さい gain.p を一度書き込んでください</translation>
    </message>
    <message>
        <source>write a smaller gain.p once</source>
        <translation>より小さい gain.p を一度書き込んでください</translation>
    </message>
    <message>
        <source>write it like 2.5</source>
        <translation>2.5 のように入力してください</translation>
    </message>
    <message>
        <source>write it with &apos;motorbenchctl set&apos;</source>
        <translation>&apos;motorbenchctl set&apos; で書き込んでください</translation>
    </message>
    <message>
        <source>write it with a dot, like 1.5, and no comma</source>
        <translation>コンマではなくピリオドで 1.5 のように入力してください</translation>
    </message>
    <message>
        <source>write on or off</source>
        <translation>on または off と入力してください</translation>
    </message>
    <message>
        <source>write openocd:INTERFACE, such as openocd:stlink</source>
        <translation>openocd:INTERFACE の形式で入力してください (例: openocd:stlink)</translation>
    </message>
    <message>
        <source>write the gains of this loop once, or keep what is tried</source>
        <translation>この制御ループのゲインを一度書き込むか、試す値をそのまま残してください</translation>
    </message>
    <message>
        <source>write true or false</source>
        <translation>true または false と入力してください</translation>
    </message>
    <message>
        <source>written again: %1</source>
        <translation>再書込み済み: %1</translation>
    </message>
    <message>
        <source>written, but the current limit, which this firmware overwrites with it, could not be put back to %1 mA: %2</source>
        <translation>書き込みましたが、このファームウェアが同時に上書きする電流制限を %1 mA に戻せませんでした: %2</translation>
    </message>
    <message>
        <source>brisk</source>
        <translation>速応</translation>
    </message>
    <message>
        <source>calm</source>
        <translation>緩やか</translation>
    </message>
    <message>
        <source>kept</source>
        <translation>維持</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>標準</translation>
    </message>
    <message>
        <source>proposed</source>
        <translation>候補</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>拒否</translation>
    </message>
    <message>
        <source>rolled-back</source>
        <translation>元に戻しました</translation>
    </message>
    <message>
        <source>P alone, in a loop that looks at the current every %1, holds %2 of what is asked for when it overshoots by %3</source>
        <translation>%1 ごとに電流を見るループでは、P だけでは %3 のオーバーシュートで指令の %2 しか保てません</translation>
    </message>
    <message>
        <source>allow more travel, so that pushes may last</source>
        <translation>パルスを長く印加できるよう、移動量の許容値を上げてください</translation>
    </message>
    <message>
        <source>drive it by duty, or try its I with &apos;motorbenchctl step&apos;: not every build of the firmware runs it</source>
        <translation>デューティで駆動するか、&apos;motorbenchctl step&apos; で I を試してください。すべてのファームウェアが I を計算するわけではありません</translation>
    </message>
    <message>
        <source>friction takes %1 duty, and %2 may push: too little for a motor to swing</source>
        <translation>摩擦がデューティ %1 を占め、許されるのは %2 です。モーターを振動させるには足りません</translation>
    </message>
    <message>
        <source>its current stays %1 A behind while the motor speeds up</source>
        <translation>モーターが加速している間、電流は %1 A 遅れます</translation>
    </message>
    <message>
        <source>no motor of this gain swings by %1 counts every %2</source>
        <translation>このゲインで %2 ごとに %1 counts 振動するモーターはありません</translation>
    </message>
    <message>
        <source>now those of the model as that step has corrected it</source>
        <translation>次に、そのステップで補正したモデルのゲインを試します</translation>
    </message>
    <message>
        <source>off</source>
        <translation>オフ</translation>
    </message>
    <message>
        <source>on</source>
        <translation>オン</translation>
    </message>
    <message>
        <source>swinging with %1 duty to and fro</source>
        <translation>デューティ %1 で往復振動中</translation>
    </message>
    <message>
        <source>the %1 gains of the first model did not: %2</source>
        <translation>最初のモデルのゲイン「%1」では達成できませんでした: %2</translation>
    </message>
    <message>
        <source>the gain is known within %1, at most 15 %</source>
        <translation>ゲインの不確かさが %1 です (最大 15 %)</translation>
    </message>
    <message>
        <source>the motor did not swing evenly under a duty that changes its sign</source>
        <translation>符号が切り替わるデューティの下で、モーターは一様に振動しませんでした</translation>
    </message>
    <message>
        <source>their model was corrected by a step, %1</source>
        <translation>モデルはステップで補正されました、%1</translation>
    </message>
    <message>
        <source>there is no room for pushes that last</source>
        <translation>長いパルスを印加する余地がありません</translation>
    </message>
    <message>
        <source>there was no room for long pushes; under %1 duty to and fro it swings by %2 counts every %3, the periods differ by %4, at most 10 %</source>
        <translation>長いパルスを印加する余地がありませんでした。デューティ %1 の往復で %3 ごとに %2 counts 振動し、周期のばらつきは %4 です (最大 10 %)</translation>
    </message>
    <message>
        <source>this unit is for motors of more current</source>
        <translation>この機器はより大きな電流のモーター用です</translation>
    </message>
    <message>
        <source>%1 %2 is unusual: %3 units have %4 to %5</source>
        <translation>%1 %2 は異例です: %3 台は %4 から %5 です</translation>
    </message>
    <message>
        <source>%1 besides those of the recipe differ from the backup</source>
        <translation>レシピ以外の%1がバックアップと異なります</translation>
    </message>
    <message>
        <source>%1 of %2 written</source>
        <translation>%2のうち %1 個を書き込みました</translation>
    </message>
    <message>
        <source>%1 pages, %2 sent again</source>
        <translation>%1 ページ、再送 %2</translation>
    </message>
    <message>
        <source>%1 settings</source>
        <translation>設定 %1 個</translation>
    </message>
    <message>
        <source>1 setting</source>
        <translation>設定 1 個</translation>
    </message>
    <message>
        <source>all numbers are used up, the highest is %1</source>
        <translation>番号はすべて使い切られました。最大は %1 です</translation>
    </message>
    <message>
        <source>already %1</source>
        <translation>すでに %1</translation>
    </message>
    <message>
        <source>backup</source>
        <translation>バックアップ</translation>
    </message>
    <message>
        <source>done</source>
        <translation>完了</translation>
    </message>
    <message>
        <source>firmware</source>
        <translation>ファームウェア</translation>
    </message>
    <message>
        <source>firmware %1</source>
        <translation>ファームウェア %1</translation>
    </message>
    <message>
        <source>its flash has it</source>
        <translation>フラッシュに入っています</translation>
    </message>
    <message>
        <source>no version is told</source>
        <translation>バージョンは示されません</translation>
    </message>
    <message>
        <source>not kept: there is no notebook</source>
        <translation>保存されていません: ノートブックがありません</translation>
    </message>
    <message>
        <source>nothing can be read in the bootloader</source>
        <translation>ブートローダでは何も読み取れません</translation>
    </message>
    <message>
        <source>nothing had to be stored</source>
        <translation>保存するものはありませんでした</translation>
    </message>
    <message>
        <source>number</source>
        <translation>番号</translation>
    </message>
    <message>
        <source>number %1</source>
        <translation>番号 %1</translation>
    </message>
    <message>
        <source>number %1, as before</source>
        <translation>番号 %1、以前と同じ</translation>
    </message>
    <message>
        <source>parameters</source>
        <translation>パラメータ</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>合格</translation>
    </message>
    <message>
        <source>preflight</source>
        <translation>事前確認</translation>
    </message>
    <message>
        <source>proof</source>
        <translation>証明</translation>
    </message>
    <message>
        <source>read back</source>
        <translation>読み戻し済み</translation>
    </message>
    <message>
        <source>self-test</source>
        <translation>セルフテスト</translation>
    </message>
    <message>
        <source>snapshot %1 has %2 values</source>
        <translation>スナップショット %1 には %2 個の値があります</translation>
    </message>
    <message>
        <source>within its limits</source>
        <translation>限度内</translation>
    </message>
    <message>
        <source>%1 is for no unit that is here and takes firmware over its own link</source>
        <translation>%1 は、ここにあって自身のリンクで更新できる機器のものではありません</translation>
    </message>
    <message>
        <source>%1 is not open, or something runs there</source>
        <translation>%1 が開いていないか、そこで何かが動いています</translation>
    </message>
    <message>
        <source>for the others write a recipe that names the way in</source>
        <translation>ほかの機器には、経路を指定したレシピを書いてください</translation>
    </message>
    <message>
        <source>open it, or end what runs there first</source>
        <translation>開くか、先にそこで動いているものを終えてください</translation>
    </message>
    <message>
        <source>this unit was never served, so there is nothing for a label</source>
        <translation>この機器は処理されたことがないので、ラベルの内容がありません</translation>
    </message>
    <message>
        <source>units are served here; the link stays open</source>
        <translation>ここで機器を処理中のため、リンクは開いたままです</translation>
    </message>
    <message>
        <source>write a page</source>
        <translation>ページとして書き出してください</translation>
    </message>
    <message>
        <source>does not answer</source>
        <translation>応答しません</translation>
    </message>
    <message>
        <source>hold Arm, then put it on again</source>
        <translation>駆動許可ボタンを長押ししてから、もう一度接続してください</translation>
    </message>
    <message>
        <source>it was cut off at &apos;%1&apos; and does not answer any more</source>
        <translation>「%1」で中断され、もう応答しません</translation>
    </message>
    <message>
        <source>left before the station was armed</source>
        <translation>ステーションが駆動許可される前に離れました</translation>
    </message>
    <message>
        <source>look at cable and supply; when it answers again it is served from the beginning</source>
        <translation>ケーブルと電源を確認してください。再び応答すれば最初から処理されます</translation>
    </message>
    <message>
        <source>the unit was taken off while it waited for the station to be armed</source>
        <translation>ステーションの駆動許可を待っている間に機器が外されました</translation>
    </message>
    <message>
        <source>waits until the station is armed</source>
        <translation>ステーションの駆動許可を待っています</translation>
    </message>
    <message>
        <source>a step of %1 stands in noise of %2, at most %3; the mean of %4 tells it</source>
        <translation>%1 のステップは %2 の雑音の中にあります（上限 %3）。%4 回の平均で読み取ります</translation>
    </message>
    <message>
        <source>on the model as these steps have corrected it, other gains leave less error; now those</source>
        <translation>これらのステップで補正したモデルでは、別のゲインの方が誤差が小さくなります。次はそれを試します</translation>
    </message>
    <message>
        <source>those that were proven first left more error, these leave %1 of it</source>
        <translation>最初に検証したゲインは誤差がより大きく、このゲインではその %1 です</translation>
    </message>
    <message>
        <source>their model was corrected by those that were proven first, which left no clearly more error</source>
        <translation>モデルは最初に検証したゲインで補正されました。その誤差は明らかに大きいわけではありません</translation>
    </message>
    <message>
        <source>a chunk of it is damaged</source>
        <translation>ブロックが壊れています</translation>
    </message>
    <message>
        <source>a chunk of it is larger than %1 MB</source>
        <translation>%1 MB を超えるブロックがあります</translation>
    </message>
    <message>
        <source>its chunks are packed by &apos;%1&apos;; zstd and lz4 are known</source>
        <translation>ブロックは &apos;%1&apos; で圧縮されています。使えるのは zstd と lz4 です</translation>
    </message>
    <message>
        <source>messages in JSON can be read, and what this program wrote</source>
        <translation>読めるのは JSON のメッセージと、このプログラムが書いたものです</translation>
    </message>
    <message>
        <source>--theme takes dark, light, contrast or system</source>
        <translation>--theme は dark、light、contrast、system のいずれかです</translation>
    </message>
    <message>
        <source>give an .mcap with messages in JSON or of this program, a .csv, or the output of watch</source>
        <translation>JSON メッセージまたはこのプログラムの .mcap、.csv、または watch の出力を指定します</translation>
    </message>
    <message>
        <source>overshoot %1, not settled</source>
        <translation>オーバーシュート %1、整定せず</translation>
    </message>
    <message>
        <source>overshoot %1, settled in %2</source>
        <translation>オーバーシュート %1、整定 %2</translation>
    </message>
    <message>
        <source>seed, loss, bitrate and fault are known</source>
        <translation>使えるのは seed、loss、bitrate、fault です</translation>
    </message>
    <message>
        <source>within its limits, at attempt %1: samples were lost before</source>
        <translation>%1 回目の試行で限度内: それまでの試行ではサンプルが欠落しました</translation>
    </message>
    <message>
        <source>its speed goes on swinging by %1 where it should rest, whole counts alone would make %2</source>
        <translation>静定すべきところで速度が %1 振れ続けています。整数カウントだけなら %2 です</translation>
    </message>
    <message>
        <source>a count or their largest error makes more output than it may</source>
        <translation>1 カウントまたは最大誤差による出力が許容値を超えます</translation>
    </message>
    <message>
        <source>the gains that were there may leave as little error; now those</source>
        <translation>元のゲインでも誤差は同じくらい小さいかもしれません。次はそれを試します</translation>
    </message>
    <message>
        <source>their largest sensitivity is %1, at most %2 are allowed, and %3 with more gain and delay</source>
        <translation>最大感度は %1 です。許容は最大 %2、ゲインとむだ時間が増えた場合は %3 です</translation>
    </message>
    <message>
        <source>there was no time to compare them with those that were there</source>
        <translation>元のゲインと比較する時間がありませんでした</translation>
    </message>
    <message>
        <source>they would draw more current than is allowed</source>
        <translation>許容より大きな電流が流れます</translation>
    </message>
    <message>
        <source>they would overshoot by %1</source>
        <translation>オーバーシュートが %1 になります</translation>
    </message>
    <message>
        <source>those that were found left more error: these, which were there, leave %1 of it</source>
        <translation>見つかったゲインの方が誤差が大きく、元からあるこのゲインではその %1 です</translation>
    </message>
    <message>
        <source>those that were there leave more error</source>
        <translation>元のゲインの方が誤差が大きくなります</translation>
    </message>
    <message>
        <source>those that were there would leave less error, but are not for keeping: %1</source>
        <translation>元のゲインの方が誤差は小さくなりますが、残すべきものではありません: %1</translation>
    </message>
    <message>
        <source>what is left over is much of so small steps; the same with larger ones</source>
        <translation>この小さなステップでは残差の割合が大きすぎます。同じことをより大きなステップで行います</translation>
    </message>
    <message>
        <source>what was there is not known, and these were not compared with it</source>
        <translation>元の値は不明なため、比較していません</translation>
    </message>
    <message>
        <source>bus voltage</source>
        <translation>バス電圧</translation>
    </message>
    <message>
        <source>direction</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>energy</source>
        <translation>エネルギー</translation>
    </message>
    <message>
        <source>foreign master</source>
        <translation>別のマスタ</translation>
    </message>
    <message>
        <source>interrupted</source>
        <translation>中断</translation>
    </message>
    <message>
        <source>lateness</source>
        <translation>遅延</translation>
    </message>
    <message>
        <source>link</source>
        <translation>リンク</translation>
    </message>
    <message>
        <source>missing guardian</source>
        <translation>監視プロセスなし</translation>
    </message>
    <message>
        <source>no motion</source>
        <translation>動作なし</translation>
    </message>
    <message>
        <source>oscillation</source>
        <translation>振動</translation>
    </message>
    <message>
        <source>refusal</source>
        <translation>拒否</translation>
    </message>
    <message>
        <source>restart</source>
        <translation>再起動</translation>
    </message>
    <message>
        <source>sleep</source>
        <translation>スリープ</translation>
    </message>
    <message>
        <source>temperature</source>
        <translation>温度</translation>
    </message>
    <message>
        <source>time</source>
        <translation>時間</translation>
    </message>
    <message>
        <source>user</source>
        <translation>ユーザ</translation>
    </message>
    <message>
        <source>a step would draw too much current: the unit&apos;s own profile leads, at %1 counts/s at most</source>
        <translation>ステップでは電流が大きくなりすぎるため、機器自身のプロファイルが最大 %1 counts/s で導きます</translation>
    </message>
    <message>
        <source>allow more travel, duty or current</source>
        <translation>移動量、デューティまたは電流の許容値を上げてください</translation>
    </message>
    <message>
        <source>an answer was lost; the same again</source>
        <translation>応答が一つ失われたため、やり直します</translation>
    </message>
    <message>
        <source>friction takes %1 of what its current limit and its room allow, at most 60 %</source>
        <translation>摩擦が、電流制限と移動量の許す出力の %1 を占めています (最大 60 %)</translation>
    </message>
    <message>
        <source>friction takes more than half of what P makes of a step</source>
        <translation>摩擦がステップに対する P の出力の半分以上を占めています</translation>
    </message>
    <message>
        <source>its own profile leads there at %1 counts/s</source>
        <translation>機器自身のプロファイルが %1 counts/s で目標へ導きます</translation>
    </message>
    <message>
        <source>see whether the motor is too strong for this unit</source>
        <translation>モーターがこの機器には強すぎないか確認してください</translation>
    </message>
    <message>
        <source>the unit&apos;s own profile led at %1 counts/s, for a step would draw too much current</source>
        <translation>ステップでは電流が大きくなりすぎるため、機器自身のプロファイルが %1 counts/s で導きました</translation>
    </message>
    <message>
        <source>at most %1 duty, %2 counts/s and %3 counts from where it stands</source>
        <translation>最大でデューティ %1、%2 counts/s、現在位置から %3 counts</translation>
    </message>
    <message>
        <source>first its direction is checked: %1 counts up</source>
        <translation>まず方向を確認: 正方向へ %1 counts</translation>
    </message>
    <message>
        <source>its loop takes its velocity every %1 ms, every %2 ms was expected</source>
        <translation>ループは速度を %1 ms ごとに取得、想定は %2 ms ごと</translation>
    </message>
    <message>
        <source>perhaps its D acts the other way round than in the firmware that is known</source>
        <translation>既知のファームウェアとは D が逆に働くのかもしれません</translation>
    </message>
    <message>
        <source>see which firmware it runs</source>
        <translation>動作しているファームウェアを確認してください</translation>
    </message>
    <message>
        <source>a regression of mean speeds makes the lag %1, %2 beside what was fitted</source>
        <translation>平均速度の回帰による時定数は %1、フィッティングとの差は %2</translation>
    </message>
    <message>
        <source>F is 0: in a position loop it would push by where the target lies, not by how far it is</source>
        <translation>F は 0 です: 位置ループでは、目標までの距離ではなく目標の位置に応じて押してしまいます</translation>
    </message>
    <message>
        <source>F is 0: with an integral both would give what friction and speed take, and it would overshoot</source>
        <translation>F は 0 です: 積分があると、摩擦と速度に必要な分を両方が出し、オーバーシュートします</translation>
    </message>
    <message>
        <source>it is %1</source>
        <translation>%1 です</translation>
    </message>
    <message>
        <source>number %1 has another session</source>
        <translation>番号 %1 のセッションは異なります</translation>
    </message>
    <message>
        <source>chatter of the duty</source>
        <translation>デューティの変動</translation>
    </message>
    <message>
        <source>encoder</source>
        <translation>エンコーダ</translation>
    </message>
    <message>
        <source>error at rest</source>
        <translation>定常偏差</translation>
    </message>
    <message>
        <source>friction</source>
        <translation>摩擦</translation>
    </message>
    <message>
        <source>gain</source>
        <translation>ゲイン</translation>
    </message>
    <message>
        <source>noise</source>
        <translation>ノイズ</translation>
    </message>
    <message>
        <source>overshoot</source>
        <translation>オーバーシュート</translation>
    </message>
    <message>
        <source>peak current</source>
        <translation>ピーク電流</translation>
    </message>
    <message>
        <source>resistance</source>
        <translation>抵抗</translation>
    </message>
    <message>
        <source>rise</source>
        <translation>立上り</translation>
    </message>
    <message>
        <source>settle</source>
        <translation>整定</translation>
    </message>
    <message>
        <source>time at the duty limit</source>
        <translation>デューティ上限の時間</translation>
    </message>
    <message>
        <source>undershoot</source>
        <translation>アンダーシュート</translation>
    </message>
    <message>
        <source>%1 was cleared but reads %2</source>
        <translation>%1 をクリアしましたが、読出し値は %2 です</translation>
    </message>
    <message>
        <source>%1: unknown key %2</source>
        <translation>%1: 不明なキー %2</translation>
    </message>
    <message>
        <source>%1; the gains of the axis were not known, and are now those that the board starts with</source>
        <translation>%1。軸のゲインは不明だったため、現在はボードの起動時の値になっています</translation>
    </message>
    <message>
        <source>correct it, or delete its row</source>
        <translation>修正するか、その行を削除してください</translation>
    </message>
    <message>
        <source>its cause is there again, or still</source>
        <translation>原因が再び生じたか、まだ残っています</translation>
    </message>
    <message>
        <source>the gains of axis %1 are not known here: it will be left with those that the board starts with</source>
        <translation>軸 %1 のゲインが不明です: 終了後はボードの起動時の値のままになります</translation>
    </message>
    <message>
        <source>the gains of this loop are not known here, so its target begins within %1 of where it is, and goes further as its output is seen to allow it; write its p, d and divisor once</source>
        <translation>この制御ループのゲインが不明なため、目標は現在位置から %1 以内で始め、出力に余裕があることを確認しながら広げます。p、d と divisor を一度書き込んでください</translation>
    </message>
    <message>
        <source>write &quot;value&quot; or &quot;raw&quot;</source>
        <translation>&quot;value&quot; または &quot;raw&quot; と書いてください</translation>
    </message>
    <message>
        <source>%1 duty makes the motor quicker than %2 counts/s, which are allowed</source>
        <translation>デューティ %1 でモーターは許可された %2 counts/s より速くなります</translation>
    </message>
    <message>
        <source>&apos;sqlite3 %1 .recover&apos; tells what it still holds; where it is moved away, a new one is begun</source>
        <translation>&apos;sqlite3 %1 .recover&apos; で残っている内容が分かります。別の場所へ移せば新しいものが作られます</translation>
    </message>
    <message>
        <source>another program holds it: try again when that has ended</source>
        <translation>別のプログラムが使用中です。終了してからもう一度試してください</translation>
    </message>
    <message>
        <source>look whether its disk is there, has room and is in order</source>
        <translation>ディスクが接続されているか、空きがあるか、正常かを確認してください</translation>
    </message>
    <message>
        <source>make room on its disk</source>
        <translation>ディスクの空きを増やしてください</translation>
    </message>
    <message>
        <source>%1: its value is in &apos;%2&apos;, its unit is &apos;%3&apos;</source>
        <translation>%1: 値は「%2」で書かれていますが、単位は「%3」です</translation>
    </message>
    <message>
        <source>write it in that unit</source>
        <translation>その単位で書いてください</translation>
    </message>
    <message>
        <source>a line has more than %1 bytes</source>
        <translation>%1 バイトを超える行があります</translation>
    </message>
    <message>
        <source>allow more duty, speed or travel</source>
        <translation>デューティ、速度または移動量の許容値を上げてください</translation>
    </message>
    <message>
        <source>it came to %1 of its step while that was held</source>
        <translation>ステップを保持している間に、その %1 までしか達しませんでした</translation>
    </message>
    <message>
        <source>the pushes that its limits leave hardly moved the motor</source>
        <translation>制限内のパルスではモーターがほとんど動きませんでした</translation>
    </message>
    <message>
        <source>it may rest %1 short of its target until its integral has overcome friction</source>
        <translation>積分が摩擦に打ち勝つまで、目標の %1 手前で静止することがあります</translation>
    </message>
    <message>
        <source>%1 has restarted and did not say yet whether it is the same unit</source>
        <translation>%1 は再起動し、同じユニットかどうかをまだ通知していません</translation>
    </message>
    <message>
        <source>another unit stands in its place by now</source>
        <translation>その場所には現在、別のユニットがあります</translation>
    </message>
    <message>
        <source>look at what it says, then order it again</source>
        <translation>通知された内容を確認してから、もう一度実行してください</translation>
    </message>
    <message>
        <source>compile an offset of its own, 1 … 99, into its firmware, or leave it alone on the bus</source>
        <translation>ファームウェアに固有のオフセット (1 … 99) をコンパイルするか、バスにこのドライブだけを残してください</translation>
    </message>
    <message>
        <source>what is sent to offset 0 is done by every drive of the bus, and others answer on this one</source>
        <translation>オフセット 0 に送ったものはバス上のすべてのドライブが実行し、このバスではほかのドライブも応答しています</translation>
    </message>
    <message>
        <source>the board is told to tell its whole counters; look at the position, and run it again</source>
        <translation>基板にカウンタ全体を知らせるよう指示しました。位置を確かめてから、もう一度実行してください</translation>
    </message>
    <message>
        <source>%1 settings were written and cannot be read back</source>
        <translation>%1 件の設定を書き込みました。読み戻すことはできません</translation>
    </message>
    <message>
        <source>1 setting was written and cannot be read back</source>
        <translation>1 件の設定を書き込みました。読み戻すことはできません</translation>
    </message>
    <message>
        <source>put it on again, and do it again</source>
        <translation>もう一度取り付けて、やり直してください</translation>
    </message>
    <message>
        <source>the unit was taken off while it waited for a number</source>
        <translation>番号を待っている間にユニットが取り外されました</translation>
    </message>
    <message>
        <source>%1 is not told as often as was asked for: %2</source>
        <translation>%1 は要求した頻度では通知されません：%2</translation>
    </message>
    <message>
        <source>%1: the gains were not put back: %2</source>
        <translation>%1：ゲインは元に戻されませんでした：%2</translation>
    </message>
    <message>
        <source>let it come to rest first</source>
        <translation>先に静止させてください</translation>
    </message>
    <message>
        <source>no position for %1</source>
        <translation>%1 の間、位置がありません</translation>
    </message>
    <message>
        <source>the gains were not put back: %1</source>
        <translation>ゲインは元に戻されませんでした：%1</translation>
    </message>
    <message>
        <source>the gains were not put back: %1; they are offered at the next connection</source>
        <translation>ゲインは元に戻されませんでした：%1。次の接続時に提示されます</translation>
    </message>
    <message>
        <source>the shaft still turns, so nobody can tell which way it is pushed</source>
        <translation>軸がまだ回っているため、どちらに押されたかわかりません</translation>
    </message>
    <message>
        <source>the stop was not confirmed by %1</source>
        <translation>%1 は停止を確認していません</translation>
    </message>
    <message>
        <source>what was proven could not be written: %1</source>
        <translation>実証された値を書き込めませんでした：%1</translation>
    </message>
    <message>
        <source>what was proven could not be written: %1; what was there before is in force again</source>
        <translation>実証された値を書き込めませんでした：%1。以前の値が再び有効です</translation>
    </message>
    <message>
        <source>what was proven could not be written: %1; what was there before was not put back: %2; it is offered at the next connection</source>
        <translation>実証された値を書き込めませんでした：%1。以前の値は元に戻されませんでした：%2。次の接続時に提示されます</translation>
    </message>
    <message>
        <source>a duty that grew to %1 did not move the motor both ways</source>
        <translation>%1 まで増やしたデューティでも、モーターは両方向には動きませんでした</translation>
    </message>
    <message>
        <source>it lets go at %1 forwards and %2 backwards, known within %3, and takes %4 and %5 while it turns (R² %6)</source>
        <translation>正方向は %1、逆方向は %2 で動き出し（誤差 %3 以内）、回転中は %4 と %5 を要します（R² %6）</translation>
    </message>
    <message>
        <source>pushing with a duty that grows to %1 in %2 s</source>
        <translation>%2 s で %1 まで増えるデューティを印加中</translation>
    </message>
    <message>
        <source>there is no room for a duty that grows slowly</source>
        <translation>ゆっくり増えるデューティを印加する余地がありません</translation>
    </message>
    <message>
        <source>%1 has a time that is more than 140 years from 1970</source>
        <translation>%1 に 1970 年から 140 年以上離れた時刻があります</translation>
    </message>
    <message>
        <source>record with the clock set</source>
        <translation>時計を合わせて記録してください</translation>
    </message>
    <message>
        <source>an experiment on it has not ended</source>
        <translation>この機器での実験がまだ終わっていません</translation>
    </message>
    <message>
        <source>begin a queue first</source>
        <translation>先にキューを始めてください</translation>
    </message>
    <message>
        <source>firmware is written to a unit here; the link stays open</source>
        <translation>ここで機器にファームウェアを書き込んでいるため、リンクは開いたままです</translation>
    </message>
    <message>
        <source>it has passed</source>
        <translation>合格しています</translation>
    </message>
    <message>
        <source>it is being served, or waits for its turn</source>
        <translation>処理中か、順番を待っています</translation>
    </message>
    <message>
        <source>it is not armed, or moves</source>
        <translation>駆動が許可されていないか、動いています</translation>
    </message>
    <message>
        <source>it is not in the queue</source>
        <translation>キューにありません</translation>
    </message>
    <message>
        <source>it was taken off</source>
        <translation>取り外されました</translation>
    </message>
    <message>
        <source>nothing is served here</source>
        <translation>ここでは何も処理していません</translation>
    </message>
    <message>
        <source>put it on again; it gets a row of its own</source>
        <translation>もう一度取り付けてください。新しい行になります</translation>
    </message>
    <message>
        <source>take it off and put it on again to serve it once more</source>
        <translation>もう一度処理するには、取り外してから取り付け直してください</translation>
    </message>
    <message>
        <source>wait until it has, or stop it</source>
        <translation>終わるまで待つか、止めてください</translation>
    </message>
    <message>
        <source>wait until it is done, or cancel it</source>
        <translation>終わるまで待つか、中止してください</translation>
    </message>
    <message>
        <source>after a move with a velocity or a profile it is not known from where this distance counts</source>
        <translation>速度またはプロファイルによる移動の後では、この距離がどこから数えられるか分かりません</translation>
    </message>
    <message>
        <source>avrdude read back all %1 bytes and they are equal, but the port is away</source>
        <translation>avrdude は全 %1 バイトを読み戻し、一致しましたが、ポートがありません</translation>
    </message>
    <message>
        <source>halt it first, or give a position</source>
        <translation>先に停止保持するか、位置を指定してください</translation>
    </message>
    <message>
        <source>restart the unit: its old firmware is still there</source>
        <translation>ユニットを再起動してください。元のファームウェアは残っています</translation>
    </message>
    <message>
        <source>the drive may hold half a program, and runs again once an update has succeeded</source>
        <translation>ドライブには途中までのプログラムしかない可能性があり、更新が成功すれば再び動作します</translation>
    </message>
    <message>
        <source>the motor may be %1 counts from where its loop holds it, and with this P that overflows</source>
        <translation>モーターはループの保持位置から %1 カウント離れている可能性があり、この P ではオーバーフローします</translation>
    </message>
    <message>
        <source>another adapter has this name now; what was found on the one before is not in the list any more</source>
        <translation>別のアダプターが今この名前です。前のアダプターで見つかったものは一覧にもうありません</translation>
    </message>
    <message>
        <source>another adapter is called %1 now</source>
        <translation>今は別のアダプターが %1 です</translation>
    </message>
    <message>
        <source>close the link, and open it again to see who is there</source>
        <translation>接続を閉じて開き直すと、誰がいるか分かります</translation>
    </message>
    <message>
        <source>another unit answers as number %1: serial number &apos;%2&apos; instead of &apos;%3&apos;</source>
        <translation>番号 %1 で別の機器が応答しています: シリアル番号は「%3」ではなく「%2」です</translation>
    </message>
    <message>
        <source>scan again, and update it if it is the one that is meant</source>
        <translation>再スキャンし、目的の機器であれば更新してください</translation>
    </message>
    <message>
        <source>the unit with number %1 has another session than before, and may be another unit: its serial number was not known</source>
        <translation>番号 %1 の機器のセッションが以前と異なり、別の機器かもしれません: シリアル番号は不明でした</translation>
    </message>
    <message>
        <source>begin it once more to serve this unit again</source>
        <translation>この機器をもう一度処理するには、もう一度開始してください</translation>
    </message>
    <message>
        <source>the queue was ended</source>
        <translation>キューは終了されました</translation>
    </message>
    <message>
        <source>%1 has more than %2 MB that are no samples</source>
        <translation>%1 にはサンプルではないデータが %2 MB を超えて含まれています</translation>
    </message>
    <message>
        <source>%1 was taken away; what memory still has of it is recorded anew</source>
        <translation>%1 がなくなりました。メモリに残っている分を改めて記録します</translation>
    </message>
    <message>
        <source>leave that folder where it is</source>
        <translation>そのフォルダーを移動・削除しないでください</translation>
    </message>
    <message>
        <source>the file was deleted while it was written</source>
        <translation>書き込み中にファイルが削除されました</translation>
    </message>
    <message>
        <source>write it anew</source>
        <translation>もう一度書き込んでください</translation>
    </message>
    <message>
        <source>the kernel does not say what %1 is: a driver holds it up</source>
        <translation>カーネルが %1 について応答しません: ドライバーが止めています</translation>
    </message>
    <message>
        <source>unplug the adapter and plug it in again</source>
        <translation>アダプターを抜いて、もう一度差し込んでください</translation>
    </message>
    <message>
        <source>its velocity loop begins with the mean speed since it ran last: from %1 to %2 counts/s, with the speed of now, is so much that with its gains the output would turn to full reverse</source>
        <translation>この速度ループは、前回動作してからの平均速度で始まります: 現在の速度と合わせた %1 ～ %2 counts/s の幅は大きすぎ、このゲインでは出力が逆転最大に反転します</translation>
    </message>
    <message>
        <source>stop the motor and let it stand for a while, or lower p</source>
        <translation>モーターを止めてしばらく静止させるか、p を下げてください</translation>
    </message>
    <message>
        <source>stop the motor and let it stand for a while, or write p, d and divisor of the loop once</source>
        <translation>モーターを止めてしばらく静止させるか、ループの p、d、divisor を一度書き込んでください</translation>
    </message>
    <message>
        <source>%1 has restarted, and nobody has looked at it since</source>
        <translation>%1 が再起動し、その後まだ確認されていません</translation>
    </message>
    <message>
        <source>Answers with offset %1 are destroyed on the bus, as where several drives have it and answer at once; offsets are compiled into the firmware, so give one of them another and flash it.</source>
        <translation>オフセット %1 の応答がバス上で壊れています。同じオフセットの複数のドライブが同時に応答する場合と同じです。オフセットはファームウェアに組み込まれているため、一方に別のオフセットを与えて書き込んでください。</translation>
    </message>
    <message>
        <source>the notebook may offer to put back what was there before: %1</source>
        <translation>以前の値に戻すことをノートが提案する場合があります: %1</translation>
    </message>
    <message>
        <source>turn its shaft until its position is %1 counts away from 0, which shows that it was off, then switch it off and on</source>
        <translation>位置が 0 から %1 カウント離れるまで軸を回してから（電源が切れたことがそれで分かります）、電源を入れ直してください</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be above 0 and at most %2</source>
        <translation>「%1」は 0 より大きく %2 以下でなければなりません</translation>
    </message>
    <message>
        <source>nothing was written, because what is there cannot be kept: %1</source>
        <translation>現在の内容を保存できないため、何も書き込まれませんでした：%1</translation>
    </message>
    <message>
        <source>where it is left out the unit&apos;s own limit serves</source>
        <translation>省略した場合はユニット自身の制限が使われます</translation>
    </message>
    <message>
        <source>its number holds from its next power cycle on, and nothing proves it before</source>
        <translation>番号は次に電源を入れ直してから有効になり、それまでは何によっても確かめられません</translation>
    </message>
    <message>
        <source>put it back first, as &apos;motorbenchctl set %1 %2&apos; does</source>
        <translation>まず「motorbenchctl set %1 %2」のようにして元に戻してください</translation>
    </message>
    <message>
        <source>trial %1 did not put back what it changed</source>
        <translation>試行 %1 は変更したものを元に戻していません</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must not be empty</source>
        <translation>「%1」は空にできません</translation>
    </message>
    <message>
        <source>the steps in both directions kept their limits; the gains are as they were</source>
        <translation>両方向のステップが限度内でした。ゲインは元のままです</translation>
    </message>
    <message>
        <source>the steps in both directions kept their limits; the gains were written and read back</source>
        <translation>両方向のステップが限度内でした。ゲインを書き込み、読み戻しました</translation>
    </message>
    <message>
        <source>the steps in both directions kept their limits; the gains were written, which this family cannot read back</source>
        <translation>両方向のステップが限度内でした。ゲインを書き込みましたが、このファミリでは読み戻せません</translation>
    </message>
    <message>
        <source>%1 CAN FD frames are left out, because only classic CAN is read</source>
        <translation>CAN FD フレーム %1 個は省かれています。読み込めるのはクラシック CAN だけです</translation>
    </message>
    <message>
        <source>1 CAN FD frame is left out, because only classic CAN is read</source>
        <translation>CAN FD フレーム 1 個は省かれています。読み込めるのはクラシック CAN だけです</translation>
    </message>
    <message>
        <source>a simulated board&apos;s socket has no option &apos;%1&apos;</source>
        <translation>シミュレートされた基板のソケットにオプション「%1」はありません</translation>
    </message>
    <message>
        <source>it has pace</source>
        <translation>あるのは pace です</translation>
    </message>
    <message>
        <source>leave one of the two out</source>
        <translation>どちらか一方を省いてください</translation>
    </message>
    <message>
        <source>legal are 0 and 1</source>
        <translation>使えるのは 0 と 1 です</translation>
    </message>
    <message>
        <source>link option &apos;%1&apos; is there twice</source>
        <translation>リンクのオプション「%1」が 2 回あります</translation>
    </message>
    <message>
        <source>pace=%1 is no choice</source>
        <translation>pace=%1 は選べません</translation>
    </message>
    <message>
        <source>the last line has no end, so its frame may be cut short</source>
        <translation>最後の行に行末がないので、そのフレームは途中で切れているかもしれません</translation>
    </message>
    <message>
        <source>the last line is cut off, and left out</source>
        <translation>最後の行は途中で切れているため、省かれています</translation>
    </message>
    <message>
        <source>nothing proves that its flash has what was written</source>
        <translation>書き込んだ内容がフラッシュにあることを証明するものがありません</translation>
    </message>
    <message>
        <source>switch its supply off and on, then do it again: what is read then comes from its flash</source>
        <translation>電源を切って入れ直し、もう一度行ってください。そのとき読まれる値はフラッシュのものです</translation>
    </message>
    <message>
        <source>take it out of the recipe&apos;s parameters, or serve such units by a recipe of their own</source>
        <translation>レシピのパラメータから外すか、このような機器には専用のレシピを使ってください</translation>
    </message>
    <message>
        <source>take one of them off, then test the other again</source>
        <translation>一方を外し、もう一方を再度テストしてください</translation>
    </message>
    <message>
        <source>this unit does not have %1 of the recipe</source>
        <translation>この機器にはレシピの %1 がありません</translation>
    </message>
    <message>
        <source>two units tell the serial number %1</source>
        <translation>2 台の機器がシリアル番号 %1 を返しています</translation>
    </message>
    <message>
        <source>a stop came before it was begun</source>
        <translation>始まる前に停止が指示されました</translation>
    </message>
    <message>
        <source>it has restarted, or a second unit has number %1: another session answers</source>
        <translation>再起動したか、2 台目の装置が番号 %1 を使っています。別のセッションが応答しています</translation>
    </message>
    <message>
        <source>its position is being reset</source>
        <translation>位置をリセットしているところです</translation>
    </message>
    <message>
        <source>it did not say that it restarts, and may have done so or not</source>
        <translation>再起動するという応答がなく、再起動したかどうかは分かりません</translation>
    </message>
    <message>
        <source>restart it once more</source>
        <translation>もう一度再起動してください</translation>
    </message>
    <message>
        <source>%1 leads to a terminal that another program serves</source>
        <translation>%1 は別のプログラムが使っている端末を指しています</translation>
    </message>
    <message>
        <source>%1 takes no bytes any more</source>
        <translation>%1 はもうバイトを受け付けません</translation>
    </message>
    <message>
        <source>a stop that is owed cannot be written down: %1 cannot be used</source>
        <translation>未完了の停止を記録できません: %1 を使えません</translation>
    </message>
    <message>
        <source>it must be a folder of yours that nobody else may write to</source>
        <translation>自分のフォルダで、ほかの誰も書き込めないものでなければなりません</translation>
    </message>
    <message>
        <source>the simulator at %1 does not answer</source>
        <translation>%1 のシミュレータが応答しません</translation>
    </message>
    <message>
        <source>a limit switch was met</source>
        <translation>リミットスイッチに達しました</translation>
    </message>
    <message>
        <source>no time was left to prove others</source>
        <translation>ほかの組を検証する時間は残っていませんでした</translation>
    </message>
    <message>
        <source>what these gains do is predicted, and not proven on the motor</source>
        <translation>これらのゲインの効果は予測であり、モーターで検証されていません</translation>
    </message>
    <message>
        <source>what was there is not known, and those that were tried are in force</source>
        <translation>元の値は不明で、試した値が有効になっています</translation>
    </message>
    <message>
        <source>its averaging was lowered, or set beyond 500, as far as can be known, and until it has lost its power once it may overwrite its own memory</source>
        <translation>平均化の値が小さくされたか 500 を超えて設定されたと考えられ、電源を一度切るまで自身のメモリを上書きするおそれがあります</translation>
    </message>
    <message>
        <source>stop the motor before its calibration is changed</source>
        <translation>校正を変更する前にモーターを停止してください</translation>
    </message>
    <message>
        <source>the power limit of axis %1 is %2: its motor gets no more</source>
        <translation>軸 %1 の出力制限は %2 です。モーターにはそれ以上かかりません</translation>
    </message>
    <message>
        <source>the velocity limit of axis %1 is %2: its motor goes no faster</source>
        <translation>軸 %1 の速度制限は %2 です。モーターはそれより速くなりません</translation>
    </message>
    <message>
        <source>write an averaging of 1 … 500, then switch it off and on</source>
        <translation>1 … 500 の平均化を書き込み、その後電源を入れ直してください</translation>
    </message>
    <message>
        <source>Nothing is written yet. Where OpenOCD has halted the drive already it stands still: switch it off and on</source>
        <translation>まだ何も書き込んでいません。OpenOCD がすでにドライブを停止させている場合は止まったままです。電源を入れ直してください</translation>
    </message>
    <message>
        <source>firmware is written here, or units are served; nothing was searched</source>
        <translation>ここではファームウェアの書き込み中か、ユニットの処理中です。何も検索していません</translation>
    </message>
    <message>
        <source>put the programmer on it, and look at the other one</source>
        <translation>プログラマーをこちらに接続し、もう一方を確認してください</translation>
    </message>
    <message>
        <source>the programmer wrote another unit: %1 answered all the while</source>
        <translation>プログラマーは別のユニットに書き込みました: %1 はその間ずっと応答していました</translation>
    </message>
    <message>
        <source>wait until it is done</source>
        <translation>終わるまで待ってください</translation>
    </message>
    <message>
        <source>averaging changed: it may overwrite its memory</source>
        <translation>平均化が変更された: メモリを上書きする恐れ</translation>
    </message>
    <message>
        <source>the acceptance mask of node %1 is not known, so it may do what is sent to node %2, too; set its error.level to 0 where it is 1, then scan again</source>
        <translation>ノード %1 のアクセプタンスマスクが分からないため、ノード %2 への指令も実行する可能性があります。その error.level が 1 なら 0 にしてから再スキャンしてください</translation>
    </message>
    <message>
        <source>All of it is written; whether the unit runs it is not known then</source>
        <translation>すべて書き込み済みです。機器がそれで動作するかは確認されません</translation>
    </message>
    <message>
        <source>%1 settings are lost with its power</source>
        <translation>%1 件の設定は電源が切れると失われます</translation>
    </message>
    <message>
        <source>%1 settings hold from its next power cycle on, and nothing proves them before</source>
        <translation>%1 件の設定は次に電源を入れ直してから有効になり、それまでは何によっても確かめられません</translation>
    </message>
    <message>
        <source>1 setting holds from its next power cycle on, and nothing proves it before</source>
        <translation>1 件の設定は次に電源を入れ直してから有効になり、それまでは何によっても確かめられません</translation>
    </message>
    <message>
        <source>1 setting is lost with its power</source>
        <translation>1 件の設定は電源が切れると失われます</translation>
    </message>
    <message>
        <source>a unit whose %1 was lowered must lose its power once before its motor may be driven</source>
        <translation>%1 を小さくしたユニットは、モーターを駆動する前に電源を一度切る必要があります</translation>
    </message>
    <message>
        <source>leave &apos;store&apos; out: its settings are lost with its power</source>
        <translation>&apos;store&apos; を省いてください。設定は電源が切れると失われます</translation>
    </message>
    <message>
        <source>leave it out of the file, or the self-test out of the recipe</source>
        <translation>ファイルからそれを外すか、レシピからセルフテストを外してください</translation>
    </message>
    <message>
        <source>no link is open on which such units may be</source>
        <translation>このような機器がありうるリンクが開いていません</translation>
    </message>
    <message>
        <source>no unit has failed that is still there</source>
        <translation>まだ接続されている不合格の機器はありません</translation>
    </message>
    <message>
        <source>open it first</source>
        <translation>先に開いてください</translation>
    </message>
    <message>
        <source>the search ends here, because firmware is written or units are served; what it found stays</source>
        <translation>ファームウェアの書き込みまたはユニットの処理が始まるため、検索をここで終了します。見つかったものは残ります</translation>
    </message>
    <message>
        <source>Abstract DC Drives so old that they answer no broadcast (dialect LL) are found at this bit rate only by their number, or by %1</source>
        <translation>ブロードキャストに応答しない古い Abstract DC Drive（方言 LL）は、このビットレートでは番号を指定するか、%1 でのみ見つかります</translation>
    </message>
    <message>
        <source>interrupted before it was done</source>
        <translation>完了する前に中断されました</translation>
    </message>
    <message>
        <source>run it again to finish</source>
        <translation>もう一度実行して完了してください</translation>
    </message>
    <message>
        <source>the last run of %1 was begun by another program, which still runs</source>
        <translation>%1 の最後の実行は別のプログラムが始めたもので、そのプログラムはまだ動いています</translation>
    </message>
    <message>
        <source>a drive of dialect LL hears its stop, too, and would be started by it</source>
        <translation>ダイアレクト LL のドライブにもこの停止が届き、それによって始動してしまいます</translation>
    </message>
    <message>
        <source>coarse</source>
        <translation>粗い</translation>
    </message>
    <message>
        <source>current limit</source>
        <translation>電流制限</translation>
    </message>
    <message>
        <source>derivative noise</source>
        <translation>微分ノイズ</translation>
    </message>
    <message>
        <source>did not move</source>
        <translation>動作せず</translation>
    </message>
    <message>
        <source>do it once more if it is the same</source>
        <translation>同じ機器であればもう一度実行してください</translation>
    </message>
    <message>
        <source>largest error</source>
        <translation>最大偏差</translation>
    </message>
    <message>
        <source>limit switch</source>
        <translation>リミットスイッチ</translation>
    </message>
    <message>
        <source>margin</source>
        <translation>余裕</translation>
    </message>
    <message>
        <source>not symmetric</source>
        <translation>非対称</translation>
    </message>
    <message>
        <source>ramp</source>
        <translation>ランプ</translation>
    </message>
    <message>
        <source>restart needed</source>
        <translation>要再起動</translation>
    </message>
    <message>
        <source>samples lost</source>
        <translation>サンプル欠落</translation>
    </message>
    <message>
        <source>saturated</source>
        <translation>飽和</translation>
    </message>
    <message>
        <source>stop not confirmed</source>
        <translation>停止未確認</translation>
    </message>
    <message>
        <source>stopped before its motor turned</source>
        <translation>モーターが回る前に停止されました</translation>
    </message>
    <message>
        <source>the unit tells no current in ampere: the duty limit stands in for %1 A</source>
        <translation>機器は電流をアンペアで通知しません。%1 A の代わりにデューティ上限が適用されます</translation>
    </message>
    <message>
        <source>this place, not this unit: what is kept may be of another</source>
        <translation>この機器ではなくこの場所の記録です：保存されているのは別の機器のものかもしれません</translation>
    </message>
    <message>
        <source>%1 answers, and a programmer would not tell them apart: take all others off the line</source>
        <translation>%1 が応答しており、書き込み装置では区別できません。ほかの機器をすべて回線から取り外してください</translation>
    </message>
    <message>
        <source>P, I and D are divided by it. Blank flash holds 0, with which no loop works; 0 is never written. A negative divisor keeps the integral across modes: to reverse the loop, change the signs of P, I and D.</source>
        <translation>P、I、D はこの値で割られます。空のフラッシュの値は 0 で、その場合ループは動作しません。0 は書き込みません。負の除数はモードが変わっても積分値を保持します。ループを反転させるには、P、I、D の符号を変えてください。</translation>
    </message>
    <message>
        <source>Samples of 20 ms in a mean of the current, which reads wrong until so many were taken: it is changed at a standstill. Once lowered, the drive must lose its power for a moment before it is driven.</source>
        <translation>電流の平均に使う 20 ms サンプルの数。その数だけ取得されるまで電流の読みは正しくないため、モーターの停止中に変更します。減らした場合は、駆動する前にドライブの電源をいったん切る必要があります。</translation>
    </message>
    <message>
        <source>%1 cannot blink</source>
        <translation>%1 は点滅できません</translation>
    </message>
    <message>
        <source>%1 has no name</source>
        <translation>%1 には名前がありません</translation>
    </message>
    <message>
        <source>choose a free one</source>
        <translation>空いているものを選んでください</translation>
    </message>
    <message>
        <source>lower them, or raise the divisor</source>
        <translation>それらを下げるか、除数を上げてください</translation>
    </message>
    <message>
        <source>no device of %1 can have the fault &apos;%2&apos;</source>
        <translation>%1 には fault「%2」を起こせる機器がありません</translation>
    </message>
    <message>
        <source>p and d are so high for the divisor that an error of 1 turns the output to full reverse</source>
        <translation>除数に対して p と d が大きすぎ、偏差 1 で出力が逆転最大に反転します</translation>
    </message>
    <message>
        <source>the motor is so far from its target that with this value the output would turn to full reverse</source>
        <translation>モーターが目標から離れすぎており、この値では出力が逆転最大に反転します</translation>
    </message>
    <message>
        <source>until it has averaged once it reads a wrong current</source>
        <translation>一度平均し終えるまで、電流の読みは正しくありません</translation>
    </message>
    <message>
        <source>give --velocity, or write a lower profile.velocity</source>
        <translation>--velocity を指定するか、より小さい profile.velocity を書き込んでください</translation>
    </message>
    <message>
        <source>somebody searches here already</source>
        <translation>ここではすでに検索中です</translation>
    </message>
    <message>
        <source>%1 no longer goes back by itself: the unit was gone or has restarted</source>
        <translation>%1 は自動では戻らなくなりました: ユニットが応答しなくなったか、再起動しました</translation>
    </message>
    <message>
        <source>at most %1 counts/s with its P</source>
        <translation>この P では最大 %1 counts/s です</translation>
    </message>
    <message>
        <source>its adapter has another name now; what was found under this one is not in the list any more</source>
        <translation>このアダプターの名前が今は別の名前です。この名前で見つかったものは一覧にもうありません</translation>
    </message>
    <message>
        <source>node %1 is on this line, too: it hears what the bootloader is told, and may be the one that is written</source>
        <translation>ノード %1 もこの線につながっています。ブートローダへの通信を受け取り、書き込まれるのがそのノードかもしれません</translation>
    </message>
    <message>
        <source>take all others off the line and scan it, or use a programmer on the pins</source>
        <translation>ほかの機器をすべて線から外して検索するか、ピンに接続する書込み器を使用してください</translation>
    </message>
    <message>
        <source>%1 cannot be told to brake or to coast</source>
        <translation>%1 にはブレーキまたはフリーランを指示できません</translation>
    </message>
    <message>
        <source>%1 cannot exchange directions</source>
        <translation>%1 では方向を反転できません</translation>
    </message>
    <message>
        <source>%1 has no limit override</source>
        <translation>%1 ではリミットを無効にできません</translation>
    </message>
    <message>
        <source>%1 has no ramp of the output in mode &apos;%2&apos;</source>
        <translation>%1 はモード「%2」では出力ランプを持ちません</translation>
    </message>
    <message>
        <source>docs/bench.md has the options of each family, and what they take</source>
        <translation>各ファミリのオプションとその値は docs/bench.md にあります</translation>
    </message>
    <message>
        <source>it is being recorded or replayed</source>
        <translation>記録中または再生中です</translation>
    </message>
    <message>
        <source>name a notebook that can be written</source>
        <translation>書込み可能なノートを指定してください</translation>
    </message>
    <message>
        <source>option &apos;%1&apos; is there twice</source>
        <translation>オプション「%1」が 2 回あります</translation>
    </message>
    <message>
        <source>seed and bitrate are whole numbers, loss is a fraction below 1</source>
        <translation>seed と bitrate は整数、loss は 1 未満の割合です</translation>
    </message>
    <message>
        <source>the file is for family &apos;%1&apos;, the device is of &apos;%2&apos;</source>
        <translation>ファイルはファミリ「%1」用ですが、機器は「%2」です</translation>
    </message>
    <message>
        <source>the rest of its disk is left to others</source>
        <translation>ディスクの残りはほかの用途に空けておきます</translation>
    </message>
    <message>
        <source>%1 keeps no setting without power</source>
        <translation>%1 は電源が切れると設定を保持しません</translation>
    </message>
    <message>
        <source>cut its power and try again after 10 minutes, or look at it and say in the window that it stands</source>
        <translation>電源を切って 10 分後にもう一度試すか、停止を目視で確認してウィンドウでその旨を知らせてください</translation>
    </message>
    <message>
        <source>the motor did not move when it was sent %1 counts up (%2 counts): stalled, or the encoder is dead</source>
        <translation>正方向 %1 counts の指令でモーターが動きませんでした (%2 counts): ストール、またはエンコーダの故障です</translation>
    </message>
    <message>
        <source>see that motor and load are those of the recipe and that its time is enough, then test again</source>
        <translation>モーターと負荷がレシピどおりであること、レシピの時間が足りていることを確認して再試験してください</translation>
    </message>
    <message>
        <source>%1 is %2 of its smallest steps, fewer than %3: one of them is %4</source>
        <translation>%1 は最小刻みの %2 個分で、%3 個より少なく、1 刻みが %4 になります</translation>
    </message>
    <message>
        <source>allow more current or aim for a calmer loop</source>
        <translation>電流の許容値を上げるか、より緩やかな制御ループを目標にしてください</translation>
    </message>
    <message>
        <source>any step of these gains draws more than the %1 A that are allowed</source>
        <translation>これらのゲインではどのステップでも許容の %1 A を超える電流が流れます</translation>
    </message>
    <message>
        <source>at most %1 duty and %2 counts from where it stands, at a speed that nobody knows yet</source>
        <translation>最大でデューティ %1、現在位置から %2 counts、速度はまだ不明</translation>
    </message>
    <message>
        <source>first its direction is checked: pushes of 0.3 s, until it turns</source>
        <translation>まず方向を確認: 回り出すまで 0.3 s のパルス</translation>
    </message>
    <message>
        <source>no gains as the device stores them keep a largest sensitivity of %1 in this loop</source>
        <translation>デバイスに保存される値では、このループの最大感度を %1 に保てるゲインがありません</translation>
    </message>
    <message>
        <source>left out before it was done</source>
        <translation>完了前に除外されました</translation>
    </message>
    <message>
        <source>load 9 × rotor inertia · 4096 counts a turn</source>
        <translation>負荷はロータ慣性の 9 倍 · 1 回転 4096 カウント</translation>
    </message>
    <message>
        <source>4096 counts a turn</source>
        <translation>1 回転 4096 カウント</translation>
    </message>
    <message>
        <source>reset it without the jumper of its bootloader</source>
        <translation>ブートローダのジャンパを外してリセットしてください</translation>
    </message>
    <message>
        <source>N20 geared</source>
        <translation>ギア付き N20</translation>
    </message>
    <message>
        <source>gear 75.81:1 · 32768 counts a turn</source>
        <translation>ギア 75.81:1 · 1 回転 32768 カウント</translation>
    </message>
    <message>
        <source>%1; update it</source>
        <translation>%1。更新してください</translation>
    </message>
    <message>
        <source>%1; update it, or %2</source>
        <translation>%1。更新するか、%2</translation>
    </message>
    <message>
        <source>nothing answers: no power, wrong wiring, another rate, or no program that runs</source>
        <translation>応答がありません：電源がない、配線が違う、速度が違う、または動作するプログラムがありません</translation>
    </message>
    <message>
        <source>stored, and the unit has proved it</source>
        <translation>保存しました。機器が証明しました</translation>
    </message>
    <message>
        <source>the device did not write its flash within %1 s</source>
        <translation>機器が %1 s 以内にフラッシュへ書き込みませんでした</translation>
    </message>
    <message>
        <source>%1 is busy: %2</source>
        <translation>%1 はビジーです: %2</translation>
    </message>
    <message>
        <source>%1 is driven already</source>
        <translation>%1 はすでに駆動されています</translation>
    </message>
    <message>
        <source>%1 is not armed</source>
        <translation>%1 は駆動許可されていません</translation>
    </message>
    <message>
        <source>%1 keeps its last set-point for ever: it has no watchdog</source>
        <translation>%1 はウォッチドッグがないため、最後の目標値を保持し続けます</translation>
    </message>
    <message>
        <source>assign one a new number first</source>
        <translation>先に一方へ新しい番号を割り当ててください</translation>
    </message>
    <message>
        <source>drive it from the Tune page</source>
        <translation>「調整」ページから駆動してください</translation>
    </message>
    <message>
        <source>halt it first</source>
        <translation>先に停止してください</translation>
    </message>
    <message>
        <source>no %1 is known on this link, so STOP could not reach it</source>
        <translation>このリンクに %1 が見つかっていないため、STOP が届きません</translation>
    </message>
    <message>
        <source>no open CAN link is shown</source>
        <translation>開いている CAN リンクが表示されていません</translation>
    </message>
    <message>
        <source>open one first</source>
        <translation>先に開いてください</translation>
    </message>
    <message>
        <source>scan first</source>
        <translation>先にスキャンしてください</translation>
    </message>
    <message>
        <source>select it, then hold Arm in the header</source>
        <translation>選択して、ヘッダの駆動許可ボタンを長押ししてください</translation>
    </message>
    <message>
        <source>they were proven by %1 steps instead of %2</source>
        <translation>%2 回ではなく %1 回のステップで検証されました</translation>
    </message>
    <message>
        <source>two units answer as %1</source>
        <translation>2 台の機器が %1 として応答しています</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>不明</translation>
    </message>
    <message>
        <source>is told no more to stop after 10 minutes: the motor may still turn, cut its power</source>
        <translation>10 分を過ぎたため停止指令の送信を終えました: モーターがまだ回転している可能性があります。電源を切ってください</translation>
    </message>
    <message>
        <source>no time was left to do the same again</source>
        <translation>同じことをやり直す時間は残っていませんでした</translation>
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
        <translation>移動量を小さくしてすべて許容するか、'motorbenchctl step' で手動調整してください</translation>
    </message>
    <message>
        <source>allow more duty or aim for a calmer loop</source>
        <translation>デューティの許容値を上げるか、より緩やかな制御ループを目標にしてください</translation>
    </message>
    <message>
        <source>it may rest %1 short of its target, which its allowable error lets it</source>
        <translation>目標の %1 手前で止まることがあります。許容誤差の範囲内です</translation>
    </message>
    <message>
        <source>nothing of its own keeps a position loop of %1 to %2 duty</source>
        <translation>%1 の位置ループをデューティ %2 に保つ自身の制限はありません</translation>
    </message>
    <message>
        <source>others that may leave less error were given up: %1</source>
        <translation>誤差が小さくなるかもしれない別のゲインは断念しました: %1</translation>
    </message>
    <message>
        <source>take a larger response</source>
        <translation>応答時間を長くしてください</translation>
    </message>
    <message>
        <source>the smallest step that proves these gains puts out %1 duty, %2 are allowed, and the unit has no limit of its own that keeps it to them</source>
        <translation>これらのゲインを検証できる最小のステップはデューティ %1 を出力しますが、許容は %2 で、このユニットにはそれを守る自身の制限がありません</translation>
    </message>
    <message>
        <source>the smallest step that proves these gains takes %1 counts of travel, %2 are allowed</source>
        <translation>これらのゲインを検証できる最小のステップには %1 カウントの移動量が必要ですが、許容は %2 です</translation>
    </message>
    <message>
        <source>these are given up: %1</source>
        <translation>これらは断念します: %1</translation>
    </message>
    <message>
        <source>these gains would overshoot by %1, and at most %2 are kept</source>
        <translation>これらのゲインは %1 オーバーシュートしますが、残せるのは %2 までです</translation>
    </message>
    <message>
        <source>they would put out more duty than is allowed</source>
        <translation>許容より大きなデューティを出力します</translation>
    </message>
    <message>
        <source>whether gains of an experiment are still to be put back is not known yet: %1</source>
        <translation>実験で変更したゲインを元に戻す必要があるかどうかはまだ不明です：%1</translation>
    </message>
</context>
</TS>
