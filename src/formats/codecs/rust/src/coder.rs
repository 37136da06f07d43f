// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

//! The adaptive arithmetic decoder of LASzip, from memory (A. Said: Arithmetic Coding, in K. Sayood, ed.: Lossless
//! Compression Handbook, 2003, chapter 5). It gives what that of the crate gives and is faster for where it searches:
//! a table of the size of the alphabet leads next to the symbol, and a few steps do the rest.

use std::hint::select_unpredictable;

const LENGTH_BITS: u32 = 15; // of an interval's length that models divide
const BIT_LENGTH_BITS: u32 = 13; // those of models of one bit
const MOST_COUNT: u32 = 1 << LENGTH_BITS;
const MOST_BIT_COUNT: u32 = 1 << BIT_LENGTH_BITS;
const MOST_BIT_CYCLE: u32 = 64;

const SPARE: usize = 8; // entries written together

#[derive(Clone, Copy)]
struct Cell {
    from: u16,  // of the interval, in 2^15ths
    count: u16, // how often the symbol came
}

/// How often each of some symbols comes. CELLS: one more than symbols, at least; TABLE: entries that lead to them,
/// and SPARE ones.
pub struct Model<const CELLS: usize, const TABLE: usize> {
    until_update: u32,
    last: u32,
    cycle: u32,
    total: u32,
    table: [u8; TABLE],
    cells: [Cell; CELLS],
    is_bit: bool,
}
/// Of up to 256 symbols.
pub type Bytes = Model<257, 264>;
/// Of up to 33: within which power of two a number is.
pub type Kinds = Model<34, 72>;
/// Of times: which multiple of the last step.
pub type Multiples = Model<517, 264>;

impl<const CELLS: usize, const TABLE: usize> Model<CELLS, TABLE> {
    const ENTRIES: usize = TABLE - SPARE;
    const SHIFT: u32 = LENGTH_BITS - Self::ENTRIES.trailing_zeros();
    /// An entry is a byte: of more symbols half of theirs.
    const HALVED: u32 = (CELLS > 257) as u32;

    pub fn new(symbols: usize) -> Self {
        let mut model = Model {
            until_update: 0,
            last: symbols as u32 - 1,
            cycle: symbols as u32,
            total: 0,
            table: [0; TABLE],
            cells: [Cell { from: u16::MAX, count: 1 }; CELLS],
            is_bit: false,
        };
        model.update();
        model.cycle = (symbols as u32 + 6) >> 1;
        model.until_update = model.cycle;
        model
    }

    /// Of one bit, which has a law of its own.
    pub fn bit() -> Self {
        let mut model = Self::new(2);
        model.is_bit = true;
        model.total = 2;
        model.cells[0].count = 1;
        model.cells[1].count = 0;
        model.set_bit((MOST_BIT_COUNT / 2) as u16);
        model.cycle = 4;
        model.until_update = 4;
        model
    }

    fn length_bits(&self) -> u32 {
        if self.is_bit {
            BIT_LENGTH_BITS
        } else {
            LENGTH_BITS
        }
    }

    fn set_bit(&mut self, zeros: u16) {
        self.cells[0].from = 0;
        self.cells[1].from = zeros;
        for (i, entry) in self.table.iter_mut().enumerate() {
            *entry = u8::from((i as u32) << Self::SHIFT >= u32::from(zeros));
        }
    }

    fn update_bit(&mut self) {
        self.total += self.cycle;
        let mut zeros = u32::from(self.cells[0].count);
        if self.total > MOST_BIT_COUNT {
            self.total = (self.total + 1) >> 1;
            zeros = (zeros + 1) >> 1;
            if zeros == self.total {
                self.total += 1;
            }
        }
        self.cells[0].count = zeros as u16;
        self.cells[1].count = 0;
        let scale = 0x8000_0000 / self.total;
        self.set_bit(((zeros * scale) >> (31 - BIT_LENGTH_BITS)) as u16);
        self.cycle = ((5 * self.cycle) >> 2).min(MOST_BIT_CYCLE);
        self.until_update = self.cycle;
    }

    #[cold]
    #[inline(never)]
    fn update(&mut self) {
        if self.is_bit {
            return self.update_bit();
        }
        let symbols = self.last as usize + 1;
        self.total += self.cycle;
        if self.total > MOST_COUNT {
            self.total = 0;
            for cell in &mut self.cells[..symbols] {
                cell.count = (cell.count + 1) >> 1;
                self.total += u32::from(cell.count);
            }
        }
        let scale = 0x8000_0000 / self.total;
        let mut sum = 0u32;
        let mut next = 0; // entry that none of the symbols before has filled
        for (symbol, cell) in self.cells[..symbols].iter_mut().enumerate() {
            let from = (scale * sum) >> (31 - LENGTH_BITS);
            cell.from = from as u16;
            sum += u32::from(cell.count);
            // From the first entry on that begins behind where the symbol does, as far as the next one leaves it.
            let entry = ((from + (1 << Self::SHIFT) - 1) >> Self::SHIFT) as usize;
            while next < entry {
                next = lead(&mut self.table, next, (symbol - 1) >> Self::HALVED);
            }
            next = lead(&mut self.table, entry, symbol >> Self::HALVED);
        }
        while next < Self::ENTRIES {
            next = lead(&mut self.table, next, (symbols - 1) >> Self::HALVED);
        }
        self.cycle = ((5 * self.cycle) >> 2).min((self.last + 7) << 3);
        self.until_update = self.cycle;
    }
}

