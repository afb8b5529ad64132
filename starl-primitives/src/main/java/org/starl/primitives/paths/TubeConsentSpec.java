package org.starl.primitives.paths;

import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.starl.id.RobotId;
import org.starl.spec.InstanceMonitor;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Delivered;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Sent;
import org.starl.trace.TraceEvent.Variable;

/**
 * The rules of claims, on the messages and tubes of every robot: a broken rule is seen long before
 * two robots hold tubes that meet. A restart changes nothing: a robot keeps what it has said.
 *
 * <ul>
 *   <li>{@code Consents}: a robot consents to no tube that meets one of another robot to which it has
 *       consented, unless that robot has told it of newer tubes. A refusal names no older ones.
 *   <li>{@code Claimed}: a new tube is held after the consent of a majority; other changes, those of a
 *       restart too, only give parts back, and not the last one. A restarted robot tells the others
 *       what it still holds. A claim is given up as refused only when no majority can consent.
 * </ul>
 *
 * <p>{@code Claimed} is not checked of runs in real time, since the end of a killed process's trace
 * may be missing, nor of traces without messages.
 */
final class TubeConsentSpec extends InstanceMonitor<TubeConsentSpec.Claims> {

  static final String CONSENTS = "tubes.Consents";
  static final String CLAIMED = "tubes.Claimed";

  private static final long NONE = -1;

  /** The time within which a restarted robot tells of its tubes. */
  private static final long TELL_NS = 1_000_000_000;

  private boolean isRealTime;

  TubeConsentSpec() {
    super(TubeFact.PRIMITIVE);
    lemma(CONSENTS, "A robot consents to no two tubes of different robots that meet.");
    lemma(CLAIMED, "A new tube is held after the consent of a majority.");
  }

  /** The claims of one instance. */
  static final class Claims {
    private final Set<String> participants = new TreeSet<>();
    private final Map<RobotId, Claimant> claimants = new TreeMap<>();
    // By voter: the latest tubes of each robot that it has heard of and consented to.
    private final Map<RobotId, SortedMap<RobotId, Holding>> heard = new TreeMap<>();
    private final Map<RobotId, SortedMap<RobotId, Holding>> consents = new TreeMap<>();

    private Claimant claimant(RobotId robot) {
      return claimants.computeIfAbsent(robot, any -> new Claimant());
    }
  }

  /** One robot: its held tubes, its latest request, and who has consented to that. */
  private static final class Claimant {
    private List<Tube> held = List.of();
    private @Nullable Holding asked;
    private final Set<RobotId> votes = new TreeSet<>();
    private final Set<RobotId> refusals = new TreeSet<>();
    private @Nullable TubeFlag flag;

    // Whether it has held a second tube: then a tube survives a crash.
    private boolean hasSettled;
    private boolean hasCrashed;

    // When it began to hold tubes from before a restart; the others do not know it yet.
    private long untoldNs = NONE;

    private void onCrash() {
      hasCrashed = true;
      flag = null;
      untoldNs = NONE;
    }
  }

  @Override
  protected Claims begin(Instance source) {
    return new Claims();
  }

  @Override
  protected void changed(Variable variable, Report report) {
    TubeList held = variable.of(TubeFact.HELD);
    if (held != null) {
      Claims all = instance(variable.source());
      Claimant claimant = all.claimant(variable.robot());
      List<Tube> now = held.tubes();
      if (!isRealTime && !all.participants.isEmpty()) {
        checkClaimed(variable, all, claimant, now, report);
        checkTold(claimant, variable.robot(), variable.timeNs(), report);
      }
      claimant.hasSettled |= now.size() > 1;
      claimant.held = now;
      if (claimant.hasCrashed && !now.isEmpty()) {
        claimant.untoldNs = variable.timeNs();
      }
      claimant.hasCrashed = false;
    }
    TubeFlag flag = variable.of(TubeFact.FLAG);
    if (flag != null) {
      Claims all = instance(variable.source());
      Claimant claimant = all.claimant(variable.robot());
      boolean isRefused = claimant.flag == TubeFlag.CLAIMING && flag == TubeFlag.PLANNING;
      int others = all.participants.size() - claimant.refusals.size();
      if (isRefused && !isRealTime && 2 * others > all.participants.size()) {
        String detail = "gives up its claim, refused only by " + claimant.refusals;
        report.violated(CLAIMED, variable.timeNs(), List.of(variable.robot()), detail);
      }
      claimant.flag = flag;
    }
  }

  private static void checkClaimed(
      Variable variable, Claims all, Claimant claimant, List<Tube> now, Report report) {
    report.checked(CLAIMED);
    for (Tube tube : now) {
      boolean isGranted =
          claimant.asked != null
              && claimant.asked.wanted().contains(tube)
              && 2 * claimant.votes.size() > all.participants.size();
      if (!isGranted && claimant.held.stream().noneMatch(before -> isPartOf(tube, before))) {
        String detail =
            ("holds " + tube + " after " + Tube.text(claimant.held))
                + (", with the consent of " + claimant.votes);
        report.violated(CLAIMED, variable.timeNs(), List.of(variable.robot()), detail);
      }
    }
    if (now.isEmpty() && claimant.hasSettled) {
      String detail = "holds no tube any more, after " + Tube.text(claimant.held);
      report.violated(CLAIMED, variable.timeNs(), List.of(variable.robot()), detail);
    }
  }

