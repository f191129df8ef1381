"""Its limits of an angle are degrees."""

import honest

honest.AXES[:] = ["x", "y", "theta_z"]
honest.LIMITS["theta_z"] = [-30.0, 30.0]
honest.LIMITS.pop("z")
honest.Program().run()
