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
        <message>
            <source>Error table</source>
            <translation>误差表</translation>
        </message>
        <message>
            <source>Squareness, parallelism or offset of an axis</source>
            <translation>轴的垂直度、平行度或偏移</translation>
        </message>
        <message>
            <source>Scale error</source>
            <translation>比例误差</translation>
        </message>
        <message>
            <source>Periodic error of screw, worm, gear or rack</source>
            <translation>丝杠、蜗杆、齿轮或齿条的周期误差</translation>
        </message>
        <message>
            <source>Bow or S-shape of a guideway</source>
            <translation>导轨的弯曲或 S 形</translation>
        </message>
        <message>
            <source>Pitch, yaw or roll of a carriage</source>
            <translation>拖板的俯仰、偏摆或滚转</translation>
        </message>
        <message>
            <source>Periodic tilt of a carriage</source>
            <translation>拖板的周期性倾斜</translation>
        </message>
        <message>
            <source>Eccentricity of a rotary axis</source>
            <translation>回转轴的偏心</translation>
        </message>
        <message>
            <source>Two-, three- or more-lobed run-out</source>
            <translation>两棱、三棱或多棱跳动</translation>
        </message>
        <message>
            <source>Wobble of a rotary axis</source>
            <translation>回转轴的摆动</translation>
        </message>
        <message>
            <source>Axial run-out, camming</source>
            <translation>轴向窜动</translation>
        </message>
        <message>
            <source>Eccentric encoder disc</source>
            <translation>编码器盘偏心</translation>
        </message>
        <message>
            <source>Interpolation error of a scale or encoder</source>
            <translation>光栅尺或编码器的细分误差</translation>
        </message>
        <message>
            <source>Backlash</source>
            <translation>反向间隙</translation>
        </message>
        <message>
            <source>Sideways play of a carriage</source>
            <translation>拖板的侧向间隙</translation>
        </message>
        <message>
            <source>Tilting play of a carriage</source>
            <translation>拖板的倾斜间隙</translation>
        </message>
        <message>
            <source>Wind-up: play that grows along the travel</source>
            <translation>扭卷：沿行程增大的间隙</translation>
        </message>
        <message>
            <source>Lost motion that grows with the load</source>
            <translation>随负载增大的失动量</translation>
        </message>
        <message>
            <source>Hysteresis with a long transition</source>
            <translation>过渡距离长的滞后</translation>
        </message>
        <message>
            <source>Reversal spike, quadrant glitch</source>
            <translation>反向尖峰、象限突起</translation>
        </message>
        <message>
            <source>Friction that falls with the speed</source>
            <translation>随速度下降的摩擦</translation>
        </message>
        <message>
            <source>Servo lag, mismatched gains</source>
            <translation>伺服滞后、增益不匹配</translation>
        </message>
        <message>
            <source>Yielding under acceleration, contraction of circles</source>
            <translation>加速度引起的退让、圆的收缩</translation>
        </message>
        <message>
            <source>Rotary axis late against the linear ones</source>
            <translation>回转轴相对直线轴滞后</translation>
        </message>
        <message>
            <source>Vibration</source>
            <translation>振动</translation>
        </message>
        <message>
            <source>Growth of the ball screw</source>
            <translation>滚珠丝杠的热伸长</translation>
        </message>
        <message>
            <source>Growth of the linear scale</source>
            <translation>直线光栅尺的热伸长</translation>
        </message>
        <message>
            <source>Growth of headstock, spindle or wheel head</source>
            <translation>主轴箱、主轴或砂轮架的热伸长</translation>
        </message>
        <message>
            <source>Drift with the room&apos;s temperature</source>
            <translation>随室温的漂移</translation>
        </message>
        <message>
            <source>Coolant on or off</source>
            <translation>冷却液开或关</translation>
        </message>
        <message>
            <source>Tilt of column or bed by a temperature difference</source>
            <translation>由温差引起的立柱或床身倾斜</translation>
        </message>
        <message>
            <source>Growth of the workpiece in process</source>
            <translation>工件在加工中的热伸长</translation>
        </message>
        <message>
            <source>Steady drift of unknown cause</source>
            <translation>原因不明的稳定漂移</translation>
        </message>
        <message>
            <source>Sag of a ram or slide</source>
            <translation>滑枕或滑板的下垂</translation>
        </message>
        <message>
            <source>Sinking under the load</source>
            <translation>负载下的下沉</translation>
        </message>
        <message>
            <source>Tilting under the load</source>
            <translation>负载下的倾斜</translation>
        </message>
        <message>
            <source>Counterweight of a vertical axis</source>
            <translation>垂直轴的配重</translation>
        </message>
        <message>
            <source>Wear of the wheel</source>
            <translation>砂轮磨损</translation>
        </message>
        <message>
            <source>Wheel and work give way</source>
            <translation>砂轮与工件的退让</translation>
        </message>
        <message>
            <source>Remainder after sparking out</source>
            <translation>光磨后的残余</translation>
        </message>
        <message>
            <source>Bending of the work between centres</source>
            <translation>顶尖间工件的弯曲</translation>
        </message>
        <message>
            <source>Distortion by a three-jaw chuck</source>
            <translation>三爪卡盘引起的变形</translation>
        </message>
        <message>
            <source>Laser beam not parallel to the axis</source>
            <translation>激光束与轴不平行</translation>
        </message>
        <message>
            <source>Dead path of the laser</source>
            <translation>激光的死程</translation>
        </message>
        <message>
            <source>Wrong material temperature or expansion in the laser</source>
            <translation>激光仪中材料温度或膨胀系数错误</translation>
        </message>
        <message>
            <source>Wavelength in air not corrected</source>
            <translation>空气中波长未修正</translation>
        </message>
        <message>
            <source>Lobing of a touch probe</source>
            <translation>触发测头的三棱误差</translation>
        </message>
        <message>
            <source>Stylus radius or approach offset</source>
            <translation>测针半径或接近偏移</translation>
        </message>
        <message>
            <source>Datum shifted during the measurement</source>
            <translation>测量中基准移动</translation>
        </message>
        <message>
            <source>Clock of the instrument off</source>
            <translation>仪器时钟偏差</translation>
        </message>
        <message>
            <source>Measuring point declared at the wrong place</source>
            <translation>测量点位置填写错误</translation>
        </message>
        <message>
            <source>Structure without a name</source>
            <translation>没有名称的规律</translation>
        </message>
        <message>
            <source>Everything that was measured of an axis at given positions.</source>
            <translation>在给定位置上测得的一个轴的全部误差。</translation>
        </message>
        <message>
            <source>Whatever was found.</source>
            <translation>所测得的大小。</translation>
        </message>
        <message>
            <source>Nothing to repair: the table is compensated. Measure anew after a repair or a crash.</source>
            <translation>无需修理：误差表由补偿消除。修理或碰撞之后请重新测量。</translation>
        </message>
        <message>
            <source>Guideways or an axis of rotation were not set square or in line, or the bed has moved on its feet.</source>
            <translation>导轨或回转轴没有调到垂直或对齐，或床身在地脚上移动。</translation>
        </message>
        <message>
            <source>2 to 40 arcsec, on new precision machines below 4; offsets up to 0.1 mm.</source>
            <translation>2 至 40 角秒，新的精密机床低于 4；偏移可达 0.1 mm。</translation>
        </message>
        <message>
            <source>Level the bed first; then align column or head by its set screws or by scraping. What remains is compensated.</source>
            <translation>先调平床身，再用调整螺钉或刮研校正立柱或主轴箱。剩余部分由补偿消除。</translation>
        </message>
        <message>
            <source>The lead of the screw or the division of the scale differs from the nominal one, or the control holds a wrong factor.</source>
            <translation>丝杠导程或光栅尺刻度与标称值不同，或控制系统中的系数错误。</translation>
        </message>
        <message>
            <source>5 to 50 um/m.</source>
            <translation>5 至 50 µm/m。</translation>
        </message>
        <message>
            <source>Correct the factor or the pitch table of the control; otherwise compensate.</source>
            <translation>修正控制系统的系数或螺距表；否则进行补偿。</translation>
        </message>
        <message>
            <source>The screw runs out in its bearings or was cut with a periodic lead error; a worm, gear or coupling runs out.</source>
            <translation>丝杠在轴承中跳动，或加工时带有周期性导程误差；蜗杆、齿轮或联轴器跳动。</translation>
        </message>
        <message>
            <source>0.5 to 10 um, once or twice a turn of the screw.</source>
            <translation>0.5 至 10 µm，丝杠每转一次或两次。</translation>
        </message>
        <message>
            <source>Check bearing seat, nut alignment and coupling for run-out; replace a worn screw. What remains is compensated.</source>
            <translation>检查轴承座、螺母对中和联轴器的跳动；更换磨损的丝杠。剩余部分由补偿消除。</translation>
        </message>
        <message>
            <source>The guideway was ground or has settled with a bow; the bed is not level or was clamped under stress.</source>
            <translation>导轨磨成或沉降成弯曲；床身未调平或在应力下夹紧。</translation>
        </message>
        <message>
            <source>1 to 20 um over the travel.</source>
            <translation>全行程 1 至 20 µm。</translation>
        </message>
        <message>
            <source>Level the bed and loosen foundation bolts that pull; then scrape or shim the rail. What remains is compensated.</source>
            <translation>调平床身，松开拉紧的地脚螺栓；然后刮研或垫平导轨。剩余部分由补偿消除。</translation>
        </message>
        <message>
            <source>A bowed or twisted guideway tilts the carriage as it travels; through its arm the tilt becomes an error at the tool.</source>
            <translation>弯曲或扭曲的导轨使拖板在行进中倾斜；倾斜通过力臂成为刀具处的误差。</translation>
        </message>
        <message>
            <source>1 to 15 arcsec.</source>
            <translation>1 至 15 角秒。</translation>
        </message>
        <message>
            <source>Level the bed, check gib and shoe clearance; shorten the arm between scale and work. What remains is compensated.</source>
            <translation>调平床身，检查镶条和滑块间隙；缩短光栅尺与工件之间的力臂。剩余部分由补偿消除。</translation>
        </message>
        <message>
            <source>Balls or rollers entering a guideway shoe, or a bent screw that pushes the carriage sideways once a turn.</source>
            <translation>滚珠或滚柱进入导轨滑块，或弯曲的丝杠每转把拖板推向一侧。</translation>
        </message>
        <message>
            <source>0.2 to 3 arcsec.</source>
            <translation>0.2 至 3 角秒。</translation>
        </message>
        <message>
            <source>Check the screw for run-out and the nut&apos;s mounting; renew guideway shoes.</source>
            <translation>检查丝杠跳动和螺母安装；更换导轨滑块。</translation>
        </message>
        <message>
            <source>The spindle&apos;s nose, a centre or the chuck sits beside the axis of rotation; a bearing ring was mounted off centre.</source>
            <translation>主轴端、顶尖或卡盘偏离回转轴线；轴承圈安装偏心。</translation>
        </message>
        <message>
            <source>1 to 20 um; good spindles below 1.</source>
            <translation>1 至 20 µm；好的主轴低于 1。</translation>
        </message>
        <message>
            <source>Clean and indicate the nose, turn the chuck by half a turn and compare; regrind the centre in place.</source>
            <translation>清洁并打表主轴端，将卡盘转半圈比较；就地修磨顶尖。</translation>
        </message>
        <message>
            <source>A bearing seat or ring is out of round, or the ring is pinched by its screws.</source>
            <translation>轴承座或轴承圈不圆，或被螺钉压变形。</translation>
        </message>
        <message>
            <source>0.1 to 3 um.</source>
            <translation>0.1 至 3 µm。</translation>
        </message>
        <message>
            <source>Loosen and retighten the bearing&apos;s clamping crosswise; check the seat&apos;s roundness.</source>
            <translation>松开轴承压盖并对角拧紧；检查轴承座圆度。</translation>
        </message>
        <message>
            <source>The body is mounted askew on the spindle, or the bearings&apos; shoulders are not square to the axis: the tilt turns with the work.</source>
            <translation>工件在主轴上装歪，或轴承台肩与轴线不垂直：倾斜随工件转动。</translation>
        </message>
        <message>
            <source>0.5 to 10 arcsec.</source>
            <translation>0.5 至 10 角秒。</translation>
        </message>
        <message>
            <source>Clean the faces, look for chips; regrind the face plate on the machine.</source>
            <translation>清洁端面，查找切屑；在机床上修磨花盘端面。</translation>
        </message>
        <message>
            <source>The thrust bearing&apos;s face is not square to the axis: the spindle moves to and fro once a turn and the thread is drunken.</source>
            <translation>推力轴承端面与轴线不垂直：主轴每转来回移动一次，螺纹出现周期性歪斜。</translation>
        </message>
        <message>
            <source>0.2 to 3 um.</source>
            <translation>0.2 至 3 µm。</translation>
        </message>
        <message>
            <source>Check shoulder and spacer rings for parallelism; renew the thrust bearing.</source>
            <translation>检查台肩和隔圈的平行度；更换推力轴承。</translation>
        </message>
        <message>
            <source>The encoder&apos;s disc sits beside the axis: it reads the angle once a turn too far and once too short.</source>
            <translation>编码器盘偏离轴线：每转一次读数偏大，一次偏小。</translation>
        </message>
        <message>
            <source>1 to 20 arcsec; 1 um of eccentricity at 50 mm radius is 4 arcsec.</source>
            <translation>1 至 20 角秒；半径 50 mm 上偏心 1 µm 等于 4 角秒。</translation>
        </message>
        <message>
            <source>Centre the disc, or fit a second reading head opposite the first.</source>
            <translation>对中编码器盘，或在对面加装第二个读数头。</translation>
        </message>
        <message>
            <source>Signals of the reading head are unequal or not square to each other, mostly by dirt or a wrong gap.</source>
            <translation>读数头信号不等或不正交，多因污垢或间隙不当。</translation>
        </message>
        <message>
            <source>0.05 to 0.5 um; 0.1 to 2 arcsec.</source>
            <translation>0.05 至 0.5 µm；0.1 至 2 角秒。</translation>
        </message>
        <message>
            <source>Clean scale and head, set the gap, adjust signals with the maker&apos;s instrument.</source>
            <translation>清洁光栅尺和读数头，调好间隙，用厂家仪器调整信号。</translation>
        </message>
        <message>
            <source>Play in the nut, the coupling, the thrust bearing or the worm.</source>
            <translation>螺母、联轴器、推力轴承或蜗杆有间隙。</translation>
        </message>
        <message>
            <source>1 to 10 um on a ball screw, up to 50 on a worn one; 2 to 60 arcsec on a worm.</source>
            <translation>滚珠丝杠 1 至 10 µm，磨损后可达 50；蜗杆 2 至 60 角秒。</translation>
        </message>
        <message>
            <source>Check the axial play of the thrust bearing and the preload of the nut; set the worm closer. What remains goes into the control&apos;s backlash value or is compensated.</source>
            <translation>检查推力轴承的轴向间隙和螺母预紧；调紧蜗杆。剩余部分输入控制系统的间隙值或由补偿消除。</translation>
        </message>
        <message>
            <source>The carriage changes sides in its guideway at each reversal: gib too loose, drive beside the centre.</source>
            <translation>拖板每次反向在导轨中换边：镶条过松，驱动偏离中心。</translation>
        </message>
        <message>
            <source>0.5 to 5 um.</source>
            <translation>0.5 至 5 µm。</translation>
        </message>
        <message>
            <source>Set the gib or the shoes&apos; preload; check that the screw is parallel to the guideway.</source>
            <translation>调整镶条或滑块预紧；检查丝杠与导轨的平行度。</translation>
        </message>
        <message>
            <source>The drive pulls beside the carriage&apos;s centre and tips it to the other side at each reversal.</source>
            <translation>驱动偏离拖板中心，每次反向使其向另一侧倾斜。</translation>
        </message>
        <message>
            <source>0.2 to 5 arcsec.</source>
            <translation>0.2 至 5 角秒。</translation>
        </message>
        <message>
            <source>Set the gib or renew the shoes; check lubrication.</source>
            <translation>调整镶条或更换滑块；检查润滑。</translation>
        </message>
        <message>
            <source>The screw twists under friction; the free length between motor and nut grows.</source>
            <translation>丝杠在摩擦下扭转；电机与螺母之间的自由长度增大。</translation>
        </message>
        <message>
            <source>1 to 20 um over a metre.</source>
            <translation>每米 1 至 20 µm。</translation>
        </message>
        <message>
            <source>Reduce friction (gib, wipers, lubrication); a thicker screw or a linear scale helps for good.</source>
            <translation>减小摩擦（镶条、刮屑板、润滑）；更粗的丝杠或光栅尺可根治。</translation>
        </message>
        <message>
            <source>Friction grows with the load and stretches the drive before the table moves.</source>
            <translation>摩擦随负载增大，工作台移动前先拉伸传动链。</translation>
        </message>
        <message>
            <source>0.005 to 0.05 um/kg.</source>
            <translation>0.005 至 0.05 µm/kg。</translation>
        </message>
        <message>
            <source>Lubricate, check the guideways; stiffen the thrust bearing.</source>
            <translation>润滑，检查导轨；加强推力轴承。</translation>
        </message>
        <message>
            <source>Friction holds the carriage while drive, seals and cables stretch; the play is taken up over millimetres.</source>
            <translation>摩擦拖住拖板，传动、密封和电缆被拉伸；间隙要经过数毫米才消除。</translation>
        </message>
        <message>
            <source>1 to 20 um, over 0.1 to 50 mm.</source>
            <translation>1 至 20 µm，距离 0.1 至 50 mm。</translation>
        </message>
        <message>
            <source>Look for a stiff wiper, hose or cable chain, a dry guideway, a soft coupling.</source>
            <translation>检查过紧的刮屑板、软管或拖链、干燥的导轨、过软的联轴器。</translation>
        </message>
        <message>
            <source>Static friction at standstill: the axis hangs until the controller has built up force.</source>
            <translation>静止时的静摩擦：轴停住，直到控制器建立足够的力。</translation>
        </message>
        <message>
            <source>1 to 15 um on circles at the quadrants.</source>
            <translation>圆的象限处 1 至 15 µm。</translation>
        </message>
        <message>
            <source>Switch on or tune the control&apos;s friction compensation; oil the guideway.</source>
            <translation>打开或调整控制系统的摩擦补偿；给导轨加油。</translation>
        </message>
        <message>
            <source>Oil film on a sliding guideway: sticky when slow, floating when fast.</source>
            <translation>滑动导轨的油膜：慢时粘滞，快时浮起。</translation>
        </message>
        <message>
            <source>1 to 10 um below 5 mm/s.</source>
            <translation>5 mm/s 以下 1 至 10 µm。</translation>
        </message>
        <message>
            <source>Use slideway oil of the right grade; raise the controller&apos;s integral gain; avoid creeping feeds.</source>
            <translation>使用合适牌号的导轨油；提高控制器积分增益；避免爬行进给。</translation>
        </message>
        <message>
            <source>One axis follows its command later than the others.</source>
            <translation>一个轴比其他轴更晚跟随指令。</translation>
        </message>
        <message>
            <source>0.05 to 1 ms of difference: 1 to 15 um at 1 m/min.</source>
            <translation>相差 0.05 至 1 ms：在 1 m/min 时为 1 至 15 µm。</translation>
        </message>
        <message>
            <source>Set equal position gains and feed-forward on all axes of the path.</source>
            <translation>将轨迹各轴的位置增益和前馈调成一致。</translation>
        </message>
        <message>
            <source>The drive yields under inertia, or the control&apos;s smoothing cuts corners and shrinks circles.</source>
            <translation>传动在惯性下退让，或控制系统的平滑功能切角并缩小圆。</translation>
        </message>
        <message>
            <source>1 to 100 um at 1 m/s2.</source>
            <translation>1 m/s² 时 1 至 100 µm。</translation>
        </message>
        <message>
            <source>Lower jerk and acceleration for finishing, tune acceleration feed-forward.</source>
            <translation>精加工时降低加加速度和加速度，调整加速度前馈。</translation>
        </message>
        <message>
            <source>Work spindle and slide are coupled with a delay: the thread starts late by an angle that grows with the speed.</source>
            <translation>工件主轴与滑板的联动有延迟：螺纹起点的角度误差随转速增大。</translation>
        </message>
        <message>
            <source>0.1 to 3 ms.</source>
            <translation>0.1 至 3 ms。</translation>
        </message>
        <message>
            <source>Set the coupling&apos;s dead time or the gains alike; cut at one speed throughout.</source>
            <translation>将联动的死区时间或增益调成一致；全程以同一转速切削。</translation>
        </message>
        <message>
            <source>An unbalanced wheel, a pump, a hydraulic unit or the floor.</source>
            <translation>砂轮不平衡、泵、液压站或地面。</translation>
        </message>
        <message>
            <source>0.1 to 5 um.</source>
            <translation>0.1 至 5 µm。</translation>
        </message>
        <message>
            <source>Balance the wheel; find the source by switching units off one by one. Vibration is not compensated by a program.</source>
            <translation>平衡砂轮；逐个关闭设备查找来源。振动不能由程序补偿。</translation>
        </message>
        <message>
            <source>The screw warms by friction in nut and bearings and grows away from its fixed bearing.</source>
            <translation>丝杠因螺母和轴承摩擦发热，从固定轴承端伸长。</translation>
        </message>
        <message>
            <source>9 to 12 um per metre and degree: 5 to 30 um in the first hour of work.</source>
            <translation>每米每度 9 至 12 µm：开机第一小时 5 至 30 µm。</translation>
        </message>
        <message>
            <source>Warm the axis up before work, cool or stretch the screw, fit a linear scale; or compensate by a sensor near the nut.</source>
            <translation>加工前预热该轴，冷却或预拉伸丝杠，安装光栅尺；或用螺母附近的传感器补偿。</translation>
        </message>
        <message>
            <source>Glass or steel scales grow with their temperature, less than cast iron.</source>
            <translation>玻璃或钢制光栅尺随自身温度伸长，比铸铁小。</translation>
        </message>
        <message>
            <source>8 um/m/C glass, 11 steel, 0 to 1 glass ceramics.</source>
            <translation>玻璃 8 µm/m/°C，钢 11，微晶玻璃 0 至 1。</translation>
        </message>
        <message>
            <source>Keep coolant mist and chips off the scale; enter its expansion in the control.</source>
            <translation>避免冷却液雾和切屑进入光栅尺；在控制系统中输入其膨胀系数。</translation>
        </message>
        <message>
            <source>Bearing losses warm the head; centre height and position move over an hour.</source>
            <translation>轴承损耗使主轴箱发热；中心高和位置在一小时内移动。</translation>
        </message>
        <message>
            <source>5 to 50 um from cold to warm.</source>
            <translation>从冷到热 5 至 50 µm。</translation>
        </message>
        <message>
            <source>Warm up, keep the spindle turning in breaks, control the coolant&apos;s temperature; or compensate by a sensor in the head.</source>
            <translation>预热，休息时让主轴保持转动，控制冷却液温度；或用主轴箱中的传感器补偿。</translation>
        </message>
        <message>
            <source>Bed and column follow the hall with a delay of one to several hours.</source>
            <translation>床身和立柱跟随车间温度，滞后一至数小时。</translation>
        </message>
        <message>
            <source>1 to 5 um per degree.</source>
            <translation>每度 1 至 5 µm。</translation>
        </message>
        <message>
            <source>Close doors, no sun or heater on the machine; measure and finish at the same hour.</source>
            <translation>关好门，避免阳光或暖气照射机床；在同一时段测量和精加工。</translation>
        </message>
        <message>
            <source>Coolant cools (or warms) bed and work once it flows.</source>
            <translation>冷却液流动后使床身和工件变冷（或变热）。</translation>
        </message>
        <message>
            <source>2 to 20 um within minutes.</source>
            <translation>数分钟内 2 至 20 µm。</translation>
        </message>
        <message>
            <source>Let the coolant run 20 minutes before finishing; control its temperature.</source>
            <translation>精加工前让冷却液流动 20 分钟；控制其温度。</translation>
        </message>
        <message>
            <source>One side of the column is warmer than the other (motor, hydraulics, sun), so it bends away.</source>
            <translation>立柱一侧比另一侧热（电机、液压、阳光），因此向外弯曲。</translation>
        </message>
        <message>
            <source>0.5 to 3 arcsec per degree.</source>
            <translation>每度 0.5 至 3 角秒。</translation>
        </message>
        <message>
            <source>Remove or shield the source, let air through; measure both sides and compensate.</source>
            <translation>移走或遮挡热源，让空气流通；测量两侧温度并补偿。</translation>
        </message>
        <message>
            <source>The part is ground warm and shrinks when it cools: a long thread comes out short.</source>
            <translation>工件磨削时是热的，冷却后收缩：长螺纹会变短。</translation>
        </message>
        <message>
            <source>11.5 um per metre and degree of steel.</source>
            <translation>钢每米每度 11.5 µm。</translation>
        </message>
        <message>
            <source>More coolant, smaller infeed; let the part cool before the last pass.</source>
            <translation>加大冷却液，减小进给；最后一遍之前让工件冷却。</translation>
        </message>
        <message>
            <source>Something warms, settles or creeps, and no sensor shows it.</source>
            <translation>某处在发热、沉降或蠕变，而没有传感器能显示。</translation>
        </message>
        <message>
            <source>1 to 10 um/h.</source>
            <translation>1 至 10 µm/h。</translation>
        </message>
        <message>
            <source>Fit a sensor where the heat may come from and measure again; probe a datum regularly.</source>
            <translation>在可能发热处安装传感器并重新测量；定期探测基准。</translation>
        </message>
        <message>
            <source>A ram, quill or cross slide bends under its weight the further it reaches out.</source>
            <translation>滑枕、套筒或横滑板伸出越远，自重下垂越大。</translation>
        </message>
        <message>
            <source>5 to 50 um at full reach.</source>
            <translation>全伸出时 5 至 50 µm。</translation>
        </message>
        <message>
            <source>Work with less overhang; set the counterweight or hydraulic support; compensate.</source>
            <translation>减小悬伸；调整配重或液压支撑；进行补偿。</translation>
        </message>
        <message>
            <source>Bed, guideway and feet give way under part and fixture.</source>
            <translation>床身、导轨和地脚在工件和夹具重量下退让。</translation>
        </message>
        <message>
            <source>0.01 to 0.1 um/kg.</source>
            <translation>0.01 至 0.1 µm/kg。</translation>
        </message>
        <message>
            <source>Set up feet and foundation; state the load and compensate.</source>
            <translation>调整地脚和地基；输入负载并补偿。</translation>
        </message>
        <message>
            <source>The part stands beside the table&apos;s centre and tips it.</source>
            <translation>工件偏离工作台中心，使其倾斜。</translation>
        </message>
        <message>
            <source>0.002 to 0.05 arcsec/kg.</source>
            <translation>0.002 至 0.05 角秒/kg。</translation>
        </message>
        <message>
            <source>Set the part over the guideways; state the load and compensate.</source>
            <translation>将工件放在导轨上方；输入负载并补偿。</translation>
        </message>
        <message>
            <source>Chain, cylinder or accumulator of the weight compensation pulls unevenly up and down.</source>
            <translation>重量平衡的链条、油缸或蓄能器上下拉力不等。</translation>
        </message>
        <message>
            <source>1 to 15 um.</source>
            <translation>1 至 15 µm。</translation>
        </message>
        <message>
            <source>Check pressure and valves of the cylinder, chain and pulleys.</source>
            <translation>检查油缸压力和阀、链条和链轮。</translation>
        </message>
        <message>
            <source>The wheel loses grain and becomes smaller from pass to pass until it is dressed.</source>
            <translation>砂轮逐遍脱粒变小，直到修整。</translation>
        </message>
        <message>
            <source>0.1 to 2 um a pass.</source>
            <translation>每遍 0.1 至 2 µm。</translation>
        </message>
        <message>
            <source>Dress more often, harder wheel; compensate by the pass number.</source>
            <translation>更频繁地修整，用更硬的砂轮；按遍数补偿。</translation>
        </message>
        <message>
            <source>The grinding force pushes wheel spindle and work apart.</source>
            <translation>磨削力把砂轮主轴和工件推开。</translation>
        </message>
        <message>
            <source>1 to 20 um.</source>
            <translation>1 至 20 µm。</translation>
        </message>
        <message>
            <source>Smaller infeed, spark out, support the work by a steady rest.</source>
            <translation>减小进给，光磨，用中心架支撑工件。</translation>
        </message>
        <message>
            <source>The spring of wheel and work has not yet relaxed when grinding ends.</source>
            <translation>磨削结束时砂轮与工件的弹性尚未松弛。</translation>
        </message>
        <message>
            <source>More passes without infeed.</source>
            <translation>增加无进给的光磨遍数。</translation>
        </message>
        <message>
            <source>A slender part bends between the centres under force or weight: thick in the middle.</source>
            <translation>细长工件在顶尖之间受力或自重弯曲：中间偏粗。</translation>
        </message>
        <message>
            <source>1 to 30 um.</source>
            <translation>1 至 30 µm。</translation>
        </message>
        <message>
            <source>Steady rest in the middle, smaller infeed, spark out.</source>
            <translation>中间用中心架，减小进给，光磨。</translation>
        </message>
        <message>
            <source>Three jaws press a thin part out of round; less so away from the chuck.</source>
            <translation>三爪把薄工件压得不圆；离卡盘越远越小。</translation>
        </message>
        <message>
            <source>0.5 to 10 um.</source>
            <translation>0.5 至 10 µm。</translation>
        </message>
        <message>
            <source>Clamp more gently, use a collet or soft jaws, grind between centres.</source>
            <translation>减小夹紧力，使用弹簧夹头或软爪，在顶尖间磨削。</translation>
        </message>
        <message>
            <source>The beam runs at an angle to the travel, so the laser reads short.</source>
            <translation>激光束与行程成角度，因此激光读数偏短。</translation>
        </message>
        <message>
            <source>1 mm off over 1 m: 0.5 um/m.</source>
            <translation>1 m 上偏 1 mm：0.5 µm/m。</translation>
        </message>
        <message>
            <source>Align by the drift of the spot; no fault of the machine.</source>
            <translation>按光斑漂移对准；不是机床的故障。</translation>
        </message>
        <message>
            <source>Air between interferometer and zero position is not corrected when it warms.</source>
            <translation>干涉仪与零位之间的空气变热时未被修正。</translation>
        </message>
        <message>
            <source>1 um per metre and degree.</source>
            <translation>每米每度 1 µm。</translation>
        </message>
        <message>
            <source>Set the interferometer close to the zero position.</source>
            <translation>将干涉仪靠近零位放置。</translation>
        </message>
        <message>
            <source>The laser&apos;s material sensor fell off, hangs in the air, or the expansion was typed wrong.</source>
            <translation>激光仪的材料传感器脱落、悬在空气中，或膨胀系数输入错误。</translation>
        </message>
        <message>
            <source>up to 12 um per metre and degree.</source>
            <translation>每米每度可达 12 µm。</translation>
        </message>
        <message>
            <source>Put the sensor on the scale or screw; check the coefficient.</source>
            <translation>将传感器放在光栅尺或丝杠上；检查系数。</translation>
        </message>
        <message>
            <source>The laser&apos;s weather station is off or its sensors are wrong.</source>
            <translation>激光仪的气象站关闭或其传感器错误。</translation>
        </message>
        <message>
            <source>1 um/m per degree or per 3.7 hPa.</source>
            <translation>每度或每 3.7 hPa 为 1 µm/m。</translation>
        </message>
        <message>
            <source>Switch it on; enter the pressure by hand.</source>
            <translation>打开气象站；手动输入气压。</translation>
        </message>
        <message>
            <source>A probe on three contacts triggers sooner in three directions.</source>
            <translation>三触点测头在三个方向上更早触发。</translation>
        </message>
        <message>
            <source>Calibrate by direction, shorter stylus, strain-gauge probe.</source>
            <translation>按方向标定，用更短的测针、应变式测头。</translation>
        </message>
        <message>
            <source>The effective radius of the stylus is set wrong.</source>
            <translation>测针有效半径设置错误。</translation>
        </message>
        <message>
            <source>Calibrate the probe on a ring or sphere.</source>
            <translation>在环规或球上标定测头。</translation>
        </message>
        <message>
            <source>Gauge, reflector or part was touched or slipped.</source>
            <translation>量具、反射镜或工件被碰动或滑移。</translation>
        </message>
        <message>
            <source>1 to 50 um.</source>
            <translation>1 至 50 µm。</translation>
        </message>
        <message>
            <source>Fasten it and repeat the run.</source>
            <translation>固定好并重复该次测量。</translation>
        </message>
        <message>
            <source>Instrument and control do not share a clock.</source>
            <translation>仪器与控制系统没有共同的时钟。</translation>
        </message>
        <message>
            <source>0.01 to 2 s.</source>
            <translation>0.01 至 2 s。</translation>
        </message>
        <message>
            <source>Trigger by the control; or read at standstill.</source>
            <translation>由控制系统触发；或静止时读数。</translation>
        </message>
        <message>
            <source>The distance from guideway to reflector was entered wrong.</source>
            <translation>从导轨到反射镜的距离填写错误。</translation>
        </message>
        <message>
            <source>5 to 100 mm.</source>
            <translation>5 至 100 mm。</translation>
        </message>
        <message>
            <source>Measure where the beam meets the carriage and correct the file&apos;s head.</source>
            <translation>测量光束与拖板相交的位置，并更正文件头。</translation>
        </message>
        <message>
            <source>Something repeatable depends on these quantities, and no known cause explains it.</source>
            <translation>某种可重复的现象取决于这些量，而没有已知原因能解释。</translation>
        </message>
        <message>
            <source>As found.</source>
            <translation>如所发现。</translation>
        </message>
        <message>
            <source>Look where and when it appears; the correction helps within the measured range only.</source>
            <translation>查看它在何处何时出现；校正只在测量范围内有效。</translation>
        </message>
        <message>
            <source>run the circle at two feeds and in both senses: squareness follows neither</source>
            <translation>以两种进给、两个方向走圆：垂直度与两者都无关</translation>
        </message>
        <message>
            <source>measure at two distances from the guideway</source>
            <translation>在离导轨两个距离处测量</translation>
        </message>
        <message>
            <source>a second instrument on the axis, or the laser aligned anew; cosine only shortens</source>
            <translation>在该轴上用第二台仪器，或重新对准激光；余弦误差只会变短</translation>
        </message>
        <message>
            <source>a second instrument on the axis</source>
            <translation>在该轴上用第二台仪器</translation>
        </message>
        <message>
            <source>needs a run at another screw temperature, 3 C apart or more</source>
            <translation>需要在另一丝杠温度下测一次，相差 3 °C 以上</translation>
        </message>
        <message>
            <source>the period: a grating&apos;s is a fraction of a millimetre, a screw&apos;s its lead</source>
            <translation>看周期：光栅为几分之一毫米，丝杠为其导程</translation>
        </message>
        <message>
            <source>another lead, or the start of the thread shifted along Z</source>
            <translation>另一导程，或沿 Z 移动螺纹起点</translation>
        </message>
        <message>
            <source>measure at two distances from the guideway; the two have one cause</source>
            <translation>在离导轨两个距离处测量；两者同一原因</translation>
        </message>
        <message>
            <source>change the mass that is carried</source>
            <translation>改变所承载的质量</translation>
        </message>
        <message>
            <source>two arms</source>
            <translation>两个力臂</translation>
        </message>
        <message>
            <source>two heights above the guideway, both directions</source>
            <translation>导轨上方两个高度，两个方向</translation>
        </message>
        <message>
            <source>approach from both directions</source>
            <translation>从两个方向接近</translation>
        </message>
        <message>
            <source>measure at two distances, 1 : 3 or more</source>
            <translation>在两个距离测量，比例 1 : 3 以上</translation>
        </message>
        <message>
            <source>a face measurement, or two leads: the encoder scales with the lead</source>
            <translation>端面测量，或两种导程：编码器误差随导程成比例</translation>
        </message>
        <message>
            <source>turn the probe by 60 degrees</source>
            <translation>将测头转 60 度</translation>
        </message>
        <message>
            <source>turn the part in the chuck by 60 degrees, or measure at two distances</source>
            <translation>将工件在卡盘中转 60 度，或在两个距离测量</translation>
        </message>
        <message>
            <source>two leads, or a measurement on the face: there is no lead on a face</source>
            <translation>两种导程，或在端面上测量：端面上没有导程</translation>
        </message>
        <message>
            <source>another lead, or the start shifted along Z</source>
            <translation>另一导程，或沿 Z 移动起点</translation>
        </message>
        <message>
            <source>two leads, or a face measurement</source>
            <translation>两种导程，或端面测量</translation>
        </message>
        <message>
            <source>the worm&apos;s period</source>
            <translation>蜗杆的周期</translation>
        </message>
        <message>
            <source>the period</source>
            <translation>看周期</translation>
        </message>
        <message>
            <source>let the axis stand after the reversal: a spike goes, play stays</source>
            <translation>反向后让轴停住：尖峰消失，间隙保留</translation>
        </message>
        <message>
            <source>sample from 0.01 to 50 mm after the reversal</source>
            <translation>在反向后 0.01 至 50 mm 处取样</translation>
        </message>
        <message>
            <source>repeat with another load</source>
            <translation>换另一负载重复</translation>
        </message>
        <message>
            <source>measure without the probe, or calibrate it</source>
            <translation>不用测头测量，或标定测头</translation>
        </message>
        <message>
            <source>measure at two arms</source>
            <translation>用两个力臂测量</translation>
        </message>
        <message>
            <source>measure at both ends of the travel</source>
            <translation>在行程两端测量</translation>
        </message>
        <message>
            <source>stand still after the reversal</source>
            <translation>反向后停住</translation>
        </message>
        <message>
            <source>two feeds</source>
            <translation>两种进给</translation>
        </message>
        <message>
            <source>the other sense of rotation and another feed: lag follows both</source>
            <translation>另一旋转方向和另一进给：滞后与两者有关</translation>
        </message>
        <message>
            <source>move in steps and hold before reading</source>
            <translation>步进移动，停住后读数</translation>
        </message>
        <message>
            <source>two speeds, both senses</source>
            <translation>两种速度，两个方向</translation>
        </message>
        <message>
            <source>move in steps and hold</source>
            <translation>步进移动并停住</translation>
        </message>
        <message>
            <source>needs a run at another temperature, 3 C apart or more</source>
            <translation>需要在另一温度下测一次，相差 3 °C 以上</translation>
        </message>
        <message>
            <source>a second instrument on the axis; screw warm while the material is cool</source>
            <translation>第二台仪器；材料冷而丝杠热时测量</translation>
        </message>
        <message>
            <source>sensors on screw and scale apart</source>
            <translation>丝杠和光栅尺分别装传感器</translation>
        </message>
        <message>
            <source>spindle on and off, not in step with the room</source>
            <translation>主轴开和关，与室温不同步</translation>
        </message>
        <message>
            <source>probe a fixed datum every 2 to 3 minutes</source>
            <translation>每 2 至 3 分钟探测一个固定基准</translation>
        </message>
        <message>
            <source>a run at another time of day</source>
            <translation>在一天中的另一时间测一次</translation>
        </message>
        <message>
            <source>switch them apart</source>
            <translation>分别开关</translation>
        </message>
        <message>
            <source>switch the coolant several times</source>
            <translation>多次开关冷却液</translation>
        </message>
        <message>
            <source>measure at two heights</source>
            <translation>在两个高度测量</translation>
        </message>
        <message>
            <source>measure after cooling down</source>
            <translation>冷却后测量</translation>
        </message>
        <message>
            <source>dress between parts</source>
            <translation>各工件之间修整砂轮</translation>
        </message>
        <message>
            <source>spindle on and off</source>
            <translation>主轴开和关</translation>
        </message>
        <message>
            <source>dress the wheel in between</source>
            <translation>中间修整砂轮</translation>
        </message>
        <message>
            <source>measure at both ends of the table</source>
            <translation>在工作台两端测量</translation>
        </message>
        <message>
            <source>vary the infeed at the same number of passes</source>
            <translation>遍数相同而改变进给</translation>
        </message>
        <message>
            <source>vary the number of passes without infeed</source>
            <translation>改变无进给的遍数</translation>
        </message>
        <message>
            <source>measure with another load, or without work</source>
            <translation>用另一负载或不装工件测量</translation>
        </message>
        <message>
            <source>turn the part by 60 degrees; measure at two distances</source>
            <translation>将工件转 60 度；在两个距离测量</translation>
        </message>
        <message>
            <source>turn the probe</source>
            <translation>转动测头</translation>
        </message>
        <message>
            <source>align the laser anew; cosine only ever shortens</source>
            <translation>重新对准激光；余弦误差只会变短</translation>
        </message>
        <message>
            <source>interferometer close to the reflector at zero</source>
            <translation>零位时干涉仪靠近反射镜</translation>
        </message>
        <message>
            <source>a second instrument; screw warm while the material is cool</source>
            <translation>第二台仪器；材料冷而丝杠热时测量</translation>
        </message>
        <message>
            <source>a second instrument</source>
            <translation>第二台仪器</translation>
        </message>
        <message>
            <source>repeat in other air, or correct it</source>
            <translation>在另一空气条件下重复，或修正</translation>
        </message>
        <message>
            <source>probe the datum across the instant</source>
            <translation>在该时刻前后探测基准</translation>
        </message>
        <message>
            <source>measure the arm</source>
            <translation>测量力臂</translation>
        </message>
    </context>
</TS>
