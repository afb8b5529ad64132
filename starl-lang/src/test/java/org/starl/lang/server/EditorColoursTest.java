package org.starl.lang.server;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.antlr.v4.runtime.Vocabulary;
import org.junit.jupiter.api.Test;
import org.starl.lang.grammar.StarlLexer;

/** What Visual Studio Code colours as a word of the language. */
class EditorColoursTest {

  @Test
  void everyWordOfTheGrammarHasAColour() throws IOException {
    String colours = Files.readString(Path.of("vscode/syntaxes/starl.tmLanguage.json"));
    TreeSet<String> coloured = new TreeSet<>();
    Matcher alternatives = Pattern.compile("\\\\\\\\b\\(([a-z|]+)\\)").matcher(colours);
    while (alternatives.find()) {
      coloured.addAll(List.of(alternatives.group(1).split("\\|")));
    }
    assertThat(coloured).containsAll(words());
  }

  private static List<String> words() {
    List<String> words = new ArrayList<>();
    Vocabulary vocabulary = StarlLexer.VOCABULARY;
    for (int type = 1; type <= vocabulary.getMaxTokenType(); type++) {
      String literal = vocabulary.getLiteralName(type);
      if (literal != null && literal.matches("'[a-z]+'")) {
        words.add(literal.substring(1, literal.length() - 1));
      }
    }
    assertThat(words).contains("automaton", "disjoint");
    return words;
  }
}
