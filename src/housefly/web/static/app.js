import"./chunk-chunk-IKDTSDSQ.js";
