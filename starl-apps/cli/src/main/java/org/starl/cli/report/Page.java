package org.starl.cli.report;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Base64;
import org.starl.Version;
import org.starl.sim.check.RunOutcome.Verdict;

/** The frame of the page, with its parts in order. */
final class Page {

  private final Report report;
  private final Html html = new Html();

  Page(Report report) {
    this.report = report;
  }

  String write() {
    String style = resource("report.css");
    String script = resource("report.js");
    html.open("html", "lang", "en");
    head(style);
    html.open("body");
    new HeadPart(html, report).write();
    html.open("main");
    if (!report.bad().isEmpty()) {
      new BadRunsPart(html, report).write();
    }
    samples();
    new MessagesPart(html, report).write();
    new LemmasPart(html, report).write();
    new FiguresPart(html, report).write();
    new RunsPart(html, report).write();
    html.close();
    footer();
    html.code("script", script);
    html.close().close();
    return html.page();
  }

  /** The policy lets the browser use only the page's own style, script and images. */
  private void head(String style) {
    html.open("head").empty("meta", "charset", "utf-8");
    html.empty(
        "meta",
        "http-equiv",
        "Content-Security-Policy",
        "content",
        "default-src 'none'; img-src data:; style-src '"
            + hash(style)
            + "'; script-src '"
            + hash(resource("report.js"))
            + "'");
    html.empty("meta", "name", "viewport", "content", "width=device-width, initial-scale=1");
    html.empty("meta", "name", "color-scheme", "content", "light dark");
    html.element("title", report.description().app() + ": " + HeadPart.verdict(report));
    html.code("style", style).close();
  }

  private void samples() {
    for (Report.Sampled sampled : report.samples()) {
      if (sampled.isEmpty()) {
        continue;
      }
      html.open("section").element("h2", NumberFormats.capitalized(sampled.name()));
      switch (sampled.kind()) {
        case SIZES ->
            new SizeCharts(html, sampled.name(), sampled.unit(), Distribution.ofAll(sampled.runs()))
                .write();
        case TIMES -> new TimeChart(html, sampled.name(), sampled.runs()).write();
      }
      html.close();
    }
  }

  private void footer() {
    html.open("footer").open("p");
    html.text(
        "Made by StarL "
            + Version.STARL
            + ". All times are simulated. Equal seeds give equal runs: the same command makes this"
            + " page again.");
    html.close().close();
  }

  static String of(Verdict verdict) {
    return switch (verdict) {
      case GOOD -> "good";
      case UNFINISHED -> "unfinished";
      case VIOLATED -> "violated";
      case FAILED -> "failed";
    };
  }

  private static String hash(String code) {
    try {
      byte[] digest =
          MessageDigest.getInstance("SHA-256").digest(code.getBytes(StandardCharsets.UTF_8));
      return "sha256-" + Base64.getEncoder().encodeToString(digest);
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException(e);
    }
  }

  private static String resource(String name) {
    try (InputStream in = Page.class.getResourceAsStream(name)) {
      if (in == null) {
        throw new IllegalStateException("missing resource " + name);
      }
      return new String(in.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