  private static void checkTold(Claimant claimant, RobotId robot, long nowNs, Report report) {
    if (claimant.untoldNs != NONE && nowNs > claimant.untoldNs + TELL_NS) {
      String detail = "has not told of the tubes that it still holds after a restart";
      report.violated(CLAIMED, nowNs, List.of(robot), detail);
    }
    claimant.untoldNs = NONE;
  }

  /** Whether it has legs of the other one alone. */
  private static boolean isPartOf(Tube tube, Tube before) {
    return tube.radiusMm() == before.radiusMm()
        && Collections.indexOfSubList(before.points(), tube.points()) >= 0;
  }

  @Override
  protected void happened(TraceEvent event, Report report) {
    switch (event) {
      case Sent sent when sent.message() instanceof TubeMessage message ->
          sent(sent, message, report);
      case Delivered delivered when delivered.message() instanceof TubeMessage.Ask ask ->
          delivered(delivered, ask.holding());
      case Fault fault -> {
        isRealTime |= fault.isRealTime();
        if (fault.name().equals(Fault.CRASH)) {
          instances().values().forEach(all -> all.claimant(fault.robot()).onCrash());
        }
      }
      default -> {}
    }
  }

  private void sent(Sent sent, TubeMessage message, Report report) {
    Claims all = instance(sent.channel());
    switch (message) {
      case TubeMessage.Ask ask -> asked(sent, ask.holding(), all, report);
      case TubeMessage.Vote vote -> voted(sent, vote.version(), all, report);
      case TubeMessage.Refuse refusal -> refused(sent, refusal, all, report);
    }
  }

  private static void asked(Sent sent, Holding asked, Claims all, Report report) {
    all.participants.add(sent.to());
    Claimant claimant = all.claimant(sent.robot());
    checkTold(claimant, sent.robot(), sent.timeNs(), report);
    if (!asked.equals(claimant.asked) && !asked.wanted().isEmpty()) {
      claimant.asked = asked;
      claimant.votes.clear();
      claimant.refusals.clear();
    }
  }

  private static void refused(Sent sent, TubeMessage.Refuse refusal, Claims all, Report report) {
    Claimant claimant = all.claimant(new RobotId(sent.to()));
    if (claimant.asked != null && claimant.asked.version() == refusal.version()) {
      claimant.refusals.add(sent.robot());
    }
    RobotId who = refusal.who();
    Holding known = byVoter(all.consents, sent.robot()).get(who);
    report.checked(CONSENTS);
    if (known != null && refusal.theirs().version() < known.version()) {
      String detail = "has forgotten its consent to " + Tube.text(known.all()) + " of " + who;
      report.violated(CONSENTS, sent.timeNs(), List.of(sent.robot()), detail);
    }
  }

  private static void voted(Sent sent, long version, Claims all, Report report) {
    RobotId to = new RobotId(sent.to());
    Claimant claimant = all.claimant(to);
    if (claimant.asked != null && claimant.asked.version() == version) {
      claimant.votes.add(sent.robot());
    }
    Holding theirs = byVoter(all.heard, sent.robot()).get(to);
    if (theirs == null || theirs.version() != version) {
      return;
    }
    SortedMap<RobotId, Holding> consents = byVoter(all.consents, sent.robot());
    report.checked(CONSENTS);
    if (theirs.equals(consents.get(to))) {
      // Said again, perhaps after others, who knew more, have let another robot hold a part of it.
      return;
    }
    consents.forEach((other, holding) -> {
      if (!other.equals(to) && Tube.meet(theirs.wanted(), holding.all())) {
        String detail =
            ("consents to " + Tube.text(theirs.wanted()) + " of " + to)
                + (", and had consented to " + Tube.text(holding.all()) + " of " + other);
        report.violated(CONSENTS, sent.timeNs(), List.of(sent.robot()), detail);
      }
    });
    consents.put(to, theirs);
  }

  private void delivered(Delivered delivered, Holding holding) {
    Claims all = instance(delivered.channel());
    SortedMap<RobotId, Holding> heard = byVoter(all.heard, delivered.robot());
    Holding before = heard.get(delivered.from());
    if (before == null || before.version() < holding.version()) {
      heard.put(delivered.from(), holding);
      byVoter(all.consents, delivered.robot()).remove(delivered.from());
    }
  }

  private static SortedMap<RobotId, Holding> byVoter(
      Map<RobotId, SortedMap<RobotId, Holding>> all, RobotId voter) {
    return all.computeIfAbsent(voter, any -> new TreeMap<>());
  }
}
