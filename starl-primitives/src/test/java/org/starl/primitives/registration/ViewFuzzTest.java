package org.starl.primitives.registration;

import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import org.starl.id.ProcessId;
import org.starl.id.RobotId;
import org.starl.primitives.OneSpelling;
import org.starl.primitives.agreement.Value;
import org.starl.primitives.membership.Confinement;
import org.starl.primitives.membership.Sections;
import org.starl.primitives.membership.View;
import org.starl.shape.WireFormatException;
import org.starl.shape.WireReader;
import org.starl.sim.check.MalformedBytes;

/** Any bytes as a view, and as a change of one. */
public class ViewFuzzTest {

  private static final long NUMBER = 12;

  public static void fuzzerTestOneInput(byte[] input) {
    OneSpelling.require(
        in -> ViewFormat.read(NUMBER, value(in)), view -> ViewFormat.toValue(view).bytes(), input);
    // A change is written as far as it fits: one that is longer than any is not.
    if (input.length <= 350) {
      OneSpelling.require(
          in -> Change.fromValue(value(in)), change -> change.toValue().bytes(), input);
    }
  }

  private static Value value(WireReader in) {
    byte[] all = new byte[in.remaining()];
    for (int i = 0; i < all.length; i++) {
      all[i] = (byte) in.u8();
    }
    if (all.length > Value.MAX_BYTES) {
      throw new WireFormatException("too long");
    }
    return Value.of(all);
  }

  /** Entries in any order were read all the same. */
  @Test
  void aViewInAnotherOrderIsRefused() {
    String hex =
        "020002036f6e650000000000d4000100000000000000010347776f0000000100000000000000000000000c00010574"
            + "687265650000000000000005000000000000000302014103423a31";
    WireReader in = new WireReader(HexFormat.of().parseHex(hex));

    assertThatThrownBy(() -> ViewFormat.read(NUMBER, value(in)))
        .isInstanceOf(WireFormatException.class);
  }

  @Test
  void equalViewsHaveEqualBytes() {
    ProcessId one = ProcessId.first(new RobotId("one"), 1);
    ProcessId two = new ProcessId(new RobotId("two"), 1L << 32);
    ProcessId three = ProcessId.first(new RobotId("three"), 5);
    var sections = Sections.copyOf(List.of("A", "B:1"));
    View view =
        new View(
            NUMBER,
            new TreeMap<>(Map.of(one, 1L, two, 12L)),
            new TreeMap<>(Map.of(three, new View.Ghost(3, sections))));
    Change change =
        new Change(
            one,
            List.of(two),
            List.of(new Confinement(three, sections, new TreeSet<>(List.of(one, two)))));
    List<byte[]> samples = new ArrayList<>();
    samples.add(ViewFormat.toValue(view).bytes());
    samples.add(ViewFormat.toValue(View.NONE).bytes());
    samples.add(change.toValue().bytes());
    samples.add(Change.NONE.toValue().bytes());

    MalformedBytes.feed(samples, ViewFuzzTest::fuzzerTestOneInput);
  }
}