/// Has entries from the first one on lead to the symbol; which one is next.
#[inline(always)]
fn lead(table: &mut [u8], first: usize, symbol: usize) -> usize {
    table[first..][..SPARE].copy_from_slice(&[symbol as u8; SPARE]);
    first + SPARE
}

/// A model that is made when it is first asked for.
pub type Lazy<M> = Option<Box<M>>;
#[inline(always)]
pub fn bytes_of(model: &mut Lazy<Bytes>, symbols: usize) -> &mut Bytes {
    model.get_or_insert_with(|| boxed(symbols))
}
/// Apart, so that loops over symbols stay small.
#[cold]
#[inline(never)]
pub fn boxed<const CELLS: usize, const TABLE: usize>(symbols: usize) -> Box<Model<CELLS, TABLE>> {
    Box::new(Model::new(symbols))
}

/// Where a stream of code stands. Behind its end come zeros: `is_past` tells so, before much is made of them.
#[derive(Clone, Copy)]
pub struct Decoder<'a> {
    value: u32, // always below length
    length: u32,
    at: usize,
    bytes: &'a [u8],
}

impl<'a> Decoder<'a> {
    pub fn new(bytes: &'a [u8]) -> Self {
        let mut decoder = Decoder { value: 0, length: u32::MAX, at: 0, bytes };
        decoder.value = ((decoder.next() >> 32) as u32).min(u32::MAX - 1);
        decoder.at = 4;
        decoder
    }

    pub fn is_past(&self) -> bool {
        self.at > self.bytes.len()
    }

    /// Eight bytes, of which some are taken.
    #[inline(always)]
    fn next(&self) -> u64 {
        match self.bytes.get(self.at..).and_then(|rest| rest.first_chunk()) {
            Some(eight) => u64::from_be_bytes(*eight),
            None => self.next_of_end(),
        }
    }

    #[cold]
    #[inline(never)]
    fn next_of_end(&self) -> u64 {
        let rest = self.bytes.get(self.at..).unwrap_or(&[]);
        let mut eight = [0; 8];
        eight[..rest.len()].copy_from_slice(rest);
        u64::from_be_bytes(eight)
    }

    /// Back to a length of 2^24 at least, of 2^8 or more.
    #[inline(always)]
    fn take_two(&mut self) {
        let next = self.next();
        let (value, length) = (self.value, self.length);
        let (one, two) = (length < 1 << 24, length < 1 << 16);
        let of_one = value << 8 | (next >> 56) as u32;
        let of_two = value << 16 | (next >> 48) as u32;
        self.value = select_unpredictable(two, of_two, select_unpredictable(one, of_one, value));
        self.length =
            select_unpredictable(two, length << 16, select_unpredictable(one, length << 8, length));
        self.at += usize::from(one) + usize::from(two);
    }

    /// The same of any length.
    #[inline(always)]
    fn take_three(&mut self) {
        let length = self.length;
        let bytes =
            u32::from(length < 1 << 24) + u32::from(length < 1 << 16) + u32::from(length < 1 << 8);
        let next = u64::from(self.value) << 32 | self.next() >> 32;
        self.value = ((next << (8 * bytes)) >> 32) as u32;
        self.length <<= 8 * bytes;
        self.at += bytes as usize;
    }

    #[inline(always)]
    pub fn symbol<const CELLS: usize, const TABLE: usize>(
        &mut self,
        model: &mut Model<CELLS, TABLE>,
    ) -> usize {
        self.coded(model, LENGTH_BITS)
    }

    /// Of a model of one bit or of more.
    #[inline(always)]
    pub fn symbol_or_bit(&mut self, model: &mut Bytes) -> usize {
        let bits = model.length_bits();
        self.coded(model, bits)
    }

    #[inline(always)]
    fn coded<const CELLS: usize, const TABLE: usize>(
        &mut self,
        model: &mut Model<CELLS, TABLE>,
        length_bits: u32,
    ) -> usize {
        let part = self.length >> length_bits;
        let place = self.value / part;
        let entry = ((place >> Model::<CELLS, TABLE>::SHIFT) as usize).min(Model::<CELLS, TABLE>::ENTRIES - 1);
        let mut symbol = usize::from(model.table[entry]) << Model::<CELLS, TABLE>::HALVED;
        // The cell behind the last one begins beyond all places.
        while u32::from(model.cells[symbol + 1].from) <= place {
            symbol += 1;
        }
        let from = u32::from(model.cells[symbol].from) * part;
        let to = if symbol == model.last as usize {
            self.length
        } else {
            u32::from(model.cells[symbol + 1].from) * part
        };
        self.value -= from;
        self.length = to - from;
        self.take_two();
        model.cells[symbol].count += 1;
        model.until_update -= 1;
        if model.until_update == 0 {
            model.update();
        }
        symbol
    }

    #[inline(always)]
    fn few_bits(&mut self, bits: u32) -> u32 {
        self.length >>= bits;
        let number = self.value / self.length;
        self.value -= self.length * number;
        self.take_three();
        number
    }

    /// A number that no model foretells.
    #[inline(always)]
    pub fn bits(&mut self, bits: u32) -> u32 {
        if bits > 19 {
            let low = self.few_bits(16) & 0xffff;
            self.few_bits(bits - 16) << 16 | low
        } else {
            self.few_bits(bits)
        }
    }

    /// One of 32 bits.
    pub fn whole(&mut self) -> u32 {
        let low = self.few_bits(16) & 0xffff;
        (self.few_bits(16) & 0xffff) << 16 | low
    }
}
