package org.starl.cli.campaign;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.starl.apps.Demos;
import org.starl.apps.Plan;
import org.starl.apps.Request;
import org.starl.cli.Cli;
import org.starl.cli.HelloWithATwist;
import org.starl.cli.command.ExitStatus;
import org.starl.cli.report.Report;
import org.starl.spec.LemmaMonitor;
import org.starl.trace.TraceEvent;
import org.w3c.dom.Document;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;

/** {@code starl ci}. With no time for a second seed, each command runs one more of each app. */
class CiTest {

  private static final Demos DEMOS = new Demos(List.of(new Twisted("calm"), new Twisted("odd")));

  @TempDir private Path folder;

  /** Hello; the one called odd violates its specification in each odd seed. */
  private static final class Twisted extends HelloWithATwist {
    Twisted(String name) {
      super(name, "hello");
    }

    @Override
    protected Plan twist(Plan plan, Request request) {
      if (name().equals("odd") && request.seed() % 2 == 1) {
        plan.simulation().monitor(Odd::new);
      }
      return plan;
    }
  }

  private static final class Odd extends LemmaMonitor {
    Odd() {
      lemma("even", "The seed is even.");
    }

    @Override
    public void observe(TraceEvent event, Report report) {
      report.checked("even");
      report.violated("even", event.timeNs(), List.of(event.robot()), "it <is> odd");
    }
  }

  private Cli ci(String... words) {
    Stream<String> all =
        Stream.concat(
            Stream.of("ci", "--budget", "1ns", "--out", folder.toString()), Stream.of(words));
    return Cli.run(DEMOS, all.toArray(String[]::new));
  }

  private Document junit() throws Exception {
    return DocumentBuilderFactory.newInstance()
        .newDocumentBuilder()
        .parse(folder.resolve("junit.xml").toFile());
  }

  private List<Path> saved() throws IOException {
    try (Stream<Path> files = Files.list(folder.resolve("good"))) {
      return files.sorted().toList();
    }
  }

  @Test
  void goodSeedsAreKeptAndTheNextCommandRunsOthers() throws Exception {
    for (int seeds = 1; seeds <= 3; seeds++) {
      Cli cli = ci("calm");
      assertThat(cli.status()).as("%s", cli).isZero();
      assertThat(cli.text()).contains("calm: " + (seeds - 1) + " good seeds of an earlier run");
      assertThat(junit().getElementsByTagName("testcase").getLength()).isEqualTo(seeds);
      assertThat(Files.readAllLines(saved().getFirst())).hasSize(seeds);
    }
    assertThat(saved()).hasSize(1);
    assertThat(folder.resolve("index.html"))
        .content()
        .contains("calm.html", "Every campaign went well");
    // As after a change of a class.
    Path file = saved().getFirst();
    Files.move(
        file,
        file.resolveSibling(file.getFileName().toString().replaceAll("..\\.rows", "00.rows")));
    assertThat(ci("calm").text()).contains("calm: 0 good seeds of an earlier run");
    assertThat(saved()).hasSize(1);
  }

  @Test
  void aBadSeedIsToldAndShownAndRunsAgainTheNextTime() throws Exception {
    for (int i = 0; i < 2; i++) {
      Cli cli = ci();
      assertThat(cli.status()).as("%s", cli).isEqualTo(ExitStatus.VIOLATED);
      assertThat(cli.err()).anyMatch(line -> line.startsWith("odd: seed 1: even violated at "));
      NodeList failures = junit().getElementsByTagName("failure");
      assertThat(failures.getLength()).isOne();
      Element failure = (Element) failures.item(0);
      assertThat(failure.getAttribute("message")).contains("it <is> odd");
      assertThat(failure.getTextContent())
          .contains("replay: ./starl run odd --seed 1 --chaos")
          .contains("bad/odd-1.html");
      assertThat(((Element) failure.getParentNode()).getAttribute("name")).isEqualTo("seed 1");
      for (String ending : List.of("trace", "png", "html")) {
        assertThat(folder.resolve("bad/odd-1." + ending)).isNotEmptyFile();
      }
      assertThat(folder.resolve("index.html")).content().contains("href=\"bad/odd-1.html\"");
    }
  }

  @Test
  void wrongWordsAreRefusedBeforeAnythingRuns() {
    ci("calm", "calm").assertRefused("calm is there twice");
    ci("clam").assertRefused("clam");
    Cli.run(DEMOS, "ci", "--budget", "soon").assertRefused("--budget", "'soon'");
    Cli.run(DEMOS, "ci", "--budget", "0s").assertRefused("--budget", "a time above 0");
    assertThat(folder.resolve("index.html")).doesNotExist();
  }
}
