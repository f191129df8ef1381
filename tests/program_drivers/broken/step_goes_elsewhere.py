"""A step ends elsewhere than it was sent to."""

import honest


class Broken(honest.Program):
    moves = "steps"

    def begin_step(self, to, duration):
        super().begin_step([q + 0.002 for q in to], duration)


Broken().run()
