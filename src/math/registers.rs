//! Functions on numbers side by side, compiled for processors with registers of several widths.

/// Registers of a processor that functions of packets are compiled for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Registers {
    /// Those that every processor of this kind has.
    Base,
    /// Registers of AVX2, for four numbers.
    Avx2,
    /// Registers of AVX-512, for eight numbers.
    Avx512,
}

impl Registers {
    /// Returns the widest registers of this processor.
    #[inline(always)]
    pub fn widest() -> Self {
        #[cfg(test)]
        if let Some(forced) = testing::FORCED.get() {
            return forced;
        }
        Self::detected()
    }

    #[inline(always)]
    fn detected() -> Self {
        #[cfg(target_arch = "x86_64")]
        {
            if is_x86_feature_detected!("avx512vl") && is_x86_feature_detected!("avx512dq") {
                return Self::Avx512;
            }
            if is_x86_feature_detected!("avx2") {
                return Self::Avx2;
            }
        }
        Self::Base
    }
}

/// Defines a function whose body is compiled three times: for processors with AVX-512, for those with AVX2, and for all others.
/// All versions have the same operations, and so the same results. What the body calls is compiled with it only if it is
/// inlined.
macro_rules! wide_versions {
    (
        $(#[$attribute:meta])*
        $visibility:vis fn $name:ident $(<$($lifetime:lifetime),* $(; $parameter:ident: ($($bound:tt)+))?>)?
        ($($argument:ident: $type:ty),* $(,)?) $(-> $out:ty)? $body:block
    ) => {
        $(#[$attribute])*
        $visibility fn $name $(<$($lifetime,)* $($parameter: $($bound)+)?>)?($($argument: $type),*) $(-> $out)? {
            #[inline(always)]
            fn body $(<$($lifetime,)* $($parameter: $($bound)+)?>)?($($argument: $type),*) $(-> $out)? $body
            #[cfg(target_arch = "x86_64")]
            {
                #[target_feature(enable = "avx2")]
                fn avx2 $(<$($lifetime,)* $($parameter: $($bound)+)?>)?($($argument: $type),*) $(-> $out)? {
                    body($($argument),*)
                }
                #[target_feature(enable = "avx2,avx512f,avx512dq,avx512vl")]
                fn avx512 $(<$($lifetime,)* $($parameter: $($bound)+)?>)?($($argument: $type),*) $(-> $out)? {
                    body($($argument),*)
                }
                let registers = $crate::math::registers::Registers::widest();
                if registers == $crate::math::registers::Registers::Avx512 {
                    // SAFETY: the processor has the features that the function needs; AVX-512 implies AVX2.
                    #[expect(unsafe_code, reason = "the compiler can't know the processor")]
                    return unsafe { avx512($($argument),*) };
                }
                if registers == $crate::math::registers::Registers::Avx2 {
                    // SAFETY: the processor has the feature that the function needs.
                    #[expect(unsafe_code, reason = "the compiler can't know the processor")]
                    return unsafe { avx2($($argument),*) };
                }
            }
            body($($argument),*)
        }
    };
}
pub(crate) use wide_versions;

/// For tests: functions of packets as other processors run them.
#[cfg(test)]
pub mod testing {
    use super::Registers;
    use std::cell::Cell;

    thread_local! {
        pub(super) static FORCED: Cell<Option<Registers>> = const { Cell::new(None) };
    }

    /// Calls a function once for each kind of registers that this processor has; meanwhile functions of packets use these.
    pub fn for_all_registers(mut call: impl FnMut(Registers)) {
        for registers in [Registers::Base, Registers::Avx2, Registers::Avx512] {
            if registers as u8 <= Registers::detected() as u8 {
                FORCED.set(Some(registers));
                call(registers);
                FORCED.set(None);
            }
        }
    }
}
