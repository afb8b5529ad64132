// Longer than 500 lines because all pages of the server are tested with the same clients.
package org.starl.serve;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.ByteArrayOutputStream;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.net.Socket;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.net.http.WebSocket;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.CleanupMode;
import org.junit.jupiter.api.io.TempDir;
import org.starl.apps.hello.HelloDemo;
import org.starl.browser.Browser;
import org.starl.cli.Main;
import org.starl.cli.serve.PageServer;
import org.starl.cli.serve.Site;
import org.starl.geometry.Obstacles;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;
import org.starl.sim.record.Layer;
import org.starl.sim.replay.Recording;
import org.starl.sim.view.page.LivePage;
import org.starl.spec.SpecReport;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceHeader;

/** The pages of {@code starl serve} in a real browser. */
@Tag("realtime")
class ServeTest {

  private static final ObjectMapper JSON = new ObjectMapper();
  private static final int MOST_ASKED = 2000;

  @TempDir(cleanup = CleanupMode.ON_SUCCESS)
  Path folder;

  private int profiles;

  private Browser browser(URI page) throws Exception {
    return Browser.open(Files.createDirectory(folder.resolve("p" + profiles++)), page, 1200, 860);
  }

  private static String nowMs() {
    return "Number(document.getElementById('time').value)";
  }

  @Test
  void aPageFollowsARunWhileItGoesOn() throws Exception {
    try (Serve serve = new Serve("intersection", "--seed", "7", "--set", "speed=5");
        Browser browser = browser(serve.address)) {
      browser.await(nowMs() + " > 500");
      double before = browser.evaluate(nowMs()).asDouble();
      browser.await(nowMs() + " > 2000 + " + before);
      assertThat(browser.evaluate("document.getElementById('live').hidden").asBoolean()).isFalse();
      assertThat(browser.text("#robots")).contains("bot");
      browser.await("document.getElementById('message').textContent.startsWith('The run ended')");
      assertThat(browser.evaluate("document.getElementById('live').hidden").asBoolean()).isTrue();
      assertThat(browser.errors()).isEmpty();
    }
  }

  @Test
  void aRecordedTraceIsPlayed() throws Exception {
    String trace = folder.resolve("hello.trace").toString();
    String picture = folder.resolve("hello.png").toString();
    PrintWriter none = new PrintWriter(new StringWriter());
    Main.run(none, none, "run", "hello", "--seed", "7", "--trace", trace, "--png", picture);
    try (Serve serve = new Serve(trace);
        Browser browser = browser(serve.address)) {
      browser.key("End");
      browser.await("document.getElementById('message').textContent.startsWith('The run ended')");
      assertThat(browser.errors()).isEmpty();
    }
  }

  /** One run, which a test records. */
  private record OneRun(Shown shown) implements Site {

    @Override
    public Home home() {
      return Home.RUN;
    }

    @Override
    public Shown run(int number) {
      return shown;
    }

    @Override
    public Map<String, Object> overview() {
      return Map.of();
    }

    @Override
    public Map<String, Object> schema() {
      return Map.of();
    }

    @Override
    public int start(Map<String, ?> request) {
      return 1;
    }
  }

  @Test
  void aViolationIsShownWhenItHappens() throws Exception {
    Recording recording = new Recording(Obstacles.NONE, Layer.NONE);
    Site site = new OneRun(new Site.Shown("made up", "", recording, new LivePage(recording, 1)));
    PageServer.Access access = new PageServer.Access("127.0.0.1", 0, "", List.of());
    RobotId bot = new RobotId("bot0");
    try (PageServer.Running server = new WebServer().start(access, site)) {
      recording.started(new TraceHeader("0", "made up", 7, 8, Map.of(), List.of(bot)));
      recording.observed(new TraceEvent.Joined(0, bot, new Pose(0, 0, 0), 150));
      recording.reached(2_000_000_000);
      try (Browser browser = browser(URI.create("http://127.0.0.1:" + server.port() + "/"))) {
        browser.await(nowMs() + " >= 1900");
        assertThat(browser.evaluate("document.getElementById('next').disabled").asBoolean())
            .isTrue();
        recording.violated(
            new SpecReport.Violation("Exclusive", 1_500_000_000, List.of(bot), "two in one zone"));
        browser.await("document.getElementById('message').className === 'alarm'");
        assertThat(browser.text("#message")).contains("two in one zone");
        browser.evaluate("document.querySelector('#marks .VIOLATION').click()");
        assertThat(browser.evaluate(nowMs()).asDouble()).isEqualTo(1500);
        recording.over(3_000_000_000L);
        browser.await("document.getElementById('live').hidden");
        assertThat(browser.evaluate("document.getElementById('time').max").asText())
            .isEqualTo("3000");
        assertThat(browser.errors()).isEmpty();
      }
    }
  }

