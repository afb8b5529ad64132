package org.starl.cli.campaign;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Base64;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.starl.apps.Demo;
import org.starl.apps.Demos;
import org.starl.apps.Measures;
import org.starl.apps.Parameter;
import org.starl.apps.Plan;
import org.starl.apps.Request;
import org.starl.apps.Sample;
import org.starl.apps.Story;
import org.starl.cli.Cli;
import org.starl.cli.HelloWithATwist;
import org.starl.cli.command.Apps;
import org.starl.cli.report.Parsed;
import org.starl.cli.report.Report;
import org.starl.cli.request.RunRequest;
import org.starl.sim.view.page.RunPage;
import org.starl.spec.Monitor;
import org.starl.spec.Monitors;
import org.starl.trace.TraceEvent;
import org.w3c.dom.Document;
import org.w3c.dom.Element;
import org.w3c.dom.Node;
import org.w3c.dom.NodeList;

/** {@code starl campaign --report}. */
class ReportTest {

  /** A text that runs as a script, or breaks the page, unless it is escaped. */
  private static final String HOSTILE =
      "<script>alert(1)</script><img src=x onerror=alert(2)>\"' onload='x' &amp; ]]> --> </title>";

  private static final Demos HOSTILE_APP = new Demos(List.of(new Hostile()));

  @TempDir private Path folder;

  /** Hello with runs that fail in every way, by seed, and with hostile texts. */
  private static final class Hostile extends HelloWithATwist {
    Hostile() {
      super("hostile<b>", HOSTILE);
    }

    @Override
    public List<Parameter> parameters() {
      return List.of(new Parameter("why", "", "anything"));
    }

    @Override
    protected Plan twist(Plan plan, Request request) {
      switch ((int) (request.seed() % 5)) {
        case 1 -> plan.simulation().monitor(Still::new);
        case 2 -> throwing(plan, new IllegalStateException(HOSTILE));
        case 3 -> plan.simulation().endNs(1_000_000_000);
        default -> {
          if (request.seed() == 99) {
            throwing(plan, new StackOverflowError("of the test"));
          }
        }
      }
      return new Plan(
          plan.simulation(), new HostileStory(plan.story()), plan.layer(), plan.obstacles());
    }

    private static void throwing(Plan plan, Throwable error) {
      plan.simulation()
          .director(control ->
              control.at(
                  1_000_000_000,
                  () -> {
                    if (error instanceof Error fatal) {
                      throw fatal;
                    }
                    throw (RuntimeException) error;
                  }));
    }
  }

  /** The story of hello, and hostile texts. */
  private static final class HostileStory implements Story {
    private final Story hello;

    HostileStory(Story hello) {
      this.hello = hello;
    }

    @Override
    public List<String> lines() {
      List<String> lines = new ArrayList<>(hello.lines());
      lines.add("reported: " + HOSTILE);
      return lines;
    }

    @Override
    public Measures measures() {
      return hello.measures();
    }

    @Override
    public List<Sample> samples() {
      return List.of(
          Sample.when("times of " + HOSTILE, List.of(1_500_000_000L, 2_000_000_000L)),
          Sample.howLong("sizes of " + HOSTILE, List.of(0L, 7_000_000L)));
    }
  }

  private static final class Still implements Monitor {
    @Override
    public List<String> lemmas() {
      return List.of(HOSTILE);
    }

    @Override
    public String description(String lemma) {
      return "no robot drives " + HOSTILE;
    }

    @Override
    public void observe(TraceEvent event, Report report) {
      report.checked(HOSTILE);
      if (event instanceof TraceEvent.Moved moved && moved.linearMmPerS() != 0) {
        report.violated(HOSTILE, event.timeNs(), List.of(event.robot()), "drives " + HOSTILE);
      }
    }
  }

  /** Hello with a lemma that is never checked. */
  private static final class Unchecked extends HelloWithATwist {
    Unchecked() {
      super("unchecked", "Hello with a lemma that is never checked.");
    }

    @Override
    protected Plan twist(Plan plan, Request request) {
      plan.simulation()
          .monitor(() ->
              new Monitor() {
                @Override
                public List<String> lemmas() {
                  return List.of("blind");
                }

                @Override
                public void observe(TraceEvent event, Report report) {
                  // checks nothing
                }
              });
      return plan;
    }
  }

