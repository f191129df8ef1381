<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
<context>
    <name>About</name>
    <message>
        <source>About Bask</source>
        <translation>关于 Bask</translation>
    </message>
    <message>
        <source>Radiation-based thermal servoing: a robot brings objects to their temperatures by holding them in front of a heat source.</source>
        <translation>基于辐射的热伺服：机器人将物体置于热源前，使其达到各自的温度。</translation>
    </message>
    <message>
        <source>Qt %1 on %2. Licence: GPL-3.0-or-later.</source>
        <translation>Qt %1，%2。许可证：GPL-3.0-or-later。</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
</context>
<context>
    <name>CloseQuestion</name>
    <message>
        <source>&quot;Stop, then close&quot; switches the heat off, takes the objects away from the source, and closes when they are there. &quot;Close now&quot; switches the heat off and leaves the objects where they are, perhaps close to a hot source. What is recorded stays.</source>
        <translation>“停止后关闭”会关闭加热，使物体离开热源，到位后再关闭程序。“立即关闭”会关闭加热，并使物体停在原处，可能就在灼热的热源附近。已记录的内容会保留。</translation>
    </message>
    <message>
        <source>A recipe is on, with nothing heated or moved just now.</source>
        <translation>配方正在进行，此刻没有加热或移动。</translation>
    </message>
    <message>
        <source>The recipe ends, and its other steps are not run.</source>
        <translation>配方随之结束，其余步骤不再运行。</translation>
    </message>
    <message>
        <source>A run is on</source>
        <translation>运行正在进行</translation>
    </message>
    <message>
        <source>A recipe is on</source>
        <translation>配方正在进行</translation>
    </message>
    <message>
        <source>Stop, then close</source>
        <translation>停止后关闭</translation>
    </message>
    <message>
        <source>Close now</source>
        <translation>立即关闭</translation>
    </message>
    <message>
        <source>End the recipe and close</source>
        <translation>结束配方并关闭</translation>
    </message>
    <message>
        <source>Stay</source>
        <translation>留下</translation>
    </message>
    <message>
        <source>The heat is not known to be off</source>
        <translation>加热不能确定已关闭</translation>
    </message>
    <message>
        <source>The heat source was told to switch off and has not said that it is off. Look at the plate, and switch it off at its mains.</source>
        <translation>已命令热源关闭，但它没有回报已关闭。请查看热板，并切断其电源。</translation>
    </message>
    <message>
        <source>A guard process goes on switching off a heater on a serial port after Bask has closed. The alarm is there again at the next start.</source>
        <translation>Bask 关闭后，守护进程会继续关闭串口上的热源。下次启动时该报警会再次出现。</translation>
    </message>
    <message>
        <source>An export is being written</source>
        <translation>正在写出导出内容</translation>
    </message>
    <message>
        <source>Bask is still writing what is named below. If it closes now, some of it may be missing; no file is left half written.</source>
        <translation>Bask 仍在写出下列内容。现在关闭，其中一部分可能会缺失；不会留下只写了一半的文件。</translation>
    </message>
    <message>
        <source>Close anyway</source>
        <translation>仍然关闭</translation>
    </message>
    <message>
        <source>The recording is on</source>
        <translation>正在记录</translation>
    </message>
    <message>
        <source>If Bask is closed now, the recording ends. What is recorded stays.</source>
        <translation>现在关闭 Bask，记录即结束。已记录的内容会保留。</translation>
    </message>
</context>
<context>
    <name>Column</name>
    <message>
        <source>Temperature</source>
        <translation>温度</translation>
    </message>
    <message>
        <source>Temperatures</source>
        <translation>温度</translation>
    </message>
    <message>
        <source>Measured temperatures. Dashed: targets; grey: the band of %1 about them. Gaps: no valid reading. The numbers at dotted lines are those of the table of events.</source>
        <translation>测量温度。虚线：目标；灰色：其周围 %1 的容差带。间断处：没有有效读数。点线处的编号与事件表中的编号一致。</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>误差</translation>
    </message>
    <message>
        <source>Errors</source>
        <translation>误差</translation>
    </message>
    <message>
        <source>Measured temperature minus target, within %1; grey: the band.</source>
        <translation>测量温度减目标，在 %1 以内；灰色：容差带。</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>变化率</translation>
    </message>
    <message>
        <source>Rates</source>
        <translation>变化率</translation>
    </message>
    <message>
        <source>View factor</source>
        <translation>角系数</translation>
    </message>
    <message>
        <source>View factors</source>
        <translation>角系数</translation>
    </message>
    <message>
        <source>View factor of the source from each object.</source>
        <translation>各物体对热源的角系数。</translation>
    </message>
    <message>
        <source>Shade</source>
        <translation>遮挡</translation>
    </message>
    <message>
        <source>Share of the source&apos;s light that other objects, fixtures and shields take from each object.</source>
        <translation>其他物体、夹具和遮板从各物体挡去的热源光的份额。</translation>
    </message>
    <message>
        <source>Estimated λ₁</source>
        <translation>估计的 λ₁</translation>
    </message>
    <message>
        <source>Estimates</source>
        <translation>估计值</translation>
    </message>
</context>
<context>
    <name>Controller</name>
    <message>
        <source>Level servo</source>
        <translation>等值面伺服</translation>
    </message>
    <message>
        <source>Moves to the view factor each object needs; learns the rates on the way.</source>
        <translation>运动到每个物体所需的角系数；途中学习热速率。</translation>
    </message>
    <message>
        <source>Model-based</source>
        <translation>基于模型</translation>
    </message>
    <message>
        <source>Adaptive</source>
        <translation>自适应</translation>
    </message>
    <message>
        <source>The paper&apos;s law with adapted heat rates.</source>
        <translation>论文的控制律，热速率自适应。</translation>
    </message>
    <message>
        <source>The paper&apos;s law with known heat rates: dv/dt = −D v − K Δτ.</source>
        <translation>论文的控制律，热速率已知：dv/dt = −D v − K Δτ。</translation>
    </message>
</context>
<context>
    <name>Damage</name>
    <message>
        <source>it is cut short</source>
        <translation>文件不完整</translation>
    </message>
    <message>
        <source>a sample is missing</source>
        <translation>缺少一个采样</translation>
    </message>
    <message>
        <source>it does not say whether the rig was simulated</source>
        <translation>未说明装置是否为仿真</translation>
    </message>
    <message>
        <source>its database is not whole</source>
        <translation>其数据库不完整</translation>
    </message>
    <message>
        <source>it has a format number that no version has</source>
        <translation>其格式编号不属于任何版本</translation>
    </message>
    <message>
        <source>the header of its database was written over</source>
        <translation>其数据库的文件头已被覆盖</translation>
    </message>
</context>
<context>
    <name>Device</name>
    <message>
        <source>robot</source>
        <translation>机器人</translation>
    </message>
    <message>
        <source>thermometer</source>
        <translation>温度计</translation>
    </message>
    <message>
        <source>heat source</source>
        <translation>热源</translation>
    </message>
    <message>
        <source>heat source kept by hand</source>
        <translation>人工加热的热源</translation>
    </message>
    <message>
        <source>source temperature</source>
        <translation>热源温度</translation>
    </message>
    <message>
        <source>thermal camera</source>
        <translation>热像仪</translation>
    </message>
</context>
<context>
    <name>Fault</name>
    <message>
        <source>Restore all devices</source>
        <translation>恢复所有设备</translation>
    </message>
    <message>
        <source>Sensor lost</source>
        <translation>传感器失联</translation>
    </message>
    <message>
        <source>Sensor open</source>
        <translation>传感器开路</translation>
    </message>
    <message>
        <source>Sensor shorted</source>
        <translation>传感器短路</translation>
    </message>
    <message>
        <source>Sensor frozen</source>
        <translation>传感器冻结</translation>
    </message>
    <message>
        <source>Sensor jumping</source>
        <translation>传感器跳变</translation>
    </message>
    <message>
        <source>Sensor off its object</source>
        <translation>传感器脱离物体</translation>
    </message>
    <message>
        <source>Object heated otherwise</source>
        <translation>物体被另外加热</translation>
    </message>
    <message>
        <source>Robot lost</source>
        <translation>机器人失联</translation>
    </message>
    <message>
        <source>Robot in alarm</source>
        <translation>机器人报警</translation>
    </message>
    <message>
        <source>Robot restarted</source>
        <translation>机器人已重启</translation>
    </message>
    <message>
        <source>Robot slow</source>
        <translation>机器人缓慢</translation>
    </message>
    <message>
        <source>Heat source lost</source>
        <translation>热源失联</translation>
    </message>
    <message>
        <source>Heat source without temperature</source>
        <translation>热源没有温度值</translation>
    </message>
    <message>
        <source>Heat source does not heat</source>
        <translation>热源不加热</translation>
    </message>
    <message>
        <source>Heat source heats unasked</source>
        <translation>热源擅自加热</translation>
    </message>
    <message>
        <source>Heat source overheats</source>
        <translation>热源过热</translation>
    </message>
    <message>
        <source>Heat source limited by itself</source>
        <translation>热源自行限制</translation>
    </message>
    <message>
        <source>Heat source cannot be switched off</source>
        <translation>热源无法关闭</translation>
    </message>
    <message>
        <source>Source hidden from the camera</source>
        <translation>相机看不到热源</translation>
    </message>
    <message>
        <source>Camera lost</source>
        <translation>相机失联</translation>
    </message>
    <message>
        <source>Sensors swapped with the next object</source>
        <translation>传感器与下一个物体的互换</translation>
    </message>
</context>
<context>
    <name>MaterialPreset</name>
    <message>
        <source>aluminium, painted black</source>
        <translation>铝，涂黑漆</translation>
    </message>
    <message>
        <source>aluminium, anodised</source>
        <translation>铝，阳极氧化</translation>
    </message>
    <message>
        <source>copper, polished</source>
        <translation>铜，抛光</translation>
    </message>
    <message>
        <source>steel, painted black</source>
        <translation>钢，涂黑漆</translation>
    </message>
    <message>
        <source>stainless steel, polished</source>
        <translation>不锈钢，抛光</translation>
    </message>
    <message>
        <source>stainless steel, oxidised</source>
        <translation>不锈钢，氧化</translation>
    </message>
    <message>
        <source>ABS, 30 % infill</source>
        <translation>ABS，填充率 30 %</translation>
    </message>
    <message>
        <source>graphite</source>
        <translation>石墨</translation>
    </message>
    <message>
        <source>cardboard</source>
        <translation>纸板</translation>
    </message>
    <message>
        <source>Hu et al., arXiv 2012.13147 (bulk), flat paint (surface)</source>
        <translation>Hu 等，arXiv 2012.13147（本体），哑光漆（表面）</translation>
    </message>
    <message>
        <source>aluminium, painted</source>
        <translation>铝，涂漆</translation>
    </message>
    <message>
        <source>aluminium, bare</source>
        <translation>铝，裸面</translation>
    </message>
    <message>
        <source>PLA, 30 % infill</source>
        <translation>PLA，填充率 30 %</translation>
    </message>
    <message>
        <source>PLA, 50 % infill</source>
        <translation>PLA，填充率 50 %</translation>
    </message>
    <message>
        <source>PLA, solid</source>
        <translation>PLA，实心</translation>
    </message>
    <message>
        <source>ABS, solid</source>
        <translation>ABS，实心</translation>
    </message>
    <message>
        <source>copper, oxidised</source>
        <translation>铜，氧化</translation>
    </message>
    <message>
        <source>glass</source>
        <translation>玻璃</translation>
    </message>
    <message>
        <source>Incropera, table A.1 (bulk), FLIR tables: matte black lacquer (surface)</source>
        <translation>Incropera，表 A.1（本体），FLIR 数据表：哑光黑漆（表面）</translation>
    </message>
    <message>
        <source>Incropera, table A.1 (bulk), Neutrium: anodised, 20 °C (surface)</source>
        <translation>Incropera，表 A.1（本体），Neutrium：阳极氧化，20 °C（表面）</translation>
    </message>
    <message>
        <source>Incropera, table A.1 (bulk), FLIR tables: sheet as received (surface)</source>
        <translation>Incropera，表 A.1（本体），FLIR 数据表：出厂板材（表面）</translation>
    </message>
    <message>
        <source>Hu et al., arXiv 2012.13147; FLIR tables: 0.04 to 0.06, polished</source>
        <translation>Hu 等，arXiv 2012.13147；FLIR 数据表：0.04 至 0.06，抛光</translation>
    </message>
    <message>
        <source>Incropera, table A.1 (bulk), FLIR tables (surface)</source>
        <translation>Incropera，表 A.1（本体），FLIR 数据表（表面）</translation>
    </message>
    <message>
        <source>AISI 1010, Matmake (bulk), FLIR tables: matte black lacquer (surface)</source>
        <translation>AISI 1010，Matmake（本体），FLIR 数据表：哑光黑漆（表面）</translation>
    </message>
    <message>
        <source>EN 10088-1, 1.4301 (bulk), Trotec: 18-8, 25 °C (surface)</source>
        <translation>EN 10088-1，1.4301（本体），Trotec：18-8，25 °C（表面）</translation>
    </message>
    <message>
        <source>EN 10088-1, 1.4301 (bulk), Thome, EPFL: 0.5 to 0.7 after heating (surface)</source>
        <translation>EN 10088-1，1.4301（本体），Thome，EPFL：加热后 0.5 至 0.7（表面）</translation>
    </message>
    <message>
        <source>FreeCAD card PLA-Generic (bulk), plastics: 0.85 to 0.95 (surface)</source>
        <translation>FreeCAD 材料卡 PLA-Generic（本体），塑料：0.85 至 0.95（表面）</translation>
    </message>
    <message>
        <source>Kaiao, Granta Design (bulk), plastics: 0.85 to 0.95 (surface)</source>
        <translation>Kaiao，Granta Design（本体），塑料：0.85 至 0.95（表面）</translation>
    </message>
    <message>
        <source>Pilkington ATS-129; specific heat: tables say 720 to 880 J/(kg·K)</source>
        <translation>Pilkington ATS-129；比热容：各数据表为 720 至 880 J/(kg·K)</translation>
    </message>
    <message>
        <source>Entegris, by FreeCAD&apos;s card (bulk), tables: 0.8 to 0.98 (surface)</source>
        <translation>Entegris，据 FreeCAD 材料卡（本体），数据表：0.8 至 0.98（表面）</translation>
    </message>
    <message>
        <source>Ashby: 480 to 860 kg/m³ (bulk), FLIR tables: paper (surface)</source>
        <translation>Ashby：480 至 860 kg/m³（本体），FLIR 数据表：纸（表面）</translation>
    </message>
    <message>
        <source>aluminium, polished</source>
        <translation>铝，抛光</translation>
    </message>
    <message>
        <source>Standard uncertainty: %1</source>
        <translation>标准不确定度：%1</translation>
    </message>
</context>
<context>
    <name>Message</name>
    <message>
        <source>&quot;%1&quot; is not the finite number or numbers that it should be</source>
        <translation>“%1”不是此处所需的有限数值</translation>
    </message>
    <message>
        <source>Held for more than %1 s without a reading: the run is ended</source>
        <translation>无读数保持超过 %1 s：运行结束</translation>
    </message>
    <message>
        <source>a recipe needs at least one step that runs an experiment</source>
        <translation>配方至少需要一个运行实验的步骤</translation>
    </message>
    <message>
        <source>not one of Bask&apos;s files, or a damaged one: it is no valid JSON (%1)</source>
        <translation>不是 Bask 的文件，或文件已损坏：不是有效的 JSON（%1）</translation>
    </message>
    <message>
        <source>simulated fault of &quot;%2&quot;: %1</source>
        <translation>“%2”的模拟故障：%1</translation>
    </message>
    <message>
        <source>simulated fault: %1</source>
        <translation>模拟故障：%1</translation>
    </message>
    <message>
        <source>the camera matrix cannot be used: nine numbers fx 0 cx, 0 fy cy, 0 0 1 with focal lengths above zero are needed</source>
        <translation>相机矩阵不可用：需要九个数 fx 0 cx, 0 fy cy, 0 0 1，且焦距大于零</translation>
    </message>
    <message>
        <source>a distortion of %1 coefficients cannot be used; 4, 5 or 8 can</source>
        <translation>含 %1 个系数的畸变不可用；可用 4、5 或 8 个</translation>
    </message>
    <message>
        <source>the camera was calibrated with pictures of %1 pixels, this one has %2; calibrate it at this size</source>
        <translation>相机是用 %1 像素的图像标定的，而此图像为 %2；请在此尺寸下标定</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not %2 digits 0 or 1</source>
        <translation>“%1”不是 %2 位的 0 或 1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no board; write chessboard:9x6:0.025 (inner corners, square in m) or charuco:5x7:0.04:0.02:6X6_250 (squares, square and marker in m, dictionary)</source>
        <translation>“%1”不是标定板；请写成 chessboard:9x6:0.025（内角点数，方格边长单位 m）或 charuco:5x7:0.04:0.02:6X6_250（方格数，方格与标记边长单位 m，字典）</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no marker; write marker:6X6_250:23:0.05 (dictionary, id, side in m)</source>
        <translation>“%1”不是标记；请写成 marker:6X6_250:23:0.05（字典，编号，边长单位 m）</translation>
    </message>
    <message>
        <source>a marker of %1 m does not fit into a square of %2 m</source>
        <translation>%1 m 的标记放不进 %2 m 的方格</translation>
    </message>
    <message>
        <source>dictionary %1 has %2 markers; %3 are needed</source>
        <translation>字典 %1 有 %2 个标记；需要 %3 个</translation>
    </message>
    <message>
        <source>no chessboard of %1 inner corners is seen; it needs to be whole in the picture, flat, with a light margin</source>
        <translation>未见到内角点为 %1 的棋盘格；它须完整位于画面中，保持平整，并留有浅色边缘</translation>
    </message>
    <message>
        <source>only %1 corners of the board are seen; %2 that are not in one line are needed</source>
        <translation>只见到标定板的 %1 个角点；需要 %2 个不共线的角点</translation>
    </message>
    <message>
        <source>the pictures show the board %1, not %2; correct the setting</source>
        <translation>图像中的标定板是 %1，而不是 %2；请更正设置</translation>
    </message>
    <message>
        <source>the picture has %1 pixels, the others %2; take all with one camera at one size</source>
        <translation>此图像为 %1 像素，其余为 %2；请用同一相机、同一尺寸拍摄全部图像</translation>
    </message>
    <message>
        <source>%1 pictures that can be used are too few; at least %2 are needed, with the board tilted in different ways</source>
        <translation>可用的图像只有 %1 张，太少；至少需要 %2 张，并使标定板朝不同方向倾斜</translation>
    </message>
    <message>
        <source>in all pictures the board is seen straight on, tilted by %1 degrees at most; at least %2 are needed to tell the focal length</source>
        <translation>所有图像中标定板都接近正对相机，倾斜最多 %1 度；要确定焦距至少需要 %2 度</translation>
    </message>
    <message>
        <source>in all pictures the board is held in nearly the same direction, turned by %1 degrees at most between two of them; at least %2 are needed to tell the focal length</source>
        <translation>所有图像中标定板的朝向几乎相同，任意两张之间最多相差 %1 度；要确定焦距至少需要 %2 度</translation>
    </message>
    <message>
        <source>no camera explains these pictures; tilt the board in different ways and check its setting</source>
        <translation>没有相机模型能解释这些图像；请使标定板朝不同方向倾斜，并检查其设置</translation>
    </message>
    <message>
        <source>the focal length is known to %1 % only; at most %2 % can be used, so add pictures with the board tilted in different ways</source>
        <translation>焦距的不确定度为 %1 %；最多允许 %2 %，请补充标定板朝不同方向倾斜的图像</translation>
    </message>
    <message>
        <source>the pictures contradict one another by %1 px; at most %2 px can be used, so check that the board is flat, its setting right and all pictures from one camera</source>
        <translation>各图像之间相差 %1 px；最多允许 %2 px，请检查标定板是否平整、设置是否正确、图像是否均来自同一相机</translation>
    </message>
    <message>
        <source>%1 mm are needed with margins, %2 has room for %3 mm; take larger paper or a smaller pattern</source>
        <translation>含边距共需 %1 mm，而 %2 只有 %3 mm；请用更大的纸张或更小的图案</translation>
    </message>
    <message>
        <source>the file does not say which camera it came from; name the camera&apos;s profile</source>
        <translation>该文件没有说明来自哪台相机；请指定相机的配置文件</translation>
    </message>
    <message>
        <source>a frame of &quot;%1&quot; has %2 bytes, this one has %3; choose the profile of the camera that it came from, or record it again</source>
        <translation>“%1”的一帧有 %2 字节，而这里有 %3 字节；请选择拍摄它的相机的配置文件，或重新记录</translation>
    </message>
    <message>
        <source>the number %1 at column %2, row %3 does not fit into %4 bits; the byte order, or the profile, is another camera&apos;s</source>
        <translation>第 %2 列、第 %3 行的数值 %1 超出 %4 位；字节顺序或配置文件属于另一台相机</translation>
    </message>
    <message>
        <source>%1 % of the pixels are outside of %2 to %3, which is all that &quot;%4&quot; can tell; switch the camera to radiometric output (linear in temperature), or choose another profile</source>
        <translation>%1 % 的像素不在 %2 至 %3 之内，这是“%4”能测的全部范围；请把相机切换到辐射测温输出（与温度成线性），或选择另一个配置文件</translation>
    </message>
    <message>
        <source>%1 pixels are above %2, where the numbers of &quot;%3&quot; are known to be wrong for some cameras; check them with another thermometer</source>
        <translation>%1 个像素高于 %2，在该范围“%3”的数值对某些相机已知是错误的；请用另一支温度计核对</translation>
    </message>
    <message>
        <source>all pixels of the picture have one value; the camera&apos;s shutter is closed, or it sends no picture</source>
        <translation>图像的所有像素都是同一个值；相机的快门关着，或相机没有送出图像</translation>
    </message>
    <message>
        <source>%1 pixels are outside of what the camera can tell, the first at column %2, row %3, so the temperatures of the whole picture are not known; ask for regions, or take a lower gain</source>
        <translation>%1 个像素超出相机能测的范围，第一个在第 %2 列、第 %3 行，因此整幅图像的温度未知；请改用区域，或降低增益</translation>
    </message>
    <message>
        <source>one channel of 16 bits is needed, and this picture has %1; save the camera&apos;s numbers, not the colours that it shows</source>
        <translation>需要 16 位的单通道，而该图像是 %1；请保存相机的数值，而不是它显示的颜色</translation>
    </message>
    <message>
        <source>a picture of &quot;%1&quot; has %2 pixels, this one has %3; choose the profile of the camera that it came from</source>
        <translation>“%1”的图像有 %2 像素，而这一幅有 %3；请选择拍摄它的相机的配置文件</translation>
    </message>
    <message>
        <source>there is no table of temperatures: lines of %1 numbers or more, of one length, up to the end of the file</source>
        <translation>没有温度表：应是每行至少 %1 个数、长度相同、直到文件末尾的各行</translation>
    </message>
    <message>
        <source>line %1 has %2 values, the table&apos;s first line has %3; export the picture again</source>
        <translation>第 %1 行有 %2 个值，而表的首行有 %3 个；请重新导出图像</translation>
    </message>
    <message>
        <source>line %1, value %2: &quot;%3&quot; is no temperature in degrees Celsius; export the picture again, without masks</source>
        <translation>第 %1 行、第 %2 个值：“%3”不是摄氏温度；请重新导出图像，不要带掩膜</translation>
    </message>
    <message>
        <source>there are no frames here; their names end in one of %1</source>
        <translation>这里没有帧；其文件名以下列之一结尾：%1</translation>
    </message>
    <message>
        <source>the times of the frames are not known; put %1 beside them, or give the profile a frame_rate_Hz</source>
        <translation>各帧的时间未知；请在旁边放入 %1，或在配置文件中给出 frame_rate_Hz</translation>
    </message>
    <message>
        <source>line %1, &quot;%2&quot;, cannot be used: first file,time_s, then one line for each file of this folder, with growing times</source>
        <translation>第 %1 行“%2”无法使用：首行为 file,time_s，其后该文件夹的每个文件一行，时间递增</translation>
    </message>
    <message>
        <source>it is not in the picture; aim the camera at it</source>
        <translation>它不在图像中；请将相机对准它</translation>
    </message>
    <message>
        <source>nearer things hide it: %1 of its pixels are seen, %2 are needed</source>
        <translation>它被更近的东西遮住：可见 %1 个像素，需要 %2 个</translation>
    </message>
    <message>
        <source>it is seen edge-on, at %1 degrees to its face; move the camera</source>
        <translation>只看到它的侧边，视线与其表面成 %1 度；请移动相机</translation>
    </message>
    <message>
        <source>%1 pixels inside of its edges are too few, %2 are needed; bring the camera nearer</source>
        <translation>其边缘以内只有 %1 个像素，太少，需要 %2 个；请将相机移近</translation>
    </message>
    <message>
        <source>%1 of its %2 pixels tell nothing; check the camera</source>
        <translation>其 %2 个像素中有 %1 个没有读数；请检查相机</translation>
    </message>
    <message>
        <source>%1 of its %2 pixels are outside of what the camera can tell (saturated); take a lower gain</source>
        <translation>其 %2 个像素中有 %1 个超出相机能测的范围（饱和）；请降低增益</translation>
    </message>
    <message>
        <source>the name &quot;%1&quot; is used twice; give each region its own</source>
        <translation>名称“%1”用了两次；请给每个区域各自的名称</translation>
    </message>
    <message>
        <source>what the camera saw, %1, is explained by no temperature of the face at emittance %2 with these reflections; check emittance, view factors and the source&apos;s temperature</source>
        <translation>相机所见的 %1，在发射率 %2 及这些反射下，表面取任何温度都无法解释；请检查发射率、角系数和热源温度</translation>
    </message>
    <message>
        <source>at emittance %1 the camera tells this face&apos;s temperature to +-%2 only, and a thermometer needs +-%3; paint the face black, or use a contact sensor</source>
        <translation>发射率为 %1 时，相机只能以 ±%2 测得该表面的温度，而温度计需要 ±%3；请将表面涂黑，或使用接触式传感器</translation>
    </message>
    <message>
        <source>the objects&apos; outlines are seen at %1 poses of the robot; at least %2 are needed</source>
        <translation>在 %1 个机器人位姿看到物体的轮廓；至少需要 %2 个</translation>
    </message>
    <message>
        <source>no object lies in the picture where the camera is said to be; check that pose, or aim the camera at the objects</source>
        <translation>按所给的相机位姿，图像中没有物体；请检查该位姿，或将相机对准物体</translation>
    </message>
    <message>
        <source>the objects do not stand out against what is behind them by %1 or more; make them 5 K or more warmer or colder than the room</source>
        <translation>物体与其背景相差不到 %1；请使其比室内热或冷 5 K 以上</translation>
    </message>
    <message>
        <source>no pose of the camera explains the pictures: at the best one %1 % of the visible outlines are found; check the start pose, the robot&apos;s pose of each picture, the mountings and that no outline is mirrored</source>
        <translation>没有能解释这些图像的相机位姿：最好的位姿也只找到 %1 % 的可见轮廓；请检查起始位姿、每幅图像的机器人位姿、安装位置，以及轮廓是否镜像</translation>
    </message>
    <message>
        <source>the pictures allow two poses of the camera, %1 degrees apart; take more pictures, with the objects tilted and nearer</source>
        <translation>这些图像允许两个相机位姿，相差 %1 度；请再拍摄物体倾斜且更近的图像</translation>
    </message>
    <message>
        <source>picture %1 was left out: %2 points of the objects&apos; outlines are seen in it, %3 are needed</source>
        <translation>图像 %1 未采用：其中看到物体轮廓的 %2 个点，需要 %3 个</translation>
    </message>
    <message>
        <source>%1 poses of the robot hardly show the robot&apos;s own errors; take %2 or more</source>
        <translation>%1 个机器人位姿几乎显不出机器人自身的误差；请取 %2 个或更多</translation>
    </message>
    <message>
        <source>the robot stood at places in one line, within %1 mm; move it in two directions or more</source>
        <translation>机器人所在的位置在一条直线上（%1 mm 以内）；请沿两个或更多方向移动</translation>
    </message>
    <message>
        <source>all outlines lie at nearly one distance from the camera (within %1 %), where its distance and its tilt are told badly; move the robot towards the camera, too</source>
        <translation>所有轮廓到相机的距离几乎相同（%1 % 以内），难以得出其距离和倾斜；请也让机器人朝相机移动</translation>
    </message>
    <message>
        <source>the camera&apos;s pose is good to %1 mm at the objects, %2 mm across the line of sight (2 sigma)</source>
        <translation>相机位姿在物体处的误差为 %1 mm，垂直于视线方向 %2 mm（2 sigma）</translation>
    </message>
    <message>
        <source>the camera&apos;s pose is good to %1 mm only at the objects, %2 mm across the line of sight (2 sigma); take more pictures, with the objects nearer and all over the picture</source>
        <translation>相机位姿在物体处的误差只能达到 %1 mm，垂直于视线方向 %2 mm（2 sigma）；请再拍摄物体更近、遍布图像各处的图像</translation>
    </message>
    <message>
        <source>%1 pixels show the source&apos;s face and nothing else, %2 are needed; move the objects aside, or bring the camera nearer</source>
        <translation>只有 %1 个像素仅显示热源的表面，需要 %2 个；请移开物体，或将相机移近</translation>
    </message>
    <message>
        <source>of the ring from %1 to %2 mm too little is seen; it is left out of the profile</source>
        <translation>%1 至 %2 mm 的圆环可见部分太少；未计入分布</translation>
    </message>
    <message>
        <source>%1 and %2 overlap; move one of them</source>
        <translation>%1 与 %2 重叠；请移动其中一个</translation>
    </message>
    <message>
        <source>%1 reaches %2 cm from the end-effector&apos;s centre; the robot can carry objects within %3 cm</source>
        <translation>%1 距末端执行器中心达 %2 cm；机器人可携带 %3 cm 以内的物体</translation>
    </message>
    <message>
        <source>%1, %2 and %3 lie in a line; like temperatures for all three cannot be held together, a triangle is better</source>
        <translation>%1、%2 与 %3 位于一条直线上；三者无法同时保持相近的温度，布置成三角形更好</translation>
    </message>
    <message>
        <source>none of the free axes changes the view factor of %1; mount it elsewhere or free another axis</source>
        <translation>没有自由轴能改变 %1 的角系数；请换个位置安装，或释放另一个轴</translation>
    </message>
    <message>
        <source>%1 and %2 have the same view factor wherever the free axes bring them, so one cannot be heated without the other; mount one elsewhere or free another axis</source>
        <translation>无论自由轴如何运动，%1 与 %2 的角系数始终相同，因此无法只加热其中一个；请将其中一个换位安装，或释放另一个轴</translation>
    </message>
    <message>
        <source>the free axes cannot change the view factors of %1 independently of one another; mount one elsewhere or free another axis</source>
        <translation>自由轴无法各自独立地改变 %1 的角系数；请将其中一个换位安装，或释放另一个轴</translation>
    </message>
    <message>
        <source>as many objects as free axes (%1): their heating decides every movement, none is left for keeping away from limits</source>
        <translation>物体数与自由轴数相同（%1）：加热决定了全部运动，没有余量用于避开限值</translation>
    </message>
    <message>
        <source>At rest the sensors&apos; readings lie %1 from their mean; at most %2 can be zeroed. Check the sensors and their noise.</source>
        <translation>静止时传感器读数偏离其平均值达 %1；最多可校零 %2。请检查传感器及其噪声。</translation>
    </message>
    <message>
        <source>there is no such file; check the path</source>
        <translation>没有此文件；请检查路径</translation>
    </message>
    <message>
        <source>the file cannot be read: %1</source>
        <translation>无法读取文件：%1</translation>
    </message>
    <message>
        <source>the file cannot be written: %1</source>
        <translation>无法写入文件：%1</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>文件为空</translation>
    </message>
    <message>
        <source>the file has %1, more than the %2 that are read</source>
        <translation>文件含 %1，超过可读取的 %2</translation>
    </message>
    <message>
        <source>unknown key &quot;%1&quot;; known here: %2</source>
        <translation>未知的键“%1”；此处可用：%2</translation>
    </message>
    <message>
        <source>the key &quot;%1&quot; is missing</source>
        <translation>缺少键“%1”</translation>
    </message>
    <message>
        <source>%1 expected, %2 found</source>
        <translation>应为 %1，实为 %2</translation>
    </message>
    <message>
        <source>the key &quot;%1&quot; is given twice</source>
        <translation>键“%1”出现了两次</translation>
    </message>
    <message>
        <source>nested more than %1 levels deep</source>
        <translation>嵌套超过 %1 层</translation>
    </message>
    <message>
        <source>&quot;%1&quot; and &quot;%2&quot; say the same thing; give one of them</source>
        <translation>“%1”与“%2”含义相同；请只给出其中一个</translation>
    </message>
    <message>
        <source>%1 is out of range; allowed: %2 to %3 %4</source>
        <translation>%1 超出范围；允许：%2 至 %3 %4</translation>
    </message>
    <message>
        <source>%1 is not allowed; it must be greater than zero</source>
        <translation>不允许 %1；必须大于零</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not known; known: %2</source>
        <translation>未知的“%1”；可用：%2</translation>
    </message>
    <message>
        <source>made by a newer version of Bask (format %1, this one knows up to %2); update Bask to open it</source>
        <translation>由更新版本的 Bask 生成（格式 %1，当前版本最高支持 %2）；请更新 Bask 后再打开</translation>
    </message>
    <message>
        <source>not a regular file; choose another name</source>
        <translation>不是普通文件；请另选名称</translation>
    </message>
    <message>
        <source>this file is also an input; choose another name for the output</source>
        <translation>此文件同时也是输入；请为输出另选名称</translation>
    </message>
    <message>
        <source>another output goes there; give each its own name</source>
        <translation>另一项输出已写往此处；请为每项输出指定各自的名称</translation>
    </message>
    <message>
        <source>a file of that name exists and is not %1; choose another name</source>
        <translation>已有同名文件，且它不是 %1；请另选名称</translation>
    </message>
    <message>
        <source>a file of that name exists and is not an earlier export; choose another folder</source>
        <translation>已有同名文件，且它不是先前的导出结果；请另选文件夹</translation>
    </message>
    <message>
        <source>%1 objects, but the robot has only %2 free degrees of freedom; remove objects or free more axes</source>
        <translation>有 %1 个物体，但机器人只有 %2 个自由的自由度；请移除物体或释放更多轴</translation>
    </message>
    <message>
        <source>there is no object; add at least one</source>
        <translation>没有物体；请至少添加一个</translation>
    </message>
    <message>
        <source>control characters, invisible ones (of no width, or that turn the direction of writing) and spaces at either end are not allowed here</source>
        <translation>此处不允许有控制字符、不可见字符（零宽或改变书写方向的字符），首尾也不允许有空格</translation>
    </message>
    <message>
        <source>the axis &quot;%1&quot; is given twice</source>
        <translation>轴“%1”出现了两次</translation>
    </message>
    <message>
        <source>%1 targets given for %2 objects</source>
        <translation>给出了 %1 个目标，而物体有 %2 个</translation>
    </message>
    <message>
        <source>the start&apos;s %1 is %2, outside the workspace of %3 to %4</source>
        <translation>起始位姿的 %1 为 %2，超出工作空间 %3 至 %4</translation>
    </message>
    <message>
        <source>at the start &quot;%1&quot; is %2 mm from the source plane; at least %3 mm are needed</source>
        <translation>起始时“%1”距热源平面 %2 mm；至少需要 %3 mm</translation>
    </message>
    <message>
        <source>the times must grow, but %1 s comes after %2 s</source>
        <translation>时间必须递增，但 %1 s 出现在 %2 s 之后</translation>
    </message>
    <message>
        <source>no pose of the workspace keeps the clearance to the source; widen the workspace or lower the clearance</source>
        <translation>工作空间中没有位姿能保持与热源的间距；请扩大工作空间或减小间距</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be held at %2: with this source it settles at %3 at most, even at a view factor of 1</source>
        <translation>“%1”无法保持在 %2：用此热源，即使角系数为 1，它也最高稳定在 %3</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be held at %2: it settles at %3 where it does not see the source</source>
        <translation>“%1”无法保持在 %2：在看不到热源之处，它稳定在 %3</translation>
    </message>
    <message>
        <source>&quot;%1&quot; needs a view factor of %2; within the workspace it has at most %3</source>
        <translation>“%1”需要角系数 %2；在工作空间内最多为 %3</translation>
    </message>
    <message>
        <source>&quot;%1&quot; needs a view factor of %2; within the workspace it has at least %3</source>
        <translation>“%1”需要角系数 %2；在工作空间内至少为 %3</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is to be %3 hotter than &quot;%2&quot;; with this mounting and workspace at most %4 are possible</source>
        <translation>“%1”应比“%2”高 %3；在此安装方式和工作空间下最多可高 %4</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is to be %3 hotter than &quot;%2&quot;; with this mounting and workspace it is at least %4 hotter everywhere</source>
        <translation>“%1”应比“%2”高 %3；在此安装方式和工作空间下，它处处至少高 %4</translation>
    </message>
    <message>
        <source>each target can be held by itself, but not all together: where they come nearest within the workspace, the target surfaces miss one another by %3 cm, and &quot;%1&quot; is %2 off</source>
        <translation>各目标可单独保持，但不能同时保持：在工作空间内最接近处，各目标等值面相距 %3 cm，“%1”偏离 %2</translation>
    </message>
    <message>
        <source>each target can be held by itself, but not all together: the best pose leaves &quot;%1&quot; %2 off</source>
        <translation>各目标可单独保持，但不能同时保持：在最佳位姿下“%1”仍偏离 %2</translation>
    </message>
    <message>
        <source>the motion must begin at source.pose, where %1 is %3, not %2</source>
        <translation>运动必须从 source.pose 开始，该处 %1 为 %3，而不是 %2</translation>
    </message>
    <message>
        <source>the lower limit %1 must be less than the upper limit %2</source>
        <translation>下限 %1 必须小于上限 %2</translation>
    </message>
    <message>
        <source>no axis of the robot is free; free at least one</source>
        <translation>机器人没有自由轴；请至少释放一个</translation>
    </message>
    <message>
        <source>this source cannot heat: its net power is %1 W/m2; raise its temperature or emittance, or use the gray source model</source>
        <translation>此热源无法加热：其净功率为 %1 W/m2；请提高其温度或发射率，或使用灰体热源模型</translation>
    </message>
    <message>
        <source>only %1 points; an outline needs at least %2</source>
        <translation>只有 %1 个点；轮廓至少需要 %2 个点</translation>
    </message>
    <message>
        <source>%1 has a coordinate that is not a finite number</source>
        <translation>%1 的某个坐标不是有限数值</translation>
    </message>
    <message>
        <source>&quot;%1&quot; in line %2 is not a number</source>
        <translation>第 %2 行的“%1”不是数字</translation>
    </message>
    <message>
        <source>line %1 has %2 column(s); an x and a y are needed</source>
        <translation>第 %1 行有 %2 列；需要 x 和 y</translation>
    </message>
    <message>
        <source>the outline is open: its ends are %1 mm apart (at most %2 mm)</source>
        <translation>轮廓未闭合：两端相距 %1 mm（最多 %2 mm）</translation>
    </message>
    <message>
        <source>the outline crosses itself: edges %1 and %2 meet near (%3, %4) mm</source>
        <translation>轮廓自相交：边 %1 与边 %2 在 (%3, %4) mm 附近相交</translation>
    </message>
    <message>
        <source>the outline encloses no area</source>
        <translation>轮廓没有围出面积</translation>
    </message>
    <message>
        <source>the unit of length is not known; give it (mm, cm, m or in)</source>
        <translation>长度单位未知；请给出单位（mm、cm、m 或 in）</translation>
    </message>
    <message>
        <source>the file holds no outline</source>
        <translation>文件中没有轮廓</translation>
    </message>
    <message>
        <source>not readable as XML near line %2: %1</source>
        <translation>第 %1 行附近无法作为 XML 读取：%2</translation>
    </message>
    <message>
        <source>elements are nested or used more than %1 levels deep</source>
        <translation>元素嵌套或引用超过 %1 层</translation>
    </message>
    <message>
        <source>not an SVG drawing</source>
        <translation>不是 SVG 图形</translation>
    </message>
    <message>
        <source>line %1: the path data of the drawing are damaged from &quot;%2&quot; on</source>
        <translation>第 %1 行：图形的路径数据从“%2”起已损坏</translation>
    </message>
    <message>
        <source>line %1: &lt;use&gt; draws &quot;%2&quot;, which holds it</source>
        <translation>第 %1 行：&lt;use&gt; 绘制的“%2”包含它自身</translation>
    </message>
    <message>
        <source>the drawing&apos;s size &quot;%1&quot; cannot be used</source>
        <translation>图形尺寸“%1”不可用</translation>
    </message>
    <message>
        <source>the drawing gives its size in pixels, taken as 1/96 inch (0.2646 mm) each; check its size</source>
        <translation>图形尺寸以像素给出，每像素按 1/96 英寸（0.2646 mm）计；请检查尺寸</translation>
    </message>
    <message>
        <source>left out, since they are no outlines: %1</source>
        <translation>以下内容不是轮廓，已略去：%1</translation>
    </message>
    <message>
        <source>the drawing holds more than can be read; save the one outline that is needed</source>
        <translation>图形内容超出可读取的范围；请只保存所需的那个轮廓</translation>
    </message>
    <message>
        <source>the drawing reaches farther than %1 m; check its unit</source>
        <translation>图形范围超过 %1 m；请检查其单位</translation>
    </message>
    <message>
        <source>a path has more than the %1 parts that can be read; simplify it, or save the outline as DXF or CSV</source>
        <translation>某条路径超过可读取的 %1 段；请简化它，或将轮廓存为 DXF 或 CSV</translation>
    </message>
    <message>
        <source>no silhouette found; the picture needs one dark object on a light ground or the reverse</source>
        <translation>未找到剪影；图片中需要浅色背景上的一个深色物体，或深色背景上的一个浅色物体</translation>
    </message>
    <message>
        <source>the silhouette touches the picture&apos;s border; take the picture with a margin all round</source>
        <translation>剪影触及图片边缘；拍摄时请在四周留出边距</translation>
    </message>
    <message>
        <source>not a picture that can be read, or a damaged one</source>
        <translation>不是可读取的图片，或图片已损坏</translation>
    </message>
    <message>
        <source>the scale is %1 pixels per mm; it must be greater than zero</source>
        <translation>比例为每毫米 %1 像素；必须大于零</translation>
    </message>
    <message>
        <source>the scale of the picture is not known; give it in pixels per mm</source>
        <translation>图片的比例未知；请以每毫米像素数给出</translation>
    </message>
    <message>
        <source>%1 harmonics; between %2 and %3 can be used</source>
        <translation>%1 个谐波；可用 %2 至 %3 个</translation>
    </message>
    <message>
        <source>files of type &quot;%1&quot; are not read; known: %2</source>
        <translation>不读取“%1”类型的文件；可用：%2</translation>
    </message>
    <message>
        <source>there is no outline %1; they are numbered from 0 to %2</source>
        <translation>没有轮廓 %1；编号为 0 至 %2</translation>
    </message>
    <message>
        <source>the file holds %1 outlines; the largest is taken</source>
        <translation>文件中有 %1 个轮廓；取最大的一个</translation>
    </message>
    <message>
        <source>holes left out, since they cross or touch something or are more than %2: %1</source>
        <translation>以下孔因相交、接触其他部分或超过 %2 个而略去：%1</translation>
    </message>
    <message>
        <source>the corners of the holes were thinned from %1 to %2, within %3 mm</source>
        <translation>孔的角点由 %1 个精简为 %2 个，误差在 %3 mm 以内</translation>
    </message>
    <message>
        <source>the fitted contour cuts a hole; use more harmonics</source>
        <translation>拟合轮廓切入了孔；请使用更多谐波</translation>
    </message>
    <message>
        <source>%1 holes; there may be %2 at most</source>
        <translation>有 %1 个孔；最多允许 %2 个</translation>
    </message>
    <message>
        <source>the hole does not lie wholly inside the outline</source>
        <translation>孔没有完全位于轮廓之内</translation>
    </message>
    <message>
        <source>the hole meets hole %1 or lies in it, or round it</source>
        <translation>孔与孔 %1 相交，或位于其内，或包围它</translation>
    </message>
    <message>
        <source>silhouettes left out since they touch the picture&apos;s border: %1</source>
        <translation>以下剪影因触及图片边缘而略去：%1</translation>
    </message>
    <message>
        <source>more than one scale is given; give pixels per mm, a known length or a marker</source>
        <translation>给出了不止一种比例；请只给出每毫米像素数、已知长度或标记三者之一</translation>
    </message>
    <message>
        <source>no marker of dictionary %1 is seen; it needs to lie flat in the picture with a light margin</source>
        <translation>未见到字典 %1 的标记；它须平放在画面中，并留有浅色边缘</translation>
    </message>
    <message>
        <source>%1 markers are seen; marker %2, the largest, gives the scale</source>
        <translation>见到 %1 个标记；以最大的标记 %2 确定比例</translation>
    </message>
    <message>
        <source>the marker is only %1 pixels wide; the scale is uncertain below %2</source>
        <translation>标记宽仅 %1 像素；小于 %2 像素时比例不可靠</translation>
    </message>
    <message>
        <source>the outline reaches the horizon of the marker&apos;s plane; look at it more from above</source>
        <translation>轮廓到达了标记平面的地平线；请从更接近正上方的角度拍摄</translation>
    </message>
    <message>
        <source>the fitted contour crosses itself; use more harmonics</source>
        <translation>拟合轮廓自相交；请使用更多谐波</translation>
    </message>
    <message>
        <source>the outline cannot be fitted to %1 mm without crossing itself: with %2 harmonics %3 mm are left</source>
        <translation>轮廓无法在不自相交的情况下拟合到 %1 mm：用 %2 个谐波时仍余 %3 mm</translation>
    </message>
    <message>
        <source>binary DXF is not read; save the drawing as ASCII DXF</source>
        <translation>不读取二进制 DXF；请将图形保存为 ASCII DXF</translation>
    </message>
    <message>
        <source>the drawing is cut off: its end mark (EOF) is missing</source>
        <translation>图形不完整：缺少结束标志（EOF）</translation>
    </message>
    <message>
        <source>the drawing is damaged: what line %1 says cannot be</source>
        <translation>图形已损坏：第 %1 行的内容不合法</translation>
    </message>
    <message>
        <source>block &quot;%1&quot; contains itself</source>
        <translation>块“%1”包含了自身</translation>
    </message>
    <message>
        <source>the drawing names no known unit of length; it is taken as millimetres</source>
        <translation>图形未注明已知的长度单位；按毫米处理</translation>
    </message>
    <message>
        <source>%1 hidden entities were left out (layer off or frozen, invisible, or on paper)</source>
        <translation>略去了 %1 个隐藏的图元（图层已关闭或冻结、不可见，或位于图纸空间）</translation>
    </message>
    <message>
        <source>the outline crosses itself so far that it does not go round %1 % of its area exactly once; at most 1 % is taken, use other harmonics</source>
        <translation>轮廓自相交过多，有 %1 % 的面积不是恰好被环绕一次；最多接受 1 %，请改用其他谐波数</translation>
    </message>
    <message>
        <source>%1 samples, more than the %2 that there may be; take larger steps or a smaller range</source>
        <translation>有 %1 个采样，超过允许的 %2 个；请增大步长或缩小范围</translation>
    </message>
    <message>
        <source>the sampling was cancelled</source>
        <translation>采样已取消</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is an axis and cannot be held as well</source>
        <translation>“%1”是坐标轴，不能同时设为固定</translation>
    </message>
    <message>
        <source>not a Bask session file</source>
        <translation>不是 Bask 会话文件</translation>
    </message>
    <message>
        <source>the session file is damaged: %1</source>
        <translation>会话文件已损坏：%1</translation>
    </message>
    <message>
        <source>the session file is in use: %1</source>
        <translation>会话文件正在使用：%1</translation>
    </message>
    <message>
        <source>not a part of a divided study or field</source>
        <translation>不是拆分的研究或场的一部分</translation>
    </message>
    <message>
        <source>this shard was begun already; go on with --resume, or choose another folder</source>
        <translation>此分片已经开始过；请用 --resume 继续，或另选一个文件夹</translation>
    </message>
    <message>
        <source>another process works on this shard; wait for it, or end it</source>
        <translation>另一个进程正在处理此分片；请等待它完成或结束它</translation>
    </message>
    <message>
        <source>a part of other work: %1 is %2 here and %3 there</source>
        <translation>属于另一项工作：%1 在这里是 %2，在那里是 %3</translation>
    </message>
    <message>
        <source>damaged after %1 whole records; run this shard again with --resume, which keeps these</source>
        <translation>在 %1 条完整记录之后损坏；请用 --resume 重新运行此分片，它会保留这些记录</translation>
    </message>
    <message>
        <source>%1 of %2 cases are not there yet (%3); run these shards with --resume</source>
        <translation>%2 个案例中还缺 %1 个（%3）；请用 --resume 运行这些分片</translation>
    </message>
    <message>
        <source>%1 readings in windows long enough are too few: at least %2 windows of %3 s are needed; record a longer run</source>
        <translation>足够长的窗口内只有 %1 个读数，太少：至少需要 %2 个 %3 s 的窗口；请记录更长的运行</translation>
    </message>
    <message>
        <source>the source was never in view; record a run that heats</source>
        <translation>热源始终不在视野内；请记录一次有加热的运行</translation>
    </message>
    <message>
        <source>the view factor hardly varied (by %1), so heating and cooling cannot be told apart; record a run that moves</source>
        <translation>角系数几乎没有变化（仅 %1），无法区分加热与冷却；请记录一次有运动的运行</translation>
    </message>
    <message>
        <source>the record tells %1 within %2 % only; at most 25 % can be used; record a run that heats and cools more</source>
        <translation>由此记录得到的 %1 不确定度为 %2 %；最多允许 25 %；请记录一次加热和冷却更充分的运行</translation>
    </message>
    <message>
        <source>%1 comes out below zero: the heat balance does not describe this record; check the sensor, the source and the environment&apos;s temperature</source>
        <translation>%1 的结果小于零：热平衡模型与此记录不符；请检查传感器、热源和环境温度</translation>
    </message>
    <message>
        <source>No experiment is loaded. Open one or make a new one.</source>
        <translation>未载入实验。请打开或新建一个实验。</translation>
    </message>
    <message>
        <source>The objects are not at rest at the room&apos;s temperature (%1), so the sensors cannot be zeroed. Let them cool, or correct the environment&apos;s temperature.</source>
        <translation>物体未静置于室温（%1），因此传感器无法校零。请等待冷却，或更正环境温度。</translation>
    </message>
    <message>
        <source>The workspace lets %1 go to %2, but the robot says that it goes to %3 only. Make the workspace smaller, or correct what the robot says.</source>
        <translation>工作空间允许 %1 到 %2，但机器人称其只能到 %3。请缩小工作空间，或更正机器人所报告的限值。</translation>
    </message>
    <message>
        <source>Held by the operator. Resume or stop.</source>
        <translation>由操作员保持。请继续或停止。</translation>
    </message>
    <message>
        <source>The targets cannot be held. See the Targets page.</source>
        <translation>目标无法保持。请见“目标”页面。</translation>
    </message>
    <message>
        <source>The source&apos;s pose is measured again</source>
        <translation>热源位姿已恢复测量</translation>
    </message>
    <message>
        <source>The heat source does not answer: %1. Check its link, then reset.</source>
        <translation>热源无应答：%1。请检查其连接，然后复位。</translation>
    </message>
    <message>
        <source>The recording failed: %1. Free disk space or choose another folder, then reset.</source>
        <translation>记录失败：%1。请释放磁盘空间或另选文件夹，然后复位。</translation>
    </message>
    <message>
        <source>The engine met an internal fault: %1. Reset, and report it if it comes again.</source>
        <translation>引擎发生内部故障：%1。请复位；若再次出现，请报告。</translation>
    </message>
    <message>
        <source>Armed</source>
        <translation>已进入待命</translation>
    </message>
    <message>
        <source>Started</source>
        <translation>已开始</translation>
    </message>
    <message>
        <source>Held</source>
        <translation>已保持</translation>
    </message>
    <message>
        <source>Resumed</source>
        <translation>已继续</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>已停止</translation>
    </message>
    <message>
        <source>STOP pressed</source>
        <translation>已按下“软件停止”</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>已复位</translation>
    </message>
    <message>
        <source>All objects settled</source>
        <translation>所有物体均已稳定</translation>
    </message>
    <message>
        <source>Not settled: %1</source>
        <translation>未稳定：%1</translation>
    </message>
    <message>
        <source>Targets: %1</source>
        <translation>目标：%1</translation>
    </message>
    <message>
        <source>Controller or gains changed</source>
        <translation>控制器或增益已更改</translation>
    </message>
    <message>
        <source>The thermal camera has looked at its shutter: its drift counts from now</source>
        <translation>热像仪已对其快门校正：漂移从现在起计算</translation>
    </message>
    <message>
        <source>Sensors zeroed at ambient</source>
        <translation>传感器已在环境温度下校零</translation>
    </message>
    <message>
        <source>The sensor of &quot;%1&quot; is back</source>
        <translation>“%1”的传感器已恢复</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be done in the state &quot;%2&quot;</source>
        <translation>“%1”不能在状态“%2”下执行</translation>
    </message>
    <message>
        <source>A run is on; stop it first</source>
        <translation>正在运行；请先停止</translation>
    </message>
    <message>
        <source>no part of the picture is clearly of this colour; set a tolerance or take another colour</source>
        <translation>图片中没有明显属于此颜色的部分；请设定容差或另选颜色</translation>
    </message>
    <message>
        <source>the drawing names its unit itself (%1); the unit given is not used</source>
        <translation>图形自身已注明单位（%1）；不使用另行给出的单位</translation>
    </message>
    <message>
        <source>marker %1 is listed twice; each id is one marker</source>
        <translation>标记 %1 列出了两次；每个编号只对应一个标记</translation>
    </message>
    <message>
        <source>none of the markers %1 was seen</source>
        <translation>未见到标记 %1 中的任何一个</translation>
    </message>
    <message>
        <source>marker %1 moved by %2 px while it was looked at; camera, source and end-effector must keep still</source>
        <translation>观测期间标记 %1 移动了 %2 px；相机、热源和末端执行器必须保持不动</translation>
    </message>
    <message>
        <source>no pose shows the markers %1 within %2 px of where they are seen; check their ids, sides and places</source>
        <translation>没有位姿能使标记 %1 与所见位置相差在 %2 px 以内；请检查其编号、边长和位置</translation>
    </message>
    <message>
        <source>marker %1 was left out: it is seen %2 px from where the others put it; check its id and place</source>
        <translation>已剔除标记 %1：其所见位置与由其他标记推算的位置相差 %2 px；请检查其编号和位置</translation>
    </message>
    <message>
        <source>marker %1 is %2 mm wide by the others, not %3 mm; measure the print</source>
        <translation>由其他标记推算，标记 %1 宽 %2 mm，而不是 %3 mm；请测量打印件</translation>
    </message>
    <message>
        <source>the markers are seen %1 px from where they fit best together; the uncertainty is widened accordingly; check their sides and places, and the camera&apos;s calibration</source>
        <translation>标记的所见位置与整体最佳拟合相差 %1 px；不确定度已相应放大；请检查其边长、位置以及相机标定</translation>
    </message>
    <message>
        <source>the markers&apos; corners allow two poses, %1 degrees apart; use more or larger markers, or tilt them against the camera</source>
        <translation>标记角点允许两种位姿，相差 %1 度；请使用更多或更大的标记，或使其相对相机倾斜</translation>
    </message>
    <message>
        <source>the pose is good to %1 mm and %2 degrees (2 sigma)</source>
        <translation>位姿精度为 %1 mm 和 %2 度（2σ）</translation>
    </message>
    <message>
        <source>the pose is good to %1 mm and %2 degrees only (2 sigma), and these markers before this camera allow no better than %3 mm and %4 degrees; use more or larger markers farther apart, tilt them against the camera, or bring it nearer</source>
        <translation>位姿精度仅为 %1 mm 和 %2 度（2σ），而这些标记在此相机前的极限为 %3 mm 和 %4 度；请使用更多或更大、间隔更远的标记，使其相对相机倾斜，或让相机靠近</translation>
    </message>
    <message>
        <source>the pose is good to %1 mm and %2 degrees only (2 sigma), though these markers before this camera allow %3 mm and %4 degrees; check light and focus, that all markers are seen, and their places</source>
        <translation>位姿精度仅为 %1 mm 和 %2 度（2σ），而这些标记在此相机前本可达到 %3 mm 和 %4 度；请检查光照和对焦、是否所有标记都可见以及它们的位置</translation>
    </message>
    <message>
        <source>the end-effector&apos;s markers were seen at %1 poses of the robot; at least %2 are needed</source>
        <translation>仅在机器人的 %1 个位姿下见到末端执行器的标记；至少需要 %2 个</translation>
    </message>
    <message>
        <source>the robot hardly turned (by %1 degrees between poses; %2 are needed): without turns the camera&apos;s place cannot be told from the markers&apos; mounting; turn it about two axes, or measure where the markers sit on the end-effector</source>
        <translation>机器人几乎没有转动（各位姿间仅 %1 度；需要 %2 度）：不转动就无法区分相机位置与标记的安装位置；请使其绕两个轴转动，或测量标记在末端执行器上的位置</translation>
    </message>
    <message>
        <source>the robot turned about one axis only (by %1 degrees about any other; %2 are needed): along that axis the camera&apos;s place cannot be told from the markers&apos; mounting; turn it about a second one, or measure where the markers sit on the end-effector</source>
        <translation>机器人只绕一个轴转动（绕其他任何轴仅 %1 度；需要 %2 度）：沿该轴无法区分相机位置与标记的安装位置；请使其再绕第二个轴转动，或测量标记在末端执行器上的位置</translation>
    </message>
    <message>
        <source>the robot&apos;s poses and the pictures contradict one another; check that each picture was taken at its pose, that the camera kept still, and the markers&apos; sides and places</source>
        <translation>机器人位姿与图像互相矛盾；请检查每张图像是否在对应位姿拍摄、相机是否保持不动，以及标记的边长和位置</translation>
    </message>
    <message>
        <source>pose %1 of the robot was left out: the markers are seen %2 mm and %3 degrees from where the robot has them</source>
        <translation>已剔除机器人位姿 %1：所见标记与机器人给出的位置相差 %2 mm 和 %3 度</translation>
    </message>
    <message>
        <source>camera &quot;%1&quot; is being opened</source>
        <translation>正在打开相机“%1”</translation>
    </message>
    <message>
        <source>camera &quot;%1&quot; cannot be opened (%2); a camera is a number, a device, a video file, a folder of pictures or an address such as rtsp://host/stream</source>
        <translation>无法打开相机“%1”（%2）；相机可以是编号、设备、视频文件、图片文件夹，或 rtsp://host/stream 这样的地址</translation>
    </message>
    <message>
        <source>no picture from camera &quot;%1&quot; for a second (%2); check cable and power. It is taken up again as soon as it answers</source>
        <translation>相机“%1”已有一秒没有图像（%2）；请检查电缆和电源。相机一有应答即恢复使用</translation>
    </message>
    <message>
        <source>the source has markers and is followed by the camera, which is not calibrated yet: calibrate the camera and measure where it stands on the Calibrate page, or leave the source untracked</source>
        <translation>热源上有标记且由相机跟踪，但相机尚未标定：请在“标定”页面标定相机并测量其位置，或不跟踪热源</translation>
    </message>
    <message>
        <source>the robot cannot go there: outside of its workspace, or too near to the source</source>
        <translation>机器人不能到达该处：超出其工作空间，或离热源太近</translation>
    </message>
    <message>
        <source>the calibration was cancelled</source>
        <translation>标定已取消</translation>
    </message>
    <message>
        <source>errors at %3 m are %1 mm across the line of sight and %2 mm along it</source>
        <translation>在 %3 m 处，误差为垂直于视线方向 %1 mm、沿视线方向 %2 mm</translation>
    </message>
    <message>
        <source>errors at %3 m are %1 mm across the line of sight and %2 mm along it; check that the board is flat, measured and sharp in the pictures, and leave out views that stand out</source>
        <translation>在 %3 m 处，误差为垂直于视线方向 %1 mm、沿视线方向 %2 mm；请检查标定板是否平整、是否已测量、图像是否清晰，并剔除离群的视图</translation>
    </message>
    <message>
        <source>errors at %3 m are %1 mm across the line of sight and %2 mm along it; take more views with the board tilted, near the camera and at the picture&apos;s edges</source>
        <translation>在 %3 m 处，误差为垂直于视线方向 %1 mm、沿视线方向 %2 mm；请使标定板倾斜，在相机近处和画面边缘拍摄更多视图</translation>
    </message>
    <message>
        <source>%1 views cannot be checked against one another; take at least %2</source>
        <translation>%1 个视图无法相互校验；请至少拍摄 %2 个</translation>
    </message>
    <message>
        <source>bring the board to the left edge of the picture</source>
        <translation>请将标定板移到画面左边缘</translation>
    </message>
    <message>
        <source>bring the board to the right edge of the picture</source>
        <translation>请将标定板移到画面右边缘</translation>
    </message>
    <message>
        <source>bring the board to the upper edge of the picture</source>
        <translation>请将标定板移到画面上边缘</translation>
    </message>
    <message>
        <source>bring the board to the lower edge of the picture</source>
        <translation>请将标定板移到画面下边缘</translation>
    </message>
    <message>
        <source>bring the board nearer to the camera</source>
        <translation>请将标定板移近相机</translation>
    </message>
    <message>
        <source>tilt the board more, its left or right edge towards the camera</source>
        <translation>请加大标定板倾斜，使其左边缘或右边缘朝向相机</translation>
    </message>
    <message>
        <source>tilt the board more, its upper or lower edge towards the camera</source>
        <translation>请加大标定板倾斜，使其上边缘或下边缘朝向相机</translation>
    </message>
    <message>
        <source>%1 views of %2 that are enough</source>
        <translation>已有 %1 个视图，%2 个即足够</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be opened: %2. Check the cable and the name of the port; Bask tries again by itself.</source>
        <translation>无法打开“%1”：%2。请检查电缆和端口名称；Bask 会自动重试。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; exists and is not a link; choose another path</source>
        <translation>“%1”已存在且不是链接；请另选路径</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is at %2, above its trip limit of %3. The robot takes it away and the heat is off. Check the object and its sensor. Reset when it has cooled.</source>
        <translation>“%1”为 %2，超过其跳闸限值 %3。机器人将其移开，加热已关闭。请检查物体及其传感器。冷却后再复位。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not an axis; axes are X, Y, Z, A, B, C and R</source>
        <translation>“%1”不是轴；轴为 X、Y、Z、A、B、C 和 R</translation>
    </message>
    <message>
        <source>&quot;%1&quot; takes no more bytes: the device does not read. Check its power and the flow control of the port.</source>
        <translation>“%1”不再接收字节：设备没有读取。请检查其电源和端口的流控制。</translation>
    </message>
    <message>
        <source>%1 channels for %2 objects; give each object one</source>
        <translation>%1 个通道对应 %2 个物体；请为每个物体指定一个</translation>
    </message>
    <message>
        <source>%1 is free, but no axis of the robot drives it</source>
        <translation>%1 是自由的，但没有机器人轴驱动它</translation>
    </message>
    <message>
        <source>Bask has just connected to the rig. Check it, then reset.</source>
        <translation>Bask 刚连接到装置。请检查装置，然后复位。</translation>
    </message>
    <message>
        <source>Only %1 MB of disk space are left; a recording needs %2 MB. Free some space, then arm again.</source>
        <translation>磁盘空间仅剩 %1 MB；记录需要 %2 MB。请释放空间，然后重新进入待命。</translation>
    </message>
    <message>
        <source>The robot is held at its own panel (%1). Release it there, then clear the alarm.</source>
        <translation>机器人被其自身面板保持（%1）。请在面板上解除，然后清除报警。</translation>
    </message>
    <message>
        <source>The robot is switched off at its own controller. Enable it, then clear the alarm.</source>
        <translation>机器人在其自身控制器上被关闭。请启用它，然后清除报警。</translation>
    </message>
    <message>
        <source>The robot reports alarm %1: %2. Remove the cause and clear the alarm. Home the robot if its place is not sure.</source>
        <translation>机器人报出报警 %1：%2。请排除原因并清除报警。若其位置不确定，请使机器人回零。</translation>
    </message>
    <message>
        <source>The robot&apos;s controller has restarted: its last order is lost and its place is not sure. Home it, or confirm its place, then reset.</source>
        <translation>机器人控制器已重启：先前的指令已失效，位置不确定。请使其回零或确认其位置，然后复位。</translation>
    </message>
    <message>
        <source>The source is at %1, above its trip limit of %2. The robot takes the objects away and the heat is off. Check the source&apos;s controller and sensor. Reset when it has cooled.</source>
        <translation>热源为 %1，超过其跳闸限值 %2。机器人将物体移开，加热已关闭。请检查热源的控制器和传感器。冷却后再复位。</translation>
    </message>
    <message>
        <source>The source is at %1 and has come no nearer to %2 for %3 s. The heat is off. Check that the source is switched on and that its sensor is in place, then reset.</source>
        <translation>热源为 %1，已有 %3 s 未向 %2 接近。加热已关闭。请检查热源是否通电、其传感器是否到位，然后复位。</translation>
    </message>
    <message>
        <source>The source was set to %1 but reads back %2. Bask switches the heat off. Check its own panel and limits, then reset.</source>
        <translation>热源被设为 %1，回读却为 %2。Bask 将关闭加热。请检查其自身面板和限值，然后复位。</translation>
    </message>
    <message>
        <source>a step of the robot would leave its workspace or come too near to the source; it was not sent</source>
        <translation>机器人的某一步会离开其工作空间或离热源太近；该步未发送</translation>
    </message>
    <message>
        <source>faults can be simulated on the simulated rig only</source>
        <translation>只能在仿真装置上模拟故障</translation>
    </message>
    <message>
        <source>over: %1</source>
        <translation>已解除：%1</translation>
    </message>
    <message>
        <source>the axis %1 is given twice</source>
        <translation>轴 %1 出现了两次</translation>
    </message>
    <message>
        <source>the device on &quot;%1&quot; has not answered for %2 s. Check its power, the cable, and the speed and unit set for it.</source>
        <translation>“%1”上的设备已有 %2 s 没有应答。请检查其电源、电缆，以及所设的速率和单元地址。</translation>
    </message>
    <message>
        <source>the device on &quot;%1&quot; is not the one that is set: it says &quot;%2&quot;. Check the port and the driver.</source>
        <translation>“%1”上的设备不是所设的设备：它回报“%2”。请检查端口和驱动。</translation>
    </message>
    <message>
        <source>the experiment has no rig of its own (&quot;rig&quot;), only the simulated one</source>
        <translation>实验没有自己的装置（“rig”），只有仿真装置</translation>
    </message>
    <message>
        <source>the link to &quot;%1&quot; was lost: %2. Check the cable; Bask opens it again as soon as it is there.</source>
        <translation>与“%1”的连接已断开：%2。请检查电缆；一旦恢复，Bask 会立即重新打开。</translation>
    </message>
    <message>
        <source>the profile &quot;%1&quot; is that of another kind of device</source>
        <translation>配置文件“%1”属于另一类设备</translation>
    </message>
    <message>
        <source>the rig has no %1; set one, or use the simulated rig</source>
        <translation>装置缺少%1；请设置，或使用仿真装置</translation>
    </message>
    <message>
        <source>the robot has no axis</source>
        <translation>机器人没有轴</translation>
    </message>
    <message>
        <source>this robot has no homing</source>
        <translation>此机器人没有回零功能</translation>
    </message>
    <message>
        <source>two axes drive %1</source>
        <translation>两个轴驱动 %1</translation>
    </message>
    <message>
        <source>two devices are on &quot;%1&quot;; only Modbus devices of different units and the same line settings can share a port</source>
        <translation>“%1”上有两个设备；只有单元地址不同且线路设置相同的 Modbus 设备才能共用端口</translation>
    </message>
    <message>
        <source>two objects have channel %1; give each its own</source>
        <translation>两个物体都用通道 %1；请为每个物体指定各自的通道</translation>
    </message>
    <message>
        <source>unit %2 on &quot;%1&quot; refuses the request with exception %3. Check the profile set for it.</source>
        <translation>“%1”上的单元 %2 以异常 %3 拒绝了请求。请检查所设的配置文件。</translation>
    </message>
    <message>
        <source>The heat source did not obey the order to switch off. Switch it off at its mains. Its answer: %1</source>
        <translation>热源没有执行关闭指令。请切断其总电源。它的应答：%1</translation>
    </message>
    <message>
        <source>The heat source has reported no temperature for %1 s. The heat is off. Check its sensor and its link, then reset.</source>
        <translation>热源已有 %1 s 没有给出温度。加热已关闭。请检查其传感器和连接，然后复位。</translation>
    </message>
    <message>
        <source>The source is heated manually and is at %1: Bask cannot switch it off. Switch it off yourself, and keep the objects away from it.</source>
        <translation>热源由人工加热，当前 %1：Bask 无法将其关闭。请您自行关闭，并使物体远离它。</translation>
    </message>
    <message>
        <source>The temperature of &quot;%1&quot; should have changed by %2 in %3 s but has not. Its sensor may be off, the object may be gone, or the source may be elsewhere than expected. Bask switches the heat off. Check all three, then reset.</source>
        <translation>“%1”的温度本应在 %3 s 内变化 %2，却没有变化。可能是传感器脱落、物体缺失，或热源不在预想的位置。Bask 将关闭加热。请检查这三项，然后复位。</translation>
    </message>
    <message>
        <source>The target of &quot;%1&quot;, %2, is above its warning limit of %3, where every run holds. Lower the target, or raise the limit if object and sensor bear it.</source>
        <translation>“%1”的目标 %2 高于其警告限值 %3，每次运行都会在此保持。请降低目标；若物体和传感器能承受，也可提高限值。</translation>
    </message>
    <message>
        <source>The source is still at %1, %2 s after its heat was switched off. Switch it off at its mains, then reset.</source>
        <translation>热源在关闭加热 %2 s 后仍为 %1。请切断其总电源，然后复位。</translation>
    </message>
    <message>
        <source>The robot refused a line with error %1: %2. Remove the cause, clear the alarm, then reset.</source>
        <translation>机器人以错误 %1 拒绝了一行指令：%2。请排除原因，清除报警，然后复位。</translation>
    </message>
    <message>
        <source>The robot has not reported its state yet. Wait a moment. If this lasts, check its power, its link and the driver set for it.</source>
        <translation>机器人尚未回报状态。请稍候。若一直如此，请检查其电源、连接和所设的驱动。</translation>
    </message>
    <message>
        <source>the device on &quot;%1&quot; gave an answer that does not fit the question: %2. The answer was not used. Check the settings of the port, and of the device itself.</source>
        <translation>“%1”上的设备所答非所问：%2。该应答未被使用。请检查端口和设备本身的设置。</translation>
    </message>
    <message>
        <source>No pose in the workspace holds all targets together; going to the best compromise found, expected to end at %1 of the targets. The Targets page shows what can be held.</source>
        <translation>工作空间中没有能同时保持所有目标的位姿；将前往所找到的最佳折中处，预计最终与目标的偏差为 %1。可保持的目标见“目标”页面。</translation>
    </message>
    <message>
        <source>The heat source was stopped at its own panel or by its own protection; Bask keeps it off. Find the cause, then reset.</source>
        <translation>热源被其自身面板或自身保护停止；Bask 使其保持关闭。请查明原因，然后复位。</translation>
    </message>
    <message>
        <source>with the profile &quot;%1&quot; the source has no watchdog: it stays hot when Bask or the computer dies. Take a controller that has one, or allow it with &quot;unattended_heat&quot;: true.</source>
        <translation>使用配置文件“%1”时热源没有看门狗：Bask 或计算机停止运行后它会一直发热。请使用带看门狗的控制器，或以 &quot;unattended_heat&quot;: true 允许这样做。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; and &quot;%2&quot; are far from the source but differ by %3, more than %4. One sensor is wrong or off its object. Check both.</source>
        <translation>“%1”与“%2”远离热源，却相差 %3，超过 %4。某个传感器有误或脱离了物体。请检查两者。</translation>
    </message>
    <message>
        <source>The control loop was delayed by %1 s, more than the allowed %2 s; the robot stood still. Close other programs on this computer.</source>
        <translation>控制回路被延误 %1 s，超过允许的 %2 s；机器人已静止。请关闭此计算机上的其他程序。</translation>
    </message>
    <message>
        <source>The robot is %1 mm from where its steps should have brought it, more than %2 mm. It may have been pushed or have lost steps: check it, home it, then reset.</source>
        <translation>机器人与按步进应到的位置相差 %1 mm，超过 %2 mm。它可能被推动过或丢步：请检查并回零，然后复位。</translation>
    </message>
    <message>
        <source>The robot&apos;s place is not sure: Bask has not seen it homed since it connected, or its place was lost in a restart or a stop. Home it, or confirm its place.</source>
        <translation>机器人的位置不确定：自连接以来 Bask 未见其回零，或其位置在重启或停止时丢失。请使其回零，或确认其位置。</translation>
    </message>
    <message>
        <source>The source warmed by %1 in %2 s although its heat is off; at most %3 is allowed. Its relay may be stuck, or somebody heats it at its own panel. Switch it off at its mains, then reset.</source>
        <translation>加热已关闭，热源却在 %2 s 内升温 %1；最多允许 %3。可能是其继电器粘连，或有人在其面板上加热。请切断其总电源，然后复位。</translation>
    </message>
    <message>
        <source>The sensor of &quot;%1&quot; jumped by %2/s; heat can change it by at most %3/s. Check for a loose contact, and that the sensor is on its object. Bask uses it again when it agrees with the heat, or when a person confirms it.</source>
        <translation>“%1”的传感器跳变 %2/s；受热最多只能变化 %3/s。请检查是否接触不良、传感器是否在物体上。待其与受热情况相符或经人确认后，Bask 才重新使用它。</translation>
    </message>
    <message>
        <source>The sensor of &quot;%1&quot; reads %2, but after the heat that its object received the object should be at %3 to %4. Check that the sensor is on its object, then confirm it.</source>
        <translation>“%1”的传感器读数为 %2，但按其物体的受热情况，物体应为 %3 至 %4。请检查传感器是否在物体上，然后确认。</translation>
    </message>
    <message>
        <source>The sensor of &quot;%1&quot; has given exactly the same value for %2 s, without its usual noise: it may have stopped. Watch whether it follows the heat, or confirm it.</source>
        <translation>“%1”的传感器在 %2 s 内一直给出完全相同的值，没有平常的噪声：可能已停止工作。请观察它是否跟随受热变化，或确认它。</translation>
    </message>
    <message>
        <source>The temperature of &quot;%1&quot; has changed by %2 in %3 s, which no heat or loss explains. Its sensor may be off, or something touches the object. Bask switches the heat off. Check both, then reset.</source>
        <translation>“%1”的温度在 %3 s 内变化了 %2，任何加热或散热都无法解释。其传感器可能已脱落，或有东西接触物体。Bask 将关闭加热。请检查两者，然后复位。</translation>
    </message>
    <message>
        <source>Another Bask runs with the same settings. The alarms of this one are kept in %1.</source>
        <translation>另一个 Bask 正以相同的设置运行。本程序的报警保存在 %1 中。</translation>
    </message>
    <message>
        <source>The sensor of &quot;%1&quot; is confirmed at %2</source>
        <translation>“%1”的传感器已确认为 %2</translation>
    </message>
    <message>
        <source>The heat source has no watchdog: if this computer stops, it stays hot. Do not leave it unattended.</source>
        <translation>热源没有看门狗：若本计算机停机，热源仍保持高温。请勿无人看管。</translation>
    </message>
    <message>
        <source>No heat without the guard process, which switches the heater off if Bask dies; it cannot be started: %1. Install Bask again.</source>
        <translation>没有守护进程就不加热：它在 Bask 异常终止时关闭加热器；无法启动它：%1。请重新安装 Bask。</translation>
    </message>
    <message>
        <source>The guard process has taken the heater over and switches it off: %1. Its log says what it did. Find the cause, then reset.</source>
        <translation>守护进程已接管加热器并将其关闭：%1。其日志说明了所做的操作。请查明原因，然后复位。</translation>
    </message>
    <message>
        <source>The heater&apos;s guard process has ended; Bask has taken the port back and switches the heat off. Reset starts a new guard.</source>
        <translation>加热器的守护进程已终止；Bask 已收回端口并关闭加热。“复位”会启动新的守护进程。</translation>
    </message>
    <message>
        <source>The sensor of &quot;%1&quot; has given nothing new for %2 s. Check its cable.</source>
        <translation>“%1”的传感器在 %2 s 内没有给出新值。请检查其电缆。</translation>
    </message>
    <message>
        <source>The sensor of &quot;%1&quot; gives no plausible value: a broken wire, a loose contact, or another device than was set up. Check it.</source>
        <translation>“%1”的传感器给出的值不合理：导线断开、接触不良，或不是所设置的设备。请检查。</translation>
    </message>
    <message>
        <source>The source&apos;s pose is not measured any more. Bring the source back into view.</source>
        <translation>不再测得热源的位姿。请使热源回到视野中。</translation>
    </message>
    <message>
        <source>Held by the engine: %1</source>
        <translation>由引擎保持：%1</translation>
    </message>
    <message>
        <source>Ended by the engine: %1</source>
        <translation>由引擎结束：%1</translation>
    </message>
    <message>
        <source>Retreat: the heat is off, the robot takes the objects away</source>
        <translation>撤离：加热关闭，机器人将物体移开</translation>
    </message>
    <message>
        <source>The robot takes the objects away by itself: %1</source>
        <translation>机器人自行将物体移开：%1</translation>
    </message>
    <message>
        <source>Held for more than %1 s without a reading of &quot;%2&quot;: the run is ended</source>
        <translation>无“%2”的读数保持超过 %1 s：运行结束</translation>
    </message>
    <message>
        <source>Held for more than %1 s without the source&apos;s pose: the run is ended</source>
        <translation>无热源位姿保持超过 %1 s：运行结束</translation>
    </message>
    <message>
        <source>The robot stops</source>
        <translation>机器人停止</translation>
    </message>
    <message>
        <source>The run ends, with a retreat and the heat off</source>
        <translation>运行结束，撤离并关闭加热</translation>
    </message>
    <message>
        <source>The heat is switched off</source>
        <translation>加热被关闭</translation>
    </message>
    <message>
        <source>The robot takes the objects away from the source</source>
        <translation>机器人使物体离开热源</translation>
    </message>
    <message>
        <source>Reset when the rig is safe.</source>
        <translation>确认装置安全后复位。</translation>
    </message>
    <message>
        <source>Reset is possible when this is over: %1</source>
        <translation>待此情况消除后方可复位：%1</translation>
    </message>
    <message>
        <source>Keep your hands off the robot and press Retreat: it takes the objects away from the heat.</source>
        <translation>手勿靠近机器人，按“撤离”：机器人会使物体离开热源。</translation>
    </message>
    <message>
        <source>Resume, or stop the run.</source>
        <translation>请继续或停止运行。</translation>
    </message>
    <message>
        <source>Resume is possible when this is over; Stop ends the run: %1</source>
        <translation>待此情况消除后方可继续；“停止”结束运行：%1</translation>
    </message>
    <message>
        <source>an alarm is shelved with a reason; say why</source>
        <translation>搁置报警需要理由；请说明原因</translation>
    </message>
    <message>
        <source>%1: %3 instead of %2</source>
        <translation>%1：%3，而非 %2</translation>
    </message>
    <message>
        <source>this allows the real rig more than before: %1. Whether robot, source, objects and sensors bear it is for a person to say</source>
        <translation>这将允许实机装置超出以前的范围：%1。机器人、热源、物体和传感器能否承受，须由人来判断</translation>
    </message>
    <message>
        <source>The robot was ordered to take the objects away but does not move; %1 cm are left. The heat is off. Take the objects away by hand; they may be hot. Check the robot&apos;s power and its drives.</source>
        <translation>已令机器人将物体移开，但它不动；还剩 %1 cm。加热已关闭。请用手移开物体，物体可能很烫。请检查机器人的电源和驱动。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is at %2, above its warning limit of %3. Let it cool: Stop or Retreat takes it away. Check its target and its limits.</source>
        <translation>“%1”为 %2，超过其警告限值 %3。请让它冷却：“停止”或“撤离”会将其移开。请检查其目标和限值。</translation>
    </message>
    <message>
        <source>The sensor of &quot;%1&quot; is open: a wire or the plug is off. Repair it.</source>
        <translation>“%1”的传感器开路：导线或插头脱落。请修好。</translation>
    </message>
    <message>
        <source>The sensor of &quot;%1&quot; is shorted. Check its wires and its plug, and repair it.</source>
        <translation>“%1”的传感器短路。请检查其导线和插头并修好。</translation>
    </message>
    <message>
        <source>The sensor of &quot;%1&quot; has given exactly the same value for %2 s: the sensor or its device has stopped. Check both.</source>
        <translation>“%1”的传感器在 %2 s 内一直给出完全相同的值：传感器或其设备已停止工作。请检查两者。</translation>
    </message>
    <message>
        <source>The heat source reports %1, more than %3 below the room&apos;s %2. It may use another unit (°C, °F) than its profile says, or its sensor is wrong. It is not heated. Set both to the same unit, then reset.</source>
        <translation>热源报告 %1，比室温 %2 低 %3 以上。它使用的单位（°C、°F）可能与其配置文件不同，或其传感器有误。不对它加热。请把两者设为同一单位，然后复位。</translation>
    </message>
    <message>
        <source>The heat source reports %1 °C instead of %2 °C. This is the same number in °F: it uses another unit than its profile says. It is not heated. Set both to the same unit, then reset.</source>
        <translation>热源报告 %1 °C，而不是 %2 °C。这正是以 °F 表示的同一数值：它使用的单位与其配置文件不同。不对它加热。请把两者设为同一单位，然后复位。</translation>
    </message>
    <message>
        <source>The computer was suspended for %1 s while the source was hot or the robot moved. What happened meanwhile is not known. The heat is off. Check the rig, then reset.</source>
        <translation>计算机在热源加热或机器人运动时休眠了 %1 s。其间发生了什么并不清楚。加热已关闭。请检查装置，然后复位。</translation>
    </message>
    <message>
        <source>The computer was suspended for %1 s</source>
        <translation>计算机休眠了 %1 s</translation>
    </message>
    <message>
        <source>This computer cannot be kept awake while heat is on (%1): switch off its standby, and keep its lid open</source>
        <translation>加热期间无法让这台计算机保持唤醒（%1）：请关闭其待机功能，并保持机盖打开</translation>
    </message>
    <message>
        <source>The device that answers at %1 is the right one from now on</source>
        <translation>从现在起，在 %1 应答的设备就是正确的设备</translation>
    </message>
    <message>
        <source>Another device than before answers at %1: it was &quot;%2&quot; and is &quot;%3&quot;. Nothing is written to it. Put the plugs right, or say on the Rig page that this is the one.</source>
        <translation>在 %1 应答的设备与以前不同：原为“%2”，现为“%3”。不会向它写入任何内容。请把插头接对，或在“装置”页上说明就是这台。</translation>
    </message>
    <message>
        <source>The heat of the real rig (%1) is not known to be off, and Bask no longer watches it. Check the plate, and switch it off at its mains.</source>
        <translation>实际装置（%1）的加热不能确定已关闭，Bask 也不再监视它。请检查热板，并切断其电源。</translation>
    </message>
    <message>
        <source>The sensor of &quot;%1&quot; reads %2 and did not follow its object&apos;s heat. Check that the sensor is on its object, then confirm it.</source>
        <translation>“%1”的传感器读数为 %2，且没有跟随其物体的受热。请检查传感器是否在物体上，然后确认。</translation>
    </message>
    <message>
        <source>what the air takes is unknown and not counted: in air objects settle colder than told here; state the convection of the air in the experiment</source>
        <translation>空气带走的热量未知，未计入：在空气中物体的稳态温度会低于此处所示；请在实验中说明空气的对流</translation>
    </message>
    <message>
        <source>this record cannot tell radiation from what the air takes: only the loss of both together and its slope at %1 are certain; state the convection of the air in the experiment, or record wide temperatures</source>
        <translation>此记录无法区分辐射与空气带走的热量：只有两者合计的损失及其在 %1 处的斜率是确定的；请在实验中说明空气的对流，或记录更宽的温度范围</translation>
    </message>
    <message>
        <source>%1 takes %2 % of the light of %3 at the start pose</source>
        <translation>在起始位姿，%1 挡住 %3 的 %2 % 的光</translation>
    </message>
    <message>
        <source>%1 takes %2 % of the light of %3 at this pose</source>
        <translation>在此位姿，%1 挡住 %3 的 %2 % 的光</translation>
    </message>
    <message>
        <source>the list is empty; leave it out for a source that is even</source>
        <translation>列表为空；热源均匀时请省略它</translation>
    </message>
    <message>
        <source>this part of the source overlaps %1; parts may touch but not cover one another</source>
        <translation>热源的这一部分与 %1 重叠；各部分可以相接，但不能互相覆盖</translation>
    </message>
    <message>
        <source>this part reaches %1 mm beyond the source&apos;s contour; move it or make the contour larger</source>
        <translation>这一部分超出热源轮廓 %1 mm；请移动它或扩大轮廓</translation>
    </message>
    <message>
        <source>this part stands %1 mm out of the source&apos;s plane, from which clearances are measured; lower it, or move the source&apos;s pose up</source>
        <translation>这一部分高出热源平面 %1 mm，而安全距离从该平面量起；请降低它，或上移热源的位姿</translation>
    </message>
    <message>
        <source>this part of the source stands on edge or faces away; tilt it by less than 89 degrees</source>
        <translation>热源的这一部分侧立或背向；倾斜角须小于 89 度</translation>
    </message>
    <message>
        <source>this part lies in front of %1; what parts of a source hide from one another is not computed</source>
        <translation>这一部分位于 %1 前方；热源各部分之间的遮挡不作计算</translation>
    </message>
    <message>
        <source>the radii must grow, but %1 mm comes after %2 mm</source>
        <translation>半径必须递增，但 %2 mm 之后是 %1 mm</translation>
    </message>
    <message>
        <source>a radial profile needs a source whose contour is a disk without holes</source>
        <translation>径向分布要求热源轮廓为无孔圆盘</translation>
    </message>
    <message>
        <source>the first line must name two columns: the radius (radius_mm, radius_cm or radius_m) and temperature_ratio or temperature_offset_K</source>
        <translation>第一行必须给出两列的名称：半径（radius_mm、radius_cm 或 radius_m）以及 temperature_ratio 或 temperature_offset_K</translation>
    </message>
    <message>
        <source>line %1: two numbers expected, &quot;%2&quot; found</source>
        <translation>第 %1 行：应为两个数，实为“%2”</translation>
    </message>
    <message>
        <source>the name &quot;%1&quot; is used twice; give each object, fixture and shield its own</source>
        <translation>名称“%1”用了两次；请给每个物体、夹具和遮板不同的名称</translation>
    </message>
    <message>
        <source>every object, fixture and shield needs a name</source>
        <translation>每个物体、夹具和遮板都需要名称</translation>
    </message>
    <message>
        <source>at the start &quot;%1&quot; is %2 mm from the source plane; at least %3 mm are needed, since the shield &quot;%4&quot; reaches up to %5 mm and everything held stays above it</source>
        <translation>在起始位姿，“%1”距热源平面 %2 mm；至少需要 %3 mm，因为遮板“%4”高达 %5 mm，所有被夹持的物件都须保持在其上方</translation>
    </message>
    <message>
        <source>the lowest point of this shield is %1 mm over the source plane; at least %2 mm are needed</source>
        <translation>此遮板的最低点在热源平面上方 %1 mm；至少需要 %2 mm</translation>
    </message>
    <message>
        <source>the camera&apos;s pose in the robot&apos;s base is not known</source>
        <translation>相机在机器人基座中的位姿未知</translation>
    </message>
    <message>
        <source>the robot&apos;s place is not sure, so nobody knows where in the picture it is</source>
        <translation>机器人的位置不确定，因此无从得知它在图像中的何处</translation>
    </message>
    <message>
        <source>the camera is not zeroed on it; it has to see the object as cold as the room, before any heat</source>
        <translation>相机尚未在它上面校零；须在任何加热之前看到该物体与室内一样冷</translation>
    </message>
    <message>
        <source>its face reflects the source, whose temperature is not known</source>
        <translation>其表面反射热源，而热源的温度未知</translation>
    </message>
    <message>
        <source>it is above %1, where the camera&apos;s numbers are known to be wrong</source>
        <translation>它高于 %1，已知相机的数值在那里有误</translation>
    </message>
    <message>
        <source>the camera&apos;s last picture is %1 s old</source>
        <translation>相机最近一幅图像已过去 %1 s</translation>
    </message>
    <message>
        <source>the lens model has no line of sight for some pixels; calibrate the camera again</source>
        <translation>镜头模型对某些像素没有视线；请重新标定相机</translation>
    </message>
    <message>
        <source>no pictures of a thermal camera were recorded; set sampling.thermal_frame_period_s before a run</source>
        <translation>没有记录热像仪的图像；请在运行前设定 sampling.thermal_frame_period_s</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is to be read by a thermal camera, and the rig has none; give the rig one, or read the object by &quot;contact&quot;</source>
        <translation>“%1”要由热像仪读取，而装置没有热像仪；请为装置配一台，或以“contact”读取该物体</translation>
    </message>
    <message>
        <source>The sensors of &quot;%1&quot; and &quot;%2&quot; seem to be swapped: within the last %3 s their readings changed as if each were on the other object, as the thermal camera sees both. The heat is off. Check both, confirm them, then reset.</source>
        <translation>“%1”和“%2”的传感器似乎互换了：在最近 %3 s 内，从热像仪看，它们读数的变化如同各自在另一物体上。加热已关闭。请检查两者，确认它们，然后复位。</translation>
    </message>
    <message>
        <source>The sensor of &quot;%1&quot; reads %2, but the thermal camera sees the object at %3, within %4, and no emittance explains that. The sensor may be off its object. The heat is off. Fasten the sensor, confirm it, then reset.</source>
        <translation>“%1”的传感器读数为 %2，而热像仪看到该物体为 %3（误差在 %4 以内），没有任何发射率能解释。传感器可能已从物体上脱落。加热已关闭。请固定传感器并确认，然后复位。</translation>
    </message>
    <message>
        <source>The sensor of &quot;%1&quot; reads %2, but the thermal camera sees the object at %3, within %4; both agreed %5 s ago. The sensor has come off its object. The heat is off. Fasten the sensor, confirm it, then reset.</source>
        <translation>“%1”的传感器读数为 %2，而热像仪看到该物体为 %3（误差在 %4 以内）；%5 s 前两者还相符。传感器已从物体上脱落。加热已关闭。请固定传感器并确认，然后复位。</translation>
    </message>
    <message>
        <source>The thermal camera cannot read &quot;%1&quot;: %2.</source>
        <translation>热像仪无法读取“%1”：%2。</translation>
    </message>
    <message>
        <source>The thermal camera sees &quot;%1&quot; at %2, within %3, but its sensor reads %4. Both agree if the emittance of its face is %5 instead of %6. Measure the emittance, and check that the sensor is fastened well.</source>
        <translation>热像仪看到“%1”为 %2（误差在 %3 以内），而其传感器读数为 %4。若其表面的发射率为 %5 而不是 %6，两者就相符。请测量发射率，并检查传感器是否固定好。</translation>
    </message>
    <message>
        <source>The thermal camera sees &quot;%1&quot; at %2, within %3, but its sensor reads %4. Check the sensor, that nothing is before the camera, and that the camera has not been moved.</source>
        <translation>热像仪看到“%1”为 %2（误差在 %3 以内），而其传感器读数为 %4。请检查传感器，相机前有没有东西，以及相机是否被移动过。</translation>
    </message>
    <message>
        <source>The thermal camera cannot check the sensor of &quot;%1&quot;: %2.</source>
        <translation>热像仪无法核对“%1”的传感器：%2。</translation>
    </message>
    <message>
        <source>A step of the robot took over twice its time and was stopped. Its controller&apos;s rates ($110 to $115) or accelerations ($120 to $125) are too small for the largest speed of the experiment, or it is blocked. Check both, then reset.</source>
        <translation>机器人的某一步所用时间超过其两倍，已令其停止。其控制器的速率（$110 至 $115）或加速度（$120 至 $125）对实验的最大速度来说太小，或机器人受阻。请检查这两项，然后复位。</translation>
    </message>
    <message>
        <source>The robot cannot follow the largest speed of the experiment, because its controller has %1: a step takes %2 s instead of %3 s, and a retreat up to %4 s. Raise that setting, or set a smaller largest speed.</source>
        <translation>机器人跟不上实验的最大速度，因为其控制器的设置为 %1：一步需要 %2 s 而不是 %3 s，撤离最长需要 %4 s。请增大该设置，或设定较小的最大速度。</translation>
    </message>
    <message>
        <source>the program &quot;%1&quot; was not confirmed on this computer, or has changed since. Bask does not start it. Look at it, then confirm it on the Rig page, or allow it with --allow-program where there is no window.</source>
        <translation>程序“%1”未在本计算机上确认，或此后已改变。Bask 不启动它。请查看它，然后在“装置”页确认；没有窗口时用 --allow-program 允许。</translation>
    </message>
    <message>
        <source>the program &quot;%1&quot; cannot be started: %2. Check its command on the Rig page.</source>
        <translation>程序“%1”无法启动：%2。请在“装置”页检查其命令。</translation>
    </message>
    <message>
        <source>the program &quot;%1&quot; has ended: %2. Bask starts it again. If it ends again, try it with &quot;bask check-device&quot;.</source>
        <translation>程序“%1”已结束：%2。Bask 会重新启动它。若再次结束，请用 &quot;bask check-device&quot; 检验。</translation>
    </message>
    <message>
        <source>Bask has ended the program &quot;%1&quot;: %2. It starts it again. If this happens again, try it with &quot;bask check-device&quot;.</source>
        <translation>Bask 已结束程序“%1”：%2。它会重新启动该程序。若再次发生，请用 &quot;bask check-device&quot; 检验。</translation>
    </message>
    <message>
        <source>the program &quot;%1&quot; has not answered for %2 s. Check the device behind it and its link.</source>
        <translation>程序“%1”已有 %2 s 未应答。请检查其后的设备及连接。</translation>
    </message>
    <message>
        <source>the program &quot;%1&quot; does not fit the rig: %2. Change the program, or the device on the Rig page.</source>
        <translation>程序“%1”与装置不符：%2。请更改程序，或在“装置”页更改设备。</translation>
    </message>
    <message>
        <source>the program &quot;%1&quot; refuses a command: %2. Remove the cause, clear the alarm of a robot, then reset.</source>
        <translation>程序“%1”拒绝命令：%2。请消除原因，清除机器人的警报，然后复位。</translation>
    </message>
    <message>
        <source>The robot does not move: %1. Remove the cause, clear the alarm, then reset.</source>
        <translation>机器人不动：%1。请消除原因，清除警报，然后复位。</translation>
    </message>
    <message>
        <source>The program &quot;%1&quot; is confirmed on this computer</source>
        <translation>程序“%1”已在本计算机上确认</translation>
    </message>
    <message>
        <source>the link to &quot;%1&quot; is in the hands of a person at the console: Bask takes it back 3 s after the last that is sent by hand.</source>
        <translation>与“%1”的链路正由控制台前的人使用：最后一次手动发送 3 s 后，Bask 取回它。</translation>
    </message>
    <message>
        <source>The source was set to %1 but reads back %2, which is %3 times that: its numbers mean something else than its profile says. It is not heated. Set device and profile to the same scale, then reset.</source>
        <translation>热源设定为 %1，但读回 %2，是设定值的 %3 倍：它的数值含义与其配置文件所述不同。不对它加热。请使设备与配置文件的比例一致，然后复位。</translation>
    </message>
    <message>
        <source>Sent by hand to &quot;%1&quot;: %2</source>
        <translation>手动发送到“%1”：%2</translation>
    </message>
    <message>
        <source>monitoring: the broker %1 is not reached: %2</source>
        <translation>监视：无法连接到代理 %1：%2</translation>
    </message>
    <message>
        <source>monitoring: the broker %1 is too slow; %2 messages were left out</source>
        <translation>监视：代理 %1 太慢；有 %2 条消息未发送</translation>
    </message>
    <message>
        <source>monitoring: the status file is not written: %1</source>
        <translation>监视：状态文件未写入：%1</translation>
    </message>
    <message>
        <source>others can read this file, which holds a password; let its owner alone read it (chmod 600)</source>
        <translation>其他人可以读取这个含有密码的文件；请只让其所有者读取（chmod 600）</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no address of a broker; give its name, with a colon and the port if that is not the usual one</source>
        <translation>“%1”不是代理的地址；请给出其名称，若端口不是通常的端口，再加冒号和端口</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no topic: letters, digits, dots, hyphens and underscores in parts between slashes, at most 128 characters</source>
        <translation>“%1”不是主题：由斜杠分隔的各部分只能含字母、数字、点、连字符和下划线，最多 128 个字符</translation>
    </message>
    <message>
        <source>this installation of Bask cannot speak to a broker: %1</source>
        <translation>此 Bask 安装无法与代理通信：%1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no date; write year, month and day as in 2026-11-23</source>
        <translation>“%1”不是日期；请按 2026-11-23 的形式写出年、月、日</translation>
    </message>
    <message>
        <source>two materials are named &quot;%1&quot;; give each its own name</source>
        <translation>两种材料都名为“%1”；请给每种各自的名称</translation>
    </message>
    <message>
        <source>The sensors of &quot;%1&quot; and &quot;%2&quot; were exchanged: they read %3 and %4 where %5 and %6 were expected. The heat is off. See that each is on its own object, confirm both, then reset.</source>
        <translation>“%1”和“%2”的传感器已互换：读数为 %3 和 %4，而预期为 %5 和 %6。加热已关闭。请确认每个传感器都在自己的物体上，分别确认两者，然后复位。</translation>
    </message>
    <message>
        <source>The objects are cold: the recording ends</source>
        <translation>物体均已冷却：记录结束</translation>
    </message>
    <message>
        <source>The recording after the run has ended before all was cold: the experiment was changed, another one was opened, a person has heated the source, or 6 h have passed.</source>
        <translation>运行之后的记录在一切冷却之前已结束：实验被修改、打开了另一个实验、有人手动加热了热源，或已过 6 h。</translation>
    </message>
    <message>
        <source>the thermal camera&apos;s place is not known well enough for so small an object; measure it on the Calibrate page, Place</source>
        <translation>对于这么小的物体，热像仪的位置不够准确；请在“标定”页的“位置”中测量</translation>
    </message>
    <message>
        <source>The target of &quot;%1&quot;, %2, is not what the thermal camera that reads it can tell: %3 to %4 with this emittance. Change the target, or let a sensor read the object.</source>
        <translation>“%1”的目标 %2 不在读取它的热像仪所能测的范围内：以此发射率为 %3 至 %4。请更改目标，或改用传感器读取该物体。</translation>
    </message>
    <message>
        <source>Ready in %1 s: the first readings are being collected.</source>
        <translation>%1 s 后就绪：正在采集最初的读数。</translation>
    </message>
    <message>
        <source>the order was not taken (simulated)</source>
        <translation>命令未被接受（模拟）</translation>
    </message>
    <message>
        <source>The sensors of &quot;%1&quot; and &quot;%2&quot; seem to be swapped: what they read in the last %3 s agrees with the heat of the other object, not with that of their own. The heat is off. Check both, confirm them, then reset.</source>
        <translation>“%1”和“%2”的传感器似乎互换了：它们最近 %3 s 的读数与另一物体的受热一致，而与自己物体的不一致。加热已关闭。请检查两者，确认它们，然后复位。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; warms by %2/s; the source explains at most %3/s: something else heats it, or its sensor is not on it. Bask switches the heat off. Check both, then reset.</source>
        <translation>“%1”以 %2/s 升温；热源最多能解释 %3/s：有别的东西在加热它，或其传感器不在它上面。Bask 将关闭加热。请检查两者，然后复位。</translation>
    </message>
    <message>
        <source>The source is at %1, %2 above its set point, and does not cool. Check its controller and its sensor; Stop takes the objects away and switches the heat off.</source>
        <translation>热源为 %1，高于设定值 %2，且未降温。请检查其控制器和传感器；停止会将物体移开并关闭加热。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is at %2, %3 from its target, and has gone farther from it for %4 s. Its sensor may be on another object, its outline or its mounting may be wrong, or something heats or cools it. The run goes on: check these.</source>
        <translation>“%1”为 %2，距目标 %3，且已持续远离 %4 s。其传感器可能在别的物体上，其轮廓或安装可能有误，或有东西在加热或冷却它。运行仍在继续：请检查这些。</translation>
    </message>
    <message>
        <source>line %1: &lt;use&gt; draws &quot;%2&quot;, which is not in the drawing (no other file is opened); put it there, or take the &lt;use&gt; out</source>
        <translation>第 %1 行：&lt;use&gt; 绘制的“%2”不在图形中（不会打开其他文件）；请把它放入图形，或去掉该 &lt;use&gt;</translation>
    </message>
    <message>
        <source>line %1: the points of &lt;%2&gt; are damaged from &quot;%3&quot; on</source>
        <translation>第 %1 行：&lt;%2&gt; 的点从“%3”起已损坏</translation>
    </message>
    <message>
        <source>line %1: the %2 of &lt;%3&gt;, &quot;%4&quot;, is no length; write a number, with px, mm, cm, in, pt, pc or % if it has a unit</source>
        <translation>第 %1 行：&lt;%3&gt; 的 %2“%4”不是长度；请写一个数字，有单位时加上 px、mm、cm、in、pt、pc 或 %</translation>
    </message>
    <message>
        <source>line %1: the transform of &lt;%2&gt; is damaged from &quot;%3&quot; on</source>
        <translation>第 %1 行：&lt;%2&gt; 的变换从“%3”起已损坏</translation>
    </message>
    <message>
        <source>a chessboard or the like: there are too many quadrangles to find a marker among them; cut the markers out</source>
        <translation>是棋盘格之类的图片：四边形太多，无法在其中找到标记；请把标记裁剪出来</translation>
    </message>
    <message>
        <source>the file holds %1 frames of &quot;%2&quot; one after another; choose one by its number (thermal-frame --frame), or save one frame (%3 bytes) a file</source>
        <translation>该文件依次包含“%2”的 %1 帧；请按编号选择一帧（thermal-frame --frame），或每个文件只保存一帧（%3 字节）</translation>
    </message>
    <message>
        <source>the file holds %1 pictures; choose one by its number (thermal-frame --frame), or save one picture a file</source>
        <translation>该文件包含 %1 幅图像；请按编号选择一幅（thermal-frame --frame），或每个文件只保存一幅</translation>
    </message>
    <message>
        <source>its face reflects the source, whose place is not known; let the source be seen, or aim the camera at the backs of the objects</source>
        <translation>其表面反射热源，而热源的位置未知；请让热源可被看到，或将相机对准物体的背面</translation>
    </message>
    <message>
        <source>where &quot;%1&quot; has temperatures, this frame holds a plain picture; its halves are exchanged, or the camera sends no temperatures. Record it again as the camera sends it</source>
        <translation>在“%1”应有温度之处，此帧是普通画面；它的上下两半被调换了，或相机没有送出温度。请按相机送出的原样重新录制</translation>
    </message>
    <message>
        <source>all pixels are between %1 and %2, as the bytes of a plain grey picture would be; make sure that the camera looks at something that hot</source>
        <translation>所有像素都在 %1 至 %2 之间，普通灰度画面的字节也会如此；请确认相机看的确实是这么热的东西</translation>
    </message>
    <message>
        <source>line %1 counts up by one, as a line of column numbers does, and nothing tells whether it is temperatures; name the camera&apos;s profile, whose size tells, or delete the line</source>
        <translation>第 %1 行逐个加一，与列号的行一样，无法判断它是否是温度；请指定相机的配置文件，由其尺寸判断，或删除该行</translation>
    </message>
    <message>
        <source>the first column counts up by one, as line numbers do, and nothing tells whether it is temperatures; name the camera&apos;s profile, whose size tells, or delete the column</source>
        <translation>第一列逐个加一，与行号一样，无法判断它是否是温度；请指定相机的配置文件，由其尺寸判断，或删除该列</translation>
    </message>
    <message>
        <source>there is no frame %1: the file holds %2, counted from 1</source>
        <translation>没有第 %1 帧：该文件有 %2 帧，从 1 开始计数</translation>
    </message>
    <message>
        <source>the bytes are those of %1 frames of &quot;%2&quot; or, with its optional rows, of %3, and nothing tells which; save one frame a file</source>
        <translation>这些字节可以是“%2”的 %1 帧，或连同其可选行的 %3 帧，无法判断是哪一种；请每个文件只保存一帧</translation>
    </message>
    <message>
        <source>it is a BigTIFF, which is not read; save it as an ordinary TIFF, or as PNG</source>
        <translation>这是 BigTIFF，不能读取；请另存为普通 TIFF 或 PNG</translation>
    </message>
    <message>
        <source>case %1 is also in %2, with other bytes: one of the two parts was changed; leave it out, or delete it and run its shard again</source>
        <translation>案例 %1 在 %2 中也有，但字节不同：两个分片文件之一被改动过；请不要列出它，或删除它并重新运行其分片</translation>
    </message>
    <message>
        <source>warning limit of &quot;%1&quot;</source>
        <translation>“%1”的警告限值</translation>
    </message>
    <message>
        <source>trip limit of &quot;%1&quot;</source>
        <translation>“%1”的跳闸限值</translation>
    </message>
    <message>
        <source>lowest %1</source>
        <translation>%1 的下限</translation>
    </message>
    <message>
        <source>highest %1</source>
        <translation>%1 的上限</translation>
    </message>
    <message>
        <source>axis %1</source>
        <translation>轴 %1</translation>
    </message>
    <message>
        <source>%1/s</source>
        <translation>%1/s</translation>
    </message>
    <message>
        <source>The robot&apos;s link is there, but the robot has reported or obeyed nothing for %1 s: its controller is busy, blocked or held. The heat is off. Look at the robot and its controller, then reset.</source>
        <translation>机器人的链路正常，但机器人已有 %1 s 没有报告或执行任何内容：其控制器正忙、受阻或被停住。加热已关闭。请查看机器人及其控制器，然后复位。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is at %2 and warms by %3/s with the heat off; the source explains at most %4/s. Something else heats it, or its sensor has just been put on it. Look at it before it reaches its limits.</source>
        <translation>“%1”为 %2，在加热关闭时以 %3/s 升温；热源最多能解释 %4/s。有别的东西在加热它，或其传感器刚刚装上。请在它达到限值之前查看。</translation>
    </message>
    <message>
        <source>The robot does not answer: %1. What it holds stays where it is, perhaps before a hot source. Check its link, then reset and retreat.</source>
        <translation>机器人无应答：%1。其所持物体停在原处，可能在高温热源前。请检查其连接，然后复位并撤离。</translation>
    </message>
    <message>
        <source>STOP was pressed: the robot stands still and the heat is off. What it holds stays where it is, perhaps before a hot source. Reset when it is safe, and retreat.</source>
        <translation>已按下“软件停止”：机器人静止，加热已关闭。其所持物体停在原处，可能在高温热源前。确认安全后再复位，并撤离。</translation>
    </message>
    <message>
        <source>simulated fault removed: %1</source>
        <translation>模拟故障已移除：%1</translation>
    </message>
    <message>
        <source>The sensor of &quot;%1&quot; reads %2. By now the object may be anywhere from %3 to %4, where its wrong readings were too, so Bask cannot tell whether this one is right. Check that the sensor is on its object, then confirm it.</source>
        <translation>“%1”的传感器读数为 %2。此时物体可能在 %3 至 %4 之间的任何温度，其错误读数也在此范围内，因此 Bask 无法判断这个读数是否正确。请检查传感器是否在物体上，然后确认。</translation>
    </message>
    <message>
        <source>The temperature of &quot;%1&quot; does not follow its heat: in %3 s it changed by %4 where %2, or more in that direction, was due. Its sensor may be off or on another object, the object may be gone, or the source may be elsewhere than expected. Bask switches the heat off. Check these, then reset.</source>
        <translation>“%1”的温度未随其受热变化：%3 s 内变化了 %4，而应为 %2，或沿该方向更多。其传感器可能脱落或在另一物体上，物体可能已不在，或热源不在预期位置。Bask 将关闭加热。请检查这些，然后复位。</translation>
    </message>
    <message>
        <source>The temperature of &quot;%1&quot; does not follow its heat: in %3 s it changed by %4 where %2, or more in that direction, was due, and &quot;%5&quot; deviates the other way. Their sensors may be swapped, or that of &quot;%1&quot; is off. Bask switches the heat off. Check both, then reset.</source>
        <translation>“%1”的温度未随其受热变化：%3 s 内变化了 %4，而应为 %2，或沿该方向更多，且“%5”向相反方向偏离。两者的传感器可能互换了，或“%1”的传感器脱落。Bask 将关闭加热。请检查两者，然后复位。</translation>
    </message>
</context>
<context>
    <name>OutlinePainting</name>
    <message>
        <source>1 harmonic</source>
        <translation>1 个谐波</translation>
    </message>
    <message>
        <source>%1 harmonics</source>
        <translation>%1 个谐波</translation>
    </message>
    <message>
        <source>1 hole</source>
        <translation>1 个孔</translation>
    </message>
    <message>
        <source>%1 holes</source>
        <translation>%1 个孔</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
</context>
<context>
    <name>Parameter</name>
    <message>
        <source>Objects: warning</source>
        <translation>物体：警告</translation>
    </message>
    <message>
        <source>A run holds, and a priority 2 alarm is given</source>
        <translation>运行进入保持，并发出优先级 2 的报警</translation>
    </message>
    <message>
        <source>Objects: trip</source>
        <translation>物体：跳闸</translation>
    </message>
    <message>
        <source>Heat off and retreat. What object, paint and sensor bear.</source>
        <translation>关闭加热并撤离。按物体、涂层和传感器所能承受的温度设定。</translation>
    </message>
    <message>
        <source>Source: trip</source>
        <translation>热源：跳闸</translation>
    </message>
    <message>
        <source>Heat off and retreat. Automatic: 50 K over the highest set point.</source>
        <translation>关闭加热并撤离。自动：比最高设定值高 50 K。</translation>
    </message>
    <message>
        <source>Periods a reading is good for</source>
        <translation>读数有效的周期数</translation>
    </message>
    <message>
        <source>A sensor without a newer one is lost; also the source and its place</source>
        <translation>超过此时间没有更新的传感器即视为失联；热源及其位置亦然</translation>
    </message>
    <message>
        <source>Longest hold</source>
        <translation>最长保持时间</translation>
    </message>
    <message>
        <source>A lost sensor or source holds the run so long, then it ends with a retreat</source>
        <translation>失去传感器或热源时，运行保持这么久，然后撤离并结束</translation>
    </message>
    <message>
        <source>Fastest plausible change</source>
        <translation>最快合理变化</translation>
    </message>
    <message>
        <source>Faster readings are a jump, and no heat. Automatic: three times what the source can do to the object, 2 K/s at least.</source>
        <translation>更快的读数是跳变，而非受热所致。自动：热源使物体所能达到的变化的三倍，至少 2 K/s。</translation>
    </message>
    <message>
        <source>Jumps in a row</source>
        <translation>连续跳变次数</translation>
    </message>
    <message>
        <source>So many readings that are too fast are a sensor fault</source>
        <translation>过快的读数达到此数即为传感器故障</translation>
    </message>
    <message>
        <source>Frozen sensor after</source>
        <translation>传感器冻结判定时间</translation>
    </message>
    <message>
        <source>The very same reading for so long, though the object must have changed</source>
        <translation>物体本应变化，而读数在此时间内完全相同</translation>
    </message>
    <message>
        <source>Change that must be seen</source>
        <translation>必须见到的变化</translation>
    </message>
    <message>
        <source>An object that must have changed by so much and did not does not follow its heat</source>
        <translation>物体本应变化这么多却没有变化，即为不随加热而变</translation>
    </message>
    <message>
        <source>Sensors apart when cold</source>
        <translation>冷态时传感器间差异</translation>
    </message>
    <message>
        <source>Sensors of a cold rig that differ by more are told</source>
        <translation>冷态装置中差异超过此值的传感器会被指出</translation>
    </message>
    <message>
        <source>Source: time to gain 2 K</source>
        <translation>热源：升温 2 K 的时间</translation>
    </message>
    <message>
        <source>A source that is too cold and no nearer after so long does not heat</source>
        <translation>热源温度过低，且经过此时间仍未接近设定值，即为不加热</translation>
    </message>
    <message>
        <source>Source: near its set point</source>
        <translation>热源：接近设定值</translation>
    </message>
    <message>
        <source>Within this the source is not too cold</source>
        <translation>在此范围内，热源不算温度过低</translation>
    </message>
    <message>
        <source>Source: warming unasked</source>
        <translation>热源：擅自升温</translation>
    </message>
    <message>
        <source>More warming with the heat off is an alarm</source>
        <translation>加热关闭时升温超过此值即报警</translation>
    </message>
    <message>
        <source>Least room on the disk</source>
        <translation>磁盘最小剩余空间</translation>
    </message>
    <message>
        <source>With less no recording is begun</source>
        <translation>少于此值时不开始记录</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>Trip</source>
        <translation>跳闸</translation>
    </message>
    <message>
        <source>Emittance</source>
        <translation>发射率</translation>
    </message>
    <message>
        <source>Absorptance</source>
        <translation>吸收率</translation>
    </message>
    <message>
        <source>Specific heat</source>
        <translation>比热容</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>密度</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>厚度</translation>
    </message>
    <message>
        <source>Infill</source>
        <translation>填充率</translation>
    </message>
    <message>
        <source>Largest speed</source>
        <translation>最大速度</translation>
    </message>
    <message>
        <source>Largest turning speed</source>
        <translation>最大转动速度</translation>
    </message>
    <message>
        <source>Largest acceleration</source>
        <translation>最大加速度</translation>
    </message>
    <message>
        <source>Largest turning acceleration</source>
        <translation>最大转动加速度</translation>
    </message>
    <message>
        <source>Clearance to the source</source>
        <translation>与热源的间距</translation>
    </message>
    <message>
        <source>Least distance of any point of an object from the source&apos;s plane</source>
        <translation>物体上任意一点到热源平面的最小距离</translation>
    </message>
    <message>
        <source>Largest mounting radius</source>
        <translation>最大安装半径</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>无限制</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>heat without a watchdog</source>
        <translation>无看门狗加热</translation>
    </message>
    <message>
        <source>not allowed</source>
        <translation>不允许</translation>
    </message>
    <message>
        <source>allowed</source>
        <translation>允许</translation>
    </message>
    <message>
        <source>Time constant</source>
        <translation>时间常数</translation>
    </message>
    <message>
        <source>Wanted rate = error / time constant: shorter is faster and rougher.</source>
        <translation>期望变化率 = 误差 / 时间常数：越短则越快、越不平稳。</translation>
    </message>
    <message>
        <source>Integral time</source>
        <translation>积分时间</translation>
    </message>
    <message>
        <source>Of the slow integral action near the target.</source>
        <translation>目标附近缓慢积分作用的时间。</translation>
    </message>
    <message>
        <source>Damping D</source>
        <translation>阻尼 D</translation>
    </message>
    <message>
        <source>Stiffness K</source>
        <translation>刚度 K</translation>
    </message>
    <message>
        <source>Weight of the error μ</source>
        <translation>误差权重 μ</translation>
    </message>
    <message>
        <source>ζ = v + μ Δτ</source>
        <translation>ζ = v + μ Δτ</translation>
    </message>
    <message>
        <source>Feedback K</source>
        <translation>反馈 K</translation>
    </message>
    <message>
        <source>Of ζ in the velocity command</source>
        <translation>速度指令中 ζ 的系数</translation>
    </message>
    <message>
        <source>Adaptation γ₁</source>
        <translation>自适应 γ₁</translation>
    </message>
    <message>
        <source>Speed at which 1/λ₁ is adapted</source>
        <translation>1/λ₁ 的自适应速度</translation>
    </message>
    <message>
        <source>Adaptation γ₂</source>
        <translation>自适应 γ₂</translation>
    </message>
    <message>
        <source>Speed at which λ₂/λ₁ is adapted</source>
        <translation>λ₂/λ₁ 的自适应速度</translation>
    </message>
    <message>
        <source>dv/dt = −D v − K Δτ</source>
        <translation>dv/dt = −D v − K Δτ</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>单元</translation>
    </message>
    <message>
        <source>The device&apos;s Modbus address</source>
        <translation>设备的 Modbus 地址</translation>
    </message>
    <message>
        <source>Watchdog</source>
        <translation>看门狗</translation>
    </message>
    <message>
        <source>The device switches its heat off when it has heard nothing for so long</source>
        <translation>设备若在这段时间内没有收到任何信息，就自行关闭加热</translation>
    </message>
    <message>
        <source>Convection h</source>
        <translation>对流系数 h</translation>
    </message>
    <message>
        <source>What the air takes from an object&apos;s face, by its temperature above the room</source>
        <translation>空气从物体表面带走的热量，按其高于室温的温度计</translation>
    </message>
    <message>
        <source>a figure drawn by Bask</source>
        <translation>Bask 绘制的图</translation>
    </message>
    <message>
        <source>a report written by Bask</source>
        <translation>Bask 写出的报告</translation>
    </message>
    <message>
        <source>a table written by Bask</source>
        <translation>Bask 写出的表格</translation>
    </message>
    <message>
        <source>a comparison written by Bask</source>
        <translation>Bask 写出的比较</translation>
    </message>
    <message>
        <source>a NeXus file written by Bask</source>
        <translation>Bask 写出的 NeXus 文件</translation>
    </message>
    <message>
        <source>lines written by Bask</source>
        <translation>Bask 写出的线条文件</translation>
    </message>
    <message>
        <source>a collection written by Bask</source>
        <translation>Bask 写出的集合文件</translation>
    </message>
    <message>
        <source>a field written by Bask</source>
        <translation>Bask 写出的场文件</translation>
    </message>
    <message>
        <source>a surface file written by Bask</source>
        <translation>Bask 写出的曲面文件</translation>
    </message>
    <message>
        <source>it is written to again and again</source>
        <translation>它不断被写入</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>z</source>
        <translation>z</translation>
    </message>
    <message>
        <source>theta x</source>
        <translation>θx 轴</translation>
    </message>
    <message>
        <source>theta y</source>
        <translation>θy 轴</translation>
    </message>
    <message>
        <source>theta z</source>
        <translation>θz 轴</translation>
    </message>
    <message>
        <source>fixed</source>
        <translation>固定</translation>
    </message>
    <message>
        <source>free</source>
        <translation>自由</translation>
    </message>
</context>
<context>
    <name>PoseWords</name>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>x %1, y %2, z %3; turned by %4, %5, %6 about x, y, z</source>
        <translation>x %1，y %2，z %3；绕 x、y、z 转动 %4、%5、%6</translation>
    </message>
</context>
<context>
    <name>State</name>
    <message>
        <source>Idle</source>
        <translation>空闲</translation>
    </message>
    <message>
        <source>Not ready</source>
        <translation>未就绪</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>就绪</translation>
    </message>
    <message>
        <source>Armed</source>
        <translation>待命中</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>运行中</translation>
    </message>
    <message>
        <source>Holding</source>
        <translation>保持中</translation>
    </message>
    <message>
        <source>Settled</source>
        <translation>已稳定</translation>
    </message>
    <message>
        <source>Stopping</source>
        <translation>正在停止</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>已停止</translation>
    </message>
    <message>
        <source>Fault (latched)</source>
        <translation>故障（已锁存）</translation>
    </message>
    <message>
        <source>Connecting</source>
        <translation>正在连接</translation>
    </message>
    <message>
        <source>Homing</source>
        <translation>正在回零</translation>
    </message>
    <message>
        <source>Over</source>
        <translation>已解除</translation>
    </message>
</context>
<context>
    <name>Verb</name>
    <message>
        <source>Arm</source>
        <translation>待命</translation>
    </message>
    <message>
        <source>Disarm</source>
        <translation>解除待命</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>开始</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>保持</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>继续</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>复位</translation>
    </message>
    <message>
        <source>Retreat</source>
        <translation>撤离</translation>
    </message>
    <message>
        <source>Set targets</source>
        <translation>设定目标</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>移动</translation>
    </message>
    <message>
        <source>Jog</source>
        <translation>点动</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>回零</translation>
    </message>
    <message>
        <source>Heat</source>
        <translation>加热</translation>
    </message>
    <message>
        <source>Confirm sensor</source>
        <translation>确认传感器</translation>
    </message>
    <message>
        <source>Clear alarm</source>
        <translation>清除报警</translation>
    </message>
    <message>
        <source>Shelve</source>
        <translation>搁置</translation>
    </message>
    <message>
        <source>Unshelve</source>
        <translation>取消搁置</translation>
    </message>
</context>
<context>
    <name>bask::Actions</name>
    <message>
        <source>&amp;File</source>
        <translation>文件(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Examples</source>
        <translation>示例(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Recent files</source>
        <translation>最近的文件(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>编辑(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>帮助(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;New experiment</source>
        <translation>新建实验(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>打开(&amp;O)…</translation>
    </message>
    <message>
        <source>Open an experiment (*.json) or a recorded session (*.bask)</source>
        <translation>打开实验（*.json）或记录的会话（*.bask）</translation>
    </message>
    <message>
        <source>&amp;Save experiment</source>
        <translation>保存实验(&amp;S)</translation>
    </message>
    <message>
        <source>Save experiment &amp;as…</source>
        <translation>实验另存为(&amp;A)…</translation>
    </message>
    <message>
        <source>Save sess&amp;ion…</source>
        <translation>保存会话(&amp;I)…</translation>
    </message>
    <message>
        <source>Copy the recording of the present or last run to a file of your choice</source>
        <translation>将当前或上一次运行的记录复制到您选择的文件</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>退出(&amp;Q)</translation>
    </message>
    <message>
        <source>&amp;About Bask</source>
        <translation>关于 Bask(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>运行(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Arm</source>
        <translation>待命(&amp;A)</translation>
    </message>
    <message>
        <source>Zero the sensors at ambient and open the recording. Nothing moves or heats yet.</source>
        <translation>在环境温度下将传感器校零，并打开记录。此时没有运动，也不加热。</translation>
    </message>
    <message>
        <source>S&amp;tart</source>
        <translation>开始(&amp;T)</translation>
    </message>
    <message>
        <source>Open the heat and servo every object to its target.</source>
        <translation>打开加热，并将每个物体伺服到其目标。</translation>
    </message>
    <message>
        <source>&amp;Hold</source>
        <translation>保持(&amp;H)</translation>
    </message>
    <message>
        <source>Zero velocity; the controller keeps its state and Resume goes on from here.</source>
        <translation>速度为零；控制器保留其状态，按“继续”从此处接着运行。</translation>
    </message>
    <message>
        <source>R&amp;esume</source>
        <translation>继续(&amp;E)</translation>
    </message>
    <message>
        <source>Go on from where the run was held.</source>
        <translation>从运行被保持之处继续。</translation>
    </message>
    <message>
        <source>Sto&amp;p</source>
        <translation>停止(&amp;P)</translation>
    </message>
    <message>
        <source>End the run: heat off, retreat upwards, close the recording. While armed: disarm.</source>
        <translation>结束运行：关闭加热，向上撤离，关闭记录。待命时：解除待命。</translation>
    </message>
    <message>
        <source>STOP now</source>
        <translation>立即软件停止</translation>
    </message>
    <message>
        <source>Zero velocity and heat off now, latched. A software stop, not a safety-rated emergency stop.</source>
        <translation>立即使速度为零并关闭加热，并锁存。这是软件停止，不是安全等级的急停。</translation>
    </message>
    <message>
        <source>Re&amp;set</source>
        <translation>复位(&amp;S)</translation>
    </message>
    <message>
        <source>Clear a latched stop or fault. It never starts anything.</source>
        <translation>解除锁存的停止或故障。此操作绝不会启动任何东西。</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>视图(&amp;V)</translation>
    </message>
    <message>
        <source>Objects</source>
        <translation>物体</translation>
    </message>
    <message>
        <source>Targets</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>运行</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>回顾</translation>
    </message>
    <message>
        <source>What is held in front of the source: outlines, materials, mounting</source>
        <translation>热源前所持的物体：轮廓、材料、安装</translation>
    </message>
    <message>
        <source>What temperature each object shall have, and whether it can be reached</source>
        <translation>每个物体应达到的温度，以及能否达到</translation>
    </message>
    <message>
        <source>Temperatures, the scene and the controller during a run</source>
        <translation>运行中的温度、场景和控制器</translation>
    </message>
    <message>
        <source>A recorded run, opened again</source>
        <translation>重新打开的已记录运行</translation>
    </message>
    <message>
        <source>Temperature &amp;unit</source>
        <translation>温度单位(&amp;U)</translation>
    </message>
    <message>
        <source>Degrees Celsius (°C)</source>
        <translation>摄氏度（°C）</translation>
    </message>
    <message>
        <source>Kelvin (K)</source>
        <translation>开尔文（K）</translation>
    </message>
    <message>
        <source>Degrees Fahrenheit (°F)</source>
        <translation>华氏度（°F）</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>主题(&amp;T)</translation>
    </message>
    <message>
        <source>As the desktop</source>
        <translation>与桌面一致</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>浅色</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>深色</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>语言(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Tools</source>
        <translation>工具(&amp;T)</translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation>标定</translation>
    </message>
    <message>
        <source>The camera: its lens, where it stands, and where the source is</source>
        <translation>相机：其镜头、所在位置，以及热源的位置</translation>
    </message>
    <message>
        <source>Rig</source>
        <translation>装置</translation>
    </message>
    <message>
        <source>The devices, what must be so before a run, and the robot and the heat by hand</source>
        <translation>设备、运行前必须满足的条件，以及机器人和加热的手动操作</translation>
    </message>
    <message>
        <source>Ac&amp;knowledge all alarms</source>
        <translation>确认所有报警(&amp;K)</translation>
    </message>
    <message>
        <source>You have seen all alarms. Those that are over leave the list. (F9)</source>
        <translation>表示您已看到所有报警。已解除的报警将从列表中移除。（F9）</translation>
    </message>
    <message>
        <source>&amp;Clear the list</source>
        <translation>清空列表(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>手册(&amp;M)</translation>
    </message>
    <message>
        <source>Report a &amp;problem…</source>
        <translation>报告问题(&amp;P)…</translation>
    </message>
    <message>
        <source>The &amp;first five minutes</source>
        <translation>最初五分钟(&amp;F)</translation>
    </message>
    <message>
        <source>Te&amp;xt size</source>
        <translation>文字大小(&amp;X)</translation>
    </message>
    <message>
        <source>&amp;Retreat…</source>
        <translation>撤离(&amp;R)…</translation>
    </message>
    <message>
        <source>The robot takes the objects away from the source and the heat goes off, in every state in which the robot answers. A fault stays latched.</source>
        <translation>机器人使物体离开热源，并关闭加热；只要机器人有应答，在任何状态下都可以。故障仍保持锁存。</translation>
    </message>
    <message>
        <source>End the re&amp;cording</source>
        <translation>结束记录(&amp;C)</translation>
    </message>
    <message>
        <source>After a stop or a fault the recording goes on until everything is cold. This ends it now.</source>
        <translation>停止或故障之后，记录会继续到一切冷却为止。此命令立即结束记录。</translation>
    </message>
    <message>
        <source>Alarm &amp;horn</source>
        <translation>报警声(&amp;H)</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>On a real rig</source>
        <translation>仅实机</translation>
    </message>
    <message>
        <source>Always</source>
        <translation>始终</translation>
    </message>
    <message>
        <source>The desktop&apos;s bell, until alarms of priority 1 and 2 are acknowledged or over; once for priority 3</source>
        <translation>桌面的提示音，直到优先级 1 和 2 的报警被确认或结束；优先级 3 只响一次</translation>
    </message>
    <message>
        <source>&amp;Operator and sample…</source>
        <translation>操作员和样品(&amp;O)…</translation>
    </message>
    <message>
        <source>Who operates, and what is heated: recordings, reports and the list of runs show it.</source>
        <translation>谁在操作，加热的是什么：记录、报告和运行列表都会显示。</translation>
    </message>
    <message>
        <source>&amp;Monitoring…</source>
        <translation>监视(&amp;M)…</translation>
    </message>
    <message>
        <source>Large &amp;numbers</source>
        <translation>大号数字(&amp;N)</translation>
    </message>
    <message>
        <source>Ho&amp;me the robot…</source>
        <translation>机器人回零(&amp;M)…</translation>
    </message>
    <message>
        <source>All &amp;alarms…</source>
        <translation>所有报警(&amp;A)…</translation>
    </message>
    <message>
        <source>The alarms of all recorded runs, with how often and when</source>
        <translation>所有已记录运行的报警，及其次数和时间</translation>
    </message>
    <message>
        <source>The robot seeks its switches to know its place: it moves</source>
        <translation>机器人寻找其限位开关以确定位置：它会移动</translation>
    </message>
</context>
<context>
    <name>bask::AirForm</name>
    <message>
        <source>The simulated rig has natural convection.</source>
        <translation>仿真装置有自然对流。</translation>
    </message>
    <message>
        <source>The simulated rig has h = %1 W/(m² K).</source>
        <translation>仿真装置的 h = %1 W/(m² K)。</translation>
    </message>
    <message>
        <source>Natural convection would take some %1 % of what “%2” loses at %3.</source>
        <translation>在 %3 时，自然对流约占“%2”损失的 %1 %。</translation>
    </message>
    <message>
        <source>Takes %1 % of what “%2” loses at %3, with h = %4 W/(m² K).</source>
        <translation>在 %3 时占“%2”损失的 %1 %，h = %4 W/(m² K)。</translation>
    </message>
    <message>
        <source>Air in the room</source>
        <translation>室内空气</translation>
    </message>
    <message>
        <source>Convection, for all objects</source>
        <translation>对流，适用于所有物体</translation>
    </message>
    <message>
        <source>What verdicts, predictions and controllers take the air to be; it has the temperature of the room</source>
        <translation>判定、预测和控制器所假定的空气；其温度为室温</translation>
    </message>
    <message>
        <source>not known, not counted</source>
        <translation>未知，未计入</translation>
    </message>
    <message>
        <source>h is given</source>
        <translation>给定 h</translation>
    </message>
    <message>
        <source>natural, by correlation</source>
        <translation>自然对流，按关联式</translation>
    </message>
</context>
<context>
    <name>bask::AlarmButton</name>
    <message>
        <source>Alarm of priority %1 (%2): %3</source>
        <translation>优先级 %1 的报警（%2）：%3</translation>
    </message>
    <message>
        <source>%1 more.</source>
        <translation>另有 %1 个。</translation>
    </message>
    <message>
        <source>This may be old: the engine is not answering.</source>
        <translation>可能已过时：引擎没有应答。</translation>
    </message>
</context>
<context>
    <name>bask::AlarmHistoryDialog</name>
    <message>
        <source>Priority %1: %2</source>
        <translation>优先级 %1：%2</translation>
    </message>
    <message>
        <source>SIMULATED</source>
        <translation>仿真</translation>
    </message>
    <message>
        <source>LIVE</source>
        <translation>实机</translation>
    </message>
    <message>
        <source>Reading the runs: %1 %</source>
        <translation>正在读取运行：%1 %</translation>
    </message>
    <message>
        <source>The list has no run.</source>
        <translation>列表中没有运行。</translation>
    </message>
    <message numerus="yes">
        <source>No alarm was raised in %n run(s).</source>
        <translation>
            <numerusform>%n 次运行中没有出现报警。</numerusform>
        </translation>
    </message>
    <message>
        <source>No alarm matches &quot;%1&quot;.</source>
        <translation>没有与“%1”匹配的报警。</translation>
    </message>
    <message numerus="yes">
        <source>Alarms in %1 of %n run(s)</source>
        <translation>
            <numerusform>%n 次运行中有 %1 次出现报警</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n recording(s) could not be read: %1</source>
        <translation>
            <numerusform>%n 个记录无法读取：%1</numerusform>
        </translation>
    </message>
    <message>
        <source>Alarms of the listed runs</source>
        <translation>所列运行的报警</translation>
    </message>
    <message>
        <source>Filter the alarms</source>
        <translation>筛选报警</translation>
    </message>
    <message>
        <source>Shows the alarms that have every word.</source>
        <translation>显示含有全部词语的报警。</translation>
    </message>
    <message>
        <source>Alarm</source>
        <translation>报警</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>运行次数</translation>
    </message>
    <message>
        <source>Times</source>
        <translation>次数</translation>
    </message>
    <message>
        <source>Active</source>
        <translation>有效时间</translation>
    </message>
    <message>
        <source>Last raised</source>
        <translation>最近出现</translation>
    </message>
    <message>
        <source>Last run</source>
        <translation>最近的运行</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>报警</translation>
    </message>
    <message>
        <source>As it was raised the last time</source>
        <translation>最近一次出现时的内容</translation>
    </message>
    <message>
        <source>Number of runs in which it was raised</source>
        <translation>出现该报警的运行次数</translation>
    </message>
    <message>
        <source>How often it was raised</source>
        <translation>出现的次数</translation>
    </message>
    <message>
        <source>Recorded</source>
        <translation>记录时间</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>运行</translation>
    </message>
    <message>
        <source>Rig</source>
        <translation>装置</translation>
    </message>
    <message>
        <source>Raised at</source>
        <translation>出现于</translation>
    </message>
    <message>
        <source>Runs of the selected alarm</source>
        <translation>所选报警的运行</translation>
    </message>
    <message>
        <source>Time since Start</source>
        <translation>自“开始”起的时间</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>复制</translation>
    </message>
    <message>
        <source>Copy the alarms as text, for a spreadsheet</source>
        <translation>将报警作为文本复制，供电子表格使用</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>打开</translation>
    </message>
    <message>
        <source>Open the selected run</source>
        <translation>打开所选运行</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>%1. Only %2 of %3 alarms are shown, the gravest.</source>
        <comment>%1: Alarms in 2 of 5 runs</comment>
        <translation>%1。只显示 %3 个报警中最严重的 %2 个。</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>a run: its name, and when it was recorded</comment>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>Priority</source>
        <translation>优先级</translation>
    </message>
    <message>
        <source>1 is the gravest</source>
        <translation>1 为最严重</translation>
    </message>
    <message>
        <source>Opens the run at the moment when the alarm was last raised in it</source>
        <translation>打开该运行，停在报警在其中最近一次出现的时刻</translation>
    </message>
    <message>
        <source>%1 + %2</source>
        <comment>when a run was recorded, and the time in it</comment>
        <translation>%1 + %2</translation>
    </message>
    <message>
        <source>When the last run with it was recorded, and the time since Start when it was raised</source>
        <translation>最近一次出现该报警的运行的记录时刻，以及报警出现时自“开始”起的时间</translation>
    </message>
    <message>
        <source>No run</source>
        <translation>无运行</translation>
    </message>
    <message>
        <source>Raised while nothing was recorded</source>
        <translation>在没有进行记录时出现</translation>
    </message>
    <message numerus="yes">
        <source>%1, and %n time(s) while nothing was recorded</source>
        <comment>%1: Alarms in 2 of 5 runs</comment>
        <translation>
            <numerusform>%1，另有 %n 次在没有进行记录时出现</numerusform>
        </translation>
    </message>
    <message>
        <source>The alarms that were raised while nothing was recorded could not be read.</source>
        <translation>没有进行记录时出现的报警无法读取。</translation>
    </message>
    <message numerus="yes">
        <source>%n line(s) with alarms that were raised while nothing was recorded could not be read.</source>
        <translation>
            <numerusform>%n 行没有进行记录时出现的报警无法读取。</numerusform>
        </translation>
    </message>
    <message>
        <source>Without a run, when the alarm was raised</source>
        <translation>没有运行时，为报警出现的时间</translation>
    </message>
    <message>
        <source>at least %1</source>
        <comment>a duration: minutes and seconds</comment>
        <translation>至少 %1</translation>
    </message>
    <message>
        <source>Time for which it was active, until it was over or reset. &quot;At least&quot;: a recording ended before it, or the end of one of its times is not known.</source>
        <translation>有效的时间，到它结束或被复位为止。“至少”：某个记录在它之前结束，或其中一次的结束不明。</translation>
    </message>
</context>
<context>
    <name>bask::AlarmList</name>
    <message>
        <source>Priority %1</source>
        <translation>优先级 %1</translation>
    </message>
    <message>
        <source>Priority %1. %2.</source>
        <translation>优先级 %1。%2。</translation>
    </message>
    <message>
        <source>%1×</source>
        <translation>%1×</translation>
    </message>
    <message>
        <source>No alarms.</source>
        <translation>没有报警。</translation>
    </message>
    <message>
        <source>Choose an alarm to read what to do.</source>
        <translation>选择一个报警，查看应对方法。</translation>
    </message>
    <message>
        <source>Raised at %1, %2 times since it was last acknowledged.</source>
        <translation>出现于 %1，自上次确认以来共 %2 次。</translation>
    </message>
    <message>
        <source>Raised at %1.</source>
        <translation>出现于 %1。</translation>
    </message>
    <message>
        <source>Over at %1.</source>
        <translation>解除于 %1。</translation>
    </message>
    <message>
        <source>The first of those that came together: likely their cause.</source>
        <translation>同时出现的报警中的首个：很可能是其余报警的原因。</translation>
    </message>
    <message>
        <source>It was active when Bask was last left.</source>
        <translation>上次退出 Bask 时它仍处于激活状态。</translation>
    </message>
    <message>
        <source>The engine is not answering: these alarms may be old.</source>
        <translation>引擎没有应答：这些报警可能已过时。</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>报警</translation>
    </message>
    <message>
        <source>Priority</source>
        <translation>优先级</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>Raised</source>
        <translation>出现</translation>
    </message>
    <message>
        <source>Times</source>
        <translation>次数</translation>
    </message>
    <message>
        <source>What is wrong</source>
        <translation>问题</translation>
    </message>
    <message>
        <source>What to do about the alarm</source>
        <translation>报警的应对方法</translation>
    </message>
    <message>
        <source>Acknowledge</source>
        <translation>确认</translation>
    </message>
    <message>
        <source>You have seen this alarm. It stays in the list while its condition holds.</source>
        <translation>表示您已看到此报警。只要其条件仍存在，它就留在列表中。</translation>
    </message>
    <message>
        <source>Acknowledge all</source>
        <translation>全部确认</translation>
    </message>
    <message>
        <source>You have seen all alarms. Those that are over leave the list.</source>
        <translation>表示您已看到所有报警。已解除的报警将从列表中移除。</translation>
    </message>
    <message>
        <source>Shelved: %1</source>
        <translation>已搁置：%1</translation>
    </message>
    <message numerus="yes">
        <source>, %n follow(s)</source>
        <comment>from this alarm</comment>
        <translation>
            <numerusform>，引发 %n 个</numerusform>
        </translation>
    </message>
    <message>
        <source>It follows from the alarm over it, and goes with that.</source>
        <translation>它由上面的报警引发，并随之消失。</translation>
    </message>
    <message>
        <source>Take the alarm back from the shelf</source>
        <translation>取回已搁置的报警</translation>
    </message>
    <message>
        <source>Shelve: put the alarm aside for a time, with a reason</source>
        <translation>搁置：将报警暂时放在一边，须说明理由</translation>
    </message>
    <message>
        <source>All alarms…</source>
        <translation>所有报警…</translation>
    </message>
    <message>
        <source>Unshelve</source>
        <translation>取消搁置</translation>
    </message>
    <message>
        <source>Shelve…</source>
        <translation>搁置…</translation>
    </message>
</context>
<context>
    <name>bask::AlarmWords</name>
    <message>
        <source>Active</source>
        <translation>激活</translation>
    </message>
    <message>
        <source>Over</source>
        <translation>已解除</translation>
    </message>
    <message>
        <source>new</source>
        <translation>新</translation>
    </message>
    <message>
        <source>seen</source>
        <translation>已看到</translation>
    </message>
    <message>
        <source>first</source>
        <translation>首个</translation>
    </message>
    <message>
        <source>from before</source>
        <translation>先前遗留</translation>
    </message>
    <message>
        <source>, </source>
        <comment>between states</comment>
        <translation>，</translation>
    </message>
    <message>
        <source>Shelved until %1: %2</source>
        <translation>搁置至 %1：%2</translation>
    </message>
    <message>
        <source>seen by %1</source>
        <translation>%1 已看到</translation>
    </message>
    <message>
        <source>Shelved until %1 by %3: %2</source>
        <translation>由 %3 搁置至 %1：%2</translation>
    </message>
</context>
<context>
    <name>bask::AxisTable</name>
    <message>
        <source>Axis</source>
        <translation>轴</translation>
    </message>
    <message>
        <source>Where the axis reads zero</source>
        <translation>该轴读数为零之处</translation>
    </message>
    <message>
        <source>Axis that drives %1</source>
        <translation>驱动 %1 的轴</translation>
    </message>
    <message>
        <source>reversed</source>
        <translation>反向</translation>
    </message>
    <message>
        <source>The axis of %1 counts the other way</source>
        <translation>%1 的轴计数方向相反</translation>
    </message>
    <message>
        <source>%1 where its axis reads zero</source>
        <translation>该轴读数为零时的 %1</translation>
    </message>
</context>
<context>
    <name>bask::BeliefText</name>
    <message>
        <source>The controller begins with heat rates wrong by up to ×%1, as the experiment asks.</source>
        <translation>按实验的要求，控制器起始时所用的热速率有误，误差最大为 %1 倍。</translation>
    </message>
</context>
<context>
    <name>bask::BoardForm</name>
    <message>
        <source>&amp;Board</source>
        <translation>标定板(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Dictionary</source>
        <translation>字典(&amp;D)</translation>
    </message>
    <message>
        <source>As measured on the print: over ten squares, divided by ten.</source>
        <translation>按打印件实测：测十个方格的长度，再除以十。</translation>
    </message>
    <message>
        <source>Boards made by OpenCV before 4.6 with an even number of rows.</source>
        <translation>由 4.6 之前的 OpenCV 生成、行数为偶数的标定板。</translation>
    </message>
    <message>
        <source>ChArUco board</source>
        <translation>ChArUco 板</translation>
    </message>
    <message>
        <source>Chessboard</source>
        <translation>棋盘格</translation>
    </message>
    <message>
        <source>Dictionary of the markers</source>
        <translation>标记的字典</translation>
    </message>
    <message>
        <source>Inner cor&amp;ners</source>
        <translation>内角点(&amp;N)</translation>
    </message>
    <message>
        <source>Inner corners across</source>
        <translation>横向内角点数</translation>
    </message>
    <message>
        <source>Inner corners down</source>
        <translation>纵向内角点数</translation>
    </message>
    <message>
        <source>Kind of board</source>
        <translation>标定板类型</translation>
    </message>
    <message>
        <source>Lower left square is black</source>
        <translation>左下角方格为黑色</translation>
    </message>
    <message>
        <source>S&amp;ide of a square</source>
        <translation>方格边长(&amp;I)</translation>
    </message>
    <message>
        <source>S&amp;quares</source>
        <translation>方格数(&amp;Q)</translation>
    </message>
    <message>
        <source>Side of a &amp;marker</source>
        <translation>标记边长(&amp;M)</translation>
    </message>
    <message>
        <source>Side of a marker</source>
        <translation>标记边长</translation>
    </message>
    <message>
        <source>Side of a square</source>
        <translation>方格边长</translation>
    </message>
    <message>
        <source>Squares across</source>
        <translation>横向方格数</translation>
    </message>
    <message>
        <source>Squares down</source>
        <translation>纵向方格数</translation>
    </message>
    <message>
        <source>With its black border, as measured on the print.</source>
        <translation>含黑色边框，按打印件实测。</translation>
    </message>
</context>
<context>
    <name>bask::BottomDock</name>
    <message>
        <source>Alarms</source>
        <translation>报警</translation>
    </message>
    <message>
        <source>Alarms (%1)</source>
        <translation>报警（%1）</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>事件</translation>
    </message>
    <message>
        <source>Alarms and events</source>
        <translation>报警与事件</translation>
    </message>
    <message>
        <source>Recipe</source>
        <translation>配方</translation>
    </message>
    <message>
        <source>, %1 shelved</source>
        <comment>behind the number of alarms</comment>
        <translation>，%1 个已搁置</translation>
    </message>
</context>
<context>
    <name>bask::CalibratePage</name>
    <message>
        <source>Calibrate</source>
        <translation>标定</translation>
    </message>
    <message>
        <source>What is calibrated</source>
        <translation>标定的内容</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>相机</translation>
    </message>
    <message>
        <source>Simulated camera</source>
        <translation>仿真相机</translation>
    </message>
    <message>
        <source>Or type a number (0), a device (/dev/video0), a video file, a folder of pictures or an address (rtsp://…), and Enter</source>
        <translation>或输入编号（0）、设备（/dev/video0）、视频文件、图片文件夹或地址（rtsp://…），再按回车</translation>
    </message>
    <message>
        <source>Thermal camera</source>
        <translation>热像仪</translation>
    </message>
</context>
<context>
    <name>bask::CalibrationAge</name>
    <message>
        <source>at an unknown time</source>
        <translation>时间未知</translation>
    </message>
    <message>
        <source>in the future: check the computer&apos;s clock</source>
        <translation>在将来：请检查计算机的时钟</translation>
    </message>
    <message>
        <source>just now</source>
        <translation>刚刚</translation>
    </message>
    <message>
        <source>Camera calibrated %1.</source>
        <translation>相机标定于：%1。</translation>
    </message>
    <message>
        <source>Camera not calibrated.</source>
        <translation>相机未标定。</translation>
    </message>
    <message>
        <source>Where the camera stands was measured %1.</source>
        <translation>相机位置测量于：%1。</translation>
    </message>
    <message>
        <source>Where the camera stands is not measured.</source>
        <translation>相机位置未测量。</translation>
    </message>
    <message>
        <source>The source&apos;s place is as typed, not measured by the camera.</source>
        <translation>热源位置为手动输入，未经相机测量。</translation>
    </message>
    <message>
        <source>The source&apos;s place was measured %1.</source>
        <translation>热源位置测量于：%1。</translation>
    </message>
    <message numerus="yes">
        <source>%n minute(s) ago</source>
        <translation>
            <numerusform>%n 分钟前</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n hour(s) ago</source>
        <translation>
            <numerusform>%n 小时前</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n day(s) ago</source>
        <translation>
            <numerusform>%n 天前</numerusform>
        </translation>
    </message>
    <message>
        <source>Thermal camera&apos;s lens calibrated %1.</source>
        <translation>热像仪的镜头标定于：%1。</translation>
    </message>
    <message>
        <source>Thermal camera&apos;s lens not calibrated.</source>
        <translation>热像仪的镜头未标定。</translation>
    </message>
    <message>
        <source>The thermal camera&apos;s place is not known.</source>
        <translation>热像仪的位置未知。</translation>
    </message>
    <message>
        <source>The thermal camera&apos;s place is as typed, not measured.</source>
        <translation>热像仪的位置按输入值，未测量。</translation>
    </message>
    <message>
        <source>The thermal camera&apos;s place was measured %1.</source>
        <translation>热像仪的位置测量于：%1。</translation>
    </message>
</context>
<context>
    <name>bask::CameraPanel</name>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>&amp;Calibrate</source>
        <translation>标定(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Start looking</source>
        <translation>开始观测(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Stop looking</source>
        <translation>停止观测(&amp;S)</translation>
    </message>
    <message>
        <source>Calibration board</source>
        <translation>标定板</translation>
    </message>
    <message>
        <source>Calibration of the camera</source>
        <translation>相机标定</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>相机</translation>
    </message>
    <message>
        <source>Cameras (%1);;All files (*)</source>
        <translation>相机 (%1);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Drops all views. The board can be set again.</source>
        <translation>丢弃所有视图。之后可重新设置标定板。</translation>
    </message>
    <message>
        <source>Hold the board still.</source>
        <translation>请保持标定板不动。</translation>
    </message>
    <message>
        <source>Leave &amp;out the views that stand out</source>
        <translation>剔除离群视图(&amp;O)</translation>
    </message>
    <message>
        <source>Load a camera</source>
        <translation>载入相机</translation>
    </message>
    <message>
        <source>Looks for the board in the live picture.</source>
        <translation>在实时图像中寻找标定板。</translation>
    </message>
    <message>
        <source>OpenCV YAML (%1)</source>
        <translation>OpenCV YAML (%1)</translation>
    </message>
    <message>
        <source>Progress of the calibration</source>
        <translation>标定进度</translation>
    </message>
    <message>
        <source>ROS camera_info (%1)</source>
        <translation>ROS camera_info (%1)</translation>
    </message>
    <message>
        <source>Save the camera</source>
        <translation>保存相机</translation>
    </message>
    <message>
        <source>Start again</source>
        <translation>重新开始</translation>
    </message>
    <message>
        <source>Start looking, then show the board to the camera from near and far, at all edges of the picture and tilted to all sides.</source>
        <translation>请开始观测，然后让相机在远近不同处、画面各边缘处以及向各方向倾斜时看到标定板。</translation>
    </message>
    <message>
        <source>Ta&amp;ke this view</source>
        <translation>拍摄此视图(&amp;K)</translation>
    </message>
    <message>
        <source>Take still, new views &amp;automatically</source>
        <translation>自动拍摄静止的新视图(&amp;A)</translation>
    </message>
    <message>
        <source>The board is seen: hold it still and take the view.</source>
        <translation>已见到标定板：请保持不动并拍摄视图。</translation>
    </message>
    <message>
        <source>The camera is saved in %1.</source>
        <translation>相机已保存在 %1。</translation>
    </message>
    <message>
        <source>The views are of this board: start again to set another.</source>
        <translation>这些视图属于此标定板：重新开始后才能设置另一块。</translation>
    </message>
    <message>
        <source>There is such a view: move the board on.</source>
        <translation>已有这样的视图：请移动标定板。</translation>
    </message>
    <message>
        <source>Too little of the board is seen for a view.</source>
        <translation>见到的标定板部分太少，不能作为视图。</translation>
    </message>
    <message>
        <source>Use the board seen</source>
        <translation>使用所见的标定板</translation>
    </message>
    <message>
        <source>View %1 is taken: move the board on.</source>
        <translation>已拍摄视图 %1：请移动标定板。</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>视图</translation>
    </message>
    <message>
        <source>Waiting for the camera&apos;s pictures.</source>
        <translation>正在等待相机图像。</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1。</translation>
    </message>
</context>
<context>
    <name>bask::CameraResult</name>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>%1 views</source>
        <translation>%1 个视图</translation>
    </message>
    <message>
        <source>%1 × %2 pixels</source>
        <translation>%1 × %2 像素</translation>
    </message>
    <message>
        <source>%1, in use</source>
        <translation>%1，正在使用</translation>
    </message>
    <message>
        <source>&amp;Use this camera</source>
        <translation>使用此相机(&amp;U)</translation>
    </message>
    <message>
        <source>Calibrate it by views of a board, or load its file.</source>
        <translation>请用标定板的视图标定，或载入其文件。</translation>
    </message>
    <message>
        <source>Good</source>
        <translation>良好</translation>
    </message>
    <message>
        <source>Load a camera from a file</source>
        <translation>从文件载入相机</translation>
    </message>
    <message>
        <source>Load…</source>
        <translation>载入…</translation>
    </message>
    <message>
        <source>No camera yet</source>
        <translation>尚无相机</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>参数</translation>
    </message>
    <message>
        <source>Parameters of the camera</source>
        <translation>相机参数</translation>
    </message>
    <message>
        <source>Poses of markers are computed by it from now on.</source>
        <translation>此后标记的位姿由它计算。</translation>
    </message>
    <message>
        <source>Read from a file: how far it holds was not checked here.</source>
        <translation>从文件读取：其适用程度未在此处校验。</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>需重做</translation>
    </message>
    <message>
        <source>Save the camera in a file</source>
        <translation>将相机保存到文件</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>保存…</translation>
    </message>
    <message>
        <source>Standard deviation</source>
        <translation>标准差</translation>
    </message>
    <message>
        <source>The camera in use</source>
        <translation>正在使用的相机</translation>
    </message>
    <message>
        <source>Usable</source>
        <translation>可用</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>值</translation>
    </message>
    <message>
        <source>held-out views %1 px</source>
        <translation>留出视图 %1 px</translation>
    </message>
    <message>
        <source>residual %1 px</source>
        <translation>残差 %1 px</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1。</translation>
    </message>
</context>
<context>
    <name>bask::CheckList</name>
    <message>
        <source>done</source>
        <translation>已完成</translation>
    </message>
    <message>
        <source>wrong</source>
        <translation>有误</translation>
    </message>
    <message>
        <source>not yet</source>
        <translation>尚未</translation>
    </message>
    <message>
        <source>Before a run</source>
        <translation>运行之前</translation>
    </message>
    <message>
        <source>Devices: simulated</source>
        <translation>设备：仿真</translation>
    </message>
    <message>
        <source>Devices: none set up as %1</source>
        <translation>设备：未设置 %1</translation>
    </message>
    <message>
        <source>Devices: no answer from %1</source>
        <translation>设备：%1 无应答</translation>
    </message>
    <message>
        <source>Devices: all answer</source>
        <translation>设备：均有应答</translation>
    </message>
    <message>
        <source>Robot: in alarm</source>
        <translation>机器人：处于报警</translation>
    </message>
    <message>
        <source>Robot: its place is not sure</source>
        <translation>机器人：位置不确定</translation>
    </message>
    <message>
        <source>Robot: its place is sure</source>
        <translation>机器人：位置确定</translation>
    </message>
    <message>
        <source>Sensors: no readings yet</source>
        <translation>传感器：尚无读数</translation>
    </message>
    <message>
        <source>Sensors: the newest readings are %1 old</source>
        <translation>传感器：最新读数已过去 %1</translation>
    </message>
    <message>
        <source>Sensors: %1 of %2 without a valid reading</source>
        <translation>传感器：%2 个中有 %1 个没有有效读数</translation>
    </message>
    <message>
        <source>Sensors: fresh and valid</source>
        <translation>传感器：读数及时且有效</translation>
    </message>
    <message>
        <source>Source: no temperature</source>
        <translation>热源：无温度</translation>
    </message>
    <message>
        <source>Source: warm, %1</source>
        <translation>热源：已热，%1</translation>
    </message>
    <message>
        <source>Source: %1, not at %2 yet</source>
        <translation>热源：%1，尚未达到 %2</translation>
    </message>
    <message>
        <source>Source: %1, above %2</source>
        <translation>热源：%1，高于 %2</translation>
    </message>
    <message>
        <source>Recording: not possible</source>
        <translation>记录：无法进行</translation>
    </message>
    <message>
        <source>Recording: begins with Arm</source>
        <translation>记录：进入待命时开始</translation>
    </message>
    <message>
        <source>Recording: on</source>
        <translation>记录：进行中</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>Robot: its place is UNKNOWN, what it told last is %1</source>
        <translation>机器人：位置未知，最后告知的是：%1</translation>
    </message>
    <message>
        <source>Sensors: %1 of %2 not believed</source>
        <translation>传感器：%2 个中有 %1 个不采信</translation>
    </message>
    <message>
        <source>Sensors: %1 of %2 stale</source>
        <translation>传感器：%2 个中有 %1 个过时</translation>
    </message>
    <message>
        <source>Source: UNKNOWN whether it heats, %1</source>
        <translation>热源：是否加热未知，%1</translation>
    </message>
    <message>
        <source>Source: %1, not at %2 yet. %3</source>
        <extracomment>the last is a sentence about the time that it takes</extracomment>
        <translation>热源：%1，尚未达到 %2。%3</translation>
    </message>
    <message>
        <source>Source: it heats though its heat is off, %1</source>
        <translation>热源：加热已关闭，但它仍在加热，%1</translation>
    </message>
</context>
<context>
    <name>bask::Coach</name>
    <message>
        <source>Show me</source>
        <translation>演示</translation>
    </message>
    <message>
        <source>Not now</source>
        <translation>以后再说</translation>
    </message>
    <message>
        <source>%1 of %2: %3</source>
        <extracomment>number of the step, of so many, what to do</extracomment>
        <translation>第 %1 步，共 %2 步：%3</translation>
    </message>
    <message>
        <source>Show where</source>
        <translation>指出位置</translation>
    </message>
    <message>
        <source>Skip</source>
        <translation>跳过</translation>
    </message>
    <message>
        <source>On the Objects page, select “bunny” and drag Harmonics. With fewer of them its outline leaves the drawing&apos;s.</source>
        <translation>在“物体”页选择“bunny”并拖动谐波数。谐波越少，轮廓偏离原图越多。</translation>
    </message>
    <message>
        <source>Take that back with Ctrl+Z. Every edit can be undone.</source>
        <translation>用 Ctrl+Z 撤销。每项编辑都可以撤销。</translation>
    </message>
    <message>
        <source>On the Targets page, type %1 for one object and read why it cannot be held.</source>
        <translation>在“目标”页为一个物体输入 %1，阅读为何无法保持。</translation>
    </message>
    <message>
        <source>Press “Use nearest feasible”: targets that can be held together.</source>
        <translation>按“采用最近的可行目标”：可同时保持的目标。</translation>
    </message>
    <message>
        <source>Start (F6): the heat is on, and the robot moves.</source>
        <translation>开始（F6）：加热打开，机器人移动。</translation>
    </message>
    <message>
        <source>The run has ended in a fault, as a hold that lasts does. End it in Tools &gt; Simulate fault, press Reset, then Arm (F5) and Start (F6) again.</source>
        <translation>运行已因故障结束：保持过久即会如此。请在“工具 &gt; 模拟故障”中结束故障，按“复位”，然后再次“待命”（F5）、“开始”（F6）。</translation>
    </message>
    <message>
        <source>The run has ended. Arm (F5) and Start (F6) again.</source>
        <translation>运行已结束。请再次“待命”（F5）、“开始”（F6）。</translation>
    </message>
    <message>
        <source>The run has ended. End the fault in Tools &gt; Simulate fault, then Arm (F5) and Start (F6) again.</source>
        <translation>运行已结束。请在“工具 &gt; 模拟故障”中结束故障，然后再次“待命”（F5）、“开始”（F6）。</translation>
    </message>
    <message>
        <source>The temperatures go to their targets. Press N on the Run page and note something.</source>
        <translation>温度趋向各自的目标。在“运行”页按 N，写一条备注。</translation>
    </message>
    <message>
        <source>Change a gain at the controller and apply it: the traces are marked there.</source>
        <translation>更改控制器的一个增益并应用：曲线上会有标记。</translation>
    </message>
    <message>
        <source>Acknowledge the alarm (F9): you have seen it.</source>
        <translation>确认报警（F9）：表示您已看到。</translation>
    </message>
    <message>
        <source>Stop (F8): heat off, the robot retreats, the recording is closed.</source>
        <translation>停止（F8）：关闭加热，机器人退回，关闭记录。</translation>
    </message>
    <message>
        <source>On the Review page, open the recording of this run.</source>
        <translation>在“回顾”页打开本次运行的记录。</translation>
    </message>
    <message>
        <source>Type %1 there again, which is reached sooner. Then Arm (F5): the sensors are zeroed and the recording is opened. Nothing moves yet.</source>
        <translation>在那里重新输入 %1，可更快达到。然后待命（F5）：传感器校零，打开记录。此时什么都不动。</translation>
    </message>
    <message>
        <source>File &gt; Examples &gt; thermal-camera: three objects that only a thermal camera reads. On the Run page, look at the tab Thermal picture.</source>
        <translation>文件 &gt; 示例 &gt; thermal-camera：三个只由热像仪读取的物体。在“运行”页查看“热像图”标签页。</translation>
    </message>
    <message>
        <source>That was all. “Simulated rig” on the Rig page leads back to the simulated one; F1 opens the manual, which has the rest.</source>
        <translation>到此结束。“装置”页的“仿真装置”可返回仿真装置；其余内容见手册（F1）。</translation>
    </message>
    <message>
        <source>New here? %1 small steps on simulated rigs show what Bask does. Nothing can burn.</source>
        <extracomment>how many</extracomment>
        <translation>初次使用？在仿真装置上的 %1 个小步骤演示 Bask 的功能，不会有任何危险。</translation>
    </message>
    <message>
        <source>Tools &gt; Simulate fault &gt; %1: choose an object. The run holds, and an alarm says what to do.</source>
        <extracomment>a simulated fault, as the menu has it</extracomment>
        <translation>“工具 &gt; 模拟故障 &gt; %1”：选择一个物体。运行保持，报警说明如何处理。</translation>
    </message>
    <message>
        <source>Remove its cause: choose the fault again in the same menu, which ends it. The sensor tells its temperature again.</source>
        <translation>消除原因：在同一菜单中再次选择该故障，即可结束它。传感器重新给出温度。</translation>
    </message>
    <message>
        <source>Resume (Shift+F7): the run goes on where it was held.</source>
        <translation>继续（Shift+F7）：运行从保持处接着进行。</translation>
    </message>
    <message>
        <source>File &gt; Examples &gt; serial-rig: a rig with devices of its own, as a real one has. They are at serial ports, where nothing answers yet.</source>
        <translation>文件 &gt; 示例 &gt; serial-rig：像实际装置一样有自己的设备。它们在串行端口上，目前还没有应答。</translation>
    </message>
    <message>
        <source>Type “bask simulate-rig” in a terminal: it plays robot, thermometer and heat source at these ports. On the Rig page all three become live.</source>
        <translation>在终端中输入“bask simulate-rig”：它在这些端口上充当机器人、温度计和热源。在“装置”页，三者都变为在线。</translation>
    </message>
    <message>
        <source>Find a device: “Remove” the thermometer, then “Set up…” with port %1. “Find devices” lists what answers there; choose it and press “Use”.</source>
        <extracomment>the path of a serial port</extracomment>
        <translation>查找设备：先“移除”温度计，再“设置…”，端口为 %1。“查找设备”列出在那里应答的设备；选择它并按“使用”。</translation>
    </message>
</context>
<context>
    <name>bask::Comparison</name>
    <message>
        <source>Metric</source>
        <translation>指标</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>物体</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>object; its steps in the runs</comment>
        <translation>%1：%2</translation>
    </message>
</context>
<context>
    <name>bask::ComparisonView</name>
    <message>
        <source>Differences from</source>
        <translation>与其之差</translation>
    </message>
    <message>
        <source>The run that the others are compared with</source>
        <translation>其他运行与之比较的运行</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>复制</translation>
    </message>
    <message>
        <source>Copy the table as text, for a spreadsheet or a letter</source>
        <translation>将表格作为文本复制，供电子表格或信件使用</translation>
    </message>
    <message>
        <source>Export (CSV)…</source>
        <translation>导出 (CSV)…</translation>
    </message>
    <message>
        <source>Metrics of the runs that are laid over each other</source>
        <translation>叠加的各次运行的指标</translation>
    </message>
    <message>
        <source>%1 less %2</source>
        <translation>%1 减 %2</translation>
    </message>
    <message>
        <source>Being computed from all samples: %1</source>
        <translation>正在用全部采样计算：%1</translation>
    </message>
    <message>
        <source>No metrics, the recording cannot be read to its end: %1</source>
        <translation>没有指标，记录无法读到结尾：%1</translation>
    </message>
    <message>
        <source>Write the numbers of this table for other programs</source>
        <translation>写出此表中的数字，供其他程序使用</translation>
    </message>
    <message>
        <source>Once all metrics are computed</source>
        <translation>所有指标计算完成之后</translation>
    </message>
    <message numerus="yes">
        <source>Copied %n row(s)</source>
        <translation>
            <numerusform>已复制 %n 行</numerusform>
        </translation>
    </message>
    <message>
        <source>The steps are not alike, so neither are times and overshoots: %1</source>
        <translation>阶跃不同，因此时间和超调也不可比较：%1</translation>
    </message>
    <message>
        <source>The source was not equally hot at Start: %1</source>
        <translation>开始时各次运行的热源温度不同：%1</translation>
    </message>
</context>
<context>
    <name>bask::ControllerPanel</name>
    <message>
        <source>Not applied: %1</source>
        <comment>number of changes</comment>
        <translation>未应用：%1</translation>
    </message>
    <message>
        <source>Controller and gains</source>
        <translation>控制器与增益</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>控制器</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>应用</translation>
    </message>
    <message>
        <source>Use these settings from the next control step on; noted in the run&apos;s log.</source>
        <translation>从下一个控制步起使用这些设置；将记入运行日志。</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>还原</translation>
    </message>
    <message>
        <source>Back to the settings in use.</source>
        <translation>恢复为正在使用的设置。</translation>
    </message>
    <message>
        <source>After a step of %1 K, without limits and noise: it never settles.</source>
        <translation>阶跃 %1 K 后，不计限值和噪声：始终不能稳定。</translation>
    </message>
    <message>
        <source>After a step of %1 K, without limits and noise: overshoot %2 %, within ±%3 K after %4 s.</source>
        <translation>阶跃 %1 K 后，不计限值和噪声：超调 %2 %，%4 s 后进入 ±%3 K 以内。</translation>
    </message>
    <message>
        <source>After a step of %1 K, once it has adapted, without limits and noise: no overshoot, within ±%2 K after %3 s at best.</source>
        <translation>阶跃 %1 K 后，自适应完成时，不计限值和噪声：无超调，最快 %3 s 后进入 ±%2 K 以内。</translation>
    </message>
    <message>
        <source>Frequency ω</source>
        <translation>频率 ω</translation>
    </message>
    <message>
        <source>rad/s</source>
        <translation>rad/s</translation>
    </message>
    <message>
        <source>Natural frequency: ω = √K. Changes D and K together.</source>
        <translation>固有频率：ω = √K。同时改变 D 和 K。</translation>
    </message>
    <message>
        <source>Damping ratio ζ</source>
        <translation>阻尼比 ζ</translation>
    </message>
    <message>
        <source>ζ = D / (2√K): overshoots below 1. Changes D.</source>
        <translation>ζ = D / (2√K)：小于 1 时有超调。改变 D。</translation>
    </message>
    <message>
        <source>Rates wrong: ×%1</source>
        <comment>the heat rates that the controller begins with</comment>
        <translation>热速率有误：×%1</translation>
    </message>
</context>
<context>
    <name>bask::CountdownBar</name>
    <message>
        <source>In %1 s, unless the cause is gone: %2</source>
        <translation>%1 s 后，除非原因消除：%2</translation>
    </message>
    <message>
        <source>Cause: %1</source>
        <translation>原因：%1</translation>
    </message>
</context>
<context>
    <name>bask::CoverageView</name>
    <message>
        <source>%1 of %2 views</source>
        <translation>%1 / %2 个视图</translation>
    </message>
    <message>
        <source>%1 views</source>
        <translation>%1 个视图</translation>
    </message>
    <message>
        <source>Colours the picture by how many corners were seen where.</source>
        <translation>按各处见到的角点数为画面着色。</translation>
    </message>
    <message>
        <source>Covered: %1</source>
        <translation>已覆盖：%1</translation>
    </message>
    <message>
        <source>Left to right</source>
        <translation>左到右</translation>
    </message>
    <message>
        <source>Nearness</source>
        <translation>远近</translation>
    </message>
    <message>
        <source>Show on the &amp;picture</source>
        <translation>显示在画面上(&amp;P)</translation>
    </message>
    <message>
        <source>This is enough: calibrate.</source>
        <translation>已经足够：请标定。</translation>
    </message>
    <message>
        <source>Tilt</source>
        <translation>倾斜</translation>
    </message>
    <message>
        <source>Top to bottom</source>
        <translation>上到下</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1。</translation>
    </message>
</context>
<context>
    <name>bask::CutControls</name>
    <message>
        <source>No cut</source>
        <translation>无剖面</translation>
    </message>
    <message>
        <source>Cut: %1</source>
        <translation>剖面：%1</translation>
    </message>
    <message>
        <source>Object whose field is cut</source>
        <translation>显示其场剖面的物体</translation>
    </message>
    <message>
        <source>A plane in the colours of what one object would have there.</source>
        <translation>一个平面，其颜色表示某一物体在该处的值。</translation>
    </message>
    <message>
        <source>What the cut shows: T, the steady temperature, or F, the view factor</source>
        <translation>剖面所显示的量：T 为稳态温度，F 为角系数</translation>
    </message>
    <message>
        <source>T: the temperature that the object settles at there. F: its view factor.</source>
        <translation>T：物体在该处最终稳定的温度。F：其角系数。</translation>
    </message>
    <message>
        <source>Axis that the plane is square to</source>
        <translation>平面所垂直的轴</translation>
    </message>
    <message>
        <source>Place of the plane along its axis</source>
        <translation>平面沿其轴的位置</translation>
    </message>
</context>
<context>
    <name>bask::CutOffRun</name>
    <message>
        <source>Bask ended in the middle of a run (%1) and could not stop the rig: look at the robot and the source before you go on.</source>
        <translation>Bask 在一次运行途中意外结束（%1），未能停止装置：请先检查机器人和热源，然后再继续。</translation>
    </message>
    <message>
        <source>Bask ended in the middle of a simulated run (%1).</source>
        <translation>Bask 在一次仿真运行途中意外结束（%1）。</translation>
    </message>
    <message>
        <source>Show in Review</source>
        <translation>在“回顾”中显示</translation>
    </message>
    <message>
        <source>What it had recorded is kept.</source>
        <translation>已记录的内容均已保留。</translation>
    </message>
</context>
<context>
    <name>bask::DesktopFiles</name>
    <message>
        <source>%1 is no longer there.</source>
        <translation>%1 已不存在。</translation>
    </message>
    <message>
        <source>The desktop has no program that opens %1.</source>
        <translation>桌面没有能打开 %1 的程序。</translation>
    </message>
</context>
<context>
    <name>bask::Device</name>
    <message>
        <source>Robot</source>
        <translation>机器人</translation>
    </message>
    <message>
        <source>Thermometer</source>
        <translation>温度计</translation>
    </message>
    <message>
        <source>Heat source</source>
        <translation>热源</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>相机</translation>
    </message>
    <message>
        <source>Closed</source>
        <translation>已关闭</translation>
    </message>
    <message>
        <source>Opening</source>
        <translation>正在打开</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>在线</translation>
    </message>
    <message>
        <source>Lost</source>
        <translation>已失联</translation>
    </message>
    <message>
        <source>Grbl or grblHAL (G-code)</source>
        <translation>Grbl 或 grblHAL（G 代码）</translation>
    </message>
    <message>
        <source>Dobot MG400 or M1 Pro (network)</source>
        <translation>Dobot MG400 或 M1 Pro（网络）</translation>
    </message>
    <message>
        <source>Modbus RTU module</source>
        <translation>Modbus RTU 模块</translation>
    </message>
    <message>
        <source>Lines of text (MAX31865)</source>
        <translation>文本行（MAX31865）</translation>
    </message>
    <message>
        <source>Kept hot by a person</source>
        <translation>由人工保持高温</translation>
    </message>
    <message>
        <source>Hotplate (NAMUR, IKA)</source>
        <translation>加热板（NAMUR，IKA）</translation>
    </message>
    <message>
        <source>Modbus RTU controller</source>
        <translation>Modbus RTU 控制器</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>图片</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>a temperature and how old it is</comment>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>Thermal camera</source>
        <translation>热像仪</translation>
    </message>
    <message>
        <source>Program of your own</source>
        <translation>自编程序</translation>
    </message>
    <message>
        <source>Modbus TCP controller</source>
        <translation>Modbus TCP 控制器</translation>
    </message>
    <message>
        <source>Modbus TCP module</source>
        <translation>Modbus TCP 模块</translation>
    </message>
    <message>
        <source>heated by hand</source>
        <translation>手动加热</translation>
    </message>
    <message>
        <source>heat off</source>
        <translation>加热关闭</translation>
    </message>
    <message>
        <source>heat on</source>
        <translation>加热开启</translation>
    </message>
    <message>
        <source>heat UNKNOWN</source>
        <translation>加热未知</translation>
    </message>
    <message>
        <source>SIMULATED</source>
        <translation>仿真</translation>
    </message>
    <message>
        <source>LIVE</source>
        <translation>实机</translation>
    </message>
    <message>
        <source>heats though off</source>
        <translation>已关仍在加热</translation>
    </message>
    <message>
        <source>The robot&apos;s place was not sure. It is sure again: press Reset.</source>
        <translation>机器人的位置曾不确定，现已确定：请按“复位”。</translation>
    </message>
    <message>
        <source>The robot&apos;s place was not sure. It is sure again.</source>
        <translation>机器人的位置曾不确定，现已确定。</translation>
    </message>
</context>
<context>
    <name>bask::DeviceCard</name>
    <message>
        <source>Change…</source>
        <translation>更改…</translation>
    </message>
    <message>
        <source>Set up…</source>
        <translation>设置…</translation>
    </message>
    <message>
        <source>Simulated</source>
        <translation>仿真</translation>
    </message>
    <message>
        <source>None</source>
        <translation>无</translation>
    </message>
    <message>
        <source>%1 ago</source>
        <translation>%1 前</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source>Not in use yet</source>
        <translation>尚未使用</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message numerus="yes">
        <source>%n answer(s) discarded</source>
        <translation>
            <numerusform>已丢弃 %n 个应答</numerusform>
        </translation>
    </message>
    <message>
        <source>Age of its newest answer, answers a second, and answers that nobody can read or that were not asked for</source>
        <translation>最新应答的时龄、每秒应答数，以及无法识别或并非所问的应答数</translation>
    </message>
    <message>
        <source>This is the one</source>
        <translation>就是这台</translation>
    </message>
    <message>
        <source>Use the device that answers now, and remember it instead of the one before</source>
        <translation>使用现在应答的设备，并记住它以取代以前的设备</translation>
    </message>
    <message>
        <source>Confirm…</source>
        <translation>确认…</translation>
    </message>
    <message>
        <source>Look at what would be started, and allow it on this computer</source>
        <translation>查看将启动的内容，并在本计算机上允许</translation>
    </message>
    <message>
        <source>The last of them: %1</source>
        <translation>其中最近一个：%1</translation>
    </message>
</context>
<context>
    <name>bask::DeviceConsole</name>
    <message>
        <source>Nothing is sent by hand while a run is armed or on, the heat is on or the robot moves.</source>
        <translation>运行已预备或进行中、加热开启或机器人运动时，不能手动发送。</translation>
    </message>
    <message>
        <source>Bask sends this as it is and checks no limit: the robot can move and the source can heat. Bask lets the device go meanwhile, and takes it back 3 s later.</source>
        <translation>Bask 原样发送，不检查任何限值：机器人可能运动，热源可能加热。期间 Bask 放开该设备，3 s 后取回。</translation>
    </message>
    <message>
        <source>No link to a device is open.</source>
        <translation>没有打开的设备链路。</translation>
    </message>
    <message>
        <source>Device console</source>
        <translation>设备控制台</translation>
    </message>
    <message>
        <source>All links</source>
        <translation>全部链路</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>链路</translation>
    </message>
    <message>
        <source>Both directions</source>
        <translation>双向</translation>
    </message>
    <message>
        <source>Sent</source>
        <translation>发送</translation>
    </message>
    <message>
        <source>Received</source>
        <translation>接收</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>Show only rows with this text</source>
        <translation>只显示含此文字的行</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>筛选</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>暂停</translation>
    </message>
    <message>
        <source>The traffic of the last 10 minutes is kept meanwhile</source>
        <translation>期间仍保留最近 10 分钟的通信</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>复制</translation>
    </message>
    <message>
        <source>Copies the selected rows, or all that are shown: the newest 8 million characters</source>
        <translation>复制选中的行，或所有显示的行：最新的 800 万个字符</translation>
    </message>
    <message>
        <source>Link to send to</source>
        <translation>发送到的链路</translation>
    </message>
    <message>
        <source>Text to send</source>
        <translation>要发送的文字</translation>
    </message>
    <message>
        <source>ends with \n</source>
        <translation>以 \n 结尾</translation>
    </message>
    <message>
        <source>ends with \r</source>
        <translation>以 \r 结尾</translation>
    </message>
    <message>
        <source>ends with \r\n</source>
        <translation>以 \r\n 结尾</translation>
    </message>
    <message>
        <source>as it is</source>
        <translation>原样</translation>
    </message>
    <message>
        <source>hexadecimal</source>
        <translation>十六进制</translation>
    </message>
    <message>
        <source>End of the text</source>
        <translation>文字结尾</translation>
    </message>
    <message>
        <source>Send</source>
        <translation>发送</translation>
    </message>
    <message>
        <source>Traffic of the links</source>
        <translation>链路的通信</translation>
    </message>
</context>
<context>
    <name>bask::DeviceDialog</name>
    <message>
        <source>Take a profile from a file</source>
        <translation>从文件读取配置</translation>
    </message>
    <message>
        <source>Profiles (*.json)</source>
        <translation>配置文件 (*.json)</translation>
    </message>
    <message>
        <source>Asking…</source>
        <translation>正在询问…</translation>
    </message>
    <message>
        <source>Channels %1</source>
        <translation>通道 %1</translation>
    </message>
    <message>
        <source>Temperature %1</source>
        <translation>温度 %1</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>相机</translation>
    </message>
    <message>
        <source>A number (0), a device (/dev/video0), a video file, a folder of pictures or an address (rtsp://…)</source>
        <translation>编号（0）、设备（/dev/video0）、视频文件、图片文件夹或地址（rtsp://…）</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>端口</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>地址</translation>
    </message>
    <message>
        <source>Choose one, or type its path</source>
        <translation>请选择一个，或输入其路径</translation>
    </message>
    <message>
        <source>Set up: %1</source>
        <translation>设置：%1</translation>
    </message>
    <message>
        <source>Driver</source>
        <translation>驱动</translation>
    </message>
    <message>
        <source>Refresh</source>
        <translation>刷新</translation>
    </message>
    <message>
        <source>Look for ports anew</source>
        <translation>重新查找端口</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>线路</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>轴</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>设备</translation>
    </message>
    <message>
        <source>From file…</source>
        <translation>从文件…</translation>
    </message>
    <message>
        <source>Take what the device&apos;s registers mean from a file</source>
        <translation>从文件读取设备各寄存器的含义</translation>
    </message>
    <message>
        <source>Channels</source>
        <translation>通道</translation>
    </message>
    <message>
        <source>The channel of each object&apos;s sensor, counted from 0</source>
        <translation>每个物体的传感器通道，从 0 开始计数</translation>
    </message>
    <message>
        <source>Its external probe measures the surface</source>
        <translation>由其外接探头测量表面温度</translation>
    </message>
    <message>
        <source>Test read</source>
        <translation>读取测试</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>使用</translation>
    </message>
    <message>
        <source>Use this device in the experiment</source>
        <translation>在实验中使用此设备</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Asks the device without using it. Nothing moves or heats.</source>
        <translation>仅询问设备而不使用它。没有运动，也不加热。</translation>
    </message>
    <message>
        <source>No serial port was found. Plug the device in and refresh, or type a path.</source>
        <translation>未找到串口。请插入设备后刷新，或输入路径。</translation>
    </message>
    <message>
        <source>1. Which device</source>
        <translation>1. 哪个设备</translation>
    </message>
    <message>
        <source>2. Where it is connected</source>
        <translation>2. 连接在何处</translation>
    </message>
    <message>
        <source>3. Does it answer?</source>
        <translation>3. 是否应答？</translation>
    </message>
    <message>
        <source>4. Its axes</source>
        <translation>4. 它的轴</translation>
    </message>
    <message>
        <source>4. The objects&apos; channels</source>
        <translation>4. 各物体的通道</translation>
    </message>
    <message>
        <source>4. The device&apos;s own settings</source>
        <translation>4. 设备自身的设置</translation>
    </message>
    <message>
        <source>May heat without a watchdog</source>
        <translation>允许在没有看门狗时加热</translation>
    </message>
    <message>
        <source>Then the source stays hot when Bask or the computer stops. Never leave it alone.</source>
        <translation>那么当 Bask 或计算机停止运行时，热源会一直发热。不得无人看管。</translation>
    </message>
    <message>
        <source>Its place is sure</source>
        <translation>其位置确定</translation>
    </message>
    <message>
        <source>Once it is homed, if its controller can; else once it is confirmed</source>
        <translation>若控制器支持，回零之后；否则确认之后</translation>
    </message>
    <message>
        <source>Once it is homed</source>
        <translation>回零之后</translation>
    </message>
    <message>
        <source>Once it is homed or confirmed</source>
        <translation>回零或确认之后</translation>
    </message>
    <message>
        <source>Host name or IP address of the device</source>
        <translation>设备的主机名或 IP 地址</translation>
    </message>
    <message>
        <source>Picture from %1 to %2</source>
        <translation>图像从 %1 到 %2</translation>
    </message>
    <message>
        <source>A number (0), a device (/dev/video0), a recorded frame or a folder of frames</source>
        <translation>编号（0）、设备（/dev/video0）、录制的一帧或帧的文件夹</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>命令</translation>
    </message>
    <message>
        <source>The program and its arguments: python3 /home/lab/my_robot.py</source>
        <translation>程序及其参数：python3 /home/lab/my_robot.py</translation>
    </message>
    <message>
        <source>When its program says so</source>
        <translation>当其程序表示时</translation>
    </message>
</context>
<context>
    <name>bask::DialogFrame</name>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
</context>
<context>
    <name>bask::Display</name>
    <message>
        <source>%1/min</source>
        <comment>a rate; %1 is K or °F</comment>
        <translation>%1/min</translation>
    </message>
    <message>
        <source>The rig cannot be armed or started yet.</source>
        <translation>装置尚不能进入待命或开始。</translation>
    </message>
    <message>
        <source>Nothing stands in the way: press Arm.</source>
        <translation>一切就绪：请按“待命”。</translation>
    </message>
    <message>
        <source>The sensors are zeroed and the recording is open: press Start.</source>
        <translation>传感器已校零，记录已打开：请按“开始”。</translation>
    </message>
    <message>
        <source>The robot moves the objects towards their targets.</source>
        <translation>机器人正将各物体移向其目标。</translation>
    </message>
    <message>
        <source>Zero velocity; the controller&apos;s state is kept. Press Resume to go on.</source>
        <translation>速度为零；控制器状态已保留。按“继续”接着运行。</translation>
    </message>
    <message>
        <source>All objects stay within their tolerance band. The controller keeps working.</source>
        <translation>所有物体都保持在容差带内。控制器继续工作。</translation>
    </message>
    <message>
        <source>no value yet</source>
        <translation>尚无数值</translation>
    </message>
    <message>
        <source>%1 s old</source>
        <translation>%1 s 前</translation>
    </message>
    <message>
        <source>%1 old</source>
        <comment>%1 is minutes and seconds</comment>
        <translation>%1 前</translation>
    </message>
    <message>
        <source>Nothing is armed.</source>
        <translation>未进入待命。</translation>
    </message>
    <message>
        <source>The robot takes the objects away, and the heat was ordered off.</source>
        <translation>机器人正将物体移开，已下令关闭加热。</translation>
    </message>
    <message>
        <source>The run has ended.</source>
        <translation>运行已结束。</translation>
    </message>
    <message>
        <source>A stop or a fault is latched. Remove its cause, then press Reset.</source>
        <translation>有停止或故障被锁存。请排除其原因，然后按“复位”。</translation>
    </message>
</context>
<context>
    <name>bask::Document</name>
    <message>
        <source>Untitled</source>
        <translation>未命名</translation>
    </message>
</context>
<context>
    <name>bask::EvennessText</name>
    <message>
        <source>even</source>
        <translation>均匀</translation>
    </message>
    <message>
        <source>Parts: %1, which radiate %2 to %3 % of what an even one does</source>
        <translation>%1 个部分，辐射为均匀热源的 %2 至 %3 %</translation>
    </message>
    <message>
        <source>Radial profile of %1 points, radiating %2 to %3 % of what an even one does</source>
        <translation>%1 个点的径向分布，辐射为均匀热源的 %2 至 %3 %</translation>
    </message>
</context>
<context>
    <name>bask::EventList</name>
    <message>
        <source>Priority %1</source>
        <translation>优先级 %1</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>Event</source>
        <translation>事件</translation>
    </message>
    <message>
        <source>Events and notes</source>
        <translation>事件与备注</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>What happened</source>
        <translation>发生了什么</translation>
    </message>
</context>
<context>
    <name>bask::ExperimentEdit</name>
    <message>
        <source>target of “%1”</source>
        <translation>“%1”的目标</translation>
    </message>
    <message>
        <source>targets</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>controller and gains</source>
        <translation>控制器与增益</translation>
    </message>
    <message>
        <source>markers</source>
        <translation>标记</translation>
    </message>
    <message>
        <source>calibration of the camera</source>
        <translation>相机标定</translation>
    </message>
    <message>
        <source>place of the camera</source>
        <translation>相机的位置</translation>
    </message>
    <message>
        <source>calibration</source>
        <translation>标定</translation>
    </message>
    <message>
        <source>place of the source</source>
        <translation>热源的位置</translation>
    </message>
    <message>
        <source>following of the source</source>
        <translation>热源的跟踪</translation>
    </message>
    <message>
        <source>start of runs</source>
        <translation>运行的起始位姿</translation>
    </message>
    <message>
        <source>set point of the source</source>
        <translation>热源的设定值</translation>
    </message>
    <message>
        <source>emittance of the source</source>
        <translation>热源的发射率</translation>
    </message>
    <message>
        <source>workspace</source>
        <translation>工作空间</translation>
    </message>
    <message>
        <source>limits of motion</source>
        <translation>运动限值</translation>
    </message>
    <message>
        <source>safety limits</source>
        <translation>安全限值</translation>
    </message>
    <message>
        <source>choice of the real rig</source>
        <translation>选用实际装置</translation>
    </message>
    <message>
        <source>devices of the rig</source>
        <translation>装置的设备</translation>
    </message>
    <message>
        <source>choice of the simulated rig</source>
        <translation>选用仿真装置</translation>
    </message>
    <message>
        <source>move of “%1”</source>
        <translation>移动“%1”</translation>
    </message>
    <message>
        <source>moves</source>
        <translation>移动</translation>
    </message>
    <message>
        <source>renaming of “%1”</source>
        <translation>重命名“%1”</translation>
    </message>
    <message>
        <source>names</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>start values of “%1”</source>
        <translation>“%1”的起始值</translation>
    </message>
    <message>
        <source>start values</source>
        <translation>起始值</translation>
    </message>
    <message>
        <source>material of “%1”</source>
        <translation>“%1”的材料</translation>
    </message>
    <message>
        <source>materials</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>outline of “%1”</source>
        <translation>“%1”的轮廓</translation>
    </message>
    <message>
        <source>outlines</source>
        <translation>轮廓</translation>
    </message>
    <message>
        <source>change of “%1”</source>
        <translation>更改“%1”</translation>
    </message>
    <message>
        <source>change of several objects</source>
        <translation>更改多个物体</translation>
    </message>
    <message>
        <source>addition of “%1”</source>
        <translation>添加“%1”</translation>
    </message>
    <message>
        <source>removal of “%1”</source>
        <translation>移除“%1”</translation>
    </message>
    <message>
        <source>change of the experiment</source>
        <translation>更改实验</translation>
    </message>
    <message>
        <source>air in the room</source>
        <translation>室内空气</translation>
    </message>
    <message>
        <source>calibration of the thermal camera</source>
        <translation>热像仪标定</translation>
    </message>
</context>
<context>
    <name>bask::ExportBar</name>
    <message>
        <source>Computing…</source>
        <translation>正在计算…</translation>
    </message>
    <message>
        <source>Picture %1 of %2</source>
        <translation>图片 %1 / %2</translation>
    </message>
    <message>
        <source>Progress of the export</source>
        <translation>导出进度</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Cancel the export</source>
        <translation>取消导出</translation>
    </message>
</context>
<context>
    <name>bask::FaultMenu</name>
    <message>
        <source>Not on a real rig: faults are simulated on the simulated rig only.</source>
        <translation>实机上不可用：故障只能在仿真装置上模拟。</translation>
    </message>
    <message>
        <source>No simulated fault is active.</source>
        <translation>没有启用的模拟故障。</translation>
    </message>
    <message>
        <source>Active. Choose it again to end it.</source>
        <translation>已启用。再次选择即可结束。</translation>
    </message>
    <message>
        <source>&amp;Simulate fault</source>
        <translation>模拟故障(&amp;S)</translation>
    </message>
</context>
<context>
    <name>bask::FaultWords</name>
    <message>
        <source>%1: %2</source>
        <extracomment>a fault, and the object that it is about</extracomment>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Shows once the object is warmer than the room.</source>
        <translation>物体比室温高时才会显现。</translation>
    </message>
    <message>
        <source>Shows once the two objects have different temperatures.</source>
        <translation>两个物体温度不同时才会显现。</translation>
    </message>
    <message>
        <source>Shows when the heat is switched off.</source>
        <translation>关闭加热时才会显现。</translation>
    </message>
    <message>
        <source>Shows in the picture of the Calibrate page only: nothing else here uses the camera.</source>
        <translation>只在“标定”页的图像中可见：这里没有其他部分使用相机。</translation>
    </message>
    <message>
        <source>Would show nothing here: the thermal camera reads the object, no sensor does.</source>
        <translation>在此什么也不会显现：该物体由热像仪读取，没有传感器。</translation>
    </message>
    <message>
        <source>Would show nothing here: there is no other sensor to swap with.</source>
        <translation>在此什么也不会显现：没有可与之对调的其他传感器。</translation>
    </message>
    <message>
        <source>Would show nothing here: the source has no markers, and nothing follows it.</source>
        <translation>在此什么也不会显现：热源没有标记，也没有任何东西跟踪它。</translation>
    </message>
    <message>
        <source>Would show nothing now: the heat is off. Start a run or heat by hand first.</source>
        <translation>此刻什么也不会显现：加热已关闭。请先开始运行或手动加热。</translation>
    </message>
    <message>
        <source>Would show nothing now: the heat is on. Stop the run or switch it off first.</source>
        <translation>此刻什么也不会显现：加热已打开。请先停止运行或关闭加热。</translation>
    </message>
    <message>
        <source>Would change no run here: no camera follows the source, and there is no thermal camera.</source>
        <translation>在此不会影响任何运行：没有相机跟踪热源，也没有热像仪。</translation>
    </message>
</context>
<context>
    <name>bask::FigureDialog</name>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>With a &amp;heading</source>
        <translation>带标题(&amp;H)</translation>
    </message>
    <message>
        <source>Size of the figure</source>
        <translation>图的尺寸</translation>
    </message>
    <message>
        <source>One column: %1 mm</source>
        <translation>一栏：%1 mm</translation>
    </message>
    <message>
        <source>Two columns: %1 mm</source>
        <translation>两栏：%1 mm</translation>
    </message>
    <message>
        <source>Another</source>
        <translation>其他</translation>
    </message>
    <message>
        <source>Title, names of the files and marked moments. Without it, a simulated run is called so in the corner.</source>
        <translation>标题、文件名和标出的时刻。没有它时，仿真运行在角上注明。</translation>
    </message>
    <message>
        <source>&amp;Size on paper</source>
        <translation>纸上尺寸(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>宽度(&amp;W)</translation>
    </message>
    <message>
        <source>The letters have 7 to 9 points at any width.</source>
        <translation>无论宽度多少，字都为 7 至 9 磅。</translation>
    </message>
    <message>
        <source>Choose the place…</source>
        <translation>选择位置…</translation>
    </message>
</context>
<context>
    <name>bask::FinalValuesTable</name>
    <message>
        <source>Final values</source>
        <translation>最终值</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>物体</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>误差</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>not settled</source>
        <translation>未稳定</translation>
    </message>
    <message>
        <source>Final</source>
        <translation>最终</translation>
    </message>
    <message>
        <source>What the thermometer read when the run was stopped</source>
        <translation>运行停止时温度计的读数</translation>
    </message>
    <message>
        <source>The simulated object&apos;s own temperature when the run was stopped, which no sensor tells</source>
        <translation>运行停止时仿真物体自身的温度，没有传感器能读到</translation>
    </message>
    <message>
        <source>True</source>
        <translation>真实</translation>
    </message>
    <message>
        <source>Settled at</source>
        <translation>稳定时刻</translation>
    </message>
    <message>
        <source>Time of the run from which the object stays within %1 of its target until the end</source>
        <translation>从运行的此时刻起直到结束，物体都保持在目标的 %1 以内</translation>
    </message>
</context>
<context>
    <name>bask::HarmonicsPanel</name>
    <message>
        <source>&amp;Harmonics</source>
        <translation>谐波数(&amp;H)</translation>
    </message>
    <message>
        <source>Number of harmonics</source>
        <translation>谐波的个数</translation>
    </message>
    <message>
        <source>With this number of harmonics the outline crosses itself; choose another.</source>
        <translation>用此谐波数时轮廓自相交；请另选。</translation>
    </message>
    <message>
        <source>Fitting…</source>
        <translation>正在拟合…</translation>
    </message>
    <message>
        <source>Residual &lt;b&gt;%1 mm&lt;/b&gt; rms, &lt;b&gt;%2 mm&lt;/b&gt; at most; Hausdorff &lt;b&gt;%3 mm&lt;/b&gt;; area &lt;b&gt;%4 %&lt;/b&gt;</source>
        <translation>残差：均方根 &lt;b&gt;%1 mm&lt;/b&gt;，最大 &lt;b&gt;%2 mm&lt;/b&gt;；豪斯多夫距离 &lt;b&gt;%3 mm&lt;/b&gt;；面积 &lt;b&gt;%4 %&lt;/b&gt;</translation>
    </message>
    <message>
        <source>%1 mm cannot be reached with up to %2 harmonics: %3 of them come closest, within %4 mm. The outline itself is exact.</source>
        <translation>%1 mm 无法用至多 %2 个谐波达到：%3 个谐波最接近，误差在 %4 mm 以内。轮廓本身是精确的。</translation>
    </message>
    <message>
        <source>With any number of harmonics up to %1 the outline crosses itself. The outline itself is exact.</source>
        <translation>用 %1 个以内的任何谐波数，轮廓都自相交。轮廓本身是精确的。</translation>
    </message>
    <message>
        <source>Fitting… %1 of %2</source>
        <translation>正在拟合… %1 / %2</translation>
    </message>
    <message>
        <source>Fewest harmonics &amp;within</source>
        <translation>最少谐波数，误差不超过(&amp;W)</translation>
    </message>
    <message>
        <source>Chooses the fewest harmonics whose outline does not cross itself and is nowhere farther from the imported one than this (Hausdorff distance).</source>
        <translation>选择最少的谐波数，使轮廓不自相交，且各处与导入轮廓的距离都不超过此值（豪斯多夫距离）。</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Distance within which the Fourier outline shall be</source>
        <translation>傅里叶轮廓应达到的距离</translation>
    </message>
    <message>
        <source>Use the outli&amp;ne itself</source>
        <translation>直接使用轮廓本身(&amp;N)</translation>
    </message>
    <message>
        <source>Takes the imported outline as a polygon, corner by corner, in place of a Fourier outline. Exact; slower the more corners it has.</source>
        <translation>将导入的轮廓逐角点作为多边形使用，代替傅里叶轮廓。精确；角点越多越慢。</translation>
    </message>
    <message>
        <source>The imported outline itself is used: %1 corners.</source>
        <translation>使用导入的轮廓本身：%1 个角点。</translation>
    </message>
    <message>
        <source>The imported outline itself is used, thinned from %1 to %2 corners.</source>
        <translation>使用导入的轮廓本身，由 %1 个角点精简为 %2 个。</translation>
    </message>
    <message>
        <source>Take %1</source>
        <comment>a number of harmonics</comment>
        <translation>采用 %1</translation>
    </message>
    <message>
        <source>Take %1 harmonics</source>
        <translation>采用 %1 个谐波</translation>
    </message>
    <message>
        <source>Residual: between points at equal arc length, as a root mean square (rms) and at most. Hausdorff distance: the farthest that any point of one outline is from the nearest of the other; it is what &quot;Fewest harmonics within&quot; is about. Area: of the Fourier outline against the imported one.</source>
        <translation>残差：弧长相同处两点之间的距离，给出均方根（rms）和最大值。豪斯多夫距离：一条轮廓上任意点到另一条轮廓最近点的最远距离；“最少谐波数，误差不超过”即指它。面积：傅里叶轮廓与导入轮廓之比较。</translation>
    </message>
</context>
<context>
    <name>bask::HeatPanel</name>
    <message>
        <source>Heat the source</source>
        <translation>加热热源</translation>
    </message>
    <message>
        <source>The source heats towards %1 until it is switched off. Is nothing on it or near it that must not get hot?</source>
        <translation>热源将向 %1 加热，直至被关闭。热源上及其附近确实没有怕热的物品吗？</translation>
    </message>
    <message>
        <source>Heat</source>
        <translation>加热</translation>
    </message>
    <message>
        <source>A person keeps the source hot: %1 as typed last.</source>
        <translation>由人工保持热源高温：上次输入为 %1。</translation>
    </message>
    <message>
        <source>Heating towards %1: %2 now.</source>
        <translation>正在向 %1 加热：当前 %2。</translation>
    </message>
    <message>
        <source>The heat is on: %1 now.</source>
        <translation>加热已打开：当前 %1。</translation>
    </message>
    <message>
        <source>The heat is off: %1 now.</source>
        <translation>加热已关闭：当前 %1。</translation>
    </message>
    <message>
        <source>Set point</source>
        <translation>设定值</translation>
    </message>
    <message>
        <source>Set point of the source</source>
        <translation>热源的设定值</translation>
    </message>
    <message>
        <source>Heat the source until it is switched off</source>
        <translation>加热热源，直至被关闭</translation>
    </message>
    <message>
        <source>Heat off</source>
        <translation>关闭加热</translation>
    </message>
    <message>
        <source>Measured by you</source>
        <translation>由您测量</translation>
    </message>
    <message>
        <source>Temperature of the source as you measured it</source>
        <translation>您测得的热源温度</translation>
    </message>
    <message>
        <source>Take</source>
        <translation>采用</translation>
    </message>
    <message>
        <source>UNKNOWN whether it heats: it was asked to heat towards %1. Last seen: %2.</source>
        <translation>是否加热未知：曾要求加热到 %1。最后所见：%2。</translation>
    </message>
    <message>
        <source>UNKNOWN whether it heats. Last seen: %1. Take it for hot.</source>
        <translation>是否加热未知。最后所见：%1。请当作高温对待。</translation>
    </message>
    <message>
        <source>It heats though its heat is off: %1 now. Switch it off at its mains.</source>
        <translation>加热已关闭却仍在加热：当前 %1。请切断其电源。</translation>
    </message>
    <message>
        <source>The heat is off: %1 now, behind the closed shutter of the simulated source.</source>
        <translation>加热已关闭：现在 %1，位于模拟热源闭合的快门之后。</translation>
    </message>
</context>
<context>
    <name>bask::HeldControls</name>
    <message>
        <source>Play</source>
        <translation>播放</translation>
    </message>
    <message>
        <source>Play the surfaces through the robot&apos;s range of the value held, in nine steps.</source>
        <translation>使固定值在机器人的范围内分九步变化，播放等值面。</translation>
    </message>
    <message>
        <source>As at the pose</source>
        <translation>取位姿处的值</translation>
    </message>
    <message>
        <source>Draw the surfaces at the values of the pose that was found.</source>
        <translation>按所找到的位姿的值绘制等值面。</translation>
    </message>
    <message>
        <source>Position at which the surfaces are drawn: %1</source>
        <translation>绘制等值面的位置：%1</translation>
    </message>
    <message>
        <source>Angle at which the surfaces are drawn: %1</source>
        <translation>绘制等值面的角度：%1</translation>
    </message>
</context>
<context>
    <name>bask::IdentifiedLosses</name>
    <message>
        <source>Losses from the record</source>
        <translation>由记录得出的损失</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>物体</translation>
    </message>
    <message>
        <source>At</source>
        <translation>温度</translation>
    </message>
    <message>
        <source>Loss, K/s</source>
        <translation>损失，K/s</translation>
    </message>
    <message>
        <source>Median temperature of the record&apos;s second half</source>
        <translation>记录后半段的中位温度</translation>
    </message>
    <message>
        <source>What radiation and air take together, less what the room gives, with its standard error</source>
        <translation>辐射与空气共同带走的热量减去室内给予的热量，附标准误差</translation>
    </message>
    <message>
        <source>Convection of the air, from the curvature of the radiation&apos;s fourth power</source>
        <translation>空气的对流系数，由辐射四次方的曲率得出</translation>
    </message>
    <message>
        <source>not told</source>
        <translation>无法确定</translation>
    </message>
    <message>
        <source>Its change with the object&apos;s temperature: %1 1/s</source>
        <translation>它随物体温度的变化：%1 1/s</translation>
    </message>
</context>
<context>
    <name>bask::IdentifiedTable</name>
    <message>
        <source>Heat rates from the record</source>
        <translation>由记录得出的热速率</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>物体</translation>
    </message>
    <message>
        <source>Identified</source>
        <translation>辨识值</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>控制器</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>λ₁ by least squares on the whole record, with its standard error</source>
        <translation>对整个记录作最小二乘得到的 λ₁ 及其标准误差</translation>
    </message>
    <message>
        <source>λ₁ that the controller believed at the end</source>
        <translation>控制器最后所认定的 λ₁</translation>
    </message>
    <message>
        <source>λ₁ of the experiment&apos;s material and source</source>
        <translation>由实验的材料和热源得到的 λ₁</translation>
    </message>
    <message>
        <source>λ₂ = %1 1/(K³ s), λ₃ = %2 K/s</source>
        <translation>λ₂ = %1 1/(K³ s)，λ₃ = %2 K/s</translation>
    </message>
    <message>
        <source>not usable</source>
        <translation>不可用</translation>
    </message>
    <message>
        <source>At Start</source>
        <translation>开始时</translation>
    </message>
    <message>
        <source>λ₁ with which the controller began</source>
        <translation>控制器起始时所用的 λ₁</translation>
    </message>
</context>
<context>
    <name>bask::ImportPanel</name>
    <message>
        <source>%1, hole in %2</source>
        <translation>%1，%2 中的孔</translation>
    </message>
    <message>
        <source>%1, open</source>
        <translation>%1，未闭合</translation>
    </message>
    <message>
        <source>&amp;Outlines</source>
        <translation>轮廓(&amp;O)</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>面积</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>导入</translation>
    </message>
    <message>
        <source>Import an outline</source>
        <translation>导入轮廓</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>轮廓</translation>
    </message>
    <message>
        <source>Outline %1: %2 points, %3 around.</source>
        <translation>轮廓 %1：%2 个点，周长 %3。</translation>
    </message>
    <message>
        <source>Outlines of the file</source>
        <translation>文件中的轮廓</translation>
    </message>
    <message>
        <source>Reading the file</source>
        <translation>正在读取文件</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>尺寸</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>%1 counted off.</source>
        <translation>已从面积中扣除 %1。</translation>
    </message>
    <message>
        <source>units</source>
        <translation>单位</translation>
    </message>
    <message>
        <source>The outline is %1 across; an object may be %2 at most. Correct its size.</source>
        <translation>轮廓宽 %1；物体最大为 %2。请更正其尺寸。</translation>
    </message>
</context>
<context>
    <name>bask::ImportQuestions</name>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source> px/mm</source>
        <translation> px/mm</translation>
    </message>
    <message>
        <source>&amp;Dictionary</source>
        <translation>字典(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Length</source>
        <translation>长度(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Scale</source>
        <translation>比例(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Scale from</source>
        <translation>比例来源(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Tolerance</source>
        <translation>容差(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Unit</source>
        <translation>单位(&amp;U)</translation>
    </message>
    <message>
        <source>A printed ArUco marker lies beside the object, in the plane of its face. It tells the scale and undoes the perspective.</source>
        <translation>物体旁有打印的 ArUco 标记，与物体表面共面。由它得出比例并消除透视。</translation>
    </message>
    <message>
        <source>Click its two ends</source>
        <translation>请单击其两端</translation>
    </message>
    <message>
        <source>Click the object</source>
        <translation>请单击物体</translation>
    </message>
    <message>
        <source>Dictionary of the marker</source>
        <translation>标记的字典</translation>
    </message>
    <message>
        <source>Largest distance from the colour clicked, in CIE Lab; 0: found by itself</source>
        <translation>与所单击颜色的最大距离（CIE Lab）；0：自动确定</translation>
    </message>
    <message>
        <source>Lay the ruler over a length that you know: drag its ends, or click both. The picture must be taken straight from above.</source>
        <translation>将标尺置于已知长度之上：拖动其两端，或单击两端。图片必须从正上方拍摄。</translation>
    </message>
    <message>
        <source>Length of the ruler</source>
        <translation>标尺的长度</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>物体</translation>
    </message>
    <message>
        <source>Otherwise by the picture’s opacity or brightness.</source>
        <translation>否则按图片的不透明度或亮度。</translation>
    </message>
    <message>
        <source>S&amp;ide of its square</source>
        <translation>其方形的边长(&amp;I)</translation>
    </message>
    <message>
        <source>Scale of the picture, pixels per millimetre</source>
        <translation>图片的比例，每毫米像素数</translation>
    </message>
    <message>
        <source>Side of the marker’s black square</source>
        <translation>标记黑色方形的边长</translation>
    </message>
    <message>
        <source>The picture must be taken straight from above, or scanned.</source>
        <translation>图片必须从正上方拍摄，或为扫描件。</translation>
    </message>
    <message>
        <source>Tolerance of the colour</source>
        <translation>颜色容差</translation>
    </message>
    <message>
        <source>Unit of the coordinates</source>
        <translation>坐标的单位</translation>
    </message>
    <message>
        <source>What gives the picture its scale</source>
        <translation>由什么确定图片的比例</translation>
    </message>
    <message>
        <source>a known length</source>
        <translation>已知长度</translation>
    </message>
    <message>
        <source>an ArUco marker in it</source>
        <translation>图中的 ArUco 标记</translation>
    </message>
    <message>
        <source>as its header says</source>
        <translation>按文件头</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>pixels per millimetre</source>
        <translation>每毫米像素数</translation>
    </message>
    <message>
        <source>tell it by its colour</source>
        <translation>按颜色识别</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>宽度(&amp;W)</translation>
    </message>
    <message>
        <source>Width of the outline chosen</source>
        <translation>所选轮廓的宽度</translation>
    </message>
    <message>
        <source>As the drawing says. Type another to make all of it larger or smaller.</source>
        <translation>按图形中的值。输入其他值可将整体放大或缩小。</translation>
    </message>
    <message>
        <source>Its true size is not known yet: choose the unit above.</source>
        <translation>其真实尺寸尚不清楚：请在上面选择单位。</translation>
    </message>
    <message>
        <source>Its true size is not known yet: lay the ruler over the length above.</source>
        <translation>其真实尺寸尚不清楚：请将标尺置于上面的长度之上。</translation>
    </message>
    <message>
        <source>Its true size is not known yet: type the length of the ruler above.</source>
        <translation>其真实尺寸尚不清楚：请在上面输入标尺的长度。</translation>
    </message>
    <message>
        <source>Its true size is not known yet: type the scale above.</source>
        <translation>其真实尺寸尚不清楚：请在上面输入比例。</translation>
    </message>
    <message>
        <source>Its true size is not known yet: type the side of the marker’s square above.</source>
        <translation>其真实尺寸尚不清楚：请在上面输入标记方形的边长。</translation>
    </message>
</context>
<context>
    <name>bask::InfeasibleDialog</name>
    <message>
        <source>Start all the same; the recording says so</source>
        <translation>仍然开始；记录中会注明</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>开始</translation>
    </message>
    <message>
        <source>Targets out of reach</source>
        <translation>目标无法达到</translation>
    </message>
    <message>
        <source>The run would end at the best compromise it finds.
The Targets page says more and offers the nearest targets that can be held.</source>
        <translation>运行将止于所找到的最佳折中处。
“目标”页面有详细说明，并给出可保持的最近目标。</translation>
    </message>
</context>
<context>
    <name>bask::JogPanel</name>
    <message>
        <source>Step</source>
        <translation>步长</translation>
    </message>
    <message>
        <source>Step along an axis</source>
        <translation>沿轴的步长</translation>
    </message>
    <message>
        <source>Step about an axis</source>
        <translation>绕轴的步长</translation>
    </message>
    <message>
        <source>Speed while held</source>
        <translation>按住时的速度</translation>
    </message>
    <message>
        <source>Of the largest speed that the robot&apos;s limits allow</source>
        <translation>占机器人限值所允许最大速度的比例</translation>
    </message>
    <message>
        <source>Go to</source>
        <translation>前往位置</translation>
    </message>
    <message>
        <source>One step of %1 down</source>
        <translation>%1 减小一步</translation>
    </message>
    <message>
        <source>One step of %1 up</source>
        <translation>%1 增大一步</translation>
    </message>
    <message>
        <source>%1 downwards for as long as this is held</source>
        <translation>按住期间 %1 持续减小</translation>
    </message>
    <message>
        <source>%1 upwards for as long as this is held</source>
        <translation>按住期间 %1 持续增大</translation>
    </message>
    <message>
        <source>%1 to go to</source>
        <translation>要前往的 %1</translation>
    </message>
    <message>
        <source>Go</source>
        <translation>前往</translation>
    </message>
    <message>
        <source>Move to these coordinates; Hold (F7) ends it</source>
        <translation>运动到这些坐标；“保持”（F7）可使其结束</translation>
    </message>
    <message>
        <source>Here</source>
        <translation>此处</translation>
    </message>
    <message>
        <source>Put in where the robot is</source>
        <translation>填入机器人的当前位置</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>回零</translation>
    </message>
    <message>
        <source>The robot seeks its switches to know its place: it moves</source>
        <translation>机器人寻找限位开关以确定自身位置：它会运动</translation>
    </message>
    <message>
        <source>Clear alarm</source>
        <translation>清除报警</translation>
    </message>
    <message>
        <source>After you have seen to it: the robot is where it says. Nothing moves.</source>
        <translation>请在处理之后使用：确认机器人就在它所报的位置。没有运动。</translation>
    </message>
    <message>
        <source>Place UNKNOWN. What stands below is %1.</source>
        <translation>位置未知。以下数值：%1。</translation>
    </message>
    <message>
        <source>Place UNKNOWN: the robot has not told it yet.</source>
        <translation>位置未知：机器人尚未告知。</translation>
    </message>
    <message>
        <source>Confirm its place</source>
        <translation>确认其位置</translation>
    </message>
</context>
<context>
    <name>bask::LabelsDialog</name>
    <message>
        <source>Before the run</source>
        <translation>运行之前</translation>
    </message>
    <message>
        <source>Operator and sample</source>
        <translation>操作员和样品</translation>
    </message>
    <message>
        <source>The run that is on has it; it can be changed after the run.</source>
        <translation>正在进行的运行使用它；运行之后可以更改。</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>操作员</translation>
    </message>
    <message>
        <source>Sample</source>
        <translation>样品</translation>
    </message>
    <message>
        <source>Batch</source>
        <translation>批次</translation>
    </message>
    <message>
        <source>Recordings, reports and the list of runs show them. Each command, note and acknowledgement is recorded with its operator.</source>
        <translation>记录、报告和运行列表都会显示它们。每条命令、备注和确认都连同其操作员一起记录。</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>待命</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>确定</translation>
    </message>
    <message>
        <source>Ask at each Arm</source>
        <translation>每次待命时询问</translation>
    </message>
</context>
<context>
    <name>bask::LargeNumbers</name>
    <message>
        <source>Run %1</source>
        <comment>%1 is the time since Start</comment>
        <translation>运行 %1</translation>
    </message>
    <message>
        <source>Source %1</source>
        <comment>%1 is its newest temperature</comment>
        <translation>热源 %1</translation>
    </message>
    <message>
        <source>The engine is not answering: what is shown is old.</source>
        <translation>引擎没有应答：所显示的内容已过时。</translation>
    </message>
    <message>
        <source>Bask: large numbers</source>
        <translation>Bask：大号数字</translation>
    </message>
    <message>
        <source>In %1 s: %2</source>
        <comment>seconds, and what the engine does then</comment>
        <translation>%1 s 后：%2</translation>
    </message>
</context>
<context>
    <name>bask::LimitsPanel</name>
    <message>
        <source>Heat source</source>
        <translation>热源</translation>
    </message>
    <message>
        <source>Measured temperature</source>
        <translation>测得的温度</translation>
    </message>
    <message>
        <source>Set point of runs</source>
        <translation>运行的设定值</translation>
    </message>
    <message>
        <source>Emittance</source>
        <translation>发射率</translation>
    </message>
    <message>
        <source>Emittance of the source</source>
        <translation>热源的发射率</translation>
    </message>
    <message>
        <source>Workspace of the end-effector</source>
        <translation>末端执行器的工作空间</translation>
    </message>
    <message>
        <source>From</source>
        <translation>从</translation>
    </message>
    <message>
        <source>To</source>
        <translation>至</translation>
    </message>
    <message>
        <source>Least %1</source>
        <translation>%1 的最小值</translation>
    </message>
    <message>
        <source>Largest %1</source>
        <translation>%1 的最大值</translation>
    </message>
    <message>
        <source>Limits of motion</source>
        <translation>运动限值</translation>
    </message>
    <message>
        <source>%1: %2 instead of %3</source>
        <translation>%1：%2，而不是 %3</translation>
    </message>
    <message>
        <source>Evenness</source>
        <translation>均匀性</translation>
    </message>
</context>
<context>
    <name>bask::LivePicture</name>
    <message>
        <source>%1 pictures/s</source>
        <translation>%1 帧/s</translation>
    </message>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>Live picture of the camera</source>
        <translation>相机实时图像</translation>
    </message>
    <message>
        <source>No picture yet: no camera is running.</source>
        <translation>尚无图像：没有相机在运行。</translation>
    </message>
    <message>
        <source>Nothing is found in the picture</source>
        <translation>图像中未找到任何内容</translation>
    </message>
    <message>
        <source>age %1 s</source>
        <translation>时龄 %1 s</translation>
    </message>
    <message>
        <source>base</source>
        <translation>基座</translation>
    </message>
    <message>
        <source>end-effector</source>
        <translation>末端执行器</translation>
    </message>
    <message>
        <source>latency %1 ms</source>
        <translation>延迟 %1 ms</translation>
    </message>
    <message>
        <source>marker %1</source>
        <translation>标记 %1</translation>
    </message>
    <message>
        <source>marker %1, %2</source>
        <translation>标记 %1，%2</translation>
    </message>
    <message>
        <source>simulated</source>
        <translation>仿真</translation>
    </message>
    <message>
        <source>source</source>
        <translation>热源</translation>
    </message>
    <message>
        <source>source predicted</source>
        <translation>热源为预测</translation>
    </message>
    <message>
        <source>source searched</source>
        <translation>正在寻找热源</translation>
    </message>
    <message>
        <source>source tracked</source>
        <translation>正在跟踪热源</translation>
    </message>
    <message>
        <source>the board</source>
        <translation>标定板</translation>
    </message>
    <message>
        <source>two poses</source>
        <translation>两种位姿</translation>
    </message>
</context>
<context>
    <name>bask::MainWindow</name>
    <message>
        <source>Not taken: the targets stay as they were.</source>
        <translation>未采用：目标保持原样。</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>页面</translation>
    </message>
    <message>
        <source>Arm the real rig</source>
        <translation>使实际装置进入待命</translation>
    </message>
    <message>
        <source>This rig is real: once the run is started, the robot moves and the source heats. Is everybody and everything out of the way?</source>
        <translation>这是实际装置：一旦开始运行，机器人就会运动，热源就会加热。所有人员和物品都已避开了吗？</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>待命</translation>
    </message>
    <message>
        <source>Only files of this computer can be opened: save it here first.</source>
        <translation>只能打开此计算机上的文件：请先将其保存到此处。</translation>
    </message>
    <message>
        <source>Only one file can be opened at a time.</source>
        <translation>一次只能打开一个文件。</translation>
    </message>
    <message>
        <source>Unsaved edits cannot be kept for a crash: %1</source>
        <translation>无法为防备崩溃而保留未保存的更改：%1</translation>
    </message>
    <message>
        <source>From the next start of Bask on, text and all that is drawn with it has %1 % of its size.</source>
        <translation>从 Bask 下次启动起，文字及随之绘制的一切将为原大小的 %1 %。</translation>
    </message>
    <message>
        <source>The window will then be larger than this screen.</source>
        <translation>届时窗口将大于此屏幕。</translation>
    </message>
    <message>
        <source>Bask closes when the objects are away from the source.</source>
        <translation>物体离开热源后，Bask 即关闭。</translation>
    </message>
    <message>
        <source>Retreat</source>
        <translation>撤离</translation>
    </message>
    <message>
        <source>Retreat now</source>
        <translation>立即撤离</translation>
    </message>
    <message>
        <source>This was the horn: the desktop&apos;s bell. If you heard nothing, it is off in the desktop&apos;s settings.</source>
        <translation>刚才是报警声：桌面的提示音。若没有听到，说明它在桌面设置中已关闭。</translation>
    </message>
    <message>
        <source>Bask stays open: the run ended by a fault. Look at the alarms.</source>
        <translation>Bask 保持打开：运行因故障结束。请查看报警。</translation>
    </message>
    <message>
        <source>Simulated faults are active: %1. Tools &gt; Simulate fault ends them.</source>
        <translation>有启用的模拟故障：%1。可在“工具 &gt; 模拟故障”中结束。</translation>
    </message>
    <message>
        <source>The objects are over the source, which has %1: its heat reaches them although no run is on. Warm sensors cannot be zeroed, and a run begins with objects as warm as they are then. Retreat takes them away.</source>
        <translation>物体在热源上方，热源为 %1：虽然没有运行，热量仍会到达物体。变热的传感器无法校零，运行将以物体当时的温度开始。“撤离”会将其移开。</translation>
    </message>
    <message>
        <source>source %1 of %2</source>
        <comment>temperatures: that of now, and the set point</comment>
        <translation>热源 %1 / %2</translation>
    </message>
    <message>
        <source>over hot source: %1</source>
        <comment>the objects are over it; its temperature</comment>
        <translation>物体下方热源：%1</translation>
    </message>
    <message>
        <source>Arm the simulated rig</source>
        <translation>使模拟装置进入待命</translation>
    </message>
    <message>
        <source>The robot will move: it takes the objects away from the source, and the heat goes off. Are all hands off the robot and is nothing in its way?</source>
        <translation>机器人即将运动：使物体离开热源，并关闭加热。所有人的手都已离开机器人，且路径上没有障碍吗？</translation>
    </message>
    <message>
        <source>Home the robot</source>
        <translation>机器人回零</translation>
    </message>
    <message>
        <source>Home now</source>
        <translation>立即回零</translation>
    </message>
    <message>
        <source>The question &quot;%1&quot; was closed: the state has changed since it was asked.</source>
        <translation>问题“%1”已关闭：提出后状态已改变。</translation>
    </message>
    <message>
        <source>ready in %1 s</source>
        <comment>readings are being collected</comment>
        <translation>%1 s 后就绪</translation>
    </message>
    <message>
        <source>The robot will move: it seeks its switches to know its place. Are all hands off the robot and is nothing in its way?</source>
        <translation>机器人即将运动：它寻找其限位开关以确定位置。所有人的手是否都已离开机器人，其路径上是否没有障碍？</translation>
    </message>
    <message>
        <source>%1. Are they mounted so all the same?</source>
        <translation>%1。它们确实是这样安装的吗？</translation>
    </message>
    <message>
        <source>Nothing else begins while the question &quot;%1&quot; is open: answer it first. Hold, Stop and STOP are possible.</source>
        <translation>问题“%1”未回答之前，不会开始任何其他操作：请先回答。“保持”、“停止”和“软件停止”仍可使用。</translation>
    </message>
    <message>
        <source>Ready, but: %1. Arm asks about it.</source>
        <translation>就绪，但是：%1。“待命”时会询问。</translation>
    </message>
    <message>
        <source>Ready; whether the targets can be held is being checked.</source>
        <translation>就绪；正在检查目标能否保持。</translation>
    </message>
    <message>
        <source>Ready, but: %1. Start asks about it.</source>
        <translation>就绪，但是：%1。“开始”时会询问。</translation>
    </message>
    <message>
        <source>objects overlap</source>
        <translation>物体重叠</translation>
    </message>
    <message>
        <source>cannot be held</source>
        <comment>the targets</comment>
        <translation>目标无法保持</translation>
    </message>
    <message>
        <source>STOP was pressed</source>
        <translation>已按软件停止</translation>
    </message>
    <message>
        <source>The targets cannot be held: %1. Start asks about it.</source>
        <translation>目标无法保持：%1。“开始”时会询问。</translation>
    </message>
    <message>
        <source>The objects stay where they are, near the source, and go on towards the temperature that they reach there; Retreat takes them away.</source>
        <translation>物体停在热源附近原处，温度会继续趋向该处的终值；“撤离”可使其离开。</translation>
    </message>
</context>
<context>
    <name>bask::ManualWindow</name>
    <message>
        <source>Bask: manual</source>
        <translation>Bask：手册</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>返回</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>目录</translation>
    </message>
    <message>
        <source>Find in the manual</source>
        <translation>在手册中查找</translation>
    </message>
    <message>
        <source>Text of the manual</source>
        <translation>手册正文</translation>
    </message>
    <message>
        <source>This page is in English only.</source>
        <translation>本页只有英文版。</translation>
    </message>
</context>
<context>
    <name>bask::MarkerEditor</name>
    <message>
        <source>%1 px off</source>
        <translation>偏离 %1 px</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>添加</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>基座</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>相机</translation>
    </message>
    <message>
        <source>Dictionary</source>
        <translation>字典</translation>
    </message>
    <message>
        <source>End-effector</source>
        <translation>末端执行器</translation>
    </message>
    <message>
        <source>Id</source>
        <translation>编号</translation>
    </message>
    <message>
        <source>Lists another marker: one that the camera sees and that is not listed, if there is one</source>
        <translation>再列入一个标记：若有相机见到而未列入的标记，则列入它</translation>
    </message>
    <message>
        <source>Markers of the rig</source>
        <translation>装置上的标记</translation>
    </message>
    <message>
        <source>On</source>
        <translation>位于</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>边长</translation>
    </message>
    <message>
        <source>Side, mm</source>
        <translation>边长，mm</translation>
    </message>
    <message>
        <source>Sits on</source>
        <translation>所在部位</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>热源</translation>
    </message>
    <message>
        <source>Where the marker&apos;s middle is on its part, and how its axes (x right, y up, z out of it) are turned there</source>
        <translation>标记中心在其部位上的位置，以及其坐标轴（x 向右，y 向上，z 向外）在该处如何转动</translation>
    </message>
    <message>
        <source>With the black border, as measured on the print</source>
        <translation>含黑色边框，按打印件实测</translation>
    </message>
    <message>
        <source>about y, °</source>
        <translation>绕 y，°</translation>
    </message>
    <message>
        <source>about z, °</source>
        <translation>绕 z，°</translation>
    </message>
    <message>
        <source>not seen</source>
        <translation>未见到</translation>
    </message>
    <message>
        <source>seen</source>
        <translation>已见到</translation>
    </message>
    <message>
        <source>turned about x, °</source>
        <translation>绕 x 转动，°</translation>
    </message>
    <message>
        <source>two poses fit</source>
        <translation>符合两种位姿</translation>
    </message>
    <message>
        <source>x, mm</source>
        <translation>x，mm</translation>
    </message>
    <message>
        <source>y, mm</source>
        <translation>y，mm</translation>
    </message>
    <message>
        <source>z, mm</source>
        <translation>z，mm</translation>
    </message>
</context>
<context>
    <name>bask::MaterialControl</name>
    <message>
        <source>Your library of materials cannot be used and is left as it is: %1. Mend the file or move it elsewhere.</source>
        <translation>您的材料库无法使用，并保持原样：%1。请修复该文件或将其移到别处。</translation>
    </message>
    <message>
        <source>Import materials</source>
        <translation>导入材料</translation>
    </message>
    <message>
        <source>Materials (*.json);;All files (*)</source>
        <translation>材料 (*.json);;所有文件 (*)</translation>
    </message>
    <message>
        <source>%1: %2 added, %3 of them under another name, since theirs was taken; %4 were there already.</source>
        <translation>%1：已添加 %2 种，其中 %3 种因名称已被占用而改名；%4 种原已存在。</translation>
    </message>
    <message>
        <source>Export the library of materials</source>
        <translation>导出材料库</translation>
    </message>
    <message>
        <source>Materials (*.json)</source>
        <translation>材料 (*.json)</translation>
    </message>
    <message>
        <source>%1 was written.</source>
        <translation>已写入 %1。</translation>
    </message>
</context>
<context>
    <name>bask::MaterialsDialog</name>
    <message>
        <source>Rename</source>
        <translation>重命名</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
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
        <source>Materials</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>The library is empty. “Save as material” on the Objects page adds an object&apos;s material, Import those of a file.</source>
        <translation>材料库是空的。“物体”页上的“存为材料”可添加物体的材料，“导入”可添加文件中的材料。</translation>
    </message>
    <message>
        <source>“%1” was removed.</source>
        <translation>已移除“%1”。</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>撤销</translation>
    </message>
</context>
<context>
    <name>bask::MessageBar</name>
    <message>
        <source>Close the message</source>
        <translation>关闭此消息</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>问题</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>提示</translation>
    </message>
</context>
<context>
    <name>bask::Metrics</name>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>start unknown</source>
        <translation>起点未知</translation>
    </message>
    <message>
        <source>step too small</source>
        <translation>阶跃太小</translation>
    </message>
    <message>
        <source>not reached</source>
        <translation>未达到</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>not settled</source>
        <translation>未稳定</translation>
    </message>
    <message>
        <source>%1 (s.d. %2)</source>
        <comment>mean with its unit, standard deviation without</comment>
        <translation>%1（标准差 %2）</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>Final</source>
        <translation>最终</translation>
    </message>
    <message>
        <source>Settling time</source>
        <translation>稳定时间</translation>
    </message>
    <message>
        <source>Rise time</source>
        <translation>上升时间</translation>
    </message>
    <message>
        <source>Overshoot</source>
        <translation>超调</translation>
    </message>
    <message>
        <source>Steady-state error</source>
        <translation>稳态误差</translation>
    </message>
    <message>
        <source>Path length</source>
        <translation>路径长度</translation>
    </message>
    <message>
        <source>Duration of control</source>
        <translation>控制时长</translation>
    </message>
    <message>
        <source>Path of the end-effector</source>
        <translation>末端执行器的路径</translation>
    </message>
    <message>
        <source>Rotation of the end-effector</source>
        <translation>末端执行器的转动</translation>
    </message>
    <message>
        <source>Time at a velocity limit</source>
        <translation>处于速度限值的时间</translation>
    </message>
    <message>
        <source>Time at any limit</source>
        <translation>处于任一限值的时间</translation>
    </message>
    <message>
        <source>The last target that was set. The other numbers count from that moment, or from Start when it was not changed, until Stop.</source>
        <translation>最后设定的目标。其余数值从该时刻（若未更改过，则从“开始”）算起，到“停止”为止。</translation>
    </message>
    <message>
        <source>How far the temperature went beyond the target in the direction of the step, and as a share of the step. Not given for steps under twice the band.</source>
        <translation>温度沿阶跃方向超出目标的量，以及它占阶跃的比例。阶跃小于容差带两倍时不给出。</translation>
    </message>
    <message>
        <source>From Start until Stop.</source>
        <translation>从“开始”到“停止”。</translation>
    </message>
    <message>
        <source>Sum of the angles by which the end-effector was turned from sample to sample.</source>
        <translation>各采样之间末端执行器所转角度之和。</translation>
    </message>
    <message>
        <source>Time in which the limit of speed or of rotation held the command back.</source>
        <translation>指令受速度限值或转动限值约束的时间。</translation>
    </message>
    <message>
        <source>Time in which a limit of any kind held the command back: speed, rotation, acceleration, clearance or workspace.</source>
        <translation>指令受任何一种限值约束的时间：速度、转动、加速度、间距或工作空间。</translation>
    </message>
    <message>
        <source>no samples</source>
        <translation>没有采样</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>%1, true</source>
        <comment>a metric by the true temperature</comment>
        <translation>%1（真实）</translation>
    </message>
    <message>
        <source>The same by the simulated object&apos;s own temperature, which no sensor tells.</source>
        <translation>按仿真物体自身的温度计算的同一指标，没有传感器能读到该温度。</translation>
    </message>
    <message>
        <source>What the object&apos;s thermometer read at the last sample until Stop. The other numbers take its readings, too. ± is the standard uncertainty: of a sensor that of the room&apos;s temperature to which it was zeroed, of its zeroing, and of step and noise of its readings, without its own error away from the room&apos;s temperature and that of its contact.</source>
        <translation>物体的温度计在到“停止”为止的最后一个采样时的读数。其他数值也取其读数。± 为标准不确定度：对传感器而言，来自校零所依据的室温、校零本身以及读数的步长和噪声，不包括其远离室温时自身的误差和接触的误差。</translation>
    </message>
    <message>
        <source>Mean of temperature minus target over the last %1 s until Stop, or since settling where that is less, with its standard uncertainty (±) and the standard deviation of the samples.</source>
        <translation>到“停止”为止的最后 %1 s 内（若稳定后的时间更短，则自稳定时起）温度减目标的平均值，附其标准不确定度（±）和各采样的标准差。</translation>
    </message>
    <message>
        <source>, not sure</source>
        <comment>after a number</comment>
        <translation>，不确定</translation>
    </message>
    <message>
        <source>Time until the temperature stays within %1 of the target until Stop. The event &quot;All objects settled&quot; is another and comes later: when all objects have been so near for %2 s by the controller&apos;s estimates, and the robot needs no other place. ± is its standard uncertainty: how far readings that are wrong by theirs move that moment, and the period. Not sure: with such an error it would be outside at the end.</source>
        <translation>直到温度进入目标的 %1 以内并保持到“停止”为止所需的时间。事件“所有物体均已稳定”是另一回事，并且更晚：按控制器的估计，全部物体已如此接近 %2 s，且机器人无需再去别处。± 为其标准不确定度：读数偏差为其不确定度时该时刻移动多少，以及周期。“不确定”：有这样的误差时，结束时温度在范围之外。</translation>
    </message>
    <message>
        <source>Time between the first crossings of 10 % and of 90 % of the step, which leads from the temperature when the target was set to the target. Not given for steps under twice the band. ± is its standard uncertainty: how far wrong readings at the beginning and at both crossings move these.</source>
        <translation>首次越过阶跃的 10 % 与首次越过 90 % 之间的时间；阶跃从设定目标时的温度到目标为止。阶跃小于容差带两倍时不给出。± 为其标准不确定度：开始时和两次越过时的读数误差使其移动多少。</translation>
    </message>
    <message>
        <source>Length of the path of the object&apos;s centre in the robot&apos;s base, from Start until Stop, by the robot&apos;s reported places, whose uncertainty no device tells.</source>
        <translation>从“开始”到“停止”，物体中心在机器人基座坐标系中所走路径的长度，按机器人报告的位置计算，没有设备给出其不确定度。</translation>
    </message>
    <message>
        <source>Length of the path of the end-effector&apos;s origin in the robot&apos;s base, from Start until Stop, by the robot&apos;s reported places, whose uncertainty no device tells.</source>
        <translation>从“开始”到“停止”，末端执行器原点在机器人基座坐标系中所走路径的长度，按机器人报告的位置计算，没有设备给出其不确定度。</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>阶跃</translation>
    </message>
    <message>
        <source>%1 at %2 s</source>
        <comment>difference of temperatures; time of the run</comment>
        <translation>%1，始于 %2 s</translation>
    </message>
    <message>
        <source>The target minus the temperature when it was set: at Start, or at the time beside it where the target was changed during the run. Times, overshoot and steady-state error are of this step.</source>
        <translation>目标减去设定目标时的温度：设定于开始时；若运行中更改过目标，则为旁边标明的时刻。时间、超调和稳态误差均针对这一阶跃。</translation>
    </message>
</context>
<context>
    <name>bask::MetricsPanel</name>
    <message>
        <source>How these numbers are defined</source>
        <translation>这些数值的定义</translation>
    </message>
    <message>
        <source>Metrics of the run</source>
        <translation>本次运行的指标</translation>
    </message>
</context>
<context>
    <name>bask::MonitorControl</name>
    <message>
        <source>Monitoring is off: %1</source>
        <translation>监视已关闭：%1</translation>
    </message>
</context>
<context>
    <name>bask::MonitorDialog</name>
    <message>
        <source>Publish to an MQTT broker</source>
        <translation>发布到 MQTT 代理</translation>
    </message>
    <message>
        <source>Write status files</source>
        <translation>写入状态文件</translation>
    </message>
    <message>
        <source>Monitoring</source>
        <translation>监视</translation>
    </message>
    <message>
        <source>Encrypted (TLS)</source>
        <translation>加密（TLS）</translation>
    </message>
    <message>
        <source>those of the system</source>
        <translation>系统的证书</translation>
    </message>
    <message>
        <source>Its first line is the password; nobody else may read the file.</source>
        <translation>首行为密码；其他人不得读取此文件。</translation>
    </message>
    <message>
        <source>In front of all topics, with a slash: lab2/bask becomes lab2/bask/status and so on.</source>
        <translation>置于所有主题之前，以斜杠分隔：lab2/bask 成为 lab2/bask/status 等。</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>地址</translation>
    </message>
    <message>
        <source>Trusted certificates</source>
        <translation>受信任的证书</translation>
    </message>
    <message>
        <source>User</source>
        <translation>用户</translation>
    </message>
    <message>
        <source>File with the password</source>
        <translation>密码文件</translation>
    </message>
    <message>
        <source>Topic</source>
        <translation>主题</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>文件夹</translation>
    </message>
    <message>
        <source>Folder of the status files</source>
        <translation>状态文件的文件夹</translation>
    </message>
    <message>
        <source>Bask publishes only: nobody can give it an order this way, and it opens no port. The setting belongs to this computer; no experiment can switch it on.</source>
        <translation>Bask 只发布：任何人都不能以这种方式对它下达命令，它也不打开任何端口。此设置属于这台计算机；任何实验都不能将其打开。</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>测试</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>确定</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>选择…</translation>
    </message>
    <message>
        <source>Trying…</source>
        <translation>正在尝试…</translation>
    </message>
    <message>
        <source>It works: everything that is ticked has taken a message.</source>
        <translation>可以使用：所有勾选项都收到了一条消息。</translation>
    </message>
    <message>
        <source>Without TLS the password goes over the network in clear text.</source>
        <translation>没有 TLS，密码将以明文通过网络传送。</translation>
    </message>
</context>
<context>
    <name>bask::MountingPlan</name>
    <message>
        <source>Plan of the objects on the end-effector</source>
        <translation>物体在末端执行器上的平面图</translation>
    </message>
    <message>
        <source>The objects on the end-effector, to scale. Drag one to move it in steps of 5 mm, its handle to turn it in steps of 5°; with Alt finely. Arrow keys move the selected one by 1 mm, Page Up and Page Down turn it.</source>
        <translation>末端执行器上的物体，按比例绘制。拖动物体可按 5 mm 的步长移动，拖动其手柄可按 5° 的步长转动；按住 Alt 可微调。方向键使所选物体移动 1 mm，Page Up 和 Page Down 使其转动。</translation>
    </message>
    <message>
        <source>Grid %1, snap %2</source>
        <translation>网格 %1，吸附 %2</translation>
    </message>
    <message>
        <source>x %1 cm, y %2 cm, %3°</source>
        <translation>x %1 cm，y %2 cm，%3°</translation>
    </message>
    <message>
        <source>Objects on the end-effector from the front</source>
        <translation>末端执行器上的物体，正视图</translation>
    </message>
    <message>
        <source>Objects on the end-effector from the side</source>
        <translation>末端执行器上的物体，侧视图</translation>
    </message>
    <message>
        <source>The objects edge-on, to the scale of the plan. Drag one to change its height in steps of 5 mm, its handle to tilt it in steps of 5°; with Alt finely. Arrow keys move the selected one by 1 mm, Page Up and Page Down tilt it.</source>
        <translation>从侧面看到的物体，比例与平面图相同。拖动物体可按 5 mm 的步长改变高度，拖动其手柄可按 5° 的步长倾斜；按住 Alt 可微调。方向键使所选物体移动 1 mm，Page Up 和 Page Down 使其倾斜。</translation>
    </message>
    <message>
        <source>z %1 cm, tilt %2° about x, %3° about y</source>
        <translation>z %1 cm，绕 x 倾斜 %2°，绕 y 倾斜 %3°</translation>
    </message>
    <message>
        <source>Arrows: where the heated faces look</source>
        <translation>箭头：受热面的朝向</translation>
    </message>
</context>
<context>
    <name>bask::MountingViews</name>
    <message>
        <source>Heights and tilts</source>
        <translation>高度与倾角</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>正面</translation>
    </message>
    <message>
        <source>Seen along y: x to the right, z up</source>
        <translation>沿 y 方向看：x 向右，z 向上</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>侧面</translation>
    </message>
    <message>
        <source>Seen against x: y to the right, z up</source>
        <translation>逆 x 方向看：y 向右，z 向上</translation>
    </message>
</context>
<context>
    <name>bask::NumberField</name>
    <message>
        <source>“%1” is not a number; the value stays as it was</source>
        <translation>“%1”不是数字；数值保持不变</translation>
    </message>
    <message>
        <source>“%1” is out of range; allowed: %2 to %3</source>
        <translation>“%1”超出范围；允许：%2 至 %3</translation>
    </message>
    <message>
        <source>“%1” was not taken: this value has no unit</source>
        <translation>未采用“%1”：此值没有单位</translation>
    </message>
    <message>
        <source>“%1” was not taken: %2 is not a unit of this value, which is in %3</source>
        <translation>未采用“%1”：%2 不是此值的单位，此值以 %3 为单位</translation>
    </message>
    <message>
        <source>“%1” may be one of two numbers: type %2 or %3</source>
        <translation>“%1”可能是两个数之一：请输入 %2 或 %3</translation>
    </message>
    <message>
        <source>“%1” was not taken: with the digits of this field it would be %2</source>
        <translation>未采用“%1”：按此字段的位数将变为 %2</translation>
    </message>
    <message>
        <source>“%1” is out of range; allowed: more than %2, up to %3</source>
        <translation>“%1”超出范围；允许：大于 %2，至 %3</translation>
    </message>
</context>
<context>
    <name>bask::ObjectList</name>
    <message>
        <source>disk, %1 cm</source>
        <translation>圆盘，%1 cm</translation>
    </message>
    <message>
        <source>polygon</source>
        <translation>多边形</translation>
    </message>
    <message>
        <source>Objects</source>
        <translation>物体</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <comment>kind and target of an object</comment>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>%1: %2. Press F2 to rename.</source>
        <translation>%1：%2。按 F2 重命名。</translation>
    </message>
</context>
<context>
    <name>bask::ObjectProperties</name>
    <message>
        <source>Heat capacity</source>
        <translation>热容</translation>
    </message>
    <message>
        <source>Time constant</source>
        <translation>时间常数</translation>
    </message>
    <message>
        <source>Of the plate, per area that is seen</source>
        <translation>板材的值，按可见面积计</translation>
    </message>
    <message>
        <source>Of small changes about the target</source>
        <translation>目标附近的微小变化</translation>
    </message>
    <message>
        <source>Heating at view factor 1 with the source as it is set</source>
        <translation>角系数为 1、热源按当前设置时的升温</translation>
    </message>
    <message>
        <source>Times T⁴: what the object radiates</source>
        <translation>乘以 T⁴：物体辐射出的部分</translation>
    </message>
    <message>
        <source>What the surroundings give</source>
        <translation>来自周围环境的部分</translation>
    </message>
    <message>
        <source>typed values</source>
        <translation>输入的值</translation>
    </message>
    <message>
        <source>typed values (%1)</source>
        <translation>输入的值（%1）</translation>
    </message>
    <message>
        <source>Disk</source>
        <translation>圆盘</translation>
    </message>
    <message>
        <source>Fourier outline, %1</source>
        <translation>傅里叶轮廓，%1</translation>
    </message>
    <message>
        <source>Polygon</source>
        <translation>多边形</translation>
    </message>
    <message>
        <source>%1 cm²</source>
        <translation>%1 cm²</translation>
    </message>
    <message>
        <source>%1 cm</source>
        <translation>%1 cm</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>物体</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>Mounting on the end-effector</source>
        <translation>在末端执行器上的安装</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>半径</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>面积</translation>
    </message>
    <message>
        <source>Perimeter</source>
        <translation>周长</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>预设</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>Rotation about z</source>
        <translation>绕 z 转动</translation>
    </message>
    <message>
        <source>Mounting x</source>
        <translation>安装 x</translation>
    </message>
    <message>
        <source>Mounting y</source>
        <translation>安装 y</translation>
    </message>
    <message>
        <source>Mounting z</source>
        <translation>安装 z</translation>
    </message>
    <message>
        <source> cm</source>
        <translation> cm</translation>
    </message>
    <message>
        <source> °</source>
        <translation> °</translation>
    </message>
    <message>
        <source>%1 J/(m²·K)</source>
        <translation>%1 J/(m²·K)</translation>
    </message>
    <message>
        <source>%1 K/s</source>
        <translation>%1 K/s</translation>
    </message>
    <message>
        <source>%1 K⁻³·s⁻¹</source>
        <translation>%1 K⁻³·s⁻¹</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>%1 h</source>
        <translation>%1 h</translation>
    </message>
    <message>
        <source>%1 without holes</source>
        <translation>不计孔时 %1</translation>
    </message>
    <message>
        <source>z, height</source>
        <translation>z，高度</translation>
    </message>
    <message>
        <source>Tilt about x</source>
        <translation>绕 x 倾斜</translation>
    </message>
    <message>
        <source>Tilt about y</source>
        <translation>绕 y 倾斜</translation>
    </message>
    <message>
        <source>The object is turned about the end-effector&apos;s x first, then about its y, then about its z</source>
        <translation>物体先绕末端执行器的 x 轴转动，再绕 y 轴，然后绕 z 轴</translation>
    </message>
    <message>
        <source>Save as material…</source>
        <translation>存为材料…</translation>
    </message>
    <message>
        <source>Keeps these values in your library of materials</source>
        <translation>把这些数值存入您的材料库</translation>
    </message>
    <message>
        <source>Materials…</source>
        <translation>材料…</translation>
    </message>
    <message>
        <source>Your library of materials: see, rename, remove, import and export</source>
        <translation>您的材料库：查看、重命名、移除、导入和导出</translation>
    </message>
</context>
<context>
    <name>bask::ObjectTile</name>
    <message>
        <source>Mean of the last 10 s</source>
        <translation>最近 10 s 的平均值</translation>
    </message>
    <message>
        <source>No reading yet</source>
        <translation>尚无读数</translation>
    </message>
    <message>
        <source>Heating</source>
        <translation>正在升温</translation>
    </message>
    <message>
        <source>Cooling</source>
        <translation>正在降温</translation>
    </message>
    <message>
        <source>Off target</source>
        <comment>steady, outside the tolerance band</comment>
        <translation>偏离目标</translation>
    </message>
    <message>
        <source>Settling</source>
        <translation>正在稳定</translation>
    </message>
    <message>
        <source>Settled</source>
        <translation>已稳定</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>误差</translation>
    </message>
    <message>
        <source>Measured minus target</source>
        <translation>测量值减目标</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>变化率</translation>
    </message>
    <message>
        <source>Object %1</source>
        <translation>物体 %1</translation>
    </message>
    <message>
        <source>Measured temperature of %1</source>
        <translation>%1 的测量温度</translation>
    </message>
    <message>
        <source>UNKNOWN</source>
        <comment>the temperature of an object</comment>
        <translation>未知</translation>
    </message>
    <message>
        <source>Stale</source>
        <comment>the reading of an object</comment>
        <translation>过时</translation>
    </message>
    <message>
        <source>Not believed</source>
        <comment>the reading of an object</comment>
        <translation>不采信</translation>
    </message>
    <message>
        <source>Confirm</source>
        <translation>确认</translation>
    </message>
    <message>
        <source>Confirm the sensor of %1</source>
        <translation>确认 %1 的传感器</translation>
    </message>
    <message>
        <source>You have looked: the sensor is on its object and right. It is believed again.</source>
        <translation>您已查看：传感器在物体上且正确。将重新采信。</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>热像仪 %1</translation>
    </message>
    <message>
        <source>Above its warning limit</source>
        <comment>the temperature of an object</comment>
        <translation>超过警告限值</translation>
    </message>
    <message>
        <source>Above its trip limit</source>
        <comment>the temperature of an object</comment>
        <translation>超过跳闸限值</translation>
    </message>
    <message>
        <source>Standard uncertainty %1 %2. Of a sensor it is that of the room&apos;s temperature to which it was zeroed, of its zeroing, and of step and noise of its readings. Not in it: the sensor&apos;s own error away from the room&apos;s temperature, and how well it touches its object.</source>
        <translation>标准不确定度 %1 %2。对传感器而言，它来自校零所依据的室温、校零本身，以及读数的步长和噪声。不包括：传感器在远离室温时自身的误差，以及它与物体接触的好坏。</translation>
    </message>
    <message>
        <source>same for %1 s</source>
        <comment>the value of a frozen sensor</comment>
        <translation>%1 s 未变</translation>
    </message>
    <message>
        <source>same for %1</source>
        <comment>the value of a frozen sensor; %1 is minutes and seconds</comment>
        <translation>%1 未变</translation>
    </message>
    <message>
        <source>Camera %1 (part)</source>
        <translation>热像仪 %1（部分）</translation>
    </message>
    <message>
        <source>Standard uncertainty of the reading, or what the thermal camera sees of the object, with twice its own; of a reading that is not believed its age, or how long the sensor has told the same value. (part): some of the object is outside of the picture</source>
        <translation>读数的标准不确定度，或热像仪所见的物体温度及其标准不确定度的两倍；读数不予采信时，为其时效，或传感器数值多久未变。（部分）：物体有一部分在图像之外</translation>
    </message>
</context>
<context>
    <name>bask::ObjectsPage</name>
    <message>
        <source>Reading %1…</source>
        <translation>正在读取 %1…</translation>
    </message>
    <message>
        <source>disk</source>
        <translation>圆盘</translation>
    </message>
    <message>
        <source>“%1” was removed.</source>
        <translation>“%1”已移除。</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>撤销</translation>
    </message>
    <message>
        <source>Import an outline</source>
        <translation>导入轮廓</translation>
    </message>
    <message>
        <source>Outlines (%1);;All files (*)</source>
        <translation>轮廓 (%1);;所有文件 (*)</translation>
    </message>
    <message>
        <source>A disk is used as it is; it needs no fit.</source>
        <translation>圆盘按原样使用，无需拟合。</translation>
    </message>
    <message>
        <source>No imported outline is kept with this object, so it cannot be fitted again.</source>
        <translation>此物体未保留导入的轮廓，因此无法重新拟合。</translation>
    </message>
    <message>
        <source>Each object needs a free axis of the robot of its own; all are used. Remove an object first.</source>
        <translation>每个物体都需要各自的一个机器人自由轴；自由轴已全部用完。请先移除一个物体。</translation>
    </message>
    <message>
        <source>&amp;Objects</source>
        <translation>物体(&amp;O)</translation>
    </message>
    <message>
        <source>Add &amp;disk</source>
        <translation>添加圆盘(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Import outline…</source>
        <translation>导入轮廓(&amp;I)…</translation>
    </message>
    <message>
        <source>Du&amp;plicate</source>
        <translation>复制副本(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>移除(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>撤销(&amp;U)</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>重做</translation>
    </message>
    <message>
        <source>%1 of %2 degrees of freedom used</source>
        <translation>已用 %1 个自由度，共 %2 个</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>&amp;Sample shapes</source>
        <translation>示例形状(&amp;S)</translation>
    </message>
    <message>
        <source>Bunny</source>
        <translation>兔子</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>圆</translation>
    </message>
    <message>
        <source>Gear</source>
        <translation>齿轮</translation>
    </message>
    <message>
        <source>Hand</source>
        <translation>手</translation>
    </message>
    <message>
        <source>Leaf</source>
        <translation>树叶</translation>
    </message>
    <message>
        <source>%1 is not a kind of file that can be imported. Use a drawing (%2), a list of x, y points (%3) or a picture of a silhouette (%4).</source>
        <translation>%1 不是可导入的文件类型。请使用图形（%2）、x, y 点的列表（%3）或剪影图片（%4）。</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>轮廓</translation>
    </message>
    <message>
        <source>Mounting</source>
        <translation>安装</translation>
    </message>
</context>
<context>
    <name>bask::Outcome</name>
    <message>
        <source>Fault</source>
        <translation>故障</translation>
    </message>
    <message>
        <source>Interrupted</source>
        <translation>中断</translation>
    </message>
    <message>
        <source>Not settled</source>
        <translation>未稳定</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>正在记录</translation>
    </message>
    <message>
        <source>Settled</source>
        <translation>已稳定</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>已停止</translation>
    </message>
    <message>
        <source>Unreadable</source>
        <translation>无法读取</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>软件停止</translation>
    </message>
    <message>
        <source>Damaged</source>
        <translation>已损坏</translation>
    </message>
    <message>
        <source>Altered</source>
        <translation>已改动</translation>
    </message>
    <message>
        <source>%1, by an alarm of priority %2</source>
        <comment>the outcome of a run</comment>
        <translation>%1，由优先级 %2 的报警引起</translation>
    </message>
</context>
<context>
    <name>bask::OutlinePicker</name>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>Outlines of the file</source>
        <translation>文件中的轮廓</translation>
    </message>
    <message>
        <source>Click an outline to choose it. The wheel zooms, a double click shows all.</source>
        <translation>单击轮廓即可选择。滚轮缩放，双击显示全部。</translation>
    </message>
</context>
<context>
    <name>bask::OutlinePreview</name>
    <message>
        <source>Outline</source>
        <translation>轮廓</translation>
    </message>
    <message>
        <source>%1, %2 mm wide and %3 mm high</source>
        <translation>%1，宽 %2 mm，高 %3 mm</translation>
    </message>
    <message>
        <source>Imported outline, %1 points</source>
        <translation>导入的轮廓，%1 个点</translation>
    </message>
    <message>
        <source>Fourier outline, %1</source>
        <translation>傅里叶轮廓，%1</translation>
    </message>
    <message>
        <source>Outline used</source>
        <translation>所用轮廓</translation>
    </message>
    <message>
        <source>Drop a drawing, a CSV or a picture of a silhouette here, or add a disk.</source>
        <translation>将图形、CSV 或剪影图片拖放到此处，或添加圆盘。</translation>
    </message>
    <message>
        <source>%1 mm × %2 mm</source>
        <translation>%1 mm × %2 mm</translation>
    </message>
    <message>
        <source>Centroid, principal axes: radii of gyration %1 mm and %2 mm</source>
        <translation>形心，主轴：回转半径 %1 mm 和 %2 mm</translation>
    </message>
    <message>
        <source>Imported outline at most %1 mm from the Fourier outline</source>
        <translation>导入轮廓与傅里叶轮廓相距最大 %1 mm</translation>
    </message>
    <message>
        <source>Imported outline, %1 points, coloured by its distance</source>
        <translation>导入的轮廓，%1 个点，按距离着色</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>0 mm</source>
        <translation>0 mm</translation>
    </message>
</context>
<context>
    <name>bask::PageHost</name>
    <message>
        <source>A run is armed or on. Objects can be changed once it has stopped.</source>
        <translation>已待命或正在运行。停止后即可更改物体。</translation>
    </message>
    <message>
        <source>The run is stopping. Targets can be changed once it has.</source>
        <translation>运行正在停止。停止后即可更改目标。</translation>
    </message>
    <message>
        <source>Runs start at %1 from now on.</source>
        <translation>今后的运行从 %1 开始。</translation>
    </message>
    <message>
        <source>A run is armed or on. The start can be changed once it has stopped.</source>
        <translation>已待命或正在运行。停止后即可更改起始位姿。</translation>
    </message>
    <message>
        <source>The source is followed no more: that takes markers on it, a calibrated camera and its place.</source>
        <translation>不再跟踪热源：这需要热源上有标记、相机已标定且其位置已知。</translation>
    </message>
    <message>
        <source>Redone: %1</source>
        <translation>已重做：%1</translation>
    </message>
    <message>
        <source>Undone: %1</source>
        <translation>已撤销：%1</translation>
    </message>
    <message>
        <source>Confirm a sensor</source>
        <translation>确认传感器</translation>
    </message>
    <message>
        <source>The sensor of &quot;%1&quot; reads %2. Have you looked, and is it on its object and right?</source>
        <translation>“%1”的传感器读数为 %2。您查看过吗？它在物体上且正确吗？</translation>
    </message>
    <message>
        <source>Confirm</source>
        <translation>确认</translation>
    </message>
    <message>
        <source>A run is armed or on. The thermal camera can be changed once it has stopped.</source>
        <translation>已待命或正在运行。停止后才能更改热像仪。</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>打开</translation>
    </message>
    <message>
        <source>Show in folder</source>
        <translation>在文件夹中显示</translation>
    </message>
    <message>
        <source>%1 cannot be opened. Bask opens experiments and rigs (JSON), recorded sessions (BASK) and outlines (%2, pictures).</source>
        <comment>%2 names of file formats, with commas</comment>
        <translation>无法打开 %1。Bask 可打开实验和装置（JSON）、记录的会话（BASK）以及轮廓（%2、图片）。</translation>
    </message>
</context>
<context>
    <name>bask::PairsView</name>
    <message>
        <source>Folder for the tables and pictures</source>
        <translation>存放表格和图片的文件夹</translation>
    </message>
    <message>
        <source>Tables and pictures of the pairs written to %1</source>
        <translation>各物体对的表格和图片已写入 %1</translation>
    </message>
    <message>
        <source>Maps need two objects or more.</source>
        <translation>图表需要两个或更多物体。</translation>
    </message>
    <message>
        <source>No pose of the workspace keeps the clearance: there is nothing to map.</source>
        <translation>工作空间中没有位姿能保持间距：没有可绘制的内容。</translation>
    </message>
    <message>
        <source>Which temperatures two objects can have together, whatever the others do. Drag a point, or double-click, to set their targets.</source>
        <translation>两个物体可同时达到的温度，不论其他物体如何。拖动一点或双击即可设定其目标。</translation>
    </message>
    <message>
        <source>few poses</source>
        <translation>位姿很少</translation>
    </message>
    <message>
        <source>rare</source>
        <translation>罕见</translation>
    </message>
    <message>
        <source>Some pose has both, found by search; none of the poses that were counted does.</source>
        <translation>经搜索得知有某个位姿可同时达到两者；所统计的位姿中则没有。</translation>
    </message>
    <message>
        <source>many (log)</source>
        <translation>很多（对数）</translation>
    </message>
    <message>
        <source>Share of the workspace&apos;s poses at which the pair settles there, on a logarithmic scale. Where it is small, the pair asks for a pose that is hard to keep.</source>
        <translation>工作空间中使该物体对稳定于此处的位姿所占的比例，对数刻度。比例小处，该物体对所要求的位姿难以保持。</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>导出…</translation>
    </message>
    <message>
        <source>Write each map as a table (CSV) and as a picture (PNG).</source>
        <translation>将每张图写成表格（CSV）和图片（PNG）。</translation>
    </message>
</context>
<context>
    <name>bask::ParameterForm</name>
    <message>
        <source>automatic</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>%1: %2 instead of %3</source>
        <translation>%1：%2，而不是 %3</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>%1: automatic</source>
        <translation>%1：自动</translation>
    </message>
</context>
<context>
    <name>bask::PickedPanel</name>
    <message>
        <source>For each object at this point: its view factor, the temperature that it settles at, and how fast that rises along its arrow.</source>
        <translation>对此点处的每个物体：其角系数、最终稳定的温度，以及该温度沿箭头方向上升的快慢。</translation>
    </message>
    <message>
        <source>Start here</source>
        <translation>从此处开始</translation>
    </message>
    <message>
        <source>Runs start at this point.</source>
        <translation>运行从此点开始。</translation>
    </message>
    <message>
        <source>Runs cannot start at this point: %1.</source>
        <translation>运行不能从此点开始：%1。</translation>
    </message>
</context>
<context>
    <name>bask::PictureDialog</name>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>As the view: %1 × %2</source>
        <translation>与视图相同：%1 × %2</translation>
    </message>
    <message>
        <source>Twice the view: %1 × %2</source>
        <translation>视图的两倍：%1 × %2</translation>
    </message>
    <message>
        <source>Screen: %1 × %2</source>
        <translation>屏幕：%1 × %2</translation>
    </message>
    <message>
        <source>A4 across at 300 dpi: %1 × %2</source>
        <translation>A4 横向，300 dpi：%1 × %2</translation>
    </message>
    <message>
        <source>A4 upright at 300 dpi: %1 × %2</source>
        <translation>A4 纵向，300 dpi：%1 × %2</translation>
    </message>
    <message>
        <source>Another</source>
        <translation>其他</translation>
    </message>
    <message>
        <source>Choose the place…</source>
        <translation>选择位置…</translation>
    </message>
    <message>
        <source>&amp;Size</source>
        <translation>尺寸(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>宽度(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Height</source>
        <translation>高度(&amp;H)</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>保存图片</translation>
    </message>
    <message>
        <source>Save the animation</source>
        <translation>保存动画</translation>
    </message>
    <message>
        <source>Folder for the pictures</source>
        <translation>存放图片的文件夹</translation>
    </message>
</context>
<context>
    <name>bask::PlotPlace</name>
    <message>
        <source>Take the cursor away</source>
        <translation>移走游标</translation>
    </message>
    <message>
        <source>On the right axis</source>
        <translation>右轴上</translation>
    </message>
    <message>
        <source>None</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Put back into the page</source>
        <translation>放回页面</translation>
    </message>
    <message>
        <source>Own window</source>
        <translation>单独窗口</translation>
    </message>
    <message>
        <source>This plot is in a window of its own.</source>
        <translation>此曲线图在一个单独的窗口中。</translation>
    </message>
    <message>
        <source>Put back</source>
        <translation>放回</translation>
    </message>
    <message>
        <source>Put the plot back: %1</source>
        <translation>放回曲线图：%1</translation>
    </message>
    <message>
        <source>Export what is shown</source>
        <translation>导出所显示的内容</translation>
    </message>
    <message>
        <source>Figure (PDF)…</source>
        <translation>图 (PDF)…</translation>
    </message>
    <message>
        <source>Figure (SVG)…</source>
        <translation>图 (SVG)…</translation>
    </message>
    <message>
        <source>Figure (PNG)…</source>
        <translation>图 (PNG)…</translation>
    </message>
    <message>
        <source>Table (CSV)…</source>
        <translation>表格 (CSV)…</translation>
    </message>
    <message>
        <source>Measure from here</source>
        <translation>从此处测量</translation>
    </message>
</context>
<context>
    <name>bask::PlotWindowsControl</name>
    <message>
        <source>Rig %1: %2</source>
        <comment>SIMULATED or LIVE, and the state of the run</comment>
        <translation>%1装置：%2</translation>
    </message>
</context>
<context>
    <name>bask::ProblemDialog</name>
    <message>
        <source>Report a problem</source>
        <translation>报告问题</translation>
    </message>
    <message>
        <source>This is all that the report has. Write at the top what happened and what you expected, take out what nobody should see, save it, and give it to whoever looks after your Bask. Nothing is sent.</source>
        <translation>这就是报告的全部内容。请在最上方写明发生了什么、您期望的是什么，删去不应让人看到的内容，保存后交给负责维护 Bask 的人。不会发送任何内容。</translation>
    </message>
    <message>
        <source>The report</source>
        <translation>报告</translation>
    </message>
    <message>
        <source>What happened:</source>
        <translation>发生了什么：</translation>
    </message>
    <message>
        <source>What was expected:</source>
        <translation>期望的是什么：</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>保存…</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
</context>
<context>
    <name>bask::ProgramQuestion</name>
    <message>
        <source>Program of a device</source>
        <translation>设备的程序</translation>
    </message>
    <message>
        <source>May Bask start this program on this computer?</source>
        <translation>是否允许 Bask 在本计算机上启动此程序？</translation>
    </message>
    <message>
        <source>It starts these files:</source>
        <translation>它启动这些文件：</translation>
    </message>
    <message>
        <source>It can do whatever you can do on this computer, and it moves or heats the device. Confirm only what you know. You are asked again when one of these files changes.</source>
        <translation>它能做您在本计算机上能做的一切，并使设备移动或加热。只确认您了解的程序。其中任一文件改变时会再次询问。</translation>
    </message>
    <message>
        <source>Allow it</source>
        <translation>允许</translation>
    </message>
</context>
<context>
    <name>bask::Question</name>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
</context>
<context>
    <name>bask::ReachBar</name>
    <message>
        <source>Reachable temperatures</source>
        <translation>可达温度</translation>
    </message>
    <message>
        <source>The range is being worked out.</source>
        <translation>正在计算范围。</translation>
    </message>
    <message>
        <source>Target %1. Here it can be held between %2 and %3; with nothing but the source in view, up to %4.</source>
        <translation>目标 %1。在此可保持于 %2 与 %3 之间；若视野内只有热源，则可达 %4。</translation>
    </message>
</context>
<context>
    <name>bask::ReachMap</name>
    <message>
        <source>Checking…</source>
        <translation>正在检查…</translation>
    </message>
    <message>
        <source>%1 inside</source>
        <translation>界内 %1</translation>
    </message>
    <message>
        <source>%1 outside</source>
        <translation>界外 %1</translation>
    </message>
    <message>
        <source>Temperatures that %1 and %2 can have together</source>
        <translation>%1 与 %2 可同时达到的温度</translation>
    </message>
    <message>
        <source>Targets %1 and %2: %3</source>
        <translation>目标 %1 与 %2：%3</translation>
    </message>
    <message>
        <source>%1 %2 and %3 %4: some pose has both</source>
        <translation>%1 %2 且 %3 %4：有位姿可同时达到</translation>
    </message>
    <message>
        <source>%1 %2 and %3 %4: no pose has both</source>
        <translation>%1 %2 且 %3 %4：没有位姿可同时达到</translation>
    </message>
</context>
<context>
    <name>bask::ReadingPanel</name>
    <message>
        <source>Temperature of %1</source>
        <translation>%1 的温度</translation>
    </message>
    <message>
        <source>Temperatures by</source>
        <translation>温度来自</translation>
    </message>
    <message>
        <source>The pose of the thermal camera is not known, so it reads nothing: set it up.</source>
        <translation>热像仪的位姿未知，因此它不读取任何物体：请设置。</translation>
    </message>
    <message>
        <source>Sensor on the object</source>
        <translation>物体上的传感器</translation>
    </message>
    <message>
        <source>Thermal camera</source>
        <translation>热像仪</translation>
    </message>
    <message>
        <source>Sensor, checked by the thermal camera</source>
        <translation>传感器，由热像仪核对</translation>
    </message>
</context>
<context>
    <name>bask::Recipe</name>
    <message>
        <source>Wait</source>
        <translation>等待</translation>
    </message>
    <message>
        <source>all have been settled for %1</source>
        <translation>全部已稳定 %1</translation>
    </message>
    <message>
        <source>%1 have passed</source>
        <translation>已过 %1</translation>
    </message>
    <message>
        <source>%1 is at %2 or above</source>
        <translation>%1 达到或高于 %2</translation>
    </message>
    <message>
        <source>%1 is at %2 or below</source>
        <translation>%1 达到或低于 %2</translation>
    </message>
    <message>
        <source>To come</source>
        <translation>未开始</translation>
    </message>
    <message>
        <source>Under way</source>
        <translation>进行中</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>已完成</translation>
    </message>
    <message>
        <source>Not reached</source>
        <translation>未达到</translation>
    </message>
    <message>
        <source>Failed</source>
        <translation>失败</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>已停止</translation>
    </message>
    <message>
        <source>The recipe is done.</source>
        <translation>配方已完成。</translation>
    </message>
    <message>
        <source>The recipe has ended: not every step was done.</source>
        <translation>配方已结束：并非每个步骤都已完成。</translation>
    </message>
    <message>
        <source>The recipe was stopped.</source>
        <translation>配方已停止。</translation>
    </message>
    <message>
        <source>The recipe has ended, since the rig or the experiment was taken in hand.</source>
        <translation>配方已结束，因为有人接管了装置或实验。</translation>
    </message>
    <message>
        <source>The recipe was ended by an alarm.</source>
        <translation>配方因报警而结束。</translation>
    </message>
    <message>
        <source>The recipe was ended by a fault.</source>
        <translation>配方因故障而结束。</translation>
    </message>
    <message>
        <source>Held</source>
        <translation>已保持</translation>
    </message>
</context>
<context>
    <name>bask::RecipeControl</name>
    <message>
        <source>A recipe is on, step %1 of %2. It arms, moves and heats by itself.</source>
        <translation>配方正在进行，第 %1 步，共 %2 步。它会自行待命、移动和加热。</translation>
    </message>
    <message>
        <source>Open a recipe</source>
        <translation>打开配方</translation>
    </message>
    <message>
        <source>Recipes (*.json);;All files (*)</source>
        <translation>配方 (*.json);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Recipes (*.json)</source>
        <translation>配方 (*.json)</translation>
    </message>
    <message>
        <source>A recipe is on. Stop it before another one is opened.</source>
        <translation>配方正在进行。请先将其停止，再打开另一个。</translation>
    </message>
    <message>
        <source>Show the recipe</source>
        <translation>查看配方</translation>
    </message>
    <message>
        <source>Unsaved recipe</source>
        <translation>未保存的配方</translation>
    </message>
    <message>
        <source>The recipe was changed and not saved.</source>
        <translation>配方已更改但未保存。</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Discard changes</source>
        <translation>放弃更改</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Save the recipe</source>
        <translation>保存配方</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>已保存 %1</translation>
    </message>
    <message>
        <source>Add a run of an experiment</source>
        <translation>添加一次实验运行</translation>
    </message>
    <message>
        <source>Experiments (*.json);;All files (*)</source>
        <translation>实验 (*.json);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Step %1 is for another rig than the present one: a recipe runs on one rig, which has been looked at.</source>
        <translation>步骤 %1 用于另一套装置，而非当前装置：配方只在一套已检查过的装置上运行。</translation>
    </message>
    <message>
        <source>%1. %2 until %3</source>
        <translation>%1. %2，直到%3</translation>
    </message>
    <message>
        <source>%1. %2 until %3, at most %4</source>
        <translation>%1. %2，直到%3，最多 %4</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>还有 %n 个</numerusform>
        </translation>
    </message>
    <message>
        <source>Start the recipe</source>
        <translation>启动配方</translation>
    </message>
    <message>
        <source>It takes at most %1 and its retreats:</source>
        <translation>最多需要 %1，另加各次撤离：</translation>
    </message>
    <message>
        <source>This rig is real: the robot moves and the source heats, again and again and by itself. Is everybody and everything out of the way for so long? An alarm, a hold or a stop ends the recipe.</source>
        <translation>这是真实装置：机器人将自行一次又一次地移动，热源将一次又一次地加热。在这么长的时间内，所有人和物是否都已避开？报警、保持或停止都会结束配方。</translation>
    </message>
    <message>
        <source>An alarm, a hold or a stop ends the recipe.</source>
        <translation>报警、保持或停止都会结束配方。</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>开始</translation>
    </message>
    <message>
        <source>Something was changed meanwhile: start the recipe once more.</source>
        <translation>其间有所更改：请再次启动配方。</translation>
    </message>
    <message>
        <source>The experiment has unsaved edits.</source>
        <translation>实验有未保存的编辑。</translation>
    </message>
    <message>
        <source>The source is heated by hand: a recipe cannot switch it off between its steps.</source>
        <translation>热源由人工加热：配方无法在各步骤之间将其关闭。</translation>
    </message>
    <message>
        <source>Its run is held, not ended: nothing but a person resumes or stops it now.</source>
        <translation>其运行处于保持状态，并未结束：现在只能由人来继续或停止它。</translation>
    </message>
    <message>
        <source>Its steps allow the real rig more than now:</source>
        <translation>其步骤允许实机装置超出现在的范围：</translation>
    </message>
    <message>
        <source>Do robot, source, objects and sensors bear it?</source>
        <translation>机器人、热源、物体和传感器能承受吗？</translation>
    </message>
</context>
<context>
    <name>bask::RecipePanel</name>
    <message>
        <source>Run %1</source>
        <translation>运行 %1</translation>
    </message>
    <message>
        <source>%1; otherwise on with the next</source>
        <translation>%1；否则继续下一步骤</translation>
    </message>
    <message>
        <source>Step %1 of %2</source>
        <translation>步骤 %1/%2</translation>
    </message>
    <message>
        <source>%1 of at most %2</source>
        <translation>%1，最多 %2</translation>
    </message>
    <message>
        <source>running, %1</source>
        <translation>运行中，%1</translation>
    </message>
    <message>
        <source>waiting, %1</source>
        <translation>等待中，%1</translation>
    </message>
    <message>
        <source>heat off, retreat</source>
        <translation>关闭加热，撤离</translation>
    </message>
    <message>
        <source>getting ready</source>
        <translation>准备中</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Experiments that are run one after another, with waits. Add a step or open a recipe.</source>
        <translation>依次运行的实验，中间可有等待。请添加步骤或打开配方。</translation>
    </message>
    <message numerus="yes">
        <source>%n step(s), at most %1</source>
        <translation>
            <numerusform>%n 个步骤，最多 %1</numerusform>
        </translation>
    </message>
    <message>
        <source>not saved yet</source>
        <translation>尚未保存</translation>
    </message>
    <message>
        <source>%1, changed</source>
        <translation>%1，已更改</translation>
    </message>
    <message>
        <source>File</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>New recipe</source>
        <translation>新建配方</translation>
    </message>
    <message>
        <source>Open a recipe…</source>
        <translation>打开配方…</translation>
    </message>
    <message>
        <source>Examples</source>
        <translation>示例</translation>
    </message>
    <message>
        <source>Save the recipe as…</source>
        <translation>配方另存为…</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>添加</translation>
    </message>
    <message>
        <source>A run of the open experiment</source>
        <translation>运行已打开的实验</translation>
    </message>
    <message>
        <source>A run of an experiment from a file…</source>
        <translation>运行文件中的实验…</translation>
    </message>
    <message>
        <source>A wait</source>
        <translation>等待</translation>
    </message>
    <message>
        <source>A wait until an object has cooled</source>
        <translation>等待某个物体冷却</translation>
    </message>
    <message>
        <source>Edit…</source>
        <translation>编辑…</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Start the recipe</source>
        <translation>启动配方</translation>
    </message>
    <message>
        <source>Stop after this step</source>
        <translation>此步骤后停止</translation>
    </message>
    <message>
        <source>Stop the recipe</source>
        <translation>停止配方</translation>
    </message>
    <message>
        <source>Look at the run</source>
        <translation>查看运行</translation>
    </message>
    <message>
        <source>Recipe file</source>
        <translation>配方文件</translation>
    </message>
    <message>
        <source>A new recipe, another one, or this one under another name</source>
        <translation>新建配方、打开另一个，或将此配方另存</translation>
    </message>
    <message>
        <source>Save the recipe</source>
        <translation>保存配方</translation>
    </message>
    <message>
        <source>Add a step</source>
        <translation>添加步骤</translation>
    </message>
    <message>
        <source>Add a step after the chosen one</source>
        <translation>在所选步骤之后添加步骤</translation>
    </message>
    <message>
        <source>Edit the step</source>
        <translation>编辑步骤</translation>
    </message>
    <message>
        <source>Its condition, its longest time, and what comes if that passes (Enter)</source>
        <translation>其条件、最长时间，以及超时后如何处理（回车）</translation>
    </message>
    <message>
        <source>Remove the step</source>
        <translation>删除步骤</translation>
    </message>
    <message>
        <source>Move the step up</source>
        <translation>上移步骤</translation>
    </message>
    <message>
        <source>Move the step down</source>
        <translation>下移步骤</translation>
    </message>
    <message>
        <source>Says what it will do, and asks</source>
        <translation>先说明将要做什么，再征求确认</translation>
    </message>
    <message>
        <source>The step under way is the last one</source>
        <translation>进行中的步骤为最后一步</translation>
    </message>
    <message>
        <source>Heat off, retreat, and nothing more is begun</source>
        <translation>关闭加热，撤离，不再开始任何步骤</translation>
    </message>
    <message>
        <source>The recording of the chosen step, on the Review page</source>
        <translation>在“回顾”页查看所选步骤的记录</translation>
    </message>
    <message>
        <source>Steps of the recipe</source>
        <translation>配方的步骤</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>编号</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>步骤</translation>
    </message>
    <message>
        <source>Until</source>
        <translation>直到</translation>
    </message>
    <message>
        <source>At most</source>
        <translation>最多</translation>
    </message>
    <message>
        <source>Elapsed</source>
        <translation>已用时</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
</context>
<context>
    <name>bask::RecipeStepDialog</name>
    <message>
        <source>Run %1</source>
        <translation>运行 %1</translation>
    </message>
    <message>
        <source>Wait</source>
        <translation>等待</translation>
    </message>
    <message>
        <source>All objects have settled</source>
        <translation>所有物体均已稳定</translation>
    </message>
    <message>
        <source>A time has passed</source>
        <translation>经过一段时间</translation>
    </message>
    <message>
        <source>An object is so hot or hotter</source>
        <translation>某个物体达到或高于此温度</translation>
    </message>
    <message>
        <source>An object is so cold or colder</source>
        <translation>某个物体达到或低于此温度</translation>
    </message>
    <message>
        <source>End the recipe</source>
        <translation>结束配方</translation>
    </message>
    <message>
        <source>Go on with the next step</source>
        <translation>继续下一步骤</translation>
    </message>
    <message>
        <source>Until</source>
        <translation>直到</translation>
    </message>
    <message>
        <source>For</source>
        <translation>持续</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>物体</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>温度</translation>
    </message>
    <message>
        <source>At most</source>
        <translation>最多</translation>
    </message>
    <message>
        <source>Otherwise</source>
        <translation>否则</translation>
    </message>
    <message>
        <source>Where the condition does not come in time, or the run cannot be begun. An alarm, a fault or a person&apos;s stop always ends the recipe.</source>
        <translation>当条件未按时达到，或运行无法开始时。报警、故障或由人停止总会结束配方。</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>确定</translation>
    </message>
</context>
<context>
    <name>bask::RecoveryOffer</name>
    <message>
        <source>Bask ended before changes of “%1” were saved. They are kept as they were on %2.</source>
        <translation>Bask 在“%1”的更改保存之前就已结束。这些更改已按 %2 时的状态保留。</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>放弃</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>恢复</translation>
    </message>
</context>
<context>
    <name>bask::ReplayView</name>
    <message>
        <source>3-D scene of the run: source, objects and their paths</source>
        <translation>运行的三维场景：热源、物体及其路径</translation>
    </message>
    <message>
        <source>Further traces and the scene</source>
        <translation>其他曲线与场景</translation>
    </message>
    <message>
        <source>Laid over it:</source>
        <translation>叠加：</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>场景</translation>
    </message>
    <message>
        <source>Take %1 away</source>
        <translation>移除 %1</translation>
    </message>
    <message>
        <source>Thermal picture</source>
        <translation>热像图</translation>
    </message>
    <message>
        <source>Comparison</source>
        <translation>比较</translation>
    </message>
    <message>
        <source>recorded run %1</source>
        <translation>已记录的运行 %1</translation>
    </message>
    <message>
        <source>no recorded run</source>
        <translation>没有已记录的运行</translation>
    </message>
    <message>
        <source>Export figure</source>
        <translation>导出图</translation>
    </message>
    <message>
        <source>The temperatures of all runs as they are shown; other plots by their own menus</source>
        <translation>所有运行的温度，按所显示的样子；其他曲线图用各自的菜单</translation>
    </message>
</context>
<context>
    <name>bask::ResidualPlot</name>
    <message>
        <source>Residual against the number of harmonics</source>
        <translation>残差与谐波个数的关系</translation>
    </message>
    <message>
        <source>Distance between the imported outline and the Fourier outline. Click to choose a number of harmonics.</source>
        <translation>导入轮廓与傅里叶轮廓之间的距离。单击可选择谐波个数。</translation>
    </message>
    <message>
        <source>Residual, mm: rms (line), largest (dashes)</source>
        <translation>残差，mm：均方根（实线），最大（虚线）</translation>
    </message>
    <message>
        <source>harmonics</source>
        <translation>谐波数</translation>
    </message>
</context>
<context>
    <name>bask::ReviewDesk</name>
    <message>
        <source>%1 was closed properly: its outcome is &quot;interrupted&quot; now.</source>
        <translation>%1 已正确关闭：其结果现为“中断”。</translation>
    </message>
    <message numerus="yes">
        <source>It is shown already, or there are %n runs over the open one: take one away first.</source>
        <translation>
            <numerusform>它已在显示，或已有 %n 次运行叠加在当前运行上：请先移除一次。</numerusform>
        </translation>
    </message>
    <message>
        <source>A run is armed or on. Objects can be changed once it has stopped.</source>
        <translation>已待命或正在运行。停止后即可更改物体。</translation>
    </message>
    <message>
        <source>No object of the open experiment has the name and material of one of this run under the same source and environment.</source>
        <translation>在相同的热源和环境下，打开的实验中没有与本次运行名称和材料相同的物体。</translation>
    </message>
    <message>
        <source>Start values taken from this run: %1</source>
        <translation>已采用本次运行的起始值：%1</translation>
    </message>
    <message>
        <source>List of runs is up to date</source>
        <translation>运行列表已是最新</translation>
    </message>
</context>
<context>
    <name>bask::ReviewPage</name>
    <message>
        <source>Interrupted: the recording ended without a Stop. What had been written is here.</source>
        <translation>已中断：记录未经“停止”而结束。此处为已写入的内容。</translation>
    </message>
    <message>
        <source>All objects settled</source>
        <translation>所有物体均已稳定</translation>
    </message>
    <message>
        <source>Not all objects settled</source>
        <translation>并非所有物体都已稳定</translation>
    </message>
    <message>
        <source>Ended by a fault</source>
        <translation>因故障结束</translation>
    </message>
    <message>
        <source>No session open</source>
        <translation>未打开会话</translation>
    </message>
    <message>
        <source>&amp;Open session…</source>
        <translation>打开会话(&amp;O)…</translation>
    </message>
    <message>
        <source>Final values</source>
        <translation>最终值</translation>
    </message>
    <message>
        <source>Events and notes</source>
        <translation>事件与备注</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>时长</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>控制器</translation>
    </message>
    <message>
        <source>Recorded</source>
        <translation>记录时间</translation>
    </message>
    <message>
        <source>Software</source>
        <translation>软件</translation>
    </message>
    <message>
        <source>SIMULATED</source>
        <translation>仿真</translation>
    </message>
    <message>
        <source>LIVE</source>
        <translation>实机</translation>
    </message>
    <message>
        <source>Heat rates λ₁ in K/s</source>
        <translation>热速率 λ₁，K/s</translation>
    </message>
    <message>
        <source>Use as start values</source>
        <translation>用作起始值</translation>
    </message>
    <message>
        <source>Controllers of the open experiment start with the identified rates, in the objects of the same name and material under the same source.</source>
        <translation>对于相同热源下名称和材料相同的物体，打开的实验中的控制器从辨识出的热速率开始。</translation>
    </message>
    <message>
        <source>Fitting the heat balance to the record…</source>
        <translation>正在将热平衡模型拟合到记录…</translation>
    </message>
    <message>
        <source>Choose a recorded run in the list and press Enter, or open a file: its traces, events and metrics are shown here, and it can be played again.</source>
        <translation>在列表中选择一次已记录的运行并按回车，或打开文件：这里显示其曲线、事件和指标，并可回放。</translation>
    </message>
    <message>
        <source>Interrupted: the recording ended without a Stop, and was closed later. What had been written is here.</source>
        <translation>中断：记录未经停止便结束，后来才关闭。已写入的内容都在这里。</translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation>指标</translation>
    </message>
    <message>
        <source>What is known of the run</source>
        <translation>关于本次运行的已知信息</translation>
    </message>
    <message>
        <source>About the recording</source>
        <translation>关于此记录</translation>
    </message>
    <message>
        <source>Heat rates</source>
        <translation>热变化率</translation>
    </message>
    <message>
        <source>E&amp;xport</source>
        <translation>导出(&amp;X)</translation>
    </message>
    <message>
        <source>Write this session as a report, as figures or for other programs</source>
        <translation>将此会话写成报告、图，或供其他程序使用的文件</translation>
    </message>
    <message>
        <source>Report (&amp;PDF)…</source>
        <translation>报告 (PDF)(&amp;P)…</translation>
    </message>
    <message>
        <source>Report (&amp;HTML)…</source>
        <translation>报告 (HTML)(&amp;H)…</translation>
    </message>
    <message>
        <source>&amp;Figures (PNG, SVG, PDF)…</source>
        <translation>图(PNG、SVG、PDF)(&amp;F)…</translation>
    </message>
    <message>
        <source>Tables (&amp;CSV)…</source>
        <translation>表格 (CSV)(&amp;C)…</translation>
    </message>
    <message>
        <source>&amp;NeXus (HDF5)…</source>
        <translation>NeXus (HDF5)(&amp;N)…</translation>
    </message>
    <message>
        <source>&amp;VTK, for ParaView…</source>
        <translation>VTK（用于 ParaView）(&amp;V)…</translation>
    </message>
    <message>
        <source>Metrics, final values and heat rates are being computed from all samples: %1 %</source>
        <translation>正在根据全部采样计算指标、最终值和热速率：%1 %</translation>
    </message>
    <message>
        <source>No metrics, final values and heat rates: the recording cannot be read to its end.</source>
        <translation>无指标、最终值和热速率：记录无法读取到结尾。</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>已停止</translation>
    </message>
    <message>
        <source>Ended by STOP</source>
        <translation>因软件停止结束</translation>
    </message>
    <message>
        <source>Opened while it was being recorded: open it again to see the rest.</source>
        <translation>打开时仍在记录：再次打开可查看其余部分。</translation>
    </message>
    <message>
        <source>The record tells the losses of %1, but not what of them is radiated and what the air takes. State the air on the Objects page, or record wider temperatures.</source>
        <translation>记录给出了%1的损失，但无法区分其中的辐射与空气带走的部分。请在“物体”页说明空气，或记录更宽的温度范围。</translation>
    </message>
    <message>
        <source>Losses, of radiation and air</source>
        <translation>辐射与空气的损失</translation>
    </message>
    <message>
        <source>There is nothing to play: no run is open. Choose one in the list.</source>
        <translation>没有可播放的：没有打开任何运行。请在列表中选择一个。</translation>
    </message>
    <message>
        <source>Open as new experiment</source>
        <translation>作为新实验打开</translation>
    </message>
    <message>
        <source>Opens what was run here, objects, source, targets and limits as the recording has them, as a new experiment without a file.</source>
        <translation>将此处所运行的内容（物体、热源、目标和限值，均按记录中的）作为没有文件的新实验打开。</translation>
    </message>
    <message>
        <source>Tables with &amp;all digits (CSV)…</source>
        <translation>全部位数的表格 (CSV)(&amp;A)…</translation>
    </message>
    <message>
        <source>Not verified: %1</source>
        <translation>未验证：%1</translation>
    </message>
    <message>
        <source>No object shades another</source>
        <translation>物体之间没有遮挡</translation>
    </message>
    <message>
        <source>At most %1 % of an object&apos;s view factor is taken by the others</source>
        <translation>某个物体的角系数最多有 %1 % 被其他物体挡住</translation>
    </message>
    <message>
        <source>Being verified…</source>
        <translation>正在验证…</translation>
    </message>
    <message>
        <source>Head of the hash chain: %1</source>
        <translation>哈希链的头：%1</translation>
    </message>
    <message>
        <source>Verification</source>
        <translation>验证</translation>
    </message>
    <message>
        <source>Heat rates at Start</source>
        <translation>开始时的热速率</translation>
    </message>
    <message>
        <source>Shade</source>
        <translation>遮挡</translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation>仿真</translation>
    </message>
    <message>
        <source>%1, recorded until %2</source>
        <comment>two times since Start</comment>
        <translation>%1，记录至 %2</translation>
    </message>
</context>
<context>
    <name>bask::RigDevices</name>
    <message>
        <source>Simulated rig</source>
        <translation>仿真装置</translation>
    </message>
    <message>
        <source>No device moves or heats. The real rig&apos;s set-up is kept for later.</source>
        <translation>没有设备运动或加热。实际装置的设置会保留以备后用。</translation>
    </message>
    <message>
        <source>Real rig</source>
        <translation>实际装置</translation>
    </message>
    <message>
        <source>The devices below</source>
        <translation>以下设备</translation>
    </message>
    <message>
        <source>Name of the rig</source>
        <translation>装置名称</translation>
    </message>
    <message>
        <source>Open rig…</source>
        <translation>打开装置…</translation>
    </message>
    <message>
        <source>Take the devices from a rig file</source>
        <translation>从装置文件读取设备</translation>
    </message>
    <message>
        <source>Save rig…</source>
        <translation>保存装置…</translation>
    </message>
    <message>
        <source>Write these devices to a rig file, for other experiments</source>
        <translation>将这些设备写入装置文件，供其他实验使用</translation>
    </message>
    <message>
        <source>Console…</source>
        <translation>控制台…</translation>
    </message>
    <message>
        <source>What goes over the links to the devices</source>
        <translation>设备链路上往来的内容</translation>
    </message>
</context>
<context>
    <name>bask::RigPage</name>
    <message>
        <source>The rig was set up for %1 objects, and there are %2: check the thermometer&apos;s channels.</source>
        <translation>装置是按 %1 个物体设置的，而现有 %2 个：请检查温度计的通道。</translation>
    </message>
    <message>
        <source>A run is armed or on: it has the robot and the heat.</source>
        <translation>已待命或正在运行：机器人和加热由其占用。</translation>
    </message>
    <message>
        <source>A stop or a fault is latched. Press Reset first.</source>
        <translation>有停止或故障被锁存。请先按“复位”。</translation>
    </message>
    <message>
        <source>By hand</source>
        <translation>手动</translation>
    </message>
    <message>
        <source>Source and limits</source>
        <translation>热源与限值</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>机器人</translation>
    </message>
    <message>
        <source>Heat</source>
        <translation>加热</translation>
    </message>
    <message>
        <source>Rig</source>
        <translation>装置</translation>
    </message>
    <message>
        <source>Raise a limit of the real rig</source>
        <translation>提高实际装置的限值</translation>
    </message>
    <message>
        <source>This allows the rig more than before. Do robot, source, objects and sensors bear it?</source>
        <translation>这将允许装置超出以前的范围。机器人、热源、物体和传感器能承受吗？</translation>
    </message>
    <message>
        <source>Raise the limit</source>
        <translation>提高限值</translation>
    </message>
    <message>
        <source>Limits of the real rig</source>
        <translation>实机装置的限值</translation>
    </message>
    <message>
        <source>This rig is allowed more than now, or than is usual:</source>
        <translation>此装置被允许的范围超出现在或通常：</translation>
    </message>
    <message>
        <source>Do robot, source, objects and sensors bear it?</source>
        <translation>机器人、热源、物体和传感器能承受吗？</translation>
    </message>
    <message>
        <source>Use these limits</source>
        <translation>使用这些限值</translation>
    </message>
    <message>
        <source>A stop or a fault is latched. Home the robot or confirm its place, then press Reset.</source>
        <translation>停止或故障已锁存。请使机器人回零或确认其位置，然后按“复位”。</translation>
    </message>
    <message>
        <source>A stop or a fault is latched. Reset is possible when its cause is over.</source>
        <translation>停止或故障已锁存。其原因解除后方可复位。</translation>
    </message>
</context>
<context>
    <name>bask::RigPanel</name>
    <message>
        <source>Follow the source &amp;during runs</source>
        <translation>运行期间跟踪热源(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>测量(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Several poses</source>
        <translation>多个位姿(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Use this pose</source>
        <translation>使用此位姿(&amp;U)</translation>
    </message>
    <message>
        <source>A run is armed or on, or a stop is not reset. Measure after that.</source>
        <translation>已待命、正在运行，或停止尚未复位。请在此之后测量。</translation>
    </message>
    <message>
        <source>As typed</source>
        <translation>按输入值</translation>
    </message>
    <message>
        <source>By the end-effector&apos;s markers, in the robot&apos;s base. Several poses of the robot are surer than one.</source>
        <translation>由末端执行器的标记在机器人基座坐标系中确定。机器人的多个位姿比单个更可靠。</translation>
    </message>
    <message>
        <source>By the markers on the source and on the end-effector, seen in the same pictures.</source>
        <translation>由同一图像中所见的热源上和末端执行器上的标记确定。</translation>
    </message>
    <message>
        <source>Calibrate the camera first.</source>
        <translation>请先标定相机。</translation>
    </message>
    <message>
        <source>Chec&amp;k</source>
        <translation>校验(&amp;K)</translation>
    </message>
    <message>
        <source>Checked at another pose: %1 and %2 off; up to %3 and %4 was to be expected.</source>
        <translation>在另一位姿校验：偏离 %1 和 %2；预期最多 %3 和 %4。</translation>
    </message>
    <message>
        <source>Fr&amp;om here</source>
        <translation>从此处(&amp;O)</translation>
    </message>
    <message>
        <source>In use</source>
        <translation>正在使用</translation>
    </message>
    <message>
        <source>List the markers on the end-effector first.</source>
        <translation>请先列出末端执行器上的标记。</translation>
    </message>
    <message>
        <source>Markers on the rig</source>
        <translation>装置上的标记</translation>
    </message>
    <message>
        <source>Moves the robot to a pose that was not measured, compares where the markers are with where they should be, and moves back.</source>
        <translation>使机器人运动到一个未测量过的位姿，比较标记的实际位置与应在位置，然后返回。</translation>
    </message>
    <message>
        <source>No picture from the camera.</source>
        <translation>相机没有图像。</translation>
    </message>
    <message>
        <source>Not measured</source>
        <translation>未测量</translation>
    </message>
    <message>
        <source>Rig</source>
        <translation>装置</translation>
    </message>
    <message>
        <source>That is %1 and %2 from where the experiment has it.</source>
        <translation>与实验中的位置相差 %1 和 %2。</translation>
    </message>
    <message>
        <source>The camera stands at %1, measured %2.</source>
        <translation>相机位于 %1，测量于：%2。</translation>
    </message>
    <message>
        <source>The camera stands at %1.</source>
        <translation>相机位于 %1。</translation>
    </message>
    <message>
        <source>The camera tells the controllers where the source is. Takes markers on the source, a calibrated camera and its place.</source>
        <translation>由相机告知控制器热源的位置。需要热源上有标记、相机已标定且其位置已知。</translation>
    </message>
    <message>
        <source>The end-effector in the source: %1.</source>
        <translation>末端执行器在热源坐标系中：%1。</translation>
    </message>
    <message>
        <source>The robot did not move: nothing was checked.</source>
        <translation>机器人没有运动：未作任何校验。</translation>
    </message>
    <message>
        <source>The robot moves to some poses within its workspace, never nearer to the source, and back. Stand clear.</source>
        <translation>机器人将运动到其工作空间内的若干位姿，绝不更靠近热源，然后返回。请保持距离。</translation>
    </message>
    <message>
        <source>The robot says where it is to %1 and %2 (one standard deviation).</source>
        <translation>机器人自报位置的精度为 %1 和 %2（一倍标准差）。</translation>
    </message>
    <message>
        <source>The robot stays where it is.</source>
        <translation>机器人停在原处不动。</translation>
    </message>
    <message>
        <source>The source in the robot&apos;s base: %1.</source>
        <translation>热源在机器人基座坐标系中：%1。</translation>
    </message>
    <message>
        <source>The source lies at %1, measured %2.</source>
        <translation>热源位于 %1，测量于：%2。</translation>
    </message>
    <message>
        <source>The source lies at %1.</source>
        <translation>热源位于 %1。</translation>
    </message>
    <message>
        <source>Use this p&amp;lace</source>
        <translation>使用此位置(&amp;L)</translation>
    </message>
    <message>
        <source>What it sees at the source is known to ±%1 and ±%2 (two standard deviations), by %3 pose(s) of the robot; residual %4 px.</source>
        <translation>相机在热源处所见内容的精度为 ±%1 和 ±%2（两倍标准差），由机器人的 %3 个位姿得出；残差 %4 px。</translation>
    </message>
    <message>
        <source>Where the camera stands</source>
        <translation>相机的位置</translation>
    </message>
    <message>
        <source>Where the source is</source>
        <translation>热源的位置</translation>
    </message>
</context>
<context>
    <name>bask::RunDifferences</name>
    <message>
        <source>all %1</source>
        <comment>objects of a run; their target</comment>
        <translation>全部 %1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>objects, and their one target</comment>
        <translation>%1：%2</translation>
    </message>
</context>
<context>
    <name>bask::RunLabelWords</name>
    <message>
        <source>operator %1</source>
        <translation>操作员 %1</translation>
    </message>
    <message>
        <source>sample %1</source>
        <translation>样品 %1</translation>
    </message>
    <message>
        <source>batch %1</source>
        <translation>批次 %1</translation>
    </message>
    <message>
        <source>, </source>
        <comment>between operator, sample and batch</comment>
        <translation>，</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <comment>note, its operator</comment>
        <translation>%1（%2）</translation>
    </message>
    <message>
        <source>The run had been stopped; what followed is not recorded to its end.</source>
        <translation>运行已被停止；其后的过程没有记录完整。</translation>
    </message>
    <message>
        <source>Faster than real time: %1 (min:s) of the simulated rig in %2 by the clock</source>
        <translation>快于实际时间：仿真装置的 %1（分:秒）按时钟只用了 %2</translation>
    </message>
</context>
<context>
    <name>bask::RunPage</name>
    <message>
        <source>Sensor lost</source>
        <translation>传感器失联</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>保持</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>继续</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>软件停止</translation>
    </message>
    <message>
        <source>Settled</source>
        <translation>已稳定</translation>
    </message>
    <message>
        <source>New targets</source>
        <translation>新目标</translation>
    </message>
    <message>
        <source>New gains</source>
        <translation>新增益</translation>
    </message>
    <message>
        <source>Fault</source>
        <translation>故障</translation>
    </message>
    <message>
        <source>Compromise</source>
        <translation>折中</translation>
    </message>
    <message>
        <source>Source lost</source>
        <translation>热源丢失</translation>
    </message>
    <message>
        <source>Source back</source>
        <translation>热源恢复</translation>
    </message>
    <message>
        <source>Sensor back</source>
        <translation>传感器恢复</translation>
    </message>
    <message>
        <source>Behind by %1 — jump to live</source>
        <translation>落后 %1 — 跳到实时</translation>
    </message>
    <message>
        <source>Jump to live</source>
        <translation>跳到实时</translation>
    </message>
    <message>
        <source>Follow live</source>
        <translation>跟随实时</translation>
    </message>
    <message>
        <source>Keep the newest samples in view. Zooming or dragging a plot turns it off; no sample is lost.</source>
        <translation>使最新采样保持在视图中。缩放或拖动曲线图会将其关闭；采样不会丢失。</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>显示</translation>
    </message>
    <message>
        <source>whole run</source>
        <translation>整个运行</translation>
    </message>
    <message>
        <source>last minute</source>
        <translation>最近 1 分钟</translation>
    </message>
    <message>
        <source>last 5 minutes</source>
        <translation>最近 5 分钟</translation>
    </message>
    <message>
        <source>last 30 minutes</source>
        <translation>最近 30 分钟</translation>
    </message>
    <message>
        <source>Stretch of time shown while following</source>
        <translation>跟随时所显示的时间段</translation>
    </message>
    <message>
        <source>Show the newest samples again and follow them.</source>
        <translation>重新显示最新采样并跟随它们。</translation>
    </message>
    <message>
        <source>Further traces</source>
        <translation>更多曲线</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>场景</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>俯视</translation>
    </message>
    <message>
        <source>Look along −z of the source, from above.</source>
        <translation>沿热源的 −z 方向，从上方看。</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>侧视</translation>
    </message>
    <message>
        <source>Look along x of the source, from the side.</source>
        <translation>沿热源的 x 方向，从侧面看。</translation>
    </message>
    <message>
        <source>Isometric</source>
        <translation>等轴测</translation>
    </message>
    <message>
        <source>Look from above at an angle.</source>
        <translation>从斜上方看。</translation>
    </message>
    <message>
        <source>View: %1</source>
        <translation>视角：%1</translation>
    </message>
    <message>
        <source>3-D scene: source, objects and their paths</source>
        <translation>三维场景：热源、物体及其路径</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>Press N, type, Enter: noted at this moment of the run</source>
        <translation>按 N 键，输入，再按回车：记在运行的此刻</translation>
    </message>
    <message>
        <source>Note at this moment of the run</source>
        <translation>运行此刻的备注</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>添加</translation>
    </message>
    <message>
        <source>Record the note with the present time.</source>
        <translation>以当前时间记录此备注。</translation>
    </message>
    <message>
        <source>Add the note</source>
        <translation>添加备注</translation>
    </message>
    <message>
        <source>Simulation speed</source>
        <translation>仿真速度</translation>
    </message>
    <message>
        <source>Simulated seconds a second; only on the simulated rig.</source>
        <translation>每秒仿真的秒数；仅用于仿真装置。</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>rotation</source>
        <translation>转动</translation>
    </message>
    <message>
        <source>acceleration</source>
        <translation>加速度</translation>
    </message>
    <message>
        <source>angular acceleration</source>
        <translation>角加速度</translation>
    </message>
    <message>
        <source>clearance</source>
        <translation>间距</translation>
    </message>
    <message>
        <source>workspace %1</source>
        <translation>工作空间 %1</translation>
    </message>
    <message>
        <source>No limit holds the robot back.</source>
        <translation>机器人未受任何限值约束。</translation>
    </message>
    <message>
        <source>A limit holds the robot back.</source>
        <translation>机器人受某个限值约束。</translation>
    </message>
    <message>
        <source>Held back by: %1</source>
        <translation>受限于：%1</translation>
    </message>
    <message>
        <source>Place UNKNOWN, what is drawn is %1.</source>
        <translation>位置未知，所画的是：%1。</translation>
    </message>
    <message>
        <source>The robot is not sure of its place.</source>
        <translation>机器人的位置不确定。</translation>
    </message>
    <message>
        <source>Thermal picture</source>
        <translation>热像图</translation>
    </message>
    <message>
        <source>present run</source>
        <translation>当前运行</translation>
    </message>
    <message>
        <source>run of %1</source>
        <translation>%1 的运行</translation>
    </message>
    <message>
        <source>Predicted</source>
        <translation>预测</translation>
    </message>
    <message>
        <source>%1 %2 %</source>
        <comment>the name of an object, and how much of the source the others hide from it</comment>
        <translation>%1 %2 %</translation>
    </message>
    <message>
        <source>Shaded: %1</source>
        <translation>遮挡：%1</translation>
    </message>
    <message>
        <source>How much of the source the other objects hide: %1. The view factors count it.</source>
        <translation>其他物体遮住热源的比例：%1。角系数已计入。</translation>
    </message>
    <message>
        <source>The run as the simulated rig predicts it from where it starts: dotted behind the traces, dashed in the scene. Its band: %1 runs with other sensor noise; not material, air or source, which are as the experiment has them. It is kept with the recording.</source>
        <translation>仿真装置从运行起始处预测的运行：在曲线后面为点线，在场景中为虚线。其色带：%1 次传感器噪声不同的运行；不涵盖不同的材料、空气或热源，它们取实验中的值。它与记录一同保存。</translation>
    </message>
</context>
<context>
    <name>bask::RunReport</name>
    <message>
        <source>%1: %2</source>
        <comment>command: its values</comment>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>, changing by a profile during the run</source>
        <translation>，运行期间按曲线变化</translation>
    </message>
    <message>
        <source>, tracked during the run</source>
        <translation>，运行期间被跟踪</translation>
    </message>
    <message>
        <source>Acknowledge</source>
        <translation>确认</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>报警</translation>
    </message>
    <message>
        <source>Alarms, events, notes and commands</source>
        <translation>报警、事件、备注和指令</translation>
    </message>
    <message>
        <source>All objects settled.</source>
        <translation>所有物体均已稳定。</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>面积</translation>
    </message>
    <message>
        <source>Areal heat capacity</source>
        <translation>面热容</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>待命</translation>
    </message>
    <message>
        <source>By itself</source>
        <translation>单独</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>标定</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>相机</translation>
    </message>
    <message>
        <source>Clearance to the source&apos;s plane</source>
        <translation>与热源平面的间距</translation>
    </message>
    <message>
        <source>Commanded speed</source>
        <translation>指令速度</translation>
    </message>
    <message>
        <source>Commanded speed of the end-effector as a share of its limits: %1 mm/s and %2 °/s.</source>
        <translation>末端执行器的指令速度占其限值的比例：%1 mm/s 和 %2 °/s。</translation>
    </message>
    <message>
        <source>Control from Start until Stop</source>
        <translation>从“开始”到“停止”的控制</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>控制器</translation>
    </message>
    <message>
        <source>Definitions</source>
        <translation>定义</translation>
    </message>
    <message>
        <source>Disarm</source>
        <translation>解除待命</translation>
    </message>
    <message>
        <source>Emittance of the source</source>
        <translation>热源的发射率</translation>
    </message>
    <message>
        <source>Ended by a fault.</source>
        <translation>因故障结束。</translation>
    </message>
    <message>
        <source>Experiment without a title</source>
        <translation>无标题的实验</translation>
    </message>
    <message>
        <source>Feasibility of the targets</source>
        <translation>目标的可行性</translation>
    </message>
    <message>
        <source>Fourier contour, radius %1 mm</source>
        <translation>傅里叶轮廓，半径 %1 mm</translation>
    </message>
    <message>
        <source>Free axes</source>
        <translation>自由轴</translation>
    </message>
    <message>
        <source>Gains at the start</source>
        <translation>开始时的增益</translation>
    </message>
    <message>
        <source>Heat source</source>
        <translation>热源</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>保持</translation>
    </message>
    <message>
        <source>Interrupted: the recording ended without a Stop. What had been written is reported.</source>
        <translation>已中断：记录未经“停止”而结束。本报告为已写入的内容。</translation>
    </message>
    <message>
        <source>It was not computed.</source>
        <translation>未计算。</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>LIVE</source>
        <translation>实机</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>标记</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation>指标</translation>
    </message>
    <message>
        <source>Model of the source</source>
        <translation>热源模型</translation>
    </message>
    <message>
        <source>Nearest that can be held</source>
        <translation>可保持的最近值</translation>
    </message>
    <message>
        <source>No pose keeps the workspace and the clearance.</source>
        <translation>没有位姿能同时满足工作空间和间距。</translation>
    </message>
    <message>
        <source>No samples were recorded: there are no traces, trajectories and metrics.</source>
        <translation>没有记录到采样：因此没有曲线、轨迹和指标。</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>编号</translation>
    </message>
    <message>
        <source>None was recorded.</source>
        <translation>没有记录。</translation>
    </message>
    <message>
        <source>Not all objects settled.</source>
        <translation>并非所有物体都已稳定。</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>物体</translation>
    </message>
    <message>
        <source>Objects</source>
        <translation>物体</translation>
    </message>
    <message>
        <source>Origin</source>
        <translation>来源</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>轮廓</translation>
    </message>
    <message>
        <source>Place on the end-effector</source>
        <translation>在末端执行器上的位置</translation>
    </message>
    <message>
        <source>Pose of the camera in the robot&apos;s base</source>
        <translation>相机在机器人基座坐标系中的位姿</translation>
    </message>
    <message>
        <source>Pose of the source</source>
        <translation>热源位姿</translation>
    </message>
    <message>
        <source>Pose of the source in the robot&apos;s base</source>
        <translation>热源在机器人基座坐标系中的位姿</translation>
    </message>
    <message>
        <source>Range in the workspace</source>
        <translation>工作空间中的范围</translation>
    </message>
    <message>
        <source>Recorded</source>
        <translation>记录时间</translation>
    </message>
    <message>
        <source>Recorded by</source>
        <translation>记录者</translation>
    </message>
    <message>
        <source>Recorded on a real rig.</source>
        <translation>在实际装置上记录。</translation>
    </message>
    <message>
        <source>Report made at</source>
        <translation>报告生成时间</translation>
    </message>
    <message>
        <source>Report made by</source>
        <translation>报告生成者</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>复位</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>继续</translation>
    </message>
    <message>
        <source>Rig</source>
        <translation>装置</translation>
    </message>
    <message>
        <source>SIMULATED</source>
        <translation>仿真</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>软件停止</translation>
    </message>
    <message>
        <source>Sampling</source>
        <translation>采样</translation>
    </message>
    <message>
        <source>Session file</source>
        <translation>会话文件</translation>
    </message>
    <message>
        <source>Set temperature</source>
        <translation>设定温度</translation>
    </message>
    <message>
        <source>Set-up</source>
        <translation>实验设置</translation>
    </message>
    <message>
        <source>Head of the hash chain (bask verify --head)</source>
        <translation>哈希链的头（bask verify --head）</translation>
    </message>
    <message>
        <source>Size of the session file</source>
        <translation>会话文件大小</translation>
    </message>
    <message>
        <source>Speed limits</source>
        <translation>速度限值</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>开始</translation>
    </message>
    <message>
        <source>Start pose</source>
        <translation>起始位姿</translation>
    </message>
    <message>
        <source>Steady, all together</source>
        <translation>稳态，同时保持</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Surroundings</source>
        <translation>周围环境</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>Target at the start</source>
        <translation>开始时的目标</translation>
    </message>
    <message>
        <source>Targets</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>Temperature (%1)</source>
        <translation>温度（%1）</translation>
    </message>
    <message>
        <source>The checksum is of the file without the log beside it.</source>
        <translation>校验和仅针对该文件，不含其旁的日志。</translation>
    </message>
    <message>
        <source>The experiment has none: the pose of the source is as typed.</source>
        <translation>实验中没有：热源位姿为手动输入。</translation>
    </message>
    <message>
        <source>The rig was simulated: these are not measurements of a real one.</source>
        <translation>装置为仿真：这些不是实际装置的测量结果。</translation>
    </message>
    <message>
        <source>The targets cannot be held together, by the materials as given: %1.</source>
        <translation>按给定的材料，各目标不能同时保持：%1。</translation>
    </message>
    <message>
        <source>Time (s)</source>
        <translation>时间（s）</translation>
    </message>
    <message>
        <source>Traces and trajectories</source>
        <translation>曲线与轨迹</translation>
    </message>
    <message>
        <source>View factor needed</source>
        <translation>所需的角系数</translation>
    </message>
    <message>
        <source>Warning, trip</source>
        <translation>警告，跳闸</translation>
    </message>
    <message>
        <source>Trajectories of the objects</source>
        <translation>物体的轨迹</translation>
    </message>
    <message>
        <source>Trajectories of the objects&apos; centres over the source until Stop, from the ring to the dot, coloured by temperature; black: the source.</source>
        <translation>到“停止”为止物体中心在热源上方的轨迹，从圆环到圆点，按温度着色；黑色：热源。</translation>
    </message>
    <message>
        <source>What</source>
        <translation>内容</translation>
    </message>
    <message>
        <source>Workspace</source>
        <translation>工作空间</translation>
    </message>
    <message>
        <source>Zero the sensors</source>
        <translation>将传感器校零</translation>
    </message>
    <message>
        <source>alarm, priority %1</source>
        <translation>报警，优先级 %1</translation>
    </message>
    <message>
        <source>as in the paper, without reflection</source>
        <translation>如论文所示，不计反射</translation>
    </message>
    <message>
        <source>as typed</source>
        <translation>按输入值</translation>
    </message>
    <message>
        <source>command</source>
        <translation>指令</translation>
    </message>
    <message>
        <source>date not known</source>
        <translation>日期未知</translation>
    </message>
    <message>
        <source>disk, radius %1 mm</source>
        <translation>圆盘，半径 %1 mm</translation>
    </message>
    <message>
        <source>error not known</source>
        <translation>误差未知</translation>
    </message>
    <message>
        <source>event</source>
        <translation>事件</translation>
    </message>
    <message>
        <source>every %1 s</source>
        <translation>每 %1 s</translation>
    </message>
    <message>
        <source>grey, with reflection</source>
        <translation>灰体，计入反射</translation>
    </message>
    <message>
        <source>measured by the camera, %1</source>
        <translation>由相机测量，%1</translation>
    </message>
    <message>
        <source>no event was recorded</source>
        <translation>没有记录到事件</translation>
    </message>
    <message>
        <source>no samples were recorded</source>
        <translation>没有记录到采样</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>not calibrated</source>
        <translation>未标定</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>note</source>
        <translation>备注</translation>
    </message>
    <message>
        <source>offsets of the sensors %1</source>
        <translation>传感器偏移 %1</translation>
    </message>
    <message>
        <source>page %1 of %2</source>
        <translation>第 %1 页，共 %2 页</translation>
    </message>
    <message>
        <source>polygon, radius %1 mm</source>
        <translation>多边形，半径 %1 mm</translation>
    </message>
    <message>
        <source>seen along x of the source</source>
        <translation>沿热源 x 方向观察</translation>
    </message>
    <message>
        <source>seen along −z of the source</source>
        <translation>沿热源 −z 方向观察</translation>
    </message>
    <message>
        <source>simulated, seed %1</source>
        <translation>仿真，随机种子 %1</translation>
    </message>
    <message>
        <source>surroundings %1</source>
        <translation>周围环境 %1</translation>
    </message>
    <message>
        <source>targets out of reach accepted</source>
        <translation>已接受无法达到的目标</translation>
    </message>
    <message>
        <source>too cold</source>
        <translation>太冷</translation>
    </message>
    <message>
        <source>too hot</source>
        <translation>太热</translation>
    </message>
    <message>
        <source>within the range</source>
        <translation>在范围内</translation>
    </message>
    <message>
        <source>without a name</source>
        <translation>未命名</translation>
    </message>
    <message numerus="yes">
        <source>%1 (min:s), %n sample(s)</source>
        <translation>
            <numerusform>%1（分:秒），%n 个采样</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 pixels, fx = %2 px, fy = %3 px, %4, %n view(s)</source>
        <translation>
            <numerusform>%1 像素，fx = %2 px，fy = %3 px，%4，%n 个视图</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n alarm(s)</source>
        <translation>
            <numerusform>%n 个报警</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n hole(s)</source>
        <translation>
            <numerusform>%n 个孔</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n marker(s) of dictionary %1</source>
        <translation>
            <numerusform>字典 %1 的 %n 个标记</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n more row(s) are in the session file; bask export --csv lists them.</source>
        <translation>
            <numerusform>会话文件中还有 %n 行；可用 bask export --csv 列出。</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 bytes</source>
        <translation>%1 字节</translation>
    </message>
    <message>
        <source>%1 mm/s and %2 °/s</source>
        <translation>%1 mm/s 和 %2 °/s</translation>
    </message>
    <message>
        <source>%1 px rms</source>
        <translation>均方根 %1 px</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 至 %2</translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation>已停止。</translation>
    </message>
    <message>
        <source>Ended by STOP.</source>
        <translation>因软件停止结束。</translation>
    </message>
    <message>
        <source>Interrupted: the recording ended without a Stop, and was closed later. What had been written is reported.</source>
        <translation>已中断：记录未经“停止”而结束，后来才关闭。本报告为已写入的内容。</translation>
    </message>
    <message>
        <source>All targets can be held together, by the materials as given, at %1; margin %2 to the nearest limit (%3).</source>
        <translation>按给定的材料，所有目标可在 %1 处同时保持；距最近的限制（%3）余量 %2。</translation>
    </message>
    <message>
        <source>Safety limits</source>
        <translation>安全限值</translation>
    </message>
    <message>
        <source>Air</source>
        <translation>空气</translation>
    </message>
    <message>
        <source>natural convection, by correlation</source>
        <translation>自然对流，按关联式</translation>
    </message>
    <message>
        <source>convection h = %1 W/(m² K)</source>
        <translation>对流系数 h = %1 W/(m² K)</translation>
    </message>
    <message>
        <source>convection not known, not counted</source>
        <translation>对流未知，未计入</translation>
    </message>
    <message>
        <source>Mean view factor</source>
        <translation>平均角系数</translation>
    </message>
    <message>
        <source>Without shade</source>
        <translation>无遮挡</translation>
    </message>
    <message>
        <source>Taken by the others, mean</source>
        <translation>被其他物体挡住，平均</translation>
    </message>
    <message>
        <source>Taken by the others, largest</source>
        <translation>被其他物体挡住，最大</translation>
    </message>
    <message>
        <source>Shade of the objects on one another, from Start until Stop</source>
        <translation>从“开始”到“停止”期间物体之间的相互遮挡</translation>
    </message>
    <message>
        <source>Evenness of the source</source>
        <translation>热源的均匀性</translation>
    </message>
    <message>
        <source>Fixture or shield</source>
        <translation>夹具或遮板</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>on the end-effector: %1</source>
        <translation>在末端执行器上：%1</translation>
    </message>
    <message>
        <source>in the robot&apos;s base: %1</source>
        <translation>在机器人基座中：%1</translation>
    </message>
    <message>
        <source>thermal camera</source>
        <translation>热像仪</translation>
    </message>
    <message>
        <source>sensor, checked by the thermal camera</source>
        <translation>传感器，由热像仪核对</translation>
    </message>
    <message>
        <source>sensor on the object</source>
        <translation>物体上的传感器</translation>
    </message>
    <message>
        <source>Temperature by</source>
        <translation>温度来自</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>测得</translation>
    </message>
    <message>
        <source>By the camera, ± 2 standard uncertainties</source>
        <translation>热像仪，± 2 倍标准不确定度</translation>
    </message>
    <message>
        <source>Largest difference across the face</source>
        <translation>面上的最大温差</translation>
    </message>
    <message>
        <source>Pixels</source>
        <translation>像素</translation>
    </message>
    <message>
        <source>not read</source>
        <translation>未读取</translation>
    </message>
    <message>
        <source>The thermal camera at the last sample until Stop</source>
        <translation>停止前最后一个采样时的热像仪</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>操作员</translation>
    </message>
    <message>
        <source>Sample</source>
        <translation>样品</translation>
    </message>
    <message>
        <source>Batch</source>
        <translation>批次</translation>
    </message>
    <message>
        <source>not told: the recording was altered</source>
        <translation>不予给出：记录被改动过</translation>
    </message>
    <message>
        <source>This recording was altered after it had been recorded, so nothing here is proven; bask verify tells where.</source>
        <translation>此记录在记录之后被改动过，因此这里的内容均无法证明；bask verify 会指出位置。</translation>
    </message>
    <message>
        <source>zeroed %1</source>
        <translation>校零于 %1</translation>
    </message>
    <message>
        <source>from Arm at %1; Start at %2</source>
        <translation>自待命起，%1；开始，%2</translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation>仿真</translation>
    </message>
    <message>
        <source>Heat rates at Start</source>
        <translation>开始时的热速率</translation>
    </message>
    <message>
        <source>%1 %2 (set point %3)</source>
        <comment>when: the source&apos;s temperature</comment>
        <translation>%1 %2（设定值 %3）</translation>
    </message>
    <message>
        <source>at Start</source>
        <translation>开始时</translation>
    </message>
    <message>
        <source>settled at %1 s</source>
        <translation>%1 s 稳定时</translation>
    </message>
    <message>
        <source>at the end of control</source>
        <translation>控制结束时</translation>
    </message>
    <message>
        <source>Source in the run</source>
        <translation>运行中的热源</translation>
    </message>
    <message>
        <source>λ₁ at Start (K/s)</source>
        <translation>开始时的 λ₁（K/s）</translation>
    </message>
    <message>
        <source>by the material</source>
        <translation>按材料</translation>
    </message>
    <message>
        <source>λ₂ at Start (1/(K³ s))</source>
        <translation>开始时的 λ₂（1/(K³ s)）</translation>
    </message>
    <message>
        <source>Where from</source>
        <translation>来源</translation>
    </message>
    <message>
        <source>given by the experiment</source>
        <translation>由实验给出</translation>
    </message>
    <message>
        <source>the material, made wrong</source>
        <translation>材料，有意加入误差</translation>
    </message>
    <message>
        <source>the material</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>Heat rates with which the controller began</source>
        <translation>控制器起始时所用的热速率</translation>
    </message>
    <message>
        <source>± is the standard uncertainty of a material&apos;s value.</source>
        <translation>± 为材料数值的标准不确定度。</translation>
    </message>
    <message>
        <source>none</source>
        <comment>no simulated fault any more</comment>
        <translation>无</translation>
    </message>
    <message>
        <source>ended</source>
        <comment>a simulated fault</comment>
        <translation>已结束</translation>
    </message>
    <message>
        <source>Speed of the simulation</source>
        <translation>仿真速度</translation>
    </message>
    <message>
        <source>Temperature of the source, as typed</source>
        <translation>热源温度（手动输入）</translation>
    </message>
    <message>
        <source>Simulated fault</source>
        <translation>模拟故障</translation>
    </message>
</context>
<context>
    <name>bask::RunStateChip</name>
    <message>
        <source>Click for the reasons and what to do.</source>
        <translation>单击可查看原因和应对方法。</translation>
    </message>
    <message>
        <source>State of the run: %1</source>
        <translation>运行状态：%1</translation>
    </message>
    <message>
        <source>UNKNOWN</source>
        <comment>state of the run</comment>
        <translation>未知</translation>
    </message>
</context>
<context>
    <name>bask::SafetyPanel</name>
    <message>
        <source>Safety limits</source>
        <translation>安全限值</translation>
    </message>
    <message>
        <source>More</source>
        <translation>更多</translation>
    </message>
    <message>
        <source>%1 has limits of its own: warning %2, trip %3.</source>
        <translation>%1 有自己的限值：警告 %2，跳闸 %3。</translation>
    </message>
</context>
<context>
    <name>bask::SaveMaterialDialog</name>
    <message>
        <source>Save as material</source>
        <translation>存为材料</translation>
    </message>
    <message>
        <source>measured on a sample, data sheet, book</source>
        <translation>样品测量、数据表、书籍</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>来源</translation>
    </message>
    <message>
        <source>Values, with their standard uncertainties</source>
        <translation>数值及其标准不确定度</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>Standard uncertainty: %1</source>
        <translation>标准不确定度：%1</translation>
    </message>
    <message>
        <source>The library has a material of this name. Its values are replaced.</source>
        <translation>材料库中已有此名称的材料。其数值将被替换。</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>替换</translation>
    </message>
    <message>
        <source>As it is, or as a share of the value: 2 %</source>
        <translation>直接填写，或写成该值的百分比：2 %</translation>
    </message>
</context>
<context>
    <name>bask::SceneOverlay</name>
    <message>
        <source>x (cm)</source>
        <translation>x（cm）</translation>
    </message>
    <message>
        <source>y (cm)</source>
        <translation>y（cm）</translation>
    </message>
    <message>
        <source>z (cm)</source>
        <translation>z（cm）</translation>
    </message>
    <message>
        <source>θx (°)</source>
        <translation>θx（°）</translation>
    </message>
    <message>
        <source>θy (°)</source>
        <translation>θy（°）</translation>
    </message>
    <message>
        <source>θz (°)</source>
        <translation>θz（°）</translation>
    </message>
    <message>
        <source>object&apos;s x (cm)</source>
        <translation>物体的 x（cm）</translation>
    </message>
    <message>
        <source>object&apos;s y (cm)</source>
        <translation>物体的 y（cm）</translation>
    </message>
    <message>
        <source>object&apos;s z (cm)</source>
        <translation>物体的 z（cm）</translation>
    </message>
</context>
<context>
    <name>bask::SceneView</name>
    <message>
        <source>Source</source>
        <translation>热源</translation>
    </message>
    <message>
        <source>3-D scene</source>
        <translation>三维场景</translation>
    </message>
    <message>
        <source>The 3-D scene needs OpenGL 3.2, which this display does not offer. Everything else works.</source>
        <translation>三维场景需要 OpenGL 3.2，而此显示环境不提供。其他功能均正常。</translation>
    </message>
</context>
<context>
    <name>bask::SerialForm</name>
    <message>
        <source>no parity</source>
        <translation>无校验</translation>
    </message>
    <message>
        <source>even parity</source>
        <translation>偶校验</translation>
    </message>
    <message>
        <source>odd parity</source>
        <translation>奇校验</translation>
    </message>
    <message>
        <source>Speed of the line, baud</source>
        <translation>线路速率，波特</translation>
    </message>
    <message>
        <source>Data bits</source>
        <translation>数据位</translation>
    </message>
    <message>
        <source>Parity</source>
        <translation>校验</translation>
    </message>
    <message>
        <source>Stop bits</source>
        <translation>停止位</translation>
    </message>
</context>
<context>
    <name>bask::SessionActions</name>
    <message>
        <source>Unsaved experiment</source>
        <translation>未保存的实验</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was changed and not saved.</source>
        <translation>“%1”已更改但未保存。</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Discard changes</source>
        <translation>放弃更改</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Open an experiment or a session</source>
        <translation>打开实验或会话</translation>
    </message>
    <message>
        <source>Experiments and sessions (*.json *.bask);;Experiments (*.json);;Sessions (*.bask);;All files (*)</source>
        <translation>实验和会话 (*.json *.bask);;实验 (*.json);;会话 (*.bask);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Open a session</source>
        <translation>打开会话</translation>
    </message>
    <message>
        <source>Sessions (*.bask);;All files (*)</source>
        <translation>会话 (*.bask);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>已保存 %1</translation>
    </message>
    <message>
        <source>Save the experiment</source>
        <translation>保存实验</translation>
    </message>
    <message>
        <source>Experiments (*.json)</source>
        <translation>实验 (*.json)</translation>
    </message>
    <message>
        <source>Save the session</source>
        <translation>保存会话</translation>
    </message>
    <message>
        <source>Sessions (*.bask)</source>
        <translation>会话 (*.bask)</translation>
    </message>
    <message>
        <source>Session saved as %1</source>
        <translation>会话已另存为 %1</translation>
    </message>
    <message>
        <source>the folder cannot be made</source>
        <translation>无法创建文件夹</translation>
    </message>
    <message>
        <source>Open a rig</source>
        <translation>打开装置</translation>
    </message>
    <message>
        <source>Rigs (*.json);;All files (*)</source>
        <translation>装置 (*.json);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Save the rig</source>
        <translation>保存装置</translation>
    </message>
    <message>
        <source>The rig was saved as %1.</source>
        <translation>装置已保存为 %1。</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>保存报告</translation>
    </message>
    <message>
        <source>Texts (*.txt);;All files (*)</source>
        <translation>文本 (*.txt);;所有文件 (*)</translation>
    </message>
    <message>
        <source>The report was saved as %1.</source>
        <translation>报告已保存为 %1。</translation>
    </message>
    <message>
        <source>Folder of recorded runs</source>
        <translation>已记录运行的文件夹</translation>
    </message>
    <message>
        <source>Folder for the exported files</source>
        <translation>存放导出文件的文件夹</translation>
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
        <source>&quot;%1&quot; was not opened: edits were made or recovered while it was read. Open it again to replace them.</source>
        <translation>未打开“%1”：读取期间有新的编辑或已恢复的编辑。如要替换这些编辑，请重新打开。</translation>
    </message>
    <message>
        <source>Limits of the real rig</source>
        <translation>实机装置的限值</translation>
    </message>
    <message>
        <source>&quot;%1&quot; allows the real rig more than now:</source>
        <translation>“%1”允许实机装置超出现在的范围：</translation>
    </message>
    <message>
        <source>Do robot, source, objects and sensors bear it?</source>
        <translation>机器人、热源、物体和传感器能承受吗？</translation>
    </message>
    <message>
        <source>Open with these limits</source>
        <translation>以这些限值打开</translation>
    </message>
    <message>
        <source>Save the comparison</source>
        <translation>保存比较</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>表格 (*.csv)</translation>
    </message>
    <message>
        <source>The experiment of %1 is open as a new one, which is not saved yet.</source>
        <translation>%1 的实验已作为新实验打开，尚未保存。</translation>
    </message>
    <message>
        <source>Figures (*%1)</source>
        <translation>图 (*%1)</translation>
    </message>
    <message>
        <source>Save the table</source>
        <translation>保存表格</translation>
    </message>
    <message>
        <source>Save the figure</source>
        <translation>保存图</translation>
    </message>
    <message>
        <source>No table was written: the first samples of the shown time are in the recording only. Open it on the Review page and export the table there, or show a later stretch of time.</source>
        <translation>未写入表格：所显示时间内最初的采样只在记录中。请在“回顾”页打开该记录并在那里导出表格，或显示较晚的时间段。</translation>
    </message>
    <message>
        <source>Figures and reports are drawn only while no run and no recipe is on or begins, no heat is asked for and the robot stands still: the window, with its STOP, would have to wait for them. Nothing was written.</source>
        <translation>只有没有运行或配方正在进行或开始、未要求加热且机器人静止时才绘制图形和报告：否则带有 STOP 的窗口必须等待。未写入任何内容。</translation>
    </message>
    <message>
        <source>Choose another name</source>
        <translation>选择其他名称</translation>
    </message>
    <message>
        <source>%1 is there already.</source>
        <translation>%1 已经存在。</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>替换</translation>
    </message>
    <message>
        <source>Save the NeXus file</source>
        <translation>保存 NeXus 文件</translation>
    </message>
    <message>
        <source>NeXus (*.nxs)</source>
        <translation>NeXus (*.nxs)</translation>
    </message>
</context>
<context>
    <name>bask::SessionExport</name>
    <message numerus="yes">
        <source>%n file(s) written to %1</source>
        <translation>
            <numerusform>已将 %n 个文件写入 %1</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 written to %2</source>
        <translation>已将 %1 写入 %2</translation>
    </message>
</context>
<context>
    <name>bask::SessionList</name>
    <message numerus="yes">
        <source>%1 of %n session(s)</source>
        <translation>
            <numerusform>%n 个会话中的 %1 个</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sample(s)</source>
        <translation>
            <numerusform>%n 个样本</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n session(s)</source>
        <translation>
            <numerusform>%n 个会话</numerusform>
        </translation>
    </message>
    <message>
        <source>Choose the folder whose runs are listed</source>
        <translation>选择要列出其运行的文件夹</translation>
    </message>
    <message>
        <source>Close it properly</source>
        <translation>正确关闭</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>时长</translation>
    </message>
    <message>
        <source>Folder…</source>
        <translation>文件夹…</translation>
    </message>
    <message>
        <source>Kept in the session file. A recording without an end has to be closed first.</source>
        <translation>保存在会话文件中。没有结尾的记录须先关闭。</translation>
    </message>
    <message>
        <source>LIVE</source>
        <translation>实机</translation>
    </message>
    <message>
        <source>No recorded runs in this folder.</source>
        <translation>此文件夹中没有已记录的运行。</translation>
    </message>
    <message>
        <source>Open on this page</source>
        <translation>已在本页打开</translation>
    </message>
    <message>
        <source>Open the selected run</source>
        <translation>打开所选运行</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>打开</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>Overlay</source>
        <translation>叠加</translation>
    </message>
    <message>
        <source>Reading the folder…</source>
        <translation>正在读取文件夹…</translation>
    </message>
    <message>
        <source>Recorded runs</source>
        <translation>已记录的运行</translation>
    </message>
    <message>
        <source>Recorded</source>
        <translation>记录时间</translation>
    </message>
    <message>
        <source>Rig</source>
        <translation>装置</translation>
    </message>
    <message>
        <source>SIMULATED</source>
        <translation>仿真</translation>
    </message>
    <message>
        <source>Search the recorded runs</source>
        <translation>搜索已记录的运行</translation>
    </message>
    <message>
        <source>Tags of the selected run, with commas</source>
        <translation>所选运行的标签，用逗号分隔</translation>
    </message>
    <message>
        <source>Tags</source>
        <translation>标签</translation>
    </message>
    <message>
        <source>The recording has no end: Bask or the computer went down. Saved: %1, until %2 after Start; at most the last %3 s before it went down are missing.</source>
        <translation>记录没有结尾：Bask 或计算机曾意外终止。已保存：%1，直至开始后 %2；最多缺少终止前最后 %3 秒。</translation>
    </message>
    <message>
        <source>The runs listed are in %1</source>
        <translation>所列运行位于 %1</translation>
    </message>
    <message>
        <source>This run is being recorded now.</source>
        <translation>此运行正在记录中。</translation>
    </message>
    <message>
        <source>with commas</source>
        <translation>用逗号分隔</translation>
    </message>
    <message>
        <source>Search names, experiments, operators, samples, notes, tags</source>
        <translation>搜索名称、实验、操作员、样品、备注、标签</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>操作员</translation>
    </message>
    <message>
        <source>Sample / batch</source>
        <translation>样品 / 批次</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>运行</translation>
    </message>
    <message>
        <source>No run matches &quot;%1&quot;.</source>
        <translation>没有与“%1”匹配的运行。</translation>
    </message>
    <message>
        <source>Show all runs</source>
        <translation>显示全部运行</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>打开(&amp;O)</translation>
    </message>
    <message>
        <source>O&amp;verlay</source>
        <translation>叠加(&amp;V)</translation>
    </message>
    <message>
        <source>Open as &amp;new experiment</source>
        <translation>作为新实验打开(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Sort by</source>
        <translation>排序方式(&amp;S)</translation>
    </message>
    <message>
        <source>Finds the runs that have every word in what the list shows, or among objects, materials and notes.</source>
        <translation>查找列表所显示的内容或物体、材料、备注中含有全部词语的运行。</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>控制器</translation>
    </message>
    <message>
        <source>Alarms…</source>
        <translation>报警…</translation>
    </message>
    <message>
        <source>Which alarms the listed runs had, how often and when</source>
        <translation>所列运行中出现过哪些报警、多少次、何时</translation>
    </message>
    <message>
        <source>From Start to Stop, STOP or the engine&apos;s end of the run. What is recorded after it, until all is away or cold, does not count.</source>
        <translation>从“开始”到“停止”、软件停止或引擎结束运行为止。此后记录到一切撤离或冷却为止的部分不计。</translation>
    </message>
    <message>
        <source>Lay the selected runs over the open one</source>
        <translation>将所选的各次运行叠加到已打开的运行上</translation>
    </message>
    <message>
        <source>Draws the selected runs over the one that is open, all from their Start. Without an open one, select several (Ctrl and click): the first of them is opened.</source>
        <translation>将所选的各次运行叠加到已打开的运行上，都从开始时刻对齐。没有打开的运行时，请选择几次（按住 Ctrl 并单击）：其中第一个会被打开。</translation>
    </message>
    <message>
        <source>Not verified: nobody has looked yet whether the recording is as it was made.</source>
        <translation>未验证：还没有人查看此记录是否与生成时一致。</translation>
    </message>
    <message>
        <source>%1, not verified</source>
        <comment>an outcome</comment>
        <translation>%1，未验证</translation>
    </message>
    <message>
        <source>What each run told at its end; in italics until its recording was verified: a short one while nothing else is to be done, a long one when it is opened. Damage of its file is found when the run is selected, too. All of it is listed until the file changes or Bask is closed.</source>
        <translation>各次运行结束时给出的结果；在其记录得到验证之前以斜体显示：较短的在没有别的事要做时验证，较长的在打开时验证。选中运行时也会发现其文件的损坏。这些都保留到文件改变或 Bask 关闭。</translation>
    </message>
</context>
<context>
    <name>bask::SheetPanel</name>
    <message>
        <source>A marker&apos;s side is truly %1.</source>
        <translation>标记的实际边长为 %1。</translation>
    </message>
    <message>
        <source>A square&apos;s side is truly %1.</source>
        <translation>方格的实际边长为 %1。</translation>
    </message>
    <message>
        <source>&amp;Dictionary</source>
        <translation>字典(&amp;D)</translation>
    </message>
    <message>
        <source>Calibration board</source>
        <translation>标定板</translation>
    </message>
    <message>
        <source>Give the markers&apos; numbers such as 1-4, 11.</source>
        <translation>请给出标记编号，例如 1-4, 11。</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>标记</translation>
    </message>
    <message>
        <source>Measured &amp;length</source>
        <translation>实测长度(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Numbers</source>
        <translation>编号(&amp;N)</translation>
    </message>
    <message>
        <source>Of the ruler on the print, which is 100 mm long.</source>
        <translation>打印件上标尺的长度，其标称长度为 100 mm。</translation>
    </message>
    <message>
        <source>&amp;Paper</source>
        <translation>纸张(&amp;P)</translation>
    </message>
    <message>
        <source>Printers scale, and no picture tells how large a square is: measure the ruler on the print, from 0 to 100 mm.</source>
        <translation>打印机会缩放，而图像无法得知方格有多大：请测量打印件上的标尺，从 0 到 100 mm。</translation>
    </message>
    <message>
        <source>Save as PDF…</source>
        <translation>保存为 PDF…</translation>
    </message>
    <message>
        <source>Save the sheet</source>
        <translation>保存打印页</translation>
    </message>
    <message>
        <source>Saved. Print it at 100 % (actual size) and measure its ruler.</source>
        <translation>已保存。请按 100 %（实际尺寸）打印，并测量其标尺。</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>打印页</translation>
    </message>
    <message>
        <source>Sheets to be printed</source>
        <translation>待打印的页面</translation>
    </message>
    <message>
        <source>&amp;Side of a marker</source>
        <translation>标记的边长(&amp;S)</translation>
    </message>
    <message>
        <source>Such as 1-4, 11</source>
        <translation>例如 1-4, 11</translation>
    </message>
    <message>
        <source>The first of %1 pages</source>
        <translation>第一页，共 %1 页</translation>
    </message>
    <message>
        <source>The sheet as it is printed</source>
        <translation>打印页的实际样子</translation>
    </message>
    <message>
        <source>Use the true lengths</source>
        <translation>使用实际长度</translation>
    </message>
    <message>
        <source>With its black border.</source>
        <translation>含黑色边框。</translation>
    </message>
    <message>
        <source>Print</source>
        <translation>打印</translation>
    </message>
    <message>
        <source>The sheet was saved as %1.</source>
        <translation>打印页已保存为 %1。</translation>
    </message>
</context>
<context>
    <name>bask::ShelfPopup</name>
    <message>
        <source>An alarm of priority 1 is shelved for a shorter time.</source>
        <translation>优先级 1 的报警只能搁置较短时间。</translation>
    </message>
    <message>
        <source>Put this alarm aside for a time. It comes back by itself, and the engine goes on watching and acting.</source>
        <translation>将此报警暂时搁置。它会自行恢复，引擎继续监视和动作。</translation>
    </message>
    <message>
        <source>Why? (needed)</source>
        <translation>为什么？（必填）</translation>
    </message>
    <message>
        <source>Why the alarm is shelved</source>
        <translation>搁置报警的理由</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 分钟</translation>
    </message>
    <message>
        <source>Shelve for %1 min</source>
        <translation>搁置 %1 分钟</translation>
    </message>
</context>
<context>
    <name>bask::SourceTile</name>
    <message>
        <source>Source</source>
        <translation>热源</translation>
    </message>
    <message>
        <source>Set point</source>
        <translation>设定值</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>变化率</translation>
    </message>
    <message>
        <source>Slope of the readings of the last 10 s</source>
        <translation>最近 10 s 读数的斜率</translation>
    </message>
    <message>
        <source>Where the heat goes, or the set point with which a run begins while it is off</source>
        <translation>加热的目标值；加热关闭时，为运行开始时的设定值</translation>
    </message>
    <message>
        <source>Temperature of the source</source>
        <translation>热源的温度</translation>
    </message>
</context>
<context>
    <name>bask::SourceWords</name>
    <message>
        <source>How long it takes to heat it is not known.</source>
        <translation>加热需要多长时间未知。</translation>
    </message>
    <message>
        <source>Heated from now on it takes about %1.</source>
        <translation>从现在起加热，大约需要 %1。</translation>
    </message>
    <message>
        <source>The source has %1, its set point is %2 (%3). Start does not wait for it: the run begins, and its time counts, while the source warms up.</source>
        <translation>热源为 %1，其设定值为 %2（%3）。“开始”不会等待它：热源升温期间运行已经开始并计时。</translation>
    </message>
    <message>
        <source>The run has ended. Its time and its recording go on until the source and the objects are cold (source %1), or until the next Arm.</source>
        <translation>运行已结束。其时间和记录继续，直到热源和物体冷却（热源 %1）或下一次待命为止。</translation>
    </message>
</context>
<context>
    <name>bask::StateBar</name>
    <message>
        <source>The engine is not answering. The robot ends its step, and a heat source with a watchdog goes off by itself. Look at the rig, then close Bask and start it again.</source>
        <translation>引擎没有应答。机器人会走完当前步，带看门狗的热源会自行关闭。请查看装置，然后关闭 Bask 并重新启动。</translation>
    </message>
    <message>
        <source>The rig is simulated: no device moves or heats.</source>
        <translation>装置为仿真：没有设备运动或加热。</translation>
    </message>
    <message>
        <source>The rig is real: Start moves it and opens the heat.</source>
        <translation>装置为实机：“开始”会使其运动并打开加热。</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>运行</translation>
    </message>
    <message>
        <source>Time since Start</source>
        <translation>自开始以来的时间</translation>
    </message>
    <message>
        <source>State of the run</source>
        <translation>运行状态</translation>
    </message>
    <message>
        <source>Click to change it.</source>
        <translation>点击可更改。</translation>
    </message>
    <message>
        <source>Simulated faults, which Tools &gt; Simulate fault ends:</source>
        <translation>模拟故障，可在“工具 &gt; 模拟故障”中结束：</translation>
    </message>
    <message>
        <source>recorded until cold</source>
        <comment>under the clock: the run has ended</comment>
        <translation>记录至冷却</translation>
    </message>
    <message>
        <source>until cold</source>
        <comment>the same where there is less room</comment>
        <translation>至冷却</translation>
    </message>
</context>
<context>
    <name>bask::StatusLine</name>
    <message>
        <source>engine not answering</source>
        <translation>引擎没有应答</translation>
    </message>
    <message>
        <source>readings %1 s old</source>
        <translation>读数已过去 %1 s</translation>
    </message>
    <message>
        <source>no readings</source>
        <translation>没有读数</translation>
    </message>
    <message>
        <source>(simulation ×%1)</source>
        <translation>（仿真 ×%1）</translation>
    </message>
    <message>
        <source>loop %1 Hz, late %2</source>
        <translation>回路 %1 Hz，延迟 %2</translation>
    </message>
    <message>
        <source>not recording</source>
        <translation>未记录</translation>
    </message>
    <message>
        <source>recording %1, %2 samples</source>
        <translation>正在记录 %1，%2 个采样</translation>
    </message>
    <message>
        <source>Control steps a second, and how many began late</source>
        <translation>每秒控制步数，以及其中延迟开始的步数</translation>
    </message>
    <message>
        <source>Temperature unit</source>
        <translation>温度单位</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>语言</translation>
    </message>
    <message>
        <source>source not seen</source>
        <translation>看不到热源</translation>
    </message>
    <message>
        <source>source not seen for %1 s, predicted</source>
        <translation>已有 %1 s 看不到热源，采用预测</translation>
    </message>
    <message>
        <source>source followed</source>
        <translation>正在跟踪热源</translation>
    </message>
    <message>
        <source>%1 ms late</source>
        <translation>延迟 %1 ms</translation>
    </message>
    <message>
        <source>±%1 mm</source>
        <translation>±%1 mm</translation>
    </message>
    <message>
        <source>How the camera follows the source: time from the light to the pose, two standard deviations of its place</source>
        <translation>相机跟踪热源的情况：从曝光到得出位姿的时间，以及热源位置的两倍标准差</translation>
    </message>
    <message>
        <source>Age of the newest temperature readings; of a real rig, of each device&apos;s newest answer</source>
        <translation>最新温度读数的时龄；对于实际装置，为各设备最新应答的时龄</translation>
    </message>
    <message>
        <source>source %1,</source>
        <translation>热源 %1，</translation>
    </message>
    <message>
        <source>source %1 as typed,</source>
        <translation>热源 %1（输入值），</translation>
    </message>
    <message>
        <source>source: no temperature typed,</source>
        <translation>热源：未输入温度，</translation>
    </message>
    <message>
        <source>monitoring fails</source>
        <translation>监视失败</translation>
    </message>
    <message>
        <source>monitored</source>
        <translation>受监视</translation>
    </message>
    <message numerus="yes">
        <source>What the run does is published (View &gt; Monitoring): %n message(s)</source>
        <translation>
            <numerusform>运行的情况已发布（视图 &gt; 监视）：%n 条消息</numerusform>
        </translation>
    </message>
    <message>
        <source>monitoring begins</source>
        <translation>监视开始</translation>
    </message>
    <message numerus="yes">
        <source>%n event(s) were not published</source>
        <translation>
            <numerusform>有 %n 个事件未发布</numerusform>
        </translation>
    </message>
    <message>
        <source>Newest temperature of the source, and whether it is heated, as the device has confirmed. UNKNOWN: it may be hot, whatever was ordered. Heats though off: it warms all the same.</source>
        <translation>热源的最新温度，以及设备所确认的是否加热。未知：无论下过什么命令，它都可能是热的。关闭仍加热：它照样升温。</translation>
    </message>
    <message>
        <source>recorded until cold: source %1; %2, %3 samples</source>
        <translation>记录至冷却：热源 %1；%2，%3 个采样</translation>
    </message>
</context>
<context>
    <name>bask::StopButton</name>
    <message>
        <source>STOP</source>
        <translation>软件停止</translation>
    </message>
    <message>
        <source>Zero velocity and heater off now; latched until reset (F12).
This is a software stop, not a safety-rated emergency stop.</source>
        <translation>立即使速度为零并关闭加热器；锁存直至复位（F12）。
这是软件停止，不是安全等级的急停。</translation>
    </message>
    <message>
        <source>STOP: zero velocity and heater off now (F12)</source>
        <translation>软件停止：立即使速度为零并关闭加热器（F12）</translation>
    </message>
    <message>
        <source>Software stop, not a safety-rated emergency stop.</source>
        <translation>软件停止，不是安全等级的急停。</translation>
    </message>
</context>
<context>
    <name>bask::SurfacesView</name>
    <message>
        <source>The animation is not whole: the experiment was changed while it was saved.</source>
        <translation>动画不完整：保存期间实验被更改。</translation>
    </message>
    <message>
        <source>3-D scene: where the end-effector may be for each object to hold its target</source>
        <translation>三维场景：各物体保持其目标时末端执行器可处的位置</translation>
    </message>
    <message>
        <source>End-effector positions</source>
        <translation>末端执行器位置</translation>
    </message>
    <message>
        <source>Each object&apos;s own positions (as in the paper)</source>
        <translation>各物体自身位置（如论文所示）</translation>
    </message>
    <message>
        <source>End-effector angles</source>
        <translation>末端执行器角度</translation>
    </message>
    <message>
        <source>What the surfaces are drawn over</source>
        <translation>等值面以什么为坐标绘制</translation>
    </message>
    <message>
        <source>What the surfaces are drawn over. On its surface an object holds its target.</source>
        <translation>等值面以什么为坐标绘制。在其等值面上，物体可保持其目标。</translation>
    </message>
    <message>
        <source>Picture saved: %1</source>
        <translation>图片已保存：%1</translation>
    </message>
    <message>
        <source>Animation saved in %1: frame-1.png to frame-9.png, and all in panels.png</source>
        <translation>动画已保存在 %1：frame-1.png 至 frame-9.png，以及汇总的 panels.png</translation>
    </message>
</context>
<context>
    <name>bask::SurveyBar</name>
    <message>
        <source>The robot moves to pose %1 of %2.</source>
        <translation>机器人正运动到位姿 %1 / %2。</translation>
    </message>
    <message>
        <source>Looking, picture %1 of %2. Nothing may move.</source>
        <translation>正在观测，图像 %1 / %2。任何东西都不得移动。</translation>
    </message>
    <message>
        <source>Computing…</source>
        <translation>正在计算…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Pictures looked at</source>
        <translation>已观测的图像</translation>
    </message>
</context>
<context>
    <name>bask::TargetScene</name>
    <message>
        <source>Picked</source>
        <translation>所选点</translation>
    </message>
    <message>
        <source>All targets</source>
        <translation>全部目标</translation>
    </message>
    <message>
        <source>Closest</source>
        <translation>最接近</translation>
    </message>
    <message>
        <source>%1 %2 to %3°</source>
        <comment>an angle, its least and largest value</comment>
        <translation>%1 %2 至 %3°</translation>
    </message>
    <message>
        <source>The robot does not turn</source>
        <translation>机器人不转动</translation>
    </message>
    <message>
        <source>Robot: %1</source>
        <translation>机器人：%1</translation>
    </message>
    <message>
        <source>%1 %2: nowhere here</source>
        <comment>object, target</comment>
        <translation>%1 %2：此处没有</translation>
    </message>
    <message>
        <source>3-D scene of the targets</source>
        <translation>目标的三维场景</translation>
    </message>
    <message>
        <source>The 3-D scene of the targets needs OpenGL 3.2, which this display does not offer. Everything else works.</source>
        <translation>目标的三维场景需要 OpenGL 3.2，而此显示环境不提供。其他功能均正常。</translation>
    </message>
    <message>
        <source>%1: F %2, steady %3, %4/%5</source>
        <comment>name, view factor, temperature, slope</comment>
        <translation>%1：F %2，稳态 %3，%4/%5</translation>
    </message>
</context>
<context>
    <name>bask::TargetsPage</name>
    <message>
        <source>Target of %1</source>
        <translation>%1 的目标</translation>
    </message>
    <message>
        <source>Checking…</source>
        <translation>正在检查…</translation>
    </message>
    <message>
        <source>Nearest reachable</source>
        <translation>最近可达</translation>
    </message>
    <message>
        <source>Set the target of %1 to the nearest reachable one</source>
        <translation>将 %1 的目标设为最近的可达值</translation>
    </message>
    <message>
        <source>Set the target to %1</source>
        <translation>将目标设为 %1</translation>
    </message>
    <message>
        <source>The target is within reach already.</source>
        <translation>目标已在可达范围内。</translation>
    </message>
    <message>
        <source>There is no object yet. Add one on the Objects page.</source>
        <translation>尚无物体。请在“物体”页面添加一个。</translation>
    </message>
    <message>
        <source>, </source>
        <comment>between names</comment>
        <translation>、</translation>
    </message>
    <message>
        <source>Checking the targets…</source>
        <translation>正在检查目标…</translation>
    </message>
    <message>
        <source>Targets</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>物体</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>判定</translation>
    </message>
    <message>
        <source>What is checked</source>
        <translation>检查的内容</translation>
    </message>
    <message>
        <source>To stay at its target an object must take up as much heat as it gives off. That fixes its view factor F, the share of its sight that the source fills: near 0 far away, near 1 close to the source and facing it. A target is reachable if its F occurs somewhere in the robot&apos;s workspace with the clearance kept; all can be held together if one pose has the F of each. In the bars, solid is what can be held here, outlined what the source could hold at F = 1.</source>
        <translation>要停留在目标温度，物体吸收的热量必须与散出的热量相等。这就确定了它的角系数 F，即热源在其视野中所占的份额：远离时接近 0，靠近并正对热源时接近 1。若在保持间距的前提下，其 F 在机器人工作空间中的某处出现，该目标即可达；若有一个位姿使各物体的 F 同时出现，则全部目标可同时保持。条形图中，实心部分为此处可保持的范围，空心轮廓为热源在 F = 1 时可保持的范围。</translation>
    </message>
    <message>
        <source>Starting out of reach</source>
        <translation>在目标无法达到的情况下开始</translation>
    </message>
    <message>
        <source>All targets can be held together.</source>
        <translation>所有目标可同时保持。</translation>
    </message>
    <message>
        <source>Best compromise, at %1: %2.</source>
        <translation>最佳折中，在 %1 处：%2。</translation>
    </message>
    <message>
        <source>Cannot be held: %1.</source>
        <translation>无法保持：%1。</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>保留</translation>
    </message>
    <message>
        <source>Keep the target of %1</source>
        <translation>保留 %1 的目标</translation>
    </message>
    <message>
        <source>Leave this target as it is when the nearest ones are sought.</source>
        <translation>寻找最近目标时，保持此目标不变。</translation>
    </message>
    <message>
        <source>Nearest targets that can be held: %1.</source>
        <translation>可保持的最近目标：%1。</translation>
    </message>
    <message>
        <source>The target can be held.</source>
        <translation>目标可保持。</translation>
    </message>
    <message>
        <source>Those to be kept cannot be held together.</source>
        <translation>要保留的目标不能同时保持。</translation>
    </message>
    <message>
        <source>Use nearest feasible</source>
        <translation>采用最近的可行目标</translation>
    </message>
    <message>
        <source>Surfaces</source>
        <translation>等值面</translation>
    </message>
    <message>
        <source>Pairs</source>
        <translation>物体对</translation>
    </message>
    <message>
        <source>Predicting how long a run takes…</source>
        <translation>正在预测运行所需的时间…</translation>
    </message>
    <message>
        <source>Reachable alone</source>
        <translation>可单独达到</translation>
    </message>
    <message>
        <source>The targets to be kept cannot be held together: untick “Keep” for one.</source>
        <translation>要保留的目标不能同时保持：请取消勾选其中一个的“保留”。</translation>
    </message>
    <message>
        <source>A run with a target out of reach needs your explicit agreement at Start. It holds the best compromise it finds, says so, and the session records that you agreed. During a run new targets are taken at once; if they cannot be held, an event says why.</source>
        <translation>若运行中有目标无法达到，需要您在开始时明确同意。运行将保持所找到的最佳折中并予以说明，会话中也会记录您已同意。运行期间，新目标立即生效；若无法保持，会有事件说明原因。</translation>
    </message>
    <message>
        <source>No object shades another at this pose.</source>
        <translation>在该位姿时物体之间没有遮挡。</translation>
    </message>
    <message>
        <source>Held at %1; %2 from the nearest limit: %3.</source>
        <translation>在 %1 处保持；距最近的限值 %2：%3。</translation>
    </message>
    <message>
        <source>Predicted: a run from the start pose does not settle within %1 (simulated).</source>
        <translation>预测：从起始位姿开始的运行在 %1 内不能稳定（仿真）。</translation>
    </message>
    <message>
        <source>Predicted: a run from the start pose has settled after %1 (simulated).</source>
        <translation>预测：从起始位姿开始的运行在 %1 后稳定（仿真）。</translation>
    </message>
</context>
<context>
    <name>bask::ThermalCameraForm</name>
    <message>
        <source>Take a profile from a file</source>
        <translation>从文件读取配置</translation>
    </message>
    <message>
        <source>Profiles (*.json)</source>
        <translation>配置文件 (*.json)</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>相机</translation>
    </message>
    <message>
        <source>Kind of thermal camera</source>
        <translation>热像仪的型号</translation>
    </message>
    <message>
        <source>From file…</source>
        <translation>从文件…</translation>
    </message>
    <message>
        <source>Take what the camera&apos;s numbers mean from a file</source>
        <translation>从文件取得相机数值的含义</translation>
    </message>
    <message>
        <source>Its pose in the robot&apos;s base is known</source>
        <translation>其在机器人基座中的位姿已知</translation>
    </message>
    <message>
        <source>The camera&apos;s axes: x right, y down, z along its view. Without its pose it shows pictures and reads no object.</source>
        <translation>相机的轴：x 向右，y 向下，z 沿视线方向。没有位姿时它只显示图像，不读取任何物体。</translation>
    </message>
    <message>
        <source>Pose of the camera, %1</source>
        <translation>相机的位姿，%1</translation>
    </message>
</context>
<context>
    <name>bask::ThermalCanvas</name>
    <message>
        <source>no value</source>
        <translation>无数值</translation>
    </message>
    <message>
        <source>saturated</source>
        <translation>饱和</translation>
    </message>
    <message>
        <source>below range</source>
        <translation>低于量程</translation>
    </message>
    <message>
        <source>%1 at column %2, row %3</source>
        <translation>%1（第 %2 列，第 %3 行）</translation>
    </message>
    <message>
        <source>saturated %1</source>
        <comment>a number of pixels</comment>
        <translation>饱和 %1</translation>
    </message>
    <message>
        <source>below range %1</source>
        <comment>a number of pixels</comment>
        <translation>低于量程 %1</translation>
    </message>
    <message>
        <source>no value %1</source>
        <comment>a number of pixels</comment>
        <translation>无数值 %1</translation>
    </message>
    <message>
        <source>Thermal picture</source>
        <translation>热像图</translation>
    </message>
    <message>
        <source>Arrow keys place a spot, which tells a pixel&apos;s temperature; Escape removes it.</source>
        <translation>方向键可放置测温点，显示一个像素的温度；Esc 键将其移除。</translation>
    </message>
    <message>
        <source>Apparent temperature: that of a black body which looks the same. The objects&apos; temperatures have reflections and emittance taken into account.</source>
        <translation>表观温度：看起来相同的黑体的温度。物体的温度已计入反射和发射率。</translation>
    </message>
</context>
<context>
    <name>bask::ThermalControls</name>
    <message>
        <source>Inferno</source>
        <translation>Inferno</translation>
    </message>
    <message>
        <source>Grey</source>
        <translation>灰度</translation>
    </message>
    <message>
        <source>Colours of the thermal picture</source>
        <translation>热像图的颜色</translation>
    </message>
    <message>
        <source>Limits: objects</source>
        <translation>界限：物体</translation>
    </message>
    <message>
        <source>Limits: picture</source>
        <translation>界限：图像</translation>
    </message>
    <message>
        <source>Limits: fixed</source>
        <translation>界限：固定</translation>
    </message>
    <message>
        <source>Limits of the colours</source>
        <translation>颜色的界限</translation>
    </message>
    <message>
        <source>What the colours span: the objects&apos; pixels with a margin, all pixels but the 0.5 % at either end, or limits of your own.</source>
        <translation>颜色覆盖的范围：物体的像素并留余量、除两端各 0.5 % 外的所有像素，或自定的界限。</translation>
    </message>
    <message>
        <source>Lower limit of the colours</source>
        <translation>颜色的下限</translation>
    </message>
    <message>
        <source>Upper limit of the colours</source>
        <translation>颜色的上限</translation>
    </message>
    <message>
        <source>No isotherm</source>
        <translation>无等温线</translation>
    </message>
    <message>
        <source>Isotherm: above</source>
        <translation>等温线：以上</translation>
    </message>
    <message>
        <source>Isotherm: near</source>
        <translation>等温线：附近</translation>
    </message>
    <message>
        <source>Isotherm</source>
        <translation>等温线</translation>
    </message>
    <message>
        <source>Draws the pixels in green that are above a temperature, or nearer to it than 0.5 K.</source>
        <translation>将高于某温度或与其相差不到 0.5 K 的像素画成绿色。</translation>
    </message>
    <message>
        <source>Temperature of the isotherm</source>
        <translation>等温线的温度</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>放大</translation>
    </message>
    <message>
        <source>Show the objects with a margin instead of the whole picture.</source>
        <translation>只显示物体及其周围，而不是整幅图像。</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>平滑</translation>
    </message>
    <message>
        <source>Smooth the picture; else each pixel is a square of one colour.</source>
        <translation>平滑图像；否则每个像素为一个单色方块。</translation>
    </message>
</context>
<context>
    <name>bask::ThermalHistogramPlot</name>
    <message numerus="yes">
        <source>%1: %n pixel(s)</source>
        <translation>
            <numerusform>%1：%n 个像素</numerusform>
        </translation>
    </message>
    <message>
        <source>No pixels are read</source>
        <translation>没有读取的像素</translation>
    </message>
    <message>
        <source>mean %1, s.d. %2</source>
        <comment>standard deviation</comment>
        <translation>平均 %1，标准差 %2</translation>
    </message>
    <message>
        <source>Distribution of apparent temperatures</source>
        <translation>表观温度的分布</translation>
    </message>
    <message>
        <source>mean %1</source>
        <translation>平均 %1</translation>
    </message>
</context>
<context>
    <name>bask::ThermalObjectList</name>
    <message>
        <source>Temperatures by the thermal camera</source>
        <translation>热像仪测得的温度</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>物体</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>温度</translation>
    </message>
    <message>
        <source>Spread</source>
        <translation>温差</translation>
    </message>
    <message>
        <source>Reflections and emittance are taken into account; with two standard deviations.</source>
        <translation>已计入反射和发射率；附两倍标准差。</translation>
    </message>
    <message>
        <source>Largest difference across the object.</source>
        <translation>物体上的最大温差。</translation>
    </message>
    <message>
        <source>Whole picture</source>
        <translation>整幅图像</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 至 %2</translation>
    </message>
    <message>
        <source>Apparent temperatures of all but the 0.5 % at either end.</source>
        <translation>除两端各 0.5 % 外所有像素的表观温度。</translation>
    </message>
    <message>
        <source>%1 (part)</source>
        <translation>%1（部分）</translation>
    </message>
    <message>
        <source>A part of the object is outside of the picture: the reading is that of the rest.</source>
        <translation>物体有一部分在图像之外：读数是其余部分的。</translation>
    </message>
</context>
<context>
    <name>bask::ThermalPanel</name>
    <message>
        <source>Not measured</source>
        <translation>未测量</translation>
    </message>
    <message>
        <source>As typed</source>
        <translation>按输入值</translation>
    </message>
    <message>
        <source>In use</source>
        <translation>正在使用</translation>
    </message>
    <message>
        <source>The camera is at %1.</source>
        <translation>相机位于 %1。</translation>
    </message>
    <message>
        <source>The camera is at %1, measured %2.</source>
        <translation>相机位于 %1，测量于：%2。</translation>
    </message>
    <message>
        <source>That is %1 and %2 from where the experiment has it.</source>
        <translation>与实验中的位置相差 %1 和 %2。</translation>
    </message>
    <message>
        <source>Of the outlines %1 % were found, %2 px from where they should be.</source>
        <translation>找到了 %1 % 的轮廓，与应在的位置相差 %2 px。</translation>
    </message>
    <message>
        <source>Say on the Rig page where the thermal camera is, to 5 cm and 5 degrees.</source>
        <translation>请在“装置”页说明热像仪的位置，精确到 5 cm 和 5 度。</translation>
    </message>
    <message>
        <source>No picture from the thermal camera.</source>
        <translation>没有来自热像仪的图像。</translation>
    </message>
    <message>
        <source>A run is armed or on, or a stop is not reset. Measure after that.</source>
        <translation>已待命、正在运行，或停止尚未复位。请在此之后测量。</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Where the thermal camera is</source>
        <translation>热像仪的位置</translation>
    </message>
    <message>
        <source>By the outlines of the objects at several poses of the robot. The camera has to see them, and they have to be 5 K or more warmer or colder than what is behind them.</source>
        <translation>根据机器人在多个位姿下各物体的轮廓求出。相机须能看到物体，且物体须比其背后之物热或冷 5 K 以上。</translation>
    </message>
    <message>
        <source>&amp;Several poses</source>
        <translation>多个位姿(&amp;S)</translation>
    </message>
    <message>
        <source>The robot moves to some poses within its workspace, never nearer to the source, and back. Stand clear.</source>
        <translation>机器人将运动到其工作空间内的若干位姿，绝不更靠近热源，然后返回。请保持距离。</translation>
    </message>
    <message>
        <source>Use this p&amp;lace</source>
        <translation>使用此位置(&amp;L)</translation>
    </message>
    <message>
        <source>As simulated</source>
        <translation>按仿真</translation>
    </message>
    <message>
        <source>A calibration board is looked for. Stop looking first.</source>
        <translation>正在寻找标定板。请先停止寻找。</translation>
    </message>
    <message>
        <source>Measured by an earlier version: measure it again</source>
        <translation>由早期版本测量：请重新测量</translation>
    </message>
</context>
<context>
    <name>bask::ThermalPictureView</name>
    <message>
        <source>The thermal camera has not given a picture yet.</source>
        <translation>热像仪尚未给出图像。</translation>
    </message>
    <message>
        <source>This picture is %1.</source>
        <translation>此图像为 %1的。</translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>%1 pictures/s</source>
        <translation>%1 帧/s</translation>
    </message>
    <message>
        <source>shutter %1 ago, drift ± %2</source>
        <translation>快门 %1 前，漂移 ± %2</translation>
    </message>
    <message>
        <source>age %1 s</source>
        <translation>时龄 %1 s</translation>
    </message>
    <message>
        <source>No picture was recorded.</source>
        <translation>没有录制图像。</translation>
    </message>
    <message>
        <source>taken at %1</source>
        <translation>拍摄于 %1</translation>
    </message>
    <message numerus="yes">
        <source>%n picture(s) left out</source>
        <translation>
            <numerusform>略过 %n 幅图像</numerusform>
        </translation>
    </message>
    <message>
        <source>Left out last: %1</source>
        <translation>最近略过的：%1</translation>
    </message>
</context>
<context>
    <name>bask::TracePlot</name>
    <message>
        <source>translation</source>
        <translation>平移</translation>
    </message>
    <message>
        <source>rotation</source>
        <translation>转动</translation>
    </message>
    <message>
        <source>%1 cm/s</source>
        <translation>%1 cm/s</translation>
    </message>
    <message>
        <source>%1 °/s</source>
        <translation>%1 °/s</translation>
    </message>
    <message>
        <source>Time since start (h:min:s)</source>
        <translation>自开始以来的时间（时:分:秒）</translation>
    </message>
    <message>
        <source>Time since start (min:s)</source>
        <translation>自开始以来的时间（分:秒）</translation>
    </message>
    <message>
        <source>Speed (% of limit)</source>
        <translation>速度（占限值的 %）</translation>
    </message>
    <message>
        <source>Plot against time: %1</source>
        <translation>随时间变化的曲线图：%1</translation>
    </message>
    <message>
        <source>Arrow keys move, plus and minus zoom, Home shows the whole run, End goes back to live.</source>
        <translation>方向键平移，加号和减号缩放，Home 显示整个运行，End 返回实时。</translation>
    </message>
    <message>
        <source>No samples yet. Traces begin with Start.</source>
        <translation>尚无采样。曲线从“开始”时起绘制。</translation>
    </message>
    <message>
        <source>This controller does not estimate λ₁.</source>
        <translation>此控制器不估计 λ₁。</translation>
    </message>
    <message>
        <source>Nothing has shaded an object.</source>
        <translation>没有物体被遮挡。</translation>
    </message>
    <message>
        <source>Time since Start (h)</source>
        <translation>自开始以来的时间（h）</translation>
    </message>
    <message>
        <source>Time since Start (min)</source>
        <translation>自开始以来的时间（min）</translation>
    </message>
    <message>
        <source>Time since Start (s)</source>
        <translation>自开始以来的时间（s）</translation>
    </message>
    <message>
        <source>Command speed</source>
        <translation>速度指令</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <comment>quantity and unit</comment>
        <translation>%1（%2）</translation>
    </message>
    <message>
        <source>Dotted: predicted. Traces begin with Start.</source>
        <translation>点线：预测。曲线从“开始”时起绘制。</translation>
    </message>
    <message>
        <source>predicted</source>
        <translation>预测</translation>
    </message>
    <message>
        <source>predicted, not settled by then</source>
        <translation>预测，届时未稳定</translation>
    </message>
    <message>
        <source>predicted, not computed further</source>
        <translation>预测，未继续计算</translation>
    </message>
    <message>
        <source>predicted to end in a fault</source>
        <translation>预测以故障结束</translation>
    </message>
    <message>
        <source>target</source>
        <translation>目标</translation>
    </message>
    <message>
        <source>band of ±%1</source>
        <comment>%1 is 0.5 K</comment>
        <translation>±%1 的容差带</translation>
    </message>
    <message numerus="yes">
        <source>%n more without a number</source>
        <comment>moments that are close to another one</comment>
        <translation>
            <numerusform>另有 %n 个未编号</numerusform>
        </translation>
    </message>
    <message>
        <source>predicted; band: other sensor noise only</source>
        <translation>预测；色带：仅传感器噪声不同</translation>
    </message>
</context>
<context>
    <name>bask::TrafficModel</name>
    <message>
        <source>sent</source>
        <translation>发送</translation>
    </message>
    <message>
        <source>sent by hand</source>
        <translation>手动发送</translation>
    </message>
    <message>
        <source>received</source>
        <translation>接收</translation>
    </message>
    <message>
        <source>error output</source>
        <translation>错误输出</translation>
    </message>
    <message>
        <source>opened</source>
        <translation>打开</translation>
    </message>
    <message>
        <source>closed</source>
        <translation>关闭</translation>
    </message>
    <message numerus="yes">
        <source>%1… (%n bytes)</source>
        <translation>
            <numerusform>%1…（%n 字节）</numerusform>
        </translation>
    </message>
    <message>
        <source>Time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>链路</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>Bytes</source>
        <translation>字节</translation>
    </message>
</context>
<context>
    <name>bask::TransportBar</name>
    <message>
        <source>Pause</source>
        <translation>暂停</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>播放</translation>
    </message>
    <message>
        <source>Position and length of the run</source>
        <translation>运行的位置与时长</translation>
    </message>
    <message>
        <source>Position in the run</source>
        <translation>运行中的位置</translation>
    </message>
    <message>
        <source>REPLAY</source>
        <translation>回放</translation>
    </message>
    <message>
        <source>Space, while nothing else on the page takes it</source>
        <translation>空格键（页面上没有其他控件占用时）</translation>
    </message>
    <message>
        <source>Speed of the replay</source>
        <translation>回放速度</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>What is shown here was recorded: nothing moves or heats by it.</source>
        <translation>这里显示的是记录内容：不会使任何东西移动或加热。</translation>
    </message>
</context>
<context>
    <name>bask::UndoActions</name>
    <message>
        <source>%1: %2</source>
        <extracomment>%1 is &quot;Undo&quot; or &quot;Redo&quot;, %2 what: &quot;Undo: move of bunny&quot;</extracomment>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>重做(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>撤销(&amp;U)</translation>
    </message>
    <message>
        <source>A run is armed or on. This can be changed once it has stopped.</source>
        <translation>已待命或正在运行。停止后即可更改此项。</translation>
    </message>
    <message>
        <source>Nothing to redo</source>
        <translation>没有可重做的操作</translation>
    </message>
    <message>
        <source>Nothing to undo</source>
        <translation>没有可撤销的操作</translation>
    </message>
    <message>
        <source>Raise a limit of the real rig</source>
        <translation>提高实际装置的限值</translation>
    </message>
    <message>
        <source>Raise the limit</source>
        <translation>提高限值</translation>
    </message>
    <message>
        <source>This allows the rig more than now. Do robot, source, objects and sensors bear it?</source>
        <translation>这将允许装置超出现在的范围。机器人、热源、物体和传感器能承受吗？</translation>
    </message>
</context>
<context>
    <name>bask::UnitFinder</name>
    <message>
        <source>Unit %1: %2 (%3)</source>
        <translation>单元 %1：%2（%3）</translation>
    </message>
    <message>
        <source>Unit %1 answers, but no profile of this role fits</source>
        <translation>单元 %1 有应答，但没有适合此角色的配置文件</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Find devices</source>
        <translation>查找设备</translation>
    </message>
    <message>
        <source>Asks units 1 to 16 at this port. Nothing is written.</source>
        <translation>在此端口询问单元 1 到 16。不写入任何内容。</translation>
    </message>
    <message>
        <source>%1 %, unit %2, %3</source>
        <translation>%1 %，单元 %2，%3</translation>
    </message>
    <message>
        <source>No unit from 1 to 16 answers.</source>
        <translation>单元 1 到 16 均无应答。</translation>
    </message>
    <message>
        <source>Choose one:</source>
        <translation>请选择一项：</translation>
    </message>
    <message>
        <source>Devices found at this port</source>
        <translation>在此端口找到的设备</translation>
    </message>
</context>
<context>
    <name>bask::VerdictBox</name>
    <message>
        <source>%1, in use</source>
        <translation>%1，正在使用</translation>
    </message>
</context>
<context>
    <name>bask::VerdictText</name>
    <message>
        <source>Too hot</source>
        <translation>太热</translation>
    </message>
    <message>
        <source>Too cold</source>
        <translation>太冷</translation>
    </message>
    <message>
        <source>Reachable</source>
        <translation>可达</translation>
    </message>
    <message>
        <source>needs F = %1, at most %2 here; at most %3</source>
        <translation>需要 F = %1，此处最多 %2；最多 %3</translation>
    </message>
    <message>
        <source>below the room&apos;s %1</source>
        <translation>低于室温 %1</translation>
    </message>
    <message>
        <source>below the %1 it settles at far from the source</source>
        <translation>低于其远离热源时稳定的 %1</translation>
    </message>
    <message>
        <source>needs F = %1, at least %2 here; at least %3</source>
        <translation>需要 F = %1，此处至少 %2；至少 %3</translation>
    </message>
    <message>
        <source>needs F = %1, up to %2 here</source>
        <translation>需要 F = %1，此处可达 %2</translation>
    </message>
    <message>
        <source>clearance</source>
        <translation>间距</translation>
    </message>
    <message>
        <source>workspace %1</source>
        <translation>工作空间 %1</translation>
    </message>
</context>
<context>
    <name>bask::Verification</name>
    <message>
        <source>table %1</source>
        <translation>表 %1</translation>
    </message>
    <message>
        <source>row %1</source>
        <translation>第 %1 行</translation>
    </message>
    <message>
        <source>at %1</source>
        <comment>a time since Start</comment>
        <translation>在 %1</translation>
    </message>
    <message>
        <source>Altered: in tags, or in bytes of the file that are in no row. An older Bask that changed the tags does that, too.</source>
        <translation>已改动：在标签中，或在文件中不属于任何行的字节中。较旧的 Bask 更改标签时也会如此。</translation>
    </message>
    <message>
        <source>Altered: %1; see bask verify</source>
        <translation>已改动：%1；详见 bask verify</translation>
    </message>
    <message>
        <source>Altered: %1, and %2 more; see bask verify</source>
        <translation>已改动：%1，另有 %2 处；详见 bask verify</translation>
    </message>
    <message>
        <source>Damaged: bask verify tells what of it can be read</source>
        <translation>已损坏：bask verify 说明其中可以读取的内容</translation>
    </message>
    <message>
        <source>Not verifiable: recorded by an older Bask, without a hash chain</source>
        <translation>无法验证：由较旧的 Bask 记录，没有哈希链</translation>
    </message>
    <message>
        <source>Intact: %1 rows, sealed, head %2</source>
        <translation>完好：%1 行，已封存，链头 %2</translation>
    </message>
    <message>
        <source>Intact: %1 rows, not sealed, head %2</source>
        <translation>完好：%1 行，未封存，链头 %2</translation>
    </message>
    <message>
        <source>key %1</source>
        <translation>键 %1</translation>
    </message>
    <message>
        <source>view %1</source>
        <translation>视图 %1</translation>
    </message>
    <message>
        <source>index %1</source>
        <comment>of a database</comment>
        <translation>索引 %1</translation>
    </message>
    <message>
        <source>trigger %1</source>
        <comment>of a database</comment>
        <translation>触发器 %1</translation>
    </message>
    <message>
        <source>the file&apos;s header</source>
        <translation>文件头</translation>
    </message>
    <message>
        <source>after %1</source>
        <comment>a time since Start</comment>
        <translation>在 %1 之后</translation>
    </message>
    <message>
        <source>Altered: its seal was removed. Tags, and bytes of the file that are in no row, may have been changed.</source>
        <translation>已改动：封印已被移除。标签以及文件中不属于任何行的字节可能已被更改。</translation>
    </message>
</context>
<context>
    <name>bask::ViewBar</name>
    <message>
        <source>Top</source>
        <translation>俯视</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>侧视</translation>
    </message>
    <message>
        <source>Isometric</source>
        <translation>等轴测</translation>
    </message>
    <message>
        <source>View: %1</source>
        <translation>视角：%1</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>导出</translation>
    </message>
    <message>
        <source>&amp;Picture…</source>
        <translation>图片(&amp;P)…</translation>
    </message>
    <message>
        <source>&amp;Animation…</source>
        <translation>动画(&amp;A)…</translation>
    </message>
</context>
<context>
    <name>bask::ViewList</name>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>%1, stands out</source>
        <translation>%1，离群</translation>
    </message>
    <message>
        <source>A view that is not ticked is left out.</source>
        <translation>未勾选的视图不参与标定。</translation>
    </message>
    <message>
        <source>Residual</source>
        <translation>残差</translation>
    </message>
    <message>
        <source>View</source>
        <translation>视图</translation>
    </message>
    <message>
        <source>Views of the calibration</source>
        <translation>标定视图</translation>
    </message>
</context>
<context>
    <name>bask::WholeNumberField</name>
    <message>
        <source>“%1” is not a whole number; the value stays as it was</source>
        <translation>“%1”不是整数；数值保持不变</translation>
    </message>
</context>
<context>
    <name>bask::WhyNot</name>
    <message>
        <source>Arm is not possible: no experiment is loaded. Open one first.</source>
        <translation>无法待命：尚未载入实验。请先打开一个。</translation>
    </message>
    <message>
        <source>The rig is armed already. Press Start.</source>
        <translation>装置已在待命。请按“开始”。</translation>
    </message>
    <message>
        <source>Arm is not possible: a stop or a fault is latched. Remove its cause, then press Reset.</source>
        <translation>无法待命：有停止或故障被锁存。请排除其原因，然后按“复位”。</translation>
    </message>
    <message>
        <source>Arm is not possible yet: the run is stopping.</source>
        <translation>尚无法待命：运行正在停止。</translation>
    </message>
    <message>
        <source>Arm is not possible: the rig is not ready.</source>
        <translation>无法待命：装置未就绪。</translation>
    </message>
    <message>
        <source>Arm is not possible: a run is on. Stop it first.</source>
        <translation>无法待命：正在运行。请先停止。</translation>
    </message>
    <message>
        <source>Start is not possible: a stop or a fault is latched. Press Reset, then Arm.</source>
        <translation>无法开始：有停止或故障被锁存。请按“复位”，再按“待命”。</translation>
    </message>
    <message>
        <source>Start is not possible: a run is on.</source>
        <translation>无法开始：正在运行。</translation>
    </message>
    <message>
        <source>Start is not possible: the rig is not armed. Press Arm first.</source>
        <translation>无法开始：装置未待命。请先按“待命”。</translation>
    </message>
    <message>
        <source>The run is held already. Resume goes on, Stop ends it.</source>
        <translation>运行已在保持。“继续”恢复运行，“停止”结束运行。</translation>
    </message>
    <message>
        <source>Hold is not possible: the run is stopping. STOP ends all motion.</source>
        <translation>无法保持：运行正在停止。“软件停止”终止一切运动。</translation>
    </message>
    <message>
        <source>There is nothing to hold: the robot does not move.</source>
        <translation>没有可保持的：机器人没有运动。</translation>
    </message>
    <message>
        <source>The run is stopping already.</source>
        <translation>运行已在停止。</translation>
    </message>
    <message>
        <source>There is no run to stop: a stop or a fault has ended it.</source>
        <translation>没有可停止的运行：停止或故障已将其结束。</translation>
    </message>
    <message>
        <source>There is no run to stop.</source>
        <translation>没有可停止的运行。</translation>
    </message>
    <message>
        <source>The robot is retreating already.</source>
        <translation>机器人已在撤离。</translation>
    </message>
    <message>
        <source>Retreat is not possible: the robot does not answer. Take the objects away by hand, mind the heat.</source>
        <translation>无法撤离：机器人没有应答。请手动移开物体，小心烫伤。</translation>
    </message>
    <message>
        <source>Retreat is not possible:</source>
        <translation>无法撤离：</translation>
    </message>
    <message>
        <source>Retreat is not possible: the robot is not sure of its place. Look where it is, then home it or clear its alarm on the Rig page.</source>
        <translation>无法撤离：机器人的位置不确定。请查看其位置，然后在“装置”页面使其回零或清除其报警。</translation>
    </message>
    <message>
        <source>Retreat is not possible now: there is no robot that can move, or the objects are away already.</source>
        <translation>现在无法撤离：没有可运动的机器人，或物体已经移开。</translation>
    </message>
    <message>
        <source>There is nothing to resume: no run is held.</source>
        <translation>没有可继续的：没有保持中的运行。</translation>
    </message>
    <message>
        <source>There is nothing to reset: no stop and no fault is latched.</source>
        <translation>没有可复位的：没有锁存的停止或故障。</translation>
    </message>
    <message>
        <source>A run is armed or on. Stop it first; then another experiment can be begun.</source>
        <translation>已待命或正在运行。请先停止，然后才能开始另一个实验。</translation>
    </message>
    <message>
        <source>There is no recording to end.</source>
        <translation>没有可结束的记录。</translation>
    </message>
    <message>
        <source>The recording is that of the run, which is armed or on. It ends with the run.</source>
        <translation>该记录属于已待命或正在进行的运行，随运行一起结束。</translation>
    </message>
    <message>
        <source>There is no alarm to acknowledge.</source>
        <translation>没有需要确认的报警。</translation>
    </message>
    <message>
        <source>All alarms are acknowledged already.</source>
        <translation>所有报警均已确认。</translation>
    </message>
    <message>
        <source>There is no recording to save yet. Arm begins one.</source>
        <translation>还没有可保存的记录。“待命”会开始一个记录。</translation>
    </message>
    <message>
        <source>This run has no prediction: it was not finished at Start.</source>
        <translation>此次运行没有预测：开始时预测尚未完成。</translation>
    </message>
    <message>
        <source>This run has no prediction: the robot&apos;s place or a reading was not known before Start.</source>
        <translation>此次运行没有预测：开始前机器人的位置或某个读数未知。</translation>
    </message>
    <message>
        <source>This run has no prediction: it could not be computed.</source>
        <translation>此次运行没有预测：无法计算。</translation>
    </message>
    <message>
        <source>Reset waits for the source to cool by %1: it does not cool yet. Switch it off at its mains.</source>
        <translation>复位在等待热源降温 %1：它尚未降温。请切断其电源。</translation>
    </message>
    <message>
        <source>The source cools: Reset is possible when it has fallen by %1; now %2.</source>
        <translation>热源正在降温：降低 %1 后方可复位；目前为 %2。</translation>
    </message>
    <message>
        <source>Home the robot: here, or on the page Rig, By hand, where its place can be confirmed instead.</source>
        <translation>请使机器人回零：在此处，或在“装置”页的“手动”中，那里也可改为确认其位置。</translation>
    </message>
    <message>
        <source>Then Reset, then Arm.</source>
        <translation>然后复位，再待命。</translation>
    </message>
    <message>
        <source>Home is not possible: no experiment is loaded.</source>
        <translation>无法回零：未载入实验。</translation>
    </message>
    <message>
        <source>Home is not possible: a run is armed or on. Stop it first.</source>
        <translation>无法回零：有运行处于待命或进行中。请先停止它。</translation>
    </message>
    <message>
        <source>Home is not possible: the robot does not answer.</source>
        <translation>无法回零：机器人没有应答。</translation>
    </message>
    <message>
        <source>This run has no prediction: it is computed while the Run page is shown, and was not ready at Start.</source>
        <translation>此次运行没有预测：预测在显示“运行”页时计算，开始时尚未完成。</translation>
    </message>
    <message>
        <source>Reset is possible when the robot has come to rest.</source>
        <translation>机器人静止后才能复位。</translation>
    </message>
</context>
<context>
    <name>bask::ZeroPanel</name>
    <message>
        <source>Offsets: %1.</source>
        <translation>零点偏移：%1。</translation>
    </message>
    <message>
        <source>That of %1 is large: check the sensor and its wiring.</source>
        <translation>%1 的零点偏移较大：请检查传感器及其接线。</translation>
    </message>
    <message>
        <source>Not while the heat is on.</source>
        <translation>加热打开时不可进行。</translation>
    </message>
    <message>
        <source>Zeroed on %1 with the room at %2.</source>
        <translation>已于 %1 校零，当时室温 %2。</translation>
    </message>
    <message>
        <source>Not zeroed yet: Arm does it, if all objects are at the room&apos;s temperature then.</source>
        <translation>尚未校零：若届时所有物体都处于室温，进入待命时会自动校零。</translation>
    </message>
    <message>
        <source>Sensors at rest</source>
        <translation>静止的传感器</translation>
    </message>
    <message>
        <source>Zero the sensors</source>
        <translation>将传感器校零</translation>
    </message>
    <message>
        <source>Make all sensors agree while the objects are at the room&apos;s temperature</source>
        <translation>在物体处于室温时，使所有传感器读数一致</translation>
    </message>
</context>
</TS>
