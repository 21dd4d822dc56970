//! Andrews' squeezing mechanism by the names of the test set, for every model that has them as fields.

/// The model's struct from the golden data's parameters.
macro_rules! andrews {
    ($model:ident, $values:expr) => {
        $crate::support::golden::from_json!(
            $values,
            $model {
                m1: "m1",
                m2: "m2",
                m3: "m3",
                m4: "m4",
                m5: "m5",
                m6: "m6",
                m7: "m7",
                i1: "I1",
                i2: "I2",
                i3: "I3",
                i4: "I4",
                i5: "I5",
                i6: "I6",
                i7: "I7",
                xa: "xa",
                ya: "ya",
                xb: "xb",
                yb: "yb",
                xc: "xc",
                yc: "yc",
                d: "d",
                da: "da",
                e: "e",
                ea: "ea",
                zf: "zf",
                zt: "zt",
                fa: "fa",
                rr: "rr",
                ra: "ra",
                ss: "ss",
                sa: "sa",
                sb: "sb",
                sc: "sc",
                sd: "sd",
                ta: "ta",
                tb: "tb",
                u: "u",
                ua: "ua",
                ub: "ub",
                c0: "c0",
                l0: "l0",
                mom: "mom",
            }
        )
    };
}
pub(crate) use andrews;
