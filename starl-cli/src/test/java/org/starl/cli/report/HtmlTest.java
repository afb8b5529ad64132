package org.starl.cli.report;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Tag;
import org.w3c.dom.Document;
import org.w3c.dom.Element;

class HtmlTest {

  /** The test removes characters that XML forbids; another test covers them. */
  @Property
  @Tag("long")
  void anyTextIsParsedUnchanged(@ForAll String text) throws Exception {
    String allowed = text.replaceAll("[^\\t\\n -~\\u00A0-\\uD7FF\\uE000-\\uFDCF]", "");
    Document page =
        Parsed.page(new Html().open("p", "title", allowed).text(allowed).close().page());
    Element p = page.getDocumentElement();
    assertThat(p.getTextContent()).isEqualTo(allowed);
    assertThat(p.getAttribute("title")).isEqualTo(allowed.replaceAll("[\\t\\n]", " "));
  }

  @Property
  void anyTextAtAllParses(@ForAll String text) throws Exception {
    Parsed.page(new Html().open("p", "title", text).text(text).close().page());
  }

  @Example
  void charactersThatXmlForbidsAreReplaced() {
    String text = "a\u0000b\u001Fc\rd\uD800e\uFFFEf\u0085g\uD83E\uDD16h";
    assertThat(new Html().element("p", text).page())
        .contains("a\uFFFDb\uFFFDc\uFFFDd\uFFFDe\uFFFDf\uFFFDg\uD83E\uDD16h");
  }

  @Example
  void anOpenElementIsAnError() {
    assertThatThrownBy(() -> new Html().open("p").page()).hasMessageContaining("[p]");
  }

  @Example
  void ambiguousCodeIsRefused() {
    assertThatThrownBy(() -> new Html().code("script", "a < b")).hasMessageContaining("script");
  }
}
