<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
    <context>
        <name>components</name>
        <message>
            <source>squareness: axis %1 turned about %2</source>
            <translation>垂直度：%1 轴绕 %2 的转角</translation>
        </message>
        <message>
            <source>place of axis %1 shifted along %2</source>
            <translation>%1 轴位置沿 %2 的偏移</translation>
        </message>
        <message>
            <source>positioning error of %1</source>
            <translation>%1 轴定位误差</translation>
        </message>
        <message>
            <source>straightness of %1 in %2</source>
            <translation>%1 轴在 %2 方向的直线度</translation>
        </message>
        <message>
            <source>roll of %1</source>
            <translation>%1 轴滚转误差</translation>
        </message>
        <message>
            <source>tilt of %1 about %2</source>
            <translation>%1 轴绕 %2 的角度误差</translation>
        </message>
        <message>
            <source>axial motion of %1</source>
            <translation>%1 轴轴向窜动</translation>
        </message>
        <message>
            <source>radial motion of %1 in %2</source>
            <translation>%1 轴在 %2 方向的径向跳动</translation>
        </message>
        <message>
            <source>angular positioning error of %1</source>
            <translation>%1 轴角定位误差</translation>
        </message>
        <message>
            <source>wobble of %1 about %2</source>
            <translation>%1 轴绕 %2 的摆动</translation>
        </message>
        <message>
            <source>Scale error</source>
            <translation>比例误差</translation>
        </message>
        <message>
            <source>Backlash</source>
            <translation>反向间隙</translation>
        </message>
        <message>
            <source>Cyclic error</source>
            <translation>周期误差</translation>
        </message>
        <message>
            <source>Thermal growth of the screw</source>
            <translation>丝杠热伸长</translation>
        </message>
        <message>
            <source>Error table</source>
            <translation>误差表</translation>
        </message>
        <message>
            <source>Location error</source>
            <translation>位置误差</translation>
        </message>
        <message>
            <source>Growth per metre</source>
            <translation>每米伸长</translation>
        </message>
        <message>
            <source>Width of the play</source>
            <translation>间隙宽度</translation>
        </message>
        <message>
            <source>Amplitude</source>
            <translation>幅值</translation>
        </message>
        <message>
            <source>Period</source>
            <translation>周期</translation>
        </message>
        <message>
            <source>Phase</source>
            <translation>相位</translation>
        </message>
        <message>
            <source>Growth per metre and degree</source>
            <translation>每米每度伸长</translation>
        </message>
        <message>
            <source>Position of the fixed bearing</source>
            <translation>固定轴承位置</translation>
        </message>
        <message>
            <source>B2-K3032 thread grinder</source>
            <translation>B2-K3032 螺纹磨床</translation>
        </message>
        <message>
            <source>B2-K3032 thread grinder (worked example)</source>
            <translation>B2-K3032 螺纹磨床（示例）</translation>
        </message>
        <message>
            <source>Three-axis mill, X and Y under the table, Z in the head</source>
            <translation>三轴铣床，X、Y 在工作台，Z 在主轴头</translation>
        </message>
        <message>
            <source>Five-axis mill with a trunnion table A, C</source>
            <translation>五轴铣床，A、C 摇篮转台</translation>
        </message>
        <message>
            <source>Five-axis mill with a fork head C, B</source>
            <translation>五轴铣床，C、B 双摆头</translation>
        </message>
        <message>
            <source>Five-axis mill with a table C and a swivel head B</source>
            <translation>五轴铣床，C 转台与 B 摆头</translation>
        </message>
        <message>
            <source>Seven-axis five-linkage propeller machine</source>
            <translation>七轴五联动螺旋桨加工机床</translation>
        </message>
        <message>
            <source>Rotary table C</source>
            <translation>C 回转工作台</translation>
        </message>
        <message>
            <source>Linear stage X</source>
            <translation>X 直线轴</translation>
        </message>
    </context>
    <context>
        <name>messages</name>
        <message>
            <source>Cancelled.</source>
            <translation>已取消。</translation>
        </message>
        <message>
            <source>There is nothing here yet.</source>
            <translation>这里还没有内容。</translation>
        </message>
        <message>
            <source>There is no program yet.</source>
            <translation>还没有数控程序。</translation>
        </message>
        <message>
            <source>A value of the machine state cannot be used.</source>
            <translation>机床状态中有一个值无法使用。</translation>
        </message>
        <message>
            <source>A compensation option cannot be used.</source>
            <translation>一个补偿选项无法使用。</translation>
        </message>
        <message>
            <source>The machine description is not right.</source>
            <translation>机床描述有误。</translation>
        </message>
        <message>
            <source>The text is not as expected.</source>
            <translation>文本格式与预期不符。</translation>
        </message>
        <message>
            <source>A measured error or effect is not right.</source>
            <translation>某个测量误差或效应有误。</translation>
        </message>
        <message>
            <source>An error table is not right.</source>
            <translation>某个误差表有误。</translation>
        </message>
        <message>
            <source>A word of the program needs a number.</source>
            <translation>程序中的一个字缺少数值。</translation>
        </message>
        <message>
            <source>The program names an axis that the machine lacks.</source>
            <translation>程序使用了机床没有的轴。</translation>
        </message>
        <message>
            <source>The program has a code that could be motion and is not understood.</source>
            <translation>程序中有一个可能引起运动但无法识别的代码。</translation>
        </message>
        <message>
            <source>The program depends on something that is known at run time only.</source>
            <translation>程序依赖于运行时才能确定的内容。</translation>
        </message>
        <message>
            <source>Centre, radius and end of an arc do not fit.</source>
            <translation>圆弧的圆心、半径与终点不一致。</translation>
        </message>
        <message>
            <source>The program cannot be read here.</source>
            <translation>程序在此处无法读取。</translation>
        </message>
        <message>
            <source>A command lies outside the travel of an axis.</source>
            <translation>指令超出了轴的行程。</translation>
        </message>
        <message>
            <source>The model needs a temperature or condition that is not given.</source>
            <translation>模型需要的温度或条件没有给出。</translation>
        </message>
        <message>
            <source>The program cannot be simulated on this machine.</source>
            <translation>程序无法在此机床上仿真。</translation>
        </message>
        <message>
            <source>A correction is larger than its limit.</source>
            <translation>补偿量超过限值。</translation>
        </message>
        <message>
            <source>The program cannot be compensated.</source>
            <translation>程序无法补偿。</translation>
        </message>
        <message>
            <source>A thread parameter needs attention.</source>
            <translation>请检查螺纹参数。</translation>
        </message>
        <message>
            <source>The project was saved by a newer version of Nineline.</source>
            <translation>该项目由更新版本的 Nineline 保存。</translation>
        </message>
        <message>
            <source>The project file is damaged.</source>
            <translation>项目文件已损坏。</translation>
        </message>
        <message>
            <source>The project file cannot be used.</source>
            <translation>项目文件无法使用。</translation>
        </message>
        <message>
            <source>The file cannot be read or written.</source>
            <translation>文件无法读取或写入。</translation>
        </message>
        <message>
            <source>Line %1:</source>
            <translation>第 %1 行：</translation>
        </message>
        <message>
            <source>Line %1, column %2:</source>
            <translation>第 %1 行第 %2 列：</translation>
        </message>
        <message>
            <source>%1 (%2 times)</source>
            <translation>%1（共 %2 次）</translation>
        </message>
        <message>
            <source>The axes cannot reach a pose that the program asks for.</source>
            <translation>各轴无法到达程序要求的位姿。</translation>
        </message>
        <message>
            <source>Outside the range of an error table its end value is used.</source>
            <translation>超出误差表范围时使用其端点值。</translation>
        </message>
        <message>
            <source>An axis is not corrected before the program has stated its position.</source>
            <translation>在程序给出某轴位置之前，该轴不作补偿。</translation>
        </message>
        <message>
            <source>The control's cutter compensation acts on the corrected path.</source>
            <translation>数控系统的刀具半径补偿作用于补偿后的路径。</translation>
        </message>
        <message>
            <source>A canned cycle is not corrected inside.</source>
            <translation>固定循环内部不作补偿。</translation>
        </message>
        <message>
            <source>Somewhere the path stays outside the tolerance.</source>
            <translation>部分路径仍超出公差。</translation>
        </message>
        <message>
            <source>Some errors cannot be corrected by the axes that may move.</source>
            <translation>部分误差无法由可运动的轴补偿。</translation>
        </message>
        <message>
            <source>A code that moves nothing was passed through.</source>
            <translation>不引起运动的代码原样保留。</translation>
        </message>
        <message>
            <source>A value that the program does not state was assumed.</source>
            <translation>程序未给出的值采用了假定值。</translation>
        </message>
    </context>
    <context>
        <name>nineline::models::ComponentTreeModel</name>
        <message>
            <source>Axis %1</source>
            <translation>%1 轴</translation>
        </message>
        <message>
            <source>Squareness and place</source>
            <translation>垂直度与位置</translation>
        </message>
        <message>
            <source>Other effects</source>
            <translation>其他效应</translation>
        </message>
        <message>
            <source>Error</source>
            <translation>误差</translation>
        </message>
        <message>
            <source>Values</source>
            <translation>个数</translation>
        </message>
    </context>
    <context>
        <name>nineline::models::DifferenceModel</name>
        <message>
            <source>added</source>
            <translation>新增</translation>
        </message>
        <message>
            <source>inserted</source>
            <translation>插入</translation>
        </message>
        <message>
            <source>left out</source>
            <translation>删去</translation>
        </message>
        <message>
            <source>Line</source>
            <translation>行</translation>
        </message>
        <message>
            <source>Original program</source>
            <translation>原程序</translation>
        </message>
        <message>
            <source>Corrected program</source>
            <translation>补偿后程序</translation>
        </message>
        <message>
            <source>Difference</source>
            <translation>差值</translation>
        </message>
    </context>
    <context>
        <name>nineline::models::ErrorTableModel</name>
        <message>
            <source>There is nothing to paste.</source>
            <translation>没有可粘贴的内容。</translation>
        </message>
        <message>
            <source>'%1' is no position.</source>
            <translation>“%1”不是位置值。</translation>
        </message>
        <message>
            <source>Paste at least two positions, or values alone.</source>
            <translation>请至少粘贴两个位置，或只粘贴误差值。</translation>
        </message>
        <message>
            <source>The positions must grow from row to row.</source>
            <translation>位置必须逐行增大。</translation>
        </message>
        <message>
            <source>The positions are not equally spaced: row %1 is %2, expected %3.</source>
            <translation>位置间距不等：第 %1 行为 %2，应为 %3。</translation>
        </message>
        <message>
            <source>A table takes at most %1 values.</source>
            <translation>一个表最多 %1 个值。</translation>
        </message>
        <message>
            <source>A value is missing here.</source>
            <translation>此处缺少数值。</translation>
        </message>
        <message>
            <source>'%1' is no number. Type digits, with a point or a comma.</source>
            <translation>“%1”不是数字。请输入数字，小数点或逗号均可。</translation>
        </message>
        <message>
            <source>%1 %2 is very large for a machine error. Is the unit right?</source>
            <translation>%1 %2 作为机床误差过大，单位是否正确？</translation>
        </message>
        <message>
            <source>Position, %1</source>
            <translation>位置，%1</translation>
        </message>
        <message>
            <source>%1, %2</source>
            <translation>%1，%2</translation>
        </message>
    </context>
    <context>
        <name>nineline::models::LocationModel</name>
        <message>
            <source>This is no number.</source>
            <translation>这不是数字。</translation>
        </message>
        <message>
            <source>Location error</source>
            <translation>位置误差</translation>
        </message>
        <message>
            <source>Value</source>
            <translation>数值</translation>
        </message>
        <message>
            <source>Unit</source>
            <translation>单位</translation>
        </message>
    </context>
    <context>
        <name>nineline::models::SummaryModel</name>
        <message>
            <source>Axis %1, %2</source>
            <translation>%1 轴，%2</translation>
        </message>
        <message>
            <source>Tool tip x, µm</source>
            <translation>刀尖 x，µm</translation>
        </message>
        <message>
            <source>Tool tip y, µm</source>
            <translation>刀尖 y，µm</translation>
        </message>
        <message>
            <source>Tool tip z, µm</source>
            <translation>刀尖 z，µm</translation>
        </message>
        <message>
            <source>Tool tip distance, µm</source>
            <translation>刀尖偏差，µm</translation>
        </message>
        <message>
            <source>Tool axis, ″</source>
            <translation>刀轴，″</translation>
        </message>
        <message>
            <source>Error of</source>
            <translation>误差项</translation>
        </message>
        <message>
            <source>Mean
