import"./chunk-chunk-B555YXXZ.js";
