package org.starl.comms;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.starl.id.RobotId;
import org.starl.session.Session;
import org.starl.shape.WireReader;
import org.starl.shape.WireWriter;
import org.starl.testing.FakeWorld;

/** {@code docs/wire-format.md} says what the code does. */
class WireFormatDocTest {

  private static final class Text implements Codec<String> {
    @Override
    public void write(String message, WireWriter out) {
      out.string(message);
    }

    @Override
    public String read(WireReader in) {
      return in.string();
    }
  }

  private final String doc = read();

  private static String read() {
    Path folder = Path.of("").toAbsolutePath();
    while (!Files.exists(folder.resolve("docs/wire-format.md"))) {
      folder = folder.getParent();
      assertThat(folder).as("a folder above with docs/wire-format.md").isNotNull();
    }
    try {
      return Files.readString(folder.resolve("docs/wire-format.md"));
    } catch (IOException e) {
      throw new java.io.UncheckedIOException(e);
    }
  }

  @Test
  void theExamplesAreWhatTheCodeSends() {
    FakeWorld world = new FakeWorld("bot1", "bot2");
    List<String> sent = new ArrayList<>();
    world.rule =
        (from, to, datagram) -> {
          sent.add(hex(datagram));
          return new long[] {1};
        };
    Channel<String> talk = new Channel<>("talk", "1", new Text());
    Comms bot1 = new Comms(world.boot("bot1").platform(), 3);
    Comms bot2 = new Comms(world.boot("bot2").platform(), 1);
    bot2.open(talk, (from, message) -> {});
    Endpoint<String> endpoint = bot1.open(talk, (from, message) -> {});
    bot1.lamportClock().advanceTo(42);
    for (int i = 0; i < 7; i++) {
      endpoint.send(new RobotId("bot2"), "hi");
    }
    endpoint.sendReliably(new RobotId("bot2"), "hi");
    world.runMs(1);

    assertThat(sent).hasSize(9);
    assertThat(sent.get(6)).isEqualTo(example("plain"));
    assertThat(sent.get(7)).isEqualTo(example("reliable"));
    assertThat(sent.get(8)).isEqualTo(example("acknowledgement"));
  }

  @Test
  void theOffsetsKindsAndLimitsMatchTheCode() {
    assertThat(doc)
        .contains("| " + Header.LENGTH_AT + " | 2 | length |")
        .contains("| " + Header.BOOT_AT + " | 4 | boot |")
        .contains("| " + Header.NUMBER_AT + " | 8 | number |")
        .contains("| " + Header.CLOCK_AT + " | 8 | clock |")
        .contains("| " + Header.NAMES_AT + " | 1 + s | sender |")
        .contains("| 2 | 1 | version | " + Header.VERSION + " |")
        .contains("| plain | " + Header.PLAIN + " |")
        .contains("| reliable | " + Header.RELIABLE + " |")
        .contains("| acknowledgement | " + Header.ACK + " |")
        .contains("at most " + Header.MAX_BYTES + " bytes")
        .contains("the " + Session.BYTES + " bytes of a seal")
        .contains("the " + String.format(Locale.ROOT, "%,d", Seal.WINDOW) + " highest counts")
        .contains("the " + InboundWindows.WINDOW + " highest orders")
        .contains(String.format(Locale.ROOT, "remembers %,d senders", InboundWindows.MAX_SENDERS));
    assertThat(Header.MAX_CLOCK).isEqualTo((1L << 62) - 1);
    assertThat(Reliability.DEFAULT).isEqualTo(new Reliability(250, 1.5, 2_000, 15, 30_000));
  }

  @Test
  void theDropReasonsMatchTheCode() {
    Matcher row =
        Pattern.compile("^\\| `([a-z-]+)` \\|", Pattern.MULTILINE)
            .matcher(doc.substring(doc.indexOf("## Bad input"), doc.indexOf("## Versions")));
    List<String> reasons = row.results().map(r -> r.group(1)).toList();
    assertThat(reasons)
        .containsExactlyElementsOf(
            Arrays.stream(DropReason.values()).map(DropReason::toString).toList());
  }

  private String example(String name) {
    int from = doc.indexOf("```hex " + name + "\n");
    assertThat(from).as("an example called " + name).isPositive();
    String block = doc.substring(doc.indexOf('\n', from) + 1, doc.indexOf("```", from + 3));
    StringBuilder bytes = new StringBuilder();
    for (String line : block.split("\n")) {
      Matcher matcher = Pattern.compile("^(?:[0-9A-F]{2} )+").matcher(line);
      assertThat(matcher.find()).as(line).isTrue();
      bytes.append(matcher.group());
    }
    return bytes.toString().strip();
  }

  private static String hex(byte[] bytes) {
    StringBuilder text = new StringBuilder();
    for (byte b : bytes) {
      text.append(String.format(Locale.ROOT, "%02X ", b));
    }
    return text.toString().strip();
  }
}