before</source>
            <translation>平均
补偿前</translation>
        </message>
        <message>
            <source>Mean
after</source>
            <translation>平均
补偿后</translation>
        </message>
        <message>
            <source>RMS
before</source>
            <translation>均方根
补偿前</translation>
        </message>
        <message>
            <source>RMS
after</source>
            <translation>均方根
补偿后</translation>
        </message>
        <message>
            <source>Largest
before</source>
            <translation>最大
补偿前</translation>
        </message>
        <message>
            <source>Largest
after</source>
            <translation>最大
补偿后</translation>
        </message>
        <message>
            <source>RMS
removed</source>
            <translation>均方根
消除</translation>
        </message>
    </context>
    <context>
        <name>nineline::models::Workspace</name>
        <message>
            <source>No measured errors yet: type, paste or load them for at least one axis.</source>
            <translation>还没有测量误差：请为至少一个轴输入、粘贴或载入。</translation>
        </message>
        <message>
            <source>Open an NC program or generate a thread.</source>
            <translation>请打开数控程序或生成螺纹程序。</translation>
        </message>
        <message>
            <source>Something has changed since this result was computed: start the compensation again.</source>
            <translation>结果计算之后数据已有改动：请重新开始补偿。</translation>
        </message>
        <message>
            <source>Start the compensation to get the corrected program.</source>
            <translation>开始补偿即可得到补偿后的程序。</translation>
        </message>
        <message>
            <source>There is no result yet: start the compensation first.</source>
            <translation>还没有结果：请先开始补偿。</translation>
        </message>
        <message>
            <source>Load readings of the corrected machine to compare with the model.</source>
            <translation>请载入已校正机床的读数，以便与模型比较。</translation>
        </message>
        <message>
            <source>Start the search to see what the model lacks.</source>
            <translation>开始搜索，查看模型缺少什么。</translation>
        </message>
        <message>
            <source>The model or the readings have changed since this search.</source>
            <translation>搜索之后模型或读数已更改。</translation>
        </message>
    </context>
    <context>
        <name>nineline::pages::AxisPanel</name>
        <message>
            <source>All axes to zero</source>
            <translation>各轴回零</translation>
        </message>
    </context>
    <context>
        <name>nineline::pages::CameraButtons</name>
        <message>
            <source>3D</source>
            <translation>三维</translation>
        </message>
        <message>
            <source>Front</source>
            <translation>前视</translation>
        </message>
        <message>
            <source>Top</source>
            <translation>俯视</translation>
        </message>
        <message>
            <source>Side</source>
            <translation>侧视</translation>
        </message>
    </context>
    <context>
        <name>nineline::pages::CompensatePage</name>
        <message>
            <source>Set how the program is corrected, then start the compensation.</source>
            <translation>设定程序的补偿方式，然后开始补偿。</translation>
        </message>
        <message>
            <source>Correction</source>
            <translation>补偿</translation>
        </message>
        <message>
            <source>Change machine state</source>
            <translation>更改机床状态</translation>
        </message>
        <message>
            <source>Control and machine state</source>
            <translation>数控系统与机床状态</translation>
        </message>
        <message>
            <source>Start compensation</source>
            <translation>开始补偿</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>取消</translation>
        </message>
        <message>
            <source>Show results</source>
            <translation>查看结果</translation>
        </message>
        <message>
            <source>Change option</source>
            <translation>更改选项</translation>
        </message>
        <message>
            <source>The compensation cannot start.</source>
            <translation>补偿无法开始。</translation>
        </message>
        <message>
            <source>Computing the corrected program…</source>
            <translation>正在计算补偿后的程序…</translation>
        </message>
        <message>
            <source>Cancelled. Nothing was changed.</source>
            <translation>已取消，未作任何改动。</translation>
        </message>
        <message>
            <source>The program was not corrected.</source>
            <translation>程序未能补偿。</translation>
        </message>
        <message>
            <source>About %1 left</source>
            <translation>约剩 %1</translation>
        </message>
        <message>
            <source>NC program corrected</source>
            <translation>数控程序补偿完成</translation>
        </message>
        <message>
            <source>blocks corrected, of %1</source>
            <translation>个程序段已补偿，共 %1 段</translation>
        </message>
        <message>
            <source>lines inserted</source>
            <translation>行插入</translation>
        </message>
        <message>
            <source>RMS deviation removed</source>
            <translation>均方根偏差消除</translation>
        </message>
        <message>
            <source>RMS deviation before</source>
            <translation>补偿前均方根偏差</translation>
        </message>
        <message>
            <source>RMS deviation after</source>
            <translation>补偿后均方根偏差</translation>
        </message>
        <message>
            <source>largest deviation after</source>
            <translation>补偿后最大偏差</translation>
        </message>
        <message>
            <source>The corrected program was read again and simulated apart from the correction: no warnings.</source>
            <translation>补偿后的程序已重新读取并独立仿真：没有警告。</translation>
        </message>
    </context>
    <context>
        <name>nineline::pages::EffectsEditor</name>
        <message>
            <source>Other effects</source>
            <translation>其他效应</translation>
        </message>
        <message>
            <source>Effects with a few parameters that act beside the tables.</source>
            <translation>与误差表同时起作用、只有几个参数的效应。</translation>
        </message>
        <message>
            <source>Add effect</source>
            <translation>添加效应</translation>
        </message>
        <message>
            <source>Remove effect</source>
            <translation>删除效应</translation>
        </message>
        <message>
            <source>Axis %1</source>
            <translation>%1 轴</translation>
        </message>
        <message>
            <source>Change effect</source>
            <translation>更改效应</translation>
        </message>
    </context>
    <context>
        <name>nineline::pages::ErrorCurves</name>
        <message>
            <source>path length</source>
            <translation>路径长度</translation>
        </message>
        <message>
            <source>time</source>
            <translation>时间</translation>
        </message>
        <message>
            <source>axis position</source>
            <translation>轴位置</translation>
        </message>
        <message>
            <source>Save picture…</source>
            <translation>保存图片…</translation>
        </message>
        <message>
            <source>Error of</source>
            <translation>误差：</translation>
        </message>
        <message>
            <source>over</source>
            <translation>随</translation>
        </message>
        <message>
            <source>before</source>
            <translation>补偿前</translation>
        </message>
        <message>
            <source>after</source>
            <translation>补偿后</translation>
        </message>
        <message>
            <source>Axis %1</source>
            <translation>%1 轴</translation>
        </message>
        <message>
            <source>Tool tip</source>
            <translation>刀尖</translation>
        </message>
    </context>
    <context>
        <name>nineline::pages::ExportPage</name>
        <message>
            <source>Compare the corrected program with the original, then save it for the machine.</source>
            <translation>对照补偿后的程序与原程序，然后保存以供机床使用。</translation>
        </message>
        <message>
            <source>Next difference</source>
            <translation>下一处差异</translation>
        </message>
        <message>
            <source>Save corrected program…</source>
            <translation>保存补偿后程序…</translation>
        </message>
        <message>
            <source>Save corrected program</source>
            <translation>保存补偿后程序</translation>
        </message>
        <message>
            <source>Something has changed since this program was corrected. Save it all the same?</source>
            <translation>程序补偿之后数据已有改动。仍要保存吗？</translation>
        </message>
        <message>
            <source>NC programs (*.%1);;All files (*)</source>
            <translation>数控程序 (*.%1);;所有文件 (*)</translation>
        </message>
    </context>
    <context>
        <name>nineline::pages::LocationEditor</name>
        <message>
            <source>Constants of where the axis stands and how it is turned. Leave empty what was not measured; C0Y turns the direction of Y about Z.</source>
            <translation>轴的安装位置与方向的常值误差。未测量的留空；C0Y 表示 Y 方向绕 Z 的转角。</translation>
        </message>
        <message>
            <source>Change %1</source>
            <translation>更改 %1</translation>
        </message>
        <message>
            <source>Clear values</source>
            <translation>清除数值</translation>
        </message>
        <message>
            <source>Squareness and place of axis %1</source>
            <translation>%1 轴的垂直度与位置</translation>
        </message>
    </context>
    <context>
        <name>nineline::pages::MachinePage</name>
        <message>
            <source>Choose the machine whose errors are compensated, or open its file.</source>
            <translation>选择要补偿误差的机床，或打开机床文件。</translation>
        </message>
        <message>
            <source>Open machine file…</source>
            <translation>打开机床文件…</translation>
        </message>
        <message>
            <source>Save machine file…</source>
            <translation>保存机床文件…</translation>
        </message>
        <message>
            <source>Move axes</source>
            <translation>移动各轴</translation>
        </message>
        <message>
            <source>Machine file</source>
            <translation>机床文件</translation>
        </message>
        <message>
            <source>Axes %1</source>
            <translation>轴 %1</translation>
        </message>
        <message>
            <source>Choose machine</source>
            <translation>选择机床</translation>
        </message>
        <message>
            <source>Open machine file</source>
            <translation>打开机床文件</translation>
        </message>
        <message>
            <source>Machine files (*.json);;All files (*)</source>
            <translation>机床文件 (*.json);;所有文件 (*)</translation>
        </message>
        <message>
            <source>Save machine file</source>
            <translation>保存机床文件</translation>
        </message>
        <message>
            <source>Edit machine file</source>
            <translation>编辑机床文件</translation>
        </message>
        <message>
            <source>The machine file is right.</source>
            <translation>机床文件正确。</translation>
        </message>
    </context>
    <context>
        <name>nineline::pages::MeasurementsPage</name>
        <message>
            <source>Type, paste or load the measured errors of each axis. Deviations are actual minus ideal.</source>
            <translation>输入、粘贴或载入各轴测得的几何误差。偏差为实际值减理想值。</translation>
        </message>
        <message>
            <source>Load error values</source>
            <translation>载入误差值</translation>
        </message>
        <message>
            <source>Tables (*.csv *.txt *.tsv);;All files (*)</source>
            <translation>表格 (*.csv *.txt *.tsv);;所有文件 (*)</translation>
        </message>
        <message>
            <source>Open model…</source>
            <translation>打开模型…</translation>
        </message>
        <message>
            <source>Save model…</source>
            <translation>保存模型…</translation>
        </message>
        <message>
            <source>Open error model</source>
            <translation>打开误差模型</translation>
        </message>
        <message>
            <source>Error models (*.json);;All files (*)</source>
            <translation>误差模型 (*.json);;所有文件 (*)</translation>
        </message>
        <message>
            <source>Error model</source>
            <translation>误差模型</translation>
        </message>
        <message>
            <source>Save error model</source>
            <translation>保存误差模型</translation>
        </message>
        <message>
            <source>Errors</source>
            <translation>误差</translation>
        </message>
        <message>
            <source>Readings</source>
            <translation>读数</translation>
        </message>
    </context>
    <context>
        <name>nineline::pages::PathPanel</name>
        <message>
            <source>Click the path to see block, command and deviation.</source>
            <translation>点击路径可查看程序段、指令与偏差。</translation>
        </message>
        <message>
            <source>Save picture…</source>
            <translation>保存图片…</translation>
        </message>
        <message>
            <source>Before and after</source>
            <translation>补偿前与补偿后</translation>
        </message>
        <message>
            <source>Before compensation</source>
            <translation>补偿前</translation>
        </message>
        <message>
            <source>After compensation</source>
            <translation>补偿后</translation>
        </message>
        <message>
            <source>Show</source>
            <translation>显示</translation>
        </message>
        <message>
            <source>Deviation magnified</source>
            <translation>偏差放大</translation>
        </message>
        <message>
            <source>Line %1 · command %2</source>
            <translation>第 %1 行 · 指令 %2</translation>
        </message>
        <message>
            <source>before: %1</source>
            <translation>补偿前：%1</translation>
        </message>
        <message>
            <source>after: %1</source>
            <translation>补偿后：%1</translation>
        </message>
    </context>
    <context>
        <name>nineline::pages::ProgramPage</name>
        <message>
            <source>Open the NC program to correct, or generate one for a thread.</source>
            <translation>打开要补偿的数控程序，或生成螺纹程序。</translation>
        </message>
        <message>
            <source>Generate thread program</source>
            <translation>生成螺纹程序</translation>
        </message>
        <message>
            <source>Open NC program…</source>
            <translation>打开数控程序…</translation>
        </message>
        <message>
            <source>Open NC program</source>
            <translation>打开数控程序</translation>
        </message>
        <message>
            <source>NC programs (*.nc *.ngc *.tap *.mpf *.txt *.iso *.eia *.gcode);;All files (*)</source>
            <translation>数控程序 (*.nc *.ngc *.tap *.mpf *.txt *.iso *.eia *.gcode);;所有文件 (*)</translation>
        </message>
        <message>
            <source>NC program</source>
            <translation>数控程序</translation>
        </message>
        <message>
            <source>Change thread</source>
            <translation>更改螺纹</translation>
        </message>
        <message>
            <source>Thread program</source>
            <translation>螺纹程序</translation>
        </message>
        <message>
            <source>The thread parameters are right.</source>
            <translation>螺纹参数正确。</translation>
        </message>
        <message>
            <source>No program yet</source>
            <translation>还没有程序</translation>
        </message>
        <message>
            <source>%1 blocks · path %2 · %3</source>
            <translation>%1 个程序段 · 路径 %2 · %3</translation>
        </message>
        <message>
            <source>The program can be read whole.</source>
            <translation>程序可以完整读取。</translation>
        </message>
    </context>
    <context>
        <name>nineline::pages::ResultsPage</name>
        <message>
            <source>What the errors did to the tool path, and what is left of it after compensation.</source>
            <translation>误差对刀具路径的影响，以及补偿后的残余。</translation>
        </message>
        <message>
            <source>Save picture</source>
            <translation>保存图片</translation>
        </message>
        <message>
            <source>Pictures (*.png)</source>
            <translation>图片 (*.png)</translation>
        </message>
        <message>
            <source>Save figures and path as CSV…</source>
            <translation>将数据与路径保存为 CSV…</translation>
        </message>
        <message>
            <source>Save figures and path</source>
            <translation>保存数据与路径</translation>
        </message>
        <message>
            <source>Tables (*.csv)</source>
            <translation>表格 (*.csv)</translation>
        </message>
        <message>
            <source>Last of %1 cuts</source>
            <translation>最后一刀（共 %1 刀）</translation>
        </message>
        <message>
            <source>Whole program</source>
            <translation>整个程序</translation>
        </message>
        <message>
            <source>Last cut</source>
            <translation>最后一刀</translation>
        </message>
        <message>
            <source>Path and curves of</source>
            <translation>路径与曲线范围</translation>
        </message>
        <message>
            <source>The table is of the whole program.</source>
            <translation>表格为整个程序的数据。</translation>
        </message>
    </context>
    <context>
        <name>nineline::pages::SetupEditor</name>
        <message>
            <source>State of the machine</source>
            <translation>机床状态</translation>
        </message>
        <message>
            <source>Control</source>
            <translation>数控系统</translation>
        </message>
        <message>
            <source>Work offset %1</source>
            <translation>工件偏置 %1</translation>
        </message>
        <message>
            <source>Position before the first block</source>
            <translation>首个程序段之前的位置</translation>
        </message>
        <message>
            <source>Tool lengths</source>
            <translation>刀具长度</translation>
        </message>
        <message>
            <source>none</source>
            <translation>无</translation>
        </message>
    </context>
    <context>
        <name>nineline::pages::TableEditor</name>
        <message>
            <source>Change %1</source>
            <translation>更改 %1</translation>
        </message>
        <message>
            <source>Smooth (cubic)</source>
            <translation>平滑（三次）</translation>
        </message>
        <message>
            <source>Straight (linear)</source>
            <translation>直线（线性）</translation>
        </message>
        <message>
            <source>Turns with the axis</source>
            <translation>随轴转动</translation>
        </message>
        <message>
            <source>Stands still</source>
            <translation>静止</translation>
        </message>
        <message>
            <source>Start</source>
            <translation>起点</translation>
        </message>
        <message>
            <source>Spacing</source>
            <translation>间距</translation>
        </message>
        <message>
            <source>Count</source>
            <translation>点数</translation>
        </message>
        <message>
            <source>Between the points</source>
            <translation>点间插值</translation>
        </message>
        <message>
            <source>Measured in a frame that</source>
            <translation>测量坐标系</translation>
        </message>
        <message>
            <source>Load CSV…</source>
            <translation>载入 CSV…</translation>
        </message>
        <message>
            <source>Remove table</source>
            <translation>删除误差表</translation>
        </message>
        <message>
            <source>nothing entered yet</source>
            <translation>尚未输入</translation>
        </message>
        <message>
            <source>The spacing must be above 0.</source>
            <translation>间距必须大于 0。</translation>
        </message>
        <message>
            <source>Change grid</source>
            <translation>更改网格</translation>
        </message>
        <message>
            <source>Change count</source>
            <translation>更改点数</translation>
        </message>
        <message>
            <source>Change interpolation</source>
            <translation>更改插值</translation>
        </message>
    </context>
    <context>
        <name>nineline::shell::Application</name>
        <message>
            <source>Mistake of the program</source>
            <translation>程序错误</translation>
        </message>
        <message>
            <source>Nineline made a mistake and stopped what it was doing. Your work is kept.</source>
            <translation>Nineline 出现错误并停止了当前操作。您的工作已保留。</translation>
        </message>
    </context>
    <context>
        <name>nineline::shell::MainWindow</name>
        <message>
            <source>Mistake of the program</source>
            <translation>程序错误</translation>
        </message>
        <message>
            <source>Nineline made a mistake and stopped what it was doing. Your work is kept.</source>
            <translation>Nineline 出现错误并停止了当前操作。您的工作已保留。</translation>
        </message>
        <message>
            <source>Nineline projects (*.nineline)</source>
            <translation>Nineline 项目 (*.nineline)</translation>
        </message>
        <message>
            <source>Worked example</source>
            <translation>示例</translation>
        </message>
        <message>
            <source>Open project</source>
            <translation>打开项目</translation>
        </message>
        <message>
            <source>Project</source>
            <translation>项目</translation>
        </message>
        <message>
            <source>'%1' was not opened.</source>
            <translation>未能打开“%1”。</translation>
        </message>
        <message>
            <source>This project can be read, not written: save it under another name.</source>
            <translation>该项目只能读取，不能写入：请另存为其他名称。</translation>
        </message>
        <message>
            <source>Save project</source>
            <translation>保存项目</translation>
        </message>
        <message>
            <source>Unsaved changes</source>
            <translation>未保存的更改</translation>
        </message>
        <message>
            <source>Save the changes to this project first?</source>
            <translation>是否先保存对此项目的更改？</translation>
        </message>
        <message>
            <source>A copy of the project was saved as %1.</source>
            <translation>项目副本已保存为 %1。</translation>
        </message>
        <message>
            <source>new project</source>
            <translation>新项目</translation>
        </message>
        <message>
            <source>&amp;Language</source>
            <translation>语言(&amp;L)</translation>
        </message>
        <message>
            <source>&amp;Help</source>
            <translation>帮助(&amp;H)</translation>
        </message>
        <message>
            <source>&amp;About Nineline</source>
            <translation>关于 Nineline(&amp;A)</translation>
        </message>
        <message>
            <source>&amp;File</source>
            <translation>文件(&amp;F)</translation>
        </message>
        <message>
            <source>&amp;New project</source>
            <translation>新建项目(&amp;N)</translation>
        </message>
        <message>
            <source>&amp;Open project…</source>
            <translation>打开项目(&amp;O)…</translation>
        </message>
        <message>
            <source>Recent projects</source>
            <translation>最近的项目</translation>
        </message>
        <message>
            <source>Open &amp;worked example</source>
            <translation>打开示例(&amp;W)</translation>
        </message>
        <message>
            <source>&amp;Save project</source>
            <translation>保存项目(&amp;S)</translation>
        </message>
        <message>
            <source>Save project &amp;as…</source>
            <translation>项目另存为(&amp;A)…</translation>
        </message>
        <message>
            <source>&amp;Quit</source>
            <translation>退出(&amp;Q)</translation>
        </message>
        <message>
            <source>&amp;Edit</source>
            <translation>编辑(&amp;E)</translation>
        </message>
        <message>
            <source>Undo</source>
            <translation>撤销</translation>
        </message>
        <message>
            <source>Redo</source>
            <translation>重做</translation>
        </message>
        <message>
            <source>&amp;View</source>
            <translation>视图(&amp;V)</translation>
        </message>
        <message>
            <source>Machine</source>
            <translation>机床</translation>
        </message>
        <message>
            <source>Measurements</source>
            <translation>测量</translation>
        </message>
        <message>
            <source>Program</source>
            <translation>程序</translation>
        </message>
        <message>
            <source>Compensate</source>
            <translation>补偿</translation>
        </message>
        <message>
            <source>Results</source>
            <translation>结果</translation>
        </message>
        <message>
            <source>Export</source>
            <translation>导出</translation>
        </message>
        <message>
            <source>Full screen</source>
            <translation>全屏</translation>
        </message>
        <message>
            <source>None yet</source>
            <translation>暂无</translation>
        </message>
        <message>
            <source>About Nineline</source>
            <translation>关于 Nineline</translation>
        </message>
        <message>
            <source>&lt;h3&gt;Nineline %1&lt;/h3&gt;&lt;p&gt;Measured machine errors in, corrected NC program out.&lt;/p&gt;&lt;p&gt;Every error of every axis is one effect of one model; the program that comes out is read again and simulated before you get it.&lt;/p&gt;</source>
            <translation>&lt;h3&gt;Nineline %1&lt;/h3&gt;&lt;p&gt;输入测得的机床误差，输出补偿后的数控程序。&lt;/p&gt;&lt;p&gt;每个轴的每项误差都是同一模型中的一个效应；输出的程序在交付之前会被重新读取并仿真。&lt;/p&gt;</translation>
        </message>
        <message>
            <source>Another window saved this project in the meantime.</source>
            <translation>另一个窗口在此期间保存了该项目。</translation>
        </message>
        <message>
            <source>Write over it</source>
            <translation>覆盖</translation>
        </message>
        <message>
            <source>Save under another name</source>
            <translation>另存为</translation>
        </message>
        <message>
            <source>Unsaved project</source>
            <translation>未保存的项目</translation>
        </message>
        <message>
            <source>Nineline ended before the last project was saved. Open it again?</source>
            <translation>Nineline 上次结束时项目尚未保存。是否重新打开？</translation>
        </message>
        <message>
            <source>Recover project</source>
            <translation>恢复项目</translation>
        </message>
    </context>
    <context>
        <name>nineline::widgets::NumberEdit</name>
        <message>
            <source>A number is missing here.</source>
            <translation>此处缺少数字。</translation>
        </message>
        <message>
            <source>'%1' is no number. Type digits, with a point or a comma.</source>
            <translation>“%1”不是数字。请输入数字，小数点或逗号均可。</translation>
        </message>
    </context>
    <context>
        <name>nineline::widgets::StepBar</name>
        <message>
            <source>Machine</source>
            <translation>机床</translation>
        </message>
        <message>
            <source>Measurements</source>
            <translation>测量</translation>
        </message>
        <message>
            <source>Program</source>
            <translation>程序</translation>
        </message>
        <message>
            <source>Compensate</source>
            <translation>补偿</translation>
        </message>
        <message>
            <source>Results</source>
            <translation>结果</translation>
        </message>
        <message>
            <source>Export</source>
            <translation>导出</translation>
        </message>
        <message>
            <source>missing</source>
            <translation>缺少</translation>
        </message>
        <message>
            <source>ready</source>
            <translation>就绪</translation>
        </message>
        <message>
            <source>stale</source>
            <translation>已过期</translation>
        </message>
        <message>
            <source>check</source>
            <translation>需检查</translation>
        </message>
        <message>
            <source>Model gap</source>
            <translation>模型差距</translation>
        </message>
    </context>
    <context>
        <name>options</name>
        <message>
            <source>Accuracy</source>
            <translation>精度</translation>
        </message>
        <message>
            <source>Tolerance along a block</source>
            <translation>程序段内公差</translation>
        </message>
        <message>
            <source>Tolerance of the tool axis</source>
            <translation>刀轴公差</translation>
        </message>
        <message>
            <source>Keep the number of blocks</source>
            <translation>保持程序段数不变</translation>
        </message>
        <message>
            <source>Correct rapid motions too</source>
            <translation>同时补偿快速移动</translation>
        </message>
        <message>
            <source>Correct</source>
            <translation>补偿对象</translation>
        </message>
        <message>
            <source>Tip and tool axis</source>
            <translation>刀尖与刀轴</translation>
        </message>
        <message>
            <source>The tool tip only</source>
            <translation>仅刀尖</translation>
        </message>
        <message>
            <source>Radius and lead of a thread (X and Z)</source>
            <translation>螺纹的半径与导程（X 和 Z）</translation>
        </message>
        <message>
            <source>Limits</source>
            <translation>限值</translation>
        </message>
        <message>
            <source>Largest correction</source>
            <translation>最大补偿量</translation>
        </message>
        <message>
            <source>Largest angular correction</source>
            <translation>最大角度补偿量</translation>
        </message>
        <message>
            <source>Decimals of the corrected words</source>
            <translation>补偿后数值的小数位</translation>
        </message>
        <message>
            <source>Linear axes</source>
            <translation>直线轴</translation>
        </message>
        <message>
            <source>as in the program</source>
            <translation>与原程序相同</translation>
        </message>
        <message>
            <source>Rotary axes</source>
            <translation>旋转轴</translation>
        </message>
        <message>
            <source>Control</source>
            <translation>数控系统</translation>
        </message>
        <message>
            <source>Recognise from the program</source>
            <translation>从程序识别</translation>
        </message>
        <message>
            <source>ISO / Fanuc</source>
            <translation>ISO / Fanuc</translation>
        </message>
        <message>
            <source>Siemens 840D</source>
            <translation>Siemens 840D</translation>
        </message>
        <message>
            <source>LinuxCNC</source>
            <translation>LinuxCNC</translation>
        </message>
        <message>
            <source>Skip blocks that begin with /</source>
            <translation>跳过以 / 开头的程序段</translation>
        </message>
    </context>
    <context>
        <name>quantities</name>
        <message>
            <source>%1 s</source>
            <translation>%1 秒</translation>
        </message>
        <message>
            <source>%1 min %2 s</source>
            <translation>%1 分 %2 秒</translation>
        </message>
        <message>
            <source>%1 h %2 min</source>
            <translation>%1 小时 %2 分</translation>
        </message>
    </context>
    <context>
        <name>thread</name>
        <message>
            <source>Thread</source>
            <translation>螺纹</translation>
        </message>
        <message>
            <source>Nominal diameter</source>
            <translation>公称直径</translation>
        </message>
        <message>
            <source>Pitch</source>
            <translation>螺距</translation>
        </message>
        <message>
            <source>Length</source>
            <translation>长度</translation>
        </message>
        <message>
            <source>Starts</source>
            <translation>线数</translation>
        </message>
        <message>
            <source>Hand</source>
            <translation>旋向</translation>
        </message>
        <message>
            <source>Right</source>
            <translation>右旋</translation>
        </message>
        <message>
            <source>Left</source>
            <translation>左旋</translation>
        </message>
        <message>
            <source>Kind</source>
            <translation>类型</translation>
        </message>
        <message>
            <source>External</source>
            <translation>外螺纹</translation>
        </message>
        <message>
            <source>Internal</source>
            <translation>内螺纹</translation>
        </message>
        <message>
            <source>Depth</source>
            <translation>牙深</translation>
        </message>
        <message>
            <source>ISO 68-1</source>
            <translation>ISO 68-1</translation>
        </message>
        <message>
            <source>Taper of the radius</source>
            <translation>半径锥度</translation>
        </message>
        <message>
            <source>Start, Z</source>
            <translation>起点 Z</translation>
        </message>
        <message>
            <source>Start angle</source>
            <translation>起始角</translation>
        </message>
        <message>
            <source>Passes</source>
            <translation>磨削行程</translation>
        </message>
        <message>
            <source>Infeed per pass</source>
            <translation>每次进给</translation>
        </message>
        <message>
            <source>Infeed along</source>
            <translation>进给方式</translation>
        </message>
        <message>
            <source>The radius</source>
            <translation>径向</translation>
        </message>
        <message>
            <source>One flank</source>
            <translation>单侧</translation>
        </message>
        <message>
            <source>Both flanks in turn</source>
            <translation>两侧交替</translation>
        </message>
        <message>
            <source>Finishing passes</source>
            <translation>精磨次数</translation>
        </message>
        <message>
            <source>Finishing infeed</source>
            <translation>精磨进给</translation>
        </message>
        <message>
            <source>Spark-out passes</source>
            <translation>光磨次数</translation>
        </message>
        <message>
            <source>Speed, first pass</source>
            <translation>首次转速</translation>
        </message>
        <message>
            <source>Speed, last pass</source>
            <translation>末次转速</translation>
        </message>
        <message>
            <source>Motion</source>
            <translation>运动</translation>
        </message>
        <message>
            <source>Cuts towards</source>
            <translation>磨削方向</translation>
        </message>
        <message>
            <source>+Z of the work</source>
            <translation>工件 +Z</translation>
        </message>
        <message>
            <source>−Z of the work</source>
            <translation>工件 −Z</translation>
        </message>
        <message>
            <source>Lead-in</source>
            <translation>导入</translation>
        </message>
        <message>
            <source>as needed</source>
            <translation>按需</translation>
        </message>
        <message>
            <source>Run-out</source>
            <translation>导出长度</translation>
        </message>
        <message>
            <source>Relief</source>
            <translation>退刀量</translation>
        </message>
        <message>
            <source>Return clearance</source>
            <translation>返回间隙</translation>
        </message>
        <message>
            <source>Safety distance</source>
            <translation>安全距离</translation>
        </message>
        <message>
            <source>Wheel</source>
            <translation>砂轮</translation>
        </message>
        <message>
            <source>Diameter</source>
            <translation>直径</translation>
        </message>
        <message>
            <source>Width</source>
            <translation>宽度</translation>
        </message>
        <message>
            <source>Ribs</source>
            <translation>齿数</translation>
        </message>
        <message>
            <source>Tilt</source>
            <translation>倾角</translation>
        </message>
        <message>
            <source>helix angle</source>
            <translation>螺旋升角</translation>
        </message>
        <message>
            <source>Dress every … passes</source>
            <translation>修整间隔（次）</translation>
        </message>
        <message>
            <source>Program</source>
            <translation>程序</translation>
        </message>
        <message>
            <source>C turn per block</source>
            <translation>每段 C 转角</translation>
        </message>
        <message>
            <source>Decimals</source>
            <translation>小数位</translation>
        </message>
        <message>
            <source>Program number</source>
            <translation>程序号</translation>
        </message>
    </context>
    <context>
        <name>nineline::models::FoundEffectsModel</name>
        <message>
            <source>%1 (of the measurement, not of the machine)</source>
            <translation>%1（属于测量，不属于机床）</translation>
        </message>
        <message>
            <source>Missing effect</source>
            <translation>缺少的效应</translation>
        </message>
        <message>
            <source>Axis and error</source>
            <translation>轴与误差</translation>
        </message>
        <message>
            <source>Size</source>
            <translation>大小</translation>
        </message>
        <message>
            <source>Confidence</source>
            <translation>置信度</translation>
        </message>
        <message>
            <source>Share of the gap</source>
            <translation>占差距</translation>
        </message>
    </context>
    <context>
        <name>Gap</name>
        <message>
            <source>%1 (%2 % of the gap)</source>
            <translation>%1（占差距的 %2 %）</translation>
        </message>
        <message>
            <source>Where</source>
            <translation>位置</translation>
        </message>
        <message>
            <source>%1, rows %2 to %3: %4</source>
            <translation>%1，第 %2 至 %3 行：%4</translation>
        </message>
        <message>
            <source>Look at the data</source>
            <translation>请检查数据</translation>
        </message>
        <message>
            <source>Looks alike on these data</source>
            <translation>在这些数据上看起来相同</translation>
        </message>
        <message>
            <source>Suspected, not added</source>
            <translation>有嫌疑，未加入</translation>
        </message>
        <message>
            <source>Nothing is missing: what differs lies within the present parameters.</source>
            <translation>没有缺少的效应：差异来自现有参数。</translation>
        </message>
        <message>
            <source>Nothing is missing: no gap beyond the repeatability.</source>
            <translation>没有缺少的效应：差距不超过重复精度。</translation>
        </message>
        <message>
            <source>Named effects explain the gap.</source>
            <translation>差距已由有名称的效应解释。</translation>
        </message>
        <message>
            <source>Part of the gap has a name; a structured rest remains.</source>
            <translation>部分差距已有名称；仍有规律性的剩余。</translation>
        </message>
        <message>
            <source>Something is missing, and no known effect explains it.</source>
            <translation>缺少某种效应，但没有已知效应能解释。</translation>
        </message>
        <message>
            <source>present model</source>
            <translation>现有模型</translation>
        </message>
        <message>
            <source>On runs not seen by the search: %1 → %2 µm, repeatability %3 µm</source>
            <translation>在搜索未见过的测量上：%1 → %2 µm，重复精度 %3 µm</translation>
        </message>
        <message>
            <source>&lt;b&gt;%1 %&lt;/b&gt; of the gap closed</source>
            <translation>差距已消除 &lt;b&gt;%1 %&lt;/b&gt;</translation>
        </message>
        <message>
            <source>Next measurement</source>
            <translation>下一步测量</translation>
        </message>
    </context>
    <context>
        <name>nineline::pages::GapChart</name>
        <message>
            <source>Save picture…</source>
            <translation>保存图片…</translation>
        </message>
        <message>
            <source>Reading − model:</source>
            <translation>读数 − 模型：</translation>
        </message>
        <message>
            <source>over</source>
            <translation>对</translation>
        </message>
        <message>
            <source>before</source>
            <translation>之前</translation>
        </message>
        <message>
            <source>after</source>
            <translation>之后</translation>
        </message>
    </context>
    <context>
        <name>nineline::pages::GapPage</name>
        <message>
            <source>Compare readings of the machine with the model: where they disagree, what is missing, and what is left once it is added.</source>
            <translation>将机床读数与模型比较：哪里不一致，缺少什么，加入后还剩多少。</translation>
        </message>
        <message>
            <source>Save picture</source>
            <translation>保存图片</translation>
        </message>
        <message>
            <source>Pictures (*.png)</source>
            <translation>图片 (*.png)</translation>
        </message>
        <message>
            <source>Readings</source>
            <translation>读数</translation>
        </message>
        <message>
            <source>Search for missing effects</source>
            <translation>搜索缺少的效应</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>取消</translation>
        </message>
        <message>
            <source>Add to model</source>
            <translation>加入模型</translation>
        </message>
        <message>
            <source>Model gap</source>
            <translation>模型差距</translation>
        </message>
        <message>
            <source>Searching…</source>
            <translation>正在搜索…</translation>
        </message>
        <message>
            <source>Cancelled. Nothing was changed.</source>
            <translation>已取消，没有任何更改。</translation>
        </message>
        <message>
            <source>Add found effects to the model</source>
            <translation>将找到的效应加入模型</translation>
        </message>
    </context>
    <context>
        <name>nineline::pages::ReadingsList</name>
        <message>
            <source>Add readings…</source>
            <translation>添加读数…</translation>
        </message>
        <message>
            <source>Remove</source>
            <translation>移除</translation>
        </message>
        <message>
            <source>Add readings</source>
            <translation>添加读数</translation>
        </message>
        <message>
            <source>Measurements (*.csv *.txt *.tsv);;All files (*)</source>
            <translation>测量文件 (*.csv *.txt *.tsv);;所有文件 (*)</translation>
        </message>
        <message>
            <source>Remove readings</source>
            <translation>移除读数</translation>
        </message>
    </context>
    <context>
        <name>nineline::models::ReadingsModel</name>
        <message>
            <source>tool deviation</source>
            <translation>刀具偏差</translation>
        </message>
        <message>
            <source>encoder on one axis</source>
            <translation>单轴编码器</translation>
        </message>
        <message>
            <source>laser, positioning</source>
            <translation>激光，定位</translation>
        </message>
        <message>
            <source>laser, straightness</source>
            <translation>激光，直线度</translation>
        </message>
        <message>
            <source>laser, angle</source>
            <translation>激光，角度</translation>
        </message>
        <message>
            <source>ballbar</source>
            <translation>球杆仪</translation>
        </message>
        <message>
            <source>lead tester</source>
            <translation>导程仪</translation>
        </message>
        <message>
            <source>dial gauge</source>
            <translation>千分表</translation>
        </message>
        <message>
            <source>cannot be used</source>
            <translation>不能使用</translation>
        </message>
        <message>
            <source>ready</source>
            <translation>就绪</translation>
        </message>
        <message>
            <source>notes: %1</source>
            <translation>提示：%1</translation>
        </message>
        <message>
            <source>File</source>
            <translation>文件</translation>
        </message>
        <message>
            <source>Instrument</source>
            <translation>仪器</translation>
        </message>
        <message>
            <source>Axis</source>
            <translation>轴</translation>
        </message>
        <message>
            <source>Runs</source>
            <translation>次数</translation>
        </message>
        <message>
            <source>Readings</source>
            <translation>读数</translation>
        </message>
        <message>
            <source>State</source>
            <translation>状态</translation>
        </message>
    </context>
    <context>
        <name>nineline::pages::ReadingsPanel</name>
        <message>
            <source>Readings</source>
            <translation>读数</translation>
        </message>
        <message>
            <source>over</source>
            <translation>对</translation>
        </message>
        <message>
            <source>The file was read without a doubt.</source>
            <translation>文件已读入，没有疑问。</translation>
        </message>
    </context>
    <context>
        <name>catalogue</name>
        <message>
            <source>Cause:</source>
            <translation>原因：</translation>
        </message>
        <message>
            <source>Usual size:</source>
            <translation>常见大小：</translation>
        </message>
        <message>
            <source>Remedy:</source>
            <translation>处理：</translation>
        </message>
    </context>
</TS>
