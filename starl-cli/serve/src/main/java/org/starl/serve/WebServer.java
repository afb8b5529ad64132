package org.starl.serve;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.type.TypeReference;
import com.fasterxml.jackson.databind.ObjectMapper;
import io.javalin.Javalin;
import io.javalin.config.JavalinConfig;
import io.javalin.config.RoutesConfig;
import io.javalin.http.Context;
import io.javalin.http.Cookie;
import io.javalin.http.HttpResponseException;
import io.javalin.http.SameSite;
import io.javalin.util.JavalinException;
import io.javalin.websocket.WsConfig;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import java.util.SortedMap;
import java.util.concurrent.ConcurrentSkipListMap;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;
import org.eclipse.jetty.websocket.api.Session;
import org.starl.cli.serve.PageServer;
import org.starl.cli.serve.Site;
import org.starl.input.BadInput;
import org.starl.input.FailureText;
import org.starl.input.TextFile;
import org.starl.robot.realtime.RealClock;
import org.starl.sim.export.FoxgloveLayout;
import org.starl.sim.view.page.LivePage;
import org.starl.time.Time;

/** The server, found as a service. */
public final class WebServer implements PageServer {

  /** Connections that stay open. */
  private static final int MOST_STREAMS = 64;

  private static final int MOST_REQUEST_BYTES = 64 << 10;
  private static final long LOOK_MS = 50;

  /** A connection without news is checked so often. */
  private static final int LOOKS_PER_COMMENT = 100;

  private static final int PROTOCOL_ERROR = 1002;
  private static final int TRY_LATER = 1013;
  private static final int FORBIDDEN = 403;
  private static final int UNAUTHORIZED = 401;

  /** For the service loader. */
  public WebServer() {}

  @Override
  public Running start(Access access, Site site) throws IOException {
    Serving serving = new Serving(access, site);
    try {
      serving.server.start(access.host(), access.port());
    } catch (JavalinException e) {
      Throwable cause = e.getCause() == null ? e : e.getCause();
      String where = "--host " + access.host() + " --port " + access.port();
      throw new IOException(where + ": " + cause.getMessage(), e);
    }
    return serving;
  }

  private static final class Serving implements Running {

    private final Access access;
    private final Site site;
    private final Gate gate;
    private final Javalin server;
    private final ObjectMapper mapper = new ObjectMapper();

    /** Begins the ids of events: a page of an earlier server of this port has others. */
    private final String name = Long.toHexString(RealClock.ofDate().nowNs());

    private final Semaphore streams = new Semaphore(MOST_STREAMS);
    private final CountDownLatch closing = new CountDownLatch(1);

    Serving(Access access, Site site) {
      this.access = access;
      this.site = site;
      gate = new Gate(access, Gate.machine());
      server = Javalin.create(this::configure);
    }

    @Override
    public int port() {
      return server.port();
    }

    @Override
    public void close() {
      closing.countDown();
      server.stop();
    }

    private void configure(JavalinConfig config) {
      config.startup.showJavalinBanner = false;
      config.startup.showOldJavalinVersionWarning = false;
      config.startup.startupWatcherEnabled = false;
      config.concurrency.useVirtualThreads = true;
      config.http.maxRequestSize = MOST_REQUEST_BYTES;
      RoutesConfig routes = config.routes;
      routes.before(this::admit);
      routes.wsBeforeUpgrade(this::admit);
      routes.exception(
          BadInput.class,
          (error, context) ->
              context.status(400).result(error.getMessage()).contentType("text/plain"));
      routes.get("/", this::home);
      routes.get("/site.js", context -> file(context, "site.js", "text/javascript"));
      routes.get("/site.css", context -> file(context, "site.css", "text/css"));
      routes.get("/favicon.ico", context -> context.status(204)); // browsers ask for one
      routes.get("/run/{number}", this::page);
      routes.get("/run/{number}/parts", this::parts);
      routes.get("/api/overview", context -> json(context, site.overview()));
      routes.get("/api/schema", context -> json(context, site.schema()));
      routes.post("/api/runs", this::begin);
      routes.get(
          "/foxglove-layout.json",
          context -> context.result(FoxgloveLayout.json()).contentType("application/json"));
      routes.ws("/run/{number}/foxglove", this::foxglove);
    }

    /** Refuses a request, or adds what all answers have. */
    private void admit(Context context) {
      String refusal = gate.refusal(context.header("Host"), context.header("Origin"));
      if (!refusal.isEmpty()) {
        throw new HttpResponseException(FORBIDDEN, refusal, Map.of());
      }
      context.header("X-Content-Type-Options", "nosniff");
      context.header("Referrer-Policy", "no-referrer");
      context.header("Cache-Control", "no-store");
      context.header("Content-Security-Policy", "frame-ancestors 'self'");
      if (gate.needsToken()) {
        requireToken(context);
      }
    }

    /** The token comes with the address that was printed, and then as a cookie. */
    private void requireToken(Context context) {
      String cookieName = "starl-" + port();
      String given = context.queryParam("token");
      if (gate.isToken(given)) {
        Cookie cookie = new Cookie(cookieName, access.token());
        cookie.setHttpOnly(true);
        cookie.setSameSite(SameSite.LAX);
        context.cookie(cookie);
      } else if (!gate.isToken(context.cookie(cookieName))) {
        throw new HttpResponseException(
            UNAUTHORIZED,
            "expected the token: open the address that 'starl serve' printed",
            Map.of());
      }
    }

