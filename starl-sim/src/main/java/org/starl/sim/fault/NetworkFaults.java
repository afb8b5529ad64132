package org.starl.sim.fault;

import static org.starl.sim.fault.ArgumentType.DURATION;
import static org.starl.sim.fault.ArgumentType.POSITIVE_DURATION;
import static org.starl.sim.fault.ArgumentType.PROBABILITY;
import static org.starl.sim.fault.FaultGrammar.Row.row;

import java.util.ArrayList;
import java.util.List;
import java.util.function.LongFunction;
import java.util.stream.Collectors;
import org.starl.geometry.Region;
import org.starl.id.RobotId;
import org.starl.input.BadInput;
import org.starl.random.Rng;
import org.starl.sim.net.Latency;
import org.starl.sim.net.Partition;
import org.starl.sim.net.Verdict;
import org.starl.sim.world.Body;
import org.starl.time.Time;

/** The faults of the radio network. Several act together. */
final class NetworkFaults {

  static final List<FaultGrammar.Row> ROWS =
      List.of(
          row(
              "loss(0.3,from=WHO,to=WHO)",
              "each copy of a datagram is lost with this probability",
              NetworkFaults::loss),
          row(
              "burst(2s,200ms,0.9,from=WHO,to=WHO)",
              "each link is good, then bad, for these mean times; loses copies while bad",
              NetworkFaults::burst),
          row(
              "delay(uniform(10ms,200ms),from=WHO,to=WHO)",
              "each copy gets this additional delay",
              NetworkFaults::delay),
          row(
              "duplicate(0.1,50ms,from=WHO,to=WHO)",
              "a copy arrives twice with this probability, the second up to this much later",
              NetworkFaults::duplicate),
          row(
              "reorder(0.2,100ms,from=WHO,to=WHO)",
              "a copy is delayed with this probability, by up to this time",
              NetworkFaults::reorder),
          row(
              "partition(bot0+bot1|bot2)",
              "groups hear only their own members; also bot0>bot1 (one way), area=rect(0,0,2m,1m),"
                  + " area=circle(0,0,2m)",
              NetworkFaults::partition),
          row(
              "datagram(bot0>bot1,17,30ms)",
              "the copy to bot1 of bot0's datagram number 17, counted from 0, takes exactly this"
                  + " time; 'lost' instead of a time: it does not arrive",
              NetworkFaults::datagram),
          row("range(3m)", "the radio range, between centres", NetworkFaults::range),
          row(
              "sight",
              "datagrams need a line of sight, free of walls and bodies",
              call ->
                  betweenBodies("sight", (context, a, b) -> context.target().world().sees(a, b))));

  private static final long USUAL_DUPLICATE_NS = 50 * Time.NS_PER_MS;

  private NetworkFaults() {}

  private static FaultAction loss(FaultArguments call) {
    double probability = probability(call);
    Verdict lost = Verdict.drop("loss");
    return Link.rule(
        call,
        (context, salt) ->
            copy -> copy.rng().fork(salt).nextBoolean(probability) ? lost : Verdict.PASS);
  }

  private static FaultAction burst(FaultArguments call) {
    long goodNs = call.next("the mean good time", POSITIVE_DURATION);
    long badNs = call.next("the mean bad time", POSITIVE_DURATION);
    double loss = call.nextOr("the loss while bad", PROBABILITY, 1.0);
    return Link.rule(
        call,
        (context, salt) ->
            new BurstRule(
                goodNs, badNs, loss, context.target().nowNs(), context.rng().fork("links")));
  }

  private static FaultAction delay(FaultArguments call) {
    Latency more = call.next("a delay", ArgumentType.LATENCY);
    return Link.rule(
        call, (context, salt) -> copy -> Verdict.later(more.drawNs(copy.rng().fork(salt))));
  }

  private static FaultAction duplicate(FaultArguments call) {
    double probability = probability(call);
    long mostNs = call.nextOr("how much later", DURATION, USUAL_DUPLICATE_NS);
    return sometimes(call, probability, mostNs, Verdict::again);
  }

  private static FaultAction reorder(FaultArguments call) {
    double probability = probability(call);
    long mostNs = call.next("how long it is held back", DURATION);
    return sometimes(call, probability, mostNs, Verdict::later);
  }

