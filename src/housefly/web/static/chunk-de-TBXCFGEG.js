import"./chunk-chunk-PVYBGDIB.js";var r=["0000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000","1007111003000102032104231019011111001000004290251011103202020020004030110372000001011003211110100040103210322750400012000100000100101120001201211110002101324301030100001402005401002210130120011022000304101300107312001010023103002204000310000201150101100001113233020600011200000102010121250030200004000101001200002031101230910111010905220214011002002132630000100100010326200850301004634010133000201430010011010063020070003200140010300020110623021205c202200024601100017200002303292310021040400502133200101001000140116100013002212000011001002333202011c0021102300000111113006002100611002121000201140b21611117021002011310532001230020210002002201111312210020101102020001301000001070001010000001003100201313100001000300252000331010021000100201201101220124121036011312401100321023","wuo97cduehc15e4x2zn15yr83iblk6m4b25rv015vsy0phg4hrb250za6d7f3bl7b7xc6lf87ccfat5ivvvbndu9kk6amire9tie0t0q5llk82l2a357uako3h1t1i4km47stc1z13ga6hhm3whxet6kcuvtsmplbradf620i1v3ffeme4qcfk40c8db83w0wq50agiq7p14t6n213toard3fgk9oggkz3v16p9kfzc9nk54a34tja3wcagl6yn1u6ijr413bg68yasgellzpr5w1ih26b157x5xl2emg05p8ehhe955709vuz45rk8jwbon78bcrrciy10d6pneqvc9erc8ss93viqejgk2h9gd9flt10mb6wt8ca63dhrln3m87864hdou3sl6g4me8p635ajvcfjdmisfe0z54ke9de674r4re26ds1r9ltbuypc8tibhapj4wm7vsl8gerrjl9050nl4ipb3gdfw49ul5j5dt7jvg6ls2theezt0sgsi1r8ebg48a10gbkqdff2jqooxgnbja0a8o623c7i17la6g9wevbe1stl89blnohp2r4t66xb1ha7jkqi86ilbut0q85dlo5nap71364hjy7qozcfj835whwyh1kgmthg2ybic6512nhjilxqnzuk7hjjjw3lm07wxkb9rz42rafifcp5gw87sdjnh3mr4ejza1dge3jwg926f113c9jxl6haafc4avfyygi2h6itzbwil1oe3o39l10o28tgr9b61","t4qztdlx29v91jd1j5bkt3mfus3rb0o005v1qhp0mb3m7lbfnruhlac6n11ekwtmsljct2p7au6pwj4shpm7lgcoq5mg742ob521s4s1y31sl42e5hpm1p63mrg0jk2a6pnhssfpq3dig5fho8krc3moe2shho8h09264ry5dr4tw465657flvp9tlnugl5vyplgmy6umh76kb3t77s48ah1blm1do26mimao64wuwurranyqyy5hi2d0vwinzqrwxhtd7dazkarjmih9nfz2x1e7uzr45kvpvtezqeko5wq4hi63rns01v470l9muhsp9gckli0mlcomi1evwfsou0ilyfjzyo053aml0wm03qtxxr54tcbqyoz7pg9l3vahpojiztk5iqchysen4e9j6xc4a5asvhtqqoc8s8ow0nu8d8aao04klsmox5khyug98f81wqjdvkv9sla5hsydm11shyjpiwaf2tzt34gk7nsg2ppyky8h6su9wfc3biiw9klxm34ddyqv4hyqeidmq1q5be6bqzg2watrwxfbik824ebrdtza1cu8pr115r5d9o4rpob4y4zq4ps9yh7dtghb3en0xc4q8t184sbi1naljdugo2pag8ndmi6ueyp4ngwxkx8dp33cx78azghorfqz26pi0267gzcp9vdkqcbs3xlvq8q0ppy92fda63936fzo29m82lpcdmxxsfd89m048jvxozzpi3eqb0vzd3dz5t0a75kpghc6vdw9em61bik","petwwdmie50itlrua2nb17pdlsj044skjl3f3qvbcg1oif8cjn6sywezpuyrgmvs5badey7kg8rkuu01cx0xtiawg8mufq97fznzpwdrvye4092db0q2vwctk8v2s91hrej6tp8nkfrtkirwqw2ie48ienss5nz9624ill99on3l43dl9xbia7eu04426sjeegxhnt8jzt5feluqw3akeobvvzti51l6cu9unhdjk80a91c4elk5owgb24glib7uqhpywmvsv3o9dqsicv2mh6h6g3hq0vlmvtlu690s03dbsk69yymfh9uf2sljrb1ctk4cskrgc9ptqrr049rtga5p8y0041sdvucvr21969o04mkxaxv84w9vya1gibvs1o507a1w0ndbtnoahh1kvcjuydfr8ayjuaxj6maqvn4qwzf46muqjnqsc655hdrv2aibzm5a6h0rx42gbcgm7zgh4pp9bkqkwpj66x7qougihs34marmbyls6b60gyvvrv0oyu65pv4iwqwnmp73yi2bqxtbez9oq80apv5lfyfgqlq2uq1dho4mdh2o7amkzo4bjz8hducjqz8xd9kwdakfbs1og5frnceizy0y5x6dndz0a98jgh2qcwkthcpzvsvvaiwq6sypum8jnou11me0xkwz07qxrqo1sbaijh1244x3a9j30imos6u9dckfwf3qavjcdfbw76loeo9s8cqwvysmfq03i13suad86m7iani5l9q1kh72kuy5yl2f85pe"],s=0,e=Object.fromEntries(`frei
es gibt einen Weg: weiter
prüfen, dass niemand nahe und sie heil ist, dann „Zurücksetzen“ halten
die Drohne weigert sich: {what}
id ist kein Name
seine Uhr geht {n} s nach; es gilt die Zeit der Ankunft
neigt sich {n} Grad und bewegt sich nicht (Grenze {m}): hängt fest, sie landet
{name}: Lesen misslang ({error})
sie steht, sagt sie selbst
Behält eine Person eine Weile im Bild; sucht sie, kommt dann zurück.
sie fliegt vielleicht anders als geplant
Motoren werden abgeschaltet
die Lage ist kein Einheitsquaternion
Drohne empfing keine Befehle
die Ortung ansehen: Läuft sie, sendet sie den Körper unter diesem Namen? Ist sie nur langsam, nennt housefly gains das nötige limits.pose_age_level
{who} hat Orte und Zonen gespeichert
landet
von Hand bewegt
{d} m davon entfernt
Das Programm wurde neu gestartet
steht {d} m höher als beim Start: auf etwas
wartet hier: {why}
der Weg nach oben ist nicht frei
Seit {n} s nichts vom Autopiloten: {then}. STOP und Landen werden weiter gesendet.
der Befehl ist {n} s alt; Befehle verfallen nach {m} s
{name} ist von keinem Ort zu sehen, wo die Drohne schweben darf: etwas steht dazwischen
Abschalten der Motoren
seine Größe ist unmöglich (höchstens {d} m)
die Ortung zeigt die Drohne in anderer Höhe
meldet mehr als {n} Dinge
hier soll sie langsam fliegen
{name}: keine Tiefenbilder
die letzte Achsenprüfung fand die Ortung falsch
er darf fliegen
der Akku ist zu leer: {p} %, hin und zurück ({n} s) braucht {q} %; laden
Person steht
wo Besuch steht
erledigt
{why}: {found}; {mend}
steht bei {p} %
die Ortung ist das Spiegelbild der Bewegung
{n} Aufgaben von {who} warten schon; eine beantworten oder abbrechen
kein Flug dorthin hält die Grenzen der Drohne ein
prüft, ob alles in Ordnung ist
angekommen
jemand
die Drohne meldet Bewegung, obwohl sie steht
{place}; vor dem nächsten Flug zurücksetzen
landet hier
wann hinfliegen
am Boden, bereit
Person liegt
Hinfliegen
darunter stehen Möbel
seit [tracking] geändert wurde
niemand antwortet unter {name}; ist das Gerät an und in diesem Netz?
die Warteschlange war voll, „{title}“ ging vor
seine Sicherheit liegt nicht zwischen 0 und 1
{who} kommt näher, und zum Ausweichen ist kein Platz
{why}, {more}
Achsen geprüft
{who} hat die Steuerung an {name} übergeben
nichts fliegt
{why}: sie kommt zurück
steht sie doch dort, passen Ortung und Karte nicht, und Wände sind nicht, wo sie scheinen
die Drohne steht schief
der Akku ist geladen
der Autopilot war {n} s zu spät
sie war am Boden
nein
eben auf den Landeplatz stellen
er darf alles
{why}, schon lange (Grenze {d} m)
er startet von selbst neu: warten, oder sein Protokoll im Ordner des Laufs ansehen
am Boden
die Drohne hat ihre Grenzwerte nicht bestätigt
sie steht auf ihren Füßen
ein Hindernis von {who} wird abgelehnt: {why}
die Ortung sieht sie nicht
die Ortung sah sie noch nicht
Dieser Raum hat keine Drohne.
die Drohne meldet nicht, dass sie steht
ein um {n} s schnellerer Weg wurde frei: sie nimmt ihn
die Aufgaben haben eben begonnen
Fliegt zu {goal}
die Ortung ist {n} s älter als angegeben
die Akkuanzeige bewegt sich
der Akku verlor {p} % in {n} s (Grenze {q} %)
{place}; Start von dort möglich
die Drohne ist nicht bereit
Akku wechseln oder die Drohne neu starten: Start, sobald ein anderer Wert erscheint
{d} m
die Verbindung zu {name} ging verloren
{who} hat Nein gesagt
{p} % frei auf {name}
kommt zurück
Sieht jeden Ort an, macht Bilder und meldet, was sich geändert hat.
dieser Raum hat keine Drohne
mit Ihrer Rolle lassen sich Clips ansehen, nicht gemeinsam speichern
niemand steuert: erst die Steuerung übernehmen
Personen bleiben vielleicht ungesehen: von einem Sensor für sie kam noch nichts
{who} ist darunter
{what} dauerte länger als {n} s
fliegt
sie würde {d} m neben dem Landeplatz landen
die Ortung hat die Drohne nicht auf dem Landeplatz gesehen
sie kommt zur Sicherheit zurück
niemand und nichts ist über oder neben ihr
noch ist nicht bekannt, was die Drohne tut
geht
Angehalten
die Drohne antwortet
die Drohne ist im Notaus: Motoren aus
er nennt weder Ort noch Ziel
eine Ortung, die am Boden wandert, wandert auch in der Luft
falsch
sendet mehr als {n} Nachrichten je Sekunde; der Rest fällt weg
Umsehen
auf eine Platte lässt sich nicht schreiben
Der Raum wird beobachtet
ab wann es als alt gilt
um {d} m bewegt
zuletzt vor {n} s
sie antwortet, sendet aber keine Berichte
Gewünscht von {who}
er darf zusehen und fragen
verlässt gleich die Karte um {d} m
{who} hat unterbrochen
{d} m vom Startort verweht (Grenze {m} m) und nur {k} m hoch: Motoren werden abgeschaltet
prüfen, ob ein anderer Körper ihren Namen hat; einmal anheben zeigt, wo sie ist
{why}; nächster freier Ort: ({x}; {y}) m
{thing} ist im Weg, {d} m voraus
{end} {place} liegt in einem Hindernis
in der Luft; {why}
was zu spät kommt, wird verworfen, als wäre es nie gekommen
niemand ist zu sehen
Motoren aus
die Drohne meldet: {what}; sie landet
sie fliegt weiter, wenn der Boden schweigt
steht {d} m über dem Boden: auf etwas
Fliegt zum Blickpunkt, macht ein Bild und kommt zurück.
wie lange
Wartezeit je Bild
von hier aus
Akku {p} %, der Heimweg ({n} s) braucht {q} %
place ist kein Name
der letzte Ort von {who} wird nicht mehr freigehalten
Sagt, was in Schrank und Kühlschrank ist, und macht von beiden ein Bild.
sie wurde von {who} von Hand bewegt
{why}: langsam
Sinkt zur Sicherheit
Schwebt
Motoren sind aus
der Start
{who} kommt näher
die Verbindung zum Server brach ab
der Drohne fehlt, was andere haben
nicht alle seine Zahlen sind endlich
alte Flüge löschen oder auf eine andere Platte verschieben
es liegt weit außerhalb der Karte
ein Browser kam herein über {link}: {what}
kein freier Weg von {name} nach {place}
niemand weiß, wo {name} ist
{who} kommt näher: Start abgebrochen
der Weg bleibt versperrt
sie sah nach: {goal}
{who}: {why}
Am Boden
sie ist zu weit von dort, wo die Drohne sein kann
{n} der letzten {m} s gehalten
Akku schwach
die Ortung sieht sie
ein rechtzeitiger Beginn war nicht möglich
ein Sensor sieht Personen ohne Marker
die Drohne hat sich gesperrt: aus- und einschalten
{asked} {place}
Bereit auf dem Landeplatz
die Drohne meldet ihre Bewegung nicht
Nicht bereit: {why}.
höchstens {n} Grad
im Umkreis von {d} m um {name} gibt es keinen Ort, wo die Drohne schweben darf und die Ortung sie sieht
{name} sendet mit y nach oben; in der Ortungssoftware z nach oben wählen
hält
Einstellungen und Sensoren sind in Ordnung
es gibt kein Ziel
{why} ({found})
die Aufgabe dauerte zu lange
zu lange: {what}
sie flog zu {goal}
{name} sendet mehr als {n} Bilder je Sekunde; der Rest fällt weg
„{title}“ fortsetzen? {why}.
nicht beachten
Keine Verbindung zur Drohne
die Drohne fliegt, obwohl ihre Motoren aus waren: sie landet
angestoßen, oder die Ortung sprang: plötzlich {d} m/s anders (Grenze {m} m/s), sie landet
SICHERHEITSHALT
jemand anders fliegt sie, oder sie sich selbst (Modus {mode})
in Bewegung
seine Uhr geht {n} s vor; es gilt die Zeit der Ankunft
liegt
Keine Verbindung zum Autopiloten
{p} %
Notaus aufgehoben
voraus sind Wand oder Möbel
schwebt bis „Fortsetzen“
{why}; {more}
ein Manöver fliegt die Drohne
sie kommen in Sekunden
eigene Lage
den Landeplatz freimachen
kein freier Weg führt dorthin, wo {name} zu sehen ist
Landen
Ortung seit {n} s verloren
Notlandung durch Benutzer
look_s ist falsch
sobald sie in der Luft ist
über der Drohne hängt etwas: dorthin tragen, wo die Luft darüber frei ist
ein neuer Treiber fand sie in der Luft: sie schwebt nur und landet
jemand steuert die Drohne
Befehle erreichen die Drohne verspätet oder gar nicht
ihre eigenen Grenzen für Neigung, Höhe und Tempo gelten, wenn alles andere versagt
die Drohne fliegt schon
eigene Geschwindigkeit
Die Drohne schwebt und nimmt keine Befehle an, bis „Fortsetzen“ gehalten wird
was anzusehen ist
ihrem Ziel
auf {name} lässt sich nichts schreiben ({why})
sie muss zurückkommen und landen
noch nicht
kein MQTT-Broker antwortet unter {name}; läuft er (mosquitto), stimmt mqtt.port?
{who}: {what}, doch der Autopilot schweigt
der Autopilot hat den Start noch nicht freigegeben
was fehlt
es wurde in der Zukunft gesehen
landet nicht: {why}. „Landen“ drücken, um trotzdem hier zu landen
wo Ortung und Karte nicht übereinstimmen, sind Wände nicht, wo sie scheinen
{who} kommt näher: sie weicht aus
Gerät an
die Drohne steht in einer Verbotszone: hinaustragen
keine Verbindung zum Autopiloten
am Boden; {why}
Last {n} auf {k} Kern
sie landete
Last {n} auf {k} Kernen
sie startet weiter, schwebt, kommt dann binnen {n} s von selbst zurück und landet
die Drohne startet schon
Kamera unten und Boden darunter ansehen, dann aus- und einschalten
Sensorplatine schweigt
ihre Motoren werden abgeschaltet
Sagt, wie es allen geht; sieht nach, wer gestürzt oder nachts aufgestanden ist.
das Gedächtnis des Raums antwortet nicht
{who} flog und ist nicht mehr zu sehen: ihr letzter Ort bleibt frei
kein Ort namens {name}: meinten Sie {place}? Bekannte Orte: {places}
niemand hört darauf; läuft der Prozess „perception“?
sie kommt zur Sicherheit weiter zurück und landet
die Drohne meldet ihr {setting} noch nicht
voraus endet der erlaubte Bereich
niemand weiß, wie voll der Akku ist
ein Schritt misslang
die Drohne schweigt seit {n} s
der Befehl war keine Zahl
{n} davor
{why}, und der eigenen Geschwindigkeit der Drohne ist nicht zu trauen: sie sinkt waagerecht
abgemeldet; ist das Gerät an und in Reichweite des Netzes?
der Ultraschall zeigt überall etwas: Landung nach der Höhe der Ortung
das Ziel liegt außerhalb des Raums
Motorstörung
gestürzt
unter {name} antwortet nach {n} s keine Drohne: ist sie eingeschaltet und der Rechner in ihrem WLAN?
Bett belegt
sie sinkt weiter zum Boden, wo sie ist
der Autopilot ist ausgefallen ({name}): sie landet
sie steht unter, auf oder in {thing}
{why}, {d} ms zu spät
„{title}“ fliegen? {why}.
die geortete Höhe weicht {d} m von der eigenen der Drohne ab
mit {d} m/s verweht (Grenze {m} m/s), nur {k} m über dem Boden: Motoren werden abgeschaltet
{why}: sie landet hier
der Raum ist noch nicht bekannt
die Drohne ist unterwegs: erst „Schweben“ drücken
{place}; bleibt unten bis „Fortsetzen“
Auf dem Landeplatz
die Drohne steht nicht auf dem Landeplatz
gesendet, noch nicht bestätigt
darunter oder daneben sind Möbel oder eine Wand
{end} {place} ist einem Hindernis zu nah ({d} m)
{d} m über ihrer Höhe von {m} m
{who} hat die Steuerung übernommen
die Ortung sieht die Drohne {d} m neben ihrem Stand (Grenze {m} m): Ursprung der Ortung und Körper der Drohne prüfen
{thing} ist im Weg: sie fliegt herum
jetzt nicht
Türklingel gedrückt
die Ortung lässt sie, wo sie steht
die Drohne behält {setting} = {kept} statt {wanted}
„{title}“ hat die Drohne übernommen
sie landet zur Sicherheit
sie fliegt nicht, wie man ihr sagt
eine Datei lässt sich schreiben
{why}: {found}, nötig: {limit}; {mend}
die Drohne steht, doch die Ortung zeigt sie um {d} m bewegt (Grenze {m} m): sie bleibt unten
sie landet weiter, wo sie ist
eine Wand könnte nahe sein
Zu einem Punkt fliegen
Daten kommen nicht von {name}; in tracking.address {other} eintragen
Böen: seit {n} s {d} m/s neben der Sollgeschwindigkeit
die eigene Geschwindigkeit passt weder zur Ortung noch zur Neigung: Landung nach Ortung
kein Weg nach Hause, landet hier: {why}
ihre Karte hat noch keinen Ursprung: Man muss ihr im Stehen sagen, wo sie ist
was unter {name} antwortet, spricht nicht {protocol} ({error})
die Drohne schweigt; ist sie eingeschaltet?
die Kamera nimmt nur im Flug auf
die Drohne tut, was diese Aufgabe nicht befahl: {phase}
Person anwesend
Personen werden vielleicht nicht gesehen: seit {n} s nichts Brauchbares von einem Sensor
STOP ist gesetzt
{name} ist nirgends im Bild: zu nah, zu hoch oder zu tief
die Prüfungen vor dem Start fehlen noch
wo nachzusehen ist, in dieser Reihenfolge
die Ortung sieht die Drohne nicht
von {name} kommen Bilder, doch ihre Zeit steht; ist {what} angehalten?
ihre Motoren sind aus
{why}: sie hält an
gedrückt
einmal höchstens {d} m und {n}° davon
sie bleibt bis aufs letzte Bit gleich, obwohl die Drohne fliegt
laden oder Akku wechseln
STOP: schwebt bis zum Fortsetzen
ein Schritt brach ab ({error}); das Protokoll sagt, warum
bevor [tracking] geändert wurde
ein anderer Tab meldet sich mit eigener Verbindung
Jemandem folgen
höchstens {d} m/s, und nur beim Bewegen von Hand
Motoren ausgefallen
Ursprung der Ortung auf den Boden legen und den Körper der Drohne neu anlegen
mindestens {p} %, für weite Wege mehr
Nennt den Ort aus dem Gedächtnis; ist er alt oder unsicher, sieht sie nach.
auf den Landeplatz stellen; steht sie dort, den Ursprung der Ortung mit der Karte vergleichen
sieht nach
Motoren werden auf Befehl abgeschaltet
Softwarefehler
{why} (Grenze {d} m)
noch {d} m, {n} s
{why}: sie hält sich selbst
der Autopilot ist oft zu spät ({k}-mal in {n} s)
nichts
Heim
Fortsetzen
ein Boden in anderer Höhe ist ein Raum in anderer Höhe
auch von {who} gewünscht
die Motoren sind aus: die Drohne fiel oder wurde abgeschaltet
wird geprobt
sie wurde von Hand bewegt
{end} {place} liegt außerhalb des Raums
die Akkuanzeige stand still
schwebt und nimmt bis „Fortsetzen“ keine Flugbefehle an
der Prozess des Treibers antwortet nicht (Protokoll: driver.log)
{thing} ist nah
sie hat ihre Grenzwerte bestätigt
die Drohne meldet: {what}
STOP kam nicht an: keine Verbindung zum Server
Nachtrunde
Akku {p} % unter {q} %
nach dem Weg ließ sich nicht fragen: {why}
{who} läuft in den Weg: sie fliegt herum
Bewegen von Hand
Jetzt nicht: {why}.
Die Drohne antwortet noch nicht.
sie sieht zu Ende nach, kommt dann von selbst zurück und landet
das geschieht schon
bestätigt
Sie steuern nicht
der Akku zeigt seit {n} s {p} % (Grenze {m} s): Flug nach der Uhr, noch {k} s
schweigt seit {n} s; sendet sonst mindestens alle {k} s
sie ist zu alt
dieses Bild ist nicht mehr gespeichert
wie lange dort warten
das Programm endete währenddessen
Motoren sind aus: erst „Zurücksetzen“ halten.
{who} hat übernommen: {what}
Seit {n} s nichts von der Drohne: {then}. STOP und Landen werden weiter gesendet.
Angehalten: erst „Fortsetzen“ halten.
{why}, oder darunter ist etwas: langsam
Warten auf den Autopiloten
fliegt mit {d} m/s (Grenze {m} m/s)
eine Platte ist fast voll
vor höchstens {n} s gehört
die Ortung zeigt sie, wo sie steht
{who} gibt zu viele Befehle: {n} in einer Sekunde abgelehnt (Grenze {m} je Sekunde)
{why}; kein Weg weiter, wartet hier: {more}
{asked} abgelehnt: {why}
auf den Landeplatz stellen, die Nase in dessen Richtung; steht sie so: \`housefly preflight --frames\`
Hindernis abgelehnt: {why}
{who} hat die Steuerung abgegeben
{why}, sobald sie kann: {what}
Person gestürzt
in der Luft
keine Drohne
am Boden, {d} m vom Landeplatz
{why}: die Drohne hält sich selbst
eine Kamera
geht zum Landen {d} m zur Seite, nach eigener Bewegung
Bewegen von Hand ist hier ausgeschaltet.
Warte auf die Ortung
startet
mit {name} verbunden, doch es kommt nichts
Regeln, die das brauchen, gelten nicht; fällt die Ortung aus, sinkt und landet sie
sie startet weiter, fliegt zu {goal}, kommt dann binnen {n} s von selbst zurück und landet
sie landet weiter
ist der Autopilot beendet, bremst und landet die Drohne in Sekunden von selbst; fehlt nur seine Nachricht, gilt: {then}
kommt von selbst zurück
in der Luft behält die Drohne die Karte vom Start: erst landen
Achsen nicht geprüft
sie kam zurück
kein freier Landeplatz im Umkreis von 2 m: wartet in der Luft
unbekannt, was anzusehen ist
wie lange dort schweben
niemand hat STOP gedrückt
auf die Platte lässt sich schreiben
der Akku ist zu leer
kommt zur Sicherheit zurück
{d} m davon entfernt, um {n}° gedreht
ein Deck der Drohne meldet einen Fehler: ausschalten und das Deck ansehen
der Akku ist zu leer: {p} %, der Start braucht {q} %
die Drohne meldet eine Störung
darunter scheint etwas {d} m Hohes zu stehen
ihr Zeitstempel liegt in der Zukunft
die Ortung ist nur zum Teil glaubwürdig, {n} der letzten {m} Posen nicht: {why}
Startet
{end} {place} ist einem Hindernis zu nah
Die Drohne ist am Boden.
Flugzeit abgelaufen
ihr Zeitstempel ist nicht neuer als der letzte
Von Hand bewegt
sie fliegt weiter zu {goal}, kommt dann binnen {n} s von selbst zurück und landet
sie fliegt nicht nach den Posen, die wir senden
Zurücksetzen
weicht zur Seite aus
{why}: sie landet
niemand kommt näher: kehrt an ihren Ort zurück
dauert {time} und braucht {p} % der Ladung; über den Heimweg hinaus sind {q} % übrig
nur eine stehende Drohne kann starten
sind es Millimeter? In der Ortungssoftware Meter wählen
niemand weiß, ob die Drohne fliegt
{n} s lang kein Befehl: kommt zurück
Motoren sind aus
{why} (Grenze {n} s)
die Drohne meldet ihre Bewegung nicht: Die Ortung ist ungeprüft
Landet
die Ortung ist seit {n} s unglaubwürdig: {why}
die Drohne war zuletzt am Boden; ohne Autopilot bewegt sie nichts
der geortete Körper ist {n} Grad gegen die Drohne verdreht
nach {time} nicht fertig
anwesend
eigene Höhe
vorher kam ein Befehl zum Anhalten oder Landen
{n} Grad
über dem Landeplatz, sie landet
den Link des Terminals
der Weg ist frei: weiter
Verlorenes suchen
Zu jemandem kommen
schwebt nach dem Loslassen
die Drohne wurde am Boden bewegt: die Ortung beginnt neu
{d} m von der Sollposition
eine dringendere Aufgabe hat die Drohne übernommen
{why}: {found}, nötig: {limit}; wohl weil: {cause} ({value}): {mend}
die Drohne glaubt sich {d} m von dort, wo die Ortung sie sieht: Erreichen sie Posen?
die Probe war nicht möglich ({why}), daher kein Flug
am Boden, {d} m vom Landeplatz, unter, auf oder in {thing}
von {who} von Hand bewegt
{why}; kein Weg nach Hause, wartet hier: {more}
Ist alles in Ordnung?
dieser Lauf wird aufgezeichnet, mit nur einer Karte: neu starten
nichts bekannt
die Drohne hat diese Fassung schon
sie passt nicht zur Eigenbewegung der Drohne
die Motoren sind aus: zurücksetzen, wenn niemand nahe ist
{who} startet den Autopiloten neu, damit die Drohne die neuesten Orte und Zonen hat
erst anmelden
niemanden in den Raum lassen, oder Scanner oder Tiefenkamera ergänzen
{end} ist kein Ort: {place}
Nicht bereit
Person sitzt
höchstens {d} m/s
bleibt hier
das Ziel
sie startete
bleibt hier: {why}
die Drohne antwortet nicht
sie meldet keine Störung
STOP wurde nicht angenommen
der Autopilot antwortet nicht
gelandet
die Drohne landet
der Prozess des Raums antwortet nicht (Protokoll: room.log)
Ultraschall taub
sie war zuletzt in der Luft; Landen wird weiter verlangt, und eine Drohne ohne Verbindung bremst und landet von selbst
{end} {place} liegt in einer Verbotszone
unbekannt
Landung nach {n} s nicht bestätigt: wird weiter verlangt
zu viel Wind
die Drohne ist ohne Befehl in der Luft: sie hält
Macht Bilder in alle Richtungen, am Startort oder an einem Ort.
Schweben
Sieht leise einmal überall nach; meldet nur, was nicht stimmt.
höher als {d} m
das Programm endete im Flug; ohne neuen Befehl beginnt nichts wieder
Kommt zur Sicherheit zurück
die Ortung hat sie auf dem Landeplatz gesehen
Nachsehen
Ort oder Ding ansehen
nimmt wieder Befehle an
ein Ding oder eine Person
{who} steuert
Motoren abschalten
ja
zu viele Befehle auf einmal: kurz warten
bewegt sich mehr als {d} m/s anders als befohlen
Sieht nach, wo es wohl ist, zeigt Bilder und fragt; sagt, was nicht angesehen wurde.
„Zurücksetzen“ drücken, wenn sie im Notaus und niemand nahe ist
jener Zuschauer ist nicht mehr da oder darf nicht fliegen
für alles zusammen
unbekannt
jemand
höchstens vor {n} s
Namen, mit Komma getrennt
noch nicht mit {name} verbunden
Warten auf die Drohne
Bewegen von Hand
an der Drohne {setting} auf {allowed} setzen (jetzt {value}): {why}
nicht gedrückt
Posen werden abgelehnt, {pose}: {ask}
eigenes Schweben
Person geht
wie viele Bilder
von zu Hause führt kein Weg hierher: {end} {place}
{who} kommt näher, und zum Ausweichen ist kein Platz: sie landet hier
nicht bestätigt: STOP wird immer wieder gesendet
nach der Uhr noch {n} s Flug, der Heimweg braucht {m} s
neigt sich {n} Grad anders als befohlen
{who} war {n} s still und steuert nicht mehr: jetzt steuert niemand
wo; sonst über dem Landeplatz
prüft, was darunter ist
es ist schneller als {d} m/s
Fliegt zu einem Punkt, wartet dort und kommt zurück.
Personen ohne Marker sieht sie nicht
eine Drohne ohne Verbindung lässt sich nicht anhalten
mit {name} verbunden, doch es kommen keine Messungen
\`housefly sensors\` ansehen: ist jeder an, in diesem Netz und unverdeckt?
{who} ist zu nah
dort ist der Landeplatz von {who}
in Ruhe
Notaus
gespiegelte, gedrehte oder verschobene Achsen fallen erst nach einer Bewegung auf
der Autopilot schweigt
{who} hat fortgesetzt
nicht nötig: der Raum ist simuliert
von Hand bewegt: {why}
Bewegen von Hand geht nur mit den Tasten dafür
Propeller, Motoren und Akku ansehen, dann aus- und einschalten
kein Notaus aufzuheben; Zustand der Drohne: {what}
die Drohne sieht ihre Bewegung nicht: sie kann sich nicht selbst halten
höchstens {n} druckbare Zeichen
kein Sensor
wie lange hinsehen
wen; anybody ist, wer am nächsten ist
noch nicht gehört; sendet sonst mindestens alle {k} s
die Drohne fliegt schon
Sieht nach: {goal}
Ihre Rolle ist {name}, nötig ist {what}: den Betreiber von Housefly fragen
hier wurde darunter etwas gefunden
Keine Verbindung zum Autopiloten.
den Link von {who}
wartet auf einen Befehl
{asked}, von {who}: {what}
„{title}“ hat die Drohne
{what}: {why}
nicht von der Drohne bestätigt: {what}
„{title}“ darf von hier nicht beginnen
auf dem Landeplatz
einige Sekunden warten oder aus- und einschalten
{who} ist im Weg
die Ortung passt seit {n} s nicht zur Bewegung der Drohne
die Ortung weicht {d} m vom eigenen Weg der Drohne ab
Fliegt zu einer Person, wendet sich ihr zu und wartet; kommt auf Wunsch oder nach einer Weile zurück.
goal ist kein Ort in einem Raum
die Drohne würde {thing} berühren
Tür offen
seit {n} s in der Luft, so lange die Ladung beim Start erlaubt (limits.flight_time {m} s)
keine Verbindung zum Server
sie würde mitten im Flug landen oder fallen
hier sieht nichts Personen: kein Scanner, keine Tiefenkamera
kein Körper ist zu sehen; läuft die Ortung?
eine Zahl ist nicht endlich
die Drohne steht, doch die Ortung zeigt sie {d} m vom Boden (Grenze {m} m): sie bleibt unten
steigt mit {d} m/s
seit {n} s nichts Brauchbares
nur für Personen, die ein Sensor sieht, hält sie und weicht aus
Die Drohne nimmt keine Befehle an, bis „Fortsetzen“ gehalten wird
{why} (Grenze {n})
{why}: gehalten
Motoren sind aus
lange genug nachgesehen, kommt zurück
sie schwebte
Die Drohne ist unterwegs: erst „Schweben“ drücken.
sie hebt ab und hält sich nach dieser Geschwindigkeit
der Autopilot startet mit der neuen Karte neu; gleich noch einmal befehlen
nicht mehr von Hand bewegt
landet nicht: {why}
sie schwebt an Ort und Stelle, bis jemand fortsetzt, und landet von selbst, wenn Akku oder Zeit zu Ende gehen
mit {name} verbunden, doch es kommt nichts Neues; läuft {what}, ohne Pause?
velocity ist falsch
fliegt zum Ziel
höchstens {d} m
Koordinaten bis {d} m
er darf zusehen
Notaus verlassen
die Verbindung ist langsam: dies kam {n} s zu spät
Der Auftrag hat lange gewartet
STOP ist gesetzt: erst fortsetzen
die Drohne ist zu schnell, um dorthin abzubiegen: erst anhalten lassen
was nachts aus sein muss
die Drohne hat ihre Grenzwerte noch nicht bestätigt
ihr Ultraschall zeigt überall etwas
ihre Eigenbewegung ist unsicher
innerhalb {d} m
es sind mehr als {n} zugleich
{end} {place} ist einem Hindernis zu nah: {d} m vom Rumpf, nötig sind {m} m
schief startet sie zur Seite
{who} hat abgebrochen
steht
Starten
kam neben ihrem Kurs zur Ruhe: weiter von dort
soll {d} m/s fliegen und bewegt sich nicht
angekommen, sie sieht nach
{why} (Grenze {d} m/s)
sitzt
die Frist ist schon vorbei
neigte sich {d} der letzten {n} s anders als befohlen
die Ortung ansehen: Läuft sie, sendet sie den Körper unter diesem Namen?
die Drohne ist abgestürzt: ansehen, dann zurücksetzen
Nachsehen, wer an der Tür ist
die Platte wieder zum Schreiben einhängen oder diesen Benutzer dort schreiben lassen
dauerte zu lange
{who} läuft in den Weg: sie wartet
seit {n} s am Boden mit laufenden Motoren: Abschalten
wo nachzusehen ist, in dieser Reihenfolge; whole floor zeigt alles
noch nichts gehört
Fliegt zum Eingang, filmt, wer dort steht, und meldet es allen.
{why}: {more}
sie bleibt am Boden: ohne neuen Befehl bewegt sie nichts
Die Drohne fliegt schon.
Landet zur Sicherheit
0 bis {n} s
noch nicht geprüft
startet, dann
diese Sitzung ist beendet
zu viele Befehle in einer Sekunde
als Nächstes an der Reihe
dem gewählten Punkt
etwas getroffen: Stoß von {d} m/s² (Grenze {m} m/s²), sie landet
nichts hält die Drohne mehr zurück
{who} darf nicht mehr fliegen und steuert nicht mehr
auf der Platte ist Platz
hat sich beim Abheben um {n} Grad gedreht
{d} m/s
die Drohne wird zur Sicherheit gelandet
Bewegen von Hand ist hier ausgeschaltet (limits.nudge_speed)
die Ortung zeigte die Drohne noch nicht
tiefer als {d} m
eine Einstellung oder ein Sensor der Drohne stimmt nicht
Anhalten
die Seite der Drohne im Handbuch ansehen
die Drohne hat ihre Grenzwerte noch nicht bestätigt: warten oder aus- und einschalten
mindestens {p} % frei, oder {n} GB
noch {d} m
sie fliegt nach der Ortung
Wo ist etwas
mehr als {d} m außerhalb der Karte
auf dem Landeplatz scheint etwas {d} m Hohes zu liegen: Ist er frei?
niemand antwortet unter {name}; läuft {what}, und sendet es?
sie schwebt, bis die Störung vorbei ist, und landet von selbst, wenn sie andauert
sie zeigt {d} m Bewegung, obwohl die Drohne still lag: Ist es ein anderer Körper? Drohne anheben, um zu zeigen, wo sie ist
ihre Motoren werden abgeschaltet: sie fällt
die letzte Achsenprüfung fand keinen Fehler
der Autopilot ist mehr als {n} s zu spät
{why}: um die Drohne muss Luft frei sein
sie schwebt an Ort und Stelle, kommt dann binnen {n} s von selbst zurück und landet
landet zur Sicherheit
look_at ist kein Ort in einem Raum
kein Ort namens {name}; bekannte Orte: {places}
Bewegen von Hand braucht map.planner = "space" und den Modus default
dieser Befehl braucht weder Ort noch Ziel: {asked}
{d} m vom Startort verweht
Türklingel
hier landen
„Fortsetzen“ drücken, wenn alles in Ordnung ist
die Drohne landet von selbst
eben geschrieben
{asked}: {what}
niemand hat rechtzeitig Ja gesagt
„Fortsetzen“ halten, wenn alles in Ordnung ist
andere Programme beenden; das simulierte Bild kostet am meisten (twin.video = false)
nie
auf Befehl
andere Aufgaben laufen
eine Last unter {n}
zum Landeplatz tragen
Von {who} von Hand bewegt
wurde abgebrochen
Kommt zurück
sie hat, was andere haben
Befehl: {what}; erlaubt: {limit}
wie von der Prüfung gesagt beheben und neu prüfen: \`housefly preflight --frames\`
die Konsole wurde neu gestartet: was inzwischen geschah, fehlt hier
„{title}“ beginnen? {why}.
Nicht auf dem Landeplatz
Rundgang
Steuern durch Neigen
die Drohne hat ihre Grenzwerte seit {n} s nicht bestätigt
der MQTT-Broker unter {name} weist uns ab; mqtt.username und mqtt.password_file prüfen
vor dem Beginn hat jemand der Drohne befohlen
die Ortung zeigt die Drohne von vor {n} s (limits.pose_age_level: {m} s); housefly gains nennt die nötige Grenze
{d} m unter ihrer Höhe von {m} m
die geortete Höhe stieg um {d} m (Grenze {m} m) ohne Stufe im Boden
der Befehl braucht einen Ort oder ein Ziel
sie flöge an falsche Orte und landete oder stieße an
{n} Aufgaben warten schon; eine abbrechen oder später fragen
der Autopilot schweigt; auch der nächste wird angehalten
dort steht {thing}
Eine Aufgabe fliegt die Drohne: erst „Schweben“ drücken.
eine Aufgabe läuft: ihr Ende abwarten oder sie beenden
Nur nach STOP.
kein freier Landeplatz im Umkreis von 2 m: hält sich nach eigener Bewegung
dieser Rechner kommt mit
jemand anderes fliegt: zum Übernehmen die Taste halten
sie steht nach eigener Angabe still
der MQTT-Broker unter {name} weist uns ab ({error})
nur eine Person davon
STOP gilt, bis jemand fortsetzt
abgelehnt
steht {d} m über dem Boden (Grenze {m} m): auf etwas
dieser Rechner ist überlastet
was im Flug geschieht, ließe sich nicht aufbewahren
sender ist kein Name
{who} hat eine Änderung an Orten und Zonen zurückgenommen
zu stark geneigt
die Warteschlange war voll, anderes ging vor
die Drohne ist nicht bereit: {what}
einschalten, mit ihrem WLAN verbinden und \`housefly doctor\` ansehen
die Drohne ist am Boden
die Ortung sah sie zuletzt vor {n} s
{who} hat Ja gesagt
seit {n} s soll sie landen (Grenze {m} s) und ist noch oben: Sinken nach eigener Vorgabe
landet trotzdem: {why}
die Ortung sah die Drohne noch nicht
Bestand
Akku {p} %: bei {q} % kehrt sie um
sie steht auf dem Landeplatz
wie lange jeweils hinsehen
die Drohne einmal umhertragen, zwei Minuten: \`housefly preflight --frames\`
seit {n} s; {then}
nur fliegen, wo die Ortung sicher ist, und niemanden in die Nähe lassen
die Ortung sah die Drohne zuletzt vor {n} s
geprüft
die Ortung bewegt die Drohne, obwohl sie steht
landet {d} m daneben
sie steigt von ihrem Platz gerade nach oben
{end} {place} liegt außerhalb der Karte
die Drohne kommt zur Sicherheit zurück
zu wem; anybody ist, wer am nächsten ist
sie fliegt weiter zurück und landet von selbst`.split(`
`).map((n,t)=>[s+=parseInt(r.map(i=>i[t]).join(""),36),n]));var a={"STOP FAILED":"STOP GESCHEITERT",STOPPED:"STOP AKTIV","STOP sent":"STOP gesendet","When this page last heard: {words}":"Nach letztem Stand: {words}","sending …":"wird gesendet …","hover at once and stay":"Halt: sofort schweben und bleiben",Space:"Leertaste",Resume:"Fortsetzen","Resume after STOP":"Nach STOP fortsetzen",hold:"halten","not ready":"nicht bereit","Cut motors":"Motoren aus","Cut motors: motors stop, drone falls":"Motoren aus: Sie bleiben stehen, die Drohne fällt","it falls, hold 1 s":"sie fällt, 1 s halten",Reset:"Zurücksetzen","Reset after a cut":"Nach dem Abschalten zurücksetzen","Take off":"Starten",Land:"Landen","Land here":"Hier landen",Hover:"Schweben","Stay where it is":"An Ort und Stelle bleiben",Home:"Heim","Fly home":"Heimfliegen","Fly home and land":"Heimfliegen und landen","Fly there and stay":"Hinfliegen und bleiben","Look there and come back":"Dort nachsehen und zurück","Look at {place} and come back":"{place} ansehen und zurück","Look and come back":"Nachsehen und zurück","Choose where to look":"Ziel wählen","Not ready: see why":"Nicht bereit: Grund ansehen","No contact":"Keine Verbindung",More:"Mehr","More orders":"Weitere Befehle",Orders:"Befehle",Close:"Schließen","{label}: hold {n} s":"{label}: {n} s halten","Hold it for {n} s: a tap does nothing.":"{n} s lang halten: Antippen bewirkt nichts.","Hold Enter.":"Eingabetaste halten.",Places:"Orte","Where to?":"Wohin?","Point {x}, {y} m":"Punkt {x} / {y} m","Forget this goal":"Ziel verwerfen","The path keeps {d} m away from everything.":"Der Weg hält {d} m Abstand zu allem.","The goal was moved {d} m, to the nearest free point.":"Das Ziel wurde um {d} m zum nächsten freien Punkt verschoben.","Looking for a path …":"Weg wird gesucht …","Choose a place, or point on the map.":"Ort wählen oder auf die Karte zeigen.","The battery is too low for a flight.":"Der Akku reicht nicht für einen Flug.","No contact with the server.":"Keine Verbindung zum Server.","No contact with the pilot.":"Keine Verbindung zum Autopiloten.","No contact with the server":"Keine Verbindung zum Server","Opened in another tab":"In anderem Tab geöffnet","this one only watches the past":"dieser zeigt nur Vergangenes","Session ended":"Sitzung beendet","use a fresh link":"neuen Link verwenden",Connecting:"Verbinden","for {n} s":"seit {n} s","Waiting for the pilot":"Warten auf den Autopiloten","This console was opened in another tab; that one is live.":"Diese Konsole ist in einem anderen Tab geöffnet; nur jener ist aktuell.","This browser's session has ended. Ask for a fresh link.":"Die Sitzung dieses Browsers ist beendet. Um einen neuen Link bitten.","No contact with the server: nothing is known of the drone.":"Keine Verbindung zum Server: Über die Drohne ist nichts bekannt.","No word from the server for {n} s: what is shown is of then.":"Seit {n} s nichts vom Server: Die Anzeige ist von damals.","What held then: {then}. STOP from this page may not arrive.":"Damals galt: {then}. STOP von dieser Seite kommt vielleicht nicht an.","Not known: no contact with the server":"Unbekannt: keine Verbindung zum Server","In flight":"Im Flug","Not ready: {why}":"Nicht bereit: {why}",Ready:"Bereit",more:"mehr","{n} check|{n} checks":"{n} Prüfung|{n} Prüfungen","Checks before take-off":"Prüfungen vor dem Start","Before take-off":"Vor dem Start","If contact is lost now:":"Bei Verbindungsverlust jetzt:","As contact was lost:":"Beim Verbindungsverlust:","If contact is lost:":"Bei Verbindungsverlust:","no take-off":"kein Start",look:"nachsehen",well:"in Ordnung","What is to be mended":"Was zu beheben ist","{who} has control. You watch.":"{who} steuert. Sie sehen zu.","Nobody has control: take it first.":"Niemand steuert: erst die Steuerung übernehmen.","You lost control; {who} has it now":"Sie haben die Steuerung verloren; jetzt steuert {who}","This page was silent and lost control; nobody has it: take it again":"Diese Seite schwieg und verlor die Steuerung; niemand steuert: wieder übernehmen","You have control":"Sie steuern","{who} has control":"{who} steuert","has control":"steuert","Take control":"Steuern","Take over":"Übernehmen","Take over control":"Steuerung übernehmen","Release control":"Steuerung abgeben","Hand over":"Übergeben","You watch.":"Sie sehen zu.","{who} has control; STOP and Land work.":"{who} steuert; STOP und Landen gehen.",Control:"Steuerung","One person has control.":"Eine Person steuert.","Everybody else watches, and can still stop or land the drone.":"Alle anderen sehen zu und können die Drohne trotzdem anhalten oder landen.","Your name":"Ihr Name","Viewer {n}":"Zuschauer {n}","(you)":"(Sie)",Invite:"Einladen",Live:"Live",Tasks:"Aufgaben",Screens:"Ansichten","Round trip between this browser and the server":"Laufzeit zwischen diesem Browser und dem Server, hin und zurück","lag {time}":"Verzug {time}","battery {p}":"Akku {p}","{site} · mode {mode}":"{site} · Modus {mode}",Ask:"Fragen",Details:"Details",Keys:"Tasten","Drone and house":"Drohne und Haus",Battery:"Akku","Battery unknown":"Akkustand unbekannt","{p} to land":"{p} zum Landen","{p} to come home":"{p} für den Heimweg","{p} usable":"{p} nutzbar","about {time} of flight":"etwa {time} Flugzeit","land {p}":"Landen {p}","home {p}":"Heimweg {p}","usable {p}":"nutzbar {p}","Event log":"Ereignisse",Log:"Protokoll","Which lines":"Welche Zeilen","all^lines":"alle","drone^lines":"Drohne","room^lines":"Raum","warnings^lines":"Warnungen","Show the room as it was then":"Den Raum von damals zeigen","Only of":"Nur von",everything:"alles",info:"Hinweis",warning:"Warnung",fault:"Störung",now:"jetzt","{n} days ago":"vor {n} Tagen","{n} h ago":"vor {n} h","{n} min ago":"vor {n} min","{n} s ago":"vor {n} s","by {name}":"durch {name}",Tracking:"Ortung",Drone:"Drohne",Picture:"Bild","Pilot loop":"Regeltakt",Delays:"Verzögerung",Filter:"Filter",Push:"Schub",Position:"Position",Motion:"Bewegung",State:"Zustand","p99 {d} ms late · {n} missed":"p99 {d} ms spät · {n} ausgefallen","tracking {one} · command {other}":"Ortung {one} · Befehl {other}","{one} · height {other}":"{one} · Höhe {other}","{d} m/s² · load {p}":"{d} m/s² · Last {p}","{state} · safety {mode}":"{state} · Sicherheit {mode}","by itself":"endet von selbst","once it stands":"bis sie steht","a fresh order on the ground":"bis zu einem neuen Auftrag am Boden","a reset":"bis zum Zurücksetzen","nothing yet":"noch nichts",Sensors:"Sensoren","none heard yet":"noch keiner gehört","{n} of {all} needs a look|{n} of {all} need a look":"{n} von {all} braucht einen Blick|{n} von {all} brauchen einen Blick","all is kept":"alles wird aufbewahrt","all {n} are well":"alle {n} in Ordnung",memory:"Gedächtnis","never heard":"nie gehört",Layers:"Ebenen","People and things":"Personen und Dinge","Safety margins":"Sicherheitsabstände","Tracking coverage":"Ortungsbereich","Edit the room":"Raum bearbeiten","number: how many of {n} cameras see {d} m above the floor;":"Zahl: wie viele von {n} Kameras {d} m über dem Boden sehen;","hatched: fewer than {n}, no tracking":"schraffiert: weniger als {n}, keine Ortung","The past":"Vergangenes","Fetching the past":"Vergangenes wird geladen","Back to now":"Zurück zu jetzt","Shift + Esc, held 1 s":"Umschalt + Esc, 1 s halten","Arrow keys":"Pfeiltasten","Enter, held":"Eingabe halten",L:"L",H:"H",M:"M",R:"R",T:"T","?":"?",Esc:"Esc","STOP: hover at once; in flight whatever has the focus":"STOP: sofort schweben; im Flug immer","Cut motors: the drone falls":"Motoren aus: Die Drohne fällt","Move the goal by one cell":"Ziel um ein Feld verschieben","Send the drone to look and come back":"Nachsehen und zurückkommen lassen","Swap map and picture":"Karte und Bild tauschen","Edit the room, and back":"Raum bearbeiten, und zurück","Go to the tasks, and back":"Zu den Aufgaben, und zurück","Show or hide this list":"Diese Liste zeigen oder verbergen","Close a panel":"Fenster schließen","Space stops the drone even while you type, as long as it flies.":"Die Leertaste hält die fliegende Drohne an, auch während Sie tippen.","On the ground it types a space, or presses the button that has the focus.":"Am Boden schreibt sie ein Leerzeichen oder drückt die gewählte Schaltfläche.","Letters and ? are keys":"Buchstaben und ? sind Tasten","Where is, go to":"Wo ist, fliege zu","Where is … / go to …":"Wo ist … / fliege zu …","Close the answer":"Antwort schließen","At {time}:":"Um {time}:","Fly there and look":"Hinfliegen und nachsehen","Choose it as the goal":"Als Ziel wählen","Look there":"Dort nachsehen","Nobody knows where that is.":"Niemand weiß, wo das ist.","Go to {place}":"Fliege zu {place}","Where is {thing}":"Wo ist {thing}",Doorbell:"Türklingel","The bell rings.":"Es klingelt.","The bell rings. Hold to fly there and look; it comes home by itself.":"Es klingelt. Halten, um nachzusehen; sie kommt von selbst zurück.","Look who is at {place}":"Nachsehen, wer da ist: {place}","Look^order":"Nachsehen",Ignore:"Nicht beachten",door:"Tür","Someone at the {place}":"Jemand ist da: {place}","This device":"Dieses Gerät","Ring for the doorbell and for faults":"Bei Türklingel und Störung läuten","Install as an app":"Als App installieren","As an app: Share, then Add to Home Screen.":"Als App: Teilen, dann „Zum Home-Bildschirm“.","This browser does not keep the screen on while the drone flies.":"Dieser Browser lässt den Bildschirm im Flug nicht an.","It sounds while the page is open.":"Es läutet, solange die Seite offen ist.","It sounds from your next touch on, while the page is open.":"Es läutet ab der nächsten Berührung, solange die Seite offen ist.","It notifies beside other pages.":"Auch neben anderen Seiten kommt eine Nachricht.","Notifications are forbidden: its settings in the browser allow them.":"Mitteilungen sind verboten: im Browser erlauben.","Housefly: look at the drone":"Housefly: nach der Drohne sehen",Watch:"Zusehen",Fly:"Fliegen","may see everything, and STOP or land the drone":"darf alles sehen und die Drohne anhalten oder landen","may watch and ask; a flight waits for your yes":"darf zusehen und bitten; ein Flug wartet auf Ihr Ja","may take control and fly":"darf steuern und fliegen","What the guest may do":"Was der Gast darf","No link could be made.":"Es konnte kein Link erstellt werden.","Your role is “{role}”: ask who runs Housefly for a link.":"Ihre Rolle ist „{role}“: Um einen Link bitten, wer Housefly betreibt.","What may the other one do? STOP is for everybody.":"Was darf der Gast? STOP ist für alle da.","The link was used: the guest {may}.":"Der Link wurde benutzt: Wer ihn öffnete, {may}.","The link expired: make a new one.":"Der Link ist abgelaufen: einen neuen erstellen.","The first to open it {may}. It works once, for:":"Wer den Link zuerst öffnet, {may}. Er gilt einmal, noch:","Only this machine reaches the console.":"Nur dieses Gerät erreicht die Konsole.","For a phone, restart with:":"Für ein Handy Housefly beenden und so starten:","QR code of the link":"QR-Code des Links",Copied:"Kopiert","Copy link":"Link kopieren",Share:"Teilen","Ask for something":"Um etwas bitten","Look at the entrance, where is the cup …":"Schau zum Eingang, wo ist die Tasse …","“{words}”, answered {age}":"„{words}“, beantwortet {age}","Yes, do it":"Ja, ausführen","The services are not running.":"Die Dienste laufen nicht.","The services are not running: nothing can be asked for now.":"Die Dienste laufen nicht: Jetzt ist nichts möglich.","What is shown here is what was known {age}.":"Die Anzeige ist von {age}.","services not running":"Dienste laufen nicht","Simulated doorbell":"Simulierte Türklingel","Ring the doorbell":"Klingeln","This room is simulated: press, and a visitor comes to the door.":"Dieser Raum ist simuliert: Drücken, und jemand kommt zur Tür.","What can be done":"Was möglich ist",Services:"Dienste","Not known yet.":"Noch nicht bekannt.","Say first: {what}.":"Zuerst angeben: {what}.",Start:"Ausführen","Start: {title}":"Ausführen: {title}",Rehearse:"Proben","Rehearsing …":"Wird geprobt …",Questions:"Fragen","{n} more question|{n} more questions":"{n} weitere Frage|{n} weitere Fragen","Question of task {n}":"Frage von Aufgabe {n}","Without an answer it counts as “{choice}” in {time}.":"Ohne Antwort gilt in {time}: „{choice}“.",Now:"Jetzt","Nothing is asked for.":"Es liegt nichts an.","Task {n}":"Aufgabe {n}","{words}: task {n}":"{words}: Aufgabe {n}",Pause:"Pause","Go on":"Weiter",Cancel:"Abbrechen",Steps:"Schritte","waiting for a yes":"wartet auf ein Ja",queued:"in der Warteschlange",running:"läuft",paused:"angehalten",suspended:"unterbrochen",waiting:"wartet",skipped:"übersprungen",done:"erledigt",failed:"gescheitert",cancelled:"abgebrochen",refused:"abgelehnt",expired:"abgelaufen","asked for by {who}":"von {who} verlangt","asked for":"verlangt",", because of {cause}":", Anlass: {cause}","in the console":"in der Konsole","on the command line":"auf der Befehlszeile","over HTTP":"über HTTP","over MQTT":"über MQTT","by a webhook":"durch einen Webhook","by an assistant":"durch einen Assistenten","The bell rings":"Es klingelt","Somebody may have fallen":"Vielleicht ist jemand gestürzt","Who walks there may close the way for a moment: ask again when it is free.":"Wer dort geht, versperrt vielleicht kurz den Weg: noch einmal bitten, wenn er frei ist.",yes:"ja",no:"nein","What was":"Was war",History:"Verlauf",Clips:"Clips",Rules:"Regeln","No task has ended yet.":"Noch keine Aufgabe ist beendet.","Older tasks":"Ältere Aufgaben","that is all":"das ist alles",Trigger:"Auslöser",Decision:"Entscheidung","It was not rehearsed.":"Es wurde nicht geprobt.",Flight:"Flug","{time}, in the air for {span}.":"{time}, {span} in der Luft.","It did not begin.":"Sie hat nicht begonnen.","It did not fly.":"Es wurde nicht geflogen.","Recorded:":"Aufgezeichnet:",Outcome:"Ergebnis","None.":"Keiner.","None is kept any more.":"Keiner mehr aufbewahrt.",Clip:"Clip","Show clip, {time}":"Clip zeigen, {time}","Show snapshot":"Foto zeigen",Save:"Speichern","Save all":"Alle speichern","Save all of these":"Diese alle speichern","Picture of {title}":"Bild: {title}","Clip of {title}":"Clip: {title}","This clip is gone, or this browser cannot show it.":"Diesen Clip gibt es nicht mehr, oder der Browser kann ihn nicht zeigen.",Keep:"Behalten","Keep no longer than others":"Nicht länger als andere behalten",Delete:"Löschen","Delete this clip":"Diesen Clip löschen",When:"Wann",Place:"Ort",Thing:"Ding",People:"Personen",For:"Für","Because of":"Anlass",End:"Ende",Privacy:"Privatsphäre",Kept:"Aufbewahrt",Size:"Größe","{service}, task {n}":"{service}, Aufgabe {n}","missing: a crash or a full disk cut it off":"fehlt: durch Absturz oder volle Platte abgeschnitten","a part of the picture is blank, as the site says":"ein Teil des Bildes ist abgedeckt, wie eingestellt","until somebody deletes it":"bis jemand ihn löscht","until {time}":"bis {time}","Which clips":"Welche Clips",person:"Person",place:"Ort",thing:"Ding",time:"Zeit",any:"beliebig","any time":"jederzeit",today:"heute","this week":"diese Woche","this month":"dieser Monat","{n} or more clips.":"{n} oder mehr Clips.","{n} clip.|{n} clips.":"{n} Clip.|{n} Clips.","There is no such clip.":"Keinen solchen Clip gefunden.",snapshot:"Foto","cut off":"abgeschnitten","Older clips":"Ältere Clips","There is no rule.":"Es gibt keine Regel.","(off)":"(aus)","What would have happened last week?":"Was wäre letzte Woche geschehen?","What the rules would have done":"Was die Regeln getan hätten","Nothing.":"Nichts.","Mode of the house":"Modus des Hauses",Mode:"Modus","home^mode":"zu Hause","away^mode":"abwesend","night^mode":"Nacht","privacy^mode":"privat","maintenance^mode":"Wartung",recording:"Aufnahme","Taken by":"Aufgenommen von","First steps":"Erste Schritte","Choose a place on the map, or ask above.":"Einen Ort auf der Karte wählen oder oben fragen.","Hold the large button to fly.":"Zum Fliegen die große Taste halten.","STOP stops at once. It works for everybody, at any time.":"STOP hält sofort an. Für alle, jederzeit.",OK:"OK","Close the hints":"Hinweise schließen","Show the first steps again":"Erste Schritte noch einmal zeigen","Waiting for the room":"Warten auf den Raum","Map of the room":"Karte des Raums","Floor plan with the drone. Arrow keys move the goal; a list of places follows.":"Grundriss mit der Drohne. Pfeiltasten verschieben das Ziel; danach folgen die Orte.",Legend:"Legende","People and things are not shown: {why}.":"Personen und Dinge fehlen: {why}.","kept free by order":"Verbotszone","too close to fly":"zu eng zum Fliegen","{n} in the way that no map knows":"{n} im Weg, der Karte unbekannt","{p} sure":"{p} sicher","told before":"früher gemeldet","Place unknown: {names}":"Ort unbekannt: {names}","{name} (in {holder})":"{name} (in {holder})","height {d} m, no curve is flown":"Höhe {d} m, keine Kurve","height unknown":"Höhe unbekannt","{low} to {high} m":"{low} bis {high} m","height {heights} over {length} m in {n} s, up to {fastest} m/s":"Höhe {heights} auf {length} m in {n} s, bis {fastest} m/s","± {one} in the plane, ± {other} in height":"± {one} in der Ebene, ± {other} in der Höhe","; stops in {d} m":"; hält nach {d} m","Height unknown":"Höhe unbekannt","Height {d} metres":"Höhe {d} Meter","Flight height":"Flughöhe","0 to {d} m/s, a dot each second":"0 bis {d} m/s, ein Punkt je Sekunde","stops here if it brakes now":"hält hier, wenn sie jetzt bremst","Zoom of the map":"Zoom der Karte","Zoom in":"Vergrößern","Zoom in (+)":"Vergrößern (+)","Zoom out":"Verkleinern","Zoom out (-)":"Verkleinern (-)","Whole room":"Ganzer Raum","Whole room (0)":"Ganzer Raum (0)","The drone is out of view: show it":"Die Drohne ist nicht im Bild: zeigen","Show the drone":"Drohne zeigen",Time:"Zeit","Live again: {why}":"Wieder live: {why}","Back to live":"Zurück zu live","● Live":"● Live","Time shown":"Gezeigte Zeit","How far back":"Wie weit zurück","10 min":"10 min","1 h":"1 h","6 h":"6 h","1 day":"1 Tag","1 week":"1 Woche","Flight at {time}, {span} long":"Flug um {time}, {span} lang","Flight at {time} to {goal}, {span} long":"Flug um {time} zu {goal}, {span} lang",", with warnings":", mit Warnungen",", with faults":", mit Störungen","{name}: look at it again":"{name}: noch einmal ansehen",Play:"Abspielen","How fast":"Wie schnell","Moment of the recording":"Zeitpunkt der Aufzeichnung","{time} of {span}":"{time} von {span}","Recorded, not live":"Aufzeichnung, nicht live",Recorded:"Aufgezeichnet","Log, recorded":"Protokoll, aufgezeichnet","Log of the recording":"Protokoll der Aufzeichnung","Recorded picture":"Aufgezeichnetes Bild","No picture of this moment was kept.":"Von diesem Zeitpunkt gibt es kein Bild.","nobody saw the drone":"niemand sah die Drohne","{high} m high, {fast} m/s, battery {p}":"{high} m hoch, {fast} m/s, Akku {p}","The drone may be in the air: what is live stays on the screen.":"Die Drohne ist vielleicht in der Luft: Die Gegenwart bleibt im Bild.","the drone may be in the air":"die Drohne ist vielleicht in der Luft","a goal was chosen":"ein Ziel wurde gewählt","STOP was pressed":"STOP wurde gedrückt","never seen":"nie gesehen","has {names}":"hat {names}","in it: {names}":"darin: {names}","idle^phase":"bereit","taking off^phase":"startet","flying to goal^phase":"Hinweg","looking^phase":"sieht nach","holding^phase":"schwebt","returning^phase":"Rückweg","landing^phase":"landet","The view in space could not be fetched: no contact with the server.":"Die Raumansicht ließ sich nicht laden: keine Verbindung zum Server.","Fetching the view in space …":"Raumansicht wird geladen …",Plan:"Plan","3-D":"3-D","The room in space":"Der Raum in 3-D","This browser cannot draw in space (WebGL is off or missing). The plan shows the same.":"Dieser Browser kann nicht in 3-D zeichnen (WebGL fehlt). Der Plan zeigt dasselbe.","Recorded, not live.":"Aufzeichnung, nicht live.","Nobody sees the drone.":"Niemand sieht die Drohne.","The drone was seen {time} ago.":"Die Drohne wurde vor {time} gesehen.","Drag to turn, two fingers or the wheel to come nearer.":"Ziehen zum Drehen, zwei Finger oder das Rad zum Nähern.","People are where they were last seen; pale is long ago.":"Personen stehen, wo sie zuletzt gesehen wurden; blass ist lange her.","Picture from the drone":"Bild der Drohne","No picture yet":"Noch kein Bild","No new picture for {time}":"Seit {time} kein neues Bild","Make the map large, or small again":"Karte vergrößern oder wieder verkleinern","Make the picture large, or small again":"Bild vergrößern oder wieder verkleinern","Swap (M)":"Tauschen (M)","No services run here, and only they keep pictures: nothing was kept.":"Hier laufen keine Dienste, nur sie bewahren Bilder auf: nichts wurde behalten.","Nothing was kept.":"Nichts wurde behalten.","Keep this picture as a photo":"Dieses Bild als Foto behalten",Snap:"Foto","Photo kept":"Foto behalten","in Tasks, Clips.":"unter Aufgaben, Clips.","in Tasks, Clips, until {date}.":"unter Aufgaben, Clips, bis {date}.",Show:"Zeigen","Map being edited":"Karte in Bearbeitung","Floor plan being edited. The list of places and zones follows.":"Grundriss in Bearbeitung. Danach folgen Orte und Zonen.","too close":"zu eng","Tap the map for a new place, drag on it for a new zone, or:":"Für einen neuen Ort auf die Karte tippen, für eine neue Zone ziehen, oder:","Tap or drag on the map to move what is open; Done when it is right.":"Zum Verschieben auf die Karte tippen oder ziehen; Fertig, wenn es stimmt.","Drag on the map to draw the open zone again; Done when it is right.":"Zum Neuzeichnen der Zone auf der Karte ziehen; Fertig, wenn es stimmt.","Edit places and zones":"Orte und Zonen bearbeiten","Places and no-fly zones":"Orte und Verbotszonen","version {n}":"Fassung {n}","version {n}, by {who}":"Fassung {n}, von {who}","never edited":"nie bearbeitet","Add a place":"Ort hinzufügen","Add a zone":"Zone hinzufügen","Places and zones":"Orte und Zonen","new place":"neuer Ort","new zone":"neue Zone","where it starts and lands":"wo sie startet und landet","Not saved yet.":"Noch nicht gespeichert.","The drone keeps the map that it started with.":"Die Drohne behält die Karte vom Start.","What is saved here counts from the next start of Housefly on.":"Gespeichertes gilt ab dem nächsten Start von Housefly.","What is saved here counts from the next start on, or as soon as you use it after Save.":"Gespeichertes gilt ab dem nächsten Start von Housefly oder nach „Jetzt verwenden“.",Discard:"Verwerfen",Undo:"Rückgängig","Go back to the version before":"Zur vorigen Fassung zurück",Remove:"Entfernen","Remove {name}":"Entfernen: {name}",Done:"Fertig",Name:"Name","Reading corner":"Leseecke","In commands: {name}":"In Befehlen: {name}","Hovers at [m]":"Schwebt bei [m]","Looks at [m]":"Sieht auf [m]",height:"Höhe","on map":"auf Karte","x from":"x von","y from":"y von","x to":"x bis","y to":"y bis",Reason:"Grund","Wet floor":"Nasser Boden","Kept free [m]":"Frei halten [m]","These changes were not saved before. Save or Discard them.":"Diese Änderungen sind noch nicht gespeichert: speichern oder verwerfen.","{who} has control, and only who has control may change the room.":"{who} steuert, und nur wer steuert, darf den Raum ändern.","Take control first: only who has control may change the room.":"Erst steuern: Nur wer steuert, darf den Raum ändern.","Give this place a name.":"Diesem Ort einen Namen geben.","In the air the drone keeps the map that it took off with: land first.":"In der Luft behält die Drohne die Karte vom Start: erst landen.","Nobody knows whether the drone flies: the new map waits.":"Niemand weiß, ob die Drohne fliegt: Die neue Karte wartet.","That is being done.":"Das geschieht gerade.","The pilot has not come back. The terminal of Housefly says why.":"Der Autopilot kam nicht zurück. Das Terminal von Housefly sagt, warum.","In use: the drone has this map now.":"In Gebrauch: Die Drohne hat jetzt diese Karte.","The pilot starts again.":"Der Autopilot startet neu.","No flight meanwhile.":"Solange kein Flug.","Use it now":"Jetzt verwenden","The pilot starts again, about {n} s. No flight meanwhile.":"Der Autopilot startet neu, etwa {n} s. Solange kein Flug.","Move by hand":"Von Hand bewegen","Up the map":"Auf der Karte nach oben","Left on the map":"Auf der Karte nach links","Right on the map":"Auf der Karte nach rechts","Down the map":"Auf der Karte nach unten",Climb:"Steigen",Sink:"Sinken","Moving while you hold.":"Bewegt sich, solange Sie halten.","Hovering. Hold an arrow, W A S D or a stick.":"Schwebt. Pfeil, W A S D oder Stick halten.","W A S D or arrows, R F":"W A S D oder Pfeile, R F","While Move by hand is on: move the drone, up and down":"Bei „Von Hand bewegen“: Drohne bewegen, auf und ab","+ − 0":"+ − 0","Map with the focus: nearer, farther, whole room":"Karte gewählt: näher, weiter, ganzer Raum","No drone":"Keine Drohne","To add one: enabled = true under [drone] in the site file.":"Um eine hinzuzufügen, unter [drone] der Standortdatei enabled = true setzen und neu starten.","Floor plan of the room":"Grundriss des Raums"},h=["Wer ist an der Tür?","Ist jemand da?","Ist alles in Ordnung?","Was ist heute passiert?"],l={texts:a,ideas:h,templates:e};export{l as DE};
