//! The sum of the cycles.

/// What a block takes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Block {
    /// Its first address.
    pub address: u32,
    /// The address behind its last instruction.
    pub end: u32,
    /// Cycles, if its last instruction does not branch.
    pub cycles: u32,
    /// What a branch takes more where it is taken.
    pub taken: u32,
    /// What its first instruction takes more where a branch leads to it.
    pub entered: u32,
    /// The last instruction is a conditional branch back, which the chip may predict.
    pub predicted: bool,
}

/// The blocks of a program, and what those that were carried out took.
#[derive(Debug)]
pub struct Counter {
    /// Where the program's instructions begin.
    base: u32,
    /// For each halfword from there the number of the block that begins at it, from 1; 0 where none is known.
    numbers: Vec<u32>,
    blocks: Vec<Block>,
    /// How often each block was carried out while the program measured.
    executions: Vec<u64>,
    /// The block that was carried out last.
    last: Option<u32>,
    /// The chip predicts that the branch back that was taken last is taken again.
    predicts: bool,
    /// That branch, as the number of its block.
    remembered: Option<u32>,
    cycles: u64,
    /// The program reads the clock when a measurement begins and when it ends.
    measuring: bool,
}

impl Counter {
    /// A counter of a program whose instructions are at these addresses.
    pub fn new(base: u32, bytes: u32, predicts: bool) -> Self {
        Self {
            base,
            numbers: vec![0; bytes as usize / 2 + 1],
            blocks: Vec::new(),
            executions: Vec::new(),
            last: None,
            predicts,
            remembered: None,
            cycles: 0,
            measuring: false,
        }
    }

    fn place(&self, address: u32) -> usize {
        (address.wrapping_sub(self.base) / 2) as usize
    }

    /// Whether the block of so many bytes at an address is known.
    pub fn knows(&self, address: u32, bytes: u32) -> bool {
        self.number(address).is_some_and(|number| self.blocks[number as usize].end == address.wrapping_add(bytes))
    }

    fn number(&self, address: u32) -> Option<u32> {
        self.numbers.get(self.place(address))?.checked_sub(1)
    }

    /// Learns a block. `false` if it is not among the program's instructions.
    pub fn learn(&mut self, block: Block) -> bool {
        let place = self.place(block.address);
        let Some(number) = self.numbers.get_mut(place) else { return false };
        self.blocks.push(block);
        self.executions.push(0);
        *number = self.blocks.len() as u32;
        true
    }

    /// Adds a block that is carried out.
    pub fn add(&mut self, address: u32) {
        let Some(number) = self.number(address) else { return };
        let block = self.blocks[number as usize];
        if let Some(last) = self.last {
            self.cycles += u64::from(self.branch(last, block));
        }
        self.cycles += u64::from(block.cycles);
        self.executions[number as usize] += u64::from(self.measuring);
        self.last = Some(number);
    }

    /// What the way from one block to the next takes.
    fn branch(&mut self, last: u32, next: Block) -> u32 {
        let before = self.blocks[last as usize];
        let taken = next.address != before.end;
        let entered = if taken { next.entered } else { 0 };
        if !(self.predicts && before.predicted) {
            return if taken { before.taken + entered } else { 0 };
        }
        let remembered = self.remembered == Some(last);
        if taken {
            self.remembered = Some(last);
        } else if remembered {
            self.remembered = None;
        }
        if taken == remembered { entered } else { before.taken + entered }
    }

    /// Cycles so far.
    pub fn cycles(&self) -> u64 {
        self.cycles
    }

    /// The program read the clock: a measurement begins or ends.
    pub fn was_read(&mut self) {
        self.measuring = !self.measuring;
    }

    /// A block, and how often it was carried out while the program measured.
    pub fn block(&self, number: usize) -> Option<(Block, u64)> {
        Some((*self.blocks.get(number)?, *self.executions.get(number)?))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const LOOP: Block = Block { address: 0x100, end: 0x108, cycles: 3, taken: 1, entered: 0, predicted: true };
    const AFTER: Block = Block { address: 0x108, end: 0x10a, cycles: 1, taken: 2, entered: 5, predicted: false };

    /// Cycles of these blocks, one after the other.
    fn cycles(predicts: bool, order: &[Block]) -> u64 {
        let mut counter = Counter::new(0x100, 0x100, predicts);
        for block in [LOOP, AFTER] {
            assert!(counter.learn(block));
        }
        for block in order {
            counter.add(block.address);
        }
        counter.cycles()
    }

    #[test]
    fn a_branch_costs_more_where_it_is_taken() {
        assert_eq!(cycles(false, &[LOOP, AFTER]), 3 + 1);
        assert_eq!(cycles(false, &[LOOP, LOOP, AFTER]), 3 + 1 + 3 + 1);
        assert_eq!(cycles(false, &[AFTER, LOOP]), 1 + 2 + 3);
    }

    #[test]
    fn where_a_branch_leads_to_may_cost_more() {
        assert_eq!(cycles(false, &[AFTER, AFTER]), 1 + 2 + 5 + 1);
    }

    #[test]
    fn the_branch_back_that_was_taken_last_is_predicted() {
        // Not predicted, predicted, then predicted in vain.
        assert_eq!(cycles(true, &[LOOP; 3]), 3 + 1 + 3 + 3);
        assert_eq!(cycles(true, &[LOOP, LOOP, AFTER]), 3 + 1 + 3 + 1 + 1);
        // In vain it was forgotten.
        assert_eq!(cycles(true, &[LOOP, LOOP, AFTER, LOOP, AFTER]), 3 + 1 + 3 + 1 + 1 + 2 + 3 + 1);
    }

    #[test]
    fn a_block_of_another_length_is_another() {
        let mut counter = Counter::new(0x100, 0x100, false);
        assert!(counter.learn(LOOP) && counter.knows(0x100, 8) && !counter.knows(0x100, 6) && !counter.knows(0x102, 6));
        assert!(!counter.learn(Block { address: 0x1000, ..LOOP }) && !counter.learn(Block { address: 0, ..LOOP }));
    }

    #[test]
    fn executions_count_while_the_program_measures() {
        let mut counter = Counter::new(0x100, 0x100, false);
        counter.learn(LOOP);
        // Before a measurement, in it, and after it.
        for _ in 0..3 {
            counter.add(LOOP.address);
            counter.was_read();
        }
        assert_eq!((counter.block(0), counter.block(1)), (Some((LOOP, 1)), None));
    }
}
