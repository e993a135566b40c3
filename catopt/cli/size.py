"""``catopt size``: from buoy or ship, depth and weather to a mooring."""

from __future__ import annotations

from typing import Annotated

import typer

from catopt.cli.options import JsonOption, LangOption, OutOption, ReportLanguage
from catopt.cli.size_options import (
    BreadthOption,
    BuoysOption,
    ChainOption,
    CodeOption,
    CurrentOption,
    DensityOption,
    DepthOption,
    DiameterMaxOption,
    DiameterMinOption,
    FrictionOption,
    GrowthOption,
    HmaxOption,
    HsOption,
    LengthOption,
    LifeOption,
    LowWaterOption,
    Material,
    PeriodOption,
    Preference,
    PreferOption,
    RecalledOption,
    SaveOption,
    SinkerDensityOption,
    SinkerOption,
    StepOption,
    WearOption,
    WindOption,
    measure,
)

__all__ = ["size"]

size = typer.Typer(
    name="size",
    rich_markup_mode=None,
    no_args_is_help=True,
    help="Size the mooring of a buoy or a tanker from its place and its weather.",
    epilog="On a terminal, what is missing is asked for. The loads are those of catopt loads, the "
    "line is searched as by catopt design; --save writes the case of it.",
)


@size.command()
def buoy(
    context: typer.Context,
    name: Annotated[
        str | None,
        typer.Argument(
            metavar="BUOY",
            help='Name of the buoy, such as "pillar 1.8 m", or a file (.toml) with what is known; '
            "or give --force and --reserve-buoyancy.",
        ),
    ] = None,
    depth: DepthOption = None,
    low_water: LowWaterOption = None,
    force: Annotated[
        str | None, measure("--force", "Horizontal force of a buoy that is not in the library.")
    ] = None,
    reserve_buoyancy: Annotated[
        str | None,
        measure("--reserve-buoyancy", "Vertical pull that takes that buoy to its draught."),
    ] = None,
    keel_depth: Annotated[
        str | None, measure("--keel-depth", "From the water to that buoy's chain; 0 if left out.")
    ] = None,
    wind: WindOption = None,
    current: CurrentOption = None,
    hs: HsOption = None,
    hmax: HmaxOption = None,
    period: PeriodOption = None,
    soil: Annotated[
        str | None,
        typer.Option(metavar="SOIL", help='Under the sinker; "fine or silty sand" if left out.'),
    ] = None,
    friction: FrictionOption = None,
    sinker: SinkerOption = Material.CONCRETE,
    sinker_density: SinkerDensityOption = None,
    chain: ChainOption = None,
    diameter_min: DiameterMinOption = None,
    diameter_max: DiameterMaxOption = None,
    length_step: StepOption = None,
    code: CodeOption = None,
    prefer: PreferOption = Preference.BALANCED,
    life: LifeOption = None,
    wear: WearOption = None,
    growth: GrowthOption = "0 mm",
    buoys: BuoysOption = None,
    water_density: DensityOption = "1025 kg/m^3",
    recalled: RecalledOption = False,
    save: SaveOption = None,
    lang: LangOption = ReportLanguage.ENGLISH,
    as_json: JsonOption = False,
    out: OutOption = None,
) -> None:
    """Size the chain and the sinker of a buoy.

    Wind, current and waves come from one side, after IALA's CALMAR reference. The chain is
    checked by IALA's rules under the storm at high and at low water; what is not given is taken,
    and the answer says so. What is given as an option goes before what a file says.
    """
    from catopt.cli.size_answer import check_places, give, sized
    from catopt.cli.size_file import fill, is_file
    from catopt.cli.size_note import given_to_size
    from catopt.cli.size_questions import asked_buoy
    from catopt.cli.size_requests import Wishes, buoy_request, titled
    from catopt.render.texts import Words
    from catopt.sizing import size_buoy

    options = {
        "BUOY": None if is_file(name) else name,
        "--depth": depth,
        "--low-water": low_water,
        "--force": force,
        "--reserve-buoyancy": reserve_buoyancy,
        "--keel-depth": keel_depth,
        "--wind": wind,
        "--current": current,
        "--hs": hs,
        "--hmax": hmax,
        "--period": period,
        "--soil": soil,
        "--friction": friction,
        "--sinker-density": sinker_density,
        "--diameter-min": diameter_min,
        "--diameter-max": diameter_max,
        "--length-step": length_step,
        "--life": life,
        "--wear": wear,
        "--growth": growth,
        "--water-density": water_density,
        "--chain": chain,
        "--code": code,
        "--prefer": prefer.value,
        "--sinker": sinker.value,
        "--buoys": buoys,
        "--recalled": recalled,
    }
    check_places(out, save)
    words = Words(lang.value)
    filled = fill(context, options, name if is_file(name) else None, "buoy")
    with filled.telling():
        given = asked_buoy(filled.options, words) if filled.is_sound else filled.options
        request = buoy_request(given, Wishes.among(given))
        found = sized(size_buoy, titled(request, filled)) if filled.is_sound else None
    if found is not None:
        asked = given_to_size(context, filled, given)
        give(context.obj, found, words, as_json=as_json, out=out, save=save, given=asked)


