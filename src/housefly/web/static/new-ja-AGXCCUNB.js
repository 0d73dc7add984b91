var t=["000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000","0183100173c7014464g020033d990020005201c02177x13110008207101c44256049090a115011011g42060043720714412922090402706323392100013444h13e1114h2887b4b2f157a31kc102c71038c9153602102022732112864024a010103032072a52b03c1520765109320h8aa5024d00491a483b481a041241b7420707c4ae077320832425943214","87p67zm373b0a4fmf8rfg7vyh1fjwfxpm62n6tactsa4sme3msub3rzxnbtmdvwlghsvnrpo8smbwykkbu1r6mm7samdi27a3l4s62v5tacwgwkxx11yw976n2whu3io4ggfuxo9nuvaizv6r9b7c8y0jot4wyf5m3smt1reznlbqg9gcb2pzv6i65fxp43osg5dz0eweiw8a6flwgm7pssm7p64u6ez22ma94bnbvz3hnoh6pjmag450elxnvv6u8pedahd7lkyegyuf6qil4j","9d0sr8g5e1tniwazi2yupk2bp4j5lmfu5nhdw5izbqd5sr2gs4hjn0xhf3i4a58gu10u6wurnmot3rjkae6ifi1xdmn7uaelmsl6anpaf698cg5dzjwpwf8bpm7ty4vlq51d9hr6222h4sgbku0ujj7tzsm9rzmj0evur98201yyiiomu8axkeupx79ny0w1teunaoilj9lu2x4tzea971dbak3fxxcowtyauy943ka62ikm4cr0orh0iq004xm82kpddif0ztljw8881x37bph","9x258ky66ua1arlkb97nuriu51am22hc1dnfvgl1j3o4mnqbfl4jpif12hovwlyrbrkxbg2q1g7jv9k8qh4bgpwf51rm23p2xjg9di8bnw4s9k8or9yaiwjmecv32lvrkt55ohhb17195z9u0kdhyvgyjayyp4yvav2pog2ye0qjyuj6i2lasyiaj4jf1jl7k8jkgrirc0j517kt81awjgkky219hghfl7t1o4aujdcvqv0z92lspolhgqfla4rwioy560gt2gnzdu2rucp2mhn"],o=0,n=Object.fromEntries(`センチメートル
毎秒20フレーム未満です。ゆっくり飛ぶか、頻度を上げてください
壁を .dxf に書き出してください
{kind}を読む部品（{name}）
{part} がありません。次で入れられます：{name}
{name}：読み取れません（{error}）
housefly new と通信できません。まだ動いていますか。今の操作は保存されません
{a} x {b} m、高さ {c} m の部屋を作りました
着陸中
このページはサイトを変更できません
壁という名のレイヤーがないため、すべての線を壁とします
形は '{name}' に合わせてください
{name} は {thing} で面を保存していて、読めません。圧縮せずに書き出すか、pip install DracoPy としてください
{name} {n}個
下書きは別のタブか端末で変更されました。今の内容を表示しています。最後の変更をやり直してください
は知られていない項目です
点が鏡像になっています。2点が入れ替わったか、計測の軸が1つ逆です。正しい順で取り直すか、計測ソフトでz上向きの右手系を選んでください
離着陸するパッドの位置が決まっていません
数値 ({thing}) は、ファイルによれば1単位 {a} m です
{name} は毎秒{n}回応答：{words}、バッテリー {p} %、ファームウェア {firmware}
{name} は1点に{n}個を超える数があります
{words}
壁の外は飛びません
動かすか、外してください
片方の名前を変えてください
{why}、{more}
読み取りが {name} で止まりました
{name} は {a} m²あります。飛ぶ部分を切り出してください
機種とアドレスを入力してください。例：tello 192.168.10.1
点を取り直してください
yamlと同じ場所にあるpgmかpngのファイル名
{name} に座標が3つでない点があります
{name}：origin の yaw が {a} rad です。読めるのは0だけです。画像を回し、yaw を0にしてください
{name}です。{a}から{b} {unit}までの数にしてください
ドローンが入る場所がありません。ファイルの単位は正しいですか
{what}点が {a} m 以内にあります。{b} m 以上、できれば数メートル離れた点を取ってください
有限の数を入力してください
3つの数 x, y, yaw のリスト [m, m, rad]
床はその中の高さ {a} m としました
{name}：{a} m x {b} m、{m}点から箱{n}個。{ceiling}
{name}との接続が切れました
スキャンを読む部品（{name}）
残りのずれ：{names}
飛行中
{b} m² のうち {a} % は見えていません。未知とし、その上は飛びません（上の項目で変えられます）
パッドを動かしてください。({x}, {y}) m は広く空いています
{name} は単位 {c} では {a} m x {b} m です。{d} から {e} m になるよう、別の単位を指定してください
{name} の画素が小数です。8ビットのpngかpgmで保存してください
m／画素
数値 ({a} x {b}) は{words}とみなし、{c} m x {d} m の部屋です。壁を1枚測り、長さが違えば単位を指定してください
{name} をスキャンとして読めません：{why}。ファイルは完全ですか
{name}：({x}, {y}, {z}) m、向き {a}°、フレームの{n} %
真か偽にしてください
図形が{n}個を超えています。壁でないものを除いてください
数値 ({a} x {b}) は「{words}」ではありえないため、{then}とみなし、{c} m x {d} m の部屋です。壁を1枚測り、長さが違えば単位を指定してください
灰色205は、free_thresh（{a}）では空きですが、見えていない所とします。map_saverがそう書きます
{name} に線がありません。壁は画像でなく線や図形で描かれていますか
{name} の画素が16ビットを超えています。8ビットのpngかpgmで保存してください
0か1
スキャンを .ply か .e57 に書き出してください
{name} ほか{n}
使えるのは：{names}
縮尺1:{n}の図
整数を入力してください
{name} を読めません：{why}。直すか、別の場所に移してください
{name}：{a} m x {b} m、線{n}本を天井までの壁にしました（同じレイヤーにあればドアと窓も）
すでにファイルが{n}個あります。housefly newを起動し直してください
{name} のLASヘッダーが正しくありません。ファイルは完全ですか
{name}はy軸が上です。計測ソフトでz軸を上にしてください
{name}は毎秒{n}件を超えて送信しています。残りは捨てます
{place} ({x}, {y}) m ではホバリングできません。{why}
最も近い障害物まで {a} m、必要な距離は {b} m です
数を入力してください
整数を入力してください
スキャンを .glb か .ply に書き出してください
ご自分の機体を測ってください：housefly identify (docs/identify-and-gains.md)
平面図を .svg か .dxf に書き出してください
2点では互いに確かめられません。3点目を取ってください
{why}。{more}
フィート
区域 {name} がパッドを覆っています
新しいドライバーが飛行中に見つけました。停止飛行と着陸だけをします
ただし：{why}
2点と、確認用の3点目が必要です
パッドの中心から {a} m の床に物があります。離陸には周囲 {b} m 以上が必要です
{name} をSVGとして読めません：{why}
{name}は {a} m x {b} m です。各辺 {c} m までです
x_minはx_maxより、y_minはy_maxより小さくしてください [m]
飛んでいく場所がありません
{name}から何も届きません
数値 ({a} x {b}) は{words}です。壁を1枚測り、長さが違えば単位を指定してください
部屋の高さを直すか、flight_heightを下げてください
{name} は{n}点です。少なくとも{m}点、できれば壁と床の2 cmごとに1点必要です
{name} を .old として残せません：{why}
広い位置をいくつか選びました
挿入されたブロックが{n}個を超えています。壁でないものを除いてください
中にない{name}の{kind}
ファイルが途中で切れていて、{n}点足りません
地図の画像 {name} を読めません：{why}。使えるのはpgmかpngです
1文字以上入力してください
リストにしてください
ファイル名が {name} です。使えるのは100文字までの文字、数字、空白、. _ - + ( ) で、先頭は文字か数字です
壁の向こうか、何かの中です
グループの入れ子が{n}段を超えています
{name}で{n}秒以内にドローンが応答しません。電源は入っていますか、ドローンのWi-Fiに接続していますか
{name} は {thing} で面を保存していて、読めません。圧縮も量子化もせずに書き出してください
{name} が文字列 {thing} なので、数 {n} として読みました
{name}を上向きとみなしました
部屋の始点は (0, 0) で、ROSの地図では ({x}, {y}) m です
{n}個までです。{m}個あります（{kind}）
{name} に点がないか、有限な点がありません
整数を入力してください
読まなかったもの：{names}（{words}）
パッドから行ける広い位置はもうありません
ドローンの{setting}が{wanted}ではなく{kept}のままです
データは{name}から届いていません。tracking.addressを{other}にしてください
{name} から報告がありません
{name}の応答は{protocol}ではありません（{error}）
この部屋にはドローンが入る場所がありません。空いた床はありますか
点が一直線上にあり、逆向きの軸を見つけられません。線の横にもう1点取ってください
読まなかった点：雑音とされた{n}点
{name} を含むレイヤーがありません。あるのは：{thing}
{name} はyamlファイルではありません：{why}
{name}です。{words}
{name}から届く値の時刻が止まっています。{what}は一時停止中ですか
{n}文字までです
天井 {c} m
がありません
{name} の大きさは {thing} で、すべての点が一直線か一平面にあります
{n}より大きくしてください
大きすぎます。{n} MiBまでです
つながりません：{why}
数値 ({thing}) は{words}とみなしました
部屋の大きさがまだありません
これ以上は戻れません
{name} に点も面もありません
ファイルが壊れています。直したか除いた箇所：{n}
が文字列 {thing} です
{name} を読めません：{why}。地図のyamlを選んでください
{name}：{a} m x {b} m、箱{n}個。ROSの地図は平面なので、壁は床から天井までとします
このブラウザーにはセッションがありません
要素が{n}個を超えています。壁でないものを除いてください
{name} のPCDヘッダーが正しくありません：{why}
{name} は {thing} で面を保存していて、読めません。圧縮せずに書き出してください
壁という名のレイヤーがないため、すべての線を壁とします。一部だけが壁なら、レイヤーを指定してください：{name}
何も受信できません：{why}
文字列を入力してください
ファイルの単位か大きさを確かめてください（メートルですか）。または家具や区域を減らしてください
離陸中
{name}に接続しましたが、応答がありません
部屋に壁がありません
数を入力してください
{name} は途中で切れています（{b} バイト中 {a} バイト）
箱が{n}個以上必要で、上限は{m}個です。飛ぶ部分を切り出し、孤立した点を除いてください
名前と位置を決めてください
{n}以上にしてください
読まなかった点：{m}点中{n}点（{words}）
読めない
何も保存されませんでした：{why}
単位がミリメートルではありませんか。計測ソフトでメートルを選んでください
画像ではなく、それを指す地図のyamlを選んでください
なし
{name} に書き込めません：{why}
{name} は {n} MB を超えています。点を間引いてください。間隔は2 cmで十分です
部屋の始点は (0, 0) で、スキャンでは ({x}, {y}) m です
計測の座標系の原点は地図上の ({x}, {y}, {z}) m、回転 {a}°です
指定どおり、{name}が上向きです
{name} は地図のyamlではありません。image、resolution、originがありません
計測された
{name} を読めません。読み取りが異常終了しました。ファイルは完全ですか
ドローンが入る場所がありません。床の {a} % が見えていません
外壁が閉じておらず、どこが外か分かりません。地図を見て、足りない壁を描いてください
種類とアドレスを入力してください（例：vicon 10.0.0.5）
先にドローンのアドレスを入力してください
知られていない項目です
非表示、またはフリーズ・オフのレイヤー
広い位置を選びました
床
{n}以下にしてください
{n}より小さくしてください
{name}：地図が {a} m² を超えています。飛ぶ部分を切り出してください
長方形は x_min, y_min, x_max, y_max [m] で、x_min < x_max、y_min < y_max にしてください
ファイルが届き終わる前にブラウザーが離れました
が {thing} です
位置を決めてください。({x}, {y}) m は広く空いています
ファイルを保存できません：{why}
メートル
ページと同じ大きさのrect
着陸済み
点の間隔は約 {a} cm です。{b} cm のマスで読みました
点が {n} cm 以内で一致しません（最大は{name}）。ドローンを置き直して測るか、地図上の位置を測り直してください
この部屋にはドローンが入る場所がありません
部屋のプロセスが応答しません（記録：room.log）
{name} の点の間隔は {a} cm を超え、壁と隙間を区別できません。もっと密に（できれば2 cmごとに）、または面として書き出してください。単位が違うかもしれません
先にシステムの種類とアドレスを入力してください
形式のとおり、{name}が上向きです
不明
ファイルが途中で切れています
{name}：地図に空いた画素がありません。negate（0か1）と free_thresh を確かめてください
{name} の位置が部屋より遠すぎます。{ask}
({x}, {y}) m からは離陸できません。{why}
ファイルの書き方によればインチ
数でない
{name}にまだ接続していません
{name} {n} cm
位置を受け付けません。{pose}：{ask}
計測では1 mが {a} m に見えます。点を測り直してください。それでも同じなら、カメラを校正するか、計測ソフトの単位をメートルにしてください
{name} の大きさ {a} x {b} は、どの標準の単位でも部屋になりません。1単位が何メートルか指定してください
{name} には {thing} も必要です。両方を選ぶか、1つの .glb に書き出してください
{name}：{key} {found}。使えるのは：{words}
{name} というファイルはありません。名前を確かめてください
{n}文字以上入力してください
天井（{a} m）が飛行の高さ（{b} m）より0.4 m以上高くありません
非常停止
{a}です。ファイルの1単位は{b}から{c}メートルまでです
{name}：free_thresh（{a}）は occupied_thresh（{b}）より小さくしてください
{name} は {n} x {m} 画素です。読めるのは各辺{p}までです
{words} {unit}
map.flight_height（{a} m）は limits.height_min..height_max（{b} .. {c} m）の間にしてください
{name} のE57ヘッダーが正しくありません。ファイルは完全ですか
サイトのファイルで飛行禁止です
長さ×幅×高さをメートルで（6x4x2.5）、または部屋のファイルを指定してください
線や図形でない
ドローンを計測するシステムが決まっていません
ミリメートル
やり直しました
ドローン {name} が見つかりません（見えているもの：{names}）。マーカーを隠さないようにするか、計測ソフトでの名前を入力してください
ドローンのアドレスが決まっていません
{a} x {b} x {c}
ブロックの入れ子が{n}段を超えています
壁のないレイヤー
天井 {c} m（スキャンになく、標準の値）
{name} を読み込みました
{name}に接続しましたが、新しい値が届きません。{what}は動作中ですか、一時停止していませんか
{name} は {n} MiB を超えています。先にスキャンの点を間引いてください。間隔は5 cmで十分です
{name} は毎秒{n}フレームを送っています
ドローンが制限値をまだ確認していません
ファイルによれば1単位 {c} m
指定どおり、未知の床は空いているとみなします
{names}（地図を保存し直してください）
は知られていない項目です。{names} のことですか
壁はレイヤー {name} から取りました
{why}：{more}
image の {thing} がないため、yamlと同じ場所の {name} を読みました
{a}から{b} {unit}までの数
壁を描くか、大きさを入力し直してください。長方形には4枚の壁が付きます
{name} は実体を定義しています。プレーンSVGで保存してください
{name} には線が{n}本あり、読めるのは{m}本までです。壁のレイヤーを指定してください。レイヤー：{thing}
地図上の
この値を直してください
{name} は{n}点あり、読めるのは{m}点までです。点を間引いてください。間隔は2 cmで十分です
{name} は地図のyamlではありません。{n}文字、括弧{m}個までです
{a}から{b}までの数
{name}で応答がありません。{what}は動作中で、送信していますか
元に戻しました
{name} をDXFとして読めません：{why}
ここで3点を取るか、ドローンを持って歩いてください：housefly preflight --frames --site SITE
点でも面でもない{n}個の部分は読みませんでした
({x}, {y}) m から {a} m 離してください
インチ
指定どおり、1単位は {a} m です
部屋の大きさがまだありません。長さと幅、またはファイルを指定してください
{place} という場所が2つあります
2 cm以下
{name} に項目 {thing} がありません。あるのは：{place}
{name} は壊れています。点の長さが書かれた値と違います
がありません
一般的な{name}の定数で飛びます
{name}です。{a}から{b}までの数にしてください
消しました
計測の座標系と地図はまだ照合されていません
{name} を読めません：{why}
ほか{n}個
{name} の大きさ {thing} は、どの標準の単位でも部屋になりません。1単位が何メートルか（ミリメートルなら0.001）と、上向きの軸を指定してください
{name}：この種類のファイルからは部屋を読めません。{words}。使えるのは：{thing}
{name}：この種類のファイルからは部屋を読めません。使えるのは：{thing}
ホームからそこへの道がありません
ほかから遠く離れている
{name} が届きませんでした。もう一度選んでください`.split(`
`).map((e,a)=>[o+=parseInt(t.map(m=>m[a]).join(""),36),e]));var i={"New site":"新しいサイト","Waiting for the draft …":"下書きを待っています…",Steps:"手順","new site: {name}":"新しいサイト：{name}","without a name":"名前なし",Undo:"元に戻す",Redo:"やり直す","△ Not kept":"△ 保存されていません","Keeping …":"保存中…","Kept; checking where one can fly …":"保存済み。飛べる場所を確認中…","Everything is kept.":"すべて保存されています。","Next: {title}":"次へ：{title}","Bringing {file} …":"{file} を送信中…","Remove {name}":"{name}を削除",Remove:"削除",Done:"完了",Name:"名前",Address:"アドレス",Room:"部屋","Walls and furniture":"壁と家具",Pad:"パッド",Places:"場所","No-fly zones":"飛行禁止区域",Tracking:"位置計測","Tracking frame":"計測の座標系",Drone:"ドローン","Write the site":"サイトを書き出す","Wall {k}, {d} m":"壁 {k}、{d} m","point {k}":"点 {k}","at {x}, {y} m":"{x}, {y} m","{n} point|{n} points":"{n}点","no points":"点なし","{n} piece|{n} pieces":"家具{n}点","{n} wall|{n} walls":"壁{n}枚","no walls":"壁なし","no furniture":"家具なし","{n} boxes of a file":"ファイルの箱{n}個","{a} × {b} m, {h} m high":"{a} × {b} m、高さ {h} m",simulated:"模擬","{kind} at {address}":"{kind}（{address}）",none:"なし","Floor plan":"間取り図","Floor plan. Tab reaches what the open step draws; arrow keys move it.":"間取り図。Tabキーで開いている手順の図形を選び、矢印キーで動かします。","Give the room a size first.":"先に部屋の大きさを入力してください。","too close to fly":"近すぎて飛べません","Drag to draw; tap what is drawn to move it.":"ドラッグして描き、描いた物を押して動かします。","Tap where the pad lies; pull its line to where the nose looks.":"パッドの位置を押し、線を機首の向きへ引きます。","Tap for a new place; pull its line to what it looks at.":"押すと新しい場所。線を見る物へ引きます。","Drag over what is to be kept free.":"空けておく範囲をドラッグします。","Tap where a point lies on the floor.":"床の上の点の位置を押します。","Name of the site":"サイトの名前","my lab":"研究室","An empty rectangle [m]":"空の長方形 [m]","length (x)":"長さ (x)","width (y)":"幅 (y)",ceiling:"天井","Make this room":"この部屋を作る","Change the size":"大きさを変える","Four new walls take the place of those that are drawn.":"描いた壁は新しい4枚の壁に置き換わります。","Or a file of it":"またはファイル","ROS map (yaml and its picture), scan (ply, gltf, las, e57 …), plan (svg, dxf)":"ROSの地図（yamlと画像）、スキャン（ply, obj, gltf, e57, las, pcd …）、平面図（svg, dxf）","Unit of the file":"ファイルの単位","Up in a scan":"スキャンの上方向","Floor that was never seen is":"スキャンされていない床の扱い","a wall":"壁","free floor":"空いた床","found out":"自動判定",metres:"メートル",centimetres:"センチメートル",millimetres:"ミリメートル",inches:"インチ",feet:"フィート","Layers of the plan that hold the walls (may be empty)":"壁が描かれたレイヤー（空欄可）","walls, windows":"壁, 窓","None of these is a room: choose the yaml, the scan or the plan too.":"部屋のファイルがありません。yaml、スキャン、平面図も選んでください。","Read {file}":"{file} を読む","Read it":"読み込む","Reading {file} …":"{file} を読み込み中…","Read from {file}.":"{file} から読み込みました。","The drone flies at [m]":"飛行の高さ [m]","height above the floor":"床からの高さ","A drag on the plan":"間取り図でのドラッグ",Move:"動かす","Draw walls":"壁を描く","Draw furniture":"家具を描く","Erase scan":"スキャンを消す","{n} boxes come from the file; “Erase scan” takes out what moved since.":"箱{n}個はファイルのものです。その後動いた物は「スキャンを消す」で取り除けます。","Kind of furniture":"家具の種類","{name}, {d} m high":"{name}、高さ {d} m",table:"机",chair:"椅子",sofa:"ソファ",bed:"ベッド",shelf:"棚",cupboard:"戸棚",box:"箱","Add a wall":"壁を追加","Add a {name}":"{name}を追加",Furniture:"家具",Walls:"壁","From, to [m]":"始点と終点 [m]","x from":"始点 x","y from":"始点 y","x to":"終点 x","y to":"終点 y","Thickness and heights [m]":"厚さと高さ [m]",thickness:"厚さ",bottom:"下端",top:"上端","up to the ceiling":"天井まで","Middle and size [m]":"中心と大きさ [m]",length:"長さ",width:"幅","Heights [m], turn [°]":"高さ [m]、回転 [°]",turned:"回転","Choose a roomy spot":"広い位置を選ぶ","Looking for a roomy spot …":"広い位置を探しています…","Put it in the middle":"中央に置く","Pad [m], nose [°]":"パッド [m]、機首 [°]","nose looks to":"機首の向き","The drone starts and lands there. 0° is along x, 90° along y.":"ここから離陸し、ここに着陸します。0°はx方向、90°はy方向です。","Add a place":"場所を追加","Choose roomy spots":"広い位置をいくつか選ぶ","Looking for roomy spots …":"広い位置を探しています…",Place:"場所","Reading corner":"読書コーナー","In commands: {name}":"コマンドでの名前：{name}","Hovers at [m]":"ホバリング位置 [m]","Looks at [m]":"見る位置 [m]",height:"高さ","looks away from the pad":"パッドと反対側を見る","Add a zone":"区域を追加","None are needed: walls and furniture are kept away from anyway.":"なくてもかまいません。壁と家具からは常に離れて飛びます。",Reason:"理由","Wet floor":"床がぬれている","kept free":"空けておく","Kept free [m]":"空けておく範囲 [m]","What flies":"飛ぶもの","All simulated":"すべて模擬","Real hardware":"実機","Drone and tracking are simulated: try the room first.":"ドローンと位置計測は模擬です。まず部屋を試してください。","What is real can be said later.":"実機の設定は後でできます。",System:"システム","another, by motioncapture":"その他（motioncapture）","as usual":"標準",Port:"ポート","Its type in motioncapture":"motioncaptureでの種類","The drone's name there":"そこでのドローンの名前","Axis up":"上向きの軸","Begins by":"接続の方法","Listen for {n} s":"{n}秒間受信する","Listening …":"受信中…","Which one is the drone":"どれがドローンか","The simulated tracking system uses the map's frame.":"模擬の位置計測は地図の座標系を使います。","Lay the drone on three points of the floor that are far from each other.":"互いに離れた床の3点に、順にドローンを置きます。","For each, say where it is on the map, and take where tracking sees the drone.":"各点について地図上の位置を入力し、計測された位置を取り込みます。","Add a point":"点を追加",Points:"点","What the points say":"点からわかること","On the map [m]":"地図上 [m]","As tracking sees it [m]":"計測された位置 [m]","Take what tracking sees now":"今の計測位置を取り込む","The drone is simulated; “Tracking” says what flies.":"ドローンは模擬です。飛ぶものは「位置計測」で選びます。","Profile of housefly identify (may be empty)":"housefly identifyのプロファイル（空欄可）","Ask the drone":"ドローンに問い合わせる","Asking the drone …":"ドローンに問い合わせ中…","Nothing turns: it is only asked how it is.":"何も回りません。状態を聞くだけです。","What the steps above still lack has to be said first.":"先に上の手順で足りないものを入力してください。","Room and site are written as files that you can read and change.":"部屋とサイトは、読んで変更できるファイルとして書き出されます。","Writing …":"書き出し中…","Written to {folder}. In a terminal:":"{folder} に書き出しました。端末で：","Is this machine fit for it?":"このコンピューターで動きますか","The whole thing, simulated":"すべてを模擬で","Before the first flight, the drone in your hands":"初飛行の前に、ドローンを手に持って","The real room":"実際の部屋で"},h={texts:i,templates:n};export{h as JA};