  /** The first event of a run's parts, for a browser that has the part of this id. */
  private static List<String> firstEvent(int port, String lastId) throws Exception {
    HttpRequest.Builder request =
        HttpRequest.newBuilder(URI.create("http://127.0.0.1:" + port + "/run/1/parts"));
    if (!lastId.isEmpty()) {
      request.header("Last-Event-ID", lastId);
    }
    try (HttpClient http = HttpClient.newHttpClient();
        Stream<String> lines =
            http.send(request.build(), HttpResponse.BodyHandlers.ofLines()).body()) {
      List<String> event =
          lines
              .filter(line -> line.startsWith("id: ") || line.startsWith("event: "))
              .limit(2)
              .toList();
      http.shutdownNow();
      return event;
    }
  }

  @Test
  void aPageOfAnEarlierServerBeginsAgain() throws Exception {
    PageServer.Access access = new PageServer.Access("127.0.0.1", 0, "", List.of());
    RobotId bot = new RobotId("bot0");
    List<String> ids = new ArrayList<>();
    for (int i = 0; i < 2; i++) {
      Recording recording = new Recording(Obstacles.NONE, Layer.NONE);
      recording.started(new TraceHeader("0", "made up", i, i, Map.of(), List.of(bot)));
      recording.observed(new TraceEvent.Joined(0, bot, new Pose(0, 0, 0), 150));
      recording.reached(9_000_000_000L);
      Site site = new OneRun(new Site.Shown("made up", "", recording, new LivePage(recording, 1)));
      try (PageServer.Running server = new WebServer().start(access, site)) {
        String id = firstEvent(server.port(), "").getFirst().substring("id: ".length());
        assertThat(firstEvent(server.port(), id).getLast()).isEqualTo("event: more");
        for (String other : ids) {
          assertThat(firstEvent(server.port(), other).getLast()).isEqualTo("event: begin");
        }
        ids.addAll(List.of(id, "x", "7", "-1", "a-b-c"));
      }
    }
  }

  /** A run that goes on, at this time. */
  private static Site site(String title, long atNs) {
    RobotId bot = new RobotId("bot0");
    Recording recording = new Recording(Obstacles.NONE, Layer.NONE);
    recording.started(new TraceHeader("0", title, 7, 8, Map.of(), List.of(bot)));
    recording.observed(new TraceEvent.Joined(0, bot, new Pose(0, 0, 0), 150));
    recording.reached(atNs);
    return new OneRun(new Site.Shown(title, "", recording, new LivePage(recording, 1)));
  }

  /** Waits for a title, while the page may load anew, which ends what is evaluated. */
  private static void awaitTitle(Browser browser, String title) throws Exception {
    for (int asked = 0; asked < MOST_ASKED; asked++) {
      try {
        String shown = "new Promise(done => setTimeout(() => done(document.title), 20))";
        if (browser.evaluate(shown).asText().equals(title)) {
          return;
        }
      } catch (AssertionError replaced) {
        continue; // the page has just been loaded anew
      }
    }
    throw new AssertionError("the page has another title");
  }

  @Test
  void aPageTellsThatItsServerIsGoneAndShowsTheRunOfTheNextOne() throws Exception {
    PageServer.Access any = new PageServer.Access("127.0.0.1", 0, "", List.of());
    PageServer.Running first = new WebServer().start(any, site("first", 2_000_000_000));
    int port = first.port();
    try (first;
        Browser browser = browser(URI.create("http://127.0.0.1:" + port + "/"))) {
      browser.await(nowMs() + " >= 1900");
      first.close();
      browser.await("document.getElementById('lacks').textContent.startsWith('No connection')");
      PageServer.Access same = new PageServer.Access("127.0.0.1", port, "", List.of());
      try (PageServer.Running next = new WebServer().start(same, site("next", 1_000_000_000))) {
        assertThat(next.port()).isEqualTo(port);
        awaitTitle(browser, "next");
      }
      browser.takeErrors(); // of the connection
    }
  }

