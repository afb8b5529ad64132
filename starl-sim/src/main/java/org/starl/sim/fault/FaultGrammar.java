package org.starl.sim.fault;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import org.starl.input.BadInput;
import org.starl.input.NearMatches;
import org.starl.input.Quantities;
import org.starl.sim.net.Latency;
import org.starl.sim.world.PositionNoise;
import org.starl.sim.world.Unsynced;

/**
 * The grammar of faults: {@code name(arguments,times)}. The affected robots come first: a name,
 * {@code bot0+bot1}, {@code any} (drawn by seed), {@code half} or {@code all}.
 */
public final class FaultGrammar {

  /** The times of every fault, one line for users. */
  public static final String TIMES =
      "every fault takes at=12s or at=5s..20s (drawn), and for=5s, for=2s..9s or until=30s";

  /**
   * One kind of fault, for users.
   *
   * @param usage its syntax
   * @param meaning one line
   */
  public record Kind(String name, String usage, String meaning) {}

  private record Row(Kind kind, Function<FaultArguments, FaultEffect> reader) {}

  private static final List<Row> ROWS =
      List.of(
          row(
              "crash(WHO,restart=5s,lose=unsynced)",
              "the program crashes; restart: after this time; lose: unsynced, some or nothing",
              call ->
                  new Crash(
                      who(call), call.optional("lose", FaultGrammar::unsynced, Unsynced.LOST))),
          row(
              "loss(0.3,from=WHO,to=WHO)",
              "each copy of a datagram is lost with this probability",
              call -> new NetworkFault.Loss(probability(call), Link.read(call))),
          row(
              "burst(2s,200ms,0.9,from=WHO,to=WHO)",
              "each link is good, then bad, for these mean times; loses copies while bad",
              call ->
                  new NetworkFault.Burst(
                      call.next("the mean good time", FaultGrammar::positiveNs),
                      call.next("the mean bad time", FaultGrammar::positiveNs),
                      call.nextOr("the loss while bad", Quantities::probability, 1.0),
                      Link.read(call))),
          row(
              "delay(uniform(10ms,200ms),from=WHO,to=WHO)",
              "each copy gets this additional delay",
              call ->
                  new NetworkFault.Delay(call.next("a delay", Latency::parse), Link.read(call))),
          row(
              "duplicate(0.1,50ms,from=WHO,to=WHO)",
              "a copy arrives twice with this probability, the second up to this much later",
              call ->
                  new NetworkFault.Duplicate(
                      probability(call),
                      call.nextOr(
                          "how much later",
                          Quantities::durationNs,
                          NetworkFault.Duplicate.USUAL_NS),
                      Link.read(call))),
          row(
              "reorder(0.2,100ms,from=WHO,to=WHO)",
              "a copy is delayed with this probability, by up to this time",
              call ->
                  new NetworkFault.Reorder(
                      probability(call),
                      call.next("how long it is held back", Quantities::durationNs),
                      Link.read(call))),
          row(
              "partition(bot0+bot1|bot2)",
              "groups hear only their own members; also bot0>bot1 (one way), area=rect(0,0,2m,1m),"
                  + " area=circle(0,0,2m)",
              FaultGrammar::partition),
          row(
              "range(3m)",
              "the radio range, between centres",
              call -> new ConnectivityFault.Range(call.next("a distance", Quantities::distanceMm))),
          row(
              "sight",
              "datagrams need a line of sight, free of walls and bodies",
              call -> new ConnectivityFault.Sight()),
          row("stuck(WHO)", "the wheels do not turn", call -> new RobotFault.Stuck(who(call))),
          row(
              "slow(WHO,0.5)",
              "the wheels turn at this fraction of the commanded speed",
              call ->
                  new RobotFault.Slow(who(call), call.next("a fraction", Quantities::probability))),
          row(
              "noise(WHO,30mm,3deg)",
              "fixes have this additional error, and report it in their bound",
              call -> new RobotFault.Noise(who(call), noise(call))),
          row("dropout(WHO)", "no fixes come", call -> new RobotFault.Dropout(who(call))),
          row(
              "jump(WHO,300mm)",
              "fixes are shifted this far, and do not report it",
              call -> new RobotFault.Jump(who(call), call.next("how far", Quantities::distanceMm))),
          row(
              "compute(WHO,20ms)",
              "each action takes this time, and the next one waits",
              call ->
                  new RobotFault.Compute(
                      who(call), call.next("the time of an action", Quantities::durationNs))),
          row(
              "drift(WHO,200ppm)",
              "the clock is too fast by this rate, or too slow: -200ppm",
              call -> new RobotFault.Drift(who(call), call.next("a drift", FaultGrammar::ppm))),
          row(
              "skew(WHO,50ms)",
              "the clock is ahead by this time, or behind: -50ms",
              call -> new RobotFault.Skew(who(call), call.next("a skew", FaultGrammar::signedNs))),
          row(
              "disk(WHO,50ms)",
              "writes to stable storage survive a crash only after this additional time",
              call ->
                  new RobotFault.Disk(
                      who(call), call.next("the time of a write", Quantities::durationNs))),
          row(
              "ram(WHO,300mm/s)",
              "a foreign body drives into the robot again and again",
              call ->
                  new IntruderFault.Ram(
                      who(call),
                      call.nextOr(
                          "a speed",
                          FaultGrammar::positiveSpeed,
                          IntruderFault.Ram.USUAL_MM_PER_S))),
          row(
              "block(WHO)",
              "a foreign body parks in front of the robot",
              call -> new IntruderFault.Block(who(call))),
          row(
              "forge(WHO,100ms)",
              "an attacker without the key sends changed recordings, at this mean interval",
              call -> new AttackFault.Forge(who(call), meanTime(call))),
          row(
              "replay(WHO,100ms)",
              "an attacker without the key sends old recordings, at this mean interval",
              call -> new AttackFault.Replay(who(call), meanTime(call))),
          row(
              "flood(WHO,1ms)",
              "an attacker without the key sends random bytes, at this mean interval",
              call -> new AttackFault.Flood(who(call), meanTime(call))));

