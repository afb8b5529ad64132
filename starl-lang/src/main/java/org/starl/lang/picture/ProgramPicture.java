package org.starl.lang.picture;

import java.util.ArrayList;
import java.util.List;
import org.starl.lang.tree.Program;
import org.starl.lang.tree.Program.Branch;
import org.starl.lang.tree.Program.Location;
import org.starl.lang.tree.Program.Statement;

/** A program as a picture: its locations as boxes, its branches as arrows. */
public final class ProgramPicture {

  private static final int WIDEST = 44;

  private ProgramPicture() {}

  /** The text of an SVG file. */
  public static String of(Program program) {
    List<String> names = program.locations().stream().map(Location::name).toList();
    List<Arrow> arrows = new ArrayList<>();
    for (int from = 0; from < names.size(); from++) {
      for (Branch branch : program.locations().get(from).branches()) {
        int to = branch.isRestart() ? 0 : names.indexOf(branch.to());
        arrows.add(new Arrow(arrows.size(), from, to, wrapped(branch.text()), effect(branch)));
      }
    }
    return new Column(names, arrows).svg(program.name());
  }

  private static List<String> effect(Branch branch) {
    List<String> lines = new ArrayList<>();
    for (Statement each : branch.statements()) {
      lines.addAll(
          wrapped(
              switch (each) {
                case Statement.Assign assign -> assign.text();
                case Statement.Call call -> call.text();
              }));
    }
    if (branch.isRestart()) {
      lines.add("restart");
    }
    return List.copyOf(lines);
  }

  /** Lines of at most so many characters, if the words allow it. */
  private static List<String> wrapped(String text) {
    List<String> lines = new ArrayList<>();
    StringBuilder line = new StringBuilder();
    for (String word : text.split(" ", -1)) {
      if (!line.isEmpty() && line.length() + 1 + word.length() > WIDEST) {
        lines.add(line.toString());
        line = new StringBuilder(" ");
      }
      line.append(line.isEmpty() ? "" : " ").append(word);
    }
    if (!line.toString().isBlank()) {
      lines.add(line.toString());
    }
    return List.copyOf(lines);
  }
}
