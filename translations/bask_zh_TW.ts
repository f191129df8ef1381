<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_TW" sourcelanguage="en">
<context>
    <name>About</name>
    <message>
        <source>About Bask</source>
        <translation>關於 Bask</translation>
    </message>
    <message>
        <source>Radiation-based thermal servoing: a robot brings objects to their temperatures by holding them in front of a heat source.</source>
        <translation>基於輻射的熱伺服：機器人將物體置於熱源前，使其達到各自的溫度。</translation>
    </message>
    <message>
        <source>Qt %1 on %2. Licence: GPL-3.0-or-later.</source>
        <translation>Qt %1，%2。授權條款：GPL-3.0-or-later。</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>關閉</translation>
    </message>
</context>
<context>
    <name>CloseQuestion</name>
    <message>
        <source>&quot;Stop, then close&quot; switches the heat off, takes the objects away from the source, and closes when they are there. &quot;Close now&quot; switches the heat off and leaves the objects where they are, perhaps close to a hot source. What is recorded stays.</source>
        <translation>「停止後關閉」會關閉加熱，使物體離開熱源，到位後再關閉程式。「立即關閉」會關閉加熱，並使物體停在原處，可能就在灼熱的熱源附近。已記錄的內容會保留。</translation>
    </message>
    <message>
        <source>A recipe is on, with nothing heated or moved just now.</source>
        <translation>配方正在進行，此刻沒有加熱或移動。</translation>
    </message>
    <message>
        <source>The recipe ends, and its other steps are not run.</source>
        <translation>配方隨之結束，其餘步驟不再執行。</translation>
    </message>
    <message>
        <source>A run is on</source>
        <translation>運轉正在進行</translation>
    </message>
    <message>
        <source>A recipe is on</source>
        <translation>配方正在進行</translation>
    </message>
    <message>
        <source>Stop, then close</source>
        <translation>停止後關閉</translation>
    </message>
    <message>
        <source>Close now</source>
        <translation>立即關閉</translation>
    </message>
    <message>
        <source>End the recipe and close</source>
        <translation>結束配方並關閉</translation>
    </message>
    <message>
        <source>Stay</source>
        <translation>留下</translation>
    </message>
    <message>
        <source>The heat is not known to be off</source>
        <translation>加熱不能確定已關閉</translation>
    </message>
    <message>
        <source>The heat source was told to switch off and has not said that it is off. Look at the plate, and switch it off at its mains.</source>
        <translation>已命令熱源關閉，但它沒有回報已關閉。請查看熱板，並切斷其電源。</translation>
    </message>
    <message>
        <source>A guard process goes on switching off a heater on a serial port after Bask has closed. The alarm is there again at the next start.</source>
        <translation>Bask 關閉後，守護行程會繼續關閉串列埠上的熱源。下次啟動時該警報會再次出現。</translation>
    </message>
    <message>
        <source>An export is being written</source>
        <translation>正在寫出匯出內容</translation>
    </message>
    <message>
        <source>Bask is still writing what is named below. If it closes now, some of it may be missing; no file is left half written.</source>
        <translation>Bask 仍在寫出下列內容。現在關閉，其中一部分可能會缺失；不會留下只寫了一半的檔案。</translation>
    </message>
    <message>
        <source>Close anyway</source>
        <translation>仍要關閉</translation>
    </message>
    <message>
        <source>The recording is on</source>
        <translation>正在記錄</translation>
    </message>
    <message>
        <source>If Bask is closed now, the recording ends. What is recorded stays.</source>
        <translation>現在關閉 Bask，記錄即結束。已記錄的內容會保留。</translation>
    </message>
</context>
<context>
    <name>Column</name>
    <message>
        <source>Temperature</source>
        <translation>溫度</translation>
    </message>
    <message>
        <source>Temperatures</source>
        <translation>溫度</translation>
    </message>
    <message>
        <source>Measured temperatures. Dashed: targets; grey: the band of %1 about them. Gaps: no valid reading. The numbers at dotted lines are those of the table of events.</source>
        <translation>測量溫度。虛線：目標；灰色：其周圍 %1 的容差帶。間斷處：沒有有效讀數。點線處的編號與事件表中的編號一致。</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>誤差</translation>
    </message>
    <message>
        <source>Errors</source>
        <translation>誤差</translation>
    </message>
    <message>
        <source>Measured temperature minus target, within %1; grey: the band.</source>
        <translation>測量溫度減目標，在 %1 以內；灰色：容差帶。</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>變化率</translation>
    </message>
    <message>
        <source>Rates</source>
        <translation>變化率</translation>
    </message>
    <message>
        <source>View factor</source>
        <translation>角係數</translation>
    </message>
    <message>
        <source>View factors</source>
        <translation>角係數</translation>
    </message>
    <message>
        <source>View factor of the source from each object.</source>
        <translation>各物體對熱源的角係數。</translation>
    </message>
    <message>
        <source>Shade</source>
        <translation>遮擋</translation>
    </message>
    <message>
        <source>Share of the source&apos;s light that other objects, fixtures and shields take from each object.</source>
        <translation>其他物體、夾具和遮板從各物體擋去的熱源光的份額。</translation>
    </message>
    <message>
        <source>Estimated λ₁</source>
        <translation>估計的 λ₁</translation>
    </message>
    <message>
        <source>Estimates</source>
        <translation>估計值</translation>
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
        <translation>運動到每個物體所需的角係數；途中學習熱速率。</translation>
    </message>
    <message>
        <source>Model-based</source>
        <translation>基於模型</translation>
    </message>
    <message>
        <source>Adaptive</source>
        <translation>自適應</translation>
    </message>
    <message>
        <source>The paper&apos;s law with adapted heat rates.</source>
        <translation>論文的控制律，熱速率自適應。</translation>
    </message>
    <message>
        <source>The paper&apos;s law with known heat rates: dv/dt = −D v − K Δτ.</source>
        <translation>論文的控制律，熱速率已知：dv/dt = −D v − K Δτ。</translation>
    </message>
</context>
<context>
    <name>Damage</name>
    <message>
        <source>it is cut short</source>
        <translation>檔案不完整</translation>
    </message>
    <message>
        <source>a sample is missing</source>
        <translation>缺少一個取樣</translation>
    </message>
    <message>
        <source>it does not say whether the rig was simulated</source>
        <translation>未說明實驗台是否為模擬</translation>
    </message>
    <message>
        <source>its database is not whole</source>
        <translation>其資料庫不完整</translation>
    </message>
    <message>
        <source>it has a format number that no version has</source>
        <translation>其格式編號不屬於任何版本</translation>
    </message>
    <message>
        <source>the header of its database was written over</source>
        <translation>其資料庫的檔案標頭已被覆寫</translation>
    </message>
</context>
<context>
    <name>Device</name>
    <message>
        <source>robot</source>
        <translation>機器人</translation>
    </message>
    <message>
        <source>thermometer</source>
        <translation>溫度計</translation>
    </message>
    <message>
        <source>heat source</source>
        <translation>熱源</translation>
    </message>
    <message>
        <source>heat source kept by hand</source>
        <translation>人工加熱的熱源</translation>
    </message>
    <message>
        <source>source temperature</source>
        <translation>熱源溫度</translation>
    </message>
    <message>
        <source>thermal camera</source>
        <translation>熱像儀</translation>
    </message>
</context>
<context>
    <name>Fault</name>
    <message>
        <source>Restore all devices</source>
        <translation>恢復所有裝置</translation>
    </message>
    <message>
        <source>Sensor lost</source>
        <translation>感測器失聯</translation>
    </message>
    <message>
        <source>Sensor open</source>
        <translation>感測器開路</translation>
    </message>
    <message>
        <source>Sensor shorted</source>
        <translation>感測器短路</translation>
    </message>
    <message>
        <source>Sensor frozen</source>
        <translation>感測器凍結</translation>
    </message>
    <message>
        <source>Sensor jumping</source>
        <translation>感測器跳變</translation>
    </message>
    <message>
        <source>Sensor off its object</source>
        <translation>感測器脫離物體</translation>
    </message>
    <message>
        <source>Object heated otherwise</source>
        <translation>物體被另外加熱</translation>
    </message>
    <message>
        <source>Robot lost</source>
        <translation>機器人失聯</translation>
    </message>
    <message>
        <source>Robot in alarm</source>
        <translation>機器人警報</translation>
    </message>
    <message>
        <source>Robot restarted</source>
        <translation>機器人已重啟</translation>
    </message>
    <message>
        <source>Robot slow</source>
        <translation>機器人緩慢</translation>
    </message>
    <message>
        <source>Heat source lost</source>
        <translation>熱源失聯</translation>
    </message>
    <message>
        <source>Heat source without temperature</source>
        <translation>熱源沒有溫度值</translation>
    </message>
    <message>
        <source>Heat source does not heat</source>
        <translation>熱源不加熱</translation>
    </message>
    <message>
        <source>Heat source heats unasked</source>
        <translation>熱源擅自加熱</translation>
    </message>
    <message>
        <source>Heat source overheats</source>
        <translation>熱源過熱</translation>
    </message>
    <message>
        <source>Heat source limited by itself</source>
        <translation>熱源自行限制</translation>
    </message>
    <message>
        <source>Heat source cannot be switched off</source>
        <translation>熱源無法關閉</translation>
    </message>
    <message>
        <source>Source hidden from the camera</source>
        <translation>相機看不到熱源</translation>
    </message>
    <message>
        <source>Camera lost</source>
        <translation>相機失聯</translation>
    </message>
    <message>
        <source>Sensors swapped with the next object</source>
        <translation>感測器與下一個物體的互換</translation>
    </message>
</context>
<context>
    <name>MaterialPreset</name>
    <message>
        <source>aluminium, painted black</source>
        <translation>鋁，塗黑漆</translation>
    </message>
    <message>
        <source>aluminium, anodised</source>
        <translation>鋁，陽極氧化</translation>
    </message>
    <message>
        <source>copper, polished</source>
        <translation>銅，拋光</translation>
    </message>
    <message>
        <source>steel, painted black</source>
        <translation>鋼，塗黑漆</translation>
    </message>
    <message>
        <source>stainless steel, polished</source>
        <translation>不鏽鋼，拋光</translation>
    </message>
    <message>
        <source>stainless steel, oxidised</source>
        <translation>不鏽鋼，氧化</translation>
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
        <translation>紙板</translation>
    </message>
    <message>
        <source>Hu et al., arXiv 2012.13147 (bulk), flat paint (surface)</source>
        <translation>Hu 等，arXiv 2012.13147（本體），消光漆（表面）</translation>
    </message>
    <message>
        <source>aluminium, painted</source>
        <translation>鋁，塗漆</translation>
    </message>
    <message>
        <source>aluminium, bare</source>
        <translation>鋁，裸面</translation>
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
        <translation>PLA，實心</translation>
    </message>
    <message>
        <source>ABS, solid</source>
        <translation>ABS，實心</translation>
    </message>
    <message>
        <source>copper, oxidised</source>
        <translation>銅，氧化</translation>
    </message>
    <message>
        <source>glass</source>
        <translation>玻璃</translation>
    </message>
    <message>
        <source>Incropera, table A.1 (bulk), FLIR tables: matte black lacquer (surface)</source>
        <translation>Incropera，表 A.1（本體），FLIR 資料表：消光黑漆（表面）</translation>
    </message>
    <message>
        <source>Incropera, table A.1 (bulk), Neutrium: anodised, 20 °C (surface)</source>
        <translation>Incropera，表 A.1（本體），Neutrium：陽極氧化，20 °C（表面）</translation>
    </message>
    <message>
        <source>Incropera, table A.1 (bulk), FLIR tables: sheet as received (surface)</source>
        <translation>Incropera，表 A.1（本體），FLIR 資料表：出廠板材（表面）</translation>
    </message>
    <message>
        <source>Hu et al., arXiv 2012.13147; FLIR tables: 0.04 to 0.06, polished</source>
        <translation>Hu 等，arXiv 2012.13147；FLIR 資料表：0.04 至 0.06，拋光</translation>
    </message>
    <message>
        <source>Incropera, table A.1 (bulk), FLIR tables (surface)</source>
        <translation>Incropera，表 A.1（本體），FLIR 資料表（表面）</translation>
    </message>
    <message>
        <source>AISI 1010, Matmake (bulk), FLIR tables: matte black lacquer (surface)</source>
        <translation>AISI 1010，Matmake（本體），FLIR 資料表：消光黑漆（表面）</translation>
    </message>
    <message>
        <source>EN 10088-1, 1.4301 (bulk), Trotec: 18-8, 25 °C (surface)</source>
        <translation>EN 10088-1，1.4301（本體），Trotec：18-8，25 °C（表面）</translation>
    </message>
    <message>
        <source>EN 10088-1, 1.4301 (bulk), Thome, EPFL: 0.5 to 0.7 after heating (surface)</source>
        <translation>EN 10088-1，1.4301（本體），Thome，EPFL：加熱後 0.5 至 0.7（表面）</translation>
    </message>
    <message>
        <source>FreeCAD card PLA-Generic (bulk), plastics: 0.85 to 0.95 (surface)</source>
        <translation>FreeCAD 材料卡 PLA-Generic（本體），塑膠：0.85 至 0.95（表面）</translation>
    </message>
    <message>
        <source>Kaiao, Granta Design (bulk), plastics: 0.85 to 0.95 (surface)</source>
        <translation>Kaiao，Granta Design（本體），塑膠：0.85 至 0.95（表面）</translation>
    </message>
    <message>
        <source>Pilkington ATS-129; specific heat: tables say 720 to 880 J/(kg·K)</source>
        <translation>Pilkington ATS-129；比熱：各資料表為 720 至 880 J/(kg·K)</translation>
    </message>
    <message>
        <source>Entegris, by FreeCAD&apos;s card (bulk), tables: 0.8 to 0.98 (surface)</source>
        <translation>Entegris，據 FreeCAD 材料卡（本體），資料表：0.8 至 0.98（表面）</translation>
    </message>
    <message>
        <source>Ashby: 480 to 860 kg/m³ (bulk), FLIR tables: paper (surface)</source>
        <translation>Ashby：480 至 860 kg/m³（本體），FLIR 資料表：紙（表面）</translation>
    </message>
    <message>
        <source>aluminium, polished</source>
        <translation>鋁，拋光</translation>
    </message>
    <message>
        <source>Standard uncertainty: %1</source>
        <translation>標準不確定度：%1</translation>
    </message>
</context>
<context>
    <name>Message</name>
    <message>
        <source>&quot;%1&quot; is not the finite number or numbers that it should be</source>
        <translation>「%1」不是此處所需的有限數值</translation>
    </message>
    <message>
        <source>Held for more than %1 s without a reading: the run is ended</source>
        <translation>無讀數保持超過 %1 s：運轉結束</translation>
    </message>
    <message>
        <source>a recipe needs at least one step that runs an experiment</source>
        <translation>配方至少需要一個執行實驗的步驟</translation>
    </message>
    <message>
        <source>not one of Bask&apos;s files, or a damaged one: it is no valid JSON (%1)</source>
        <translation>不是 Bask 的檔案，或檔案已損壞：不是有效的 JSON（%1）</translation>
    </message>
    <message>
        <source>simulated fault of &quot;%2&quot;: %1</source>
        <translation>「%2」的模擬故障：%1</translation>
    </message>
    <message>
        <source>simulated fault: %1</source>
        <translation>模擬故障：%1</translation>
    </message>
    <message>
        <source>the camera matrix cannot be used: nine numbers fx 0 cx, 0 fy cy, 0 0 1 with focal lengths above zero are needed</source>
        <translation>相機矩陣不可用：需要九個數 fx 0 cx, 0 fy cy, 0 0 1，且焦距大於零</translation>
    </message>
    <message>
        <source>a distortion of %1 coefficients cannot be used; 4, 5 or 8 can</source>
        <translation>含 %1 個係數的畸變不可用；可用 4、5 或 8 個</translation>
    </message>
    <message>
        <source>the camera was calibrated with pictures of %1 pixels, this one has %2; calibrate it at this size</source>
        <translation>相機是用 %1 像素的影像校正的，而此影像為 %2；請在此尺寸下校正</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not %2 digits 0 or 1</source>
        <translation>「%1」不是 %2 位的 0 或 1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no board; write chessboard:9x6:0.025 (inner corners, square in m) or charuco:5x7:0.04:0.02:6X6_250 (squares, square and marker in m, dictionary)</source>
        <translation>「%1」不是校正板；請寫成 chessboard:9x6:0.025（內角點數，方格邊長單位 m）或 charuco:5x7:0.04:0.02:6X6_250（方格數，方格與標記邊長單位 m，字典）</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no marker; write marker:6X6_250:23:0.05 (dictionary, id, side in m)</source>
        <translation>「%1」不是標記；請寫成 marker:6X6_250:23:0.05（字典，編號，邊長單位 m）</translation>
    </message>
    <message>
        <source>a marker of %1 m does not fit into a square of %2 m</source>
        <translation>%1 m 的標記放不進 %2 m 的方格</translation>
    </message>
    <message>
        <source>dictionary %1 has %2 markers; %3 are needed</source>
        <translation>字典 %1 有 %2 個標記；需要 %3 個</translation>
    </message>
    <message>
        <source>no chessboard of %1 inner corners is seen; it needs to be whole in the picture, flat, with a light margin</source>
        <translation>未見到內角點為 %1 的棋盤格；它須完整位於畫面中，保持平整，並留有淺色邊緣</translation>
    </message>
    <message>
        <source>only %1 corners of the board are seen; %2 that are not in one line are needed</source>
        <translation>只見到校正板的 %1 個角點；需要 %2 個不共線的角點</translation>
    </message>
    <message>
        <source>the pictures show the board %1, not %2; correct the setting</source>
        <translation>影像中的校正板是 %1，而不是 %2；請更正設定</translation>
    </message>
    <message>
        <source>the picture has %1 pixels, the others %2; take all with one camera at one size</source>
        <translation>此影像為 %1 像素，其餘為 %2；請用同一相機、同一尺寸拍攝全部影像</translation>
    </message>
    <message>
        <source>%1 pictures that can be used are too few; at least %2 are needed, with the board tilted in different ways</source>
        <translation>可用的影像只有 %1 張，太少；至少需要 %2 張，並使校正板朝不同方向傾斜</translation>
    </message>
    <message>
        <source>in all pictures the board is seen straight on, tilted by %1 degrees at most; at least %2 are needed to tell the focal length</source>
        <translation>所有影像中校正板都接近正對相機，傾斜最多 %1 度；要確定焦距至少需要 %2 度</translation>
    </message>
    <message>
        <source>in all pictures the board is held in nearly the same direction, turned by %1 degrees at most between two of them; at least %2 are needed to tell the focal length</source>
        <translation>所有影像中校正板的朝向幾乎相同，任意兩張之間最多相差 %1 度；要確定焦距至少需要 %2 度</translation>
    </message>
    <message>
        <source>no camera explains these pictures; tilt the board in different ways and check its setting</source>
        <translation>沒有相機模型能解釋這些影像；請使校正板朝不同方向傾斜，並檢查其設定</translation>
    </message>
    <message>
        <source>the focal length is known to %1 % only; at most %2 % can be used, so add pictures with the board tilted in different ways</source>
        <translation>焦距的不確定度為 %1 %；最多允許 %2 %，請補充校正板朝不同方向傾斜的影像</translation>
    </message>
    <message>
        <source>the pictures contradict one another by %1 px; at most %2 px can be used, so check that the board is flat, its setting right and all pictures from one camera</source>
        <translation>各影像之間相差 %1 px；最多允許 %2 px，請檢查校正板是否平整、設定是否正確、影像是否均來自同一相機</translation>
    </message>
    <message>
        <source>%1 mm are needed with margins, %2 has room for %3 mm; take larger paper or a smaller pattern</source>
        <translation>含邊距共需 %1 mm，而 %2 只有 %3 mm；請用更大的紙張或更小的圖案</translation>
    </message>
    <message>
        <source>the file does not say which camera it came from; name the camera&apos;s profile</source>
        <translation>該檔案沒有說明來自哪台相機；請指定相機的設定檔</translation>
    </message>
    <message>
        <source>a frame of &quot;%1&quot; has %2 bytes, this one has %3; choose the profile of the camera that it came from, or record it again</source>
        <translation>「%1」的一個影格有 %2 位元組，而這裡有 %3 位元組；請選擇拍攝它的相機的設定檔，或重新記錄</translation>
    </message>
    <message>
        <source>the number %1 at column %2, row %3 does not fit into %4 bits; the byte order, or the profile, is another camera&apos;s</source>
        <translation>第 %2 欄、第 %3 列的數值 %1 超出 %4 位元；位元組順序或設定檔屬於另一台相機</translation>
    </message>
    <message>
        <source>%1 % of the pixels are outside of %2 to %3, which is all that &quot;%4&quot; can tell; switch the camera to radiometric output (linear in temperature), or choose another profile</source>
        <translation>%1 % 的像素不在 %2 至 %3 之內，這是「%4」能測的全部範圍；請將相機切換到輻射測溫輸出（與溫度成線性），或選擇另一個設定檔</translation>
    </message>
    <message>
        <source>%1 pixels are above %2, where the numbers of &quot;%3&quot; are known to be wrong for some cameras; check them with another thermometer</source>
        <translation>%1 個像素高於 %2，在該範圍「%3」的數值對某些相機已知是錯誤的；請用另一支溫度計核對</translation>
    </message>
    <message>
        <source>all pixels of the picture have one value; the camera&apos;s shutter is closed, or it sends no picture</source>
        <translation>影像的所有像素都是同一個值；相機的快門關著，或相機沒有送出影像</translation>
    </message>
    <message>
        <source>%1 pixels are outside of what the camera can tell, the first at column %2, row %3, so the temperatures of the whole picture are not known; ask for regions, or take a lower gain</source>
        <translation>%1 個像素超出相機能測的範圍，第一個在第 %2 欄、第 %3 列，因此整幅影像的溫度未知；請改用區域，或降低增益</translation>
    </message>
    <message>
        <source>one channel of 16 bits is needed, and this picture has %1; save the camera&apos;s numbers, not the colours that it shows</source>
        <translation>需要 16 位元的單一通道，而該影像是 %1；請儲存相機的數值，而不是它顯示的顏色</translation>
    </message>
    <message>
        <source>a picture of &quot;%1&quot; has %2 pixels, this one has %3; choose the profile of the camera that it came from</source>
        <translation>「%1」的影像有 %2 像素，而這一幅有 %3；請選擇拍攝它的相機的設定檔</translation>
    </message>
    <message>
        <source>there is no table of temperatures: lines of %1 numbers or more, of one length, up to the end of the file</source>
        <translation>沒有溫度表：應是每行至少 %1 個數、長度相同、直到檔案末尾的各行</translation>
    </message>
    <message>
        <source>line %1 has %2 values, the table&apos;s first line has %3; export the picture again</source>
        <translation>第 %1 行有 %2 個值，而表的首行有 %3 個；請重新匯出影像</translation>
    </message>
    <message>
        <source>line %1, value %2: &quot;%3&quot; is no temperature in degrees Celsius; export the picture again, without masks</source>
        <translation>第 %1 行、第 %2 個值：「%3」不是攝氏溫度；請重新匯出影像，不要帶遮罩</translation>
    </message>
    <message>
        <source>there are no frames here; their names end in one of %1</source>
        <translation>這裡沒有影格；其檔名以下列之一結尾：%1</translation>
    </message>
    <message>
        <source>the times of the frames are not known; put %1 beside them, or give the profile a frame_rate_Hz</source>
        <translation>各影格的時間未知；請在旁邊放入 %1，或在設定檔中給出 frame_rate_Hz</translation>
    </message>
    <message>
        <source>line %1, &quot;%2&quot;, cannot be used: first file,time_s, then one line for each file of this folder, with growing times</source>
        <translation>第 %1 行「%2」無法使用：首行為 file,time_s，其後該資料夾的每個檔案一行，時間遞增</translation>
    </message>
    <message>
        <source>it is not in the picture; aim the camera at it</source>
        <translation>它不在影像中；請將相機對準它</translation>
    </message>
    <message>
        <source>nearer things hide it: %1 of its pixels are seen, %2 are needed</source>
        <translation>它被更近的東西遮住：可見 %1 個像素，需要 %2 個</translation>
    </message>
    <message>
        <source>it is seen edge-on, at %1 degrees to its face; move the camera</source>
        <translation>只看到它的側邊，視線與其表面成 %1 度；請移動相機</translation>
    </message>
    <message>
        <source>%1 pixels inside of its edges are too few, %2 are needed; bring the camera nearer</source>
        <translation>其邊緣以內只有 %1 個像素，太少，需要 %2 個；請將相機移近</translation>
    </message>
    <message>
        <source>%1 of its %2 pixels tell nothing; check the camera</source>
        <translation>其 %2 個像素中有 %1 個沒有讀數；請檢查相機</translation>
    </message>
    <message>
        <source>%1 of its %2 pixels are outside of what the camera can tell (saturated); take a lower gain</source>
        <translation>其 %2 個像素中有 %1 個超出相機能測的範圍（飽和）；請降低增益</translation>
    </message>
    <message>
        <source>the name &quot;%1&quot; is used twice; give each region its own</source>
        <translation>名稱「%1」用了兩次；請給每個區域各自的名稱</translation>
    </message>
    <message>
        <source>what the camera saw, %1, is explained by no temperature of the face at emittance %2 with these reflections; check emittance, view factors and the source&apos;s temperature</source>
        <translation>相機所見的 %1，在發射率 %2 及這些反射下，表面取任何溫度都無法解釋；請檢查發射率、角係數和熱源溫度</translation>
    </message>
    <message>
        <source>at emittance %1 the camera tells this face&apos;s temperature to +-%2 only, and a thermometer needs +-%3; paint the face black, or use a contact sensor</source>
        <translation>發射率為 %1 時，相機只能以 ±%2 測得該表面的溫度，而溫度計需要 ±%3；請將表面塗黑，或使用接觸式感測器</translation>
    </message>
    <message>
        <source>the objects&apos; outlines are seen at %1 poses of the robot; at least %2 are needed</source>
        <translation>在 %1 個機器人位姿看到物體的輪廓；至少需要 %2 個</translation>
    </message>
    <message>
        <source>no object lies in the picture where the camera is said to be; check that pose, or aim the camera at the objects</source>
        <translation>依所給的相機位姿，影像中沒有物體；請檢查該位姿，或將相機對準物體</translation>
    </message>
    <message>
        <source>the objects do not stand out against what is behind them by %1 or more; make them 5 K or more warmer or colder than the room</source>
        <translation>物體與其背景相差不到 %1；請使其比室內熱或冷 5 K 以上</translation>
    </message>
    <message>
        <source>no pose of the camera explains the pictures: at the best one %1 % of the visible outlines are found; check the start pose, the robot&apos;s pose of each picture, the mountings and that no outline is mirrored</source>
        <translation>沒有能解釋這些影像的相機位姿：最好的位姿也只找到 %1 % 的可見輪廓；請檢查起始位姿、每幅影像的機器人位姿、安裝位置，以及輪廓是否鏡像</translation>
    </message>
    <message>
        <source>the pictures allow two poses of the camera, %1 degrees apart; take more pictures, with the objects tilted and nearer</source>
        <translation>這些影像允許兩個相機位姿，相差 %1 度；請再拍攝物體傾斜且更近的影像</translation>
    </message>
    <message>
        <source>picture %1 was left out: %2 points of the objects&apos; outlines are seen in it, %3 are needed</source>
        <translation>影像 %1 未採用：其中看到物體輪廓的 %2 個點，需要 %3 個</translation>
    </message>
    <message>
        <source>%1 poses of the robot hardly show the robot&apos;s own errors; take %2 or more</source>
        <translation>%1 個機器人位姿幾乎顯不出機器人自身的誤差；請取 %2 個或更多</translation>
    </message>
    <message>
        <source>the robot stood at places in one line, within %1 mm; move it in two directions or more</source>
        <translation>機器人所在的位置在一條直線上（%1 mm 以內）；請沿兩個或更多方向移動</translation>
    </message>
    <message>
        <source>all outlines lie at nearly one distance from the camera (within %1 %), where its distance and its tilt are told badly; move the robot towards the camera, too</source>
        <translation>所有輪廓到相機的距離幾乎相同（%1 % 以內），難以得出其距離和傾斜；請也讓機器人朝相機移動</translation>
    </message>
    <message>
        <source>the camera&apos;s pose is good to %1 mm at the objects, %2 mm across the line of sight (2 sigma)</source>
        <translation>相機位姿在物體處的誤差為 %1 mm，垂直於視線方向 %2 mm（2 sigma）</translation>
    </message>
    <message>
        <source>the camera&apos;s pose is good to %1 mm only at the objects, %2 mm across the line of sight (2 sigma); take more pictures, with the objects nearer and all over the picture</source>
        <translation>相機位姿在物體處的誤差只能達到 %1 mm，垂直於視線方向 %2 mm（2 sigma）；請再拍攝物體更近、遍布影像各處的影像</translation>
    </message>
    <message>
        <source>%1 pixels show the source&apos;s face and nothing else, %2 are needed; move the objects aside, or bring the camera nearer</source>
        <translation>只有 %1 個像素僅顯示熱源的表面，需要 %2 個；請移開物體，或將相機移近</translation>
    </message>
    <message>
        <source>of the ring from %1 to %2 mm too little is seen; it is left out of the profile</source>
        <translation>%1 至 %2 mm 的圓環可見部分太少；未計入分布</translation>
    </message>
    <message>
        <source>%1 and %2 overlap; move one of them</source>
        <translation>%1 與 %2 重疊；請移動其中一個</translation>
    </message>
    <message>
        <source>%1 reaches %2 cm from the end-effector&apos;s centre; the robot can carry objects within %3 cm</source>
        <translation>%1 距末端執行器中心達 %2 cm；機器人可攜帶 %3 cm 以內的物體</translation>
    </message>
    <message>
        <source>%1, %2 and %3 lie in a line; like temperatures for all three cannot be held together, a triangle is better</source>
        <translation>%1、%2 與 %3 位於一條直線上；三者無法同時保持相近的溫度，佈置成三角形更好</translation>
    </message>
    <message>
        <source>none of the free axes changes the view factor of %1; mount it elsewhere or free another axis</source>
        <translation>沒有自由軸能改變 %1 的角係數；請換個位置安裝，或釋放另一個軸</translation>
    </message>
    <message>
        <source>%1 and %2 have the same view factor wherever the free axes bring them, so one cannot be heated without the other; mount one elsewhere or free another axis</source>
        <translation>無論自由軸如何運動，%1 與 %2 的角係數始終相同，因此無法只加熱其中一個；請將其中一個換位安裝，或釋放另一個軸</translation>
    </message>
    <message>
        <source>the free axes cannot change the view factors of %1 independently of one another; mount one elsewhere or free another axis</source>
        <translation>自由軸無法各自獨立地改變 %1 的角係數；請將其中一個換位安裝，或釋放另一個軸</translation>
    </message>
    <message>
        <source>as many objects as free axes (%1): their heating decides every movement, none is left for keeping away from limits</source>
        <translation>物體數與自由軸數相同（%1）：加熱決定了全部運動，沒有餘量用於避開限值</translation>
    </message>
    <message>
        <source>At rest the sensors&apos; readings lie %1 from their mean; at most %2 can be zeroed. Check the sensors and their noise.</source>
        <translation>靜止時感測器讀數偏離其平均值達 %1；最多可歸零 %2。請檢查感測器及其雜訊。</translation>
    </message>
    <message>
        <source>there is no such file; check the path</source>
        <translation>沒有此檔案；請檢查路徑</translation>
    </message>
    <message>
        <source>the file cannot be read: %1</source>
        <translation>無法讀取檔案：%1</translation>
    </message>
    <message>
        <source>the file cannot be written: %1</source>
        <translation>無法寫入檔案：%1</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>檔案為空</translation>
    </message>
    <message>
        <source>the file has %1, more than the %2 that are read</source>
        <translation>檔案含 %1，超過可讀取的 %2</translation>
    </message>
    <message>
        <source>unknown key &quot;%1&quot;; known here: %2</source>
        <translation>未知的鍵「%1」；此處可用：%2</translation>
    </message>
    <message>
        <source>the key &quot;%1&quot; is missing</source>
        <translation>缺少鍵「%1」</translation>
    </message>
    <message>
        <source>%1 expected, %2 found</source>
        <translation>應為 %1，實為 %2</translation>
    </message>
    <message>
        <source>the key &quot;%1&quot; is given twice</source>
        <translation>鍵「%1」出現了兩次</translation>
    </message>
    <message>
        <source>nested more than %1 levels deep</source>
        <translation>巢狀超過 %1 層</translation>
    </message>
    <message>
        <source>&quot;%1&quot; and &quot;%2&quot; say the same thing; give one of them</source>
        <translation>「%1」與「%2」含義相同；請只給出其中一個</translation>
    </message>
    <message>
        <source>%1 is out of range; allowed: %2 to %3 %4</source>
        <translation>%1 超出範圍；允許：%2 至 %3 %4</translation>
    </message>
    <message>
        <source>%1 is not allowed; it must be greater than zero</source>
        <translation>不允許 %1；必須大於零</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not known; known: %2</source>
        <translation>未知的「%1」；可用：%2</translation>
    </message>
    <message>
        <source>made by a newer version of Bask (format %1, this one knows up to %2); update Bask to open it</source>
        <translation>由更新版本的 Bask 產生（格式 %1，目前版本最高支援 %2）；請更新 Bask 後再開啟</translation>
    </message>
    <message>
        <source>not a regular file; choose another name</source>
        <translation>不是普通檔案；請另選名稱</translation>
    </message>
    <message>
        <source>this file is also an input; choose another name for the output</source>
        <translation>此檔案同時也是輸入；請為輸出另選名稱</translation>
    </message>
    <message>
        <source>another output goes there; give each its own name</source>
        <translation>另一項輸出已寫往此處；請為每項輸出指定各自的名稱</translation>
    </message>
    <message>
        <source>a file of that name exists and is not %1; choose another name</source>
        <translation>已有同名檔案，且它不是 %1；請另選名稱</translation>
    </message>
    <message>
        <source>a file of that name exists and is not an earlier export; choose another folder</source>
        <translation>已有同名檔案，且它不是先前的匯出結果；請另選資料夾</translation>
    </message>
    <message>
        <source>%1 objects, but the robot has only %2 free degrees of freedom; remove objects or free more axes</source>
        <translation>有 %1 個物體，但機器人只有 %2 個自由的自由度；請移除物體或釋放更多軸</translation>
    </message>
    <message>
        <source>there is no object; add at least one</source>
        <translation>沒有物體；請至少新增一個</translation>
    </message>
    <message>
        <source>control characters, invisible ones (of no width, or that turn the direction of writing) and spaces at either end are not allowed here</source>
        <translation>此處不允許有控制字元、不可見字元（零寬或改變書寫方向的字元），首尾也不允許有空格</translation>
    </message>
    <message>
        <source>the axis &quot;%1&quot; is given twice</source>
        <translation>軸「%1」出現了兩次</translation>
    </message>
    <message>
        <source>%1 targets given for %2 objects</source>
        <translation>給出了 %1 個目標，而物體有 %2 個</translation>
    </message>
    <message>
        <source>the start&apos;s %1 is %2, outside the workspace of %3 to %4</source>
        <translation>起始位姿的 %1 為 %2，超出工作空間 %3 至 %4</translation>
    </message>
    <message>
        <source>at the start &quot;%1&quot; is %2 mm from the source plane; at least %3 mm are needed</source>
        <translation>起始時「%1」距熱源平面 %2 mm；至少需要 %3 mm</translation>
    </message>
    <message>
        <source>the times must grow, but %1 s comes after %2 s</source>
        <translation>時間必須遞增，但 %1 s 出現在 %2 s 之後</translation>
    </message>
    <message>
        <source>no pose of the workspace keeps the clearance to the source; widen the workspace or lower the clearance</source>
        <translation>工作空間中沒有位姿能保持與熱源的間距；請擴大工作空間或減小間距</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be held at %2: with this source it settles at %3 at most, even at a view factor of 1</source>
        <translation>「%1」無法保持在 %2：用此熱源，即使角係數為 1，它也最高穩定在 %3</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be held at %2: it settles at %3 where it does not see the source</source>
        <translation>「%1」無法保持在 %2：在看不到熱源之處，它穩定在 %3</translation>
    </message>
    <message>
        <source>&quot;%1&quot; needs a view factor of %2; within the workspace it has at most %3</source>
        <translation>「%1」需要角係數 %2；在工作空間內最多為 %3</translation>
    </message>
    <message>
        <source>&quot;%1&quot; needs a view factor of %2; within the workspace it has at least %3</source>
        <translation>「%1」需要角係數 %2；在工作空間內至少為 %3</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is to be %3 hotter than &quot;%2&quot;; with this mounting and workspace at most %4 are possible</source>
        <translation>「%1」應比「%2」高 %3；在此安裝方式和工作空間下最多可高 %4</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is to be %3 hotter than &quot;%2&quot;; with this mounting and workspace it is at least %4 hotter everywhere</source>
        <translation>「%1」應比「%2」高 %3；在此安裝方式和工作空間下，它處處至少高 %4</translation>
    </message>
    <message>
        <source>each target can be held by itself, but not all together: where they come nearest within the workspace, the target surfaces miss one another by %3 cm, and &quot;%1&quot; is %2 off</source>
        <translation>各目標可單獨保持，但不能同時保持：在工作空間內最接近處，各目標等值面相距 %3 cm，「%1」偏離 %2</translation>
    </message>
    <message>
        <source>each target can be held by itself, but not all together: the best pose leaves &quot;%1&quot; %2 off</source>
        <translation>各目標可單獨保持，但不能同時保持：在最佳位姿下「%1」仍偏離 %2</translation>
    </message>
    <message>
        <source>the motion must begin at source.pose, where %1 is %3, not %2</source>
        <translation>運動必須從 source.pose 開始，該處 %1 為 %3，而不是 %2</translation>
    </message>
    <message>
        <source>the lower limit %1 must be less than the upper limit %2</source>
        <translation>下限 %1 必須小於上限 %2</translation>
    </message>
    <message>
        <source>no axis of the robot is free; free at least one</source>
        <translation>機器人沒有自由軸；請至少釋放一個</translation>
    </message>
    <message>
        <source>this source cannot heat: its net power is %1 W/m2; raise its temperature or emittance, or use the gray source model</source>
        <translation>此熱源無法加熱：其淨功率為 %1 W/m2；請提高其溫度或發射率，或使用灰體熱源模型</translation>
    </message>
    <message>
        <source>only %1 points; an outline needs at least %2</source>
        <translation>只有 %1 個點；輪廓至少需要 %2 個點</translation>
    </message>
    <message>
        <source>%1 has a coordinate that is not a finite number</source>
        <translation>%1 的某個座標不是有限數值</translation>
    </message>
    <message>
        <source>&quot;%1&quot; in line %2 is not a number</source>
        <translation>第 %2 行的「%1」不是數字</translation>
    </message>
    <message>
        <source>line %1 has %2 column(s); an x and a y are needed</source>
        <translation>第 %1 行有 %2 欄；需要 x 和 y</translation>
    </message>
    <message>
        <source>the outline is open: its ends are %1 mm apart (at most %2 mm)</source>
        <translation>輪廓未閉合：兩端相距 %1 mm（最多 %2 mm）</translation>
    </message>
    <message>
        <source>the outline crosses itself: edges %1 and %2 meet near (%3, %4) mm</source>
        <translation>輪廓自相交：邊 %1 與邊 %2 在 (%3, %4) mm 附近相交</translation>
    </message>
    <message>
        <source>the outline encloses no area</source>
        <translation>輪廓沒有圍出面積</translation>
    </message>
    <message>
        <source>the unit of length is not known; give it (mm, cm, m or in)</source>
        <translation>長度單位未知；請給出單位（mm、cm、m 或 in）</translation>
    </message>
    <message>
        <source>the file holds no outline</source>
        <translation>檔案中沒有輪廓</translation>
    </message>
    <message>
        <source>not readable as XML near line %2: %1</source>
        <translation>第 %1 行附近無法作為 XML 讀取：%2</translation>
    </message>
    <message>
        <source>elements are nested or used more than %1 levels deep</source>
        <translation>元素巢狀或引用超過 %1 層</translation>
    </message>
    <message>
        <source>not an SVG drawing</source>
        <translation>不是 SVG 圖形</translation>
    </message>
    <message>
        <source>line %1: the path data of the drawing are damaged from &quot;%2&quot; on</source>
        <translation>第 %1 行：圖形的路徑資料從「%2」起已損壞</translation>
    </message>
    <message>
        <source>line %1: &lt;use&gt; draws &quot;%2&quot;, which holds it</source>
        <translation>第 %1 行：&lt;use&gt; 繪製的「%2」包含它自身</translation>
    </message>
    <message>
        <source>the drawing&apos;s size &quot;%1&quot; cannot be used</source>
        <translation>圖形尺寸「%1」不可用</translation>
    </message>
    <message>
        <source>the drawing gives its size in pixels, taken as 1/96 inch (0.2646 mm) each; check its size</source>
        <translation>圖形尺寸以像素給出，每像素按 1/96 英吋（0.2646 mm）計；請檢查尺寸</translation>
    </message>
    <message>
        <source>left out, since they are no outlines: %1</source>
        <translation>以下內容不是輪廓，已略去：%1</translation>
    </message>
    <message>
        <source>the drawing holds more than can be read; save the one outline that is needed</source>
        <translation>圖形內容超出可讀取的範圍；請只儲存所需的那個輪廓</translation>
    </message>
    <message>
        <source>the drawing reaches farther than %1 m; check its unit</source>
        <translation>圖形範圍超過 %1 m；請檢查其單位</translation>
    </message>
    <message>
        <source>a path has more than the %1 parts that can be read; simplify it, or save the outline as DXF or CSV</source>
        <translation>某條路徑超過可讀取的 %1 段；請簡化它，或將輪廓存為 DXF 或 CSV</translation>
    </message>
    <message>
        <source>no silhouette found; the picture needs one dark object on a light ground or the reverse</source>
        <translation>未找到剪影；圖片中需要淺色背景上的一個深色物體，或深色背景上的一個淺色物體</translation>
    </message>
    <message>
        <source>the silhouette touches the picture&apos;s border; take the picture with a margin all round</source>
        <translation>剪影觸及圖片邊緣；拍攝時請在四周留出邊距</translation>
    </message>
    <message>
        <source>not a picture that can be read, or a damaged one</source>
        <translation>不是可讀取的圖片，或圖片已損壞</translation>
    </message>
    <message>
        <source>the scale is %1 pixels per mm; it must be greater than zero</source>
        <translation>比例為每毫米 %1 像素；必須大於零</translation>
    </message>
    <message>
        <source>the scale of the picture is not known; give it in pixels per mm</source>
        <translation>圖片的比例未知；請以每毫米像素數給出</translation>
    </message>
    <message>
        <source>%1 harmonics; between %2 and %3 can be used</source>
        <translation>%1 個諧波；可用 %2 至 %3 個</translation>
    </message>
    <message>
        <source>files of type &quot;%1&quot; are not read; known: %2</source>
        <translation>不讀取「%1」類型的檔案；可用：%2</translation>
    </message>
    <message>
        <source>there is no outline %1; they are numbered from 0 to %2</source>
        <translation>沒有輪廓 %1；編號為 0 至 %2</translation>
    </message>
    <message>
        <source>the file holds %1 outlines; the largest is taken</source>
        <translation>檔案中有 %1 個輪廓；取最大的一個</translation>
    </message>
    <message>
        <source>holes left out, since they cross or touch something or are more than %2: %1</source>
        <translation>以下孔因相交、接觸其他部分或超過 %2 個而略去：%1</translation>
    </message>
    <message>
        <source>the corners of the holes were thinned from %1 to %2, within %3 mm</source>
        <translation>孔的角點由 %1 個精簡為 %2 個，誤差在 %3 mm 以內</translation>
    </message>
    <message>
        <source>the fitted contour cuts a hole; use more harmonics</source>
        <translation>擬合輪廓切入了孔；請使用更多諧波</translation>
    </message>
    <message>
        <source>%1 holes; there may be %2 at most</source>
        <translation>有 %1 個孔；最多允許 %2 個</translation>
    </message>
    <message>
        <source>the hole does not lie wholly inside the outline</source>
        <translation>孔沒有完全位於輪廓之內</translation>
    </message>
    <message>
        <source>the hole meets hole %1 or lies in it, or round it</source>
        <translation>孔與孔 %1 相交，或位於其內，或包圍它</translation>
    </message>
    <message>
        <source>silhouettes left out since they touch the picture&apos;s border: %1</source>
        <translation>以下剪影因觸及圖片邊緣而略去：%1</translation>
    </message>
    <message>
        <source>more than one scale is given; give pixels per mm, a known length or a marker</source>
        <translation>給出了不止一種比例；請只給出每毫米像素數、已知長度或標記三者之一</translation>
    </message>
    <message>
        <source>no marker of dictionary %1 is seen; it needs to lie flat in the picture with a light margin</source>
        <translation>未見到字典 %1 的標記；它須平放在畫面中，並留有淺色邊緣</translation>
    </message>
    <message>
        <source>%1 markers are seen; marker %2, the largest, gives the scale</source>
        <translation>見到 %1 個標記；以最大的標記 %2 確定比例</translation>
    </message>
    <message>
        <source>the marker is only %1 pixels wide; the scale is uncertain below %2</source>
        <translation>標記寬僅 %1 像素；小於 %2 像素時比例不可靠</translation>
    </message>
    <message>
        <source>the outline reaches the horizon of the marker&apos;s plane; look at it more from above</source>
        <translation>輪廓到達了標記平面的地平線；請從更接近正上方的角度拍攝</translation>
    </message>
    <message>
        <source>the fitted contour crosses itself; use more harmonics</source>
        <translation>擬合輪廓自相交；請使用更多諧波</translation>
    </message>
    <message>
        <source>the outline cannot be fitted to %1 mm without crossing itself: with %2 harmonics %3 mm are left</source>
        <translation>輪廓無法在不自相交的情況下擬合到 %1 mm：用 %2 個諧波時仍餘 %3 mm</translation>
    </message>
    <message>
        <source>binary DXF is not read; save the drawing as ASCII DXF</source>
        <translation>不讀取二進位制 DXF；請將圖形儲存為 ASCII DXF</translation>
    </message>
    <message>
        <source>the drawing is cut off: its end mark (EOF) is missing</source>
        <translation>圖形不完整：缺少結束標誌（EOF）</translation>
    </message>
    <message>
        <source>the drawing is damaged: what line %1 says cannot be</source>
        <translation>圖形已損壞：第 %1 行的內容不合法</translation>
    </message>
    <message>
        <source>block &quot;%1&quot; contains itself</source>
        <translation>圖塊「%1」包含了自身</translation>
    </message>
    <message>
        <source>the drawing names no known unit of length; it is taken as millimetres</source>
        <translation>圖形未註明已知的長度單位；按毫米處理</translation>
    </message>
    <message>
        <source>%1 hidden entities were left out (layer off or frozen, invisible, or on paper)</source>
        <translation>略去了 %1 個隱藏的圖元（圖層已關閉或凍結、不可見，或位於圖紙空間）</translation>
    </message>
    <message>
        <source>the outline crosses itself so far that it does not go round %1 % of its area exactly once; at most 1 % is taken, use other harmonics</source>
        <translation>輪廓自相交過多，有 %1 % 的面積不是恰好被環繞一次；最多接受 1 %，請改用其他諧波數</translation>
    </message>
    <message>
        <source>%1 samples, more than the %2 that there may be; take larger steps or a smaller range</source>
        <translation>有 %1 個取樣，超過允許的 %2 個；請增大步長或縮小範圍</translation>
    </message>
    <message>
        <source>the sampling was cancelled</source>
        <translation>取樣已取消</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is an axis and cannot be held as well</source>
        <translation>「%1」是座標軸，不能同時設為固定</translation>
    </message>
    <message>
        <source>not a Bask session file</source>
        <translation>不是 Bask 工作階段檔案</translation>
    </message>
    <message>
        <source>the session file is damaged: %1</source>
        <translation>工作階段檔案已損壞：%1</translation>
    </message>
    <message>
        <source>the session file is in use: %1</source>
        <translation>工作階段檔案正在使用：%1</translation>
    </message>
    <message>
        <source>not a part of a divided study or field</source>
        <translation>不是拆分的研究或場的一部分</translation>
    </message>
    <message>
        <source>this shard was begun already; go on with --resume, or choose another folder</source>
        <translation>此分片已經開始過；請用 --resume 繼續，或另選一個資料夾</translation>
    </message>
    <message>
        <source>another process works on this shard; wait for it, or end it</source>
        <translation>另一個行程正在處理此分片；請等待它完成或結束它</translation>
    </message>
    <message>
        <source>a part of other work: %1 is %2 here and %3 there</source>
        <translation>屬於另一項工作：%1 在這裡是 %2，在那裡是 %3</translation>
    </message>
    <message>
        <source>damaged after %1 whole records; run this shard again with --resume, which keeps these</source>
        <translation>在 %1 筆完整記錄之後損壞；請用 --resume 重新執行此分片，它會保留這些記錄</translation>
    </message>
    <message>
        <source>%1 of %2 cases are not there yet (%3); run these shards with --resume</source>
        <translation>%2 個案例中還缺 %1 個（%3）；請用 --resume 執行這些分片</translation>
    </message>
    <message>
        <source>%1 readings in windows long enough are too few: at least %2 windows of %3 s are needed; record a longer run</source>
        <translation>足夠長的視窗內只有 %1 個讀數，太少：至少需要 %2 個 %3 s 的視窗；請記錄更長的運轉</translation>
    </message>
    <message>
        <source>the source was never in view; record a run that heats</source>
        <translation>熱源始終不在視野內；請記錄一次有加熱的運轉</translation>
    </message>
    <message>
        <source>the view factor hardly varied (by %1), so heating and cooling cannot be told apart; record a run that moves</source>
        <translation>角係數幾乎沒有變化（僅 %1），無法區分加熱與冷卻；請記錄一次有運動的運轉</translation>
    </message>
    <message>
        <source>the record tells %1 within %2 % only; at most 25 % can be used; record a run that heats and cools more</source>
        <translation>由此記錄得到的 %1 不確定度為 %2 %；最多允許 25 %；請記錄一次加熱和冷卻更充分的運轉</translation>
    </message>
    <message>
        <source>%1 comes out below zero: the heat balance does not describe this record; check the sensor, the source and the environment&apos;s temperature</source>
        <translation>%1 的結果小於零：熱平衡模型與此記錄不符；請檢查感測器、熱源和環境溫度</translation>
    </message>
    <message>
        <source>No experiment is loaded. Open one or make a new one.</source>
        <translation>未載入實驗。請開啟或新建一個實驗。</translation>
    </message>
    <message>
        <source>The objects are not at rest at the room&apos;s temperature (%1), so the sensors cannot be zeroed. Let them cool, or correct the environment&apos;s temperature.</source>
        <translation>物體未靜置於室溫（%1），因此感測器無法歸零。請等待冷卻，或更正環境溫度。</translation>
    </message>
    <message>
        <source>The workspace lets %1 go to %2, but the robot says that it goes to %3 only. Make the workspace smaller, or correct what the robot says.</source>
        <translation>工作空間允許 %1 到 %2，但機器人稱其只能到 %3。請縮小工作空間，或更正機器人所回報的限值。</translation>
    </message>
    <message>
        <source>Held by the operator. Resume or stop.</source>
        <translation>由操作員保持。請繼續或停止。</translation>
    </message>
    <message>
        <source>The targets cannot be held. See the Targets page.</source>
        <translation>目標無法保持。請見「目標」頁面。</translation>
    </message>
    <message>
        <source>The source&apos;s pose is measured again</source>
        <translation>熱源位姿已恢復測量</translation>
    </message>
    <message>
        <source>The heat source does not answer: %1. Check its link, then reset.</source>
        <translation>熱源無回應：%1。請檢查其連線，然後復歸。</translation>
    </message>
    <message>
        <source>The recording failed: %1. Free disk space or choose another folder, then reset.</source>
        <translation>記錄失敗：%1。請釋放磁碟空間或另選資料夾，然後復歸。</translation>
    </message>
    <message>
        <source>The engine met an internal fault: %1. Reset, and report it if it comes again.</source>
        <translation>引擎發生內部故障：%1。請復歸；若再次出現，請回報。</translation>
    </message>
    <message>
        <source>Armed</source>
        <translation>已進入待命</translation>
    </message>
    <message>
        <source>Started</source>
        <translation>已開始</translation>
    </message>
    <message>
        <source>Held</source>
        <translation>已保持</translation>
    </message>
    <message>
        <source>Resumed</source>
        <translation>已繼續</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>已停止</translation>
    </message>
    <message>
        <source>STOP pressed</source>
        <translation>已按下「軟體停止」</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>已復歸</translation>
    </message>
    <message>
        <source>All objects settled</source>
        <translation>所有物體均已穩定</translation>
    </message>
    <message>
        <source>Not settled: %1</source>
        <translation>未穩定：%1</translation>
    </message>
    <message>
        <source>Targets: %1</source>
        <translation>目標：%1</translation>
    </message>
    <message>
        <source>Controller or gains changed</source>
        <translation>控制器或增益已更改</translation>
    </message>
    <message>
        <source>The thermal camera has looked at its shutter: its drift counts from now</source>
        <translation>熱像儀已對其快門校正：漂移從現在起計算</translation>
    </message>
    <message>
        <source>Sensors zeroed at ambient</source>
        <translation>感測器已在環境溫度下歸零</translation>
    </message>
    <message>
        <source>The sensor of &quot;%1&quot; is back</source>
        <translation>「%1」的感測器已恢復</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be done in the state &quot;%2&quot;</source>
        <translation>「%1」不能在狀態「%2」下進行</translation>
    </message>
    <message>
        <source>A run is on; stop it first</source>
        <translation>正在運轉；請先停止</translation>
    </message>
    <message>
        <source>no part of the picture is clearly of this colour; set a tolerance or take another colour</source>
        <translation>圖片中沒有明顯屬於此顏色的部分；請設定容差或另選顏色</translation>
    </message>
    <message>
        <source>the drawing names its unit itself (%1); the unit given is not used</source>
        <translation>圖形自身已註明單位（%1）；不使用另行給出的單位</translation>
    </message>
    <message>
        <source>marker %1 is listed twice; each id is one marker</source>
        <translation>標記 %1 列出了兩次；每個編號只對應一個標記</translation>
    </message>
    <message>
        <source>none of the markers %1 was seen</source>
        <translation>未見到標記 %1 中的任何一個</translation>
    </message>
    <message>
        <source>marker %1 moved by %2 px while it was looked at; camera, source and end-effector must keep still</source>
        <translation>觀測期間標記 %1 移動了 %2 px；相機、熱源和末端執行器必須保持不動</translation>
    </message>
    <message>
        <source>no pose shows the markers %1 within %2 px of where they are seen; check their ids, sides and places</source>
        <translation>沒有位姿能使標記 %1 與所見位置相差在 %2 px 以內；請檢查其編號、邊長和位置</translation>
    </message>
    <message>
        <source>marker %1 was left out: it is seen %2 px from where the others put it; check its id and place</source>
        <translation>已剔除標記 %1：其所見位置與由其他標記推算的位置相差 %2 px；請檢查其編號和位置</translation>
    </message>
    <message>
        <source>marker %1 is %2 mm wide by the others, not %3 mm; measure the print</source>
        <translation>由其他標記推算，標記 %1 寬 %2 mm，而不是 %3 mm；請測量列印稿</translation>
    </message>
    <message>
        <source>the markers are seen %1 px from where they fit best together; the uncertainty is widened accordingly; check their sides and places, and the camera&apos;s calibration</source>
        <translation>標記的所見位置與整體最佳擬合相差 %1 px；不確定度已相應放大；請檢查其邊長、位置以及相機校正</translation>
    </message>
    <message>
        <source>the markers&apos; corners allow two poses, %1 degrees apart; use more or larger markers, or tilt them against the camera</source>
        <translation>標記角點允許兩種位姿，相差 %1 度；請使用更多或更大的標記，或使其相對相機傾斜</translation>
    </message>
    <message>
        <source>the pose is good to %1 mm and %2 degrees (2 sigma)</source>
        <translation>位姿精度為 %1 mm 和 %2 度（2σ）</translation>
    </message>
    <message>
        <source>the pose is good to %1 mm and %2 degrees only (2 sigma), and these markers before this camera allow no better than %3 mm and %4 degrees; use more or larger markers farther apart, tilt them against the camera, or bring it nearer</source>
        <translation>位姿精度僅為 %1 mm 和 %2 度（2σ），而這些標記在此相機前的極限為 %3 mm 和 %4 度；請使用更多或更大、間隔更遠的標記，使其相對相機傾斜，或讓相機靠近</translation>
    </message>
    <message>
        <source>the pose is good to %1 mm and %2 degrees only (2 sigma), though these markers before this camera allow %3 mm and %4 degrees; check light and focus, that all markers are seen, and their places</source>
        <translation>位姿精度僅為 %1 mm 和 %2 度（2σ），而這些標記在此相機前本可達到 %3 mm 和 %4 度；請檢查光線和對焦、是否所有標記都可見以及它們的位置</translation>
    </message>
    <message>
        <source>the end-effector&apos;s markers were seen at %1 poses of the robot; at least %2 are needed</source>
        <translation>僅在機器人的 %1 個位姿下見到末端執行器的標記；至少需要 %2 個</translation>
    </message>
    <message>
        <source>the robot hardly turned (by %1 degrees between poses; %2 are needed): without turns the camera&apos;s place cannot be told from the markers&apos; mounting; turn it about two axes, or measure where the markers sit on the end-effector</source>
        <translation>機器人幾乎沒有轉動（各位姿間僅 %1 度；需要 %2 度）：不轉動就無法區分相機位置與標記的安裝位置；請使其繞兩個軸轉動，或測量標記在末端執行器上的位置</translation>
    </message>
    <message>
        <source>the robot turned about one axis only (by %1 degrees about any other; %2 are needed): along that axis the camera&apos;s place cannot be told from the markers&apos; mounting; turn it about a second one, or measure where the markers sit on the end-effector</source>
        <translation>機器人只繞一個軸轉動（繞其他任何軸僅 %1 度；需要 %2 度）：沿該軸無法區分相機位置與標記的安裝位置；請使其再繞第二個軸轉動，或測量標記在末端執行器上的位置</translation>
    </message>
    <message>
        <source>the robot&apos;s poses and the pictures contradict one another; check that each picture was taken at its pose, that the camera kept still, and the markers&apos; sides and places</source>
        <translation>機器人位姿與影像互相矛盾；請檢查每張影像是否在對應位姿拍攝、相機是否保持不動，以及標記的邊長和位置</translation>
    </message>
    <message>
        <source>pose %1 of the robot was left out: the markers are seen %2 mm and %3 degrees from where the robot has them</source>
        <translation>已剔除機器人位姿 %1：所見標記與機器人給出的位置相差 %2 mm 和 %3 度</translation>
    </message>
    <message>
        <source>camera &quot;%1&quot; is being opened</source>
        <translation>正在開啟相機「%1」</translation>
    </message>
    <message>
        <source>camera &quot;%1&quot; cannot be opened (%2); a camera is a number, a device, a video file, a folder of pictures or an address such as rtsp://host/stream</source>
        <translation>無法開啟相機「%1」（%2）；相機可以是編號、裝置、影片檔、圖片資料夾，或 rtsp://host/stream 這樣的位址</translation>
    </message>
    <message>
        <source>no picture from camera &quot;%1&quot; for a second (%2); check cable and power. It is taken up again as soon as it answers</source>
        <translation>相機「%1」已有一秒沒有影像（%2）；請檢查纜線和電源。相機一有回應即恢復使用</translation>
    </message>
    <message>
        <source>the source has markers and is followed by the camera, which is not calibrated yet: calibrate the camera and measure where it stands on the Calibrate page, or leave the source untracked</source>
        <translation>熱源上有標記且由相機追蹤，但相機尚未校正：請在「校正」頁面校正相機並測量其位置，或不追蹤熱源</translation>
    </message>
    <message>
        <source>the robot cannot go there: outside of its workspace, or too near to the source</source>
        <translation>機器人不能到達該處：超出其工作空間，或離熱源太近</translation>
    </message>
    <message>
        <source>the calibration was cancelled</source>
        <translation>校正已取消</translation>
    </message>
    <message>
        <source>errors at %3 m are %1 mm across the line of sight and %2 mm along it</source>
        <translation>在 %3 m 處，誤差為垂直於視線方向 %1 mm、沿視線方向 %2 mm</translation>
    </message>
    <message>
        <source>errors at %3 m are %1 mm across the line of sight and %2 mm along it; check that the board is flat, measured and sharp in the pictures, and leave out views that stand out</source>
        <translation>在 %3 m 處，誤差為垂直於視線方向 %1 mm、沿視線方向 %2 mm；請檢查校正板是否平整、是否已測量、影像是否清晰，並剔除離群的視圖</translation>
    </message>
    <message>
        <source>errors at %3 m are %1 mm across the line of sight and %2 mm along it; take more views with the board tilted, near the camera and at the picture&apos;s edges</source>
        <translation>在 %3 m 處，誤差為垂直於視線方向 %1 mm、沿視線方向 %2 mm；請使校正板傾斜，在相機近處和畫面邊緣拍攝更多視圖</translation>
    </message>
    <message>
        <source>%1 views cannot be checked against one another; take at least %2</source>
        <translation>%1 個視圖無法相互驗證；請至少拍攝 %2 個</translation>
    </message>
    <message>
        <source>bring the board to the left edge of the picture</source>
        <translation>請將校正板移到畫面左邊緣</translation>
    </message>
    <message>
        <source>bring the board to the right edge of the picture</source>
        <translation>請將校正板移到畫面右邊緣</translation>
    </message>
    <message>
        <source>bring the board to the upper edge of the picture</source>
        <translation>請將校正板移到畫面上邊緣</translation>
    </message>
    <message>
        <source>bring the board to the lower edge of the picture</source>
        <translation>請將校正板移到畫面下邊緣</translation>
    </message>
    <message>
        <source>bring the board nearer to the camera</source>
        <translation>請將校正板移近相機</translation>
    </message>
    <message>
        <source>tilt the board more, its left or right edge towards the camera</source>
        <translation>請加大校正板傾斜，使其左邊緣或右邊緣朝向相機</translation>
    </message>
    <message>
        <source>tilt the board more, its upper or lower edge towards the camera</source>
        <translation>請加大校正板傾斜，使其上邊緣或下邊緣朝向相機</translation>
    </message>
    <message>
        <source>%1 views of %2 that are enough</source>
        <translation>已有 %1 個視圖，%2 個即足夠</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be opened: %2. Check the cable and the name of the port; Bask tries again by itself.</source>
        <translation>無法開啟「%1」：%2。請檢查纜線和連接埠名稱；Bask 會自動重試。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; exists and is not a link; choose another path</source>
        <translation>「%1」已存在且不是連結；請另選路徑</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is at %2, above its trip limit of %3. The robot takes it away and the heat is off. Check the object and its sensor. Reset when it has cooled.</source>
        <translation>「%1」為 %2，超過其跳脫限值 %3。機器人將其移開，加熱已關閉。請檢查物體及其感測器。冷卻後再復歸。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not an axis; axes are X, Y, Z, A, B, C and R</source>
        <translation>「%1」不是軸；軸為 X、Y、Z、A、B、C 和 R</translation>
    </message>
    <message>
        <source>&quot;%1&quot; takes no more bytes: the device does not read. Check its power and the flow control of the port.</source>
        <translation>「%1」不再接收位元組：裝置沒有讀取。請檢查其電源和連接埠的流量控制。</translation>
    </message>
    <message>
        <source>%1 channels for %2 objects; give each object one</source>
        <translation>%1 個通道對應 %2 個物體；請為每個物體指定一個</translation>
    </message>
    <message>
        <source>%1 is free, but no axis of the robot drives it</source>
        <translation>%1 是自由的，但沒有機器人軸驅動它</translation>
    </message>
    <message>
        <source>Bask has just connected to the rig. Check it, then reset.</source>
        <translation>Bask 剛連接到實驗台。請檢查實驗台，然後復歸。</translation>
    </message>
    <message>
        <source>Only %1 MB of disk space are left; a recording needs %2 MB. Free some space, then arm again.</source>
        <translation>磁碟空間僅剩 %1 MB；記錄需要 %2 MB。請釋放空間，然後重新進入待命。</translation>
    </message>
    <message>
        <source>The robot is held at its own panel (%1). Release it there, then clear the alarm.</source>
        <translation>機器人被其自身面板保持（%1）。請在面板上解除，然後清除警報。</translation>
    </message>
    <message>
        <source>The robot is switched off at its own controller. Enable it, then clear the alarm.</source>
        <translation>機器人在其自身控制器上被關閉。請啟用它，然後清除警報。</translation>
    </message>
    <message>
        <source>The robot reports alarm %1: %2. Remove the cause and clear the alarm. Home the robot if its place is not sure.</source>
        <translation>機器人報出警報 %1：%2。請排除原因並清除警報。若其位置不確定，請使機器人回原點。</translation>
    </message>
    <message>
        <source>The robot&apos;s controller has restarted: its last order is lost and its place is not sure. Home it, or confirm its place, then reset.</source>
        <translation>機器人控制器已重啟：先前的指令已失效，位置不確定。請使其回原點或確認其位置，然後復歸。</translation>
    </message>
    <message>
        <source>The source is at %1, above its trip limit of %2. The robot takes the objects away and the heat is off. Check the source&apos;s controller and sensor. Reset when it has cooled.</source>
        <translation>熱源為 %1，超過其跳脫限值 %2。機器人將物體移開，加熱已關閉。請檢查熱源的控制器和感測器。冷卻後再復歸。</translation>
    </message>
    <message>
        <source>The source is at %1 and has come no nearer to %2 for %3 s. The heat is off. Check that the source is switched on and that its sensor is in place, then reset.</source>
        <translation>熱源為 %1，已有 %3 s 未向 %2 接近。加熱已關閉。請檢查熱源是否通電、其感測器是否到位，然後復歸。</translation>
    </message>
    <message>
        <source>The source was set to %1 but reads back %2. Bask switches the heat off. Check its own panel and limits, then reset.</source>
        <translation>熱源被設為 %1，回讀卻為 %2。Bask 將關閉加熱。請檢查其自身面板和限值，然後復歸。</translation>
    </message>
    <message>
        <source>a step of the robot would leave its workspace or come too near to the source; it was not sent</source>
        <translation>機器人的某一步會離開其工作空間或離熱源太近；該步未傳送</translation>
    </message>
    <message>
        <source>faults can be simulated on the simulated rig only</source>
        <translation>只能在模擬實驗台上模擬故障</translation>
    </message>
    <message>
        <source>over: %1</source>
        <translation>已解除：%1</translation>
    </message>
    <message>
        <source>the axis %1 is given twice</source>
        <translation>軸 %1 出現了兩次</translation>
    </message>
    <message>
        <source>the device on &quot;%1&quot; has not answered for %2 s. Check its power, the cable, and the speed and unit set for it.</source>
        <translation>「%1」上的裝置已有 %2 s 沒有回應。請檢查其電源、纜線，以及所設的速率和單元位址。</translation>
    </message>
    <message>
        <source>the device on &quot;%1&quot; is not the one that is set: it says &quot;%2&quot;. Check the port and the driver.</source>
        <translation>「%1」上的裝置不是所設的裝置：它回報「%2」。請檢查連接埠和驅動。</translation>
    </message>
    <message>
        <source>the experiment has no rig of its own (&quot;rig&quot;), only the simulated one</source>
        <translation>實驗沒有自己的實驗台（「rig」），只有模擬實驗台</translation>
    </message>
    <message>
        <source>the link to &quot;%1&quot; was lost: %2. Check the cable; Bask opens it again as soon as it is there.</source>
        <translation>與「%1」的連線已斷開：%2。請檢查纜線；一旦恢復，Bask 會立即重新開啟。</translation>
    </message>
    <message>
        <source>the profile &quot;%1&quot; is that of another kind of device</source>
        <translation>設定檔「%1」屬於另一類裝置</translation>
    </message>
    <message>
        <source>the rig has no %1; set one, or use the simulated rig</source>
        <translation>實驗台缺少%1；請設定，或使用模擬實驗台</translation>
    </message>
    <message>
        <source>the robot has no axis</source>
        <translation>機器人沒有軸</translation>
    </message>
    <message>
        <source>this robot has no homing</source>
        <translation>此機器人沒有回原點功能</translation>
    </message>
    <message>
        <source>two axes drive %1</source>
        <translation>兩個軸驅動 %1</translation>
    </message>
    <message>
        <source>two devices are on &quot;%1&quot;; only Modbus devices of different units and the same line settings can share a port</source>
        <translation>「%1」上有兩個裝置；只有單元位址不同且線路設定相同的 Modbus 裝置才能共用連接埠</translation>
    </message>
    <message>
        <source>two objects have channel %1; give each its own</source>
        <translation>兩個物體都用通道 %1；請為每個物體指定各自的通道</translation>
    </message>
    <message>
        <source>unit %2 on &quot;%1&quot; refuses the request with exception %3. Check the profile set for it.</source>
        <translation>「%1」上的單元 %2 以異常 %3 拒絕了請求。請檢查所設的設定檔。</translation>
    </message>
    <message>
        <source>The heat source did not obey the order to switch off. Switch it off at its mains. Its answer: %1</source>
        <translation>熱源沒有執行關閉指令。請切斷其總電源。它的回應：%1</translation>
    </message>
    <message>
        <source>The heat source has reported no temperature for %1 s. The heat is off. Check its sensor and its link, then reset.</source>
        <translation>熱源已有 %1 s 沒有給出溫度。加熱已關閉。請檢查其感測器和連線，然後復歸。</translation>
    </message>
    <message>
        <source>The source is heated manually and is at %1: Bask cannot switch it off. Switch it off yourself, and keep the objects away from it.</source>
        <translation>熱源由人工加熱，目前 %1：Bask 無法將其關閉。請您自行關閉，並使物體遠離它。</translation>
    </message>
    <message>
        <source>The temperature of &quot;%1&quot; should have changed by %2 in %3 s but has not. Its sensor may be off, the object may be gone, or the source may be elsewhere than expected. Bask switches the heat off. Check all three, then reset.</source>
        <translation>「%1」的溫度本應在 %3 s 內變化 %2，卻沒有變化。可能是感測器脫落、物體缺失，或熱源不在預期的位置。Bask 將關閉加熱。請檢查這三項，然後復歸。</translation>
    </message>
    <message>
        <source>The target of &quot;%1&quot;, %2, is above its warning limit of %3, where every run holds. Lower the target, or raise the limit if object and sensor bear it.</source>
        <translation>「%1」的目標 %2 高於其警告限值 %3，每次運轉都會在此保持。請降低目標；若物體和感測器能承受，也可提高限值。</translation>
    </message>
    <message>
        <source>The source is still at %1, %2 s after its heat was switched off. Switch it off at its mains, then reset.</source>
        <translation>熱源在關閉加熱 %2 s 後仍為 %1。請切斷其總電源，然後復歸。</translation>
    </message>
    <message>
        <source>The robot refused a line with error %1: %2. Remove the cause, clear the alarm, then reset.</source>
        <translation>機器人以錯誤 %1 拒絕了一行指令：%2。請排除原因，清除警報，然後復歸。</translation>
    </message>
    <message>
        <source>The robot has not reported its state yet. Wait a moment. If this lasts, check its power, its link and the driver set for it.</source>
        <translation>機器人尚未回報狀態。請稍候。若一直如此，請檢查其電源、連線和所設的驅動。</translation>
    </message>
    <message>
        <source>the device on &quot;%1&quot; gave an answer that does not fit the question: %2. The answer was not used. Check the settings of the port, and of the device itself.</source>
        <translation>「%1」上的裝置所答非所問：%2。該回應未被使用。請檢查連接埠和裝置本身的設定。</translation>
    </message>
    <message>
        <source>No pose in the workspace holds all targets together; going to the best compromise found, expected to end at %1 of the targets. The Targets page shows what can be held.</source>
        <translation>工作空間中沒有能同時保持所有目標的位姿；將前往所找到的最佳折衷處，預計最終與目標的偏差為 %1。可保持的目標見「目標」頁面。</translation>
    </message>
    <message>
        <source>The heat source was stopped at its own panel or by its own protection; Bask keeps it off. Find the cause, then reset.</source>
        <translation>熱源被其自身面板或自身保護停止；Bask 使其保持關閉。請查明原因，然後復歸。</translation>
    </message>
    <message>
        <source>with the profile &quot;%1&quot; the source has no watchdog: it stays hot when Bask or the computer dies. Take a controller that has one, or allow it with &quot;unattended_heat&quot;: true.</source>
        <translation>使用設定檔「%1」時熱源沒有看門狗：Bask 或電腦停止執行後它會一直發熱。請使用具有看門狗的控制器，或以 &quot;unattended_heat&quot;: true 允許這樣做。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; and &quot;%2&quot; are far from the source but differ by %3, more than %4. One sensor is wrong or off its object. Check both.</source>
        <translation>「%1」與「%2」遠離熱源，卻相差 %3，超過 %4。某個感測器有誤或脫離了物體。請檢查兩者。</translation>
    </message>
    <message>
        <source>The control loop was delayed by %1 s, more than the allowed %2 s; the robot stood still. Close other programs on this computer.</source>
        <translation>控制迴路被延誤 %1 s，超過允許的 %2 s；機器人已靜止。請關閉此電腦上的其他程式。</translation>
    </message>
    <message>
        <source>The robot is %1 mm from where its steps should have brought it, more than %2 mm. It may have been pushed or have lost steps: check it, home it, then reset.</source>
        <translation>機器人與按步進應到的位置相差 %1 mm，超過 %2 mm。它可能被推動過或失步：請檢查並使其回原點，然後復歸。</translation>
    </message>
    <message>
        <source>The robot&apos;s place is not sure: Bask has not seen it homed since it connected, or its place was lost in a restart or a stop. Home it, or confirm its place.</source>
        <translation>機器人的位置不確定：自連線以來 Bask 未見其回原點，或其位置在重新啟動或停止時失去。請使其回原點，或確認其位置。</translation>
    </message>
    <message>
        <source>The source warmed by %1 in %2 s although its heat is off; at most %3 is allowed. Its relay may be stuck, or somebody heats it at its own panel. Switch it off at its mains, then reset.</source>
        <translation>加熱已關閉，熱源卻在 %2 s 內升溫 %1；最多允許 %3。可能是其繼電器沾黏，或有人在其面板上加熱。請切斷其總電源，然後復歸。</translation>
    </message>
    <message>
        <source>The sensor of &quot;%1&quot; jumped by %2/s; heat can change it by at most %3/s. Check for a loose contact, and that the sensor is on its object. Bask uses it again when it agrees with the heat, or when a person confirms it.</source>
        <translation>「%1」的感測器跳變 %2/s；受熱最多只能變化 %3/s。請檢查是否接觸不良、感測器是否在物體上。待其與受熱情況相符或經人確認後，Bask 才重新使用它。</translation>
    </message>
    <message>
        <source>The sensor of &quot;%1&quot; reads %2, but after the heat that its object received the object should be at %3 to %4. Check that the sensor is on its object, then confirm it.</source>
        <translation>「%1」的感測器讀數為 %2，但按其物體的受熱情況，物體應為 %3 至 %4。請檢查感測器是否在物體上，然後確認。</translation>
    </message>
    <message>
        <source>The sensor of &quot;%1&quot; has given exactly the same value for %2 s, without its usual noise: it may have stopped. Watch whether it follows the heat, or confirm it.</source>
        <translation>「%1」的感測器在 %2 s 內一直給出完全相同的值，沒有平常的雜訊：可能已停止工作。請觀察它是否跟隨受熱變化，或確認它。</translation>
    </message>
    <message>
        <source>The temperature of &quot;%1&quot; has changed by %2 in %3 s, which no heat or loss explains. Its sensor may be off, or something touches the object. Bask switches the heat off. Check both, then reset.</source>
        <translation>「%1」的溫度在 %3 s 內變化了 %2，任何加熱或散熱都無法解釋。其感測器可能已脫落，或有東西接觸物體。Bask 將關閉加熱。請檢查兩者，然後復歸。</translation>
    </message>
    <message>
        <source>Another Bask runs with the same settings. The alarms of this one are kept in %1.</source>
        <translation>另一個 Bask 正以相同的設定執行。本程式的警報儲存在 %1 中。</translation>
    </message>
    <message>
        <source>The sensor of &quot;%1&quot; is confirmed at %2</source>
        <translation>「%1」的感測器已確認為 %2</translation>
    </message>
    <message>
        <source>The heat source has no watchdog: if this computer stops, it stays hot. Do not leave it unattended.</source>
        <translation>熱源沒有看門狗：若本電腦停機，熱源仍保持高溫。請勿無人看管。</translation>
    </message>
    <message>
        <source>No heat without the guard process, which switches the heater off if Bask dies; it cannot be started: %1. Install Bask again.</source>
        <translation>沒有守護行程就不加熱：它在 Bask 異常終止時關閉加熱器；無法啟動它：%1。請重新安裝 Bask。</translation>
    </message>
    <message>
        <source>The guard process has taken the heater over and switches it off: %1. Its log says what it did. Find the cause, then reset.</source>
        <translation>守護行程已接管加熱器並將其關閉：%1。其日誌說明了所做的操作。請查明原因，然後復歸。</translation>
    </message>
    <message>
        <source>The heater&apos;s guard process has ended; Bask has taken the port back and switches the heat off. Reset starts a new guard.</source>
        <translation>加熱器的守護行程已終止；Bask 已收回連接埠並關閉加熱。「復歸」會啟動新的守護行程。</translation>
    </message>
    <message>
        <source>The sensor of &quot;%1&quot; has given nothing new for %2 s. Check its cable.</source>
        <translation>「%1」的感測器在 %2 s 內沒有給出新值。請檢查其電纜。</translation>
    </message>
    <message>
        <source>The sensor of &quot;%1&quot; gives no plausible value: a broken wire, a loose contact, or another device than was set up. Check it.</source>
        <translation>「%1」的感測器給出的值不合理：導線斷開、接觸不良，或不是所設定的裝置。請檢查。</translation>
    </message>
    <message>
        <source>The source&apos;s pose is not measured any more. Bring the source back into view.</source>
        <translation>不再測得熱源的位姿。請使熱源回到視野中。</translation>
    </message>
    <message>
        <source>Held by the engine: %1</source>
        <translation>由引擎保持：%1</translation>
    </message>
    <message>
        <source>Ended by the engine: %1</source>
        <translation>由引擎結束：%1</translation>
    </message>
    <message>
        <source>Retreat: the heat is off, the robot takes the objects away</source>
        <translation>撤離：加熱關閉，機器人將物體移開</translation>
    </message>
    <message>
        <source>The robot takes the objects away by itself: %1</source>
        <translation>機器人自行將物體移開：%1</translation>
    </message>
    <message>
        <source>Held for more than %1 s without a reading of &quot;%2&quot;: the run is ended</source>
        <translation>無「%2」的讀數保持超過 %1 s：運轉結束</translation>
    </message>
    <message>
        <source>Held for more than %1 s without the source&apos;s pose: the run is ended</source>
        <translation>無熱源位姿保持超過 %1 s：運轉結束</translation>
    </message>
    <message>
        <source>The robot stops</source>
        <translation>機器人停止</translation>
    </message>
    <message>
        <source>The run ends, with a retreat and the heat off</source>
        <translation>運轉結束，撤離並關閉加熱</translation>
    </message>
    <message>
        <source>The heat is switched off</source>
        <translation>加熱被關閉</translation>
    </message>
    <message>
        <source>The robot takes the objects away from the source</source>
        <translation>機器人使物體離開熱源</translation>
    </message>
    <message>
        <source>Reset when the rig is safe.</source>
        <translation>確認實驗台安全後復歸。</translation>
    </message>
    <message>
        <source>Reset is possible when this is over: %1</source>
        <translation>待此情況消除後方可復歸：%1</translation>
    </message>
    <message>
        <source>Keep your hands off the robot and press Retreat: it takes the objects away from the heat.</source>
        <translation>手勿靠近機器人，按「撤離」：機器人會使物體離開熱源。</translation>
    </message>
    <message>
        <source>Resume, or stop the run.</source>
        <translation>請繼續或停止運轉。</translation>
    </message>
    <message>
        <source>Resume is possible when this is over; Stop ends the run: %1</source>
        <translation>待此情況消除後方可繼續；「停止」結束運轉：%1</translation>
    </message>
    <message>
        <source>an alarm is shelved with a reason; say why</source>
        <translation>擱置警報需要理由；請說明原因</translation>
    </message>
    <message>
        <source>%1: %3 instead of %2</source>
        <translation>%1：%3，而非 %2</translation>
    </message>
    <message>
        <source>this allows the real rig more than before: %1. Whether robot, source, objects and sensors bear it is for a person to say</source>
        <translation>這將允許實機實驗台超出以前的範圍：%1。機器人、熱源、物體和感測器能否承受，須由人來判斷</translation>
    </message>
    <message>
        <source>The robot was ordered to take the objects away but does not move; %1 cm are left. The heat is off. Take the objects away by hand; they may be hot. Check the robot&apos;s power and its drives.</source>
        <translation>已令機器人將物體移開，但它不動；還剩 %1 cm。加熱已關閉。請用手移開物體，物體可能很燙。請檢查機器人的電源和驅動。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is at %2, above its warning limit of %3. Let it cool: Stop or Retreat takes it away. Check its target and its limits.</source>
        <translation>「%1」為 %2，超過其警告限值 %3。請讓它冷卻：「停止」或「撤離」會將其移開。請檢查其目標和限值。</translation>
    </message>
    <message>
        <source>The sensor of &quot;%1&quot; is open: a wire or the plug is off. Repair it.</source>
        <translation>「%1」的感測器開路：導線或插頭脫落。請修好。</translation>
    </message>
    <message>
        <source>The sensor of &quot;%1&quot; is shorted. Check its wires and its plug, and repair it.</source>
        <translation>「%1」的感測器短路。請檢查其導線和插頭並修好。</translation>
    </message>
    <message>
        <source>The sensor of &quot;%1&quot; has given exactly the same value for %2 s: the sensor or its device has stopped. Check both.</source>
        <translation>「%1」的感測器在 %2 s 內一直給出完全相同的值：感測器或其裝置已停止工作。請檢查兩者。</translation>
    </message>
    <message>
        <source>The heat source reports %1, more than %3 below the room&apos;s %2. It may use another unit (°C, °F) than its profile says, or its sensor is wrong. It is not heated. Set both to the same unit, then reset.</source>
        <translation>熱源回報 %1，比室溫 %2 低 %3 以上。它使用的單位（°C、°F）可能與其設定檔不同，或其感測器有誤。不對它加熱。請把兩者設為同一單位，然後復歸。</translation>
    </message>
    <message>
        <source>The heat source reports %1 °C instead of %2 °C. This is the same number in °F: it uses another unit than its profile says. It is not heated. Set both to the same unit, then reset.</source>
        <translation>熱源回報 %1 °C，而不是 %2 °C。這正是以 °F 表示的同一數值：它使用的單位與其設定檔不同。不對它加熱。請把兩者設為同一單位，然後復歸。</translation>
    </message>
    <message>
        <source>The computer was suspended for %1 s while the source was hot or the robot moved. What happened meanwhile is not known. The heat is off. Check the rig, then reset.</source>
        <translation>電腦在熱源加熱或機器人運動時休眠了 %1 s。其間發生了什麼並不清楚。加熱已關閉。請檢查實驗台，然後復歸。</translation>
    </message>
    <message>
        <source>The computer was suspended for %1 s</source>
        <translation>電腦休眠了 %1 s</translation>
    </message>
    <message>
        <source>This computer cannot be kept awake while heat is on (%1): switch off its standby, and keep its lid open</source>
        <translation>加熱期間無法讓這台電腦保持喚醒（%1）：請關閉其待機功能，並保持機蓋打開</translation>
    </message>
    <message>
        <source>The device that answers at %1 is the right one from now on</source>
        <translation>從現在起，在 %1 回應的裝置就是正確的裝置</translation>
    </message>
    <message>
        <source>Another device than before answers at %1: it was &quot;%2&quot; and is &quot;%3&quot;. Nothing is written to it. Put the plugs right, or say on the Rig page that this is the one.</source>
        <translation>在 %1 回應的裝置與以前不同：原為「%2」，現為「%3」。不會向它寫入任何內容。請把插頭接對，或在「實驗台」頁上說明就是這台。</translation>
    </message>
    <message>
        <source>The heat of the real rig (%1) is not known to be off, and Bask no longer watches it. Check the plate, and switch it off at its mains.</source>
        <translation>實際實驗台（%1）的加熱不能確定已關閉，Bask 也不再監視它。請檢查熱板，並切斷其電源。</translation>
    </message>
    <message>
        <source>The sensor of &quot;%1&quot; reads %2 and did not follow its object&apos;s heat. Check that the sensor is on its object, then confirm it.</source>
        <translation>「%1」的感測器讀數為 %2，且沒有跟隨其物體的受熱。請檢查感測器是否在物體上，然後確認。</translation>
    </message>
    <message>
        <source>what the air takes is unknown and not counted: in air objects settle colder than told here; state the convection of the air in the experiment</source>
        <translation>空氣帶走的熱量未知，未計入：在空氣中物體的穩態溫度會低於此處所示；請在實驗中說明空氣的對流</translation>
    </message>
    <message>
        <source>this record cannot tell radiation from what the air takes: only the loss of both together and its slope at %1 are certain; state the convection of the air in the experiment, or record wide temperatures</source>
        <translation>此記錄無法區分輻射與空氣帶走的熱量：只有兩者合計的損失及其在 %1 處的斜率是確定的；請在實驗中說明空氣的對流，或記錄更寬的溫度範圍</translation>
    </message>
    <message>
        <source>%1 takes %2 % of the light of %3 at the start pose</source>
        <translation>在起始位姿，%1 擋住 %3 的 %2 % 的光</translation>
    </message>
    <message>
        <source>%1 takes %2 % of the light of %3 at this pose</source>
        <translation>在此位姿，%1 擋住 %3 的 %2 % 的光</translation>
    </message>
    <message>
        <source>the list is empty; leave it out for a source that is even</source>
        <translation>清單為空；熱源均勻時請省略它</translation>
    </message>
    <message>
        <source>this part of the source overlaps %1; parts may touch but not cover one another</source>
        <translation>熱源的這一部分與 %1 重疊；各部分可以相接，但不能互相覆蓋</translation>
    </message>
    <message>
        <source>this part reaches %1 mm beyond the source&apos;s contour; move it or make the contour larger</source>
        <translation>這一部分超出熱源輪廓 %1 mm；請移動它或擴大輪廓</translation>
    </message>
    <message>
        <source>this part stands %1 mm out of the source&apos;s plane, from which clearances are measured; lower it, or move the source&apos;s pose up</source>
        <translation>這一部分高出熱源平面 %1 mm，而安全距離從該平面量起；請降低它，或上移熱源的位姿</translation>
    </message>
    <message>
        <source>this part of the source stands on edge or faces away; tilt it by less than 89 degrees</source>
        <translation>熱源的這一部分側立或背向；傾斜角須小於 89 度</translation>
    </message>
    <message>
        <source>this part lies in front of %1; what parts of a source hide from one another is not computed</source>
        <translation>這一部分位於 %1 前方；熱源各部分之間的遮擋不作計算</translation>
    </message>
    <message>
        <source>the radii must grow, but %1 mm comes after %2 mm</source>
        <translation>半徑必須遞增，但 %2 mm 之後是 %1 mm</translation>
    </message>
    <message>
        <source>a radial profile needs a source whose contour is a disk without holes</source>
        <translation>徑向分布要求熱源輪廓為無孔圓盤</translation>
    </message>
    <message>
        <source>the first line must name two columns: the radius (radius_mm, radius_cm or radius_m) and temperature_ratio or temperature_offset_K</source>
        <translation>第一行必須給出兩欄的名稱：半徑（radius_mm、radius_cm 或 radius_m）以及 temperature_ratio 或 temperature_offset_K</translation>
    </message>
    <message>
        <source>line %1: two numbers expected, &quot;%2&quot; found</source>
        <translation>第 %1 行：應為兩個數，實為「%2」</translation>
    </message>
    <message>
        <source>the name &quot;%1&quot; is used twice; give each object, fixture and shield its own</source>
        <translation>名稱「%1」用了兩次；請給每個物體、夾具和遮板不同的名稱</translation>
    </message>
    <message>
        <source>every object, fixture and shield needs a name</source>
        <translation>每個物體、夾具和遮板都需要名稱</translation>
    </message>
    <message>
        <source>at the start &quot;%1&quot; is %2 mm from the source plane; at least %3 mm are needed, since the shield &quot;%4&quot; reaches up to %5 mm and everything held stays above it</source>
        <translation>在起始位姿，「%1」距熱源平面 %2 mm；至少需要 %3 mm，因為遮板「%4」高達 %5 mm，所有被夾持的物件都須保持在其上方</translation>
    </message>
    <message>
        <source>the lowest point of this shield is %1 mm over the source plane; at least %2 mm are needed</source>
        <translation>此遮板的最低點在熱源平面上方 %1 mm；至少需要 %2 mm</translation>
    </message>
    <message>
        <source>the camera&apos;s pose in the robot&apos;s base is not known</source>
        <translation>相機在機器人基座中的位姿未知</translation>
    </message>
    <message>
        <source>the robot&apos;s place is not sure, so nobody knows where in the picture it is</source>
        <translation>機器人的位置不確定，因此無從得知它在影像中的何處</translation>
    </message>
    <message>
        <source>the camera is not zeroed on it; it has to see the object as cold as the room, before any heat</source>
        <translation>相機尚未在它上面歸零；須在任何加熱之前看到該物體與室內一樣冷</translation>
    </message>
    <message>
        <source>its face reflects the source, whose temperature is not known</source>
        <translation>其表面反射熱源，而熱源的溫度未知</translation>
    </message>
    <message>
        <source>it is above %1, where the camera&apos;s numbers are known to be wrong</source>
        <translation>它高於 %1，已知相機的數值在那裡有誤</translation>
    </message>
    <message>
        <source>the camera&apos;s last picture is %1 s old</source>
        <translation>相機最近一幅影像已過去 %1 s</translation>
    </message>
    <message>
        <source>the lens model has no line of sight for some pixels; calibrate the camera again</source>
        <translation>鏡頭模型對某些像素沒有視線；請重新校正相機</translation>
    </message>
    <message>
        <source>no pictures of a thermal camera were recorded; set sampling.thermal_frame_period_s before a run</source>
        <translation>沒有記錄熱像儀的影像；請在運轉前設定 sampling.thermal_frame_period_s</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is to be read by a thermal camera, and the rig has none; give the rig one, or read the object by &quot;contact&quot;</source>
        <translation>「%1」要由熱像儀讀取，而實驗台沒有熱像儀；請為實驗台配一台，或以「contact」讀取該物體</translation>
    </message>
    <message>
        <source>The sensors of &quot;%1&quot; and &quot;%2&quot; seem to be swapped: within the last %3 s their readings changed as if each were on the other object, as the thermal camera sees both. The heat is off. Check both, confirm them, then reset.</source>
        <translation>「%1」和「%2」的感測器似乎互換了：在最近 %3 s 內，從熱像儀看，它們讀數的變化如同各自在另一物體上。加熱已關閉。請檢查兩者，確認它們，然後復歸。</translation>
    </message>
    <message>
        <source>The sensor of &quot;%1&quot; reads %2, but the thermal camera sees the object at %3, within %4, and no emittance explains that. The sensor may be off its object. The heat is off. Fasten the sensor, confirm it, then reset.</source>
        <translation>「%1」的感測器讀數為 %2，而熱像儀看到該物體為 %3（誤差在 %4 以內），沒有任何發射率能解釋。感測器可能已從物體上脫落。加熱已關閉。請固定感測器並確認，然後復歸。</translation>
    </message>
    <message>
        <source>The sensor of &quot;%1&quot; reads %2, but the thermal camera sees the object at %3, within %4; both agreed %5 s ago. The sensor has come off its object. The heat is off. Fasten the sensor, confirm it, then reset.</source>
        <translation>「%1」的感測器讀數為 %2，而熱像儀看到該物體為 %3（誤差在 %4 以內）；%5 s 前兩者還相符。感測器已從物體上脫落。加熱已關閉。請固定感測器並確認，然後復歸。</translation>
    </message>
    <message>
        <source>The thermal camera cannot read &quot;%1&quot;: %2.</source>
        <translation>熱像儀無法讀取「%1」：%2。</translation>
    </message>
    <message>
        <source>The thermal camera sees &quot;%1&quot; at %2, within %3, but its sensor reads %4. Both agree if the emittance of its face is %5 instead of %6. Measure the emittance, and check that the sensor is fastened well.</source>
        <translation>熱像儀看到「%1」為 %2（誤差在 %3 以內），而其感測器讀數為 %4。若其表面的發射率為 %5 而不是 %6，兩者就相符。請測量發射率，並檢查感測器是否固定好。</translation>
    </message>
    <message>
        <source>The thermal camera sees &quot;%1&quot; at %2, within %3, but its sensor reads %4. Check the sensor, that nothing is before the camera, and that the camera has not been moved.</source>
        <translation>熱像儀看到「%1」為 %2（誤差在 %3 以內），而其感測器讀數為 %4。請檢查感測器，相機前有沒有東西，以及相機是否被移動過。</translation>
    </message>
    <message>
        <source>The thermal camera cannot check the sensor of &quot;%1&quot;: %2.</source>
        <translation>熱像儀無法核對「%1」的感測器：%2。</translation>
    </message>
    <message>
        <source>A step of the robot took over twice its time and was stopped. Its controller&apos;s rates ($110 to $115) or accelerations ($120 to $125) are too small for the largest speed of the experiment, or it is blocked. Check both, then reset.</source>
        <translation>機器人的某一步所用時間超過其兩倍，已令其停止。其控制器的速率（$110 至 $115）或加速度（$120 至 $125）對實驗的最大速度來說太小，或機器人受阻。請檢查這兩項，然後復歸。</translation>
    </message>
    <message>
        <source>The robot cannot follow the largest speed of the experiment, because its controller has %1: a step takes %2 s instead of %3 s, and a retreat up to %4 s. Raise that setting, or set a smaller largest speed.</source>
        <translation>機器人跟不上實驗的最大速度，因為其控制器的設定為 %1：一步需要 %2 s 而不是 %3 s，撤離最長需要 %4 s。請增大該設定，或設定較小的最大速度。</translation>
    </message>
    <message>
        <source>the program &quot;%1&quot; was not confirmed on this computer, or has changed since. Bask does not start it. Look at it, then confirm it on the Rig page, or allow it with --allow-program where there is no window.</source>
        <translation>程式「%1」未在本電腦上確認，或此後已改變。Bask 不啟動它。請查看它，然後在「實驗台」頁確認；沒有視窗時以 --allow-program 允許。</translation>
    </message>
    <message>
        <source>the program &quot;%1&quot; cannot be started: %2. Check its command on the Rig page.</source>
        <translation>程式「%1」無法啟動：%2。請在「實驗台」頁檢查其命令。</translation>
    </message>
    <message>
        <source>the program &quot;%1&quot; has ended: %2. Bask starts it again. If it ends again, try it with &quot;bask check-device&quot;.</source>
        <translation>程式「%1」已結束：%2。Bask 會重新啟動它。若再次結束，請以 &quot;bask check-device&quot; 檢驗。</translation>
    </message>
    <message>
        <source>Bask has ended the program &quot;%1&quot;: %2. It starts it again. If this happens again, try it with &quot;bask check-device&quot;.</source>
        <translation>Bask 已結束程式「%1」：%2。它會重新啟動該程式。若再次發生，請以 &quot;bask check-device&quot; 檢驗。</translation>
    </message>
    <message>
        <source>the program &quot;%1&quot; has not answered for %2 s. Check the device behind it and its link.</source>
        <translation>程式「%1」已有 %2 s 未回應。請檢查其後的裝置及連線。</translation>
    </message>
    <message>
        <source>the program &quot;%1&quot; does not fit the rig: %2. Change the program, or the device on the Rig page.</source>
        <translation>程式「%1」與實驗台不符：%2。請更改程式，或在「實驗台」頁更改裝置。</translation>
    </message>
    <message>
        <source>the program &quot;%1&quot; refuses a command: %2. Remove the cause, clear the alarm of a robot, then reset.</source>
        <translation>程式「%1」拒絕命令：%2。請排除原因，清除機器人的警報，然後重設。</translation>
    </message>
    <message>
        <source>The robot does not move: %1. Remove the cause, clear the alarm, then reset.</source>
        <translation>機器人不動：%1。請排除原因，清除警報，然後重設。</translation>
    </message>
    <message>
        <source>The program &quot;%1&quot; is confirmed on this computer</source>
        <translation>程式「%1」已在本電腦上確認</translation>
    </message>
    <message>
        <source>the link to &quot;%1&quot; is in the hands of a person at the console: Bask takes it back 3 s after the last that is sent by hand.</source>
        <translation>與「%1」的連線正由主控台前的人使用：最後一次手動傳送 3 s 後，Bask 取回它。</translation>
    </message>
    <message>
        <source>The source was set to %1 but reads back %2, which is %3 times that: its numbers mean something else than its profile says. It is not heated. Set device and profile to the same scale, then reset.</source>
        <translation>熱源設定為 %1，但讀回 %2，是設定值的 %3 倍：它的數值含義與其設定檔所述不同。不對它加熱。請使裝置與設定檔的比例一致，然後復歸。</translation>
    </message>
    <message>
        <source>Sent by hand to &quot;%1&quot;: %2</source>
        <translation>手動傳送到「%1」：%2</translation>
    </message>
    <message>
        <source>monitoring: the broker %1 is not reached: %2</source>
        <translation>監視：無法連線到代理 %1：%2</translation>
    </message>
    <message>
        <source>monitoring: the broker %1 is too slow; %2 messages were left out</source>
        <translation>監視：代理 %1 太慢；有 %2 則訊息未傳送</translation>
    </message>
    <message>
        <source>monitoring: the status file is not written: %1</source>
        <translation>監視：狀態檔案未寫入：%1</translation>
    </message>
    <message>
        <source>others can read this file, which holds a password; let its owner alone read it (chmod 600)</source>
        <translation>其他人可以讀取這個含有密碼的檔案；請只讓其擁有者讀取（chmod 600）</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no address of a broker; give its name, with a colon and the port if that is not the usual one</source>
        <translation>「%1」不是代理的位址；請給出其名稱，若連接埠不是通常的連接埠，再加冒號和連接埠</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no topic: letters, digits, dots, hyphens and underscores in parts between slashes, at most 128 characters</source>
        <translation>「%1」不是主題：由斜線分隔的各部分只能含字母、數字、點、連字號和底線，最多 128 個字元</translation>
    </message>
    <message>
        <source>this installation of Bask cannot speak to a broker: %1</source>
        <translation>此 Bask 安裝無法與代理通訊：%1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no date; write year, month and day as in 2026-11-23</source>
        <translation>「%1」不是日期；請依 2026-11-23 的形式寫出年、月、日</translation>
    </message>
    <message>
        <source>two materials are named &quot;%1&quot;; give each its own name</source>
        <translation>兩種材料都名為「%1」；請給每種各自的名稱</translation>
    </message>
    <message>
        <source>The sensors of &quot;%1&quot; and &quot;%2&quot; were exchanged: they read %3 and %4 where %5 and %6 were expected. The heat is off. See that each is on its own object, confirm both, then reset.</source>
        <translation>「%1」和「%2」的感測器已互換：讀數為 %3 和 %4，而預期為 %5 和 %6。加熱已關閉。請確認每個感測器都在自己的物體上，分別確認兩者，然後復歸。</translation>
    </message>
    <message>
        <source>The objects are cold: the recording ends</source>
        <translation>物體均已冷卻：記錄結束</translation>
    </message>
    <message>
        <source>The recording after the run has ended before all was cold: the experiment was changed, another one was opened, a person has heated the source, or 6 h have passed.</source>
        <translation>運轉之後的記錄在一切冷卻之前已結束：實驗被修改、開啟了另一個實驗、有人手動加熱了熱源，或已過 6 h。</translation>
    </message>
    <message>
        <source>the thermal camera&apos;s place is not known well enough for so small an object; measure it on the Calibrate page, Place</source>
        <translation>對於這麼小的物體，熱像儀的位置不夠準確；請在「校正」頁的「位置」中測量</translation>
    </message>
    <message>
        <source>The target of &quot;%1&quot;, %2, is not what the thermal camera that reads it can tell: %3 to %4 with this emittance. Change the target, or let a sensor read the object.</source>
        <translation>「%1」的目標 %2 不在讀取它的熱像儀所能測的範圍內：以此發射率為 %3 至 %4。請更改目標，或改用感測器讀取該物體。</translation>
    </message>
    <message>
        <source>Ready in %1 s: the first readings are being collected.</source>
        <translation>%1 s 後就緒：正在擷取最初的讀數。</translation>
    </message>
    <message>
        <source>the order was not taken (simulated)</source>
        <translation>命令未被接受（模擬）</translation>
    </message>
    <message>
        <source>The sensors of &quot;%1&quot; and &quot;%2&quot; seem to be swapped: what they read in the last %3 s agrees with the heat of the other object, not with that of their own. The heat is off. Check both, confirm them, then reset.</source>
        <translation>「%1」和「%2」的感測器似乎互換了：它們最近 %3 s 的讀數與另一物體的受熱一致，而與自己物體的不一致。加熱已關閉。請檢查兩者，確認它們，然後復歸。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; warms by %2/s; the source explains at most %3/s: something else heats it, or its sensor is not on it. Bask switches the heat off. Check both, then reset.</source>
        <translation>「%1」以 %2/s 升溫；熱源最多能解釋 %3/s：有別的東西在加熱它，或其感測器不在它上面。Bask 將關閉加熱。請檢查兩者，然後復歸。</translation>
    </message>
    <message>
        <source>The source is at %1, %2 above its set point, and does not cool. Check its controller and its sensor; Stop takes the objects away and switches the heat off.</source>
        <translation>熱源為 %1，高於設定值 %2，且未降溫。請檢查其控制器和感測器；停止會將物體移開並關閉加熱。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is at %2, %3 from its target, and has gone farther from it for %4 s. Its sensor may be on another object, its outline or its mounting may be wrong, or something heats or cools it. The run goes on: check these.</source>
        <translation>「%1」為 %2，距目標 %3，且已持續遠離 %4 s。其感測器可能在別的物體上，其輪廓或安裝可能有誤，或有東西在加熱或冷卻它。執行仍在繼續：請檢查這些。</translation>
    </message>
    <message>
        <source>line %1: &lt;use&gt; draws &quot;%2&quot;, which is not in the drawing (no other file is opened); put it there, or take the &lt;use&gt; out</source>
        <translation>第 %1 行：&lt;use&gt; 繪製的「%2」不在圖形中（不會開啟其他檔案）；請把它放入圖形，或去掉該 &lt;use&gt;</translation>
    </message>
    <message>
        <source>line %1: the points of &lt;%2&gt; are damaged from &quot;%3&quot; on</source>
        <translation>第 %1 行：&lt;%2&gt; 的點從「%3」起已損壞</translation>
    </message>
    <message>
        <source>line %1: the %2 of &lt;%3&gt;, &quot;%4&quot;, is no length; write a number, with px, mm, cm, in, pt, pc or % if it has a unit</source>
        <translation>第 %1 行：&lt;%3&gt; 的 %2「%4」不是長度；請寫一個數字，有單位時加上 px、mm、cm、in、pt、pc 或 %</translation>
    </message>
    <message>
        <source>line %1: the transform of &lt;%2&gt; is damaged from &quot;%3&quot; on</source>
        <translation>第 %1 行：&lt;%2&gt; 的變換從「%3」起已損壞</translation>
    </message>
    <message>
        <source>a chessboard or the like: there are too many quadrangles to find a marker among them; cut the markers out</source>
        <translation>是棋盤格之類的圖片：四邊形太多，無法在其中找到標記；請把標記裁切出來</translation>
    </message>
    <message>
        <source>the file holds %1 frames of &quot;%2&quot; one after another; choose one by its number (thermal-frame --frame), or save one frame (%3 bytes) a file</source>
        <translation>該檔案依序包含「%2」的 %1 個影格；請按編號選擇一個影格（thermal-frame --frame），或每個檔案只儲存一個影格（%3 位元組）</translation>
    </message>
    <message>
        <source>the file holds %1 pictures; choose one by its number (thermal-frame --frame), or save one picture a file</source>
        <translation>該檔案包含 %1 幅影像；請按編號選擇一幅（thermal-frame --frame），或每個檔案只儲存一幅</translation>
    </message>
    <message>
        <source>its face reflects the source, whose place is not known; let the source be seen, or aim the camera at the backs of the objects</source>
        <translation>其表面反射熱源，而熱源的位置未知；請讓熱源可被看到，或將相機對準物體的背面</translation>
    </message>
    <message>
        <source>where &quot;%1&quot; has temperatures, this frame holds a plain picture; its halves are exchanged, or the camera sends no temperatures. Record it again as the camera sends it</source>
        <translation>在「%1」應有溫度之處，此影格是一般畫面；它的上下兩半被調換了，或相機沒有送出溫度。請按相機送出的原樣重新錄製</translation>
    </message>
    <message>
        <source>all pixels are between %1 and %2, as the bytes of a plain grey picture would be; make sure that the camera looks at something that hot</source>
        <translation>所有像素都在 %1 至 %2 之間，一般灰階畫面的位元組也會如此；請確認相機看的確實是這麼熱的東西</translation>
    </message>
    <message>
        <source>line %1 counts up by one, as a line of column numbers does, and nothing tells whether it is temperatures; name the camera&apos;s profile, whose size tells, or delete the line</source>
        <translation>第 %1 行逐個加一，與欄號的行一樣，無法判斷它是否是溫度；請指定相機的設定檔，由其尺寸判斷，或刪除該行</translation>
    </message>
    <message>
        <source>the first column counts up by one, as line numbers do, and nothing tells whether it is temperatures; name the camera&apos;s profile, whose size tells, or delete the column</source>
        <translation>第一欄逐個加一，與行號一樣，無法判斷它是否是溫度；請指定相機的設定檔，由其尺寸判斷，或刪除該欄</translation>
    </message>
    <message>
        <source>there is no frame %1: the file holds %2, counted from 1</source>
        <translation>沒有第 %1 個影格：該檔案有 %2 個影格，從 1 開始計數</translation>
    </message>
    <message>
        <source>the bytes are those of %1 frames of &quot;%2&quot; or, with its optional rows, of %3, and nothing tells which; save one frame a file</source>
        <translation>這些位元組可以是「%2」的 %1 個影格，或連同其可選列的 %3 個影格，無法判斷是哪一種；請每個檔案只儲存一個影格</translation>
    </message>
    <message>
        <source>it is a BigTIFF, which is not read; save it as an ordinary TIFF, or as PNG</source>
        <translation>這是 BigTIFF，不能讀取；請另存為一般 TIFF 或 PNG</translation>
    </message>
    <message>
        <source>case %1 is also in %2, with other bytes: one of the two parts was changed; leave it out, or delete it and run its shard again</source>
        <translation>案例 %1 在 %2 中也有，但位元組不同：兩個分片檔案之一被更動過；請不要列出它，或刪除它並重新執行其分片</translation>
    </message>
    <message>
        <source>warning limit of &quot;%1&quot;</source>
        <translation>「%1」的警告限值</translation>
    </message>
    <message>
        <source>trip limit of &quot;%1&quot;</source>
        <translation>「%1」的跳脫限值</translation>
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
        <translation>軸 %1</translation>
    </message>
    <message>
        <source>%1/s</source>
        <translation>%1/s</translation>
    </message>
    <message>
        <source>The robot&apos;s link is there, but the robot has reported or obeyed nothing for %1 s: its controller is busy, blocked or held. The heat is off. Look at the robot and its controller, then reset.</source>
        <translation>機器人的連線正常，但機器人已有 %1 s 沒有回報或執行任何內容：其控制器正忙、受阻或被停住。加熱已關閉。請查看機器人及其控制器，然後復歸。</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is at %2 and warms by %3/s with the heat off; the source explains at most %4/s. Something else heats it, or its sensor has just been put on it. Look at it before it reaches its limits.</source>
        <translation>「%1」為 %2，在加熱關閉時以 %3/s 升溫；熱源最多能解釋 %4/s。有別的東西在加熱它，或其感測器剛剛裝上。請在它達到限值之前查看。</translation>
    </message>
    <message>
        <source>The robot does not answer: %1. What it holds stays where it is, perhaps before a hot source. Check its link, then reset and retreat.</source>
        <translation>機器人無回應：%1。其所持物體停在原處，可能在高溫熱源前。請檢查其連線，然後復歸並撤離。</translation>
    </message>
    <message>
        <source>STOP was pressed: the robot stands still and the heat is off. What it holds stays where it is, perhaps before a hot source. Reset when it is safe, and retreat.</source>
        <translation>已按下「軟體停止」：機器人靜止，加熱已關閉。其所持物體停在原處，可能在高溫熱源前。確認安全後再復歸，並撤離。</translation>
    </message>
    <message>
        <source>simulated fault removed: %1</source>
        <translation>模擬故障已移除：%1</translation>
    </message>
    <message>
        <source>The sensor of &quot;%1&quot; reads %2. By now the object may be anywhere from %3 to %4, where its wrong readings were too, so Bask cannot tell whether this one is right. Check that the sensor is on its object, then confirm it.</source>
        <translation>「%1」的感測器讀數為 %2。此時物體可能在 %3 至 %4 之間的任何溫度，其錯誤讀數也在此範圍內，因此 Bask 無法判斷這個讀數是否正確。請檢查感測器是否在物體上，然後確認。</translation>
    </message>
    <message>
        <source>The temperature of &quot;%1&quot; does not follow its heat: in %3 s it changed by %4 where %2, or more in that direction, was due. Its sensor may be off or on another object, the object may be gone, or the source may be elsewhere than expected. Bask switches the heat off. Check these, then reset.</source>
        <translation>「%1」的溫度未隨其受熱變化：%3 s 內變化了 %4，而應為 %2，或沿該方向更多。其感測器可能脫落或在另一物體上，物體可能已不在，或熱源不在預期位置。Bask 將關閉加熱。請檢查這些，然後復歸。</translation>
    </message>
    <message>
        <source>The temperature of &quot;%1&quot; does not follow its heat: in %3 s it changed by %4 where %2, or more in that direction, was due, and &quot;%5&quot; deviates the other way. Their sensors may be swapped, or that of &quot;%1&quot; is off. Bask switches the heat off. Check both, then reset.</source>
        <translation>「%1」的溫度未隨其受熱變化：%3 s 內變化了 %4，而應為 %2，或沿該方向更多，且「%5」向相反方向偏離。兩者的感測器可能互換了，或「%1」的感測器脫落。Bask 將關閉加熱。請檢查兩者，然後復歸。</translation>
    </message>
</context>
<context>
    <name>OutlinePainting</name>
    <message>
        <source>1 harmonic</source>
        <translation>1 個諧波</translation>
    </message>
    <message>
        <source>%1 harmonics</source>
        <translation>%1 個諧波</translation>
    </message>
    <message>
        <source>1 hole</source>
        <translation>1 個孔</translation>
    </message>
    <message>
        <source>%1 holes</source>
        <translation>%1 個孔</translation>
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
        <translation>物體：警告</translation>
    </message>
    <message>
        <source>A run holds, and a priority 2 alarm is given</source>
        <translation>運轉進入保持，並發出優先順序 2 的警報</translation>
    </message>
    <message>
        <source>Objects: trip</source>
        <translation>物體：跳脫</translation>
    </message>
    <message>
        <source>Heat off and retreat. What object, paint and sensor bear.</source>
        <translation>關閉加熱並撤離。按物體、塗層和感測器所能承受的溫度設定。</translation>
    </message>
    <message>
        <source>Source: trip</source>
        <translation>熱源：跳脫</translation>
    </message>
    <message>
        <source>Heat off and retreat. Automatic: 50 K over the highest set point.</source>
        <translation>關閉加熱並撤離。自動：比最高設定值高 50 K。</translation>
    </message>
    <message>
        <source>Periods a reading is good for</source>
        <translation>讀數有效的週期數</translation>
    </message>
    <message>
        <source>A sensor without a newer one is lost; also the source and its place</source>
        <translation>超過此時間沒有更新的感測器即視為失聯；熱源及其位置亦然</translation>
    </message>
    <message>
        <source>Longest hold</source>
        <translation>最長保持時間</translation>
    </message>
    <message>
        <source>A lost sensor or source holds the run so long, then it ends with a retreat</source>
        <translation>失去感測器或熱源時，運轉保持這麼久，然後撤離並結束</translation>
    </message>
    <message>
        <source>Fastest plausible change</source>
        <translation>最快合理變化</translation>
    </message>
    <message>
        <source>Faster readings are a jump, and no heat. Automatic: three times what the source can do to the object, 2 K/s at least.</source>
        <translation>更快的讀數是跳變，而非受熱所致。自動：熱源使物體所能達到的變化的三倍，至少 2 K/s。</translation>
    </message>
    <message>
        <source>Jumps in a row</source>
        <translation>連續跳變次數</translation>
    </message>
    <message>
        <source>So many readings that are too fast are a sensor fault</source>
        <translation>過快的讀數達到此數即為感測器故障</translation>
    </message>
    <message>
        <source>Frozen sensor after</source>
        <translation>感測器凍結判定時間</translation>
    </message>
    <message>
        <source>The very same reading for so long, though the object must have changed</source>
        <translation>物體本應變化，而讀數在此時間內完全相同</translation>
    </message>
    <message>
        <source>Change that must be seen</source>
        <translation>必須見到的變化</translation>
    </message>
    <message>
        <source>An object that must have changed by so much and did not does not follow its heat</source>
        <translation>物體本應變化這麼多卻沒有變化，即為不隨加熱而變</translation>
    </message>
    <message>
        <source>Sensors apart when cold</source>
        <translation>冷態時感測器間差異</translation>
    </message>
    <message>
        <source>Sensors of a cold rig that differ by more are told</source>
        <translation>冷態實驗台中差異超過此值的感測器會被指出</translation>
    </message>
    <message>
        <source>Source: time to gain 2 K</source>
        <translation>熱源：升溫 2 K 的時間</translation>
    </message>
    <message>
        <source>A source that is too cold and no nearer after so long does not heat</source>
        <translation>熱源溫度過低，且經過此時間仍未接近設定值，即為不加熱</translation>
    </message>
    <message>
        <source>Source: near its set point</source>
        <translation>熱源：接近設定值</translation>
    </message>
    <message>
        <source>Within this the source is not too cold</source>
        <translation>在此範圍內，熱源不算溫度過低</translation>
    </message>
    <message>
        <source>Source: warming unasked</source>
        <translation>熱源：擅自升溫</translation>
    </message>
    <message>
        <source>More warming with the heat off is an alarm</source>
        <translation>加熱關閉時升溫超過此值即警報</translation>
    </message>
    <message>
        <source>Least room on the disk</source>
        <translation>磁碟最小剩餘空間</translation>
    </message>
    <message>
        <source>With less no recording is begun</source>
        <translation>少於此值時不開始記錄</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>Trip</source>
        <translation>跳脫</translation>
    </message>
    <message>
        <source>Emittance</source>
        <translation>發射率</translation>
    </message>
    <message>
        <source>Absorptance</source>
        <translation>吸收率</translation>
    </message>
    <message>
        <source>Specific heat</source>
        <translation>比熱</translation>
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
        <translation>最大轉動速度</translation>
    </message>
    <message>
        <source>Largest acceleration</source>
        <translation>最大加速度</translation>
    </message>
    <message>
        <source>Largest turning acceleration</source>
        <translation>最大轉動加速度</translation>
    </message>
    <message>
        <source>Clearance to the source</source>
        <translation>與熱源的間距</translation>
    </message>
    <message>
        <source>Least distance of any point of an object from the source&apos;s plane</source>
        <translation>物體上任意一點到熱源平面的最小距離</translation>
    </message>
    <message>
        <source>Largest mounting radius</source>
        <translation>最大安裝半徑</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>無限制</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>自動</translation>
    </message>
    <message>
        <source>heat without a watchdog</source>
        <translation>無看門狗加熱</translation>
    </message>
    <message>
        <source>not allowed</source>
        <translation>不允許</translation>
    </message>
    <message>
        <source>allowed</source>
        <translation>允許</translation>
    </message>
    <message>
        <source>Time constant</source>
        <translation>時間常數</translation>
    </message>
    <message>
        <source>Wanted rate = error / time constant: shorter is faster and rougher.</source>
        <translation>期望變化率 = 誤差 / 時間常數：越短則越快、越不平穩。</translation>
    </message>
    <message>
        <source>Integral time</source>
        <translation>積分時間</translation>
    </message>
    <message>
        <source>Of the slow integral action near the target.</source>
        <translation>目標附近緩慢積分作用的時間。</translation>
    </message>
    <message>
        <source>Damping D</source>
        <translation>阻尼 D</translation>
    </message>
    <message>
        <source>Stiffness K</source>
        <translation>剛性 K</translation>
    </message>
    <message>
        <source>Weight of the error μ</source>
        <translation>誤差權重 μ</translation>
    </message>
    <message>
        <source>ζ = v + μ Δτ</source>
        <translation>ζ = v + μ Δτ</translation>
    </message>
    <message>
        <source>Feedback K</source>
        <translation>回饋 K</translation>
    </message>
    <message>
        <source>Of ζ in the velocity command</source>
        <translation>速度指令中 ζ 的係數</translation>
    </message>
    <message>
        <source>Adaptation γ₁</source>
        <translation>自適應 γ₁</translation>
    </message>
    <message>
        <source>Speed at which 1/λ₁ is adapted</source>
        <translation>1/λ₁ 的自適應速度</translation>
    </message>
    <message>
        <source>Adaptation γ₂</source>
        <translation>自適應 γ₂</translation>
    </message>
    <message>
        <source>Speed at which λ₂/λ₁ is adapted</source>
        <translation>λ₂/λ₁ 的自適應速度</translation>
    </message>
    <message>
        <source>dv/dt = −D v − K Δτ</source>
        <translation>dv/dt = −D v − K Δτ</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>單元</translation>
    </message>
    <message>
        <source>The device&apos;s Modbus address</source>
        <translation>裝置的 Modbus 位址</translation>
    </message>
    <message>
        <source>Watchdog</source>
        <translation>看門狗</translation>
    </message>
    <message>
        <source>The device switches its heat off when it has heard nothing for so long</source>
        <translation>裝置若在這段時間內沒有收到任何資訊，就自行關閉加熱</translation>
    </message>
    <message>
        <source>Convection h</source>
        <translation>對流係數 h</translation>
    </message>
    <message>
        <source>What the air takes from an object&apos;s face, by its temperature above the room</source>
        <translation>空氣從物體表面帶走的熱量，依其高於室溫的溫度計</translation>
    </message>
    <message>
        <source>a figure drawn by Bask</source>
        <translation>Bask 繪製的圖</translation>
    </message>
    <message>
        <source>a report written by Bask</source>
        <translation>Bask 寫出的報告</translation>
    </message>
    <message>
        <source>a table written by Bask</source>
        <translation>Bask 寫出的表格</translation>
    </message>
    <message>
        <source>a comparison written by Bask</source>
        <translation>Bask 寫出的比較</translation>
    </message>
    <message>
        <source>a NeXus file written by Bask</source>
        <translation>Bask 寫出的 NeXus 檔案</translation>
    </message>
    <message>
        <source>lines written by Bask</source>
        <translation>Bask 寫出的線條檔案</translation>
    </message>
    <message>
        <source>a collection written by Bask</source>
        <translation>Bask 寫出的集合檔案</translation>
    </message>
    <message>
        <source>a field written by Bask</source>
        <translation>Bask 寫出的場檔案</translation>
    </message>
    <message>
        <source>a surface file written by Bask</source>
        <translation>Bask 寫出的曲面檔案</translation>
    </message>
    <message>
        <source>it is written to again and again</source>
        <translation>它不斷被寫入</translation>
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
        <translation>θx 軸</translation>
    </message>
    <message>
        <source>theta y</source>
        <translation>θy 軸</translation>
    </message>
    <message>
        <source>theta z</source>
        <translation>θz 軸</translation>
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
        <translation>x %1，y %2，z %3；繞 x、y、z 轉動 %4、%5、%6</translation>
    </message>
</context>
<context>
    <name>State</name>
    <message>
        <source>Idle</source>
        <translation>空閒</translation>
    </message>
    <message>
        <source>Not ready</source>
        <translation>未就緒</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>就緒</translation>
    </message>
    <message>
        <source>Armed</source>
        <translation>待命中</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>運轉中</translation>
    </message>
    <message>
        <source>Holding</source>
        <translation>保持中</translation>
    </message>
    <message>
        <source>Settled</source>
        <translation>已穩定</translation>
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
        <translation>故障（已閂鎖）</translation>
    </message>
    <message>
        <source>Connecting</source>
        <translation>正在連線</translation>
    </message>
    <message>
        <source>Homing</source>
        <translation>正在回原點</translation>
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
        <translation>開始</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>保持</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>繼續</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>復歸</translation>
    </message>
    <message>
        <source>Retreat</source>
        <translation>撤離</translation>
    </message>
    <message>
        <source>Set targets</source>
        <translation>設定目標</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>移動</translation>
    </message>
    <message>
        <source>Jog</source>
        <translation>寸動</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>回原點</translation>
    </message>
    <message>
        <source>Heat</source>
        <translation>加熱</translation>
    </message>
    <message>
        <source>Confirm sensor</source>
        <translation>確認感測器</translation>
    </message>
    <message>
        <source>Clear alarm</source>
        <translation>清除警報</translation>
    </message>
    <message>
        <source>Shelve</source>
        <translation>擱置</translation>
    </message>
    <message>
        <source>Unshelve</source>
        <translation>取消擱置</translation>
    </message>
</context>
<context>
    <name>bask::Actions</name>
    <message>
        <source>&amp;File</source>
        <translation>檔案(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Examples</source>
        <translation>範例(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Recent files</source>
        <translation>最近的檔案(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>編輯(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>幫助(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;New experiment</source>
        <translation>新增實驗(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>開啟(&amp;O)…</translation>
    </message>
    <message>
        <source>Open an experiment (*.json) or a recorded session (*.bask)</source>
        <translation>開啟實驗（*.json）或記錄的工作階段（*.bask）</translation>
    </message>
    <message>
        <source>&amp;Save experiment</source>
        <translation>儲存實驗(&amp;S)</translation>
    </message>
    <message>
        <source>Save experiment &amp;as…</source>
        <translation>另存實驗(&amp;A)…</translation>
    </message>
    <message>
        <source>Save sess&amp;ion…</source>
        <translation>儲存工作階段(&amp;I)…</translation>
    </message>
    <message>
        <source>Copy the recording of the present or last run to a file of your choice</source>
        <translation>將目前或上一次運轉的記錄複製到您選擇的檔案</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>結束(&amp;Q)</translation>
    </message>
    <message>
        <source>&amp;About Bask</source>
        <translation>關於 Bask(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>運轉(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Arm</source>
        <translation>待命(&amp;A)</translation>
    </message>
    <message>
        <source>Zero the sensors at ambient and open the recording. Nothing moves or heats yet.</source>
        <translation>在環境溫度下將感測器歸零，並開啟記錄。此時沒有運動，也不加熱。</translation>
    </message>
    <message>
        <source>S&amp;tart</source>
        <translation>開始(&amp;T)</translation>
    </message>
    <message>
        <source>Open the heat and servo every object to its target.</source>
        <translation>開啟加熱，並將每個物體伺服到其目標。</translation>
    </message>
    <message>
        <source>&amp;Hold</source>
        <translation>保持(&amp;H)</translation>
    </message>
    <message>
        <source>Zero velocity; the controller keeps its state and Resume goes on from here.</source>
        <translation>速度為零；控制器保留其狀態，按「繼續」從此處接著運轉。</translation>
    </message>
    <message>
        <source>R&amp;esume</source>
        <translation>繼續(&amp;E)</translation>
    </message>
    <message>
        <source>Go on from where the run was held.</source>
        <translation>從運轉被保持之處繼續。</translation>
    </message>
    <message>
        <source>Sto&amp;p</source>
        <translation>停止(&amp;P)</translation>
    </message>
    <message>
        <source>End the run: heat off, retreat upwards, close the recording. While armed: disarm.</source>
        <translation>結束運轉：關閉加熱，向上撤離，關閉記錄。待命時：解除待命。</translation>
    </message>
    <message>
        <source>STOP now</source>
        <translation>立即軟體停止</translation>
    </message>
    <message>
        <source>Zero velocity and heat off now, latched. A software stop, not a safety-rated emergency stop.</source>
        <translation>立即使速度為零並關閉加熱，並閂鎖。這是軟體停止，不是安全等級的緊急停止。</translation>
    </message>
    <message>
        <source>Re&amp;set</source>
        <translation>復歸(&amp;S)</translation>
    </message>
    <message>
        <source>Clear a latched stop or fault. It never starts anything.</source>
        <translation>解除閂鎖的停止或故障。此操作絕不會啟動任何東西。</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>檢視(&amp;V)</translation>
    </message>
    <message>
        <source>Objects</source>
        <translation>物體</translation>
    </message>
    <message>
        <source>Targets</source>
        <translation>目標</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>運轉</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>回顧</translation>
    </message>
    <message>
        <source>What is held in front of the source: outlines, materials, mounting</source>
        <translation>熱源前所持的物體：輪廓、材料、安裝</translation>
    </message>
    <message>
        <source>What temperature each object shall have, and whether it can be reached</source>
        <translation>每個物體應達到的溫度，以及能否達到</translation>
    </message>
    <message>
        <source>Temperatures, the scene and the controller during a run</source>
        <translation>運轉中的溫度、場景和控制器</translation>
    </message>
    <message>
        <source>A recorded run, opened again</source>
        <translation>重新開啟的已記錄運轉</translation>
    </message>
    <message>
        <source>Temperature &amp;unit</source>
        <translation>溫度單位(&amp;U)</translation>
    </message>
    <message>
        <source>Degrees Celsius (°C)</source>
        <translation>攝氏度（°C）</translation>
    </message>
    <message>
        <source>Kelvin (K)</source>
        <translation>克耳文（K）</translation>
    </message>
    <message>
        <source>Degrees Fahrenheit (°F)</source>
        <translation>華氏度（°F）</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>主題(&amp;T)</translation>
    </message>
    <message>
        <source>As the desktop</source>
        <translation>依桌面設定</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>淺色</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>深色</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>語言(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Tools</source>
        <translation>工具(&amp;T)</translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation>校正</translation>
    </message>
    <message>
        <source>The camera: its lens, where it stands, and where the source is</source>
        <translation>相機：其鏡頭、所在位置，以及熱源的位置</translation>
    </message>
    <message>
        <source>Rig</source>
        <translation>實驗台</translation>
    </message>
    <message>
        <source>The devices, what must be so before a run, and the robot and the heat by hand</source>
        <translation>裝置、運轉前必須滿足的條件，以及機器人和加熱的手動操作</translation>
    </message>
    <message>
        <source>Ac&amp;knowledge all alarms</source>
        <translation>確認所有警報(&amp;K)</translation>
    </message>
    <message>
        <source>You have seen all alarms. Those that are over leave the list. (F9)</source>
        <translation>表示您已看到所有警報。已解除的警報將從清單中移除。（F9）</translation>
    </message>
    <message>
        <source>&amp;Clear the list</source>
        <translation>清空清單(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>手冊(&amp;M)</translation>
    </message>
    <message>
        <source>Report a &amp;problem…</source>
        <translation>回報問題(&amp;P)…</translation>
    </message>
    <message>
        <source>The &amp;first five minutes</source>
        <translation>最初五分鐘(&amp;F)</translation>
    </message>
    <message>
        <source>Te&amp;xt size</source>
        <translation>文字大小(&amp;X)</translation>
    </message>
    <message>
        <source>&amp;Retreat…</source>
        <translation>撤離(&amp;R)…</translation>
    </message>
    <message>
        <source>The robot takes the objects away from the source and the heat goes off, in every state in which the robot answers. A fault stays latched.</source>
        <translation>機器人使物體離開熱源，並關閉加熱；只要機器人有回應，在任何狀態下都可以。故障仍保持閂鎖。</translation>
    </message>
    <message>
        <source>End the re&amp;cording</source>
        <translation>結束記錄(&amp;C)</translation>
    </message>
    <message>
        <source>After a stop or a fault the recording goes on until everything is cold. This ends it now.</source>
        <translation>停止或故障之後，記錄會繼續到一切冷卻為止。此命令立即結束記錄。</translation>
    </message>
    <message>
        <source>Alarm &amp;horn</source>
        <translation>警報聲(&amp;H)</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>關閉</translation>
    </message>
    <message>
        <source>On a real rig</source>
        <translation>僅實機</translation>
    </message>
    <message>
        <source>Always</source>
        <translation>始終</translation>
    </message>
    <message>
        <source>The desktop&apos;s bell, until alarms of priority 1 and 2 are acknowledged or over; once for priority 3</source>
        <translation>桌面的提示音，直到優先級 1 和 2 的警報被確認或結束；優先順序 3 只響一次</translation>
    </message>
    <message>
        <source>&amp;Operator and sample…</source>
        <translation>操作員和樣品(&amp;O)…</translation>
    </message>
    <message>
        <source>Who operates, and what is heated: recordings, reports and the list of runs show it.</source>
        <translation>誰在操作，加熱的是什麼：記錄、報告和運轉清單都會顯示。</translation>
    </message>
    <message>
        <source>&amp;Monitoring…</source>
        <translation>監視(&amp;M)…</translation>
    </message>
    <message>
        <source>Large &amp;numbers</source>
        <translation>大型數字(&amp;N)</translation>
    </message>
    <message>
        <source>Ho&amp;me the robot…</source>
        <translation>機器人回原點(&amp;M)…</translation>
    </message>
    <message>
        <source>All &amp;alarms…</source>
        <translation>所有警報(&amp;A)…</translation>
    </message>
    <message>
        <source>The alarms of all recorded runs, with how often and when</source>
        <translation>所有已記錄運轉的警報，及其次數和時間</translation>
    </message>
    <message>
        <source>The robot seeks its switches to know its place: it moves</source>
        <translation>機器人尋找其極限開關以確定位置：它會移動</translation>
    </message>
</context>
<context>
    <name>bask::AirForm</name>
    <message>
        <source>The simulated rig has natural convection.</source>
        <translation>模擬實驗台有自然對流。</translation>
    </message>
    <message>
        <source>The simulated rig has h = %1 W/(m² K).</source>
        <translation>模擬實驗台的 h = %1 W/(m² K)。</translation>
    </message>
    <message>
        <source>Natural convection would take some %1 % of what “%2” loses at %3.</source>
        <translation>在 %3 時，自然對流約占「%2」損失的 %1 %。</translation>
    </message>
    <message>
        <source>Takes %1 % of what “%2” loses at %3, with h = %4 W/(m² K).</source>
        <translation>在 %3 時占「%2」損失的 %1 %，h = %4 W/(m² K)。</translation>
    </message>
    <message>
        <source>Air in the room</source>
        <translation>室內空氣</translation>
    </message>
    <message>
        <source>Convection, for all objects</source>
        <translation>對流，適用於所有物體</translation>
    </message>
    <message>
        <source>What verdicts, predictions and controllers take the air to be; it has the temperature of the room</source>
        <translation>判定、預測和控制器所假定的空氣；其溫度為室溫</translation>
    </message>
    <message>
        <source>not known, not counted</source>
        <translation>未知，未計入</translation>
    </message>
    <message>
        <source>h is given</source>
        <translation>給定 h</translation>
    </message>
    <message>
        <source>natural, by correlation</source>
        <translation>自然對流，依關聯式</translation>
    </message>
</context>
<context>
    <name>bask::AlarmButton</name>
    <message>
        <source>Alarm of priority %1 (%2): %3</source>
        <translation>優先順序 %1 的警報（%2）：%3</translation>
    </message>
    <message>
        <source>%1 more.</source>
        <translation>另有 %1 個。</translation>
    </message>
    <message>
        <source>This may be old: the engine is not answering.</source>
        <translation>可能已過時：引擎沒有回應。</translation>
    </message>
</context>
<context>
    <name>bask::AlarmHistoryDialog</name>
    <message>
        <source>Priority %1: %2</source>
        <translation>優先順序 %1：%2</translation>
    </message>
    <message>
        <source>SIMULATED</source>
        <translation>模擬</translation>
    </message>
    <message>
        <source>LIVE</source>
        <translation>實機</translation>
    </message>
    <message>
        <source>Reading the runs: %1 %</source>
        <translation>正在讀取運轉：%1 %</translation>
    </message>
    <message>
        <source>The list has no run.</source>
        <translation>清單中沒有運轉。</translation>
    </message>
    <message numerus="yes">
        <source>No alarm was raised in %n run(s).</source>
        <translation>
            <numerusform>%n 次運轉中沒有出現警報。</numerusform>
        </translation>
    </message>
    <message>
        <source>No alarm matches &quot;%1&quot;.</source>
        <translation>沒有符合「%1」的警報。</translation>
    </message>
    <message numerus="yes">
        <source>Alarms in %1 of %n run(s)</source>
        <translation>
            <numerusform>%n 次運轉中有 %1 次出現警報</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n recording(s) could not be read: %1</source>
        <translation>
            <numerusform>%n 個記錄無法讀取：%1</numerusform>
        </translation>
    </message>
    <message>
        <source>Alarms of the listed runs</source>
        <translation>所列運轉的警報</translation>
    </message>
    <message>
        <source>Filter the alarms</source>
        <translation>篩選警報</translation>
    </message>
    <message>
        <source>Shows the alarms that have every word.</source>
        <translation>顯示含有全部字詞的警報。</translation>
    </message>
    <message>
        <source>Alarm</source>
        <translation>警報</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>運轉次數</translation>
    </message>
    <message>
        <source>Times</source>
        <translation>次數</translation>
    </message>
    <message>
        <source>Active</source>
        <translation>有效時間</translation>
    </message>
    <message>
        <source>Last raised</source>
        <translation>最近出現</translation>
    </message>
    <message>
        <source>Last run</source>
        <translation>最近的運轉</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>警報</translation>
    </message>
    <message>
        <source>As it was raised the last time</source>
        <translation>最近一次出現時的內容</translation>
    </message>
    <message>
        <source>Number of runs in which it was raised</source>
        <translation>出現該警報的運轉次數</translation>
    </message>
    <message>
        <source>How often it was raised</source>
        <translation>出現的次數</translation>
    </message>
    <message>
        <source>Recorded</source>
        <translation>記錄時間</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>運轉</translation>
    </message>
    <message>
        <source>Rig</source>
        <translation>實驗台</translation>
    </message>
    <message>
        <source>Raised at</source>
        <translation>出現於</translation>
    </message>
    <message>
        <source>Runs of the selected alarm</source>
        <translation>所選警報的運轉</translation>
    </message>
    <message>
        <source>Time since Start</source>
        <translation>自「開始」起的時間</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>複製</translation>
    </message>
    <message>
        <source>Copy the alarms as text, for a spreadsheet</source>
        <translation>將警報作為文字複製，供試算表使用</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>開啟</translation>
    </message>
    <message>
        <source>Open the selected run</source>
        <translation>開啟所選運轉</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>關閉</translation>
    </message>
    <message>
        <source>%1. Only %2 of %3 alarms are shown, the gravest.</source>
        <comment>%1: Alarms in 2 of 5 runs</comment>
        <translation>%1。只顯示 %3 個警報中最嚴重的 %2 個。</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <comment>a run: its name, and when it was recorded</comment>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>Priority</source>
        <translation>優先順序</translation>
    </message>
    <message>
        <source>1 is the gravest</source>
        <translation>1 為最嚴重</translation>
    </message>
    <message>
        <source>Opens the run at the moment when the alarm was last raised in it</source>
        <translation>開啟該次運轉，停在警報在其中最近一次出現的時刻</translation>
    </message>
    <message>
        <source>%1 + %2</source>
        <comment>when a run was recorded, and the time in it</comment>
        <translation>%1 + %2</translation>
    </message>
    <message>
        <source>When the last run with it was recorded, and the time since Start when it was raised</source>
        <translation>最近一次出現該警報的運轉的記錄時刻，以及警報出現時自「開始」起的時間</translation>
    </message>
    <message>
        <source>No run</source>
        <translation>無運轉</translation>
    </message>
    <message>
        <source>Raised while nothing was recorded</source>
        <translation>在沒有進行記錄時出現</translation>
    </message>
    <message numerus="yes">
        <source>%1, and %n time(s) while nothing was recorded</source>
        <comment>%1: Alarms in 2 of 5 runs</comment>
        <translation>
            <numerusform>%1，另有 %n 次在沒有進行記錄時出現</numerusform>
        </translation>
    </message>
    <message>
        <source>The alarms that were raised while nothing was recorded could not be read.</source>
        <translation>沒有進行記錄時出現的警報無法讀取。</translation>
    </message>
    <message numerus="yes">
        <source>%n line(s) with alarms that were raised while nothing was recorded could not be read.</source>
        <translation>
            <numerusform>%n 列沒有進行記錄時出現的警報無法讀取。</numerusform>
        </translation>
    </message>
    <message>
        <source>Without a run, when the alarm was raised</source>
        <translation>沒有運轉時，為警報出現的時間</translation>
    </message>
    <message>
        <source>at least %1</source>
        <comment>a duration: minutes and seconds</comment>
        <translation>至少 %1</translation>
    </message>
    <message>
        <source>Time for which it was active, until it was over or reset. &quot;At least&quot;: a recording ended before it, or the end of one of its times is not known.</source>
        <translation>有效的時間，到它結束或被復歸為止。「至少」：某個記錄在它之前結束，或其中一次的結束不明。</translation>
    </message>
</context>
<context>
    <name>bask::AlarmList</name>
    <message>
        <source>Priority %1</source>
        <translation>優先順序 %1</translation>
    </message>
    <message>
        <source>Priority %1. %2.</source>
        <translation>優先順序 %1。%2。</translation>
    </message>
    <message>
        <source>%1×</source>
        <translation>%1×</translation>
    </message>
    <message>
        <source>No alarms.</source>
        <translation>沒有警報。</translation>
    </message>
    <message>
        <source>Choose an alarm to read what to do.</source>
        <translation>選擇一個警報，檢視處理方法。</translation>
    </message>
    <message>
        <source>Raised at %1, %2 times since it was last acknowledged.</source>
        <translation>出現於 %1，自上次確認以來共 %2 次。</translation>
    </message>
    <message>
        <source>Raised at %1.</source>
        <translation>出現於 %1。</translation>
    </message>
    <message>
        <source>Over at %1.</source>
        <translation>解除於 %1。</translation>
    </message>
    <message>
        <source>The first of those that came together: likely their cause.</source>
        <translation>同時出現的警報中的首個：很可能是其餘警報的原因。</translation>
    </message>
    <message>
        <source>It was active when Bask was last left.</source>
        <translation>上次結束 Bask 時它仍在作用中。</translation>
    </message>
    <message>
        <source>The engine is not answering: these alarms may be old.</source>
        <translation>引擎沒有回應：這些警報可能已過時。</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>警報</translation>
    </message>
    <message>
        <source>Priority</source>
        <translation>優先順序</translation>
    </message>
    <message>
        <source>State</source>
        <translation>狀態</translation>
    </message>
    <message>
        <source>Raised</source>
        <translation>出現</translation>
    </message>
    <message>
        <source>Times</source>
        <translation>次數</translation>
    </message>
    <message>
        <source>What is wrong</source>
        <translation>問題</translation>
    </message>
    <message>
        <source>What to do about the alarm</source>
        <translation>警報的處理方法</translation>
    </message>
    <message>
        <source>Acknowledge</source>
        <translation>確認</translation>
    </message>
    <message>
        <source>You have seen this alarm. It stays in the list while its condition holds.</source>
        <translation>表示您已看到此警報。只要其條件仍存在，它就留在清單中。</translation>
    </message>
    <message>
        <source>Acknowledge all</source>
        <translation>全部確認</translation>
    </message>
    <message>
        <source>You have seen all alarms. Those that are over leave the list.</source>
        <translation>表示您已看到所有警報。已解除的警報將從清單中移除。</translation>
    </message>
    <message>
        <source>Shelved: %1</source>
        <translation>已擱置：%1</translation>
    </message>
    <message numerus="yes">
        <source>, %n follow(s)</source>
        <comment>from this alarm</comment>
        <translation>
            <numerusform>，引發 %n 個</numerusform>
        </translation>
    </message>
    <message>
        <source>It follows from the alarm over it, and goes with that.</source>
        <translation>它由上面的警報引發，並隨之消失。</translation>
    </message>
    <message>
        <source>Take the alarm back from the shelf</source>
        <translation>取回已擱置的警報</translation>
    </message>
    <message>
        <source>Shelve: put the alarm aside for a time, with a reason</source>
        <translation>擱置：將警報暫時放在一邊，須說明理由</translation>
    </message>
    <message>
        <source>All alarms…</source>
        <translation>所有警報…</translation>
    </message>
    <message>
        <source>Unshelve</source>
        <translation>取消擱置</translation>
    </message>
    <message>
        <source>Shelve…</source>
        <translation>擱置…</translation>
    </message>
</context>
<context>
    <name>bask::AlarmWords</name>
    <message>
        <source>Active</source>
        <translation>作用中</translation>
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
        <translation>首個</translation>
    </message>
    <message>
        <source>from before</source>
        <translation>先前遺留</translation>
    </message>
    <message>
        <source>, </source>
        <comment>between states</comment>
        <translation>，</translation>
    </message>
    <message>
        <source>Shelved until %1: %2</source>
        <translation>擱置至 %1：%2</translation>
    </message>
    <message>
        <source>seen by %1</source>
        <translation>%1 已看到</translation>
    </message>
    <message>
        <source>Shelved until %1 by %3: %2</source>
        <translation>由 %3 擱置至 %1：%2</translation>
    </message>
</context>
<context>
    <name>bask::AxisTable</name>
    <message>
        <source>Axis</source>
        <translation>軸</translation>
    </message>
    <message>
        <source>Where the axis reads zero</source>
        <translation>該軸讀數為零之處</translation>
    </message>
    <message>
        <source>Axis that drives %1</source>
        <translation>驅動 %1 的軸</translation>
    </message>
    <message>
        <source>reversed</source>
        <translation>反向</translation>
    </message>
    <message>
        <source>The axis of %1 counts the other way</source>
        <translation>%1 的軸計數方向相反</translation>
    </message>
    <message>
        <source>%1 where its axis reads zero</source>
        <translation>該軸讀數為零時的 %1</translation>
    </message>
</context>
<context>
    <name>bask::BeliefText</name>
    <message>
        <source>The controller begins with heat rates wrong by up to ×%1, as the experiment asks.</source>
        <translation>依實驗的要求，控制器起始時所用的熱速率有誤，誤差最大為 %1 倍。</translation>
    </message>
</context>
<context>
    <name>bask::BoardForm</name>
    <message>
        <source>&amp;Board</source>
        <translation>校正板(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Dictionary</source>
        <translation>字典(&amp;D)</translation>
    </message>
    <message>
        <source>As measured on the print: over ten squares, divided by ten.</source>
        <translation>按列印稿實測：測十個方格的長度，再除以十。</translation>
    </message>
    <message>
        <source>Boards made by OpenCV before 4.6 with an even number of rows.</source>
        <translation>由 4.6 之前的 OpenCV 產生、列數為偶數的校正板。</translation>
    </message>
    <message>
        <source>ChArUco board</source>
        <translation>ChArUco 板</translation>
    </message>
    <message>
        <source>Chessboard</source>
        <translation>棋盤格</translation>
    </message>
    <message>
        <source>Dictionary of the markers</source>
        <translation>標記的字典</translation>
    </message>
    <message>
        <source>Inner cor&amp;ners</source>
        <translation>內角點(&amp;N)</translation>
    </message>
    <message>
        <source>Inner corners across</source>
        <translation>橫向內角點數</translation>
    </message>
    <message>
        <source>Inner corners down</source>
        <translation>縱向內角點數</translation>
    </message>
    <message>
        <source>Kind of board</source>
        <translation>校正板類型</translation>
    </message>
    <message>
        <source>Lower left square is black</source>
        <translation>左下角方格為黑色</translation>
    </message>
    <message>
        <source>S&amp;ide of a square</source>
        <translation>方格邊長(&amp;I)</translation>
    </message>
    <message>
        <source>S&amp;quares</source>
        <translation>方格數(&amp;Q)</translation>
    </message>
    <message>
        <source>Side of a &amp;marker</source>
        <translation>標記邊長(&amp;M)</translation>
    </message>
    <message>
        <source>Side of a marker</source>
        <translation>標記邊長</translation>
    </message>
    <message>
        <source>Side of a square</source>
        <translation>方格邊長</translation>
    </message>
    <message>
        <source>Squares across</source>
        <translation>橫向方格數</translation>
    </message>
    <message>
        <source>Squares down</source>
        <translation>縱向方格數</translation>
    </message>
    <message>
        <source>With its black border, as measured on the print.</source>
        <translation>含黑色邊框，按列印稿實測。</translation>
    </message>
</context>
<context>
    <name>bask::BottomDock</name>
    <message>
        <source>Alarms</source>
        <translation>警報</translation>
    </message>
    <message>
        <source>Alarms (%1)</source>
        <translation>警報（%1）</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>事件</translation>
    </message>
    <message>
        <source>Alarms and events</source>
        <translation>警報與事件</translation>
    </message>
    <message>
        <source>Recipe</source>
        <translation>配方</translation>
    </message>
    <message>
        <source>, %1 shelved</source>
        <comment>behind the number of alarms</comment>
        <translation>，%1 個已擱置</translation>
    </message>
</context>
<context>
    <name>bask::CalibratePage</name>
    <message>
        <source>Calibrate</source>
        <translation>校正</translation>
    </message>
    <message>
        <source>What is calibrated</source>
        <translation>校正的內容</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>相機</translation>
    </message>
    <message>
        <source>Simulated camera</source>
        <translation>模擬相機</translation>
    </message>
    <message>
        <source>Or type a number (0), a device (/dev/video0), a video file, a folder of pictures or an address (rtsp://…), and Enter</source>
        <translation>或輸入編號（0）、裝置（/dev/video0）、影片檔、圖片資料夾或位址（rtsp://…），再按 Enter</translation>
    </message>
    <message>
        <source>Thermal camera</source>
        <translation>熱像儀</translation>
    </message>
</context>
<context>
    <name>bask::CalibrationAge</name>
    <message>
        <source>at an unknown time</source>
        <translation>時間未知</translation>
    </message>
    <message>
        <source>in the future: check the computer&apos;s clock</source>
        <translation>在將來：請檢查電腦的時鐘</translation>
    </message>
    <message>
        <source>just now</source>
        <translation>剛剛</translation>
    </message>
    <message>
        <source>Camera calibrated %1.</source>
        <translation>相機校正於：%1。</translation>
    </message>
    <message>
        <source>Camera not calibrated.</source>
        <translation>相機未校正。</translation>
    </message>
    <message>
        <source>Where the camera stands was measured %1.</source>
        <translation>相機位置測量於：%1。</translation>
    </message>
    <message>
        <source>Where the camera stands is not measured.</source>
        <translation>相機位置未測量。</translation>
    </message>
    <message>
        <source>The source&apos;s place is as typed, not measured by the camera.</source>
        <translation>熱源位置為手動輸入，未經相機測量。</translation>
    </message>
    <message>
        <source>The source&apos;s place was measured %1.</source>
        <translation>熱源位置測量於：%1。</translation>
    </message>
    <message numerus="yes">
        <source>%n minute(s) ago</source>
        <translation>
            <numerusform>%n 分鐘前</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n hour(s) ago</source>
        <translation>
            <numerusform>%n 小時前</numerusform>
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
        <translation>熱像儀的鏡頭校正於：%1。</translation>
    </message>
    <message>
        <source>Thermal camera&apos;s lens not calibrated.</source>
        <translation>熱像儀的鏡頭未校正。</translation>
    </message>
    <message>
        <source>The thermal camera&apos;s place is not known.</source>
        <translation>熱像儀的位置未知。</translation>
    </message>
    <message>
        <source>The thermal camera&apos;s place is as typed, not measured.</source>
        <translation>熱像儀的位置按輸入值，未測量。</translation>
    </message>
    <message>
        <source>The thermal camera&apos;s place was measured %1.</source>
        <translation>熱像儀的位置測量於：%1。</translation>
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
        <translation>校正(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Start looking</source>
        <translation>開始觀測(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Stop looking</source>
        <translation>停止觀測(&amp;S)</translation>
    </message>
    <message>
        <source>Calibration board</source>
        <translation>校正板</translation>
    </message>
    <message>
        <source>Calibration of the camera</source>
        <translation>相機校正</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>相機</translation>
    </message>
    <message>
        <source>Cameras (%1);;All files (*)</source>
        <translation>相機 (%1);;所有檔案 (*)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Drops all views. The board can be set again.</source>
        <translation>丟棄所有視圖。之後可重新設定校正板。</translation>
    </message>
    <message>
        <source>Hold the board still.</source>
        <translation>請保持校正板不動。</translation>
    </message>
    <message>
        <source>Leave &amp;out the views that stand out</source>
        <translation>剔除離群視圖(&amp;O)</translation>
    </message>
    <message>
        <source>Load a camera</source>
        <translation>載入相機</translation>
    </message>
    <message>
        <source>Looks for the board in the live picture.</source>
        <translation>在即時影像中尋找校正板。</translation>
    </message>
    <message>
        <source>OpenCV YAML (%1)</source>
        <translation>OpenCV YAML (%1)</translation>
    </message>
    <message>
        <source>Progress of the calibration</source>
        <translation>校正進度</translation>
    </message>
    <message>
        <source>ROS camera_info (%1)</source>
        <translation>ROS camera_info (%1)</translation>
    </message>
    <message>
        <source>Save the camera</source>
        <translation>儲存相機</translation>
    </message>
    <message>
        <source>Start again</source>
        <translation>重新開始</translation>
    </message>
    <message>
        <source>Start looking, then show the board to the camera from near and far, at all edges of the picture and tilted to all sides.</source>
        <translation>請開始觀測，然後讓相機在遠近不同處、畫面各邊緣處以及向各方向傾斜時看到校正板。</translation>
    </message>
    <message>
        <source>Ta&amp;ke this view</source>
        <translation>拍攝此視圖(&amp;K)</translation>
    </message>
    <message>
        <source>Take still, new views &amp;automatically</source>
        <translation>自動拍攝靜止的新視圖(&amp;A)</translation>
    </message>
    <message>
        <source>The board is seen: hold it still and take the view.</source>
        <translation>已見到校正板：請保持不動並拍攝視圖。</translation>
    </message>
    <message>
        <source>The camera is saved in %1.</source>
        <translation>相機已儲存在 %1。</translation>
    </message>
    <message>
        <source>The views are of this board: start again to set another.</source>
        <translation>這些視圖屬於此校正板：重新開始後才能設定另一塊。</translation>
    </message>
    <message>
        <source>There is such a view: move the board on.</source>
        <translation>已有這樣的視圖：請移動校正板。</translation>
    </message>
    <message>
        <source>Too little of the board is seen for a view.</source>
        <translation>見到的校正板部分太少，不能作為視圖。</translation>
    </message>
    <message>
        <source>Use the board seen</source>
        <translation>使用所見的校正板</translation>
    </message>
    <message>
        <source>View %1 is taken: move the board on.</source>
        <translation>已拍攝視圖 %1：請移動校正板。</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>視圖</translation>
    </message>
    <message>
        <source>Waiting for the camera&apos;s pictures.</source>
        <translation>正在等待相機影像。</translation>
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
        <translation>%1 個視圖</translation>
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
        <translation>使用此相機(&amp;U)</translation>
    </message>
    <message>
        <source>Calibrate it by views of a board, or load its file.</source>
        <translation>請用校正板的視圖校正，或載入其檔案。</translation>
    </message>
    <message>
        <source>Good</source>
        <translation>良好</translation>
    </message>
    <message>
        <source>Load a camera from a file</source>
        <translation>從檔案載入相機</translation>
    </message>
    <message>
        <source>Load…</source>
        <translation>載入…</translation>
    </message>
    <message>
        <source>No camera yet</source>
        <translation>尚無相機</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>參數</translation>
    </message>
    <message>
        <source>Parameters of the camera</source>
        <translation>相機參數</translation>
    </message>
    <message>
        <source>Poses of markers are computed by it from now on.</source>
        <translation>此後標記的位姿由它計算。</translation>
    </message>
    <message>
        <source>Read from a file: how far it holds was not checked here.</source>
        <translation>從檔案讀取：其適用程度未在此處驗證。</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>需重做</translation>
    </message>
    <message>
        <source>Save the camera in a file</source>
        <translation>將相機儲存到檔案</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>儲存…</translation>
    </message>
    <message>
        <source>Standard deviation</source>
        <translation>標準差</translation>
    </message>
    <message>
        <source>The camera in use</source>
        <translation>正在使用的相機</translation>
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
        <translation>保留視圖 %1 px</translation>
    </message>
    <message>
        <source>residual %1 px</source>
        <translation>殘差 %1 px</translation>
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
        <translation>有誤</translation>
    </message>
    <message>
        <source>not yet</source>
        <translation>尚未</translation>
    </message>
    <message>
        <source>Before a run</source>
        <translation>運轉之前</translation>
    </message>
    <message>
        <source>Devices: simulated</source>
        <translation>裝置：模擬</translation>
    </message>
    <message>
        <source>Devices: none set up as %1</source>
        <translation>裝置：未設定 %1</translation>
    </message>
    <message>
        <source>Devices: no answer from %1</source>
        <translation>裝置：%1 無回應</translation>
    </message>
    <message>
        <source>Devices: all answer</source>
        <translation>裝置：均有回應</translation>
    </message>
    <message>
        <source>Robot: in alarm</source>
        <translation>機器人：處於警報</translation>
    </message>
    <message>
        <source>Robot: its place is not sure</source>
        <translation>機器人：位置不確定</translation>
    </message>
    <message>
        <source>Robot: its place is sure</source>
        <translation>機器人：位置確定</translation>
    </message>
    <message>
        <source>Sensors: no readings yet</source>
        <translation>感測器：尚無讀數</translation>
    </message>
    <message>
        <source>Sensors: the newest readings are %1 old</source>
        <translation>感測器：最新讀數已過去 %1</translation>
    </message>
    <message>
        <source>Sensors: %1 of %2 without a valid reading</source>
        <translation>感測器：%2 個中有 %1 個沒有有效讀數</translation>
    </message>
    <message>
        <source>Sensors: fresh and valid</source>
        <translation>感測器：讀數及時且有效</translation>
    </message>
    <message>
        <source>Source: no temperature</source>
        <translation>熱源：無溫度</translation>
    </message>
    <message>
        <source>Source: warm, %1</source>
        <translation>熱源：已熱，%1</translation>
    </message>
    <message>
        <source>Source: %1, not at %2 yet</source>
        <translation>熱源：%1，尚未達到 %2</translation>
    </message>
    <message>
        <source>Source: %1, above %2</source>
        <translation>熱源：%1，高於 %2</translation>
    </message>
    <message>
        <source>Recording: not possible</source>
        <translation>記錄：無法進行</translation>
    </message>
    <message>
        <source>Recording: begins with Arm</source>
        <translation>記錄：進入待命時開始</translation>
    </message>
    <message>
        <source>Recording: on</source>
        <translation>記錄：進行中</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>Robot: its place is UNKNOWN, what it told last is %1</source>
        <translation>機器人：位置未知，最後告知的是：%1</translation>
    </message>
    <message>
        <source>Sensors: %1 of %2 not believed</source>
        <translation>感測器：%2 個中有 %1 個不採信</translation>
    </message>
    <message>
        <source>Sensors: %1 of %2 stale</source>
        <translation>感測器：%2 個中有 %1 個過時</translation>
    </message>
    <message>
        <source>Source: UNKNOWN whether it heats, %1</source>
        <translation>熱源：是否加熱未知，%1</translation>
    </message>
    <message>
        <source>Source: %1, not at %2 yet. %3</source>
        <extracomment>the last is a sentence about the time that it takes</extracomment>
        <translation>熱源：%1，尚未達到 %2。%3</translation>
    </message>
    <message>
        <source>Source: it heats though its heat is off, %1</source>
        <translation>熱源：加熱已關閉，但它仍在加熱，%1</translation>
    </message>
</context>
<context>
    <name>bask::Coach</name>
    <message>
        <source>Show me</source>
        <translation>示範</translation>
    </message>
    <message>
        <source>Not now</source>
        <translation>以後再說</translation>
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
        <translation>略過</translation>
    </message>
    <message>
        <source>On the Objects page, select “bunny” and drag Harmonics. With fewer of them its outline leaves the drawing&apos;s.</source>
        <translation>在「物體」頁選擇「bunny」並拖動諧波數。諧波越少，輪廓偏離原圖越多。</translation>
    </message>
    <message>
        <source>Take that back with Ctrl+Z. Every edit can be undone.</source>
        <translation>用 Ctrl+Z 復原。每項編輯都可以復原。</translation>
    </message>
    <message>
        <source>On the Targets page, type %1 for one object and read why it cannot be held.</source>
        <translation>在「目標」頁為一個物體輸入 %1，閱讀為何無法維持。</translation>
    </message>
    <message>
        <source>Press “Use nearest feasible”: targets that can be held together.</source>
        <translation>按「採用最近的可行目標」：可同時維持的目標。</translation>
    </message>
    <message>
        <source>Start (F6): the heat is on, and the robot moves.</source>
        <translation>開始（F6）：加熱開啟，機器人移動。</translation>
    </message>
    <message>
        <source>The run has ended in a fault, as a hold that lasts does. End it in Tools &gt; Simulate fault, press Reset, then Arm (F5) and Start (F6) again.</source>
        <translation>運轉已因故障結束：保持過久即會如此。請在「工具 &gt; 模擬故障」中結束故障，按「復歸」，然後再次「待命」（F5）、「開始」（F6）。</translation>
    </message>
    <message>
        <source>The run has ended. Arm (F5) and Start (F6) again.</source>
        <translation>運轉已結束。請再次「待命」（F5）、「開始」（F6）。</translation>
    </message>
    <message>
        <source>The run has ended. End the fault in Tools &gt; Simulate fault, then Arm (F5) and Start (F6) again.</source>
        <translation>運轉已結束。請在「工具 &gt; 模擬故障」中結束故障，然後再次「待命」（F5）、「開始」（F6）。</translation>
    </message>
    <message>
        <source>The temperatures go to their targets. Press N on the Run page and note something.</source>
        <translation>溫度趨向各自的目標。在「運轉」頁按 N，寫一則備註。</translation>
    </message>
    <message>
        <source>Change a gain at the controller and apply it: the traces are marked there.</source>
        <translation>更改控制器的一個增益並套用：曲線上會有標記。</translation>
    </message>
    <message>
        <source>Acknowledge the alarm (F9): you have seen it.</source>
        <translation>確認警報（F9）：表示您已看到。</translation>
    </message>
    <message>
        <source>Stop (F8): heat off, the robot retreats, the recording is closed.</source>
        <translation>停止（F8）：關閉加熱，機器人退回，關閉記錄。</translation>
    </message>
    <message>
        <source>On the Review page, open the recording of this run.</source>
        <translation>在「回顧」頁開啟本次運轉的記錄。</translation>
    </message>
    <message>
        <source>Type %1 there again, which is reached sooner. Then Arm (F5): the sensors are zeroed and the recording is opened. Nothing moves yet.</source>
        <translation>在那裡重新輸入 %1，可更快達到。然後待命（F5）：感測器校零，開啟記錄。此時什麼都不動。</translation>
    </message>
    <message>
        <source>File &gt; Examples &gt; thermal-camera: three objects that only a thermal camera reads. On the Run page, look at the tab Thermal picture.</source>
        <translation>檔案 &gt; 範例 &gt; thermal-camera：三個只由熱像儀讀取的物體。在「運轉」頁查看「熱像圖」標籤頁。</translation>
    </message>
    <message>
        <source>That was all. “Simulated rig” on the Rig page leads back to the simulated one; F1 opens the manual, which has the rest.</source>
        <translation>到此結束。「實驗台」頁的「模擬實驗台」可返回模擬實驗台；其餘內容見手冊（F1）。</translation>
    </message>
    <message>
        <source>New here? %1 small steps on simulated rigs show what Bask does. Nothing can burn.</source>
        <extracomment>how many</extracomment>
        <translation>初次使用？在模擬實驗台上的 %1 個小步驟示範 Bask 的功能，不會有任何危險。</translation>
    </message>
    <message>
        <source>Tools &gt; Simulate fault &gt; %1: choose an object. The run holds, and an alarm says what to do.</source>
        <extracomment>a simulated fault, as the menu has it</extracomment>
        <translation>「工具 &gt; 模擬故障 &gt; %1」：選擇一個物體。運轉保持，警報說明如何處理。</translation>
    </message>
    <message>
        <source>Remove its cause: choose the fault again in the same menu, which ends it. The sensor tells its temperature again.</source>
        <translation>消除原因：在同一選單中再次選擇該故障，即可結束它。感測器重新給出溫度。</translation>
    </message>
    <message>
        <source>Resume (Shift+F7): the run goes on where it was held.</source>
        <translation>繼續（Shift+F7）：運轉從保持處接著進行。</translation>
    </message>
    <message>
        <source>File &gt; Examples &gt; serial-rig: a rig with devices of its own, as a real one has. They are at serial ports, where nothing answers yet.</source>
        <translation>檔案 &gt; 範例 &gt; serial-rig：像實際實驗台一樣有自己的裝置。它們在序列埠上，目前還沒有回應。</translation>
    </message>
    <message>
        <source>Type “bask simulate-rig” in a terminal: it plays robot, thermometer and heat source at these ports. On the Rig page all three become live.</source>
        <translation>在終端機中輸入「bask simulate-rig」：它在這些連接埠上充當機器人、溫度計和熱源。在「實驗台」頁，三者都變為線上。</translation>
    </message>
    <message>
        <source>Find a device: “Remove” the thermometer, then “Set up…” with port %1. “Find devices” lists what answers there; choose it and press “Use”.</source>
        <extracomment>the path of a serial port</extracomment>
        <translation>尋找裝置：先「移除」溫度計，再「設定…」，連接埠為 %1。「尋找裝置」列出在那裡回應的裝置；選擇它並按「使用」。</translation>
    </message>
</context>
<context>
    <name>bask::Comparison</name>
    <message>
        <source>Metric</source>
        <translation>指標</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>物體</translation>
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
        <translation>與其之差</translation>
    </message>
    <message>
        <source>The run that the others are compared with</source>
        <translation>其他運轉與之比較的運轉</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>複製</translation>
    </message>
    <message>
        <source>Copy the table as text, for a spreadsheet or a letter</source>
        <translation>將表格作為文字複製，供試算表或信件使用</translation>
    </message>
    <message>
        <source>Export (CSV)…</source>
        <translation>匯出 (CSV)…</translation>
    </message>
    <message>
        <source>Metrics of the runs that are laid over each other</source>
        <translation>疊加的各次運轉的指標</translation>
    </message>
    <message>
        <source>%1 less %2</source>
        <translation>%1 減 %2</translation>
    </message>
    <message>
        <source>Being computed from all samples: %1</source>
        <translation>正在用全部取樣計算：%1</translation>
    </message>
    <message>
        <source>No metrics, the recording cannot be read to its end: %1</source>
        <translation>沒有指標，記錄無法讀到結尾：%1</translation>
    </message>
    <message>
        <source>Write the numbers of this table for other programs</source>
        <translation>寫出此表中的數字，供其他程式使用</translation>
    </message>
    <message>
        <source>Once all metrics are computed</source>
        <translation>所有指標計算完成之後</translation>
    </message>
    <message numerus="yes">
        <source>Copied %n row(s)</source>
        <translation>
            <numerusform>已複製 %n 列</numerusform>
        </translation>
    </message>
    <message>
        <source>The steps are not alike, so neither are times and overshoots: %1</source>
        <translation>步階不同，因此時間和過衝也不可比較：%1</translation>
    </message>
    <message>
        <source>The source was not equally hot at Start: %1</source>
        <translation>開始時各次運轉的熱源溫度不同：%1</translation>
    </message>
</context>
<context>
    <name>bask::ControllerPanel</name>
    <message>
        <source>Not applied: %1</source>
        <comment>number of changes</comment>
        <translation>未應用：%1</translation>
    </message>
    <message>
        <source>Controller and gains</source>
        <translation>控制器與增益</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>控制器</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>應用</translation>
    </message>
    <message>
        <source>Use these settings from the next control step on; noted in the run&apos;s log.</source>
        <translation>從下一個控制步起使用這些設定；將記入運轉日誌。</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>還原</translation>
    </message>
    <message>
        <source>Back to the settings in use.</source>
        <translation>恢復為正在使用的設定。</translation>
    </message>
    <message>
        <source>After a step of %1 K, without limits and noise: it never settles.</source>
        <translation>步階 %1 K 後，不計限值和雜訊：始終不能穩定。</translation>
    </message>
    <message>
        <source>After a step of %1 K, without limits and noise: overshoot %2 %, within ±%3 K after %4 s.</source>
        <translation>步階 %1 K 後，不計限值和雜訊：過衝 %2 %，%4 s 後進入 ±%3 K 以內。</translation>
    </message>
    <message>
        <source>After a step of %1 K, once it has adapted, without limits and noise: no overshoot, within ±%2 K after %3 s at best.</source>
        <translation>步階 %1 K 後，自適應完成時，不計限值和雜訊：無過衝，最快 %3 s 後進入 ±%2 K 以內。</translation>
    </message>
    <message>
        <source>Frequency ω</source>
        <translation>頻率 ω</translation>
    </message>
    <message>
        <source>rad/s</source>
        <translation>rad/s</translation>
    </message>
    <message>
        <source>Natural frequency: ω = √K. Changes D and K together.</source>
        <translation>自然頻率：ω = √K。同時改變 D 和 K。</translation>
    </message>
    <message>
        <source>Damping ratio ζ</source>
        <translation>阻尼比 ζ</translation>
    </message>
    <message>
        <source>ζ = D / (2√K): overshoots below 1. Changes D.</source>
        <translation>ζ = D / (2√K)：小於 1 時有過衝。改變 D。</translation>
    </message>
    <message>
        <source>Rates wrong: ×%1</source>
        <comment>the heat rates that the controller begins with</comment>
        <translation>熱速率有誤：×%1</translation>
    </message>
</context>
<context>
    <name>bask::CountdownBar</name>
    <message>
        <source>In %1 s, unless the cause is gone: %2</source>
        <translation>%1 s 後，除非原因消除：%2</translation>
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
        <translation>%1 / %2 個視圖</translation>
    </message>
    <message>
        <source>%1 views</source>
        <translation>%1 個視圖</translation>
    </message>
    <message>
        <source>Colours the picture by how many corners were seen where.</source>
        <translation>按各處見到的角點數為畫面著色。</translation>
    </message>
    <message>
        <source>Covered: %1</source>
        <translation>已覆蓋：%1</translation>
    </message>
    <message>
        <source>Left to right</source>
        <translation>左到右</translation>
    </message>
    <message>
        <source>Nearness</source>
        <translation>遠近</translation>
    </message>
    <message>
        <source>Show on the &amp;picture</source>
        <translation>顯示在畫面上(&amp;P)</translation>
    </message>
    <message>
        <source>This is enough: calibrate.</source>
        <translation>已經足夠：請校正。</translation>
    </message>
    <message>
        <source>Tilt</source>
        <translation>傾斜</translation>
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
        <translation>無剖面</translation>
    </message>
    <message>
        <source>Cut: %1</source>
        <translation>剖面：%1</translation>
    </message>
    <message>
        <source>Object whose field is cut</source>
        <translation>顯示其場剖面的物體</translation>
    </message>
    <message>
        <source>A plane in the colours of what one object would have there.</source>
        <translation>一個平面，其顏色表示某一物體在該處的值。</translation>
    </message>
    <message>
        <source>What the cut shows: T, the steady temperature, or F, the view factor</source>
        <translation>剖面所顯示的量：T 為穩態溫度，F 為角係數</translation>
    </message>
    <message>
        <source>T: the temperature that the object settles at there. F: its view factor.</source>
        <translation>T：物體在該處最終穩定的溫度。F：其角係數。</translation>
    </message>
    <message>
        <source>Axis that the plane is square to</source>
        <translation>平面所垂直的軸</translation>
    </message>
    <message>
        <source>Place of the plane along its axis</source>
        <translation>平面沿其軸的位置</translation>
    </message>
</context>
<context>
    <name>bask::CutOffRun</name>
    <message>
        <source>Bask ended in the middle of a run (%1) and could not stop the rig: look at the robot and the source before you go on.</source>
        <translation>Bask 在一次運轉途中意外結束（%1），未能停止實驗台：請先檢查機器人和熱源，然後再繼續。</translation>
    </message>
    <message>
        <source>Bask ended in the middle of a simulated run (%1).</source>
        <translation>Bask 在一次模擬運轉途中意外結束（%1）。</translation>
    </message>
    <message>
        <source>Show in Review</source>
        <translation>在「回顧」中顯示</translation>
    </message>
    <message>
        <source>What it had recorded is kept.</source>
        <translation>已記錄的內容均已保留。</translation>
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
        <translation>桌面沒有能開啟 %1 的程式。</translation>
    </message>
</context>
<context>
    <name>bask::Device</name>
    <message>
        <source>Robot</source>
        <translation>機器人</translation>
    </message>
    <message>
        <source>Thermometer</source>
        <translation>溫度計</translation>
    </message>
    <message>
        <source>Heat source</source>
        <translation>熱源</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>相機</translation>
    </message>
    <message>
        <source>Closed</source>
        <translation>已關閉</translation>
    </message>
    <message>
        <source>Opening</source>
        <translation>正在開啟</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>線上</translation>
    </message>
    <message>
        <source>Lost</source>
        <translation>已失聯</translation>
    </message>
    <message>
        <source>Grbl or grblHAL (G-code)</source>
        <translation>Grbl 或 grblHAL（G 碼）</translation>
    </message>
    <message>
        <source>Dobot MG400 or M1 Pro (network)</source>
        <translation>Dobot MG400 或 M1 Pro（網路）</translation>
    </message>
    <message>
        <source>Modbus RTU module</source>
        <translation>Modbus RTU 模組</translation>
    </message>
    <message>
        <source>Lines of text (MAX31865)</source>
        <translation>文字行（MAX31865）</translation>
    </message>
    <message>
        <source>Kept hot by a person</source>
        <translation>由人工保持高溫</translation>
    </message>
    <message>
        <source>Hotplate (NAMUR, IKA)</source>
        <translation>加熱板（NAMUR，IKA）</translation>
    </message>
    <message>
        <source>Modbus RTU controller</source>
        <translation>Modbus RTU 控制器</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>圖片</translation>
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
        <translation>熱像儀</translation>
    </message>
    <message>
        <source>Program of your own</source>
        <translation>自編程式</translation>
    </message>
    <message>
        <source>Modbus TCP controller</source>
        <translation>Modbus TCP 控制器</translation>
    </message>
    <message>
        <source>Modbus TCP module</source>
        <translation>Modbus TCP 模組</translation>
    </message>
    <message>
        <source>heated by hand</source>
        <translation>手動加熱</translation>
    </message>
    <message>
        <source>heat off</source>
        <translation>加熱關閉</translation>
    </message>
    <message>
        <source>heat on</source>
        <translation>加熱開啟</translation>
    </message>
    <message>
        <source>heat UNKNOWN</source>
        <translation>加熱未知</translation>
    </message>
    <message>
        <source>SIMULATED</source>
        <translation>模擬</translation>
    </message>
    <message>
        <source>LIVE</source>
        <translation>實機</translation>
    </message>
    <message>
        <source>heats though off</source>
        <translation>已關仍在加熱</translation>
    </message>
    <message>
        <source>The robot&apos;s place was not sure. It is sure again: press Reset.</source>
        <translation>機器人的位置曾不確定，現已確定：請按「復歸」。</translation>
    </message>
    <message>
        <source>The robot&apos;s place was not sure. It is sure again.</source>
        <translation>機器人的位置曾不確定，現已確定。</translation>
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
        <translation>設定…</translation>
    </message>
    <message>
        <source>Simulated</source>
        <translation>模擬</translation>
    </message>
    <message>
        <source>None</source>
        <translation>無</translation>
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
            <numerusform>已丟棄 %n 個回應</numerusform>
        </translation>
    </message>
    <message>
        <source>Age of its newest answer, answers a second, and answers that nobody can read or that were not asked for</source>
        <translation>最新回應的時齡、每秒回應數，以及無法識別或並非所問的回應數</translation>
    </message>
    <message>
        <source>This is the one</source>
        <translation>就是這台</translation>
    </message>
    <message>
        <source>Use the device that answers now, and remember it instead of the one before</source>
        <translation>使用現在回應的裝置，並記住它以取代以前的裝置</translation>
    </message>
    <message>
        <source>Confirm…</source>
        <translation>確認…</translation>
    </message>
    <message>
        <source>Look at what would be started, and allow it on this computer</source>
        <translation>查看將啟動的內容，並在本電腦上允許</translation>
    </message>
    <message>
        <source>The last of them: %1</source>
        <translation>其中最近一個：%1</translation>
    </message>
</context>
<context>
    <name>bask::DeviceConsole</name>
    <message>
        <source>Nothing is sent by hand while a run is armed or on, the heat is on or the robot moves.</source>
        <translation>執行已預備或進行中、加熱開啟或機器人移動時，不能手動傳送。</translation>
    </message>
    <message>
        <source>Bask sends this as it is and checks no limit: the robot can move and the source can heat. Bask lets the device go meanwhile, and takes it back 3 s later.</source>
        <translation>Bask 原樣傳送，不檢查任何限值：機器人可能移動，熱源可能加熱。期間 Bask 放開該裝置，3 s 後取回。</translation>
    </message>
    <message>
        <source>No link to a device is open.</source>
        <translation>沒有開啟的裝置連線。</translation>
    </message>
    <message>
        <source>Device console</source>
        <translation>裝置主控台</translation>
    </message>
    <message>
        <source>All links</source>
        <translation>全部連線</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>連線</translation>
    </message>
    <message>
        <source>Both directions</source>
        <translation>雙向</translation>
    </message>
    <message>
        <source>Sent</source>
        <translation>傳送</translation>
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
        <translation>只顯示含此文字的列</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>篩選</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>暫停</translation>
    </message>
    <message>
        <source>The traffic of the last 10 minutes is kept meanwhile</source>
        <translation>期間仍保留最近 10 分鐘的通訊</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>複製</translation>
    </message>
    <message>
        <source>Copies the selected rows, or all that are shown: the newest 8 million characters</source>
        <translation>複製選取的列，或所有顯示的列：最新的 800 萬個字元</translation>
    </message>
    <message>
        <source>Link to send to</source>
        <translation>傳送到的連線</translation>
    </message>
    <message>
        <source>Text to send</source>
        <translation>要傳送的文字</translation>
    </message>
    <message>
        <source>ends with \n</source>
        <translation>以 \n 結尾</translation>
    </message>
    <message>
        <source>ends with \r</source>
        <translation>以 \r 結尾</translation>
    </message>
    <message>
        <source>ends with \r\n</source>
        <translation>以 \r\n 結尾</translation>
    </message>
    <message>
        <source>as it is</source>
        <translation>原樣</translation>
    </message>
    <message>
        <source>hexadecimal</source>
        <translation>十六進位</translation>
    </message>
    <message>
        <source>End of the text</source>
        <translation>文字結尾</translation>
    </message>
    <message>
        <source>Send</source>
        <translation>傳送</translation>
    </message>
    <message>
        <source>Traffic of the links</source>
        <translation>連線的通訊</translation>
    </message>
</context>
<context>
    <name>bask::DeviceDialog</name>
    <message>
        <source>Take a profile from a file</source>
        <translation>從檔案讀取配置</translation>
    </message>
    <message>
        <source>Profiles (*.json)</source>
        <translation>設定檔 (*.json)</translation>
    </message>
    <message>
        <source>Asking…</source>
        <translation>正在詢問…</translation>
    </message>
    <message>
        <source>Channels %1</source>
        <translation>通道 %1</translation>
    </message>
    <message>
        <source>Temperature %1</source>
        <translation>溫度 %1</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>相機</translation>
    </message>
    <message>
        <source>A number (0), a device (/dev/video0), a video file, a folder of pictures or an address (rtsp://…)</source>
        <translation>編號（0）、裝置（/dev/video0）、影片檔、圖片資料夾或位址（rtsp://…）</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>連接埠</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>位址</translation>
    </message>
    <message>
        <source>Choose one, or type its path</source>
        <translation>請選擇一個，或輸入其路徑</translation>
    </message>
    <message>
        <source>Set up: %1</source>
        <translation>設定：%1</translation>
    </message>
    <message>
        <source>Driver</source>
        <translation>驅動</translation>
    </message>
    <message>
        <source>Refresh</source>
        <translation>重新整理</translation>
    </message>
    <message>
        <source>Look for ports anew</source>
        <translation>重新尋找連接埠</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>線路</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>軸</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>裝置</translation>
    </message>
    <message>
        <source>From file…</source>
        <translation>從檔案…</translation>
    </message>
    <message>
        <source>Take what the device&apos;s registers mean from a file</source>
        <translation>從檔案讀取裝置各暫存器的含義</translation>
    </message>
    <message>
        <source>Channels</source>
        <translation>通道</translation>
    </message>
    <message>
        <source>The channel of each object&apos;s sensor, counted from 0</source>
        <translation>每個物體的感測器通道，從 0 開始計數</translation>
    </message>
    <message>
        <source>Its external probe measures the surface</source>
        <translation>由其外接探頭測量表面溫度</translation>
    </message>
    <message>
        <source>Test read</source>
        <translation>讀取測試</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>使用</translation>
    </message>
    <message>
        <source>Use this device in the experiment</source>
        <translation>在實驗中使用此裝置</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Asks the device without using it. Nothing moves or heats.</source>
        <translation>僅詢問裝置而不使用它。沒有運動，也不加熱。</translation>
    </message>
    <message>
        <source>No serial port was found. Plug the device in and refresh, or type a path.</source>
        <translation>未找到串列埠。請插入裝置後重新整理，或輸入路徑。</translation>
    </message>
    <message>
        <source>1. Which device</source>
        <translation>1. 哪個裝置</translation>
    </message>
    <message>
        <source>2. Where it is connected</source>
        <translation>2. 連線在何處</translation>
    </message>
    <message>
        <source>3. Does it answer?</source>
        <translation>3. 是否回應？</translation>
    </message>
    <message>
        <source>4. Its axes</source>
        <translation>4. 它的軸</translation>
    </message>
    <message>
        <source>4. The objects&apos; channels</source>
        <translation>4. 各物體的通道</translation>
    </message>
    <message>
        <source>4. The device&apos;s own settings</source>
        <translation>4. 裝置自身的設定</translation>
    </message>
    <message>
        <source>May heat without a watchdog</source>
        <translation>允許在沒有看門狗時加熱</translation>
    </message>
    <message>
        <source>Then the source stays hot when Bask or the computer stops. Never leave it alone.</source>
        <translation>那麼當 Bask 或電腦停止執行時，熱源會一直發熱。不得無人看管。</translation>
    </message>
    <message>
        <source>Its place is sure</source>
        <translation>其位置確定</translation>
    </message>
    <message>
        <source>Once it is homed, if its controller can; else once it is confirmed</source>
        <translation>若控制器支援，回原點之後；否則確認之後</translation>
    </message>
    <message>
        <source>Once it is homed</source>
        <translation>回原點之後</translation>
    </message>
    <message>
        <source>Once it is homed or confirmed</source>
        <translation>回原點或確認之後</translation>
    </message>
    <message>
        <source>Host name or IP address of the device</source>
        <translation>裝置的主機名稱或 IP 位址</translation>
    </message>
    <message>
        <source>Picture from %1 to %2</source>
        <translation>影像從 %1 到 %2</translation>
    </message>
    <message>
        <source>A number (0), a device (/dev/video0), a recorded frame or a folder of frames</source>
        <translation>編號（0）、裝置（/dev/video0）、錄製的一格或影格的資料夾</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>命令</translation>
    </message>
    <message>
        <source>The program and its arguments: python3 /home/lab/my_robot.py</source>
        <translation>程式及其參數：python3 /home/lab/my_robot.py</translation>
    </message>
    <message>
        <source>When its program says so</source>
        <translation>當其程式表示時</translation>
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
        <translation>實驗台尚不能進入待命或開始。</translation>
    </message>
    <message>
        <source>Nothing stands in the way: press Arm.</source>
        <translation>一切就緒：請按「待命」。</translation>
    </message>
    <message>
        <source>The sensors are zeroed and the recording is open: press Start.</source>
        <translation>感測器已歸零，記錄已開啟：請按「開始」。</translation>
    </message>
    <message>
        <source>The robot moves the objects towards their targets.</source>
        <translation>機器人正將各物體移向其目標。</translation>
    </message>
    <message>
        <source>Zero velocity; the controller&apos;s state is kept. Press Resume to go on.</source>
        <translation>速度為零；控制器狀態已保留。按「繼續」接著運轉。</translation>
    </message>
    <message>
        <source>All objects stay within their tolerance band. The controller keeps working.</source>
        <translation>所有物體都保持在容差帶內。控制器繼續工作。</translation>
    </message>
    <message>
        <source>no value yet</source>
        <translation>尚無數值</translation>
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
        <translation>未進入待命。</translation>
    </message>
    <message>
        <source>The robot takes the objects away, and the heat was ordered off.</source>
        <translation>機器人正將物體移開，已下令關閉加熱。</translation>
    </message>
    <message>
        <source>The run has ended.</source>
        <translation>運轉已結束。</translation>
    </message>
    <message>
        <source>A stop or a fault is latched. Remove its cause, then press Reset.</source>
        <translation>有停止或故障被閂鎖。請排除其原因，然後按「復歸」。</translation>
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
        <translation>均勻</translation>
    </message>
    <message>
        <source>Parts: %1, which radiate %2 to %3 % of what an even one does</source>
        <translation>%1 個部分，輻射為均勻熱源的 %2 至 %3 %</translation>
    </message>
    <message>
        <source>Radial profile of %1 points, radiating %2 to %3 % of what an even one does</source>
        <translation>%1 個點的徑向分布，輻射為均勻熱源的 %2 至 %3 %</translation>
    </message>
</context>
<context>
    <name>bask::EventList</name>
    <message>
        <source>Priority %1</source>
        <translation>優先順序 %1</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>備註</translation>
    </message>
    <message>
        <source>Event</source>
        <translation>事件</translation>
    </message>
    <message>
        <source>Events and notes</source>
        <translation>事件與備註</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>時間</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>類型</translation>
    </message>
    <message>
        <source>What happened</source>
        <translation>發生了什麼</translation>
    </message>
</context>
<context>
    <name>bask::ExperimentEdit</name>
    <message>
        <source>target of “%1”</source>
        <translation>「%1」的目標</translation>
    </message>
    <message>
        <source>targets</source>
        <translation>目標</translation>
    </message>
    <message>
        <source>controller and gains</source>
        <translation>控制器與增益</translation>
    </message>
    <message>
        <source>markers</source>
        <translation>標記</translation>
    </message>
    <message>
        <source>calibration of the camera</source>
        <translation>相機校正</translation>
    </message>
    <message>
        <source>place of the camera</source>
        <translation>相機的位置</translation>
    </message>
    <message>
        <source>calibration</source>
        <translation>校正</translation>
    </message>
    <message>
        <source>place of the source</source>
        <translation>熱源的位置</translation>
    </message>
    <message>
        <source>following of the source</source>
        <translation>熱源的追蹤</translation>
    </message>
    <message>
        <source>start of runs</source>
        <translation>運轉的起始位姿</translation>
    </message>
    <message>
        <source>set point of the source</source>
        <translation>熱源的設定值</translation>
    </message>
    <message>
        <source>emittance of the source</source>
        <translation>熱源的發射率</translation>
    </message>
    <message>
        <source>workspace</source>
        <translation>工作空間</translation>
    </message>
    <message>
        <source>limits of motion</source>
        <translation>運動限值</translation>
    </message>
    <message>
        <source>safety limits</source>
        <translation>安全限值</translation>
    </message>
    <message>
        <source>choice of the real rig</source>
        <translation>選用實際實驗台</translation>
    </message>
    <message>
        <source>devices of the rig</source>
        <translation>實驗台的裝置</translation>
    </message>
    <message>
        <source>choice of the simulated rig</source>
        <translation>選用模擬實驗台</translation>
    </message>
    <message>
        <source>move of “%1”</source>
        <translation>移動「%1」</translation>
    </message>
    <message>
        <source>moves</source>
        <translation>移動</translation>
    </message>
    <message>
        <source>renaming of “%1”</source>
        <translation>重新命名「%1」</translation>
    </message>
    <message>
        <source>names</source>
        <translation>名稱</translation>
    </message>
    <message>
        <source>start values of “%1”</source>
        <translation>「%1」的起始值</translation>
    </message>
    <message>
        <source>start values</source>
        <translation>起始值</translation>
    </message>
    <message>
        <source>material of “%1”</source>
        <translation>「%1」的材料</translation>
    </message>
    <message>
        <source>materials</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>outline of “%1”</source>
        <translation>「%1」的輪廓</translation>
    </message>
    <message>
        <source>outlines</source>
        <translation>輪廓</translation>
    </message>
    <message>
        <source>change of “%1”</source>
        <translation>更改「%1」</translation>
    </message>
    <message>
        <source>change of several objects</source>
        <translation>更改多個物體</translation>
    </message>
    <message>
        <source>addition of “%1”</source>
        <translation>新增「%1」</translation>
    </message>
    <message>
        <source>removal of “%1”</source>
        <translation>移除「%1」</translation>
    </message>
    <message>
        <source>change of the experiment</source>
        <translation>更改實驗</translation>
    </message>
    <message>
        <source>air in the room</source>
        <translation>室內空氣</translation>
    </message>
    <message>
        <source>calibration of the thermal camera</source>
        <translation>熱像儀校正</translation>
    </message>
</context>
<context>
    <name>bask::ExportBar</name>
    <message>
        <source>Computing…</source>
        <translation>正在計算…</translation>
    </message>
    <message>
        <source>Picture %1 of %2</source>
        <translation>圖片 %1 / %2</translation>
    </message>
    <message>
        <source>Progress of the export</source>
        <translation>匯出進度</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Cancel the export</source>
        <translation>取消匯出</translation>
    </message>
</context>
<context>
    <name>bask::FaultMenu</name>
    <message>
        <source>Not on a real rig: faults are simulated on the simulated rig only.</source>
        <translation>實機上不可用：故障只能在模擬的實驗台上模擬。</translation>
    </message>
    <message>
        <source>No simulated fault is active.</source>
        <translation>沒有啟用的模擬故障。</translation>
    </message>
    <message>
        <source>Active. Choose it again to end it.</source>
        <translation>已啟用。再次選擇即可結束。</translation>
    </message>
    <message>
        <source>&amp;Simulate fault</source>
        <translation>模擬故障(&amp;S)</translation>
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
        <translation>物體比室溫高時才會顯現。</translation>
    </message>
    <message>
        <source>Shows once the two objects have different temperatures.</source>
        <translation>兩個物體溫度不同時才會顯現。</translation>
    </message>
    <message>
        <source>Shows when the heat is switched off.</source>
        <translation>關閉加熱時才會顯現。</translation>
    </message>
    <message>
        <source>Shows in the picture of the Calibrate page only: nothing else here uses the camera.</source>
        <translation>只在「校正」頁的影像中可見：這裡沒有其他部分使用相機。</translation>
    </message>
    <message>
        <source>Would show nothing here: the thermal camera reads the object, no sensor does.</source>
        <translation>在此什麼也不會顯現：該物體由熱像儀讀取，沒有感測器。</translation>
    </message>
    <message>
        <source>Would show nothing here: there is no other sensor to swap with.</source>
        <translation>在此什麼也不會顯現：沒有可與之對調的其他感測器。</translation>
    </message>
    <message>
        <source>Would show nothing here: the source has no markers, and nothing follows it.</source>
        <translation>在此什麼也不會顯現：熱源沒有標記，也沒有任何東西追蹤它。</translation>
    </message>
    <message>
        <source>Would show nothing now: the heat is off. Start a run or heat by hand first.</source>
        <translation>此刻什麼也不會顯現：加熱已關閉。請先開始運轉或手動加熱。</translation>
    </message>
    <message>
        <source>Would show nothing now: the heat is on. Stop the run or switch it off first.</source>
        <translation>此刻什麼也不會顯現：加熱已開啟。請先停止運轉或關閉加熱。</translation>
    </message>
    <message>
        <source>Would change no run here: no camera follows the source, and there is no thermal camera.</source>
        <translation>在此不會影響任何運轉：沒有相機追蹤熱源，也沒有熱像儀。</translation>
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
        <translation>帶標題(&amp;H)</translation>
    </message>
    <message>
        <source>Size of the figure</source>
        <translation>圖的尺寸</translation>
    </message>
    <message>
        <source>One column: %1 mm</source>
        <translation>一欄：%1 mm</translation>
    </message>
    <message>
        <source>Two columns: %1 mm</source>
        <translation>兩欄：%1 mm</translation>
    </message>
    <message>
        <source>Another</source>
        <translation>其他</translation>
    </message>
    <message>
        <source>Title, names of the files and marked moments. Without it, a simulated run is called so in the corner.</source>
        <translation>標題、檔名和標出的時刻。沒有它時，模擬運轉在角上註明。</translation>
    </message>
    <message>
        <source>&amp;Size on paper</source>
        <translation>紙上尺寸(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>寬度(&amp;W)</translation>
    </message>
    <message>
        <source>The letters have 7 to 9 points at any width.</source>
        <translation>無論寬度多少，字都為 7 至 9 點。</translation>
    </message>
    <message>
        <source>Choose the place…</source>
        <translation>選擇位置…</translation>
    </message>
</context>
<context>
    <name>bask::FinalValuesTable</name>
    <message>
        <source>Final values</source>
        <translation>最終值</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>物體</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>目標</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>誤差</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>not settled</source>
        <translation>未穩定</translation>
    </message>
    <message>
        <source>Final</source>
        <translation>最終</translation>
    </message>
    <message>
        <source>What the thermometer read when the run was stopped</source>
        <translation>運轉停止時溫度計的讀數</translation>
    </message>
    <message>
        <source>The simulated object&apos;s own temperature when the run was stopped, which no sensor tells</source>
        <translation>運轉停止時模擬物體自身的溫度，沒有感測器能讀到</translation>
    </message>
    <message>
        <source>True</source>
        <translation>真實</translation>
    </message>
    <message>
        <source>Settled at</source>
        <translation>穩定時刻</translation>
    </message>
    <message>
        <source>Time of the run from which the object stays within %1 of its target until the end</source>
        <translation>從運轉的此時刻起直到結束，物體都保持在目標的 %1 以內</translation>
    </message>
</context>
<context>
    <name>bask::HarmonicsPanel</name>
    <message>
        <source>&amp;Harmonics</source>
        <translation>諧波數(&amp;H)</translation>
    </message>
    <message>
        <source>Number of harmonics</source>
        <translation>諧波的個數</translation>
    </message>
    <message>
        <source>With this number of harmonics the outline crosses itself; choose another.</source>
        <translation>用此諧波數時輪廓自相交；請另選。</translation>
    </message>
    <message>
        <source>Fitting…</source>
        <translation>正在擬合…</translation>
    </message>
    <message>
        <source>Residual &lt;b&gt;%1 mm&lt;/b&gt; rms, &lt;b&gt;%2 mm&lt;/b&gt; at most; Hausdorff &lt;b&gt;%3 mm&lt;/b&gt;; area &lt;b&gt;%4 %&lt;/b&gt;</source>
        <translation>殘差：均方根 &lt;b&gt;%1 mm&lt;/b&gt;，最大 &lt;b&gt;%2 mm&lt;/b&gt;；豪斯多夫距離 &lt;b&gt;%3 mm&lt;/b&gt;；面積 &lt;b&gt;%4 %&lt;/b&gt;</translation>
    </message>
    <message>
        <source>%1 mm cannot be reached with up to %2 harmonics: %3 of them come closest, within %4 mm. The outline itself is exact.</source>
        <translation>%1 mm 無法用至多 %2 個諧波達到：%3 個諧波最接近，誤差在 %4 mm 以內。輪廓本身是精確的。</translation>
    </message>
    <message>
        <source>With any number of harmonics up to %1 the outline crosses itself. The outline itself is exact.</source>
        <translation>用 %1 個以內的任何諧波數，輪廓都自相交。輪廓本身是精確的。</translation>
    </message>
    <message>
        <source>Fitting… %1 of %2</source>
        <translation>正在擬合… %1 / %2</translation>
    </message>
    <message>
        <source>Fewest harmonics &amp;within</source>
        <translation>最少諧波數，誤差不超過(&amp;W)</translation>
    </message>
    <message>
        <source>Chooses the fewest harmonics whose outline does not cross itself and is nowhere farther from the imported one than this (Hausdorff distance).</source>
        <translation>選擇最少的諧波數，使輪廓不自相交，且各處與匯入輪廓的距離都不超過此值（豪斯多夫距離）。</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Distance within which the Fourier outline shall be</source>
        <translation>傅立葉輪廓應達到的距離</translation>
    </message>
    <message>
        <source>Use the outli&amp;ne itself</source>
        <translation>直接使用輪廓本身(&amp;N)</translation>
    </message>
    <message>
        <source>Takes the imported outline as a polygon, corner by corner, in place of a Fourier outline. Exact; slower the more corners it has.</source>
        <translation>將匯入的輪廓逐角點作為多邊形使用，代替傅立葉輪廓。精確；角點越多越慢。</translation>
    </message>
    <message>
        <source>The imported outline itself is used: %1 corners.</source>
        <translation>使用匯入的輪廓本身：%1 個角點。</translation>
    </message>
    <message>
        <source>The imported outline itself is used, thinned from %1 to %2 corners.</source>
        <translation>使用匯入的輪廓本身，由 %1 個角點精簡為 %2 個。</translation>
    </message>
    <message>
        <source>Take %1</source>
        <comment>a number of harmonics</comment>
        <translation>採用 %1</translation>
    </message>
    <message>
        <source>Take %1 harmonics</source>
        <translation>採用 %1 個諧波</translation>
    </message>
    <message>
        <source>Residual: between points at equal arc length, as a root mean square (rms) and at most. Hausdorff distance: the farthest that any point of one outline is from the nearest of the other; it is what &quot;Fewest harmonics within&quot; is about. Area: of the Fourier outline against the imported one.</source>
        <translation>殘差：弧長相同處兩點之間的距離，給出均方根（rms）和最大值。豪斯多夫距離：一條輪廓上任意點到另一條輪廓最近點的最遠距離；「最少諧波數，誤差不超過」即指它。面積：傅立葉輪廓與匯入輪廓之比較。</translation>
    </message>
</context>
<context>
    <name>bask::HeatPanel</name>
    <message>
        <source>Heat the source</source>
        <translation>加熱熱源</translation>
    </message>
    <message>
        <source>The source heats towards %1 until it is switched off. Is nothing on it or near it that must not get hot?</source>
        <translation>熱源將向 %1 加熱，直至被關閉。熱源上及其附近確實沒有怕熱的物品嗎？</translation>
    </message>
    <message>
        <source>Heat</source>
        <translation>加熱</translation>
    </message>
    <message>
        <source>A person keeps the source hot: %1 as typed last.</source>
        <translation>由人工保持熱源高溫：上次輸入為 %1。</translation>
    </message>
    <message>
        <source>Heating towards %1: %2 now.</source>
        <translation>正在向 %1 加熱：目前 %2。</translation>
    </message>
    <message>
        <source>The heat is on: %1 now.</source>
        <translation>加熱已開啟：目前 %1。</translation>
    </message>
    <message>
        <source>The heat is off: %1 now.</source>
        <translation>加熱已關閉：目前 %1。</translation>
    </message>
    <message>
        <source>Set point</source>
        <translation>設定值</translation>
    </message>
    <message>
        <source>Set point of the source</source>
        <translation>熱源的設定值</translation>
    </message>
    <message>
        <source>Heat the source until it is switched off</source>
        <translation>加熱熱源，直至被關閉</translation>
    </message>
    <message>
        <source>Heat off</source>
        <translation>關閉加熱</translation>
    </message>
    <message>
        <source>Measured by you</source>
        <translation>由您測量</translation>
    </message>
    <message>
        <source>Temperature of the source as you measured it</source>
        <translation>您測得的熱源溫度</translation>
    </message>
    <message>
        <source>Take</source>
        <translation>採用</translation>
    </message>
    <message>
        <source>UNKNOWN whether it heats: it was asked to heat towards %1. Last seen: %2.</source>
        <translation>是否加熱未知：曾要求加熱到 %1。最後所見：%2。</translation>
    </message>
    <message>
        <source>UNKNOWN whether it heats. Last seen: %1. Take it for hot.</source>
        <translation>是否加熱未知。最後所見：%1。請當作高溫對待。</translation>
    </message>
    <message>
        <source>It heats though its heat is off: %1 now. Switch it off at its mains.</source>
        <translation>加熱已關閉卻仍在加熱：目前 %1。請切斷其電源。</translation>
    </message>
    <message>
        <source>The heat is off: %1 now, behind the closed shutter of the simulated source.</source>
        <translation>加熱已關閉：現在 %1，位於模擬熱源閉合的快門之後。</translation>
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
        <translation>使固定值在機器人的範圍內分九步變化，播放等值面。</translation>
    </message>
    <message>
        <source>As at the pose</source>
        <translation>取位姿處的值</translation>
    </message>
    <message>
        <source>Draw the surfaces at the values of the pose that was found.</source>
        <translation>按所找到的位姿的值繪製等值面。</translation>
    </message>
    <message>
        <source>Position at which the surfaces are drawn: %1</source>
        <translation>繪製等值面的位置：%1</translation>
    </message>
    <message>
        <source>Angle at which the surfaces are drawn: %1</source>
        <translation>繪製等值面的角度：%1</translation>
    </message>
</context>
<context>
    <name>bask::IdentifiedLosses</name>
    <message>
        <source>Losses from the record</source>
        <translation>由記錄得出的損失</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>物體</translation>
    </message>
    <message>
        <source>At</source>
        <translation>溫度</translation>
    </message>
    <message>
        <source>Loss, K/s</source>
        <translation>損失，K/s</translation>
    </message>
    <message>
        <source>Median temperature of the record&apos;s second half</source>
        <translation>記錄後半段的中位溫度</translation>
    </message>
    <message>
        <source>What radiation and air take together, less what the room gives, with its standard error</source>
        <translation>輻射與空氣共同帶走的熱量減去室內給予的熱量，附標準誤差</translation>
    </message>
    <message>
        <source>Convection of the air, from the curvature of the radiation&apos;s fourth power</source>
        <translation>空氣的對流係數，由輻射四次方的曲率得出</translation>
    </message>
    <message>
        <source>not told</source>
        <translation>無法確定</translation>
    </message>
    <message>
        <source>Its change with the object&apos;s temperature: %1 1/s</source>
        <translation>它隨物體溫度的變化：%1 1/s</translation>
    </message>
</context>
<context>
    <name>bask::IdentifiedTable</name>
    <message>
        <source>Heat rates from the record</source>
        <translation>由記錄得出的熱速率</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>物體</translation>
    </message>
    <message>
        <source>Identified</source>
        <translation>辨識值</translation>
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
        <translation>對整個記錄作最小平方得到的 λ₁ 及其標準誤差</translation>
    </message>
    <message>
        <source>λ₁ that the controller believed at the end</source>
        <translation>控制器最後所認定的 λ₁</translation>
    </message>
    <message>
        <source>λ₁ of the experiment&apos;s material and source</source>
        <translation>由實驗的材料和熱源得到的 λ₁</translation>
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
        <translation>開始時</translation>
    </message>
    <message>
        <source>λ₁ with which the controller began</source>
        <translation>控制器起始時所用的 λ₁</translation>
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
        <translation>%1，未閉合</translation>
    </message>
    <message>
        <source>&amp;Outlines</source>
        <translation>輪廓(&amp;O)</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>面積</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>匯入</translation>
    </message>
    <message>
        <source>Import an outline</source>
        <translation>匯入輪廓</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>輪廓</translation>
    </message>
    <message>
        <source>Outline %1: %2 points, %3 around.</source>
        <translation>輪廓 %1：%2 個點，周長 %3。</translation>
    </message>
    <message>
        <source>Outlines of the file</source>
        <translation>檔案中的輪廓</translation>
    </message>
    <message>
        <source>Reading the file</source>
        <translation>正在讀取檔案</translation>
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
        <translation>已從面積中扣除 %1。</translation>
    </message>
    <message>
        <source>units</source>
        <translation>單位</translation>
    </message>
    <message>
        <source>The outline is %1 across; an object may be %2 at most. Correct its size.</source>
        <translation>輪廓寬 %1；物體最大為 %2。請更正其尺寸。</translation>
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
        <translation>長度(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Scale</source>
        <translation>比例(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Scale from</source>
        <translation>比例來源(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Tolerance</source>
        <translation>容差(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Unit</source>
        <translation>單位(&amp;U)</translation>
    </message>
    <message>
        <source>A printed ArUco marker lies beside the object, in the plane of its face. It tells the scale and undoes the perspective.</source>
        <translation>物體旁有列印的 ArUco 標記，與物體表面共面。由它得出比例並消除透視。</translation>
    </message>
    <message>
        <source>Click its two ends</source>
        <translation>請按一下其兩端</translation>
    </message>
    <message>
        <source>Click the object</source>
        <translation>請按一下物體</translation>
    </message>
    <message>
        <source>Dictionary of the marker</source>
        <translation>標記的字典</translation>
    </message>
    <message>
        <source>Largest distance from the colour clicked, in CIE Lab; 0: found by itself</source>
        <translation>與所點選顏色的最大距離（CIE Lab）；0：自動確定</translation>
    </message>
    <message>
        <source>Lay the ruler over a length that you know: drag its ends, or click both. The picture must be taken straight from above.</source>
        <translation>將標尺置於已知長度之上：拖曳其兩端，或按一下兩端。圖片必須從正上方拍攝。</translation>
    </message>
    <message>
        <source>Length of the ruler</source>
        <translation>標尺的長度</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>物體</translation>
    </message>
    <message>
        <source>Otherwise by the picture’s opacity or brightness.</source>
        <translation>否則按圖片的不透明度或亮度。</translation>
    </message>
    <message>
        <source>S&amp;ide of its square</source>
        <translation>其方形的邊長(&amp;I)</translation>
    </message>
    <message>
        <source>Scale of the picture, pixels per millimetre</source>
        <translation>圖片的比例，每毫米像素數</translation>
    </message>
    <message>
        <source>Side of the marker’s black square</source>
        <translation>標記黑色方形的邊長</translation>
    </message>
    <message>
        <source>The picture must be taken straight from above, or scanned.</source>
        <translation>圖片必須從正上方拍攝，或為掃描件。</translation>
    </message>
    <message>
        <source>Tolerance of the colour</source>
        <translation>顏色容差</translation>
    </message>
    <message>
        <source>Unit of the coordinates</source>
        <translation>座標的單位</translation>
    </message>
    <message>
        <source>What gives the picture its scale</source>
        <translation>由什麼確定圖片的比例</translation>
    </message>
    <message>
        <source>a known length</source>
        <translation>已知長度</translation>
    </message>
    <message>
        <source>an ArUco marker in it</source>
        <translation>圖中的 ArUco 標記</translation>
    </message>
    <message>
        <source>as its header says</source>
        <translation>按檔頭</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>自動</translation>
    </message>
    <message>
        <source>pixels per millimetre</source>
        <translation>每毫米像素數</translation>
    </message>
    <message>
        <source>tell it by its colour</source>
        <translation>按顏色識別</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>寬度(&amp;W)</translation>
    </message>
    <message>
        <source>Width of the outline chosen</source>
        <translation>所選輪廓的寬度</translation>
    </message>
    <message>
        <source>As the drawing says. Type another to make all of it larger or smaller.</source>
        <translation>按圖形中的值。輸入其他值可將整體放大或縮小。</translation>
    </message>
    <message>
        <source>Its true size is not known yet: choose the unit above.</source>
        <translation>其真實尺寸尚不清楚：請在上面選擇單位。</translation>
    </message>
    <message>
        <source>Its true size is not known yet: lay the ruler over the length above.</source>
        <translation>其真實尺寸尚不清楚：請將標尺置於上面的長度之上。</translation>
    </message>
    <message>
        <source>Its true size is not known yet: type the length of the ruler above.</source>
        <translation>其真實尺寸尚不清楚：請在上面輸入標尺的長度。</translation>
    </message>
    <message>
        <source>Its true size is not known yet: type the scale above.</source>
        <translation>其真實尺寸尚不清楚：請在上面輸入比例。</translation>
    </message>
    <message>
        <source>Its true size is not known yet: type the side of the marker’s square above.</source>
        <translation>其真實尺寸尚不清楚：請在上面輸入標記方形的邊長。</translation>
    </message>
</context>
<context>
    <name>bask::InfeasibleDialog</name>
    <message>
        <source>Start all the same; the recording says so</source>
        <translation>仍然開始；記錄中會註明</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>開始</translation>
    </message>
    <message>
        <source>Targets out of reach</source>
        <translation>目標無法達到</translation>
    </message>
    <message>
        <source>The run would end at the best compromise it finds.
The Targets page says more and offers the nearest targets that can be held.</source>
        <translation>運轉將止於所找到的最佳折衷處。
「目標」頁面有詳細說明，並給出可保持的最近目標。</translation>
    </message>
</context>
<context>
    <name>bask::JogPanel</name>
    <message>
        <source>Step</source>
        <translation>步長</translation>
    </message>
    <message>
        <source>Step along an axis</source>
        <translation>沿軸的步長</translation>
    </message>
    <message>
        <source>Step about an axis</source>
        <translation>繞軸的步長</translation>
    </message>
    <message>
        <source>Speed while held</source>
        <translation>按住時的速度</translation>
    </message>
    <message>
        <source>Of the largest speed that the robot&apos;s limits allow</source>
        <translation>佔機器人限值所允許最大速度的比例</translation>
    </message>
    <message>
        <source>Go to</source>
        <translation>前往位置</translation>
    </message>
    <message>
        <source>One step of %1 down</source>
        <translation>%1 減小一步</translation>
    </message>
    <message>
        <source>One step of %1 up</source>
        <translation>%1 增大一步</translation>
    </message>
    <message>
        <source>%1 downwards for as long as this is held</source>
        <translation>按住期間 %1 持續減小</translation>
    </message>
    <message>
        <source>%1 upwards for as long as this is held</source>
        <translation>按住期間 %1 持續增大</translation>
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
        <translation>運動到這些座標；「保持」（F7）可使其結束</translation>
    </message>
    <message>
        <source>Here</source>
        <translation>此處</translation>
    </message>
    <message>
        <source>Put in where the robot is</source>
        <translation>填入機器人的目前位置</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>回原點</translation>
    </message>
    <message>
        <source>The robot seeks its switches to know its place: it moves</source>
        <translation>機器人尋找限位開關以確定自身位置：它會運動</translation>
    </message>
    <message>
        <source>Clear alarm</source>
        <translation>清除警報</translation>
    </message>
    <message>
        <source>After you have seen to it: the robot is where it says. Nothing moves.</source>
        <translation>請在處理之後使用：確認機器人就在它所報的位置。沒有運動。</translation>
    </message>
    <message>
        <source>Place UNKNOWN. What stands below is %1.</source>
        <translation>位置未知。以下數值：%1。</translation>
    </message>
    <message>
        <source>Place UNKNOWN: the robot has not told it yet.</source>
        <translation>位置未知：機器人尚未告知。</translation>
    </message>
    <message>
        <source>Confirm its place</source>
        <translation>確認其位置</translation>
    </message>
</context>
<context>
    <name>bask::LabelsDialog</name>
    <message>
        <source>Before the run</source>
        <translation>運轉之前</translation>
    </message>
    <message>
        <source>Operator and sample</source>
        <translation>操作員和樣品</translation>
    </message>
    <message>
        <source>The run that is on has it; it can be changed after the run.</source>
        <translation>正在進行的運轉使用它；運轉之後可以變更。</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>操作員</translation>
    </message>
    <message>
        <source>Sample</source>
        <translation>樣品</translation>
    </message>
    <message>
        <source>Batch</source>
        <translation>批次</translation>
    </message>
    <message>
        <source>Recordings, reports and the list of runs show them. Each command, note and acknowledgement is recorded with its operator.</source>
        <translation>記錄、報告和運轉清單都會顯示它們。每個命令、備註和確認都連同其操作員一起記錄。</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>待命</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>確定</translation>
    </message>
    <message>
        <source>Ask at each Arm</source>
        <translation>每次待命時詢問</translation>
    </message>
</context>
<context>
    <name>bask::LargeNumbers</name>
    <message>
        <source>Run %1</source>
        <comment>%1 is the time since Start</comment>
        <translation>運轉 %1</translation>
    </message>
    <message>
        <source>Source %1</source>
        <comment>%1 is its newest temperature</comment>
        <translation>熱源 %1</translation>
    </message>
    <message>
        <source>The engine is not answering: what is shown is old.</source>
        <translation>引擎沒有回應：所顯示的內容已過時。</translation>
    </message>
    <message>
        <source>Bask: large numbers</source>
        <translation>Bask：大型數字</translation>
    </message>
    <message>
        <source>In %1 s: %2</source>
        <comment>seconds, and what the engine does then</comment>
        <translation>%1 s 後：%2</translation>
    </message>
</context>
<context>
    <name>bask::LimitsPanel</name>
    <message>
        <source>Heat source</source>
        <translation>熱源</translation>
    </message>
    <message>
        <source>Measured temperature</source>
        <translation>測得的溫度</translation>
    </message>
    <message>
        <source>Set point of runs</source>
        <translation>運轉的設定值</translation>
    </message>
    <message>
        <source>Emittance</source>
        <translation>發射率</translation>
    </message>
    <message>
        <source>Emittance of the source</source>
        <translation>熱源的發射率</translation>
    </message>
    <message>
        <source>Workspace of the end-effector</source>
        <translation>末端執行器的工作空間</translation>
    </message>
    <message>
        <source>From</source>
        <translation>從</translation>
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
        <translation>運動限值</translation>
    </message>
    <message>
        <source>%1: %2 instead of %3</source>
        <translation>%1：%2，而不是 %3</translation>
    </message>
    <message>
        <source>Evenness</source>
        <translation>均勻性</translation>
    </message>
</context>
<context>
    <name>bask::LivePicture</name>
    <message>
        <source>%1 pictures/s</source>
        <translation>%1 影格/s</translation>
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
        <translation>相機即時影像</translation>
    </message>
    <message>
        <source>No picture yet: no camera is running.</source>
        <translation>尚無影像：沒有相機在運作。</translation>
    </message>
    <message>
        <source>Nothing is found in the picture</source>
        <translation>影像中未找到任何內容</translation>
    </message>
    <message>
        <source>age %1 s</source>
        <translation>時齡 %1 s</translation>
    </message>
    <message>
        <source>base</source>
        <translation>基座</translation>
    </message>
    <message>
        <source>end-effector</source>
        <translation>末端執行器</translation>
    </message>
    <message>
        <source>latency %1 ms</source>
        <translation>延遲 %1 ms</translation>
    </message>
    <message>
        <source>marker %1</source>
        <translation>標記 %1</translation>
    </message>
    <message>
        <source>marker %1, %2</source>
        <translation>標記 %1，%2</translation>
    </message>
    <message>
        <source>simulated</source>
        <translation>模擬</translation>
    </message>
    <message>
        <source>source</source>
        <translation>熱源</translation>
    </message>
    <message>
        <source>source predicted</source>
        <translation>熱源為預測</translation>
    </message>
    <message>
        <source>source searched</source>
        <translation>正在尋找熱源</translation>
    </message>
    <message>
        <source>source tracked</source>
        <translation>正在追蹤熱源</translation>
    </message>
    <message>
        <source>the board</source>
        <translation>校正板</translation>
    </message>
    <message>
        <source>two poses</source>
        <translation>兩種位姿</translation>
    </message>
</context>
<context>
    <name>bask::MainWindow</name>
    <message>
        <source>Not taken: the targets stay as they were.</source>
        <translation>未採用：目標保持原樣。</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>頁面</translation>
    </message>
    <message>
        <source>Arm the real rig</source>
        <translation>使實際實驗台進入待命</translation>
    </message>
    <message>
        <source>This rig is real: once the run is started, the robot moves and the source heats. Is everybody and everything out of the way?</source>
        <translation>這是實際的實驗台：一旦開始運轉，機器人就會運動，熱源就會加熱。所有人員和物品都已避開了嗎？</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>待命</translation>
    </message>
    <message>
        <source>Only files of this computer can be opened: save it here first.</source>
        <translation>只能開啟此電腦上的檔案：請先將其儲存到此處。</translation>
    </message>
    <message>
        <source>Only one file can be opened at a time.</source>
        <translation>一次只能開啟一個檔案。</translation>
    </message>
    <message>
        <source>Unsaved edits cannot be kept for a crash: %1</source>
        <translation>無法為防備當機而保留未儲存的變更：%1</translation>
    </message>
    <message>
        <source>From the next start of Bask on, text and all that is drawn with it has %1 % of its size.</source>
        <translation>從 Bask 下次啟動起，文字及隨之繪製的一切將為原大小的 %1 %。</translation>
    </message>
    <message>
        <source>The window will then be larger than this screen.</source>
        <translation>屆時視窗將大於此螢幕。</translation>
    </message>
    <message>
        <source>Bask closes when the objects are away from the source.</source>
        <translation>物體離開熱源後，Bask 即關閉。</translation>
    </message>
    <message>
        <source>Retreat</source>
        <translation>撤離</translation>
    </message>
    <message>
        <source>Retreat now</source>
        <translation>立即撤離</translation>
    </message>
    <message>
        <source>This was the horn: the desktop&apos;s bell. If you heard nothing, it is off in the desktop&apos;s settings.</source>
        <translation>剛才是警報聲：桌面的提示音。若沒有聽到，表示它在桌面設定中已關閉。</translation>
    </message>
    <message>
        <source>Bask stays open: the run ended by a fault. Look at the alarms.</source>
        <translation>Bask 保持開啟：運轉因故障結束。請查看警報。</translation>
    </message>
    <message>
        <source>Simulated faults are active: %1. Tools &gt; Simulate fault ends them.</source>
        <translation>有啟用的模擬故障：%1。可在「工具 &gt; 模擬故障」中結束。</translation>
    </message>
    <message>
        <source>The objects are over the source, which has %1: its heat reaches them although no run is on. Warm sensors cannot be zeroed, and a run begins with objects as warm as they are then. Retreat takes them away.</source>
        <translation>物體在熱源上方，熱源為 %1：雖然沒有運轉，熱量仍會到達物體。變熱的感測器無法歸零，運轉將以物體當時的溫度開始。「撤離」會將其移開。</translation>
    </message>
    <message>
        <source>source %1 of %2</source>
        <comment>temperatures: that of now, and the set point</comment>
        <translation>熱源 %1 / %2</translation>
    </message>
    <message>
        <source>over hot source: %1</source>
        <comment>the objects are over it; its temperature</comment>
        <translation>物體下方熱源：%1</translation>
    </message>
    <message>
        <source>Arm the simulated rig</source>
        <translation>使模擬實驗台進入待命</translation>
    </message>
    <message>
        <source>The robot will move: it takes the objects away from the source, and the heat goes off. Are all hands off the robot and is nothing in its way?</source>
        <translation>機器人即將運動：使物體離開熱源，並關閉加熱。所有人的手都已離開機器人，且路徑上沒有障礙嗎？</translation>
    </message>
    <message>
        <source>Home the robot</source>
        <translation>機器人回原點</translation>
    </message>
    <message>
        <source>Home now</source>
        <translation>立即回原點</translation>
    </message>
    <message>
        <source>The question &quot;%1&quot; was closed: the state has changed since it was asked.</source>
        <translation>問題「%1」已關閉：提出後狀態已改變。</translation>
    </message>
    <message>
        <source>ready in %1 s</source>
        <comment>readings are being collected</comment>
        <translation>%1 s 後就緒</translation>
    </message>
    <message>
        <source>The robot will move: it seeks its switches to know its place. Are all hands off the robot and is nothing in its way?</source>
        <translation>機器人即將運動：它尋找其極限開關以確定位置。所有人的手是否都已離開機器人，其路徑上是否沒有障礙？</translation>
    </message>
    <message>
        <source>%1. Are they mounted so all the same?</source>
        <translation>%1。它們確實是這樣安裝的嗎？</translation>
    </message>
    <message>
        <source>Nothing else begins while the question &quot;%1&quot; is open: answer it first. Hold, Stop and STOP are possible.</source>
        <translation>問題「%1」未回答之前，不會開始任何其他操作：請先回答。「保持」、「停止」和「軟體停止」仍可使用。</translation>
    </message>
    <message>
        <source>Ready, but: %1. Arm asks about it.</source>
        <translation>就緒，但是：%1。「待命」時會詢問。</translation>
    </message>
    <message>
        <source>Ready; whether the targets can be held is being checked.</source>
        <translation>就緒；正在檢查目標能否保持。</translation>
    </message>
    <message>
        <source>Ready, but: %1. Start asks about it.</source>
        <translation>就緒，但是：%1。「開始」時會詢問。</translation>
    </message>
    <message>
        <source>objects overlap</source>
        <translation>物體重疊</translation>
    </message>
    <message>
        <source>cannot be held</source>
        <comment>the targets</comment>
        <translation>目標無法保持</translation>
    </message>
    <message>
        <source>STOP was pressed</source>
        <translation>已按軟體停止</translation>
    </message>
    <message>
        <source>The targets cannot be held: %1. Start asks about it.</source>
        <translation>目標無法保持：%1。「開始」時會詢問。</translation>
    </message>
    <message>
        <source>The objects stay where they are, near the source, and go on towards the temperature that they reach there; Retreat takes them away.</source>
        <translation>物體停在熱源附近原處，溫度會繼續趨向該處的終值；「撤離」可使其離開。</translation>
    </message>
</context>
<context>
    <name>bask::ManualWindow</name>
    <message>
        <source>Bask: manual</source>
        <translation>Bask：手冊</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>返回</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>目錄</translation>
    </message>
    <message>
        <source>Find in the manual</source>
        <translation>在手冊中尋找</translation>
    </message>
    <message>
        <source>Text of the manual</source>
        <translation>手冊內文</translation>
    </message>
    <message>
        <source>This page is in English only.</source>
        <translation>本頁只有英文版。</translation>
    </message>
</context>
<context>
    <name>bask::MarkerEditor</name>
    <message>
        <source>%1 px off</source>
        <translation>偏離 %1 px</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>新增</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>基座</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>相機</translation>
    </message>
    <message>
        <source>Dictionary</source>
        <translation>字典</translation>
    </message>
    <message>
        <source>End-effector</source>
        <translation>末端執行器</translation>
    </message>
    <message>
        <source>Id</source>
        <translation>編號</translation>
    </message>
    <message>
        <source>Lists another marker: one that the camera sees and that is not listed, if there is one</source>
        <translation>再列入一個標記：若有相機見到而未列入的標記，則列入它</translation>
    </message>
    <message>
        <source>Markers of the rig</source>
        <translation>實驗台上的標記</translation>
    </message>
    <message>
        <source>On</source>
        <translation>位於</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>邊長</translation>
    </message>
    <message>
        <source>Side, mm</source>
        <translation>邊長，mm</translation>
    </message>
    <message>
        <source>Sits on</source>
        <translation>所在部位</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>熱源</translation>
    </message>
    <message>
        <source>Where the marker&apos;s middle is on its part, and how its axes (x right, y up, z out of it) are turned there</source>
        <translation>標記中心在其部位上的位置，以及其座標軸（x 向右，y 向上，z 向外）在該處如何轉動</translation>
    </message>
    <message>
        <source>With the black border, as measured on the print</source>
        <translation>含黑色邊框，按列印稿實測</translation>
    </message>
    <message>
        <source>about y, °</source>
        <translation>繞 y，°</translation>
    </message>
    <message>
        <source>about z, °</source>
        <translation>繞 z，°</translation>
    </message>
    <message>
        <source>not seen</source>
        <translation>未見到</translation>
    </message>
    <message>
        <source>seen</source>
        <translation>已見到</translation>
    </message>
    <message>
        <source>turned about x, °</source>
        <translation>繞 x 轉動，°</translation>
    </message>
    <message>
        <source>two poses fit</source>
        <translation>符合兩種位姿</translation>
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
        <translation>您的材料庫無法使用，並保持原樣：%1。請修復該檔案或將其移到別處。</translation>
    </message>
    <message>
        <source>Import materials</source>
        <translation>匯入材料</translation>
    </message>
    <message>
        <source>Materials (*.json);;All files (*)</source>
        <translation>材料 (*.json);;所有檔案 (*)</translation>
    </message>
    <message>
        <source>%1: %2 added, %3 of them under another name, since theirs was taken; %4 were there already.</source>
        <translation>%1：已加入 %2 種，其中 %3 種因名稱已被占用而改名；%4 種原已存在。</translation>
    </message>
    <message>
        <source>Export the library of materials</source>
        <translation>匯出材料庫</translation>
    </message>
    <message>
        <source>Materials (*.json)</source>
        <translation>材料 (*.json)</translation>
    </message>
    <message>
        <source>%1 was written.</source>
        <translation>已寫入 %1。</translation>
    </message>
</context>
<context>
    <name>bask::MaterialsDialog</name>
    <message>
        <source>Rename</source>
        <translation>重新命名</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Import…</source>
        <translation>匯入…</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>匯出…</translation>
    </message>
    <message>
        <source>Materials</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>關閉</translation>
    </message>
    <message>
        <source>The library is empty. “Save as material” on the Objects page adds an object&apos;s material, Import those of a file.</source>
        <translation>材料庫是空的。「物體」頁上的「另存為材料」可加入物體的材料，「匯入」可加入檔案中的材料。</translation>
    </message>
    <message>
        <source>“%1” was removed.</source>
        <translation>已移除「%1」。</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>復原</translation>
    </message>
</context>
<context>
    <name>bask::MessageBar</name>
    <message>
        <source>Close the message</source>
        <translation>關閉此訊息</translation>
    </message>
    <message>
        <source>Problem</source>
        <translation>問題</translation>
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
        <translation>起點未知</translation>
    </message>
    <message>
        <source>step too small</source>
        <translation>步階太小</translation>
    </message>
    <message>
        <source>not reached</source>
        <translation>未達到</translation>
    </message>
    <message>
        <source>none</source>
        <translation>無</translation>
    </message>
    <message>
        <source>not settled</source>
        <translation>未穩定</translation>
    </message>
    <message>
        <source>%1 (s.d. %2)</source>
        <comment>mean with its unit, standard deviation without</comment>
        <translation>%1（標準差 %2）</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>目標</translation>
    </message>
    <message>
        <source>Final</source>
        <translation>最終</translation>
    </message>
    <message>
        <source>Settling time</source>
        <translation>穩定時間</translation>
    </message>
    <message>
        <source>Rise time</source>
        <translation>上升時間</translation>
    </message>
    <message>
        <source>Overshoot</source>
        <translation>過衝</translation>
    </message>
    <message>
        <source>Steady-state error</source>
        <translation>穩態誤差</translation>
    </message>
    <message>
        <source>Path length</source>
        <translation>路徑長度</translation>
    </message>
    <message>
        <source>Duration of control</source>
        <translation>控制持續時間</translation>
    </message>
    <message>
        <source>Path of the end-effector</source>
        <translation>末端執行器的路徑</translation>
    </message>
    <message>
        <source>Rotation of the end-effector</source>
        <translation>末端執行器的轉動</translation>
    </message>
    <message>
        <source>Time at a velocity limit</source>
        <translation>處於速度限值的時間</translation>
    </message>
    <message>
        <source>Time at any limit</source>
        <translation>處於任一限值的時間</translation>
    </message>
    <message>
        <source>The last target that was set. The other numbers count from that moment, or from Start when it was not changed, until Stop.</source>
        <translation>最後設定的目標。其餘數值從該時刻（若未更改過，則從「開始」）算起，到「停止」為止。</translation>
    </message>
    <message>
        <source>How far the temperature went beyond the target in the direction of the step, and as a share of the step. Not given for steps under twice the band.</source>
        <translation>溫度沿步階方向超出目標的量，以及它佔步階的比例。步階小於容差帶兩倍時不給出。</translation>
    </message>
    <message>
        <source>From Start until Stop.</source>
        <translation>從「開始」到「停止」。</translation>
    </message>
    <message>
        <source>Sum of the angles by which the end-effector was turned from sample to sample.</source>
        <translation>各取樣之間末端執行器所轉角度之和。</translation>
    </message>
    <message>
        <source>Time in which the limit of speed or of rotation held the command back.</source>
        <translation>指令受速度限值或轉動限值約束的時間。</translation>
    </message>
    <message>
        <source>Time in which a limit of any kind held the command back: speed, rotation, acceleration, clearance or workspace.</source>
        <translation>指令受任何一種限值約束的時間：速度、轉動、加速度、間距或工作空間。</translation>
    </message>
    <message>
        <source>no samples</source>
        <translation>沒有取樣</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>%1, true</source>
        <comment>a metric by the true temperature</comment>
        <translation>%1（真實）</translation>
    </message>
    <message>
        <source>The same by the simulated object&apos;s own temperature, which no sensor tells.</source>
        <translation>按模擬物體自身的溫度計算的同一指標，沒有感測器能讀到該溫度。</translation>
    </message>
    <message>
        <source>What the object&apos;s thermometer read at the last sample until Stop. The other numbers take its readings, too. ± is the standard uncertainty: of a sensor that of the room&apos;s temperature to which it was zeroed, of its zeroing, and of step and noise of its readings, without its own error away from the room&apos;s temperature and that of its contact.</source>
        <translation>物體的溫度計在到「停止」為止的最後一個取樣時的讀數。其他數值也取其讀數。± 為標準不確定度：對感測器而言，來自歸零所依據的室溫、歸零本身以及讀數的步長和雜訊，不包括其遠離室溫時自身的誤差和接觸的誤差。</translation>
    </message>
    <message>
        <source>Mean of temperature minus target over the last %1 s until Stop, or since settling where that is less, with its standard uncertainty (±) and the standard deviation of the samples.</source>
        <translation>到「停止」為止的最後 %1 s 內（若穩定後的時間更短，則自穩定時起）溫度減目標的平均值，附其標準不確定度（±）和各取樣的標準差。</translation>
    </message>
    <message>
        <source>, not sure</source>
        <comment>after a number</comment>
        <translation>，不確定</translation>
    </message>
    <message>
        <source>Time until the temperature stays within %1 of the target until Stop. The event &quot;All objects settled&quot; is another and comes later: when all objects have been so near for %2 s by the controller&apos;s estimates, and the robot needs no other place. ± is its standard uncertainty: how far readings that are wrong by theirs move that moment, and the period. Not sure: with such an error it would be outside at the end.</source>
        <translation>直到溫度進入目標的 %1 以內並保持到「停止」為止所需的時間。事件「所有物體均已穩定」是另一回事，並且更晚：依控制器的估計，全部物體已如此接近 %2 s，且機器人無需再去別處。± 為其標準不確定度：讀數偏差為其不確定度時該時刻移動多少，以及週期。「不確定」：有這樣的誤差時，結束時溫度在範圍之外。</translation>
    </message>
    <message>
        <source>Time between the first crossings of 10 % and of 90 % of the step, which leads from the temperature when the target was set to the target. Not given for steps under twice the band. ± is its standard uncertainty: how far wrong readings at the beginning and at both crossings move these.</source>
        <translation>首次越過步階的 10 % 與首次越過 90 % 之間的時間；步階從設定目標時的溫度到目標為止。步階小於容差帶兩倍時不給出。± 為其標準不確定度：開始時和兩次越過時的讀數誤差使其移動多少。</translation>
    </message>
    <message>
        <source>Length of the path of the object&apos;s centre in the robot&apos;s base, from Start until Stop, by the robot&apos;s reported places, whose uncertainty no device tells.</source>
        <translation>從「開始」到「停止」，物體中心在機器人基座座標系中所走路徑的長度，按機器人回報的位置計算，沒有裝置給出其不確定度。</translation>
    </message>
    <message>
        <source>Length of the path of the end-effector&apos;s origin in the robot&apos;s base, from Start until Stop, by the robot&apos;s reported places, whose uncertainty no device tells.</source>
        <translation>從「開始」到「停止」，末端執行器原點在機器人基座座標系中所走路徑的長度，按機器人回報的位置計算，沒有裝置給出其不確定度。</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>步階</translation>
    </message>
    <message>
        <source>%1 at %2 s</source>
        <comment>difference of temperatures; time of the run</comment>
        <translation>%1，始於 %2 s</translation>
    </message>
    <message>
        <source>The target minus the temperature when it was set: at Start, or at the time beside it where the target was changed during the run. Times, overshoot and steady-state error are of this step.</source>
        <translation>目標減去設定目標時的溫度：設定於開始時；若運轉中更改過目標，則為旁邊標明的時刻。時間、過衝和穩態誤差均針對這一步階。</translation>
    </message>
</context>
<context>
    <name>bask::MetricsPanel</name>
    <message>
        <source>How these numbers are defined</source>
        <translation>這些數值的定義</translation>
    </message>
    <message>
        <source>Metrics of the run</source>
        <translation>本次運轉的指標</translation>
    </message>
</context>
<context>
    <name>bask::MonitorControl</name>
    <message>
        <source>Monitoring is off: %1</source>
        <translation>監視已關閉：%1</translation>
    </message>
</context>
<context>
    <name>bask::MonitorDialog</name>
    <message>
        <source>Publish to an MQTT broker</source>
        <translation>發佈到 MQTT 代理</translation>
    </message>
    <message>
        <source>Write status files</source>
        <translation>寫入狀態檔案</translation>
    </message>
    <message>
        <source>Monitoring</source>
        <translation>監視</translation>
    </message>
    <message>
        <source>Encrypted (TLS)</source>
        <translation>加密（TLS）</translation>
    </message>
    <message>
        <source>those of the system</source>
        <translation>系統的憑證</translation>
    </message>
    <message>
        <source>Its first line is the password; nobody else may read the file.</source>
        <translation>首行為密碼；其他人不得讀取此檔案。</translation>
    </message>
    <message>
        <source>In front of all topics, with a slash: lab2/bask becomes lab2/bask/status and so on.</source>
        <translation>置於所有主題之前，以斜線分隔：lab2/bask 成為 lab2/bask/status 等。</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>位址</translation>
    </message>
    <message>
        <source>Trusted certificates</source>
        <translation>受信任的憑證</translation>
    </message>
    <message>
        <source>User</source>
        <translation>使用者</translation>
    </message>
    <message>
        <source>File with the password</source>
        <translation>密碼檔案</translation>
    </message>
    <message>
        <source>Topic</source>
        <translation>主題</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>資料夾</translation>
    </message>
    <message>
        <source>Folder of the status files</source>
        <translation>狀態檔案的資料夾</translation>
    </message>
    <message>
        <source>Bask publishes only: nobody can give it an order this way, and it opens no port. The setting belongs to this computer; no experiment can switch it on.</source>
        <translation>Bask 只發佈：任何人都不能以這種方式對它下達命令，它也不開啟任何連接埠。此設定屬於這部電腦；任何實驗都不能將其開啟。</translation>
    </message>
    <message>
        <source>Test</source>
        <translation>測試</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>確定</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>選擇…</translation>
    </message>
    <message>
        <source>Trying…</source>
        <translation>正在嘗試…</translation>
    </message>
    <message>
        <source>It works: everything that is ticked has taken a message.</source>
        <translation>可以使用：所有勾選項目都收到了一則訊息。</translation>
    </message>
    <message>
        <source>Without TLS the password goes over the network in clear text.</source>
        <translation>沒有 TLS，密碼將以明文透過網路傳送。</translation>
    </message>
</context>
<context>
    <name>bask::MountingPlan</name>
    <message>
        <source>Plan of the objects on the end-effector</source>
        <translation>物體在末端執行器上的平面圖</translation>
    </message>
    <message>
        <source>The objects on the end-effector, to scale. Drag one to move it in steps of 5 mm, its handle to turn it in steps of 5°; with Alt finely. Arrow keys move the selected one by 1 mm, Page Up and Page Down turn it.</source>
        <translation>末端執行器上的物體，按比例繪製。拖曳物體可按 5 mm 的步長移動，拖曳其控制點可按 5° 的步長轉動；按住 Alt 可微調。方向鍵使所選物體移動 1 mm，Page Up 和 Page Down 使其轉動。</translation>
    </message>
    <message>
        <source>Grid %1, snap %2</source>
        <translation>網格 %1，貼齊 %2</translation>
    </message>
    <message>
        <source>x %1 cm, y %2 cm, %3°</source>
        <translation>x %1 cm，y %2 cm，%3°</translation>
    </message>
    <message>
        <source>Objects on the end-effector from the front</source>
        <translation>末端執行器上的物體，正視圖</translation>
    </message>
    <message>
        <source>Objects on the end-effector from the side</source>
        <translation>末端執行器上的物體，側視圖</translation>
    </message>
    <message>
        <source>The objects edge-on, to the scale of the plan. Drag one to change its height in steps of 5 mm, its handle to tilt it in steps of 5°; with Alt finely. Arrow keys move the selected one by 1 mm, Page Up and Page Down tilt it.</source>
        <translation>從側面看到的物體，比例與平面圖相同。拖曳物體可按 5 mm 的步長改變高度，拖曳其控制點可按 5° 的步長傾斜；按住 Alt 可微調。方向鍵使所選物體移動 1 mm，Page Up 和 Page Down 使其傾斜。</translation>
    </message>
    <message>
        <source>z %1 cm, tilt %2° about x, %3° about y</source>
        <translation>z %1 cm，繞 x 傾斜 %2°，繞 y 傾斜 %3°</translation>
    </message>
    <message>
        <source>Arrows: where the heated faces look</source>
        <translation>箭頭：受熱面的朝向</translation>
    </message>
</context>
<context>
    <name>bask::MountingViews</name>
    <message>
        <source>Heights and tilts</source>
        <translation>高度與傾角</translation>
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
        <translation>側面</translation>
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
        <translation>「%1」不是數字；數值保持不變</translation>
    </message>
    <message>
        <source>“%1” is out of range; allowed: %2 to %3</source>
        <translation>「%1」超出範圍；允許：%2 至 %3</translation>
    </message>
    <message>
        <source>“%1” was not taken: this value has no unit</source>
        <translation>未採用「%1」：此值沒有單位</translation>
    </message>
    <message>
        <source>“%1” was not taken: %2 is not a unit of this value, which is in %3</source>
        <translation>未採用「%1」：%2 不是此值的單位，此值以 %3 為單位</translation>
    </message>
    <message>
        <source>“%1” may be one of two numbers: type %2 or %3</source>
        <translation>「%1」可能是兩個數之一：請輸入 %2 或 %3</translation>
    </message>
    <message>
        <source>“%1” was not taken: with the digits of this field it would be %2</source>
        <translation>未採用「%1」：按此欄位的位數將變為 %2</translation>
    </message>
    <message>
        <source>“%1” is out of range; allowed: more than %2, up to %3</source>
        <translation>「%1」超出範圍；允許：大於 %2，至 %3</translation>
    </message>
</context>
<context>
    <name>bask::ObjectList</name>
    <message>
        <source>disk, %1 cm</source>
        <translation>圓盤，%1 cm</translation>
    </message>
    <message>
        <source>polygon</source>
        <translation>多邊形</translation>
    </message>
    <message>
        <source>Objects</source>
        <translation>物體</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <comment>kind and target of an object</comment>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>%1: %2. Press F2 to rename.</source>
        <translation>%1：%2。按 F2 重新命名。</translation>
    </message>
</context>
<context>
    <name>bask::ObjectProperties</name>
    <message>
        <source>Heat capacity</source>
        <translation>熱容</translation>
    </message>
    <message>
        <source>Time constant</source>
        <translation>時間常數</translation>
    </message>
    <message>
        <source>Of the plate, per area that is seen</source>
        <translation>板材的值，按可見面積計</translation>
    </message>
    <message>
        <source>Of small changes about the target</source>
        <translation>目標附近的微小變化</translation>
    </message>
    <message>
        <source>Heating at view factor 1 with the source as it is set</source>
        <translation>角係數為 1、熱源按目前設定時的升溫</translation>
    </message>
    <message>
        <source>Times T⁴: what the object radiates</source>
        <translation>乘以 T⁴：物體輻射出的部分</translation>
    </message>
    <message>
        <source>What the surroundings give</source>
        <translation>來自周圍環境的部分</translation>
    </message>
    <message>
        <source>typed values</source>
        <translation>輸入的值</translation>
    </message>
    <message>
        <source>typed values (%1)</source>
        <translation>輸入的值（%1）</translation>
    </message>
    <message>
        <source>Disk</source>
        <translation>圓盤</translation>
    </message>
    <message>
        <source>Fourier outline, %1</source>
        <translation>傅立葉輪廓，%1</translation>
    </message>
    <message>
        <source>Polygon</source>
        <translation>多邊形</translation>
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
        <translation>物體</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>Mounting on the end-effector</source>
        <translation>在末端執行器上的安裝</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名稱</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>目標</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>半徑</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>面積</translation>
    </message>
    <message>
        <source>Perimeter</source>
        <translation>周長</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>預設</translation>
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
        <translation>繞 z 轉動</translation>
    </message>
    <message>
        <source>Mounting x</source>
        <translation>安裝 x</translation>
    </message>
    <message>
        <source>Mounting y</source>
        <translation>安裝 y</translation>
    </message>
    <message>
        <source>Mounting z</source>
        <translation>安裝 z</translation>
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
        <translation>不計孔時 %1</translation>
    </message>
    <message>
        <source>z, height</source>
        <translation>z，高度</translation>
    </message>
    <message>
        <source>Tilt about x</source>
        <translation>繞 x 傾斜</translation>
    </message>
    <message>
        <source>Tilt about y</source>
        <translation>繞 y 傾斜</translation>
    </message>
    <message>
        <source>The object is turned about the end-effector&apos;s x first, then about its y, then about its z</source>
        <translation>物體先繞末端執行器的 x 軸轉動，再繞 y 軸，然後繞 z 軸</translation>
    </message>
    <message>
        <source>Save as material…</source>
        <translation>另存為材料…</translation>
    </message>
    <message>
        <source>Keeps these values in your library of materials</source>
        <translation>把這些數值存入您的材料庫</translation>
    </message>
    <message>
        <source>Materials…</source>
        <translation>材料…</translation>
    </message>
    <message>
        <source>Your library of materials: see, rename, remove, import and export</source>
        <translation>您的材料庫：檢視、重新命名、移除、匯入和匯出</translation>
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
        <translation>尚無讀數</translation>
    </message>
    <message>
        <source>Heating</source>
        <translation>正在升溫</translation>
    </message>
    <message>
        <source>Cooling</source>
        <translation>正在降溫</translation>
    </message>
    <message>
        <source>Off target</source>
        <comment>steady, outside the tolerance band</comment>
        <translation>偏離目標</translation>
    </message>
    <message>
        <source>Settling</source>
        <translation>正在穩定</translation>
    </message>
    <message>
        <source>Settled</source>
        <translation>已穩定</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>目標</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>誤差</translation>
    </message>
    <message>
        <source>Measured minus target</source>
        <translation>測量值減目標</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>變化率</translation>
    </message>
    <message>
        <source>Object %1</source>
        <translation>物體 %1</translation>
    </message>
    <message>
        <source>Measured temperature of %1</source>
        <translation>%1 的測量溫度</translation>
    </message>
    <message>
        <source>UNKNOWN</source>
        <comment>the temperature of an object</comment>
        <translation>未知</translation>
    </message>
    <message>
        <source>Stale</source>
        <comment>the reading of an object</comment>
        <translation>過時</translation>
    </message>
    <message>
        <source>Not believed</source>
        <comment>the reading of an object</comment>
        <translation>不採信</translation>
    </message>
    <message>
        <source>Confirm</source>
        <translation>確認</translation>
    </message>
    <message>
        <source>Confirm the sensor of %1</source>
        <translation>確認 %1 的感測器</translation>
    </message>
    <message>
        <source>You have looked: the sensor is on its object and right. It is believed again.</source>
        <translation>您已查看：感測器在物體上且正確。將重新採信。</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>熱像儀 %1</translation>
    </message>
    <message>
        <source>Above its warning limit</source>
        <comment>the temperature of an object</comment>
        <translation>超過警告限值</translation>
    </message>
    <message>
        <source>Above its trip limit</source>
        <comment>the temperature of an object</comment>
        <translation>超過跳脫限值</translation>
    </message>
    <message>
        <source>Standard uncertainty %1 %2. Of a sensor it is that of the room&apos;s temperature to which it was zeroed, of its zeroing, and of step and noise of its readings. Not in it: the sensor&apos;s own error away from the room&apos;s temperature, and how well it touches its object.</source>
        <translation>標準不確定度 %1 %2。對感測器而言，它來自歸零所依據的室溫、歸零本身，以及讀數的步長和雜訊。不包括：感測器在遠離室溫時自身的誤差，以及它與物體接觸的好壞。</translation>
    </message>
    <message>
        <source>same for %1 s</source>
        <comment>the value of a frozen sensor</comment>
        <translation>%1 s 未變</translation>
    </message>
    <message>
        <source>same for %1</source>
        <comment>the value of a frozen sensor; %1 is minutes and seconds</comment>
        <translation>%1 未變</translation>
    </message>
    <message>
        <source>Camera %1 (part)</source>
        <translation>熱像儀 %1（部分）</translation>
    </message>
    <message>
        <source>Standard uncertainty of the reading, or what the thermal camera sees of the object, with twice its own; of a reading that is not believed its age, or how long the sensor has told the same value. (part): some of the object is outside of the picture</source>
        <translation>讀數的標準不確定度，或熱像儀所見的物體溫度及其標準不確定度的兩倍；讀數不予採信時，為其時齡，或感測器數值多久未變。（部分）：物體有一部分在影像之外</translation>
    </message>
</context>
<context>
    <name>bask::ObjectsPage</name>
    <message>
        <source>Reading %1…</source>
        <translation>正在讀取 %1…</translation>
    </message>
    <message>
        <source>disk</source>
        <translation>圓盤</translation>
    </message>
    <message>
        <source>“%1” was removed.</source>
        <translation>「%1」已移除。</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>復原</translation>
    </message>
    <message>
        <source>Import an outline</source>
        <translation>匯入輪廓</translation>
    </message>
    <message>
        <source>Outlines (%1);;All files (*)</source>
        <translation>輪廓 (%1);;所有檔案 (*)</translation>
    </message>
    <message>
        <source>A disk is used as it is; it needs no fit.</source>
        <translation>圓盤按原樣使用，不需擬合。</translation>
    </message>
    <message>
        <source>No imported outline is kept with this object, so it cannot be fitted again.</source>
        <translation>此物體未保留匯入的輪廓，因此無法重新擬合。</translation>
    </message>
    <message>
        <source>Each object needs a free axis of the robot of its own; all are used. Remove an object first.</source>
        <translation>每個物體都需要各自的一個機器人自由軸；自由軸已全部用完。請先移除一個物體。</translation>
    </message>
    <message>
        <source>&amp;Objects</source>
        <translation>物體(&amp;O)</translation>
    </message>
    <message>
        <source>Add &amp;disk</source>
        <translation>新增圓盤(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Import outline…</source>
        <translation>匯入輪廓(&amp;I)…</translation>
    </message>
    <message>
        <source>Du&amp;plicate</source>
        <translation>複製副本(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>移除(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>復原(&amp;U)</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>重做</translation>
    </message>
    <message>
        <source>%1 of %2 degrees of freedom used</source>
        <translation>已用 %1 個自由度，共 %2 個</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>&amp;Sample shapes</source>
        <translation>範例形狀(&amp;S)</translation>
    </message>
    <message>
        <source>Bunny</source>
        <translation>兔子</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>圓</translation>
    </message>
    <message>
        <source>Gear</source>
        <translation>齒輪</translation>
    </message>
    <message>
        <source>Hand</source>
        <translation>手</translation>
    </message>
    <message>
        <source>Leaf</source>
        <translation>樹葉</translation>
    </message>
    <message>
        <source>%1 is not a kind of file that can be imported. Use a drawing (%2), a list of x, y points (%3) or a picture of a silhouette (%4).</source>
        <translation>%1 不是可匯入的檔案類型。請使用圖形（%2）、x, y 點的清單（%3）或剪影圖片（%4）。</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>輪廓</translation>
    </message>
    <message>
        <source>Mounting</source>
        <translation>安裝</translation>
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
        <translation>中斷</translation>
    </message>
    <message>
        <source>Not settled</source>
        <translation>未穩定</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>正在記錄</translation>
    </message>
    <message>
        <source>Settled</source>
        <translation>已穩定</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>已停止</translation>
    </message>
    <message>
        <source>Unreadable</source>
        <translation>無法讀取</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>軟體停止</translation>
    </message>
    <message>
        <source>Damaged</source>
        <translation>已損壞</translation>
    </message>
    <message>
        <source>Altered</source>
        <translation>已改動</translation>
    </message>
    <message>
        <source>%1, by an alarm of priority %2</source>
        <comment>the outcome of a run</comment>
        <translation>%1，由優先順序 %2 的警報引起</translation>
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
        <translation>檔案中的輪廓</translation>
    </message>
    <message>
        <source>Click an outline to choose it. The wheel zooms, a double click shows all.</source>
        <translation>按一下輪廓即可選擇。滾輪縮放，按兩下顯示全部。</translation>
    </message>
</context>
<context>
    <name>bask::OutlinePreview</name>
    <message>
        <source>Outline</source>
        <translation>輪廓</translation>
    </message>
    <message>
        <source>%1, %2 mm wide and %3 mm high</source>
        <translation>%1，寬 %2 mm，高 %3 mm</translation>
    </message>
    <message>
        <source>Imported outline, %1 points</source>
        <translation>匯入的輪廓，%1 個點</translation>
    </message>
    <message>
        <source>Fourier outline, %1</source>
        <translation>傅立葉輪廓，%1</translation>
    </message>
    <message>
        <source>Outline used</source>
        <translation>所用輪廓</translation>
    </message>
    <message>
        <source>Drop a drawing, a CSV or a picture of a silhouette here, or add a disk.</source>
        <translation>將圖形、CSV 或剪影圖片拖放到此處，或新增圓盤。</translation>
    </message>
    <message>
        <source>%1 mm × %2 mm</source>
        <translation>%1 mm × %2 mm</translation>
    </message>
    <message>
        <source>Centroid, principal axes: radii of gyration %1 mm and %2 mm</source>
        <translation>形心，主軸：回轉半徑 %1 mm 和 %2 mm</translation>
    </message>
    <message>
        <source>Imported outline at most %1 mm from the Fourier outline</source>
        <translation>匯入輪廓與傅立葉輪廓相距最大 %1 mm</translation>
    </message>
    <message>
        <source>Imported outline, %1 points, coloured by its distance</source>
        <translation>匯入的輪廓，%1 個點，按距離著色</translation>
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
        <translation>已待命或正在運轉。停止後即可更改物體。</translation>
    </message>
    <message>
        <source>The run is stopping. Targets can be changed once it has.</source>
        <translation>運轉正在停止。停止後即可更改目標。</translation>
    </message>
    <message>
        <source>Runs start at %1 from now on.</source>
        <translation>今後的運轉從 %1 開始。</translation>
    </message>
    <message>
        <source>A run is armed or on. The start can be changed once it has stopped.</source>
        <translation>已待命或正在運轉。停止後即可更改起始位姿。</translation>
    </message>
    <message>
        <source>The source is followed no more: that takes markers on it, a calibrated camera and its place.</source>
        <translation>不再追蹤熱源：這需要熱源上有標記、相機已校正且其位置已知。</translation>
    </message>
    <message>
        <source>Redone: %1</source>
        <translation>已重做：%1</translation>
    </message>
    <message>
        <source>Undone: %1</source>
        <translation>已復原：%1</translation>
    </message>
    <message>
        <source>Confirm a sensor</source>
        <translation>確認感測器</translation>
    </message>
    <message>
        <source>The sensor of &quot;%1&quot; reads %2. Have you looked, and is it on its object and right?</source>
        <translation>「%1」的感測器讀數為 %2。您查看過嗎？它在物體上且正確嗎？</translation>
    </message>
    <message>
        <source>Confirm</source>
        <translation>確認</translation>
    </message>
    <message>
        <source>A run is armed or on. The thermal camera can be changed once it has stopped.</source>
        <translation>已待命或正在運轉。停止後才能更改熱像儀。</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>開啟</translation>
    </message>
    <message>
        <source>Show in folder</source>
        <translation>在資料夾中顯示</translation>
    </message>
    <message>
        <source>%1 cannot be opened. Bask opens experiments and rigs (JSON), recorded sessions (BASK) and outlines (%2, pictures).</source>
        <comment>%2 names of file formats, with commas</comment>
        <translation>無法開啟 %1。Bask 可開啟實驗和實驗台（JSON）、記錄的工作階段（BASK）以及輪廓（%2、圖片）。</translation>
    </message>
</context>
<context>
    <name>bask::PairsView</name>
    <message>
        <source>Folder for the tables and pictures</source>
        <translation>存放表格和圖片的資料夾</translation>
    </message>
    <message>
        <source>Tables and pictures of the pairs written to %1</source>
        <translation>各物體對的表格和圖片已寫入 %1</translation>
    </message>
    <message>
        <source>Maps need two objects or more.</source>
        <translation>圖表需要兩個或更多物體。</translation>
    </message>
    <message>
        <source>No pose of the workspace keeps the clearance: there is nothing to map.</source>
        <translation>工作空間中沒有位姿能保持間距：沒有可繪製的內容。</translation>
    </message>
    <message>
        <source>Which temperatures two objects can have together, whatever the others do. Drag a point, or double-click, to set their targets.</source>
        <translation>兩個物體可同時達到的溫度，不論其他物體如何。拖曳一點或按兩下即可設定其目標。</translation>
    </message>
    <message>
        <source>few poses</source>
        <translation>位姿很少</translation>
    </message>
    <message>
        <source>rare</source>
        <translation>罕見</translation>
    </message>
    <message>
        <source>Some pose has both, found by search; none of the poses that were counted does.</source>
        <translation>經搜尋得知有某個位姿可同時達到兩者；所統計的位姿中則沒有。</translation>
    </message>
    <message>
        <source>many (log)</source>
        <translation>很多（對數）</translation>
    </message>
    <message>
        <source>Share of the workspace&apos;s poses at which the pair settles there, on a logarithmic scale. Where it is small, the pair asks for a pose that is hard to keep.</source>
        <translation>工作空間中使該物體對穩定於此處的位姿所佔的比例，對數刻度。比例小處，該物體對所要求的位姿難以保持。</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>匯出…</translation>
    </message>
    <message>
        <source>Write each map as a table (CSV) and as a picture (PNG).</source>
        <translation>將每張圖寫成表格（CSV）和圖片（PNG）。</translation>
    </message>
</context>
<context>
    <name>bask::ParameterForm</name>
    <message>
        <source>automatic</source>
        <translation>自動</translation>
    </message>
    <message>
        <source>%1: %2 instead of %3</source>
        <translation>%1：%2，而不是 %3</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>自動</translation>
    </message>
    <message>
        <source>%1: automatic</source>
        <translation>%1：自動</translation>
    </message>
</context>
<context>
    <name>bask::PickedPanel</name>
    <message>
        <source>For each object at this point: its view factor, the temperature that it settles at, and how fast that rises along its arrow.</source>
        <translation>對此點處的每個物體：其角係數、最終穩定的溫度，以及該溫度沿箭頭方向上升的快慢。</translation>
    </message>
    <message>
        <source>Start here</source>
        <translation>從此處開始</translation>
    </message>
    <message>
        <source>Runs start at this point.</source>
        <translation>運轉從此點開始。</translation>
    </message>
    <message>
        <source>Runs cannot start at this point: %1.</source>
        <translation>運轉不能從此點開始：%1。</translation>
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
        <translation>與視圖相同：%1 × %2</translation>
    </message>
    <message>
        <source>Twice the view: %1 × %2</source>
        <translation>視圖的兩倍：%1 × %2</translation>
    </message>
    <message>
        <source>Screen: %1 × %2</source>
        <translation>螢幕：%1 × %2</translation>
    </message>
    <message>
        <source>A4 across at 300 dpi: %1 × %2</source>
        <translation>A4 橫向，300 dpi：%1 × %2</translation>
    </message>
    <message>
        <source>A4 upright at 300 dpi: %1 × %2</source>
        <translation>A4 縱向，300 dpi：%1 × %2</translation>
    </message>
    <message>
        <source>Another</source>
        <translation>其他</translation>
    </message>
    <message>
        <source>Choose the place…</source>
        <translation>選擇位置…</translation>
    </message>
    <message>
        <source>&amp;Size</source>
        <translation>尺寸(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>寬度(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Height</source>
        <translation>高度(&amp;H)</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>儲存圖片</translation>
    </message>
    <message>
        <source>Save the animation</source>
        <translation>儲存動畫</translation>
    </message>
    <message>
        <source>Folder for the pictures</source>
        <translation>存放圖片的資料夾</translation>
    </message>
</context>
<context>
    <name>bask::PlotPlace</name>
    <message>
        <source>Take the cursor away</source>
        <translation>移走游標</translation>
    </message>
    <message>
        <source>On the right axis</source>
        <translation>右軸上</translation>
    </message>
    <message>
        <source>None</source>
        <translation>無</translation>
    </message>
    <message>
        <source>Put back into the page</source>
        <translation>放回頁面</translation>
    </message>
    <message>
        <source>Own window</source>
        <translation>單獨視窗</translation>
    </message>
    <message>
        <source>This plot is in a window of its own.</source>
        <translation>此曲線圖在一個單獨的視窗中。</translation>
    </message>
    <message>
        <source>Put back</source>
        <translation>放回</translation>
    </message>
    <message>
        <source>Put the plot back: %1</source>
        <translation>放回曲線圖：%1</translation>
    </message>
    <message>
        <source>Export what is shown</source>
        <translation>匯出所顯示的內容</translation>
    </message>
    <message>
        <source>Figure (PDF)…</source>
        <translation>圖 (PDF)…</translation>
    </message>
    <message>
        <source>Figure (SVG)…</source>
        <translation>圖 (SVG)…</translation>
    </message>
    <message>
        <source>Figure (PNG)…</source>
        <translation>圖 (PNG)…</translation>
    </message>
    <message>
        <source>Table (CSV)…</source>
        <translation>表格 (CSV)…</translation>
    </message>
    <message>
        <source>Measure from here</source>
        <translation>從此處測量</translation>
    </message>
</context>
<context>
    <name>bask::PlotWindowsControl</name>
    <message>
        <source>Rig %1: %2</source>
        <comment>SIMULATED or LIVE, and the state of the run</comment>
        <translation>%1實驗台：%2</translation>
    </message>
</context>
<context>
    <name>bask::ProblemDialog</name>
    <message>
        <source>Report a problem</source>
        <translation>回報問題</translation>
    </message>
    <message>
        <source>This is all that the report has. Write at the top what happened and what you expected, take out what nobody should see, save it, and give it to whoever looks after your Bask. Nothing is sent.</source>
        <translation>這就是報告的全部內容。請在最上方寫明發生了什麼、您期望的是什麼，刪去不應讓人看到的內容，儲存後交給負責維護 Bask 的人。不會傳送任何內容。</translation>
    </message>
    <message>
        <source>The report</source>
        <translation>報告</translation>
    </message>
    <message>
        <source>What happened:</source>
        <translation>發生了什麼：</translation>
    </message>
    <message>
        <source>What was expected:</source>
        <translation>期望的是什麼：</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>儲存…</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>關閉</translation>
    </message>
</context>
<context>
    <name>bask::ProgramQuestion</name>
    <message>
        <source>Program of a device</source>
        <translation>裝置的程式</translation>
    </message>
    <message>
        <source>May Bask start this program on this computer?</source>
        <translation>是否允許 Bask 在本電腦上啟動此程式？</translation>
    </message>
    <message>
        <source>It starts these files:</source>
        <translation>它啟動這些檔案：</translation>
    </message>
    <message>
        <source>It can do whatever you can do on this computer, and it moves or heats the device. Confirm only what you know. You are asked again when one of these files changes.</source>
        <translation>它能做您在本電腦上能做的一切，並使裝置移動或加熱。只確認您了解的程式。其中任一檔案改變時會再次詢問。</translation>
    </message>
    <message>
        <source>Allow it</source>
        <translation>允許</translation>
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
        <translation>可達溫度</translation>
    </message>
    <message>
        <source>The range is being worked out.</source>
        <translation>正在計算範圍。</translation>
    </message>
    <message>
        <source>Target %1. Here it can be held between %2 and %3; with nothing but the source in view, up to %4.</source>
        <translation>目標 %1。在此可保持於 %2 與 %3 之間；若視野內只有熱源，則可達 %4。</translation>
    </message>
</context>
<context>
    <name>bask::ReachMap</name>
    <message>
        <source>Checking…</source>
        <translation>正在檢查…</translation>
    </message>
    <message>
        <source>%1 inside</source>
        <translation>界內 %1</translation>
    </message>
    <message>
        <source>%1 outside</source>
        <translation>界外 %1</translation>
    </message>
    <message>
        <source>Temperatures that %1 and %2 can have together</source>
        <translation>%1 與 %2 可同時達到的溫度</translation>
    </message>
    <message>
        <source>Targets %1 and %2: %3</source>
        <translation>目標 %1 與 %2：%3</translation>
    </message>
    <message>
        <source>%1 %2 and %3 %4: some pose has both</source>
        <translation>%1 %2 且 %3 %4：有位姿可同時達到</translation>
    </message>
    <message>
        <source>%1 %2 and %3 %4: no pose has both</source>
        <translation>%1 %2 且 %3 %4：沒有位姿可同時達到</translation>
    </message>
</context>
<context>
    <name>bask::ReadingPanel</name>
    <message>
        <source>Temperature of %1</source>
        <translation>%1 的溫度</translation>
    </message>
    <message>
        <source>Temperatures by</source>
        <translation>溫度來自</translation>
    </message>
    <message>
        <source>The pose of the thermal camera is not known, so it reads nothing: set it up.</source>
        <translation>熱像儀的位姿未知，因此它不讀取任何物體：請設定。</translation>
    </message>
    <message>
        <source>Sensor on the object</source>
        <translation>物體上的感測器</translation>
    </message>
    <message>
        <source>Thermal camera</source>
        <translation>熱像儀</translation>
    </message>
    <message>
        <source>Sensor, checked by the thermal camera</source>
        <translation>感測器，由熱像儀核對</translation>
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
        <translation>全部已穩定 %1</translation>
    </message>
    <message>
        <source>%1 have passed</source>
        <translation>已過 %1</translation>
    </message>
    <message>
        <source>%1 is at %2 or above</source>
        <translation>%1 達到或高於 %2</translation>
    </message>
    <message>
        <source>%1 is at %2 or below</source>
        <translation>%1 達到或低於 %2</translation>
    </message>
    <message>
        <source>To come</source>
        <translation>未開始</translation>
    </message>
    <message>
        <source>Under way</source>
        <translation>進行中</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>已完成</translation>
    </message>
    <message>
        <source>Not reached</source>
        <translation>未達到</translation>
    </message>
    <message>
        <source>Failed</source>
        <translation>失敗</translation>
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
        <translation>配方已結束：並非每個步驟都已完成。</translation>
    </message>
    <message>
        <source>The recipe was stopped.</source>
        <translation>配方已停止。</translation>
    </message>
    <message>
        <source>The recipe has ended, since the rig or the experiment was taken in hand.</source>
        <translation>配方已結束，因為有人接管了實驗台或實驗。</translation>
    </message>
    <message>
        <source>The recipe was ended by an alarm.</source>
        <translation>配方因警報而結束。</translation>
    </message>
    <message>
        <source>The recipe was ended by a fault.</source>
        <translation>配方因故障而結束。</translation>
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
        <translation>配方正在進行，第 %1 步，共 %2 步。它會自行待命、移動和加熱。</translation>
    </message>
    <message>
        <source>Open a recipe</source>
        <translation>開啟配方</translation>
    </message>
    <message>
        <source>Recipes (*.json);;All files (*)</source>
        <translation>配方 (*.json);;所有檔案 (*)</translation>
    </message>
    <message>
        <source>Recipes (*.json)</source>
        <translation>配方 (*.json)</translation>
    </message>
    <message>
        <source>A recipe is on. Stop it before another one is opened.</source>
        <translation>配方正在進行。請先將其停止，再開啟另一個。</translation>
    </message>
    <message>
        <source>Show the recipe</source>
        <translation>檢視配方</translation>
    </message>
    <message>
        <source>Unsaved recipe</source>
        <translation>未儲存的配方</translation>
    </message>
    <message>
        <source>The recipe was changed and not saved.</source>
        <translation>配方已變更但未儲存。</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>儲存</translation>
    </message>
    <message>
        <source>Discard changes</source>
        <translation>放棄更改</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Save the recipe</source>
        <translation>儲存配方</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>已儲存 %1</translation>
    </message>
    <message>
        <source>Add a run of an experiment</source>
        <translation>加入一次實驗運轉</translation>
    </message>
    <message>
        <source>Experiments (*.json);;All files (*)</source>
        <translation>實驗 (*.json);;所有檔案 (*)</translation>
    </message>
    <message>
        <source>Step %1 is for another rig than the present one: a recipe runs on one rig, which has been looked at.</source>
        <translation>步驟 %1 用於另一座實驗台，而非目前的實驗台：配方只在一座已檢查過的實驗台上運轉。</translation>
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
            <numerusform>還有 %n 個</numerusform>
        </translation>
    </message>
    <message>
        <source>Start the recipe</source>
        <translation>啟動配方</translation>
    </message>
    <message>
        <source>It takes at most %1 and its retreats:</source>
        <translation>最多需要 %1，另加各次撤離：</translation>
    </message>
    <message>
        <source>This rig is real: the robot moves and the source heats, again and again and by itself. Is everybody and everything out of the way for so long? An alarm, a hold or a stop ends the recipe.</source>
        <translation>這是真實的實驗台：機器人將自行一次又一次地移動，熱源將一次又一次地加熱。在這麼長的時間內，所有人和物是否都已避開？警報、保持或停止都會結束配方。</translation>
    </message>
    <message>
        <source>An alarm, a hold or a stop ends the recipe.</source>
        <translation>警報、保持或停止都會結束配方。</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>開始</translation>
    </message>
    <message>
        <source>Something was changed meanwhile: start the recipe once more.</source>
        <translation>其間有所變更：請再次啟動配方。</translation>
    </message>
    <message>
        <source>The experiment has unsaved edits.</source>
        <translation>實驗有未儲存的編輯。</translation>
    </message>
    <message>
        <source>The source is heated by hand: a recipe cannot switch it off between its steps.</source>
        <translation>熱源由人工加熱：配方無法在各步驟之間將其關閉。</translation>
    </message>
    <message>
        <source>Its run is held, not ended: nothing but a person resumes or stops it now.</source>
        <translation>其運轉處於保持狀態，並未結束：現在只能由人來繼續或停止它。</translation>
    </message>
    <message>
        <source>Its steps allow the real rig more than now:</source>
        <translation>其步驟允許實機實驗台超出現在的範圍：</translation>
    </message>
    <message>
        <source>Do robot, source, objects and sensors bear it?</source>
        <translation>機器人、熱源、物體和感測器能承受嗎？</translation>
    </message>
</context>
<context>
    <name>bask::RecipePanel</name>
    <message>
        <source>Run %1</source>
        <translation>運轉 %1</translation>
    </message>
    <message>
        <source>%1; otherwise on with the next</source>
        <translation>%1；否則繼續下一步驟</translation>
    </message>
    <message>
        <source>Step %1 of %2</source>
        <translation>步驟 %1/%2</translation>
    </message>
    <message>
        <source>%1 of at most %2</source>
        <translation>%1，最多 %2</translation>
    </message>
    <message>
        <source>running, %1</source>
        <translation>運轉中，%1</translation>
    </message>
    <message>
        <source>waiting, %1</source>
        <translation>等待中，%1</translation>
    </message>
    <message>
        <source>heat off, retreat</source>
        <translation>關閉加熱，撤離</translation>
    </message>
    <message>
        <source>getting ready</source>
        <translation>準備中</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Experiments that are run one after another, with waits. Add a step or open a recipe.</source>
        <translation>依次運轉的實驗，中間可有等待。請加入步驟或開啟配方。</translation>
    </message>
    <message numerus="yes">
        <source>%n step(s), at most %1</source>
        <translation>
            <numerusform>%n 個步驟，最多 %1</numerusform>
        </translation>
    </message>
    <message>
        <source>not saved yet</source>
        <translation>尚未儲存</translation>
    </message>
    <message>
        <source>%1, changed</source>
        <translation>%1，已變更</translation>
    </message>
    <message>
        <source>File</source>
        <translation>檔案</translation>
    </message>
    <message>
        <source>New recipe</source>
        <translation>新增配方</translation>
    </message>
    <message>
        <source>Open a recipe…</source>
        <translation>開啟配方…</translation>
    </message>
    <message>
        <source>Examples</source>
        <translation>範例</translation>
    </message>
    <message>
        <source>Save the recipe as…</source>
        <translation>配方另存新檔…</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>儲存</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>新增</translation>
    </message>
    <message>
        <source>A run of the open experiment</source>
        <translation>運轉已開啟的實驗</translation>
    </message>
    <message>
        <source>A run of an experiment from a file…</source>
        <translation>運轉檔案中的實驗…</translation>
    </message>
    <message>
        <source>A wait</source>
        <translation>等待</translation>
    </message>
    <message>
        <source>A wait until an object has cooled</source>
        <translation>等待某個物體冷卻</translation>
    </message>
    <message>
        <source>Edit…</source>
        <translation>編輯…</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Start the recipe</source>
        <translation>啟動配方</translation>
    </message>
    <message>
        <source>Stop after this step</source>
        <translation>此步驟後停止</translation>
    </message>
    <message>
        <source>Stop the recipe</source>
        <translation>停止配方</translation>
    </message>
    <message>
        <source>Look at the run</source>
        <translation>檢視運轉</translation>
    </message>
    <message>
        <source>Recipe file</source>
        <translation>配方檔案</translation>
    </message>
    <message>
        <source>A new recipe, another one, or this one under another name</source>
        <translation>新增配方、開啟另一個，或將此配方另存</translation>
    </message>
    <message>
        <source>Save the recipe</source>
        <translation>儲存配方</translation>
    </message>
    <message>
        <source>Add a step</source>
        <translation>加入步驟</translation>
    </message>
    <message>
        <source>Add a step after the chosen one</source>
        <translation>在所選步驟之後加入步驟</translation>
    </message>
    <message>
        <source>Edit the step</source>
        <translation>編輯步驟</translation>
    </message>
    <message>
        <source>Its condition, its longest time, and what comes if that passes (Enter)</source>
        <translation>其條件、最長時間，以及逾時後如何處理（Enter）</translation>
    </message>
    <message>
        <source>Remove the step</source>
        <translation>移除步驟</translation>
    </message>
    <message>
        <source>Move the step up</source>
        <translation>上移步驟</translation>
    </message>
    <message>
        <source>Move the step down</source>
        <translation>下移步驟</translation>
    </message>
    <message>
        <source>Says what it will do, and asks</source>
        <translation>先說明將要做什麼，再徵求確認</translation>
    </message>
    <message>
        <source>The step under way is the last one</source>
        <translation>進行中的步驟為最後一步</translation>
    </message>
    <message>
        <source>Heat off, retreat, and nothing more is begun</source>
        <translation>關閉加熱，撤離，不再開始任何步驟</translation>
    </message>
    <message>
        <source>The recording of the chosen step, on the Review page</source>
        <translation>在「回顧」頁檢視所選步驟的記錄</translation>
    </message>
    <message>
        <source>Steps of the recipe</source>
        <translation>配方的步驟</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>編號</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>步驟</translation>
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
        <translation>已用時</translation>
    </message>
    <message>
        <source>State</source>
        <translation>狀態</translation>
    </message>
</context>
<context>
    <name>bask::RecipeStepDialog</name>
    <message>
        <source>Run %1</source>
        <translation>運轉 %1</translation>
    </message>
    <message>
        <source>Wait</source>
        <translation>等待</translation>
    </message>
    <message>
        <source>All objects have settled</source>
        <translation>所有物體均已穩定</translation>
    </message>
    <message>
        <source>A time has passed</source>
        <translation>經過一段時間</translation>
    </message>
    <message>
        <source>An object is so hot or hotter</source>
        <translation>某個物體達到或高於此溫度</translation>
    </message>
    <message>
        <source>An object is so cold or colder</source>
        <translation>某個物體達到或低於此溫度</translation>
    </message>
    <message>
        <source>End the recipe</source>
        <translation>結束配方</translation>
    </message>
    <message>
        <source>Go on with the next step</source>
        <translation>繼續下一步驟</translation>
    </message>
    <message>
        <source>Until</source>
        <translation>直到</translation>
    </message>
    <message>
        <source>For</source>
        <translation>持續</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>物體</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>溫度</translation>
    </message>
    <message>
        <source>At most</source>
        <translation>最多</translation>
    </message>
    <message>
        <source>Otherwise</source>
        <translation>否則</translation>
    </message>
    <message>
        <source>Where the condition does not come in time, or the run cannot be begun. An alarm, a fault or a person&apos;s stop always ends the recipe.</source>
        <translation>當條件未按時達到，或運轉無法開始時。警報、故障或由人停止總會結束配方。</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>確定</translation>
    </message>
</context>
<context>
    <name>bask::RecoveryOffer</name>
    <message>
        <source>Bask ended before changes of “%1” were saved. They are kept as they were on %2.</source>
        <translation>Bask 在「%1」的更改儲存之前就已結束。這些更改已按 %2 時的狀態保留。</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>捨棄</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>復原變更</translation>
    </message>
</context>
<context>
    <name>bask::ReplayView</name>
    <message>
        <source>3-D scene of the run: source, objects and their paths</source>
        <translation>運轉的三維場景：熱源、物體及其路徑</translation>
    </message>
    <message>
        <source>Further traces and the scene</source>
        <translation>其他曲線與場景</translation>
    </message>
    <message>
        <source>Laid over it:</source>
        <translation>疊加：</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>場景</translation>
    </message>
    <message>
        <source>Take %1 away</source>
        <translation>移除 %1</translation>
    </message>
    <message>
        <source>Thermal picture</source>
        <translation>熱像圖</translation>
    </message>
    <message>
        <source>Comparison</source>
        <translation>比較</translation>
    </message>
    <message>
        <source>recorded run %1</source>
        <translation>已記錄的運轉 %1</translation>
    </message>
    <message>
        <source>no recorded run</source>
        <translation>沒有已記錄的運轉</translation>
    </message>
    <message>
        <source>Export figure</source>
        <translation>匯出圖</translation>
    </message>
    <message>
        <source>The temperatures of all runs as they are shown; other plots by their own menus</source>
        <translation>所有運轉的溫度，按所顯示的樣子；其他曲線圖用各自的選單</translation>
    </message>
</context>
<context>
    <name>bask::ResidualPlot</name>
    <message>
        <source>Residual against the number of harmonics</source>
        <translation>殘差與諧波個數的關係</translation>
    </message>
    <message>
        <source>Distance between the imported outline and the Fourier outline. Click to choose a number of harmonics.</source>
        <translation>匯入輪廓與傅立葉輪廓之間的距離。按一下可選擇諧波個數。</translation>
    </message>
    <message>
        <source>Residual, mm: rms (line), largest (dashes)</source>
        <translation>殘差，mm：均方根（實線），最大（虛線）</translation>
    </message>
    <message>
        <source>harmonics</source>
        <translation>諧波數</translation>
    </message>
</context>
<context>
    <name>bask::ReviewDesk</name>
    <message>
        <source>%1 was closed properly: its outcome is &quot;interrupted&quot; now.</source>
        <translation>%1 已正確關閉：其結果現為「中斷」。</translation>
    </message>
    <message numerus="yes">
        <source>It is shown already, or there are %n runs over the open one: take one away first.</source>
        <translation>
            <numerusform>它已在顯示，或已有 %n 次運轉疊加在目前的運轉上：請先移除一次。</numerusform>
        </translation>
    </message>
    <message>
        <source>A run is armed or on. Objects can be changed once it has stopped.</source>
        <translation>已待命或正在運轉。停止後即可更改物體。</translation>
    </message>
    <message>
        <source>No object of the open experiment has the name and material of one of this run under the same source and environment.</source>
        <translation>在相同的熱源和環境下，開啟的實驗中沒有與本次運轉名稱和材料相同的物體。</translation>
    </message>
    <message>
        <source>Start values taken from this run: %1</source>
        <translation>已採用本次運轉的起始值：%1</translation>
    </message>
    <message>
        <source>List of runs is up to date</source>
        <translation>運轉清單已是最新</translation>
    </message>
</context>
<context>
    <name>bask::ReviewPage</name>
    <message>
        <source>Interrupted: the recording ended without a Stop. What had been written is here.</source>
        <translation>已中斷：記錄未經「停止」而結束。此處為已寫入的內容。</translation>
    </message>
    <message>
        <source>All objects settled</source>
        <translation>所有物體均已穩定</translation>
    </message>
    <message>
        <source>Not all objects settled</source>
        <translation>並非所有物體都已穩定</translation>
    </message>
    <message>
        <source>Ended by a fault</source>
        <translation>因故障結束</translation>
    </message>
    <message>
        <source>No session open</source>
        <translation>未開啟工作階段</translation>
    </message>
    <message>
        <source>&amp;Open session…</source>
        <translation>開啟工作階段(&amp;O)…</translation>
    </message>
    <message>
        <source>Final values</source>
        <translation>最終值</translation>
    </message>
    <message>
        <source>Events and notes</source>
        <translation>事件與備註</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>結果</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>持續時間</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>控制器</translation>
    </message>
    <message>
        <source>Recorded</source>
        <translation>記錄時間</translation>
    </message>
    <message>
        <source>Software</source>
        <translation>軟體</translation>
    </message>
    <message>
        <source>SIMULATED</source>
        <translation>模擬</translation>
    </message>
    <message>
        <source>LIVE</source>
        <translation>實機</translation>
    </message>
    <message>
        <source>Heat rates λ₁ in K/s</source>
        <translation>熱速率 λ₁，K/s</translation>
    </message>
    <message>
        <source>Use as start values</source>
        <translation>用作起始值</translation>
    </message>
    <message>
        <source>Controllers of the open experiment start with the identified rates, in the objects of the same name and material under the same source.</source>
        <translation>對於相同熱源下名稱和材料相同的物體，開啟的實驗中的控制器從辨識出的熱速率開始。</translation>
    </message>
    <message>
        <source>Fitting the heat balance to the record…</source>
        <translation>正在將熱平衡模型擬合到記錄…</translation>
    </message>
    <message>
        <source>Choose a recorded run in the list and press Enter, or open a file: its traces, events and metrics are shown here, and it can be played again.</source>
        <translation>在清單中選擇一次已記錄的運轉並按 Enter，或開啟檔案：這裡顯示其曲線、事件和指標，並可重播。</translation>
    </message>
    <message>
        <source>Interrupted: the recording ended without a Stop, and was closed later. What had been written is here.</source>
        <translation>中斷：記錄未經停止便結束，後來才關閉。已寫入的內容都在這裡。</translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation>指標</translation>
    </message>
    <message>
        <source>What is known of the run</source>
        <translation>關於本次運轉的已知資訊</translation>
    </message>
    <message>
        <source>About the recording</source>
        <translation>關於此記錄</translation>
    </message>
    <message>
        <source>Heat rates</source>
        <translation>熱變化率</translation>
    </message>
    <message>
        <source>E&amp;xport</source>
        <translation>匯出(&amp;X)</translation>
    </message>
    <message>
        <source>Write this session as a report, as figures or for other programs</source>
        <translation>將此工作階段寫成報告、圖，或供其他程式使用的檔案</translation>
    </message>
    <message>
        <source>Report (&amp;PDF)…</source>
        <translation>報告 (PDF)(&amp;P)…</translation>
    </message>
    <message>
        <source>Report (&amp;HTML)…</source>
        <translation>報告 (HTML)(&amp;H)…</translation>
    </message>
    <message>
        <source>&amp;Figures (PNG, SVG, PDF)…</source>
        <translation>圖(PNG、SVG、PDF)(&amp;F)…</translation>
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
        <translation>VTK（用於 ParaView）(&amp;V)…</translation>
    </message>
    <message>
        <source>Metrics, final values and heat rates are being computed from all samples: %1 %</source>
        <translation>正在根據全部取樣計算指標、最終值和熱速率：%1 %</translation>
    </message>
    <message>
        <source>No metrics, final values and heat rates: the recording cannot be read to its end.</source>
        <translation>無指標、最終值和熱速率：記錄無法讀取到結尾。</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>已停止</translation>
    </message>
    <message>
        <source>Ended by STOP</source>
        <translation>因軟體停止結束</translation>
    </message>
    <message>
        <source>Opened while it was being recorded: open it again to see the rest.</source>
        <translation>開啟時仍在記錄：再次開啟可檢視其餘部分。</translation>
    </message>
    <message>
        <source>The record tells the losses of %1, but not what of them is radiated and what the air takes. State the air on the Objects page, or record wider temperatures.</source>
        <translation>記錄給出了%1的損失，但無法區分其中的輻射與空氣帶走的部分。請在「物體」頁說明空氣，或記錄更寬的溫度範圍。</translation>
    </message>
    <message>
        <source>Losses, of radiation and air</source>
        <translation>輻射與空氣的損失</translation>
    </message>
    <message>
        <source>There is nothing to play: no run is open. Choose one in the list.</source>
        <translation>沒有可播放的：沒有開啟任何運轉。請在清單中選擇一個。</translation>
    </message>
    <message>
        <source>Open as new experiment</source>
        <translation>作為新實驗開啟</translation>
    </message>
    <message>
        <source>Opens what was run here, objects, source, targets and limits as the recording has them, as a new experiment without a file.</source>
        <translation>將此處所運轉的內容（物體、熱源、目標和限值，均按記錄中的）作為沒有檔案的新實驗開啟。</translation>
    </message>
    <message>
        <source>Tables with &amp;all digits (CSV)…</source>
        <translation>全部位數的表格 (CSV)(&amp;A)…</translation>
    </message>
    <message>
        <source>Not verified: %1</source>
        <translation>未驗證：%1</translation>
    </message>
    <message>
        <source>No object shades another</source>
        <translation>物體之間沒有遮擋</translation>
    </message>
    <message>
        <source>At most %1 % of an object&apos;s view factor is taken by the others</source>
        <translation>某個物體的角係數最多有 %1 % 被其他物體擋住</translation>
    </message>
    <message>
        <source>Being verified…</source>
        <translation>正在驗證…</translation>
    </message>
    <message>
        <source>Head of the hash chain: %1</source>
        <translation>雜湊鏈的頭：%1</translation>
    </message>
    <message>
        <source>Verification</source>
        <translation>驗證</translation>
    </message>
    <message>
        <source>Heat rates at Start</source>
        <translation>開始時的熱速率</translation>
    </message>
    <message>
        <source>Shade</source>
        <translation>遮擋</translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation>模擬</translation>
    </message>
    <message>
        <source>%1, recorded until %2</source>
        <comment>two times since Start</comment>
        <translation>%1，記錄至 %2</translation>
    </message>
</context>
<context>
    <name>bask::RigDevices</name>
    <message>
        <source>Simulated rig</source>
        <translation>模擬實驗台</translation>
    </message>
    <message>
        <source>No device moves or heats. The real rig&apos;s set-up is kept for later.</source>
        <translation>沒有裝置運動或加熱。實際實驗台的設定會保留以備後用。</translation>
    </message>
    <message>
        <source>Real rig</source>
        <translation>實際實驗台</translation>
    </message>
    <message>
        <source>The devices below</source>
        <translation>以下裝置</translation>
    </message>
    <message>
        <source>Name of the rig</source>
        <translation>實驗台名稱</translation>
    </message>
    <message>
        <source>Open rig…</source>
        <translation>開啟實驗台…</translation>
    </message>
    <message>
        <source>Take the devices from a rig file</source>
        <translation>從實驗台檔案讀取裝置</translation>
    </message>
    <message>
        <source>Save rig…</source>
        <translation>儲存實驗台…</translation>
    </message>
    <message>
        <source>Write these devices to a rig file, for other experiments</source>
        <translation>將這些裝置寫入實驗台檔案，供其他實驗使用</translation>
    </message>
    <message>
        <source>Console…</source>
        <translation>主控台…</translation>
    </message>
    <message>
        <source>What goes over the links to the devices</source>
        <translation>裝置連線上往來的內容</translation>
    </message>
</context>
<context>
    <name>bask::RigPage</name>
    <message>
        <source>The rig was set up for %1 objects, and there are %2: check the thermometer&apos;s channels.</source>
        <translation>實驗台是按 %1 個物體設定的，而現有 %2 個：請檢查溫度計的通道。</translation>
    </message>
    <message>
        <source>A run is armed or on: it has the robot and the heat.</source>
        <translation>已待命或正在運轉：機器人和加熱由其佔用。</translation>
    </message>
    <message>
        <source>A stop or a fault is latched. Press Reset first.</source>
        <translation>有停止或故障被閂鎖。請先按「復歸」。</translation>
    </message>
    <message>
        <source>By hand</source>
        <translation>手動</translation>
    </message>
    <message>
        <source>Source and limits</source>
        <translation>熱源與限值</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>機器人</translation>
    </message>
    <message>
        <source>Heat</source>
        <translation>加熱</translation>
    </message>
    <message>
        <source>Rig</source>
        <translation>實驗台</translation>
    </message>
    <message>
        <source>Raise a limit of the real rig</source>
        <translation>提高實際實驗台的限值</translation>
    </message>
    <message>
        <source>This allows the rig more than before. Do robot, source, objects and sensors bear it?</source>
        <translation>這將允許實驗台超出以前的範圍。機器人、熱源、物體和感測器能承受嗎？</translation>
    </message>
    <message>
        <source>Raise the limit</source>
        <translation>提高限值</translation>
    </message>
    <message>
        <source>Limits of the real rig</source>
        <translation>實機實驗台的限值</translation>
    </message>
    <message>
        <source>This rig is allowed more than now, or than is usual:</source>
        <translation>此實驗台被允許的範圍超出現在或通常：</translation>
    </message>
    <message>
        <source>Do robot, source, objects and sensors bear it?</source>
        <translation>機器人、熱源、物體和感測器能承受嗎？</translation>
    </message>
    <message>
        <source>Use these limits</source>
        <translation>使用這些限值</translation>
    </message>
    <message>
        <source>A stop or a fault is latched. Home the robot or confirm its place, then press Reset.</source>
        <translation>停止或故障已閂鎖。請使機器人回原點或確認其位置，然後按「復歸」。</translation>
    </message>
    <message>
        <source>A stop or a fault is latched. Reset is possible when its cause is over.</source>
        <translation>停止或故障已閂鎖。其原因解除後方可復歸。</translation>
    </message>
</context>
<context>
    <name>bask::RigPanel</name>
    <message>
        <source>Follow the source &amp;during runs</source>
        <translation>運轉期間追蹤熱源(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>測量(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Several poses</source>
        <translation>多個位姿(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Use this pose</source>
        <translation>使用此位姿(&amp;U)</translation>
    </message>
    <message>
        <source>A run is armed or on, or a stop is not reset. Measure after that.</source>
        <translation>已待命、正在運轉，或停止尚未復歸。請在此之後測量。</translation>
    </message>
    <message>
        <source>As typed</source>
        <translation>按輸入值</translation>
    </message>
    <message>
        <source>By the end-effector&apos;s markers, in the robot&apos;s base. Several poses of the robot are surer than one.</source>
        <translation>由末端執行器的標記在機器人基座座標系中確定。機器人的多個位姿比單個更可靠。</translation>
    </message>
    <message>
        <source>By the markers on the source and on the end-effector, seen in the same pictures.</source>
        <translation>由同一影像中所見的熱源上和末端執行器上的標記確定。</translation>
    </message>
    <message>
        <source>Calibrate the camera first.</source>
        <translation>請先校正相機。</translation>
    </message>
    <message>
        <source>Chec&amp;k</source>
        <translation>驗證(&amp;K)</translation>
    </message>
    <message>
        <source>Checked at another pose: %1 and %2 off; up to %3 and %4 was to be expected.</source>
        <translation>在另一位姿驗證：偏離 %1 和 %2；預期最多 %3 和 %4。</translation>
    </message>
    <message>
        <source>Fr&amp;om here</source>
        <translation>從此處(&amp;O)</translation>
    </message>
    <message>
        <source>In use</source>
        <translation>正在使用</translation>
    </message>
    <message>
        <source>List the markers on the end-effector first.</source>
        <translation>請先列出末端執行器上的標記。</translation>
    </message>
    <message>
        <source>Markers on the rig</source>
        <translation>實驗台上的標記</translation>
    </message>
    <message>
        <source>Moves the robot to a pose that was not measured, compares where the markers are with where they should be, and moves back.</source>
        <translation>使機器人運動到一個未測量過的位姿，比較標記的實際位置與應在位置，然後返回。</translation>
    </message>
    <message>
        <source>No picture from the camera.</source>
        <translation>相機沒有影像。</translation>
    </message>
    <message>
        <source>Not measured</source>
        <translation>未測量</translation>
    </message>
    <message>
        <source>Rig</source>
        <translation>實驗台</translation>
    </message>
    <message>
        <source>That is %1 and %2 from where the experiment has it.</source>
        <translation>與實驗中的位置相差 %1 和 %2。</translation>
    </message>
    <message>
        <source>The camera stands at %1, measured %2.</source>
        <translation>相機位於 %1，測量於：%2。</translation>
    </message>
    <message>
        <source>The camera stands at %1.</source>
        <translation>相機位於 %1。</translation>
    </message>
    <message>
        <source>The camera tells the controllers where the source is. Takes markers on the source, a calibrated camera and its place.</source>
        <translation>由相機告知控制器熱源的位置。需要熱源上有標記、相機已校正且其位置已知。</translation>
    </message>
    <message>
        <source>The end-effector in the source: %1.</source>
        <translation>末端執行器在熱源座標系中：%1。</translation>
    </message>
    <message>
        <source>The robot did not move: nothing was checked.</source>
        <translation>機器人沒有運動：未作任何驗證。</translation>
    </message>
    <message>
        <source>The robot moves to some poses within its workspace, never nearer to the source, and back. Stand clear.</source>
        <translation>機器人將運動到其工作空間內的若干位姿，絕不更靠近熱源，然後返回。請保持距離。</translation>
    </message>
    <message>
        <source>The robot says where it is to %1 and %2 (one standard deviation).</source>
        <translation>機器人自報位置的精度為 %1 和 %2（一倍標準差）。</translation>
    </message>
    <message>
        <source>The robot stays where it is.</source>
        <translation>機器人停在原處不動。</translation>
    </message>
    <message>
        <source>The source in the robot&apos;s base: %1.</source>
        <translation>熱源在機器人基座座標系中：%1。</translation>
    </message>
    <message>
        <source>The source lies at %1, measured %2.</source>
        <translation>熱源位於 %1，測量於：%2。</translation>
    </message>
    <message>
        <source>The source lies at %1.</source>
        <translation>熱源位於 %1。</translation>
    </message>
    <message>
        <source>Use this p&amp;lace</source>
        <translation>使用此位置(&amp;L)</translation>
    </message>
    <message>
        <source>What it sees at the source is known to ±%1 and ±%2 (two standard deviations), by %3 pose(s) of the robot; residual %4 px.</source>
        <translation>相機在熱源處所見內容的精度為 ±%1 和 ±%2（兩倍標準差），由機器人的 %3 個位姿得出；殘差 %4 px。</translation>
    </message>
    <message>
        <source>Where the camera stands</source>
        <translation>相機的位置</translation>
    </message>
    <message>
        <source>Where the source is</source>
        <translation>熱源的位置</translation>
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
        <translation>操作員 %1</translation>
    </message>
    <message>
        <source>sample %1</source>
        <translation>樣品 %1</translation>
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
        <translation>運轉已被停止；其後的過程沒有記錄完整。</translation>
    </message>
    <message>
        <source>Faster than real time: %1 (min:s) of the simulated rig in %2 by the clock</source>
        <translation>快於實際時間：模擬實驗台的 %1（分:秒）按時鐘只用了 %2</translation>
    </message>
</context>
<context>
    <name>bask::RunPage</name>
    <message>
        <source>Sensor lost</source>
        <translation>感測器失聯</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>保持</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>繼續</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>軟體停止</translation>
    </message>
    <message>
        <source>Settled</source>
        <translation>已穩定</translation>
    </message>
    <message>
        <source>New targets</source>
        <translation>新目標</translation>
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
        <translation>折衷</translation>
    </message>
    <message>
        <source>Source lost</source>
        <translation>失去熱源</translation>
    </message>
    <message>
        <source>Source back</source>
        <translation>熱源恢復</translation>
    </message>
    <message>
        <source>Sensor back</source>
        <translation>感測器恢復</translation>
    </message>
    <message>
        <source>Behind by %1 — jump to live</source>
        <translation>落後 %1 — 跳到即時</translation>
    </message>
    <message>
        <source>Jump to live</source>
        <translation>跳到即時</translation>
    </message>
    <message>
        <source>Follow live</source>
        <translation>跟隨即時</translation>
    </message>
    <message>
        <source>Keep the newest samples in view. Zooming or dragging a plot turns it off; no sample is lost.</source>
        <translation>使最新取樣保持在視圖中。縮放或拖曳曲線圖會將其關閉；取樣不會遺失。</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>顯示</translation>
    </message>
    <message>
        <source>whole run</source>
        <translation>整個運轉</translation>
    </message>
    <message>
        <source>last minute</source>
        <translation>最近 1 分鐘</translation>
    </message>
    <message>
        <source>last 5 minutes</source>
        <translation>最近 5 分鐘</translation>
    </message>
    <message>
        <source>last 30 minutes</source>
        <translation>最近 30 分鐘</translation>
    </message>
    <message>
        <source>Stretch of time shown while following</source>
        <translation>跟隨時所顯示的時間段</translation>
    </message>
    <message>
        <source>Show the newest samples again and follow them.</source>
        <translation>重新顯示最新取樣並跟隨它們。</translation>
    </message>
    <message>
        <source>Further traces</source>
        <translation>更多曲線</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>場景</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>俯視</translation>
    </message>
    <message>
        <source>Look along −z of the source, from above.</source>
        <translation>沿熱源的 −z 方向，從上方看。</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>側視</translation>
    </message>
    <message>
        <source>Look along x of the source, from the side.</source>
        <translation>沿熱源的 x 方向，從側面看。</translation>
    </message>
    <message>
        <source>Isometric</source>
        <translation>等角</translation>
    </message>
    <message>
        <source>Look from above at an angle.</source>
        <translation>從斜上方看。</translation>
    </message>
    <message>
        <source>View: %1</source>
        <translation>視角：%1</translation>
    </message>
    <message>
        <source>3-D scene: source, objects and their paths</source>
        <translation>3D 場景：熱源、物體及其路徑</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>備註</translation>
    </message>
    <message>
        <source>Press N, type, Enter: noted at this moment of the run</source>
        <translation>按 N 鍵，輸入，再按 Enter：記在運轉的此刻</translation>
    </message>
    <message>
        <source>Note at this moment of the run</source>
        <translation>運轉此刻的備註</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>新增</translation>
    </message>
    <message>
        <source>Record the note with the present time.</source>
        <translation>以目前時間記錄此備註。</translation>
    </message>
    <message>
        <source>Add the note</source>
        <translation>新增備註</translation>
    </message>
    <message>
        <source>Simulation speed</source>
        <translation>模擬速度</translation>
    </message>
    <message>
        <source>Simulated seconds a second; only on the simulated rig.</source>
        <translation>每秒模擬的秒數；僅用於模擬實驗台。</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>rotation</source>
        <translation>轉動</translation>
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
        <translation>間距</translation>
    </message>
    <message>
        <source>workspace %1</source>
        <translation>工作空間 %1</translation>
    </message>
    <message>
        <source>No limit holds the robot back.</source>
        <translation>機器人未受任何限值約束。</translation>
    </message>
    <message>
        <source>A limit holds the robot back.</source>
        <translation>機器人受某個限值約束。</translation>
    </message>
    <message>
        <source>Held back by: %1</source>
        <translation>受限於：%1</translation>
    </message>
    <message>
        <source>Place UNKNOWN, what is drawn is %1.</source>
        <translation>位置未知，所畫的是：%1。</translation>
    </message>
    <message>
        <source>The robot is not sure of its place.</source>
        <translation>機器人的位置不確定。</translation>
    </message>
    <message>
        <source>Thermal picture</source>
        <translation>熱像圖</translation>
    </message>
    <message>
        <source>present run</source>
        <translation>目前的運轉</translation>
    </message>
    <message>
        <source>run of %1</source>
        <translation>%1 的運轉</translation>
    </message>
    <message>
        <source>Predicted</source>
        <translation>預測</translation>
    </message>
    <message>
        <source>%1 %2 %</source>
        <comment>the name of an object, and how much of the source the others hide from it</comment>
        <translation>%1 %2 %</translation>
    </message>
    <message>
        <source>Shaded: %1</source>
        <translation>遮擋：%1</translation>
    </message>
    <message>
        <source>How much of the source the other objects hide: %1. The view factors count it.</source>
        <translation>其他物體遮住熱源的比例：%1。角係數已計入。</translation>
    </message>
    <message>
        <source>The run as the simulated rig predicts it from where it starts: dotted behind the traces, dashed in the scene. Its band: %1 runs with other sensor noise; not material, air or source, which are as the experiment has them. It is kept with the recording.</source>
        <translation>模擬實驗台從運轉起始處預測的運轉：在曲線後面為點線，在場景中為虛線。其色帶：%1 次感測器雜訊不同的運轉；不涵蓋不同的材料、空氣或熱源，它們取實驗中的值。它與記錄一同保存。</translation>
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
        <translation>，運轉期間按曲線變化</translation>
    </message>
    <message>
        <source>, tracked during the run</source>
        <translation>，運轉期間被追蹤</translation>
    </message>
    <message>
        <source>Acknowledge</source>
        <translation>確認</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>警報</translation>
    </message>
    <message>
        <source>Alarms, events, notes and commands</source>
        <translation>警報、事件、備註和指令</translation>
    </message>
    <message>
        <source>All objects settled.</source>
        <translation>所有物體均已穩定。</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>面積</translation>
    </message>
    <message>
        <source>Areal heat capacity</source>
        <translation>面熱容</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>待命</translation>
    </message>
    <message>
        <source>By itself</source>
        <translation>單獨</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>校正</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>相機</translation>
    </message>
    <message>
        <source>Clearance to the source&apos;s plane</source>
        <translation>與熱源平面的間距</translation>
    </message>
    <message>
        <source>Commanded speed</source>
        <translation>指令速度</translation>
    </message>
    <message>
        <source>Commanded speed of the end-effector as a share of its limits: %1 mm/s and %2 °/s.</source>
        <translation>末端執行器的指令速度佔其限值的比例：%1 mm/s 和 %2 °/s。</translation>
    </message>
    <message>
        <source>Control from Start until Stop</source>
        <translation>從「開始」到「停止」的控制</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>控制器</translation>
    </message>
    <message>
        <source>Definitions</source>
        <translation>定義</translation>
    </message>
    <message>
        <source>Disarm</source>
        <translation>解除待命</translation>
    </message>
    <message>
        <source>Emittance of the source</source>
        <translation>熱源的發射率</translation>
    </message>
    <message>
        <source>Ended by a fault.</source>
        <translation>因故障結束。</translation>
    </message>
    <message>
        <source>Experiment without a title</source>
        <translation>無標題的實驗</translation>
    </message>
    <message>
        <source>Feasibility of the targets</source>
        <translation>目標的可行性</translation>
    </message>
    <message>
        <source>Fourier contour, radius %1 mm</source>
        <translation>傅立葉輪廓，半徑 %1 mm</translation>
    </message>
    <message>
        <source>Free axes</source>
        <translation>自由軸</translation>
    </message>
    <message>
        <source>Gains at the start</source>
        <translation>開始時的增益</translation>
    </message>
    <message>
        <source>Heat source</source>
        <translation>熱源</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>保持</translation>
    </message>
    <message>
        <source>Interrupted: the recording ended without a Stop. What had been written is reported.</source>
        <translation>已中斷：記錄未經「停止」而結束。本報告為已寫入的內容。</translation>
    </message>
    <message>
        <source>It was not computed.</source>
        <translation>未計算。</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>類型</translation>
    </message>
    <message>
        <source>LIVE</source>
        <translation>實機</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>標記</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation>指標</translation>
    </message>
    <message>
        <source>Model of the source</source>
        <translation>熱源模型</translation>
    </message>
    <message>
        <source>Nearest that can be held</source>
        <translation>可保持的最近值</translation>
    </message>
    <message>
        <source>No pose keeps the workspace and the clearance.</source>
        <translation>沒有位姿能同時滿足工作空間和間距。</translation>
    </message>
    <message>
        <source>No samples were recorded: there are no traces, trajectories and metrics.</source>
        <translation>沒有記錄到取樣：因此沒有曲線、軌跡和指標。</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>編號</translation>
    </message>
    <message>
        <source>None was recorded.</source>
        <translation>沒有記錄。</translation>
    </message>
    <message>
        <source>Not all objects settled.</source>
        <translation>並非所有物體都已穩定。</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>物體</translation>
    </message>
    <message>
        <source>Objects</source>
        <translation>物體</translation>
    </message>
    <message>
        <source>Origin</source>
        <translation>來源</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>結果</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>輪廓</translation>
    </message>
    <message>
        <source>Place on the end-effector</source>
        <translation>在末端執行器上的位置</translation>
    </message>
    <message>
        <source>Pose of the camera in the robot&apos;s base</source>
        <translation>相機在機器人基座座標系中的位姿</translation>
    </message>
    <message>
        <source>Pose of the source</source>
        <translation>熱源位姿</translation>
    </message>
    <message>
        <source>Pose of the source in the robot&apos;s base</source>
        <translation>熱源在機器人基座座標系中的位姿</translation>
    </message>
    <message>
        <source>Range in the workspace</source>
        <translation>工作空間中的範圍</translation>
    </message>
    <message>
        <source>Recorded</source>
        <translation>記錄時間</translation>
    </message>
    <message>
        <source>Recorded by</source>
        <translation>記錄者</translation>
    </message>
    <message>
        <source>Recorded on a real rig.</source>
        <translation>在實際實驗台上記錄。</translation>
    </message>
    <message>
        <source>Report made at</source>
        <translation>報告生成時間</translation>
    </message>
    <message>
        <source>Report made by</source>
        <translation>報告生成者</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>復歸</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>繼續</translation>
    </message>
    <message>
        <source>Rig</source>
        <translation>實驗台</translation>
    </message>
    <message>
        <source>SIMULATED</source>
        <translation>模擬</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>軟體停止</translation>
    </message>
    <message>
        <source>Sampling</source>
        <translation>取樣</translation>
    </message>
    <message>
        <source>Session file</source>
        <translation>工作階段檔案</translation>
    </message>
    <message>
        <source>Set temperature</source>
        <translation>設定溫度</translation>
    </message>
    <message>
        <source>Set-up</source>
        <translation>實驗設定</translation>
    </message>
    <message>
        <source>Head of the hash chain (bask verify --head)</source>
        <translation>雜湊鏈的頭（bask verify --head）</translation>
    </message>
    <message>
        <source>Size of the session file</source>
        <translation>工作階段檔案大小</translation>
    </message>
    <message>
        <source>Speed limits</source>
        <translation>速度限值</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>開始</translation>
    </message>
    <message>
        <source>Start pose</source>
        <translation>起始位姿</translation>
    </message>
    <message>
        <source>Steady, all together</source>
        <translation>穩態，同時保持</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Surroundings</source>
        <translation>周圍環境</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>目標</translation>
    </message>
    <message>
        <source>Target at the start</source>
        <translation>開始時的目標</translation>
    </message>
    <message>
        <source>Targets</source>
        <translation>目標</translation>
    </message>
    <message>
        <source>Temperature (%1)</source>
        <translation>溫度（%1）</translation>
    </message>
    <message>
        <source>The checksum is of the file without the log beside it.</source>
        <translation>總和檢查碼僅針對該檔案，不含其旁的日誌。</translation>
    </message>
    <message>
        <source>The experiment has none: the pose of the source is as typed.</source>
        <translation>實驗中沒有：熱源位姿為手動輸入。</translation>
    </message>
    <message>
        <source>The rig was simulated: these are not measurements of a real one.</source>
        <translation>實驗台為模擬：這些不是實際實驗台的測量結果。</translation>
    </message>
    <message>
        <source>The targets cannot be held together, by the materials as given: %1.</source>
        <translation>按給定的材料，各目標不能同時保持：%1。</translation>
    </message>
    <message>
        <source>Time (s)</source>
        <translation>時間（s）</translation>
    </message>
    <message>
        <source>Traces and trajectories</source>
        <translation>曲線與軌跡</translation>
    </message>
    <message>
        <source>View factor needed</source>
        <translation>所需的角係數</translation>
    </message>
    <message>
        <source>Warning, trip</source>
        <translation>警告，跳脫</translation>
    </message>
    <message>
        <source>Trajectories of the objects</source>
        <translation>物體的軌跡</translation>
    </message>
    <message>
        <source>Trajectories of the objects&apos; centres over the source until Stop, from the ring to the dot, coloured by temperature; black: the source.</source>
        <translation>到「停止」為止物體中心在熱源上方的軌跡，從圓環到圓點，按溫度著色；黑色：熱源。</translation>
    </message>
    <message>
        <source>What</source>
        <translation>內容</translation>
    </message>
    <message>
        <source>Workspace</source>
        <translation>工作空間</translation>
    </message>
    <message>
        <source>Zero the sensors</source>
        <translation>將感測器歸零</translation>
    </message>
    <message>
        <source>alarm, priority %1</source>
        <translation>警報，優先順序 %1</translation>
    </message>
    <message>
        <source>as in the paper, without reflection</source>
        <translation>如論文所示，不計反射</translation>
    </message>
    <message>
        <source>as typed</source>
        <translation>按輸入值</translation>
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
        <translation>圓盤，半徑 %1 mm</translation>
    </message>
    <message>
        <source>error not known</source>
        <translation>誤差未知</translation>
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
        <translation>灰體，計入反射</translation>
    </message>
    <message>
        <source>measured by the camera, %1</source>
        <translation>由相機測量，%1</translation>
    </message>
    <message>
        <source>no event was recorded</source>
        <translation>沒有記錄到事件</translation>
    </message>
    <message>
        <source>no samples were recorded</source>
        <translation>沒有記錄到取樣</translation>
    </message>
    <message>
        <source>none</source>
        <translation>無</translation>
    </message>
    <message>
        <source>not calibrated</source>
        <translation>未校正</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>note</source>
        <translation>備註</translation>
    </message>
    <message>
        <source>offsets of the sensors %1</source>
        <translation>感測器偏移 %1</translation>
    </message>
    <message>
        <source>page %1 of %2</source>
        <translation>第 %1 頁，共 %2 頁</translation>
    </message>
    <message>
        <source>polygon, radius %1 mm</source>
        <translation>多邊形，半徑 %1 mm</translation>
    </message>
    <message>
        <source>seen along x of the source</source>
        <translation>沿熱源 x 方向觀察</translation>
    </message>
    <message>
        <source>seen along −z of the source</source>
        <translation>沿熱源 −z 方向觀察</translation>
    </message>
    <message>
        <source>simulated, seed %1</source>
        <translation>模擬，隨機種子 %1</translation>
    </message>
    <message>
        <source>surroundings %1</source>
        <translation>周圍環境 %1</translation>
    </message>
    <message>
        <source>targets out of reach accepted</source>
        <translation>已接受無法達到的目標</translation>
    </message>
    <message>
        <source>too cold</source>
        <translation>太冷</translation>
    </message>
    <message>
        <source>too hot</source>
        <translation>太熱</translation>
    </message>
    <message>
        <source>within the range</source>
        <translation>在範圍內</translation>
    </message>
    <message>
        <source>without a name</source>
        <translation>未命名</translation>
    </message>
    <message numerus="yes">
        <source>%1 (min:s), %n sample(s)</source>
        <translation>
            <numerusform>%1（分:秒），%n 個取樣</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 pixels, fx = %2 px, fy = %3 px, %4, %n view(s)</source>
        <translation>
            <numerusform>%1 像素，fx = %2 px，fy = %3 px，%4，%n 個視圖</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n alarm(s)</source>
        <translation>
            <numerusform>%n 個警報</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n hole(s)</source>
        <translation>
            <numerusform>%n 個孔</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n marker(s) of dictionary %1</source>
        <translation>
            <numerusform>字典 %1 的 %n 個標記</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n more row(s) are in the session file; bask export --csv lists them.</source>
        <translation>
            <numerusform>工作階段檔案中還有 %n 行；可用 bask export --csv 列出。</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 bytes</source>
        <translation>%1 位元組</translation>
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
        <translation>因軟體停止結束。</translation>
    </message>
    <message>
        <source>Interrupted: the recording ended without a Stop, and was closed later. What had been written is reported.</source>
        <translation>已中斷：記錄未經「停止」而結束，後來才關閉。本報告為已寫入的內容。</translation>
    </message>
    <message>
        <source>All targets can be held together, by the materials as given, at %1; margin %2 to the nearest limit (%3).</source>
        <translation>按給定的材料，所有目標可在 %1 處同時保持；距最近的限制（%3）餘量 %2。</translation>
    </message>
    <message>
        <source>Safety limits</source>
        <translation>安全限值</translation>
    </message>
    <message>
        <source>Air</source>
        <translation>空氣</translation>
    </message>
    <message>
        <source>natural convection, by correlation</source>
        <translation>自然對流，依關聯式</translation>
    </message>
    <message>
        <source>convection h = %1 W/(m² K)</source>
        <translation>對流係數 h = %1 W/(m² K)</translation>
    </message>
    <message>
        <source>convection not known, not counted</source>
        <translation>對流未知，未計入</translation>
    </message>
    <message>
        <source>Mean view factor</source>
        <translation>平均角係數</translation>
    </message>
    <message>
        <source>Without shade</source>
        <translation>無遮擋</translation>
    </message>
    <message>
        <source>Taken by the others, mean</source>
        <translation>被其他物體擋住，平均</translation>
    </message>
    <message>
        <source>Taken by the others, largest</source>
        <translation>被其他物體擋住，最大</translation>
    </message>
    <message>
        <source>Shade of the objects on one another, from Start until Stop</source>
        <translation>從「開始」到「停止」期間物體之間的相互遮擋</translation>
    </message>
    <message>
        <source>Evenness of the source</source>
        <translation>熱源的均勻性</translation>
    </message>
    <message>
        <source>Fixture or shield</source>
        <translation>夾具或遮板</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>on the end-effector: %1</source>
        <translation>在末端執行器上：%1</translation>
    </message>
    <message>
        <source>in the robot&apos;s base: %1</source>
        <translation>在機器人基座中：%1</translation>
    </message>
    <message>
        <source>thermal camera</source>
        <translation>熱像儀</translation>
    </message>
    <message>
        <source>sensor, checked by the thermal camera</source>
        <translation>感測器，由熱像儀核對</translation>
    </message>
    <message>
        <source>sensor on the object</source>
        <translation>物體上的感測器</translation>
    </message>
    <message>
        <source>Temperature by</source>
        <translation>溫度來自</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>測得</translation>
    </message>
    <message>
        <source>By the camera, ± 2 standard uncertainties</source>
        <translation>熱像儀，± 2 倍標準不確定度</translation>
    </message>
    <message>
        <source>Largest difference across the face</source>
        <translation>面上的最大溫差</translation>
    </message>
    <message>
        <source>Pixels</source>
        <translation>像素</translation>
    </message>
    <message>
        <source>not read</source>
        <translation>未讀取</translation>
    </message>
    <message>
        <source>The thermal camera at the last sample until Stop</source>
        <translation>停止前最後一個取樣時的熱像儀</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>操作員</translation>
    </message>
    <message>
        <source>Sample</source>
        <translation>樣品</translation>
    </message>
    <message>
        <source>Batch</source>
        <translation>批次</translation>
    </message>
    <message>
        <source>not told: the recording was altered</source>
        <translation>不予給出：記錄被改動過</translation>
    </message>
    <message>
        <source>This recording was altered after it had been recorded, so nothing here is proven; bask verify tells where.</source>
        <translation>此記錄在記錄之後被改動過，因此這裡的內容均無法證明；bask verify 會指出位置。</translation>
    </message>
    <message>
        <source>zeroed %1</source>
        <translation>歸零於 %1</translation>
    </message>
    <message>
        <source>from Arm at %1; Start at %2</source>
        <translation>自待命起，%1；開始，%2</translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation>模擬</translation>
    </message>
    <message>
        <source>Heat rates at Start</source>
        <translation>開始時的熱速率</translation>
    </message>
    <message>
        <source>%1 %2 (set point %3)</source>
        <comment>when: the source&apos;s temperature</comment>
        <translation>%1 %2（設定值 %3）</translation>
    </message>
    <message>
        <source>at Start</source>
        <translation>開始時</translation>
    </message>
    <message>
        <source>settled at %1 s</source>
        <translation>%1 s 穩定時</translation>
    </message>
    <message>
        <source>at the end of control</source>
        <translation>控制結束時</translation>
    </message>
    <message>
        <source>Source in the run</source>
        <translation>運轉中的熱源</translation>
    </message>
    <message>
        <source>λ₁ at Start (K/s)</source>
        <translation>開始時的 λ₁（K/s）</translation>
    </message>
    <message>
        <source>by the material</source>
        <translation>依材料</translation>
    </message>
    <message>
        <source>λ₂ at Start (1/(K³ s))</source>
        <translation>開始時的 λ₂（1/(K³ s)）</translation>
    </message>
    <message>
        <source>Where from</source>
        <translation>來源</translation>
    </message>
    <message>
        <source>given by the experiment</source>
        <translation>由實驗給出</translation>
    </message>
    <message>
        <source>the material, made wrong</source>
        <translation>材料，有意加入誤差</translation>
    </message>
    <message>
        <source>the material</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>Heat rates with which the controller began</source>
        <translation>控制器起始時所用的熱速率</translation>
    </message>
    <message>
        <source>± is the standard uncertainty of a material&apos;s value.</source>
        <translation>± 為材料數值的標準不確定度。</translation>
    </message>
    <message>
        <source>none</source>
        <comment>no simulated fault any more</comment>
        <translation>無</translation>
    </message>
    <message>
        <source>ended</source>
        <comment>a simulated fault</comment>
        <translation>已結束</translation>
    </message>
    <message>
        <source>Speed of the simulation</source>
        <translation>模擬速度</translation>
    </message>
    <message>
        <source>Temperature of the source, as typed</source>
        <translation>熱源溫度（手動輸入）</translation>
    </message>
    <message>
        <source>Simulated fault</source>
        <translation>模擬故障</translation>
    </message>
</context>
<context>
    <name>bask::RunStateChip</name>
    <message>
        <source>Click for the reasons and what to do.</source>
        <translation>按一下可檢視原因和處理方法。</translation>
    </message>
    <message>
        <source>State of the run: %1</source>
        <translation>運轉狀態：%1</translation>
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
        <translation>%1 有自己的限值：警告 %2，跳脫 %3。</translation>
    </message>
</context>
<context>
    <name>bask::SaveMaterialDialog</name>
    <message>
        <source>Save as material</source>
        <translation>另存為材料</translation>
    </message>
    <message>
        <source>measured on a sample, data sheet, book</source>
        <translation>樣品量測、資料表、書籍</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名稱</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>來源</translation>
    </message>
    <message>
        <source>Values, with their standard uncertainties</source>
        <translation>數值及其標準不確定度</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>儲存</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>未知</translation>
    </message>
    <message>
        <source>Standard uncertainty: %1</source>
        <translation>標準不確定度：%1</translation>
    </message>
    <message>
        <source>The library has a material of this name. Its values are replaced.</source>
        <translation>材料庫中已有此名稱的材料。其數值將被取代。</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>取代</translation>
    </message>
    <message>
        <source>As it is, or as a share of the value: 2 %</source>
        <translation>直接填寫，或寫成該值的百分比：2 %</translation>
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
        <translation>物體的 x（cm）</translation>
    </message>
    <message>
        <source>object&apos;s y (cm)</source>
        <translation>物體的 y（cm）</translation>
    </message>
    <message>
        <source>object&apos;s z (cm)</source>
        <translation>物體的 z（cm）</translation>
    </message>
</context>
<context>
    <name>bask::SceneView</name>
    <message>
        <source>Source</source>
        <translation>熱源</translation>
    </message>
    <message>
        <source>3-D scene</source>
        <translation>3D 場景</translation>
    </message>
    <message>
        <source>The 3-D scene needs OpenGL 3.2, which this display does not offer. Everything else works.</source>
        <translation>3D 場景需要 OpenGL 3.2，而此顯示環境不提供。其他功能均正常。</translation>
    </message>
</context>
<context>
    <name>bask::SerialForm</name>
    <message>
        <source>no parity</source>
        <translation>無同位</translation>
    </message>
    <message>
        <source>even parity</source>
        <translation>偶同位</translation>
    </message>
    <message>
        <source>odd parity</source>
        <translation>奇同位</translation>
    </message>
    <message>
        <source>Speed of the line, baud</source>
        <translation>線路速率，baud</translation>
    </message>
    <message>
        <source>Data bits</source>
        <translation>資料位元</translation>
    </message>
    <message>
        <source>Parity</source>
        <translation>同位</translation>
    </message>
    <message>
        <source>Stop bits</source>
        <translation>停止位元</translation>
    </message>
</context>
<context>
    <name>bask::SessionActions</name>
    <message>
        <source>Unsaved experiment</source>
        <translation>未儲存的實驗</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was changed and not saved.</source>
        <translation>「%1」已更改但未儲存。</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>儲存</translation>
    </message>
    <message>
        <source>Discard changes</source>
        <translation>放棄更改</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Open an experiment or a session</source>
        <translation>開啟實驗或工作階段</translation>
    </message>
    <message>
        <source>Experiments and sessions (*.json *.bask);;Experiments (*.json);;Sessions (*.bask);;All files (*)</source>
        <translation>實驗和工作階段 (*.json *.bask);;實驗 (*.json);;工作階段 (*.bask);;所有檔案 (*)</translation>
    </message>
    <message>
        <source>Open a session</source>
        <translation>開啟工作階段</translation>
    </message>
    <message>
        <source>Sessions (*.bask);;All files (*)</source>
        <translation>工作階段 (*.bask);;所有檔案 (*)</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>已儲存 %1</translation>
    </message>
    <message>
        <source>Save the experiment</source>
        <translation>儲存實驗</translation>
    </message>
    <message>
        <source>Experiments (*.json)</source>
        <translation>實驗 (*.json)</translation>
    </message>
    <message>
        <source>Save the session</source>
        <translation>儲存工作階段</translation>
    </message>
    <message>
        <source>Sessions (*.bask)</source>
        <translation>工作階段 (*.bask)</translation>
    </message>
    <message>
        <source>Session saved as %1</source>
        <translation>工作階段已另存為 %1</translation>
    </message>
    <message>
        <source>the folder cannot be made</source>
        <translation>無法建立資料夾</translation>
    </message>
    <message>
        <source>Open a rig</source>
        <translation>開啟實驗台</translation>
    </message>
    <message>
        <source>Rigs (*.json);;All files (*)</source>
        <translation>實驗台 (*.json);;所有檔案 (*)</translation>
    </message>
    <message>
        <source>Save the rig</source>
        <translation>儲存實驗台</translation>
    </message>
    <message>
        <source>The rig was saved as %1.</source>
        <translation>實驗台已儲存為 %1。</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>儲存報告</translation>
    </message>
    <message>
        <source>Texts (*.txt);;All files (*)</source>
        <translation>文字檔 (*.txt);;所有檔案 (*)</translation>
    </message>
    <message>
        <source>The report was saved as %1.</source>
        <translation>報告已儲存為 %1。</translation>
    </message>
    <message>
        <source>Folder of recorded runs</source>
        <translation>已記錄運轉的資料夾</translation>
    </message>
    <message>
        <source>Folder for the exported files</source>
        <translation>存放匯出檔案的資料夾</translation>
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
        <translation>未開啟「%1」：讀取期間有新的編輯或已復原的編輯。如要取代這些編輯，請重新開啟。</translation>
    </message>
    <message>
        <source>Limits of the real rig</source>
        <translation>實機實驗台的限值</translation>
    </message>
    <message>
        <source>&quot;%1&quot; allows the real rig more than now:</source>
        <translation>「%1」允許實機實驗台超出現在的範圍：</translation>
    </message>
    <message>
        <source>Do robot, source, objects and sensors bear it?</source>
        <translation>機器人、熱源、物體和感測器能承受嗎？</translation>
    </message>
    <message>
        <source>Open with these limits</source>
        <translation>以這些限值開啟</translation>
    </message>
    <message>
        <source>Save the comparison</source>
        <translation>儲存比較</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>表格 (*.csv)</translation>
    </message>
    <message>
        <source>The experiment of %1 is open as a new one, which is not saved yet.</source>
        <translation>%1 的實驗已作為新實驗開啟，尚未儲存。</translation>
    </message>
    <message>
        <source>Figures (*%1)</source>
        <translation>圖 (*%1)</translation>
    </message>
    <message>
        <source>Save the table</source>
        <translation>儲存表格</translation>
    </message>
    <message>
        <source>Save the figure</source>
        <translation>儲存圖</translation>
    </message>
    <message>
        <source>No table was written: the first samples of the shown time are in the recording only. Open it on the Review page and export the table there, or show a later stretch of time.</source>
        <translation>未寫入表格：所顯示時間內最初的取樣只在記錄中。請在「回顧」頁開啟該記錄並在那裡匯出表格，或顯示較晚的時間段。</translation>
    </message>
    <message>
        <source>Figures and reports are drawn only while no run and no recipe is on or begins, no heat is asked for and the robot stands still: the window, with its STOP, would have to wait for them. Nothing was written.</source>
        <translation>只有沒有運轉或配方正在進行或開始、未要求加熱且機器人靜止時才繪製圖形和報告：否則帶有 STOP 的視窗必須等待。未寫入任何內容。</translation>
    </message>
    <message>
        <source>Choose another name</source>
        <translation>選擇其他名稱</translation>
    </message>
    <message>
        <source>%1 is there already.</source>
        <translation>%1 已經存在。</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>取代</translation>
    </message>
    <message>
        <source>Save the NeXus file</source>
        <translation>儲存 NeXus 檔案</translation>
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
            <numerusform>已將 %n 個檔案寫入 %1</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 written to %2</source>
        <translation>已將 %1 寫入 %2</translation>
    </message>
</context>
<context>
    <name>bask::SessionList</name>
    <message numerus="yes">
        <source>%1 of %n session(s)</source>
        <translation>
            <numerusform>%n 個工作階段中的 %1 個</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n sample(s)</source>
        <translation>
            <numerusform>%n 個樣本</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n session(s)</source>
        <translation>
            <numerusform>%n 個工作階段</numerusform>
        </translation>
    </message>
    <message>
        <source>Choose the folder whose runs are listed</source>
        <translation>選擇要列出其運轉的資料夾</translation>
    </message>
    <message>
        <source>Close it properly</source>
        <translation>正確關閉</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>持續時間</translation>
    </message>
    <message>
        <source>Folder…</source>
        <translation>資料夾…</translation>
    </message>
    <message>
        <source>Kept in the session file. A recording without an end has to be closed first.</source>
        <translation>保存在工作階段檔案中。沒有結尾的記錄須先關閉。</translation>
    </message>
    <message>
        <source>LIVE</source>
        <translation>實機</translation>
    </message>
    <message>
        <source>No recorded runs in this folder.</source>
        <translation>此資料夾中沒有已記錄的運轉。</translation>
    </message>
    <message>
        <source>Open on this page</source>
        <translation>已在本頁開啟</translation>
    </message>
    <message>
        <source>Open the selected run</source>
        <translation>開啟所選運轉</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>開啟</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>結果</translation>
    </message>
    <message>
        <source>Overlay</source>
        <translation>疊加</translation>
    </message>
    <message>
        <source>Reading the folder…</source>
        <translation>正在讀取資料夾…</translation>
    </message>
    <message>
        <source>Recorded runs</source>
        <translation>已記錄的運轉</translation>
    </message>
    <message>
        <source>Recorded</source>
        <translation>記錄時間</translation>
    </message>
    <message>
        <source>Rig</source>
        <translation>實驗台</translation>
    </message>
    <message>
        <source>SIMULATED</source>
        <translation>模擬</translation>
    </message>
    <message>
        <source>Search the recorded runs</source>
        <translation>搜尋已記錄的運轉</translation>
    </message>
    <message>
        <source>Tags of the selected run, with commas</source>
        <translation>所選運轉的標籤，用逗號分隔</translation>
    </message>
    <message>
        <source>Tags</source>
        <translation>標籤</translation>
    </message>
    <message>
        <source>The recording has no end: Bask or the computer went down. Saved: %1, until %2 after Start; at most the last %3 s before it went down are missing.</source>
        <translation>記錄沒有結尾：Bask 或電腦曾意外終止。已儲存：%1，直至開始後 %2；最多缺少終止前最後 %3 秒。</translation>
    </message>
    <message>
        <source>The runs listed are in %1</source>
        <translation>所列運轉位於 %1</translation>
    </message>
    <message>
        <source>This run is being recorded now.</source>
        <translation>此運轉正在記錄中。</translation>
    </message>
    <message>
        <source>with commas</source>
        <translation>用逗號分隔</translation>
    </message>
    <message>
        <source>Search names, experiments, operators, samples, notes, tags</source>
        <translation>搜尋名稱、實驗、操作員、樣品、備註、標籤</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>操作員</translation>
    </message>
    <message>
        <source>Sample / batch</source>
        <translation>樣品 / 批次</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>運轉</translation>
    </message>
    <message>
        <source>No run matches &quot;%1&quot;.</source>
        <translation>沒有符合「%1」的運轉。</translation>
    </message>
    <message>
        <source>Show all runs</source>
        <translation>顯示全部運轉</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>開啟(&amp;O)</translation>
    </message>
    <message>
        <source>O&amp;verlay</source>
        <translation>疊加(&amp;V)</translation>
    </message>
    <message>
        <source>Open as &amp;new experiment</source>
        <translation>作為新實驗開啟(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Sort by</source>
        <translation>排序方式(&amp;S)</translation>
    </message>
    <message>
        <source>Finds the runs that have every word in what the list shows, or among objects, materials and notes.</source>
        <translation>尋找清單所顯示的內容或物體、材料、備註中含有全部字詞的運轉。</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>控制器</translation>
    </message>
    <message>
        <source>Alarms…</source>
        <translation>警報…</translation>
    </message>
    <message>
        <source>Which alarms the listed runs had, how often and when</source>
        <translation>所列運轉中出現過哪些警報、多少次、何時</translation>
    </message>
    <message>
        <source>From Start to Stop, STOP or the engine&apos;s end of the run. What is recorded after it, until all is away or cold, does not count.</source>
        <translation>從「開始」到「停止」、軟體停止或引擎結束運轉為止。此後記錄到一切撤離或冷卻為止的部分不計。</translation>
    </message>
    <message>
        <source>Lay the selected runs over the open one</source>
        <translation>將所選的各次運轉疊加到已開啟的運轉上</translation>
    </message>
    <message>
        <source>Draws the selected runs over the one that is open, all from their Start. Without an open one, select several (Ctrl and click): the first of them is opened.</source>
        <translation>將所選的各次運轉疊加到已開啟的運轉上，都從開始時刻對齊。沒有開啟的運轉時，請選取幾次（按住 Ctrl 並按一下）：其中第一個會被開啟。</translation>
    </message>
    <message>
        <source>Not verified: nobody has looked yet whether the recording is as it was made.</source>
        <translation>未驗證：還沒有人查看此記錄是否與產生時一致。</translation>
    </message>
    <message>
        <source>%1, not verified</source>
        <comment>an outcome</comment>
        <translation>%1，未驗證</translation>
    </message>
    <message>
        <source>What each run told at its end; in italics until its recording was verified: a short one while nothing else is to be done, a long one when it is opened. Damage of its file is found when the run is selected, too. All of it is listed until the file changes or Bask is closed.</source>
        <translation>各次運轉結束時給出的結果；在其記錄得到驗證之前以斜體顯示：較短的在沒有別的事要做時驗證，較長的在開啟時驗證。選取運轉時也會發現其檔案的損壞。這些都保留到檔案改變或 Bask 關閉。</translation>
    </message>
</context>
<context>
    <name>bask::SheetPanel</name>
    <message>
        <source>A marker&apos;s side is truly %1.</source>
        <translation>標記的實際邊長為 %1。</translation>
    </message>
    <message>
        <source>A square&apos;s side is truly %1.</source>
        <translation>方格的實際邊長為 %1。</translation>
    </message>
    <message>
        <source>&amp;Dictionary</source>
        <translation>字典(&amp;D)</translation>
    </message>
    <message>
        <source>Calibration board</source>
        <translation>校正板</translation>
    </message>
    <message>
        <source>Give the markers&apos; numbers such as 1-4, 11.</source>
        <translation>請給出標記編號，例如 1-4, 11。</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>標記</translation>
    </message>
    <message>
        <source>Measured &amp;length</source>
        <translation>實測長度(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Numbers</source>
        <translation>編號(&amp;N)</translation>
    </message>
    <message>
        <source>Of the ruler on the print, which is 100 mm long.</source>
        <translation>列印稿上標尺的長度，其標稱長度為 100 mm。</translation>
    </message>
    <message>
        <source>&amp;Paper</source>
        <translation>紙張(&amp;P)</translation>
    </message>
    <message>
        <source>Printers scale, and no picture tells how large a square is: measure the ruler on the print, from 0 to 100 mm.</source>
        <translation>印表機會縮放，而影像無法得知方格有多大：請測量列印稿上的標尺，從 0 到 100 mm。</translation>
    </message>
    <message>
        <source>Save as PDF…</source>
        <translation>儲存為 PDF…</translation>
    </message>
    <message>
        <source>Save the sheet</source>
        <translation>儲存列印頁面</translation>
    </message>
    <message>
        <source>Saved. Print it at 100 % (actual size) and measure its ruler.</source>
        <translation>已儲存。請按 100 %（實際尺寸）列印，並測量其標尺。</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>列印頁面</translation>
    </message>
    <message>
        <source>Sheets to be printed</source>
        <translation>待列印的頁面</translation>
    </message>
    <message>
        <source>&amp;Side of a marker</source>
        <translation>標記的邊長(&amp;S)</translation>
    </message>
    <message>
        <source>Such as 1-4, 11</source>
        <translation>例如 1-4, 11</translation>
    </message>
    <message>
        <source>The first of %1 pages</source>
        <translation>第一頁，共 %1 頁</translation>
    </message>
    <message>
        <source>The sheet as it is printed</source>
        <translation>列印頁面的實際樣子</translation>
    </message>
    <message>
        <source>Use the true lengths</source>
        <translation>使用實際長度</translation>
    </message>
    <message>
        <source>With its black border.</source>
        <translation>含黑色邊框。</translation>
    </message>
    <message>
        <source>Print</source>
        <translation>列印</translation>
    </message>
    <message>
        <source>The sheet was saved as %1.</source>
        <translation>列印頁面已儲存為 %1。</translation>
    </message>
</context>
<context>
    <name>bask::ShelfPopup</name>
    <message>
        <source>An alarm of priority 1 is shelved for a shorter time.</source>
        <translation>優先級 1 的警報只能擱置較短時間。</translation>
    </message>
    <message>
        <source>Put this alarm aside for a time. It comes back by itself, and the engine goes on watching and acting.</source>
        <translation>將此警報暫時擱置。它會自行恢復，引擎繼續監視和動作。</translation>
    </message>
    <message>
        <source>Why? (needed)</source>
        <translation>為什麼？（必填）</translation>
    </message>
    <message>
        <source>Why the alarm is shelved</source>
        <translation>擱置警報的理由</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 分鐘</translation>
    </message>
    <message>
        <source>Shelve for %1 min</source>
        <translation>擱置 %1 分鐘</translation>
    </message>
</context>
<context>
    <name>bask::SourceTile</name>
    <message>
        <source>Source</source>
        <translation>熱源</translation>
    </message>
    <message>
        <source>Set point</source>
        <translation>設定值</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>變化率</translation>
    </message>
    <message>
        <source>Slope of the readings of the last 10 s</source>
        <translation>最近 10 s 讀數的斜率</translation>
    </message>
    <message>
        <source>Where the heat goes, or the set point with which a run begins while it is off</source>
        <translation>加熱的目標值；加熱關閉時，為運轉開始時的設定值</translation>
    </message>
    <message>
        <source>Temperature of the source</source>
        <translation>熱源的溫度</translation>
    </message>
</context>
<context>
    <name>bask::SourceWords</name>
    <message>
        <source>How long it takes to heat it is not known.</source>
        <translation>加熱需要多長時間未知。</translation>
    </message>
    <message>
        <source>Heated from now on it takes about %1.</source>
        <translation>從現在起加熱，大約需要 %1。</translation>
    </message>
    <message>
        <source>The source has %1, its set point is %2 (%3). Start does not wait for it: the run begins, and its time counts, while the source warms up.</source>
        <translation>熱源為 %1，其設定值為 %2（%3）。「開始」不會等待它：熱源升溫期間運轉已經開始並計時。</translation>
    </message>
    <message>
        <source>The run has ended. Its time and its recording go on until the source and the objects are cold (source %1), or until the next Arm.</source>
        <translation>運轉已結束。其時間和記錄繼續，直到熱源和物體冷卻（熱源 %1）或下一次待命為止。</translation>
    </message>
</context>
<context>
    <name>bask::StateBar</name>
    <message>
        <source>The engine is not answering. The robot ends its step, and a heat source with a watchdog goes off by itself. Look at the rig, then close Bask and start it again.</source>
        <translation>引擎沒有回應。機器人會走完目前這一步，具有看門狗的熱源會自行關閉。請查看實驗台，然後關閉 Bask 並重新啟動。</translation>
    </message>
    <message>
        <source>The rig is simulated: no device moves or heats.</source>
        <translation>實驗台為模擬：沒有裝置運動或加熱。</translation>
    </message>
    <message>
        <source>The rig is real: Start moves it and opens the heat.</source>
        <translation>實驗台為實機：「開始」會使其運動並開啟加熱。</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>運轉</translation>
    </message>
    <message>
        <source>Time since Start</source>
        <translation>自開始以來的時間</translation>
    </message>
    <message>
        <source>State of the run</source>
        <translation>運轉狀態</translation>
    </message>
    <message>
        <source>Click to change it.</source>
        <translation>按一下可變更。</translation>
    </message>
    <message>
        <source>Simulated faults, which Tools &gt; Simulate fault ends:</source>
        <translation>模擬故障，可在「工具 &gt; 模擬故障」中結束：</translation>
    </message>
    <message>
        <source>recorded until cold</source>
        <comment>under the clock: the run has ended</comment>
        <translation>記錄至冷卻</translation>
    </message>
    <message>
        <source>until cold</source>
        <comment>the same where there is less room</comment>
        <translation>至冷卻</translation>
    </message>
</context>
<context>
    <name>bask::StatusLine</name>
    <message>
        <source>engine not answering</source>
        <translation>引擎沒有回應</translation>
    </message>
    <message>
        <source>readings %1 s old</source>
        <translation>讀數已過去 %1 s</translation>
    </message>
    <message>
        <source>no readings</source>
        <translation>沒有讀數</translation>
    </message>
    <message>
        <source>(simulation ×%1)</source>
        <translation>（模擬 ×%1）</translation>
    </message>
    <message>
        <source>loop %1 Hz, late %2</source>
        <translation>迴路 %1 Hz，延遲 %2</translation>
    </message>
    <message>
        <source>not recording</source>
        <translation>未記錄</translation>
    </message>
    <message>
        <source>recording %1, %2 samples</source>
        <translation>正在記錄 %1，%2 個取樣</translation>
    </message>
    <message>
        <source>Control steps a second, and how many began late</source>
        <translation>每秒控制步數，以及其中延遲開始的步數</translation>
    </message>
    <message>
        <source>Temperature unit</source>
        <translation>溫度單位</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>語言</translation>
    </message>
    <message>
        <source>source not seen</source>
        <translation>看不到熱源</translation>
    </message>
    <message>
        <source>source not seen for %1 s, predicted</source>
        <translation>已有 %1 s 看不到熱源，採用預測</translation>
    </message>
    <message>
        <source>source followed</source>
        <translation>正在追蹤熱源</translation>
    </message>
    <message>
        <source>%1 ms late</source>
        <translation>延遲 %1 ms</translation>
    </message>
    <message>
        <source>±%1 mm</source>
        <translation>±%1 mm</translation>
    </message>
    <message>
        <source>How the camera follows the source: time from the light to the pose, two standard deviations of its place</source>
        <translation>相機追蹤熱源的情況：從曝光到得出位姿的時間，以及熱源位置的兩倍標準差</translation>
    </message>
    <message>
        <source>Age of the newest temperature readings; of a real rig, of each device&apos;s newest answer</source>
        <translation>最新溫度讀數的時齡；對於實際實驗台，為各裝置最新回應的時齡</translation>
    </message>
    <message>
        <source>source %1,</source>
        <translation>熱源 %1，</translation>
    </message>
    <message>
        <source>source %1 as typed,</source>
        <translation>熱源 %1（輸入值），</translation>
    </message>
    <message>
        <source>source: no temperature typed,</source>
        <translation>熱源：未輸入溫度，</translation>
    </message>
    <message>
        <source>monitoring fails</source>
        <translation>監視失敗</translation>
    </message>
    <message>
        <source>monitored</source>
        <translation>受監視</translation>
    </message>
    <message numerus="yes">
        <source>What the run does is published (View &gt; Monitoring): %n message(s)</source>
        <translation>
            <numerusform>運轉的情況已發佈（檢視 &gt; 監視）：%n 則訊息</numerusform>
        </translation>
    </message>
    <message>
        <source>monitoring begins</source>
        <translation>監視開始</translation>
    </message>
    <message numerus="yes">
        <source>%n event(s) were not published</source>
        <translation>
            <numerusform>有 %n 個事件未發佈</numerusform>
        </translation>
    </message>
    <message>
        <source>Newest temperature of the source, and whether it is heated, as the device has confirmed. UNKNOWN: it may be hot, whatever was ordered. Heats though off: it warms all the same.</source>
        <translation>熱源的最新溫度，以及裝置所確認的是否加熱。未知：無論下過什麼命令，它都可能是熱的。關閉仍加熱：它照樣升溫。</translation>
    </message>
    <message>
        <source>recorded until cold: source %1; %2, %3 samples</source>
        <translation>記錄至冷卻：熱源 %1；%2，%3 個取樣</translation>
    </message>
</context>
<context>
    <name>bask::StopButton</name>
    <message>
        <source>STOP</source>
        <translation>軟體停止</translation>
    </message>
    <message>
        <source>Zero velocity and heater off now; latched until reset (F12).
This is a software stop, not a safety-rated emergency stop.</source>
        <translation>立即使速度為零並關閉加熱器；閂鎖直至復歸（F12）。
這是軟體停止，不是安全等級的緊急停止。</translation>
    </message>
    <message>
        <source>STOP: zero velocity and heater off now (F12)</source>
        <translation>軟體停止：立即使速度為零並關閉加熱器（F12）</translation>
    </message>
    <message>
        <source>Software stop, not a safety-rated emergency stop.</source>
        <translation>軟體停止，不是安全等級的緊急停止。</translation>
    </message>
</context>
<context>
    <name>bask::SurfacesView</name>
    <message>
        <source>The animation is not whole: the experiment was changed while it was saved.</source>
        <translation>動畫不完整：儲存期間實驗被更改。</translation>
    </message>
    <message>
        <source>3-D scene: where the end-effector may be for each object to hold its target</source>
        <translation>3D 場景：各物體保持其目標時末端執行器可處的位置</translation>
    </message>
    <message>
        <source>End-effector positions</source>
        <translation>末端執行器位置</translation>
    </message>
    <message>
        <source>Each object&apos;s own positions (as in the paper)</source>
        <translation>各物體自身位置（如論文所示）</translation>
    </message>
    <message>
        <source>End-effector angles</source>
        <translation>末端執行器角度</translation>
    </message>
    <message>
        <source>What the surfaces are drawn over</source>
        <translation>等值面以什麼為座標繪製</translation>
    </message>
    <message>
        <source>What the surfaces are drawn over. On its surface an object holds its target.</source>
        <translation>等值面以什麼為座標繪製。在其等值面上，物體可保持其目標。</translation>
    </message>
    <message>
        <source>Picture saved: %1</source>
        <translation>圖片已儲存：%1</translation>
    </message>
    <message>
        <source>Animation saved in %1: frame-1.png to frame-9.png, and all in panels.png</source>
        <translation>動畫已儲存在 %1：frame-1.png 至 frame-9.png，以及彙總的 panels.png</translation>
    </message>
</context>
<context>
    <name>bask::SurveyBar</name>
    <message>
        <source>The robot moves to pose %1 of %2.</source>
        <translation>機器人正運動到位姿 %1 / %2。</translation>
    </message>
    <message>
        <source>Looking, picture %1 of %2. Nothing may move.</source>
        <translation>正在觀測，影像 %1 / %2。任何東西都不得移動。</translation>
    </message>
    <message>
        <source>Computing…</source>
        <translation>正在計算…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Pictures looked at</source>
        <translation>已觀測的影像</translation>
    </message>
</context>
<context>
    <name>bask::TargetScene</name>
    <message>
        <source>Picked</source>
        <translation>所選點</translation>
    </message>
    <message>
        <source>All targets</source>
        <translation>全部目標</translation>
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
        <translation>機器人不轉動</translation>
    </message>
    <message>
        <source>Robot: %1</source>
        <translation>機器人：%1</translation>
    </message>
    <message>
        <source>%1 %2: nowhere here</source>
        <comment>object, target</comment>
        <translation>%1 %2：此處沒有</translation>
    </message>
    <message>
        <source>3-D scene of the targets</source>
        <translation>目標的 3D 場景</translation>
    </message>
    <message>
        <source>The 3-D scene of the targets needs OpenGL 3.2, which this display does not offer. Everything else works.</source>
        <translation>目標的 3D 場景需要 OpenGL 3.2，而此顯示環境不提供。其他功能均正常。</translation>
    </message>
    <message>
        <source>%1: F %2, steady %3, %4/%5</source>
        <comment>name, view factor, temperature, slope</comment>
        <translation>%1：F %2，穩態 %3，%4/%5</translation>
    </message>
</context>
<context>
    <name>bask::TargetsPage</name>
    <message>
        <source>Target of %1</source>
        <translation>%1 的目標</translation>
    </message>
    <message>
        <source>Checking…</source>
        <translation>正在檢查…</translation>
    </message>
    <message>
        <source>Nearest reachable</source>
        <translation>最近可達</translation>
    </message>
    <message>
        <source>Set the target of %1 to the nearest reachable one</source>
        <translation>將 %1 的目標設為最近的可達值</translation>
    </message>
    <message>
        <source>Set the target to %1</source>
        <translation>將目標設為 %1</translation>
    </message>
    <message>
        <source>The target is within reach already.</source>
        <translation>目標已在可達範圍內。</translation>
    </message>
    <message>
        <source>There is no object yet. Add one on the Objects page.</source>
        <translation>尚無物體。請在「物體」頁面新增一個。</translation>
    </message>
    <message>
        <source>, </source>
        <comment>between names</comment>
        <translation>、</translation>
    </message>
    <message>
        <source>Checking the targets…</source>
        <translation>正在檢查目標…</translation>
    </message>
    <message>
        <source>Targets</source>
        <translation>目標</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>物體</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>目標</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>判定</translation>
    </message>
    <message>
        <source>What is checked</source>
        <translation>檢查的內容</translation>
    </message>
    <message>
        <source>To stay at its target an object must take up as much heat as it gives off. That fixes its view factor F, the share of its sight that the source fills: near 0 far away, near 1 close to the source and facing it. A target is reachable if its F occurs somewhere in the robot&apos;s workspace with the clearance kept; all can be held together if one pose has the F of each. In the bars, solid is what can be held here, outlined what the source could hold at F = 1.</source>
        <translation>要停留在目標溫度，物體吸收的熱量必須與散出的熱量相等。這就確定了它的角係數 F，即熱源在其視野中所佔的份額：遠離時接近 0，靠近並正對熱源時接近 1。若在保持間距的前提下，其 F 在機器人工作空間中的某處出現，該目標即可達；若有一個位姿使各物體的 F 同時出現，則全部目標可同時保持。條形圖中，實心部分為此處可保持的範圍，空心輪廓為熱源在 F = 1 時可保持的範圍。</translation>
    </message>
    <message>
        <source>Starting out of reach</source>
        <translation>在目標無法達到的情況下開始</translation>
    </message>
    <message>
        <source>All targets can be held together.</source>
        <translation>所有目標可同時保持。</translation>
    </message>
    <message>
        <source>Best compromise, at %1: %2.</source>
        <translation>最佳折衷，在 %1 處：%2。</translation>
    </message>
    <message>
        <source>Cannot be held: %1.</source>
        <translation>無法保持：%1。</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>保留</translation>
    </message>
    <message>
        <source>Keep the target of %1</source>
        <translation>保留 %1 的目標</translation>
    </message>
    <message>
        <source>Leave this target as it is when the nearest ones are sought.</source>
        <translation>尋找最近目標時，保持此目標不變。</translation>
    </message>
    <message>
        <source>Nearest targets that can be held: %1.</source>
        <translation>可保持的最近目標：%1。</translation>
    </message>
    <message>
        <source>The target can be held.</source>
        <translation>目標可保持。</translation>
    </message>
    <message>
        <source>Those to be kept cannot be held together.</source>
        <translation>要保留的目標不能同時保持。</translation>
    </message>
    <message>
        <source>Use nearest feasible</source>
        <translation>採用最近的可行目標</translation>
    </message>
    <message>
        <source>Surfaces</source>
        <translation>等值面</translation>
    </message>
    <message>
        <source>Pairs</source>
        <translation>物體對</translation>
    </message>
    <message>
        <source>Predicting how long a run takes…</source>
        <translation>正在預測運轉所需的時間…</translation>
    </message>
    <message>
        <source>Reachable alone</source>
        <translation>可單獨達到</translation>
    </message>
    <message>
        <source>The targets to be kept cannot be held together: untick “Keep” for one.</source>
        <translation>要保留的目標不能同時保持：請取消勾選其中一個的「保留」。</translation>
    </message>
    <message>
        <source>A run with a target out of reach needs your explicit agreement at Start. It holds the best compromise it finds, says so, and the session records that you agreed. During a run new targets are taken at once; if they cannot be held, an event says why.</source>
        <translation>若運轉中有目標無法達到，需要您在開始時明確同意。運轉將保持所找到的最佳折衷並予以說明，工作階段中也會記錄您已同意。運轉期間，新目標立即生效；若無法保持，會有事件說明原因。</translation>
    </message>
    <message>
        <source>No object shades another at this pose.</source>
        <translation>在該位姿時物體之間沒有遮擋。</translation>
    </message>
    <message>
        <source>Held at %1; %2 from the nearest limit: %3.</source>
        <translation>在 %1 處保持；距最近的限值 %2：%3。</translation>
    </message>
    <message>
        <source>Predicted: a run from the start pose does not settle within %1 (simulated).</source>
        <translation>預測：從起始位姿開始的運轉在 %1 內不能穩定（模擬）。</translation>
    </message>
    <message>
        <source>Predicted: a run from the start pose has settled after %1 (simulated).</source>
        <translation>預測：從起始位姿開始的運轉在 %1 後穩定（模擬）。</translation>
    </message>
</context>
<context>
    <name>bask::ThermalCameraForm</name>
    <message>
        <source>Take a profile from a file</source>
        <translation>從檔案讀取配置</translation>
    </message>
    <message>
        <source>Profiles (*.json)</source>
        <translation>設定檔 (*.json)</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>相機</translation>
    </message>
    <message>
        <source>Kind of thermal camera</source>
        <translation>熱像儀的型號</translation>
    </message>
    <message>
        <source>From file…</source>
        <translation>從檔案…</translation>
    </message>
    <message>
        <source>Take what the camera&apos;s numbers mean from a file</source>
        <translation>從檔案取得相機數值的含義</translation>
    </message>
    <message>
        <source>Its pose in the robot&apos;s base is known</source>
        <translation>其在機器人基座中的位姿已知</translation>
    </message>
    <message>
        <source>The camera&apos;s axes: x right, y down, z along its view. Without its pose it shows pictures and reads no object.</source>
        <translation>相機的軸：x 向右，y 向下，z 沿視線方向。沒有位姿時它只顯示影像，不讀取任何物體。</translation>
    </message>
    <message>
        <source>Pose of the camera, %1</source>
        <translation>相機的位姿，%1</translation>
    </message>
</context>
<context>
    <name>bask::ThermalCanvas</name>
    <message>
        <source>no value</source>
        <translation>無數值</translation>
    </message>
    <message>
        <source>saturated</source>
        <translation>飽和</translation>
    </message>
    <message>
        <source>below range</source>
        <translation>低於量程</translation>
    </message>
    <message>
        <source>%1 at column %2, row %3</source>
        <translation>%1（第 %2 行，第 %3 列）</translation>
    </message>
    <message>
        <source>saturated %1</source>
        <comment>a number of pixels</comment>
        <translation>飽和 %1</translation>
    </message>
    <message>
        <source>below range %1</source>
        <comment>a number of pixels</comment>
        <translation>低於量程 %1</translation>
    </message>
    <message>
        <source>no value %1</source>
        <comment>a number of pixels</comment>
        <translation>無數值 %1</translation>
    </message>
    <message>
        <source>Thermal picture</source>
        <translation>熱像圖</translation>
    </message>
    <message>
        <source>Arrow keys place a spot, which tells a pixel&apos;s temperature; Escape removes it.</source>
        <translation>方向鍵可放置測溫點，顯示一個像素的溫度；Esc 鍵將其移除。</translation>
    </message>
    <message>
        <source>Apparent temperature: that of a black body which looks the same. The objects&apos; temperatures have reflections and emittance taken into account.</source>
        <translation>表觀溫度：看起來相同的黑體的溫度。物體的溫度已計入反射和發射率。</translation>
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
        <translation>灰階</translation>
    </message>
    <message>
        <source>Colours of the thermal picture</source>
        <translation>熱像圖的顏色</translation>
    </message>
    <message>
        <source>Limits: objects</source>
        <translation>界限：物體</translation>
    </message>
    <message>
        <source>Limits: picture</source>
        <translation>界限：影像</translation>
    </message>
    <message>
        <source>Limits: fixed</source>
        <translation>界限：固定</translation>
    </message>
    <message>
        <source>Limits of the colours</source>
        <translation>顏色的界限</translation>
    </message>
    <message>
        <source>What the colours span: the objects&apos; pixels with a margin, all pixels but the 0.5 % at either end, or limits of your own.</source>
        <translation>顏色涵蓋的範圍：物體的像素並留餘量、除兩端各 0.5 % 外的所有像素，或自訂的界限。</translation>
    </message>
    <message>
        <source>Lower limit of the colours</source>
        <translation>顏色的下限</translation>
    </message>
    <message>
        <source>Upper limit of the colours</source>
        <translation>顏色的上限</translation>
    </message>
    <message>
        <source>No isotherm</source>
        <translation>無等溫線</translation>
    </message>
    <message>
        <source>Isotherm: above</source>
        <translation>等溫線：以上</translation>
    </message>
    <message>
        <source>Isotherm: near</source>
        <translation>等溫線：附近</translation>
    </message>
    <message>
        <source>Isotherm</source>
        <translation>等溫線</translation>
    </message>
    <message>
        <source>Draws the pixels in green that are above a temperature, or nearer to it than 0.5 K.</source>
        <translation>將高於某溫度或與其相差不到 0.5 K 的像素畫成綠色。</translation>
    </message>
    <message>
        <source>Temperature of the isotherm</source>
        <translation>等溫線的溫度</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>放大</translation>
    </message>
    <message>
        <source>Show the objects with a margin instead of the whole picture.</source>
        <translation>只顯示物體及其周圍，而不是整幅影像。</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>平滑</translation>
    </message>
    <message>
        <source>Smooth the picture; else each pixel is a square of one colour.</source>
        <translation>平滑影像；否則每個像素為一個單色方塊。</translation>
    </message>
</context>
<context>
    <name>bask::ThermalHistogramPlot</name>
    <message numerus="yes">
        <source>%1: %n pixel(s)</source>
        <translation>
            <numerusform>%1：%n 個像素</numerusform>
        </translation>
    </message>
    <message>
        <source>No pixels are read</source>
        <translation>沒有讀取的像素</translation>
    </message>
    <message>
        <source>mean %1, s.d. %2</source>
        <comment>standard deviation</comment>
        <translation>平均 %1，標準差 %2</translation>
    </message>
    <message>
        <source>Distribution of apparent temperatures</source>
        <translation>表觀溫度的分布</translation>
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
        <translation>熱像儀測得的溫度</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>物體</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>溫度</translation>
    </message>
    <message>
        <source>Spread</source>
        <translation>溫差</translation>
    </message>
    <message>
        <source>Reflections and emittance are taken into account; with two standard deviations.</source>
        <translation>已計入反射和發射率；附兩倍標準差。</translation>
    </message>
    <message>
        <source>Largest difference across the object.</source>
        <translation>物體上的最大溫差。</translation>
    </message>
    <message>
        <source>Whole picture</source>
        <translation>整幅影像</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 至 %2</translation>
    </message>
    <message>
        <source>Apparent temperatures of all but the 0.5 % at either end.</source>
        <translation>除兩端各 0.5 % 外所有像素的表觀溫度。</translation>
    </message>
    <message>
        <source>%1 (part)</source>
        <translation>%1（部分）</translation>
    </message>
    <message>
        <source>A part of the object is outside of the picture: the reading is that of the rest.</source>
        <translation>物體有一部分在影像之外：讀數是其餘部分的。</translation>
    </message>
</context>
<context>
    <name>bask::ThermalPanel</name>
    <message>
        <source>Not measured</source>
        <translation>未測量</translation>
    </message>
    <message>
        <source>As typed</source>
        <translation>按輸入值</translation>
    </message>
    <message>
        <source>In use</source>
        <translation>正在使用</translation>
    </message>
    <message>
        <source>The camera is at %1.</source>
        <translation>相機位於 %1。</translation>
    </message>
    <message>
        <source>The camera is at %1, measured %2.</source>
        <translation>相機位於 %1，測量於：%2。</translation>
    </message>
    <message>
        <source>That is %1 and %2 from where the experiment has it.</source>
        <translation>與實驗中的位置相差 %1 和 %2。</translation>
    </message>
    <message>
        <source>Of the outlines %1 % were found, %2 px from where they should be.</source>
        <translation>找到了 %1 % 的輪廓，與應在的位置相差 %2 px。</translation>
    </message>
    <message>
        <source>Say on the Rig page where the thermal camera is, to 5 cm and 5 degrees.</source>
        <translation>請在「實驗台」頁說明熱像儀的位置，精確到 5 cm 和 5 度。</translation>
    </message>
    <message>
        <source>No picture from the thermal camera.</source>
        <translation>沒有來自熱像儀的影像。</translation>
    </message>
    <message>
        <source>A run is armed or on, or a stop is not reset. Measure after that.</source>
        <translation>已待命、正在運轉，或停止尚未復歸。請在此之後測量。</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Where the thermal camera is</source>
        <translation>熱像儀的位置</translation>
    </message>
    <message>
        <source>By the outlines of the objects at several poses of the robot. The camera has to see them, and they have to be 5 K or more warmer or colder than what is behind them.</source>
        <translation>根據機器人在多個位姿下各物體的輪廓求出。相機須能看到物體，且物體須比其背後之物熱或冷 5 K 以上。</translation>
    </message>
    <message>
        <source>&amp;Several poses</source>
        <translation>多個位姿(&amp;S)</translation>
    </message>
    <message>
        <source>The robot moves to some poses within its workspace, never nearer to the source, and back. Stand clear.</source>
        <translation>機器人將運動到其工作空間內的若干位姿，絕不更靠近熱源，然後返回。請保持距離。</translation>
    </message>
    <message>
        <source>Use this p&amp;lace</source>
        <translation>使用此位置(&amp;L)</translation>
    </message>
    <message>
        <source>As simulated</source>
        <translation>按模擬</translation>
    </message>
    <message>
        <source>A calibration board is looked for. Stop looking first.</source>
        <translation>正在尋找校正板。請先停止尋找。</translation>
    </message>
    <message>
        <source>Measured by an earlier version: measure it again</source>
        <translation>由較早的版本測量：請重新測量</translation>
    </message>
</context>
<context>
    <name>bask::ThermalPictureView</name>
    <message>
        <source>The thermal camera has not given a picture yet.</source>
        <translation>熱像儀尚未給出影像。</translation>
    </message>
    <message>
        <source>This picture is %1.</source>
        <translation>此影像為 %1的。</translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>%1 pictures/s</source>
        <translation>%1 影格/s</translation>
    </message>
    <message>
        <source>shutter %1 ago, drift ± %2</source>
        <translation>快門 %1 前，漂移 ± %2</translation>
    </message>
    <message>
        <source>age %1 s</source>
        <translation>時齡 %1 s</translation>
    </message>
    <message>
        <source>No picture was recorded.</source>
        <translation>沒有錄製影像。</translation>
    </message>
    <message>
        <source>taken at %1</source>
        <translation>拍攝於 %1</translation>
    </message>
    <message numerus="yes">
        <source>%n picture(s) left out</source>
        <translation>
            <numerusform>略過 %n 幅影像</numerusform>
        </translation>
    </message>
    <message>
        <source>Left out last: %1</source>
        <translation>最近略過的：%1</translation>
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
        <translation>轉動</translation>
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
        <translation>自開始以來的時間（時:分:秒）</translation>
    </message>
    <message>
        <source>Time since start (min:s)</source>
        <translation>自開始以來的時間（分:秒）</translation>
    </message>
    <message>
        <source>Speed (% of limit)</source>
        <translation>速度（佔限值的 %）</translation>
    </message>
    <message>
        <source>Plot against time: %1</source>
        <translation>隨時間變化的曲線圖：%1</translation>
    </message>
    <message>
        <source>Arrow keys move, plus and minus zoom, Home shows the whole run, End goes back to live.</source>
        <translation>方向鍵平移，加號和減號縮放，Home 顯示整個運轉，End 返回即時。</translation>
    </message>
    <message>
        <source>No samples yet. Traces begin with Start.</source>
        <translation>尚無取樣。曲線從「開始」時起繪製。</translation>
    </message>
    <message>
        <source>This controller does not estimate λ₁.</source>
        <translation>此控制器不估計 λ₁。</translation>
    </message>
    <message>
        <source>Nothing has shaded an object.</source>
        <translation>沒有物體被遮擋。</translation>
    </message>
    <message>
        <source>Time since Start (h)</source>
        <translation>自開始以來的時間（h）</translation>
    </message>
    <message>
        <source>Time since Start (min)</source>
        <translation>自開始以來的時間（min）</translation>
    </message>
    <message>
        <source>Time since Start (s)</source>
        <translation>自開始以來的時間（s）</translation>
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
        <translation>點線：預測。曲線從「開始」時起繪製。</translation>
    </message>
    <message>
        <source>predicted</source>
        <translation>預測</translation>
    </message>
    <message>
        <source>predicted, not settled by then</source>
        <translation>預測，屆時未穩定</translation>
    </message>
    <message>
        <source>predicted, not computed further</source>
        <translation>預測，未繼續計算</translation>
    </message>
    <message>
        <source>predicted to end in a fault</source>
        <translation>預測以故障結束</translation>
    </message>
    <message>
        <source>target</source>
        <translation>目標</translation>
    </message>
    <message>
        <source>band of ±%1</source>
        <comment>%1 is 0.5 K</comment>
        <translation>±%1 的容差帶</translation>
    </message>
    <message numerus="yes">
        <source>%n more without a number</source>
        <comment>moments that are close to another one</comment>
        <translation>
            <numerusform>另有 %n 個未編號</numerusform>
        </translation>
    </message>
    <message>
        <source>predicted; band: other sensor noise only</source>
        <translation>預測；色帶：僅感測器雜訊不同</translation>
    </message>
</context>
<context>
    <name>bask::TrafficModel</name>
    <message>
        <source>sent</source>
        <translation>傳送</translation>
    </message>
    <message>
        <source>sent by hand</source>
        <translation>手動傳送</translation>
    </message>
    <message>
        <source>received</source>
        <translation>接收</translation>
    </message>
    <message>
        <source>error output</source>
        <translation>錯誤輸出</translation>
    </message>
    <message>
        <source>opened</source>
        <translation>開啟</translation>
    </message>
    <message>
        <source>closed</source>
        <translation>關閉</translation>
    </message>
    <message numerus="yes">
        <source>%1… (%n bytes)</source>
        <translation>
            <numerusform>%1…（%n 位元組）</numerusform>
        </translation>
    </message>
    <message>
        <source>Time</source>
        <translation>時間</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>連線</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>Bytes</source>
        <translation>位元組</translation>
    </message>
</context>
<context>
    <name>bask::TransportBar</name>
    <message>
        <source>Pause</source>
        <translation>暫停</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>播放</translation>
    </message>
    <message>
        <source>Position and length of the run</source>
        <translation>運轉的位置與時長</translation>
    </message>
    <message>
        <source>Position in the run</source>
        <translation>運轉中的位置</translation>
    </message>
    <message>
        <source>REPLAY</source>
        <translation>重播</translation>
    </message>
    <message>
        <source>Space, while nothing else on the page takes it</source>
        <translation>空白鍵（頁面上沒有其他控制項占用時）</translation>
    </message>
    <message>
        <source>Speed of the replay</source>
        <translation>重播速度</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>What is shown here was recorded: nothing moves or heats by it.</source>
        <translation>這裡顯示的是記錄內容：不會使任何東西移動或加熱。</translation>
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
        <translation>復原(&amp;U)</translation>
    </message>
    <message>
        <source>A run is armed or on. This can be changed once it has stopped.</source>
        <translation>已待命或正在運轉。停止後即可更改此項。</translation>
    </message>
    <message>
        <source>Nothing to redo</source>
        <translation>沒有可重做的操作</translation>
    </message>
    <message>
        <source>Nothing to undo</source>
        <translation>沒有可復原的操作</translation>
    </message>
    <message>
        <source>Raise a limit of the real rig</source>
        <translation>提高實際實驗台的限值</translation>
    </message>
    <message>
        <source>Raise the limit</source>
        <translation>提高限值</translation>
    </message>
    <message>
        <source>This allows the rig more than now. Do robot, source, objects and sensors bear it?</source>
        <translation>這將允許實驗台超出現在的範圍。機器人、熱源、物體和感測器能承受嗎？</translation>
    </message>
</context>
<context>
    <name>bask::UnitFinder</name>
    <message>
        <source>Unit %1: %2 (%3)</source>
        <translation>單元 %1：%2（%3）</translation>
    </message>
    <message>
        <source>Unit %1 answers, but no profile of this role fits</source>
        <translation>單元 %1 有回應，但沒有適合此角色的設定檔</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Find devices</source>
        <translation>尋找裝置</translation>
    </message>
    <message>
        <source>Asks units 1 to 16 at this port. Nothing is written.</source>
        <translation>在此連接埠詢問單元 1 到 16。不寫入任何內容。</translation>
    </message>
    <message>
        <source>%1 %, unit %2, %3</source>
        <translation>%1 %，單元 %2，%3</translation>
    </message>
    <message>
        <source>No unit from 1 to 16 answers.</source>
        <translation>單元 1 到 16 均無回應。</translation>
    </message>
    <message>
        <source>Choose one:</source>
        <translation>請選擇一項：</translation>
    </message>
    <message>
        <source>Devices found at this port</source>
        <translation>在此連接埠找到的裝置</translation>
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
        <translation>太熱</translation>
    </message>
    <message>
        <source>Too cold</source>
        <translation>太冷</translation>
    </message>
    <message>
        <source>Reachable</source>
        <translation>可達</translation>
    </message>
    <message>
        <source>needs F = %1, at most %2 here; at most %3</source>
        <translation>需要 F = %1，此處最多 %2；最多 %3</translation>
    </message>
    <message>
        <source>below the room&apos;s %1</source>
        <translation>低於室溫 %1</translation>
    </message>
    <message>
        <source>below the %1 it settles at far from the source</source>
        <translation>低於其遠離熱源時穩定的 %1</translation>
    </message>
    <message>
        <source>needs F = %1, at least %2 here; at least %3</source>
        <translation>需要 F = %1，此處至少 %2；至少 %3</translation>
    </message>
    <message>
        <source>needs F = %1, up to %2 here</source>
        <translation>需要 F = %1，此處可達 %2</translation>
    </message>
    <message>
        <source>clearance</source>
        <translation>間距</translation>
    </message>
    <message>
        <source>workspace %1</source>
        <translation>工作空間 %1</translation>
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
        <translation>第 %1 列</translation>
    </message>
    <message>
        <source>at %1</source>
        <comment>a time since Start</comment>
        <translation>在 %1</translation>
    </message>
    <message>
        <source>Altered: in tags, or in bytes of the file that are in no row. An older Bask that changed the tags does that, too.</source>
        <translation>已改動：在標籤中，或在檔案中不屬於任何列的位元組中。較舊的 Bask 更改標籤時也會如此。</translation>
    </message>
    <message>
        <source>Altered: %1; see bask verify</source>
        <translation>已改動：%1；詳見 bask verify</translation>
    </message>
    <message>
        <source>Altered: %1, and %2 more; see bask verify</source>
        <translation>已改動：%1，另有 %2 處；詳見 bask verify</translation>
    </message>
    <message>
        <source>Damaged: bask verify tells what of it can be read</source>
        <translation>已損壞：bask verify 說明其中可以讀取的內容</translation>
    </message>
    <message>
        <source>Not verifiable: recorded by an older Bask, without a hash chain</source>
        <translation>無法驗證：由較舊的 Bask 記錄，沒有雜湊鏈</translation>
    </message>
    <message>
        <source>Intact: %1 rows, sealed, head %2</source>
        <translation>完好：%1 列，已封存，鏈頭 %2</translation>
    </message>
    <message>
        <source>Intact: %1 rows, not sealed, head %2</source>
        <translation>完好：%1 列，未封存，鏈頭 %2</translation>
    </message>
    <message>
        <source>key %1</source>
        <translation>鍵 %1</translation>
    </message>
    <message>
        <source>view %1</source>
        <translation>檢視 %1</translation>
    </message>
    <message>
        <source>index %1</source>
        <comment>of a database</comment>
        <translation>索引 %1</translation>
    </message>
    <message>
        <source>trigger %1</source>
        <comment>of a database</comment>
        <translation>觸發程序 %1</translation>
    </message>
    <message>
        <source>the file&apos;s header</source>
        <translation>檔案標頭</translation>
    </message>
    <message>
        <source>after %1</source>
        <comment>a time since Start</comment>
        <translation>在 %1 之後</translation>
    </message>
    <message>
        <source>Altered: its seal was removed. Tags, and bytes of the file that are in no row, may have been changed.</source>
        <translation>已改動：封印已被移除。標籤以及檔案中不屬於任何列的位元組可能已被更改。</translation>
    </message>
</context>
<context>
    <name>bask::ViewBar</name>
    <message>
        <source>Top</source>
        <translation>俯視</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>側視</translation>
    </message>
    <message>
        <source>Isometric</source>
        <translation>等角</translation>
    </message>
    <message>
        <source>View: %1</source>
        <translation>視角：%1</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>匯出</translation>
    </message>
    <message>
        <source>&amp;Picture…</source>
        <translation>圖片(&amp;P)…</translation>
    </message>
    <message>
        <source>&amp;Animation…</source>
        <translation>動畫(&amp;A)…</translation>
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
        <translation>%1，離群</translation>
    </message>
    <message>
        <source>A view that is not ticked is left out.</source>
        <translation>未勾選的視圖不參與校正。</translation>
    </message>
    <message>
        <source>Residual</source>
        <translation>殘差</translation>
    </message>
    <message>
        <source>View</source>
        <translation>視圖</translation>
    </message>
    <message>
        <source>Views of the calibration</source>
        <translation>校正視圖</translation>
    </message>
</context>
<context>
    <name>bask::WholeNumberField</name>
    <message>
        <source>“%1” is not a whole number; the value stays as it was</source>
        <translation>「%1」不是整數；數值保持不變</translation>
    </message>
</context>
<context>
    <name>bask::WhyNot</name>
    <message>
        <source>Arm is not possible: no experiment is loaded. Open one first.</source>
        <translation>無法待命：尚未載入實驗。請先開啟一個。</translation>
    </message>
    <message>
        <source>The rig is armed already. Press Start.</source>
        <translation>實驗台已在待命。請按「開始」。</translation>
    </message>
    <message>
        <source>Arm is not possible: a stop or a fault is latched. Remove its cause, then press Reset.</source>
        <translation>無法待命：有停止或故障被閂鎖。請排除其原因，然後按「復歸」。</translation>
    </message>
    <message>
        <source>Arm is not possible yet: the run is stopping.</source>
        <translation>尚無法待命：運轉正在停止。</translation>
    </message>
    <message>
        <source>Arm is not possible: the rig is not ready.</source>
        <translation>無法待命：實驗台未就緒。</translation>
    </message>
    <message>
        <source>Arm is not possible: a run is on. Stop it first.</source>
        <translation>無法待命：正在運轉。請先停止。</translation>
    </message>
    <message>
        <source>Start is not possible: a stop or a fault is latched. Press Reset, then Arm.</source>
        <translation>無法開始：有停止或故障被閂鎖。請按「復歸」，再按「待命」。</translation>
    </message>
    <message>
        <source>Start is not possible: a run is on.</source>
        <translation>無法開始：正在運轉。</translation>
    </message>
    <message>
        <source>Start is not possible: the rig is not armed. Press Arm first.</source>
        <translation>無法開始：實驗台未待命。請先按「待命」。</translation>
    </message>
    <message>
        <source>The run is held already. Resume goes on, Stop ends it.</source>
        <translation>運轉已在保持。「繼續」恢復運轉，「停止」結束運轉。</translation>
    </message>
    <message>
        <source>Hold is not possible: the run is stopping. STOP ends all motion.</source>
        <translation>無法保持：運轉正在停止。「軟體停止」終止一切運動。</translation>
    </message>
    <message>
        <source>There is nothing to hold: the robot does not move.</source>
        <translation>沒有可保持的：機器人沒有運動。</translation>
    </message>
    <message>
        <source>The run is stopping already.</source>
        <translation>運轉已在停止。</translation>
    </message>
    <message>
        <source>There is no run to stop: a stop or a fault has ended it.</source>
        <translation>沒有可停止的運轉：停止或故障已將其結束。</translation>
    </message>
    <message>
        <source>There is no run to stop.</source>
        <translation>沒有可停止的運轉。</translation>
    </message>
    <message>
        <source>The robot is retreating already.</source>
        <translation>機器人已在撤離。</translation>
    </message>
    <message>
        <source>Retreat is not possible: the robot does not answer. Take the objects away by hand, mind the heat.</source>
        <translation>無法撤離：機器人沒有回應。請手動移開物體，小心燙傷。</translation>
    </message>
    <message>
        <source>Retreat is not possible:</source>
        <translation>無法撤離：</translation>
    </message>
    <message>
        <source>Retreat is not possible: the robot is not sure of its place. Look where it is, then home it or clear its alarm on the Rig page.</source>
        <translation>無法撤離：機器人的位置不確定。請查看其位置，然後在「實驗台」頁面使其回原點或清除其警報。</translation>
    </message>
    <message>
        <source>Retreat is not possible now: there is no robot that can move, or the objects are away already.</source>
        <translation>現在無法撤離：沒有可運動的機器人，或物體已經移開。</translation>
    </message>
    <message>
        <source>There is nothing to resume: no run is held.</source>
        <translation>沒有可繼續的：沒有保持中的運轉。</translation>
    </message>
    <message>
        <source>There is nothing to reset: no stop and no fault is latched.</source>
        <translation>沒有可復歸的：沒有閂鎖的停止或故障。</translation>
    </message>
    <message>
        <source>A run is armed or on. Stop it first; then another experiment can be begun.</source>
        <translation>已待命或正在運轉。請先停止，然後才能開始另一個實驗。</translation>
    </message>
    <message>
        <source>There is no recording to end.</source>
        <translation>沒有可結束的記錄。</translation>
    </message>
    <message>
        <source>The recording is that of the run, which is armed or on. It ends with the run.</source>
        <translation>該記錄屬於已待命或正在進行的運轉，隨運轉一起結束。</translation>
    </message>
    <message>
        <source>There is no alarm to acknowledge.</source>
        <translation>沒有需要確認的警報。</translation>
    </message>
    <message>
        <source>All alarms are acknowledged already.</source>
        <translation>所有警報均已確認。</translation>
    </message>
    <message>
        <source>There is no recording to save yet. Arm begins one.</source>
        <translation>還沒有可儲存的記錄。「待命」會開始一個記錄。</translation>
    </message>
    <message>
        <source>This run has no prediction: it was not finished at Start.</source>
        <translation>此次運轉沒有預測：開始時預測尚未完成。</translation>
    </message>
    <message>
        <source>This run has no prediction: the robot&apos;s place or a reading was not known before Start.</source>
        <translation>此次運轉沒有預測：開始前機器人的位置或某個讀數未知。</translation>
    </message>
    <message>
        <source>This run has no prediction: it could not be computed.</source>
        <translation>此次運轉沒有預測：無法計算。</translation>
    </message>
    <message>
        <source>Reset waits for the source to cool by %1: it does not cool yet. Switch it off at its mains.</source>
        <translation>復歸在等待熱源降溫 %1：它尚未降溫。請切斷其電源。</translation>
    </message>
    <message>
        <source>The source cools: Reset is possible when it has fallen by %1; now %2.</source>
        <translation>熱源正在降溫：降低 %1 後方可復歸；目前為 %2。</translation>
    </message>
    <message>
        <source>Home the robot: here, or on the page Rig, By hand, where its place can be confirmed instead.</source>
        <translation>請使機器人回原點：在此處，或在「實驗台」頁的「手動」中，那裡也可改為確認其位置。</translation>
    </message>
    <message>
        <source>Then Reset, then Arm.</source>
        <translation>然後復歸，再待命。</translation>
    </message>
    <message>
        <source>Home is not possible: no experiment is loaded.</source>
        <translation>無法回原點：未載入實驗。</translation>
    </message>
    <message>
        <source>Home is not possible: a run is armed or on. Stop it first.</source>
        <translation>無法回原點：有運轉處於待命或進行中。請先停止它。</translation>
    </message>
    <message>
        <source>Home is not possible: the robot does not answer.</source>
        <translation>無法回原點：機器人沒有回應。</translation>
    </message>
    <message>
        <source>This run has no prediction: it is computed while the Run page is shown, and was not ready at Start.</source>
        <translation>此次運轉沒有預測：預測在顯示「運轉」頁時計算，開始時尚未完成。</translation>
    </message>
    <message>
        <source>Reset is possible when the robot has come to rest.</source>
        <translation>機器人靜止後才能復歸。</translation>
    </message>
</context>
<context>
    <name>bask::ZeroPanel</name>
    <message>
        <source>Offsets: %1.</source>
        <translation>零點偏移：%1。</translation>
    </message>
    <message>
        <source>That of %1 is large: check the sensor and its wiring.</source>
        <translation>%1 的零點偏移較大：請檢查感測器及其接線。</translation>
    </message>
    <message>
        <source>Not while the heat is on.</source>
        <translation>加熱開啟時不可進行。</translation>
    </message>
    <message>
        <source>Zeroed on %1 with the room at %2.</source>
        <translation>已於 %1 歸零，當時室溫 %2。</translation>
    </message>
    <message>
        <source>Not zeroed yet: Arm does it, if all objects are at the room&apos;s temperature then.</source>
        <translation>尚未歸零：若屆時所有物體都處於室溫，進入待命時會自動歸零。</translation>
    </message>
    <message>
        <source>Sensors at rest</source>
        <translation>靜止的感測器</translation>
    </message>
    <message>
        <source>Zero the sensors</source>
        <translation>將感測器歸零</translation>
    </message>
    <message>
        <source>Make all sensors agree while the objects are at the room&apos;s temperature</source>
        <translation>在物體處於室溫時，使所有感測器讀數一致</translation>
    </message>
</context>
</TS>
