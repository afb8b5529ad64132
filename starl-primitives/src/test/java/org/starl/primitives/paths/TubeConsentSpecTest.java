package org.starl.primitives.paths;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.starl.geometry.Point;
import org.starl.id.RobotId;
import org.starl.spec.Monitors;
import org.starl.trace.Instance;
import org.starl.trace.TraceEvent.Delivered;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Sent;
import org.starl.trace.TraceEvent.Variable;

/** Claims written by hand, among the robots a and b: both are a majority. */
class TubeConsentSpecTest {

  private static final Instance X = Instance.of(TubeFact.PRIMITIVE, "x");
  private static final RobotId A = new RobotId("a");
  private static final RobotId B = new RobotId("b");
  private static final Tube HERE = tube(0, 0, 1000, 0);
  private static final Tube CROSSING = tube(500, -500, 500, 500);
  private static final Tube FAR = tube(0, 5000, 1000, 5000);

  private final Monitors monitors = new Monitors(List.of(new TubeConsentSpec()));

  @Test
  void aTubeWithTheConsentOfAllIsHeldAndGivenBackInParts() {
    asks(A, new Holding(1, List.of(), List.of(HERE)));
    votes(A, A, 1);
    votes(B, A, 1);
    holds(A, HERE);
    holds(A, HERE.from(1));
    assertThat(monitors.report().holds()).isTrue();
    assertThat(monitors.report().neverChecked()).isEmpty();
  }

  @Test
  void aTubeWithTheConsentOfHalfViolatesClaimed() {
    asks(A, new Holding(1, List.of(), List.of(HERE)));
    votes(A, A, 1);
    votes(B, A, 0);
    holds(A, HERE);
    assertThat(monitors.report().violations(TubeConsentSpec.CLAIMED)).isEqualTo(1);
  }

  @Test
  void aTubeThatIsHeldAgainAfterARestartViolatesClaimed() {
    aTubeWithTheConsentOfAllIsHeldAndGivenBackInParts();
    asks(A, new Holding(2, List.of(HERE.from(1)), List.of(FAR)));
    holds(A, HERE);
    assertThat(monitors.report().violations(TubeConsentSpec.CLAIMED)).isEqualTo(1);
  }

  @Test
  void consentsToTwoTubesThatMeetViolateConsents() {
    asks(A, new Holding(1, List.of(), List.of(HERE)));
    votes(B, A, 1);
    asks(B, new Holding(1, List.of(), List.of(CROSSING)));
    votes(B, B, 1);
    assertThat(monitors.report().violations(TubeConsentSpec.CONSENTS)).isEqualTo(1);
  }

  @Test
  void aVoterMayForgetATubeThatItsRobotHasGivenUp() {
    asks(A, new Holding(1, List.of(), List.of(HERE)));
    votes(B, A, 1);
    asks(A, new Holding(2, List.of(), List.of(FAR)));
    asks(B, new Holding(1, List.of(), List.of(CROSSING)));
    votes(B, B, 1);
    assertThat(monitors.report().violations()).isEmpty();
  }

  @Test
  void aConsentMayBeRepeatedAfterAnotherRobotHoldsPartOfTheTube() {
    asks(A, new Holding(1, List.of(), List.of(HERE)));
    votes(B, A, 1);
    // The others knew that A has given up.
    asks(B, new Holding(1, List.of(CROSSING), List.of()));
    votes(B, B, 1);
    votes(B, A, 1);
    assertThat(monitors.report().violations()).isEmpty();
  }

  @Test
  void aRobotThatGivesBackItsLastTubeViolatesClaimed() {
    asks(A, new Holding(1, List.of(), List.of(HERE)));
    votes(A, A, 1);
    votes(B, A, 1);
    holds(A, HERE);
    asks(A, new Holding(2, List.of(HERE), List.of(FAR)));
    votes(A, A, 2);
    votes(B, A, 2);
    holds(A, HERE, FAR);
    assertThat(monitors.report().holds()).isTrue();
    holds(A);
    assertThat(monitors.report().violations(TubeConsentSpec.CLAIMED)).isEqualTo(1);
  }