  @Test
  void aLinkOfThePlaygroundStartsTheSameRunsInAnotherBrowser() throws Exception {
    try (Serve serve = new Serve();
        Browser first = browser(serve.address)) {
      first.evaluate(
          "{ document.getElementById('app').value = 'hello'; document.getElementById('app').onchange();"
              + " document.getElementById('seed').value = '3'; document.getElementById('run').click(); }");
      assertThat(first.text("#summary")).isEqualTo(new HelloDemo().summary());
      first.await("document.querySelectorAll('iframe').length === 1");
      first.evaluate(
          "{ document.querySelector('[name=robots]').value = '3';"
              + " document.getElementById('faults').value = 'crash(bot0,at=1s)';"
              + " document.getElementById('beside').click(); }");
      first.await("document.querySelectorAll('iframe').length === 2");
      assertThat(first.text("article:last-child p"))
          .isEqualTo("changed: faults: default \u2192 crash(bot0,at=1s), robots: default \u2192 3");
      String link = first.evaluate("location.href").asText();
      try (Browser second = browser(URI.create(link))) {
        assertThat(second.text("#linked")).contains("2 runs", "crash(bot0,at=1s)");
        assertThat(second.evaluate("document.querySelectorAll('iframe').length").asInt()).isZero();
        JsonNode overview = JSON.readTree(serve.get("/api/overview").body());
        assertThat(overview.get("runs")).as("a link alone starts nothing").hasSize(2);
        second.evaluate("document.getElementById('run').click()");
        second.await("document.querySelectorAll('iframe').length === 2");
        assertThat(second.text("article:last-child code"))
            .isEqualTo(first.text("article:last-child code"))
            .endsWith("run hello --seed 3 --robots 3 --fault 'crash(bot0,at=1s)'");
        assertThat(second.evaluate("document.querySelector('[name=robots]').value").asText())
            .isEqualTo("3");
        assertThat(second.errors()).isEmpty();
      }
      first.evaluate(
          "{ document.querySelector('[name=robots]').value = 'many';"
              + " document.getElementById('beside').click(); }");
      first.await("document.getElementById('error').textContent !== ''");
      assertThat(first.text("#error")).contains("robots", "many", "expected");
      assertThat(first.takeErrors())
          .hasSize(1)
          .allMatch(error -> error.contains("400 (Bad Request)"));
    }
  }

  @Test
  void aCampaignShowsEachBadRunAndOpensIt() throws Exception {
    try (Serve serve =
            new Serve(
                "intersection",
                "--seeds",
                "1..3",
                "--set",
                "scenario=figure7",
                "--fault",
                "jump(bot1,600mm,at=2s)",
                "--for",
                "40s",
                "--threads",
                "1");
        Browser browser = browser(serve.address)) {
      browser.await("document.querySelector('#bad button') !== null");
      browser.await("document.getElementById('state').textContent.endsWith('ended')");
      assertThat(browser.text("#state")).startsWith("3 of 3 runs, ");
      assertThat(browser.evaluate("document.querySelectorAll('#squares i').length").asInt())
          .isEqualTo(3);
      browser.evaluate("document.getElementById('bad').style.marginBottom = '900px'"); // more rows
      browser.evaluate("document.querySelector('#bad button').click()");
      browser.await(
          "document.querySelector('iframe')?.contentDocument?.documentElement?.dataset.ready === 'true'");
      assertThat(
              browser
                  .evaluate(
                      "document.querySelector('iframe').getBoundingClientRect().top < innerHeight")
                  .asBoolean())
          .isTrue();
      browser.await(
          "(page => page.getElementById('play').textContent === 'Play' && page.getElementById("
              + "'clock').textContent.split(' ')[0] > 30)"
              + "(document.querySelector('iframe').contentDocument)");
      assertThat(browser.errors()).isEmpty();
    }
  }

  @Test
  void robotsAsProcessesAreWatchedWhileOneIsKilled() throws Exception {
    try (Serve serve =
            new Serve(
                "hello",
                "--processes",
                "--robots",
                "3",
                "--seed",
                "7",
                "--kill",
                "bot1@1s",
                "--for",
                "4s");
        Browser browser = browser(serve.address)) {
      browser.await("document.querySelector('#marks .CRASH') !== null");
      assertThat(browser.evaluate("document.querySelector('#marks .CRASH').title").asText())
          .contains("bot1 crash");
      browser.await(
          "document.getElementById('live').hidden && !document.getElementById('play').disabled");
      assertThat(browser.errors()).isEmpty();
    }
  }

