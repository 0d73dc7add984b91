import"./chunk-chunk-3EKDO2TE.js";
