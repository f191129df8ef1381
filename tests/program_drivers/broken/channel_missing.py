"""It tells fewer temperatures than it has channels."""

import honest


class Broken(honest.Program):
    def state(self):
        return {"temperatures": [295.2, None]}


Broken().run()