  @Test
  void aSignalIsTheNormalEndOfProcesses() throws Exception {
    Serve serve = new Serve("hello", "--processes", "--robots", "2", "--seed", "7");
    try (serve) {
      assertThat(serve.get("/").statusCode()).isEqualTo(302);
    }
    assertThat(serve.errors()).contains("stopped").doesNotContain("interrupted", "starl: ");
  }

  @Test
  void foreignRequestsAreRefusedAndBadOnesTold() throws Exception {
    try (Serve serve = new Serve()) {
      try (Socket socket = serve.ask("GET / HTTP/1.1\r\nHost: evil.example\r\n\r\n")) {
        byte[] first = socket.getInputStream().readNBytes(12);
        assertThat(new String(first, StandardCharsets.US_ASCII)).isEqualTo("HTTP/1.1 403");
      }
      assertThat(serve.get("/", "Origin", "http://evil.example").statusCode()).isEqualTo(403);
      assertThat(serve.get("/run/1").statusCode()).isEqualTo(404);
      assertThat(serve.get("/run/x").statusCode()).isEqualTo(404);
      for (String body :
          new String[] {
            "",
            "[]",
            "{",
            "{\"app\":\"nope\",\"seed\":1}",
            "{\"app\":\"hello\"}",
            "{\"app\":\"hello\",\"seed\":\"x\"}",
            "{\"app\":\"hello\",\"seed\":1,\"faults\":[\"crash(\"]}",
            "{\"app\":\"hello\",\"seed\":1,\"set\":{\"nope\":1}}"
          }) {
        var answer = serve.post("/api/runs", body);
        assertThat(answer.statusCode()).as(body).isEqualTo(400);
        assertThat(answer.body().lines()).as(body).hasSize(1);
        assertThat(answer.body()).as(body).contains("expected");
      }
      assertThat(serve.post("/api/runs", "x".repeat(100_000)).statusCode()).isEqualTo(413);
      var page = serve.get("/");
      assertThat(page.headers().firstValue("Content-Security-Policy").orElse(""))
          .contains("frame-ancestors 'self'", "default-src 'none'");
    }
  }

  @Test
  void beyondThisMachineATokenIsNeeded() throws Exception {
    try (Serve serve = new Serve("--host", "0.0.0.0")) {
      assertThat(serve.address.getHost()).as("an address to connect to").isNotEqualTo("0.0.0.0");
      assertThat(serve.address.getQuery()).matches("token=[0-9a-f]{32}");
      assertThat(serve.get("/api/overview").statusCode()).isEqualTo(401);
      assertThat(serve.get("/api/overview?token=" + "0".repeat(32)).statusCode()).isEqualTo(401);
      var first = serve.get("/?" + serve.address.getQuery());
      assertThat(first.statusCode()).isEqualTo(200);
      String cookie = first.headers().firstValue("Set-Cookie").orElse("");
      assertThat(cookie).contains("HttpOnly", "SameSite=Lax");
      JsonNode overview =
          JSON.readTree(serve.get("/api/overview", "Cookie", cookie.split(";")[0]).body());
      assertThat(overview.get("runs")).isEmpty();
    }
  }

  @Test
  void aRunSlowsForNoBrowserThatDoesNotRead() throws Exception {
    try (Serve serve = new Serve("intersection", "--seed", "7", "--set", "speed=0");
        Socket reader =
            serve.ask(
                "GET /run/1/parts HTTP/1.1\r\nHost: "
                    + serve.address.getAuthority()
                    + "\r\n\r\n")) {
      assertThat(reader.isConnected()).isTrue();
      String state = "";
      while (!state.startsWith("ended")) {
        state = JSON.readTree(serve.get("/api/overview").body()).at("/runs/0/state").asText();
        assertThat(state).doesNotContain("failed");
      }
    }
  }

