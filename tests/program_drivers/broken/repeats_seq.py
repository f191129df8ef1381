"""Its seq has the same number twice now and then."""

import honest


class Broken(honest.Program):
    def next_seq(self):
        self.seq += 1
        return self.seq - self.seq // 10


Broken().run()
