// What the server of the page of a new site says, in Japanese: templates of its sentences.
import type { Templates } from "../../messages/speech";

export const JA_TOLD: Templates = {
  // what a draft lacks, and what mends it
  "the room has no size yet": "部屋の大きさがまだありません",
  "give length x width x height in metres (6x4x2.5), or a file of the room":
    "長さ×幅×高さをメートルで（6x4x2.5）、または部屋のファイルを指定してください",
  "the room has no size yet: give its length and width, or a file":
    "部屋の大きさがまだありません。長さと幅、またはファイルを指定してください",
  "x_min must be below x_max, and y_min below y_max [m]":
    "x_minはx_maxより、y_minはy_maxより小さくしてください [m]",
  "correct that value": "この値を直してください",
  "the ceiling ({a} m) is less than 0.4 m above the flight height ({b} m)":
    "天井（{a} m）が飛行の高さ（{b} m）より0.4 m以上高くありません",
  "correct the height of the room, or lower flight_height": "部屋の高さを直すか、flight_heightを下げてください",
  "the room has no walls": "部屋に壁がありません",
  "draw them, or give the size again: a rectangle brings its four walls":
    "壁を描くか、大きさを入力し直してください。長方形には4枚の壁が付きます",
  "the drone fits nowhere in this room": "この部屋にはドローンが入る場所がありません",
  "the drone fits nowhere in this room: is there a free floor?": "この部屋にはドローンが入る場所がありません。空いた床はありますか",
  "check the unit of the file or the size: are they metres? Or take furniture and zones out":
    "ファイルの単位か大きさを確かめてください（メートルですか）。または家具や区域を減らしてください",
  "it is not said where the pad lies, on which the drone starts and lands": "離着陸するパッドの位置が決まっていません",
  "say where: ({x}, {y}) m is roomy": "位置を決めてください。({x}, {y}) m は広く空いています",
  "move the pad: ({x}, {y}) m is roomy": "パッドを動かしてください。({x}, {y}) m は広く空いています",
  "the drone cannot start at ({x}, {y}) m: {why}": "({x}, {y}) m からは離陸できません。{why}",
  "the drone cannot hover at {place}, ({x}, {y}) m: {why}":
    "{place} ({x}, {y}) m ではホバリングできません。{why}",
  "no way leads there from home": "ホームからそこへの道がありません",
  "the site file keeps it free by order": "サイトのファイルで飛行禁止です",
  "it is behind a wall or inside something": "壁の向こうか、何かの中です",
  "the nearest obstacle is {a} m away and the drone keeps {b} m": "最も近い障害物まで {a} m、必要な距離は {b} m です",
  ["something stands on the floor {a} m from the middle of the pad, and the drone " +
      "starts with {b} m and more around it"]:
    "パッドの中心から {a} m の床に物があります。離陸には周囲 {b} m 以上が必要です",
  "there is no place to fly to": "飛んでいく場所がありません",
  "name one and say where it is": "名前と位置を決めてください",
  "two places are called {place}": "{place} という場所が2つあります",
  "rename one": "片方の名前を変えてください",
  "move it, or leave it out": "動かすか、外してください",
  "the zone {name} covers the pad": "区域 {name} がパッドを覆っています",
  "keep it {a} m away from ({x}, {y}) m": "({x}, {y}) m から {a} m 離してください",
  "it is not said which motion capture system sees the drone": "ドローンを計測するシステムが決まっていません",
  "say its kind and address, such as: vicon 10.0.0.5": "種類とアドレスを入力してください（例：vicon 10.0.0.5）",
  "nobody compared the tracking frame with the map yet": "計測の座標系と地図はまだ照合されていません",
  "take three points here, or carry the drone: housefly preflight --frames --site SITE":
    "ここで3点を取るか、ドローンを持って歩いてください：housefly preflight --frames --site SITE",
  "take the points again": "点を取り直してください",
  "it is not said where the drone answers": "ドローンのアドレスが決まっていません",
  "say its model and its address, such as: tello 192.168.10.1":
    "機種とアドレスを入力してください。例：tello 192.168.10.1",
  "the drone flies with the constants of a usual {name}": "一般的な{name}の定数で飛びます",
  "measure yours: housefly identify (docs/identify-and-gains.md)":
    "ご自分の機体を測ってください：housefly identify (docs/identify-and-gains.md)",
  // the points of the tracking frame
  "the tracking frame has its origin at ({x}, {y}, {z}) m on the map, turned by {a} deg":
    "計測の座標系の原点は地図上の ({x}, {y}, {z}) m、回転 {a}°です",
  ["the points fit as in a mirror: two were exchanged, or the tracking system counts " +
      "one axis the other way; take them again in the right order, or choose z up, " +
      "right-handed, in its software"]:
    "点が鏡像になっています。2点が入れ替わったか、計測の軸が1つ逆です。正しい順で取り直すか、計測ソフトでz上向きの右手系を選んでください",
  ["tracking sees a metre as {a} m: measure the points again; if it comes again, " +
      "calibrate the cameras or set metres in the tracking software"]:
    "計測では1 mが {a} m に見えます。点を測り直してください。それでも同じなら、カメラを校正するか、計測ソフトの単位をメートルにしてください",
  ["the points do not agree to {n} cm, {name} worst: put the drone there again and " +
      "measure, or measure its place on the map again"]:
    "点が {n} cm 以内で一致しません（最大は{name}）。ドローンを置き直して測るか、地図上の位置を測り直してください",
  ["the points lie on one line: an axis that is counted the other way would not show; " +
      "take one more beside it"]:
    "点が一直線上にあり、逆向きの軸を見つけられません。線の横にもう1点取ってください",
  "two points cannot check each other: take a third": "2点では互いに確かめられません。3点目を取ってください",
  "two points are needed, and a third to check them": "2点と、確認用の3点目が必要です",
  // what was done, and what was not
  "a room of {a} x {b} m, {c} m high": "{a} x {b} m、高さ {c} m の部屋を作りました",
  "read {name}": "{name} を読み込みました",
  "erased": "消しました",
  "a roomy spot": "広い位置を選びました",
  "roomy spots": "広い位置をいくつか選びました",
  "undone": "元に戻しました",
  "done again": "やり直しました",
  "there is nothing more to go back to": "これ以上は戻れません",
  "no further roomy spot can be reached from the pad": "パッドから行ける広い位置はもうありません",
  ["the draft was changed elsewhere, in another tab or in a terminal: this is how it is " +
      "now; make your last change again"]:
    "下書きは別のタブか端末で変更されました。今の内容を表示しています。最後の変更をやり直してください",
  "no contact with `housefly new`: does it still run? What you do now is not kept":
    "housefly new と通信できません。まだ動いていますか。今の操作は保存されません",
  "say first which system it is, and where it answers": "先にシステムの種類とアドレスを入力してください",
  "say first where the drone answers": "先にドローンのアドレスを入力してください",
  "this browser has no session": "このブラウザーにはセッションがありません",
  "this page may not change the site": "このページはサイトを変更できません",
  "too much; allowed: {n} MiB": "大きすぎます。{n} MiBまでです",
  "the browser left before the whole file was here": "ファイルが届き終わる前にブラウザーが離れました",
  "the file cannot be kept: {why}": "ファイルを保存できません：{why}",
  "nothing was kept: {why}": "何も保存されませんでした：{why}",
  "{name} did not arrive: choose the file again": "{name} が届きませんでした。もう一度選んでください",
  "{n} files are here already: start the page again": "すでにファイルが{n}個あります。housefly newを起動し直してください",
  "{name} is larger than {n} MiB: thin the scan out first, 5 cm between its points are enough":
    "{name} は {n} MiB を超えています。先にスキャンの点を間引いてください。間隔は5 cmで十分です",
  ["the file is called {name}; allowed: up to 100 letters, digits, spaces and . _ - + ( " +
      "), a letter or digit first"]:
    "ファイル名が {name} です。使えるのは100文字までの文字、数字、空白、. _ - + ( ) で、先頭は文字か数字です",
  // a value that is not allowed
  "is not a known key": "は知られていない項目です",
  "is missing": "がありません",
  "is {name}; {words}": "{name}です。{words}",
  "input should be less than or equal to {n}": "{n}以下にしてください",
  "input should be greater than or equal to {n}": "{n}以上にしてください",
  "input should be greater than {n}": "{n}より大きくしてください",
  "input should be less than {n}": "{n}より小さくしてください",
  "input should be a valid number": "数を入力してください",
  "input should be a valid number, unable to parse string as a number": "数を入力してください",
  "unexpected keyword argument": "知られていない項目です",
  "map.flight_height ({a} m) must lie in limits.height_min..height_max ({b} .. {c} m)":
    "map.flight_height（{a} m）は limits.height_min..height_max（{b} .. {c} m）の間にしてください",
  "input should be a finite number": "有限の数を入力してください",
  "input should be a valid integer, got a number with a fractional part": "整数を入力してください",
  "string should have at least 1 character": "1文字以上入力してください",
  "string should have at most {n} characters": "{n}文字までです",
  // what a tracking system and a drone say
  "heard nothing: {why}": "何も受信できません：{why}",
  "{name} sends {n} frames a second": "{name} は毎秒{n}フレームを送っています",
  "{name} at ({x}, {y}, {z}) m, heading {a} deg, in {n} % of the frames":
    "{name}：({x}, {y}, {z}) m、向き {a}°、フレームの{n} %",
  "but: {why}": "ただし：{why}",
  ["the drone's body {name} is not among them (seen: {names}): uncover its markers, " +
      "or say its name as the tracking software has it"]:
    "ドローン {name} が見つかりません（見えているもの：{names}）。マーカーを隠さないようにするか、計測ソフトでの名前を入力してください",
  "none": "なし",
  "fewer than 20 frames a second: fly slowly, or raise the rate": "毎秒20フレーム未満です。ゆっくり飛ぶか、頻度を上げてください",
  "not reached: {why}": "つながりません：{why}",
  "no report came from {name}": "{name} から報告がありません",
  "unknown": "不明",
  "landed": "着陸済み",
  "taking off": "離陸中",
  "flying": "飛行中",
  "landing": "着陸中",
  "emergency": "非常停止",
  // what a file holds, and why it cannot be read
  "the drone fits nowhere: is the unit of the file right?": "ドローンが入る場所がありません。ファイルの単位は正しいですか",
  ["{name}: {a} m x {b} m, {n} boxes; a ROS map is flat, so its walls reach from the " +
      "floor to the ceiling"]:
    "{name}：{a} m x {b} m、箱{n}個。ROSの地図は平面なので、壁は床から天井までとします",
  "the room begins at (0, 0), which the ROS map calls ({x}, {y}) m":
    "部屋の始点は (0, 0) で、ROSの地図では ({x}, {y}) m です",
  "the room begins at (0, 0), which the scan calls ({x}, {y}) m":
    "部屋の始点は (0, 0) で、スキャンでは ({x}, {y}) m です",
  "walls are taken from the layers {name}": "壁はレイヤー {name} から取りました",
  "every line is taken for a wall: no layer is called so": "壁という名のレイヤーがないため、すべての線を壁とします",
  "one unit is {a} m, as you said": "指定どおり、1単位は {a} m です",
  "its numbers ({thing}) were taken for {words}": "数値 ({thing}) は{words}とみなしました",
  "metres": "メートル",
  "centimetres": "センチメートル",
  "millimetres": "ミリメートル",
  "inches": "インチ",
  ["its outer walls do not close, so nothing says what is outside: look at the map, and " +
      "draw walls where they are missing"]:
    "外壁が閉じておらず、どこが外か分かりません。地図を見て、足りない壁を描いてください",
  "what is outside of its walls is not flown in": "壁の外は飛びません",
  ["{name}: {a} m x {b} m, {n} lines became walls up to the ceiling (doors and windows " +
      "too, where they are drawn on the same layer)"]:
    "{name}：{a} m x {b} m、線{n}本を天井までの壁にしました（同じレイヤーにあればドアと窓も）",
  "{name} points up, as you said": "指定どおり、{name}が上向きです",
  "{name} was taken to point up": "{name}を上向きとみなしました",
  "{name} holds no lines: are its walls drawn as lines or shapes, not as a picture?":
    "{name} に線がありません。壁は画像でなく線や図形で描かれていますか",
  "{name} has {n} lines, at most {m} are read: say which layers hold the walls; it has: {thing}":
    "{name} には線が{n}本あり、読めるのは{m}本までです。壁のレイヤーを指定してください。レイヤー：{thing}",
  "no layer's name holds {name}; there are: {thing}": "{name} を含むレイヤーがありません。あるのは：{thing}",
  "{name} is {a} m x {b} m with unit={c}; allowed: {d} to {e} m: say another unit":
    "{name} は単位 {c} では {a} m x {b} m です。{d} から {e} m になるよう、別の単位を指定してください",
  ["{name} measures {thing}: no room in any usual unit; say how many metres one unit is " +
      "(0.001 for millimetres), and which axis points up"]:
    "{name} の大きさ {thing} は、どの標準の単位でも部屋になりません。1単位が何メートルか（ミリメートルなら0.001）と、上向きの軸を指定してください",
  "{name} has {n} points; at least {m} are needed, better one on each 2 cm of wall and floor":
    "{name} は{n}点です。少なくとも{m}点、できれば壁と床の2 cmごとに1点必要です",
  ["{name} holds {n} points, at most {m} are read: thin the scan out, 2 cm between " +
      "points are enough"]:
    "{name} は{n}点あり、読めるのは{m}点までです。点を間引いてください。間隔は2 cmで十分です",
  "{name} has more than {n} MB; thin the scan out, 2 cm between points are enough":
    "{name} は {n} MB を超えています。点を間引いてください。間隔は2 cmで十分です",
  "{name} holds neither points nor surfaces": "{name} に点も面もありません",
  "{name} covers {a} m^2; cut out the part to fly in": "{name} は {a} m²あります。飛ぶ部分を切り出してください",
  ["{n} boxes and more are needed, at most {m} are supported: cut out the part to fly " +
      "in, and clean it of single points"]:
    "箱が{n}個以上必要で、上限は{m}個です。飛ぶ部分を切り出し、孤立した点を除いてください",
  "{name} cannot be read as SVG: {why}": "{name} をSVGとして読めません：{why}",
  "{name} cannot be read as DXF: {why}": "{name} をDXFとして読めません：{why}",
  "{name} cannot be read: {why}": "{name} を読めません：{why}",
  "{name}: no room is read from such a file; allowed: {thing}":
    "{name}：この種類のファイルからは部屋を読めません。使えるのは：{thing}",
  "{name} is no file; check its name": "{name} というファイルはありません。名前を確かめてください",
  ["{a} % of its {b} m^2 were never seen: unexplored, not flown over " +
      "(unexplored=free changes that)"]:
    "{b} m² のうち {a} % は見えていません。未知とし、その上は飛びません（上の項目で変えられます）",
  "unexplored floor counts as free, as you said": "指定どおり、未知の床は空いているとみなします",
  "the drone fits nowhere: {a} % of the floor were never seen":
    "ドローンが入る場所がありません。床の {a} % が見えていません",
  "{name} has the text {thing}, read as the number {n}": "{name} が文字列 {thing} なので、数 {n} として読みました",
  "image is {thing}, which is not there: {name} beside the yaml was read":
    "image の {thing} がないため、yamlと同じ場所の {name} を読みました",
  ["grey 205 counts as never seen, although free_thresh ({a}) calls it free: " +
      "map_saver writes it for that"]:
    "灰色205は、free_thresh（{a}）では空きですが、見えていない所とします。map_saverがそう書きます",
  ["every line is taken for a wall: no layer is called so; say layers= if only " +
      "some hold them: {name}"]:
    "壁という名のレイヤーがないため、すべての線を壁とします。一部だけが壁なら、レイヤーを指定してください：{name}",
  "{name} and {n} more": "{name} ほか{n}",
  ["its numbers ({a} x {b}) are {words}, a room of {c} m x {d} m: measure one " +
      "wall, and say the unit if it is not so long"]:
    "数値 ({a} x {b}) は{words}とみなし、{c} m x {d} m の部屋です。壁を1枚測り、長さが違えば単位を指定してください",
  ["its numbers ({a} x {b}) cannot be {words}, and were {then}, a room of {c} m x " +
      "{d} m: measure one wall, and say the unit if it is not so long"]:
    "数値 ({a} x {b}) は「{words}」ではありえないため、{then}とみなし、{c} m x {d} m の部屋です。壁を1枚測り、長さが違えば単位を指定してください",
  "inches, as the file writes its lengths": "ファイルの書き方によればインチ",
  "{c} m each, as the file says": "ファイルによれば1単位 {c} m",
  "taken for {words}": "{words}",
  "drawn at 1:{n}": "縮尺1:{n}の図",
  "feet": "フィート",
  "its numbers ({thing}) are {a} m each, as the file says": "数値 ({thing}) は、ファイルによれば1単位 {a} m です",
  "left out: {n} of {m} points ({words})": "読まなかった点：{m}点中{n}点（{words}）",
  "left out: {n} points that it calls noise": "読まなかった点：雑音とされた{n}点",
  "left out: {n} parts that are neither points nor surfaces": "点でも面でもない{n}個の部分は読みませんでした",
  "no lines or shapes": "線や図形でない",
  "hidden, or on a layer that is frozen or off": "非表示、またはフリーズ・オフのレイヤー",
  "cannot be read": "読めない",
  "on layers without walls": "壁のないレイヤー",
  "2 cm and smaller": "2 cm以下",
  "far away from all the rest": "ほかから遠く離れている",
  "no numbers": "数でない",
  "the file is damaged; faults in it that were mended or left out: {n}":
    "ファイルが壊れています。直したか除いた箇所：{n}",
  "the file ends in the middle: it was cut off": "ファイルが途中で切れています",
  "the file ends in the middle: {n} points are missing": "ファイルが途中で切れていて、{n}点足りません",
  "its points are about {a} cm apart: cells of {b} cm": "点の間隔は約 {a} cm です。{b} cm のマスで読みました",
  ["{name} has points more than {a} cm apart, too few to tell walls from gaps: " +
      "export it denser, 2 cm between points are best, or as a mesh; or is its unit " +
      "another one?"]:
    "{name} の点の間隔は {a} cm を超え、壁と隙間を区別できません。もっと密に（できれば2 cmごとに）、または面として書き出してください。単位が違うかもしれません",
  "{name} points up, as the format has it": "形式のとおり、{name}が上向きです",
  "{name} measures {thing}: all its points lie on one line or plane":
    "{name} の大きさは {thing} で、すべての点が一直線か一平面にあります",
  "{name} stores its surfaces by {thing}, which is not read: export it without compression":
    "{name} は {thing} で面を保存していて、読めません。圧縮せずに書き出してください",
  ["{name} stores its surfaces by {thing}, which is not read: export it without " +
      "compression, or pip install DracoPy"]:
    "{name} は {thing} で面を保存していて、読めません。圧縮せずに書き出すか、pip install DracoPy としてください",
  ["{name} stores its surfaces by {thing}, which is not read: export it without " +
      "compression or quantization"]:
    "{name} は {thing} で面を保存していて、読めません。圧縮も量子化もせずに書き出してください",
  "{name} needs {thing}, which is not beside it: choose both files, or export it as one .glb":
    "{name} には {thing} も必要です。両方を選ぶか、1つの .glb に書き出してください",
  "{name} holds no points, or none that is finite": "{name} に点がないか、有限な点がありません",
  "{name} has points without three coordinates each": "{name} に座標が3つでない点があります",
  "{name} ends in the middle: {a} of {b} bytes are there": "{name} は途中で切れています（{b} バイト中 {a} バイト）",
  "{name} is damaged: its points are not as long as it says": "{name} は壊れています。点の長さが書かれた値と違います",
  "{name} has no good header of a PCD: {why}": "{name} のPCDヘッダーが正しくありません：{why}",
  "{name} has no field {thing}; it has: {place}": "{name} に項目 {thing} がありません。あるのは：{place}",
  "{name} has more than {n} numbers a point": "{name} は1点に{n}個を超える数があります",
  "{name} defines entities; save it as plain SVG": "{name} は実体を定義しています。プレーンSVGで保存してください",
  "{name}: no room is read from such a file; {words}; allowed: {thing}":
    "{name}：この種類のファイルからは部屋を読めません。{words}。使えるのは：{thing}",
  "give the map's yaml file, which names the picture": "画像ではなく、それを指す地図のyamlを選んでください",
  "export the plan as .svg or .dxf": "平面図を .svg か .dxf に書き出してください",
  "export the walls as .dxf": "壁を .dxf に書き出してください",
  "export the scan as .glb or .ply": "スキャンを .glb か .ply に書き出してください",
  "export the scan as .ply or .e57": "スキャンを .ply か .e57 に書き出してください",
  "the floor was taken at {a} m in it": "床はその中の高さ {a} m としました",
  // files of ROS maps, plans and scans, and values of them
  "0 or 1": "0か1",
  "a list x, y, yaw of three numbers [m, m, rad]": "3つの数 x, y, yaw のリスト [m, m, rad]",
  "a number from {a} to {b}": "{a}から{b}までの数",
  "a number from {a} to {b} {unit}": "{a}から{b} {unit}までの数",
  "a rectangle is x_min, y_min, x_max, y_max [m] with x_min < x_max and y_min < y_max":
    "長方形は x_min, y_min, x_max, y_max [m] で、x_min < x_max、y_min < y_max にしてください",
  "as tracking sees them": "計測された",
  "blocks are nested deeper than {n} levels": "ブロックの入れ子が{n}段を超えています",
  "ceiling {c} m": "天井 {c} m",
  "ceiling {c} m (not in the scan: as usual)": "天井 {c} m（スキャンになく、標準の値）",
  "groups are nested deeper than {n} levels": "グループの入れ子が{n}段を超えています",
  "input should be a valid boolean": "真か偽にしてください",
  "input should be a valid integer": "整数を入力してください",
  "input should be a valid integer, unable to parse string as an integer": "整数を入力してください",
  "input should be a valid string": "文字列を入力してください",
  "input should be a valid tuple": "リストにしてください",
  "input should be {names}": "使えるのは：{names}",
  "is not a known key: did you mean {names}?": "は知られていない項目です。{names} のことですか",
  "is the text {thing}": "が文字列 {thing} です",
  "is {a}; allowed: {b} to {c} metres per unit of the file": "{a}です。ファイルの1単位は{b}から{c}メートルまでです",
  "is {name}; allowed: a number from {a} to {b}": "{name}です。{a}から{b}までの数にしてください",
  "is {name}; allowed: a number from {a} to {b} {unit}": "{name}です。{a}から{b} {unit}までの数にしてください",
  "is {thing}": "が {thing} です",
  "its numbers ({a} x {b}) are {words}: measure one wall, and say the unit if it is not so long":
    "数値 ({a} x {b}) は{words}です。壁を1枚測り、長さが違えば単位を指定してください",
  "its reader stops with {name}": "読み取りが {name} で止まりました",
  "left out: {names} ({words})": "読まなかったもの：{names}（{words}）",
  "left over: {names}": "残りのずれ：{names}",
  "m per pixel": "m／画素",
  "missing required argument": "がありません",
  "more than {n} blocks are inserted; leave out what is no wall":
    "挿入されたブロックが{n}個を超えています。壁でないものを除いてください",
  "more than {n} elements; leave out what is no wall": "要素が{n}個を超えています。壁でないものを除いてください",
  "more than {n} shapes; leave out what is no wall": "図形が{n}個を超えています。壁でないものを除いてください",
  "on the map": "地図上の",
  "rect as large as the page": "ページと同じ大きさのrect",
  "string should have at least {n} characters": "{n}文字以上入力してください",
  "string should match pattern '{name}'": "形は '{name}' に合わせてください",
  "the floor": "床",
  "the map's picture {name} cannot be read: {why}; allowed: pgm or png":
    "地図の画像 {name} を読めません：{why}。使えるのはpgmかpngです",
  "the name of a pgm or png file beside the yaml": "yamlと同じ場所にあるpgmかpngのファイル名",
  ["the points are within {a} m of each other {what}; take points that are {b} m and " +
      "more apart, better several metres"]:
    "{what}点が {a} m 以内にあります。{b} m 以上、できれば数メートル離れた点を取ってください",
  "the reader of scans ({name})": "スキャンを読む部品（{name}）",
  "the reader of {kind} ({name})": "{kind}を読む部品（{name}）",
  "{a} x {b} x {c}": "{a} x {b} x {c}",
  "{kind} of {name}, which is not in it": "中にない{name}の{kind}",
  "{kind} should have at most {n} items after validation, not {m}": "{n}個までです。{m}個あります（{kind}）",
  "{names} (save the map again)": "{names}（地図を保存し直してください）",
  "{name} answers {n} times a second: {words}, battery {p} %, firmware {firmware}":
    "{name} は毎秒{n}回応答：{words}、バッテリー {p} %、ファームウェア {firmware}",
  "{name} cannot be kept as .old: {why}": "{name} を .old として残せません：{why}",
  "{name} cannot be read as a scan: {why}; is the file whole?":
    "{name} をスキャンとして読めません：{why}。ファイルは完全ですか",
  "{name} cannot be read: its reader broke; is the file whole?":
    "{name} を読めません。読み取りが異常終了しました。ファイルは完全ですか",
  "{name} cannot be read: {why}; give the map's yaml file": "{name} を読めません：{why}。地図のyamlを選んでください",
  "{name} cannot be read: {why}; mend it or move it away": "{name} を読めません：{why}。直すか、別の場所に移してください",
  "{name} cannot be written: {why}": "{name} に書き込めません：{why}",
  "{name} has decimals for pixels; save it as png or pgm with 8 bits each":
    "{name} の画素が小数です。8ビットのpngかpgmで保存してください",
  "{name} has more than 16 bits a pixel; save it as png or pgm with 8":
    "{name} の画素が16ビットを超えています。8ビットのpngかpgmで保存してください",
  "{name} has no good header of a LAS; is the file whole?": "{name} のLASヘッダーが正しくありません。ファイルは完全ですか",
  "{name} has no good header of an E57; is the file whole?": "{name} のE57ヘッダーが正しくありません。ファイルは完全ですか",
  "{name} is farther away than any room is long: {ask}": "{name} の位置が部屋より遠すぎます。{ask}",
  "{name} is no map's yaml: allowed are {n} characters, and {m} brackets":
    "{name} は地図のyamlではありません。{n}文字、括弧{m}個までです",
  "{name} is not a map's yaml file: it has no keys image, resolution, origin":
    "{name} は地図のyamlではありません。image、resolution、originがありません",
  "{name} is not a yaml file: {why}": "{name} はyamlファイルではありません：{why}",
  "{name} is {a} m by {b} m; allowed: up to {c} m along each side":
    "{name}は {a} m x {b} m です。各辺 {c} m までです",
  "{name} is {n} x {m} pixels; at most {p} a side can be imported":
    "{name} は {n} x {m} 画素です。読めるのは各辺{p}までです",
  "{name} measures {a} x {b}: no room in any usual unit; say how many metres one unit is":
    "{name} の大きさ {a} x {b} は、どの標準の単位でも部屋になりません。1単位が何メートルか指定してください",
  "{name} {n} cm": "{name} {n} cm",
  "{name}: free_thresh ({a}) must be below occupied_thresh ({b})":
    "{name}：free_thresh（{a}）は occupied_thresh（{b}）より小さくしてください",
  "{name}: origin has yaw {a} rad; only 0 can be imported: turn the picture and set yaw to 0":
    "{name}：origin の yaw が {a} rad です。読めるのは0だけです。画像を回し、yaw を0にしてください",
  "{name}: the map covers more than {a} m^2; cut out the part to fly in":
    "{name}：地図が {a} m² を超えています。飛ぶ部分を切り出してください",
  "{name}: the map has no free pixel; check negate (0 or 1) and free_thresh":
    "{name}：地図に空いた画素がありません。negate（0か1）と free_thresh を確かめてください",
  "{name}: {a} m x {b} m, {n} boxes from {m} points; {ceiling}":
    "{name}：{a} m x {b} m、{m}点から箱{n}個。{ceiling}",
  "{name}: {key} {found}; allowed: {words}": "{name}：{key} {found}。使えるのは：{words}",
  "{n} more": "ほか{n}個",
  "{n} {name}": "{name} {n}個",
  "{part} is missing; install it with: {name}": "{part} がありません。次で入れられます：{name}",
  "{words} {unit}": "{words} {unit}",
  // what tracking and drone say of themselves, as on the console
  "connected to {name}, but it is silent": "{name}に接続しましたが、応答がありません",
  "connected to {name}, but nothing new arrives; is {what} live, not paused?":
    "{name}に接続しましたが、新しい値が届きません。{what}は動作中ですか、一時停止していませんか",
  "found in the air by a new driver: it only hovers and lands": "新しいドライバーが飛行中に見つけました。停止飛行と着陸だけをします",
  "frames arrive from {name}, but their time stands still; is {what} paused?":
    "{name}から届く値の時刻が止まっています。{what}は一時停止中ですか",
  "frames do not come from {name}; set tracking.address to {other}":
    "データは{name}から届いていません。tracking.addressを{other}にしてください",
  "is its unit millimetres? choose metres in the tracking software":
    "単位がミリメートルではありませんか。計測ソフトでメートルを選んでください",
  ["no drone answers at {name} within {n} s: is it switched on, and is your computer " +
      "in the drone's Wi-Fi?"]:
    "{name}で{n}秒以内にドローンが応答しません。電源は入っていますか、ドローンのWi-Fiに接続していますか",
  "nobody answers at {name}; is {what} running, and does it stream?":
    "{name}で応答がありません。{what}は動作中で、送信していますか",
  "not connected to {name} yet": "{name}にまだ接続していません",
  "nothing came from {name}": "{name}から何も届きません",
  "poses are refused, {pose}: {ask}": "位置を受け付けません。{pose}：{ask}",
  "the connection to {name} was lost": "{name}との接続が切れました",
  "the drone has not confirmed its limits yet": "ドローンが制限値をまだ確認していません",
  "the drone keeps {setting} = {kept} instead of {wanted}":
    "ドローンの{setting}が{wanted}ではなく{kept}のままです",
  "the room's process does not answer (its log: room.log)": "部屋のプロセスが応答しません（記録：room.log）",
  "what answers at {name} does not speak {protocol} ({error})":
    "{name}の応答は{protocol}ではありません（{error}）",
  "{name} sends more than {n} frames a second; the rest is dropped":
    "{name}は毎秒{n}件を超えて送信しています。残りは捨てます",
  "{name} streams with y up; choose z up in the tracking software":
    "{name}はy軸が上です。計測ソフトでz軸を上にしてください",
  "{name}: reading failed ({error})": "{name}：読み取れません（{error}）",
  "{why}, {more}": "{why}、{more}",
  "{why}: {more}": "{why}：{more}",
  "{why}; {more}": "{why}。{more}",
  "the simulated room": "シミュレーションの部屋",
  "{p} % of the free floor cannot be reached from the pad":
    "床の空いた所の{p}%へはパッドから行けません",
  "write the site first": "先に設置場所を書き出してください",
  "clear a way, or leave it so": "道を空けるか、そのままで",
};