@size.command()
def tanker(
    context: typer.Context,
    file: Annotated[
        str | None,
        typer.Argument(metavar="FILE", help="File (.toml) with what is known; or give options."),
    ] = None,
    length: LengthOption = None,
    breadth: BreadthOption = None,
    draught: Annotated[str | None, measure("--draught", "Draught, loaded.")] = None,
    ballast_draught: Annotated[
        str | None, measure("--ballast-draught", "Draught in ballast; only loaded when left out.")
    ] = None,
    moulded_depth: Annotated[
        str | None, measure("--moulded-depth", "From deck to keel; 1.3 draughts when left out.")
    ] = None,
    dwt: Annotated[
        str | None, measure("--dwt", "Deadweight, to hold against the displacement.")
    ] = None,
    frontal_area: Annotated[
        str | None,
        measure("--frontal-area", "Above water, loaded, from ahead; estimated if left out."),
    ] = None,
    lateral_area: Annotated[
        str | None, measure("--lateral-area", "The same from the side; estimated when left out.")
    ] = None,
    fairlead: Annotated[
        str | None,
        measure("--fairlead", "Bow fairlead over the water, loaded; the deck when left out."),
    ] = None,
    depth: DepthOption = None,
    low_water: LowWaterOption = None,
    wind: WindOption = None,
    current: CurrentOption = None,
    hs: HsOption = None,
    hmax: HmaxOption = None,
    period: PeriodOption = None,
    buoy: Annotated[
        str | None,
        typer.Option(
            metavar="BUOY", help='Mooring buoy with a hawser to the ship: "mooring buoy 5.0 m".'
        ),
    ] = None,
    hawser: Annotated[
        str | None, measure("--hawser", "Length of the hawser to the buoy; 50 m if left out.")
    ] = None,
    lines: Annotated[
        int,
        typer.Option(metavar="N", help="Lines: 1, or 3 and more evenly around buoy or turret."),
    ] = 1,
    pretension: Annotated[
        str,
        measure("--pretension", "Of several lines, as a part of one line's largest force."),
    ] = "10 %",
    anchor: Annotated[
        str,
        typer.Option(metavar="NAME", help='Kind of drag anchor; or "sinker".'),
    ] = "Stevpris Mk5",
    soil: Annotated[
        str | None,
        typer.Option(
            metavar="SOIL",
            help='"sand" when left out; under a sinker "fine or silty sand".',
        ),
    ] = None,
    friction: FrictionOption = None,
    sinker: SinkerOption = Material.CONCRETE,
    sinker_density: SinkerDensityOption = None,
    clump_weight: Annotated[
        list[str] | None,
        measure(
            "--clump-weight",
            "Clump weight on the line, in air, of concrete; several to choose from.",
        ),
    ] = None,
    chain: ChainOption = None,
    diameter_min: DiameterMinOption = None,
    diameter_max: DiameterMaxOption = None,
    length_step: StepOption = None,
    code: CodeOption = None,
    prefer: PreferOption = Preference.BALANCED,
    life: LifeOption = None,
    wear: WearOption = None,
    buoys: BuoysOption = None,
    water_density: DensityOption = "1025 kg/m^3",
    recalled: RecalledOption = False,
    save: SaveOption = None,
    lang: LangOption = ReportLanguage.ENGLISH,
    as_json: JsonOption = False,
    out: OutOption = None,
) -> None:
    """Size the chain and the anchor of a tanker's mooring.

    One line from the bow, one leg from a mooring buoy with a hawser (--buoy), or several lines
    around a buoy or a turret (--lines). The ship lies head to wind, current and waves; what is not
    given is taken or estimated, and the answer says so. What is given as an option goes before
    what a file says.
    """
    from catopt.cli.size_answer import check_places, give, sized
    from catopt.cli.size_file import fill
    from catopt.cli.size_note import given_to_size
    from catopt.cli.size_questions import asked_tanker
    from catopt.cli.size_requests import Wishes, tanker_request, titled
    from catopt.render.texts import Words
    from catopt.sizing import size_tanker

    options = {
        "--length": length,
        "--breadth": breadth,
        "--draught": draught,
        "--ballast-draught": ballast_draught,
        "--moulded-depth": moulded_depth,
        "--dwt": dwt,
        "--frontal-area": frontal_area,
        "--lateral-area": lateral_area,
        "--fairlead": fairlead,
        "--depth": depth,
        "--low-water": low_water,
        "--wind": wind,
        "--current": current,
        "--hs": hs,
        "--hmax": hmax,
        "--period": period,
        "--buoy": buoy,
        "--hawser": hawser,
        "--pretension": pretension,
        "--soil": soil,
        "--friction": friction,
        "--sinker-density": sinker_density,
        "--diameter-min": diameter_min,
        "--diameter-max": diameter_max,
        "--length-step": length_step,
        "--life": life,
        "--wear": wear,
        "--water-density": water_density,
        "--clump-weight": clump_weight,
        "--chain": chain,
        "--code": code,
        "--prefer": prefer.value,
        "--sinker": sinker.value,
        "--buoys": buoys,
        "--recalled": recalled,
        "--anchor": anchor,
        "--lines": lines,
    }
    check_places(out, save)
    words = Words(lang.value)
    filled = fill(context, options, file, "tanker")
    with filled.telling():
        given = asked_tanker(filled.options, words) if filled.is_sound else filled.options
        request = tanker_request(given, Wishes.among(given))
        found = sized(size_tanker, titled(request, filled)) if filled.is_sound else None
    if found is not None:
        asked = given_to_size(context, filled, given)
        give(context.obj, found, words, as_json=as_json, out=out, save=save, given=asked)
