import"./chunk-chunk-3JDQFTOK.js";var i="hfgmt8urq4r1ed28kmp4ozkrhkblec5i63d8pjgyo2e8pv3hqi6og580jrv67ztk6mwgtmxdnfgcavaz7g0ytjj6qp42gipqtquvx1zuykklob6q0tqjog69wy6iklo6rvsrdfl227l7r3yjjiirfwf6l2jvzxoe49iqt2jz4oc9cgw92g5vzg52w3dhidt04han55nl8gp417fxvbitioaao69nflwpt6lgfwa3eu9vdyc1fbd5jrg4wri7qdkm1re9alxcii1tx462yf9oriju3vuvqys8tn3vc3pz3g18ziwczdm0fx177eph3u259zbp3smej3xsd5zccg26p7geinbak9g020sw4z79b4biat7av0d1nv1byr0tw5sucv1s9z55ix2l095nnry8tiih5jih8nrariwgjp7uvg8rg2zwy9fiic0lw8h8kalmm43kamqqsymiv1udodk74l96cf0na6ozyq500dsgy203fowdha8bwu1s7ujf8cc1lrnwy4ua8cr6p95mhguzr61h2kcoh47nng4ya5jkydkxuvrq81nxeg4cil50pjycw3aiaz4v5juk6l34hfw6m9j0ibc68kefcpf4p89ucpavsnq0iezjr0mevl7uvjwhz1ybhbehfy4otgrxkccv3u2j1g1s4746y0drq0bq3aaoz7ll44e6vp56gqj2pa4tbw6ipk9r6f6f86ldz8879gjr2c9k8z7voleerjv2hker7grl1dyl0ll51ugk2xn546c3su6h8oqys0vo0d1fq942tz78nj0hvey02chywmxmvvy3gxsiw23iro1ihjvooelsc3vwpe1zmuhsid0enhnlp9ndspkbtvllzjmywmby1k41t2iev2eupcde5mqqi0b9blefbawwhsd5oww5vgighj1xlolzmvy7v615xmzoc4hwnwfai7d5f4ybi8tuvfsro5i8hq5tzccwux56ow268prmqu0fwhj3ym2znh1t84vdfrie401q99wtnupruk3xafonlu63udfv350tcl6z1g820cwu5q913fiaifyeiiggte9a6ifz9rusbrgwoanafwtjctbdf8l6lrsi5xqha5p39ycmj5u128zh7xesm5wa4brce5k6e43obhfw9zi1tkxq8qb2eb8f4b4c9in7ok1sw0ie60lfubcuzlhzjy1i5txvhte53t5mrtr5xrp2hpfsf1kb7p4djzhu0j6ufby3jeqm45j4ilve2gnqp17ezy5w3xwjog953ac213yzc01wtpq5r8oxsuexzq5tz97gtz885slvp9hbol6230jqlovqvvzo2sc54x4ikj9nlre4402aj3zehxblxz9hogcbdag0v1w434t81ev6f0x2eha73p2gxgwf7ibikip40f0l65s19xrix97dmwih1q8zhtgu7pf1zpqcguqlc3nsft2jsea99uzf33hnt4aq5kbtmu9b1w63mg1pixom9odyxrm08xa0s231c2nit5w22ts50e8zbxqg8bc5mzftzj4mxqahfrzg4725schpidpqhi2xex4iwjg3wqd2xxdfgy9x6eapzesao1b3wxtuk64zuhwusvrvhkx2hnpem4hfdvvz0cdycf1m78102j51c55rodwwouy9d0k3luo6huru1yu7doqjhu4swu7vla9iyqtnzmc2fbpkjjs30f661ao2pshqo4ro318b9aqhqxjtqlpcvn56fzrq6cyn8udvr3cpcnci3jcnmnxmji6d0pzyxyoejgjfr4v7meiol801oqx7vxpodic6evabuaa1rsagp6ywlb4nem3csdmbwhi7tdd6lyp4g5i1rhzrmwsn52omvsi0zktl5mvf5cl1bu6yxkuer5c8uk35bupbybwyi1alc0orpil03e2lb8ipqqcrg7h0offff7x2ot0chqipalbk7qcqxufubm9pcngaskcm6ew9d9hahgyoflt3vramoj3rid3cgxu4ypvnowewe5sp969laqh3untnkrtozwi3bugkpf3yjtelkle7mg87ygxhlaysv3jo4lznx1hrno4a7b1wmpv3zo4s0d6gd32cl90mlh3zhozl99emo9lpt3v6zpl6hi62bwspuc842eklyoqjx4au8cymj69dltf6vtojngf6fmuc9ngt10lbgk9n09v90if2taxyvcem662pssmrp5h5885irn624bfx09u0bxioq7xlemcuvw1n3wlpo1hw7hjchgsurc79mhb5mm41w51jae4bkuafhe42ym1iu06il1jqwltz72bjobw3jii8vwib6hz2ch7w8u3u2lgs7nvl0gznenktkgpww9ju39ndr6ssdtmexwb9pni181a55l6qd840sekhm2j18t4gw1qgtfxjthkyibz7zxx8ggivyjkk9zwvb2osswcp2md6ukip61wv206yjjuqzb77br3t55moafu84a4agig2wkzhxg6t3rmthwvb926imry4hu22ycm0sotrac9ow4wr16bew2uw9jdy8869van0w99gn0dfhvpvo8v713v1qqycrdd4c80xq39ubgc8ldekc9b9g5min1nx7opnjkw0yrntiawtfctrkazwn7iffzzej664e3alho0loecxbntpyb786un0qje6k4c0x4hpn0jwwzq5u5tc17ib6s7arlkiu37fr3qu2y9202qy389illvake6ur9epjiwvzkxjxdt98pw117cnr5kb57zfdxwscbimvrqxjkjzlcfxc1u3hylnu5t361lmkzrev7fsrvo5zrtrcoadwfxyig8egnv6w33j2yt3gp6s2lakrqn7fbz5b2i5ahpobf4pmlng2mnvut8bz7g0tkhyaugc27fi318i7c69ttdss7mw71nhlrna01tfxf5yzclm3a2ohqvtm79xhheaqx63gqi21ql39tfa7r5vcgfg28uv4nso2mr50hxcxddldza3r1ne9wf1spqukkc31nz9ocuwfhxxbtvgd720ocw5cn4s8ye4eephib0a9gqto9l6y6a1r7w0tnheuzjwxdpsm4i3dhg0j0ynzol8umq0zuzlg95r47knytham3t45b0fq9z54qs6l23ieb39v0jdqolknpuom7q1lmjzrrn7iba0bbfqn7e4zc30idkrywuy2ud1tdpuiwvv1gyxfg6biwpp4i6kobemkaehhwy3xp52m8ju5sg496e0cgordlqpl61zqoifsztwp1tsrucox3ayifcjwpsvk4t7yoe9pcqvdok89d5110k6z7l8qt8m0d9w1a97mgrvm87bvnvb2w2bzw4ugsb3ns3oz3suqpwrwabvbwbnhq3p2ks25othogjxsg1lh7ty1zm2xlea94f66wfxewptvi8bd97encv2bqqb006nkql3d97de8gspt870td1o7x50fif5r67gprf2sgcvgpq5utw6c2suk8hovcxde39tq2ez0w3gflq1so2cee49qxdoxlg2xbbxm0e87plfer2nm1d127ozxwvbav0iwi1ifjtpgk14m3x1jlf4wjemuhbjo65zk4wtflvl2ttgv5ivc349t42nke0wwufh4b2w1dacewrpglhfgk0ongwcrae1nco1zwph29neylwv32w8zo40swwbld1g1v8vixs7144sne0r6vuou6tpiqd18m5x0sx4fobmyva48h3qsp1te7k8d4tt",e=Object.fromEntries(`Warten auf den Autopiloten
Keine Verbindung zum Autopiloten
Keine Verbindung zum Autopiloten.
Keine Verbindung zur Drohne
Warten auf die Drohne
Motoren sind aus
Angehalten
SICHERHEITSHALT
Kommt zur Sicherheit zurück
Landet zur Sicherheit
Sinkt zur Sicherheit
Motoren werden abgeschaltet
Bereit auf dem Landeplatz
Nicht bereit
Nicht auf dem Landeplatz
Auf dem Landeplatz
Am Boden
Startet
Fliegt zu {goal}
Sieht nach: {goal}
Kommt zurück
Landet
Schwebt
Von Hand bewegt
Von {who} von Hand bewegt
schwebt nach dem Loslassen
Motoren sind aus
prüft, ob alles in Ordnung ist
wartet auf einen Befehl
kommt von selbst zurück
noch {d} m, {n} s
noch {d} m
{place}; Start von dort möglich
{place}; vor dem nächsten Flug zurücksetzen
{place}; bleibt unten bis „Fortsetzen“
schwebt bis „Fortsetzen“
seit {n} s; {then}
sie war am Boden
sie schwebte
sie startete
sie flog zu {goal}
sie sah nach: {goal}
sie kam zurück
sie landete
sie wurde von Hand bewegt
sie wurde von {who} von Hand bewegt
ihrem Ziel
dem gewählten Punkt
Heim
auf dem Landeplatz
am Boden, {d} m vom Landeplatz
am Boden, {d} m vom Landeplatz, unter, auf oder in {thing}
am Boden; {why}
in der Luft
in der Luft; {why}
unbekannt
die Ortung sah sie noch nicht
die Ortung sah sie zuletzt vor {n} s
die Ortung sieht sie nicht
die Ortung sah die Drohne noch nicht
die Ortung sah die Drohne zuletzt vor {n} s
die Ortung sieht die Drohne nicht
Seit {n} s nichts vom Autopiloten: {then}. STOP und Landen werden weiter gesendet.
Seit {n} s nichts von der Drohne: {then}. STOP und Landen werden weiter gesendet.
Die Drohne schwebt und nimmt keine Befehle an, bis „Fortsetzen“ gehalten wird
Die Drohne nimmt keine Befehle an, bis „Fortsetzen“ gehalten wird
der Autopilot schweigt; auch der nächste wird angehalten
gesendet, noch nicht bestätigt
nicht bestätigt: STOP wird immer wieder gesendet
STOP wurde nicht angenommen
STOP kam nicht an: keine Verbindung zum Server
sie schwebt, bis die Störung vorbei ist, und landet von selbst, wenn sie andauert
sie kommt zur Sicherheit weiter zurück und landet
sie schwebt an Ort und Stelle, bis jemand fortsetzt, und landet von selbst, wenn Akku oder Zeit zu Ende gehen
sie landet weiter, wo sie ist
sie sinkt weiter zum Boden, wo sie ist
ihre Motoren werden abgeschaltet: sie fällt
sie bleibt am Boden: ohne neuen Befehl bewegt sie nichts
noch ist nicht bekannt, was die Drohne tut
die Drohne war zuletzt am Boden; ohne Autopilot bewegt sie nichts
sie war zuletzt in der Luft; Landen wird weiter verlangt, und eine Drohne ohne Verbindung bremst und landet von selbst
ist der Autopilot beendet, bremst und landet die Drohne in Sekunden von selbst; fehlt nur seine Nachricht, gilt: {then}
sie startet weiter, fliegt zu {goal}, kommt dann binnen {n} s von selbst zurück und landet
sie startet weiter, schwebt, kommt dann binnen {n} s von selbst zurück und landet
sie fliegt weiter zu {goal}, kommt dann binnen {n} s von selbst zurück und landet
sie sieht zu Ende nach, kommt dann von selbst zurück und landet
sie fliegt weiter zurück und landet von selbst
sie landet weiter
sie schwebt an Ort und Stelle, kommt dann binnen {n} s von selbst zurück und landet
keine Verbindung zum Autopiloten
er startet von selbst neu: warten, oder sein Protokoll im Ordner des Laufs ansehen
die Drohne fliegt schon
Die Drohne fliegt schon.
die Prüfungen vor dem Start fehlen noch
sie kommen in Sekunden
die Drohne antwortet nicht
einschalten, mit ihrem WLAN verbinden und \`housefly doctor\` ansehen
ihre Motoren sind aus
prüfen, dass niemand nahe und sie heil ist, dann „Zurücksetzen“ halten
STOP ist gesetzt
„Fortsetzen“ halten, wenn alles in Ordnung ist
die Ortung ansehen: Läuft sie, sendet sie den Körper unter diesem Namen?
sie steht unter, auf oder in {thing}
zum Landeplatz tragen
{why} ({found})
{why}; {more}
{why}: {more}
Motoren sind aus: erst „Zurücksetzen“ halten.
Angehalten: erst „Fortsetzen“ halten.
Die Drohne antwortet noch nicht.
Die Drohne ist am Boden.
Nur nach STOP.
Nicht bereit: {why}.
Jetzt nicht: {why}.
sie kommt zur Sicherheit zurück
sie landet zur Sicherheit
ihre Motoren werden abgeschaltet
{why}: sie landet
{why}: sie kommt zurück
{why}: langsam
{why}: die Drohne hält sich selbst
{why} (Grenze {n} s)
{why} (Grenze {d} m)
{why} (Grenze {d} m/s)
{why} (Grenze {n})
Motoren werden auf Befehl abgeschaltet
die Motoren sind aus: zurücksetzen, wenn niemand nahe ist
seit {n} s am Boden mit laufenden Motoren: Abschalten
seit {n} s soll sie landen (Grenze {m} s) und ist noch oben: Sinken nach eigener Vorgabe
die Drohne schweigt seit {n} s
Personen bleiben vielleicht ungesehen: von einem Sensor für sie kam noch nichts
die Drohne hat ihre Grenzwerte seit {n} s nicht bestätigt
die Drohne hat ihre Grenzwerte nicht bestätigt
Akku {p} % unter {q} %
der Akku verlor {p} % in {n} s (Grenze {q} %)
seit {n} s in der Luft, so lange die Ladung beim Start erlaubt (limits.flight_time {m} s)
der Autopilot war {n} s zu spät
{n} der letzten {m} s gehalten
STOP: schwebt bis zum Fortsetzen
Akku {p} %, der Heimweg ({n} s) braucht {q} %
nach der Uhr noch {n} s Flug, der Heimweg braucht {m} s
der Autopilot ist mehr als {n} s zu spät
Befehle erreichen die Drohne verspätet oder gar nicht
der Autopilot ist oft zu spät ({k}-mal in {n} s)
Akku {p} %: bei {q} % kehrt sie um
der Akku zeigt seit {n} s {p} % (Grenze {m} s): Flug nach der Uhr, noch {k} s
Ortung seit {n} s verloren
die Ortung zeigte die Drohne noch nicht
die Ortung passt seit {n} s nicht zur Bewegung der Drohne
die Drohne meldet ihre Bewegung nicht: Die Ortung ist ungeprüft
die Ortung weicht {d} m vom eigenen Weg der Drohne ab
der geortete Körper ist {n} Grad gegen die Drohne verdreht
die Ortung ist das Spiegelbild der Bewegung
die geortete Höhe stieg um {d} m (Grenze {m} m) ohne Stufe im Boden
die geortete Höhe weicht {d} m von der eigenen der Drohne ab
{why}, oder darunter ist etwas: langsam
die Drohne steht, doch die Ortung zeigt sie {d} m vom Boden (Grenze {m} m): sie bleibt unten
die Drohne steht, doch die Ortung zeigt sie um {d} m bewegt (Grenze {m} m): sie bleibt unten
die Ortung ist {n} s älter als angegeben
angestoßen, oder die Ortung sprang: plötzlich {d} m/s anders (Grenze {m} m/s), sie landet
etwas getroffen: Stoß von {d} m/s² (Grenze {m} m/s²), sie landet
{d} m über ihrer Höhe von {m} m
{d} m unter ihrer Höhe von {m} m
{why}, schon lange (Grenze {d} m)
mehr als {d} m außerhalb der Karte
höher als {d} m
tiefer als {d} m
steigt mit {d} m/s
neigt sich {n} Grad anders als befohlen
neigte sich {d} der letzten {n} s anders als befohlen
neigt sich {n} Grad und bewegt sich nicht (Grenze {m}): hängt fest, sie landet
{d} m von der Sollposition
{why}: gehalten
{d} m/s
höchstens {d} m/s
sie steht nach eigener Angabe still
sie hebt ab und hält sich nach dieser Geschwindigkeit
die Drohne meldet Bewegung, obwohl sie steht
Personen werden vielleicht nicht gesehen: seit {n} s nichts Brauchbares von einem Sensor
die Drohne sieht ihre Bewegung nicht: sie kann sich nicht selbst halten
{why}, und der eigenen Geschwindigkeit der Drohne ist nicht zu trauen: sie sinkt waagerecht
Kamera unten und Boden darunter ansehen, dann aus- und einschalten
die eigene Geschwindigkeit passt weder zur Ortung noch zur Neigung: Landung nach Ortung
verlässt gleich die Karte um {d} m
fliegt mit {d} m/s (Grenze {m} m/s)
bewegt sich mehr als {d} m/s anders als befohlen
steht {d} m über dem Boden (Grenze {m} m): auf etwas
{d} m vom Startort verweht (Grenze {m} m) und nur {k} m hoch: Motoren werden abgeschaltet
mit {d} m/s verweht (Grenze {m} m/s), nur {k} m über dem Boden: Motoren werden abgeschaltet
{d} m vom Startort verweht
Böen: seit {n} s {d} m/s neben der Sollgeschwindigkeit
der Befehl war keine Zahl
nichts hält die Drohne mehr zurück
die Drohne antwortet
zuletzt vor {n} s
nie
höchstens vor {n} s
eine Drohne ohne Verbindung lässt sich nicht anhalten
sie steht, sagt sie selbst
die Drohne meldet nicht, dass sie steht
gelandet
fliegt
startet
Notaus
unbekannt
nur eine stehende Drohne kann starten
„Zurücksetzen“ drücken, wenn sie im Notaus und niemand nahe ist
sie steht auf ihren Füßen
die Drohne steht schief
{n} Grad
höchstens {n} Grad
schief startet sie zur Seite
eben auf den Landeplatz stellen
sie hat ihre Grenzwerte bestätigt
bestätigt
noch nicht
ihre eigenen Grenzen für Neigung, Höhe und Tempo gelten, wenn alles andere versagt
einige Sekunden warten oder aus- und einschalten
sie meldet keine Störung
die Drohne meldet eine Störung
nichts
sie würde mitten im Flug landen oder fallen
Propeller, Motoren und Akku ansehen, dann aus- und einschalten
der Akku ist geladen
der Akku ist zu leer
{p} %
mindestens {p} %, für weite Wege mehr
sie muss zurückkommen und landen
laden oder Akku wechseln
die Akkuanzeige bewegt sich
die Akkuanzeige stand still
steht bei {p} %
in Bewegung
niemand weiß, wie voll der Akku ist
Akku wechseln oder die Drohne neu starten: Start, sobald ein anderer Wert erscheint
die Ortung sieht sie
sie fliegt nach der Ortung
die Ortung ansehen: Läuft sie, sendet sie den Körper unter diesem Namen? Ist sie nur langsam, nennt housefly gains das nötige limits.pose_age_level
die Ortung lässt sie, wo sie steht
die Ortung bewegt die Drohne, obwohl sie steht
um {d} m bewegt
höchstens {d} m
eine Ortung, die am Boden wandert, wandert auch in der Luft
prüfen, ob ein anderer Körper ihren Namen hat; einmal anheben zeigt, wo sie ist
die Ortung zeigt sie, wo sie steht
die Ortung zeigt die Drohne in anderer Höhe
{d} m
innerhalb {d} m
ein Boden in anderer Höhe ist ein Raum in anderer Höhe
Ursprung der Ortung auf den Boden legen und den Körper der Drohne neu anlegen
niemand hat STOP gedrückt
gedrückt
nicht gedrückt
STOP gilt, bis jemand fortsetzt
„Fortsetzen“ drücken, wenn alles in Ordnung ist
niemand und nichts ist über oder neben ihr
der Weg nach oben ist nicht frei
frei
{who} ist zu nah
dort steht {thing}
sie steigt von ihrem Platz gerade nach oben
den Landeplatz freimachen
Einstellungen und Sensoren sind in Ordnung
eine Einstellung oder ein Sensor der Drohne stimmt nicht
ja
sie fliegt vielleicht anders als geplant
die Seite der Drohne im Handbuch ansehen
die Ortung hat sie auf dem Landeplatz gesehen
die Ortung hat die Drohne nicht auf dem Landeplatz gesehen
{d} m davon entfernt, um {n}° gedreht
einmal höchstens {d} m und {n}° davon
wo Ortung und Karte nicht übereinstimmen, sind Wände nicht, wo sie scheinen
auf den Landeplatz stellen, die Nase in dessen Richtung; steht sie so: \`housefly preflight --frames\`
sie steht auf dem Landeplatz
die Drohne steht nicht auf dem Landeplatz
{d} m davon entfernt
steht sie doch dort, passen Ortung und Karte nicht, und Wände sind nicht, wo sie scheinen
auf den Landeplatz stellen; steht sie dort, den Ursprung der Ortung mit der Karte vergleichen
sie hat, was andere haben
der Drohne fehlt, was andere haben
Steuern durch Neigen
eine Kamera
eigenes Schweben
eigene Höhe
eigene Geschwindigkeit
eigene Lage
Regeln, die das brauchen, gelten nicht; fällt die Ortung aus, sinkt und landet sie
nur fliegen, wo die Ortung sicher ist, und niemanden in die Nähe lassen
ein Sensor sieht Personen ohne Marker
Personen ohne Marker sieht sie nicht
kein Sensor
nur für Personen, die ein Sensor sieht, hält sie und weicht aus
seit {n} s nichts Brauchbares
noch nichts gehört
vor höchstens {n} s gehört
\`housefly sensors\` ansehen: ist jeder an, in diesem Netz und unverdeckt?
niemanden in den Raum lassen, oder Scanner oder Tiefenkamera ergänzen
die letzte Achsenprüfung fand keinen Fehler
die letzte Achsenprüfung fand die Ortung falsch
nichts bekannt
sie flöge an falsche Orte und landete oder stieße an
wie von der Prüfung gesagt beheben und neu prüfen: \`housefly preflight --frames\`
Achsen geprüft
Achsen nicht geprüft
seit [tracking] geändert wurde
bevor [tracking] geändert wurde
nicht nötig: der Raum ist simuliert
falsch
geprüft
gespiegelte, gedrehte oder verschobene Achsen fallen erst nach einer Bewegung auf
die Drohne einmal umhertragen, zwei Minuten: \`housefly preflight --frames\`
Der Raum wird beobachtet
Warte auf die Ortung
keine Drohne
dieser Raum hat keine Drohne
Dieser Raum hat keine Drohne.
dieser Rechner kommt mit
dieser Rechner ist überlastet
Last {n} auf {k} Kernen
Last {n} auf {k} Kern
eine Last unter {n}
was zu spät kommt, wird verworfen, als wäre es nie gekommen
andere Programme beenden; das simulierte Bild kostet am meisten (twin.video = false)
auf der Platte ist Platz
eine Platte ist fast voll
{p} % frei auf {name}
mindestens {p} % frei, oder {n} GB
was im Flug geschieht, ließe sich nicht aufbewahren
alte Flüge löschen oder auf eine andere Platte verschieben
auf die Platte lässt sich schreiben
auf eine Platte lässt sich nicht schreiben
eben geschrieben
eine Datei lässt sich schreiben
die Platte wieder zum Schreiben einhängen oder diesen Benutzer dort schreiben lassen
hier sieht nichts Personen: kein Scanner, keine Tiefenkamera
kein freier Weg von {name} nach {place}
{asked} abgelehnt: {why}
Starten
Landen
Schweben
Fortsetzen
Zurücksetzen
Motoren aus
Hinfliegen
Nachsehen
der Befehl ist {n} s alt; Befehle verfallen nach {m} s
kein Notaus aufzuheben; Zustand der Drohne: {what}
STOP ist gesetzt: erst fortsetzen
die Drohne wird zur Sicherheit gelandet
die Drohne kommt zur Sicherheit zurück
die Drohne ist nicht bereit: {what}
die Drohne hat ihre Grenzwerte noch nicht bestätigt: warten oder aus- und einschalten
die Ortung sieht die Drohne {d} m neben ihrem Stand (Grenze {m} m): Ursprung der Ortung und Körper der Drohne prüfen
der Akku ist zu leer: {p} %, der Start braucht {q} %
die Ortung zeigt die Drohne von vor {n} s (limits.pose_age_level: {m} s); housefly gains nennt die nötige Grenze
{why}: {found}, nötig: {limit}; {mend}
jemand anderes fliegt: zum Übernehmen die Taste halten
Sie steuern nicht
diese Sitzung ist beendet
zu viele Befehle auf einmal: kurz warten
jener Zuschauer ist nicht mehr da oder darf nicht fliegen
der Befehl braucht einen Ort oder ein Ziel
der Raum ist noch nicht bekannt
das Ziel liegt außerhalb des Raums
keine Verbindung zum Server
die Verbindung zum Server brach ab
mit Ihrer Rolle lassen sich Clips ansehen, nicht gemeinsam speichern
Türklingel gedrückt
Türklingel
Person anwesend
Person geht
Person steht
Person sitzt
Person liegt
Person gestürzt
anwesend
geht
steht
sitzt
liegt
gestürzt
Bett belegt
Gerät an
Tür offen
nein
nicht beachten
jetzt nicht
landet
{why}: sie hält sich selbst
Die Drohne ist unterwegs: erst „Schweben“ drücken.
in der Luft behält die Drohne die Karte vom Start: erst landen
niemand weiß, ob die Drohne fliegt
eine Aufgabe läuft: ihr Ende abwarten oder sie beenden
die Drohne hat diese Fassung schon
das geschieht schon
dieser Lauf wird aufgezeichnet, mit nur einer Karte: neu starten
die Kamera nimmt nur im Flug auf
dieses Bild ist nicht mehr gespeichert
der Autopilot startet mit der neuen Karte neu; gleich noch einmal befehlen
{who} startet den Autopiloten neu, damit die Drohne die neuesten Orte und Zonen hat
Bewegen von Hand ist hier ausgeschaltet.
Eine Aufgabe fliegt die Drohne: erst „Schweben“ drücken.
Bewegen von Hand ist hier ausgeschaltet (limits.nudge_speed)
Bewegen von Hand braucht map.planner = "space" und den Modus default
ein Manöver fliegt die Drohne
Bewegen von Hand geht nur mit den Tasten dafür
die Verbindung ist langsam: dies kam {n} s zu spät
Bewegen von Hand
Motorstörung
Softwarefehler
Motoren ausgefallen
Akku schwach
zu stark geneigt
Sensorplatine schweigt
Flugzeit abgelaufen
zu viel Wind
Ultraschall taub
das Gedächtnis des Raums antwortet nicht
0 bis {n} s
eine Zahl ist nicht endlich
eine Wand könnte nahe sein
voraus sind Wand oder Möbel
ein um {n} s schnellerer Weg wurde frei: sie nimmt ihn
über dem Landeplatz, sie landet
nimmt wieder Befehle an
ein Hindernis von {who} wird abgelehnt: {why}
vorher kam ein Befehl zum Anhalten oder Landen
angekommen
angekommen, sie sieht nach
höchstens {d} m/s, und nur beim Bewegen von Hand
höchstens {n} druckbare Zeichen
kam neben ihrem Kurs zur Ruhe: weiter von dort
kommt zur Sicherheit zurück
Koordinaten bis {d} m
Motoren abschalten
von hier aus
sobald sie in der Luft ist
Drohne empfing keine Befehle
Notlandung durch Benutzer
Notaus aufgehoben
fliegt zum Ziel
darunter oder daneben sind Möbel oder eine Wand
darunter stehen Möbel
goal ist kein Ort in einem Raum
hält
bleibt hier: {why}
schwebt und nimmt bis „Fortsetzen“ keine Flugbefehle an
id ist kein Name
in Ruhe
sie passt nicht zur Eigenbewegung der Drohne
hier soll sie langsam fliegen
es ist schneller als {d} m/s
sie ist zu weit von dort, wo die Drohne sein kann
sie ist zu alt
es liegt weit außerhalb der Karte
er nennt weder Ort noch Ziel
sie zeigt {d} m Bewegung, obwohl die Drohne still lag: Ist es ein anderer Körper? Drohne anheben, um zu zeigen, wo sie ist
sie bleibt bis aufs letzte Bit gleich, obwohl die Drohne fliegt
es wurde in der Zukunft gesehen
seine Sicherheit liegt nicht zwischen 0 und 1
ihre Eigenbewegung ist unsicher
seine Größe ist unmöglich (höchstens {d} m)
ihr Ultraschall zeigt überall etwas
ihr Zeitstempel ist nicht neuer als der letzte
ihr Zeitstempel liegt in der Zukunft
hier landen
landet trotzdem: {why}
landet zur Sicherheit
landet hier
Landung nach {n} s nicht bestätigt: wird weiter verlangt
landet {d} m daneben
Notaus verlassen
look_at ist kein Ort in einem Raum
look_s ist falsch
lange genug nachgesehen, kommt zurück
sieht nach
prüft, was darunter ist
Abschalten der Motoren
Motoren sind aus
von Hand bewegt
von {who} von Hand bewegt
nicht mehr von Hand bewegt
von Hand bewegt: {why}
weicht zur Seite aus
geht zum Landen {d} m zur Seite, nach eigener Bewegung
kein freier Landeplatz im Umkreis von 2 m: hält sich nach eigener Bewegung
kein freier Landeplatz im Umkreis von 2 m: wartet in der Luft
{n} s lang kein Befehl: kommt zurück
kein Ort namens {name}: meinten Sie {place}? Bekannte Orte: {places}
kein Ort namens {name}; bekannte Orte: {places}
kein Weg nach Hause, landet hier: {why}
von zu Hause führt kein Weg hierher: {end} {place}
kein Flug dorthin hält die Grenzen der Drohne ein
niemand kommt näher: kehrt an ihren Ort zurück
nicht alle seine Zahlen sind endlich
landet nicht: {why}
landet nicht: {why}. „Landen“ drücken, um trotzdem hier zu landen
auf {name} lässt sich nichts schreiben ({why})
Bewegen von Hand
Hindernis abgelehnt: {why}
am Boden
auf Befehl
place ist kein Name
kommt zurück
sender ist kein Name
jemand
über der Drohne hängt etwas: dorthin tragen, wo die Luft darüber frei ist
hier wurde darunter etwas gefunden
auf dem Landeplatz scheint etwas {d} m Hohes zu liegen: Ist er frei?
darunter scheint etwas {d} m Hohes zu stehen
steht {d} m über dem Boden: auf etwas
steht {d} m höher als beim Start: auf etwas
bleibt hier
Anhalten
startet, dann
der Akku ist zu leer: {p} %, hin und zurück ({n} s) braucht {q} %; laden
nicht von der Drohne bestätigt: {what}
die Drohne meldet ihre Bewegung nicht
die Drohne fliegt schon
die Drohne fliegt, obwohl ihre Motoren aus waren: sie landet
die Drohne ist unterwegs: erst „Schweben“ drücken
die Drohne ist im Notaus: Motoren aus
die Drohne ist ohne Befehl in der Luft: sie hält
die Drohne landet
die Drohne ist am Boden
die Drohne startet schon
die Drohne ist zu schnell, um dorthin abzubiegen: erst anhalten lassen
die Drohne landet von selbst
die Drohne meldet: {what}
die Drohne meldet: {what}; sie landet
die Drohne steht in einer Verbotszone: hinaustragen
die Drohne wurde am Boden bewegt: die Ortung beginnt neu
der Ultraschall zeigt überall etwas: Landung nach der Höhe der Ortung
voraus endet der erlaubte Bereich
das Ziel
der letzte Ort von {who} wird nicht mehr freigehalten
Befehl: {what}; erlaubt: {limit}
die Lage ist kein Einheitsquaternion
dort ist der Landeplatz von {who}
der Autopilot ist ausgefallen ({name}): sie landet
der Start
der Weg ist frei: weiter
der Weg bleibt versperrt
es sind mehr als {n} zugleich
es gibt einen Weg: weiter
es gibt kein Ziel
zu viele Befehle in einer Sekunde
dauerte zu lange
die Ortung ist nur zum Teil glaubwürdig, {n} der letzten {m} Posen nicht: {why}
die Ortung ist seit {n} s unglaubwürdig: {why}
velocity ist falsch
wartet hier: {why}
{asked}, von {who}: {what}
{asked} {place}
{asked}: {what}
{end} ist kein Ort: {place}
{end} {place} ist einem Hindernis zu nah
{end} {place} ist einem Hindernis zu nah ({d} m)
{end} {place} ist einem Hindernis zu nah: {d} m vom Rumpf, nötig sind {m} m
{end} {place} liegt in einer Verbotszone
{end} {place} liegt in einem Hindernis
{end} {place} liegt außerhalb der Karte
{end} {place} liegt außerhalb des Raums
{thing} ist im Weg, {d} m voraus
{thing} ist im Weg: sie fliegt herum
{thing} ist nah
zu lange: {what}
{who} kommt näher
{who} kommt näher, und zum Ausweichen ist kein Platz
{who} kommt näher, und zum Ausweichen ist kein Platz: sie landet hier
{who} kommt näher: sie weicht aus
{who} kommt näher: Start abgebrochen
{who} flog und ist nicht mehr zu sehen: ihr letzter Ort bleibt frei
{who} gibt zu viele Befehle: {n} in einer Sekunde abgelehnt (Grenze {m} je Sekunde)
{who} ist darunter
{who} läuft in den Weg: sie fliegt herum
{who} läuft in den Weg: sie wartet
{who}: {why}
{why}, sobald sie kann: {what}
{why}, {d} ms zu spät
{why}, {more}
{why}: sie landet hier
{why}: sie hält an
{why}: um die Drohne muss Luft frei sein
{why}: {found}, nötig: {limit}; wohl weil: {cause} ({value}): {mend}
{why}: {found}; {mend}
{why}; nächster freier Ort: ({x}; {y}) m
{why}; kein Weg nach Hause, wartet hier: {more}
{why}; kein Weg weiter, wartet hier: {more}
ein Browser kam herein über {link}: {what}
ein anderer Tab meldet sich mit eigener Verbindung
er darf alles
er darf fliegen
er darf zusehen
er darf zusehen und fragen
nach dem Weg ließ sich nicht fragen: {why}
niemand steuert: erst die Steuerung übernehmen
erst anmelden
die Konsole wurde neu gestartet: was inzwischen geschah, fehlt hier
den Link des Terminals
den Link von {who}
dieser Befehl braucht weder Ort noch Ziel: {asked}
Ihre Rolle ist {name}, nötig ist {what}: den Betreiber von Housefly fragen
{who} hat die Steuerung an {name} übergeben
{who} steuert
{who} hat die Steuerung abgegeben
{who} darf nicht mehr fliegen und steuert nicht mehr
{who} hat Orte und Zonen gespeichert
{who} hat die Steuerung übernommen
{who} hat eine Änderung an Orten und Zonen zurückgenommen
{who} war {n} s still und steuert nicht mehr: jetzt steuert niemand
{who}: {what}, doch der Autopilot schweigt
Ort oder Ding ansehen
Fliegt zum Blickpunkt, macht ein Bild und kommt zurück.
Wo ist etwas
Nennt den Ort aus dem Gedächtnis; ist er alt oder unsicher, sieht sie nach.
Rundgang
Sieht jeden Ort an, macht Bilder und meldet, was sich geändert hat.
Nachtrunde
Sieht leise einmal überall nach; meldet nur, was nicht stimmt.
Nachsehen, wer an der Tür ist
Fliegt zum Eingang, filmt, wer dort steht, und meldet es allen.
Umsehen
Macht Bilder in alle Richtungen, am Startort oder an einem Ort.
Ist alles in Ordnung?
Sagt, wie es allen geht; sieht nach, wer gestürzt oder nachts aufgestanden ist.
Bestand
Sagt, was in Schrank und Kühlschrank ist, und macht von beiden ein Bild.
Jemandem folgen
Behält eine Person eine Weile im Bild; sucht sie, kommt dann zurück.
Verlorenes suchen
Sieht nach, wo es wohl ist, zeigt Bilder und fragt; sagt, was nicht angesehen wurde.
Zu jemandem kommen
Fliegt zu einer Person, wendet sich ihr zu und wartet; kommt auf Wunsch oder nach einer Weile zurück.
was anzusehen ist
wie lange hinsehen
wie lange jeweils hinsehen
wo nachzusehen ist, in dieser Reihenfolge
wo nachzusehen ist, in dieser Reihenfolge; whole floor zeigt alles
wo Besuch steht
wie lange dort schweben
wie lange dort warten
wie lange
wie viele Bilder
ein Ding oder eine Person
was fehlt
nur eine Person davon
wann hinfliegen
ab wann es als alt gilt
Wartezeit je Bild
für alles zusammen
wo; sonst über dem Landeplatz
wen; anybody ist, wer am nächsten ist
zu wem; anybody ist, wer am nächsten ist
was nachts aus sein muss
Namen, mit Komma getrennt
mit {name} verbunden, doch es kommt nichts
mit {name} verbunden, doch es kommen keine Messungen
mit {name} verbunden, doch es kommt nichts Neues; läuft {what}, ohne Pause?
ein neuer Treiber fand sie in der Luft: sie schwebt nur und landet
von {name} kommen Bilder, doch ihre Zeit steht; ist {what} angehalten?
Daten kommen nicht von {name}; in tracking.address {other} eintragen
sind es Millimeter? In der Ortungssoftware Meter wählen
seine Uhr geht {n} s vor; es gilt die Zeit der Ankunft
seine Uhr geht {n} s nach; es gilt die Zeit der Ankunft
kein MQTT-Broker antwortet unter {name}; läuft er (mosquitto), stimmt mqtt.port?
kein Körper ist zu sehen; läuft die Ortung?
unter {name} antwortet nach {n} s keine Drohne: ist sie eingeschaltet und der Rechner in ihrem WLAN?
niemand antwortet unter {name}; ist das Gerät an und in diesem Netz?
niemand antwortet unter {name}; läuft {what}, und sendet es?
niemand hört darauf; läuft der Prozess „perception“?
noch nicht mit {name} verbunden
noch nicht gehört; sendet sonst mindestens alle {k} s
von {name} kam nichts
abgemeldet; ist das Gerät an und in Reichweite des Netzes?
Posen werden abgelehnt, {pose}: {ask}
sendet mehr als {n} Nachrichten je Sekunde; der Rest fällt weg
schweigt seit {n} s; sendet sonst mindestens alle {k} s
meldet mehr als {n} Dinge
der MQTT-Broker unter {name} weist uns ab ({error})
der MQTT-Broker unter {name} weist uns ab; mqtt.username und mqtt.password_file prüfen
die Verbindung zu {name} ging verloren
der Prozess des Treibers antwortet nicht (Protokoll: driver.log)
die Drohne hat ihre Grenzwerte noch nicht bestätigt
die Drohne schweigt; ist sie eingeschaltet?
die Drohne behält {setting} = {kept} statt {wanted}
der Autopilot schweigt
der Prozess des Raums antwortet nicht (Protokoll: room.log)
was unter {name} antwortet, spricht nicht {protocol} ({error})
{name} sendet mehr als {n} Bilder je Sekunde; der Rest fällt weg
{name} sendet mit y nach oben; in der Ortungssoftware z nach oben wählen
{name}: keine Tiefenbilder
{name}: Lesen misslang ({error})
„{title}“ hat die Drohne
„{title}“ darf von hier nicht beginnen
„{title}“ hat die Drohne übernommen
Gewünscht von {who}
„{title}“ fliegen? {why}.
„{title}“ fortsetzen? {why}.
„{title}“ beginnen? {why}.
Der Auftrag hat lange gewartet
Das Programm wurde neu gestartet
eine dringendere Aufgabe hat die Drohne übernommen
jemand
jemand steuert die Drohne
vor dem Beginn hat jemand der Drohne befohlen
ein Schritt misslang
ein Schritt brach ab ({error}); das Protokoll sagt, warum
auch von {who} gewünscht
die Probe war nicht möglich ({why}), daher kein Flug
ein rechtzeitiger Beginn war nicht möglich
als Nächstes an der Reihe
unbekannt, was anzusehen ist
wird geprobt
dauert {time} und braucht {p} % der Ladung; über den Heimweg hinaus sind {q} % übrig
wurde abgebrochen
sie würde {d} m neben dem Landeplatz landen
die Frist ist schon vorbei
niemand ist zu sehen
niemand hat rechtzeitig Ja gesagt
nach {time} nicht fertig
noch nicht geprüft
nichts fliegt
am Boden, bereit
andere Aufgaben laufen
die Drohne ist nicht bereit
die Drohne tut, was diese Aufgabe nicht befahl: {phase}
die Drohne würde {thing} berühren
die Motoren sind aus: die Drohne fiel oder wurde abgeschaltet
der Autopilot antwortet nicht
der Autopilot hat den Start noch nicht freigegeben
das Programm endete im Flug; ohne neuen Befehl beginnt nichts wieder
das Programm endete währenddessen
die Warteschlange war voll, anderes ging vor
die Warteschlange war voll, „{title}“ ging vor
die Aufgaben haben eben begonnen
{n} davor
{n} Aufgaben von {who} warten schon; eine beantworten oder abbrechen
{n} Aufgaben warten schon; eine abbrechen oder später fragen
{what} dauerte länger als {n} s
{what}: {why}
{who} hat abgebrochen
{who} hat fortgesetzt
{who} hat unterbrochen
{who} hat Nein gesagt
{who} hat Ja gesagt
{who} hat übernommen: {what}
erledigt
die Aufgabe dauerte zu lange`.split(`
`).map((n,t)=>[i.substr(5*t,5),n]));var r={"STOP FAILED":"STOP GESCHEITERT",STOPPED:"STOP AKTIV","STOP sent":"STOP gesendet","When this page last heard: {words}":"Nach letztem Stand: {words}","sending …":"wird gesendet …","hover at once and stay":"Halt: sofort schweben und bleiben",Space:"Leertaste",Resume:"Fortsetzen","Resume after STOP":"Nach STOP fortsetzen",hold:"halten","not ready":"nicht bereit","Cut motors":"Motoren aus","Cut motors: motors stop, drone falls":"Motoren aus: Sie bleiben stehen, die Drohne fällt","it falls, hold 1 s":"sie fällt, 1 s halten",Reset:"Zurücksetzen","Reset after a cut":"Nach dem Abschalten zurücksetzen","Take off":"Starten",Land:"Landen","Land here":"Hier landen",Hover:"Schweben","Stay where it is":"An Ort und Stelle bleiben",Home:"Heim","Fly home":"Heimfliegen","Fly home and land":"Heimfliegen und landen","Fly there and stay":"Hinfliegen und bleiben","Look there and come back":"Dort nachsehen und zurück","Look at {place} and come back":"{place} ansehen und zurück","Look and come back":"Nachsehen und zurück","Choose where to look":"Ziel wählen","Not ready: see why":"Nicht bereit: Grund ansehen","No contact":"Keine Verbindung",More:"Mehr","More orders":"Weitere Befehle",Orders:"Befehle",Close:"Schließen","{label}: hold {n} s":"{label}: {n} s halten","Hold it for {n} s: a tap does nothing.":"{n} s lang halten: Antippen bewirkt nichts.","Hold Enter.":"Eingabetaste halten.",Places:"Orte","Where to?":"Wohin?","Point {x}, {y} m":"Punkt {x} / {y} m","Forget this goal":"Ziel verwerfen","The path keeps {d} m away from everything.":"Der Weg hält {d} m Abstand zu allem.","The goal was moved {d} m, to the nearest free point.":"Das Ziel wurde um {d} m zum nächsten freien Punkt verschoben.","Looking for a path …":"Weg wird gesucht …","Choose a place, or point on the map.":"Ort wählen oder auf die Karte zeigen.","The battery is too low for a flight.":"Der Akku reicht nicht für einen Flug.","No contact with the server.":"Keine Verbindung zum Server.","No contact with the pilot.":"Keine Verbindung zum Autopiloten.","No contact with the server":"Keine Verbindung zum Server","Opened in another tab":"In anderem Tab geöffnet","this one only watches the past":"dieser zeigt nur Vergangenes","Session ended":"Sitzung beendet","use a fresh link":"neuen Link verwenden",Connecting:"Verbinden","for {n} s":"seit {n} s","Waiting for the pilot":"Warten auf den Autopiloten","This console was opened in another tab; that one is live.":"Diese Konsole ist in einem anderen Tab geöffnet; nur jener ist aktuell.","This browser's session has ended. Ask for a fresh link.":"Die Sitzung dieses Browsers ist beendet. Um einen neuen Link bitten.","No contact with the server: nothing is known of the drone.":"Keine Verbindung zum Server: Über die Drohne ist nichts bekannt.","No word from the server for {n} s: what is shown is of then.":"Seit {n} s nichts vom Server: Die Anzeige ist von damals.","What held then: {then}. STOP from this page may not arrive.":"Damals galt: {then}. STOP von dieser Seite kommt vielleicht nicht an.","Not known: no contact with the server":"Unbekannt: keine Verbindung zum Server","In flight":"Im Flug","Not ready: {why}":"Nicht bereit: {why}",Ready:"Bereit",more:"mehr","{n} check|{n} checks":"{n} Prüfung|{n} Prüfungen","Checks before take-off":"Prüfungen vor dem Start","Before take-off":"Vor dem Start","If contact is lost now:":"Bei Verbindungsverlust jetzt:","As contact was lost:":"Beim Verbindungsverlust:","If contact is lost:":"Bei Verbindungsverlust:","no take-off":"kein Start",look:"nachsehen",well:"in Ordnung","What is to be mended":"Was zu beheben ist","{who} has control. You watch.":"{who} steuert. Sie sehen zu.","Nobody has control: take it first.":"Niemand steuert: erst die Steuerung übernehmen.","You lost control; {who} has it now":"Sie haben die Steuerung verloren; jetzt steuert {who}","This page was silent and lost control; nobody has it: take it again":"Diese Seite schwieg und verlor die Steuerung; niemand steuert: wieder übernehmen","You have control":"Sie steuern","{who} has control":"{who} steuert","has control":"steuert","Take control":"Steuern","Take over":"Übernehmen","Take over control":"Steuerung übernehmen","Release control":"Steuerung abgeben","Hand over":"Übergeben","You watch.":"Sie sehen zu.","{who} has control; STOP and Land work.":"{who} steuert; STOP und Landen gehen.",Control:"Steuerung","One person has control.":"Eine Person steuert.","Everybody else watches, and can still stop or land the drone.":"Alle anderen sehen zu und können die Drohne trotzdem anhalten oder landen.","Your name":"Ihr Name","Viewer {n}":"Zuschauer {n}","(you)":"(Sie)",Invite:"Einladen",Live:"Live",Tasks:"Aufgaben",Screens:"Ansichten","Round trip between this browser and the server":"Laufzeit zwischen diesem Browser und dem Server, hin und zurück","lag {time}":"Verzug {time}","battery {p}":"Akku {p}","{site} · mode {mode}":"{site} · Modus {mode}",Ask:"Fragen",Details:"Details",Keys:"Tasten","Drone and house":"Drohne und Haus",Battery:"Akku","Battery unknown":"Akkustand unbekannt","{p} to land":"{p} zum Landen","{p} to come home":"{p} für den Heimweg","{p} usable":"{p} nutzbar","about {time} of flight":"etwa {time} Flugzeit","land {p}":"Landen {p}","home {p}":"Heimweg {p}","usable {p}":"nutzbar {p}","Event log":"Ereignisse",Log:"Protokoll","Which lines":"Welche Zeilen","all^lines":"alle","drone^lines":"Drohne","room^lines":"Raum","warnings^lines":"Warnungen","Show the room as it was then":"Den Raum von damals zeigen","Only of":"Nur von",everything:"alles",info:"Hinweis",warning:"Warnung",fault:"Störung",now:"jetzt","{n} days ago":"vor {n} Tagen","{n} h ago":"vor {n} h","{n} min ago":"vor {n} min","{n} s ago":"vor {n} s","by {name}":"durch {name}",Tracking:"Ortung",Drone:"Drohne",Picture:"Bild","Pilot loop":"Regeltakt",Delays:"Verzögerung",Filter:"Filter",Push:"Schub",Position:"Position",Motion:"Bewegung",State:"Zustand","p99 {d} ms late · {n} missed":"p99 {d} ms spät · {n} ausgefallen","tracking {one} · command {other}":"Ortung {one} · Befehl {other}","{one} · height {other}":"{one} · Höhe {other}","{d} m/s² · load {p}":"{d} m/s² · Last {p}","{state} · safety {mode}":"{state} · Sicherheit {mode}","by itself":"endet von selbst","once it stands":"bis sie steht","a fresh order on the ground":"bis zu einem neuen Auftrag am Boden","a reset":"bis zum Zurücksetzen","nothing yet":"noch nichts",Sensors:"Sensoren","none heard yet":"noch keiner gehört","{n} of {all} needs a look|{n} of {all} need a look":"{n} von {all} braucht einen Blick|{n} von {all} brauchen einen Blick","all is kept":"alles wird aufbewahrt","all {n} are well":"alle {n} in Ordnung",memory:"Gedächtnis","never heard":"nie gehört",Layers:"Ebenen","People and things":"Personen und Dinge","Safety margins":"Sicherheitsabstände","Tracking coverage":"Ortungsbereich","Edit the room":"Raum bearbeiten","number: how many of {n} cameras see {d} m above the floor;":"Zahl: wie viele von {n} Kameras {d} m über dem Boden sehen;","hatched: fewer than {n}, no tracking":"schraffiert: weniger als {n}, keine Ortung","The past":"Vergangenes","Fetching the past":"Vergangenes wird geladen","Back to now":"Zurück zu jetzt","Shift + Esc, held 1 s":"Umschalt + Esc, 1 s halten","Arrow keys":"Pfeiltasten","Enter, held":"Eingabe halten",L:"L",H:"H",M:"M",R:"R",T:"T","?":"?",Esc:"Esc","STOP: hover at once; in flight whatever has the focus":"STOP: sofort schweben; im Flug immer","Cut motors: the drone falls":"Motoren aus: Die Drohne fällt","Move the goal by one cell":"Ziel um ein Feld verschieben","Send the drone to look and come back":"Nachsehen und zurückkommen lassen","Swap map and picture":"Karte und Bild tauschen","Edit the room, and back":"Raum bearbeiten, und zurück","Go to the tasks, and back":"Zu den Aufgaben, und zurück","Show or hide this list":"Diese Liste zeigen oder verbergen","Close a panel":"Fenster schließen","Space stops the drone even while you type, as long as it flies.":"Die Leertaste hält die fliegende Drohne an, auch während Sie tippen.","On the ground it types a space, or presses the button that has the focus.":"Am Boden schreibt sie ein Leerzeichen oder drückt die gewählte Schaltfläche.","Letters and ? are keys":"Buchstaben und ? sind Tasten","Where is, go to":"Wo ist, fliege zu","Where is … / go to …":"Wo ist … / fliege zu …","Close the answer":"Antwort schließen","At {time}:":"Um {time}:","Fly there and look":"Hinfliegen und nachsehen","Choose it as the goal":"Als Ziel wählen","Look there":"Dort nachsehen","Nobody knows where that is.":"Niemand weiß, wo das ist.","Go to {place}":"Fliege zu {place}","Where is {thing}":"Wo ist {thing}",Doorbell:"Türklingel","The bell rings.":"Es klingelt.","The bell rings. Hold to fly there and look; it comes home by itself.":"Es klingelt. Halten, um nachzusehen; sie kommt von selbst zurück.","Look who is at {place}":"Nachsehen, wer da ist: {place}","Look^order":"Nachsehen",Ignore:"Nicht beachten",door:"Tür","Someone at the {place}":"Jemand ist da: {place}","This device":"Dieses Gerät","Ring for the doorbell and for faults":"Bei Türklingel und Störung läuten","Install as an app":"Als App installieren","As an app: Share, then Add to Home Screen.":"Als App: Teilen, dann „Zum Home-Bildschirm“.","This browser does not keep the screen on while the drone flies.":"Dieser Browser lässt den Bildschirm im Flug nicht an.","It sounds while the page is open.":"Es läutet, solange die Seite offen ist.","It sounds from your next touch on, while the page is open.":"Es läutet ab der nächsten Berührung, solange die Seite offen ist.","It notifies beside other pages.":"Auch neben anderen Seiten kommt eine Nachricht.","Notifications are forbidden: its settings in the browser allow them.":"Mitteilungen sind verboten: im Browser erlauben.","Housefly: look at the drone":"Housefly: nach der Drohne sehen",Watch:"Zusehen",Fly:"Fliegen","may see everything, and STOP or land the drone":"darf alles sehen und die Drohne anhalten oder landen","may watch and ask; a flight waits for your yes":"darf zusehen und bitten; ein Flug wartet auf Ihr Ja","may take control and fly":"darf steuern und fliegen","What the guest may do":"Was der Gast darf","No link could be made.":"Es konnte kein Link erstellt werden.","Your role is “{role}”: ask who runs Housefly for a link.":"Ihre Rolle ist „{role}“: Um einen Link bitten, wer Housefly betreibt.","What may the other one do? STOP is for everybody.":"Was darf der Gast? STOP ist für alle da.","The link was used: the guest {may}.":"Der Link wurde benutzt: Wer ihn öffnete, {may}.","The link expired: make a new one.":"Der Link ist abgelaufen: einen neuen erstellen.","The first to open it {may}. It works once, for:":"Wer den Link zuerst öffnet, {may}. Er gilt einmal, noch:","Only this machine reaches the console.":"Nur dieses Gerät erreicht die Konsole.","For a phone, restart with:":"Für ein Handy Housefly beenden und so starten:","QR code of the link":"QR-Code des Links",Copied:"Kopiert","Copy link":"Link kopieren",Share:"Teilen","Ask for something":"Um etwas bitten","Look at the entrance, where is the cup …":"Schau zum Eingang, wo ist die Tasse …","“{words}”, answered {age}":"„{words}“, beantwortet {age}","Yes, do it":"Ja, ausführen","The services are not running.":"Die Dienste laufen nicht.","The services are not running: nothing can be asked for now.":"Die Dienste laufen nicht: Jetzt ist nichts möglich.","What is shown here is what was known {age}.":"Die Anzeige ist von {age}.","services not running":"Dienste laufen nicht","Simulated doorbell":"Simulierte Türklingel","Ring the doorbell":"Klingeln","This room is simulated: press, and a visitor comes to the door.":"Dieser Raum ist simuliert: Drücken, und jemand kommt zur Tür.","What can be done":"Was möglich ist",Services:"Dienste","Not known yet.":"Noch nicht bekannt.","Say first: {what}.":"Zuerst angeben: {what}.",Start:"Ausführen","Start: {title}":"Ausführen: {title}",Rehearse:"Proben","Rehearsing …":"Wird geprobt …",Questions:"Fragen","{n} more question|{n} more questions":"{n} weitere Frage|{n} weitere Fragen","Question of task {n}":"Frage von Aufgabe {n}","Without an answer it counts as “{choice}” in {time}.":"Ohne Antwort gilt in {time}: „{choice}“.",Now:"Jetzt","Nothing is asked for.":"Es liegt nichts an.","Task {n}":"Aufgabe {n}","{words}: task {n}":"{words}: Aufgabe {n}",Pause:"Pause","Go on":"Weiter",Cancel:"Abbrechen",Steps:"Schritte","waiting for a yes":"wartet auf ein Ja",queued:"in der Warteschlange",running:"läuft",paused:"angehalten",suspended:"unterbrochen",waiting:"wartet",skipped:"übersprungen",done:"erledigt",failed:"gescheitert",cancelled:"abgebrochen",refused:"abgelehnt",expired:"abgelaufen","asked for by {who}":"von {who} verlangt","asked for":"verlangt",", because of {cause}":", Anlass: {cause}","in the console":"in der Konsole","on the command line":"auf der Befehlszeile","over HTTP":"über HTTP","over MQTT":"über MQTT","by a webhook":"durch einen Webhook","by an assistant":"durch einen Assistenten","by a rule":"durch eine Regel","The bell rings":"Es klingelt","Somebody may have fallen":"Vielleicht ist jemand gestürzt","Who walks there may close the way for a moment: ask again when it is free.":"Wer dort geht, versperrt vielleicht kurz den Weg: noch einmal bitten, wenn er frei ist.",yes:"ja",no:"nein","What was":"Was war",History:"Verlauf",Clips:"Clips",Rules:"Regeln","No task has ended yet.":"Noch keine Aufgabe ist beendet.","Older tasks":"Ältere Aufgaben","that is all":"das ist alles",Trigger:"Auslöser",Decision:"Entscheidung","It was not rehearsed.":"Es wurde nicht geprobt.",Flight:"Flug","{time}, in the air for {span}.":"{time}, {span} in der Luft.","It did not begin.":"Sie hat nicht begonnen.","It did not fly.":"Es wurde nicht geflogen.","Recorded:":"Aufgezeichnet:",Outcome:"Ergebnis","None.":"Keiner.","None is kept any more.":"Keiner mehr aufbewahrt.",Clip:"Clip","Show clip, {time}":"Clip zeigen, {time}","Show snapshot":"Foto zeigen",Save:"Speichern","Save all":"Alle speichern","Save all of these":"Diese alle speichern","Picture of {title}":"Bild: {title}","Clip of {title}":"Clip: {title}","This clip is gone, or this browser cannot show it.":"Diesen Clip gibt es nicht mehr, oder der Browser kann ihn nicht zeigen.",Keep:"Behalten","Keep no longer than others":"Nicht länger als andere behalten",Delete:"Löschen","Delete this clip":"Diesen Clip löschen",When:"Wann",Place:"Ort",Thing:"Ding",People:"Personen",For:"Für","Because of":"Anlass",End:"Ende",Privacy:"Privatsphäre",Kept:"Aufbewahrt",Size:"Größe","{service}, task {n}":"{service}, Aufgabe {n}","missing: a crash or a full disk cut it off":"fehlt: durch Absturz oder volle Platte abgeschnitten","a part of the picture is blank, as the site says":"ein Teil des Bildes ist abgedeckt, wie eingestellt","until somebody deletes it":"bis jemand ihn löscht","until {time}":"bis {time}","Which clips":"Welche Clips",person:"Person",place:"Ort",thing:"Ding",time:"Zeit",any:"beliebig","any time":"jederzeit",today:"heute","this week":"diese Woche","this month":"dieser Monat","{n} or more clips.":"{n} oder mehr Clips.","{n} clip.|{n} clips.":"{n} Clip.|{n} Clips.","There is no such clip.":"Keinen solchen Clip gefunden.",snapshot:"Foto","cut off":"abgeschnitten","Older clips":"Ältere Clips","There is no rule.":"Es gibt keine Regel.","(off)":"(aus)","What would have happened last week?":"Was wäre letzte Woche geschehen?","What the rules would have done":"Was die Regeln getan hätten","Nothing.":"Nichts.","Mode of the house":"Modus des Hauses",Mode:"Modus","home^mode":"zu Hause","away^mode":"abwesend","night^mode":"Nacht","privacy^mode":"privat","maintenance^mode":"Wartung",recording:"Aufnahme","Taken by":"Aufgenommen von","First steps":"Erste Schritte","Choose a place on the map, or ask above.":"Einen Ort auf der Karte wählen oder oben fragen.","Hold the large button to fly.":"Zum Fliegen die große Taste halten.","STOP stops at once. It works for everybody, at any time.":"STOP hält sofort an. Für alle, jederzeit.",OK:"OK","Close the hints":"Hinweise schließen","Show the first steps again":"Erste Schritte noch einmal zeigen","Waiting for the room":"Warten auf den Raum","Map of the room":"Karte des Raums","Floor plan with the drone. Arrow keys move the goal; a list of places follows.":"Grundriss mit der Drohne. Pfeiltasten verschieben das Ziel; danach folgen die Orte.",Legend:"Legende","People and things are not shown: {why}.":"Personen und Dinge fehlen: {why}.","kept free by order":"Verbotszone","too close to fly":"zu eng zum Fliegen","{n} in the way that no map knows":"{n} im Weg, der Karte unbekannt","{p} sure":"{p} sicher","told before":"früher gemeldet","Place unknown: {names}":"Ort unbekannt: {names}","{name} (in {holder})":"{name} (in {holder})","height {d} m, no curve is flown":"Höhe {d} m, keine Kurve","height unknown":"Höhe unbekannt","{low} to {high} m":"{low} bis {high} m","height {heights} over {length} m in {n} s, up to {fastest} m/s":"Höhe {heights} auf {length} m in {n} s, bis {fastest} m/s","± {one} in the plane, ± {other} in height":"± {one} in der Ebene, ± {other} in der Höhe","; stops in {d} m":"; hält nach {d} m","Height unknown":"Höhe unbekannt","Height {d} metres":"Höhe {d} Meter","Flight height":"Flughöhe","0 to {d} m/s, a dot each second":"0 bis {d} m/s, ein Punkt je Sekunde","stops here if it brakes now":"hält hier, wenn sie jetzt bremst","Zoom of the map":"Zoom der Karte","Zoom in":"Vergrößern","Zoom in (+)":"Vergrößern (+)","Zoom out":"Verkleinern","Zoom out (-)":"Verkleinern (-)","Whole room":"Ganzer Raum","Whole room (0)":"Ganzer Raum (0)","The drone is out of view: show it":"Die Drohne ist nicht im Bild: zeigen","Show the drone":"Drohne zeigen",Time:"Zeit","Live again: {why}":"Wieder live: {why}","Back to live":"Zurück zu live","● Live":"● Live","Time shown":"Gezeigte Zeit","How far back":"Wie weit zurück","10 min":"10 min","1 h":"1 h","6 h":"6 h","1 day":"1 Tag","1 week":"1 Woche","Flight at {time}, {span} long":"Flug um {time}, {span} lang","Flight at {time} to {goal}, {span} long":"Flug um {time} zu {goal}, {span} lang",", with warnings":", mit Warnungen",", with faults":", mit Störungen","{name}: look at it again":"{name}: noch einmal ansehen",Play:"Abspielen","How fast":"Wie schnell","Moment of the recording":"Zeitpunkt der Aufzeichnung","{time} of {span}":"{time} von {span}","Recorded, not live":"Aufzeichnung, nicht live",Recorded:"Aufgezeichnet","Log, recorded":"Protokoll, aufgezeichnet","Log of the recording":"Protokoll der Aufzeichnung","Recorded picture":"Aufgezeichnetes Bild","No picture of this moment was kept.":"Von diesem Zeitpunkt gibt es kein Bild.","nobody saw the drone":"niemand sah die Drohne","{high} m high, {fast} m/s, battery {p}":"{high} m hoch, {fast} m/s, Akku {p}","The drone may be in the air: what is live stays on the screen.":"Die Drohne ist vielleicht in der Luft: Die Gegenwart bleibt im Bild.","the drone may be in the air":"die Drohne ist vielleicht in der Luft","a goal was chosen":"ein Ziel wurde gewählt","STOP was pressed":"STOP wurde gedrückt","never seen":"nie gesehen","has {names}":"hat {names}","in it: {names}":"darin: {names}","idle^phase":"bereit","taking off^phase":"startet","flying to goal^phase":"Hinweg","looking^phase":"sieht nach","holding^phase":"schwebt","returning^phase":"Rückweg","landing^phase":"landet","The view in space could not be fetched: no contact with the server.":"Die Raumansicht ließ sich nicht laden: keine Verbindung zum Server.","Fetching the view in space …":"Raumansicht wird geladen …",Plan:"Plan","3-D":"3-D","The room in space":"Der Raum in 3-D","This browser cannot draw in space (WebGL is off or missing). The plan shows the same.":"Dieser Browser kann nicht in 3-D zeichnen (WebGL fehlt). Der Plan zeigt dasselbe.","Recorded, not live.":"Aufzeichnung, nicht live.","Nobody sees the drone.":"Niemand sieht die Drohne.","The drone was seen {time} ago.":"Die Drohne wurde vor {time} gesehen.","Drag to turn, two fingers or the wheel to come nearer.":"Ziehen zum Drehen, zwei Finger oder das Rad zum Nähern.","People are where they were last seen; pale is long ago.":"Personen stehen, wo sie zuletzt gesehen wurden; blass ist lange her.","Picture from the drone":"Bild der Drohne","No picture yet":"Noch kein Bild","No new picture for {time}":"Seit {time} kein neues Bild","Make the map large, or small again":"Karte vergrößern oder wieder verkleinern","Make the picture large, or small again":"Bild vergrößern oder wieder verkleinern","Swap (M)":"Tauschen (M)","No services run here, and only they keep pictures: nothing was kept.":"Hier laufen keine Dienste, nur sie bewahren Bilder auf: nichts wurde behalten.","Nothing was kept.":"Nichts wurde behalten.","Keep this picture as a photo":"Dieses Bild als Foto behalten",Snap:"Foto","Photo kept":"Foto behalten","in Tasks, Clips.":"unter Aufgaben, Clips.","in Tasks, Clips, until {date}.":"unter Aufgaben, Clips, bis {date}.",Show:"Zeigen","Map being edited":"Karte in Bearbeitung","Floor plan being edited. The list of places and zones follows.":"Grundriss in Bearbeitung. Danach folgen Orte und Zonen.","too close":"zu eng","Tap the map for a new place, drag on it for a new zone, or:":"Für einen neuen Ort auf die Karte tippen, für eine neue Zone ziehen, oder:","Tap or drag on the map to move what is open; Done when it is right.":"Zum Verschieben auf die Karte tippen oder ziehen; Fertig, wenn es stimmt.","Drag on the map to draw the open zone again; Done when it is right.":"Zum Neuzeichnen der Zone auf der Karte ziehen; Fertig, wenn es stimmt.","Edit places and zones":"Orte und Zonen bearbeiten","Places and no-fly zones":"Orte und Verbotszonen","version {n}":"Fassung {n}","version {n}, by {who}":"Fassung {n}, von {who}","never edited":"nie bearbeitet","Add a place":"Ort hinzufügen","Add a zone":"Zone hinzufügen","Places and zones":"Orte und Zonen","new place":"neuer Ort","new zone":"neue Zone","where it starts and lands":"wo sie startet und landet","Not saved yet.":"Noch nicht gespeichert.","The drone keeps the map that it started with.":"Die Drohne behält die Karte vom Start.","What is saved here counts from the next start of Housefly on.":"Gespeichertes gilt ab dem nächsten Start von Housefly.","What is saved here counts from the next start on, or as soon as you use it after Save.":"Gespeichertes gilt ab dem nächsten Start von Housefly oder nach „Jetzt verwenden“.",Discard:"Verwerfen",Undo:"Rückgängig","Go back to the version before":"Zur vorigen Fassung zurück",Remove:"Entfernen","Remove {name}":"Entfernen: {name}",Done:"Fertig",Name:"Name","Reading corner":"Leseecke","In commands: {name}":"In Befehlen: {name}","Hovers at [m]":"Schwebt bei [m]","Looks at [m]":"Sieht auf [m]",height:"Höhe","on map":"auf Karte","x from":"x von","y from":"y von","x to":"x bis","y to":"y bis",Reason:"Grund","Wet floor":"Nasser Boden","Kept free [m]":"Frei halten [m]","These changes were not saved before. Save or Discard them.":"Diese Änderungen sind noch nicht gespeichert: speichern oder verwerfen.","{who} has control, and only who has control may change the room.":"{who} steuert, und nur wer steuert, darf den Raum ändern.","Take control first: only who has control may change the room.":"Erst steuern: Nur wer steuert, darf den Raum ändern.","Give this place a name.":"Diesem Ort einen Namen geben.","In the air the drone keeps the map that it took off with: land first.":"In der Luft behält die Drohne die Karte vom Start: erst landen.","Nobody knows whether the drone flies: the new map waits.":"Niemand weiß, ob die Drohne fliegt: Die neue Karte wartet.","That is being done.":"Das geschieht gerade.","The pilot has not come back. The terminal of Housefly says why.":"Der Autopilot kam nicht zurück. Das Terminal von Housefly sagt, warum.","In use: the drone has this map now.":"In Gebrauch: Die Drohne hat jetzt diese Karte.","The pilot starts again.":"Der Autopilot startet neu.","No flight meanwhile.":"Solange kein Flug.","Use it now":"Jetzt verwenden","The pilot starts again, about {n} s. No flight meanwhile.":"Der Autopilot startet neu, etwa {n} s. Solange kein Flug.","Move by hand":"Von Hand bewegen","Up the map":"Auf der Karte nach oben","Left on the map":"Auf der Karte nach links","Right on the map":"Auf der Karte nach rechts","Down the map":"Auf der Karte nach unten",Climb:"Steigen",Sink:"Sinken","Moving while you hold.":"Bewegt sich, solange Sie halten.","Hovering. Hold an arrow, W A S D or a stick.":"Schwebt. Pfeil, W A S D oder Stick halten.","W A S D or arrows, R F":"W A S D oder Pfeile, R F","While Move by hand is on: move the drone, up and down":"Bei „Von Hand bewegen“: Drohne bewegen, auf und ab","+ − 0":"+ − 0","Map with the focus: nearer, farther, whole room":"Karte gewählt: näher, weiter, ganzer Raum","No drone":"Keine Drohne","To add one: enabled = true under [drone] in the site file.":"Um eine hinzuzufügen, unter [drone] der Standortdatei enabled = true setzen und neu starten.","Floor plan of the room":"Grundriss des Raums"},s=["Wer ist an der Tür?","Ist jemand da?","Ist alles in Ordnung?","Was ist heute passiert?"],o={texts:r,ideas:s,templates:e};export{o as DE};