    private void home(Context context) throws IOException {
      switch (site.home()) {
        case RUN -> context.redirect("/run/1");
        case CAMPAIGN -> file(context, "campaign.html", "text/html");
        case PLAYGROUND -> file(context, "playground.html", "text/html");
      }
    }

    private Site.Shown run(Context context) {
      String number = context.pathParam("number");
      Site.Shown shown = number.matches("\\d{1,9}") ? site.run(Integer.parseInt(number)) : null;
      if (shown == null) {
        throw new HttpResponseException(404, "no run " + number, Map.of());
      }
      return shown;
    }

    private void page(Context context) {
      context.html(LivePage.html(run(context).title(), context.path() + "/parts"));
    }

    /**
     * Each part as soon as it is there. A browser that comes again names the last one that it has; if
     * that is not of this server, it gets all.
     */
    private void parts(Context context) throws IOException, InterruptedException {
      LivePage page = run(context).page();
      String last = context.header("Last-Event-ID");
      boolean isOwn = last != null && last.matches(name + "-\\d{1,9}");
      int next = isOwn ? Integer.parseInt(last.substring(name.length() + 1)) + 1 : 0;
      if (!streams.tryAcquire()) {
        throw new HttpResponseException(503, MOST_STREAMS + " connections are open", Map.of());
      }
      try {
        context.res().setContentType("text/event-stream;charset=utf-8");
        OutputStream out = context.res().getOutputStream();
        send(page, next, out);
      } finally {
        streams.release();
      }
    }

    private void send(LivePage page, int first, OutputStream out)
        throws IOException, InterruptedException {
      int next = first;
      int looks = 0;
      while (closing.getCount() > 0) {
        LivePage.Part part = page.part(next);
        if (part != null) {
          String kind = part.isFirst() ? "begin" : "more";
          String id = name + "-" + part.number();
          write(out, "id: " + id + "\nevent: " + kind + "\ndata: " + part.json());
          next = part.number() + 1;
        } else if (page.isWhole()) {
          write(out, "event: end\ndata:");
          return;
        } else {
          if (looks++ % LOOKS_PER_COMMENT == 0) {
            write(out, ":");
          }
          closing.await(LOOK_MS, TimeUnit.MILLISECONDS);
        }
      }
    }

    private static void write(OutputStream out, String event) throws IOException {
      out.write((event + "\n\n").getBytes(StandardCharsets.UTF_8));
      out.flush();
    }

    private void foxglove(WsConfig socket) {
      SortedMap<String, FoxgloveFeed> feeds = new ConcurrentSkipListMap<>();
      socket.onConnect(client -> {
        String number = client.pathParam("number");
        Site.Shown shown = number.matches("[0-9]{1,9}") ? site.run(Integer.parseInt(number)) : null;
        String wanted = String.valueOf(client.header("Sec-WebSocket-Protocol"));
        if (FoxgloveFeed.PROTOCOLS.stream().noneMatch(wanted.split(",", -1)[0].strip()::equals)) {
          client.closeSession(PROTOCOL_ERROR, "expected one of " + FoxgloveFeed.PROTOCOLS);
        } else if (shown == null || !streams.tryAcquire()) {
          client.closeSession(TRY_LATER, shown == null ? "no such run" : "too many connections");
        } else {
          FoxgloveFeed feed = new FoxgloveFeed(client.session, shown);
          feeds.put(client.sessionId(), feed);
          Thread.ofVirtual().start(() -> feed(client.session, feed));
        }
      });
      socket.onMessage(message -> {
        FoxgloveFeed feed = feeds.get(message.sessionId());
        String problem = feed == null ? null : feed.received(message.message());
        if (problem != null) {
          message.closeSession(PROTOCOL_ERROR, problem);
        }
      });
      socket.onClose(client -> feeds.remove(client.sessionId()));
    }

    private void feed(Session session, FoxgloveFeed feed) {
      try {
        while (session.isOpen() && !closing.await(LOOK_MS, TimeUnit.MILLISECONDS)) {
          feed.advance(LOOK_MS * Time.NS_PER_MS);
        }
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
      } finally {
        streams.release();
        session.close();
      }
    }

    private void begin(Context context) throws IOException {
      Map<String, Object> request;
      try {
        request = mapper.readValue(context.body(), new TypeReference<Map<String, Object>>() {});
      } catch (JsonProcessingException e) {
        throw FailureText.syntax("the request", context.body(), e, "JSON", "expected an object");
      }
      json(context, Map.of("number", site.start(request)));
    }

    private void json(Context context, Map<String, ?> value) throws IOException {
      context.result(mapper.writeValueAsString(value)).contentType("application/json");
    }

    private static void file(Context context, String name, String type) {
      if (type.equals("text/html")) {
        context.header(
            "Content-Security-Policy",
            "default-src 'none'; script-src 'self'; style-src 'self'; connect-src 'self';"
                + " frame-src 'self'; frame-ancestors 'self'");
      }
      context.contentType(type + ";charset=utf-8").result(TextFile.resource(WebServer.class, name));
    }
  }
}
