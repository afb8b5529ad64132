package org.starl.sim;

import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Objects;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;
import org.starl.id.RobotId;
import org.starl.platform.DeploymentKey;
import org.starl.session.KnownStarts;
import org.starl.session.Session;

class SealWatchTest {

  private static final RobotId A = new RobotId("a");
  private static final RobotId B = new RobotId("b");
  private static final DeploymentKey KEY =
      new DeploymentKey("0123456789abcdef0123456789abcdef".getBytes(StandardCharsets.US_ASCII));

  private final SealWatch watch = new SealWatch();

  /** The session of a robot's start with the first start of another robot. */
  private static Session session(SealWatch watch, RobotId self, int start, RobotId peer) {
    KnownStarts sessions =
        new KnownStarts(
            robot -> KEY.pairKey(self, robot), self, start, robot -> 1, () -> List.of(A, B), watch);
    return Objects.requireNonNull(sessions.with(peer));
  }

  private static void seal(Session session, byte[] datagram, int bodyAt) {
    session.seal(datagram, bodyAt, datagram.length, new byte[datagram.length + Session.BYTES]);
  }

  @Property(tries = 50)
  void bothEndsOfEachStartSealAnything(
      @ForAll byte[] text, @ForAll @IntRange(min = 1, max = 20) int transmissions) {
    SealWatch fresh = new SealWatch();
    for (Session session :
        List.of(session(fresh, A, 1, B), session(fresh, A, 2, B), session(fresh, B, 1, A))) {
      for (int i = 0; i < transmissions; i++) {
        seal(session, text, text.length / 3);
      }
    }
  }

  @Test
  void aStartThatIsNumberedAsTheOneBeforeUsesItsKeyAndNoncesAgain() {
    seal(session(watch, A, 1, B), new byte[20], 4);
    Session again = session(watch, A, 1, B);
    // Another text does not hide it.
    byte[] text = {9, 9, 9, 9, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
    assertThatThrownBy(() -> seal(again, text, 4))
        .hasMessage("a key is used twice with one nonce: the datagram with count 1");
  }

  @Test
  void aKeyForBothDirectionsOpensWhatIsSentBack() {
    Session withItself = session(watch, A, 1, A);
    assertThatThrownBy(() -> seal(withItself, new byte[10], 4))
        .hasMessage("a robot would accept its own datagram from another robot");
  }
}