  /** A client of Foxglove's protocol: keeps what it receives. */
  private static final class Client implements WebSocket.Listener {
    private final BlockingQueue<JsonNode> texts = new LinkedBlockingQueue<>();
    private final BlockingQueue<ByteBuffer> data = new LinkedBlockingQueue<>();
    private final StringBuilder parts = new StringBuilder();
    private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();

    @Override
    public @Nullable CompletionStage<?> onText(WebSocket from, CharSequence part, boolean isLast) {
      parts.append(part);
      if (isLast) {
        try {
          texts.add(JSON.readTree(parts.toString()));
        } catch (JsonProcessingException e) {
          throw new IllegalStateException(e);
        }
        parts.setLength(0);
      }
      from.request(1);
      return null;
    }

    @Override
    public @Nullable CompletionStage<?> onBinary(WebSocket from, ByteBuffer part, boolean isLast) {
      while (part.hasRemaining()) {
        bytes.write(part.get());
      }
      if (isLast) {
        data.add(ByteBuffer.wrap(bytes.toByteArray()).order(ByteOrder.LITTLE_ENDIAN));
        bytes.reset();
      }
      from.request(1);
      return null;
    }

    private WebSocket connect(Serve serve, String protocol) throws Exception {
      URI at = URI.create("ws://" + serve.address.getAuthority() + "/run/1/foxglove");
      return HttpClient.newHttpClient()
          .newWebSocketBuilder()
          .subprotocols(protocol)
          .buildAsync(at, this)
          .get(30, TimeUnit.SECONDS);
    }

    /** The channel of a topic, once it is advertised. */
    private int channel(String topic) throws InterruptedException {
      while (true) {
        JsonNode text = Objects.requireNonNull(texts.poll(30, TimeUnit.SECONDS));
        for (JsonNode channel : text.path("channels")) {
          if (channel.get("topic").asText().equals(topic)) {
            return channel.get("id").asInt();
          }
        }
      }
    }

    /** The next message of a subscription; checks that the time does not go back. */
    private JsonNode message(int subscription) throws Exception {
      while (true) {
        ByteBuffer next = Objects.requireNonNull(data.poll(30, TimeUnit.SECONDS));
        if (next.get() == 1) {
          assertThat(next.getInt()).isEqualTo(subscription);
          assertThat(next.getLong()).isNotNegative();
          byte[] json = new byte[next.remaining()];
          next.get(json);
          return JSON.readTree(json);
        }
      }
    }
  }

  @Test
  void foxgloveSeesARunWhileItGoesOn() throws Exception {
    for (String protocol : FoxgloveFeed.PROTOCOLS) {
      Client client = new Client();
      try (Serve serve = new Serve("intersection", "--seed", "7", "--set", "speed=2")) {
        WebSocket socket = client.connect(serve, protocol);
        assertThat(socket.getSubprotocol()).isEqualTo(protocol);
        JsonNode info = Objects.requireNonNull(client.texts.poll(30, TimeUnit.SECONDS));
        assertThat(info.get("op").asText()).isEqualTo("serverInfo");
        assertThat(info.get("name").asText()).contains("intersection, seed 7");
        int scene = client.channel("/scene");
        socket.sendText(
            "{\"op\":\"subscribe\",\"subscriptions\":[{\"id\":5,\"channelId\":" + scene + "}]}",
            true);
        double first = client.message(5).at("/entities/0/timestamp/nsec").asDouble();
        for (int i = 0; i < 20; i++) {
          assertThat(client.message(5).get("entities")).isNotEmpty();
        }
        assertThat(client.message(5).at("/entities/0/timestamp/nsec").asDouble())
            .isNotEqualTo(first);
        socket.abort();
      }
    }
  }

  @Test
  void aClientOfAnotherProtocolIsSentAway() throws Exception {
    CompletableFuture<Integer> closed = new CompletableFuture<>();
    try (Serve serve = new Serve("hello", "--seed", "7")) {
      HttpClient.newHttpClient()
          .newWebSocketBuilder()
          .subprotocols("other")
          .buildAsync(
              URI.create("ws://" + serve.address.getAuthority() + "/run/1/foxglove"),
              new WebSocket.Listener() {
                @Override
                public @Nullable CompletionStage<?> onClose(WebSocket from, int code, String why) {
                  closed.complete(code);
                  return null;
                }
              })
          .get(30, TimeUnit.SECONDS);
      assertThat(closed.get(30, TimeUnit.SECONDS)).isEqualTo(1002);
    }
  }
}