  private Cli campaign(Demos demos, String app, String seeds, String... more) {
    List<String> words = new ArrayList<>(List.of("campaign", app, "--seeds", seeds));
    words.addAll(List.of("--report", file().toString()));
    words.addAll(Arrays.asList(more));
    return Cli.run(demos, words.toArray(String[]::new));
  }

  private Path file() {
    return folder.resolve("report.html");
  }

  private List<Path> files() throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      return files.toList();
    }
  }

  /** A picture within the page: pixels, or a drawing that runs nothing and loads nothing. */
  private static void requireHarmless(String address) throws Exception {
    String drawing = "data:image/svg+xml;base64,";
    if (!address.startsWith(drawing)) {
      assertThat(address).startsWith("data:image/png;base64,");
      return;
    }
    byte[] svg = Base64.getDecoder().decode(address.substring(drawing.length()));
    Document picture = Parsed.page(new String(svg, StandardCharsets.UTF_8));
    for (Element element : Parsed.elements(picture, "*")) {
      assertThat(element.getTagName()).isNotIn("script", "a", "image", "use", "foreignObject");
      for (int i = 0; i < element.getAttributes().getLength(); i++) {
        assertThat(element.getAttributes().item(i).getNodeName()).doesNotStartWith("on");
      }
    }
  }

  @Test
  void hostileTextsAreShownEscaped() throws Exception {
    Cli cli = campaign(HOSTILE_APP, "hostile<b>", "1..3", "--set", "why=" + HOSTILE);
    assertThat(cli.status()).isEqualTo(1);
    String text = Files.readString(file());
    Document page = Parsed.page(text);
    assertThat(Parsed.elements(page, "script")).hasSize(1);
    assertThat(Parsed.elements(page, "title").get(0).getTextContent()).startsWith("hostile<b>: ");
    for (Element element : Parsed.elements(page, "*")) {
      for (int i = 0; i < element.getAttributes().getLength(); i++) {
        String name = element.getAttributes().item(i).getNodeName();
        String value = element.getAttributes().item(i).getNodeValue();
        assertThat(name).doesNotStartWith("on").isNotEqualTo("style");
        if (name.equals("src")) {
          requireHarmless(value);
        }
        if (name.equals("href")) {
          assertThat(value).matches("#[a-z0-9-]+");
        }
      }
    }
    assertThat(page.getDocumentElement().getTextContent())
        .contains("why=" + HOSTILE)
        .contains("drives " + HOSTILE)
        .contains("says: no robot drives " + HOSTILE)
        .contains("reported: " + HOSTILE)
        .contains("Times of " + HOSTILE)
        .contains("Sizes of " + HOSTILE)
        .contains("IllegalStateException: " + HOSTILE);
  }

  @Test
  void everySectionIsInTheContentsAndEveryDrawingHasATitle() throws Exception {
    campaign(HOSTILE_APP, "hostile<b>", "1..7");
    Document page = Parsed.page(Files.readString(file()));
    List<Element> sections = Parsed.elements(page, "section");
    Element contents = Parsed.elements(page, "nav").getFirst();
    NodeList links = contents.getElementsByTagName("a");
    assertThat(links.getLength()).isEqualTo(sections.size()).isGreaterThan(5);
    for (int i = 0; i < links.getLength(); i++) {
      Element section = sections.get(i);
      assertThat(((Element) links.item(i)).getAttribute("href"))
          .isEqualTo("#" + section.getAttribute("id"));
      assertThat(links.item(i).getTextContent())
          .isEqualTo(section.getElementsByTagName("h2").item(0).getTextContent());
    }
    assertThat(Parsed.elements(page, "th")).noneMatch(head -> head.getTextContent().isEmpty());
    assertThat(Parsed.elements(page, "div"))
        .filteredOn(div -> div.getAttribute("class").equals("wide"))
        .isNotEmpty()
        .allMatch(div -> div.getAttribute("tabindex").equals("0"));
    for (Element drawing : Parsed.elements(page, "svg")) {
      boolean isSkipped =
          ((Element) drawing.getParentNode()).getAttribute("aria-hidden").equals("true");
      Node first = drawing.getFirstChild();
      while (first != null && !(first instanceof Element)) {
        first = first.getNextSibling();
      }
      assertThat(isSkipped || (first != null && first.getNodeName().equals("title"))).isTrue();
    }
  }

  @Test
  void badRunsHaveStoryPicturesAndReplay() throws Exception {
    campaign(HOSTILE_APP, "hostile<b>", "1..7");
    Document page = Parsed.page(Files.readString(file()));
    List<Element> articles = Parsed.elements(page, "article");
    assertThat(articles)
        .extracting(article -> article.getAttribute("id"))
        .containsExactly("seed1", "seed2", "seed3", "seed6", "seed7");
    for (Element article : articles) {
      String seed = article.getAttribute("id").substring("seed".length());
      assertThat(article.getTextContent()).contains("./starl run 'hostile<b>' --seed " + seed);
      assertThat(article.getElementsByTagName("img").getLength()).isPositive();
      Element player = (Element) article.getElementsByTagName("iframe").item(0);
      assertThat(player.getAttribute("srcdoc")).contains("hostile&lt;b>");
      // An XML parser reads line ends in attributes as spaces.
      assertThat(player.getAttribute("srcdoc")).contains(RunPage.script().replace('\n', ' '));
      boolean isThrown = Integer.parseInt(seed) % 5 == 2;
      assertThat(article.getElementsByTagName("ol").getLength()).isEqualTo(isThrown ? 0 : 1);
      assertThat(article.getTextContent()).doesNotContain("ended differently");
    }
    assertThat(articles.get(0).getTextContent())
        .contains("violated")
        .contains("more violations in this run");
    assertThat(articles.get(2).getTextContent())
        .contains("unfinished")
        .contains("1.000\u00A0s: the end");
    assertThat(page.getDocumentElement().getTextContent())
        .contains("5 of 7\u00A0runs did not go well (2 violated, 2 failed, 1 unfinished)");
    // Tasks completed in violated runs are no figure beside that of good runs.
    assertThat(figures(page))
        .filteredOn(figure -> figure.contains("of"))
        .anyMatch(f -> f.matches("2 of 7 runs went well, though \\d+ of \\d+ robots finished.*"))
        .noneMatch(figure -> figure.matches("\\d+ of \\d+ robots finished.*"));
  }

  private static List<String> figures(Document page) {
    return Parsed.elements(page, "li").stream()
        .map(Element::getTextContent)
        .map(text -> text.replace('\u00A0', ' '))
        .toList();
  }

  @Test
  void thePageShowsWhatWasReachedAndTheErrorRates() throws Exception {
    String[] more = {"--robots=3", "--set=rounds=4", "--fault=loss(0.1,until=5s)"};
    campaign(Apps.ALL, "mutex", "1..2", more);
    Document page = Parsed.page(Files.readString(file()));
    assertThat(rows(page, "Bad runs").get(0)).startsWith("all 0 2 ").endsWith("78 %");
    assertThat(rows(page, "Bad runs").get(1)).startsWith("loss 0 2 ");
    assertThat(rows(page, "Mutex_decls"))
        .anyMatch(row -> row.matches("crit_set\\(i\\) = \\{} \\d+ \\d+"))
        .anyMatch(row -> row.matches("do_mutex RS != \\{} \\d+ \\d+ never"))
        .anyMatch(row -> row.matches("stands_in  never  "));
    assertThat(rows(page, "mutex"))
        .hasSize(3)
        .anyMatch(row -> row.matches("TRYING \\d+ \\d+ .* never never never"));
  }

  @Test
  void thePageNamesLemmasThatNoRunChecked() throws Exception {
    Demos blind = new Demos(List.of(new Unchecked()));
    String told = "Never checked, so unknown: blind.";
    assertThat(campaign(blind, "unchecked", "1..2").status()).isZero();
    assertThat(Files.readString(file())).contains(told).doesNotContain("is a failure");
    assertThat(campaign(blind, "unchecked", "1..100").status()).isEqualTo(1);
    assertThat(Files.readString(file())).contains(told).contains("is a failure");
  }

  /** The rows of the table with this caption; cells are separated by spaces. */
  private static List<String> rows(Document page, String caption) {
    Element table =
        Parsed.elements(page, "table").stream()
            .filter(any -> any.getElementsByTagName("caption").getLength() > 0)
            .filter(
                any -> any.getElementsByTagName("caption").item(0).getTextContent().equals(caption))
            .findFirst()
            .orElseThrow();
    List<String> rows = new ArrayList<>();
    NodeList all =
        ((Element) table.getElementsByTagName("tbody").item(0)).getElementsByTagName("tr");
    for (int i = 0; i < all.getLength(); i++) {
      List<String> cells = new ArrayList<>();
      for (Node cell = all.item(i).getFirstChild(); cell != null; cell = cell.getNextSibling()) {
        if (cell instanceof Element) {
          cells.add(cell.getTextContent().replaceAll("[\\u202F\\u00A0]", ""));
        }
      }
      rows.add(String.join(" ", cells));
    }
    return rows;
  }

  @Test
  void everySeedHasALineWithItsReplay() throws Exception {
    Cli cli = campaign(Apps.ALL, "hello", "5..44");
    assertThat(cli.status()).isZero();
    assertThat(cli.out()).endsWith("report: " + file());
    String text = Files.readString(file());
    Document page = Parsed.page(text);
    Element table =
        Parsed.elements(page, "table").stream()
            .filter(any -> any.getAttribute("id").equals("runs"))
            .findFirst()
            .orElseThrow();
    for (int seed = 5; seed <= 44; seed++) {
      assertThat(table.getTextContent()).contains("./starl run hello --seed " + seed);
    }
    assertThat(table.getElementsByTagName("tr").getLength()).isEqualTo(41);
    assertThat(page.getDocumentElement().getTextContent()).contains("All 40 runs went well.");
    String ours = text.replace("http-equiv", "").replaceAll("base64,[A-Za-z0-9+/=]+", "");
    assertThat(ours).hasSizeLessThan(40_000).doesNotContainPattern("http|url\\(|@import|//[a-z]");
  }

  @Test
  void theSameCampaignMakesTheSamePageOnAnyNumberOfThreads() throws IOException {
    campaign(HOSTILE_APP, "hostile<b>", "1..4", "--threads", "1");
    String one = Files.readString(file());
    campaign(HOSTILE_APP, "hostile<b>", "1..4", "--threads", "3");
    String threads = "<span>--threads</span> <span>%d</span>";
    assertThat(Files.readString(file()).replace(threads.formatted(3), threads.formatted(1)))
        .isEqualTo(one);
  }

  @Test
  void anUnwritablePageIsRefusedBeforeTheCampaign() throws IOException {
    Path noFolder = Files.createFile(folder.resolve("file"));
    for (Path bad : List.of(folder, noFolder.resolve("report.html"))) {
      Cli cli = Cli.run("campaign", "hello", "--seeds", "1..100000", "--report", bad.toString());
      assertThat(cli.status()).isEqualTo(2);
      assertThat(cli.err()).hasSize(1);
      assertThat(cli.err().get(0)).startsWith("starl: --report: ").contains("expected");
    }
    Cli many = Cli.run("campaign", "hello", "--seeds", "1..100001", "--report", "" + file());
    assertThat(many.status()).isEqualTo(2);
    assertThat(many.err()).hasSize(1);
    assertThat(files()).containsExactly(noFolder);
  }

  @Test
  void anAbortedCampaignLeavesNoFile() throws IOException {
    assertThatThrownBy(() -> campaign(HOSTILE_APP, "hostile<b>", "99..99"))
        .isInstanceOf(StackOverflowError.class);
    assertThat(files()).isEmpty();
  }

  @Test
  void jsonNamesTheReportFile() throws IOException {
    Cli cli = campaign(Apps.ALL, "hello", "1..3", "--json");
    assertThat(cli.out()).hasSize(1);
    assertThat(new ObjectMapper().readTree(cli.out().get(0)).get("report").asText())
        .isEqualTo(file().toString());
    assertThat(files()).containsExactly(file());
  }

  @Test
  void everyLemmaOfEveryAppHasADescription() {
    for (Demo demo : Apps.ALL.all()) {
      Plan plan = new RunRequest.Builder(demo).build().plan(1);
      for (Monitor monitor : Monitors.of(plan.simulation().build().plan().monitors()).monitors()) {
        for (String lemma : monitor.lemmas()) {
          assertThat(monitor.description(lemma))
              .as("%s of %s", lemma, monitor.getClass())
              .matches("[A-Z\"].{15,110}[.]");
        }
        assertThat(monitor.description("no lemma of it")).isNotNull();
      }
    }
  }
}