  /** With this probability, the verdict of a time up to {@code mostNs}. */
  private static FaultAction sometimes(
      FaultArguments call, double probability, long mostNs, LongFunction<Verdict> verdict) {
    return Link.rule(
        call,
        (context, salt) ->
            copy -> {
              Rng rng = copy.rng().fork(salt);
              return rng.nextBoolean(probability)
                  ? verdict.apply(rng.nextLong(0, mostNs))
                  : Verdict.PASS;
            });
  }

  private static FaultAction datagram(FaultArguments call) {
    String link = call.nextText("two robots");
    List<String> ends = call.split(link, '>');
    if (ends.size() != 2) {
      throw call.bad(BadInput.quote(link) + ": expected a sender and a recipient, as in bot0>bot1");
    }
    RobotSelector from = call.read("from", ends.get(0), ArgumentType.ROBOTS);
    RobotSelector to = call.read("to", ends.get(1), ArgumentType.ROBOTS);
    call.write(from + ">" + to);
    long number = call.next("the number of a datagram", ArgumentType.COUNT);
    Verdict fate = call.next("a duration, or 'lost'", ArgumentType.FATE);
    return context -> {
      context
          .target()
          .network()
          .install(copy ->
              copy.datagram() == number
                      && from.named().contains(copy.from())
                      && to.named().contains(copy.to())
                  ? fate
                  : Verdict.PASS);
      // It decides one copy, and cannot end before.
      return () -> {};
    };
  }

  private static FaultAction range(FaultArguments call) {
    double mostMm = call.next("a distance", ArgumentType.DISTANCE);
    return betweenBodies(
        "range", (context, a, b) -> a.pose().at().distanceMm(b.pose().at()) <= mostMm);
  }

  private static FaultAction partition(FaultArguments call) {
    String areaText = call.keyed("area");
    if (areaText != null) {
      // Separates robots inside the area from robots outside it.
      Region area = call.read("area", areaText, ArgumentType.AREA);
      call.write("area=" + ArgumentType.AREA.writer().apply(area));
      return betweenBodies(
          "partition",
          (context, a, b) -> area.contains(a.pose().at()) == area.contains(b.pose().at()));
    }
    String text = call.nextText("groups of robots");
    List<String> sides = call.split(text, '>');
    if (sides.size() > 2) {
      throw call.bad("expected one '>' at most");
    }
    return sides.size() == 2 ? oneWay(call, sides) : groups(call, call.split(text, '|'));
  }

  private static FaultAction oneWay(FaultArguments call, List<String> sides) {
    RobotSelector from = call.read("from", sides.get(0), ArgumentType.ROBOTS);
    RobotSelector to = call.read("to", sides.get(1), ArgumentType.ROBOTS);
    call.write(from + ">" + to);
    return Link.install(context ->
        Partition.oneWay(
            from.pick(context.target(), context.rng().fork("from")),
            to.pick(context.target(), context.rng().fork("to"))));
  }

  /** All robots outside the groups form one more group. */
  private static FaultAction groups(FaultArguments call, List<String> texts) {
    List<RobotSelector> groups = new ArrayList<>();
    for (String text : texts) {
      groups.add(call.read("group", text, ArgumentType.ROBOTS));
    }
    call.write(groups.stream().map(RobotSelector::toString).collect(Collectors.joining("|")));
    return Link.install(context -> {
      List<List<RobotId>> robots = new ArrayList<>();
      for (int i = 0; i < groups.size(); i++) {
        robots.add(groups.get(i).pick(context.target(), context.rng().fork("group" + i)));
      }
      return Partition.of(robots);
    });
  }

  private static double probability(FaultArguments call) {
    return call.next("a probability", PROBABILITY);
  }

  /** Whether datagrams pass between two bodies. */
  private interface Connectivity {
    boolean passes(FaultContext context, Body from, Body to);
  }

  /** Drops copies that do not pass; robots off the floor have no position. */
  private static FaultAction betweenBodies(String why, Connectivity connectivity) {
    Verdict cut = Verdict.drop(why);
    return Link.install(context ->
        copy -> {
          Body from = context.target().body(copy.from());
          Body to = context.target().body(copy.to());
          return from == null || to == null || connectivity.passes(context, from, to)
              ? Verdict.PASS
              : cut;
        });
  }
}
