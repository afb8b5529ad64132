package org.starl.sim.view.page;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.starl.input.TextFile;
import org.starl.sim.Failure;
import org.starl.sim.record.MessageText;
import org.starl.sim.replay.Recording;
import org.starl.time.Time;
import org.starl.trace.TraceCodec;
import org.starl.trace.TraceEvent;
import org.starl.trace.TraceEvent.Action;
import org.starl.trace.TraceEvent.Delivered;
import org.starl.trace.TraceEvent.Dropped;
import org.starl.trace.TraceEvent.Fault;
import org.starl.trace.TraceEvent.Sent;
import org.starl.trace.TraceEvent.Variable;

/**
 * Writes two finished runs as one HTML page, side by side: it plays both by one clock, and opens
 * where they first differ.
 */
public final class ComparePage {

  private final Run first;
  private final Run second;
  private final @Nullable Difference difference;

  /**
   * One of the runs.
   *
   * @param command the command line that shows it
   * @param recording of the finished run
   */
  public record Run(String command, Recording recording) {

    /** Its app, its seed, and how it ended, in one line. */
    public String summary() {
      Failure failure = recording.wentWrong();
      String end =
          failure == null
              ? "nothing went wrong until " + Time.text(recording.endNs(), 1)
              : failure.headline();
      return RunPage.title(recording) + ": " + end;
    }
  }

  /**
   * The first event that is not the same in both runs.
   *
   * @param index its number, from 0
   * @param atNs the earlier time of the two events
   * @param first null if the first run has no more events
   * @param second the same of the second run
   */
  public record Difference(
      int index, long atNs, @Nullable TraceEvent first, @Nullable TraceEvent second) {

    private static final int MOST = 300;

    /** The first difference of two finished runs; null if there is none. */
    public static @Nullable Difference of(Recording first, Recording second) {
      int most = Math.max(first.size(), second.size());
      for (int i = 0; i < most; i++) {
        TraceEvent one = event(first, i);
        TraceEvent other = event(second, i);
        if (!line(one).equals(line(other))) {
          return new Difference(i, Math.min(timeNs(one), timeNs(other)), one, other);
        }
      }
      return null;
    }

    /** An event for people: in at most 300 characters. */
    public static String shown(@Nullable TraceEvent event) {
      String text =
          switch (event) {
            case null -> "no more events";
            case Sent e ->
                "%s sends to %s, %s: %s"
                    .formatted(
                        e.robot(),
                        e.to().equals(Sent.ALL) ? "all" : e.to(),
                        e.channel(),
                        MessageText.of(e.shape(), e.message(), Set.of()));
            case Delivered e ->
                "%s receives from %s, %s: %s"
                    .formatted(
                        e.robot(),
                        e.from(),
                        e.channel(),
                        MessageText.of(e.shape(), e.message(), Set.of()));
            case Dropped e ->
                "%s does not receive a datagram of %s: %s".formatted(e.robot(), e.from(), e.why());
            case Action e -> "%s, %s: %s %s".formatted(e.robot(), e.source(), e.name(), e.args());
            case Variable e ->
                "%s, %s: %s = %s".formatted(e.robot(), e.source(), e.name(), e.value());
            case Fault e -> "%s: %s %s".formatted(e.robot(), e.name(), e.detail());
            default -> line(event);
          };
      return text.length() <= MOST ? text : text.substring(0, MOST) + "...";
    }

    /** As in a trace; empty if there is none. */
    public static String line(@Nullable TraceEvent event) {
      return event == null ? "" : TraceCodec.line(event);
    }

    private static @Nullable TraceEvent event(Recording run, int index) {
      return index < run.size() ? run.event(index) : null;
    }

    private static long timeNs(@Nullable TraceEvent event) {
      return event == null ? Long.MAX_VALUE : event.timeNs();
    }
  }

  public ComparePage(Run first, Run second, @Nullable Difference difference) {
    this.first = first;
    this.second = second;
    this.difference = difference;
  }

  /** Writes the page in UTF-8. */
  public void write(OutputStream out) throws IOException {
    long endNs = Math.max(first.recording.endNs(), second.recording.endNs());
    Difference known = difference;
    String differs =
        known == null
            ? "The runs do not differ"
            : "The runs first differ at " + Time.text(known.atNs, 3);
    String page =
        TextFile.resource(RunPage.class, "compare.html")
            .replace("{{script}}", TextFile.resource(RunPage.class, "compare.js"))
            .replace("{{title}}", RunPage.escaped(RunPage.title(first.recording)))
            .replace("{{differs}}", differs)
            .replace("{{atMs}}", "" + RunPage.millis(known == null ? 0 : known.atNs))
            .replace("{{toMs}}", "" + RunPage.millis(endNs))
            .replace("{{first}}", part(first, known == null ? null : known.first))
            .replace("{{second}}", part(second, known == null ? null : known.second));
    out.write(page.getBytes(StandardCharsets.UTF_8));
  }

  private String part(Run run, @Nullable TraceEvent event) throws IOException {
    Difference known = difference;
    String player =
        known == null
            ? new RunPage(run.recording).html("", 0)
            : new RunPage(run.recording).html("first difference", known.atNs);
    String told = known == null ? "" : Difference.shown(event);
    return "<h2>%s</h2><code>%s</code><p>%s</p><iframe title=\"%s\" srcdoc=\"%s\"></iframe>"
        .formatted(
            RunPage.escaped(run.summary()),
            RunPage.escaped(run.command),
            RunPage.escaped(told),
            RunPage.escaped(run.summary()),
            RunPage.escaped(player));
  }
}
