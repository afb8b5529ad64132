plugins {
    `java-library`
    antlr
    id("maven-publish")
}

description = "Reads automata in StarL's language, and makes Java and PVS of them; explores and proves them"

configurations.api {
    // The plugin hands on its tool; the parser needs its runtime alone.
    setExtendsFrom(extendsFrom.filterNot { it.name == "antlr" })
}

dependencies {
    antlr(libs.antlr.tool)
    api(libs.jspecify)
    // The server's methods take and return its types.
    api(libs.lsp4j)
    implementation(project(":starl-core-input"))
    implementation(libs.antlr.runtime)
    implementation(libs.z3)
    testImplementation(project(":starl-core"))
    testImplementation(libs.junit.jupiter)
    testImplementation(libs.assertj.core)
    testImplementation(libs.jqwik)
    testRuntimeOnly(libs.junit.platform.launcher)
}

java {
    sourceSets.named("main") {
        // Where Maven's plugin looks.
        extensions.getByType(org.gradle.api.plugins.antlr.AntlrSourceDirectorySet::class.java)
            .setSrcDirs(listOf("src/main/antlr4"))
    }
}

tasks.generateGrammarSource {
    arguments = listOf("-no-listener", "-package", "org.starl.lang.grammar")
}

tasks.named("sourcesJar") {
    // The parser is a source too.
    dependsOn(tasks.generateGrammarSource)
}

tasks.processResources {
    // StarL's own automata, which programs use.
    from("../pvs/starl") {
        into("org/starl/lang/library")
    }
}