  private FaultGrammar() {}

  /** Every kind of fault, in display order. */
  public static List<Kind> kinds() {
    return ROWS.stream().map(Row::kind).toList();
  }

  /**
   * Reads one fault.
   *
   * @throws BadInput if the text is not a fault; the message has the text, the argument and what
   *     was expected
   */
  public static Fault parse(String text) {
    FaultArguments call = FaultArguments.parse(text);
    Row row = rowOf(call);
    call.usage(row.kind.usage());
    FaultEffect harm = row.reader.apply(call);
    Span span = Span.read(call, harm.lastingKey());
    call.end();
    return new Fault(harm, span);
  }

  private static Row rowOf(FaultArguments call) {
    List<String> names = new ArrayList<>();
    for (Row row : ROWS) {
      if (row.kind.name().equals(call.name())) {
        return row;
      }
      names.add(row.kind.name());
    }
    throw call.bad(
        "no fault is called " + BadInput.quote(call.name()) + NearMatches.hint(call.name(), names));
  }

  private static Row row(
      String usage, String meaning, Function<FaultArguments, FaultEffect> reader) {
    int open = usage.indexOf('(');
    String name = open < 0 ? usage : usage.substring(0, open);
    return new Row(new Kind(name, usage, meaning), reader);
  }

  private static RobotSelector who(FaultArguments call) {
    return call.next(RobotSelector.EXPECTED, RobotSelector::parse);
  }

  private static long meanTime(FaultArguments call) {
    return call.next("the mean interval", FaultGrammar::positiveNs);
  }

  private static double probability(FaultArguments call) {
    return call.next("a probability", Quantities::probability);
  }

  private static PositionNoise noise(FaultArguments call) {
    double mm = call.next("how far", Quantities::distanceMm);
    double rad = call.nextOr("an angle", Quantities::angleRad, 0.0);
    if (rad > StrictMath.PI) {
      throw call.bad("expected an angle of at most 180deg");
    }
    return new PositionNoise(mm, rad);
  }

  private static FaultEffect partition(FaultArguments call) {
    String area = call.keyed("area");
    if (area != null) {
      return new ConnectivityFault.Area(call.value("area", area, AreaText::parse));
    }
    String groups = call.next("groups of robots", text -> text);
    List<String> sides = call.split(groups, '>');
    if (sides.size() == 2) {
      return new ConnectivityFault.OneWay(
          call.value("from", sides.get(0), RobotSelector::parse),
          call.value("to", sides.get(1), RobotSelector::parse));
    }
    if (sides.size() > 2) {
      throw call.bad("expected one '>' at most");
    }
    List<RobotSelector> parts = new ArrayList<>();
    for (String part : call.split(groups, '|')) {
      parts.add(call.value("group", part, RobotSelector::parse));
    }
    return new ConnectivityFault.Groups(parts);
  }

  private static Unsynced unsynced(String text) {
    return switch (text) {
      case "unsynced" -> Unsynced.LOST;
      case "some" -> Unsynced.SOME;
      case "nothing" -> Unsynced.KEPT;
      default -> throw new BadInput(BadInput.quote(text) + ": expected unsynced, some or nothing");
    };
  }

  private static long ppm(String text) {
    String number = text.endsWith("ppm") ? text.substring(0, text.length() - 3) : "";
    try {
      return Quantities.whole(number, -RobotFault.Drift.MOST_PPM, RobotFault.Drift.MOST_PPM);
    } catch (BadInput wrong) {
      throw new BadInput(
          BadInput.quote(text) + ": expected -500000ppm to 500000ppm, such as 200ppm");
    }
  }

  private static long signedNs(String text) {
    return text.startsWith("-")
        ? -Quantities.durationNs(text.substring(1))
        : Quantities.durationNs(text);
  }

  private static long positiveNs(String text) {
    long ns = Quantities.durationNs(text);
    if (ns == 0) {
      throw new BadInput(BadInput.quote(text) + ": expected a duration above 0");
    }
    return ns;
  }

  private static double positiveSpeed(String text) {
    double mmPerS = Quantities.speedMmPerS(text);
    if (mmPerS == 0) {
      throw new BadInput(BadInput.quote(text) + ": expected a speed above 0");
    }
    return mmPerS;
  }
}
