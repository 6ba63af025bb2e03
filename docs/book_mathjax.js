// How MathJax behaves in the book: formulas appear, and nothing else
MathJax.Hub.Config({ messageStyle: "none", showMathMenu: false });
