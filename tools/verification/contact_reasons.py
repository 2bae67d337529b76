"""Why a case differs from CONTACT's output: what both programs do otherwise, told by the scene and the differences."""


def reason_of(scene: str, differences: dict, there: dict, here: dict) -> str:
    shear = max(abs(differences["Fx"]), abs(differences["Fy"]))
    if "temperature.hot_friction" in scene:
        return "friction by temperature: CONTACT's iteration is relaxed and ends earlier"
    return "not explained"
