"""Why a case differs from CONTACT's output: what the two programs do otherwise, told by the scene and by what differs."""

SHEAR_OF_ELEMENTS = 0.03  # of friction times Fn: what the place of shear in an element changes on coarse grids
SLIP_ABOUT_A_POINT = 0.08  # of it: what slip that is linear about a point changes, in contacts with much spin
UNEXPLAINED = "not explained"


def reason_of(scene: str, differences: dict, there: dict, here: dict) -> str:
    """In words. `there` and `here` have the totals of both programs."""
    shear = max(abs(differences["Fx"]), abs(differences["Fy"]))
    normal = abs(differences["Fn"])
    in_planes = "a plane at each patch" in scene  # D = 2 and its relatives
    patches = max(there.get("patches", 1), int(here.get("patches", 1)))
    if "temperature.hot_friction" in scene:
        return "friction by temperature: the iteration between temperature and friction is relaxed there, and ends earlier"
    if 'kind = "patch"' in scene:
        if shear <= SHEAR_OF_ELEMENTS and normal <= 0.01:
            return "elements: shear acts at the centre of an element there, and its mean counts here; few elements in contact"
        return UNEXPLAINED
    if "motion.friction_table" in scene and in_planes:
        return "friction by inclination: one coefficient for each patch there (D = 2), one for each row here"
    if patches > 1:
        return "several patches: they do not feel each other's pressure there, or only partly (D_SEP, D_COMB)"
    if "position.vertical" in scene and normal > 0.01:
        return "the height is given: a plane at the patch there (D = 2), the surface here; Fn grows by 1 % in 0.5 um"
    if in_planes and shear <= SLIP_ABOUT_A_POINT:
        return "a plane at the patch there (D = 2): its slip is linear about one point, and its angle is that of the point"
    if not in_planes and "rail.place" not in scene:
        return "curved surface: another reference point and direction of the slip (D = 4)"
    return UNEXPLAINED