  @Test
  void aRestartedRobotThatDoesNotTellOfItsTubesViolatesClaimed() {
    aTubeWithTheConsentOfAllIsHeldAndGivenBackInParts();
    monitors.observe(new Fault(0, A, Fault.CRASH, ""));
    holds(A, HERE.from(1));
    TubeMessage ask = new TubeMessage.Ask(new Holding(9, List.of(HERE.from(1)), List.of()));
    monitors.observe(sends(2_000_000_000L, A, B, ask));
    assertThat(monitors.report().violations(TubeConsentSpec.CLAIMED)).isEqualTo(1);
  }

  @Test
  void aRestartedRobotThatTellsOfItsTubesAtOnceSatisfiesClaimed() {
    aTubeWithTheConsentOfAllIsHeldAndGivenBackInParts();
    monitors.observe(new Fault(0, A, Fault.CRASH, ""));
    holds(A, HERE.from(1));
    asks(A, new Holding(9, List.of(HERE.from(1)), List.of()));
    holds(A, HERE.from(1));
    assertThat(monitors.report().violations()).isEmpty();
  }

  @Test
  void aVoterThatForgetsItsConsentViolatesConsentsByARefusal() {
    asks(A, new Holding(1, List.of(), List.of(HERE)));
    votes(B, A, 1);
    monitors.observe(sends(0, B, B, new TubeMessage.Refuse(1, A, Holding.NONE)));
    assertThat(monitors.report().violations(TubeConsentSpec.CONSENTS)).isEqualTo(1);
  }

  @Test
  void aClaimThatIsGivenUpWithoutARefusalViolatesClaimed() {
    asks(A, new Holding(1, List.of(HERE), List.of(CROSSING)));
    claims(TubeFlag.CLAIMING);
    monitors.observe(sends(0, B, A, new TubeMessage.Refuse(1, B, Holding.NONE)));
    claims(TubeFlag.PLANNING);
    assertThat(monitors.report().violations()).isEmpty();
    asks(A, new Holding(2, List.of(HERE), List.of(FAR)));
    claims(TubeFlag.CLAIMING);
    monitors.observe(sends(0, B, A, new TubeMessage.Refuse(1, B, Holding.NONE)));
    claims(TubeFlag.PLANNING);
    assertThat(monitors.report().violations(TubeConsentSpec.CLAIMED)).isEqualTo(1);
  }

  private void claims(TubeFlag flag) {
    monitors.observe(new Variable(0, A, X, TubeFact.FLAG, flag));
  }

  private static Tube tube(double x1, double y1, double x2, double y2) {
    return new Tube(List.of(new Point(x1, y1), new Point(x2, y2)), 300);
  }

  /** Sends a request to both robots, which receive it. */
  private void asks(RobotId robot, Holding holding) {
    TubeMessage ask = new TubeMessage.Ask(holding);
    for (RobotId to : List.of(A, B)) {
      monitors.observe(sends(0, robot, to, ask));
      monitors.observe(new Delivered(0, to, robot, X, 1, TubeMessage.SHAPE, ask));
    }
  }

  private void votes(RobotId voter, RobotId to, long version) {
    monitors.observe(sends(0, voter, to, new TubeMessage.Vote(version)));
  }

  private static Sent sends(long timeNs, RobotId robot, RobotId to, TubeMessage message) {
    return new Sent(timeNs, robot, to.name(), X, 1, 1, TubeMessage.SHAPE, message);
  }

  private void holds(RobotId robot, Tube... tubes) {
    TubeList held = new TubeList(List.of(tubes));
    monitors.observe(new Variable(0, robot, X, TubeFact.HELD, held));
  }
}
