package org.starl.apps.race.logic;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;
import org.starl.geometry.Point;
import org.starl.id.RobotId;
import org.starl.shape.Shape;
import org.starl.shape.WireFormatException;
import org.starl.shape.WireReader;
import org.starl.shape.WireWriter;

class RaceMessagesTest {

  private static final int POINTS = 5;

  private final Shape<RaceMessage> codec = RaceMessage.shape(POINTS);

  @Provide
  Arbitrary<Claim> claims() {
    return Combinators.combine(
            Arbitraries.integers().between(0, POINTS - 1),
            Arbitraries.integers().between(0, 3),
            Arbitraries.longs().between(0, 3),
            Arbitraries.integers().between(0, 2))
        .as((point, robot, atNs, offMm) ->
            new Claim(point, new RobotId("bot" + robot), atNs, offMm));
  }

  private static byte[] bytes(Shape<RaceMessage> codec, RaceMessage message) {
    byte[] buffer = new byte[200];
    WireWriter out = new WireWriter(buffer);
    codec.write(message, out);
    byte[] bytes = new byte[out.length()];
    System.arraycopy(buffer, 0, bytes, 0, bytes.length);
    return bytes;
  }

  @Property
  void aClaimIsReadAsItWasWritten(@ForAll("claims") Claim claim) {
    assertThat(codec.read(new WireReader(bytes(codec, claim)))).isEqualTo(claim);
  }

  @Property
  void theOrderOfClaimsIsTotal(
      @ForAll("claims") Claim a, @ForAll("claims") Claim b, @ForAll("claims") Claim c) {
    assertThat(a.compareTo(b) == 0).isEqualTo(a.equals(b));
    assertThat(Integer.signum(a.compareTo(b))).isEqualTo(-Integer.signum(b.compareTo(a)));
    if (a.compareTo(b) < 0 && b.compareTo(c) < 0) {
      assertThat(a.compareTo(c)).isNegative();
    }
  }

  @Test
  void claimsAreOrderedByReachingThePointThenTimeThenName() {
    RobotId first = new RobotId("bot2");
    RobotId second = new RobotId("bot10");
    assertThat(new Claim(0, second, 9, 0)).isLessThan(new Claim(0, first, 5, 300));
    assertThat(new Claim(0, second, 5, 0)).isLessThan(new Claim(0, first, 9, 0));
    assertThat(new Claim(0, first, 5, 0)).isLessThan(new Claim(0, second, 5, 0));
  }

  @Test
  void aQuestionIsReadAndMalformedMessagesAreRefused() {
    RaceMessage question = new RaceMessage.Question();
    assertThat(codec.read(new WireReader(bytes(codec, question)))).isEqualTo(question);
    assertThatThrownBy(() -> codec.read(new WireReader(new byte[] {7})))
        .isInstanceOf(WireFormatException.class);
    byte[] another = bytes(RaceMessage.shape(9), new Claim(POINTS, new RobotId("bot0"), 1, 0));
    assertThatThrownBy(() -> codec.read(new WireReader(another)))
        .isInstanceOf(WireFormatException.class)
        .hasMessageContaining("point 5 of a race of 5");
  }

  @Test
  void patienceEndsAfterThreeFailedMotionsAndIsRenewedByProgress() {
    RacePoint point = new RacePoint("A", new Point(0, 0), 75);
    Patience patience = new Patience(point, 165);
    assertThat(patience.recordFailedMotion(400)).isFalse();
    assertThat(patience.recordFailedMotion(400)).isFalse();
    assertThat(patience.recordFailedMotion(340)).isFalse();
    assertThat(patience.recordFailedMotion(340)).isFalse();
    assertThat(patience.recordFailedMotion(340)).isTrue();
    Patience far = new Patience(point, 165);
    int tries = 0;
    do {
      tries++;
    } while (!far.recordFailedMotion(2000));
    assertThat(tries).isEqualTo(7);
  }
}
