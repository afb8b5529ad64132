package org.starl.cli.report;

import static org.starl.cli.report.NumberFormats.count;

import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import org.starl.cli.report.Coverage.Action;
import org.starl.cli.report.Coverage.Values;

/** The sections of the page about what the runs reached: theories and deliveries. */
record CoverageTables(Html html, Coverage coverage) {

  void write() {
    if (!coverage.theories().isEmpty()) {
      html.section("Coverage of the theories");
      note(
          "Each action of the automata, and how often each conjunct of its guard was true or false"
              + " when it was evaluated: for each action taken, and for a sample of actions at other"
              + " times. A conjunct is evaluated if those before it are true. A part that was never"
              + " reached was not checked by these runs.");
      html.open("div", "class", "charts");
      coverage.theories().forEach(this::theory);
      html.close().close();
    }
    List<Deliveries.Table> deliveries = coverage.deliveries();
    if (!deliveries.isEmpty()) {
      html.section("Deliveries by phase and location");
      note(
          "How many messages of each type were delivered while the receiving robot's primitive was in"
              + " a phase, and its app at a location.");
      deliveries.forEach(this::channel);
      html.close();
    }
  }

  private void note(String text) {
    html.element("p", text, "class", "note");
  }

  private void theory(String theory, SortedMap<String, Action> actions) {
    table(theory, List.of("action", "conjunct"), List.of("taken", "true", "false"));
    actions.forEach((name, action) -> {
      String rows = Integer.toString(Math.max(1, action.guard().size()));
      html.open("tr");
      html.open("th", "scope", "rowgroup", "rowspan", rows).element("code", name).close();
      if (action.guard().isEmpty()) {
        html.element("td", action.taken() == 0 ? "" : "always enabled");
        cell(action.taken(), rows);
        html.element("td", "").element("td", "").close();
      }
      boolean isFirst = true;
      for (Map.Entry<String, Values> conjunct : action.guard().entrySet()) {
        if (!isFirst) {
          html.open("tr");
        }
        html.open("td").element("code", conjunct.getKey()).close();
        if (isFirst) {
          cell(action.taken(), rows);
        }
        cell(conjunct.getValue().held(), "1");
        cell(conjunct.getValue().failed(), "1");
        html.close();
        isFirst = false;
      }
    });
    html.endTable();
  }

  private void table(String caption, List<String> names, List<String> numbers) {
    html.wide().open("table", "class", "reached");
    html.element("caption", caption).open("thead").open("tr");
    names.forEach(name -> html.element("th", name, "scope", "col"));
    numbers.forEach(name -> html.element("th", name, "scope", "col", "class", "n"));
    html.close().close().open("tbody");
  }

  private void channel(Deliveries.Table table) {
    List<String> names = table.hasLocations() ? List.of("phase", "location") : List.of("phase");
    table(table.channel(), names, table.types());
    for (String phase : table.phases()) {
      List<Deliveries.Place> places = table.places(phase);
      if (places.isEmpty()) {
        places = List.of(new Deliveries.Place(phase, "", new TreeMap<>()));
      }
      places.forEach(place -> place(table, place));
    }
    html.endTable();
  }

  private void place(Deliveries.Table table, Deliveries.Place place) {
    html.row(place.phase());
    if (table.hasLocations()) {
      html.open("td").element("code", place.location()).close();
    }
    table.types().forEach(type -> cell(place.count(type), "1"));
    html.close();
  }

  private void cell(long times, String rows) {
    String cssClass = times == 0 ? "n never" : "n";
    html.element("td", times == 0 ? "never" : count(times), "class", cssClass, "rowspan", rows);
  }
}
