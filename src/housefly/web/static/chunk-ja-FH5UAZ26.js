import"./chunk-chunk-3JDQFTOK.js";var t="hfgmt8urq4r1ed28kmp4ozkrhkblec5i63d8pjgyo2e8pv3hqi6og580jrv67ztk6mwgtmxdnfgcavaz7g0ytjj6qp42gipqtquvx1zuykklob6q0tqjog69wy6iklo6rvsrdfl227l7r3yjjiirfwf6l2jvzxoe49iqt2jz4oc9cgw92g5vzg52w3dhidt04han55nl8gp417fxvbitioaao69nflwpt6lgfwa3eu9vdyc1fbd5jrg4wri7qdkm1re9alxcii1tx462yf9oriju3vuvqys8tn3vc3pz3g18ziwczdm0fx177eph3u259zbp3smej3xsd5zccg26p7geinbak9g020sw4z79b4biat7av0d1nv1byr0tw5sucv1s9z55ix2l095nnry8tiih5jih8nrariwgjp7uvg8rg2zwy9fiic0lw8h8kalmm43kamqqsymiv1udodk74l96cf0na6ozyq500dsgy203fowdha8bwu1s7ujf8cc1lrnwy4ua8cr6p95mhguzr61h2kcoh47nng4ya5jkydkxuvrq81nxeg4cil50pjycw3aiaz4v5juk6l34hfw6m9j0ibc68kefcpf4p89ucpavsnq0iezjr0mevl7uvjwhz1ybhbehfy4otgrxkccv3u2j1g1s4746y0drq0bq3aaoz7ll44e6vp56gqj2pa4tbw6ipk9r6f6f86ldz8879gjr2c9k8z7voleerjv2hker7grl1dyl0ll51ugk2xn546c3su6h8oqys0vo0d1fq942tz78nj0hvey02chywmxmvvy3gxsiw23iro1ihjvooelsc3vwpe1zmuhsid0enhnlp9ndspkbtvllzjmywmby1k41t2iev2eupcde5mqqi0b9blefbawwhsd5oww5vgighj1xlolzmvy7v615xmzoc4hwnwfai7d5f4ybi8tuvfsro5i8hq5tzccwux56ow268prmqu0fwhj3ym2znh1t84vdfrie401q99wtnupruk3xafonlu63udfv350tcl6z1g820cwu5q913fiaifyeiiggte9a6ifz9rusbrgwoanafwtjctbdf8l6lrsi5xqha5p39ycmj5u128zh7xesm5wa4brce5k6e43obhfw9zi1tkxq8qb2eb8f4b4c9in7ok1sw0ie60lfubcuzlhzjy1i5txvhte53t5mrtr5xrp2hpfsf1kb7p4djzhu0j6ufby3jeqm45j4ilve2gnqp17ezy5w3xwjog953ac213yzc01wtpq5r8oxsuexzq5tz97gtz885slvp9hbol6230jqlovqvvzo2sc54x4ikj9nlre4402aj3zehxblxz9hogcbdag0v1w434t81ev6f0x2eha73p2gxgwf7ibikip40f0l65s19xrix97dmwih1q8zhtgu7pf1zpqcguqlc3nsft2jsea99uzf33hnt4aq5kbtmu9b1w63mg1pixom9odyxrm08xa0s231c2nit5w22ts50e8zbxqg8bc5mzftzj4mxqahfrzg4725schpidpqhi2xex4iwjg3wqd2xxdfgy9x6eapzesao1b3wxtuk64zuhwusvrvhkx2hnpem4hfdvvz0cdycf1m78102j51c55rodwwouy9d0k3luo6huru1yu7doqjhu4swu7vla9iyqtnzmc2fbpkjjs30f661ao2pshqo4ro318b9aqhqxjtqlpcvn56fzrq6cyn8udvr3cpcnci3jcnmnxmji6d0pzyxyoejgjfr4v7meiol801oqx7vxpodic6evabuaa1rsagp6ywlb4nem3csdmbwhi7tdd6lyp4g5i1rhzrmwsn52omvsi0zktl5mvf5cl1bu6yxkuer5c8uk35bupbybwyi1alc0orpil03e2lb8ipqqcrg7h0offff7x2ot0chqipalbk7qcqxufubm9pcngaskcm6ew9d9hahgyoflt3vramoj3rid3cgxu4ypvnowewe5sp969laqh3untnkrtozwi3bugkpf3yjtelkle7mg87ygxhlaysv3jo4lznx1hrno4a7b1wmpv3zo4s0d6gd32cl90mlh3zhozl99emo9lpt3v6zpl6hi62bwspuc842eklyoqjx4au8cymj69dltf6vtojngf6fmuc9ngt10lbgk9n09v90if2taxyvcem662pssmrp5h5885irn624bfx09u0bxioq7xlemcuvw1n3wlpo1hw7hjchgsurc79mhb5mm41w51jae4bkuafhe42ym1iu06il1jqwltz72bjobw3jii8vwib6hz2ch7w8u3u2lgs7nvl0gznenktkgpww9ju39ndr6ssdtmexwb9pni181a55l6qd840sekhm2j18t4gw1qgtfxjthkyibz7zxx8ggivyjkk9zwvb2osswcp2md6ukip61wv206yjjuqzb77br3t55moafu84a4agig2wkzhxg6t3rmthwvb926imry4hu22ycm0sotrac9ow4wr16bew2uw9jdy8869van0w99gn0dfhvpvo8v713v1qqycrdd4c80xq39ubgc8ldekc9b9g5min1nx7opnjkw0yrntiawtfctrkazwn7iffzzej664e3alho0loecxbntpyb786un0qje6k4c0x4hpn0jwwzq5u5tc17ib6s7arlkiu37fr3qu2y9202qy389illvake6ur9epjiwvzkxjxdt98pw117cnr5kb57zfdxwscbimvrqxjkjzlcfxc1u3hylnu5t361lmkzrev7fsrvo5zrtrcoadwfxyig8egnv6w33j2yt3gp6s2lakrqn7fbz5b2i5ahpobf4pmlng2mnvut8bz7g0tkhyaugc27fi318i7c69ttdss7mw71nhlrna01tfxf5yzclm3a2ohqvtm79xhheaqx63gqi21ql39tfa7r5vcgfg28uv4nso2mr50hxcxddldza3r1ne9wf1spqukkc31nz9ocuwfhxxbtvgd720ocw5cn4s8ye4eephib0a9gqto9l6y6a1r7w0tnheuzjwxdpsm4i3dhg0j0ynzol8umq0zuzlg95r47knytham3t45b0fq9z54qs6l23ieb39v0jdqolknpuom7q1lmjzrrn7iba0bbfqn7e4zc30idkrywuy2ud1tdpuiwvv1gyxfg6biwpp4i6kobemkaehhwy3xp52m8ju5sg496e0cgordlqpl61zqoifsztwp1tsrucox3ayifcjwpsvk4t7yoe9pcqvdok89d5110k6z7l8qt8m0d9w1a97mgrvm87bvnvb2w2bzw4ugsb3ns3oz3suqpwrwabvbwbnhq3p2ks25othogjxsg1lh7ty1zm2xlea94f66wfxewptvi8bd97encv2bqqb006nkql3d97de8gspt870td1o7x50fif5r67gprf2sgcvgpq5utw6c2suk8hovcxde39tq2ez0w3gflq1so2cee49qxdoxlg2xbbxm0e87plfer2nm1d127ozxwvbav0iwi1ifjtpgk14m3x1jlf4wjemuhbjo65zk4wtflvl2ttgv5ivc349t42nke0wwufh4b2w1dacewrpglhfgk0ongwcrae1nco1zwph29neylwv32w8zo40swwbld1g1v8vixs7144sne0r6vuou6tpiqd18m5x0sx4fobmyva48h3qsp1te7k8d4tt",n=Object.fromEntries(`自動操縦を待っています
自動操縦と通信なし
自動操縦と通信なし。
ドローンと通信なし
ドローンを待っています
モーター遮断済み
停止中
安全のため静止中
安全のため帰還中
安全のため着陸中
安全のため降下中
モーターを遮断中
準備完了・パッド上
準備できていません
パッドの外です
パッド上
地上
離陸中
{goal}へ飛行中
{goal}を確認中
帰還中
着陸中
ホバリング中
手動で移動中
{who}が手動で移動中
手を離すとその場で静止します
モーターは止まっています
状態を確認中
指示を待っています
自動で戻ります
残り {d} m・{n}秒
残り {d} m
{place}。そこから離陸できます
{place}。次の飛行の前にリセット
{place}。再開するまで飛びません
再開するまでホバリング
{n}秒間。{then}
最後は地上にいました
最後はホバリング中でした
最後は離陸中でした
最後は{goal}へ飛行中でした
最後は{goal}を確認中でした
最後は帰還中でした
最後は着陸中でした
最後は手動で移動中でした
最後は{who}が手動で移動中でした
目的地
選んだ地点
ホーム
パッド上
地上、パッドから {d} m
地上、パッドから {d} m、{thing}の下・上・中
地上。{why}
空中
空中。{why}
不明
位置計測はまだ見つけていません
位置計測は{n}秒前から見失っています
位置計測で見えません
位置計測はまだドローンを見つけていません
位置計測は{n}秒前からドローンを見失っています
位置計測でドローンが見えません
自動操縦から{n}秒間応答がありません。{then}。STOPと着陸は送り続けます。
ドローンから{n}秒間応答がありません。{then}。STOPと着陸は送り続けます。
ホバリング中。「再開」を長押しするまで指示を受けません
「再開」を長押しするまで指示を受けません
自動操縦の応答がありません。次に動くものも停止します
送信済み。自動操縦の確認待ちです
自動操縦が確認していません。送り続けています
STOPは受け付けられませんでした
STOPが届きません。サーバーと通信できません
異常がなくなるまでホバリングし、続く場合は自動で着陸します
安全のため帰還を続け、着陸します
再開されるまでその場でホバリングし、電池か時間がなくなれば自動で着陸します
その場で着陸を続けます
その場で床まで降下を続けます
モーターを遮断中です。落下します
地上にとどまります。新しい指示がなければ動きません
ドローンの状態はまだ分かりません
最後の応答では地上にいました。自動操縦がなければ動きません
最後の応答では空中にいました。着陸を指示し続けています。通信が切れたドローンは自動で止まり、着陸します
自動操縦が止まった場合、ドローンは数秒で自動で止まり、着陸します。通信だけが切れた場合、{then}
離陸を続け、{goal}へ飛び、{n}秒以内に自動で帰還し着陸します
離陸を続けてホバリングし、{n}秒以内に自動で帰還し着陸します
{goal}へ飛び続け、{n}秒以内に自動で帰還し着陸します
最後まで確認し、自動で帰還し着陸します
帰還を続け、自動で着陸します
着陸を続けます
その場でホバリングし、{n}秒以内に自動で帰還し着陸します
自動操縦と通信できません
自動で再起動します。待つか、実行フォルダーの記録を見てください
ドローンはすでに飛行中です
ドローンはすでに飛行中です。
離陸前の点検がまだ終わっていません
数秒で終わります
ドローンが応答しません
電源を入れ、そのWi-Fiに接続し、\`housefly doctor\` を見てください
モーターが遮断されています
近くに人がいないこと、壊れていないことを確かめ、「リセット」を長押ししてください
STOPで停止中です
安全を確かめて「再開」を長押ししてください
位置計測の装置を見てください。動いていますか。この名前で送信していますか
{thing}の下・上・中にあります
パッドまで運んでください
{why}（{found}）
{why}。{more}
{why}：{more}
モーター遮断済みです。先に「リセット」を長押ししてください。
停止中です。先に「再開」を長押ししてください。
ドローンがまだ応答しません。
ドローンは地上にいます。
STOPのあとだけ使えます。
準備できていません：{why}。
いまはできません：{why}。
安全のため帰還中です
安全のため着陸中です
モーターを遮断中です
{why}。着陸します
{why}。帰還します
{why}。減速します
{why}。ドローンが自力で静止します
{why}（限度 {n}秒）
{why}（限度 {d} m）
{why}（限度 {d} m/s）
{why}（限度 {n}）
指示によりモーターを遮断中です
モーター遮断済みです。近くに人がいないときにリセットしてください
床の上で{n}秒間モーターが回っています。遮断します
着陸の指示から{n}秒（限度 {m}秒）、まだ空中です。こちらの指令で降下します
ドローンから{n}秒間応答がありません
人が見えていない恐れ：人を見るセンサーからまだ応答なし
ドローンが{n}秒間、制限値を確認していません
ドローンが制限値を確認していません
バッテリー {p}% が {q}% を下回りました
バッテリーが{n}秒で {p}% 減りました（限度 {q}%）
飛行{n}秒。離陸時の残量で飛べる時間です（limits.flight_time {m}秒）
自動操縦が{n}秒遅れました
直前{m}秒のうち{n}秒、静止しました
STOP：再開するまでホバリング
バッテリー {p}%、帰還（{n}秒）に {q}% 必要です
残り飛行時間 {n}秒、帰還に{m}秒必要です
自動操縦が{n}秒以上遅れています
命令がドローンに遅れて届くか、届いていません
自動操縦が何度も遅れています（{n}秒に{k}回）
バッテリー {p}%。{q}% で帰還します
バッテリー表示が{n}秒間 {p}% のままです（限度 {m}秒）。時計で飛行、残り{k}秒
位置計測が{n}秒間途切れています
位置計測にドローンがまだ映っていません
計測した位置がドローンの動きと{n}秒間合いません
ドローンが動きを報告しないため、計測を確かめられません
計測した経路がドローンの動きから {d} m ずれています
計測した向きがドローンと{n}度ずれています
位置計測がドローンの動きと左右逆です
計測した高さが床の段差なしに {d} m 上がりました（限度 {m} m）
計測した高さがドローンの値と {d} m ずれています
{why}、または下に物があります。減速します
ドローンは床にいますが、位置計測では床から {d} m です（限度 {m} m）。飛びません
ドローンは床にいますが、位置計測では {d} m 動いています（限度 {m} m）。飛びません
位置データが表示より{n}秒古いです
何かに当たったか、位置計測が飛びました：速度が急に {d} m/s 変化（限度 {m} m/s）。着陸します
何かに当たりました：衝撃 {d} m/s²（限度 {m} m/s²）。着陸します
予定の高さ {m} m より {d} m 高い
予定の高さ {m} m より {d} m 低い
{why}状態が続いています（限度 {d} m）
地図の外へ {d} m 以上出ました
高さ {d} m を超えました
高さ {d} m を下回りました
上昇速度 {d} m/s
傾きが指令と{n}度違います
直前{n}秒のうち{d}秒、傾きが指令と違いました
{n}度傾いても動きません（限度 {m}）。何かに引っかかっています。着陸します
予定の位置から {d} m ずれています
{why}。その場で止めています
毎秒{d} m
毎秒{d} m以下
自身の報告では静止しています
この速度をもとに離陸し、位置を保ちます
着地しているのに、動いていると報告しています
人が見えていないかもしれません：センサーが{n}秒間、使える値を出していません
ドローンは自分の動きが見えず、自分では位置を保てません
{why}。ドローン自身の速度も信頼できないため、水平に降下します
下向きカメラと床を確認し、電源を入れ直してください
ドローン自身の速度が計測とも傾きとも合いません。計測をもとに着陸します
地図の外へ {d} m 出そうです
{d} m/s で飛行中（限度 {m} m/s）
動きが指令と {d} m/s 以上違います
床より {d} m 高い所にあります（限度 {m} m）。何かの上です
離陸位置から {d} m 流され（限度 {m} m）、高さは {k} m だけです。モーターを遮断します
{d} m/s で流され（限度 {m} m/s）、床から {k} m だけです。モーターを遮断します
離陸位置から {d} m 流されました
風にあおられています：{n}秒間、速度が {d} m/s ずれました
指令が数値ではありません
飛行を妨げるものはなくなりました
ドローンが応答しています
{n}秒前
一度もなし
{n}秒以内
応答のないドローンは止められません
着地しています（本人の報告）
ドローンが着地を報告していません
着地
飛行中
離陸中
非常停止
不明
着地したドローンだけが離陸できます
非常停止中で近くに人がいなければ「リセット」を押してください
正しく立っています
ドローンが傾いています
{n}度
{n}度以下
傾いたドローンは横に飛び出します
パッドに水平に置いてください
制限値を確認しました
確認済み
まだです
傾き・高さ・速度の制限値は、ほかがすべて失敗したときの守りです
数秒待つか、電源を入れ直してください
異常の報告はありません
ドローンが異常を報告しています
なし
飛行中に着陸するか落下します
プロペラ、モーター、バッテリーを見て、電源を入れ直してください
バッテリーは充電されています
バッテリー残量が足りません
{p}%
{p}% 以上、遠い場合はさらに必要
帰還と着陸に必要です
充電するか、バッテリーを交換してください
バッテリー残量の表示は変化しています
バッテリー残量の表示が変わりませんでした
{p}% のまま変化なし
変化あり
残量が分かりません
バッテリーを交換するか、ドローンの電源を入れ直し、別の値が出てから離陸してください
位置計測で見えています
位置計測をもとに飛びます
位置計測の装置を見てください。動いていますか。この名前で送信していますか。遅いだけなら、必要な limits.pose_age_level を housefly gains が示します
止まっている間、位置は動いていません
止まっているのに、計測では動いています
{d} m 移動
{d} m 以下
床でずれる計測は、飛行中もずれます
別の物が同じ名前でないか確認し、一度持ち上げて位置を示してください
計測した高さは正しいです
計測した高さが違います
{d} m
{d} m 以内
床の高さが違えば、部屋全体の高さが違います
位置計測の原点を床に合わせ、ドローンを登録し直してください
STOPは押されていません
押されています
押されていません
人が再開するまでSTOPが続きます
安全を確かめて「再開」を押してください
上と周りに人も物もありません
上がる場所が空いていません
空いています
{who} が近すぎます
{thing} があります
その場からまっすぐ上がります
パッドの周りを空けてください
設定とセンサーは正常です
ドローンの設定かセンサーに異常があります
はい
予定と違う飛び方をすることがあります
説明書のドローンのページを見てください
位置計測でパッド上に確認済み
位置計測でまだパッド上に確認されていません
パッドから {d} m、{n}° 回転
一度 {d} m・{n}° 以内
位置計測と地図がずれていると、壁の位置も違います
機首を向きに合わせてパッドに置いてください。すでにそうなら: \`housefly preflight --frames\`
パッドに置かれています
ドローンがパッドにありません
パッドから {d} m
実際にパッドにあるなら位置計測と地図がずれていて、壁の位置も違います
パッドに置いてください。すでにあるなら、位置計測の原点を地図と比べてください
ほかの機体にある機能がそろっています
ほかの機体にある機能がありません
傾きでの操縦
カメラ
自律ホバリング
自身の高度
自身の速度
自身の姿勢
それを使う規則は働かず、位置計測が途切れると降下して着陸します
位置計測が確かな所でだけ飛ばし、人を近づけないでください
目印のない人もセンサーで見えます
目印のない人は見えません
センサーなし
センサーに見える人の前でだけ止まり、よけます
{n}秒間使えるデータなし
まだ応答なし
{n}秒以内に応答
\`housefly sensors\` で、各センサーの電源、ネットワーク、覆いの有無を見てください
人を部屋に入れないか、スキャナーか深度カメラを追加してください
前回の座標点検は正常でした
前回の座標点検で位置計測に誤りがありました
分かっている異常なし
違う場所へ飛び、着陸や衝突をします
点検の指示どおり直し、もう一度点検してください：\`housefly preflight --frames\`
座標を点検済み
座標を未点検
[tracking] を変えてから
[tracking] を変える前
不要：部屋は模擬です
誤りあり
点検済み
軸の反転、回転、ずれは、動いたあとでしか分かりません
ドローンを一度持ち運んでください（2分）：\`housefly preflight --frames\`
部屋を見守っています
位置計測を待っています
ドローンなし
この部屋にドローンはありません
この部屋にドローンはありません。
このコンピューターの処理は間に合っています
このコンピューターは過負荷です
{k} コアで負荷 {n}
{k} コアで負荷 {n}
負荷 {n} 未満
遅れて届いたデータは、届かなかったものとして扱われます
ほかのプログラムを終了してください。シミュレーション映像が最も重い処理です（twin.video = false）
ディスクに空きがあります
ディスクの空きがわずかです
{name} の空き {p}%
空き {p}% 以上、または {n} GB
飛行の記録を残せません
古い飛行記録を消すか、別のディスクに移してください
ディスクに書き込めます
ディスクに書き込めません
今書き込みました
ファイルを書き込めること
ディスクを書き込み可能でマウントし直すか、このユーザーの書き込みを許可してください
ここでは人を検知できません：スキャナーも深度カメラもありません
{name} から {place} へ行ける道がありません
受け付けません（{asked}）：{why}
離陸
着陸
ホバリング
再開
リセット
モーター遮断
移動
確認
指示が古すぎます（{n}秒）。{m}秒で無効になります
非常停止中ではありません。ドローンの状態：{what}
STOPで停止中です。先に再開してください
安全のため着陸中です
安全のため帰還中です
ドローンの準備ができていません：{what}
ドローンが制限値をまだ確認していません。待つか、電源を入れ直してください
計測した位置が実際と {d} m ずれています（限度 {m} m）。位置計測の原点とドローンの登録を確認してください
バッテリー残量が足りません：{p}%、離陸には {q}% 必要です
位置計測が{n}秒遅れています（limits.pose_age_level：{m}秒）。必要な値は housefly gains が示します
{why}：{found}（条件：{limit}）。{mend}
ほかの人が操縦中です。引き継ぐにはボタンを長押ししてください
操縦権がありません
このセッションは終了しました
操作が多すぎます。少し待ってください
その人はもういないか、操縦できません
場所か目的地を指定してください
部屋の情報がまだありません
目的地が部屋の外です
サーバーと通信できません
サーバーとの通信が切れました
あなたの役割では、動画は見られますが、まとめて保存できません
呼び鈴が押されました
呼び鈴
人がいます
人が歩いています
人が立っています
人が座っています
人が横になっています
人が倒れました
室内にいます
歩いています
立っています
座っています
横になっています
倒れました
ベッドに人がいます
家電がついています
扉が開いています
いいえ
無視
あとで
着陸中
{why}。自力で静止します
ドローンは移動中です。先に「ホバリング」を押してください。
飛行中は離陸時の地図のままです。先に着陸してください
ドローンが飛行中か分かりません
用事の実行中です。終わるのを待つか、取り消してください
ドローンはすでにこの版を使っています
すでに実行中です
記録中は地図を変えられません。起動し直してください
撮影できるのは飛行中だけです
その映像はもう残っていません
新しい地図で自動操縦を再起動中です。少しあとでもう一度指示してください
{who} が自動操縦を再起動し、最新の場所と区域を反映します
ここでは手動での移動は使えません。
用事の飛行中です。先に「ホバリング」を押してください。
ここでは手動での移動は使えません（limits.nudge_speed）
手動での移動には map.planner = "space" と標準モードが必要です
自動動作の飛行中です
手動での移動は専用の操作で行ってください
通信が遅れています：{n}秒遅れで届きました
手動での移動
モーターの異常
ソフトウェアの異常
モーター停止
バッテリー残量不足
傾きすぎ
センサー基板の応答なし
飛行時間の超過
強風
超音波の応答なし
部屋の記憶が応答しません
0〜{n}秒
有限でない数値があります
壁が近いかもしれません
前方に壁か家具があります
{n}秒早い経路が空いたので、そちらを通ります
パッドの上です。着陸します
指示の受け付けを再開します
{who} の障害物は使えません：{why}
先に停止か着陸の指示が来ました
到着しました
到着しました。確認しています
最大 {d} m/s、手動での移動のみ
印字できる {n}文字まで
経路を外れて止まりました。そこから続けます
安全のため戻ります
座標は {d} m まで
モーターを切る
ここから実行します
離陸後に実行します
指示がドローンに届きませんでした
利用者による緊急着陸
非常停止を解除しました
目的地へ飛行中
下か横に家具または壁があります
下に家具があります
goal が室内の位置ではありません
保持中
ここで待機します：{why}
「再開」まで停止し、移動の指示を受け付けません
id が名前ではありません
待機中
ドローン自身の動きと合いません
ここは低速で飛ぶ区域です
{d} m/s より速く動いています
ドローンがいられる位置から離れすぎています
古すぎます
地図のはるか外です
場所も目標もありません
静止中に {d} m 動いたことになっています。別の物体ではありませんか？ドローンを持ち上げて位置を示してください
飛行中なのに値がまったく変わりません
未来の時刻に検出されています
確信度が 0〜1 の範囲にありません
自身の動きが疑わしいです
大きさが不正です（最大 {d} m）
超音波がどこでも反応しています
時刻が前のものより新しくありません
時刻が未来です
ここに着陸
それでも着陸します：{why}
安全のため着陸します
ここに着陸します
{n}秒たっても着陸が確認されません。要求を続けます
{d} m 横に着陸します
非常停止を解除
look_at が室内の位置ではありません
look_s が不正です
確認が終わりました。戻ります
確認中
下を確認しています
モーター停止
モーターは停止しています
手動で移動中
{who} が手動で移動中
手動での移動が終わりました
手動で移動中：{why}
横へ移動しています
自身の動きを頼りに {d} m 横へ移動して着陸します
2 m 以内に着陸できる場所がありません。自身の動きを頼りに待機します
2 m 以内に着陸できる場所がありません。空中で待ちます
{n}秒間指示がないため戻ります
{name} という場所はありません。{place} ですか？登録済みの場所：{places}
{name} という場所はありません。登録済みの場所：{places}
戻る経路がないため、ここに着陸します：{why}
パッドからの経路がありません：{end} {place}
ドローンの制限内でそこへ飛ぶ方法がありません
近づく人がいなくなりました。元の位置へ戻ります
有限でない数値があります
着陸しません：{why}
着陸しません：{why}。それでもここに着陸するには「着陸」を押してください
{name} に書き込めません（{why}）
手動での移動
障害物は使えません：{why}
地上にいます
指示されたため
place が名前ではありません
戻っています
sender が名前ではありません
誰か
ドローンの上に何かあります。上が空いた所へ運んでください
この下で何かが見つかっています
パッドに高さ {d} m の物があるようです。空いていますか？
下に高さ {d} m の物があるようです
床から {d} m の高さにいます。何かの上です
離陸した所より {d} m 高い所にいます。何かの上です
ここに留まる
停止
離陸してから実行します
バッテリー不足です：{p}%、往復（{n}秒）には {q}% 必要です。充電してください
ドローンが確認しませんでした：{what}
ドローンが自身の動きを伝えません
ドローンはすでに飛行中です
モーターを切ったのに飛んでいます。着陸します
移動中です。先に「ホバリング」を押してください
ドローンは非常停止状態です。モーターは停止しています
指示なしで空中にいます。その場に留まります
ドローンは着陸中です
ドローンは地上にいます
ドローンはすでに離陸中です
速すぎてそこへ曲がれません。先に停止させてください
ドローンが自動で着陸しています
ドローンの警告：{what}
ドローンの警告：{what}。着陸します
ドローンが飛行禁止区域にあります。外へ運んでください
地上で動かされました。位置計測をやり直します
超音波がどこでも反応しています。位置計測の高さで着陸します
前方は飛行できる範囲の端です
目的地
{who} の最後の位置はもう空けていません
指示：{what}。許容範囲：{limit}
姿勢が単位四元数ではありません
{who} の発着台があります
操縦プログラムが異常終了しました（{name}）。着陸します
現在地
経路が空きました。続けます
経路がふさがったままです
同時に {n}個を超えています
経路がありました。続けます
行き先がありません
1 秒間の指示が多すぎます
時間がかかりすぎました
位置計測の一部だけを使っています。最近の {m} 回のうち {n} 回は使えません：{why}
位置計測を {n}秒間信用していません：{why}
velocity が不正です
ここで待ちます：{why}
{asked}（{who}）：{what}
{asked} {place}
{asked}：{what}
{end}が位置ではありません：{place}
{end} {place} は障害物に近すぎます
{end} {place} は障害物に近すぎます（{d} m）
{end} {place} は障害物に近すぎます：機体から {d} m、必要なのは {m} m です
{end} {place} は飛行禁止区域内です
{end} {place} は障害物の中です
{end} {place} は地図の外です
{end} {place} は部屋の外です
{d} m 前方で {thing} が経路をふさいでいます
{thing} が経路上にあるため、よけて進みます
{thing} が近くにあります
時間がかかりすぎました：{what}
{who} が近づいています
{who} が近づいていますが、よける場所がありません
{who} が近づいていますが、よける場所がないため、ここに着陸します
{who} が近づいているため、よけます
{who} が近づいたため、離陸を中止しました
飛行中の {who} が見えなくなりました。最後の位置を空けておきます
{who} の指示が多すぎます：1 秒間に {n}件を拒否しました（上限 {m}件）
{who} が下にいます
{who} が経路に入ったため、よけて進みます
{who} が経路に入ったため、待ちます
{who}：{why}
{why}（可能になりしだい：{what}）
{why}、{d} ミリ秒の遅れ
{why}、{more}
{why}。ここに着陸します
{why}。停止します
{why}。ドローンの周りを空けてください
{why}：{found}（条件：{limit}）。考えられる原因：{cause}（{value}）。{mend}
{why}：{found}。{mend}
{why}。最も近い空いた位置：({x}, {y}) m
{why}。戻る経路がないため、ここで待ちます：{more}
{why}。先へ進む経路がないため、ここで待ちます：{more}
{link} からブラウザが入りました：{what}
別のタブが独自の接続を使っています
すべての操作ができます
飛行の操作ができます
閲覧だけできます
閲覧と質問ができます
経路を問い合わせられません：{why}
誰も操縦していません。先に操縦を引き受けてください
先に接続を始めてください
コンソールが再起動しました。その間の出来事は記録にありません
端末のリンク
{who} が作ったリンク
この指示に場所や目的地は要りません：{asked}
あなたの役割は {name} ですが、{what} が必要です。Houseflyの管理者に頼んでください
{who} が {name} に操縦を渡しました
{who} が操縦中です
{who} が操縦をやめました
{who} は飛行の権限がなくなり、操縦を失いました
{who} が場所と区域を保存しました
{who} が操縦を引き受けました
{who} が場所と区域の変更を取り消しました
{who} から{n}秒間応答がなく、操縦を失いました。いまは誰も操縦していません
{who}：{what}（自動操縦の応答がありません）
場所や物を見る
よく見える所まで飛び、写真を撮って戻ります。
物の場所
記憶にある場所を答え、古いか不確かなら見に行きます。
見回り
各場所を順に見て写真を撮り、前回との違いを知らせます。
夜の見回り
静かに一度ずつ見て回り、異常だけを知らせます。
玄関に誰がいるか見る
玄関へ飛び、来た人を撮影して皆に知らせます。
周りを見る
離陸した所か選んだ場所で、全方向の写真を撮ります。
異常はありませんか
皆の様子を知らせ、転倒や夜の離床を見に行きます。
中身の確認
棚と冷蔵庫の中身を知らせ、それぞれ写真を撮ります。
人を追う
しばらく人を映し続け、見失えば探してから戻ります。
なくした物を探す
ありそうな所を見て写真で確認し、見ていない所を知らせます。
人のところへ行く
人のところへ飛び、向き合って待ちます。指示かしばらくのあと戻ります。
見るもの
見る時間
それぞれを見る時間
見る場所（この順）
見る場所（この順）。whole floor は床全体
来客の立つ場所
そこで待つ時間
そこで待つ時間
時間
写真の枚数
物か人
なくした物
そのうち1人だけ
見に行くとき
古いとみなす時間
写真ごとの返事を待つ時間
全体の時間
場所。なければパッドの上
誰を。anybody は一番近い人
誰に。anybody は一番近い人
夜に切っておく物
名前（カンマ区切り）
{name}に接続しましたが、応答がありません
{name}に接続しましたが、測定値が届きません
{name}に接続しましたが、新しい値が届きません。{what}は動作中ですか、一時停止していませんか
新しいドライバーが飛行中に見つけました。停止飛行と着陸だけをします
{name}から届く値の時刻が止まっています。{what}は一時停止中ですか
データは{name}から届いていません。tracking.addressを{other}にしてください
単位がミリメートルではありませんか。計測ソフトでメートルを選んでください
時計が{n}秒進んでいます。届いた時刻を使います
時計が{n}秒遅れています。届いた時刻を使います
{name}でMQTTブローカーが応答しません。動作中ですか（mosquitto）、mqtt.portは正しいですか
物体が見えません。位置計測は動作中ですか
{name}で{n}秒以内にドローンが応答しません。電源は入っていますか、ドローンのWi-Fiに接続していますか
{name}で応答がありません。電源は入っていますか、このネットワークにありますか
{name}で応答がありません。{what}は動作中で、送信していますか
受信されていません。perceptionプロセスは動作中ですか
{name}にまだ接続していません
まだ応答なし。通常は{k}秒以内ごとに送信します
{name}から何も届きません
オフラインです。電源は入っていますか、ネットワークに届いていますか
位置を受け付けません。{pose}：{ask}
毎秒{n}件を超えて送信しています。残りは捨てます
{n}秒間応答なし。通常は{k}秒以内ごとに送信します
{n}個を超える物を報告しています
{name}のMQTTブローカーに拒否されました（{error}）
{name}のMQTTブローカーに拒否されました。mqtt.usernameとmqtt.password_fileを確認してください
{name}との接続が切れました
ドライバーのプロセスが応答しません（記録：driver.log）
ドローンが制限値をまだ確認していません
ドローンから応答がありません。電源は入っていますか
ドローンの{setting}が{wanted}ではなく{kept}のままです
自動操縦の応答がありません
部屋のプロセスが応答しません（記録：room.log）
{name}の応答は{protocol}ではありません（{error}）
{name}は毎秒{n}件を超えて送信しています。残りは捨てます
{name}はy軸が上です。計測ソフトでz軸を上にしてください
{name}：深度画像がありません
{name}：読み取れません（{error}）
「{title}」が使用中です
「{title}」はここから開始できません
「{title}」がドローンを引き継ぎました
{who}が依頼しました
「{title}」で飛びますか。{why}。
「{title}」を続けますか。{why}。
「{title}」を始めますか。{why}。
長く待ちました
プログラムが再起動しました
より急ぐ用事がドローンを引き継ぎました
誰か
人が操縦しています
開始前に人が指示しました
手順に失敗しました
手順が中断しました（{error}）。記録を見てください
{who}も依頼しました
試算できないため（{why}）、飛びません
期限までに始められませんでした
次の番です
何を見るのか分かりません
試算しています
{time}、電池{p}%が必要ですが、帰りの分を除くと残り{q}%です
中止されました
パッドから{d} m離れて着陸します
期限を過ぎています
誰も見えません
期限までに承認がありませんでした
{time}で終わりません
まだ確認していません
飛びません
地上で準備完了
ほかの用事を実行中です
ドローンは準備中です
この用事が指示していない動作です：{phase}
ドローンが{thing}に触れます
モーターが停止しています（落下または緊急停止）
自動操縦が応答しません
離陸できるかまだ分かりません
飛行中にプログラムが終了しました。新しい指示があるまで再開しません
実行中にプログラムが終了しました
順番待ちがいっぱいで外れました
順番待ちがいっぱいで、「{title}」に譲りました
用事の管理が始まったばかりです
前に{n}件
{who}の用事が{n}件待っています。答えるか中止してください
{n}件待っています。中止するか、後で依頼してください
{what}が{n}秒を超えました
{what}：{why}
{who}が中止しました
{who}が再開しました
{who}が一時停止しました
{who}が断りました
{who}が承認しました
{who}が操縦を引き継ぎました：{what}
完了
用事に時間がかかりすぎました`.split(`
`).map((e,o)=>[t.substr(5*o,5),e]));var a={"STOP FAILED":"STOP 未達",STOPPED:"STOP 停止中","STOP sent":"STOP 送信済み","When this page last heard: {words}":"最後の受信時：{words}","sending …":"送信中…","hover at once and stay":"停止：すぐその場で静止",Space:"スペース",Resume:"再開","Resume after STOP":"STOPのあと再開",hold:"長押し","not ready":"準備中","Cut motors":"モーター遮断","Cut motors: motors stop, drone falls":"モーター遮断：モーターが止まり、落下します","it falls, hold 1 s":"落下します・1秒長押し",Reset:"リセット","Reset after a cut":"遮断のあとのリセット","Take off":"離陸",Land:"着陸","Land here":"ここに着陸",Hover:"ホバリング","Stay where it is":"その場で静止",Home:"ホームへ","Fly home":"ホームへ戻る","Fly home and land":"ホームへ戻って着陸","Fly there and stay":"そこへ飛んで待機","Look there and come back":"そこを見て戻る","Look at {place} and come back":"{place}を見て戻る","Look and come back":"見て戻る","Choose where to look":"見る場所を選ぶ","Not ready: see why":"準備できていません：理由を見る","No contact":"通信なし",More:"その他","More orders":"その他の操作",Orders:"操作",Close:"閉じる","{label}: hold {n} s":"{label}：{n}秒長押し","Hold it for {n} s: a tap does nothing.":"{n}秒間長押ししてください。軽く触れるだけでは動きません。","Hold Enter.":"Enterキーを長押ししてください。",Places:"場所","Where to?":"どこへ行きますか","Point {x}, {y} m":"地点 {x}, {y} m","Forget this goal":"この目的地を取り消す","The path keeps {d} m away from everything.":"経路は周囲から {d} m 以上離れています。","The goal was moved {d} m, to the nearest free point.":"目的地を {d} m 動かし、最も近い空いた場所にしました。","Looking for a path …":"経路を探しています…","Choose a place, or point on the map.":"場所を選ぶか、地図を押してください。","The battery is too low for a flight.":"バッテリー残量が足りず、飛べません。","No contact with the server.":"サーバーと通信できません。","No contact with the pilot.":"自動操縦と通信できません。","No contact with the server":"サーバーと通信なし","Opened in another tab":"別のタブで表示中","this one only watches the past":"このタブの表示は過去のものです","Session ended":"セッション終了","use a fresh link":"新しいリンクを使ってください",Connecting:"接続中","for {n} s":"{n}秒間","Waiting for the pilot":"自動操縦を待っています","This console was opened in another tab; that one is live.":"この画面は別のタブで開かれました。そちらが現在の表示です。","This browser's session has ended. Ask for a fresh link.":"このブラウザーのセッションは終了しました。新しいリンクをもらってください。","No contact with the server: nothing is known of the drone.":"サーバーと通信できません。ドローンの状態は不明です。","No word from the server for {n} s: what is shown is of then.":"サーバーから{n}秒間応答がありません。表示はその時点のものです。","What held then: {then}. STOP from this page may not arrive.":"その時点の予定：{then}。この画面のSTOPは届かないことがあります。","Not known: no contact with the server":"不明：サーバーと通信できません","In flight":"飛行中","Not ready: {why}":"準備できていません：{why}",Ready:"準備完了",more:"詳細","{n} check|{n} checks":"点検 {n}件","Checks before take-off":"離陸前の点検","Before take-off":"離陸前","If contact is lost now:":"いま通信が切れると：","As contact was lost:":"通信が切れたとき：","If contact is lost:":"通信が切れると：","no take-off":"離陸できません",look:"確認が必要",well:"良好","What is to be mended":"直すところ","{who} has control. You watch.":"{who} が操縦中です。あなたは見学中です。","Nobody has control: take it first.":"操縦者がいません。先に操縦権を取ってください。","You lost control; {who} has it now":"操縦権を失いました。いまは {who} が操縦中です","This page was silent and lost control; nobody has it: take it again":"この画面の応答が途切れ、操縦権を失いました。操縦者がいません。もう一度取ってください","You have control":"あなたが操縦中","{who} has control":"{who} が操縦中","has control":"操縦中","Take control":"操縦する","Take over":"引き継ぐ","Take over control":"操縦を引き継ぐ","Release control":"操縦をやめる","Hand over":"譲る","You watch.":"見学中です。","{who} has control; STOP and Land work.":"{who} が操縦中。STOPと着陸は使えます。",Control:"操縦","One person has control.":"操縦できるのは1人です。","Everybody else watches, and can still stop or land the drone.":"ほかの人は見学です。停止と着陸は誰でもできます。","Your name":"あなたの名前","Viewer {n}":"閲覧者 {n}","(you)":"（あなた）",Invite:"招待",Live:"現在",Tasks:"用事",Screens:"画面","Round trip between this browser and the server":"このブラウザーとサーバーの往復時間","lag {time}":"遅れ {time}","battery {p}":"電池 {p}","{site} · mode {mode}":"{site}・モード {mode}",Ask:"聞く",Details:"詳細",Keys:"キー操作","Drone and house":"ドローンと家",Battery:"バッテリー","Battery unknown":"バッテリー残量は不明","{p} to land":"着陸用 {p}","{p} to come home":"帰還用 {p}","{p} usable":"使える残量 {p}","about {time} of flight":"飛行 約{time}","land {p}":"着陸 {p}","home {p}":"帰還 {p}","usable {p}":"使用可 {p}","Event log":"できごとの記録",Log:"記録","Which lines":"表示する行","all^lines":"すべて","drone^lines":"ドローン","room^lines":"部屋","warnings^lines":"警告","Show the room as it was then":"そのときの部屋を表示","Only of":"対象",everything:"すべて",info:"情報",warning:"警告",fault:"異常",now:"いま","{n} days ago":"{n}日前","{n} h ago":"{n}時間前","{n} min ago":"{n}分前","{n} s ago":"{n}秒前","by {name}":"（{name}による）",Tracking:"位置計測",Drone:"ドローン",Picture:"映像","Pilot loop":"制御周期",Delays:"遅れ",Filter:"フィルター",Push:"外力",Position:"位置",Motion:"動き",State:"状態","p99 {d} ms late · {n} missed":"p99 遅れ {d} ms・欠落 {n}","tracking {one} · command {other}":"計測 {one}・指令 {other}","{one} · height {other}":"{one}・高さ {other}","{d} m/s² · load {p}":"{d} m/s²・負荷 {p}","{state} · safety {mode}":"{state}・安全 {mode}","by itself":"自然に終わります","once it stands":"着地まで","a fresh order on the ground":"地上で次の指示まで","a reset":"リセットまで","nothing yet":"まだありません",Sensors:"センサー","none heard yet":"まだ受信なし","{n} of {all} needs a look|{n} of {all} need a look":"{all}個中 {n}個を確認してください","all is kept":"すべて保存されています","all {n} are well":"{n}個すべて良好",memory:"記憶","never heard":"受信なし",Layers:"表示","People and things":"人と物","Safety margins":"安全距離","Tracking coverage":"計測できる範囲","Edit the room":"部屋を編集","number: how many of {n} cameras see {d} m above the floor;":"数字：{n}台のうち床上 {d} m が見えるカメラの数","hatched: fewer than {n}, no tracking":"斜線：{n}台未満、計測できません","The past":"過去","Fetching the past":"過去を読み込み中","Back to now":"いまに戻る","Shift + Esc, held 1 s":"Shift + Esc を1秒長押し","Arrow keys":"矢印キー","Enter, held":"Enter を長押し",L:"L",H:"H",M:"M",R:"R",T:"T","?":"?",Esc:"Esc","STOP: hover at once; in flight whatever has the focus":"STOP：すぐその場で静止。飛行中はいつでも効きます","Cut motors: the drone falls":"モーター遮断：ドローンは落下します","Move the goal by one cell":"目的地を1マス動かす","Send the drone to look and come back":"見に行って戻らせる","Swap map and picture":"地図と映像を入れ替え","Edit the room, and back":"部屋の編集、もう一度で戻る","Go to the tasks, and back":"用事の画面、もう一度で戻る","Show or hide this list":"この一覧の表示・非表示","Close a panel":"パネルを閉じる","Space stops the drone even while you type, as long as it flies.":"飛行中は、文字の入力中でもスペースキーで停止します。","On the ground it types a space, or presses the button that has the focus.":"地上では空白を入力するか、選択中のボタンを押します。","Letters and ? are keys":"文字キーと ? で操作する","Where is, go to":"どこにある、行って","Where is … / go to …":"…はどこ／…へ行って","Close the answer":"答えを閉じる","At {time}:":"{time} の時点：","Fly there and look":"飛んで見に行く","Choose it as the goal":"目的地にする","Look there":"見に行く","Nobody knows where that is.":"どこにあるか分かりません。","Go to {place}":"{place}へ行って","Where is {thing}":"{thing}はどこ",Doorbell:"呼び鈴","The bell rings.":"呼び鈴が鳴っています。","The bell rings. Hold to fly there and look; it comes home by itself.":"呼び鈴が鳴っています。長押しすると見に行き、自動で戻ります。","Look who is at {place}":"{place}に誰がいるか見る","Look^order":"見る",Ignore:"無視",door:"玄関","Someone at the {place}":"{place}に誰か来ています","This device":"この端末","Ring for the doorbell and for faults":"呼び鈴と異常のとき鳴らす","Install as an app":"アプリとして追加","As an app: Share, then Add to Home Screen.":"アプリにするには：共有から「ホーム画面に追加」。","This browser does not keep the screen on while the drone flies.":"このブラウザーでは、飛行中に画面が消えることがあります。","It sounds while the page is open.":"画面を開いている間、音が鳴ります。","It sounds from your next touch on, while the page is open.":"次に画面に触れてから、開いている間、音が鳴ります。","It notifies beside other pages.":"ほかの画面を見ていても通知します。","Notifications are forbidden: its settings in the browser allow them.":"通知は禁止されています。ブラウザーの設定で許可できます。","Housefly: look at the drone":"Housefly：ドローンを確認してください",Watch:"見る",Fly:"飛ばす","may see everything, and STOP or land the drone":"すべて見られ、停止と着陸ができます","may watch and ask; a flight waits for your yes":"見ることと頼むことができます。飛行にはあなたの承認が必要です","may take control and fly":"操縦して飛ばせます","What the guest may do":"招待した人ができること","No link could be made.":"リンクを作れませんでした。","Your role is “{role}”: ask who runs Housefly for a link.":"あなたの役割は「{role}」です。リンクは管理者に頼んでください。","What may the other one do? STOP is for everybody.":"相手に何を許しますか。STOPは誰でも使えます。","The link was used: the guest {may}.":"リンクは使われました。開いた人は{may}。","The link expired: make a new one.":"リンクの期限が切れました。新しく作ってください。","The first to open it {may}. It works once, for:":"最初に開いた人は{may}。1回だけ使えます。残り：","Only this machine reaches the console.":"この画面はこの機器からしか開けません。","For a phone, restart with:":"スマートフォンで使うには、Houseflyを終了し、次のように起動してください：","QR code of the link":"リンクのQRコード",Copied:"コピーしました","Copy link":"リンクをコピー",Share:"共有","Ask for something":"頼む","Look at the entrance, where is the cup …":"玄関を見て、コップはどこ…","“{words}”, answered {age}":"「{words}」の答え、{age}","Yes, do it":"はい、実行","The services are not running.":"サービスが動いていません。","The services are not running: nothing can be asked for now.":"サービスが動いていません。いまは何も頼めません。","What is shown here is what was known {age}.":"ここの表示は{age}のものです。","services not running":"サービス停止中","Simulated doorbell":"模擬の呼び鈴","Ring the doorbell":"呼び鈴を鳴らす","This room is simulated: press, and a visitor comes to the door.":"この部屋は模擬です。押すと玄関に来客があります。","What can be done":"できること",Services:"サービス","Not known yet.":"まだ分かりません。","Say first: {what}.":"先に指定してください：{what}。",Start:"実行","Start: {title}":"実行：{title}",Rehearse:"試算","Rehearsing …":"試算中…",Questions:"質問","{n} more question|{n} more questions":"ほかに質問 {n}件","Question of task {n}":"用事 {n} の質問","Without an answer it counts as “{choice}” in {time}.":"返事がなければ {time} 後に「{choice}」とします。",Now:"いま","Nothing is asked for.":"頼まれている用事はありません。","Task {n}":"用事 {n}","{words}: task {n}":"{words}：用事 {n}",Pause:"一時停止","Go on":"続ける",Cancel:"取り消し",Steps:"手順","waiting for a yes":"承認待ち",queued:"順番待ち",running:"実行中",paused:"一時停止中",suspended:"中断中",waiting:"待機中",skipped:"省略",done:"完了",failed:"失敗",cancelled:"取り消し済み",refused:"拒否",expired:"期限切れ","asked for by {who}":"{who} が依頼","asked for":"依頼",", because of {cause}":"、きっかけ：{cause}","in the console":"（画面から）","on the command line":"（コマンドから）","over HTTP":"（HTTPから）","over MQTT":"（MQTTから）","by a webhook":"（Webhookから）","by an assistant":"（音声アシスタントから）","by a rule":"（自動ルール）","The bell rings":"呼び鈴が鳴っています","Somebody may have fallen":"誰か倒れたかもしれません","Who walks there may close the way for a moment: ask again when it is free.":"人が通って一時的にふさがっているかもしれません。空いたらもう一度頼んでください。",yes:"はい",no:"いいえ","What was":"これまで",History:"履歴",Clips:"動画",Rules:"ルール","No task has ended yet.":"終わった用事はまだありません。","Older tasks":"以前の用事","that is all":"これですべてです",Trigger:"きっかけ",Decision:"判断","It was not rehearsed.":"試算していません。",Flight:"飛行","{time}, in the air for {span}.":"{time}、飛行時間 {span}。","It did not begin.":"始まりませんでした。","It did not fly.":"飛びませんでした。","Recorded:":"記録：",Outcome:"結果","None.":"ありません。","None is kept any more.":"もう残っていません。",Clip:"動画","Show clip, {time}":"動画を見る、{time}","Show snapshot":"写真を見る",Save:"保存","Save all":"すべて保存","Save all of these":"これらをすべて保存","Picture of {title}":"{title}の写真","Clip of {title}":"{title}の動画","This clip is gone, or this browser cannot show it.":"この動画はもうないか、このブラウザーでは再生できません。",Keep:"残す","Keep no longer than others":"ほかと同じ期間だけ残す",Delete:"削除","Delete this clip":"この動画を削除",When:"日時",Place:"場所",Thing:"物",People:"人",For:"用事","Because of":"きっかけ",End:"終わり",Privacy:"プライバシー",Kept:"保存期間",Size:"大きさ","{service}, task {n}":"{service}、用事 {n}","missing: a crash or a full disk cut it off":"途中まで：異常終了か容量不足で切れました","a part of the picture is blank, as the site says":"設定により映像の一部を隠しています","until somebody deletes it":"削除するまで","until {time}":"{time} まで","Which clips":"表示する動画",person:"人",place:"場所",thing:"物",time:"時期",any:"指定なし","any time":"いつでも",today:"今日","this week":"この1週間","this month":"この1か月","{n} or more clips.":"動画 {n}件以上。","{n} clip.|{n} clips.":"動画 {n}件。","There is no such clip.":"該当する動画はありません。",snapshot:"写真","cut off":"途中まで","Older clips":"以前の動画","There is no rule.":"ルールはありません。","(off)":"（無効）","What would have happened last week?":"先週ならどうなったか","What the rules would have done":"ルールが行ったはずのこと","Nothing.":"何もありません。","Mode of the house":"家のモード",Mode:"モード","home^mode":"在宅","away^mode":"外出","night^mode":"夜間","privacy^mode":"プライバシー","maintenance^mode":"整備",recording:"録画中","Taken by":"撮影","First steps":"はじめに","Choose a place on the map, or ask above.":"地図で場所を選ぶか、上の欄で聞いてください。","Hold the large button to fly.":"大きなボタンを長押しすると飛びます。","STOP stops at once. It works for everybody, at any time.":"STOPを押すとすぐ止まります。誰でも、いつでも使えます。",OK:"OK","Close the hints":"説明を閉じる","Show the first steps again":"使い方をもう一度見る","Waiting for the room":"部屋の情報を待っています","Map of the room":"部屋の地図","Floor plan with the drone. Arrow keys move the goal; a list of places follows.":"ドローンのいる間取り図。矢印キーで目的地を動かします。続いて場所の一覧があります。",Legend:"凡例","People and things are not shown: {why}.":"人と物は表示していません：{why}。","kept free by order":"飛行禁止の場所","too close to fly":"近すぎて飛べない場所","{n} in the way that no map knows":"地図にない障害物 {n}個","{p} sure":"確かさ {p}","told before":"以前の情報","Place unknown: {names}":"場所不明：{names}","{name} (in {holder})":"{name}（{holder}の中）","height {d} m, no curve is flown":"高さ {d} m、曲線飛行なし","height unknown":"高さ不明","{low} to {high} m":"{low}～{high} m","height {heights} over {length} m in {n} s, up to {fastest} m/s":"高さ {heights}、{length} m を{n}秒、最高 {fastest} m/s","± {one} in the plane, ± {other} in height":"水平 ± {one}、高さ ± {other}","; stops in {d} m":"、停止まで {d} m","Height unknown":"高さ不明","Height {d} metres":"高さ {d} メートル","Flight height":"飛行高度","0 to {d} m/s, a dot each second":"0～{d} m/s、点は1秒ごと","stops here if it brakes now":"いま止まるとここで停止","Zoom of the map":"地図の拡大・縮小","Zoom in":"拡大","Zoom in (+)":"拡大（+）","Zoom out":"縮小","Zoom out (-)":"縮小（-）","Whole room":"部屋全体","Whole room (0)":"部屋全体（0）","The drone is out of view: show it":"ドローンは画面の外です：表示する","Show the drone":"ドローンを表示",Time:"時間","Live again: {why}":"現在に戻りました：{why}","Back to live":"現在に戻る","● Live":"● 現在","Time shown":"表示する時刻","How far back":"さかのぼる長さ","10 min":"10分","1 h":"1時間","6 h":"6時間","1 day":"1日","1 week":"1週間","Flight at {time}, {span} long":"{time} の飛行、{span}","Flight at {time} to {goal}, {span} long":"{time} の飛行、{goal}へ、{span}",", with warnings":"、警告あり",", with faults":"、異常あり","{name}: look at it again":"{name}：もう一度見る",Play:"再生","How fast":"再生の速さ","Moment of the recording":"記録の時点","{time} of {span}":"{time} / {span}","Recorded, not live":"記録です・現在ではありません",Recorded:"記録","Log, recorded":"記録（過去）","Log of the recording":"記録のできごと","Recorded picture":"記録の映像","No picture of this moment was kept.":"この時点の映像は残っていません。","nobody saw the drone":"ドローンは見えていません","{high} m high, {fast} m/s, battery {p}":"高さ {high} m、{fast} m/s、電池 {p}","The drone may be in the air: what is live stays on the screen.":"ドローンが飛行中かもしれません。現在の表示を続けます。","the drone may be in the air":"ドローンが飛行中かもしれません","a goal was chosen":"目的地が選ばれました","STOP was pressed":"STOPが押されました","never seen":"未確認","has {names}":"所持：{names}","in it: {names}":"中身：{names}","idle^phase":"待機","taking off^phase":"離陸","flying to goal^phase":"往路","looking^phase":"確認","holding^phase":"ホバリング","returning^phase":"帰還","landing^phase":"着陸","The view in space could not be fetched: no contact with the server.":"立体表示を読み込めません。サーバーと通信できません。","Fetching the view in space …":"立体表示を読み込み中…",Plan:"平面","3-D":"立体","The room in space":"部屋の立体表示","This browser cannot draw in space (WebGL is off or missing). The plan shows the same.":"このブラウザーでは立体表示ができません（WebGLが無効）。平面図でも同じ内容が見られます。","Recorded, not live.":"記録です・現在ではありません。","Nobody sees the drone.":"ドローンが見えません。","The drone was seen {time} ago.":"ドローンを見たのは {time} 前です。","Drag to turn, two fingers or the wheel to come nearer.":"ドラッグで回転、二本指かホイールで拡大。","People are where they were last seen; pale is long ago.":"人は最後に見えた場所にいます。薄いほど前です。","Picture from the drone":"ドローンの映像","No picture yet":"映像はまだありません","No new picture for {time}":"{time} 新しい映像がありません","Make the map large, or small again":"地図を大きく、または元に戻す","Make the picture large, or small again":"映像を大きく、または元に戻す","Swap (M)":"入れ替え（M）","No services run here, and only they keep pictures: nothing was kept.":"サービスが動いていないため、写真を保存できませんでした。","Nothing was kept.":"何も保存されませんでした。","Keep this picture as a photo":"この映像を写真として保存",Snap:"撮影","Photo kept":"写真を保存しました","in Tasks, Clips.":"「用事」の「動画」にあります。","in Tasks, Clips, until {date}.":"「用事」の「動画」に {date} まであります。",Show:"表示","Map being edited":"編集中の地図","Floor plan being edited. The list of places and zones follows.":"編集中の間取り図。続いて場所と区域の一覧があります。","too close":"近すぎる場所","Tap the map for a new place, drag on it for a new zone, or:":"地図を押すと新しい場所、ドラッグすると新しい区域。または：","Tap or drag on the map to move what is open; Done when it is right.":"地図を押すかドラッグして動かし、よければ「完了」。","Drag on the map to draw the open zone again; Done when it is right.":"地図をドラッグして区域を描き直し、よければ「完了」。","Edit places and zones":"場所と区域の編集","Places and no-fly zones":"場所と飛行禁止区域","version {n}":"第{n}版","version {n}, by {who}":"第{n}版、{who}","never edited":"未編集","Add a place":"場所を追加","Add a zone":"区域を追加","Places and zones":"場所と区域","new place":"新しい場所","new zone":"新しい区域","where it starts and lands":"離着陸する場所","Not saved yet.":"まだ保存していません。","The drone keeps the map that it started with.":"ドローンは起動時の地図のままです。","What is saved here counts from the next start of Housefly on.":"保存した内容は、次にHouseflyを起動したときから有効です。","What is saved here counts from the next start on, or as soon as you use it after Save.":"保存した内容は、次にHouseflyを起動したとき、または保存後「すぐ使う」を選んだときから有効です。",Discard:"破棄",Undo:"元に戻す","Go back to the version before":"前の版に戻す",Remove:"削除","Remove {name}":"{name}を削除",Done:"完了",Name:"名前","Reading corner":"読書コーナー","In commands: {name}":"コマンドでの名前：{name}","Hovers at [m]":"ホバリング位置 [m]","Looks at [m]":"見る位置 [m]",height:"高さ","on map":"地図で","x from":"x 始点","y from":"y 始点","x to":"x 終点","y to":"y 終点",Reason:"理由","Wet floor":"床がぬれている","Kept free [m]":"飛行禁止 [m]","These changes were not saved before. Save or Discard them.":"前回保存していない変更があります。保存するか破棄してください。","{who} has control, and only who has control may change the room.":"{who} が操縦中です。部屋を変更できるのは操縦者だけです。","Take control first: only who has control may change the room.":"先に操縦権を取ってください。部屋を変更できるのは操縦者だけです。","Give this place a name.":"この場所に名前を付けてください。","In the air the drone keeps the map that it took off with: land first.":"飛行中は離陸時の地図のままです。先に着陸してください。","Nobody knows whether the drone flies: the new map waits.":"ドローンが飛行中か分かりません。新しい地図は待機中です。","That is being done.":"実行中です。","The pilot has not come back. The terminal of Housefly says why.":"自動操縦が再起動しません。理由はHouseflyの端末に出ています。","In use: the drone has this map now.":"反映しました。ドローンはこの地図を使っています。","The pilot starts again.":"自動操縦を再起動中です。","No flight meanwhile.":"その間は飛べません。","Use it now":"すぐ使う","The pilot starts again, about {n} s. No flight meanwhile.":"自動操縦を再起動します（約{n}秒）。その間は飛べません。","Move by hand":"手動で移動","Up the map":"地図の上へ","Left on the map":"地図の左へ","Right on the map":"地図の右へ","Down the map":"地図の下へ",Climb:"上昇",Sink:"下降","Moving while you hold.":"押している間、動きます。","Hovering. Hold an arrow, W A S D or a stick.":"ホバリング中。矢印、W A S D、スティックを押し続けると動きます。","W A S D or arrows, R F":"W A S D か矢印、R F","While Move by hand is on: move the drone, up and down":"「手動で移動」中：ドローンを動かす、上下","+ − 0":"+ − 0","Map with the focus: nearer, farther, whole room":"地図を選択中：拡大、縮小、部屋全体","No drone":"ドローンなし","To add one: enabled = true under [drone] in the site file.":"追加するには、サイトファイルの [drone] に enabled = true と書いて、再起動してください。","Floor plan of the room":"部屋の間取り図"},h=["玄関に誰がいますか","誰かいますか","大丈夫ですか","今日何がありましたか"],r={texts:a,ideas:h,templates:n};export{r as JA};
