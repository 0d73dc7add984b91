import"./chunk-chunk-PVYBGDIB.js";var a=["0000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000","1007111003000102032104231019011111001000004290251011103202020020004030110372000001011003211110100040103210322750400012000100000100101120001201211110002101324301030100001402005401002210130120011022000304101300107312001010023103002204000310000201150101100001113233020600011200000102010121250030200004000101001200002031101230910111010905220214011002002132630000100100010326200850301004634010133000201430010011010063020070003200140010300020110623021205c202200024601100017200002303292310021040400502133200101001000140116100013002212000011001002333202011c0021102300000111113006002100611002121000201140b21611117021002011310532001230020210002002201111312210020101102020001301000001070001010000001003100201313100001000300252000331010021000100201201101220124121036011312401100321023","wuo97cduehc15e4x2zn15yr83iblk6m4b25rv015vsy0phg4hrb250za6d7f3bl7b7xc6lf87ccfat5ivvvbndu9kk6amire9tie0t0q5llk82l2a357uako3h1t1i4km47stc1z13ga6hhm3whxet6kcuvtsmplbradf620i1v3ffeme4qcfk40c8db83w0wq50agiq7p14t6n213toard3fgk9oggkz3v16p9kfzc9nk54a34tja3wcagl6yn1u6ijr413bg68yasgellzpr5w1ih26b157x5xl2emg05p8ehhe955709vuz45rk8jwbon78bcrrciy10d6pneqvc9erc8ss93viqejgk2h9gd9flt10mb6wt8ca63dhrln3m87864hdou3sl6g4me8p635ajvcfjdmisfe0z54ke9de674r4re26ds1r9ltbuypc8tibhapj4wm7vsl8gerrjl9050nl4ipb3gdfw49ul5j5dt7jvg6ls2theezt0sgsi1r8ebg48a10gbkqdff2jqooxgnbja0a8o623c7i17la6g9wevbe1stl89blnohp2r4t66xb1ha7jkqi86ilbut0q85dlo5nap71364hjy7qozcfj835whwyh1kgmthg2ybic6512nhjilxqnzuk7hjjjw3lm07wxkb9rz42rafifcp5gw87sdjnh3mr4ejza1dge3jwg926f113c9jxl6haafc4avfyygi2h6itzbwil1oe3o39l10o28tgr9b61","t4qztdlx29v91jd1j5bkt3mfus3rb0o005v1qhp0mb3m7lbfnruhlac6n11ekwtmsljct2p7au6pwj4shpm7lgcoq5mg742ob521s4s1y31sl42e5hpm1p63mrg0jk2a6pnhssfpq3dig5fho8krc3moe2shho8h09264ry5dr4tw465657flvp9tlnugl5vyplgmy6umh76kb3t77s48ah1blm1do26mimao64wuwurranyqyy5hi2d0vwinzqrwxhtd7dazkarjmih9nfz2x1e7uzr45kvpvtezqeko5wq4hi63rns01v470l9muhsp9gckli0mlcomi1evwfsou0ilyfjzyo053aml0wm03qtxxr54tcbqyoz7pg9l3vahpojiztk5iqchysen4e9j6xc4a5asvhtqqoc8s8ow0nu8d8aao04klsmox5khyug98f81wqjdvkv9sla5hsydm11shyjpiwaf2tzt34gk7nsg2ppyky8h6su9wfc3biiw9klxm34ddyqv4hyqeidmq1q5be6bqzg2watrwxfbik824ebrdtza1cu8pr115r5d9o4rpob4y4zq4ps9yh7dtghb3en0xc4q8t184sbi1naljdugo2pag8ndmi6ueyp4ngwxkx8dp33cx78azghorfqz26pi0267gzcp9vdkqcbs3xlvq8q0ppy92fda63936fzo29m82lpcdmxxsfd89m048jvxozzpi3eqb0vzd3dz5t0a75kpghc6vdw9em61bik","petwwdmie50itlrua2nb17pdlsj044skjl3f3qvbcg1oif8cjn6sywezpuyrgmvs5badey7kg8rkuu01cx0xtiawg8mufq97fznzpwdrvye4092db0q2vwctk8v2s91hrej6tp8nkfrtkirwqw2ie48ienss5nz9624ill99on3l43dl9xbia7eu04426sjeegxhnt8jzt5feluqw3akeobvvzti51l6cu9unhdjk80a91c4elk5owgb24glib7uqhpywmvsv3o9dqsicv2mh6h6g3hq0vlmvtlu690s03dbsk69yymfh9uf2sljrb1ctk4cskrgc9ptqrr049rtga5p8y0041sdvucvr21969o04mkxaxv84w9vya1gibvs1o507a1w0ndbtnoahh1kvcjuydfr8ayjuaxj6maqvn4qwzf46muqjnqsc655hdrv2aibzm5a6h0rx42gbcgm7zgh4pp9bkqkwpj66x7qougihs34marmbyls6b60gyvvrv0oyu65pv4iwqwnmp73yi2bqxtbez9oq80apv5lfyfgqlq2uq1dho4mdh2o7amkzo4bjz8hducjqz8xd9kwdakfbs1og5frnceizy0y5x6dndz0a98jgh2qcwkthcpzvsvvaiwq6sypum8jnou11me0xkwz07qxrqo1sbaijh1244x3a9j30imos6u9dckfwf3qavjcdfbw76loeo9s8cqwvysmfq03i13suad86m7iani5l9q1kh72kuy5yl2f85pe"],h=0,n=Object.fromEntries(`空いています
経路がありました。続けます
近くに人がおらず、壊れていないことを確かめ、「リセット」を長押ししてください
ドローンが拒否しました：{what}
id が名前ではありません
時計が{n}秒遅れています。届いた時刻を使います
{n}度傾いても動きません（限度 {m}）。何かに引っかかっています。着陸します
{name}：読み取れません（{error}）
着地しています（本人の報告）
しばらく人を映し続け、見失えば探してから戻ります。
予定と違う飛び方をすることがあります
モーターを遮断中
姿勢が単位四元数ではありません
指示がドローンに届きませんでした
位置計測の装置は動いていますか。この名前で送信していますか。遅いだけなら、必要な limits.pose_age_level を housefly gains が示します
{who} が場所と区域を保存しました
着陸中
手動で移動中
パッドから {d} m
プログラムが再起動しました
離陸した所より {d} m 高い所にいます。何かの上です
ここで待ちます：{why}
上がる場所が空いていません
自動操縦から{n}秒間応答がありません。{then}。STOPと着陸は送り続けます。
指示が古すぎます（{n}秒）。{m}秒で無効になります
ホバリングできるどの場所からも{name}が見えません：間に何かあります
モーター停止
大きさが不正です（最大 {d} m）
計測した高さが違います
{n}個を超える物を報告しています
ここは低速で飛ぶ区域です
{name}：深度画像がありません
前回の座標点検で位置計測に誤りがありました
飛行の操作ができます
バッテリー不足です：{p}%、往復（{n}秒）には {q}% 必要です。充電してください
人が立っています
来客の立つ場所
完了
{why}：{found}。{mend}
{p}% のまま変化なし
位置計測がドローンの動きと左右逆です
{who}の用事が{n}件待っています。答えるか中止してください
ドローンの制限内でそこへ飛ぶ方法がありません
状態を確認中
到着しました
誰か
着地しているのに、動いていると報告しています
{place}。次の飛行の前にリセット
ここに着陸します
見に行くとき
地上で準備完了
人が横になっています
移動
下に家具があります
[tracking] を変えてから
{name}で応答がありません。電源は入っていますか、このネットワークにありますか
順番待ちがいっぱいで、「{title}」に譲りました
確信度が 0〜1 の範囲にありません
{who} が近づいていますが、よける場所がありません
{why}、{more}
座標を点検済み
{who} が {name} に操縦を渡しました
飛びません
{why}。帰還します
実際にパッドにあるなら位置計測と地図がずれていて、壁の位置も違います
ドローンが傾いています
バッテリーは充電されています
自動操縦が{n}秒遅れました
最後は地上にいました
いいえ
パッドに水平に置いてください
すべての操作ができます
{why}状態が続いています（限度 {d} m）
自動で再起動します。待つか、実行フォルダーの記録を見てください
地上にいます
ドローンが制限値を確認していません
正しく立っています
{who} の障害物は使えません：{why}
位置計測で見えません
位置計測はまだ見つけていません
この部屋にドローンはありません。
ドローンが着地を報告していません
{n}秒早い経路が空いたので、そちらを通ります
用事の管理が始まったばかりです
{goal}へ飛行中
位置データが表示より{n}秒古いです
バッテリー残量の表示は変化しています
バッテリーが{n}秒で {p}% 減りました（限度 {q}%）
{place}。そこから離陸できます
ドローンは準備中です
バッテリーを交換するか電源を入れ直し、別の値が出てから離陸してください
{d} m
{name}との接続が切れました
{who}が断りました
{name} の空き {p}%
戻っています
各場所を順に見て写真を撮り、前回との違いを知らせます。
この部屋にドローンはありません
あなたの役割では、動画は見られますが、まとめて保存できません
誰も操縦していません。先に操縦を引き受けてください
人が見えていない恐れ：人を見るセンサーからまだ応答なし
{who} が下にいます
{what}が{n}秒を超えました
飛行中
パッドから{d} m離れて着陸します
位置計測でまだパッド上に確認されていません
安全のため帰還中です
上と周りに人も物もありません
ドローンの状態はまだ分かりません
歩いています
停止中
ドローンが応答しています
ドローンは非常停止状態です。モーターは停止しています
場所も目標もありません
床でずれる計測は、飛行中もずれます
誤りあり
毎秒{n}件を超えて送信しています。残りは捨てます
周りを見る
ディスクに書き込めません
部屋を見守っています
古いとみなす時間
{d} m 移動
{n}秒前
応答しますが、報告を送りません
{who}が依頼しました
閲覧と質問ができます
地図の外へ {d} m 出そうです
{who}が一時停止しました
離陸位置から {d} m 流され（限度 {m} m）、高さは {k} m だけです。モーターを遮断します
別の物が同じ名前でないか確認し、一度持ち上げて位置を示してください
{why}。最も近い空いた位置：({x}, {y}) m
{d} m 前方で {thing} が経路をふさいでいます
{end} {place} は障害物の中です
空中。{why}
遅れて届いたデータは、届かなかったものとして扱われます
誰も見えません
モーター遮断
ドローンの警告：{what}。着陸します
地上が沈黙しても飛び続けます
床から {d} m の高さにいます。何かの上です
よく見える所まで飛び、写真を撮って戻ります。
時間
写真ごとの返事を待つ時間
ここから実行します
バッテリー {p}%、帰還（{n}秒）に {q}% 必要です
place が名前ではありません
{who} の最後の位置はもう空けていません
棚と冷蔵庫の中身を知らせ、それぞれ写真を撮ります。
最後は{who}が手動で移動中でした
{why}。減速します
安全のため降下中
ホバリング中
モーターは停止しています
現在地
{who} が近づいています
サーバーとの通信が切れました
ほかの機体にある機能がありません
有限でない数値があります
古い飛行記録を消すか、別のディスクに移してください
地図のはるか外です
{link} からブラウザが入りました：{what}
{name} から {place} へ行ける道がありません
{name}の場所は分かりません
{who} が近づいたため、離陸を中止しました
経路がふさがったままです
最後は{goal}を確認中でした
{who}：{why}
地上
ドローンがいられる位置から離れすぎています
直前{m}秒のうち{n}秒、静止しました
バッテリー残量不足
位置計測で見えています
期限までに始められませんでした
目印のない人もセンサーで見えます
ドローンがロックされました：電源を入れ直してください
{asked} {place}
準備完了・パッド上
ドローンが自身の動きを伝えません
準備できていません：{why}。
{n}度以下
{name}から{d} m以内に、ホバリングでき計測に見える場所がありません
{name}はy軸が上です。計測ソフトでz軸を上にしてください
保持中
設定とセンサーは正常です
行き先がありません
{why}（{found}）
用事に時間がかかりすぎました
時間がかかりすぎました：{what}
最後は{goal}へ飛行中でした
{name}は毎秒{n}件を超えて送信しています。残りは捨てます
「{title}」を続けますか。{why}。
無視
ドローンと通信なし
モーターを切ったのに飛んでいます。着陸します
何かに当たったか、位置計測が飛びました：速度が急に {d} m/s 変化（限度 {m} m/s）。着陸します
安全のため静止中
ほかから操縦されています（{mode}）
変化あり
時計が{n}秒進んでいます。届いた時刻を使います
横になっています
自動操縦と通信なし
{p}%
非常停止を解除しました
前方に壁か家具があります
再開するまでホバリング
{why}。{more}
自動動作の飛行中です
数秒で終わります
自身の姿勢
パッドの周りを空けてください
{name}が見える場所への道がありません
着陸
位置計測が{n}秒間途切れています
利用者による緊急着陸
look_s が不正です
離陸後に実行します
ドローンの上に何かあります。上が空いた所へ運んでください
新しいドライバーが飛行中に見つけました。停止飛行と着陸だけをします
人が操縦しています
命令がドローンに遅れて届くか、届いていません
傾き・高さ・速度の制限値は、ほかがすべて失敗したときの守りです
ドローンはすでに飛行中です
自身の速度
ホバリング中。「再開」を長押しするまで指示を受けません
見るもの
目的地
{name} に書き込めません（{why}）
帰還と着陸に必要です
まだです
{name}でMQTTブローカーが応答しません。動作中ですか（mosquitto）、mqtt.portは正しいですか
{who}：{what}（自動操縦の応答がありません）
離陸できるかまだ分かりません
なくした物
未来の時刻に検出されています
着陸しません：{why}。それでもここに着陸するには「着陸」を押してください
位置計測と地図がずれていると、壁の位置も違います
{who} が近づいているため、よけます
家電がついています
ドローンが飛行禁止区域にあります。外へ運んでください
自動操縦と通信できません
地上。{why}
{k} コアで負荷 {n}
最後は着陸中でした
{k} コアで負荷 {n}
離陸を続けてホバリングし、{n}秒以内に自動で帰還し着陸します
ドローンはすでに離陸中です
下向きカメラと床を確認し、電源を入れ直してください
センサー基板の応答なし
モーターを遮断中です
皆の様子を知らせ、転倒や夜の離床を見に行きます。
部屋の記憶が応答しません
飛行中の {who} が見えなくなりました。最後の位置を空けておきます
{name} という場所はありません。{place} ですか？登録済みの場所：{places}
受信されていません。perceptionプロセスは動作中ですか
安全のため帰還を続け、着陸します
ドローンが{setting}をまだ知らせません
前方は飛行できる範囲の端です
残量が分かりません
手順に失敗しました
ドローンから{n}秒間応答がありません
指令が数値ではありません
前に{n}件
{why}。ドローン自身の速度も信頼できないため、水平に降下します
オフラインです。電源は入っていますか、ネットワークに届いていますか
超音波がどこでも反応しています。位置計測の高さで着陸します
目的地が部屋の外です
モーターの異常
倒れました
{name}で{n}秒以内にドローンが応答しません。電源は入っていますか、ドローンのWi-Fiに接続していますか
ベッドに人がいます
その場で床まで降下を続けます
操縦プログラムが異常終了しました（{name}）。着陸します
{thing}の下・上・中にあります
{why}、{d} ミリ秒の遅れ
「{title}」で飛びますか。{why}。
計測した高さがドローンの値と {d} m ずれています
{d} m/s で流され（限度 {m} m/s）、床から {k} m だけです。モーターを遮断します
{why}。ここに着陸します
部屋の情報がまだありません
移動中です。先に「ホバリング」を押してください
{place}。再開するまで飛びません
パッド上
ドローンがパッドにありません
送信済み。自動操縦の確認待ちです
下か横に家具または壁があります
{end} {place} は障害物に近すぎます（{d} m）
予定の高さ {m} m より {d} m 高い
{who} が操縦を引き受けました
計測位置が実際と {d} m ずれています（限度 {m} m）。原点とドローンの登録を見てください
{thing} が経路上にあるため、よけて進みます
あとで
呼び鈴が押されました
止まっている間、位置は動いていません
ドローンの{setting}が{wanted}ではなく{kept}のままです
「{title}」がドローンを引き継ぎました
安全のため着陸中です
指示どおりに飛びません
ファイルを書き込めること
{why}：{found}（条件：{limit}）。{mend}
ドローンは床にいますが、位置計測では {d} m 動いています（限度 {m} m）。飛びません
その場で着陸を続けます
壁が近いかもしれません
点へ飛ぶ
データは{name}から届いていません。tracking.addressを{other}にしてください
風にあおられています：{n}秒間、速度が {d} m/s ずれました
ドローン自身の速度が計測とも傾きとも合いません。計測をもとに着陸します
戻る経路がないため、ここに着陸します：{why}
地図の原点がまだありません
{name}の応答は{protocol}ではありません（{error}）
ドローンから応答がありません。電源は入っていますか
撮影できるのは飛行中だけです
この用事が指示していない動作です：{phase}
人がいます
人が見えていないかもしれません：センサーが{n}秒間、使える値を出していません
STOPで停止中です
{name}は画面に入りません：近すぎるか、高すぎるか、低すぎます
離陸前の点検がまだ終わっていません
見る場所（この順）
位置計測でドローンが見えません
{name}から届く値の時刻が止まっています。{what}は一時停止中ですか
モーターが遮断されています
{why}。停止します
押されています
一度 {d} m・{n}° 以内
飛行中なのに値がまったく変わりません
充電するか、バッテリーを交換してください
STOP：再開するまでホバリング
手順が中断しました（{error}）。記録を見てください
[tracking] を変える前
別のタブが独自の接続を使っています
人を追う
最大 {d} m/s、手動での移動のみ
モーター停止
位置計測の原点を床に合わせ、ドローンを登録し直してください
{p}% 以上、遠い場合はさらに必要
記憶にある場所を答え、古いか不確かなら見に行きます。
パッドに置いてください。すでにあるなら、位置計測の原点を地図と比べてください
確認中
指示によりモーターを遮断中です
ソフトウェアの異常
{why}（限度 {d} m）
残り {d} m・{n}秒
{why}。自力で静止します
自動操縦が何度も遅れています（{n}秒に{k}回）
なし
ホーム
再開
床の高さが違えば、部屋全体の高さが違います
{who}も依頼しました
モーターが停止しています（落下または緊急停止）
試算しています
最後は手動で移動中でした
{end} {place} は部屋の外です
バッテリー残量の表示が変わりませんでした
「再開」まで停止し、移動の指示を受け付けません
ドライバーのプロセスが応答しません（記録：driver.log）
{thing} が近くにあります
制限値を確認しました
ドローンの警告：{what}
STOPが届きません。サーバーと通信できません
夜の見回り
バッテリー {p}% が {q}% を下回りました
経路を問い合わせられません：{why}
{who} が経路に入ったため、よけて進みます
手動での移動
いまはできません：{why}。
ドローンがまだ応答しません。
最後まで確認し、自動で帰還し着陸します
すでに実行中です
確認済み
操縦権がありません
バッテリー表示が{n}秒間 {p}% のままです（限度 {m}秒）。時計で飛行、残り{k}秒
{n}秒間応答なし。通常は{k}秒以内ごとに送信します
古すぎます
その映像はもう残っていません
そこで待つ時間
実行中にプログラムが終了しました
モーター遮断済みです。先に「リセット」を長押ししてください。
{who}が操縦を引き継ぎました：{what}
ドローンから{n}秒間応答がありません。{then}。STOPと着陸は送り続けます。
停止中です。先に「再開」を長押ししてください。
{why}、または下に物があります。減速します
自動操縦を待っています
{d} m/s で飛行中（限度 {m} m/s）
ディスクの空きがわずかです
{n}秒以内に応答
計測した高さは正しいです
{who} の指示が多すぎます：1 秒間に {n}件を拒否しました（上限 {m}件）
{why}。先へ進む経路がないため、ここで待ちます：{more}
受け付けません（{asked}）：{why}
機首を向きに合わせてパッドに置いてください。すでにそうなら: \`housefly preflight --frames\`
障害物は使えません：{why}
{who} が操縦をやめました
{why}（可能になりしだい：{what}）
人が倒れました
空中
ドローンなし
地上、パッドから {d} m
{why}。ドローンが自力で静止します
カメラ
自身の動きを頼りに {d} m 横へ移動して着陸します
ここでは手動での移動は使えません。
位置計測を待っています
離陸中
{name}に接続しましたが、応答がありません
それを使う規則は働かず、位置計測が途切れると降下して着陸します
離陸を続け、{goal}へ飛び、{n}秒以内に自動で帰還し着陸します
着陸を続けます
自動操縦が止まると、ドローンは数秒で止まり、着陸します。通信だけが切れると、{then}
自動で戻ります
飛行中は離陸時の地図のままです。先に着陸してください
座標を未点検
最後は帰還中でした
2 m 以内に着陸できる場所がありません。空中で待ちます
何を見るのか分かりません
そこで待つ時間
STOPは押されていません
ディスクに書き込めます
バッテリー残量が足りません
安全のため戻ります
パッドから {d} m、{n}° 回転
デッキが故障しています：電源を切って確認してください
バッテリー残量が足りません：{p}%、離陸には {q}% 必要です
ドローンが異常を報告しています
下に高さ {d} m の物があるようです
時刻が未来です
位置計測の一部だけを使っています。最近の {m} 回のうち {n} 回は使えません：{why}
離陸中
{end} {place} は障害物に近すぎます
ドローンは地上にいます。
飛行時間の超過
時刻が前のものより新しくありません
手動で移動中
{goal}へ飛び続け、{n}秒以内に自動で帰還し着陸します
送った位置姿勢を使って飛びません
リセット
横へ移動しています
{why}。着陸します
近づく人がいなくなりました。元の位置へ戻ります
{time}、電池{p}%が必要ですが、帰りの分を除くと残り{q}%です
着地したドローンだけが離陸できます
単位がミリメートルではありませんか。計測ソフトでメートルを選んでください
ドローンが飛行中か分かりません
{n}秒間指示がないため戻ります
モーター遮断済み
{why}（限度 {n}秒）
ドローンが動きを報告しないため、計測を確かめられません
着陸中
位置計測を {n}秒間信用していません：{why}
最後の応答では地上にいました。自動操縦がなければ動きません
計測した向きがドローンと{n}度ずれています
{time}で終わりません
室内にいます
自身の高度
先に停止か着陸の指示が来ました
{n}度
パッドの上です。着陸します
端末のリンク
経路が空きました。続けます
なくした物を探す
人のところへ行く
手を離すとその場で静止します
地上で動かされました。位置計測をやり直します
予定の位置から {d} m ずれています
より急ぐ用事がドローンを引き継ぎました
{why}：{found}（条件：{limit}）。考えられる原因：{cause}（{value}）。{mend}
ドローンの推定位置が{d} m違います
試算できないため（{why}）、飛びません
地上、パッドから {d} m、{thing}の下・上・中
{who} が手動で移動中
{why}。戻る経路がないため、ここで待ちます：{more}
異常はありませんか
記録中は地図を変えられません。起動し直してください
分かっている異常なし
ドローンはすでにこの版を使っています
ドローン自身の動きと合いません
モーター遮断済み。近くに人がいないときにリセットしてください
{who} が自動操縦を再起動し、最新の場所と区域を反映します
先に接続を始めてください
人を部屋に入れないか、スキャナーか深度カメラを追加してください
{end}が位置ではありません：{place}
準備できていません
人が座っています
毎秒{d} m以下
ここに留まる
目的地
最後は離陸中でした
ここで待機します：{why}
ドローンが応答しません
異常の報告はありません
STOPは受け付けられませんでした
自動操縦が応答しません
着地
ドローンは着陸中です
部屋のプロセスが応答しません（記録：room.log）
超音波の応答なし
最後の応答では空中でした。着陸を指示しています。通信が切れると自動で着陸します
{end} {place} は飛行禁止区域内です
不明
{n}秒たっても着陸が確認されません。要求を続けます
強風
指示なしで空中にいます。その場に留まります
離陸した所か場所で、全方向の写真を撮ります。
ホバリング
静かに一度ずつ見て回り、異常だけを知らせます。
高さ {d} m を超えました
飛行中にプログラムが終了しました。新しい指示があるまで再開しません
安全のため帰還中
位置計測でパッド上に確認済み
確認
場所や物を見る
指示の受け付けを再開します
物か人
{who} が操縦中です
モーターを切る
はい
操作が多すぎます。少し待ってください
動きが指令と {d} m/s 以上違います
ありそうな所を見て写真で確認し、見ていない所を知らせます。
非常停止中で近くに人がいなければ「リセット」を押してください
その人はもういないか、操縦できません
全体の時間
不明
誰か
{n}秒以内
名前（カンマ区切り）
{name}にまだ接続していません
ドローンを待っています
手動での移動
ドローンの{setting}を{allowed}に設定してください（現在{value}）：{why}
押されていません
位置を受け付けません。{pose}：{ask}
自律ホバリング
人が歩いています
写真の枚数
パッドからの経路がありません：{end} {place}
{who} が近づいていますが、よける場所がないため、ここに着陸します
自動操縦が確認していません。送り続けています
残り飛行時間 {n}秒、帰還に{m}秒必要です
傾きが指令と{n}度違います
{who} から{n}秒間応答がなく、操縦を失いました。いまは誰も操縦していません
場所。なければパッドの上
下を確認しています
{d} m/s より速く動いています
その点へ飛び、待って戻ります。
目印のない人は見えません
応答のないドローンは止められません
{name}に接続しましたが、測定値が届きません
\`housefly sensors\` で、各センサーの電源、ネットワーク、覆いの有無を見てください
{who} が近すぎます
{who} の発着台があります
待機中
非常停止
軸の反転、回転、ずれは、動いたあとでしか分かりません
自動操縦の応答がありません
{who}が再開しました
不要：部屋は模擬です
手動で移動中：{why}
手動での移動は専用の操作で行ってください
プロペラ、モーター、バッテリーを見て、電源を入れ直してください
非常停止中ではありません。ドローンの状態：{what}
ドローンは自分の動きが見えず、自分では位置を保てません
印字できる {n}文字まで
センサーなし
見る時間
誰を。anybody は一番近い人
まだ応答なし。通常は{k}秒以内ごとに送信します
ドローンはすでに飛行中です
{goal}を確認中
あなたの役割は {name} ですが、{what} が必要です。Houseflyの管理者に頼んでください
この下で何かが見つかっています
自動操縦と通信なし。
{who} が作ったリンク
指示を待っています
{asked}（{who}）：{what}
「{title}」が使用中です
{what}：{why}
ドローンが確認しませんでした：{what}
「{title}」はここから開始できません
パッド上
数秒待つか、電源を入れ直してください
{who}が道にいます
計測した位置がドローンの動きと{n}秒間合いません
計測した経路がドローンの動きから {d} m ずれています
人のところへ飛び、向き合って待ちます。指示かしばらくのあと戻ります。
goal が室内の位置ではありません
ドローンが{thing}に触れます
扉が開いています
飛行{n}秒。離陸時の残量で飛べる時間です（limits.flight_time {m}秒）
サーバーと通信できません
飛行中に着陸するか落下します
ここでは人を検知できません：スキャナーも深度カメラもありません
物体が見えません。位置計測は動作中ですか
有限でない数値があります
ドローンは床にいますが、位置計測では床から {d} m です（限度 {m} m）。飛びません
上昇速度 {d} m/s
{n}秒間使えるデータなし
センサーに見える人の前でだけ止まり、よけます
「再開」を長押しするまで指示を受けません
{why}（限度 {n}）
{why}。その場で止めています
モーターは止まっています
確認が終わりました。戻ります
最後はホバリング中でした
ドローンは移動中です。先に「ホバリング」を押してください。
この速度をもとに離陸し、位置を保ちます
新しい地図で自動操縦を再起動中です。少しあとでもう一度指示してください
手動での移動が終わりました
着陸しません：{why}
再開されるまでその場でホバリングし、電池か時間がなくなれば自動で着陸します
{name}に接続しましたが、新しい値が届きません。{what}は動作中ですか、一時停止していませんか
velocity が不正です
目的地へ飛行中
{d} m 以下
座標は {d} m まで
閲覧だけできます
非常停止を解除
通信が遅れています：{n}秒遅れで届きました
長く待ちました
STOPで停止中です。先に再開してください
速すぎてそこへ曲がれません。先に停止させてください
夜に切っておく物
ドローンが制限値をまだ確認していません
超音波がどこでも反応しています
自身の動きが疑わしいです
{d} m 以内
同時に {n}個を超えています
{end} {place} は障害物に近すぎます：機体から {d} m、必要なのは {m} m です
傾いたドローンは横に飛び出します
{who}が中止しました
立っています
離陸
経路を外れて止まりました。そこから続けます
{d} m/s の指令でも動きません
到着しました。確認しています
{why}（限度 {d} m/s）
座っています
期限を過ぎています
直前{n}秒のうち{d}秒、傾きが指令と違いました
位置計測の装置は動いていますか。この名前で送信していますか
ドローンが墜落しました：点検してからリセットしてください
玄関に誰がいるか見る
ディスクを書き込み可能でマウントし直すか、このユーザーの書き込みを許可してください
時間がかかりすぎました
{who} が経路に入ったため、待ちます
床の上で{n}秒間モーターが回っています。遮断します
見る場所（この順）。whole floor は床全体
まだ応答なし
玄関へ飛び、来た人を撮影して皆に知らせます。
{why}：{more}
地上にとどまります。新しい指示がなければ動きません
ドローンはすでに飛行中です。
安全のため着陸中
0〜{n}秒
まだ確認していません
離陸してから実行します
このセッションは終了しました
1 秒間の指示が多すぎます
次の番です
選んだ地点
何かに当たりました：衝撃 {d} m/s²（限度 {m} m/s²）。着陸します
飛行を妨げるものはなくなりました
{who} は飛行の権限がなくなり、操縦を失いました
ディスクに空きがあります
離陸中に{n}度回転しました
毎秒{d} m
安全のため着陸中です
ここでは手動での移動は使えません（limits.nudge_speed）
位置計測にドローンがまだ映っていません
高さ {d} m を下回りました
ドローンの設定かセンサーに異常があります
停止
説明書のドローンのページを見てください
ドローンが制限値をまだ確認していません。待つか、電源を入れ直してください
空き {p}% 以上、または {n} GB
残り {d} m
位置計測をもとに飛びます
物の場所
地図の外へ {d} m 以上出ました
パッドに高さ {d} m の物があるようです。空いていますか？
{name}で応答がありません。{what}は動作中で、送信していますか
異常がなくなるまでホバリングし、続く場合は自動で着陸します
静止中に {d} m 動いたことになっています。別の物体ではありませんか？ドローンを持ち上げて位置を示してください
モーターを遮断中です。落下します
前回の座標点検は正常でした
自動操縦が{n}秒以上遅れています
{why}。ドローンの周りを空けてください
その場でホバリングし、{n}秒以内に自動で帰還し着陸します
安全のため着陸します
look_at が室内の位置ではありません
{name} という場所はありません。登録済みの場所：{places}
手動での移動には map.planner = "space" と標準モードが必要です
この指示に場所や目的地は要りません：{asked}
離陸位置から {d} m 流されました
呼び鈴
ここに着陸
安全を確かめて「再開」を押してください
ドローンが自動で着陸しています
今書き込みました
{asked}：{what}
期限までに承認がありませんでした
安全を確かめて「再開」を長押ししてください
ほかのプログラムを終了してください。最も重いのは映像です（twin.video = false）
一度もなし
指示されたため
ほかの用事を実行中です
負荷 {n} 未満
パッドまで運んでください
{who}が手動で移動中
中止されました
帰還中
ほかの機体にある機能がそろっています
指示：{what}。許容範囲：{limit}
点検の指示どおり直し、もう一度点検してください：\`housefly preflight --frames\`
コンソールが再起動しました。その間の出来事は記録にありません
「{title}」を始めますか。{why}。
パッドの外です
見回り
傾きでの操縦
ドローンが{n}秒間、制限値を確認していません
{name}のMQTTブローカーに拒否されました。mqtt.usernameとmqtt.password_fileを確認してください
開始前に人が指示しました
位置計測が{n}秒遅れています（limits.pose_age_level：{m}秒）。必要な値は housefly gains が示します
予定の高さ {m} m より {d} m 低い
計測した高さが床の段差なしに {d} m 上がりました（限度 {m} m）
場所か目的地を指定してください
違う場所へ飛び、着陸や衝突をします
{n}件待っています。中止するか、後で依頼してください
自動操縦の応答がありません。次に動くものも停止します
{thing} があります
用事の飛行中です。先に「ホバリング」を押してください。
用事の実行中です。終わるのを待つか、取り消してください
STOPのあとだけ使えます。
2 m 以内に着陸できる場所がありません。自身の動きを頼りに待機します
このコンピューターの処理は間に合っています
ほかの人が操縦中です。長押しで引き継ぎます
自身の報告では静止しています
{name}のMQTTブローカーに拒否されました（{error}）
そのうち1人だけ
人が再開するまでSTOPが続きます
拒否されました
床より {d} m 高い所にあります（限度 {m} m）。何かの上です
このコンピューターは過負荷です
飛行の記録を残せません
sender が名前ではありません
{who} が場所と区域の変更を取り消しました
傾きすぎ
順番待ちがいっぱいで外れました
ドローンの準備ができていません：{what}
電源を入れ、そのWi-Fiに接続し、\`housefly doctor\` を見てください
ドローンは地上にいます
位置計測は{n}秒前から見失っています
{who}が承認しました
着陸の指示から{n}秒（限度 {m}秒）、まだ空中です。こちらの指令で降下します
それでも着陸します：{why}
位置計測はまだドローンを見つけていません
中身の確認
バッテリー {p}%。{q}% で帰還します
パッドに置かれています
それぞれを見る時間
ドローンを一度持ち運んでください（2分）：\`housefly preflight --frames\`
{n}秒間。{then}
位置計測が確かな所でだけ飛ばし、人を近づけないでください
位置計測は{n}秒前からドローンを見失っています
点検済み
止まっているのに、計測では動いています
{d} m 横に着陸します
その場からまっすぐ上がります
{end} {place} は地図の外です
安全のため帰還中です
誰に。anybody は一番近い人
帰還を続け、自動で着陸します`.split(`
`).map((e,o)=>[h+=parseInt(a.map(t=>t[o]).join(""),36),e]));var s={"STOP FAILED":"STOP 未達",STOPPED:"STOP 停止中","STOP sent":"STOP 送信済み","When this page last heard: {words}":"最後の受信時：{words}","sending …":"送信中…","hover at once and stay":"停止：すぐその場で静止",Space:"スペース",Resume:"再開","Resume after STOP":"STOPのあと再開",hold:"長押し","not ready":"準備中","Cut motors":"モーター遮断","Cut motors: motors stop, drone falls":"モーター遮断：モーターが止まり、落下します","it falls, hold 1 s":"落下します・1秒長押し",Reset:"リセット","Reset after a cut":"遮断のあとのリセット","Take off":"離陸",Land:"着陸","Land here":"ここに着陸",Hover:"ホバリング","Stay where it is":"その場で静止",Home:"ホームへ","Fly home":"ホームへ戻る","Fly home and land":"ホームへ戻って着陸","Fly there and stay":"そこへ飛んで待機","Look there and come back":"そこを見て戻る","Look at {place} and come back":"{place}を見て戻る","Look and come back":"見て戻る","Choose where to look":"見る場所を選ぶ","Not ready: see why":"準備できていません：理由を見る","No contact":"通信なし",More:"その他","More orders":"その他の操作",Orders:"操作",Close:"閉じる","{label}: hold {n} s":"{label}：{n}秒長押し","Hold it for {n} s: a tap does nothing.":"{n}秒間長押ししてください。軽く触れるだけでは動きません。","Hold Enter.":"Enterキーを長押ししてください。",Places:"場所","Where to?":"どこへ行きますか","Point {x}, {y} m":"地点 {x}, {y} m","Forget this goal":"この目的地を取り消す","The path keeps {d} m away from everything.":"経路は周囲から {d} m 以上離れています。","The goal was moved {d} m, to the nearest free point.":"目的地を {d} m 動かし、最も近い空いた場所にしました。","Looking for a path …":"経路を探しています…","Choose a place, or point on the map.":"場所を選ぶか、地図を押してください。","The battery is too low for a flight.":"バッテリー残量が足りず、飛べません。","No contact with the server.":"サーバーと通信できません。","No contact with the pilot.":"自動操縦と通信できません。","No contact with the server":"サーバーと通信なし","Opened in another tab":"別のタブで表示中","this one only watches the past":"このタブの表示は過去のものです","Session ended":"セッション終了","use a fresh link":"新しいリンクを使ってください",Connecting:"接続中","for {n} s":"{n}秒間","Waiting for the pilot":"自動操縦を待っています","This console was opened in another tab; that one is live.":"この画面は別のタブで開かれました。そちらが有効です。","This browser's session has ended. Ask for a fresh link.":"このブラウザーのセッションは終了しました。新しいリンクをもらってください。","No contact with the server: nothing is known of the drone.":"サーバーと通信できません。ドローンの状態は不明です。","No word from the server for {n} s: what is shown is of then.":"サーバーから{n}秒間応答がありません。表示はその時点のものです。","What held then: {then}. STOP from this page may not arrive.":"その時点の予定：{then}。この画面のSTOPは届かないことがあります。","Not known: no contact with the server":"不明：サーバーと通信できません","In flight":"飛行中","Not ready: {why}":"準備できていません：{why}",Ready:"準備完了",more:"詳細","{n} check|{n} checks":"点検 {n}件","Checks before take-off":"離陸前の点検","Before take-off":"離陸前","If contact is lost now:":"いま通信が切れると：","As contact was lost:":"通信が切れたとき：","If contact is lost:":"通信が切れると：","no take-off":"離陸できません",look:"確認が必要",well:"良好","What is to be mended":"直すところ","{who} has control. You watch.":"{who} が操縦中です。あなたは見学中です。","Nobody has control: take it first.":"操縦者がいません。先に操縦権を取ってください。","You lost control; {who} has it now":"操縦権を失いました。いまは {who} が操縦中です","This page was silent and lost control; nobody has it: take it again":"この画面の応答が途切れ、操縦権を失いました。操縦者がいません。もう一度取ってください","You have control":"あなたが操縦中","{who} has control":"{who} が操縦中","has control":"操縦中","Take control":"操縦する","Take over":"引き継ぐ","Take over control":"操縦を引き継ぐ","Release control":"操縦をやめる","Hand over":"譲る","You watch.":"見学中です。","{who} has control; STOP and Land work.":"{who} が操縦中。STOPと着陸は使えます。",Control:"操縦","One person has control.":"操縦できるのは1人です。","Everybody else watches, and can still stop or land the drone.":"ほかの人は見学です。停止と着陸は誰でもできます。","Your name":"あなたの名前","Viewer {n}":"閲覧者 {n}","(you)":"（あなた）",Invite:"招待",Live:"現在",Tasks:"用事",Screens:"画面","Round trip between this browser and the server":"このブラウザーとサーバーの往復時間","lag {time}":"遅れ {time}","battery {p}":"電池 {p}","{site} · mode {mode}":"{site}・モード {mode}",Ask:"聞く",Details:"詳細",Keys:"キー操作","Drone and house":"ドローンと家",Battery:"バッテリー","Battery unknown":"バッテリー残量は不明","{p} to land":"着陸用 {p}","{p} to come home":"帰還用 {p}","{p} usable":"使える残量 {p}","about {time} of flight":"飛行 約{time}","land {p}":"着陸 {p}","home {p}":"帰還 {p}","usable {p}":"使用可 {p}","Event log":"できごとの記録",Log:"記録","Which lines":"表示する行","all^lines":"すべて","drone^lines":"ドローン","room^lines":"部屋","warnings^lines":"警告","Show the room as it was then":"そのときの部屋を表示","Only of":"対象",everything:"すべて",info:"情報",warning:"警告",fault:"異常",now:"いま","{n} days ago":"{n}日前","{n} h ago":"{n}時間前","{n} min ago":"{n}分前","{n} s ago":"{n}秒前","by {name}":"（{name}による）",Tracking:"位置計測",Drone:"ドローン",Picture:"映像","Pilot loop":"制御周期",Delays:"遅れ",Filter:"フィルター",Push:"外力",Position:"位置",Motion:"動き",State:"状態","p99 {d} ms late · {n} missed":"p99 遅れ {d} ms・欠落 {n}","tracking {one} · command {other}":"計測 {one}・指令 {other}","{one} · height {other}":"{one}・高さ {other}","{d} m/s² · load {p}":"{d} m/s²・負荷 {p}","{state} · safety {mode}":"{state}・安全 {mode}","by itself":"自然に終わります","once it stands":"着地まで","a fresh order on the ground":"地上で次の指示まで","a reset":"リセットまで","nothing yet":"まだありません",Sensors:"センサー","none heard yet":"まだ受信なし","{n} of {all} needs a look|{n} of {all} need a look":"{all}個中 {n}個を確認してください","all is kept":"すべて保存されています","all {n} are well":"{n}個すべて良好",memory:"記憶","never heard":"受信なし",Layers:"表示","People and things":"人と物","Safety margins":"安全距離","Tracking coverage":"計測できる範囲","Edit the room":"部屋を編集","number: how many of {n} cameras see {d} m above the floor;":"数字：{n}台のうち床上 {d} m が見えるカメラの数","hatched: fewer than {n}, no tracking":"斜線：{n}台未満、計測できません","The past":"過去","Fetching the past":"過去を読み込み中","Back to now":"いまに戻る","Shift + Esc, held 1 s":"Shift + Esc を1秒長押し","Arrow keys":"矢印キー","Enter, held":"Enter を長押し",L:"L",H:"H",M:"M",R:"R",T:"T","?":"?",Esc:"Esc","STOP: hover at once; in flight whatever has the focus":"STOP：すぐその場で静止。飛行中はいつでも効きます","Cut motors: the drone falls":"モーター遮断：ドローンは落下します","Move the goal by one cell":"目的地を1マス動かす","Send the drone to look and come back":"見に行って戻らせる","Swap map and picture":"地図と映像を入れ替え","Edit the room, and back":"部屋の編集、もう一度で戻る","Go to the tasks, and back":"用事の画面、もう一度で戻る","Show or hide this list":"この一覧の表示・非表示","Close a panel":"パネルを閉じる","Space stops the drone even while you type, as long as it flies.":"飛行中は、文字の入力中でもスペースキーで停止します。","On the ground it types a space, or presses the button that has the focus.":"地上では空白を入力するか、選択中のボタンを押します。","Letters and ? are keys":"文字キーと ? で操作する","Where is, go to":"どこにある、行って","Where is … / go to …":"…はどこ／…へ行って","Close the answer":"答えを閉じる","At {time}:":"{time} の時点：","Fly there and look":"飛んで見に行く","Choose it as the goal":"目的地にする","Look there":"見に行く","Nobody knows where that is.":"どこにあるか分かりません。","Go to {place}":"{place}へ行って","Where is {thing}":"{thing}はどこ",Doorbell:"呼び鈴","The bell rings.":"呼び鈴が鳴っています。","The bell rings. Hold to fly there and look; it comes home by itself.":"呼び鈴が鳴っています。長押しすると見に行き、自動で戻ります。","Look who is at {place}":"{place}に誰がいるか見る","Look^order":"見る",Ignore:"無視",door:"玄関","Someone at the {place}":"{place}に誰か来ています","This device":"この端末","Ring for the doorbell and for faults":"呼び鈴と異常のとき鳴らす","Install as an app":"アプリとして追加","As an app: Share, then Add to Home Screen.":"アプリにするには：共有から「ホーム画面に追加」。","This browser does not keep the screen on while the drone flies.":"このブラウザーでは、飛行中に画面が消えることがあります。","It sounds while the page is open.":"画面を開いている間、音が鳴ります。","It sounds from your next touch on, while the page is open.":"次に画面に触れてから、開いている間、音が鳴ります。","It notifies beside other pages.":"ほかの画面を見ていても通知します。","Notifications are forbidden: its settings in the browser allow them.":"通知は禁止されています。ブラウザーの設定で許可できます。","Housefly: look at the drone":"Housefly：ドローンを確認してください",Watch:"見る",Fly:"飛ばす","may see everything, and STOP or land the drone":"すべて見られ、停止と着陸ができます","may watch and ask; a flight waits for your yes":"見ることと頼むことができます。飛行にはあなたの承認が必要です","may take control and fly":"操縦して飛ばせます","What the guest may do":"招待した人ができること","No link could be made.":"リンクを作れませんでした。","Your role is “{role}”: ask who runs Housefly for a link.":"あなたの役割は「{role}」です。リンクは管理者に頼んでください。","What may the other one do? STOP is for everybody.":"相手に何を許しますか。STOPは誰でも使えます。","The link was used: the guest {may}.":"リンクは使われました。開いた人は{may}。","The link expired: make a new one.":"リンクの期限が切れました。新しく作ってください。","The first to open it {may}. It works once, for:":"最初に開いた人は{may}。1回だけ使えます。残り：","Only this machine reaches the console.":"この画面はこの機器からしか開けません。","For a phone, restart with:":"スマートフォンで使うには、Houseflyを終了し、次のように起動してください：","QR code of the link":"リンクのQRコード",Copied:"コピーしました","Copy link":"リンクをコピー",Share:"共有","Ask for something":"頼む","Look at the entrance, where is the cup …":"玄関を見て、コップはどこ…","“{words}”, answered {age}":"「{words}」の答え、{age}","Yes, do it":"はい、実行","The services are not running.":"サービスが動いていません。","The services are not running: nothing can be asked for now.":"サービスが動いていません。いまは何も頼めません。","What is shown here is what was known {age}.":"ここの表示は{age}のものです。","services not running":"サービス停止中","Simulated doorbell":"模擬の呼び鈴","Ring the doorbell":"呼び鈴を鳴らす","This room is simulated: press, and a visitor comes to the door.":"この部屋は模擬です。押すと玄関に来客があります。","What can be done":"できること",Services:"サービス","Not known yet.":"まだ分かりません。","Say first: {what}.":"先に指定してください：{what}。",Start:"実行","Start: {title}":"実行：{title}",Rehearse:"試算","Rehearsing …":"試算中…",Questions:"質問","{n} more question|{n} more questions":"ほかに質問 {n}件","Question of task {n}":"用事 {n} の質問","Without an answer it counts as “{choice}” in {time}.":"返事がなければ {time} 後に「{choice}」とします。",Now:"いま","Nothing is asked for.":"頼まれている用事はありません。","Task {n}":"用事 {n}","{words}: task {n}":"{words}：用事 {n}",Pause:"一時停止","Go on":"続ける",Cancel:"取り消し",Steps:"手順","waiting for a yes":"承認待ち",queued:"順番待ち",running:"実行中",paused:"一時停止中",suspended:"中断中",waiting:"待機中",skipped:"省略",done:"完了",failed:"失敗",cancelled:"取り消し済み",refused:"拒否",expired:"期限切れ","asked for by {who}":"{who} が依頼","asked for":"依頼",", because of {cause}":"、きっかけ：{cause}","in the console":"（画面から）","on the command line":"（コマンドから）","over HTTP":"（HTTPから）","over MQTT":"（MQTTから）","by a webhook":"（Webhookから）","by an assistant":"（音声アシスタントから）","The bell rings":"呼び鈴が鳴っています","Somebody may have fallen":"誰か倒れたかもしれません","Who walks there may close the way for a moment: ask again when it is free.":"人が通って一時的にふさがっているかもしれません。空いたらもう一度頼んでください。",yes:"はい",no:"いいえ","What was":"これまで",History:"履歴",Clips:"動画",Rules:"ルール","No task has ended yet.":"終わった用事はまだありません。","Older tasks":"以前の用事","that is all":"これですべてです",Trigger:"きっかけ",Decision:"判断","It was not rehearsed.":"試算していません。",Flight:"飛行","{time}, in the air for {span}.":"{time}、飛行時間 {span}。","It did not begin.":"始まりませんでした。","It did not fly.":"飛びませんでした。","Recorded:":"記録：",Outcome:"結果","None.":"ありません。","None is kept any more.":"もう残っていません。",Clip:"動画","Show clip, {time}":"動画を見る、{time}","Show snapshot":"写真を見る",Save:"保存","Save all":"すべて保存","Save all of these":"これらをすべて保存","Picture of {title}":"{title}の写真","Clip of {title}":"{title}の動画","This clip is gone, or this browser cannot show it.":"この動画はもうないか、このブラウザーでは再生できません。",Keep:"残す","Keep no longer than others":"ほかと同じ期間だけ残す",Delete:"削除","Delete this clip":"この動画を削除",When:"日時",Place:"場所",Thing:"物",People:"人",For:"用事","Because of":"きっかけ",End:"終わり",Privacy:"プライバシー",Kept:"保存期間",Size:"大きさ","{service}, task {n}":"{service}、用事 {n}","missing: a crash or a full disk cut it off":"途中まで：異常終了か容量不足で切れました","a part of the picture is blank, as the site says":"設定により映像の一部を隠しています","until somebody deletes it":"削除するまで","until {time}":"{time} まで","Which clips":"表示する動画",person:"人",place:"場所",thing:"物",time:"時期",any:"指定なし","any time":"いつでも",today:"今日","this week":"この1週間","this month":"この1か月","{n} or more clips.":"動画 {n}件以上。","{n} clip.|{n} clips.":"動画 {n}件。","There is no such clip.":"該当する動画はありません。",snapshot:"写真","cut off":"途中まで","Older clips":"以前の動画","There is no rule.":"ルールはありません。","(off)":"（無効）","What would have happened last week?":"先週ならどうなったか","What the rules would have done":"ルールが行ったはずのこと","Nothing.":"何もありません。","Mode of the house":"家のモード",Mode:"モード","home^mode":"在宅","away^mode":"外出","night^mode":"夜間","privacy^mode":"プライバシー","maintenance^mode":"整備",recording:"録画中","Taken by":"撮影","First steps":"はじめに","Choose a place on the map, or ask above.":"地図で場所を選ぶか、上の欄で聞いてください。","Hold the large button to fly.":"大きなボタンを長押しすると飛びます。","STOP stops at once. It works for everybody, at any time.":"STOPを押すとすぐ止まります。誰でも、いつでも使えます。",OK:"OK","Close the hints":"説明を閉じる","Show the first steps again":"使い方をもう一度見る","Waiting for the room":"部屋の情報を待っています","Map of the room":"部屋の地図","Floor plan with the drone. Arrow keys move the goal; a list of places follows.":"ドローンのいる間取り図。矢印キーで目的地を動かします。続いて場所の一覧があります。",Legend:"凡例","People and things are not shown: {why}.":"人と物は表示していません：{why}。","kept free by order":"飛行禁止の場所","too close to fly":"近すぎて飛べない場所","{n} in the way that no map knows":"地図にない障害物 {n}個","{p} sure":"確かさ {p}","told before":"以前の情報","Place unknown: {names}":"場所不明：{names}","{name} (in {holder})":"{name}（{holder}の中）","height {d} m, no curve is flown":"高さ {d} m、曲線飛行なし","height unknown":"高さ不明","{low} to {high} m":"{low}～{high} m","height {heights} over {length} m in {n} s, up to {fastest} m/s":"高さ {heights}、{length} m を{n}秒、最高 {fastest} m/s","± {one} in the plane, ± {other} in height":"水平 ± {one}、高さ ± {other}","; stops in {d} m":"、停止まで {d} m","Height unknown":"高さ不明","Height {d} metres":"高さ {d} メートル","Flight height":"飛行高度","0 to {d} m/s, a dot each second":"0～{d} m/s、点は1秒ごと","stops here if it brakes now":"いま止まるとここで停止","Zoom of the map":"地図の拡大・縮小","Zoom in":"拡大","Zoom in (+)":"拡大（+）","Zoom out":"縮小","Zoom out (-)":"縮小（-）","Whole room":"部屋全体","Whole room (0)":"部屋全体（0）","The drone is out of view: show it":"ドローンは画面の外です：表示する","Show the drone":"ドローンを表示",Time:"時間","Live again: {why}":"現在に戻りました：{why}","Back to live":"現在に戻る","● Live":"● 現在","Time shown":"表示する時刻","How far back":"さかのぼる長さ","10 min":"10分","1 h":"1時間","6 h":"6時間","1 day":"1日","1 week":"1週間","Flight at {time}, {span} long":"{time} の飛行、{span}","Flight at {time} to {goal}, {span} long":"{time} の飛行、{goal}へ、{span}",", with warnings":"、警告あり",", with faults":"、異常あり","{name}: look at it again":"{name}：もう一度見る",Play:"再生","How fast":"再生の速さ","Moment of the recording":"記録の時点","{time} of {span}":"{time} / {span}","Recorded, not live":"記録です・現在ではありません",Recorded:"記録","Log, recorded":"記録（過去）","Log of the recording":"記録のできごと","Recorded picture":"記録の映像","No picture of this moment was kept.":"この時点の映像は残っていません。","nobody saw the drone":"ドローンは見えていません","{high} m high, {fast} m/s, battery {p}":"高さ {high} m、{fast} m/s、電池 {p}","The drone may be in the air: what is live stays on the screen.":"ドローンが飛行中かもしれません。現在の表示を続けます。","the drone may be in the air":"ドローンが飛行中かもしれません","a goal was chosen":"目的地が選ばれました","STOP was pressed":"STOPが押されました","never seen":"未確認","has {names}":"所持：{names}","in it: {names}":"中身：{names}","idle^phase":"待機","taking off^phase":"離陸","flying to goal^phase":"往路","looking^phase":"確認","holding^phase":"ホバリング","returning^phase":"帰還","landing^phase":"着陸","The view in space could not be fetched: no contact with the server.":"立体表示を読み込めません。サーバーと通信できません。","Fetching the view in space …":"立体表示を読み込み中…",Plan:"平面","3-D":"立体","The room in space":"部屋の立体表示","This browser cannot draw in space (WebGL is off or missing). The plan shows the same.":"このブラウザーでは立体表示ができません（WebGLが無効）。平面図でも同じ内容が見られます。","Recorded, not live.":"記録です・現在ではありません。","Nobody sees the drone.":"ドローンが見えません。","The drone was seen {time} ago.":"ドローンを見たのは {time} 前です。","Drag to turn, two fingers or the wheel to come nearer.":"ドラッグで回転、二本指かホイールで拡大。","People are where they were last seen; pale is long ago.":"人は最後に見えた場所にいます。薄いほど前です。","Picture from the drone":"ドローンの映像","No picture yet":"映像はまだありません","No new picture for {time}":"{time} 新しい映像がありません","Make the map large, or small again":"地図を大きく、または元に戻す","Make the picture large, or small again":"映像を大きく、または元に戻す","Swap (M)":"入れ替え（M）","No services run here, and only they keep pictures: nothing was kept.":"サービスが動いていないため、写真を保存できませんでした。","Nothing was kept.":"何も保存されませんでした。","Keep this picture as a photo":"この映像を写真として保存",Snap:"撮影","Photo kept":"写真を保存しました","in Tasks, Clips.":"「用事」の「動画」にあります。","in Tasks, Clips, until {date}.":"「用事」の「動画」に {date} まであります。",Show:"表示","Map being edited":"編集中の地図","Floor plan being edited. The list of places and zones follows.":"編集中の間取り図。続いて場所と区域の一覧があります。","too close":"近すぎる場所","Tap the map for a new place, drag on it for a new zone, or:":"地図を押すと新しい場所、ドラッグすると新しい区域。または：","Tap or drag on the map to move what is open; Done when it is right.":"地図を押すかドラッグして動かし、よければ「完了」。","Drag on the map to draw the open zone again; Done when it is right.":"地図をドラッグして区域を描き直し、よければ「完了」。","Edit places and zones":"場所と区域の編集","Places and no-fly zones":"場所と飛行禁止区域","version {n}":"第{n}版","version {n}, by {who}":"第{n}版、{who}","never edited":"未編集","Add a place":"場所を追加","Add a zone":"区域を追加","Places and zones":"場所と区域","new place":"新しい場所","new zone":"新しい区域","where it starts and lands":"離着陸する場所","Not saved yet.":"まだ保存していません。","The drone keeps the map that it started with.":"ドローンは起動時の地図のままです。","What is saved here counts from the next start of Housefly on.":"保存した内容は、次にHouseflyを起動したときから有効です。","What is saved here counts from the next start on, or as soon as you use it after Save.":"保存した内容は、次にHouseflyを起動したとき、または保存後「すぐ使う」を選んだときから有効です。",Discard:"破棄",Undo:"元に戻す","Go back to the version before":"前の版に戻す",Remove:"削除","Remove {name}":"{name}を削除",Done:"完了",Name:"名前","Reading corner":"読書コーナー","In commands: {name}":"コマンドでの名前：{name}","Hovers at [m]":"ホバリング位置 [m]","Looks at [m]":"見る位置 [m]",height:"高さ","on map":"地図で","x from":"x 始点","y from":"y 始点","x to":"x 終点","y to":"y 終点",Reason:"理由","Wet floor":"床がぬれている","Kept free [m]":"飛行禁止 [m]","These changes were not saved before. Save or Discard them.":"保存していない変更があります。保存するか破棄してください。","{who} has control, and only who has control may change the room.":"{who} が操縦中です。部屋を変更できるのは操縦者だけです。","Take control first: only who has control may change the room.":"先に操縦権を取ってください。部屋を変更できるのは操縦者だけです。","Give this place a name.":"この場所に名前を付けてください。","In the air the drone keeps the map that it took off with: land first.":"飛行中は離陸時の地図のままです。先に着陸してください。","Nobody knows whether the drone flies: the new map waits.":"ドローンが飛行中か分かりません。新しい地図は待機中です。","That is being done.":"実行中です。","The pilot has not come back. The terminal of Housefly says why.":"自動操縦が再起動しません。理由はHouseflyの端末に出ています。","In use: the drone has this map now.":"反映しました。ドローンはこの地図を使っています。","The pilot starts again.":"自動操縦を再起動中です。","No flight meanwhile.":"その間は飛べません。","Use it now":"すぐ使う","The pilot starts again, about {n} s. No flight meanwhile.":"自動操縦を再起動します（約{n}秒）。その間は飛べません。","Move by hand":"手動で移動","Up the map":"地図の上へ","Left on the map":"地図の左へ","Right on the map":"地図の右へ","Down the map":"地図の下へ",Climb:"上昇",Sink:"下降","Moving while you hold.":"押している間、動きます。","Hovering. Hold an arrow, W A S D or a stick.":"ホバリング中。矢印、W A S D、スティックを押し続けると動きます。","W A S D or arrows, R F":"W A S D か矢印、R F","While Move by hand is on: move the drone, up and down":"「手動で移動」中：ドローンを動かす、上下","+ − 0":"+ − 0","Map with the focus: nearer, farther, whole room":"地図を選択中：拡大、縮小、部屋全体","No drone":"ドローンなし","To add one: enabled = true under [drone] in the site file.":"追加するには、サイトファイルの [drone] に enabled = true と書いて、再起動してください。","Floor plan of the room":"部屋の間取り図"},i=["玄関に誰がいますか","誰かいますか","大丈夫ですか","今日何がありましたか"],m={texts:s,ideas:i,templates:n};export{m as JA};
